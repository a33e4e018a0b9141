// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program_run.h"

#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QTest>

#include <csignal>

namespace tst_drivecommands {

using namespace axiscomp;
using test::ProgramRun;
using test::Sandbox;
using test::VirtualDriveProcess;

namespace {

const QStringList statusKeys{"activation", "axis", "dimensions", "drive", "error", "flash",
    "homing", "indices", "output", "persistent", "slot", "sources", "state", "table"};

const QByteArray line1D = "X [mm],Error [mm]\n0,0\n50,0.002\n100,-0.003\n";

QStringList with(const VirtualDriveProcess& drive, const QStringList& arguments)
{
    return arguments + QStringList{"--drive", drive.url()};
}

/// Writes a small 1D table to axis 0.
ProgramRun writeLine(const Sandbox& box, const VirtualDriveProcess& drive,
    const QStringList& more = {}, const QByteArray& data = line1D)
{
    box.file("line.csv", data);
    return box.run(with(drive,
        QStringList{"write", "--axis", "0", "--data", "line.csv", "--dims", "1", "--source1",
            test::positionSource(0)}
            + more));
}

} // namespace

class tst_DriveCommands : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void axesListsAllDrivesAndGoesOnWhenOneFails()
    {
        const Sandbox box;
        const VirtualDriveProcess first(box, {"--name", "First"});
        const VirtualDriveProcess second(box, {"--name", "Second", "--axes", "3"});
        QVERIFY(first.isReady() && second.isReady());
        const QStringList arguments{"axes", "--drive", first.url(), "--drive", "http://127.0.0.1:1",
            "--drive", second.url()};
        const ProgramRun text = box.run(arguments);
        VERIFY_CODE(text, 5);
        QVERIFY(text.out.contains("First"));
        QCOMPARE(text.out.count("Second"), 3);
        QVERIFY2(text.err.startsWith("error: NotConnected: no connection to http://127.0.0.1:1"),
            text.err.constData());

        const ProgramRun run = box.run(arguments + QStringList{"--json"});
        VERIFY_CODE(run, 5);
        const QJsonArray drives = run.json().value("drives").toArray();
        QCOMPARE(drives.size(), 3);
        const QJsonObject drive = drives.at(0).toObject();
        QCOMPARE(drive.keys(), (QStringList{"axes", "drive", "endpoint", "serialNumber"}));
        QCOMPARE(drive.value("drive").toString(), "First");
        const QJsonObject axis = drive.value("axes").toArray().at(0).toObject();
        QCOMPARE(axis.keys(), (QStringList{"homing", "index", "name", "state", "travel", "unit"}));
        QCOMPARE(axis.value("unit").toString(), "Millimeter");
        const QJsonObject broken = drives.at(1).toObject();
        QCOMPARE(broken.keys(), (QStringList{"endpoint", "error"}));
        QCOMPARE(broken.value("error").toObject().value("code").toString(), "NotConnected");
        QCOMPARE(drives.at(2).toObject().value("axes").toArray().size(), 3);
    }

    void theDriveComesFromTheEnvironmentUnlessItIsGiven()
    {
        Sandbox box;
        box.setVariable("AXISCOMP_DRIVE", "demo:");
        const ProgramRun run = box.run({"axes", "--json"});
        VERIFY_CODE(run, 0);
        QCOMPARE(run.json().value("drives").toArray().at(0).toObject().value("drive").toString(),
            "Demo");
        const ProgramRun given = box.run({"axes", "--drive", "http://127.0.0.1:1"});
        VERIFY_CODE(given, 5);
    }

