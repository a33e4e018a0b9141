// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/drive/drive_link.h"
#include "core/drive/drive_profile.h"
#include "core/drive/operation.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

/// Readings by path.
using Readings = std::map<std::string, RegisterReading, std::less<>>;

/// A link with the profile's names and one operation's options: what all steps of an operation
/// share.
class RegisterAccess {
public:
    RegisterAccess(DriveLink& link, const DriveProfile& profile, const OperationOptions& options)
        : m_link(link)
        , m_profile(profile)
        , m_options(options)
    {
    }

    [[nodiscard]] DriveLink& link() const { return m_link; }
    [[nodiscard]] const DriveProfile& profile() const { return m_profile; }
    [[nodiscard]] const RegisterPaths& registers() const { return m_profile.registers; }
    [[nodiscard]] const RegisterEnums& enums() const { return m_profile.enums; }
    [[nodiscard]] const OperationOptions& options() const { return m_options; }

    [[nodiscard]] Exchange exchange() const;
    /// For putting things back: the user's stop must not reach it.
    [[nodiscard]] RegisterAccess withoutStop() const;
    /// For an operation that must not go on in another drive: see checkDrive().
    [[nodiscard]] RegisterAccess expecting(const DriveIdentity& drive) const;
    void report(std::string_view step, double fraction) const;
    [[nodiscard]] Result<void> checkStop() const;
    /// Waits, and ends early with Cancelled.
    [[nodiscard]] Result<void> pause(std::chrono::milliseconds duration) const;

    [[nodiscard]] std::string axisPath(
        const std::string& pattern, int axis, std::optional<int> n = {}) const;
    [[nodiscard]] std::string slotPath(
        const std::string& pattern, std::string_view slot, std::optional<int> n = {}) const;
    /// {first}, {first+1}, ... in place of {n}
    [[nodiscard]] std::vector<std::string> axisPaths(
        const std::string& pattern, int axis, int first, int count) const;

    /// Names and texts of a drive are as shownText() gives them, here and in read().
    [[nodiscard]] Result<DriveIdentity> identify() const;
    /// Asks once more who answers, where a drive is expected. Errors: OtherDrive.
    [[nodiscard]] Result<void> checkDrive() const;
    [[nodiscard]] Result<Readings> read(const std::vector<std::string>& paths) const;
    /// Registers that the drive does not have are left out.
    /// One that is named twice is read once.
    [[nodiscard]] Result<Readings> readAvailable(std::vector<std::string> paths) const;
    [[nodiscard]] Result<void> write(const std::vector<RegisterWrite>& writes) const;

private:
    DriveLink& m_link;
    const DriveProfile& m_profile;
    OperationOptions m_options;
    std::optional<std::int32_t> m_expected; ///< serial number
};

/// The request may have been carried out although it failed.
[[nodiscard]] bool isUncertain(ErrorCode code);

/// NaN or "" when the register is not among the readings.
[[nodiscard]] double numberAt(const Readings& readings, const std::string& path);
[[nodiscard]] std::string textAt(const Readings& readings, const std::string& path);
[[nodiscard]] std::uint32_t unsignedAt(const Readings& readings, const std::string& path);

} // namespace axiscomp
