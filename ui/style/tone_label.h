// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/style/contrast.h"
#include "ui/style/plain_label.h"

#include <optional>

namespace axiscomp::ui {

/// A label whose text has the colour of a tone, also after the palette has changed.
class ToneLabel : public PlainLabel {
public:
    using PlainLabel::PlainLabel;

    /// None: as other text.
    void setTone(std::optional<Tone> tone);
    /// Less important than other text.
    void setMuted();

protected:
    void changeEvent(QEvent* event) override;

private:
    void colour();

    std::optional<Tone> m_tone;
    bool m_isMuted = false;
};

} // namespace axiscomp::ui
