// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivecomm/virtualdrive/firmware/virtual_drive.h"

#include <condition_variable>
#include <mutex>
#include <optional>

namespace axiscomp::test {

/// What a test does to the way between the page and a drive, from its own thread.
class Gate {
public:
    /// Uploads stop half-way until release(), or until they are stopped.
    void holdUploads()
    {
        const std::lock_guard lock(m_mutex);
        m_holdsUploads = true;
    }
    void release()
    {
        const std::lock_guard lock(m_mutex);
        m_holdsUploads = false;
        m_changed.notify_all();
    }
    /// No exchange gets through.
    void cut(bool isCut)
    {
        const std::lock_guard lock(m_mutex);
        m_isCut = isCut;
    }
    /// The drive answers every upload with this error.
    void refuseUploads(std::optional<Error> error)
    {
        const std::lock_guard lock(m_mutex);
        m_refusal = std::move(error);
    }

    [[nodiscard]] Result<void> pass() const
    {
        const std::lock_guard lock(m_mutex);
        if (m_isCut)
            return fail(ErrorCode::ConnectionLost,
                {{"endpoint", "http://192.168.1.20"}, {"reason", "Connection closed"}});
        return {};
    }
    [[nodiscard]] Result<void> passUpload(const Exchange& exchange)
    {
        const std::stop_callback wake(exchange.stop, [this] { m_changed.notify_all(); });
        std::unique_lock lock(m_mutex);
        if (m_holdsUploads && exchange.progress)
            exchange.progress(62, 100);
        m_changed.wait(lock, [&] { return !m_holdsUploads || exchange.stop.stop_requested(); });
        if (exchange.stop.stop_requested())
            return fail(ErrorCode::Cancelled);
        if (m_refusal)
            return fail(*m_refusal);
        return {};
    }

private:
    mutable std::mutex m_mutex;
    std::condition_variable m_changed;
    bool m_holdsUploads = false;
    bool m_isCut = false;
    std::optional<Error> m_refusal;
};

/// A link to a virtual drive in this process, through a gate.
class GatedLink final : public DriveLink {
public:
    GatedLink(drivecomm::VirtualDrive& drive, Gate& gate)
        : m_gate(gate)
        , m_inner(drivecomm::makeDirectLink(drive))
    {
    }

    [[nodiscard]] std::string endpoint() const override { return "http://192.168.1.20"; }
    [[nodiscard]] Result<DriveIdentity> identify(const Exchange& exchange) override
    {
        return pass<DriveIdentity>([&] { return m_inner->identify(exchange); });
    }
    [[nodiscard]] Result<std::vector<RegisterReading>> readRegisters(
        std::span<const std::string> paths, const Exchange& exchange) override
    {
        return pass<std::vector<RegisterReading>>(
            [&] { return m_inner->readRegisters(paths, exchange); });
    }
    [[nodiscard]] Result<std::vector<RegisterReading>> readTree(
        const std::string& prefix, const Exchange& exchange) override
    {
        return pass<std::vector<RegisterReading>>(
            [&] { return m_inner->readTree(prefix, exchange); });
    }
    [[nodiscard]] Result<void> writeRegisters(
        std::span<const RegisterWrite> writes, const Exchange& exchange) override
    {
        return pass<void>([&] { return m_inner->writeRegisters(writes, exchange); });
    }
    [[nodiscard]] Result<std::vector<DriveFile>> listFiles(const Exchange& exchange) override
    {
        return pass<std::vector<DriveFile>>([&] { return m_inner->listFiles(exchange); });
    }
    [[nodiscard]] Result<Bytes> download(const std::string& path, const Exchange& exchange) override
    {
        return pass<Bytes>([&] { return m_inner->download(path, exchange); });
    }
    [[nodiscard]] Result<void> upload(
        const std::string& path, ByteView bytes, const Exchange& exchange) override
    {
        if (auto open = m_gate.passUpload(exchange); !open)
            return open;
        return pass<void>([&] { return m_inner->upload(path, bytes, exchange); });
    }

private:
    template <typename T> Result<T> pass(const std::function<Result<T>()>& call)
    {
        if (auto open = m_gate.pass(); !open)
            return fail(open.error());
        return call();
    }

    Gate& m_gate;
    std::unique_ptr<DriveLink> m_inner;
};

} // namespace axiscomp::test
