// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/judge/published_figures.h"
#include "core/base/portable_math.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace axiscomp {

namespace {

struct Inequality {
    Iso230Figure larger;
    Iso230Figure smaller;
};
constexpr std::array inequalities{
    Inequality{Iso230Figure::E, Iso230Figure::EUp},
    Inequality{Iso230Figure::E, Iso230Figure::EDown},
    Inequality{Iso230Figure::E, Iso230Figure::M},
    Inequality{Iso230Figure::A, Iso230Figure::AUp},
    Inequality{Iso230Figure::A, Iso230Figure::ADown},
    Inequality{Iso230Figure::A, Iso230Figure::E},
    Inequality{Iso230Figure::A, Iso230Figure::R},
    Inequality{Iso230Figure::R, Iso230Figure::RUp},
    Inequality{Iso230Figure::R, Iso230Figure::RDown},
    Inequality{Iso230Figure::R, Iso230Figure::B},
};

/// How much a figure can change when every value changes by 1.
double sensitivity(Iso230Figure figure, std::size_t fewestValues)
{
    const auto n = static_cast<double>(std::max<std::size_t>(fewestValues, 2));
    const double spread = std::sqrt(n / (n - 1.0)); // of s
    switch (figure) {
    case Iso230Figure::RUp:
    case Iso230Figure::RDown:
        return 4.0 * spread;
    case Iso230Figure::R:
    case Iso230Figure::A:
    case Iso230Figure::AUp:
    case Iso230Figure::ADown:
        return 4.0 * spread + 2.0;
    default:
        return 2.0;
    }
}

std::size_t fewestValues(const Iso230Figures& figures)
{
    std::size_t fewest = 0;
    for (const TargetFigures& target : figures.targets)
        for (const std::size_t n : {target.up.n, target.down.n})
            if (n > 0)
                fewest = fewest == 0 ? n : std::min(fewest, n);
    return fewest;
}

/// As many decimals as the file prints.
Quantity printed(double value, double halfUnit, const Measurement& measurement)
{
    const int decimals = halfUnit > 0.0
        ? std::clamp(static_cast<int>(std::lround(-portable::log10(2.0 * halfUnit))), 0, 12)
        : 6;
    std::array<char, 352> buffer{};
    const auto end = std::to_chars(
        buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
    return {std::string(buffer.data(), end.ptr), std::string(positionUnit(measurement))};
}

class PublishedChecker {
public:
    PublishedChecker(const Measurement& measurement, const Iso230Figures& figures)
        : m_measurement(measurement)
        , m_figures(figures)
    {
    }

    [[nodiscard]] PublishedCheck check()
    {
        const std::size_t fewest = fewestValues(m_figures);
        for (const PublishedFigure& published : m_measurement.published) {
            const auto figure = figureNamed(published.name);
            if (!figure)
                continue;
            PublishedComparison comparison{*figure, published.value, m_figures[*figure].value,
                published.halfUnit + m_measurement.halfPrintedUnit * sensitivity(*figure, fewest),
                true, published.line};
            comparison.agrees = !comparison.computed
                || std::abs(*comparison.computed - comparison.published)
                    <= comparison.tolerance * (1.0 + 1e-9);
            m_result.comparisons.push_back(comparison);
        }
        for (const PublishedComparison& comparison : m_result.comparisons)
            judge(comparison);
        return std::move(m_result);
    }

private:
    [[nodiscard]] const PublishedComparison* violatedBy(const PublishedComparison& larger) const
    {
        for (const Inequality& inequality : inequalities) {
            if (inequality.larger != larger.figure)
                continue;
            for (const PublishedComparison& other : m_result.comparisons)
                if (other.figure == inequality.smaller
                    && larger.published + larger.tolerance + other.tolerance < other.published)
                    return &other;
        }
        return nullptr;
    }

    void judge(const PublishedComparison& comparison)
    {
        const PublishedComparison* const smaller = violatedBy(comparison);
        if (comparison.agrees && smaller == nullptr)
            return;
        const double half = halfUnitOf(comparison);
        Text text = AXISCOMP_TEXT("Measurement", "the file says {figure} = {published}")
                        .with("figure", figureText(comparison.figure))
                        .with("published", printed(comparison.published, half, m_measurement));
        if (smaller != nullptr)
            text = AXISCOMP_TEXT(
                "Measurement", "{statement}, which is less than its own {figure} = {published}")
                       .with("statement", text)
                       .with("figure", figureText(smaller->figure))
                       .with("published",
                           printed(smaller->published, halfUnitOf(*smaller), m_measurement));
        if (comparison.computed)
            text = AXISCOMP_TEXT("Measurement", "{statement}; computed from its values: {computed}")
                       .with("statement", text)
                       .with("computed", printed(*comparison.computed, half, m_measurement));
        m_result.contradictions.push_back(std::move(text));
    }

    [[nodiscard]] double halfUnitOf(const PublishedComparison& comparison) const
    {
        const auto published = std::ranges::find_if(
            m_measurement.published, [&comparison](const PublishedFigure& one) {
                return figureNamed(one.name) == comparison.figure && one.line == comparison.line;
            });
        return published == m_measurement.published.end() ? 0.0 : published->halfUnit;
    }

    const Measurement& m_measurement;
    const Iso230Figures& m_figures;
    PublishedCheck m_result;
};

} // namespace

PublishedCheck checkPublished(const Measurement& measurement, const Iso230Figures& figures)
{
    return PublishedChecker(measurement, figures).check();
}

} // namespace axiscomp
