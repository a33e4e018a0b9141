// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/table_input.h"

#include "app/cli/standard_input.h"
#include "app/common/arguments.h"
#include "app/common/number_text.h"
#include "core/drive_store.h"
#include "core/tam_table.h"
#include "drivecomm/profile_loader.h"

#include <algorithm>
#include <charconv>

namespace axiscomp::app {

namespace {

constexpr std::uint64_t maximumTableFile = 64 * 1024 * 1024;

CsvReading readCsv(Environment& environment, const std::string& file,
    const std::optional<std::string>& text, int dimensions)
{
    CsvOptions options;
    options.dimensions = dimensions;
    options.stop = environment.stopToken();
    options.progress = [&](double fraction) {
        environment.console().progress("reading " + file, fraction);
    };
    CsvReading reading =
        text ? parseCalibrationCsv(*text, options) : readCalibrationCsv(file, options);
    environment.console().clearProgress();
    return reading;
}

bool isUnreadable(const CsvReading& reading)
{
    return std::ranges::any_of(
        reading.diagnostics, [](const Diagnostic& d) { return d.code == DiagnosticCode::IoError; });
}

/// The number of dimensions is the user's to choose, but when only one fits it can be named.
Result<CsvReading> refuseWithoutDimensions(Environment& environment,
    const TableInputOptions& options, const std::optional<std::string>& text)
{
    std::vector<int> fitting;
    for (int dimensions = 1; dimensions <= 3; ++dimensions) {
        CsvReading reading = readCsv(environment, options.file, text, dimensions);
        if (reading.cancelled)
            return fail(ErrorCode::Cancelled);
        if (isUnreadable(reading))
            return reading;
        if (!reading.hasErrors())
            fitting.push_back(dimensions);
    }
    std::string reason = "the number of dimensions is missing: give --dims 1, 2 or 3";
    if (fitting.size() == 1)
        reason += "; only --dims " + std::to_string(fitting.front()) + " fits "
            + displayName(options.file);
    return wrongUsage(reason, options.command);
}

Result<TableInput> inspectCsv(Environment& environment, const TableInputOptions& options)
{
    std::optional<std::string> text;
    if (options.file == standardStream) {
        auto all = readStandardInput(environment.interrupt(), CsvOptions{}.maximumBytes);
        if (!all)
            return fail(all.error());
        text = std::move(*all);
    }
    auto reading = options.dimensions == 0
        ? refuseWithoutDimensions(environment, options, text)
        : Result<CsvReading>(readCsv(environment, options.file, text, options.dimensions));
    if (!reading)
        return fail(reading.error());
    if (reading->cancelled)
        return fail(ErrorCode::Cancelled);
    environment.diagnose(displayName(options.file), reading->diagnostics);
    if (reading->suppressed > 0)
        environment.console().note(displayName(options.file) + ": "
            + plural(reading->suppressed, "further error is", "further errors are")
            + " not listed");
    TableInput input;
    input.format = TableFormat::Csv;
    input.diagnostics = std::move(reading->diagnostics);
    input.suppressed = reading->suppressed;
    if (!reading->hasErrors())
        input.data = std::move(reading->data);
    return input;
}

Result<TableInput> inspectTamTable(Environment& environment, const TableInputOptions& options)
{
    auto profile = profileOf(options.profile);
    if (!profile)
        return fail(profile.error());
    Result<Bytes> bytes;
    if (options.file == standardStream) {
        auto text = readStandardInput(environment.interrupt(), maximumTableFile);
        if (!text)
            return fail(text.error());
        const ByteView view = asBytes(*text);
        bytes = Bytes(view.begin(), view.end());
    } else {
        bytes = loadFile(options.file, maximumTableFile);
    }
    if (!bytes)
        return fail(bytes.error());
    auto table = decodeTamTable(*bytes, profile->layout);
    if (!table)
        return fail(table.error());
    const int dimensions = table->table.grid.dimensions();
    if (options.dimensions != 0 && options.dimensions != dimensions)
        return fail(ErrorCode::DimensionMismatch,
            {{"table", std::to_string(dimensions)},
                {"chosen", std::to_string(options.dimensions)}});
    TableInput input;
    input.format = TableFormat::TamTable;
    input.persistent = table->persistent;
    input.bytes = bytes->size();
    input.data = CalibrationData{table->table.grid, {}, {}};
    input.data->tables.push_back(std::move(table->table));
    return input;
}

std::string listTables(const CalibrationData& data)
{
    std::string list;
    for (std::size_t i = 0; i < data.tables.size(); ++i)
        list += (i == 0 ? "" : ", ") + std::to_string(i + 1) + " (" + data.tables[i].name + ")";
    return list;
}

} // namespace

void addDimensionsOption(CLI::App& command, TableInputOptions& options)
{
    command
        .add_option("--dims", options.dimensions,
            "Number of dimensions of a CSV file: its first D columns are positions")
        ->option_text("D")
        ->check(CLI::IsMember({1, 2, 3}).description(""));
}

void addFromOption(CLI::App& command, TableInputOptions& options)
{
    command.add_option("--from", options.from, "Format of the input, if its name does not tell")
        ->option_text("FORMAT");
}

void addTableOption(CLI::App& command, TableInputOptions& options)
{
    command
        .add_option("--table", options.table,
            "Which table of the file, by name or by number from 1; not needed for a single one")
        ->option_text("TABLE");
}

void addProfileOption(CLI::App& command, std::string& profile)
{
    command
        .add_option(
            "--profile", profile, "Drive profile (JSON) in place of the built-in one, generic")
        ->option_text("FILE");
}

Result<DriveProfile> profileOf(const std::string& file)
{
    if (file.empty())
        return drivecomm::genericProfile();
    return drivecomm::loadProfile(file);
}

std::string displayName(const std::string& file)
{
    return file == standardStream ? "<stdin>" : file;
}

Result<TableInput> inspectInput(Environment& environment, const TableInputOptions& options)
{
    const bool isUnnamed = options.file == standardStream && options.from.empty();
    const auto format = isUnnamed ? Result<TableFormat>(TableFormat::Csv)
                                  : chooseFormat(options.file, options.from);
    if (!format)
        return fail(format.error());
    return *format == TableFormat::Csv ? inspectCsv(environment, options)
                                       : inspectTamTable(environment, options);
}

Result<TableInput> readInput(Environment& environment, const TableInputOptions& options)
{
    auto input = inspectInput(environment, options);
    if (!input || input->data)
        return input;
    const auto errors =
        std::ranges::count(input->diagnostics, Severity::Error, &Diagnostic::severity);
    return fail(ErrorCode::InvalidCalibration,
        {{"file", displayName(options.file)},
            {"count", std::to_string(static_cast<std::size_t>(errors) + input->suppressed)}});
}

Result<std::size_t> chooseTable(const CalibrationData& data, const TableInputOptions& options)
{
    if (options.table.empty() && data.tables.size() == 1)
        return std::size_t{0};
    if (options.table.empty())
        return wrongUsage(displayName(options.file) + " has " + std::to_string(data.tables.size())
                + " tables: choose one with --table: " + listTables(data),
            options.command);
    const auto named = std::ranges::find(data.tables, options.table, &CompensationTable::name);
    if (named != data.tables.end())
        return static_cast<std::size_t>(named - data.tables.begin());
    std::size_t number = 0;
    const char* const last = options.table.data() + options.table.size();
    const auto [end, error] = std::from_chars(options.table.data(), last, number);
    if (error == std::errc{} && end == last && number >= 1 && number <= data.tables.size())
        return number - 1;
    return fail(ErrorCode::TableNotFound, {{"table", options.table}, {"known", listTables(data)}});
}

} // namespace axiscomp::app
