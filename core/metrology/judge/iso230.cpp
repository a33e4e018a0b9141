// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/judge/iso230.h"

#include "core/base/portable_math.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <cmath>

namespace axiscomp {

namespace {

struct FigureRow {
    Iso230Figure figure;
    std::string_view name;
    std::string_view otherName;
    TextPattern words;
};
constexpr std::array figureRows{
    FigureRow{Iso230Figure::B, "B", "B", AXISCOMP_TEXT("Measurement", "reversal value B")},
    FigureRow{Iso230Figure::MeanReversal, "Bmean", "Bm",
        AXISCOMP_TEXT("Measurement", "mean reversal value")},
    FigureRow{
        Iso230Figure::M, "M", "M", AXISCOMP_TEXT("Measurement", "range of the mean deviation M")},
    FigureRow{
        Iso230Figure::EUp, "EUp", "E+", AXISCOMP_TEXT("Measurement", "systematic deviation E, up")},
    FigureRow{Iso230Figure::EDown, "EDown", "E-",
        AXISCOMP_TEXT("Measurement", "systematic deviation E, down")},
    FigureRow{Iso230Figure::E, "E", "E", AXISCOMP_TEXT("Measurement", "systematic deviation E")},
    FigureRow{Iso230Figure::RUp, "RUp", "R+", AXISCOMP_TEXT("Measurement", "repeatability R, up")},
    FigureRow{
        Iso230Figure::RDown, "RDown", "R-", AXISCOMP_TEXT("Measurement", "repeatability R, down")},
    FigureRow{Iso230Figure::R, "R", "R", AXISCOMP_TEXT("Measurement", "repeatability R")},
    FigureRow{Iso230Figure::AUp, "AUp", "A+", AXISCOMP_TEXT("Measurement", "accuracy A, up")},
    FigureRow{Iso230Figure::ADown, "ADown", "A-", AXISCOMP_TEXT("Measurement", "accuracy A, down")},
    FigureRow{Iso230Figure::A, "A", "A", AXISCOMP_TEXT("Measurement", "accuracy A")},
};
static_assert(figureRows.size() == iso230FigureCount);

constexpr auto allFigures = [] {
    std::array<Iso230Figure, iso230FigureCount> all{};
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = figureRows[i].figure;
    return all;
}();

/// The figures of one direction at one target; sums once for the mean and once for the spread, so
/// that a common offset costs no digits.
DirectionFigures directionFigures(std::span<const double> values)
{
    DirectionFigures result;
    result.n = values.size();
    if (values.empty())
        return result;
    const auto n = static_cast<double>(values.size());
    const double first = values.front();
    double sum = 0.0;
    for (const double value : values)
        sum += value - first;
    const double mean = first + sum / n;
    result.mean = mean;
    if (values.size() < 2)
        return result;
    double squares = 0.0;
    for (const double value : values)
        squares += (value - mean) * (value - mean);
    const double s = std::sqrt(squares / (n - 1.0));
    result.s = s;
    result.repeatability = 4.0 * s;
    result.low = mean - 2.0 * s;
    result.high = mean + 2.0 * s;
    return result;
}

void combineDirections(TargetFigures& target)
{
    if (!target.up.mean || !target.down.mean)
        return;
    target.mean = (*target.up.mean + *target.down.mean) / 2.0;
    target.reversal = *target.up.mean - *target.down.mean;
    if (target.up.s && target.down.s)
        target.repeatability =
            std::max({2.0 * *target.up.s + 2.0 * *target.down.s + std::abs(*target.reversal),
                *target.up.repeatability, *target.down.repeatability});
}

/// Collects the largest and the smallest of what every target must have.
class Extremes {
public:
    void add(const std::optional<double>& high, const std::optional<double>& low, std::size_t at)
    {
        if (!high || !low) {
            m_isDefined = false;
            return;
        }
        if (!m_hasAny || *high > m_highest) {
            m_highest = *high;
            m_figure.high = at;
        }
        if (!m_hasAny || *low < m_lowest) {
            m_lowest = *low;
            m_figure.low = at;
        }
        m_hasAny = true;
    }
    void add(const std::optional<double>& value, std::size_t at) { add(value, value, at); }

