// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/figures_models.h"

#include "ui/record/judgement_cells.h"
#include "ui/record/record_model.h"
#include "ui/text/fine_scale.h"
#include "ui/text/translated_text.h"
#include "ui/text/value_text.h"

#include <algorithm>
#include <array>

namespace axiscomp::ui {

namespace {

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

} // namespace

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
        return withUnit(
            state().judgement->ofAllValues ? tr("Without excluded") : tr("Value"), unit.symbol);
    case Cell::OfAll:
        return withUnit(tr("All values"), unit.symbol);
    case Cell::Tolerance:
        return withUnit(tr("Tolerance"), unit.symbol);
    case Cell::Verdict:
        return tr("Verdict");
    case Cell::Places:
        break;
    }
    return withUnit(tr("At target"), state().measurement->isAngular ? "°" : "mm");
}

const Verdict* FiguresModel::verdictOf(int row) const
{
    if (row >= static_cast<int>(iso230FigureCount))
        return nullptr;
    return axiscomp::verdictOf(state().judgement->verdicts, figureOfRow(row));
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
    const auto shown = [&](const std::optional<double>& value) {
        return shownOrNothing(unit, value,
            verdictDecimals({verdict, axiscomp::verdictOf(judgement.verdictsOfAllValues, figure)},
                unit, FineScale::usualDecimals));
    };
    switch (cell) {
    case Cell::Symbol:
        return qString(figureSymbol(figure));
    case Cell::Meaning:
        return translated(figureText(figure));
    case Cell::Value:
        return judgement.figures[figure].value ? shown(judgement.figures[figure].value)
                                               : tr("not defined");
    case Cell::OfAll:
        return shown((*judgement.ofAllValues)[figure].value);
    case Cell::Tolerance:
        return verdict ? shown(verdict->tolerance.value) : noFigure();
    case Cell::Verdict:
        if (!verdict)
            return noFigure();
        return translated(verdictText(verdict->result)) + QStringLiteral(", ")
            + (verdict->uncertainty ? QStringLiteral("U ")
                        + aloneOrNothing(verdict->uncertainty, state().measurement->isAngular)
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
        return withUnit(tr("Target"), state().measurement->isAngular ? "°" : "mm");
    case 2:
        return tr("Values ↑");
    case 3:
        return withUnit(tr("Mean ↑"), unit.symbol);
    case 4:
        return withUnit(QStringLiteral("s ↑"), unit.symbol);
    case 5:
        return tr("Values ↓");
    case 6:
        return withUnit(tr("Mean ↓"), unit.symbol);
    case 7:
        return withUnit(QStringLiteral("s ↓"), unit.symbol);
    case 8:
        return withUnit(tr("Mean"), unit.symbol);
    case 9:
        return withUnit(QStringLiteral("B"), unit.symbol);
    default:
        return withUnit(QStringLiteral("R"), unit.symbol);
    }
}

QString TargetFiguresModel::text(int row, int column) const
{
    const DeviationSeries& series = shown().series;
    const TargetFigures& target = series.figures->targets[static_cast<std::size_t>(row)];
    const FineUnit& unit = shown().unit;
    switch (column) {
    case 0:
        return countText(target.target + 1);
    case 1:
        return numberText(target.position);
    case 2:
        return countText(target.up.n);
    case 3:
        return shownOrNothing(unit, series.shown(target.up.mean));
    case 4:
        return shownOrNothing(unit, target.up.s);
    case 5:
        return countText(target.down.n);
    case 6:
        return shownOrNothing(unit, series.shown(target.down.mean));
    case 7:
        return shownOrNothing(unit, target.down.s);
    case 8:
        return shownOrNothing(unit, series.shown(target.mean));
    case 9:
        return shownOrNothing(unit, target.reversal);
    default:
        return shownOrNothing(unit, target.repeatability);
    }
}

/// What is 0 among the means.
QVariant TargetFiguresModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    const bool isOfMean = section == 3 || section == 6 || section == 8;
    if (orientation == Qt::Horizontal && role == Qt::ToolTipRole && isOfMean && state().judgement)
        if (const auto& datum = shown().series.curves->datum)
            return translated(datumText(*datum, state().measurement->isAngular));
    return JudgementTableModel::headerData(section, orientation, role);
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

} // namespace axiscomp::ui
