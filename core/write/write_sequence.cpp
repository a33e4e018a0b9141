// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/write/write_sequence.h"

#include <utility>

namespace axiscomp {

WriteSequence::WriteSequence(std::map<std::string, Text> takenSlots)
    : m_takenSlots(std::move(takenSlots))
{
}

void WriteSequence::expect(int axis, bool isPersistent)
{
    if (isPersistent)
        m_others.stored.insert(axis);
}

void WriteSequence::begin(int axis, WriteRequest& request)
{
    m_others.stored.erase(axis);
    request.takenSlots = m_takenSlots;
    request.others = m_others;
}

void WriteSequence::add(const WritePlan& plan)
{
    m_others.written.insert_or_assign(plan.axis, plan.after);
    if (plan.slotReason != SlotReason::KeepTable)
        m_takenSlots.emplace(plan.after.slot,
            AXISCOMP_TEXT("Error", "axis {axis}, which is written first").with("axis", plan.axis));
}

} // namespace axiscomp
