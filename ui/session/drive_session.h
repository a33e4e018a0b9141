// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compensator/axis_compensator.h"
#include "core/drive/drive_search.h"

#include <QFuture>
#include <QObject>
#include <QPromise>
#include <QString>

#include <filesystem>
#include <functional>
#include <memory>
#include <stop_token>

namespace axiscomp::ui {

/// One drive and the one thread that talks to it. Link and compensator are made, used and destroyed
/// on that thread; everything here is called on the window's thread and returns at once. Operations
/// run one after the other, in the order in which they were asked for. After a lost connection the
/// next operation has a new link.
class DriveSession : public QObject {
    Q_OBJECT

public:
    template <typename T>
    using Operation = std::function<Result<T>(AxisCompensator&, const OperationOptions&)>;

    /// profile must outlive the session.
    DriveSession(QString endpoint, LinkFactory factory, const DriveProfile& profile,
        std::filesystem::path storeRoot, std::chrono::milliseconds timeout,
        QObject* parent = nullptr);
    /// close(), and waits for the end of the thread: within one deadline, even when the drive
    /// hangs.
    ~DriveSession() override;

    /// Without a password.
    [[nodiscard]] QString endpoint() const;
    [[nodiscard]] bool isDemo() const;
    /// Where the operations keep backups, journal and flash history. Of a demo drive nothing is
    /// kept longer than the session: the next one is another drive.
    [[nodiscard]] std::filesystem::path storeRoot() const;

    /// Keep the future and watch it (whenDone). stop ends this operation only, before it has begun
    /// or while it runs.
    template <typename T>
    [[nodiscard]] QFuture<Result<T>> run(Operation<T> operation, std::stop_token stop = {})
    {
        QPromise<Result<T>> promise;
        promise.start();
        QFuture<Result<T>> future = promise.future();
        post(
            [promise = std::make_shared<QPromise<Result<T>>>(std::move(promise)),
                operation = std::move(operation)](
                Result<AxisCompensator*> compensator, const OperationOptions& options) {
                promise->addResult(compensator ? operation(**compensator, options)
                                               : Result<T>(fail(compensator.error())));
                promise->finish();
            },
            std::move(stop));
        return future;
    }

    /// Stops the operation that runs now; it ends with Cancelled, after putting back what it has
    /// to.
    void stop();

    /// Stops what runs, drops what waits and what is asked for from now on (their futures end as
    /// cancelled), and ends the thread. Does not wait: closed() follows.
    void close();
    [[nodiscard]] bool isClosed() const;

Q_SIGNALS:
    /// Of the operation that runs, at most 30 times a second.
    void progressed(const QString& step, double fraction);
    /// close() was called: what is asked for now is the last that gets to the session's thread,
    /// where it is destroyed without having been carried out.
    void closing();
    void closed();

private:
    using Job = std::function<void(Result<AxisCompensator*>, const OperationOptions&)>;
    void post(Job job, std::stop_token stop);

    class Worker;
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace axiscomp::ui
