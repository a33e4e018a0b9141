// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/neutral/drive_note.h"
#include "core/neutral/lookup_note.h"
#include "core/neutral/sign_note.h"
#include "tests/core/csv/csv_reading.h"

#include "tests/support/test_registry.h"

namespace tst_longcsv {

using namespace axiscomp;
using test::describe;
using test::parse;

namespace {

constexpr int columns = 200;
constexpr int rows = 100;

/// 200 x 100 points in two dimensions with three columns of values: long enough for what reads rows
/// at once. Line 2 is the first point.
QByteArray longText(const QByteArray& lineEnd, int changedPoint = -1, const QByteArray& change = {})
{
    QByteArray text = "X [mm],Y [mm],A,B,C" + lineEnd;
    for (int i = 0; i < columns * rows; ++i) {
        const int x = i % columns;
        const int y = i / columns;
        QByteArray line = QByteArray::number(x * 0.5) + ',' + QByteArray::number(y * 2) + ','
            + QByteArray::number(1e-5 * x) + ',' + QByteArray::number(-1e-5 * y) + ','
            + QByteArray::number(1e-6 * (x + y));
        if (i == changedPoint)
            line = change;
        text += line + lineEnd;
    }
    return text;
}

} // namespace

class TestLongCsv : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void everyValueIsWhereItBelongs_data()
    {
        QTest::addColumn<QByteArray>("lineEnd");
        QTest::newRow("LF") << QByteArray("\n");
        QTest::newRow("CR LF") << QByteArray("\r\n");
        QTest::newRow("CR") << QByteArray("\r");
    }
    void everyValueIsWhereItBelongs()
    {
        QFETCH(QByteArray, lineEnd);
        const CsvReading reading = parse(longText(lineEnd), 2);
        QCOMPARE(describe(reading), QByteArrayList{});
        QVERIFY(reading.data);
        for (int i = 0; i < columns * rows; ++i) {
            const auto index = static_cast<std::size_t>(i);
            const int x = i % columns;
            const int y = i / columns;
            const std::array expected{1e-5 * x, -1e-5 * y, 1e-6 * (x + y)};
            for (std::size_t n = 0; n < expected.size(); ++n)
                // As printed, with six digits.
                QCOMPARE(reading.data->tables[n].values[index],
                    QByteArray::number(expected[n]).toFloat());
        }
    }

    /// 30 comments of 64 KiB and then the statements: only what changes no number is left out.
    void commentsBeyondAMegabyteAreNotKept()
    {
        QByteArray text = "X [mm],Y [mm],E [mm]\n";
        for (int n = 0; n < 30; ++n)
            text += "// " + QByteArray(65536, static_cast<char>('a' + n % 26)) + '\n';
        text += "// target: Y\n// sign: command,\n// lookup: set,,\n"
                "// drive: Mill, serial number 4711\n0,0,0.001\n1,0,0.002\n0,1,0.003\n1,1,0.004\n";
        const CsvReading reading = parse(text, 2);
        QCOMPARE(describe(reading),
            QByteArrayList{"18:0 DroppedComments 14 more comment lines|at most 1 MiB of comments"});
        QVERIFY(reading.data);
        const std::vector<std::string>& notes = reading.data->notes;
        QCOMPARE(notes.size(), std::size_t{19});
        QCOMPARE(reading.data->tables[0].target, std::string("Y"));
        QCOMPARE(signOfTable(notes, {}).value(), std::optional(SignConvention::Command));
        QCOMPARE(lookupInNotes(notes).value(), std::optional(LookupAt::Set));
        QCOMPARE(measuredDriveInNotes(notes).value(), std::optional(4711));
    }

    void aProblemIsInItsLine_data()
    {
        QTest::addColumn<QByteArray>("lineEnd");
        QTest::addColumn<QByteArray>("values");
        QTest::addColumn<QByteArray>("problem");
        for (const auto& [name, lineEnd] :
            {std::pair("LF", "\n"), std::pair("CR LF", "\r\n"), std::pair("CR", "\r")}) {
            for (const auto& [values, problem] :
                std::initializer_list<std::pair<const char*, const char*>>{
                    {"1e39,0,0", ":3 NotFinite 1e39|"}, {"0,-3.5e38,0", ":4 NotFinite -3.5e38|"},
                    {"0,0,1e999", ":5 NotFinite 1e999|"}, {"0,nan,0", ":4 NotFinite nan|"},
                    {"0,x,0", ":4 NotANumber x|"}})
                QTest::addRow("%s, %s", name, values)
                    << QByteArray(lineEnd) << QByteArray(values) << QByteArray(problem);
        }
    }
    void aProblemIsInItsLine()
    {
        QFETCH(QByteArray, lineEnd);
        QFETCH(QByteArray, values);
        QFETCH(QByteArray, problem);
        for (const int point : {0, 1, 777, 12'345, columns * rows - 1}) {
            const QByteArray place = QByteArray::number(point % columns * 0.5) + ','
                + QByteArray::number(point / columns * 2) + ',';
            const CsvReading reading = parse(longText(lineEnd, point, place + values), 2);
            const QByteArrayList problems = describe(reading);
            QCOMPARE(problems.size(), 1);
            const QByteArray expected = QByteArray::number(point + 2) + problem;
            QVERIFY2(problems.front().startsWith(expected),
                (problems.front() + " instead of " + expected).constData());
            QVERIFY(!reading.data);
        }
    }

    /// Positions of 11 characters that begin with the same eight.
    void longPositionsThatBeginAlikeAreToldApart_data()
    {
        QTest::addColumn<int>("alike");
        QTest::newRow("two") << 2;
        QTest::newRow("a hundred") << 100;
    }
    void longPositionsThatBeginAlikeAreToldApart()
    {
        QFETCH(int, alike);
        QByteArray text = "X [mm],Y [mm],A\n";
        constexpr int lines = 3000;
        for (int i = 0; i < lines; ++i)
            text += "100.0000" + QByteArray::number(100 + i % alike) + ','
                + QByteArray::number(i / alike) + ",0.00" + QByteArray::number(i % 2 + 1) + '\n';
        const CsvReading reading = parse(text, 2);
        QVERIFY(reading.data);
        QCOMPARE(reading.data->grid.axes[0].size, static_cast<std::uint32_t>(alike));
        QCOMPARE(reading.data->tables[0].values.size(), static_cast<std::size_t>(lines));
    }

    void theFinestPrintedDecimalSaysHowEvenPositionsMustBe()
    {
        const CsvReading reading = parse("X [mm],A\n0.000,0\n1.008,0\n2,0.001\n", 1);
        QVERIFY(!reading.data);
        QVERIFY(!describe(reading).isEmpty());
        QVERIFY(describe(reading).front().contains("UnevenSpacing"));
    }

    void theLargestFloatIsNoProblem()
    {
        const QByteArray place = QByteArray::number(777 % columns * 0.5) + ','
            + QByteArray::number(777 / columns * 2) + ',';
        const CsvReading reading = parse(longText("\n", 777, place + "3.4028234e38,0,0"), 2);
        QVERIFY(reading.data);
        QCOMPARE(reading.data->tables[0].values[777], 3.4028234e38F);
    }
};

AXISCOMP_TEST(TestLongCsv)

} // namespace tst_longcsv

#include "tst_longcsv.moc"
