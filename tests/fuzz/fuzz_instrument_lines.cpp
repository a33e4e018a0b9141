// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/reference_lines.h"
#include "drivecomm/capture/number_pattern.h"
#include "tests/fuzz/expect.h"

#include <cmath>
#include <cstdint>

using namespace axiscomp;

namespace {

constexpr std::chrono::seconds now(10);

InstrumentReading said(
    std::string_view bytes, std::size_t piece, const std::string& unit, const std::string& pattern)
{
    ReferenceScale scale;
    scale.unit = unit;
    auto reader =
        ReferenceLineReader::make(scale, false, drivecomm::numberPattern(pattern).value());
    FUZZ_EXPECT(reader.has_value());
    ReferenceLines lines(*std::move(reader), std::chrono::seconds(1));
    for (; !bytes.empty(); bytes.remove_prefix(std::min(piece, bytes.size())))
        lines.feed(bytes.substr(0, piece), now);
    return lines.at(now);
}

} // namespace

/// What an instrument sends, in one piece and in small ones: the same comes out, a position or a
/// sentence. The first byte is the size of the pieces, and which options there are.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0)
        return 0;
    const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    const std::string unit = (data[0] & 1U) != 0 ? "um" : "";
    const std::string pattern = (data[0] & 2U) != 0 ? "=([^;]*)" : "";
    const InstrumentReading whole = said(bytes, bytes.size() + 1, unit, pattern);
    const InstrumentReading pieces = said(bytes, std::size_t{1} + (data[0] >> 2U), unit, pattern);
    FUZZ_EXPECT(whole.problem == pieces.problem);
    FUZZ_EXPECT(std::isfinite(whole.position) == whole.problem.isEmpty());
    FUZZ_EXPECT(!std::isfinite(whole.position) || whole.position == pieces.position);
    return 0;
}
