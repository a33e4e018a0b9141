// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/triamec/triamec_tables.h"
#include "core/table/table_layout.h"
#include "core/table/tam_table.h"
#include "tests/core/formats/format_sample.h"
#include "tests/support/test_registry.h"

namespace tst_triamec {

using namespace axiscomp;

namespace {

TableReadOptions withDimensions(int dimensions)
{
    TableReadOptions options;
    options.dimensions = dimensions;
    return options;
}
TableReadOptions oneDimension()
{
    return withDimensions(1);
}

/// What a calibration file says of the table of the example.
NeutralTable exampleTable(int dimensions)
{
    return calibration_csv::format()
        .read(exampleCalibrationCsv(dimensions), withDimensions(dimensions))
        ->tables.front();
}

void describeCsv(test::FormatSample& sample)
{
    sample.facts = "feedback is published; 1 to 3 dimensions, even knots; "
                   "points any, columns any, tables 1, bytes 1073741824; holds names units notes";
    sample.text = exampleCalibrationCsv(2);
    sample.reading = withDimensions(2);
    sample.comment = "// ";
    sample.spareBytes = 247; // half of the lines are a table
    sample.recognises(Recognition::Possible, {sample.text});
    sample.writes("the example of the manual", {exampleTable(2)});
}

void describeTamtbl(test::FormatSample& sample)
{
    static const TableLayout layout = genericTableLayout();
    sample.facts = "feedback is published; 1 to 3 dimensions, even knots; "
                   "points any, columns 1, tables 1, bytes 67108864; holds persistency bytes";
    sample.reading.layout = &layout;
    sample.writing.layout = &layout;
    // The file has neither names nor units.
    const NeutralTable table = test::tableOf(SignConvention::Feedback,
        {test::evenAxis("", "", -100, 50, 5), test::evenAxis("", "", 0, 40, 4)},
        {test::waveColumn("", "", 20, 1.0)});
    sample.writes("a plane", {table}).within(6e-8, 0); // of float32
    sample.text = tam_table::format().write(std::array{table}, sample.writing)->bytes;
}

constexpr const char* unevenText = "X [mm],Table 1 [um]\n0,0\n1,0.5\n2.5,1.5\n10,-1\n";

} // namespace

class TestCalibrationTables : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void unevenPositionsAreReadForResampling()
    {
        READ_TABLE(table, calibration_csv::format(), unevenText, oneDimension());
        QCOMPARE(table.axes[0].knots, (std::vector<double>{0, 1, 2.5, 10}));
        QCOMPARE(table.axes[0].unit, std::string("mm"));
        QCOMPARE(table.columns[0].name, std::string("Table 1"));
        QCOMPARE(table.columns[0].unit, std::string("um"));
        QVERIFY(!isEven(table));
    }

    void evenPositionsAreThoseOfTheGrid()
    {
        // 0.1 + 0.2 and the like: the file's texts and the grid differ by the rounding of doubles.
        READ_TABLE(
            table, calibration_csv::format(), "X,T\n0.1,1\n0.2,2\n0.3,3\n0.4,5\n", oneDimension());
        QVERIFY(isEven(table));
        const auto data = calibrationData(table);
        VERIFY_RESULT(data);
        QCOMPARE(data->grid.axes[0].start, 0.1);
        QCOMPARE(data->grid.axes[0].distance, 0.1);
    }

    void unevenPositionsAreNotWritten()
    {
        READ_TABLE(table, calibration_csv::format(), unevenText, oneDimension());
        VERIFY_ERROR(calibrationData(table), ErrorCode::FormatCannotHold);
    }

    void aColumnThatNamesAnAxisIsForThatAxis()
    {
        TableReadOptions options;
        options.dimensions = 2;
        READ_TABLE(table, calibration_csv::format(),
            "X,Y,X error,Y\n0,0,1,2\n1,0,1,2\n0,1,1,3\n1,1,2,3\n", options);
        QCOMPARE(table.columns[0].target, std::string("X"));
        QCOMPARE(table.columns[1].target, std::string("Y"));
        QCOMPARE(ownAxis(table, table.columns[1]), std::optional<std::size_t>(1));
        QCOMPARE(ownAxis(table, table.columns[0]), std::optional<std::size_t>(0));
    }

    void valuesAreTheNumbersThatThePersonWrote()
    {
        READ_TABLE(
            table, calibration_csv::format(), "X,T\n0,0.0021\n1,-3.4\n2,1e-12\n", oneDimension());
        QCOMPARE(table.columns[0].values, (std::vector<double>{0.0021, -3.4, 1e-12}));
    }

    void offsetsOfTheCommandAreNotTakenForErrors()
    {
        READ_TABLE(read, calibration_csv::format(), "X,T\n0,1\n1,2\n", oneDimension());
        NeutralTable table = read;
        table.sign = SignConvention::Command;
        VERIFY_ERROR(calibrationData(table), ErrorCode::FormatCannotHold);
    }

    void theNumberOfDimensionsMustBeSaid()
    {
        VERIFY_ERROR(calibration_csv::format().read(unevenText, {}), ErrorCode::InvalidArgument);
    }

    void aTamTableNeedsALayout()
    {
        VERIFY_ERROR(tam_table::format().read("TAM", {}), ErrorCode::InvalidArgument);
    }