    void whatWasDoneIsSaidWhereStandardOutputIsFull()
    {
        const Sandbox box;
        const VirtualDriveProcess drive(box);
        QVERIFY(drive.isReady());
        box.file("line.csv", line1D);
        const auto toNowhere = [&](const QStringList& command) {
            return box.runProgram(QStringLiteral("/bin/sh"),
                QStringList{"-c", "exec \"$0\" \"$@\" > /dev/full", test::axiscompProgram()}
                    + with(drive, command + QStringList{"--axis", "0"}));
        };
        const QStringList write{
            "write", "--data", "line.csv", "--dims", "1", "--source1", test::positionSource(0)};
        const QList<std::pair<QStringList, QByteArray>> deeds{
            {write, "note: Written and verified: every byte"},
            {{"activate", "--json"}, "note: The compensation of axis 0 (X) of "},
            {{"deactivate"}, "note: The compensation of axis 0 (X) of "},
            {{"delete"}, "note: Deleted and verified: Small1 is empty"}};
        for (const auto& [command, said] : deeds) {
            const ProgramRun run = toNowhere(command);
            VERIFY_CODE(run, 1);
            QVERIFY2(run.err.contains(said), run.err.constData());
            QVERIFY2(
                run.err.contains("error: FileNotWritable: standard output"), run.err.constData());
        }
        const ProgramRun looked = toNowhere({"status"});
        VERIFY_CODE(looked, 1);
        QVERIFY2(looked.err.startsWith("error: FileNotWritable: "), looked.err.constData());
    }

    void anAxisIsGivenByIndexOrNameOrIsTheOnlyOne()
    {
        const Sandbox box;
        const VirtualDriveProcess two(box, {"--axes", "2"});
        const VirtualDriveProcess one(box, {"--axes", "1", "--name", "Single"});
        QCOMPARE(box.run(with(two, {"status", "--axis", "Y", "--json"})).json().value("axis"), 1);
        QCOMPARE(box.run(with(two, {"status", "--axis", "1", "--json"})).json().value("axis"), 1);
        QCOMPARE(box.run(with(one, {"status", "--json"})).json().value("axis"), 0);
        const ProgramRun missing = box.run(with(two, {"status"}));
        VERIFY_CODE(missing, 2);
        QVERIFY2(missing.err.contains("0 (X), 1 (Y)"), missing.err.constData());
        const ProgramRun wrong = box.run(with(two, {"status", "--axis", "Z"}));
        VERIFY_CODE(wrong, 2);
        QVERIFY2(wrong.err.startsWith("error: AxisNotFound: "), wrong.err.constData());
    }

    void statusHasExactlyTheKeysOfTheSpecification()
    {
        const Sandbox box;
        const ProgramRun run = box.run({"status", "--drive", "demo:", "--axis", "X", "--json"});
        VERIFY_CODE(run, 0);
        const QJsonObject json = run.json();
        QCOMPARE(json.keys(), statusKeys);
        QCOMPARE(json.value("drive").toString(), "Demo");
        QCOMPARE(json.value("dimensions").toInt(), 2);
        QCOMPARE(json.value("slot").toString(), "Small1");
        QCOMPARE(json.value("persistent").toBool(), true);
        QCOMPARE(json.value("sources").toArray().size(), 2);
        QVERIFY(json.value("sources").toArray().at(0).toString().startsWith("tam://mc/Demo/Axes"));
        QCOMPARE(json.value("indices").toArray().size(), 2);
        const QJsonObject table = json.value("table").toObject();
        QCOMPARE(table.keys(), (QStringList{"axes", "crc", "elements"}));
        QCOMPARE(table.value("axes").toArray().at(0).toObject().keys(),
            (QStringList{"distance", "name", "size", "start", "unit"}));
    }

    void statusOfAnAxisWithoutATableSaysSo()
    {
        const Sandbox box;
        const VirtualDriveProcess drive(box);
        const ProgramRun run = box.run(with(drive, {"status", "--axis", "0", "--json"}));
        VERIFY_CODE(run, 0);
        QCOMPARE(run.json().keys(), statusKeys);
        QVERIFY(run.json().value("slot").isNull());
        QVERIFY(run.json().value("table").isNull());
        QCOMPARE(run.json().value("persistent").toBool(true), false);
        const ProgramRun text = box.run(with(drive, {"status", "--axis", "0"}));
        QVERIFY2(text.out.contains("Table         none\n"), text.out.constData());
        QVERIFY2(text.out.contains("8 operations possible now"), text.out.constData());
    }

