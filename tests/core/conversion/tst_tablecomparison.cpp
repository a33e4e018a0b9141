// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/sign_conversion.h"

#include "tests/core/conversion/numeric_tables.h"
#include "tests/support/test_registry.h"

#include <numbers>

namespace tst_tablecomparison {

using namespace axiscomp;
using test::addColumn;
using test::axisX;
using test::evenAxis;
using test::held;
using test::tableOver;
using test::zeroOutside;
using Values = std::vector<double>;

namespace {

constexpr double pi = std::numbers::pi;

double wave(const Values& p)
{
    return 0.01 * std::sin(p[0] / 9.0);
}

/// The table of the other convention.
NeutralTable converted(const NeutralTable& table)
{
    const auto to =
        table.sign == SignConvention::Feedback ? SignConvention::Command : SignConvention::Feedback;
    const auto result = convertSign(table, to, held);
    return result ? result->table : NeutralTable{};
}

} // namespace

class TestConversionDifference : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aTableDoesNotDifferFromItself()
    {
        const auto table = tableOver({axisX({0, 7, 9, 30})}, "X", wave);
        const auto difference = conversionDifference(table, held, table, held);
        VERIFY_RESULT(difference);
        QCOMPARE(difference->columns.size(), std::size_t(1));
        QCOMPARE(difference->columns[0].largest, 0.0);
        QVERIFY(difference->columns[0].where.empty());
        QVERIFY(!difference->isThinned);
    }

    void tablesBesideEachOtherAreNotComparedCrosswise()
    {
        auto table = tableOver({axisX({0, 7, 9, 30})}, "X", wave);
        addColumn(table, "X", [](const Values& p) { return 0.02 + wave(p); });
        const auto difference = conversionDifference(table, held, table, held);
        VERIFY_RESULT(difference);
        QCOMPARE(difference->columns.size(), std::size_t(2));
        for (const ColumnDifference& column : difference->columns) {
            QCOMPARE(column.columnA, column.columnB);
            QCOMPARE(column.largest, 0.0);
        }
    }

    void oneChangedValueIsFoundAtItsPlace()
    {
        const auto a =
            tableOver({evenAxis("X", "mm", 0, 10, 9), evenAxis("Y", "mm", 0, 5, 4)}, "Z", wave);
        auto b = a;
        b.columns[0].values[4 + 9 * 2] += 0.25;
        const auto difference = conversionDifference(a, held, b, held);
        VERIFY_RESULT(difference);
        const ColumnDifference& column = difference->columns[0];
        QVERIFY(std::abs(column.largest - 0.25) < 1e-15);
        QCOMPARE(column.where, (Values{40, 10}));
        QCOMPARE(column.largestInside, column.largest);
        QCOMPARE(column.whereInside, column.where);
    }

    void aConvertedTableDiffersBySecondOrderTermsOnly()
    {
        const auto e = tableOver({evenAxis("X", "mm", 0, 5, 21)}, "X", wave);
        const double bound = 2.0 * test::largestKink(e) * test::largestSize(e.columns[0].values);
        for (const bool toCommand : {true, false}) {
            NeutralTable a = e;
            a.sign = toCommand ? SignConvention::Feedback : SignConvention::Command;
            const auto difference = conversionDifference(a, held, converted(a), held);
            VERIFY_RESULT(difference);
            const double found = difference->columns[0].largest;
            QVERIFY2(found > 0.0 && found <= bound, std::to_string(found).c_str());
            QVERIFY(bound < 0.01 * 0.2);
        }
    }

    /// The kinks of e are met between the knots of c: there the difference is largest.
    void theLargestDifferenceIsNotMissedBetweenKnots()
    {
        const auto e = tableOver(
            {evenAxis("X", "mm", 0, 5, 21)}, "X", [](const Values& p) { return 30 * wave(p); });
        const NeutralTable c = converted(e);
        const auto difference = conversionDifference(e, held, c, held);
        VERIFY_RESULT(difference);
        const ControllerLookup feedback(e, 0, held);
        const ControllerLookup command(c, 0, held);
        double largest = 0.0;
        for (int i = 0; i <= 100000; ++i) {
            const double x = 0.001 * i;
            const double shift = command.at(std::vector{x});
            largest = std::max(largest, std::abs(shift + feedback.at(std::vector{x + shift})));
        }
        QVERIFY(difference->columns[0].largest >= largest - 1e-12);
        QVERIFY(difference->columns[0].largest <= 1.01 * largest);
    }

