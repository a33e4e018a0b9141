// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/neutral/lookup_note.h"

#include "core/text/text_file.h"
#include "core/text/token_scanner.h"
#include "core/text/utf8.h"

#include <string_view>

namespace axiscomp {

namespace {

bool isLookupNote(std::string_view note)
{
    return statedIn(note, lookupKey).has_value();
}

} // namespace

std::string_view lookupAtName(LookupAt lookupAt)
{
    return lookupAt == LookupAt::Encoder ? "encoder" : "set";
}

std::optional<LookupAt> lookupAtNamed(std::string_view name)
{
    for (const LookupAt known : {LookupAt::Encoder, LookupAt::Set})
        if (sameLetters(name, lookupAtName(known)))
            return known;
    return std::nullopt;
}

std::string lookupNote(LookupAt lookupAt)
{
    return std::string(lookupKey) + ' ' + std::string(lookupAtName(lookupAt));
}

std::vector<std::string> withLookupNote(
    std::vector<std::string> notes, std::optional<LookupAt> lookupAt)
{
    std::erase_if(notes, isLookupNote);
    if (lookupAt)
        notes.push_back(lookupNote(*lookupAt));
    return notes;
}

Result<std::optional<LookupAt>> lookupInNotes(std::span<const std::string> notes)
{
    std::optional<LookupAt> said;
    for (const std::string& note : notes) {
        const auto name = statedIn(note, lookupKey);
        if (!name)
            continue;
        const auto side = lookupAtNamed(*name);
        if (!side || (said && side != said))
            return fail(ErrorCode::InvalidArgument,
                {{"reason",
                    AXISCOMP_TEXT("Error",
                        "the file says \"{note}\", where one comment, lookup: encoder or "
                        "lookup: set, says for which side of the compensation the table was "
                        "made: correct that line, or leave it out")
                        .with("note", shownText(trimmed(note), 60))}});
        said = side;
    }
    return said;
}

Result<std::optional<LookupAt>> lookupOfTable(
    std::span<const std::string> notes, std::optional<LookupAt> stated)
{
    AXISCOMP_TRY(const auto said, lookupInNotes(notes));
    if (said && stated && said != stated)
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "the file of the table says lookup: {file}, and stated is {stated} "
                    "(--lookup-at): correct the one that is wrong")
                    .with("file", lookupAtName(*said))
                    .with("stated", lookupAtName(*stated))}});
    return said ? said : stated;
}

} // namespace axiscomp
