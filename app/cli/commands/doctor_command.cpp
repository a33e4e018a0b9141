// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/input/table_input.h"
#include "app/cli/output/doctor_output.h"
#include "app/cli/output/report_output.h"
#include "app/cli/session/command_session.h"
#include "app/cli/session/drive_search.h"
#include "app/texts/program_texts.h"
#include "core/base/parallel.h"
#include "drivecomm/link_factory.h"

#include <QStandardPaths>

#include <algorithm>
#include <filesystem>

namespace axiscomp::app {

namespace {

namespace fs = std::filesystem;

/// A state folder that does not exist, and cannot.
const char* const noStateFolder = "/dev/null/axiscomp";

std::string windowProgram(const fs::path& program)
{
    const auto name = QStringLiteral("axis-compensation-wizard");
    const QString beside = QStandardPaths::findExecutable(
        name, {QString::fromStdString(program.parent_path().string())});
    return (beside.isEmpty() ? QStandardPaths::findExecutable(name) : beside).toStdString();
}

ProgramFacts programFacts()
{
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    ProgramFacts facts{.version = AXISCOMP_VERSION,
        .buildType = AXISCOMP_BUILD_TYPE,
        .path = program.string(),
        .libraries = {{"Qt", qVersion(), QT_VERSION_STR}},
        .tls = drivecomm::tlsLibrary(),
        .window = windowProgram(program),
        .drawsPdf = drawsPdf()};
    std::ranges::move(libraryVersions(), std::back_inserter(facts.libraries));
    return facts;
}

std::vector<SerialPortFacts> portFacts()
{
    std::vector<SerialPortFacts> ports;
    for (const drivecomm::SerialPort& port : drivecomm::serialPorts())
        ports.push_back({port.device, port.description, port.usbId, deviceAccess(port.device)});
    return ports;
}

/// A drive to ask.
struct KnownDrive {
    std::string endpoint; ///< may have a password
    std::string shown;
    std::string place; ///< the same for two names of one serial port
};

/// Those of the options, and the connections of the window: each place once, with the password that
/// the options have.
std::vector<KnownDrive> knownDrives(
    const std::vector<std::string>& given, const std::vector<std::string>& remembered)
{
    std::vector<KnownDrive> drives;
    for (const auto* endpoints : {&given, &remembered})
        for (const std::string& endpoint : *endpoints) {
            std::string place = drivecomm::placeOf(endpoint);
            if (std::ranges::find(drives, place, &KnownDrive::place) == drives.end())
                drives.push_back({endpoint, shownEndpoint(endpoint), std::move(place)});
        }
    return drives;
}

/// Nothing is kept: an unknown certificate stays unknown, and the store is not opened.
drivecomm::CertificateCheck certificateCheckBy(const fs::path& storeRoot)
{
    return [certificates = std::make_shared<TrustedCertificates>(storeRoot)](
               const std::string& endpoint, const std::string& fingerprint) {
        return certificates->check(endpoint, fingerprint);
    };
}

/// All at once: one that does not answer must not make the others wait.
std::vector<DriveAnswer> answersOf(const std::vector<KnownDrive>& drives,
    const Result<DriveProfile>& profile, const DriveOptions& options, const fs::path& storeRoot,
    std::stop_token stop)
{
    std::vector<DriveAnswer> answers(drives.size());
    if (!profile) {
        for (std::size_t n = 0; n < drives.size(); ++n)
            answers[n] = {drives[n].shown, {}, {}, {}, {}, profile.error()};
        return answers;
    }
    const DriveQuestion question{
        .linkFactory = drivecomm::linkFactory(*profile, certificateCheckBy(storeRoot)),
        .profile = *profile,
        .storeRoot = storeRoot,
        .timeLimit =
            std::chrono::milliseconds(static_cast<std::int64_t>(options.timeoutSeconds * 1000.0)),
        .stop = std::move(stop)};
    forEachAtOnce(drives.size(), drives.size(), [&](std::size_t n) {
        answers[n] = askDrive(drives[n].endpoint, drives[n].shown, question);
    });
    return answers;
}

DoctorFacts doctorFacts(Environment& environment, const DriveOptions& options)
{
    const fs::path root = DriveStore::defaultRoot();
    // What is looked at must not be changed by that, and whoever opens a damaged store replaces it.
    const auto scratch = TemporaryFolder::make();
    DoctorFacts facts{.program = programFacts(),
        .computer = computerFacts(),
        .languages = textLanguages(),
        .stateFolder = folderFacts(root),
        .store = {},
        .configuration = {.window = windowSettings(),
            .profileFile = options.profile,
            .profile = {}},
        .ports = portFacts(),
        .drives = {}};
    if (scratch)
        facts.store = lookAtStore(root, scratch->path());
    const fs::path copy = scratch ? scratch->path() : fs::path(noStateFolder);
    for (const TrustedCertificates::Entry& entry : TrustedCertificates(copy).all())
        facts.configuration.certificates.push_back(entry.endpoint);
    const auto profile = profileOf(options.profile);
    if (profile)
        facts.configuration.profile = profile->name;
    else
        facts.configuration.profileError = profile.error();
    environment.console().progress("ask the drives", 0.0);
    facts.drives = answersOf(knownDrives(options.endpoints, facts.configuration.window.drives),
        profile, options, copy, environment.stopToken());
    environment.console().clearProgress();
    return facts;
}

Result<ExitCode> runDoctor(Environment& environment, const DriveOptions& options)
{
    const QtRuntime runtime;
    const DoctorFacts facts = doctorFacts(environment, options);
    if (environment.stopToken().stop_requested())
        return fail(ErrorCode::Cancelled);
    const std::vector<FindingSection> sections = doctorFindings(facts);
    environment.print(doctorText(facts, sections));
    environment.document(doctorJson(facts, sections));
    return countOf(sections, Grade::Problem) == 0 ? ExitCode::Done : ExitCode::ProblemsFound;
}

} // namespace

void addDoctorCommand(CommandLine& line)
{
    auto options = std::make_shared<DriveOptions>();
    options->command = commandName("doctor");
    CLI::App* command = line.add("doctor", computerCommands,
        AXISCOMP_HELP(
            "Help", "Show what this computer has and lacks, and what each known drive answers"),
        [options](Environment& environment) { return runDoctor(environment, *options); });
    addDriveOption(*command, *options, DriveCount::Several);
    addProfileOption(*command, options->profile);
    addTimeoutOption(*command, *options,
        AXISCOMP_HELP("Help", "Time limit for all that a drive is asked (5 unless given)"));
    command->footer(AXISCOMP_HELP("Help",
        "The connections of the window are asked too. Nothing is changed, on this computer or on a "
        "drive. What is printed has no passwords in it and is meant to be sent to whoever helps."));
}

} // namespace axiscomp::app
