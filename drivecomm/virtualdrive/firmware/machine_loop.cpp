// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/firmware/drive_registers.h"
#include "drivecomm/virtualdrive/firmware/virtual_drive_p.h"

#include <algorithm>
#include <cmath>

namespace axiscomp::drivecomm {

namespace {

constexpr DriveTime machineTick = std::chrono::microseconds(100);

double secondsOf(DriveTime time)
{
    return std::chrono::duration<double>(time).count();
}

} // namespace

void VirtualDrive::Private::beginMachine()
{
    machine = Machine{MachineTruth(*options.machine), {}, {}, 0, options.programStart, 0};
    if (!options.program)
        return;
    const auto& known = options.machine->axes;
    const auto axis = std::ranges::find(known, options.program->axis, &MachineAxis::name);
    if (axis == known.end() || options.program->steps.empty())
        return; // VirtualDrive::create refuses these
    machine->programAxis = static_cast<std::size_t>(axis - known.begin());
    machine->program.emplace(*options.program, options.program->steps.front().approach);
}

void VirtualDrive::Private::defineMachine()
{
    for (std::size_t i = 0; i < axes.size(); ++i)
        define(registers::referencePosition, {.axis = static_cast<int>(i)},
            {.path = {},
                .type = "Double",
                .value = 0.0,
                .live = [this, i] { return RegisterValue(referencePosition(i)); },
                .independent = false});
    if (machine->program)
        defineEnum(registers::programCommand, {}, "ProgramCommand",
            {std::string(registers::idle), std::string(registers::programStart)},
            RegisterRole::ProgramCommand, 0);
}

/// From where the axis is.
void VirtualDrive::Private::startProgram()
{
    machine->stepsBefore +=
        static_cast<std::uint64_t>(machine->program->step(programSeconds(tick)));
    machine->program.emplace(*options.program, heldPosition(machine->programAxis, tick));
    machine->programStart = tick;
}

double VirtualDrive::Private::programSeconds(DriveTime at) const
{
    return secondsOf(at - machine->programStart);
}

double VirtualDrive::Private::heldPosition(std::size_t axis, DriveTime at) const
{
    const AxisMotion& motion = axes[axis].motion;
    if (!machine || !machine->program)
        return motion.actualPosition(at);
    return axis == machine->programAxis ? machine->program->position(programSeconds(at))
                                        : motion.middle();
}

float VirtualDrive::Private::motorTemperature(std::size_t axis, DriveTime at) const
{
    constexpr double secondsPerMinute = 60.0;
    if (machine)
        if (const auto& thermal = options.machine->axes[axis].thermal; thermal && thermal->warmUp)
            return static_cast<float>(warmedUp(*thermal->warmUp, secondsOf(at) / secondsPerMinute));
    return axes[axis].motion.motorTemperature(at);
}

double VirtualDrive::Private::referencePosition(std::size_t axis) const
{
    std::vector<double> raw;
    for (const Axis& each : axes)
        raw.push_back(each.encoder);
    const std::uint64_t approach = machine->program
        ? machine->stepsBefore
            + static_cast<std::uint64_t>(machine->program->step(programSeconds(tick)))
        : static_cast<std::uint64_t>(std::max(0.0, axes[axis].motion.turns(tick))) + 1;
    return machine->truth.reading(axis, raw,
        {machine->reversals[axis].side(), static_cast<double>(motorTemperature(axis, tick)),
            approach, static_cast<std::uint64_t>(tick / machineTick)});
}

std::vector<DriveTime> VirtualDrive::Private::turnsBetween(DriveTime after, DriveTime until) const
{
    std::vector<DriveTime> turns;
    if (!machine || until <= after)
        return turns;
    if (machine->program) {
        for (const double end :
            machine->program->movementEnds(programSeconds(after), programSeconds(until)))
            turns.push_back(machine->programStart
                + std::chrono::ceil<DriveTime>(std::chrono::duration<double>(end)));
    } else {
        // A sweep over all of the travel leaves nothing of what was before it.
        constexpr double enough = 3.0;
        for (const Axis& axis : axes) {
            const double last = axis.motion.turns(until);
            const double first = std::max(axis.motion.turns(after), last - enough) + 1.0;
            for (double n = first; n <= last; ++n)
                turns.push_back(axis.motion.turnTime(n));
        }
    }
    std::erase_if(turns, [&](DriveTime turn) { return turn <= after || turn >= until; });
    std::ranges::sort(turns);
    return turns;
}

void VirtualDrive::Private::followMachine()
{
    // None while the drive is being made.
    for (std::size_t i = 0; machine && i < machine->reversals.size(); ++i)
        machine->reversals[i].moveTo(axes[i].encoder);
}

} // namespace axiscomp::drivecomm
