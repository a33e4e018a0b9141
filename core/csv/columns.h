// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/text/number_parser.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace axiscomp::csv {

/// The positions of one dimension. A grid repeats few positions often, and in a regular order: each
/// distinct text is parsed once and gets an id, and which text follows which is remembered, so that
/// reading a cell mostly is one comparison. Positions that do not repeat (one dimension) are
/// appended instead; then the id is the row.
class PositionColumn {
public:
    /// text: what all cells are part of; at most 4 GiB.
    explicit PositionColumn(std::string_view text) : m_text(text) { }

    /// Reads a known position and the separator behind it, and moves p past both. False: the next
    /// position is another one, or unknown. matchReach characters must be readable.
    bool match(const char*& p, const char* end, char separator, std::uint32_t& id)
    {
        const std::uint32_t candidate = m_entries.empty() ? none : m_entries[m_last].follower;
        if (candidate != none && matches(candidate, p, end, separator)) {
            p += m_entries[candidate].length + 1;
            id = m_last = candidate;
            return true;
        }
        return false;
    }
    static constexpr std::size_t matchReach = 24;

    /// The id of any cell, new ones included. None: not a number, and why.
    std::optional<std::uint32_t> intern(std::string_view cell, char decimal, NumberFault& fault);

    void append(const Number& number)
    {
        m_values.push_back(number.value);
        m_lastDecimal = std::min(m_lastDecimal, number.lastDecimal);
    }

    /// By id. Different texts of the same value are different ids.
    [[nodiscard]] const std::vector<double>& values() const { return m_values; }
    /// The finest one printed.
    [[nodiscard]] int lastDecimal() const { return m_lastDecimal; }

private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    static constexpr std::size_t inlineLength = 16;

    struct Entry {
        std::uint64_t head[2]; ///< the first 16 characters, zero behind the end
        std::uint32_t offset; ///< in the text
        std::uint32_t follower; ///< what came after it the last time
        std::uint32_t length;
    };

    [[nodiscard]] static std::uint64_t load(const char* p, std::size_t length)
    {
        std::uint64_t word = 0;
        std::memcpy(&word, p, sizeof word);
        return length >= 8 ? word : word & ((std::uint64_t{1} << (8 * length)) - 1);
    }
    [[nodiscard]] bool matches(
        std::uint32_t id, const char* p, const char* end, char separator) const
    {
        const Entry& entry = m_entries[id];
        const std::size_t length = entry.length;
        if (length <= 8)
            return load(p, length) == entry.head[0] && p[length] == separator;
        if (length <= inlineLength)
            return load(p, 8) == entry.head[0] && load(p + 8, length - 8) == entry.head[1]
                && p[length] == separator;
        return static_cast<std::size_t>(end - p) > length
            && std::memcmp(p, m_text.data() + entry.offset, length) == 0 && p[length] == separator;
    }
    [[nodiscard]] std::string_view textOf(std::uint32_t id) const
    {
        return m_text.substr(m_entries[id].offset, m_entries[id].length);
    }
    std::uint32_t* slotOf(std::string_view cell);
    std::uint32_t add(std::string_view cell, const Number& number);
    void grow();

    std::string_view m_text;
    std::vector<Entry> m_entries;
    std::vector<std::uint32_t> m_slots; ///< open addressing, at most half full
    std::vector<double> m_values;
    std::uint32_t m_last = 0;
    int m_lastDecimal = std::numeric_limits<int>::max();
};

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
