// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program_run.h"

#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>
#include <QUrl>

namespace tst_passwords {

using namespace axiscomp;
using test::ProgramRun;
using test::Sandbox;
using test::VirtualDriveProcess;

namespace {

const QByteArray user = "anna";
const QByteArray password = "Xq9-geheim/7";
const QByteArray residuals1D =
    "target [mm],direction,deviation [um]\n0,+,0.1\n50,+,0.2\n100,+,0.1\n";
/// A plan, and the file of its only value: nothing is left to be waited for.
const QString captureReference =
    QStringLiteral("Axes[1]/Signals/PositionController/MasterPosition");
const QByteArray plan = "// axiscomp plan: 1\n// axis: X\n// overrun: 1 mm\n// feed: 1000 mm/min\n"
                        "// dwell: 5 s\n// seed: 1\nstep,run,direction,target [mm],approach [mm]\n"
                        "1,1,+,0.000,-1.000\n";
const QByteArray runs =
    "// axiscomp runs: 1\n// axis: X\n// date: now\n// compensation: off\n// reference: "
    + captureReference.toLatin1()
    + "\n// corrected: none\ntarget [mm],direction,run,deviation [mm],encoder [mm],output "
      "[mm],time\n"
      "0.000,+,1,0.0000000,0.0000000,0.0000000,0.000\n";
const QByteArray line1D = "X [mm],Error [mm]\n0,0\n50,0.002\n100,-0.003\n";

/// The password in every form in which it could turn up.
QByteArrayList formsOfIt()
{
    const QByteArray both = (user + ':' + password).toBase64();
    return {password, password.toPercentEncoding(), both, password.toBase64()};
}

/// What of it is in the text; empty: nothing.
QByteArray foundIn(const QByteArray& text)
{
    for (const QByteArray& form : formsOfIt())
        if (text.contains(form))
            return form;
    return {};
}

/// All files that were written, with their names.
QByteArray filesOf(const Sandbox& box)
{
    QByteArray all;
    QDirIterator files(
        box.path(), QDir::Files | QDir::Hidden | QDir::System, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        QFile file(files.next());
        if (file.open(QIODevice::ReadOnly))
            all += file.fileName().toUtf8() + '\n' + file.readAll() + '\n';
    }
    return all;
}

/// A drive that asks for the password.
struct GuardedDrive {
    GuardedDrive() : drive((box.file("password", password + '\n'), box), options()) { }

    static QStringList options()
    {
        return {"--user", QString::fromLatin1(user), "--password-file", "password"};
    }
    [[nodiscard]] QString urlWith(const QByteArray& given) const
    {
        QUrl url(drive.url());
        url.setUserName(QString::fromLatin1(user));
        url.setPassword(QString::fromLatin1(given.toPercentEncoding()), QUrl::TolerantMode);
        return QString::fromLatin1(url.toEncoded());
    }

