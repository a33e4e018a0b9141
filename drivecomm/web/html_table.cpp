// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/web/html_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <utility>

namespace axiscomp::drivecomm {

namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 6> namedReferences{{
    {"amp", "&"},
    {"lt", "<"},
    {"gt", ">"},
    {"quot", "\""},
    {"apos", "'"},
    {"nbsp", " "},
}};

bool isBlank(char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool startsWith(std::string_view text, std::string_view lowerCasePrefix)
{
    return text.size() >= lowerCasePrefix.size()
        && std::equal(lowerCasePrefix.begin(), lowerCasePrefix.end(), text.begin(),
            [](char a, char b) { return a == lower(b); });
}

void appendUtf8(std::string& out, std::uint32_t code)
{
    if (code == 0 || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000))
        code = 0xFFFD;
    const auto byte = [&out](std::uint32_t value) { out += static_cast<char>(value); };
    if (code < 0x80) {
        byte(code);
    } else if (code < 0x800) {
        byte(0xC0 | (code >> 6));
        byte(0x80 | (code & 0x3F));
    } else if (code < 0x10000) {
        byte(0xE0 | (code >> 12));
        byte(0x80 | ((code >> 6) & 0x3F));
        byte(0x80 | (code & 0x3F));
    } else {
        byte(0xF0 | (code >> 18));
        byte(0x80 | ((code >> 12) & 0x3F));
        byte(0x80 | ((code >> 6) & 0x3F));
        byte(0x80 | (code & 0x3F));
    }
}

/// Plain text that grows from pieces of markup.
class TextCollector {
public:
    void addText(std::string_view text)
    {
        while (!text.empty()) {
            if (text.front() == '&') {
                text.remove_prefix(addReference(text));
                continue;
            }
            addCharacter(text.front());
            text.remove_prefix(1);
        }
    }
    void addBlank() { m_blank = true; }
    [[nodiscard]] std::string take()
    {
        m_blank = false;
        return std::exchange(m_text, {});
    }

private:
    void addCharacter(char c)
    {
        if (isBlank(c)) {
            m_blank = true;
            return;
        }
        separate();
        m_text += c;
    }
    void separate()
    {
        if (m_blank && !m_text.empty())
            m_text += ' ';
        m_blank = false;
    }
    /// Length of the reference at the start of text; a lone & is itself.
    std::size_t addReference(std::string_view text)
    {
        const std::size_t end = text.substr(0, 12).find(';');
        if (end != std::string_view::npos) {
            const std::string_view name = text.substr(1, end - 1);
            for (const auto& [known, replacement] : namedReferences) {
                if (name != known)
                    continue;
                addCharacter(replacement.front());
                return end + 1;
            }
            if (addNumericReference(name))
                return end + 1;
        }
        addCharacter('&');
        return 1;
    }
    bool addNumericReference(std::string_view name)
    {
        if (name.size() < 2 || name.front() != '#')
            return false;
        const bool isHex = lower(name[1]) == 'x';
        const std::string_view digits = name.substr(isHex ? 2 : 1);
        std::uint32_t code = 0;
        const auto [end, error] =
            std::from_chars(digits.data(), digits.data() + digits.size(), code, isHex ? 16 : 10);
        if (error != std::errc() || digits.empty() || end != digits.data() + digits.size())
            return false;
        if (code == 0xA0 || (code < 0x80 && isBlank(static_cast<char>(code)))) {
            m_blank = true;
            return true;
        }
        separate();
        appendUtf8(m_text, code);
        return true;
    }

