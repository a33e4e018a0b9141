// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/drive_search.h"
#include "core/drive/network_range.h"

#include <span>
#include <string>
#include <vector>

/// Where findDrives() may look.
namespace axiscomp::drivecomm {

enum class BaudRates {
    AsGiven, ///< the address's, or the default
    Usual, ///< that one first, then the others that drives are usually set to
};

/// A remembered address; one that is not serial, or not valid, is tried as it is.
[[nodiscard]] DriveCandidate candidateAt(
    const std::string& endpoint, BaudRates rates = BaudRates::AsGiven);

/// A serial port of this machine.
struct SerialPort {
    std::string device; ///< "/dev/ttyUSB0"
    std::string description; ///< "FT232R USB UART, FTDI, serial number A50285BI"; may be empty
    std::string usbId = {}; ///< vendor and product, "0403:6001"; empty: not on USB

    friend bool operator==(const SerialPort&, const SerialPort&) = default;
};

/// Those that Qt lists: USB adapters and built-in ports, but no ptys.
[[nodiscard]] std::vector<SerialPort> serialPorts();

/// What all addresses of one port have in common: the device that a link to it leads to, at any
/// speed; of another address itself, without a password, and of what is none the text.
[[nodiscard]] std::string placeOf(const std::string& endpoint);

/// The ports that no address in otherThan names, under whatever name it knows them (a link in
/// /dev/serial/by-id): one port must not be opened twice.
[[nodiscard]] std::vector<DriveCandidate> candidatesAt(std::span<const SerialPort> ports,
    std::span<const std::string> otherThan, BaudRates rates = BaudRates::AsGiven);

/// Networks that this computer has an IPv4 address in, as ranges to propose ("192.168.1.0/24"),
/// without loopback.
[[nodiscard]] std::vector<std::string> ownNetworks();

/// So many addresses of a network are asked at once (DriveSearch::mostAtOnce).
inline constexpr std::size_t addressesAtOnce = 32;

/// The addresses of a range, over http, that none in otherThan names; each has a second.
[[nodiscard]] std::vector<DriveCandidate> candidatesIn(
    const NetworkRange& range, std::span<const std::string> otherThan);

} // namespace axiscomp::drivecomm
