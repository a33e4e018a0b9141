// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/judge/iso230.h"
#include "core/metrology/run_selection.h"
#include "tests/core/metrology/measurement_reading.h"
#include "tests/support/test_registry.h"

#include <cmath>
#include <map>
#include <random>

namespace tst_iso230 {

using namespace axiscomp;
using Figure = Iso230Figure;

namespace {

/// Published values of public measurements, in mm (B Bm M E+ E- E R+ R- R A+ A- A); the tool of the
/// publisher takes other E and R, these are worked out by the formulas of the standard.
struct PublicSet {
    const char* file;
    std::array<double, iso230FigureCount> figures;
};
const std::array publicSets{
    PublicSet{"bifrost.csv",
        {0.0045640, 0.0006956, 0.0149520, 0.0150520, 0.0148520, 0.0159880, 0.0075024, 0.0038825,
            0.0083539, 0.0180654, 0.0165425, 0.0185713}},
    PublicSet{"b02_x.csv",
        {0.0335757, 0.0253683, 0.0936527, 0.0906452, 0.0980339, 0.1228472, 0.0283114, 0.0193653,
            0.0551606, 0.1084219, 0.1114976, 0.1352711}},
    PublicSet{"b02_y.csv",
        {0.0200201, 0.0127680, 0.0842648, 0.0884967, 0.0800329, 0.1000530, 0.0325448, 0.0380745,
            0.0468660, 0.1113957, 0.1040004, 0.1257168}},
    PublicSet{"ess_mcu1025.csv",
        {0.0434594, 0.0071849, 0.0480935, 0.0747720, 0.0461161, 0.0747720, 0.0182970, 0.2047595,
            0.2047595, 0.0892653, 0.2047595, 0.2047595}},
};
constexpr double tolerance = 1e-6;

Measurement measurementOf(const char* file)
{
    return test::readAs("runs", test::publicMeasurement(file)).measurement.value_or(Measurement{});
}

double value(const Iso230Figures& figures, Figure figure)
{
    return figures[figure].value.value_or(std::nan(""));
}

/// Targets at 0, 1, 2 ...; each row: the values up, then those down.
Measurement measured(const std::vector<std::array<std::vector<double>, 2>>& rows)
{
    Measurement measurement;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        measurement.targets.push_back(static_cast<double>(i));
        for (const Approach direction : {Approach::Up, Approach::Down}) {
            int run = 0;
            for (const double deviation : rows[i][static_cast<std::size_t>(direction)]) {
                RunValue one;
                one.target = i;
                one.direction = direction;
                one.run = ++run;
                one.deviation = deviation;
                measurement.values.push_back(one);
            }
        }
    }
    sortValues(measurement.values);
    return measurement;
}

Measurement randomMeasurement(std::mt19937& random)
{
    std::uniform_int_distribution<int> targets(2, 12);
    std::uniform_int_distribution<int> runs(2, 6);
    std::normal_distribution<double> normal;
    const double systematic = std::exp(2.0 * normal(random));
    const double reversal = normal(random);
    const int up = runs(random);
    const int down = runs(random);
    std::vector<std::array<std::vector<double>, 2>> rows(static_cast<std::size_t>(targets(random)));
    for (auto& row : rows) {
        const double mean = systematic * normal(random);
        for (int j = 0; j < up; ++j)
            row[0].push_back(mean + reversal + normal(random));
        for (int j = 0; j < down; ++j)
            row[1].push_back(mean - reversal + normal(random));
    }
    return measured(rows);
}

} // namespace

