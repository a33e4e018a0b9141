// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/reference_lines.h"

#include "core/metrology/fine_quantity.h"
#include "core/table/position_unit.h"
#include "core/text/number_text.h"
#include "core/text/text_file.h"
#include "core/text/token_scanner.h"
#include "core/text/utf8.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace axiscomp {

namespace {

bool isLineDigit(char c)
{
    return c >= '0' && c <= '9';
}

std::string shownLine(std::string_view line)
{
    constexpr std::size_t mostShown = 60;
    return '"' + shownText(line, mostShown) + '"';
}

InstrumentReading noPosition(Text text)
{
    InstrumentReading reading;
    reading.problem = std::move(text);
    return reading;
}

InstrumentReading noNumber(std::string_view line)
{
    return noPosition(AXISCOMP_TEXT("Error",
        "the instrument says {line}, where a number is expected; a pattern says where it is")
                          .with("line", shownLine(line)));
}

InstrumentReading tooLong(std::size_t longest)
{
    return noPosition(AXISCOMP_TEXT("Error",
        "the instrument sends a line of more than {count} characters: check its settings and its "
        "speed")
                          .with("count", longest));
}

/// Any of the signs that programs print or people paste for a minus: hyphens and dashes too.
bool isMinusCharacter(std::uint32_t code)
{
    constexpr std::array<std::uint32_t, 5> others{0x2212, 0x207B, 0xFE58, 0xFE63, 0xFF0D};
    constexpr std::uint32_t firstDash = 0x2010;
    constexpr std::uint32_t lastDash = 0x2015;
    return (code >= firstDash && code <= lastDash)
        || std::ranges::find(others, code) != others.end();
}

/// Blanks of any width, what has none, and the control characters that frame a line (STX, ETX).
bool isBlankCharacter(std::uint32_t code)
{
    constexpr std::array<std::pair<std::uint32_t, std::uint32_t>, 9> blanks{
        {{0x00, 0x20}, {0x7F, 0xA0}, {0x1680, 0x1680}, {0x2000, 0x200F}, {0x2028, 0x2029},
            {0x202F, 0x202F}, {0x205F, 0x2060}, {0x3000, 0x3000}, {0xFEFF, 0xFEFF}}};
    return std::ranges::any_of(
        blanks, [code](const auto& range) { return range.first <= code && code <= range.second; });
}

std::size_t lengthOfBlanks(std::string_view text)
{
    std::size_t length = 0;
    while (length < text.size()) {
        const auto [code, bytes] = firstCharacter(text.substr(length));
        if (!isBlankCharacter(code))
            break;
        length += bytes;
    }
    return length;
}

/// With one plain character for each of a kind.
std::string withPlain(char plain, bool (*isOfKind)(std::uint32_t), std::string_view line)
{
    std::string result;
    while (!line.empty()) {
        const auto [code, length] = firstCharacter(line);
        if (isOfKind(code))
            result += plain;
        else
            result += line.substr(0, length);
        line.remove_prefix(length);
    }
    return result;
}

/// Many an instrument has the micro sign, the degree sign and its dashes in Windows-1252.
std::string inUtf8(std::string_view line)
{
    const bool isOther = findInvalidUtf8(line) != std::string_view::npos
        && line.find('\0') == std::string_view::npos; // which would end it
    return isOther ? toUtf8(line, Encoding::Windows1252) : std::string(line);
}

bool isSign(char c)
{
    return c == '-' || c == '+';
}

/// "-     0.0035" as "-0.0035": displays have the sign in the first place, and the number at the
/// right.
std::string withSignsAtNumbers(std::string_view line)
{
    std::string close;
    for (std::size_t i = 0; i < line.size(); ++i) {
        close += line[i];
        if (!isSign(line[i]))
            continue;
        const std::size_t next = i + 1 + lengthOfBlanks(line.substr(i + 1));
        if (next < line.size() && (isLineDigit(line[next]) || line[next] == '.'))
            i = next - 1;
    }
    return close;
}

/// Of the first number in a line; empty: there is none.
std::string_view firstNumber(std::string_view line)
{
    const auto isStart = [&](std::size_t i) {
        return isLineDigit(line[i])
            || (line[i] == '.' && i + 1 < line.size() && isLineDigit(line[i + 1]));
    };
    std::size_t begin = 0;
    while (begin < line.size() && !isStart(begin))
        ++begin;
    if (begin == line.size())
        return {};
    std::size_t end = begin;
    const auto digits = [&] {
        while (end < line.size() && isLineDigit(line[end]))
            ++end;
    };
    digits();
    if (end < line.size() && line[end] == '.') {
        ++end;
        digits();
    }
    const std::size_t exponent = end;
    if (end < line.size() && (line[end] == 'e' || line[end] == 'E')) {
        ++end;
        if (end < line.size() && (line[end] == '+' || line[end] == '-'))
            ++end;
        const std::size_t first = end;
        digits();
        if (end == first)
            end = exponent;
    }
    if (begin > 0 && isSign(line[begin - 1]))
        --begin;
    return line.substr(begin, end - begin);
}

std::string_view withoutBlanksInFront(std::string_view text)
{
    return text.substr(std::min(text.find_first_not_of(' '), text.size()));
}

/// The word behind a number, up to a blank or what ends a field.
std::string_view wordBehind(std::string_view rest)
{
    rest = withoutBlanksInFront(rest);
    return rest.substr(0, rest.find_first_of(" ,;|"));
}

/// Whether the next number follows with no more than a blank or a mark of degrees and minutes in
/// between, as in "24°35'29.4", "24 35 29.4" and "24:35:29.4", with a sign or without: taken for
/// itself the first one is another position. Degrees with a decimal point have no minutes.
bool isFollowedByNumber(std::string_view number, std::string_view rest)
{
    rest = withoutBlanksInFront(rest);
    constexpr std::array<std::string_view, 3> degreeMarks{"\u00b0", "deg", "d"};
    constexpr std::array<std::string_view, 3> otherMarks{"'", "\"", ":"};
    const auto skipMark = [&](std::string_view mark) {
        const bool isThere = rest.starts_with(mark);
        rest.remove_prefix(isThere ? mark.size() : 0);
        return isThere;
    };
    if (std::ranges::any_of(degreeMarks, skipMark)) {
        if (number.find('.') != std::string_view::npos)
            return false;
    } else {
        static_cast<void>(std::ranges::any_of(otherMarks, skipMark));
    }
    rest = withoutBlanksInFront(rest);
    const std::size_t first = rest.find_first_not_of("+-.");
    return first != std::string_view::npos && isLineDigit(rest[first]);
}

bool isLineLetter(char c)
{
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

bool isBeyondAscii(char c)
{
    return static_cast<unsigned char>(c) >= 0x80U;
}

/// Whether a number, with its sign, may begin behind this: a blank that no sign stands before, a
/// separator, and for one with a sign also a name, as in "A-3.5". "X1", "/84.5" and "-+56.5" hold
/// something else, or a part of a number.
bool mayStandBefore(std::string_view before, std::string_view number)
{
    constexpr std::string_view separators = ":=;|,\"";
    const bool isApart = before.ends_with(' ');
    before = before.substr(0, before.find_last_not_of(' ') + 1);
    if (before.empty())
        return true;
    const std::string_view word = before.substr(before.find_last_of(' ') + 1);
    const char last = word.back();
    const bool isNamed = std::ranges::any_of(word, isLineLetter);
    if (isSign(last) || (!isNamed && word.find_first_of("+-") != std::string_view::npos))
        return false;
    const bool isSeparated = separators.find(last) != std::string_view::npos;
    if (isApart)
        return isNamed || isSeparated;
    if (word == ",") // ",5" is half of one
        return false;
    return isSeparated || (isSign(number[0]) && isLineLetter(last));
}

/// Whether a number may end before this: a unit, a separator, or a blank and a word without digits
/// that is no unit of another kind. In "7_000", "12.3#45", "34.5e mm" and "0x10" it goes on.
bool mayStandBehind(std::string_view rest)
{
    constexpr std::string_view separators = ",;|}";
    const std::string_view word = wordBehind(rest);
    const std::string_view next = withoutBlanksInFront(rest);
    if (next.empty() || isPositionUnit(word) || separators.find(next[0]) != std::string_view::npos)
        return true;
    const bool isWord = std::ranges::any_of(word, isLineLetter) && !isSign(word[0])
        && std::ranges::none_of(word, [](char c) { return isLineDigit(c) || isBeyondAscii(c); });
    return rest[0] == ' ' && isWord && !looksLikeUnknownUnit(word);
}

/// Why the first number of a line is not taken; empty: it stands by itself.
Text doubtAboutNumber(std::string_view before, std::string_view number, std::string_view rest)
{
    if (rest.size() > 1 && rest[0] == ',' && isLineDigit(rest[1]))
        return AXISCOMP_TEXT("Error",
            "the instrument says {line}: its number has a comma; set it to a decimal point, or "
            "say what the number is with a pattern");
    if (isFollowedByNumber(number, rest))
        return AXISCOMP_TEXT("Error",
            "the instrument says {line}: another number follows its first one, as in degrees, "
            "minutes and seconds; set it to one decimal number, or say what the number is with a "
            "pattern");
    if (!mayStandBefore(before, number) || !mayStandBehind(rest))
        return AXISCOMP_TEXT("Error",
            "the instrument says {line}: it is not clear where its number begins and ends; set it "
            "to one decimal number and its unit, or say what the number is with a pattern");
    return {};
}

} // namespace

ReferenceLineReader::ReferenceLineReader(
    ReferenceScale scale, std::string wanted, NumberFinder finder)
    : m_scale(std::move(scale))
    , m_wanted(std::move(wanted))
    , m_finder(std::move(finder))
{
}

Result<ReferenceLineReader> ReferenceLineReader::make(
    ReferenceScale scale, bool isAngular, NumberFinder finder)
{
    const std::string wanted = isAngular ? "deg" : "mm";
    if (!scale.unit.empty() && !unitFactor(scale.unit, wanted))
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "the instrument is in {unit}, which cannot be converted to {planned}, the unit "
                    "of the plan: state the unit of the instrument")
                    .with("unit", scale.unit)
                    .with("planned", wanted)}});
    return ReferenceLineReader(std::move(scale), wanted, std::move(finder));
}

