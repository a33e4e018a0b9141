// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/link_factory.h"
#include "drivecomm/profile/profile_loader.h"
#include "drivecomm/virtualdrive/direct_link.h"
#include "tests/support/compensator_fixture.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"
#include "tests/ui/support/gate_link.h"
#include "ui/async/background_job.h"
#include "ui/session/drive_session.h"

#include <QElapsedTimer>
#include <QSemaphore>
#include <QSignalSpy>
#include <QTest>

#include <atomic>

namespace tst_drivesession {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::DriveGate;

namespace {

constexpr std::chrono::milliseconds deadline{300};

/// A session with a virtual drive behind a gate.
struct SessionFixture {
    SessionFixture() : drive(drivecomm::genericProfile(), test::CompensatorFixture::options(time))
    {
    }
    ~SessionFixture() { session.reset(); }

    std::unique_ptr<DriveSession> make(std::chrono::milliseconds timeout = deadline)
    {
        return std::make_unique<DriveSession>(
            QStringLiteral("http://user:p@ss@test"),
            [this](const std::string& endpoint) { return link(endpoint); },
            drivecomm::genericProfile(), store(), timeout);
    }
    [[nodiscard]] std::filesystem::path store() const
    {
        return std::filesystem::path(folder.path().toStdString()) / "store";
    }

    Result<std::unique_ptr<DriveLink>> link(const std::string& endpoint)
    {
        ++linksMade;
        lastEndpoint = endpoint;
        if (refuses)
            return fail(
                ErrorCode::InvalidEndpoint, {{"endpoint", endpoint}, {"reason", Verbatim{"no"}}});
        return std::make_unique<test::GateLink>(
            drivecomm::makeDirectLink(drive), gate, [this](QThread* made, QThread* destroyed) {
                madeOn = made;
                destroyedOn = destroyed;
            });
    }

    std::atomic<std::int64_t> time = 0;
    QTemporaryDir folder;
    drivecomm::VirtualDrive drive;
    DriveGate gate;
    std::atomic<int> linksMade = 0;
    std::atomic<bool> refuses = false;
    std::string lastEndpoint;
    std::atomic<QThread*> madeOn = nullptr;
    std::atomic<QThread*> destroyedOn = nullptr;
    std::unique_ptr<DriveSession> session = make();
};

QFuture<Result<DriveIdentity>> identify(DriveSession& session, std::stop_token stop = {})
{
    return session.run<DriveIdentity>(
        [](AxisCompensator& compensator, const OperationOptions& options) {
            return compensator.identify(options);
        },
        std::move(stop));
}

} // namespace

class TestDriveSession : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void anOperationRunsOnTheSessionsThreadWithALinkMadeThere()
    {
        SessionFixture bench;
        QCOMPARE(bench.linksMade.load(), 0);
        const auto future = identify(*bench.session);
        QTRY_VERIFY(future.isFinished());
        VERIFY_RESULT(future.result());
        QCOMPARE(future.result()->name, "Test-1");
        QCOMPARE(bench.linksMade.load(), 1);
        QCOMPARE(bench.lastEndpoint, "http://user:p@ss@test");
        bench.session.reset();
        QVERIFY(bench.madeOn.load() != nullptr);
        QVERIFY(bench.madeOn.load() != thread());
        QCOMPARE(bench.destroyedOn.load(), bench.madeOn.load());
    }

    void theEndpointIsShownWithoutThePassword()
    {
        const SessionFixture bench;
        QCOMPARE(bench.session->endpoint(), QStringLiteral("http://test"));
        QVERIFY(!bench.session->isDemo());
        QCOMPARE(bench.session->storeRoot(), bench.store());
    }

    void whatADemoDriveLeavesEndsWithItsSession()
    {
        std::filesystem::path kept;
        {
            const DriveSession session(
                QStringLiteral("demo:"), {}, drivecomm::genericProfile(), "/nowhere", deadline);
            QVERIFY(session.isDemo());
            kept = session.storeRoot();
            QVERIFY(std::filesystem::exists(kept));
        }
        QVERIFY(!std::filesystem::exists(kept));
    }

    void operationsRunOneAfterTheOtherInTheirOrder()
    {
        SessionFixture bench;
        std::vector<int> order;
        std::atomic<int> atOnce = 0;
        std::atomic<bool> overlapped = false;
        QFuture<Result<int>> last;
        for (int i = 0; i < 50; ++i)
            last = bench.session->run<int>(
                [&, i](AxisCompensator&, const OperationOptions&) -> Result<int> {
                    overlapped = overlapped || ++atOnce > 1;
                    order.push_back(i);
                    --atOnce;
                    return i;
                });
        QTRY_VERIFY(last.isFinished());
        QVERIFY(!overlapped);
        QCOMPARE(order.size(), std::size_t{50});
        QVERIFY(std::ranges::is_sorted(order));
    }

