// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/judge/judgement.h"

#include "core/metrology/fine_quantity.h"
#include "core/metrology/joined_files.h"

#include <algorithm>
#include <iterator>

namespace axiscomp {

namespace {

void warnOfDrift(Judgement& result, const Measurement& measurement, const DirectionDrift& drift,
    Approach direction)
{
    if (!drift.isSuspected)
        return;
    result.warnings.push_back({"DriftSuspected",
        AXISCOMP_TEXT("Measurement",
            "the runs {direction} drift by {drift} from the first to the last, more than their "
            "spread explains")
            .with("direction", approachText(direction))
            .with("drift", fineQuantity(*drift.firstToLast, measurement.isAngular))});
}

void warnOfDisturbance(Judgement& result, const DirectionOutliers& outliers, Approach direction)
{
    if (outliers.isDisturbed)
        result.warnings.push_back({"DisturbedMeasurement",
            AXISCOMP_TEXT("Measurement",
                "more than a fifth of the values {direction} do not fit the others: the "
                "measurement was disturbed, and nothing is proposed")
                .with("direction", approachText(direction))});
}

void warnOfUndecided(Judgement& result, const DirectionOutliers& outliers, Approach direction)
{
    if (!outliers.isUndecided)
        return;
    const TextPattern pattern = result.outliers.rule == OutlierRule::Grubbs
        ? AXISCOMP_TEXT("Measurement",
            "the rule grubbs is for 4 to 10 values of a target, and some of those {direction} were "
            "not tested")
        : AXISCOMP_TEXT("Measurement",
            "a value {direction} stands out that the rule mad does not propose: it keeps 3 values "
            "of each target, and needs others that differ");
    result.warnings.push_back(
        {"OutliersNotTested", pattern.with("direction", approachText(direction))});
}

/// "M1 (file 1)", "M2 (file 3)"
std::vector<Text> statementTexts(const TextsOfFiles& said)
{
    std::vector<Text> texts;
    for (const auto& each : said)
        if (!each.said.empty())
            texts.push_back(AXISCOMP_TEXT("Measurement", "{said} (file {file})")
                                .with("said", each.said)
                                .with("file", each.files.front() + 1));
    return texts;
}

Text verdictOfAllText(const Verdict& verdict, bool isAngular, UnitLetters letters)
{
    const double limit = verdict.tolerance.value;
    const double value = verdict.value.value_or(limit);
    constexpr int decimals = 3;
    const ComparedDigits shown = verdictDigits(verdict, isAngular, decimals);
    const auto quantity = [&](const FineUnit& unit, double amount) {
        return Quantity{unit.digits(amount, shown.decimals),
            letters == UnitLetters::Ascii ? unit.name : unit.symbol};
    };
    return AXISCOMP_TEXT(
        "Measurement", "of all values {figure} is {value} (tolerance {tolerance}: {result})")
        .with("figure", figureText(verdict.tolerance.figure))
        .with("value", quantity(shown.value, value))
        .with("tolerance", quantity(shown.limit, limit))
        .with("result", verdictText(verdict.result));
}

void judgeAll(Judgement& result, const JudgeOptions& options, bool isAngular)
{
    if (!result.ofAllValues)
        return;
    result.verdictsOfAllValues =
        verdicts(*result.ofAllValues, options.tolerances, options.uncertainty);
    std::ranges::move(otherVerdicts(result.verdicts, result.verdictsOfAllValues, isAngular),
        std::back_inserter(result.warnings));
}

} // namespace

Text excludedText(std::size_t count)
{
    return AXISCOMP_COUNTED("Measurement",
        "{count} values excluded, not an evaluation by ISO 230-2",
        "1 value excluded, not an evaluation by ISO 230-2")
        .with("count", count);
}

std::vector<JudgeWarning> otherMachines(const Measurement& measurement)
{
    std::vector<JudgeWarning> warnings;
    const auto machines = saidByFiles(measurement, &MeasurementHeader::machine);
    if (areDifferent(machines))
        warnings.push_back({"OtherMachine",
            AXISCOMP_TEXT("Measurement", "the files are of different machines: {machines}")
                .with("machines", statementTexts(machines))});
    const auto serials = saidByFiles(measurement, &MeasurementHeader::serial);
    if (areDifferent(serials))
        warnings.push_back({"OtherSerial",
            AXISCOMP_TEXT("Measurement", "the files have different serial numbers: {numbers}")
                .with("numbers", statementTexts(serials))});
    return warnings;
}

std::vector<JudgeWarning> otherVerdicts(std::span<const Verdict> inUse,
    std::span<const Verdict> ofAllValues, bool isAngular, UnitLetters letters)
{
    std::vector<JudgeWarning> warnings;
    for (std::size_t n = 0; n < inUse.size(); ++n)
        if (ofAllValues[n].value && ofAllValues[n].result != inUse[n].result)
            warnings.push_back(
                {"OtherVerdict", verdictOfAllText(ofAllValues[n], isAngular, letters)});
    return warnings;
}

bool Judgement::isWithinTolerances() const
{
    return std::ranges::all_of(
        verdicts, [](const Verdict& verdict) { return verdict.result == VerdictResult::Passed; });
}

Judgement judge(const Measurement& measurement, const JudgeOptions& options)
{
    Judgement result;
    result.warnings = otherMachines(measurement);
    result.figures = iso230Figures(measurement);
    const Measurement whole = withAllValues(measurement);
    const std::size_t excluded = measurement.excludedCount();
    if (excluded > 0) {
        result.ofAllValues = iso230Figures(whole);
        result.warnings.push_back({"ValuesExcluded", excludedText(excluded)});
    }
    if (measurement.kind == MeasurementKind::Runs) {
        result.driftUp = driftOf(measurement, Approach::Up);
        result.driftDown = driftOf(measurement, Approach::Down);
        result.outliers = findOutliers(measurement, options.outlierRule);
    }
    warnOfDrift(result, measurement, result.driftUp, Approach::Up);
    warnOfDrift(result, measurement, result.driftDown, Approach::Down);
    if (result.driftUp.isSuspected || result.driftDown.isSuspected)
        result.withoutOffsets = iso230Figures(withoutDrift(measurement, DriftRemoval::Offset));
    warnOfDisturbance(result, result.outliers.up, Approach::Up);
    warnOfDisturbance(result, result.outliers.down, Approach::Down);
    warnOfUndecided(result, result.outliers.up, Approach::Up);
    warnOfUndecided(result, result.outliers.down, Approach::Down);
    // What a file says is said of all of its values.
    result.published = checkPublished(whole, excluded > 0 ? *result.ofAllValues : result.figures);
    for (const Text& contradiction : result.published.contradictions)
        result.warnings.push_back({"PublishedContradiction", contradiction});
    result.compliance = complianceOf(measurement, result.figures, options.period);
    if (options.wantsVdi)
        result.vdi = vdi3441Figures(result.figures);
    result.verdicts = verdicts(result.figures, options.tolerances, options.uncertainty);
    judgeAll(result, options, measurement.isAngular);
    return result;
}

} // namespace axiscomp
