// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/table_layout.h"

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

/// One table file of the drive (AN140 chapter 5).
struct TableSlot {
    std::string name; ///< the value of the Table register, "Small1"
    std::string file; ///< "tables/small1.TAMtbl"
    std::uint32_t maximumSize = 0; ///< bytes, header included

    friend bool operator==(const TableSlot&, const TableSlot&) = default;
};

/// Paths of the registers that the program uses; {axis}, {slot} and {n} are placeholders.
struct RegisterPaths {
    std::string deviceName; ///< {n} = 0 .. deviceNameWords - 1, Int32, packed little-endian ASCII
    int deviceNameWords = 0;
    std::string serialNumber;
    std::string driveError;
    std::string saveParameters;
    std::string reboot;
    std::string axisName; ///< {axis}, {n} = 0 .. axisNameWords - 1
    int axisNameWords = 0;
    std::string positionUnit; ///< {axis}, as all below
    std::string positionMinimum; ///< how far the axis travels; empty: the drive does not say
    std::string positionMaximum;
    std::string table;
    std::string source; ///< {n} = 1, 2, 3
    std::string coggingTable;
    std::string activation;
    std::string state;
    std::string error;
    std::string output;
    std::string index; ///< {n} = 1, 2, 3
    std::string homingState;
    std::string tablePersistent; ///< {slot}, as all below
    std::string tableDimensions;
    std::string tableSize; ///< {n} = 0, 1, 2
    std::string tableStart;
    std::string tableDistance;
    std::string tableElements;
    std::string tableCrc;
    std::string tableCommand;
    std::string tableEraseCount;
};

/// Names of enum values in those registers.
struct RegisterEnums {
    std::string tableDisabled; ///< "Disabled"; the other values of Table are the slots' names
    std::string activationDisabled, activationEvaluate, activationAddToEncoders;
    std::string stateDisabled, stateEvaluating, stateRamping, stateActive, stateError;
    std::string errorNone;
    /// What the drive calls the reasons that this program explains; may be empty.
    std::string errorNotHomed, errorNoTable, errorDimensionMismatch, errorBadSource, errorBadTable;
    std::string homingDone;
    std::string saveParametersSave;
    std::string rebootReboot;
    std::string tableCommandCommit, tableCommandDelete;
    std::string driveErrorNone, driveErrorFlashWear;
};

/// Paths and form fields of the drive's web server (docs/profiles.md, "web").
struct WebPaths {
    std::string directory; ///< "/directory"
    std::string transfer; ///< "/transfer"
    std::string files; ///< "/files/", followed by the file path
    std::string registers; ///< "/registers", followed by "/" and a path for a single write
    std::string transferPathField; ///< "filepath"
    std::string transferFileField; ///< "file"
};

/// At most `operations` flash operations in any `window` (AN140 5.1: too many in a short time lead
/// to an error that goes away after some minutes).
struct FlashWearLimits {
    int operations = 0;
    std::chrono::seconds window{0};
    std::uint32_t ratedCycles = 0; ///< usual life of a slot, 0 = unknown
};

/// Which registers are positions of an axis; paths with {axis}. The output of a compensation is
/// added to the encoder position (AN140 1.5, 3.1): before it there is what the encoder says.
struct PositionKinds {
    std::vector<std::string> before;
    std::vector<std::string> after;
    std::vector<std::string> commanded; ///< what the sum follows
};

/// Everything that AN140 leaves open about a drive, as data. Nothing else in the program spells a
/// register path, an enum value or a URL path.
struct DriveProfile {
    std::string name; ///< "generic"
    RegisterPaths registers;
    RegisterEnums enums;
    std::vector<std::string> sourceShortlist; ///< DimSource candidates; with {axis} once per axis
    PositionKinds positionKinds;
    std::vector<std::string> temperatures; ///< registers that are one; with {axis} once per axis
    std::vector<std::string> sourceTypes; ///< types that a DimSource may have: Single, Double
    std::vector<TableSlot> tableSlots;
    TableLayout layout;
    WebPaths web;
    FlashWearLimits flashWear;
    bool writesAtOneInstant = true; ///< several registers in one request, all or none
    bool readsAtOneInstant = true;

    [[nodiscard]] const TableSlot* slotNamed(std::string_view name) const;
    [[nodiscard]] const TableSlot* slotOfFile(std::string_view file) const;
    /// Of a table that the largest slot holds.
    [[nodiscard]] std::size_t mostPoints() const;
    /// This register says where an axis is before its compensation, as far as the profile says.
    [[nodiscard]] bool isBeforeCompensation(std::string_view path) const;
    /// The output of the compensation is in this register, as far as the profile says.
    [[nodiscard]] bool isAfterCompensation(std::string_view path) const;
    /// The axis of which this register is a position; nothing: of none.
    [[nodiscard]] std::optional<int> axisOfPosition(std::string_view path) const;
    [[nodiscard]] bool isTemperature(std::string_view path) const;
};

/// Replaces {axis}, {slot}, {n} in a register path.
struct PathArguments {
    std::optional<int> axis{};
    std::string_view slot{};
    std::optional<int> n{};
};
[[nodiscard]] std::string expandPath(std::string_view pattern, const PathArguments& arguments);

/// Of Table and the DimSources of an axis, in this order: what decides which table is looked up,
/// and where.
[[nodiscard]] std::vector<std::string> axisRegisterPaths(const DriveProfile& profile, int axis);

/// Little-endian packed ASCII, as DeviceName and AxisName are kept; stops at the first zero byte.
[[nodiscard]] std::string unpackName(const std::vector<std::int32_t>& words);
[[nodiscard]] std::vector<std::int32_t> packName(std::string_view name, int words);

} // namespace axiscomp
