// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/unended_write.h"
#include "tests/ui/support/controller_fixture.h"

namespace axiscomp::test {

/// As if the program had been killed before the last step of the persistent 2D write that has just
/// ended: the drive has the new state, the journal is open.
[[nodiscard]] inline Result<void> reopenWrite(ControllerFixture& bench)
{
    return openJournalOf(
        bench.store(), bench.drive().drive, 4711, bench->setup().baseline(), "save");
}

} // namespace axiscomp::test
