// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/drive_search_job.h"

#include <QPromise>
#include <QThreadPool>

namespace axiscomp::ui {

DriveSearchJob::DriveSearchJob(QObject* parent) : QObject(parent)
{
    connect(&m_watcher, &QFutureWatcherBase::resultReadyAt, this,
        [this](int index) { Q_EMIT sighted(*m_watcher.resultAt(index)); });
    connect(&m_watcher, &QFutureWatcherBase::finished, this, &DriveSearchJob::finished);
}

DriveSearchJob::~DriveSearchJob()
{
    m_stop.request_stop();
}

void DriveSearchJob::start(LinkFactory linkFactory,
    std::function<std::vector<DriveCandidate>()> candidates, std::size_t mostAtOnce)
{
    m_stop.request_stop();
    m_stop = std::stop_source();
    auto promise = std::make_shared<QPromise<Sighting>>();
    promise->start();
    m_watcher.setFuture(promise->future());
    QThreadPool::globalInstance()->start(
        [promise, linkFactory = std::move(linkFactory), candidates = std::move(candidates),
            mostAtOnce, stop = m_stop.get_token()] {
            DriveSearch search;
            search.linkFactory = linkFactory;
            search.stop = stop;
            search.mostAtOnce = mostAtOnce;
            search.sighted = [&](const DriveSighting& sighting) { promise->addResult(sighting); };
            static_cast<void>(findDrives(candidates(), search));
            promise->finish();
        });
}

void DriveSearchJob::stop()
{
    m_stop.request_stop();
}

bool DriveSearchJob::isRunning() const
{
    return m_watcher.isRunning();
}

} // namespace axiscomp::ui
