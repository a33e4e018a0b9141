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
struct Difference {
    TableField field;
    std::size_t dimension = 0;
    double byDrive = 0.0;
    double byLayout = 0.0;
};

bool isOther(double shown, double position, double rounding)
{
    const double single = double(std::numeric_limits<float>::epsilon()) * std::abs(position);
    return std::isfinite(shown) && std::abs(shown - position) > std::max(rounding, single);
}

std::optional<Difference> differenceOf(const Grid& shown, const Grid& grid)
{
    if (shown.axes.size() != grid.axes.size())
        return Difference{
            TableField::Dimensions, 0, double(shown.axes.size()), double(grid.axes.size())};
    for (std::size_t n = 0; n < grid.axes.size(); ++n) {
        const GridAxis& drive = shown.axes[n];
        const GridAxis& axis = grid.axes[n];
        if (drive.size != 0 && drive.size != axis.size)
            return Difference{TableField::Size, n, double(drive.size), double(axis.size)};
        // As much as a file with single precision may move the points.
        const double rounding = 1e-3 * axis.distance;
        if (isOther(drive.start, axis.start, rounding))
            return Difference{TableField::Start, n, drive.start, axis.start};
        if (isOther(drive.distance, axis.distance, rounding / std::max(1U, axis.size - 1)))
            return Difference{TableField::Distance, n, drive.distance, axis.distance};
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
