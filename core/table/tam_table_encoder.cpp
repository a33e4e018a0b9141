// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/compensation_table.h"
#include "core/table/field_codec.h"
#include "core/table/tam_table.h"
#include "core/text/number_text.h"
#include "core/text/utf8.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace axiscomp {

namespace {

tl::unexpected<Error> refused(Text reason)
{
    return fail(ErrorCode::InvalidArgument, {{"reason", std::move(reason)}});
}

Result<void> checkAxis(const GridAxis& axis, std::size_t index)
{
    const auto wrong = [&](const TextPattern& pattern, Argument value) {
        return refused(pattern.with("dimension", index + 1).with("value", std::move(value)));
    };
    if (axis.size < 2)
        return wrong(AXISCOMP_TEXT("Error",
                         "the size of dimension {dimension} is {value}, at least 2 is needed"),
            axis.size);
    if (!std::isfinite(axis.start))
        return wrong(
            AXISCOMP_TEXT("Error",
                "the start value of dimension {dimension} is {value}, a finite number is needed"),
            Quantity{shortestText(axis.start)});
    if (!(axis.distance > 0.0) || !std::isfinite(axis.distance))
        return wrong(AXISCOMP_TEXT("Error",
                         "the distance of dimension {dimension} is {value}, a finite number above "
                         "0 is needed"),
            Quantity{shortestText(axis.distance)});
    if (!std::isfinite(axis.last()))
        return refused(AXISCOMP_TEXT(
            "Error", "the last position of dimension {dimension} is too large to be a number")
                           .with("dimension", index + 1));
    if (!pointsAreDistinct(axis))
        return refused(AXISCOMP_TEXT("Error",
            "the distance of dimension {dimension} is {value}, too little to tell positions such "
            "as {position} apart")
                           .with("dimension", index + 1)
                           .with("value", Quantity{shortestText(axis.distance)})
                           .with("position", Quantity{shortestText(axis.last())}));
    return {};
}

Result<void> checkTable(const CompensationTable& table)
{
    if (table.grid.axes.empty() || table.grid.axes.size() > 3)
        return refused(
            AXISCOMP_TEXT("Error", "the table has {count} dimensions, 1 to 3 are possible")
                .with("count", table.grid.axes.size()));
    // the product is compared by division, so that it cannot overflow
    std::size_t remaining = table.values.size();
    bool matches = true;
    for (std::size_t i = 0; i < table.grid.axes.size(); ++i) {
        const GridAxis& axis = table.grid.axes[i];
        if (auto checked = checkAxis(axis, i); !checked)
            return checked;
        matches = matches && remaining % axis.size == 0;
        remaining /= axis.size;
    }
    if (!matches || remaining != 1)
        return refused(AXISCOMP_TEXT(
            "Error", "the table has {count} values, which is not the product of its sizes")
                           .with("count", table.values.size()));
    if (table.values.size() > std::numeric_limits<std::uint32_t>::max())
        return refused(AXISCOMP_TEXT("Error", "the table has more values than a file can count"));
    // one pass without a branch: an exponent of all ones is infinite or not a number
    std::uint32_t notFinite = 0;
    for (const float value : table.values)
        notFinite |= static_cast<std::uint32_t>(
            (std::bit_cast<std::uint32_t>(value) & 0x7F800000U) == 0x7F800000U);
    if (notFinite != 0) {
        const auto found = std::ranges::find_if_not(
            table.values, [](float value) { return std::isfinite(value); });
        return refused(
            AXISCOMP_TEXT("Error", "value {number} is {value}, a finite number is needed")
                .with("number", found - table.values.begin() + 1)
                .with("value", Quantity{shortestText(static_cast<double>(*found))}));
    }
    return {};
}

bool rounds(double& value, FieldType type)
{
    if (type != FieldType::F32)
        return true;
    if (std::abs(value) > static_cast<double>(std::numeric_limits<float>::max()))
        return false;
    value = static_cast<double>(static_cast<float>(value));
    return true;
}

bool isSameGrid(const GridAxis& wanted, const GridAxis& stored)
{
    const double shift =
        std::max(std::abs(stored.start - wanted.start), std::abs(stored.last() - wanted.last()));
    return stored.distance > 0.0 && shift <= largestPointShift * wanted.distance;
}

/// As fields of these types hold it; nothing where they cannot.
std::optional<GridAxis> storedAxis(const GridAxis& axis, FieldType start, FieldType distance)
{
    GridAxis stored = axis;
    if (!rounds(stored.start, start) || !rounds(stored.distance, distance)
        || !isSameGrid(axis, stored))
        return std::nullopt;
    return stored;
}

/// Writes the header of one file, field by field; keeps the first fault.
class HeaderWriter {
public:
    HeaderWriter(std::span<std::byte> header, const TableLayout& layout)
        : m_header(header)
        , m_layout(layout)
    {
    }

