// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QWidget;

namespace axiscomp::ui {

/// Fills a tab with two columns, whose border can be moved: what is chosen, and what comes of it.
/// name: that of the splitter.
void fillWithColumns(QWidget& tab, const QString& name, QWidget* chosen, QWidget* outcome);

} // namespace axiscomp::ui
