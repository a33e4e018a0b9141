// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <functional>

namespace axiscomp::ui {

/// A text as the function that makes it, in the language of the moment in which it is called. What
/// is kept for longer than that is kept in this form: the language may change while the window is
/// open.
using Wording = std::function<QString()>;

} // namespace axiscomp::ui
