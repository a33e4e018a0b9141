// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/record/calibration_record.h"
#include "tests/app/program_run.h"
#include "tests/support/file_content.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QJsonArray>
#include <QTest>

namespace tst_recordonadrive {

using namespace axiscomp;
using test::ProgramRun;
using test::Sandbox;
using test::VirtualDriveProcess;

namespace {

/// A record with a table, as `axiscomp fit --record` leaves it, and a drive.
struct Fixture {
    Sandbox box;
    VirtualDriveProcess drive;

    explicit Fixture(std::optional<LookupAt> lookupAt = {}) : drive(box)
    {
        CalibrationRecord record;
        if (lookupAt) {
            record.fit.emplace();
            record.fit->settings.lookupAt = lookupAt;
        }
        record.program = "axiscomp 0.1";
        RecordedTable table;
        table.table.name = "dX";
        table.table.target = "X";
        table.table.unit = "mm";
        table.table.grid.axes = {{"X", "mm", 0.0, 40.0, 3}};
        table.table.values = {0.0F, 0.0021F, -0.001F};
        table.crc = tableCrc(table.table);
        record.tables = {table};
        box.file("job.axcal", QByteArray::fromStdString(recordText(record)));
    }

    [[nodiscard]] ProgramRun run(const QStringList& arguments, const QString& axis = "0") const
    {
        return box.run(arguments + QStringList{"--drive", drive.url(), "--axis", axis});
    }
    [[nodiscard]] ProgramRun write(const QStringList& more = {}, const QString& axis = "0") const
    {
        return run(
            QStringList{"write", "--record", "job.axcal", "--source1", test::positionSource(0)}
                + more,
            axis);
    }
    [[nodiscard]] QByteArray text() const
    {
        return QByteArray::fromStdString(test::contentOf(box.path("job.axcal").toStdString()));
    }
    [[nodiscard]] CalibrationRecord record() const
    {
        auto loaded = loadRecord(box.path("job.axcal").toStdString());
        return loaded ? *std::move(loaded) : CalibrationRecord{};
    }
};

} // namespace

class tst_RecordOnADrive : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aRecordNotesWhereItsTableIsAndThatItIsProved()
    {
        const Fixture bench;
        VERIFY_CODE(bench.write({"--persistent"}), 0);
        CalibrationRecord record = bench.record();
        QVERIFY(record.drive && record.write);
        QCOMPARE(record.drive->serialNumber, 100001);
        QCOMPARE(record.drive->profile, std::string("generic"));
        QCOMPARE(record.drive->axisName, std::string("X"));
        QCOMPARE(record.write->slot, std::string("Small1"));
        QVERIFY(record.write->isPersistent);
        QCOMPARE(record.write->crc, record.tables.front().crc);
        QVERIFY(!record.write->proof);

        VERIFY_CODE(bench.run({"activate", "--record", "job.axcal"}), 0);
        record = bench.record();
        QVERIFY(record.write->proof && record.write->proof->isProved);
        QVERIFY(record.write->proof->samples > 0);
        QVERIFY(record.write->proof->provedShare > 0.0);
    }

    /// As it would be by a thousand times what the record has.
    void aTableInAnotherUnitIsNotActivatedByItsRecord()
    {
        const Fixture bench;
        VERIFY_CODE(bench.write(), 0);
        QVERIFY(bench.record().write->units == (TableUnits{"mm", {"mm"}}));
        const QByteArray before = bench.text();
        const std::string unit = "Axes[0]/Parameters/PositionController/PositionUnit";
        QVERIFY(bench.drive.writeRegister(unit, std::string("Meter")));
        const ProgramRun run = bench.run({"activate", "--record", "job.axcal"});
        VERIFY_CODE(run, 2);
        QVERIFY2(run.err.contains("error: UnitMismatch: the values of the record's table were in "
                                  "mm when it was written, and the drive has them in m now"),
            run.err.constData());
        QVERIFY2(!run.out.contains("Proof"), run.out.constData());
        QCOMPARE(bench.text(), before);
        QCOMPARE(bench.run({"status", "--json"}).json().value("state").toString(), "Disabled");
        // Both ways out that the sentence names.
        QVERIFY(bench.drive.writeRegister(unit, std::string("Millimeter")));
        VERIFY_CODE(bench.run({"activate", "--record", "job.axcal"}), 0);
        VERIFY_CODE(bench.run({"deactivate"}), 0);
        QVERIFY(bench.drive.writeRegister(unit, std::string("Meter")));
        VERIFY_CODE(bench.write(), 0);
        QVERIFY(bench.record().write->units == (TableUnits{"m", {"m"}}));
    }

