// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/outliers_model.h"

#include "ui/record/judgement_cells.h"
#include "ui/record/record_model.h"
#include "ui/text/value_text.h"

#include <QLocale>

namespace axiscomp::ui {

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
        return withUnit(tr("Target"), state().measurement->isAngular ? "°" : "mm");
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
