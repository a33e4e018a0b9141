// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

/// Bytes that a configuration may have: for loadFile.
inline constexpr std::uint64_t maximumConfigurationSize = std::uint64_t{64} << 20;

/// A register as a configuration has it, and where its value stands.
struct TamRegister {
    std::string path; ///< with slashes
    std::string type; ///< "Int32", "SourceTable"
    std::string value;
    std::size_t line = 0; ///< from 1
    std::size_t offset = 0; ///< of the value in the text
    std::size_t size = 0; ///< bytes there
};

/// A drive in a configuration.
struct TamStation {
    std::string name; ///< may be empty
    std::optional<std::int32_t> serialNumber;
    std::vector<TamRegister> registers; ///< in their order; of repeated ones the last counts

    /// The one that counts; null: there is none.
    [[nodiscard]] const TamRegister* find(std::string_view path) const;
};

/// The stations of a TAM configuration file (.TAMcfg; XML in UTF-8: TamTopology > Stations >
/// TamStation > ... > RegisterComponent Address, Type, Value). At most 100 000 registers. Errors:
/// InvalidConfiguration with the line.
[[nodiscard]] Result<std::vector<TamStation>> readTamStations(
    std::string_view text, const std::string& fileName);

/// A configuration file, and what its stations have.
struct TamConfiguration {
    std::string fileName; ///< as errors say it
    Bytes bytes;
    std::vector<TamStation> stations;
};

/// Errors: those of loadFile and readTamStations.
[[nodiscard]] Result<TamConfiguration> loadTamConfiguration(
    const std::filesystem::path& file, const std::string& fileName);

/// "Gantry (2207)", "Gantry" when it states no serial number, "?" in place of no name.
[[nodiscard]] std::string stationName(const TamStation& station);

/// The name of a unit as drives have it ("Degree", "None"): configurations write "degree" and
/// "unspecified" too. Others stay as they are.
[[nodiscard]] std::string tamUnit(const std::string& word);

} // namespace axiscomp
