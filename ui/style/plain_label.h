// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace axiscomp::ui {

/// A label whose text is never taken for markup: what a drive or a file says may look like it.
class PlainLabel : public QLabel {
public:
    explicit PlainLabel(QWidget* parent = nullptr) : QLabel(parent)
    {
        setTextFormat(Qt::PlainText);
    }
    explicit PlainLabel(const QString& text, QWidget* parent = nullptr) : PlainLabel(parent)
    {
        setText(text);
    }

    /// A long word does not make a window wider than a screen: it is cut off where there is no
    /// room.
    [[nodiscard]] QSize minimumSizeHint() const override
    {
        constexpr int characters = 60;
        const QSize hint = QLabel::minimumSizeHint();
        const int widest = characters * fontMetrics().averageCharWidth();
        return text().isEmpty() ? hint : hint.boundedTo({widest, hint.height()});
    }
};

} // namespace axiscomp::ui
