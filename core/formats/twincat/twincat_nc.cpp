// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/format_reader.h"
#include "core/formats/format_writer.h"
#include "core/formats/formats.h"
#include "core/formats/own_axis.h"
#include "core/text/number_text.h"
#include "core/text/text_file.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace axiscomp::twincat_nc {

namespace {

constexpr std::size_t mostElements = 1'000'000;
constexpr std::string_view parameterType = "ST_PositionCompensationTableParameter";
constexpr std::string_view elementType = "ST_PositionCompensationTableElement";
constexpr std::string_view nameKey = "name";

constexpr std::array<std::string_view, 2> extensions{".txt", ".st"};
constexpr std::array settings{
    FormatSetting{.key = nameKey,
        .kind = FormatSetting::Kind::Text,
        .meaning = AXISCOMP_TEXT(
            "Error", "what the variables are called: letters, digits and _, a letter first"),
        .standard = "PositionCompensation",
        .forWriting = true},
};
constexpr std::array<std::string_view, 6> rules{
    "Structured text for MC_TableBasedPositionCompensation: a variable of the type "
    "ST_PositionCompensationTableParameter, and an array of ST_PositionCompensationTableElement "
    "with "
    "a Position and a Compensation each; in the older library fPos and fCompensation, without "
    "brackets round the elements.",
    "Positions increase and are evenly spaced; the first is MinPosition, the last MaxPosition, and "
    "NoOfTableElements says how many there are.",
    "Comments stand in (* and *), or behind //.",
    "The compensation value is added to the position that is not corrected, such as the set "
    "position.",
    "Position Correction of the axis must be on; Ramp limits its speed.",
    "Numbers are in units of the axis, which the text does not say.",
};
constexpr std::array<std::string_view, 4> assumptions{
    "Two pages of the manual say that the correction is added to the target or nominal position, "
    "and "
    "a third one, of MC_PositionCorrectionLimiter, says to the actual position: the manual "
    "contradicts itself. Command is assumed, and must be stated.",
    "Outside of the table the value at that end is held; between the elements it is linear.",
    "With Modulo the table repeats after MaxPosition - MinPosition, and both ends have the same "
    "value.",
    "One table is written to a file; one that is read may hold several, each element array behind "
    "its "
    "parameters.",
};

bool isWordCharacter(char c)
{
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_'
        || c == '.' || c == '+' || c == '-' || c == '#';
}

/// Words, numbers and signs of a text without its comments: ":=" is one.
class Words {
public:
    explicit Words(std::string_view text) : m_lines(text) { }

    [[nodiscard]] std::optional<Token> next()
    {
        while (true) {
            m_rest = trimmedToken(m_rest);
            if (!m_rest) {
                const auto line = m_lines.next();
                if (!line)
                    return std::nullopt;
                m_rest = *line;
                continue;
            }
            if (m_isInComment) {
                const std::size_t end = m_rest.text.find("*)");
                m_isInComment = end == std::string_view::npos;
                drop(m_isInComment ? m_rest.text.size() : end + 2);
            } else if (m_rest.text.starts_with("(*")) {
                m_isInComment = true;
                drop(2);
            } else if (m_rest.text.starts_with("//")) {
                drop(m_rest.text.size());
            } else {
                return take();
            }
        }
    }

private:
    void drop(std::size_t count) { m_rest = m_rest.part(count); }
    [[nodiscard]] Token take()
    {
        std::size_t size = 0;
        while (size < m_rest.text.size() && isWordCharacter(m_rest.text[size]))
            ++size;
        if (size == 0)
            size = m_rest.text.starts_with(":=") ? 2 : 1;
        const Token word = m_rest.part(0, size);
        drop(size);
        return word;
    }

    TextLines m_lines;
    Token m_rest;
    bool m_isInComment = false;
};

struct Element {
    Token position;
    Token compensation;
};

/// The two variables of one table.
struct Definition {
    std::string name; ///< of the array
    std::string parameters; ///< name of their variable
    std::size_t line = 0; ///< of the type's name
    Token minimum = {};
    Token maximum = {};
    Token count = {};
    bool isModulo = false;
    std::vector<Element> elements = {};
    bool hasBrackets = false; ///< each element stands in brackets
    bool isNewElement = false; ///< a bracket has been opened
    bool isChanged = false; ///< by a statement behind the declaration
};

class Reader {
public:
    explicit Reader(TextReading& reading) : m_reading(reading), m_words(reading.text) { }
    [[nodiscard]] std::vector<NeutralTable> read();

private:
    enum class Inside { Nothing, Parameters, Elements };
    void begin(Inside inside, const Token& type);
    void assign(const Token& name, const Token& value);
    void assignParameter(const Token& name, const Token& value);
    void assignElement(const Token& name, const Token& value);
    void lookForChange(const Token& word);
    void checkComma(const Token& value, const Token& word);
    void checkEndOfValue(const Token& value, const Token& word);
    void scan();
    [[nodiscard]] NeutralTable table(const Definition& definition);
    [[nodiscard]] bool checkRange(const Definition& definition, const NeutralTable& table);

