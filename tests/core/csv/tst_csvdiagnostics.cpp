// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/csv/csv_reading.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <set>

namespace tst_csvdiagnostics {

using namespace axiscomp;
using test::describe;
using test::parse;

namespace {

bool isSentence(const std::string& text)
{
    return !text.empty() && text.ends_with(')') && text.find("  ") == std::string::npos
        && text.find(", ,") == std::string::npos;
}

} // namespace

class TestCsvDiagnostics : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void everyProblemIsNamedWithItsPlace_data()
    {
        QTest::addColumn<int>("dimensions");
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArrayList>("expected"); // beginnings
        const auto row = [](const char* name, int dimensions, const QByteArray& text,
                             const QByteArrayList& expected) {
            QTest::newRow(name) << dimensions << text << expected;
        };
        row("nothing", 1, "", {"0:0 EmptyFile |"});
        row("only a byte-order mark", 1, "\xEF\xBB\xBF", {"0:0 EmptyFile |"});
        row("only blank lines", 1, " \n\t\r\n", {"0:0 EmptyFile |"});
        row("only comments", 1, "// a\n// b\n", {"0:0 NoHeader |"});
        row("no header", 1, "// a\n0,0.1\n1,0.2\n", {"2:0 NoHeader 0,0.1|"});
        row("no header, decimal comma", 1, "0,5;0,1\n1;0,2\n", {"1:0 NoHeader 0,5;0,1|"});
        row("one column", 1, "X\n1\n", {"1:0 TooFewColumns 1 column|at least 2"});
        row("two columns for a plane", 2, "X,T\n0,1\n",
            {"1:0 TooFewColumns 2 columns|at least 3 for dimensionality 2, 2 of positions and 1 of "
             "values (or is the dimensionality 1?)"});
        row("tabs", 1, "X\tT\n0\t1\n",
            {"1:0 TooFewColumns 1 column|at least 2 for "
             "dimensionality 1, 1 of positions and 1 of values; separate the columns with , or "
             "; instead of tabs"});
        row("two targets", 1, "// target: other\n// target: X\nX,T\n0,1e-3\n1,2e-3\n",
            {"0:0 Contradiction target: X|\"target: other\", as another comment says; leave one of "
             "them out"});
        row("short line", 1, "X,T\n0,1e-3\n1\n2,1e-3,4\n",
            {"3:0 ColumnCount 1 column|2 as in the header (line 1)",
                "4:0 ColumnCount 3 columns|2 as in the header (line 1); if the commas are decimal "
                "commas"});
        row("other separator", 1, "X,T\n0;1\n1;2\n",
            {"2:0 ColumnCount 1 column|2 as in the header (line 1); the header separates its "
             "columns with ,",
                "3:0 ColumnCount 1 column|2"});
        row("tab below commas", 1, "X,T\n0\t1\n",
            {"2:0 ColumnCount 1 column|2 as in the header (line 1); separate the columns with , "
             "instead of tabs"});
        row("words", 1, "X,T\n0,abc\nx,1\n",
            {"2:2 NotANumber abc|a number such as 0.5", "3:1 NotANumber x|a number such as 0.5"});
        row("words below decimal commas", 1, "X;T\n0,5;abc\n1;1\n",
            {"2:2 NotANumber abc|a number such as 0,5"});
        row("both cells of a line", 1, "X,T\nx,y\n", {"2:1 NotANumber x|", "2:2 NotANumber y|"});
        row("empty cells", 1, "X,T\n0,\n,1\n2,\"\"\n",
            {"2:2 NotANumber |", "3:1 NotANumber |", "4:2 NotANumber |"});
        row("an empty position of a plane", 2, "X,Y,T\n0,0,0\n1,,0\n ,1,0\n1,1,0\n",
            {"3:2 NotANumber |", "4:1 NotANumber |"});
        row("hexadecimal", 1, "X,T\n0,0x10\n1,1\n", {"2:2 NotANumber 0x10|"});
        row("trailing text", 1, "X,T\n0,1.5mm\n1,1 5\n",
            {"2:2 NotANumber 1.5mm|", "3:2 NotANumber 1 5|"});
        row("two signs", 1, "X,T\n0,+-5\n1,--5\n2,++5\n3,+\n4,-\n5,.\n6,e5\n7,1e\n",
            {"2:2 NotANumber +-5|", "3:2 NotANumber --5|", "4:2 NotANumber ++5|",
                "5:2 NotANumber +|", "6:2 NotANumber -|", "7:2 NotANumber .|", "8:2 NotANumber e5|",
                "9:2 NotANumber 1e|"});
        row("quoted decimal comma", 1, "X,T\n0,\"0,5\"\n1,1\n",
            {"2:2 NotANumber 0,5|a number such as 0.5; decimal commas need the separator ;"});
        row("not finite", 1, "X,T\n0,nan\n1,INF\n2,-infinity\n3,1e999\n4,-1e39\n",
            {"2:2 NotFinite nan|", "3:2 NotFinite INF|", "4:2 NotFinite -infinity|",
                "5:2 NotFinite 1e999|", "6:2 NotFinite -1e39|a value that fits float32"});
        row("too small", 1, "X,T\n0,1e-400\n1,0\n", {"2:2 NotANumber 1e-400|0 or a number that"});
        row("positions not finite", 1, "X,T\nnan,1\n1e400,1\n",
            {"2:1 NotFinite nan|", "3:1 NotFinite 1e400|"});
        row("range not finite", 1, "X,T\n-1.7e308,0\n1.7e308,1\n", {"3:1 NotFinite 1.7e+308|"});
        row("comma and point", 1, "X;T\n0;0,1\n1;0.2\n2.5;0,3\n",
            {"3:2 MixedDecimals 0.2|a decimal comma as in line 2",
                "4:1 MixedDecimals 2.5|a decimal comma as in line 2"});
        row("point and comma", 1, "X;T\n0;0.1\n1;0,2\n",
            {"3:2 MixedDecimals 0,2|a decimal point as in line 2"});
        row("thousands", 1, "X;T\n0;1.234,5\n1;2\n",
            {"2:2 MixedDecimals 1.234,5|no sign between the thousands"});
        row("points that may be between thousands", 1, "X;T\n0;1\n500;2\n1.000;1\n",
            {"4:1 MixedDecimals 1.000 in a column with 500|numbers that show whether the point "
             "stands between thousands: no point in 1.000, or the same decimals in 500"});
        row("open quote", 1, "X,T\n0,\"1\n1,2\n", {"2:2 UnterminatedQuote 1|a closing \""});
        row("text behind a quote", 1, "X,T\n0,\"1\"2\n1,2\n",
            {"2:2 UnterminatedQuote 1\"2|a separator or the end of the line"});
        row("open quote in the header", 1, "X,\"T\n0,1\n", {"1:2 UnterminatedQuote T|a closing"});
        row("a point twice", 1, "X [mm],T\n0,0\n1,1e-3\n// \n\n1.0,2e-3\n2,0\n",
            {"6:0 DuplicatePoint X = 1 mm in line 3 and again in line 6|every position once"});
        row("a point three times", 1, "X,T\n0,0\n0,1e-3\n1,0\n0,0\n",
            {"3:0 DuplicatePoint X = 0 in line 2 and again in line 3|",
                "5:0 DuplicatePoint X = 0 in line 2 and again in line 5|"});
        row("a plane read as a line", 1, "X,Y,T\n0,0,0\n1,0,0\n0,1,0\n1,1,0\n",
            {"0:0 OtherDimensionality a full 2D grid of 2 x 2 points|",
                "4:0 DuplicatePoint X = 0 in line 2 and again in line 4|every position once (or is "
                "the dimensionality 2?)"});
        row("a space read as a line", 1,
            "X,Y,Z,T\n0,0,0,0\n1,0,0,0\n2,0,0,1\n0,1,0,0\n1,1,0,2\n2,1,0,0\n0,0,5,0\n1,0,5,0\n"
            "2,0,5,0\n0,1,5,0\n1,1,5,0\n2,1,5,0\n",
            {"0:0 OtherDimensionality a full 3D grid of 3 x 2 x 2 points|", "5:0 DuplicatePoint"});
        row("a plane with a hole read as a line", 1, "X,Y,T\n0,0,0\n1,0,0\n0,1,0\n",
            {"4:0 DuplicatePoint X = 0 in line 2 and again in line 4|"});
        row("a plane with a word read as a line", 1, "X,Y,T\n0,0,0\n1,0,0\n0,1,0\n1,1,x\n",
            {"4:0 DuplicatePoint", "5:3 NotANumber x|", "5:0 DuplicatePoint"});
        row("missing points", 2, "X [mm],Y,T\n0,0,1\n1,0,1\n0,5,1\n",
            {"0:0 MissingPoint no line for X = 1 mm, Y = 5 (missing: 1 of 4 points)|every "
             "combination of the positions"});
        row("a twice and a missing point", 2, "X,Y,T\n0,0,1\n1,0,1\n0,5,1\n1,0,2\n",
            {"5:0 DuplicatePoint X = 1, Y = 0 in line 3 and again in line 5|",
                "0:0 MissingPoint no line for X = 1, Y = 5 (missing: 1 of 4 points)|"});
        row("a diagonal", 3, "X,,Z,T\n0,0,0,1\n1,1,1,1\n2,2,2,1\n3,3,3,1\n4,4,4,1\n5,5,5,1\n",
            {"0:0 MissingPoint no line for X = 1, position 2 = 0, Z = 0; X = 2, position 2 = 0, Z "
             "= 0; X = 3, position 2 = 0, Z = 0; ... (missing: 210 of 216 points)|every "
             "combination of the positions (or is the dimensionality 1?)"});
        row("uneven", 1, "X,T\n0,0\n1,0\n2,1e-3\n4,0\n",
            {"5:1 UnevenSpacing X = 4 next to 2|3 (steps of 1)"});
        row("uneven beyond rounding", 1, "X,T\n0,0\n0.33,0\n0.70,1e-3\n1,0\n",
            {"4:1 UnevenSpacing X = 0.7 next to 0.33|0.66 (steps of 0.33)",
                "5:1 UnevenSpacing X = 1 next to 0.7|1.03 (steps of 0.33)"});
        row("a missing grid line", 2,
            "X,Y,T\n0,0,0\n0,1,0\n0,3,0\n0,4,1\n1,0,0\n1,1,0\n1,3,0\n1,4,0\n",
            {"4:2 UnevenSpacing Y = 3 next to 1|2 (steps of 1)"});
        row("a line read as a plane", 2,
            "X,T,U\n0,1.12,0\n1,1.57,0\n2,1.31,0\n3,1.13,0\n4,1.99,0\n",
            {"3:2 UnevenSpacing T = 1.57 next to 1.31|1.49 (steps of 0.18) (or is the "
             "dimensionality 1?)",
                "5:2 UnevenSpacing T = 1.13 next to 1.12|1.3 (steps of 0.18) (or is the",
                "6:2 UnevenSpacing T = 1.99 next to 1.57|1.75 (steps of 0.18) (or is the"});
        row("header only", 1, "X,T\n", {"1:0 TooFewPoints no data lines after the header|"});
        row("one point", 1, "X,T\n7,0\n", {"2:1 TooFewPoints only X = 7|at least 2 different"});
        row("one line of points", 2, "X,Y,T\n0,7,0\n1,7,1\n",
            {"2:2 TooFewPoints only Y = 7|at least 2 different positions (or is the dimensionality "
             "1?)"});
        row("UTF-16", 1, QByteArray("\xFF\xFEX\0,\0T\0", 8), {"0:0 NotText UTF-16 text|"});
        row("UTF-16 big end first", 1, QByteArray("\xFE\xFF\0X\0,\0T", 8),
            {"0:0 NotText UTF-16 text|"});
        row("UTF-16 without a mark", 1, QByteArray("X\0,\0T\0\n\0", 8),
            {"0:0 NotText UTF-16 text|"});
        row("NUL", 1, QByteArray("X,T\n0,1\n1,\0002\n", 13), {"3:0 NotText a NUL byte|"});
        row("workbook", 1, "PK\x03\x04 and so on", {"0:0 NotText a spreadsheet workbook"});
        row("binary", 1, "\x01\x02\x03\x04\x05\x06\x07\x0e\x0f", {"0:0 NotText a binary file|"});
    }
    void everyProblemIsNamedWithItsPlace()
    {
        QFETCH(int, dimensions);
        QFETCH(QByteArray, text);
        QFETCH(QByteArrayList, expected);
        const CsvReading reading = parse(text, dimensions);
        const QByteArrayList found = describe(reading);
        QVERIFY(!reading.data);
        QVERIFY(reading.hasErrors());
        QVERIFY2(found.size() == expected.size(), found.join('\n').constData());
        for (qsizetype i = 0; i < found.size(); ++i)
            QVERIFY2(found[i].startsWith(expected[i]), found[i].constData());
        for (const Diagnostic& diagnostic : reading.diagnostics) {
            QCOMPARE(diagnostic.severity, Severity::Error);
            QVERIFY2(isSentence(message(diagnostic)), message(diagnostic).c_str());
        }
    }

