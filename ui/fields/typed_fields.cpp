// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/fields/typed_fields.h"

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

const QAbstractButton* buttonOf(const QObject& watched)
{
    return qobject_cast<const QAbstractButton*>(&watched);
}

bool takesFocusByClick(const QAbstractButton& button)
{
    return button.isEnabled() && (button.focusPolicy() & Qt::ClickFocus) != 0;
}

/// While its list of proposals is open, a field is not told that the focus goes.
void closeProposals(const QWidget& field)
{
    QWidget* popup = QApplication::activePopupWidget();
    if (popup && popup->focusProxy() == &field)
        popup->hide();
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

TypedFields::TypedFields(QWidget& root) : QObject(&root), m_root(root)
{
    qApp->installEventFilter(this);
}

bool TypedFields::isUse(const QObject& watched, const QEvent& event) const
{
    switch (event.type()) {
    case QEvent::Shortcut:
        return !static_cast<const QShortcutEvent&>(event).isAmbiguous()
            && belongsTo(&watched, m_root);
    case QEvent::MouseButtonPress: {
        const QAbstractButton* button = buttonOf(watched);
        return button && !takesFocusByClick(*button) && belongsTo(button, m_root);
    }
    case QEvent::Drop:
        return belongsTo(&watched, m_root);
    case QEvent::Close:
        return &watched == m_root.window();
    default:
        return false;
    }
}

bool TypedFields::eventFilter(QObject* watched, QEvent* event)
{
    if (!isUse(*watched, *event))
        return false;
    QWidget* field = QApplication::focusWidget();
    // A part of the field itself, such as its arrow, belongs to the typing.
    const bool isTyped = field && belongsTo(field, m_root) && !belongsTo(watched, *field);
    if (isTyped)
        closeProposals(*field);
    auto* button = qobject_cast<QAbstractButton*>(watched);
    if (button && takesFocusByClick(*button))
        button->setFocus(Qt::ShortcutFocusReason);
    else if (isTyped)
        takeTyped(*field);
    return false;
}

} // namespace axiscomp::ui
