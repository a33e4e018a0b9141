// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/conversion.h"
#include "core/formats/formats.h"
#include "core/formats/triamec/triamec_tables.h"
#include "core/table/table_layout.h"
#include "tests/core/conversion/numeric_tables.h"
#include "tests/core/formats/format_checks.h"
#include "tests/support/test_registry.h"

#include <numbers>

namespace tst_targets {

using namespace axiscomp;
using Values = std::vector<double>;

namespace {

const TableLayout& layout()
{
    static const TableLayout generic = genericTableLayout();
    return generic;
}

ConversionRequest requestFor(const TableFormat& from, const TableFormat& to)
{
    ConversionRequest request;
    request.from = &from;
    request.to = &to;
    request.writing.layout = &layout();
    request.writing.fileName = "table.txt";
    for (const FormatSetting& setting : to.facts.settings)
        if (setting.isNeeded && setting.forWriting)
            request.writing.settings[std::string(setting.key)] =
                setting.kind == FormatSetting::Kind::Text ? "X" : "1000000";
        else if (setting.key == "unit")
            request.writing.settings["unit"] = "mm";
    if (from.facts.needsSign())
        request.sourceSign = from.facts.sign;
    if (to.facts.needsSign())
        request.targetSign = to.facts.sign;
    return request;
}

TableReadOptions readOptions(const FormatFacts& facts, int dimensions)
{
    TableReadOptions options;
    options.layout = &layout();
    options.dimensions = dimensions;
    for (const FormatSetting& setting : facts.settings)
        if ((setting.isNeeded || setting.key == "counts-per-unit") && setting.forReading)
            options.settings[std::string(setting.key)] = "1000000";
        else if (setting.key == "unit" && setting.forReading)
            options.settings["unit"] = "mm";
    if (facts.name == "fanuc")
        options.settings = {
            {"reference-number", "100"}, {"interval", "10"}, {"detection-unit", "0.00001"}};
    if (!facts.holdsUnits && facts.name != "tamtbl") {
        options.settings["position-unit"] = "mm";
        options.settings["value-unit"] = "mm";
    }
    return options;
}

/// Over 1 to 3 axes, closed and 0 at 0, so that every format can hold it.
NeutralTable waves(const std::vector<std::string>& names, const std::string& target)
{
    NeutralTable table;
    for (const std::string& name : names)
        table.axes.push_back(test::evenAxis(name, "mm", 0, 10, 9));
    test::addColumn(table, target, [](const Values& position) {
        double value = 0.4;
        for (const double x : position)
            value *= std::sin(x / 80.0 * 2.0 * std::numbers::pi);
        return std::round(value * 1e12) / 1e12; // exactly 0 at the end, too
    });
    return table;
}

/// Linear between the knots along one axis, at a knot of the others, the ends held.
double between(const NeutralTable& table, std::size_t axis, std::size_t index, double x)
{
    std::size_t stride = 1;
    for (std::size_t n = 0; n < axis; ++n)
        stride *= table.axes[n].knots.size();
    const Values& knots = table.axes[axis].knots;
    const Values& values = table.columns.front().values;
    const std::size_t first = index - index / stride % knots.size() * stride;
    std::size_t cell = 0;
    while (cell + 2 < knots.size() && x > knots[cell + 1])
        ++cell;
    const double fraction =
        std::clamp((x - knots[cell]) / (knots[cell + 1] - knots[cell]), 0.0, 1.0);
    return (1.0 - fraction) * values[first + cell * stride]
        + fraction * values[first + (cell + 1) * stride];
}

/// -e(z) with z + e(z) = x on the own axis, by halving intervals; -e(x) for another axis.
double otherSign(
    const NeutralTable& table, std::optional<std::size_t> own, std::size_t index, const Values& at)
{
    if (!own)
        return -table.columns.front().values[index];
    const double x = at[*own];
    double low = x - 2.0;
    double high = x + 2.0;
    for (int step = 0; step < 100; ++step) {
        const double middle = (low + high) / 2.0;
        (middle + between(table, *own, index, middle) < x ? low : high) = middle;
    }
    return -between(table, *own, index, low);
}

double inMillimetres(const std::string& unit)
{
    for (const auto& [name, factor] : {std::pair("mm", 1.0), {"um", 1e-3}, {"nm", 1e-6}, {"", 1.0}})
        if (unit == name)
            return factor;
    return 0.0;
}

/// What a conversion has to make of a table along its own axis, in millimetres, at the points of
/// its result.
Values expectedValues(const NeutralTable& table, const NeutralTable& result,
    std::optional<std::size_t> own, bool isSameSign)
{
    NeutralTable inMm = table;
    const double factor = inMillimetres(table.columns.front().unit);
    for (double& value : inMm.columns.front().values)
        value *= factor;
    Values expected = inMm.columns.front().values;
    for (std::size_t i = 0; i < expected.size() && !isSameSign; ++i)
        expected[i] = otherSign(inMm, own, i, test::positionOf(result, i));
    return expected;
}

QString farthest(const CompensationColumn& column, const Values& expected, double tolerance)
{
    const double factor = inMillimetres(column.unit);
    if (factor == 0.0 || column.values.size() != expected.size())
        return QStringLiteral("%1 values in \"%2\"")
            .arg(column.values.size())
            .arg(QString::fromStdString(column.unit));
    for (std::size_t i = 0; i < expected.size(); ++i)
        if (!(std::abs(column.values[i] * factor - expected[i]) < tolerance))
            return QStringLiteral("%1 instead of %2 at point %3")
                .arg(column.values[i] * factor)
                .arg(expected[i])
                .arg(i);
    return {};
}

bool isOfAxesForThemselves(const TableFormat& format)
{
    for (const std::string_view name : {"acs-1d", "aerotech-1d", "siemens-eec", "isg-ssfk", "icube",
             "fanuc", "kmotion-linear", "linuxcnc", "twincat-nc", "weihong"})
        if (format.facts.name == name)
            return true;
    return false;
}

} // namespace

class TestTargets : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    /// A flatness map: the correction of Z moves no place of X or Y.
    void aMapOfAnotherAxisOnlyChangesItsSign()
    {
        NeutralTable table;
        table.axes = {
            test::evenAxis("X", "mm", 0, 50000, 5), test::evenAxis("Y", "mm", 0, 57500, 5)};
        test::addColumn(table, "Z", [](const Values& p) {
            return p[0] == 100000 && p[1] == 115000 ? -1800.0 : p[0] / 100.0;
        });
        const auto converted = convertSign(table, SignConvention::Command, test::held);
        VERIFY_RESULT(converted);
        for (std::size_t i = 0; i < table.pointCount(); ++i)
            QCOMPARE(converted->table.columns[0].values[i], -table.columns[0].values[i]);
        QCOMPARE(converted->table.columns[0].values[2 + 5 * 2], 1800.0);
    }

