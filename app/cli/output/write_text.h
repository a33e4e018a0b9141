// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compensator/axis_compensator.h"

#include <filesystem>
#include <optional>
#include <string>

namespace axiscomp::app {

/// Before anything is written: what is on the drive, what will be there, in which slot and why,
/// and what it costs.
[[nodiscard]] std::string planText(const WritePlan& plan, const AxisInfo& axis);

/// Where a table is looked up.
struct SignPlace {
    std::optional<LookupAt> lookupAt{}; ///< of the axis's own source
    bool isOwnPosition = true; ///< one of the sources is the position of the axis itself
    bool isComputed = false; ///< as in WritePlan: no reference said what the value would make of it
};
/// What the sign of the values means, at the largest of them: "where the encoder reads 40.0000 the
/// reference says 40.0021: the drive will add +0.0021 mm". What the encoder reads is only known of
/// a table over the axis's own position: at a temperature it says "the reference is 0.0021 mm above
/// the encoder".
[[nodiscard]] std::string signSentence(
    const CompensationTable& table, std::string_view unit, const SignPlace& at = {});

[[nodiscard]] std::string planText(const SlotDeletion& plan);

/// "1 operation; 8 operations possible now"
[[nodiscard]] std::string flashWords(int operations, const FlashBudget& budget);

/// After a table that no axis uses was deleted. driveOption: CommandSession::driveOption.
[[nodiscard]] std::string deletionText(const SlotDeletion& plan,
    const std::filesystem::path& backup, const std::string& driveOption, bool isDemo);

/// After a write: what was verified, where the old state is kept, what comes next.
[[nodiscard]] std::string reportText(
    const WriteReport& report, const std::string& driveOption, bool isDemo);

} // namespace axiscomp::app
