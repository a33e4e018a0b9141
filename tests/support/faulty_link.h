// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivecomm/virtualdrive/virtual_drive.h"

#include <functional>
#include <optional>

namespace axiscomp::test {

/// What goes wrong at one exchange.
enum class LinkFault {
    RequestLost, ///< not carried out, the connection breaks
    ReplyLost, ///< carried out, no answer
    ReplyGarbled, ///< carried out, the answer is nonsense
    Refused, ///< not carried out, the drive says no
    DriveGone, ///< not carried out, and nothing from here on
    DriveGoneAfter, ///< carried out, but from here on there is no drive
    Reboot, ///< the drive restarts instead of answering
    StoresWrong, ///< the drive says yes and keeps something else
    UserStops, ///< the user's stop comes with this exchange
};

/// A link to a virtual drive that fails at one chosen exchange.
class FaultyLink final : public DriveLink {
public:
    explicit FaultyLink(drivecomm::VirtualDrive& drive)
        : m_drive(drive)
        , m_inner(drivecomm::makeDirectLink(drive))
    {
    }

    /// number counts from 1.
    void failAt(int number, LinkFault fault)
    {
        m_failAt = m_exchanges + number;
        m_fault = fault;
    }
    void heal()
    {
        m_failAt.reset();
        m_isGone = false;
    }
    [[nodiscard]] int exchanges() const { return m_exchanges; }
    std::function<void()> stopUser;

    [[nodiscard]] std::string endpoint() const override { return "test:"; }
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
        return pass<void>([&] { return m_inner->upload(path, bytes, exchange); });
    }

private:
    static tl::unexpected<Error> lost()
    {
        return fail(ErrorCode::ConnectionLost, {{"endpoint", "test:"}, {"reason", "cut"}});
    }
    static tl::unexpected<Error> gone()
    {
        return fail(ErrorCode::NotConnected, {{"endpoint", "test:"}, {"reason", "no drive"}});
    }

    template <typename T> Result<T> pass(const std::function<Result<T>()>& call)
    {
        ++m_exchanges;
        if (m_isGone)
            return gone();
        if (m_failAt != m_exchanges)
            return call();
        switch (m_fault) {
        case LinkFault::RequestLost:
            return lost();
        case LinkFault::ReplyLost:
            (void)call();
            return fail(ErrorCode::Timeout, {{"endpoint", "test:"}, {"seconds", "0"}});
        case LinkFault::ReplyGarbled:
            (void)call();
            return fail(ErrorCode::Protocol,
                {{"endpoint", "test:"}, {"expected", "an answer"}, {"quote", "%$!"}});
        case LinkFault::Refused:
            return fail(ErrorCode::DriveRejected, {{"reason", "no"}});
        case LinkFault::DriveGone:
            m_isGone = true;
            return gone();
        case LinkFault::DriveGoneAfter:
            (void)call();
            m_isGone = true;
            return lost();
        case LinkFault::Reboot:
            m_drive.reboot();
            return lost();
        case LinkFault::StoresWrong:
            m_drive.storeNextWrong();
            return call();
        case LinkFault::UserStops:
            stopUser();
            return call();
        }
        return call();
    }

    drivecomm::VirtualDrive& m_drive;
    std::unique_ptr<DriveLink> m_inner;
    std::optional<int> m_failAt;
    LinkFault m_fault = LinkFault::RequestLost;
    int m_exchanges = 0;
    bool m_isGone = false;
};

} // namespace axiscomp::test
