// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/sign_conversion.h"

#include "tests/core/conversion/numeric_tables.h"
#include "tests/support/test_registry.h"

#include <numbers>

namespace tst_signconversion {

using namespace axiscomp;
using test::addColumn;
using test::axisX;
using test::evenAxis;
using test::held;
using test::tableOver;
using Values = std::vector<double>;

namespace {

constexpr double pi = std::numbers::pi;

SignConvention other(SignConvention sign)
{
    return sign == SignConvention::Feedback ? SignConvention::Command : SignConvention::Feedback;
}

/// One, two or three axes; each of them corrected by a column of its own.
NeutralTable wavyTable(int dimensions, double height, SignConvention sign)
{
    NeutralTable table;
    table.sign = sign;
    const std::vector<std::string> names{"X", "Y", "Z"};
    for (int n = 0; n < dimensions; ++n)
        table.axes.push_back(evenAxis(names[static_cast<std::size_t>(n)], "mm", -10 * n, 7, 9));
    for (int n = 0; n < dimensions; ++n)
        addColumn(table, names[static_cast<std::size_t>(n)], [=](const Values& p) {
            double phase = n;
            for (const double x : p)
                phase += x / 9.0;
            return height * std::sin(phase);
        });
    return table;
}

std::string reasonOf(const Result<SignConversion>& result)
{
    return result ? "converted" : sentence(result.error());
}

} // namespace

class TestSignConversion : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aLinearCorrectionHasTheClosedForm_data()
    {
        QTest::addColumn<double>("slope");
        for (const double slope : {1e-6, -1e-3, 0.2, 3.0, -0.9})
            QTest::addRow("%g", slope) << slope;
    }
    /// c = -(a + b x) / (1 + b), also where b is so large that no iteration would converge
    void aLinearCorrectionHasTheClosedForm()
    {
        QFETCH(double, slope);
        for (const SignConvention sign : {SignConvention::Feedback, SignConvention::Command}) {
            const auto table = tableOver(
                {axisX({-100, -40, 0, 10, 25, 100})}, "X",
                [=](const Values& p) { return 0.002 + slope * p[0]; }, sign);
            const auto converted = convertSign(table, other(sign), held);
            VERIFY_RESULT(converted);
            QCOMPARE(converted->table.sign, other(sign));
            int compared = 0;
            for (std::size_t i = 0; i < 6; ++i) {
                const double knot = table.axes[0].knots[i];
                const double expected = -(0.002 + slope * knot) / (1.0 + slope);
                if (knot + expected < -100 || knot + expected > 100)
                    continue; // there the end is held
                ++compared;
                const double found = converted->table.columns[0].values[i];
                QVERIFY2(std::abs(found - expected) <= 1e-12 * (1.0 + std::abs(expected)),
                    (std::to_string(found) + " is not " + std::to_string(expected)).c_str());
            }
            QVERIFY(compared >= 2);
            QCOMPARE(converted->iterations, 0);
            QVERIFY(converted->residual <= 1e-11);
        }
    }

    /// c(u + e(u)) = -e(u), and c is linear between: no difference anywhere, both ways.
    void exactKnotsLoseNothing()
    {
        const auto e = tableOver({axisX({0, 10, 25, 30, 50})}, "X",
            [](const Values& p) { return 0.3 * std::sin(p[0] / 4.0) - 0.01; });
        const auto c = convertSign(e, SignConvention::Command, held, ConvertedKnots::Exact);
        VERIFY_RESULT(c);
        for (std::size_t i = 0; i < 5; ++i) {
            const double u = e.axes[0].knots[i];
            const double value = e.columns[0].values[i];
            QCOMPARE(c->table.axes[0].knots[i], u + value);
            QCOMPARE(c->table.columns[0].values[i], -value);
        }
        const auto difference = conversionDifference(e, held, c->table, held);
        VERIFY_RESULT(difference);
        QVERIFY2(difference->columns[0].largest < 1e-14,
            std::to_string(difference->columns[0].largest).c_str());
        const auto back =
            convertSign(c->table, SignConvention::Feedback, held, ConvertedKnots::Exact);
        VERIFY_RESULT(back);
        for (std::size_t i = 0; i < 5; ++i)
            QVERIFY(std::abs(back->table.axes[0].knots[i] - e.axes[0].knots[i]) < 1e-14);
        QCOMPARE(back->table.columns[0].values, e.columns[0].values);
    }

    void exactKnotsAreTakenOnlyWhereTheyServe()
    {
        const auto shifted =
            tableOver({axisX({0, 10, 20})}, "X", [](const Values&) { return 0.5; });
        const auto even =
            convertSign(shifted, SignConvention::Command, held, ConvertedKnots::ExactIfEven);
        VERIFY_RESULT(even);
        QCOMPARE(even->table.axes[0].knots, (Values{0.5, 10.5, 20.5}));
        const auto bent = tableOver(
            {axisX({0, 10, 20})}, "X", [](const Values& p) { return 0.001 * p[0] * p[0]; });
        const auto same =
            convertSign(bent, SignConvention::Command, held, ConvertedKnots::ExactIfEven);
        VERIFY_RESULT(same);
        QCOMPARE(same->table.axes[0].knots, (Values{0, 10, 20}));
        auto straightness = bent;
        straightness.columns[0].target = "Y";
        const auto unmoved =
            convertSign(straightness, SignConvention::Command, held, ConvertedKnots::Exact);
        VERIFY_RESULT(unmoved);
        QCOMPARE(unmoved->table.axes[0].knots, (Values{0, 10, 20}));
    }

