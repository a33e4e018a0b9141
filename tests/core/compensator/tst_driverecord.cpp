// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compensator/drive_record.h"

#include "core/base/error.h"
#include "drivecomm/profile/profile_loader.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

namespace tst_driverecord {

using namespace axiscomp;

namespace {

AxisStatus axisWithTable()
{
    AxisStatus status;
    status.drive = {"Stage-8", 1560, 2};
    status.axis.index = 1;
    status.axis.name = "Y";
    status.setup.slot = "Large2";
    status.setup.sources[0] = {1, "Axes[1]/Signals/PositionController/MasterPosition"};
    status.table = TableHeader{{{{"Y", "mm", 0.0, 20.0, 3}}}, 3, 0x1c291ca3, true};
    return status;
}

const DriveProfile& profile()
{
    return drivecomm::genericProfile();
}

bool isOf(const CalibrationRecord& record, const CompensationTable& table)
{
    return hasTable(record, {tableCrc(table), table.grid}, profile().layout);
}

AxisStatus axisIn(const std::string& unit)
{
    AxisStatus status = axisWithTable();
    status.axis.unit = unit;
    status.sourceUnits[0] = unit;
    return status;
}

CalibrationRecord writtenRecord()
{
    CalibrationRecord record;
    if (!recordWrite(record, axisWithTable(), "generic", WallTime{}))
        return {};
    return record;
}

} // namespace

class TestDriveRecord : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aWriteIsNotedAsTheDriveSaysIt()
    {
        CalibrationRecord record;
        VERIFY_RESULT(recordWrite(record, axisWithTable(), "generic", WallTime{}));
        QCOMPARE(record.drive->serialNumber, 1560);
        QCOMPARE(record.drive->axis, 1);
        QCOMPARE(record.write->slot, std::string("Large2"));
        QCOMPARE(record.write->crc, 0x1c291ca3U);
        QVERIFY(record.write->isPersistent);
    }

    void anEarlierProofIsNotThatOfANewWrite()
    {
        CalibrationRecord record;
        VERIFY_RESULT(recordWrite(record, axisWithTable(), "generic", WallTime{}));
        Proof proof;
        proof.samples.resize(5);
        VERIFY_RESULT(recordProof(record, axisWithTable(), proof, profile()));
        QCOMPARE(record.write->proof->samples, 5);
        VERIFY_RESULT(recordWrite(record, axisWithTable(), "generic", WallTime{}));
        QVERIFY(!record.write->proof);
    }

    /// Neither is it a proof that failed.
    void whatShowsNothingIsNoProof()
    {
        CalibrationRecord record;
        VERIFY_RESULT(recordWrite(record, axisWithTable(), "generic", WallTime{}));
        Proof proof;
        proof.samples.resize(5);
        proof.extent = Proof::Extent::OutsideTable;
        VERIFY_RESULT(recordProof(record, axisWithTable(), proof, profile()));
        QVERIFY(!record.write->proof);
    }

    /// The axis Y of a twin machine has another error.
    void aTableGoesToTheDriveThatWasMeasured()
    {
        CalibrationRecord record;
        record.before = RecordedMeasurement{{RecordedFile{"y.csv", "runs", {}, {}}}};
        std::string& drive = record.before->files.front().measurement.header.drive;
        drive = "Stage-8, serial number 850618";
        const auto refused = recordWrite(record, axisWithTable(), "generic", WallTime{});
        VERIFY_ERROR(refused, ErrorCode::InvalidArgument);
        const std::string said = sentence(refused.error());
        QVERIFY2(said.find("850618") != std::string::npos
                && said.find("Stage-8 (serial number 1560)") != std::string::npos,
            said.c_str());
        QVERIFY(!record.write && !record.drive);
        drive = "Mill, serial number 1560"; // a new name is no new drive
        VERIFY_RESULT(recordWrite(record, axisWithTable(), "generic", WallTime{}));
    }

