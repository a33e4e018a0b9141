// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/profile_loader.h"
#include "drivecomm/serial_drive_link.h"
#include "drivecomm/virtualdrive/serial_front.h"
#include "drivecomm/virtualdrive/web_front.h"
#include "drivecomm/web_drive_link.h"
#include "tests/drivecomm/link_contract.h"

#include <QCoreApplication>
#include <QTemporaryDir>
#include <QTest>

using namespace axiscomp;
using namespace axiscomp::drivecomm;
using namespace axiscomp::test;

namespace {

class InProcess final : public LinkAttachment {
public:
    InProcess(VirtualDrive& drive, FaultPlan& faults) : m_link(makeDirectLink(drive, &faults)) { }
    DriveLink& link() override { return *m_link; }

private:
    std::unique_ptr<DriveLink> m_link;
};

class Web final : public LinkAttachment {
public:
    Web(VirtualDrive& drive, FaultPlan& faults)
        : m_front(WebFront::start(drive, genericProfile(), faults).value())
        , m_link(makeWebDriveLink(parseEndpoint(m_front->url()).value(), genericProfile()))
    {
    }
    DriveLink& link() override { return *m_link; }

private:
    std::unique_ptr<WebFront> m_front;
    std::unique_ptr<DriveLink> m_link;
};

class Serial final : public LinkAttachment {
public:
    Serial(VirtualDrive& drive, FaultPlan& faults)
        : m_front(SerialFront::start(drive, faults, {linkIn(m_folder), 0}).value())
        , m_link(makeSerialDriveLink(parseEndpoint(m_front->url()).value(), genericProfile()))
    {
        // The first request of a connection finds the drive, and is not one of those that tests
        // count.
        (void)m_link->identify({});
        faults.clear();
    }
    DriveLink& link() override { return *m_link; }

private:
    /// A port that was cut comes back under the same link.
    static std::string linkIn(const QTemporaryDir& folder)
    {
        return folder.filePath(QStringLiteral("drive")).toStdString();
    }

    QTemporaryDir m_folder;
    std::unique_ptr<SerialFront> m_front;
    std::unique_ptr<DriveLink> m_link;
};

template <typename Attachment> AttachmentKind kind(const char* name)
{
    return {name,
        [](VirtualDrive& drive, FaultPlan& faults) {
            return std::make_unique<Attachment>(drive, faults);
        },
        DriveLink::maximumWrites, false};
}

} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    AttachmentKind serial = kind<Serial>("serial");
    serial.writesAtOnce = 8;
    serial.asksAgain = true;
    LinkContract contract({kind<InProcess>("in process"), kind<Web>("web"), serial});
    return QTest::qExec(&contract, argc, argv);
}
