// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program_run.h"

#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QTest>

namespace tst_writecommand {

using namespace axiscomp;
using test::ProgramRun;
using test::Sandbox;
using test::VirtualDriveProcess;

namespace {

const QByteArray first1D = "X [mm],Error [mm]\n0,0\n40,0.0021\n80,-0.001\n";
const QByteArray second1D = "X [mm],Error [mm]\n0,0\n40,0.0011\n80,-0.003\n";
const QByteArray plane = "X,Y,T\n0,0,0\n50,0,0.001\n0,50,0.002\n50,50,-0.003\n";

const QStringList planKeys{"after", "axis", "before", "changes", "coverage", "deletedSlot", "drive",
    "flashOperations", "flashOperationsLeft", "flashWaitSeconds", "largeCorrections",
    "serialNumber", "slotReason", "tableBytes", "units", "warnings"};

/// A drive, and the files of this test.
struct Fixture {
    Sandbox box;
    VirtualDriveProcess drive;

    explicit Fixture(const QStringList& options = {}) : drive(box, options)
    {
        box.file("first.csv", first1D);
        box.file("second.csv", second1D);
        box.file("plane.csv", plane);
    }

    [[nodiscard]] ProgramRun run(const QStringList& arguments) const
    {
        return box.run(arguments + QStringList{"--drive", drive.url(), "--axis", "0"});
    }
    [[nodiscard]] ProgramRun write(const QString& file, const QStringList& more = {}) const
    {
        return run(QStringList{
                       "write", "--data", file, "--dims", "1", "--source1", test::positionSource(0)}
            + more);
    }
    [[nodiscard]] QJsonObject status() const { return run({"status", "--json"}).json(); }
};

} // namespace

class tst_WriteCommand : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theWholeWriteIsShown()
    {
        const Fixture bench;
        const ProgramRun run = bench.write("first.csv", {"--persistent"});
        VERIFY_CODE(run, 0);
        for (const char* const part : {"Plan for axis 0 (X) of Virtual-1 (serial number 100001)",
                 "what", "on the drive now", "will be written", "Small1: 3 points, X 0 .. 80",
                 "tam://mc/Virtual-1/Axes[0]/Signals/PathPlanner/Position",
                 "Small1, the smallest empty one that is large enough",
                 "3 values from -0.001 mm to +0.0021 mm, 140 bytes",
                 "at the set position 40.0000 the drive will add +0.0021 mm",
                 "1 operation; 8 operations possible now", "  ok      upload the table\n",
                 "  ok      read the table back and compare every byte\n",
                 "  ok      store the table in flash\n", "Written and verified: ",
                 "Backup of the old state  ", "axiscomp activate --drive http://127.0.0.1:"})
            QVERIFY2(run.out.contains(part), (part + ("\n" + run.out)).constData());
        QCOMPARE(run.err,
            QByteArray("warning: Dimension 1 of the table reaches from 0 to 80: 80 % of the travel "
                       "of axis 0, 0 to 100. Beyond the table the drive holds the value of its "
                       "end.\n"));
    }

    void theDocumentHasPlanAndReport()
    {
        const Fixture bench;
        const ProgramRun run = bench.write("first.csv", {"--persistent", "--json"});
        VERIFY_CODE(run, 0);
        QCOMPARE(run.json().keys(), (QStringList{"plan", "report"}));
        const QJsonObject plan = run.json().value("plan").toObject();
        QCOMPARE(plan.keys(), planKeys);
        QCOMPARE(plan.value("slotReason").toString(), "Empty");
        QCOMPARE(plan.value("flashOperations").toInt(), 1);
        QCOMPARE(plan.value("before").toObject().value("slot"), QJsonValue());
        QCOMPARE(plan.value("after").toObject().keys(),
            (QStringList{"crc", "dimensions", "persistent", "slot", "sources"}));
        QCOMPARE(plan.value("after").toObject().value("slot").toString(), "Small1");
        const QJsonObject change = plan.value("changes").toArray().at(0).toObject();
        QCOMPARE(change.keys(), (QStringList{"after", "before", "field"}));
        const QJsonObject report = run.json().value("report").toObject();
        QCOMPARE(report.keys(), (QStringList{"backup", "status"}));
        QVERIFY(QFile::exists(report.value("backup").toString()));
        QJsonObject status = bench.status();
        QCOMPARE(status.take("flash").toObject().value("cycles").toInt(), 1);
        QCOMPARE(report.value("status").toObject(), status);
    }

