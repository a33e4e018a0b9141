// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/number_parser.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <random>

namespace tst_numberparser {

using namespace axiscomp;

namespace {

struct Reference {
    bool number = false;
    double value = 0.0;
};

/// What the rule names: std::from_chars over the whole text.
Reference reference(std::string_view text)
{
    Reference result;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), result.value);
    result.number = read.ec == std::errc{} && read.ptr == text.data() + text.size();
    return result;
}

bool sameBits(double a, double b)
{
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// The short form as the reader of plain rows uses it; nullptr where it declines.
const char* parseShort(const std::string& text, char decimal, Number& number)
{
    // What stands behind a number in a file must not matter.
    static std::string padded;
    padded = text + ";87654321012345678901234567890123456789012";
    const char* after = parseShortNumber(padded.data(), decimal, number);
    return after == nullptr || after != padded.data() + text.size() ? nullptr : after;
}

std::string randomNumber(std::mt19937& random)
{
    const auto below = [&random](int limit) {
        return std::uniform_int_distribution<int>(0, limit - 1)(random);
    };
    const auto digits = [&](int most) {
        std::string text;
        for (int count = below(most + 1); count > 0; --count)
            text += static_cast<char>('0' + below(10));
        return text;
    };
    std::string text = below(3) == 0 ? "-" : "";
    text += digits(below(4) == 0 ? 20 : 7);
    if (below(5) != 0)
        text += '.' + digits(below(4) == 0 ? 25 : 9);
    if (below(5) == 0)
        text += (below(2) == 0 ? "e" : "E") + std::string(below(2) == 0 ? "-" : "+") + digits(3);
    return text;
}

} // namespace

class TestCsvNumber : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void numbersAreThoseOfFromChars_data()
    {
        QTest::addColumn<char>("decimal");
        QTest::newRow("point") << '.';
        QTest::newRow("comma") << ',';
    }
    void numbersAreThoseOfFromChars()
    {
        QFETCH(char, decimal);
        std::mt19937 random(7);
        int read = 0;
        int readShort = 0;
        for (int i = 0; i < 300'000; ++i) {
            std::string text = randomNumber(random);
            const Reference due = reference(text);
            std::ranges::replace(text, '.', decimal);
            Number number;
            const bool isNumber = parseNumber(text, decimal, number) == NumberFault::None;
            QVERIFY2(isNumber == due.number, text.c_str());
            if (isNumber)
                QVERIFY2(sameBits(number.value, due.value), text.c_str());
            read += isNumber ? 1 : 0;
            Number shortNumber;
            if (parseShort(text, decimal, shortNumber) == nullptr)
                continue;
            ++readShort;
            QVERIFY2(isNumber && sameBits(shortNumber.value, due.value), text.c_str());
            QVERIFY2(shortNumber.lastDecimal == number.lastDecimal, text.c_str());
        }
        // Otherwise the comparison would be about nothing.
        QVERIFY(read > 200'000);
        QVERIFY(readShort > 150'000);
    }

    void theShortestTextOfEveryDoubleIsReadExactly()
    {
        std::mt19937_64 random(11);
        std::array<char, 32> buffer{};
        for (int i = 0; i < 200'000; ++i) {
            const auto value = std::bit_cast<double>(random());
            if (!std::isfinite(value))
                continue;
            const auto written = std::to_chars(buffer.data(), buffer.data() + 32, value);
            Number number;
            const std::string text(buffer.data(), written.ptr);
            QVERIFY2(parseNumber(text, '.', number) == NumberFault::None, text.c_str());
            QVERIFY2(sameBits(number.value, value), text.c_str());
        }
    }

    void aTextIsANumberOrSaysWhyNot_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("fault");
        const auto row = [](const char* text, NumberFault fault) {
            QTest::newRow(*text == '\0' ? "empty" : text)
                << QByteArray(text) << static_cast<int>(fault);
        };
        for (const char* text : {"0", "-0", "+0", "1", "+1", "1.", ".5", "+.5", "1e5", "1E+05",
                 "1.5e-3", "00012", "123456789012345678901234567890", "4.9e-324",
                 "1.7976931348623157e308", "0e99999", "0.0e-99999999999"})
            row(text, NumberFault::None);
        for (const char* text : {"", "+", "-", ".", "+-1", "-+1", "++1", "1e", "e1", "1e+", "0x10",
                 "1 ", " 1", "1,5", "1.2.3", "1_000", "1'000", "nano", "infinite",
                 "\xC2\xA0"
                 "1"})
            row(text, NumberFault::NotANumber);
        for (const char* text :
            {"nan", "NaN", "nan(1)", "inf", "-INF", "infinity", "1e309", "-1e400", "1e99999999999"})
            row(text, NumberFault::NotFinite);
        for (const char* text : {"1e-400", "-1e-99999999999", "0.1e-330"})
            row(text, NumberFault::TooSmall);
        const QByteArray zeros(400, '0');
        QTest::newRow("1 and 400 zeros") << "1" + zeros << static_cast<int>(NumberFault::NotFinite);
        QTest::newRow("400 zeros and 1")
            << "0." + zeros + "1" << static_cast<int>(NumberFault::TooSmall);
        QTest::newRow("400 zeros") << "0." + zeros << static_cast<int>(NumberFault::None);
    }
    void aTextIsANumberOrSaysWhyNot()
    {
        QFETCH(QByteArray, text);
        QFETCH(int, fault);
        Number number;
        QCOMPARE(static_cast<int>(parseNumber(text.toStdString(), '.', number)), fault);
    }

    void theLastDecimalIsTheOnePrinted_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("lastDecimal");
        QTest::newRow("whole") << QByteArray("12") << 0;
        QTest::newRow("decimals") << QByteArray("-12.500") << -3;
        QTest::newRow("point without decimals") << QByteArray("12.") << 0;
        QTest::newRow("exponent") << QByteArray("1.25e-3") << -5;
        QTest::newRow("large exponent") << QByteArray("1.25E+6") << 4;
        QTest::newRow("17 digits") << QByteArray("0.33333333333333331") << -17;
    }
    void theLastDecimalIsTheOnePrinted()
    {
        QFETCH(QByteArray, text);
        QFETCH(int, lastDecimal);
        Number number;
        QVERIFY(parseNumber(text.toStdString(), '.', number) == NumberFault::None);
        QCOMPARE(number.lastDecimal, lastDecimal);
    }
};

AXISCOMP_TEST(TestCsvNumber)

} // namespace tst_numberparser

#include "tst_numberparser.moc"
