// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/axis/proof.h"

#include "core/axis/activation.h"
#include "core/axis/axis_reader.h"
#include "core/table/lookup.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace axiscomp {

namespace {

/// The axis moves between samples, so that they are not all the same place.
constexpr std::chrono::milliseconds sampleInterval{20};

/// The drive calculates with Single numbers: some roundings of half a unit in the last place each.
constexpr double roundings = 8.0;
constexpr double singleRounding = std::numeric_limits<float>::epsilon() / 2.0;

Quantity exactNumber(double value)
{
    return {toText(RegisterValue{value})};
}

class Prover {
public:
    Prover(const RegisterAccess& access, const AxisStatus& status, const CompensationTable& table)
        : m_access(access)
        , m_status(status)
        , m_table(table)
        , m_lookup(table)
    {
        double largest = 0.0;
        for (const float value : table.values)
            largest = std::max(largest, static_cast<double>(std::abs(value)));
        m_proof.tolerance = roundings * singleRounding * largest;
    }

    Result<Proof> run(int samples)
    {
        for (int i = 0; i < samples; ++i) {
            if (i > 0) {
                AXISCOMP_CHECK(m_access.pause(sampleInterval));
            }
            AXISCOMP_CHECK(sample());
        }
        m_proof.extent = !m_isWithin ? Proof::Extent::OutsideTable
            : !m_hasContent          ? Proof::Extent::OnlyZeros
                                     : Proof::Extent::Proved;
        return m_proof;
    }

private:
    [[nodiscard]] std::size_t dimensions() const
    {
        return static_cast<std::size_t>(m_table.grid.dimensions());
    }

    [[nodiscard]] std::vector<std::string> sourcePaths() const
    {
        std::vector<std::string> paths;
        for (std::size_t n = 0; n < dimensions(); ++n)
            paths.push_back(m_status.setup.sources[n].path);
        return paths;
    }

    Result<void> sample()
    {
        const RegisterPaths& names = m_access.registers();
        const int axis = m_status.axis.index;
        const std::string statePath = m_access.axisPath(names.state, axis);
        const std::string outputPath = m_access.axisPath(names.output, axis);
        const std::vector<std::string> indexPaths =
            m_access.axisPaths(names.index, axis, 1, m_table.grid.dimensions());
        std::vector<std::string> paths{statePath, outputPath};
        paths.insert(paths.end(), indexPaths.begin(), indexPaths.end());
        for (const std::string& source : sourcePaths()) {
            if (std::ranges::find(paths, source) == paths.end())
                paths.push_back(source);
        }
        AXISCOMP_TRY(auto readings, m_access.read(paths));

        Proof::Sample sample;
        for (std::size_t n = 0; n < dimensions(); ++n) {
            sample.sources[n] = numberAt(readings, m_status.setup.sources[n].path);
            sample.indices[n] = numberAt(readings, indexPaths[n]);
            sample.expectedIndices[n] = m_lookup.index(static_cast<int>(n), sample.sources[n]);
        }
        const std::string state = textAt(readings, statePath);
        const bool isActive = state == m_access.enums().stateActive;
        if (!isActive && state != m_access.enums().stateEvaluating)
            return fail(ErrorCode::CompensationError,
                {{"axis", axis}, {"error", state},
                    {"hint",
                        AXISCOMP_TEXT("Error",
                            "only an active or an evaluating compensation can be proved")}});
        sample.output = numberAt(readings, outputPath);
        // While evaluating, the drive looks up but adds nothing.
        sample.expected = isActive
            ? m_lookup.at(std::span<const double>(sample.sources.data(), dimensions()))
            : 0.0;
        const bool isWithin = isWithinTable(sample);
        m_isWithin = m_isWithin || isWithin;
        // The indices are what an evaluation shows.
        m_hasContent = m_hasContent || (isWithin && (!isActive || sample.expected != 0.0));
        Motion motion;
        if (!m_access.profile().readsAtOneInstant) {
            AXISCOMP_TRY(auto moved, motionSince(sample));
            motion = moved;
        }
        return compare(sample, motion);
    }

