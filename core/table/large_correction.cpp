// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/large_correction.h"

#include "core/table/position_unit.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>

namespace axiscomp {

namespace {

constexpr double largestShare = 0.01;
constexpr double largestSlope = 0.1;
/// What rounding to float32 may add to a value that is just allowed.
constexpr double roundingAllowance = 1.0 + 1e-6;

std::string fourDigits(double value)
{
    if (value >= 1000.0)
        return roundedText(std::round(value));
    char digits[32];
    const auto end =
        std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, 4).ptr;
    return {digits, end};
}

/// How much of the positions' unit one of the values' is; none: they cannot be compared.
std::optional<double> valueInPositions(const CompensationTable& table, const GridAxis& axis)
{
    if (table.unit.empty() || axis.unit.empty() || isSameUnit(table.unit, axis.unit))
        return 1.0;
    return unitFactor(table.unit, axis.unit);
}

using FourValues = float __attribute__((vector_size(16)));

template <typename Number> Number valuesAt(const float* values)
{
    Number number{};
    std::memcpy(&number, values, sizeof number);
    return number;
}

/// The largest |number| of numbersAt(Number(), i), i from 0 to count - 1; 0 for none, and a NaN is
/// left out. Number is float, or FourValues: those of i to i + 3. Eight at a time, which do not
/// wait for each other.
template <typename NumbersAt> float largestSize(std::size_t count, const NumbersAt& numbersAt)
{
    constexpr std::size_t width = 4;
    std::array<FourValues, 2> highest{};
    std::array<FourValues, 2> lowest{};
    std::size_t i = 0;
    for (; i + 2 * width <= count; i += 2 * width)
        for (std::size_t k = 0; k < 2; ++k) {
            const FourValues numbers = numbersAt(FourValues{}, i + width * k);
            highest[k] = numbers > highest[k] ? numbers : highest[k];
            lowest[k] = numbers < lowest[k] ? numbers : lowest[k];
        }
    float largest = 0.0F;
    for (std::size_t k = 0; k < 2; ++k)
        for (std::size_t n = 0; n < width; ++n)
            largest = std::max({largest, highest[k][n], -lowest[k][n]});
    for (; i < count; ++i)
        largest = std::max(largest, std::fabs(numbersAt(0.0F, i)));
    return largest;
}

/// The largest |step| between each of `count` values and the one a stride behind it.
float largestStep(const float* values, std::size_t stride, std::size_t count)
{
    return largestSize(count, [=](auto number, std::size_t i) {
        using Number = decltype(number);
        return valuesAt<Number>(values + i + stride) - valuesAt<Number>(values + i);
    });
}

/// The steepest step in one dimension. The runs of neighbouring values are compared as a whole,
/// because most tables have no step worth finding.
SteepestStep steepestAlong(
    const CompensationTable& table, std::size_t dimension, std::size_t stride, double factor)
{
    const std::vector<float>& values = table.values;
    const GridAxis& axis = table.grid.axes[dimension];
    const std::size_t run = stride * axis.size;
    SteepestStep steepest{0.0, 0, 0, dimension};
    float largest = 0.0F;
    for (std::size_t begin = 0; begin < values.size(); begin += run) {
        const std::size_t end = begin + run - stride;
        const float here = largestStep(values.data() + begin, stride, run - stride);
        if (!(here > largest))
            continue;
        largest = here;
        for (std::size_t i = begin; i < end; ++i)
            if (std::fabs(values[i + stride] - values[i]) == largest)
                steepest.from = i;
        steepest.to = steepest.from + stride;
    }
    const double difference =
        static_cast<double>(values[steepest.to]) - static_cast<double>(values[steepest.from]);
    steepest.slope = std::fabs(difference) * factor / axis.distance;
    return steepest;
}

float largestValue(const CompensationTable& table)
{
    return largestSize(
        table.values.size(), [values = table.values.data()](auto number, std::size_t i) {
            return valuesAt<decltype(number)>(values + i);
        });
}

Text slopeText(const CompensationTable& table, const SteepestStep& step)
{
    const Grid& grid = table.grid;
    const std::string& unit = grid.axes[step.dimension].unit;
    const auto place = [&](std::size_t element) {
        return Quantity{roundedText(positionOf(grid, element)[step.dimension]), unit};
    };
    return AXISCOMP_TEXT("Error",
        "The correction has a slope of {slope} along dimension {number}, between {first} and "
        "{last}.")
        .with("slope", Quantity{fourDigits(step.slope), {}})
        .with("number", step.dimension + 1)
        .with("first", place(step.from))
        .with("last", place(step.to));
}

} // namespace

SteepestStep steepestStep(const CompensationTable& table)
{
    SteepestStep steepest;
    std::size_t stride = 1;
    for (std::size_t n = 0; n < table.grid.axes.size(); ++n) {
        const GridAxis& axis = table.grid.axes[n];
        if (const auto factor = valueInPositions(table, axis)) {
            const SteepestStep step = steepestAlong(table, n, stride, *factor);
            if (step.slope > steepest.slope)
                steepest = step;
        }
        stride *= axis.size;
    }
    return steepest;
}

std::vector<Text> largeCorrections(const CompensationTable& table)
{
    std::vector<Text> sentences;
    const float largest = largestValue(table);
    for (std::size_t n = 0; n < table.grid.axes.size(); ++n) {
        const GridAxis& axis = table.grid.axes[n];
        const auto factor = valueInPositions(table, axis);
        const double range = axis.last() - axis.start;
        const double share = factor ? static_cast<double>(largest) * *factor / range : 0.0;
        if (share > largestShare * roundingAllowance)
            sentences.push_back(AXISCOMP_TEXT("Error",
                "The largest correction, {largest}, is {percent} of the range of dimension "
                "{number}, {range}.")
                                    .with("largest", Quantity{toText(largest), table.unit})
                                    .with("percent", Quantity{fourDigits(100.0 * share), "%"})
                                    .with("number", n + 1)
                                    .with("range", Quantity{roundedText(range), axis.unit}));
    }
    if (const SteepestStep step = steepestStep(table);
        step.slope > largestSlope * roundingAllowance)
        sentences.push_back(slopeText(table, step));
    return sentences;
}

} // namespace axiscomp