    void anAxisWithoutATableHasNothingToNote()
    {
        CalibrationRecord record;
        AxisStatus status = axisWithTable();
        status.table.reset();
        const auto noted = recordWrite(record, status, "generic", WallTime{});
        QVERIFY(!noted);
        QCOMPARE(noted.error().code, ErrorCode::NoTable);
        QVERIFY(!record.write && !record.drive);
    }

    void theSameValuesOverOtherPositionsAreAnotherTable()
    {
        CalibrationRecord record = writtenRecord();
        AxisStatus status = axisWithTable();
        VERIFY_RESULT(checkRecordTable(record, status, profile()));
        status.table->grid.axes[0].start = 50.0;
        const auto other = checkRecordTable(record, status, profile());
        VERIFY_ERROR(other, ErrorCode::InvalidArgument);
        QVERIFY2(
            sentence(other.error()).find("1c291ca3, over other positions") != std::string::npos,
            sentence(other.error()).c_str());
        VERIFY_ERROR(recordProof(record, status, Proof{}, profile()), ErrorCode::InvalidArgument);
        // Older programs did not note where it lies.
        record.write->grid.reset();
        VERIFY_RESULT(checkRecordTable(record, status, profile()));
    }

    void positionsThatTheDriveDoesNotShowAreNotCompared_data()
    {
        QTest::addColumn<double>("start");
        QTest::addColumn<double>("distance");
        QTest::addColumn<int>("size");
        QTest::newRow("start") << qQNaN() << 20.0 << 3;
        QTest::newRow("distance") << 0.0 << qQNaN() << 3;
        QTest::newRow("endless") << 0.0 << qInf() << 3;
        QTest::newRow("size") << 0.0 << 20.0 << 0;
    }

    void positionsThatTheDriveDoesNotShowAreNotCompared()
    {
        QFETCH(const double, start);
        QFETCH(const double, distance);
        QFETCH(const int, size);
        AxisStatus status = axisWithTable();
        status.table->grid.axes[0] = {"", "", start, distance, static_cast<std::uint32_t>(size)};
        VERIFY_RESULT(checkRecordTable(writtenRecord(), status, profile()));
        CalibrationRecord record;
        VERIFY_RESULT(recordWrite(record, status, "generic", WallTime{}));
        QVERIFY(!record.write->grid);
        VERIFY_RESULT(checkRecordTable(record, status, profile()));
        const auto opened = recordFromText(recordText(record), "y.axcal");
        VERIFY_RESULT(opened);
        QVERIFY(opened->write == record.write);
        status.table->crc = 1;
        VERIFY_ERROR(checkRecordTable(record, status, profile()), ErrorCode::InvalidArgument);
    }

    void aTableOfTheRecordIsKnownInTheUnitOfItsAxis()
    {
        CompensationTable millimetres{{}, "mm", {{{"Y", "mm", 0.0, 20.0, 3}}}, {0.0F, 1.0F, 2.0F}};
        CompensationTable metres{{}, "m", {{{"Y", "m", 0.0, 0.02, 3}}}, {0.0F, 0.001F, 0.002F}};
        CalibrationRecord record;
        record.tables = {{millimetres, tableCrc(millimetres)}};
        QVERIFY(isOf(record, millimetres));
        QVERIFY(isOf(record, metres));
        metres.values[1] = 0.0015F;
        QVERIFY(!isOf(record, metres));
    }

    void aTableOfAnglesIsKnownInRadians()
    {
        CompensationTable degrees{{}, "deg", {{{"C", "deg", 0.0, 90.0, 3}}}, {0.0F, 180.0F, 0.0F}};
        CompensationTable radians{degrees};
        radians.values[1] = 3.14159265F;
        CalibrationRecord record;
        record.tables = {{degrees, tableCrc(degrees)}};
        QVERIFY(isOf(record, radians)); // of another axis, whose positions are the source
        radians.grid.axes[0].distance = 1.57079632679;
        QVERIFY(isOf(record, radians));
    }

