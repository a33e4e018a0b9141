// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/strict_json.h"

#include <algorithm>
#include <utility>

namespace axiscomp {

namespace {

constexpr int documentVersion = 1;

using nlohmann::json;

Text lineAndColumn(std::string_view text, std::size_t position)
{
    const std::string_view before = text.substr(0, position);
    const auto line = 1 + std::ranges::count(before, '\n');
    const std::size_t lineStart = before.rfind('\n') + 1; // npos + 1 = 0
    return AXISCOMP_TEXT("Error", "line {line}, column {column}")
        .with("line", line)
        .with("column", before.size() - lineStart + 1);
}

Text orDocument(const std::string& path)
{
    return path.empty() ? Text(AXISCOMP_TEXT("Error", "the document")) : Verbatim{path};
}

JsonProblem problemAt(Text place, Text fault)
{
    Text reason =
        AXISCOMP_TEXT("Error", "{place}: {problem}").with("place", place).with("problem", fault);
    return {std::move(reason), std::move(place), std::move(fault)};
}

Text described(const json* value)
{
    if (value->is_structured())
        return value->is_array() ? AXISCOMP_TEXT("Error", "a list")
                                 : AXISCOMP_TEXT("Error", "an object");
    constexpr std::size_t longest = 40;
    std::string text = value->dump(-1, ' ', true, json::error_handler_t::replace);
    return Verbatim{text.size() > longest ? text.substr(0, longest) + "..." : std::move(text)};
}

/// Builds the document and stops at the first breach of a limit. The library's own parser looks at
/// depth and repeated members only after it has stored them, if at all.
class Builder final : public nlohmann::json_sax<json> {
public:
    Builder(std::string_view text, const JsonLimits& limits, json& document)
        : m_text(text)
        , m_limits(limits)
        , m_document(document)
    {
    }
    [[nodiscard]] const JsonProblem& problem() const { return m_problem; }

