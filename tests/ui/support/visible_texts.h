// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMap>
#include <QMenu>
#include <QProgressBar>
#include <QTabBar>
#include <QWidget>

namespace axiscomp::test {

/// Every text that a person at the window can see, hover over or be read to, by where it is.
using VisibleTexts = QMap<QString, QString>;

namespace visible_texts {

/// Object names from the window down; a number where there is none.
inline QString placeOf(const QObject& object, const QObject& root)
{
    QString place;
    for (const QObject* at = &object; at && at != &root; at = at->parent()) {
        QString name = at->objectName();
        if (name.isEmpty() && at->parent())
            name = QStringLiteral("%1#%2")
                       .arg(QLatin1StringView(at->metaObject()->className()))
                       .arg(at->parent()->children().indexOf(const_cast<QObject*>(at)));
        place.prepend(u'/' + name);
    }
    return place;
}

class Collector {
public:
    explicit Collector(const QWidget& root) : m_root(root) { }

    void collect()
    {
        m_texts[QStringLiteral("window title")] = m_root.windowTitle();
        for (const QWidget* widget : m_root.findChildren<QWidget*>()) {
            if (widget->isVisible())
                take(*widget);
        }
    }
    [[nodiscard]] const VisibleTexts& texts() const { return m_texts; }

private:
    void add(const QString& place, const char* what, const QString& text)
    {
        if (!text.isEmpty())
            m_texts[place + u' ' + QLatin1StringView(what)] = text;
    }
    void take(const QWidget& widget)
    {
        const QString place = placeOf(widget, m_root);
        add(place, "tooltip", widget.toolTip());
        add(place, "accessible name", widget.accessibleName());
        add(place, "accessible description", widget.accessibleDescription());
        if (const auto* label = qobject_cast<const QLabel*>(&widget))
            add(place, "text", label->text());
        if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
            add(place, "text", button->text());
        if (const auto* group = qobject_cast<const QGroupBox*>(&widget))
            add(place, "title", group->title());
        if (const auto* bar = qobject_cast<const QProgressBar*>(&widget))
            add(place, "text", bar->text());
        if (const auto* line = qobject_cast<const QLineEdit*>(&widget))
            add(place, "placeholder", line->placeholderText());
        takeItems(widget, place);
        for (const QAction* action : widget.actions())
            takeAction(*action, place);
        if (const auto* button = widget.findChild<QMenu*>(QString(), Qt::FindDirectChildrenOnly))
            takeMenu(*button, place);
    }
    void takeItems(const QWidget& widget, const QString& place)
    {
        if (const auto* combo = qobject_cast<const QComboBox*>(&widget)) {
            add(place, "placeholder", combo->placeholderText());
            for (int i = 0; i < combo->count(); ++i)
                add(place, qPrintable(QStringLiteral("item %1").arg(i)), combo->itemText(i));
        }
        if (const auto* tabs = qobject_cast<const QTabBar*>(&widget)) {
            for (int i = 0; i < tabs->count(); ++i)
                add(place, qPrintable(QStringLiteral("tab %1").arg(i)), tabs->tabText(i));
        }
        const auto* view = qobject_cast<const QAbstractItemView*>(&widget);
        if (!view || !view->model() || qobject_cast<const QHeaderView*>(view))
            return;
        const QAbstractItemModel& model = *view->model();
        for (int column = 0; column < model.columnCount(); ++column) {
            add(place, qPrintable(QStringLiteral("heading %1").arg(column)),
                model.headerData(column, Qt::Horizontal).toString());
            constexpr int mostRows = 50;
            for (int row = 0; row < std::min(model.rowCount(), mostRows); ++row)
                takeCell(model.index(row, column),
                    place + QStringLiteral(" cell %1,%2").arg(row).arg(column));
        }
    }
    void takeCell(const QModelIndex& index, const QString& place)
    {
        add(place, "text", index.data().toString());
        add(place, "tooltip", index.data(Qt::ToolTipRole).toString());
        add(place, "accessible text", index.data(Qt::AccessibleTextRole).toString());
    }
    void takeMenu(const QMenu& menu, const QString& place)
    {
        add(place + QStringLiteral(" menu"), "title", menu.title());
        for (const QAction* action : menu.actions()) {
            takeAction(*action, place + QStringLiteral(" menu"));
            if (action->menu())
                takeMenu(*action->menu(), place + u'/' + action->menu()->objectName());
        }
    }
    void takeAction(const QAction& action, const QString& place)
    {
        const QString name = place + u' ' + action.objectName();
        add(name, "action", action.text());
        if (action.toolTip() != action.iconText())
            add(name, "action tooltip", action.toolTip());
    }

    const QWidget& m_root;
    VisibleTexts m_texts;
};

} // namespace visible_texts

inline VisibleTexts visibleTexts(const QWidget& window)
{
    visible_texts::Collector collector(window);
    collector.collect();
    return collector.texts();
}

} // namespace axiscomp::test
