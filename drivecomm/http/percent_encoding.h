// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace axiscomp::drivecomm {

// The small texts of HTTP.

/// Everything but letters, digits and -._~/ as %XX.
[[nodiscard]] std::string percentEncoded(std::string_view text);

/// Undoes %XX, and + for a blank, as in a query or a form; a % that starts no such code is itself.
[[nodiscard]] std::string formDecoded(std::string_view text);

/// "text/html" of "Text/HTML; charset=utf-8".
[[nodiscard]] std::string mediaType(std::string_view contentType);

/// Names of header fields and codings are the same in capital letters.
[[nodiscard]] std::string lowerCase(std::string_view text);
/// Without the blanks and tabs around it.
[[nodiscard]] std::string_view withoutBlanks(std::string_view text);

} // namespace axiscomp::drivecomm
