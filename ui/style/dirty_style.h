// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProxyStyle>

namespace axiscomp::ui {

/// Draws a 2 px frame round editors whose value differs from the drive's. Everything else, size
/// included, is the native style's. Set on the editors themselves, so that a program that embeds
/// the wizard keeps its own style.
class DirtyStyle : public QProxyStyle {
    Q_OBJECT

public:
    /// On a style of its own, of the same kind as the application's.
    DirtyStyle();

    static constexpr int frameWidth = 2;

    /// Marks an editor as one whose frame shows that it is dirty: combo boxes, line edits and check
    /// boxes.
    static void setDirty(QWidget& editor, bool dirty);
    [[nodiscard]] static bool isDirty(const QWidget& editor);

    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
        QPainter* painter, const QWidget* widget) const override;
    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
        const QWidget* widget) const override;
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
        const QWidget* widget) const override;
    [[nodiscard]] QRect subElementRect(
        SubElement element, const QStyleOption* option, const QWidget* widget) const override;
    [[nodiscard]] QSize sizeFromContents(ContentsType type, const QStyleOption* option,
        const QSize& size, const QWidget* widget) const override;
};

} // namespace axiscomp::ui
