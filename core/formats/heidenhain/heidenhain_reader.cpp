// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/portable_math.h"
#include "core/formats/heidenhain/heidenhain_file.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <cmath>

namespace axiscomp::heidenhain {

namespace {

constexpr std::string_view begin = "BEGIN AXIS";
constexpr std::string_view datumWord = "DATUM:";
constexpr std::string_view distanceWord = "DISTANCE:";
constexpr double positionAllowance = 0.00005; // half of the last decimal

bool contains(std::string_view text, std::string_view part)
{
    return capitals(text).find(part) != std::string::npos;
}

bool isFirstLine(std::string_view line)
{
    return capitals(line).starts_with(begin) && contains(line, ".COM");
}

bool hasGrid(std::string_view line)
{
    return contains(line, datumWord) && contains(line, distanceWord);
}

/// The number behind a word of the first line, blanks between allowed.
std::optional<double> numberBehind(
    const Token& line, std::string_view word, DiagnosticList& diagnostics)
{
    const std::size_t at = capitals(line.text).find(word) + word.size();
    const Token rest = trimmedToken(line.part(at));
    const std::size_t end = std::min(rest.text.find_first_of(" \t"), rest.text.size());
    return readNumber(rest.part(0, end),
        AXISCOMP_TEXT("Error", "a number in mm or degrees behind {word}").with("word", word),
        diagnostics);
}

/// "Y" of "BEGIN AXIS_Y.COM" and "BEGIN AXIS-Y.COM"; empty: another name.
std::string axisInName(std::string_view line)
{
    const std::string name = capitals(line).substr(begin.size());
    const bool isOne = name.size() > 2 && (name[0] == '_' || name[0] == '-') && name[2] == '.'
        && name[1] >= 'A' && name[1] <= 'Z';
    return isOne ? name.substr(1, 1) : std::string();
}

/// 0.0001 where all positions are multiples of it, as they are with four decimals.
double stepOf(std::span<const double> positions)
{
    const double perUnit = portable::pow(10.0, decimals);
    const bool areMultiples = std::ranges::all_of(positions, [perUnit](double position) {
        const double exact = position * perUnit;
        return std::abs(exact - std::round(exact)) <= 1e-6;
    });
    return areMultiples ? 1.0 / perUnit : 0.0;
}

struct Header {
    enum class Kind { Number, Position, Backlash, Axis, Unknown };
    Token name;
    Kind kind = Kind::Unknown;
};

struct Row {
    Token number;
    Token position;
    std::vector<Token> values; ///< of each header; empty: none
};

/// A column of an axis while its values are collected.
struct Column {
    std::string axis;
    std::vector<double> positions;
    std::vector<double> values;
    std::vector<std::size_t> lines;
    std::vector<std::int64_t> numbers;
};

class FileReader {
public:
    FileReader(TextReading& source, Layout layout)
        : m_source(source)
        , m_diagnostics(source.diagnostics)
        , m_layout(layout)
    {
    }

    [[nodiscard]] std::vector<NeutralTable> tables();

private:
    [[nodiscard]] bool isEven() const { return m_layout == Layout::EvenPositions; }
    void error(DiagnosticCode code, const Token& at, Text expected)
    {
        m_diagnostics.error(code, at.line, at.column, quoted(at), std::move(expected));
    }
    [[nodiscard]] bool readLines();
    void take(const Token& line);
    void takeFirstLine(const Token& line);
    void takeAxis(const Token& line);
    void takeUnit(const Token& line);
    void takeHeaders(const Token& line);
    void takeRow(const Token& line);
    [[nodiscard]] bool hasTab(const Token& line);
    [[nodiscard]] std::size_t headerOf(const Token& token) const;
    [[nodiscard]] bool place(const Token& token, Row& row);
    [[nodiscard]] std::optional<double> positionOf(const Row& row);
    void takeValues(const Row& row, double position);
    void checkEnd();
    void checkRotary();
    void checkSlopes();
    [[nodiscard]] bool checkColumns();

