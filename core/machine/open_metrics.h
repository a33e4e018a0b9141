// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/proof.h"
#include "core/base/result.h"
#include "core/compensator/drive_summary.h"
#include "core/machine/machine_plan.h"

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace axiscomp {

/// What is known of one drive at one moment.
struct DriveMetrics {
    std::string endpoint; ///< without a password
    std::optional<DriveSummary> summary; ///< none: the drive does not answer as it should
    /// By axis: from a machine file. None: it cannot be compared.
    std::map<int, std::optional<bool>> differs;
    std::vector<std::string> unfoundAxes; ///< that the machine file names and the drive has not
    std::map<int, Result<Proof>> proofs; ///< by axis: made now
};

/// Takes up how the axes compare with the machine file.
void addComparison(const DrivePlan& plan, DriveMetrics& metrics);

/// OpenMetrics 1.0 text, in which every metric is a gauge, so that collectors of the older
/// Prometheus text format read it too (docs/machine-file.md, "metrics").
[[nodiscard]] std::string openMetrics(std::span<const DriveMetrics> drives);

} // namespace axiscomp
