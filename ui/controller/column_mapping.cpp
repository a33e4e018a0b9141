// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controller/column_mapping.h"

#include "ui/session/axis_list.h"

#include <QCoreApplication>

#include <algorithm>
#include <set>

namespace axiscomp::ui {

namespace {

class Assignment {
    Q_DECLARE_TR_FUNCTIONS(axiscomp::ui::ColumnMapping)

public:
    [[nodiscard]] static QString nothingChosen() { return tr("Select at least one axis."); }
    [[nodiscard]] static QString chosenTwice(const QString& axis)
    {
        return tr("%1 is selected twice; an axis has only one table.").arg(axis);
    }
    [[nodiscard]] static QString unnamed(int axis) { return tr("Axis %1").arg(axis); }
};

QString comparable(const std::string& name)
{
    return QString::fromStdString(name).simplified().toCaseFolded();
}

/// The one axis with that name.
AxisChoice axisCalled(std::span<const AxisEntry> axes, const QString& name)
{
    AxisChoice found;
    for (const AxisEntry& entry : axes) {
        if (name.isEmpty() || comparable(entry.axis.name) != name)
            continue;
        if (found)
            return {};
        found = entry.axis.index;
    }
    return found;
}

} // namespace

std::vector<AxisChoice> proposedAxes(
    std::span<const CompensationTable> tables, std::span<const AxisEntry> axes)
{
    std::vector<AxisChoice> choices(tables.size());
    std::set<int> taken;
    const auto propose = [&](std::size_t n, const QString& name) {
        const AxisChoice axis = axisCalled(axes, name);
        if (!choices[n] && axis && taken.insert(*axis).second)
            choices[n] = axis;
    };
    for (std::size_t n = 0; n < tables.size(); ++n)
        propose(n, comparable(tables[n].name));
    const QString addition = QStringLiteral(" error");
    for (std::size_t n = 0; n < tables.size(); ++n) {
        const QString name = comparable(tables[n].name);
        if (name.endsWith(addition))
            propose(n, name.chopped(addition.size()));
    }
    return choices;
}

QString assignmentObstacle(std::span<const AxisChoice> choices, std::span<const AxisEntry> axes)
{
    std::set<int> chosen;
    for (const AxisChoice& axis : choices) {
        if (axis && !chosen.insert(*axis).second)
            return Assignment::chosenTwice(axisNameAmong(axes, *axis));
    }
    return chosen.empty() ? Assignment::nothingChosen() : QString();
}

QString axisNameAmong(std::span<const AxisEntry> axes, int axis)
{
    const auto entry = std::ranges::find_if(
        axes, [axis](const AxisEntry& candidate) { return candidate.axis.index == axis; });
    return entry == axes.end() ? Assignment::unnamed(axis) : axisNameOnDrive(*entry);
}

} // namespace axiscomp::ui
