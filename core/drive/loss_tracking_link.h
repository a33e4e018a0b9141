// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/drive/drive_link.h"

#include <atomic>
#include <memory>

namespace axiscomp {

/// A link that notes when the drive was lost, so that its session makes a new one. Once the session
/// is ending, a lost drive is not asked again: what is put back then may take as long as the drive
/// answers, but a drive that hangs is waited for once only.
class GuardedLink final : public DriveLink {
public:
    GuardedLink(std::unique_ptr<DriveLink> link, const std::atomic<bool>& isEnding)
        : m_link(std::move(link))
        , m_isEnding(isEnding)
    {
    }

    [[nodiscard]] bool isLost() const { return m_isLost; }

    [[nodiscard]] std::string endpoint() const override { return m_link->endpoint(); }
    [[nodiscard]] Result<DriveIdentity> identify(const Exchange& exchange) override
    {
        return guarded([&] { return m_link->identify(exchange); });
    }
    [[nodiscard]] Result<std::vector<RegisterReading>> readRegisters(
        std::span<const std::string> paths, const Exchange& exchange) override
    {
        return guarded([&] { return m_link->readRegisters(paths, exchange); });
    }
    [[nodiscard]] Result<std::vector<RegisterReading>> readTree(
        const std::string& prefix, const Exchange& exchange) override
    {
        return guarded([&] { return m_link->readTree(prefix, exchange); });
    }
    [[nodiscard]] Result<void> writeRegisters(
        std::span<const RegisterWrite> writes, const Exchange& exchange) override
    {
        return guarded([&] { return m_link->writeRegisters(writes, exchange); });
    }
    [[nodiscard]] Result<std::vector<DriveFile>> listFiles(const Exchange& exchange) override
    {
        return guarded([&] { return m_link->listFiles(exchange); });
    }
    [[nodiscard]] Result<Bytes> download(const std::string& path, const Exchange& exchange) override
    {
        return guarded([&] { return m_link->download(path, exchange); });
    }
    [[nodiscard]] Result<void> upload(
        const std::string& path, ByteView bytes, const Exchange& exchange) override
    {
        return guarded([&] { return m_link->upload(path, bytes, exchange); });
    }

private:
    template <typename Call> auto guarded(const Call& call) -> decltype(call())
    {
        if (m_isLost && m_isEnding)
            return fail(ErrorCode::NotConnected,
                {{"endpoint", endpoint()},
                    {"reason", AXISCOMP_TEXT("Error", "the program is ending")}});
        auto result = call();
        if (!result && isLinkFailure(result.error().code))
            m_isLost = true;
        return result;
    }

    std::unique_ptr<DriveLink> m_link;
    const std::atomic<bool>& m_isEnding;
    bool m_isLost = false;
};

} // namespace axiscomp
