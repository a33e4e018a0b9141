// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/register_value.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace axiscomp::drivecomm {

/// The JSON of registers (docs/protocol.md, "Web server"): {path, address, type, value}. Boolean is
/// true or false, an enum its name, a number is exact: whoever reads it as a double and converts it
/// to the register's type gets the same bits. NaN and infinity are null, null is NaN.
[[nodiscard]] std::string valueJson(const RegisterValue& value);
[[nodiscard]] std::string readingsJson(std::span<const RegisterReading> readings);
/// Errors: Protocol (expected, quote).
[[nodiscard]] Result<std::vector<RegisterReading>> parseReadings(std::string_view json);

/// [{path, value}, ...]
[[nodiscard]] std::string writesJson(std::span<const RegisterWrite> writes);

/// A value as JSON has it, before the register's type is known.
using JsonValue =
    std::variant<std::nullptr_t, bool, std::int64_t, std::uint64_t, double, std::string>;

struct RequestedWrite {
    std::string path; ///< normalised
    JsonValue value;

    friend bool operator==(const RequestedWrite&, const RequestedWrite&) = default;
};
/// The body of PUT /registers. Errors: DriveRejected with the JSON path of the fault.
[[nodiscard]] Result<std::vector<RequestedWrite>> parseWrites(std::string_view json);
/// The body of PUT /registers/<path>: {"value": v}. Errors: as above.
[[nodiscard]] Result<JsonValue> parseWrittenValue(std::string_view json);

/// nullopt when the value is not one of the type (an integer out of range, a text for a number).
[[nodiscard]] std::optional<RegisterValue> typedValue(
    std::string_view type, const JsonValue& value);

/// "12.5", "\"Small1\"": for messages.
[[nodiscard]] std::string describe(const JsonValue& value);

} // namespace axiscomp::drivecomm
