// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/session/command_session.h"

#include "app/cli/input/table_input.h"
#include "app/cli/output/status_text.h"
#include "app/common/arguments.h"
#include "app/common/number_checks.h"
#include "core/io/local_file.h"
#include "core/io/system.h"
#include "core/text/token_scanner.h"
#include "drivecomm/link_factory.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace axiscomp::app {

namespace {

constexpr const char* driveVariable = "AXISCOMP_DRIVE";
constexpr double longestTimeoutSeconds = 3600.0;
constexpr double shortestTimeoutSeconds = 0.001;

std::string listAxes(const std::vector<AxisInfo>& axes)
{
    std::string text;
    for (const AxisInfo& axis : axes)
        text += (text.empty() ? "" : ", ") + std::to_string(axis.index)
            + (axis.name.empty() ? "" : " (" + axis.name + ")");
    return text;
}

std::string optionFor(const drivecomm::DriveEndpoint& drive, const std::string& given)
{
    std::string shown = drivecomm::displayText(drive);
    if (!drive.user.empty() || !drive.password.empty()) {
        const char* const known = std::getenv(driveVariable);
        if (known && given == known)
            return {};
        shown.insert(shown.find("://") + 3, "user:password@");
    }
    return " --drive " + shown;
}

/// Of this program that did not end, or of another one that goes on.
void warnOfWrites(Environment& environment, const SettledStatus& now)
{
    if (now.isBeingWritten)
        environment.warn(
            beingWritten(now.status.axis) + "; what is shown may already have changed");
    if (now.settled)
        environment.warn(outcomeSentence(*now.settled));
}

} // namespace

void addDriveOption(CLI::App& command, DriveOptions& options, DriveCount count)
{
    CLI::Option* drive = command.add_option("--drive", options.endpoints,
        count == DriveCount::Several
            ? AXISCOMP_HELP("Help",
                "Address of the drive, may be given several times; $AXISCOMP_DRIVE unless given")
            : AXISCOMP_HELP("Help", "Address of the drive; $AXISCOMP_DRIVE unless given"));
    drive->option_text("ENDPOINT")->envname(driveVariable);
}

void addDriveOptions(CLI::App& command, DriveOptions& options, DriveCount count)
{
    addDriveOption(command, options, count);
    addConnectionOptions(command, options);
}

void addTimeoutOption(CLI::App& command, DriveOptions& options, const std::string& description)
{
    command.add_option("--timeout", options.timeoutSeconds, description)
        ->option_text("SECONDS")
        ->check(numberBetween(shortestTimeoutSeconds, longestTimeoutSeconds));
}

void addConnectionOptions(CLI::App& command, DriveOptions& options)
{
    addProfileOption(command, options.profile);
    command
        .add_option("--trust-certificate", options.trustedFingerprint,
            AXISCOMP_HELP("Help",
                "Trust the https certificate with this fingerprint from now on; any other one is "
                "refused"))
        ->option_text("SHA256")
        ->check(CLI::Validator(
            [](const std::string& text) {
                return sha256Fingerprint(text) ? std::string()
                                               : text + " is not 64 hexadecimal digits";
            },
            ""));
    addTimeoutOption(command, options,
        AXISCOMP_HELP("Help", "Time limit for one exchange with the drive (5 unless given)"));
}

drivecomm::CertificateCheck certificateCheck(const DriveOptions& options)
{
    return [certificates = std::make_shared<TrustedCertificates>(DriveStore::defaultRoot()),
               trusted = sha256Fingerprint(options.trustedFingerprint)](
               const std::string& endpoint, const std::string& fingerprint) {
        const CertificateTrust known = certificates->check(endpoint, fingerprint);
        if (known == CertificateTrust::Trusted || trusted != fingerprint)
            return known;
        // Where it cannot be kept, the next run asks again.
        static_cast<void>(certificates->trust(endpoint, fingerprint));
        return CertificateTrust::Trusted;
    };
}

CLI::Option* addAxisOption(CLI::App& command, DriveOptions& options)
{
    return command
        .add_option("--axis", options.axis,
            AXISCOMP_HELP(
                "Help", "Index or name of the axis; not needed if the drive has only one"))
        ->option_text("AXIS");
}

QtRuntime::QtRuntime() : m_arguments{m_name.data(), nullptr}
{
    if (!QCoreApplication::instance())
        m_application.emplace(m_count, m_arguments.data());
}

Result<TemporaryFolder> TemporaryFolder::make()
{
    std::error_code error;
    const std::filesystem::path parent = std::filesystem::temp_directory_path(error);
    auto folder = error ? tl::unexpected(error) : system::makeTemporaryFolder(parent);
    if (!folder)
        return fail(ErrorCode::FileNotWritable,
            {{"file", parent.string()}, {"reason", fileErrorReason(folder.error())}});
    return TemporaryFolder(*std::move(folder));
}

TemporaryFolder::TemporaryFolder(std::filesystem::path path) : m_path(std::move(path)) { }

TemporaryFolder::TemporaryFolder(TemporaryFolder&& other) noexcept
    : m_path(std::exchange(other.m_path, {}))
{
}

TemporaryFolder& TemporaryFolder::operator=(TemporaryFolder&& other) noexcept
{
    std::swap(m_path, other.m_path);
    return *this;
}