    /// On every line along the axis that moves, where the shift is another one.
    void theLargestDifferenceOfAPlaneIsFoundToo()
    {
        const auto e = tableOver({evenAxis("X", "mm", 0, 5, 21), evenAxis("Y", "mm", 0, 10, 4)},
            "X", [](const Values& p) { return (0.1 + 0.003 * p[1]) * std::sin(p[0] / 9.0); });
        const NeutralTable c = converted(e);
        const auto difference = conversionDifference(e, held, c, held);
        VERIFY_RESULT(difference);
        const ControllerLookup feedback(e, 0, held);
        const ControllerLookup command(c, 0, held);
        double largest = 0.0;
        for (int j = 0; j <= 60; ++j)
            for (int i = 0; i <= 10000; ++i) {
                const double x = 0.01 * i;
                const double y = 0.5 * j;
                const double shift = command.at(std::vector{x, y});
                largest =
                    std::max(largest, std::abs(shift + feedback.at(std::vector{x + shift, y})));
            }
        QVERIFY2(difference->columns[0].largest >= largest - 1e-12,
            (std::to_string(difference->columns[0].largest) + " < " + std::to_string(largest))
                .c_str());
        QVERIFY(difference->columns[0].largest <= 1.01 * largest);
    }

    /// Both tables are exact at their points and along X; between two lines of X they are not.
    void theLargestDifferenceBetweenTwoLinesIsFound()
    {
        const auto e = tableOver({evenAxis("X", "mm", 0, 100, 2), evenAxis("Y", "mm", 0, 10, 2)},
            "X", [](const Values& p) { return 0.03 * (10 - p[1]) * p[0]; });
        const NeutralTable c = converted(e);
        const auto difference = conversionDifference(e, held, c, held);
        VERIFY_RESULT(difference);
        const ControllerLookup feedback(e, 0, held);
        const ControllerLookup command(c, 0, held);
        const std::vector place{100.0, 5.0};
        const double shift = command.at(place);
        const double middle = std::abs(shift + feedback.at(std::vector{100.0 + shift, 5.0}));
        QVERIFY(middle > 1.0);
        QVERIFY2(difference->columns[0].largestInside >= middle - 1e-12,
            std::to_string(difference->columns[0].largestInside).c_str());
    }

    void aFlatnessMapIsFoundWhereTheOtherFormatNumbersItsAxes()
    {
        const auto a =
            tableOver({evenAxis("X", "mm", 0, 10, 3), evenAxis("Y", "mm", 0, 5, 4)}, "Z", wave);
        auto b = tableOver({evenAxis("1", "mm", 0, 10, 3), evenAxis("2", "mm", 0, 5, 4)}, "1",
            [](const Values&) { return 0.0; });
        addColumn(b, "3", wave);
        b.columns[1].values[5] += 0.5;
        const auto difference = conversionDifference(a, held, b, held);
        VERIFY_RESULT(difference);
        QCOMPARE(difference->columns.size(), std::size_t(1));
        QCOMPARE(difference->columns[0].columnB, std::size_t(1));
        QVERIFY(std::abs(difference->columns[0].largest - 0.5) < 1e-12);
    }

    void theWrongSignIsTwiceTheError()
    {
        const auto e =
            tableOver({evenAxis("X", "mm", 0, 10, 9)}, "X", [](const Values&) { return 0.003; });
        auto wrong = e;
        wrong.sign = SignConvention::Command;
        const auto difference = conversionDifference(e, held, wrong, held);
        VERIFY_RESULT(difference);
        QVERIFY(std::abs(difference->columns[0].largest - 0.006) < 1e-15);
    }

    void whatControllersDoOutsideIsADifferenceOutside()
    {
        const auto table =
            tableOver({axisX({0, 10, 20})}, "X", [](const Values& p) { return 0.1 + 0.01 * p[0]; });
        const auto difference = conversionDifference(table, held, table, zeroOutside);
        VERIFY_RESULT(difference);
        const ColumnDifference& column = difference->columns[0];
        QVERIFY(std::abs(column.largest - 0.3) < 1e-15);
        QVERIFY(column.where[0] > 20);
        QCOMPARE(column.largestInside, 0.0);
        const TableBehaviour late{.outside = Outside::Hold, .startsAtFirst = true};
        const auto begin = conversionDifference(table, held, table, late);
        VERIFY_RESULT(begin);
        QVERIFY(std::abs(begin->columns[0].largest - 0.1) < 1e-15);
        QVERIFY(begin->columns[0].where[0] < 0);
    }

