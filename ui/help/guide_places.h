// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QWidget;

namespace axiscomp::ui {

/// A place of the user guide: below a heading, and there the cell of a table. As the guide has
/// them.
struct GuidePlace {
    QString heading; ///< empty: the beginning
    QString cell; ///< empty: the heading itself
    friend bool operator==(const GuidePlace&, const GuidePlace&) = default;
};

/// Where the guide says something about a widget, or about what it is part of; null: the beginning.
[[nodiscard]] GuidePlace guidePlaceOf(const QWidget* widget);

} // namespace axiscomp::ui
