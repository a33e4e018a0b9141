// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive/register_value.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace tst_registervalue {

using namespace axiscomp;

class TestRegisterValue : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void textIsReadAsItsType_data()
    {
        QTest::addColumn<std::string>("type");
        QTest::addColumn<std::string>("text");
        QTest::addColumn<RegisterValue>("expected");
        const auto row = [](const char* type, const char* text, RegisterValue expected) {
            QTest::addRow("%s %s", type, text)
                << std::string(type) << std::string(text) << expected;
        };
        for (const char* text : {"true", "True", "1"})
            row("Boolean", text, true);
        for (const char* text : {"false", "False", "0"})
            row("Boolean", text, false);
        row("Int32", "0", std::int32_t{0});
        row("Int32", "-2147483648", std::numeric_limits<std::int32_t>::min());
        row("Int32", "2147483647", std::numeric_limits<std::int32_t>::max());
        row("UInt32", "4294967295", std::numeric_limits<std::uint32_t>::max());
        row("UInt32", "0x1234", std::uint32_t{0x1234});
        row("UInt32", "0XFFFFFFFF", std::numeric_limits<std::uint32_t>::max());
        row("Single", "12.5", 12.5F);
        row("Single", "-1e-3", -0.001F);
        row("Single", "3.4028235e+38", std::numeric_limits<float>::max());
        row("Single", "inf", std::numeric_limits<float>::infinity());
        row("Double", "0.1", 0.1);
        row("Double", "1.7976931348623157e308", std::numeric_limits<double>::max());
        row("Double", "-0", -0.0);
        row("HomingState", "HomingDone", std::string("HomingDone"));
        row("SourceTable", "Large1", std::string("Large1"));
    }
    void textIsReadAsItsType()
    {
        QFETCH(std::string, type);
        QFETCH(std::string, text);
        QFETCH(RegisterValue, expected);
        const auto value = registerValueFromText(type, text);
        VERIFY_RESULT(value);
        QCOMPARE(value->index(), expected.index());
        QVERIFY(*value == expected);
    }

    void wrongTextIsRefusedWithTheTypeAndTheText_data()
    {
        QTest::addColumn<std::string>("type");
        QTest::addColumn<std::string>("text");
        const auto row = [](const char* type, const char* text) {
            QTest::addRow("%s '%s'", type, text) << std::string(type) << std::string(text);
        };
        for (const char* text : {"", "TRUE", "yes", "2", "true ", " 0", "00"})
            row("Boolean", text);
        for (const char* text :
            {"", "-2147483649", "2147483648", "1.0", "1e3", "+1", " 1", "1 ", "0x10", "--1"})
            row("Int32", text);
        for (const char* text : {"", "-1", "4294967296", "0x", "0x100000000", "0x-1", "x12", "1_0"})
            row("UInt32", text);
        for (const char* text : {"", "1,5", "1e39", "-1e39", "1.5x", "+1", ".", "e5", "0x1p3"})
            row("Single", text);
        for (const char* text : {"", "1e309", "12.5 ", "\t1", "one"})
            row("Double", text);
        for (const char* text : {"", "Homing Done", "a\nb", "\"a\""})
            row("HomingState", text);
        row("", "Done");
    }
    void wrongTextIsRefusedWithTheTypeAndTheText()
    {
        QFETCH(std::string, type);
        QFETCH(std::string, text);
        const auto value = registerValueFromText(type, text);
        VERIFY_ERROR(value, ErrorCode::InvalidArgument);
        const std::string words = sentence(value.error());
        QVERIFY(words.find(type) != std::string::npos);
        QVERIFY(words.find('"' + text + '"') != std::string::npos);
        QVERIFY(words.find("expected ") != std::string::npos);
    }

    void aLongTextIsQuotedInPart()
    {
        const auto value = registerValueFromText("Int32", std::string(100'000, 'x'));
        VERIFY_ERROR(value, ErrorCode::InvalidArgument);
        QVERIFY(sentence(value.error()).size() < 300);
    }

    void numbersAreShownInTheShortestExactForm_data()
    {
        QTest::addColumn<RegisterValue>("value");
        QTest::addColumn<std::string>("expected");
        QTest::newRow("bool") << RegisterValue(true) << std::string("true");
        QTest::newRow("int") << RegisterValue(std::int32_t{-12}) << std::string("-12");
        QTest::newRow("uint") << RegisterValue(std::uint32_t{4000000000})
                              << std::string("4000000000");
        QTest::newRow("single") << RegisterValue(0.1F) << std::string("0.1");
        QTest::newRow("double") << RegisterValue(0.1) << std::string("0.1");
        QTest::newRow("single as double")
            << RegisterValue(static_cast<double>(0.1F)) << std::string("0.10000000149011612");
        QTest::newRow("half") << RegisterValue(12.5) << std::string("12.5");
        QTest::newRow("enum") << RegisterValue(std::string("HomingDone"))
                              << std::string("HomingDone");
    }
    void numbersAreShownInTheShortestExactForm()
    {
        QFETCH(RegisterValue, value);
        QFETCH(std::string, expected);
        QCOMPARE(toText(value), expected);
    }

    void everyNumberComesBackFromItsText()
    {
        std::mt19937_64 generator(1);
        for (int round = 0; round < 100'000; ++round) {
            const std::uint64_t bits = generator();
            double number = 0.0;
            std::memcpy(&number, &bits, sizeof(number));
            float single = 0.0F;
            std::memcpy(&single, &bits, sizeof(single));
            if (std::isfinite(number)) {
                const auto back = registerValueFromText("Double", toText(RegisterValue{number}));
                VERIFY_RESULT(back);
                QVERIFY(std::get<double>(*back) == number);
            }
            if (std::isfinite(single)) {
                const auto back = registerValueFromText("Single", toText(RegisterValue{single}));
                VERIFY_RESULT(back);
                QVERIFY(std::get<float>(*back) == single);
            }
        }
    }

    void aValueStandsForANumberUnlessItIsAnEnum()
    {
        QCOMPARE(toDouble(true), 1.0);
        QCOMPARE(toDouble(std::int32_t{-3}), -3.0);
        QCOMPARE(toDouble(std::numeric_limits<std::uint32_t>::max()), 4294967295.0);
        QCOMPARE(toDouble(0.5F), 0.5);
        QCOMPARE(toDouble(0.25), 0.25);
        QVERIFY(std::isnan(toDouble(std::string("12"))));
    }

    void pathsAreNormalised_data()
    {
        QTest::addColumn<std::string>("path");
        QTest::addColumn<std::string>("expected");
        const auto row = [](const char* path, const char* expected) {
            QTest::newRow(path) << std::string(path) << std::string(expected);
        };
        row("Axes[0].Signals.PathPlanner.Position", "Axes[0]/Signals/PathPlanner/Position");
        row("Axes[0]/Signals/PathPlanner/Position", "Axes[0]/Signals/PathPlanner/Position");
        row("/General/Signals/", "General/Signals");
        row("Axes[0].Signals/Output", "Axes[0]/Signals/Output");
        row("", "");
        row("/", "");
    }
    void pathsAreNormalised()
    {
        QFETCH(std::string, path);
        QFETCH(std::string, expected);
        QCOMPARE(normalisedPath(path), expected);
    }
};

AXISCOMP_TEST(TestRegisterValue)

} // namespace tst_registervalue

#include "tst_registervalue.moc"
