// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/firmware/drive_registers.h"

#include "drivecomm/virtualdrive/firmware/virtual_drive_p.h"

#include <algorithm>

namespace axiscomp::drivecomm {

namespace {

std::vector<std::string> unitNames(const std::string& own)
{
    std::vector<std::string> names{"None", "Meter", "Millimeter", "Radian", "Degree"};
    if (std::ranges::find(names, own) == names.end())
        names.push_back(own);
    return names;
}

std::string faultName(CompensationState::Fault fault, const RegisterEnums& enums)
{
    // A profile may leave these out.
    const auto word = [](const std::string& known, const char* own) {
        return known.empty() ? std::string(own) : known;
    };
    using enum CompensationState::Fault;
    switch (fault) {
    case None:
        return enums.errorNone;
    case NotHomed:
        return word(enums.errorNotHomed, "NotHomed");
    case NoTable:
        return word(enums.errorNoTable, "NoTable");
    case DimensionMismatch:
        return word(enums.errorDimensionMismatch, "DimensionMismatch");
    case BadSource:
        return word(enums.errorBadSource, "BadSource");
    case BadTable:
        return word(enums.errorBadTable, "BadTable");
    }
    return {};
}

std::string stateName(CompensationState::State state, const RegisterEnums& enums)
{
    using enum CompensationState::State;
    switch (state) {
    case Disabled:
        return enums.stateDisabled;
    case Evaluating:
        return enums.stateEvaluating;
    case Ramping:
        return enums.stateRamping;
    case Active:
        return enums.stateActive;
    case Error:
        return enums.stateError;
    }
    return {};
}

std::string requestName(CompensationState::Request request, const RegisterEnums& enums)
{
    using enum CompensationState::Request;
    switch (request) {
    case Disabled:
        return enums.activationDisabled;
    case Evaluate:
        return enums.activationEvaluate;
    case AddToEncoders:
        return enums.activationAddToEncoders;
    }
    return {};
}

std::string homingName(Homing::State state, const RegisterEnums& enums)
{
    using enum Homing::State;
    switch (state) {
    case NotHomed:
        return "NotHomed";
    case Homing:
        return "Homing";
    case Done:
        return enums.homingDone;
    }
    return {};
}

} // namespace

/// Null when the profile does not have the register.
Register* VirtualDrive::Private::define(
    std::string_view pattern, const PathArguments& arguments, Register added)
{
    if (pattern.empty())
        return nullptr;
    added.path = normalisedPath(expandPath(pattern, arguments));
    return &tree.add(std::move(added));
}

Register* VirtualDrive::Private::defineEnum(std::string_view pattern,
    const PathArguments& arguments, std::string type, std::vector<std::string> values,
    RegisterRole role, int index, std::function<std::string()> live)
{
    Register added{.path = {}, .type = std::move(type), .value = values.front()};
    added.role = role;
    added.index = index;
    added.enumValues = std::move(values);
    if (live)
        added.live = [live = std::move(live)] { return RegisterValue(live()); };
    return define(pattern, arguments, std::move(added));
}

void VirtualDrive::Private::defineRegisters()
{
    defineGeneral();
    for (std::size_t i = 0; i < axes.size(); ++i)
        defineAxis(static_cast<int>(i));
    defineApplication();
    for (std::size_t i = 0; i < profile.tableSlots.size(); ++i)
        defineSlot(static_cast<int>(i));
    if (machine)
        defineMachine();
}

void VirtualDrive::Private::defineGeneral()
{
    const RegisterPaths& paths = profile.registers;
    const RegisterEnums& enums = profile.enums;
    int n = 0;
    for (const std::int32_t word : packName(options.name, paths.deviceNameWords))
        if (const Register* added = define(paths.deviceName, {.n = n++},
                {.path = {}, .type = "Int32", .value = word, .role = RegisterRole::Value}))
            deviceName.push_back(added);
    define(paths.serialNumber, {}, {.path = {}, .type = "Int32", .value = options.serialNumber});
    defineEnum(paths.driveError, {}, "DriveError",
        {enums.driveErrorNone, enums.driveErrorFlashWear}, RegisterRole::ReadOnly, 0, [this] {
            return now < wornUntil ? profile.enums.driveErrorFlashWear
                                   : profile.enums.driveErrorNone;
        });
    defineEnum(paths.saveParameters, {}, "SaveParameters",
        {std::string(registers::idle), enums.saveParametersSave}, RegisterRole::SaveParameters, 0);
    defineEnum(paths.reboot, {}, "Reboot", {std::string(registers::idle), enums.rebootReboot},
        RegisterRole::Reboot, 0);
}

void VirtualDrive::Private::defineAxis(int index)
{
    const RegisterPaths& paths = profile.registers;
    const VirtualAxis& axis = options.axes[static_cast<std::size_t>(index)];
    int n = 0;
    for (const std::int32_t word : packName(axis.name, paths.axisNameWords))
        define(paths.axisName, {.axis = index, .n = n++},
            {.path = {}, .type = "Int32", .value = word});
    if (Register* unit = defineEnum(paths.positionUnit, {.axis = index}, "PositionUnit",
            unitNames(axis.unit), RegisterRole::Value, index))
        unit->value = unit->factory = unit->saved = axis.unit;
    defineCompensation(index);
    defineAxisSignals(index);
}

void VirtualDrive::Private::defineAxisSignals(int index)
{
    const auto self = static_cast<std::size_t>(index);
    const auto position = [&](std::string_view pattern, int n, bool isIndependent, auto value) {
        define(pattern, {.axis = index, .n = n},
            {.path = {},
                .type = "Double",
                .value = 0.0,
                .live = [this, self, value] { return RegisterValue(value(axes[self], tick)); },
                .independent = isIndependent});
    };
    const auto encoder = [](const Axis& axis, DriveTime) { return axis.encoder; };
    position(registers::masterPosition, 0, true, encoder);
    position(registers::encoderPosition, 0, true, encoder);
    position(registers::encoderPosition, 1, true,
        [](const Axis& axis, DriveTime) { return axis.motion.secondEncoder(axis.encoder); });
    position(registers::setPosition, 0, true, [this, self](const Axis& axis, DriveTime at) {
        return machine ? heldPosition(self, at) : axis.motion.setPosition(at);
    });
    define(registers::motorTemperature, {.axis = index},
        {.path = {}, .type = "Single", .value = 0.0F, .live = [this, self] {
             return RegisterValue(motorTemperature(self, tick));
         }});
    const RegisterEnums& enums = profile.enums;
    defineEnum(profile.registers.homingState, {.axis = index}, "HomingState",
        {homingName(Homing::State::NotHomed, enums), homingName(Homing::State::Homing, enums),
            enums.homingDone},
        RegisterRole::ReadOnly, index,
        [this, self] { return homingName(axes[self].homing.state(now), profile.enums); });
    defineEnum(registers::homingCommand, {.axis = index}, "HomingCommand",
        {std::string(registers::idle), std::string(registers::homingStart)},
        RegisterRole::HomingCommand, index);
    // Behind the others, whose addresses state folders of earlier versions name as sources.
    position(registers::actualPosition, 0, false,
        [this, self](const Axis&, DriveTime at) { return heldPosition(self, at); });
    const VirtualAxis& axis = options.axes[self];
    for (const auto& [pattern, limit] : {std::pair(&profile.registers.positionMinimum, axis.low),
             std::pair(&profile.registers.positionMaximum, axis.high)})
        define(*pattern, {.axis = index},
            {.path = {},
                .type = "Single",
                .value = axis.saysTravel ? static_cast<float>(limit) : 0.0F,
                .role = RegisterRole::Value});
}

void VirtualDrive::Private::defineCompensation(int index)
{
    const RegisterPaths& paths = profile.registers;
    const RegisterEnums& enums = profile.enums;
    const auto self = static_cast<std::size_t>(index);
    const PathArguments here{.axis = index};
    std::vector<std::string> tables{enums.tableDisabled};
    for (const TableSlot& slot : profile.tableSlots)
        tables.push_back(slot.name);
    axes[self].table = defineEnum(
        paths.table, here, "SourceTable", tables, RegisterRole::CompensationValue, index);
    for (int n = 1; n <= 3; ++n)
        axes[self].sources.at(static_cast<std::size_t>(n - 1)) =
            define(paths.source, {.axis = index, .n = n},
                {.path = {},
                    .type = "UInt32",
                    .value = std::uint32_t{0},
                    .role = RegisterRole::CompensationValue,
                    .index = index});
    defineEnum(paths.coggingTable, here, "SourceTable", tables, RegisterRole::Value, index);
    defineEnum(paths.activation, here, "CompensationActivation",
        {enums.activationDisabled, enums.activationEvaluate, enums.activationAddToEncoders},
        RegisterRole::Activation, index,
        [this, self] { return requestName(axes[self].compensation.requested(), profile.enums); });

    std::vector<std::string> states;
    for (const State state :
        {State::Disabled, State::Evaluating, State::Ramping, State::Active, State::Error})
        states.push_back(stateName(state, enums));
    defineEnum(paths.state, here, "CompensationState", states, RegisterRole::ReadOnly, index,
        [this, self] { return stateName(axes[self].compensation.state(now), profile.enums); });
    std::vector<std::string> faults;
    for (const Fault fault : {Fault::None, Fault::NotHomed, Fault::NoTable,
             Fault::DimensionMismatch, Fault::BadSource, Fault::BadTable})
        faults.push_back(faultName(fault, enums));
    defineEnum(paths.error, here, "CompensationError", faults, RegisterRole::ReadOnly, index,
        [this, self] { return faultName(axes[self].compensation.fault(), profile.enums); });

    const auto single = [&](std::string_view pattern, int n, std::function<float()> live) {
        define(pattern, {.axis = index, .n = n},
            {.path = {},
                .type = "Single",
                .value = 0.0F,
                .live = [live = std::move(live)] { return RegisterValue(live()); },
                .independent = false});
    };
    single(paths.output, 0, [this, self] { return output(axes[self]); });
    for (int n = 1; n <= 3; ++n)
        single(paths.index, n, [this, self, n] { return this->index(axes[self], n - 1); });
}

void VirtualDrive::Private::defineApplication()
{
    for (const std::string_view pattern :
        {registers::applicationVariables, registers::applicationParameters})
        for (int n = 0; n < registers::applicationFloats; ++n)
            define(pattern, {.n = n},
                {.path = {}, .type = "Single", .value = 0.0F, .role = RegisterRole::Value});
}

void VirtualDrive::Private::defineSlot(int index)
{
    const RegisterPaths& paths = profile.registers;
    const auto self = static_cast<std::size_t>(index);
    const std::string& name = profile.tableSlots[self].name;
    define(paths.tablePersistent, {.slot = name},
        {.path = {},
            .type = "Boolean",
            .value = false,
            .role = RegisterRole::TablePersistent,
            .index = index,
            .live = [this, self] { return RegisterValue(memory.slot(self).persistent); }});
    // The view of the header: zeros for an empty slot and for a damaged table.
    const auto view = [&](std::string_view pattern, int n, std::string type,
                          const std::function<RegisterValue(const StoredTable*)>& of) {
        define(pattern, {.slot = name, .n = n},
            {.path = {}, .type = std::move(type), .value = of(nullptr), .live = [this, self, of] {
                 const auto& ram = memory.slot(self).ram;
                 return of(ram && ram->lookup ? ram.get() : nullptr);
             }});
    };
    using Table = const StoredTable*;
    view(paths.tableDimensions, 0, "UInt32", [](Table stored) {
        return static_cast<std::uint32_t>(stored ? stored->table.grid.dimensions() : 0);
    });
    for (int n = 0; n < 3; ++n) {
        const auto axisOf = [n](Table stored) -> const GridAxis* {
            return stored && n < stored->table.grid.dimensions()
                ? &stored->table.grid.axes[static_cast<std::size_t>(n)]
                : nullptr;
        };
        view(paths.tableSize, n, "UInt32", [axisOf](Table stored) {
            const GridAxis* axis = axisOf(stored);
            return axis ? axis->size : std::uint32_t{stored ? 1U : 0U};
        });
        view(paths.tableStart, n, "Double", [axisOf](Table stored) {
            const GridAxis* axis = axisOf(stored);
            return axis ? axis->start : 0.0;
        });
        view(paths.tableDistance, n, "Double", [axisOf](Table stored) {
            const GridAxis* axis = axisOf(stored);
            return axis ? axis->distance : 0.0;
        });
    }
    view(paths.tableElements, 0, "UInt32", [](Table stored) {
        return static_cast<std::uint32_t>(stored ? stored->table.values.size() : 0);
    });
    view(paths.tableCrc, 0, "UInt32", [](Table stored) { return stored ? stored->crc : 0U; });
    defineEnum(paths.tableCommand, {.slot = name}, "TableCommand",
        {std::string(registers::idle), profile.enums.tableCommandCommit,
            profile.enums.tableCommandDelete},
        RegisterRole::TableCommand, index);
    define(paths.tableEraseCount, {.slot = name},
        {.path = {}, .type = "UInt32", .value = std::uint32_t{0}, .live = [this, self] {
             return RegisterValue(memory.slot(self).eraseCount);
         }});
}

/// A file may name registers that this drive has (their value is taken, if it is one that stays),
/// and others, which are added.
Result<void> VirtualDrive::Private::applyParameters()
{
    tree.beginConfigured();
    Result<void> result;
    for (const RegisterReading& parameter : options.parameters) {
        Register* target = tree.find(parameter.path);
        if (target == nullptr) {
            const std::string path = normalisedPath(parameter.path);
            const bool signal = path.find("/Signals/") != std::string::npos
                || path.find("/Information/") != std::string::npos;
            target = &tree.add({.path = path,
                .type = parameter.type,
                .value = parameter.value,
                .role = signal ? RegisterRole::ReadOnly : RegisterRole::Value});
        }
        if (target->live || target->isCommand())
            continue;
        if (Result<RegisterValue> value = fitted(*target, parameter.value))
            target->value = target->factory = target->saved = *std::move(value);
        else if (result)
            result = fail(value.error());
    }
    return result;
}

} // namespace axiscomp::drivecomm
