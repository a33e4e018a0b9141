// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/tone_label.h"

#include <QEvent>

namespace axiscomp::ui {

void ToneLabel::setTone(std::optional<Tone> tone)
{
    m_tone = tone;
    m_isMuted = false;
    colour();
}

void ToneLabel::setMuted()
{
    m_tone.reset();
    m_isMuted = true;
    colour();
}

void ToneLabel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::ParentChange)
        colour();
    PlainLabel::changeEvent(event);
}

/// From the palette around the label: its own has the colour of before.
void ToneLabel::colour()
{
    const QPalette around = parentWidget() ? parentWidget()->palette() : QPalette();
    QPalette own;
    own.setResolveMask(0);
    if (m_tone)
        own.setColor(QPalette::WindowText, textColor(*m_tone, around));
    else if (m_isMuted)
        own.setColor(QPalette::WindowText, mutedTextColor(around));
    const bool isSame = own.resolveMask() == 0 ? !testAttribute(Qt::WA_SetPalette)
                                               : testAttribute(Qt::WA_SetPalette)
            && own.color(QPalette::WindowText) == palette().color(QPalette::WindowText);
    if (!isSame)
        setPalette(own);
}

} // namespace axiscomp::ui
