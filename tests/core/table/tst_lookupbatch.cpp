// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/lookup.h"
#include "tests/core/table/lookup_reference.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <span>

namespace tst_lookupbatch {

using namespace axiscomp;
using namespace axiscomp::test;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::array outsideModes{
    Outside::Hold, Outside::Zero, Outside::Wrap, Outside::Extrapolate, Outside::Error};
constexpr std::array modeNames{"hold", "zero", "wrap", "extrapolate", "error"};
constexpr std::array instructionSets{
    InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512};
constexpr std::array setNames{"baseline", "AVX2", "AVX-512"};

/// Rows "dimensions", "outside" and "instructions" for every combination.
void addCombinations()
{
    QTest::addColumn<int>("dimensions");
    QTest::addColumn<Outside>("outside");
    QTest::addColumn<InstructionSet>("instructions");
    for (int dimensions = 1; dimensions <= 3; ++dimensions)
        for (std::size_t i = 0; i < outsideModes.size(); ++i)
            for (std::size_t n = 0; n < instructionSets.size(); ++n)
                QTest::addRow("%dD %s %s", dimensions, modeNames[i], setNames[n])
                    << dimensions << outsideModes[i] << instructionSets[n];
}

/// The same bits; whichever NaN.
bool isSame(double a, double b)
{
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b)
        || (std::isnan(a) && std::isnan(b));
}

/// Compares each of them with the single lookup. The values have a frame that must stay.
void verifyBatch(
    const Lookup& lookup, const std::vector<double>& positions, InstructionSet instructions)
{
    constexpr double frame = 12345.0;
    const auto dimensions = static_cast<std::size_t>(lookup.dimensions());
    const std::size_t count = positions.size() / dimensions;
    std::vector<double> values(count + 2, frame);
    lookup.atEach(positions, std::span(values).subspan(1, count), instructions);
    for (std::size_t i = 0; i < count; ++i) {
        const double due = lookup.at(std::span(positions).subspan(i * dimensions, dimensions));
        QVERIFY2(isSame(values[i + 1], due),
            qPrintable(QStringLiteral("%1 of %2: %3 instead of %4")
                           .arg(i)
                           .arg(count)
                           .arg(values[i + 1], 0, 'g', 17)
                           .arg(due, 0, 'g', 17)));
    }
    QVERIFY(values.front() == frame && values.back() == frame);
}

/// Grids of any size and distance, whose values differ in magnitude.
CompensationTable anyTable(int dimensions, std::mt19937& random)
{
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    Grid grid;
    for (int n = 0; n < dimensions; ++n)
        grid.axes.push_back({{}, {}, between(-1e4, 1e4), std::pow(10.0, between(-5.0, 3.0)),
            static_cast<std::uint32_t>(2 + random() % 30)});
    CompensationTable table = randomTable(grid, static_cast<unsigned>(random()));
    for (float& value : table.values)
        value *= static_cast<float>(std::pow(10.0, between(-6.0, 6.0)));
    return table;
}

/// Mostly within the table; at grid points, at the ends and beside them, outside, and none.
double anyPosition(const GridAxis& axis, std::mt19937& random)
{
    const double stroke = axis.last() - axis.start;
    std::uniform_real_distribution<double> within(axis.start, axis.last());
    std::uniform_real_distribution<double> around(axis.start - stroke, axis.last() + stroke);
    switch (random() % 16) {
    case 0:
        return axis.start;
    case 1:
        return axis.last();
    case 2:
        return std::nextafter(axis.start, random() % 2 == 0 ? infinity : -infinity);
    case 3:
        return std::nextafter(axis.last(), random() % 2 == 0 ? infinity : -infinity);
    case 4:
        return axis.position(random() % axis.size);
    case 5:
        return std::nextafter(
            axis.position(random() % axis.size), random() % 2 == 0 ? infinity : -infinity);
    case 6:
        return around(random);
    case 7: {
        constexpr std::array extremes{infinity, -infinity, notANumber, 1e300, -1e300, 0.0, -0.0};
        return extremes[random() % extremes.size()];
    }
    default:
        return within(random);
    }
}

#ifdef __x86_64__
/// As a caller that is compiled for such a processor has them.
[[gnu::target("avx2,fma")]] double withFusedOperations(
    const Lookup& lookup, std::span<const double, 3> position)
{
    return lookup.at(position[0], position[1], position[2]);
}
#endif

} // namespace