    void aDamagedRecordStopsFlashUntilTheUserDecides()
    {
        const Fixture bench;
        const ProgramRun first = bench.write("first.csv", {"--persistent", "--json"});
        VERIFY_CODE(first, 0);
        const QString backup = first.json().value("report").toObject().value("backup").toString();
        QFile database(QFileInfo(backup).dir().filePath("../../axiscomp.db"));
        QVERIFY(database.exists());
        QVERIFY(database.resize(0));

        const ProgramRun refused = bench.write("second.csv", {"--persistent"});
        VERIFY_CODE(refused, 7);
        QVERIFY2(
            refused.err.contains("axiscomp status --reset-flash-count"), refused.err.constData());
        const ProgramRun damaged = bench.run({"status"});
        VERIFY_CODE(damaged, 0);
        QVERIFY2(damaged.out.contains("axiscomp.db.damaged-"), damaged.out.constData());
        const QJsonObject flash = bench.status().value("flash").toObject();
        QVERIFY(flash.value("damagedRecord").toString().contains("axiscomp.db.damaged-"));
        QCOMPARE(flash.value("operationsLeft").toInt(), 0);

        VERIFY_CODE(bench.run({"status", "--reset-flash-count"}), 0);
        QVERIFY(bench.status().value("flash").toObject().value("damagedRecord").isNull());
        VERIFY_CODE(bench.write("second.csv", {"--persistent"}), 0);
    }

    void aDatabaseThatCannotBeUsedDoesNotKeepACompensationOn()
    {
        const Fixture bench;
        VERIFY_CODE(bench.write("first.csv"), 0);
        VERIFY_CODE(bench.run({"activate"}), 0);
        const QString database = bench.box.path("state/axiscomp/axiscomp.db");
        for (const char* const ending : {"", "-wal", "-shm"})
            QFile::remove(database + QLatin1String(ending));
        QVERIFY(QDir().mkpath(database));
        const QByteArray unknown = "warning: whether an earlier write did not end is not known: ";
        for (const char* const command : {"status", "read", "deactivate"}) {
            const ProgramRun run = bench.run({QLatin1String(command)});
            VERIFY_CODE(run, 0);
            QVERIFY2(run.err.contains(unknown), run.text().constData());
            QVERIFY2(run.err.contains("axiscomp.db cannot be read"), run.err.constData());
        }
        const QJsonObject status = bench.status();
        QCOMPARE(status.value("state").toString(), "Disabled");
        QVERIFY(status.contains("flash") && status.value("flash").isNull());
        VERIFY_CODE(bench.run({"activate"}), 3);
        VERIFY_CODE(bench.run({"evaluate"}), 3);
        VERIFY_CODE(bench.write("second.csv"), 3);
    }

    void aColumnGoesToTheAxisThatItIsNamedAsAndIsLookedUpByItsPosition()
    {
        const Fixture bench;
        bench.box.file(
            "both.csv", "Position [mm],Y error [mm],X error [mm]\n0,0.001,0.002\n50,0.003,0.004\n");
        const ProgramRun run = bench.box.run({"write", "--data", "both.csv", "--dims", "1", "--map",
            "X", "--map", "Y", "--own-position", "--drive", bench.drive.url(), "--json"});
        VERIFY_CODE(run, 0);
        QCOMPARE(run.json().value("writes").toArray().size(), 2);
        for (const int axis : {0, 1}) {
            const QString number = QString::number(axis);
            const QJsonObject status =
                bench.box.run({"status", "--drive", bench.drive.url(), "--axis", number, "--json"})
                    .json();
            QCOMPARE(status.value("sources").toArray().at(0).toString(),
                "tam://mc/Virtual-1/Axes[" + number
                    + "]/Signals/PositionController/MasterPosition");
        }
        // The column of each is its own.
        const ProgramRun x =
            bench.box.run({"read", "--drive", bench.drive.url(), "--axis", "X", "-o", "x.csv"});
        VERIFY_CODE(x, 0);
        QVERIFY2(
            bench.box.content("x.csv").contains("0.004"), bench.box.content("x.csv").constData());

        const ProgramRun none = bench.box.run({"write", "--data", "both.csv", "--dims", "1",
            "--map", "Z", "--own-position", "--drive", bench.drive.url()});
        VERIFY_CODE(none, 2);
        QVERIFY2(none.err.contains("no column is named as axis Z"), none.err.constData());
    }