    /// A line and its opposite in the other convention are the same compensation everywhere, as
    /// long as both go on; against ends that are held the difference is that of a cell.
    void tablesThatGoOnAreComparedBeyondTheirEnds()
    {
        const auto e =
            tableOver({axisX({0, 10, 20})}, "X", [](const Values& p) { return 1 + 0.1 * p[0]; });
        const auto c = convertSign(e, SignConvention::Command, test::goingOn);
        VERIFY_RESULT(c);
        const auto same = conversionDifference(e, test::goingOn, c->table, test::goingOn);
        VERIFY_RESULT(same);
        QVERIFY2(same->columns[0].largest < 1e-13,
            qPrintable(QString::number(same->columns[0].largest)));
        const auto ended = conversionDifference(e, test::goingOn, e, held);
        VERIFY_RESULT(ended);
        QVERIFY(std::abs(ended->columns[0].largest - 1.0) < 1e-14);
        QVERIFY(ended->columns[0].where[0] == -10.0 || ended->columns[0].where[0] == 30.0);
        QCOMPARE(ended->columns[0].largestInside, 0.0);
    }

    /// Corrections of two axes that depend on each other, and are linear: the two conventions are
    /// the same everywhere, but only at the place where both axes are moved to.
    void aPositionThatMovesAlongTwoAxesIsFollowed()
    {
        auto e = tableOver({axisX({-10, 0, 10}), axisX({0, 5})}, "X",
            [](const Values& p) { return 0.5 + 0.01 * p[0] + 0.02 * p[1]; });
        e.axes[1].name = "Y";
        addColumn(e, "Y", [](const Values& p) { return -0.2 + 0.03 * p[0] - 0.01 * p[1]; });
        const auto c = convertSign(e, SignConvention::Command, test::goingOn);
        VERIFY_RESULT(c);
        for (const bool isFirst : {true, false}) {
            const NeutralTable& a = isFirst ? e : c->table;
            const NeutralTable& b = isFirst ? c->table : e;
            const auto difference = conversionDifference(a, test::goingOn, b, test::goingOn);
            VERIFY_RESULT(difference);
            QCOMPARE(difference->columns.size(), std::size_t(2));
            for (const ColumnDifference& column : difference->columns)
                QVERIFY2(column.largest < 1e-11, std::to_string(column.largest).c_str());
        }
    }

    void anEndThatTheShiftLeavesIsNotInside()
    {
        // at the first knot the encoder is moved to -0.1, where e is not applied
        const auto e = tableOver({axisX({0, 10, 20})}, "X", [](const Values&) { return 0.1; });
        const auto difference = conversionDifference(e, zeroOutside, converted(e), held);
        VERIFY_RESULT(difference);
        QVERIFY(std::abs(difference->columns[0].largest - 0.1) < 1e-15);
        QVERIFY(difference->columns[0].largestInside < 1e-15);
    }

    void aTableThatEndsEarlierDiffersOutsideTheCommonRange()
    {
        const auto a = tableOver({axisX({0, 10, 20})}, "X", [](const Values& p) { return p[0]; });
        const auto b = tableOver({axisX({0, 10})}, "X", [](const Values& p) { return p[0]; });
        const auto difference = conversionDifference(a, held, b, held);
        VERIFY_RESULT(difference);
        QCOMPARE(difference->columns[0].largest, 10.0);
        QCOMPARE(difference->columns[0].largestInside, 0.0);
    }

    void unitsMayDiffer()
    {
        const auto a = tableOver({axisX({0, 0.3, 10.7})}, "X", wave);
        auto b = a;
        b.axes[0].unit = "m";
        b.columns[0].unit = "um";
        for (double& knot : b.axes[0].knots)
            knot /= 1000;
        for (double& value : b.columns[0].values)
            value *= 1000;
        // with a step at the ends, which rounding must not cross
        const auto same = conversionDifference(a, zeroOutside, b, zeroOutside);
        VERIFY_RESULT(same);
        QVERIFY(same->columns[0].largestInside < 1e-15);
        const auto reversed = conversionDifference(converted(a), held, b, held);
        VERIFY_RESULT(reversed);
        // slopes of 0.0012 at most, values of 0.01: a unit mistaken would show as 0.01 or more
        QVERIFY(reversed->columns[0].largest < 1.2e-5);
        b.columns[0].values[1] += 7;
        const auto changed = conversionDifference(a, zeroOutside, b, zeroOutside);
        VERIFY_RESULT(changed);
        QVERIFY(std::abs(changed->columns[0].largest - 0.007) < 1e-15); // in a's unit
        QVERIFY(std::abs(changed->columns[0].where[0] - 0.3) < 1e-12);
    }

