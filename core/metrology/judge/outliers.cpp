// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/judge/outliers.h"

#include "core/text/token_scanner.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace axiscomp {

namespace {

constexpr double madLimit = 4.0;
constexpr double madToSigma = 1.4826; // of a normal distribution
constexpr std::size_t fewestKept = 3;
/// Two-sided 5 % for n = 3 .. 10: (n - 1) / sqrt(n) * sqrt(t^2 / (n - 2 + t^2)) with t the quantile
/// 1 - 0.05 / (2 n) of Student's distribution with n - 2 degrees of freedom.
constexpr std::array grubbsLimits{1.1543, 1.4812, 1.7150, 1.8871, 2.0200, 2.1266, 2.2150, 2.2900};

/// The values of one target in one direction.
struct Group {
    std::vector<const RunValue*> values;

    [[nodiscard]] double mean() const
    {
        double sum = 0.0;
        for (const RunValue* value : values)
            sum += value->deviation - values.front()->deviation;
        return values.front()->deviation + sum / static_cast<double>(values.size());
    }
    void remove(const RunValue* value) { std::erase(values, value); }
};

std::vector<Group> groupsOf(const Measurement& measurement, Approach direction)
{
    std::vector<Group> groups(measurement.targets.size());
    for (const RunValue& value : measurement.values)
        if (value.direction == direction && value.isUsed)
            groups[value.target].values.push_back(&value);
    std::erase_if(groups, [](const Group& group) { return group.values.empty(); });
    return groups;
}

struct Candidate {
    Group* group = nullptr;
    const RunValue* value = nullptr;
    double size = 0.0; ///< |t|
};

/// All |t| of the groups with a spread.
std::vector<Candidate> residuals(std::vector<Group>& groups)
{
    std::vector<Candidate> all;
    for (Group& group : groups) {
        if (group.values.size() < 2)
            continue;
        const double mean = group.mean();
        const auto n = static_cast<double>(group.values.size());
        for (const RunValue* value : group.values)
            all.push_back(
                {&group, value, std::abs(value->deviation - mean) * std::sqrt(n / (n - 1.0))});
    }
    return all;
}

double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    if (values.size() % 2 == 1)
        return *middle;
    return (*middle + *std::max_element(values.begin(), middle)) / 2.0;
}

DirectionOutliers byPooledMad(const Measurement& measurement, Approach direction)
{
    DirectionOutliers result;
    std::vector<Group> groups = groupsOf(measurement, direction);
    std::size_t count = 0;
    for (const Group& group : groups)
        count += group.values.size();
    while (true) {
        const std::vector<Candidate> all = residuals(groups);
        if (all.empty())
            return result;
        std::vector<double> sizes;
        for (const Candidate& candidate : all)
            sizes.push_back(candidate.size);
        const double sigma = madToSigma * median(std::move(sizes));
        result.sigma = sigma;
        const Candidate worst = *std::ranges::max_element(all, {}, &Candidate::size);
        if (worst.size <= madLimit * sigma)
            return result;
        // Without any spread there is no measure of what is unusual.
        if (!(sigma > 0.0) || worst.group->values.size() <= fewestKept) {
            result.isUndecided = true;
            return result;
        }
        if (5 * (result.flagged.size() + 1) > count) {
            result.flagged.clear();
            result.isDisturbed = true;
            return result;
        }
        result.flagged.push_back(
            {direction, worst.value->target, worst.value->run, worst.size / sigma});
        worst.group->remove(worst.value);
    }
}

DirectionOutliers byGrubbs(const Measurement& measurement, Approach direction)
{
    DirectionOutliers result;
    for (const Group& group : groupsOf(measurement, direction)) {
        const std::size_t n = group.values.size();
        if (n <= fewestKept || n - fewestKept >= grubbsLimits.size()) {
            result.isUndecided = true;
            continue;
        }
        const double mean = group.mean();
        double squares = 0.0;
        const RunValue* farthest = group.values.front();
        for (const RunValue* value : group.values) {
            squares += (value->deviation - mean) * (value->deviation - mean);
            if (std::abs(value->deviation - mean) > std::abs(farthest->deviation - mean))
                farthest = value;
        }
        const double s = std::sqrt(squares / static_cast<double>(n - 1));
        const double score = std::abs(farthest->deviation - mean) / s;
        if (s > 0.0 && score > grubbsLimits[n - fewestKept])
            result.flagged.push_back({direction, farthest->target, farthest->run, score});
    }
    std::ranges::stable_sort(result.flagged, std::ranges::greater{}, &Outlier::score);
    return result;
}

DirectionOutliers outliersOf(const Measurement& measurement, Approach direction, OutlierRule rule)
{
    if (rule == OutlierRule::None)
        return {};
    return rule == OutlierRule::Grubbs ? byGrubbs(measurement, direction)
                                       : byPooledMad(measurement, direction);
}

} // namespace

std::string_view outlierRuleName(OutlierRule rule)
{
    switch (rule) {
    case OutlierRule::PooledMad:
        return "mad";
    case OutlierRule::Grubbs:
        return "grubbs";
    case OutlierRule::None:
        break;
    }
    return "none";
}

std::optional<OutlierRule> outlierRuleNamed(std::string_view name)
{
    for (const OutlierRule rule : {OutlierRule::None, OutlierRule::PooledMad, OutlierRule::Grubbs})
        if (sameLetters(name, outlierRuleName(rule)))
            return rule;
    return std::nullopt;
}

Outliers findOutliers(const Measurement& measurement, OutlierRule rule)
{
    return {rule, rule == OutlierRule::PooledMad ? madLimit : 0.0,
        outliersOf(measurement, Approach::Up, rule), outliersOf(measurement, Approach::Down, rule)};
}

Exclusion exclusionOf(const Outlier& outlier)
{
    return {outlier.direction, outlier.target + 1, outlier.run};
}

std::vector<Exclusion> exclusionsOf(const Outliers& outliers)
{
    std::vector<Exclusion> all;
    for (const DirectionOutliers* one : {&outliers.up, &outliers.down})
        for (const Outlier& outlier : one->flagged)
            all.push_back(exclusionOf(outlier));
    return all;
}

} // namespace axiscomp
