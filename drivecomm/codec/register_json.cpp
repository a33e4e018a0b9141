// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/codec/register_json.h"

#include "drivecomm/codec/json_parsing.h"

#include <nlohmann/json.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

namespace axiscomp::drivecomm {

namespace {

using Json = nlohmann::json;

template <typename Number> std::string shortest(Number value)
{
    std::array<char, 64> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

std::string realJson(double value)
{
    if (!std::isfinite(value))
        return "null";
    // JSON readers take -0 for an integer and lose the sign.
    return value == 0.0 && std::signbit(value) ? "-0.0" : shortest(value);
}

std::string realJson(float value)
{
    if (!std::isfinite(value) || value == 0.0F)
        return realJson(static_cast<double>(value));
    std::string text = shortest(value);
    // Most readers go by way of a double; where rounding twice would miss, all digits are needed.
    double readBack = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), readBack);
    return static_cast<float>(readBack) == value ? text : shortest(static_cast<double>(value));
}

std::optional<JsonValue> scalar(const Json& json)
{
    switch (json.type()) {
    case Json::value_t::null:
        return JsonValue{nullptr};
    case Json::value_t::boolean:
        return JsonValue{json.get<bool>()};
    case Json::value_t::number_integer:
        return JsonValue{json.get<std::int64_t>()};
    case Json::value_t::number_unsigned:
        return JsonValue{json.get<std::uint64_t>()};
    case Json::value_t::number_float:
        return JsonValue{json.get<double>()};
    case Json::value_t::string:
        return JsonValue{json.get<std::string>()};
    default:
        return std::nullopt;
    }
}

std::optional<double> realOf(const JsonValue& value)
{
    if (std::holds_alternative<std::nullptr_t>(value))
        return std::numeric_limits<double>::quiet_NaN();
    if (const auto* real = std::get_if<double>(&value))
        return *real;
    if (const auto* integer = std::get_if<std::int64_t>(&value))
        return static_cast<double>(*integer);
    if (const auto* natural = std::get_if<std::uint64_t>(&value))
        return static_cast<double>(*natural);
    return std::nullopt;
}

template <typename Integer> std::optional<RegisterValue> integerOf(const JsonValue& value)
{
    if (const auto* integer = std::get_if<std::int64_t>(&value);
        integer && std::in_range<Integer>(*integer))
        return RegisterValue{static_cast<Integer>(*integer)};
    if (const auto* natural = std::get_if<std::uint64_t>(&value);
        natural && std::in_range<Integer>(*natural))
        return RegisterValue{static_cast<Integer>(*natural)};
    return std::nullopt;
}

const Json* member(const Json& object, const char* key)
{
    const auto place = object.find(key);
    return place == object.end() ? nullptr : &*place;
}

std::optional<RegisterReading> reading(const Json& json)
{
    if (!json.is_object())
        return std::nullopt;
    const Json* path = member(json, "path");
    const Json* address = member(json, "address");
    const Json* type = member(json, "type");
    const Json* value = member(json, "value");
    if (!path || !path->is_string() || !type || !type->is_string() || !value || !address
        || !address->is_number_unsigned()
        || !std::in_range<std::uint32_t>(address->get<std::uint64_t>()))
        return std::nullopt;
    const std::optional<JsonValue> plain = scalar(*value);
    if (!plain || type->get_ref<const std::string&>().empty())
        return std::nullopt;
    RegisterReading result;
    result.path = normalisedPath(path->get_ref<const std::string&>());
    result.address = address->get<std::uint32_t>();
    result.type = type->get<std::string>();
    auto typed = typedValue(result.type, *plain);
    if (!typed || result.path.empty())
        return std::nullopt;
    result.value = std::move(*typed);
    return result;
}

tl::unexpected<Error> malformed(Text reason)
{
    return fail(ErrorCode::DriveRejected, {{"reason", std::move(reason)}});
}

} // namespace

std::string valueJson(const RegisterValue& value)
{
    struct Writer {
        std::string operator()(bool v) const { return v ? "true" : "false"; }
        std::string operator()(std::int32_t v) const { return std::to_string(v); }
        std::string operator()(std::uint32_t v) const { return std::to_string(v); }
        std::string operator()(float v) const { return realJson(v); }
        std::string operator()(double v) const { return realJson(v); }
        std::string operator()(const std::string& v) const { return jsonString(v); }
    };
    return std::visit(Writer{}, value);
}

std::string readingsJson(std::span<const RegisterReading> readings)
{
    std::string json = "[";
    for (const RegisterReading& each : readings) {
        json += json.size() == 1 ? "\n" : ",\n";
        json += "{\"path\":" + jsonString(each.path);
        json += ",\"address\":" + std::to_string(each.address);
        json += ",\"type\":" + jsonString(each.type);
        json += ",\"value\":" + valueJson(each.value) + "}";
    }
    return json + "\n]\n";
}

