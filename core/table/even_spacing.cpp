// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/even_spacing.h"
#include "core/base/portable_math.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <vector>

namespace axiscomp {

namespace {

double position(double start, double distance, std::size_t index)
{
    return start + static_cast<double>(index) * distance;
}

struct Line {
    long double start = 0.0L;
    long double distance = 0.0L;
};

Line leastSquares(std::span<const double> lines)
{
    const auto count = static_cast<long double>(lines.size());
    const long double middle = (count - 1.0L) / 2.0L;
    long double sum = 0.0L;
    long double moment = 0.0L;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        sum += static_cast<long double>(lines[i]);
        moment += (static_cast<long double>(i) - middle) * static_cast<long double>(lines[i]);
    }
    const long double distance = moment / (count * (count * count - 1.0L) / 12.0L);
    return {sum / count - distance * middle, distance};
}

bool liesOn(std::span<const double> lines, double start, double distance, double allowance)
{
    const auto isOff = [&](std::size_t i) {
        return !(std::fabs(lines[i] - position(start, distance, i)) <= allowance);
    };
    // The last position tells most wrong distances at once.
    if (isOff(lines.size() - 1))
        return false;
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (isOff(i))
            return false;
    return true;
}

double withDigits(double number, int digits)
{
    std::array<char, 64> text{};
    const auto written = std::to_chars(
        text.data(), text.data() + text.size(), number, std::chars_format::scientific, digits - 1);
    double rounded = 0.0;
    std::from_chars(text.data(), written.ptr, rounded);
    return rounded;
}

double noiseOf(std::span<const double> lines)
{
    const double largest = std::max(std::fabs(lines.front()), std::fabs(lines.back()));
    return 4.0 * std::numeric_limits<double>::epsilon() * largest;
}

/// The number that a person would give as the distance of positions that are even but for the
/// rounding of doubles: a short one if it serves, otherwise one that gives the very same positions.
double plainDistance(std::span<const double> lines, double start)
{
    constexpr int shortDigits = 10;
    constexpr int allDigits = 17;
    const auto distance = static_cast<double>(leastSquares(lines).distance);
    const auto search = [&](int from, int to, double allowance) {
        for (int digits = from; digits <= to; ++digits) {
            const double candidate = withDigits(distance, digits);
            if (candidate > 0.0 && liesOn(lines, start, candidate, allowance))
                return candidate;
        }
        return 0.0;
    };
    double found = search(1, shortDigits, noiseOf(lines));
    if (found == 0.0)
        found = search(1, allDigits, 0.0);
    if (found == 0.0)
        found = search(shortDigits + 1, allDigits, noiseOf(lines));
    return found == 0.0 ? distance : found;
}

/// A distance that is found again when the positions that it gives are written and read.
double settledDistance(double start, double distance, std::size_t count)
{
    constexpr int rounds = 20; // each makes the number shorter
    std::vector<double> lines(count);
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < count; ++i)
            lines[i] = position(start, distance, i);
        const double next = plainDistance(lines, start);
        if (next == distance)
            break;
        distance = next;
    }
    return distance;
}

/// Whether any line has all positions within tolerance. The least-squares line misses positions of
/// an even grid by up to twice the rounding to the last printed decimal: nearly a third of all such
/// files have one that is off by more than half a unit. The width of the strip that holds all
/// positions is a convex function of its slope.
bool fitsSomeLine(std::span<const double> lines, long double distance, long double tolerance)
{
    const auto strip = [lines](long double slope) {
        long double low = std::numeric_limits<long double>::max();
        long double high = std::numeric_limits<long double>::lowest();
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const long double rest =
                static_cast<long double>(lines[i]) - static_cast<long double>(i) * slope;
            low = std::min(low, rest);
            high = std::max(high, rest);
        }
        return high - low;
    };
    constexpr int steps = 60;
    const long double reach = 4.0L * tolerance / static_cast<long double>(lines.size() - 1);
    long double low = distance - reach;
    long double high = distance + reach;
    for (int step = 0; step < steps; ++step) {
        const long double left = low + (high - low) / 3.0L;
        const long double right = high - (high - low) / 3.0L;
        const long double leftStrip = strip(left);
        const long double rightStrip = strip(right);
        if (std::min(leftStrip, rightStrip) <= 2.0L * tolerance)
            return true;
        (leftStrip < rightStrip ? high : low) = leftStrip < rightStrip ? right : left;
    }
    return false;
}

} // namespace

EvenSpacing fitEvenSpacing(std::span<const double> lines, int lastDecimal)
{
    const Line line = leastSquares(lines);
    const double range = lines.back() - lines.front();
    const double noise = noiseOf(lines);
    const double halfUnit = 0.5 * portable::pow(10.0, lastDecimal);
    const double printed = std::min(halfUnit, 0.01 * static_cast<double>(line.distance));
    EvenSpacing spacing;
    spacing.start = static_cast<double>(line.start);
    spacing.distance = static_cast<double>(line.distance);
    spacing.tolerance = std::max(printed, 1e-9 * range) + noise;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const long double due = line.start + static_cast<long double>(i) * line.distance;
        const auto deviation =
            static_cast<double>(std::fabs(static_cast<long double>(lines[i]) - due));
        if (deviation > spacing.deviation) {
            spacing.deviation = deviation;
            spacing.worst = i;
        }
    }
    spacing.even = spacing.deviation <= spacing.tolerance
        || (printed == halfUnit && spacing.deviation <= 2.0 * spacing.tolerance
            && fitsSomeLine(lines, line.distance, static_cast<long double>(halfUnit + noise)));
    spacing.rounded = spacing.even && spacing.deviation > 1e-9 * range + noise;
    if (spacing.deviation <= noise) {
        spacing.start = lines.front();
        spacing.distance = plainDistance(lines, spacing.start);
    }
    if (spacing.even)
        spacing.distance = settledDistance(spacing.start, spacing.distance, lines.size());
    return spacing;
}

} // namespace axiscomp