    void whereASourceIsMissingWhatTheFileProposesIsSaid()
    {
        const Fixture bench;
        const ProgramRun run = bench.run({"write", "--data", "first.csv", "--dims", "1"});
        VERIFY_CODE(run, 2);
        QVERIFY2(run.err.contains("SourceMissing"), run.err.constData());
        QVERIFY2(run.err.contains("note: the file proposes --source1 "
                                  "'Axes[0]/Signals/PositionController/MasterPosition'\n"),
            run.err.constData());
        QVERIFY(bench.status().value("slot").isNull()); // a proposal is not written
    }

    void aDryRunChangesNothing()
    {
        const Fixture bench;
        const QJsonObject before = bench.status();
        const ProgramRun run = bench.write("first.csv", {"--dry-run", "--json"});
        VERIFY_CODE(run, 0);
        QVERIFY(run.json().value("report").isNull());
        QVERIFY(!run.json().value("plan").toObject().value("changes").toArray().isEmpty());
        QCOMPARE(bench.status(), before);
        const ProgramRun text = bench.write("first.csv", {"--dry-run"});
        QVERIFY2(text.out.endsWith("Nothing was written (--dry-run).\n"), text.out.constData());
        QVERIFY(!text.out.contains("  ok "));
    }

    void writingTheSameAgainIsDoneAtOnce()
    {
        const Fixture bench;
        VERIFY_CODE(bench.write("first.csv", {"--persistent"}), 0);
        const QJsonObject before = bench.status();
        const ProgramRun again = bench.write("first.csv", {"--persistent"});
        VERIFY_CODE(again, 0);
        QVERIFY2(again.out.contains("Nothing had to be written."), again.out.constData());
        const ProgramRun json = bench.write("first.csv", {"--persistent", "--json"});
        VERIFY_CODE(json, 0);
        QVERIFY(json.json().value("report").isNull());
        QCOMPARE(bench.status(), before);
    }

    void slotsAreTakenInTurn()
    {
        const Fixture bench;
        VERIFY_CODE(bench.write("first.csv"), 0);
        QCOMPARE(bench.status().value("slot").toString(), "Small1");
        VERIFY_CODE(bench.write("second.csv"), 0);
        QCOMPARE(bench.status().value("slot").toString(), "Small2");
        const ProgramRun third = bench.write("first.csv");
        VERIFY_CODE(third, 0);
        QVERIFY2(third.out.contains("Small1, which holds a table that this axis used before"),
            third.out.constData());
        QCOMPARE(bench.status().value("slot").toString(), "Small1");
    }

    void aSlotCanBeNamed_data()
    {
        QTest::addColumn<QString>("slot");
        QTest::addColumn<int>("code");
        QTest::addColumn<QString>("used");
        QTest::newRow("name") << "Large1" << 0 << "Large1";
        QTest::newRow("small letters") << "small3" << 0 << "Small3";
        QTest::newRow("path") << "tables/small4.TAMtbl" << 0 << "Small4";
        QTest::newRow("unknown") << "small9" << 2 << "";
    }
    void aSlotCanBeNamed()
    {
        QFETCH(const QString, slot);
        QFETCH(const int, code);
        const Fixture bench;
        const ProgramRun run = bench.write("first.csv", {"--slot", slot});
        VERIFY_CODE(run, code);
        QTEST(bench.status().value("slot").toString(), "used");
        if (code != 0)
            QVERIFY2(run.err.startsWith("error: SlotNotFound: "), run.err.constData());
        QVERIFY2(!run.err.contains("is overwritten"), run.err.constData()); // nothing was in it
    }

    void aTableFileNeedsNoDimensions()
    {
        const Fixture bench;
        VERIFY_CODE(bench.box.run({"convert", "plane.csv", "p.TAMtbl", "--dims", "2"}), 0);
        const ProgramRun run = bench.run({"write", "--data", "p.TAMtbl", "--source1",
            test::positionSource(0), "--source2", test::positionSource(1)});
        VERIFY_CODE(run, 0);
        QCOMPARE(bench.status().value("dimensions").toInt(), 2);
        QCOMPARE(bench.status().value("sources").toArray().size(), 2);
    }

