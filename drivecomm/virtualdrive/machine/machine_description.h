// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace axiscomp::drivecomm {

// The hidden truth of a virtual machine: what is wrong with its axes, and how they are measured.
// Positions and errors are in mm, of rotary axes in deg; time in minutes, temperatures in deg C.

/// amplitude * sin(2 pi u / period + phase)
struct ErrorWave {
    double period = 1.0;
    double amplitude = 0.0;
    double phase = 0.0; ///< rad
};

/// A random walk at knots, and the natural spline between them; beyond the travel its ends.
struct ErrorMap {
    double spacing = 1.0; ///< of its knots, from the low end of the travel
    double sigma = 0.0; ///< standard deviation of one step of the walk
};

/// Errors that follow from a raw position u.
struct ErrorTerms {
    double slope = 0.0; ///< error per position
    std::vector<ErrorWave> waves;
    std::optional<ErrorMap> map;
};

struct WarmUp {
    double rise = 0.0; ///< in K above 20 deg C, in the end
    double minutes = 1.0; ///< time constant: after it 63 % of the rise
};

struct ThermalError {
    double expansion = 0.0; ///< in 1/K
    double zeroPerKelvin = 0.0; ///< how the zero moves
    double fixedAt = 0.0; ///< the position that expansion does not move
    std::optional<WarmUp> warmUp; ///< none: the temperature of the motor as without a machine
};

/// What another axis adds, as squareness and straightness do.
struct CrossError {
    std::size_t axis = 0; ///< whose raw position counts
    ErrorTerms terms;
};

struct MachineAxis {
    std::string name;
    bool isAngular = false;
    double low = 0.0; ///< the travel
    double high = 500.0;
    ErrorTerms terms;
    double reversal = 0.0; ///< the error after moving up less that after moving down
    double reversalWidth = 0.0; ///< the movement after a turn over which it changes sides
    double approachNoise = 0.0; ///< standard deviation, once for each movement
    double readingNoise = 0.0; ///< standard deviation, for each reading
    std::optional<ThermalError> thermal;
    std::vector<CrossError> cross;
};

/// One position of a program at which the instrument is wrong.
struct GrossError {
    std::uint64_t reading = 1; ///< the position of the program, from 1
    double by = 0.0;
};

struct MachineInstrument {
    std::size_t axis = 0; ///< whose position its lines have
    double zero = 0.0; ///< what it shows at 0
    int sign = 1; ///< -1: it counts the other way
    std::string unit = "mm"; ///< of its lines
    double unitsPerPosition = 1.0; ///< of that unit in a mm, or in a deg
    std::vector<GrossError> gross;
};

struct MachineDescription {
    std::uint64_t seed = 1;
    std::vector<MachineAxis> axes; ///< 1 to 16
    MachineInstrument instrument;
};

} // namespace axiscomp::drivecomm
