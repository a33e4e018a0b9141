// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/axis_plan.h"
#include "core/capture/capture_request.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

namespace tst_axisplan {

using namespace axiscomp;
using namespace std::chrono_literals;

namespace {

AxisInfo axisOf(const std::string& unit, const std::optional<Travel>& travel)
{
    AxisInfo axis;
    axis.name = "X";
    axis.unit = unit;
    axis.travel = travel;
    return axis;
}

MeasuringPlan planOver(double from, double to)
{
    MeasuringPlanRequest request;
    request.from = from;
    request.to = to;
    request.count = 21;
    return makeMeasuringPlan(request).value();
}

} // namespace

class tst_AxisPlan : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theTravelIsInTheUnitOfThePlan()
    {
        const MeasuredAxis metres = measuredAxis(axisOf("Meter", Travel{-0.1, 0.4}));
        QVERIFY(!metres.isAngular);
        QCOMPARE(metres.travel.value(), (Travel{-100.0, 400.0}));
        const MeasuredAxis degrees = measuredAxis(axisOf("Degree", Travel{0.0, 360.0}));
        QVERIFY(degrees.isAngular);
        QCOMPARE(degrees.travel.value(), (Travel{0.0, 360.0}));
        QVERIFY(!measuredAxis(axisOf("None", Travel{0.0, 360.0})).travel);
        QVERIFY(!measuredAxis(axisOf("Millimeter", std::nullopt)).travel);
    }

    void proposedEndsLeaveRoomForTheOverrun_data()
    {
        QTest::addColumn<double>("low");
        QTest::addColumn<double>("high");
        QTest::newRow("40 mm") << 0.0 << 40.0;
        QTest::newRow("around zero") << -250.0 << 250.0;
        QTest::newRow("odd") << -17.3333 << 81.7777;
        QTest::newRow("short") << 0.0 << 1.0;
    }
    void proposedEndsLeaveRoomForTheOverrun()
    {
        QFETCH(const double, low);
        QFETCH(const double, high);
        const Travel travel{low, high};
        const auto ends = proposedEnds(travel);
        QVERIFY(ends.has_value());
        const Text problem = travelProblem(planOver(ends->from, ends->to), travel);
        QVERIFY2(problem.isEmpty(), problem.english().c_str());
    }

    void aTravelOfNothingProposesNothing()
    {
        QVERIFY(!proposedEnds({0.0, 0.001}));
        QVERIFY(!proposedEnds({0.0, 1e9}));
    }

    void aWayBeyondTheTravelIsSaidWithBoth()
    {
        const std::string said = travelProblem(planOver(0.0, 40.0), Travel{0.0, 40.0}).english();
        QVERIFY2(said.starts_with("the axis would move from -0.400 mm to 40.400 mm, and its travel "
                                  "is 0.000 mm to 40.000 mm"),
            said.c_str());
        QVERIFY(travelProblem(planOver(0.0, 40.0), std::nullopt).isEmpty());
    }

    void timesGoOnFromTheLastValue()
    {
        std::chrono::nanoseconds steady = 100s;
        const auto now = [&steady] { return steady; };
        const CaptureClock fresh({}, 5000s, now);
        QVERIFY(!fresh.isBehind());
        QCOMPARE(fresh.now(), std::chrono::nanoseconds(5000s));
        steady += 3s;
        QCOMPARE(fresh.now(), std::chrono::nanoseconds(5003s));
        CapturedValue last;
        last.time = 9000s;
        const CaptureClock behind(std::span(&last, 1), 5000s, now);
        QVERIFY(behind.isBehind());
        QCOMPARE(behind.now(), std::chrono::nanoseconds(9000s));
    }

    void aFirstValueThatIsFarOffNamesTheZero()
    {
        const MeasuringPlan plan = planOver(0.0, 500.0);
        CapturedValue first;
        first.deviation = -100.0; // it says 0 where the axis is at 100
        QCOMPARE(proposedZero(first, plan, {}).value(), 100.0);
        ReferenceScale scale;
        scale.zeroAt = 12.0;
        QCOMPARE(proposedZero(first, plan, scale).value(), 112.0);
        first.deviation = 0.02;
        QVERIFY(!proposedZero(first, plan, {}));
    }
};

AXISCOMP_TEST(tst_AxisPlan)

} // namespace tst_axisplan

#include "tst_axisplan.moc"
