// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/direct_link.h"

#include <algorithm>

namespace axiscomp::drivecomm {

namespace {

class DirectLink final : public DriveLink {
public:
    DirectLink(VirtualDrive& drive, FaultPlan* faults) : m_drive(drive), m_faults(faults) { }

    [[nodiscard]] std::string endpoint() const override { return "demo:"; }

    [[nodiscard]] Result<DriveIdentity> identify(const Exchange& exchange) override
    {
        return request(exchange, 0, [&]() -> Result<DriveIdentity> { return m_drive.identity(); });
    }

    [[nodiscard]] Result<std::vector<RegisterReading>> readRegisters(
        std::span<const std::string> paths, const Exchange& exchange) override
    {
        std::vector<RegisterReading> all;
        do {
            const auto part = paths.first(std::min(paths.size(), maximumReads));
            paths = paths.subspan(part.size());
            auto read = request(exchange, 0, [&] {
                return m_drive.readRegisters({part.begin(), part.end()});
            });
            if (!read)
                return read;
            all.insert(all.end(), read->begin(), read->end());
        } while (!paths.empty());
        return all;
    }

    [[nodiscard]] Result<std::vector<RegisterReading>> readTree(
        const std::string& prefix, const Exchange& exchange) override
    {
        return request(exchange, 0,
            [&]() -> Result<std::vector<RegisterReading>> { return m_drive.readTree(prefix); });
    }

    [[nodiscard]] Result<void> writeRegisters(
        std::span<const RegisterWrite> writes, const Exchange& exchange) override
    {
        return request(
            exchange, 0,
            [&] {
                return m_drive.writeRegisters({writes.begin(), writes.end()});
            },
            true);
    }

    [[nodiscard]] Result<std::vector<DriveFile>> listFiles(const Exchange& exchange) override
    {
        return request(
            exchange, 0, [&]() -> Result<std::vector<DriveFile>> { return m_drive.listFiles(); });
    }

    [[nodiscard]] Result<Bytes> download(const std::string& path, const Exchange& exchange) override
    {
        auto bytes = request(exchange, 0, [&] { return m_drive.download(path); });
        if (bytes)
            report(exchange, bytes->size());
        return bytes;
    }

    [[nodiscard]] Result<void> upload(
        const std::string& path, ByteView bytes, const Exchange& exchange) override
    {
        auto result = request(
            exchange, bytes.size(), [&] { return m_drive.upload(path, bytes); }, true);
        if (result)
            report(exchange, bytes.size());
        return result;
    }

private:
    static void report(const Exchange& exchange, std::uint64_t size)
    {
        if (exchange.progress)
            exchange.progress(size, size);
    }

    [[nodiscard]] tl::unexpected<Error> lost(Text reason) const
    {
        return fail(
            ErrorCode::ConnectionLost, {{"endpoint", endpoint()}, {"reason", std::move(reason)}});
    }
    [[nodiscard]] tl::unexpected<Error> late(const Exchange& exchange) const
    {
        return fail(ErrorCode::Timeout,
            {{"endpoint", endpoint()},
                {"seconds", std::chrono::ceil<std::chrono::seconds>(exchange.timeout).count()}});
    }

    /// True when the connection is cut before the drive has the whole request.
    [[nodiscard]] bool isCut(std::uint64_t size)
    {
        constexpr std::uint64_t overhead = 200; // about that of a request line and headers
        const auto left = m_faults->bytesUntilDrop();
        m_faults->countBytes(size + overhead);
        return left && *left <= size + overhead;
    }

    template <typename Function>
    auto request(const Exchange& exchange, std::uint64_t size, Function call, bool isWrite = false)
        -> decltype(call())
    {
        if (exchange.stop.stop_requested())
            return fail(ErrorCode::Cancelled);
        if (m_faults == nullptr)
            return call();
        if (isCut(size))
            return lost(AXISCOMP_TEXT("Error", "the connection was cut"));
        const FaultPlan::Decision decision = m_faults->next(isWrite);
        if (decision.rejectCode)
            return fail(errorAskedFor(*decision.rejectCode));
        if (decision.storeWrong)
            m_drive.storeNextWrong();
        auto result = call();
        if (decision.reboot) {
            m_drive.reboot();
            return lost(AXISCOMP_TEXT("Error", "the drive rebooted"));
        }
        if (decision.noReply || decision.delay >= exchange.timeout)
            return late(exchange);
        if (decision.garble)
            return fail(ErrorCode::Protocol,
                {{"endpoint", endpoint()}, {"expected", AXISCOMP_TEXT("Error", "a reply")},
                    {"quote", AXISCOMP_TEXT("Error", "flipped bytes")}});
        return result;
    }

    VirtualDrive& m_drive;
    FaultPlan* m_faults;
};

} // namespace

std::unique_ptr<DriveLink> makeDirectLink(VirtualDrive& drive, FaultPlan* faults)
{
    return std::make_unique<DirectLink>(drive, faults);
}

} // namespace axiscomp::drivecomm