    void theSameValuesOverOtherPositionsAreNoTableOfTheRecord()
    {
        const CompensationTable table{{}, "mm", {{{"Y", "mm", 0.0, 20.0, 3}}}, {0.0F, 1.0F, 2.0F}};
        CalibrationRecord record;
        record.tables = {{table, tableCrc(table)}};
        CompensationTable other = table;
        other.grid.axes[0].start = -5.0;
        QVERIFY(!isOf(record, other));
        QVERIFY(hasTable(record, {tableCrc(other)}, profile().layout)); // where it lies is unknown
        other.grid.axes[0] = {"Y", "m", 0.0, 0.025, 3};
        QVERIFY(!isOf(record, other));
        other.grid.axes[0] = {"Y", "", 0.004, 20.001, 3}; // as single precision may round
        QVERIFY(isOf(record, other));
        other.grid.axes.push_back({"X", "mm", 0.0, 20.0, 2});
        QVERIFY(!isOf(record, other));
    }

    void theSameNumbersInAnotherUnitAreAnotherTable()
    {
        CalibrationRecord record;
        const AxisStatus millimetres = axisIn("Millimeter");
        VERIFY_RESULT(recordWrite(record, millimetres, "generic", WallTime{}));
        QVERIFY(record.write->units == (TableUnits{"mm", {"mm"}}));
        const auto opened = recordFromText(recordText(record), "y.axcal");
        VERIFY_RESULT(opened);
        QVERIFY(opened->write == record.write);
        VERIFY_RESULT(checkRecordTable(record, millimetres, profile()));
        for (const char* const unit : {"Meter", "Degree", "None", ""}) {
            const AxisStatus now = axisIn(unit);
            VERIFY_ERROR(checkRecordTable(record, now, profile()), ErrorCode::UnitMismatch);
            VERIFY_ERROR(recordProof(record, now, Proof{}, profile()), ErrorCode::UnitMismatch);
            QVERIFY(!record.write->proof);
        }
        QCOMPARE(sentence(checkRecordTable(record, axisIn("Meter"), profile()).error()),
            std::string("the values of the record's table were in mm when it was written, and the "
                        "drive has them in m now, so that the same numbers mean something else; "
                        "set the unit on the drive to mm again, or write the record's table again "
                        "(`axiscomp write --record`)"));
        AxisStatus turned = millimetres;
        turned.sourceUnits[0] = "Degree"; // of the axis whose position the source is
        const auto refused = checkRecordTable(record, turned, profile());
        VERIFY_ERROR(refused, ErrorCode::UnitMismatch);
        QVERIFY2(
            sentence(refused.error()).starts_with("the positions of dimension 1 of the record's"),
            sentence(refused.error()).c_str());
    }

    /// Which noted no units: the table says what it would be in those of now.
    void theUnitOfARecordOfAnOlderProgramIsToldByItsTables_data()
    {
        QTest::addColumn<std::string>("written");
        QTest::addColumn<std::string>("other");
        QTest::addColumn<std::string>("ofTable");
        QTest::newRow("mm") << std::string("Millimeter") << std::string("Meter")
                            << std::string("mm");
        QTest::newRow("m") << std::string("Meter") << std::string("Millimeter")
                           << std::string("mm");
        QTest::newRow("values in um")
            << std::string("Millimeter") << std::string("Meter") << std::string("um");
        QTest::newRow("no unit") << std::string("Millimeter") << std::string("None")
                                 << std::string("mm");
    }

