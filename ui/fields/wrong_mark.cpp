// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/fields/wrong_mark.h"

#include "ui/style/contrast.h"
#include "ui/style/symbols.h"

#include <QAction>
#include <QLineEdit>

namespace axiscomp::ui {

namespace {

QAction* markOf(const QLineEdit& edit)
{
    return edit.findChild<QAction*>(QStringLiteral("wrongMark"), Qt::FindDirectChildrenOnly);
}

} // namespace

void markWrong(QLineEdit& edit, bool isWrong)
{
    QAction* mark = markOf(edit);
    if (!mark && !isWrong)
        return;
    if (!mark) {
        mark = edit.addAction(QIcon(), QLineEdit::TrailingPosition);
        mark->setObjectName(QStringLiteral("wrongMark"));
    }
    constexpr int size = 16;
    mark->setIcon(QIcon(symbolPixmap(
        Symbol::Warning, frameColor(Tone::Error, edit.palette()), size, edit.devicePixelRatioF())));
    mark->setVisible(isWrong);
}

bool isMarkedWrong(const QLineEdit& edit)
{
    const QAction* mark = markOf(edit);
    return mark && mark->isVisible();
}

} // namespace axiscomp::ui
