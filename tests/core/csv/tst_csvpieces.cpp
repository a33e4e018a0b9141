// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/scan.h"
#include "tests/core/csv/csv_reading.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <algorithm>
#include <random>

namespace tst_csvpieces {

using namespace axiscomp;
using test::describe;
using test::parse;

namespace {

constexpr std::size_t whole = std::size_t{1} << 18U;

CsvReading readIn(const QByteArray& text, int dimensions, std::size_t pieceBytes,
    std::size_t threads, CsvOptions options = {})
{
    options.pieceBytes = pieceBytes;
    options.threads = threads;
    return parse(text, dimensions, options);
}

bool isSame(const CsvReading& a, const CsvReading& b)
{
    if (a.diagnostics != b.diagnostics || a.suppressed != b.suppressed || a.fullGrid != b.fullGrid
        || a.data.has_value() != b.data.has_value())
        return false;
    return !a.data
        || (a.data->grid == b.data->grid && a.data->tables == b.data->tables
            && a.data->notes == b.data->notes);
}

/// Lines are read at once only where more text follows: this is the text.
QByteArray longEnd()
{
    return "// " + QByteArray(220, '.') + '\n';
}

QByteArrayList planeLines(int columns, int rows)
{
    QByteArrayList lines;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x)
            lines += QByteArray::number(x * 0.25 - 1) + ',' + QByteArray::number(y * 5) + ','
                + QByteArray::number(1e-5 * ((x * 7 + y * 3) % 11 - 5));
    return lines;
}

/// The same plane, of as many rows as columns, so that no position repeats before each has come up.
QByteArrayList diagonalLines(int columns)
{
    const QByteArrayList plane = planeLines(columns, columns);
    QByteArrayList lines;
    for (int shift = 0; shift < columns; ++shift)
        for (int x = 0; x < columns; ++x)
            lines += plane[(x + shift) % columns * columns + x];
    return lines;
}

QByteArray planeText(const QByteArrayList& lines, const QByteArray& lineEnd = "\n")
{
    return "X [mm],Y [mm],E [mm]" + lineEnd + lines.join(lineEnd) + lineEnd + longEnd();
}

QByteArrayList shuffled(QByteArrayList lines)
{
    std::mt19937 random(5); // NOLINT: the same order every time
    std::ranges::shuffle(lines, random);
    return lines;
}

} // namespace

