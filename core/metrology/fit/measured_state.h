// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/metrology/measurement.h"
#include "core/table/compensation_table.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

/// Tables that may have been active while it was measured: those of a file, or the one of an axis.
struct KnownTables {
    Text name; ///< "x.csv", "the table of axis 0 (X)"
    std::vector<CompensationTable> tables; ///< consistent; positions and values in mm or deg
    std::vector<std::uint32_t> crcs; ///< of each, as a drive shows it
    /// While they were active the axis had other sources than the new table will have: their values
    /// may belong to other positions.
    bool hadOtherSources = false;
    /// What a file tells of a table beside it.
    struct Origin {
        /// As the file has its numbers, and as a drive shows it whose axis is in m or rad.
        std::vector<std::uint32_t> otherCrcs;
        bool isUnitStated = true; ///< otherwise its numbers were taken to be in mm or deg
    };
    std::vector<Origin> origins = {}; ///< of each, or none: then their units are known

    [[nodiscard]] bool has(std::uint32_t crc) const;
    /// Null: there is none with it.
    [[nodiscard]] const CompensationTable* withCrc(std::uint32_t crc) const;
    /// The index of the table that has it, in whichever unit. Nothing: there is none.
    [[nodiscard]] std::optional<std::size_t> indexWithCrc(std::uint32_t crc) const;
    [[nodiscard]] bool isUnitStated(std::size_t table) const;
};

/// That one of the tables was active, as a person says it: by the CRC on file, where it is one of
/// that table.
[[nodiscard]] MeasuredState statedTable(
    const KnownTables& known, std::size_t table, const MeasurementHeader& onFile);

/// Which of the tables is that of an axis, as a measurement or a person names it ("X", "y", "X
/// axis"): the only one of all, whatever it is of, else the only one whose target has that name.
/// Errors: InvalidArgument.
[[nodiscard]] Result<std::size_t> tableOfAxis(const KnownTables& known, std::string_view axis);

/// What is known of the drive's state, and what is asked for.
struct StateRequest {
    MeasuredState onFile; ///< as the measurement says it
    std::optional<MeasuredState> stated = {}; ///< as a person says it, where the file does not
    bool hasRawReadings = false; ///< hasRawValues of the measurement
    const KnownTables* onto = nullptr; ///< what the residuals are merged onto; null: nothing
    /// Other tables that may have been active: a file, the backups of the drive.
    std::span<const KnownTables> others = {};
    /// The axis that the table is made for, as a person states it; empty: the one that was
    /// measured.
    std::string axis = {};
    MeasuredState onSomeFiles = {}; ///< compensationOfSome of the measurement
};

/// What the drive added while it was measured.
struct FoundState {
    enum class Kind {
        Off,
        On,
        Irrelevant, ///< the raw positions are known
    };
    Kind kind = Kind::Off;
    /// With On what was active, one of those of the request; with Irrelevant what is merged onto.
    const KnownTables* active = nullptr;
    Text text; ///< "measured with the table 1c291ca3 of x.csv active"
    Text assumption; ///< what was taken for granted; empty: nothing
    std::optional<std::uint32_t> tableCrc = {}; ///< of the table that was active, where it is known
    std::string axis = {}; ///< of the request
};
[[nodiscard]] std::string_view stateName(FoundState::Kind kind); ///< "off", "on", "irrelevant"

/// Whether record and request agree, before a table is made or merged. Errors: MeasurementState,
/// with the way out: measured off and merged; measured on and not merged; measured with a table
/// that is not among those known; not on record and not stated; stated otherwise than on record.
[[nodiscard]] Result<FoundState> findState(const StateRequest& request);

} // namespace axiscomp
