// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/metrology/record/record_example.h"
#include "tests/support/test_registry.h"

#include <QProcess>
#include <QTemporaryDir>

#include <nlohmann/json.hpp>

#include <functional>

namespace tst_calibrationrecord {

using namespace axiscomp;
using nlohmann::json;

namespace {

/// A member that nobody knows, in every object of a document.
void addStrangers(json& value)
{
    for (json& part : value)
        if (part.is_structured())
            addStrangers(part);
    if (value.is_object())
        value["from a later/version~"] = {{"list", {1, {{"deep", 0.1}}}}, {"text", "\xc3\xa9"}};
}

std::string reasonOf(const Result<CalibrationRecord>& record)
{
    return record ? "" : sentence(record.error());
}

} // namespace

class TestCalibrationRecord : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void everythingReadsBackToTheSame()
    {
        const CalibrationRecord record = test::fullRecord();
        const std::string text = recordText(record);
        const auto again = recordFromText(text, "a.axcal");
        VERIFY_RESULT(again);
        QCOMPARE(QByteArray::fromStdString(recordText(*again)), QByteArray::fromStdString(text));
        QCOMPARE(again->before, record.before);
        QCOMPARE(again->tables, record.tables);
        QCOMPARE(again->drive, record.drive);
        QCOMPARE(again->write, record.write);
        QCOMPARE(again->after.size(), std::size_t{2});
        QCOMPARE(again->after[0].measurement, record.after[0].measurement);
        QCOMPARE(again->after[0].isAsPredicted, std::optional(true));
        QVERIFY(!again->after[1].isAsPredicted);
        QCOMPARE(again->prediction->before, record.prediction->before);
        QCOMPARE(again->prediction->heldOut->residuals[1].value, -2e-3);
        QCOMPARE(again->fit->settings.periods.periods, record.fit->settings.periods.periods);
        QCOMPARE(again->fit->settings.grid[1].end, std::optional(500.0));
        QCOMPARE(again->fit->active, record.fit->active);
        QCOMPARE(again->verdict->figures[1].result, VerdictResult::NotDefined);
        QCOMPARE(again->judging->outlierRule, OutlierRule::None);
        QVERIFY(again->judging->tolerances == record.judging->tolerances);
        QCOMPARE(again->judging->uncertainty, record.judging->uncertainty);
        QCOMPARE(again->draft->before, record.draft->before);
        QCOMPARE(again->draft->after, record.draft->after);
        QVERIFY(again->draft->isTableStated);
        QVERIFY(again->others.empty());
        QVERIFY(again->before->others.empty());
        QVERIFY(again->before->files[0].others.empty());
    }

    void anEmptyRecordIsOne()
    {
        const auto record = recordFromText(recordText({}), "a.axcal");
        VERIFY_RESULT(record);
        QVERIFY(!record->before);
        QVERIFY(record->tables.empty());
    }

    void theTolerancesThatHoldAreThoseOfTheVerdictThenWhatWasSaidThenOfTheFit()
    {
        CalibrationRecord record;
        QVERIFY(judgingOf(record).tolerances.empty());
        record.fit.emplace();
        record.fit->settings.tolerances = {{Iso230Figure::A, 0.01}};
        record.fit->settings.uncertainty = 0.001;
        record.fit->settings.outlierRule = OutlierRule::Grubbs;
        QCOMPARE(judgingOf(record).tolerances.front().figure, Iso230Figure::A);
        QCOMPARE(judgingOf(record).uncertainty, std::optional(0.001));
        QCOMPARE(judgingOf(record).outlierRule, OutlierRule::Grubbs);
        // None is what was said as well.
        record.judging.emplace();
        QVERIFY(judgingOf(record).tolerances.empty() && !judgingOf(record).uncertainty);
        record.verdict.emplace();
        QVERIFY(judgingOf(record).tolerances.empty());
        record.verdict->figures = {{{Iso230Figure::R, 0.002}, 0.001, 0.0005}};
        QCOMPARE(judgingOf(record).tolerances.front().value, 0.002);
        QCOMPARE(judgingOf(record).uncertainty, std::optional(0.0005));
    }

    void aTableIsItsValuesItsPositionsAndItsUnits()
    {
        const RecordedTable table = test::fullRecord().tables.front();
        const auto isOther = [&table](const std::function<void(RecordedTable&)>& change) {
            RecordedTable other = table;
            change(other);
            return !isSameTable(table, other);
        };
        QVERIFY(!isOther([](RecordedTable& other) {
            other.table.name = "Table 2";
            other.table.unit = "Millimeter";
            other.table.grid.axes[0].name = "A";
        }));
        QVERIFY(isOther([](RecordedTable& other) { other.crc ^= 1U; }));
        QVERIFY(isOther([](RecordedTable& other) { other.table.grid.axes[0].start += 5.0; }));
        QVERIFY(isOther([](RecordedTable& other) { other.table.grid.axes[0].unit = "m"; }));
        QVERIFY(isOther([](RecordedTable& other) { other.table.unit = "um"; }));
    }

