// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>

#include <mutex>
#include <optional>

namespace axiscomp::ui {

/// Carries progress from a working thread to the thread of this object: always the newest value, at
/// most 30 times a second, however often it is reported.
class ProgressRelay : public QObject {
    Q_OBJECT

public:
    explicit ProgressRelay(QObject* parent = nullptr);

    /// From any thread.
    void report(const QString& step, double fraction);
    /// From any thread: what has not been delivered yet is dropped.
    void clear();

Q_SIGNALS:
    void progressed(const QString& step, double fraction);

private:
    void deliver();

    struct Value {
        QString step;
        double fraction = 0.0;
    };
    std::mutex m_mutex;
    std::optional<Value> m_newest;
    bool m_isAnnounced = false;
    QElapsedTimer m_sinceDelivery;
    QTimer m_timer;
};

} // namespace axiscomp::ui
