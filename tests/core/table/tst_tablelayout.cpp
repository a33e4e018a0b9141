// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/table_layout.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <functional>
#include <set>

namespace tst_tablelayout {

using namespace axiscomp;

namespace {

using Change = std::function<void(TableLayout&)>;

Change place(TableField field, std::uint32_t offset, FieldType type, std::uint32_t count = 1)
{
    return [=](TableLayout& layout) { layout.place(field) = FieldPlace{offset, type, count}; };
}

Change without(TableField field)
{
    return [=](TableLayout& layout) { layout.place(field).reset(); };
}

} // namespace

class TestTableLayout : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    /// The generic layout of docs/profiles.md, byte by byte.
    void theGenericLayoutIsTheDocumentedOne_data()
    {
        QTest::addColumn<TableField>("field");
        QTest::addColumn<std::uint32_t>("offset");
        QTest::addColumn<FieldType>("type");
        QTest::addColumn<std::uint32_t>("count");
        const auto row = [](const char* name, TableField field, std::uint32_t offset,
                             FieldType type, std::uint32_t count = 1) {
            QTest::newRow(name) << field << offset << type << count;
        };
        row("magic", TableField::Magic, 0, FieldType::Char, 4);
        row("version", TableField::Version, 4, FieldType::U16);
        row("headerSize", TableField::HeaderSize, 6, FieldType::U16);
        row("elementType", TableField::ElementType, 8, FieldType::U32);
        row("persistent", TableField::Persistent, 12, FieldType::U32);
        row("dimensions", TableField::Dimensions, 16, FieldType::U32);
        row("size", TableField::Size, 20, FieldType::U32, 3);
        row("start", TableField::Start, 32, FieldType::F64, 3);
        row("distance", TableField::Distance, 56, FieldType::F64, 3);
        row("elementCount", TableField::ElementCount, 80, FieldType::U32);
        row("elementCrc", TableField::ElementCrc, 84, FieldType::U32);
        row("name", TableField::Name, 88, FieldType::Char, 32);
        row("headerCrc", TableField::HeaderCrc, 124, FieldType::U32);
    }
    void theGenericLayoutIsTheDocumentedOne()
    {
        QFETCH(TableField, field);
        QFETCH(std::uint32_t, offset);
        QFETCH(FieldType, type);
        QFETCH(std::uint32_t, count);
        const TableLayout layout = genericTableLayout();
        QCOMPARE(tableFieldName(field), std::string_view(QTest::currentDataTag()));
        QVERIFY(layout.place(field).has_value());
        QCOMPARE(layout.place(field)->offset, offset);
        QVERIFY(layout.place(field)->type == type);
        QCOMPARE(layout.place(field)->count, count);
        QVERIFY(layout.littleEndian);
        QVERIFY(layout.dimension1Fastest);
        QCOMPARE(layout.headerSize, 128U);
        QCOMPARE(layout.magic, "TAMT");
        QCOMPARE(layout.version, 1U);
        QCOMPARE(layout.elementTypeFloat32, 1U);
    }

    void fieldsHaveNamesOfTheirOwn()
    {
        std::set<std::string_view> names;
        for (int i = 0; i < tableFieldCount; ++i)
            names.insert(tableFieldName(static_cast<TableField>(i)));
        QCOMPARE(names.size(), static_cast<std::size_t>(tableFieldCount));
    }

    void aFieldTakesCountTimesTheSizeOfItsType_data()
    {
        QTest::addColumn<FieldType>("type");
        QTest::addColumn<std::uint32_t>("size");
        QTest::newRow("u8") << FieldType::U8 << 1U;
        QTest::newRow("u16") << FieldType::U16 << 2U;
        QTest::newRow("u32") << FieldType::U32 << 4U;
        QTest::newRow("i32") << FieldType::I32 << 4U;
        QTest::newRow("f32") << FieldType::F32 << 4U;
        QTest::newRow("f64") << FieldType::F64 << 8U;
        QTest::newRow("char") << FieldType::Char << 1U;
    }
    void aFieldTakesCountTimesTheSizeOfItsType()
    {
        QFETCH(FieldType, type);
        QFETCH(std::uint32_t, size);
        QCOMPARE(fieldTypeName(type), std::string_view(QTest::currentDataTag()));
        QCOMPARE((FieldPlace{0, type, 1}.byteCount()), size);
        QCOMPARE((FieldPlace{0, type, 3}.byteCount()), 3 * size);
        QCOMPARE((FieldPlace{0, type, 4294967295U}.byteCount()), 4294967295U);
    }

    void aUsableLayoutIsAccepted_data()
    {
        QTest::addColumn<Change>("change");
        QTest::newRow("generic") << Change([](TableLayout&) {});
        for (int i = 0; i < tableFieldCount; ++i) {
            const auto field = static_cast<TableField>(i);
            if (field != TableField::Size && field != TableField::Start
                && field != TableField::Distance)
                QTest::addRow("without %s", tableFieldName(field).data()) << without(field);
        }
        QTest::newRow("start and distance as f32") << Change([](TableLayout& layout) {
            layout.place(TableField::Start)->type = FieldType::F32;
            layout.place(TableField::Distance)->type = FieldType::F32;
        });
        QTest::newRow("persistent behind the header CRC") << Change([](TableLayout& layout) {
            layout.headerSize = 129;
            layout.place(TableField::Persistent) = FieldPlace{128, FieldType::U8, 1};
        });
        QTest::newRow("fields in another order, without a gap") << Change([](TableLayout& layout) {
            layout = {};
            layout.headerSize = 60;
            layout.place(TableField::Distance) = FieldPlace{0, FieldType::F64, 3};
            layout.place(TableField::Size) = FieldPlace{24, FieldType::I32, 3};
            layout.place(TableField::Start) = FieldPlace{36, FieldType::F64, 3};
        });
        QTest::newRow("largest header") << Change([](TableLayout& layout) {
            layout.headerSize = 65536;
            layout.place(TableField::HeaderSize).reset();
        });
    }
    void aUsableLayoutIsAccepted()
    {
        QFETCH(Change, change);
        TableLayout layout = genericTableLayout();
        change(layout);
        VERIFY_RESULT(checkLayout(layout));
    }

