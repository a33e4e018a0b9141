// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/table_format.h"

#include <span>
#include <string>
#include <vector>

namespace axiscomp {

/// What the notes of a table state, and a file of a format without notes does not: which drive was
/// measured, and where the drive looks the table up. Nothing checks it any more, so that it is for
/// the user to heed. Errors: InvalidArgument for notes that contradict each other.
[[nodiscard]] Result<std::vector<Text>> unheldNotes(
    const FormatFacts& to, std::span<const std::string> notes);

} // namespace axiscomp
