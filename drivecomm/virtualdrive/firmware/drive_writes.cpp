// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/firmware/drive_registers.h"
#include "drivecomm/virtualdrive/firmware/virtual_drive_p.h"

#include <algorithm>
#include <bit>

namespace axiscomp::drivecomm {

namespace {

tl::unexpected<Error> refusedWrite(Text reason)
{
    return fail(ErrorCode::DriveRejected, {{"reason", std::move(reason)}});
}

tl::unexpected<Error> compensationIsOn(Text axis, Argument what)
{
    return fail(ErrorCode::NotAllowedNow,
        {{"reason",
            AXISCOMP_TEXT(
                "Error", "the compensation of {axis} is on, so {what} must stay; deactivate it")
                .with("axis", std::move(axis))
                .with("what", std::move(what))}});
}

std::string otherName(const Register& target, const std::string& name)
{
    if (target.enumValues.empty())
        return name + '_';
    return name == target.enumValues.front() ? target.enumValues.back() : target.enumValues.front();
}

/// Another value of the same type: what a faulty drive stores instead.
RegisterValue otherValue(const Register& target, const RegisterValue& value)
{
    return std::visit(
        [&](const auto& held) -> RegisterValue {
            using Held = std::decay_t<decltype(held)>;
            if constexpr (std::is_same_v<Held, bool>)
                return !held;
            else if constexpr (std::is_same_v<Held, float> || std::is_same_v<Held, double>)
                return held == Held{0} ? Held{1} : -held;
            else if constexpr (std::is_same_v<Held, std::string>)
                return otherName(target, held);
            else
                return static_cast<Held>(held ^ Held{4});
        },
        value);
}

/// The same table with one value changed in its last bit, and a CRC that fits.
Result<Bytes> withWrongValue(const TamTable& sent, const TableLayout& layout)
{
    CompensationTable table = sent.table;
    float& value = table.values[table.values.size() / 2];
    value = std::bit_cast<float>(std::bit_cast<std::uint32_t>(value) ^ 1U);
    return encodeTamTable(table, sent.persistent, layout);
}

} // namespace

bool VirtualDrive::Private::savesParameters(const std::vector<Change>& changes)
{
    return std::ranges::any_of(changes,
        [](const Change& change) { return change.target->role == RegisterRole::SaveParameters; });
}

Result<void> VirtualDrive::Private::write(const std::vector<RegisterWrite>& writes)
{
    if (writes.empty() || writes.size() > DriveLink::maximumWrites)
        return refusedWrite(
            AXISCOMP_TEXT("Error", "a request writes 1 to {most} registers, not {count}")
                .with("most", DriveLink::maximumWrites)
                .with("count", writes.size()));
    Result<std::vector<Change>> changes = resolve(writes);
    if (!changes)
        return fail(changes.error());
    if (storeWrong)
        spoil(*changes);
    FlashMemory trial = memory;
    if (const Result<void> changed = changeTables(*changes, trial); !changed)
        return noticingWear(changed, trial);
    return takeOver(std::move(trial), *changes);
}

/// Every check that needs no flash; commands that rest are left out.
Result<std::vector<VirtualDrive::Private::Change>> VirtualDrive::Private::resolve(
    const std::vector<RegisterWrite>& writes)
{
    std::vector<Change> changes;
    std::vector<const Register*> named;
    for (const RegisterWrite& write : writes) {
        Register* target = tree.find(write.path);
        if (target == nullptr)
            return fail(ErrorCode::UnknownRegister,
                {{"path", write.path}, {"nearest", tree.nearest(write.path)}});
        if (std::ranges::find(named, target) != named.end())
            return refusedWrite(AXISCOMP_TEXT("Error", "{path} is written twice in one request")
                                    .with("path", target->path));
        named.push_back(target);
        if (target->role == RegisterRole::ReadOnly)
            return refusedWrite(
                AXISCOMP_TEXT("Error", "{path} is read-only").with("path", target->path));
        Result<RegisterValue> value = fitted(*target, write.value);
        if (!value)
            return fail(value.error());
        if (Result<void> allowed = guard(*target, *value); !allowed)
            return fail(allowed.error());
        const bool rests = target->isCommand() && !target->live && *value == target->value;
        if (!rests)
            changes.push_back({target, *std::move(value)});
    }
    std::ranges::stable_sort(changes, {}, [](const Change& change) { return change.target->role; });
    return changes;
}

Result<void> VirtualDrive::Private::guard(const Register& target, const RegisterValue& value) const
{
    const auto index = static_cast<std::size_t>(target.index);
    switch (target.role) {
    case RegisterRole::CompensationValue:
        if (axes[index].compensation.isOn(now))
            return compensationIsOn(axisName(index), target.path);
        return {};
    case RegisterRole::HomingCommand:
        if (value != target.value && axes[index].compensation.isOn(now))
            return compensationIsOn(axisName(index), AXISCOMP_TEXT("Error", "its homing"));
        return {};
    case RegisterRole::TableCommand:
        if (value == RegisterValue(profile.enums.tableCommandDelete))
            if (const auto user = userOf(index))
                return compensationIsOn(axisName(*user),
                    AXISCOMP_TEXT("Error", "the table in {slot}")
                        .with("slot", profile.tableSlots[index].name));
        return {};
    default:
        return {};
    }
}

Result<void> VirtualDrive::Private::changeTables(
    const std::vector<Change>& changes, FlashMemory& trial) const
{
    for (const auto& [target, value] : changes) {
        const auto slot = static_cast<std::size_t>(target->index);
        Result<void> result;
        if (target->role == RegisterRole::TablePersistent)
            result = trial.setPersistent(slot, std::get<bool>(value));
        else if (target->role == RegisterRole::TableCommand)
            result = value == RegisterValue(profile.enums.tableCommandDelete)
                ? trial.erase(slot, now)
                : trial.commit(slot, now);
        if (!result)
            return result;
    }
    return {};
}

/// From here on nothing can be refused but by the state folder, and that comes first.
Result<void> VirtualDrive::Private::takeOver(FlashMemory trial, const std::vector<Change>& changes)
{
    const bool used = trial.operationCount() != memory.operationCount();
    if (folder && (used || savesParameters(changes)))
        if (Result<void> saved = folder->save(snapshot(trial, changes)); !saved)
            return refusedWrite(AXISCOMP_TEXT("Error", "the drive's flash failed: {reason}")
                                    .with("reason", textOf(saved.error())));
    storeWrong = false;
    memory = std::move(trial);
    for (const Change& change : changes) {
        if (change.target->isCommand())
            act(change);
        else if (!change.target->live)
            change.target->value = change.value;
    }
    recheckEvaluating();
    return {};
}

Result<void> VirtualDrive::Private::noticingWear(
    const Result<void>& refused, const FlashMemory& trial)
{
    if (refused.error().code == ErrorCode::FlashWear)
        wornUntil = trial.availableFrom(now);
    return refused;
}

void VirtualDrive::Private::act(const Change& change)
{
    const auto index = static_cast<std::size_t>(change.target->index);
    switch (change.target->role) {
    case RegisterRole::SaveParameters:
        for (Register& one : tree)
            if (one.isParameter())
                one.saved = one.value;
        return;
    case RegisterRole::HomingCommand:
        axes[index].homing.start(now);
        return;
    case RegisterRole::ProgramCommand:
        startProgram();
        return;
    case RegisterRole::Activation: {
        const RegisterEnums& enums = profile.enums;
        Axis& axis = axes[index];
        if (change.value == RegisterValue(enums.activationDisabled))
            axis.compensation.request(Request::Disabled, Fault::None, now);
        else if (change.value == RegisterValue(enums.activationEvaluate))
            axis.compensation.request(Request::Evaluate, check(axis, false), now);
        else
            axis.compensation.request(Request::AddToEncoders, check(axis, true), now);
        return;
    }
    case RegisterRole::Reboot:
        reboot();
        return;
    default: // tables have been changed before
        return;
    }
}

void VirtualDrive::Private::reboot()
{
    memory.reboot();
    for (Register& one : tree)
        if (!one.live)
            one.value = one.isParameter() ? one.saved : one.factory;
    for (Axis& axis : axes) {
        axis.compensation.reboot();
        axis.homing.lose();
    }
}

/// One value of the request is kept wrong; when it has commands only, one of them is lost.
void VirtualDrive::Private::spoil(std::vector<Change>& changes) const
{
    if (changes.empty())
        return;
    Change& first = changes.front(); // values stand before commands
    if (!first.target->isCommand())
        first.value = otherValue(*first.target, first.value);
    else
        changes.erase(changes.begin());
}

Result<void> VirtualDrive::Private::upload(const std::string& path, ByteView bytes)
{
    const auto slot = std::ranges::find(profile.tableSlots, path, &TableSlot::file);
    if (slot == profile.tableSlots.end())
        return fail(ErrorCode::UnknownFile, {{"path", path}});
    const auto index = static_cast<std::size_t>(slot - profile.tableSlots.begin());
    if (bytes.size() > slot->maximumSize)
        return fail(ErrorCode::TooLargeForSlot,
            {{"reason",
                AXISCOMP_TEXT("Error", "{path} can have {most} bytes, not {size}")
                    .with("path", path)
                    .with("most", slot->maximumSize)
                    .with("size", bytes.size())}});
    if (const auto user = userOf(index))
        return compensationIsOn(axisName(*user), path);
    const Result<TamTable> decoded = decodeTamTable(bytes, profile.layout);
    if (!decoded)
        return fail(ErrorCode::TableRefused, {{"reason", textOf(decoded.error())}});
    Bytes kept(bytes.begin(), bytes.end());
    if (storeWrong)
        if (Result<Bytes> wrong = withWrongValue(*decoded, profile.layout))
            kept = *std::move(wrong);
    Result<std::shared_ptr<const StoredTable>> table = storedTable(std::move(kept), profile.layout);
    if (!table)
        return fail(ErrorCode::TableRefused, {{"reason", textOf(table.error())}});
    FlashMemory trial = memory;
    const Result<void> changed = trial.upload(index, *std::move(table), decoded->persistent, now);
    return changed ? takeOver(std::move(trial), {}) : noticingWear(changed, trial);
}

} // namespace axiscomp::drivecomm
