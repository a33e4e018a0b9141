// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/lookup_sides.h"
#include "core/conversion/sign_conversion.h"
#include "core/neutral/table_motion.h"
#include "core/table/position_unit.h"
#include "core/text/token_scanner.h"

#include <algorithm>
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
Quantity signedQuantity(double value, const std::string& unit)
{
    return {(value > 0.0 ? "+" : "") + sixDigits(value), unit};
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
    for (std::size_t i = 0; i < table.columns.size(); ++i)
        hasOwn =
            hasOwn || (ownAxes[i] && std::ranges::any_of(table.columns[i].values, [](double value) {
                return value != 0.0;
            }));
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

/// What turns values into the unit of the positions of their own axis; nothing: it is not known,
/// and they are not added.
std::optional<double> factorToPlace(const std::string& unit, const std::string& ofPlace)
{
    return isSameUnit(unit, ofPlace) ? std::optional(1.0) : unitFactor(unit, ofPlace);
}

class Sentence {
public:
    Sentence(const NeutralTable& table, const Point& point, bool isComputed)
        : m_table(table)
        , m_column(table.columns[point.column])
        , m_own(ownAxis(table, m_column))
        , m_value(m_column.values[point.index])
        , m_position(knotPosition(table, point.index))
        , m_isComputed(isComputed)
    {
        if (m_own)
            m_factor = factorToPlace(m_column.unit, m_table.axes[*m_own].unit);
    }

    /// Without the numbers of files.
    [[nodiscard]] Text text() const
    {
        const bool isFeedback = m_table.sign == SignConvention::Feedback;
        Text text = m_isComputed ? (isFeedback ? correctedText() : movedText())
            : isFeedback         ? encoderText()
                                 : commandText();
        if (m_column.direction == Direction::Both)
            return text;
        return (m_column.direction == Direction::Positive
                ? AXISCOMP_TEXT("Error", "moving in positive direction, {example}")
                : AXISCOMP_TEXT("Error", "moving in negative direction, {example}"))
            .with("example", std::move(text));
    }

private:
    [[nodiscard]] Text about(const TextPattern& pattern) const;
    /// Whether the moved place can be said; otherwise the value is, in its own unit.
    [[nodiscard]] bool hasMovedPlace() const { return m_factor.has_value(); }
    [[nodiscard]] Argument target() const
    {
        if (m_own)
            return axisText(m_table, *m_own);
        if (m_column.target.empty())
            return AXISCOMP_TEXT("Error", "the target");
        return m_column.target;
    }
    /// What the value makes of the position of its own axis.
    [[nodiscard]] Quantity movedPlace() const
    {
        const SourceAxis& axis = m_table.axes[*m_own];
        return quantityOf(m_position[*m_own] + *m_factor * shownValue(m_value), axis.unit);
    }
    [[nodiscard]] Text encoderText() const;
    [[nodiscard]] Text commandText() const;
    // The same without the reference.
    [[nodiscard]] Text correctedText() const;
    [[nodiscard]] Text movedText() const;

    const NeutralTable& m_table;
    const CompensationColumn& m_column;
    std::optional<std::size_t> m_own;
    std::optional<double> m_factor; ///< from the value to the positions of its own axis
    double m_value;
    Position m_position;
    bool m_isComputed;
};

/// With what the sentences say of the place and of the axis.
Text Sentence::about(const TextPattern& pattern) const
{
    Text text = pattern.with("place", positionText(m_table, m_position));
    if (!hasMovedPlace())
        return std::move(text)
            .with("axis", target())
            .with("offset", Quantity{sixDigits(std::abs(m_value)), m_column.unit});
    return std::move(text)
        .with("axis", axisText(m_table, *m_own))
        .with("moved", movedPlace())
        .with("reference", quantityOf(m_position[*m_own], m_table.axes[*m_own].unit));
}

Text Sentence::encoderText() const
{
    const bool isOne = m_table.axes.size() == 1;
    if (hasMovedPlace())
        return about(isOne
                ? AXISCOMP_TEXT(
                    "Error", "where the encoder reads {place} the reference says {moved}")
                : AXISCOMP_TEXT("Error",
                    "where the encoders read {place} the reference of {axis} says {moved}"));
    if (isOne)
        return about(m_value > 0.0
                ? AXISCOMP_TEXT("Error",
                    "where the encoder reads {place} the reference of {axis} is {offset} above "
                    "its encoder")
                : AXISCOMP_TEXT("Error",
                    "where the encoder reads {place} the reference of {axis} is {offset} below "
                    "its encoder"));
    return about(m_value > 0.0
            ? AXISCOMP_TEXT("Error",
                "where the encoders read {place} the reference of {axis} is {offset} above its "
                "encoder")
            : AXISCOMP_TEXT("Error",
                "where the encoders read {place} the reference of {axis} is {offset} below its "
                "encoder"));
}

Text Sentence::commandText() const
{
    if (hasMovedPlace())
        return about(m_table.axes.size() == 1
                ? AXISCOMP_TEXT("Error",
                    "commanded to {place}, the controller moves the encoder to {moved}, where "
                    "the reference says {reference}")
                : AXISCOMP_TEXT("Error",
                    "commanded to {place}, the controller moves the encoder of {axis} to "
                    "{moved}, where the reference says {reference}"));
    return about(m_value < 0.0
            ? AXISCOMP_TEXT("Error",
                "commanded to {place}, where the reference of {axis} is {offset} above its "
                "encoder, the controller moves {target} by {value}")
            : AXISCOMP_TEXT("Error",
                "commanded to {place}, where the reference of {axis} is {offset} below its "
                "encoder, the controller moves {target} by {value}"))
        .with("target", target())
        .with("value", signedQuantity(m_value, m_column.unit));
}

Text Sentence::correctedText() const
{
    const bool isOne = m_table.axes.size() == 1;
    if (hasMovedPlace())
        return about(isOne ? AXISCOMP_TEXT("Error",
                         "where the encoder reads {place} the controller takes the axis to be at "
                         "{moved}")
                           : AXISCOMP_TEXT("Error",
                               "where the encoders read {place} the controller takes {axis} to be "
                               "at {moved}"));
    return about(isOne ? AXISCOMP_TEXT("Error",
                     "where the encoder reads {place} the controller adds {value} to the position "
                     "of {axis}")
                       : AXISCOMP_TEXT("Error",
                           "where the encoders read {place} the controller adds {value} to the "
                           "position of {axis}"))
        .with("value", signedQuantity(m_value, m_column.unit));
}

Text Sentence::movedText() const
{
    if (hasMovedPlace())
        return about(m_table.axes.size() == 1
                ? AXISCOMP_TEXT(
                    "Error", "commanded to {place}, the controller moves the encoder to {moved}")
                : AXISCOMP_TEXT("Error",
                    "commanded to {place}, the controller moves the encoder of {axis} to "
                    "{moved}"));
    return about(
        AXISCOMP_TEXT("Error", "commanded to {place}, the controller moves {target} by {value}"))
        .with("target", target())
        .with("value", signedQuantity(m_value, m_column.unit));
}

Quantity valueOf(const NeutralTable& table, const Point& point)
{
    const CompensationColumn& column = table.columns[point.column];
    return signedQuantity(column.values[point.index], column.unit);
}

constexpr TextPattern allZero = AXISCOMP_TEXT("Error", "all values are 0, in either sign");

} // namespace

