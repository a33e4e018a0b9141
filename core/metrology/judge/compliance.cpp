// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/judge/compliance.h"

#include "core/text/number_text.h"

#include <algorithm>
#include <cmath>

namespace axiscomp {

namespace {

constexpr double longAxisMm = 2000.0;

/// The conditions in the order of the standard.
class Conditions {
public:
    Conditions(
        const Measurement& measurement, const Iso230Figures& figures, std::optional<double> period)
        : m_measurement(measurement)
        , m_figures(figures)
        , m_period(period)
        , m_range(figures.targets.empty()
                  ? 0.0
                  : figures.targets.back().position - figures.targets.front().position)
    {
    }

    [[nodiscard]] std::vector<ComplianceLine> all()
    {
        checkTargets();
        checkRuns();
        checkDirections();
        checkPeriod();
        checkRecord("environment", AXISCOMP_TEXT("Measurement", "the file states the temperature"),
            isTemperatureStated());
        checkRecord("instrument", AXISCOMP_TEXT("Measurement", "the file states the instrument"),
            !m_measurement.header.instrument.empty());
        checkRecord("feed", AXISCOMP_TEXT("Measurement", "the file states the feed"),
            !m_measurement.header.feed.empty());
        checkRecord("dwell", AXISCOMP_TEXT("Measurement", "the file states the dwell"),
            !m_measurement.header.dwell.empty());
        return std::move(m_lines);
    }

private:
    void add(std::string_view rule, Text text, std::optional<bool> isMet, bool isAssumed = false)
    {
        m_lines.push_back({rule, std::move(text), isMet, isAssumed});
    }
    /// By each of the files that were joined, whether it is one for all or not.
    [[nodiscard]] bool isTemperatureStated() const
    {
        const auto isIn = [](const MeasurementHeader& header) {
            return header.airTemperature || header.materialTemperature;
        };
        const auto& files = m_measurement.joined;
        return isIn(m_measurement.header) || temperaturesOfValues(m_measurement)
            || (!files.empty() && std::ranges::all_of(files, isIn));
    }
    [[nodiscard]] Quantity range() const
    {
        return {roundedText(m_range), std::string(positionUnit(m_measurement))};
    }
    [[nodiscard]] bool isLong() const { return !m_measurement.isAngular && m_range > longAxisMm; }

    /// Between two targets, which are in order.
    [[nodiscard]] double widestGap() const
    {
        double widest = 0.0;
        for (std::size_t n = 1; n < m_figures.targets.size(); ++n)
            widest =
                std::max(widest, m_figures.targets[n].position - m_figures.targets[n - 1].position);
        return widest;
    }

    void checkTargets();
    void checkRuns();
    void checkDirections();
    void checkPeriod();
    void checkRecord(std::string_view rule, const TextPattern& text, bool isThere)
    {
        add(rule, text, isThere);
    }

    const Measurement& m_measurement;
    const Iso230Figures& m_figures;
    std::optional<double> m_period;
    double m_range;
    std::vector<ComplianceLine> m_lines;
};

void Conditions::checkTargets()
{
    const std::size_t count = m_figures.targets.size();
    if (m_measurement.isAngular) {
        constexpr double slack = 1e-9;
        const std::size_t due = m_range <= 90.0 + slack ? 3 : m_range <= 180.0 + slack ? 5 : 8;
        add("targets",
            AXISCOMP_TEXT("Measurement", "at least {due} targets over {range}: {count}")
                .with("due", due)
                .with("range", range())
                .with("count", count),
            count >= due, true);
        return;
    }
    if (isLong()) {
        constexpr double aboutMm = 275.0; // "about every 250 mm"
        constexpr double widestMm = 2.0 * aboutMm; // uneven targets are meant to differ
        const double gap = widestGap();
        const bool isMet =
            count >= 2 && m_range / static_cast<double>(count - 1) <= aboutMm && gap <= widestMm;
        add("targets",
            AXISCOMP_TEXT("Measurement",
                "a target about every 250 mm on an axis above 2 m: {count} over {range}, at most "
                "{gap} apart")
                .with("range", range())
                .with("count", count)
                .with("gap", Quantity{roundedText(gap), std::string(positionUnit(m_measurement))}),
            isMet, true);
        return;
    }
    const auto perMetre = static_cast<std::size_t>(std::ceil(5.0 * m_range / 1000.0 - 1e-9));
    add("targets",
        AXISCOMP_TEXT(
            "Measurement", "at least 5 targets, and 5 for each metre: {count} over {range}")
            .with("range", range())
            .with("count", count),
        count >= std::max<std::size_t>(5, perMetre));
}

void Conditions::checkRuns()
{
    std::size_t fewest = 0;
    bool isFirst = true;
    for (const TargetFigures& target : m_figures.targets)
        for (const std::size_t n : {target.up.n, target.down.n}) {
            fewest = isFirst ? n : std::min(fewest, n);
            isFirst = false;
        }
    if (isLong())
        add("runs",
            AXISCOMP_TEXT("Measurement",
                "a run in each direction on an axis above 2 m, for E, B and M alone: {count}")
                .with("count", fewest),
            fewest >= 1, true);
    else if (m_measurement.kind == MeasurementKind::Averages)
        add("runs", AXISCOMP_TEXT("Measurement", "5 runs in each direction: the file has means"),
            std::nullopt);
    else
        add("runs",
            AXISCOMP_TEXT(
                "Measurement", "5 runs in each direction: {count} at the target with the fewest")
                .with("count", fewest),
            fewest >= 5);
}

void Conditions::checkDirections()
{
    const bool hasBoth = std::ranges::all_of(m_figures.targets,
        [](const TargetFigures& target) { return target.up.n > 0 && target.down.n > 0; });
    add("bidirectional",
        AXISCOMP_TEXT("Measurement", "every target is approached in both directions"), hasBoth);
}

void Conditions::checkPeriod()
{
    if (!m_period) {
        add("period",
            AXISCOMP_TEXT("Measurement",
                "the targets are not all at the same place of a period of the axis; no period is "
                "stated"),
            std::nullopt);
        return;
    }
    double largest = 0.0;
    for (const TargetFigures& target : m_figures.targets) {
        const double turns = (target.position - m_figures.targets.front().position) / *m_period;
        largest = std::max(largest, std::abs(turns - std::round(turns)));
    }
    constexpr double least = 0.05; // of a period: what the positions would have to differ by
    add("period",
        AXISCOMP_TEXT(
            "Measurement", "the targets are not all at the same place of the period {period}")
            .with("period",
                Quantity{roundedText(*m_period), std::string(positionUnit(m_measurement))}),
        largest >= least);
}

} // namespace

TextPattern complianceText(std::optional<bool> isMet)
{
    if (!isMet)
        return AXISCOMP_TEXT("Measurement", "not known");
    return *isMet ? AXISCOMP_TEXT("Measurement", "met") : AXISCOMP_TEXT("Measurement", "not met");
}

std::vector<ComplianceLine> complianceOf(
    const Measurement& measurement, const Iso230Figures& figures, std::optional<double> period)
{
    return Conditions(measurement, figures, period).all();
}

} // namespace axiscomp
