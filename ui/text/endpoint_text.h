// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace axiscomp::ui {

/// An endpoint as typed, without user and password: for everything that is shown or logged.
[[nodiscard]] QString shownEndpoint(const QString& endpoint);
/// What a person types, "192.168.1.20" or "drive-3:8080", is the address of a web server:
/// "http://192.168.1.20". What has a scheme, and what is no host, stays as it is.
[[nodiscard]] QString completedEndpoint(const QString& typed);
[[nodiscard]] bool isDemoEndpoint(const QString& endpoint);

} // namespace axiscomp::ui