TemporaryFolder::~TemporaryFolder()
{
    std::error_code ignored;
    if (!m_path.empty())
        std::filesystem::remove_all(m_path, ignored);
}

CommandSession::CommandSession(Environment& environment, DriveOptions options, DriveProfile profile,
    std::optional<TemporaryFolder> demoState)
    : m_environment(environment)
    , m_options(std::move(options))
    , m_profile(std::move(profile))
    , m_demoState(std::move(demoState))
    , m_storeRoot(m_demoState ? m_demoState->path() : DriveStore::defaultRoot())
    , m_store(m_storeRoot)
{
}

Result<std::unique_ptr<CommandSession>> CommandSession::open(
    Environment& environment, const DriveOptions& options, const std::string& endpoint)
{
    AXISCOMP_TRY(const auto parsed, drivecomm::parseEndpoint(endpoint));
    AXISCOMP_TRY(auto profile, profileOf(options.profile));
    // What is remembered of a drive must not outlive it: the next demo is another drive.
    std::optional<TemporaryFolder> demoState;
    if (parsed.kind == drivecomm::DriveEndpoint::Kind::Demo) {
        AXISCOMP_TRY(auto folder, TemporaryFolder::make());
        demoState = std::move(folder);
    }
    std::unique_ptr<CommandSession> session(
        new CommandSession(environment, options, std::move(profile), std::move(demoState)));
    AXISCOMP_TRY(
        auto link, drivecomm::makeLink(parsed, session->m_profile, certificateCheck(options)));
    session->m_driveOption = optionFor(parsed, endpoint);
    session->m_link = std::move(link);
    session->m_compensator =
        std::make_unique<AxisCompensator>(*session->m_link, session->m_profile, session->m_store);
    return session;
}

Result<std::unique_ptr<CommandSession>> CommandSession::open(
    Environment& environment, const DriveOptions& options)
{
    if (options.endpoints.empty())
        return wrongUsage("the drive is missing: give --drive http://host, or set AXISCOMP_DRIVE",
            options.command);
    if (options.endpoints.size() > 1)
        return wrongUsage("only one --drive is possible here", options.command);
    return open(environment, options, options.endpoints.front());
}

OperationOptions CommandSession::operation() const
{
    OperationOptions operation;
    operation.timeout =
        std::chrono::milliseconds(static_cast<std::int64_t>(m_options.timeoutSeconds * 1000.0));
    operation.stop = m_environment.stopToken();
    operation.progress = [this](const Progress& progress) {
        m_environment.console().progress(stepWords(progress.step), progress.fraction);
    };
    return operation;
}

OperationOptions CommandSession::quietOperation() const
{
    OperationOptions quiet = operation();
    quiet.progress = {};
    return quiet;
}

Exchange CommandSession::exchange() const
{
    Exchange exchange;
    exchange.timeout = operation().timeout;
    exchange.stop = m_environment.stopToken();
    return exchange;
}

Result<int> CommandSession::axis()
{
    if (!m_options.axis.empty())
        return m_compensator->findAxis(m_options.axis, operation());
    AXISCOMP_TRY(const auto axes, m_compensator->axes(operation()));
    if (axes.size() == 1)
        return axes.front().index;
    return wrongUsage(
        "the drive has several axes: choose one with --axis: " + listAxes(axes), m_options.command);
}

std::string slotName(const DriveProfile& profile, const std::string& text)
{
    const auto slot = std::ranges::find_if(profile.tableSlots, [&](const TableSlot& candidate) {
        return sameLetters(candidate.name, text) || candidate.file == text;
    });
    return slot == profile.tableSlots.end() ? text : slot->name;
}

Result<SettledStatus> settledStatus(Environment& environment, CommandSession& session, int axis)
{
    auto now = axiscomp::settledStatus(
        session.compensator(), session.storeRoot(), axis, session.operation());
    if (now && now->settlingProblem)
        return fail(*now->settlingProblem);
    if (now)
        warnOfWrites(environment, *now);
    return now;
}

Result<SettledStatus> shownStatus(Environment& environment, CommandSession& session, int axis)
{
    auto now = axiscomp::settledStatus(
        session.compensator(), session.storeRoot(), axis, session.operation());
    if (!now)
        return now;
    warnOfWrites(environment, *now);
    if (!now->isJournalKnown())
        warnOfJournal(environment, *now->settlingProblem);
    else if (now->settlingProblem)
        environment.warn("what an earlier write that did not end has left is not known: "
            + sentence(*now->settlingProblem));
    return now;
}

void warnOfJournal(Environment& environment, const Error& problem)
{
    environment.warn("whether an earlier write did not end is not known: " + sentence(problem));
}

Result<ExitCode> withDrive(
    Environment& environment, const DriveOptions& options, const DriveFunction& function)
{
    const QtRuntime runtime;
    AXISCOMP_TRY(auto session, CommandSession::open(environment, options));
    auto outcome = function(environment, *session);
    environment.console().clearProgress();
    return outcome;
}

Result<ExitCode> withAxis(
    Environment& environment, const DriveOptions& options, const AxisFunction& function)
{
    return withDrive(
        environment, options, [&](Environment& sameEnvironment, CommandSession& session) {
            const auto axis = session.axis();
            return axis ? function(sameEnvironment, session, *axis)
                        : Result<ExitCode>(fail(axis.error()));
        });
}

} // namespace axiscomp::app
