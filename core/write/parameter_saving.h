// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/register_access.h"
#include "core/write/flash_account.h"

namespace axiscomp {

/// Saves the parameters of all axes. What a reboot brings back are these with the tables that are
/// in flash: so first, where the volatile table of an axis covers another one in flash, that one is
/// deleted; after a reboot the axis has no table then, and never that one with other sources. What
/// has been saved is recorded in the store. counts: what is spent here, and recorded, is added.
[[nodiscard]] Result<void> saveParameters(const RegisterAccess& access, DriveStore& store,
    const DriveIdentity& drive, FlashAccount& flash, EraseCounts& counts);

/// The flash operations that saving costs: the tables that it deletes.
[[nodiscard]] Result<int> costOfSaving(
    const RegisterAccess& access, DriveStore& store, const DriveIdentity& drive);

} // namespace axiscomp
