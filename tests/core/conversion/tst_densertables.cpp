// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tables that follow a spline more closely than their own points do (AN140 5.2).
#include "core/conversion/resampling/resampling.h"
#include "core/curve/smoothing_spline.h"
#include "core/metrology/judge/iso230.h"

#include "tests/core/conversion/numeric_tables.h"
#include "tests/core/metrology/measurement_reading.h"
#include "tests/support/test_registry.h"

#include <numbers>
#include <random>

namespace tst_densertables {

using namespace axiscomp;
using test::axisX;
using test::evenAxis;
using test::tableOver;
using Values = std::vector<double>;

namespace {

constexpr auto spline = ResamplingMethod::NaturalSpline;
constexpr auto smooth = ResamplingMethod::SmoothingSpline;

/// The means of both directions, in um.
NeutralTable meansOfB02x()
{
    const auto reading = test::readAs("runs", test::publicMeasurement("b02_x.csv"));
    const Iso230Figures figures = iso230Figures(reading.measurement.value_or(Measurement{}));
    SourceAxis axis = axisX({});
    Values means;
    for (const TargetFigures& target : figures.targets) {
        axis.knots.push_back(target.position);
        means.push_back(1000.0 * target.mean.value_or(0.0));
    }
    NeutralTable table = tableOver({axis}, "X", [](const Values&) { return 0.0; });
    table.columns.front().unit = "um";
    table.columns.front().values = means;
    return table;
}

Result<ResampledTable> onto(
    const NeutralTable& table, const std::vector<std::size_t>& points, ResamplingMethod method)
{
    ResamplingRequest request{.axes = {}, .method = method};
    for (const std::size_t count : points)
        request.axes.push_back({.points = count});
    return resample(table, request);
}

bool isNear(double value, double expected, double limit)
{
    return std::abs(value - expected) <= limit;
}

} // namespace

class TestDenserTables : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    /// Computed with scipy's CubicSpline(bc_type='natural').
    void theDistanceFromTheSplineAndItsSlopesAreThoseOfAnotherProgram_data()
    {
        QTest::addColumn<int>("points");
        QTest::addColumn<double>("distance");
        QTest::addColumn<double>("slopeChange");
        QTest::newRow("9") << 9 << 9.295609 << 16.4275;
        QTest::newRow("81") << 81 << 0.147016 << 2.3695;
        QTest::newRow("641") << 641 << 0.002381 << 0.3050;
    }
    void theDistanceFromTheSplineAndItsSlopesAreThoseOfAnotherProgram()
    {
        QFETCH(int, points);
        QFETCH(double, distance);
        QFETCH(double, slopeChange);
        const auto result = onto(meansOfB02x(), {static_cast<std::size_t>(points)}, spline);
        VERIFY_RESULT(result);
        if (points == 9) { // its own points stay as they are, and nothing is said
            QCOMPARE(result->table.columns.front().values, meansOfB02x().columns.front().values);
            return;
        }
        QCOMPARE(result->report.columns.front().density.size(), std::size_t{1});
        const auto& density = result->report.columns.front().density.front();
        QCOMPARE(density.points, static_cast<std::size_t>(points));
        QVERIFY(isNear(density.largestDistance, distance, 5e-7));
        QVERIFY(isNear(density.largestSlopeChange, slopeChange, 5e-5));
        QVERIFY(result->report.columns.front().largest < 1e-9); // through every point
    }

    void theFewestPointsThatKeepADistanceAreFound_data()
    {
        QTest::addColumn<double>("within");
        QTest::addColumn<int>("points");
        QTest::newRow("1 um") << 1.0 << 32;
        QTest::newRow("0.1 um") << 0.1 << 100;
        QTest::newRow("0.01 um") << 0.01 << 313;
    }
    void theFewestPointsThatKeepADistanceAreFound()
    {
        QFETCH(double, within);
        QFETCH(int, points);
        const auto found = coarsestGrid(meansOfB02x(), within, spline);
        VERIFY_RESULT(found);
        QCOMPARE(found->points, (std::vector<std::size_t>{static_cast<std::size_t>(points)}));
        QVERIFY(found->deviation <= within);
    }

