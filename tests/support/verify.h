// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QTest>

namespace axiscomp::test {

/// Any warning that Qt logs fails the test unless it was announced with QTest::ignoreMessage.
inline void failOnWarnings()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
}

inline std::string describe(const Error& error)
{
    return std::string(errorName(error.code)) + ": " + sentence(error)
        + (error.detail.empty() ? "" : " [" + error.detail + "]");
}

} // namespace axiscomp::test

/// Fails with the error's sentence when result holds one. Evaluates result once.
#define VERIFY_RESULT(result)                                                                      \
    do {                                                                                           \
        const auto& verified = (result);                                                           \
        QVERIFY2(verified.has_value(),                                                             \
            verified.has_value() ? "" : axiscomp::test::describe(verified.error()).c_str());       \
    } while (false)

/// Fails unless result holds an error with this code. Evaluates result once.
#define VERIFY_ERROR(result, expectedCode)                                                         \
    do {                                                                                           \
        const auto& verified = (result);                                                           \
        QVERIFY2(!verified.has_value(), "there was no error");                                     \
        QVERIFY2(verified.error().code == (expectedCode),                                          \
            axiscomp::test::describe(verified.error()).c_str());                                   \
    } while (false)
