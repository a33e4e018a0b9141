// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/record/kept_figures.h"

#include "core/metrology/fine_quantity.h"
#include "core/metrology/record/comparison.h"
#include "core/table/target_axis.h"

#include <algorithm>
#include <array>

namespace axiscomp {

namespace {

using Figure = MeasuredFigures::Figure;

bool isMeasured(const Figure& figure)
{
    return figure.before || figure.after;
}

/// What was measured before, as it was when the promise was made; else as the record has it now.
FigureValues figuresBefore(const CalibrationRecord& record)
{
    if (record.prediction)
        return record.prediction->before;
    if (!record.before)
        return {};
    const auto used = usedMeasurement(*record.before);
    return used && used->hasTargets() ? figureValues(figuresBy(record, *used)) : FigureValues{};
}

/// Nothing, too, for a record whose measurements can be used no more.
std::optional<TwoRanges> lesserRangeOf(const CalibrationRecord& record, const RecordedAfter* after)
{
    if (!record.before || !after)
        return std::nullopt;
    const auto first = usedMeasurement(*record.before);
    const auto second = usedMeasurement(after->measurement);
    return first && second ? lesserRange(*first, *second) : std::nullopt;
}

std::size_t excludedOf(const RecordedMeasurement& recorded)
{
    const auto used = usedMeasurement(recorded);
    return used ? used->excludedCount() : 0;
}

/// The verdict is that of the last measurement of the record, whichever table was active in it.
bool isJudged(const CalibrationRecord& record, const RecordedAfter* after)
{
    return record.verdict && after && after == &record.after.back();
}

void addTolerances(MeasuredFigures& kept, const CalibrationRecord& record, bool isJudged)
{
    const auto figureOf = [&kept](Iso230Figure figure) -> Figure& {
        return kept.figures[static_cast<std::size_t>(figure)];
    };
    for (const Tolerance& tolerance : judgingOf(record).tolerances)
        figureOf(tolerance.figure).tolerance = tolerance.value;
    if (!isJudged)
        return;
    for (const Verdict& verdict : record.verdict->figures)
        figureOf(verdict.tolerance.figure).result = verdictName(verdict.result);
}

/// One table that does not say what it corrects may be that of any axis.
MadeForLookup madeForLookup(const CalibrationRecord& record)
{
    MadeForLookup made;
    if (record.fit)
        made.at = record.fit->settings.lookupAt;
    for (const RecordedTable& recorded : record.tables) {
        const auto target = targetOf(recorded.table);
        if (!target)
            return {made.at, {}};
        made.targets.push_back(
            target->source ? sourceTarget(*target->source) : std::string(otherAxis));
    }
    return made;
}

/// A, or the accuracy of one direction.
std::vector<Figure> accuracies(const MeasuredFigures& measured)
{
    constexpr std::array wanted{
        Iso230Figure::A, Iso230Figure::AUp, Iso230Figure::ADown, Iso230Figure::E, Iso230Figure::M};
    for (const Iso230Figure figure : wanted) {
        const auto found = std::ranges::find(measured.figures, figureName(figure), &Figure::name);
        if (found != measured.figures.end() && isMeasured(*found))
            return {*found};
    }
    return {};
}

std::vector<Figure> shownFigures(const MeasuredFigures& measured)
{
    std::vector<Figure> shown;
    std::ranges::copy_if(measured.figures, std::back_inserter(shown),
        [](const Figure& figure) { return figure.tolerance && isMeasured(figure); });
    return shown.empty() ? accuracies(measured) : shown;
}

Text valuesText(const Figure& figure, const std::string& name, bool isAngular)
{
    const auto quantity = [isAngular](const std::optional<double>& value) {
        return fineQuantity(value.value_or(0.0), isAngular);
    };
    const auto known = figureNamed(name);
    const Text words = known ? Text(figureText(*known)) : Text(Verbatim{name});
    const TextPattern pattern = figure.after && figure.before
        ? AXISCOMP_TEXT("Measurement", "{figure} {before} before, {after} after")
        : figure.after ? AXISCOMP_TEXT("Measurement", "{figure} {after}")
        : figure.predicted
        ? AXISCOMP_TEXT(
            "Measurement", "{figure} {before} before, {predicted} predicted, not measured since")
        : AXISCOMP_TEXT("Measurement", "{figure} {before} before, not measured since");
    return pattern.with("figure", words)
        .with("before", quantity(figure.before))
        .with("predicted", quantity(figure.predicted))
        .with("after",
            figure.after && figure.tolerance
                ? comparedQuantities(*figure.after, *figure.tolerance, isAngular).value
                : quantity(figure.after));
}

Text clauseOf(const Figure& figure, bool isAngular)
{
    Text values = valuesText(figure, figure.name, isAngular);
    if (!figure.tolerance)
        return values;
    constexpr std::array results{VerdictResult::Passed, VerdictResult::Failed,
        VerdictResult::Undecided, VerdictResult::NotDefined};
    const auto* const result = std::ranges::find(results, figure.result, &verdictName);
    const TextPattern pattern = result == results.end()
        ? AXISCOMP_TEXT("Measurement", "{values} (tolerance {tolerance})")
        : AXISCOMP_TEXT("Measurement", "{values} (tolerance {tolerance}: {result})");
    return pattern.with("values", std::move(values))
        .with("tolerance",
            comparedQuantities(
                figure.after.value_or(*figure.tolerance), *figure.tolerance, isAngular)
                .limit)
        .with("result", result == results.end() ? Text() : Text(verdictText(*result)));
}

Text shortClauseOf(const Figure& figure, bool isAngular)
{
    const auto& last = figure.after ? figure.after : figure.before;
    const Quantity value = fineQuantity(*last, isAngular);
    const Text name = Verbatim{figure.name};
    if (!figure.after)
        return AXISCOMP_TEXT("Measurement", "{figure} {before} before")
            .with("figure", name)
            .with("before", value);
    if (!figure.before)
        return AXISCOMP_TEXT("Measurement", "{figure} {after}")
            .with("figure", name)
            .with("after", value);
    return AXISCOMP_TEXT("Measurement", "{figure} {after}, {before} before")
        .with("figure", name)
        .with("after", value)
        .with("before", fineQuantity(*figure.before, isAngular));
}

} // namespace

std::optional<MeasuredFigures> figuresToKeep(const CalibrationRecord& record, WallTime time)
{
    if (!record.drive || !record.write)
        return std::nullopt;
    const RecordedAfter* const after = lastAfter(record);
    const RecordedMeasurement* const last = after ? &after->measurement
        : record.before                           ? &*record.before
                                                  : nullptr;
    MeasuredFigures kept;
    kept.crc = record.write->crc;
    kept.grid = record.write->grid;
    kept.units = record.write->units;
    kept.axisName = record.drive->axisName;
    kept.madeFor = madeForLookup(record);
    kept.time = time;
    if (last && !last->files.empty()) {
        kept.date = last->files.front().measurement.header.date;
        kept.isAngular = last->files.front().measurement.isAngular;
    }
    if (record.before)
        kept.excluded += excludedOf(*record.before);
    if (after)
        kept.excluded += excludedOf(after->measurement);
    kept.lesserRange = lesserRangeOf(record, after);
    const FigureValues before = figuresBefore(record);
    for (const Iso230Figure figure : allIso230Figures()) {
        Figure& one = kept.figures.emplace_back(Figure{std::string(figureName(figure))});
        one.before = before[figure];
        if (record.prediction)
            one.predicted = record.prediction->predicted[figure];
        if (after)
            one.after = after->figures[figure];
    }
    addTolerances(kept, record, isJudged(record, after));
    std::erase_if(kept.figures, [](const Figure& figure) { return !isMeasured(figure); });
    if (kept.figures.empty())
        return std::nullopt;
    return kept;
}

Result<void> keepFigures(
    DriveStore& store, const CalibrationRecord& record, WallTime time, Measuring measuring)
{
    const auto kept = figuresToKeep(record, time);
    if (!kept)
        return {};
    return store.recordMeasured(record.drive->serialNumber, record.drive->axis, *kept, measuring);
}

Text measuredFiguresText(const MeasuredFigures& measured)
{
    Text clauses;
    const auto add = [&clauses](Text next) {
        clauses = clauses.isEmpty() ? std::move(next)
                                    : AXISCOMP_TEXT("Measurement", "{first}; {next}")
                                          .with("first", std::move(clauses))
                                          .with("next", std::move(next));
    };
    for (const Figure& figure : shownFigures(measured))
        add(clauseOf(figure, measured.isAngular));
    if (!clauses.isEmpty() && measured.excluded > 0)
        add(excludedText(measured.excluded));
    if (!clauses.isEmpty() && measured.lesserRange)
        add(lesserRangeText(*measured.lesserRange, measured.isAngular));
    if (clauses.isEmpty() || measured.date.empty())
        return clauses;
    return AXISCOMP_TEXT("Measurement", "measured {date}: {figures}")
        .with("date", measured.date)
        .with("figures", std::move(clauses));
}

Text measuredFiguresCell(const MeasuredFigures& measured)
{
    const auto shown = shownFigures(measured);
    if (shown.empty())
        return {};
    Text cell = shortClauseOf(shown.front(), measured.isAngular);
    if (!measured.lesserRange)
        return cell;
    return AXISCOMP_TEXT("Measurement", "{figures}, over part of the travel")
        .with("figures", std::move(cell));
}

} // namespace axiscomp
