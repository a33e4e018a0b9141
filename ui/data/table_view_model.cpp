// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/data/table_view_model.h"

#include "ui/async/background_job.h"
#include "ui/text/value_text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace axiscomp::ui {

namespace {

/// A scale needs a width, a table of zeros too.
constexpr double smallestScale = 1e-9;

double largestOf(const CompensationTable& table)
{
    const TableStatistics numbers = statistics(table);
    return std::max(-numbers.minimum, numbers.maximum);
}

} // namespace

double differenceNoise(const CompensationTable& one, const CompensationTable& other)
{
    constexpr double rounding = 2e-7; // of a float32
    return rounding * std::max(largestOf(one), largestOf(other));
}

struct TableViewModel::Private {
    Table selected;
    Table onDrive;
    TableSources sources = TableSources::Same;
    Table difference; ///< of these two, once it was wanted
    double noise = 0.0; ///< what values of the difference are without being different
    Table table;
    Table drawn;
    TableStatistics numbers; ///< of table
    ValueScale valueScale; ///< likewise
    TableContent content = TableContent::Selected;
    std::size_t cutDimension = 2;
    std::size_t cutIndex = 0;
    std::optional<GridPoint> current;
    int request = 0; ///< the newest one for a difference
};

TableViewModel::TableViewModel(QObject* parent)
    : QObject(parent)
    , d(std::make_unique<Private>()) { }

TableViewModel::~TableViewModel() = default;

void TableViewModel::setTables(Table selected, Table onDrive, TableSources sources)
{
    if (selected == d->selected && onDrive == d->onDrive && sources == d->sources)
        return;
    d->selected = std::move(selected);
    d->onDrive = std::move(onDrive);
    d->sources = sources;
    d->difference.reset();
    ++d->request;
    if (!canShow(d->content))
        d->content = TableContent::Selected;
    update();
}

bool TableViewModel::canShow(TableContent content) const
{
    switch (content) {
    case TableContent::Selected:
        return true;
    case TableContent::Drive:
        return d->onDrive != nullptr;
    case TableContent::Difference:
        return isComparable();
    }
    return false;
}

/// Whether each place in the one table is a place in the other.
bool TableViewModel::isComparable() const
{
    return d->selected && d->onDrive && d->selected != d->onDrive
        && d->sources == TableSources::Same
        && d->selected->grid.dimensions() == d->onDrive->grid.dimensions();
}

void TableViewModel::setContent(TableContent content)
{
    if (!canShow(content) || content == d->content)
        return;
    d->content = content;
    update();
}

TableContent TableViewModel::content() const
{
    return d->content;
}

void TableViewModel::update()
{
    if (d->content == TableContent::Difference && !d->difference)
        computeDifference();
    else if (d->content == TableContent::Difference)
        show(d->difference);
    else
        show(d->content == TableContent::Drive ? d->onDrive : d->selected);
}

void TableViewModel::computeDifference()
{
    using Difference = std::pair<Table, double>;
    const auto difference =
        inBackground<Difference>([selected = d->selected, onDrive = d->onDrive]() -> Difference {
            auto computed = tableDifference(*selected, *onDrive);
            if (!computed)
                return {};
            return {std::make_shared<const CompensationTable>(std::move(*computed)),
                differenceNoise(*selected, *onDrive)};
        });
    whenDone(difference, this, [this, request = ++d->request](const Difference& computed) {
        if (request != d->request || !computed.first)
            return;
        d->difference = computed.first;
        d->noise = computed.second;
        update();
    });
}

void TableViewModel::show(Table table)
{
    const bool isSameGrid = table && d->table && table->grid.axes == d->table->grid.axes;
    d->table = std::move(table);
    d->numbers = d->table ? statistics(*d->table) : TableStatistics{};
    const double largest = std::max(-d->numbers.minimum, d->numbers.maximum);
    const double noise = d->table && d->table == d->difference ? d->noise : 0.0;
    d->valueScale =
        d->table ? ValueScale(d->table->unit, largest, d->table->values, noise) : ValueScale();
    if (!isSameGrid) {
        d->current.reset();
        d->cutIndex = isCut() ? d->table->grid.axes[d->cutDimension].size / 2 : 0;
    }
    cut();
}

void TableViewModel::cut()
{
    d->drawn = isCut() ? std::make_shared<const CompensationTable>(
                   tableSlice(*d->table, d->cutDimension, d->cutIndex))
                       : d->table;
    Q_EMIT changed();
}

const TableViewModel::Table& TableViewModel::table() const
{
    return d->table;
}

const TableViewModel::Table& TableViewModel::drawn() const
{
    return d->drawn;
}

