// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/field_codec.h"
#include "core/table/tam_table.h"
#include "tests/core/table/table_samples.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <cmath>
#include <limits>

namespace tst_tamtablefaults {

using namespace axiscomp;
using namespace axiscomp::test;

namespace {

/// A fault of the header is found although both CRCs fit.
void repairCrcs(Bytes& file)
{
    const std::span<std::byte> bytes(file);
    storeAt(bytes.subspan(84), crc32(bytes.subspan(128)), true);
    Bytes header(file.begin(), file.begin() + 124);
    std::fill_n(header.begin() + 12, 4, std::byte{0});
    storeAt(bytes.subspan(124), crc32(header), true);
}

} // namespace

class TestTamTableFaults : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { axiscomp::test::failOnWarnings(); }

    void anyFlippedBitIsFound()
    {
        const Bytes file = encoded(tamSample(2));
        for (std::size_t bit = 0; bit < 8 * file.size(); ++bit) {
            Bytes wrong = file;
            wrong[bit / 8] ^= std::byte{1} << (bit % 8);
            // the one change that the drive itself makes
            if (bit != 8 * 12)
                VERIFY_ERROR(decodeTamTable(wrong, genericTableLayout()), ErrorCode::InvalidTable);
        }
    }

    void anyOtherLengthIsFound()
    {
        Bytes file = encoded(tamSample(2));
        for (std::size_t length = 0; length < file.size(); ++length) {
            const auto decoded = decodeTamTable(ByteView(file).first(length), genericTableLayout());
            VERIFY_ERROR(decoded, ErrorCode::InvalidTable);
            QCOMPARE(decoded.error().context.english("field"), std::string("file length"));
            QCOMPARE(decoded.error().context.english("offset"), std::to_string(length));
        }
        for (int more = 1; more <= 8; ++more) {
            file.push_back(std::byte{0});
            VERIFY_ERROR(decodeTamTable(file, genericTableLayout()), ErrorCode::InvalidTable);
        }
    }

    void aWrongFieldIsNamed_data();
    void aWrongFieldIsNamed();

    void sizesWithAHugeProductAreRefusedWithoutAllocating()
    {
        // no element count to contradict the sizes, whose product is above 2^64
        const TableLayout layout = smallLayout();
        TableLayout wide = layout;
        wide.headerSize = 36;
        wide.place(TableField::Size) = FieldPlace{24, FieldType::U32, 3};
        wide.place(TableField::Start) = FieldPlace{0, FieldType::F32, 3};
        wide.place(TableField::Distance) = FieldPlace{12, FieldType::F32, 3};
        for (const std::uint32_t size : {0xFFFFFFFFU, 0x80000000U, 0x400000U, 0x200000U}) {
            Bytes file(36 + 16);
            for (std::size_t i = 0; i < 3; ++i) {
                storeAt(std::span(file).subspan(12 + 4 * i), 1.0F, true);
                storeAt(std::span(file).subspan(24 + 4 * i), size, true);
            }
            const auto decoded = decodeTamTable(file, wide);
            VERIFY_ERROR(decoded, ErrorCode::InvalidTable);
            QCOMPARE(decoded.error().context.english("field"), std::string("file length"));
        }
    }

    void aTableThatIsNoneIsNotWritten_data();
    void aTableThatIsNoneIsNotWritten();

    void aValueThatTheLayoutCannotHoldIsNotWritten_data();
    void aValueThatTheLayoutCannotHoldIsNotWritten();

    void aWrongLayoutIsRefusedBeforeItIsUsed()
    {
        TableLayout layout = genericTableLayout();
        layout.place(TableField::Size)->offset = 4000;
        VERIFY_ERROR(encodeTamTable(tamSample(1), false, layout), ErrorCode::InvalidProfile);
        VERIFY_ERROR(decodeTamTable(encoded(tamSample(1)), layout), ErrorCode::InvalidProfile);
    }
};