    void beyondTheKnotsTheEndIsHeld()
    {
        const auto table = tableOver({axisX({0, 10})}, "X", [](const Values&) { return 0.5; });
        const auto converted = convertSign(table, SignConvention::Command, held);
        VERIFY_RESULT(converted);
        QCOMPARE(converted->table.columns[0].values, (Values{-0.5, -0.5}));
        QVERIFY(!converted->usesHeldEnds); // the controller does the same
        const auto zero = convertSign(table, SignConvention::Command, test::zeroOutside);
        VERIFY_RESULT(zero);
        QCOMPARE(zero->table.columns[0].values, (Values{-0.5, -0.5}));
        QVERIFY(zero->usesHeldEnds);
        const auto inside = tableOver(
            {axisX({0, 10})}, "X", [](const Values& p) { return 0.01 * p[0] * (p[0] - 10); });
        const auto kept = convertSign(inside, SignConvention::Command, test::zeroOutside);
        VERIFY_RESULT(kept);
        QVERIFY(!kept->usesHeldEnds);
    }

    void theEquationHoldsAtEveryKnot_data()
    {
        QTest::addColumn<int>("dimensions");
        QTest::addColumn<bool>("toCommand");
        for (int dimensions = 1; dimensions <= 3; ++dimensions) {
            QTest::addRow("%dD, to command", dimensions) << dimensions << true;
            QTest::addRow("%dD, to feedback", dimensions) << dimensions << false;
        }
    }
    /// r = -f(knot + r), with the shifts of all axes together
    void theEquationHoldsAtEveryKnot()
    {
        QFETCH(int, dimensions);
        QFETCH(bool, toCommand);
        const auto sign = toCommand ? SignConvention::Feedback : SignConvention::Command;
        const NeutralTable table = wavyTable(dimensions, 0.9, sign);
        const auto converted = convertSign(table, other(sign), held);
        VERIFY_RESULT(converted);
        const auto& columns = converted->table.columns;
        for (std::size_t i = 0; i < table.pointCount(); ++i) {
            Values place = test::positionOf(table, i);
            for (std::size_t n = 0; n < place.size(); ++n)
                place[n] += columns[n].values[i];
            for (std::size_t n = 0; n < columns.size(); ++n) {
                const double rest =
                    columns[n].values[i] + ControllerLookup(table, n, held).at(place);
                QVERIFY2(std::abs(rest) < 2e-14, std::to_string(rest).c_str());
            }
        }
        QVERIFY(converted->residual < 2e-14);
        QCOMPARE(converted->iterations > 0, dimensions > 1);
        // the plain change of sign would not do
        QVERIFY(test::largestDifference(columns[0].values, table.columns[0].values) > 0.05);
        Values negated = table.columns[0].values;
        for (double& value : negated)
            value = -value;
        QVERIFY(test::largestDifference(columns[0].values, negated) > 1e-3);
    }

    void aRoundTripLosesSecondOrderTermsOnly_data() { theEquationHoldsAtEveryKnot_data(); }
    /// Between knots the converted table is linear, but the true function has its kinks moved from
    /// the knots by at most the largest value. A kink that is moved by s in a cell changes the
    /// value by at most s times the change of slope; each axis adds its own, and the slopes of the
    /// way back at most double it here.
    void aRoundTripLosesSecondOrderTermsOnly()
    {
        QFETCH(int, dimensions);
        QFETCH(bool, toCommand);
        const auto sign = toCommand ? SignConvention::Feedback : SignConvention::Command;
        for (const double height : {1e-5, 1e-3, 0.05}) {
            const NeutralTable table = wavyTable(dimensions, height, sign);
            const auto there = convertSign(table, other(sign), held);
            VERIFY_RESULT(there);
            const auto back = convertSign(there->table, sign, held);
            VERIFY_RESULT(back);
            QCOMPARE(back->table.sign, sign);
            for (std::size_t n = 0; n < table.columns.size(); ++n) {
                const double bound = 2.0 * dimensions * test::largestKink(table, n)
                    * test::largestSize(table.columns[n].values);
                const double lost =
                    test::largestDifference(back->table.columns[n].values, table.columns[n].values);
                QVERIFY2(lost <= bound + 1e-15,
                    (std::to_string(lost) + " > " + std::to_string(bound)).c_str());
                QVERIFY(bound < 0.5 * height); // or the bound would say nothing
            }
        }
    }

