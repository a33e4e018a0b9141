// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/conversion/adjustment.h"
#include "core/conversion/directions.h"
#include "core/conversion/resampling/resampling.h"
#include "core/conversion/sign_conversion.h"
#include "core/formats/table_format.h"
#include "core/neutral/lookup_note.h"
#include "core/table/table_units.h"

#include <memory>
#include <optional>
#include <variant>

namespace axiscomp {

/// Onto an even grid that keeps this deviation at the source's knots, with as few points as that
/// takes.
struct WantedDeviation {
    double deviation = 0.0; ///< in the unit of the values
    ResamplingMethod method = ResamplingMethod::Linear;
};

/// How tables of one controller become tables of another.
struct ConversionRequest {
    const TableFormat* from = nullptr;
    const TableFormat* to = nullptr;
    /// Overrules what is known of the source's format; needed where that is only assumed
    /// (FormatFacts::needsSign).
    std::optional<SignConvention> sourceSign;
    std::optional<SignConvention> targetSign; ///< likewise of the target's
    /// What the columns of each table correct (target_axis.h), one for all or one for each; empty:
    /// as the tables say.
    std::vector<std::string> targets;
    /// Of the only table, where that is one column of a file (sourcesBeside): they are converted
    /// with it where its sign is. Null: there are none.
    std::shared_ptr<const NeutralTable> beside;
    StatedUnits units; ///< of the source, in place of those that it states
    Adjustment adjustment;
    std::optional<DirectionChoice> direction; ///< merges values of two directions of motion
    bool dropsWrap = false; ///< a modulo axis becomes a linear one
    std::variant<std::monostate, ResamplingRequest, WantedDeviation> resampling;
    /// Where the drive looks its table up, the one that is read or the one that is written.
    /// Nothing: as the notes of a table of the drive say, and else at the encoder's position.
    std::optional<LookupAt> lookupAt;
    /// It is known that no reference said what the largest value says, as in WriteRequest.
    bool isComputed = false;
    /// Of the axis, in positions per second, for the steps of its velocity that are told.
    std::optional<double> speed;
    TableWriteOptions writing;
};

/// What became of one table.
struct TableConversion {
    NeutralTable source; ///< with the sign that it was taken to have
    NeutralTable result; ///< as the target's file holds it
    std::optional<ResamplingReport> resampling;
    std::vector<DirectionLoss> directionLosses; ///< of merged directions
    ConversionDifference difference; ///< source and result, each as its controller applies it
    /// The largest by the steps of the target's numbers, of each of its columns and axes in its
    /// unit, at the points of the table; empty where the file lacks one of them.
    std::vector<double> valueRounding, positionRounding;
    Text example; ///< one point in words, both conventions
    /// Where the drive has to look up the table that it gets; nothing: no table of the drive is
    /// written, or it does not matter, as for cross compensations, or nobody has said it.
    std::optional<LookupAt> lookupAt;
};

struct Conversion {
    WrittenTables written;
    std::vector<TableConversion> tables;
    std::vector<Text> remarks; ///< for the user: assumptions, losses, what to do
};

/// In this order: take the stated units, and values without a unit in that of their positions,
/// adjust the values, merge directions, resample, shift to 0 where that is asked for, convert the
/// sign, check that the target can hold it, write, and compare what the file says with the source
/// under both controllers' rules. A table of the drive that is looked up at the set position x
/// holds -c(x): there the drive moves the encoder to x + c(x), as a controller with command values
/// does (docs/formats.md). Errors: of each of these steps; InvalidArgument for a lookupAt that the
/// table contradicts, and between two tables of the drive where the first one does not say its own;
/// SignNotStated before any of them where the sign of one of two formats is assumed and the request
/// does not state it.
[[nodiscard]] Result<Conversion> convertTables(
    std::span<const NeutralTable> tables, const ConversionRequest& request);

/// A table as its own controller applies it, with what a person says of it.
struct StatedTable {
    NeutralTable table;
    std::vector<Text> remarks; ///< for the user
};

/// What convertTables does before it writes, within the format that the table comes from: no number
/// is rounded, and nothing is refused because a file could not hold it. The sign stays that of the
/// table, or the one that is stated of it, without a targetSign. Errors: those of these steps.
[[nodiscard]] Result<StatedTable> tableAsStated(
    const NeutralTable& table, ConversionRequest request);

/// The sentences of a report, in the order of interest: sign with the example, resampling,
/// directions, rounding, the largest difference, remarks.
[[nodiscard]] std::vector<Text> conversionReport(
    const Conversion& conversion, const ConversionRequest& request);

/// Those sentences of the report that are warnings: the source has what the result lacks, which
/// nobody asked for.
[[nodiscard]] std::vector<Text> conversionLosses(const Conversion& conversion);

} // namespace axiscomp
