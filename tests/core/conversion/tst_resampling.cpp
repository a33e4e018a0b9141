// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/resampling/resampling.h"

#include "core/conversion/resampling/axis_interpolant.h"
#include "tests/core/conversion/numeric_tables.h"
#include "tests/support/test_registry.h"

#include <cstring>
#include <numbers>

namespace tst_resampling {

using namespace axiscomp;
using test::addColumn;
using test::axisX;
using test::evenAxis;
using test::held;
using test::tableOver;
using Values = std::vector<double>;

namespace {

constexpr double pi = std::numbers::pi;

AxisRequest byPoints(std::size_t points)
{
    return {.points = points};
}
AxisRequest byDistance(double distance)
{
    return {.distance = distance};
}

ResamplingRequest request(
    std::vector<AxisRequest> axes, ResamplingMethod method = ResamplingMethod::Linear)
{
    return {.axes = std::move(axes), .method = method};
}

bool areSameBits(const Values& a, const Values& b)
{
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

/// Positions at uneven distances.
SourceAxis unevenAxis(const std::string& name, std::size_t count)
{
    SourceAxis axis;
    axis.name = name;
    axis.unit = "mm";
    for (std::size_t i = 0; i < count; ++i) {
        const auto x = static_cast<double>(i);
        axis.knots.push_back(3.0 * x + std::sin(7.0 * x));
    }
    return axis;
}

NeutralTable unevenTable(int dimensions)
{
    NeutralTable table;
    const std::vector<std::string> names{"X", "Y", "Z"};
    for (int n = 0; n < dimensions; ++n)
        table.axes.push_back(unevenAxis(names[static_cast<std::size_t>(n)], 5 + 2 * n));
    addColumn(table, "X", [](const Values& p) {
        double phase = 0.3;
        for (const double x : p)
            phase = 1.7 * phase + x;
        return std::sin(phase);
    });
    return table;
}

double maximum(const Values& values)
{
    return *std::ranges::max_element(values);
}

} // namespace

class TestResampling : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void anEvenTableOntoItsOwnGridIsUnchangedBitByBit_data()
    {
        QTest::addColumn<int>("dimensions");
        QTest::addColumn<bool>("isCubic");
        QTest::addColumn<AxisRequest>("axis");
        for (int dimensions = 1; dimensions <= 3; ++dimensions) {
            for (const bool isCubic : {false, true}) {
                const char* const method = isCubic ? "cubic" : "linear";
                QTest::addRow("%dD, %s, points", dimensions, method)
                    << dimensions << isCubic << byPoints(12);
                QTest::addRow("%dD, %s, distance", dimensions, method)
                    << dimensions << isCubic << byDistance(0.1);
                QTest::addRow("%dD, %s, as it is", dimensions, method)
                    << dimensions << isCubic << AxisRequest{};
            }
        }
    }
    void anEvenTableOntoItsOwnGridIsUnchangedBitByBit()
    {
        QFETCH(int, dimensions);
        QFETCH(bool, isCubic);
        QFETCH(AxisRequest, axis);
        SourceAxis source;
        source.unit = "mm";
        for (int i = 0; i < 12; ++i) // decimals, as a file has them, which no sum of 0.1 meets
            source.knots.push_back((i - 4) / 10.0);
        source.step = 0.1;
        NeutralTable table;
        const auto method = isCubic ? ResamplingMethod::MonotoneCubic : ResamplingMethod::Linear;
        for (int n = 0; n < dimensions; ++n)
            table.axes.push_back(source);
        addColumn(table, "X", [](const Values& p) { return std::sin(40 * p[0]) / (2 + p.back()); });
        table.columns[0].values[3] = -0.0;
        table.columns[0].filled = {2, 5};
        const auto result = resample(
            table, request(std::vector(static_cast<std::size_t>(dimensions), axis), method));
        VERIFY_RESULT(result);
        QCOMPARE(result->table, table);
        QVERIFY(areSameBits(result->table.columns[0].values, table.columns[0].values));
        QVERIFY(areSameBits(result->table.axes[0].knots, table.axes[0].knots));
        QCOMPARE(result->report.columns[0].largest, 0.0);
        QVERIFY(result->report.columns[0].position.empty());
        QCOMPARE(result->report.columns[0].rms, 0.0);
        QVERIFY(result->report.remarks.empty());
        QCOMPARE(result->grid[0], (AxisGrid{-0.4, 0.1, 12}));
    }

