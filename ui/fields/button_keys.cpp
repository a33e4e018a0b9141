// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/fields/button_keys.h"

#include <QAbstractButton>
#include <QApplication>
#include <QShortcutEvent>

namespace axiscomp::ui {

namespace {

bool belongsTo(const QObject* object, const QObject& root)
{
    while (object && object != &root)
        object = object->parent();
    return object != nullptr;
}

} // namespace

ButtonKeys::ButtonKeys(QWidget& root) : QObject(&root), m_root(root)
{
    qApp->installEventFilter(this);
}

bool ButtonKeys::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::Shortcut)
        return false;
    auto* button = qobject_cast<QAbstractButton*>(watched);
    const bool isKey = button && !static_cast<QShortcutEvent*>(event)->isAmbiguous();
    if (isKey && (button->focusPolicy() & Qt::ClickFocus) != 0 && belongsTo(button, m_root))
        button->setFocus(Qt::ShortcutFocusReason);
    return false;
}

} // namespace axiscomp::ui
