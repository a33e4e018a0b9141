// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/text/number_parser.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace axiscomp::csv {

/// The positions of one dimension in one piece of a file. A grid repeats few positions often, and
/// in a regular order: each distinct text is parsed once and gets an id, and which text follows
/// which is remembered, so that reading a cell mostly is one comparison. Positions that do not
/// repeat (one dimension, or none of the first rows of a piece) are appended instead; then the id
/// is the row.
class PositionColumn {
public:
    /// text: what all cells are part of; at most 4 GiB. separator: what is behind each of them.
    PositionColumn(std::string_view text, char separator);

    /// Reads a known position and the separator behind it. Returns what follows both; nullptr: the
    /// position is another one than expected. matchReach characters must be readable.
    const char* match(const char* p, std::uint16_t& id)
    {
        const Entry& entry = m_entries[m_expected];
        const Key found = loaded(p);
        if ((((found[0] & entry.mask[0]) ^ entry.text[0])
                | ((found[1] & entry.mask[1]) ^ entry.text[1]))
            != 0)
            return nullptr;
        id = static_cast<std::uint16_t>(m_expected - 1);
        m_last = m_expected;
        m_expected = entry.follower;
        return p + entry.length + 1;
    }
    static constexpr std::size_t matchReach = 16;

    /// The length of the cell at p, if its separator is among matchReach characters.
    [[nodiscard]] std::optional<std::size_t> shortLength(const char* p) const
    {
        const Key found = loaded(p);
        for (std::size_t word = 0; word < found.size(); ++word) {
            // The lowest marked byte is the first separator; higher ones may be none.
            const std::uint64_t others = found[word] ^ m_separators;
            const std::uint64_t marks = (others - everyByte(0x01)) & ~others & everyByte(0x80);
            if (marks != 0)
                return 8 * word + static_cast<std::size_t>(std::countr_zero(marks)) / 8;
        }
        return std::nullopt;
    }

    /// The id of a position at p that has come up before, and whose length shortLength has found.
    [[nodiscard]] std::optional<std::uint16_t> known(const char* p, std::size_t length)
    {
        const Key found = loaded(p);
        const Key& mask = masks[length];
        const std::uint16_t entry = m_slots[slotOf({found[0] & mask[0], found[1] & mask[1]})];
        if (entry == 0)
            return std::nullopt;
        return follow(entry);
    }

    /// The id of any cell, a new one if need be. None: not a number, and why.
    std::optional<std::uint16_t> intern(std::string_view cell, char decimal, NumberFault& fault);

    /// Gives it an id of its own.
    std::uint16_t append(const Number& number)
    {
        m_values.push_back(number.value);
        m_lastDecimal = std::min(m_lastDecimal, number.lastDecimal);
        return static_cast<std::uint16_t>(m_values.size() - 1);
    }

    /// From here on each text gets an id of its own.
    void expectNoRepeats();
    [[nodiscard]] bool expectsRepeats() const { return !m_slots.empty(); }

    /// Keeps the values alone: nothing more is read.
    void close();
    /// In bytes, by the room that it keeps.
    [[nodiscard]] std::size_t memory() const
    {
        return m_values.capacity() * sizeof(double) + m_entries.capacity() * sizeof(Entry)
            + m_slots.capacity() * sizeof(std::uint16_t);
    }

    /// By id. Different texts of the same value are different ids.
    [[nodiscard]] const std::vector<double>& values() const { return m_values; }
    /// The finest one printed.
    [[nodiscard]] int lastDecimal() const { return m_lastDecimal; }

private:
    using Key = std::array<std::uint64_t, 2>; ///< 16 characters

    /// Entry 0 is no text: what is expected before anything is known. The id of entry n is n - 1.
    struct Entry {
        Key text; ///< with the separator behind it, and zeros; what never matches if it is longer
        Key mask;
        std::uint32_t offset; ///< in the text
        std::uint32_t length;
        std::uint32_t follower; ///< what came after it the last time
    };

    static constexpr std::size_t keyLength = matchReach - 1;
    /// By the length of a text: of its characters, and of the separator behind it.
    static constexpr std::array<Key, matchReach> masks = [] {
        std::array<Key, matchReach> result{};
        for (std::size_t length = 0; length < matchReach; ++length)
            for (std::size_t i = 0; i <= length; ++i)
                result[length][i / 8] |= std::uint64_t{0xFF} << (i % 8 * 8);
        return result;
    }();