    void activationIsProvedAndReported()
    {
        const Sandbox box;
        const VirtualDriveProcess drive(box);
        VERIFY_CODE(writeLine(box, drive), 0);
        const ProgramRun evaluated = box.run(with(drive, {"evaluate", "--axis", "0", "--json"}));
        VERIFY_CODE(evaluated, 0);
        QCOMPARE(evaluated.json().value("status").toObject().value("state"), "Evaluating");
        QVERIFY(!evaluated.json().value("proof").toObject().value("proved").toBool(true));

        const ProgramRun activated = box.run(with(drive, {"activate", "--axis", "0", "--json"}));
        VERIFY_CODE(activated, 0);
        QCOMPARE(activated.json().keys(), (QStringList{"proof", "status"}));
        QCOMPARE(activated.json().value("status").toObject().value("state"), "Active");
        const QJsonObject proof = activated.json().value("proof").toObject();
        QCOMPARE(proof.keys(),
            (QStringList{"largestDifference", "proved", "provedShare", "samples", "tolerance"}));
        QVERIFY(proof.value("provedShare").toDouble() > 0.0);
        QVERIFY(proof.value("provedShare").toDouble() < 1.0);
        QVERIFY(proof.value("tolerance").toDouble() > 0.0);
        QVERIFY(proof.value("proved").toBool());
        QVERIFY(proof.value("largestDifference").toDouble() <= proof.value("tolerance").toDouble());
        const QJsonObject sample = proof.value("samples").toArray().at(0).toObject();
        QCOMPARE(sample.keys(),
            (QStringList{"expected", "expectedIndices", "indices", "output", "sources"}));
        QCOMPARE(sample.value("sources").toArray().size(), 1);

        const ProgramRun text = box.run(with(drive, {"activate", "--axis", "0"}));
        VERIFY_CODE(text, 0);
        QVERIFY2(text.out.contains("Proof: what the drive adds is what the table says, over "),
            text.out.constData());

        const ProgramRun off = box.run(with(drive, {"deactivate", "--axis", "0", "--json"}));
        VERIFY_CODE(off, 0);
        QCOMPARE(off.json().keys(), (QStringList{"status"}));
        QCOMPARE(off.json().value("status").toObject().value("state"), "Disabled");
    }

