// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/formats/measurement_csv.h"
#include "core/metrology/formats/measurement_formats.h"
#include "core/metrology/formats/run_assembly.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <array>

namespace axiscomp::wide_csv {

namespace {

constexpr std::array<std::string_view, 1> extensions{".csv"};
constexpr std::array kinds{MeasurementKind::Runs, MeasurementKind::Averages};
constexpr std::array<std::string_view, 3> rules{
    "One line for each target, a column for each run: target, up1, up2, ..., down1, down2, ... "
    "(also fwd or forward, bwd, backward or rev, with or without _). Empty cells are values that "
    "are missing. A direction without a number is run 1 where no other column is.",
    "The file says // values: deviation, or // values: reference; without that it is asked "
    "(--values), since both are common.",
    "Units stand in brackets or behind the name (target_mm, up1_um); the columns of runs need one, "
    "too.",
};

/// "up_3" and "up3" are run 3 in positive direction.
struct RunName {
    Approach direction = Approach::Up;
    int run = 1; ///< 0: not said, as in "up"
};

std::optional<RunName> runName(std::string_view name)
{
    const std::size_t digits = name.find_last_not_of("0123456789") + 1;
    std::string_view word = name.substr(0, digits);
    if (word.ends_with('_') || word.ends_with(' '))
        word.remove_suffix(1);
    const bool hasNumber = digits < name.size();
    const auto run =
        hasNumber ? wholeNumberOf(name.substr(digits)) : std::optional<std::int64_t>(0);
    const bool isWord = !word.empty() && word.find_first_of("+-1") == std::string_view::npos;
    const auto direction = isWord ? approachOf(word) : std::nullopt;
    constexpr std::int64_t most = 1'000'000;
    if (!direction || !run || *run < (hasNumber ? 1 : 0) || *run > most)
        return std::nullopt;
    return RunName{*direction, static_cast<int>(*run)};
}

struct RunColumn {
    std::size_t column = 0;
    RunName run;
    double factor = 1.0;
};

/// A direction alone is run 1 where no column says that it is.
bool isFirstRunFree(
    const MeasurementCsv& csv, const std::vector<RunColumn>& taken, Approach direction)
{
    const auto isFirst = [direction](const RunName& run) {
        return run.direction == direction && run.run == 1;
    };
    return std::ranges::none_of(taken, isFirst, &RunColumn::run)
        && std::ranges::none_of(csv.columns(), [&](const csv::ColumnName& column) {
               const auto run = runName(column.name);
               return run && isFirst(*run);
           });
}

std::vector<RunColumn> runColumns(MeasurementCsv& csv, const MeasurementReadOptions& options,
    const std::optional<MeasurementUnit>& target)
{
    std::vector<RunColumn> columns;
    for (std::size_t i = 0; i < csv.columns().size(); ++i) {
        auto run = runName(csv.columns()[i].name);
        if (run && run->run == 0)
            run = isFirstRunFree(csv, columns, run->direction)
                ? std::optional(RunName{run->direction, 1})
                : std::nullopt;
        if (!run)
            continue;
        csv.markKnown(i + 1);
        const auto unit = csv.unit(i + 1, options.valueUnit);
        csv.checkSameKind(target, unit, i + 1);
        columns.push_back({i + 1, *run, unit ? unit->factor : 1.0});
    }
    return columns;
}

/// Whether a word of the name is a direction, as in "run2 up".
bool namesDirection(std::string_view name)
{
    const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    for (std::size_t begin = 0; begin < name.size();) {
        std::size_t end = begin;
        while (end < name.size() && isLetter(name[end]))
            ++end;
        if (end > begin && approachOf(name.substr(begin, end - begin)))
            return true;
        begin = end + 1;
    }
    return false;
}

/// Columns that may be meant as runs, and are not called so.
std::vector<std::size_t> doubtfulColumns(const MeasurementCsv& csv, bool isAngular)
{
    std::vector<std::size_t> columns;
    for (std::size_t column = 1; column <= csv.columns().size(); ++column) {
        const csv::ColumnName& name = csv.columns()[column - 1];
        const auto unit = measurementUnit(name.unit);
        if (!csv.isKnown(column)
            && ((unit && unit->isAngular == isAngular) || namesDirection(name.name)))
            columns.push_back(column);
    }
    return columns;
}

/// Once for each of them that has a value.
void warnOfDoubtful(
    std::vector<std::size_t>& columns, const MeasurementCsv& csv, DiagnosticList& diagnostics)
{
    std::erase_if(columns, [&](std::size_t column) {
        if (csv.isEmpty(column))
            return false;
        diagnostics.warning(DiagnosticCode::LeftOut, csv.headerLine(), column,
            AXISCOMP_TEXT("Error", "column {column}")
                .with("column", csv.columns()[column - 1].name),
            AXISCOMP_TEXT("Error", "for a run its direction and number, such as up2 or down1"));
        return true;
    });
}

/// Nothing: neither the file nor the user says it, which is reported.
std::optional<bool> holdsReference(MeasurementCsv& csv, const MeasurementReadOptions& options)
{
    if (options.values != MeasurementReadOptions::Values::AsFileSays)
        return options.values == MeasurementReadOptions::Values::Reference;
    if (!csv.comments().holdsReference)
        csv.error(DiagnosticCode::MissingColumn, 0,
            AXISCOMP_TEXT("Error", "columns of runs that are either deviations or positions"),
            AXISCOMP_TEXT("Error",
                "which it is: // values: deviation or // values: reference before the header, or "
                "--values"));
    return csv.comments().holdsReference;
}

std::vector<RawRunValue> valuesOf(std::string_view text, const MeasurementReadOptions& options,
    Measurement& measurement, DiagnosticList& diagnostics)
{
    MeasurementCsv csv(text, options, measurement, diagnostics);
    if (!csv.readHeader())
        return {};
    const std::size_t target = csv.column("target", {"position"});
    if (target == 0) {
        csv.error(DiagnosticCode::MissingColumn, 0, AXISCOMP_TEXT("Error", "no column target"),
            AXISCOMP_TEXT("Error", "a column target before those of the runs"));
        return {};
    }
    const auto targetUnit = csv.unit(target, options.unit);
    const std::vector<RunColumn> columns = runColumns(csv, options, targetUnit);
    csv.findAxis();
    const auto isReference = holdsReference(csv, options);
    if (!targetUnit || !isReference || diagnostics.hasErrors())
        return {};
    measurement.isAngular = targetUnit->isAngular;
    csv.settleValues(
        options.values == MeasurementReadOptions::Values::AsFileSays ? isReference : std::nullopt,
        !*isReference);
    std::vector<std::size_t> doubtful = doubtfulColumns(csv, measurement.isAngular);
    std::vector<RawRunValue> values;
    while (csv.next()) {
        warnOfDoubtful(doubtful, csv, diagnostics);
        const auto position = csv.number(target);
        if (position)
            measurement.targets.push_back(*position * targetUnit->factor);
        for (const RunColumn& column : columns) {
            const auto number = csv.optionalNumber(column.column);
            if (!position || !number)
                continue;
            RawRunValue raw;
            raw.target = *position * targetUnit->factor;
            raw.value.direction = column.run.direction;
            raw.value.run = column.run.run;
            raw.value.line = csv.line();
            const double scaled = *number * column.factor;
            if (*isReference)
                raw.reference = scaled;
            else
                raw.value.deviation = csv.comments().holdsCorrections ? -scaled : scaled;
            values.push_back(raw);
        }
    }
    csv.noteUnknownColumns();
    return values;
}

MeasurementRecognition recognise(std::string_view text)
{
    bool hasTarget = false;
    std::size_t runs = 0;
    std::size_t directions = 0;
    for (const std::string& name : headerNames(text)) {
        hasTarget = hasTarget || name == "target" || name == "position";
        const auto run = runName(name);
        runs += run && run->run > 0 ? 1 : 0;
        directions += run ? 1 : 0;
    }
    if (!hasTarget || directions == 0)
        return MeasurementRecognition::No;
    return runs > 0 ? MeasurementRecognition::Certain : MeasurementRecognition::Possible;
}

} // namespace

const MeasurementFormat& format()
{
    static const MeasurementFormat format{
        .facts = {.name = "wide",
            .origin = "spreadsheets",
            .description = AXISCOMP_TEXT("Error", "CSV with a line for each target"),
            .extensions = extensions,
            .kinds = kinds,
            .rules = rules},
        .recognise = recognise,
        .read = readRuns<valuesOf>};
    return format;
}

} // namespace axiscomp::wide_csv
