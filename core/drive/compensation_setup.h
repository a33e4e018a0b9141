// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/grid.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace axiscomp {

enum class Persistency { Volatile, Persistent };

/// A DimSource: the register whose value looks the table up. The drive keeps the address, people
/// read the path.
struct DimSource {
    std::uint32_t address = 0; ///< 0 = unset
    std::string path; ///< empty when unset, or when no register with that address was found

    [[nodiscard]] bool isSet() const { return address != 0; }
    friend bool operator==(const DimSource& a, const DimSource& b)
    {
        return a.address == b.address;
    }
};

/// What the user chooses for one axis. The baseline is the same value as last read back from the
/// drive; a field is changed when the two differ.
struct CompensationSetup {
    int dimensionality = 1; ///< 1, 2, 3
    std::array<DimSource, 3> sources; ///< set from dimension 1 up, without gaps
    std::string slot; ///< empty: the axis uses no table
    std::uint32_t tableCrc = 0; ///< of the table's elements; 0: no table
    Persistency persistency = Persistency::Volatile;

    friend bool operator==(const CompensationSetup&, const CompensationSetup&) = default;
};

/// Whether both look their tables up at the same places: the same sources, in the same order, of as
/// many dimensions. Sources above the dimensionality do not count.
[[nodiscard]] bool haveSameSources(const CompensationSetup& a, const CompensationSetup& b);

/// Of a source that is set: its path, or its address where the register is not known: "0x0000abcd".
[[nodiscard]] std::string sourceName(const DimSource& source);

/// `tam://mc/<drive>/<path>`
[[nodiscard]] std::string sourceUri(const std::string& drive, const std::string& path);

} // namespace axiscomp