    TextReading& m_reading;
    DiagnosticList& m_diagnostics = m_reading.diagnostics;
    Words m_words;
    Inside m_inside = Inside::Nothing;
    bool m_isOpen = false; ///< the last definition has no elements yet
    bool m_isComplete = true; ///< the last declaration ended with a semicolon
    std::string m_declared; ///< the last variable before a colon
    std::vector<Definition> m_definitions;
    Token m_named; ///< variable of a definition, when only its index or member stands behind it
    std::size_t m_namedDefinition = 0;
    bool m_isInIndex = false;
};

void Reader::begin(Inside inside, const Token& type)
{
    m_inside = inside;
    m_isComplete = false;
    if (inside == Inside::Parameters) {
        m_definitions.push_back({{}, m_declared, type.line});
        m_isOpen = true;
        return;
    }
    if (!m_isOpen) {
        m_diagnostics.error(DiagnosticCode::Syntax, type.line, type.column, quoted(type),
            AXISCOMP_TEXT("Error", "a variable of the type {type} in front of the elements")
                .with("type", Verbatim{std::string(parameterType)}));
        m_definitions.push_back({{}, {}, type.line});
    }
    m_definitions.back().name = m_declared;
    m_isOpen = false;
}

bool isOneOf(const Token& name, std::initializer_list<std::string_view> names)
{
    return std::ranges::any_of(
        names, [&](std::string_view known) { return sameLetters(name.text, known); });
}

void Reader::assignParameter(const Token& name, const Token& value)
{
    Definition& definition = m_definitions.back();
    if (isOneOf(name, {"MinPosition", "fPosMin"})) {
        definition.minimum = value;
    } else if (isOneOf(name, {"MaxPosition", "fPosMax"})) {
        definition.maximum = value;
    } else if (isOneOf(name, {"NoOfTableElements"})) {
        definition.count = value;
    } else if (isOneOf(name, {"Modulo"})) {
        definition.isModulo = sameLetters(value.text, "TRUE");
        if (!definition.isModulo && !sameLetters(value.text, "FALSE"))
            m_diagnostics.error(DiagnosticCode::Syntax, value.line, value.column, quoted(value),
                AXISCOMP_TEXT("Error", "TRUE or FALSE"));
    } else if (isOneOf(name, {"Direction"})) {
        if (!sameLetters(value.text, "WorkDirectionBoth"))
            m_diagnostics.error(DiagnosticCode::Contradiction, value.line, value.column,
                quoted(value),
                AXISCOMP_TEXT("Error", "{value}: what another direction means is not known here")
                    .with("value", Verbatim{"WorkDirectionBoth"}));
    } else {
        m_diagnostics.warning(DiagnosticCode::UnknownKey, name.line, name.column, quoted(name), {});
    }
}

void Reader::assignElement(const Token& name, const Token& value)
{
    Definition& definition = m_definitions.back();
    std::vector<Element>& elements = definition.elements;
    const bool isPosition = isOneOf(name, {"Position", "fPos"});
    if (!isPosition && !isOneOf(name, {"Compensation", "fCompensation"})) {
        m_diagnostics.warning(DiagnosticCode::UnknownKey, name.line, name.column, quoted(name), {});
        return;
    }
    const auto numberOf = [&](Element& element) -> Token& {
        return isPosition ? element.position : element.compensation;
    };
    const bool isThere = !elements.empty() && numberOf(elements.back());
    if (definition.hasBrackets && !definition.isNewElement && isThere)
        m_diagnostics.error(DiagnosticCode::Contradiction, name.line, name.column, quoted(name),
            AXISCOMP_TEXT("Error", "one position and one compensation in each pair of brackets"));
    if (elements.empty() || (definition.hasBrackets ? definition.isNewElement : isThere))
        elements.emplace_back();
    definition.isNewElement = false;
    numberOf(elements.back()) = value;
}

void Reader::assign(const Token& name, const Token& value)
{
    if (m_inside == Inside::Parameters)
        assignParameter(name, value);
    else
        assignElement(name, value);
}

/// Outside of declarations: "stTab[2].Compensation := 0.5".
void Reader::lookForChange(const Token& word)
{
    if (word.text == "[" || word.text == "]") {
        m_isInIndex = word.text == "[";
        return;
    }
    if (m_named && word.text == ":=" && !m_definitions[m_namedDefinition].isChanged) {
        m_definitions[m_namedDefinition].isChanged = true;
        m_diagnostics.warning(DiagnosticCode::Assumption, m_named.line, m_named.column,
            AXISCOMP_TEXT("Error", "{name}, which is changed by a statement of the program")
                .with("name", quoted(m_named)),
            AXISCOMP_TEXT("Error",
                "the declaration alone; the table is that of the declaration, since statements are "
                "not computed"));
    }
    if (m_isInIndex || (m_named && word.text.starts_with('.')))
        return;
    m_named = {};
    const Token variable = word.part(0, word.text.find('.'));
    for (std::size_t n = 0; variable && n < m_definitions.size() && !m_named; ++n)
        if (isOneOf(variable, {m_definitions[n].name, m_definitions[n].parameters})) {
            m_named = variable;
            m_namedDefinition = n;
        }
}

/// Behind a value and a comma: of "0,1" the 0 alone would be another number.
void Reader::checkComma(const Token& value, const Token& word)
{
    if (word.text.front() >= '0' && word.text.front() <= '9')
        m_diagnostics.error(DiagnosticCode::NotANumber, value.line, value.column,
            Verbatim{
                excerpt(std::string(value.text) + ',' + std::string(word.text), Encoding::Utf8)},
            AXISCOMP_TEXT("Error", "a number with a decimal point"));
}

/// Behind a value: of "2*UM" the 2 alone would be another number.
void Reader::checkEndOfValue(const Token& value, const Token& word)
{
    if (!isOneOf(word, {",", ")", "]", ";"}))
        m_diagnostics.error(DiagnosticCode::Syntax, word.line, word.column, quoted(word),
            AXISCOMP_TEXT("Error", "a comma, a bracket or a semicolon behind the value \"{value}\"")
                .with("value", quoted(value)));
}

void Reader::scan()
{
    Token last;
    Token value; ///< directly before the word
    Token valueBeforeComma; ///< when the comma is directly before the word
    while (const auto word = m_words.next()) {
        if (m_reading.isStopped())
            return;
        if (m_inside == Inside::Nothing)
            lookForChange(*word);
        if (valueBeforeComma)
            checkComma(valueBeforeComma, *word);
        if (value)
            checkEndOfValue(value, *word);
        valueBeforeComma = word->text == "," ? value : Token{};
        value = {};
        if (sameLetters(word->text, parameterType)) {
            begin(Inside::Parameters, *word);
        } else if (sameLetters(word->text, elementType)) {
            begin(Inside::Elements, *word);
        } else if (word->text == "(" && m_inside == Inside::Elements) {
            m_definitions.back().hasBrackets = true;
            m_definitions.back().isNewElement = true;
            last = {};
            continue;
        } else if (word->text == ":") {
            m_declared = last.text;
        } else if (word->text == ";") {
            m_isComplete = m_isComplete || m_inside != Inside::Nothing;
            m_inside = Inside::Nothing;
        } else if (word->text == ":=" && m_inside != Inside::Nothing && last
            && isWordCharacter(last.text.front()) && !isOneOf(last, {parameterType, elementType})) {
            value = m_words.next().value_or(Token{{}, last.line, last.column});
            assign(last, value);
            last = {};
            continue;
        }
        last = *word;
    }
    if (!m_isComplete)
        m_diagnostics.error(DiagnosticCode::Syntax, last.line, 0,
            AXISCOMP_TEXT("Error", "a declaration without its end"),
            AXISCOMP_TEXT("Error", "a semicolon behind it"));
}

bool Reader::checkRange(const Definition& definition, const NeutralTable& table)
{
    const std::vector<double>& knots = table.axes[0].knots;
    const auto minimum =
        readNumber(definition.minimum, AXISCOMP_TEXT("Error", "the first position"), m_diagnostics);
    const auto maximum =
        readNumber(definition.maximum, AXISCOMP_TEXT("Error", "the last position"), m_diagnostics);
    const auto count = readWholeNumber(
        definition.count, AXISCOMP_TEXT("Error", "the number of elements"), m_diagnostics);
    if (!minimum || !maximum || !count)
        return false;
    if (*count != static_cast<std::int64_t>(knots.size())) {
        m_diagnostics.error(*count > static_cast<std::int64_t>(knots.size())
                ? DiagnosticCode::MissingPoint
                : DiagnosticCode::Contradiction,
            definition.count.line, definition.count.column,
            AXISCOMP_COUNTED("Error", "{count} elements", "1 element").with("count", knots.size()),
            AXISCOMP_TEXT("Error", "{value}, as {key} says")
                .with("value", *count)
                .with("key", Verbatim{"NoOfTableElements"}));
        return false;
    }
    const double rounding = 1e-9 * (std::abs(*minimum) + std::abs(*maximum));
    const bool fits = std::abs(knots.front() - *minimum) <= rounding
        && std::abs(knots.back() - *maximum) <= rounding;
    if (!fits)
        m_diagnostics.error(DiagnosticCode::Contradiction, definition.line, 0,
            AXISCOMP_TEXT("Error", "positions from {first} to {last}")
                .with("first", Quantity{toText(knots.front())})
                .with("last", Quantity{toText(knots.back())}),
            AXISCOMP_TEXT("Error", "from {first} to {last}, as MinPosition and MaxPosition say")
                .with("first", Quantity{toText(*minimum)})
                .with("last", Quantity{toText(*maximum)}));
    return fits;
}

NeutralTable Reader::table(const Definition& definition)
{
    NeutralTable table;
    table.name = definition.name;
    table.sign = SignConvention::Command;
    table.axes.resize(1);
    table.columns.resize(1);
    std::vector<std::size_t> lines;
    for (const Element& element : definition.elements) {
        const Token& place = element.position ? element.position : element.compensation;
        for (const Token& part : {element.position, element.compensation})
            if (!part)
                m_diagnostics.error(DiagnosticCode::Syntax, place.line, 0,
                    AXISCOMP_TEXT("Error", "an element of one number"),
                    AXISCOMP_TEXT("Error", "a position and a compensation"));
        if (m_diagnostics.hasErrors())
            return table;
        table.axes[0].knots.push_back(
            readNumber(element.position, AXISCOMP_TEXT("Error", "a position"), m_diagnostics)
                .value_or(0.0));
        table.columns[0].values.push_back(readNumber(
            element.compensation, AXISCOMP_TEXT("Error", "a compensation"), m_diagnostics)
                                              .value_or(0.0));
        lines.push_back(element.position.line);
    }
    if (lines.empty())
        m_diagnostics.error(DiagnosticCode::TooFewPoints, definition.line, 0,
            AXISCOMP_COUNTED("Error", "{count} elements", "1 element").with("count", 0),
            AXISCOMP_TEXT("Error", "at least 2"));
    if (m_diagnostics.hasErrors() || !checkKnots(table.axes[0].knots, lines, {}, m_diagnostics)
        || !checkRange(definition, table))
        return table;
    const SourceAxis& axis = table.axes[0];
    if (!isEven(axis))
        m_diagnostics.error(DiagnosticCode::UnevenSpacing, lines.front(), 0,
            AXISCOMP_TEXT("Error", "positions from {first} to {last}")
                .with("first", Quantity{toText(axis.knots.front())})
                .with("last", Quantity{toText(axis.knots.back())}),
            AXISCOMP_TEXT("Error", "equal distances"));
    if (definition.isModulo) {
        const std::vector<double>& values = table.columns[0].values;
        table.axes[0].wrap = axis.knots.back() - axis.knots.front();
        if (values.front() != values.back())
            m_diagnostics.error(DiagnosticCode::NotPeriodic, lines.back(), 0,
                AXISCOMP_TEXT("Error", "the values {first} and {last} at the ends")
                    .with("first", Quantity{toText(values.front())})
                    .with("last", Quantity{toText(values.back())}),
                AXISCOMP_TEXT("Error", "the same value at both ends, which are one place"));
    }
    return table;
}

std::vector<NeutralTable> Reader::read()
{
    scan();
    if (m_isOpen && !m_diagnostics.hasErrors())
        m_diagnostics.error(DiagnosticCode::Syntax, m_definitions.back().line, 0, {},
            AXISCOMP_TEXT("Error", "an array of {type} behind the parameters")
                .with("type", Verbatim{std::string(elementType)}));
    if (m_definitions.empty())
        m_diagnostics.error(DiagnosticCode::Syntax, 0, 0, {},
            AXISCOMP_TEXT("Error", "a variable of the type {type}")
                .with("type", Verbatim{std::string(parameterType)}));
    std::vector<NeutralTable> tables;
    for (const Definition& definition : m_definitions) {
        if (m_diagnostics.hasErrors())
            return {};
        tables.push_back(table(definition));
        if (tables.size() > 1) { // a unit that nobody says is said once
            DiagnosticList ignored(1);
            takeOneUnit(tables.back(), m_reading.settings, ignored);
        } else {
            takeOneUnit(tables.back(), m_reading.settings, m_diagnostics);
        }
    }
    return tables;
}

std::vector<NeutralTable> parse(TextReading& reading)
{
    return Reader(reading).read();
}

Result<TableReading> read(std::string_view text, const TableReadOptions& options)
{
    return readText(twincat_nc::format().facts, text, options, parse);
}

Recognition recognise(std::string_view text)
{
    Words words(text);
    while (const auto word = words.next())
        if (sameLetters(word->text, parameterType) || sameLetters(word->text, elementType))
            return Recognition::Certain;
    return Recognition::No;
}

bool isName(std::string_view name)
{
    const auto isLetter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); };
    return !name.empty() && isLetter(name.front()) && std::ranges::all_of(name, [&](char c) {
        return isLetter(c) || (c >= '0' && c <= '9') || c == '_';
    });
}

