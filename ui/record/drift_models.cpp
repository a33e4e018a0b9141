// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/drift_models.h"

#include "ui/record/judgement_cells.h"
#include "ui/record/record_model.h"
#include "ui/text/fine_scale.h"
#include "ui/text/value_text.h"

#include <algorithm>
#include <array>

namespace axiscomp::ui {

RunDriftModel::RunDriftModel(const RecordModel& record, QObject* parent)
    : JudgementTableModel(record, parent)
{
    follow();
}

namespace {

/// A run of one direction by its row: those up first.
struct RunRow {
    Approach direction;
    const DirectionDrift& drift;
    std::size_t index;
};

RunRow runRow(const Judgement& judgement, int row)
{
    const auto index = static_cast<std::size_t>(row);
    const std::size_t ups = judgement.driftUp.runs.size();
    return index < ups ? RunRow{Approach::Up, judgement.driftUp, index}
                       : RunRow{Approach::Down, judgement.driftDown, index - ups};
}

} // namespace

int RunDriftModel::rows() const
{
    return static_cast<int>(
        state().judgement->driftUp.runs.size() + state().judgement->driftDown.runs.size());
}

int RunDriftModel::columns() const
{
    return 4;
}

QString RunDriftModel::heading(int column) const
{
    switch (column) {
    case 0:
        return tr("Direction");
    case 1:
        return tr("Run");
    case 2:
        return withUnit(tr("Offset"), state().offsetUnit.symbol);
    default:
        return withUnit(tr("Slope"), slopeUnit(state().measurement->isAngular).symbol);
    }
}

QString RunDriftModel::text(int row, int column) const
{
    const RunRow run = runRow(*state().judgement, row);
    switch (column) {
    case 0:
        return directionText(run.direction);
    case 1:
        return QString::number(run.drift.runs[run.index]);
    case 2:
        return FineScale(state().offsetUnit).text(run.drift.offset[run.index]);
    default:
        return FineScale(slopeUnit(state().measurement->isAngular))
            .text(run.drift.slope[run.index]);
    }
}

bool RunDriftModel::isNumber(int column) const
{
    return column > 0;
}

std::optional<Exclusion> RunDriftModel::valuesOf(int row) const
{
    const RunRow run = runRow(*state().judgement, row);
    return Exclusion{run.direction, {}, run.drift.runs[run.index]};
}

int RunDriftModel::rowOf(const Exclusion& values) const
{
    if (!values.direction || !values.run || !state().judgement)
        return -1;
    const Judgement& judgement = *state().judgement;
    const bool isUp = *values.direction == Approach::Up;
    const auto& runs = isUp ? judgement.driftUp.runs : judgement.driftDown.runs;
    const auto found = std::ranges::lower_bound(runs, *values.run);
    if (found == runs.end() || *found != *values.run)
        return -1;
    return static_cast<int>(found - runs.begin())
        + (isUp ? 0 : static_cast<int>(judgement.driftUp.runs.size()));
}

DriftModel::DriftModel(const RecordModel& record, QObject* parent)
    : JudgementTableModel(record, parent)
{
    follow();
}

int DriftModel::rows() const
{
    constexpr int statements = 6;
    constexpr int withoutOffsets = 2;
    return statements + (state().judgement->withoutOffsets ? withoutOffsets : 0);
}

int DriftModel::columns() const
{
    return 4;
}

QString DriftModel::heading(int column) const
{
    switch (column) {
    case 0:
        return tr("Drift of the runs");
    case 1:
        return tr("Runs ↑");
    case 2:
        return tr("Runs ↓");
    default:
        return tr("Both");
    }
}

QString DriftModel::text(int row, int column) const
{
    const Judgement& judgement = *state().judgement;
    const bool isAngular = state().measurement->isAngular;
    static const std::array names{QT_TR_NOOP("From the first to the last run"),
        QT_TR_NOOP("From run to run"), QT_TR_NOOP("Per hour"), QT_TR_NOOP("Per kelvin"),
        QT_TR_NOOP("s without the offsets of the runs"), QT_TR_NOOP("Drift"),
        QT_TR_NOOP("A without the offsets of the runs"),
        QT_TR_NOOP("R without the offsets of the runs")};
    if (column == 0)
        return tr(names.at(static_cast<std::size_t>(row)));
    if (row >= 6) {
        static constexpr std::array accuracy{
            Iso230Figure::AUp, Iso230Figure::ADown, Iso230Figure::A};
        static constexpr std::array repeatability{
            Iso230Figure::RUp, Iso230Figure::RDown, Iso230Figure::R};
        const auto& figures = row == 6 ? accuracy : repeatability;
        const Iso230Figure figure = figures.at(static_cast<std::size_t>(column) - 1);
        return aloneOrNothing((*judgement.withoutOffsets)[figure].value, isAngular);
    }
    if (column == 3)
        return {};
    const DirectionDrift& drift = column == 1 ? judgement.driftUp : judgement.driftDown;
    if (row == 5)
        return !drift.firstToLast ? noFigure()
            : drift.isSuspected   ? tr("suspected")
                                  : tr("not suspected");
    const std::array values{&drift.firstToLast, &drift.trendPerRun, &drift.trendPerHour,
        &drift.trendPerKelvin, &drift.sWithoutOffsets};
    return aloneOrNothing(*values.at(static_cast<std::size_t>(row)), isAngular);
}

bool DriftModel::isNumber(int column) const
{
    return column > 0;
}

std::optional<Tone> DriftModel::tone(int row, int column) const
{
    if (row != 5 || column < 1 || column > 2)
        return std::nullopt;
    const Judgement& judgement = *state().judgement;
    const DirectionDrift& drift = column == 1 ? judgement.driftUp : judgement.driftDown;
    if (!drift.firstToLast)
        return std::nullopt;
    return drift.isSuspected ? Tone::Warning : Tone::Success;
}

} // namespace axiscomp::ui