    void theUnitOfARecordOfAnOlderProgramIsToldByItsTables()
    {
        QFETCH(const std::string, written);
        QFETCH(const std::string, other);
        QFETCH(const std::string, ofTable);
        const CompensationTable table{
            {}, ofTable, {{{"Y", "mm", 0.0, 20.0, 3}}}, {0.0F, 2.0F, 1.0F}};
        const auto held = inDriveUnits(table, {written, {written}});
        VERIFY_RESULT(held);
        AxisStatus status = axisIn(written);
        status.table = TableHeader{held->table.grid, 3, tableCrc(held->table), false};
        CalibrationRecord record;
        VERIFY_RESULT(recordWrite(record, status, "generic", WallTime{}));
        record.write->units.reset();
        record.tables = {{table, tableCrc(table)}};
        VERIFY_RESULT(checkRecordTable(record, status, profile()));
        status.axis.unit = status.sourceUnits[0] = other;
        const auto refused = checkRecordTable(record, status, profile());
        VERIFY_ERROR(refused, ErrorCode::InvalidArgument);
        QVERIFY2(sentence(refused.error()).find("does not say in which unit") != std::string::npos,
            sentence(refused.error()).c_str());
        // Nothing is left that could tell.
        status = axisIn(written);
        status.table = TableHeader{held->table.grid, 3, tableCrc(held->table), false};
        record.tables.clear();
        VERIFY_ERROR(checkRecordTable(record, status, profile()), ErrorCode::InvalidArgument);
    }

    /// As after a change of the order of the axes.
    void anAxisThatHasTheNameOfAnotherOneIsNotThatOfTheRecord()
    {
        CalibrationRecord record = writtenRecord();
        AxisStatus status = axisWithTable();
        status.axis.name = "Z";
        for (const auto& refused : {checkRecordTable(record, status, profile()),
                 recordWrite(record, status, "generic", WallTime{})}) {
            VERIFY_ERROR(refused, ErrorCode::InvalidArgument);
            QVERIFY2(
                sentence(refused.error())
                    .starts_with("the record is of axis 1 (Y) of Stage-8 (serial number 1560), "
                                 "and this is axis 1 (Z)"),
                sentence(refused.error()).c_str());
        }
        status.axis.name = "Gantry"; // may be the same axis
        VERIFY_RESULT(checkRecordTable(record, status, profile()));
    }

    /// A source can be changed without the table.
    void aTableThatIsLookedUpElsewhereIsNotThatOfTheRecord()
    {
        CalibrationRecord record = writtenRecord();
        record.fit.emplace();
        record.fit->settings.lookupAt = LookupAt::Encoder;
        RecordedTable& table = record.tables.emplace_back();
        table.table.target = "Y";
        table.table.grid.axes = {{"Y", "mm", 0.0, 20.0, 3}};
        AxisStatus status = axisWithTable();
        VERIFY_RESULT(checkRecordTable(record, status, profile()));
        status.setup.sources[0].path = "Axes[1]/Signals/PathPlanner/Position";
        VERIFY_ERROR(checkRecordTable(record, status, profile()), ErrorCode::InvalidArgument);
        status.setup.sources[0].path = "Axes[0]/Signals/PositionController/MasterPosition";
        VERIFY_ERROR(checkRecordTable(record, status, profile()), ErrorCode::TargetMismatch);
    }

    void whatIsKeptOfARecordFollowsTheRuleOfTheRecord()
    {
        const MadeForLookup made{LookupAt::Encoder, {"#1"}};
        AxisStatus status = axisWithTable();
        QVERIFY(isLookedUpAsMade(made, status, profile()));
        QVERIFY(!isLookedUpAsMade({LookupAt::Encoder, {"other"}}, status, profile()));
        // Of several tables it may be any.
        QVERIFY(isLookedUpAsMade({LookupAt::Encoder, {"other", "#1"}}, status, profile()));
        status.setup.sources[0].path = "Axes[1]/Signals/PathPlanner/Position";
        QVERIFY(!isLookedUpAsMade(made, status, profile()));
        QVERIFY(isLookedUpAsMade({LookupAt::Set, {"#1"}}, status, profile()));
        status.setup.sources[0].path = "Axes[0]/Signals/PositionController/MasterPosition";
        QVERIFY(!isLookedUpAsMade(made, status, profile()));
        QVERIFY(isLookedUpAsMade({}, status, profile())); // older programs did not note it
    }
};

AXISCOMP_TEST(TestDriveRecord)

} // namespace tst_driverecord

#include "tst_driverecord.moc"
