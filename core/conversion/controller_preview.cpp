// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/controller_preview.h"

#include "core/conversion/lookup_sides.h"
#include "core/conversion/sign_conversion.h"
#include "core/formats/format_writer.h"
#include "core/formats/formats.h"
#include "core/formats/triamec/triamec_tables.h"

#include <algorithm>

namespace axiscomp {

namespace {

/// A tenth of the table beyond each end.
Grid widened(Grid grid)
{
    constexpr std::uint32_t part = 10;
    for (GridAxis& axis : grid.axes) {
        const std::uint32_t more = std::max(axis.size / part, std::uint32_t{1});
        axis.start -= axis.distance * more;
        axis.size += 2 * more;
    }
    return grid;
}

/// With axes that roll over. From the last value of a table that does not close one more interval
/// leads to the first one, as in its file: looked at are the points alone, none of which is
/// between.
NeutralTable rollingOver(NeutralTable table)
{
    for (std::size_t n = 0; n < table.axes.size(); ++n) {
        SourceAxis& axis = table.axes[n];
        const double span = axis.knots.back() - axis.knots.front();
        const auto intervals = static_cast<double>(axis.knots.size() - 1);
        axis.wrap = isClosed(table, n) ? span : span + span / intervals;
    }
    return table;
}

std::vector<float> valuesAt(const Grid& grid, const ControllerLookup& applied)
{
    std::vector<float> values;
    values.reserve(grid.pointCount());
    for (std::size_t point = 0; point < grid.pointCount(); ++point)
        values.push_back(static_cast<float>(applied.at(positionOf(grid, point))));
    return values;
}

} // namespace

Result<CompensationTable> tableAsAppliedBy(
    const CompensationTable& table, const AxisPlace& place, const FormatFacts& facts)
{
    NeutralTable neutral = neutralTable(CalibrationData{table.grid, {table}, {}});
    const bool isOfDrive = &facts == &calibration_csv::format().facts;
    if (place.lookupAt == LookupAt::Set && !isOfDrive)
        neutral = withTurnedSigns(std::move(neutral), SignConvention::Command);
    if (facts.sign != neutral.sign) {
        if (neutral.columns.front().target.empty())
            neutral.columns.front().target = place.target;
        AXISCOMP_TRY(auto converted,
            convertSign(neutral, facts.sign, calibration_csv::format().facts.behaviour));
        neutral = std::move(converted.table);
    }
    if (facts.behaviour.outside == Outside::Wrap)
        neutral = rollingOver(std::move(neutral));
    CompensationTable applied{table.name, table.unit, widened(table.grid), {}};
    applied.values = valuesAt(applied.grid, ControllerLookup(neutral, 0, facts.behaviour));
    return applied;
}

std::vector<const TableFormat*> controllersFor(int dimensions)
{
    std::vector<const TableFormat*> formats;
    for (const TableFormat* format : tableFormats()) {
        const FormatFacts& facts = format->facts;
        const bool isKnown = std::ranges::any_of(formats, [&](const TableFormat* known) {
            return known->facts.controller == facts.controller && known->facts.sign == facts.sign;
        });
        if (!isTriamec(*format) && !isKnown && dimensions >= facts.fewestDimensions
            && dimensions <= facts.mostDimensions)
            formats.push_back(format);
    }
    return formats;
}

} // namespace axiscomp
