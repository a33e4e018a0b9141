// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/axis/proof_rule.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace axiscomp {

namespace {

/// The drive calculates with Single numbers: some roundings of half a unit in the last place each.
constexpr double roundings = 8.0;
constexpr double singleRounding = std::numeric_limits<float>::epsilon() / 2.0;

Quantity exactNumber(double value)
{
    return {toText(RegisterValue{value})};
}

} // namespace

ProofRule::ProofRule(const CompensationTable& table) : m_table(table), m_lookup(table)
{
    double largest = 0.0;
    for (const float value : table.values)
        largest = std::max(largest, static_cast<double>(std::abs(value)));
    m_tolerance = roundings * singleRounding * largest;
}

double ProofRule::lookedUp(const std::array<double, 3>& sources) const
{
    return m_lookup.at(std::span<const double>(sources.data(), dimensions()));
}

Proof::Sample ProofRule::sampleOf(const Reading& reading) const
{
    Proof::Sample sample;
    sample.sources = reading.sources;
    sample.output = reading.output;
    sample.indices = reading.indices;
    for (std::size_t n = 0; n < dimensions(); ++n)
        sample.expectedIndices[n] = m_lookup.index(static_cast<int>(n), sample.sources[n]);
    sample.expected = reading.isActive ? lookedUp(sample.sources) : 0.0;
    return sample;
}

ProofRule::Motion ProofRule::motionTo(
    const Proof::Sample& sample, const std::array<double, 3>& sources) const
{
    Motion motion;
    for (std::size_t n = 0; n < dimensions(); ++n)
        motion.indices[n] =
            std::abs(m_lookup.index(static_cast<int>(n), sources[n]) - sample.expectedIndices[n]);
    motion.output = sample.expected == 0.0 ? 0.0 : std::abs(lookedUp(sources) - sample.expected);
    return motion;
}

bool ProofRule::shows(const Proof::Sample& sample, const Motion& motion) const
{
    return std::abs(sample.expected) > allowedDifference(motion);
}

Result<void> ProofRule::compare(
    const AxisStatus& status, const Proof::Sample& sample, const Motion& motion) const
{
    const auto mismatch = [&](Text what, double found, double expected) {
        std::vector<Text> position;
        for (std::size_t n = 0; n < dimensions(); ++n)
            position.push_back(AXISCOMP_TEXT("Error", "{axis} = {position}")
                                   .with("axis", status.setup.sources[n].path)
                                   .with("position", exactNumber(sample.sources[n])));
        return fail(ErrorCode::ProofFailed,
            {{"axis", status.axis.index}, {"what", std::move(what)}, {"found", exactNumber(found)},
                {"expected", exactNumber(expected)}, {"position", std::move(position)}});
    };
    if (!(std::abs(sample.output - sample.expected) <= allowedDifference(motion)))
        return mismatch(AXISCOMP_TEXT("Error", "the output"), sample.output, sample.expected);
    for (std::size_t n = 0; n < dimensions(); ++n) {
        const double tolerance = motion.indices[n]
            + roundings * singleRounding * static_cast<double>(m_table.grid.axes[n].size);
        if (!(std::abs(sample.indices[n] - sample.expectedIndices[n]) <= tolerance))
            return mismatch(AXISCOMP_TEXT("Error", "the index of dimension {dimension}")
                                .with("dimension", n + 1),
                sample.indices[n], sample.expectedIndices[n]);
    }
    return {};
}

} // namespace axiscomp
