// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/portable_math.h"
#include "core/metrology/formats/measurement_csv.h"
#include "core/metrology/formats/measurement_formats.h"
#include "core/metrology/formats/run_assembly.h"
#include "core/text/number_parser.h"
#include "core/text/token_scanner.h"
#include "core/text/utf8.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace axiscomp::ecmc_report {

namespace {

constexpr std::array<std::string_view, 1> extensions{".md"};
constexpr std::array kinds{MeasurementKind::Runs};
constexpr std::array<std::string_view, 3> rules{
    "The Markdown report of an ISO 230-2 test: the tables below \"Data forward direction\" and "
    "\"Data backward direction\", with the target and the positions of the reference in each "
    "line.",
    "Results such as B = 0.03358 [mm] are compared with those of the values.",
    "The program that writes such reports prints the two directions the other way round in every "
    "public pair of data and report; they are read as printed, with a warning, and exchanged with "
    "--swap-directions.",
};

struct ResultName {
    std::string_view printed;
    std::string_view figure;
};
constexpr std::array resultNames{ResultName{"B", "B"}, ResultName{"B_avg", "Bmean"},
    ResultName{"M", "M"}, ResultName{"E_fwd", "EUp"}, ResultName{"E_bwd", "EDown"},
    ResultName{"E", "E"}, ResultName{"R_fwd", "RUp"}, ResultName{"R_bwd", "RDown"},
    ResultName{"R", "R"}, ResultName{"A_fwd", "AUp"}, ResultName{"A_bwd", "ADown"},
    ResultName{"A", "A"}};

/// "#### Data forward direction:" -> "Data forward direction"
std::optional<std::string_view> headingOf(std::string_view line)
{
    std::string_view text = trimmed(line);
    if (!text.starts_with('#'))
        return std::nullopt;
    text = trimmed(text.substr(std::min(text.find_first_not_of('#'), text.size())));
    return text.ends_with(':') ? trimmed(text.substr(0, text.size() - 1)) : text;
}

/// "tgt_pos(i) [mm]" -> "mm"
std::string_view unitInBrackets(std::string_view text)
{
    const std::size_t open = text.find('[');
    const std::size_t close = text.find(']', open);
    if (open == std::string_view::npos || close == std::string_view::npos)
        return {};
    return trimmed(text.substr(open + 1, close - open - 1));
}

class Reader {
public:
    Reader(Measurement& measurement, const MeasurementReadOptions& options,
        DiagnosticList& diagnostics, Encoding encoding)
        : m_measurement(measurement)
        , m_options(options)
        , m_diagnostics(diagnostics)
        , m_encoding(encoding)
    {
    }

    void takeLine(const Token& line);
    [[nodiscard]] std::vector<RawRunValue> values();

private:
    void takeRow(const Token& line);
    void takeUnit(const Token& line, std::string_view symbol);
    void takeResult(const Token& line);
    std::optional<double> number(const Token& token);