    void anUnstatedTargetIsAskedForBeforeASignIsConverted()
    {
        const NeutralTable table = waves({"X", "Y"}, "");
        VERIFY_ERROR(
            convertSign(table, SignConvention::Command, test::held), ErrorCode::TargetNotKnown);
        const auto refused = convertSign(table, SignConvention::Command, test::held);
        QVERIFY2(test::mentions(sentence(refused.error()), "#1 (X), #2 (Y)"),
            sentence(refused.error()).c_str());
        VERIFY_RESULT(convertSign(table, SignConvention::Feedback, test::held));
    }

    /// A table file of the drive names no sources, so that Z may be one of them.
    void aTargetThatMayBeASourceOrNotIsNamed()
    {
        const std::vector<std::string> stated{"Z"};
        const auto refused = withTargets(waves({""}, ""), stated, false);
        VERIFY_ERROR(refused, ErrorCode::TargetNotKnown);
        const std::string said = sentence(refused.error());
        QVERIFY2(said.starts_with("Z, stated as the axis that"), said.c_str());
        QVERIFY2(test::mentions(said, "#1 (source 1), other"), said.c_str());
    }

    void theWaysOutOfTheRefusalWork()
    {
        for (const std::string statement : {"#1", "#2", "X", "y", "Z", "other"}) {
            const std::array tables{waves({"X", "Y"}, "")};
            ConversionRequest request = requestFor(calibration_csv::format(), softmc::format());
            VERIFY_ERROR(convertTables(tables, request), ErrorCode::TargetNotKnown);
            request.targets = {statement};
            VERIFY_RESULT(convertTables(tables, request));
        }
    }

