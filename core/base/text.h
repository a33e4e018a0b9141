// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace axiscomp {

class Text;
class Argument;
struct NamedArgument;

/// A name, a path, a quotation: the same in every language.
struct Verbatim {
    std::string text;

    friend bool operator==(const Verbatim&, const Verbatim&) = default;
};

/// A number as core rounded it, with a decimal point ("0.5", "-1.5e-05"), and its unit, which may
/// be empty.
struct Quantity {
    std::string digits;
    std::string unit = {};

    friend bool operator==(const Quantity&, const Quantity&) = default;
};

/// What the placeholders of a sentence stand for, by their names.
class Arguments {
public:
    Arguments();
    Arguments(std::initializer_list<NamedArgument> arguments);
    Arguments(const Arguments& other);
    Arguments(Arguments&& other) noexcept;
    Arguments& operator=(const Arguments& other);
    Arguments& operator=(Arguments&& other) noexcept;
    ~Arguments();

    [[nodiscard]] const std::vector<NamedArgument>& all() const { return m_arguments; }
    [[nodiscard]] bool contains(std::string_view name) const { return find(name) != nullptr; }
    /// Null when there is none of this name.
    [[nodiscard]] const Argument* find(std::string_view name) const;
    /// In English, empty when there is none of this name: for names and paths that a program acts
    /// on.
    [[nodiscard]] std::string english(std::string_view name) const;
    /// None when there is no whole number of this name.
    [[nodiscard]] std::optional<std::int64_t> integer(std::string_view name) const;
    void set(std::string_view name, Argument value);
    void setIfMissing(std::string_view name, Argument value);
    void remove(std::string_view name);

    friend bool operator==(const Arguments& a, const Arguments& b);

private:
    std::vector<NamedArgument> m_arguments;
};

/// A sentence, or a part of one, in English and with {placeholders}, as the translators have it.
/// Made by AXISCOMP_TEXT or AXISCOMP_COUNTED, where lupdate finds it.
struct TextPattern {
    const char* context = "";
    const char* words = "";
    const char* one = nullptr; ///< the English words when {count} is 1; null: the same

    [[nodiscard]] Text with(std::string_view name, Argument value) const;
};

/// How a language says the words of a text and writes its numbers.
struct Wording {
    /// The words of a pattern, still with its placeholders. count: of a pattern that counts.
    std::function<std::string(const TextPattern& pattern, std::optional<std::int64_t> count)> words;
    char decimalSign = '.';
};

/// A sentence, or a part of one, as a value: the words of a pattern and what its placeholders stand
/// for.
class Text {
public:
    Text() = default;
    Text(const TextPattern& pattern) : m_pattern(pattern) { } // NOLINT(google-explicit-constructor)
    Text(const TextPattern& pattern, Arguments arguments)
        : m_pattern(pattern)
        , m_arguments(std::move(arguments))
    {
    }
    Text(Verbatim text); // NOLINT(google-explicit-constructor)

    /// With words that were read at run time, such as those of the virtual drive's answers.
    [[nodiscard]] static Text withWords(
        std::string_view context, std::string words, std::string one, Arguments arguments);

    [[nodiscard]] Text with(std::string_view name, Argument value) const&;
    [[nodiscard]] Text with(std::string_view name, Argument value) &&;

    [[nodiscard]] bool isEmpty() const { return *m_pattern.words == '\0'; }
    [[nodiscard]] const TextPattern& pattern() const { return m_pattern; }
    [[nodiscard]] const Arguments& arguments() const { return m_arguments; }
    /// A placeholder without an argument becomes "?".
    [[nodiscard]] std::string english() const;
    /// The same in another language.
    [[nodiscard]] std::string in(const Wording& wording) const;

    friend bool operator==(const Text& a, const Text& b);

private:
    struct Words;

    TextPattern m_pattern;
    std::shared_ptr<const Words> m_words; ///< what m_pattern points into, unless it is static
    Arguments m_arguments;
};

/// What one placeholder stands for: a name, a number with its unit, a count, a sentence, or a list.
class Argument {
public:
    using Value = std::variant<Verbatim, Quantity, std::int64_t, Text, std::vector<Text>>;

    Argument(Verbatim value) : m_value(std::move(value)) { } // NOLINT(google-explicit-constructor)
    Argument(Quantity value) : m_value(std::move(value)) { } // NOLINT(google-explicit-constructor)
    Argument(Text value) : m_value(std::move(value)) { } // NOLINT(google-explicit-constructor)
    Argument(const TextPattern& value)
        : m_value(Text(value)) { } // NOLINT(google-explicit-constructor)
    Argument(std::vector<Text> value)
        : m_value(std::move(value)) { } // NOLINT(google-explicit-constructor)
    Argument(const std::vector<std::string>& names); // NOLINT(google-explicit-constructor)
    template <typename Integer,
        std::enable_if_t<
            std::is_integral_v<
                Integer> && !std::is_same_v<Integer, bool> && !std::is_same_v<Integer, char>,
            int> = 0>
    Argument(Integer value) // NOLINT(google-explicit-constructor)
        : m_value(static_cast<std::int64_t>(value))
    {
    }
    /// A name.
    Argument(std::string value)
        : m_value(Verbatim{std::move(value)}) { } // NOLINT(google-explicit-constructor)
    Argument(std::string_view value)
        : m_value(Verbatim{std::string(value)}) { } // NOLINT(google-explicit-constructor)
    /// Words in the source are a sentence (AXISCOMP_TEXT), or are said to be none (Verbatim).
    Argument(const char*) = delete;

    [[nodiscard]] const Value& value() const { return m_value; }
    [[nodiscard]] std::string english() const;
    [[nodiscard]] std::string in(const Wording& wording) const;

    friend bool operator==(const Argument&, const Argument&) = default;

private:
    Value m_value;
};

/// Whether a text in place of a placeholder asks something: the full stop of the sentence around it
/// is left out then. said: the text, in any language.
[[nodiscard]] bool endsInQuestion(const Argument& argument, std::string_view said);

struct NamedArgument {
    std::string name;
    Argument value;

    friend bool operator==(const NamedArgument&, const NamedArgument&) = default;
};

} // namespace axiscomp

/// A pattern in a context of the translations ("Error", "Problem", "Setting" ...). lupdate reads it
/// as QT_TRANSLATE_NOOP.
#define AXISCOMP_TEXT(context, words) (::axiscomp::TextPattern{context, words, nullptr})

/// A pattern whose words depend on {count}: the words for several, and for one. lupdate reads it as
/// QT_TRANSLATE_N_NOOP3, so that every language has its own forms.
#define AXISCOMP_COUNTED(context, words, one) (::axiscomp::TextPattern{context, words, one})
