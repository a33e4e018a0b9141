// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/moving_proof.h"
#include "core/compensator/axis_compensator.h"
#include "core/compensator/axis_operations.h"
#include "core/configuration/compensation_parameters.h"
#include "core/conversion/import_choices.h"
#include "ui/controller/action_rules.h"
#include "ui/controller/setup_model.h"
#include "ui/controller/wizard_options.h"
#include "ui/data/column_mapping.h"
#include "ui/data/data_file_state.h"
#include "ui/outcome/wizard_log.h"
#include "ui/session/axis_entry.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <memory>
#include <optional>
#include <vector>

namespace axiscomp::ui {

class AxisOverview;
class DriveConnection;
class MachineController;
class SetupHistory;

/// Everything of the wizard but its widgets: which drives and axes there are, the setup of the
/// chosen axis, the open file, what runs, and each action with its reason. Never blocks: drives are
/// talked to on their sessions' threads, files are parsed on a thread of their own. Owns no widget.
class WizardController : public QObject {
    Q_OBJECT

public:
    explicit WizardController(WizardOptions options, QObject* parent = nullptr);
    ~WizardController() override;

    // Drives and axes
    void setEndpoints(const QStringList& endpoints);
    [[nodiscard]] QStringList endpoints() const; ///< as given, passwords included
    [[nodiscard]] const std::vector<DriveState>& drives() const;
    [[nodiscard]] const std::vector<AxisEntry>& axes() const;
    [[nodiscard]] int currentAxis() const; ///< index into axes(), -1 none
    /// The first axis that can be used of a drive that answers: index into axes(), -1 none.
    [[nodiscard]] int usableAxisOf(const QString& endpoint) const;
    /// Whether the current axis is of the drive that this entry was of; it may be lost.
    [[nodiscard]] bool isCurrentDrive(const AxisEntry& entry) const;
    /// Of the current axis; null: there is none. Goes away with the drive.
    [[nodiscard]] DriveConnection* connection() const;
    /// The drive of the current axis answers.
    [[nodiscard]] bool isConnected() const;
    /// Drops unwritten changes; the page asks first when setup().isDirty().
    void selectAxis(int index);
    /// The same for an entry that was taken earlier, wherever it is among axes() now. False: it is
    /// not the current axis; it has gone, or something runs.
    bool selectAxis(const AxisEntry& entry);
    void refresh();
    /// Asks one drive again, at once.
    void tryDrive(const QString& endpoint);
    /// All axes of all drives.
    [[nodiscard]] AxisOverview& overview();
    /// The machine file, and how all drives differ from it.
    [[nodiscard]] MachineController& machine();

    // The setup of the current axis
    [[nodiscard]] SetupModel& setup();
    [[nodiscard]] const SetupModel& setup() const;
    /// Of setup() and dataFile(); cleared with another axis and by a write.
    [[nodiscard]] SetupHistory& history();
    [[nodiscard]] const std::optional<AxisStatus>& status() const; ///< as last read
    [[nodiscard]] const std::vector<DimSource>& sourceShortlist() const;
    /// Path, tam:// URI or hex address, checked against the drive; then setup() has it, or
    /// sourceProblem() says why not and the field keeps its old value.
    void chooseSource(int dimension, const QString& text);
    [[nodiscard]] QString sourceProblem(int dimension) const;
    [[nodiscard]] bool isSourceBeingChecked(int dimension) const;
    /// The entered text is another one by now: what was wrong with it is over.
    void forgetSourceProblem(int dimension);
    /// What the selected table of the file proposes for a source that is not set, or that it speaks
    /// against (core/axis/proposals.h); for the user to accept by chooseSource(). Unset: nothing.
    [[nodiscard]] DimSource proposedSource(int dimension) const;
    /// What the selected table of the file says against the source that is chosen, a translated
    /// sentence; empty: nothing.
    [[nodiscard]] QString sourceDoubt(int dimension) const;
    /// Of the register that is chosen, as last read; none: not read yet.
    [[nodiscard]] std::optional<double> sourceValue(int dimension) const;