    void aNameThatMayBeThatOfASourceIsNoWayOut()
    {
        const std::array tables{waves({"Position"}, "")};
        ConversionRequest request = requestFor(calibration_csv::format(), softmc::format());
        request.targets = {"X"};
        VERIFY_ERROR(convertTables(tables, request), ErrorCode::TargetNotKnown);
    }

    void aColumnIsConvertedTheSameWithAnotherBesideIt()
    {
        NeutralTable both = waves({"X", "Y"}, "X");
        test::addColumn(both, "Z", [](const Values& p) { return 0.01 * p[0]; });
        NeutralTable alone = both;
        alone.columns.pop_back();
        const auto together = convertSign(both, SignConvention::Command, test::held);
        const auto single = convertSign(alone, SignConvention::Command, test::held);
        VERIFY_RESULT(together);
        VERIFY_RESULT(single);
        QCOMPARE(together->table.columns[0].values, single->table.columns[0].values);
    }

    void theNumbersOfAxesInAFileMustNotSayAnotherTarget()
    {
        const std::array tables{waves({"X"}, "X")};
        ConversionRequest request = requestFor(calibration_csv::format(), isg_crosscomp::format());
        request.writing.settings["axis"] = "3";
        request.writing.settings["master-axis"] = "1";
        VERIFY_ERROR(convertTables(tables, request), ErrorCode::InvalidArgument);
        request.writing.settings["axis"] = "1";
        VERIFY_RESULT(convertTables(tables, request));
    }

    void everyFormatHoldsWhatIsMeantAndGivesItBack_data()
    {
        QTest::addColumn<int>("format");
        QTest::addColumn<int>("dimensions");
        QTest::addColumn<int>("own");
        const auto formats = tableFormats();
        for (std::size_t f = 0; f < formats.size(); ++f)
            for (int dimensions = 1; dimensions <= 3; ++dimensions)
                for (int own = -1; own < dimensions; ++own)
                    if (formats[f]->write && formats[f]->facts.fewestDimensions <= dimensions
                        && dimensions <= formats[f]->facts.mostDimensions)
                        QTest::addRow("%s, %dD, %s", formats[f]->facts.name.data(), dimensions,
                            own < 0 ? "another axis" : qPrintable(QString::number(own + 1)))
                            << static_cast<int>(f) << dimensions << own;
    }
    void everyFormatHoldsWhatIsMeantAndGivesItBack()
    {
        QFETCH(int, format);
        QFETCH(int, dimensions);
        QFETCH(int, own);
        const TableFormat& to = *tableFormats()[static_cast<std::size_t>(format)];
        const bool hasNames = to.facts.name.starts_with("siemens");
        std::vector<std::string> names{hasNames ? "X1" : "1", hasNames ? "Y2" : "2", "3"};
        names.resize(static_cast<std::size_t>(dimensions));
        const std::string target = own >= 0 ? names[static_cast<std::size_t>(own)]
            : hasNames                      ? "Z3"
            : &to == &kmotion_geo::format() ? "other"
                                            : "4";
        const std::optional<std::size_t> axis =
            own < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(own));
        const std::array tables{waves(names, target)};
        ConversionRequest asked = requestFor(calibration_csv::format(), to);
        if (to.facts.name == "weihong" || to.facts.name.starts_with("heidenhain"))
            asked.writing.settings["axis"] = "X";
        if (to.facts.name.starts_with("heidenhain") && !axis)
            asked.writing.settings["target-axis"] = "Z";
        if (to.facts.name == "heidenhain-com-530")
            asked.writing.settings["any-distance"] = "yes";
        if (to.facts.name == "fanuc")
            asked.writing.settings = {{"reference-number", "100"}, {"detection-unit", "0.00001"},
                {"largest-step", "100000"}};
        if (to.facts.name == "acs-2d") {
            asked.writing.settings = {{"source-axis-1", "0"}, {"source-axis-2", "1"}};
            if (!axis)
                asked.writing.settings["target-axis"] = "2";
        }
        const auto conversion = convertTables(tables, asked);
        if (isOfAxesForThemselves(to) && !axis) {
            VERIFY_ERROR(conversion, ErrorCode::FormatCannotHold);
            return;
        }
        VERIFY_RESULT(conversion);

