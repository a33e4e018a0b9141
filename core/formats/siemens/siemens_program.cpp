// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/siemens/siemens_program.h"

#include "core/text/number_text.h"
#include "core/text/text_file.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace axiscomp::siemens {

namespace {

Verbatim quoted(std::string_view text)
{
    return {excerpt(text, Encoding::Utf8)};
}

/// "$AN_CEC_STEP"
std::string nameOf(const Curve& curve, Curve::Variable variable)
{
    return curve.prefix + std::string(variableNames[variable]);
}

/// Of a curve.
Text about(const Curve& curve, const TextPattern& pattern)
{
    return pattern.with("curve", curve.label);
}

bool isNameCharacter(char c)
{
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
}

Token rest(const Token& token, std::size_t from)
{
    const std::size_t at = std::min(from, token.text.size());
    return trimmedToken(token.part(at));
}

/// Without a block number "N10 " in front.
Token withoutBlockNumber(const Token& line)
{
    const std::string_view text = line.text;
    if (text.size() < 2 || (text[0] != 'N' && text[0] != 'n'))
        return line;
    const std::size_t end = text.find_first_not_of("0123456789", 1);
    const bool isNumber = end != std::string_view::npos && end > 1
        && (text[end] == ' ' || text[end] == '\t' || text[end] == '$');
    return isNumber ? rest(line, end) : line;
}

/// The name of an axis stands alone, in brackets or in quotation marks.
Token bare(Token value)
{
    for (const std::string_view pair : {"()", "\"\""}) {
        const std::string_view text = value.text;
        if (text.size() >= 2 && text.front() == pair[0] && text.back() == pair[1])
            value = trimmedToken(value.part(1, text.size() - 2));
    }
    return value;
}

/// The 802D writes [0.1] for [0,1].
void splitAtPoint(std::vector<Token>& arguments)
{
    const Token whole = trimmedToken(arguments.front());
    const std::size_t point = whole.text.find('.');
    if (point == std::string_view::npos || !wholeNumberOf(whole.text.substr(0, point))
        || !wholeNumberOf(whole.text.substr(point + 1)))
        return;
    arguments = {whole.part(0, point), whole.part(point + 1)};
}

/// False: not of this form; the problem is reported.
bool readAssignment(const Token& line, Assignment& said, DiagnosticList& diagnostics)
{
    const auto refuse = [&](std::size_t at, Text expected) {
        const Token found = rest(line, at);
        diagnostics.error(DiagnosticCode::Syntax, found.line, found.column, quoted(found.text),
            std::move(expected));
        return false;
    };
    std::size_t i = 1;
    while (i < line.text.size() && isNameCharacter(line.text[i]))
        ++i;
    said.name = line.part(0, i);
    const Token behindName = rest(line, i);
    if (!behindName.text.starts_with('['))
        return refuse(i, AXISCOMP_TEXT("Error", "an index in [ ] behind the name"));
    const std::size_t close = behindName.text.find(']');
    if (close == std::string_view::npos)
        return refuse(i, AXISCOMP_TEXT("Error", "an index that ends in ]"));
    splitCells(behindName.part(1, close - 1), ',', said.arguments);
    if (said.arguments.size() == 1)
        splitAtPoint(said.arguments);
    for (Token& argument : said.arguments)
        argument = bare(argument);
    const Token behindIndex = rest(behindName, close + 1);
    if (!behindIndex.text.starts_with('='))
        return refuse(behindIndex.column - line.column,
            AXISCOMP_TEXT("Error", "= and a value behind the index"));
    said.value = bare(rest(behindIndex, 1));
    if (!said.value)
        return refuse(line.text.size(), AXISCOMP_TEXT("Error", "a value behind ="));
    return true;
}

bool isEnd(std::string_view text)
{
    return std::ranges::any_of(std::array{"M17", "M30", "M02", "M2", "RET"},
        [&](std::string_view end) { return sameLetters(text, end); });
}

/// What people put round the assignments to load and activate them: it says nothing of the table.
bool isAside(std::string_view text)
{
    const std::string_view word = text.substr(0, text.find_first_of(" \t("));
    if (word.size() >= 2 && (word[0] == 'M' || word[0] == 'm') && wholeNumberOf(word.substr(1)))
        return true;
    return std::ranges::any_of(std::array{"NEWCONF", "STOPRE", "MSG", "G4", "G04"},
        [&](std::string_view aside) { return sameLetters(word, aside); });
}

bool isFrame(std::string_view text)
{
    constexpr std::string_view channel = "CHANDATA";
    const bool isChannel = text.size() > channel.size()
        && sameLetters(text.substr(0, channel.size()), channel) && text.back() == ')';
    return isChannel || text.front() == '%';
}

} // namespace

