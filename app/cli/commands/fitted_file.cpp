// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/fitted_file.h"

#include "app/common/arguments.h"
#include "core/csv/calibration_csv.h"
#include "core/formats/formats.h"
#include "core/formats/triamec/triamec_tables.h"
#include "core/io/local_file.h"
#include "core/neutral/neutral_table.h"
#include "core/table/large_correction.h"
#include "core/table/tam_table.h"

#include <algorithm>
#include <filesystem>

namespace axiscomp::app {

namespace {

std::string columnNames(const std::vector<CompensationTable>& tables)
{
    std::string names;
    for (const CompensationTable& table : tables)
        names += (names.empty() ? "" : ", ") + table.name;
    return names;
}

bool isPair(const std::vector<FittedTable>& fitted)
{
    return fitted.front().direction != Direction::Both;
}

/// One of several columns, where one was named or the format holds no more.
Result<void> chooseColumns(const FittedFileOptions& options, const TableFormat& format,
    const std::vector<FittedTable>& fitted, std::vector<CompensationTable>& tables)
{
    if (isPair(fitted)) {
        if (!options.table.empty())
            return wrongUsage("the tables of both directions are written together; for one of them "
                              "leave out --table and take --direction positive or negative",
                options.output.command);
        return {};
    }
    if (options.table.empty()) {
        if (format.facts.mostColumns == 1 && tables.size() > 1)
            return wrongUsage(std::string(format.facts.name)
                    + " holds one table: choose one with --table: " + columnNames(tables),
                options.output.command);
        return {};
    }
    const auto chosen = std::ranges::find(tables, options.table, &CompensationTable::name);
    if (chosen == tables.end())
        return fail(
            ErrorCode::TableNotFound, {{"table", options.table}, {"known", columnNames(tables)}});
    tables = {*chosen};
    return {};
}

/// The tables beside the one that was chosen (sourcesBeside).
std::shared_ptr<const NeutralTable> tablesBeside(
    const CalibrationData& chosen, const std::vector<FittedTable>& fitted)
{
    if (chosen.tables.size() == fitted.size())
        return nullptr;
    std::vector<CompensationTable> all;
    for (const FittedTable& made : fitted)
        all.push_back(made.table);
    const auto found = std::ranges::find(all, chosen.tables.front().name, &CompensationTable::name);
    const auto index = static_cast<std::size_t>(found - all.begin());
    const NeutralTable whole = neutralTable(CalibrationData{chosen.grid, std::move(all), {}});
    return sourcesBeside(std::span(&whole, 1), index);
}

Result<Bytes> convertedBytes(Environment& environment, const FittedFileOptions& options,
    const TableFormat& format, const DriveProfile& profile, const CalibrationData& data,
    const std::vector<FittedTable>& fitted)
{
    NeutralTable table = neutralTable(data);
    if (isPair(fitted))
        for (std::size_t i = 0; i < fitted.size(); ++i)
            table.columns[i].direction = fitted[i].direction;
    const bool isRepeated = std::ranges::all_of(data.tables,
        [](const CompensationTable& made) { return made.values.front() == made.values.back(); });
    if (options.turn && isRepeated && format.facts.holdsWrap)
        table.axes.front().wrap = options.turn;
    const NeutralTable tables[] = {std::move(table)};
    ConversionOptions conversion = options.conversion;
    conversion.targets.clear(); // stated already
    AXISCOMP_TRY(auto request,
        conversionRequest(conversion, calibration_csv::format(), format, data.grid.axes.size()));
    request.beside = tablesBeside(data, fitted);
    request.isComputed = options.isComputed;
    request.writing.layout = &profile.layout;
    request.writing.fileName = pathFromText(options.output.file).filename().string();
    AXISCOMP_TRY(const auto converted, convertTables(tables, request));
    for (const Text& line : conversionReport(converted, request))
        environment.console().note(options.output.file + ": " + line.english());
    const ByteView view = asBytes(converted.written.bytes);
    return Bytes(view.begin(), view.end());
}

Result<Bytes> tableBytes(Environment& environment, const FittedFileOptions& options,
    const CalibrationData& data, const DriveProfile& profile)
{
    const CompensationTable& table = data.tables.front();
    for (const Text& large : largeCorrections(table)) {
        if (!options.acceptsLarge)
            return fail(ErrorCode::LargeCorrection, {{"reason", large}});
        environment.warn(large.english());
    }
    AXISCOMP_CHECK(noteUnheld(environment, options.output.file, data.notes));
    return encodeTamTable(table, false, profile.layout);
}

} // namespace

Result<const TableFormat*> fittedFormat(Environment& environment, const FittedFileOptions& options)
{
    AXISCOMP_TRY(const auto format,
        options.output.isStandardOutput() && options.to.empty()
            ? Result<const TableFormat*>(&calibration_csv::format())
            : outputFormat(options.output.file, options.to));
    AXISCOMP_CHECK(checkOutput(environment, options.output, format->facts.isText));
    return format;
}

Result<void> stateTargets(
    const std::vector<std::string>& statements, std::vector<FittedTable>& fitted)
{
    if (statements.empty())
        return {};
    std::vector<CompensationTable> tables;
    for (const FittedTable& made : fitted)
        tables.push_back(made.table);
    const Grid& grid = fitted.front().table.grid;
    AXISCOMP_TRY(
        const auto stated, withTargets(neutralTable({grid, tables, {}}), statements, true));
    for (std::size_t n = 0; n < fitted.size(); ++n)
        fitted[n].table.target = stated.columns[n].target;
    return {};
}

Result<void> writeFitted(Environment& environment, const FittedFileOptions& options,
    const TableFormat& format, const DriveProfile& profile, const std::vector<FittedTable>& fitted,
    std::vector<std::string> notes)
{
    std::vector<CompensationTable> tables;
    for (const FittedTable& made : fitted)
        tables.push_back(made.table);
    AXISCOMP_CHECK(chooseColumns(options, format, fitted, tables));
    CalibrationData data{tables.front().grid, tables, std::move(notes)};
    const bool isOwn = isTriamec(format) && !isPair(fitted) && options.conversion.toSign.empty()
        && options.conversion.settings.empty();
    if (!isOwn) {
        AXISCOMP_TRY(
            const auto bytes, convertedBytes(environment, options, format, profile, data, fitted));
        return writeOutput(environment, options.output, bytes);
    }
    if (&format == &tam_table::format()) {
        AXISCOMP_TRY(const auto bytes, tableBytes(environment, options, data, profile));
        return writeOutput(environment, options.output, bytes);
    }
    return writeOutput(environment, options.output, asBytes(writeCalibrationCsv(data)));
}

} // namespace axiscomp::app