    void linearIsWhatAControllerMakesOfTheSource_data()
    {
        QTest::addColumn<int>("dimensions");
        for (int dimensions = 1; dimensions <= 3; ++dimensions)
            QTest::addRow("%dD", dimensions) << dimensions;
    }
    void linearIsWhatAControllerMakesOfTheSource()
    {
        QFETCH(int, dimensions);
        const NeutralTable table = unevenTable(dimensions);
        std::vector<AxisRequest> axes{byPoints(31), byPoints(4), byPoints(9)};
        axes.resize(static_cast<std::size_t>(dimensions));
        const auto result = resample(table, request(axes));
        VERIFY_RESULT(result);
        QVERIFY(isEven(result->table));
        const ControllerLookup applied(table, 0, held);
        for (std::size_t i = 0; i < result->table.pointCount(); ++i) {
            const double expected = applied.at(test::positionOf(result->table, i));
            QVERIFY(std::abs(result->table.columns[0].values[i] - expected) < 1e-13);
        }
        for (std::size_t n = 0; n < axes.size(); ++n) {
            QCOMPARE(result->table.axes[n].knots.size(), axes[n].points);
            QCOMPARE(result->table.axes[n].knots.front(), table.axes[n].knots.front());
            QCOMPARE(result->table.axes[n].knots.back(), table.axes[n].knots.back());
        }
    }

    void theReportIsTheDeviationAtTheKnotsOfTheSource_data()
    {
        linearIsWhatAControllerMakesOfTheSource_data();
    }
    void theReportIsTheDeviationAtTheKnotsOfTheSource()
    {
        QFETCH(int, dimensions);
        NeutralTable table = unevenTable(dimensions);
        addColumn(table, "Y", [](const Values& p) { return p[0]; });
        for (const auto method : {ResamplingMethod::Linear, ResamplingMethod::MonotoneCubic}) {
            const std::vector<AxisRequest> axes(static_cast<std::size_t>(dimensions), byPoints(6));
            const auto result = resample(table, request(axes, method));
            VERIFY_RESULT(result);
            const ControllerLookup applied(result->table, 0, held);
            double largest = 0.0;
            double sum = 0.0;
            Values where;
            for (std::size_t i = 0; i < table.pointCount(); ++i) {
                const double deviation =
                    std::abs(applied.at(test::positionOf(table, i)) - table.columns[0].values[i]);
                sum += deviation * deviation;
                if (deviation > largest)
                    where = test::positionOf(table, i);
                largest = std::max(largest, deviation);
            }
            const ColumnDeviation& report = result->report.columns[0];
            QVERIFY(largest > 0.01);
            QVERIFY(std::abs(report.largest - largest) < 1e-13);
            QCOMPARE(report.position, where);
            const double rms = std::sqrt(sum / static_cast<double>(table.pointCount()));
            QVERIFY(std::abs(report.rms - rms) < 1e-13);
            QVERIFY(result->report.columns[1].largest < 1e-13);
        }
    }

    /// By hand: slopes 7/6, 9/13 and 1/6 at the knots
    void theMonotoneCubicHasTheSlopesOfPchip()
    {
        auto table = tableOver({axisX({0, 1, 3})}, "X", [](const Values&) { return 0.0; });
        table.columns[0].values = {0, 1, 2};
        const auto result =
            resample(table, request({byDistance(0.5)}, ResamplingMethod::MonotoneCubic));
        VERIFY_RESULT(result);
        const Values& values = result->table.columns[0].values;
        QCOMPARE(values[0], 0.0);
        QVERIFY(std::abs(values[1] - (0.5 + 0.125 * (7.0 / 6 - 9.0 / 13))) < 1e-15);
        QCOMPARE(values[2], 1.0);
        QVERIFY(std::abs(values[4] - (1.5 + 0.25 * (9.0 / 13 - 1.0 / 6))) < 1e-15);
        QCOMPARE(values[6], 2.0);
    }

