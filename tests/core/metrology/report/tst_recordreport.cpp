// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/report/record_report.h"
#include "core/metrology/report/report_html.h"
#include "tests/core/metrology/measurement_reading.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <cmath>
#include <functional>

namespace tst_recordreport {

using namespace axiscomp;

namespace {

/// A fit of a public measurement at its targets, with nothing taken out.
CalibrationRecord plainRecord()
{
    CalibrationRecord record;
    RecordedFile file;
    file.measurement = test::readAs("runs", test::publicMeasurement("bifrost.csv"))
                           .measurement.value_or(Measurement{});
    file.file = "before.csv";
    file.format = "runs";
    record.before.emplace();
    record.before->files = {file};
    record.fit.emplace();
    record.fit->settings.zero = FitZero::Keep;
    RecordedTable table;
    table.table.unit = "mm";
    table.table.grid.axes = {{"X", "mm", 15.0, 10.2, 5}};
    table.table.values = {0.003226F, -0.001888F, 0.000615F, -0.008452F, 0.0065F};
    record.tables = {table};
    return record;
}

} // namespace

class TestRecordReport : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aFitByTemperatureSaysSoAndItsFiguresAreOfTheWorstState()
    {
        CalibrationRecord record = plainRecord();
        record.fit->settings.isByTemperature = true;
        Measurement& measurement = record.before->files[0].measurement;
        for (RunValue& value : measurement.values) {
            value.temperature = value.run == 1 ? 16.0 : 26.0;
            value.deviation = (value.run == 1 ? 4e-4 : -1e-4) * static_cast<double>(value.target);
        }
        const auto content = reportContent(record, "1");
        VERIFY_RESULT(content);
        QVERIFY(content->table.method.english().ends_with("over position and temperature"));
        // 1 run of 5: the mean of all is 0 at each target.
        QVERIFY(std::abs(*figuresBy(*content, measurement)[Iso230Figure::M].value - 16e-4) < 1e-9);
    }

    /// Also where nothing is measured again, as programs before this one kept it.
    void aSecondMeasurementOverLessOfTheAxisIsSaid()
    {
        CalibrationRecord record = plainRecord();
        record.after = {RecordedAfter{*record.before, {}}};
        auto content = reportContent(record, "1");
        VERIFY_RESULT(content);
        QVERIFY(content->warnings.empty());
        for (double& target : record.after[0].measurement.files[0].measurement.targets)
            target += 1000.0;
        content = reportContent(record, "1");
        VERIFY_RESULT(content);
        QCOMPARE(content->warnings.size(), std::size_t{1});
        QCOMPARE(content->warnings[0].name, std::string_view("LesserRange"));
        const std::string said = content->warnings[0].text.english();
        QVERIFY2(said.find("second one from 10") != std::string::npos, said.c_str());
    }

    /// Nobody is to take what one file says for what is true of all runs.
    void whatJoinedFilesSayDifferentlyIsSaidOfEach()
    {
        CalibrationRecord record = plainRecord();
        record.before->files.push_back(record.before->files[0]);
        RecordedFile& one = record.before->files[0];
        RecordedFile& two = record.before->files[1];
        one.file = "j1.csv";
        two.file = "j2.csv";
        for (RunValue& value : two.measurement.values)
            value.deviation += 1e-4;
        const auto state = [](MeasurementHeader& header, const char* machine, const char* date,
                               double celsius) {
            header.machine = machine;
            header.serial = std::string(machine) + "-88";
            header.date = date;
            header.instrument = "XL-80";
            header.materialTemperature = celsius;
        };
        state(one.measurement.header, "M1", "2026-11-01", 20.5);
        state(two.measurement.header, "M2", "2026-11-03", 24.5);
        two.measurement.header.airTemperature = 21.0;
        two.measurement.header.feed = "500 mm/min";
        const auto page = [&] {
            const auto content = reportContent(record, "1.0");
            return content ? reportHtml(reportDocument(*content)) : sentence(content.error());
        };
        const std::string differing = page();
        for (const char* said :
            {"<dd>M1 (j1.csv), M2 (j2.csv)</dd>", "<dd>M1-88 (j1.csv), M2-88 (j2.csv)</dd>",
                "<td>2026-11-01 (j1.csv), 2026-11-03 (j2.csv)</td>", "<td>XL-80</td>",
                "<td>500 mm/min, not stated</td>",
                "air not stated (j1.csv), 21 °C (j2.csv), material 20.5 °C (j1.csv), 24.5 °C "
                "(j2.csv), expansion not stated",
                "Warning: first measurement: the files are of different machines: M1 (file 1), M2 "
                "(file 2).",
                "Warning: first measurement: the files have different serial numbers: "})
            QVERIFY2(differing.find(said) != std::string::npos, said);
        state(two.measurement.header, "M1", "2026-11-01", 20.5);
        const std::string alike = page();
        QVERIFY(alike.find("<dd>M1</dd>") != std::string::npos);
        QVERIFY(alike.find("material 20.5 °C, expansion") != std::string::npos);
        QVERIFY(alike.find("Warning") == std::string::npos);
    }

