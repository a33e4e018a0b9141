// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/portable_math.h"
#include "core/formats/axis_letter.h"
#include "core/formats/heidenhain/heidenhain_file.h"
#include "core/formats/units.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace axiscomp::heidenhain {

namespace {

/// The width of each column, in characters, left-aligned.
struct Widths {
    std::size_t number = 0;
    std::size_t position = 0;
    std::size_t backlash = 0;
    std::size_t value = 0;
};
Widths widthsOf(Layout layout)
{
    return layout == Layout::EvenPositions ? Widths{8, 12, 0, 11} : Widths{5, 14, 14, 14};
}

/// "+0.0000"
std::string signedText(double value)
{
    std::string text = fixedDigits(value, decimals);
    return text.starts_with('-') ? text : '+' + text;
}

std::string padded(std::string text, std::size_t width)
{
    if (text.size() < width)
        text.append(width - text.size(), ' ');
    return text;
}

std::string withoutBlanksAtEnd(std::string text)
{
    text.erase(text.find_last_not_of(' ') + 1);
    return text + '\n';
}

/// One table on its way into the file.
class FileWriter {
public:
    FileWriter(const FormatFacts& facts, Layout layout, const SettingValues& given)
        : m_facts(facts)
        , m_layout(layout)
        , m_given(given)
        , m_widths(widthsOf(layout))
    {
    }

    /// Finds the letters of the axes and brings the numbers into mm and degrees.
    [[nodiscard]] Result<void> prepare(const NeutralTable& table, std::vector<Text>& remarks);
    [[nodiscard]] Result<std::string> text() const;
    [[nodiscard]] const std::string& axis() const { return m_axis; }
    /// The columns of the file in the order of the table; the file has them in that of the letters.
    void orderColumns(NeutralTable& held) const;

private:
    [[nodiscard]] Result<void> takeLetters(const NeutralTable& table);
    [[nodiscard]] Result<void> checkStatedTarget(const NeutralTable& table) const;
    [[nodiscard]] Result<void> checkUnits() const;
    [[nodiscard]] Result<void> checkDistance(double distance) const;
    [[nodiscard]] Result<std::string> firstLine() const;
    [[nodiscard]] Result<std::string> row(std::size_t index) const;
    [[nodiscard]] std::string headers() const;

