// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/grid_lines.h"

#include "core/base/portable_math.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

namespace axiscomp::csv {

namespace {

constexpr double sameLine = 1e-9; ///< of the range

/// As a whole number that is larger for a larger double.
std::uint64_t ordinal(double value)
{
    constexpr std::uint64_t sign = std::uint64_t{1} << 63U;
    const auto bits = std::bit_cast<std::uint64_t>(value);
    return (bits & sign) != 0 ? ~bits : bits | sign;
}

/// By one byte after the other, from the lowest; bytes that are the same in all values are left
/// out. std::sort takes four times as long for a million positions.
void sortByBytes(std::vector<SortedPositions::Place>& places)
{
    constexpr std::size_t bytes = sizeof(double);
    std::array<std::array<std::uint32_t, 256>, bytes> counts{};
    for (const SortedPositions::Place& place : places)
        for (std::size_t byte = 0; byte < bytes; ++byte)
            ++counts[byte][(ordinal(place.value) >> (8 * byte)) & 0xFFU];
    std::vector<SortedPositions::Place> other(places.size());
    for (std::size_t byte = 0; byte < bytes; ++byte) {
        std::array<std::uint32_t, 256>& starts = counts[byte];
        if (std::ranges::find(starts, places.size()) != starts.end())
            continue;
        std::exclusive_scan(starts.begin(), starts.end(), starts.begin(), 0U);
        for (const SortedPositions::Place& place : places)
            other[starts[(ordinal(place.value) >> (8 * byte)) & 0xFFU]++] = place;
        std::swap(places, other);
    }
}

/// How far the positions are off an even line, measured ones on both sides of a grid line included.
/// None: further than the limit, or it cannot be told from an uneven one.
std::optional<EvenSpacing> held(const GridLines& lines, double start, double distance, double limit)
{
    EvenSpacing worst;
    std::vector<double> even(lines.positions.size());
    for (std::size_t i = 0; i < even.size(); ++i) {
        even[i] = start + static_cast<double>(i) * distance;
        const double shift = std::fabs(lines.positions[i] - even[i]) + lines.reach[i];
        // Before anything that takes long: most lines are off at one of their first positions.
        if (!(shift <= limit))
            return std::nullopt;
        if (shift > worst.deviation) {
            worst.deviation = shift;
            worst.worst = i;
        }
    }
    EvenSpacing spacing = fitEvenSpacing(even, noDecimals);
    spacing.deviation = worst.deviation;
    spacing.worst = worst.worst;
    return spacing.even ? std::optional(spacing) : std::nullopt;
}

} // namespace

SortedPositions::SortedPositions(std::vector<Place> places) : m_places(std::move(places))
{
    if (!std::ranges::is_sorted(m_places, {}, &Place::value))
        sortByBytes(m_places);
}

GridLines gridLines(const SortedPositions& sorted, double snap)
{
    const std::vector<SortedPositions::Place>& places = sorted.places();
    const long double range = static_cast<long double>(places.back().value)
        - static_cast<long double>(places.front().value);
    const long double closest =
        std::max(static_cast<long double>(sameLine) * range, 2.0L * static_cast<long double>(snap));
    GridLines lines;
    lines.lineOf.resize(places.size());
    double before = 0.0;
    for (const auto& [value, id] : places) {
        const double next = value + 0.0; // no negative zero
        const long double gap = static_cast<long double>(next) - static_cast<long double>(before);
        if (lines.positions.empty() || (gap > 0.0L && gap >= closest)) {
            lines.positions.push_back(next);
            lines.reach.push_back(next);
        }
        lines.lineOf[id] = static_cast<std::uint32_t>(lines.positions.size() - 1);
        if (snap > 0.0) {
            before = lines.reach.back() = next;
        } else {
            before = lines.positions.back();
        }
    }
    for (std::size_t i = 0; i < lines.positions.size(); ++i) {
        const double last = lines.reach[i];
        lines.reach[i] = 0.5 * (last - lines.positions[i]);
        lines.positions[i] += lines.reach[i];
    }
    return lines;
}

std::optional<EvenSpacing> spacingWithin(const GridLines& lines, double tolerance)
{
    const double limit = tolerance * (1.0 + 1e-9);
    const double range = lines.positions.back() - lines.positions.front();
    const auto steps = static_cast<double>(lines.positions.size() - 1);
    constexpr int digits = 12;
    const int coarsest = static_cast<int>(std::ceil(portable::log10(range)));
    for (int decimal = coarsest; decimal > coarsest - digits; --decimal) {
        const double unit = portable::pow(10.0, std::abs(decimal));
        const auto rounded = [&](double position) {
            return decimal > 0 ? std::round(position / unit) * unit
                               : std::round(position * unit) / unit;
        };
        const double start = rounded(lines.positions.front());
        const double distance = (rounded(lines.positions.back()) - start) / steps;
        if (!(distance > 0.0))
            continue;
        if (const auto spacing = held(lines, start, distance, limit))
            return spacing;
    }
    const EvenSpacing line = fitEvenSpacing(lines.positions, noDecimals);
    return held(lines, line.start, line.distance, limit);
}

double suggestedSnap(const SortedPositions& sorted, bool mayMerge)
{
    constexpr double mostOfGap = 0.1;
    constexpr double mostOfDistance = 0.02;
    const std::vector<SortedPositions::Place>& places = sorted.places();
    double largestGap = 0.0;
    for (std::size_t i = 1; i < places.size(); ++i)
        largestGap = std::max(largestGap, places[i].value - places[i - 1].value);
    const GridLines lines = gridLines(sorted, 0.5 * mostOfGap * largestGap);
    const bool isMerged = lines.positions.size() < places.size();
    if (lines.positions.size() < 3 || !std::isfinite(largestGap) || (isMerged && !mayMerge))
        return 0.0;
    const double distance = (lines.positions.back() - lines.positions.front())
        / static_cast<double>(lines.positions.size() - 1);
    const auto spacing = spacingWithin(lines, mostOfDistance * distance);
    if (!spacing || !(spacing->deviation > 0.0))
        return 0.0;
    const double unit = portable::pow(10.0, std::floor(portable::log10(spacing->deviation)));
    return std::ceil(spacing->deviation / unit * (1.0 - 1e-9)) * unit;
}

} // namespace axiscomp::csv
