// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/proof.h"
#include "core/table/lookup.h"

namespace axiscomp {

/// How what a drive says at one instant is compared with core's lookup. Refers to the table, which
/// must outlive it.
class ProofRule {
public:
    explicit ProofRule(const CompensationTable& table);

    /// Of the output: the drive calculates with Single numbers.
    [[nodiscard]] double tolerance() const { return m_tolerance; }

    /// The drive's numbers of one instant.
    struct Reading {
        std::array<double, 3> sources{};
        double output = 0.0;
        std::array<double, 3> indices{};
        bool isActive = true; ///< while it evaluates, the drive looks up but adds nothing
    };
    [[nodiscard]] Proof::Sample sampleOf(const Reading& reading) const;
    /// How far output and indices may have moved while a drive answered register by register.
    struct Motion {
        double output = 0.0;
        std::array<double, 3> indices{};
    };
    /// From a sample to where the sources were later or before.
    [[nodiscard]] Motion motionTo(
        const Proof::Sample& sample, const std::array<double, 3>& sources) const;

    /// Whether a drive that adds nothing, or the opposite, would be told from one that adds what
    /// the table says: what is within the difference that is allowed is evidence of nothing.
    [[nodiscard]] bool shows(const Proof::Sample& sample, const Motion& motion) const;

    /// Errors: ProofFailed. status: whose sample it is.
    [[nodiscard]] Result<void> compare(
        const AxisStatus& status, const Proof::Sample& sample, const Motion& motion) const;

private:
    [[nodiscard]] std::size_t dimensions() const { return m_table.grid.axes.size(); }
    [[nodiscard]] double lookedUp(const std::array<double, 3>& sources) const;
    [[nodiscard]] double allowedDifference(const Motion& motion) const
    {
        return m_tolerance + motion.output;
    }

    const CompensationTable& m_table;
    Lookup m_lookup;
    double m_tolerance = 0.0;
};

} // namespace axiscomp
