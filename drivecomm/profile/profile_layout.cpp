// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/profile/profile_layout.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace axiscomp::drivecomm {

namespace {

constexpr std::array fieldTypes{FieldType::U8, FieldType::U16, FieldType::U32, FieldType::I32,
    FieldType::F32, FieldType::F64, FieldType::Char};

/// "u32", or "u32[3]" with the count in brackets; false when it is neither.
bool readType(std::string_view text, FieldPlace& place)
{
    const std::size_t open = text.find('[');
    const auto type = std::ranges::find(fieldTypes, text.substr(0, open), fieldTypeName);
    if (type == fieldTypes.end())
        return false;
    place.type = *type;
    if (open == text.npos)
        return true;
    const char* const end = text.data() + text.size();
    const auto number = std::from_chars(text.data() + open + 1, end, place.count);
    return number.ec == std::errc{} && std::string_view(number.ptr, end) == "]";
}

FieldPlace readPlace(const JsonNode& node)
{
    constexpr std::array<std::string_view, 2> keys{"offset", "type"};
    constexpr std::array<std::string_view, 1> optionalKeys{"count"};
    node.expectMembers(keys, optionalKeys);

    FieldPlace place;
    place.offset = node["offset"].integer<std::uint32_t>();
    const JsonNode type = node["type"];
    const std::string_view typeText = type.textView();
    if (!readType(typeText, place))
        type.refuse(AXISCOMP_TEXT("Error",
            "one of u8, u16, u32, i32, f32, f64 or char is expected, with a count in brackets "
            "where there are several: char[32]"));
    const bool hasBrackets = typeText.find('[') != typeText.npos;
    if (node.has("count")) {
        place.count = node["count"].integer<std::uint32_t>(1);
        if (hasBrackets)
            node["count"].refuse(
                AXISCOMP_TEXT("Error", "the count is given twice, here and in the type"));
    } else if (place.type == FieldType::Char && !hasBrackets) {
        type.refuse(AXISCOMP_TEXT("Error", "the number of characters is missing: char[32]"));
    }
    return place;
}

void readFields(const JsonNode& node, TableLayout& layout)
{
    std::array<std::string_view, tableFieldCount> names;
    for (std::size_t i = 0; i < names.size(); ++i)
        names[i] = tableFieldName(static_cast<TableField>(i));
    node.expectMembers({}, names);
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (node.has(names[i]))
            layout.fields[i] = readPlace(node[names[i]]);
    }
}

/// The node of a constant that belongs to a field: there exactly when the field is.
std::optional<JsonNode> constantOf(
    TableField field, std::string_view key, const JsonNode& node, const TableLayout& layout)
{
    const bool hasField = layout.place(field).has_value();
    if (node.has(key) && !hasField)
        node[key].refuse(AXISCOMP_TEXT("Error", "there is no field {name} to hold it")
                             .with("name", tableFieldName(field)));
    if (!hasField)
        return std::nullopt;
    return node[key];
}

} // namespace

TableLayout readTableLayout(const JsonNode& node)
{
    constexpr std::array<std::string_view, 4> keys{
        "byteOrder", "headerSize", "fastestDimension", "fields"};
    constexpr std::array<std::string_view, 3> optionalKeys{
        "magic", "version", "elementTypeFloat32"};
    node.expectMembers(keys, optionalKeys);

    TableLayout layout;
    const std::string byteOrder = node["byteOrder"].text();
    if (byteOrder != "little" && byteOrder != "big")
        node["byteOrder"].refuse(AXISCOMP_TEXT("Error", "\"little\" or \"big\" is expected"));
    layout.littleEndian = byteOrder != "big";
    const std::string fastest = node["fastestDimension"].text();
    if (fastest != "first" && fastest != "last")
        node["fastestDimension"].refuse(
            AXISCOMP_TEXT("Error", "\"first\" or \"last\" is expected"));
    layout.dimension1Fastest = fastest != "last";
    layout.headerSize = node["headerSize"].integer<std::uint32_t>();

    readFields(node["fields"], layout);
    if (const auto magic = constantOf(TableField::Magic, "magic", node, layout))
        layout.magic = magic->text();
    if (const auto version = constantOf(TableField::Version, "version", node, layout))
        layout.version = version->integer<std::uint32_t>();
    if (const auto type = constantOf(TableField::ElementType, "elementTypeFloat32", node, layout))
        layout.elementTypeFloat32 = type->integer<std::uint32_t>();
    return layout;
}

} // namespace axiscomp::drivecomm
