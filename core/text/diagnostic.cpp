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

struct DiagnosticRow {
    DiagnosticCode code;
    std::string_view name;
    TextPattern problem;
    TextPattern wayOut; ///< empty where the expected text says it
    bool quotesFile = false;
};

constexpr std::array diagnosticRows{
    DiagnosticRow{DiagnosticCode::EmptyFile, "EmptyFile",
        AXISCOMP_TEXT("Problem", "the file holds no data"),
        AXISCOMP_TEXT("Problem", "export it again, or choose another file")},
    DiagnosticRow{DiagnosticCode::NoHeader, "NoHeader",
        AXISCOMP_TEXT("Problem", "the header line with the names of the columns is missing"),
        AXISCOMP_TEXT("Problem",
            "add a first line such as X [mm],Table 1 [mm], or for a measurement target "
            "[mm],direction,run,deviation [um]"),
        true},
    DiagnosticRow{DiagnosticCode::TooFewColumns, "TooFewColumns",
        AXISCOMP_TEXT("Problem", "the header has too few columns"),
        AXISCOMP_TEXT("Problem", "choose the dimensionality that the file has")},
    DiagnosticRow{DiagnosticCode::ColumnCount, "ColumnCount",
        AXISCOMP_TEXT("Problem", "this line does not have as many columns as the header"),
        TextPattern{}},
    DiagnosticRow{DiagnosticCode::NotANumber, "NotANumber",
        AXISCOMP_TEXT("Problem", "this is not a number"), TextPattern{}, true},
    DiagnosticRow{DiagnosticCode::NotFinite, "NotFinite",
        AXISCOMP_TEXT("Problem", "this number is not finite"), TextPattern{}, true},
    DiagnosticRow{DiagnosticCode::MixedDecimals, "MixedDecimals",
        AXISCOMP_TEXT("Problem", "it is not clear which sign is the decimal one"),
        AXISCOMP_TEXT("Problem", "use one decimal sign in all numbers, and none between thousands"),
        true},
    DiagnosticRow{DiagnosticCode::UnterminatedQuote, "UnterminatedQuote",
        AXISCOMP_TEXT("Problem", "a quotation mark is not closed as it should be"), TextPattern{},
        true},
    DiagnosticRow{DiagnosticCode::DuplicatePoint, "DuplicatePoint",
        AXISCOMP_TEXT("Problem", "the same position occurs twice"),
        AXISCOMP_TEXT("Problem", "delete one of the two lines")},
    DiagnosticRow{DiagnosticCode::MissingPoint, "MissingPoint",
        AXISCOMP_TEXT("Problem", "the grid is incomplete"), TextPattern{}},
    DiagnosticRow{DiagnosticCode::UnevenSpacing, "UnevenSpacing",
        AXISCOMP_TEXT("Problem", "the positions are not evenly spaced"),
        AXISCOMP_TEXT("Problem",
            "resample the data onto an even grid, which can be done here for a calibration file "
            "only")},
    DiagnosticRow{DiagnosticCode::OtherDimensionality, "OtherDimensionality",
        AXISCOMP_TEXT("Problem", "the file has another dimensionality than the one chosen"),
        AXISCOMP_TEXT("Problem", "choose the dimensionality that the file has (--dims)")},
    DiagnosticRow{DiagnosticCode::TooFewPoints, "TooFewPoints",
        AXISCOMP_TEXT("Problem", "there are too few points"), TextPattern{}},
    DiagnosticRow{DiagnosticCode::TooLarge, "TooLarge",
        AXISCOMP_TEXT("Problem", "the file is too large"),
        AXISCOMP_TEXT("Problem", "choose a coarser grid, or split the file")},
    DiagnosticRow{DiagnosticCode::NotText, "NotText",
        AXISCOMP_TEXT("Problem", "this is not a text file"),
        AXISCOMP_TEXT("Problem", "save it as UTF-8 text")},
    DiagnosticRow{DiagnosticCode::IoError, "IoError",
        AXISCOMP_TEXT("Problem", "the file cannot be read"), TextPattern{}},
    DiagnosticRow{DiagnosticCode::Encoding, "Encoding",
        AXISCOMP_TEXT("Problem", "the file is not valid UTF-8 and is read as Windows-1252"),
        AXISCOMP_TEXT("Problem", "check the names and notes, or save it as UTF-8 text")},
    DiagnosticRow{DiagnosticCode::RoundedSpacing, "RoundedSpacing",
        AXISCOMP_TEXT("Problem", "the positions are even only within the printed precision"),
        AXISCOMP_TEXT(
            "Problem", "the even grid is used; print more decimals if that is not meant")},
    DiagnosticRow{DiagnosticCode::FloatPrecision, "FloatPrecision",
        AXISCOMP_TEXT("Problem", "a value loses precision when it is stored as float32"),
        AXISCOMP_TEXT("Problem", "check the unit of the values")},
    DiagnosticRow{DiagnosticCode::LargeGradient, "LargeGradient",
        AXISCOMP_TEXT("Problem", "the table is very steep, which is likely a unit mistake"),
        AXISCOMP_TEXT("Problem", "check the units of values and positions")},
    DiagnosticRow{DiagnosticCode::ConstantTable, "ConstantTable",
        AXISCOMP_TEXT("Problem", "all values of the table are equal"),
        AXISCOMP_TEXT("Problem", "check that this column is meant")},
    DiagnosticRow{DiagnosticCode::FilledPoints, "FilledPoints",
        AXISCOMP_TEXT("Problem", "points without a value are filled"), TextPattern{}},
    DiagnosticRow{DiagnosticCode::CroppedGrid, "CroppedGrid",
        AXISCOMP_TEXT("Problem", "the grid is cropped to the points that have a value"),
        TextPattern{}},
    DiagnosticRow{DiagnosticCode::SnappedPositions, "SnappedPositions",
        AXISCOMP_TEXT("Problem", "positions are snapped to the grid"), TextPattern{}},
    DiagnosticRow{DiagnosticCode::DroppedComments, "DroppedComments",
        AXISCOMP_TEXT("Problem", "comments from here on are not kept with the table"),
        TextPattern{}},
    DiagnosticRow{DiagnosticCode::Syntax, "Syntax",
        AXISCOMP_TEXT("Problem", "this is not written as the format demands"), TextPattern{}, true},
    DiagnosticRow{DiagnosticCode::Contradiction, "Contradiction",
        AXISCOMP_TEXT("Problem", "two statements contradict each other"), TextPattern{}},
    DiagnosticRow{DiagnosticCode::NotMonotonic, "NotMonotonic",
        AXISCOMP_TEXT("Problem", "the positions do not go in one direction"), TextPattern{}},
    DiagnosticRow{DiagnosticCode::NotPeriodic, "NotPeriodic",
        AXISCOMP_TEXT("Problem", "the table does not close after one revolution"), TextPattern{}},
    DiagnosticRow{DiagnosticCode::LimitExceeded, "LimitExceeded",
        AXISCOMP_TEXT("Problem", "the controller does not take as much"), TextPattern{}},
    DiagnosticRow{DiagnosticCode::MissingColumn, "MissingColumn",
        AXISCOMP_TEXT("Problem", "the columns do not say what was measured"), TextPattern{}},
    DiagnosticRow{DiagnosticCode::UnitMissing, "UnitMissing",
        AXISCOMP_TEXT("Problem", "the unit of a column is not known"), TextPattern{}},
    DiagnosticRow{DiagnosticCode::UnitMixed, "UnitMixed",
        AXISCOMP_TEXT("Problem", "a length and an angle are mixed"),
        AXISCOMP_TEXT("Problem", "correct the unit in the file, or state it")},
    DiagnosticRow{DiagnosticCode::BadDirection, "BadDirection",
        AXISCOMP_TEXT("Problem", "this is not a direction"), TextPattern{}, true},
    DiagnosticRow{DiagnosticCode::BadRun, "BadRun",
        AXISCOMP_TEXT("Problem", "this is not the number of a run"), TextPattern{}, true},
    DiagnosticRow{DiagnosticCode::DuplicateValue, "DuplicateValue",
        AXISCOMP_TEXT("Problem", "the same value is there twice"),
        AXISCOMP_TEXT("Problem", "delete one of the two")},
    DiagnosticRow{DiagnosticCode::CountMismatch, "CountMismatch",
        AXISCOMP_TEXT("Problem", "the file holds another number than it says"), TextPattern{}},
    DiagnosticRow{DiagnosticCode::TooFewTargets, "TooFewTargets",
        AXISCOMP_TEXT("Problem", "there are too few targets"), TextPattern{}},
    DiagnosticRow{DiagnosticCode::UnknownTargetNumber, "UnknownTargetNumber",
        AXISCOMP_TEXT("Problem", "there is no target of this number"), TextPattern{}},
    DiagnosticRow{DiagnosticCode::InstrumentScale, "InstrumentScale",
        AXISCOMP_TEXT("Problem", "positions do not follow one another one to one"), TextPattern{}},
    DiagnosticRow{DiagnosticCode::IncompleteRuns, "IncompleteRuns",
        AXISCOMP_TEXT("Problem", "values are missing"),
        AXISCOMP_TEXT("Problem", "the figures are made of the values that are there")},
    DiagnosticRow{DiagnosticCode::UnequalRuns, "UnequalRuns",
        AXISCOMP_TEXT("Problem", "the directions have different numbers of runs"), TextPattern{}},
    DiagnosticRow{DiagnosticCode::ValuesLookLikePositions, "ValuesLookLikePositions",
        AXISCOMP_TEXT("Problem", "the values look like positions instead of deviations"),
        AXISCOMP_TEXT("Problem",
            "if they are positions of the reference, say so: --values reference, or name the "
            "column reference")},
    DiagnosticRow{DiagnosticCode::UnitSuspicious, "UnitSuspicious",
        AXISCOMP_TEXT("Problem", "the size of the values is unusual"),
        AXISCOMP_TEXT("Problem", "check the unit of the values")},
    DiagnosticRow{DiagnosticCode::DirectionsDoubtful, "DirectionsDoubtful",
        AXISCOMP_TEXT("Problem", "the directions of the runs are doubtful"),
        AXISCOMP_TEXT("Problem",
            "compare them with the data, and exchange them if they are the other way round")},
    DiagnosticRow{DiagnosticCode::PublishedContradiction, "PublishedContradiction",
        AXISCOMP_TEXT("Problem", "a result in the file is not what its values give"),
        TextPattern{}},
    DiagnosticRow{DiagnosticCode::LeftOut, "LeftOut",
        AXISCOMP_TEXT("Problem", "not everything in the file is used"), TextPattern{}},
    DiagnosticRow{DiagnosticCode::UnknownKey, "UnknownKey",
        AXISCOMP_TEXT("Problem", "this entry is not known and is left out"), TextPattern{}, true},
    DiagnosticRow{DiagnosticCode::UnitNotGiven, "UnitNotGiven",
        AXISCOMP_TEXT("Problem", "the file does not say a unit"), TextPattern{}},
    DiagnosticRow{DiagnosticCode::TargetNotKnown, "TargetNotKnown",
        AXISCOMP_TEXT("Problem", "the axis that the values correct cannot be told"), TextPattern{},
        true},
    DiagnosticRow{DiagnosticCode::Assumption, "Assumption",
        AXISCOMP_TEXT("Problem", "the file can be understood in several ways"), TextPattern{}},
};

