// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/run_selection.h"

namespace axiscomp {

/// How values that do not fit the others are found. Chauvenet's rule is not among them: with five
/// runs it flags 14 % of groups that are in order.
enum class OutlierRule {
    None,
    /// t_ij = (x_ij - xm_i) sqrt(n_i / (n_i - 1)) of all values of a direction; sigma = 1.4826
    /// median |t|; a score |t| / sigma above 4. One after the other, all computed anew each time.
    PooledMad,
    /// The largest |x_ij - xm_i| / s_i of a group against the two-sided 5 % limit of Grubbs, for 3
    /// to 10 values.
    Grubbs,
};
[[nodiscard]] std::string_view outlierRuleName(OutlierRule rule); ///< "mad", "grubbs", "none"
[[nodiscard]] std::optional<OutlierRule> outlierRuleNamed(std::string_view name);

struct Outlier {
    Approach direction = Approach::Up;
    std::size_t target = 0; ///< index into the measurement's targets
    int run = 1;
    double score = 0.0;

    friend bool operator==(const Outlier&, const Outlier&) = default;
};

struct DirectionOutliers {
    std::optional<double> sigma; ///< of PooledMad when it ended, in mm or deg
    std::vector<Outlier> flagged; ///< the most striking first
    /// More than a fifth of the values would go: nothing is proposed, the measurement is disturbed.
    bool isDisturbed = false;
    /// Values may stand out that the rule cannot tell: of PooledMad one above the limit in a group
    /// of 3, or any where all others are equal; of Grubbs a group of another size than 4 to 10.
    bool isUndecided = false;
};

/// A proposal; nothing is left out by it.
struct Outliers {
    OutlierRule rule = OutlierRule::None;
    double limit = 0.0; ///< of the score; 0 for Grubbs, which has one for each number of values
    DirectionOutliers up;
    DirectionOutliers down;
};

/// Of the values in use. No group would keep fewer than 3 values.
[[nodiscard]] Outliers findOutliers(const Measurement& measurement, OutlierRule rule);

/// What exclude() takes.
[[nodiscard]] Exclusion exclusionOf(const Outlier& outlier);
/// Of everything that is proposed.
[[nodiscard]] std::vector<Exclusion> exclusionsOf(const Outliers& outliers);

} // namespace axiscomp
