// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/axis_readings.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace axiscomp {

/// What an instrument says: a position, or why there is none.
struct InstrumentReading {
    double position = std::numeric_limits<double>::quiet_NaN(); ///< in mm or deg
    Text problem; ///< empty with a position
};

/// Asked at each reading; now: of the clock of the readings.
using Instrument = std::function<InstrumentReading(std::chrono::nanoseconds now)>;

/// The number in a line, as the line has it; empty: there is none.
using NumberFinder = std::function<std::string(std::string_view line)>;

/// Reads positions from lines of text such as "+517.3000042 mm": the first number of a line with a
/// decimal point, with the sign before it even where blanks are between, and the unit behind it.
/// Every kind of minus and dash is a "-", and every kind of blank a blank. Nothing is guessed: a
/// line without a unit needs the one of the scale, and one with another unit, with a comma in its
/// number, with another number right behind it (degrees, minutes and seconds, grouped digits) or
/// without a number is a problem, and so is one in which anything but a blank, a separator or the
/// unit touches the number.
class ReferenceLineReader {
public:
    /// finder: where the number is; none: it is the first. Only a number that was found by it may
    /// have a decimal comma, and what stands behind it is no unit. Errors: InvalidArgument.
    [[nodiscard]] static Result<ReferenceLineReader> make(
        ReferenceScale scale, bool isAngular, NumberFinder finder = {});

    [[nodiscard]] InstrumentReading read(std::string_view line) const;

private:
    ReferenceLineReader(ReferenceScale scale, std::string wanted, NumberFinder finder);
    /// The number and what stands round it; an empty number: there is none.
    struct Found {
        std::string before;
        std::string number;
        std::string rest;
    };
    [[nodiscard]] Found find(std::string_view said) const;
    [[nodiscard]] std::string foundByPattern(std::string_view line) const;

    ReferenceScale m_scale;
    std::string m_wanted; ///< "mm" or "deg"
    NumberFinder m_finder;
};

/// The lines of an instrument as they come. Only the newest counts, and only that one is read:
/// there may be thousands between two readings. It does not count for long: it may belong to where
/// the axis was.
class ReferenceLines {
public:
    /// dwell: as of CaptureRules; a line counts for a second at most, and no longer than this, so
    /// that what is averaged was said after the axis had come to stand.
    ReferenceLines(ReferenceLineReader reader, std::chrono::nanoseconds dwell)
        : m_reader(std::move(reader))
        , m_longestAge(std::min<std::chrono::nanoseconds>(dwell, std::chrono::seconds(1)))
    {
    }

    static constexpr std::size_t longestLine = 4096; ///< a longer one is a problem

    /// What comes next may begin within a line, as behind a port that has just been opened: nothing
    /// up to the end of that line counts, since half a number is another number.
    void beginWithinLine();
    /// bytes: what came, whole lines or not, ended by LF or CR; now: of the clock of the readings.
    void feed(std::string_view bytes, std::chrono::nanoseconds now);
    [[nodiscard]] InstrumentReading at(std::chrono::nanoseconds now) const;

private:
    void take(std::chrono::nanoseconds now);

    ReferenceLineReader m_reader;
    std::chrono::nanoseconds m_longestAge;
    std::string m_line; ///< that has not ended
    bool m_isWithinLine = false; ///< of which the beginning was not seen
    std::optional<std::chrono::nanoseconds> m_time; ///< of the last line
    std::string m_last;
};

/// A reference that a person reads and types, one for each standstill. A number that is further
/// from the encoder than ten times what was seen so far is asked for once more.
class TypedReference {
public:
    /// taken: the values that there are already. window: as of CaptureRules; until there is a value
    /// a hundred of it are no surprise, and later ten of it.
    TypedReference(ReferenceLineReader reader, std::span<const CapturedValue> taken, double window);

    /// Empty: it counts from now on. Otherwise what is wrong with it, or the question whether it is
    /// right, to which the same number once more is the answer.
    [[nodiscard]] Text type(std::string_view line, const CaptureReading& axis, bool isAngular);
    [[nodiscard]] bool isDoubted() const { return m_doubted.has_value(); }
    [[nodiscard]] InstrumentReading reading() const;
    /// The axis moves, or what was typed was not taken.
    void forget();
    void taken(const CapturedValue& value);
    /// left: of the values that were taken, those that still count.
    void takeBack(std::span<const CapturedValue> left);

private:
    [[nodiscard]] static double differenceOf(const CapturedValue& value);

    ReferenceLineReader m_reader;
    std::optional<double> m_seen; ///< largest difference from encoder + output so far
    double m_window;
    std::optional<double> m_position;
    std::optional<double> m_doubted;
};

} // namespace axiscomp
