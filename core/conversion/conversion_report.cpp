// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/conversion.h"
#include "core/formats/units.h"
#include "core/neutral/table_motion.h"
#include "core/table/compensation_table.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <cmath>

namespace axiscomp {

namespace {

/// An amount that nobody needs exactly: "0.0333 um".
Quantity amountOf(double amount, const std::string& unit)
{
    constexpr int digits = 3;
    return {significantText(amount, digits), unit};
}

/// What is left of numbers that are the same but for the rounding of doubles.
bool isNoise(double difference, const CompensationColumn& column)
{
    const TableStatistics values = statisticsOf(column.values);
    return difference <= 1e-12 * std::max(std::abs(values.minimum), std::abs(values.maximum));
}

/// Every number of a controller that computes with float32 is rounded like that.
bool isFloatRounding(double rounding, const CompensationColumn& column, const TableFormat& target)
{
    const TableStatistics values = statisticsOf(column.values);
    const double largest = std::max(std::abs(values.minimum), std::abs(values.maximum));
    return rounding <= (target.facts.behaviour.usesFloat ? 1e-7 : 1e-12) * largest;
}

Text formatSign(const TableFormat& format, std::optional<SignConvention> overruled)
{
    constexpr TextPattern known[] = {AXISCOMP_TEXT("Error", "{format} holds feedback values"),
        AXISCOMP_TEXT("Error", "{format} holds command values")};
    constexpr TextPattern said[] = {
        AXISCOMP_TEXT("Error", "{format} holds feedback values, as you say"),
        AXISCOMP_TEXT("Error", "{format} holds command values, as you say")};
    const auto sign = static_cast<std::size_t>(overruled.value_or(format.facts.sign));
    return (overruled ? said : known)[sign].with("format", format.facts.name);
}

Text signLine(const ConversionRequest& request, const Text& example)
{
    const bool hasTarget = request.from != request.to || request.targetSign;
    return (hasTarget ? AXISCOMP_TEXT("Error", "sign: {from}, {to}; {example}")
                      : AXISCOMP_TEXT("Error", "sign: {from}; {example}"))
        .with("from", formatSign(*request.from, request.sourceSign))
        .with("to", formatSign(*request.to, request.targetSign))
        .with("example", example);
}

Text resamplingLine(const TableConversion& table, std::size_t column)
{
    const ResamplingReport& report = *table.resampling;
    const ColumnDeviation& deviation = report.columns[column];
    const std::string& unit = table.source.columns[column].unit;
    return AXISCOMP_TEXT("Error",
        "resampled from {before} points to {after} points: at the positions of the source it is "
        "off by at most {largest}, {rms} rms")
        .with("before", sizeText(knotCounts(table.source)))
        .with("after", sizeText(knotCounts(table.result)))
        .with("largest", amountOf(deviation.largest, unit))
        .with("rms", amountOf(deviation.rms, unit));
}

/// Of a table that follows a curve, along one axis.
Text densityLine(const TableConversion& table, std::size_t column,
    const ColumnDeviation::Density& density, std::optional<double> speed)
{
    const std::string& unit = table.source.columns[column].unit;
    const std::string& position = table.source.axes[density.axis].unit;
    return (speed ? AXISCOMP_TEXT("Error",
                "along {axis}, {points} points: at most {distance} from the curve; at a point its "
                "slope changes by up to {slope}, which at {speed} is a step of the velocity of "
                "{step}")
                  : AXISCOMP_TEXT("Error",
                      "along {axis}, {points} points: at most {distance} from the curve; at a "
                      "point its slope changes by up to {slope}"))
        .with("axis", axisText(table.source, density.axis))
        .with("points", density.points)
        .with("distance", amountOf(density.largestDistance, unit))
        .with("slope", amountOf(density.largestSlopeChange, unit + "/" + position))
        .with("speed", amountOf(speed.value_or(0.0), position + "/s"))
        .with("step", amountOf(density.largestSlopeChange * speed.value_or(0.0), unit + "/s"));
}

Text directionLine(const TableConversion& table, const DirectionLoss& loss, DirectionChoice choice)
{
    const CompensationColumn& column = table.result.columns[loss.column];
    const bool hasTarget = !column.target.empty();
    if (loss.position.empty())
        return (hasTarget ? AXISCOMP_TEXT("Error",
                    "one value for both directions of motion, {choice}, for {target}: they are the "
                    "same")
                          : AXISCOMP_TEXT("Error",
                              "one value for both directions of motion, {choice}: they are the "
                              "same"))
            .with("choice", choiceText(choice))
            .with("target", column.target);
    const std::string& unit = table.source.columns.front().unit;
    return (hasTarget ? AXISCOMP_TEXT("Error",
                "one value for both directions of motion, {choice}, for {target}: half their "
                "difference is up to {loss}, at {place}")
                      : AXISCOMP_TEXT("Error",
                          "one value for both directions of motion, {choice}: half their "
                          "difference is up to {loss}, at {place}"))
        .with("choice", choiceText(choice))
        .with("target", column.target)
        .with("loss", amountOf(loss.largestHalfDifference, unit))
        .with("place", positionText(table.source, loss.position));
}

/// One for each unit, with the largest rounding of what has it.
template <class Part>
std::vector<Quantity> roundingsByUnit(
    const std::vector<double>& roundings, const std::vector<Part>& parts)
{
    std::vector<std::pair<std::string, double>> largest;
    for (std::size_t n = 0; n < roundings.size(); ++n) {
        if (roundings[n] <= 0.0)
            continue;
        const auto known =
            std::ranges::find(largest, parts[n].unit, &std::pair<std::string, double>::first);
        if (known == largest.end())
            largest.emplace_back(parts[n].unit, roundings[n]);
        else
            known->second = std::max(known->second, roundings[n]);
    }
    std::vector<Quantity> amounts;
    for (const auto& [unit, rounding] : largest)
        amounts.push_back(amountOf(rounding, unit));
    return amounts;
}

void addRoundings(const TableConversion& table, const TableFormat& target, std::vector<Text>& lines)
{
    std::vector<double> values = table.valueRounding;
    for (std::size_t n = 0; n < values.size(); ++n)
        if (isFloatRounding(values[n], table.result.columns[n], target))
            values[n] = 0.0;
    for (const Quantity& amount : roundingsByUnit(values, table.result.columns))
        lines.push_back(
            AXISCOMP_TEXT("Error", "the values of the file are rounded by up to {amount}")
                .with("amount", amount));
    for (const Quantity& amount : roundingsByUnit(table.positionRounding, table.result.axes))
        lines.push_back(
            AXISCOMP_TEXT("Error", "the positions of the file are rounded by up to {amount}")
                .with("amount", amount));
}

Text differenceOf(const TableConversion& table, const ColumnDifference& difference)
{
    const CompensationColumn& column = table.source.columns[difference.columnA];
    if (isNoise(difference.largest, column))
        return AXISCOMP_TEXT("Error", "they do not differ");
    TextPattern pattern = AXISCOMP_TEXT("Error", "they differ by at most {largest} at {place}");
    if (isNoise(difference.largestInside, column))
        pattern = AXISCOMP_TEXT("Error",
            "they differ by at most {largest} at {place}, and not at all where both have values");
    else if (difference.largestInside < difference.largest)
        pattern = AXISCOMP_TEXT("Error",
            "they differ by at most {largest} at {place}, where both have values by at most "
            "{inside}");
    return pattern.with("largest", amountOf(difference.largest, column.unit))
        .with("place", positionText(table.source, difference.where))
        .with("inside", amountOf(difference.largestInside, column.unit));
}

Text differenceLine(const TableConversion& table, const ColumnDifference& difference)
{
    const bool hasOthers = table.source.columns.size() > 1;
    return (hasOthers
            ? AXISCOMP_TEXT("Error",
                "compared at {count} positions, each by its controller's rules ({column}): "
                "{difference}")
            : AXISCOMP_TEXT("Error",
                "compared at {count} positions, each by its controller's rules: {difference}"))
        .with("count", table.difference.positions)
        .with("column", columnText(table.source, table.source.columns[difference.columnA]))
        .with("difference", differenceOf(table, difference));
}

void addResampling(const TableConversion& table, std::size_t column, std::optional<double> speed,
    std::vector<Text>& lines)
{
    lines.push_back(resamplingLine(table, column));
    for (const ColumnDeviation::Density& density : table.resampling->columns[column].density)
        lines.push_back(densityLine(table, column, density, speed));
}

void addTable(
    const TableConversion& table, const ConversionRequest& request, std::vector<Text>& lines)
{
    lines.push_back(signLine(request, table.example));
    for (std::size_t n = 0; table.resampling && n < table.resampling->columns.size(); ++n)
        addResampling(table, n, request.speed, lines);
    for (const DirectionLoss& loss : table.directionLosses)
        lines.push_back(directionLine(table, loss, *request.direction));
    addRoundings(table, *request.to, lines);
    for (const ColumnDifference& difference : table.difference.columns)
        lines.push_back(differenceLine(table, difference));
}

} // namespace

std::vector<Text> conversionReport(const Conversion& conversion, const ConversionRequest& request)
{
    std::vector<Text> lines;
    for (std::size_t n = 0; n < conversion.tables.size(); ++n) {
        if (conversion.tables.size() > 1)
            lines.push_back(AXISCOMP_TEXT("Error", "table {number} of {count}:")
                                .with("number", n + 1)
                                .with("count", conversion.tables.size()));
        addTable(conversion.tables[n], request, lines);
    }
    lines.insert(lines.end(), conversion.remarks.begin(), conversion.remarks.end());
    return lines;
}

std::vector<Text> conversionLosses(const Conversion& conversion)
{
    std::vector<Text> losses;
    for (const TableConversion& table : conversion.tables)
        if (table.resampling)
            for (const Text& loss : table.resampling->losses)
                remarkOnce(losses, loss);
    return losses;
}

} // namespace axiscomp
