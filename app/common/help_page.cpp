// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/help_page.h"

#include "app/common/arguments.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace axiscomp::app {

namespace {

constexpr std::size_t helpWidth = 100;
constexpr std::size_t helpIndent = 2;
constexpr std::size_t nameWidth = 24;

/// How the character at the beginning of valid UTF-8 is shown.
struct Character {
    std::size_t bytes = 1;
    bool isWide = false; ///< two columns, and a line may end behind it
    bool beginsSomething = false; ///< a line does not end with it
    bool endsSomething = false; ///< a line does not begin with it
};

Character characterAt(std::string_view text)
{
    const auto byte = static_cast<unsigned char>(text.front());
    const std::size_t bytes = byte < 0x80 ? 1 : byte < 0xe0 ? 2 : byte < 0xf0 ? 3 : 4;
    if (bytes != 3 || text.size() < bytes)
        return {std::min(bytes, text.size())};
    const auto at = [&](std::size_t i) { return static_cast<unsigned char>(text[i]) & 0x3fU; };
    const unsigned code = (byte & 0x0fU) << 12U | at(1) << 6U | at(2);
    // Chinese and Japanese: radicals to ideographs, compatibility ideographs, full-width forms.
    const bool isWide = (code >= 0x2e80 && code < 0xa4d0) || (code >= 0xf900 && code < 0xfb00)
        || (code >= 0xfe30 && code < 0xfe70) || (code >= 0xff00 && code < 0xff61);
    constexpr std::array<std::string_view, 18> closing{"、", "。", "，", "．", "：", "；", "！",
        "？", "）", "」", "』", "】", "》", "・", "ー", "々", "ッ", "ょ"};
    constexpr std::array<std::string_view, 5> opening{"（", "「", "『", "【", "《"};
    const auto isOneOf = [&](const auto& characters) {
        return std::ranges::find(characters, text.substr(0, bytes)) != characters.end();
    };
    return {bytes, isWide, isOneOf(opening), isOneOf(closing)};
}

/// What is not broken: a word with what follows it directly, or a wide character.
struct Piece {
    std::string_view text;
    std::size_t columns = 0;
};

Piece pieceAt(std::string_view text)
{
    Piece piece;
    std::size_t end = 0;
    while (end < text.size() && text[end] != ' ') {
        const Character character = characterAt(text.substr(end));
        if (end > 0 && character.isWide && !character.endsSomething)
            break;
        piece.columns += character.isWide ? 2 : 1;
        end += character.bytes;
        const bool isOver = character.isWide && !character.beginsSomething && end < text.size()
            && !characterAt(text.substr(end)).endsSomething;
        if (isOver)
            break;
    }
    piece.text = text.substr(0, end);
    return piece;
}

std::string helpLine(const std::string& name, const std::string& description)
{
    const std::size_t column = helpIndent + nameWidth;
    std::string line = std::string(helpIndent, ' ') + name;
    if (line.size() + 2 > column)
        line += "\n" + std::string(column, ' ');
    else
        line.resize(column, ' ');
    return line + wrapped(description, helpWidth, column) + "\n";
}

} // namespace

std::string wrapped(std::string_view text, std::size_t width, std::size_t indent)
{
    std::string result;
    std::size_t column = indent;
    bool isBehindBlank = false;
    while (!text.empty()) {
        const Piece piece = pieceAt(text);
        const std::size_t blank = isBehindBlank ? 1 : 0;
        if (column > indent && column + blank + piece.columns > width) {
            result += "\n" + std::string(indent, ' ');
            column = indent;
        } else if (column > indent && isBehindBlank) {
            result += ' ';
            ++column;
        }
        result += piece.text;
        column += piece.columns;
        text.remove_prefix(piece.text.size());
        isBehindBlank = text.starts_with(' ');
        text.remove_prefix(isBehindBlank ? 1 : 0);
    }
    return result;
}

HelpPage::HelpPage(const ProgramTexts& texts) : m_texts(texts)
{
    label("Positionals", texts.help(AXISCOMP_HELP("Help", "Arguments")));
    label("OPTIONS", texts.help(AXISCOMP_HELP("Help", "options")));
    label("SUBCOMMAND", texts.help(AXISCOMP_HELP("Help", "COMMAND")));
    label("Usage", texts.help(AXISCOMP_HELP("Help", "usage")));
}

std::string HelpPage::make_description(const CLI::App* app) const
{
    return wrapped(m_texts.help(app->get_description()), helpWidth, 0) + "\n\n";
}

std::string HelpPage::make_group(
    std::string group, bool isPositional, std::vector<const CLI::Option*> options) const
{
    return Formatter::make_group(
        isPositional ? std::move(group) : m_texts.help(group), isPositional, std::move(options));
}

std::string HelpPage::make_option(const CLI::Option* option, bool isPositional) const
{
    std::string name = make_option_name(option, isPositional);
    // "-o,--output FILE" reads better as "-o, --output FILE".
    if (const auto comma = name.find(','); comma != std::string::npos)
        name.insert(comma + 1, " ");
    if (!isPositional && !option->get_option_text().empty())
        name += " " + option->get_option_text();
    return helpLine(name, m_texts.help(option->get_description()));
}

/// The text of an argument is how it looks in the usage line, where that is not its name.
std::string HelpPage::make_option_usage(const CLI::Option* option) const
{
    if (!option->get_option_text().empty())
        return option->get_option_text();
    std::string usage = option->get_name(true);
    if (option->get_items_expected_max() > 1)
        usage += "...";
    return option->get_required() ? usage : "[" + usage + "]";
}

std::string HelpPage::make_subcommands(const CLI::App* app, CLI::AppFormatMode /*mode*/) const
{
    std::vector<std::string> groups;
    for (const CLI::App* command : app->get_subcommands({})) {
        if (std::ranges::find(groups, command->get_group()) == groups.end())
            groups.push_back(command->get_group());
    }
    std::string text;
    for (const std::string& group : groups) {
        text += "\n" + m_texts.help(group) + ":\n";
        for (const CLI::App* command : app->get_subcommands({})) {
            if (command->get_group() == group)
                text += make_subcommand(command);
        }
    }
    return text;
}

std::string HelpPage::make_subcommand(const CLI::App* command) const
{
    return helpLine(command->get_name(), m_texts.help(command->get_description()));
}

/// Its paragraphs are sentences, or a heading with lines of examples, which are typed as they are.
std::string HelpPage::make_footer(const CLI::App* app) const
{
    constexpr std::string_view gap = "\n\n";
    std::string text;
    std::string rest = app->get_footer();
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(gap), rest.size());
        const std::string paragraph = rest.substr(0, end);
        const std::size_t heading = std::min(paragraph.find('\n'), paragraph.size());
        text += text.empty() ? "" : "\n";
        text += wrapped(m_texts.help(paragraph.substr(0, heading)), helpWidth, 0)
            + paragraph.substr(heading) + "\n";
        rest.erase(0, end + gap.size());
    }
    return text;
}

} // namespace axiscomp::app
