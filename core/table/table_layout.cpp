// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/table_layout.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace axiscomp {

namespace {

constexpr std::uint32_t largestHeader = 65536;
constexpr std::uint32_t gridDimensions = 3;

constexpr std::array<std::string_view, tableFieldCount> fieldNames{"magic", "version", "headerSize",
    "elementType", "persistent", "dimensions", "size", "start", "distance", "elementCount",
    "elementCrc", "name", "headerCrc"};

constexpr std::array<std::string_view, 7> fieldTypeNames{
    "u8", "u16", "u32", "i32", "f32", "f64", "char"};
constexpr std::array<std::uint32_t, 7> typeSizes{1, 2, 4, 4, 4, 8, 1};

enum class Holds { Integer, Number, Checksum, Text };

Holds contentOf(TableField field)
{
    switch (field) {
    case TableField::Magic:
    case TableField::Name:
        return Holds::Text;
    case TableField::Start:
    case TableField::Distance:
        return Holds::Number;
    case TableField::ElementCrc:
    case TableField::HeaderCrc:
        return Holds::Checksum;
    case TableField::Version:
    case TableField::HeaderSize:
    case TableField::ElementType:
    case TableField::Persistent:
    case TableField::Dimensions:
    case TableField::Size:
    case TableField::ElementCount:
        break;
    }
    return Holds::Integer;
}

bool isPerDimension(TableField field)
{
    return field == TableField::Size || field == TableField::Start || field == TableField::Distance;
}

std::uint32_t largestValue(FieldType type)
{
    switch (type) {
    case FieldType::U8:
        return std::numeric_limits<std::uint8_t>::max();
    case FieldType::U16:
        return std::numeric_limits<std::uint16_t>::max();
    case FieldType::I32:
        return static_cast<std::uint32_t>(std::numeric_limits<std::int32_t>::max());
    default:
        return std::numeric_limits<std::uint32_t>::max();
    }
}

tl::unexpected<Error> wrongLayout(std::string path, Text reason)
{
    return fail(ErrorCode::InvalidProfile,
        {{"file", AXISCOMP_TEXT("Error", "(table layout)")}, {"path", std::move(path)},
            {"reason", std::move(reason)}});
}

tl::unexpected<Error> wrongField(TableField field, Text reason)
{
    return wrongLayout("fields." + std::string(tableFieldName(field)), std::move(reason));
}

/// The fault of a field's type, empty when there is none.
Text typeFault(TableField field, FieldType type)
{
    const auto expected = [&](Argument types) {
        return AXISCOMP_TEXT("Error", "it cannot be of type {type}; expected {expected}")
            .with("type", fieldTypeName(type))
            .with("expected", std::move(types));
    };
    const bool isFloat = type == FieldType::F32 || type == FieldType::F64;
    switch (contentOf(field)) {
    case Holds::Text:
        return type == FieldType::Char ? Text() : expected(fieldTypeName(FieldType::Char));
    case Holds::Number:
        return isFloat ? Text() : expected(AXISCOMP_TEXT("Error", "f32 or f64"));
    case Holds::Checksum:
        return type == FieldType::U32 ? Text() : expected(fieldTypeName(FieldType::U32));
    case Holds::Integer:
        break;
    }
    return isFloat || type == FieldType::Char
        ? expected(AXISCOMP_TEXT("Error", "u8, u16, u32 or i32"))
        : Text();
}

Text countFault(TableField field, const FieldPlace& place, const TableLayout& layout)
{
    if (field == TableField::Magic)
        return place.count == layout.magic.size() && place.count > 0
            ? Text()
            : AXISCOMP_TEXT("Error",
                "its count is {found}, expected the length of the magic text, {expected}, which is "
                "at least 1")
                  .with("found", place.count)
                  .with("expected", layout.magic.size());
    if (field == TableField::Name)
        return place.count > 0 ? Text()
                               : AXISCOMP_TEXT("Error", "its count is 0, expected at least 1");
    const std::uint32_t expected = isPerDimension(field) ? gridDimensions : 1;
    return place.count == expected
        ? Text()
        : AXISCOMP_TEXT("Error", "its count is {found}, expected {expected}")
              .with("found", place.count)
              .with("expected", expected);
}

/// The fault of a constant that the layout wants in a field.
Text constantFault(TableField field, FieldType type, const TableLayout& layout)
{
    std::uint32_t value = 0;
    if (field == TableField::Version)
        value = layout.version;
    else if (field == TableField::HeaderSize)
        value = layout.headerSize;
    else if (field == TableField::ElementType)
        value = layout.elementTypeFloat32;
    if (value <= largestValue(type))
        return {};
    return AXISCOMP_TEXT("Error", "its type {type} cannot hold {value}")
        .with("type", fieldTypeName(type))
        .with("value", value);
}

Text placeFault(TableField field, const FieldPlace& place, const TableLayout& layout)
{
    const std::uint64_t end = std::uint64_t{place.offset} + place.byteCount();
    if (end > layout.headerSize)
        return AXISCOMP_TEXT("Error", "it ends at byte {end}, but the header has only {size} bytes")
            .with("end", end)
            .with("size", layout.headerSize);
    if (field == TableField::HeaderCrc && place.offset == 0)
        return AXISCOMP_TEXT("Error", "it covers the header bytes before it, and there are none");
    return {};
}

Result<void> checkField(TableField field, const FieldPlace& place, const TableLayout& layout)
{
    for (const Text& fault : {typeFault(field, place.type), countFault(field, place, layout),
             placeFault(field, place, layout), constantFault(field, place.type, layout)}) {
        if (!fault.isEmpty())
            return wrongField(field, fault);
    }
    return {};
}

Result<void> checkOverlaps(const TableLayout& layout)
{
    struct Extent {
        std::uint32_t begin;
        std::uint32_t end;
        TableField field;
    };
    std::vector<Extent> extents;
    for (std::size_t i = 0; i < layout.fields.size(); ++i) {
        if (const auto& place = layout.fields[i])
            extents.push_back(
                {place->offset, place->offset + place->byteCount(), static_cast<TableField>(i)});
    }
    std::ranges::stable_sort(extents, {}, &Extent::begin);
    for (std::size_t i = 1; i < extents.size(); ++i) {
        const Extent& before = extents[i - 1];
        if (extents[i].begin < before.end)
            return wrongField(extents[i].field,
                AXISCOMP_TEXT(
                    "Error", "it begins at byte {begin}, inside {field}, which ends at byte {end}")
                    .with("begin", extents[i].begin)
                    .with("field", tableFieldName(before.field))
                    .with("end", before.end));
    }
    return {};
}

} // namespace