    void singlesStandInTheFileWithTheirShortestDigits()
    {
        const std::string text = recordText(test::fullRecord());
        QVERIFY(text.find("[0.1,-1.1754944e-38,3.4028235e+38]") != std::string::npos);
        QVERIFY(text.find("0.30000000000000004") != std::string::npos);
    }

    void membersOfALaterVersionAreWrittenBack()
    {
        json document = json::parse(recordText(test::fullRecord()));
        addStrangers(document);
        const auto record = recordFromText(document.dump(), "a.axcal");
        VERIFY_RESULT(record);
        const json written = json::parse(recordText(*record));
        QCOMPARE(QByteArray::fromStdString(json::diff(document, written).dump()), "[]");
    }

    void whatIsMadeAnewHasNoMembersOfTheOldOne()
    {
        json document = json::parse(recordText(test::fullRecord()));
        document["fit"]["quality"] = 5;
        document["prediction"]["method"] = "old";
        auto record = recordFromText(document.dump(), "a.axcal");
        VERIFY_RESULT(record);
        record->fit = RecordedFit{};
        record->prediction.reset();
        const json written = json::parse(recordText(*record));
        QVERIFY(!written["fit"].contains("quality"));
        QVERIFY(!written.contains("prediction"));
    }

    void aNewerVersionIsRefusedAndBothAreNamed()
    {
        json document = json::parse(recordText({}));
        document["version"] = 7;
        const auto record = recordFromText(document.dump(), "a.axcal");
        VERIFY_ERROR(record, ErrorCode::InvalidRecord);
        QCOMPARE(QByteArray::fromStdString(reasonOf(record)),
            "a.axcal is not a valid record: version: the record has version 7, and this program "
            "reads version 1 at most; open it with a newer version of the program");
    }

    void aFaultIsNamedByItsPlace_data()
    {
        QTest::addColumn<QByteArray>("place");
        QTest::addColumn<QByteArray>("value");
        QTest::addColumn<QByteArray>("reason");
        const auto row = [](const char* place, const char* value, const char* reason) {
            QTest::newRow(qPrintable(
                QString::fromLatin1(place) + QLatin1Char(' ') + QString::fromLatin1(value)))
                << QByteArray(place) << QByteArray(value) << QByteArray(reason);
        };
        row("/format", "\"axiscomp-backup\"", "format: \"axiscomp-record\" is expected");
        row("/before/files", "[]", "before.files: at least one file is expected");
        row("/before/files/0/sha256", "\"12\"",
            "before.files[0].sha256: a SHA-256 of 64 hexadecimal digits is expected");
        row("/before/files/0/measurement/kind", "\"run\"",
            "before.files[0].measurement.kind: \"run\" is none of: runs, averages, track, points");
        row("/before/files/0/measurement/targets/2", "-100",
            "before.files[0].measurement.targets: targets are expected to ascend");
        row("/before/files/0/measurement/values/run", "[1]",
            "before.files[0].measurement.values.run: this list has 1 elements, and the others have "
            "90");
        row("/before/files/0/measurement/values/run/4", "0.5",
            "before.files[0].measurement.values.run: whole numbers from 1 to 1000000 are expected, "
            "not 0.5");
        row("/before/files/0/measurement/values/target/4", "9",
            "before.files[0].measurement.values.target: whole numbers from 0 to 8 are expected, "
            "not 9");
        row("/before/files/0/measurement/values/direction/0", "\"left\"",
            "before.files[0].measurement.values.direction: \"left\" is neither up nor down");
        row("/before/files/0/measurement/values/deviation/3", "null",
            "before.files[0].measurement.values.deviation[3]: a number is expected, not null");
        row("/before/files/0/measurement/values/encoder/3", "\"x\"",
            "before.files[0].measurement.values.encoder[3]: a number is expected, not \"x\"");
        row("/before/files/2/measurement/points/values", "[]",
            "before.files[2].measurement.points.values: 0 lists are here, and there are 1 names");
        row("/before/exclude/0", "\"down:1\"",
            "before.exclude[0]: what is left out is expected, such as down:1:1, run:up:3 or "
            "target:7");
        row("/fit/settings/method", "\"best\"",
            "fit.settings.method: \"best\" is none of: linear, cubic, spline, smooth, harmonic");
        row("/tables/0/values/0", "0.2",
            "tables[0].crc32: the values have the CRC-32 {crc}: they were changed, or the file is "
            "damaged");
        row("/tables/0/values", "[1]",
            "tables[0].values: 1 values are here, and the grid has 3 points");
        row("/tables/0/values/0", "1e39", "tables[0].values: this is too large for a Single");
        row("/tables/0/axes/0/distance", "0",
            "tables[0].axes[0].distance: a distance above 0 is expected");
        row("/tables/0/filled/0", "3",
            "tables[0].filled[0]: numbers of the table's points are expected, ascending from 0");
        row("/prediction/before", "5", "prediction.before: an object is expected, not 5");
        row("/prediction/heldOut/residuals", "[1]",
            "prediction.heldOut.residuals: this list has 1 elements, and the others have 2");
        row("/write/time", "\"today\"",
            "write.time: a time such as 2026-11-21T08:02:23Z is expected");
        row("/verdict/figures/0/figure", "\"a\"",
            "verdict.figures[0].figure: this is no figure of ISO 230-2, such as A or EUp");
    }
    void aFaultIsNamedByItsPlace()
    {
        QFETCH(QByteArray, place);
        QFETCH(QByteArray, value);
        QFETCH(QByteArray, reason);
        json document = json::parse(recordText(test::fullRecord()));
        document[json::json_pointer(place.toStdString())] = json::parse(value.toStdString());
        const auto record = recordFromText(document.dump(), "a.axcal");
        VERIFY_ERROR(record, ErrorCode::InvalidRecord);
        const QByteArray found = QByteArray::fromStdString(reasonOf(record));
        const auto split = reason.indexOf("{crc}");
        QVERIFY2(found.startsWith("a.axcal is not a valid record: " + reason.left(split))
                && found.endsWith(split < 0 ? reason : reason.mid(split + 5)),
            found.constData());
    }