    bool null() override { return place(nullptr); }
    bool boolean(bool value) override { return place(value); }
    bool number_integer(number_integer_t value) override { return place(value); }
    bool number_unsigned(number_unsigned_t value) override { return place(value); }
    bool number_float(number_float_t value, const string_t&) override { return place(value); }
    bool string(string_t& value) override { return place(std::move(value)); }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(json::object()); }
    bool start_array(std::size_t) override { return open(json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& name) override
    {
        const auto [member, isNew] = m_open.back()->emplace(name, nullptr);
        m_member = &*member;
        if (!isNew)
            breach(AXISCOMP_TEXT("Error", "the member \"{name}\" is there twice in one object")
                       .with("name", name),
                path() + name);
        return isNew;
    }
    bool parse_error(std::size_t position, const std::string&, const json::exception&) override
    {
        m_problem = problemAt(lineAndColumn(m_text, position == 0 ? 0 : position - 1),
            AXISCOMP_TEXT("Error", "this is not JSON"));
        return false;
    }

private:
    void breach(const Text& fault, const std::string& place = {})
    {
        m_problem = {fault, orDocument(place), fault};
    }
    /// Of the innermost object that is open, with a dot behind it: "slots[2]."
    [[nodiscard]] std::string path() const
    {
        std::string result;
        for (std::size_t i = 0; i + 1 < m_open.size(); ++i) {
            const json& outer = *m_open[i];
            if (outer.is_array()) {
                result += "[" + std::to_string(outer.size() - 1) + "]";
                continue;
            }
            const auto isOpen = [&](const json& member) { return &member == m_open[i + 1]; };
            const auto member = std::find_if(outer.begin(), outer.end(), isOpen);
            result += (result.empty() ? "" : ".") + member.key();
        }
        return result.empty() ? result : result + ".";
    }
    template <typename Value> bool place(Value&& value)
    {
        return put(json(std::forward<Value>(value))) != nullptr;
    }
    json* put(json&& value)
    {
        if (++m_values > m_limits.values) {
            breach(AXISCOMP_TEXT("Error", "it has more than {count} values")
                       .with("count", m_limits.values));
            return nullptr;
        }
        json* const target = m_open.empty() ? &m_document
            : m_open.back()->is_array()     ? &m_open.back()->emplace_back()
                                            : m_member;
        *target = std::move(value);
        return target;
    }
    bool open(json&& container)
    {
        if (static_cast<int>(m_open.size()) >= m_limits.depth) {
            breach(AXISCOMP_TEXT("Error", "it is nested deeper than {count} levels")
                       .with("count", m_limits.depth));
            return false;
        }
        m_open.push_back(put(std::move(container)));
        return m_open.back() != nullptr;
    }
    bool close()
    {
        m_open.pop_back();
        return true;
    }

    std::string_view m_text;
    const JsonLimits& m_limits;
    json& m_document;
    std::vector<json*> m_open; ///< the objects and arrays around the current place
    json* m_member = nullptr; ///< of the innermost object, awaiting its value
    std::size_t m_values = 0;
    JsonProblem m_problem;
};

} // namespace

StrictJson::StrictJson(std::string_view text, const JsonLimits& limits)
{
    if (text.size() > limits.size) {
        const Text fault = AXISCOMP_TEXT(
            "Error", "it has {size} bytes, more than the {limit} that such a file can have")
                               .with("size", text.size())
                               .with("limit", limits.size);
        m_problem = JsonProblem{fault, orDocument({}), fault};
        return;
    }
    Builder builder{text, limits, m_document};
    if (!json::sax_parse(text, &builder))
        m_problem = builder.problem();
}

JsonNode StrictJson::root()
{
    return {this, m_problem ? nullptr : &m_document, {}};
}

JsonNode::JsonNode(StrictJson* document, const json* value, std::string path)
    : m_document(document)
    , m_value(value)
    , m_path(std::move(path))
{
}

void JsonNode::refuse(Text reason) const
{
    if (!m_document->m_problem)
        m_document->m_problem = problemAt(orDocument(m_path), std::move(reason));
}

std::string JsonNode::pathOf(std::string_view key) const
{
    return m_path.empty() ? std::string(key) : m_path + "." + std::string(key);
}

JsonNode JsonNode::operator[](std::string_view key) const
{
    std::string path = pathOf(key);
    const json* member = nullptr;
    if (m_value != nullptr && !m_value->is_object())
        refuse(AXISCOMP_TEXT("Error", "an object is expected, not {found}")
                   .with("found", described(m_value)));
    else if (m_value != nullptr) {
        const auto found = m_value->find(key);
        if (found != m_value->end())
            member = &*found;
        else
            JsonNode(m_document, nullptr, path).refuse(AXISCOMP_TEXT("Error", "this is missing"));
    }
    return {m_document, member, std::move(path)};
}

std::vector<JsonNode> JsonNode::items() const
{
    std::vector<JsonNode> result;
    if (m_value != nullptr && !m_value->is_array())
        refuse(AXISCOMP_TEXT("Error", "a list is expected, not {found}")
                   .with("found", described(m_value)));
    else if (m_value != nullptr)
        for (const json& item : *m_value)
            result.push_back(
                {m_document, &item, m_path + "[" + std::to_string(result.size()) + "]"});
    return result;
}

void JsonNode::expectMembers(std::initializer_list<std::string_view> keys) const
{
    expectMembers(std::span(keys.begin(), keys.size()));
}

void JsonNode::expectMembers(
    std::span<const std::string_view> keys, std::span<const std::string_view> optional) const
{
    for (const std::string_view key : keys)
        static_cast<void>((*this)[key]);
    if (m_value == nullptr || !m_value->is_object())
        return;
    for (const auto& [key, value] : m_value->items()) {
        if (m_document->m_problem || std::ranges::find(keys, key) != keys.end()
            || std::ranges::find(optional, key) != optional.end())
            continue;
        JsonProblem problem = problemAt(orDocument(m_path),
            AXISCOMP_TEXT("Error", "the member \"{name}\" is not known").with("name", key));
        problem.place = Verbatim{pathOf(key)};
        m_document->m_problem = std::move(problem);
    }
}

std::vector<std::string> JsonNode::memberNames() const
{
    std::vector<std::string> names;
    if (m_value != nullptr && m_value->is_object())
        for (const auto& [key, value] : m_value->items())
            names.push_back(key);
    return names;
}

bool JsonNode::has(std::string_view key) const
{
    return m_value != nullptr && m_value->is_object() && m_value->contains(key);
}

bool JsonNode::isText() const
{
    return m_value != nullptr && m_value->is_string();
}

bool JsonNode::isNull() const
{
    return m_value != nullptr && m_value->is_null();
}

std::string_view JsonNode::textView() const
{
    if (isText())
        return m_value->get_ref<const std::string&>();
    if (m_value != nullptr)
        refuse(AXISCOMP_TEXT("Error", "a text is expected, not {found}")
                   .with("found", described(m_value)));
    return {};
}

std::string JsonNode::text() const
{
    return std::string(textView());
}

bool JsonNode::boolean() const
{
    if (m_value != nullptr && m_value->is_boolean())
        return m_value->get<bool>();
    if (m_value != nullptr)
        refuse(AXISCOMP_TEXT("Error", "true or false is expected, not {found}")
                   .with("found", described(m_value)));
    return false;
}

double JsonNode::number() const
{
    if (m_value != nullptr && m_value->is_number())
        return m_value->get<double>();
    if (m_value != nullptr)
        refuse(AXISCOMP_TEXT("Error", "a number is expected, not {found}")
                   .with("found", described(m_value)));
    return 0.0;
}

std::vector<double> JsonNode::numbers() const
{
    std::vector<double> result;
    for (const auto& number : numbersOrNull())
        result.push_back(number.value_or(0.0));
    if (m_value != nullptr && m_value->is_array()) {
        const auto hole = std::ranges::find_if(*m_value, &json::is_null);
        if (hole != m_value->end())
            static_cast<void>(element(hole - m_value->begin()).number());
    }
    return result;
}

std::vector<std::optional<double>> JsonNode::numbersOrNull() const
{
    std::vector<std::optional<double>> result;
    if (m_value == nullptr || !m_value->is_array()) {
        static_cast<void>(items());
        return result;
    }
    result.reserve(m_value->size());
    for (const json& item : *m_value) {
        if (item.is_number())
            result.emplace_back(item.get<double>());
        else
            result.emplace_back();
        if (!item.is_number() && !item.is_null())
            static_cast<void>(element(&item - &m_value->front()).number());
    }
    return result;
}

JsonNode JsonNode::element(std::ptrdiff_t index) const
{
    return {m_document, &(*m_value)[static_cast<std::size_t>(index)],
        m_path + "[" + std::to_string(index) + "]"};
}

std::int64_t JsonNode::integerWithin(std::int64_t minimum, std::int64_t maximum) const
{
    if (m_value == nullptr)
        return minimum;
    const bool tooLarge = m_value->is_number_unsigned()
        && m_value->get<std::uint64_t>() > static_cast<std::uint64_t>(maximum);
    if (m_value->is_number_integer() && !tooLarge) {
        const auto value = m_value->get<std::int64_t>();
        if (value >= minimum && value <= maximum)
            return value;
    }
    refuse(AXISCOMP_TEXT("Error", "a whole number from {least} to {most} is expected, not {found}")
               .with("least", minimum)
               .with("most", maximum)
               .with("found", described(m_value)));
    return minimum;
}

std::string jsonText(const OrderedJson& document)
{
    return document.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

OrderedJson newDocument(std::string_view format)
{
    return {{"format", format}, {"version", documentVersion}};
}

void expectFormat(const JsonNode& document, std::string_view format)
{
    const JsonNode found = document["format"];
    if (found.textView() != format)
        found.refuse(AXISCOMP_TEXT("Error", "\"{format}\" is expected").with("format", format));
    const JsonNode foundVersion = document["version"];
    if (foundVersion.integer<int>() != documentVersion)
        foundVersion.refuse(AXISCOMP_TEXT("Error",
            "only version {version} can be read; a newer version of this program may have written "
            "it")
                                .with("version", documentVersion));
}

} // namespace axiscomp
