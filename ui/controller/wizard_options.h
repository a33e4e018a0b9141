// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compensator/axis_compensator.h"
#include "core/csv/calibration_csv.h"
#include "core/formats/table_format.h"
#include "ui/session/drive_session.h"
#include "ui/session/rejected_certificate.h"
#include "ui/text/wording.h"

#include <QString>

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

/// The plain values that the wizard's page shows.
namespace axiscomp::ui {

/// The page's actions. Each says why it cannot be done now.
enum class Action {
    Write,
    Activate,
    Evaluate,
    Deactivate,
    Revert,
    RestorePrevious,
    FinishWrite, ///< one that did not end
    UndoWrite,
    Refresh,
    OpenData,
    WriteSeveral, ///< columns of the file, each to an axis of its own
    Cancel,
};
inline constexpr std::array allActions{Action::Write, Action::Activate, Action::Evaluate,
    Action::Deactivate, Action::Revert, Action::RestorePrevious, Action::FinishWrite,
    Action::UndoWrite, Action::Refresh, Action::OpenData, Action::WriteSeveral, Action::Cancel};

struct ActionState {
    bool isEnabled = false;
    QString reason; ///< a translated sentence: why not, or what will happen
    friend bool operator==(const ActionState&, const ActionState&) = default;
};

/// One entry of the Axis field.
struct AxisEntry {
    QString endpoint; ///< of its drive, without a password
    QString driveName;
    std::int32_t serialNumber = 0;
    AxisInfo axis;
    bool isDemo = false;
    bool isUsable = false; ///< false: no compensation registers, or the drive does not answer
    QString label; ///< unique among the entries, "X · Triamec-616 (demo)"
    QString place; ///< what stands in the label between name and remark: " · Triamec-616"
    QString problem; ///< a translated sentence: why it is not usable; empty when it is
};

struct DriveState {
    enum class Connection { Connecting, Connected, Lost };
    QString endpoint; ///< without a password
    QString name; ///< empty until identified
    Connection connection = Connection::Connecting;
    QString problem; ///< translated, when Lost
    std::optional<RejectedCertificate> certificate; ///< when Lost because of it
    bool isDemo = false;
    friend bool operator==(const DriveState&, const DriveState&) = default;
};

/// A table of the open file, by its index, and the axis of the current drive that it is for.
struct ColumnForAxis {
    int column = 0;
    int axis = 0;
    friend bool operator==(const ColumnForAxis&, const ColumnForAxis&) = default;
};

/// The open file of compensation data.
struct DataFile {
    QString path; ///< of data; of the file that was tried when there is none; empty: none is open
    std::shared_ptr<const CalibrationData> data; ///< only of a file without errors
    const TableFamily* family = nullptr; ///< as which data was read
    std::vector<std::string> report; ///< of the conversion of data: English, for phraseText
    std::vector<Diagnostic> problems;
    std::size_t suppressedProblems = 0;
    QString problemsPath; ///< the file that has the problems: after a bad one, not that of data
    bool isReading = false;
    QString readingPath; ///< the file that is being read
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
    int number = 0; ///< of all lines that there have been, from 1
    WallTime time;
    enum class Kind { Information, Warning, Error } kind = Kind::Information;
    Wording text;
    QString detail; ///< for experts, in English
};

/// The serial ports of this computer that none of the addresses names; at several baud rates when
/// asked for. Called on any thread.
using PortCandidates = std::function<std::vector<DriveCandidate>(
    const std::vector<std::string>& otherThan, bool anyBaudRate)>;

struct WizardOptions {
    LinkFactory linkFactory;
    PortCandidates portCandidates; ///< empty: drives are not looked for
    const DriveProfile* profile = nullptr; ///< must outlive the controller
    std::filesystem::path storeRoot;
    std::chrono::milliseconds timeout{5000};
    std::chrono::milliseconds liveInterval{100}; ///< 0: live values only on refreshLive()
    std::chrono::milliseconds reconnectInterval{2000};
};

} // namespace axiscomp::ui