    void halfARecordIsNone()
    {
        const std::string text = recordText(test::fullRecord());
        for (std::size_t length = 0; length + 1 < text.size(); length += 97)
            VERIFY_ERROR(
                recordFromText(text.substr(0, length), "a.axcal"), ErrorCode::InvalidRecord);
    }

    void itIsNotReadDeeperThanItIs()
    {
        const std::string deep = R"({"format":"axiscomp-record","version":1,"x":)"
            + std::string(100'000, '[') + std::string(100'000, ']') + "}";
        VERIFY_ERROR(recordFromText(deep, "a.axcal"), ErrorCode::InvalidRecord);
    }

    void aSavedRecordReplacesTheOldOneWhole()
    {
        QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath(QStringLiteral("a.axcal")).toStdString();
        VERIFY_RESULT(saveRecord(file, {}));
        VERIFY_RESULT(saveRecord(file, test::fullRecord()));
        const auto record = loadRecord(file);
        VERIFY_RESULT(record);
        QCOMPARE(record->before, test::fullRecord().before);
        VERIFY_ERROR(saveRecord(file / "b.axcal", {}), ErrorCode::FileNotWritable);
        VERIFY_ERROR(loadRecord(file / "b.axcal"), ErrorCode::FileNotReadable);
    }

    void theFiguresAreMadeOfWhatIsUsed()
    {
        RecordedMeasurement recorded{
            {test::recordedFile("runs", test::publicMeasurement("ess_mcu1025.csv"))}};
        recorded.exclusions = {{Approach::Down, 1, 1}, {Approach::Down, 2, 1}};
        const auto used = usedMeasurement(recorded);
        VERIFY_RESULT(used);
        QCOMPARE(used->excludedCount(), std::size_t{2});
        const FigureValues figures = figureValues(iso230Figures(*used));
        QVERIFY(std::abs(*figures[Iso230Figure::A] - 0.0892653) < 1e-6);
        QVERIFY(std::abs(*figures[Iso230Figure::R] - 0.0582781) < 1e-6);
        recorded.swapsDirections = true;
        VERIFY_RESULT(usedMeasurement(recorded));
        recorded.exclusions = {{std::nullopt, 99, std::nullopt}};
        VERIFY_ERROR(usedMeasurement(recorded), ErrorCode::InvalidArgument);
    }

    void recordsAreAsTheInstalledSchemaSays()
    {
        QTemporaryDir folder;
        const QString full = folder.filePath(QStringLiteral("full.axcal"));
        const QString empty = folder.filePath(QStringLiteral("empty.axcal"));
        VERIFY_RESULT(saveRecord(full.toStdString(), test::fullRecord()));
        VERIFY_RESULT(saveRecord(empty.toStdString(), {}));
        QProcess python;
        python.start(QStringLiteral("/usr/bin/python3"),
            {QStringLiteral(AXISCOMP_SOURCE_FOLDER "/tests/core/metrology/record/check_schema.py"),
                QStringLiteral(AXISCOMP_SOURCE_FOLDER "/resources/schemas/axcal.schema.json"),
                QStringLiteral("--strict"), full, empty});
        QVERIFY(python.waitForFinished(120000));
        if (python.exitCode() == 77)
            QSKIP("python3-jsonschema is not installed");
        QVERIFY2(python.exitCode() == 0, python.readAllStandardError().constData());
    }
};

AXISCOMP_TEST(TestCalibrationRecord)

} // namespace tst_calibrationrecord

#include "tst_calibrationrecord.moc"
