// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/tam_table.h"

#include "core/table/compensation_table.h"
#include "core/table/field_codec.h"
#include "core/text/number_text.h"
#include "core/text/utf8.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace axiscomp {

namespace {

constexpr std::uint32_t tableDimensions = 3;

std::uint64_t saturatedProduct(std::uint64_t a, std::uint64_t b)
{
    constexpr std::uint64_t largest = std::numeric_limits<std::uint64_t>::max();
    return b != 0 && a > largest / b ? largest : a * b;
}

std::string hex(std::uint32_t value)
{
    std::string digits = "0x";
    for (int shift = 28; shift >= 0; shift -= 4)
        digits += "0123456789abcdef"[value >> shift & 0xFU];
    return digits;
}

/// CRC-32 of the header bytes before the CRC, Persistent taken as 0.
std::uint32_t headerCrc(ByteView header, const FieldPlace& crc, const TableLayout& layout)
{
    Bytes covered(header.begin(), header.begin() + crc.offset);
    if (const auto& place = layout.place(TableField::Persistent)) {
        const std::size_t begin = std::min<std::size_t>(place->offset, covered.size());
        const std::size_t end = std::min<std::size_t>(begin + place->byteCount(), covered.size());
        std::fill(covered.begin() + static_cast<std::ptrdiff_t>(begin),
            covered.begin() + static_cast<std::ptrdiff_t>(end), std::byte{0});
    }
    return crc32(covered);
}

/// Checks one file from its first to its last field (docs/tamtbl.md, "Reading").
class Decoder {
public:
    Decoder(ByteView file, const TableLayout& layout) : m_file(file), m_layout(layout) { }

    [[nodiscard]] Result<TamTable> decode();

private:
    [[nodiscard]] Result<void> checkMagic();
    [[nodiscard]] Result<void> checkConstants();
    [[nodiscard]] Result<void> checkSizes();
    [[nodiscard]] Result<void> checkLength();
    [[nodiscard]] Result<void> checkPositions();
    [[nodiscard]] Result<void> checkCrcs();
    [[nodiscard]] Result<void> checkValues();

    [[nodiscard]] ByteView header() const { return m_file.first(m_layout.headerSize); }
    [[nodiscard]] ByteView elements() const { return m_file.subspan(m_layout.headerSize); }
    [[nodiscard]] std::int64_t integer(TableField field, std::uint32_t index = 0) const
    {
        return loadInteger(header(), *m_layout.place(field), index, m_layout.littleEndian);
    }
    [[nodiscard]] double number(TableField field, std::uint32_t index) const
    {
        return loadNumber(header(), *m_layout.place(field), index, m_layout.littleEndian);
    }
    [[nodiscard]] Result<void> equals(TableField field, std::int64_t expected) const;
    [[nodiscard]] GridAxis axis(std::uint32_t index) const;
    [[nodiscard]] CompensationTable table() const;

    [[nodiscard]] static tl::unexpected<Error> invalid(
        Argument field, std::size_t offset, Argument found, Argument expected)
    {
        return fail(ErrorCode::InvalidTable,
            {{"field", std::move(field)}, {"offset", offset}, {"found", std::move(found)},
                {"expected", std::move(expected)}});
    }
    [[nodiscard]] tl::unexpected<Error> invalidLength(Text expected) const
    {
        return invalid(AXISCOMP_TEXT("Error", "file length"), m_file.size(),
            AXISCOMP_TEXT("Error", "{size} bytes").with("size", m_file.size()),
            std::move(expected));
    }
    /// The fault of item `index` of a field.
    [[nodiscard]] tl::unexpected<Error> invalidItem(
        TableField field, std::uint32_t index, Argument found, Argument expected) const
    {
        const FieldPlace& place = *m_layout.place(field);
        std::string name(tableFieldName(field));
        if (place.type != FieldType::Char && place.count > 1)
            name += '[' + std::to_string(index) + ']';
        const std::uint32_t itemSize = place.byteCount() / place.count;
        return invalid(std::move(name), place.offset + std::size_t{itemSize} * index,
            std::move(found), std::move(expected));
    }

