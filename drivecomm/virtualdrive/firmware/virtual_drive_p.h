// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivecomm/virtualdrive/firmware/axis_simulation.h"
#include "drivecomm/virtualdrive/firmware/flash_memory.h"
#include "drivecomm/virtualdrive/firmware/register_tree.h"
#include "drivecomm/virtualdrive/firmware/state_folder.h"
#include "drivecomm/virtualdrive/firmware/virtual_drive.h"
#include "drivecomm/virtualdrive/machine/machine_truth.h"
#include "drivecomm/virtualdrive/machine/program_motion.h"

#include <array>
#include <mutex>

namespace axiscomp::drivecomm {

/// Everything of the drive; its functions are called with the mutex held, after advance().
struct VirtualDrive::Private {
    using Fault = CompensationState::Fault;
    using State = CompensationState::State;
    using Request = CompensationState::Request;

    struct Axis {
        AxisMotion motion;
        Homing homing;
        CompensationState compensation;
        const Register* table = nullptr; ///< null: the profile has no such register
        std::array<const Register*, 3> sources{};
        double encoder = 0.0; ///< at this tick, before compensation
    };
    /// What moves with the axes and how it is measured.
    struct Machine {
        MachineTruth truth;
        std::vector<ReversalState> reversals; ///< of each axis
        std::optional<ProgramMotion> program;
        std::size_t programAxis = 0;
        DriveTime programStart{0};
        std::uint64_t stepsBefore = 0; ///< of programs that were played before this one
    };
    struct Change {
        Register* target = nullptr;
        RegisterValue value;
    };

    Private(const DriveProfile& usedProfile, VirtualDriveOptions usedOptions);

    // drive_registers.cpp: the drive's own registers, and those of the options
    void defineRegisters();
    void defineGeneral();
    void defineAxis(int index);
    void defineAxisSignals(int index);
    void defineCompensation(int index);
    void defineApplication();
    void defineSlot(int index);
    Register* define(std::string_view pattern, const PathArguments& arguments, Register added);
    Register* defineEnum(std::string_view pattern, const PathArguments& arguments, std::string type,
        std::vector<std::string> values, RegisterRole role, int index,
        std::function<std::string()> live = {});
    /// Error: the first parameter that does not fit.
    [[nodiscard]] Result<void> applyParameters();

    // machine_loop.cpp: a machine's motion and measurement
    void beginMachine();
    void defineMachine();
    void startProgram();
    [[nodiscard]] double programSeconds(DriveTime at) const;
    /// What the position loop holds: encoder and output together.
    [[nodiscard]] double heldPosition(std::size_t axis, DriveTime at) const;
    [[nodiscard]] float motorTemperature(std::size_t axis, DriveTime at) const;
    [[nodiscard]] double referencePosition(std::size_t axis) const;
    /// When an axis may have turned, between two ticks.
    [[nodiscard]] std::vector<DriveTime> turnsBetween(DriveTime after, DriveTime until) const;
    void followMachine();

    // compensation_loop.cpp: the firmware's loop at this instant
    void advance();
    [[nodiscard]] std::optional<std::size_t> slotOf(const Axis& axis) const;
    [[nodiscard]] Fault check(const Axis& axis, bool needsHoming) const;
    [[nodiscard]] Fault checkSources(const Axis& axis, int dimensions) const;
    void settleEncoders();
    [[nodiscard]] double exactOutput(const Axis& axis) const;
    [[nodiscard]] float output(const Axis& axis) const;
    [[nodiscard]] float index(const Axis& axis, int dimension) const;
    /// The axis whose compensation is on with this slot.
    [[nodiscard]] std::optional<std::size_t> userOf(std::size_t slot) const;
    [[nodiscard]] Text axisName(std::size_t index) const; ///< "axis 0 (X)", "axis 1"
    void recheckEvaluating();

    // drive_writes.cpp: writes and uploads, all or none
    [[nodiscard]] Result<void> write(const std::vector<RegisterWrite>& writes);
    [[nodiscard]] Result<void> upload(const std::string& path, ByteView bytes);
    [[nodiscard]] Result<std::vector<Change>> resolve(const std::vector<RegisterWrite>& writes);
    [[nodiscard]] Result<void> guard(const Register& target, const RegisterValue& value) const;
    void spoil(std::vector<Change>& changes) const;
    [[nodiscard]] Result<void> changeTables(
        const std::vector<Change>& changes, FlashMemory& trial) const;
    [[nodiscard]] Result<void> noticingWear(const Result<void>& refused, const FlashMemory& trial);
    [[nodiscard]] Result<void> takeOver(FlashMemory trial, const std::vector<Change>& changes);
    void act(const Change& change);
    void reboot();

    // drive_state.cpp: the state folder
    [[nodiscard]] Result<void> openState();
    [[nodiscard]] Result<void> restore(const SavedDrive& saved);
    [[nodiscard]] static bool savesParameters(const std::vector<Change>& changes);
    [[nodiscard]] SavedDrive snapshot(
        const FlashMemory& trial, const std::vector<Change>& changes) const;

    const DriveProfile& profile;
    VirtualDriveOptions options;
    std::mutex mutex;
    DriveTime now{0};
    DriveTime tick{0}; ///< the last one at or before now
    RegisterTree tree;
    std::vector<Axis> axes;
    std::optional<Machine> machine;
    std::vector<const Register*> deviceName;
    FlashMemory memory;
    DriveTime wornUntil{DriveTime::min()}; ///< while DriveError shows FlashWear
    std::unique_ptr<StateFolder> folder;
    bool storeWrong = false;
};

} // namespace axiscomp::drivecomm
