// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/local_file.h"
#include "core/table/tam_table.h"
#include "tests/reliability/soak/soak_model.h"

#include <algorithm>

namespace axiscomp::test {

namespace {

/// What a program read, against what the drive has.
bool isSame(const CompensationSetup& setup, const AxisPicture& picture, const TableLayout& layout)
{
    const std::string slot = setup.slot.empty() ? "Disabled" : setup.slot;
    for (std::size_t n = 0; n < 3; ++n)
        if (setup.sources[n].address != picture.sources[n])
            return false;
    const bool isPersistent = setup.persistency == Persistency::Persistent;
    const std::uint32_t crc = picture.table.size() < layout.headerSize
        ? 0
        : crc32(ByteView(picture.table).subspan(layout.headerSize));
    return slot == picture.slot && setup.tableCrc == crc && isPersistent == picture.persistent;
}

bool isSame(const std::vector<RegisterWrite>& registers, const AxisPicture& picture)
{
    bool same = registers.size() == 4 && toText(registers[0].value) == picture.slot;
    for (std::size_t n = 0; same && n < 3; ++n)
        same = toDouble(registers[n + 1].value) == static_cast<double>(picture.sources[n]);
    return same;
}

/// The file of a slot that a backup has for the axis.
Bytes tableIn(const AxisBackup& backup, const std::string& slot, const TableLayout& layout)
{
    const auto file = std::ranges::find(backup.files, slot, &AxisBackup::File::slot);
    Bytes bytes = file == backup.files.end() ? Bytes{} : file->bytes;
    if (!bytes.empty())
        setPersistent(bytes, false, layout);
    return bytes;
}

const std::string stateAfter(Action action)
{
    return action == Action::Activate ? "Active"
        : action == Action::Evaluate  ? "Evaluating"
                                      : "Disabled";
}

} // namespace

void SoakModel::checkReports(
    const Operation& operation, const Ending& ending, const Moment& before, const Moment& after)
{
    if (operation.isRestore() || mayHaveRebooted(operation, ending)) {
        for (const WriteReport& report : ending.reports)
            expect(std::filesystem::exists(report.backup), "there is no backup file");
        return;
    }
    const auto axis = static_cast<std::size_t>(operation.axis);
    for (const WriteReport& report : ending.reports)
        checkWriteReport(report, ending, before, after);
    const TableLayout& layout = m_drive.drive().profile().layout;
    if (ending.status)
        expect(isSame(ending.status->setup, after.now.axes[axis], layout),
            "the status is not what the drive has: " + after.now.axes[axis].text());
    const bool activates = operation.action == Action::Activate
        || operation.action == Action::Evaluate || operation.action == Action::Deactivate;
    const std::string& state = after.now.states[axis];
    if (activates && ending.isDone())
        expect(state == stateAfter(operation.action)
                || (operation.action == Action::Activate && state == "Ramping"),
            "the compensation is " + state + " after " + operation.text());
    if (ending.plan)
        expect(isSame(ending.plan->before, after.now.axes[axis], layout),
            "the plan begins with something else than the drive has");
    if (ending.backup)
        checkBackup(*ending.backup, after.now.axes);
    if (ending.file) {
        const std::string slot = m_drive.drive().profile().slotOfFile(operation.path)->name;
        const auto file = after.now.slots.find(slot);
        expect(*ending.file == (file == after.now.slots.end() ? Bytes{} : file->second),
            "the download is not the file");
    }
    if (ending.settled)
        checkSettled(operation, *ending.settled, after.now);
}

void SoakModel::checkWriteReport(
    const WriteReport& report, const Ending& ending, const Moment& before, const Moment& after)
{
    const TableLayout& layout = m_drive.drive().profile().layout;
    const auto axis = static_cast<std::size_t>(report.plan.axis);
    const AxisPicture& old = before.now.axes[axis];
    expect(isSame(report.now.setup, after.now.axes[axis], layout),
        "the report is not what the drive has: " + after.now.axes[axis].text());
    expect(isSame(report.plan.before, old, layout), "the report begins with something else");
    if (!ending.hasStruck)
        expect(after.now.flashCycles - before.now.flashCycles
                <= static_cast<std::uint64_t>(report.plan.flashOperations),
            "the write cost more flash operations than the "
                + std::to_string(report.plan.flashOperations) + " planned");
    const auto text = loadFile(report.backup, maximumBackupSize);
    const auto backup =
        text ? readBackup(asText(*text), report.backup.string()) : fail(text.error());
    expect(backup && backup->axes.size() == 1 && isSame(backup->axes.front().registers, old)
            && tableIn(backup->axes.front(), old.slot, layout) == old.table,
        "the backup " + report.backup.string() + " is not what the axis had: " + old.text());
}

void SoakModel::checkBackup(const DriveBackup& backup, const std::vector<AxisPicture>& axes)
{
    const auto again = readBackup(writeBackup(backup), "backup");
    expect(again && *again == backup, "the backup does not read back");
    expect(backup.axes.size() == axes.size(), "the backup has not all axes");
    for (const AxisBackup& axis : backup.axes) {
        const AxisPicture& picture = axes[static_cast<std::size_t>(axis.axis)];
        expect(isSame(axis.registers, picture)
                && tableIn(axis, picture.slot, m_drive.drive().profile().layout) == picture.table,
            "the backup of axis " + std::to_string(axis.axis) + " is not " + picture.text());
    }
}

void SoakModel::checkSettled(const Operation& operation, AxisCompensator::UnfinishedOutcome outcome,
    const DrivePicture& after)
{
    using Outcome = AxisCompensator::UnfinishedOutcome;
    const JournalEntry& journal = *operation.journal;
    const AxisPicture& now = after.axes[static_cast<std::size_t>(operation.axis)];
    const auto text = loadFile(journal.backup, maximumBackupSize).value();
    const AxisBackup old = readBackup(asText(text), journal.backup.string()).value().axes.front();
    const bool isOld = isSame(old.registers, now)
        && tableIn(old, now.slot, m_drive.drive().profile().layout) == now.table;
    const bool isNew = isSame(journal.newRegisters, now) && now.persistent == journal.persistent;
    switch (outcome) {
    case Outcome::Old:
        return expect(isOld, "settled as old, but it is " + now.text());
    case Outcome::New:
    case Outcome::NewUnsaved:
        return expect(isNew, "settled as new, but it is " + now.text());
    case Outcome::Neither:
        return expect(!isOld || now.persistent != old.files.front().persistent,
            "settled as neither, but it is the old state");
    case Outcome::Unknown:
        return expect(false, "settled as unknown, but its backup is there");
    }
}

} // namespace axiscomp::test
