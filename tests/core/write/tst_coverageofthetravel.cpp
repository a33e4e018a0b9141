// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/compensator_fixture.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <algorithm>

namespace tst_coverageofthetravel {

using namespace axiscomp;
using test::CompensatorFixture;

namespace {

/// X travels from -10 to 90, and Y does not say how far.
struct Travelling : CompensatorFixture {
    Travelling()
    {
        set("Axes[0]/Parameters/PathPlanner/PositionMinimum", -10.0F);
        set("Axes[0]/Parameters/PathPlanner/PositionMaximum", 90.0F);
    }
};

/// From 0 in steps of 10.
WriteRequest tableOfX(std::uint32_t points)
{
    WriteRequest request;
    request.dimensionality = 1;
    request.sources = {test::masterX};
    request.table = test::exampleTable(1, 1, points);
    return request;
}

std::vector<std::string> said(const Result<WritePlan>& plan)
{
    std::vector<std::string> texts;
    for (const Text& warning : plan->warnings)
        texts.push_back(warning.english());
    return texts;
}

} // namespace

class TestCoverageOfTheTravel : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aTableThatEndsWithinTheTravelIsSaidWithItsNumbers()
    {
        Travelling f;
        const auto plan = f.compensator.plan(0, tableOfX(6));
        VERIFY_RESULT(plan);
        QCOMPARE(said(plan),
            (std::vector<std::string>{
                "Dimension 1 of the table reaches from 0 to 50: 50 % of the travel of axis 0, -10 "
                "to 90. Beyond the table the drive holds the value of its end."}));
        QCOMPARE(plan->coverage.front().share, 0.5);
    }

    void aTableBesideTheTravelIsSaid()
    {
        Travelling f;
        WriteRequest request = tableOfX(6);
        request.table->grid.axes[0].start = 100.0;
        const auto plan = f.compensator.plan(0, request);
        VERIFY_RESULT(plan);
        QCOMPARE(said(plan),
            (std::vector<std::string>{
                "Dimension 1 of the table reaches from 100 to 150: outside the travel of axis 0, "
                "-10 to 90. The drive holds the value of one end everywhere."}));
    }

    void aTableOverTheWholeTravelNeedsNoWord()
    {
        Travelling f;
        WriteRequest request = tableOfX(11);
        request.table->grid.axes[0].start = -10.0;
        const auto plan = f.compensator.plan(0, request);
        VERIFY_RESULT(plan);
        QVERIFY2(plan->warnings.empty(), said(plan).empty() ? "" : said(plan).front().c_str());
        QCOMPARE(plan->coverage.front().share, 1.0);
    }

    /// Axis Y is corrected over X: the travel is that of X.
    void theTravelIsThatOfTheSource()
    {
        Travelling f;
        const auto plan = f.compensator.plan(1, tableOfX(6));
        VERIFY_RESULT(plan);
        QCOMPARE(plan->coverage.size(), std::size_t{1});
        QCOMPARE(plan->coverage.front().axis, 0);
        QCOMPARE(plan->coverage.front().share, 0.5);
    }

    /// Only the numbers that reach the drive count: 0 to 5 cm are 0 to 50 mm.
    void theTableIsComparedInTheUnitsOfTheDrive()
    {
        Travelling f;
        WriteRequest request = tableOfX(6);
        request.table->grid.axes[0].unit = "cm";
        request.table->grid.axes[0].distance = 1.0;
        request.table->unit = "mm";
        const auto plan = f.compensator.plan(0, request);
        VERIFY_RESULT(plan);
        QCOMPARE(plan->coverage.front().share, 0.5);
    }

    void whatTheDriveHasAlreadyIsNoNews()
    {
        Travelling f;
        VERIFY_RESULT(f.compensator.write(0, tableOfX(6)));
        WriteRequest keep;
        keep.dimensionality = 1;
        keep.persistency = Persistency::Persistent;
        const auto plan = f.compensator.plan(0, keep);
        VERIFY_RESULT(plan);
        QVERIFY(plan->warnings.empty());
    }
};

AXISCOMP_TEST(TestCoverageOfTheTravel)

} // namespace tst_coverageofthetravel

#include "tst_coverageofthetravel.moc"
