// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/directions.h"

#include "tests/core/conversion/numeric_tables.h"
#include "tests/support/test_registry.h"

namespace tst_directions {

using namespace axiscomp;
using test::addColumn;
using test::axisX;
using test::evenAxis;
using test::tableOver;
using Values = std::vector<double>;

namespace {

/// X with backlash that is largest at 20, Y without directions between its columns.
NeutralTable backlashTable()
{
    NeutralTable table;
    table.name = "machine";
    table.notes = {"measured"};
    table.axes = {axisX({0, 10, 20})};
    addColumn(
        table, "X", [](const Values& p) { return p[0]; }, Direction::Positive);
    addColumn(table, "Y", [](const Values&) { return 7.0; });
    addColumn(
        table, "X", [](const Values& p) { return p[0] - 1 - p[0] / 10; }, Direction::Negative);
    return table;
}

std::string reasonOf(const Result<MergedDirections>& result)
{
    return result ? "merged" : sentence(result.error());
}

} // namespace

class TestDirections : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aPairBecomesOneColumnForBothDirections_data()
    {
        QTest::addColumn<DirectionChoice>("choice");
        QTest::addColumn<Values>("values");
        QTest::addRow("mean") << DirectionChoice::Mean << Values{-0.5, 9, 18.5};
        QTest::addRow("positive") << DirectionChoice::Positive << Values{0, 10, 20};
        QTest::addRow("negative") << DirectionChoice::Negative << Values{-1, 8, 17};
    }
    void aPairBecomesOneColumnForBothDirections()
    {
        QFETCH(DirectionChoice, choice);
        QFETCH(Values, values);
        const NeutralTable table = backlashTable();
        const auto merged = mergeDirections(table, choice);
        VERIFY_RESULT(merged);
        QCOMPARE(merged->table.columns.size(), std::size_t(2));
        const CompensationColumn& column = merged->table.columns[0];
        QCOMPARE(column.target, std::string("X"));
        QCOMPARE(column.direction, Direction::Both);
        QCOMPARE(column.values, values);
        QCOMPARE(merged->table.columns[1], table.columns[1]); // Y is left as it is
        QCOMPARE(merged->table.axes, table.axes);
        QCOMPARE(merged->table.notes, table.notes);
        // what is lost is the same, whatever is chosen
        QCOMPARE(merged->losses.size(), std::size_t(1));
        QCOMPARE(merged->losses[0].column, std::size_t(0));
        QCOMPARE(merged->losses[0].largestHalfDifference, 1.5);
        QCOMPARE(merged->losses[0].position, (Values{20}));
    }

    void whatWasFilledInOneDirectionIsFilledInTheMean()
    {
        NeutralTable table = backlashTable();
        table.columns[0].filled = {0, 1};
        table.columns[2].filled = {1, 2};
        const auto filledBy = [&](DirectionChoice choice) {
            const auto merged = mergeDirections(table, choice);
            return merged ? merged->table.columns[0].filled : std::vector<std::uint32_t>{99};
        };
        QCOMPARE(filledBy(DirectionChoice::Positive), (std::vector<std::uint32_t>{0, 1}));
        QCOMPARE(filledBy(DirectionChoice::Negative), (std::vector<std::uint32_t>{1, 2}));
        QCOMPARE(filledBy(DirectionChoice::Mean), (std::vector<std::uint32_t>{0, 1, 2}));
    }

    void equalDirectionsLoseNothing()
    {
        NeutralTable table;
        table.axes = {axisX({0, 10}), evenAxis("Y", "mm", 0, 1, 2)};
        const auto sum = [](const Values& p) { return p[0] + p[1]; };
        addColumn(table, "X", sum, Direction::Negative);
        addColumn(table, "X", sum, Direction::Positive);
        const auto merged = mergeDirections(table, DirectionChoice::Mean);
        VERIFY_RESULT(merged);
        QCOMPARE(merged->table.columns[0].values, table.columns[0].values);
        QCOMPARE(merged->losses[0].largestHalfDifference, 0.0);
        QVERIFY(merged->losses[0].position.empty());
    }

    void thePositionOfTheLossHasAllAxes()
    {
        NeutralTable table;
        table.axes = {axisX({0, 10, 30}), evenAxis("Y", "mm", 5, 5, 2)};
        addColumn(
            table, "X", [](const Values&) { return 0.0; }, Direction::Positive);
        addColumn(
            table, "X", [](const Values& p) { return p[0] == 10 && p[1] == 10 ? 0.25 : 0.125; },
            Direction::Negative);
        const auto merged = mergeDirections(table, DirectionChoice::Positive);
        VERIFY_RESULT(merged);
        QCOMPARE(merged->losses[0].largestHalfDifference, 0.125);
        QCOMPARE(merged->losses[0].position, (Values{10, 10}));
    }

    void aTableWithoutDirectionsStaysAsItIs()
    {
        auto table = tableOver({axisX({0, 10})}, "", [](const Values& p) { return p[0]; });
        addColumn(table, "", [](const Values& p) { return -p[0]; });
        for (const auto choice :
            {DirectionChoice::Mean, DirectionChoice::Positive, DirectionChoice::Negative}) {
            const auto merged = mergeDirections(table, choice);
            VERIFY_RESULT(merged);
            QCOMPARE(merged->table, table);
            QVERIFY(merged->losses.empty());
        }
    }

