// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/codec/json_parsing.h"

#include <nlohmann/json.hpp>

namespace axiscomp::drivecomm {

namespace {

constexpr std::size_t quoteLength = 80;

/// Brackets outside of strings; malformed text is left to the parser.
std::size_t nestingDepth(std::string_view text)
{
    std::size_t depth = 0;
    std::size_t deepest = 0;
    bool inString = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (inString) {
            if (c == '\\')
                ++i;
            else if (c == '"')
                inString = false;
        } else if (c == '"') {
            inString = true;
        } else if (c == '[' || c == '{') {
            deepest = std::max(deepest, ++depth);
        } else if ((c == ']' || c == '}') && depth > 0) {
            --depth;
        }
    }
    return deepest;
}

} // namespace

Text quoteOf(std::string_view text)
{
    std::string shown;
    bool blank = false;
    std::size_t i = 0;
    for (; i < text.size() && shown.size() < quoteLength; ++i) {
        const char c = text[i];
        if (c == ' ' || c == '\n' || c == '\r' || c == '\t') {
            blank = !shown.empty();
            continue;
        }
        if (blank)
            shown += ' ';
        blank = false;
        shown += c > ' ' && c < '\x7f' ? c : '.';
    }
    if (text.empty())
        return AXISCOMP_TEXT("Error", "nothing");
    return Verbatim{'"' + shown + (i < text.size() ? "...\"" : "\"")};
}

tl::unexpected<Error> notExpected(Text expected, std::string_view text)
{
    return fail(ErrorCode::Protocol, {{"expected", std::move(expected)}, {"quote", quoteOf(text)}});
}

nlohmann::json parseJson(std::string_view text, std::size_t maximumDepth)
{
    if (nestingDepth(text) > maximumDepth)
        return nlohmann::json(nlohmann::json::value_t::discarded);
    return nlohmann::json::parse(text, nullptr, false);
}

std::string jsonString(std::string_view text)
{
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

} // namespace axiscomp::drivecomm