    void sourcesAreKeptUnlessGiven()
    {
        const Fixture bench;
        VERIFY_CODE(bench.write("first.csv"), 0);
        const QJsonValue sources = bench.status().value("sources");
        VERIFY_CODE(bench.run({"write", "--data", "second.csv", "--dims", "1"}), 0);
        QCOMPARE(bench.status().value("sources"), sources);
        VERIFY_CODE(bench.run({"write", "--source1", "Axes[1].Signals.PathPlanner.Position"}), 0);
        QCOMPARE(bench.status().value("sources").toArray().at(0).toString(),
            "tam://mc/Virtual-1/Axes[1]/Signals/PathPlanner/Position");
    }

    void wrongSourcesAreNamed_data()
    {
        QTest::addColumn<QStringList>("sources");
        QTest::addColumn<QByteArray>("error");
        QTest::addColumn<QByteArray>("part");
        QTest::newRow("missing") << QStringList{} << QByteArray("error: SourceMissing: ")
                                 << QByteArray("dimension 1");
        QTest::newRow("gap") << QStringList{"--source2", test::positionSource(0)}
                             << QByteArray("error: SourceMissing: ") << QByteArray("dimension 1");
        QTest::newRow("surplus") << QStringList{"--source1", test::positionSource(0), "--source2",
            test::positionSource(1)}
                                 << QByteArray("error: SourceSurplus: ")
                                 << QByteArray("dimension 2");
        QTest::newRow("misspelt") << QStringList{"--source1", "Axes[0]/Signals/PathPlaner/Position"}
                                  << QByteArray("error: SourceNotFound: ")
                                  << QByteArray("PathPlanner/Position");
        QTest::newRow("no number")
            << QStringList{"--source1", "Axes[0]/Signals/Homing/State"}
            << QByteArray("error: SourceWrongType: ") << QByteArray("Single");
        QTest::newRow("other drive")
            << QStringList{"--source1", "tam://mc/Other/Axes[0]/Signals/PathPlanner/Position"}
            << QByteArray("error: SourceOtherDrive: ") << QByteArray("Other");
    }
    void wrongSourcesAreNamed()
    {
        QFETCH(const QStringList, sources);
        QFETCH(const QByteArray, error);
        QFETCH(const QByteArray, part);
        const Fixture bench;
        const QJsonObject before = bench.status();
        const ProgramRun run =
            bench.run(QStringList{"write", "--data", "first.csv", "--dims", "1"} + sources);
        VERIFY_CODE(run, 2);
        // Of a missing source a note before it says what the file proposes.
        QVERIFY2(run.err.startsWith(error) || run.err.contains('\n' + error), run.err.constData());
        QVERIFY2(run.err.contains(part), run.err.constData());
        QCOMPARE(bench.status(), before);
    }

    void aBadFileIsRefusedBeforeTheDriveIsAsked()
    {
        const Sandbox box;
        box.file("bad.csv", "X,T\n0,0\n1,x\n");
        const ProgramRun run = box.run({"write", "--drive", "http://127.0.0.1:1", "--data",
            "bad.csv", "--dims", "1", "--json"});
        VERIFY_CODE(run, 3);
        QVERIFY2(run.err.startsWith("bad.csv:3:2: error: "), run.err.constData());
        const QJsonObject error = run.json().value("error").toObject();
        QCOMPARE(error.keys(), (QStringList{"code", "context", "diagnostics", "message"}));
        QCOMPARE(error.value("code").toString(), "InvalidCalibration");
        const QJsonObject diagnostic = error.value("diagnostics").toArray().at(0).toObject();
        QCOMPARE(diagnostic.keys(), (QStringList{"code", "column", "file", "line", "message"}));
    }

    void aTableThatFitsNoSlotNamesItsSize()
    {
        const Fixture bench;
        QByteArray csv = "X,Y,T\n";
        for (int y = 0; y < 800; ++y)
            for (int x = 0; x < 800; ++x)
                csv += QByteArray::number(x) + ',' + QByteArray::number(y) + ",0."
                    + (x == 0 && y == 0 ? "0001\n" : "0\n");
        bench.box.file("huge.csv", csv);
        const ProgramRun run = bench.run({"write", "--data", "huge.csv", "--dims", "2", "--source1",
            test::positionSource(0), "--source2", test::positionSource(1)});
        VERIFY_CODE(run, 4);
        QVERIFY2(run.err.contains("error: TableTooLarge: "), run.err.constData());
        QVERIFY2(run.err.contains("2560128"), run.err.constData());
        QVERIFY2(run.err.contains("2096976"), run.err.constData());
    }

