// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/value_writer.h"
#include "core/text/number_parser.h"
#include "core/text/number_text.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace tst_valuewriter {

using namespace axiscomp;

namespace {

std::string textOf(float value, csv::ValueWriter& writer)
{
    std::array<char, longestText + shortNumberReach> room{};
    const char* const end = writer.write(value, room.data());
    if (end[-1] != ',')
        return "no comma";
    return std::string(room.data(), static_cast<std::size_t>(end - 1 - room.data()));
}

std::string textOf(float value)
{
    csv::ValueWriter writer;
    return textOf(value, writer);
}

/// As the reader takes it: the nearest double, and then the nearest float32.
float readBack(const std::string& text)
{
    double value = 0.0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    return read.ptr == text.data() + text.size() ? static_cast<float>(value)
                                                 : std::numeric_limits<float>::quiet_NaN();
}

/// The standard library's shortest digits for a float32, as this program writes them.
std::string shortestText(float value)
{
    std::array<char, longestText> buffer{};
    const float size = std::abs(value);
    const bool isPlain = size == 0.0F || (size >= 1e-7F && size < 1e15F);
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
        isPlain ? std::chars_format::fixed : std::chars_format::scientific);
    return std::string(buffer.data(), end.ptr);
}

/// Any float32, and those of tables: decimals of every number, whole numbers, powers.
std::vector<float> values()
{
    std::mt19937 random(11); // NOLINT: the same values every time
    std::vector<float> all{0.0F, -0.0F, 1e-7F, std::nextafter(1e-7F, 0.0F), 0.1F, 16777216.0F, 1e9F,
        std::nextafter(1e9F, 0.0F), 4e9F, 4294967296.0F, 1e15F, std::nextafter(1e15F, 0.0F),
        std::numeric_limits<float>::max(), std::numeric_limits<float>::min(),
        std::numeric_limits<float>::denorm_min(), 0.99999994F, 9.9999998e-5F, 0.5F, 0.25F, 1.5e-5F};
    for (int exponent = -40; exponent <= 100; ++exponent)
        for (int n = 0; n < 200; ++n)
            all.push_back(std::ldexp(static_cast<float>(random() % 0x1000000), exponent - 24));
    for (int decimals = 0; decimals <= 13; ++decimals)
        for (int n = 0; n < 2000; ++n)
            all.push_back(static_cast<float>(
                (static_cast<double>(random() % 20'000'001) - 1e7) / std::pow(10.0, decimals)));
    for (int n = 0; n < 100'000; ++n)
        if (const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
            std::isfinite(value))
            all.push_back(value);
    return all;
}

} // namespace

class TestValueWriter : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void examplesAreWrittenAsAPersonWould_data()
    {
        QTest::addColumn<float>("value");
        QTest::addColumn<QString>("text");
        const auto row = [](float value, const char* text) {
            QTest::newRow(text) << value << text;
        };
        row(0.0F, "0");
        row(-0.0F, "-0");
        row(0.0012F, "0.0012");
        row(-0.000000125F, "-0.000000125");
        row(1e-7F, "0.0000001");
        row(9.5e-8F, "9.5e-08");
        row(25.0F, "25");
        row(-1234.5F, "-1234.5");
        row(16777216.0F, "16777216");
        row(3e9F, "3000000000");
        row(1e15F, "1e+15");
    }
    void examplesAreWrittenAsAPersonWould()
    {
        QFETCH(float, value);
        QFETCH(QString, text);
        QCOMPARE(textOf(value), text.toStdString());
    }

    void theTextIsReadBackAsTheSameValue()
    {
        csv::ValueWriter writer;
        for (const float value : values()) {
            const std::string text = textOf(value, writer);
            QVERIFY2(
                std::bit_cast<std::uint32_t>(readBack(text)) == std::bit_cast<std::uint32_t>(value),
                text.c_str());
        }
    }

    /// Where its shortest digits are read back, which goes by way of a double, the text is that of
    /// the standard library.
    void theTextIsTheShortestThatIsReadBack()
    {
        csv::ValueWriter writer;
        int others = 0;
        for (const float value : values()) {
            const std::string due = shortestText(value);
            if (readBack(due) == value)
                QCOMPARE(textOf(value, writer), due);
            else
                ++others;
        }
        QVERIFY2(others < 10, QByteArray::number(others).constData());
    }

    void theTextDoesNotDependOnTheValueBefore()
    {
        csv::ValueWriter writer;
        std::vector<float> mixed = values();
        std::shuffle(mixed.begin(), mixed.end(), std::mt19937(7)); // NOLINT: the same order
        for (const float value : mixed)
            QCOMPARE(textOf(value, writer), textOf(value));
    }
};

AXISCOMP_TEST(TestValueWriter)

} // namespace tst_valuewriter

#include "tst_valuewriter.moc"
