// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/capture_request.h"

#include <memory>
#include <string>
#include <string_view>

namespace axiscomp::drivecomm {

/// A measuring instrument that says its position in lines over a serial port, 8N1. A port that is
/// gone is opened again. Used on one thread; a QCoreApplication must exist.
class SerialInstrument {
public:
    /// endpoint: "serial:/dev/ttyUSB1?baud=9600". request: sent before each reading, with `\r`,
    /// `\n` and `\t` for these characters, and with both line ends where it has none; empty: the
    /// instrument sends by itself. Opens the port. Errors: InvalidEndpoint, InvalidArgument,
    /// NotConnected.
    [[nodiscard]] static Result<std::unique_ptr<SerialInstrument>> open(
        const std::string& endpoint, std::string_view request, ReferenceLines lines);
    ~SerialInstrument();

    /// What has come until now, of a clock that never goes back. Does not wait for an answer: a
    /// request is answered before the next reading.
    [[nodiscard]] InstrumentReading at(std::chrono::nanoseconds now);

private:
    struct Private;
    explicit SerialInstrument(std::unique_ptr<Private> d);
    std::unique_ptr<Private> d;
};

/// The same with the lines read by a pattern and a scale, for a capture. dwell: as of CaptureRules.
/// Errors: those of SerialInstrument::open, numberPattern and ReferenceLineReader::make.
[[nodiscard]] Result<Instrument> openSerialInstrument(const SerialInstrumentRequest& request,
    const ReferenceScale& scale, bool isAngular, std::chrono::nanoseconds dwell);

} // namespace axiscomp::drivecomm