    void micrometresOverMetresAreConvertedForAnAxisInMillimetres()
    {
        const Fixture bench;
        bench.box.file("um.csv", "X [m],T [um]\n0,0\n0.04,2.1\n0.08,-1\n");
        const ProgramRun plan = bench.write("um.csv", {"--dry-run"});
        VERIFY_CODE(plan, 0);
        for (const char* const part :
            {"3 values from -0.001 mm to +0.0021 mm", "X 0 .. 80", "the drive will add +0.0021 mm"})
            QVERIFY2(plan.out.contains(part), (part + ("\n" + plan.out)).constData());
        for (const char* const part :
            {"note: The values are converted from um to mm. The largest correction is 0.0021 mm.",
                "note: The positions of dimension 1 are converted from m to mm: 0 mm to 80 mm."})
            QVERIFY2(plan.err.contains(part), (part + ("\n" + plan.err)).constData());
        VERIFY_CODE(bench.write("um.csv"), 0);
        VERIFY_CODE(bench.run({"read", "-o", "um.TAMtbl"}), 0);
        VERIFY_CODE(bench.write("first.csv"), 0);
        VERIFY_CODE(bench.run({"read", "-o", "mm.TAMtbl"}), 0);
        // The same elements; what precedes them says when the table was made.
        QCOMPARE(bench.box.content("um.TAMtbl").last(3 * 4).toHex(),
            bench.box.content("mm.TAMtbl").last(3 * 4).toHex());
    }

    void theUnitThatIsStatedCountsMoreThanTheFiles()
    {
        const Fixture bench;
        bench.box.file("um.csv", "X [m],T [um]\n0,0\n0.04,2.1\n0.08,-1\n");
        const ProgramRun nanometres =
            bench.write("um.csv", {"--dry-run", "--value-unit", "nm", "--position-unit", "drive"});
        VERIFY_CODE(nanometres, 0);
        QVERIFY2(nanometres.out.contains("X 0 .. 0.08"), nanometres.out.constData());
        QVERIFY2(nanometres.err.contains("converted from nm to mm. The largest correction is "),
            nanometres.err.constData());
        QVERIFY2(nanometres.err.contains("they are taken to be in mm: 0 mm to 0.08 mm"),
            nanometres.err.constData());
        const ProgramRun asItStands = bench.write("um.csv", {"--dry-run", "--value-unit", "drive"});
        VERIFY_CODE(asItStands, 0);
        QVERIFY2(asItStands.out.contains("from -1 mm to +2.1 mm"), asItStands.out.constData());
    }

    /// 5.5 um over 100 mm are no mistake of units.
    void theUnitsThatAreStatedCountForTheWarningsOfTheFile()
    {
        const Fixture bench;
        bench.box.file("x.csv", "X,T\n0,1.5\n0.1,-2.5\n0.2,3\n");
        const QByteArray steep = "the table is very steep";
        QVERIFY(bench.write("x.csv", {"--dry-run"}).err.contains(steep));
        const ProgramRun stated =
            bench.write("x.csv", {"--dry-run", "--value-unit", "um", "--position-unit", "m"});
        VERIFY_CODE(stated, 0);
        QVERIFY2(!stated.err.contains(steep), stated.err.constData());
        const ProgramRun set = bench.write(
            "x.csv", {"--dry-run", "--set-in", "value-unit=um", "--set-in", "position-unit=m"});
        VERIFY_CODE(set, 0);
        QVERIFY2(!set.err.contains(steep), set.err.constData());
    }

    void anAngleForALengthIsRefused()
    {
        const Fixture bench;
        bench.box.file("values.csv", "X [mm],T [mrad]\n0,0\n40,0.5\n80,1\n");
        bench.box.file("positions.csv", "X [deg],T [mm]\n0,0\n40,0.5\n80,1\n");
        bench.box.file("counts.csv", "X [mm],T [counts]\n0,0\n40,5\n80,1\n");
        const std::initializer_list<std::pair<const char*, const char*>> refused{
            {"values.csv", "the values are in mrad, which cannot be converted to mm"},
            {"positions.csv", "the positions of dimension 1 are in deg, which cannot be"},
            {"counts.csv", "the values are in counts, which cannot be converted to mm"}};
        for (const auto& [file, sentence] : refused) {
            const ProgramRun run = bench.write(file);
            VERIFY_CODE(run, 2);
            QVERIFY2(run.err.contains("error: UnitMismatch: "), run.err.constData());
            QVERIFY2(run.err.contains(sentence), run.err.constData());
        }
        VERIFY_CODE(bench.write("counts.csv", {"--value-unit", "um"}), 0);
    }

