// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/output/environment.h"
#include "core/base/result.h"
#include "core/metrology/fit/lookup_frame.h"
#include "core/metrology/fit/measured_state.h"
#include "core/metrology/measurement.h"

#include <CLI/App.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace axiscomp::app {

/// What an axis of a drive says of the state in which it was measured.
struct DriveState {
    KnownTables active; ///< the table that the axis uses
    std::optional<LookupAt> lookupAt; ///< by the axis's source
    std::vector<KnownTables> backups; ///< tables that it had before, newest first
};

/// The drive of `fit --onto drive`. fit_drive.cpp; in a program that is built without drives,
/// cli/without_drives/fit_without_drive.cpp.
class FitDrive {
public:
    explicit FitDrive(const std::string& command);
    ~FitDrive();

    /// --profile, and how the drive is reached.
    void addOptions(CLI::App& command);
    [[nodiscard]] const std::string& profile() const;

    /// measurement: of that drive. stated: --lookup-at, which must agree with the axis. Errors:
    /// OtherDrive, InvalidArgument, NoTable, UnitMismatch, those of the link.
    [[nodiscard]] Result<DriveState> read(Environment& environment, const Measurement& measurement,
        std::optional<LookupAt> stated) const;

    /// Of --onto.
    [[nodiscard]] static const char* description();
    /// A line for the help page, or none.
    [[nodiscard]] static const char* example();

private:
    struct Options;
    std::unique_ptr<Options> m_options;
};

} // namespace axiscomp::app
