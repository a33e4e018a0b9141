// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a person should know before a write.
#include "core/table/position_unit.h"
#include "core/write/write_planner.h"

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

void WritePlanner::warn()
{
    WritePlan& plan = m_write.plan;
    if (plan.slotReason == SlotReason::OverwriteOwn)
        plan.warnings.push_back(AXISCOMP_TEXT("Error",
            "No other slot is free: the table in {slot} is overwritten. A copy is kept in the "
            "backup.")
                                    .with("slot", plan.after.slot));
    if (plan.slotReason == SlotReason::Named)
        plan.warnings.push_back(AXISCOMP_TEXT(
            "Error", "What {slot} holds now is overwritten. A copy is kept in the backup.")
                                    .with("slot", plan.after.slot));
    if (plan.after.persistency == Persistency::Persistent)
        return warnOfSaving();
    if (plan.slotReason == SlotReason::KeepTable)
        return;
    if (m_status.table && m_status.table->persistent)
        plan.warnings.push_back(AXISCOMP_TEXT("Error",
            "The new table is volatile: after a reboot the axis has the old, persistent one "
            "again."));
    if (m_write.slotBefore.persistent && plan.after.slot != plan.before.slot)
        plan.warnings.push_back(AXISCOMP_TEXT("Error",
            "The new table is volatile and covers an older one that flash holds in {slot}: after a "
            "reboot the axis may have that one again, until the parameters are saved, which "
            "deletes it.")
                                    .with("slot", plan.after.slot));
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
        if (!other.table || other.table->persistent)
            continue;
        plan.warnings.push_back(AXISCOMP_TEXT("Error",
            "The parameters of all axes are saved, but the table of {axis} in {slot} is volatile: "
            "after a reboot that axis has no table.")
                                    .with("axis", axisText(other.axis.index, other.axis.name))
                                    .with("slot", other.setup.slot));
        if (m_saved.isCovered(other.setup.slot))
            plan.warnings.push_back(AXISCOMP_TEXT("Error",
                "Flash may hold an older table in {slot}: it is deleted before the parameters are "
                "saved.")
                                        .with("slot", other.setup.slot));
    }
}

/// Numbers are never converted: micrometres are a thousand times too large for an axis that counts
/// in millimetres.
void WritePlanner::warnOfUnit(const CompensationTable& table)
{
    const std::string& positionUnit = m_status.axis.unit;
    if (table.unit.empty() || isSameUnit(table.unit, positionUnit))
        return;
    const std::string symbol = unitSymbol(positionUnit);
    const auto factor = unitFactor(positionUnit, table.unit);
    const bool isTooLarge = factor && *factor > 1.0;
    TextPattern pattern = AXISCOMP_TEXT("Error",
        "The file says that the values are in {unit}, but {axis} counts in {other}: the numbers "
        "are written as they are, not converted.");
    if (isTooLarge)
        pattern = AXISCOMP_TEXT("Error",
            "The file says that the values are in {unit}, but {axis} counts in {other}: the "
            "numbers are written as they are, not converted, {factor} times too large.");
    else if (factor)
        pattern = AXISCOMP_TEXT("Error",
            "The file says that the values are in {unit}, but {axis} counts in {other}: the "
            "numbers are written as they are, not converted, {factor} times too small.");
    Text warning = pattern.with("unit", table.unit)
                       .with("axis", axisText(m_axis, m_status.axis.name))
                       .with("other", symbol.empty() ? positionUnit : symbol);
    if (factor)
        warning = std::move(warning).with(
            "factor", Quantity{factorText(isTooLarge ? *factor : 1.0 / *factor)});
    m_write.plan.warnings.push_back(std::move(warning));
}

} // namespace axiscomp
