// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reliability/soak/soak_model.h"

#include <algorithm>

namespace axiscomp::test {

namespace {

Bytes fileIn(const DrivePicture& picture, const std::string& slot)
{
    const auto file = picture.slots.find(slot);
    return file == picture.slots.end() ? Bytes{} : file->second;
}

bool mayChangeForeign(const Operation& operation, const TableSlot& slot)
{
    if (operation.action == Action::RestoreOld)
        return std::ranges::find(operation.backup->otherFiles, slot.name, &AxisBackup::File::slot)
            != operation.backup->otherFiles.end();
    return operation.action == Action::Upload && operation.path == slot.file;
}

bool isForeign(const std::string& slot)
{
    const auto& slots = SoakDrive::foreignSlots();
    return std::ranges::find(slots, slot) != slots.end();
}

} // namespace

void SoakModel::checkForeignSlots(
    const std::vector<Operation>& group, const DrivePicture& before, const DrivePicture& after)
{
    for (const TableSlot& slot : m_drive.drive().profile().tableSlots) {
        const bool isAllowed = std::ranges::any_of(
            group, [&](const Operation& one) { return mayChangeForeign(one, slot); });
        if (isForeign(slot.name))
            expect(isAllowed || fileIn(before, slot.name) == fileIn(after, slot.name),
                "the table of a drive program in " + slot.name + " was changed");
    }
}

void SoakModel::checkSlots(
    const Operation& operation, const DrivePicture& before, const DrivePicture& after)
{
    checkForeignSlots({operation}, before, after);
    for (const TableSlot& slot : m_drive.drive().profile().tableSlots) {
        if (isForeign(slot.name) || operation.action == Action::RestoreOld
            || fileIn(before, slot.name) == fileIn(after, slot.name))
            continue;
        expect(operation.changesSetup(), slot.name + " was changed by " + operation.text());
        for (int axis = 0; axis < SoakDrive::axes; ++axis) {
            const auto index = static_cast<std::size_t>(axis);
            expect(axis == operation.axis
                    || (before.axes[index].slot != slot.name
                        && after.axes[index].slot != slot.name),
                slot.name + " was changed, which is used by axis " + std::to_string(axis));
        }
        const auto owner = m_owners.find(slot.name);
        expect(owner == m_owners.end() || owner->second == operation.axis
                || fileIn(before, slot.name).empty(),
            slot.name + " was changed, which holds an earlier table of another axis");
    }
}

/// Whoever uses a slot that was filled is its owner; without a user: the axis that was written to,
/// when it was one.
void SoakModel::noteOwners(
    const DrivePicture& before, const DrivePicture& after, std::optional<int> axis)
{
    for (const TableSlot& slot : m_drive.drive().profile().tableSlots) {
        if (fileIn(before, slot.name) == fileIn(after, slot.name))
            continue;
        const auto user = after.userOf(slot.name);
        const auto owner = user ? user : axis;
        if (owner && !fileIn(after, slot.name).empty())
            m_owners[slot.name] = *owner;
        else
            m_owners.erase(slot.name);
    }
}

void SoakModel::checkJournals(const Operation& operation, const Ending& ending,
    const DrivePicture& before, const DrivePicture& after)
{
    for (int axis = 0; axis < SoakDrive::axes; ++axis)
        checkJournal(operation, ending, axis, before, after);
}

void SoakModel::checkJournal(const Operation& operation, const Ending& ending, int axis,
    const DrivePicture& before, const DrivePicture& after)
{
    const auto index = static_cast<std::size_t>(axis);
    const auto journal = m_store.journal(SoakDrive::serialNumber, axis);
    expect(journal.has_value(), "the journal cannot be read");
    if (!journal)
        return;
    const std::string name = "axis " + std::to_string(axis) + ": ";
    const bool isWrite = operation.changesSetup() && !operation.isRestore();
    if (changesSetupOf(operation, axis)) {
        if (ending.isUncertain(operation) || ending.isOutOfReach())
            m_journalMayBeOpen[index] = true;
        if (isWrite && ending.isDone())
            m_journalMayBeOpen[index] = false;
        if (isWrite && ending.isUncertain(operation) && !(before.axes[index] == after.axes[index])
            && !mayHaveRebooted(operation, ending))
            expect(journal->has_value(), name + "an unfinished write is not in the journal");
    }
    if (operation.axis == axis && ending.settled == AxisCompensator::UnfinishedOutcome::New)
        m_journalMayBeOpen[index] = false;
    expect(m_journalMayBeOpen[index] || !*journal,
        name + "the journal is open although no write was interrupted");
}

void SoakModel::checkStore(const DrivePicture& after)
{
    const auto history = m_store.flashHistory(SoakDrive::serialNumber);
    const std::uint64_t recorded = history ? history->total : 0;
    const std::uint64_t counted = after.flashCycles - m_firstCycles;
    expect(recorded + m_deaths >= counted,
        "the drive counts " + std::to_string(counted) + " flash operations, but only "
            + std::to_string(recorded) + " are recorded");
    const bool isSure =
        m_drive.now() > m_lastUncounted + m_drive.drive().profile().flashWear.window;
    expect(!isSure || after.driveError != "FlashWear",
        "the drive was asked for too many flash operations");
    const std::filesystem::path folder = m_drive.store() / std::to_string(SoakDrive::serialNumber);
    for (const char* name : {"write.lock", "lock"})
        if (std::filesystem::exists(folder / name))
            expect(
                FileLock::acquire(folder / name, std::chrono::milliseconds{0}, folder).has_value(),
                std::string(name) + " is still held");
}

void SoakModel::checkOutputs(const DrivePicture& after)
{
    for (int axis = 0; axis < SoakDrive::axes; ++axis) {
        if (!after.isOn(axis) && after.states[static_cast<std::size_t>(axis)] != "Evaluating")
            continue;
        if (const auto wrong = wrongOutput(m_drive.drive(), axis))
            expect(false, "axis " + std::to_string(axis) + ": " + *wrong);
    }
}

} // namespace axiscomp::test