    void anotherMachineAfterwardsIsSaid()
    {
        CalibrationRecord record = plainRecord();
        record.after = {RecordedAfter{*record.before, {}}};
        record.before->files[0].measurement.header.machine = "M1";
        record.after[0].measurement.files[0].measurement.header.machine = "M2";
        const auto content = reportContent(record, "1");
        VERIFY_RESULT(content);
        QVERIFY(reportHtml(reportDocument(*content))
                    .find("Warning: the first measurement is of the machine M1, the second of M2.")
            != std::string::npos);
    }

    /// The page stays one page.
    void ofManyFilesAFewAreNamed()
    {
        CalibrationRecord record = plainRecord();
        for (int n = 1; n < 7; ++n) {
            RecordedFile next = record.before->files[0];
            next.file = "j" + std::to_string(n) + ".csv";
            next.measurement.header.date = "2026-11-0" + std::to_string(n);
            for (RunValue& value : next.measurement.values)
                value.deviation += 1e-4 * n;
            record.before->files.push_back(next);
        }
        const auto content = reportContent(record, "1.0");
        VERIFY_RESULT(content);
        const std::string page = reportHtml(reportDocument(*content));
        QVERIFY(page.find("not stated (before.csv), 2026-11-01 (j1.csv), 2026-11-02 (j2.csv), "
                          "2026-11-03 (j3.csv), and 3 more in the record")
            != std::string::npos);
    }

    void theDatumOfACorrectionIsThatOfThePlots()
    {
        CalibrationRecord record = plainRecord();
        TemperatureCorrection& temperature = record.before->corrections.temperature.emplace();
        temperature.expansionPerKelvin = 11.5e-6;
        temperature.isConfirmed = true;
        temperature.datum = 35.4;
        record.after = {RecordedAfter{*record.before, {}}};
        record.after[0].measurement.corrections.temperature.reset();
        const auto content = reportContent(record, "1");
        VERIFY_RESULT(content);
        QCOMPARE(content->before->datum, std::optional(35.4));
        QVERIFY(!content->after->datum);
    }

    /// Of the last measurement: a report is what an acceptance is filed with.
    void aVerdictThatAllValuesWouldChangeIsSaid()
    {
        CalibrationRecord record = plainRecord();
        record.judging.emplace();
        record.judging->tolerances = {{Iso230Figure::A, 0.02}, {Iso230Figure::R, 1.0}};
        record.after = {RecordedAfter{*record.before, {}}};
        const auto warnings = [&] {
            std::vector<std::string> said;
            if (const auto content = reportContent(record, "1"))
                for (const JudgeWarning& warning : content->warnings)
                    said.push_back(std::string(warning.name) + ": " + warning.text.english());
            return said;
        };
        QCOMPARE(warnings(), std::vector<std::string>{}); // A is 18.571 um
        record.after[0].measurement.files[0].measurement.values[7].deviation = 0.05;
        QCOMPARE(warnings(), std::vector<std::string>{}); // it fails, and so it says
        record.after[0].measurement.exclusions = {{Approach::Up, 2, 3}};
        const auto said = warnings();
        QCOMPARE(said.size(), std::size_t{1});
        QVERIFY2(said[0].find("OtherVerdict: of all values accuracy A is ") == 0
                && said[0].find("(tolerance 20.000 µm: failed)") != std::string::npos,
            said[0].c_str());
        record.before = record.after[0].measurement;
        record.after.clear();
        QCOMPARE(warnings(), said);
    }

