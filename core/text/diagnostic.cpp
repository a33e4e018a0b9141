// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/diagnostic.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <iterator>
#include <limits>
#include <utility>

namespace axiscomp {

namespace {

enum class Found {
    Text, ///< characters of the file: put in quotation marks
    Words, ///< a description
    Reason, ///< explains the problem by itself
};

struct DiagnosticRow {
    DiagnosticCode code;
    std::string_view name;
    Found found;
    std::string_view problem; ///< may be empty when found and expected say it all
    std::string_view wayOut;
};

constexpr std::array diagnosticRows{
    DiagnosticRow{DiagnosticCode::EmptyFile, "EmptyFile", Found::Words, "the file holds no data",
        "a calibration file has a header line and one line per grid point; save an example file "
        "to see one"},
    DiagnosticRow{DiagnosticCode::NoHeader, "NoHeader", Found::Text,
        "the header line with the names of the columns is missing",
        "add a first line such as X [mm],Table 1 [mm]"},
    DiagnosticRow{DiagnosticCode::TooFewColumns, "TooFewColumns", Found::Words,
        "the header has too few columns", ""},
    DiagnosticRow{DiagnosticCode::ColumnCount, "ColumnCount", Found::Words,
        "this line does not have the columns of the header", ""},
    DiagnosticRow{DiagnosticCode::NotANumber, "NotANumber", Found::Text, "", ""},
    DiagnosticRow{DiagnosticCode::NotFinite, "NotFinite", Found::Text, "", ""},
    DiagnosticRow{DiagnosticCode::MixedDecimals, "MixedDecimals", Found::Text,
        "decimal comma and decimal point are mixed", "use the same decimal sign in every number"},
    DiagnosticRow{DiagnosticCode::UnterminatedQuote, "UnterminatedQuote", Found::Text,
        "a quotation mark is not closed as it should be", ""},
    DiagnosticRow{DiagnosticCode::DuplicatePoint, "DuplicatePoint", Found::Words,
        "the same position occurs twice", "delete one of the two lines"},
    DiagnosticRow{DiagnosticCode::MissingPoint, "MissingPoint", Found::Words,
        "the grid is incomplete",
        "measure the missing points, or resample the data onto a full grid"},
    DiagnosticRow{DiagnosticCode::UnevenSpacing, "UnevenSpacing", Found::Words,
        "the positions are not evenly spaced", "resample the data onto an even grid"},
    DiagnosticRow{
        DiagnosticCode::TooFewPoints, "TooFewPoints", Found::Words, "there are too few points", ""},
    DiagnosticRow{DiagnosticCode::TooLarge, "TooLarge", Found::Words, "the file is too large",
        "choose a coarser grid, or split the file"},
    DiagnosticRow{DiagnosticCode::NotText, "NotText", Found::Words, "this is not a text file",
        "save it as UTF-8 CSV"},
    DiagnosticRow{DiagnosticCode::IoError, "IoError", Found::Reason, "the file cannot be read", ""},
    DiagnosticRow{DiagnosticCode::Encoding, "Encoding", Found::Words,
        "the file is not valid UTF-8 and is read as Windows-1252",
        "check the names and notes, or save it as UTF-8 CSV"},
    DiagnosticRow{DiagnosticCode::RoundedSpacing, "RoundedSpacing", Found::Words,
        "the positions are even only within the printed precision",
        "the even grid is used; print more decimals if that is not meant"},
    DiagnosticRow{DiagnosticCode::FloatPrecision, "FloatPrecision", Found::Words,
        "a value loses precision when it is stored as float32", "check the unit of the values"},
    DiagnosticRow{DiagnosticCode::LargeGradient, "LargeGradient", Found::Words,
        "the table is very steep, which is likely a unit mistake",
        "the values must be in the unit of the positions"},
    DiagnosticRow{DiagnosticCode::ConstantTable, "ConstantTable", Found::Words,
        "all values of the table are equal", "check that this column is meant"},
    DiagnosticRow{DiagnosticCode::Syntax, "Syntax", Found::Text,
        "this is not written as the format demands", ""},
    DiagnosticRow{DiagnosticCode::Contradiction, "Contradiction", Found::Words,
        "two statements of the file contradict each other", ""},
    DiagnosticRow{DiagnosticCode::NotMonotonic, "NotMonotonic", Found::Words,
        "the positions do not go in one direction", ""},
    DiagnosticRow{DiagnosticCode::NotPeriodic, "NotPeriodic", Found::Words,
        "the table does not close after one revolution", ""},
    DiagnosticRow{DiagnosticCode::LimitExceeded, "LimitExceeded", Found::Words,
        "the controller does not take as much", ""},
    DiagnosticRow{DiagnosticCode::UnknownKey, "UnknownKey", Found::Text,
        "this entry is not known and is left out", ""},
    DiagnosticRow{DiagnosticCode::UnitNotGiven, "UnitNotGiven", Found::Words,
        "the file does not say a unit", ""},
    DiagnosticRow{DiagnosticCode::Assumption, "Assumption", Found::Words,
        "the file can be understood in several ways", ""},
};

const DiagnosticRow& rowOf(DiagnosticCode code)
{
    const auto row = std::ranges::find(diagnosticRows, code, &DiagnosticRow::code);
    assert(row != diagnosticRows.end());
    return *row;
}

std::string foundPart(const Diagnostic& diagnostic, Found found)
{
    if (diagnostic.found.empty())
        return diagnostic.code == DiagnosticCode::NotANumber ? "found an empty cell" : "";
    if (found == Found::Text)
        return "found \"" + diagnostic.found + '"';
    return found == Found::Reason ? diagnostic.found : "found " + diagnostic.found;
}

} // namespace

std::string_view diagnosticName(DiagnosticCode code)
{
    return rowOf(code).name;
}

std::string message(const Diagnostic& diagnostic)
{
    const DiagnosticRow& row = rowOf(diagnostic.code);
    std::string text(row.problem);
    const auto append = [&text](std::string_view separator, std::string_view part) {
        if (part.empty())
            return;
        if (!text.empty())
            text += separator;
        text += part;
    };
    append(": ", foundPart(diagnostic, row.found));
    if (!diagnostic.expected.empty())
        append(", ", "expected " + diagnostic.expected);
    append("; ", row.wayOut);
    text.append(" (").append(row.name);
    if (!diagnostic.controllerError.empty())
        text.append(", error ").append(diagnostic.controllerError).append(" of the controller");
    return text.append(")");
}

void DiagnosticList::error(DiagnosticCode code, std::size_t line, std::size_t column,
    std::string found, std::string expected)
{
    error({.severity = Severity::Error,
        .code = code,
        .line = line,
        .column = column,
        .found = std::move(found),
        .expected = std::move(expected),
        .controllerError = {}});
}

void DiagnosticList::error(Diagnostic diagnostic)
{
    m_hasErrors = true;
    if (isFull())
        ++m_suppressed;
    else
        m_items.push_back(std::move(diagnostic));
}

void DiagnosticList::warning(DiagnosticCode code, std::size_t line, std::size_t column,
    std::string found, std::string expected)
{
    if (m_warnings.size() < m_maximum)
        m_warnings.push_back({.severity = Severity::Warning,
            .code = code,
            .line = line,
            .column = column,
            .found = std::move(found),
            .expected = std::move(expected),
            .controllerError = {}});
}

void DiagnosticList::countErrors(std::size_t count)
{
    m_hasErrors = m_hasErrors || count > 0;
    m_suppressed += count;
}

std::vector<Diagnostic> DiagnosticList::take()
{
    // Errors come first when there is no room for all: they are what stops the file.
    const std::size_t room = m_maximum - std::min(m_maximum, m_items.size());
    const std::size_t kept = std::min(room, m_warnings.size());
    std::move(m_warnings.begin(), m_warnings.begin() + static_cast<std::ptrdiff_t>(kept),
        std::back_inserter(m_items));
    const auto place = [](const Diagnostic& item) {
        return item.line == 0 ? std::numeric_limits<std::size_t>::max() : item.line;
    };
    std::ranges::stable_sort(m_items, {}, place);
    return std::move(m_items);
}

} // namespace axiscomp
