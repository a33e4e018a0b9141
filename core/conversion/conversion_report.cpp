// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/conversion.h"
#include "core/neutral/table_motion.h"
#include "core/table/compensation_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace axiscomp {

namespace {

/// An amount that nobody needs exactly: "0.0333 um".
std::string amountText(double amount, const std::string& unit)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g", amount);
    return unit.empty() ? text.data() : std::string(text.data()) + ' ' + unit;
}

/// What is left of numbers that are the same but for the rounding of doubles.
bool isNoise(double difference, const CompensationColumn& column)
{
    const TableStatistics values = statisticsOf(column.values);
    return difference <= 1e-12 * std::max(std::abs(values.minimum), std::abs(values.maximum));
}

/// Every number of a controller that computes with float32 is rounded like that.
bool isFloatRounding(const TableConversion& table, const ConversionRequest& request)
{
    const CompensationColumn& column = table.result.columns.front();
    const TableStatistics values = statisticsOf(column.values);
    const double largest = std::max(std::abs(values.minimum), std::abs(values.maximum));
    const double share = request.to->facts.behaviour.usesFloat ? 1e-7 : 1e-12;
    return table.valueRounding <= share * largest;
}

std::string formatSign(const TableFormat& format, std::optional<SignConvention> overruled)
{
    const FormatFacts& facts = format.facts;
    std::string text = std::string(facts.name) + " holds ";
    text += signName(overruled.value_or(facts.sign));
    return text + (overruled ? " values, as you say" : " values");
}

std::string signLine(const ConversionRequest& request, const std::string& example)
{
    std::string text = "sign: " + formatSign(*request.from, request.sourceSign);
    if (request.from != request.to || request.targetSign)
        text += ", " + formatSign(*request.to, request.targetSign);
    return text + "; " + example;
}

std::string sizesText(const NeutralTable& table)
{
    std::string text;
    for (const SourceAxis& axis : table.axes)
        text += (text.empty() ? "" : " x ") + std::to_string(axis.knots.size());
    return text + " points";
}

std::string resamplingLine(const TableConversion& table, std::size_t column)
{
    const ResamplingReport& report = *table.resampling;
    const ColumnDeviation& deviation = report.columns[column];
    const std::string& unit = table.source.columns[column].unit;
    return "resampled from " + sizesText(table.source) + " to " + sizesText(table.result)
        + ": at the positions of the source it is off by at most "
        + amountText(deviation.largest, unit) + ", " + amountText(deviation.rms, unit) + " rms";
}

std::string directionLine(
    const TableConversion& table, const DirectionLoss& loss, DirectionChoice choice)
{
    const CompensationColumn& column = table.result.columns[loss.column];
    const std::string unit = table.source.columns.front().unit;
    std::string text = "one value for both directions of motion, " + std::string(choiceName(choice))
        + (column.target.empty() ? "" : ", for " + column.target);
    if (loss.position.empty())
        return text + ": they are the same";
    return text + ": half their difference is up to " + amountText(loss.largestHalfDifference, unit)
        + ", at " + positionText(table.source, loss.position);
}

std::string roundingLine(const TableConversion& table)
{
    std::string text = "the numbers of the file are rounded: values by up to "
        + amountText(table.valueRounding, table.result.columns.front().unit);
    if (table.positionRounding > 0.0)
        text += ", positions by up to "
            + amountText(table.positionRounding, table.result.axes.front().unit);
    return text;
}

std::string differenceLine(const TableConversion& table, const ColumnDifference& difference)
{
    const CompensationColumn& column = table.source.columns[difference.columnA];
    std::string text = "compared at " + std::to_string(table.difference.positions)
        + " positions, each by its controller's rules";
    if (table.source.columns.size() > 1)
        text += " (" + columnText(table.source, column) + ")";
    if (isNoise(difference.largest, column))
        return text + ": they do not differ";
    text += ": they differ by at most " + amountText(difference.largest, column.unit);
    if (!difference.where.empty())
        text += " at " + positionText(table.source, difference.where);
    if (isNoise(difference.largestInside, column))
        text += ", and not at all where both have values";
    else if (difference.largestInside < difference.largest)
        text += ", where both have values by at most "
            + amountText(difference.largestInside, column.unit);
    return text;
}

void addTable(
    const TableConversion& table, const ConversionRequest& request, std::vector<std::string>& lines)
{
    lines.push_back(signLine(request, table.example));
    for (std::size_t n = 0; table.resampling && n < table.resampling->columns.size(); ++n)
        lines.push_back(resamplingLine(table, n));
    for (const DirectionLoss& loss : table.directionLosses)
        lines.push_back(directionLine(table, loss, *request.direction));
    if (!isFloatRounding(table, request) || table.positionRounding > 0.0)
        lines.push_back(roundingLine(table));
    for (const ColumnDifference& difference : table.difference.columns)
        lines.push_back(differenceLine(table, difference));
}

} // namespace

std::vector<std::string> conversionReport(
    const Conversion& conversion, const ConversionRequest& request)
{
    std::vector<std::string> lines;
    for (std::size_t n = 0; n < conversion.tables.size(); ++n) {
        if (conversion.tables.size() > 1)
            lines.push_back("table " + std::to_string(n + 1) + " of "
                + std::to_string(conversion.tables.size()) + ":");
        addTable(conversion.tables[n], request, lines);
    }
    lines.insert(lines.end(), conversion.remarks.begin(), conversion.remarks.end());
    return lines;
}

} // namespace axiscomp
