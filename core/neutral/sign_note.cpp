// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/neutral/sign_note.h"

#include "core/text/token_scanner.h"
#include "core/text/utf8.h"

#include <algorithm>
#include <string_view>

namespace axiscomp {

namespace {

/// Other signs, such as "sign: deviation", are of files of measurements.
bool saysSign(std::string_view note, SignConvention sign)
{
    const auto name = statedIn(note, signKey);
    return name && sameLetters(*name, signName(sign));
}

} // namespace

std::vector<std::string> withSignNote(std::vector<std::string> notes, SignConvention sign)
{
    const bool isCommand = sign == SignConvention::Command;
    std::erase_if(notes, [isCommand](const std::string& note) {
        return saysSign(note, SignConvention::Command)
            || (isCommand && saysSign(note, SignConvention::Feedback));
    });
    if (isCommand)
        notes.push_back(std::string(signKey) + ' ' + std::string(signName(sign)));
    return notes;
}

Result<std::optional<SignConvention>> signOfTable(
    std::span<const std::string> notes, std::optional<SignConvention> stated)
{
    const bool isCommand = std::ranges::any_of(
        notes, [](const std::string& note) { return saysSign(note, SignConvention::Command); });
    if (!isCommand)
        return stated;
    if (stated == SignConvention::Feedback)
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "the file says sign: command, and stated is {stated}: correct the one that is "
                    "wrong")
                    .with("stated", signName(*stated))}});
    return std::optional(SignConvention::Command);
}

} // namespace axiscomp