    void whatCannotBeInvertedIsRefused_data()
    {
        QTest::addColumn<QByteArray>("kind");
        QTest::addColumn<QByteArray>("sentence");
        QTest::addRow("steep") << QByteArray("steep")
                               << QByteArray("the sign cannot be converted at 10 mm: from there to "
                                             "20 mm the correction changes by -10 mm, so that "
                                             "positions would change their order; check the unit");
        QTest::addRow("steep in 2D")
            << QByteArray("plane")
            << QByteArray("at X = 10 mm, Y = 5 mm: from there to 20 mm the correction changes by "
                          "-11 mm");
        QTest::addRow("steep between two turns")
            << QByteArray("gap")
            << QByteArray("at 0 deg: a full turn of C begins with the "
                          "correction 1 deg and ends with 2 deg");
        QTest::addRow("ends of a turn")
            << QByteArray("turn")
            << QByteArray("at 0 deg: a full turn of C begins with the correction 0 deg and ends "
                          "with 0.5 deg; make both the same");
        QTest::addRow("joint") << QByteArray("joint")
                               << QByteArray("the correction of X changes by 2 for each unit of "
                                             "the way, too much for several axes");
        QTest::addRow("too large")
            << QByteArray("huge")
            << QByteArray("at 1e+308 mm: the numbers are too large to be added to each other");
    }
    void whatCannotBeInvertedIsRefused()
    {
        QFETCH(QByteArray, kind);
        QFETCH(QByteArray, sentence);
        NeutralTable table = tableOver(
            {axisX({0, 10, 20})}, "X", [](const Values& p) { return p[0] > 10 ? -10.0 : 0.0; });
        if (kind == "plane")
            table = tableOver({axisX({0, 10, 20}), evenAxis("Y", "mm", 0, 5, 2)}, "X",
                [](const Values& p) { return p[0] > 10 && p[1] > 0 ? -11.0 : 0.0; });
        if (kind == "turn")
            table = tableOver({test::turningAxis(5)}, "C",
                [](const Values& p) { return p[0] > 300 ? 0.5 : 0.0; });
        if (kind == "gap") {
            table = tableOver({evenAxis("C", "deg", 0, 90, 4)}, "C",
                [](const Values& p) { return 1.0 + p[0] / 270.0; });
            table.axes[0].wrap = 360;
        }
        if (kind == "joint") {
            table = tableOver({axisX({0, 10}), evenAxis("Y", "mm", 0, 10, 2)}, "X",
                [](const Values& p) { return 2.0 * p[1]; });
            addColumn(table, "Y", [](const Values& p) { return p[0]; });
        }
        if (kind == "huge")
            table =
                tableOver({axisX({1e308, 1.5e308})}, "X", [](const Values&) { return 1.7e308; });
        const auto result = convertSign(table, SignConvention::Command, held);
        VERIFY_ERROR(result, ErrorCode::SignNotConvertible);
        QVERIFY2(reasonOf(result).find(sentence.toStdString()) != std::string::npos,
            reasonOf(result).c_str());
    }

    /// Not one far out, to where the table was continued when it was looked at.
    void aTableThatGoesOnIsRefusedAtAKnotOfItsOwn()
    {
        auto table = tableOver({axisX({0, 10}), evenAxis("Y", "mm", 0, 10, 2)}, "X",
            [](const Values& p) { return 2.0 * p[1]; });
        addColumn(table, "Y", [](const Values& p) { return p[0]; });
        const auto result = convertSign(
            table, SignConvention::Command, TableBehaviour{.outside = Outside::Extrapolate});
        VERIFY_ERROR(result, ErrorCode::SignNotConvertible);
        QVERIFY2(reasonOf(result).find("at X = 0 mm, Y = 0 mm: ") != std::string::npos,
            reasonOf(result).c_str());
    }

    void aUnitMistakenIsFoundByItsSlopes()
    {
        auto table =
            tableOver({axisX({0, 1, 2})}, "X", [](const Values& p) { return -p[0] * 1.2; });
        table.columns[0].unit = "um";
        VERIFY_RESULT(convertSign(table, SignConvention::Command, held));
        table.columns[0].unit = "mm";
        VERIFY_ERROR(
            convertSign(table, SignConvention::Command, held), ErrorCode::SignNotConvertible);
    }

    void aCrossCompensationChangesItsSignAtTheSamePlace()
    {
        // steeper than anything that could be inverted
        const auto table =
            tableOver({axisX({0, 1, 2})}, "Y", [](const Values& p) { return 5 - 9 * p[0]; });
        const auto converted = convertSign(table, SignConvention::Command, held);
        VERIFY_RESULT(converted);
        QCOMPARE(converted->table.columns[0].values, (Values{-5, 4, 13}));
        const auto zero = tableOver({axisX({0, 1})}, "Y", [](const Values&) { return 0.0; });
        const auto same = convertSign(zero, SignConvention::Command, held);
        VERIFY_RESULT(same);
        QVERIFY(!std::signbit(same->table.columns[0].values[0])); // no "-0" in files
    }