    void theMonotoneCubicIsExactAtKnotsAndForLines()
    {
        const auto steps = tableOver(
            {axisX({0, 1, 4, 5, 9, 10})}, "X", [](const Values& p) { return std::cos(p[0]); });
        const auto fine =
            resample(steps, request({byDistance(0.25)}, ResamplingMethod::MonotoneCubic));
        VERIFY_RESULT(fine);
        for (std::size_t i = 0; i < 6; ++i) {
            const auto index = static_cast<std::size_t>(4 * steps.axes[0].knots[i]);
            QCOMPARE(fine->table.columns[0].values[index], steps.columns[0].values[i]);
        }
        QCOMPARE(fine->report.columns[0].largest, 0.0);
        const auto line = tableOver(
            {axisX({0, 1, 4, 5, 9, 10})}, "X", [](const Values& p) { return 3 - 0.7 * p[0]; });
        const auto finer =
            resample(line, request({byPoints(101)}, ResamplingMethod::MonotoneCubic));
        VERIFY_RESULT(finer);
        for (std::size_t i = 0; i <= 100; ++i)
            QVERIFY(std::abs(finer->table.columns[0].values[i] - (3 - 0.07 * double(i))) < 1e-14);
        const auto two = tableOver({axisX({0, 1})}, "X", [](const Values& p) { return p[0]; });
        const auto plain = resample(two, request({byPoints(5)}, ResamplingMethod::MonotoneCubic));
        VERIFY_RESULT(plain);
        QCOMPARE(plain->table.columns[0].values, (Values{0, 0.25, 0.5, 0.75, 1}));
    }

    void theMonotoneCubicIsMonotoneWhereTheKnotsAre()
    {
        auto table = tableOver({unevenAxis("X", 40)}, "X", [](const Values&) { return 0.0; });
        Values& values = table.columns[0].values;
        for (std::size_t i = 1; i < values.size(); ++i) // steps of very different heights
            values[i] = values[i - 1] + (i < 25 ? 1 : -1) * std::pow(10.0, double(i * i % 7) - 4);
        const auto result =
            resample(table, request({byPoints(5000)}, ResamplingMethod::MonotoneCubic));
        VERIFY_RESULT(result);
        const Values& made = result->table.columns[0].values;
        const double turn = table.axes[0].knots[24];
        for (std::size_t i = 1; i < made.size(); ++i) {
            const Values& knots = result->table.axes[0].knots;
            if (knots[i] <= turn)
                QVERIFY(made[i] >= made[i - 1]);
            else if (knots[i - 1] >= turn)
                QVERIFY(made[i] <= made[i - 1]);
        }
        QVERIFY(maximum(made) <= maximum(values));
        QVERIFY(test::largestDifference(
                    made, resample(table, request({byPoints(5000)}))->table.columns[0].values)
            > 0.05); // it is not linear
    }

    void theMonotoneCubicGoesAlongOneAxisAfterTheOther()
    {
        const auto formula = [](const Values& p) {
            return (1 + std::sin(p[0])) * (2 + p[1] * p[1]);
        };
        const auto plane = tableOver({unevenAxis("X", 6), unevenAxis("Y", 5)}, "X", formula);
        const auto cubic = ResamplingMethod::MonotoneCubic;
        const auto both = resample(plane, request({byPoints(9), byPoints(8)}, cubic));
        VERIFY_RESULT(both);
        // a product of two functions of one variable
        const auto alongX = resample(tableOver({unevenAxis("X", 6)}, "X",
                                         [](const Values& p) { return 1 + std::sin(p[0]); }),
            request({byPoints(9)}, cubic));
        const auto alongY = resample(
            tableOver({unevenAxis("Y", 5)}, "Y", [](const Values& p) { return 2 + p[0] * p[0]; }),
            request({byPoints(8)}, cubic));
        for (std::size_t i = 0; i < 72; ++i) {
            const double expected =
                alongX->table.columns[0].values[i % 9] * alongY->table.columns[0].values[i / 9];
            QVERIFY(std::abs(both->table.columns[0].values[i] - expected)
                < 1e-12 * std::abs(expected) + 1e-12);
        }
    }

