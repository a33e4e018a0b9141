// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>

namespace axiscomp::test {

/// How long a test waits for what must happen: on a busy machine everything happens late. It is
/// used up only where something never happens.
inline constexpr int patienceMs = 120'000;

} // namespace axiscomp::test

// Qt's own five seconds are too short for a busy machine.
#undef QTRY_VERIFY
#define QTRY_VERIFY(condition) QTRY_VERIFY_WITH_TIMEOUT(condition, axiscomp::test::patienceMs)
#undef QTRY_VERIFY2
#define QTRY_VERIFY2(condition, message)                                                           \
    QTRY_VERIFY2_WITH_TIMEOUT(condition, message, axiscomp::test::patienceMs)
#undef QTRY_COMPARE
#define QTRY_COMPARE(actual, expected)                                                             \
    QTRY_COMPARE_WITH_TIMEOUT(actual, expected, axiscomp::test::patienceMs)
