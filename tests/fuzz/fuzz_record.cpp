// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/judge/iso230.h"
#include "core/metrology/record/calibration_record.h"
#include "tests/fuzz/expect.h"

using namespace axiscomp;

namespace {

/// Whoever reads a record relies on this.
void expectConsistent(const RecordedMeasurement& recorded)
{
    FUZZ_EXPECT(!recorded.files.empty());
    for (const RecordedFile& file : recorded.files)
        for (const RunValue& value : file.measurement.values)
            FUZZ_EXPECT(value.target < file.measurement.targets.size() && value.run >= 1);
    const auto used = usedMeasurement(recorded);
    if (used && used->hasTargets())
        static_cast<void>(iso230Figures(*used));
}

} // namespace

/// Whatever is taken as a record is written and read again without a change.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const auto record = recordFromText(text, "fuzz.axcal");
    if (!record)
        return 0;
    if (record->before)
        expectConsistent(*record->before);
    for (const RecordedAfter& after : record->after)
        expectConsistent(after.measurement);
    for (const RecordedTable& table : record->tables)
        FUZZ_EXPECT(table.table.values.size() == table.table.grid.pointCount());
    const std::string written = recordText(*record);
    const auto again = recordFromText(written, "again.axcal");
    FUZZ_EXPECT(again.has_value() && recordText(*again) == written);
    return 0;
}
