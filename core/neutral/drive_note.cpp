// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/neutral/drive_note.h"

#include "core/text/text_file.h"
#include "core/text/token_scanner.h"
#include "core/text/utf8.h"

#include <charconv>
#include <system_error>

namespace axiscomp {

namespace {

/// Nothing: a note of something else, or without a serial number.
std::optional<std::int32_t> serialInNote(std::string_view note)
{
    const auto drive = statedIn(note, driveKey);
    return drive ? driveSerialIn(*drive) : std::nullopt;
}

} // namespace

std::optional<std::int32_t> driveSerialIn(std::string_view text)
{
    const std::size_t key = text.rfind(driveSerialKey);
    if (key == std::string_view::npos)
        return std::nullopt;
    const std::string_view digits = withoutSeparators(text.substr(key + driveSerialKey.size()));
    std::int32_t serial = 0;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), serial);
    if (read.ec != std::errc{} || read.ptr != digits.data() + digits.size())
        return std::nullopt;
    return serial;
}

std::string driveText(std::string_view name, std::int32_t serial)
{
    const std::string number = std::string(driveSerialKey) + std::to_string(serial);
    return name.empty() ? number : std::string(name) + ", " + number;
}

std::string driveNote(std::string_view drive)
{
    return std::string(driveKey) + ' ' + std::string(drive);
}

Result<std::optional<std::int32_t>> measuredDriveInNotes(std::span<const std::string> notes)
{
    std::optional<std::int32_t> said;
    for (const std::string& note : notes) {
        const auto serial = serialInNote(note);
        if (said && serial && *said != *serial)
            return fail(ErrorCode::InvalidArgument,
                {{"reason",
                    AXISCOMP_TEXT("Error",
                        "the file says \"{note}\", and another of its comments the serial number "
                        "{serial}: a table is made of the measurement of one drive, so correct "
                        "the wrong line, or leave it out")
                        .with("note", shownText(trimmed(note), 60))
                        .with("serial", Verbatim{std::to_string(*said)})}});
        said = serial ? serial : said;
    }
    return said;
}

Result<void> checkMeasuredDrive(std::optional<std::int32_t> measured, std::int32_t found)
{
    if (!measured || *measured == found)
        return {};
    return fail(ErrorCode::OtherDrive,
        {{"expected", *measured}, {"found", found}, {"measured", Verbatim{"drive"}}});
}

} // namespace axiscomp
