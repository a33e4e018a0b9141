// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/record/kept_figures.h"
#include "tests/core/metrology/record/record_example.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTemporaryDir>

namespace tst_keptfigures {

using namespace axiscomp;

namespace {

constexpr std::uint32_t writtenCrc = 0x10203040;

FigureValues accuracy(double a, double m)
{
    FigureValues values;
    values.values[static_cast<std::size_t>(Iso230Figure::A)] = a;
    values.values[static_cast<std::size_t>(Iso230Figure::M)] = m;
    return values;
}

/// Written to axis 1 of drive 1559; before A 14.3 um, predicted 3 um.
CalibrationRecord writtenRecord()
{
    CalibrationRecord record;
    record.before = RecordedMeasurement{{test::fullRecord().before->files.front()}};
    record.before->files.front().measurement.header.date = "2026-11-20";
    record.before->files.front().measurement.values[7].isUsed = true;
    record.prediction = RecordedPrediction{accuracy(0.0143, 0.011), accuracy(0.003, 0.001)};
    record.drive = RecordedDrive{"Triamec-616", 1559, "generic", 1, "X"};
    record.write = RecordedWrite{{}, "Small1", true, writtenCrc};
    return record;
}

void addAfter(CalibrationRecord& record, double a, std::optional<std::uint32_t> crc)
{
    RecordedAfter after{*record.before, accuracy(a, 0.0011)};
    after.measurement.files.front().measurement.header.date = "2026-11-24";
    after.tableCrc = crc;
    record.after.push_back(after);
}

std::string sentenceOf(const CalibrationRecord& record)
{
    const auto kept = figuresToKeep(record, {});
    return kept ? measuredFiguresText(*kept).english() : "nothing";
}

} // namespace

class TestKeptFigures : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aRecordThatWasNotWrittenKeepsNothing()
    {
        CalibrationRecord record = writtenRecord();
        record.write.reset();
        QCOMPARE(sentenceOf(record), std::string("nothing"));
        record = writtenRecord();
        record.prediction.reset();
        record.before.reset();
        QCOMPARE(sentenceOf(record), std::string("nothing"));
    }

    void whatWasPromisedIsSaidUntilItIsMeasured()
    {
        QCOMPARE(sentenceOf(writtenRecord()),
            std::string("measured 2026-11-20: accuracy A 14.300 um before, 3.000 um predicted, not "
                        "measured since"));
    }

    void beforeAndAfterAreSaidWithTheVerdict()
    {
        CalibrationRecord record = writtenRecord();
        addAfter(record, 0.0032, writtenCrc);
        QCOMPARE(sentenceOf(record),
            std::string("measured 2026-11-24: accuracy A 14.300 um before, 3.200 um after"));
        record.verdict =
            RecordedVerdict{{{{Iso230Figure::A, 0.005}, 0.0032, {}, VerdictResult::Passed},
                {{Iso230Figure::M, 0.001}, 0.0011, {}, VerdictResult::Failed}}};
        QCOMPARE(sentenceOf(record),
            std::string("measured 2026-11-24: range of the mean deviation M 11.000 um before, "
                        "1.100 um after (tolerance 1.000 um: failed); accuracy A 14.300 um before, "
                        "3.200 um after (tolerance 5.000 um: passed)"));
        QCOMPARE(measuredFiguresCell(*figuresToKeep(record, {})).english(),
            std::string("M 1.100 um, 11.000 um before"));
    }

    void valuesThatAreLeftOutAreSaid()
    {
        CalibrationRecord record = writtenRecord();
        record.before->exclusions = {{Approach::Up, 1, 1}};
        addAfter(record, 0.0032, writtenCrc);
        QCOMPARE(figuresToKeep(record, {})->excluded, std::size_t{2});
        QCOMPARE(sentenceOf(record),
            std::string("measured 2026-11-24: accuracy A 14.300 um before, 3.200 um after; 2 "
                        "values excluded, not an evaluation by ISO 230-2"));
    }

    void aShorterTravelIsSaid()
    {
        CalibrationRecord record = writtenRecord();
        addAfter(record, 0.0032, writtenCrc);
        QVERIFY(!figuresToKeep(record, {})->lesserRange);
        Measurement& second = record.after.front().measurement.files.front().measurement;
        for (double& target : second.targets)
            target /= 2.0;
        const auto kept = figuresToKeep(record, {});
        QCOMPARE(kept->lesserRange->after.last, second.targets.back());
        const std::string said = sentenceOf(record);
        QVERIFY2(said.starts_with("measured 2026-11-24: accuracy A 14.300 um before, 3.200 um "
                                  "after; first measurement from -20 to 20 mm, second one from -10 "
                                  "to 10 mm: over a shorter travel"),
            said.c_str());
        QCOMPARE(measuredFiguresCell(*kept).english(),
            std::string("A 3.200 um, 14.300 um before, over part of the travel"));
    }

