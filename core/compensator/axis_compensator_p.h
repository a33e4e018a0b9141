// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/register_access.h"
#include "core/axis/source_directory.h"
#include "core/compensator/axis_compensator.h"

#include <span>

namespace axiscomp {

struct AxisWrite;
struct PreparedWrite;
class UnfinishedWrite;

struct AxisCompensator::Private {
    DriveLink& link;
    const DriveProfile& profile;
    DriveStore& store;
    std::function<WallTime()> clock;
    SourceDirectory sources;
    /// Tells this instance, and with it the link, from every other one.
    std::shared_ptr<const int> connection = std::make_shared<const int>(0);

    [[nodiscard]] RegisterAccess access(const OperationOptions& options) const
    {
        return RegisterAccess(link, profile, options);
    }

    [[nodiscard]] Result<DriveIdentity> identify(const RegisterAccess& access)
    {
        auto drive = access.identify();
        if (drive)
            sources.useDrive(*drive);
        return drive;
    }

    /// Errors: AxisNotFound.
    [[nodiscard]] Result<DriveIdentity> identify(const RegisterAccess& access, int axis)
    {
        auto drive = identify(access);
        if (drive && (axis < 0 || axis >= drive->axes))
            return fail(ErrorCode::AxisNotFound,
                {{"axis", axis},
                    {"known",
                        AXISCOMP_TEXT("Error", "{number} to {number2}")
                            .with("number", 0)
                            .with("number2", drive->axes - 1)}});
        return drive;
    }

    /// Whether it is the drive that was planned for, where it is said. Errors: OtherDrive.
    [[nodiscard]] static Result<void> checkExpected(
        const DriveIdentity& drive, std::optional<std::int32_t> serialNumber)
    {
        if (!serialNumber || *serialNumber == drive.serialNumber)
            return {};
        return fail(
            ErrorCode::OtherDrive, {{"expected", *serialNumber}, {"found", drive.serialNumber}});
    }

    /// Errors: AxisNotFound, OtherDrive.
    [[nodiscard]] Result<DriveIdentity> identify(
        const RegisterAccess& access, const JournalEntry& entry);
    /// An unfinished write that is still the one of the journal, with the write lock held.
    struct ResumedWrite;
    [[nodiscard]] Result<ResumedWrite> resume(
        const RegisterAccess& access, const JournalEntry& entry);

    /// Whether it is known what the compensation does now.
    [[nodiscard]] bool withdraw(
        const AxisStatus& before, Activation& activation, const RegisterAccess& access);
    void putBack(const AxisStatus& before, Activation& activation, const RegisterAccess& access);

    [[nodiscard]] Result<void> checkFlash(const DriveIdentity& drive, int operations, int reserve);

    /// isUnfinished: an earlier write did not end, and the next one ends it.
    [[nodiscard]] Result<PreparedWrite> prepare(const RegisterAccess& access,
        const DriveIdentity& drive, int axis, const WriteRequest& request, bool isUnfinished);

    // With the write lock held.
    [[nodiscard]] Result<WriteReport> write(const RegisterAccess& access,
        const DriveIdentity& drive, int axis, const WriteRequest& request);
    struct PreparedFinish;
    [[nodiscard]] Result<PreparedFinish> prepareFinish(const RegisterAccess& access,
        const DriveIdentity& drive, const UnfinishedWrite& unfinished);
    /// Errors: UnknownFile.
    [[nodiscard]] Result<TableSlot> slotOf(const AxisBackup::File& file) const;
    /// Whether the drive did not have exactly this file already.
    [[nodiscard]] Result<bool> restoreFile(
        const RegisterAccess& access, const DriveIdentity& drive, const AxisBackup::File& file);
    [[nodiscard]] Result<PlannedFile> planFile(
        const RegisterAccess& access, const DriveIdentity& drive, const AxisBackup::File& file);
    /// turn: which axis or, after these, which file is being written.
    [[nodiscard]] Result<RestoreReport> restoreAll(const RegisterAccess& access,
        const DriveIdentity& drive, std::span<const AxisWrite> writes,
        std::span<const WritePlan> plans, const std::vector<AxisBackup::File>& files,
        std::size_t& turn);
    [[nodiscard]] Result<void> checkRestored(const RegisterAccess& access,
        const DriveIdentity& drive, const std::vector<AxisStatus>& axes,
        const std::vector<AxisBackup::File>& files);
};

} // namespace axiscomp
