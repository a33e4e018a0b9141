// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/endpoint_probe.h"

#include "ui/async/background_job.h"

namespace axiscomp::ui {

namespace {

/// Deletes a session when its thread has ended, without waiting for it here.
void endInOrder(DriveSession& session)
{
    QObject::connect(&session, &DriveSession::closed, &session, &QObject::deleteLater);
    session.close();
}

} // namespace

EndpointProbe::EndpointProbe(ProbeOptions options, QObject* parent)
    : QObject(parent)
    , m_options(std::move(options))
{
}

EndpointProbe::~EndpointProbe()
{
    for (DriveSession* session : std::as_const(m_sessions))
        endInOrder(*session);
}

void EndpointProbe::ask(const QString& endpoint, Handler handler)
{
    auto* session = new DriveSession(endpoint, m_options.linkFactory, *m_options.profile,
        m_options.storeRoot, m_options.timeout);
    m_sessions.append(session);
    const QFuture<Result<DriveIdentity>> answer = session->run<DriveIdentity>(
        [](AxisCompensator& compensator, const OperationOptions& options) {
            return compensator.identify(options);
        });
    whenDone(answer, this,
        [this, session, handler = std::move(handler)](const Result<DriveIdentity>& identity) {
            m_sessions.removeOne(session);
            endInOrder(*session);
            handler(identity);
        });
}

} // namespace axiscomp::ui
