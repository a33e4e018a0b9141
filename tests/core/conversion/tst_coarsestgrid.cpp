// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/resampling/resampling.h"
#include "core/text/number_text.h"

#include "tests/core/conversion/numeric_tables.h"
#include "tests/support/test_registry.h"

#include <numbers>

namespace tst_coarsestgrid {

using namespace axiscomp;
using test::addColumn;
using test::axisX;
using test::evenAxis;
using test::tableOver;
using Values = std::vector<double>;
using Sizes = std::vector<std::size_t>;

namespace {

constexpr double pi = std::numbers::pi;
constexpr auto linear = ResamplingMethod::Linear;
constexpr auto cubic = ResamplingMethod::MonotoneCubic;

/// What a grid of so many points deviates, by resampling onto it.
double deviationWith(const NeutralTable& table, const Sizes& sizes, ResamplingMethod method)
{
    ResamplingRequest request{.axes = {}, .method = method};
    for (const std::size_t size : sizes)
        request.axes.push_back({.points = size});
    const auto result = resample(table, request);
    double largest = result ? 0.0 : INFINITY;
    for (std::size_t i = 0; result && i < table.columns.size(); ++i)
        largest = std::max(largest, result->report.columns[i].largest);
    return largest;
}

SourceAxis unevenAxis(const std::string& name, std::size_t count)
{
    SourceAxis axis = axisX({});
    axis.name = name;
    for (std::size_t i = 0; i < count; ++i)
        axis.knots.push_back(double(i) + 0.3 * std::sin(5.0 * double(i)));
    return axis;
}

} // namespace

class TestCoarsestGrid : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void inOneDimensionTheFewestPointsOfAllAreFound_data()
    {
        QTest::addColumn<bool>("isCubic");
        QTest::addColumn<double>("deviation");
        for (const bool isCubic : {false, true})
            for (const double deviation : {2.0, 0.5, 0.1, 0.03, 0.01})
                QTest::addRow("%s, %g", isCubic ? "cubic" : "linear", deviation)
                    << isCubic << deviation;
    }
    void inOneDimensionTheFewestPointsOfAllAreFound()
    {
        QFETCH(bool, isCubic);
        QFETCH(double, deviation);
        const auto method = isCubic ? cubic : linear;
        const auto table = tableOver({unevenAxis("X", 60)}, "X",
            [](const Values& p) { return std::sin(p[0] / 3) + 0.1 * std::sin(p[0]); });
        const auto found = coarsestGrid(table, deviation, method);
        VERIFY_RESULT(found);
        QCOMPARE(found->points.size(), std::size_t(1));
        QVERIFY(found->deviation <= deviation);
        QCOMPARE(found->deviation, deviationWith(table, found->points, method));
        for (std::size_t points = 2; points < found->points[0]; ++points)
            QVERIFY(deviationWith(table, {points}, method) > deviation);
    }

    void morePointsCanBeWorseAndAreNotTaken()
    {
        const auto hat = tableOver(
            {axisX({0, 5, 10})}, "X", [](const Values& p) { return p[0] == 5 ? 1.0 : 0.0; });
        QVERIFY(deviationWith(hat, {4}, linear) > 0.3);
        const auto found = coarsestGrid(hat, 0.1, linear);
        VERIFY_RESULT(found);
        QCOMPARE(found->points, (Sizes{3}));
        QCOMPARE(found->deviation, 0.0);
    }

    void anEvenTableNeedsItsOwnPointsForNoDeviation()
    {
        NeutralTable table;
        table.axes = {evenAxis("X", "mm", -0.7, 0.1, 23), evenAxis("Y", "mm", 3, 0.3, 7)};
        addColumn(table, "X", [](const Values& p) { return std::sin(9 * p[0] + 20 * p[1]); });
        for (const auto method : {linear, cubic}) {
            const auto found = coarsestGrid(table, 0.0, method);
            VERIFY_RESULT(found);
            QCOMPARE(found->points, (Sizes{23, 7}));
            QCOMPARE(found->deviation, 0.0);
        }
    }

    void aPlaneNeedsTwoPoints()
    {
        NeutralTable table;
        table.axes = {unevenAxis("X", 9), unevenAxis("Y", 5), unevenAxis("Z", 4)};
        addColumn(table, "X", [](const Values& p) { return p[0] - 2 * p[1] + p[2]; });
        const auto found = coarsestGrid(table, 1e-9, linear);
        VERIFY_RESULT(found);
        QCOMPARE(found->points, (Sizes{2, 2, 2}));
    }

    void inTwoAndThreeDimensionsNoAxisCanDoWithOneLess_data()
    {
        QTest::addColumn<int>("dimensions");
        QTest::addColumn<bool>("isCubic");
        QTest::addRow("2D, linear") << 2 << false;
        QTest::addRow("2D, cubic") << 2 << true;
        QTest::addRow("3D, linear") << 3 << false;
    }
    void inTwoAndThreeDimensionsNoAxisCanDoWithOneLess()
    {
        QFETCH(int, dimensions);
        QFETCH(bool, isCubic);
        const auto method = isCubic ? cubic : linear;
        NeutralTable table;
        table.axes = {unevenAxis("X", 25), unevenAxis("Y", 14), unevenAxis("Z", 6)};
        table.axes.resize(static_cast<std::size_t>(dimensions));
        addColumn(table, "X", [](const Values& p) {
            return std::sin(p[0] / 4) * std::cos(p[1] / 5) + (p.size() > 2 ? p[2] * p[2] / 50 : 0);
        });
        for (const double deviation : {0.2, 0.05}) {
            const auto found = coarsestGrid(table, deviation, method);
            VERIFY_RESULT(found);
            QVERIFY(found->deviation <= deviation);
            QCOMPARE(found->deviation, deviationWith(table, found->points, method));
            for (std::size_t n = 0; n < found->points.size(); ++n) {
                Sizes fewer = found->points;
                --fewer[n];
                QVERIFY(fewer[n] < 2 || deviationWith(table, fewer, method) > deviation);
            }
        }
    }

