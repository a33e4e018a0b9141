// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/axis_reader.h"
#include "core/axis/slot_state.h"
#include "core/store/drive_store.h"
#include "core/write/flash_account.h"
#include "core/write/write_plan.h"

namespace axiscomp {

/// Puts a file into a slot as it is, with what belongs to every change of a drive: a backup first,
/// a last look for changes of somebody else, verification, the old file back when that fails. The
/// write lock is held by the caller. Used once.
class FileReplacement {
public:
    FileReplacement(const RegisterAccess& access, DriveStore& store, const DriveIdentity& drive,
        std::function<WallTime()> clock, const TableSlot& slot)
        : m_access(access.expecting(drive))
        , m_store(store)
        , m_drive(drive)
        , m_clock(std::move(clock))
        , m_slot(slot)
    {
    }

    /// Flash operations that it needs, and those that putting it back may need beyond them.
    struct Cost {
        int operations = 0;
        int reserve = 0;
        bool isThere = false; ///< the slot holds exactly this already
    };

    /// Whether an axis or a cogging compensation may use the slot, or an axis after a reboot.
    enum class Users { Allowed, Refused };
    /// No bytes: the slot is emptied. Gives the backup, or an empty path when the slot held exactly
    /// this already. Errors: SlotInUse, ChangedMeanwhile, FlashWear, those of DriveLink::upload,
    /// VerifyMismatch, RollbackFailed.
    [[nodiscard]] Result<std::filesystem::path> run(ByteView bytes, Users users);
    /// What run(bytes) costs; changes nothing. Whether the slot is free is seen by run.
    [[nodiscard]] Result<Cost> planReplacement(ByteView bytes);
    /// What emptying the slot costs; changes nothing. Errors: NoTable when it is empty, SlotInUse,
    /// FlashWear.
    [[nodiscard]] Result<SlotDeletion> planDeletion();

private:
    /// The slot and what counts its cycles, at one instant.
    struct Look {
        SlotState state;
        EraseCounts counts;
        int user = -1; ///< an axis whose table this is; -1: none
    };
    [[nodiscard]] Result<Look> look() const;
    [[nodiscard]] Result<void> lookAndRead();
    [[nodiscard]] bool needsFlash(ByteView bytes, const SavedState& saved) const;
    [[nodiscard]] Cost costOf(bool needsFlash) const;
    [[nodiscard]] Result<Cost> check(ByteView bytes, Users users) const;
    [[nodiscard]] Result<void> keepOldFile();
    [[nodiscard]] Result<void> checkUnchanged() const;
    [[nodiscard]] Result<void> checkSavedUse(ByteView bytes) const;
    [[nodiscard]] Error inUse(ByteView bytes, Text user) const;
    [[nodiscard]] Result<void> noteCovering(ByteView bytes, const Cost& cost) const;
    [[nodiscard]] Result<void> put(const RegisterAccess& access, ByteView bytes) const;
    [[nodiscard]] Result<void> confirmDrive() const;
    [[nodiscard]] Error rollBack(const Error& reason) const;

    RegisterAccess m_access;
    DriveStore& m_store;
    const DriveIdentity& m_drive;
    std::function<WallTime()> m_clock;
    const TableSlot& m_slot;
    Look m_seen;
    AxisBackup::File m_old;
    std::filesystem::path m_backup;
};

} // namespace axiscomp
