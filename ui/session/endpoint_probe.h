// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/drive_session.h"
#include "ui/session/port_candidates.h"

#include <QObject>

namespace axiscomp::ui {

/// How links are made, and for how long they are waited for.
struct ProbeOptions {
    LinkFactory linkFactory;
    PortCandidates portCandidates; ///< empty: drives are not looked for
    NetworkPlaces network;
    const DriveProfile* profile = nullptr;
    std::filesystem::path storeRoot;
    std::chrono::milliseconds timeout{5000};
};

/// Asks whether there is a drive at an endpoint, on a session of its own.
class EndpointProbe : public QObject {
    Q_OBJECT

public:
    explicit EndpointProbe(ProbeOptions options, QObject* parent = nullptr);
    /// Does not wait: a session that still talks ends by itself.
    ~EndpointProbe() override;

    using Handler = std::function<void(const Result<DriveIdentity>&)>;
    /// handler is called from the event loop, unless the probe is gone by then.
    void ask(const QString& endpoint, Handler handler);

private:
    ProbeOptions m_options;
    QList<DriveSession*> m_sessions;
};

} // namespace axiscomp::ui
