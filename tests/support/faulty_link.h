// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivecomm/virtualdrive/direct_link.h"

#include <functional>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

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
    Late, ///< no answer in time; carried out all the same, after the next exchange
    ProgramDies, ///< not carried out, and the caller ends here: ProgramDied is thrown
    ProgramDiesAfter, ///< carried out, but the caller does not live to see it
};

/// Thrown through everything that runs, so that nothing of it happens any more, as when a program
/// is killed; what the system lets go of then (locks, connections) is let go of here too.
struct ProgramDied { };

/// A link to a virtual drive, by way of another one, that fails at one chosen exchange.
class FaultyLink final : public DriveLink {
public:
    explicit FaultyLink(drivecomm::VirtualDrive& drive)
        : m_drive(drive)
        , m_owned(drivecomm::makeDirectLink(drive))
        , m_inner(*m_owned)
    {
    }
    /// inner leads to the drive, and outlives this.
    FaultyLink(drivecomm::VirtualDrive& drive, DriveLink& inner)
        : m_drive(drive)
        , m_inner(inner) { }

    /// number counts from 1; 0 is the exchange that is beginning.
    void failAt(int number, LinkFault fault)
    {
        m_failAt = m_exchanges + number;
        m_fault = fault;
    }
    void heal()
    {
        m_failAt.reset();
        m_isGone = false;
        carryOutLate();
    }
    [[nodiscard]] int exchanges() const { return m_exchanges; }
    /// The exchange that was to fail has been reached.
    [[nodiscard]] bool hasFailed() const { return m_failAt && m_exchanges >= *m_failAt; }
    /// Lets somebody else act, once; number counts from 1.
    void actBefore(int number, std::function<void()> act)
    {
        m_actBefore = m_exchanges + number;
        m_act = std::move(act);
    }
    /// The number of the first exchange that could change the drive; 0: there was none.
    [[nodiscard]] int firstChange() const { return m_firstChange; }
    void forgetChange() { m_firstChange = 0; }
    std::function<void()> stopUser;
    /// Changes what a drive says it is, what registers say and files hold on their way from it.
    std::function<void(DriveIdentity&)> altersIdentity;
    std::function<void(RegisterReading&)> altersReading;
    std::function<void(Bytes&)> altersDownload;
    /// The drive says yes to such a write and does nothing.
    std::function<bool(const RegisterWrite&)> ignoresWrite;
    /// Told of every exchange before it begins: "identify", "read", "write", "list", "download",
    /// "upload".
    std::function<void(std::string_view what)> beginning;

    [[nodiscard]] std::string endpoint() const override { return "test:"; }
    [[nodiscard]] Result<DriveIdentity> identify(const Exchange& exchange) override
    {
        return pass<DriveIdentity>("identify", exchange, [this](const Exchange& e) {
            auto identity = m_inner.identify(e);
            if (altersIdentity && identity)
                altersIdentity(*identity);
            return identity;
        });
    }
    [[nodiscard]] Result<std::vector<RegisterReading>> readRegisters(
        std::span<const std::string> paths, const Exchange& exchange) override
    {
        return pass<std::vector<RegisterReading>>("read", exchange,
            [this, own = std::vector(paths.begin(), paths.end())](const Exchange& e) {
                auto readings = m_inner.readRegisters(own, e);
                for (std::size_t i = 0; altersReading && readings && i < readings->size(); ++i)
                    altersReading((*readings)[i]);
                return readings;
            });
    }
    [[nodiscard]] Result<std::vector<RegisterReading>> readTree(
        const std::string& prefix, const Exchange& exchange) override
    {
        return pass<std::vector<RegisterReading>>("read", exchange,
            [this, prefix](const Exchange& e) { return m_inner.readTree(prefix, e); });
    }
    [[nodiscard]] Result<void> writeRegisters(
        std::span<const RegisterWrite> writes, const Exchange& exchange) override
    {
        return pass<void>("write", exchange,
            [this, own = std::vector(writes.begin(), writes.end())](
                const Exchange& e) mutable -> Result<void> {
                const bool isIgnored = ignoresWrite && std::erase_if(own, ignoresWrite) > 0;
                return isIgnored && own.empty() ? Result<void>() : m_inner.writeRegisters(own, e);
            });
    }
    [[nodiscard]] Result<std::vector<DriveFile>> listFiles(const Exchange& exchange) override
    {
        return pass<std::vector<DriveFile>>(
            "list", exchange, [this](const Exchange& e) { return m_inner.listFiles(e); });
    }
    [[nodiscard]] Result<Bytes> download(const std::string& path, const Exchange& exchange) override
    {
        return pass<Bytes>("download", exchange, [this, path](const Exchange& e) {
            auto bytes = m_inner.download(path, e);
            if (altersDownload && bytes)
                altersDownload(*bytes);
            return bytes;
        });
    }
    [[nodiscard]] Result<void> upload(
        const std::string& path, ByteView bytes, const Exchange& exchange) override
    {
        return pass<void>("upload", exchange,
            [this, path, own = Bytes(bytes.begin(), bytes.end())](
                const Exchange& e) { return m_inner.upload(path, own, e); });
    }

private:
    template <typename T> using Call = std::function<Result<T>(const Exchange&)>;

