// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/number_text.h"

#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <random>

namespace tst_significanttext {

using axiscomp::significantText;

/// Digits are those of printf, but for the locale of the computer and the run time of C.
class TestSignificantText : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { axiscomp::test::failOnWarnings(); }

    void digitsAreThoseOfPrintf_data()
    {
        QTest::addColumn<int>("digits");
        for (const int digits : {1, 2, 3, 12})
            QTest::addRow("%d digits", digits) << digits;
    }
    void digitsAreThoseOfPrintf()
    {
        QFETCH(int, digits);
        std::mt19937 random(1);
        std::uniform_real_distribution<double> mantissa(-10.0, 10.0);
        std::uniform_int_distribution<int> exponent(-20, 20);
        for (int i = 0; i < 10'000; ++i) {
            const double value = mantissa(random) * std::pow(10.0, exponent(random));
            std::array<char, 64> expected{};
            std::snprintf(expected.data(), expected.size(), "%.*g", digits, value);
            QCOMPARE(significantText(value, digits), std::string(expected.data()));
        }
        QCOMPARE(significantText(0.0, digits), std::string("0"));
    }
};

AXISCOMP_TEST(TestSignificantText)

} // namespace tst_significanttext

#include "tst_significanttext.moc"
