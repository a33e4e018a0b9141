// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/reference_lines.h"
#include "core/capture/run_file.h"

#include <functional>

namespace axiscomp {

/// What a reading has brought.
struct CaptureNews {
    enum class Kind {
        Nothing,
        Taken, ///< value is in the file
        Refused, ///< text says why no value is taken where the axis stands; once for a standstill
        NoReference, ///< the axis stands where a value is due: text says what the instrument lacks
        Moving, ///< the axis has left where it stood
        Lost, ///< the drive does not answer, by text; it is asked again
        Stopped, ///< text says why nothing is taken any more
        Done, ///< every step of the plan has its value
    };
    Kind kind = Kind::Nothing;
    Text text = {};
    bool isBack = false; ///< the drive answers again after Lost
};

/// Takes the values of a plan from the readings of an axis and of an instrument, and keeps each in
/// a file. Changes nothing on the drive. A value counts as taken only when it is on the disk.
class CaptureRun {
public:
    /// instrument: asked at each reading; none: the reference is a register. link: of the readings.
    /// All references must outlive this.
    CaptureRun(DriveLink& link, AxisReadings readings, RunFile file, MeasuringPlan plan,
        CaptureRules rules, DriveIdentity drive);

    using Instrument = std::function<InstrumentReading(std::chrono::nanoseconds now)>;
    void setInstrument(Instrument instrument) { m_instrument = std::move(instrument); }

    /// One reading. now: of a clock that goes on while the computer sleeps. A drive that does not
    /// answer is news; when it is back it must be the same. Errors: OtherDrive, FileNotWritable
    /// (the value is not in the file), Cancelled, and what the drive refuses.
    [[nodiscard]] Result<CaptureNews> read(
        const std::function<std::chrono::nanoseconds()>& now, const Exchange& exchange);

    [[nodiscard]] const MeasuringPlan& plan() const { return m_session.plan(); }
    [[nodiscard]] std::size_t taken() const { return m_file.taken(); }
    [[nodiscard]] const CapturedValue& value() const { return m_session.value(); }
    [[nodiscard]] const CaptureReading& lastReading() const { return m_reading; }
    [[nodiscard]] bool isLost() const { return m_isLost; }

private:
    [[nodiscard]] Result<CaptureNews> lost(const Error& error);
    [[nodiscard]] Result<CaptureNews> take();
    /// Nothing when the same was said of this standstill.
    [[nodiscard]] CaptureNews said(CaptureNews::Kind kind, const Text& text);

    DriveLink& m_link;
    AxisReadings m_readings;
    RunFile m_file;
    CaptureSession m_session;
    DriveIdentity m_drive;
    Instrument m_instrument;
    CaptureReading m_reading;
    Text m_instrumentProblem;
    const char* m_saidWords = nullptr; ///< of this standstill
    bool m_isLost = false;
};

} // namespace axiscomp
