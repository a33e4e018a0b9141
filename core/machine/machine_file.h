// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/conversion/import_choices.h"
#include "core/drive/compensation_setup.h"
#include "core/text/diagnostic.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

/// How far the values of a drive's table may be from those of the file.
struct ValueTolerance {
    double value = 0.0; ///< >= 0
    std::string unit; ///< a length or an angle
    friend bool operator==(const ValueTolerance&, const ValueTolerance&) = default;
};

/// What one axis of a machine shall have (docs/machine-file.md).
struct MachineAxis {
    std::string axis; ///< index or name on its drive
    /// As WriteRequest has them, one for each dimension of the table; none: the axis, which shall
    /// have no table, keeps its sources.
    std::optional<std::vector<std::string>> sources;
    std::string file; ///< of the table, as written: relative to the machine file; empty: no table
    std::string column; ///< name or number from 1; empty: the only one
    ImportChoices choices; ///< format, settings, units, target, sign, direction and wrap
    Persistency persistency = Persistency::Volatile;
    std::string slot; ///< empty: chosen
    std::optional<bool> isActive; ///< none: the activation is left as it is
    std::optional<ValueTolerance> tolerance; ///< none: every bit counts
    bool acceptsLarge = false; ///< WriteRequest::acceptsLarge
    std::size_t line = 0; ///< of the file; 0: of none

    friend bool operator==(const MachineAxis&, const MachineAxis&) = default;
};

struct MachineDrive {
    std::string endpoint; ///< "http://192.168.1.20"
    std::int32_t serialNumber = 0; ///< another drive at this endpoint is refused
    std::vector<MachineAxis> axes; ///< at least one
    std::size_t line = 0;
    /// Slots that axes name which are left out of this run, and each of these: no other axis gets
    /// them, or the whole file would be impossible from then on.
    std::map<std::string, std::string> reservedSlots = {};

    friend bool operator==(const MachineDrive&, const MachineDrive&) = default;
};

/// The compensation of a whole machine as text: which drive has which tables.
struct MachineFile {
    std::string name; ///< of the machine; may be empty
    std::vector<MachineDrive> drives; ///< at least one

    friend bool operator==(const MachineFile&, const MachineFile&) = default;
};

/// Of a machine file.
inline constexpr std::uint64_t maximumMachineFile = 4ULL * 1024 * 1024; ///< bytes
inline constexpr std::size_t mostMachineDrives = 1024;
inline constexpr std::size_t mostMachineAxes = 64; ///< of one drive

struct MachineReading {
    std::optional<MachineFile> machine; ///< only without an error
    std::vector<Diagnostic> diagnostics; ///< with line and column, both from 1
    std::size_t suppressed = 0; ///< further errors
};

/// Strict: what is not known, is there twice, or contradicts something else is an error.
[[nodiscard]] MachineReading readMachine(std::string_view text);

/// Errors: FileNotReadable, FileTooLarge.
[[nodiscard]] Result<MachineReading> loadMachine(const std::filesystem::path& file);

/// InvalidConfiguration with the number of problems, for a reading without a machine.
[[nodiscard]] Error machineError(const std::string& file, const MachineReading& reading);

/// A text that is read back as the same machine, but for lines. The same machine always gives the
/// same text.
[[nodiscard]] std::string writeMachine(const MachineFile& machine);

} // namespace axiscomp
