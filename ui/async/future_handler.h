// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFuture>
#include <QFutureWatcher>
#include <QObject>

#include <utility>

namespace axiscomp::ui {

/// Calls handler(result) on the context's thread when the future has its result; not when it was
/// cancelled, and not after the context's end. Always from the event loop, never before this
/// returns, and in the order in which the futures ended: QFuture::then would call at once when the
/// future has already ended.
template <typename T, typename Handler>
void whenDone(const QFuture<T>& future, QObject* context, Handler handler)
{
    auto* watcher = new QFutureWatcher<T>(context);
    QObject::connect(watcher, &QFutureWatcherBase::finished, context,
        [watcher, handler = std::move(handler)]() mutable {
            watcher->deleteLater();
            if (!watcher->isCanceled())
                handler(watcher->result());
        });
    watcher->setFuture(future);
}

} // namespace axiscomp::ui
