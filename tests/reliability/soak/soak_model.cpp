// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reliability/soak/soak_model.h"

#include "core/io/local_file.h"
#include "core/table/tam_table.h"
#include "drivecomm/profile/profile_loader.h"

#include <algorithm>

namespace axiscomp::test {

namespace {

std::string axisName(int axis)
{
    return "axis " + std::to_string(axis) + ": ";
}

bool storesWrong(const Operation& operation)
{
    const auto& mishap = operation.mishap;
    return mishap
        && (mishap->fault == LinkFault::StoresWrong
            || (mishap->onTheWire
                && mishap->onTheWire->kind == drivecomm::FaultSpec::Kind::StoresWrong));
}

bool isOneOf(const AxisPicture& picture, const std::vector<AxisPicture>& pictures)
{
    return std::ranges::find(pictures, picture) != pictures.end();
}

std::string listed(const std::vector<AxisPicture>& pictures)
{
    std::string text;
    for (const AxisPicture& picture : pictures)
        text += (text.empty() ? "" : " | ") + picture.text();
    return text;
}

/// The slot holds another table in flash than the one that the drive uses now.
bool hidesFlash(const Moment& moment, const std::string& slot)
{
    const auto now = moment.now.slots.find(slot);
    const auto flash = moment.afterReboot.slots.find(slot);
    return now != moment.now.slots.end() && flash != moment.afterReboot.slots.end()
        && !sameTable(now->second, flash->second, drivecomm::genericProfile().layout);
}

} // namespace

bool mayHaveRebooted(const Operation& operation, const Ending& ending)
{
    if (operation.action == Action::Reboot)
        return true;
    const auto& mishap = operation.mishap;
    return mishap && ending.hasStruck
        && (mishap->fault == LinkFault::Reboot
            || (mishap->onTheWire
                && mishap->onTheWire->kind == drivecomm::FaultSpec::Kind::RebootAfter));
}

bool changesSetupOf(const Operation& operation, int axis)
{
    if (operation.isRestore())
        return std::ranges::find(operation.backup->axes, axis, &AxisBackup::axis)
            != operation.backup->axes.end();
    return operation.changesSetup() && operation.axis == axis;
}

SoakModel::SoakModel(SoakDrive& drive)
    : m_drive(drive)
    , m_store(drive.store())
    , m_firstCycles(drive.picture().flashCycles)
    , m_known(SoakDrive::axes)
    , m_journalMayBeOpen(SoakDrive::axes, false)
{
}

std::vector<std::string> SoakModel::check(
    const Operation& operation, const Ending& ending, const Moment& before, const Moment& after)
{
    m_problems.clear();
    noteUncounted(operation, ending);
    checkHiding(operation, ending, before, after);
    for (int axis = 0; axis < SoakDrive::axes; ++axis) {
        checkAxis(operation, ending, axis, before, after);
        checkFlash(operation, ending, axis, before, after);
    }
    checkReports(operation, ending, before, after);
    if (!mayHaveRebooted(operation, ending))
        checkSlots(operation, before.now, after.now);
    // What a restart brings back into a slot may be of any axis.
    const bool isOfOneAxis = operation.changesSetup() && operation.action != Action::RestoreOld
        && !mayHaveRebooted(operation, ending);
    noteOwners(before.now, after.now, isOfOneAxis ? std::optional(operation.axis) : std::nullopt);
    checkJournals(operation, ending, before.now, after.now);
    checkStore(after.now);
    checkOutputs(after.now);
    return m_problems;
}

std::vector<std::string> SoakModel::check(const std::vector<Operation>& group,
    const std::vector<Ending>& endings, const Moment& before, const Moment& after)
{
    m_problems.clear();
    for (std::size_t i = 0; i < group.size(); ++i) {
        noteUncounted(group[i], endings[i]);
    }
    for (int axis = 0; axis < SoakDrive::axes; ++axis)
        checkAxisTogether(group, endings, axis, before, after);
    checkForeignSlots(group, before.now, after.now);
    for (std::size_t i = 0; i < group.size(); ++i) {
        if (group[i].action != Action::Write)
            continue;
        m_journalMayBeOpen[static_cast<std::size_t>(group[i].axis)] = true;
    }
    noteOwners(before.now, after.now);
    checkStore(after.now);
    checkOutputs(after.now);
    return m_problems;
}

/// What an operation begins with. One that keeps the table of the axis keeps that which a restart
/// has brought back, when the drive restarts before the program has looked.
const DrivePicture& SoakModel::keptFrom(const Operation& operation, const Ending& ending, int axis,
    const Moment& before, const Moment& after)
{
    const auto index = static_cast<std::size_t>(axis);
    const bool isBroughtBack = operation.action == Action::SetPersistency
        && mayHaveRebooted(operation, ending)
        && after.now.axes[index].table == before.afterReboot.axes[index].table;
    return isBroughtBack ? before.afterReboot : before.now;
}

/// What the axis has when the operation is done; its slot is left open.
std::optional<AxisPicture> SoakModel::wanted(
    const Operation& operation, int axis, const DrivePicture& before)
{
    if (!changesSetupOf(operation, axis))
        return {};
    if (operation.isRestore())
        return wantedByBackup(*operation.backup, axis);
    AxisPicture picture = before.axes[static_cast<std::size_t>(axis)];
    if (operation.action == Action::Finish)
        return finished(operation);
    if (operation.action == Action::Undo)
        return heldBy(backupOf(*operation.journal), axis);
    if (operation.action == Action::SetPersistency) {
        picture.persistent = operation.persistency == Persistency::Persistent;
        return picture;
    }
    picture.slot.clear();
    const WriteRequest& request = operation.request;
    if (!request.sources.empty()) {
        picture.sources = {};
        for (std::size_t n = 0; n < request.sources.size(); ++n)
            picture.sources[n] = addressOf(m_drive.drive(), request.sources[n]);
    }
    if (request.table)
        picture.table =
            encodeTamTable(*request.table, false, m_drive.drive().profile().layout).value();
    if (request.persistency)
        picture.persistent = *request.persistency == Persistency::Persistent;
    return picture;
}

/// What finishing an unfinished write brings about.
AxisPicture SoakModel::finished(const Operation& operation)
{
    const JournalEntry& journal = *operation.journal;
    AxisPicture picture = heldBy(backupOf(journal), journal.axis).value();
    picture.slot = toText(journal.newRegisters.front().value);
    for (std::size_t n = 0; n < 3; ++n)
        picture.sources[n] =
            static_cast<std::uint32_t>(toDouble(journal.newRegisters[n + 1].value));
    if (picture.slot == "Disabled")
        picture.table.clear();
    else if (!operation.file.empty()) // otherwise the axis keeps its table
        picture.table = operation.file;
    picture.persistent = journal.persistent;
    return picture;
}

DriveBackup SoakModel::backupOf(const JournalEntry& journal)
{
    const auto text = loadFile(journal.backup, maximumBackupSize).value();
    return readBackup(asText(text), "backup").value();
}

/// What the axis had when the backup was made.
std::optional<AxisPicture> SoakModel::heldBy(const DriveBackup& backup, int axis)
{
    const auto found = std::ranges::find(backup.axes, axis, &AxisBackup::axis);
    if (found == backup.axes.end())
        return {};
    AxisPicture picture;
    picture.slot = toText(found->registers.front().value);
    for (std::size_t n = 0; n < 3; ++n)
        picture.sources[n] = static_cast<std::uint32_t>(toDouble(found->registers[n + 1].value));
    const auto file = std::ranges::find(found->files, picture.slot, &AxisBackup::File::slot);
    if (file == found->files.end() || file->bytes.empty())
        return picture;
    picture.table = file->bytes;
    setPersistent(picture.table, false, m_drive.drive().profile().layout);
    picture.persistent = file->persistent;
    return picture;
}

/// What restoring the backup brings about.
std::optional<AxisPicture> SoakModel::wantedByBackup(const DriveBackup& backup, int axis)
{
    auto picture = heldBy(backup, axis);
    if (!picture)
        return {};
    if (picture->table.empty()) { // it names no slot that may be somebody else's by now
        picture->slot = "Disabled";
        return picture;
    }
    // Sources that its table has no dimension for are not put back.
    const auto decoded = decodeTamTable(picture->table, m_drive.drive().profile().layout);
    for (auto n = static_cast<std::size_t>(decoded ? decoded->table.grid.dimensions() : 3); n < 3;
         ++n)
        picture->sources[n] = 0;
    return picture;
}

void SoakModel::learn(int axis, const AxisPicture& picture)
{
    m_known[static_cast<std::size_t>(axis)].emplace(picture.sources, picture.table);
}

/// A volatile table covers another one that flash holds only where no slot was empty that nobody
/// needs, not even after a reboot, or where the user named that slot. The drive does not tell what
/// a reboot brings back: what the programs must reckon with counts.
void SoakModel::checkHiding(
    const Operation& operation, const Ending& ending, const Moment& before, const Moment& after)
{
    if (operation.action != Action::Write || !ending.isDone() || operation.request.slot
        || !operation.request.table || mayHaveRebooted(operation, ending))
        return;
    const auto& foreign = SoakDrive::foreignSlots();
    const std::size_t size = after.now.axes[static_cast<std::size_t>(operation.axis)].table.size();
    const auto& slots = m_drive.drive().profile().tableSlots;
    const auto saved =
        m_store.savedState(SoakDrive::serialNumber); // a volatile write saves nothing
    const auto room = std::ranges::find_if(slots, [&](const TableSlot& slot) {
        return slot.maximumSize >= size && !before.now.slots.contains(slot.name)
            && !before.now.userOf(slot.name)
            && before.afterReboot.userOf(slot.name).value_or(operation.axis) == operation.axis
            && saved && !saved->otherUser(slot.name, operation.axis)
            && std::ranges::find(foreign, slot.name) == foreign.end();
    });
    const std::string& slot = after.now.axes[static_cast<std::size_t>(operation.axis)].slot;
    const auto there = before.now.slots.find(slot);
    const auto file = there == before.now.slots.end()
        ? Result<TamTable>(TamTable{})
        : decodeTamTable(there->second, m_drive.drive().profile().layout);
    if (room == slots.end() || (file && !file->persistent) || !hidesFlash(after, slot))
        return;
    const auto index = static_cast<std::size_t>(operation.axis);
    expect(false,
        slot + " was taken for a volatile table, although flash holds another one there and "
            + room->name + " was free; the axis had " + before.now.axes[index].text()
            + ", after a reboot " + before.afterReboot.axes[index].text());
}

/// A program that was killed in a write may have left a flash operation unrecorded; a drive that
/// stores something else than it was told may spend one that no program has asked for.
void SoakModel::noteUncounted(const Operation& operation, const Ending& ending)
{
    const bool hasDiedInWrite =
        ending.hasDied && (operation.changesSetup() || operation.action == Action::Upload);
    if (hasDiedInWrite)
        ++m_deaths;
    if (hasDiedInWrite || (storesWrong(operation) && ending.hasStruck))
        m_lastUncounted = m_drive.now();
}

/// A reboot at this moment must not bring back a mixture that can be switched on.
void SoakModel::checkReachable(int axis, const Moment& moment)
{
    const auto index = static_cast<std::size_t>(axis);
    const AxisPicture& later = moment.afterReboot.axes[index];
    const bool isKnown = m_known[index].contains({later.sources, later.table});
    expect(!later.canBeActivated() || isKnown,
        axisName(axis) + "after a reboot it would have a mixture: " + later.text());
}

/// The axis whose only slot was being overwritten may be left without a table. In a group it may
/// have got that slot from another write just before, as the backup says.
bool SoakModel::isSwitchedOffInPlace(const Operation& operation, const Ending& ending, int axis,
    const AxisPicture& before, const AxisPicture& after)
{
    const auto journal = m_store.journal(SoakDrive::serialNumber, axis);
    if (!ending.isUncertain(operation) || after.slot != "Disabled" || !journal || !*journal)
        return false;
    const std::string& slot = (*journal)->newSlot;
    const auto kept = heldBy(backupOf(**journal), axis);
    return slot == before.slot || (kept && slot == kept->slot);
}

void SoakModel::checkAxis(const Operation& operation, const Ending& ending, int axis,
    const Moment& before, const Moment& after)
{
    const auto index = static_cast<std::size_t>(axis);
    const AxisPicture& old = before.now.axes[index];
    const AxisPicture& now = after.now.axes[index];
    const auto complete = wanted(operation, axis, keptFrom(operation, ending, axis, before, after));
    std::vector<AxisPicture> allowed;
    const bool hasRebooted = mayHaveRebooted(operation, ending);
    if (hasRebooted && !(complete && ending.isDone())) {
        allowed = {before.afterReboot.axes[index], after.afterReboot.axes[index]};
        // It may have brought the same table back from flash, over which the axis had it volatile.
        if (before.afterReboot.slots.contains(old.slot) && !hidesFlash(before, old.slot)) {
            allowed.push_back(old);
            allowed.back().persistent = true;
        }
    }
    const bool isSure = operation.action == Action::Reboot || (complete && ending.isDone());
    if (!isSure)
        allowed.push_back(old);
    const bool mayBeNew =
        complete && (ending.isDone() || ending.isUncertain(operation) || operation.isRestore());
    // The slot was empty, and holds somebody else's table by now.
    const bool isTaken = mayBeNew && operation.action == Action::Undo && complete->table.empty()
        && after.now.slots.contains(complete->slot);
    // It named an empty slot, as the backup does: that is left.
    const bool isLeft = operation.isRestore() && now == old && now.table.empty();
    const bool isNew = mayBeNew && now.compensatesAs(*complete)
        && (isLeft || (complete->slot == "Disabled" || isTaken) == (now.slot == "Disabled"));
    learn(axis, old);
    if (mayBeNew)
        learn(axis, *complete);
    if (isNew || isOneOf(now, allowed) || isSwitchedOffInPlace(operation, ending, axis, old, now)) {
        if (isNew && !isLeft)
            m_owners[now.slot] = axis;
        return;
    }
    expect(false,
        axisName(axis) + "it has " + now.text() + "; allowed: " + listed(allowed)
            + (mayBeNew ? "; new: " + complete->text() : ""));
}

/// The same for an axis in a group: without an order, each of its writes may be the last.
void SoakModel::checkAxisTogether(const std::vector<Operation>& group,
    const std::vector<Ending>& endings, int axis, const Moment& before, const Moment& after)
{
    const auto index = static_cast<std::size_t>(axis);
    const AxisPicture& now = after.now.axes[index];
    learn(axis, before.now.axes[index]);
    std::vector<AxisPicture> news;
    bool isOld = true;
    bool isOff = false;
    for (std::size_t i = 0; i < group.size(); ++i) {
        const auto complete = wanted(group[i], axis, before.now);
        if (!complete || !(endings[i].isDone() || endings[i].isUncertain(group[i])))
            continue;
        news.push_back(*complete);
        learn(axis, *complete);
        isOld = isOld && !endings[i].isDone();
        isOff =
            isOff || isSwitchedOffInPlace(group[i], endings[i], axis, before.now.axes[index], now);
    }
    const bool isNew = std::ranges::any_of(
        news, [&](const AxisPicture& picture) { return now.compensatesAs(picture); });
    expect(isNew || isOff || (isOld && now == before.now.axes[index]),
        axisName(axis) + "it has " + now.text() + " instead of " + listed(news)
            + (isOld ? ", before: " + before.now.axes[index].text() : ""));
    checkReachable(axis, after);
    for (std::size_t i = 0; i < group.size(); ++i)
        if (endings[i].backup)
            for (const AxisBackup& part : endings[i].backup->axes)
                if (const auto kept = wantedByBackup(*endings[i].backup, part.axis))
                    expect(!kept->canBeActivated()
                            || m_known[static_cast<std::size_t>(part.axis)].contains(
                                {kept->sources, kept->table})
                            || part.axis > axis,
                        axisName(part.axis) + "a backup holds a mixture: " + kept->text());
}

/// What a reboot would bring back.
void SoakModel::checkFlash(const Operation& operation, const Ending& ending, int axis,
    const Moment& before, const Moment& after)
{
    const auto index = static_cast<std::size_t>(axis);
    const AxisPicture& later = after.afterReboot.axes[index];
    checkReachable(axis, after);
    const auto complete = wanted(operation, axis, keptFrom(operation, ending, axis, before, after));
    if (storesWrong(operation))
        return; // that parameters were not saved cannot be read back
    if (complete && ending.isDone() && complete->persistent && !operation.isRestore())
        expect(later.compensatesAs(*complete),
            axisName(axis) + "after a reboot it would not have what was written persistently but "
                + later.text() + "; wanted: " + complete->text() + "; it had "
                + before.now.axes[index].text() + ", after a reboot "
                + before.afterReboot.axes[index].text());
    if (!operation.changesSetup())
        expect(later == before.afterReboot.axes[index],
            axisName(axis) + "what a reboot brings back was changed from "
                + before.afterReboot.axes[index].text() + " to " + later.text());
}

} // namespace axiscomp::test