    void aModuloAxisIsComparedOverThreeTurns()
    {
        auto a = tableOver({test::turningAxis(13)}, "C",
            [](const Values& p) { return std::sin(p[0] * pi / 180); });
        a.columns[0].values.back() = a.columns[0].values.front();
        const auto same = conversionDifference(a, held, converted(a), held);
        VERIFY_RESULT(same);
        QVERIFY(same->columns[0].largest < 0.01);
        auto b = a;
        b.axes[0].wrap.reset();
        const auto open = conversionDifference(a, held, b, held);
        VERIFY_RESULT(open);
        QVERIFY(open->columns[0].largest > 0.99); // the second and third turn
        QVERIFY(open->columns[0].largestInside < 1e-12);
    }

    void directionsAreComparedWithTheirLike()
    {
        NeutralTable a;
        a.axes = {axisX({0, 10, 20})};
        addColumn(
            a, "X", [](const Values&) { return 0.1; }, Direction::Positive);
        addColumn(
            a, "X", [](const Values&) { return -0.1; }, Direction::Negative);
        auto swapped = a;
        std::swap(swapped.columns[0], swapped.columns[1]);
        const auto same = conversionDifference(a, held, swapped, held);
        VERIFY_RESULT(same);
        QCOMPARE(same->columns.size(), std::size_t(2));
        QCOMPARE(same->columns[0].columnB, std::size_t(1));
        QCOMPARE(same->columns[0].largest, 0.0);
        const auto mean = tableOver({axisX({0, 10, 20})}, "X", [](const Values&) { return 0.0; });
        for (const bool isFirst : {true, false}) {
            const auto merged = isFirst ? conversionDifference(a, held, mean, held)
                                        : conversionDifference(mean, held, a, held);
            VERIFY_RESULT(merged);
            QCOMPARE(merged->columns.size(), std::size_t(2));
            QCOMPARE(merged->columns[0].largest, 0.1);
            QCOMPARE(merged->columns[1].largest, 0.1);
        }
        const auto command = conversionDifference(a, held, converted(a), held);
        VERIFY_RESULT(command);
        QVERIFY(command->columns[1].largest < 1e-15);
    }

    void namesThatAFormatLostAreTakenFromTheOtherTable()
    {
        // straightness: nothing moves, although a table without names would seem to
        const auto e =
            tableOver({axisX({0, 1, 2})}, "Y", [](const Values& p) { return 0.3 * p[0]; });
        auto c = converted(e);
        c.axes[0].name.clear();
        c.columns[0].target.clear();
        for (const bool isFirst : {true, false}) {
            const auto difference = isFirst ? conversionDifference(e, held, c, held)
                                            : conversionDifference(c, held, e, held);
            VERIFY_RESULT(difference);
            QCOMPARE(difference->columns[0].largest, 0.0);
        }
    }

    void manyPositionsAreThinnedToTheLimit()
    {
        NeutralTable a;
        a.axes = {evenAxis("X", "mm", 0, 1, 60), evenAxis("Y", "mm", 0, 1, 50),
            evenAxis("Z", "mm", 0, 1, 3)};
        addColumn(a, "X", wave);
        const auto all = conversionDifference(a, held, a, held, 1'000'000);
        VERIFY_RESULT(all);
        QVERIFY(!all->isThinned);
        QCOMPARE(all->positions, std::size_t(64) * 54 * 7);
        auto b = a;
        for (double& value : b.columns[0].values)
            value += 0.5;
        const auto thin = conversionDifference(a, held, b, held, 5000);
        VERIFY_RESULT(thin);
        QVERIFY(thin->isThinned);
        QVERIFY(thin->positions <= 5000);
        QVERIFY(thin->positions > 3000);
        QVERIFY(std::abs(thin->columns[0].largest - 0.5) < 1e-12);
    }

