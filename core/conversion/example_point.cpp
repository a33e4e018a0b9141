// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/sign_conversion.h"
#include "core/neutral/table_motion.h"
#include "core/table/position_unit.h"
#include "core/text/token_scanner.h"

#include <array>
#include <charconv>
#include <cmath>

namespace axiscomp {

namespace {

/// Six digits tell the size and the sign.
std::string sixDigits(double value)
{
    constexpr int digits = 6;
    std::array<char, 32> buffer{};
    const auto result = std::to_chars(
        buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits);
    return {buffer.data(), result.ptr};
}

/// "+0.0021 mm"
std::string signedText(double value, const std::string& unit)
{
    return (value > 0.0 ? "+" : "") + sixDigits(value) + (unit.empty() ? "" : " " + unit);
}

/// So that the sum with a position has no more digits than the value itself is shown with.
double shownValue(double value)
{
    return numberOf(sixDigits(value)).value_or(value);
}

/// One value of a table.
struct Point {
    std::size_t column = 0;
    std::size_t index = 0;
};

std::optional<Point> largestPoint(const NeutralTable& table)
{
    const OwnAxes ownAxes = ownAxesOf(table);
    bool hasOwn = false;
    for (const auto& axis : ownAxes)
        hasOwn = hasOwn || axis.has_value();
    std::optional<Point> point;
    double largest = 0.0;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const CompensationColumn& column = table.columns[i];
        if (hasOwn && !ownAxes[i])
            continue;
        const double factor = unitFactor(column.unit, table.columns[0].unit).value_or(1.0);
        for (std::size_t index = 0; index < column.values.size(); ++index) {
            const double size = std::abs(column.values[index]) * factor;
            if (size > largest) {
                largest = size;
                point = Point{i, index};
            }
        }
    }
    return point;
}

class Sentence {
public:
    Sentence(const NeutralTable& table, const Point& point)
        : m_table(table)
        , m_column(table.columns[point.column])
        , m_own(ownAxis(table, m_column))
        , m_value(m_column.values[point.index])
        , m_position(knotPosition(table, point.index))
    {
    }

    /// Without the numbers of files.
    [[nodiscard]] std::string text() const
    {
        std::string text;
        if (m_column.direction != Direction::Both)
            text = "moving in " + std::string(directionName(m_column.direction)) + " direction, ";
        return text + (m_table.sign == SignConvention::Feedback ? encoderText() : commandText());
    }

private:
    [[nodiscard]] std::string place() const { return positionText(m_table, m_position); }
    [[nodiscard]] std::string target() const
    {
        return m_column.target.empty() ? "the target" : m_column.target;
    }
    /// What the value makes of the position of its own axis.
    [[nodiscard]] std::string movedPlace() const
    {
        const SourceAxis& axis = m_table.axes[*m_own];
        const double factor = unitFactor(m_column.unit, axis.unit).value_or(1.0);
        return quantityText(m_position[*m_own] + factor * shownValue(m_value), axis.unit);
    }
    [[nodiscard]] std::string referenceOffset(double offset) const
    {
        return "the reference of " + target() + " is "
            + quantityText(std::abs(offset), m_column.unit) + (offset > 0.0 ? " above" : " below")
            + " its encoder";
    }
    [[nodiscard]] std::string encoderText() const
    {
        const bool isOne = m_table.axes.size() == 1;
        const std::string reads =
            "where the " + std::string(isOne ? "encoder reads " : "encoders read ") + place();
        if (!m_own)
            return reads + ' ' + referenceOffset(m_value);
        return reads + " the reference " + (isOne ? "" : "of " + axisText(m_table, *m_own) + ' ')
            + "says " + movedPlace();
    }
    [[nodiscard]] std::string commandText() const
    {
        if (!m_own)
            return "commanded to " + place() + ", where " + referenceOffset(-m_value)
                + ", the controller moves " + target() + " by "
                + signedText(m_value, m_column.unit);
        const bool isOne = m_table.axes.size() == 1;
        return "commanded to " + place() + ", the controller moves the encoder "
            + (isOne ? "" : "of " + axisText(m_table, *m_own) + ' ') + "to " + movedPlace()
            + ", where the reference says "
            + quantityText(m_position[*m_own], m_table.axes[*m_own].unit);
    }

    const NeutralTable& m_table;
    const CompensationColumn& m_column;
    std::optional<std::size_t> m_own;
    double m_value;
    Position m_position;
};

std::string fileText(const NeutralTable& table, const Point& point)
{
    const CompensationColumn& column = table.columns[point.column];
    return "the " + std::string(signName(table.sign)) + " file says "
        + signedText(column.values[point.index], column.unit);
}

constexpr std::string_view allZero = "all values are 0, in either sign";

} // namespace

std::string examplePoint(const NeutralTable& table)
{
    const auto point = largestPoint(table);
    if (!point)
        return std::string(allZero);
    return Sentence(table, *point).text() + ": " + fileText(table, *point);
}

std::string examplePoint(const NeutralTable& feedback, const NeutralTable& command)
{
    const auto point = largestPoint(feedback);
    if (!point)
        return std::string(allZero);
    const CompensationColumn& column = command.columns[point->column];
    return Sentence(feedback, *point).text() + ": " + fileText(feedback, *point)
        + ", the command file " + signedText(column.values[point->index], column.unit);
}

} // namespace axiscomp
