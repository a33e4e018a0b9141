// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/axis_status.h"
#include "core/base/result.h"
#include "core/base/text.h"
#include "core/table/compensation_table.h"

#include <array>
#include <vector>

namespace axiscomp {

class RegisterAccess;

/// The drive's own numbers against core's lookup at the same sources.
struct Proof {
    /// What the samples can show. Beyond the ends of a table, and where it is 0 or no larger than
    /// the difference that is allowed, a wrong table looks like the right one.
    enum class Extent {
        Proved, ///< at least one sample within the table and with an output that shows
        IndicesOnly, ///< within the table, but the compensation evaluates: nothing is added
        OutsideTable,
        OnlyZeros, ///< or so little that it cannot be told from 0
    };
    struct Sample {
        std::array<double, 3> sources{};
        double output = 0.0; ///< the drive's
        double expected = 0.0; ///< computed here
        std::array<double, 3> indices{};
        std::array<double, 3> expectedIndices{};
    };
    std::vector<Sample> samples;
    double largestDifference = 0.0; ///< |output - expected|
    double tolerance = 0.0; ///< float32 rounding of the table's largest value
    Extent extent = Extent::Proved;
    double provedShare = 0.0; ///< the share of the table's cells in which a sample was, 0 to 1
};

/// Samples of a proof that follows a switch by itself.
inline constexpr int proofSamples = 5;

/// Why nothing is proved although nothing differs, and what to do about it, as a sentence; for
/// another extent than Proved.
[[nodiscard]] Text notProvedText(Proof::Extent extent);

/// The end-to-end proof (docs/architecture.md): the drive's own output and indices against core's
/// lookup in the table that the drive holds, at the sources that the drive reports with them. Finds
/// mistakes of sign, unit and element order. table: as downloaded from the drive, or the one that
/// was to be written.
[[nodiscard]] Result<Proof> proveAxis(const RegisterAccess& access, const AxisStatus& status,
    const CompensationTable& table, int samples);

} // namespace axiscomp
