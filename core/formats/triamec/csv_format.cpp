// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/calibration_csv.h"
#include "core/csv/cells.h"
#include "core/csv/fields.h"
#include "core/formats/formats.h"
#include "core/formats/triamec/triamec_tables.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <array>

namespace axiscomp::calibration_csv {

namespace {

constexpr std::array settings{
    FormatSetting{.key = "position-unit",
        .kind = FormatSetting::Kind::Text,
        .meaning =
            AXISCOMP_TEXT("Error", "unit of the positions, in place of what the header says"),
        .forReading = true},
    FormatSetting{.key = "value-unit",
        .kind = FormatSetting::Kind::Text,
        .meaning = AXISCOMP_TEXT("Error", "unit of the values, in place of what the header says"),
        .forReading = true},
};
constexpr std::array<std::string_view, 1> extensions{".csv"};
constexpr std::array<std::string_view, 3> rules{
    "A header line, then one line for each grid point: the first 1, 2 or 3 columns are reference "
    "positions, each further one is a compensation table (AN140 2.3).",
    "The number of dimensions is chosen by the user, since the file does not say it.",
    "Values are x_ref - x_enc, in the unit of the positions, and are added to the encoder position "
    "(AN140 3.1).",
};
constexpr std::array<std::string_view, 1> assumptions{
    "Outside of the table the drive holds the values at the ends.",
};

Result<TableReading> read(std::string_view text, const TableReadOptions& options)
{
    AXISCOMP_CHECK(SettingValues::of(calibration_csv::format().facts, options.settings, false));
    if (options.dimensions < 1 || options.dimensions > 3)
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT(
                    "Error", "a calibration file needs the number of its dimensions: 1, 2 or 3")}});
    CsvOptions csv;
    csv.dimensions = options.dimensions;
    csv.acceptsUneven = true;
    csv.missing = options.missing;
    csv.units = statedUnits(options.settings);
    csv.snap = options.snap;
    csv.maximumDiagnostics = options.maximumDiagnostics;
    csv.stop = options.stop;
    CsvReading parsed = parseCalibrationCsv(text, csv);
    TableReading reading;
    reading.diagnostics = std::move(parsed.diagnostics);
    reading.suppressed = parsed.suppressed;
    reading.cancelled = parsed.cancelled;
    if (parsed.data)
        reading.tables.push_back(neutralTable(*parsed.data, parsed.knots));
    return reading;
}

bool isNumeric(const csv::Cell& cell)
{
    return numberOf(cell.text).has_value();
}

/// Between semicolons, where a comma may stand for the decimal point; statements of a program end
/// with them as well.
bool beginsWithNumber(const std::vector<csv::Cell>& row)
{
    std::string first(row.front().text);
    std::ranges::replace(first, ',', '.');
    return numberOf(first).has_value();
}

/// A header of at least two names, and a line of as many numbers.
Recognition recognise(std::string_view text)
{
    constexpr std::size_t all = std::string_view::npos;
    std::vector<csv::Cell> header;
    std::vector<csv::Cell> row;
    for (const char separator : {';', ',', '\t'}) {
        TextLines lines(text);
        header.clear();
        while (const auto line = lines.next()) {
            if (isCsvComment(line->text))
                continue;
            csv::splitCells(line->text, separator, all, header.empty() ? header : row);
            if (!row.empty())
                break;
        }
        const bool isHeader = header.size() >= 2 && std::ranges::none_of(header, isNumeric)
            && !header.back().text.empty();
        if (isHeader && row.size() == header.size()
            && (separator == ';' ? beginsWithNumber(row) : std::ranges::all_of(row, isNumeric)))
            return Recognition::Possible;
        row.clear();
    }
    return Recognition::No;
}

Result<WrittenTables> write(std::span<const NeutralTable> tables, const TableWriteOptions& options)
{
    AXISCOMP_CHECK(SettingValues::of(calibration_csv::format().facts, options.settings, true));
    AXISCOMP_TRY(auto data, calibrationData(tables.front()));
    for (std::size_t n = 0; n < data.grid.axes.size(); ++n) {
        std::string& name = data.grid.axes[n].name;
        if (name.empty())
            name = "Dim " + std::to_string(n + 1);
    }
    for (CompensationTable& table : data.tables)
        table.grid = data.grid;
    WrittenTables written;
    written.bytes = writeCalibrationCsv(data);
    written.held.push_back(neutralTable(data));
    return written;
}

} // namespace

const TableFormat& format()
{
    static const TableFormat format{
        .facts = {.name = "csv",
            .controller = "Triamec",
            .description = AXISCOMP_TEXT(
                "Error", "calibration file: reference positions and compensation values"),
            .extensions = extensions,
            .mostDimensions = 3,
            .knots = KnotRule::Even,
            .mostColumns = 0,
            .mostBytes = std::size_t{1} << 30U,
            .holdsNames = true,
            .holdsUnits = true,
            .marksMissing = true,
            .holdsNotes = true,
            .numbers = "decimal text",
            .sign = SignConvention::Feedback,
            .signEvidence = Evidence::Published,
            .behaviour = {.outside = Outside::Hold, .usesFloat = true},
            .outsideEvidence = Evidence::Assumed,
            .settings = settings,
            .rules = rules,
            .assumptions = assumptions},
        .recognise = recognise,
        .read = read,
        .write = write};
    return format;
}

} // namespace axiscomp::calibration_csv
