// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace axiscomp::ui {

/// The front page of all documents, as the package axiscomp-doc installs them: beside the program,
/// or in a data folder of the system. Empty: they are not installed.
[[nodiscard]] QString installedDocumentation();

} // namespace axiscomp::ui
