// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/format_writer.h"

#include "core/text/number_text.h"
#include "core/text/text_file.h"
#include "core/text/utf8.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace axiscomp {

namespace {

/// Calls visit(first, last) for the pairs of points that face each other at both ends of an axis.
template <typename Visit>
void visitEnds(const NeutralTable& table, std::size_t axis, const Visit& visit)
{
    std::size_t stride = 1;
    for (std::size_t n = 0; n < axis; ++n)
        stride *= table.axes[n].knots.size();
    const std::size_t size = table.axes[axis].knots.size();
    const std::size_t count = table.pointCount();
    for (std::size_t block = 0; block < count; block += stride * size)
        for (std::size_t i = 0; i < stride; ++i)
            visit(block + i, block + i + (size - 1) * stride);
}

double largestGap(const NeutralTable& table, std::size_t axis)
{
    double largest = 0.0;
    visitEnds(table, axis, [&](std::size_t first, std::size_t last) {
        for (const CompensationColumn& column : table.columns)
            largest = std::max(largest, std::abs(column.values[first] - column.values[last]));
    });
    return largest;
}

} // namespace

tl::unexpected<Error> cannotHold(const FormatFacts& facts, Text reason, Text wayOut)
{
    return fail(ErrorCode::FormatCannotHold,
        {{"format", facts.name}, {"reason", std::move(reason)}, {"wayOut", std::move(wayOut)}});
}

Result<void> checkOwnAxis(const FormatFacts& facts, const NeutralTable& table, const Text& wayOut)
{
    AXISCOMP_CHECK(checkTargets(table));
    for (const CompensationColumn& column : table.columns)
        if (ownAxis(table, column) != 0)
            return cannotHold(facts,
                AXISCOMP_TEXT("Error",
                    "it corrects an axis by its own position, and this table goes from {column}")
                    .with("column", columnText(table, column)),
                wayOut);
    return {};
}

Result<std::int64_t> axisNumber(const FormatFacts& facts, const SettingValues& settings,
    std::string_view key, const std::string& name)
{
    const bool isSet = settings.has(key);
    const auto number = isSet ? std::optional(settings.whole(key)) : wholeNumberOf(name);
    if (number && *number >= 1)
        return *number;
    Text reason = isSet
        ? AXISCOMP_TEXT("Error",
            "the format {format} names its axes by numbers from 1; the setting {key} is {value}")
              .with("value", settings.text(key))
        : AXISCOMP_TEXT("Error",
            "the format {format} names its axes by numbers from 1 and there is no number in the "
            "axis name \"{name}\"; give the setting {key}")
              .with("name", name);
    return fail(ErrorCode::InvalidArgument,
        {{"reason", std::move(reason).with("format", facts.name).with("key", key)}});
}

Result<void> checkTwoSources(
    std::string_view first, std::string_view second, std::span<const std::string_view> keys)
{
    if (first != second)
        return {};
    return fail(ErrorCode::InvalidArgument,
        {{"reason",
            AXISCOMP_TEXT("Error", "both sources are axis {axis}: {key} and {other}")
                .with("axis", first)
                .with("key", keys[0])
                .with("other", keys[1])}});
}

bool isClosed(const NeutralTable& table, std::size_t axis)
{
    return largestGap(table, axis) == 0.0;
}

Result<void> checkOnePeriod(
    const FormatFacts& facts, const NeutralTable& table, std::size_t axis, double allowance)
{
    const SourceAxis& source = table.axes[axis];
    const double period = source.wrap.value_or(0.0);
    const double span = source.knots.back() - source.knots.front();
    if (std::abs(span - period) > 1e-9 * period + source.step / 2.0)
        return cannotHold(facts,
            AXISCOMP_TEXT("Error",
                "its positions of source {number} span {span}, and a modulo axis needs exactly one "
                "period of {period}")
                .with("number", axis + 1)
                .with("span", Quantity{roundedText(span)})
                .with("period", Quantity{roundedText(period)}),
            AXISCOMP_TEXT("Error", "resample it over one whole period"));
    if (largestGap(table, axis) > allowance)
        return cannotHold(facts,
            AXISCOMP_TEXT("Error",
                "the values at both ends of the modulo axis, source {number}, differ by "
                "{difference}")
                .with("number", axis + 1)
                .with("difference", Quantity{roundedText(largestGap(table, axis))}),
            AXISCOMP_TEXT("Error", "make both ends equal: they are the same place"));
    return {};
}

