// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/judge/uncertainty.h"

#include "core/base/portable_math.h"
#include "core/io/strict_json.h"
#include "core/table/position_unit.h"
#include "core/text/number_text.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace axiscomp {

namespace {

/// Half of a range of a rectangular distribution is 1.73 standard deviations: r / (2 sqrt 3) * 2.
constexpr double rectangular = 0.6;

tl::unexpected<Error> wrongAmount(Text reason)
{
    return fail(ErrorCode::InvalidArgument, {{"reason", std::move(reason)}});
}

/// A member that may be missing.
double memberOr(const JsonNode& node, std::string_view key, double fallback)
{
    if (!node.has(key))
        return fallback;
    const double number = node[key].number();
    if (!std::isfinite(number) || (number < 0.0 && key != "temperature"))
        node[key].refuse(AXISCOMP_TEXT("Error", "a number that is not negative"));
    return number;
}

/// Of a product of two members one alone would count as 0.
void expectBeside(const JsonNode& budget, std::string_view one, std::string_view other)
{
    for (const auto& [there, missing] : {std::pair(one, other), std::pair(other, one)})
        if (budget.has(there) && !budget.has(missing))
            budget[there].refuse(
                AXISCOMP_TEXT("Error", "this counts only with {member}, which is missing")
                    .with("member", missing));
}

/// A number and its unit, which has no digit and may follow without a blank: the longest number
/// counts.
std::pair<std::optional<double>, std::string_view> parsedAmount(std::string_view text)
{
    std::size_t length = text.find_first_not_of("0123456789.+-eE");
    if (length == std::string_view::npos)
        length = text.size();
    while (length > 0 && !numberOf(text.substr(0, length)))
        --length;
    return {numberOf(text.substr(0, length)), trimmedToken({text.substr(length), 0, 1}).text};
}

} // namespace

Uncertainty uncertaintyOf(const UncertaintyBudget& budget)
{
    constexpr double standardCelsius = 20.0;
    Uncertainty result;
    result.device = budget.deviceMm + budget.devicePpm * 1e-6 * budget.lengthMm;
    result.misalignment = budget.lengthMm * (1.0 - portable::cos(budget.misalignmentMrad * 1e-3));
    result.temperature =
        rectangular * budget.expansionPerKelvin * budget.lengthMm * budget.temperatureRangeKelvin;
    result.coefficient = rectangular * std::abs(budget.materialCelsius - standardCelsius)
        * budget.lengthMm * budget.expansionRangePerKelvin;
    result.environment = rectangular * budget.environmentMm;
    result.total = std::sqrt(result.device * result.device
        + result.misalignment * result.misalignment + result.temperature * result.temperature
        + result.coefficient * result.coefficient + result.environment * result.environment);
    return result;
}

Result<UncertaintyBudget> uncertaintyBudgetFromJson(std::string_view text, double defaultLengthMm)
{
    StrictJson json(text, {.size = std::size_t{64} * 1024});
    const JsonNode root = json.root();
    constexpr std::array<std::string_view, 9> keys{"length", "device", "devicePpm", "misalignment",
        "expansion", "temperatureRange", "temperature", "expansionRange", "environment"};
    root.expectMembers(std::span<const std::string_view>(), keys);
    expectBeside(root, "expansion", "temperatureRange");
    expectBeside(root, "temperature", "expansionRange");
    // A length alone, or nothing, would state that there is no uncertainty.
    if (std::ranges::none_of(
            std::span(keys).subspan(1), [&root](std::string_view key) { return root.has(key); }))
        root.refuse(AXISCOMP_TEXT("Error", "it states no term of the uncertainty"));
    UncertaintyBudget budget;
    budget.lengthMm = memberOr(root, "length", defaultLengthMm);
    budget.deviceMm = memberOr(root, "device", 0.0);
    budget.devicePpm = memberOr(root, "devicePpm", 0.0);
    budget.misalignmentMrad = memberOr(root, "misalignment", 0.0);
    budget.expansionPerKelvin = memberOr(root, "expansion", 0.0);
    budget.temperatureRangeKelvin = memberOr(root, "temperatureRange", 0.0);
    budget.materialCelsius = memberOr(root, "temperature", 20.0);
    budget.expansionRangePerKelvin = memberOr(root, "expansionRange", 0.0);
    budget.environmentMm = memberOr(root, "environment", 0.0);
    if (json.problem())
        return wrongAmount(AXISCOMP_TEXT("Error", "the uncertainty budget is wrong: {reason}")
                               .with("reason", json.problem()->reason));
    return budget;
}

Result<double> amountFromText(std::string_view text, bool isAngular, std::string_view defaultUnit)
{
    const auto [number, stated] = parsedAmount(text);
    const std::string_view unit = stated.empty() ? defaultUnit : stated;
    const std::string_view own = isAngular ? "deg" : "mm";
    const auto factor = unit.empty() ? std::optional(1.0) : unitFactor(unit, own);
    if (!number || !factor || !(*number >= 0.0) || !std::isfinite(*number))
        return wrongAmount(
            (isAngular ? AXISCOMP_TEXT("Error",
                 "\"{text}\" is no angle; write a number that is not negative and its unit, such "
                 "as 5arcsec")
                       : AXISCOMP_TEXT("Error",
                           "\"{text}\" is no length; write a number that is not negative and its "
                           "unit, such as 10um"))
                .with("text", text));
    return *number * *factor;
}