    void tenThousandKnotsAreNoDifficulty()
    {
        const auto table = tableOver({unevenAxis("X", 10000)}, "X",
            [](const Values& p) { return std::sin(p[0] / 200) + 0.02 * std::sin(p[0] / 7); });
        for (const auto method : {linear, cubic}) {
            const auto found = coarsestGrid(table, 0.001, method);
            VERIFY_RESULT(found);
            QVERIFY(found->points[0] > 1000 && found->points[0] < 10000);
            QVERIFY(deviationWith(table, found->points, method) <= 0.001);
            QVERIFY(deviationWith(table, {found->points[0] - 1}, method) > 0.001);
        }
        // a deviation that no grid up to the limit keeps: every one of them is tried
        const auto never =
            coarsestGrid(table, 0.0, linear, {.mostPoints = 100'000, .mostPerAxis = {}});
        VERIFY_ERROR(never, ErrorCode::ResamplingImpossible);
    }

    void aLimitThatDoesNotSufficeSaysWhatIsPossible()
    {
        const auto table = tableOver(
            {unevenAxis("X", 60)}, "X", [](const Values& p) { return std::sin(p[0] / 3); });
        const auto result = coarsestGrid(table, 0.001, linear, {.mostPerAxis = {12}});
        VERIFY_ERROR(result, ErrorCode::ResamplingImpossible);
        const std::string possible = roundedText(deviationWith(table, {12}, linear));
        QCOMPARE(sentence(result.error()),
            "the table cannot be resampled: a deviation of 0.001 mm takes more than 12 points "
            "along X; with 12 it is "
                + possible + " mm; allow more points or a larger deviation");
    }

    void aLimitOfAllPointsSaysWhatIsPossibleToo()
    {
        NeutralTable table;
        table.axes = {unevenAxis("X", 25), unevenAxis("Y", 25)};
        addColumn(
            table, "X", [](const Values& p) { return std::sin(p[0] / 3) + std::sin(p[1] / 3); });
        const auto wanted = coarsestGrid(table, 0.1, linear);
        VERIFY_RESULT(wanted);
        const std::size_t needed = wanted->points[0] * wanted->points[1];
        const auto enough =
            coarsestGrid(table, 0.1, linear, {.mostPoints = 2 * needed, .mostPerAxis = {}});
        VERIFY_RESULT(enough);
        const auto result =
            coarsestGrid(table, 0.1, linear, {.mostPoints = needed - 10, .mostPerAxis = {}});
        VERIFY_ERROR(result, ErrorCode::ResamplingImpossible);
        const std::string text = sentence(result.error());
        QVERIFY2(text.find("a deviation of 0.1 mm takes more points than allowed; with ")
                != std::string::npos,
            text.c_str());
    }

    void columnsAreComparedInTheUnitOfTheFirst()
    {
        auto table = tableOver({unevenAxis("X", 60)}, "X", [](const Values&) { return 0.0; });
        addColumn(table, "Y", [](const Values& p) { return 1000 * std::sin(p[0] / 3); });
        table.columns[1].unit = "um";
        auto inMm = tableOver(
            {unevenAxis("X", 60)}, "Y", [](const Values& p) { return std::sin(p[0] / 3); });
        const auto mixed = coarsestGrid(table, 0.05, linear);
        const auto plain = coarsestGrid(inMm, 0.05, linear);
        VERIFY_RESULT(mixed);
        VERIFY_RESULT(plain);
        QCOMPARE(mixed->points, plain->points);
        QVERIFY(std::abs(mixed->deviation - plain->deviation) < 1e-12);
    }

    void aModuloAxisIsSearchedOverItsTurn()
    {
        auto table = tableOver(
            {test::turningAxis(73)}, "C", [](const Values& p) { return std::sin(p[0] * pi / 90); });
        table.columns[0].values.back() = table.columns[0].values.front();
        for (const auto method : {linear, cubic}) {
            const auto found = coarsestGrid(table, 0.02, method);
            VERIFY_RESULT(found);
            QVERIFY(found->deviation <= 0.02);
            for (std::size_t points = 2; points < found->points[0]; ++points)
                QVERIFY(deviationWith(table, {points}, method) > 0.02);
        }
    }

    void whatMakesNoSenseIsRefused()
    {
        const auto table =
            tableOver({axisX({0, 1, 10})}, "X", [](const Values& p) { return p[0]; });
        for (const double deviation : {-1.0, double(NAN), double(INFINITY)})
            VERIFY_ERROR(coarsestGrid(table, deviation, linear), ErrorCode::InvalidArgument);
        VERIFY_ERROR(
            coarsestGrid(table, 1, linear, {.mostPerAxis = {3, 3}}), ErrorCode::InvalidArgument);
        VERIFY_ERROR(
            coarsestGrid(table, 1, linear, {.mostPerAxis = {1}}), ErrorCode::InvalidArgument);
        VERIFY_ERROR(coarsestGrid(table, 1, linear, {.mostPoints = 1, .mostPerAxis = {}}),
            ErrorCode::InvalidArgument);
        VERIFY_ERROR(coarsestGrid(NeutralTable{}, 1, linear), ErrorCode::InvalidArgument);
    }
};

AXISCOMP_TEST(TestCoarsestGrid)

} // namespace tst_coarsestgrid

#include "tst_coarsestgrid.moc"
