// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/base/wall_time.h"
#include "core/metrology/fit/measurement_fit.h"
#include "core/metrology/judge/corrections.h"
#include "core/metrology/judge/drift.h"
#include "core/metrology/judge/uncertainty.h"
#include "core/metrology/run_selection.h"
#include "core/table/compensation_table.h"
#include "core/table/table_identity.h"
#include "core/table/table_units.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

// The record of a compensation, a file .axcal (docs/axcal.md): what was measured, the table made of
// it, what that promised, what was written, and what a second measurement showed. Lengths are in
// mm, angles in degrees, values of tables in the table's own unit.

/// Members that this version does not know, since a later one wrote them: JSON text by JSON pointer
/// from the object that holds them. They are written back.
using OtherMembers = std::map<std::string, std::string>;

/// A measurement file as it was read, before anything was left out, exchanged or corrected.
struct RecordedFile {
    std::string file;
    std::string format; ///< "renishaw"
    std::string sha256; ///< of its bytes, 64 hexadecimal digits
    Measurement measurement;
    OtherMembers others = {};

    friend bool operator==(const RecordedFile&, const RecordedFile&) = default;
};

/// What was asked for before judging.
struct RecordedCorrections {
    std::optional<TemperatureCorrection> temperature = {};
    std::optional<DeadPathCorrection> deadPath = {};
    std::optional<DriftRemoval> drift = {}; ///< for the table alone, never for figures

    friend bool operator==(const RecordedCorrections&, const RecordedCorrections&) = default;
};

struct RecordedMeasurement {
    std::vector<RecordedFile> files; ///< at least one
    bool swapsDirections = false;
    std::vector<Exclusion> exclusions = {};
    RecordedCorrections corrections = {};
    OtherMembers others = {};

    friend bool operator==(const RecordedMeasurement&, const RecordedMeasurement&) = default;
};

/// What figures are made of: the files joined, directions exchanged, values left out, and corrected
/// for temperature and dead path. Errors: InvalidArgument for what the files do not have.
[[nodiscard]] Result<Measurement> usedMeasurement(const RecordedMeasurement& recorded);
/// The same, with what the corrections have changed. Errors: likewise.
[[nodiscard]] Result<CorrectedMeasurement> correctedMeasurement(
    const RecordedMeasurement& recorded);

/// The serial number of the drive that measured, where a file states it.
[[nodiscard]] std::optional<std::int32_t> statedDrive(const RecordedMeasurement& recorded);

inline constexpr std::size_t maximumDeadPathSize = std::size_t{1} << 20;
/// A dead path as a record has it: JSON with length, atZero, runs. Errors: InvalidArgument.
[[nodiscard]] Result<DeadPathCorrection> deadPathFromText(
    std::string_view text, const std::string& fileName);

/// How the tables were made.
struct RecordedFit {
    FitSettings settings = {};
    /// The tables that were active during the measurement, onto which residuals were merged.
    std::vector<CompensationTable> active = {};
    OtherMembers others = {};
};

struct RecordedTable {
    CompensationTable table;
    std::uint32_t crc = 0; ///< tableCrc
    OtherMembers others = {};

    friend bool operator==(const RecordedTable&, const RecordedTable&) = default;
};
/// Whether it is one table: the same values over the same positions (isSameTable of the
/// identities), in the same units. Whatever the names.
[[nodiscard]] bool isSameTable(const RecordedTable& a, const RecordedTable& b);
/// CRC-32 of the values as little-endian float32, dimension 1 fastest: what a drive shows for its
/// table, by the generic layout.
[[nodiscard]] std::uint32_t tableCrc(const CompensationTable& table);

/// What the table promised before it was written. Figures in mm or deg.
struct RecordedPrediction {
    FigureValues before;
    FigureValues predicted; ///< of the same runs, with the table
    std::optional<HeldOut> heldOut = {};
    OtherMembers others = {};
};

/// The drive and its state while it was measured.
struct RecordedDrive {
    std::string name;
    std::int32_t serialNumber = 0;
    std::string profile;
    int axis = 0; ///< its number, from 0
    std::string axisName;
    MeasuredState state = {}; ///< what it added
    OtherMembers others = {};

    friend bool operator==(const RecordedDrive&, const RecordedDrive&) = default;
};

