// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/table_format.h"

namespace axiscomp {

/// That tables of which one counts at a time do not act together in a file whose controller adds
/// those of an axis. given: what was to be written, of this format;
/// held: what the file says, perhaps with further columns of zeros. Errors: FormatCannotHold.
[[nodiscard]] Result<void> checkAddedTables(const FormatFacts& from, const FormatFacts& to,
    std::span<const NeutralTable> given, std::span<const NeutralTable> held);

/// What is to be said of tables that are added, and move the place where they are looked up, when
/// the sign of each is converted by itself.
[[nodiscard]] std::vector<Text> signRemarksOfAdded(std::span<const NeutralTable> tables);

} // namespace axiscomp