    void aCrossCompensationMovesWithTheOwnColumnBesideIt()
    {
        auto table =
            tableOver({evenAxis("X", "mm", 0, 10, 11)}, "X", [](const Values&) { return 0.5; });
        addColumn(table, "Y", [](const Values& p) { return 0.01 * p[0]; });
        const auto converted = convertSign(table, SignConvention::Command, held);
        VERIFY_RESULT(converted);
        // commanded to 50, the encoder of X is at 49.5
        QCOMPARE(converted->table.columns[0].values[5], -0.5);
        QVERIFY(std::abs(converted->table.columns[1].values[5] + 0.495) < 1e-15);
    }

    /// e = A p + b: c = -(1 + A)^-1 (A x + b)
    void severalOwnColumnsShiftTogether()
    {
        constexpr double a = 0.1;
        constexpr double b = -0.3;
        constexpr double c = 0.2;
        constexpr double d = -0.05;
        auto table = tableOver({evenAxis("X", "mm", -50, 10, 11), evenAxis("Y", "mm", -50, 25, 5)},
            "X", [=](const Values& p) { return a * p[0] + b * p[1] + 0.3; });
        addColumn(table, "Y", [=](const Values& p) { return c * p[0] + d * p[1] - 0.2; });
        const auto converted = convertSign(table, SignConvention::Command, held);
        VERIFY_RESULT(converted);
        QVERIFY(converted->iterations > 3 && converted->iterations < 60);
        const double determinant = (1 + a) * (1 + d) - b * c;
        const std::size_t index = 6 + 11 * 2; // X = 10, Y = 0
        const double ex = a * 10 + 0.3;
        const double ey = c * 10 - 0.2;
        const double x = -((1 + d) * ex - b * ey) / determinant;
        const double y = -((1 + a) * ey - c * ex) / determinant;
        QVERIFY(std::abs(converted->table.columns[0].values[index] - x) < 1e-13);
        QVERIFY(std::abs(converted->table.columns[1].values[index] - y) < 1e-13);
    }

    void oneOwnColumnInAPlaneMovesAlongItsAxisOnly()
    {
        const auto table = tableOver({axisX({0, 5, 20, 50}), evenAxis("Y", "mm", 0, 10, 3)}, "Y",
            [](const Values& p) { return 0.2 + 0.1 * p[0] - 0.02 * p[1]; });
        const auto converted = convertSign(table, SignConvention::Command, held);
        VERIFY_RESULT(converted);
        QCOMPARE(converted->iterations, 0);
        const double e = 0.2 + 0.1 * 5 - 0.02 * 10; // X = 5, Y = 10
        QVERIFY(std::abs(converted->table.columns[0].values[1 + 4] + e / 0.98) < 1e-15);
    }

    void eachDirectionIsConvertedForItself()
    {
        const auto rising = [](const Values& p) { return 0.1 * p[0] - 1.0; };
        const auto falling = [](const Values& p) { return 0.5 - 0.05 * p[0]; };
        NeutralTable table;
        table.axes = {evenAxis("X", "mm", 0, 5, 5)};
        addColumn(table, "X", rising, Direction::Positive);
        addColumn(table, "X", falling, Direction::Negative);
        const auto both = convertSign(table, SignConvention::Command, held);
        VERIFY_RESULT(both);
        for (std::size_t i = 0; i < 2; ++i) {
            NeutralTable one = table;
            one.columns = {table.columns[i]};
            const auto alone = convertSign(one, SignConvention::Command, held);
            VERIFY_RESULT(alone);
            QCOMPARE(both->table.columns[i], alone->table.columns[0]);
        }
        QVERIFY(std::abs(both->table.columns[0].values[2] - 0.0) < 1e-15);
        QVERIFY(std::abs(both->table.columns[1].values[2] - 0.0) < 1e-15);
        QVERIFY(std::abs(both->table.columns[1].values[1] + 0.25 / 0.95) < 1e-15);
    }

    void valuesAndPositionsMayHaveDifferentUnits()
    {
        auto inMm = tableOver(
            {axisX({0, 3, 10, 20})}, "X", [](const Values& p) { return 0.02 * (p[0] - 7); });
        auto inUm = inMm;
        inUm.columns[0].unit = "um";
        for (double& value : inUm.columns[0].values)
            value *= 1000;
        const auto a = convertSign(inMm, SignConvention::Command, held);
        const auto b = convertSign(inUm, SignConvention::Command, held);
        VERIFY_RESULT(a);
        VERIFY_RESULT(b);
        for (std::size_t i = 0; i < 4; ++i)
            QVERIFY(std::abs(b->table.columns[0].values[i] - 1000 * a->table.columns[0].values[i])
                < 1e-12);
        QCOMPARE(b->table.columns[0].unit, std::string("um"));
    }

    void unknownUnitsAreTakenAsEqual()
    {
        auto table =
            tableOver({axisX({0, 3, 10})}, "X", [](const Values& p) { return 0.02 * p[0]; });
        const auto known = convertSign(table, SignConvention::Command, held);
        table.columns[0].unit = "counts";
        const auto unknown = convertSign(table, SignConvention::Command, held);
        VERIFY_RESULT(known);
        VERIFY_RESULT(unknown);
        QCOMPARE(unknown->table.columns[0].values, known->table.columns[0].values);
    }