/// That the table is on the drive.
struct RecordedWrite {
    WallTime time = {};
    std::string slot;
    bool isPersistent = false;
    std::uint32_t crc = 0;
    /// The end-to-end proof. Differences in the unit of the table.
    struct Proof {
        bool isProved = false;
        int samples = 0;
        double largestDifference = 0.0;
        double tolerance = 0.0;
        double provedShare = 0.0; ///< of the table's cells, 0 to 1

        friend bool operator==(const Proof&, const Proof&) = default;
    };
    std::optional<Proof> proof = {};
    /// Where the values lie, as the drive shows it; nothing: it does not show all of it, or an
    /// older program wrote it.
    std::optional<Grid> grid = {};
    /// In which units the drive takes the table, as symbols; nothing: it does not say, or an older
    /// program wrote it.
    std::optional<TableUnits> units = {};
    OtherMembers others = {};

    /// The table that is on the drive.
    [[nodiscard]] TableIdentity table() const { return {crc, grid}; }
    friend bool operator==(const RecordedWrite&, const RecordedWrite&) = default;
};

/// A measurement with the table active.
struct RecordedAfter {
    RecordedMeasurement measurement;
    FigureValues figures;
    std::optional<bool> isAsPredicted = {}; ///< nothing: nothing was predicted, or it is open
    /// Of the table that was active; nothing: older programs did not note it.
    std::optional<std::uint32_t> tableCrc = {};
    OtherMembers others = {};
};

/// Of the last measurement.
struct RecordedVerdict {
    std::vector<Verdict> figures;
    OtherMembers others = {};
};

/// By what figures are judged, as it was said last.
struct RecordedJudging {
    OutlierRule outlierRule = OutlierRule::PooledMad;
    std::vector<Tolerance> tolerances = {};
    std::optional<double> uncertainty = {}; ///< U with k = 2, in mm or deg
    OtherMembers others = {};
};

/// What is being worked on and is not among the rest yet.
struct RecordedDraft {
    /// The measurement as it is chosen by now, where that is not the one the table was made of.
    std::optional<RecordedMeasurement> before = {};
    std::optional<RecordedMeasurement> after = {}; ///< a second one that is not kept
    bool isTableStated = false; ///< a person says that the table was active while it was made
    OtherMembers others = {};
};

struct CalibrationRecord {
    std::string program; ///< and its version, which wrote the record: "axiscomp 1.0"
    std::optional<WallTime> time = {}; ///< when it was begun
    std::optional<RecordedMeasurement> before = {};
    std::optional<RecordedFit> fit = {};
    std::vector<RecordedTable> tables = {}; ///< one for each column
    std::optional<RecordedPrediction> prediction = {};
    std::optional<RecordedDrive> drive = {};
    std::optional<RecordedWrite> write = {};
    std::vector<RecordedAfter> after = {}; ///< in the order in which they were measured
    std::optional<RecordedVerdict> verdict = {};
    std::optional<RecordedJudging> judging = {};
    std::optional<RecordedDraft> draft = {};
    std::vector<std::string> notes = {};
    OtherMembers others = {};
};

/// The last measurement with the table of the record active: that of its write, where there was
/// one. null: none. It lives as long as the record.
[[nodiscard]] const RecordedAfter* lastAfter(const CalibrationRecord& record);

/// The tolerances and the uncertainty that hold: those of the verdict, else those that were said
/// last, else those of the fit.
[[nodiscard]] RecordedJudging judgingOf(const CalibrationRecord& record);

/// Bytes that a record may have.
inline constexpr std::uint64_t maximumRecordSize = 512ULL * 1024 * 1024;
inline constexpr int recordVersion = 1;

/// JSON, format "axiscomp-record". Numbers are exact: the shortest digits that read back. The same
/// record always gives the same text.
[[nodiscard]] std::string recordText(const CalibrationRecord& record);

/// Errors: InvalidRecord; its reason names the place of the fault ("before.files[0].sha256: ..."),
/// or both versions when a newer one is needed.
[[nodiscard]] Result<CalibrationRecord> recordFromText(
    std::string_view text, const std::string& fileName);

/// Whole or not at all. Errors: FileNotWritable.
[[nodiscard]] Result<void> saveRecord(
    const std::filesystem::path& file, const CalibrationRecord& record);
/// Errors: FileNotReadable, FileTooLarge, InvalidRecord.
[[nodiscard]] Result<CalibrationRecord> loadRecord(const std::filesystem::path& file);

} // namespace axiscomp
