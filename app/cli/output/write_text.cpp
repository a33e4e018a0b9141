// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output/write_text.h"

#include "app/cli/output/status_text.h"
#include "app/common/number_text.h"
#include "app/common/text_table.h"
#include "core/table/position_unit.h"
#include "core/table/target_axis.h"

#include <algorithm>
#include <cmath>

namespace axiscomp::app {

namespace {

constexpr int mostDecimals = 9;
constexpr const char* endOfDemo =
    "This was the demo: its drive and its backup end with this program.\n";

std::string slotWords(const WritePlan& plan)
{
    const std::string slot = plan.after.slot;
    switch (plan.slotReason) {
    case SlotReason::Named:
        return slot + ", named by you";
    case SlotReason::Empty:
        return slot + ", the smallest empty one that is large enough";
    case SlotReason::OwnPrevious:
        return slot + ", which holds a table that this axis used before and does not use now";
    case SlotReason::KeepTable:
        return slot + ", the axis keeps its table";
    case SlotReason::OverwriteOwn:
        return slot + ", the slot that the axis uses now";
    }
    return slot;
}

/// How what was deleted is had again.
std::string deletedText(
    const std::filesystem::path& backup, const std::string& driveOption, bool isDemo)
{
    if (isDemo)
        return endOfDemo;
    return labelled({{"Backup of the old state", backup.string()},
        {"To have it again", "axiscomp restore" + driveOption + " " + backup.string()}});
}

std::string tableWords(const WritePlan& plan, const CompensationTable& table, std::string_view unit)
{
    const TableStatistics figures = statistics(table);
    const std::string name = table.name.empty() ? "" : "\"" + table.name + "\", ";
    return name + plural(table.values.size(), "value", "values") + " from "
        + withUnit(signedText(shortText(figures.minimum)), unit) + " to "
        + withUnit(signedText(shortText(figures.maximum)), unit) + ", "
        + plural(plan.tableBytes, "byte", "bytes");
}

} // namespace

std::string flashWords(int operations, const FlashBudget& budget)
{
    if (operations == 0)
        return "not used";
    return plural(static_cast<std::uint64_t>(operations), "operation", "operations") + "; "
        + budgetWords(budget);
}

std::string signSentence(const CompensationTable& table, std::string_view unit, const SignPlace& at)
{
    const auto largest =
        std::ranges::max_element(table.values, {}, [](float value) { return std::abs(value); });
    const auto value = static_cast<double>(*largest);
    const std::vector<double> position =
        positionOf(table.grid, static_cast<std::size_t>(largest - table.values.begin()));
    const std::string added = withUnit(signedText(floatText(value)), unit);
    if (value == 0.0)
        return "all values are 0: the drive will add nothing";
    if (position.size() == 1 && at.isOwnPosition && table.target != otherAxis) {
        const int decimals =
            std::max(decimalsOf(position[0], mostDecimals), decimalsOf(value, mostDecimals));
        if (at.lookupAt == LookupAt::Set)
            return "at the set position " + fixedText(position[0], decimals)
                + " the drive will add " + added;
        if (at.isComputed)
            return "where the encoder reads " + shortText(position[0]) + " the drive will add "
                + added;
        return "where the encoder reads " + fixedText(position[0], decimals)
            + " the reference says " + fixedText(position[0] + value, decimals)
            + ": the drive will add " + added;
    }
    std::string place;
    for (std::size_t n = 0; n < position.size(); ++n)
        place += (n == 0 ? "" : n + 1 == position.size() ? " and " : ", ") + shortText(position[n]);
    place = (position.size() == 1 ? "where the source reads " : "where the sources read ") + place;
    if (at.isComputed)
        return place + " the drive will add " + added;
    return place + " the reference is " + withUnit(floatText(std::abs(value)), unit)
        + (value > 0 ? " above" : " below") + " the encoder: the drive will add " + added;
}

std::string planText(const WritePlan& plan, const AxisInfo& axis)
{
    std::string text = "Plan for " + axisWords(axis) + " of " + driveWords(plan.drive) + "\n\n";
    if (plan.changes.empty()) {
        text += "  The axis already has all of this.\n";
    } else {
        TextTable changes({"what", "on the drive now",
            plan.deletedSlot.empty() ? "will be written" : "afterwards"});
        for (const PlannedChange& change : plan.changes)
            changes.add({change.field, change.before, change.after});
        text += changes.text();
    }
    std::vector<std::pair<std::string, std::string>> lines;
    if (!plan.after.slot.empty())
        lines.emplace_back("Slot", slotWords(plan));
    if (plan.table) {
        const std::string unit = unitSymbol(axis.unit);
        lines.emplace_back("Table", tableWords(plan, *plan.table, unit));
        lines.emplace_back("Sign",
            signSentence(*plan.table, unit,
                {plan.lookupAt, plan.ownDimension.has_value(), plan.isComputed}));
    }
    lines.emplace_back("Flash", flashWords(plan.flashOperations, plan.flashBudget));
    return text + "\n" + labelled(lines, "  ");
}

std::string planText(const SlotDeletion& plan)
{
    TextTable changes({"what", "on the drive now", "afterwards"});
    changes.add({plan.file,
        plural(plan.bytes, "byte", "bytes") + (plan.persistent ? ", persistent" : ", volatile"),
        "deleted"});
    return "Plan for " + plan.slot + " of " + driveWords(plan.drive) + "\n\n" + changes.text()
        + "\n" + labelled({{"Flash", flashWords(plan.flashOperations, plan.flashBudget)}}, "  ");
}

std::string deletionText(const SlotDeletion& plan, const std::filesystem::path& backup,
    const std::string& driveOption, bool isDemo)
{
    return "\nDeleted and verified: " + plan.slot + " is empty.\n"
        + deletedText(backup, driveOption, isDemo);
}

std::string reportText(const WriteReport& report, const std::string& driveOption, bool isDemo)
{
    const AxisStatus& now = report.now;
    const std::string& deleted = report.plan.deletedSlot;
    std::string text = deleted.empty()
        ? "\nWritten and verified: every byte of what was written was read back and compared.\n"
        : "\nDeleted and verified: " + deleted + " is empty, and " + axisWords(now.axis)
            + " uses no table.\n";
    if (!deleted.empty())
        return text + deletedText(report.backup, driveOption, isDemo);
    if (isDemo)
        return text + endOfDemo;
    text += labelled({{"Backup of the old state", report.backup.string()},
        {"Next", "axiscomp activate" + driveOption + " --axis " + std::to_string(now.axis.index)}});
    if (now.table && !now.table->persistent)
        text += "The table is volatile: a reboot of the drive removes it. `axiscomp persist` keeps "
                "it.\n";
    return text;
}

} // namespace axiscomp::app
