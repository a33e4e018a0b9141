// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fit/lookup_note.h"

#include "core/text/text_file.h"
#include "core/text/token_scanner.h"

#include <string_view>

namespace axiscomp {

namespace {

constexpr std::string_view lookupKey = "lookup:";

std::string_view sideName(LookupAt lookupAt)
{
    return lookupAt == LookupAt::Encoder ? "encoder" : "set";
}

} // namespace

std::string lookupNote(LookupAt lookupAt)
{
    return std::string(lookupKey) + ' ' + std::string(sideName(lookupAt));
}

std::optional<LookupAt> lookupInNotes(std::span<const std::string> notes)
{
    for (const std::string& note : notes) {
        const std::string_view text = trimmed(note);
        if (!sameLetters(text.substr(0, lookupKey.size()), lookupKey))
            continue;
        const std::string_view said = trimmed(text.substr(lookupKey.size()));
        for (const LookupAt known : {LookupAt::Encoder, LookupAt::Set})
            if (sameLetters(said, sideName(known)))
                return known;
    }
    return std::nullopt;
}

} // namespace axiscomp
