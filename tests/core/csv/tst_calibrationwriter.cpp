// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/target_axis.h"
#include "tests/core/csv/csv_reading.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <random>

namespace tst_calibrationwriter {

using namespace axiscomp;
using test::describe;
using test::parse;

namespace {

CsvReading reparse(const CalibrationData& data)
{
    return parse(QByteArray::fromStdString(writeCalibrationCsv(data)), data.grid.dimensions());
}

} // namespace

class TestCalibrationWriter : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    /// 30 000 points are several pieces, the last one a part of one.
    void anyNumberOfThreadsWritesTheSameBytes()
    {
        std::mt19937 random(3); // NOLINT: the same table every time
        CalibrationData data{{{{"X", "mm", -3.1, 0.1, 300}, {"Y", "mm", 7.0, 2.5, 100}}}, {}, {}};
        for (const char* name : {"T", "U"}) {
            CompensationTable& table = data.tables.emplace_back();
            table.name = name;
            table.grid = data.grid;
            while (table.values.size() < data.grid.pointCount()) {
                const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
                table.values.push_back(std::isfinite(value) ? value : 0.0F);
            }
        }
        const std::string due = writeCalibrationCsv(data, 1);
        for (const std::size_t threads : {0, 2, 3, 7})
            QVERIFY(writeCalibrationCsv(data, threads) == due);
        const CsvReading reading = parse(QByteArray::fromStdString(due), 2);
        QVERIFY(reading.data);
        QVERIFY(reading.data->grid == data.grid);
        for (std::size_t n = 0; n < data.tables.size(); ++n)
            QVERIFY(reading.data->tables[n].values == data.tables[n].values);
    }

    void notesThatStateATargetDoNotOverruleThatOfTheTable_data()
    {
        QTest::addColumn<std::string>("target");
        QTest::addColumn<std::string>("name");
        QTest::addColumn<std::string>("note");
        const std::string index = "#1";
        const std::string header = "X";
        const std::string named = "X error";
        const std::string plain = "T";
        const std::string cable = "Target: 2 um";
        const std::string hidden = "first line\n target: Y";
        QTest::newRow("stated") << index << plain << cable;
        QTest::newRow("by the header") << header << named << cable;
        QTest::newRow("in a second line") << header << named << hidden;
    }
    void notesThatStateATargetDoNotOverruleThatOfTheTable()
    {
        QFETCH(const std::string, target);
        QFETCH(const std::string, name);
        QFETCH(const std::string, note);
        CalibrationData data{{{{"X", "mm", 0, 1, 2}}}, {}, {note}};
        data.tables.push_back({name, "mm", data.grid, {1.0F, 2.0F}, target});
        const CsvReading reading = reparse(data);
        QVERIFY2(reading.data, describe(reading).join('\n').constData());
        QCOMPARE(targetOf(reading.data->tables[0]), targetOf(data.tables[0]));
        QCOMPARE(reading.data->notes.back(),
            "note: " + note.substr(note.find('\n') + 1)); // it is kept as a mere text
    }

    /// A statement that is not understood is said again when the file is read again.
    void aTargetThatIsNotKnownStaysANote()
    {
        const std::string note = "target: X2, Y, Z";
        CalibrationData data{{{{"Dim 1", "mm", 0, 1, 2}}}, {}, {note}};
        data.tables.push_back({"T", "mm", data.grid, {1.0F, 2.0F}});
        const CsvReading reading = reparse(data);
        QVERIFY(reading.data);
        QCOMPARE(reading.data->notes, std::vector<std::string>{note});
    }

    /// An empty statement would be a note for the reader, and the name says the axis as before.
    void aTargetThatOnlyTheNameSaysIsNotWrittenAsNone()
    {
        CalibrationData data{{{{"X", "mm", 0, 1, 2}}}, {}, {}};
        data.tables.push_back({"Y error", "mm", data.grid, {1.0F, 2.0F}});
        QVERIFY(writeCalibrationCsv(data).find("target") == std::string::npos);
        data.tables.push_back({"T", "mm", data.grid, {1.0F, 2.0F}, "Z"});
        const CsvReading reading = reparse(data);
        QVERIFY(reading.data);
        QCOMPARE(reading.data->tables[0].target, "Y");
        QCOMPARE(reading.data->tables[1].target, "Z");
        QVERIFY(reading.data->notes.empty());
    }