    void aModuloAxisIsLookedUpAcrossItsSeam()
    {
        const auto e = [](const Values& p) { return 3.0 * std::cos(p[0] * pi / 180); };
        auto table = tableOver({test::turningAxis(37)}, "C", e);
        table.columns[0].values.back() = table.columns[0].values.front();
        const auto converted = convertSign(table, SignConvention::Command, held);
        VERIFY_RESULT(converted);
        const Values& c = converted->table.columns[0].values;
        QCOMPARE(c.back(), c.front());
        QVERIFY(converted->residual < 1e-12);
        // z = -3 deg or so is 357 deg, in the last cell: 3 - 0.1 * |z| * (1 - cos 10 deg) * 3
        const double slope = 3.0 * (1 - std::cos(10 * pi / 180)) / 10.0;
        QVERIFY(std::abs(c.front() + 3.0 / (1 + slope)) < 1e-12);
    }

    void aModuloAxisWithoutItsLastPointHoldsUpToTheNextTurn()
    {
        auto table = tableOver({evenAxis("C", "deg", 0, 90, 4)}, "C",
            [](const Values& p) { return p[0] == 90 ? 9.0 : 2.0; });
        table.axes[0].wrap = 360;
        const auto converted = convertSign(table, SignConvention::Command, held);
        VERIFY_RESULT(converted);
        QCOMPARE(converted->table.columns[0].values[0], -2.0); // at 358 deg it is 2
    }

    void bothEndsOfAFullTurnStayTheSameExactly()
    {
        for (int start = 0; start < 60; ++start) {
            SourceAxis axis = axisX({});
            axis.wrap = 360;
            for (int i = 0; i <= 7; ++i)
                axis.knots.push_back(0.1 * start + i * (360.0 / 7));
            auto table = tableOver({axis}, "X", [](const Values& p) { return std::sin(p[0]); });
            table.columns[0].values.back() = table.columns[0].values.front();
            const auto converted = convertSign(table, SignConvention::Command, held);
            VERIFY_RESULT(converted);
            const Values& values = converted->table.columns[0].values;
            QVERIFY2(values.back() == values.front(), QByteArray::number(start)); // no tolerance
        }
    }

    void aColumnForBothDirectionsIsMovedByTheirMean()
    {
        NeutralTable table;
        table.axes = {axisX({0, 10, 20})};
        addColumn(
            table, "X", [](const Values&) { return 1.0; }, Direction::Positive);
        addColumn(
            table, "X", [](const Values&) { return 3.0; }, Direction::Negative);
        addColumn(table, "Y", [](const Values& p) { return p[0]; });
        const auto converted = convertSign(table, SignConvention::Command, held);
        VERIFY_RESULT(converted);
        QVERIFY(converted->table.columns[2].values == (Values{0, -8, -18}));
    }

    void theExampleIsOfAnAxisThatIsMoved()
    {
        auto table = tableOver({axisX({0, 10})}, "Y", [](const Values&) { return 5.0; });
        addColumn(table, "X", [](const Values& p) { return p[0] == 0 ? 0.25 : 0.0; });
        QVERIFY2(examplePoint(table).english().find("0.25 mm") != std::string::npos,
            examplePoint(table).english().c_str());
    }

    void theExampleHasNoMoreDigitsThanTellTheSize()
    {
        const auto table =
            tableOver({axisX({0, 10})}, "Y", [](const Values&) { return 1.0 / 300.0; });
        const std::string text = examplePoint(table).english();
        QVERIFY2(text.find("0.00333333 mm above") != std::string::npos, text.c_str());
    }

    void aPlaceBehindTheLastKnotIsSaidWhereNothingIsAppliedThere()
    {
        const auto table = tableOver(
            {axisX({0, 10})}, "X", [](const Values& p) { return p[0] == 0 ? 0.0 : -1.0; });
        const auto ended = convertSign(table, SignConvention::Command, {.outside = Outside::Zero});
        VERIFY_RESULT(ended);
        QVERIFY(ended->usesHeldEnds);
        const auto whole = convertSign(table, SignConvention::Command, held);
        VERIFY_RESULT(whole);
        QVERIFY(!whole->usesHeldEnds);
    }

    /// e(x) = 1 + x / 10 everywhere: c(x) = -(1 + x / 10) / 1.1, also at places outside of the
    /// knots.
    void aTableThatGoesOnIsConvertedAsALine()
    {
        const auto table =
            tableOver({axisX({0, 10, 30})}, "X", [](const Values& p) { return 1 + 0.1 * p[0]; });
        const auto command = convertSign(table, SignConvention::Command, test::goingOn);
        VERIFY_RESULT(command);
        QVERIFY(test::largestDifference(
                    command->table.columns[0].values, {-1 / 1.1, -2 / 1.1, -4 / 1.1})
            < 1e-14);
        QVERIFY(command->residual < 1e-14 && !command->usesHeldEnds);
        const auto back = convertSign(command->table, SignConvention::Feedback, test::goingOn);
        VERIFY_RESULT(back);
        QVERIFY(test::largestDifference(back->table.columns[0].values, table.columns[0].values)
            < 1e-14);
        // Held, the place for 0 is at -1, and not at -1 / 1.1.
        const auto ended = convertSign(table, SignConvention::Command, held);
        VERIFY_RESULT(ended);
        QCOMPARE(ended->table.columns[0].values[0], -1.0);
    }

