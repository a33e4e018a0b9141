// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tabs/next_step.h"

#include "ui/style/plain_label.h"
#include "ui/style/symbols.h"

#include <QBoxLayout>

namespace axiscomp::ui {

NextStep::NextStep(const QString& name, QWidget* parent)
    : QWidget(parent)
    , m_symbol(new PlainLabel)
    , m_text(new PlainLabel)
{
    m_text->setObjectName(name);
    m_text->setWordWrap(true);
    m_text->setMinimumHeight(2 * m_text->fontMetrics().lineSpacing());
    m_text->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_text->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addWidget(m_symbol, 0, Qt::AlignTop);
    layout->addWidget(m_text, 1);
}

void NextStep::say(Tone tone, const QString& sentence)
{
    constexpr int size = 16;
    m_symbol->setPixmap(
        symbolPixmap(symbolOf(tone), frameColor(tone, palette()), size, devicePixelRatioF()));
    m_text->setText(sentence);
    m_text->setToolTip(sentence);
}

} // namespace axiscomp::ui
