// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/formats.h"
#include "core/text/number_text.h"
#include "tests/support/verify.h"

#include <QTest>

#include <array>
#include <cmath>

namespace axiscomp::test {

/// "2:3 NotANumber found|expected", one line each; a leading "warning " where it is one.
inline std::string problemLines(const TableReading& reading)
{
    std::string text;
    for (const Diagnostic& d : reading.diagnostics) {
        text += d.severity == Severity::Warning ? "warning " : "";
        text += std::to_string(d.line) + ':' + std::to_string(d.column) + ' '
            + std::string(diagnosticName(d.code)) + ' ' + d.found.english() + '|'
            + d.expected.english() + (d.controllerError.empty() ? "" : " #" + d.controllerError)
            + '\n';
    }
    return text;
}

/// Whether one of the problems has this code at this line, and, unless it is empty, the number of
/// the controller.
inline bool hasProblem(const TableReading& reading, DiagnosticCode code, std::size_t line,
    std::string_view controllerError = {})
{
    for (const Diagnostic& d : reading.diagnostics)
        if (d.code == code && d.line == line && d.controllerError == controllerError)
            return true;
    return false;
}

inline bool mentions(std::string_view text, std::string_view part)
{
    return text.find(part) != std::string_view::npos;
}

inline std::string joined(const std::vector<Text>& lines)
{
    std::string text;
    for (const Text& line : lines)
        text += line.english() + '\n';
    return text;
}

/// The text with the first `from` in it replaced.
inline std::string with(std::string text, std::string_view from, std::string_view to)
{
    return text.replace(text.find(from), from.size(), to);
}
/// The same as a function of from and to.
inline auto changing(const std::string& text)
{
    return [text](std::string_view from, std::string_view to) { return with(text, from, to); };
}

inline TableReadOptions readingWith(FormatSettings settings)
{
    TableReadOptions options;
    options.settings = std::move(settings);
    return options;
}
inline TableWriteOptions writingWith(FormatSettings settings)
{
    TableWriteOptions options;
    options.settings = std::move(settings);
    return options;
}

inline NeutralTable tableOf(
    SignConvention sign, std::vector<SourceAxis> axes, std::vector<CompensationColumn> columns)
{
    NeutralTable table;
    table.sign = sign;
    table.axes = std::move(axes);
    table.columns = std::move(columns);
    return table;
}
/// An offset of the command.
inline NeutralTable commandTable(
    std::vector<SourceAxis> axes, std::vector<CompensationColumn> columns)
{
    return tableOf(SignConvention::Command, std::move(axes), std::move(columns));
}
/// A copy that a function changes.
template <class Change> NeutralTable changed(NeutralTable table, const Change& change)
{
    change(table);
    return table;
}

inline SourceAxis axisOf(std::string name, std::string unit, std::vector<double> knots)
{
    SourceAxis axis;
    axis.name = std::move(name);
    axis.unit = std::move(unit);
    axis.knots = std::move(knots);
    return axis;
}
/// An axis with even knots.
inline SourceAxis evenAxis(
    std::string name, std::string unit, double start, double distance, std::size_t count)
{
    SourceAxis axis = axisOf(std::move(name), std::move(unit), {});
    for (std::size_t i = 0; i < count; ++i)
        axis.knots.push_back(start + static_cast<double>(i) * distance);
    return axis;
}

/// A column whose values are all different and of both signs: scale * sin(i).
inline CompensationColumn waveColumn(
    std::string target, std::string unit, std::size_t count, double scale)
{
    CompensationColumn column;
    column.target = std::move(target);
    column.unit = std::move(unit);
    for (std::size_t i = 0; i < count; ++i)
        column.values.push_back(scale * std::sin(static_cast<double>(i) + 1.0));
    return column;
}
inline CompensationColumn columnOf(std::string target, std::string unit, std::vector<double> values)
{
    CompensationColumn column;
    column.target = std::move(target);
    column.unit = std::move(unit);
    column.values = std::move(values);
    return column;
}

inline double largestDifference(const std::vector<double>& a, const std::vector<double>& b)
{
    double largest = a.size() == b.size() ? 0.0 : INFINITY;
    for (std::size_t i = 0; i < a.size() && i < b.size(); ++i)
        largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

/// Names count as they are, statements by what they mean.
inline bool haveSameTarget(const NeutralTable& a, const CompensationColumn& ofA,
    const NeutralTable& b, const CompensationColumn& ofB)
{
    if (ofA.target == ofB.target)
        return true;
    const bool isStatement = ofA.target.starts_with('#') || ofB.target.starts_with('#');
    return isStatement && targetOf(a, ofA) == targetOf(b, ofB);
}

/// Why two tables are not the same but for `allowance` in values and positions; empty: they are.
/// Names of tables, notes and steps are left aside.
inline std::string difference(const NeutralTable& found, const NeutralTable& expected,
    double allowance, double allowanceOfPositions)
{
    if (found.sign != expected.sign)
        return "the sign is " + std::string(signName(found.sign));
    if (found.axes.size() != expected.axes.size())
        return std::to_string(found.axes.size()) + " axes";
    if (found.columns.size() != expected.columns.size())
        return std::to_string(found.columns.size()) + " columns";
    for (std::size_t n = 0; n < found.axes.size(); ++n) {
        const SourceAxis& a = found.axes[n];
        const SourceAxis& b = expected.axes[n];
        if (a.name != b.name || a.unit != b.unit)
            return "axis " + std::to_string(n + 1) + " is " + a.name + " [" + a.unit + "]";
        if (a.wrap != b.wrap)
            return "the wrap of axis " + a.name + " differs";
        if (!(largestDifference(a.knots, b.knots) <= allowanceOfPositions))
            return "the knots of axis " + a.name + " differ";
    }
    for (std::size_t n = 0; n < found.columns.size(); ++n) {
        const CompensationColumn& a = found.columns[n];
        const CompensationColumn& b = expected.columns[n];
        if (!haveSameTarget(found, a, expected, b) || a.unit != b.unit
            || a.direction != b.direction)
            return "column " + std::to_string(n + 1) + " is for " + a.target + " [" + a.unit + "], "
                + std::string(directionName(a.direction));
        if (!(largestDifference(a.values, b.values) <= allowance))
            return "the values for " + a.target + " differ by "
                + toText(largestDifference(a.values, b.values));
    }
    return {};
}
inline std::string difference(
    const NeutralTable& found, const NeutralTable& expected, double allowance = 0.0)
{
    return difference(found, expected, allowance, allowance);
}

/// What the format's controller applies at a position, for the first column.
inline double applied(const TableFormat& format, const NeutralTable& table,
    std::initializer_list<double> position, std::size_t column = 0)
{
    return ControllerLookup(table, column, format.facts.behaviour)
        .at(std::span(position.begin(), position.size()));
}

} // namespace axiscomp::test

/// The only table of a text that must be read without an error.
#define READ_TABLE(table, format, text, options)                                                   \
    const auto reading_##table = (format).read(text, options);                                     \
    VERIFY_RESULT(reading_##table);                                                                \
    QVERIFY2(reading_##table->tables.size() == 1,                                                  \
        axiscomp::test::problemLines(*reading_##table).c_str());                                   \
    const axiscomp::NeutralTable& table = reading_##table->tables.front()

/// What is written of one table without an error.
#define WRITE_TABLE(written, format, table, options)                                               \
    const auto written = (format).write(std::array{table}, options);                               \
    VERIFY_RESULT(written)

/// The two tables are the same; otherwise the first difference in words.
#define COMPARE_TABLES(found, expected, allowance)                                                 \
    do {                                                                                           \
        const std::string why = axiscomp::test::difference(found, expected, allowance);            \
        QVERIFY2(why.empty(), why.c_str());                                                        \
    } while (false)
