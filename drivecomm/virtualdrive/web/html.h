// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace axiscomp::drivecomm {

/// Text for element content and for quoted attributes.
[[nodiscard]] std::string escaped(std::string_view text);

/// A path that may go on in another line after a slash.
[[nodiscard]] std::string breakable(std::string_view path);

/// A complete page: heading and drive are text, content is HTML. Every page leads to the others.
struct PageFrame {
    std::string driveName;
    std::string serialNumber;
    std::string directoryLink;
    std::string transferLink;
    std::string registersLink;
};
[[nodiscard]] std::string page(
    const PageFrame& frame, std::string_view heading, std::string_view content);

/// <a href="target">text</a>; both are text, target is percent-encoded already.
[[nodiscard]] std::string link(std::string_view target, std::string_view text);

} // namespace axiscomp::drivecomm