void TestTamTableFaults::aWrongFieldIsNamed_data()
{
    QTest::addColumn<std::size_t>("offset");
    QTest::addColumn<std::uint64_t>("value");
    QTest::addColumn<int>("bytes");
    QTest::addColumn<std::string>("field");
    QTest::addColumn<std::string>("found");
    QTest::addColumn<std::string>("expected"); // its beginning
    const auto row = [](const char* name, std::size_t offset, auto value, const char* field,
                         const char* found, const char* expected) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &value, sizeof(value));
        QTest::newRow(name) << offset << bits << static_cast<int>(sizeof(value))
                            << std::string(field) << std::string(found) << std::string(expected);
    };
    constexpr double infinity = std::numeric_limits<double>::infinity();
    row("magic", 0, std::uint32_t{0x21544D54}, "magic", "\"TMT!\"", "\"TAMT\"");
    row("version", 4, std::uint16_t{2}, "version", "2", "1");
    row("header size", 6, std::uint16_t{127}, "headerSize", "127", "128");
    row("element type", 8, std::uint32_t{2}, "elementType", "2", "1");
    row("persistent", 12, std::uint32_t{2}, "persistent", "2", "0 or 1");
    row("no dimensions", 16, std::uint32_t{0}, "dimensions", "0", "1, 2 or 3");
    row("four dimensions", 16, std::uint32_t{4}, "dimensions", "4", "1, 2 or 3");
    row("size of 1", 20, std::uint32_t{1}, "size[0]", "1", "2 or more");
    row("size of 0", 24, std::uint32_t{0}, "size[1]", "0", "2 or more");
    row("size of an unused dimension", 28, std::uint32_t{2}, "size[2]", "2", "1, because");
    row("no start", 32, infinity, "start[0]", "inf", "a finite number");
    row("start of dimension 2", 40, -infinity, "start[1]", "-inf", "a finite number");
    row("zero distance", 56, 0.0, "distance[0]", "0", "a finite number above 0");
    row("negative distance", 64, -1.0, "distance[1]", "-1", "a finite number above 0");
    row("endless distance", 64, infinity, "distance[1]", "inf", "a finite number above 0");
    row("last position is none", 56, 1e308, "distance[0]", "1e+308", "one that leads to a finite");
    row("points in one place", 64, 1e-15, "distance[1]", "1e-15", "one that tells positions such");
    row("points hardly apart", 64, 1e-13, "distance[1]", "1e-13", "one that tells positions such");
    row("denormal distance", 56, 5e-324, "distance[0]", "5e-324", "one that tells positions such");
    row("element count", 80, std::uint32_t{11}, "elementCount", "11", "12, the product");
    row("element count of 2^32 - 1", 80, std::uint32_t{0xFFFFFFFF}, "elementCount", "4294967295",
        "12, the product");
    row("infinite element", 128, std::numeric_limits<float>::infinity(), "element 0", "inf",
        "a finite number");
    row("last element", 128 + 44, -std::numeric_limits<float>::infinity(), "element 11", "-inf",
        "a finite number");
}

void TestTamTableFaults::aWrongFieldIsNamed()
{
    QFETCH(std::size_t, offset);
    QFETCH(std::uint64_t, value);
    QFETCH(int, bytes);
    QFETCH(std::string, field);
    QFETCH(std::string, found);
    QFETCH(std::string, expected);
    CompensationTable table = tamSample(2);
    table.grid.axes[0].size = 3;
    table.grid.axes[0].start = 1.2e308; // "last position is none" needs little more
    table.grid.axes[0].distance = 1e300;
    Bytes file = encoded(table);
    QVERIFY(!file.empty());
    std::memcpy(file.data() + offset, &value, static_cast<std::size_t>(bytes));
    repairCrcs(file);
    const auto decoded = decodeTamTable(file, genericTableLayout());
    VERIFY_ERROR(decoded, ErrorCode::InvalidTable);
    const ErrorContext& context = decoded.error().context;
    QCOMPARE(context.english("field"), field);
    QCOMPARE(context.english("offset"), std::to_string(offset));
    QCOMPARE(context.english("found"), found);
    const std::string wanted = context.english("expected");
    QVERIFY2(wanted.starts_with(expected), wanted.c_str());
}

