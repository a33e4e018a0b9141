// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/machine/machine_truth.h"

#include "core/base/fixed_random.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace axiscomp::drivecomm {

namespace {

constexpr double referenceTemperature = 20.0;

/// What a sequence of random numbers is for: the second of the words that it is made from.
enum class RandomUse : std::uint64_t { Map = 1, Approach = 2, Reading = 3 };

FixedRandom randomFor(std::uint64_t seed, RandomUse use, std::size_t axis, std::uint64_t number)
{
    return FixedRandom({seed, static_cast<std::uint64_t>(use), axis, number});
}

/// The walk of the terms of `from` in `axis`, over the travel of `from`.
std::optional<CubicCurve> mapOf(const MachineDescription& machine, std::size_t axis,
    std::size_t from, const std::optional<ErrorMap>& map)
{
    if (!map)
        return std::nullopt;
    const MachineAxis& travel = machine.axes[from];
    const auto intervals = static_cast<std::size_t>(
        std::max(1.0, std::ceil((travel.high - travel.low) / map->spacing)));
    FixedRandom random = randomFor(machine.seed, RandomUse::Map, axis, from);
    CubicCurve curve;
    double value = 0.0;
    for (std::size_t i = 0; i <= intervals; ++i) {
        curve.knots.push_back(travel.low + static_cast<double>(i) * map->spacing);
        curve.values.push_back(value);
        value += map->sigma * random.normal();
    }
    curve.slopes = splineSlopes(curve.knots, curve.values, false);
    return curve;
}

double errorAt(const ErrorTerms& terms, const std::optional<CubicCurve>& map, double raw)
{
    double error = terms.slope * raw;
    for (const ErrorWave& wave : terms.waves)
        error += wave.amplitude * std::sin(2.0 * std::numbers::pi * raw / wave.period + wave.phase);
    return map ? error + map->at(raw) : error;
}

} // namespace

ReversalState::ReversalState(double width, double position)
    // Never nothing, so that the side of a turn at once is not a case of its own.
    : m_width(std::max(width, 1e-9))
    , m_position(position)
    , m_middle(position - m_width / 2.0)
{
}

void ReversalState::moveTo(double position)
{
    m_position = position;
    m_middle = std::clamp(m_middle, position - m_width / 2.0, position + m_width / 2.0);
}

double ReversalState::side() const
{
    return std::clamp((m_position - m_middle) / m_width, -0.5, 0.5);
}

double warmedUp(const WarmUp& warmUp, double minutes)
{
    return referenceTemperature + warmUp.rise * (1.0 - std::exp(-minutes / warmUp.minutes));
}

MachineTruth::MachineTruth(MachineDescription description) : m_description(std::move(description))
{
    for (std::size_t i = 0; i < m_description.axes.size(); ++i) {
        const MachineAxis& axis = m_description.axes[i];
        Maps maps{mapOf(m_description, i, i, axis.terms.map), {}};
        for (const CrossError& cross : axis.cross)
            maps.cross.push_back(mapOf(m_description, i, cross.axis, cross.terms.map));
        m_maps.push_back(std::move(maps));
    }
}

double MachineTruth::position(
    std::size_t axis, std::span<const double> raw, const MeasuredInstant& instant) const
{
    const MachineAxis& truth = m_description.axes.at(axis);
    const double own = raw[axis];
    double error = errorAt(truth.terms, m_maps[axis].own, own) + instant.side * truth.reversal;
    if (truth.thermal) {
        const double kelvin = instant.temperature - referenceTemperature;
        error += truth.thermal->expansion * kelvin * (own - truth.thermal->fixedAt)
            + truth.thermal->zeroPerKelvin * kelvin;
    }
    for (std::size_t i = 0; i < truth.cross.size(); ++i)
        error += errorAt(truth.cross[i].terms, m_maps[axis].cross[i], raw[truth.cross[i].axis]);
    if (truth.approachNoise > 0.0)
        error += truth.approachNoise
            * randomFor(m_description.seed, RandomUse::Approach, axis, instant.approach).normal();
    return own + error;
}

double MachineTruth::reading(
    std::size_t axis, std::span<const double> raw, const MeasuredInstant& instant) const
{
    const MachineAxis& truth = m_description.axes.at(axis);
    const MachineInstrument& instrument = m_description.instrument;
    double seen = position(axis, raw, instant);
    if (truth.readingNoise > 0.0)
        seen += truth.readingNoise
            * randomFor(m_description.seed, RandomUse::Reading, axis, instant.reading).normal();
    for (const GrossError& gross : instrument.gross)
        if (gross.reading == instant.approach && instrument.axis == axis)
            seen += gross.by;
    return instrument.sign * seen + instrument.zero;
}

} // namespace axiscomp::drivecomm