    void aLargeCorrectionHasToBeConfirmed()
    {
        const Fixture bench;
        bench.box.file("large.csv", "X [mm],T [mm]\n0,0\n40,2.1\n80,-1\n");
        const ProgramRun plan = bench.write("large.csv", {"--dry-run", "--json"});
        VERIFY_CODE(plan, 0);
        QCOMPARE(plan.json().value("plan").toObject().value("largeCorrections").toArray().at(0),
            QJsonValue("The largest correction, 2.1 mm, is 2.625 % of the range of dimension 1, "
                       "80 mm."));
        QVERIFY2(plan.err.contains("needs --accept-large"), plan.err.constData());
        const QJsonObject before = bench.status();
        const ProgramRun refused = bench.write("large.csv");
        VERIFY_CODE(refused, 2);
        QVERIFY2(
            refused.err.contains("error: LargeCorrection: The largest correction, 2.1 mm, is "),
            refused.err.constData());
        QCOMPARE(bench.status(), before);
        const ProgramRun accepted = bench.write("large.csv", {"--accept-large"});
        VERIFY_CODE(accepted, 0);
        QVERIFY2(!accepted.err.contains("--accept-large"), accepted.err.constData());
    }

    void ofSeveralWritesNoneBeginsWhenOneIsLarge()
    {
        const Fixture bench;
        bench.box.file("two.csv", "X [mm],A [mm],B [mm]\n0,0,0\n40,0.001,2.1\n80,0,-1\n");
        const QStringList command{"write", "--data", "two.csv", "--dims", "1", "--source1",
            test::positionSource(0), "--map", "A=0", "--map", "B=1", "--drive", bench.drive.url()};
        const QJsonObject before = bench.status();
        const ProgramRun refused = bench.box.run(command);
        VERIFY_CODE(refused, 2);
        QVERIFY2(refused.err.contains("error: LargeCorrection: "), refused.err.constData());
        QCOMPARE(bench.status(), before);
        VERIFY_CODE(bench.box.run(command + QStringList{"--accept-large"}), 0);
    }

    void ofSeveralTargetsEachIsOfTheMapAtItsPlace()
    {
        const Fixture bench;
        bench.box.file("two.csv", "X [mm],A [mm],B [mm]\n0,0,0\n40,0.001,0.002\n80,0,0.001\n");
        const QStringList command{"write", "--data", "two.csv", "--dims", "1", "--source1",
            test::positionSource(0), "--map", "A=0", "--map", "B=1", "--drive", bench.drive.url(),
            "--target"};
        const ProgramRun three = bench.box.run(command + QStringList{"#1,other,other"});
        VERIFY_CODE(three, 2);
        QVERIFY2(three.err.contains("states 3 targets for 2 --map"), three.err.constData());
        const ProgramRun turned = bench.box.run(command + QStringList{"other,#1"});
        VERIFY_CODE(turned, 2);
        QVERIFY2(turned.err.contains("error: TargetMismatch: "), turned.err.constData());
        VERIFY_CODE(bench.box.run(command + QStringList{"#1,other"}), 0);
    }

    void theOwnSlotThatWasNamedIsNotCalledTheOnlyOne()
    {
        const Fixture bench;
        VERIFY_CODE(bench.write("first.csv"), 0);
        const ProgramRun run = bench.write("second.csv", {"--slot", "small1"});
        VERIFY_CODE(run, 0);
        QVERIFY2(!run.err.contains("No other slot is free"), run.err.constData());
        QVERIFY2(run.err.contains("warning: What Small1 holds now is overwritten."),
            run.err.constData());
    }

    void withoutAFileTheOwnPositionIsTheNewSourceOfTheTable()
    {
        const Fixture bench;
        VERIFY_CODE(
            bench.run({"write", "--data", "first.csv", "--dims", "1", "--own-position"}), 0);
        const QJsonValue own = bench.status().value("sources");
        VERIFY_CODE(bench.run({"write", "--source1", test::positionSource(1)}), 0);
        QVERIFY(bench.status().value("sources") != own);
        VERIFY_CODE(bench.run({"write", "--own-position"}), 0);
        QCOMPARE(bench.status().value("sources"), own);
    }