/// What the pattern says, and the sign that it leaves in front of it: "[-+]?[0-9.]+" takes one only
/// where it touches the digits.
std::string ReferenceLineReader::foundByPattern(std::string_view line) const
{
    std::string number = m_finder(line);
    const std::string close = m_finder(withSignsAtNumbers(line));
    if (!number.empty() && !close.empty() && isSign(close[0])
        && std::string_view(close).substr(1) == number)
        number = close;
    number = withSignsAtNumbers(number);
    if (number.find('.') == std::string::npos && std::ranges::count(number, ',') == 1)
        std::ranges::replace(number, ',', '.');
    return number;
}

ReferenceLineReader::Found ReferenceLineReader::find(std::string_view said) const
{
    const auto withPlainSigns = [](std::string_view line) {
        return withPlain('-', isMinusCharacter, line);
    };
    if (m_finder)
        return {{}, foundByPattern(withPlainSigns(said)), {}};
    const std::string line = withPlainSigns(inUtf8(said));
    const std::string close = withSignsAtNumbers(withPlain(' ', isBlankCharacter, line));
    const std::string_view number = firstNumber(close);
    if (number.empty())
        return {};
    const auto begin = static_cast<std::size_t>(number.data() - close.data());
    return {close.substr(0, begin), std::string(number), close.substr(begin + number.size())};
}

