// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/tam_table.h"
#include "drivecomm/profile/generic_profile.h"
#include "drivecomm/profile/profile_loader.h"
#include "tests/fuzz/expect.h"

#include <cstdint>

using namespace axiscomp;

namespace {

/// The generic profile with another layout object: the fuzzer need not write a whole profile to
/// come as far as the layout.
std::string withLayout(std::string_view layout)
{
    const std::string_view profile = drivecomm::genericProfileJson;
    const std::size_t begin = profile.find("\"layout\": ") + 10;
    const std::size_t end = profile.find("\"web\": ");
    return std::string(profile.substr(0, begin)) + std::string(layout) + ","
        + std::string(profile.substr(end));
}

void expectUsable(const DriveProfile& profile)
{
    FUZZ_EXPECT(checkLayout(profile.layout).has_value());
    FUZZ_EXPECT(!profile.tableSlots.empty() && !profile.sourceTypes.empty());
    for (const TableSlot& slot : profile.tableSlots) {
        FUZZ_EXPECT(profile.slotNamed(slot.name) == &slot);
        FUZZ_EXPECT(profile.slotOfFile(slot.file) == &slot);
    }
    for (const std::string& source : profile.sourceShortlist)
        FUZZ_EXPECT(expandPath(source, {0, {}, {}}).find_first_of("{}.") == std::string::npos);

    CompensationTable table;
    table.name = "fuzz";
    table.grid.axes = {{{}, {}, 0.0, 0.5, 2}, {{}, {}, -4.0, 2.0, 3}};
    table.values = {1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F};
    const auto file = encodeTamTable(table, false, profile.layout);
    FUZZ_EXPECT(file.has_value());
    const auto decoded = decodeTamTable(*file, profile.layout);
    FUZZ_EXPECT(decoded.has_value());
    FUZZ_EXPECT(decoded->table.values == table.values && decoded->table.grid == table.grid);
}

} // namespace

/// A profile, or after an L the layout of one.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    std::string text(reinterpret_cast<const char*>(data), size);
    if (text.starts_with('L'))
        text = withLayout(std::string_view(text).substr(1));
    const auto profile = drivecomm::parseProfile(text, "fuzz.json");
    if (profile) {
        expectUsable(*profile);
        return 0;
    }
    FUZZ_EXPECT(profile.error().code == ErrorCode::InvalidProfile);
    FUZZ_EXPECT(!profile.error().context.english("path").empty());
    FUZZ_EXPECT(!profile.error().context.english("reason").empty());
    return 0;
}