    void aDistanceThatDoesNotDivideTheRangeEndsInsideTheData()
    {
        const auto table =
            tableOver({axisX({0, 40, 103})}, "X", [](const Values& p) { return p[0]; });
        const auto inside = resample(table, request({byDistance(10)}));
        VERIFY_RESULT(inside);
        QCOMPARE(inside->table.axes[0].knots.size(), std::size_t(11));
        QCOMPARE(inside->table.axes[0].knots.back(), 100.0);
        QCOMPARE(inside->grid[0], (AxisGrid{0, 10, 11}));
        QCOMPARE(inside->report.remarks.size(), std::size_t(1));
        QCOMPARE(inside->report.remarks[0].english(),
            std::string("the range of X from 0 mm to 103 mm is no whole multiple of 10 mm: the "
                        "grid ends at 100 mm, 3 mm before its end"));
        QVERIFY(inside->report.losses == inside->report.remarks);
        // what is lost is in the report
        QCOMPARE(inside->report.columns[0].largest, 3.0);
        QCOMPARE(inside->report.columns[0].position, (Values{103}));

        ResamplingRequest holding = request({byDistance(10)});
        holding.holdsEnds = true;
        const auto behind = resample(table, holding);
        VERIFY_RESULT(behind);
        QCOMPARE(behind->table.axes[0].knots.back(), 110.0);
        QCOMPARE(behind->table.columns[0].values.back(), 103.0);
        QVERIFY(behind->report.remarks[0].english().ends_with(
            "the grid ends at 110 mm, 7 mm behind it"));
        QVERIFY(behind->report.losses.empty());
    }

    void beyondTheDataTheEndsAreHeldOnlyWhenAsked()
    {
        const auto table =
            tableOver({axisX({0, 5, 10})}, "X", [](const Values& p) { return 1 + p[0]; });
        ResamplingRequest wide = request({{.points = 9, .start = -5, .end = 15}});
        VERIFY_ERROR(resample(table, wide), ErrorCode::ResamplingImpossible);
        wide.holdsEnds = true;
        const auto result = resample(table, wide);
        VERIFY_RESULT(result);
        QCOMPARE(result->table.columns[0].values, (Values{1, 1, 1, 3.5, 6, 8.5, 11, 11, 11}));
        QCOMPARE(result->report.columns[0].largest, 0.0);
    }

    void onlyKnotsWithinTheWantedRangeCount()
    {
        const auto table = tableOver({axisX({0, 1, 2, 8, 9, 10})}, "X",
            [](const Values& p) { return p[0] == 1 || p[0] == 8 ? 1.0 : 0.0; });
        const auto result = resample(table, request({{.points = 2, .start = 2, .end = 10}}));
        VERIFY_RESULT(result);
        QCOMPARE(result->table.axes[0].knots, (Values{2, 10}));
        QCOMPARE(result->report.columns[0].largest, 1.0);
        QCOMPARE(result->report.columns[0].position, (Values{8}));
        QCOMPARE(result->report.columns[0].rms, 0.5);
    }

