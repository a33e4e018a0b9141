// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/busy_mark.h"

#include <QPainter>
#include <QTimerEvent>

namespace axiscomp::ui {

namespace {

constexpr int side = 16;
constexpr int stepMs = 80;
constexpr int stepsPerTurn = 12;

} // namespace

BusyMark::BusyMark(QWidget* parent) : QWidget(parent)
{
    setFixedSize(side, side);
}

void BusyMark::setBusy(bool busy)
{
    if (busy == isBusy())
        return;
    if (busy)
        m_timer.start(stepMs, this);
    else
        m_timer.stop();
    update();
}

bool BusyMark::isBusy() const
{
    return m_timer.isActive();
}

QSize BusyMark::sizeHint() const
{
    return {side, side};
}

void BusyMark::paintEvent(QPaintEvent*)
{
    if (!isBusy())
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2.0, Qt::SolidLine, Qt::RoundCap));
    const int sixteenths = 16 * 360 / stepsPerTurn;
    painter.drawArc(QRectF(rect()).adjusted(2, 2, -2, -2), -m_turn * sixteenths, 16 * 270);
}

void BusyMark::timerEvent(QTimerEvent* event)
{
    if (event->timerId() != m_timer.timerId())
        return;
    m_turn = (m_turn + 1) % stepsPerTurn;
    update();
}

} // namespace axiscomp::ui
