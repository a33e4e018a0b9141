// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/axis_status.h"
#include "core/axis/register_access.h"
#include "core/base/bytes.h"
#include "core/store/backup.h"

#include <optional>

namespace axiscomp {

/// A slot's file as it is now, which is the table that the drive's registers show; without bytes
/// when the slot is empty. What differs from them is read again. A file that is no table is a
/// damaged one where the registers do not show another: it is taken when it comes twice. Errors:
/// ChangedMeanwhile when it differs the second time too, InvalidTable when the drive shows its
/// positions elsewhere.
[[nodiscard]] Result<AxisBackup::File> readSlotFile(
    const RegisterAccess& access, const TableSlot& slot);

/// A slot's file as it comes, whatever table the registers show; empty when the slot is. Elements
/// whose CRC is not the one that the drive says are read again. Errors: ChangedMeanwhile when they
/// are others then.
[[nodiscard]] Result<Bytes> downloadSlotFile(
    const RegisterAccess& access, const TableSlot& slot, const Exchange& exchange);

/// Whether a drive shows the table of a file: its CRC, where it shows one, and its positions. What
/// is no table in the profile's layout cannot be told by them, and passes.
[[nodiscard]] bool isShownTable(
    const DriveProfile& profile, const std::optional<TableHeader>& shown, ByteView file);

} // namespace axiscomp
