// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/fields/shortcut_keys.h"

#include <QAbstractButton>
#include <QApplication>
#include <QFocusEvent>
#include <QPointer>
#include <QShortcutEvent>

namespace axiscomp::ui {

namespace {

bool belongsTo(const QObject* object, const QObject& root)
{
    while (object && object != &root)
        object = object->parent();
    return object != nullptr;
}

/// As if the focus went elsewhere and came back.
void takeTyped(QWidget& field)
{
    const QPointer<QWidget> lasting(&field);
    QFocusEvent leaves(QEvent::FocusOut, Qt::ShortcutFocusReason);
    QCoreApplication::sendEvent(&field, &leaves);
    if (!lasting)
        return;
    QFocusEvent comesBack(QEvent::FocusIn, Qt::OtherFocusReason);
    QCoreApplication::sendEvent(lasting, &comesBack);
}

} // namespace

ShortcutKeys::ShortcutKeys(QWidget& root) : QObject(&root), m_root(root)
{
    qApp->installEventFilter(this);
}

bool ShortcutKeys::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::Shortcut || static_cast<QShortcutEvent*>(event)->isAmbiguous()
        || !belongsTo(watched, m_root))
        return false;
    auto* button = qobject_cast<QAbstractButton*>(watched);
    if (button && (button->focusPolicy() & Qt::ClickFocus) != 0)
        button->setFocus(Qt::ShortcutFocusReason);
    else if (QWidget* field = QApplication::focusWidget(); field && belongsTo(field, m_root))
        takeTyped(*field);
    return false;
}

} // namespace axiscomp::ui