    void theOwnPositionIsTheSourceOfAFileWhoseTargetTheAxisSays()
    {
        const Fixture bench;
        bench.box.file("open.csv",
            "# RapidCode compensator table, the first axis fastest\n# input.1.axis = X\n"
            "# input.1.unit = mm\n# input.1.min = 0\n# input.1.max = 20\n# input.1.delta = 10\n"
            "# output.unit = mm\n# output.counts-per-unit = 1000\n-1,-2,-3\n");
        const ProgramRun run = bench.run({"write", "--data", "open.csv", "--own-position"});
        VERIFY_CODE(run, 0);
        QVERIFY2(run.out.contains("the drive will add +0.003 mm"), run.out.constData());
    }

    void theTargetOfTheDriveIsNoStatementAboutAColumn()
    {
        const Fixture bench;
        bench.box.file("y.csv", "Y [mm],Error [mm]\n0,0\n10,0.003\n20,0\n");
        const QStringList write{"write", "--data", "y.csv", "--dims", "1", "--from", "csv",
            "--own-position", "--sign", "command"};
        const ProgramRun refused = bench.run(write);
        VERIFY_CODE(refused, 2);
        QVERIFY2(refused.err.contains("Column Y of the file is not named as axis X"),
            refused.err.constData());
        VERIFY_CODE(bench.run(write + QStringList{"--target", "#1"}), 0);
    }

    void withoutAFileWhatIsAboutTheTableIsRefused_data()
    {
        QTest::addColumn<QStringList>("option");
        for (const QStringList& option : {QStringList{"--value-unit", "um"},
                 QStringList{"--table", "X"}, QStringList{"--target", "X"},
                 QStringList{"--points", "11"}, QStringList{"--fill", "nearest"},
                 QStringList{"--from", "csv"}, QStringList{"--slot", "small1"}})
            QTest::addRow("%s", qPrintable(option.front())) << option;
    }
    void withoutAFileWhatIsAboutTheTableIsRefused()
    {
        QFETCH(const QStringList, option);
        const Sandbox box;
        const ProgramRun run =
            box.run(QStringList{"write", "--drive", "http://127.0.0.1:1", "--persistent"} + option);
        VERIFY_CODE(run, 2);
        QVERIFY2(run.err.contains("give --data FILE"), run.err.constData());
    }

    void aTableWithoutUnitsIsShownWithItsLargestCorrection()
    {
        const Fixture bench;
        bench.box.file("none.csv", "X,T\n0,0\n1000,0.5\n2000,0.8\n");
        const ProgramRun run = bench.write("none.csv", {"--dry-run", "--json"});
        VERIFY_CODE(run, 0);
        QVERIFY2(run.err.contains("taken to be in mm. The largest correction is 0.8 mm."),
            run.err.constData());
        QCOMPARE(run.json().value("plan").toObject().value("units").toArray().size(), 1);
    }

    void anActiveAxisIsNotWritten()
    {
        const Fixture bench;
        VERIFY_CODE(bench.write("first.csv"), 0);
        VERIFY_CODE(bench.run({"activate"}), 0);
        const QJsonValue table = bench.status().value("table");
        const ProgramRun run = bench.write("second.csv");
        VERIFY_CODE(run, 4);
        QVERIFY2(run.err.startsWith("error: CompensationActive: "), run.err.constData());
        QCOMPARE(bench.status().value("table"), table);
        const ProgramRun same = bench.write("first.csv");
        VERIFY_CODE(same, 0);
        QVERIFY2(same.out.contains("Nothing had to be written"), same.out.constData());
    }

    void persistencyIsChangedBothWays()
    {
        const Fixture bench;
        VERIFY_CODE(bench.write("first.csv"), 0);
        QCOMPARE(bench.status().value("persistent").toBool(true), false);
        const ProgramRun persisted = bench.run({"persist", "--json"});
        VERIFY_CODE(persisted, 0);
        QCOMPARE(persisted.json().keys(), (QStringList{"plan", "report"}));
        QCOMPARE(bench.status().value("persistent").toBool(), true);
        VERIFY_CODE(bench.run({"unpersist"}), 0);
        QCOMPARE(bench.status().value("persistent").toBool(true), false);
    }

