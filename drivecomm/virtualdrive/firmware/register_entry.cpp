// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/firmware/virtual_drive_p.h"

namespace axiscomp::drivecomm {

RegisterEntry VirtualDrive::registerEntry(const std::string& path) const
{
    const std::scoped_lock lock(d->mutex);
    const Register* found = d->tree.find(path);
    if (found == nullptr)
        return {};
    return {found->role != RegisterRole::ReadOnly, found->enumValues};
}

} // namespace axiscomp::drivecomm