    Sandbox box;
    VirtualDriveProcess drive;
};

const QByteArray machine = "<TamTopology><TamStation Name='Machine'>"
                           "<RegisterComponent Type='SourceTable' Value='Disabled' "
                           "Address='Axes[0]/Parameters/Compensations/Axis/Table'/>"
                           "<RegisterComponent Type='UInt32' Value='0' "
                           "Address='Axes[0]/Parameters/Compensations/Axis/Dim1Source'/>"
                           "</TamStation></TamTopology>\n";

/// Every command that talks to a drive, in an order in which each can be done.
const QList<QStringList>& driveCommands()
{
    static const QList<QStringList> all{
        {"axes"},
        {"capture", "--axis", "0", "--plan", "plan.csv", "--reference", captureReference, "-o",
            "runs.csv"},
        {"write", "--axis", "0", "--data", "line.csv", "--dims", "1", "--source1",
            test::positionSource(0), "--persistent"},
        {"status", "--axis", "0"},
        {"unpersist", "--axis", "0"},
        {"persist", "--axis", "0"},
        {"evaluate", "--axis", "0"},
        {"deactivate", "--axis", "0"},
        {"activate", "--axis", "0"},
        {"monitor", "--axis", "0", "--count", "2"},
        {"fit", "residuals.csv", "--onto", "drive", "--axis", "0", "--measured-with", "on",
            "--points", "3"},
        {"snapshot", "-o", "snapshot"},
        {"metrics", "-o", "metrics.prom"},
        {"deactivate", "--axis", "0"},
        {"read", "--axis", "0", "-o", "read.TAMtbl"},
        {"files"},
        {"upload", "read.TAMtbl", "--to", "tables/small5.TAMtbl"},
        {"download", "tables/small5.TAMtbl", "-o", "download.TAMtbl"},
        {"backup", "-o", "backup.json"},
        {"delete", "--slot", "small5"},
        {"config", "export", "machine.TAMcfg"},
        {"restore", "backup.json"},
        {"recover", "--axis", "0"},
        {"doctor"},
    };
    return all;
}

} // namespace

/// A password that is part of an address is used, and is nowhere afterwards.
class tst_Passwords : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void everyDriveCommandIsTried()
    {
        const Sandbox box;
        const QByteArray help = box.run({"--help"}).out;
        QVERIFY(!help.isEmpty());
        static const QRegularExpression name("^  ([a-z]+) ", QRegularExpression::MultilineOption);
        int drives = 0;
        for (auto match = name.globalMatch(QString::fromUtf8(help)); match.hasNext();) {
            const QString command = match.next().captured(1);
            const ProgramRun run = box.run({command, "--help"});
            if (run.code != 0 || !run.out.contains("--drive"))
                continue;
            ++drives;
            const bool isTried = std::ranges::any_of(driveCommands(),
                [&](const QStringList& tried) { return tried.front() == command; });
            QVERIFY2(isTried, qPrintable(command));
        }
        QVERIFY(drives >= 14);
    }

    void noCommandTellsThePassword_data()
    {
        QTest::addColumn<bool>("json");
        QTest::addColumn<bool>("isRight");
        QTest::newRow("right") << false << true;
        QTest::newRow("right, JSON") << true << true;
        QTest::newRow("wrong") << false << false;
        QTest::newRow("wrong, JSON") << true << false;
    }
    void noCommandTellsThePassword()
    {
        QFETCH(const bool, json);
        QFETCH(const bool, isRight);
        const GuardedDrive guarded;
        QVERIFY(guarded.drive.isReady());
        // A wrong password must not be told either: it is the right one of something else.
        const QString url =
            isRight ? guarded.urlWith(password) : guarded.urlWith(password).replace("anna", "otto");
        const Sandbox box;
        box.file("line.csv", line1D);
        box.file("residuals.csv", residuals1D);
        box.file("plan.csv", plan);
        box.file("runs.csv", runs);
        box.file("machine.TAMcfg", machine);
        for (const QStringList& command : driveCommands()) {
            if (!isRight && (command.front() == "restore" || command.front() == "upload"))
                continue; // there is no file
            QStringList arguments = command + QStringList{"--drive", url};
            if (json)
                arguments += "--json";
            const ProgramRun run = box.run(arguments);
            // A drive that does not answer is what metrics has to say.
            const bool isFine = isRight || command.front() == "metrics";
            // The computer may have problems beside the drive.
            const bool saysProblems = command.front() == "doctor" && (!isRight || run.code != 0);
            VERIFY_CODE(run, saysProblems ? 10 : isFine ? 0 : 4);
            QVERIFY2(foundIn(run.out + run.err).isEmpty(), run.text().constData());
        }
        const QByteArray files = filesOf(box);
        QVERIFY(!isRight || files.contains("backups")); // it looked where there was something
        QVERIFY2(foundIn(files).isEmpty(), files.left(5000).constData());
    }

