// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/klipper/klipper_config.h"

#include <algorithm>

namespace axiscomp::klipper {

namespace {

/// How each line of the part begins that SAVE_CONFIG writes.
constexpr std::string_view autosavePrefix = "#*#";

} // namespace

bool AutosavedPart::beginsAt(const Token& line)
{
    if (m_hasBegun || !line.text.starts_with(autosavePrefix))
        return false;
    m_hasBegun = true;
    return true;
}

Token configLine(const Token& line)
{
    if (!line.text.starts_with(autosavePrefix))
        return withoutComment(line, "#;");
    const std::size_t length = std::min<std::size_t>(autosavePrefix.size() + 1, line.text.size());
    return line.part(length);
}

std::optional<Token> sectionOf(const Token& line)
{
    const Token content = trimmedToken(line);
    const std::size_t end = content.text.find(']');
    if (!content.text.starts_with('[') || end == std::string_view::npos)
        return std::nullopt;
    return trimmedToken(content.part(1, end - 1));
}

} // namespace axiscomp::klipper
