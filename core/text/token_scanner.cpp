// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/token_scanner.h"

#include "core/text/number_parser.h"
#include "core/text/number_text.h"
#include "core/text/text_file.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <span>
#include <utility>

namespace axiscomp {

namespace {

constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

bool isBlank(char c)
{
    return c == ' ' || c == '\t';
}

char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
}

[[gnu::noinline]] bool isAnyNumber(std::string_view text, double& value)
{
    const NumberFault fault = parseValue(text, value);
    if (fault == NumberFault::TooSmall)
        value = 0.0;
    return fault == NumberFault::None || fault == NumberFault::TooSmall;
}

void reportNoNumber(const Token& token, Text expected, DiagnosticList& diagnostics)
{
    diagnostics.error(
        DiagnosticCode::NotANumber, token.line, token.column, quoted(token), std::move(expected));
}

/// Calls visit(characters, their offset in the line, their number) for one block after the other.
template <typename Visit> void forEachBlock(const Token& line, Visit visit)
{
    for (std::size_t at = 0; at < line.text.size(); at += CharacterSet::blockSize)
        visit(line.text.data() + at, at, std::min(CharacterSet::blockSize, line.text.size() - at));
}

/// In its place: a token that was made elsewhere and copied took as long again as to find it.
inline void setToken(
    Token& token, std::string_view text, std::size_t line, std::size_t column, const char* textEnd)
{
    token.text = text;
    token.line = line;
    token.column = column;
    token.textEnd = textEnd;
}

inline void addPart(
    const Token& line, std::size_t begin, std::size_t end, std::vector<Token>& parts)
{
    setToken(parts.emplace_back(), {line.text.data() + begin, end - begin}, line.line,
        line.column + begin, line.textEnd);
}

inline void addTrimmed(
    const Token& line, std::size_t begin, std::size_t end, std::vector<Token>& parts)
{
    while (begin < end && isBlank(line.text[begin]))
        ++begin;
    while (begin < end && isBlank(line.text[end - 1]))
        --end;
    addPart(line, begin, end, parts);
}

} // namespace

Verbatim quoted(const Token& token)
{
    return {excerpt(token.text, Encoding::Utf8)};
}

TextLines::TextLines(std::string_view text)
    : m_lines(text.starts_with(byteOrderMark) ? text.substr(byteOrderMark.size()) : text)
{
}

std::optional<Token> TextLines::next()
{
    std::optional<Token> line;
    if (m_lines.atEnd())
        return line;
    const std::size_t number = m_lines.lineNumber();
    setToken(line.emplace(), m_lines.next(), number, 1, m_lines.end());
    return line;
}

void splitTokens(const Token& line, CharacterSet separators, std::vector<Token>& tokens)
{
    tokens.clear();
    std::size_t begin = 0;
    bool isInToken = false;
    forEachBlock(line, [&](const char* block, std::size_t offset, std::size_t count) {
        const std::uint64_t inside =
            ~separators.among(block, count, line.readableEnd()) & CharacterSet::lowestBits(count);
        // Set where a token begins or has ended.
        std::uint64_t edges = inside ^ (inside << 1U | std::uint64_t{isInToken});
        for (edges &= CharacterSet::lowestBits(count); edges != 0; edges &= edges - 1) {
            const std::size_t at = offset + static_cast<std::size_t>(std::countr_zero(edges));
            if (isInToken)
                addPart(line, begin, at, tokens);
            begin = at;
            isInToken = !isInToken;
        }
    });
    if (isInToken)
        addPart(line, begin, line.text.size(), tokens);
}

void splitCells(const Token& line, char separator, std::vector<Token>& cells)
{
    cells.clear();
    std::size_t begin = 0;
    const CharacterSet separators(separator);
    forEachBlock(line, [&](const char* block, std::size_t offset, std::size_t count) {
        std::uint64_t found = separators.among(block, count, line.readableEnd());
        for (; found != 0; found &= found - 1) {
            const std::size_t at = offset + static_cast<std::size_t>(std::countr_zero(found));
            addTrimmed(line, begin, at, cells);
            begin = at + 1;
        }
    });
    addTrimmed(line, begin, line.text.size(), cells);
}

Token trimmedToken(const Token& token)
{
    const std::string_view text = trimmed(token.text);
    return token.part(static_cast<std::size_t>(text.data() - token.text.data()), text.size());
}

Token withoutComment(const Token& line, CharacterSet commentCharacters)
{
    return firstToken(line, commentCharacters);
}

Token firstToken(const Token& line, CharacterSet separators)
{
    return line.part(0, separators.findIn(line.text, line.readableEnd()));
}

bool isNumber(const Token& token, double& value)
{
    const char* const begin = token.text.data();
    const char* const end = begin + token.text.size();
    constexpr std::size_t mostlyShort = 18; // of longer ones few are, and trying takes its time
    const bool mayBeShort = token.text.size() <= mostlyShort && token.textEnd != nullptr
        && token.textEnd - begin >= std::ptrdiff_t{shortNumberReach};
    Number number;
    if (mayBeShort && parseShortNumber(begin, '.', number) == end) {
        value = number.value;
        return true;
    }
    return isAnyNumber(token.text, value);
}

