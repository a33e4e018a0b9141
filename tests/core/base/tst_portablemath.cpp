// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/portable_math.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <bit>
#include <charconv>
#include <cmath>
#include <functional>
#include <random>

namespace tst_portablemath {

using namespace axiscomp;

/// What an argument is taken from.
struct Range {
    double low = 0.0;
    double high = 0.0;
};

namespace {

using Function = std::function<double(double, double)>;
using Reference = std::function<long double(long double, long double)>;

/// Of one whose ends are positive, evenly in orders of magnitude.
double from(std::mt19937_64& random, const Range& range)
{
    const double share = static_cast<double>(random() >> 11U) * 0x1p-53;
    if (range.low > 0.0)
        return range.low * std::pow(range.high / range.low, share);
    return range.low + share * (range.high - range.low);
}

std::uint64_t bitsOf(double value)
{
    return std::bit_cast<std::uint64_t>(value);
}

} // namespace

class TestPortableMath : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }
    void theNearestDoubleComesOut_data();
    void theNearestDoubleComesOut();
    void theBitsAreTheseOnEveryComputer_data();
    void theBitsAreTheseOnEveryComputer();
    void powersOfTenAreExact();
    void whatIsNoNumberStaysNone();
};

void TestPortableMath::theNearestDoubleComesOut_data()
{
    QTest::addColumn<Function>("function");
    QTest::addColumn<Reference>("reference");
    QTest::addColumn<Range>("first");
    QTest::addColumn<Range>("second");
    const Range none{0.0, 0.0};
    const Range anything{-50.0, 50.0};
    const Range large{-1e9, 1e9};
    const Range positive{1e-30, 1e30};
    const Function sine = [](double a, double) { return portable::sin(a); };
    const Function cosine = [](double a, double) { return portable::cos(a); };
    const Function logarithm = [](double a, double) { return portable::log(a); };
    const Reference sineL = [](long double a, long double) { return std::sin(a); };
    const Reference cosineL = [](long double a, long double) { return std::cos(a); };
    const Reference logarithmL = [](long double a, long double) { return std::log(a); };
    QTest::newRow("sin") << sine << sineL << anything << none;
    QTest::newRow("sin of many turns") << sine << sineL << large << none;
    QTest::newRow("sin of little") << sine << sineL << Range{1e-20, 1e-3} << none;
    QTest::newRow("cos") << cosine << cosineL << anything << none;
    QTest::newRow("cos of many turns") << cosine << cosineL << large << none;
    QTest::newRow("atan2") << Function([](double a, double b) {
        return portable::atan2(a, b);
    }) << Reference([](long double a, long double b) { return std::atan2(a, b); })
                           << anything << anything;
    QTest::newRow("log") << logarithm << logarithmL << positive << none;
    QTest::newRow("log beside 1") << logarithm << logarithmL << Range{0.99, 1.01} << none;
    QTest::newRow("log2") << Function([](double a, double) { return portable::log2(a); })
                          << Reference([](long double a, long double) { return std::log2(a); })
                          << positive << none;
    QTest::newRow("log10") << Function([](double a, double) { return portable::log10(a); })
                           << Reference([](long double a, long double) { return std::log10(a); })
                           << positive << none;
    QTest::newRow("pow") << Function([](double a, double b) { return portable::pow(a, b); })
                         << Reference([](long double a, long double b) { return std::pow(a, b); })
                         << Range{1e-9, 1e9} << Range{-4.0, 4.0};
}

/// The reference has 11 digits more, and may itself be wrong where these say nothing.
void TestPortableMath::theNearestDoubleComesOut()
{
    QFETCH(Function, function);
    QFETCH(Reference, reference);
    QFETCH(Range, first);
    QFETCH(Range, second);
    constexpr int count = 20'000;
    constexpr int mostDoubtful = count / 500;
    std::mt19937_64 random(7);
    int other = 0;
    for (int i = 0; i < count; ++i) {
        const double a = from(random, first);
        const double b = from(random, second);
        const double value = function(a, b);
        const auto expected = static_cast<double>(reference(a, b));
        if (value == expected)
            continue;
        ++other;
        QVERIFY2(
            value == std::nextafter(expected, 1e300) || value == std::nextafter(expected, -1e300),
            qPrintable(
                QStringLiteral("%1 %2: %3").arg(a, 0, 'g', 17).arg(b, 0, 'g', 17).arg(value)));
    }
    QVERIFY2(other <= mostDoubtful, std::to_string(other).c_str());
}

