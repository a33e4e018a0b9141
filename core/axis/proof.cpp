// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/axis/proof.h"

#include "core/axis/activation.h"
#include "core/axis/axis_reader.h"
#include "core/axis/proof_rule.h"
#include "core/axis/proved_part.h"

#include <algorithm>
#include <cmath>

namespace axiscomp {

namespace {

/// The axis moves between samples, so that they are not all the same place.
constexpr std::chrono::milliseconds sampleInterval{20};

class Prover {
public:
    Prover(const RegisterAccess& access, const AxisStatus& status, const CompensationTable& table)
        : m_access(access)
        , m_status(status)
        , m_table(table)
        , m_rule(table)
        , m_part(table.grid)
    {
        m_proof.tolerance = m_rule.tolerance();
    }

    Result<Proof> run(int samples)
    {
        for (int i = 0; i < samples; ++i) {
            if (i > 0) {
                AXISCOMP_CHECK(m_access.pause(sampleInterval));
            }
            AXISCOMP_CHECK(sample());
        }
        m_proof.provedShare = m_part.share();
        m_proof.extent = m_part.seen().empty() ? Proof::Extent::OutsideTable
            : m_isEvaluating                   ? Proof::Extent::IndicesOnly
            : !m_hasContent                    ? Proof::Extent::OnlyZeros
                                               : Proof::Extent::Proved;
        return m_proof;
    }

private:
    [[nodiscard]] std::vector<std::string> sourcePaths() const
    {
        std::vector<std::string> paths;
        for (std::size_t n = 0; n < m_table.grid.axes.size(); ++n)
            paths.push_back(m_status.setup.sources[n].path);
        return paths;
    }

    [[nodiscard]] std::array<double, 3> sourcesFrom(const Readings& readings) const
    {
        std::array<double, 3> sources{};
        for (std::size_t n = 0; n < m_table.grid.axes.size(); ++n)
            sources[n] = numberAt(readings, m_status.setup.sources[n].path);
        return sources;
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

        const std::string state = textAt(readings, statePath);
        const bool isActive = state == m_access.enums().stateActive;
        if (!isActive && state != m_access.enums().stateEvaluating)
            return fail(ErrorCode::CompensationError,
                {{"axis", axis}, {"error", state},
                    {"hint",
                        AXISCOMP_TEXT("Error",
                            "only an active or an evaluating compensation can be proved")}});
        ProofRule::Reading reading{
            sourcesFrom(readings), numberAt(readings, outputPath), {}, isActive};
        for (std::size_t n = 0; n < indexPaths.size(); ++n)
            reading.indices[n] = numberAt(readings, indexPaths[n]);
        const Proof::Sample sample = m_rule.sampleOf(reading);
        m_isEvaluating = m_isEvaluating || !isActive;
        ProofRule::Motion motion;
        if (!m_access.profile().readsAtOneInstant) {
            AXISCOMP_TRY(const auto later, m_access.read(sourcePaths()));
            motion = m_rule.motionTo(sample, sourcesFrom(later));
        }
        if (isWithin(m_table.grid, sample.sources)) {
            m_part.add(sample.sources);
            m_hasContent = m_hasContent || m_rule.shows(sample, motion);
        }
        m_proof.largestDifference =
            std::max(m_proof.largestDifference, std::abs(sample.output - sample.expected));
        m_proof.samples.push_back(sample);
        return m_rule.compare(m_status, sample, motion);
    }

    const RegisterAccess& m_access;
    const AxisStatus& m_status;
    const CompensationTable& m_table;
    ProofRule m_rule;
    ProvedPart m_part;
    Proof m_proof;
    bool m_hasContent = false;
    bool m_isEvaluating = false;
};

} // namespace

Text notProvedText(Proof::Extent extent)
{
    if (extent == Proof::Extent::IndicesOnly)
        return AXISCOMP_TEXT("Error",
            "The drive looks up where it should, but adds nothing while it evaluates. Activate to "
            "prove what it adds.");
    if (extent == Proof::Extent::OutsideTable)
        return AXISCOMP_TEXT("Error",
            "The axis is outside of the table, where the values at its ends hold. Move the axis "
            "into the table and activate again.");
    return AXISCOMP_TEXT("Error",
        "The table is 0, or too small to be seen, at every position that was looked at. Move the "
        "axis to where the table is larger and activate again.");
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
    auto proof = Prover(access, status, table).run(samples);
    if (!proof && proof.error().code != ErrorCode::ProofFailed
        && proof.error().code != ErrorCode::CompensationError)
        return proof;
    // What another drive has answered proves nothing, and contradicts nothing.
    const auto same = access.expecting(status.drive).checkDrive();
    if (!same && (proof || same.error().code == ErrorCode::OtherDrive))
        return fail(same.error());
    return proof;
}

} // namespace axiscomp
