// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/drive_link.h"

#include <QThread>

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

namespace axiscomp::test {

/// What happens on the way between a session and its drive; set by the test from its own thread.
class DriveGate {
public:
    enum class Mode {
        Open,
        Gone, ///< no exchange gets through: an error at once
        Silent, ///< no answer: an exchange ends at its deadline or when it is stopped
        Deaf, ///< no answer, and a stop is not heard either
    };

    DriveGate() = default;
    /// The error of an exchange with a drive that is gone, in place of NotConnected.
    explicit DriveGate(Error whenGone) : m_whenGone(std::move(whenGone)) { }

    void set(Mode mode)
    {
        const std::lock_guard lock(m_mutex);
        m_mode = mode;
        m_changed.notify_all();
    }
    /// From the number-th exchange on from now (1: the next), and not before.
    void setAt(int number, Mode mode)
    {
        const std::lock_guard lock(m_mutex);
        m_turn = m_exchanges + number;
        m_modeAfterTurn = mode;
    }
    /// Something happens just before the number-th exchange from now, on the session's thread.
    void callAt(int number, std::function<void()> action)
    {
        const std::lock_guard lock(m_mutex);
        m_callTurn = m_exchanges + number;
        m_action = std::move(action);
    }
    /// Uploads stop half-way until releaseUploads(), or until they are stopped.
    void holdUploads()
    {
        const std::lock_guard lock(m_mutex);
        m_holdsUploads = true;
    }
    void releaseUploads()
    {
        const std::lock_guard lock(m_mutex);
        m_holdsUploads = false;
        m_changed.notify_all();
    }
    /// The drive answers every upload with this error.
    void refuseUploads(std::optional<Error> error)
    {
        const std::lock_guard lock(m_mutex);
        m_refusal = std::move(error);
    }
    [[nodiscard]] int exchanges() const
    {
        const std::lock_guard lock(m_mutex);
        return m_exchanges;
    }
    /// Exchanges that are waiting for an answer now, and that have waited until their deadline.
    [[nodiscard]] int waiting() const
    {
        const std::lock_guard lock(m_mutex);
        return m_waiting;
    }
    [[nodiscard]] int timeouts() const
    {
        const std::lock_guard lock(m_mutex);
        return m_timeouts;
    }
    /// Never more than one at a time on a link.
    [[nodiscard]] int mostAtOnce() const
    {
        const std::lock_guard lock(m_mutex);
        return m_mostAtOnce;
    }