    void persistencyNeedsATable()
    {
        const Fixture bench;
        const ProgramRun run = bench.run({"persist"});
        VERIFY_CODE(run, 4);
        QVERIFY2(run.err.startsWith("error: NoTable: "), run.err.constData());
    }

    void wornFlashIsRefusedBeforehandAndTheLastOperationKeptForPuttingBack()
    {
        const Fixture bench;
        VERIFY_CODE(bench.write("first.csv"), 0);
        ProgramRun run;
        int operations = 0;
        for (; operations <= 8; ++operations) {
            run = bench.run({operations % 2 == 0 ? "persist" : "unpersist"});
            if (run.code != 0)
                break;
        }
        QCOMPARE(operations, 7);
        VERIFY_CODE(run, 7);
        QVERIFY2(run.err.startsWith("error: FlashWear: "), run.err.constData());
        QVERIFY2(run.err.contains("not for putting everything back"), run.err.constData());
        QVERIFY2(bench.run({"status"}).out.contains("1 operation possible now"), "none is left");
        // What takes another slot is put back without flash.
        VERIFY_CODE(bench.write("second.csv", {"--persistent"}), 0);
        run = bench.run({"unpersist"});
        VERIFY_CODE(run, 7);
        QVERIFY2(run.err.startsWith("error: FlashWear: "), run.err.constData());
        QVERIFY2(!run.err.contains("putting everything back"), run.err.constData());
        QVERIFY2(bench.run({"status"}).out.contains("none possible for "), "no waiting time");
    }

    void whatWasStoredWronglyIsFoundAndPutBack()
    {
        const Fixture bench({"--fault", "stores-wrong=1"});
        const ProgramRun run = bench.write("first.csv", {"--json"});
        VERIFY_CODE(run, 6);
        QVERIFY2(run.err.contains("error: VerifyMismatch: "), run.err.constData());
        QVERIFY2(
            run.err.contains("note: the drive holds the complete old state"), run.err.constData());
        const QJsonObject context =
            run.json().value("error").toObject().value("context").toObject();
        QCOMPARE(context.value("driveHolds").toString(), "old");
        QVERIFY(bench.status().value("table").isNull());
    }

    void anAxisThatFailsAfterAnotherSaysWhichIsWritten()
    {
        // X is uploaded and switched over, then Y is uploaded.
        const Fixture bench({"--fault", "stores-wrong=3"});
        bench.box.file(
            "both.csv", "Position [mm],Y error [mm],X error [mm]\n0,0.001,0.002\n50,0.003,0.004\n");
        const ProgramRun run = bench.box.run({"write", "--data", "both.csv", "--dims", "1", "--map",
            "X", "--map", "Y", "--own-position", "--drive", bench.drive.url(), "--json"});
        VERIFY_CODE(run, 6);
        QVERIFY2(!run.err.contains("the drive holds the complete old state"), run.err.constData());
        QVERIFY2(
            run.err.contains("note: what failed has its complete old state"), run.err.constData());
        QVERIFY2(run.err.contains("note: written before the error: "), run.err.constData());
        const QJsonObject context =
            run.json().value("error").toObject().value("context").toObject();
        QCOMPARE(context.value("driveHolds").toString(), "old");
        QVERIFY(!bench.status().value("table").isNull());
    }

    void whatTheDriveRefusesIsPutBack()
    {
        const Fixture bench({"--fault", "reject=TableRefused"});
        const ProgramRun run = bench.write("first.csv");
        VERIFY_CODE(run, 4);
        QVERIFY2(run.out.contains("  failed  upload the table\n"), run.out.constData());
        QVERIFY(bench.status().value("table").isNull());
    }

    void theDemoIsANewDriveEachTime()
    {
        const Sandbox box;
        box.file("y.csv", QByteArray(first1D).replace("X [mm]", "Y [mm]"));
        for (int i = 0; i < 10; ++i) {
            const ProgramRun run = box.run({"write", "--drive", "demo:", "--axis", "Y", "--data",
                "y.csv", "--dims", "1", "--source1", test::positionSource(1), "--persistent"});
            VERIFY_CODE(run, 0);
        }
        QVERIFY(!QFile::exists(box.path("state/axiscomp")));
    }
};

AXISCOMP_TEST(tst_WriteCommand)

} // namespace tst_writecommand

#include "tst_writecommand.moc"
