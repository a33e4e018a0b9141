// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/machine/machine_texts.h"

#include "core/text/crc_text.h"

#include <vector>

namespace axiscomp {

namespace {

/// What was switched on is proved then, or it is said that it is not.
Text withProof(const TextPattern& done, const Activation& activation)
{
    if (!activation.proof || !*activation.proof)
        return done;
    return (activation.notProved() ? AXISCOMP_TEXT("Machine", "{outcome}, not proved")
                                   : AXISCOMP_TEXT("Machine", "{outcome}, proved"))
        .with("outcome", done);
}

} // namespace

Text fieldText(const std::string& field)
{
    if (field == "Table")
        return AXISCOMP_TEXT("Machine", "Table");
    if (field == "Dimensionality")
        return AXISCOMP_TEXT("Machine", "Dimensionality");
    if (field == "Persistency")
        return AXISCOMP_TEXT("Machine", "Persistency");
    for (const char* number : {"1", "2", "3"})
        if (field == std::string("Dim") + number + "Source")
            return AXISCOMP_TEXT("Machine", "Dim{n}Source").with("n", std::string(number));
    return Verbatim{field};
}

Text differenceText(const AxisPlan& axis)
{
    if (axis.problem)
        return AXISCOMP_TEXT("Machine", "problem");
    if (!axis.differs())
        return AXISCOMP_TEXT("Machine", "has all of this");
    std::vector<Text> fields;
    for (const PlannedChange& change : axis.plan.changes)
        fields.push_back(fieldText(change.field));
    if (axis.isUnfinished)
        fields.emplace_back(AXISCOMP_TEXT("Machine", "unfinished write"));
    if (axis.switches)
        fields.emplace_back(AXISCOMP_TEXT("Machine", "Activation"));
    return AXISCOMP_TEXT("Machine", "differs: {fields}").with("fields", fields);
}

Text outcomeText(const AxisOutcome& outcome)
{
    if (outcome.problem)
        return AXISCOMP_TEXT("Machine", "failed");
    if (outcome.awaitsWrite)
        return outcome.activation ? AXISCOMP_TEXT("Machine", "switched, not written")
                                  : AXISCOMP_TEXT("Machine", "not written");
    if (outcome.awaitsSwitch)
        return outcome.report ? AXISCOMP_TEXT("Machine", "written, not switched")
                              : AXISCOMP_TEXT("Machine", "not switched");
    if (outcome.report)
        return outcome.activation
            ? withProof(AXISCOMP_TEXT("Machine", "written and switched"), *outcome.activation)
            : AXISCOMP_TEXT("Machine", "written");
    if (outcome.activation)
        return withProof(AXISCOMP_TEXT("Machine", "switched"), *outcome.activation);
    return AXISCOMP_TEXT("Machine", "nothing to do");
}

Text heldText(const AxisStatus& status)
{
    const std::string& slot = status.setup.slot;
    if (slot.empty())
        return AXISCOMP_TEXT("Machine", "no table");
    if (!status.table)
        return AXISCOMP_TEXT("Machine", "{slot}, empty").with("slot", slot);
    const TextPattern held = status.table->persistent
        ? AXISCOMP_TEXT("Machine", "{slot}, persistent, CRC {crc}")
        : AXISCOMP_TEXT("Machine", "{slot}, volatile, CRC {crc}");
    return held.with("slot", slot).with("crc", crcText(status.table->crc));
}

} // namespace axiscomp
