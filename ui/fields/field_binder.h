// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/controller/setup_model.h"

#include <QObject>
#include <QVariant>

#include <functional>
#include <vector>

class QCheckBox;
class QComboBox;

namespace axiscomp::ui {

class FieldRow;
class SourceCombo;

/// Ties the page's editors to the setup model: what the user does reaches the model at once, what
/// the model says reaches the editor with its signals blocked, and every row shows whether its
/// field is changed and what the drive has.
class FieldBinder : public QObject {
    Q_OBJECT

public:
    explicit FieldBinder(SetupModel& model, QObject* parent = nullptr);

    /// The words for the drive's value of a field.
    using DriveText = std::function<QString(const CompensationSetup&)>;

    /// The value is the combo box's item data.
    void bind(Field field, FieldRow& row, QComboBox& combo,
        std::function<QVariant(const EditedSetup&)> read,
        std::function<void(SetupModel&, const QVariant&)> write, DriveText driveText);
    void bind(Field field, FieldRow& row, QCheckBox& checkBox,
        std::function<bool(const EditedSetup&)> read, std::function<void(SetupModel&, bool)> write,
        DriveText driveText);
    /// What the user enters is not a value yet: it leaves by sourceEntered, and the model gets the
    /// register when the drive has said that there is one.
    void bind(FieldRow& row, SourceCombo& combo, int dimension,
        std::function<QString(const DimSource&)> uri,
        std::function<QString(const DimSource&)> name);

    /// Shows the model's value again: after the list or the texts of an editor have changed.
    void refresh();
    void refresh(Field field);

Q_SIGNALS:
    void sourceEntered(int dimension, const QString& text);
    void sourceEdited(int dimension); ///< what was entered before is no longer there

private:
    struct Binding {
        Field field;
        FieldRow* row;
        std::function<void()> show;
        DriveText driveText;
    };
    void add(Binding binding);
    static void show(const SetupModel& model, const Binding& binding);

    SetupModel& m_model;
    std::vector<Binding> m_bindings;
};

} // namespace axiscomp::ui