    const FormatFacts& m_facts;
    Layout m_layout;
    const SettingValues& m_given;
    Widths m_widths;
    NeutralTable m_table;
    std::string m_axis;
    std::map<std::string, std::size_t> m_columns; ///< by letter
};

Result<void> FileWriter::takeLetters(const NeutralTable& table)
{
    AXISCOMP_CHECK(checkTargets(table));
    AXISCOMP_TRY(
        m_axis, axisLetter(m_facts, m_given, movingAxis.key, table.axes.front().name, axisLetters));
    for (std::size_t n = 0; n < table.columns.size(); ++n) {
        const bool isOwn = ownAxis(table, table.columns[n]) == std::optional<std::size_t>(0);
        std::string letter = m_axis;
        if (!isOwn) {
            AXISCOMP_TRY(letter,
                axisLetter(m_facts, m_given, compensatedAxis.key,
                    targetName(table, table.columns[n]), axisLetters));
        }
        if (!isOwn && letter == m_axis)
            return fail(ErrorCode::InvalidArgument,
                {{"reason",
                    AXISCOMP_TEXT("Error",
                        "the table goes from {column}, and the settings for its axes say {axis} "
                        "for both")
                        .with("column", columnText(table, table.columns[n]))
                        .with("axis", letter)}});
        if (!m_columns.emplace(letter, n).second)
            return cannotHold(m_facts,
                AXISCOMP_TEXT("Error", "there are two columns for axis {axis}")
                    .with("axis", letter),
                AXISCOMP_TEXT("Error", "choose one of them"));
    }
    return checkStatedTarget(table);
}

/// A target that is stated must be that of a column.
Result<void> FileWriter::checkStatedTarget(const NeutralTable& table) const
{
    if (!m_given.has(compensatedAxis.key))
        return {};
    AXISCOMP_TRY(
        const auto letter, axisLetter(m_facts, m_given, compensatedAxis.key, {}, axisLetters));
    if (m_columns.contains(letter))
        return {};
    return fail(ErrorCode::InvalidArgument,
        {{"reason",
            AXISCOMP_TEXT("Error",
                "the setting {key} of the format {format} says {value}, and the table goes from "
                "{column}")
                .with("key", compensatedAxis.key)
                .with("format", m_facts.name)
                .with("value", letter)
                .with("column", columnText(table, table.columns.front()))}});
}

/// Lengths for linear axes, angles for rotary ones; of a rotary axis 0 to 360 degrees.
Result<void> FileWriter::checkUnits() const
{
    const auto check = [&](const std::string& letter, const std::string& unit) -> Result<void> {
        if ((unit == "deg") == isRotary(letter))
            return {};
        return cannotHold(m_facts,
            AXISCOMP_TEXT("Error",
                "its numbers for axis {axis} are in {unit}; A, B and C are in degrees, other axes "
                "in mm")
                .with("axis", letter)
                .with("unit", unit),
            AXISCOMP_TEXT("Error", "check the units and the axes of the table"));
    };
    const SourceAxis& source = m_table.axes.front();
    AXISCOMP_CHECK(check(m_axis, source.unit));
    for (const auto& [letter, n] : m_columns)
        AXISCOMP_CHECK(check(letter, m_table.columns[n].unit));
    if (isRotary(m_axis) && (source.knots.front() < 0.0 || source.knots.back() > 360.0))
        return cannotHold(m_facts,
            AXISCOMP_TEXT("Error",
                "its positions go from {first} to {last}, and of a rotary axis only 0 to 360 "
                "degrees count")
                .with("first", Quantity{roundedText(source.knots.front()), "deg"})
                .with("last", Quantity{roundedText(source.knots.back()), "deg"}),
            AXISCOMP_TEXT("Error",
                "give them from 0 to 360 degrees in the file that is converted, -90 as 270"));
    return {};
}

Result<void> FileWriter::prepare(const NeutralTable& table, std::vector<Text>& remarks)
{
    AXISCOMP_CHECK(takeLetters(table));
    NeutralTable said = table;
    const auto assume = [&](std::string& unit, const std::string& letter) {
        if (!unit.empty() || !isRotary(letter))
            return;
        unit = "deg";
        remarkOnce(remarks,
            AXISCOMP_TEXT("Error",
                "the numbers for axis {axis} have no unit; they are taken to be "
                "in {unit}")
                .with("axis", letter)
                .with("unit", unit));
    };
    assume(said.axes.front().unit, m_axis);
    for (const auto& [letter, n] : m_columns)
        assume(said.columns[n].unit, letter);
    AXISCOMP_TRY(m_table, inUnits(said, "mm", "deg", remarks));
    return checkUnits();
}

/// What the TNC 407 demands, a power of two times 0.0001, and that four decimals hold it.
Result<void> FileWriter::checkDistance(double distance) const
{
    const double step = portable::pow(10.0, -decimals);
    const double below =
        portable::pow(2.0, std::max(0.0, std::floor(portable::log2(distance / step) + 1e-9)));
    const bool isPower = std::abs(distance / step - below) <= 1e-6 * below;
    const auto textOf = [&](double count) {
        return Quantity{fixedDigits(count * step, decimals), m_table.axes.front().unit};
    };
    if (!isPower && !m_given.yes("any-distance"))
        return cannotHold(m_facts,
            AXISCOMP_TEXT("Error",
                "its distance is {distance}; the TNC 407 takes a power of two times {step}, and "
                "the next ones are {below} and {above}")
                .with("distance", Quantity{roundedText(distance), m_table.axes.front().unit})
                .with("step", textOf(1.0))
                .with("below", textOf(below))
                .with("above", textOf(2.0 * below)),
            AXISCOMP_TEXT("Error",
                "resample it with one of these distances, or set any-distance=yes for an iTNC "
                "530"));
    const double written = std::round(distance / step) * step;
    const auto cells = static_cast<double>(m_table.pointCount() - 1);
    if (!(std::abs(written - distance) * cells <= step / 2.0))
        return cannotHold(m_facts,
            AXISCOMP_TEXT("Error", "its distance {distance} has more than {count} decimals")
                .with("distance", Quantity{roundedText(distance), m_table.axes.front().unit})
                .with("count", decimals),
            AXISCOMP_TEXT("Error", "resample it with a distance of fewer decimals"));
    return {};
}

Result<std::string> FileWriter::firstLine() const
{
    if (m_layout == Layout::Positions)
        return "BEGIN AXIS_" + m_axis + ".COM MM\n";
    const SourceAxis& source = m_table.axes.front();
    const double distance = evenDistance(source);
    AXISCOMP_CHECK(checkDistance(distance));
    return "BEGIN AXIS-" + m_axis + ".COM  DATUM:" + signedText(source.knots.front())
        + " DISTANCE:" + signedText(distance) + '\n';
}

/// X, Y and Z, and what else has values, in the order of the letters.
std::string FileWriter::headers() const
{
    std::string text = padded("NR", m_widths.number);
    if (m_layout == Layout::Positions)
        text += padded("AXISPOS", m_widths.position) + padded("BACKLASH", m_widths.backlash);
    else
        text += padded({}, m_widths.position);
    for (const char letter : axisLetters)
        if (letter >= 'X' || m_columns.contains(std::string(1, letter)))
            text += padded(std::string(1, letter), m_widths.value);
    return withoutBlanksAtEnd(text);
}

Result<std::string> FileWriter::row(std::size_t index) const
{
    std::string text = padded(std::to_string(index), m_widths.number);
    const auto add = [&](double number, std::size_t width) -> Result<void> {
        const std::string digits = signedText(number);
        if (digits.size() >= width)
            return cannotHold(m_facts,
                AXISCOMP_TEXT("Error", "the number {number} has more digits than a column holds")
                    .with("number", Quantity{roundedText(number)}),
                AXISCOMP_TEXT("Error", "check the unit of positions and values"));
        text += padded(digits, width);
        return {};
    };
    AXISCOMP_CHECK(add(m_table.axes.front().knots[index], m_widths.position));
    text += padded({}, m_widths.backlash);
    for (const char letter : axisLetters) {
        const auto column = m_columns.find(std::string(1, letter));
        if (column != m_columns.end())
            AXISCOMP_CHECK(add(m_table.columns[column->second].values[index], m_widths.value));
        else if (letter >= 'X')
            text += padded({}, m_widths.value);
    }
    return withoutBlanksAtEnd(text);
}

Result<std::string> FileWriter::text() const
{
    AXISCOMP_TRY(std::string text, firstLine());
    text += headers();
    for (std::size_t i = 0; i < m_table.pointCount(); ++i) {
        AXISCOMP_TRY(const auto line, row(i));
        text += line;
    }
    return text + "[END]\n";
}

void FileWriter::orderColumns(NeutralTable& held) const
{
    const auto place = [this](const CompensationColumn& column) {
        const auto found = m_columns.find(column.target);
        return found == m_columns.end() ? m_columns.size() : found->second;
    };
    std::ranges::stable_sort(held.columns, {}, place);
}

} // namespace

Result<WrittenTables> writeFile(const TableFormat& format, Layout layout, const NeutralTable& table,
    const FormatSettings& settings)
{
    AXISCOMP_TRY(const auto given, SettingValues::of(format.facts, settings, true));
    WrittenTables written;
    FileWriter writer(format.facts, layout, given);
    AXISCOMP_CHECK(writer.prepare(table, written.remarks));
    AXISCOMP_TRY(written.bytes, writer.text());
    AXISCOMP_TRY(auto held, readBack(format, written.bytes, {}, &written.remarks));
    writer.orderColumns(held.front());
    written.held = std::move(held);
    written.remarks.push_back(AXISCOMP_TEXT("Error",
        "no text says the sign of a .COM table; it is written as the error, actual - commanded "
        "position. Check one point on the machine"));
    written.remarks.push_back(AXISCOMP_TEXT("Error",
        "name the file in a line of config.cma, in the column of axis {axis}, and mark the line "
        "with *; older controls also need the bit of the axis in MP730")
                                  .with("axis", writer.axis()));
    return written;
}

} // namespace axiscomp::heidenhain