    /// It has no units, and a drive takes its numbers in that of the axis.
    void aTamTableIsNotWrittenInAStatedUnit()
    {
        const TableLayout layout = genericTableLayout();
        const std::array tables{test::tableOf(SignConvention::Feedback,
            {test::evenAxis("X", "mm", 0, 50, 3)}, {test::waveColumn("E", "mm", 3, 1.0)})};
        for (const std::string key : {"position-unit", "value-unit"}) {
            TableWriteOptions options;
            options.layout = &layout;
            options.settings[key] = "mm";
            const auto written = tam_table::format().write(tables, options);
            VERIFY_ERROR(written, ErrorCode::InvalidArgument);
            QVERIFY(test::mentions(
                sentence(written.error()), "has no setting " + key + " for writing; it has: pers"));
        }
    }

    void aTamTableIsReadInTheStatedUnits()
    {
        const TableLayout layout = genericTableLayout();
        const std::array tables{test::tableOf(SignConvention::Feedback,
            {test::evenAxis("", "", 0, 50, 3)}, {test::waveColumn("", "", 3, 1.0)})};
        TableWriteOptions writing;
        writing.layout = &layout;
        const auto written = tam_table::format().write(tables, writing);
        VERIFY_RESULT(written);
        TableReadOptions options;
        options.layout = &layout;
        options.settings = {{"position-unit", "m"}, {"value-unit", "um"}};
        READ_TABLE(table, tam_table::format(), written->bytes, options);
        QCOMPARE(table.axes[0].unit, std::string("m"));
        QCOMPARE(table.columns[0].unit, std::string("um"));
    }

    void aUnitThatNobodySaysIsKnown()
    {
        const auto found = [](const std::string& positions, const std::string& values) {
            CalibrationData data;
            data.grid.axes = {{"X", "mm", 0, 1, 2}, {"Y", positions, 0, 1, 2}};
            data.tables.resize(2);
            data.tables[0].unit = "um";
            data.tables[1].unit = values;
            std::vector<std::string> found;
            for (const Diagnostic& problem : openUnits(data))
                found.push_back(
                    problem.code == DiagnosticCode::UnitNotGiven ? problem.found.english() : "");
            return found;
        };
        const std::string positions = "positions without a unit";
        const std::string values = "values without a unit";
        QCOMPARE(found("mm", "mm"), std::vector<std::string>());
        QCOMPARE(found("", "mm"), std::vector{positions});
        QCOMPARE(found("mm", ""), std::vector{values});
        QCOMPARE(found("", ""), (std::vector{positions, values}));
    }

    void unknownNamesListTheKnownOnes()
    {
        const auto format = formatNamed("tamtable");
        VERIFY_ERROR(format, ErrorCode::UnknownFormat);
        QVERIFY(sentence(format.error()).find("csv, tamtbl") != std::string::npos);
    }

    void aFileIsReadAsWhatItsContentIs()
    {
        const auto choice = chooseFormat("1 2\n0 0.1\n1 0.2\n", "table.dat", false);
        VERIFY_RESULT(choice);
        QCOMPARE(choice->format, &softmc::format());
        const auto csv = chooseFormat("X,T\n0,1\n1,2\n", "x.csv", true);
        VERIFY_RESULT(csv);
        QCOMPARE(csv->format, &calibration_csv::format());
        const auto tam = chooseFormat("anything", "X.TAMTBL", false);
        VERIFY_RESULT(tam);
        QCOMPARE(tam->format, &tam_table::format());
        VERIFY_ERROR(chooseFormat("?", "x.bin", false), ErrorCode::UnknownFormat);
    }

    /// Each of its columns would be one, the direction, too.
    void aMeasurementIsNoTable()
    {
        for (const char* text : {"target [mm],direction,deviation [mm]\n0,1,0.001\n10,1,0.002\n",
                 "target_mm,up1_um,down1_um\n0,1,1\n10,2,2\n",
                 "encoder [mm],reference [mm]\n0,0.001\n10,10.002\n"})
            for (const bool isCalibration : {false, true}) {
                const auto choice = chooseFormat(text, "m.csv", isCalibration);
                VERIFY_ERROR(choice, ErrorCode::UnknownFormat);
                const std::string said = sentence(choice.error());
                QVERIFY2(said.starts_with("m.csv is a measurement, not a table; "), said.c_str());
            }
    }

    /// Otherwise a header has other columns than its lines, which are pairs as icube has them.
    void aSeparatorWithinQuotationMarksSeparatesNothing()
    {
        for (const char* text : {"X [mm],\"X error, laser 3 [um]\"\n0,1\n100,2\n",
                 "X [mm];\"X error; laser 3 [um]\"\n0;1\n100;2\n",
                 "X [mm],X error [um]\n\"0\",\"1\"\n100,2\n200,1\n"}) {
            const auto choice = chooseFormat(text, "x.csv", false);
            VERIFY_RESULT(choice);
            QCOMPARE(choice->format, &calibration_csv::format());
        }
    }

    void thatAFileIsUtf16IsSaidInsteadOfTheFormatsThatThereAre()
    {
        using namespace std::string_literals;
        for (const std::string& text : {"\xFF\xFEk\0o\0"s, "\xFE\xFF\0k\0o"s, "k\0o\0p\0f\0"s}) {
            const auto choice = chooseFormat(text, "x.lis", false);
            VERIFY_ERROR(choice, ErrorCode::UnknownFormat);
            QCOMPARE(sentence(choice.error()),
                std::string("x.lis is UTF-16 text; save it as UTF-8 text"));
        }
    }
};

AXISCOMP_TEST(TestCalibrationTables)
AXISCOMP_FORMAT(calibration_csv::format(), describeCsv)
AXISCOMP_FORMAT(tam_table::format(), describeTamtbl)

} // namespace tst_triamec

#include "tst_triamec.moc"