const DiagnosticRow& rowOf(DiagnosticCode code)
{
    const auto row = std::ranges::find(diagnosticRows, code, &DiagnosticRow::code);
    assert(row != diagnosticRows.end());
    return *row;
}

Text foundText(const Diagnostic& diagnostic)
{
    if (diagnostic.found.isEmpty())
        return diagnostic.code == DiagnosticCode::NotANumber
            ? Text(AXISCOMP_TEXT("Problem", "found an empty cell"))
            : Text();
    if (diagnostic.code == DiagnosticCode::IoError)
        return diagnostic.found;
    return (quotesFile(diagnostic.code) ? AXISCOMP_TEXT("Problem", "found \"{found}\"")
                                        : AXISCOMP_TEXT("Problem", "found {found}"))
        .with("found", diagnostic.found);
}

} // namespace

std::string_view diagnosticName(DiagnosticCode code)
{
    return rowOf(code).name;
}

bool quotesFile(DiagnosticCode code)
{
    return rowOf(code).quotesFile;
}

Text textOf(const Diagnostic& diagnostic)
{
    const DiagnosticRow& row = rowOf(diagnostic.code);
    Text text = row.problem;
    if (const Text found = foundText(diagnostic); !found.isEmpty())
        text = AXISCOMP_TEXT("Problem", "{problem}: {found}")
                   .with("problem", text)
                   .with("found", found);
    if (!diagnostic.expected.isEmpty())
        text = AXISCOMP_TEXT("Problem", "{problem}, expected {expected}")
                   .with("problem", text)
                   .with("expected", diagnostic.expected);
    if (!Text(row.wayOut).isEmpty())
        text = AXISCOMP_TEXT("Problem", "{problem}; {wayOut}")
                   .with("problem", text)
                   .with("wayOut", row.wayOut);
    return text;
}

std::string message(const Diagnostic& diagnostic)
{
    std::string text = textOf(diagnostic).english();
    text.append(" (").append(diagnosticName(diagnostic.code));
    if (!diagnostic.controllerError.empty())
        text.append(", error ").append(diagnostic.controllerError).append(" of the controller");
    return text.append(")");
}

void DiagnosticList::error(
    DiagnosticCode code, std::size_t line, std::size_t column, Text found, Text expected)
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

void DiagnosticList::warning(
    DiagnosticCode code, std::size_t line, std::size_t column, Text found, Text expected)
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

void DiagnosticList::append(DiagnosticList following)
{
    for (Diagnostic& item : following.m_items)
        error(std::move(item));
    const std::size_t room = m_maximum - std::min(m_maximum, m_warnings.size());
    const std::size_t kept = std::min(room, following.m_warnings.size());
    std::move(following.m_warnings.begin(),
        following.m_warnings.begin() + static_cast<std::ptrdiff_t>(kept),
        std::back_inserter(m_warnings));
    countErrors(following.m_suppressed);
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
