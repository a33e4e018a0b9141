// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program_run.h"

#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QRegularExpression>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTest>
#include <QUrl>

#include <csignal>

#include <sys/resource.h>

namespace tst_virtualdriveprogram {

using namespace axiscomp;
using test::ProgramRun;
using test::Sandbox;
using test::VirtualDriveProcess;

namespace {

QJsonArray axesOf(const Sandbox& box, const QString& url)
{
    return box.run({"axes", "--drive", url, "--json"})
        .json()
        .value("drives")
        .toArray()
        .at(0)
        .toObject()
        .value("axes")
        .toArray();
}

ProgramRun runDrive(const Sandbox& box, const QStringList& arguments)
{
    return box.runProgram(test::virtualDriveProgram(), arguments);
}

} // namespace

class tst_VirtualDriveProgram : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void itIsReadyOnLoopbackWithoutOptions()
    {
        const Sandbox box;
        const VirtualDriveProcess drive(box);
        QCOMPARE(drive.urls().size(), 1);
        QCOMPARE(drive.names(), (QStringList{"Virtual-1"}));
        QCOMPARE(QUrl(drive.url()).host(), "127.0.0.1");
        QCOMPARE(axesOf(box, drive.url()).size(), 2);
    }

    void itEndsCleanlyOnASignal_data()
    {
        QTest::addColumn<int>("number");
        QTest::newRow("SIGINT") << SIGINT;
        QTest::newRow("SIGTERM") << SIGTERM;
    }
    void itEndsCleanlyOnASignal()
    {
        QFETCH(const int, number);
        const Sandbox box;
        VirtualDriveProcess drive(box);
        QVERIFY(drive.isReady());
        ::kill(static_cast<pid_t>(drive.process().processId()), number);
        QVERIFY(drive.process().waitForFinished());
        QCOMPARE(drive.process().exitStatus(), QProcess::NormalExit);
        QCOMPARE(drive.process().exitCode(), 0);
        QCOMPARE(drive.said(), QByteArray());
    }

    void axesAndHomingAreAsGiven()
    {
        const Sandbox box;
        const VirtualDriveProcess drive(box, {"--axes", "5", "--unhomed", "--name", "Press 7"});
        QCOMPARE(drive.names(), (QStringList{"Press 7"}));
        const QJsonArray axes = axesOf(box, drive.url());
        QCOMPARE(axes.size(), 5);
        QCOMPARE(axes.at(0).toObject().value("name").toString(), "X");
        QCOMPARE(axes.at(0).toObject().value("homing").toString(), "NotHomed");
        QCOMPARE(axes.at(4).toObject().value("unit").toString(), "Degree");
    }

    void aPortInUseIsAClearError()
    {
        QTcpServer other;
        QVERIFY(other.listen(QHostAddress::LocalHost));
        const QString address = QStringLiteral("127.0.0.1:%1").arg(other.serverPort());
        const Sandbox box;
        const ProgramRun run = runDrive(box, {"--http", address});
        VERIFY_CODE(run, 2);
        QVERIFY2(run.err.startsWith("error: InvalidEndpoint: "), run.err.constData());
        QVERIFY2(run.err.contains(address.toUtf8()), run.err.constData());
        QCOMPARE(run.out, QByteArray());
    }

    void otherComputersAreWarnedOf()
    {
        const Sandbox box;
        VirtualDriveProcess drive(box, {"--http", "0.0.0.0:0"});
        QVERIFY(drive.isReady());
        QTRY_VERIFY(drive.process().bytesAvailable() == 0);
        QCOMPARE(drive.said(),
            "warning: the virtual drive can be reached from other computers; write --http "
            "127.0.0.1:PORT to keep it to this one\n");
    }

