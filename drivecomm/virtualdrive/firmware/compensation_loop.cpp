// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/firmware/virtual_drive_p.h"

#include <algorithm>
#include <cmath>

namespace axiscomp::drivecomm {

namespace {

constexpr DriveTime loopPeriod = std::chrono::microseconds(100);

} // namespace

void VirtualDrive::Private::advance()
{
    const DriveTime until = std::max(now, options.clock());
    for (const DriveTime turn : turnsBetween(tick, until - until % loopPeriod)) {
        now = tick = turn;
        settleEncoders();
        followMachine();
    }
    now = until;
    tick = now - now % loopPeriod;
    settleEncoders();
    followMachine();
}

/// The position loop holds the sum of encoder and output, so that the encoder moves by the opposite
/// of the output, which depends on it and, over cross compensation, on other encoders.
void VirtualDrive::Private::settleEncoders()
{
    constexpr int mostRounds = 100; // a table whose slope is below 0.5 needs 50
    constexpr double rounding = 1e-13;
    std::vector<double> held;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        held.push_back(heldPosition(i, tick));
        axes[i].encoder = held[i];
    }
    bool isSettled = false;
    for (int round = 0; round < mostRounds && !isSettled; ++round) {
        isSettled = true;
        for (std::size_t i = 0; i < axes.size(); ++i) {
            const double encoder = held[i] - exactOutput(axes[i]);
            isSettled = isSettled
                && std::abs(encoder - axes[i].encoder) <= rounding * (1.0 + std::abs(held[i]));
            axes[i].encoder = encoder;
        }
    }
}

std::optional<std::size_t> VirtualDrive::Private::slotOf(const Axis& axis) const
{
    if (axis.table == nullptr)
        return {};
    const auto& name = std::get<std::string>(axis.table->value);
    const auto slot = std::ranges::find(profile.tableSlots, name, &TableSlot::name);
    if (slot == profile.tableSlots.end())
        return {};
    return static_cast<std::size_t>(slot - profile.tableSlots.begin());
}

CompensationState::Fault VirtualDrive::Private::check(const Axis& axis, bool needsHoming) const
{
    const std::optional<std::size_t> slot = slotOf(axis);
    if (!slot || !memory.slot(*slot).ram)
        return Fault::NoTable;
    const StoredTable& stored = *memory.slot(*slot).ram;
    if (!stored.lookup)
        return Fault::BadTable;
    if (const Fault fault = checkSources(axis, stored.lookup->dimensions()); fault != Fault::None)
        return fault;
    if (needsHoming && axis.homing.state(now) != Homing::State::Done)
        return Fault::NotHomed;
    return Fault::None;
}

CompensationState::Fault VirtualDrive::Private::checkSources(const Axis& axis, int dimensions) const
{
    const auto isSet = [](const Register* source) {
        return source != nullptr && std::get<std::uint32_t>(source->value) != 0;
    };
    const auto firstUnset = std::ranges::find_if_not(axis.sources, isSet);
    if (std::any_of(firstUnset, axis.sources.end(), isSet))
        return Fault::BadSource;
    if (firstUnset - axis.sources.begin() != dimensions)
        return Fault::DimensionMismatch;
    const bool allGood = std::all_of(axis.sources.begin(), firstUnset, [&](const Register* source) {
        const Register* target = tree.atAddress(std::get<std::uint32_t>(source->value));
        return target != nullptr && target->independent
            && std::ranges::find(profile.sourceTypes, target->type) != profile.sourceTypes.end();
    });
    return allGood ? Fault::None : Fault::BadSource;
}

float VirtualDrive::Private::output(const Axis& axis) const
{
    return static_cast<float>(exactOutput(axis));
}

double VirtualDrive::Private::exactOutput(const Axis& axis) const
{
    const double gain = axis.compensation.gain(now);
    if (!axis.compensation.isOn(now) || gain == 0.0)
        return 0.0;
    const Lookup& lookup = *memory.slot(*slotOf(axis)).ram->lookup;
    std::array<double, 3> positions{};
    const auto dimensions = static_cast<std::size_t>(lookup.dimensions());
    for (std::size_t i = 0; i < dimensions; ++i)
        positions.at(i) =
            toDouble(tree.atAddress(std::get<std::uint32_t>(axis.sources.at(i)->value))->current());
    return lookup.at(std::span(positions).first(dimensions)) * gain;
}

float VirtualDrive::Private::index(const Axis& axis, int dimension) const
{
    if (!axis.compensation.isOn(now) && axis.compensation.state(now) != State::Evaluating)
        return 0.0F;
    const Lookup& lookup = *memory.slot(*slotOf(axis)).ram->lookup;
    if (dimension >= lookup.dimensions())
        return 0.0F;
    const Register* source = axis.sources.at(static_cast<std::size_t>(dimension));
    const Register* target = tree.atAddress(std::get<std::uint32_t>(source->value));
    return static_cast<float>(lookup.index(dimension, toDouble(target->current())));
}

std::optional<std::size_t> VirtualDrive::Private::userOf(std::size_t slot) const
{
    const auto uses = [&](const Axis& axis) {
        return axis.compensation.isOn(now) && slotOf(axis) == slot;
    };
    const auto user = std::ranges::find_if(axes, uses);
    if (user == axes.end())
        return {};
    return static_cast<std::size_t>(user - axes.begin());
}

Text VirtualDrive::Private::axisName(std::size_t index) const
{
    const std::string& name = options.axes.at(index).name;
    return (name.empty() ? AXISCOMP_TEXT("Error", "axis {axis}")
                         : AXISCOMP_TEXT("Error", "axis {axis} ({name})"))
        .with("axis", index)
        .with("name", name);
}

/// What an axis in Evaluating relies on may be taken away; what one relies on whose compensation is
/// on may not.
void VirtualDrive::Private::recheckEvaluating()
{
    for (Axis& axis : axes)
        if (axis.compensation.state(now) == State::Evaluating)
            axis.compensation.setFault(check(axis, false));
}

} // namespace axiscomp::drivecomm
