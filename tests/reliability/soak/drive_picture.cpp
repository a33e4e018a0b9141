// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reliability/soak/drive_picture.h"

#include "core/table/tam_table.h"
#include "core/text/crc_text.h"
#include "drivecomm/profile/profile_loader.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace axiscomp::test {

namespace {

std::string axisPath(int axis, const std::string& rest)
{
    return "Axes[" + std::to_string(axis) + "]/" + rest;
}

const std::string parameters = "Parameters/Compensations/Axis/";
const std::string signals = "Signals/Compensations/Axis/";

AxisPicture axisPicture(const std::vector<RegisterReading>& readings, std::size_t first)
{
    AxisPicture picture;
    picture.slot = toText(readings[first].value);
    for (std::size_t n = 0; n < 3; ++n)
        picture.sources[n] = std::get<std::uint32_t>(readings[first + 1 + n].value);
    return picture;
}

} // namespace

bool AxisPicture::canBeActivated() const
{
    const auto decoded = decodeTamTable(table, drivecomm::genericProfile().layout);
    if (!decoded)
        return false;
    const auto firstUnset = std::ranges::find(sources, 0U);
    return std::all_of(firstUnset, sources.end(), [](std::uint32_t source) { return source == 0; })
        && firstUnset - sources.begin() == decoded->table.grid.dimensions();
}

std::string AxisPicture::text() const
{
    std::string text = slot;
    if (!table.empty())
        text += " (crc " + crcText(crc32(table)) + ", " + std::to_string(table.size()) + " bytes, "
            + (persistent ? "persistent)" : "volatile)");
    text += ", sources";
    for (const std::uint32_t source : sources)
        text += " " + std::to_string(source);
    return text;
}

std::optional<int> DrivePicture::userOf(const std::string& slot) const
{
    const auto user = std::ranges::find(axes, slot, &AxisPicture::slot);
    return user == axes.end() ? std::nullopt : std::optional(static_cast<int>(user - axes.begin()));
}

bool DrivePicture::isOn(int axis) const
{
    const std::string& state = states[static_cast<std::size_t>(axis)];
    return state == "Active" || state == "Ramping";
}

DrivePicture pictureOf(drivecomm::VirtualDrive& drive)
{
    constexpr std::size_t perAxis = 5;
    const auto& slots = drive.profile().tableSlots;
    const int axes = drive.identity().axes;
    std::vector<std::string> paths;
    for (int axis = 0; axis < axes; ++axis) {
        for (const char* name : {"Table", "Dim1Source", "Dim2Source", "Dim3Source"})
            paths.push_back(axisPath(axis, parameters + name));
        paths.push_back(axisPath(axis, signals + "State"));
    }
    for (const TableSlot& slot : slots)
        paths.push_back("Application/Tables/" + slot.name + "/EraseCount");
    paths.push_back("General/Signals/DriveError");
    const auto readings = drive.readRegisters(paths).value();

    DrivePicture picture;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(axes); ++axis) {
        picture.axes.push_back(axisPicture(readings, axis * perAxis));
        picture.states.push_back(toText(readings[axis * perAxis + 4].value));
    }
    const std::size_t firstSlot = static_cast<std::size_t>(axes) * perAxis;
    for (std::size_t i = 0; i < slots.size(); ++i) {
        picture.flashCycles += std::get<std::uint32_t>(readings[firstSlot + i].value);
        Bytes file = drive.download(slots[i].file).value();
        if (!file.empty())
            picture.slots.emplace(slots[i].name, std::move(file));
    }
    picture.driveError = toText(readings.back().value);
    for (AxisPicture& axis : picture.axes) {
        const auto file = picture.slots.find(axis.slot);
        if (file == picture.slots.end())
            continue;
        axis.table = file->second;
        const auto decoded = decodeTamTable(axis.table, drive.profile().layout);
        axis.persistent = decoded && decoded->persistent;
        setPersistent(axis.table, false, drive.profile().layout);
    }
    return picture;
}

std::uint32_t addressOf(drivecomm::VirtualDrive& drive, const std::string& path)
{
    const auto readings = drive.readRegisters({path});
    return readings ? readings->front().address : 0;
}

std::optional<std::string> wrongOutput(drivecomm::VirtualDrive& drive, int axis)
{
    const AxisPicture picture = pictureOf(drive).axes[static_cast<std::size_t>(axis)];
    const auto decoded = decodeTamTable(picture.table, drive.profile().layout);
    if (!decoded)
        return "there is no table, but the state is not Disabled";
    std::vector<std::string> paths{
        axisPath(axis, signals + "State"), axisPath(axis, signals + "Output")};
    const auto tree = drive.readTree("");
    std::vector<double> positions;
    for (int n = 0; n < decoded->table.grid.dimensions(); ++n) {
        const auto source = std::ranges::find(
            tree, picture.sources[static_cast<std::size_t>(n)], &RegisterReading::address);
        if (source == tree.end())
            return "a source is no register of the drive";
        if (std::ranges::find(paths, source->path) == paths.end())
            paths.push_back(source->path);
    }
    const auto readings = drive.readRegisters(paths).value();
    for (std::size_t n = 2; n < readings.size(); ++n)
        positions.push_back(toDouble(readings[n].value));
    const Lookup lookup(decoded->table);
    const double expected = toText(readings[0].value) == "Active" ? lookup.at(positions) : 0.0;
    const double output = toDouble(readings[1].value);
    double largest = 0.0;
    for (const float value : decoded->table.values)
        largest = std::max(largest, static_cast<double>(std::abs(value)));
    const double tolerance = 4.0 * std::numeric_limits<float>::epsilon() * largest;
    if (toText(readings[0].value) == "Ramping" || std::abs(output - expected) <= tolerance)
        return {};
    return "the output is " + toText(readings[1].value) + " instead of "
        + toText(RegisterValue{expected});
}

} // namespace axiscomp::test