class TestLookupBatch : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { axiscomp::test::failOnWarnings(); }

    void aBatchAnswersWhatSingleLookupsDo_data() { addCombinations(); }
    void aBatchAnswersWhatSingleLookupsDo()
    {
        QFETCH(int, dimensions);
        QFETCH(Outside, outside);
        QFETCH(InstructionSet, instructions);
        if (!isSupported(instructions))
            QSKIP("this processor does not have these instructions");
        std::mt19937 random(23); // NOLINT: the same tables every time
        for (int round = 0; round < 60; ++round) {
            const CompensationTable table = anyTable(dimensions, random);
            const Lookup lookup(table, outside);
            std::vector<double> positions;
            for (std::size_t i = 0; i < 64 * (random() % 4) + random() % 64; ++i)
                for (const GridAxis& axis : table.grid.axes)
                    positions.push_back(anyPosition(axis, random));
            verifyBatch(lookup, positions, instructions);
        }
    }

    void aBatchMayHaveAnyNumberOfPositions_data() { addCombinations(); }
    void aBatchMayHaveAnyNumberOfPositions()
    {
        QFETCH(int, dimensions);
        QFETCH(Outside, outside);
        QFETCH(InstructionSet, instructions);
        if (!isSupported(instructions))
            QSKIP("this processor does not have these instructions");
        // values in a block of exactly their size: the sanitizers see any other read
        const CompensationTable table = randomTable(awkwardGrid(dimensions));
        const Lookup lookup(table, outside);
        std::mt19937 random(29); // NOLINT
        for (std::size_t count = 0; count < 200; ++count) {
            std::vector<double> positions;
            for (std::size_t i = 0; i < count; ++i)
                for (const GridAxis& axis : table.grid.axes)
                    positions.push_back(anyPosition(axis, random));
            verifyBatch(lookup, positions, instructions);
        }
    }

    void theEndsOfAllDimensionsAreAnswered_data() { addCombinations(); }
    void theEndsOfAllDimensionsAreAnswered()
    {
        QFETCH(int, dimensions);
        QFETCH(Outside, outside);
        QFETCH(InstructionSet, instructions);
        if (!isSupported(instructions))
            QSKIP("this processor does not have these instructions");
        Grid smallest;
        for (int n = 0; n < dimensions; ++n)
            smallest.axes.push_back({{}, {}, -1.0, 2.0, 2});
        const CompensationTable table = randomTable(smallest);
        const Lookup lookup(table, outside);
        constexpr std::array places{-2.0, -1.0, 0.25, 1.0, 2.0, notANumber};
        std::vector<double> positions;
        for (const double x : places)
            for (const double y : places)
                for (const double z : places)
                    for (int n = 0; n < dimensions; ++n)
                        positions.push_back(std::array{x, y, z}[static_cast<std::size_t>(n)]);
        verifyBatch(lookup, positions, instructions);
    }

    /// The lookup is inline: its bits are those of whoever is compiled with it.
    void fusedOperationsOfTheCallerChangeNoBit()
    {
#ifdef __x86_64__
        if (__builtin_cpu_supports("fma") == 0)
            QSKIP("this processor does not have these instructions");
        const CompensationTable table = randomTable(awkwardGrid(3));
        const Lookup lookup(table);
        std::mt19937 random(37); // NOLINT
        for (int i = 0; i < 1000; ++i) {
            std::array<double, 3> position{};
            for (std::size_t n = 0; n < position.size(); ++n)
                position[n] = anyPosition(table.grid.axes[n], random);
            QVERIFY(isSame(withFusedOperations(lookup, position),
                lookup.at(std::span<const double>(position))));
        }
#else
        QSKIP("other processors");
#endif
    }

    void theBestInstructionsAreThereAndAnswerTheSame()
    {
        QVERIFY(isSupported(InstructionSet::Baseline));
        QVERIFY(isSupported(bestInstructionSet()));
        const CompensationTable table = randomTable(awkwardGrid(3));
        const Lookup lookup(table);
        std::mt19937 random(31); // NOLINT
        std::vector<double> positions(3 * 1000);
        for (std::size_t i = 0; i < positions.size(); ++i)
            positions[i] = anyPosition(table.grid.axes[i % 3], random);
        std::vector<double> best(1000);
        std::vector<double> baseline(1000);
        lookup.atEach(positions, best);
        lookup.atEach(positions, baseline, InstructionSet::Baseline);
        for (std::size_t i = 0; i < best.size(); ++i)
            QVERIFY(isSame(best[i], baseline[i]));
    }
};

AXISCOMP_TEST(TestLookupBatch)

} // namespace tst_lookupbatch

#include "tst_lookupbatch.moc"
