// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis_compensator.h"
#include "core/calibration_csv.h"
#include "ui/drive_session.h"
#include "ui/setup_model.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace axiscomp::ui {

/// The page's actions. Each says why it cannot be done now.
enum class Action {
    Write,
    Activate,
    Evaluate,
    Deactivate,
    Revert,
    RestorePrevious,
    Refresh,
    OpenData,
    Cancel,
};
inline constexpr std::array allActions{Action::Write, Action::Activate, Action::Evaluate,
    Action::Deactivate, Action::Revert, Action::RestorePrevious, Action::Refresh, Action::OpenData,
    Action::Cancel};

struct ActionState {
    bool isEnabled = false;
    QString reason; ///< a translated sentence: why not, or what will happen
    friend bool operator==(const ActionState&, const ActionState&) = default;
};

/// One entry of the Axis field.
struct AxisEntry {
    QString endpoint;
    QString driveName;
    std::int32_t serialNumber = 0;
    AxisInfo axis;
    bool isDemo = false;
    bool isUsable = false; ///< false: no compensation registers, or the drive does not answer
    QString label; ///< unique among the entries, "X · Triamec-616 (demo)"
};

struct DriveState {
    enum class Connection { Connecting, Connected, Lost };
    QString endpoint;
    QString name; ///< empty until identified
    Connection connection = Connection::Connecting;
    QString problem; ///< translated, when Lost
    bool isDemo = false;
};

/// The open file of compensation data.
struct DataFile {
    QString path; ///< empty: none is open
    std::shared_ptr<const CalibrationData> data; ///< only of a file without errors
    std::vector<Diagnostic> problems;
    std::size_t suppressedProblems = 0;
    bool isReading = false;
    double progress = 0.0;
    bool hasChangedOnDisk = false;
};

/// What a busy page shows.
struct BusyState {
    bool isBusy = false;
    QString step; ///< translated: "writing: verifying table"
    double fraction = 0.0;
    bool canCancel = false;
};

struct LogLine {
    WallTime time;
    enum class Kind { Information, Warning, Error } kind = Kind::Information;
    QString text;
    QString detail;
};

struct WizardOptions {
    LinkFactory linkFactory;
    const DriveProfile* profile = nullptr; ///< must outlive the controller
    std::filesystem::path storeRoot;
    std::chrono::milliseconds timeout{5000};
    std::chrono::milliseconds liveInterval{100}; ///< 0: live values only on refreshLive()
    std::chrono::milliseconds reconnectInterval{2000};
};

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
    /// Drops unwritten changes; the page asks first when setup().isChanged().
    void selectAxis(int index);
    void refresh();

    // The setup of the current axis
    [[nodiscard]] SetupModel& setup();
    [[nodiscard]] const SetupModel& setup() const;
    [[nodiscard]] const std::optional<AxisStatus>& status() const; ///< as last read
    [[nodiscard]] const std::vector<DimSource>& sourceShortlist() const;
    /// Path, tam:// URI or hex address, checked against the drive; then setup() has it, or
    /// sourceProblem() says why not and the field keeps its old value.
    void chooseSource(int dimension, const QString& text);
    [[nodiscard]] QString sourceProblem(int dimension) const;
    [[nodiscard]] bool isSourceBeingChecked(int dimension) const;

    // Compensation data
    void openData(const QString& path);
    void closeData();
    void cancelReading();
    [[nodiscard]] const DataFile& dataFile() const;
    /// The chosen table: of the file, or the one on the drive (once it has been downloaded); may be
    /// null.
    [[nodiscard]] std::shared_ptr<const CompensationTable> selectedTable() const;
    [[nodiscard]] std::shared_ptr<const CompensationTable> driveTable() const;
    [[nodiscard]] std::size_t
    selectedTableBytes() const; ///< as a file on the drive; 0 without a table
    /// "where the encoder reads 40.000 the reference says 40.0021, the drive will add +0.0021"
    [[nodiscard]] QString signSentence() const;

    // Actions
    [[nodiscard]] ActionState action(Action action) const;
    /// The line under the buttons: the one sentence that matters most now.
    [[nodiscard]] QString hint() const;
    /// Asks the drive what a write would change; planReady follows, or a failure.
    void planWrite();
    /// Carries out the plan that planReady gave.
    void write();
    void activate(); ///< ends with the end-to-end proof
    void evaluate();
    void deactivate();
    void restorePrevious();
    void cancel();
    [[nodiscard]] const BusyState& busy() const;
    [[nodiscard]] bool
    isWriting() const; ///< the drive would be left to a roll-back when it is stopped now

    [[nodiscard]] const std::optional<WritePlan>& plan() const;
    [[nodiscard]] const std::optional<Proof>& proof() const; ///< of the last activation
    [[nodiscard]] QString
    outcome() const; ///< of the last operation, a translated sentence; may be empty
    [[nodiscard]] bool isOutcomeAnError() const;
    [[nodiscard]] const std::vector<LogLine>& log() const; ///< the newest 1000
    /// Seconds until flash may be written again, 0 now; counts down.
    [[nodiscard]] int flashWaitSeconds() const;
    [[nodiscard]] int flashOperationsLeft() const;

    /// Reads the live values once.
    void refreshLive();

Q_SIGNALS:
    void drivesChanged();
    void axesChanged();
    void currentAxisChanged();
    void statusChanged(); ///< baseline, state, drive table: read again
    void liveChanged(); ///< output, indices, source values of status()
    void sourceChecked(int dimension);
    void dataFileChanged();
    void selectedTableChanged();
    void actionsChanged(); ///< action(), hint()
    void busyChanged();
    void planReady();
    void outcomeChanged();
    void logged();

private:
    struct Private;
    std::unique_ptr<Private> d;
};

/// The translated sentence of an error (context "Error" in the translations).
[[nodiscard]] QString errorText(const Error& error);
/// The translated sentence of a file's problem.
[[nodiscard]] QString problemText(const Diagnostic& diagnostic);

} // namespace axiscomp::ui
