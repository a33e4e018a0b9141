// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFuture>
#include <QPromise>
#include <QThreadPool>

#include <functional>
#include <memory>

namespace axiscomp::ui {

/// Computes something off the window's thread; watch the future with a context object. The function
/// refers to nothing that may go away.
template <typename T> [[nodiscard]] QFuture<T> inBackground(std::function<T()> function)
{
    auto promise = std::make_shared<QPromise<T>>();
    promise->start();
    QFuture<T> future = promise->future();
    QThreadPool::globalInstance()->start([promise, function = std::move(function)] {
        promise->addResult(function());
        promise->finish();
    });
    return future;
}

} // namespace axiscomp::ui
