// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compensator/axis_compensator.h"
#include "core/table/lookup.h"
#include "drivecomm/link/drive_endpoint.h"
#include "drivecomm/link_factory.h"
#include "drivecomm/profile/profile_loader.h"

#include <iostream>

using namespace axiscomp;

namespace {

int failed(const Error& error)
{
    std::cerr << errorName(error.code) << ": " << sentence(error) << '\n';
    return 1;
}

} // namespace

/// Looks a table up, and lists the axes of the demo drive. The argument is a folder for the store.
int main(int argc, char** argv)
{
    if (argc != 2)
        return 2;
    const CompensationTable table{"t", "mm", {{{"x", "mm", 0.0, 10.0, 2}}}, {0.0F, 1.0F}};
    std::cout << "halfway " << Lookup(table).at(5.0) << '\n';

    const auto endpoint = drivecomm::parseEndpoint("demo:");
    if (!endpoint)
        return failed(endpoint.error());
    const auto link = drivecomm::makeLink(*endpoint, drivecomm::genericProfile());
    if (!link)
        return failed(link.error());
    DriveStore store{argv[1]};
    AxisCompensator compensator{**link, drivecomm::genericProfile(), store};
    const auto axes = compensator.axes();
    if (!axes)
        return failed(axes.error());
    for (const AxisInfo& axis : *axes)
        std::cout << "axis " << axis.index << ' ' << axis.name << '\n';
    return 0;
}
