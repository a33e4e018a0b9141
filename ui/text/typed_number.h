// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"

#include <QLocale>
#include <QString>
#include <QStringList>

#include <optional>

namespace axiscomp::ui {

/// Whether the language reads it only with a sign between thousands: "1,000" is no thousand here,
/// and no one either. "0,016" has none.
[[nodiscard]] bool hasThousands(const QString& text, const QLocale& language = QLocale());
/// What a person has typed, as the language writes it, or with a point where that can be nothing
/// else. Nothing: it is no finite number, or hasThousands().
[[nodiscard]] std::optional<double> typedNumber(const QString& text);
/// The parts of a list, "21; 31", in which blanks separate, too, and commas where hasCommas.
/// Nothing: one of these may stand between thousands, as in "1 250".
[[nodiscard]] std::optional<QStringList> typedList(const QString& text, bool hasCommas = false);
/// Why a text that hasThousands() is not taken.
[[nodiscard]] Text thousandsProblem(const QString& text);

} // namespace axiscomp::ui
