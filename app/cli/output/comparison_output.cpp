// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output/comparison_output.h"

#include "app/cli/output/fine_text.h"
#include "app/cli/output/judgement_output.h"
#include "app/common/number_text.h"
#include "app/common/text_table.h"
#include "core/metrology/fit/measurement_fit.h"

#include <algorithm>
#include <iterator>

namespace axiscomp::app {

namespace {

using Value = std::optional<double>;

std::string sideBySide(bool isAngular, const Comparison& comparison)
{
    std::vector<Value> shown;
    for (const Iso230Figures* one : {&comparison.before, &comparison.after})
        std::ranges::copy(figureValues(*one).values, std::back_inserter(shown));
    if (comparison.predicted)
        std::ranges::copy(comparison.predicted->values, std::back_inserter(shown));
    const FineText fine(shown, isAngular);
    TextTable table({"figure", ">before", ">predicted", ">after", ">change"});
    for (const Iso230Figure figure : allIso230Figures()) {
        const Value before = comparison.before[figure].value;
        const Value after = comparison.after[figure].value;
        table.add({figureText(figure).words, fine(before),
            comparison.predicted ? fine((*comparison.predicted)[figure]) : "-", fine(after),
            fine(changeOf(before, after))});
    }
    const std::string rule = comparison.isByTemperature
        ? "  " + figuresByTemperatureText().english() + "\n"
        : std::string();
    return "Figures, in " + fine.unit() + "\n" + table.text() + rule;
}

/// As if nothing were left out; empty where nothing is.
std::string allValuesText(bool isAngular, const Comparison& comparison)
{
    if (!comparison.hasExcluded())
        return {};
    const Iso230Figures& before = comparison.ofAllValues(false);
    const Iso230Figures& after = comparison.ofAllValues(true);
    std::vector<Value> shown;
    for (const Iso230Figures* one : {&before, &after})
        std::ranges::copy(figureValues(*one).values, std::back_inserter(shown));
    const FineText fine(shown, isAngular);
    TextTable table({"figure", ">before", ">after", ">change"});
    for (const Iso230Figure figure : allIso230Figures())
        table.add({figureText(figure).words, fine(before[figure].value), fine(after[figure].value),
            fine(changeOf(before[figure].value, after[figure].value))});
    return "\nFigures of all values, in " + fine.unit() + "\n" + table.text();
}

/// What the figures are, before anybody reads them.
std::string warningsText(const Comparison& comparison)
{
    std::string text;
    for (const JudgeWarning& warning : comparison.warnings)
        text += warning.text.english() + "\n";
    return text.empty() ? text : text + "\n";
}

/// Of an M that is within the limit, as it was before.
std::string noBetterText(bool isAngular, const Comparison& comparison)
{
    const std::string name = shortFigureName(comparison.promised);
    const double before = comparison.before[comparison.promised].value.value_or(0.0);
    const double after = comparison.after[comparison.promised].value.value_or(0.0);
    const auto [value, limit] = comparedQuantities(after, before, isAngular);
    return (comparison.isAsPredicted
                   ? "Not as predicted, since the machine is no better than before: "
                   : "Whether it is as predicted is open, since " + name
                       + " is smaller than before by no more than what cannot be told: ")
        + name + " is " + withUnit(value.digits, value.unit) + " after and was "
        + withUnit(limit.digits, limit.unit) + " before\n";
}

std::string promiseText(bool isAngular, const Comparison& comparison)
{
    if (!comparison.heldOut)
        return {};
    const std::string name = shortFigureName(comparison.promised);
    std::string text = "\nHeld out, at targets that the table did not know: " + name + " "
        + fineText(comparison.heldOut->range, isAngular) + ", largest "
        + fineText(comparison.heldOut->largest, isAngular) + ", rms "
        + fineText(comparison.heldOut->rms, isAngular) + "\n";
    if (!comparison.largestAsPredicted)
        return text + "Whether it is as predicted is open, since " + name
            + " is not defined after\n";
    if (comparison.isNoBetter)
        return text + noBetterText(isAngular, comparison);
    const double spread = comparison.after[comparison.promised].value.value_or(0.0);
    const auto [value, limit] =
        comparedQuantities(spread, *comparison.largestAsPredicted, isAngular);
    const std::string result = !comparison.isAsPredicted
        ? std::string("Whether it is as predicted is open, since ")
            + (comparison.lesserRange ? "less of the axis was measured: "
                                      : "its targets are farther apart than before: ")
        : *comparison.isAsPredicted ? "As predicted: "
                                    : "Not as predicted: ";
    return text + result + name + " is " + withUnit(value.digits, value.unit) + " after, and "
        + withUnit(limit.digits, limit.unit) + " or less is as predicted (1.2 times " + name
        + " held out, and what cannot be told)\n";
}

/// From the datum.
std::string residualText(const Measurement& after, const Comparison& comparison,
    const std::optional<PlacedDeviation>& datum)
{
    std::vector<Value> shown;
    for (const RemainingError& error : comparison.residual)
        shown.insert(
            shown.end(), {Value(fromDatum(error.value, datum)), Value(error.standardError)});
    const FineText fine(shown, after.isAngular);
    TextTable table(
        {">target [" + std::string(positionUnit(after)) + "]", ">left", ">standard error"});
    for (const RemainingError& error : comparison.residual)
        table.add({shortText(error.position), fine(fromDatum(error.value, datum)),
            fine(error.standardError)});
    return "\nWhat is left at the targets, in " + fine.unit() + datumPhrase(datum, after.isAngular)
        + "\n" + table.text();
}

std::string hintsText(const Comparison& comparison)
{
    std::string text;
    for (const ComparisonHint& hint : comparison.hints)
        text += "  " + hint.text.english() + "\n";
    return text.empty() ? text : "\nWhat to look at\n" + text;
}

Json axisJson(const FigureValues& figures)
{
    Json json = Json::object();
    for (const Iso230Figure figure : allIso230Figures())
        json[std::string(figureName(figure))] =
            figures[figure] ? Json(*figures[figure]) : Json(nullptr);
    return json;
}

Json numberOrNothing(const Value& value)
{
    return value ? Json(*value) : Json(nullptr);
}

} // namespace

std::string comparisonText(const Measurement& after, const Comparison& comparison,
    const std::optional<PlacedDeviation>& datum)
{
    const std::string verdict = verdictsText(after, comparison.verdicts)
        + verdictsText(after, comparison.verdictsOfAllValues, verdictOfAllValuesHeading);
    return warningsText(comparison) + sideBySide(after.isAngular, comparison)
        + allValuesText(after.isAngular, comparison) + promiseText(after.isAngular, comparison)
        + hintsText(comparison) + residualText(after, comparison, datum) + verdict;
}

Json comparisonJson(const Measurement& after, const Comparison& comparison)
{
    Json residual = Json::array();
    for (const RemainingError& error : comparison.residual)
        residual.push_back({{"position", error.position}, {"value", error.value},
            {"standardError", numberOrNothing(error.standardError)}});
    Json hints = Json::array();
    for (const ComparisonHint& hint : comparison.hints)
        hints.push_back({{"name", hint.name}, {"text", hint.text.english()}});
    const auto figuresOrNothing = [](const std::optional<Iso230Figures>& figures) {
        return figures ? axisFiguresJson(*figures) : Json(nullptr);
    };
    Json heldOut;
    if (comparison.heldOut)
        heldOut = {{"rms", comparison.heldOut->rms}, {"largest", comparison.heldOut->largest},
            {"M", comparison.heldOut->range}};
    return {{"unit", positionUnit(after)}, {"before", axisFiguresJson(comparison.before)},
        {"predicted", comparison.predicted ? axisJson(*comparison.predicted) : Json(nullptr)},
        {"heldOut", std::move(heldOut)}, {"after", axisFiguresJson(comparison.after)},
        {"residual", std::move(residual)},
        {"asPredicted", comparison.isAsPredicted ? Json(*comparison.isAsPredicted) : Json(nullptr)},
        {"largestAsPredicted", numberOrNothing(comparison.largestAsPredicted)},
        {"hints", std::move(hints)}, {"verdict", verdictsJson(comparison.verdicts)},
        {"beforeOfAllValues", figuresOrNothing(comparison.beforeOfAllValues)},
        {"afterOfAllValues", figuresOrNothing(comparison.afterOfAllValues)},
        {"verdictOfAllValues", verdictsJson(comparison.verdictsOfAllValues)},
        {"warnings", warningsJson(comparison.warnings)}};
}

} // namespace axiscomp::app
