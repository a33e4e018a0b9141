// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/virtualdrive/drive_options.h"

#include "core/base/bytes.h"
#include "core/io/local_file.h"
#include "core/metrology/measuring_plan.h"
#include "drivecomm/virtualdrive/machine/machine_file.h"
#include "drivecomm/virtualdrive/tam_configuration.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace axiscomp::app {

namespace {

using drivecomm::VirtualAxis;
using drivecomm::VirtualDriveOptions;

constexpr int usualAxes = 2;
constexpr std::int32_t firstSerialNumber = 100001;
constexpr std::uint32_t serialNumbers = 800'000;

/// The same name is the same drive in every run, and another name is another one: the histories
/// that axiscomp keeps by serial number must not get mixed.
std::int32_t serialNumberOf(const std::string& name)
{
    if (name == VirtualDriveOptions{}.name)
        return firstSerialNumber;
    return firstSerialNumber + 1 + static_cast<std::int32_t>(crc32(asBytes(name)) % serialNumbers);
}

std::vector<VirtualAxis> makeAxes(int count)
{
    static constexpr std::array names{"X", "Y", "Z", "A", "B", "C"};
    constexpr std::size_t linearAxes = 3;
    std::vector<VirtualAxis> axes;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        VirtualAxis axis;
        axis.name = i < names.size() ? names[i] : "Axis" + std::to_string(i);
        axis.unit = i < linearAxes || i >= names.size() ? "Millimeter" : "Degree";
        axis.saysTravel = true;
        // Different periods, so that all places of a plane or a volume are visited.
        axis.periodSeconds += 7.0 * static_cast<double>(i);
        axes.push_back(std::move(axis));
    }
    return axes;
}

/// A sub-folder for each drive: its name, with what a file name cannot hold replaced.
std::filesystem::path stateFolderOf(const std::filesystem::path& root, const std::string& name)
{
    std::string folder = name;
    std::ranges::replace_if(
        folder,
        [](char c) {
            const auto byte = static_cast<unsigned char>(c);
            return byte < 0x20 || c == '/' || c == '\\';
        },
        '_');
    return root / (folder.empty() || folder.front() == '.' ? "_" + folder : folder);
}

} // namespace

Result<HostAndPort> parseHostAndPort(const std::string& text)
{
    const std::size_t colon = text.rfind(':');
    HostAndPort result;
    const std::string digits = colon == std::string::npos ? "" : text.substr(colon + 1);
    const char* const last = digits.data() + digits.size();
    const auto [end, error] = std::from_chars(digits.data(), last, result.port);
    result.host = text.substr(0, colon);
    if (result.host.starts_with('[') && result.host.ends_with(']'))
        result.host = result.host.substr(1, result.host.size() - 2);
    if (digits.empty() || error != std::errc{} || end != last || result.host.empty())
        return fail(ErrorCode::InvalidArgument,
            {{"reason", text + " is not HOST:PORT; write --http 127.0.0.1:8080"}});
    return result;
}

std::string serialLinkOf(const std::string& link, std::size_t index)
{
    return index == 0 ? link : link + "-" + std::to_string(index + 1);
}

/// The machine of --machine and --program into the options of a drive.
Result<void> addMachine(const VirtualDriveArguments& arguments, VirtualDriveOptions& drive)
{
    if (arguments.machine.empty())
        return {};
    AXISCOMP_TRY(drive.machine, drivecomm::loadMachine(arguments.machine));
    if (arguments.program.empty())
        return {};
    AXISCOMP_TRY(const auto bytes, loadFile(arguments.program, mostPlanBytes));
    AXISCOMP_TRY(drive.program, readMeasuringPlan(asText(bytes), arguments.program));
    if (arguments.programAfter)
        drive.programStart = std::chrono::duration_cast<std::chrono::nanoseconds>(
            std::chrono::duration<double>(*arguments.programAfter * arguments.speed));
    return {};
}

Result<std::vector<VirtualDriveOptions>> drivesOf(const VirtualDriveArguments& arguments)
{
    std::vector<VirtualDriveOptions> drives(1);
    if (!arguments.configuration.empty()) {
        AXISCOMP_TRY(auto loaded, drivecomm::loadTamConfiguration(arguments.configuration));
        drives = std::move(loaded);
    }
    if (drives.size() > 1 && !arguments.name.empty())
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                arguments.configuration + " has " + std::to_string(drives.size())
                    + " drives with names of their own: leave --name out"}});
    for (VirtualDriveOptions& drive : drives) {
        if (!arguments.name.empty())
            drive.name = arguments.name;
        if (arguments.configuration.empty())
            drive.serialNumber = serialNumberOf(drive.name);
        if (arguments.axes > 0 || drive.axes.empty())
            drive.axes = makeAxes(arguments.axes > 0 ? arguments.axes : usualAxes);
        for (VirtualAxis& axis : drive.axes)
            axis.homed = axis.homed && !arguments.unhomed;
        AXISCOMP_CHECK(addMachine(arguments, drive));
        if (!arguments.stateFolder.empty())
            drive.stateFolder = stateFolderOf(arguments.stateFolder, drive.name);
    }
    return drives;
}

} // namespace axiscomp::app