    // Compensation data
    /// The table that is called as the axis is chosen, or the file's first, unless another one of
    /// the same file is.
    void openData(const QString& path);
    /// The same with what the user has said about the file.
    void importData(const QString& path, const ImportChoices& choices);
    /// A file that is a grid of another dimensionality than the setup's: the setup gets that.
    void openDataAs(const QString& path, int dimensions);
    /// What the user has said about the file so far.
    [[nodiscard]] ImportChoices importChoices(const QString& path) const;
    /// Tables that were made here, in place of a file; the first of them is selected. False:
    /// action(Action::OpenData) says why not.
    [[nodiscard]] bool useTables(const MadeTables& made);
    /// The open file, which may have changed; what was chosen stays chosen.
    void readDataAgain();
    void closeData();
    void cancelReading();
    [[nodiscard]] const DataFile& dataFile() const;
    /// The chosen table: of the file, or the one on the drive (once it has been downloaded); may be
    /// null.
    [[nodiscard]] std::shared_ptr<const CompensationTable> selectedTable() const;
    /// What the axis is to the sources that are chosen.
    [[nodiscard]] AxisPlace chosenPlace() const;
    /// The same, where the chosen table was made for another side of the compensation for that one.
    [[nodiscard]] AxisPlace selectedPlace() const;
    /// Of the file that it is of; the drive keeps none.
    [[nodiscard]] std::vector<std::string> selectedNotes() const;
    /// Its largest value is not what a reference said there, as in WriteRequest.
    [[nodiscard]] bool isSelectedComputed() const;
    [[nodiscard]] std::shared_ptr<const CompensationTable> driveTable() const;
    [[nodiscard]] std::size_t
    selectedTableBytes() const; ///< as a file on the drive; 0 without a table
    /// "where the encoder reads 40.000 the reference says 40.0021, the drive will add +0.0021"
    [[nodiscard]] QString signSentence() const;

    // Actions
    [[nodiscard]] ActionState action(Action action) const;
    /// The line under the buttons: the one sentence that matters most now.
    [[nodiscard]] QString hint() const;
    /// Asks the drive what a write would change; planReady follows, or a failure. doubts: as
    /// WriteRequest has them.
    void planWrite(std::vector<Text> doubts = {});
    /// Carries out the plan that planReady gave. acceptsLarge: what is unusually large in it was
    /// confirmed; without it such a plan is refused.
    void write(bool acceptsLarge = false);
    /// Says why the plan that planReady gave is not there any more.
    void refuseOldPlan();
    void activate(); ///< ends with the end-to-end proof
    void evaluate();
    void deactivate();
    /// Asks what deleting the axis's table would change; planReady() follows, as for planWrite.
    void planDeletion();
    /// The same for what the axis had before the last write.
    void planRestoration();
    /// The same for a backup of the current axis; write() brings it back.
    void planRestoration(const BackupChoice& choice);
    /// The backup that plan() brings back; none: it is another plan.
    [[nodiscard]] std::optional<Restoration> plannedRestoration() const;
    /// What an earlier write that did not end has left on the axis, a translated sentence; empty
    /// when there is none.
    [[nodiscard]] QString unfinishedWrite() const;
    void finishWrite();
    void undoWrite();

    // Several axes of the current drive, each with a column of the open file
    [[nodiscard]] std::vector<AxisEntry> usableAxes() const;
    /// Those of setup(), as many as the file has dimensions; empty when one is not set.
    [[nodiscard]] std::vector<DimSource> sourcesForSeveral() const;
    /// Asks the drive what all of these would change; multiAxisPlanned() follows unless another
    /// question does. False: action(Action::WriteSeveral) says why not.
    [[nodiscard]] bool planMultiAxis(
        const std::vector<ColumnForAxis>& columns, SourcesForSeveral sources);
    /// The register of the position of an axis of the current drive; unset: none is known.
    [[nodiscard]] DimSource ownPosition(int axis) const;
    /// The last question is of no interest any more.
    void dropSeveral();
    /// One plan per column, in their order; none while the drive is being asked.
    [[nodiscard]] const std::optional<Result<std::vector<WritePlan>>>& multiAxisPlans() const;
    /// The same question for the parameters of a station. acceptsOther: it may have another serial
    /// number than the drive. False: action(Action::ImportConfiguration) says why not.
    [[nodiscard]] bool planImport(const std::shared_ptr<const TamConfiguration>& configuration,
        std::size_t station, bool acceptsOther);
    /// The same question for a backup of a whole drive. acceptsOther: of one with another serial
    /// number. False: action(Action::RestoreDrive) says why not.
    [[nodiscard]] bool planRestoreDrive(
        const std::shared_ptr<const DriveBackup>& backup, bool acceptsOther);
    /// Carries out multiAxisPlans(), axis by axis; multiAxisWritten() follows, outcome() says what
    /// each axis holds. acceptsLarge: as in write().
    void writeMultiAxis(bool acceptsLarge = false);

