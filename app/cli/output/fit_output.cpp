// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output/fit_output.h"

#include "app/cli/output/fine_text.h"
#include "app/cli/output/json_output.h"
#include "app/cli/output/judgement_output.h"
#include "app/common/number_text.h"
#include "app/common/text_table.h"
#include "core/metrology/fit/known_tables.h"
#include "core/table/tam_table.h"
#include "core/table/target_axis.h"

#include <algorithm>
#include <iterator>

namespace axiscomp::app {

namespace {

using FitLines = std::vector<std::pair<std::string, std::string>>;

Json jsonOf(const std::optional<double>& value)
{
    return value ? Json(*value) : Json(nullptr);
}

std::string methodText(
    const Measurement& measurement, const FitSettings& settings, const FittedTable& made)
{
    std::string text(fitMethodName(settings.method));
    if (isFittedOnGrid(measurement, settings))
        text = "penalised least squares on the grid";
    if (made.smoothness)
        text += ", smoothness " + shortText(*made.smoothness)
            + (settings.smoothness ? "" : " by cross-validation");
    const FitDirection direction = fittedDirection(measurement, settings);
    if (measurement.kind != MeasurementKind::Points)
        text += direction == FitDirection::Mean ? ", mean of both directions"
            : direction == FitDirection::Both
            ? ", " + std::string(directionName(made.direction)) + " direction"
            : ", " + std::string(fitDirectionName(direction)) + " direction";
    return text;
}

std::string gridText(const GridAxis& axis)
{
    return axis.name + " from " + shortText(axis.start) + " to "
        + withUnit(shortText(axis.last()), axis.unit) + ", " + plural(axis.size, "point", "points")
        + ", " + withUnit(shortText(axis.distance), axis.unit) + " apart";
}

/// The smallest slot that holds it.
std::string slotText(const Grid& grid, const DriveProfile& profile)
{
    const std::size_t needed = tamTableSize(grid, profile.layout);
    const TableSlot* smallest = nullptr;
    for (const TableSlot& slot : profile.tableSlots)
        if (slot.maximumSize >= needed && (!smallest || slot.maximumSize < smallest->maximumSize))
            smallest = &slot;
    return countText(needed) + " bytes, "
        + (smallest ? "a slot such as " + smallest->name + " holds it" : "no slot holds it");
}

/// The other methods go through what was measured.
bool leavesResiduals(const Measurement& measurement, const FitSettings& settings)
{
    return settings.method == FitMethod::Smooth || settings.method == FitMethod::Harmonic
        || settings.isByTemperature || isFittedOnGrid(measurement, settings);
}

/// A drive whose axis is in another unit has other numbers.
std::string crcsText(const CompensationTable& table, std::uint32_t crc, const DriveProfile& profile)
{
    const auto inMeters = crcInMeters(table, table.unit, profile.layout);
    if (!inMeters)
        return hexText(crc);
    return hexText(crc) + " on an axis in " + table.unit + ", " + hexText(*inMeters) + " in "
        + (table.unit == "mm" ? "m" : "rad");
}

std::string tableText(const Measurement& measurement, const FitSettings& settings,
    const FitReport& report, const FittedTable& made, std::uint32_t crc,
    const DriveProfile& profile)
{
    const auto fine = [&](double value) { return fineText(value, measurement.isAngular); };
    const TableStatistics values = statistics(made.table);
    FitLines lines;
    for (const GridAxis& axis : made.table.grid.axes)
        lines.emplace_back("Grid", gridText(axis));
    lines.emplace_back("Values", fine(values.minimum) + " to " + fine(values.maximum));
    const std::string corrected = targetName(made.table);
    lines.emplace_back("Corrects",
        corrected.empty()            ? "not stated by the measurement"
            : corrected == otherAxis ? "an axis that is no source"
                                     : "axis " + corrected);
    lines.emplace_back("Method", methodText(measurement, settings, made));
    lines.emplace_back("Looked up",
        report.lookupAt == LookupAt::Encoder ? "at the encoder's position, before the compensation"
                                             : "at the set position, after the compensation");
    if (leavesResiduals(measurement, settings))
        lines.emplace_back("Residuals of the fit",
            fine(made.residualRms) + " rms, " + fine(made.residualLargest) + " at most");
    if (made.crossValidation)
        lines.emplace_back(
            "Foretold", fine(*made.crossValidation) + " rms at values that were left out");
    if (made.filledNodes > 0)
        lines.emplace_back("Filled",
            plural(made.filledNodes, "point", "points") + " of "
                + std::to_string(made.table.values.size()));
    for (const PeriodicTerm& term : made.periods)
        lines.emplace_back("Period " + shortText(term.period / term.harmonic),
            "amplitude " + fine(term.amplitude()) + ", standard error " + fine(term.standardError)
                + ", phase " + fixedText(term.phase(), 3) + " rad");
    if (made.direction == Direction::Both) { // otherwise it is for another controller
        lines.emplace_back("CRC", crcsText(made.table, crc, profile));
        lines.emplace_back("On the drive", slotText(made.table.grid, profile));
    }
    return "\nTable " + made.table.name + "\n" + labelled(lines, "  ");
}

std::string figuresText(const Measurement& measurement, const FitReport& report)
{
    if (!report.before || !report.predicted)
        return {};
    std::vector<std::optional<double>> shown;
    for (const Iso230Figures* one : {&*report.before, &*report.predicted})
        std::ranges::copy(figureValues(*one).values, std::back_inserter(shown));
    if (report.heldOut)
        shown.push_back(report.heldOut->range);
    const FineText fine(shown, measurement.isAngular);
    TextTable table({"figure", ">before", ">foretold", ">held out"});
    for (const Iso230Figure figure : figuresInShort(*report.before)) {
        const bool isRange =
            report.heldOut && figure == figureStandingFor(Iso230Figure::M, *report.before);
        table.add({figureText(figure).words, fine((*report.before)[figure].value),
            fine((*report.predicted)[figure].value), isRange ? fine(report.heldOut->range) : ""});
    }
    std::string text = "\nFigures of ISO 230-2:2014, in " + fine.unit() + "\n" + table.text();
    text += "  Foretold: the same runs with the table active. Held out: each target foretold "
            "without it;\n  this is the one to believe between the targets.\n";
    if (report.heldOut)
        text +=
            "  Held out at single targets: " + fineText(report.heldOut->rms, measurement.isAngular)
            + " rms, " + fineText(report.heldOut->largest, measurement.isAngular) + " at most\n";
    return text;
}

Json tableJson(const FittedTable& made, std::uint32_t crc)
{
    return {{"axes", toJson(made.table.grid)}, {"crc", crc}, {"unit", made.table.unit}};
}

Json periodsJson(const FittedTable& made)
{
    Json list = Json::array();
    for (const PeriodicTerm& term : made.periods)
        list.push_back(
            {{"period", term.period}, {"harmonic", term.harmonic}, {"amplitude", term.amplitude()},
                {"phase", term.phase()}, {"standardError", term.standardError}});
    return list;
}

Json columnJson(const FittedTable& made, std::uint32_t crc)
{
    std::vector<std::size_t> sizes;
    for (const GridAxis& axis : made.table.grid.axes)
        sizes.push_back(axis.size);
    return {{"name", made.table.name}, {"target", made.table.target},
        {"direction", directionName(made.direction)}, {"crc", crc},
        {"filled", filledJson(made.table.filled, sizes)}, {"smoothness", jsonOf(made.smoothness)},
        {"residual", {{"rms", made.residualRms}, {"largest", made.residualLargest}}},
        {"crossValidation", jsonOf(made.crossValidation)},
        {"nodes", {{"measured", made.measuredNodes}, {"filled", made.filledNodes}}},
        {"removedConstant", made.removedConstant}, {"removedSlope", made.removedSlope},
        {"rounding", made.rounding}};
}

Json mergeJson(const std::optional<FitMerge>& merge)
{
    if (!merge)
        return nullptr;
    return {{"onto", merge->onto.english()}, {"gain", merge->gain},
        {"largestChange", merge->largestChange}, {"at", merge->largestAt}};
}

Json densityJson(const FittedTable& made, const FitSettings& settings)
{
    if (!made.density)
        return nullptr;
    const CurveGrid& density = *made.density;
    return {{"points", density.points}, {"largestDistance", density.largestDistance},
        {"at", density.distanceAt}, {"largestSlopeChange", density.largestSlopeChange},
        {"velocityStep",
            settings.speed ? Json(density.largestSlopeChange * *settings.speed) : Json(nullptr)}};
}

Json heldOutJson(const FitReport& report)
{
    if (!report.heldOut)
        return nullptr;
    return {{"rms", report.heldOut->rms}, {"largest", report.heldOut->largest},
        {"M", report.heldOut->range}};
}

Json remarksJson(const FitReport& report, bool areWarnings)
{
    Json list = Json::array();
    for (const FitRemark& remark : report.remarks)
        if (remark.isWarning == areWarnings)
            list.push_back({{"code", remark.name}, {"message", remark.text.english()}});
    return list;
}

} // namespace

std::string fitText(const Measurement& measurement, const FitSettings& settings,
    const FitReport& report, const std::vector<std::uint32_t>& crcs, const DriveProfile& profile)
{
    std::string text = report.state.text.english() + "\n";
    if (const std::size_t excluded = measurement.excludedCount(); excluded > 0)
        text += plural(excluded, "value is", "values are") + " left out\n";
    for (std::size_t i = 0; i < report.tables.size(); ++i)
        text += tableText(measurement, settings, report, report.tables[i], crcs[i], profile);
    text += figuresText(measurement, report);
    text += "\nSign\n  " + report.sign.english() + "\n";
    text += "\nBefore it is used\n";
    for (const FitRemark& remark : report.remarks)
        text += (remark.isWarning ? "  ! " : "  - ") + remark.text.english() + "\n";
    return text + verdictsText(measurement, report.verdicts);
}

Json fitJson(const Measurement& measurement, const FitSettings& settings, const FitReport& report,
    const std::vector<std::uint32_t>& crcs)
{
    const FittedTable& first = report.tables.front();
    Json columns = Json::array();
    for (std::size_t i = 0; i < report.tables.size(); ++i)
        columns.push_back(columnJson(report.tables[i], crcs[i]));
    return {{"table", tableJson(first, crcs.front())}, {"columns", std::move(columns)},
        {"method", madeBy(measurement, settings)},
        {"direction", fitDirectionName(settings.direction)},
        {"smoothness", jsonOf(first.smoothness)}, {"periods", periodsJson(first)},
        {"knots", first.knots},
        {"residual", {{"rms", first.residualRms}, {"largest", first.residualLargest}}},
        {"crossValidation", jsonOf(first.crossValidation)},
        {"nodes", {{"measured", first.measuredNodes}, {"filled", first.filledNodes}}},
        {"lookupAt", lookupAtName(report.lookupAt)}, {"state", stateName(report.state.kind)},
        {"merge", mergeJson(report.merge)}, {"densification", densityJson(first, settings)},
        {"before", report.before ? axisFiguresJson(*report.before) : Json(nullptr)},
        {"predicted", report.predicted ? axisFiguresJson(*report.predicted) : Json(nullptr)},
        {"heldOut", heldOutJson(report)}, {"sign", report.sign.english()},
        {"excluded", excludedJson(measurement)}, {"verdict", verdictsJson(report.verdicts)},
        {"remarks", remarksJson(report, false)}, {"warnings", remarksJson(report, true)}};
}

} // namespace axiscomp::app
