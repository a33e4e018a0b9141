// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a person should know before a write.
#include "core/drive/axis_target.h"
#include "core/text/number_text.h"
#include "core/write/lookup_side.h"
#include "core/write/write_planner.h"

namespace axiscomp {

namespace {

Text coverageText(const DimensionCoverage& coverage)
{
    const TextPattern pattern = coverage.share > 0.0
        ? AXISCOMP_TEXT("Error",
            "Dimension {number} of the table reaches from {first} to {last}: {percent} of the "
            "travel of axis {axis}, {low} to {high}. Beyond the table the drive holds the value "
            "of its end.")
        : AXISCOMP_TEXT("Error",
            "Dimension {number} of the table reaches from {first} to {last}: outside the travel "
            "of axis {axis}, {low} to {high}. The drive holds the value of one end everywhere.");
    const auto number = [](double position) { return Quantity{roundedText(position)}; };
    return pattern.with("number", coverage.dimension + 1)
        .with("first", number(coverage.table.low))
        .with("last", number(coverage.table.high))
        .with("percent", Quantity{percentText(coverage.share), "%"})
        .with("axis", coverage.axis)
        .with("low", number(coverage.travel.low))
        .with("high", number(coverage.travel.high));
}

} // namespace

Result<void> checkLargeAccepted(const WritePlan& plan, const WriteRequest& request)
{
    if (plan.changes.empty() || plan.largeCorrections.empty() || request.acceptsLarge)
        return {};
    return fail(ErrorCode::LargeCorrection,
        {{"reason", plan.largeCorrections.front()}, {"ofAxis", plan.axis}});
}

void WritePlanner::warn()
{
    WritePlan& plan = m_write.plan;
    if (!plan.deletedSlot.empty())
        return warnOfDeletion();
    const bool isNews =
        plan.slotReason != SlotReason::KeepTable || plan.before.sources != plan.after.sources;
    for (const DimensionCoverage& dimension : plan.coverage)
        if (isNews && dimension.share < 1.0)
            plan.warnings.push_back(coverageText(dimension));
    for (const DimSource& source : plan.after.sources)
        if (m_access.profile().isAfterCompensation(source.path))
            plan.warnings.push_back(AXISCOMP_TEXT("Error",
                "{source} is a position after the compensation: the table would be looked up where "
                "its own values have moved the axis.")
                                        .with("source", source.path));
    warnOfKeptTable();
    if (plan.slotReason == SlotReason::OverwriteOwn && !m_isSlotNamed)
        plan.warnings.push_back(AXISCOMP_TEXT("Error",
            "No other slot is free: the table in {slot} is overwritten. A copy is kept in the "
            "backup.")
                                    .with("slot", plan.after.slot));
    const bool isNamed = plan.slotReason == SlotReason::Named
        || (plan.slotReason == SlotReason::OverwriteOwn && m_isSlotNamed);
    if (isNamed && !m_isInSlot && !m_isSlotEmpty)
        plan.warnings.push_back(AXISCOMP_TEXT(
            "Error", "What {slot} holds now is overwritten. A copy is kept in the backup.")
                                    .with("slot", plan.after.slot));
    if (plan.after.persistency == Persistency::Persistent)
        return warnOfSaving();
    if (removesFromFlash(plan))
        plan.warnings.push_back(AXISCOMP_TEXT("Error",
            "The table is removed from flash, which is a flash operation too. After a reboot the "
            "axis has no table."));
    if (plan.after.slot.empty())
        return warnOfDetaching();
    if (plan.slotReason == SlotReason::KeepTable)
        return;
    if (m_status.table && m_status.table->persistent)
        plan.warnings.push_back(AXISCOMP_TEXT("Error",
            "The new table is volatile: after a reboot the axis has the old, persistent one "
            "again, or none where the parameters have been saved since then."));
    if (m_write.slotBefore.persistent && plan.after.slot != plan.before.slot)
        plan.warnings.push_back(AXISCOMP_TEXT("Error",
            "The new table is volatile and covers an older one that flash holds in {slot}: after a "
            "reboot the axis may have that one again, until the parameters are saved, which "
            "deletes it.")
                                    .with("slot", plan.after.slot));
}

/// Its values belong to the places of the sources that it had.
void WritePlanner::warnOfKeptTable()
{
    if (!m_keepsTable)
        return;
    WritePlan& plan = m_write.plan;
    const auto before = lookupAtSources(m_access.profile(), m_axis, sourcePaths(plan.before));
    if (before && plan.lookupAt && before != plan.lookupAt)
        plan.warnings.push_back(AXISCOMP_TEXT("Error",
            "The table stays, and its new source is on the other side of the compensation: its "
            "values belong to other positions. Write the table that was made for this source."));
    warnOfUnknownKinds();
    const auto own = ownDimension(m_access.profile(), m_axis, sourcePaths(plan.before));
    if (!own || *own >= plan.after.sources.size())
        return;
    const std::string& source = plan.after.sources[*own].path;
    const auto owner = m_access.profile().axisOfPosition(source);
    if (owner && *owner != m_axis)
        plan.warnings.push_back(AXISCOMP_TEXT("Error",
            "The table stays, and {source} is a position of another axis: its values belong to "
            "positions of the axis itself. Write the table that was made for this source.")
                                    .with("source", source));
}

/// What was over positions of an axis gets a register of which the profile says nothing.
void WritePlanner::warnOfUnknownKinds()
{
    WritePlan& plan = m_write.plan;
    const DriveProfile& profile = m_access.profile();
    for (std::size_t n = 0; n < plan.after.sources.size(); ++n) {
        const DimSource& source = plan.after.sources[n];
        if (!source.isSet() || source == plan.before.sources[n]
            || !profile.axisOfPosition(plan.before.sources[n].path)
            || profile.axisOfPosition(source.path))
            continue;
        plan.warnings.push_back(AXISCOMP_TEXT("Error",
            "The table stays, its dimension {number} has positions of an axis, and the profile "
            "does not say what {source} is. Write the table that was made for this source.")
                                    .with("number", n + 1)
                                    .with("source", Verbatim{sourceName(source)}));
    }
}

/// Where another axis has a volatile table when the parameters are saved; nothing: it has none. Of
/// one that is written before this one it is known what it has then.
std::optional<std::string> WritePlanner::volatileSlotOf(const AxisStatus& other) const
{
    const auto written = m_otherWrites.written.find(other.axis.index);
    const bool isWritten = written != m_otherWrites.written.end();
    const CompensationSetup& then = isWritten ? written->second : other.setup;
    const bool hasTable = isWritten ? then.tableCrc != 0 : other.table.has_value();
    if (!hasTable || then.persistency == Persistency::Persistent)
        return std::nullopt;
    return then.slot;
}

/// Saving stores the parameters of all axes, volatile tables of others included.
void WritePlanner::warnOfSaving()
{
    WritePlan& plan = m_write.plan;
    if (m_write.releases)
        plan.warnings.push_back(AXISCOMP_TEXT("Error",
            "After a reboot the drive would look for another table in {slot}: the parameters are "
            "saved once before the new one goes into flash. When the write is interrupted then, "
            "the axis may have no table after a reboot.")
                                    .with("slot", plan.after.slot));
    for (const AxisStatus& other : m_others) {
        const auto slot = volatileSlotOf(other);
        if (!slot)
            continue;
        if (!m_otherWrites.stored.contains(other.axis.index))
            plan.warnings.push_back(AXISCOMP_TEXT("Error",
                "The parameters of all axes are saved, but the table of {axis} in {slot} is "
                "volatile: after a reboot that axis has no table.")
                                        .with("axis", axisText(other.axis.index, other.axis.name))
                                        .with("slot", *slot));
        if (m_saved.isCovered(*slot))
            plan.warnings.push_back(AXISCOMP_TEXT("Error",
                "Flash may hold an older table in {slot}: it is deleted before the parameters are "
                "saved.")
                                        .with("slot", *slot));
    }
}

} // namespace axiscomp
