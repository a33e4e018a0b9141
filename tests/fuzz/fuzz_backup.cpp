// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/backup.h"
#include "tests/fuzz/expect.h"

/// Whatever is taken as a backup is written and read again without a change.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const auto backup = axiscomp::readBackup(text, "fuzz.json");
    if (!backup)
        return 0;
    const std::string written = axiscomp::writeBackup(*backup);
    const auto again = axiscomp::readBackup(written, "again.json");
    FUZZ_EXPECT(again.has_value() && axiscomp::writeBackup(*again) == written);
    return 0;
}