Result<std::vector<RegisterReading>> parseReadings(std::string_view json)
{
    const Json document = parseJson(json);
    if (!document.is_array())
        return notExpected(AXISCOMP_TEXT("Error", "a JSON array of registers"), json);
    std::vector<RegisterReading> readings;
    readings.reserve(document.size());
    for (const Json& each : document) {
        auto parsed = reading(each);
        if (!parsed)
            return notExpected(AXISCOMP_TEXT("Error",
                                   "a register with path, address, type and a value of that type"),
                each.dump(-1, ' ', false, Json::error_handler_t::replace));
        readings.push_back(std::move(*parsed));
    }
    return readings;
}

std::string writesJson(std::span<const RegisterWrite> writes)
{
    std::string json = "[";
    for (const RegisterWrite& each : writes) {
        json += json.size() == 1 ? "" : ",";
        json += "{\"path\":" + jsonString(each.path) + ",\"value\":" + valueJson(each.value) + "}";
    }
    return json + "]";
}

Result<std::vector<RequestedWrite>> parseWrites(std::string_view json)
{
    const Json document = parseJson(json);
    if (document.is_discarded())
        return malformed(AXISCOMP_TEXT("Error", "the body is not JSON"));
    if (!document.is_array())
        return malformed(AXISCOMP_TEXT("Error", "the body must be an array, {example}")
                             .with("example", Verbatim{R"([{"path": ..., "value": ...}, ...])"}));
    std::vector<RequestedWrite> writes;
    writes.reserve(document.size());
    for (std::size_t i = 0; i < document.size(); ++i) {
        const std::string place = "[" + std::to_string(i) + "]";
        const Json& each = document[i];
        if (!each.is_object())
            return malformed(AXISCOMP_TEXT("Error", "{place} must be an object, {example}")
                                 .with("place", place)
                                 .with("example", Verbatim{R"({"path": ..., "value": ...})"}));
        const Json* path = member(each, "path");
        if (!path || !path->is_string())
            return malformed(
                AXISCOMP_TEXT("Error", "{place}.path must be a text").with("place", place));
        const Json* value = member(each, "value");
        auto plain = value ? scalar(*value) : std::nullopt;
        if (!plain)
            return malformed(AXISCOMP_TEXT(
                "Error", "{place}.value must be a number, a text, true, false or null")
                                 .with("place", place));
        writes.push_back({normalisedPath(path->get_ref<const std::string&>()), std::move(*plain)});
    }
    return writes;
}

Result<JsonValue> parseWrittenValue(std::string_view json)
{
    const Json document = parseJson(json);
    if (document.is_discarded())
        return malformed(AXISCOMP_TEXT("Error", "the body is not JSON"));
    const Json* value = document.is_object() ? member(document, "value") : nullptr;
    auto plain = value ? scalar(*value) : std::nullopt;
    if (!plain)
        return malformed(AXISCOMP_TEXT("Error",
            "the body must be an object with \"value\": a number, a text, true, false or null"));
    return std::move(*plain);
}

std::optional<RegisterValue> typedValue(std::string_view type, const JsonValue& value)
{
    if (type == "Boolean") {
        const auto* boolean = std::get_if<bool>(&value);
        return boolean ? std::optional<RegisterValue>(*boolean) : std::nullopt;
    }
    if (type == "Int32")
        return integerOf<std::int32_t>(value);
    if (type == "UInt32")
        return integerOf<std::uint32_t>(value);
    if (type == "Double" || type == "Single") {
        const std::optional<double> real = realOf(value);
        if (!real)
            return std::nullopt;
        if (type == "Double")
            return RegisterValue{*real};
        // A finite number beyond a float's range is not silently made infinite.
        const float single = static_cast<float>(*real);
        return std::isinf(single) ? std::nullopt : std::optional<RegisterValue>(single);
    }
    const auto* text = std::get_if<std::string>(&value);
    return text ? std::optional<RegisterValue>(*text) : std::nullopt;
}

std::string describe(const JsonValue& value)
{
    struct Writer {
        std::string operator()(std::nullptr_t) const { return "null"; }
        std::string operator()(bool v) const { return v ? "true" : "false"; }
        std::string operator()(std::int64_t v) const { return std::to_string(v); }
        std::string operator()(std::uint64_t v) const { return std::to_string(v); }
        std::string operator()(double v) const { return realJson(v); }
        std::string operator()(const std::string& v) const { return quoteOf(v).english(); }
    };
    return std::visit(Writer{}, value);
}

} // namespace axiscomp::drivecomm