class tst_Iso230 : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void publicMeasurementsHaveTheFiguresOfTheStandard()
    {
        for (const PublicSet& set : publicSets) {
            const Iso230Figures figures = iso230Figures(measurementOf(set.file));
            for (const Figure figure : allIso230Figures()) {
                const double expected = set.figures[static_cast<std::size_t>(figure)];
                QVERIFY2(std::abs(value(figures, figure) - expected) <= tolerance,
                    (std::string(set.file) + " " + std::string(figureName(figure)) + " "
                        + std::to_string(value(figures, figure)))
                        .c_str());
            }
        }
    }

    void inequalitiesHoldForRandomMeasurements()
    {
        std::mt19937 random(20000);
        for (int n = 0; n < 20000; ++n) {
            const Iso230Figures figures = iso230Figures(randomMeasurement(random));
            std::map<Figure, double> f;
            for (const Figure figure : allIso230Figures())
                f[figure] = value(figures, figure);
            constexpr double slack = 1e-12;
            const auto atLeast = [&](Figure larger, Figure smaller) {
                return f[larger] + slack * f[larger] >= f[smaller];
            };
            for (const Figure smaller : {Figure::EUp, Figure::EDown, Figure::M})
                QVERIFY(atLeast(Figure::E, smaller));
            for (const Figure smaller : {Figure::AUp, Figure::ADown, Figure::E, Figure::R})
                QVERIFY(atLeast(Figure::A, smaller));
            for (const Figure smaller : {Figure::RUp, Figure::RDown, Figure::B})
                QVERIFY(atLeast(Figure::R, smaller));
            QVERIFY(f[Figure::E] <= (f[Figure::M] + f[Figure::B]) * (1.0 + slack));
            QVERIFY(std::abs(f[Figure::MeanReversal]) <= f[Figure::B] * (1.0 + slack));
        }
    }

    void aConstantAddedChangesNothing()
    {
        std::mt19937 random(1);
        for (int n = 0; n < 500; ++n) {
            Measurement measurement = randomMeasurement(random);
            const Iso230Figures before = iso230Figures(measurement);
            for (RunValue& one : measurement.values)
                one.deviation += 1000.0;
            const Iso230Figures after = iso230Figures(measurement);
            for (const Figure figure : allIso230Figures())
                QVERIFY(std::abs(value(after, figure) - value(before, figure)) < 1e-10);
        }
    }

    void aFactorScalesEveryFigure()
    {
        std::mt19937 random(2);
        for (int n = 0; n < 500; ++n) {
            Measurement measurement = randomMeasurement(random);
            const Iso230Figures before = iso230Figures(measurement);
            for (RunValue& one : measurement.values)
                one.deviation *= 8.0; // exact
            const Iso230Figures after = iso230Figures(measurement);
            for (const Figure figure : allIso230Figures())
                QVERIFY(std::abs(value(after, figure) - 8.0 * value(before, figure)) < 1e-12);
        }
    }

    void exchangingDirectionsChangesTheSignOfTheReversalOnly()
    {
        std::mt19937 random(3);
        const std::map<Figure, Figure> exchanged{{Figure::EUp, Figure::EDown},
            {Figure::EDown, Figure::EUp}, {Figure::RUp, Figure::RDown},
            {Figure::RDown, Figure::RUp}, {Figure::AUp, Figure::ADown},
            {Figure::ADown, Figure::AUp}};
        for (int n = 0; n < 500; ++n) {
            Measurement measurement = randomMeasurement(random);
            const Iso230Figures before = iso230Figures(measurement);
            swapDirections(measurement);
            const Iso230Figures after = iso230Figures(measurement);
            for (const Figure figure : allIso230Figures()) {
                const auto other = exchanged.find(figure);
                const double expected =
                    value(before, other == exchanged.end() ? figure : other->second);
                QCOMPARE(
                    value(after, figure), figure == Figure::MeanReversal ? -expected : expected);
            }
        }
    }

    void aSingleValueAnywhereLeavesTheSpreadUndefined()
    {
        const Iso230Figures figures =
            iso230Figures(measured({{{{1.0, 2.0}, {0.0, 1.0}}}, {{{4.0}, {3.0, 5.0}}}}));
        QCOMPARE(figures.targets[1].up.mean, std::optional(4.0));
        QVERIFY(!figures.targets[1].up.s);
        for (const Figure undefined : {Figure::RUp, Figure::R, Figure::AUp, Figure::A})
            QVERIFY2(!figures[undefined].value, figureName(undefined).data());
        // By hand: means 1.5 | 0.5 and 4 | 4; s down 0.7071 and 1.4142.
        QCOMPARE(value(figures, Figure::B), 1.0);
        QCOMPARE(value(figures, Figure::MeanReversal), 0.5);
        QCOMPARE(value(figures, Figure::M), 3.0);
        QCOMPARE(value(figures, Figure::E), 3.5);
        QCOMPARE(value(figures, Figure::RDown), 4.0 * std::sqrt(2.0));
    }

    void oneDirectionAloneHasNoBidirectionalFigures()
    {
        const Iso230Figures figures =
            iso230Figures(measured({{{{1.0, 2.0}, {}}}, {{{4.0, 4.0}, {}}}}));
        for (const Figure undefined : {Figure::B, Figure::MeanReversal, Figure::M, Figure::E,
                 Figure::R, Figure::A, Figure::EDown, Figure::RDown, Figure::ADown})
            QVERIFY2(!figures[undefined].value, figureName(undefined).data());
        QCOMPARE(value(figures, Figure::EUp), 2.5);
        QCOMPARE(value(figures, Figure::RUp), 4.0 * std::sqrt(0.5));
        QCOMPARE(value(figures, Figure::AUp), 4.0 - (1.5 - 2.0 * std::sqrt(0.5)));
    }

    void thoseOfOneDirectionStandForTheFiguresOfBoth()
    {
        const std::vector<double> values{1.0, 2.0};
        const auto up = iso230Figures(measured({{{values, {}}}, {{values, {}}}}));
        QCOMPARE(figureStandingFor(Figure::A, up), Figure::AUp);
        QCOMPARE(figureStandingFor(Figure::R, up), Figure::RUp);
        QCOMPARE(figureStandingFor(Figure::E, up), Figure::EUp);
        QCOMPARE(figureStandingFor(Figure::M, up), Figure::EUp);
        QCOMPARE(figureStandingFor(Figure::B, up), Figure::B);
        QCOMPARE(figuresInShort(up), (std::vector{Figure::AUp, Figure::RUp, Figure::EUp}));
        const auto down = iso230Figures(measured({{{{}, values}}, {{{}, values}}}));
        QCOMPARE(figureStandingFor(Figure::M, down), Figure::EDown);
        QCOMPARE(figuresInShort(down), (std::vector{Figure::ADown, Figure::RDown, Figure::EDown}));
        // A direction that lacks a target is there all the same.
        const auto both = iso230Figures(measured({{{values, values}}, {{values, {}}}}));
        QCOMPARE(figureStandingFor(Figure::M, both), Figure::M);
        QCOMPARE(figuresInShort(both),
            (std::vector{Figure::A, Figure::R, Figure::E, Figure::B, Figure::M}));
        QCOMPARE(figureStandingFor(Figure::M, {}), Figure::M);
    }

    void aDirectionThatLacksATargetIsNotDefined()
    {
        const Iso230Figures figures = iso230Figures(
            measured({{{{1.0, 2.0}, {1.0, 2.0}}}, {{{4.0, 4.0}, {}}}, {{{0.0, 0.0}, {1.0, 1.0}}}}));
        QVERIFY(!figures[Figure::EDown].value);
        QVERIFY(!figures[Figure::E].value);
        QCOMPARE(value(figures, Figure::EUp), 4.0);
    }

    void theMeanAtATargetIsThatOfTheDirectionsThatItHas()
    {
        const Iso230Figures figures = iso230Figures(
            measured({{{{1.0, 3.0}, {3.0, 5.0}}}, {{{4.0, 6.0}, {}}}, {{{}, {7.0, 7.0}}}}));
        QCOMPARE(meanInUse(figures.targets[0]), std::optional(3.0));
        QCOMPARE(meanInUse(figures.targets[1]), std::optional(5.0));
        QCOMPARE(meanInUse(figures.targets[2]), std::optional(7.0));
        QVERIFY(!meanInUse({}));
    }

    void excludedValuesAreLeftOut()
    {
        Measurement measurement = measurementOf("ess_mcu1025.csv");
        const auto exclusions = exclusionsFromText("down:1:1,down:2:1");
        VERIFY_RESULT(exclusions);
        VERIFY_RESULT(exclude(measurement, *exclusions));
        QCOMPARE(measurement.excludedCount(), std::size_t{2});
        const Iso230Figures figures = iso230Figures(measurement);
        QVERIFY(std::abs(value(figures, Figure::A) - 0.0892653) <= tolerance);
        QVERIFY(std::abs(value(figures, Figure::R) - 0.0582781) <= tolerance);
    }

    void anExcludedTargetIsGone()
    {
        Measurement measurement = measured(
            {{{{1.0, 1.0}, {1.0, 1.0}}}, {{{9.0, 9.0}, {9.0, 9.0}}}, {{{2.0, 2.0}, {2.0, 2.0}}}});
        const Exclusion second{{}, 2, {}};
        VERIFY_RESULT(exclude(measurement, std::span(&second, 1)));
        const Iso230Figures figures = iso230Figures(measurement);
        QCOMPARE(figures.targets.size(), std::size_t{2});
        QCOMPARE(figures.targets[1].target, std::size_t{2});
        QCOMPARE(value(figures, Figure::E), 1.0);
    }

    void eachFigureNamesItsTargets()
    {
        const Iso230Figures figures = iso230Figures(measured({{{{0.0, 0.0}, {1.0, 1.0}}},
            {{{5.0, 7.0}, {5.0, 5.0}}}, {{{-3.0, -3.0}, {1.0, 1.0}}}}));
        QCOMPARE(figures[Figure::B].high, std::size_t{2});
        QCOMPARE(figures[Figure::RUp].high, std::size_t{1});
        QCOMPARE(figures[Figure::E].high, std::size_t{1});
        QCOMPARE(figures[Figure::E].low, std::size_t{2});
    }

    void figuresAreKnownByTheirNames()
    {
        QCOMPARE(figureNamed("eup"), std::optional(Figure::EUp));
        QCOMPARE(figureNamed("R-"), std::optional(Figure::RDown));
        QCOMPARE(figureNamed("Bm"), std::optional(Figure::MeanReversal));
        QVERIFY(!figureNamed("F"));
    }
};

AXISCOMP_TEST(tst_Iso230)

} // namespace tst_iso230

#include "tst_iso230.moc"
