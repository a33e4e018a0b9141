// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/output/environment.h"
#include "app/common/exit_codes.h"
#include "core/compensator/axis_operations.h"
#include "drivecomm/link/certificate_check.h"

#include <CLI/App.hpp>
#include <QCoreApplication>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace axiscomp::app {

/// The options of every command that talks to a drive.
struct DriveOptions {
    std::string command; ///< "axiscomp write": for hints
    std::vector<std::string> endpoints;
    std::string axis; ///< index or name; empty: the only one
    std::string profile; ///< path; empty: the built-in one
    std::string trustedFingerprint; ///< as given; empty: none
    double timeoutSeconds = 5.0;
};

/// What is remembered of certificates by this program and the window, and what the options add.
[[nodiscard]] drivecomm::CertificateCheck certificateCheck(const DriveOptions& options);

enum class DriveCount { One, Several };
void addDriveOptions(CLI::App& command, DriveOptions& options, DriveCount count = DriveCount::One);
/// --drive alone.
void addDriveOption(CLI::App& command, DriveOptions& options, DriveCount count);
/// The same without --drive, for commands whose file names the drives.
void addConnectionOptions(CLI::App& command, DriveOptions& options);
/// --timeout alone.
void addTimeoutOption(CLI::App& command, DriveOptions& options, const std::string& description);
CLI::Option* addAxisOption(CLI::App& command, DriveOptions& options);

/// What Qt needs to exist while drives are talked to. Made by drive commands only: it costs more
/// time than the start of the program. Where a program has it already, that one is used.
class QtRuntime {
public:
    QtRuntime();

private:
    int m_count = 1;
    std::string m_name = "axiscomp";
    std::vector<char*> m_arguments;
    std::optional<QCoreApplication> m_application;
};

/// A folder of its own that is removed with everything in it.
class TemporaryFolder {
public:
    /// Errors: FileNotWritable.
    [[nodiscard]] static Result<TemporaryFolder> make();
    TemporaryFolder(TemporaryFolder&& other) noexcept;
    TemporaryFolder& operator=(TemporaryFolder&& other) noexcept;
    ~TemporaryFolder();

    [[nodiscard]] const std::filesystem::path& path() const { return m_path; }

private:
    explicit TemporaryFolder(std::filesystem::path path);

    std::filesystem::path m_path; ///< empty: moved from
};

/// A connection to one drive with what works on it; used on the thread that made it. A QtRuntime
/// must exist.
class CommandSession {
public:
    /// Errors: InvalidEndpoint, InvalidProfile, ...; nothing is sent yet.
    [[nodiscard]] static Result<std::unique_ptr<CommandSession>> open(
        Environment& environment, const DriveOptions& options, const std::string& endpoint);
    /// Of the one drive that the options name. Errors: InvalidArgument when they name none.
    [[nodiscard]] static Result<std::unique_ptr<CommandSession>> open(
        Environment& environment, const DriveOptions& options);

    [[nodiscard]] AxisCompensator& compensator() { return *m_compensator; }
    [[nodiscard]] DriveLink& link() { return *m_link; }
    [[nodiscard]] const DriveProfile& profile() const { return m_profile; }
    /// For a command that a person types next: " --drive http://host". Where AXISCOMP_DRIVE has
    /// the password it is empty; a password that was given as --drive is left to the person.
    [[nodiscard]] const std::string& driveOption() const { return m_driveOption; }
    /// The drive is inside this process and ends with it.
    [[nodiscard]] bool isDemo() const { return m_demoState.has_value(); }
    /// Deadline, stop and progress of an operation.
    [[nodiscard]] OperationOptions operation() const;
    /// The same without progress, for several drives at the same time: they would write over each
    /// other's line.
    [[nodiscard]] OperationOptions quietOperation() const;
    [[nodiscard]] Exchange exchange() const;

    /// The axis that the options name. Errors: InvalidArgument when none is named and there are
    /// several; AxisNotFound, AxisAmbiguous.
    [[nodiscard]] Result<int> axis();
    [[nodiscard]] const std::filesystem::path& storeRoot() const { return m_storeRoot; }
    [[nodiscard]] DriveStore& store() { return m_store; }

private:
    CommandSession(Environment& environment, DriveOptions options, DriveProfile profile,
        std::optional<TemporaryFolder> demoState);

    Environment& m_environment;
    DriveOptions m_options;
    DriveProfile m_profile;
    std::optional<TemporaryFolder> m_demoState;
    std::filesystem::path m_storeRoot;
    DriveStore m_store;
    std::string m_driveOption;
    std::unique_ptr<DriveLink> m_link;
    std::unique_ptr<AxisCompensator> m_compensator;
};

/// "small1" and "tables/small1.TAMtbl" are the slot Small1; the rest is judged by the compensator.
[[nodiscard]] std::string slotName(const DriveProfile& profile, const std::string& text);

/// The state of an axis; says on standard error what became of an earlier write that did not end,
/// or that another program is writing.
[[nodiscard]] Result<SettledStatus> settledStatus(
    Environment& environment, CommandSession& session, int axis);
/// The same for what changes nothing, or only switches off: what is not known of an earlier write
/// is a warning.
[[nodiscard]] Result<SettledStatus> shownStatus(
    Environment& environment, CommandSession& session, int axis);
/// problem: WatchedStatus::journalProblem.
void warnOfJournal(Environment& environment, const Error& problem);

/// Reads the options of a command, opens a session and runs the function with it and the axis.
using AxisFunction = std::function<Result<ExitCode>(Environment&, CommandSession&, int axis)>;
[[nodiscard]] Result<ExitCode> withAxis(
    Environment& environment, const DriveOptions& options, const AxisFunction& function);
using DriveFunction = std::function<Result<ExitCode>(Environment&, CommandSession&)>;
[[nodiscard]] Result<ExitCode> withDrive(
    Environment& environment, const DriveOptions& options, const DriveFunction& function);

} // namespace axiscomp::app
