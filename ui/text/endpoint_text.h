// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace axiscomp::ui {

/// An endpoint as typed, without user and password: for everything that is shown or logged.
[[nodiscard]] QString shownEndpoint(const QString& endpoint);
[[nodiscard]] bool isDemoEndpoint(const QString& endpoint);

} // namespace axiscomp::ui
