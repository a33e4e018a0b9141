// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/profile_loader.h"
#include "drivecomm/virtualdrive/web_front.h"
#include "drivecomm/web_drive_link.h"
#include "tests/drivecomm/link_contract.h"

#include <QCoreApplication>
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

template <typename Attachment> AttachmentKind kind(const char* name)
{
    return {name, [](VirtualDrive& drive, FaultPlan& faults) {
                return std::make_unique<Attachment>(drive, faults);
            }};
}

} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    LinkContract contract({kind<InProcess>("in process"), kind<Web>("web")});
    return QTest::qExec(&contract, argc, argv);
}
