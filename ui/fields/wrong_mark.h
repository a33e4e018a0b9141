// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QLineEdit;

namespace axiscomp::ui {

/// The mark in a field that its text is not taken.
void markWrong(QLineEdit& edit, bool isWrong);
[[nodiscard]] bool isMarkedWrong(const QLineEdit& edit);

} // namespace axiscomp::ui
