// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace axiscomp {

namespace {

/// What several threads take one by one.
class SharedWork {
public:
    SharedWork(std::size_t count, const std::function<void(std::size_t)>& work)
        : m_count(count)
        , m_work(work)
    {
    }

    void take() noexcept
    {
        try {
            for (std::size_t index = m_next++; index < m_count; index = m_next++)
                m_work(index);
        } catch (...) {
            m_next = m_count;
            const std::lock_guard lock(m_mutex);
            m_failure = std::current_exception();
        }
    }
    /// When all threads have ended.
    void throwFailure() const
    {
        if (m_failure)
            std::rethrow_exception(m_failure);
    }

private:
    std::size_t m_count;
    const std::function<void(std::size_t)>& m_work;
    std::atomic<std::size_t> m_next = 0;
    std::mutex m_mutex;
    std::exception_ptr m_failure;
};

/// Until all is done.
void takeOnThreads(std::size_t threads, bool callerHelps, SharedWork& shared)
{
    {
        std::vector<std::jthread> others;
        try {
            while (others.size() < threads)
                others.emplace_back([&shared] { shared.take(); });
        } catch (const std::system_error&) {
            // No more threads are to be had: those that there are do the work.
        }
        if (callerHelps || others.empty())
            shared.take();
    }
    shared.throwFailure();
}

} // namespace

std::size_t processorCount()
{
    return std::max(1U, std::thread::hardware_concurrency());
}

void forEachAtOnce(
    std::size_t count, std::size_t mostAtOnce, const std::function<void(std::size_t)>& work)
{
    SharedWork shared(count, work);
    takeOnThreads(std::min(count, mostAtOnce), false, shared);
}

void shareWork(std::size_t count, std::size_t threads, const std::function<void(std::size_t)>& work)
{
    if (threads == 0)
        threads = processorCount();
    SharedWork shared(count, work);
    takeOnThreads(std::max<std::size_t>(1, std::min(count, threads)) - 1, true, shared);
}

} // namespace axiscomp
