// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output/status_text.h"

#include "app/cli/output/drive_json.h"
#include "app/common/number_text.h"
#include "app/common/text_table.h"
#include "core/table/position_unit.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <array>
#include <limits>

namespace axiscomp::app {

namespace {

struct Step {
    std::string_view id;
    std::string_view words;
};

constexpr std::array steps{
    Step{"plan", "look at the drive and plan"},
    Step{"backup", "keep the old state in a backup"},
    Step{"begin", "check that nothing has changed meanwhile"},
    Step{"switch off", "switch the axis to no table"},
    Step{"upload", "upload the table"},
    Step{"verify", "read the table back and compare every byte"},
    Step{"commit", "store the table in flash"},
    Step{"switch", "switch the axis over and read back"},
    Step{"save", "save the parameters and read back"},
    Step{"delete", "delete the table and look whether its slot is empty"},
    Step{"putting back", "put the old state back"},
    Step{"download", "download"},
};

int dimensionsOf(const AxisStatus& status)
{
    return status.table ? status.table->grid.dimensions() : status.setup.dimensionality;
}

std::string tableWords(const AxisStatus& status, const DriveProfile& profile)
{
    if (status.setup.slot.empty())
        return "none";
    const TableSlot* const slot = profile.slotNamed(status.setup.slot);
    std::string text = status.setup.slot + (slot ? " (" + slot->file + ")" : "");
    if (!status.table)
        return text + ", empty";
    const auto dimensions = static_cast<std::uint64_t>(status.table->grid.dimensions());
    return text + (status.table->persistent ? ", persistent, " : ", volatile, ")
        + plural(dimensions, "dimension", "dimensions") + ", "
        + plural(status.table->elements, "value", "values") + ", CRC " + hexText(status.table->crc);
}

/// One line per dimension: its grid, and where the drive looks the table up now.
std::string dimensionalityText(const AxisStatus& status)
{
    TextTable table(
        {">dimension", ">start", ">distance", ">size", ">last", "source", ">value", ">index"});
    const std::vector<std::string> sources = sourceTexts(status.drive.name, status.setup);
    const auto dimensions = static_cast<std::size_t>(dimensionsOf(status));
    for (std::size_t n = 0; n < std::min<std::size_t>(3, std::max(dimensions, sources.size()));
         ++n) {
        std::vector<std::string> cells{std::to_string(n + 1)};
        if (status.table && n < dimensions) {
            const GridAxis& axis = status.table->grid.axes[n];
            const bool hasSize = axis.size > 0; // else the drive does not show it
            for (const std::string& cell : {shortText(axis.start), shortText(axis.distance),
                     hasSize ? countText(axis.size) : "-", hasSize ? shortText(axis.last()) : "-"})
                cells.push_back(cell);
        } else {
            cells.resize(5, "-");
        }
        const bool hasSource = n < sources.size();
        cells.push_back(hasSource ? sources[n] : "not set");
        cells.push_back(hasSource ? shortText(status.sourceValues[n]) : "-");
        cells.push_back(hasSource && status.table ? shortText(status.indices[n]) : "-");
        table.add(std::move(cells));
    }
    return table.text();
}

} // namespace

std::string axisWords(const AxisInfo& axis)
{
    return "axis " + std::to_string(axis.index) + (axis.name.empty() ? "" : " (" + axis.name + ")");
}

std::string driveWords(const DriveIdentity& drive)
{
    return drive.name + " (serial number " + std::to_string(drive.serialNumber) + ")";
}

std::string statusText(const AxisStatus& status, const DriveProfile& profile)
{
    const std::string unit = unitSymbol(status.axis.unit);
    std::vector<std::pair<std::string, std::string>> lines{
        {"Drive", driveWords(status.drive)},
        {"Axis",
            std::to_string(status.axis.index)
                + (status.axis.name.empty() ? "" : " (" + status.axis.name + ")") + ", position in "
                + status.axis.unit},
        {"Homing", status.axis.homingWord},
        {"Compensation", status.axis.stateWord + ", activation " + status.activation},
        {"Error", status.error},
        {"Output", withUnit(signedText(shortText(status.output)), unit)},
        {"Table", tableWords(status, profile)},
    };
    if (status.hasDriveError)
        lines.emplace_back("Drive error", status.driveError);
    std::string text = labelled(lines);
    if (!status.setup.slot.empty() || status.setup.sources[0].isSet())
        text += "\n" + dimensionalityText(status);
    return text;
}

std::string budgetWords(const FlashBudget& budget)
{
    if (budget.left == std::numeric_limits<int>::max())
        return "no limit known";
    if (budget.isRecordLost)
        return "none possible, because the record of past operations was damaged";
    if (budget.left == 0)
        return "none possible for " + std::to_string(budget.wait.count()) + " s";
    return plural(static_cast<std::uint64_t>(budget.left), "operation", "operations")
        + " possible now";
}

std::string flashText(const FlashUse& use)
{
    std::string text;
    if (use.damagedRecord)
        text = "What this computer kept about the drive was damaged. It is now in "
            + use.damagedRecord->string()
            + ", and what could be read was recovered.\nFlash operations may be missing, so all of "
              "them count as used up. A write that did not end may be missing too: compare what "
              "the drive holds.\nTo store in flash again, wait as long as the drive counts its "
              "flash operations, then run 'axiscomp status --reset-flash-count'.\n";
    text += "Flash: " + budgetWords(use.budget) + "; ";
    const std::string usual =
        use.ratedCycles > 0 ? " of the usual " + countText(use.ratedCycles) + " cycles" : "";
    if (use.mostUsedSlot.empty())
        return text + plural(use.operationsRecorded, "operation", "operations")
            + " by this computer so far (others are not counted)"
            + (usual.empty()
                    ? ""
                    : "; a slot has the usual life of " + countText(use.ratedCycles) + " cycles")
            + "\n";
    return text + use.mostUsedSlot + " is the most used slot: " + countText(use.mostCycles)
        + (usual.empty() ? " cycles" : usual) + " (all slots together " + countText(use.allCycles)
        + ", by this computer " + countText(use.operationsRecorded) + ")\n";
}

std::string proofSentence(const Proof& proof)
{
    const std::string share = percentText(proof.provedShare) + " % of the table";
    return proof.extent == Proof::Extent::IndicesOnly
        ? "The drive looks up where it should, over " + share
            + "; it adds nothing while it evaluates."
        : "Proof: what the drive adds is what the table says, over " + share
            + ". Only where the axis has been is proved.";
}

std::string proofText(const Proof& proof, const AxisStatus& status)
{
    const std::string unit = unitSymbol(status.axis.unit);
    const auto dimensions = static_cast<std::size_t>(dimensionsOf(status));
    std::vector<std::string> headings;
    for (std::size_t n = 0; n < dimensions; ++n)
        headings.push_back(">source " + std::to_string(n + 1));
    headings.insert(headings.end(), {">drive adds", ">computed here"});
    std::vector<std::vector<double>> columns(dimensions + 2);
    for (const Proof::Sample& sample : proof.samples) {
        for (std::size_t n = 0; n < dimensions; ++n)
            columns[n].push_back(sample.sources[n]);
        columns[dimensions].push_back(sample.output);
        columns[dimensions + 1].push_back(sample.expected);
    }
    std::vector<std::vector<std::string>> cells;
    for (std::size_t n = 0; n < columns.size(); ++n) {
        cells.push_back(columnTexts(columns[n]));
        if (n >= dimensions)
            std::ranges::transform(cells.back(), cells.back().begin(), signedText);
    }
    TextTable table(headings);
    for (std::size_t i = 0; i < proof.samples.size(); ++i) {
        std::vector<std::string> row;
        for (const std::vector<std::string>& column : cells)
            row.push_back(column[i]);
        table.add(std::move(row));
    }
    return table.text() + "  largest difference "
        + withUnit(shortText(proof.largestDifference), unit) + ", allowed "
        + withUnit(shortText(proof.tolerance), unit) + "\n";
}

std::string stepWords(std::string_view step)
{
    const auto* const known = std::ranges::find(steps, step, &Step::id);
    return std::string(known == steps.end() ? step : known->words);
}

std::string_view outcomeName(AxisCompensator::UnfinishedOutcome outcome)
{
    switch (outcome) {
    case AxisCompensator::UnfinishedOutcome::Old:
        return "Old";
    case AxisCompensator::UnfinishedOutcome::New:
        return "New";
    case AxisCompensator::UnfinishedOutcome::NewUnsaved:
        return "NewUnsaved";
    case AxisCompensator::UnfinishedOutcome::Neither:
        return "Neither";
    case AxisCompensator::UnfinishedOutcome::Unknown:
        return "Unknown";
    }
    return "";
}

std::string beingWritten(const AxisInfo& axis)
{
    return "another program is writing to " + axisWords(axis) + " at this moment";
}

std::string outcomeSentence(const SettledWrite& settled)
{
    const JournalEntry& entry = settled.entry;
    const std::string head = "a write to axis " + std::to_string(entry.axis) + " that began at "
        + utcText(entry.time) + " did not end (last step: " + stepWords(entry.step) + "). ";
    const std::string wayOut = "`axiscomp write`, or `axiscomp restore` of another backup, puts an "
                               "end to it; the backup was "
        + entry.backup.string();
    switch (settled.outcome) {
    case AxisCompensator::UnfinishedOutcome::Old:
        return head
            + "The drive holds the complete old state: `axiscomp recover --finish` brings the new "
              "one about, `axiscomp recover --undo` puts an end to it";
    case AxisCompensator::UnfinishedOutcome::New:
        return head + "The drive holds the complete new state; nothing needs to be done";
    case AxisCompensator::UnfinishedOutcome::NewUnsaved:
        if (settled.recovery.isBackupUnread)
            return head
                + "The drive holds the complete new state, but its parameters may not be saved, "
                  "and "
                  "the backup of the old state cannot be read. "
                + wayOut;
        return head
            + "The drive holds the complete new state, but its parameters may not be saved: "
              "`axiscomp recover --finish` saves them, `axiscomp recover --undo` brings the old "
              "state back";
    case AxisCompensator::UnfinishedOutcome::Unknown:
        return head
            + "Which state the drive holds is not known, since the backup of the old one cannot be "
              "read: do not activate the axis. "
            + wayOut;
    case AxisCompensator::UnfinishedOutcome::Neither:
        break;
    }
    return head
        + "The drive holds neither the old nor the new state: do not activate the axis; finish the "
          "write with `axiscomp recover --finish`, or undo it with `axiscomp recover --undo`. The "
          "old state is kept in "
        + entry.backup.string();
}

} // namespace axiscomp::app
