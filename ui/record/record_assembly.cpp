// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/record_assembly.h"

#include "core/metrology/record/comparison.h"

#include <QFileInfo>

#include <algorithm>

namespace axiscomp::ui {

namespace {

/// Nothing of it is copied: it lives as long as the record that it is of.
void openMeasurement(const std::shared_ptr<const CalibrationRecord>& calibration,
    const RecordedMeasurement& recorded, Record& record)
{
    for (const RecordedFile& file : recorded.files)
        record.files.push_back({QString::fromStdString(file.file), {},
            std::shared_ptr<const RecordedFile>(calibration, &file)});
    record.swapsDirections = recorded.swapsDirections;
    record.exclusions = recorded.exclusions;
    record.corrections = {recorded.corrections.temperature, recorded.corrections.deadPath};
}

/// Of what a record holds of tolerances and uncertainty: they are in deg where its measurement is
/// of an angle. What is chosen beside the measurement of a table has no part in that.
bool areLimitsAngles(const CalibrationRecord& record)
{
    const RecordedMeasurement* const measurement = record.before ? &*record.before
        : !record.after.empty()                                  ? &record.after.back().measurement
                                                                 : nullptr;
    return measurement && !measurement->files.empty()
        && measurement->files.front().measurement.isAngular;
}

/// How a table was made, as far as the window can say it; nothing of what is said elsewhere, and
/// not where it was looked up, which is for the source of the axis to say.
FitSettings chosenSettings(const FitSettings& made)
{
    FitSettings chosen = made;
    const FitSettings unset;
    chosen.lookupAt = unset.lookupAt;
    chosen.tolerances = unset.tolerances;
    chosen.uncertainty = unset.uncertainty;
    chosen.outlierRule = unset.outlierRule;
    chosen.mostPoints = unset.mostPoints;
    return chosen;
}

bool isUsable(const ReadMeasurement& file)
{
    return file.measurement() != nullptr;
}

/// Its files that can be used; nothing without one.
std::optional<RecordedMeasurement> usablePart(RecordState state)
{
    std::erase_if(state.files, [](const ReadMeasurement& file) { return !isUsable(file); });
    if (state.files.empty())
        return std::nullopt;
    const auto recorded = recordedMeasurement(state);
    return recorded ? std::optional(*recorded) : std::nullopt;
}

Result<std::optional<RecordedMeasurement>> measurementOf(
    const RecordState& state, bool leavesOutUnusable)
{
    if (state.record.files.empty())
        return std::optional<RecordedMeasurement>();
    if (leavesOutUnusable)
        return usablePart(state);
    AXISCOMP_TRY(auto recorded, recordedMeasurement(state));
    return std::optional(std::move(recorded));
}

/// What the file has and a table that was made since does not say.
void carryOver(const CalibrationRecord& base, CalibrationRecord& made)
{
    made.others.insert(base.others.begin(), base.others.end());
    if (!made.time)
        made.time = base.time;
    if (!made.drive)
        made.drive = base.drive;
    if (!made.judging)
        made.judging = base.judging;
}

void keepMembers(const std::optional<RecordedMeasurement>& known, RecordedMeasurement& made)
{
    if (!known)
        return;
    made.others = known->others;
    made.corrections.drift = known->corrections.drift; // of the table: it is not chosen here
    for (RecordedFile& file : made.files) {
        const auto same = std::ranges::find(known->files, file.sha256, &RecordedFile::sha256);
        if (same != known->files.end() && same->measurement == file.measurement)
            file.others = same->others;
    }
}

/// The measurement of the table stays what the table was made of; what is chosen since stands
/// beside it.
void putBefore(std::optional<RecordedMeasurement> before, bool isTableUsed, RecordedDraft& draft,
    CalibrationRecord& made)
{
    if (before)
        keepMembers(draft.before ? draft.before : made.before, *before);
    draft.before.reset();
    if (isTableUsed && made.before) {
        if (before && !isSameMeasurement(*before, *made.before))
            draft.before = std::move(before);
        return;
    }
    made.before = std::move(before);
}

/// stated: the table that a person says was active.
void putAfter(std::optional<RecordedMeasurement> after, std::optional<std::uint32_t> stated,
    RecordedDraft& draft, const CalibrationRecord& made)
{
    if (after)
        keepMembers(draft.after, *after);
    draft.after.reset();
    draft.isTableStated = false;
    const bool isKept = after && std::ranges::any_of(made.after, [&](const RecordedAfter& kept) {
        return isSameMeasurement(kept.measurement, *after);
    });
    if (!after || isKept)
        return;
    draft.after = std::move(after);
    // The file says it of its own table: said of another one, it is not said of that.
    draft.isTableStated = stated && stated == comparisonRequest(made).tableCrc;
}

/// The verdict is one of the last measurement, by the tolerances that it was given.
Result<void> judgeAnew(CalibrationRecord& made)
{
    const RecordedMeasurement* last = !made.after.empty() ? &made.after.back().measurement
        : made.before                                     ? &*made.before
                                                          : nullptr;
    if (!made.verdict)
        return {};
    made.verdict->figures.clear();
    if (!last)
        return {};
    AXISCOMP_TRY(const auto measurement, usedMeasurement(*last));
    if (measurement.hasTargets())
        made.verdict->figures = verdicts(
            figuresBy(made, measurement), made.judging->tolerances, made.judging->uncertainty);
    return {};
}

Result<void> putJudging(const Record& record, CalibrationRecord& made)
{
    std::vector<Tolerance> tolerances;
    std::optional<double> uncertainty;
    // 0.01 mm would be read as 0.01 deg.
    if (record.areLimitsAngles == areLimitsAngles(made)) {
        tolerances = record.tolerances;
        uncertainty = record.uncertainty;
    }
    const RecordedJudging holds = judgingOf(made);
    if (holds.tolerances == tolerances && holds.uncertainty == uncertainty
        && holds.outlierRule == record.outlierRule)
        return {};
    if (!made.judging)
        made.judging.emplace();
    made.judging->tolerances = std::move(tolerances);
    made.judging->uncertainty = uncertainty;
    made.judging->outlierRule = record.outlierRule;
    return judgeAnew(made);
}

} // namespace

OpenedRecord opened(const std::shared_ptr<const CalibrationRecord>& calibration)
{
    OpenedRecord result;
    const auto& work = calibration->draft;
    if (work && work->before)
        openMeasurement(calibration, *work->before, result.record);
    else if (calibration->before)
        openMeasurement(calibration, *calibration->before, result.record);
    RecordedJudging judging = judgingOf(*calibration);
    result.record.areLimitsAngles = areLimitsAngles(*calibration);
    result.record.tolerances = std::move(judging.tolerances);
    result.record.uncertainty = judging.uncertainty;
    result.record.outlierRule = judging.outlierRule;
    if (!calibration->tables.empty())
        result.record.calibration = calibration;
    // A table over temperature is made by the command line alone.
    if (calibration->fit && !calibration->fit->settings.isByTemperature)
        result.record.fit.settings = chosenSettings(calibration->fit->settings);
    result.record.fit.areLengthsAngles = areLimitsAngles(*calibration);
    if (work && work->after) {
        openMeasurement(calibration, *work->after, result.after);
        if (work->isTableStated)
            result.after.statedTable = comparisonRequest(*calibration).tableCrc;
    } else if (const RecordedAfter* const last = lastAfter(*calibration)) {
        openMeasurement(calibration, last->measurement, result.after);
        // It would not be among those otherwise.
        result.after.statedTable =
            last->tableCrc ? last->tableCrc : comparisonRequest(*calibration).tableCrc;
    }
    return result;
}

Result<RecordedMeasurement> recordedMeasurement(const RecordState& state)
{
    RecordedMeasurement recorded;
    for (const ReadMeasurement& file : state.files) {
        if (file.refusal)
            return fail(*file.refusal);
        if (file.file.recorded)
            recorded.files.push_back(*file.file.recorded);
        else
            recorded.files.push_back({QFileInfo(file.file.path).fileName().toStdString(),
                std::string(file.format->facts.name), file.sha256, *file.measurement()});
    }
    recorded.swapsDirections = state.record.swapsDirections;
    recorded.exclusions = state.record.exclusions;
    recorded.corrections.temperature = state.record.corrections.temperature;
    recorded.corrections.deadPath = state.record.corrections.deadPath;
    return recorded;
}

FileDigests fileDigests(const RecordState& record, const RecordState& after)
{
    FileDigests digests;
    for (const ReadMeasurement& file : record.files)
        digests[0].push_back(file.sha256);
    for (const ReadMeasurement& file : after.files)
        digests[1].push_back(file.sha256);
    return digests;
}

bool haveChanged(const FileDigests& now, const FileDigests& known)
{
    const auto isSame = [](const std::string& one, const std::string& before) {
        return one.empty() || one == before;
    };
    return !std::ranges::equal(now[0], known[0], isSame)
        || !std::ranges::equal(now[1], known[1], isSame);
}

bool isSameMeasurement(const RecordedMeasurement& a, const RecordedMeasurement& b)
{
    const auto isSameFile = [](const RecordedFile& one, const RecordedFile& other) {
        return one.sha256 == other.sha256 && one.measurement == other.measurement;
    };
    return a.swapsDirections == b.swapsDirections && a.exclusions == b.exclusions
        && a.corrections.temperature == b.corrections.temperature
        && a.corrections.deadPath == b.corrections.deadPath
        && std::ranges::equal(a.files, b.files, isSameFile);
}

Result<CalibrationRecord> assembled(const RecordParts& parts)
{
    if (parts.isUnchanged)
        return *parts.base;
    const auto& calibration = parts.record.record.calibration;
    CalibrationRecord made = calibration ? *calibration : *parts.base;
    if (calibration && calibration != parts.base)
        carryOver(*parts.base, made);
    AXISCOMP_TRY(auto before, measurementOf(parts.record, parts.leavesOutUnusable));
    AXISCOMP_TRY(auto after, measurementOf(parts.after, parts.leavesOutUnusable));
    RecordedDraft draft = made.draft.value_or(RecordedDraft{});
    putBefore(std::move(before), calibration != nullptr, draft, made);
    putAfter(std::move(after), parts.after.record.statedTable, draft, made);
    const bool isNeeded = draft.before || draft.after || !draft.others.empty();
    made.draft = isNeeded ? std::optional(std::move(draft)) : std::nullopt;
    AXISCOMP_CHECK(putJudging(parts.record.record, made));
    return made;
}

} // namespace axiscomp::ui