    void aWrongLayoutIsRefusedWithTheField_data()
    {
        QTest::addColumn<Change>("change");
        QTest::addColumn<std::string>("path");
        QTest::addColumn<std::string>("reason"); // a part of it
        const auto row = [](const char* name, const char* path, const char* reason, Change change) {
            QTest::newRow(name) << change << std::string(path) << std::string(reason);
        };
        using F = TableField;
        using T = FieldType;
        const auto header = [](std::uint32_t size) {
            return [=](TableLayout& layout) { layout.headerSize = size; };
        };
        row("no header", "headerSize", "it is 0", header(0));
        row("huge header", "headerSize", "it is 4294967295", header(4294967295U));
        row("no size", "fields.size", "missing", without(F::Size));
        row("no start", "fields.start", "missing", without(F::Start));
        row("no distance", "fields.distance", "missing", without(F::Distance));
        row("outside", "fields.headerCrc", "ends at byte 128, but the header has only 127",
            header(127));
        row("far outside", "fields.version", "ends at byte 4294967297",
            place(F::Version, 4294967295U, T::U16));
        row("count overflows", "fields.name", "ends at byte 4294967383",
            place(F::Name, 88, T::Char, 4294967295U));
        row("overlap by one byte", "fields.version", "inside magic, which ends at byte 4",
            place(F::Version, 3, T::U8));
        row("same place", "fields.elementCrc", "inside elementCount",
            place(F::ElementCrc, 80, T::U32));
        row("size as float", "fields.size", "f64; expected u8, u16, u32 or i32",
            place(F::Size, 20, T::F64, 3));
        row("start as integer", "fields.start", "u32; expected f32 or f64",
            place(F::Start, 32, T::U32, 3));
        row("distance as text", "fields.distance", "char; expected f32 or f64",
            place(F::Distance, 56, T::Char, 3));
        row("magic as number", "fields.magic", "u32; expected char", place(F::Magic, 0, T::U32));
        row("name as number", "fields.name", "u8; expected char", place(F::Name, 88, T::U8, 32));
        row("CRC too short", "fields.headerCrc", "u16; expected u32",
            place(F::HeaderCrc, 124, T::U16));
        row("persistent as text", "fields.persistent", "char; expected u8",
            place(F::Persistent, 12, T::Char));
        row("two sizes", "fields.size", "its count is 2, expected 3",
            place(F::Size, 20, T::U32, 2));
        row("no start values", "fields.start", "its count is 0", place(F::Start, 32, T::F64, 0));
        row("several versions", "fields.version", "its count is 2, expected 1",
            place(F::Version, 4, T::U8, 2));
        row("empty name", "fields.name", "at least 1", place(F::Name, 88, T::Char, 0));
        row("magic of another length", "fields.magic", "length of the magic text, 4",
            place(F::Magic, 0, T::Char, 3));
        row("no magic text", "fields.magic", "length of the magic text, 0",
            [](TableLayout& layout) {
                layout.magic.clear();
                layout.place(F::Magic)->count = 0;
            });
        row("version does not fit", "fields.version", "u16 cannot hold 65536",
            [](TableLayout& layout) { layout.version = 65536; });
        row("header size does not fit", "fields.headerSize", "u8 cannot hold 256",
            [](TableLayout& layout) {
                layout.headerSize = 256;
                layout.place(F::HeaderSize)->type = T::U8;
            });
        row("element type does not fit", "fields.elementType", "i32 cannot hold 2147483648",
            [](TableLayout& layout) {
                layout.elementTypeFloat32 = 2147483648U;
                layout.place(F::ElementType)->type = T::I32;
            });
        row("a CRC of nothing", "fields.headerCrc", "covers the header bytes before it",
            [](TableLayout& layout) {
                layout.place(F::Magic).reset();
                layout.place(F::HeaderCrc) = FieldPlace{0, T::U32, 1};
            });
    }
    void aWrongLayoutIsRefusedWithTheField()
    {
        QFETCH(Change, change);
        QFETCH(std::string, path);
        QFETCH(std::string, reason);
        TableLayout layout = genericTableLayout();
        change(layout);
        const auto checked = checkLayout(layout);
        VERIFY_ERROR(checked, ErrorCode::InvalidProfile);
        QCOMPARE(checked.error().context.english("path"), path);
        const std::string found = checked.error().context.english("reason");
        QVERIFY2(found.find(reason) != std::string::npos, found.c_str());
    }
};

AXISCOMP_TEST(TestTableLayout)

} // namespace tst_tablelayout

#include "tst_tablelayout.moc"