    void integer(TableField field, std::int64_t value, std::uint32_t index = 0)
    {
        const auto& place = m_layout.place(field);
        if (place && !storeInteger(m_header, *place, index, value, m_layout.littleEndian)
            && m_fault.isEmpty())
            m_fault = AXISCOMP_TEXT(
                "Error", "{value} does not fit into the field {field}, which is of type {type}")
                          .with("value", value)
                          .with("field", tableFieldName(field))
                          .with("type", fieldTypeName(place->type));
    }

    void characters(TableField field, std::string_view content)
    {
        if (const auto& place = m_layout.place(field))
            std::ranges::copy(asBytes(cutAtCharacter(content, place->count)),
                m_header.subspan(place->offset).begin());
    }

    void position(const GridAxis& axis, std::uint32_t index)
    {
        const FieldPlace& start = *m_layout.place(TableField::Start);
        const FieldPlace& distance = *m_layout.place(TableField::Distance);
        const auto stored = storedAxis(axis, start.type, distance.type);
        if (!stored) {
            if (m_fault.isEmpty())
                m_fault = AXISCOMP_TEXT("Error",
                    "the grid of dimension {dimension}, start {start} and distance {distance}, "
                    "cannot be held by fields of the types {first} and {second}")
                              .with("dimension", index + 1)
                              .with("start", Quantity{shortestText(axis.start)})
                              .with("distance", Quantity{shortestText(axis.distance)})
                              .with("first", fieldTypeName(start.type))
                              .with("second", fieldTypeName(distance.type));
            return;
        }
        storeNumber(m_header, start, index, stored->start, m_layout.littleEndian);
        storeNumber(m_header, distance, index, stored->distance, m_layout.littleEndian);
    }

    [[nodiscard]] const Text& fault() const { return m_fault; }

private:
    std::span<std::byte> m_header;
    const TableLayout& m_layout;
    Text m_fault;
};

void writeElements(
    std::span<std::byte> file, const CompensationTable& table, const TableLayout& layout)
{
    const std::span<std::byte> elements = file.subspan(layout.headerSize);
    const auto store = [&](std::size_t fileIndex, std::size_t tableIndex) {
        storeAt(elements.subspan(fileIndex * sizeof(float)), table.values[tableIndex],
            layout.littleEndian);
    };
    if (layout.dimension1Fastest && isNativeOrder(layout.littleEndian)) {
        std::memcpy(elements.data(), table.values.data(), elements.size());
    } else if (layout.dimension1Fastest) {
        for (std::size_t i = 0; i < table.values.size(); ++i)
            store(i, i);
    } else {
        visitLastDimensionFastest(table.grid, store);
    }
}

} // namespace

Result<Bytes> encodeTamTable(
    const CompensationTable& table, bool persistent, const TableLayout& layout)
{
    AXISCOMP_CHECK(checkLayout(layout));
    AXISCOMP_CHECK(checkTable(table));

    Bytes file(tamTableSize(table.grid, layout));
    writeElements(file, table, layout);

    const std::span<std::byte> header = std::span(file).first(layout.headerSize);
    HeaderWriter writer(header, layout);
    writer.characters(TableField::Magic, layout.magic);
    writer.integer(TableField::Version, layout.version);
    writer.integer(TableField::HeaderSize, layout.headerSize);
    writer.integer(TableField::ElementType, layout.elementTypeFloat32);
    writer.integer(TableField::Dimensions, table.grid.dimensions());
    for (std::uint32_t i = 0; i < 3; ++i) {
        const bool isUsed = i < table.grid.axes.size();
        writer.integer(TableField::Size, isUsed ? table.grid.axes[i].size : 1, i);
        if (isUsed)
            writer.position(table.grid.axes[i], i);
    }
    writer.integer(TableField::ElementCount, static_cast<std::int64_t>(table.values.size()));
    if (layout.place(TableField::ElementCrc))
        writer.integer(TableField::ElementCrc, crc32(std::span(file).subspan(layout.headerSize)));
    writer.characters(TableField::Name, cleanText(table.name));
    // last, and while Persistent is still 0, which is what the CRC covers
    if (const auto& place = layout.place(TableField::HeaderCrc))
        writer.integer(TableField::HeaderCrc, crc32(header.first(place->offset)));
    if (!writer.fault().isEmpty())
        return refused(
            AXISCOMP_TEXT("Error", "the table cannot be kept in this drive's table file: {reason}")
                .with("reason", writer.fault()));
    setPersistent(file, persistent, layout);
    return file;
}

Result<std::uint32_t> elementCrc(const CompensationTable& table, const TableLayout& layout)
{
    AXISCOMP_TRY(const auto file, encodeTamTable(table, false, layout));
    // The elements are the end of every file.
    return crc32(std::span(file).last(table.values.size() * sizeof(float)));
}

Grid storedGrid(Grid grid, const TableLayout& layout)
{
    const auto& start = layout.place(TableField::Start);
    const auto& distance = layout.place(TableField::Distance);
    for (GridAxis& axis : grid.axes)
        if (start && distance)
            axis = storedAxis(axis, start->type, distance->type).value_or(axis);
    return grid;
}

std::size_t tamTableSize(const Grid& grid, const TableLayout& layout)
{
    return layout.headerSize + grid.pointCount() * sizeof(float);
}

} // namespace axiscomp