InstrumentReading ReferenceLineReader::read(std::string_view line) const
{
    const Found found = find(line);
    const auto number = numberOf(found.number);
    if (!number)
        return noNumber(line);
    Text doubt = doubtAboutNumber(found.before, found.number, found.rest);
    if (!doubt.isEmpty())
        return noPosition(std::move(doubt).with("line", shownLine(line)));
    const std::string_view word = wordBehind(found.rest);
    const std::string said = isPositionUnit(word) ? std::string(word) : std::string();
    if (said.empty() && m_scale.unit.empty())
        return noPosition(AXISCOMP_TEXT(
            "Error", "the instrument says {line} without a unit: state the unit, such as mm")
                              .with("line", shownLine(line)));
    const bool isOther = !said.empty() && !m_scale.unit.empty() && !isSameUnit(said, m_scale.unit);
    const auto factor = unitFactor(said.empty() ? m_scale.unit : said, m_wanted);
    if (isOther || !factor)
        return noPosition(AXISCOMP_TEXT("Error",
            "the instrument says {line}, in another unit than {unit}: set the instrument, or "
            "begin a new file with the right unit")
                              .with("line", shownLine(line))
                              .with("unit", m_scale.unit.empty() ? m_wanted : m_scale.unit));
    const double position = m_scale.position(*number, *factor);
    return std::isfinite(position) ? InstrumentReading{position, {}} : noNumber(line);
}

