// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivecomm/profile/profile_loader.h"
#include "drivecomm/serial/serial_drive_link.h"
#include "drivecomm/virtualdrive/serial/serial_server.h"
#include "drivecomm/virtualdrive/web/socket.h"
#include "drivecomm/virtualdrive/web/web_server.h"
#include "drivecomm/web/web_drive_link.h"
#include "tests/support/link_attachment.h"

#include <QTemporaryDir>

#include <fcntl.h>

namespace axiscomp::test {

/// Over the drive's web server, on loopback.
class Web final : public LinkAttachment {
public:
    Web(drivecomm::VirtualDrive& drive, drivecomm::FaultPlan& faults)
        : m_server(drivecomm::WebServer::start(drive, drivecomm::genericProfile(), faults).value())
    {
    }
    std::string url() const override { return m_server->url(); }
    DriveLink& link() override
    {
        if (!m_link)
            m_link = drivecomm::makeWebDriveLink(
                drivecomm::parseEndpoint(url()).value(), drivecomm::genericProfile());
        return *m_link;
    }

private:
    std::unique_ptr<drivecomm::WebServer> m_server;
    std::unique_ptr<DriveLink> m_link;
};

/// Over the drive's serial link, on a pseudo-terminal.
class Serial final : public LinkAttachment {
public:
    Serial(drivecomm::VirtualDrive& drive, drivecomm::FaultPlan& faults)
        : m_faults(faults)
        , m_server(drivecomm::SerialServer::start(drive, faults, {linkIn(m_folder), 0}).value())
        , m_port(::open(m_server->device().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC))
    {
    }
    std::string url() const override { return m_server->url(); }
    DriveLink& link() override
    {
        if (!m_link) {
            m_link = drivecomm::makeSerialDriveLink(
                drivecomm::parseEndpoint(url()).value(), drivecomm::genericProfile());
            // The first request of a connection finds the drive, and is not one of those that tests
            // count.
            (void)m_link->identify({});
            m_faults.clear();
        }
        return *m_link;
    }

private:
    /// A port that was cut comes back under the same link.
    static std::string linkIn(const QTemporaryDir& folder)
    {
        return folder.filePath(QStringLiteral("drive")).toStdString();
    }

    drivecomm::FaultPlan& m_faults;
    QTemporaryDir m_folder;
    std::unique_ptr<drivecomm::SerialServer> m_server;
    /// Held, so that a port that was cut off is nobody else's until the link has let it go: the
    /// lock of a port goes by its name.
    FileDescriptor m_port;
    std::unique_ptr<DriveLink> m_link;
};

inline AttachmentKind web()
{
    AttachmentKind kind = attachmentKind<Web>("web");
    kind.servesInOrder = false;
    return kind;
}

inline AttachmentKind serial()
{
    AttachmentKind kind = attachmentKind<Serial>("serial");
    kind.writesAtOnce = 8;
    kind.asksAgain = true;
    return kind;
}

} // namespace axiscomp::test
