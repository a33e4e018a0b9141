// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/record/reference_reading.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <functional>

namespace tst_referencereading {

using namespace axiscomp;

namespace {

/// The table at the targets 0, 10 and 20 mm, with nothing taken out; the largest value at 10 mm.
CalibrationRecord plainRecord()
{
    RecordedFile file{"before.csv", "runs", std::string(64, 'a'), {}};
    file.measurement.targets = {0.0, 10.0, 20.0};
    for (const Approach direction : {Approach::Up, Approach::Down})
        for (std::size_t i = 0; i < 3; ++i)
            file.measurement.values.push_back({i, direction, 1, i == 1 ? -0.002 : 0.001});
    CalibrationRecord record;
    record.before = RecordedMeasurement{{file}};
    record.fit.emplace();
    record.fit->settings.zero = FitZero::Keep;
    RecordedTable table;
    table.table.grid.axes = {{"X", "mm", 0.0, 10.0, 3}};
    table.table.values = {0.001F, -0.002F, 0.001F};
    record.tables = {table};
    return record;
}

} // namespace

class TestReferenceReading : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void whatTheReferenceSaidIsKnownWhereItWasRead_data()
    {
        using Change = std::function<void(CalibrationRecord&)>;
        QTest::addColumn<Change>("change");
        QTest::addColumn<bool>("isRead");
        const auto row = [](const char* name, bool isRead, Change change) {
            QTest::newRow(name) << std::move(change) << isRead;
        };
        row("as measured", true, [](CalibrationRecord&) {});
        row("a zero was taken out", false,
            [](CalibrationRecord& r) { r.fit->settings.zero = FitZero::First; });
        row("corrected to 20 degrees", false, [](CalibrationRecord& r) {
            r.before->corrections.temperature.emplace();
            r.before->corrections.temperature->expansionPerKelvin = 11.5e-6;
            r.before->corrections.temperature->isConfirmed = true;
        });
        row("the largest value between the targets", false, [](CalibrationRecord& r) {
            r.tables[0].table.grid.axes = {{"X", "mm", 0.0, 5.0, 3}};
        });
        row("a smaller value between the targets", true, [](CalibrationRecord& r) {
            r.tables[0].table.grid.axes = {{"X", "mm", 5.0, 5.0, 3}};
        });
        row("the table corrects another axis", false, [](CalibrationRecord& r) {
            r.before->files[0].measurement.header.axis = "X";
            r.tables[0].table.target = "Y";
        });
        row("onto a table that was active", false,
            [](CalibrationRecord& r) { r.fit->active = {r.tables[0].table}; });
        row("drift taken out", false,
            [](CalibrationRecord& r) { r.before->corrections.drift = DriftRemoval::Offset; });
        row("no fit", false, [](CalibrationRecord& r) { r.fit.reset(); });
        row("no measurement", false, [](CalibrationRecord& r) { r.before.reset(); });
        row("no table", false, [](CalibrationRecord& r) { r.tables.clear(); });
        row("an exclusion that fits no value", false, [](CalibrationRecord& r) {
            r.before->exclusions = {{Approach::Up, 7, 1}};
        });
    }
    void whatTheReferenceSaidIsKnownWhereItWasRead()
    {
        QFETCH(const std::function<void(CalibrationRecord&)>, change);
        QFETCH(const bool, isRead);
        CalibrationRecord record = plainRecord();
        change(record);
        QCOMPARE(isReferenceReadAtLargest(record), isRead);
    }

    void itIsKnownOfTheTablesOfAFitBeforeThereIsARecord()
    {
        const CalibrationRecord record = plainRecord();
        FitSettings settings = record.fit->settings;
        CorrectionsBefore corrections;
        FitReport report;
        report.tables.emplace_back().table = record.tables[0].table;
        const auto isRead = [&] {
            return isReferenceReadAtLargest(
                record.before->files[0].measurement, corrections, settings, report);
        };
        QVERIFY(isRead());
        corrections.temperature.emplace();
        QVERIFY(!isRead());
        corrections = {};
        settings.zero = FitZero::First;
        QVERIFY(!isRead());
        settings.zero = FitZero::Keep;
        settings.drift = DriftRemoval::Offset;
        QVERIFY(!isRead());
        settings.drift.reset();
        const KnownTables active{Verbatim{"x.csv"}, {report.tables[0].table}, {}};
        report.state.active = &active;
        QVERIFY(!isRead());
        report.state.active = nullptr;
        // One of several is enough.
        report.tables.push_back(report.tables.front());
        QVERIFY(isRead());
        report.tables.back().table.grid.axes = {{"X", "mm", 0.0, 5.0, 3}};
        QVERIFY(!isRead());
    }
};

AXISCOMP_TEST(TestReferenceReading)

} // namespace tst_referencereading

#include "tst_referencereading.moc"
