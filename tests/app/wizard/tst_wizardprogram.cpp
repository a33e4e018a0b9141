// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/wizard/wizard_window.h"
#include "drivecomm/link_factory.h"
#include "drivecomm/profile/profile_loader.h"
#include "tests/app/program_run.h"
#include "tests/support/end_watch.h"
#include "tests/support/file_content.h"
#include "tests/support/raw_responder.h"
#include "tests/support/verify.h"
#include "tests/ui/support/window_test.h"

#include <QRegularExpression>
#include <QSettings>
#include <QTest>

namespace tst_wizardprogram {

using namespace axiscomp;
using test::EndWatch;
using test::RawResponder;
using test::Sandbox;

namespace {

/// What the programs are told to give an exchange with the drive.
constexpr std::chrono::milliseconds deadline{6'000};
/// Less than a second deadline, which is what a drive that is asked twice would take.
constexpr std::chrono::milliseconds limit{11'000};

} // namespace

class TestWizardProgram : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aSignalEndsTheProgramWithinOneDeadlineOfADriveThatNeverAnswers()
    {
        const RawResponder silent(test::neverAnswer);
        Sandbox box;
        box.setVariable("XDG_CONFIG_HOME", box.path("config"));
        box.setVariable("QT_QPA_PLATFORM", "offscreen");
        const auto program = box.start(AXISCOMP_WIZARD_PROGRAM,
            {"--drive", QString::fromStdString(silent.url()), "--timeout", "6"});
        QTRY_COMPARE(silent.requests(), 1);
        program->terminate(); // SIGTERM
        QVERIFY(program->waitForFinished(static_cast<int>(limit.count())));
        QCOMPARE(program->exitStatus(), QProcess::NormalExit);
        QCOMPARE(program->exitCode(), 0);
    }

    void closingTheWindowEndsWithinOneDeadlineOfADriveThatNeverAnswers()
    {
        const RawResponder silent(test::neverAnswer);
        const Sandbox box;
        QSettings settings(box.path("settings.ini"), QSettings::IniFormat);
        ui::WizardOptions options;
        options.profile = &drivecomm::genericProfile();
        options.storeRoot = box.path("store").toStdString();
        options.timeout = deadline;
        options.linkFactory = drivecomm::linkFactory(drivecomm::genericProfile());
        auto window = std::make_unique<app::WizardWindow>(options, settings);
        window->wizard().controller().setEndpoints({QString::fromStdString(silent.url())});
        QTRY_COMPARE(silent.requests(), 1);
        EndWatch end(limit);
        QVERIFY(window->close());
        window.reset();
        QVERIFY(end.ended());
    }

    /// make_completion.py and tst_usage look after the options of the other programs.
    void theManPageHasTheOptionsOfTheHelp()
    {
        const Sandbox box;
        const test::ProgramRun run = box.runProgram(AXISCOMP_WIZARD_PROGRAM, {"--help"});
        VERIFY_CODE(run, 0);
        QByteArray page = QByteArray::fromStdString(
            test::contentOf(AXISCOMP_SOURCE_FOLDER "/packaging/man/axis-compensation-wizard.1"));
        page.replace("\\-", "-");
        static const QRegularExpression option(QStringLiteral("(?<![a-z])--[a-z]+"));
        QStringList named;
        for (auto each = option.globalMatch(QString::fromUtf8(run.out)); each.hasNext();)
            named += each.next().captured();
        QVERIFY(named.contains("--drive"));
        for (const QString& name : named)
            QVERIFY2(page.contains(name.toUtf8()), qPrintable(name));
    }

    void aMistakeOnTheCommandLineIsToldWithoutAWindow()
    {
        const Sandbox box;
        const test::ProgramRun run =
            box.runProgram(AXISCOMP_WIZARD_PROGRAM, {"--drive", "nothing://here"});
        VERIFY_CODE(run, 2);
        QVERIFY2(run.err.startsWith("error: InvalidEndpoint: "), run.err.constData());
    }
};

AXISCOMP_WINDOW_TEST(TestWizardProgram)

} // namespace tst_wizardprogram

#include "tst_wizardprogram.moc"