    std::string m_text;
    bool m_blank = false;
};

struct Tag {
    std::string name; ///< lower case, "/td" for an end tag
    std::size_t length = 0; ///< including the brackets
};

/// The tag or comment at the start of html, which starts with '<'; an empty name for a comment or
/// for a '<' that is no tag (length 0).
Tag tagAt(std::string_view html)
{
    if (startsWith(html, "<!--")) {
        const std::size_t end = html.find("-->", 4);
        return {{}, end == std::string_view::npos ? html.size() : end + 3};
    }
    std::size_t i = 1;
    Tag tag;
    if (i < html.size() && html[i] == '/')
        tag.name += html[i++];
    while (i < html.size() && !isBlank(html[i]) && html[i] != '>' && html[i] != '/')
        tag.name += lower(html[i++]);
    const bool isTag = tag.name.size() > (tag.name.starts_with('/') ? 1U : 0U);
    if (!isTag)
        return {};
    for (char quote = '\0'; i < html.size(); ++i) {
        if (quote != '\0')
            quote = html[i] == quote ? '\0' : quote;
        else if (html[i] == '"' || html[i] == '\'')
            quote = html[i];
        else if (html[i] == '>')
            return {std::move(tag.name), i + 1};
    }
    return {std::move(tag.name), html.size()};
}

/// What follows the raw text of a script or style element.
std::string_view afterRawText(std::string_view html, std::string_view endTag)
{
    for (std::size_t i = html.find('<'); i != std::string_view::npos; i = html.find('<', i + 1)) {
        if (startsWith(html.substr(i), endTag))
            return html.substr(i);
    }
    return {};
}

bool isInline(std::string_view name)
{
    if (name.starts_with('/'))
        name.remove_prefix(1);
    return name == "a" || name == "b" || name == "i" || name == "em" || name == "strong"
        || name == "span" || name == "code" || name == "tt" || name == "font" || name == "u"
        || name == "wbr";
}

/// Calls onText and onTag for the pieces of a page.
template <typename OnText, typename OnTag>
void walk(std::string_view html, OnText onText, OnTag onTag)
{
    while (!html.empty()) {
        const std::size_t next = std::min(html.find('<', html.front() == '<' ? 0 : 1), html.size());
        if (next > 0) {
            onText(html.substr(0, next));
            html.remove_prefix(next);
            continue;
        }
        const Tag tag = tagAt(html);
        if (tag.length == 0) {
            onText(html.substr(0, 1));
            html.remove_prefix(1);
            continue;
        }
        html.remove_prefix(tag.length);
        if (tag.name == "script" || tag.name == "style")
            html = afterRawText(html, "</" + tag.name);
        else if (!tag.name.empty())
            onTag(tag.name);
    }
}

/// Puts cells into rows and rows into tables, whatever end tags are missing.
class TableBuilder {
public:
    void text(std::string_view text)
    {
        if (!m_open.empty() && m_open.back().inCell)
            m_text.addText(text);
    }
    void tag(std::string_view name)
    {
        if (name == "table") {
            endCell();
            m_open.push_back({m_tables.size(), false});
            m_tables.emplace_back();
        } else if (m_open.empty()) {
            return;
        } else if (name == "/table") {
            endCell();
            m_open.pop_back();
        } else if (name == "tr") {
            endCell();
            m_tables[m_open.back().table].emplace_back();
        } else if (name == "td" || name == "th") {
            endCell();
            if (m_tables[m_open.back().table].empty())
                m_tables[m_open.back().table].emplace_back();
            m_open.back().inCell = true;
        } else if (name == "/td" || name == "/th" || name == "/tr") {
            endCell();
        } else if (!isInline(name)) {
            m_text.addBlank();
        }
    }
    [[nodiscard]] std::vector<HtmlTable> finish()
    {
        if (!m_open.empty())
            endCell();
        for (HtmlTable& table : m_tables)
            std::erase_if(table, [](const HtmlRow& row) { return row.empty(); });
        return std::move(m_tables);
    }

private:
    struct Open {
        std::size_t table;
        bool inCell;
    };
    void endCell()
    {
        if (m_open.empty() || !m_open.back().inCell)
            return;
        m_tables[m_open.back().table].back().push_back(m_text.take());
        m_open.back().inCell = false;
    }

    std::vector<HtmlTable> m_tables;
    std::vector<Open> m_open;
    TextCollector m_text;
};

} // namespace

std::vector<HtmlTable> htmlTables(std::string_view html)
{
    TableBuilder builder;
    walk(
        html, [&builder](std::string_view text) { builder.text(text); },
        [&builder](std::string_view name) { builder.tag(name); });
    return builder.finish();
}

std::string htmlText(std::string_view html)
{
    TextCollector text;
    walk(
        html, [&text](std::string_view piece) { text.addText(piece); },
        [&text](std::string_view name) {
            if (!isInline(name))
                text.addBlank();
        });
    return text.take();
}

} // namespace axiscomp::drivecomm
