// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program_run.h"

#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QJsonArray>
#include <QTest>

#include <csignal>

namespace tst_lookupcommand {

using namespace axiscomp;
using test::ProgramRun;
using test::Sandbox;

namespace {

const QByteArray line1D = "X,T\n-10000,1\n0,2\n10000,5\n";
const QByteArray plane = "X,Y,T\n0,0,0\n10000,0,1\n0,10000,2\n10000,10000,5\n";
const QByteArray cube = "X,Y,Z,T\n0,0,0,0\n1000,0,0,1\n0,1000,0,2\n1000,1000,0,3\n"
                        "0,0,1000,4\n1000,0,1000,5\n0,1000,1000,6\n1000,1000,1000,7\n";

} // namespace

class tst_LookupCommand : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void positionsMayBeNegative_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("value");
        QTest::newRow("1D") << line1D << QStringList{"5000", "--dims", "1"} << QByteArray("3.5\n");
        QTest::newRow("negative") << line1D << QStringList{"-5000", "--dims", "1"}
                                  << QByteArray("1.5\n");
        QTest::newRow("negative fraction")
            << line1D << QStringList{"-.5", "--dims", "1"} << QByteArray("1.99995\n");
        QTest::newRow("negative exponent")
            << line1D << QStringList{"-5e3", "--dims", "1"} << QByteArray("1.5\n");
        QTest::newRow("negative behind the options")
            << line1D << QStringList{"--dims", "1", "--", "-5000"} << QByteArray("1.5\n");
        QTest::newRow("negative fraction behind the options")
            << line1D << QStringList{"--dims", "1", "--", "-.5"} << QByteArray("1.99995\n");
        QTest::newRow("2D") << plane << QStringList{"5000", "5000", "--dims", "2"}
                            << QByteArray("2\n");
        QTest::newRow("2D negative")
            << plane << QStringList{"--dims", "2", "-3", "-1"} << QByteArray("0\n");
        QTest::newRow("3D") << cube << QStringList{"500", "500", "500", "--dims", "3"}
                            << QByteArray("3.5\n");
    }
    void positionsMayBeNegative()
    {
        QFETCH(const QByteArray, content);
        QFETCH(const QStringList, arguments);
        const Sandbox box;
        box.file("t.csv", content);
        const ProgramRun run = box.run(QStringList{"lookup", "t.csv"} + arguments);
        VERIFY_CODE(run, 0);
        QTEST(run.out, "value");
    }

    void aFileBehindTheOptionsMayBeCalledLikeOne()
    {
        for (const char* const name : {"-5", "-.5", "--json"}) {
            const Sandbox box;
            box.file(name, line1D);
            const ProgramRun run = box.run({"lookup", "--dims", "1", "--", name, "5000"});
            VERIFY_CODE(run, 0);
            QCOMPARE(run.out, QByteArray("3.5\n"));
        }
    }

    void fileAndPositionMayStandBehindAnOptionThatMayBeRepeated_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("value");
        const QByteArray value = "3.5\n";
        QTest::newRow("position behind a setting")
            << QStringList{"t.csv", "--dims", "1", "--set-in", "value-unit=um", "5000"} << value;
        QTest::newRow("file behind a setting")
            << QStringList{"--set-in", "value-unit=um", "t.csv", "5000", "--dims", "1"} << value;
        QTest::newRow("both behind two settings") << QStringList{"--dims", "1", "--set-in",
            "value-unit=um", "--set-in", "position-unit=um", "t.csv", "5000"}
                                                  << value;
        QTest::newRow("position behind the target")
            << QStringList{"t.csv", "--dims", "1", "--target", "#1", "5000"} << value;
        QTest::newRow("position behind the zero") << QStringList{"t.csv", "--dims", "1", "--zero",
            "-10000", "5000"} << QByteArray("2.5\n");
    }
    void fileAndPositionMayStandBehindAnOptionThatMayBeRepeated()
    {
        QFETCH(const QStringList, arguments);
        const Sandbox box;
        box.file("t.csv", line1D);
        const ProgramRun run = box.run(QStringList{"lookup"} + arguments);
        VERIFY_CODE(run, 0);
        QTEST(run.out, "value");
    }

    void aSignThatNobodyHasPublishedIsStatedOnceOfAFileAndItsController()
    {
        const Sandbox box;
        box.file("t.csv", line1D);
        const QStringList ofFile{"t.dat", "5000", "--from", "weihong"};
        VERIFY_CODE(box.run({"convert", "t.csv", "t.dat", "--dims", "1", "--to", "weihong",
                        "--to-sign", "feedback", "--target", "#1"}),
            0);
        for (const char* sign : {"command", "feedback"}) {
            const QStringList stated = ofFile + QStringList{"--sign", sign};
            const ProgramRun own = box.run(QStringList{"lookup"} + stated);
            VERIFY_CODE(own, 0);
            QCOMPARE(own.out, QByteArray("3.5\n"));
            const ProgramRun forDrive =
                box.run(QStringList{"lookup"} + stated + QStringList{"--as", "csv"});
            VERIFY_CODE(forDrive, 0);
            QCOMPARE(forDrive.out.toDouble() < 0.0, sign == QByteArray("command"));
        }
    }

    /// The controller of the other format has its positions in mm.
    void aPositionIsInTheUnitOfTheFileForAnotherControllerToo()
    {
        const Sandbox box;
        box.file("t.csv", "X [inch],X error [um]\n0,0\n1,25.4\n2,50.8\n3,-25.4\n");
        box.file("points.txt", "2\n2.5\n");
        const QStringList asked{"lookup", "t.csv", "--dims", "1", "--as", "siemens-eec"};
        const ProgramRun one = box.run(asked + QStringList{"2"});
        VERIFY_CODE(one, 0);
        QCOMPARE(one.out, QByteArray("0.0508\n"));
        const ProgramRun list = box.run(asked + QStringList{"--points", "points.txt"});
        VERIFY_CODE(list, 0);
        QCOMPARE(list.out, QByteArray("0.0508\n0.0127\n"));
    }

    void outsideFollowsTheRule_data()
    {
        QTest::addColumn<QString>("rule");
        QTest::addColumn<QByteArray>("value");
        QTest::newRow("default") << "" << QByteArray("5\n");
        QTest::newRow("hold") << "hold" << QByteArray("5\n");
        QTest::newRow("zero") << "zero" << QByteArray("0\n");
        QTest::newRow("wrap") << "wrap" << QByteArray("1.5\n");
        QTest::newRow("extrapolate") << "extrapolate" << QByteArray("6.5\n");
    }
    void outsideFollowsTheRule()
    {
        QFETCH(const QString, rule);
        const Sandbox box;
        box.file("t.csv", line1D);
        QStringList arguments{"lookup", "t.csv", "15000", "--dims", "1"};
        if (!rule.isEmpty())
            arguments << "--outside" << rule;
        const ProgramRun run = box.run(arguments);
        VERIFY_CODE(run, 0);
        QTEST(run.out, "value");
    }

    void outsideCanBeAnError()
    {
        const Sandbox box;
        box.file("t.csv", line1D);
        const ProgramRun run =
            box.run({"lookup", "t.csv", "15000", "--dims", "1", "--outside", "error"});
        VERIFY_CODE(run, 2);
        QVERIFY2(run.err.contains("15000 of -10000 to 10000"), run.err.constData());
        QCOMPARE(run.out, QByteArray());
    }

    void everyInputLineGivesAResultLine()
    {
        const Sandbox box;
        box.file("t.csv", plane);
        box.file("points.txt", "0 0\n5000,5e3\r\n10000; 10000\n-1\t0\n+5000 0");
        const ProgramRun run =
            box.run({"lookup", "t.csv", "--dims", "2", "--points", "points.txt"});
        VERIFY_CODE(run, 0);
        QCOMPARE(run.out, "0\n2\n5\n0\n0.5\n");
    }

    void pointsFromStandardInputAreAnsweredAtOnce()
    {
        const Sandbox box;
        box.file("t.csv", line1D);
        const auto process =
            box.start(test::axiscompProgram(), {"lookup", "t.csv", "--dims", "1", "--points", "-"});
        process->write("5000\n");
        QTRY_VERIFY(process->canReadLine());
        QCOMPARE(process->readLine(), "3.5\n");
        process->write("-5000\n");
        QTRY_VERIFY(process->canReadLine());
        QCOMPARE(process->readLine(), "1.5\n");
        process->closeWriteChannel();
        QVERIFY(process->waitForFinished());
        QCOMPARE(process->exitCode(), 0);
    }

    void interruptStopsWaitingForPoints()
    {
        const Sandbox box;
        box.file("t.csv", line1D);
        const auto process =
            box.start(test::axiscompProgram(), {"lookup", "t.csv", "--dims", "1", "--points", "-"});
        process->write("5000\n");
        QTRY_VERIFY(process->canReadLine());
        QCOMPARE(process->readLine(), "3.5\n");
        ::kill(static_cast<pid_t>(process->processId()), SIGINT);
        QVERIFY(process->waitForFinished());
        QCOMPARE(process->exitStatus(), QProcess::NormalExit);
        QCOMPARE(process->exitCode(), 130);
        QVERIFY(process->readAllStandardError().startsWith("error: Cancelled: "));
    }

    void pointsAreReadAsAnyEditorSavesThem_data()
    {
        QTest::addColumn<QByteArray>("points");
        QTest::newRow("CRLF") << QByteArray("5000\r\n0\r\n");
        QTest::newRow("CR") << QByteArray("5000\r0");
        QTest::newRow("byte-order mark") << QByteArray("\xEF\xBB\xBF"
                                                       "5000\n0\n");
    }
    void pointsAreReadAsAnyEditorSavesThem()
    {
        QFETCH(const QByteArray, points);
        const Sandbox box;
        box.file("t.csv", line1D);
        box.file("points.txt", points);
        const QStringList lookup{"lookup", "t.csv", "--dims", "1"};
        const ProgramRun one = box.run(lookup + QStringList{"0"});
        const ProgramRun run = box.run(lookup + QStringList{"--points", "points.txt"});
        VERIFY_CODE(run, 0);
        QCOMPARE(run.out, "3.5\n" + one.out);
    }

    void aBadPointNamesItsPlace_data()
    {
        QTest::addColumn<QByteArray>("points");
        QTest::addColumn<QByteArray>("place");
        QTest::newRow("word") << QByteArray("1 2\n3 x\n") << QByteArray("points.txt:2:3: error: ");
        QTest::newRow("too few") << QByteArray("1 2\n\n") << QByteArray("points.txt:2:1: error: ");
        QTest::newRow("too many") << QByteArray("1 2 3\n") << QByteArray("points.txt:1:1: error: ");
        const QByteArray utf16("1\0 \0"
                               "2\0\n\0",
            8);
        const QByteArray said = "points.txt:1:1: error: found UTF-16 text, expected UTF-8 text";
        QTest::newRow("UTF-16") << "\xFF\xFE" + utf16 << said;
        QTest::newRow("UTF-16 without a mark") << utf16 << said;
    }
    void aBadPointNamesItsPlace()
    {
        QFETCH(const QByteArray, points);
        QFETCH(const QByteArray, place);
        const Sandbox box;
        box.file("t.csv", plane);
        box.file("points.txt", points);
        const ProgramRun run =
            box.run({"lookup", "t.csv", "--dims", "2", "--points", "points.txt", "--json"});
        VERIFY_CODE(run, 3);
        QVERIFY2(run.err.startsWith(place), run.err.constData());
        QVERIFY2(run.err.contains("points.txt is not a valid list of positions: one problem"),
            run.err.constData());
        const QJsonObject error = run.json().value("error").toObject();
        QCOMPARE(error.value("diagnostics").toArray().size(), 1);
    }

    void theDocumentHoldsExactNumbers()
    {
        const Sandbox box;
        box.file("t.csv", "X,T [um]\n0,0.1\n1000,0.2\n");
        const ProgramRun run = box.run({"lookup", "t.csv", "0", "--dims", "1", "--json"});
        VERIFY_CODE(run, 0);
        const QJsonObject json = run.json();
        QCOMPARE(json.keys(), (QStringList{"file", "outside", "results", "table"}));
        const QJsonObject result = json.value("results").toArray().at(0).toObject();
        QCOMPARE(result.value("value").toDouble(), static_cast<double>(0.1F));
        QCOMPARE(result.value("position").toArray(), (QJsonArray{0}));
        QCOMPARE(json.value("table").toObject().value("unit").toString(), "um");
    }

    void wrongPositionsAreWrongUsage_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("none") << QStringList{};
        QTest::newRow("too few") << QStringList{"1"};
        QTest::newRow("too many") << QStringList{"1", "2", "3"};
        QTest::newRow("far too many") << QStringList{"1", "2", "3", "4"};
        QTest::newRow("word") << QStringList{"1", "two"};
        QTest::newRow("both") << QStringList{"1", "2", "--points", "-"};
        QTest::newRow("rule") << QStringList{"1", "2", "--outside", "round"};
    }
    void wrongPositionsAreWrongUsage()
    {
        QFETCH(const QStringList, arguments);
        const Sandbox box;
        box.file("t.csv", plane);
        const ProgramRun run = box.run(QStringList{"lookup", "t.csv", "--dims", "2"} + arguments);
        VERIFY_CODE(run, 2);
        QVERIFY2(run.err.startsWith("error: InvalidArgument: "), run.err.constData());
        QVERIFY2(run.err.contains("axiscomp lookup --help"), run.err.constData());
        QCOMPARE(run.err.count('\n'), 1);
    }
};

AXISCOMP_TEST(tst_LookupCommand)

} // namespace tst_lookupcommand

#include "tst_lookupcommand.moc"
