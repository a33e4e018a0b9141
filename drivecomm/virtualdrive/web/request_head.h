// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace axiscomp::drivecomm {

/// Of the request line and the header fields together.
inline constexpr std::size_t mostHeadBytes = 32 * 1024;
inline constexpr std::size_t mostHeadFields = 100;

/// Why a request is refused before anything is done with it.
struct HeadFault {
    int status; ///< of HTTP
    std::string reason;
};

/// A byte that no head has, which shows before its end has come.
[[nodiscard]] std::optional<HeadFault> illegalByte(std::string_view part);

/// head: everything up to the empty line, without it. Whatever two readers could understand in two
/// ways (RFC 9112, 11.2) is refused: folded lines, blanks around a name, more than one length, a
/// length that is no number, a coding other than chunked, a body where none belongs.
[[nodiscard]] std::optional<HeadFault> headFault(std::string_view head);

/// For a head that has mostHeadBytes and no end.
[[nodiscard]] HeadFault endlessHead(std::string_view begin);

} // namespace axiscomp::drivecomm