    /// Both ends of the first column fall outside: e = a + M x, so c = -(1 + M)^-1 (a + M x).
    void twoAxesThatGoOnAreConvertedTogether()
    {
        auto table = tableOver({axisX({-10, 0, 10}), axisX({0, 5})}, "X",
            [](const Values& p) { return 0.5 + 0.01 * p[0] + 0.02 * p[1]; });
        table.axes[1].name = "Y";
        addColumn(table, "Y", [](const Values& p) { return -0.2 + 0.03 * p[0] - 0.01 * p[1]; });
        const auto command = convertSign(table, SignConvention::Command, test::goingOn);
        VERIFY_RESULT(command);
        const double determinant = 1.01 * 0.99 - 0.02 * 0.03;
        for (std::size_t i = 0; i < table.pointCount(); ++i) {
            const Values p = test::positionOf(table, i);
            const double a = 0.5 + 0.01 * p[0] + 0.02 * p[1];
            const double b = -0.2 + 0.03 * p[0] - 0.01 * p[1];
            const double x = -(0.99 * a - 0.02 * b) / determinant;
            const double y = -(1.01 * b - 0.03 * a) / determinant;
            QVERIFY(std::abs(command->table.columns[0].values[i] - x) < 1e-12);
            QVERIFY(std::abs(command->table.columns[1].values[i] - y) < 1e-12);
        }
        const auto back = convertSign(command->table, SignConvention::Feedback, test::goingOn);
        VERIFY_RESULT(back);
        for (std::size_t n = 0; n < 2; ++n)
            QVERIFY(test::largestDifference(back->table.columns[n].values, table.columns[n].values)
                < 1e-12);
    }

    /// Within the knots the slopes are gentle; where the cells go on, they are not.
    void aTwistThatGrowsTooSteepOutsideIsRefused()
    {
        auto table = tableOver({axisX({-1, 1}), axisX({-1, 1})}, "X",
            [](const Values& p) { return 0.45 * p[0] * p[1]; });
        table.axes[1].name = "Y";
        addColumn(table, "Y", [](const Values& p) { return 0.45 * p[0] * p[1]; });
        VERIFY_RESULT(convertSign(table, SignConvention::Command, held));
        VERIFY_ERROR(convertSign(table, SignConvention::Command, test::goingOn),
            ErrorCode::SignNotConvertible);
    }

    void theSameSignIsLeftAsItIs()
    {
        const auto table =
            tableOver({axisX({0, 1})}, "X", [](const Values& p) { return -9 * p[0]; });
        const auto same = convertSign(table, SignConvention::Feedback, held);
        VERIFY_RESULT(same);
        QCOMPARE(same->table, table);
    }

