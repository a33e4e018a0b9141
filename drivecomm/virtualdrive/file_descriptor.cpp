// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/file_descriptor.h"

#include <unistd.h>

namespace axiscomp::drivecomm {

void FileDescriptor::close()
{
    if (m_descriptor >= 0)
        ::close(std::exchange(m_descriptor, -1));
}

} // namespace axiscomp::drivecomm
