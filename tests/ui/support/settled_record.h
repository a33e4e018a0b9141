// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/patience.h"
#include "ui/record/record_model.h"

#include <QTest>

namespace axiscomp::test {

/// Whether everything that follows from what was done to a record has been worked out by now or
/// soon.
[[nodiscard]] inline bool settled(const ui::RecordModel& record)
{
    return QTest::qWaitFor(
        [&] { return !record.isEvaluating() && !record.isFitting(); }, patienceMs);
}

} // namespace axiscomp::test