    void tablesThatCannotBeComparedAreRefused_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QByteArray>("reason");
        QTest::addRow("dimensions")
            << 0 << QByteArray("a table of 1 source axes cannot be compared with one of 2");
        QTest::addRow("units") << 1 << QByteArray("the positions of X are in mm");
        QTest::addRow("column") << 2 << QByteArray("the second table has no column for X to X");
        QTest::addRow("values") << 3 << QByteArray("the values for X to X are in deg");
        QTest::addRow("inconsistent") << 4 << QByteArray("X has fewer than two positions");
    }
    void tablesThatCannotBeComparedAreRefused()
    {
        QFETCH(int, kind);
        QFETCH(QByteArray, reason);
        const auto a = tableOver({axisX({0, 10})}, "X", wave);
        auto b = a;
        if (kind == 0)
            b = tableOver({axisX({0, 10}), evenAxis("Y", "mm", 0, 1, 2)}, "X", wave);
        if (kind == 1)
            b.axes[0].unit = "deg";
        if (kind == 2) {
            b.columns[0].target = "Y";
            addColumn(b, "Z", wave);
        }
        if (kind == 3)
            b.columns[0].unit = "deg";
        if (kind == 4)
            b.axes[0].knots = {0};
        const auto result = conversionDifference(a, held, b, held);
        VERIFY_ERROR(result, ErrorCode::InvalidArgument);
        const std::string text = sentence(result.error());
        QVERIFY2(text.find(reason.toStdString()) != std::string::npos, text.c_str());
    }

    void ofTwoDifferencesThatAreAsLargeTheFirstIsNamed()
    {
        // Large enough for several threads.
        const auto a = tableOver({evenAxis("X", "mm", 0, 1, 300), evenAxis("Y", "mm", 0, 1, 500)},
            "Z", [](const Values&) { return 0.25; });
        NeutralTable b = a;
        for (const std::size_t y : {480U, 70U, 300U})
            b.columns[0].values[y * 300 + 11] = 0.5;
        for (int round = 0; round < 20; ++round) {
            const auto difference = conversionDifference(a, held, b, held);
            VERIFY_RESULT(difference);
            QCOMPARE(difference->columns[0].largest, 0.25);
            QCOMPARE(difference->columns[0].where, (Values{11.0, 70.0}));
            QCOMPARE(difference->columns[0].whereInside, (Values{11.0, 70.0}));
        }
    }

    /// A cell below the knots of Y the command table, which goes on, is so steep along X that
    /// x + c(x) turns back; the largest difference is where it meets a knot of the other table.
    void whereACommandTableTurnsBackThePlacesAreFoundAsWell()
    {
        auto command = tableOver(
            {evenAxis("X", "mm", 0, 1, 7), evenAxis("Y", "mm", 0, 1, 2)}, "X",
            [](const Values&) { return 0.0; }, SignConvention::Command);
        NeutralTable feedback = command;
        feedback.sign = SignConvention::Feedback;
        command.columns[0].values = {
            0.15, 0.4, 0.35, 0, 0.3, -0.4, -0.1, -0.1, -0.4, -0.1, 0.1, -0.25, 0.35, 0.35};
        feedback.columns[0].values = {
            0.45, 0.05, 0.1, 0.4, -0.2, -0.15, 0.1, 0.15, 0.15, 0.4, -0.2, 0.25, 0.1, -0.25};
        const auto difference =
            conversionDifference(command, test::goingOn, feedback, test::goingOn);
        VERIFY_RESULT(difference);
        QVERIFY(std::abs(difference->columns[0].largest - 1.74375) < 1e-12);
        QVERIFY(std::abs(difference->columns[0].where[0] - 5.09375) < 1e-12);
        QCOMPARE(difference->columns[0].where[1], -1.0);
    }

    void aLargePlaneIsComparedTheSameEachTime()
    {
        const auto a =
            tableOver({evenAxis("X", "mm", 0, 0.5, 400), evenAxis("Y", "mm", 0, 0.5, 400)}, "X",
                [](const Values& p) { return 0.02 * std::sin(p[0] / 3.0) * std::cos(p[1] / 5.0); });
        const NeutralTable b = converted(a);
        const auto first = conversionDifference(a, held, b, held);
        VERIFY_RESULT(first);
        QVERIFY(first->columns[0].largest > 0.0 && first->columns[0].largest < 1e-4);
        for (int round = 0; round < 5; ++round) {
            QVERIFY(converted(a) == b);
            const auto again = conversionDifference(a, held, b, held);
            VERIFY_RESULT(again);
            QVERIFY(again->columns[0].largest == first->columns[0].largest);
            QVERIFY(again->columns[0].where == first->columns[0].where);
            QVERIFY(again->columns[0].largestInside == first->columns[0].largestInside);
            QCOMPARE(again->positions, first->positions);
        }
    }
};

AXISCOMP_TEST(TestConversionDifference)

} // namespace tst_tablecomparison

#include "tst_tablecomparison.moc"
