// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/conversion/import_choices.h"

#include <QSet>
#include <QWidget>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;

namespace axiscomp::ui {

class SettingFields;

/// The fields with which the user says what a file of tables is, or shall be: its format with its
/// settings, the axis that it corrects, the sign of its values, directions of motion, points
/// without a value, and the even grid.
class ConversionForm : public QWidget {
    Q_OBJECT

public:
    enum class Purpose { Import, Export };
    explicit ConversionForm(Purpose purpose, QWidget* parent = nullptr);

    /// What can be chosen as format, and the one that is.
    void setFormats(const std::vector<const TableFormat*>& formats, const TableFormat* current);
    [[nodiscard]] const TableFormat* format() const; ///< null: none is chosen
    void setChoices(const ImportChoices& choices);
    [[nodiscard]] ImportChoices choices() const;
    /// Why choices() are not complete, a translated sentence; empty when they are.
    [[nodiscard]] QString problem() const;
    /// Which questions the tables of the file raise.
    void setQuestions(bool hasDirections, bool hasWrap);
    /// usedKeys: letters of the buttons around the form.
    void retranslate(const QSet<QChar>& usedKeys);

Q_SIGNALS:
    void changed();

private:
    void build();
    void connectFields();
    void chooseFormat();
    void showGridRows();
    void nameRows();
    void describeFields();
    void fillItems();
    void nameNumber();
    void nameSettings();
    [[nodiscard]] ResamplingChoice resampling() const;
    [[nodiscard]] std::optional<std::vector<double>> numbers() const;
    /// 0 without a text; nothing for a text that is no tolerance.
    [[nodiscard]] std::optional<double> snap() const;

    Purpose m_purpose;
    QFormLayout* m_form;
    QComboBox* m_format;
    QComboBox* m_target;
    QComboBox* m_sign;
    QComboBox* m_direction;
    QCheckBox* m_dropsWrap;
    QComboBox* m_missing;
    QLineEdit* m_snap;
    QComboBox* m_grid;
    QLineEdit* m_number;
    QComboBox* m_method;
    QCheckBox* m_holds;
    SettingFields* m_settings;
    QSet<QChar> m_usedKeys;
};

} // namespace axiscomp::ui
