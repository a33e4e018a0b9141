// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/csv/csv_reading.h"
#include "tests/support/test_registry.h"

namespace tst_incompletegrid {

using namespace axiscomp;
using test::describe;
using test::parse;

namespace {

CsvOptions with(MissingPoints missing, double snap = 0.0)
{
    CsvOptions options;
    options.missing = missing;
    options.snap = snap;
    return options;
}

/// A round bed as a probe leaves it: the corners have no line, one point has no value.
const QByteArray bed = "X [mm],Y [mm],Z [um]\r\n"
                       "10,0,1\r\n20,0,2\r\n"
                       "0,10,3\r\n10,10,\r\n20,10,5\r\n30,10,6\r\n"
                       "0,20,7\r\n10,20,8\r\n20,20,9\r\n30,20,10\r\n"
                       "10,30,11\r\n20,30,12\r\n";

/// Positions as an encoder reads them.
const QByteArray measured = "X [mm],Y [mm],Z [um]\n"
                            "0.0001,-0.0002,1\n9.9998,0,2\n20.0001,0.0001,3\n"
                            "-0.0001,49.9999,4\n10.0002,50.0001,5\n20,50,6\n";

/// "12.345678,", within 0.0005 of the position, and each another one.
QByteArray measuredAt(double position, int n)
{
    return QByteArray::number(position + ((n * 337) % 1000 - 500) * 1e-6, 'f', 6) + ',';
}

/// Three positions without a pattern, of which none comes up again.
QByteArray scatteredAt(int n)
{
    QByteArray text;
    for (const qint64 step : {7919, 104'729, 15'485'863}) {
        const auto place = static_cast<double>((n + 1) * step % 899'981);
        text += QByteArray::number(100 + place * 1e-3, 'f', 3) + ',';
    }
    return text;
}

} // namespace

class TestIncompleteGrid : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void gapsAreRefusedWithTheWayOut()
    {
        const CsvReading reading = parse(bed, 2);
        QVERIFY(!reading.data);
        QCOMPARE(describe(reading),
            (QByteArrayList{
                "5:3 NotANumber |a number such as 0.5; points without a value can be filled or "
                "left out (--fill, --crop, or Missing points in the import)",
                "0:0 MissingPoint no line for X = 0 mm, Y = 0 mm; X = 30 mm, Y = 0 mm; X = 0 mm, "
                "Y = 30 mm; ... (missing: 4 of 16 points)|every combination of the positions; "
                "missing points can be filled or left out (--fill, --crop, or Missing points in "
                "the import)"}));
    }

    void gapsAreFilledAndMarked()
    {
        const CsvReading reading = parse(bed, 2, with(MissingPoints::Nearest));
        QVERIFY2(reading.data, describe(reading).join('\n').constData());
        const CompensationTable& table = reading.data->tables.front();
        QCOMPARE(table.grid.pointCount(), 16U);
        QCOMPARE(table.values.size(), 16U);
        QCOMPARE(table.filled, (std::vector<std::uint32_t>{0, 3, 5, 12, 15}));
        QCOMPARE(table.values[6], 5.0F); // measured ones stay
        QCOMPARE(table.values[13], 11.0F);
        QCOMPARE(reading.data->notes,
            (std::vector<std::string>{"5 of 16 points of Z are filled, not measured"}));
        QCOMPARE(reading.diagnostics.back().code, DiagnosticCode::FilledPoints);
    }

    /// No line of the file can be named for it: the point has none.
    void aSteepStepToAFilledPointHasNoLine()
    {
        const QByteArray text = "X [mm],Y [mm],T\n0,0,0\n3,0,9\n0,1,0\n1,1,0\n2,1,9\n3,1,9\n";
        const CsvReading reading = parse(text, 2, with(MissingPoints::Nearest));
        QVERIFY(reading.data);
        QVERIFY(describe(reading).join('\n').contains("0:3 LargeGradient"));
        QVERIFY(describe(parse("X,T\n0,0\n1,9\n", 1)).join('\n').contains("3:2 LargeGradient"));
    }

    void theGridIsCropped()
    {
        const CsvReading reading = parse(bed, 2, with(MissingPoints::Crop));
        QVERIFY2(reading.data, describe(reading).join('\n').constData());
        const CompensationTable& table = reading.data->tables.front();
        QCOMPARE(table.values, (std::vector<float>{5, 6, 9, 10}));
        QVERIFY(table.filled.empty());
        QCOMPARE(table.grid.axes[0].start, 20.0);
        QCOMPARE(table.grid.axes[0].size, 2U);
        QCOMPARE(table.grid.axes[1].start, 10.0);
        QCOMPARE(reading.data->grid, table.grid);
    }

    void emptyCellsNanAndNaAreNoValue_data()
    {
        QTest::addColumn<QByteArray>("cell");
        for (const char* cell : {"", " ", "nan", "NaN", "#N/A", "\"\""})
            QTest::newRow(cell) << QByteArray(cell);
    }
    void emptyCellsNanAndNaAreNoValue()
    {
        QFETCH(const QByteArray, cell);
        const QByteArray text = "X;E\n0;1,5\n10;" + cell + "\n20;3,5\n";
        QVERIFY(!parse(text, 1).data);
        const CsvReading reading = parse(text, 1, with(MissingPoints::Plane));
        QVERIFY2(reading.data, describe(reading).join('\n').constData());
        QCOMPARE(reading.data->tables[0].values, (std::vector<float>{1.5F, 2.5F, 3.5F}));
    }

    void wordsAndMissingPositionsStayErrors()
    {
        const CsvReading reading = parse("X,E\n0,1\n10,none\n,3\n", 1, with(MissingPoints::Smooth));
        QVERIFY(!reading.data);
        QCOMPARE(reading.diagnostics.size(), 2U);
        QCOMPARE(reading.diagnostics[0].line, 3U);
        QCOMPARE(reading.diagnostics[1].line, 4U);
    }

    void measuredPositionsAreRefusedWithTheToleranceThatWouldDo()
    {
        const CsvReading reading = parse(measured, 2);
        QVERIFY(!reading.data);
        const QByteArray all = describe(reading).join('\n');
        QVERIFY2(
            all.contains("a tolerance of 0.0002 takes them for an even grid"), all.constData());
        const CsvReading taken = parse(measured, 2, with(MissingPoints::Refuse, 0.0002));
        QVERIFY2(taken.data, describe(taken).join('\n').constData());
    }

    void noToleranceIsProposedThatMakesOneOfTwoPositions()
    {
        const QByteArray all =
            describe(parse("X;T\n0;0\n1.0;4\n1.25;5\n250;1\n500;2\n750;3\n", 1)).join('\n');
        QVERIFY2(all.contains("UnevenSpacing"), all.constData());
        QVERIFY2(!all.contains("a tolerance of"), all.constData());
    }

    void measuredPositionsSnapToTheRoundestGrid()
    {
        const CsvReading reading = parse(measured, 2, with(MissingPoints::Refuse, 0.001));
        QVERIFY2(reading.data, describe(reading).join('\n').constData());
        const Grid& grid = reading.data->grid;
        QCOMPARE(grid.axes[0].start, 0.0);
        QCOMPARE(grid.axes[0].distance, 10.0);
        QCOMPARE(grid.axes[0].size, 3U);
        QCOMPARE(grid.axes[1].start, 0.0);
        QCOMPARE(grid.axes[1].distance, 50.0);
        QCOMPARE(reading.data->tables[0].values, (std::vector<float>{1, 2, 3, 4, 5, 6}));
        const QByteArray all = describe(reading).join('\n');
        QVERIFY2(all.contains("X is taken for 0 to 20 mm in steps of 10 mm; the largest shift is "
                              "0.0002 mm, at X = 10 mm"),
            all.constData());
    }

    void aPositionBeyondTheToleranceIsNotMoved()
    {
        QVERIFY(!parse(measured, 2, with(MissingPoints::Refuse, 0.0001)).data);
        // 0, 10.0002 and 20 are no even grid within 0.00005, nor 0 and 0.00015 one position.
        const QByteArray line = "X,E\n0,1\n10.0002,2\n20,3\n";
        QVERIFY(!parse(line, 1, with(MissingPoints::Refuse, 0.00005)).data);
        QVERIFY(parse(line, 1, with(MissingPoints::Refuse, 0.0002)).data);
    }

    void positionsThatChainBeyondTheToleranceAreNotOne()
    {
        // Each is within 0.2 of the next, all of them are not within 0.1 of one place.
        const CsvReading reading = parse(
            "X,Y,E\n0,0,1\n0.15,10,2\n0.3,20,3\n0.45,30,4\n10,0,5\n10,10,6\n10,20,7\n10,30,8\n", 2,
            with(MissingPoints::Refuse, 0.1));
        QVERIFY(!reading.data);
    }

    void twoLinesOfOneSnappedPointAreADuplicate()
    {
        const CsvReading reading =
            parse("X,E\n0,1\n10,2\n10.0001,2\n20,3\n", 1, with(MissingPoints::Refuse, 0.001));
        QVERIFY(!reading.data);
        QVERIFY(std::ranges::count(
                    reading.diagnostics, DiagnosticCode::DuplicatePoint, &Diagnostic::code)
            == 1);
    }

    void gapsOfMeasuredPositionsAreFilledToo()
    {
        const QByteArray text = QByteArray(measured).replace("10.0002,50.0001,5\n", "");
        const CsvReading reading = parse(text, 2, with(MissingPoints::Plane, 0.001));
        QVERIFY2(reading.data, describe(reading).join('\n').constData());
        QCOMPARE(reading.data->tables[0].filled, (std::vector<std::uint32_t>{4}));
        QCOMPARE(reading.data->tables[0].values[4], 5.0F); // all lie on one plane
    }

    void scatteredPositionsAreNoGridWithGaps()
    {
        QByteArray text = "X,Y,E\n";
        for (int i = 0; i < 60; ++i)
            text += QByteArray::number(i * i * 0.37) + ',' + QByteArray::number((i * 37) % 61 * 1.3)
                + ",1\n";
        CsvOptions options = with(MissingPoints::Nearest);
        QVERIFY(!parse(text, 2, options).data);
        options.maximumCells = 3000; // 60 x 60 points would be more
        options.acceptsUneven = true;
        const CsvReading reading = parse(text, 2, options);
        QVERIFY(!reading.data);
        QCOMPARE(reading.diagnostics.back().code, DiagnosticCode::MissingPoint);
    }

    /// 300 positions of each axis are 27 million points; 16 million lines may be read.
    void scatteredPositionsAreRefusedByTheFirstLines_data()
    {
        QTest::addColumn<int>("lines");
        QTest::addColumn<int>("read");
        QTest::newRow("few") << 300 << 300;
        // Lines of 30 bytes, up to 256 KiB; what follows is not looked at.
        QTest::newRow("many") << 30'000 << 8739;
    }
    void scatteredPositionsAreRefusedByTheFirstLines()
    {
        QFETCH(int, lines);
        QFETCH(int, read);
        QByteArray text = "X [mm],Y [mm],Z [mm],E [um]\n";
        for (int i = 0; i < lines; ++i)
            text += scatteredAt(i) + "0.001\n";
        const QByteArrayList problems = describe(parse(text, 3));
        QCOMPARE(problems.size(), 1);
        QVERIFY2(problems[0].startsWith("0:0 MissingPoint positions with "), problems[0]);
        QVERIFY2(problems[0].contains(" in the first " + QByteArray::number(read) + " data lines|"),
            problems[0]);
        QVERIFY2(problems[0].endsWith("fit makes a table of scattered points (or is the "
                                      "dimensionality 1?)"),
            problems[0]);
        for (const std::size_t bytes : {1000, 100'000}) {
            CsvOptions options;
            options.pieceBytes = bytes;
            QCOMPARE(describe(parse(text, 3, options)), problems);
        }
    }

    void manyMeasuredPositionsOfAGridAreNotScattered()
    {
        QByteArray text = "X [mm],Y [mm],Z [mm],E [um]\n";
        for (int i = 0; i < 1000; ++i)
            text += measuredAt(10 * (i % 10), i) + measuredAt(10 * (i / 10 % 10), i + 300)
                + measuredAt(10 * (i / 100), i + 600) + "0.001\n";
        const CsvReading refused = parse(text, 3);
        QVERIFY(!refused.data);
        QCOMPARE(refused.diagnostics.front().code, DiagnosticCode::UnevenSpacing);
        const QByteArray first = describe(refused).front();
        QVERIFY2(first.contains("a tolerance of 0.0005 takes them for an even grid"), first);
        const CsvReading reading = parse(text, 3, with(MissingPoints::Refuse, 0.0005));
        QVERIFY2(reading.data, describe(reading).join('\n').constData());
        QCOMPARE(reading.data->grid.pointCount(), 1000U);
    }
};

AXISCOMP_TEST(TestIncompleteGrid)

} // namespace tst_incompletegrid

#include "tst_incompletegrid.moc"
