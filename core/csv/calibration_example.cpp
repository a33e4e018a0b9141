// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/portable_math.h"
#include "core/csv/calibration_csv.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace axiscomp {

namespace {

/// The notes of every example; the first names the dimensionality.
std::vector<std::string> exampleNotes(int dimensions)
{
    return {"Example of a calibration file for dimensionality " + std::to_string(dimensions)
            + ": one line per grid point, positions first, then the tables",
        "A value is reference position - encoder position, in the unit of the positions"};
}

Grid exampleGrid(int dimensions)
{
    const std::array<GridAxis, 3> line{GridAxis{"X", "mm", 0.0, 20.0, 11}};
    const std::array<GridAxis, 3> plane{
        GridAxis{"X", "mm", -100.0, 50.0, 5}, GridAxis{"Y", "mm", 0.0, 40.0, 4}};
    const std::array<GridAxis, 3> space{GridAxis{"X", "mm", 0.0, 60.0, 4},
        GridAxis{"Y", "mm", -50.0, 50.0, 3}, GridAxis{"Z", "mm", 0.0, 25.0, 3}};
    const auto& axes = dimensions == 1 ? line : dimensions == 2 ? plane : space;
    return {{axes.begin(), axes.begin() + dimensions}};
}

/// An axis with a wrong scale, a bent guide and a periodic screw: a few micrometres, printed to a
/// hundredth of one.
float exampleValue(const Grid& grid, std::size_t point, int table)
{
    double error = 0.0;
    double weight = 1.0;
    for (const GridAxis& axis : grid.axes) {
        const double t = static_cast<double>(point % axis.size) / (axis.size - 1);
        point /= axis.size;
        const double phase = 0.7 * table;
        error += weight
            * (0.0021 * t - 0.0034 * t * (1.0 - t)
                + 0.0008 * portable::sin(2.0 * std::numbers::pi * (1.7 * t) + phase));
        weight *= -0.6;
    }
    constexpr double perMillimetre = 1e5;
    return static_cast<float>(std::round(error * perMillimetre) / perMillimetre);
}

} // namespace

std::string exampleCalibrationCsv(int dimensions, int tables)
{
    dimensions = std::clamp(dimensions, 1, 3);
    CalibrationData data{exampleGrid(dimensions), {}, exampleNotes(dimensions)};
    for (int i = 0; i < std::max(tables, 1); ++i) {
        CompensationTable table{"Table " + std::to_string(i + 1), "mm", data.grid, {}};
        for (std::size_t point = 0; point < data.grid.pointCount(); ++point)
            table.values.push_back(exampleValue(data.grid, point, i));
        data.tables.push_back(std::move(table));
    }
    return writeCalibrationCsv(data);
}

} // namespace axiscomp
