// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivecomm/virtualdrive/firmware/virtual_drive.h"
#include "tests/support/verify.h"

#include <QByteArray>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace axiscomp::test {

/// An axis of a TAM configuration.
struct ConfiguredAxis {
    QByteArray table = "Disabled";
    std::array<std::uint32_t, 3> sources{};
};

/// A station of a TAM configuration; its axes are in millimetres.
struct ConfiguredStation {
    QByteArray name;
    int serialNumber = 0;
    std::vector<ConfiguredAxis> axes;
};

namespace configuration_files {

inline QByteArray registerText(
    const QByteArray& path, const QByteArray& type, const QByteArray& value)
{
    return "        <RegisterComponent Address=\"" + path + "\" Type=\"" + type + "\" Value=\""
        + value + "\" />\n";
}

inline QByteArray axisText(int index, const ConfiguredAxis& axis)
{
    const QByteArray parameters = "Axes[" + QByteArray::number(index) + "]/Parameters/";
    const QByteArray compensation = parameters + "Compensations/Axis/";
    QByteArray text = registerText(parameters + "PositionController/PositionUnit",
                          "PositionUnitType", "Millimeter")
        + registerText(parameters + "Motor/PolePitch", "Single", "0.032")
        + registerText(compensation + "Table", "SourceTable", axis.table);
    for (std::size_t n = 0; n < axis.sources.size(); ++n)
        text +=
            registerText(compensation + "Dim" + QByteArray::number(qulonglong(n + 1)) + "Source",
                "UInt32", QByteArray::number(axis.sources.at(n)));
    return text;
}

} // namespace configuration_files

/// As the drive has it now.
inline ConfiguredAxis configuredAxis(drivecomm::VirtualDrive& drive, int index)
{
    const std::string base = "Axes[" + std::to_string(index) + "]/Parameters/Compensations/Axis/";
    const auto readings = drive.readRegisters(
        {base + "Table", base + "Dim1Source", base + "Dim2Source", base + "Dim3Source"});
    if (!readings)
        qFatal("%s", describe(readings.error()).c_str());
    ConfiguredAxis axis;
    axis.table = QByteArray::fromStdString(toText(readings->front().value));
    for (std::size_t n = 0; n < axis.sources.size(); ++n)
        axis.sources.at(n) = std::get<std::uint32_t>(readings->at(n + 1).value);
    return axis;
}

inline QByteArray tamConfiguration(const std::vector<ConfiguredStation>& stations)
{
    QByteArray text = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<TamTopology>\n  <Stations>\n";
    for (const ConfiguredStation& station : stations) {
        text += "    <TamStation Name=\"" + station.name + "\" HardwareSerialNumber=\""
            + QByteArray::number(station.serialNumber) + "\">\n      <Registers>\n";
        int index = 0;
        for (const ConfiguredAxis& axis : station.axes)
            text += configuration_files::axisText(index++, axis);
        text += "      </Registers>\n    </TamStation>\n";
    }
    return text + "  </Stations>\n</TamTopology>\n";
}

} // namespace axiscomp::test
