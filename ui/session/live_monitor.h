// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/drive_connection.h"

#include <QObject>
#include <QPointer>
#include <QTimer>

#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace axiscomp::ui {

/// Reads the status of one axis again and again: never more than one request at a time, none while
/// it is paused or the drive is lost.
class LiveMonitor : public QObject {
    Q_OBJECT

public:
    /// interval 0: only on readNow().
    explicit LiveMonitor(std::chrono::milliseconds interval, QObject* parent = nullptr);

    /// Null: nothing.
    void watch(DriveConnection* connection, int axis);
    /// Registers that are read with the status of the axis.
    void alsoRead(std::vector<std::string> registers) { m_registers = std::move(registers); }
    /// Stops the request that is under way, so that an operation need not wait for it.
    void pause();
    void resume();
    void readNow();

Q_SIGNALS:
    void read(const axiscomp::WatchedStatus& now);
    void failed(const axiscomp::Error& error);

private:
    void abandon();

    QPointer<DriveConnection> m_connection;
    int m_axis = 0;
    std::vector<std::string> m_registers;
    bool m_isPaused = false;
    int m_underWay = 0; ///< number of the request whose answer is waited for; 0: none
    int m_lastNumber = 0;
    std::stop_source m_stop;
    QTimer m_timer;
};

} // namespace axiscomp::ui
