// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fit/lookup_frame.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace tst_lookupframe {

using namespace axiscomp;

namespace {

constexpr double pi = std::numbers::pi;

/// The error of a machine: reference - raw position.
double errorAt(double u)
{
    return 0.5 * std::sin(2.0 * pi * u / 100.0) + 2e-4 * u;
}

CompensationTable lineOf(
    double from, double distance, std::uint32_t size, const std::function<double(double)>& value)
{
    CompensationTable table;
    table.grid.axes = {{"X", "mm", from, distance, size}};
    for (std::size_t i = 0; i < size; ++i)
        table.values.push_back(static_cast<float>(value(table.grid.axes[0].position(i))));
    return table;
}

CompensationTable planeOf(const std::function<double(double, double)>& value)
{
    CompensationTable table;
    table.grid.axes = {{"X", "mm", -20.0, 10.0, 16}, {"Y", "mm", -20.0, 5.0, 31}};
    for (std::size_t j = 0; j < 31; ++j)
        for (std::size_t i = 0; i < 16; ++i)
            table.values.push_back(static_cast<float>(
                value(table.grid.axes[0].position(i), table.grid.axes[1].position(j))));
    return table;
}

/// The deviation that a measurement finds at a target: the axis stands where its encoder and what
/// the drive adds are the target.
double measured(LookupAt lookupAt, const CompensationTable& active, double target)
{
    const Lookup lookup(active);
    if (lookupAt == LookupAt::Set) {
        const double raw = target - lookup.at(target);
        return raw + errorAt(raw) - target;
    }
    double low = target - 10.0;
    double high = target + 10.0;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (middle + lookup.at(middle) < target ? low : high) = middle;
    }
    return low + errorAt(low) - target;
}

} // namespace

