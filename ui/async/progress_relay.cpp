// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/async/progress_relay.h"

#include <utility>

namespace axiscomp::ui {

namespace {

constexpr qint64 shortestPauseMs = 34; // at most 30 times a second

} // namespace

ProgressRelay::ProgressRelay(QObject* parent) : QObject(parent)
{
    m_timer.setSingleShot(true);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &ProgressRelay::deliver);
}

void ProgressRelay::report(const QString& step, double fraction)
{
    const std::lock_guard lock(m_mutex);
    m_newest = Value{step, fraction};
    if (std::exchange(m_isAnnounced, true))
        return;
    QMetaObject::invokeMethod(this, &ProgressRelay::deliver, Qt::QueuedConnection);
}

void ProgressRelay::clear()
{
    const std::lock_guard lock(m_mutex);
    m_newest.reset();
}

void ProgressRelay::deliver()
{
    const qint64 since = m_sinceDelivery.isValid() ? m_sinceDelivery.elapsed() : shortestPauseMs;
    if (since < shortestPauseMs) {
        m_timer.start(static_cast<int>(shortestPauseMs - since));
        return;
    }
    std::optional<Value> value;
    {
        const std::lock_guard lock(m_mutex);
        m_isAnnounced = false;
        value = std::exchange(m_newest, std::nullopt);
    }
    if (!value)
        return;
    m_sinceDelivery.start();
    Q_EMIT progressed(value->step, value->fraction);
}

} // namespace axiscomp::ui
