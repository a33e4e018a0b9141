// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

// What a measurement file says, in one shape for all formats. Lengths are in mm, angles in degrees,
// whatever the file had. Words as in ISO 230-2: a target is a position that the axis was sent to, a
// run is one pass over the targets in one direction.

/// Whether a machine, or the air round it, can be as warm as this. The limits are ours: they are
/// wide, and leave out what is in kelvin or in hundredths of a degree.
[[nodiscard]] constexpr bool isPossibleTemperature(double celsius)
{
    return celsius >= -200.0 && celsius <= 200.0;
}

/// The positive direction (up) or the negative one (down) in which a target was approached.
enum class Approach { Up, Down };
[[nodiscard]] std::string_view approachName(Approach direction); ///< "up", "down"
[[nodiscard]] TextPattern approachText(Approach direction); ///< the same in every language

/// One measured value of a target.
struct RunValue {
    std::size_t target = 0; ///< index into Measurement::targets
    Approach direction = Approach::Up;
    int run = 1; ///< from 1, for each direction; there may be gaps
    /// The reference position minus the target: positive when the axis went too far. In mm or deg.
    double deviation = 0.0;
    std::optional<double> encoder = {}; ///< raw position, before compensation, in mm or deg
    std::optional<double> output = {}; ///< what the drive added, in mm or deg
    std::optional<double> time = {}; ///< in s, from any beginning
    std::optional<double> temperature = {}; ///< in deg C
    bool isUsed = true; ///< false: kept in the file, left out of every figure
    std::size_t line = 0; ///< of the file, from 1; 0: not known
    /// What corrections have put to the deviation, in mm or deg: without it, it is as it was read.
    double correction = 0.0;

    friend bool operator==(const RunValue&, const RunValue&) = default;
};

/// A position of the encoder and of the reference at one moment, without a target.
struct TrackSample {
    double encoder = 0.0; ///< raw position, in mm or deg
    double reference = 0.0; ///< in mm or deg
    Approach direction = Approach::Up;
    std::optional<double> time = {}; ///< in s

    friend bool operator==(const TrackSample&, const TrackSample&) = default;
};

/// Values at positions of two or three axes.
struct MeasuredPoints {
    std::vector<std::string> axes; ///< 2 or 3: "X", "Y"
    std::vector<std::vector<double>> positions; ///< [axis][point], in mm or deg
    std::vector<std::string> columns; ///< "dX"
    std::vector<std::vector<double>> values; ///< [column][point], in mm or deg

    [[nodiscard]] std::size_t size() const { return positions.empty() ? 0 : positions[0].size(); }
    friend bool operator==(const MeasuredPoints&, const MeasuredPoints&) = default;
};

enum class MeasurementKind {
    Runs, ///< targets, directions, runs
    Averages, ///< runs with one value each, which is a mean already
    Track, ///< raw and reference positions without targets
    Points, ///< values at positions of 2 or 3 axes
};
[[nodiscard]] std::string_view measurementKindName(MeasurementKind kind); ///< "runs"
[[nodiscard]] TextPattern measurementKindText(MeasurementKind kind);

/// What the drive added while it was measured.
struct MeasuredState {
    enum class Kind { NotSaid, Off, On };
    Kind kind = Kind::NotSaid;
    std::optional<std::uint32_t> tableCrc = {}; ///< of the table that was active, with On

    friend bool operator==(const MeasuredState&, const MeasuredState&) = default;
};

/// As a file of runs says it: "off", "on", "crc:1c291ca3"; empty: not said.
[[nodiscard]] std::string measuredStateText(const MeasuredState& state);

/// What the file says beside the values. Empty: it does not say it.
struct MeasurementHeader {
    std::string machine;
    std::string axis;
    std::string instrument;
    std::string serial;
    std::string operatorName;
    std::string date; ///< as written
    std::string feed; ///< as written, with its unit
    std::string dwell; ///< likewise
    MeasuredState compensation;
    std::optional<double> airTemperature; ///< in deg C
    std::optional<double> materialTemperature; ///< in deg C
    std::optional<double> expansion; ///< of the axis's scale, in 1/K
    /// Whether the values are at 20 deg C already.
    enum class Corrected { NotSaid, None, To20Celsius } corrected = Corrected::NotSaid;
    /// What some of the joined files say, where others say nothing and compensation is not said.
    MeasuredState compensationOfSome = {};
    std::string drive = {}; ///< that measured: "Mill, serial number 850618"

    friend bool operator==(const MeasurementHeader&, const MeasurementHeader&) = default;
};

/// Of the drive that measured. Nothing: the header does not say it.
[[nodiscard]] std::optional<std::int32_t> driveSerialOf(const MeasurementHeader& header);

/// Whether a measurement was certainly made before another one, by the dates of their files: both
/// begin with a day, 2026-11-20, or are times as utcText writes them.
[[nodiscard]] bool isEarlier(std::string_view date, std::string_view other);

