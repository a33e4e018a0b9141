// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/csv/csv_reading.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <algorithm>

namespace tst_calibrationcsv {

using namespace axiscomp;
using test::describe;
using test::parse;

namespace {

std::vector<float> values(const CsvReading& reading, std::size_t table = 0)
{
    return reading.data ? reading.data->tables.at(table).values : std::vector<float>{};
}

} // namespace

class TestCalibrationCsv : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aFileOfEachFormGivesTheSameTable_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("plain") << QByteArray("X,T\n0,0.001\n0.5,0.002\n1,-0.003\n");
        QTest::newRow("no line end at the end") << QByteArray("X,T\n0,0.001\n0.5,0.002\n1,-0.003");
        QTest::newRow("CRLF") << QByteArray("X,T\r\n0,0.001\r\n0.5,0.002\r\n1,-0.003\r\n");
        QTest::newRow("CR") << QByteArray("X,T\r0,0.001\r0.5,0.002\r1,-0.003\r");
        QTest::newRow("mixed ends") << QByteArray("X,T\n0,0.001\r0.5,0.002\r\n1,-0.003");
        QTest::newRow("byte-order mark")
            << QByteArray("\xEF\xBB\xBFX,T\n0,0.001\n0.5,0.002\n1,-0.003\n");
        QTest::newRow("semicolons") << QByteArray("X;T\n0;0.001\n0.5;0.002\n1;-0.003\n");
        QTest::newRow("decimal comma") << QByteArray("X;T\n0;0,001\n0,5;0,002\n1;-0,003\n");
        QTest::newRow("decimal comma comes late")
            << QByteArray("X;T\n1;-3e-3\n0;1e-3\n0,5;0,002\n");
        QTest::newRow("semicolon, comma in the header")
            << QByteArray("X;\"T\"\n0;0,001\n0,5;0,002\n1;-0,003\n");
        QTest::newRow("quotes") << QByteArray(
            "\"X\",\"T\"\n\"0\",\"0.001\"\n0.5,\"0.002\"\n\"1\",-0.003\n");
        QTest::newRow("blanks") << QByteArray(
            " X ,\tT\n 0 , 0.001 \n\t0.5,\"0.002\" \n 1\t,-0.003\t\n");
        QTest::newRow("plus signs") << QByteArray("X,T\n+0,+0.001\n+.5,+2e-3\n+1,-0.003\n");
        QTest::newRow("exponents") << QByteArray("X,T\n0,1e-3\n5e-1,2E-03\n1e0,-3.0e-3\n");
        QTest::newRow("points without digits") << QByteArray("X,T\n0.,.001\n.5,.002\n1.,-.003\n");
        QTest::newRow("comments and blank lines")
            << QByteArray("\n  \n//\nX,T\n0,0.001\n\n//\n0.5,0.002\n\t\n1,-0.003\n//");
        QTest::newRow("any order") << QByteArray("X,T\n1,-0.003\n0,0.001\n0.5,0.002\n");
        QTest::newRow("decreasing") << QByteArray("X,T\n1,-0.003\n0.5,0.002\n0,0.001\n");
        QTest::newRow("the same position in other words")
            << QByteArray("X,T\n-0,0.001\n5000e-4,0.002\n1.000,-0.003\n");
    }
    void aFileOfEachFormGivesTheSameTable()
    {
        QFETCH(QByteArray, text);
        const CsvReading reading = parse(text, 1);
        QVERIFY2(reading.data, describe(reading).join('\n').constData());
        QCOMPARE(describe(reading), QByteArrayList{});
        const GridAxis axis{"X", "", 0.0, 0.5, 3};
        QVERIFY(reading.data->grid.axes == std::vector<GridAxis>{axis});
        QCOMPARE(values(reading), (std::vector<float>{0.001F, 0.002F, -0.003F}));
        QVERIFY(reading.data->tables[0].grid == reading.data->grid);
        QVERIFY(!reading.hasErrors());
    }

    void namesAndUnitsAreRead_data()
    {
        QTest::addColumn<QByteArray>("header");
        QTest::addColumn<QByteArrayList>("expected"); // position, then tables
        QTest::newRow("units") << QByteArray("X [mm],Forward [um],B[nm]")
                               << QByteArrayList{"X|mm", "Forward|um", "B|nm"};
        QTest::newRow("none") << QByteArray("X,A,B") << QByteArrayList{"X|", "A|", "B|"};
        QTest::newRow("empty") << QByteArray(",,") << QByteArrayList{"|", "Table 1|", "Table 2|"};
        QTest::newRow("repeated") << QByteArray("X,A,A") << QByteArrayList{"X|", "A|", "Table 2|"};
        QTest::newRow("only a unit")
            << QByteArray("[mm],[um],[nm]") << QByteArrayList{"|mm", "Table 1|um", "Table 2|nm"};
        QTest::newRow("the number is taken")
            << QByteArray("X,Table 2,Table 2") << QByteArrayList{"X|", "Table 2|", "Table 3|"};
        QTest::newRow("quoted") << QByteArray(R"("X, left [mm]","say ""A""","B;C")")
                                << QByteArrayList{"X, left|mm", "say \"A\"|", "B;C|"};
        QTest::newRow("brackets in the name") << QByteArray("X [a] [mm],A [],B [x] y")
                                              << QByteArrayList{"X [a]|mm", "A|", "B [x] y|"};
        QTest::newRow("a unit in other brackets, or before the end") << QByteArray(
            "X (mm),E {um},E [um] (mean)") << QByteArrayList{"X|mm", "E|um", "E (mean)|um"};
        QTest::newRow("a unit behind a stroke")
            << QByteArray("x / mm,E/nm,E/Y") << QByteArrayList{"x|mm", "E|nm", "E/Y|"};
        QTest::newRow("a unit in words")
            << QByteArray("X in mm,E in um,E in X") << QByteArrayList{"X|mm", "E|um", "E in X|"};
        QTest::newRow("brackets without a unit")
            << QByteArray("X (left),E (mean),E (um) [nm]")
            << QByteArrayList{"X (left)|", "E (mean)|", "E (um)|nm"};
        QTest::newRow("full-width brackets")
            << QByteArray("X\uff08mm\uff09,E\uff3bum\uff3d,E\u3010\u5e73\u5747\u3011")
            << QByteArrayList{"X|mm", "E|um", "E\u3010\u5e73\u5747\u3011|"};
        QTest::newRow("spellings of shops and of this program")
            << QByteArray("X (inches),A (microns),B (thou),C (Zoll),D (\u2033),E ('),F (\u339c)")
            << QByteArrayList{
                   "X|inches", "A|microns", "B|thou", "C|Zoll", "D|\u2033", "E|'", "F|\u339c"};
        QTest::newRow("the name of an axis where a unit may stand")
            << QByteArray("Position (C),Error (C),E/C [deg]")
            << QByteArrayList{"Position (C)|", "Error (C)|", "E/C|deg"};
        QTest::newRow("quote within a name")
            << QByteArray("X 5\",A,B") << QByteArrayList{"X 5\"|", "A|", "B|"};
        QTest::newRow("stray byte-order marks")
            << QByteArray("\xEF\xBB\xBF\xEF\xBB\xBFX,\xEF\xBB\xBF,B")
            << QByteArrayList{"X|", "Table 1|", "B|"};
        QTest::newRow("UTF-8") << QByteArray("X [µm],Größe,Ω")
                               << QByteArrayList{"X|µm", "Größe|", "Ω|"};
    }
    void namesAndUnitsAreRead()
    {
        QFETCH(QByteArray, header);
        QFETCH(QByteArrayList, expected);
        const auto tables = static_cast<int>(expected.size()) - 1;
        const QByteArray more = QByteArray(",0").repeated(tables - 2);
        const CsvReading reading =
            parse(header + "\n0,0,0.001" + more + "\n1,0.002,0" + more + '\n', 1);
        QVERIFY2(reading.data, describe(reading).join('\n').constData());
        const GridAxis& axis = reading.data->grid.axes[0];
        QByteArrayList found{QByteArray::fromStdString(axis.name + '|' + axis.unit)};
        for (const CompensationTable& table : reading.data->tables)
            found += QByteArray::fromStdString(table.name + '|' + table.unit);
        QCOMPARE(found, expected);
    }

    void aStatementOfCorrectionsChangesNothingInTheFileAndIsSaid()
    {
        const auto doubts = [](const char* comment) {
            const CsvReading reading = parse(QByteArray(comment) + "X,E\n0,0\n1,0.002\n", 1);
            return reading.data && reading.data->tables[0].values[1] == 0.002F ? std::ranges::count(
                       reading.diagnostics, DiagnosticCode::Assumption, &Diagnostic::code)
                                                                               : -1;
        };
        QCOMPARE(doubts("// Sign:  Correction\n"), 1);
        QCOMPARE(doubts("// sign: deviation\n"), 0);
        QCOMPARE(doubts(""), 0);
    }

    void bracketsWithAUnitThatIsNotKnownAreNamed_data()
    {
        QTest::addColumn<QByteArray>("header");
        QTest::addColumn<int>("column"); // 0: none is named
        QTest::newRow("feet") << QByteArray("X (ft),E [um]") << 1;
        QTest::newRow("a letter too few") << QByteArray("X [mm],E (milimeter)") << 2;
        QTest::newRow("for each length") << QByteArray("X [mm],E \uff08\u00b5m/m\uff09") << 2;
        QTest::newRow("hundredths") << QByteArray("X [mm],E (1/100 mm)") << 2;
        QTest::newRow("a digit of a display") << QByteArray("X [mm],E (0.1 \u00b5m)") << 2;
        QTest::newRow("a power") << QByteArray("X [mm],E (10^-3mm)") << 2;
        QTest::newRow("a factor behind") << QByteArray("X [mm],E (mm x 1000)") << 2;
        QTest::newRow("a divisor") << QByteArray("X [mm],E (mm/1000)") << 2;
        QTest::newRow("one of several") << QByteArray("X [mm],E (1/3)") << 0;
        QTest::newRow("number of a machine") << QByteArray("X [mm],E (M 2)") << 0;
        QTest::newRow("mean") << QByteArray("X [mm],E (mean)") << 0;
        QTest::newRow("an axis") << QByteArray("Position (X),Error (C)") << 0;
        QTest::newRow("a direction") << QByteArray("X [mm],E (upwards)") << 0;
        QTest::newRow("a temperature") << QByteArray("X [mm],E (at 20 \u00b0C)") << 0;
        QTest::newRow("not at the end") << QByteArray("X [mm],E (ft) left") << 0;
    }
    void bracketsWithAUnitThatIsNotKnownAreNamed()
    {
        QFETCH(QByteArray, header);
        QFETCH(int, column);
        const CsvReading reading = parse(header + "\n0,0\n1,0.002\n", 1);
        QVERIFY2(reading.data, describe(reading).join('\n').constData());
        const auto named =
            std::ranges::find(reading.diagnostics, DiagnosticCode::Assumption, &Diagnostic::code);
        const bool isNamed = named != reading.diagnostics.end();
        QCOMPARE(isNamed ? static_cast<int>(named->column) : 0, column);
    }

    void aSeparatorInsideQuotesSeparatesNothing()
    {
        const CsvReading reading = parse("\"a;b\",T\n0,0.5\n1,0.6\n", 1);
        QVERIFY(reading.data);
        QCOMPARE(reading.data->grid.axes[0].name, "a;b");
    }

    void notesAreKept()
    {
        const CsvReading reading =
            parse("//first\nX,T\n  // second note \n0,0.001\n///\n1,0.002\n//", 1);
        QVERIFY(reading.data);
        QCOMPARE(reading.data->notes, (std::vector<std::string>{"first", "second note", "/", ""}));
    }

    void controlCharactersDoNotComeThrough()
    {
        const CsvReading reading = parse("X\x01,A\x7f"
                                         "B\n0,0.001\n1,0.002\n// a",
            1);
        QVERIFY(reading.data);
        QCOMPARE(reading.data->grid.axes[0].name, "X");
        QCOMPARE(reading.data->tables[0].name, "A B");
        QCOMPARE(reading.data->notes, (std::vector<std::string>{"a"}));
    }

    void windows1252IsReadAsText()
    {
        const CsvReading reading = parse("// 20 \xB0"
                                         "C \x80 \x81\nX [\xB5m],Gr\xF6\xDF"
                                         "e\n0,0.001\n1,0.002\n",
            1);
        QVERIFY(reading.data);
        QCOMPARE(reading.data->notes, (std::vector<std::string>{"20 °C € \xEF\xBF\xBD"}));
        QCOMPARE(reading.data->grid.axes[0].unit, "µm");
        QCOMPARE(reading.data->tables[0].name, "Größe");
        QCOMPARE(reading.diagnostics.size(), 1U);
        QCOMPARE(reading.diagnostics[0].code, DiagnosticCode::Encoding);
        QCOMPARE(reading.diagnostics[0].line, 1U);
    }

    void dimension1IsFastest()
    {
        const CsvReading reading =
            parse("X,Y,A,B\n1,10,4,0\n0,20,5,1\n0,10,3,2\n2,20,7,3\n1,20,6,4\n2,10,8,5\n", 2);
        QVERIFY(reading.data);
        QCOMPARE(reading.data->grid.pointCount(), 6U);
        QCOMPARE(values(reading, 0), (std::vector<float>{3, 4, 8, 5, 6, 7}));
        QCOMPARE(values(reading, 1), (std::vector<float>{2, 0, 5, 1, 4, 3}));
    }
};

AXISCOMP_TEST(TestCalibrationCsv)

} // namespace tst_calibrationcsv

#include "tst_calibrationcsv.moc"