    void whereTheTableIsLookedUpIsKept()
    {
        CalibrationRecord record = writtenRecord();
        record.tables.clear();
        QVERIFY(figuresToKeep(record, {})->madeFor == MadeForLookup{});
        record.fit.emplace();
        record.fit->settings.lookupAt = LookupAt::Set;
        record.tables.resize(2);
        for (RecordedTable& recorded : record.tables)
            recorded.table.grid.axes = {{"X", "mm", 0.0, 20.0, 3}, {"Y", "mm", 0.0, 20.0, 3}};
        record.tables[0].table.target = "Y";
        record.tables[1].table.target = "Z";
        QVERIFY(
            figuresToKeep(record, {})->madeFor == (MadeForLookup{LookupAt::Set, {"#2", "other"}}));
        record.tables[1].table.target.clear(); // may be that of any axis
        QVERIFY(figuresToKeep(record, {})->madeFor == (MadeForLookup{LookupAt::Set, {}}));
    }

    void theUnitsOfTheTableAndTheNameOfItsAxisAreKept()
    {
        CalibrationRecord record = writtenRecord();
        QCOMPARE(figuresToKeep(record, {})->axisName, std::string("X"));
        QVERIFY(!figuresToKeep(record, {})->units); // a record of an older program
        record.write->units = TableUnits{"mm", {"mm"}};
        QVERIFY(figuresToKeep(record, {})->units == record.write->units);
    }

    void aToleranceThatIsMissedByLittleReadsSo()
    {
        CalibrationRecord record = writtenRecord();
        addAfter(record, 0.0050000004, writtenCrc);
        record.verdict =
            RecordedVerdict{{{{Iso230Figure::A, 0.005}, 0.0050000004, {}, VerdictResult::Failed}}};
        QCOMPARE(sentenceOf(record),
            std::string("measured 2026-11-24: accuracy A 14.300 um before, 5.0000004 um after "
                        "(tolerance 5.0000000 um: failed)"));
    }

    /// The figures of another table would be those of another machine.
    void aMeasurementWithAnEarlierTableDoesNotCount()
    {
        CalibrationRecord record = writtenRecord();
        addAfter(record, 0.0090, writtenCrc + 1);
        record.verdict =
            RecordedVerdict{{{{Iso230Figure::A, 0.005}, 0.0090, {}, VerdictResult::Failed}}};
        QVERIFY(!lastAfter(record));
        QCOMPARE(sentenceOf(record),
            std::string("measured 2026-11-20: accuracy A 14.300 um before, 3.000 um predicted, not "
                        "measured since (tolerance 5.000 um)"));
        // Older programs did not note the table.
        addAfter(record, 0.0032, std::nullopt);
        QCOMPARE(lastAfter(record), &record.after[1]);
        addAfter(record, 0.0033, writtenCrc + 1);
        QCOMPARE(lastAfter(record), &record.after[1]);
    }

    void theyAreKeptByDriveAxisAndTable()
    {
        const QTemporaryDir folder;
        DriveStore store(folder.path().toStdString());
        CalibrationRecord record = writtenRecord();
        VERIFY_RESULT(keepFigures(store, record, {}, Measuring::New));
        QVERIFY(*store.measured(1559, 1, writtenCrc) == *figuresToKeep(record, {}));
        record.write.reset();
        VERIFY_RESULT(keepFigures(store, record, {}, Measuring::New));
        QVERIFY(store.measured(1559, 1, writtenCrc)->has_value());
    }

    void aLaterMeasurementIsNotReplacedByAnEarlierOne()
    {
        const QTemporaryDir folder;
        DriveStore store(folder.path().toStdString());
        CalibrationRecord later = writtenRecord();
        addAfter(later, 0.0250, writtenCrc);
        CalibrationRecord earlier = writtenRecord();
        addAfter(earlier, 0.0032, writtenCrc);
        std::string& date = earlier.after.front().measurement.files.front().measurement.header.date;
        date = "2026-11-23T17:30:00Z";
        const auto kept = [&store] { return *store.measured(1559, 1, writtenCrc); };
        VERIFY_RESULT(keepFigures(store, earlier, {}, Measuring::New));
        VERIFY_RESULT(keepFigures(store, later, {}, Measuring::Known));
        QVERIFY(kept() == *figuresToKeep(later, {}));
        VERIFY_RESULT(keepFigures(store, earlier, {}, Measuring::New));
        QVERIFY(kept() == *figuresToKeep(later, {}));
        // Without an order of the dates the new one counts.
        date = "yesterday";
        VERIFY_RESULT(keepFigures(store, earlier, {}, Measuring::Known));
        QVERIFY(kept() == *figuresToKeep(later, {}));
        VERIFY_RESULT(keepFigures(store, earlier, {}, Measuring::New));
        QVERIFY(kept() == *figuresToKeep(earlier, {}));
    }

    void whatWasMeasuredIsNotReplacedByWhatIsOnlyPromised()
    {
        const QTemporaryDir folder;
        DriveStore store(folder.path().toStdString());
        CalibrationRecord record = writtenRecord();
        addAfter(record, 0.0032, writtenCrc);
        VERIFY_RESULT(keepFigures(store, record, {}, Measuring::New));
        VERIFY_RESULT(keepFigures(store, writtenRecord(), {}, Measuring::Known));
        QVERIFY(*store.measured(1559, 1, writtenCrc) == *figuresToKeep(record, {}));
    }