/// A number of the type LREAL, which has a point.
std::string realText(double number)
{
    std::string text = plainNumber(number);
    if (text.find('.') == std::string::npos)
        text += ".0";
    return text;
}

std::string textOf(const NeutralTable& table, const std::string& name)
{
    const std::vector<double>& knots = table.axes[0].knots;
    std::string text = "st" + name + "Parameter : " + std::string(parameterType)
        + " := (MinPosition:=" + realText(knots.front()) + ", MaxPosition:="
        + realText(knots.back()) + ", NoOfTableElements:=" + std::to_string(knots.size())
        + ", Direction:=WorkDirectionBoth, Modulo:=" + (table.axes[0].wrap ? "TRUE" : "FALSE")
        + ");\n";
    text += "st" + name + "Table : ARRAY[0.." + std::to_string(knots.size() - 1) + "] OF "
        + std::string(elementType) + " := [\n";
    for (std::size_t i = 0; i < knots.size(); ++i)
        text += "    (Position:=" + realText(knots[i]) + ", Compensation:="
            + realText(table.columns[0].values[i]) + (i + 1 < knots.size() ? "),\n" : ")\n");
    return text + "];\n";
}

Result<WrittenTables> write(std::span<const NeutralTable> tables, const TableWriteOptions& options)
{
    const FormatFacts& facts = twincat_nc::format().facts;
    AXISCOMP_TRY(const auto values, SettingValues::of(facts, options.settings, true));
    const std::string name = values.text(nameKey);
    if (!isName(name))
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "the setting name is \"{value}\", expected letters, digits and _, a letter "
                    "first")
                    .with("value", name)}});
    WrittenTables written;
    AXISCOMP_TRY(const auto table, asOwnAxisTable(facts, tables.front(), values, written.remarks));
    if (table.axes[0].wrap)
        AXISCOMP_CHECK(checkOnePeriod(facts, table, 0, 0.0));
    written.bytes = textOf(table, name);
    FormatSettings reading;
    if (!table.axes[0].unit.empty())
        reading["position-unit"] = table.axes[0].unit;
    AXISCOMP_TRY(auto held, readBack(twincat_nc::format(), written.bytes, std::move(reading)));
    written.held = std::move(held);
    written.remarks.emplace_back(AXISCOMP_TEXT("Error",
        "the manual contradicts itself on whether the correction is added to the nominal or to the "
        "actual position: check one point on the machine"));
    written.remarks.emplace_back(AXISCOMP_TEXT("Error",
        "switch Position Correction of the axis on; Ramp limits the speed of the correction"));
    return written;
}

} // namespace

const TableFormat& format()
{
    static const TableFormat format{
        .facts = {.name = "twincat-nc",
            .controller = "TwinCAT 3 NC PTP (Beckhoff)",
            .description =
                AXISCOMP_TEXT("Error", "structured text for MC_TableBasedPositionCompensation"),
            .extensions = extensions,
            .knots = KnotRule::Even,
            .mostPoints = mostElements,
            .holdsWrap = true,
            .numbers = "decimal text",
            .sign = SignConvention::Command,
            .signEvidence = Evidence::Assumed,
            .behaviour = {.outside = Outside::Hold},
            .outsideEvidence = Evidence::Assumed,
            .settings = settings,
            .rules = rules,
            .assumptions = assumptions},
        .recognise = recognise,
        .read = read,
        .write = write};
    return format;
}

} // namespace axiscomp::twincat_nc
