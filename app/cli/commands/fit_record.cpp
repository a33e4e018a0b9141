// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/fit_record.h"

#include "app/common/arguments.h"
#include "core/io/local_file.h"
#include "core/io/system.h"
#include "core/metrology/record/fit_record.h"

#include <filesystem>

namespace axiscomp::app {

Result<RecordedMeasurement> recordedMeasurement(const MeasurementInput& input,
    const MeasurementInputOptions& options, const MadeCorrections& corrections)
{
    RecordedMeasurement recorded;
    for (std::size_t n = 0; n < input.sources.size(); ++n) {
        const MeasurementSource& source = input.sources[n];
        recorded.files.push_back({source.file, source.format, source.sha256, input.files[n]});
    }
    recorded.swapsDirections = options.swapsDirections;
    if (!options.excluded.empty()) {
        AXISCOMP_TRY(recorded.exclusions, exclusionsFromText(options.excluded));
    }
    recorded.corrections.temperature = corrections.corrections.temperature;
    recorded.corrections.deadPath = corrections.corrections.deadPath;
    return recorded;
}

Result<CalibrationRecord> recordOfFit(const MeasurementInput& input,
    const MeasurementInputOptions& options, const MadeCorrections& corrections,
    const FitSettings& settings, const FitReport& report)
{
    AXISCOMP_TRY(auto before, recordedMeasurement(input, options, corrections));
    return axiscomp::recordOfFit(std::move(before), settings, report, "axiscomp " AXISCOMP_VERSION,
        std::chrono::system_clock::now());
}

Result<void> checkNewRecord(const std::string& file, const std::string& command)
{
    if (!system::stateOf(pathFromText(file)))
        return {};
    return wrongUsage(
        file + " exists already, and a record is not replaced: name another file", command);
}

} // namespace axiscomp::app
