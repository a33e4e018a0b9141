// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive/compensation_setup.h"

#include "core/text/crc_text.h"

#include <algorithm>
#include <cstddef>
#include <span>

namespace axiscomp {

namespace {

std::span<const DimSource> usedSources(const CompensationSetup& setup)
{
    const auto used = static_cast<std::size_t>(std::max(setup.dimensionality, 0));
    return std::span(setup.sources).first(std::min(used, setup.sources.size()));
}

} // namespace

bool haveSameSources(const CompensationSetup& a, const CompensationSetup& b)
{
    return std::ranges::equal(usedSources(a), usedSources(b));
}

std::string sourceName(const DimSource& source)
{
    return source.path.empty() ? "0x" + crcText(source.address) : source.path;
}

std::string sourceUri(const std::string& drive, const std::string& path)
{
    return "tam://mc/" + drive + "/" + path;
}

} // namespace axiscomp
