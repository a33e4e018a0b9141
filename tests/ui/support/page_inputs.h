// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QTabBar>

namespace axiscomp::test {

/// Something that takes a value.
[[nodiscard]] inline bool isField(const QWidget& widget)
{
    return qobject_cast<const QComboBox*>(&widget) || qobject_cast<const QLineEdit*>(&widget)
        || qobject_cast<const QAbstractSpinBox*>(&widget) || qobject_cast<const QSlider*>(&widget)
        || widget.inherits("QCheckBox");
}

/// A part of another input: the line of a combo box, the cross in a line edit.
[[nodiscard]] inline bool isPartOfInput(const QWidget& widget)
{
    for (const QWidget* parent = widget.parentWidget(); parent && !widget.isWindow();
         parent = parent->parentWidget()) {
        if (isField(*parent) || qobject_cast<const QTabBar*>(parent)
            || qobject_cast<const QAbstractItemView*>(parent))
            return true;
    }
    return false;
}

/// Everything visible that a person can use: fields, buttons, lists, tabs.
[[nodiscard]] inline QList<QWidget*> visibleInputs(QWidget& window)
{
    QList<QWidget*> inputs;
    const auto children = window.findChildren<QWidget*>();
    for (QWidget* child : children) {
        const bool isInput = isField(*child) || qobject_cast<QAbstractButton*>(child)
            || qobject_cast<QAbstractItemView*>(child) || qobject_cast<QTabBar*>(child);
        if (isInput && child->isVisible() && child->window() == &window
            && !qobject_cast<QHeaderView*>(child) && !isPartOfInput(*child))
            inputs += child;
    }
    return inputs;
}

/// Fields and push buttons of the page. What belongs to the picture, and the small tools, are
/// reached by the Tab key; a dialog's standard buttons by Return and Escape.
[[nodiscard]] inline bool needsMnemonic(const QWidget& input)
{
    const auto* line = qobject_cast<const QLineEdit*>(&input);
    if (line && line->isReadOnly())
        return false;
    for (const QWidget* parent = input.parentWidget(); parent; parent = parent->parentWidget()) {
        if (parent->objectName() == QStringLiteral("tablePlot")
            || parent->objectName() == QStringLiteral("fitMap")
            || qobject_cast<const QDialogButtonBox*>(parent))
            return false;
    }
    if (input.objectName() == QStringLiteral("appliedBy"))
        return false; // as the tools of the picture, which it is about
    if (input.objectName() == QStringLiteral("activateMenuButton"))
        return false; // one key further than Activate
    return isField(input) || qobject_cast<const QPushButton*>(&input);
}

} // namespace axiscomp::test
