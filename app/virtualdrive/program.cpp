// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/virtualdrive/program.h"

#include "app/common/arguments.h"
#include "app/common/guarded_program.h"
#include "app/common/interrupt.h"
#include "app/common/number_checks.h"
#include "app/virtualdrive/drive_options.h"
#include "core/io/local_file.h"
#include "drivecomm/profile/profile_loader.h"
#include "drivecomm/virtualdrive/faults.h"
#include "drivecomm/virtualdrive/serial/instrument_server.h"
#include "drivecomm/virtualdrive/serial/serial_server.h"
#include "drivecomm/virtualdrive/web/web_server.h"

#include <algorithm>
#include <memory>

namespace axiscomp::app {

namespace {

constexpr const char* programName = "axiscomp-virtualdrive";
constexpr std::size_t longestName = 28; // seven registers of four characters
constexpr std::uint64_t longestPasswordFile = 4096;

/// A drive and everything that serves it; members are destroyed from the last to the first.
struct RunningDrive {
    std::string name;
    std::unique_ptr<drivecomm::VirtualDrive> drive;
    std::unique_ptr<drivecomm::FaultPlan> faults;
    std::unique_ptr<drivecomm::WebServer> web; ///< none when only the serial link is asked for
    std::unique_ptr<drivecomm::SerialServer> serial;
    std::unique_ptr<drivecomm::InstrumentServer> instrument;
};

void addOptions(CLI::App& app, VirtualDriveArguments& arguments)
{
    app.add_option("--http", arguments.http,
           AXISCOMP_HELP("Help",
               "Serve the drive's web pages here; port 0 picks a free one (127.0.0.1:0 unless this "
               "or "
               "--serial is given). Several drives take ports in a row"))
        ->option_text("HOST:PORT");
    CLI::Option* serial = app.add_option("--serial", arguments.serial,
        AXISCOMP_HELP("Help",
            "Serve the serial link on a pseudo-terminal, and make LINK a symbolic link to it. "
            "Several "
            "drives take LINK, LINK-2, ..."));
    serial->option_text("LINK");
    app.add_option("--baud", arguments.baud,
           AXISCOMP_HELP("Help",
               "Make the serial link as slow as a line of this speed (as fast as it can unless "
               "given)"))
        ->option_text("N")
        ->check(CLI::Range(300, 20'000'000))
        ->needs(serial);
    app.add_option("--name", arguments.name,
           AXISCOMP_HELP("Help", "Name of the drive (Virtual-1 unless given)"))
        ->option_text("NAME");
    app.add_option("--axes", arguments.axes,
           AXISCOMP_HELP("Help", "Number of axes, 1 to 16 (2 unless given)"))
        ->option_text("N")
        ->check(CLI::Range(1, 16));
    app.add_option("--config", arguments.configuration,
           AXISCOMP_HELP("Help",
               "Take names, axes and parameters from a TAM configuration; several drives in it are "
               "several virtual drives"))
        ->option_text("FILE.TAMcfg");
    CLI::Option* machine = app.add_option("--machine", arguments.machine,
        AXISCOMP_HELP("Help",
            "Move the machine of this file (JSON): axes with errors that nobody knows, and an "
            "instrument that measures them"));
    machine->option_text("FILE");
    CLI::Option* program = app.add_option("--program", arguments.program,
        AXISCOMP_HELP("Help",
            "Play this measuring plan (axiscomp targets) as the machine's control would, from 10 s "
            "after the start"));
    program->option_text("PLAN.csv")->needs(machine);
    app.add_option("--program-after", arguments.programAfter,
           AXISCOMP_HELP("Help",
               "Begin the program so many seconds after the start, whatever --speed is; unless "
               "given, "
               "after 10 s of the machine's time"))
        ->option_text("SECONDS")
        ->check(numberBetween(0.0, 86400.0))
        ->needs(program);
    app.add_option("--instrument", arguments.instrument,
           AXISCOMP_HELP("Help",
               "Serve the instrument's lines on a pseudo-terminal, and make LINK a symbolic link "
               "to it"))
        ->option_text("LINK")
        ->needs(machine);
    app.add_option("--state", arguments.stateFolder,
           AXISCOMP_HELP(
               "Help", "Keep flash and saved parameters here across runs, a folder per drive"))
        ->option_text("DIR");
    app.add_option("--fault", arguments.faults,
           AXISCOMP_HELP("Help",
               "Misbehave: drop-after=BYTES, no-reply=N, garble=N, stores-wrong=N, slow=MS, "
               "reboot-after=N or reject=CODE; may be given several times"))
        ->option_text("SPEC");
    app.add_option("--speed", arguments.speed,
           AXISCOMP_HELP("Help", "Simulated seconds per second (1 unless given)"))
        ->option_text("FACTOR")
        ->check(numberBetween(0.001, 10000.0));
    app.add_flag("--unhomed", arguments.unhomed,
        AXISCOMP_HELP("Help", "Start with axes that are not homed"));
    CLI::Option* user =
        app.add_option("--user", arguments.user, AXISCOMP_HELP("Help", "Ask for this user name"));
    user->option_text("NAME");
    app.add_option("--password-file", arguments.passwordFile,
           AXISCOMP_HELP("Help", "File whose first line is the password of --user"))
        ->option_text("FILE")
        ->needs(user);
    CLI::Option* certificate = app.add_option("--certificate", arguments.certificate,
        AXISCOMP_HELP("Help", "Serve https with this certificate"));
    certificate->option_text("FILE.pem");
    app.add_option("--key", arguments.key, AXISCOMP_HELP("Help", "Private key of --certificate"))
        ->option_text("FILE.pem")
        ->needs(certificate);
    app.add_option("--profile", arguments.profile,
           AXISCOMP_HELP("Help", "Drive profile (JSON) in place of the built-in one, generic"))
        ->option_text("FILE");
}

Result<void> checkArguments(const VirtualDriveArguments& arguments)
{
    if (arguments.name.size() > longestName)
        return wrongUsage(
            "a drive name has at most " + std::to_string(longestName) + " characters", programName);
    if (!arguments.machine.empty() && (arguments.axes > 0 || !arguments.configuration.empty()))
        return wrongUsage(
            "the axes come from --machine: leave --axes and --config out", programName);
    if (arguments.user.empty() != arguments.passwordFile.empty())
        return wrongUsage("--user and --password-file belong together", programName);
    if (arguments.certificate.empty() != arguments.key.empty())
        return wrongUsage("--certificate and --key belong together", programName);
    return {};
}

Result<drivecomm::WebServerOptions> webOptions(const VirtualDriveArguments& arguments)
{
    drivecomm::WebServerOptions options;
    AXISCOMP_TRY(const auto address,
        parseHostAndPort(arguments.http.empty() ? "127.0.0.1:0" : arguments.http));
    options.host = address.host;
    options.port = address.port;
    options.user = arguments.user;
    options.certificateFile = arguments.certificate;
    options.privateKeyFile = arguments.key;
    if (!arguments.passwordFile.empty()) {
        AXISCOMP_TRY(const auto bytes, loadFile(arguments.passwordFile, longestPasswordFile));
        const std::string_view text = asText(bytes);
        options.password = text.substr(0, text.find_first_of("\r\n"));
        if (options.password.empty())
            return wrongUsage(arguments.passwordFile + " holds no password", programName);
    }
    return options;
}

Result<std::vector<drivecomm::FaultSpec>> faultsOf(const VirtualDriveArguments& arguments)
{
    std::vector<drivecomm::FaultSpec> faults;
    for (const std::string& text : arguments.faults) {
        AXISCOMP_TRY(auto fault, drivecomm::parseFault(text));
        faults.push_back(std::move(fault));
    }
    return faults;
}

std::function<std::chrono::nanoseconds()> simulatedClock(double speed)
{
    return [speed, start = std::chrono::steady_clock::now()] {
        const std::chrono::duration<double> real = std::chrono::steady_clock::now() - start;
        return std::chrono::duration_cast<std::chrono::nanoseconds>(real * speed);
    };
}

Result<void> serveInstrument(
    RunningDrive& drive, const std::string& link, const drivecomm::MachineInstrument& instrument)
{
    AXISCOMP_TRY(auto server,
        drivecomm::InstrumentServer::start(
            [served = drive.drive.get()] { return served->instrumentReading().value_or(0.0); },
            {link, instrument.unit, instrument.unitsPerPosition}));
    drive.instrument = std::move(server);
    return {};
}

Result<void> serveDrive(RunningDrive& drive, std::size_t index,
    const VirtualDriveArguments& arguments, const DriveProfile& profile,
    const drivecomm::WebServerOptions& webOptions)
{
    if (!arguments.http.empty() || arguments.serial.empty()) {
        AXISCOMP_TRY(auto web,
            drivecomm::WebServer::start(*drive.drive, profile, *drive.faults, webOptions));
        drive.web = std::move(web);
    }
    if (arguments.serial.empty())
        return {};
    AXISCOMP_TRY(auto serial,
        drivecomm::SerialServer::start(
            *drive.drive, *drive.faults, {serialLinkOf(arguments.serial, index), arguments.baud}));
    drive.serial = std::move(serial);
    return {};
}

Result<std::vector<RunningDrive>> startAll(
    const VirtualDriveArguments& arguments, const DriveProfile& profile)
{
    AXISCOMP_TRY(auto drives, drivesOf(arguments));
    AXISCOMP_TRY(auto web, webOptions(arguments));
    AXISCOMP_TRY(const auto faults, faultsOf(arguments));
    std::vector<RunningDrive> running;
    for (drivecomm::VirtualDriveOptions& options : drives) {
        RunningDrive drive;
        drive.name = options.name;
        options.clock = simulatedClock(arguments.speed);
        const auto machine = options.machine;
        AXISCOMP_TRY(auto created, drivecomm::VirtualDrive::create(profile, std::move(options)));
        drive.drive = std::move(created);
        drive.faults = std::make_unique<drivecomm::FaultPlan>(faults);
        AXISCOMP_CHECK(serveDrive(drive, running.size(), arguments, profile, web));
        if (machine && !arguments.instrument.empty())
            AXISCOMP_CHECK(serveInstrument(drive, arguments.instrument, machine->instrument));
        if (web.port != 0)
            ++web.port;
        running.push_back(std::move(drive));
    }
    return running;
}

Result<void> serve(const VirtualDriveArguments& arguments, Console& console, Interrupt& interrupt)
{
    if (auto checked = checkArguments(arguments); !checked)
        return checked;
    AXISCOMP_TRY(auto profile,
        arguments.profile.empty() ? Result<DriveProfile>(drivecomm::genericProfile())
                                  : drivecomm::loadProfile(arguments.profile));
    AXISCOMP_TRY(const auto running, startAll(arguments, profile));
    const bool isReachable = std::ranges::any_of(running,
        [](const RunningDrive& each) { return each.web && !each.web->isOnLoopbackOnly(); });
    if (isReachable)
        console.note("warning: the virtual drive can be reached from other computers; write --http "
                     "127.0.0.1:PORT to keep it to this one");
    for (const RunningDrive& drive : running)
        console.print("ready" + (drive.web ? " http=" + drive.web->url() : "")
            + (drive.serial ? " serial=" + drive.serial->device() : "")
            + (drive.instrument ? " instrument=" + drive.instrument->device() : "")
            + " drive=" + singleLine(drive.name) + "\n");
    if (auto flushed = console.flush(); !flushed)
        return flushed;
    interrupt.wait();
    return {};
}

int run(int argc, char** argv, Console& console)
{
    VirtualDriveArguments arguments;
    CLI::App app(
        AXISCOMP_HELP("Help",
            "A servo drive in software, with the web pages, registers and behaviour of a real "
            "one."),
        programName);
    setHelpStyle(app);
    app.set_version_flag("--version", std::string(programName) + " " AXISCOMP_VERSION,
        AXISCOMP_HELP("Help", "Show the version"));
    app.footer(AXISCOMP_HELP("Help",
        "Prints a line `ready http=URL serial=DEVICE drive=NAME` for each drive, and runs until "
        "Ctrl-C."));
    addOptions(app, arguments);
    const auto proceed = parseArguments(app, argc, argv, console);
    if (proceed && !*proceed)
        return static_cast<int>(ExitCode::Done);
    Result<void> outcome;
    if (proceed) {
        Interrupt interrupt;
        outcome = serve(arguments, console, interrupt);
    } else {
        outcome = fail(proceed.error());
    }
    if (outcome)
        return static_cast<int>(ExitCode::Done);
    return static_cast<int>(noteError(console, outcome.error()));
}

} // namespace

int runVirtualDrive(int argc, char** argv)
{
    return runGuarded([&](Console& console) { return run(argc, argv, console); });
}

} // namespace axiscomp::app