bool readProgram(const TextReading& reading, std::vector<std::string>& notes,
    const std::function<void(const Assignment&)>& visit)
{
    TextLines lines(reading.text);
    Assignment said;
    bool hasEnded = false;
    while (const auto whole = lines.next()) {
        if (reading.isStopped())
            return false;
        const Token line = withoutBlockNumber(trimmedToken(withoutComment(*whole, ";")));
        if (!line && trimmedToken(*whole).text.starts_with(';'))
            keepNote(notes, trimmedToken(*whole).text.substr(1));
        if (!line)
            continue;
        if (isFrame(line.text)) {
            hasEnded = false; // an archive may hold several programs
        } else if (isAside(line.text) && !isEnd(line.text)) {
            continue;
        } else if (hasEnded) {
            reading.diagnostics.error(DiagnosticCode::Syntax, line.line, line.column,
                quoted(line.text),
                AXISCOMP_TEXT("Error", "nothing behind the end of the program, M17"));
            return true;
        } else if (line.text.front() == '$') {
            if (readAssignment(line, said, reading.diagnostics))
                visit(said);
        } else if (isEnd(line.text)) {
            hasEnded = true;
        } else {
            reading.diagnostics.error(DiagnosticCode::Syntax, line.line, line.column,
                quoted(line.text),
                AXISCOMP_TEXT("Error", "an assignment such as $NAME[0,1]=0.5, CHANDATA(1) or M17"));
        }
    }
    return true;
}

std::optional<bool> yesOrNo(std::string_view value)
{
    const auto number = numberOf(value);
    if (number == 1.0 || sameLetters(value, "TRUE"))
        return true;
    if (number == 0.0 || sameLetters(value, "FALSE"))
        return false;
    return std::nullopt;
}

bool Switches::take(const Assignment& said, std::string_view name, std::size_t argumentCount)
{
    if (!sameLetters(said.name.text, name) || said.arguments.size() != argumentCount)
        return false;
    std::string key = capitals(name);
    for (const Token& argument : said.arguments)
        key += ' ' + capitals(argument.text);
    const char* const begin = said.name.text.data(); // of the line, as its pieces are
    const char* const end = said.value.text.data() + said.value.text.size();
    Token statement = said.name;
    statement.text = {begin, static_cast<std::size_t>(end - begin)};
    const bool isOff = yesOrNo(said.value.text) == false;
    m_switches[key] = {statement, said.name, isOff};
    return true;
}

void Switches::check(std::string_view name, std::initializer_list<std::string_view> arguments,
    DiagnosticList& diagnostics)
{
    std::string key = capitals(name);
    for (const std::string_view argument : arguments)
        key += ' ' + capitals(argument);
    const auto found = m_switches.find(key);
    if (found != m_switches.end() && found->second.isOff
        && !std::exchange(found->second.isOfTable, true))
        warnOfSwitchedOff(found->second.statement, diagnostics);
}

void Switches::reportOthers(DiagnosticList& diagnostics) const
{
    for (const auto& [key, other] : m_switches)
        if (other.isOff && !other.isOfTable)
            diagnostics.warning(DiagnosticCode::UnknownKey, other.name.line, other.name.column,
                quoted(other.name.text), {});
}

Recognition recogniseProgram(std::string_view text, std::string_view own, std::string_view other)
{
    const auto begins = [](std::string_view line, std::string_view name) {
        return line.size() > name.size() && sameLetters(line.substr(0, name.size()), name)
            && (line[name.size()] == '[' || line[name.size()] == '_' || line[name.size()] == ' ');
    };
    bool hasOwn = false;
    bool hasOther = false;
    TextLines lines(text);
    while (const auto whole = lines.next()) {
        const Token line = withoutBlockNumber(trimmedToken(*whole));
        hasOwn = hasOwn || begins(line.text, own);
        hasOther = hasOther || begins(line.text, other);
    }
    if (!hasOwn)
        return Recognition::No;
    return hasOther ? Recognition::Possible : Recognition::Certain;
}

Curve::Variable variableOf(std::string_view suffix)
{
    for (std::size_t i = 0; i < std::size(variableNames); ++i)
        if (sameLetters(suffix, variableNames[i]))
            return static_cast<Curve::Variable>(i);
    return Curve::variableCount;
}

void setVariable(
    Curve& curve, Curve::Variable variable, const Assignment& said, DiagnosticList& diagnostics)
{
    const auto number = readNumber(said.value, AXISCOMP_TEXT("Error", "a number"), diagnostics);
    if (curve.variables[variable]) {
        diagnostics.error(DiagnosticCode::Contradiction, said.name.line, said.name.column,
            about(curve, AXISCOMP_TEXT("Error", "{variable} of {curve} a second time"))
                .with("variable", said.name.text),
            AXISCOMP_TEXT("Error", "each variable once; the first is in line {line}")
                .with("line", curve.lines[variable]));
        return;
    }
    curve.variables[variable] = number.value_or(0.0);
    curve.lines[variable] = said.name.line;
}

