// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/bytes.h"
#include "drivecomm/profile/profile_loader.h"
#include "drivecomm/virtualdrive/tam_configuration.h"
#include "tests/fuzz/expect.h"

using namespace axiscomp;
using namespace axiscomp::drivecomm;

namespace {

/// What the parser accepts must make a drive that has every register of the file and answers them.
void checkDrive(const VirtualDriveOptions& options)
{
    FUZZ_EXPECT(!options.axes.empty() && options.axes.size() <= 64);
    const auto drive = VirtualDrive::create(genericProfile(), options);
    if (!drive) { // a register that every drive has, with a value that it cannot have
        FUZZ_EXPECT(drive.error().code == ErrorCode::InvalidArgument);
        return;
    }
    FUZZ_EXPECT((*drive)->identity().axes == static_cast<int>(options.axes.size()));
    for (const RegisterReading& parameter : options.parameters)
        FUZZ_EXPECT((*drive)->readRegisters({parameter.path}).has_value());
    FUZZ_EXPECT(!(*drive)->readTree("").empty());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view xml(reinterpret_cast<const char*>(data), size);
    const auto drives = parseTamConfiguration(xml, "fuzz");
    if (drives) {
        FUZZ_EXPECT(!drives->empty());
        for (const VirtualDriveOptions& options : *drives)
            checkDrive(options);
    } else {
        FUZZ_EXPECT(drives.error().code == ErrorCode::InvalidConfiguration);
        FUZZ_EXPECT(drives.error().context.contains("line"));
    }
    return 0;
}
