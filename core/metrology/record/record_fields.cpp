// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/record/record_fields.h"

#include "core/text/number_text.h"

#include <charconv>

namespace axiscomp::record_json {

namespace {

using Pointer = nlohmann::json::json_pointer;

void keepOthers(
    const nlohmann::json& found, const OrderedJson& known, const Pointer& place, OtherMembers& kept)
{
    if (found.is_array() && known.is_array() && found.size() == known.size())
        for (std::size_t i = 0; i < found.size() && found[i].is_structured(); ++i)
            keepOthers(found[i], known[i], place / i, kept);
    if (!found.is_object() || !known.is_object())
        return;
    for (const auto& [key, value] : found.items()) {
        const Pointer here = place / key;
        const auto ours = known.find(key);
        if (ours == known.end())
            kept[here.to_string()] =
                value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
        else
            keepOthers(value, *ours, here, kept);
    }
}

} // namespace

std::size_t indexFromJson(const JsonNode& node, Names names)
{
    const std::string_view text = node.textView();
    const auto found = std::ranges::find(names, text);
    if (found != names.end())
        return static_cast<std::size_t>(found - names.begin());
    node.refuse(AXISCOMP_TEXT("Error", "\"{found}\" is none of: {known}")
                    .with("found", text)
                    .with("known", Argument(std::vector<std::string>(names.begin(), names.end()))));
    return 0;
}

bool isThere(const JsonNode& object, std::string_view key)
{
    return object.has(key) && !object[key].isNull();
}

std::string maybeText(const JsonNode& object, std::string_view key)
{
    return isThere(object, key) ? object[key].text() : std::string();
}

bool maybeTrue(const JsonNode& object, std::string_view key)
{
    return isThere(object, key) && object[key].boolean();
}

std::optional<double> maybeNumber(const JsonNode& object, std::string_view key)
{
    return isThere(object, key) ? std::optional(object[key].number()) : std::nullopt;
}

std::vector<std::string> textsFromJson(const JsonNode& list)
{
    std::vector<std::string> result;
    for (const JsonNode& item : list.items())
        result.push_back(item.text());
    return result;
}

std::vector<std::string> maybeTexts(const JsonNode& object, std::string_view key)
{
    return isThere(object, key) ? textsFromJson(object[key]) : std::vector<std::string>();
}

void putIfThere(OrderedJson& object, const char* key, const std::string& value)
{
    if (!value.empty())
        object[key] = value;
}

void putIfThere(OrderedJson& object, const char* key, const std::vector<std::string>& value)
{
    if (!value.empty())
        object[key] = value;
}

OtherMembers otherMembers(const JsonNode& node, const OrderedJson& known)
{
    OtherMembers kept;
    if (node.value() != nullptr)
        keepOthers(*node.value(), known, Pointer(), kept);
    return kept;
}

void putBack(OrderedJson& object, const OtherMembers& others)
{
    for (const auto& [place, text] : others) {
        const OrderedJson::json_pointer pointer(place);
        const auto parent = pointer.parent_pointer();
        if (!pointer.empty() && object.contains(parent) && object[parent].is_object()
            && !object.contains(pointer))
            object[pointer] = OrderedJson::parse(text);
    }
}

double shortDouble(float value)
{
    const std::string digits = shortestText(value);
    double result = value;
    std::from_chars(digits.data(), digits.data() + digits.size(), result);
    return static_cast<float>(result) == value ? result : double{value};
}

} // namespace axiscomp::record_json
