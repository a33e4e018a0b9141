// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/state_text.h"

#include <QCoreApplication>
#include <QLocale>

namespace axiscomp::ui {

namespace {

struct StateText {
    Q_DECLARE_TR_FUNCTIONS(axiscomp::ui::StateField)
};

} // namespace

QString stateWord(const AxisInfo& axis)
{
    switch (axis.state) {
    case CompensationState::Disabled:
        return StateText::tr("OFF");
    case CompensationState::Evaluating:
        return StateText::tr("EVALUATING");
    case CompensationState::Ramping:
        return StateText::tr("RAMPING");
    case CompensationState::Active:
        return StateText::tr("ACTIVE");
    case CompensationState::Error:
        return StateText::tr("ERROR");
    case CompensationState::Unknown:
        break;
    }
    return QString::fromStdString(axis.stateWord);
}

QString notConnectedWord()
{
    return StateText::tr("NOT CONNECTED");
}

Tone stateTone(CompensationState state)
{
    switch (state) {
    case CompensationState::Active:
        return Tone::Success;
    case CompensationState::Ramping:
    case CompensationState::Evaluating:
        return Tone::Warning;
    case CompensationState::Error:
        return Tone::Error;
    default:
        return Tone::Information;
    }
}

QString clockText(const QDateTime& time)
{
    return QLocale().toString(time.time(), QStringLiteral("HH:mm:ss"));
}

QString sinceText(const QDateTime& time)
{
    return StateText::tr("since %1").arg(clockText(time));
}

QString asReadText(const QDateTime& time)
{
    return StateText::tr("as read at %1").arg(clockText(time));
}

QString noTableText()
{
    return StateText::tr("no table");
}

QString tableWithCrc(const QString& name, std::uint32_t crc)
{
    const QString digits = QStringLiteral("%1").arg(crc, 8, 16, QLatin1Char('0')).toUpper();
    return StateText::tr("%1, CRC %2", "table and checksum").arg(name, digits);
}

} // namespace axiscomp::ui
