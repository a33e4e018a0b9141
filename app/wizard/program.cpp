// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/wizard/program.h"

#include "app/common/arguments.h"
#include "app/common/guarded_program.h"
#include "app/common/interrupt.h"
#include "app/common/number_checks.h"
#include "app/wizard/first_paint.h"
#include "app/wizard/wizard_window.h"
#include "core/store/drive_store.h"
#include "drivecomm/capture/serial_instrument.h"
#include "drivecomm/drive_candidates.h"
#include "drivecomm/link_factory.h"
#include "drivecomm/profile/profile_loader.h"
#include "ui/text/language.h"

#include <QApplication>
#include <QSettings>

namespace axiscomp::app {

namespace {

constexpr const char* programName = "axis-compensation-wizard";

struct WizardArguments {
    std::vector<std::string> drives;
    std::string profile;
    std::string data;
    std::string file;
    double timeoutSeconds = 5.0;
};

void addOptions(CLI::App& app, WizardArguments& arguments)
{
    app.add_option("--drive", arguments.drives,
           AXISCOMP_HELP("Help",
               "Use this drive in place of the remembered ones; may be given several times: "
               "http://[user:password@]host[:port], https://..., serial:/dev/ttyUSB0[?baud=N], "
               "demo:"))
        ->option_text("ENDPOINT")
        ->envname("AXISCOMP_DRIVE");
    app.add_option("--profile", arguments.profile,
           AXISCOMP_HELP("Help", "Drive profile (JSON) in place of the built-in one, generic"))
        ->option_text("FILE");
    app.add_option(
           "--data", arguments.data, AXISCOMP_HELP("Help", "Open this file of compensation data"))
        ->option_text("FILE");
    app.add_option("FILE", arguments.file,
           AXISCOMP_HELP("Help",
               "Open this file: a record (.axcal), a machine file (.toml), a TAM configuration "
               "(.TAMcfg), a table or a measurement"))
        ->option_text("[FILE]");
    app.add_option("--timeout", arguments.timeoutSeconds,
           AXISCOMP_HELP("Help", "How long one exchange with a drive may take (5 unless given)"))
        ->option_text("SECONDS")
        ->check(numberBetween(0.1, 3600.0));
}

Result<DriveProfile> profileOf(const WizardArguments& arguments)
{
    if (arguments.profile.empty())
        return drivecomm::genericProfile();
    return drivecomm::loadProfile(arguments.profile);
}

/// A wrong address is a mistake on the command line, told before there is a window.
Result<QStringList> endpointsOf(const WizardArguments& arguments)
{
    QStringList endpoints;
    for (const std::string& text : arguments.drives) {
        AXISCOMP_CHECK(drivecomm::parseEndpoint(text));
        endpoints += QString::fromStdString(text);
    }
    return endpoints;
}

ui::WizardOptions wizardOptions(const WizardArguments& arguments, const DriveProfile& profile)
{
    ui::WizardOptions options;
    options.profile = &profile;
    options.storeRoot = DriveStore::defaultRoot();
    options.timeout =
        std::chrono::milliseconds(static_cast<std::int64_t>(arguments.timeoutSeconds * 1000.0));
    options.portCandidates = [](const std::vector<std::string>& otherThan, bool anyBaudRate) {
        return drivecomm::candidatesAt(drivecomm::serialPorts(), otherThan,
            anyBaudRate ? drivecomm::BaudRates::Usual : drivecomm::BaudRates::AsGiven);
    };
    options.network.ownNetworks = [] { return drivecomm::ownNetworks(); };
    options.network.candidates = [](const NetworkRange& range,
                                     const std::vector<std::string>& otherThan) {
        return drivecomm::candidatesIn(range, otherThan);
    };
    options.network.mostAtOnce = drivecomm::addressesAtOnce;
    options.instrumentFactory = drivecomm::openSerialInstrument;
    const auto certificates = std::make_shared<TrustedCertificates>(options.storeRoot);
    options.linkFactory = drivecomm::linkFactory(
        profile, [certificates](const std::string& endpoint, const std::string& fingerprint) {
            return certificates->check(endpoint, fingerprint);
        });
    return options;
}

Result<int> showWindow(
    int argc, char** argv, const WizardArguments& arguments, Console& console, FirstPaint& paint)
{
    AXISCOMP_TRY(const auto profile, profileOf(arguments));
    AXISCOMP_TRY(const auto endpoints, endpointsOf(arguments));
    AXISCOMP_CHECK(console.flush());

    Interrupt interrupt; // before any other thread
    QApplication application(argc, argv);
    QApplication::setOrganizationName(QStringLiteral("axiscomp"));
    QApplication::setApplicationName(QString::fromLatin1(programName));
    QApplication::setApplicationVersion(QStringLiteral(AXISCOMP_VERSION));
    QApplication::setDesktopFileName(QString::fromLatin1(programName));
    QApplication::setWindowIcon(ui::wizardIcon());
    QSettings settings;
    WizardWindow window(wizardOptions(arguments, profile), settings);
    const auto close = [&window] {
        QMetaObject::invokeMethod(
            &window, [&window] { window.wizard().closeNow(); }, Qt::QueuedConnection);
    };
    interrupt.setListener([&close](int) { close(); });
    if (interrupt.stopped()) // before there was a window
        close();
    if (!endpoints.isEmpty())
        window.wizard().controller().setEndpoints(endpoints);
    if (!arguments.data.empty())
        window.wizard().openData(QString::fromStdString(arguments.data));
    if (!arguments.file.empty())
        window.wizard().openFile(QString::fromStdString(arguments.file));
    paint.watch(window, console);
    window.show();
    const int result = QApplication::exec();
    interrupt.setListener({});
    return result;
}

int run(int argc, char** argv, Console& console)
{
    FirstPaint paint;
    WizardArguments arguments;
    CLI::App app(
        AXISCOMP_HELP("Help",
            "Writes compensation tables for measured axis errors to servo drives, in a window."),
        programName);
    setHelpStyle(app);
    app.set_version_flag("--version", std::string(programName) + " " AXISCOMP_VERSION,
        AXISCOMP_HELP("Help", "Show the version"));
    app.footer(AXISCOMP_HELP("Help",
        "Without --drive it uses the drives of the last time, or the built-in demo drive."));
    addOptions(app, arguments);
    const auto proceed = parseArguments(app, argc, argv, console);
    if (proceed && !*proceed)
        return static_cast<int>(ExitCode::Done);
    const Result<int> outcome =
        proceed ? showWindow(argc, argv, arguments, console, paint) : fail(proceed.error());
    if (outcome)
        return *outcome;
    return static_cast<int>(noteError(console, outcome.error()));
}

} // namespace

int runWizard(int argc, char** argv)
{
    return runGuarded([&](Console& console) { return run(argc, argv, console); });
}

} // namespace axiscomp::app