void ReferenceLines::beginWithinLine()
{
    m_line.clear();
    m_isWithinLine = true;
}

void ReferenceLines::feed(std::string_view bytes, std::chrono::nanoseconds now)
{
    for (const char c : bytes) {
        if (c == '\n' || c == '\r')
            take(now);
        else if (m_line.size() <= longestLine)
            m_line += c;
    }
}

void ReferenceLines::take(std::chrono::nanoseconds now)
{
    std::string line = std::exchange(m_line, {});
    if (std::exchange(m_isWithinLine, false) || !trimmedToken({line, 0, 1}))
        return;
    m_last = std::move(line);
    m_time = now;
}

InstrumentReading ReferenceLines::at(std::chrono::nanoseconds now) const
{
    if (m_time && now >= *m_time && now - *m_time <= m_longestAge)
        return m_last.size() > longestLine ? tooLong(longestLine) : m_reader.read(m_last);
    return noPosition(AXISCOMP_TEXT("Error",
        "the instrument says nothing: look whether it sends, and whether its "
        "lines end"));
}

TypedReference::TypedReference(
    ReferenceLineReader reader, std::span<const CapturedValue> taken, double window)
    : m_reader(std::move(reader))
    , m_window(window)
{
    takeBack(taken);
}

void TypedReference::takeBack(std::span<const CapturedValue> left)
{
    m_seen.reset();
    forget();
    for (const CapturedValue& value : left)
        taken(value);
}

double TypedReference::differenceOf(const CapturedValue& value)
{
    return std::abs(value.deviation + value.step.target - value.encoder - value.output);
}

void TypedReference::taken(const CapturedValue& value)
{
    m_seen = std::max(m_seen.value_or(0.0), differenceOf(value));
    forget();
}

void TypedReference::forget()
{
    m_position.reset();
    m_doubted.reset();
}

Text TypedReference::type(std::string_view line, const CaptureReading& axis, bool isAngular)
{
    const InstrumentReading read = m_reader.read(line);
    if (!read.problem.isEmpty())
        return read.problem;
    constexpr double times = 10.0;
    const double difference = std::abs(read.position - axis.encoder - axis.output);
    const double limit = times * std::max(m_seen.value_or(times * m_window), m_window);
    if (difference > limit && m_doubted != read.position) {
        m_doubted = read.position;
        return (m_seen ? AXISCOMP_TEXT("Error",
                    "{position} is {difference} from the encoder, and until now it was {seen} at "
                    "most: type it once more if it is right, or another number")
                       : AXISCOMP_TEXT("Error",
                           "{position} is {difference} from the encoder: type it once more if it "
                           "is right, or another number"))
            .with("position", placeOf(read.position, isAngular))
            .with("difference", fineQuantity(difference, isAngular))
            .with("seen", fineQuantity(m_seen.value_or(0.0), isAngular));
    }
    m_doubted.reset();
    m_position = read.position;
    return {};
}

InstrumentReading TypedReference::reading() const
{
    InstrumentReading reading;
    if (m_position)
        reading.position = *m_position;
    else
        reading.problem = AXISCOMP_TEXT("Error", "the position of the instrument is asked for");
    return reading;
}

} // namespace axiscomp