    void theReferenceIsQuotedWhereItWasReadAndNothingElseIsInTheTable_data()
    {
        using Change = std::function<void(CalibrationRecord&)>;
        QTest::addColumn<Change>("change");
        QTest::addColumn<bool>("isQuoted");
        const auto row = [](const char* name, bool isQuoted, Change change) {
            QTest::newRow(name) << std::move(change) << isQuoted;
        };
        row("as measured", true, [](CalibrationRecord&) {});
        row("of another axis", false, [](CalibrationRecord& r) {
            r.before->files[0].measurement.header.axis = "X";
            r.tables[0].table.target = "Y";
        });
        row("gain", false, [](CalibrationRecord& r) { r.fit->settings.gain = 0.5; });
        row("merged", false, [](CalibrationRecord& r) { r.fit->active = {r.tables[0].table}; });
        row("zero", false, [](CalibrationRecord& r) { r.fit->settings.zero = FitZero::First; });
        row("slope", false,
            [](CalibrationRecord& r) { r.fit->settings.slope = SlopeRemoval::Ends; });
        row("drift", false,
            [](CalibrationRecord& r) { r.before->corrections.drift = DriftRemoval::Offset; });
        row("inverted", false, [](CalibrationRecord& r) {
            r.before->files[0].measurement.againstFile.invertsReference = true;
        });
        row("temperature", false, [](CalibrationRecord& r) {
            r.before->corrections.temperature.emplace();
            r.before->corrections.temperature->expansionPerKelvin = 11.5e-6;
            r.before->corrections.temperature->isConfirmed = true; // at 20 degrees: changes nothing
        });
        row("smoothed", false,
            [](CalibrationRecord& r) { r.fit->settings.method = FitMethod::Smooth; });
        row("between the targets", false, [](CalibrationRecord& r) {
            r.tables[0].table.grid.axes = {{"X", "mm", 15.0, 10.0, 5}};
        });
        row("left out", false, [](CalibrationRecord& r) {
            for (RunValue& value : r.before->files[0].measurement.values)
                value.isUsed = value.target != 3;
        });
    }
    void theReferenceIsQuotedWhereItWasReadAndNothingElseIsInTheTable()
    {
        QFETCH(const std::function<void(CalibrationRecord&)>, change);
        QFETCH(const bool, isQuoted);
        CalibrationRecord record = plainRecord();
        change(record);
        const auto content = reportContent(record, "1.0");
        VERIFY_RESULT(content);
        const std::string sign = content->sign.english();
        const bool isFound =
            sign.find("the reference said 45.5915 mm: the drive adds -8.452") != std::string::npos;
        QVERIFY2(isFound == isQuoted, sign.c_str());
        QVERIFY2(isQuoted || sign.find("the reference said") == std::string::npos, sign.c_str());
    }

    /// A straightness: who holds the page against the machine looks at that axis.
    void theAxisThatATableCorrectsIsNamedWhereItIsAnotherOne()
    {
        CalibrationRecord record = plainRecord();
        record.before->files[0].measurement.header.axis = "X";
        record.tables[0].table.target = "Y";
        auto content = reportContent(record, "1.0");
        VERIFY_RESULT(content);
        QCOMPARE(content->corrected, "Y");
        const std::string encoder = content->sign.english();
        QVERIFY2(
            encoder.find("Where the encoder of axis X reads 45.6000 mm, the drive adds -8.452") == 0
                && encoder.ends_with(" to axis Y."),
            encoder.c_str());
        record.fit->settings.lookupAt = LookupAt::Set;
        content = reportContent(record, "1.0");
        VERIFY_RESULT(content);
        const std::string set = content->sign.english();
        QVERIFY2(set.find("At the set position 45.6000 mm of axis X the drive adds -8.452") == 0
                && set.ends_with(" to what the encoder of axis Y reads."),
            set.c_str());
        record.tables[0].table.target = "X";
        content = reportContent(record, "1.0");
        VERIFY_RESULT(content);
        QVERIFY(content->corrected.empty());
    }

    /// It has its values in its own unit.
    void theCrcIsThatOfTheTableOnTheDrive()
    {
        CalibrationRecord record = plainRecord();
        record.tables[0].crc = 0x1c291ca3;
        auto content = reportContent(record, "1.0");
        VERIFY_RESULT(content);
        QCOMPARE(content->table.crc, std::optional<std::uint32_t>(0x1c291ca3));
        record.write.emplace();
        record.write->crc = 0x00c0ffee;
        content = reportContent(record, "1.0");
        VERIFY_RESULT(content);
        QCOMPARE(content->table.crc, std::optional<std::uint32_t>(0x00c0ffee));
    }