    static constexpr std::uint64_t everyByte(std::uint8_t byte)
    {
        return 0x0101010101010101U * byte;
    }
    [[nodiscard]] static Key loaded(const char* p)
    {
        static_assert(std::endian::native == std::endian::little);
        Key key;
        std::memcpy(key.data(), p, sizeof key);
        return key;
    }
    [[nodiscard]] std::string_view textOf(std::uint32_t entry) const
    {
        return m_text.substr(m_entries[entry].offset, m_entries[entry].length);
    }
    /// Without branches; == of arrays is a call of memcmp.
    [[nodiscard]] static bool isSame(const Key& a, const Key& b)
    {
        return ((a[0] ^ b[0]) | (a[1] ^ b[1])) == 0;
    }
    [[nodiscard]] Key keyOf(std::string_view cell) const;
    [[nodiscard]] static std::uint64_t hashOf(const Key& key)
    {
        // Odd numbers without a pattern. A product's upper bits depend on all lower ones of its
        // factor.
        std::uint64_t hash = key[0] ^ (key[1] * 0xC2B2AE3D27D4EB4FU);
        hash = (hash ^ (hash >> 32U)) * 0x9E3779B97F4A7C15U;
        return hash >> 32U;
    }
    /// Where a text of at most keyLength characters stands, or has its place.
    [[nodiscard]] std::size_t slotOf(const Key& key) const
    {
        const std::size_t mask = m_slots.size() - 1;
        std::size_t slot = hashOf(key) & mask;
        while (!isSame(m_entries[m_slots[slot]].text, key) && m_slots[slot] != 0)
            slot = (slot + 1) & mask;
        return slot;
    }
    [[nodiscard]] std::size_t slotOf(const Key& key, std::string_view cell) const;
    std::uint16_t follow(std::uint16_t entry)
    {
        m_entries[m_last].follower = entry;
        m_last = entry;
        m_expected = m_entries[entry].follower;
        return static_cast<std::uint16_t>(entry - 1);
    }
    NumberFault parse(std::string_view cell, char decimal, Number& number) const;
    std::uint16_t add(const Key& key, std::string_view cell);
    void grow();

    std::string_view m_text;
    std::uint64_t m_separators; ///< eight of them
    std::vector<Entry> m_entries;
    std::vector<std::uint16_t> m_slots; ///< entries, 0: free; open addressing, at most half full
    std::vector<double> m_values;
    std::uint32_t m_last = 0;
    std::uint32_t m_expected = 0;
    int m_lastDecimal = std::numeric_limits<int>::max();
};

/// Rows in the order of the file: the ids of their positions (none for one dimension, where the id
/// is the row) and their values. Kept in blocks, so that nothing is copied while it grows.
class RowStore {
public:
    RowStore() = default;
    RowStore(std::size_t idsPerRow, std::size_t valuesPerRow);

    struct Block {
        std::unique_ptr<std::uint16_t[]> ids; ///< [dimension * blockRows + row]
        std::unique_ptr<float[]> values; ///< [table * blockRows + row]
        std::size_t rows = 0;
    };

    [[nodiscard]] std::size_t blockRows() const { return m_blockRows; }
    [[nodiscard]] const std::vector<Block>& blocks() const { return m_blocks; }
    [[nodiscard]] std::size_t size() const
    {
        return m_blocks.empty() ? 0 : (m_blocks.size() - 1) * m_blockRows + m_blocks.back().rows;
    }
    /// The block with room for the next row, to be filled in place; its rows are then counted up.
    [[nodiscard]] Block& open();

private:
    std::size_t m_idsPerRow = 0;
    std::size_t m_valuesPerRow = 0;
    std::size_t m_blockRows = 1;
    std::vector<Block> m_blocks;
};

/// What is known of a table's values from their full precision.
struct ValueRange {
    double largest = 0.0; ///< |value|
    double largestError = 0.0; ///< |value - float32(value)|
    std::size_t errorRow = 0;

    void add(double value, float stored, std::size_t row)
    {
        largest = std::max(largest, std::fabs(value));
        const double error = std::fabs(value - static_cast<double>(stored));
        if (error > largestError) {
            largestError = error;
            errorRow = row;
        }
    }
    /// Of rows that follow; firstRow: the row of the file that is their row 0.
    void add(const ValueRange& following, std::size_t firstRow)
    {
        largest = std::max(largest, following.largest);
        if (following.largestError > largestError) {
            largestError = following.largestError;
            errorRow = firstRow + following.errorRow;
        }
    }
};

/// A piece of the file, which one thread reads: its data lines, in their order.
struct Piece {
    std::vector<PositionColumn> positions; ///< per dimension
    RowStore rows;
    std::vector<ValueRange> ranges; ///< per table, by the rows of the piece; while it is read
    std::size_t firstRow = 0; ///< in the file
    std::array<std::size_t, 3> firstId{}; ///< per dimension, among those of all pieces

    Piece(std::string_view text, char separator, std::size_t dimensions, std::size_t tables)
        : positions(dimensions, PositionColumn(text, separator))
        , rows(dimensions == 1 ? 0 : dimensions, tables)
        , ranges(tables)
    {
    }
};

} // namespace axiscomp::csv
