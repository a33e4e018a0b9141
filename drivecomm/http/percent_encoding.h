// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace axiscomp::drivecomm {

/// Everything but letters, digits and -._~/ as %XX.
[[nodiscard]] std::string percentEncoded(std::string_view text);

/// Undoes %XX, and + for a blank, as in a query or a form; a % that starts no such code is itself.
[[nodiscard]] std::string formDecoded(std::string_view text);

} // namespace axiscomp::drivecomm