    void everyWayToWriteAGridGivesTheSameTable()
    {
        std::mt19937 random(17);
        const auto below = [&random](int limit) {
            return std::uniform_int_distribution<int>(0, limit - 1)(random);
        };
        for (int round = 0; round < 400; ++round) {
            const int dimensions = 1 + round % 3;
            CalibrationData data;
            for (int d = 0; d < dimensions; ++d)
                data.grid.axes.push_back({std::string(1, static_cast<char>('X' + d)), "mm",
                    (below(2001) - 1000) / 8.0, (1 + below(999)) / 8.0,
                    static_cast<std::uint32_t>(2 + below(dimensions == 1 ? 400 : 9))});
            for (int table = 0; table <= below(3); ++table) {
                data.tables.push_back({"T" + std::to_string(table), "", data.grid, {}});
                for (std::size_t i = 0; i < data.grid.pointCount(); ++i)
                    data.tables.back().values.push_back(
                        std::ldexp(static_cast<float>(below(1 << 24) - (1 << 23)), -30));
            }
            const QByteArray text = disguised(data, random);
            const CsvReading reading = parse(text, dimensions);
            QVERIFY2(reading.data, (describe(reading).join('\n') + '\n' + text).constData());
            QVERIFY2(reading.data->grid == data.grid, text.constData());
            QVERIFY2(reading.data->tables == data.tables, text.constData());
        }
    }

    void writingAndReadingIsExact()
    {
        std::mt19937 random(23);
        std::uniform_real_distribution<double> any(-1.0, 1.0);
        for (int round = 0; round < 200; ++round) {
            CalibrationData data;
            for (int d = 0; d <= round % 3; ++d)
                data.grid.axes.push_back({"A", "", any(random) * std::pow(10, 4 * any(random)),
                    std::fabs(any(random)) + 1e-3, static_cast<std::uint32_t>(2 + round % 7)});
            CompensationTable table{"T", "", data.grid, {}};
            while (table.values.size() < data.grid.pointCount()) {
                const auto bits = static_cast<std::uint32_t>(random());
                float value = 0.0F;
                std::memcpy(&value, &bits, sizeof value);
                if (std::isfinite(value))
                    table.values.push_back(value);
            }
            data.tables.push_back(table);
            const CsvReading first = reparse(data);
            QVERIFY2(first.data, describe(first).join('\n').constData());
            QVERIFY(first.data->tables[0].values == table.values);
            for (std::size_t d = 0; d < data.grid.axes.size(); ++d)
                for (std::size_t i = 0; i < data.grid.axes[d].size; ++i) {
                    const double position = data.grid.axes[d].position(i);
                    QVERIFY(std::fabs(first.data->grid.axes[d].position(i) - position) <= 2e-15
                            * std::max(std::fabs(data.grid.axes[d].start),
                                std::fabs(data.grid.axes[d].last())));
                }
            const CsvReading again = reparse(*first.data);
            QVERIFY(again.data);
            QVERIFY(again.data->tables == first.data->tables);
        }
    }

    void awkwardNamesAndNotesAreWrittenSoThatTheyReadBack()
    {
        const Grid grid{{{"// X", "a;b", 0.0, 1.0, 2}}};
        CalibrationData data{grid, {}, {"first\nsecond", "", "//third", "  "}};
        for (const char* name : {"a,b", "say \"A\"", "B [x]", "5\"", "Größe", "7", "E (um)",
                 "E [um] up", "E/nm", "E in mm"})
            data.tables.push_back({name, "", grid, {0.0F, 0.001F}});
        const CsvReading reading = reparse(data);
        QVERIFY2(reading.data, describe(reading).join('\n').constData());
        QVERIFY(reading.data->tables == data.tables);
        QCOMPARE(
            reading.data->notes, (std::vector<std::string>{"first", "second", "", "//third", ""}));
    }

    void aHeaderOfNumbersIsWrittenAsAHeader()
    {
        const Grid grid{{{"0", "", 0.0, 1.0, 2}}};
        const CsvReading reading = reparse({grid, {{"1", "", grid, {0.0F, 0.001F}}}, {}});
        QVERIFY(reading.data);
        QCOMPARE(reading.data->grid.axes[0].name, "0");
        QCOMPARE(reading.data->tables[0].name, "1");
    }

