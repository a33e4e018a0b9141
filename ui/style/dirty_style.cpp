// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/dirty_style.h"

#include "ui/style/contrast.h"

#include <QApplication>
#include <QPainter>
#include <QStyleFactory>
#include <QStyleOption>
#include <QWidget>

namespace axiscomp::ui {

namespace {

constexpr char propertyName[] = "axiscompDirty";
// A check box has no frame of its own: its contents keep clear of ours, changed or not.
constexpr int checkBoxPadding = 6;

bool isField(const QWidget* widget)
{
    return widget != nullptr && widget->property(propertyName).isValid();
}

void drawFrame(const QStyleOption& option, QPainter& painter)
{
    // The native frame shows the focus by its outermost pixel: it stays visible around ours.
    const bool hasFocus = option.state.testFlag(QStyle::State_HasFocus);
    const qreal inset = DirtyStyle::frameWidth / 2.0 + (hasFocus ? 1.0 : 0.0);
    const QRectF frame = QRectF(option.rect).adjusted(inset, inset, -inset, -inset);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(frameColor(Tone::Changed, option.palette), DirtyStyle::frameWidth));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(frame, 2.0, 2.0);
    painter.restore();
}

} // namespace

DirtyStyle::DirtyStyle() : QProxyStyle(QStyleFactory::create(QApplication::style()->name())) { }

void DirtyStyle::setDirty(QWidget& editor, bool dirty)
{
    if (isField(&editor) && isDirty(editor) == dirty)
        return;
    editor.setProperty(propertyName, dirty);
    editor.update();
}

bool DirtyStyle::isDirty(const QWidget& editor)
{
    return editor.property(propertyName).toBool();
}

void DirtyStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
    QPainter* painter, const QWidget* widget) const
{
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    if (control == CC_ComboBox && widget != nullptr && isDirty(*widget))
        drawFrame(*option, *painter);
}

void DirtyStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
    const QWidget* widget) const
{
    QProxyStyle::drawControl(element, option, painter, widget);
    if (element == CE_CheckBox && widget != nullptr && isDirty(*widget))
        drawFrame(*option, *painter);
}

void DirtyStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
    QPainter* painter, const QWidget* widget) const
{
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    if (element == PE_PanelLineEdit && widget != nullptr && isDirty(*widget))
        drawFrame(*option, *painter);
}

QRect DirtyStyle::subElementRect(
    SubElement element, const QStyleOption* option, const QWidget* widget) const
{
    const QRect rect = QProxyStyle::subElementRect(element, option, widget);
    const bool isPartOfCheckBox = element == SE_CheckBoxIndicator || element == SE_CheckBoxContents
        || element == SE_CheckBoxFocusRect;
    if (!isPartOfCheckBox || !isField(widget))
        return rect;
    const int shift = option->direction == Qt::RightToLeft ? -checkBoxPadding : checkBoxPadding;
    return rect.translated(shift, 0);
}

QSize DirtyStyle::sizeFromContents(
    ContentsType type, const QStyleOption* option, const QSize& size, const QWidget* widget) const
{
    const QSize native = QProxyStyle::sizeFromContents(type, option, size, widget);
    if (type != CT_CheckBox || !isField(widget))
        return native;
    return native + QSize(2 * checkBoxPadding, 0);
}

} // namespace axiscomp::ui