    [[nodiscard]] Result<void> pass(const Exchange& exchange)
    {
        const std::stop_callback wake(exchange.stop, [this] {
            const std::lock_guard lock(m_mutex);
            m_changed.notify_all();
        });
        std::unique_lock lock(m_mutex);
        ++m_exchanges;
        if (m_action && m_exchanges >= m_callTurn)
            std::exchange(m_action, nullptr)();
        if (m_turn > 0 && m_exchanges >= m_turn) {
            m_mode = m_modeAfterTurn;
            m_turn = 0;
        }
        if (m_mode == Mode::Gone)
            return fail(m_whenGone);
        if (m_mode == Mode::Open)
            return {};
        ++m_waiting;
        m_mostAtOnce = std::max(m_mostAtOnce, m_waiting);
        const bool ended = m_changed.wait_for(lock, exchange.timeout, [&] {
            return m_mode == Mode::Open
                || (m_mode == Mode::Silent && exchange.stop.stop_requested());
        });
        --m_waiting;
        if (ended && m_mode != Mode::Open)
            return fail(ErrorCode::Cancelled);
        if (ended)
            return {};
        ++m_timeouts;
        return fail(ErrorCode::Timeout, {{"endpoint", Verbatim{"test:"}}, {"seconds", 1}});
    }
    [[nodiscard]] Result<void> passUpload(const Exchange& exchange)
    {
        const std::stop_callback wake(exchange.stop, [this] {
            const std::lock_guard lock(m_mutex);
            m_changed.notify_all();
        });
        std::unique_lock lock(m_mutex);
        if (m_holdsUploads && exchange.progress)
            exchange.progress(62, 100);
        m_changed.wait(lock, [&] { return !m_holdsUploads || exchange.stop.stop_requested(); });
        if (m_holdsUploads)
            return fail(ErrorCode::Cancelled);
        if (m_refusal)
            return fail(*m_refusal);
        return {};
    }

private:
    const Error m_whenGone{ErrorCode::NotConnected,
        {{"endpoint", Verbatim{"test:"}}, {"reason", Verbatim{"no drive"}}}, {}};
    mutable std::mutex m_mutex;
    std::condition_variable m_changed;
    bool m_holdsUploads = false;
    std::optional<Error> m_refusal;
    Mode m_mode = Mode::Open;
    Mode m_modeAfterTurn = Mode::Open;
    int m_turn = 0;
    std::function<void()> m_action;
    int m_callTurn = 0;
    int m_exchanges = 0;
    int m_waiting = 0;
    int m_timeouts = 0;
    int m_mostAtOnce = 0;
};

/// A link through a gate to anything that is a link itself. Reports its own beginning and end.
class GateLink final : public DriveLink {
public:
    GateLink(std::unique_ptr<DriveLink> link, DriveGate& gate,
        std::function<void(QThread* made, QThread* destroyed)> ended = {},
        std::string endpoint = "test:")
        : m_link(std::move(link))
        , m_gate(gate)
        , m_endpoint(std::move(endpoint))
        , m_made(QThread::currentThread())
        , m_ended(std::move(ended))
    {
    }
    ~GateLink() override
    {
        if (m_ended)
            m_ended(m_made, QThread::currentThread());
    }

    [[nodiscard]] std::string endpoint() const override { return m_endpoint; }
    [[nodiscard]] Result<DriveIdentity> identify(const Exchange& exchange) override
    {
        return pass(exchange, [&] { return m_link->identify(exchange); });
    }
    [[nodiscard]] Result<std::vector<RegisterReading>> readRegisters(
        std::span<const std::string> paths, const Exchange& exchange) override
    {
        return pass(exchange, [&] { return m_link->readRegisters(paths, exchange); });
    }
    [[nodiscard]] Result<std::vector<RegisterReading>> readTree(
        const std::string& prefix, const Exchange& exchange) override
    {
        return pass(exchange, [&] { return m_link->readTree(prefix, exchange); });
    }
    [[nodiscard]] Result<void> writeRegisters(
        std::span<const RegisterWrite> writes, const Exchange& exchange) override
    {
        return pass(exchange, [&] { return m_link->writeRegisters(writes, exchange); });
    }
    [[nodiscard]] Result<std::vector<DriveFile>> listFiles(const Exchange& exchange) override
    {
        return pass(exchange, [&] { return m_link->listFiles(exchange); });
    }
    [[nodiscard]] Result<Bytes> download(const std::string& path, const Exchange& exchange) override
    {
        return pass(exchange, [&] { return m_link->download(path, exchange); });
    }
    [[nodiscard]] Result<void> upload(
        const std::string& path, ByteView bytes, const Exchange& exchange) override
    {
        if (auto open = m_gate.passUpload(exchange); !open)
            return open;
        return pass(exchange, [&] { return m_link->upload(path, bytes, exchange); });
    }

private:
    template <typename Call>
    auto pass(const Exchange& exchange, const Call& call) -> decltype(call())
    {
        if (auto open = m_gate.pass(exchange); !open)
            return fail(open.error());
        return call();
    }

    std::unique_ptr<DriveLink> m_link;
    DriveGate& m_gate;
    std::string m_endpoint;
    QThread* m_made;
    std::function<void(QThread*, QThread*)> m_ended;
};

} // namespace axiscomp::test
