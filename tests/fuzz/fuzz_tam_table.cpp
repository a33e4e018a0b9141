// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/field_codec.h"
#include "core/table/lookup.h"
#include "core/table/tam_table.h"
#include "tests/fuzz/expect.h"

#include <cmath>
#include <cstdint>

using namespace axiscomp;

namespace {

/// The generic layout and what other drives might have: byte order, element order, fewer fields.
TableLayout layoutOf(unsigned choice)
{
    TableLayout layout = genericTableLayout();
    layout.littleEndian = (choice & 1U) == 0;
    layout.dimension1Fastest = (choice & 2U) == 0;
    if ((choice & 4U) != 0)
        layout.place(TableField::Dimensions).reset();
    if ((choice & 8U) != 0) {
        for (const TableField field : {TableField::Magic, TableField::Version,
                 TableField::HeaderSize, TableField::ElementType, TableField::ElementCount,
                 TableField::ElementCrc, TableField::HeaderCrc})
            layout.place(field).reset();
    }
    return layout;
}

/// Right CRCs, so that the fuzzer comes past them.
void repairCrcs(Bytes& file, const TableLayout& layout)
{
    if (file.size() < layout.headerSize)
        return;
    const std::span<std::byte> header = std::span(file).first(layout.headerSize);
    if (const auto& place = layout.place(TableField::ElementCrc))
        storeAt(header.subspan(place->offset), crc32(std::span(file).subspan(layout.headerSize)),
            layout.littleEndian);
    if (const auto& place = layout.place(TableField::HeaderCrc)) {
        Bytes covered(header.begin(), header.begin() + place->offset);
        const FieldPlace& persistent = *layout.place(TableField::Persistent);
        std::fill_n(covered.begin() + persistent.offset, persistent.byteCount(), std::byte{0});
        storeAt(header.subspan(place->offset), crc32(covered), layout.littleEndian);
    }
}

void expectUsable(const TamTable& decoded, const TableLayout& layout)
{
    const CompensationTable& table = decoded.table;
    FUZZ_EXPECT(table.grid.dimensions() >= 1 && table.grid.dimensions() <= 3);
    FUZZ_EXPECT(table.values.size() == table.grid.pointCount());

    const auto encoded = encodeTamTable(table, decoded.persistent, layout);
    FUZZ_EXPECT(encoded.has_value());
    const auto again = decodeTamTable(*encoded, layout);
    FUZZ_EXPECT(again.has_value());
    FUZZ_EXPECT(again->table == table && again->persistent == decoded.persistent);

    for (const Outside outside :
        {Outside::Hold, Outside::Zero, Outside::Wrap, Outside::Extrapolate, Outside::Error}) {
        const Lookup lookup(table, outside);
        std::array<double, 3> first{};
        std::array<double, 3> last{};
        for (std::size_t i = 0; i < table.grid.axes.size(); ++i) {
            first[i] = table.grid.axes[i].start;
            last[i] = table.grid.axes[i].last();
        }
        const std::size_t dimensions = table.grid.axes.size();
        FUZZ_EXPECT(lookup.at(std::span(first).first(dimensions))
            == static_cast<double>(table.values.front()));
        FUZZ_EXPECT(lookup.at(std::span(last).first(dimensions))
            == static_cast<double>(table.values.back()));
        for (const double far : {-1e300, 0.0, 1e300, HUGE_VAL, std::nan("")}) {
            const std::array<double, 3> positions{far, -far, far};
            static_cast<void>(lookup.at(std::span(positions).first(dimensions)));
            static_cast<void>(lookup.index(0, far));
        }
    }
}

} // namespace

/// The first byte chooses the layout and whether the CRCs are repaired; the rest is the file.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0)
        return 0;
    const TableLayout layout = layoutOf(data[0]);
    const ByteView input = std::as_bytes(std::span(data, size)).subspan(1);
    Bytes file(input.begin(), input.end());
    if ((data[0] & 16U) != 0)
        repairCrcs(file, layout);

    const auto decoded = decodeTamTable(file, layout);
    if (!decoded) {
        FUZZ_EXPECT(decoded.error().code == ErrorCode::InvalidTable);
        FUZZ_EXPECT(sentence(decoded.error()).find('?') == std::string::npos
            || decoded.error().context.all().size() == 4);
        return 0;
    }
    expectUsable(*decoded, layout);
    setPersistent(file, !decoded->persistent, layout);
    const auto changed = decodeTamTable(file, layout);
    FUZZ_EXPECT(changed.has_value() && changed->persistent != decoded->persistent);
    FUZZ_EXPECT(sameTable(file, input, layout) || (data[0] & 16U) != 0);
    return 0;
}