    /// So that who looks at the axis sees how good it is.
    void statusSaysWhatTheRecordsOfThisComputerHave()
    {
        const Fixture bench;
        CalibrationRecord record = bench.record();
        record.prediction.emplace();
        const auto a = static_cast<std::size_t>(Iso230Figure::A);
        record.prediction->before.values[a] = 0.0143;
        record.prediction->predicted.values[a] = 0.003;
        bench.box.file("job.axcal", QByteArray::fromStdString(recordText(record)));
        VERIFY_CODE(bench.write(), 0);
        const ProgramRun status = bench.run({"status"});
        QVERIFY2(status.out.contains("With this table: accuracy A 14.300 um before, 3.000 um "
                                     "predicted, not measured since"),
            status.out.constData());
        const QJsonObject json = bench.run({"status", "--json"}).json();
        const QJsonObject measured = json.value("measured").toObject();
        QCOMPARE(measured.value("crc"), json.value("table").toObject().value("crc"));
        QCOMPARE(measured.value("unit").toString(), "mm");
        QCOMPARE(measured.value("axisUnit").toString(), "mm");
        const QJsonObject figure = measured.value("figures").toArray().first().toObject();
        QCOMPARE(figure.value("figure").toString(), "A");
        QCOMPARE(figure.value("before").toDouble(), 0.0143);
        QVERIFY(figure.value("after").isNull());

        bench.box.file("other.csv", "X [mm],Error [mm]\n0,0\n40,0.0011\n80,-0.003\n");
        VERIFY_CODE(bench.run({"write", "--data", "other.csv", "--dims", "1"}), 0);
        QVERIFY(!bench.run({"status", "--json"}).json().contains("measured"));
    }

    void aTableThatIsThereAlreadyIsNotedToo()
    {
        const Fixture bench;
        const QByteArray before = bench.text();
        VERIFY_CODE(bench.write(), 0);
        bench.box.file("job.axcal", before);
        const ProgramRun again = bench.write();
        VERIFY_CODE(again, 0);
        QVERIFY2(again.out.contains("Nothing had to be written."), again.out.constData());
        QVERIFY(bench.record().write);
    }

    void aDryRunLeavesTheRecordAsItIs()
    {
        const Fixture bench;
        const QByteArray before = bench.text();
        VERIFY_CODE(bench.write({"--dry-run"}), 0);
        QCOMPARE(bench.text(), before);
    }

    void aRecordIsOfOneAxis()
    {
        const Fixture bench;
        VERIFY_CODE(bench.write(), 0);
        const QByteArray before = bench.text();
        const ProgramRun other = bench.write({}, "1");
        VERIFY_CODE(other, 2);
        QVERIFY2(other.err.contains("the record is of axis 0 (X) of Virtual-1 (serial number "
                                    "100001), and this is axis 1 (Y)"),
            other.err.constData());
        QCOMPARE(bench.text(), before);
        QVERIFY(bench.run({"status", "--json"}, "1").json().value("table").isNull());
    }

    /// Another machine has another error, whatever its axis is called.
    void aRecordOfAnotherDriveIsNotWritten()
    {
        const Fixture bench;
        CalibrationRecord record = bench.record();
        Measurement measured;
        measured.header.drive = "Mill, serial number 850618";
        measured.targets = {0.0, 40.0};
        measured.values = {{0, Approach::Up, 1, 0.0}, {1, Approach::Up, 1, 0.0021}};
        record.before =
            RecordedMeasurement{{RecordedFile{"x.csv", "runs", std::string(64, 'a'), measured}}};
        bench.box.file("job.axcal", QByteArray::fromStdString(recordText(record)));
        const QByteArray before = bench.text();
        const ProgramRun other = bench.write();
        VERIFY_CODE(other, 2);
        QVERIFY2(other.err.contains("of the drive with the serial number 850618, and this is axis "
                                    "0 (X) of Virtual-1 (serial number 100001)"),
            other.err.constData());
        QCOMPARE(bench.text(), before);
        QVERIFY(bench.run({"status", "--json"}).json().value("table").isNull());
        record.before->files.front().measurement.header.drive = "Mill, serial number 100001";
        bench.box.file("job.axcal", QByteArray::fromStdString(recordText(record)));
        VERIFY_CODE(bench.write(), 0);
    }

    /// It has no measurement: nobody knows what a reference said.
    void whatTheReferenceSaidIsToldOnlyWhereItIsOnRecord()
    {
        const Fixture bench(LookupAt::Encoder);
        const ProgramRun run = bench.run({"write", "--record", "job.axcal", "--own-position"});
        VERIFY_CODE(run, 0);
        QVERIFY2(run.out.contains("where the encoder reads 40 the drive will add +0.0021 mm"),
            run.out.constData());
    }