    /// The same table, made of the axis as it was measured once more, or nobody knows when.
    void whatWasMeasuredIsNotReplacedByALaterPromise()
    {
        const QTemporaryDir folder;
        DriveStore store(folder.path().toStdString());
        CalibrationRecord record = writtenRecord();
        addAfter(record, 0.0032, writtenCrc);
        VERIFY_RESULT(keepFigures(store, record, {}, Measuring::New));
        for (const char* const date : {"2026-11-25", ""})
            for (const Measuring measuring : {Measuring::New, Measuring::Known}) {
                CalibrationRecord promised = writtenRecord();
                promised.before->files.front().measurement.header.date = date;
                VERIFY_RESULT(keepFigures(store, promised, {}, measuring));
                QVERIFY(*store.measured(1559, 1, writtenCrc) == *figuresToKeep(record, {}));
            }
    }

    void theSameNumbersInAnotherUnitAreAnotherTable()
    {
        const QTemporaryDir folder;
        DriveStore store(folder.path().toStdString());
        CalibrationRecord millimetres = writtenRecord();
        millimetres.write->units = TableUnits{"mm", {"mm"}};
        addAfter(millimetres, 0.0032, writtenCrc);
        VERIFY_RESULT(keepFigures(store, millimetres, {}, Measuring::New));
        CalibrationRecord promised = writtenRecord();
        promised.write->units = TableUnits{"Millimeter", {"Millimeter"}}; // the same ones
        VERIFY_RESULT(keepFigures(store, promised, {}, Measuring::Known));
        QVERIFY(*store.measured(1559, 1, writtenCrc) == *figuresToKeep(millimetres, {}));
        promised.write->units = TableUnits{"m", {"m"}};
        VERIFY_RESULT(keepFigures(store, promised, {}, Measuring::Known));
        QVERIFY(*store.measured(1559, 1, writtenCrc) == *figuresToKeep(promised, {}));
    }

    void theSameNumbersOfAnotherAxisAreAnotherTable()
    {
        const QTemporaryDir folder;
        DriveStore store(folder.path().toStdString());
        CalibrationRecord measured = writtenRecord();
        measured.drive->axisName = "X";
        addAfter(measured, 0.0032, writtenCrc);
        VERIFY_RESULT(keepFigures(store, measured, {}, Measuring::New));
        CalibrationRecord promised = writtenRecord();
        promised.drive->axisName = "X1"; // may be the same one
        VERIFY_RESULT(keepFigures(store, promised, {}, Measuring::Known));
        QVERIFY(*store.measured(1559, 1, writtenCrc) == *figuresToKeep(measured, {}));
        promised.drive->axisName = "Z";
        VERIFY_RESULT(keepFigures(store, promised, {}, Measuring::Known));
        QVERIFY(*store.measured(1559, 1, writtenCrc) == *figuresToKeep(promised, {}));
    }

    void theSameMeasurementMayBeJudgedAnew()
    {
        const QTemporaryDir folder;
        DriveStore store(folder.path().toStdString());
        CalibrationRecord record = writtenRecord();
        addAfter(record, 0.0032, writtenCrc);
        VERIFY_RESULT(keepFigures(store, record, {}, Measuring::New));
        record.verdict =
            RecordedVerdict{{{{Iso230Figure::A, 0.003}, 0.0032, {}, VerdictResult::Failed}}};
        VERIFY_RESULT(keepFigures(store, record, {}, Measuring::Known));
        QVERIFY(*store.measured(1559, 1, writtenCrc) == *figuresToKeep(record, {}));
    }

    void datesAreOrderedWhereTheyAreDays()
    {
        QVERIFY(isEarlier("2026-11-20", "2026-11-21"));
        QVERIFY(isEarlier("2026-11-20 23:00", "2026-11-21"));
        QVERIFY(isEarlier("2026-11-20T08:00:00Z", "2026-11-20T08:00:01Z"));
        QVERIFY(!isEarlier("2026-11-20T08:00:00Z", "2026-11-20"));
        QVERIFY(!isEarlier("2026-11-20", "2026-11-20"));
        QVERIFY(!isEarlier("", "2026-11-20"));
        QVERIFY(!isEarlier("20.11.2026", "2026-11-21"));
        QVERIFY(!isEarlier("2026-11-2x", "2026-11-21"));
    }

    void aFileWithoutADateHasNone()
    {
        CalibrationRecord record = writtenRecord();
        record.before->files.front().measurement.header.date.clear();
        QCOMPARE(sentenceOf(record),
            std::string("accuracy A 14.300 um before, 3.000 um predicted, not measured since"));
    }
};

AXISCOMP_TEST(TestKeptFigures)

} // namespace tst_keptfigures

#include "tst_keptfigures.moc"
