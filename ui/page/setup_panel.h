// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/controller/setup_model.h"

#include <QWidget>

#include <array>

class QCheckBox;
class QComboBox;
class QStyle;

namespace axiscomp {
struct DriveProfile;
}

namespace axiscomp::ui {

class DataFileField;
class FieldBinder;
class FieldRow;
class SourceCombo;
class WizardController;

/// The fields of AN140 2.4: axis, dimensionality, sources, compensation data, table, persistency.
class SetupPanel : public QWidget {
    Q_OBJECT

public:
    /// style draws the frame of changed editors. All references must outlive the panel.
    SetupPanel(WizardController& controller, const DriveProfile& profile, QStyle& style,
        QWidget* parent = nullptr);

    [[nodiscard]] DataFileField& dataField();
    /// A field shows a text that the setup does not have: it is not finished, or was refused.
    [[nodiscard]] bool isBeingTyped() const;
    /// Puts the drive's value back into the field that has the focus.
    void revertFocused();
    void retranslate();

Q_SIGNALS:
    /// The user chose an entry of the Axis field; the field still shows the current axis.
    void axisChosen(int index);

private:
    static constexpr int tableOnDrive = -1; ///< item data of the Table field

    void build();
    void bind();
    void connectController();
    void setTexts();
    void showAxes();
    void showAxisState();
    void showSources();
    void showSource(int dimension);
    void showSourceAdvice();
    void showSourceValues();
    void takeProposal(int dimension);
    void showDimensions();
    void showTables();
    void showTableState();
    void showData();
    void showPersistency();
    void showAvailability();
    [[nodiscard]] QString sourceUriText(const DimSource& source) const;
    [[nodiscard]] QString sourceName(const DimSource& source) const;
    [[nodiscard]] QString driveTableText(const CompensationSetup& baseline) const;

    WizardController& m_controller;
    const DriveProfile& m_profile;
    QComboBox* m_axis;
    QComboBox* m_dimensionality;
    std::array<SourceCombo*, 3> m_sources{};
    DataFileField* m_data;
    QComboBox* m_table;
    QCheckBox* m_persistency;
    FieldRow* m_axisRow;
    FieldRow* m_dimensionalityRow;
    std::array<FieldRow*, 3> m_sourceRows{};
    FieldRow* m_dataRow;
    FieldRow* m_tableRow;
    FieldRow* m_persistencyRow;
    FieldBinder* m_binder;
};

} // namespace axiscomp::ui
