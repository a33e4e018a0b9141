// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/capture_request.h"
#include "ui/async/background_job.h"
#include "ui/dialogs/file_picker.h"

#include <QDialog>

#include <memory>
#include <optional>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace axiscomp::ui {

class BusyMark;
class CaptureFeed;
class NumberBox;
class SourceCombo;
class ToneLabel;
class WizardController;

/// What was chosen for a capture, for the next one.
struct CaptureChoices {
    QString planPath; ///< empty: of the plan that was just made, which is in no file
    std::shared_ptr<const MeasuringPlan> plan; ///< null: to be read from planPath
    CaptureReference reference;
    SerialInstrumentRequest serial;
    QString valuesPath;
    CaptureRules rules;
};

/// By which plan, with which instrument and into which file values are taken. Begins the capture,
/// and closes when it has begun.
class CaptureDialog : public QDialog {
    Q_OBJECT

public:
    /// controller has an axis; it and the feed must outlive this. hasSerial: instruments on serial
    /// ports can be opened. folder: where files are proposed to be.
    CaptureDialog(WizardController& controller, CaptureFeed& feed, const CaptureChoices& choices,
        FilePicker picker, QString folder, bool hasSerial, QWidget* parent = nullptr);
    ~CaptureDialog() override;

Q_SIGNALS:
    void begun(const axiscomp::ui::CaptureChoices& choices);

public:
    void reject() override;

protected:
    void changeEvent(QEvent* event) override;

private:
    using Kind = CaptureReference::Kind;
    using ReadPlan = Result<std::shared_ptr<const MeasuringPlan>>;

    void build(bool hasSerial);
    void addRow(QWidget* field, const char* name, QWidget* row = nullptr);
    [[nodiscard]] QWidget* withButton(QLineEdit* field, QPushButton* button);
    void show(const CaptureChoices& choices);
    void follow();
    void retranslate();
    void nameFields();
    void nameRow(QWidget* field, const QString& name, const QString& description);
    void offerSources();
    void readPlan(const QString& path);
    void askForPlan();
    void askForValues();
    void showKind();
    void showState();
    [[nodiscard]] Kind kind() const;
    [[nodiscard]] CaptureChoices choices() const;
    [[nodiscard]] QString obstacle() const;
    [[nodiscard]] QString typedProblem() const;
    [[nodiscard]] QString planText() const;
    void begin();

    WizardController& m_controller;
    CaptureFeed& m_feed;
    const FilePicker m_picker;
    QString m_folder;
    QString m_planPath;
    std::optional<ReadPlan> m_plan; ///< none: not chosen, or being read
    bool m_isReadingPlan = false;
    NewestJob<ReadPlan> m_planJob;
    bool m_isBeginning = false;
    std::optional<Error> m_refusal; ///< of the last attempt

    QFormLayout* m_form;
    QLabel* m_axis;
    QLineEdit* m_planField;
    QPushButton* m_choosePlan;
    QComboBox* m_kind;
    SourceCombo* m_register;
    QLineEdit* m_port;
    QLineEdit* m_request;
    QLineEdit* m_pattern;
    QComboBox* m_unit;
    NumberBox* m_zero;
    QCheckBox* m_invert;
    NumberBox* m_window;
    NumberBox* m_dwell;
    QSpinBox* m_average;
    QLineEdit* m_values;
    QPushButton* m_chooseValues;
    ToneLabel* m_reason;
    BusyMark* m_busy;
    QPushButton* m_begin;
    QPushButton* m_cancel;
};

} // namespace axiscomp::ui
