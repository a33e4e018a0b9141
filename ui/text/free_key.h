// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSet>
#include <QString>

namespace axiscomp::ui {

/// A name with a key that nothing else has yet: of its letters, or a digit behind it. used gets it.
[[nodiscard]] QString withFreeKey(QString name, QSet<QChar>& used);

/// "Save" of "&Save"
[[nodiscard]] QString withoutKey(QString text);

} // namespace axiscomp::ui
