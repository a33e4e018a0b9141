// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/drive_search.h"

#include <QFutureWatcher>
#include <QObject>

#include <optional>
#include <stop_token>

namespace axiscomp::ui {

/// Looks for drives on threads of its own.
class DriveSearchJob : public QObject {
    Q_OBJECT

public:
    explicit DriveSearchJob(QObject* parent = nullptr);
    /// Stops without waiting.
    ~DriveSearchJob() override;

    /// candidates is called on another thread: listing ports takes time. A scan that runs is
    /// stopped.
    void start(LinkFactory linkFactory, std::function<std::vector<DriveCandidate>()> candidates,
        std::size_t mostAtOnce = DriveSearch{}.mostAtOnce);
    void stop();
    [[nodiscard]] bool isRunning() const;

Q_SIGNALS:
    void sighted(const DriveSighting& sighting);
    void finished();

private:
    using Sighting = std::optional<DriveSighting>; // QPromise wants a default value
    std::stop_source m_stop;
    QFutureWatcher<Sighting> m_watcher;
};

} // namespace axiscomp::ui