    void aGridOfFewerDimensionsIsNeverProposed()
    {
        // Its positions would become corrections.
        for (const QByteArray text :
            {"X,Y,T\n0,0,0\n1,1,1e-3\n2,2,0\n", "X,Y,T\n0,7,0\n1,7,1e-3\n2,7,0\n"}) {
            QVERIFY(parse(text, 1).data);
            const CsvReading reading = parse(text, 2);
            QVERIFY(!reading.data);
            QVERIFY2(!reading.fullGrid, text.constData());
        }
    }

    void aGridOfMoreDimensionsIsProposedWithItsSize()
    {
        const QByteArray text = "X,Y,T\n0,0,0\n1,0,0\n2,0,0\n0,1,0\n1,1,0\n2,1,1e-3\n";
        const CsvReading reading = parse(text, 1);
        QVERIFY(reading.fullGrid);
        QCOMPARE(*reading.fullGrid, (FullGrid{2, {3, 2}}));
        QVERIFY(!parse(text, reading.fullGrid->dimensions).hasErrors());
        CsvOptions filling;
        filling.missing = MissingPoints::Nearest;
        QCOMPARE(parse(text, 1, filling).fullGrid, reading.fullGrid);
        filling.maximumDiagnostics = 0;
        QVERIFY(!parse(text, 1, filling).data);
    }