Result<DirectionPair> directionPair(const FormatFacts& facts, const NeutralTable& table)
{
    const auto& columns = table.columns;
    if (columns.size() == 1 && columns[0].direction == Direction::Both)
        return DirectionPair{&columns[0], nullptr};
    if (columns.size() == 2 && columns[0].target == columns[1].target) {
        DirectionPair pair{&columns[0], &columns[1]};
        if (pair.positive->direction == Direction::Negative)
            std::swap(pair.positive, pair.negative);
        if (pair.positive->direction == Direction::Positive
            && pair.negative->direction == Direction::Negative)
            return pair;
    }
    return cannotHold(facts,
        AXISCOMP_TEXT("Error",
            "it takes a column for both directions of motion, or one for each direction of one "
            "axis"),
        AXISCOMP_TEXT("Error", "choose these columns"));
}

std::string plainNumber(double value)
{
    std::array<char, 400> buffer{}; // the smallest double has 324 decimals
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(),
        value == 0.0 ? 0.0 : value, std::chars_format::fixed);
    return end.ec == std::errc{} ? std::string(buffer.data(), end.ptr) : toText(value);
}

double evenDistance(const SourceAxis& axis)
{
    const std::vector<double>& knots = axis.knots;
    const double exact = (knots.back() - knots.front()) / static_cast<double>(knots.size() - 1);
    const double brief = numberOf(roundedText(exact)).value_or(exact);
    const double largest = std::max(std::abs(knots.front()), std::abs(knots.back()));
    const double rounding = 4 * std::numeric_limits<double>::epsilon() * largest;
    for (std::size_t i = 0; i < knots.size(); ++i) {
        const double place = knots.front() + static_cast<double>(i) * brief;
        if (!(std::abs(place - knots[i]) <= rounding))
            return exact;
    }
    return brief;
}

double FileNumbers::inFile(double x) const
{
    const double exact = x * perUnit;
    const double rounded =
        hasDecimals ? numberOf(roundedText(exact)).value_or(exact) : std::round(exact);
    return rounded == 0.0 ? 0.0 : rounded; // no -0
}

double FileNumbers::stepOf(std::span<const double> inFile) const
{
    const bool areWhole =
        std::ranges::all_of(inFile, [](double number) { return number == std::round(number); });
    return areWhole ? 1.0 / perUnit : 0.0;
}

std::optional<std::size_t> beyond32Bits(std::span<const double> inFile)
{
    constexpr double most = 2147483647.0;
    const auto found =
        std::ranges::find_if(inFile, [](double number) { return !(std::abs(number) <= most); });
    if (found == inFile.end())
        return std::nullopt;
    return static_cast<std::size_t>(found - inFile.begin());
}

std::string noteLines(const NeutralTable& table, std::string_view prefix)
{
    std::string text;
    for (const std::string& note : table.notes) {
        // A line break in a note would end the comment.
        std::string_view rest = note;
        while (!rest.empty()) {
            const std::size_t end = std::min(rest.find_first_of("\r\n"), rest.size());
            if (end > 0)
                text.append(prefix).append(rest.substr(0, end)).append("\n");
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
    }
    return text;
}

void keepNote(std::vector<std::string>& notes, std::string_view comment)
{
    constexpr std::size_t mostNotes = 100;
    const auto isTelling = [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z')
            || static_cast<unsigned char>(c) >= 0x80;
    };
    if (notes.size() < mostNotes && std::ranges::any_of(comment, isTelling))
        notes.push_back(toUtf8(trimmed(comment),
            findInvalidUtf8(comment) == std::string_view::npos ? Encoding::Utf8
                                                               : Encoding::Windows1252));
}

void takeWrittenUnits(std::span<NeutralTable> held, std::span<const NeutralTable> written)
{
    for (std::size_t t = 0; t < std::min(held.size(), written.size()); ++t) {
        const NeutralTable& from = written[t];
        NeutralTable& to = held[t];
        for (std::size_t n = 0; n < std::min(to.axes.size(), from.axes.size()); ++n)
            to.axes[n].unit = from.axes[n].unit;
        for (std::size_t n = 0; n < std::min(to.columns.size(), from.columns.size()); ++n)
            to.columns[n].unit = from.columns[n].unit;
    }
}

Result<std::vector<NeutralTable>> readBack(const TableFormat& format, std::string_view bytes,
    FormatSettings settings, std::vector<Text>* warnings)
{
    TableReadOptions options;
    options.settings = std::move(settings);
    AXISCOMP_TRY(auto reading, format.read(bytes, options));
    for (const Diagnostic& diagnostic : reading.diagnostics)
        if (diagnostic.severity == Severity::Error)
            return cannotHold(
                format.facts, textOf(diagnostic), AXISCOMP_TEXT("Error", "choose another format"));
        else if (warnings != nullptr)
            warnings->push_back(textOf(diagnostic));
    return std::move(reading.tables);
}

} // namespace axiscomp
