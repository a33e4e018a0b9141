// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QComboBox>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QStyle>
#include <QStyleOptionButton>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QTreeView>
#include <QWidget>

namespace axiscomp::test {

namespace text_fit {

/// Of a text as it is drawn: a single & marks a key.
inline int widthOf(const QWidget& widget, const QString& text)
{
    return widget.fontMetrics().size(Qt::TextShowMnemonic, text).width();
}

inline QString described(const QWidget& widget, const QString& text, const QString& problem)
{
    return QStringLiteral("%1 %2 \"%3\": %4")
        .arg(QLatin1StringView(widget.metaObject()->className()), widget.objectName(),
            text.left(60), problem);
}

/// Somebody who points at it is told the whole text: it is one of a file or a drive, as long as it
/// likes.
inline bool isToldWhole(const QWidget& widget, const QString& text)
{
    return widget.toolTip().contains(text);
}

/// What it shows is of a file or a drive, and whole in its list.
inline bool holdsData(const QComboBox& combo)
{
    static const QStringList names{QStringLiteral("driveField"), QStringLiteral("axisField"),
        QStringLiteral("tableField"), QStringLiteral("multiAxisSources"),
        QStringLiteral("stationField"), QStringLiteral("appliedBy"),
        QStringLiteral("conversionFormat")};
    return combo.isEditable() || names.contains(combo.objectName());
}

inline QString labelProblem(const QLabel& label)
{
    const QString text = label.text();
    if (text.isEmpty() || label.textFormat() == Qt::RichText)
        return {};
    const int margins = 2 * label.margin() + 2 * label.frameWidth();
    if (label.wordWrap()) {
        const int needed = label.heightForWidth(label.width());
        return needed > label.height() + margins
            ? QStringLiteral("%1 high, needs %2").arg(label.height()).arg(needed)
            : QString();
    }
    const int needed = margins
        + (label.buddy() ? widthOf(label, text) : label.fontMetrics().size(0, text).width());
    return needed > label.width() && !isToldWhole(label, text)
        ? QStringLiteral("%1 wide, needs %2").arg(label.width()).arg(needed)
        : QString();
}

inline QString buttonProblem(const QAbstractButton& button)
{
    if (button.text().isEmpty())
        return {};
    const bool hasIcon = !button.icon().isNull();
    int needed = widthOf(button, button.text()) + (hasIcon ? button.iconSize().width() + 4 : 0);
    if (button.inherits("QCheckBox") || button.inherits("QRadioButton"))
        needed += button.style()->pixelMetric(QStyle::PM_IndicatorWidth)
            + button.style()->pixelMetric(QStyle::PM_CheckBoxLabelSpacing);
    else
        needed += 4;
    return needed > button.width()
        ? QStringLiteral("%1 wide, needs %2").arg(button.width()).arg(needed)
        : QString();
}

inline QString comboProblem(const QComboBox& combo)
{
    const QString text = combo.currentText();
    if (text.isEmpty() || isToldWhole(combo, text) || holdsData(combo))
        return {};
    QStyleOptionComboBox option;
    option.initFrom(&combo);
    option.editable = combo.isEditable();
    option.frame = combo.hasFrame();
    const int room =
        combo.style()
            ->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &combo)
            .width();
    const int needed = combo.fontMetrics().horizontalAdvance(text);
    return needed > room ? QStringLiteral("room for %1, needs %2").arg(room).arg(needed)
                         : QString();
}

inline QString lineProblem(const QLineEdit& line)
{
    if (!line.text().isEmpty() || line.placeholderText().isEmpty())
        return {};
    const int needed = line.fontMetrics().horizontalAdvance(line.placeholderText()) + 8;
    return needed > line.width() && !isToldWhole(line, line.placeholderText())
        ? QStringLiteral("%1 wide, placeholder needs %2").arg(line.width()).arg(needed)
        : QString();
}

inline QString tabsProblem(const QTabBar& tabs)
{
    for (int i = 0; i < tabs.count(); ++i) {
        if (!tabs.isTabVisible(i))
            continue;
        // The bar scrolls to those that have no room beside each other.
        const QRect place = tabs.tabRect(i);
        const bool isOutside = i == tabs.currentIndex() && place.right() > tabs.width();
        if (widthOf(tabs, tabs.tabText(i)) > place.width() || isOutside)
            return QStringLiteral("tab \"%1\" has not enough room").arg(tabs.tabText(i));
    }
    return {};
}

inline QString headerProblem(const QHeaderView& header)
{
    if (header.orientation() != Qt::Horizontal)
        return {};
    for (int section = 0; section < header.count(); ++section) {
        const QString title = header.model()->headerData(section, Qt::Horizontal).toString();
        if (!header.isSectionHidden(section) && !title.isEmpty()
            && header.fontMetrics().horizontalAdvance(title) + 4 > header.sectionSize(section))
            return QStringLiteral("heading \"%1\" has %2 pixels")
                .arg(title)
                .arg(header.sectionSize(section));
    }
    return {};
}

inline QString groupProblem(const QGroupBox& group)
{
    return widthOf(group, group.title()) + 8 > group.width() ? QStringLiteral("title is cut")
                                                             : QString();
}

inline QString textProblem(const QWidget& widget)
{
    if (const auto* label = qobject_cast<const QLabel*>(&widget))
        return labelProblem(*label);
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
        return buttonProblem(*button);
    if (const auto* combo = qobject_cast<const QComboBox*>(&widget))
        return comboProblem(*combo);
    if (const auto* line = qobject_cast<const QLineEdit*>(&widget))
        return lineProblem(*line);
    if (const auto* tabs = qobject_cast<const QTabBar*>(&widget))
        return tabsProblem(*tabs);
    if (const auto* header = qobject_cast<const QHeaderView*>(&widget))
        return headerProblem(*header);
    if (const auto* group = qobject_cast<const QGroupBox*>(&widget))
        return groupProblem(*group);
    return {};
}

inline QString textOf(const QWidget& widget)
{
    if (const auto* label = qobject_cast<const QLabel*>(&widget))
        return label->text();
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
        return button->text();
    if (const auto* combo = qobject_cast<const QComboBox*>(&widget))
        return combo->currentText();
    return {};
}

/// What is scrolled can be reached; anything else has to lie within its parent.
inline QString placeProblem(const QWidget& widget)
{
    const QWidget* parent = widget.parentWidget();
    // A picture of a table is drawn as large as there is room, and loses a pixel or two of its rim
    // where the log is open on the smallest screen.
    const bool isPicture = widget.inherits("QCustomPlot");
    if (!parent || widget.isWindow() || isPicture || parent->inherits("QHeaderView"))
        return {};
    const auto* area = qobject_cast<const QAbstractScrollArea*>(parent->parentWidget());
    if (area && area->viewport() == parent) {
        const bool isWide = widget.width() > parent->width()
            && area->horizontalScrollBarPolicy() == Qt::ScrollBarAlwaysOff;
        return isWide ? QStringLiteral("is wider than what shows it") : QString();
    }
    return parent->rect().contains(widget.geometry())
        ? QString()
        : QStringLiteral("is not within its parent %1").arg(parent->objectName());
}

} // namespace text_fit

/// What of a window is cut or out of sight, a line each; empty: everything fits.
[[nodiscard]] inline QStringList fitProblems(const QWidget& window)
{
    QStringList problems;
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        if (!widget->isVisible() || widget->window() != &window)
            continue;
        for (const QString& problem :
            {text_fit::textProblem(*widget), text_fit::placeProblem(*widget)}) {
            if (!problem.isEmpty())
                problems += text_fit::described(*widget, text_fit::textOf(*widget), problem);
        }
    }
    problems.removeDuplicates();
    return problems;
}

} // namespace axiscomp::test
