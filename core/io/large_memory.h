// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/system.h"

#include <cstddef>
#include <memory>

namespace axiscomp {

// Megabytes that are written to from end to end: by 4 KiB at a time the system takes as long to
// hand them out as it takes to fill them (DECISIONS 101).

/// container.reserve(size), of one that holds little.
template <typename Container> void reserveLarge(Container& container, std::size_t size)
{
    container.reserve(size);
    system::preferLargePages(container.data(), size * sizeof(*container.data()));
}

/// Not cleared.
template <typename Value> std::unique_ptr<Value[]> makeLarge(std::size_t size)
{
    auto memory = std::make_unique_for_overwrite<Value[]>(size);
    system::preferLargePages(memory.get(), size * sizeof(Value));
    return memory;
}

} // namespace axiscomp
