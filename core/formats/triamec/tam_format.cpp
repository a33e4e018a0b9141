// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/formats.h"
#include "core/formats/triamec/triamec_tables.h"
#include "core/table/tam_table.h"

#include <array>

namespace axiscomp::tam_table {

namespace {

constexpr std::array<std::string_view, 1> extensions{".TAMtbl"};
constexpr std::array settings{
    FormatSetting{.key = "persistent",
        .kind = FormatSetting::Kind::YesNo,
        .meaning = AXISCOMP_TEXT("Error", "the drive stores the table in its flash"),
        .standard = "no",
        .forWriting = true},
    // Not for writing: a drive takes the numbers in the unit of its axis, and no other.
    FormatSetting{.key = "position-unit",
        .kind = FormatSetting::Kind::Text,
        .meaning = AXISCOMP_TEXT("Error", "unit of the positions, where the file does not say it"),
        .forReading = true},
    FormatSetting{.key = "value-unit",
        .kind = FormatSetting::Kind::Text,
        .meaning = AXISCOMP_TEXT("Error", "unit of the values, where the file does not say it"),
        .forReading = true},
};
constexpr std::array<std::string_view, 1> rules{
    "The drive adds the value, x_ref - x_enc, to the encoder position (AN140 3.1).",
};
constexpr std::array<std::string_view, 2> assumptions{
    "The layout of the bytes is not published: it is ours, and data of the drive profile.",
    "Outside of the table the drive holds the values at the ends.",
};

Result<const TableLayout*> layoutOf(const TableLayout* layout)
{
    if (layout != nullptr)
        return layout;
    return fail(ErrorCode::InvalidArgument,
        {{"reason",
            AXISCOMP_TEXT("Error", "a TAM table needs the table layout of a drive profile")}});
}

Result<TableReading> read(std::string_view text, const TableReadOptions& options)
{
    AXISCOMP_TRY(const auto layout, layoutOf(options.layout));
    AXISCOMP_CHECK(SettingValues::of(tam_table::format().facts, options.settings, false));
    AXISCOMP_TRY(auto table, decodeTamTable(asBytes(text), *layout));
    const int dimensions = table.table.grid.dimensions();
    if (options.dimensions != 0 && options.dimensions != dimensions)
        return fail(
            ErrorCode::DimensionMismatch, {{"table", dimensions}, {"chosen", options.dimensions}});
    TableReading reading;
    CalibrationData data{table.table.grid, {std::move(table.table)}, {}};
    stateUnits(data, options.settings);
    reading.tables.push_back(neutralTable(data));
    return reading;
}

Result<WrittenTables> write(std::span<const NeutralTable> tables, const TableWriteOptions& options)
{
    AXISCOMP_TRY(const auto layout, layoutOf(options.layout));
    AXISCOMP_TRY(
        const auto values, SettingValues::of(tam_table::format().facts, options.settings, true));
    AXISCOMP_TRY(auto data, calibrationData(tables.front()));
    const CompensationTable& table = data.tables.front();
    AXISCOMP_TRY(const auto bytes, encodeTamTable(table, values.yes("persistent"), *layout));
    WrittenTables written;
    written.bytes = asText(bytes);
    written.held.push_back(neutralTable(data));
    return written;
}

} // namespace

const TableFormat& format()
{
    static const TableFormat format{
        .facts = {.name = "tamtbl",
            .controller = "Triamec",
            .description = AXISCOMP_TEXT(
                "Error", "table file of the drive, laid out as the drive profile says"),
            .extensions = extensions,
            .mostDimensions = 3,
            .knots = KnotRule::Even,
            .holdsPersistency = true,
            .isText = false,
            .numbers = "float32",
            .sign = SignConvention::Feedback,
            .signEvidence = Evidence::Published,
            .behaviour = {.outside = Outside::Hold, .usesFloat = true},
            .outsideEvidence = Evidence::Assumed,
            .settings = settings,
            .rules = rules,
            .assumptions = assumptions},
        .recognise = nullptr,
        .read = read,
        .write = write};
    return format;
}

} // namespace axiscomp::tam_table
