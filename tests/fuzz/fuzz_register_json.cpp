// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/codec/error_json.h"
#include "drivecomm/codec/register_json.h"
#include "tests/fuzz/expect.h"

#include <cstdint>

using namespace axiscomp;
using namespace axiscomp::drivecomm;

namespace {

/// What was read is written and read back without a change. Texts are compared, since no NaN is
/// equal to another.
void expectRoundTrip(const std::vector<RegisterReading>& readings)
{
    const std::string json = readingsJson(readings);
    const auto again = parseReadings(json);
    FUZZ_EXPECT(again.has_value() && readingsJson(*again) == json);

    std::vector<RegisterWrite> writes;
    for (const RegisterReading& each : readings)
        writes.push_back({each.path, each.value});
    const auto requested = parseWrites(writesJson(writes));
    FUZZ_EXPECT(requested.has_value() && requested->size() == writes.size());
    for (std::size_t i = 0; i < writes.size(); ++i) {
        const auto value = typedValue(readings[i].type, (*requested)[i].value);
        FUZZ_EXPECT((*requested)[i].path == writes[i].path && value.has_value());
        FUZZ_EXPECT(valueJson(*value) == valueJson(writes[i].value));
    }
}

} // namespace

/// Everything that is read from JSON of registers, on either side of the connection.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    if (const auto readings = parseReadings(text))
        expectRoundTrip(*readings);
    else
        FUZZ_EXPECT(readings.error().code == ErrorCode::Protocol);

    if (const auto writes = parseWrites(text); !writes)
        FUZZ_EXPECT(writes.error().code == ErrorCode::DriveRejected);
    if (const auto value = parseWrittenValue(text)) {
        for (const char* type : {"Boolean", "Int32", "UInt32", "Single", "Double", "SourceTable"})
            if (const auto typed = typedValue(type, *value))
                FUZZ_EXPECT(!valueJson(*typed).empty());
        FUZZ_EXPECT(!describe(*value).empty());
    }
    if (const auto error = parseErrorJson(text)) {
        const auto again = parseErrorJson(errorJson(*error));
        FUZZ_EXPECT(again && again->code == error->code);
        FUZZ_EXPECT(again->context == error->context);
    }
    return 0;
}