    void itAnswersWithoutFreeDescriptors()
    {
#ifdef __SANITIZE_ADDRESS__
        QSKIP("UndefinedBehaviorSanitizer needs a descriptor to look at an object: it would find "
              "faults that there are not");
#endif
        const Sandbox box;
        VirtualDriveProcess drive(box);
        const QUrl url(drive.url());
        const auto port = static_cast<quint16>(url.port());
        const struct rlimit few {
            40, 40
        };
        const auto pid = static_cast<pid_t>(drive.process().processId());
        QCOMPARE(::prlimit(pid, RLIMIT_NOFILE, &few, nullptr), 0);
        std::vector<std::unique_ptr<QTcpSocket>> crowd;
        for (int i = 0; i < 100; ++i) {
            crowd.push_back(std::make_unique<QTcpSocket>());
            crowd.back()->connectToHost(url.host(), port);
            QVERIFY(crowd.back()->waitForConnected(test::patienceMs));
            crowd.back()->write("GET / HTTP/1.1\r\n"); // and never the rest
            crowd.back()->flush();
            if (i % 20 != 0)
                continue;
            QTcpSocket client;
            client.connectToHost(url.host(), port);
            client.write("GET /directory HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n");
            QVERIFY2(client.waitForReadyRead(test::patienceMs), qPrintable(client.errorString()));
            QVERIFY(client.readAll().startsWith("HTTP/1.1 200 "));
        }
        crowd.clear();
        QCOMPARE(axesOf(box, drive.url()).size(), 2);
    }

