// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/token_scanner.h"

#include "core/text/number_parser.h"
#include "core/text/number_text.h"
#include "core/text/text_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>
#include <utility>

namespace axiscomp {

namespace {

constexpr std::string_view blanks = " \t";
constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
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
    if (m_lines.atEnd())
        return std::nullopt;
    const std::size_t number = m_lines.lineNumber();
    return Token{m_lines.next(), number, 1};
}

void splitTokens(const Token& line, std::string_view separators, std::vector<Token>& tokens)
{
    tokens.clear();
    std::size_t begin = line.text.find_first_not_of(separators);
    while (begin != std::string_view::npos) {
        const std::size_t end =
            std::min(line.text.find_first_of(separators, begin), line.text.size());
        tokens.push_back({line.text.substr(begin, end - begin), line.line, line.column + begin});
        begin = line.text.find_first_not_of(separators, end);
    }
}

void splitCells(const Token& line, char separator, std::vector<Token>& cells)
{
    cells.clear();
    std::size_t begin = 0;
    while (begin <= line.text.size()) {
        const std::size_t end = std::min(line.text.find(separator, begin), line.text.size());
        cells.push_back(
            trimmedToken({line.text.substr(begin, end - begin), line.line, line.column + begin}));
        begin = end + 1;
    }
}

Token trimmedToken(const Token& token)
{
    const std::size_t first = std::min(token.text.find_first_not_of(blanks), token.text.size());
    return {trimmed(token.text), token.line, token.column + first};
}

Token withoutComment(const Token& line, std::string_view commentCharacters)
{
    const std::size_t end = std::min(line.text.find_first_of(commentCharacters), line.text.size());
    return {line.text.substr(0, end), line.line, line.column};
}

std::optional<double> numberOf(std::string_view text)
{
    Number number;
    const NumberFault fault = parseNumber(text, '.', number);
    if (fault == NumberFault::TooSmall)
        return 0.0;
    return fault == NumberFault::None ? std::optional(number.value) : std::nullopt;
}

std::optional<long> wholeNumberOf(std::string_view text)
{
    if (text.starts_with('+') && !text.starts_with("+-"))
        text.remove_prefix(1);
    long number = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number);
    const bool isWhole = read.ec == std::errc{} && read.ptr == end;
    return isWhole ? std::optional(number) : std::nullopt;
}

std::optional<double> readNumber(const Token& token, Text expected, DiagnosticList& diagnostics)
{
    const auto number = numberOf(token.text);
    if (!number)
        diagnostics.error(DiagnosticCode::NotANumber, token.line, token.column, quoted(token),
            std::move(expected));
    return number;
}

std::optional<long> readWholeNumber(const Token& token, Text expected, DiagnosticList& diagnostics)
{
    const auto number = wholeNumberOf(token.text);
    if (!number)
        diagnostics.error(DiagnosticCode::NotANumber, token.line, token.column, quoted(token),
            std::move(expected));
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