    void aModuloAxisStaysClosed_data()
    {
        QTest::addColumn<bool>("isCubic");
        QTest::addColumn<AxisRequest>("axis");
        for (const bool isCubic : {false, true}) {
            const char* const method = isCubic ? "cubic" : "linear";
            QTest::addRow("%s, points", method) << isCubic << byPoints(50);
            QTest::addRow("%s, distance", method) << isCubic << byDistance(7.2);
            QTest::addRow("%s, from another start", method)
                << isCubic << AxisRequest{.points = 50, .start = -100.3};
        }
    }
    void aModuloAxisStaysClosed()
    {
        QFETCH(bool, isCubic);
        QFETCH(AxisRequest, axis);
        const auto method = isCubic ? ResamplingMethod::MonotoneCubic : ResamplingMethod::Linear;
        auto table = tableOver({test::turningAxis(38)}, "C",
            [](const Values& p) { return std::sin((p[0] - 20) * pi / 180); });
        table.columns[0].values.back() = table.columns[0].values.front();
        const auto result = resample(table, request({axis}, method));
        VERIFY_RESULT(result);
        const SourceAxis& made = result->table.axes[0];
        QCOMPARE(made.wrap, std::optional(360.0));
        QVERIFY(made.knots.back() - made.knots.front() <= 360.0);
        QVERIFY(isEven(made));
        const Values& values = result->table.columns[0].values;
        QCOMPARE(values.back(), values.front());
        const ControllerLookup applied(table, 0, held);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double exact = std::sin((made.knots[i] - 20) * pi / 180);
            QVERIFY(std::abs(values[i] - exact) < 0.006);
            if (!isCubic)
                QVERIFY(std::abs(values[i] - applied.at(std::span(&made.knots[i], 1))) < 1e-13);
        }
        QVERIFY(result->report.columns[0].largest > 0.0);
        QVERIFY(result->report.columns[0].largest < 0.006);
    }

    void aModuloAxisWithoutItsLastPointIsClosed()
    {
        auto table = tableOver(
            {evenAxis("C", "deg", 0, 90, 4)}, "C", [](const Values& p) { return p[0] / 90; });
        table.axes[0].wrap = 360;
        const auto result = resample(table, request({byDistance(45)}));
        VERIFY_RESULT(result);
        QCOMPARE(result->table.axes[0].knots.back(), 360.0);
        QCOMPARE(result->table.columns[0].values, (Values{0, 0.5, 1, 1.5, 2, 2.5, 3, 1.5, 0}));
    }

    void aModuloCubicIsSmoothAcrossItsSeam()
    {
        auto table = tableOver({test::turningAxis(25)}, "C",
            [](const Values& p) { return std::sin((p[0] - 100) * pi / 180); });
        table.columns[0].values.back() = table.columns[0].values.front();
        const auto result =
            resample(table, request({byPoints(36001)}, ResamplingMethod::MonotoneCubic));
        VERIFY_RESULT(result);
        const Values& v = result->table.columns[0].values;
        const double before = v[36000] - v[35999];
        const double behind = v[1] - v[0];
        // a kink, as linear values have there, would be more than the slope itself
        QVERIFY(std::abs(before - behind) < 0.01 * std::abs(behind));
    }

    void theLastPointIsTheEndAndTheFirstOfTheNextTurnExactly()
    {
        for (int start = 0; start < 60; ++start) {
            NeutralTable table;
            table.axes = {axisX({0.1 * start, 0.1 * start + 1.7, 0.1 * start + 7.3})};
            addColumn(table, "X", [](const Values& p) { return std::sin(p[0]); });
            const auto plain = resample(table, request({byPoints(23)}));
            VERIFY_RESULT(plain);
            QVERIFY(plain->table.axes[0].knots.back() == table.axes[0].knots.back());
            table.axes[0].wrap = 7.3; // a full turn
            table.columns[0].values.back() = table.columns[0].values.front();
            const auto turning = resample(table, request({byPoints(23)}));
            VERIFY_RESULT(turning);
            const Values& values = turning->table.columns[0].values;
            QVERIFY2(values.back() == values.front(), QByteArray::number(start)); // no tolerance
        }
    }

