// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/core/formats/format_checks.h"

#include <functional>

namespace axiscomp::test {

constexpr TableBehaviour held{.outside = Outside::Hold};
constexpr TableBehaviour zeroOutside{.outside = Outside::Zero};
constexpr TableBehaviour goingOn{.outside = Outside::Extrapolate};

/// A value at a position.
using Formula = std::function<double(const std::vector<double>&)>;

inline std::vector<double> positionOf(const NeutralTable& table, std::size_t index)
{
    std::vector<double> position;
    for (const SourceAxis& axis : table.axes) {
        position.push_back(axis.knots[index % axis.knots.size()]);
        index /= axis.knots.size();
    }
    return position;
}

inline void addColumn(NeutralTable& table, const std::string& target, const Formula& formula,
    Direction direction = Direction::Both)
{
    CompensationColumn column;
    column.target = target;
    column.unit = table.axes.front().unit;
    column.direction = direction;
    for (std::size_t i = 0; i < table.pointCount(); ++i)
        column.values.push_back(formula(positionOf(table, i)));
    table.columns.push_back(std::move(column));
}

inline NeutralTable tableOver(std::vector<SourceAxis> axes, const std::string& target,
    const Formula& formula, SignConvention sign = SignConvention::Feedback)
{
    NeutralTable table;
    table.axes = std::move(axes);
    table.sign = sign;
    addColumn(table, target, formula);
    return table;
}

/// X with knots, in mm.
inline SourceAxis axisX(std::vector<double> knots)
{
    SourceAxis axis;
    axis.name = "X";
    axis.unit = "mm";
    axis.knots = std::move(knots);
    return axis;
}

/// C over one turn in degrees, closed.
inline SourceAxis turningAxis(std::size_t count)
{
    SourceAxis axis = evenAxis("C", "deg", 0, 360.0 / static_cast<double>(count - 1), count);
    axis.wrap = 360.0;
    return axis;
}

/// The largest difference of slopes of a column between neighbouring cells of any axis.
inline double largestKink(const NeutralTable& table, std::size_t column = 0)
{
    double largest = 0.0;
    std::size_t stride = 1;
    for (const SourceAxis& axis : table.axes) {
        const std::size_t count = axis.knots.size();
        const std::vector<double>& values = table.columns[column].values;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const std::size_t k = i / stride % count;
            if (k == 0 || k + 1 == count)
                continue;
            const double before =
                (values[i] - values[i - stride]) / (axis.knots[k] - axis.knots[k - 1]);
            const double behind =
                (values[i + stride] - values[i]) / (axis.knots[k + 1] - axis.knots[k]);
            largest = std::max(largest, std::abs(behind - before));
        }
        stride *= count;
    }
    return largest;
}

inline double largestSize(const std::vector<double>& values)
{
    double largest = 0.0;
    for (const double value : values)
        largest = std::max(largest, std::abs(value));
    return largest;
}

} // namespace axiscomp::test
