// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/style/contrast.h"

#include <QColor>
#include <QIcon>
#include <QPixmap>

namespace axiscomp::ui {

/// The page's own line symbols, drawn in the palette's text colour at any size and scale.
enum class Symbol {
    Open,
    Refresh,
    Revert,
    Connections,
    Menu,
    Log,
    Close,
    Copy,
    Save,
    Add,
    Remove,
    Edit,
    Information,
    Warning,
    Error,
    Success,
};

/// Follows the application's palette, disabled state included.
[[nodiscard]] QIcon symbolIcon(Symbol symbol);
/// size in device-independent pixels.
[[nodiscard]] QPixmap symbolPixmap(Symbol symbol, const QColor& color, int size, qreal pixelRatio);

[[nodiscard]] Symbol symbolOf(Tone tone);
/// The symbol of a tone in its colour, for a cell, which may be selected.
[[nodiscard]] QIcon cellIcon(Tone tone);

} // namespace axiscomp::ui
