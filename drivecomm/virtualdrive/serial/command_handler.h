// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bytes.h"
#include "drivecomm/virtualdrive/firmware/virtual_drive.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace axiscomp::drivecomm {

/// The lines of a reply, without number and CRC.
using SerialReplyLines = std::vector<std::string>;

/// Answers the requests of docs/protocol.md ("Serial link") from a virtual drive; knows nothing of
/// lines on a wire. words[0] is the request.
class CommandHandler {
public:
    explicit CommandHandler(VirtualDrive& drive) : m_drive(drive) { }

    [[nodiscard]] static bool isWrite(const std::vector<std::string>& words);
    [[nodiscard]] SerialReplyLines answer(const std::vector<std::string>& words) const;

    struct Put {
        std::string path;
        std::uint32_t size = 0;
        std::uint32_t crc = 0;
        std::uint32_t limit = 0; ///< of the slot
    };
    /// Before anything is transferred: is there such a file, and does it hold so much?
    [[nodiscard]] Result<Put> beginPut(const std::vector<std::string>& words) const;
    /// What arrived. A file that is not the announced one is not stored.
    [[nodiscard]] SerialReplyLines endPut(const Put& put, ByteView file) const;
    [[nodiscard]] Result<Bytes> take(const std::vector<std::string>& words) const;
    /// boot "NAME" SERIAL
    [[nodiscard]] std::string bootLine() const;

    [[nodiscard]] static SerialReplyLines garbled(const std::string& message);
    [[nodiscard]] static SerialReplyLines refused(const Error& error);
    [[nodiscard]] static SerialReplyLines rejected(Text reason);

private:
    [[nodiscard]] Result<SerialReplyLines> get(std::span<const std::string> paths) const;
    [[nodiscard]] Result<SerialReplyLines> addresses(std::span<const std::string> paths) const;
    [[nodiscard]] Result<void> set(std::span<const std::string> words) const;
    [[nodiscard]] Result<SerialReplyLines> tree(std::span<const std::string> words) const;
    [[nodiscard]] SerialReplyLines list() const;
    [[nodiscard]] Result<std::vector<RegisterReading>> read(
        std::span<const std::string> paths) const;

    VirtualDrive& m_drive;
};

} // namespace axiscomp::drivecomm
