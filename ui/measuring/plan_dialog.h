// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/axis_plan.h"
#include "core/metrology/gcode.h"
#include "ui/async/background_job.h"
#include "ui/dialogs/file_picker.h"

#include <QDialog>

#include <array>
#include <memory>
#include <optional>

class QComboBox;
class QFormLayout;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QStackedWidget;
class QTableView;

namespace axiscomp::ui {

class NumberBox;
class PlanTargetsModel;
class ToneLabel;

/// Plans a measurement: the targets, shown as they come out, saved as a plan and as a program for
/// the machine's control.
class PlanDialog : public QDialog {
    Q_OBJECT

public:
    /// axis: what is proposed. folder: where files are proposed to be.
    PlanDialog(
        const MeasuredAxis& axis, FilePicker picker, QString folder, QWidget* parent = nullptr);
    ~PlanDialog() override;

Q_SIGNALS:
    /// The plan, or a program of it, is in this file.
    void saved(const QString& path, const std::shared_ptr<const axiscomp::MeasuringPlan>& plan,
        bool isProgram);

protected:
    void changeEvent(QEvent* event) override;

private:
    enum Field {
        AxisField,
        UnitField,
        FromField,
        ToField,
        TargetsField,
        PeriodField,
        CyclesField,
        OverrunField,
        FeedField,
        DwellField,
        SeedField,
        FieldCount
    };
    using Planned = Result<std::shared_ptr<const MeasuringPlan>>;

    void build();
    [[nodiscard]] QWidget* buildFields();
    [[nodiscard]] QWidget* buildTargets();
    [[nodiscard]] QWidget* buildPreview();
    void addField(Field field, QWidget* editor, const char* name);
    void propose(const MeasuredAxis& axis);
    void follow();
    void retranslate();
    void nameFields();
    void showUnits();
    void compute();
    [[nodiscard]] MeasuringPlanRequest request() const;
    void take(const Planned& plan);
    void showState();
    [[nodiscard]] QString summary() const;
    [[nodiscard]] QString nameOf(Field field) const;
    /// Whose number is not the one that was typed; null: there is none.
    [[nodiscard]] const NumberBox* refusedBox() const;
    void askAndSave(bool isProgram);
    void save(const QString& path, bool isProgram);

    const FilePicker m_picker;
    QString m_folder;
    std::optional<Travel> m_travel; ///< of the axis that was proposed, in the unit of its plan
    QString m_axisName; ///< of that axis
    bool m_isAxisAngular = false;
    std::optional<MeasuringPlanFault> m_fault;
    std::shared_ptr<const MeasuringPlan> m_plan; ///< null: impossible, or being made
    NewestJob<Planned> m_job;
    QString m_outcome; ///< of the last save
    bool m_hasFailed = false;

    QFormLayout* m_form;
    std::array<ToneLabel*, FieldCount> m_labels{};
    std::array<QWidget*, FieldCount> m_editors{};
    QLineEdit* m_axis;
    QComboBox* m_unit;
    NumberBox* m_from;
    NumberBox* m_to;
    ToneLabel* m_byLabel;
    QComboBox* m_by;
    QStackedWidget* m_targets;
    QSpinBox* m_count;
    NumberBox* m_spacing;
    NumberBox* m_period;
    QSpinBox* m_cycles;
    NumberBox* m_overrun;
    NumberBox* m_feed;
    NumberBox* m_dwell;
    QSpinBox* m_seed;
    PlanTargetsModel* m_model;
    QTableView* m_preview;
    ToneLabel* m_summary;
    ToneLabel* m_reason;
    ToneLabel* m_dialectLabel;
    QComboBox* m_dialect;
    QPushButton* m_savePlan;
    QPushButton* m_saveProgram;
    QPushButton* m_close;
};

} // namespace axiscomp::ui
