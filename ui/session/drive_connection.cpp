// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/drive_connection.h"

#include "ui/async/background_job.h"
#include "ui/text/endpoint_text.h"
#include "ui/text/message_text.h"

#include <utility>

namespace axiscomp::ui {

using Connection = DriveState::Connection;

DriveConnection::DriveConnection(const QString& endpoint, LinkFactory factory,
    const DriveProfile& profile, const std::filesystem::path& storeRoot,
    std::chrono::milliseconds timeout, std::chrono::milliseconds reconnectInterval, QObject* parent)
    : QObject(parent)
    , m_endpoint(endpoint)
    , m_session(endpoint, std::move(factory), profile, storeRoot, timeout)
{
    m_state.endpoint = shownEndpoint(endpoint);
    m_state.isDemo = isDemoEndpoint(endpoint);
    m_retry.setSingleShot(true);
    m_retry.setInterval(reconnectInterval);
    connect(&m_retry, &QTimer::timeout, this, &DriveConnection::explore);
}

DriveState DriveConnection::state() const
{
    DriveState state = m_state;
    if (m_problem) {
        state.problem = errorText(*m_problem);
        state.certificate = rejectedCertificate(*m_problem);
    }
    return state;
}

DriveAxes DriveConnection::axes() const
{
    DriveAxes axes;
    axes.endpoint = m_state.endpoint;
    axes.isDemo = m_state.isDemo;
    axes.isConnected = isConnected();
    if (m_findings) {
        axes.drive = m_findings->drive;
        axes.axes = m_findings->axes;
    }
    return axes;
}

void DriveConnection::explore()
{
    m_retry.stop();
    if (std::exchange(m_isExploring, true)) {
        m_mustExploreAgain = true;
        return;
    }
    const auto look = [](AxisCompensator& compensator, const OperationOptions& options) {
        return exploreDrive(compensator, options);
    };
    whenDone(m_session.run<DriveFindings>(look), this,
        [this](const Result<DriveFindings>& findings) { take(findings); });
}

void DriveConnection::tryAgain()
{
    if (m_state.connection == Connection::Lost) {
        m_problem.reset();
        m_state.connection = Connection::Connecting;
        Q_EMIT stateChanged();
    }
    explore();
}

void DriveConnection::take(const Result<DriveFindings>& findings)
{
    m_isExploring = false;
    if (!findings) {
        m_mustExploreAgain = false;
        lose(findings.error());
        return;
    }
    if (std::exchange(m_mustExploreAgain, false)) {
        explore();
        return;
    }
    const bool wasAnother =
        m_findings && m_findings->drive.serialNumber != findings->drive.serialNumber;
    m_retry.stop();
    m_findings = *findings;
    m_state.name = QString::fromStdString(findings->drive.name);
    m_state.connection = Connection::Connected;
    m_state.lostSince.reset();
    m_problem.reset();
    Q_EMIT stateChanged();
    Q_EMIT found(wasAnother);
}

void DriveConnection::lose(const Error& error)
{
    const bool isNews = !m_problem || !saysTheSame(*m_problem, error);
    m_state.connection = Connection::Lost;
    if (!m_state.lostSince)
        m_state.lostSince = std::chrono::system_clock::now();
    m_problem = error;
    m_retry.start();
    if (!isNews)
        return;
    Q_EMIT stateChanged();
    Q_EMIT lost(error);
}

void DriveConnection::close()
{
    m_retry.stop();
    m_session.close();
}

void DriveConnection::retire()
{
    disconnect(this, nullptr, nullptr, nullptr);
    connect(&m_session, &DriveSession::closed, this, &QObject::deleteLater);
    close();
    if (m_session.isClosed())
        deleteLater();
}

} // namespace axiscomp::ui