Text examplePoint(const NeutralTable& table, bool isComputed)
{
    const auto point = largestPoint(table);
    if (!point)
        return allZero;
    return (table.sign == SignConvention::Feedback
            ? AXISCOMP_TEXT("Error", "{example}: the feedback file says {value}")
            : AXISCOMP_TEXT("Error", "{example}: the command file says {value}"))
        .with("example", Sentence(table, *point, isComputed).text())
        .with("value", valueOf(table, *point));
}

Text examplePointAtSet(const NeutralTable& table, bool isComputed)
{
    const auto point = largestPoint(table);
    if (!point)
        return allZero;
    const NeutralTable moving = withTurnedSigns(table, SignConvention::Command);
    return AXISCOMP_TEXT("Error", "{example}: the file says {value}")
        .with("example", Sentence(moving, *point, isComputed).text())
        .with("value", valueOf(table, *point));
}

Text examplePoint(const NeutralTable& feedback, const NeutralTable& command, bool isComputed)
{
    const auto point = largestPoint(feedback);
    if (!point)
        return allZero;
    return AXISCOMP_TEXT(
        "Error", "{example}: the feedback file says {value}, the command file {other}")
        .with("example", Sentence(feedback, *point, isComputed).text())
        .with("value", valueOf(feedback, *point))
        .with("other", valueOf(command, *point));
}

} // namespace axiscomp
