// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/neutral/neutral_table.h"

#include <limits>
#include <vector>

namespace axiscomp::test {

/// Axes 1, 2, ... from -10 to 20 mm; 0 at the position 0.
inline NeutralTable neutralExample(std::size_t dimensions)
{
    NeutralTable table;
    table.sign = SignConvention::Command;
    for (std::size_t n = 1; n <= dimensions; ++n)
        table.axes.push_back({std::to_string(n), "mm", {-10, 0, 10, 20}, {}, 0.0});
    CompensationColumn& column = table.columns.emplace_back();
    column.target = dimensions == 1 ? "1" : "3";
    column.unit = "mm";
    const std::size_t zero = dimensions == 1 ? 1 : dimensions == 2 ? 5 : 21;
    for (std::size_t i = 0; i < table.pointCount(); ++i)
        column.values.push_back(i == zero ? 0.0 : 0.001 * static_cast<double>(i % 7) + 0.0001);
    return table;
}

/// The example with one thing changed: what formats cannot hold, and what nobody should convert.
inline std::vector<NeutralTable> variedTables(std::size_t dimensions)
{
    using Change = void (*)(NeutralTable&);
    static constexpr Change changes[] = {
        [](NeutralTable&) {},
        [](NeutralTable& t) { t.axes[0].knots[2] = 11; },
        [](NeutralTable& t) {
            t.axes[0].knots = {5.5, 15.5, 25.5, 35.5};
        },
        [](NeutralTable& t) {
            t.axes[0].knots = {-13, -3, 7, 17};
        },
        [](NeutralTable& t) {
            t.axes.back().knots = {0, 20, 40, 60};
        },
        [](NeutralTable& t) {
            t.axes[0].knots = {0, 1e-7, 2e-7, 3e-7};
        },
        [](NeutralTable& t) {
            t.axes[0].knots = {0, 1e15, 2e15, 3e15};
        },
        [](NeutralTable& t) {
            t.axes[0].knots = {0, 1e-3, 2e-3, 3.0001e-3};
        },
        [](NeutralTable& t) {
            t.axes[0].knots = {0, 0.00015, 0.0003, 0.00045};
        },
        [](NeutralTable& t) { t.axes[0].wrap = 30; },
        [](NeutralTable& t) { t.axes[0].wrap = 40; },
        [](NeutralTable& t) {
            t.axes[0].wrap = 40;
            t.axes[0].unit = "deg";
            t.columns[0].unit = "deg";
        },
        [](NeutralTable& t) { t.axes[0].wrap = 5; },
        [](NeutralTable& t) { t.axes[0].unit = "deg"; },
        [](NeutralTable& t) { t.axes[0].unit = "kg"; },
        [](NeutralTable& t) { t.axes[0].unit.clear(); },
        [](NeutralTable& t) { t.columns[0].unit = "deg"; },
        [](NeutralTable& t) { t.columns[0].unit = "um"; },
        [](NeutralTable& t) { t.columns[0].unit.clear(); },
        [](NeutralTable& t) { t.axes[0].name = "X"; },
        [](NeutralTable& t) { t.axes[0].name = "a b"; },
        [](NeutralTable& t) { t.axes[0].name = "33"; },
        [](NeutralTable& t) { t.axes[0].name.clear(); },
        [](NeutralTable& t) { t.columns[0].target = "Y"; },
        [](NeutralTable& t) { t.columns[0].target.clear(); },
        [](NeutralTable& t) { t.columns[0].values.assign(t.pointCount(), 1e12); },
        [](NeutralTable& t) { t.columns[0].values.assign(t.pointCount(), 0.5); },
        [](NeutralTable& t) { t.columns[0].values[0] = 1e30; },
        [](NeutralTable& t) { t.columns[0].values[0] = 1e300; },
        [](NeutralTable& t) { t.columns[0].values[0] = 50; },
        [](NeutralTable& t) { t.columns[0].values[0] = -50; },
        [](NeutralTable& t) { t.columns[0].values[0] = std::numeric_limits<double>::infinity(); },
        [](NeutralTable& t) { t.columns[0].values.pop_back(); },
        [](NeutralTable& t) { t.columns.clear(); },
        [](NeutralTable& t) { t.axes.push_back(t.axes[0]); },
        [](NeutralTable& t) { t.axes[0].knots[1] = -10; },
        [](NeutralTable& t) { t.axes[0].knots = {0}; },
        [](NeutralTable& t) { t.columns.push_back(t.columns[0]); },
        [](NeutralTable& t) { t.columns[0].direction = Direction::Positive; },
        [](NeutralTable& t) { t.columns[0].direction = Direction::Negative; },
        [](NeutralTable& t) {
            t.columns.push_back(t.columns[0]);
            t.columns[0].direction = Direction::Positive;
        },
        [](NeutralTable& t) {
            t.columns.push_back(t.columns[0]);
            t.columns[0].direction = t.columns[1].direction = Direction::Negative;
        },
        [](NeutralTable& t) {
            t.columns.push_back(t.columns[0]);
            t.columns[0].direction = t.columns[1].direction = Direction::Positive;
        },
        [](NeutralTable& t) {
            t.columns.push_back(t.columns[0]);
            t.columns[0].direction = Direction::Positive;
            t.columns[1].direction = Direction::Negative;
            t.columns[1].unit = "deg";
        },
        [](NeutralTable& t) { t.sign = SignConvention::Feedback; },
    };
    std::vector<NeutralTable> tables;
    for (const Change change : changes) {
        tables.push_back(neutralExample(dimensions));
        change(tables.back());
    }
    return tables;
}

} // namespace axiscomp::test
