// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/table_math.h"

#include <memory>
#include <optional>

namespace axiscomp::ui {

/// What a small picture shows of a table, or of the difference of two.
struct TablePicture {
    std::shared_ptr<const CompensationTable> drawn; ///< 1 or 2 dimensions; null: there is nothing
    std::optional<double> cutAt; ///< of the third dimension, when drawn is a slice across it
    Grid grid; ///< of the whole table
    LargestChange largest; ///< of all slices, with its position
};

/// A table and the one that takes its place. Both are drawn to one scale; the difference, which is
/// new - old, has its own.
struct TableChange {
    TablePicture before;
    TablePicture after;
    /// Over both grids. Nothing is drawn where sources or dimensions differ: its largest value is a
    /// bound then.
    TablePicture difference;
    [[nodiscard]] double scale() const;
};

/// Either may be null. sources: of the one beside those of the other. Takes a while for the largest
/// tables: not for the window's thread.
[[nodiscard]] TableChange tableChange(const std::shared_ptr<const CompensationTable>& newTable,
    const std::shared_ptr<const CompensationTable>& oldTable,
    TableSources sources = TableSources::Same);

} // namespace axiscomp::ui