void addPoint(Curve& curve, const Token& index, const Token& value, DiagnosticList& diagnostics)
{
    constexpr TextPattern pointNumber = AXISCOMP_TEXT("Error", "the number of a point, from 0");
    const auto n = readWholeNumber(index, pointNumber, diagnostics);
    const auto number =
        readNumber(value, AXISCOMP_TEXT("Error", "a compensation value"), diagnostics);
    if (n && *n < 0)
        diagnostics.error(
            DiagnosticCode::Syntax, index.line, index.column, quoted(index.text), pointNumber);
    else if (n)
        curve.points.push_back({*n, number.value_or(0.0), index.line, index.column});
}

namespace {

/// The number of points that MIN, MAX and STEP say.
std::optional<std::size_t> pointCount(const Curve& curve, DiagnosticList& diagnostics)
{
    bool isComplete = true;
    for (const auto variable : {Curve::Step, Curve::Min, Curve::Max}) {
        if (curve.variables[variable])
            continue;
        isComplete = false;
        diagnostics.error(DiagnosticCode::Syntax, 0, 0, {},
            about(curve, AXISCOMP_TEXT("Error", "{variable} of {curve}, which is missing"))
                .with("variable", nameOf(curve, variable)));
    }
    if (!isComplete)
        return std::nullopt;
    const double min = curve.value(Curve::Min);
    const double max = curve.value(Curve::Max);
    const double step = curve.value(Curve::Step);
    const double last = (max - min) / step;
    const Text found =
        about(curve, AXISCOMP_TEXT("Error", "MIN {min}, MAX {max} and STEP {step} of {curve}"))
            .with("min", Quantity{toText(min)})
            .with("max", Quantity{toText(max)})
            .with("step", Quantity{toText(step)});
    if (!(step > 0.0) || !(max > min) || !(last < 1e9)) {
        diagnostics.error(DiagnosticCode::LimitExceeded, curve.lines[Curve::Step], 0, found,
            AXISCOMP_TEXT("Error", "a STEP above 0 and a MAX above MIN"));
        return std::nullopt;
    }
    if (std::abs(last - std::round(last)) > 1e-9 + 1e-6 * last || last < 0.5) {
        diagnostics.error(DiagnosticCode::Contradiction, curve.lines[Curve::Max], 0, found,
            AXISCOMP_TEXT("Error", "a whole number of steps from MIN to MAX"));
        return std::nullopt;
    }
    return static_cast<std::size_t>(std::llround(last)) + 1;
}

/// Every point once, in order.
std::optional<std::vector<double>> pointValues(
    const Curve& curve, std::size_t count, DiagnosticList& diagnostics)
{
    // No more than the file has is ever allocated: one of the first points is missing.
    const std::size_t seenSize = std::min(count, curve.points.size() + 1);
    std::vector<bool> seen(seenSize, false);
    std::vector<double> values(seenSize);
    bool isGood = true;
    for (const Curve::Point& point : curve.points) {
        const auto n = static_cast<std::size_t>(point.index);
        if (n >= count) {
            isGood = false;
            diagnostics.error(DiagnosticCode::Contradiction, point.line, point.column,
                about(curve, AXISCOMP_TEXT("Error", "point {number} of {curve}"))
                    .with("number", point.index),
                AXISCOMP_TEXT("Error", "points up to {number}, which MIN, MAX and STEP give")
                    .with("number", count - 1));
        } else if (n < seenSize && seen[n]) {
            isGood = false;
            diagnostics.error(DiagnosticCode::DuplicatePoint, point.line, point.column,
                about(curve, AXISCOMP_TEXT("Error", "point {number} of {curve} a second time"))
                    .with("number", point.index),
                AXISCOMP_TEXT("Error", "each point once"));
        } else if (n < seenSize) {
            seen[n] = true;
            values[n] = point.value;
        }
    }
    const auto hole = std::ranges::find(seen, false);
    if (hole != seen.end()) {
        diagnostics.error(DiagnosticCode::MissingPoint, 0, 0,
            about(curve, AXISCOMP_TEXT("Error", "no point {number} of {curve}"))
                .with("number", hole - seen.begin()),
            AXISCOMP_TEXT(
                "Error", "{number} points, which MIN, MAX and STEP give; there are {number2}")
                .with("number", count)
                .with("number2", curve.points.size()));
        return std::nullopt;
    }
    return isGood ? std::optional(std::move(values)) : std::nullopt;
}

std::optional<bool> isModulo(const Curve& curve, DiagnosticList& diagnostics)
{
    const std::string name = nameOf(curve, Curve::IsModulo);
    if (!curve.variables[Curve::IsModulo])
        diagnostics.warning(DiagnosticCode::Assumption, 0, 0,
            about(curve, AXISCOMP_TEXT("Error", "no {variable} of {curve}")).with("variable", name),
            AXISCOMP_TEXT("Error", "0 or 1; 0 is assumed"));
    const double value = curve.value(Curve::IsModulo);
    if (value == 0.0 || value == 1.0)
        return value == 1.0;
    diagnostics.error(DiagnosticCode::LimitExceeded, curve.lines[Curve::IsModulo], 0,
        Verbatim{name + ' ' + toText(value)}, AXISCOMP_TEXT("Error", "0 or 1"));
    return std::nullopt;
}

/// Even from MIN to MAX, also where STEP is rounded, such as 33.3333 for a third of 100.
std::vector<double> positionsOf(const Curve& curve, std::size_t count)
{
    const double min = curve.value(Curve::Min);
    const double max = curve.value(Curve::Max);
    const double step = curve.value(Curve::Step);
    const auto steps = static_cast<double>(count - 1);
    const double rounding =
        4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(min), std::abs(max));
    const bool endsAtMax = std::abs(min + steps * step - max) <= rounding;
    auto positions = evenKnots(min, endsAtMax ? step : (max - min) / steps, count);
    positions.back() = max;
    return positions;
}

} // namespace