    void aWarningDoesNotStopTheFile_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("expected");
        QTest::newRow("Windows-1252") << QByteArray("X,T\n0,0.001\n1,0.002\n// 5 \xB5m\n")
                                      << QByteArray("4:0 Encoding the byte 0xB5 (µ)|UTF-8");
        QTest::newRow("rounded spacing")
            << QByteArray("X,T\n0,0\n0.333,0\n0.667,0.001\n1,0\n")
            << QByteArray("4:1 RoundedSpacing X = 0.667|0.6667 (steps of 0.3334)");
        QTest::newRow("float precision") << QByteArray("X,T\n0,0\n1,3e-45\n2,1e-45\n")
                                         << QByteArray("4:2 FloatPrecision a change of ");
        QTest::newRow("steep")
            << QByteArray("X [mm],T\n0,0\n10,0.1\n20,0.3\n30,0.31\n")
            << QByteArray("4:2 LargeGradient a step from 0.1 to 0.3 over 10 mm in dimension 1"
                          "|at most 0.01 per unit of position");
        QTest::newRow("constant")
            << QByteArray("X,T\n0,0.5\n1,0.5\n")
            << QByteArray("1:2 ConstantTable 0.5 at every point of T|values that differ");
    }
    void aWarningDoesNotStopTheFile()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, expected);
        const CsvReading reading = parse(text, 1);
        QVERIFY(reading.data);
        QVERIFY(!reading.hasErrors());
        const QByteArrayList found = describe(reading);
        QVERIFY2(found.size() == 1 && found[0].startsWith(expected), found.join('\n').constData());
        QCOMPARE(reading.diagnostics[0].severity, Severity::Warning);
        QVERIFY(isSentence(message(reading.diagnostics[0])));
    }

    void aGradientOfExactlyOnePercentIsNoWarning()
    {
        QCOMPARE(describe(parse("X,T\n0,0\n10,0.1\n20,0\n", 1)), QByteArrayList{});
        QCOMPARE(parse("X,T\n0,0\n10,0.1001\n20,0\n", 1).diagnostics.size(), 1U);
    }

    void theGradientIsLookedAtInEveryDimension_data()
    {
        QTest::addColumn<int>("steep");
        for (int d = 0; d < 3; ++d)
            QTest::addRow("dimension %d", d + 1) << d;
    }
    void theGradientIsLookedAtInEveryDimension()
    {
        QFETCH(int, steep);
        QByteArray text = "X,Y,Z,A,B\n";
        for (int i = 0; i < 27; ++i) {
            const std::array<int, 3> at{i % 3, i / 3 % 3, i / 9};
            text += QByteArray::number(at[0]) + ',' + QByteArray::number(at[1]) + ','
                + QByteArray::number(at[2]) + ',' + QByteArray::number(i % 2 * 0.001) + ','
                + QByteArray::number(at[static_cast<std::size_t>(steep)] == 2 ? 0.5 : 0.0) + '\n';
        }
        const CsvReading reading = parse(text, 3);
        QCOMPARE(reading.diagnostics.size(), 1U);
        QCOMPARE(reading.diagnostics[0].code, DiagnosticCode::LargeGradient);
        QCOMPARE(reading.diagnostics[0].column, 5U);
        const std::size_t firstSteep = steep == 0 ? 2 : steep == 1 ? 6 : 18;
        QVERIFY(reading.diagnostics[0].line >= firstSteep + 2);
    }

    /// 5.5 um over 100 mm in the units that are stated.
    void theGradientIsLookedAtInTheUnitsThatAreStated()
    {
        const QByteArray text = "X [mm];dX [mm]\n0;1,5\n0,1;-2,5\n0,2;3\n";
        QCOMPARE(parse(text, 1).diagnostics.size(), 1U);
        CsvOptions options;
        options.units = {"um", "m"};
        const CsvReading stated = parse(text, 1, options);
        QVERIFY2(stated.diagnostics.empty(), describe(stated).join('\n').constData());
        QCOMPARE(stated.data->grid.axes[0].unit, "m");
        QCOMPARE(stated.data->tables[0].grid.axes[0].unit, "m");
        QCOMPARE(stated.data->tables[0].unit, "um");
        options.units = {"m", {}};
        QCOMPARE(parse(text, 1, options).diagnostics.size(), 1U);
        QCOMPARE(parse(text, 1, options).data->tables[0].grid.axes[0].unit, "mm");
    }

    void theFirstHundredProblemsAreShownTheRestCounted_data()
    {
        QTest::addColumn<std::size_t>("maximum");
        QTest::addColumn<QByteArray>("line");
        for (const std::size_t maximum : {std::size_t{0}, std::size_t{1}, std::size_t{100}}) {
            QTest::addRow("%zu words", maximum) << maximum << QByteArray("0,abc\n");
            QTest::addRow("%zu short lines", maximum) << maximum << QByteArray("0\n");
        }
    }
    void theFirstHundredProblemsAreShownTheRestCounted()
    {
        QFETCH(std::size_t, maximum);
        QFETCH(QByteArray, line);
        CsvOptions options;
        options.maximumDiagnostics = maximum;
        // A position of its own for each line, lest duplicates be counted too.
        QByteArray text = "X,T\n";
        for (int i = 0; i < 250; ++i)
            text += QByteArray::number(i) + line.mid(1);
        const CsvReading reading = parse(text, 1, options);
        QCOMPARE(reading.diagnostics.size(), maximum);
        QCOMPARE(reading.suppressed, 250 - maximum);
        QVERIFY(reading.hasErrors());
        QVERIFY(!reading.data);
        for (std::size_t i = 0; i < maximum; ++i)
            QCOMPARE(reading.diagnostics[i].line, i + 2);
    }

    void aFloodOfDuplicatesLeavesRoomForOthers()
    {
        QByteArray text = "X,Y,T\n";
        for (int i = 0; i < 1000; ++i)
            text += QByteArray::number(i % 10) + ',' + QByteArray::number(i / 10) + ",0\n";
        text += "3,5,oops\n";
        const CsvReading reading = parse(text, 1);
        QCOMPARE(reading.diagnostics.size() + reading.suppressed, 992U);
        QVERIFY(reading.diagnostics.size() < 50);
        QCOMPARE(reading.diagnostics.back().line, 1002U);
        QCOMPARE(reading.diagnostics.back().code, DiagnosticCode::NotANumber);
        QVERIFY(std::ranges::is_sorted(reading.diagnostics, {}, &Diagnostic::line));
    }

    void tooManyCellsAreRefused()
    {
        CsvOptions options;
        options.maximumCells = 8;
        QVERIFY(parse("X,T\n0,0\n1,1e-3\n2,0\n3,0\n", 1, options).data);
        const CsvReading reading = parse("X,T\n0,0\n1,1e-3\n2,0\n3,0\n4,0\n5,0\n", 1, options);
        QCOMPARE(describe(reading),
            QByteArrayList{
                "6:0 TooLarge more than 4 data lines of 2 columns|at most 8 cells (lines x "
                "columns)"});
        options = {};
        options.maximumBytes = 10;
        QCOMPARE(describe(parse("X,T\n0,0\n1,1\n", 1, options)),
            QByteArrayList{"0:0 TooLarge 12 bytes|at most 10 bytes"});
        const CsvReading columns = parse(QByteArray(20000, ','), 1);
        QCOMPARE(
            describe(columns), QByteArrayList{"1:0 TooLarge 20001 columns|at most 16384 columns"});
    }

    void quotedFileTextIsShortAndClean()
    {
        const CsvReading reading = parse("X,T\n0,\xFF\x07" + QByteArray(1000, 'x') + "\n", 1);
        const auto error =
            std::ranges::find(reading.diagnostics, DiagnosticCode::NotANumber, &Diagnostic::code);
        QVERIFY(error != reading.diagnostics.end());
        const std::string found = error->found.english();
        QVERIFY(found.starts_with("ÿ xxx") && found.ends_with("x…"));
        QVERIFY(found.size() < 50);
    }

    void everyCodeHasANameOfItsOwn()
    {
        std::set<std::string_view> names;
        for (int code = 0; code <= static_cast<int>(DiagnosticCode::Assumption); ++code) {
            Diagnostic diagnostic;
            diagnostic.code = static_cast<DiagnosticCode>(code);
            diagnostic.found = Verbatim{"this"};
            diagnostic.expected = Verbatim{"that"};
            names.insert(diagnosticName(diagnostic.code));
            const std::string text = message(diagnostic);
            QVERIFY(isSentence(text));
            QVERIFY(text.find("this") != std::string::npos);
            QVERIFY(text.find("expected that") != std::string::npos);
            const auto name = std::string(diagnosticName(diagnostic.code));
            QVERIFY2(text.ends_with(" (" + name + ")"), text.c_str());
        }
        QCOMPARE(names.size(), static_cast<std::size_t>(DiagnosticCode::Assumption) + 1);
    }

    void theWayOutIsNamed_data()
    {
        QTest::addColumn<DiagnosticCode>("code");
        QTest::addColumn<QByteArray>("wayOut");
        QTest::newRow("uneven")
            << DiagnosticCode::UnevenSpacing
            << QByteArray("resample the data onto an even grid, which can be done here for a "
                          "calibration file only");
        QTest::newRow("no text") << DiagnosticCode::NotText << QByteArray("save it as UTF-8 text");
        QTest::newRow("encoding") << DiagnosticCode::Encoding
                                  << QByteArray("save it as UTF-8 text");
        QTest::newRow("steep") << DiagnosticCode::LargeGradient << QByteArray("check the units");
        QTest::newRow("header") << DiagnosticCode::NoHeader << QByteArray("add a first line");
    }
    void theWayOutIsNamed()
    {
        QFETCH(DiagnosticCode, code);
        QFETCH(QByteArray, wayOut);
        const std::string text =
            message({Severity::Error, code, 1, 1, Verbatim{"a"}, Verbatim{"b"}});
        QVERIFY2(text.find(wayOut.toStdString()) != std::string::npos, text.c_str());
    }

    void aNumberIsQuotedAsFound()
    {
        QCOMPARE(message({Severity::Error, DiagnosticCode::NotANumber, 1, 1, Verbatim{"1,5x"},
                     Verbatim{"a number such as 0.5"}}),
            "this is not a number: found \"1,5x\", expected a number such as 0.5 (NotANumber)");
    }
};

AXISCOMP_TEST(TestCsvDiagnostics)

} // namespace tst_csvdiagnostics

#include "tst_csvdiagnostics.moc"
