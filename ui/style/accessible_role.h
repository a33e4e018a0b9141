// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAccessible>
#include <QWidget>

namespace axiscomp::ui {

/// What a widget of our own is to a person who cannot see it; Qt knows that of its own classes.
/// To be called in the constructor: later the widget may have been looked at already.
void setAccessibleRole(QWidget& widget, QAccessible::Role role);

/// As QWidget's, but says nothing when nothing is new.
void announceName(QWidget& widget, const QString& name);

} // namespace axiscomp::ui
