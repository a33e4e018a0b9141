// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/axis/shown_grid.h"

#include "core/table/table_layout.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace axiscomp {

namespace {

/// Where the drive and the layout of the profile read a table differently.
struct GridDifference {
    TableField field;
    std::size_t dimension = 0;
    double byDrive = 0.0;
    double byLayout = 0.0;
};

bool isElsewhere(double shown, double position, double rounding)
{
    const double single =
        static_cast<double>(std::numeric_limits<float>::epsilon()) * std::abs(position);
    return std::isfinite(shown) && std::abs(shown - position) > std::max(rounding, single);
}

std::optional<GridDifference> differenceOf(const Grid& shown, const Grid& grid)
{
    if (shown.axes.size() != grid.axes.size())
        return GridDifference{TableField::Dimensions, 0, static_cast<double>(shown.axes.size()),
            static_cast<double>(grid.axes.size())};
    for (std::size_t n = 0; n < grid.axes.size(); ++n) {
        const GridAxis& drive = shown.axes[n];
        const GridAxis& axis = grid.axes[n];
        if (drive.size != 0 && drive.size != axis.size)
            return GridDifference{TableField::Size, n, static_cast<double>(drive.size),
                static_cast<double>(axis.size)};
        const double rounding = largestPointShift * axis.distance;
        if (isElsewhere(drive.start, axis.start, rounding))
            return GridDifference{TableField::Start, n, drive.start, axis.start};
        if (isElsewhere(drive.distance, axis.distance, rounding / std::max(1U, axis.size - 1)))
            return GridDifference{TableField::Distance, n, drive.distance, axis.distance};
    }
    return std::nullopt;
}

} // namespace

bool isShownAs(const Grid& shown, const Grid& grid)
{
    return !differenceOf(shown, grid);
}

Result<void> checkShownGrid(
    ErrorCode code, const std::string& slot, const Grid& shown, const Grid& byLayout)
{
    const auto other = differenceOf(shown, byLayout);
    if (!other)
        return {};
    return fail(code,
        {{"layout", Verbatim{"layout.fields." + std::string(tableFieldName(other->field))}},
            {"slot", slot}, {"dimension", other->dimension + 1},
            {"found", Quantity{shortestText(other->byDrive)}},
            {"expected", Quantity{shortestText(other->byLayout)}}});
}

} // namespace axiscomp
