// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/text/diagnostic.h"

#include <QString>

namespace axiscomp::ui {

/// The translated sentence of an error (context "Error" in the translations).
[[nodiscard]] QString errorText(const Error& error);
/// Of the same sentence: they may differ in what only the log shows.
[[nodiscard]] bool saysTheSame(const Error& a, const Error& b);
/// The translated sentence of a file's problem.
[[nodiscard]] QString problemText(const Diagnostic& diagnostic);
/// "verifying the table", for the ids that core reports as Progress::step.
[[nodiscard]] QString stepText(const QString& step);
/// A plan's warning, a remark on a conversion, as a sentence.
[[nodiscard]] QString sentenceText(const Text& text);

/// The text begins with a capital letter and ends as a sentence does.
[[nodiscard]] QString asSentence(const QString& text);

} // namespace axiscomp::ui
