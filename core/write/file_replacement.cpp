// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/write/file_replacement.h"

#include "core/axis/verified_transfer.h"
#include "core/table/tam_table.h"
#include "core/write/restored_axis.h"
#include "core/write/slot_file.h"

#include <algorithm>

namespace axiscomp {

namespace {

constexpr int noAxis = -1;

bool isPersistent(ByteView file, const TableLayout& layout)
{
    const auto decoded = decodeTamTable(file, layout);
    return decoded && decoded->persistent;
}

std::uint32_t elementCrc(ByteView file, const TableLayout& layout)
{
    const auto decoded = decodeTamTable(file, layout);
    return decoded ? crc32(file.last(decoded->table.values.size() * sizeof(float))) : 0;
}

} // namespace

Result<std::filesystem::path> FileReplacement::run(ByteView bytes, Users users)
{
    AXISCOMP_CHECK(lookAndRead());
    if (std::ranges::equal(m_old.bytes, bytes))
        return std::filesystem::path();
    AXISCOMP_TRY(const Cost cost, check(bytes, users));
    AXISCOMP_CHECK(keepOldFile());
    AXISCOMP_CHECK(checkUnchanged());
    AXISCOMP_CHECK(noteCovering(bytes, cost));
    auto done = put(m_access, bytes);
    const bool isRefused = !done && !isUncertain(done.error().code)
        && done.error().code != ErrorCode::VerifyMismatch
        && done.error().code != ErrorCode::OtherDrive;
    if (done)
        done = confirmDrive();
    FlashAccount account(m_store, m_drive.serialNumber, m_clock);
    if (!done)
        account.noteRefusal(done.error());
    Result<std::filesystem::path> outcome = m_backup;
    if (!done)
        outcome = fail(isRefused ? done.error() : rollBack(done.error()));
    if (!isRefused || mayHaveSpentFlash(done.error())) {
        const RegisterAccess access = m_access.withoutStop();
        Result<EraseCounts> counts = EraseCounts{};
        if (done || access.checkDrive()) // the counts of another drive say nothing about this one
            counts = readEraseCounts(access, {m_slot.name});
        account.record(m_seen.counts, counts.value_or(EraseCounts{}), cost.operations);
    }
    if (done && bytes.empty()) {
        AXISCOMP_CHECK(m_store.recordCovered(m_drive.serialNumber, m_slot.name, false));
    }
    return outcome;
}

Result<FileReplacement::Cost> FileReplacement::planReplacement(ByteView bytes)
{
    AXISCOMP_CHECK(lookAndRead());
    if (std::ranges::equal(m_old.bytes, bytes))
        return Cost{.isThere = true};
    AXISCOMP_TRY(const auto saved, m_store.savedState(m_drive.serialNumber));
    return costOf(needsFlash(bytes, saved));
}

Result<SlotDeletion> FileReplacement::planDeletion()
{
    AXISCOMP_CHECK(lookAndRead());
    if (m_old.bytes.empty())
        return fail(ErrorCode::NoTable, {{"slot", m_slot.name}, {"deleting", Verbatim{"slot"}}});
    AXISCOMP_TRY(const Cost cost, check({}, Users::Refused));
    AXISCOMP_TRY(auto history, m_store.flashHistory(m_drive.serialNumber));
    return SlotDeletion{m_drive, m_slot.name, m_slot.file, m_old.bytes.size(), m_old.persistent,
        cost.operations, cost.reserve,
        wearGuard(m_access.profile().flashWear, history).budget(m_clock())};
}

Result<void> FileReplacement::lookAndRead()
{
    AXISCOMP_TRY(auto seen, look());
    AXISCOMP_TRY(auto old, readSlotFile(m_access, m_slot));
    m_seen = std::move(seen);
    m_old = std::move(old);
    return {};
}

/// Emptying a slot spends flash when the drive has a table there.
bool FileReplacement::needsFlash(ByteView bytes, const SavedState& saved) const
{
    return bytes.empty() ? m_old.persistent || saved.isCovered(m_slot.name)
                         : isPersistent(bytes, m_access.profile().layout);
}

/// Putting back deletes the new file from flash, or stores the old one again.
FileReplacement::Cost FileReplacement::costOf(bool needsFlash) const
{
    if (!needsFlash)
        return {};
    return {1, (m_old.bytes.empty() || m_old.persistent) ? 1 : 0};
}

/// Whether it may be done, and what it costs.
Result<FileReplacement::Cost> FileReplacement::check(ByteView bytes, Users users) const
{
    if (users == Users::Refused && !m_seen.state.otherUser.isEmpty())
        return fail(inUse(bytes, m_seen.state.otherUser));
    AXISCOMP_TRY(const auto saved, m_store.savedState(m_drive.serialNumber));
    const Cost cost = costOf(needsFlash(bytes, saved));
    if (cost.operations == 0)
        return cost;
    if (users == Users::Refused)
        AXISCOMP_CHECK(checkSavedUse(bytes));
    AXISCOMP_TRY(const auto history, m_store.flashHistory(m_drive.serialNumber));
    auto possible = checkFlashBudget(
        wearGuard(m_access.profile().flashWear, history), m_clock(), cost.operations, cost.reserve);
    if (possible)
        return cost;
    if (bytes.empty()) // a deletion cannot be volatile
        possible.error().context.set("waiting", Verbatim{m_slot.name});
    return fail(std::move(possible.error()));
}

/// A volatile file leaves what flash holds under it.
Result<void> FileReplacement::noteCovering(ByteView bytes, const Cost& cost) const
{
    if (bytes.empty() || !m_old.persistent || cost.operations > 0)
        return {};
    return m_store.recordCovered(m_drive.serialNumber, m_slot.name, true);
}

Error FileReplacement::inUse(ByteView bytes, Text user) const
{
    Error error{ErrorCode::SlotInUse, {{"slot", m_slot.name}, {"user", std::move(user)}}, {}};
    if (bytes.empty())
        error.context.set("deleting", Verbatim{"slot"});
    return error;
}

Result<FileReplacement::Look> FileReplacement::look() const
{
    std::vector<std::string> paths = slotStatePaths(m_access, m_drive, noAxis, m_slot.name);
    const std::string count = m_access.slotPath(m_access.registers().tableEraseCount, m_slot.name);
    paths.push_back(count);
    AXISCOMP_TRY(auto readings, m_access.readAvailable(std::move(paths)));
    Look seen;
    seen.state = slotState(m_access, m_drive, noAxis, m_slot.name, readings);
    if (readings.contains(count))
        seen.counts[m_slot.name] = unsignedAt(readings, count);
    for (int axis = m_drive.axes - 1; axis >= 0; --axis) {
        const std::string table = m_access.axisPath(m_access.registers().table, axis);
        if (textAt(readings, table) == m_slot.name)
            seen.user = axis;
    }
    return seen;
}

Result<void> FileReplacement::keepOldFile()
{
    const WallTime now = m_clock();
    if (m_seen.user == noAxis) {
        AXISCOMP_TRY(auto saved, m_store.saveBackup(m_drive, now, m_old));
        m_backup = std::move(saved);
        return {};
    }
    // The file is the axis's table: restoring it must bring that axis back.
    AxisBackup backup{m_drive, m_seen.user, {}, now, {}, {m_old}};
    AXISCOMP_TRY(auto registers, readAxisRegisters(m_access, m_seen.user));
    backup.registers = std::move(registers);
    SourceDirectory sources;
    sources.useDrive(m_drive);
    AXISCOMP_CHECK(describeAxis(m_access, sources, backup));
    AXISCOMP_TRY(auto saved, m_store.saveBackup(backup));
    m_backup = std::move(saved);
    return {};
}

/// The last question before the change, as in a write.
Result<void> FileReplacement::checkUnchanged() const
{
    AXISCOMP_CHECK(m_access.checkDrive());
    AXISCOMP_TRY(auto now, look());
    const std::size_t elementBytes = now.state.elements * sizeof(float);
    const bool isWhatWasKept = m_old.bytes.size() >= elementBytes
        && (now.state.isEmpty()
            || crc32(ByteView(m_old.bytes).last(elementBytes)) == now.state.crc);
    if (now.state == m_seen.state && isWhatWasKept)
        return {};
    return fail(ErrorCode::ChangedMeanwhile,
        {{"what", AXISCOMP_TEXT("Error", "slot {slot}").with("slot", m_slot.name)},
            {"before", slotStateText(m_seen.state)}, {"now", slotStateText(now.state)}});
}

/// A reboot must not bring an axis this table with the sources of another.
Result<void> FileReplacement::checkSavedUse(ByteView bytes) const
{
    AXISCOMP_TRY(auto saved, m_store.savedState(m_drive.serialNumber));
    const std::uint32_t crc = elementCrc(bytes, m_access.profile().layout);
    for (const SavedState::Use& use : saved.uses)
        if (use.slot == m_slot.name && use.crc != crc)
            return fail(inUse(bytes,
                AXISCOMP_TEXT("Error", "axis {axis} after a reboot").with("axis", use.axis)));
    return {};
}

Result<void> FileReplacement::put(const RegisterAccess& access, ByteView bytes) const
{
    if (bytes.empty())
        return deleteTable(access, m_slot.name);
    return uploadVerified(access, m_slot.file, bytes,
        [&](std::string_view step, double fraction) { access.report(step, fraction); });
}

/// Whether it was this drive that took the file. From here on the user cannot stop any more.
Result<void> FileReplacement::confirmDrive() const
{
    const RegisterAccess access = m_access.withoutStop();
    auto same = access.checkDrive();
    if (!same && isUnreachable(same.error().code))
        same = access.checkDrive();
    return same;
}

/// Gives the error to report.
Error FileReplacement::rollBack(const Error& reason) const
{
    const RegisterAccess access = m_access.withoutStop();
    auto restored = access.checkDrive();
    if (restored)
        restored = put(access, m_old.bytes);
    if (restored)
        return reason;
    return Error{ErrorCode::RollbackFailed,
        {{"reason", textOf(reason)}, {"rollback", textOf(restored.error())},
            {"backup", m_backup.string()}},
        std::string(errorName(reason.code)) + ": " + reason.detail};
}

} // namespace axiscomp
