// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/backup_json.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

namespace axiscomp {

namespace {

constexpr std::string_view enumType = "Enum";
constexpr std::array<std::string_view, 6> valueTypeNames{
    "Boolean", "Int32", "UInt32", "Single", "Double", enumType}; // as in RegisterValue

OrderedJson numberToJson(double value)
{
    if (std::isnan(value))
        return "NaN";
    if (std::isinf(value))
        return value > 0 ? "Infinity" : "-Infinity";
    return value;
}

OrderedJson valueToJson(const RegisterValue& value)
{
    return std::visit(
        [](const auto& held) -> OrderedJson {
            if constexpr (std::is_floating_point_v<std::decay_t<decltype(held)>>)
                return numberToJson(held);
            else
                return held;
        },
        value);
}

double numberFromJson(const JsonNode& node)
{
    if (!node.isText())
        return node.number();
    const std::string_view text = node.textView();
    if (text == "Infinity")
        return std::numeric_limits<double>::infinity();
    if (text == "-Infinity")
        return -std::numeric_limits<double>::infinity();
    if (text != "NaN")
        node.refuse(
            AXISCOMP_TEXT("Error", "a number is expected, or NaN, Infinity, -Infinity as a text"));
    return std::numeric_limits<double>::quiet_NaN();
}

float singleFromJson(const JsonNode& node)
{
    const double value = numberFromJson(node);
    const auto single = static_cast<float>(value);
    if (std::isinf(single) && !std::isinf(value))
        node.refuse(AXISCOMP_TEXT("Error", "this is too large for a Single"));
    return single;
}

RegisterValue valueFromJson(const JsonNode& node, std::string_view type)
{
    if (type == "Boolean")
        return node.boolean();
    if (type == "Int32")
        return node.integer<std::int32_t>();
    if (type == "UInt32")
        return node.integer<std::uint32_t>();
    if (type == "Single")
        return singleFromJson(node);
    if (type == "Double")
        return numberFromJson(node);
    return node.text();
}

} // namespace

OrderedJson toJson(std::span<const RegisterWrite> registers)
{
    OrderedJson list = OrderedJson::array();
    for (const RegisterWrite& write : registers)
        list.push_back({{"path", write.path}, {"type", valueTypeNames.at(write.value.index())},
            {"value", valueToJson(write.value)}});
    return list;
}

std::vector<RegisterWrite> registersFromJson(const JsonNode& node)
{
    std::vector<RegisterWrite> registers;
    std::set<std::string> paths;
    for (const JsonNode& item : node.items()) {
        item.expectMembers({"path", "type", "value"});
        const JsonNode type = item["type"];
        if (std::ranges::find(valueTypeNames, type.textView()) == valueTypeNames.end())
            type.refuse(AXISCOMP_TEXT(
                "Error", "one of Boolean, Int32, UInt32, Single, Double, Enum is expected"));
        RegisterWrite write{item["path"].text(), valueFromJson(item["value"], type.textView())};
        if (write.path.empty() || !paths.insert(write.path).second)
            item["path"].refuse(write.path.empty() ? AXISCOMP_TEXT("Error", "this is empty")
                                                   : AXISCOMP_TEXT("Error", "this is there twice"));
        registers.push_back(std::move(write));
    }
    return registers;
}

WallTime timeFromJson(const JsonNode& node)
{
    const auto time = utcFromText(node.textView());
    if (!time)
        node.refuse(AXISCOMP_TEXT("Error", "a time such as 2026-11-21T08:02:23Z is expected"));
    return time.value_or(WallTime{});
}

std::uint32_t crcFromJson(const JsonNode& node)
{
    const std::string_view text = node.textView();
    std::uint32_t crc = 0;
    std::from_chars(text.data(), text.data() + text.size(), crc, 16);
    if (crcText(crc) != text)
        node.refuse(AXISCOMP_TEXT(
            "Error", "a CRC-32 of eight hexadecimal digits such as 1c291ca3 is expected"));
    return crc;
}

OrderedJson spansToJson(const Grid& grid)
{
    OrderedJson list = OrderedJson::array();
    for (const GridAxis& axis : grid.axes)
        list.push_back({{"start", axis.start}, {"distance", axis.distance}, {"size", axis.size}});
    return list;
}

Grid spansFromJson(const JsonNode& node)
{
    Grid grid;
    for (const JsonNode& item : node.items()) {
        GridAxis& axis = grid.axes.emplace_back();
        axis.start = item["start"].number();
        axis.distance = item["distance"].number();
        axis.size = item["size"].integer<std::uint32_t>(1);
    }
    return grid;
}

OrderedJson toJson(const TableUnits& units)
{
    return {{"values", units.values}, {"positions", units.positions}};
}

TableUnits unitsFromJson(const JsonNode& node)
{
    TableUnits units{node["values"].text(), {}};
    for (const JsonNode& unit : node["positions"].items())
        units.positions.push_back(unit.text());
    return units;
}

} // namespace axiscomp