    void theExampleReadsBackWithoutAWarning_data()
    {
        QTest::addColumn<int>("dimensions");
        QTest::addColumn<int>("tables");
        for (int dimensions = 1; dimensions <= 3; ++dimensions)
            for (const int tables : {1, 2, 25})
                QTest::addRow("%dD, %d tables", dimensions, tables) << dimensions << tables;
    }
    void theExampleReadsBackWithoutAWarning()
    {
        QFETCH(int, dimensions);
        QFETCH(int, tables);
        const std::string text = exampleCalibrationCsv(dimensions, tables);
        const CsvReading reading = parse(QByteArray::fromStdString(text), dimensions);
        QCOMPARE(describe(reading), QByteArrayList{});
        QVERIFY(reading.data);
        QCOMPARE(reading.data->notes.size(), 2U);
        constexpr std::array<std::array<std::uint32_t, 3>, 3> sizes{
            {{11, 0, 0}, {5, 4, 0}, {4, 3, 3}}};
        QCOMPARE(reading.data->grid.dimensions(), dimensions);
        for (std::size_t d = 0; d < reading.data->grid.axes.size(); ++d) {
            QCOMPARE(reading.data->grid.axes[d].size,
                sizes[static_cast<std::size_t>(dimensions) - 1][d]);
            QCOMPARE(reading.data->grid.axes[d].unit, "mm");
        }
        QCOMPARE(static_cast<int>(reading.data->tables.size()), tables);
        for (const CompensationTable& table : reading.data->tables) {
            const TableStatistics found = statistics(table);
            const double largest = std::max(-found.minimum, found.maximum);
            QVERIFY(largest > 0.0005 && largest < 0.01); // millimetres
            QCOMPARE(table.unit, "mm");
        }
        QCOMPARE(writeCalibrationCsv(*reading.data), text);
    }

    void statisticsAreThoseOfTheValues()
    {
        const Grid grid{{{"", "", 0.0, 1.0, 4}}};
        const TableStatistics found = statistics({"", "", grid, {-1.0F, 2.0F, 4.0F, 2.0F}});
        QCOMPARE(found.minimum, -1.0);
        QCOMPARE(found.maximum, 4.0);
        QCOMPARE(found.rms, 2.5);
        QCOMPARE(statistics({}).rms, 0.0);
    }

private:
    /// The same grid in one of the ways that the rules allow.
    static QByteArray disguised(const CalibrationData& data, std::mt19937& random)
    {
        const bool semicolon = random() % 2 == 0;
        const bool comma = semicolon && random() % 2 == 0;
        const bool quotes = random() % 3 == 0;
        const bool blanks = random() % 3 == 0;
        const QByteArray end = std::array<const char*, 3>{"\n", "\r\n", "\r"}[random() % 3];
        const auto cell = [&](double value) {
            QByteArray text = QByteArray::number(value, 'g', 17);
            if (comma)
                text.replace('.', ',');
            if (quotes && random() % 2 == 0)
                text = '"' + text + '"';
            return blanks && random() % 2 == 0 ? " " + text + "\t" : text;
        };
        QByteArrayList names;
        for (const GridAxis& axis : data.grid.axes)
            names += QByteArray::fromStdString(axis.name + " [" + axis.unit + ']');
        for (const CompensationTable& table : data.tables)
            names += QByteArray::fromStdString(table.name);
        const char separator = semicolon ? ';' : ',';

        std::vector<QByteArray> lines(data.grid.pointCount());
        for (std::size_t point = 0; point < lines.size(); ++point) {
            QByteArrayList cells;
            std::size_t rest = point;
            for (const GridAxis& axis : data.grid.axes) {
                cells += cell(axis.position(rest % axis.size));
                rest /= axis.size;
            }
            for (const CompensationTable& table : data.tables)
                cells += cell(static_cast<double>(table.values[point]));
            lines[point] = cells.join(separator);
        }
        order(lines, data.grid.axes.front().size, random);
        QByteArray text = names.join(separator) + end;
        for (const QByteArray& line : lines)
            text += (random() % 40 == 0 ? "// note" + end : "") + line + end;
        if (random() % 2 == 0)
            text.chop(end.size());
        return text;
    }

    static void order(std::vector<QByteArray>& lines, std::uint32_t rowLength, std::mt19937& random)
    {
        const auto row = static_cast<std::ptrdiff_t>(rowLength);
        switch (random() % 4) {
        case 0:
            std::ranges::shuffle(lines, random);
            break;
        case 1:
            std::ranges::reverse(lines);
            break;
        case 2: // serpentine
            for (auto begin = lines.begin() + row; begin < lines.end();
                 begin += std::min(2 * row, lines.end() - begin))
                std::reverse(begin, begin + row);
            break;
        default:
            break;
        }
    }
};

AXISCOMP_TEST(TestCalibrationWriter)

} // namespace tst_calibrationwriter

#include "tst_calibrationwriter.moc"