    /// Its values belong to other positions on the other side of the compensation.
    void aTableForTheEncoderIsNotLookedUpAtTheSetPosition()
    {
        const Fixture bench(LookupAt::Encoder);
        const QByteArray before = bench.text();
        const ProgramRun set = bench.write();
        VERIFY_CODE(set, 2);
        QVERIFY2(set.err.contains("the table was made for a position before the compensation, and "
                                  "Axes[0]/Signals/PathPlanner/Position is one after it"),
            set.err.constData());
        QCOMPARE(bench.text(), before);
        QVERIFY(bench.run({"status", "--json"}).json().value("table").isNull());
        VERIFY_CODE(bench.run({"write", "--record", "job.axcal", "--own-position"}), 0);
        // Now by the source that the axis has
        VERIFY_CODE(bench.run({"write", "--record", "job.axcal", "--persistent"}), 0);
        QVERIFY(bench.record().write->isPersistent);
    }

    void aTableForTheSetPositionIsWrittenToIt()
    {
        const Fixture bench(LookupAt::Set);
        VERIFY_CODE(bench.write(), 0);
        const ProgramRun encoder = bench.run({"write", "--record", "job.axcal", "--own-position"});
        VERIFY_CODE(encoder, 2);
        QVERIFY2(encoder.err.contains("--lookup-at encoder"), encoder.err.constData());
    }

    void theTableOfARecordIsWrittenAsItIs_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::newRow("another unit") << QStringList{"--value-unit", "um"};
        QTest::newRow("another sign") << QStringList{"--sign", "command"};
        QTest::newRow("fewer points") << QStringList{"--points", "2"};
        QTest::newRow("another target") << QStringList{"--target", "Y"};
        QTest::newRow("dimensions") << QStringList{"--dims", "1"};
        QTest::newRow("held ends") << QStringList{"--hold"};
    }
    void theTableOfARecordIsWrittenAsItIs()
    {
        QFETCH(const QStringList, options);
        const Fixture bench;
        const ProgramRun run = bench.write(options);
        VERIFY_CODE(run, 2);
        QVERIFY2(
            run.err.contains("the table of a record is written as it is"), run.err.constData());
        QVERIFY(!bench.record().write);
    }

    /// The CRC is that of the values alone.
    void theSameValuesOverOtherPositionsAreAnotherTable()
    {
        const Fixture bench;
        CalibrationRecord record = bench.record();
        record.prediction.emplace();
        record.prediction->before.values[static_cast<std::size_t>(Iso230Figure::A)] = 0.0143;
        bench.box.file("job.axcal", QByteArray::fromStdString(recordText(record)));
        VERIFY_CODE(bench.write(), 0);
        QVERIFY(bench.run({"status", "--json"}).json().contains("measured"));
        bench.box.file("other.csv", "X [mm],Error [mm]\n50,0\n90,0.0021\n130,-0.001\n");
        VERIFY_CODE(bench.run({"write", "--data", "other.csv", "--dims", "1"}), 0);
        const ProgramRun other = bench.run({"activate", "--record", "job.axcal"});
        VERIFY_CODE(other, 2);
        QVERIFY2(other.err.contains("over other positions"), other.err.constData());
        QVERIFY(!bench.record().write->proof);
        QVERIFY(!bench.run({"status", "--json"}).json().contains("measured"));
    }

    void aTableThatIsLookedUpElsewhereIsNotThatOfTheRecord()
    {
        const Fixture bench(LookupAt::Set);
        VERIFY_CODE(bench.write(), 0);
        VERIFY_CODE(bench.run({"write", "--source1", test::positionSource(1)}), 0);
        VERIFY_CODE(bench.run({"activate", "--record", "job.axcal"}), 2);
        VERIFY_CODE(bench.run({"write", "--own-position"}), 0);
        const ProgramRun other = bench.run({"activate", "--record", "job.axcal"});
        VERIFY_CODE(other, 2);
        QVERIFY2(other.err.contains("--lookup-at encoder"), other.err.constData());
        QVERIFY(!bench.record().write->proof);
    }

    /// Neither is it switched on.
    void aProofOfAnotherTableIsNotNoted()
    {
        const Fixture bench;
        const ProgramRun early = bench.run({"activate", "--record", "job.axcal"});
        VERIFY_CODE(early, 2);
        QVERIFY2(early.err.contains("`axiscomp write --record` writes it"), early.err.constData());
        VERIFY_CODE(bench.write(), 0);
        bench.box.file("other.csv", "X [mm],Error [mm]\n0,0\n40,0.0011\n80,-0.003\n");
        VERIFY_CODE(bench.run({"write", "--data", "other.csv", "--dims", "1"}), 0);
        const QByteArray before = bench.text();
        const ProgramRun other = bench.run({"activate", "--record", "job.axcal"});
        VERIFY_CODE(other, 2);
        QVERIFY2(other.err.contains("and that of the record is"), other.err.constData());
        QCOMPARE(bench.text(), before);
        QCOMPARE(bench.run({"status", "--json"}).json().value("state").toString(), "Disabled");
    }
};

AXISCOMP_TEST(tst_RecordOnADrive)

} // namespace tst_recordonadrive

#include "tst_recordonadrive.moc"
