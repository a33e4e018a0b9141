// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/axis_readings.h"
#include "core/capture/reference_lines.h"
#include "core/capture/run_file.h"

#include <functional>
#include <memory>

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
    std::optional<Error> error = {}; ///< of Lost
};

/// Takes the values of a plan from the readings of an axis and of an instrument, and keeps each in
/// a file. Changes nothing on the drive. A value counts as taken only when it is on the disk.
class CaptureRun {
public:
    /// The reference is a register of the readings until another one is set.
    CaptureRun(AxisReadings readings, RunFile file, MeasuringPlan plan, CaptureRules rules,
        DriveIdentity drive);

    /// The reference is what this says at each reading.
    void setInstrument(Instrument instrument) { m_instrument = std::move(instrument); }
    /// The reference is what type() gets.
    void setTyped(ReferenceLineReader reader);

    /// Over which connection the next reading is made: when it is another one than that of the last
    /// reading, the drive must say first that it is the same.
    void useConnection(const std::shared_ptr<const void>& connection);
    /// One reading over a link to the drive, another link than before when that was lost. now: of a
    /// clock that goes on while the computer sleeps. A drive that does not answer is news; when it
    /// is back it must be the same. Errors: OtherDrive, FileNotWritable (the value is not in the
    /// file), Cancelled, and what the drive refuses.
    [[nodiscard]] Result<CaptureNews> read(DriveLink& link,
        const std::function<std::chrono::nanoseconds()>& now, const Exchange& exchange);

    /// A position is waited for: the axis stands where a value is due.
    [[nodiscard]] bool isAsked() const { return m_isAsked; }
    /// What a person has read from the instrument. Empty: it is taken with the readings that
    /// follow, as long as the axis stands. Otherwise what is wrong with it, as TypedReference has
    /// it, or that no position is asked for.
    [[nodiscard]] Text type(std::string_view line);
    /// What was typed last is to be typed once more.
    [[nodiscard]] bool isDoubted() const { return m_typed && m_typed->isDoubted(); }

    /// Takes the last value off the file: its step is due again, see CaptureSession::takeBack.
    /// Nothing happens without a value. Errors: FileNotWritable.
    [[nodiscard]] Result<void> undo();

    [[nodiscard]] const MeasuringPlan& plan() const { return m_session.plan(); }
    [[nodiscard]] const AxisReadings& readings() const { return m_readings; }
    [[nodiscard]] const DriveIdentity& drive() const { return m_drive; }
    [[nodiscard]] const std::string& reference() const { return m_file.reference(); }
    [[nodiscard]] std::size_t taken() const { return m_file.taken(); }
    [[nodiscard]] std::span<const CapturedValue> values() const { return m_file.values(); }
    /// The last one that was taken.
    [[nodiscard]] const CapturedValue& value() const { return m_session.value(); }
    [[nodiscard]] const CaptureReading& lastReading() const { return m_reading; }
    /// What it came to, and why when nothing was taken.
    [[nodiscard]] CaptureSession::Event lastEvent() const { return m_event; }
    [[nodiscard]] const Text& lastProblem() const;
    /// Of lastReading(), how many readings are averaged so far.
    [[nodiscard]] std::size_t averaged() const { return m_session.averaged(); }
    /// The axis has not left yet where the last value was taken.
    [[nodiscard]] bool isTaken() const { return m_session.isTaken(); }
    [[nodiscard]] bool isLost() const { return m_isLost; }

private:
    [[nodiscard]] Result<CaptureNews> lost(const Error& error);
    [[nodiscard]] Result<CaptureNews> take();
    void askAgain();
    /// Nothing when the same was said of this standstill.
    [[nodiscard]] CaptureNews said(CaptureNews::Kind kind, const Text& text);

    AxisReadings m_readings;
    RunFile m_file;
    CaptureSession m_session;
    double m_window;
    DriveIdentity m_drive;
    Instrument m_instrument;
    std::optional<TypedReference> m_typed;
    CaptureReading m_reading;
    CaptureSession::Event m_event = CaptureSession::Event::Moving;
    Text m_instrumentProblem;
    const char* m_saidWords = nullptr; ///< of this standstill
    bool m_isAsked = false;
    bool m_isLost = false;
    bool m_mustIdentify = false;
    bool m_hasConnection = false;
    std::weak_ptr<const void> m_connection; ///< of the last reading
};

} // namespace axiscomp
