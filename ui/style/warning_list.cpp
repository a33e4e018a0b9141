// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/warning_list.h"

#include "ui/style/contrast.h"
#include "ui/style/plain_label.h"
#include "ui/style/symbols.h"

#include <QBoxLayout>
#include <QEvent>
#include <QPainter>

namespace axiscomp::ui {

namespace {

constexpr int warningSymbolSize = 16;
const QLatin1StringView symbolName("warningSymbol");

} // namespace

WarningList::WarningList(QWidget* parent) : QWidget(parent), m_layout(new QVBoxLayout(this))
{
    m_layout->setContentsMargins(10, 6, 10, 6);
    m_layout->setSpacing(4);
    setVisible(false);
}

void WarningList::setWarnings(const QStringList& warnings)
{
    qDeleteAll(findChildren<QWidget*>(Qt::FindDirectChildrenOnly));
    m_warnings = warnings;
    for (const QString& warning : warnings)
        addWarning(warning);
    setAccessibleName(tr("Warnings"));
    setAccessibleDescription(warnings.join(u' '));
    colour();
    setVisible(!warnings.isEmpty());
}

void WarningList::addWarning(const QString& warning)
{
    auto* row = new QWidget;
    auto* symbol = new PlainLabel;
    symbol->setObjectName(symbolName);
    symbol->setAccessibleName(tr("Warning"));
    auto* text = new PlainLabel(warning);
    text->setObjectName(QStringLiteral("warningText"));
    text->setWordWrap(true);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addWidget(symbol, 0, Qt::AlignTop);
    layout->addWidget(text, 1);
    m_layout->addWidget(row);
}

void WarningList::colour()
{
    const auto symbols = findChildren<QLabel*>(symbolName);
    for (QLabel* symbol : symbols)
        symbol->setPixmap(symbolPixmap(Symbol::Warning, frameColor(Tone::Warning, palette()),
            warningSymbolSize, devicePixelRatioF()));
}

void WarningList::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange)
        colour();
    QWidget::changeEvent(event);
}

void WarningList::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(frameColor(Tone::Warning, palette()), 1.0));
    painter.setBrush(fillColor(Tone::Warning, palette()));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
}

} // namespace axiscomp::ui
