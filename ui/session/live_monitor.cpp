// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/live_monitor.h"

#include "ui/async/background_job.h"

namespace axiscomp::ui {

LiveMonitor::LiveMonitor(std::chrono::milliseconds interval, QObject* parent) : QObject(parent)
{
    m_timer.setInterval(interval);
    connect(&m_timer, &QTimer::timeout, this, &LiveMonitor::readNow);
    if (interval.count() > 0)
        m_timer.start();
}

void LiveMonitor::watch(DriveConnection* connection, int axis)
{
    if (m_connection == connection && m_axis == axis)
        return;
    abandon();
    m_connection = connection;
    m_axis = axis;
}

void LiveMonitor::pause()
{
    m_isPaused = true;
    abandon();
}

void LiveMonitor::resume()
{
    m_isPaused = false;
}

/// What has been asked for is not wanted any more.
void LiveMonitor::abandon()
{
    m_stop.request_stop();
    m_underWay = 0;
}

void LiveMonitor::readNow()
{
    if (m_isPaused || m_underWay != 0 || !m_connection || !m_connection->isConnected())
        return;
    m_underWay = ++m_lastNumber;
    m_stop = std::stop_source();
    const auto read = [axis = m_axis, registers = m_registers](
                          AxisCompensator& compensator, const OperationOptions& options) {
        OperationOptions quiet = options;
        quiet.progress = {};
        return compensator.watch(axis, registers, quiet);
    };
    whenDone(m_connection->session().run<WatchedStatus>(read, m_stop.get_token()), this,
        [this, number = m_underWay](const Result<WatchedStatus>& now) {
            if (number != m_underWay)
                return;
            m_underWay = 0;
            if (now)
                Q_EMIT this->read(*now);
            else
                Q_EMIT failed(now.error());
        });
}

} // namespace axiscomp::ui