class TestCsvPieces : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    /// Pieces may end within a number, between CR and LF, in a comment, in a quoted cell: whatever
    /// they are, the same comes out.
    void whereAPieceEndsDoesNotMatter_data()
    {
        QTest::addColumn<int>("dimensions");
        QTest::addColumn<QByteArray>("text");
        const auto row = [](const char* name, int dimensions, const QByteArray& text) {
            QTest::newRow(name) << dimensions << text;
        };
        const QByteArrayList plane = planeLines(4, 3);
        row("LF", 2, planeText(plane));
        row("CR LF", 2, planeText(plane, "\r\n"));
        row("CR", 2, planeText(plane, "\r"));
        row("blank lines", 2, planeText(plane, "\n\n \n"));
        row("comments", 2, planeText(plane, "\n// between, the lines\n"));
        row("random order", 2, planeText(shuffled(plane)));
        row("byte-order mark", 2, "\xEF\xBB\xBF" + planeText(plane));
        row("Windows-1252", 2, planeText(plane, "\n// 20 \xB0\n"));
        row("a point twice", 2, planeText(plane + plane.mid(2, 3)));
        row("a point less", 2, planeText(plane.mid(0, 7) + plane.mid(8)));
        row("a word", 2, planeText(plane.mid(0, 7) + QByteArrayList{"x,10,0"} + plane.mid(7)));
        row("a column more", 2, planeText(plane.mid(0, 7) + QByteArrayList{"1,2,3,4"}));
        row("an open quote", 2, planeText(plane.mid(0, 7) + QByteArrayList{"1,\"2,3"}));
        row("quotes, blanks, exponents", 2,
            planeText({"\"0\", 0,1e-3", "1,0 ,+2e-3", "0,\t1,\"-1.5E-3\"", "1,1,0.0000"}));
        row("no end of the last line", 1, "X,T\n0,0\n1,1e-3\n2,2e-3\n// " + QByteArray(300, '.'));
        row("one dimension", 1, "X,T,U\n0,0,1\n1.5,1e-3,1\n3,2e-3,2\n" + longEnd());
        row("three dimensions", 3,
            "X,Y,Z,T\n0,0,0,1\n1,0,0,2\n0,1,0,1\n1,1,0,2\n0,0,2,1\n1,0,2,2\n0,1,2,1\n1,1,2,2\n"
                + longEnd());
        row("decimal commas, the first one late", 1,
            "X;T\n0;0\n1;0\n2;0\n3;0\n4;0,001\n5;0,002\n" + longEnd());
        row("a decimal point below commas", 1,
            "X;T\n0;0\n1;0,001\n2;0,002\n3;0.001\n4;0,001\n" + longEnd());
        row("long numbers", 2,
            "X,Y,T\n-49.999999999999996,0,1.2345678901234567890123456789e-3\n"
            "0.00000000000000000000,0,1\n-49.999999999999996,1.00000000000000000001,2\n"
            "0.00000000000000000000,1.00000000000000000001,3\n"
                + longEnd());
        row("a plane read as a line", 1, planeText(plane));
        row("scattered", 2, planeText({"0.1,0.2,0", "1.3,7,0", "2.7,4.4,0", "9,8.5,0"}));
    }
    void whereAPieceEndsDoesNotMatter()
    {
        QFETCH(int, dimensions);
        QFETCH(QByteArray, text);
        const CsvReading due = readIn(text, dimensions, whole, 1);
        for (qsizetype bytes = 1; bytes < text.size(); ++bytes) {
            const CsvReading reading =
                readIn(text, dimensions, static_cast<std::size_t>(bytes), 1 + bytes % 3);
            QVERIFY2(isSame(reading, due),
                ("pieces of " + QByteArray::number(bytes) + ": " + describe(reading).join("; ")
                    + " instead of " + describe(due).join("; "))
                    .constData());
        }
    }

    void anyNumberOfThreadsReadsTheSameBits_data()
    {
        QTest::addColumn<bool>("isShuffled");
        QTest::newRow("in order") << false;
        QTest::newRow("in random order") << true;
    }
    void anyNumberOfThreadsReadsTheSameBits()
    {
        QFETCH(bool, isShuffled);
        const QByteArrayList lines = planeLines(150, 140);
        const QByteArray text = planeText(isShuffled ? shuffled(lines) : lines);
        const CsvReading due = readIn(text, 2, whole, 1);
        QCOMPARE(describe(due), QByteArrayList{});
        QVERIFY(due.data);
        for (const std::size_t threads : {1, 2, 3, 7})
            for (const std::size_t bytes : {500, 4096, 65536})
                QVERIFY(isSame(readIn(text, 2, bytes, threads), due));
    }

    /// Line 1 is the header. The same points are in other pieces, and their first lines in none of
    /// the order in which they are found again.
    void duplicatesOfOtherPiecesAreNamedWithBothLines()
    {
        QByteArrayList lines = planeLines(100, 100);
        lines[9000] = lines[4321];
        lines[9500] = lines[17];
        lines[9999] = lines[4321];
        for (const std::size_t threads : {1, 2, 3, 7}) {
            const QByteArrayList problems = describe(readIn(planeText(lines), 2, 1000, threads));
            QCOMPARE(problems.size(), 4);
            QVERIFY(problems[0].startsWith(
                "9002:0 DuplicatePoint X = 4.25 mm, Y = 215 mm in line 4323 and again in line "
                "9002|"));
            QVERIFY(problems[1].startsWith(
                "9502:0 DuplicatePoint X = 3.25 mm, Y = 0 mm in line 19 and again in line 9502|"));
            QVERIFY(problems[2].startsWith(
                "10001:0 DuplicatePoint X = 4.25 mm, Y = 215 mm in line 4323 and again in line "
                "10001|"));
            QVERIFY(problems[3].startsWith("0:0 MissingPoint"));
            QVERIFY(problems[3].contains("missing: 3 of 10000 points"));
        }
    }

    void problemsOfAllPiecesComeInTheOrderOfTheFile()
    {
        QByteArrayList lines = planeLines(100, 100);
        for (qsizetype i = 50; i < lines.size(); i += 100)
            lines[i] = "x,0,0";
        for (const std::size_t threads : {1, 3}) {
            const CsvReading reading = readIn(planeText(lines), 2, 777, threads);
            QCOMPARE(reading.diagnostics.size(), std::size_t{100});
            QCOMPARE(reading.suppressed, std::size_t{0});
            for (std::size_t n = 0; n < reading.diagnostics.size(); ++n)
                QCOMPARE(reading.diagnostics[n].line, 100 * n + 52);
        }
    }

    /// 10 000 lines of three columns are 30 000 cells.
    void tooManyLinesAreRefusedAtTheFirstThatIsTooMuch()
    {
        const QByteArray text = planeText(planeLines(100, 100));
        for (const std::size_t rows : {1, 2, 333, 9998, 9999}) {
            CsvOptions options;
            options.maximumCells = 3 * rows + 2;
            for (const std::size_t bytes : {std::size_t{50}, std::size_t{5000}, whole}) {
                const CsvReading reading = readIn(text, 2, bytes, 2, options);
                QCOMPARE(describe(reading),
                    QByteArrayList{QByteArray::number(rows + 2) + ":0 TooLarge more than "
                        + QByteArray::number(rows) + " data lines of 3 columns|at most "
                        + QByteArray::number(3 * rows + 2) + " cells (lines x columns)"});
                QVERIFY(!reading.data);
            }
        }
        CsvOptions options;
        options.maximumCells = 30'000;
        QVERIFY(readIn(text, 2, 5000, 2, options).data);
    }

    /// Each piece of such a file has but a few lines: room for more would be many times the file.
    void wideLinesTakeNoRoomForLinesThatDoNotFollow()
    {
        constexpr std::size_t most = 16384;
        for (const std::size_t tables : {1, 100, 1000, 2000, 16382})
            QVERIFY(csv::RowStore(2, tables).blockRows() * (2 + tables) <= most);
        constexpr int wide = 2000;
        QByteArray text = "X" + QByteArray(",").repeated(wide) + '\n';
        for (int x = 0; x < 60; ++x) {
            text += QByteArray::number(x);
            for (int table = 0; table < wide; ++table)
                text += ',' + QByteArray::number((x * 7 + table * 3) % 10);
            text += '\n';
        }
        const CsvReading due = readIn(text, 1, whole, 1);
        QVERIFY(due.data);
        QCOMPARE(due.data->tables[1999].values[59], 0.0F);
        QCOMPARE(due.data->tables[1998].values[58], 0.0F);
        for (const std::size_t bytes : {1, 4096, 10'000, 100'000})
            QVERIFY(isSame(readIn(text, 1, bytes, 3), due));
    }

    /// Quoted lines are read one by one, plain ones by the threads.
    void aPieceThatIsReadKeepsNoMoreThanItsRows_data()
    {
        QTest::addColumn<QByteArray>("quote");
        QTest::newRow("plain") << QByteArray();
        QTest::newRow("quoted") << QByteArray("\"");
    }
    void aPieceThatIsReadKeepsNoMoreThanItsRows()
    {
        QFETCH(QByteArray, quote);
        QByteArrayList lines;
        for (int i = 0; i < 4000; ++i)
            lines += quote + QByteArray::number(1.5 * i) + quote + ',' + QByteArray::number(7 * i)
                + ",0.001";
        const std::string text = planeText(lines).toStdString();
        CsvOptions options;
        options.dimensions = 2;
        options.pieceBytes = 10'000;
        DiagnosticList diagnostics(100);
        const TextInspection inspection(text, options.stop, diagnostics);
        const csv::Scan scan = csv::scan(inspection, options, diagnostics);
        QVERIFY(scan.complete);
        QCOMPARE(scan.rows, std::size_t{4000});
        for (const csv::Piece& piece : scan.pieces) {
            QCOMPARE(piece.ranges.capacity(), std::size_t{0});
            for (const csv::PositionColumn& positions : piece.positions)
                QCOMPARE(positions.memory(), positions.values().size() * sizeof(double));
        }
    }

    /// Positions that do not repeat in the first rows of a piece are taken for measured ones, and
    /// get a number of their own from then on.
    void positionsThatRepeatLateAreTheSameGrid()
    {
        constexpr int columns = 300;
        QByteArrayList lines = diagonalLines(columns);
        for (qsizetype i = 0; i < lines.size(); i += 97) {
            const qsizetype value = lines[i].lastIndexOf(',') + 1;
            lines[i] = lines[i].left(value) + '"' + lines[i].mid(value) + '"';
        }
        const CsvReading due = readIn(planeText(planeLines(columns, columns)), 2, whole, 1);
        QVERIFY(due.data);
        for (const std::size_t threads : {1, 3}) {
            const CsvReading reading = readIn(planeText(lines), 2, whole, threads);
            QVERIFY2(reading.data, describe(reading).join("; ").constData());
            QCOMPARE(reading.data->grid, due.data->grid);
            QCOMPARE(reading.data->tables, due.data->tables);
        }
        const std::string text = planeText(lines).toStdString();
        CsvOptions options;
        options.dimensions = 2;
        options.pieceBytes = whole;
        DiagnosticList diagnostics(100);
        const TextInspection inspection(text, options.stop, diagnostics);
        const csv::Scan scan = csv::scan(inspection, options, diagnostics);
        QCOMPARE(scan.pieces.front().positions[0].values().size(), scan.pieces.front().rows.size());
        for (const csv::Piece& piece : scan.pieces)
            for (const csv::PositionColumn& positions : piece.positions)
                QVERIFY2(positions.values().size() <= piece.rows.size(),
                    "a line that is read twice has two numbers");
    }

    void pointsMayBeMissingInAnyPiece()
    {
        QByteArrayList lines = planeLines(100, 100);
        for (const qsizetype gone : {9000, 5000, 130})
            lines.removeAt(gone);
        lines[77] = lines[77].left(lines[77].lastIndexOf(',') + 1) + "nan";
        CsvOptions options;
        options.missing = MissingPoints::Nearest;
        const CsvReading due = readIn(planeText(lines), 2, whole, 1, options);
        QVERIFY(due.data);
        QCOMPARE(due.data->tables[0].filled, (std::vector<std::uint32_t>{77, 130, 5000, 9000}));
        for (const std::size_t threads : {1, 2, 3, 7})
            QVERIFY(isSame(readIn(planeText(lines), 2, 1000, threads, options), due));
    }
};

AXISCOMP_TEST(TestCsvPieces)

} // namespace tst_csvpieces

#include "tst_csvpieces.moc"