std::optional<Sampled> sample(const Curve& curve, DiagnosticList& diagnostics)
{
    const auto count = pointCount(curve, diagnostics);
    const auto wraps = isModulo(curve, diagnostics);
    if (!count || !wraps)
        return std::nullopt;
    auto values = pointValues(curve, *count, diagnostics);
    if (!values)
        return std::nullopt;
    Sampled sampled;
    sampled.axis.knots = positionsOf(curve, *count);
    sampled.values = std::move(*values);
    if (*wraps) {
        sampled.axis.wrap = curve.value(Curve::Max) - curve.value(Curve::Min);
        if (sampled.values.front() != sampled.values.back())
            diagnostics.warning(DiagnosticCode::NotPeriodic, curve.lines[Curve::IsModulo], 0,
                about(curve, AXISCOMP_TEXT("Error", "{number} at MAX of {curve}"))
                    .with("number", Quantity{toText(sampled.values.back())}),
                AXISCOMP_TEXT("Error", "{number}, as at MIN, which follows it")
                    .with("number", Quantity{toText(sampled.values.front())}));
    }
    if (!checkKnots(sampled.axis.knots, {}, curve.label, diagnostics))
        return std::nullopt;
    return sampled;
}

std::string unitOf(const SettingValues& settings, const std::string& axis, bool isModulo)
{
    const std::string names = settings.text("rotary-axes");
    std::vector<Token> rotary;
    splitTokens({names, 0, 0}, ", ", rotary);
    const bool isRotary = std::ranges::any_of(
        rotary, [&](const Token& name) { return sameLetters(name.text, axis); });
    return isModulo || isRotary ? "deg" : "mm";
}

Result<std::string> axisName(const FormatFacts& facts, const SettingValues& settings,
    std::string_view key, const std::string& name)
{
    const std::string wanted = settings.has(key) ? settings.text(key) : name;
    const bool isName = !wanted.empty() && wanted.size() <= 32
        && std::ranges::all_of(wanted, isNameCharacter) && !(wanted[0] >= '0' && wanted[0] <= '9');
    if (isName)
        return wanted;
    return fail(ErrorCode::InvalidArgument,
        {{"reason",
            AXISCOMP_TEXT("Error",
                "\"{axis}\" is no axis name for the format {format}, such as X1; give the setting "
                "{key}")
                .with("axis", wanted)
                .with("format", facts.name)
                .with("key", key)}});
}

std::string gridLines(const SourceAxis& axis, std::string_view prefix, std::string_view subject)
{
    const double span = axis.knots.back() - axis.knots.front();
    const double step = span / static_cast<double>(axis.knots.size() - 1);
    const std::array values{plainNumber(step), plainNumber(axis.knots.front()),
        plainNumber(axis.knots.back()), std::string(axis.wrap ? "1" : "0")};
    std::string text;
    for (std::size_t i = 0; i < values.size(); ++i)
        text.append(prefix)
            .append(variableNames[i])
            .append("[")
            .append(subject)
            .append("]=")
            .append(values[i])
            .append("\n");
    return text;
}

Result<void> checkModulo(const FormatFacts& facts, const NeutralTable& table)
{
    if (!table.axes.front().wrap)
        return {};
    if (table.axes.front().unit != "deg")
        return cannotHold(facts, AXISCOMP_TEXT("Error", "its modulo axis is not rotary"),
            AXISCOMP_TEXT("Error", "treat the axis as linear (--no-wrap)"));
    return checkOnePeriod(facts, table, 0, 0.0);
}

} // namespace axiscomp::siemens
