// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/comparison_model.h"

#include "ui/record/record_assembly.h"
#include "ui/record/record_model.h"

#include <algorithm>
#include <iterator>

namespace axiscomp::ui {

namespace {

/// What a comparison is made of.
struct Sides {
    std::shared_ptr<const CalibrationRecord> calibration; ///< null: no table is used
    std::shared_ptr<const Measurement> before; ///< without a table
    CorrectionsBefore corrections; ///< of before
    RecordState after;
    std::vector<Tolerance> tolerances;
    std::optional<double> uncertainty;
};

ComparisonRequest requestOf(const Sides& sides)
{
    ComparisonRequest request;
    if (sides.calibration)
        request = comparisonRequest(*sides.calibration);
    const auto& stated = sides.after.record.statedTable;
    request.isTableStated = stated && stated == request.tableCrc;
    request.tolerances = sides.tolerances;
    request.uncertainty = sides.uncertainty;
    return request;
}

/// That of the table, as the table was made of it.
Result<std::shared_ptr<const Measurement>> firstOf(const Sides& sides)
{
    if (!sides.calibration || !sides.calibration->before)
        return sides.before;
    AXISCOMP_TRY(auto used, usedMeasurement(*sides.calibration->before));
    return std::make_shared<const Measurement>(std::move(used));
}

TwoDatums datumsOf(const Sides& sides, const Comparison& comparison)
{
    const bool isOnRecord = sides.calibration && sides.calibration->before;
    const auto& first = isOnRecord ? sides.calibration->before->corrections.temperature
                                   : sides.corrections.temperature;
    return deviationDatums({comparison.before, statedDatum(first)},
        {comparison.after, statedDatum(sides.after.record.corrections.temperature)});
}

FineUnit unitOf(const Comparison& comparison, const TwoDatums& datums, bool isAngular)
{
    std::vector<std::optional<double>> shown;
    for (const Iso230Figures* one : {&comparison.before, &comparison.after})
        std::ranges::copy(figureValues(*one).values, std::back_inserter(shown));
    for (const auto* all : {&comparison.beforeOfAllValues, &comparison.afterOfAllValues})
        if (*all)
            std::ranges::copy(figureValues(**all).values, std::back_inserter(shown));
    for (const RemainingError& error : comparison.errorBefore)
        shown.emplace_back(fromDatum(error.value, datums.before));
    for (const RemainingError& error : comparison.residual)
        shown.emplace_back(fromDatum(error.value, datums.after));
    return fineUnit(shown, isAngular);
}

CorrectedAlike correctedAlike(const Sides& sides, const Measurement& before)
{
    bool isForDeadPath = sides.corrections.deadPath.has_value();
    if (sides.calibration && sides.calibration->before)
        isForDeadPath = sides.calibration->before->corrections.deadPath.has_value();
    const CorrectedSide after{
        *sides.after.measurement, sides.after.record.corrections.deadPath.has_value()};
    return areCorrectedAlike({before, isForDeadPath}, after);
}

/// They differ by the temperature, not by what the compensation has done.
Error lacksCorrection()
{
    return {ErrorCode::InvalidArgument,
        {{"reason",
            AXISCOMP_TEXT("Error",
                "the first measurement is corrected and the second is not, so that they cannot be "
                "compared: save the record and correct the second one with `axiscomp compare "
                "--record`, or state in its file that its values are at 20 °C (// corrected: "
                "20C)")}},
        {}};
}

bool isKept(const Sides& sides)
{
    if (!sides.calibration || sides.calibration->after.empty())
        return false;
    const auto recorded = recordedMeasurement(sides.after);
    return recorded
        && std::ranges::any_of(sides.calibration->after, [&](const RecordedAfter& kept) {
               return isSameMeasurement(kept.measurement, *recorded);
           });
}

ComparisonState compared(const Sides& sides, const std::stop_token& stop)
{
    ComparisonState state;
    const ComparisonRequest request = requestOf(sides);
    state.tableCrc = request.tableCrc;
    const auto& after = sides.after.measurement;
    if (!after)
        return state;
    state.isAngular = after->isAngular;
    state.date = after->header.date;
    state.needsStatement = needsStatement(*after, request);
    const auto before = firstOf(sides);
    if (!before || stop.stop_requested()) {
        if (!before)
            state.refusal = before.error();
        return state;
    }
    if (!*before)
        return state;
    const CorrectedAlike alike = correctedAlike(sides, **before);
    if (alike == CorrectedAlike::AfterIsNot) {
        state.refusal = lacksCorrection();
        return state;
    }
    auto comparison = compareMeasurements(**before, *after, request);
    if (!comparison) {
        state.refusal = comparison.error();
        return state;
    }
    state.datums = datumsOf(sides, *comparison);
    state.unit = unitOf(*comparison, state.datums, after->isAngular);
    state.comparison = std::make_shared<const Comparison>(std::move(*comparison));
    state.isKept = isKept(sides);
    state.isCorrectedOtherwise = alike != CorrectedAlike::Yes;
    return state;
}

} // namespace

ComparisonModel::ComparisonModel(RecordModel& record, const RecordModel& after, QObject* parent)
    : QObject(parent)
    , m_record(record)
    , m_after(after)
    , m_job([this](const ComparisonState& state) { take(state); })
{
    for (const RecordModel* model : {static_cast<const RecordModel*>(&record), &after})
        connect(model, &RecordModel::stateChanged, this, &ComparisonModel::follow);
    // Notes of what was written change no state.
    connect(&record, &RecordModel::changed, this, &ComparisonModel::follow);
}

void ComparisonModel::follow()
{
    m_job.cancel();
    m_isComparing = true;
    if (m_after.isEvaluating() || m_record.isEvaluating()) {
        Q_EMIT changed();
        return;
    }
    const Record& record = m_record.record();
    Sides sides{record.calibration, m_record.state().measurement, record.corrections,
        m_after.state(), {}, {}};
    // A limit of 10 um is none of an angle.
    const auto& after = m_after.state().measurement;
    if (after && after->isAngular == record.areLimitsAngles) {
        sides.tolerances = record.tolerances;
        sides.uncertainty = record.uncertainty;
    }
    sides.after.record = m_after.record();
    m_job.start(
        [sides = std::move(sides)](const std::stop_token& stop) { return compared(sides, stop); });
    Q_EMIT changed();
}

void ComparisonModel::take(const ComparisonState& state)
{
    m_state = state;
    m_isComparing = false;
    Q_EMIT changed();
}

bool ComparisonModel::mayKeep() const
{
    return m_record.record().calibration && m_state.comparison && !m_state.isKept && !m_isComparing
        && !m_isKeeping;
}

void ComparisonModel::keep()
{
    if (!mayKeep())
        return;
    m_isKeeping = true;
    Q_EMIT changed();
    using Kept = std::shared_ptr<const CalibrationRecord>;
    const auto calibration = m_record.record().calibration;
    const auto kept = inBackground<Kept>(
        [calibration, after = m_after.state(), comparison = m_state.comparison]() -> Kept {
            auto recorded = recordedMeasurement(after);
            if (!recorded)
                return nullptr;
            auto record = std::make_shared<CalibrationRecord>(*calibration);
            keepAfter(*record, *std::move(recorded), *comparison);
            return record;
        });
    whenDone(kept, this, [this, calibration](const Kept& record) {
        m_isKeeping = false;
        // Another table may be in use by now: nothing was measured with that one.
        if (record && m_record.record().calibration == calibration)
            m_record.setCalibration(record);
        Q_EMIT changed();
    });
}

} // namespace axiscomp::ui