    void handlersAreCalledInTheOrderOfTheOperationsEvenWhenAttachedLate()
    {
        SessionFixture bench;
        std::vector<int> order;
        const auto number = [&](int i) {
            return bench.session->run<int>(
                [i](AxisCompensator&, const OperationOptions&) -> Result<int> { return i; });
        };
        const auto first = number(1);
        const auto second = number(2);
        whenDone(first, this, [&](const Result<int>& i) { order.push_back(*i); });
        while (!second.isFinished())
            QThread::yieldCurrentThread();
        whenDone(second, this, [&](const Result<int>& i) { order.push_back(*i); });
        QVERIFY(order.empty()); // never from within the call
        QTRY_COMPARE(order, (std::vector<int>{1, 2}));
    }

    void stopEndsWhatRunsNowAndNothingElse()
    {
        SessionFixture bench;
        bench.session = bench.make(std::chrono::hours(1));
        bench.gate.set(DriveGate::Mode::Silent);
        const auto running = identify(*bench.session);
        const auto waiting = identify(*bench.session);
        QTRY_COMPARE(bench.gate.waiting(), 1);
        bench.session->stop();
        QTRY_VERIFY(running.isFinished());
        VERIFY_ERROR(running.result(), ErrorCode::Cancelled);
        bench.gate.set(DriveGate::Mode::Open);
        QTRY_VERIFY(waiting.isFinished());
        VERIFY_RESULT(waiting.result());
        bench.session->stop(); // nothing runs: nothing happens
        const auto next = identify(*bench.session);
        QTRY_VERIFY(next.isFinished());
        VERIFY_RESULT(next.result());
    }

    void aStopOfItsOwnEndsAnOperationBeforeItHasBegunToo()
    {
        SessionFixture bench;
        bench.session = bench.make(std::chrono::hours(1));
        bench.gate.set(DriveGate::Mode::Silent);
        std::stop_source first;
        std::stop_source second;
        const auto running = identify(*bench.session, first.get_token());
        const auto waiting = identify(*bench.session, second.get_token());
        QTRY_COMPARE(bench.gate.waiting(), 1);
        second.request_stop();
        QVERIFY(!running.isFinished());
        first.request_stop();
        QTRY_VERIFY(waiting.isFinished());
        VERIFY_ERROR(running.result(), ErrorCode::Cancelled);
        VERIFY_ERROR(waiting.result(), ErrorCode::Cancelled);
        QCOMPARE(bench.gate.timeouts(), 0);
    }

    void afterALostConnectionTheNextOperationHasANewLink_data()
    {
        QTest::addColumn<int>("mode");
        QTest::newRow("gone") << static_cast<int>(DriveGate::Mode::Gone);
        QTest::newRow("silent") << static_cast<int>(DriveGate::Mode::Silent);
    }
    void afterALostConnectionTheNextOperationHasANewLink()
    {
        QFETCH(int, mode);
        SessionFixture bench;
        bench.gate.set(static_cast<DriveGate::Mode>(mode));
        const auto lost = identify(*bench.session);
        QTRY_VERIFY(lost.isFinished());
        QVERIFY(!lost.result().has_value());
        bench.gate.set(DriveGate::Mode::Open);
        const auto found = identify(*bench.session);
        QTRY_VERIFY(found.isFinished());
        VERIFY_RESULT(found.result());
        QCOMPARE(bench.linksMade.load(), 2);
        const auto again = identify(*bench.session);
        QTRY_VERIFY(again.isFinished());
        QCOMPARE(bench.linksMade.load(), 2);
    }

    void aLinkThatCannotBeMadeIsTheErrorOfEachOperationAndTriedAgain()
    {
        SessionFixture bench;
        bench.refuses = true;
        const auto refused = identify(*bench.session);
        QTRY_VERIFY(refused.isFinished());
        VERIFY_ERROR(refused.result(), ErrorCode::InvalidEndpoint);
        bench.refuses = false;
        const auto made = identify(*bench.session);
        QTRY_VERIFY(made.isFinished());
        VERIFY_RESULT(made.result());
    }

    void theEndStopsWhatRunsAndCancelsWhatWaits()
    {
        SessionFixture bench;
        bench.session = bench.make(std::chrono::hours(1));
        bench.gate.set(DriveGate::Mode::Silent);
        const auto running = identify(*bench.session);
        QTRY_COMPARE(bench.gate.waiting(), 1);
        std::vector<QFuture<Result<DriveIdentity>>> waiting;
        for (int i = 0; i < 5; ++i)
            waiting.push_back(identify(*bench.session));
        bench.session.reset();
        QVERIFY(running.isFinished());
        VERIFY_ERROR(running.result(), ErrorCode::Cancelled);
        for (const auto& future : waiting) {
            QVERIFY(future.isFinished());
            QVERIFY(future.isCanceled());
            QCOMPARE(future.resultCount(), 0);
        }
        QCOMPARE(bench.gate.exchanges(), 1);
    }