    void severalTargetsArePairedEachForItself()
    {
        NeutralTable table;
        table.axes = {axisX({0, 10})};
        addColumn(
            table, "X", [](const Values&) { return 1.0; }, Direction::Positive);
        addColumn(
            table, "Y", [](const Values&) { return 10.0; }, Direction::Positive);
        addColumn(
            table, "Y", [](const Values&) { return 30.0; }, Direction::Negative);
        addColumn(
            table, "X", [](const Values&) { return 2.0; }, Direction::Negative);
        const auto merged = mergeDirections(table, DirectionChoice::Mean);
        VERIFY_RESULT(merged);
        QCOMPARE(merged->table.columns.size(), std::size_t(2));
        QCOMPARE(merged->table.columns[0].values, (Values{1.5, 1.5}));
        QCOMPARE(merged->table.columns[1].values, (Values{20, 20}));
        QCOMPARE(merged->losses[1].column, std::size_t(1));
        QCOMPARE(merged->losses[1].largestHalfDifference, 10.0);
        QCOMPARE(merged->columns, (std::vector<std::size_t>{0, 1, 1, 0}));
    }

    void unitsOfAPairMayDiffer()
    {
        NeutralTable table;
        table.axes = {axisX({0, 10})};
        addColumn(
            table, "X", [](const Values&) { return 0.25; }, Direction::Positive);
        addColumn(
            table, "X", [](const Values&) { return 750.0; }, Direction::Negative);
        table.columns[1].unit = "um";
        const auto mean = mergeDirections(table, DirectionChoice::Mean);
        VERIFY_RESULT(mean);
        QCOMPARE(mean->table.columns[0].unit, std::string("mm"));
        QCOMPARE(mean->table.columns[0].values, (Values{0.5, 0.5}));
        QCOMPARE(mean->losses[0].largestHalfDifference, 0.25);
        const auto negative = mergeDirections(table, DirectionChoice::Negative);
        VERIFY_RESULT(negative);
        QCOMPARE(negative->table.columns[0].values, (Values{0.75, 0.75}));
    }

    void aDirectionWithoutItsCounterpartMustBeChosen()
    {
        NeutralTable table;
        table.axes = {axisX({0, 10})};
        addColumn(
            table, "X", [](const Values& p) { return p[0]; }, Direction::Positive);
        const auto chosen = mergeDirections(table, DirectionChoice::Positive);
        VERIFY_RESULT(chosen);
        QCOMPARE(chosen->table.columns[0].direction, Direction::Both);
        QCOMPARE(chosen->table.columns[0].values, (Values{0, 10}));
        QVERIFY(chosen->losses.empty());
        const auto mean = mergeDirections(table, DirectionChoice::Mean);
        VERIFY_ERROR(mean, ErrorCode::InvalidArgument);
        QCOMPARE(reasonOf(mean),
            std::string("X has values for the positive direction only, so "
                        "that there is no mean; choose the positive "
                        "direction"));
        const auto negative = mergeDirections(table, DirectionChoice::Negative);
        VERIFY_ERROR(negative, ErrorCode::InvalidArgument);
        QCOMPARE(reasonOf(negative),
            std::string("X has values for the positive direction only, so "
                        "that there is no negative one; choose the "
                        "positive direction"));
    }

    void contradictionsAreRefused_data()
    {
        QTest::addColumn<Direction>("direction");
        QTest::addColumn<QByteArray>("unit");
        QTest::addColumn<QByteArray>("reason");
        QTest::addRow("twice") << Direction::Positive << QByteArray("mm")
                               << QByteArray("there are two columns for X in positive direction");
        QTest::addRow("both besides")
            << Direction::Both << QByteArray("mm")
            << QByteArray("for X there are values for both directions and others for one");
        QTest::addRow("units") << Direction::Negative << QByteArray("deg")
                               << QByteArray("the values for X are in deg, which cannot be given");
    }
    void contradictionsAreRefused()
    {
        QFETCH(Direction, direction);
        QFETCH(QByteArray, unit);
        QFETCH(QByteArray, reason);
        NeutralTable table;
        table.axes = {axisX({0, 10})};
        addColumn(
            table, "X", [](const Values& p) { return p[0]; }, Direction::Positive);
        addColumn(
            table, "X", [](const Values& p) { return p[0]; }, direction);
        table.columns[1].unit = unit.toStdString();
        for (const bool isReversed : {false, true}) {
            if (isReversed)
                std::swap(table.columns[0], table.columns[1]);
            const auto result = mergeDirections(table, DirectionChoice::Mean);
            VERIFY_ERROR(result, ErrorCode::InvalidArgument);
            if (!isReversed)
                QVERIFY2(
                    reasonOf(result).starts_with(reason.toStdString()), reasonOf(result).c_str());
        }
    }

    void aTableThatIsNotConsistentIsRefused()
    {
        NeutralTable table = backlashTable();
        table.columns[2].values.pop_back();
        VERIFY_ERROR(mergeDirections(table, DirectionChoice::Mean), ErrorCode::InvalidArgument);
    }

    void choicesHaveNames()
    {
        QCOMPARE(Text(choiceText(DirectionChoice::Mean)).english(), std::string("mean"));
        QCOMPARE(Text(choiceText(DirectionChoice::Positive)).english(), std::string("positive"));
        QCOMPARE(Text(choiceText(DirectionChoice::Negative)).english(), std::string("negative"));
    }
};

AXISCOMP_TEST(TestDirections)

} // namespace tst_directions

#include "tst_directions.moc"
