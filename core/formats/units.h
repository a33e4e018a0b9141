// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/table_format.h"
#include "core/text/diagnostic.h"

namespace axiscomp {

/// The unit of numbers that were read without counts per unit.
inline constexpr std::string_view countsUnit = "counts";
/// Errors: InvalidArgument for settings of counts per unit that are not above 0.
[[nodiscard]] Result<void> checkCounts(const FormatFacts& facts, const FormatSettings& settings);

/// Adds a sentence that is not among the remarks yet.
void remarkOnce(std::vector<Text>& remarks, Text remark);

/// Reading a format that says no units: what the settings position-unit and value-unit say, or a
/// warning that nobody says it.
void takeUnits(NeutralTable& table, const SettingValues& settings, DiagnosticList& diagnostics);
/// The same for the positions, or the values, alone.
void takePositionUnit(
    NeutralTable& table, const SettingValues& settings, DiagnosticList& diagnostics);
void takeValueUnit(NeutralTable& table, const SettingValues& settings, DiagnosticList& diagnostics);
/// That warning, of positions and of values (UnitNotGiven).
void warnOfOpenPositionUnit(DiagnosticList& diagnostics);
void warnOfOpenValueUnit(DiagnosticList& diagnostics);

/// What is wrong with values for one of the sources in another unit than its positions, where the
/// controller adds the numbers as they stand. Nothing: there are none.
[[nodiscard]] std::optional<Diagnostic> unitContradiction(const NeutralTable& table);
/// The same for units that are stated.
[[nodiscard]] Diagnostic unitContradiction(const std::string& positions, const std::string& values);
/// Writing such a format. Errors: InvalidArgument for a unitContradiction.
[[nodiscard]] Result<void> checkOneUnit(
    const FormatFacts& facts, const std::optional<Diagnostic>& contradiction);

/// Before numbers are converted: values without a unit get that of the positions that they correct,
/// which is added to remarks; those of another axis over angles stay without. Errors:
/// InvalidArgument for values with a unit that correct positions without one, since the controller
/// adds one to the other.
[[nodiscard]] Result<NeutralTable> withUnitsOfValues(
    const NeutralTable& table, std::vector<Text>& remarks);

/// Writing a format whose lengths and angles have a fixed unit each: positions and values in these.
/// A unit that the table does not say is taken to be the fixed one, which is added to remarks
/// (once). Errors: InvalidArgument for a unit that is neither a length nor an angle.
[[nodiscard]] Result<NeutralTable> inUnits(const NeutralTable& table, std::string_view lengthUnit,
    std::string_view angleUnit, std::vector<Text>& remarks);

/// Writing a format that says no units: the settings position-unit and value-unit are what the
/// numbers shall be in; without them positions stay, and the values get the unit of the positions
/// that they correct, since the controller adds one to the other; of another axis that of the first
/// source, where it can be. The units are added to remarks. Errors: InvalidArgument for units that
/// cannot be converted.
[[nodiscard]] Result<NeutralTable> inSettingUnits(
    const NeutralTable& table, const SettingValues& settings, std::vector<Text>& remarks);

/// Before the values are put down without their unit, in that of the axis that they correct.
/// Errors: InvalidArgument where positions have several units, or another one than the values, so
/// that none is that of the axis for certain.
[[nodiscard]] Result<void> checkUnitOfAxis(const NeutralTable& table);

/// The values in the unit of the positions that they correct, as a drive takes them: of the own
/// axis, or of the first one; lengths over angles, and angles over lengths, stay. What is changed,
/// and units that nobody says, are added to remarks. Errors: InvalidArgument for values that are no
/// positions.
[[nodiscard]] Result<NeutralTable> inPositionUnits(
    const NeutralTable& table, std::vector<Text>& remarks);

} // namespace axiscomp
