// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"
#include "core/text/character_set.h"
#include "core/text/diagnostic.h"
#include "core/text/line_reader.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

/// A piece of a line and where it stands.
struct Token {
    std::string_view text;
    std::size_t line = 0; ///< from 1
    std::size_t column = 0; ///< of its first character, from 1
    /// The end of the text that it is a piece of, up to which memory may be read; null: not known.
    const char* textEnd = nullptr;

    explicit operator bool() const { return !text.empty(); }
    /// At most count of the characters from begin on; begin <= text.size().
    [[nodiscard]] Token part(std::size_t begin, std::size_t count = std::string_view::npos) const
    {
        return {text.substr(begin, count), line, column + begin, textEnd};
    }
    [[nodiscard]] const char* readableEnd() const
    {
        return textEnd == nullptr ? text.data() + text.size() : textEnd;
    }
};

/// A token as a diagnostic shows it: an excerpt, and never a sentence of ours.
[[nodiscard]] Verbatim quoted(const Token& token);

/// The lines of a text, ended by LF, CRLF or CR, with their numbers. A byte-order mark is left out.
class TextLines {
public:
    explicit TextLines(std::string_view text);
    /// The next line without its end; nothing at the end of the text.
    [[nodiscard]] std::optional<Token> next();

private:
    LineReader m_lines;
};

/// The pieces of a line between any of the separators; empty pieces are left out.
void splitTokens(const Token& line, CharacterSet separators, std::vector<Token>& tokens);
/// The pieces between single separators, blanks round them cut off; empty pieces stay.
void splitCells(const Token& line, char separator, std::vector<Token>& cells);
/// Without blanks (space, tab) at both ends; the column moves with the text.
[[nodiscard]] Token trimmedToken(const Token& token);
/// What is left of the line before the comment character.
[[nodiscard]] Token withoutComment(const Token& line, CharacterSet commentCharacters);
/// What stands before the first of the separators.
[[nodiscard]] Token firstToken(const Token& line, CharacterSet separators);

/// Whether the whole token is a number, with a decimal point, and which; what is too small for a
/// double is 0.
[[nodiscard]] bool isNumber(const Token& token, double& value);
/// The same for a text; nothing when it is none.
[[nodiscard]] inline std::optional<double> numberOf(std::string_view text)
{
    double value = 0.0;
    return isNumber({text, 0, 0}, value) ? std::optional(value) : std::nullopt;
}
[[nodiscard]] std::optional<std::int64_t> wholeNumberOf(std::string_view text);

/// The error that says what was expected in place of the token.
void reportNotANumber(const Token& token, const TextPattern& expected, DiagnosticList& diagnostics);
/// The number; a token that is no finite number becomes an error that says what was expected.
[[nodiscard]] inline std::optional<double> readNumber(
    const Token& token, const TextPattern& expected, DiagnosticList& diagnostics)
{
    double value = 0.0;
    if (isNumber(token, value)) [[likely]]
        return value;
    reportNotANumber(token, expected, diagnostics);
    return std::nullopt;
}
[[nodiscard]] std::optional<double> readNumber(
    const Token& token, Text expected, DiagnosticList& diagnostics);
/// Adds a number for each token, 0 for those that become errors.
void readNumbers(std::span<const Token> tokens, const TextPattern& expected,
    std::vector<double>& numbers, DiagnosticList& diagnostics);
[[nodiscard]] std::optional<std::int64_t> readWholeNumber(
    const Token& token, Text expected, DiagnosticList& diagnostics);

/// Without the separators at its end: a spreadsheet gives each line those of the longest one.
[[nodiscard]] std::string_view withoutSeparators(std::string_view statement);

/// The same letters, upper or lower case (ASCII).
[[nodiscard]] bool sameLetters(std::string_view a, std::string_view b);
/// What stands behind a key such as "sign:" at the beginning of a text, in letters of either case
/// and with blanks before the colon or without; nothing: it begins otherwise.
[[nodiscard]] std::optional<std::string_view> behindKey(
    std::string_view text, std::string_view key);
/// What a comment states behind such a key, without the separators that a spreadsheet gives each
/// line; nothing: it states something else.
[[nodiscard]] std::optional<std::string_view> statedIn(
    std::string_view comment, std::string_view key);
/// In upper case (ASCII).
[[nodiscard]] std::string capitals(std::string_view text);

/// Refuses what is no text (binary files, UTF-16), or larger than the format's limit, before
/// anything is read.
[[nodiscard]] bool isReadableText(
    std::string_view text, std::size_t mostBytes, DiagnosticList& diagnostics);

/// Knots as a file has them: at least two, finite, strictly ascending; otherwise an error at the
/// line. lines: of each knot, or one for all, or none. axis: empty where there is only one.
[[nodiscard]] bool checkKnots(std::span<const double> knots, std::span<const std::size_t> lines,
    const Text& axis, DiagnosticList& diagnostics);

/// start + i * distance, i = 0 .. count - 1.
[[nodiscard]] std::vector<double> evenKnots(double start, double distance, std::size_t count);

} // namespace axiscomp
