// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program_run.h"

#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QFile>
#include <QJsonArray>
#include <QTest>

namespace tst_configcommand {

using namespace axiscomp;
using test::ProgramRun;
using test::Sandbox;
using test::VirtualDriveProcess;

namespace {

QByteArray twoDrives()
{
    QFile file(QStringLiteral(AXISCOMP_SOURCE_FOLDER "/tests/data/tamcfg/two-drives.TAMcfg"));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// The drives of a configuration, and a table for the axis Y of the first.
struct Bench {
    Bench()
    {
        box.file("line.csv", "Y [mm],Error [mm]\n0,0\n50,0.002\n100,-0.003\n");
        const ProgramRun written = run({"write", "--axis", "1", "--data", "line.csv", "--dims", "1",
            "--source1", test::positionSource(1), "--persistent"});
        QVERIFY2(written.code == 0, written.text());
    }
    [[nodiscard]] ProgramRun run(const QStringList& arguments, int drive = 0) const
    {
        return box.run(arguments + QStringList{"--drive", drives.url(drive)});
    }
    [[nodiscard]] QString slotOfY() const
    {
        return run({"status", "--axis", "1", "--json"}).json().value("slot").toString();
    }

    Sandbox box;
    QString file = box.file("machine.TAMcfg", twoDrives());
    VirtualDriveProcess drives{box, {"--config", file}};
};

} // namespace

class tst_ConfigCommand : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void showsTheStationsWithoutADrive()
    {
        const Sandbox box;
        box.file("machine.TAMcfg", twoDrives());
        const ProgramRun text = box.run({"config", "show", "machine.TAMcfg"});
        VERIFY_CODE(text, 0);
        QVERIFY(text.out.contains("Gantry, serial number 2207"));
        QVERIFY(text.out.contains("Small4"));
        const ProgramRun run = box.run({"config", "show", "machine.TAMcfg", "--json"});
        VERIFY_CODE(run, 0);
        const QJsonArray stations = run.json().value("stations").toArray();
        QCOMPARE(stations.size(), 2);
        const QJsonObject gantry = stations.at(0).toObject();
        QCOMPARE(gantry.keys(), (QStringList{"axes", "name", "serialNumber"}));
        const QJsonObject x = gantry.value("axes").toArray().at(0).toObject();
        QCOMPARE(x.keys(), (QStringList{"axis", "slot", "sources", "unit"}));
        QCOMPARE(x.value("slot").toString(), "Small4");
        VERIFY_CODE(box.run({"config", "show", "missing.TAMcfg"}), 3);
        box.file("bad.TAMcfg", "<TamTopology>\n<TamStation>\n");
        const ProgramRun bad = box.run({"config", "show", "bad.TAMcfg"});
        VERIFY_CODE(bad, 3);
        QVERIFY2(bad.err.contains("bad.TAMcfg is wrong in line 3"), bad.err.constData());
    }

