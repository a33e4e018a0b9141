// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/pmac/pmac_file.h"
#include "core/formats/units.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <cmath>

namespace axiscomp::pmac {

namespace {

constexpr double largestEntry = 8388607.0; // 24 bits
constexpr double largestSpan = 2147483647.0;

/// How an axis lies on the circle of a table that begins at 0 and rolls over.
struct Circle {
    std::int64_t first = 0; ///< the first knot, counted from position 0
    std::size_t size = 0; ///< knots of one round
    std::int64_t span = 0; ///< of one round, in counts

    [[nodiscard]] std::size_t place(std::size_t knot) const
    {
        const auto round = static_cast<std::int64_t>(size);
        const std::int64_t at = (first + static_cast<std::int64_t>(knot)) % round;
        return static_cast<std::size_t>(at < 0 ? at + round : at);
    }
};

Result<Circle> circleOf(const FormatFacts& facts, const NeutralTable& table, std::size_t n,
    double counts, double allowance)
{
    const SourceAxis& axis = table.axes[n];
    const auto intervals = static_cast<double>(axis.knots.size() - 1);
    const double distance = (axis.knots.back() - axis.knots.front()) / intervals;
    const double first = axis.knots.front() / distance;
    if (!(std::abs(first) < 1e9) || std::abs(first - std::round(first)) > 1e-6)
        return cannotHold(facts,
            AXISCOMP_TEXT(
                "Error", "position 0, where its tables begin, is no point of source {number}")
                .with("number", n + 1),
            AXISCOMP_TEXT("Error", "resample it with a point at 0"));
    Circle circle{std::llround(first), axis.knots.size() - 1, 0};
    if (axis.wrap) {
        AXISCOMP_CHECK(checkOnePeriod(facts, table, n, allowance));
    } else if (circle.first > 0 || circle.first + static_cast<std::int64_t>(circle.size) < 0) {
        return cannotHold(facts,
            AXISCOMP_TEXT(
                "Error", "its tables begin at position 0, which source {number} does not reach")
                .with("number", n + 1),
            AXISCOMP_TEXT("Error", "add points to the table, as far as position 0"));
    } else if (!isClosed(table, n)) {
        ++circle.size; // one interval more leads from the last value to the first
    }
    const double span = static_cast<double>(circle.size) * distance * counts;
    if (!(span <= largestSpan) || !(span >= 0.5))
        return cannotHold(facts,
            AXISCOMP_TEXT("Error", "a span of {span} counts")
                .with("span", Quantity{roundedText(span)}),
            AXISCOMP_TEXT("Error", "check counts-per-unit and the unit of the positions"));
    circle.span = std::llround(span);
    return circle;
}

double countsFor(const SettingValues& settings, std::string_view key)
{
    return settings.number(settings.has(key) ? key : "counts-per-unit");
}

/// The entries on the circle; [0] is that of position 0.
Result<std::vector<double>> entriesOf(const FormatFacts& facts, const NeutralTable& table,
    const std::vector<Circle>& circles, const FileNumbers& numbers)
{
    const std::vector<double>& values = table.columns[0].values;
    const std::size_t width = table.axes[0].knots.size();
    const std::size_t height = circles.size() == 2 ? circles[1].size : 1;
    std::vector<double> entries(circles[0].size * height, 0.0);
    // Backwards, so that of two knots at one place the first counts.
    for (std::size_t i = values.size(); i-- > 0;) {
        const double entry = numbers.inFile(values[i]);
        if (!(std::abs(entry) <= largestEntry))
            return cannotHold(facts,
                AXISCOMP_TEXT("Error", "the value {value} is beyond the 24 bits of an entry")
                    .with("value", Quantity{roundedText(values[i])}),
                AXISCOMP_TEXT("Error", "check counts-per-unit and the unit of the values"));
        const std::size_t row = circles.size() == 2 ? circles[1].place(i / width) : 0;
        entries[row * circles[0].size + circles[0].place(i % width)] = entry;
    }
    if (entries[0] != 0.0)
        return cannotHold(facts,
            AXISCOMP_TEXT("Error",
                "its value at position 0 is {value}, and the controller takes it to be 0 there")
                .with("value", Quantity{roundedText(numbers.fromFile(entries[0]))}),
            AXISCOMP_TEXT(
                "Error", "shift all values so that it is 0 there; convert does that with --zero"));
    return entries;
}

std::string entryLines(const std::vector<double>& entries, const std::vector<Circle>& circles)
{
    constexpr std::size_t perLine = 10;
    const std::size_t columns = circles[0].size;
    const std::size_t rows = circles.size() == 2 ? circles[1].size : 0;
    std::string text;
    for (std::size_t j = 0; j <= rows; ++j)
        for (std::size_t i = j == 0 ? 1 : 0; i <= columns; ++i) {
            const std::size_t row = rows == 0 ? 0 : j % rows;
            text += plainNumber(entries[row * columns + i % columns]);
            text += i == columns || (i > 0 && i % perLine == 0) ? '\n' : ' ';
        }
    return text;
}

/// The numbers of the motors: the sources, then the target.
Result<std::vector<std::string>> motorsOf(const FormatFacts& facts, const Keys& keys,
    const NeutralTable& table, const SettingValues& settings)
{
    std::vector<std::string> motors;
    const auto add = [&](std::string_view key, const std::string& name) -> Result<void> {
        AXISCOMP_TRY(const auto motor, axisNumber(facts, settings, key, name));
        if (motor > 32)
            return cannotHold(facts,
                AXISCOMP_TEXT("Error", "there is no motor {number}").with("number", motor),
                AXISCOMP_TEXT("Error", "choose one from 1 to 32"));
        motors.push_back(std::to_string(motor));
        return {};
    };
    for (std::size_t n = 0; n < table.axes.size(); ++n)
        AXISCOMP_CHECK(add(keys.motors[n], table.axes[n].name));
    if (motors.size() == 2)
        AXISCOMP_CHECK(checkTwoSources(motors[0], motors[1], keys.motors));
    const auto own = ownAxis(table, table.columns[0]);
    const std::string target = own ? motors[*own] : targetName(table, table.columns[0]);
    AXISCOMP_CHECK(add("target-motor", target));
    return motors;
}

std::string header(const std::vector<std::string>& motors, const std::vector<Circle>& circles,
    const std::string& mark)
{
    std::string text = '#' + motors.back() + "\nDEFINE COMP ";
    if (circles.size() == 2)
        text += std::to_string(circles[1].size) + '.';
    text += std::to_string(circles[0].size);
    for (std::size_t n = 0; n < circles.size(); ++n)
        text += ",#" + motors[n] + mark;
    text += ",#" + motors.back();
    for (const Circle& circle : circles)
        text += ',' + std::to_string(circle.span);
    return text + '\n';
}

} // namespace

Result<void> checkCounted(const FormatFacts& facts, const NeutralTable& table,
    std::span<const std::string_view> sourceKeys, const SettingValues& settings)
{
    const auto isCountedTwice = [&](std::string_view key, const std::string& unit) {
        return unit == countsUnit && countsPerUnit(settings, key) != 1.0;
    };
    bool isTwice = isCountedTwice(targetCountsKey, table.columns.front().unit);
    for (std::size_t n = 0; n < table.axes.size(); ++n)
        isTwice = isTwice || isCountedTwice(sourceKeys[n], table.axes[n].unit);
    if (!isTwice)
        return checkOneUnit(facts, motorContradiction(table, sourceKeys, settings));
    return fail(ErrorCode::InvalidArgument,
        {{"reason",
            AXISCOMP_TEXT("Error",
                "the table is in counts already, and the format {format} would multiply it by the "
                "counts per unit once more: set them to 1, or read the source with its own")
                .with("format", facts.name)}});
}

Result<WrittenTables> writeTable(const TableFormat& format, const Keys& keys,
    const NeutralTable& source, const FormatSettings& settings)
{
    const FormatFacts& facts = format.facts;
    AXISCOMP_CHECK(checkCounts(facts, settings));
    AXISCOMP_TRY(const auto given, SettingValues::of(facts, settings, true));
    WrittenTables written;
    AXISCOMP_TRY(const auto table, inSettingUnits(source, given, written.remarks));
    AXISCOMP_CHECK(checkCounted(facts, table, keys.counts, given));
    AXISCOMP_TRY(const auto motors, motorsOf(facts, keys, table, given));
    const FileNumbers numbers{entriesPerCount * countsFor(given, "target-counts-per-unit"), false};
    std::vector<Circle> circles;
    for (std::size_t n = 0; n < table.axes.size(); ++n) {
        const double counts = countsFor(given, keys.counts[n]);
        AXISCOMP_TRY(const auto circle, circleOf(facts, table, n, counts, 0.5 / numbers.perUnit));
        circles.push_back(circle);
    }
    AXISCOMP_TRY(const auto entries, entriesOf(facts, table, circles, numbers));
    const bool isDesired = given.text("position") == "desired";
    written.bytes = noteLines(table, "; ") + header(motors, circles, isDesired ? "D" : "")
        + entryLines(entries, circles);
    FormatSettings reading;
    for (const auto& [key, value] : settings)
        if (key.ends_with("counts-per-unit"))
            reading[key] = value;
    AXISCOMP_TRY(auto held, readBack(format, written.bytes, std::move(reading)));
    takeWrittenUnits(held, {&table, 1});
    written.held = std::move(held);
    written.remarks.emplace_back(isDesired
            ? AXISCOMP_TEXT("Error",
                "the table is looked up at the desired position of its sources (D); with "
                "position=actual at the actual one")
            : AXISCOMP_TEXT("Error",
                "the table is looked up at the actual position of its sources; with "
                "position=desired at the desired one (D)"));
    written.remarks.emplace_back(AXISCOMP_TEXT(
        "Error", "switch the table on with I51=1; outside of its span it rolls over"));
    return written;
}

} // namespace axiscomp::pmac