    void wrongUsageIsExplained_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("part");
        QTest::newRow("speed of no line")
            << QStringList{"--baud", "9600"} << QByteArray("--serial");
        QTest::newRow("no speed") << QStringList{"--serial", "link", "--baud", "0"}
                                  << QByteArray("--baud");
        QTest::newRow("address") << QStringList{"--http", "8080"} << QByteArray("HOST:PORT");
        QTest::newRow("fault") << QStringList{"--fault", "explode=1"} << QByteArray("explode");
        QTest::newRow("axes") << QStringList{"--axes", "0"} << QByteArray("--axes");
        QTest::newRow("speed") << QStringList{"--speed", "0"} << QByteArray("--speed");
        QTest::newRow("name") << QStringList{"--name", QString(29, 'x')}
                              << QByteArray("28 characters");
        QTest::newRow("user") << QStringList{"--user", "me"} << QByteArray("--password-file");
        QTest::newRow("certificate")
            << QStringList{"--certificate", "c.pem"} << QByteArray("--key");
        QTest::newRow("program") << QStringList{"--program", "p.csv"} << QByteArray("--machine");
        QTest::newRow("instrument")
            << QStringList{"--instrument", "laser"} << QByteArray("--machine");
        QTest::newRow("two kinds of axes") << QStringList{"--machine", "m.json", "--axes", "2"}
                                           << QByteArray("the axes come from --machine");
        QTest::newRow("unknown") << QStringList{"--fast"} << QByteArray("--fast");
    }
    void wrongUsageIsExplained()
    {
        QFETCH(const QStringList, arguments);
        QFETCH(const QByteArray, part);
        const Sandbox box;
        const ProgramRun run = runDrive(box, arguments);
        VERIFY_CODE(run, 2);
        QVERIFY2(run.err.startsWith("error: InvalidArgument: "), run.err.constData());
        QVERIFY2(run.err.contains(part), run.err.constData());
        QCOMPARE(run.err.count('\n'), 1);
    }

    void brokenFilesAreNamed_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("error");
        QTest::newRow("no configuration") << QStringList{"--config", "no.TAMcfg"}
                                          << QByteArray("error: FileNotReadable: no.TAMcfg");
        QTest::newRow("broken configuration")
            << QStringList{"--config", "bad.TAMcfg"} << QByteArray("error: InvalidConfiguration: ");
        QTest::newRow("profile") << QStringList{"--profile", "bad.json"}
                                 << QByteArray("error: InvalidProfile: ");
        QTest::newRow("machine") << QStringList{"--machine", "bad.json"}
                                 << QByteArray("error: FileNotReadable: bad.json cannot be read: "
                                               "axes: this is missing");
        QTest::newRow("program") << QStringList{"--machine",
            AXISCOMP_SOURCE_FOLDER "/resources/machines/screw.json", "--program",
            "bad.json"} << QByteArray("error: FileNotReadable: bad.json cannot be read: line 1: ");
        QTest::newRow("password") << QStringList{"--user", "me", "--password-file", "no.txt"}
                                  << QByteArray("error: FileNotReadable: no.txt");
    }
    void brokenFilesAreNamed()
    {
        QFETCH(const QStringList, arguments);
        QFETCH(const QByteArray, error);
        const Sandbox box;
        box.file("bad.TAMcfg", "<TamTopology><Stations>");
        box.file("bad.json", "{}");
        const ProgramRun run = runDrive(box, arguments);
        VERIFY_CODE(run, 3);
        QVERIFY2(run.err.startsWith(error), run.err.constData());
    }

    void aMachineIsMovedByItsProgramAndMeasured()
    {
        const Sandbox box;
        const QString machines = AXISCOMP_SOURCE_FOLDER "/resources/machines/";
        VERIFY_CODE(box.run({"targets", "--from", "0", "--to", "400", "--count", "5", "--axis", "Y",
                        "-o", "plan.csv"}),
            0);
        const VirtualDriveProcess drive(box,
            {"--machine", machines + "gantry.json", "--program", "plan.csv", "--instrument",
                box.path("laser"), "--speed", "1000"});
        QVERIFY(drive.isReady());
        const QJsonArray axes = axesOf(box, drive.url());
        QCOMPARE(axes.size(), 2);
        QCOMPARE(axes.at(1).toObject().value("name").toString(), "Y");
        QFile laser(box.path("laser"));
        QVERIFY(laser.open(QIODevice::ReadOnly | QIODevice::Unbuffered));
        const QByteArray line = laser.readLine();
        static const QRegularExpression reading("^[+-]\\d+\\.\\d{7} mm\r?\n$");
        QVERIFY2(reading.match(line).hasMatch(), line.constData());
    }

    void everyMachineThatIsInstalledRuns()
    {
        const QDir folder(AXISCOMP_SOURCE_FOLDER "/resources/machines");
        const QStringList names = folder.entryList({"*.json"});
        QCOMPARE(names.size(), 4);
        for (const QString& name : names) {
            const Sandbox box;
            const VirtualDriveProcess drive(box, {"--machine", folder.filePath(name)});
            QVERIFY2(drive.isReady(), qPrintable(name));
        }
    }

    void passwordsAreAskedFor()
    {
        const Sandbox box;
        box.file("password.txt", "s3cret\n");
        const VirtualDriveProcess drive(box, {"--user", "me", "--password-file", "password.txt"});
        const ProgramRun refused = box.run({"files", "--drive", drive.url()});
        VERIFY_CODE(refused, 4);
        QVERIFY2(refused.err.startsWith("error: Unauthorized: "), refused.err.constData());
        QUrl url(drive.url());
        url.setUserName("me");
        url.setPassword("s3cret");
        VERIFY_CODE(box.run({"files", "--drive", url.toString()}), 0);
        url.setPassword("wrong");
        const ProgramRun wrong = box.run({"files", "--drive", url.toString()});
        VERIFY_CODE(wrong, 4);
        QVERIFY(!wrong.err.contains("wrong"));
    }

    void flashSurvivesTheProgramAndVolatileTablesDoNot_data()
    {
        QTest::addColumn<QString>("persistency");
        QTest::addColumn<bool>("survives");
        QTest::newRow("persistent") << "--persistent" << true;
        QTest::newRow("volatile") << "--volatile" << false;
    }
    void flashSurvivesTheProgramAndVolatileTablesDoNot()
    {
        QFETCH(const QString, persistency);
        QFETCH(const bool, survives);
        const Sandbox box;
        box.file("t.csv", "X,T\n0,0\n50,0.001\n100,0.003\n");
        QJsonValue table;
        {
            const VirtualDriveProcess drive(box, {"--state", "flash"});
            VERIFY_CODE(box.run({"write", "--drive", drive.url(), "--axis", "0", "--data", "t.csv",
                            "--dims", "1", "--source1", test::positionSource(0), persistency}),
                0);
            table = box.run({"status", "--drive", drive.url(), "--axis", "0", "--json"})
                        .json()
                        .value("table");
            QVERIFY(table.isObject());
        }
        const VirtualDriveProcess again(box, {"--state", "flash"});
        const QJsonObject status =
            box.run({"status", "--drive", again.url(), "--axis", "0", "--json"}).json();
        QCOMPARE(status.value("table"), survives ? table : QJsonValue());
    }

    void aConfigurationOfTwoDrivesIsTwoVirtualDrives()
    {
        const QString file =
            QStringLiteral(AXISCOMP_SOURCE_FOLDER "/tests/data/tamcfg/two-drives.TAMcfg");
        const Sandbox box;
        const VirtualDriveProcess drives(box, {"--config", file});
        QCOMPARE(drives.urls().size(), 2);
        QVERIFY(drives.url(0) != drives.url(1));
        QVERIFY(drives.names().at(0) != drives.names().at(1));
        for (int i = 0; i < 2; ++i) {
            const ProgramRun run = box.run({"axes", "--drive", drives.url(i), "--json"});
            VERIFY_CODE(run, 0);
            QCOMPARE(
                run.json().value("drives").toArray().at(0).toObject().value("drive").toString(),
                drives.names().at(i));
        }
        const ProgramRun named = runDrive(box, {"--config", file, "--name", "One"});
        VERIFY_CODE(named, 2);
    }

    void aSerialLinkIsServedAlone()
    {
        const Sandbox box;
        const QString link = box.path("drive");
        const VirtualDriveProcess drive(box, {"--serial", link, "--baud", "921600"});
        QCOMPARE(drive.urls(), QStringList{QString()});
        QCOMPARE(drive.devices(), QStringList{QFile::symLinkTarget(link)});
        QCOMPARE(axesOf(box, "serial:" + link).size(), 2);
        QCOMPARE(axesOf(box, "serial:" + drive.devices().at(0) + "?baud=921600").size(), 2);
    }

    void bothLinksLeadToTheSameDrive()
    {
        const Sandbox box;
        box.file("t.csv", "X,T\n0,0\n50,0.001\n100,0.003\n");
        const QString link = box.path("drive");
        const VirtualDriveProcess drive(box, {"--serial", link, "--http", "127.0.0.1:0"});
        const QString serial = "serial:" + link;
        VERIFY_CODE(box.run({"write", "--drive", serial, "--axis", "0", "--data", "t.csv", "--dims",
                        "1", "--source1", test::positionSource(0), "--persistent"}),
            0);
        VERIFY_CODE(box.run({"activate", "--drive", serial, "--axis", "0"}), 0);
        for (const QString& url : {serial, drive.url()}) {
            const QJsonObject status =
                box.run({"status", "--drive", url, "--axis", "0", "--json"}).json();
            QCOMPARE(status.value("state").toString(), "Active");
        }
        VERIFY_CODE(box.run({"deactivate", "--drive", serial, "--axis", "0"}), 0);
    }

    void severalDrivesTakeSeveralLinks()
    {
        const QString file =
            QStringLiteral(AXISCOMP_SOURCE_FOLDER "/tests/data/tamcfg/two-drives.TAMcfg");
        const Sandbox box;
        const QString link = box.path("drive");
        const VirtualDriveProcess drives(box, {"--config", file, "--serial", link});
        QCOMPARE(drives.devices(),
            (QStringList{QFile::symLinkTarget(link), QFile::symLinkTarget(link + "-2")}));
        QVERIFY(!axesOf(box, "serial:" + link + "-2").isEmpty());
    }

    void aPortThatIsNotThereHasItsSentence()
    {
        const Sandbox box;
        const ProgramRun run = box.run({"files", "--drive", "serial:/dev/no-such-port"});
        VERIFY_CODE(run, 5);
        QVERIFY2(run.err.startsWith("error: NotConnected: no connection to serial:/dev/no-such-port"
                                    ": there is no such port"),
            run.err.constData());
    }

    void twoDrivesTakePortsInARow()
    {
        const QString file =
            QStringLiteral(AXISCOMP_SOURCE_FOLDER "/tests/data/tamcfg/two-drives.TAMcfg");
        const Sandbox box;
        // A pair of ports that is free now may be taken by somebody else a moment later.
        for (int attempt = 0; attempt < 10; ++attempt) {
            QTcpServer probe;
            QVERIFY(probe.listen(QHostAddress::LocalHost));
            const int port = probe.serverPort();
            probe.close();
            const VirtualDriveProcess drives(
                box, {"--config", file, "--http", QStringLiteral("127.0.0.1:%1").arg(port)});
            if (!drives.isReady())
                continue;
            QCOMPARE(QUrl(drives.url(0)).port(), port);
            QCOMPARE(QUrl(drives.url(1)).port(), port + 1);
            return;
        }
        QFAIL("no two free ports in a row");
    }
};

AXISCOMP_TEST(tst_VirtualDriveProgram)

} // namespace tst_virtualdriveprogram

#include "tst_virtualdriveprogram.moc"
