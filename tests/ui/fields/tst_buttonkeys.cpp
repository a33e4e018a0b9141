// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/window_test.h"
#include "ui/fields/button_keys.h"
#include "ui/fields/number_edit.h"

#include <QBoxLayout>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>

namespace tst_buttonkeys {

using axiscomp::ui::ButtonKeys;
using axiscomp::ui::NumberEdit;

/// What a button uses is what the fields show.
class TestButtonKeys : public QObject {
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
        new ButtonKeys(window); // which owns it
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
};

AXISCOMP_WINDOW_TEST(TestButtonKeys)

} // namespace tst_buttonkeys

#include "tst_buttonkeys.moc"
