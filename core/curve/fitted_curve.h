// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/curve/cubic_curve.h"
#include "core/curve/periodic_terms.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace axiscomp {

/// A curve and, added to it, terms of known periods. Beyond the knots of the curve the ends of that
/// sum are held.
struct FittedCurve {
    CubicCurve base;
    std::vector<PeriodicTerm> terms = {};
    /// What the sum corrects, and is added to: a table, by its points. It holds its own ends.
    std::optional<CubicCurve> onto = {};

    [[nodiscard]] double at(double position) const;
    /// Where the last position was found in the two curves (CubicCurve::at).
    struct Pieces {
        std::size_t base = 0;
        std::size_t onto = 0;
    };
    /// The same, faster where positions follow one another.
    [[nodiscard]] double at(double position, Pieces& pieces) const;
};

} // namespace axiscomp
