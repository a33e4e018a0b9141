// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/input/table_input.h"

#include "app/common/arguments.h"
#include "app/common/number_text.h"
#include "app/common/standard_streams.h"
#include "core/conversion/table_choice.h"
#include "core/formats/formats.h"
#include "core/formats/triamec/triamec_tables.h"
#include "core/io/local_file.h"
#include "core/table/tam_table.h"
#include "core/text/token_scanner.h"
#include "drivecomm/profile/profile_loader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace axiscomp::app {

namespace {

constexpr std::uint64_t maximumTableFile = 64 * 1024 * 1024;

MissingPoints missingPoints(const TableInputOptions& options)
{
    if (options.crops)
        return MissingPoints::Crop;
    if (options.fill.empty())
        return MissingPoints::Refuse;
    if (options.fill == "nearest")
        return MissingPoints::Nearest;
    return options.fill == "plane" ? MissingPoints::Plane : MissingPoints::Smooth;
}

CsvReading readCsv(Environment& environment, const TableInputOptions& input,
    const StatedUnits& units, const std::optional<std::string>& text, int dimensions)
{
    const std::string& file = input.file;
    CsvOptions options;
    options.dimensions = dimensions;
    options.acceptsUneven = input.acceptsUneven;
    options.missing = missingPoints(input);
    options.snap = input.snap;
    options.units = units;
    options.stop = environment.stopToken();
    options.progress = [&](double fraction) {
        environment.console().progress("reading " + file, fraction);
    };
    CsvReading reading = text ? parseCalibrationCsv(*text, options)
                              : readCalibrationCsv(pathFromText(file), options);
    environment.console().clearProgress();
    return reading;
}

/// As whatever it is read, then: no number of dimensions helps.
bool isUnreadable(const CsvReading& reading)
{
    return std::ranges::any_of(reading.diagnostics, [](const Diagnostic& d) {
        return d.code == DiagnosticCode::IoError || d.code == DiagnosticCode::NotText;
    });
}

/// All of standard input, which can be read only once; nothing: a file is named.
using Piped = std::optional<std::string>;

/// stated: by --from; null: nothing.
Result<Piped> readPiped(
    Environment& environment, const TableInputOptions& options, const TableFormat* stated)
{
    if (options.file != standardStream)
        return std::nullopt;
    const bool mayBeCsv = stated == nullptr || stated == &calibration_csv::format();
    AXISCOMP_TRY(auto text,
        readStandardInput(
            environment.interrupt(), mayBeCsv ? CsvOptions{}.maximumBytes : maximumTableFile));
    return Piped(std::move(text));
}

Result<std::string> wholeInput(const TableInputOptions& options, const Piped& piped)
{
    if (piped)
        return *piped;
    AXISCOMP_TRY(auto bytes, loadFile(pathFromText(options.file), maximumTableFile));
    return std::string(asText(bytes));
}

std::string nameForFormat(const TableInputOptions& options)
{
    return options.file == standardStream ? displayName(options.file)
                                          : pathFromText(options.file).filename().string();
}

std::string beginningFor(const TableInputOptions& options, const Piped& piped)
{
    return piped ? piped->substr(0, longestBeginning) : beginningOf(pathFromText(options.file));
}

/// By content and name. Standard input, which has no name, is a calibration file where its content
/// leaves it open.
Result<const TableFormat*> recognisedFormat(
    Environment& environment, const TableInputOptions& options, const Piped& piped)
{
    const auto choice =
        chooseFormat(beginningFor(options, piped), nameForFormat(options), options.dimensions != 0);
    if (!choice && piped && !isOfMeasurement(choice))
        return &calibration_csv::format();
    if (!choice) {
        if (!piped)
            AXISCOMP_CHECK(loadFile(
                pathFromText(options.file), maximumTableFile)); // or there is nothing to know
        return fail(choice.error());
    }
    const std::string others = formatNames(choice->others);
    if (!isTriamec(*choice->format))
        environment.console().note(displayName(options.file) + ": read as "
            + std::string(choice->format->facts.name)
            + (others.empty() ? "" : "; it could be " + others + " as well: say it with --from"));
    return choice->format;
}

/// Options for incomplete grids that do nothing to a file of the format. Where numbers are expected
/// to change and would not, it is refused.
Result<void> checkIncompleteGridOptions(
    Environment& environment, const TableInputOptions& options, const TableFormat& format)
{
    const std::string name(format.facts.name);
    if (options.snap != 0.0 && &format != &calibration_csv::format())
        return wrongUsage("--snap takes positions of a calibration file for those of a grid, and "
                + displayName(options.file) + " is read as " + name + ": leave it out",
            options.command);
    if ((options.crops || !options.fill.empty()) && !format.facts.marksMissing)
        environment.warn(displayName(options.file) + ": " + (options.crops ? "--crop" : "--fill")
            + " does nothing: a file of the format " + name + " has a value for each point");
    return {};
}

/// The number of dimensions is the user's to choose, but when only one fits it can be named.
Result<CsvReading> refuseWithoutDimensions(Environment& environment,
    const TableInputOptions& options, const StatedUnits& units, const Piped& text)
{
    std::vector<int> fitting;
    for (int dimensions = 1; dimensions <= 3; ++dimensions) {
        CsvReading reading = readCsv(environment, options, units, text, dimensions);
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
    auto others = guessFormat(beginningFor(options, text), nameForFormat(options)).formats;
    std::erase(others, &calibration_csv::format());
    if (!others.empty())
        reason += "; it could be " + formatNames(others) + " as well: say it with --from";
    else if (text)
        reason += "; say it with --from if it is no calibration file";
    return wrongUsage(reason, options.command);
}

Result<TableInput> inspectCsv(Environment& environment, const TableInputOptions& options,
    const FormatSettings& settings, const Piped& text)
{
    const StatedUnits units = statedUnits(settings, options.units);
    AXISCOMP_TRY(auto reading,
        options.dimensions == 0
            ? refuseWithoutDimensions(environment, options, units, text)
            : Result<CsvReading>(readCsv(environment, options, units, text, options.dimensions)));
    if (reading.cancelled)
        return fail(ErrorCode::Cancelled);
    environment.diagnose(displayName(options.file), reading.diagnostics);
    if (reading.suppressed > 0)
        environment.console().note(displayName(options.file) + ": "
            + plural(reading.suppressed, "further error is", "further errors are") + " not listed");
    TableInput input;
    input.format = &calibration_csv::format();
    input.diagnostics = std::move(reading.diagnostics);
    input.suppressed = reading.suppressed;
    if (!reading.hasErrors()) {
        input.data = std::move(reading.data);
        input.knots = std::move(reading.knots);
    }
    return input;
}

Result<TableInput> inspectTamTable(
    const TableInputOptions& options, const FormatSettings& settings, const Piped& piped)
{
    AXISCOMP_TRY(auto profile, profileOf(options.profile));
    AXISCOMP_TRY(const auto text, wholeInput(options, piped));
    AXISCOMP_TRY(auto table, decodeTamTable(asBytes(text), profile.layout));
    const int dimensions = table.table.grid.dimensions();
    if (options.dimensions != 0 && options.dimensions != dimensions)
        return fail(
            ErrorCode::DimensionMismatch, {{"table", dimensions}, {"chosen", options.dimensions}});
    TableInput input;
    input.format = &tam_table::format();
    input.persistent = table.persistent;
    input.bytes = text.size();
    input.data = CalibrationData{table.table.grid, {}, {}};
    input.data->tables.push_back(std::move(table.table));
    stateUnits(*input.data, settings);
    return input;
}

Result<TableInput> inspectOther(Environment& environment, const TableFormat& format,
    const TableInputOptions& options, const FormatSettings& settings, const Piped& piped)
{
    if (format.read == nullptr)
        return wrongUsage(
            "the format " + std::string(format.facts.name) + " can be written, not read",
            options.command);
    AXISCOMP_TRY(const auto text, wholeInput(options, piped));
    TableReadOptions readOptions;
    readOptions.dimensions = options.dimensions;
    readOptions.settings = settings;
    readOptions.missing = missingPoints(options);
    readOptions.snap = options.snap;
    readOptions.stop = environment.stopToken();
    AXISCOMP_TRY(auto reading, format.read(text, readOptions));
    if (reading.cancelled)
        return fail(ErrorCode::Cancelled);
    environment.diagnose(displayName(options.file), reading.diagnostics);
    TableInput input;
    input.format = &format;
    input.bytes = text.size();
    input.diagnostics = std::move(reading.diagnostics);
    input.suppressed = reading.suppressed;
    input.tables = std::move(reading.tables);
    if (options.dimensions != 0 && input.isValid()
        && static_cast<int>(input.tables.front().axes.size()) != options.dimensions)
        return fail(ErrorCode::DimensionMismatch,
            {{"table", input.tables.front().axes.size()}, {"chosen", options.dimensions}});
    return input;
}

} // namespace

void addDimensionsOption(CLI::App& command, TableInputOptions& options)
{
    command
        .add_option("--dims", options.dimensions,
            AXISCOMP_HELP(
                "Help", "Number of dimensions of a CSV file: its first D columns are positions"))
        ->option_text("D")
        ->check(CLI::IsMember({1, 2, 3}).description(""));
}

void addFromOption(CLI::App& command, TableInputOptions& options)
{
    command
        .add_option("--from", options.from,
            AXISCOMP_HELP("Help", "Format of the input, if content and name leave it open"))
        ->option_text("FORMAT");
    command
        .add_option("--set-in", options.settings,
            AXISCOMP_HELP(
                "Help", "Setting that the file leaves open; `axiscomp formats NAME` lists them"))
        ->option_text("KEY=VALUE");
}

void addIncompleteGridOptions(CLI::App& command, TableInputOptions& options)
{
    const std::string group = AXISCOMP_HELP("Help", "Incomplete grids");
    CLI::Option* const fill =
        command
            .add_option("--fill", options.fill,
                AXISCOMP_HELP("Help",
                    "Give points without a value that of the nearest measured point (nearest), of "
                    "the plane through all of them (plane), or the values that bend least "
                    "(smooth)"))
            ->option_text("METHOD")
            ->check(CLI::IsMember(std::vector<std::string>{"nearest", "plane", "smooth"}))
            ->group(group);
    command
        .add_flag("--crop", options.crops,
            AXISCOMP_HELP(
                "Help", "Cut the grid to the largest part in which every point has a value"))
        ->excludes(fill)
        ->group(group);
    command
        .add_option("--snap", options.snap,
            AXISCOMP_HELP("Help",
                "Take positions of a calibration file that are this close to the grid for grid "
                "positions, in their unit"))
        ->option_text("TOLERANCE")
        ->check(CLI::Validator(
            [](const std::string& text) {
                const auto number = numberOf(text);
                return number && *number > 0.0 && std::isfinite(*number)
                    ? std::string()
                    : text + ": a tolerance is above 0";
            },
            "", ""))
        ->group(group);
}

CLI::Option* addTableOption(CLI::App& command, TableInputOptions& options)
{
    return command
        .add_option("--table", options.table,
            AXISCOMP_HELP("Help",
                "Table of the file, by name or by number from 1 (name:TEXT, #N where that could be "
                "either); "
                "not needed if there is only one"))
        ->option_text("TABLE");
}

void addProfileOption(CLI::App& command, std::string& profile)
{
    command
        .add_option("--profile", profile,
            AXISCOMP_HELP("Help", "Drive profile (JSON) in place of the built-in one, generic"))
        ->option_text("FILE");
}

Result<DriveProfile> profileOf(const std::string& file)
{
    if (file.empty())
        return drivecomm::genericProfile();
    return drivecomm::loadProfile(pathFromText(file));
}

std::string displayName(const std::string& file)
{
    return file == standardStream ? "<stdin>" : file;
}

Result<TableInput> inspectInput(Environment& environment, const TableInputOptions& options)
{
    AXISCOMP_TRY(auto given, settingsOf(options.settings, options.command));
    const TableFormat* format = nullptr;
    if (!options.from.empty()) {
        AXISCOMP_TRY(format, formatNamed(options.from));
    }
    AXISCOMP_TRY(const auto piped, readPiped(environment, options, format));
    if (format == nullptr) {
        AXISCOMP_TRY(format, recognisedFormat(environment, options, piped));
    }
    AXISCOMP_TRY(
        const auto settings, withStatedUnits(format->facts, std::move(given), options.units));
    AXISCOMP_CHECK(SettingValues::of(format->facts, settings, false));
    AXISCOMP_CHECK(checkIncompleteGridOptions(environment, options, *format));
    if (!isTriamec(*format))
        return inspectOther(environment, *format, options, settings, piped);
    return format == &calibration_csv::format() ? inspectCsv(environment, options, settings, piped)
                                                : inspectTamTable(options, settings, piped);
}

Result<TableInput> readInput(Environment& environment, const TableInputOptions& options)
{
    auto input = inspectInput(environment, options);
    if (!input || input->isValid())
        return input;
    const auto errors =
        std::ranges::count(input->diagnostics, Severity::Error, &Diagnostic::severity);
    return fail(ErrorCode::InvalidCalibration,
        {{"file", displayName(options.file)},
            {"count", static_cast<std::size_t>(errors) + input->suppressed}});
}

Result<FormatSettings> settingsOf(const std::vector<std::string>& pairs, const std::string& command)
{
    FormatSettings settings;
    for (const std::string& pair : pairs) {
        const std::size_t equals = pair.find('=');
        if (equals == std::string::npos || equals == 0)
            return wrongUsage("\"" + pair + "\" is no KEY=VALUE", command);
        const std::string key = pair.substr(0, equals);
        if (!settings.emplace(key, pair.substr(equals + 1)).second)
            return wrongUsage("the setting " + key + " is given twice", command);
    }
    return settings;
}

namespace {

Result<std::size_t> choose(const std::vector<TableName>& tables, const TableInputOptions& options)
{
    if (!options.table.empty())
        return axiscomp::chooseTable(tables, options.table);
    if (tables.size() == 1)
        return std::size_t{0};
    auto several = wrongUsage(displayName(options.file) + " has " + std::to_string(tables.size())
            + " tables: choose one with --table: " + tableList(tables),
        options.command);
    several.value().context.set("tables", tables.size()); // a program may take one after the other
    return several;
}

} // namespace

Result<std::size_t> chooseTable(const CalibrationData& data, const TableInputOptions& options)
{
    std::vector<TableName> choices;
    for (const CompensationTable& table : data.tables)
        choices.push_back({table.name, table.name});
    return choose(choices, options);
}

std::vector<NeutralTable> neutralTables(const TableInput& input)
{
    return input.data ? std::vector{neutralTable(*input.data, input.knots)} : input.tables;
}

std::vector<NeutralTable> neutralColumns(const TableInput& input)
{
    return separateColumns(neutralTables(input));
}

Result<ChosenColumn> chosenColumn(
    const std::vector<NeutralTable>& tables, const TableInputOptions& options)
{
    std::vector<NeutralTable> columns = separateColumns(tables);
    std::vector<TableName> choices;
    for (const NeutralTable& table : columns) {
        const CompensationColumn& column = table.columns.front();
        const std::string name = !column.name.empty() ? column.name : table.name;
        choices.push_back({name.empty() ? targetName(table, column) : name,
            name.empty() ? columnText(table, column).english() : name});
    }
    AXISCOMP_TRY(const auto index, choose(choices, options));
    return ChosenColumn{std::move(columns[index]), sourcesBeside(tables, index)};
}

} // namespace axiscomp::app
