// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/target_axis.h"

#include "core/table/compensation_table.h"
#include "core/text/number_parser.h"
#include "core/text/text_file.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>

namespace axiscomp {

namespace {

constexpr std::array<std::string_view, 9> positionWords{
    "position", "pos", "axis", "achse", "encoder", "reference", "referenz", "commanded", "soll"};
constexpr std::array<std::string_view, 14> errorWords{"error", "err", "deviation", "dev",
    "correction", "corr", "compensation", "comp", "offset", "axis", "achse", "fehler", "abweichung",
    "korrektur"};

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

/// The letters of machine axes (ISO 841), with a number or without: X, Y2, C.
bool isAxisLetter(std::string_view word)
{
    constexpr std::string_view letters = "XYZABCUVWxyzabcuvw";
    return !word.empty() && word.size() <= 3 && letters.find(word.front()) != std::string_view::npos
        && std::ranges::all_of(word.substr(1), isDigit);
}

bool isAxisNumber(std::string_view word)
{
    return !word.empty() && word.size() <= 3 && std::ranges::all_of(word, isDigit);
}

std::vector<std::string_view> wordsOf(std::string_view header)
{
    constexpr std::string_view separators = " \t-_.:";
    std::vector<std::string_view> words;
    while (true) {
        const std::size_t begin = header.find_first_not_of(separators);
        if (begin == std::string_view::npos)
            return words;
        header.remove_prefix(begin);
        const std::size_t end = std::min(header.find_first_of(separators), header.size());
        words.push_back(header.substr(0, end));
        header.remove_prefix(end);
    }
}

/// The only word that is not one of these.
std::string_view onlyOtherWord(std::string_view header, std::span<const std::string_view> expected)
{
    std::string_view found;
    for (const std::string_view word : wordsOf(header)) {
        const bool isExpected = std::ranges::any_of(
            expected, [&](std::string_view known) { return sameLetters(word, known); });
        if (isExpected)
            continue;
        if (!found.empty())
            return {};
        found = word;
    }
    return found;
}

std::string joined(std::span<const std::string_view> words)
{
    std::string text;
    for (const std::string_view word : words)
        text.append(text.empty() ? "" : " ").append(word);
    return text;
}

bool isAxisCalled(std::string_view name, std::string_view axis)
{
    const std::string called = joined(wordsOf(axis));
    return !called.empty() && sameLetters(joined(wordsOf(name)), called);
}

/// The words that are not among the expected ones. Several without one of these are a title. A
/// number or a letter behind a word counts columns ("Error 2", "Error B"), as a letter alone may
/// do; before the word they name an axis ("B error").
std::string nameBeside(std::string_view header, std::span<const std::string_view> expected)
{
    const std::vector<std::string_view> words = wordsOf(header);
    std::vector<std::string_view> others;
    std::ranges::copy_if(words, std::back_inserter(others), [&](std::string_view word) {
        return std::ranges::none_of(
            expected, [&](std::string_view known) { return sameLetters(word, known); });
    });
    const bool isTitle = others.size() > 1 && others.size() == words.size();
    if (others.empty() || isTitle)
        return {};
    const std::string_view name = others.front();
    const bool isBehind = name != words.front();
    const bool isCount =
        (isAxisNumber(name) && isBehind) || (mayBeCounted(name) && (isBehind || words.size() == 1));
    return isCount ? std::string() : joined(others);
}

/// "Z" of "dZ", "DZ" and of a capital delta before the letter.
std::string_view withoutDelta(std::string_view word)
{
    for (const std::string_view delta : {"d", "D", "\u0394", "\u2206"})
        if (word.starts_with(delta) && isAxisLetter(word.substr(delta.size())))
            return word.substr(delta.size());
    return word;
}

/// The letter of the axis that a column of values is named by.
std::string_view letterInHeader(std::string_view header)
{
    const std::string_view word = withoutDelta(onlyOtherWord(header, errorWords));
    return isAxisLetter(word) ? word : std::string_view();
}

/// Nothing but U, V or W.
bool isSymbolOfValues(std::string_view header, std::string_view word)
{
    constexpr std::string_view linear = "XYZxyz";
    return trimmed(header) == word && word.size() == 1 && isAxisLetter(word)
        && linear.find(word.front()) == std::string_view::npos;
}

std::optional<std::size_t> sourceNumber(std::string_view statement)
{
    if (statement.size() != 2 || statement.front() != '#' || statement[1] < '1'
        || statement[1] > '3')
        return std::nullopt;
    return static_cast<std::size_t>(statement[1] - '1');
}

std::optional<std::size_t> sourceNamed(std::string_view name, std::span<const std::string> sources)
{
    const auto source = std::ranges::find_if(
        sources, [&](const std::string& known) { return sameLetters(known, name); });
    if (source == sources.end())
        return std::nullopt;
    return static_cast<std::size_t>(source - sources.begin());
}

} // namespace

bool areDifferentAxes(std::string_view one, std::string_view other)
{
    const std::string_view a = trimmed(one);
    const std::string_view b = trimmed(other);
    return isAxisLetter(a) && isAxisLetter(b) && !sameLetters(a.substr(0, 1), b.substr(0, 1));
}

bool correctsAnotherAxis(std::string_view target, std::string_view positions)
{
    return target == otherAxis || areDifferentAxes(axisInHeader(target), axisInHeader(positions));
}

bool namesAnotherAxis(
    std::string_view name, std::string_view meant, std::span<const std::string> others)
{
    return !isAxisCalled(name, meant) && std::ranges::any_of(others, [&](const std::string& other) {
        return isAxisCalled(name, other);
    });
}

bool mayBeCounted(std::string_view header)
{
    constexpr std::string_view counted = "ABCabc";
    return header.size() == 1 && counted.find(header.front()) != std::string_view::npos;
}

std::string sourceTarget(std::size_t source)
{
    return '#' + std::to_string(source + 1);
}

std::optional<TargetAxis> targetAxis(
    std::string_view statement, std::span<const std::string> sources)
{
    if (statement.empty())
        return std::nullopt;
    if (statement == otherAxis)
        return TargetAxis{};
    if (const auto number = sourceNumber(statement)) {
        if (*number >= sources.size())
            return std::nullopt;
        return TargetAxis{*number};
    }
    if (const auto named = sourceNamed(statement, sources))
        return TargetAxis{*named};
    if (std::ranges::any_of(sources, &std::string::empty))
        return std::nullopt;
    return TargetAxis{};
}

std::optional<TargetAxis> targetOf(const CompensationTable& table)
{
    std::vector<std::string> sources;
    for (const GridAxis& axis : table.grid.axes)
        sources.push_back(axis.name);
    return targetAxis(table.target, sources);
}

std::string targetName(const CompensationTable& table)
{
    const auto meant = targetOf(table);
    return meant && meant->source ? table.grid.axes[*meant->source].name : table.target;
}

bool isStatedSource(const CompensationTable& table, std::size_t source)
{
    return !table.isTargetOfDrive && table.target == sourceTarget(source);
}

std::string_view axisInHeader(std::string_view header)
{
    const std::string_view word = onlyOtherWord(header, positionWords);
    return isAxisLetter(word) || isAxisNumber(word) ? word : std::string_view();
}

std::string targetAmong(std::string_view statement, std::span<const std::string> headers)
{
    if (statement.empty() || statement == otherAxis)
        return std::string(statement);
    if (const auto number = sourceNumber(statement))
        return *number < headers.size() ? std::string(statement) : std::string();
    if (const auto named = sourceNamed(statement, headers))
        return headers[*named];
    bool areAxes = true;
    for (const std::string& header : headers) {
        const std::string_view axis = axisInHeader(header);
        if (sameLetters(axis, statement))
            return header;
        areAxes = areAxes && !axis.empty();
    }
    return areAxes ? std::string(statement) : std::string();
}

std::string targetInHeader(std::string_view header, std::span<const std::string> sourceHeaders)
{
    const std::string_view word = letterInHeader(header);
    if (word.empty())
        return {};
    std::string target = targetAmong(word, sourceHeaders);
    return mayBeCounted(word) && target == word && !sourceNamed(word, sourceHeaders) ? std::string()
                                                                                     : target;
}

std::string statedOrInHeader(
    std::string statement, std::string_view header, std::span<const std::string> sourceHeaders)
{
    return statement.empty() ? targetInHeader(header, sourceHeaders) : statement;
}

std::string_view axisOfColumn(std::string_view header)
{
    const std::string_view word = letterInHeader(header);
    return mayBeCounted(word) || isSymbolOfValues(header, word) ? std::string_view() : word;
}

std::string nameInPositions(std::string_view header)
{
    return nameBeside(header, positionWords);
}

std::string nameInValues(std::string_view header)
{
    const std::string name = nameBeside(header, errorWords);
    if (isSymbolOfValues(header, name))
        return {};
    return std::string(withoutDelta(name));
}

std::string portableTarget(std::string_view statement, std::span<const std::string> headers)
{
    const auto meant = targetAxis(statement, headers);
    const std::string same = targetAmong(statement, headers);
    const bool isList = same.find(',') != std::string::npos;
    if (!meant || (!isList && !same.empty() && targetAxis(same, headers) == meant))
        return same;
    return meant->source ? sourceTarget(*meant->source) : std::string(otherAxis);
}

std::optional<std::string_view> targetInComment(std::string_view comment)
{
    const auto statement = behindKey(comment, "target:");
    return statement && !statement->empty() ? statement : std::nullopt;
}

std::vector<std::string> targetList(std::string_view text)
{
    std::vector<std::string> statements;
    while (true) {
        const std::size_t comma = std::min(text.find(','), text.size());
        statements.emplace_back(trimmed(text.substr(0, comma)));
        if (comma == text.size())
            return statements;
        text.remove_prefix(comma + 1);
    }
}

} // namespace axiscomp
