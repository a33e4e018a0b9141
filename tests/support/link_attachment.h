// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivecomm/virtualdrive/direct_link.h"

#include <functional>
#include <memory>
#include <string>

namespace axiscomp::test {

/// One way to reach a virtual drive, with whatever serves it.
class LinkAttachment {
public:
    LinkAttachment() = default;
    LinkAttachment(const LinkAttachment&) = delete;
    LinkAttachment& operator=(const LinkAttachment&) = delete;
    virtual ~LinkAttachment() = default;

    /// By which another program reaches the same drive; empty: it cannot.
    [[nodiscard]] virtual std::string url() const { return {}; }
    /// Made by the first call, and used on its thread.
    [[nodiscard]] virtual DriveLink& link() = 0;
};

struct AttachmentKind {
    const char* name;
    std::function<std::unique_ptr<LinkAttachment>(drivecomm::VirtualDrive&, drivecomm::FaultPlan&)>
        attach;
    std::size_t writesAtOnce = DriveLink::maximumWrites;
    /// It can ask again without the drive acting again: what has been garbled arrives all the same.
    bool asksAgain = false;
    /// A request of one client is carried out before the next one of any other.
    bool servesInOrder = true;
};

template <typename Attachment> AttachmentKind attachmentKind(const char* name)
{
    return {name,
        [](drivecomm::VirtualDrive& drive, drivecomm::FaultPlan& faults) {
            return std::make_unique<Attachment>(drive, faults);
        },
        DriveLink::maximumWrites, false};
}

class InProcess final : public LinkAttachment {
public:
    InProcess(drivecomm::VirtualDrive& drive, drivecomm::FaultPlan& faults)
        : m_link(drivecomm::makeDirectLink(drive, &faults))
    {
    }
    DriveLink& link() override { return *m_link; }

private:
    std::unique_ptr<DriveLink> m_link;
};

inline AttachmentKind inProcess()
{
    return attachmentKind<InProcess>("in process");
}

} // namespace axiscomp::test
