// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

namespace axiscomp {

/// A register's value: Boolean, Int32, UInt32, Single, Double, or the name of an enum value.
using RegisterValue = std::variant<bool, std::int32_t, std::uint32_t, float, double, std::string>;

/// The number a value stands for; NaN for an enum.
[[nodiscard]] double toDouble(const RegisterValue& value);

/// "true", "12.5" (shortest exact form), "HomingDone"
[[nodiscard]] std::string toText(const RegisterValue& value);

/// Reads text as a value of a type ("Boolean", "Int32", "UInt32", "Single", "Double", any other
/// name is an enum). Errors: InvalidArgument with the reason.
[[nodiscard]] Result<RegisterValue> registerValueFromText(
    std::string_view type, std::string_view text);

/// One register as the drive answers it (docs/protocol.md, "Web server").
struct RegisterReading {
    std::string path; ///< "Axes[0]/Signals/...", slashes, no leading slash
    std::uint32_t address = 0;
    std::string type; ///< "Double", or the enum's name: "SourceTable"
    RegisterValue value;

    friend bool operator==(const RegisterReading&, const RegisterReading&) = default;
};

struct RegisterWrite {
    std::string path;
    RegisterValue value;

    friend bool operator==(const RegisterWrite&, const RegisterWrite&) = default;
};

/// Slashes for dots ("Axes[0].Signals" and "Axes[0]/Signals" are the same), no leading or trailing
/// slash.
[[nodiscard]] std::string normalisedPath(std::string_view path);

} // namespace axiscomp