    void noMistakeTellsThePassword_data()
    {
        QTest::addColumn<QStringList>("arguments");
        const QString host = "http://anna:" + QString::fromLatin1(password) + "@127.0.0.1:1";
        const QString encoded =
            "http://anna:" + QString::fromLatin1(password.toPercentEncoding()) + "@127.0.0.1:1";
        QTest::newRow("nothing there") << QStringList{"status", "--drive", encoded};
        QTest::newRow("no address") << QStringList{"status", "--drive", host};
        QTest::newRow("a slash in it")
            << QStringList{"status", "--drive", "http://anna:12/Xq9-geheim/7@127.0.0.1:1"};
        QTest::newRow("a number sign in it")
            << QStringList{"status", "--drive", "http://anna:12#Xq9-geheim/7@127.0.0.1:1"};
        QTest::newRow("a path") << QStringList{"status", "--drive", encoded + "/path"};
        QTest::newRow("another scheme")
            << QStringList{"status", "--drive", QString(encoded).replace("http:", "ftp:")};
        QTest::newRow("without --drive") << QStringList{"status", encoded};
        QTest::newRow("joined") << QStringList{"status", "--drive=" + encoded};
        QTest::newRow("in place of a file") << QStringList{"restore", encoded, "--drive", "demo:"};
        QTest::newRow("in place of a command") << QStringList{encoded};
        QTest::newRow("two drives") << QStringList{"status", "--drive", encoded, "--drive", host};
        QTest::newRow("several") << QStringList{"axes", "--drive", encoded, "--drive", host};
        QTest::newRow("search") << QStringList{"axes", "--find", "--drive", encoded};
    }
    void noMistakeTellsThePassword()
    {
        QFETCH(QStringList, arguments);
        for (const bool json : {false, true}) {
            const Sandbox box;
            if (json)
                arguments += "--json";
            const ProgramRun run = box.run(arguments);
            QVERIFY(run.code > 0 && run.code < 128);
            QVERIFY2(foundIn(run.out + run.err).isEmpty(), run.text().constData());
            QVERIFY2(!(run.out + run.err).contains("geheim"), run.text().constData());
            QVERIFY(foundIn(filesOf(box)).isEmpty());
        }
    }

    void theWayOutKeepsItsExample()
    {
        const GuardedDrive guarded;
        const ProgramRun run = guarded.box.run({"axes", "--drive", guarded.drive.url()});
        VERIFY_CODE(run, 4);
        QVERIFY2(run.err.contains("http://user:password@host"), run.err.constData());
    }

    void aWrongPasswordIsNotCalledAMissingOne()
    {
        const GuardedDrive guarded;
        const ProgramRun run = guarded.box.run({"axes", "--drive", guarded.urlWith("wrong")});
        VERIFY_CODE(run, 4);
        QVERIFY2(run.err.contains(" refuses the user name or the password "), run.err.constData());
    }

    /// It overrules AXISCOMP_DRIVE, which has the password.
    void theCommandThatComesNextHasNoDriveWhereTheVariableHasThePassword()
    {
        const GuardedDrive guarded;
        Sandbox box;
        box.file("line.csv", line1D);
        const QStringList write{"write", "--axis", "0", "--data", "line.csv", "--dims", "1",
            "--source1", test::positionSource(0)};
        const ProgramRun named = box.run(write + QStringList{"--drive", guarded.urlWith(password)});
        VERIFY_CODE(named, 0);
        QString shown = guarded.drive.url();
        shown.insert(shown.indexOf("://") + 3, "user:password@");
        const QByteArray asked = "axiscomp activate --drive " + shown.toLatin1() + " --axis 0\n";
        QVERIFY2(named.out.contains(asked), named.out.constData());
        box.setVariable("AXISCOMP_DRIVE", guarded.urlWith(password));
        box.file("line.csv", line1D + "150,0.001\n");
        const ProgramRun known = box.run(write);
        VERIFY_CODE(known, 0);
        QVERIFY2(known.out.contains("axiscomp activate --axis 0\n"), known.out.constData());
        VERIFY_CODE(box.run({"activate", "--axis", "0"}), 0);
    }

    void noOtherUserSeesItAmongTheArguments()
    {
        const GuardedDrive guarded;
        const Sandbox box;
        const auto monitor = box.start(test::axiscompProgram(),
            {"monitor", "--axis", "0", "--drive", guarded.urlWith(password)});
        QVERIFY(monitor->waitForReadyRead(
            test::patienceMs)); // it is at work, so it has read its arguments
        QFile arguments(QStringLiteral("/proc/%1/cmdline").arg(monitor->processId()));
        QVERIFY(arguments.open(QIODevice::ReadOnly));
        const QByteArray seen = arguments.readAll();
        QVERIFY2(seen.contains("monitor") && seen.contains("anna"), seen.constData());
        QVERIFY2(foundIn(seen).isEmpty(), seen.constData());
        monitor->terminate();
        QVERIFY(monitor->waitForFinished(test::patienceMs));
    }
};

AXISCOMP_TEST(tst_Passwords)

} // namespace tst_passwords

#include "tst_passwords.moc"