    /// Points of a plane make a table for each of its axes.
    void everyTableOfARecordIsOnThePage()
    {
        CalibrationRecord record = plainRecord();
        record.tables[0].table.name = "dX";
        record.tables[0].table.target = "X";
        record.tables[0].crc = 0x1c291ca3;
        record.tables.push_back(record.tables[0]);
        record.tables[1].table.name = "dY";
        record.tables[1].table.target = "Y";
        record.tables[1].crc = 0x00c0ffee;
        const auto page = [&] {
            const auto content = reportContent(record, "1.0");
            return content ? reportHtml(reportDocument(*content)) : sentence(content.error());
        };
        const auto has = [&](const char* said) { return page().find(said) != std::string::npos; };
        QVERIFY(has("dX for axis X, CRC-32 1c291ca3, dY for axis Y, CRC-32 00c0ffee"));
        QVERIFY(has("that of each table, below"));
        record.tables.insert(record.tables.end(), 4, record.tables[1]);
        QVERIFY(has("and 2 more in the record"));
        record.tables.resize(1);
        QVERIFY(!has("dX for axis X"));
        QVERIFY(has("1c291ca3"));
    }

    void whatTheFirstMeasurementDoesNotStateIsTakenFromTheSecond()
    {
        CalibrationRecord record = plainRecord();
        RecordedAfter after;
        after.measurement = *record.before;
        MeasurementHeader& second = after.measurement.files[0].measurement.header;
        second.axis = "X";
        second.machine = "M2";
        second.serial = "S2";
        record.after = {after};
        MeasurementHeader& first = record.before->files[0].measurement.header;
        first.axis.clear();
        first.machine = "M1";
        first.serial.clear();
        const auto content = reportContent(record, "1.0");
        VERIFY_RESULT(content);
        QCOMPARE(content->axis, std::string("X"));
        QCOMPARE(content->machine, std::string("M1"));
        QCOMPARE(content->serial, std::string("S2"));
    }

    /// Without it no second measurement comes into a record.
    void theTableThatWasStatedToBeActiveIsOnThePage()
    {
        CalibrationRecord record = plainRecord();
        record.tables[0].crc = 0x1c291ca3;
        RecordedAfter after;
        after.measurement = *record.before;
        after.tableCrc = 0x1c291ca3;
        record.after = {after};
        MeasuredState& state = record.after[0].measurement.files[0].measurement.header.compensation;
        const auto page = [&] {
            const auto content = reportContent(record, "1.0");
            return content ? reportHtml(reportDocument(*content)) : sentence(content.error());
        };
        const auto has = [&](const char* said) { return page().find(said) != std::string::npos; };
        state = {};
        QVERIFY(has("on, table 1c291ca3, as stated with the measurement"));
        state.kind = MeasuredState::Kind::On;
        QVERIFY(has("on, table 1c291ca3, as stated with the measurement"));
        state.tableCrc = 0x1c291ca3;
        QVERIFY(has("on, table 1c291ca3<"));
        state = {MeasuredState::Kind::On, std::nullopt};
        record.after[0].tableCrc.reset(); // of an older program
        QVERIFY(has("on, which table is not stated"));
    }

    void whatTurnedOrStraightenedTheValuesIsACorrection()
    {
        CalibrationRecord record = plainRecord();
        record.before->swapsDirections = true;
        record.before->files[0].measurement.againstFile.invertsReference = true;
        record.before->files[0].measurement.againstFile.units = {{"reference", "nm", "um"}};
        record.fit->settings.slope = SlopeRemoval::LeastSquares;
        RecordedAfter after;
        after.measurement = *record.before;
        after.measurement.swapsDirections = false;
        record.after = {after};
        const auto content = reportContent(record, "1.0");
        VERIFY_RESULT(content);
        const auto said = [](const ReportMeasurement& one) {
            std::vector<std::string> list;
            for (const Text& text : one.corrections)
                list.push_back(text.english());
            return list;
        };
        QCOMPARE(said(*content->before),
            (std::vector<std::string>{"up and down exchanged",
                "reference taken with the opposite sign",
                "unit of reference taken as nm, the file says um",
                "slope taken out for the table, not for figures"}));
        QCOMPARE(said(*content->after),
            (std::vector<std::string>{"reference taken with the opposite sign",
                "unit of reference taken as nm, the file says um"}));
    }

    void runsOfOneDirectionAreNoMeanOfBoth()
    {
        CalibrationRecord record = plainRecord();
        const auto method = [&] {
            const auto content = reportContent(record, "1.0");
            return content ? content->table.method.english() : sentence(content.error());
        };
        QCOMPARE(method(), std::string("linear, from the mean of both directions"));
        std::erase_if(record.before->files[0].measurement.values,
            [](const RunValue& value) { return value.direction == Approach::Down; });
        QCOMPARE(method(), std::string("linear, from the runs ↑"));
    }
};

AXISCOMP_TEST(TestRecordReport)

} // namespace tst_recordreport

#include "tst_recordreport.moc"
