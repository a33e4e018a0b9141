// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/unheld_notes.h"

#include "core/neutral/drive_note.h"
#include "core/neutral/lookup_note.h"

namespace axiscomp {

Result<std::vector<Text>> unheldNotes(const FormatFacts& to, std::span<const std::string> notes)
{
    std::vector<Text> unheld;
    if (to.holdsNotes)
        return unheld;
    AXISCOMP_TRY(const auto lookupAt, lookupInNotes(notes));
    if (lookupAt)
        unheld.push_back(*lookupAt == LookupAt::Set
                ? AXISCOMP_TEXT("Error",
                    "the new file does not say that the drive has to look it up at the set "
                    "position: use it with such sources only")
                : AXISCOMP_TEXT("Error",
                    "the new file does not say that the drive has to look it up at the encoder "
                    "position: use it with such sources only"));
    AXISCOMP_TRY(const auto measured, measuredDriveInNotes(notes));
    if (measured)
        unheld.push_back(AXISCOMP_TEXT("Error",
            "the new file does not say that the drive with the serial number {serial} was "
            "measured, as its source does: use it for that drive only")
                             .with("serial", Verbatim{std::to_string(*measured)}));
    return unheld;
}

} // namespace axiscomp