        const NeutralTable& held = conversion->tables.front().result;
        const bool isSameSign = to.facts.sign == SignConvention::Feedback;
        QCOMPARE(
            farthest(held.columns.front(), expectedValues(tables[0], held, axis, isSameSign), 6e-5),
            QString());
        if (!to.read)
            return;

        const auto reading = to.read(conversion->written.bytes, readOptions(to.facts, dimensions));
        VERIFY_RESULT(reading);
        std::vector<NeutralTable> back = separateColumns(reading->tables);
        if (&to == &kmotion_geo::format()) // X, Y and Z, whatever was written
            std::swap(back[0], back[axis.value_or(2)]);
        back.resize(1);
        const auto stated = targetOf(back.front(), back.front().columns.front());
        QVERIFY(!stated || stated == TargetAxis{axis});
        ConversionRequest request = requestFor(to, calibration_csv::format());
        if (!stated)
            request.targets = {axis ? sourceTarget(*axis) : std::string(otherAxis)};
        request.dropsWrap = true;
        const auto again = convertTables(back, request);
        VERIFY_RESULT(again);
        CsvOptions options;
        options.dimensions = dimensions;
        const CsvReading csv = parseCalibrationCsv(again->written.bytes, options);
        QVERIFY(csv.data);
        const NeutralTable returned = neutralTable(*csv.data);
        QCOMPARE(targetOf(returned, returned.columns.front()), std::optional(TargetAxis{axis}));
        QCOMPARE(farthest(returned.columns.front(),
                     expectedValues(held, returned, axis, isSameSign), 6e-5),
            QString());
        // Between the knots of an even grid a shifted lookup rounds the curve off.
        const bool isRounded = axis && to.facts.knots != KnotRule::Any;
        QCOMPARE(farthest(returned.columns.front(), tables[0].columns[0].values,
                     isRounded ? 1e-2 : 6e-5),
            QString());
        if (!isRounded)
            for (std::size_t n = 0; n < names.size(); ++n)
                for (std::size_t i = 0; i < 9; ++i)
                    QVERIFY(
                        std::abs(returned.axes[n].knots[i] - tables[0].axes[n].knots[i]) < 1e-9);
    }

    /// A comment of another controller's file may look like a statement of a calibration file.
    void aCommentOfAnotherControllersFileStatesNoTarget_data()
    {
        QTest::addColumn<std::string>("target");
        for (const char* target : {"", "X"})
            QTest::addRow("\"%s\"", target) << std::string(target);
    }
    void aCommentOfAnotherControllersFileStatesNoTarget()
    {
        QFETCH(const std::string, target);
        NeutralTable table = waves({"X"}, target);
        table.name = "values";
        table.columns.front().name = "values";
        table.notes = {"Target: 2 um", "sign: correction"};
        const NeutralTable tables[] = {table};
        const TableFormat& csv = calibration_csv::format();
        const auto conversion = convertTables(tables, requestFor(siemens_eec::format(), csv));
        VERIFY_RESULT(conversion);
        const auto reading = csv.read(conversion->written.bytes, readOptions(csv.facts, 1));
        VERIFY_RESULT(reading);
        for (const Diagnostic& said : reading->diagnostics)
            QVERIFY(said.code != DiagnosticCode::TargetNotKnown
                && said.code != DiagnosticCode::Assumption);
        QCOMPARE(reading->tables.at(0).columns.at(0).target, target);
    }

    /// A drive takes them in the unit of the axis that they correct, which a .TAMtbl cannot say.
    void lengthsOverAnAngleKeepTheirUnit()
    {
        NeutralTable table = waves({"C"}, "X");
        table.axes.front().unit = "deg";
        const NeutralTable tables[] = {table};
        const TableFormat& csv = calibration_csv::format();
        const auto conversion = convertTables(tables, requestFor(siemens_cec::format(), csv));
        VERIFY_RESULT(conversion);
        QCOMPARE(conversion->written.held.at(0).columns.at(0).unit, std::string("mm"));
        const auto refused =
            convertTables(tables, requestFor(siemens_cec::format(), tam_table::format()));
        VERIFY_ERROR(refused, ErrorCode::InvalidArgument);
        QVERIFY(sentence(refused.error()).find("--value-unit mm") != std::string::npos);
    }
};

AXISCOMP_TEST(TestTargets)

} // namespace tst_targets

#include "tst_targets.moc"