std::uint32_t FieldPlace::byteCount() const
{
    const std::uint64_t bytes = std::uint64_t{count} * typeSizes[static_cast<std::size_t>(type)];
    return static_cast<std::uint32_t>(
        std::min<std::uint64_t>(bytes, std::numeric_limits<std::uint32_t>::max()));
}

std::string_view tableFieldName(TableField field)
{
    return fieldNames[static_cast<std::size_t>(field)];
}

std::string_view fieldTypeName(FieldType type)
{
    return fieldTypeNames[static_cast<std::size_t>(type)];
}

Result<void> checkLayout(const TableLayout& layout)
{
    if (layout.headerSize == 0 || layout.headerSize > largestHeader)
        return wrongLayout("headerSize",
            AXISCOMP_TEXT("Error", "it is {size}, expected 1 to {limit} bytes")
                .with("size", layout.headerSize)
                .with("limit", largestHeader));
    for (const TableField field : {TableField::Size, TableField::Start, TableField::Distance}) {
        if (!layout.place(field))
            return wrongField(
                field, AXISCOMP_TEXT("Error", "it is missing; a table cannot be read without it"));
    }
    for (std::size_t i = 0; i < layout.fields.size(); ++i) {
        if (!layout.fields[i])
            continue;
        if (auto checked = checkField(static_cast<TableField>(i), *layout.fields[i], layout);
            !checked)
            return checked;
    }
    return checkOverlaps(layout);
}

std::string layoutText(const TableLayout& layout)
{
    std::string text = layout.littleEndian ? "little " : "big ";
    text += std::to_string(layout.headerSize) + (layout.dimension1Fastest ? " first" : " last");
    for (const TableField field :
        {TableField::Dimensions, TableField::Size, TableField::Start, TableField::Distance}) {
        if (const auto& place = layout.place(field))
            text += " " + std::string(tableFieldName(field)) + "="
                + std::string(fieldTypeName(place->type)) + "@" + std::to_string(place->offset);
    }
    return text;
}

TableLayout genericTableLayout()
{
    TableLayout layout;
    layout.headerSize = 128;
    layout.magic = "TAMT";
    layout.version = 1;
    const auto put = [&layout](TableField field, std::uint32_t offset, FieldType type,
                         std::uint32_t count = 1) {
        layout.place(field) = FieldPlace{offset, type, count};
    };
    put(TableField::Magic, 0, FieldType::Char, 4);
    put(TableField::Version, 4, FieldType::U16);
    put(TableField::HeaderSize, 6, FieldType::U16);
    put(TableField::ElementType, 8, FieldType::U32);
    put(TableField::Persistent, 12, FieldType::U32);
    put(TableField::Dimensions, 16, FieldType::U32);
    put(TableField::Size, 20, FieldType::U32, gridDimensions);
    put(TableField::Start, 32, FieldType::F64, gridDimensions);
    put(TableField::Distance, 56, FieldType::F64, gridDimensions);
    put(TableField::ElementCount, 80, FieldType::U32);
    put(TableField::ElementCrc, 84, FieldType::U32);
    put(TableField::Name, 88, FieldType::Char, 32);
    put(TableField::HeaderCrc, 124, FieldType::U32);
    return layout;
}

} // namespace axiscomp
