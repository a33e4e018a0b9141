// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace axiscomp::ui {

/// Of everything in a widget that is there more than once in the window: "addMeasurement" becomes
/// "afterAddMeasurement". An empty prefix changes nothing.
inline void prefixNames(const QString& prefix, const QWidget& widget)
{
    if (prefix.isEmpty())
        return;
    const auto children = widget.findChildren<QWidget*>();
    for (QWidget* child : children) {
        QString name = child->objectName();
        if (name.isEmpty() || name.startsWith(QStringLiteral("qt_")))
            continue;
        name[0] = name[0].toUpper();
        child->setObjectName(prefix + name);
    }
}

} // namespace axiscomp::ui
