// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bytes.h"
#include "drivecomm/profile_loader.h"
#include "drivecomm/virtualdrive/tam_configuration.h"

#include <cstdlib>

using namespace axiscomp;
using namespace axiscomp::drivecomm;

namespace {

void require(bool condition)
{
    if (!condition)
        std::abort();
}

/// What the parser accepts must make a drive that has every register of the file and answers them.
void checkDrive(const VirtualDriveOptions& options)
{
    require(!options.axes.empty() && options.axes.size() <= 64);
    const auto drive = VirtualDrive::create(genericProfile(), options);
    if (!drive) // a register that every drive has, with a value that it cannot have
        require(drive.error().code == ErrorCode::InvalidArgument);
    if (!drive)
        return;
    require((*drive)->identity().axes == static_cast<int>(options.axes.size()));
    for (const RegisterReading& parameter : options.parameters)
        require((*drive)->readRegisters({parameter.path}).has_value());
    require(!(*drive)->readTree("").empty());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view xml(reinterpret_cast<const char*>(data), size);
    const auto drives = parseTamConfiguration(xml, "fuzz");
    if (drives) {
        require(!drives->empty());
        for (const VirtualDriveOptions& options : *drives)
            checkDrive(options);
    } else {
        require(drives.error().code == ErrorCode::InvalidConfiguration);
        require(drives.error().context.contains("line"));
    }
    return 0;
}
