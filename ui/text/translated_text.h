// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"

#include <QString>

namespace axiscomp::ui {

/// The text in the language of the window: its words by the translations, a number with the decimal
/// sign of the locale and the name of its unit, names as they are, what stands within it likewise.
/// Words without a translation stay English.
[[nodiscard]] QString translated(const Text& text);
/// "-0.31 µm", as it stands in a text.
[[nodiscard]] QString translated(const Quantity& quantity);

} // namespace axiscomp::ui
