// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/link_factory.h"

#include "drivecomm/serial/serial_drive_link.h"
#include "drivecomm/virtualdrive/firmware/virtual_drive.h"
#include "drivecomm/web/web_drive_link.h"

namespace axiscomp::drivecomm {

namespace {

/// A link with the drive that it leads to.
class DemoLink final : public DriveLink {
public:
    explicit DemoLink(const DriveProfile& profile)
        : m_drive(profile, demoDriveOptions())
        , m_link(makeDirectLink(m_drive))
    {
    }

    [[nodiscard]] Result<void> loadState() { return loadDemoState(m_drive); }

    std::string endpoint() const override { return m_link->endpoint(); }
    Result<DriveIdentity> identify(const Exchange& exchange) override
    {
        return m_link->identify(exchange);
    }
    Result<std::vector<RegisterReading>> readRegisters(
        std::span<const std::string> paths, const Exchange& exchange) override
    {
        return m_link->readRegisters(paths, exchange);
    }
    Result<std::vector<RegisterReading>> readTree(
        const std::string& prefix, const Exchange& exchange) override
    {
        return m_link->readTree(prefix, exchange);
    }
    Result<void> writeRegisters(
        std::span<const RegisterWrite> writes, const Exchange& exchange) override
    {
        return m_link->writeRegisters(writes, exchange);
    }
    Result<std::vector<DriveFile>> listFiles(const Exchange& exchange) override
    {
        return m_link->listFiles(exchange);
    }
    Result<Bytes> download(const std::string& path, const Exchange& exchange) override
    {
        return m_link->download(path, exchange);
    }
    Result<void> upload(const std::string& path, ByteView bytes, const Exchange& exchange) override
    {
        return m_link->upload(path, bytes, exchange);
    }

private:
    VirtualDrive m_drive;
    std::unique_ptr<DriveLink> m_link;
};

} // namespace

Result<std::unique_ptr<DriveLink>> makeLink(const DriveEndpoint& endpoint,
    const DriveProfile& profile, const CertificateCheck& certificateCheck)
{
    switch (endpoint.kind) {
    case DriveEndpoint::Kind::Http:
    case DriveEndpoint::Kind::Https:
        return makeWebDriveLink(endpoint, profile, certificateCheck);
    case DriveEndpoint::Kind::Serial:
        return makeSerialDriveLink(endpoint, profile);
    case DriveEndpoint::Kind::Demo:
        break;
    }
    auto demo = std::make_unique<DemoLink>(profile);
    if (auto loaded = demo->loadState(); !loaded)
        return fail(std::move(loaded.error()));
    return demo;
}

LinkFactory linkFactory(const DriveProfile& profile, CertificateCheck certificateCheck)
{
    return [&profile, certificateCheck = std::move(certificateCheck)](
               const std::string& text) -> Result<std::unique_ptr<DriveLink>> {
        const auto endpoint = parseEndpoint(text);
        if (!endpoint)
            return fail(endpoint.error());
        return makeLink(*endpoint, profile, certificateCheck);
    };
}

} // namespace axiscomp::drivecomm
