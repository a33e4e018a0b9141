// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/plain_tool_tips.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QHelpEvent>
#include <QTextDocument>
#include <QToolTip>
#include <QWidget>

namespace axiscomp::ui {

namespace {

/// Also of a dialog of it.
bool isBelow(const QWidget* widget, const QWidget& root)
{
    while (widget && widget != &root)
        widget = widget->parentWidget();
    return widget != nullptr;
}

/// Of a widget, or of the item of a view under the pointer.
QString toolTipOf(const QWidget& widget, const QPoint& position)
{
    const auto* view = qobject_cast<const QAbstractItemView*>(widget.parentWidget());
    if (view && view->viewport() == &widget)
        return view->indexAt(position).data(Qt::ToolTipRole).toString();
    return widget.toolTip();
}

} // namespace

PlainToolTips::PlainToolTips(QWidget& root) : QObject(&root), m_root(root)
{
    qApp->installEventFilter(this);
}

bool PlainToolTips::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::ToolTip)
        return false;
    auto* widget = qobject_cast<QWidget*>(watched);
    if (!isBelow(widget, m_root))
        return false;
    const auto* help = static_cast<QHelpEvent*>(event);
    const QString text = toolTipOf(*widget, help->pos());
    if (!Qt::mightBeRichText(text))
        return false;
    QToolTip::showText(help->globalPos(), Qt::convertFromPlainText(text), widget);
    return true;
}

} // namespace axiscomp::ui
