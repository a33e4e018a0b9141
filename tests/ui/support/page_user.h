// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/patience.h"
#include "tests/ui/support/window_test.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QTest>
#include <QTimer>
#include <QWindow>

#include <functional>

namespace axiscomp::test {

/// What a person can do: see what is shown, press keys, click. Everything goes to the window, so
/// that what is hidden, covered or disabled gets nothing. false, with the reason in the log, when
/// it cannot be done.
class PageUser {
public:
    explicit PageUser(QWidget& window) : m_window(window) { }

    [[nodiscard]] bool isThere() { return showActive(m_window); }

    /// The newest widget of this name in the window or its dialogs; null: there is none.
    template <typename T = QWidget> [[nodiscard]] T* find(const char* name) const
    {
        const auto found = m_window.findChildren<T*>(QLatin1StringView(name));
        return found.isEmpty() ? nullptr : found.last();
    }
    template <typename T = QWidget> [[nodiscard]] T& the(const char* name) const
    {
        T* found = find<T>(name);
        if (!found)
            qFatal("there is no %s", name);
        return *found;
    }
    [[nodiscard]] bool sees(const char* name) const
    {
        const auto* widget = find(name);
        return widget && widget->isVisible();
    }
    /// The text of a message of the page; empty: it is not there.
    [[nodiscard]] QString message(const char* id) const
    {
        const auto* bar = find(id);
        const auto* text = bar ? bar->findChild<QLabel*>(QStringLiteral("messageText")) : nullptr;
        return text && text->isVisible() ? text->text() : QString();
    }
    [[nodiscard]] QString note(const char* field) const
    {
        QString text = the<QLabel>(QByteArray(field) + "Note").text();
        return text.remove(QChar(0x200b));
    }
    [[nodiscard]] QString hint() const { return the<QLabel>("hint").text(); }

    /// Waits until the widget can be used.
    [[nodiscard]] bool click(const char* name)
    {
        if (!waitFor([&] {
                const auto* widget = find(name);
                return widget && widget->isVisible() && widget->isEnabled();
            }))
            return cannot(name, "click");
        QWidget& widget = the(name);
        bringIntoView(widget);
        return clickAt(widget, placeOf(widget));
    }
    /// The part of a check box that can be clicked is at its beginning.
    [[nodiscard]] static QPoint placeOf(const QWidget& widget)
    {
        if (widget.inherits("QCheckBox"))
            return {16, widget.height() / 2};
        return widget.rect().center();
    }
    /// The window that has the keyboard: between two windows there is none for a moment, and a list
    /// or menu that was quickly closed can be told too late that it has it. A list of proposals
    /// belongs to no window: it hands on what it gets.
    static QWindow* focusWindow()
    {
        static_cast<void>(waitFor([] {
            const QWindow* window = QGuiApplication::focusWindow();
            return window && (window->isVisible() || !activatesOwnerOf(*window));
        }));
        return QGuiApplication::focusWindow();
    }
    static bool activatesOwnerOf(const QWindow& popup)
    {
        for (const QWidget* widget : QApplication::topLevelWidgets()) {
            if (widget->windowHandle() == &popup && widget->parentWidget()) {
                widget->parentWidget()->window()->activateWindow();
                return true;
            }
        }
        return false;
    }
    static void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
    {
        QTest::keyClick(focusWindow(), key, modifiers);
    }
    static void type(const QString& text)
    {
        for (const QChar c : text)
            QTest::keyClick(focusWindow(), c.toLatin1());
    }
    /// Types a text into a field and confirms it.
    [[nodiscard]] bool enter(const QByteArray& field, const QString& text)
    {
        if (!click(field))
            return false;
        press(Qt::Key_A, Qt::ControlModifier);
        type(text);
        press(Qt::Key_Return);
        return true;
    }
    /// An entry of a combo box, by mouse.
    [[nodiscard]] bool choose(const char* combo, const QString& entry)
    {
        if (!waitFor([&] {
                const auto* box = find<QComboBox>(combo);
                return box && box->isEnabled() && box->findText(entry, Qt::MatchContains) >= 0;
            }))
            return cannot(combo, qPrintable(QStringLiteral("choose ") + entry));
        auto& box = the<QComboBox>(combo);
        bringIntoView(box);
        const auto arrow = [&] { return QPoint(box.width() - 10, box.height() / 2); };
        if (!clickAt(box, arrow))
            return false;
        QAbstractItemView* list = box.view();
        if (!waitFor([&] { return list->isVisible(); }))
            return cannot(combo, "open");
        const QModelIndex index = box.model()->index(
            box.findText(entry, Qt::MatchContains), box.modelColumn(), box.rootModelIndex());
        list->scrollTo(index);
        return clickAt(*list->viewport(), list->visualRect(index).center());
    }

    /// An entry of a button's menu, by its key; the menu keeps the click until it is closed.
    [[nodiscard]] bool pickFromMenu(const char* button, const char* menu, Qt::Key key)
    {
        bool isPressed = false;
        QTimer poll;
        QObject::connect(&poll, &QTimer::timeout, &poll, [&] {
            if (!sees(menu))
                return;
            poll.stop();
            isPressed = true;
            press(key);
        });
        poll.start(10);
        return click(button) && waitFor([&] { return isPressed && !sees(menu); });
    }

    template <typename Condition> static bool waitFor(const Condition& condition)
    {
        return QTest::qWaitFor(condition, patienceMs);
    }

private:
    static bool cannot(const char* name, const char* what)
    {
        qInfo("cannot %s %s", what, name);
        return false;
    }
    void bringIntoView(QWidget& widget) const
    {
        for (QWidget* parent = widget.parentWidget(); parent; parent = parent->parentWidget()) {
            if (auto* area = qobject_cast<QScrollArea*>(parent))
                area->ensureWidgetVisible(&widget);
        }
    }
    /// Through the window: what lies above the widget gets the click.
    static bool clickAt(QWidget& widget, const QPoint& place)
    {
        return clickAt(widget, [&] { return place; });
    }
    /// place: where it is in the widget, whose size may still change.
    static bool clickAt(QWidget& widget, const std::function<QPoint()>& place)
    {
        const QWidget* window = widget.window();
        QPoint inWindow;
        const QWidget* hit = nullptr;
        const auto isHit = [&] {
            inWindow = widget.mapTo(window, place());
            hit = window->childAt(inWindow);
            return hit == &widget || widget.isAncestorOf(hit);
        };
        constexpr int untilLaidOut = 5000; // a window may have to grow first
        QCoreApplication::processEvents();
        if (!QTest::qWaitFor(isHit, untilLaidOut)) {
            qInfo("%s is covered by %s", qPrintable(widget.objectName()),
                hit ? qPrintable(
                    hit->objectName() + u' ' + QLatin1StringView(hit->metaObject()->className()))
                    : "nothing");
            return false;
        }
        QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {}, inWindow);
        return true;
    }

    QWidget& m_window;
};

} // namespace axiscomp::test
