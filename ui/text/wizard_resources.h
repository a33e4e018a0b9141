// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>

namespace axiscomp::ui {

/// Makes the library's icons (:/axiscomp/icons) and translations (:/i18n) known to Qt. A static
/// library's resources are left out of a program that never asks for them. May be called often.
void useWizardResources();

/// The icon of the program, in every size.
[[nodiscard]] QIcon wizardIcon();

} // namespace axiscomp::ui
