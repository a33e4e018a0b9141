// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/measured_figures.h"

#include <algorithm>

namespace axiscomp {

namespace {

/// Of the measurements with the table.
std::vector<std::pair<std::string, double>> figuresAfter(const MeasuredFigures& measured)
{
    std::vector<std::pair<std::string, double>> figures;
    for (const MeasuredFigures::Figure& figure : measured.figures)
        if (figure.after)
            figures.emplace_back(figure.name, *figure.after);
    return figures;
}

/// The same numbers in another unit, or of another axis, are another table.
bool areOfOneTable(const MeasuredFigures& next, const MeasuredFigures& kept)
{
    KeptMeaning now = next.meaning();
    if (!next.units)
        now.units = kept.meaning().units;
    return isSameTable(next.table(), kept.table()) && isMeantAsKept(kept.meaning(), now);
}

} // namespace

bool takesPlaceOf(const MeasuredFigures& next, const MeasuredFigures& kept, Measuring measuring)
{
    const auto known = figuresAfter(kept);
    if (known.empty() || !areOfOneTable(next, kept))
        return true;
    const auto found = figuresAfter(next);
    if (found.empty() || isEarlier(next.date, kept.date))
        return false;
    // the same one may be judged by other tolerances
    const bool isSame = next.date == kept.date && found == known;
    return isSame || measuring == Measuring::New || isEarlier(kept.date, next.date);
}

} // namespace axiscomp
