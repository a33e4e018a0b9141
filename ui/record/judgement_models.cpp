// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/judgement_models.h"

#include "ui/record/record_model.h"
#include "ui/text/fine_scale.h"
#include "ui/text/message_text.h"
#include "ui/text/translated_text.h"
#include "ui/text/value_text.h"

#include <algorithm>

namespace axiscomp::ui {

namespace {

QString noFigure()
{
    return QStringLiteral("–");
}

QString shownOrNothing(const FineUnit& unit, const std::optional<double>& value)
{
    return value ? FineScale(unit).text(*value) : noFigure();
}

QString alone(const std::optional<double>& value, bool isAngular)
{
    return value ? fineText(*value, isAngular) : noFigure();
}

QString positionUnitSymbol(bool isAngular)
{
    return isAngular ? QStringLiteral("°") : QStringLiteral("mm");
}

QString inUnit(const QString& name, const FineUnit& unit)
{
    return withUnit(name, unit.symbol);
}

Iso230Figure figureOfRow(int row)
{
    return shownIso230Figures()[static_cast<std::size_t>(row)];
}

/// Of the figures that are read side by side.
FineUnit unitOfFigures(const RecordState& state)
{
    const auto used = figureValues(state.judgement->figures).values;
    std::vector<std::optional<double>> shown(used.begin(), used.end());
    if (const auto& all = state.judgement->ofAllValues) {
        const auto values = figureValues(*all).values;
        shown.insert(shown.end(), values.begin(), values.end());
    }
    return fineUnit(shown, state.measurement->isAngular);
}

Tone toneOf(VerdictResult result)
{
    switch (result) {
    case VerdictResult::Passed:
        return Tone::Success;
    case VerdictResult::Failed:
        return Tone::Error;
    case VerdictResult::Undecided:
    case VerdictResult::NotDefined:
        break;
    }
    return Tone::Warning;
}

QString arrowOf(Approach direction)
{
    return direction == Approach::Up ? QStringLiteral("↑") : QStringLiteral("↓");
}

/// "↑ up": the arrow of the plot, and the word of the standard.
QString directionText(Approach direction)
{
    return arrowOf(direction) + u' ' + translated(approachText(direction));
}

} // namespace

// FiguresModel

FiguresModel::FiguresModel(const RecordModel& record, QObject* parent)
    : JudgementTableModel(record, parent)
{
    follow();
}

int FiguresModel::rows() const
{
    constexpr int vdiRows = 6;
    return static_cast<int>(iso230FigureCount) + (state().judgement->vdi ? vdiRows : 0);
}

int FiguresModel::columns() const
{
    return state().judgement->ofAllValues ? 7 : 6;
}

FiguresModel::Cell FiguresModel::cellOf(int column) const
{
    // Verdicts are about the values in use: they stand beside these.
    static constexpr std::array cells{Cell::Symbol, Cell::Meaning, Cell::Value, Cell::Tolerance,
        Cell::Verdict, Cell::OfAll, Cell::Places};
    const auto index = static_cast<std::size_t>(column);
    return index == 5 && !state().judgement->ofAllValues ? Cell::Places : cells.at(index);
}

QString FiguresModel::heading(int column) const
{
    const FineUnit unit = unitOfFigures(state());
    switch (cellOf(column)) {
    case Cell::Symbol:
        return tr("Figure");
    case Cell::Meaning:
        return tr("Meaning");
    case Cell::Value:
        return inUnit(state().judgement->ofAllValues ? tr("Without excluded") : tr("Value"), unit);
    case Cell::OfAll:
        return inUnit(tr("All values"), unit);
    case Cell::Tolerance:
        return inUnit(tr("Tolerance"), unit);
    case Cell::Verdict:
        return tr("Verdict");
    case Cell::Places:
        break;
    }
    return withUnit(
        tr("At target"), positionUnitSymbol(state().measurement->isAngular).toStdString());
}

const Verdict* FiguresModel::verdictOf(int row) const
{
    if (row >= static_cast<int>(iso230FigureCount))
        return nullptr;
    const auto& verdicts = state().judgement->verdicts;
    const auto found = std::ranges::find(verdicts, figureOfRow(row),
        [](const Verdict& verdict) { return verdict.tolerance.figure; });
    return found == verdicts.end() ? nullptr : &*found;
}

QString FiguresModel::text(int row, int column) const
{
    const Cell cell = cellOf(column);
    if (row >= static_cast<int>(iso230FigureCount))
        return vdiText(row - static_cast<int>(iso230FigureCount), cell);
    const Iso230Figure figure = figureOfRow(row);
    const Judgement& judgement = *state().judgement;
    const FineUnit unit = unitOfFigures(state());
    const Verdict* verdict = verdictOf(row);
    switch (cell) {
    case Cell::Symbol:
        return qString(figureSymbol(figure));
    case Cell::Meaning:
        return translated(figureText(figure));
    case Cell::Value:
        return judgement.figures[figure].value
            ? shownOrNothing(unit, judgement.figures[figure].value)
            : tr("not defined");
    case Cell::OfAll:
        return shownOrNothing(unit, (*judgement.ofAllValues)[figure].value);
    case Cell::Tolerance:
        return verdict ? FineScale(unit).text(verdict->tolerance.value) : noFigure();
    case Cell::Verdict:
        if (!verdict)
            return noFigure();
        return translated(verdictText(verdict->result)) + QStringLiteral(", ")
            + (verdict->uncertainty ? QStringLiteral("U ")
                        + alone(verdict->uncertainty, state().measurement->isAngular)
                                    : tr("uncertainty not stated"));
    case Cell::Places:
        break;
    }
    QStringList places;
    for (const double place : placesOf(judgement.figures, figure))
        places += numberText(place);
    return places.join(tr(" and ", "two positions"));
}

/// An assumption: the text of the guideline was not at hand.
QString FiguresModel::vdiText(int row, Cell cell) const
{
    const Vdi3441Figures& vdi = *state().judgement->vdi;
    const std::array<std::pair<QString, double>, 6> lines{
        {{QStringLiteral("P"), vdi.p}, {QStringLiteral("Pa"), vdi.pa}, {tr("U largest"), vdi.uMax},
            {tr("U mean"), vdi.uMean}, {tr("Ps largest"), vdi.psMax}, {tr("Ps mean"), vdi.psMean}}};
    const auto& [symbol, value] = lines.at(static_cast<std::size_t>(row));
    if (cell == Cell::Symbol)
        return symbol;
    if (cell == Cell::Meaning)
        return tr("VDI/DGQ 3441 (assumption)");
    if (cell == Cell::Value)
        return FineScale(unitOfFigures(state())).text(value);
    return cell == Cell::Places ? QString() : noFigure();
}

bool FiguresModel::isNumber(int column) const
{
    const Cell cell = cellOf(column);
    return cell == Cell::Value || cell == Cell::OfAll || cell == Cell::Tolerance;
}

std::optional<Tone> FiguresModel::tone(int row, int column) const
{
    const Verdict* verdict = cellOf(column) == Cell::Verdict ? verdictOf(row) : nullptr;
    return verdict ? std::optional(toneOf(verdict->result)) : std::nullopt;
}

// TargetFiguresModel

TargetFiguresModel::TargetFiguresModel(const RecordModel& record, QObject* parent)
    : JudgementTableModel(record, parent)
{
    follow();
}

const JudgedValues& TargetFiguresModel::shown() const
{
    return m_showsAll ? state().all : state().used;
}

void TargetFiguresModel::setShowsAll(bool showsAll)
{
    m_showsAll = showsAll;
    follow();
}

int TargetFiguresModel::rows() const
{
    return static_cast<int>(shown().series.figures->targets.size());
}

int TargetFiguresModel::columns() const
{
    return 11;
}

QString TargetFiguresModel::heading(int column) const
{
    const FineUnit& unit = shown().unit;
    switch (column) {
    case 0:
        return tr("Number");
    case 1:
        return withUnit(
            tr("Target"), positionUnitSymbol(state().measurement->isAngular).toStdString());
    case 2:
        return tr("Values ↑");
    case 3:
        return inUnit(tr("Mean ↑"), unit);
    case 4:
        return inUnit(QStringLiteral("s ↑"), unit);
    case 5:
        return tr("Values ↓");
    case 6:
        return inUnit(tr("Mean ↓"), unit);
    case 7:
        return inUnit(QStringLiteral("s ↓"), unit);
    case 8:
        return inUnit(tr("Mean"), unit);
    case 9:
        return inUnit(QStringLiteral("B"), unit);
    default:
        return inUnit(QStringLiteral("R"), unit);
    }
}

QString TargetFiguresModel::text(int row, int column) const
{
    const TargetFigures& target = shown().series.figures->targets[static_cast<std::size_t>(row)];
    const FineUnit& unit = shown().unit;
    switch (column) {
    case 0:
        return countText(target.target + 1);
    case 1:
        return numberText(target.position);
    case 2:
        return countText(target.up.n);
    case 3:
        return shownOrNothing(unit, target.up.mean);
    case 4:
        return shownOrNothing(unit, target.up.s);
    case 5:
        return countText(target.down.n);
    case 6:
        return shownOrNothing(unit, target.down.mean);
    case 7:
        return shownOrNothing(unit, target.down.s);
    case 8:
        return shownOrNothing(unit, target.mean);
    case 9:
        return shownOrNothing(unit, target.reversal);
    default:
        return shownOrNothing(unit, target.repeatability);
    }
}

bool TargetFiguresModel::isNumber(int) const
{
    return true;
}

std::optional<Exclusion> TargetFiguresModel::valuesOf(int row) const
{
    const auto& targets = shown().series.figures->targets;
    return Exclusion{{}, targets[static_cast<std::size_t>(row)].target + 1, {}};
}

int TargetFiguresModel::rowOf(const Exclusion& values) const
{
    if (!values.target || !state().judgement)
        return -1;
    const auto& targets = shown().series.figures->targets;
    const auto found =
        std::ranges::lower_bound(targets, *values.target - 1, {}, &TargetFigures::target);
    return found != targets.end() && found->target == *values.target - 1
        ? static_cast<int>(found - targets.begin())
        : -1;
}

// RunDriftModel

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
        return inUnit(tr("Offset"), state().offsetUnit);
    default:
        return inUnit(tr("Slope"), slopeUnit(state().measurement->isAngular));
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

// DriftModel

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
    if (row >= 6)
        return column < 3
            ? QString()
            : alone((*judgement.withoutOffsets)[row == 6 ? Iso230Figure::A : Iso230Figure::R].value,
                isAngular);
    if (column == 3)
        return {};
    const DirectionDrift& drift = column == 1 ? judgement.driftUp : judgement.driftDown;
    if (row == 5)
        return !drift.firstToLast ? noFigure()
            : drift.isSuspected   ? tr("suspected")
                                  : tr("not suspected");
    const std::array values{&drift.firstToLast, &drift.trendPerRun, &drift.trendPerHour,
        &drift.trendPerKelvin, &drift.sWithoutOffsets};
    return alone(*values.at(static_cast<std::size_t>(row)), isAngular);
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

// ConditionsModel

ConditionsModel::ConditionsModel(const RecordModel& record, QObject* parent)
    : JudgementTableModel(record, parent)
{
    follow();
}

int ConditionsModel::rows() const
{
    return static_cast<int>(state().judgement->compliance.size());
}

int ConditionsModel::columns() const
{
    return 2;
}

QString ConditionsModel::heading(int column) const
{
    return column == 0 ? tr("Condition of ISO 230-2") : tr("Met?");
}

QString ConditionsModel::text(int row, int column) const
{
    const ComplianceLine& line = state().judgement->compliance[static_cast<std::size_t>(row)];
    if (column == 1)
        return translated(complianceText(line.isMet));
    const QString condition = translated(line.text);
    return line.isAssumed ? tr("%1 (assumption)").arg(condition) : condition;
}

bool ConditionsModel::isNumber(int) const
{
    return false;
}

std::optional<Tone> ConditionsModel::tone(int row, int column) const
{
    if (column != 1)
        return std::nullopt;
    const auto& isMet = state().judgement->compliance[static_cast<std::size_t>(row)].isMet;
    return !isMet ? Tone::Information : *isMet ? Tone::Success : Tone::Warning;
}

// JudgeWarningsModel

JudgeWarningsModel::JudgeWarningsModel(const RecordModel& record, QObject* parent)
    : JudgementTableModel(record, parent)
{
    follow();
}

int JudgeWarningsModel::rows() const
{
    return static_cast<int>(state().judgement->warnings.size());
}

int JudgeWarningsModel::columns() const
{
    return 1;
}

QString JudgeWarningsModel::heading(int) const
{
    return tr("Warning");
}

QString JudgeWarningsModel::text(int row, int) const
{
    return sentenceText(state().judgement->warnings[static_cast<std::size_t>(row)].text);
}

bool JudgeWarningsModel::isNumber(int) const
{
    return false;
}

std::optional<Tone> JudgeWarningsModel::tone(int, int) const
{
    return Tone::Warning;
}

// OutliersModel

OutliersModel::OutliersModel(const RecordModel& record, QObject* parent)
    : JudgementTableModel(record, parent)
{
    follow();
}

int OutliersModel::proposedCount() const
{
    const Outliers& outliers = state().judgement->outliers;
    return static_cast<int>(outliers.up.flagged.size() + outliers.down.flagged.size());
}

int OutliersModel::rows() const
{
    return proposedCount() + static_cast<int>(state().record.exclusions.size());
}

int OutliersModel::columns() const
{
    return 5;
}

const Outlier* OutliersModel::outlierOf(int row) const
{
    const Outliers& outliers = state().judgement->outliers;
    const auto index = static_cast<std::size_t>(row);
    const std::size_t ups = outliers.up.flagged.size();
    if (index < ups)
        return &outliers.up.flagged[index];
    return row < proposedCount() ? &outliers.down.flagged[index - ups] : nullptr;
}

QString OutliersModel::heading(int column) const
{
    switch (column) {
    case 0:
        return tr("Direction");
    case 1:
        return withUnit(
            tr("Target"), positionUnitSymbol(state().measurement->isAngular).toStdString());
    case 2:
        return tr("Run");
    case 3:
        return tr("Score");
    default:
        return tr("State");
    }
}

QString OutliersModel::text(int row, int column) const
{
    const Outlier* outlier = outlierOf(row);
    const auto values = *valuesOf(row);
    switch (column) {
    case 0:
        return values.direction ? directionText(*values.direction) : tr("both");
    case 1:
        return values.target ? numberText(state().measurement->targets.at(*values.target - 1))
                             : tr("all");
    case 2:
        return values.run ? QString::number(*values.run) : tr("all");
    case 3: {
        constexpr int decimals = 2;
        return outlier ? QLocale().toString(outlier->score, 'f', decimals) : noFigure();
    }
    default:
        return outlier ? tr("proposed") : tr("excluded");
    }
}

bool OutliersModel::isNumber(int column) const
{
    return column > 0 && column < 4;
}

std::optional<Tone> OutliersModel::tone(int row, int column) const
{
    if (column != 4)
        return std::nullopt;
    return outlierOf(row) ? Tone::Warning : Tone::Information;
}

std::optional<Exclusion> OutliersModel::valuesOf(int row) const
{
    if (const Outlier* outlier = outlierOf(row))
        return exclusionOf(*outlier);
    return state().record.exclusions.at(static_cast<std::size_t>(row - proposedCount()));
}

int OutliersModel::rowOf(const Exclusion& values) const
{
    if (!state().judgement)
        return -1;
    for (int row = 0; row < rows(); ++row)
        if (*valuesOf(row) == values)
            return row;
    return -1;
}

} // namespace axiscomp::ui
