// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/machine/machine_file.h"
#include "tests/fuzz/expect.h"

#include <cstdint>

using namespace axiscomp;

/// What is read as a machine is written and read back as the same, and what is not has a problem.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const MachineReading reading =
        readMachine(std::string_view(reinterpret_cast<const char*>(data), size));
    if (!reading.machine) {
        FUZZ_EXPECT(!reading.diagnostics.empty());
        for (const Diagnostic& problem : reading.diagnostics)
            FUZZ_EXPECT(!message(problem).empty());
        return 0;
    }
    const std::string text = writeMachine(*reading.machine);
    const MachineReading again = readMachine(text);
    FUZZ_EXPECT(again.machine.has_value());
    FUZZ_EXPECT(writeMachine(*again.machine) == text);
    return 0;
}