/// The GNU C library has another last bit for the first two.
void TestPortableMath::theBitsAreTheseOnEveryComputer_data()
{
    QTest::addColumn<double>("value");
    QTest::addColumn<double>("expected");
    QTest::newRow("sin(8.85)") << portable::sin(8.85) << 0x1.165916bc22613p-1;
    QTest::newRow("log10(0.17)") << portable::log10(0.17) << -0x1.8a029956904d1p-1;
    QTest::newRow("cos(0.7)") << portable::cos(0.7) << 0x1.87996529f9d93p-1;
    QTest::newRow("cos(123456.7)") << portable::cos(123456.7) << -0x1.3186f285e765p-5;
    QTest::newRow("atan2(1.0, 3.0)") << portable::atan2(1.0, 3.0) << 0x1.4978fa3269ee1p-2;
    QTest::newRow("atan2(-2.5, -0.1)") << portable::atan2(-2.5, -0.1) << -0x1.9c5bc055fe183p+0;
    QTest::newRow("log(3.0)") << portable::log(3.0) << 0x1.193ea7aad030bp+0;
    QTest::newRow("log2(10.0)") << portable::log2(10.0) << 0x1.a934f0979a371p+1;
    QTest::newRow("pow(10.0, -2.3)") << portable::pow(10.0, -2.3) << 0x1.487543c6a9257p-8;
    QTest::newRow("pow(0.3, 1.0 / 3.0)") << portable::pow(0.3, 1.0 / 3.0) << 0x1.56bfea66ef78dp-1;
    QTest::newRow("hypot(0.1, 0.7)") << portable::hypot(0.1, 0.7) << 0x1.6a09e667f3bccp-1;
}

void TestPortableMath::theBitsAreTheseOnEveryComputer()
{
    QFETCH(double, value);
    QFETCH(double, expected);
    QCOMPARE(bitsOf(value), bitsOf(expected));
}

void TestPortableMath::powersOfTenAreExact()
{
    for (int exponent = -307; exponent <= 308; ++exponent) {
        const std::string text = "1e" + std::to_string(exponent);
        double expected = 0.0;
        std::from_chars(text.data(), text.data() + text.size(), expected);
        QCOMPARE(bitsOf(portable::pow(10.0, exponent)), bitsOf(expected));
        QCOMPARE(portable::log10(expected), static_cast<double>(exponent));
    }
}

void TestPortableMath::whatIsNoNumberStaysNone()
{
    const double infinity = std::numeric_limits<double>::infinity();
    const double none = std::numeric_limits<double>::quiet_NaN();
    for (const double angle : {infinity, -infinity, none}) {
        QVERIFY(std::isnan(portable::sin(angle)));
        QVERIFY(std::isnan(portable::cos(angle)));
    }
    QVERIFY(std::abs(portable::sin(1e300)) <= 1.0);
    QCOMPARE(portable::log(0.0), -infinity);
    QVERIFY(std::isnan(portable::log10(-1.0)));
    QCOMPARE(portable::pow(10.0, 400.0), infinity);
    QCOMPARE(portable::pow(10.0, -400.0), 0.0);
    QCOMPARE(portable::pow(0.0, 0.5), 0.0);
    QCOMPARE(portable::pow(0.0, -0.5), infinity);
    QVERIFY(std::isnan(portable::pow(-1.0, 0.5)));
    QCOMPARE(portable::atan2(0.0, 0.0), 0.0);
    QCOMPARE(portable::atan2(0.0, -1.0), std::acos(-1.0));
}

AXISCOMP_TEST(TestPortableMath)

} // namespace tst_portablemath

#include "tst_portablemath.moc"
