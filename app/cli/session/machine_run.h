// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/session/command_session.h"
#include "core/machine/machine_plan.h"

#include <optional>
#include <string>
#include <vector>

namespace axiscomp::app {

/// The options of the commands that work with a machine file.
struct MachineOptions {
    DriveOptions drive; ///< without endpoints
    std::string file;
    std::vector<std::string> only; ///< AXIS or SERIAL/AXIS; empty: all
    std::size_t jobs = 16; ///< drives at the same time
    bool activates = false;
    bool allowsMissing = false; ///< drives that do not answer
};

/// A drive of the file: how it differs, and what became of it.
struct MachineDriveRun : DriveLook {
    MachineDrive wanted;
    std::string endpoint; ///< without a password
    std::vector<MachineTable> tables; ///< one for each axis
    std::vector<AxisOutcome> outcomes; ///< of a plan that was carried out, one for each axis
};

struct MachineRun {
    std::string name;
    std::vector<MachineDriveRun> drives;

    [[nodiscard]] bool differs() const;
};

/// Reads the file and the tables of the axes that `only` leaves, reports their problems, and asks
/// no drive yet. Errors: FileNotReadable, FileTooLarge, InvalidConfiguration; InvalidArgument when
/// an entry of `only` names no axis; those of readMachineTable.
[[nodiscard]] Result<MachineRun> beginMachineRun(
    Environment& environment, const MachineOptions& options);

/// Plans all drives, several at the same time; changes nothing. A QtRuntime must exist.
void planMachine(Environment& environment, const MachineOptions& options, MachineRun& run);

/// Carries out what has been planned and differs, several drives at the same time; one that fails
/// holds up no other.
void applyMachine(Environment& environment, const MachineOptions& options, MachineRun& run);

} // namespace axiscomp::app
