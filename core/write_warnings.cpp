// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a person should know before a write.
#include "core/position_unit.h"
#include "core/write_planner.h"

#include <charconv>

namespace axiscomp {

namespace {

/// "1000", "25.4": never with an exponent.
std::string factorText(double factor)
{
    char digits[32];
    const bool isLarge = factor >= 1000.0;
    const auto end = std::to_chars(digits, digits + sizeof digits, factor,
        isLarge ? std::chars_format::fixed : std::chars_format::general, isLarge ? 0 : 4)
                         .ptr;
    return {digits, end};
}

} // namespace

Result<void> WritePlanner::warn()
{
    WritePlan& plan = m_write.plan;
    if (plan.slotReason == SlotReason::OverwriteOwn)
        plan.warnings.push_back("No other slot is free: the table in " + plan.after.slot
            + " is overwritten. A copy is kept in the backup.");
    if (plan.slotReason == SlotReason::Named)
        plan.warnings.push_back(
            "What " + plan.after.slot + " holds now is overwritten. A copy is kept in the backup.");
    if (plan.after.persistency == Persistency::Volatile && m_status.table
        && m_status.table->persistent && plan.slotReason != SlotReason::KeepTable)
        plan.warnings.push_back("The new table is volatile: after a reboot the axis has the old, "
                                "persistent one again.");
    if (plan.after.persistency != Persistency::Persistent)
        return {};

    // Saving stores the parameters of all axes, volatile tables of others included.
    for (int axis = 0; axis < m_drive.axes; ++axis) {
        if (axis == m_axis)
            continue;
        auto other = readStatus(m_access, m_drive, axis, m_sources);
        if (!other && other.error().code == ErrorCode::NoCompensation)
            continue;
        if (!other)
            return fail(other.error());
        if (other->table && !other->table->persistent)
            plan.warnings.push_back("The parameters of all axes are saved, but the table of "
                + axisText(axis, other->axis.name) + " in " + other->setup.slot
                + " is volatile: after a reboot that axis has no table.");
    }
    return {};
}

/// Numbers are never converted: micrometres are a thousand times too large for an axis that counts
/// in millimetres.
void WritePlanner::warnOfUnit(const CompensationTable& table)
{
    const std::string& positionUnit = m_status.axis.unit;
    if (table.unit.empty() || isSameUnit(table.unit, positionUnit))
        return;
    const std::string symbol = unitSymbol(positionUnit);
    std::string warning = "The file says that the values are in " + table.unit + ", but "
        + axisText(m_axis, m_status.axis.name) + " counts in "
        + (symbol.empty() ? positionUnit : symbol)
        + ": the numbers are written as they are, not converted";
    if (const auto factor = unitFactor(positionUnit, table.unit)) {
        const bool isTooLarge = *factor > 1.0;
        warning += ", " + factorText(isTooLarge ? *factor : 1.0 / *factor)
            + (isTooLarge ? " times too large" : " times too small");
    }
    m_write.plan.warnings.push_back(warning + ".");
}

} // namespace axiscomp
