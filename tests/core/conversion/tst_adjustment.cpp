// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/adjustment.h"

#include "tests/core/conversion/numeric_tables.h"
#include "tests/core/formats/format_checks.h"
#include "tests/support/test_registry.h"

namespace tst_adjustment {

using namespace axiscomp;
using Values = std::vector<double>;

namespace {

/// Over 0 .. 30 mm: 5, 7, 9, 4 um.
NeutralTable line()
{
    NeutralTable table;
    table.axes = {test::evenAxis("X", "mm", 0, 10, 4)};
    table.columns = {test::columnOf("X", "um", {5, 7, 9, 4})};
    return table;
}

/// Shifted so that it is 0 at a position.
Result<NeutralTable> zeroed(
    NeutralTable table, std::vector<double> zero, std::vector<Text>& remarks)
{
    Adjustment adjustment;
    adjustment.zero = std::move(zero);
    AXISCOMP_TRY(table, adjusted(std::move(table), adjustment, remarks));
    AXISCOMP_TRY(const auto position, zeroWithin(table, adjustment));
    if (const auto shifts = shiftsToZero(table, position))
        shiftColumns(table, *shifts, remarks);
    return table;
}

Values valuesOf(const Result<NeutralTable>& table)
{
    return table ? table->columns.front().values : Values{};
}

} // namespace

class TestAdjustment : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void valuesAreMultipliedAndShifted()
    {
        std::vector<Text> remarks;
        QCOMPARE(valuesOf(adjusted(line(), {.scale = -2.0, .offset = 1.0, .zero = {}}, remarks)),
            (Values{-9, -13, -17, -7}));
        QCOMPARE(remarks.size(), std::size_t{2});
        QCOMPARE(remarks[0].english(), std::string("the values are multiplied by -2"));
        QVERIFY2(
            remarks[1].english().ends_with("are shifted by 1 um"), remarks[1].english().c_str());
    }

    void valuesBecomeZeroAtAPositionBetweenThePoints()
    {
        std::vector<Text> remarks;
        const auto shifted = zeroed(line(), {12.5}, remarks); // 7.5 um
        QCOMPARE(valuesOf(shifted), (Values{-2.5, -0.5, 1.5, -3.5}));
        QVERIFY2(remarks.front().english().ends_with("are shifted by -7.5 um"),
            remarks.front().english().c_str());
    }

    void columnsThatCorrectTheSameAreNamed()
    {
        NeutralTable table = line();
        table.columns.push_back(test::columnOf("X", "um", {1, 1, 1, 1}));
        table.columns[0].name = "Table 1";
        table.columns[1].name = "Table 2";
        std::vector<Text> remarks;
        VERIFY_RESULT(zeroed(table, {10.0}, remarks));
        QCOMPARE(remarks.size(), std::size_t{2});
        QCOMPARE(remarks[0].english(), std::string("the values of Table 1 are shifted by -7 um"));
        QCOMPARE(remarks[1].english(), std::string("the values of Table 2 are shifted by -1 um"));
        table.columns[1].target = "Y"; // what they correct tells them apart
        remarks.clear();
        VERIFY_RESULT(zeroed(table, {10.0}, remarks));
        QVERIFY2(remarks[0].english().find("Table 1") == std::string::npos,
            remarks[0].english().c_str());
    }

    void ofAModuloAxisThePositionMayBeInAnotherTurn()
    {
        NeutralTable table = line(); // 0 .. 30 of a turn of 40
        table.axes.front().wrap = 40.0;
        std::vector<Text> remarks;
        for (const double zero : {12.5, 52.5, -27.5})
            QCOMPARE(valuesOf(zeroed(table, {zero}, remarks)), (Values{-2.5, -0.5, 1.5, -3.5}));
        VERIFY_ERROR(zeroed(table, {75.0}, remarks), ErrorCode::InvalidArgument);
    }

    void everyColumnHasItsOwnShift()
    {
        NeutralTable table = line();
        table.columns.push_back(test::columnOf("Y", "um", {1, 1, 2, 2}));
        std::vector<Text> remarks;
        const auto shifted = zeroed(table, {30.0}, remarks);
        QCOMPARE(valuesOf(shifted), (Values{1, 3, 5, 0}));
        QCOMPARE(shifted->columns[1].values, (Values{-1, -1, 0, 0}));
        QCOMPARE(remarks.size(), std::size_t{2});
    }

    void ofTwoDirectionsTheMeanIsZeroAndTheReversalStays()
    {
        NeutralTable table = line();
        table.columns.push_back(test::columnOf("X", "mm", {0.001, 0.003, 0.005, 0}));
        table.columns[0].direction = Direction::Positive;
        table.columns[1].direction = Direction::Negative;
        std::vector<Text> remarks;
        const auto shifted = zeroed(table, {0.0}, remarks);
        QCOMPARE(valuesOf(shifted), (Values{2, 4, 6, 1}));
        QVERIFY(test::largestDifference(shifted->columns[1].values, {-0.002, 0, 0.002, -0.003})
            < 1e-15);
    }

    /// By rounding, such as 0.1 + 0.2, the last knot may be below the position.
    void atTheEndsOfTheTableRoundingIsAllowedFor()
    {
        NeutralTable table = line();
        table.axes.front().knots.back() = 30.0 - 1e-12;
        std::vector<Text> remarks;
        QCOMPARE(valuesOf(zeroed(table, {30.0}, remarks)), (Values{1, 3, 5, 0}));
    }

    void aTableThatDoesNotReachThePositionSaysNoShift()
    {
        const std::vector<double> position{31.0};
        QVERIFY(!shiftsToZero(line(), position));
    }

    void nothingIsDoneUnasked()
    {
        std::vector<Text> remarks;
        QCOMPARE(valuesOf(adjusted(line(), {}, remarks)), (Values{5, 7, 9, 4}));
        QVERIFY(remarks.empty());
    }

    void whatCannotBeIsRefused_data()
    {
        QTest::addColumn<double>("scale");
        QTest::addColumn<double>("offset");
        QTest::addColumn<QList<double>>("zero");
        QTest::addColumn<QString>("reason");
        QTest::newRow("nothing is left") << 0.0 << 0.0 << QList<double>{} << "not 0";
        QTest::newRow("no number") << 1.0 << qQNaN() << QList<double>{} << "by a number";
        QTest::newRow("outside") << 1.0 << 0.0 << QList<double>{31.0} << "goes from 0 mm to 30 mm";
        QTest::newRow("two numbers") << 1.0 << 0.0 << QList<double>{1.0, 2.0} << "each of the 1";
        QTest::newRow("both") << 1.0 << 1.0 << QList<double>{1.0} << "contradict";
    }
    void whatCannotBeIsRefused()
    {
        QFETCH(double, scale);
        QFETCH(double, offset);
        QFETCH(QList<double>, zero);
        QFETCH(QString, reason);
        std::vector<Text> remarks;
        const Adjustment adjustment{scale, offset, {zero.begin(), zero.end()}};
        const auto made = adjusted(line(), adjustment, remarks);
        const auto result = made ? zeroWithin(*made, adjustment) : fail(made.error());
        VERIFY_ERROR(result, ErrorCode::InvalidArgument);
        QVERIFY2(test::mentions(sentence(result.error()), reason.toStdString()),
            sentence(result.error()).c_str());
    }
};

AXISCOMP_TEST(TestAdjustment)

} // namespace tst_adjustment

#include "tst_adjustment.moc"
