// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/judging/judge_outlook.h"

#include "ui/record/record_model.h"
#include "ui/text/fine_scale.h"
#include "ui/text/message_text.h"
#include "ui/text/translated_text.h"

#include <QCoreApplication>

#include <algorithm>

namespace axiscomp::ui {

namespace {

using Mark = PageTabs::Mark;

struct OutlookTexts {
    Q_DECLARE_TR_FUNCTIONS(JudgeOutlook)
};

/// What a table can do about a figure is in docs/metrology.md: nothing about reversal and spread.
QString ofVerdict(const Verdict& verdict, bool isAngular)
{
    const QString figure = translated(figureText(verdict.tolerance.figure));
    const QString tolerance = amountText(verdict.tolerance.value, isAngular);
    if (!verdict.value)
        return asSentence(
            OutlookTexts::tr("%1: not defined, so that the tolerance %2 cannot be met.")
                .arg(figure, tolerance));
    const QString words = verdict.result == VerdictResult::Undecided
        ? OutlookTexts::tr("%1: %2, nearer to the tolerance %3 than the uncertainty. That is "
                           "undecided.")
        : isRange(verdict.tolerance.figure)
        ? OutlookTexts::tr("%1: %2, above the tolerance %3. Go on to Fit: a table may make it "
                           "smaller.")
        : OutlookTexts::tr("%1: %2, above the tolerance %3. No table makes it smaller: look at the "
                           "mechanics.");
    return asSentence(words.arg(figure, comparedTexts(verdict, isAngular).value, tolerance));
}

/// What a person should look at first; empty: nothing is wrong.
QString concern(const Judgement& judgement, bool isAngular)
{
    const auto warningOf = [&judgement](std::string_view name) {
        const auto found = std::ranges::find(judgement.warnings, name, &JudgeWarning::name);
        return found == judgement.warnings.end() ? QString() : sentenceText(found->text);
    };
    if (const QString text = warningOf("DisturbedMeasurement"); !text.isEmpty())
        return text;
    const std::size_t proposed =
        judgement.outliers.up.flagged.size() + judgement.outliers.down.flagged.size();
    if (proposed > 0)
        return sentenceText(AXISCOMP_COUNTED("Measurement",
            "{count} values do not fit the others: look at them, and exclude them or leave "
            "them in",
            "1 value does not fit the others: look at it, and exclude it or leave it in")
                                .with("count", proposed));
    for (const VerdictResult result :
        {VerdictResult::Failed, VerdictResult::NotDefined, VerdictResult::Undecided}) {
        const auto found = std::ranges::find(judgement.verdicts, result, &Verdict::result);
        if (found != judgement.verdicts.end())
            return ofVerdict(*found, isAngular);
    }
    for (const char* name :
        {"OtherVerdict", "DriftSuspected", "PublishedContradiction", "ValuesExcluded"})
        if (const QString text = warningOf(name); !text.isEmpty())
            return text;
    for (const JudgeWarning& warning : judgement.warnings)
        return sentenceText(warning.text);
    for (const ComplianceLine& line : judgement.compliance)
        if (line.isMet == false)
            return OutlookTexts::tr("The standard's condition “%1” is not met.")
                .arg(translated(line.text));
    return {};
}

} // namespace

JudgeOutlook judgeOutlook(const RecordModel& record)
{
    const RecordState& state = record.state();
    if (record.record().files.empty())
        return {Mark::Empty, Tone::Information,
            OutlookTexts::tr("Add the files of a measurement on the tab Measure.")};
    if (record.isEvaluating() && !record.isMeasurementShown())
        return {Mark::Empty, Tone::Information, OutlookTexts::tr("The files are being read …")};
    if (state.refusal)
        return {Mark::Warning, Tone::Error, errorText(*state.refusal)};
    if (!state.measurement)
        return {Mark::Warning, Tone::Error,
            OutlookTexts::tr("A file cannot be used: the tab Measure says why.")};
    if (!state.judgement)
        return {Mark::Empty, Tone::Information,
            OutlookTexts::tr("This measurement has no targets, and so no figures of ISO 230-2. Go "
                             "on to Fit, or measure at targets.")};
    const QString wrong = concern(*state.judgement, state.measurement->isAngular);
    if (!wrong.isEmpty())
        return {Mark::Warning, Tone::Warning, wrong};
    if (state.judgement->verdicts.empty())
        return {Mark::Ready, Tone::Information,
            OutlookTexts::tr("Enter the tolerances of the axis, or go on to Fit.")};
    return {Mark::Ready, Tone::Success,
        OutlookTexts::tr("Every tolerance is met. A table can still make the axis better: go on to "
                         "Fit.")};
}

} // namespace axiscomp::ui
