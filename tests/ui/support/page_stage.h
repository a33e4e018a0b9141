// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivecomm/capture/serial_instrument.h"
#include "drivecomm/link_factory.h"
#include "drivecomm/profile/profile_loader.h"
#include "drivecomm/virtualdrive/direct_link.h"
#include "tests/ui/support/gate_link.h"
#include "ui/compensation_wizard.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace axiscomp::test {

/// A drive as in AN140 figure 2 at http://192.168.1.20, and the folders of a program that talks to
/// it. demo: is the built-in demo drive.
class PageStage {
public:
    explicit PageStage(bool isHomed = true)
        : m_drive(drivecomm::genericProfile(), driveOptions(isHomed))
    {
    }

    static constexpr const char* address = "http://192.168.1.20";
    /// Leads to the same drive.
    static constexpr const char* usbPort = "serial:/dev/ttyUSB0";
    [[nodiscard]] static QString endpoint() { return QString::fromLatin1(address); }

    [[nodiscard]] ui::WizardOptions options()
    {
        ui::WizardOptions options;
        options.profile = &drivecomm::genericProfile();
        options.storeRoot = std::filesystem::path(m_folder.path().toStdString()) / "store";
        options.timeout = std::chrono::seconds(5);
        options.liveInterval = std::chrono::milliseconds(50);
        options.reconnectInterval = std::chrono::milliseconds(50);
        options.linkFactory = [this](const std::string& text) { return link(text); };
        options.instrumentFactory = drivecomm::openSerialInstrument;
        options.portCandidates = [](const std::vector<std::string>&, bool) {
            return std::vector<DriveCandidate>{
                {.endpoints = {usbPort}, .description = "FT232R USB UART, FTDI, A50285BI"},
                {.endpoints = {"serial:/dev/no-such-port"}, .description = ""}};
        };
        options.network.ownNetworks = [] { return std::vector<std::string>{"192.168.1.0/24"}; };
        options.network.candidates = [](const NetworkRange&, const std::vector<std::string>&) {
            return std::vector<DriveCandidate>{{.endpoints = {address}, .description = ""}};
        };
        return options;
    }
    [[nodiscard]] drivecomm::VirtualDrive& drive() { return m_drive; }
    [[nodiscard]] DriveGate& gate() { return m_gate; }
    [[nodiscard]] QString path(const QString& name) const { return m_folder.filePath(name); }

    /// A file in the folder; its path.
    [[nodiscard]] QString file(const QString& name, const QByteArray& content) const
    {
        QFile file(path(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
            qFatal("cannot write %s", qPrintable(file.fileName()));
        return file.fileName();
    }
    /// The error of X over an area of 40 x 30 mm, in two tables.
    [[nodiscard]] QString superData(int seed = 0) const
    {
        QByteArray text = "X [mm],Y [mm],table 1 [mm],table 2 [mm]\n";
        for (int y = 0; y <= 30; y += 2) {
            for (int x = 0; x <= 40; x += 2) {
                const double wave = 0.0021 * std::sin(x / 6.0 + seed) + 0.00006 * x;
                const double yaw = 0.0014 * (y / 30.0 - 0.5) * std::cos(x / 14.0);
                text += QByteArray::number(x) + ',' + QByteArray::number(y) + ','
                    + QByteArray::number(wave + yaw, 'f', 7) + ','
                    + QByteArray::number(wave - yaw, 'f', 7) + '\n';
            }
        }
        return file(QStringLiteral("2D-superdata.csv"), text);
    }
    [[nodiscard]] static std::string masterPosition(int axis)
    {
        return "Axes[" + std::to_string(axis) + "]/Signals/PositionController/MasterPosition";
    }

private:
    static drivecomm::VirtualDriveOptions driveOptions(bool isHomed)
    {
        drivecomm::VirtualDriveOptions options;
        options.name = "Triamec-616";
        options.serialNumber = 1559;
        options.axes = {{"X", "Millimeter", 0.0, 40.0, 17.0, isHomed},
            {"Y", "Millimeter", 0.0, 30.0, 13.0, isHomed}};
        return options;
    }
    [[nodiscard]] Result<std::unique_ptr<DriveLink>> link(const std::string& text)
    {
        if (text == address || text == usbPort)
            return std::make_unique<GateLink>(
                drivecomm::makeDirectLink(m_drive), m_gate, nullptr, address);
        return drivecomm::linkFactory(drivecomm::genericProfile())(text);
    }

    QTemporaryDir m_folder;
    drivecomm::VirtualDrive m_drive;
    DriveGate m_gate{Error{ErrorCode::ConnectionLost,
        {{"endpoint", Verbatim{address}}, {"reason", Verbatim{"Connection closed"}}}, {}}};
};

} // namespace axiscomp::test