    void aSumOfCurvesIsFollowedAlongEveryAxis()
    {
        const auto alongX = [](double x) { return std::sin(x / 2.0); };
        const auto alongY = [](double y) { return 0.5 * std::cos(y / 3.0); };
        const auto table = tableOver({evenAxis("X", "mm", 0, 1, 11), evenAxis("Y", "mm", 0, 2, 8)},
            "X", [&](const Values& p) { return alongX(p[0]) + alongY(p[1]); });
        constexpr double within = 0.004;
        const auto grid = coarsestGrid(table, within, spline);
        VERIFY_RESULT(grid);
        QVERIFY(grid->deviation <= within);
        const auto made = onto(table, grid->points, spline);
        VERIFY_RESULT(made);
        // the surface of a sum is the sum of two splines, which are tested against scipy
        const auto curveOf = [](const SourceAxis& axis, const auto& formula) {
            Values values;
            for (const double knot : axis.knots)
                values.push_back(formula(knot));
            return *interpolatingSpline({axis.knots, values});
        };
        const FittedCurve curves[] = {
            curveOf(table.axes[0], alongX), curveOf(table.axes[1], alongY)};
        const auto lines = [&](std::size_t axis, double at) {
            const SourceAxis& grown = made->table.axes[axis];
            const std::size_t cell = std::min(grown.knots.size() - 2,
                static_cast<std::size_t>(
                    (at - grown.knots[0]) / (grown.knots[1] - grown.knots[0])));
            const double low = curves[axis].at(grown.knots[cell]);
            const double share =
                (at - grown.knots[cell]) / (grown.knots[cell + 1] - grown.knots[cell]);
            return low + share * (curves[axis].at(grown.knots[cell + 1]) - low);
        };
        double largest = 0.0;
        for (int i = 0; i <= 1000; ++i)
            for (int k = 0; k <= 140; ++k)
                largest = std::max(largest,
                    std::abs(lines(0, i * 0.01) + lines(1, k * 0.1) - curves[0].at(i * 0.01)
                        - curves[1].at(k * 0.1)));
        QVERIFY2(largest <= within, qPrintable(QString::number(largest)));
        for (std::size_t i = 0; i < made->table.pointCount(); ++i) {
            const Values place = test::positionOf(made->table, i);
            QVERIFY(isNear(made->table.columns[0].values[i],
                curves[0].at(place[0]) + curves[1].at(place[1]), 1e-12));
        }
        // each axis has what the curve along it takes, and no more
        QVERIFY(grid->points[0] > grid->points[1]);
        QVERIFY(grid->points[0] < 80);
    }

    void smoothingComesCloserToTheTruthThanTheNoisyPoints()
    {
        std::mt19937 random(7);
        std::normal_distribution noise(0.0, 0.0005);
        const auto truth = [](double x) { return 0.01 * std::sin(x / 40.0); };
        auto table = tableOver(
            {evenAxis("X", "mm", 0, 5, 101)}, "X", [&](const Values& p) { return truth(p[0]); });
        for (double& value : table.columns.front().values)
            value += noise(random);
        const auto rmsOf = [&](const NeutralTable& one) {
            double sum = 0.0;
            for (std::size_t i = 0; i < one.pointCount(); ++i)
                sum += std::pow(one.columns[0].values[i] - truth(one.axes[0].knots[i]), 2);
            return std::sqrt(sum / static_cast<double>(one.pointCount()));
        };
        // the same positions are smoothed, too
        for (const std::size_t points : {101U, 401U}) {
            const auto made = onto(table, {points}, smooth);
            VERIFY_RESULT(made);
            QVERIFY(rmsOf(made->table) < 0.5 * rmsOf(table));
            QCOMPARE(made->report.columns[0].density.size(), std::size_t{1});
        }
    }

    void aTurnStaysClosed()
    {
        const auto table = tableOver({test::turningAxis(13)}, "C",
            [](const Values& p) { return std::cos(p[0] * std::numbers::pi / 180.0); });
        for (const auto method : {spline, smooth}) {
            const auto made = onto(table, {361}, method);
            VERIFY_RESULT(made);
            const Values& values = made->table.columns.front().values;
            QCOMPARE(values.front(), values.back());
            QVERIFY(isNear(values[45], std::numbers::sqrt2 / 2.0, 2e-3));
            QVERIFY(isNear(values[1] - values[0], values[359] - values[360], 1e-12));
        }
    }

    void tooFewPointsAreNotSmoothed()
    {
        const auto table = tableOver(
            {evenAxis("X", "mm", 0, 1, 7)}, "X", [](const Values& p) { return p[0] * p[0]; });
        const auto made = onto(table, {21}, smooth);
        VERIFY_ERROR(made, ErrorCode::ResamplingImpossible);
        QCOMPARE(QByteArray::fromStdString(sentence(made.error())),
            "the table cannot be resampled: smoothing needs at least 8 positions along X, which "
            "has 7; take the method spline or "
            "cubic");
        VERIFY_ERROR(coarsestGrid(table, 0.1, smooth), ErrorCode::ResamplingImpossible);
        VERIFY_RESULT(onto(table, {21}, spline));
    }

    void moreThanAllowedIsRefusedWithWhatItTakes()
    {
        const auto table = tableOver({evenAxis("X", "mm", 0, 1, 11), evenAxis("Y", "mm", 0, 2, 8)},
            "X", [](const Values& p) { return std::sin(p[0] / 2.0) + std::cos(p[1] / 3.0); });
        VERIFY_ERROR(coarsestGrid(table, 1e-3, spline, {.mostPoints = 100}),
            ErrorCode::ResamplingImpossible);
    }
};

AXISCOMP_TEST(TestDenserTables)

} // namespace tst_densertables

#include "tst_densertables.moc"