    void whatADriveHasGoesToAFileAndBack()
    {
        const Bench bench;
        QVERIFY(bench.drives.isReady());
        const QString slot = bench.slotOfY();
        QVERIFY(!slot.isEmpty());
        const ProgramRun dry = bench.run({"config", "export", "machine.TAMcfg", "--dry-run"});
        VERIFY_CODE(dry, 0);
        QCOMPARE(bench.box.content("machine.TAMcfg"), twoDrives());
        const ProgramRun exported =
            bench.run({"config", "export", "machine.TAMcfg", "-o", "new.TAMcfg", "--json"});
        VERIFY_CODE(exported, 0);
        QVERIFY(exported.json().value("written").toBool());
        QCOMPARE(bench.box.content("machine.TAMcfg"), twoDrives());
        const QByteArray after = bench.box.content("new.TAMcfg");
        QCOMPARE(after.count('\n'), twoDrives().count('\n'));
        const QList<QByteArray> oldLines = twoDrives().split('\n');
        const QList<QByteArray> newLines = after.split('\n');
        int changed = 0;
        for (qsizetype n = 0; n < oldLines.size(); ++n) {
            if (oldLines[n] == newLines[n])
                continue;
            ++changed;
            QVERIFY(oldLines[n].contains("Axes[1]/Parameters/Compensations/Axis/"));
        }
        QCOMPARE(changed, 2); // Table and Dim1Source

        // The old configuration takes the table away from the axis, the new one gives it back.
        VERIFY_CODE(bench.run({"config", "import", "machine.TAMcfg"}), 0);
        QVERIFY(bench.slotOfY().isEmpty());
        const ProgramRun plan =
            bench.run({"config", "import", "new.TAMcfg", "--dry-run", "--json"});
        VERIFY_CODE(plan, 0);
        QCOMPARE(plan.json().value("writes").toArray().size(), 1);
        QVERIFY(bench.slotOfY().isEmpty());
        VERIFY_CODE(bench.run({"config", "import", "new.TAMcfg"}), 0);
        QCOMPARE(bench.slotOfY(), slot);
        const ProgramRun again = bench.run({"config", "import", "new.TAMcfg"});
        VERIFY_CODE(again, 0);
        QVERIFY(again.out.contains("The drive already has all of this."));
    }

    void aTableThatIsNotOnTheDriveIsSaid()
    {
        const Bench bench;
        QVERIFY(bench.drives.isReady());
        QByteArray text = twoDrives();
        text.replace("Axes[1]/Parameters/Compensations/Axis/Table\" Type=\"SourceTable\" "
                     "Value=\"Disabled\"",
            "Axes[1]/Parameters/Compensations/Axis/Table\" Type=\"SourceTable\" Value=\"Small7\"");
        bench.box.file("other.TAMcfg", text);
        const ProgramRun run = bench.run({"config", "import", "other.TAMcfg"});
        VERIFY_CODE(run, 4);
        QVERIFY2(run.err.contains("names the table in Small7 for axis 1"), run.err.constData());
        QVERIFY(!bench.slotOfY().isEmpty());
    }

    void theStationIsThatOfTheDrive()
    {
        const Bench bench;
        QVERIFY(bench.drives.isReady());
        const ProgramRun other =
            bench.run({"config", "import", "machine.TAMcfg", "--station", "Gantry"}, 1);
        VERIFY_CODE(other, 4);
        QVERIFY2(other.err.startsWith("error: OtherDrive"), other.err.constData());
        VERIFY_CODE(bench.run({"config", "import", "machine.TAMcfg"}, 1), 0);
    }

    void parametersGoFromFileToFile()
    {
        const Bench bench;
        QVERIFY(bench.drives.isReady());
        VERIFY_CODE(bench.run({"config", "export", "machine.TAMcfg", "-o", "new.TAMcfg"}), 0);
        const ProgramRun copied = bench.box.run(
            {"config", "export", "machine.TAMcfg", "--from", "new.TAMcfg", "--station", "Gantry"});
        VERIFY_CODE(copied, 0);
        QVERIFY(copied.out.contains("Wrote machine.TAMcfg: only these registers have changed."));
        QCOMPARE(bench.box.content("machine.TAMcfg"), bench.box.content("new.TAMcfg"));
        const ProgramRun same = bench.box.run({"config", "export", "machine.TAMcfg", "--from",
            "new.TAMcfg", "--station", "Gantry", "-o", "same.TAMcfg"});
        VERIFY_CODE(same, 0);
        QVERIFY2(same.out.contains("Wrote same.TAMcfg, the same: the configuration has all"),
            same.text().constData());
        QCOMPARE(bench.box.content("same.TAMcfg"), bench.box.content("machine.TAMcfg"));
    }
};

AXISCOMP_TEST(tst_ConfigCommand)

} // namespace tst_configcommand

#include "tst_configcommand.moc"
