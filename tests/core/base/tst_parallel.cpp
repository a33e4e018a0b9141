// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <atomic>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace tst_parallel {

using namespace axiscomp;

class TestParallel : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void everyPieceOfWorkIsDoneOnce()
    {
        for (const std::size_t threads : {0, 1, 2, 3, 7})
            for (const std::size_t count : {0, 1, 2, 1000}) {
                std::vector<std::atomic<int>> done(count);
                shareWork(count, threads, [&](std::size_t index) { ++done[index]; });
                for (const std::atomic<int>& times : done)
                    QCOMPARE(times.load(), 1);
            }
    }

    void oneThreadIsTheCallers()
    {
        std::vector<std::size_t> order;
        const auto caller = std::this_thread::get_id();
        shareWork(5, 1, [&](std::size_t index) {
            order.push_back(index);
            QCOMPARE(std::this_thread::get_id(), caller);
        });
        QCOMPARE(order, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
    }

    /// Each waits for the others, so that they end only when all run at once.
    void asManyRunAtOnceAsWereAskedFor()
    {
        constexpr std::size_t threads = 3;
        std::atomic<std::size_t> running = 0;
        std::mutex mutex;
        std::set<std::thread::id> seen;
        shareWork(threads, threads, [&](std::size_t) {
            ++running;
            while (running < threads)
                std::this_thread::yield();
            const std::lock_guard lock(mutex);
            seen.insert(std::this_thread::get_id());
        });
        QCOMPARE(seen.size(), threads);
        QVERIFY(seen.contains(std::this_thread::get_id()));
    }

    void anExceptionReachesTheCallerAndEndsTheWork()
    {
        for (const std::size_t threads : {1, 3}) {
            std::atomic<int> begun = 0;
            QVERIFY_THROWS_EXCEPTION(
                std::length_error, shareWork(100'000, threads, [&](std::size_t) {
                    ++begun;
                    throw std::length_error("no room");
                }));
            QVERIFY(begun >= 1 && begun <= static_cast<int>(threads));
            begun = 0;
            QVERIFY_THROWS_EXCEPTION(
                std::length_error, forEachAtOnce(100'000, threads, [&](std::size_t) {
                    ++begun;
                    throw std::length_error("no room");
                }));
            QVERIFY(begun >= 1 && begun <= static_cast<int>(threads));
        }
    }
};

AXISCOMP_TEST(TestParallel)

} // namespace tst_parallel

#include "tst_parallel.moc"
