// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/register_access.h"

namespace axiscomp {

/// Writes registers so that afterwards it is known whether they took effect: an answer that did not
/// come is replaced by reading back, and a request that did not arrive is sent once more. Only for
/// writes that may be repeated: values, and commands that do nothing the second time (commands are
/// not read back). Nothing is read back from, or sent once more to, another drive than the access
/// expects: OtherDrive.
[[nodiscard]] Result<void> writeVerified(const RegisterAccess& access,
    const std::vector<RegisterWrite>& values, const std::vector<RegisterWrite>& commands = {});

/// VerifyMismatch when a register does not hold what it should.
[[nodiscard]] Result<void> compareRegisters(
    const RegisterAccess& access, const std::vector<RegisterWrite>& wanted);

/// VerifyMismatch with the first offset where a file differs.
[[nodiscard]] Result<void> compareFiles(const std::string& path, ByteView found, ByteView expected);

/// Puts a file there and reads it back, byte by byte. progress: "upload" or "verify", 0 .. 1 over
/// both.
[[nodiscard]] Result<void> uploadVerified(const RegisterAccess& access, const std::string& path,
    ByteView bytes, const std::function<void(std::string_view, double)>& progress = {});

/// Parameters survive a reboot from here on.
[[nodiscard]] Result<void> saveParameters(const RegisterAccess& access);

/// Empties a slot in RAM and flash, and looks whether it is empty: VerifyMismatch when it is not.
[[nodiscard]] Result<void> deleteTable(const RegisterAccess& access, std::string_view slot);
[[nodiscard]] Result<bool> isSlotEmpty(const RegisterAccess& access, std::string_view slot);
/// VerifyMismatch when the slot holds a table.
[[nodiscard]] Result<void> checkEmpty(const RegisterAccess& access, std::string_view slot);

} // namespace axiscomp
