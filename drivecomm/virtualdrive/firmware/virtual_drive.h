// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/base/wall_time.h"
#include "core/drive/drive_link.h"
#include "core/drive/drive_profile.h"
#include "core/metrology/measuring_plan.h"
#include "drivecomm/virtualdrive/machine/machine_description.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace axiscomp::drivecomm {

/// One axis of a virtual drive: a slow sine over its range.
struct VirtualAxis {
    std::string name;
    std::string unit = "Millimeter"; ///< PositionUnit; a name of its own is added to the enum
    double low = 0.0; ///< position units
    double high = 100.0;
    double periodSeconds = 60.0;
    bool homed = true;
    bool saysTravel = false; ///< low and high are limits that the drive shows; 0 and 0 otherwise
};

struct VirtualDriveOptions {
    std::string name = "Virtual-1";
    std::int32_t serialNumber = 100001;
    std::vector<VirtualAxis> axes; ///< 1 to 64; empty: one with the values above
    /// Initial register values, for instance of a TAM configuration. A register that the drive does
    /// not have by itself is added with its type. Addresses are ignored: the drive gives its own.
    std::vector<RegisterReading> parameters;
    /// The machine that the drive moves, whose axes these are: `axes` counts for nothing then. Raw
    /// position and output of the compensation together are the set position.
    std::optional<MachineDescription> machine;
    /// What the machine's control visits; with machine. An axis that it does not move stands in the
    /// middle of its travel.
    std::optional<MeasuringPlan> program;
    std::chrono::nanoseconds programStart = std::chrono::seconds(10); ///< after power-on
    /// Keeps flash tables, erase counts, flash wear and saved parameters across runs; empty: not
    /// kept. Only with VirtualDrive::create.
    std::filesystem::path stateFolder;
    /// Simulated time since power-on, monotonic; the drive has no thread, it is a function of this
    /// time. Default: real time since construction.
    std::function<std::chrono::nanoseconds()> clock;
    /// For the time that passes between two runs over one state folder. Default: the system's.
    std::function<WallTime()> wallClock;
};

/// What a person can enter for a register.
struct RegisterEntry {
    bool isWritable = false;
    std::vector<std::string> names; ///< of an enum with fixed values
};

/// A drive with the behaviour of docs/drive.md ("Behaviour"): registers with addresses, RAM and
/// flash tables, commit and delete, flash wear, homing, moving axes, 10 kHz lookup, 10 ms ramp,
/// reboot. Every member function may be called from any thread. Errors carry the codes that
/// DriveLink documents.
///
/// What that leaves open, and how it is here:
/// - All signals are those of the last 100 us tick, so that sources, Output and indices that are
///   read together belong together. A written value counts as if it had been there at that tick.
/// - MasterPosition and Encoders[n]/Position are positions before compensation: a table over
///   MasterPosition does not move its own source.
/// - A ramp has a constant slope of 1 per 10 ms, also when it turns round half-way.
/// - An error of the compensation stays until Activation is written again.
/// - A signal of a compensation (Output, DimNIndex) as DimSource is a BadSource.
/// - Axes[n]/Commands/Homing/Command = Start homes an axis within a second.
/// - With a machine each axis has Machine/Axes[n]/ReferencePosition, in mm or deg. With a program
///   Machine/Program/Command = Start plays it again, from where the axis is.
/// - The same register twice in one request is refused; values take effect before commands.
class VirtualDrive {
public:
    /// profile must outlive the drive. For options without a state folder that are known to fit:
    /// what does not fit is left out.
    VirtualDrive(const DriveProfile& profile, VirtualDriveOptions options);
    ~VirtualDrive();
    /// Errors: InvalidArgument when the options do not fit the profile; FileNotReadable,
    /// FileNotWritable when the state folder is broken, another drive's, or in use by another
    /// program.
    [[nodiscard]] static Result<std::unique_ptr<VirtualDrive>> create(
        const DriveProfile& profile, VirtualDriveOptions options);

    [[nodiscard]] const DriveProfile& profile() const;
    [[nodiscard]] DriveIdentity identity() const;
    /// Up to DriveLink::maximumReads paths, read at one instant.
    [[nodiscard]] Result<std::vector<RegisterReading>> readRegisters(
        const std::vector<std::string>& paths);
    [[nodiscard]] std::vector<RegisterReading> readTree(const std::string& prefix);
    /// Up to DriveLink::maximumWrites, at one instant, all or none.
    [[nodiscard]] Result<void> writeRegisters(const std::vector<RegisterWrite>& writes);
    /// Nothing that is writable where there is no such register.
    [[nodiscard]] RegisterEntry registerEntry(const std::string& path) const;
    [[nodiscard]] std::vector<DriveFile> listFiles();
    [[nodiscard]] Result<Bytes> download(const std::string& path);
    [[nodiscard]] Result<void> upload(const std::string& path, ByteView bytes);
    void reboot();
    /// What the instrument's lines say: the reading of the machine's instrument, in mm or deg. None
    /// without a machine.
    [[nodiscard]] std::optional<double> instrumentReading();

    /// For tests and faults: the next upload stores a table with one wrong value, or the next
    /// register write a wrong value (a command is lost), whichever comes first. The answer is that
    /// of a success.
    void storeNextWrong();

private:
    struct Private;
    explicit VirtualDrive(std::unique_ptr<Private> d);
    std::unique_ptr<Private> d;
};

} // namespace axiscomp::drivecomm
