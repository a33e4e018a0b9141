// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/fit/fit_fields.h"
#include "ui/record/fit_outcome.h"

#include <QSet>
#include <QWidget>

#include <vector>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QSpinBox;

namespace axiscomp::ui {

class NumberEdit;

/// What is said of the table that is made of a measurement. A field that means nothing for the
/// measurement is hidden.
class FitForm : public QWidget {
    Q_OBJECT

public:
    explicit FitForm(QWidget* parent = nullptr);

    /// state: with no measurement while there is none.
    void show(const FitChoices& choices, const RecordState& state, const FitDrive& drive);
    /// What is not taken yet goes; show() follows.
    void forgetTyped();
    /// used: keys that other widgets have; gets those of the fields that are shown.
    void retranslate(QSet<QChar>& used);
    /// Why a field's text is not taken, a translated sentence; empty: all are.
    [[nodiscard]] QString problem() const;

Q_SIGNALS:
    /// name: of what is changed, translated.
    void chosen(const axiscomp::ui::FitChoices& choices, const QString& name);
    /// The file of a table is wanted. isOnto: to merge onto it; otherwise it was active.
    void fileWanted(bool isOnto);
    void problemChanged();
    /// Others are shown: there are not enough keys for all of them.
    void rowsChanged();

private:
    void build();
    void buildDrive();
    void buildCurve();
    void buildGrid();
    void buildZero();
    void buildPoints();
    QLabel* addHeading();
    void addRow(QWidget* field, const char* name);
    [[nodiscard]] QComboBox* addList(const char* name, int items);
    [[nodiscard]] NumberEdit* addNumbers(
        const char* name, std::size_t most, std::optional<double> smallest, bool isMore = false);
    void report(QWidget* field);
    void reportFile(QComboBox* list, int file, bool isOnto);
    [[nodiscard]] FitChoices read() const;
    void readGrid(FitSettings& settings) const;
    void showCurve();
    void showGrid();
    void showZero();
    void showDrive();
    void showPoints();
    void showRows();
    void sayWhereLookedUp();
    void sayWhatWasActive();
    void retranslateDrive();
    void retranslateCurve();
    void retranslateGrid();
    void retranslateZero();
    void retranslatePoints();
    void offerMethods();
    void offerBodies();
    static void offer(QComboBox* list, int item, bool isOffered);
    void nameRow(QWidget* field, const QString& name, const QString& description);
    void setItems(QComboBox* list, const QStringList& items);
    void setRow(QWidget* field, bool isShown);

    FitChoices m_shown;
    bool m_haveRowsChanged = false;
    bool m_isReporting = false; ///< what is shown next was said here
    MeasurementKind m_kind = MeasurementKind::Runs;
    std::vector<std::string> m_axes; ///< of points
    std::string m_unit = "mm";
    FitFields m_fields;
    bool m_isStateAsked = true;
    MeasuredState m_onFile;
    bool m_hasRaw = false;
    bool m_wasSaidOfOther = false; ///< table of the axis: what was active
    bool m_wasOntoOther = false; ///< table of the axis
    std::optional<LookupAt> m_lookupOfDrive;
    std::string m_source;

    /// How the grid is to be said, whose number has not been given yet.
    std::optional<int> m_openGrid;

    QFormLayout* m_form;
    std::vector<NumberEdit*> m_numbers;
    QSet<QChar>* m_keys = nullptr; ///< while it is retranslated

    QLabel* m_driveHeading = nullptr;
    QComboBox* m_lookup = nullptr;
    QLabel* m_lookupNote = nullptr;
    QComboBox* m_measuredWith = nullptr;
    QLabel* m_stateNote = nullptr;
    QComboBox* m_onto = nullptr;
    QLabel* m_ontoNote = nullptr;
    NumberEdit* m_gain = nullptr;

    QLabel* m_curveHeading = nullptr;
    QComboBox* m_method = nullptr;
    QComboBox* m_direction = nullptr;
    NumberEdit* m_smoothness = nullptr;
    NumberEdit* m_periods = nullptr;
    QSpinBox* m_harmonics = nullptr;
    NumberEdit* m_turn = nullptr;

    QLabel* m_gridHeading = nullptr;
    QComboBox* m_grid = nullptr;
    NumberEdit* m_points = nullptr;
    NumberEdit* m_distance = nullptr;
    NumberEdit* m_within = nullptr;
    QCheckBox* m_hold = nullptr;

    QLabel* m_zeroHeading = nullptr;
    QComboBox* m_zero = nullptr;
    NumberEdit* m_zeroPosition = nullptr;
    NumberEdit* m_home = nullptr;
    QComboBox* m_slope = nullptr;
    QComboBox* m_drift = nullptr;

    QLabel* m_pointsHeading = nullptr;
    QComboBox* m_body = nullptr;
    QComboBox* m_far = nullptr;
    QCheckBox* m_robust = nullptr;
};

} // namespace axiscomp::ui
