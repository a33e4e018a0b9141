// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>

#include <span>

namespace axiscomp::ui {

/// WCAG 2.1: (lighter + 0.05) / (darker + 0.05) of the relative luminances, 1 to 21.
[[nodiscard]] double contrastRatio(const QColor& a, const QColor& b);

/// The color, made lighter or darker as little as needed to reach the ratio against every
/// background; the best there is when none reaches it.
[[nodiscard]] QColor withContrast(
    const QColor& color, std::span<const QColor> backgrounds, double ratio);

/// What a colour stands for. Never the only sign of it.
enum class Tone { Changed, Error, Warning, Success, Information };

/// For frames and symbols: at least 3:1 against the palette's Window and Base.
[[nodiscard]] QColor frameColor(Tone tone, const QPalette& palette);
/// For small text: at least 4.5:1 against the palette's Window and Base.
[[nodiscard]] QColor textColor(Tone tone, const QPalette& palette);
/// A tint of the palette's Window that keeps its WindowText readable.
[[nodiscard]] QColor fillColor(Tone tone, const QPalette& palette);
/// Text that is less important than WindowText, still 4.5:1 against Window and Base.
[[nodiscard]] QColor mutedTextColor(const QPalette& palette);

} // namespace axiscomp::ui