    void afterCloseNothingBeginsAnyMore()
    {
        SessionFixture bench;
        QSignalSpy closed(bench.session.get(), &DriveSession::closed);
        bench.session->close();
        const auto late = identify(*bench.session);
        QVERIFY(late.isFinished());
        QVERIFY(late.isCanceled());
        QTRY_COMPARE(closed.count(), 1);
        QVERIFY(bench.session->isClosed());
        QCOMPARE(bench.linksMade.load(), 0);
    }

    /// Wherever a write is when the drive stops answering: when the session ends, its thread waits
    /// for the drive at most once, however much there is to put back.
    void theEndWaitsForADriveThatHangsAtMostOnce_data()
    {
        QTest::addColumn<int>("mode");
        QTest::addColumn<int>("exchange");
        for (const auto mode : {DriveGate::Mode::Silent, DriveGate::Mode::Deaf}) {
            for (int exchange = 1; exchange <= 24; ++exchange)
                QTest::addRow("%s at exchange %d",
                    mode == DriveGate::Mode::Silent ? "silent" : "deaf", exchange)
                    << static_cast<int>(mode) << exchange;
        }
    }
    void theEndWaitsForADriveThatHangsAtMostOnce()
    {
        QFETCH(int, mode);
        QFETCH(int, exchange);
        SessionFixture bench;
        bench.session = bench.make(std::chrono::milliseconds(200));
        bench.gate.setAt(exchange, static_cast<DriveGate::Mode>(mode));
        const auto write = bench.session->run<WriteReport>(
            [](AxisCompensator& compensator, const OperationOptions& options) {
                return compensator.write(0, test::exampleRequest(), options);
            });
        QTRY_VERIFY(bench.gate.waiting() == 1 || write.isFinished());
        const int timeoutsBefore = bench.gate.timeouts();
        bench.session.reset();
        QVERIFY(write.isFinished());
        QVERIFY(bench.gate.timeouts() - timeoutsBefore <= 1);
    }

    /// A drive that answers gets its old state back, also when the window is closed meanwhile.
    void theEndDuringAWriteLeavesTheOldState()
    {
        SessionFixture bench;
        bench.session = bench.make(std::chrono::hours(1));
        QSemaphore uploading;
        std::atomic<bool> isSeen = false;
        const auto write = bench.session->run<WriteReport>(
            [&](AxisCompensator& compensator, const OperationOptions& options) {
                OperationOptions watched = options;
                watched.progress = [&](const Progress& progress) {
                    if (progress.step == "switch" && !isSeen.exchange(true)) {
                        uploading.release();
                        while (!options.stop.stop_requested())
                            QThread::yieldCurrentThread();
                    }
                };
                return compensator.write(0, test::exampleRequest(), watched);
            });
        QVERIFY(uploading.tryAcquire(1, test::patienceMs));
        bench.session.reset();
        VERIFY_ERROR(write.result(), ErrorCode::Cancelled);
        const auto table =
            bench.drive.readRegisters({"Axes[0]/Parameters/Compensations/Axis/Table"});
        QCOMPARE(toText(table->front().value), "Disabled");
        DriveStore store(bench.store());
        const auto journal = store.journal(4711, 0);
        VERIFY_RESULT(journal);
        QVERIFY(!journal->has_value());
    }

    void progressComesAtMostThirtyTimesASecondAndTheNewestComes()
    {
        SessionFixture bench;
        std::vector<double> seen;
        connect(bench.session.get(), &DriveSession::progressed, this,
            [&](const QString& step, double fraction) {
                QCOMPARE(step, QStringLiteral("upload"));
                QCOMPARE(QThread::currentThread(), thread());
                seen.push_back(fraction);
            });
        QSemaphore mayEnd;
        QElapsedTimer timer;
        timer.start();
        const auto future = bench.session->run<int>(
            [&](AxisCompensator&, const OperationOptions& options) -> Result<int> {
                QElapsedTimer busy;
                busy.start();
                int reports = 0;
                while (busy.elapsed() < 400) {
                    options.progress({"upload", 0.5 * static_cast<double>(busy.elapsed()) / 400.0});
                    ++reports;
                }
                options.progress({"upload", 1.0});
                mayEnd.acquire();
                return reports;
            });
        QTRY_VERIFY(!seen.empty() && seen.back() == 1.0); // while it still runs
        mayEnd.release();
        QTRY_VERIFY(future.isFinished());
        QVERIFY(*future.result() > 100);
        const auto most = 1 + timer.elapsed() * 30 / 1000;
        QVERIFY2(
            static_cast<qint64>(seen.size()) <= most, qPrintable(QString::number(seen.size())));
        QVERIFY(std::ranges::is_sorted(seen));
    }
};

AXISCOMP_TEST(TestDriveSession)

} // namespace tst_drivesession

#include "tst_drivesession.moc"