void TestTamTableFaults::aTableThatIsNoneIsNotWritten_data()
{
    QTest::addColumn<CompensationTable>("table");
    QTest::addColumn<std::string>("reason");
    const auto row = [](const char* name, const char* reason, auto change) {
        CompensationTable table = tamSample(2);
        change(table);
        QTest::newRow(name) << table << std::string(reason);
    };
    using Table = CompensationTable;
    row("no dimension", "0 dimensions", [](Table& t) { t.grid.axes.clear(); });
    row("four dimensions", "4 dimensions", [](Table& t) { t.grid.axes.resize(4); });
    row("size of 1", "size of dimension 2 is 1", [](Table& t) { t.grid.axes[1].size = 1; });
    row("size of 0", "size of dimension 1 is 0", [](Table& t) { t.grid.axes[0].size = 0; });
    row("too few values", "has 11 values", [](Table& t) { t.values.pop_back(); });
    row("too many values", "has 13 values", [](Table& t) { t.values.push_back(0.0F); });
    row("no values", "has 0 values", [](Table& t) { t.values.clear(); });
    row("product overflows to the count", "has 12 values", [](Table& t) {
        t.grid.axes = {{{}, {}, 0.0, 1.0, 0x80000000U}, {{}, {}, 0.0, 1.0, 0x80000000U},
            {{}, {}, 0.0, 1.0, 4}};
    });
    row("infinite value", "value 5 is inf",
        [](Table& t) { t.values[4] = std::numeric_limits<float>::infinity(); });
    row("no number", "value 12 is nan", [](Table& t) { t.values.back() = std::nanf(""); });
    row("start", "start value of dimension 1 is nan",
        [](Table& t) { t.grid.axes[0].start = std::nan(""); });
    row("distance 0", "distance of dimension 2 is 0",
        [](Table& t) { t.grid.axes[1].distance = 0.0; });
    row("distance below 0", "distance of dimension 1 is -1",
        [](Table& t) { t.grid.axes[0].distance = -1.0; });
    row("distance no number", "distance of dimension 1 is nan",
        [](Table& t) { t.grid.axes[0].distance = std::nan(""); });
    row("points in one place", "too little to tell positions such as 100 apart",
        [](Table& t) { t.grid.axes[1].distance = 1e-15; });
    row("last position", "last position of dimension 1",
        [](Table& t) { t.grid.axes[0].distance = 1.7e308; });
}

void TestTamTableFaults::aTableThatIsNoneIsNotWritten()
{
    QFETCH(CompensationTable, table);
    QFETCH(std::string, reason);
    const auto file = encodeTamTable(table, false, genericTableLayout());
    VERIFY_ERROR(file, ErrorCode::InvalidArgument);
    const std::string words = sentence(file.error());
    QVERIFY2(words.find(reason) != std::string::npos, words.c_str());
}

void TestTamTableFaults::aValueThatTheLayoutCannotHoldIsNotWritten_data()
{
    QTest::addColumn<GridAxis>("axis");
    QTest::addColumn<std::string>("reason");
    QTest::newRow("size") << GridAxis{{}, {}, 0.0, 1.0, 65536} << std::string("field size");
    QTest::newRow("start too large")
        << GridAxis{{}, {}, 1e39, 1e38, 2} << std::string("grid of dimension 1");
    QTest::newRow("distance too small")
        << GridAxis{{}, {}, 0.0, 1e-60, 2} << std::string("grid of dimension 1");
    QTest::newRow("start too exact")
        << GridAxis{{}, {}, 123456.789, 0.001, 2} << std::string("start 123456.789");
    QTest::newRow("distance too exact for the stroke")
        << GridAxis{{}, {}, 0.0, 0.1, 60000} << std::string();
}

void TestTamTableFaults::aValueThatTheLayoutCannotHoldIsNotWritten()
{
    QFETCH(GridAxis, axis);
    QFETCH(std::string, reason);
    CompensationTable table;
    table.grid.axes = {axis};
    table.values.assign(axis.size, 1.0F);
    const auto file = encodeTamTable(table, false, smallLayout());
    if (reason.empty()) { // float32 still holds this grid to a thousandth of the distance
        VERIFY_RESULT(file);
        return;
    }
    VERIFY_ERROR(file, ErrorCode::InvalidArgument);
    const std::string words = sentence(file.error());
    QVERIFY2(words.find(reason) != std::string::npos, words.c_str());
}

AXISCOMP_TEST(TestTamTableFaults)

} // namespace tst_tamtablefaults

#include "tst_tamtablefaults.moc"