std::vector<Text> assumedUnits(std::string_view limits, bool isAngular)
{
    std::vector<Token> parts;
    splitCells({limits, 0, 1}, ',', parts);
    std::vector<Text> assumptions;
    for (const Token& part : parts) {
        const std::size_t equals = part.text.find('=');
        if (equals == std::string_view::npos)
            continue;
        const auto [number, unit] =
            parsedAmount(trimmedToken({part.text.substr(equals + 1), 0, 1}).text);
        if (!number || *number == 0.0 || !unit.empty())
            continue;
        const double inFineUnit = *number * (isAngular ? 3600.0 : 1000.0);
        assumptions.push_back(
            AXISCOMP_TEXT("Error", "{text} has no unit and is taken as {amount}, {fine}")
                .with("text", trimmedToken(part).text)
                .with("amount", Quantity{roundedText(*number), isAngular ? "deg" : "mm"})
                .with("fine", Quantity{roundedText(inFineUnit), isAngular ? "arcsec" : "um"}));
    }
    return assumptions;
}

Result<std::vector<Tolerance>> tolerancesFromText(std::string_view text, bool isAngular)
{
    std::vector<Token> parts;
    splitCells({text, 0, 1}, ',', parts);
    std::vector<Tolerance> tolerances;
    for (const Token& part : parts) {
        const std::size_t equals = part.text.find('=');
        const auto figure = figureNamed(trimmedToken({part.text.substr(0, equals), 0, 1}).text);
        if (equals == std::string_view::npos || !figure)
            return wrongAmount(AXISCOMP_TEXT("Error",
                "\"{text}\" is no tolerance; write a figure and its limit, such as A=10um; the "
                "figures are A, A+, A-, R, R+, R-, E, E+, E-, B, Bm and M")
                                   .with("text", part.text));
        AXISCOMP_TRY(const double value,
            amountFromText(trimmedToken({part.text.substr(equals + 1), 0, 1}).text, isAngular));
        tolerances.push_back({*figure, value});
    }
    return tolerances;
}

std::string_view verdictName(VerdictResult result)
{
    switch (result) {
    case VerdictResult::Passed:
        return "passed";
    case VerdictResult::Failed:
        return "failed";
    case VerdictResult::Undecided:
        return "undecided";
    case VerdictResult::NotDefined:
        break;
    }
    return "notDefined";
}

TextPattern verdictText(VerdictResult result)
{
    switch (result) {
    case VerdictResult::Passed:
        return AXISCOMP_TEXT("Measurement", "passed");
    case VerdictResult::Failed:
        return AXISCOMP_TEXT("Measurement", "failed");
    case VerdictResult::Undecided:
        return AXISCOMP_TEXT("Measurement", "undecided");
    case VerdictResult::NotDefined:
        break;
    }
    return AXISCOMP_TEXT("Measurement", "not defined");
}

VerdictResult verdictResult(double value, double tolerance, std::optional<double> uncertainty)
{
    const double size = std::abs(value);
    const double u = uncertainty.value_or(0.0);
    if (!isAbove(size + u, tolerance))
        return VerdictResult::Passed;
    return isAbove(size - u, tolerance) ? VerdictResult::Failed : VerdictResult::Undecided;
}

std::vector<Verdict> verdicts(const Iso230Figures& figures, std::span<const Tolerance> tolerances,
    std::optional<double> uncertainty)
{
    std::vector<Verdict> results;
    for (const Tolerance& tolerance : tolerances) {
        Verdict verdict{
            tolerance, figures[tolerance.figure].value, uncertainty, VerdictResult::NotDefined};
        if (verdict.value)
            verdict.result = verdictResult(*verdict.value, tolerance.value, uncertainty);
        results.push_back(verdict);
    }
    return results;
}

ComparedDigits verdictDigits(const Verdict& verdict, bool isAngular, int decimals)
{
    const double limit = verdict.tolerance.value;
    const double value = verdict.value.value_or(limit);
    return comparedDigits(value, limit, isAngular, decimals, verdict.uncertainty.value_or(0.0));
}

ComparedDigits heldOutDigits(const Verdict& verdict, bool isAngular, int decimals)
{
    Verdict heldOut = verdict;
    heldOut.value = verdict.heldOut;
    return verdictDigits(heldOut, isAngular, decimals);
}

int verdictDecimals(
    std::initializer_list<const Verdict*> verdicts, const FineUnit& unit, int decimals)
{
    for (const Verdict* verdict : verdicts)
        if (verdict && verdict->value)
            decimals = decimalsApart(unit, *verdict->value, verdict->tolerance.value, decimals,
                verdict->uncertainty.value_or(0.0));
    return decimals;
}

const Verdict* verdictOf(std::span<const Verdict> verdicts, Iso230Figure figure)
{
    const auto found = std::ranges::find(
        verdicts, figure, [](const Verdict& verdict) { return verdict.tolerance.figure; });
    return found == verdicts.end() ? nullptr : &*found;
}

} // namespace axiscomp