    [[nodiscard]] bool isWithinTable(const Proof::Sample& sample) const
    {
        for (std::size_t n = 0; n < dimensions(); ++n) {
            const GridAxis& axis = m_table.grid.axes[n];
            if (!(axis.start <= sample.sources[n] && sample.sources[n] <= axis.last()))
                return false;
        }
        return true;
    }

    /// How far output and indices may have moved while a drive answered register by register.
    struct Motion {
        double output = 0.0;
        std::array<double, 3> indices{};
    };

    Result<Motion> motionSince(const Proof::Sample& sample)
    {
        AXISCOMP_TRY(auto readings, m_access.read(sourcePaths()));
        std::array<double, 3> sources{};
        Motion motion;
        for (std::size_t n = 0; n < dimensions(); ++n) {
            sources[n] = numberAt(readings, m_status.setup.sources[n].path);
            motion.indices[n] = std::abs(
                m_lookup.index(static_cast<int>(n), sources[n]) - sample.expectedIndices[n]);
        }
        const double later = m_lookup.at(std::span<const double>(sources.data(), dimensions()));
        motion.output = sample.expected == 0.0 ? 0.0 : std::abs(later - sample.expected);
        return motion;
    }

    Result<void> compare(const Proof::Sample& sample, const Motion& motion)
    {
        const double difference = std::abs(sample.output - sample.expected);
        m_proof.largestDifference = std::max(m_proof.largestDifference, difference);
        m_proof.samples.push_back(sample);
        if (!(difference <= m_proof.tolerance + motion.output))
            return mismatch(
                AXISCOMP_TEXT("Error", "the output"), sample, sample.output, sample.expected);
        for (std::size_t n = 0; n < dimensions(); ++n) {
            const double tolerance = motion.indices[n]
                + roundings * singleRounding * static_cast<double>(m_table.grid.axes[n].size);
            if (!(std::abs(sample.indices[n] - sample.expectedIndices[n]) <= tolerance))
                return mismatch(AXISCOMP_TEXT("Error", "the index of dimension {dimension}")
                                    .with("dimension", n + 1),
                    sample, sample.indices[n], sample.expectedIndices[n]);
        }
        return {};
    }

    [[nodiscard]] tl::unexpected<Error> mismatch(
        Text what, const Proof::Sample& sample, double found, double expected) const
    {
        std::vector<Text> position;
        for (std::size_t n = 0; n < dimensions(); ++n)
            position.push_back(AXISCOMP_TEXT("Error", "{axis} = {position}")
                                   .with("axis", m_status.setup.sources[n].path)
                                   .with("position", exactNumber(sample.sources[n])));
        return fail(ErrorCode::ProofFailed,
            {{"axis", m_status.axis.index}, {"what", std::move(what)},
                {"found", exactNumber(found)}, {"expected", exactNumber(expected)},
                {"position", std::move(position)}});
    }

    const RegisterAccess& m_access;
    const AxisStatus& m_status;
    const CompensationTable& m_table;
    Lookup m_lookup;
    Proof m_proof;
    bool m_isWithin = false; ///< at least one sample
    bool m_hasContent = false;
};

} // namespace

Text notProvedText(Proof::Extent extent)
{
    if (extent == Proof::Extent::OutsideTable)
        return AXISCOMP_TEXT("Error",
            "The axis is outside of the table, where the values at its ends hold. Move the axis "
            "into the table and activate again.");
    return AXISCOMP_TEXT("Error",
        "The table is 0 at every position that was looked at. Move the axis to where the table is "
        "not 0 and activate again.");
}

Result<Proof> proveAxis(const RegisterAccess& access, const AxisStatus& status,
    const CompensationTable& table, int samples)
{
    if (status.axis.state == CompensationState::Error)
        return fail(compensationError(status));
    for (std::size_t n = 0; n < static_cast<std::size_t>(table.grid.dimensions()); ++n) {
        if (status.setup.sources[n].path.empty())
            return fail(ErrorCode::SourceMissing, {{"dimension", n + 1}});
    }
    return Prover(access, status, table).run(samples);
}

} // namespace axiscomp