    void severalColumnsAndDirectionsAreResampledAlike()
    {
        NeutralTable table;
        table.axes = {axisX({0, 1, 10})};
        table.notes = {"measured"};
        addColumn(
            table, "X", [](const Values& p) { return p[0]; }, Direction::Positive);
        addColumn(
            table, "X", [](const Values& p) { return -p[0]; }, Direction::Negative);
        table.axes[0].step = 1;
        table.columns[1].filled = {1};
        const auto result = resample(table, request({byPoints(3)}));
        VERIFY_RESULT(result);
        QCOMPARE(result->table.columns[0].values, (Values{0, 5, 10}));
        QCOMPARE(result->table.columns[1].values, (Values{0, -5, -10}));
        QCOMPARE(result->table.columns[1].direction, Direction::Negative);
        QVERIFY(result->table.columns[1].filled.empty()); // other points
        QCOMPARE(result->table.axes[0].step, 0.0); // not multiples any more
        QCOMPARE(result->table.notes, table.notes);
    }

    void whatCannotBeResampledIsRefused_data()
    {
        QTest::addColumn<AxisRequest>("axis");
        QTest::addColumn<QByteArray>("error");
        const auto row = [](const char* name, const AxisRequest& axis, const char* error) {
            QTest::addRow("%s", name) << axis << QByteArray(error);
        };
        row("both", {.points = 3, .distance = 1},
            "InvalidArgument: for X both a number of points and a distance are given");
        row("one point", byPoints(1), "InvalidArgument: a grid along X needs at least two points");
        row("negative", byDistance(-1),
            "InvalidArgument: the distance along X must be a number above 0");
        row("not a number", byDistance(NAN), "InvalidArgument: the distance along X");
        row("uneven", {}, "InvalidArgument: the positions of X are not evenly spaced; give");
        row("a part of nothing", {.start = 1}, "InvalidArgument: for a part of X a number of");
        row("turned round", {.points = 3, .start = 9, .end = 1},
            "InvalidArgument: the grid along X must end above its start, not go from 9 mm to 1 mm");
        row("infinite", {.points = 3, .end = INFINITY}, "InvalidArgument: the grid along X must");
        row("too early", {.points = 3, .start = -1},
            "ResamplingImpossible: the table cannot be resampled: the grid along X begins at -1 "
            "mm, before the data at 0 mm; stay within the data, or let the end values be held");
        row("too late", {.points = 3, .end = 10.5},
            "ResamplingImpossible: the table cannot be resampled: the grid along X ends at 10.5 "
            "mm, behind the data at 10 mm; stay");
        row("too long", byDistance(11),
            "ResamplingImpossible: the table cannot be resampled: a "
            "distance of 11 mm is longer than the range of X");
        row("too many", byPoints(4'000'001),
            "ResamplingImpossible: the table cannot be resampled: 4000001 points along X");
        row("too short", byDistance(1e-300),
            "ResamplingImpossible: the table cannot be resampled: a distance of 1e-300 mm along X "
            "makes more than 4000000 points");
        row("too close", {.points = 3'000'000, .start = 9.999999999},
            "ResamplingImpossible: the table cannot be resampled: the points along X would be so "
            "close");
    }
    void whatCannotBeResampledIsRefused()
    {
        QFETCH(AxisRequest, axis);
        QFETCH(QByteArray, error);
        const auto table =
            tableOver({axisX({0, 1, 10})}, "X", [](const Values& p) { return p[0]; });
        const auto result = resample(table, request({axis}));
        QVERIFY(!result);
        const std::string text = test::describe(result.error());
        QVERIFY2(text.starts_with(error.toStdString()), text.c_str());
    }