    TextReading& m_source;
    DiagnosticList& m_diagnostics;
    Layout m_layout;
    Token m_first;
    std::string m_axis;
    std::string m_lengthUnit = "mm";
    double m_datum = 0.0;
    double m_distance = 0.0;
    std::vector<Header> m_headers;
    std::vector<Column> m_columns; ///< of the headers that are axes, in their order
    std::vector<Token> m_tokens;
    std::optional<std::int64_t> m_lastNumber;
    std::size_t m_rows = 0;
    std::size_t m_backlashes = 0;
    Token m_backlash; ///< the first value there
    bool m_hasEnded = false;
};

/// The axis is that of the name, unless a setting says another one.
void FileReader::takeAxis(const Token& line)
{
    const std::string named = axisInName(line.text);
    const std::string said = capitals(m_source.settings.text(movingAxis.key));
    m_axis = said.empty() ? named : said;
    if (!said.empty() && (said.size() != 1 || said[0] < 'A' || said[0] > 'Z'))
        m_diagnostics.error(DiagnosticCode::Contradiction, line.line, 0,
            AXISCOMP_TEXT("Error", "the setting {key} {value}")
                .with("key", movingAxis.key)
                .with("value", m_source.settings.text(movingAxis.key)),
            AXISCOMP_TEXT("Error", "one letter"));
    else if (m_axis.empty())
        m_diagnostics.error(DiagnosticCode::Syntax, line.line, line.column, quoted(line),
            AXISCOMP_TEXT("Error",
                "the moving axis, as in AXIS_Y; its letter as the setting {key} where the file "
                "has another name")
                .with("key", movingAxis.key));
    else if (!said.empty() && !named.empty() && said != named)
        m_diagnostics.warning(DiagnosticCode::Assumption, line.line, line.column,
            AXISCOMP_TEXT("Error", "axis {axis} in the name of the file").with("axis", named),
            AXISCOMP_TEXT("Error", "axis {axis}, as the setting {key} says")
                .with("axis", said)
                .with("key", movingAxis.key));
}

/// MM or INCH at the end; the older layout may have none, which is mm.
void FileReader::takeUnit(const Token& line)
{
    splitTokens(line, " \t", m_tokens);
    const auto isWord = [&](std::string_view word) {
        return std::ranges::any_of(
            m_tokens, [word](const Token& token) { return sameLetters(token.text, word); });
    };
    if (isWord("INCH"))
        m_lengthUnit = "inch";
    else if (!isWord("MM") && !isEven())
        m_diagnostics.warning(DiagnosticCode::UnitNotGiven, line.line, 0,
            AXISCOMP_TEXT("Error", "a first line without MM"),
            AXISCOMP_TEXT("Error", "MM or INCH; mm is assumed"));
}

void FileReader::takeFirstLine(const Token& line)
{
    m_first = line;
    if (!isFirstLine(line.text)) {
        error(DiagnosticCode::Syntax, line,
            AXISCOMP_TEXT("Error", "a first line such as {example}")
                .with("example",
                    Verbatim{isEven() ? "BEGIN AXIS-Y.COM DATUM:-90.0000 DISTANCE:+6.5536"
                                      : "BEGIN AXIS_Y.COM MM"}));
        return;
    }
    if (hasGrid(line.text) != isEven()) {
        error(DiagnosticCode::Syntax, line,
            AXISCOMP_TEXT("Error", "the format {format} to read it")
                .with("format",
                    (isEven() ? heidenhain_com::format() : heidenhain_com_530::format())
                        .facts.name));
        return;
    }
    takeAxis(line);
    takeUnit(line);
    if (!isEven())
        return;
    m_datum = numberBehind(line, datumWord, m_diagnostics).value_or(0.0);
    const auto distance = numberBehind(line, distanceWord, m_diagnostics);
    m_distance = distance.value_or(1.0);
    if (!(m_distance > 0.0))
        m_diagnostics.error(DiagnosticCode::LimitExceeded, line.line, line.column,
            AXISCOMP_TEXT("Error", "a distance of {distance}")
                .with("distance", Quantity{toText(m_distance)}),
            AXISCOMP_TEXT("Error", "a distance above 0"));
}

/// Columns count characters, which a tab is not.
bool FileReader::hasTab(const Token& line)
{
    const std::size_t tab = line.text.find('\t');
    if (tab == std::string_view::npos)
        return false;
    m_diagnostics.error(DiagnosticCode::Syntax, line.line, line.column + tab,
        AXISCOMP_TEXT("Error", "a tab"),
        AXISCOMP_TEXT("Error", "blanks, since the columns are counted in characters"));
    return true;
}

void FileReader::takeHeaders(const Token& line)
{
    if (hasTab(line))
        return;
    splitTokens(line, " ", m_tokens);
    for (const Token& name : m_tokens) {
        Header header{name, Header::Kind::Unknown};
        const char c = name.text.front();
        const bool isLetter = (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
        if (sameLetters(name.text, "NR"))
            header.kind = Header::Kind::Number;
        else if (sameLetters(name.text, "AXISPOS") && !isEven())
            header.kind = Header::Kind::Position;
        else if (sameLetters(name.text, "BACKLASH"))
            header.kind = Header::Kind::Backlash;
        else if (name.text.size() == 1 && isLetter)
            header.kind = Header::Kind::Axis;
        else
            m_diagnostics.warning(
                DiagnosticCode::UnknownKey, name.line, name.column, quoted(name), {});
        const auto isSame = [&](const Header& other) {
            return sameLetters(other.name.text, name.text);
        };
        if (std::ranges::any_of(m_headers, isSame))
            error(DiagnosticCode::Contradiction, name, AXISCOMP_TEXT("Error", "each column once"));
        m_headers.push_back(header);
        if (header.kind == Header::Kind::Axis)
            m_columns.push_back({capitals(name.text), {}, {}, {}, {}});
    }
    const bool hasPosition =
        isEven() || (m_headers.size() > 1 && m_headers[1].kind == Header::Kind::Position);
    if (m_headers.front().kind != Header::Kind::Number || !hasPosition || m_columns.empty())
        error(DiagnosticCode::Syntax, line,
            AXISCOMP_TEXT("Error", "a line of headers such as {example}")
                .with("example", Verbatim{isEven() ? "NR X Y Z" : "NR AXISPOS BACKLASH X Y Z"}));
}

/// The header that begins last at or before a token; the number of headers: there is none.
std::size_t FileReader::headerOf(const Token& token) const
{
    std::size_t found = m_headers.size();
    for (std::size_t n = 0; n < m_headers.size(); ++n)
        if (m_headers[n].name.column <= token.column)
            found = n;
    return found;
}

bool FileReader::place(const Token& token, Row& row)
{
    const std::size_t n = headerOf(token);
    const auto kind = n < m_headers.size() ? m_headers[n].kind : Header::Kind::Unknown;
    const bool isFirst = kind == Header::Kind::Number;
    // The older layout has no header for the position.
    Token* const place = n == m_headers.size() ? nullptr
        : isFirst && !row.number               ? &row.number
        : isFirst && isEven()                  ? &row.position
        : kind == Header::Kind::Position       ? &row.position
        : isFirst                              ? nullptr
                                               : &row.values[n];
    // A value that begins before the header of its column would be one of the column before.
    const bool isBeside = n + 1 < m_headers.size() && m_headers[n].name.column != token.column
        && m_headers[n + 1].name.column < token.column + token.text.size();
    if (place && !*place && !isBeside) {
        *place = token;
        return true;
    }
    error(DiagnosticCode::Syntax, token,
        AXISCOMP_TEXT("Error", "a value below the header of an axis, and one in each column"));
    return false;
}

/// Nothing: an error.
std::optional<double> FileReader::positionOf(const Row& row)
{
    const auto number =
        readWholeNumber(row.number, AXISCOMP_TEXT("Error", "the number of a line"), m_diagnostics);
    const auto position =
        readNumber(row.position, AXISCOMP_TEXT("Error", "a position"), m_diagnostics);
    if (!number || !position)
        return std::nullopt;
    if (*number < 0 || (m_lastNumber && *number <= *m_lastNumber)) {
        error(DiagnosticCode::NotMonotonic, row.number,
            AXISCOMP_TEXT("Error", "ascending numbers from 0"));
        return std::nullopt;
    }
    m_lastNumber = number;
    if (!isEven())
        return position;
    const double due = m_datum + static_cast<double>(*number) * m_distance;
    if (std::abs(*position - due) <= positionAllowance * 1.000001)
        return due;
    error(DiagnosticCode::Contradiction, row.position,
        AXISCOMP_TEXT("Error", "{position}, as DATUM and DISTANCE say for line {number}")
            .with("position", Quantity{fixedDigits(due, decimals)})
            .with("number", *number));
    return std::nullopt;
}

void FileReader::takeValues(const Row& row, double position)
{
    std::size_t column = 0;
    for (std::size_t n = 0; n < m_headers.size(); ++n) {
        const bool isAxis = m_headers[n].kind == Header::Kind::Axis;
        const Token& token = row.values[n];
        if (token && m_headers[n].kind == Header::Kind::Backlash) {
            m_backlash = m_backlashes == 0 ? token : m_backlash;
            ++m_backlashes;
        }
        if (isAxis && token)
            if (const auto value = readNumber(
                    token, AXISCOMP_TEXT("Error", "a compensation value"), m_diagnostics)) {
                m_columns[column].positions.push_back(position);
                m_columns[column].values.push_back(*value);
                m_columns[column].lines.push_back(token.line);
                m_columns[column].numbers.push_back(m_lastNumber.value_or(0));
            }
        column += isAxis ? 1 : 0;
    }
}

void FileReader::takeRow(const Token& line)
{
    if (hasTab(line))
        return;
    if (++m_rows == mostRows + 1)
        m_diagnostics.error({.severity = Severity::Error,
            .code = DiagnosticCode::LimitExceeded,
            .line = line.line,
            .column = 0,
            .found = AXISCOMP_TEXT("Error", "more than {count} lines").with("count", mostRows),
            .expected = AXISCOMP_TEXT("Error", "at most {count} lines").with("count", mostRows),
            .controllerError = "9095: 3"});
    Row row;
    row.values.resize(m_headers.size());
    splitTokens(line, " ", m_tokens);
    for (const Token& token : m_tokens)
        if (!place(token, row))
            return;
    if (!row.number || !row.position) {
        error(DiagnosticCode::Syntax, line,
            AXISCOMP_TEXT("Error", "a line with its number and its position"));
        return;
    }
    if (const auto position = positionOf(row))
        takeValues(row, *position);
}

void FileReader::take(const Token& line)
{
    if (m_hasEnded)
        error(DiagnosticCode::Syntax, line, AXISCOMP_TEXT("Error", "nothing behind [END]"));
    else if (!m_first)
        takeFirstLine(line);
    else if (sameLetters(line.text, "[END]"))
        m_hasEnded = true;
    else if (m_headers.empty())
        takeHeaders(line);
    else
        takeRow(line);
}

/// What is wrong in the first lines makes the others meaningless.
bool FileReader::readLines()
{
    TextLines lines(m_source.text);
    while (const auto line = lines.next()) {
        if (m_source.isStopped())
            return false;
        const Token content = trimmedToken(*line);
        if (!content)
            continue;
        const bool isHead = m_headers.empty();
        take(content);
        if (isHead && m_diagnostics.hasErrors())
            return false;
    }
    return true;
}

void FileReader::checkEnd()
{
    if (m_hasEnded)
        return;
    const Text found = AXISCOMP_TEXT("Error", "no line [END]");
    if (isEven())
        m_diagnostics.warning(DiagnosticCode::Assumption, 0, 0, found,
            AXISCOMP_TEXT("Error", "that line at the end; the file may be cut off"));
    else
        m_diagnostics.error(DiagnosticCode::Syntax, 0, 0, found,
            AXISCOMP_TEXT("Error", "that line at the end; the file may be cut off"));
}

void FileReader::checkRotary()
{
    if (!isRotary(m_axis))
        return;
    for (const Column& column : m_columns)
        for (std::size_t i = 0; i < column.positions.size(); ++i) {
            const double position = column.positions[i];
            if (position >= 0.0 && position <= 360.0)
                continue;
            m_diagnostics.warning(DiagnosticCode::Assumption, column.lines[i], 0,
                AXISCOMP_TEXT("Error", "the position {position} of the rotary axis {axis}")
                    .with("position", Quantity{toText(position), "deg"})
                    .with("axis", m_axis),
                AXISCOMP_TEXT("Error", "0 to 360 deg; the control does not use others"));
            return;
        }
}

/// The older controls take no steeper tables.
void FileReader::checkSlopes()
{
    const double most = m_distance / 64.0;
    for (const Column& column : m_columns)
        for (std::size_t i = 1; isEven() && i < column.values.size(); ++i) {
            const auto cells = static_cast<double>(column.numbers[i] - column.numbers[i - 1]);
            const double change = std::abs(column.values[i] - column.values[i - 1]) / cells;
            if (!(change > most * (1.0 + 1e-9)))
                continue;
            m_diagnostics.warning(DiagnosticCode::LargeGradient, column.lines[i], 0,
                AXISCOMP_TEXT("Error", "values of {axis} that change by {change}")
                    .with("axis", column.axis)
                    .with("change", Quantity{roundedText(change)}),
                AXISCOMP_TEXT(
                    "Error", "at most {limit} from line to line, DISTANCE / 64, on older controls")
                    .with("limit", Quantity{roundedText(most)}));
            return;
        }
}

/// That there are columns with values, and that their positions ascend. Leaves out the empty ones.
bool FileReader::checkColumns()
{
    std::erase_if(m_columns, [](const Column& column) { return column.values.empty(); });
    if (m_columns.empty()) {
        m_diagnostics.error(DiagnosticCode::TooFewPoints, 0, 0, {},
            AXISCOMP_TEXT("Error", "values in a column, of which there are none"));
        return false;
    }
    bool isGood = true;
    for (const Column& column : m_columns)
        isGood = checkKnots(column.positions, column.lines,
                     AXISCOMP_TEXT("Error", "the column of {axis}").with("axis", column.axis),
                     m_diagnostics)
            && isGood;
    return isGood;
}

std::vector<NeutralTable> FileReader::tables()
{
    if (!readLines())
        return {};
    if (!m_first || m_headers.empty())
        m_diagnostics.error(DiagnosticCode::Syntax, 0, 0, {},
            AXISCOMP_TEXT("Error", "a line of headers behind the first line"));
    checkEnd();
    if (m_diagnostics.hasErrors() || !checkColumns())
        return {};
    checkRotary();
    checkSlopes();
    if (m_backlashes > 0)
        m_diagnostics.warning(DiagnosticCode::LeftOut, m_backlash.line, m_backlash.column,
            AXISCOMP_COUNTED(
                "Error", "{count} values in the column BACKLASH", "1 value in the column BACKLASH")
                .with("count", m_backlashes),
            AXISCOMP_TEXT(
                "Error", "none: it is not published whether they are whole values or differences"));
    const auto unitOf = [&](std::string_view axis) {
        return isRotary(axis) ? std::string("deg") : m_lengthUnit;
    };
    std::vector<NeutralTable> tables;
    for (Column& column : m_columns) {
        const auto isSame = [&](const NeutralTable& table) {
            return table.axes.front().knots == column.positions;
        };
        auto table = std::ranges::find_if(tables, isSame);
        if (table == tables.end()) {
            tables.emplace_back();
            table = tables.end() - 1;
            table->sign = SignConvention::Feedback;
            SourceAxis& axis = table->axes.emplace_back();
            axis.name = m_axis;
            axis.unit = unitOf(m_axis);
            axis.knots = column.positions;
            axis.step = stepOf(axis.knots);
        }
        CompensationColumn& values = table->columns.emplace_back();
        values.target = column.axis;
        values.unit = unitOf(column.axis);
        values.values = std::move(column.values);
    }
    return tables;
}

} // namespace

bool isRotary(std::string_view letter)
{
    return letter.size() == 1 && std::string_view("ABC").find(letter) != std::string_view::npos;
}

Recognition recogniseFile(std::string_view text, Layout layout)
{
    TextLines lines(text);
    while (const auto line = lines.next()) {
        const Token content = trimmedToken(*line);
        if (!content)
            continue;
        const bool isIt =
            isFirstLine(content.text) && hasGrid(content.text) == (layout == Layout::EvenPositions);
        return isIt ? Recognition::Certain : Recognition::No;
    }
    return Recognition::No;
}

std::vector<NeutralTable> parseFile(TextReading& reading, Layout layout)
{
    return FileReader(reading, layout).tables();
}

} // namespace axiscomp::heidenhain
