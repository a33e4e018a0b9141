// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive/travel_coverage.h"

#include "drivecomm/profile/profile_loader.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <limits>
#include <map>

namespace tst_travelcoverage {

using namespace axiscomp;

namespace {

const std::string masterX = "Axes[0]/Signals/PositionController/MasterPosition";
const std::string masterY = "Axes[1]/Signals/PositionController/MasterPosition";
const std::string temperature = "Axes[0]/Signals/General/MotorTemperature";

/// From `first` to `last` in ten steps.
GridAxis axisFrom(double first, double last)
{
    return {.name = {}, .unit = {}, .start = first, .distance = (last - first) / 10.0, .size = 11};
}

Result<std::vector<DimensionCoverage>> coverageOf(
    const std::vector<std::string>& paths, const Grid& grid, const std::map<int, Travel>& travels)
{
    std::vector<DimSource> sources;
    for (const std::string& path : paths)
        sources.push_back({1, path});
    return travelCoverage(
        drivecomm::genericProfile(), sources, grid, [&](int axis) -> Result<std::optional<Travel>> {
            const auto found = travels.find(axis);
            return found == travels.end() ? std::nullopt : std::optional(found->second);
        });
}

} // namespace

class TestTravelCoverage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theShareOfTheTravelIsCovered_data()
    {
        QTest::addColumn<double>("first");
        QTest::addColumn<double>("last");
        QTest::addColumn<double>("share");
        QTest::newRow("exactly") << -10.0 << 90.0 << 1.0;
        QTest::newRow("more") << -20.0 << 100.0 << 1.0;
        QTest::newRow("a rounding less") << -10.0 + 1e-5 << 90.0 << 1.0;
        QTest::newRow("a thousandth less") << -9.9 << 90.0 << 0.999;
        QTest::newRow("the lower half") << -10.0 << 40.0 << 0.5;
        QTest::newRow("the upper quarter and beyond") << 65.0 << 500.0 << 0.25;
        QTest::newRow("below") << -200.0 << -20.0 << 0.0;
        QTest::newRow("above") << 91.0 << 100.0 << 0.0;
        QTest::newRow("touching") << 90.0 << 100.0 << 0.0;
    }
    void theShareOfTheTravelIsCovered()
    {
        QFETCH(double, first);
        QFETCH(double, last);
        QFETCH(double, share);
        const auto coverage =
            coverageOf({masterX}, Grid{{axisFrom(first, last)}}, {{0, Travel{-10.0, 90.0}}});
        VERIFY_RESULT(coverage);
        QCOMPARE(coverage->size(), std::size_t{1});
        QVERIFY2(std::abs(coverage->front().share - share) < 1e-12,
            qPrintable(QString::number(coverage->front().share, 'g', 17)));
        QVERIFY((coverage->front().travel == Travel{-10.0, 90.0}));
        QVERIFY(std::abs(coverage->front().table.high - last) < 1e-9);
    }

    void eachDimensionHasTheTravelOfItsOwnAxis()
    {
        const Grid grid{{axisFrom(0.0, 20.0), axisFrom(0.0, 20.0)}};
        const auto coverage =
            coverageOf({masterY, masterX}, grid, {{0, Travel{0.0, 40.0}}, {1, Travel{0.0, 20.0}}});
        VERIFY_RESULT(coverage);
        QCOMPARE(coverage->size(), std::size_t{2});
        QCOMPARE(coverage->at(0).axis, 1);
        QCOMPARE(coverage->at(0).share, 1.0);
        QCOMPARE(coverage->at(1).axis, 0);
        QCOMPARE(coverage->at(1).dimension, std::size_t{1});
        QCOMPARE(coverage->at(1).share, 0.5);
    }

    void nothingIsSaidOfWhatIsNotKnown()
    {
        const Grid grid{{axisFrom(0.0, 20.0)}};
        const auto temperatureCoverage = coverageOf({temperature}, grid, {{0, Travel{0.0, 100.0}}});
        VERIFY_RESULT(temperatureCoverage);
        QVERIFY(temperatureCoverage->empty());
        const auto silent = coverageOf({masterX}, grid, {});
        VERIFY_RESULT(silent);
        QVERIFY(silent->empty());
    }

    void limitsThatAreNoRangeAreNone()
    {
        constexpr double huge = std::numeric_limits<float>::max();
        QVERIFY(!travelBetween(0.0, 0.0));
        QVERIFY(!travelBetween(10.0, -10.0));
        QVERIFY(!travelBetween(-huge, huge));
        QVERIFY(!travelBetween(std::numeric_limits<double>::quiet_NaN(), 1.0));
        QVERIFY(!travelBetween(0.0, std::numeric_limits<double>::infinity()));
        QVERIFY((travelBetween(-1.0, 1e6) == Travel{-1.0, 1e6}));
    }
};

AXISCOMP_TEST(TestTravelCoverage)

} // namespace tst_travelcoverage

#include "tst_travelcoverage.moc"
