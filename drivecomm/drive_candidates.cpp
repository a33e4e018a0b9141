// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/drive_candidates.h"

#include "drivecomm/link/drive_endpoint.h"

#include <QNetworkInterface>
#include <QSerialPortInfo>

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

namespace axiscomp::drivecomm {

namespace {

/// The likely ones first.
constexpr std::array usualBaudRates{115200, 921600, 460800, 230400, 57600, 38400, 19200, 9600};

/// For so long a serial link waits for an answer before it does more than ask once.
constexpr std::chrono::milliseconds oneIdentify{500};

std::vector<std::string> endpointsOf(DriveEndpoint endpoint, BaudRates rates)
{
    std::vector<std::string> endpoints{displayText(endpoint)};
    if (rates == BaudRates::AsGiven)
        return endpoints;
    const int given = endpoint.baud;
    for (const int baud : usualBaudRates) {
        endpoint.baud = baud;
        if (baud != given)
            endpoints.push_back(displayText(endpoint));
    }
    return endpoints;
}

std::string realDevice(const std::string& device)
{
    std::error_code error;
    const auto real = std::filesystem::canonical(device, error);
    return error ? device : real.string();
}

std::string usbIdOf(const QSerialPortInfo& info)
{
    if (!info.hasVendorIdentifier() || !info.hasProductIdentifier())
        return {};
    return QStringLiteral("%1:%2")
        .arg(info.vendorIdentifier(), 4, 16, QLatin1Char('0'))
        .arg(info.productIdentifier(), 4, 16, QLatin1Char('0'))
        .toStdString();
}

} // namespace

DriveCandidate candidateAt(const std::string& endpoint, BaudRates rates)
{
    const auto parsed = parseEndpoint(endpoint);
    if (!parsed || parsed->kind != DriveEndpoint::Kind::Serial)
        return {.endpoints = {endpoint}, .description = {}};
    return {endpointsOf(*parsed, rates), {}, oneIdentify};
}

std::vector<SerialPort> serialPorts()
{
    std::vector<SerialPort> ports;
    for (const QSerialPortInfo& info : QSerialPortInfo::availablePorts()) {
        QStringList words{info.description(), info.manufacturer(), info.serialNumber()};
        words.removeAll(QString());
        ports.push_back({info.systemLocation().toStdString(),
            words.join(QStringLiteral(", ")).toStdString(), usbIdOf(info)});
    }
    std::ranges::sort(ports, {}, &SerialPort::device);
    return ports;
}

std::string placeOf(const std::string& endpoint)
{
    const auto parsed = parseEndpoint(endpoint);
    if (!parsed)
        return endpoint;
    return parsed->kind == DriveEndpoint::Kind::Serial ? realDevice(parsed->device)
                                                       : displayText(*parsed);
}

std::vector<DriveCandidate> candidatesAt(
    std::span<const SerialPort> ports, std::span<const std::string> otherThan, BaudRates rates)
{
    std::set<std::string> taken;
    for (const std::string& endpoint : otherThan)
        taken.insert(placeOf(endpoint));
    std::vector<DriveCandidate> candidates;
    for (const SerialPort& port : ports) {
        if (!taken.insert(realDevice(port.device)).second)
            continue;
        DriveEndpoint endpoint;
        endpoint.kind = DriveEndpoint::Kind::Serial;
        endpoint.device = port.device;
        candidates.push_back({endpointsOf(endpoint, rates), port.description, oneIdentify});
    }
    return candidates;
}

std::vector<std::string> ownNetworks()
{
    std::set<std::string> networks;
    for (const QNetworkInterface& interface : QNetworkInterface::allInterfaces()) {
        const auto flags = interface.flags();
        if (!flags.testFlag(QNetworkInterface::IsRunning)
            || flags.testFlag(QNetworkInterface::IsLoopBack))
            continue;
        for (const QNetworkAddressEntry& entry : interface.addressEntries()) {
            if (entry.ip().protocol() == QAbstractSocket::IPv4Protocol)
                networks.insert(networkAround(entry.ip().toIPv4Address(), entry.prefixLength()));
        }
    }
    return {networks.begin(), networks.end()};
}

std::vector<DriveCandidate> candidatesIn(
    const NetworkRange& range, std::span<const std::string> otherThan)
{
    std::set<std::string> taken;
    for (const std::string& endpoint : otherThan) {
        if (const auto parsed = parseEndpoint(endpoint))
            taken.insert(displayText(*parsed));
    }
    std::vector<DriveCandidate> candidates;
    for (const std::string& address : addressesIn(range)) {
        DriveEndpoint endpoint;
        endpoint.kind = DriveEndpoint::Kind::Http;
        endpoint.host = address;
        endpoint.port = range.port;
        DriveCandidate candidate{.endpoints = {displayText(endpoint)}, .description = {}};
        candidate.isUnknown = true;
        if (!taken.contains(candidate.endpoints.front()))
            candidates.push_back(std::move(candidate));
    }
    return candidates;
}

} // namespace axiscomp::drivecomm