    Measurement& m_measurement;
    const MeasurementReadOptions& m_options;
    DiagnosticList& m_diagnostics;
    Encoding m_encoding;
    std::optional<Approach> m_direction; ///< of the table that is being read
    std::size_t m_columns = 0; ///< of that table; 0: its head has not come yet
    std::optional<MeasurementUnit> m_unit;
    std::optional<MeasurementUnit> m_valueUnit; ///< of the positions of the reference
    double m_halfUnit = 0.0; ///< of the numbers of the tables
    std::vector<RawRunValue> m_values;
};

void Reader::takeLine(const Token& line)
{
    if (const auto heading = headingOf(line.text)) {
        m_direction.reset();
        m_columns = 0;
        if (sameLetters(*heading, "Data forward direction"))
            m_direction = Approach::Up;
        else if (sameLetters(*heading, "Data backward direction"))
            m_direction = Approach::Down;
    } else if (m_direction && line.text.find('|') != std::string_view::npos) {
        takeRow(line);
    } else {
        takeResult(line);
    }
}

void Reader::takeUnit(const Token& line, std::string_view symbol)
{
    const auto unit = measurementUnit(m_options.unit.empty() ? symbol : m_options.unit);
    if (!unit)
        m_diagnostics.error(DiagnosticCode::UnitMissing, line.line, 0,
            Verbatim{excerpt(line.text, m_encoding)},
            AXISCOMP_TEXT("Error", "a head such as i|tgt_pos(i) [mm]|ref_pos(i,1) [mm]|"));
    else if (m_unit && m_unit->isAngular != unit->isAngular)
        m_diagnostics.error(
            DiagnosticCode::UnitMixed, line.line, 0, Verbatim{excerpt(line.text, m_encoding)}, {});
    m_unit = unit;
    if (m_options.valueUnit.empty())
        m_valueUnit = unit;
    else if (!m_valueUnit) // the second table has the same head
        m_valueUnit = unitOfFormat(
            "values", m_options.valueUnit, std::string(symbol), m_measurement, m_diagnostics);
    if (m_unit && m_valueUnit && areSameKind(*m_unit, *m_valueUnit, m_diagnostics))
        m_measurement.isAngular = m_unit->isAngular;
}

std::optional<double> Reader::number(const Token& token)
{
    Number parsed;
    if (parseNumber(token.text, '.', parsed) == NumberFault::None) {
        const double half = 0.5 * portable::pow(10.0, parsed.lastDecimal);
        m_halfUnit = m_halfUnit == 0.0 ? half : std::min(m_halfUnit, half);
        return parsed.value;
    }
    return readNumber(token, AXISCOMP_TEXT("Error", "a position"), m_diagnostics);
}

void Reader::takeRow(const Token& line)
{
    std::vector<Token> cells;
    splitCells(line, '|', cells);
    while (!cells.empty() && !cells.back())
        cells.pop_back();
    if (cells.size() < 3 || cells.front().text.starts_with("---"))
        return;
    if (m_columns == 0) {
        m_columns = cells.size();
        takeUnit(line, unitInBrackets(cells[1].text));
        return;
    }
    if (cells.size() != m_columns) {
        m_diagnostics.error(DiagnosticCode::ColumnCount, line.line, 0,
            AXISCOMP_COUNTED("Error", "{count} columns", "1 column").with("count", cells.size()),
            AXISCOMP_TEXT("Error", "{value}, as the head of the table has")
                .with("value", m_columns));
        return;
    }
    const auto target =
        readNumber(cells[1], AXISCOMP_TEXT("Error", "the position of a target"), m_diagnostics);
    for (std::size_t cell = 2; cell < cells.size(); ++cell) {
        const auto position = number(cells[cell]);
        if (!target || !position || !m_unit || !m_valueUnit)
            continue;
        RawRunValue raw;
        raw.target = *target * m_unit->factor;
        raw.reference = *position * m_valueUnit->factor;
        raw.value.direction = *m_direction;
        raw.value.run = static_cast<int>(cell) - 1;
        raw.value.line = line.line;
        m_values.push_back(raw);
    }
}

/// "**B = 0.03358 [mm]**"
void Reader::takeResult(const Token& line)
{
    std::string_view text = trimmed(line.text);
    while (text.starts_with('*'))
        text.remove_prefix(1);
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos)
        return;
    const std::string_view name = trimmed(text.substr(0, equals));
    const auto known = std::ranges::find(resultNames, name, &ResultName::printed);
    if (known == resultNames.end())
        return;
    const std::string_view value = trimmed(text.substr(equals + 1));
    const std::size_t end = std::min(value.find_first_of(" \t[*"), value.size());
    Number parsed;
    const auto unit = measurementUnit(unitInBrackets(value));
    if (parseNumber(value.substr(0, end), '.', parsed) != NumberFault::None || !unit)
        return; // a line that says what the figure is
    m_measurement.published.push_back({std::string(known->figure), parsed.value * unit->factor,
        0.5 * portable::pow(10.0, parsed.lastDecimal) * unit->factor, line.line});
}

std::vector<RawRunValue> Reader::values()
{
    if (m_valueUnit)
        m_measurement.halfPrintedUnit = m_halfUnit * m_valueUnit->factor;
    if (!m_diagnostics.hasErrors() && !m_values.empty())
        m_diagnostics.warning(DiagnosticCode::DirectionsDoubtful, 0, 0,
            AXISCOMP_TEXT("Error",
                "a report by a program that is known to print forward and backward the other way "
                "round"),
            {});
    return std::move(m_values);
}

MeasurementRecognition recognise(std::string_view text)
{
    TextLines lines(text);
    while (const auto line = lines.next()) {
        const auto heading = headingOf(line->text);
        if (heading && sameLetters(*heading, "Data forward direction"))
            return MeasurementRecognition::Certain;
    }
    return MeasurementRecognition::No;
}

} // namespace

const MeasurementFormat& format()
{
    static const MeasurementFormat format{
        .facts = {.name = "ecmc-report",
            .origin = "ecmc (EtherCAT motion control for EPICS)",
            .description = AXISCOMP_TEXT("Error", "report of an ISO 230-2 test, with its results"),
            .extensions = extensions,
            .kinds = kinds,
            .rules = rules},
        .recognise = recognise,
        .read = readRuns<valuesByLine<Reader>>};
    return format;
}

} // namespace axiscomp::ecmc_report
