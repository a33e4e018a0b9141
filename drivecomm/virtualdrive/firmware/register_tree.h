// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/register_value.h"

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace axiscomp::drivecomm {

/// What a write to a register does.
enum class RegisterRole {
    ReadOnly,
    Value, ///< keeps what is written
    CompensationValue, ///< Table and DimSources: as Value, not while that axis's compensation is on
    TablePersistent,
    // Commands: act when written, in this order within one request, after all values.
    TableCommand,
    SaveParameters,
    HomingCommand,
    ProgramCommand,
    Activation,
    Reboot,
};

struct Register {
    std::string path; ///< normalised
    std::string type; ///< "Double", or the enum's name
    RegisterValue value; ///< what a register without live answers
    RegisterRole role = RegisterRole::ReadOnly;
    int index = 0; ///< of the axis or the slot that the role is about
    std::vector<std::string> enumValues{}; ///< empty for an enum: any name
    std::function<RegisterValue()> live{}; ///< a signal, computed for the drive's current instant
    bool independent = true; ///< may be a DimSource: does not follow from a compensation
    std::uint32_t address = 0; ///< given by the tree
    RegisterValue factory{}; ///< after power-on, unless saved
    RegisterValue saved{}; ///< of a parameter: by the last SaveParameters

    [[nodiscard]] bool isCommand() const { return role >= RegisterRole::TableCommand; }
    /// Kept by SaveParameters.
    [[nodiscard]] bool isParameter() const;
    [[nodiscard]] RegisterValue current() const { return live ? live() : value; }
    [[nodiscard]] RegisterReading reading() const { return {path, address, type, current()}; }
};

/// The registers of a drive by path and by address. An address follows from the register's place in
/// the drive's own definition, never from a value, and is the same in every run.
class RegisterTree {
public:
    RegisterTree() = default;
    RegisterTree(const RegisterTree&) = delete;
    RegisterTree& operator=(const RegisterTree&) = delete;

    /// Adds a register, or answers the one that has this path already. References stay valid.
    Register& add(Register added);
    /// From now on, registers come from a configuration file: they get addresses apart from the
    /// drive's own, which therefore do not depend on the file.
    void beginConfigured() { m_configured = true; }

    /// path in any spelling; null when there is none.
    [[nodiscard]] Register* find(std::string_view path);
    [[nodiscard]] const Register* atAddress(std::uint32_t address) const;
    /// In the order of definition: the register itself and all below it.
    [[nodiscard]] std::vector<const Register*> under(std::string_view prefix) const;
    /// Up to three existing paths that look like this one, best first, "A, B, C".
    [[nodiscard]] std::string nearest(std::string_view path) const;

    [[nodiscard]] auto begin() { return m_registers.begin(); }
    [[nodiscard]] auto end() { return m_registers.end(); }
    [[nodiscard]] auto begin() const { return m_registers.begin(); }
    [[nodiscard]] auto end() const { return m_registers.end(); }

private:
    [[nodiscard]] std::uint32_t nextAddress(const Register& added);

    std::deque<Register> m_registers;
    std::unordered_map<std::string, Register*> m_byPath;
    std::unordered_map<std::uint32_t, const Register*> m_byAddress;
    std::map<std::uint32_t, std::uint32_t> m_used; ///< bytes used, by the block's base address
    bool m_configured = false;
};

/// The value as the register keeps it: whole numbers for Single and Double, Int32 for UInt32 in
/// range, enum names in any case. Errors: DriveRejected, the reason names the register.
[[nodiscard]] Result<RegisterValue> fitted(const Register& target, const RegisterValue& value);

} // namespace axiscomp::drivecomm
