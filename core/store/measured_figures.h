// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/wall_time.h"
#include "core/metrology/measurement.h"
#include "core/neutral/lookup_note.h"
#include "core/store/kept_meaning.h"
#include "core/table/table_identity.h"
#include "core/table/table_units.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace axiscomp {

/// Where a table has to be looked up to be worth what was measured.
struct MadeForLookup {
    std::optional<LookupAt> at = {}; ///< nothing: not stated
    /// What it corrects, "#1" or "other" (target_axis.h); several, where it is one of these tables.
    /// Empty: not stated.
    std::vector<std::string> targets = {};

    friend bool operator==(const MadeForLookup&, const MadeForLookup&) = default;
};

/// Whether the last measurement is one that was made just now, or one that a record has had before.
enum class Measuring { New, Known };

/// What measurements have said of an axis before and with one of its tables. In mm, or in degrees.
struct MeasuredFigures {
    struct Figure {
        std::string name; ///< "A", as figureName() has it
        std::optional<double> before = {};
        std::optional<double> predicted = {};
        std::optional<double> after = {};
        std::optional<double> tolerance = {};
        std::string result = {}; ///< "passed", as verdictName() has it; empty: no verdict

        friend bool operator==(const Figure&, const Figure&) = default;
    };
    std::uint32_t crc = 0; ///< of the table, as the drive shows it
    WallTime time{}; ///< when this was kept
    std::string date = {}; ///< of the last measurement, as its file has it; empty: it has none
    bool isAngular = false;
    std::vector<Figure> figures = {};
    /// Of the table, as the drive shows it; nothing: older programs did not note it.
    std::optional<Grid> grid = {};
    /// How many values of the measurements are left out; older programs did not note it.
    std::size_t excluded = 0;
    /// Where the last measurement covers less of the axis than the first one; older programs did
    /// not note it.
    std::optional<TwoRanges> lesserRange = {};
    MadeForLookup madeFor = {}; ///< older programs did not note it
    /// Of the table on the drive (RecordedWrite); nothing: older programs did not note them.
    std::optional<TableUnits> units = {};
    std::string axisName = {}; ///< on the drive; older programs did not note it

    [[nodiscard]] TableIdentity table() const { return {crc, grid}; }
    [[nodiscard]] KeptMeaning meaning() const { return {units.value_or(TableUnits{}), axisName}; }
    friend bool operator==(const MeasuredFigures&, const MeasuredFigures&) = default;
};

/// Whether figures of the same table are to be kept instead of those that are. What is known does
/// not give way to what is not, nor the later measurement to an earlier one: by the dates of their
/// files, else by what is new.
[[nodiscard]] bool takesPlaceOf(
    const MeasuredFigures& next, const MeasuredFigures& kept, Measuring measuring);

} // namespace axiscomp
