// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivecomm/virtualdrive/firmware/virtual_drive.h"
#include "drivecomm/virtualdrive/web/html.h"
#include "drivecomm/virtualdrive/web/message.h"
#include "drivecomm/virtualdrive/web/register_page.h"

#include <span>
#include <string>
#include <vector>

namespace axiscomp::drivecomm {

/// Answers the requests of docs/protocol.md ("Web server") from a virtual drive; knows nothing of
/// sockets. May be called from several threads.
class RequestHandler {
public:
    RequestHandler(VirtualDrive& drive, const DriveProfile& profile)
        : m_drive(drive)
        , m_profile(profile)
    {
    }

    [[nodiscard]] WebReply answer(const WebRequest& request) const;
    /// An error as JSON or as a page, whichever the client wants.
    [[nodiscard]] WebReply refusal(const WebRequest& request, const Error& error) const;
    [[nodiscard]] WebReply refusal(const WebRequest& request, const Error& error, int status) const;

private:
    [[nodiscard]] PageFrame frame() const;
    [[nodiscard]] Form formFor(const WebRequest& request) const;
    [[nodiscard]] bool isRegisterPath(const std::string& path) const;

    [[nodiscard]] WebReply showStart(const WebRequest& request) const;
    [[nodiscard]] WebReply showDirectory(const WebRequest& request) const;
    [[nodiscard]] WebReply showTransfer() const;
    [[nodiscard]] WebReply transfer(const WebRequest& request) const;
    [[nodiscard]] WebReply sendFile(const WebRequest& request) const;
    [[nodiscard]] WebReply notAllowed(const WebRequest& request, const std::string& methods) const;

    // register_handler.cpp
    [[nodiscard]] WebReply answerRegisters(const WebRequest& request) const;
    [[nodiscard]] WebReply showRegisters(const WebRequest& request) const;
    [[nodiscard]] WebReply showTree(const WebRequest& request, const std::string& prefix) const;
    [[nodiscard]] WebReply putRegisters(const WebRequest& request) const;
    [[nodiscard]] WebReply setByForm(const WebRequest& request) const;
    [[nodiscard]] Result<RegisterValue> enteredValue(
        const RegisterReading& reading, const std::string& text) const;
    [[nodiscard]] std::vector<RegisterRow> rowsFor(std::span<const RegisterReading> readings) const;
    [[nodiscard]] std::vector<std::string> suggestedSources() const;
    [[nodiscard]] bool isSource(const std::string& path) const;

    VirtualDrive& m_drive;
    const DriveProfile& m_profile;
};

} // namespace axiscomp::drivecomm
