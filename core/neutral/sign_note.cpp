// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/neutral/sign_note.h"

#include "core/text/text_file.h"
#include "core/text/token_scanner.h"
#include "core/text/utf8.h"

#include <algorithm>
#include <string_view>

namespace axiscomp {

namespace {

/// What a note states of the sign; empty where it is none of these.
struct StatedSign {
    std::string_view name; ///< as the note has it
    std::optional<SignConvention> sign;
};

/// Nothing: a note of something else. A deviation, as files of measurements say, is what the drive
/// adds; their other word, correction, is the opposite of it.
std::optional<StatedSign> signInNote(std::string_view note)
{
    const auto name = statedIn(note, signKey);
    if (!name)
        return std::nullopt;
    StatedSign stated{*name, std::nullopt};
    for (const SignConvention sign : {SignConvention::Feedback, SignConvention::Command})
        if (sameLetters(*name, signName(sign)))
            stated.sign = sign;
    if (sameLetters(*name, "deviation"))
        stated.sign = SignConvention::Feedback;
    return stated;
}

/// What is wrong with a note that says no sign of a table, or another one than the rest.
Text wrongNote(std::string_view note, const StatedSign& stated)
{
    const TextPattern sentence = sameLetters(stated.name, "correction")
        ? AXISCOMP_TEXT("Error",
            "the file says \"{note}\", which is for files of measurements: a table holds "
            "reference minus encoder (sign: feedback), or what is added to the command (sign: "
            "command). Correct that line; where the values are encoder minus reference, leave it "
            "out, and turn them with --scale -1")
        : AXISCOMP_TEXT("Error",
            "the file says \"{note}\", where one comment, sign: feedback or sign: command, says "
            "what the values are: correct that line, or leave it out, which means feedback");
    return sentence.with("note", shownText(trimmed(note), 60));
}

} // namespace

std::vector<std::string> withSignNote(std::vector<std::string> notes, SignConvention sign)
{
    const bool isCommand = sign == SignConvention::Command;
    std::erase_if(notes, [isCommand](const std::string& note) {
        const auto stated = signInNote(note);
        return stated && (isCommand || stated->sign == SignConvention::Command);
    });
    if (isCommand)
        notes.push_back(std::string(signKey) + ' ' + std::string(signName(sign)));
    return notes;
}

Result<std::optional<SignConvention>> signOfTable(
    std::span<const std::string> notes, std::optional<SignConvention> stated)
{
    std::optional<StatedSign> said;
    for (const std::string& note : notes) {
        const auto next = signInNote(note);
        if (!next)
            continue;
        if (!next->sign || (said && said->sign != next->sign))
            return fail(ErrorCode::InvalidArgument, {{"reason", wrongNote(note, *next)}});
        said = next;
    }
    if (!said)
        return stated;
    if (stated && stated != said->sign)
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "the file says sign: {file}, and stated is {stated}: correct the one that is "
                    "wrong")
                    .with("file", Verbatim{std::string(said->name)})
                    .with("stated", signName(*stated))}});
    if (said->sign == SignConvention::Feedback)
        return stated;
    return std::optional(SignConvention::Command);
}

} // namespace axiscomp
