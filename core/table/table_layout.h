// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace axiscomp {

/// The fields that a table header can have (docs/profiles.md, "layout").
enum class TableField {
    Magic,
    Version,
    HeaderSize,
    ElementType,
    Persistent,
    Dimensions,
    Size,
    Start,
    Distance,
    ElementCount,
    ElementCrc,
    Name,
    HeaderCrc,
};
inline constexpr int tableFieldCount = 13;

enum class FieldType { U8, U16, U32, I32, F32, F64, Char };

struct FieldPlace {
    std::uint32_t offset = 0;
    FieldType type = FieldType::U32;
    std::uint32_t count = 1; ///< 3 for Size, Start, Distance; the length for Char

    [[nodiscard]] std::uint32_t byteCount() const;
    friend bool operator==(const FieldPlace&, const FieldPlace&) = default;
};

/// Where a drive keeps what in its table file. AN140 leaves this to AN124, so it is data: a profile
/// holds one. Fields that a layout lacks are neither written nor checked. Size, Start and Distance
/// are mandatory. Without Dimensions, the sizes above 1 count. The header CRC covers the header
/// bytes before it, with Persistent taken as 0.
struct TableLayout {
    bool littleEndian = true;
    std::uint32_t headerSize = 0;
    bool dimension1Fastest = true;
    std::array<std::optional<FieldPlace>, tableFieldCount> fields;
    std::string magic;
    std::uint32_t version = 0;
    std::uint32_t elementTypeFloat32 = 1;

    [[nodiscard]] const std::optional<FieldPlace>& place(TableField field) const
    {
        return fields[static_cast<std::size_t>(field)];
    }
    [[nodiscard]] std::optional<FieldPlace>& place(TableField field)
    {
        return fields[static_cast<std::size_t>(field)];
    }
    friend bool operator==(const TableLayout&, const TableLayout&) = default;
};

/// "size", "start" ...: the names in a profile and in errors.
[[nodiscard]] std::string_view tableFieldName(TableField field);
[[nodiscard]] std::string_view fieldTypeName(FieldType type);

/// InvalidProfile (context path = "fields.<name>" or "headerSize", reason) when fields overlap,
/// leave the header, have a type or count that cannot hold them, or a mandatory one is missing.
[[nodiscard]] Result<void> checkLayout(const TableLayout& layout);

/// Where a layout has the numbers of a table, such as "little 128 first dimensions=u32@16 ...": two
/// layouts with one text read the same table from the same bytes, if both read them.
[[nodiscard]] std::string layoutText(const TableLayout& layout);

/// This project's own layout (docs/profiles.md, "The generic layout"), to be replaced for a real
/// drive.
[[nodiscard]] TableLayout genericTableLayout();

} // namespace axiscomp
