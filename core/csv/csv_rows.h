// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace axiscomp::csv {

/// The rows in the order of the file: the ids of their positions (none for one dimension, where the
/// id is the row) and their values. Kept in blocks, so that nothing is copied while it grows.
class RowStore {
public:
    RowStore() = default;
    RowStore(std::size_t idsPerRow, std::size_t valuesPerRow);

    struct Block {
        std::unique_ptr<std::uint32_t[]> ids; ///< [dimension * blockRows + row]
        std::unique_ptr<float[]> values; ///< [table * blockRows + row]
        std::size_t rows = 0;
    };

    [[nodiscard]] std::size_t blockRows() const { return m_blockRows; }
    [[nodiscard]] const std::vector<Block>& blocks() const { return m_blocks; }
    [[nodiscard]] std::size_t size() const { return m_finished + lastRows(); }
    /// The block with room for the next row, to be filled in place; its rows are then counted up.
    [[nodiscard]] Block& open();

private:
    [[nodiscard]] std::size_t lastRows() const
    {
        return m_blocks.empty() ? 0 : m_blocks.back().rows;
    }

    std::size_t m_idsPerRow = 0;
    std::size_t m_valuesPerRow = 0;
    std::size_t m_blockRows = 1;
    std::size_t m_finished = 0; ///< rows in all blocks but the last
    std::vector<Block> m_blocks;
};

/// What is known of a table's values from their full precision.
struct ValueRange {
    double largest = 0.0; ///< |value|
    double largestError = 0.0; ///< |value - float32(value)|
    std::size_t errorRow = 0;

    void add(double value, float stored, std::size_t row)
    {
        const double size = value < 0.0 ? -value : value;
        const double difference = value - static_cast<double>(stored);
        const double error = difference < 0.0 ? -difference : difference;
        largest = size > largest ? size : largest;
        if (error > largestError) {
            largestError = error;
            errorRow = row;
        }
    }
};

} // namespace axiscomp::csv