    ByteView m_file;
    const TableLayout& m_layout;
    std::uint32_t m_dimensions = 0;
    std::uint64_t m_elementCount = 0;
};

Result<void> Decoder::equals(TableField field, std::int64_t expected) const
{
    if (!m_layout.place(field) || integer(field) == expected)
        return {};
    return invalidItem(field, 0, integer(field), expected);
}

Result<void> Decoder::checkMagic()
{
    const auto& place = m_layout.place(TableField::Magic);
    if (!place)
        return {};
    const std::string_view found = asText(header().subspan(place->offset, place->count));
    if (found == m_layout.magic)
        return {};
    return invalidItem(
        TableField::Magic, 0, '"' + cleanText(found) + '"', '"' + cleanText(m_layout.magic) + '"');
}

Result<void> Decoder::checkConstants()
{
    if (auto checked = equals(TableField::Version, m_layout.version); !checked)
        return checked;
    if (auto checked = equals(TableField::HeaderSize, m_layout.headerSize); !checked)
        return checked;
    if (auto checked = equals(TableField::ElementType, m_layout.elementTypeFloat32); !checked)
        return checked;
    if (m_layout.place(TableField::Persistent)) {
        const std::int64_t persistent = integer(TableField::Persistent);
        if (persistent != 0 && persistent != 1)
            return invalidItem(
                TableField::Persistent, 0, persistent, AXISCOMP_TEXT("Error", "0 or 1"));
    }
    return {};
}

Result<void> Decoder::checkSizes()
{
    std::array<std::int64_t, tableDimensions> sizes{};
    for (std::uint32_t i = 0; i < tableDimensions; ++i)
        sizes[i] = integer(TableField::Size, i);

    const bool tellsDimensions = m_layout.place(TableField::Dimensions).has_value();
    if (tellsDimensions) {
        const std::int64_t dimensions = integer(TableField::Dimensions);
        if (dimensions < 1 || dimensions > tableDimensions)
            return invalidItem(
                TableField::Dimensions, 0, dimensions, AXISCOMP_TEXT("Error", "1, 2 or 3"));
        m_dimensions = static_cast<std::uint32_t>(dimensions);
    } else {
        while (m_dimensions < tableDimensions && sizes[m_dimensions] > 1)
            ++m_dimensions;
        m_dimensions = std::max(m_dimensions, 1U);
    }

    m_elementCount = 1;
    for (std::uint32_t i = 0; i < tableDimensions; ++i) {
        if (i < m_dimensions && sizes[i] < 2)
            return invalidItem(TableField::Size, i, sizes[i], AXISCOMP_TEXT("Error", "2 or more"));
        if (i >= m_dimensions && sizes[i] != 1 && (tellsDimensions || sizes[i] != 0))
            return invalidItem(TableField::Size, i, sizes[i],
                AXISCOMP_TEXT("Error", "1, because this dimension is not used"));
        if (i < m_dimensions)
            m_elementCount = saturatedProduct(m_elementCount, static_cast<std::uint64_t>(sizes[i]));
    }
    return {};
}

Result<void> Decoder::checkLength()
{
    if (m_layout.place(TableField::ElementCount)) {
        const std::int64_t found = integer(TableField::ElementCount);
        if (found < 0 || static_cast<std::uint64_t>(found) != m_elementCount)
            return invalidItem(TableField::ElementCount, 0, found,
                AXISCOMP_TEXT("Error", "{count}, the product of the sizes")
                    .with("count", m_elementCount));
    }
    const std::size_t available = elements().size();
    if (available % sizeof(float) == 0 && available / sizeof(float) == m_elementCount)
        return {};
    return invalidLength(
        AXISCOMP_TEXT("Error", "{size} for the header and 4 for each of the {count} elements")
            .with("size", m_layout.headerSize)
            .with("count", m_elementCount));
}

Result<void> Decoder::checkPositions()
{
    for (std::uint32_t i = 0; i < m_dimensions; ++i) {
        const double start = number(TableField::Start, i);
        if (!std::isfinite(start))
            return invalidItem(TableField::Start, i, Quantity{shortestText(start)},
                AXISCOMP_TEXT("Error", "a finite number"));
        const double distance = number(TableField::Distance, i);
        const Quantity found{shortestText(distance)};
        if (!(distance > 0.0) || !std::isfinite(distance))
            return invalidItem(
                TableField::Distance, i, found, AXISCOMP_TEXT("Error", "a finite number above 0"));
        const GridAxis stored = axis(i);
        if (!std::isfinite(stored.last()))
            return invalidItem(TableField::Distance, i, found,
                AXISCOMP_TEXT("Error", "one that leads to a finite last position"));
        if (!pointsAreDistinct(stored))
            return invalidItem(TableField::Distance, i, found,
                AXISCOMP_TEXT("Error", "one that tells positions such as {position} apart")
                    .with("position", Quantity{shortestText(stored.last())}));
    }
    return {};
}

Result<void> Decoder::checkCrcs()
{
    if (const auto& place = m_layout.place(TableField::HeaderCrc)) {
        const auto found = static_cast<std::uint32_t>(integer(TableField::HeaderCrc));
        const std::uint32_t computed = headerCrc(header(), *place, m_layout);
        if (found != computed)
            return invalidItem(TableField::HeaderCrc, 0, hex(found),
                AXISCOMP_TEXT("Error", "{crc}, the CRC of the header before it")
                    .with("crc", hex(computed)));
    }
    if (m_layout.place(TableField::ElementCrc)) {
        const auto found = static_cast<std::uint32_t>(integer(TableField::ElementCrc));
        const std::uint32_t computed = crc32(elements());
        if (found != computed)
            return invalidItem(TableField::ElementCrc, 0, hex(found),
                AXISCOMP_TEXT("Error", "{crc}, the CRC of the elements")
                    .with("crc", hex(computed)));
    }
    return {};
}

Result<void> Decoder::checkValues()
{
    const ByteView bytes = elements();
    for (std::size_t offset = 0; offset < bytes.size(); offset += sizeof(float)) {
        const auto value = loadAt<float>(bytes.subspan(offset), m_layout.littleEndian);
        if (!std::isfinite(value))
            return invalid(
                AXISCOMP_TEXT("Error", "element {number}").with("number", offset / sizeof(float)),
                m_layout.headerSize + offset, Quantity{shortestText(value)},
                AXISCOMP_TEXT("Error", "a finite number"));
    }
    return {};
}

GridAxis Decoder::axis(std::uint32_t index) const
{
    return {{}, {}, number(TableField::Start, index), number(TableField::Distance, index),
        static_cast<std::uint32_t>(integer(TableField::Size, index))};
}

CompensationTable Decoder::table() const
{
    CompensationTable result;
    if (const auto& place = m_layout.place(TableField::Name))
        result.name = cutAtCharacter(
            shownText(asText(header().subspan(place->offset, place->count))), place->count);
    for (std::uint32_t i = 0; i < m_dimensions; ++i)
        result.grid.axes.push_back(axis(i));

    const ByteView bytes = elements();
    result.values.resize(static_cast<std::size_t>(m_elementCount));
    const auto load = [&](std::size_t fileIndex, std::size_t tableIndex) {
        result.values[tableIndex] =
            loadAt<float>(bytes.subspan(fileIndex * sizeof(float)), m_layout.littleEndian);
    };
    if (m_layout.dimension1Fastest && isNativeOrder(m_layout.littleEndian)) {
        std::memcpy(result.values.data(), bytes.data(), bytes.size());
    } else if (m_layout.dimension1Fastest) {
        for (std::size_t i = 0; i < result.values.size(); ++i)
            load(i, i);
    } else {
        visitLastDimensionFastest(result.grid, load);
    }
    return result;
}

Result<TamTable> Decoder::decode()
{
    if (m_file.size() < m_layout.headerSize)
        return invalidLength(AXISCOMP_TEXT("Error", "at least the {size} bytes of the header")
                                 .with("size", m_layout.headerSize));
    for (const auto check : {&Decoder::checkMagic, &Decoder::checkConstants, &Decoder::checkSizes,
             &Decoder::checkLength, &Decoder::checkPositions, &Decoder::checkCrcs,
             &Decoder::checkValues}) {
        AXISCOMP_CHECK((this->*check)());
    }
    const bool persistent =
        m_layout.place(TableField::Persistent).has_value() && integer(TableField::Persistent) == 1;
    return TamTable{table(), persistent};
}

bool holds(std::size_t fileSize, const FieldPlace& place)
{
    return fileSize >= std::uint64_t{place.offset} + place.byteCount();
}

} // namespace

Result<TamTable> decodeTamTable(ByteView bytes, const TableLayout& layout)
{
    AXISCOMP_CHECK(checkLayout(layout));
    return Decoder(bytes, layout).decode();
}

void setPersistent(std::span<std::byte> file, bool persistent, const TableLayout& layout)
{
    const auto& place = layout.place(TableField::Persistent);
    if (place && holds(file.size(), *place))
        static_cast<void>(storeInteger(file, *place, 0, persistent ? 1 : 0, layout.littleEndian));
}

bool sameTable(ByteView a, ByteView b, const TableLayout& layout)
{
    if (a.size() != b.size())
        return false;
    const auto& place = layout.place(TableField::Persistent);
    if (!place || !holds(a.size(), *place))
        return std::ranges::equal(a, b);
    const std::size_t end = place->offset + place->byteCount();
    return std::ranges::equal(a.first(place->offset), b.first(place->offset))
        && std::ranges::equal(a.subspan(end), b.subspan(end));
}

} // namespace axiscomp
