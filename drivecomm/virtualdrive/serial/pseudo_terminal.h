// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/io/file_descriptor.h"

#include <string>

namespace axiscomp::drivecomm {

/// A serial port that exists in this computer only: clients open device(), or link, a symbolic link
/// to it; what they write is read from master(). No bit is lost or changed, and no speed is kept.
/// Destroying it looks to the clients as if a cable had been unplugged.
class PseudoTerminal {
public:
    /// link may be empty. A symbolic link that is there is replaced, anything else is not. Errors:
    /// InvalidEndpoint (endpoint = link).
    [[nodiscard]] static Result<PseudoTerminal> open(const std::string& link);
    PseudoTerminal(PseudoTerminal&& other) noexcept = default;
    PseudoTerminal& operator=(PseudoTerminal&& other) noexcept;
    ~PseudoTerminal();

    [[nodiscard]] const FileDescriptor& master() const { return m_master; } ///< non-blocking
    /// What was written to master() and no client has read is lost.
    void discardUnread() const;
    [[nodiscard]] const std::string& device() const { return m_device; } ///< /dev/pts/N

private:
    PseudoTerminal() = default;
    void removeLink() const;

    FileDescriptor m_master;
    FileDescriptor m_slave; ///< keeps the terminal as it is while no client has it open
    std::string m_device;
    std::string m_link;
};

} // namespace axiscomp::drivecomm
