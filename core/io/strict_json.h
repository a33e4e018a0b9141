// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

struct JsonLimits {
    std::size_t size = 0; ///< bytes of text
    int depth = 16; ///< objects and arrays inside each other
    std::size_t values = 1'000'000; ///< objects, arrays, texts, numbers ... together
};

/// The first thing that is wrong with a document, in words.
struct JsonProblem {
    Text reason; ///< "axes[0].files[1].crc32: ..." or "line 3, column 5: ..."
    /// The same in two parts: "slots[2].maximumSize", "line 3, column 5" or "the document", and the
    /// fault alone.
    Text place = {};
    Text fault = {};
};

class JsonNode;

/// A JSON document from a file that anybody may have edited: refuses what is too large or too deep
/// and members that are there twice. Then node() reads it; the first problem is kept, so that a
/// reader asks for everything it needs and looks at problem() once, at the end.
class StrictJson {
public:
    StrictJson(std::string_view text, const JsonLimits& limits);

    [[nodiscard]] JsonNode root();
    [[nodiscard]] const std::optional<JsonProblem>& problem() const { return m_problem; }

private:
    friend class JsonNode;
    nlohmann::json m_document;
    std::optional<JsonProblem> m_problem;
};

/// One place in a StrictJson document, which must outlive it. Where the document is not as asked
/// for, the problem is recorded with the place's path, and an empty value comes back.
class JsonNode {
public:
    /// A member that must be there.
    [[nodiscard]] JsonNode operator[](std::string_view key) const;
    /// The elements of an array.
    [[nodiscard]] std::vector<JsonNode> items() const;
    /// An object with exactly these members, in any order; those of `optional` may be missing.
    void expectMembers(std::initializer_list<std::string_view> keys) const;
    void expectMembers(std::span<const std::string_view> keys,
        std::span<const std::string_view> optional = {}) const;
    /// The names of an object's members, sorted; none for anything else.
    [[nodiscard]] std::vector<std::string> memberNames() const;
    /// True when this is an object with that member.
    [[nodiscard]] bool has(std::string_view key) const;

    [[nodiscard]] std::string text() const;
    [[nodiscard]] std::string_view textView() const; ///< lives as long as the document
    [[nodiscard]] bool boolean() const;
    [[nodiscard]] double number() const;
    [[nodiscard]] std::vector<double> numbers() const; ///< of a list
    [[nodiscard]] std::vector<std::optional<double>> numbersOrNull() const; ///< of a list
    template <typename Integer>
    [[nodiscard]] Integer integer(Integer minimum = std::numeric_limits<Integer>::min(),
        Integer maximum = std::numeric_limits<Integer>::max()) const
    {
        return static_cast<Integer>(
            integerWithin(static_cast<std::int64_t>(minimum), static_cast<std::int64_t>(maximum)));
    }

    [[nodiscard]] bool isText() const;
    [[nodiscard]] bool isNull() const; ///< null stands here
    /// What stands here, of whatever kind. Null pointer: there was a problem on the way here.
    [[nodiscard]] const nlohmann::json* value() const { return m_value; }
    /// Records a problem at this place, unless there is one already.
    void refuse(Text reason) const;

private:
    friend class StrictJson;
    JsonNode(StrictJson* document, const nlohmann::json* value, std::string path);
    [[nodiscard]] std::int64_t integerWithin(std::int64_t minimum, std::int64_t maximum) const;
    [[nodiscard]] JsonNode element(std::ptrdiff_t index) const; ///< of a list that has it
    [[nodiscard]] std::string pathOf(std::string_view key) const;

    StrictJson* m_document;
    const nlohmann::json* m_value; ///< null: there was a problem on the way here
    std::string m_path;
};

/// Written in the order in which the members were added, as a person would read them.
using OrderedJson = nlohmann::ordered_json;

/// Indented, with a line break at the end. Text that is not UTF-8 (a drive's name may be any bytes)
/// gets replacement characters.
[[nodiscard]] std::string jsonText(const OrderedJson& document);

/// {"format": format, "version": 1}, to which the rest is added.
[[nodiscard]] OrderedJson newDocument(std::string_view format);
/// Refuses another format or version.
void expectFormat(const JsonNode& document, std::string_view format);

} // namespace axiscomp