/// A result that a file carries beside its values, such as E = 0.09065.
struct PublishedFigure {
    std::string name; ///< "E", "R+" ..., as figureNamed takes it
    double value = 0.0; ///< in mm or deg
    double halfUnit = 0.0; ///< half of its last printed digit
    std::size_t line = 0;

    friend bool operator==(const PublishedFigure&, const PublishedFigure&) = default;
};

/// A unit that was stated where the file says another one.
struct StatedUnit {
    std::string what; ///< a column, such as "deviation", or "targets" or "values"
    std::string stated; ///< by which the values are taken
    std::string ofFile;

    friend bool operator==(const StatedUnit&, const StatedUnit&) = default;
};

/// What was asked for against what the file says: it turns values, or makes others of them.
struct AgainstFile {
    bool swapsDirections = false; ///< up is what the file calls down
    bool invertsReference = false; ///< of joined files: of one of them at least
    bool takesAsReference = false; ///< what the file calls deviations; joined as above
    bool takesAsDeviations = false; ///< what the file calls positions of the reference
    std::vector<StatedUnit> units = {};

    friend bool operator==(const AgainstFile&, const AgainstFile&) = default;
};
/// A phrase for each: "up and down exchanged".
[[nodiscard]] std::vector<Text> againstFileTexts(const AgainstFile& asked);

struct Measurement {
    MeasurementKind kind = MeasurementKind::Runs;
    bool isAngular = false; ///< positions and values are degrees
    MeasurementHeader header;
    std::vector<std::string> notes; ///< everything else that the file says
    std::vector<double> targets; ///< ascending, of runs and averages; also those without a value
    std::vector<RunValue> values; ///< sorted by direction, target, run
    std::vector<TrackSample> track; ///< in the order of the file
    MeasuredPoints points;
    std::vector<PublishedFigure> published;
    /// How finely the file prints a value: half of its last digit, in mm or deg. 0: not rounded.
    double halfPrintedUnit = 0.0;
    AgainstFile againstFile = {};
    /// What each of the files says that it was joined of, in their order; empty: it is of one.
    std::vector<MeasurementHeader> joined = {};

    [[nodiscard]] bool hasTargets() const
    {
        return kind == MeasurementKind::Runs || kind == MeasurementKind::Averages;
    }
    /// The distance of the last target from the first, or of the outermost positions of a track.
    [[nodiscard]] double range() const;
    /// Of the runs in this direction, ascending; they need not begin with 1, nor be without gaps.
    [[nodiscard]] std::vector<int> runNumbers(Approach direction) const;
    /// How many runs there are in this direction, whatever their numbers are.
    [[nodiscard]] int runCount(Approach direction) const;
    /// The highest number of a run in this direction; 0 without any.
    [[nodiscard]] int lastRun(Approach direction) const;
    /// Values that are left out.
    [[nodiscard]] std::size_t excludedCount() const;

    friend bool operator==(const Measurement&, const Measurement&) = default;
};

/// "mm" or "deg"
[[nodiscard]] std::string_view positionUnit(const Measurement& measurement);

/// The lowest and the highest temperature of values in use, in deg C; nothing where one of them has
/// none. What has it, the air or the machine, no file says.
struct TemperatureRange {
    double lowest = 0.0;
    double highest = 0.0;
};
[[nodiscard]] std::optional<TemperatureRange> temperaturesOfValues(const Measurement& measurement);

/// From the first position to the last one, in mm or deg.
struct MeasuredRange {
    double first = 0.0;
    double last = 0.0;

    friend bool operator==(const MeasuredRange&, const MeasuredRange&) = default;
};
/// What a first and a second measurement of an axis cover.
struct TwoRanges {
    MeasuredRange before;
    MeasuredRange after;

    friend bool operator==(const TwoRanges&, const TwoRanges&) = default;
};

/// Each position once, ascending: those that are closer than 1e-9 of the range are one.
[[nodiscard]] std::vector<double> distinctTargets(std::vector<double> positions);
/// The target nearest to a position. Not for an empty list.
[[nodiscard]] std::size_t targetIndex(const std::vector<double>& targets, double position);

/// Those that were planned and never measured, ascending: they have no value at all, neither in use
/// nor left out.
[[nodiscard]] std::vector<double> targetsWithoutValues(const Measurement& measurement);

/// The values of a target in one direction, by run. In a measurement whose values stand in order.
[[nodiscard]] std::span<const RunValue> valuesAt(
    const Measurement& measurement, Approach direction, std::size_t target);
/// Null: there is no such value.
[[nodiscard]] const RunValue* findValue(
    const Measurement& measurement, Approach direction, std::size_t target, int run);

/// The order in which Measurement::values stand, so that no result depends on the order of lines.
void sortValues(std::vector<RunValue>& values);

} // namespace axiscomp
