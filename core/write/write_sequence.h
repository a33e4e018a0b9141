// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/write/write_plan.h"

#include <map>
#include <string>

namespace axiscomp {

/// Writes to axes of one drive, planned together and carried out one after the other: what each of
/// them finds there when it comes to it.
class WriteSequence {
public:
    /// takenSlots: as WriteRequest has them, by axes that are not among these.
    explicit WriteSequence(std::map<std::string, Text> takenSlots = {});

    /// One of the writes, before the first of them is planned. isPersistent: of the table that the
    /// axis has then.
    void expect(int axis, bool isPersistent);
    /// The next one: its request gets what the others are to it.
    void begin(int axis, WriteRequest& request);
    /// What has become of the request.
    void add(const WritePlan& plan);

private:
    std::map<std::string, Text> m_takenSlots;
    OtherWrites m_others;
};

} // namespace axiscomp
