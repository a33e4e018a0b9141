// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/async/background_job.h"
#include "ui/record/fit_outcome.h"
#include "ui/record/record_state.h"

#include <QObject>
#include <QUndoStack>

#include <cstdint>
#include <functional>
#include <optional>

namespace axiscomp::ui {

/// The record that is being worked on: what was said of it, with every step to be undone and done
/// again, and what it comes to, which follows on another thread.
class RecordModel : public QObject {
    Q_OBJECT

public:
    static constexpr int mostSteps = 200;

    explicit RecordModel(QObject* parent = nullptr);
    struct HistoryOf {
        RecordModel& record;
    };
    /// Its steps stand among those of the other one, which undoes and does again both. The other
    /// one must outlive this.
    explicit RecordModel(HistoryOf other, QObject* parent = nullptr);
    ~RecordModel() override;

    /// Another record: there is nothing to be undone. Not for one that shares the history of
    /// another, which must be opened first.
    void open(const Record& record);

    [[nodiscard]] const Record& record() const { return m_record; }
    /// Of record(), or of an earlier one while isEvaluating().
    [[nodiscard]] const RecordState& state() const { return m_state; }
    /// Whether the measurement of state() has the values that record() names, used or not.
    [[nodiscard]] bool isMeasurementShown() const;
    [[nodiscard]] bool isEvaluating() const { return m_isEvaluating; }
    /// Whether state().fit is that of an earlier record, or there is none yet.
    [[nodiscard]] bool isFitting() const { return m_isFitting; }
    /// For which the table is made; no step, since nobody says it.
    void setDrive(const FitDrive& drive);
    [[nodiscard]] const FitDrive& drive() const { return m_drive; }

    // Each is one step. Nothing happens where nothing changes.

    /// Those that are not among the files yet, at their end. What was left out counts runs and
    /// targets of all files, so that it is used again whenever the files are other ones;
    /// corrections are lost then too, and which table was active is said of them anew.
    void addFiles(const QStringList& paths);
    void removeFile(std::size_t index);
    void setChoices(std::size_t index, const MeasurementChoices& choices);
    /// What was left out stays left out.
    void setDirectionsSwapped(bool isSwapped);
    void exclude(const std::vector<Exclusion>& exclusions);
    /// The values that these name; of a run or target that was left out, the others stay left out.
    void useAgain(const std::vector<Exclusion>& values);
    /// Whether useAgain() has something to do for one of them: not for what a file leaves out.
    [[nodiscard]] bool isLeftOut(const std::vector<Exclusion>& values) const;
    void setOutlierRule(OutlierRule rule);
    /// Made before judging, and lost with the files that they are of.
    void setCorrections(const CorrectionsBefore& corrections);
    /// In mm or deg; none: no limit.
    void setTolerance(Iso230Figure figure, std::optional<double> value);
    void setUncertainty(std::optional<double> value);
    /// Those of the record, without lengths that are none of the measurement's axis, and without
    /// what was said of another table than the axis has by now.
    [[nodiscard]] FitChoices fitChoices() const;
    /// name: of what is changed, translated; for the history.
    void setFit(const FitChoices& choices, const QString& name);
    void setCalibration(std::shared_ptr<const CalibrationRecord> calibration);
    /// The table that was active, where the files do not say it; none: nothing is said.
    void setStatedTable(std::optional<std::uint32_t> crc);
    /// The one in use, and those that undoing and doing again would bring back; each once.
    [[nodiscard]] std::vector<std::shared_ptr<const CalibrationRecord>> calibrations() const;
    /// Something has happened to a table that is in use, or was before steps were undone: no step,
    /// and nothing that could be undone. noted: gives what is to stand in place of a calibration.
    using Noting = std::function<std::shared_ptr<const CalibrationRecord>(
        const std::shared_ptr<const CalibrationRecord>&)>;
    void note(const Noting& noted);
    /// Reads files again that have changed on disk. What was said of them is lost then as in
    /// addFiles(), by a step, but not where they have only grown. Where it stands in earlier or
    /// undone steps only, there is nothing to be undone and done again after that. A step that
    /// brings a file back does the same.
    void readAgain();

    /// What undo() and redo() would do, a translated phrase; empty: there is nothing.
    [[nodiscard]] QString undoText() const;
    [[nodiscard]] QString redoText() const;
    void undo();
    void redo();

Q_SIGNALS:
    void opened(); ///< before changed(): what is typed and not taken was for the record before
    void changed(); ///< record()
    void stateChanged(); ///< state() but for its fit, isEvaluating()
    void filesChanged(const QString& names); ///< on disk, and what was said of them is lost
    void fitChanged(); ///< state().fit, isFitting(), drive()
    void historyChanged(); ///< undoText(), redoText()

private:
    enum class StepKind {
        AddFiles,
        FileChanged,
        RemoveFile,
        ReadOtherwise,
        SwapDirections,
        Exclude,
        UseAgain,
        OutlierRule,
        Corrections,
        Tolerance,
        Uncertainty,
        Fit,
        Calibration,
        StateTable,
    };
    class Step;

    void change(Record next, StepKind kind, const QString& subject = {});
    void apply(const Record& record);
    void evaluate();
    void take(const RecordState& state);
    [[nodiscard]] const Measurement*
    shownMeasurement() const; ///< null: isMeasurementShown() is not
    [[nodiscard]] Record withLimitsOfTheMeasurement() const;
    [[nodiscard]] FitChoices choicesOfDrive() const;
    void fit();
    void keepWhatStepsBringBack(std::vector<ReadMeasurement> before);
    void forgetWhatHasChanged();
    [[nodiscard]] bool isInSteps(const std::function<bool(const Record&)>& is) const;
    void takeFit(std::shared_ptr<const FitOutcome> outcome);
    [[nodiscard]] QString textOf(int step) const;

    Record m_record;
    RecordState m_state;
    /// What files were that steps bring back: they may be other ones then.
    std::vector<ReadMeasurement> m_seen;
    QUndoStack m_ownSteps;
    QUndoStack& m_steps;
    NewestJob<RecordState> m_job;
    bool m_isEvaluating = false;
    FitDrive m_drive;
    NewestJob<std::shared_ptr<const FitOutcome>> m_fitJob;
    bool m_isFitting = false;
};

} // namespace axiscomp::ui