    // The parameters of the current drive for a TAM configuration
    /// Reads them; parametersRead() follows. False: action(Action::ExportConfiguration) says why
    /// not.
    [[nodiscard]] bool readParameters();
    /// The last question is of no interest any more.
    void dropParameters();
    /// None while the drive is being read.
    [[nodiscard]] const std::optional<Result<CompensationParameters>>& parameters() const;
    /// outcome() says what has become of the file.
    void reportExport(const QString& fileName, const Result<void>& saved);

    /// Tables and sources of all axes of the current drive, to a file; outcome() says what has
    /// become of it.
    void backUpDrive(const QString& path);

    void cancel();
    [[nodiscard]] const BusyState& busy() const;
    [[nodiscard]] bool
    isWriting() const; ///< the drive would be left to a roll-back when it is stopped now

    [[nodiscard]] const std::optional<WritePlan>& plan() const;
    [[nodiscard]] const std::optional<Proof>& proof() const; ///< of the last activation
    /// What has been seen of the table since it became active; none while it is not.
    [[nodiscard]] const std::optional<MovingProof>& movingProof() const;
    [[nodiscard]] QString
    outcome() const; ///< of the last operation, a translated sentence; may be empty
    [[nodiscard]] bool isOutcomeAnError() const;
    [[nodiscard]] bool isOutcomeAWarning() const;
    [[nodiscard]] WizardLog& logModel();
    [[nodiscard]] const std::vector<LogLine>& log() const; ///< the newest 1000
    /// Seconds until flash may be written again, 0 now; counts down.
    [[nodiscard]] int flashWaitSeconds() const;
    [[nodiscard]] int flashOperationsLeft() const;
    /// Of the current axis's drive, as last read.
    [[nodiscard]] const std::optional<FlashUse>& flashUse() const;

    /// Reads the live values once.
    void refreshLive();

    /// Makes every text anew, in the language that the program has now, and announces those that
    /// are shown; the page calls it when the language has changed. outcomeChanged() is not among
    /// the signals: an outcome that the user has put away stays away.
    void retranslate();

Q_SIGNALS:
    void drivesChanged();
    void axesChanged();
    void currentAxisChanged();
    void statusChanged(); ///< baseline, state, drive table: read again
    void liveChanged(); ///< output, indices, source values of status()
    void sourceChecked(int dimension);
    void dataFileChanged();
    void importChoiceNeeded(const QString& path); ///< the file cannot be used without
    void selectedTableChanged();
    void actionsChanged(); ///< action(), hint()
    void busyChanged(); ///< busy(), isWriting()
    void planReady();
    void multiAxisPlanned();
    void multiAxisWritten();
    /// An axis of the current drive has the new state of a write, whichever operation that was.
    /// now: as read back and verified.
    void tableWritten(const axiscomp::AxisStatus& now);
    void tableActivated(); ///< of the current axis; status() is the new one, proof() may be there
    void parametersRead();
    void outcomeChanged();

private:
    void updatePlace();
    void updateUnits();
    void watchSources();
    /// Of the current axis's drive.
    [[nodiscard]] std::vector<AxisInfo> axesOfDrive() const;
    /// By which the selected table of the file is looked up; none of the file: nameless ones.
    [[nodiscard]] Grid columnsOfPositions() const;
    void wireDrives();
    void wireAxis();
    void wireTables();
    void wireOperations();

    struct Parts;
    std::unique_ptr<Parts> m_parts;
};

} // namespace axiscomp::ui
