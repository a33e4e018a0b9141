// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compensator/axis_operations.h"
#include "ui/session/axis_list.h"
#include "ui/session/drive_session.h"

#include <QObject>
#include <QTimer>

#include <optional>

namespace axiscomp::ui {

/// One drive of the window: finds out what it is, keeps what was found while it is lost, and looks
/// for it again until it answers.
class DriveConnection : public QObject {
    Q_OBJECT

public:
    /// profile must outlive the connection.
    DriveConnection(const QString& endpoint, LinkFactory factory, const DriveProfile& profile,
        const std::filesystem::path& storeRoot, std::chrono::milliseconds timeout,
        std::chrono::milliseconds reconnectInterval, QObject* parent = nullptr);

    [[nodiscard]] const QString& endpointAsGiven() const { return m_endpoint; }
    /// Without a password.
    [[nodiscard]] const QString& endpoint() const { return m_state.endpoint; }
    [[nodiscard]] const QString& name() const { return m_state.name; } ///< empty until identified
    [[nodiscard]] DriveState state() const; ///< its problem in the language of the moment
    [[nodiscard]] bool isConnected() const
    {
        return m_state.connection == DriveState::Connection::Connected;
    }
    /// Why it does not answer, while it is lost.
    [[nodiscard]] const std::optional<Error>& problem() const { return m_problem; }
    /// What was found last; kept while the drive is lost.
    [[nodiscard]] const std::optional<DriveFindings>& findings() const { return m_findings; }
    [[nodiscard]] DriveAxes axes() const;
    [[nodiscard]] DriveSession& session() { return m_session; }

    /// Looks at once, also when it is not yet time to try again.
    void explore();
    /// The user wants to know whether it answers now: a lost drive counts as being looked for.
    void tryAgain();
    /// Something else has found out that the drive does not answer.
    void lose(const Error& error);
    /// Stops everything and deletes the connection when its session has ended; nothing waits for
    /// it.
    void retire();
    /// Stops everything; the destructor then waits.
    void close();

Q_SIGNALS:
    void stateChanged();
    /// The drive has answered: its findings are new. wasAnother: another drive is at the endpoint
    /// than before.
    void found(bool wasAnother);
    void lost(const axiscomp::Error& error);

private:
    void take(const Result<DriveFindings>& findings);

    QString m_endpoint;
    DriveState m_state; ///< without its problem
    std::optional<Error> m_problem; ///< while the drive is lost
    std::optional<DriveFindings> m_findings;
    QTimer m_retry;
    bool m_isExploring = false;
    bool m_mustExploreAgain = false;
    DriveSession m_session;
};

} // namespace axiscomp::ui
