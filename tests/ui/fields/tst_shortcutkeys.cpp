// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/window_test.h"
#include "ui/fields/number_edit.h"
#include "ui/fields/shortcut_keys.h"

#include <QAction>
#include <QBoxLayout>
#include <QPushButton>
#include <QShortcut>
#include <QSpinBox>
#include <QTest>

namespace tst_shortcutkeys {

using axiscomp::ui::NumberEdit;
using axiscomp::ui::ShortcutKeys;

/// What a key uses is what the fields show.
class TestShortcutKeys : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { axiscomp::test::failOnWindowWarnings(); }

    void whatIsTypedIsTakenBeforeTheButtonUsesIt()
    {
        QWidget window;
        auto* layout = new QVBoxLayout(&window);
        auto* number = new NumberEdit(NumberEdit::Rule{});
        auto* count = new QSpinBox;
        count->setKeyboardTracking(false);
        auto* use = new QPushButton(QStringLiteral("&Use"));
        for (QWidget* widget : {static_cast<QWidget*>(number), static_cast<QWidget*>(count),
                 static_cast<QWidget*>(use)})
            layout->addWidget(widget);
        new ShortcutKeys(window); // which owns it
        std::vector<double> used;
        int counted = 0;
        connect(use, &QPushButton::clicked, this, [&] {
            used = number->numbers();
            counted = count->value();
        });
        QVERIFY(axiscomp::test::showActive(window));
        number->setFocus();
        QTest::keyClicks(number, QStringLiteral("5"));
        QTest::keyClick(number, Qt::Key_U, Qt::AltModifier);
        QTRY_COMPARE(used, std::vector{5.0});
        count->setFocus();
        count->selectAll();
        QTest::keyClicks(count, QStringLiteral("7"));
        QTest::keyClick(count, Qt::Key_U, Qt::AltModifier);
        QTRY_COMPARE(counted, 7);
    }

    void whatIsTypedIsTakenBeforeAKeyOfTheMenuOrThePageUsesIt()
    {
        QWidget window;
        auto* layout = new QVBoxLayout(&window);
        auto* number = new NumberEdit(NumberEdit::Rule{});
        layout->addWidget(number);
        auto* save = new QAction(&window);
        save->setShortcut(Qt::CTRL | Qt::Key_S);
        window.addAction(save);
        auto* write = new QShortcut(Qt::CTRL | Qt::Key_Return, &window);
        new ShortcutKeys(window); // which owns it
        std::vector<double> used;
        const auto use = [&] { used = number->numbers(); };
        connect(save, &QAction::triggered, this, use);
        connect(write, &QShortcut::activated, this, use);
        QVERIFY(axiscomp::test::showActive(window));
        number->setFocus();
        QTest::keyClicks(number, QStringLiteral("5"));
        QTest::keyClick(number, Qt::Key_S, Qt::ControlModifier);
        QTRY_COMPARE(used, std::vector{5.0});
        QTest::keyClicks(number, QStringLiteral("7"));
        QTest::keyClick(number, Qt::Key_Return, Qt::ControlModifier);
        QTRY_COMPARE(used, std::vector{57.0});
        QVERIFY(number->hasFocus());
        QCOMPARE(number->cursorPosition(), 2);
    }
};

AXISCOMP_WINDOW_TEST(TestShortcutKeys)

} // namespace tst_shortcutkeys

#include "tst_shortcutkeys.moc"
