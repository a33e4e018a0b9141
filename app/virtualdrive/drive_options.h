// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "drivecomm/virtualdrive/firmware/virtual_drive.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace axiscomp::app {

/// The command line of axiscomp-virtualdrive.
struct VirtualDriveArguments {
    std::string http;
    std::string serial;
    int baud = 0; ///< 0: not given
    std::string name;
    int axes = 0; ///< 0: not given
    std::string configuration;
    std::string machine; ///< a machine file
    std::string program; ///< a measuring plan
    std::optional<double> programAfter; ///< seconds, whatever the speed is
    std::string instrument; ///< a link to the instrument's port
    std::string stateFolder;
    std::vector<std::string> faults;
    double speed = 1.0;
    bool unhomed = false;
    std::string user;
    std::string passwordFile;
    std::string certificate;
    std::string key;
    std::string profile;
};

struct HostAndPort {
    std::string host;
    std::uint16_t port = 0;
};

/// "127.0.0.1:8080", "[::1]:8080". Errors: InvalidArgument.
[[nodiscard]] Result<HostAndPort> parseHostAndPort(const std::string& text);
/// The link of drive `index`, from 0: "/tmp/drive", "/tmp/drive-2", ...
[[nodiscard]] std::string serialLinkOf(const std::string& link, std::size_t index);

/// One drive as the options say, or those of the configuration file. Errors: InvalidArgument,
/// FileNotReadable, FileTooLarge, InvalidConfiguration.
[[nodiscard]] Result<std::vector<drivecomm::VirtualDriveOptions>> drivesOf(
    const VirtualDriveArguments& arguments);

} // namespace axiscomp::app