class TestLookupFrame : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    /// The whole error at the merged knots; values added at the targets would be off by 4.65 um and
    /// 1.19 um, as computed for the specification.
    void mergedKnotsHaveTheWholeError_data()
    {
        QTest::addColumn<int>("lookupAt");
        QTest::addColumn<double>("offAtTheTargets");
        QTest::addRow("encoder") << static_cast<int>(LookupAt::Encoder) << 0.00465;
        QTest::addRow("set") << static_cast<int>(LookupAt::Set) << 0.00119;
    }
    void mergedKnotsHaveTheWholeError()
    {
        QFETCH(int, lookupAt);
        QFETCH(double, offAtTheTargets);
        const auto at = static_cast<LookupAt>(lookupAt);
        const CompensationTable old =
            lineOf(0.0, 10.0, 51, [](double u) { return 0.9 * errorAt(u); });
        const auto frame = LookupFrame::make(at, {{&old}}, {&old});
        VERIFY_RESULT(frame);
        double off = 0.0;
        for (int i = 0; i <= 50; ++i) {
            const double target = 10.0 * i;
            const double deviation = measured(at, old, target);
            const auto point = frame->atTarget(target, deviation);
            VERIFY_RESULT(point);
            // a table after the compensation is looked up at the reference position u + e(u)
            double raw = point->knot[0];
            if (at == LookupAt::Set)
                raw -= point->value;
            QVERIFY2(std::abs(point->value - errorAt(raw)) < 1e-12,
                qPrintable(QString::number(point->value - errorAt(raw))));
            QVERIFY(std::abs(frame->rawPosition({&target, 1})->at(0) - raw) < 1e-12);

            double ideal = errorAt(target); // of the table at the target itself
            if (at == LookupAt::Set) {
                double u = target;
                for (int k = 0; k < 100; ++k)
                    u = target - errorAt(u);
                ideal = errorAt(u);
            }
            off = std::max(off, std::abs(Lookup(old).at(target) + deviation - ideal));
        }
        QVERIFY2(std::abs(off - offAtTheTargets) < 5e-6, qPrintable(QString::number(off, 'g', 9)));
    }

    void withoutAnActiveTableTheKnotsAreTheTargetsOrTheReferences()
    {
        const auto encoder = LookupFrame::make(LookupAt::Encoder, {{}}, {});
        const auto set = LookupFrame::make(LookupAt::Set, {{}}, {});
        VERIFY_RESULT(encoder);
        VERIFY_RESULT(set);
        QCOMPARE(encoder->atTarget(40.0, 0.25)->knot[0], 40.0);
        QCOMPARE(encoder->atTarget(40.0, 0.25)->value, 0.25);
        QCOMPARE(set->atTarget(40.0, 0.25)->knot[0], 40.25);
        QCOMPARE(set->atTarget(40.0, 0.25)->value, 0.25);
    }

    void aRawReadingNeedsNoActiveTable()
    {
        const double reading = 39.5;
        const double reference = 40.25;
        const auto encoder =
            pointOfReading(LookupAt::Encoder, {&reading, 1}, {&reference, 1}, 0.75);
        const auto set = pointOfReading(LookupAt::Set, {&reading, 1}, {&reference, 1}, 0.75);
        QCOMPARE(encoder.knot[0], 39.5);
        QCOMPARE(set.knot[0], 40.25);
        QCOMPARE(encoder.value, 0.75);
        QCOMPARE(set.value, 0.75);
    }

    /// Two axes, both with active tables over X and Y: the raw position satisfies both equations.
    void aCrossTableMovesWithEveryAxisWhoseTableWasActive()
    {
        const CompensationTable x =
            planeOf([](double u, double v) { return 0.3 * std::sin(u / 20.0) + 0.01 * v; });
        const CompensationTable y =
            planeOf([](double u, double v) { return 0.2 * std::cos(v / 15.0) - 0.02 * u; });
        const CompensationTable z = planeOf([](double u, double v) { return 0.001 * u * v; });
        const auto frame = LookupFrame::make(LookupAt::Encoder, {{&x}, {&y}}, {&z});
        const auto set = LookupFrame::make(LookupAt::Set, {{&x}, {&y}}, {&z});
        VERIFY_RESULT(frame);
        VERIFY_RESULT(set);
        for (const double p : {-15.0, 3.0, 77.7, 140.0}) { // the last is beyond the table
            for (const double q : {-20.0, 0.1, 50.0, 129.0}) {
                const std::array target{p, q};
                const auto point = frame->atTarget(target, 0.125, {});
                VERIFY_RESULT(point);
                const double u = point->knot[0];
                const double v = point->knot[1];
                QVERIFY(std::abs(u + Lookup(x).at(u, v) - p) < 1e-12);
                QVERIFY(std::abs(v + Lookup(y).at(u, v) - q) < 1e-12);
                QVERIFY(std::abs(point->value - 0.125 - Lookup(z).at(u, v)) < 1e-15);
                const std::array moved{0.5, -0.25};
                const auto other = set->atTarget(target, 0.125, moved);
                QCOMPARE(other->knot[0], p + 0.5);
                QCOMPARE(other->knot[1], q - 0.25);
                QCOMPARE(other->value, 0.125 + Lookup(z).at(p, q));
            }
        }
    }

    /// Measure, merge, measure again: after two passes the knots have the whole error, from no
    /// table and from a wrong one.
    void twoPassesFindTheErrorFromAnyTable_data()
    {
        QTest::addColumn<int>("lookupAt");
        QTest::addColumn<double>("first");
        for (const LookupAt at : {LookupAt::Encoder, LookupAt::Set}) {
            const char* name = at == LookupAt::Set ? "set" : "encoder";
            QTest::addRow("%s, off", name) << static_cast<int>(at) << 0.0;
            QTest::addRow("%s, wrong sign", name) << static_cast<int>(at) << -1.0;
        }
    }
    void twoPassesFindTheErrorFromAnyTable()
    {
        QFETCH(int, lookupAt);
        QFETCH(double, first);
        const auto at = static_cast<LookupAt>(lookupAt);
        CompensationTable active =
            lineOf(0.0, 5.0, 101, [first](double u) { return first * errorAt(u); });
        for (int pass = 0; pass < 2; ++pass) {
            const auto frame = LookupFrame::make(at, {{&active}}, {&active});
            VERIFY_RESULT(frame);
            std::vector<LookupFrame::Point> points;
            for (int i = 0; i <= 100; ++i) {
                const auto point = frame->atTarget(5.0 * i, measured(at, active, 5.0 * i));
                VERIFY_RESULT(point);
                points.push_back(*point);
            }
            active = lineOf(0.0, 5.0, 101, [&points](double u) {
                std::size_t i = 1;
                while (i + 1 < points.size() && points[i].knot[0] < u)
                    ++i;
                const auto& [a, b] = std::tie(points[i - 1], points[i]);
                const double t = std::clamp((u - a.knot[0]) / (b.knot[0] - a.knot[0]), 0.0, 1.0);
                return a.value + t * (b.value - a.value);
            });
        }
        // a chord of 5 mm is off by 0.5 (2 pi / 100)^2 5^2 / 8 at most; twice, as knots and grid
        // are two interpolations
        const double chord = 0.5 * std::pow(2.0 * pi / 100.0, 2) * 25.0 / 8.0;
        for (int i = 1; i < 100; ++i)
            QVERIFY(std::abs(measured(at, active, 5.0 * i)) < 2.0 * chord);
    }

    void aTableThatChangesTheOrderOfPositionsIsRefused()
    {
        const CompensationTable steep =
            lineOf(0.0, 10.0, 4, [](double u) { return u > 15.0 ? -10.5 : 0.0; });
        const auto frame = LookupFrame::make(LookupAt::Encoder, {{&steep}}, {&steep});
        VERIFY_ERROR(frame, ErrorCode::SignNotConvertible);
        QVERIFY(sentence(frame.error()).find("at 10 mm") != std::string::npos);
        VERIFY_RESULT(LookupFrame::make(LookupAt::Encoder, {{&steep, 0.9}}, {&steep, 0.9}));
        VERIFY_ERROR(LookupFrame::make(LookupAt::Encoder, {{&steep}, {}}, {}),
            ErrorCode::InvalidArgument); // one source instead of two
        VERIFY_ERROR(LookupFrame::make(LookupAt::Encoder, {}, {}), ErrorCode::InvalidArgument);
    }
};

AXISCOMP_TEST(TestLookupFrame)

} // namespace tst_lookupframe

#include "tst_lookupframe.moc"
