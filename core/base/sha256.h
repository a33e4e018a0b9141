// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bytes.h"

#include <string>

namespace axiscomp {

/// SHA-256 of FIPS 180-4, as 64 digits in lower case. It says which file a record was made of; it
/// guards no secret.
[[nodiscard]] std::string sha256Of(ByteView bytes);

} // namespace axiscomp
