// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compensator/known_tables.h"
#include "core/metrology/fit/fitted_points.h"
#include "ui/data/data_file_state.h"
#include "ui/record/record_state.h"

#include <array>
#include <filesystem>
#include <memory>
#include <stop_token>
#include <vector>

namespace axiscomp::ui {

/// What the window knows of the drive for which a table is made.
struct FitDrive {
    const DriveProfile* profile = nullptr; ///< null: the generic limits of a table
    std::filesystem::path storeRoot; ///< where backups are
    std::optional<AxisOfDrive> axis; ///< the current one; nothing: none was read
    std::optional<TableIdentity> held; ///< the table that the axis has; nothing: it has none
    std::shared_ptr<const CompensationTable> table; ///< null: it has not been downloaded yet

    /// What the source says; nothing: no axis, no source, or one that is no position.
    [[nodiscard]] std::optional<LookupAt> lookupAt() const;
    /// Nothing: no axis, or no table.
    [[nodiscard]] std::optional<HeldTable> heldTable() const;
};
/// Whether a fit for one is a fit for the other.
[[nodiscard]] bool isSameDrive(const FitDrive& a, const FitDrive& b);

struct FitRequest {
    Record record;
    std::vector<ReadMeasurement> files;
    std::shared_ptr<const Measurement> measurement; ///< of these
    FitDrive drive;
};

/// What of a fit is drawn: as much as a screen shows. Positions and values in mm or deg.
struct FitDrawing {
    std::vector<std::array<double, 2>> curve; ///< position and value of the table of one axis
    std::vector<FittedPoint> points; ///< of one axis
    std::vector<HeldOut::Residual> heldOut;
    std::vector<std::array<double, 3>> places; ///< of points of two or three axes
    std::size_t pointCount = 0; ///< that there are, of which points or places are a part
    std::size_t heldOutCount = 0;
};

/// A table that was fitted, with what is to be known of it; or why there is none.
struct FitOutcome {
    FitRequest request; ///< of which it is
    FitSettings settings; ///< that it was made with
    std::vector<KnownTables> known; ///< what report.state points into
    std::optional<FitReport> report;
    std::optional<Error> refusal; ///< with no report
    std::vector<LoadedTable> tables; ///< those of the report
    std::vector<std::uint32_t> crcs; ///< of each, as the drive shows it
    /// It is known that the largest value of a table is not what the reference said there.
    bool isComputed = false;
    std::vector<Text> remarks; ///< what is assumed of the units of other tables
    FitDrawing drawing;
};

/// Takes as long as a fit takes: not for the window's thread. Cut short by `stop`, then with the
/// refusal Cancelled.
[[nodiscard]] std::shared_ptr<const FitOutcome> fitted(
    const FitRequest& request, const std::stop_token& stop);

/// What a person reads in the file of a table of the fit, which has a report.
[[nodiscard]] std::vector<std::string> notesOf(const FitOutcome& outcome);

/// All tables of the fit, which has a report, in the order in which the tab Write lists them: the
/// wanted one first.
[[nodiscard]] MadeTables madeTables(const FitOutcome& outcome, std::size_t wanted);

/// The record that begins with the fit, which has a report: as `axiscomp fit --record` does it.
/// Copies every measurement: not for the window's thread. null: a file cannot be used.
[[nodiscard]] std::shared_ptr<const CalibrationRecord> calibrationOf(const FitOutcome& outcome);

} // namespace axiscomp::ui
