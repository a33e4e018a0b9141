// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/codec/text_json.h"

#include "core/text/utf8.h"
#include "drivecomm/codec/json_parsing.h"

#include <nlohmann/json.hpp>

#include <utility>

namespace axiscomp::drivecomm {

namespace {

struct ArgumentWriter {
    std::string operator()(const Verbatim& name) const
    {
        return "{\"name\":" + jsonString(name.text) + '}';
    }
    std::string operator()(const Quantity& number) const
    {
        return "{\"number\":" + jsonString(number.digits) + ",\"unit\":" + jsonString(number.unit)
            + '}';
    }
    std::string operator()(std::int64_t count) const
    {
        return "{\"count\":" + std::to_string(count) + '}';
    }
    std::string operator()(const Text& text) const { return "{\"text\":" + textJson(text) + '}'; }
    std::string operator()(const std::vector<Text>& list) const
    {
        std::string items;
        for (const Text& item : list)
            items += (items.empty() ? "" : ",") + textJson(item);
        return "{\"list\":[" + items + "]}";
    }
};

/// Reads one text with all that is in it.
class TextReader {
public:
    [[nodiscard]] std::optional<Text> text(const nlohmann::json& json)
    {
        const auto context = string(json, "context");
        const auto words = string(json, "words");
        const bool isCounted = json.is_object() && json.contains("one");
        const auto one = isCounted ? string(json, "one") : std::string();
        const auto given = json.is_object() ? json.find("arguments") : json.end();
        if (!context || !words || !one || given == json.end() || !given->is_object()
            || m_depth == deepestTextJson)
            return std::nullopt;
        ++m_depth;
        Arguments arguments;
        for (const auto& [name, value] : given->items()) {
            auto read = argument(value);
            if (!read)
                return std::nullopt;
            arguments.set(cut(name), *std::move(read));
        }
        --m_depth;
        Text text = Text::withWords(*context, *words, *one, std::move(arguments));
        if (!isShort(text))
            return std::nullopt;
        return text;
    }

private:
    /// In both of its forms. Texts that are filled into others more than once would grow without
    /// limit; as each of them is looked at by itself, none of these lengths is long to find out.
    [[nodiscard]] static bool isShort(const Text& text)
    {
        const auto fits = [&](const char* words) {
            const Text form(TextPattern{"", words, nullptr}, text.arguments());
            return form.english().size() <= longestTextJsonString;
        };
        const TextPattern& pattern = text.pattern();
        return fits(pattern.words) && (pattern.one == nullptr || fits(pattern.one));
    }

    [[nodiscard]] static std::string cut(std::string_view text)
    {
        return std::string(cutAtCharacter(text, longestTextJsonString));
    }

    [[nodiscard]] static std::optional<std::string> string(
        const nlohmann::json& object, const char* key)
    {
        if (!object.is_object())
            return std::nullopt;
        const auto place = object.find(key);
        if (place == object.end() || !place->is_string())
            return std::nullopt;
        return cut(place->get_ref<const std::string&>());
    }

    [[nodiscard]] std::optional<Argument> argument(const nlohmann::json& json)
    {
        if (++m_arguments > mostTextJsonArguments)
            return std::nullopt;
        if (auto name = string(json, "name"))
            return Verbatim{*std::move(name)};
        if (auto digits = string(json, "number"))
            return Quantity{*std::move(digits), string(json, "unit").value_or("")};
        if (!json.is_object())
            return std::nullopt;
        if (const auto count = json.find("count"); count != json.end()) {
            const bool isSmall = !count->is_number_unsigned()
                || std::in_range<std::int64_t>(count->get<std::uint64_t>());
            if (!count->is_number_integer() || !isSmall)
                return std::nullopt;
            return count->get<std::int64_t>();
        }
        if (const auto inner = json.find("text"); inner != json.end())
            return text(*inner);
        const auto items = json.find("list");
        return items == json.end() ? std::nullopt : list(*items);
    }

    [[nodiscard]] std::optional<Argument> list(const nlohmann::json& json)
    {
        if (!json.is_array())
            return std::nullopt;
        std::vector<Text> items;
        for (const nlohmann::json& each : json) {
            auto item = ++m_arguments > mostTextJsonArguments ? std::nullopt : text(each);
            if (!item)
                return std::nullopt;
            items.push_back(*std::move(item));
        }
        return items;
    }

    int m_depth = 0;
    std::size_t m_arguments = 0;
};

} // namespace

std::string textJson(const Text& text)
{
    const TextPattern& pattern = text.pattern();
    std::string json =
        "{\"context\":" + jsonString(pattern.context) + ",\"words\":" + jsonString(pattern.words);
    if (pattern.one != nullptr)
        json += ",\"one\":" + jsonString(pattern.one);
    json += ",\"arguments\":{";
    std::string_view separator;
    for (const NamedArgument& argument : text.arguments().all()) {
        json.append(separator).append(jsonString(argument.name)).append(":");
        json += std::visit(ArgumentWriter{}, argument.value.value());
        separator = ",";
    }
    return json + "}}";
}

std::optional<Text> parseTextJson(std::string_view json)
{
    return textFromJson(parseJson(json, textJsonNesting));
}

std::optional<Text> textFromJson(const nlohmann::json& json)
{
    return TextReader().text(json);
}

} // namespace axiscomp::drivecomm