std::optional<std::int64_t> wholeNumberOf(std::string_view text)
{
    if (text.starts_with('+') && !text.starts_with("+-"))
        text.remove_prefix(1);
    std::int64_t number = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number);
    const bool isWhole = read.ec == std::errc{} && read.ptr == end;
    return isWhole ? std::optional(number) : std::nullopt;
}

void reportNotANumber(const Token& token, const TextPattern& expected, DiagnosticList& diagnostics)
{
    reportNoNumber(token, expected, diagnostics);
}

std::optional<double> readNumber(const Token& token, Text expected, DiagnosticList& diagnostics)
{
    double value = 0.0;
    if (isNumber(token, value))
        return value;
    reportNoNumber(token, std::move(expected), diagnostics);
    return std::nullopt;
}

void readNumbers(std::span<const Token> tokens, const TextPattern& expected,
    std::vector<double>& numbers, DiagnosticList& diagnostics)
{
    for (const Token& token : tokens) {
        double value = 0.0;
        if (!isNumber(token, value)) [[unlikely]]
            reportNoNumber(token, expected, diagnostics);
        numbers.push_back(value);
    }
}

std::optional<std::int64_t> readWholeNumber(
    const Token& token, Text expected, DiagnosticList& diagnostics)
{
    const auto number = wholeNumberOf(token.text);
    if (!number)
        reportNoNumber(token, std::move(expected), diagnostics);
    return number;
}

std::string capitals(std::string_view text)
{
    std::string large(text);
    for (char& c : large)
        c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
    return large;
}

bool sameLetters(std::string_view a, std::string_view b)
{
    return std::ranges::equal(a, b, {}, lower, lower);
}

std::optional<std::string_view> behindKey(std::string_view text, std::string_view key)
{
    const std::string_view word = key.substr(0, key.size() - 1);
    const std::size_t colon = text.find_first_not_of(" \t", std::min(word.size(), text.size()));
    if (!sameLetters(text.substr(0, word.size()), word) || colon == std::string_view::npos
        || text[colon] != key.back())
        return std::nullopt;
    return text.substr(colon + 1);
}

std::string_view withoutSeparators(std::string_view statement)
{
    return trimmed(statement.substr(0, statement.find_last_not_of(",; \t") + 1));
}

std::optional<std::string_view> statedIn(std::string_view comment, std::string_view key)
{
    const auto value = behindKey(trimmed(comment), key);
    if (!value)
        return std::nullopt;
    return withoutSeparators(*value);
}

bool isReadableText(std::string_view text, std::size_t mostBytes, DiagnosticList& diagnostics)
{
    if (text.size() > mostBytes) {
        diagnostics.error(DiagnosticCode::TooLarge, 0, 0,
            AXISCOMP_TEXT("Error", "{size} bytes").with("size", text.size()),
            AXISCOMP_TEXT("Error", "at most {size} bytes").with("size", mostBytes));
        return false;
    }
    const TextInspection inspection(text, {}, diagnostics);
    if (!diagnostics.hasErrors()
        && inspection.body().find_first_not_of(" \t\r\n") == std::string_view::npos)
        diagnostics.error(DiagnosticCode::EmptyFile, 0, 0, {}, {});
    return !diagnostics.hasErrors();
}

bool checkKnots(std::span<const double> knots, std::span<const std::size_t> lines, const Text& axis,
    DiagnosticList& diagnostics)
{
    const auto lineOf = [&](std::size_t i) {
        return lines.empty() ? 0 : lines[std::min(i, lines.size() - 1)];
    };
    if (knots.size() < 2) {
        diagnostics.error(DiagnosticCode::TooFewPoints, lineOf(0), 0,
            (axis.isEmpty() ? AXISCOMP_COUNTED("Error", "{count} positions", "1 position")
                            : AXISCOMP_COUNTED(
                                "Error", "{count} positions of {axis}", "1 position of {axis}"))
                .with("count", knots.size())
                .with("axis", axis),
            AXISCOMP_TEXT("Error", "at least 2"));
        return false;
    }
    for (std::size_t i = 1; i < knots.size(); ++i) {
        if (knots[i] > knots[i - 1] && std::isfinite(knots[i] - knots.front()))
            continue;
        diagnostics.error(DiagnosticCode::NotMonotonic, lineOf(i), 0,
            AXISCOMP_TEXT("Error", "{number} after {number2}")
                .with("number", Quantity{toText(knots[i])})
                .with("number2", Quantity{toText(knots[i - 1])}),
            (axis.isEmpty() ? AXISCOMP_TEXT("Error", "strictly increasing positions")
                            : AXISCOMP_TEXT("Error", "strictly increasing positions of {axis}"))
                .with("axis", axis));
        return false;
    }
    return true;
}

std::vector<double> evenKnots(double start, double distance, std::size_t count)
{
    std::vector<double> knots(count);
    for (std::size_t i = 0; i < count; ++i)
        knots[i] = start + static_cast<double>(i) * distance;
    return knots;
}

} // namespace axiscomp
