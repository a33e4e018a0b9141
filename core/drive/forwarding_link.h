// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/drive_link.h"

#include <memory>
#include <utility>

namespace axiscomp {

/// Hands each exchange with a drive to another link. Derived says what happens around it:
/// `around(exchange, call)` gives what call(exchange), or another exchange, gives, or an error.
template <typename Derived> class ForwardingLink : public DriveLink {
public:
    explicit ForwardingLink(std::unique_ptr<DriveLink> link) : m_link(std::move(link)) { }

    [[nodiscard]] std::string endpoint() const override { return m_link->endpoint(); }
    [[nodiscard]] Result<DriveIdentity> identify(const Exchange& exchange) override
    {
        return derived().around(
            exchange, [&](const Exchange& own) { return m_link->identify(own); });
    }
    [[nodiscard]] Result<std::vector<RegisterReading>> readRegisters(
        std::span<const std::string> paths, const Exchange& exchange) override
    {
        return derived().around(
            exchange, [&](const Exchange& own) { return m_link->readRegisters(paths, own); });
    }
    [[nodiscard]] Result<std::vector<RegisterReading>> readTree(
        const std::string& prefix, const Exchange& exchange) override
    {
        return derived().around(
            exchange, [&](const Exchange& own) { return m_link->readTree(prefix, own); });
    }
    [[nodiscard]] Result<void> writeRegisters(
        std::span<const RegisterWrite> writes, const Exchange& exchange) override
    {
        return derived().around(
            exchange, [&](const Exchange& own) { return m_link->writeRegisters(writes, own); });
    }
    [[nodiscard]] Result<std::vector<DriveFile>> listFiles(const Exchange& exchange) override
    {
        return derived().around(
            exchange, [&](const Exchange& own) { return m_link->listFiles(own); });
    }
    [[nodiscard]] Result<Bytes> download(const std::string& path, const Exchange& exchange) override
    {
        return derived().around(
            exchange, [&](const Exchange& own) { return m_link->download(path, own); });
    }
    [[nodiscard]] Result<void> upload(
        const std::string& path, ByteView bytes, const Exchange& exchange) override
    {
        return derived().around(
            exchange, [&](const Exchange& own) { return m_link->upload(path, bytes, own); });
    }

private:
    [[nodiscard]] Derived& derived() { return static_cast<Derived&>(*this); }

    std::unique_ptr<DriveLink> m_link;
};

} // namespace axiscomp
