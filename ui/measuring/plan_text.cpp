// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/measuring/plan_text.h"

#include "ui/text/value_text.h"

#include <QCoreApplication>
#include <QLocale>

namespace axiscomp::ui {

QString planPositionText(double position)
{
    return qString(planPosition(position)).replace(u'.', QLocale().decimalPoint());
}

QString planPositionText(double position, bool isAngular)
{
    return planPositionText(position) + unitSuffix(isAngular ? "°" : "mm");
}

QString planSummaryText(const MeasuringPlan& plan)
{
    return QCoreApplication::translate("PlanText", "Axis %1: %2 targets, %3 values")
        .arg(qString(plan.axis), countText(targetsOf(plan).size()), countText(plan.steps.size()));
}

} // namespace axiscomp::ui