    static tl::unexpected<Error> lost()
    {
        return fail(ErrorCode::ConnectionLost,
            {{"endpoint", Verbatim{"test:"}}, {"reason", Verbatim{"cut"}}});
    }
    static tl::unexpected<Error> gone()
    {
        return fail(ErrorCode::NotConnected,
            {{"endpoint", Verbatim{"test:"}}, {"reason", Verbatim{"no drive"}}});
    }
    static tl::unexpected<Error> late()
    {
        return fail(ErrorCode::Timeout, {{"endpoint", Verbatim{"test:"}}, {"seconds", 0}});
    }

    /// call owns what it needs: it may have to outlive the exchange.
    template <typename T>
    Result<T> pass(std::string_view what, const Exchange& exchange, const Call<T>& call)
    {
        ++m_exchanges;
        if (beginning)
            beginning(what);
        if (m_firstChange == 0 && (what == "write" || what == "upload"))
            m_firstChange = m_exchanges;
        if (m_actBefore == m_exchanges)
            m_act();
        const bool isLateDue = static_cast<bool>(m_late);
        auto result = m_isGone        ? Result<T>(gone())
            : m_failAt == m_exchanges ? failing<T>(exchange, call)
                                      : call(exchange);
        if (isLateDue)
            carryOutLate();
        return result;
    }

    template <typename T> Result<T> failing(const Exchange& exchange, const Call<T>& call)
    {
        switch (m_fault) {
        case LinkFault::RequestLost:
            return lost();
        case LinkFault::ReplyLost:
            (void)call(exchange);
            return late();
        case LinkFault::ReplyGarbled:
            (void)call(exchange);
            return fail(ErrorCode::Protocol,
                {{"endpoint", Verbatim{"test:"}}, {"expected", Verbatim{"an answer"}},
                    {"quote", Verbatim{"%$!"}}});
        case LinkFault::Refused:
            return fail(ErrorCode::DriveRejected, {{"reason", Verbatim{"no"}}});
        case LinkFault::DriveGone:
            m_isGone = true;
            return gone();
        case LinkFault::DriveGoneAfter:
            (void)call(exchange);
            m_isGone = true;
            return lost();
        case LinkFault::Reboot:
            m_drive.reboot();
            return lost();
        case LinkFault::StoresWrong:
            m_drive.storeNextWrong();
            return call(exchange);
        case LinkFault::UserStops:
            stopUser();
            return call(exchange);
        case LinkFault::Late:
            m_late = [call] { (void)call(Exchange{}); };
            return late();
        case LinkFault::ProgramDies:
            throw ProgramDied{};
        case LinkFault::ProgramDiesAfter:
            (void)call(exchange);
            throw ProgramDied{};
        }
        return call(exchange);
    }

    void carryOutLate()
    {
        if (const auto call = std::exchange(m_late, {}))
            call();
    }

    drivecomm::VirtualDrive& m_drive;
    std::unique_ptr<DriveLink> m_owned;
    DriveLink& m_inner;
    std::optional<int> m_failAt;
    LinkFault m_fault = LinkFault::RequestLost;
    std::function<void()> m_late;
    int m_exchanges = 0;
    int m_firstChange = 0;
    std::optional<int> m_actBefore;
    std::function<void()> m_act;
    bool m_isGone = false;
};

} // namespace axiscomp::test
