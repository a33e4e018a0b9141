// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/capture_run.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace axiscomp {

/// Where the reference comes from.
struct CaptureReference {
    enum class Kind {
        Register, ///< of the drive
        Lines, ///< of a program
        Serial, ///< an instrument on a serial port
        Typed, ///< by a person
    };
    Kind kind = Kind::Register;
    std::string source; ///< of Register, named as sources are; of Serial, its endpoint
    ReferenceScale scale;
    std::string pattern = {}; ///< that says where the number of a line is; empty: none

    /// "typed [mm], inverted, 0 at 12.5, pattern =(.*);": for the file of the values.
    [[nodiscard]] std::string text() const;
};

/// An instrument on a serial port.
struct SerialInstrumentRequest {
    std::string endpoint; ///< "serial:/dev/ttyUSB1?baud=9600"
    std::string request; ///< sent before each reading; empty: the instrument sends by itself
    std::string pattern; ///< regular expression for the number in a line; empty: the first one
};

/// dwell: as of CaptureRules.
using InstrumentFactory = std::function<Result<Instrument>(const SerialInstrumentRequest& request,
    const ReferenceScale& scale, bool isAngular, std::chrono::nanoseconds dwell)>;

/// Opens the instrument of a reference that is none of the drive's registers.
using InstrumentOpener = std::function<Result<Instrument>()>;

/// Which values are to be taken, of what, and where they are kept.
struct CaptureRequest {
    MeasuringPlan plan;
    std::filesystem::path file; ///< one that is there goes on where it ends
    CaptureReference reference;
    std::string encoder; ///< register of the raw position; empty: the profile's
    CaptureRules rules;
    InstrumentOpener openInstrument; ///< for Lines and Serial
    NumberFinder finder; ///< for Typed
};

/// Of a clock that no person sets, and that goes on while the computer sleeps.
[[nodiscard]] std::chrono::nanoseconds timeSinceStart();

/// The times of values: since 1970, read once at the beginning; setting the clock of the computer
/// meanwhile changes nothing. Times go on from the last value that there is, whatever the clock
/// says now.
class CaptureClock {
public:
    /// steady: timeSinceStart(), replaceable for tests; wall: since 1970, now.
    CaptureClock(std::span<const CapturedValue> taken, std::chrono::nanoseconds wall,
        std::function<std::chrono::nanoseconds()> steady = timeSinceStart);

    [[nodiscard]] std::chrono::nanoseconds now() const { return m_steady() + m_offset; }
    /// The clock of the computer is behind the last value.
    [[nodiscard]] bool isBehind() const { return m_isBehind; }

private:
    std::function<std::chrono::nanoseconds()> m_steady;
    std::chrono::nanoseconds m_offset{0};
    bool m_isBehind = false;
};

/// Where the axis is when the instrument says 0, in mm or deg, as the first value of a plan has it
/// when that is too large for an error of the axis: a laser is set to 0 wherever the axis stands.
[[nodiscard]] std::optional<double> proposedZero(
    const CapturedValue& first, const MeasuringPlan& plan, const ReferenceScale& scale);

/// How far neighbouring numbers of the reference register are apart at the target that is farthest
/// from zero, see AxisReadings::resolutionAt.
struct FarthestResolution {
    double target = 0.0;
    double step = 0.0; ///< in mm or deg
};
[[nodiscard]] std::optional<FarthestResolution> farthestResolution(
    const AxisReadings& readings, const MeasuringPlan& plan);

} // namespace axiscomp
