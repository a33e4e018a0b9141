// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/even_spacing.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <cmath>
#include <random>
#include <vector>

namespace tst_evenspacing {

using namespace axiscomp;

namespace {

std::vector<double> positions(double start, double distance, int count)
{
    std::vector<double> result;
    for (int i = 0; i < count; ++i)
        result.push_back(start + i * distance);
    return result;
}

std::vector<double> rounded(std::vector<double> values, int decimals)
{
    for (double& value : values)
        value = QByteArray::number(value, 'f', decimals).toDouble();
    return values;
}

constexpr int allDecimals = -17; ///< all digits were printed

} // namespace

class TestEvenSpacing : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void spacingIsEvenWithinWhatIsPrinted_data()
    {
        QTest::addColumn<QList<double>>("lines");
        QTest::addColumn<int>("lastDecimal");
        QTest::addColumn<bool>("even");
        QTest::addColumn<bool>("rounded");
        using List = QList<double>;
        QTest::newRow("exact") << List{0, 1, 2, 3} << 0 << true << false;
        QTest::newRow("thirds") << List{0, 0.333, 0.667, 1} << -3 << true << true;
        QTest::newRow("more than rounding") << List{0, 0.33, 0.70, 1} << -2 << false << false;
        QTest::newRow("doubling") << List{0, 1, 2, 4} << 0 << false << false;
        QTest::newRow("two") << List{0, 0.7} << -1 << true << false;
        // Half a unit would be 0.5, but 1 % of the distance is 0.1.
        QTest::newRow("at most 1 % of the distance")
            << List{0, 10, 20, 30.2, 40} << 0 << false << false;
        QTest::newRow("below 1 % of the distance")
            << List{0, 10, 20, 30.1, 40} << 0 << true << true;
        // Printed with all digits the tolerance is a billionth of the range, 4e-8.
        QTest::newRow("a billionth of the range")
            << List{0, 10, 20.00000003, 30, 40} << allDecimals << true << false;
        QTest::newRow("more than a billionth")
            << List{0, 10, 20.0000001, 30, 40} << allDecimals << false << false;
        QTest::newRow("far from zero")
            << List{1e9, 1e9 + 0.001, 1e9 + 0.002, 1e9 + 0.003} << -3 << true << false;
    }
    void spacingIsEvenWithinWhatIsPrinted()
    {
        QFETCH(QList<double>, lines);
        QFETCH(int, lastDecimal);
        QFETCH(bool, even);
        QFETCH(bool, rounded);
        const EvenSpacing spacing =
            fitEvenSpacing({lines.data(), static_cast<std::size_t>(lines.size())}, lastDecimal);
        QCOMPARE(spacing.even, even);
        QCOMPARE(spacing.rounded, rounded);
    }

    void startAndDistanceAreTheLeastSquaresLine()
    {
        const std::vector<double> lines{0, 0.333, 0.667, 1};
        const EvenSpacing spacing = fitEvenSpacing(lines, -3);
        QVERIFY(std::fabs(spacing.distance - 0.3334) < 1e-15);
        QVERIFY(std::fabs(spacing.start + 0.0001) < 1e-15);
        QVERIFY(std::fabs(spacing.deviation - 0.0003) < 1e-12);
    }

    void aPlainDistanceIsFoundAgain_data()
    {
        QTest::addColumn<double>("start");
        QTest::addColumn<double>("distance");
        QTest::addColumn<int>("count");
        QTest::newRow("tenths") << 0.0 << 0.1 << 1001;
        QTest::newRow("tenths from -50") << -50.0 << 0.1 << 1001;
        QTest::newRow("three tenths") << 0.1 << 0.3 << 4;
        QTest::newRow("micrometres far away") << 1234567.891 << 0.001 << 500;
        QTest::newRow("large") << -1e12 << 2.5e11 << 9;
        QTest::newRow("small") << 1e-9 << 1e-12 << 33;
    }
    void aPlainDistanceIsFoundAgain()
    {
        QFETCH(double, start);
        QFETCH(double, distance);
        QFETCH(int, count);
        const EvenSpacing spacing = fitEvenSpacing(positions(start, distance, count), allDecimals);
        QVERIFY(spacing.even && !spacing.rounded);
        QVERIFY(spacing.start == start);
        QVERIFY(spacing.distance == distance);
    }

    void honestlyRoundedPositionsAreEven()
    {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> any(0.0, 1.0);
        for (int i = 0; i < 20'000; ++i) {
            const int decimals = static_cast<int>(any(random) * 5);
            const double unit = std::pow(10.0, -decimals);
            // From 51 units up half a unit is below 1 % of the distance.
            const double distance = unit * (51.0 + 1000.0 * any(random));
            const int count = 2 + static_cast<int>(any(random) * 100);
            const std::vector<double> lines =
                rounded(positions(200.0 * any(random) - 100.0, distance, count), decimals);
            const EvenSpacing spacing = fitEvenSpacing(lines, -decimals);
            QVERIFY2(spacing.even, std::to_string(spacing.deviation / unit).c_str());
            QVERIFY(spacing.deviation < unit);
        }
    }

    void theLineIsFoundAgainFromItsOwnPositions()
    {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> any(-1.0, 1.0);
        for (int i = 0; i < 5'000; ++i) {
            const int count = 2 + static_cast<int>(50.0 * std::fabs(any(random)));
            std::vector<double> lines = positions(any(random) * std::pow(10.0, 4.0 * any(random)),
                std::fabs(any(random)) * std::pow(10.0, 3.0 * any(random)) + 1e-6, count);
            if (i % 2 == 0)
                lines = rounded(lines, 8);
            const EvenSpacing first = fitEvenSpacing(lines, i % 2 == 0 ? -8 : allDecimals);
            if (!first.even)
                continue;
            const EvenSpacing again =
                fitEvenSpacing(positions(first.start, first.distance, count), allDecimals);
            QVERIFY(again.even);
            QVERIFY(again.start == first.start);
            QVERIFY(again.distance == first.distance);
        }
    }
};

AXISCOMP_TEST(TestEvenSpacing)

} // namespace tst_evenspacing

#include "tst_evenspacing.moc"
