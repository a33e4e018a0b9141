// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

/// The beginning or the end of an element, and where it stands.
struct XmlTag {
    struct Attribute {
        std::string_view name;
        std::string value; ///< references replaced
        std::size_t offset = 0; ///< of the value in the document, without its quotation marks
        std::size_t size = 0; ///< bytes there
    };
    std::string_view name;
    bool isEnd = false;
    std::vector<Attribute> attributes;
    std::size_t line = 0; ///< from 1

    /// Null: the element has no such attribute.
    [[nodiscard]] const Attribute* find(std::string_view attribute) const;
};

/// The tags of an XML document in UTF-8 in their order; an empty element begins and ends. Nothing
/// is taken from outside of the document: a document type and entities other than the five of XML
/// are refused. Views and offsets are of the document, so that a value can be replaced in it.
class XmlTags {
public:
    explicit XmlTags(std::string_view document);

    /// Nothing at the end of the document, or when it is not well-formed: then there is a problem.
    [[nodiscard]] std::optional<XmlTag> next();
    [[nodiscard]] const std::optional<Text>& problem() const { return m_problem; }
    [[nodiscard]] std::size_t line() const { return m_line; }

private:
    bool wrong(Text problem);
    bool skipText();
    bool skipTo(std::string_view end);
    bool skipUnparsed(bool& isTag);
    bool readTag(XmlTag& tag);
    bool readAttribute(XmlTag& tag);
    bool enter(const XmlTag& tag);
    [[nodiscard]] std::string_view readName();
    void advance(std::size_t position);
    void skipBlanks();
    [[nodiscard]] std::string_view rest() const { return m_document.substr(m_position); }

    std::string_view m_document;
    std::size_t m_position = 0;
    std::size_t m_line = 1;
    std::vector<std::string_view> m_open;
    bool m_hasRoot = false;
    bool m_endsEmpty = false; ///< the last tag was of an empty element, whose end comes next
    std::optional<Text> m_problem;
};

/// A text as the value of an attribute.
[[nodiscard]] std::string xmlEscaped(std::string_view text);

} // namespace axiscomp