    void tablesThatAreNotConsistentAreRefused_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QByteArray>("reason");
        QTest::addRow("no axis") << 0 << QByteArray("1 to 3 source axes, this has 0");
        QTest::addRow("one knot") << 1 << QByteArray("X has fewer than two positions");
        QTest::addRow("knots") << 2 << QByteArray("the positions of X do not increase strictly");
        QTest::addRow("values") << 3 << QByteArray("1 values for X to X, for 2 points");
        QTest::addRow("infinite") << 4 << QByteArray("a value for X to X is not a finite number");
        QTest::addRow("period") << 5
                                << QByteArray("the period of X, 5 mm, is shorter than the "
                                              "range of its positions, 10 mm");
        QTest::addRow("twice") << 6
                               << QByteArray("columns 1 and 2 both correct X in the same "
                                             "direction; keep one of them");
        QTest::addRow("units") << 7
                               << QByteArray("the values for X to X are in mrad, which cannot "
                                             "be given in mm");
        QTest::addRow("no column") << 8 << QByteArray("the table has no values");
    }
    void tablesThatAreNotConsistentAreRefused()
    {
        QFETCH(int, kind);
        QFETCH(QByteArray, reason);
        auto table = tableOver({axisX({0, 10})}, "X", [](const Values&) { return 0.0; });
        if (kind == 0)
            table.axes.clear();
        if (kind == 1)
            table.axes[0].knots = {0};
        if (kind == 2)
            table.axes[0].knots = {0, 0};
        if (kind == 3)
            table.columns[0].values = {0};
        if (kind == 4)
            table.columns[0].values[1] = INFINITY;
        if (kind == 5)
            table.axes[0].wrap = 5;
        if (kind == 6)
            addColumn(
                table, "X", [](const Values&) { return 0.0; }, Direction::Positive);
        if (kind == 7)
            table.columns[0].unit = "mrad";
        if (kind == 8)
            table.columns.clear();
        const auto result = convertSign(table, SignConvention::Command, held);
        VERIFY_ERROR(result, ErrorCode::InvalidArgument);
        QVERIFY2(reasonOf(result).find(reason.toStdString()) != std::string::npos,
            reasonOf(result).c_str());
    }

    void theExampleIsThePointOfTheLargestValueInBothFiles()
    {
        const auto table = tableOver({axisX({0, 20, 40, 60})}, "X",
            [](const Values& p) { return p[0] == 40 ? 0.0021 : 0.0; });
        const auto converted = convertSign(table, SignConvention::Command, held);
        VERIFY_RESULT(converted);
        const std::string expected = "where the encoder reads 40 mm the reference says 40.0021 mm: "
                                     "the feedback file says +0.0021 mm, the command file "
                                     "-0.00209978 mm";
        QCOMPARE(examplePoint(table, converted->table).english(), expected);
        const auto back = convertSign(converted->table, SignConvention::Feedback, held);
        VERIFY_RESULT(back);
        const std::string example = examplePoint(back->table, converted->table).english();
        QVERIFY2(example.starts_with("where the encoder reads 40 mm the reference says"),
            example.c_str());
    }

    void numbersOfUnlikeUnitsAreNotAdded_data()
    {
        QTest::addColumn<QByteArray>("ofPosition");
        QTest::addColumn<QByteArray>("ofValue");
        QTest::addColumn<QByteArray>("feedback");
        QTest::addColumn<QByteArray>("command");
        QTest::newRow("an angle and a length")
            << QByteArray("mm") << QByteArray("arcsec")
            << QByteArray("where the encoder reads 40 mm the reference of X is 12 arcsec above its "
                          "encoder: the feedback file says +12 arcsec")
            << QByteArray("commanded to 40 mm, where the reference of X is 12 arcsec below its "
                          "encoder, the controller moves X by +12 arcsec: the command file says "
                          "+12 arcsec");
        QTest::newRow("positions without a unit")
            << QByteArray() << QByteArray("um")
            << QByteArray("where the encoder reads 40 the reference of X is 12 um above its "
                          "encoder: the feedback file says +12 um")
            << QByteArray("commanded to 40, where the reference of X is 12 um below its encoder, "
                          "the controller moves X by +12 um: the command file says +12 um");
        QTest::newRow("values without a unit")
            << QByteArray("mm") << QByteArray()
            << QByteArray("where the encoder reads 40 mm the reference of X is 12 above its "
                          "encoder: the feedback file says +12")
            << QByteArray("commanded to 40 mm, where the reference of X is 12 below its encoder, "
                          "the controller moves X by +12: the command file says +12");
        QTest::newRow("neither has a unit")
            << QByteArray() << QByteArray()
            << QByteArray("where the encoder reads 40 the reference says 52: the feedback file "
                          "says +12")
            << QByteArray("commanded to 40, the controller moves the encoder to 52, where the "
                          "reference says 40: the command file says +12");
    }
    void numbersOfUnlikeUnitsAreNotAdded()
    {
        QFETCH(QByteArray, ofPosition);
        QFETCH(QByteArray, ofValue);
        QFETCH(QByteArray, feedback);
        QFETCH(QByteArray, command);
        NeutralTable table = tableOver(
            {axisX({0, 40, 60})}, "X", [](const Values& p) { return p[0] == 40 ? 12.0 : -5.0; });
        table.axes[0].unit = ofPosition.toStdString();
        table.columns[0].unit = ofValue.toStdString();
        QCOMPARE(examplePoint(table).english(), feedback.toStdString());
        table.sign = SignConvention::Command;
        QCOMPARE(examplePoint(table).english(), command.toStdString());
    }

    void columnsOfZerosAreNoExample()
    {
        auto table = tableOver({axisX({0, 40, 60})}, "X", [](const Values&) { return 0.0; });
        addColumn(table, "Z", [](const Values& p) { return p[0] == 40 ? 0.0021 : 0.0; });
        QCOMPARE(examplePoint(table).english(),
            std::string("where the encoder reads 40 mm the reference of Z is 0.0021 mm above its "
                        "encoder: the feedback file says +0.0021 mm"));
    }

    void theExampleTellsTheSignOfAnyTable_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QByteArray>("text");
        QTest::addRow("feedback") << 0
                                  << QByteArray("where the encoder reads 40 mm the reference says "
                                                "39.9979 mm: the feedback file says -0.0021 mm");
        QTest::addRow("command") << 1
                                 << QByteArray("commanded to 40 mm, the controller moves the "
                                               "encoder to 39.9979 mm, where the reference says 40 "
                                               "mm: the command file says -0.0021 mm");
        QTest::addRow("cross") << 2
                               << QByteArray("where the encoder reads 40 mm the reference of Z is "
                                             "0.0021 mm below its encoder: the feedback file says "
                                             "-0.0021 mm");
        QTest::addRow("cross command")
            << 3
            << QByteArray("commanded to 40 mm, where the reference of Z is 0.0021 mm above its "
                          "encoder, the controller moves Z by -0.0021 mm: the command file says "
                          "-0.0021 mm");
        QTest::addRow("plane") << 4
                               << QByteArray("where the encoders read X = 40 mm, Y = 5 mm the "
                                             "reference of Y says 4.9979 mm: the feedback file "
                                             "says -2.1 um");
        QTest::addRow("direction") << 5
                                   << QByteArray("moving in negative direction, where the encoder "
                                                 "reads 40 mm the reference says 39.9979 mm: the "
                                                 "feedback file says -0.0021 mm");
        QTest::addRow("zero") << 6 << QByteArray("all values are 0, in either sign");
    }
    void theExampleTellsTheSignOfAnyTable()
    {
        QFETCH(int, kind);
        QFETCH(QByteArray, text);
        const auto dent = [](const Values& p) { return p[0] == 40 ? -0.0021 : 0.001; };
        NeutralTable table = tableOver({axisX({0, 40, 60})}, "X", dent);
        if (kind == 1 || kind == 3)
            table.sign = SignConvention::Command;
        if (kind == 2 || kind == 3)
            table.columns[0].target = "Z";
        if (kind == 4) {
            table = tableOver({axisX({0, 40, 60}), evenAxis("Y", "mm", 5, 5, 2)}, "Y",
                [](const Values& p) { return p[0] == 40 && p[1] == 5 ? -2.1 : 1.0; });
            table.columns[0].unit = "um";
        }
        if (kind == 5)
            table.columns[0].direction = Direction::Negative;
        if (kind == 6)
            table.columns[0].values = {0, 0, 0};
        QCOMPARE(examplePoint(table).english(), text.toStdString());
    }

    /// As of a table that was fitted, and of which a zero was taken out.
    void ofAComputedTableTheExampleNamesNoReference_data()
    {
        QTest::addColumn<bool>("isPlane");
        QTest::addColumn<bool>("isCross");
        QTest::addColumn<QByteArray>("feedback");
        QTest::addColumn<QByteArray>("command");
        QTest::newRow("line") << false << false
                              << QByteArray("where the encoder reads 40 mm the controller takes "
                                            "the axis to be at 39.9979 mm")
                              << QByteArray("commanded to 40 mm, the controller moves the encoder "
                                            "to 39.9979 mm");
        QTest::newRow("cross") << false << true
                               << QByteArray("where the encoder reads 40 mm the controller adds "
                                             "-0.0021 mm to the position of Z")
                               << QByteArray(
                                      "commanded to 40 mm, the controller moves Z by -0.0021 mm");
        QTest::newRow("plane") << true << false
                               << QByteArray("where the encoders read X = 40 mm, Y = 5 mm the "
                                             "controller takes X to be at 39.9979 mm")
                               << QByteArray("commanded to X = 40 mm, Y = 5 mm, the controller "
                                             "moves the encoder of X to 39.9979 mm");
        QTest::newRow("cross plane") << true << true
                                     << QByteArray("where the encoders read X = 40 mm, Y = 5 mm "
                                                   "the controller adds -0.0021 mm to the "
                                                   "position of Z")
                                     << QByteArray("commanded to X = 40 mm, Y = 5 mm, the "
                                                   "controller moves Z by -0.0021 mm");
    }
    void ofAComputedTableTheExampleNamesNoReference()
    {
        QFETCH(const bool, isPlane);
        QFETCH(const bool, isCross);
        QFETCH(const QByteArray, feedback);
        QFETCH(const QByteArray, command);
        std::vector<SourceAxis> axes{axisX({0, 40, 60})};
        if (isPlane)
            axes.push_back(evenAxis("Y", "mm", 5, 5, 2));
        NeutralTable table = tableOver(axes, isCross ? "Z" : "X", [](const Values& p) {
            return p[0] == 40 && (p.size() == 1 || p[1] == 5) ? -0.0021 : 0.001;
        });
        QCOMPARE(examplePoint(table, true).english(),
            feedback.toStdString() + ": the feedback file says -0.0021 mm");
        table.sign = SignConvention::Command;
        QCOMPARE(examplePoint(table, true).english(),
            command.toStdString() + ": the command file says -0.0021 mm");
    }

    void ofSeveralPlacesThatAreTooSteepTheFirstIsNamed_data()
    {
        QTest::addColumn<bool>("isJoint");
        QTest::addRow("one axis moves") << false;
        QTest::addRow("both axes move") << true;
    }
    void ofSeveralPlacesThatAreTooSteepTheFirstIsNamed()
    {
        QFETCH(bool, isJoint);
        // Large enough for several threads.
        auto table = tableOver({evenAxis("X", "mm", 0, 1, 200), evenAxis("Y", "mm", 0, 1, 600)},
            "X", [](const Values& p) {
                return p[0] == 50 && (p[1] == 580 || p[1] == 90 || p[1] == 400) ? 1.5 : 0.0;
            });
        if (isJoint)
            addColumn(table, "Y", [](const Values&) { return 0.001; });
        for (int round = 0; round < 20; ++round) {
            const auto result = convertSign(table, SignConvention::Command, held);
            VERIFY_ERROR(result, ErrorCode::SignNotConvertible);
            const std::string text = reasonOf(result);
            QVERIFY2(text.find("Y = 90 mm") != std::string::npos, text.c_str());
        }
    }
};

AXISCOMP_TEST(TestSignConversion)

} // namespace tst_signconversion

#include "tst_signconversion.moc"
