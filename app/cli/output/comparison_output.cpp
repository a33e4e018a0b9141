// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output/comparison_output.h"

#include "app/cli/output/judgement_output.h"
#include "app/common/number_text.h"
#include "app/common/text_table.h"

namespace axiscomp::app {

namespace {

using Value = std::optional<double>;

/// In um, and in arc seconds for angles; "-": not defined.
struct FineText {
    double factor;
    std::string symbol;

    explicit FineText(const Measurement& measurement)
        : factor(measurement.isAngular ? 3600.0 : 1000.0)
        , symbol(measurement.isAngular ? "arcsec" : "um")
    {
    }
    [[nodiscard]] std::string operator()(const Value& value) const
    {
        return value ? fixedText(*value * factor, 3) : "-";
    }
    [[nodiscard]] std::string withSymbol(double value) const
    {
        return withUnit((*this)(value), symbol);
    }
};

Value changeOf(const Value& before, const Value& after)
{
    return before && after ? Value(*after - *before) : std::nullopt;
}

std::string sideBySide(const FineText& fine, const Comparison& comparison)
{
    TextTable table({"figure", ">before", ">predicted", ">after", ">change"});
    for (const Iso230Figure figure : allIso230Figures()) {
        const Value before = comparison.before[figure].value;
        const Value after = comparison.after[figure].value;
        const Value predicted =
            comparison.predicted ? (*comparison.predicted)[figure] : std::nullopt;
        table.add({figureText(figure).words, fine(before), fine(predicted), fine(after),
            fine(changeOf(before, after))});
    }
    return "Figures, in " + fine.symbol + "\n" + table.text();
}

std::string promiseText(const FineText& fine, const Comparison& comparison)
{
    if (!comparison.heldOut)
        return {};
    std::string text = "\nHeld out, at targets that the table did not know: M "
        + fine.withSymbol(comparison.heldOut->range) + ", largest "
        + fine.withSymbol(comparison.heldOut->largest) + ", rms "
        + fine.withSymbol(comparison.heldOut->rms) + "\n";
    if (!comparison.isAsPredicted)
        return text;
    const double spread = comparison.after[Iso230Figure::M].value.value_or(0.0);
    return text + (*comparison.isAsPredicted ? "As predicted: " : "Not as predicted: ") + "M is "
        + fine.withSymbol(spread) + " after, and " + fine.withSymbol(*comparison.largestAsPredicted)
        + " or less is as predicted (1.2 times M held out, and what cannot be told)\n";
}

std::string residualText(
    const Measurement& after, const FineText& fine, const Comparison& comparison)
{
    TextTable table(
        {">target [" + std::string(positionUnit(after)) + "]", ">left", ">standard error"});
    for (const RemainingError& error : comparison.residual)
        table.add({shortText(error.position), fine(error.value), fine(error.standardError)});
    return "\nWhat is left at the targets, in " + fine.symbol + "\n" + table.text();
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

std::string comparisonText(const Measurement& after, const Comparison& comparison)
{
    const FineText fine(after);
    const std::string verdict = verdictsText(after, comparison.verdicts);
    return sideBySide(fine, comparison) + promiseText(fine, comparison) + hintsText(comparison)
        + residualText(after, fine, comparison) + verdict;
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
        {"hints", std::move(hints)}, {"verdict", verdictsJson(comparison.verdicts)}};
}

} // namespace axiscomp::app
