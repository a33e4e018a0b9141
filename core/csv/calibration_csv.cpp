// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/calibration_csv.h"

#include "core/csv/grid_reader.h"
#include "core/csv/table_reader.h"
#include "core/io/local_file.h"
#include "core/neutral/sign_note.h"
#include "core/table/target_axis.h"
#include "core/text/number_text.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <limits>
#include <new>
#include <utility>

namespace axiscomp {

namespace {

/// Places in the text are kept in 32 bits.
std::size_t maximumBytes(const CsvOptions& options)
{
    return std::min<std::size_t>(options.maximumBytes, std::numeric_limits<std::uint32_t>::max());
}

void reportTooLarge(DiagnosticList& diagnostics, Argument bytes, std::size_t limit)
{
    diagnostics.error(DiagnosticCode::TooLarge, 0, 0,
        AXISCOMP_TEXT("Error", "{size} bytes").with("size", std::move(bytes)),
        AXISCOMP_TEXT("Error", "at most {size} bytes").with("size", limit));
}

void reportNoLines(const csv::Scan& scan, DiagnosticList& diagnostics)
{
    if (scan.headerLine == 0 && scan.notes.empty())
        diagnostics.error(DiagnosticCode::EmptyFile, 0, 0, {}, {});
    else if (scan.headerLine == 0)
        diagnostics.error(DiagnosticCode::NoHeader, 0, 0, {},
            AXISCOMP_TEXT("Error", "a line with the names of the columns, not only comments"));
    else
        diagnostics.error(DiagnosticCode::TooFewPoints, scan.headerLine, 0,
            AXISCOMP_TEXT("Error", "no data lines after the header"),
            AXISCOMP_TEXT(
                "Error", "at least 2 positions in each dimension, one line per grid point"));
}

std::vector<std::string> axisHeaders(const Grid& grid)
{
    std::vector<std::string> headers;
    for (const GridAxis& axis : grid.axes)
        headers.push_back(axis.name);
    return headers;
}

/// Takes up "target: Z" and "target: X, Y" among the notes, one for all tables or one for each;
/// tables that are left are asked by their names. An error for another one that says something
/// else.
void takeTargets(CalibrationData& data, DiagnosticList& diagnostics)
{
    const std::vector<std::string> headers = axisHeaders(data.grid);
    for (CompensationTable& table : data.tables)
        table.target = targetInHeader(table.name, headers);
    const auto note = std::ranges::find_if(
        data.notes, [](const std::string& line) { return targetInComment(line).has_value(); });
    if (note == data.notes.end())
        return;
    const std::vector<std::string> first = targetList(*targetInComment(*note));
    const auto other = std::find_if(std::next(note), data.notes.end(), [&](const auto& line) {
        const auto target = targetInComment(line);
        return target && !std::ranges::equal(targetList(*target), first, sameLetters);
    });
    if (other != data.notes.end()) {
        diagnostics.error(DiagnosticCode::Contradiction, 0, 0, Verbatim{*other},
            AXISCOMP_TEXT("Error", "\"{note}\", as another comment says; leave one of them out")
                .with("note", *note));
        return;
    }
    std::vector<std::string> said = first;
    if (said.size() == 1)
        said.resize(data.tables.size(), said.front());
    std::vector<std::string> meant;
    for (const std::string& statement : said)
        meant.push_back(targetAmong(statement, headers));
    const bool isUsable = said.size() == data.tables.size()
        && std::ranges::equal(said, meant, {}, &std::string::empty, &std::string::empty);
    if (!isUsable) {
        if (said.size() == data.tables.size())
            for (std::size_t n = 0; n < said.size(); ++n)
                data.tables[n].statedAxis = std::move(said[n]);
        diagnostics.warning(DiagnosticCode::TargetNotKnown, 0, 0, Verbatim{*note},
            AXISCOMP_TEXT("Error",
                "one axis for all columns or one for each: the name of an axis, #1 for the first "
                "source, or other"));
        return;
    }
    for (std::size_t n = 0; n < meant.size(); ++n)
        data.tables[n].target = std::move(meant[n]);
    data.notes.erase(note);
}

/// A statement that files of measurements know; what uses the values refuses it.
void warnOfSign(const CalibrationData& data, DiagnosticList& diagnostics)
{
    for (const std::string& note : data.notes)
        if (const auto sign = statedIn(note, signKey); sign && sameLetters(*sign, "correction"))
            diagnostics.warning(DiagnosticCode::Assumption, 0, 0, Verbatim{note},
                AXISCOMP_TEXT("Error",
                    "sign: feedback or sign: command; where the values are encoder minus "
                    "reference, leave the line out, and turn them with --scale -1"));
}

std::optional<CalibrationData> readData(csv::Scan& scan, const CsvOptions& options,
    DiagnosticList& diagnostics, std::vector<std::vector<double>>& knots)
{
    csv::GridReading grid = csv::readGrid(scan, options, diagnostics);
    const csv::Places places(scan, grid.lines);
    CalibrationData data;
    data.tables = csv::readTables(scan, grid, places, options, diagnostics);
    if (diagnostics.hasErrors())
        return std::nullopt;
    data.grid = std::move(grid.grid);
    data.notes = std::move(scan.notes);
    for (const CompensationTable& table : data.tables)
        if (!table.filled.empty())
            data.notes.push_back(filledNote(table.name, table.filled.size(), table.values.size()));
    takeTargets(data, diagnostics);
    if (diagnostics.hasErrors())
        return std::nullopt;
    warnOfSign(data, diagnostics);
    if (options.acceptsUneven)
        knots = std::move(grid.knots);
    return data;
}

/// What is stated counts for all that is said of the numbers.
void takeUnits(const StatedUnits& stated, csv::Scan& scan)
{
    const auto dimensions = static_cast<std::size_t>(scan.dimensions);
    for (std::size_t i = 0; i < scan.columns.size(); ++i)
        takeStatedUnit(scan.columns[i].unit, i < dimensions ? stated.positions : stated.values);
}

void parse(
    std::string_view text, const CsvOptions& options, DiagnosticList& diagnostics, CsvReading& out)
{
    if (text.size() > maximumBytes(options)) {
        reportTooLarge(diagnostics, text.size(), maximumBytes(options));
        return;
    }
    const TextInspection inspection(text, options.stop, diagnostics, options.threads);
    if (diagnostics.hasErrors())
        return;
    csv::Scan scan = csv::scan(inspection, options, diagnostics);
    takeUnits(options.units, scan);
    out.cancelled = scan.cancelled;
    if (scan.cancelled)
        return;
    const bool usable = scan.headerLine == 0 || !diagnostics.hasErrors();
    if (scan.rows == 0 && usable)
        reportNoLines(scan, diagnostics);
    else if (scan.rows > 0 && scan.complete)
        out.data = readData(scan, options, diagnostics, out.knots);
    out.cancelled = options.stop.stop_requested();
    if (out.cancelled)
        out.data.reset();
    else if (options.progress)
        options.progress(1.0);
}

CsvReading parseAs(std::string_view text, const CsvOptions& options)
{
    CsvReading reading;
    DiagnosticList diagnostics(options.maximumDiagnostics);
    try {
        parse(text, options, diagnostics, reading);
    } catch (const std::bad_alloc&) {
        reading.data.reset();
        diagnostics.error(DiagnosticCode::IoError, 0, 0,
            AXISCOMP_TEXT("Error", "there is not enough memory"), {});
    }
    reading.diagnostics = diagnostics.take();
    reading.suppressed = diagnostics.suppressed();
    return reading;
}

/// Only points that occur twice make a grid of more dimensions: with other errors the file has
/// something else to be mended first.
std::optional<FullGrid> gridOfMoreDimensions(
    std::string_view text, const CsvOptions& options, const CsvReading& reading)
{
    const bool repeats = std::ranges::any_of(reading.diagnostics,
        [](const Diagnostic& d) { return d.code == DiagnosticCode::DuplicatePoint; });
    if (!repeats || reading.data || reading.cancelled)
        return std::nullopt;
    CsvOptions other = options;
    other.missing = MissingPoints::Refuse;
    other.maximumDiagnostics = 1;
    other.progress = {};
    for (other.dimensions = options.dimensions + 1; other.dimensions <= 3; ++other.dimensions) {
        const CsvReading grid = parseAs(text, other);
        if (!grid.data)
            continue;
        FullGrid found{other.dimensions, {}};
        for (const GridAxis& axis : grid.data->grid.axes)
            found.points.push_back(axis.size);
        return found;
    }
    return std::nullopt;
}

Diagnostic ofOtherDimensionality(const FullGrid& grid)
{
    return {Severity::Error, DiagnosticCode::OtherDimensionality, 0, 0,
        AXISCOMP_TEXT("Error", "a full {dimensions}D grid of {points} points")
            .with("dimensions", grid.dimensions)
            .with("points", Verbatim{sizeText(grid.points)}),
        {}, {}};
}

} // namespace

bool CsvReading::hasErrors() const
{
    return suppressed > 0 || std::ranges::any_of(diagnostics, [](const Diagnostic& d) {
        return d.severity == Severity::Error;
    });
}

std::string mereNote(std::string_view note)
{
    return "note: " + std::string(note);
}

std::vector<std::string> withoutStatements(std::vector<std::string> notes)
{
    for (std::string& note : notes)
        if (statedIn(note, signKey) || targetInComment(trimmed(note)))
            note = mereNote(note);
    return notes;
}

CsvReading parseCalibrationCsv(std::string_view text, const CsvOptions& options)
{
    CsvReading reading = parseAs(text, options);
    reading.fullGrid = gridOfMoreDimensions(text, options, reading);
    if (reading.fullGrid) {
        const auto first =
            std::ranges::find(reading.diagnostics, Severity::Error, &Diagnostic::severity);
        reading.diagnostics = {ofOtherDimensionality(*reading.fullGrid), Diagnostic(*first)};
        reading.suppressed = 0;
    }
    return reading;
}

CsvReading readCalibrationCsv(const std::filesystem::path& file, const CsvOptions& options)
{
    const auto content = loadContent(file, maximumBytes(options), options.threads);
    if (content)
        return parseCalibrationCsv(asText(content->view()), options);
    CsvReading reading;
    DiagnosticList diagnostics(options.maximumDiagnostics);
    const ErrorContext& context = content.error().context;
    if (const Argument* const size = context.find("size"))
        reportTooLarge(diagnostics, *size, maximumBytes(options));
    else
        diagnostics.error(
            DiagnosticCode::IoError, 0, 0, Text(AXISCOMP_TEXT("Error", "{reason}"), context), {});
    reading.diagnostics = diagnostics.take();
    reading.suppressed = diagnostics.suppressed();
    return reading;
}

} // namespace axiscomp
