// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/outcome/foreign_change.h"

#include "ui/text/value_text.h"

#include <QCoreApplication>
#include <QStringList>

namespace axiscomp::ui {

namespace {

QString text(const char* source)
{
    return QCoreApplication::translate("axiscomp::ui::ForeignChange", source);
}

bool isWorking(const AxisStatus& status)
{
    return status.isOn() || status.axis.state == CompensationState::Evaluating;
}

/// A drive that restarts forgets where its axes are.
bool hasRestarted(const AxisStatus& before, const AxisStatus& now)
{
    return before.axis.isHomed && !now.axis.isHomed;
}

QString stateChange(const AxisStatus& before, const AxisStatus& now)
{
    const bool isOff = isWorking(before) && !isWorking(now);
    if (hasRestarted(before, now))
        return isOff
            ? text(QT_TRANSLATE_NOOP("axiscomp::ui::ForeignChange",
                "The axis has lost its homing, as after a restart of the drive: the compensation "
                "is off. Home the axis and activate again."))
            : text(QT_TRANSLATE_NOOP("axiscomp::ui::ForeignChange",
                "The axis has lost its homing, as after a restart of the drive."));
    if (isOff)
        return text(QT_TRANSLATE_NOOP("axiscomp::ui::ForeignChange",
            "The compensation is off: something other than this window has switched it off."));
    if (!isWorking(before) && isWorking(now))
        return text(QT_TRANSLATE_NOOP("axiscomp::ui::ForeignChange",
            "The compensation is on: something other than this window has switched it on."));
    return {};
}

QString tableLoss(const AxisStatus& before, const AxisStatus& now)
{
    if (!before.table || now.table)
        return {};
    return before.table->persistent
        ? text(QT_TRANSLATE_NOOP("axiscomp::ui::ForeignChange", "The axis has no table any more."))
        : text(QT_TRANSLATE_NOOP("axiscomp::ui::ForeignChange",
            "Its volatile table is gone: write it again, as a persistent one if it has to "
            "outlast a restart."));
}

QStringList changedFields(const CompensationSetup& before, const CompensationSetup& now)
{
    QStringList fields;
    if (before.dimensionality != now.dimensionality)
        fields += text(QT_TRANSLATE_NOOP("axiscomp::ui::ForeignChange", "dimensionality"));
    for (std::size_t n = 0; n < before.sources.size(); ++n)
        if (!(before.sources[n] == now.sources[n]))
            fields +=
                text(QT_TRANSLATE_NOOP("axiscomp::ui::ForeignChange", "source %1")).arg(n + 1);
    if (before.slot != now.slot || before.tableCrc != now.tableCrc)
        fields += text(QT_TRANSLATE_NOOP("axiscomp::ui::ForeignChange", "table"));
    if (before.persistency != now.persistency)
        fields += text(QT_TRANSLATE_NOOP("axiscomp::ui::ForeignChange", "persistency"));
    return fields;
}

} // namespace

Outcome foreignChange(const AxisStatus& before, const AxisStatus& now)
{
    QStringList sentences{stateChange(before, now), tableLoss(before, now)};
    const QStringList fields = changedFields(before.setup, now.setup);
    // A drive that restarts has the settings that were saved, which needs nobody else. One whose
    // axis is homed again by now has restarted without a trace: who it was is not said.
    if (!fields.isEmpty() && !hasRestarted(before, now))
        sentences +=
            text(QT_TRANSLATE_NOOP("axiscomp::ui::ForeignChange",
                     "The settings of this axis on the drive have changed, and not by this "
                     "window: %1."))
                .arg(listText(fields));
    sentences.removeAll(QString());
    Outcome outcome;
    outcome.text = sentences.join(u' ');
    outcome.isWarning = !outcome.text.isEmpty();
    return outcome;
}

} // namespace axiscomp::ui