    void activationIsRefusedWithTheReason_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<bool>("hasTable");
        QTest::addColumn<QByteArray>("error");
        QTest::newRow("no table") << QStringList{} << false << QByteArray("error: NoTable: ");
        QTest::newRow("not homed")
            << QStringList{"--unhomed"} << true << QByteArray("error: NotHomed: ");
    }
    void activationIsRefusedWithTheReason()
    {
        QFETCH(const QStringList, options);
        QFETCH(const bool, hasTable);
        QFETCH(const QByteArray, error);
        const Sandbox box;
        const VirtualDriveProcess drive(box, options);
        if (hasTable)
            VERIFY_CODE(writeLine(box, drive), 0);
        const ProgramRun run = box.run(with(drive, {"activate", "--axis", "0"}));
        VERIFY_CODE(run, 4);
        QVERIFY2(run.err.startsWith(error), run.err.constData());
    }

    void readGivesBackWhatWasWritten()
    {
        const Sandbox box;
        const VirtualDriveProcess drive(box);
        VERIFY_CODE(writeLine(box, drive), 0);
        const ProgramRun csv =
            box.run(with(drive, {"read", "--axis", "0", "-o", "r.csv", "--json"}));
        VERIFY_CODE(csv, 0);
        QCOMPARE(csv.json().keys(),
            (QStringList{"axes", "bytes", "format", "output", "status", "table"}));
        for (const char* const position : {"0", "25", "50", "80", "100"})
            QCOMPARE(box.run({"lookup", "r.csv", position, "--dims", "1"}).out,
                box.run({"lookup", "line.csv", position, "--dims", "1"}).out);

        const ProgramRun bare = box.run(with(drive, {"read", "--axis", "0", "-o", "r.TAMtbl"}));
        VERIFY_CODE(bare, 0);
        // Which r.csv says.
        QVERIFY2(bare.err.contains("r.TAMtbl: the new file does not say that the drive has to look "
                                   "it up at the set position"),
            bare.err.constData());
        VERIFY_CODE(
            box.run(with(drive, {"download", "tables/small1.TAMtbl", "-o", "d.TAMtbl"})), 0);
        QCOMPARE(box.content("r.TAMtbl"), box.content("d.TAMtbl"));
        QVERIFY(!box.content("r.TAMtbl").isEmpty());
        const ProgramRun text = box.run(with(drive, {"read", "--axis", "0"}));
        VERIFY_CODE(text, 0);
        QCOMPARE(text.out, box.content("r.csv"));
    }

    void readWithoutATableIsAnError()
    {
        const Sandbox box;
        const VirtualDriveProcess drive(box);
        for (const char* const file : {"o.csv", "o.TAMtbl"}) {
            const ProgramRun run = box.run(with(drive, {"read", "--axis", "0", "-o", file}));
            VERIFY_CODE(run, 4);
            QVERIFY2(run.err.startsWith("error: NoTable: "), run.err.constData());
            QVERIFY(!QFile::exists(box.path(file)));
        }
    }

    void filesAreTransferredAsTheyAre()
    {
        const Sandbox box;
        const VirtualDriveProcess drive(box);
        box.file("line.csv", line1D);
        VERIFY_CODE(box.run({"convert", "line.csv", "l.TAMtbl", "--dims", "1"}), 0);
        const ProgramRun up =
            box.run(with(drive, {"upload", "l.TAMtbl", "--to", "tables/large2.TAMtbl", "--json"}));
        VERIFY_CODE(up, 0);
        QCOMPARE(up.json().value("verified").toBool(), true);
        const ProgramRun list = box.run(with(drive, {"files", "--json"}));
        VERIFY_CODE(list, 0);
        const QJsonArray files = list.json().value("files").toArray();
        QCOMPARE(files.size(), 10);
        QCOMPARE(files.at(9).toObject().keys(), (QStringList{"maximumSize", "path", "size"}));
        QCOMPARE(files.at(9).toObject().value("path").toString(), "tables/large2.TAMtbl");
        QCOMPARE(files.at(9).toObject().value("size").toInt(), box.content("l.TAMtbl").size());
        const ProgramRun down = box.run(with(drive, {"download", "tables/large2.TAMtbl"}));
        VERIFY_CODE(down, 0);
        QCOMPARE(down.out, box.content("l.TAMtbl"));
    }

    void whatAnUploadCostsInFlashIsSaid()
    {
        const Sandbox box;
        const VirtualDriveProcess drive(box);
        box.file("line.csv", line1D);
        VERIFY_CODE(box.run({"convert", "line.csv", "v.TAMtbl", "--dims", "1"}), 0);
        VERIFY_CODE(box.run({"convert", "line.csv", "p.TAMtbl", "--dims", "1", "--persistent"}), 0);
        const auto upload = [&](const QStringList& more) {
            return box.run(
                with(drive, QStringList{"upload", "--to", "tables/small1.TAMtbl"} + more));
        };
        const ProgramRun quiet = upload({"v.TAMtbl"});
        VERIFY_CODE(quiet, 0);
        QVERIFY2(!quiet.out.contains("Flash"), quiet.out.constData());
        const ProgramRun said = upload({"p.TAMtbl"});
        VERIFY_CODE(said, 0);
        QVERIFY2(said.out.startsWith("Flash: 1 operation; 8 operations possible now\n"),
            said.out.constData());
        const QJsonObject again = upload({"p.TAMtbl", "--json"}).json();
        QCOMPARE(again.value("persistent"), QJsonValue(true));
        QCOMPARE(again.value("flashOperations").toInt(-1), 0);
    }

    void transfersThatTheDriveRefusesAreNamed_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("error");
        QTest::newRow("unknown path") << QStringList{"upload", "junk.TAMtbl", "--to",
            "tables/none.TAMtbl"} << QByteArray("error: UnknownFile: ");
        QTest::newRow("no table") << QStringList{"upload", "junk.TAMtbl", "--to",
            "tables/small1.TAMtbl"}
                                  << QByteArray("error: TableRefused: ");
        QTest::newRow("download") << QStringList{"download", "tables/none.TAMtbl", "-o", "o"}
                                  << QByteArray("error: UnknownFile: ");
        QTest::newRow("too large") << QStringList{"upload", "large.TAMtbl", "--to",
            "tables/small1.TAMtbl"} << QByteArray("error: TooLargeForSlot: ");
    }
    void transfersThatTheDriveRefusesAreNamed()
    {
        QFETCH(const QStringList, arguments);
        QFETCH(const QByteArray, error);
        const Sandbox box;
        const VirtualDriveProcess drive(box);
        box.file("junk.TAMtbl", "this is not a table");
        box.file("large.TAMtbl", QByteArray(70'000, 'x'));
        const ProgramRun run = box.run(with(drive, arguments));
        VERIFY_CODE(run, 4);
        QVERIFY2(run.err.startsWith(error), run.err.constData());
    }

    void monitorPrintsLinesWithAHeader()
    {
        const Sandbox box;
        const ProgramRun run = box.run(
            {"monitor", "--drive", "demo:", "--axis", "X", "--rate", "100", "--count", "3"});
        VERIFY_CODE(run, 0);
        const QList<QByteArray> lines = run.out.trimmed().split('\n');
        QCOMPARE(lines.size(), 4);
        QCOMPARE(lines.at(0), "time,state,output,index1,index2,source1,source2");
        for (const QByteArray& line : lines)
            QCOMPARE(line.count(','), 6);
        const ProgramRun json = box.run({"monitor", "--drive", "demo:", "--axis", "X", "--rate",
            "100", "--count", "2", "--json"});
        VERIFY_CODE(json, 0);
        const QJsonArray samples = QJsonDocument::fromJson(json.out).array();
        QCOMPARE(samples.size(), 2);
        QCOMPARE(samples.at(0).toObject().keys(),
            (QStringList{"index1", "index2", "output", "source1", "source2", "state", "time"}));
    }

    void monitorEndsCleanlyWhenItIsStopped()
    {
        const Sandbox box;
        const auto process = box.start(test::axiscompProgram(),
            {"monitor", "--drive", "demo:", "--axis", "X", "--rate", "50", "--json"});
        QTRY_VERIFY(process->bytesAvailable() > 100);
        ::kill(static_cast<pid_t>(process->processId()), SIGINT);
        QVERIFY(process->waitForFinished());
        QCOMPARE(process->exitStatus(), QProcess::NormalExit);
        QCOMPARE(process->exitCode(), 0);
        QVERIFY(QJsonDocument::fromJson(process->readAllStandardOutput()).isArray());
        QCOMPARE(process->readAllStandardError(), QByteArray());
    }

    void monitorEndsWhenItsColumnsAreNoLongerTheSources()
    {
        const Sandbox box;
        const VirtualDriveProcess drive(box);
        QVERIFY(drive.isReady());
        VERIFY_CODE(writeLine(box, drive), 0);
        const auto process = box.start(test::axiscompProgram(),
            {"monitor", "--drive", drive.url(), "--axis", "0", "--rate", "20"});
        QTRY_VERIFY(process->bytesAvailable() > 100);
        VERIFY_CODE(
            box.run(with(drive, {"write", "--axis", "0", "--source1", test::positionSource(1)})),
            0);
        QVERIFY(process->waitForFinished());
        QCOMPARE(process->exitCode(), 6);
        const QByteArray said = process->readAllStandardError();
        QVERIFY2(said.startsWith("error: ChangedMeanwhile: "), said.constData());
        QVERIFY2(said.contains("Axes[0]/"), said.constData());
    }

    void monitorEndsCleanlyWhenNobodyReads()
    {
        const Sandbox box;
        const ProgramRun run = box.runProgram("/bin/bash",
            {"-c",
                "set -o pipefail; '" + test::axiscompProgram()
                    + "' monitor --drive demo: --axis X --rate 100 | head -n 2"});
        VERIFY_CODE(run, 0);
        QCOMPARE(run.out.count('\n'), 2);
        QCOMPARE(run.err, QByteArray());
    }

    void aBackupBringsTheOldStateBack()
    {
        const Sandbox box;
        const VirtualDriveProcess drive(box);
        VERIFY_CODE(writeLine(box, drive, {"--persistent"}), 0);
        const ProgramRun backup = box.run(with(drive, {"backup", "-o", "b.json", "--json"}));
        VERIFY_CODE(backup, 0);
        QCOMPARE(backup.json().keys(), (QStringList{"axes", "bytes", "output", "tables"}));
        QCOMPARE(backup.json().value("axes").toInt(), 2);
        const QJsonObject before = box.run(with(drive, {"status", "--axis", "0", "--json"})).json();

        VERIFY_CODE(writeLine(box, drive, {}, "X,T\n0,0.001\n50,0.002\n100,0.004\n"), 0);
        const QJsonObject between =
            box.run(with(drive, {"status", "--axis", "0", "--json"})).json();
        QVERIFY(between.value("table") != before.value("table"));

        const ProgramRun shown = box.run(with(drive, {"restore", "b.json", "--dry-run"}));
        VERIFY_CODE(shown, 0);
        QVERIFY2(shown.out.contains("Plan for axis 0 (X)"), shown.out.constData());
        QVERIFY2(
            !shown.out.contains("Plan for axis 1"), shown.out.constData()); // it has everything
        QVERIFY2(shown.out.endsWith("Nothing was written (--dry-run).\n"), shown.out.constData());
        QCOMPARE(box.run(with(drive, {"status", "--axis", "0", "--json"})).json(), between);

        const ProgramRun restored = box.run(with(drive, {"restore", "b.json", "--json"}));
        VERIFY_CODE(restored, 0);
        QCOMPARE(restored.json().keys(), (QStringList{"files", "input", "plans", "writes"}));
        QCOMPARE(restored.json().value("plans").toArray().size(), 2);
        QCOMPARE(restored.json().value("writes").toArray().size(), 1);
        const QJsonObject after = box.run(with(drive, {"status", "--axis", "0", "--json"})).json();
        QCOMPARE(after.value("table"), before.value("table"));
        QCOMPARE(after.value("sources"), before.value("sources"));
        QCOMPARE(after.value("persistent"), before.value("persistent"));
    }

    void aBackupIsRestoredFromStandardInput()
    {
        const Sandbox box;
        const VirtualDriveProcess drive(box);
        VERIFY_CODE(writeLine(box, drive), 0);
        const ProgramRun backup = box.run(with(drive, {"backup"}));
        VERIFY_CODE(backup, 0);
        VERIFY_CODE(box.run(with(drive, {"delete", "--axis", "0"})), 0);
        const ProgramRun restored = box.run(with(drive, {"restore", "-"}), backup.out);
        VERIFY_CODE(restored, 0);
        QVERIFY2(restored.out.contains("Restored axis 0 (X)"), restored.out.constData());
        const ProgramRun damaged = box.run(with(drive, {"restore", "-"}), "{}");
        VERIFY_CODE(damaged, 3);
        QVERIFY2(damaged.err.contains("standard input"), damaged.err.constData());
    }

    void aRestoreThatFailsInTheMiddleSaysWhatIsWritten()
    {
        const Sandbox box;
        const VirtualDriveProcess drive(box);
        VERIFY_CODE(writeLine(box, drive), 0);
        box.file("y.csv", "Y,E\n0,0.001\n50,0.003\n100,0.001\n");
        VERIFY_CODE(box.run(with(drive,
                        {"write", "--axis", "1", "--data", "y.csv", "--dims", "1", "--source1",
                            test::positionSource(1)})),
            0);
        VERIFY_CODE(box.run(with(drive, {"backup", "-o", "b.json"})), 0);
        // X is uploaded and switched over, then Y is uploaded.
        const VirtualDriveProcess other(box, {"--fault", "stores-wrong=3"});
        const ProgramRun run = box.run(with(other, {"restore", "b.json", "--force", "--json"}));
        VERIFY_CODE(run, 6);
        QVERIFY2(
            run.err.contains("note: what failed has its complete old state"), run.err.constData());
        QVERIFY2(run.err.contains("note: written before the error: X; not written: Y"),
            run.err.constData());
        const QJsonObject context =
            run.json().value("error").toObject().value("context").toObject();
        QCOMPARE(context.value("driveHolds").toString(), "old");
        QCOMPARE(context.value("ofAxis").toVariant().toInt(), 1);
    }

    void aTableThatNoAxisUsesIsPlannedAndRestoredInWords()
    {
        const Sandbox box;
        const VirtualDriveProcess drive(box);
        box.file("t.csv", "X,E\n0,0.001\n50,0.002\n100,0.001\n");
        VERIFY_CODE(box.run({"convert", "t.csv", "t.TAMtbl", "--dims", "1", "--table", "1",
                        "--persistent"}),
            0);
        VERIFY_CODE(
            box.run(with(drive, {"upload", "t.TAMtbl", "--to", "tables/small4.TAMtbl"})), 0);
        const ProgramRun backup = box.run(with(drive, {"backup", "-o", "b.json"}));
        VERIFY_CODE(backup, 0);
        QVERIFY2(backup.out.contains(", 1 table."), backup.out.constData());
        VERIFY_CODE(box.run(with(drive, {"delete", "--slot", "small4"})), 0);
        const ProgramRun shown = box.run(with(drive, {"restore", "b.json", "--dry-run"}));
        VERIFY_CODE(shown, 0);
        QVERIFY2(shown.out.contains("persistent; flash: 1 operation\n"), shown.out.constData());
        const ProgramRun restored = box.run(with(drive, {"restore", "b.json"}));
        VERIFY_CODE(restored, 0);
        QVERIFY2(restored.out.endsWith("Restored Small4, which no axis uses.\n"),
            restored.out.constData());
        const ProgramRun again = box.run(with(drive, {"restore", "b.json"}));
        VERIFY_CODE(again, 0);
        QVERIFY2(again.out.contains("nothing was written"), again.out.constData());
        QVERIFY2(!again.out.contains("Small4"), again.out.constData());
    }

    void aBackupOfAnotherDriveNeedsForce()
    {
        const Sandbox box;
        const VirtualDriveProcess drive(box);
        const VirtualDriveProcess spare(box, {"--name", "Spare"});
        VERIFY_CODE(writeLine(box, drive), 0);
        VERIFY_CODE(box.run(with(drive, {"backup", "-o", "b.json"})), 0);
        const ProgramRun refused = box.run(with(spare, {"restore", "b.json"}));
        VERIFY_CODE(refused, 4);
        QVERIFY2(refused.err.startsWith("error: OtherDrive: "), refused.err.constData());
        VERIFY_CODE(box.run(with(spare, {"restore", "b.json", "--force"})), 0);
        QCOMPARE(box.run(with(spare, {"status", "--axis", "0", "--json"}))
                     .json()
                     .value("dimensions")
                     .toInt(),
            1);
    }

    void aBrokenBackupIsNoValidInput()
    {
        const Sandbox box;
        box.file("b.json", R"({"format": 1)");
        const ProgramRun run = box.run({"restore", "b.json", "--drive", "demo:"});
        VERIFY_CODE(run, 3);
        QVERIFY2(run.err.startsWith("error: InvalidBackup: "), run.err.constData());
    }

    void aDriveThatDoesNotAnswerEndsWithinTheDeadline()
    {
        const Sandbox box;
        const VirtualDriveProcess drive(box, {"--fault", "slow=20000"});
        const ProgramRun run = box.run(with(drive, {"files", "--timeout", "0.2"}));
        VERIFY_CODE(run, 5);
        QVERIFY2(run.err.startsWith("error: Timeout: "), run.err.constData());
    }

    void interruptEndsTheWaitForADrive()
    {
        const Sandbox box;
        const VirtualDriveProcess drive(box, {"--fault", "slow=20000"});
        const auto process =
            box.start(test::axiscompProgram(), with(drive, {"files", "--timeout", "600"}));
        // Only a program that has begun can be stopped cleanly; before that the shell's rule holds.
        QTRY_VERIFY(QFile::exists(QStringLiteral("/proc/%1/task").arg(process->processId()))
            && QDir(QStringLiteral("/proc/%1/task").arg(process->processId()))
                    .entryList(QDir::Dirs | QDir::NoDotAndDotDot)
                    .size()
                > 1);
        ::kill(static_cast<pid_t>(process->processId()), SIGTERM);
        QVERIFY(process->waitForFinished());
        QCOMPARE(process->exitStatus(), QProcess::NormalExit);
        QCOMPARE(process->exitCode(), 130);
    }
};

AXISCOMP_TEST(tst_DriveCommands)

} // namespace tst_drivecommands

#include "tst_drivecommands.moc"
