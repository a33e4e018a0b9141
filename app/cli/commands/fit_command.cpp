// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/commands/fit_drive.h"
#include "app/cli/commands/fit_record.h"
#include "app/cli/commands/fitted_file.h"
#include "app/cli/input/judging_options.h"
#include "app/cli/input/known_tables.h"
#include "app/cli/input/measurement_input.h"
#include "app/cli/output/fit_output.h"
#include "app/cli/output/json_output.h"
#include "app/cli/output/judgement_output.h"
#include "app/common/arguments.h"
#include "app/common/number_checks.h"
#include "app/common/number_text.h"
#include "core/io/local_file.h"
#include "core/metrology/record/fit_record.h"
#include "core/metrology/record/reference_reading.h"
#include "core/table/tam_table.h"
#include "core/table/target_axis.h"

#include <algorithm>
#include <iterator>
#include <map>

namespace axiscomp::app {

namespace {

constexpr std::string_view ontoDrive = "drive";

struct FitOptions {
    explicit FitOptions(const std::string& command) : drive(command) { }

    FitDrive drive;
    MeasurementInputOptions input;
    CorrectionOptions correction;
    ToleranceOptions tolerance;
    FittedFileOptions file;
    std::string record; ///< empty: none is begun
    std::string method = "linear";
    std::optional<double> smoothness;
    std::vector<double> periods;
    std::optional<int> harmonics; ///< 1
    std::string direction = "mean";
    std::string by; ///< temperature; empty: position alone
    std::string zero;
    std::optional<double> home;
    std::string removedSlope;
    std::string removedDrift;
    std::string lookupAt;
    std::string measuredWith; ///< off, on, or a file
    std::string onto; ///< drive, or a file
    double gain = 1.0;
    std::string remove;
    std::string fill;
    bool isRobust = false;
    std::optional<double> speed;
};

/// What the options say of the state of the drive; what is found in files and on the drive.
struct StateSources {
    std::optional<KnownTables> onto;
    std::vector<KnownTables> others;
    std::optional<MeasuredState> stated;
    std::optional<LookupAt> lookupAt; ///< by the drive's source
};

Result<void> takeZero(const FitOptions& options, FitSettings& settings)
{
    static const std::map<std::string, FitZero> words{{"", FitZero::Automatic},
        {"home", FitZero::Home}, {"first", FitZero::First}, {"mean", FitZero::Mean},
        {"keep", FitZero::Keep}};
    settings.home = options.home;
    if (const auto word = words.find(options.zero); word != words.end()) {
        settings.zero = word->second;
        return {};
    }
    settings.zero = FitZero::Position;
    for (const std::string& text : targetList(options.zero)) {
        const auto number = numberFromText(text);
        if (!number)
            return wrongUsage(options.zero
                    + " is no zero: it is home, first, mean, keep, or a position for each axis",
                options.input.command);
        settings.zeroPosition.push_back(*number);
    }
    return {};
}

Result<void> takeRemoval(
    const FitOptions& options, const Measurement& measurement, FitSettings& settings)
{
    const std::string along = "rigid:";
    if (options.remove == "rigid") {
        settings.remove = BodyRemoval::Rigid;
    } else if (options.remove == "scale") {
        settings.remove = BodyRemoval::Scale;
    } else if (options.remove.starts_with(along)) {
        const auto& axes = measurement.points.axes;
        const auto axis = std::ranges::find(axes, options.remove.substr(along.size()));
        if (axis == axes.end())
            return wrongUsage(
                options.remove + ": the measurement has no such axis", options.input.command);
        settings.remove = BodyRemoval::RigidAlong;
        settings.removeAlong = static_cast<std::size_t>(axis - axes.begin());
    } else if (!options.remove.empty()) {
        return wrongUsage(
            options.remove + ": --remove takes rigid, rigid:AXIS or scale", options.input.command);
    }
    return {};
}

Result<void> takeGrid(const FitOptions& options, FitSettings& settings)
{
    const ConversionOptions& grid = options.file.conversion;
    for (const std::size_t points : grid.points)
        settings.grid.push_back({.points = points});
    for (const double distance : grid.distances)
        settings.grid.push_back({.distance = distance});
    settings.within = grid.within;
    if (settings.within && !(*settings.within > 0.0))
        return wrongUsage("--within is above 0", options.input.command);
    settings.holdsEnds = grid.holdsEnds;
    return {};
}

Result<FitSettings> settingsFrom(const FitOptions& options, const Measurement& measurement,
    const StateSources& sources, const DriveProfile& profile)
{
    FitSettings settings;
    settings.method = fitMethodNamed(options.method).value_or(FitMethod::Linear);
    settings.smoothness = options.smoothness;
    settings.periods = {options.periods, options.harmonics.value_or(1)};
    if (options.harmonics && settings.method != FitMethod::Harmonic && options.periods.empty())
        return wrongUsage(
            "--harmonics are those of --method harmonic, or of the periods of --method smooth "
            "(--period); the method "
                + options.method + " has none",
            options.input.command);
    settings.turn = options.file.turn;
    settings.direction = fitDirectionNamed(options.direction).value_or(FitDirection::Mean);
    if (!options.removedSlope.empty())
        settings.slope =
            options.removedSlope == "lsq" ? SlopeRemoval::LeastSquares : SlopeRemoval::Ends;
    if (!options.removedDrift.empty())
        settings.drift =
            options.removedDrift == "offset" ? DriftRemoval::Offset : DriftRemoval::Trend;
    const auto stated = lookupAtNamed(options.lookupAt);
    settings.lookupAt = stated ? stated : sources.lookupAt;
    settings.isByTemperature = !options.by.empty();
    settings.gain = options.gain;
    settings.mostPoints = profile.mostPoints();
    if (!options.fill.empty())
        settings.farPoints = options.fill == "smooth" ? FarPoints::Smooth : FarPoints::Nearest;
    settings.isRobust = options.isRobust;
    settings.speed = options.speed;
    AXISCOMP_CHECK(takeZero(options, settings));
    AXISCOMP_CHECK(takeRemoval(options, measurement, settings));
    AXISCOMP_CHECK(takeGrid(options, settings));
    return settings;
}

TableInputOptions tableFile(
    const FitOptions& options, const Measurement& measurement, const std::string& file)
{
    TableInputOptions input;
    input.command = options.input.command;
    input.file = file;
    input.profile = options.drive.profile();
    input.dimensions = measurement.kind == MeasurementKind::Points
        ? static_cast<int>(measurement.points.axes.size())
        : 1;
    return input;
}

/// The axis that the table is made for, where --target says it.
std::string statedAxis(const FitOptions& options)
{
    const auto& targets = options.file.conversion.targets;
    return targets.size() == 1 ? targets.front() : std::string();
}

/// Which table of a file was active. Columns of points have one each, all of which were.
Result<std::size_t> statedTable(
    const FitOptions& options, const Measurement& measurement, const KnownTables& tables)
{
    if (measurement.kind == MeasurementKind::Points)
        return std::size_t{0};
    const std::string axis = statedAxis(options);
    return tableOfAxis(tables, axis.empty() ? measurement.header.axis : axis);
}

Result<StateSources> readStates(
    Environment& environment, const FitOptions& options, const Measurement& measurement)
{
    const std::string unit(positionUnit(measurement));
    StateSources sources;
    auto lookupAt = lookupAtNamed(options.lookupAt);
    if (options.onto == ontoDrive) {
        AXISCOMP_TRY(auto drive, options.drive.read(environment, measurement, lookupAt));
        sources.onto = std::move(drive.active);
        sources.lookupAt = drive.lookupAt;
        sources.others = std::move(drive.backups);
        lookupAt = lookupAt ? lookupAt : drive.lookupAt;
    } else if (!options.onto.empty()) {
        AXISCOMP_TRY(sources.onto,
            tablesOfFile(
                environment, tableFile(options, measurement, options.onto), unit, lookupAt));
    }
    if (options.measuredWith == "off" || options.measuredWith == "on") {
        sources.stated = MeasuredState{
            options.measuredWith == "off" ? MeasuredState::Kind::Off : MeasuredState::Kind::On, {}};
    } else if (!options.measuredWith.empty()) {
        AXISCOMP_TRY(auto tables,
            tablesOfFile(environment, tableFile(options, measurement, options.measuredWith), unit,
                lookupAt));
        AXISCOMP_TRY(const std::size_t stated, statedTable(options, measurement, tables));
        sources.stated = axiscomp::statedTable(tables, stated, measurement.header);
        sources.others.insert(sources.others.begin(), std::move(tables));
    }
    return sources;
}

Result<void> writeFittedTables(Environment& environment, const FitOptions& options,
    const TableFormat& format, const DriveProfile& profile, const MeasurementInput& input,
    const MadeCorrections& corrections, const FitSettings& settings, const FitReport& report)
{
    const Measurement& measurement = input.measurement;
    FittedFileOptions file = options.file;
    file.isComputed =
        !isReferenceReadAtLargest(measurement, corrections.corrections, settings, report);
    return writeFitted(environment, file, format, profile, report.tables,
        notesOfFit(sourcesText(input.sources) + ": " + measurementSummary(measurement), measurement,
            settings, report));
}

/// What a person reads. format: of the table that was written; null: none.
void tell(Environment& environment, const FitOptions& options, const MeasurementInput& input,
    const MadeCorrections& corrections, const FitReport& report, const std::string& text,
    const TableFormat* format)
{
    for (const FitRemark& remark : report.remarks)
        if (remark.isWarning)
            environment.warn(remark.text.english());
    if (format && options.file.output.isStandardOutput())
        return;
    environment.print(sourcesText(input.sources) + ": " + measurementSummary(input.measurement)
        + "\n" + corrections.text + text);
    if (format)
        environment.print(
            "\nWrote " + options.file.output.file + ": " + std::string(format->facts.name) + ".\n");
    if (!options.record.empty())
        environment.print("Began the record " + options.record + ".\n");
}

Result<ExitCode> runFit(Environment& environment, const FitOptions& options)
{
    const bool isWritten = !options.file.output.file.empty();
    const TableFormat* format = nullptr;
    if (isWritten) {
        AXISCOMP_TRY(format, fittedFormat(environment, options.file));
        AXISCOMP_CHECK(checkNoInput(options.file.output, options.input.files));
    }
    if (!options.record.empty()) {
        AXISCOMP_CHECK(checkNewRecord(options.record, options.input.command));
        if (fitDirectionNamed(options.direction) == FitDirection::Both)
            return wrongUsage("a record is of a drive, which has one value for both directions; "
                              "leave out --record or --direction both",
                options.input.command);
    }
    AXISCOMP_TRY(const auto profile, profileOf(options.drive.profile()));
    MeasurementInputOptions reading = options.input;
    reading.keepsFiles = !options.record.empty();
    AXISCOMP_TRY(auto input, readMeasurements(environment, reading));
    Measurement& measurement = input.measurement;
    if (!options.correction.isEmpty() && !measurement.hasTargets())
        return fail(ErrorCode::NoTargets, {{"file", options.input.files.front()}});
    AXISCOMP_TRY(
        const auto corrections, correct(measurement, options.correction, options.input.command));
    AXISCOMP_TRY(const auto sources, readStates(environment, options, measurement));
    AXISCOMP_TRY(auto settings, settingsFrom(options, measurement, sources, profile));
    AXISCOMP_TRY(auto limits,
        readTolerances(environment, measurement, options.tolerance, options.input.command));
    settings.tolerances = limits.tolerances;
    settings.uncertainty = limits.uncertainty;
    AXISCOMP_TRY(const auto state,
        findState({measurement.header.compensation, sources.stated,
            hasRawValues(measurement, statedAxis(options)), sources.onto ? &*sources.onto : nullptr,
            sources.others, statedAxis(options), measurement.header.compensationOfSome}));
    AXISCOMP_TRY(
        auto report, fitMeasurement(measurement, settings, state, environment.stopToken()));
    AXISCOMP_CHECK(stateTargets(options.file.conversion.targets, report.tables));

    std::vector<std::uint32_t> crcs;
    for (const FittedTable& made : report.tables) {
        AXISCOMP_TRY(const auto crc, elementCrc(made.table, profile.layout));
        crcs.push_back(crc);
    }
    if (isWritten)
        AXISCOMP_CHECK(writeFittedTables(
            environment, options, *format, profile, input, corrections, settings, report));
    if (!options.record.empty()) {
        AXISCOMP_TRY(
            const auto record, recordOfFit(input, options.input, corrections, settings, report));
        AXISCOMP_CHECK(saveRecord(pathFromText(options.record), record));
    }
    tell(environment, options, input, corrections, report,
        fitText(measurement, settings, report, crcs, profile), format);
    Json document = fitJson(measurement, settings, report, crcs);
    document["source"] = sourcesJson(input.sources);
    document["corrections"] = corrections.document;
    document["uncertainty"] = std::move(limits.terms);
    document["record"] = options.record.empty() ? Json(nullptr) : Json(options.record);
    document["output"] = isWritten ? Json(options.file.output.file) : Json(nullptr);
    for (const Diagnostic& diagnostic : input.warnings)
        document["warnings"].push_back(toJson(diagnostic));
    environment.document(document);
    return report.isWithinTolerances() ? ExitCode::Done : ExitCode::ToleranceNotMet;
}

void addOutputFileOptions(CLI::App& command, FitOptions& options)
{
    command
        .add_option("-o,--output", options.file.output.file,
            AXISCOMP_HELP("Help",
                "Table file to write, replaced if it exists; - for standard output. Without it "
                "nothing is written"))
        ->option_text("FILE");
    command
        .add_option("--record", options.record,
            AXISCOMP_HELP("Help",
                "Begin a record of the compensation (.axcal): measurement, table and what it "
                "promises, "
                "for compare and report"))
        ->option_text("FILE.axcal");
    command
        .add_option("--to", options.file.to,
            AXISCOMP_HELP("Help", "Format of the output, if its name leaves it open"))
        ->option_text("FORMAT");
    command
        .add_option("--table", options.file.table,
            AXISCOMP_HELP(
                "Help", "Write this column of points only, where the format holds one table"))
        ->option_text("NAME");
    command.add_flag("--accept-large", options.file.acceptsLarge,
        AXISCOMP_HELP("Help",
            "Put corrections above 1 % of the range, or with a slope above 0.1, into a .TAMtbl"));
    addTargetOption(command, options.file.conversion);
    addOutputOptions(command, options.file.conversion);
}

void addCurveOptions(CLI::App& command, FitOptions& options)
{
    const std::string group = AXISCOMP_HELP("Help", "Curve and grid");
    command
        .add_option("--method", options.method,
            AXISCOMP_HELP("Help",
                "Curve through the means: linear (the default), cubic, spline, smooth or harmonic"))
        ->option_text("METHOD")
        ->check(CLI::IsMember(
            std::vector<std::string>{"linear", "cubic", "spline", "smooth", "harmonic"}))
        ->group(group);
    command
        .add_option("--smoothness", options.smoothness,
            AXISCOMP_HELP("Help",
                "Of the method smooth, and of points and tracks; by cross-validation unless given"))
        ->option_text("S")
        ->check(numberFromZero())
        ->group(group);
    command
        .add_option("--period", options.periods,
            AXISCOMP_HELP("Help",
                "Known periods, such as the lead of the screw, fitted by the method smooth"))
        ->option_text("P[,P]")
        ->delimiter(',')
        ->group(group);
    command
        .add_option("--harmonics", options.harmonics,
            AXISCOMP_HELP("Help",
                "Harmonics of each period, and of the method harmonic, the fundamental counted (1 "
                "unless given)"))
        ->option_text("K")
        ->check(CLI::Range(1, 100))
        ->group(group);
    command
        .add_option("--turn", options.file.turn,
            AXISCOMP_HELP("Help",
                "Length of a turn of a modulo axis, such as 360: the table ends as it begins"))
        ->option_text("LENGTH")
        ->check(numberAboveZero())
        ->group(group);
    command
        .add_option("--direction", options.direction,
            AXISCOMP_HELP("Help",
                "Which runs the table is made of: mean of both (the default), positive or "
                "negative; "
                "both makes a table for each, for controllers that keep two"))
        ->option_text("CHOICE")
        ->check(CLI::IsMember(std::vector<std::string>{"mean", "positive", "negative", "both"}))
        ->group(group);
    command
        .add_option("--by", options.by,
            AXISCOMP_HELP("Help",
                "temperature: a table over position and temperature, from runs in several thermal "
                "states; --points and --distance take a second number for it"))
        ->option_text("WHAT")
        ->check(CLI::IsMember(std::vector<std::string>{"temperature"}))
        ->group(group);
    command
        .add_option("--points", options.file.conversion.points,
            AXISCOMP_HELP("Help",
                "Even grid with N points, for each axis or for all; unless given, that of the "
                "targets, where they are even"))
        ->option_text("N[,N[,N]]")
        ->delimiter(',')
        ->check(CLI::Range(2, 100'000'000))
        ->group(group);
    command
        .add_option("--distance", options.file.conversion.distances,
            AXISCOMP_HELP("Help", "Even grid with spacing D, for each axis or for all"))
        ->option_text("D[,D[,D]]")
        ->delimiter(',')
        ->check(numberAboveZero())
        ->excludes("--points")
        ->group(group);
    command
        .add_option("--within", options.file.conversion.within,
            AXISCOMP_HELP("Help",
                "The fewest points that leave no more than this to the curve, in mm or deg"))
        ->option_text("DEVIATION")
        ->excludes("--points")
        ->excludes("--distance")
        ->group(group);
    command
        .add_flag("--hold", options.file.conversion.holdsEnds,
            AXISCOMP_HELP(
                "Help", "Let the grid extend beyond the targets, where the end values are held"))
        ->group(group);
    command
        .add_option("--speed", options.speed,
            AXISCOMP_HELP("Help",
                "Speed of the axis in mm/s or deg/s, for the steps of the velocity that are told"))
        ->option_text("V")
        ->check(numberAboveZero())
        ->group(group);
}

void addZeroOptions(CLI::App& command, FitOptions& options)
{
    const std::string group = AXISCOMP_HELP("Help", "Zero, slope and drift");
    command
        .add_option("--zero", options.zero,
            AXISCOMP_HELP("Help",
                "Where the table is 0: home, first (the first target), mean, keep, or a position; "
                "home "
                "where it is known and measured, else first, unless given"))
        ->option_text("WHERE")
        ->group(group);
    command.add_option("--home", options.home, AXISCOMP_HELP("Help", "Home position of the axis"))
        ->option_text("POSITION")
        ->check(anyNumber())
        ->group(group);
    command
        .add_option("--remove-slope", options.removedSlope,
            AXISCOMP_HELP(
                "Help", "Take the slope out, for straightness: lsq (least squares) or ends"))
        ->option_text("HOW")
        ->check(CLI::IsMember(std::vector<std::string>{"lsq", "ends"}))
        ->group(group);
    command
        .add_option("--remove-drift", options.removedDrift,
            AXISCOMP_HELP(
                "Help", "Take the drift of the runs out before they are averaged: offset or trend"))
        ->option_text("HOW")
        ->check(CLI::IsMember(std::vector<std::string>{"offset", "trend"}))
        ->group(group);
}

void addStateOptions(CLI::App& command, FitOptions& options)
{
    const std::string group = AXISCOMP_HELP("Help", "State of the drive");
    addLookupOption(command, options.lookupAt,
        AXISCOMP_HELP("Help",
            "Where the drive looks the table up: encoder (before the compensation) or set "
            "(after "
            "it); with --onto drive by its source"))
        ->group(group);
    command
        .add_option("--measured-with", options.measuredWith,
            AXISCOMP_HELP("Help",
                "What was active while it was measured, where the file does not say it: off, on, "
                "or "
                "the file of the table"))
        ->option_text("STATE")
        ->group(group);
    command.add_option("--onto", options.onto, FitDrive::description())
        ->option_text("TABLE")
        ->group(group);
    command
        .add_option("--gain", options.gain,
            AXISCOMP_HELP("Help",
                "Factor for the residuals before they are merged (1); below 1, such as 0.7, where "
                "the machine responds sluggishly"))
        ->option_text("GAIN")
        ->group(group);
}

void addPointsOptions(CLI::App& command, FitOptions& options)
{
    const std::string group = AXISCOMP_HELP("Help", "Points and tracks");
    command
        .add_option("--remove", options.remove,
            AXISCOMP_HELP("Help",
                "Remove the alignment of the artefact: rigid (position and rotation), rigid:X "
                "(rotated so that lines along X have no slope), or scale (its scale as well)"))
        ->option_text("WHAT")
        ->group(group);
    command
        .add_option("--fill", options.fill,
            AXISCOMP_HELP("Help",
                "Points of the grid that are far from any measured one: smooth or nearest; refused "
                "unless given"))
        ->option_text("HOW")
        ->check(CLI::IsMember(std::vector<std::string>{"smooth", "nearest"}))
        ->group(group);
    command
        .add_flag("--robust", options.isRobust,
            AXISCOMP_HELP("Help", "Give values that do not fit the others less weight"))
        ->group(group);
}

} // namespace

void addFitCommand(CommandLine& line)
{
    const std::string name = commandName("fit");
    auto options = std::make_shared<FitOptions>(name);
    options->input.command = name;
    options->file.output.command = name;
    options->file.conversion.command = name;
    CLI::App* command = line.add("fit", fileCommands,
        AXISCOMP_HELP(
            "Help", "Make a compensation table of a measurement, and foretell what it does"),
        [options](Environment& environment) { return runFit(environment, *options); });
    addMeasurementOptions(*command, options->input);
    addOutputFileOptions(*command, *options);
    addToleranceOptions(*command, options->tolerance);
    addCurveOptions(*command, *options);
    addZeroOptions(*command, *options);
    addStateOptions(*command, *options);
    addPointsOptions(*command, *options);
    addCorrectionOptions(*command, options->correction);
    options->drive.addOptions(*command);
    const std::string examples = AXISCOMP_HELP("Help", "Examples:");
    command->footer(examples
        + "\n  axiscomp fit x.rtl -o x.csv --measured-with off --lookup-at encoder --points 51"
        + "\n  axiscomp fit x.csv -o x.TAMtbl --lookup-at encoder --method smooth --period 10 "
          "--distance 0.5"
        + FitDrive::example()
        + "\n  axiscomp fit plane.csv -o plane-table.csv --lookup-at encoder --remove rigid"
          " --points 41,31");
}

} // namespace axiscomp::app
