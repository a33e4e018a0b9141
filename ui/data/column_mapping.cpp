// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/data/column_mapping.h"

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

} // namespace

std::vector<AxisInfo> infosOf(std::span<const AxisEntry> axes)
{
    std::vector<AxisInfo> infos;
    for (const AxisEntry& entry : axes)
        infos.push_back(entry.axis);
    return infos;
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
