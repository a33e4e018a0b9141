// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compensator/multi_axis_write.h"
#include "core/configuration/compensation_parameters.h"

#include <filesystem>
#include <vector>

/// Compensation parameters straight from a drive, and as writes to one.
namespace axiscomp {

/// What the axes of the drive have; those without compensation registers are left out. Errors:
/// those of wholeStatus.
[[nodiscard]] Result<CompensationParameters> driveParameters(AxisCompensator& compensator,
    const std::filesystem::path& storeRoot, const OperationOptions& options = {});

/// The writes that bring the drive to these parameters, without those of axes that have them
/// already. Tables stay where they are and as they are: an axis gets the one that the parameters
/// name. Nothing is changed, and nothing is switched on. Errors: AxisNotFound, NoCompensation;
/// NoTable when the drive has no table in a slot that is named; InvalidArgument when an axis has
/// another unit.
[[nodiscard]] Result<std::vector<AxisWrite>> parameterWrites(AxisCompensator& compensator,
    const DriveProfile& profile, const CompensationParameters& parameters,
    const OperationOptions& options = {});

/// The writes of parameterWrites for one station of a configuration, planned together; nothing is
/// changed. Errors: those of stationParameters, parameterWrites and planMultiAxis; OtherDrive when
/// the station has another serial number than the drive, unless force.
[[nodiscard]] Result<PlannedTables> planImport(AxisCompensator& compensator,
    const DriveProfile& profile, const TamConfiguration& configuration, std::size_t station,
    bool force, const OperationOptions& options = {});

} // namespace axiscomp
