// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/configuration/tam_configuration.h"
#include "core/drive/drive_profile.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The compensation parameters of a drive's axes, as a TAM configuration keeps them.
namespace axiscomp {

/// Table and sources of one axis.
struct AxisParameters {
    int axis = 0;
    std::string unit; ///< as drives name it; empty: not stated
    std::string slot; ///< empty: the axis uses no table
    std::array<std::uint32_t, 3> sources{}; ///< register addresses; 0: not set
    friend bool operator==(const AxisParameters&, const AxisParameters&) = default;
};

struct CompensationParameters {
    std::string name; ///< of the drive or station
    std::optional<std::int32_t> serialNumber;
    std::vector<AxisParameters> axes; ///< those with a compensation
};

/// What a station says; axes without a Table register are left out. Errors: InvalidConfiguration
/// with the line of a value that is none.
[[nodiscard]] Result<CompensationParameters> stationParameters(
    const TamStation& station, const DriveProfile& profile, const std::string& fileName);

/// That the station is not known to be another drive than the one with this serial number. Errors:
/// OtherDrive.
[[nodiscard]] Result<void> checkStationOfDrive(
    const TamStation& station, std::optional<std::int32_t> serialNumber);

/// The station of this drive: the one that `name` names (by name or serial number), else the one
/// with the drive's serial number, else the only one if it states none. Errors:
/// InvalidArgument with the stations that there are; OtherDrive when the only station, or the named
/// one, has another serial number, unless force.
[[nodiscard]] Result<std::size_t> stationFor(std::span<const TamStation> stations,
    const std::string& fileName, std::optional<std::int32_t> serialNumber, const std::string& name,
    bool force);

/// The text with these parameters in one station's registers, everything else as it is, byte for
/// byte. Axes of the station that the parameters do not have stay as they are. Errors:
/// InvalidConfiguration when the station has no register for a value that has to be kept, or
/// another unit for an axis.
[[nodiscard]] Result<std::string> withParameters(std::string_view text, const TamStation& station,
    const CompensationParameters& parameters, const DriveProfile& profile,
    const std::string& fileName);

} // namespace axiscomp
