// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/output/json.h"
#include "core/base/result.h"
#include "core/metrology/judge/corrections.h"
#include "core/metrology/judge/uncertainty.h"
#include "core/metrology/measurement.h"

#include <CLI/App.hpp>

#include <optional>
#include <string>
#include <vector>

namespace axiscomp::app {

class Environment;

/// Corrections of a measurement, common to all commands that work with its values.
struct CorrectionOptions {
    std::optional<double> temperature;
    std::optional<double> expansion;
    std::optional<double> referenceTemperature; ///< 20
    std::optional<double> referenceExpansion; ///< 0
    std::optional<double> datum;
    bool isNotCorrected = false;
    std::string deadPath; ///< file with its length and the air of each run

    /// --not-corrected alone asks for nothing.
    [[nodiscard]] bool asksForTemperature() const
    {
        return temperature || expansion || referenceTemperature || referenceExpansion || datum;
    }
    [[nodiscard]] bool isEmpty() const { return !asksForTemperature() && deadPath.empty(); }
};
void addCorrectionOptions(CLI::App& command, CorrectionOptions& options);

struct MadeCorrections {
    CorrectionsBefore corrections;
    std::string text; ///< a line for each, and for what was asked against the file; may be empty
    Json document = Json::object(); ///< as --json has them
};
/// What makes a second measurement comparable with a first one that was corrected like this: its
/// own temperature and air, and what the two have in common, where the options leave that open.
/// measurement: the second, as it was read. Errors: InvalidArgument for what nobody states.
[[nodiscard]] Result<CorrectionOptions> correctedLike(const CorrectionsBefore& first,
    const Measurement& measurement, CorrectionOptions options, const std::string& command);

/// "Correction: up and down exchanged", a line for each; empty without any.
[[nodiscard]] std::string correctionLines(const std::vector<Text>& corrections);
/// {"swapDirections", "invertReference", "units": [{"what", "stated", "file"}]} with what was asked
/// for.
[[nodiscard]] Json againstFileJson(const AgainstFile& asked);

/// Of what was corrected by these.
[[nodiscard]] MadeCorrections madeCorrections(
    const CorrectedMeasurement& made, const CorrectionsBefore& corrections);

/// Corrects the measurement for dead path and temperature, where the user asked for it. Errors:
/// InvalidArgument, FileNotReadable, FileTooLarge.
[[nodiscard]] Result<MadeCorrections> correct(
    Measurement& measurement, const CorrectionOptions& options, const std::string& command);

/// Limits of the figures, and how well they are known.
struct ToleranceOptions {
    std::string tolerances;
    std::string uncertainty; ///< "U=2.1um", or a file with the budget
};
/// --tolerance, --uncertainty
void addToleranceOptions(CLI::App& command, ToleranceOptions& options);

struct ToleranceLimits {
    std::vector<Tolerance> tolerances;
    std::optional<double> uncertainty; ///< U with k = 2, in mm or deg
    Json terms; ///< of the uncertainty, as --json has them; null: not stated
};
/// Warns of limits without a unit. Errors: InvalidArgument, FileNotReadable, FileTooLarge.
[[nodiscard]] Result<ToleranceLimits> readTolerances(Environment& environment,
    const Measurement& measurement, const ToleranceOptions& options, const std::string& command);

} // namespace axiscomp::app
