// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compensator/drive_record.h"

#include "core/base/error.h"
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
    status.table = TableHeader{{}, 3, 0x1c291ca3, true};
    return status;
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
        VERIFY_RESULT(recordProof(record, axisWithTable(), proof));
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
        VERIFY_RESULT(recordProof(record, axisWithTable(), proof));
        QVERIFY(!record.write->proof);
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
};

AXISCOMP_TEST(TestDriveRecord)

} // namespace tst_driverecord

#include "tst_driverecord.moc"
