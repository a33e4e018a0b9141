// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <optional>
#include <string>
#include <string_view>

namespace axiscomp::drivecomm {

/// The HTTP status of an error that the drive reports (docs/protocol.md, "Errors").
[[nodiscard]] int httpStatus(ErrorCode code);

/// What a person reads: the reason where the error has one, else the whole sentence.
[[nodiscard]] Text driveMessage(const Error& error);

/// {"error": {"code", "message", "text", "retryAfterSeconds"?, "path"?, "nearest"?}}. code is the
/// error's name, text the message as a value (text_json), path the register or file that is not
/// known, nearest those that look like it.
[[nodiscard]] std::string errorJson(const Error& error);

/// The code of that name among those that a drive can report.
[[nodiscard]] std::optional<ErrorCode> driveErrorNamed(std::string_view name);

/// What errorJson wrote, as the link's error; a code that is not known becomes DriveRejected, and
/// the message counts where there is no text that can be read.
/// nullopt when json is something else.
[[nodiscard]] std::optional<Error> parseErrorJson(std::string_view json);

} // namespace axiscomp::drivecomm
