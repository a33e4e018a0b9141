// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curve/curve_grid.h"
#include "core/curve/fitted_curve.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <random>

namespace tst_cubiccurve {

using namespace axiscomp;

namespace {

CubicCurve waves(std::optional<double> wrap)
{
    return {{0.0, 0.5, 2.0, 2.25, 4.0, 7.0, 8.0}, {0.0, 1.0, -1.0, 3.0, 2.0, -2.0, 0.0},
        {1.0, 0.0, -1.0, 2.0, 0.5, 0.0, 1.0}, wrap};
}

} // namespace

class TestCubicCurve : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void whereThePositionBeforeWasChangesNoBit_data()
    {
        QTest::addColumn<bool>("isWrapped");
        QTest::newRow("linear axis") << false;
        QTest::newRow("modulo axis") << true;
    }
    void whereThePositionBeforeWasChangesNoBit()
    {
        QFETCH(const bool, isWrapped);
        const CubicCurve curve = waves(isWrapped ? std::optional(8.0) : std::nullopt);
        std::mt19937 random(1); // NOLINT
        std::uniform_real_distribution<double> anywhere(-10.0, 20.0);
        std::vector<double> positions = curve.knots;
        for (int i = 0; i < 1000; ++i)
            positions.push_back(anywhere(random));
        for (double position = -1.0; position < 9.0; position += 0.03125)
            positions.push_back(position);
        std::size_t piece = 0;
        for (const double position : positions) {
            QVERIFY(curve.at(position, piece) == curve.at(position));
            for (std::size_t last = 0; last < curve.knots.size(); ++last) {
                std::size_t remembered = last;
                QVERIFY(curve.at(position, remembered) == curve.at(position));
            }
        }
    }

    /// The chord of a sine over a cell is furthest from it where its slope is that of the chord.
    void aGridIsAsFarFromItsCurveAsTheWorstChord()
    {
        constexpr double pi = std::numbers::pi;
        FittedCurve curve{{{0.0, 2.0 * pi}, {0.0, 0.0}, {}, {}}};
        PeriodicTerm sine;
        sine.period = 2.0 * pi;
        sine.sine = 1.0;
        curve.terms = {sine};
        const CurveGrid grid = curveGrid(curve, 0.0, 2.0 * pi, 9);
        const double slope = (1.0 - std::sqrt(0.5)) / (pi / 4.0); // from a quarter pi to a half
        const double place = std::acos(slope);
        const double chord = std::sqrt(0.5) + slope * (place - pi / 4.0);
        QVERIFY(std::abs(grid.largestDistance - (std::sin(place) - chord)) < 1e-12);
    }

    void aGridSeesAPeakOfItsCurveBetweenItsPoints()
    {
        // without their knots only the wide, lower one is seen, and the search stays there
        const CubicCurve peaks{
            {0.0, 1.0, 1.01, 1.02, 4.0, 6.0, 8.0}, {0.0, 0.0, 1.0, 0.0, 0.0, 0.5, 0.0}, {}, {}};
        const CubicCurve flat{{0.0, 8.0}, {0.0, 0.0}, {}, {}};
        for (const FittedCurve& curve :
            {FittedCurve{peaks}, FittedCurve{.base = flat, .onto = peaks}}) {
            const CurveGrid grid = curveGrid(curve, 0.0, 8.0, 3);
            QVERIFY(std::abs(grid.largestDistance - 1.0) < 1e-6);
            QVERIFY(std::abs(grid.distanceAt - 1.01) < 1e-6);
        }
    }
};

AXISCOMP_TEST(TestCubicCurve)

} // namespace tst_cubiccurve

#include "tst_cubiccurve.moc"