    [[nodiscard]] AxisFigure range() const
    {
        AxisFigure figure = m_figure;
        if (m_isDefined && m_hasAny)
            figure.value = m_highest - m_lowest;
        return figure;
    }
    [[nodiscard]] AxisFigure maximum() const
    {
        AxisFigure figure{std::nullopt, m_figure.high, m_figure.high};
        if (m_isDefined && m_hasAny)
            figure.value = m_highest;
        return figure;
    }

private:
    AxisFigure m_figure;
    double m_highest = 0.0;
    double m_lowest = 0.0;
    bool m_hasAny = false;
    bool m_isDefined = true;
};

/// Nothing: both, or none.
std::optional<Approach> onlyDirection(const Iso230Figures& figures)
{
    const auto isThere = [&figures](DirectionFigures TargetFigures::*direction) {
        return std::ranges::any_of(figures.targets,
            [direction](const TargetFigures& target) { return (target.*direction).n > 0; });
    };
    const bool isUpThere = isThere(&TargetFigures::up);
    if (isUpThere == isThere(&TargetFigures::down))
        return std::nullopt;
    return isUpThere ? Approach::Up : Approach::Down;
}

std::optional<double> absolute(const std::optional<double>& value)
{
    return value ? std::optional(std::abs(*value)) : std::nullopt;
}

std::optional<double> meanReversal(const std::vector<TargetFigures>& targets)
{
    double sum = 0.0;
    for (const TargetFigures& target : targets) {
        if (!target.reversal)
            return std::nullopt;
        sum += *target.reversal;
    }
    return targets.empty() ? std::nullopt
                           : std::optional(sum / static_cast<double>(targets.size()));
}

void judgeAxis(Iso230Figures& result)
{
    std::array<Extremes, iso230FigureCount> extremes;
    const auto at = [&extremes](Iso230Figure figure) -> Extremes& {
        return extremes[static_cast<std::size_t>(figure)];
    };
    for (std::size_t i = 0; i < result.targets.size(); ++i) {
        const TargetFigures& target = result.targets[i];
        const DirectionFigures& up = target.up;
        const DirectionFigures& down = target.down;
        at(Iso230Figure::B).add(absolute(target.reversal), i);
        at(Iso230Figure::M).add(target.mean, i);
        at(Iso230Figure::EUp).add(up.mean, i);
        at(Iso230Figure::EDown).add(down.mean, i);
        at(Iso230Figure::E).add(up.mean, i);
        at(Iso230Figure::E).add(down.mean, i);
        at(Iso230Figure::RUp).add(up.repeatability, i);
        at(Iso230Figure::RDown).add(down.repeatability, i);
        at(Iso230Figure::R).add(target.repeatability, i);
        at(Iso230Figure::AUp).add(up.high, up.low, i);
        at(Iso230Figure::ADown).add(down.high, down.low, i);
        at(Iso230Figure::A).add(up.high, up.low, i);
        at(Iso230Figure::A).add(down.high, down.low, i);
    }
    for (const Iso230Figure figure : allFigures) {
        const bool isMaximum = figure == Iso230Figure::B || figure == Iso230Figure::R
            || figure == Iso230Figure::RUp || figure == Iso230Figure::RDown;
        result.axis[static_cast<std::size_t>(figure)] =
            isMaximum ? at(figure).maximum() : at(figure).range();
    }
    result.axis[static_cast<std::size_t>(Iso230Figure::MeanReversal)] = {
        meanReversal(result.targets), 0, 0};
}

} // namespace

std::span<const Iso230Figure> allIso230Figures()
{
    return allFigures;
}

std::string_view figureName(Iso230Figure figure)
{
    return figureRows[static_cast<std::size_t>(figure)].name;
}

std::optional<Iso230Figure> figureNamed(std::string_view name)
{
    for (const FigureRow& row : figureRows)
        if (sameLetters(name, row.name) || sameLetters(name, row.otherName))
            return row.figure;
    return std::nullopt;
}

TextPattern figureText(Iso230Figure figure)
{
    return figureRows[static_cast<std::size_t>(figure)].words;
}

Iso230Figures iso230Figures(const Measurement& measurement)
{
    // Values stand by direction, target and run: those of one target and direction follow each
    // other.
    Iso230Figures result;
    std::vector<TargetFigures> targets(measurement.targets.size());
    std::vector<double> group;
    const std::vector<RunValue>& values = measurement.values;
    for (std::size_t begin = 0; begin < values.size();) {
        group.clear();
        std::size_t end = begin;
        for (; end < values.size() && values[end].target == values[begin].target
             && values[end].direction == values[begin].direction;
             ++end)
            if (values[end].isUsed)
                group.push_back(values[end].deviation);
        TargetFigures& target = targets[values[begin].target];
        (values[begin].direction == Approach::Up ? target.up : target.down) =
            directionFigures(group);
        begin = end;
    }
    for (std::size_t i = 0; i < targets.size(); ++i) {
        if (targets[i].up.n == 0 && targets[i].down.n == 0)
            continue;
        targets[i].target = i;
        targets[i].position = measurement.targets[i];
        combineDirections(targets[i]);
        result.targets.push_back(targets[i]);
    }
    judgeAxis(result);
    if (!targetsWithoutValues(measurement).empty())
        for (AxisFigure& figure : result.axis)
            figure.value.reset();
    return result;
}

std::span<const Iso230Figure> shownIso230Figures()
{
    using F = Iso230Figure;
    static constexpr std::array shown{F::A, F::AUp, F::ADown, F::R, F::RUp, F::RDown, F::E, F::EUp,
        F::EDown, F::B, F::MeanReversal, F::M};
    return shown;
}

std::string_view figureSymbol(Iso230Figure figure)
{
    switch (figure) {
    case Iso230Figure::MeanReversal:
        return "Bm";
    case Iso230Figure::AUp:
        return "A↑";
    case Iso230Figure::ADown:
        return "A↓";
    case Iso230Figure::EUp:
        return "E↑";
    case Iso230Figure::EDown:
        return "E↓";
    case Iso230Figure::RUp:
        return "R↑";
    case Iso230Figure::RDown:
        return "R↓";
    case Iso230Figure::A:
    case Iso230Figure::B:
    case Iso230Figure::E:
    case Iso230Figure::M:
    case Iso230Figure::R:
        break;
    }
    return figureName(figure);
}

bool isRange(Iso230Figure figure)
{
    switch (figure) {
    case Iso230Figure::A:
    case Iso230Figure::AUp:
    case Iso230Figure::ADown:
    case Iso230Figure::E:
    case Iso230Figure::EUp:
    case Iso230Figure::EDown:
    case Iso230Figure::M:
        return true;
    case Iso230Figure::B:
    case Iso230Figure::MeanReversal:
    case Iso230Figure::R:
    case Iso230Figure::RUp:
    case Iso230Figure::RDown:
        break;
    }
    return false;
}

Iso230Figure figureStandingFor(Iso230Figure figure, const Iso230Figures& figures)
{
    const auto only = onlyDirection(figures);
    if (!only)
        return figure;
    const bool isUp = *only == Approach::Up;
    if (figure == Iso230Figure::A)
        return isUp ? Iso230Figure::AUp : Iso230Figure::ADown;
    if (figure == Iso230Figure::R)
        return isUp ? Iso230Figure::RUp : Iso230Figure::RDown;
    if (figure == Iso230Figure::E || figure == Iso230Figure::M)
        return isUp ? Iso230Figure::EUp : Iso230Figure::EDown;
    return figure;
}

std::vector<Iso230Figure> figuresInShort(const Iso230Figures& figures)
{
    std::vector<Iso230Figure> inShort{
        Iso230Figure::A, Iso230Figure::R, Iso230Figure::E, Iso230Figure::B, Iso230Figure::M};
    if (!onlyDirection(figures))
        return inShort;
    inShort.resize(3); // there is no reversal, and E is M
    for (Iso230Figure& figure : inShort)
        figure = figureStandingFor(figure, figures);
    return inShort;
}

std::vector<double> placesOf(const Iso230Figures& figures, Iso230Figure figure)
{
    const AxisFigure& place = figures[figure];
    if (!place.value || figure == Iso230Figure::MeanReversal)
        return {};
    std::vector<double> places{figures.targets[place.high].position};
    if (isRange(figure) && place.high != place.low)
        places.push_back(figures.targets[place.low].position);
    return places;
}

FigureValues figureValues(const Iso230Figures& figures)
{
    FigureValues result;
    for (const Iso230Figure figure : allIso230Figures())
        result.values[static_cast<std::size_t>(figure)] = figures[figure].value;
    return result;
}

std::optional<double> meanInUse(const TargetFigures& target)
{
    if (target.mean)
        return target.mean;
    return target.up.mean ? target.up.mean : target.down.mean;
}

std::optional<double> standardError(const DirectionFigures& figures)
{
    if (!figures.s)
        return std::nullopt;
    return *figures.s / std::sqrt(static_cast<double>(figures.n));
}

std::optional<double> standardError(const TargetFigures& target)
{
    const auto up = standardError(target.up);
    const auto down = standardError(target.down);
    if (!target.mean)
        return target.up.mean ? up : down;
    if (!up || !down)
        return std::nullopt;
    return 0.5 * portable::hypot(*up, *down);
}

std::vector<std::optional<double>> valuesOfTargets(const Iso230Figures& figures)
{
    std::vector<std::optional<double>> values;
    for (const TargetFigures& target : figures.targets)
        values.insert(values.end(),
            {target.up.mean, target.up.s, target.down.mean, target.down.s, target.mean,
                target.reversal, target.repeatability});
    return values;
}

} // namespace axiscomp