    void whatAModuloAxisCannotTakeIsRefused_data()
    {
        QTest::addColumn<AxisRequest>("axis");
        QTest::addColumn<double>("last");
        QTest::addColumn<QByteArray>("error");
        QTest::addRow("distance")
            << byDistance(7) << 0.0
            << QByteArray("the full turn of C, 360 deg, is no whole multiple of 7 deg; possible "
                          "are 6.92307692308 deg or 7.05882352941 deg");
        QTest::addRow("part of a turn") << AxisRequest{.points = 5, .end = 180} << 0.0
                                        << QByteArray("must be one full turn, from 0 deg to 360");
        QTest::addRow("ends differ")
            << byPoints(5) << 0.5
            << QByteArray("a full turn of C begins with 0 deg and ends with 0.5 deg; make both");
    }
    void whatAModuloAxisCannotTakeIsRefused()
    {
        QFETCH(AxisRequest, axis);
        QFETCH(double, last);
        QFETCH(QByteArray, error);
        auto table = tableOver({test::turningAxis(9)}, "C", [](const Values&) { return 0.0; });
        table.columns[0].values.back() = last;
        const auto result = resample(table, request({axis}));
        QVERIFY(!result);
        const std::string text = sentence(result.error());
        QVERIFY2(text.find(error.toStdString()) != std::string::npos, text.c_str());
    }

    void wholeTablesThatCannotBeAreRefused()
    {
        const auto plane = tableOver({axisX({0, 1, 10}), evenAxis("Y", "mm", 0, 1, 3)}, "X",
            [](const Values& p) { return p[0]; });
        VERIFY_ERROR(resample(plane, request({byPoints(3)})), ErrorCode::InvalidArgument);
        VERIFY_ERROR(resample(plane, request({byPoints(3000), byPoints(3000)})),
            ErrorCode::ResamplingImpossible);
        VERIFY_ERROR(resample(NeutralTable{}, request({})), ErrorCode::InvalidArgument);
        const auto huge = tableOver({axisX({0, 1, 10})}, "X",
            [](const Values& p) { return p[0] == 1 ? -1.7e308 : 1.7e308; });
        VERIFY_ERROR(resample(huge, request({byPoints(4)})), ErrorCode::ResamplingImpossible);
    }

    void eightLinesHaveTheBitsOfEachByItself_data()
    {
        QTest::addColumn<ResamplingMethod>("method");
        QTest::addColumn<bool>("isModulo");
        for (const auto method : {ResamplingMethod::Linear, ResamplingMethod::MonotoneCubic,
                 ResamplingMethod::NaturalSpline, ResamplingMethod::SmoothingSpline})
            for (const bool isModulo : {false, true})
                QTest::addRow(
                    "%s%s", resamplingMethodName(method).data(), isModulo ? ", modulo axis" : "")
                    << method << isModulo;
    }
    void eightLinesHaveTheBitsOfEachByItself()
    {
        QFETCH(ResamplingMethod, method);
        QFETCH(bool, isModulo);
        constexpr std::size_t count = 12;
        SourceAxis axis = unevenAxis("X", count);
        if (isModulo)
            axis.wrap = 1.25 * (axis.knots.back() - axis.knots.front());
        const AxisInterpolant interpolant(axis, method);
        Values values;
        for (std::size_t i = 0; i < 8 * count; ++i)
            values.push_back(i % 7 == 0 ? 0.0 : std::sin(static_cast<double>(i * i)));
        // Beside each other, and one behind the other.
        for (const std::size_t stride : {std::size_t{8}, std::size_t{1}}) {
            std::array<std::size_t, 8> firsts{};
            for (std::size_t n = 0; n < 8; ++n)
                firsts[n] = stride == 8 ? n : n * count;
            AxisInterpolant::EightLines eight;
            interpolant.load(values.data(), EightPlaces(firsts), stride, eight);
            for (std::size_t n = 0; n < 8; ++n) {
                AxisInterpolant::Line line;
                interpolant.load(&values[firsts[n]], stride, line);
                for (double x = -5.0; x < 45.0; x += 0.125) {
                    const auto place = interpolant.placeOf(x);
                    Eight found;
                    interpolant.at(eight, place, found);
                    QVERIFY(areSameBits({found[n]}, {interpolant.at(line, place)}));
                }
            }
        }
    }
};

AXISCOMP_TEST(TestResampling)

} // namespace tst_resampling

#include "tst_resampling.moc"
