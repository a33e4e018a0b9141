// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"

#include <algorithm>
#include <cstring>

namespace axiscomp {

namespace {

template <typename... Cases> struct Overloaded : Cases... {
    using Cases::operator()...;
};
template <typename... Cases> Overloaded(Cases...) -> Overloaded<Cases...>;

bool isSame(const char* a, const char* b)
{
    return a == b || (a != nullptr && b != nullptr && std::strcmp(a, b) == 0);
}

const Wording& englishWording()
{
    static const Wording english{
        [](const TextPattern& pattern, std::optional<std::int64_t> count) {
            return std::string(pattern.one != nullptr && count == 1 ? pattern.one : pattern.words);
        },
        '.'};
    return english;
}

} // namespace

struct Text::Words {
    std::string context;
    std::string words;
    std::string one;
};

Arguments::Arguments() = default;
Arguments::Arguments(std::initializer_list<NamedArgument> arguments) : m_arguments(arguments) { }
Arguments::Arguments(const Arguments& other) = default;
Arguments::Arguments(Arguments&& other) noexcept = default;
Arguments& Arguments::operator=(const Arguments& other) = default;
Arguments& Arguments::operator=(Arguments&& other) noexcept = default;
Arguments::~Arguments() = default;

const Argument* Arguments::find(std::string_view name) const
{
    const auto place = std::ranges::find(m_arguments, name, &NamedArgument::name);
    return place == m_arguments.end() ? nullptr : &place->value;
}

std::string Arguments::english(std::string_view name) const
{
    const Argument* const value = find(name);
    return value ? value->english() : std::string();
}

std::optional<std::int64_t> Arguments::integer(std::string_view name) const
{
    const Argument* const value = find(name);
    const auto* const number = value ? std::get_if<std::int64_t>(&value->value()) : nullptr;
    return number ? std::optional(*number) : std::nullopt;
}

void Arguments::set(std::string_view name, Argument value)
{
    const auto place = std::ranges::find(m_arguments, name, &NamedArgument::name);
    if (place == m_arguments.end())
        m_arguments.push_back({std::string(name), std::move(value)});
    else
        place->value = std::move(value);
}

void Arguments::setIfMissing(std::string_view name, Argument value)
{
    if (!contains(name))
        m_arguments.push_back({std::string(name), std::move(value)});
}

void Arguments::remove(std::string_view name)
{
    std::erase_if(
        m_arguments, [&](const NamedArgument& argument) { return argument.name == name; });
}

bool operator==(const Arguments& a, const Arguments& b)
{
    return std::ranges::is_permutation(a.m_arguments, b.m_arguments);
}

bool endsInQuestion(const Argument& argument, std::string_view said)
{
    return std::holds_alternative<Text>(argument.value())
        && (said.ends_with('?') || said.ends_with("\uff1f"));
}

Text TextPattern::with(std::string_view name, Argument value) const
{
    return Text(*this).with(name, std::move(value));
}

Text::Text(Verbatim text) : m_pattern{"", "{text}", nullptr}
{
    if (text.text.empty())
        m_pattern = {};
    else
        m_arguments.set("text", std::move(text));
}

Text Text::withWords(
    std::string_view context, std::string words, std::string one, Arguments arguments)
{
    const auto owned = std::make_shared<const Words>(
        Words{std::string(context), std::move(words), std::move(one)});
    Text text({owned->context.c_str(), owned->words.c_str(),
                  owned->one.empty() ? nullptr : owned->one.c_str()},
        std::move(arguments));
    text.m_words = owned;
    return text;
}

Text Text::with(std::string_view name, Argument value) const&
{
    return Text(*this).with(name, std::move(value));
}

Text Text::with(std::string_view name, Argument value) &&
{
    m_arguments.set(name, std::move(value));
    return std::move(*this);
}

std::string Text::english() const
{
    return in(englishWording());
}

std::string Text::in(const Wording& wording) const
{
    const std::string translated = wording.words(
        m_pattern, m_pattern.one != nullptr ? m_arguments.integer("count") : std::nullopt);
    std::string_view words = translated;
    std::string text;
    while (true) {
        const std::size_t open = words.find('{');
        const std::size_t close = words.find('}', open);
        if (open == std::string_view::npos || close == std::string_view::npos)
            return text.append(words);
        const Argument* const value = m_arguments.find(words.substr(open + 1, close - open - 1));
        text.append(words.substr(0, open)).append(value ? value->in(wording) : "?");
        words.remove_prefix(close + 1);
        if (!value || !endsInQuestion(*value, text))
            continue;
        for (const std::string_view stop : {".", "\u3002"})
            if (words.starts_with(stop))
                words.remove_prefix(stop.size());
    }
}

bool operator==(const Text& a, const Text& b)
{
    return isSame(a.m_pattern.context, b.m_pattern.context)
        && isSame(a.m_pattern.words, b.m_pattern.words) && a.m_arguments == b.m_arguments;
}

Argument::Argument(const std::vector<std::string>& names)
{
    std::vector<Text> list;
    for (const std::string& name : names)
        list.emplace_back(Verbatim{name});
    m_value = std::move(list);
}

std::string Argument::english() const
{
    return in(englishWording());
}

std::string Argument::in(const Wording& wording) const
{
    return std::visit(
        Overloaded{[](const Verbatim& name) { return name.text; },
            [&wording](const Quantity& number) {
                std::string digits = number.digits;
                std::ranges::replace(digits, '.', wording.decimalSign);
                if (number.unit.empty())
                    return digits;
                return digits + ' '
                    + wording.words({"Unit", number.unit.c_str(), nullptr}, std::nullopt);
            },
            [](std::int64_t count) { return std::to_string(count); },
            [&wording](const Text& text) { return text.in(wording); },
            [&wording](const std::vector<Text>& list) {
                std::string joined;
                for (const Text& item : list)
                    joined.append(joined.empty() ? "" : ", ").append(item.in(wording));
                return joined;
            }},
        m_value);
}

} // namespace axiscomp
