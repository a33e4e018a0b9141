// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/xml_tags.h"

#include "core/text/utf8.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <utility>

namespace axiscomp {

namespace {

constexpr std::string_view xmlBlanks = " \t\r\n";
constexpr std::size_t deepestElement = 1000;

struct XmlReference {
    std::string_view name;
    char character;
};
constexpr std::array xmlReferences{XmlReference{"amp", '&'}, XmlReference{"lt", '<'},
    XmlReference{"gt", '>'}, XmlReference{"quot", '"'}, XmlReference{"apos", '\''}};

void appendUtf8(std::string& text, std::uint32_t code)
{
    const auto add = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
    const auto addRest = [&](int shift) { add(0x80U | ((code >> shift) & 0x3FU)); };
    if (code < 0x80) {
        add(code);
    } else if (code < 0x800) {
        add(0xC0U | (code >> 6));
        addRest(0);
    } else if (code < 0x10000) {
        add(0xE0U | (code >> 12));
        addRest(6);
        addRest(0);
    } else {
        add(0xF0U | (code >> 18));
        addRest(12);
        addRest(6);
        addRest(0);
    }
}

/// "amp", "#65", "#x41"
bool appendReference(std::string& text, std::string_view name)
{
    const auto* const known = std::ranges::find(xmlReferences, name, &XmlReference::name);
    if (known != xmlReferences.end()) {
        text += known->character;
        return true;
    }
    if (!name.starts_with('#'))
        return false;
    name.remove_prefix(1);
    const bool isHex = name.starts_with('x');
    name.remove_prefix(isHex ? 1 : 0);
    std::uint32_t code = 0;
    const char* const end = name.data() + name.size();
    const auto parsed = std::from_chars(name.data(), end, code, isHex ? 16 : 10);
    const bool isCharacter = (code >= 0x20 || code == '\t' || code == '\n' || code == '\r')
        && code <= 0x10FFFF && (code < 0xD800 || code > 0xDFFF);
    if (name.empty() || parsed.ec != std::errc{} || parsed.ptr != end || !isCharacter)
        return false;
    appendUtf8(text, code);
    return true;
}

/// References replaced; nothing when one is none that XML has by itself.
std::optional<std::string> withoutReferences(std::string_view raw)
{
    std::string text;
    for (std::size_t i = 0; i < raw.size(); ++i) {
        if (raw[i] != '&') {
            text += xmlBlanks.find(raw[i]) == std::string_view::npos ? raw[i] : ' ';
            continue;
        }
        const std::size_t end = raw.find(';', i);
        if (end == std::string_view::npos || !appendReference(text, raw.substr(i + 1, end - i - 1)))
            return std::nullopt;
        i = end;
    }
    return text;
}

} // namespace

const XmlTag::Attribute* XmlTag::find(std::string_view attribute) const
{
    const auto found = std::ranges::find(attributes, attribute, &Attribute::name);
    return found == attributes.end() ? nullptr : &*found;
}

XmlTags::XmlTags(std::string_view document) : m_document(document)
{
    const auto isForbidden = [](char c) {
        return static_cast<unsigned char>(c) < 0x20 && xmlBlanks.find(c) == std::string_view::npos;
    };
    const auto forbidden = std::ranges::find_if(document, isForbidden);
    const std::size_t end =
        std::min(findInvalidUtf8(document), static_cast<std::size_t>(forbidden - document.begin()));
    if (end < document.size()) {
        advance(end);
        wrong(AXISCOMP_TEXT("Error", "it is not a text in UTF-8"));
    }
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    if (!m_problem && document.starts_with(mark))
        m_position = mark.size();
}

std::optional<XmlTag> XmlTags::next()
{
    XmlTag tag;
    if (m_problem)
        return std::nullopt;
    if (m_endsEmpty) {
        m_endsEmpty = false;
        tag.name = m_open.back();
        tag.isEnd = true;
        tag.line = m_line;
        m_open.pop_back();
        return tag;
    }
    for (bool isTag = false; !isTag;) {
        if (!skipText())
            return std::nullopt;
        if (m_position == m_document.size()) {
            if (!m_hasRoot)
                wrong(AXISCOMP_TEXT("Error", "it is not an XML document"));
            else if (!m_open.empty())
                wrong(AXISCOMP_TEXT("Error", "it ends before {name} ends")
                          .with("name", shownText(m_open.back())));
            return std::nullopt;
        }
        if (!skipUnparsed(isTag))
            return std::nullopt;
    }
    if (!readTag(tag) || !enter(tag))
        return std::nullopt;
    return tag;
}

bool XmlTags::wrong(Text problem)
{
    m_problem = std::move(problem);
    return false;
}

void XmlTags::advance(std::size_t position)
{
    m_line += static_cast<std::size_t>(
        std::ranges::count(m_document.substr(m_position, position - m_position), '\n'));
    m_position = position;
}

void XmlTags::skipBlanks()
{
    advance(std::min(m_document.find_first_not_of(xmlBlanks, m_position), m_document.size()));
}

/// To the next tag. Text between elements is of no interest, but it must be one.
bool XmlTags::skipText()
{
    const std::size_t end = std::min(m_document.find('<', m_position), m_document.size());
    const std::string_view text = m_document.substr(m_position, end - m_position);
    if (m_open.empty() && text.find_first_not_of(xmlBlanks) != std::string_view::npos)
        return wrong(AXISCOMP_TEXT("Error", "it is not an XML document"));
    for (std::size_t at = text.find('&'); at != std::string_view::npos;
         at = text.find('&', at + 1)) {
        if (withoutReferences(text.substr(at, text.find(';', at) + 1 - at)))
            continue;
        advance(m_position + at);
        return wrong(AXISCOMP_TEXT("Error", "entities are not allowed"));
    }
    advance(end);
    return true;
}

bool XmlTags::skipTo(std::string_view end)
{
    const std::size_t found = m_document.find(end, m_position);
    if (found == std::string_view::npos)
        return wrong(AXISCOMP_TEXT("Error", "it ends before {name} ends")
                         .with("name", shownText(rest().substr(0, 4))));
    advance(found + end.size());
    return true;
}

/// Comments, instructions and character data; isTag: what comes is a tag.
bool XmlTags::skipUnparsed(bool& isTag)
{
    if (rest().starts_with("<!--"))
        return skipTo("-->");
    if (rest().starts_with("<?"))
        return skipTo("?>");
    if (rest().starts_with("<![CDATA[") && !m_open.empty())
        return skipTo("]]>");
    if (rest().starts_with("<!"))
        return wrong(AXISCOMP_TEXT("Error", "a document type is not allowed"));
    isTag = true;
    return true;
}

std::string_view XmlTags::readName()
{
    const std::size_t end =
        std::min(m_document.find_first_of(" \t\r\n/>=<\"'&", m_position), m_document.size());
    const std::string_view name = m_document.substr(m_position, end - m_position);
    m_position = end;
    return name;
}

bool XmlTags::readTag(XmlTag& tag)
{
    const auto unexpected = [&] {
        return wrong(AXISCOMP_TEXT("Error", "a tag is not well-formed"));
    };
    tag.line = m_line;
    ++m_position;
    tag.isEnd = rest().starts_with('/');
    m_position += tag.isEnd ? 1 : 0;
    tag.name = readName();
    if (tag.name.empty())
        return unexpected();
    for (;;) {
        const std::size_t before = m_position;
        skipBlanks();
        if (rest().starts_with('>')) {
            ++m_position;
            return true;
        }
        if (rest().starts_with("/>") && !tag.isEnd) {
            m_position += 2;
            m_endsEmpty = true;
            return true;
        }
        if (tag.isEnd || before == m_position)
            return unexpected();
        if (!readAttribute(tag))
            return m_problem ? false : unexpected();
    }
}

bool XmlTags::readAttribute(XmlTag& tag)
{
    XmlTag::Attribute attribute;
    attribute.name = readName();
    skipBlanks();
    if (attribute.name.empty() || tag.find(attribute.name) || !rest().starts_with('='))
        return false;
    ++m_position;
    skipBlanks();
    const char mark = rest().empty() ? ' ' : rest().front();
    const std::size_t end = m_document.find(mark, m_position + 1);
    if ((mark != '"' && mark != '\'') || end == std::string_view::npos)
        return false;
    attribute.offset = m_position + 1;
    attribute.size = end - attribute.offset;
    const std::string_view raw = m_document.substr(attribute.offset, attribute.size);
    if (raw.find('<') != std::string_view::npos)
        return false;
    auto value = withoutReferences(raw);
    if (!value)
        return wrong(AXISCOMP_TEXT("Error", "entities are not allowed"));
    attribute.value = *std::move(value);
    tag.attributes.push_back(std::move(attribute));
    advance(end + 1);
    return true;
}

bool XmlTags::enter(const XmlTag& tag)
{
    if (!tag.isEnd) {
        if ((m_open.empty() && m_hasRoot) || m_open.size() == deepestElement)
            return wrong(AXISCOMP_TEXT("Error", "a tag is not well-formed"));
        m_hasRoot = true;
        m_open.push_back(tag.name);
        return true;
    }
    if (m_open.empty() || m_open.back() != tag.name)
        return wrong(AXISCOMP_TEXT("Error", "{name} ends where it has not begun")
                         .with("name", shownText(tag.name)));
    m_open.pop_back();
    return true;
}

std::string xmlEscaped(std::string_view text)
{
    std::string escaped;
    for (const char c : text) {
        const auto* const known = std::ranges::find(xmlReferences, c, &XmlReference::character);
        if (known == xmlReferences.end())
            escaped += c;
        else
            escaped += '&' + std::string(known->name) + ';';
    }
    return escaped;
}

} // namespace axiscomp