bool TableViewModel::showsDriveTable() const
{
    return d->table && d->table == d->onDrive;
}

bool TableViewModel::isAtSlice(const std::array<double, 3>& place) const
{
    const GridAxis& axis = d->table->grid.axes[d->cutDimension];
    return std::abs(place[d->cutDimension] - axis.position(d->cutIndex)) < axis.distance;
}

TableViewModel::Table TableViewModel::second() const
{
    const bool isBeside = d->content == TableContent::Selected && isComparable()
        && d->selected->grid.dimensions() == 1;
    return isBeside ? d->onDrive : nullptr;
}

double TableViewModel::scale() const
{
    return std::max({-d->numbers.minimum, d->numbers.maximum, smallestScale});
}

const ValueScale& TableViewModel::valueScale() const
{
    return d->valueScale;
}

QString TableViewModel::title() const
{
    if (!d->table)
        return {};
    QStringList parts{QString::fromStdString(d->table->name),
        withUnit(d->content == TableContent::Difference ? tr("difference") : tr("compensation"),
            d->valueScale.unit())};
    if (isCut()) {
        const GridAxis& axis = d->table->grid.axes[d->cutDimension];
        parts += dimensionName(d->table->grid, d->cutDimension) + u' '
            + positionText(axis, d->cutIndex) + unitSuffix(axis.unit);
    }
    parts.removeAll(QString());
    return listText(parts);
}

QString TableViewModel::description() const
{
    if (!d->table)
        return tr("No table");
    const ValueScale& values = d->valueScale;
    QStringList steps;
    for (const GridAxis& axis : d->table->grid.axes)
        steps += numberText(axis.distance);
    return tr("%1, step %2 · min %3, max %4, rms %5")
        .arg(gridText(d->table->grid), steps.join(QStringLiteral(" / ")),
            values.textWithUnit(d->numbers.minimum), values.textWithUnit(d->numbers.maximum),
            values.sizeWithUnit(d->numbers.rms));
}

void TableViewModel::setSlice(int dimension, int index)
{
    if (!isCut())
        return;
    const auto chosen = static_cast<std::size_t>(std::clamp(dimension, 1, 3) - 1);
    const int last = static_cast<int>(d->table->grid.axes[chosen].size) - 1;
    const auto place = static_cast<std::size_t>(std::clamp(index, 0, last));
    if (chosen == d->cutDimension && place == d->cutIndex)
        return;
    if (chosen != d->cutDimension)
        d->current.reset();
    d->cutDimension = chosen;
    d->cutIndex = place;
    cut();
}

bool TableViewModel::isCut() const
{
    return d->table && d->table->grid.dimensions() == 3;
}

int TableViewModel::sliceDimension() const
{
    return static_cast<int>(d->cutDimension) + 1;
}

int TableViewModel::sliceIndex() const
{
    return static_cast<int>(d->cutIndex);
}

std::size_t TableViewModel::dimensionOf(std::size_t drawnAxis) const
{
    return isCut() && drawnAxis >= d->cutDimension ? drawnAxis + 1 : drawnAxis;
}

QString TableViewModel::nameOf(std::size_t drawnAxis) const
{
    return dimensionName(d->table->grid, dimensionOf(drawnAxis));
}

float TableViewModel::valueAt(const GridPoint& point) const
{
    return d->drawn->values[point.i + point.j * std::size_t{d->drawn->grid.axes[0].size}];
}

QString TableViewModel::pointText(const GridPoint& point) const
{
    const std::array<std::size_t, 2> indices{point.i, point.j};
    QString text;
    for (std::size_t n = 0; n < d->drawn->grid.axes.size(); ++n) {
        const GridAxis& axis = d->drawn->grid.axes[n];
        text += nameOf(n) + u' ' + positionText(axis, indices[n]) + unitSuffix(axis.unit)
            + QStringLiteral(", ");
    }
    return text + d->valueScale.textWithUnit(static_cast<double>(valueAt(point)));
}

void TableViewModel::setCurrent(const std::optional<GridPoint>& point)
{
    const auto isInside = [this](const GridPoint& p) {
        const auto& axes = d->drawn->grid.axes;
        return p.i < axes[0].size && p.j < (axes.size() > 1 ? axes[1].size : 1);
    };
    const auto now = point && d->drawn && isInside(*point) ? point : std::nullopt;
    if (now == d->current)
        return;
    d->current = now;
    Q_EMIT currentChanged();
}

const std::optional<GridPoint>& TableViewModel::current() const
{
    return d->current;
}

} // namespace axiscomp::ui
