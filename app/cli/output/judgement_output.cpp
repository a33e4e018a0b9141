// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output/judgement_output.h"

#include "app/cli/output/fine_text.h"
#include "app/common/number_text.h"
#include "app/common/text_table.h"
#include "core/metrology/run_selection.h"

#include <algorithm>

namespace axiscomp::app {

namespace {

using Lines = std::vector<std::pair<std::string, std::string>>;

/// One line of the table of figures.
struct FigureLine {
    std::optional<Iso230Figure> up;
    std::optional<Iso230Figure> down;
    Iso230Figure both;
};
constexpr std::array figureLines{
    FigureLine{Iso230Figure::AUp, Iso230Figure::ADown, Iso230Figure::A},
    FigureLine{Iso230Figure::RUp, Iso230Figure::RDown, Iso230Figure::R},
    FigureLine{Iso230Figure::EUp, Iso230Figure::EDown, Iso230Figure::E},
    FigureLine{std::nullopt, std::nullopt, Iso230Figure::B},
    FigureLine{std::nullopt, std::nullopt, Iso230Figure::MeanReversal},
    FigureLine{std::nullopt, std::nullopt, Iso230Figure::M},
};

std::string placeText(const Iso230Figures& figures, const FigureLine& line)
{
    std::string text;
    for (const double place : placesOf(figures, line.both))
        text += (text.empty() ? "" : " and ") + shortText(place);
    return text;
}

std::string figuresText(
    const Measurement& measurement, const Iso230Figures& figures, const std::string& heading)
{
    const FineText fine(figureValues(figures).values, measurement.isAngular);
    TextTable table({"figure", ">up", ">down", ">both",
        "at target [" + std::string(positionUnit(measurement)) + "]"});
    const auto cell = [&](const std::optional<Iso230Figure>& figure) {
        return figure ? fine(figures[*figure].value) : std::string();
    };
    for (const FigureLine& line : figureLines)
        table.add({figureText(line.both).words, cell(line.up), cell(line.down), cell(line.both),
            placeText(figures, line)});
    return heading + ", in " + fine.unit() + "\n" + table.text();
}

/// The means from the datum.
std::string targetsText(const Measurement& measurement, const Iso230Figures& measured,
    const std::optional<double>& position)
{
    const auto datum = deviationDatum(measured, position);
    const Iso230Figures figures = fromDatum(measured, datum);
    const FineText fine(valuesOfTargets(figures), measurement.isAngular);
    TextTable table({">number", ">target [" + std::string(positionUnit(measurement)) + "]", ">n up",
        ">mean up", ">s up", ">n down", ">mean down", ">s down", ">mean", ">B", ">R"});
    for (const TargetFigures& target : figures.targets)
        table.add({std::to_string(target.target + 1), shortText(target.position),
            std::to_string(target.up.n), fine(target.up.mean), fine(target.up.s),
            std::to_string(target.down.n), fine(target.down.mean), fine(target.down.s),
            fine(target.mean), fine(target.reversal), fine(target.repeatability)});
    return "Targets, in " + fine.unit() + datumPhrase(datum, measurement.isAngular) + "\n"
        + table.text();
}

std::string fineOrNothing(const std::optional<double>& value, bool isAngular)
{
    return value ? fineText(*value, isAngular) : "-";
}

std::string driftText(const Measurement& measurement, const Judgement& judgement)
{
    std::vector<std::optional<double>> shown;
    for (const DirectionDrift* drift : {&judgement.driftUp, &judgement.driftDown})
        shown.insert(shown.end(), {drift->firstToLast, drift->trendPerRun, drift->sWithoutOffsets});
    const FineText fine(shown, measurement.isAngular);
    TextTable table({"direction", ">first to last", ">per run", ">s without offsets", "drift"});
    bool hasAny = false;
    for (const Approach direction : {Approach::Up, Approach::Down}) {
        const DirectionDrift& drift =
            direction == Approach::Up ? judgement.driftUp : judgement.driftDown;
        if (!drift.firstToLast)
            continue;
        hasAny = true;
        table.add(
            {std::string(approachName(direction)), fine(drift.firstToLast), fine(drift.trendPerRun),
                fine(drift.sWithoutOffsets), drift.isSuspected ? "suspected" : "not suspected"});
    }
    if (!hasAny)
        return {};
    std::string text = "\nDrift of the runs, in " + fine.unit() + "\n" + table.text();
    if (judgement.withoutOffsets) {
        const auto& without = *judgement.withoutOffsets;
        const auto said = [&](Iso230Figure both) {
            const Iso230Figure figure = figureStandingFor(both, without);
            return shortFigureName(figure) + " "
                + fineOrNothing(without[figure].value, measurement.isAngular);
        };
        text += "  Without the offsets of the runs: " + said(Iso230Figure::A) + ", "
            + said(Iso230Figure::R) + "\n";
    }
    return text;
}

std::string outliersText(const Measurement& measurement, const Outliers& outliers)
{
    if (outliers.rule == OutlierRule::None || measurement.kind != MeasurementKind::Runs)
        return {};
    std::string text = "\nOutliers by the rule " + std::string(outlierRuleName(outliers.rule));
    const bool isUndecided = outliers.up.isUndecided || outliers.down.isUndecided;
    if (outliers.up.flagged.empty() && outliers.down.flagged.empty())
        return text + (isUndecided ? ": none that it can tell\n" : ": none\n");
    TextTable table({"direction", ">target", ">run", ">score", "to leave it out"});
    for (const DirectionOutliers* one : {&outliers.up, &outliers.down})
        for (const Outlier& outlier : one->flagged)
            table.add({std::string(approachName(outlier.direction)),
                shortText(measurement.targets[outlier.target]), std::to_string(outlier.run),
                fixedText(outlier.score, 3), "--exclude " + exclusionText(exclusionOf(outlier))});
    return text + ", a proposal; nothing was left out\n" + table.text();
}

std::string conditionsText(const std::vector<ComplianceLine>& lines)
{
    TextTable table({"", "condition of ISO 230-2"});
    for (const ComplianceLine& line : lines)
        table.add({complianceText(line.isMet).words,
            line.text.english() + (line.isAssumed ? " (assumption)" : "")});
    return "\nMeasured as the standard wants it?\n" + table.text();
}

std::string vdiText(const Measurement& measurement, const Vdi3441Figures& vdi)
{
    const FineText fine(std::vector<std::optional<double>>{vdi.p, vdi.pa, vdi.uMax, vdi.uMean,
                            vdi.psMax, vdi.psMean},
        measurement.isAngular);
    return "\nVDI/DGQ 3441 (assumption: its text was not at hand), in " + fine.unit() + "\n"
        + labelled({{"P", fine(vdi.p)}, {"Pa", fine(vdi.pa)}, {"U largest", fine(vdi.uMax)},
                       {"U mean", fine(vdi.uMean)}, {"Ps largest", fine(vdi.psMax)},
                       {"Ps mean", fine(vdi.psMean)}},
            "  ");
}

Json numberOrNull(const std::optional<double>& value)
{
    return value ? Json(*value) : Json(nullptr);
}

Json directionJson(const DirectionFigures& figures)
{
    return {{"n", figures.n}, {"mean", numberOrNull(figures.mean)}, {"s", numberOrNull(figures.s)},
        {"R", numberOrNull(figures.repeatability)}, {"low", numberOrNull(figures.low)},
        {"high", numberOrNull(figures.high)}};
}

Json perTargetJson(const Iso230Figures& figures)
{
    Json list = Json::array();
    for (const TargetFigures& target : figures.targets)
        list.push_back({{"target", target.position}, {"up", directionJson(target.up)},
            {"down", directionJson(target.down)}, {"mean", numberOrNull(target.mean)},
            {"B", numberOrNull(target.reversal)}, {"R", numberOrNull(target.repeatability)}});
    return list;
}

/// A number for a maximum, the highest and the lowest place for a range.
Json whereJson(const Iso230Figures& figures)
{
    Json where = Json::object();
    const auto number = [&figures](std::size_t index) { return figures.targets[index].target + 1; };
    for (const Iso230Figure figure : allIso230Figures()) {
        const AxisFigure& place = figures[figure];
        if (!place.value || figure == Iso230Figure::MeanReversal)
            continue;
        where[std::string(figureName(figure))] = isRange(figure)
            ? Json{number(place.high), number(place.low)}
            : Json(number(place.high));
    }
    return where;
}

Json driftJson(const DirectionDrift& drift)
{
    return {{"offset", drift.offset}, {"slope", drift.slope},
        {"trendPerRun", numberOrNull(drift.trendPerRun)},
        {"trendPerHour", numberOrNull(drift.trendPerHour)},
        {"trendPerKelvin", numberOrNull(drift.trendPerKelvin)},
        {"firstToLast", numberOrNull(drift.firstToLast)},
        {"sWithoutOffsets", numberOrNull(drift.sWithoutOffsets)}, {"suspected", drift.isSuspected}};
}

Json outliersJson(const Outliers& outliers)
{
    Json flagged = Json::array();
    Json disturbed = Json::array();
    for (const Approach direction : {Approach::Up, Approach::Down}) {
        const DirectionOutliers& one = direction == Approach::Up ? outliers.up : outliers.down;
        for (const Outlier& outlier : one.flagged)
            flagged.push_back({{"direction", approachName(outlier.direction)},
                {"target", outlier.target + 1}, {"run", outlier.run}, {"score", outlier.score}});
        if (one.isDisturbed)
            disturbed.push_back(approachName(direction));
    }
    return {{"rule", outlierRuleName(outliers.rule)},
        {"limit", outliers.limit > 0.0 ? Json(outliers.limit) : Json(nullptr)},
        {"sigma",
            {{"up", numberOrNull(outliers.up.sigma)}, {"down", numberOrNull(outliers.down.sigma)}}},
        {"flagged", std::move(flagged)}, {"disturbed", std::move(disturbed)}};
}

Json publishedJson(const PublishedCheck& published)
{
    if (published.comparisons.empty())
        return nullptr;
    Json list = Json::object();
    for (const PublishedComparison& one : published.comparisons)
        list[std::string(figureName(one.figure))] = {{"value", one.published},
            {"computed", numberOrNull(one.computed)}, {"tolerance", one.tolerance},
            {"agrees", one.agrees}};
    return list;
}

Json textsJson(const std::vector<Text>& texts)
{
    Json list = Json::array();
    for (const Text& text : texts)
        list.push_back(text.english());
    return list;
}

Json complianceJson(const std::vector<ComplianceLine>& lines)
{
    Json list = Json::array();
    for (const ComplianceLine& line : lines)
        list.push_back({{"rule", line.rule}, {"text", line.text.english()},
            {"met", line.isMet ? Json(*line.isMet) : Json(nullptr)},
            {"assumption", line.isAssumed}});
    return list;
}

Json vdiJson(const std::optional<Vdi3441Figures>& vdi)
{
    if (!vdi)
        return nullptr;
    return {{"P", vdi->p}, {"Pa", vdi->pa}, {"Umax", vdi->uMax}, {"Umean", vdi->uMean},
        {"Psmax", vdi->psMax}, {"Psmean", vdi->psMean}};
}

} // namespace

std::string shortFigureName(Iso230Figure figure)
{
    std::string name(figureName(figure));
    for (const auto& [ending, direction] : {std::pair("Up", " up"), std::pair("Down", " down")})
        if (name.ends_with(ending))
            return name.substr(0, name.size() - std::string_view(ending).size()) + direction;
    return name;
}

std::string measurementSummary(const Measurement& measurement)
{
    const std::string unit(positionUnit(measurement));
    if (measurement.kind == MeasurementKind::Points)
        return plural(measurement.points.size(), "point", "points") + " of "
            + std::to_string(measurement.points.axes.size()) + " axes, "
            + plural(measurement.points.columns.size(), "column", "columns") + " of values";
    if (measurement.kind == MeasurementKind::Track)
        return plural(measurement.track.size(), "sample", "samples") + " over "
            + withUnit(shortText(measurement.range()), unit);
    const bool isMeans = measurement.kind == MeasurementKind::Averages;
    const auto runs = [&](Approach direction) {
        const auto count = static_cast<std::uint64_t>(measurement.runCount(direction));
        const std::string name(approachName(direction));
        if (isMeans)
            return (count > 0 ? "means " : "no means ") + name;
        return plural(count, "run ", "runs ") + name;
    };
    return plural(measurement.targets.size(), "target", "targets") + " from "
        + shortText(measurement.targets.front()) + " to "
        + withUnit(shortText(measurement.targets.back()), unit) + ", " + runs(Approach::Up) + ", "
        + runs(Approach::Down);
}

std::string verdictsText(const Measurement& measurement, const std::vector<Verdict>& verdicts,
    const std::string& heading)
{
    if (verdicts.empty())
        return {};
    constexpr int decimals = 3; // as of all that is printed
    TextTable table({"figure", ">value", ">tolerance", "uncertainty", "verdict"});
    for (const Verdict& verdict : verdicts) {
        const ComparedDigits shown = verdictDigits(verdict, measurement.isAngular, decimals);
        const auto text = [&shown](const FineUnit& unit, double value) {
            return withUnit(unit.digits(value, shown.decimals), unit.name);
        };
        std::string result(verdictText(verdict.result).words);
        if (verdict.heldOut) {
            const ComparedDigits heldOut = heldOutDigits(verdict, measurement.isAngular, decimals);
            result += ", held out "
                + withUnit(
                    heldOut.value.digits(*verdict.heldOut, heldOut.decimals), heldOut.value.name);
        }
        table.add({figureText(verdict.tolerance.figure).words,
            verdict.value ? text(shown.value, *verdict.value) : "-",
            text(shown.limit, verdict.tolerance.value),
            verdict.uncertainty ? "U " + text(shown.uncertainty, *verdict.uncertainty)
                                : "uncertainty not stated",
            std::move(result)});
    }
    return "\n" + heading + "\n" + table.text();
}

Json verdictsJson(const std::vector<Verdict>& verdicts)
{
    Json list = Json::array();
    for (const Verdict& verdict : verdicts) {
        list.push_back({{"figure", figureName(verdict.tolerance.figure)},
            {"value", numberOrNull(verdict.value)}, {"tolerance", verdict.tolerance.value},
            {"U", numberOrNull(verdict.uncertainty)}, {"result", verdictName(verdict.result)}});
        if (verdict.heldOut)
            list.back()["heldOut"] = *verdict.heldOut;
    }
    return list;
}

Json excludedJson(const Measurement& measurement)
{
    Json list = Json::array();
    for (const RunValue& value : measurement.values)
        if (!value.isUsed)
            list.push_back({{"direction", approachName(value.direction)},
                {"target", value.target + 1}, {"run", value.run}});
    return list;
}

std::string datumPhrase(const std::optional<PlacedDeviation>& datum, bool isAngular)
{
    return datum ? ", " + datumText(*datum, isAngular, UnitLetters::Ascii).english()
                 : std::string();
}

std::string judgementText(
    const Measurement& measurement, const Judgement& judgement, const std::optional<double>& datum)
{
    const std::size_t excluded = measurement.excludedCount();
    std::string text = figuresText(measurement, judgement.figures,
        excluded > 0 ? excludedText(excluded).english() + "; figures of the others"
                     : "Figures of ISO 230-2:2014");
    if (judgement.ofAllValues)
        text += "\n"
            + figuresText(
                measurement, *judgement.ofAllValues, "Figures of ISO 230-2:2014, of all values");
    text += "\n" + targetsText(measurement, judgement.figures, datum);
    text += driftText(measurement, judgement);
    text += outliersText(measurement, judgement.outliers);
    if (judgement.vdi)
        text += vdiText(measurement, *judgement.vdi);
    text += conditionsText(judgement.compliance);
    return text + verdictsText(measurement, judgement.verdicts)
        + verdictsText(measurement, judgement.verdictsOfAllValues, verdictOfAllValuesHeading);
}

Json axisFiguresJson(const Iso230Figures& figures)
{
    Json axis = Json::object();
    for (const Iso230Figure figure : allIso230Figures())
        axis[std::string(figureName(figure))] = numberOrNull(figures[figure].value);
    return axis;
}

Json warningsJson(const std::vector<JudgeWarning>& warnings)
{
    Json all = Json::array();
    for (const JudgeWarning& warning : warnings)
        all.push_back({{"code", warning.name}, {"message", warning.text.english()}});
    return all;
}

Json judgementJson(const Measurement& measurement, const Judgement& judgement)
{
    return {{"standard", "ISO 230-2:2014"}, {"unit", positionUnit(measurement)},
        {"targets", measurement.targets},
        {"runs",
            {{"up", measurement.runCount(Approach::Up)},
                {"down", measurement.runCount(Approach::Down)}}},
        {"excluded", excludedJson(measurement)}, {"perTarget", perTargetJson(judgement.figures)},
        {"axis", axisFiguresJson(judgement.figures)},
        {"axisOfAllValues",
            judgement.ofAllValues ? axisFiguresJson(*judgement.ofAllValues) : Json(nullptr)},
        {"where", whereJson(judgement.figures)}, {"vdi3441", vdiJson(judgement.vdi)},
        {"drift",
            {{"up", driftJson(judgement.driftUp)}, {"down", driftJson(judgement.driftDown)},
                {"axisWithoutOffsets",
                    judgement.withoutOffsets ? axisFiguresJson(*judgement.withoutOffsets)
                                             : Json(nullptr)}}},
        {"outliers", outliersJson(judgement.outliers)},
        {"published", publishedJson(judgement.published)},
        {"contradictions", textsJson(judgement.published.contradictions)},
        {"compliance", complianceJson(judgement.compliance)},
        {"verdict", verdictsJson(judgement.verdicts)},
        {"verdictOfAllValues", verdictsJson(judgement.verdictsOfAllValues)},
        {"warnings", warningsJson(judgement.warnings)}};
}

} // namespace axiscomp::app
