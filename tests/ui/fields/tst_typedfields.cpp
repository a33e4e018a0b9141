// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/window_test.h"
#include "ui/fields/number_edit.h"
#include "ui/fields/source_combo.h"
#include "ui/fields/typed_fields.h"

#include <QAbstractItemView>
#include <QAction>
#include <QBoxLayout>
#include <QCloseEvent>
#include <QCompleter>
#include <QLineEdit>
#include <QPushButton>
#include <QShortcut>
#include <QSpinBox>
#include <QTest>
#include <QToolButton>

namespace tst_typedfields {

using axiscomp::ui::NumberEdit;
using axiscomp::ui::SourceCombo;
using axiscomp::ui::TypedFields;

/// What a key or a button uses is what the fields show.
class TestTypedFields : public QObject {
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
        new TypedFields(window); // which owns it
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
        new TypedFields(window); // which owns it
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

    void anOpenListOfProposalsDoesNotKeepWhatIsTyped_data()
    {
        QTest::addColumn<Qt::Key>("key");
        QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
        QTest::newRow("key of a button") << Qt::Key_U << Qt::KeyboardModifiers(Qt::AltModifier);
        QTest::newRow("key of the page")
            << Qt::Key_Return << Qt::KeyboardModifiers(Qt::ControlModifier);
    }
    void anOpenListOfProposalsDoesNotKeepWhatIsTyped()
    {
        QFETCH(Qt::Key, key);
        QFETCH(Qt::KeyboardModifiers, modifiers);
        QWidget window;
        auto* layout = new QVBoxLayout(&window);
        auto* source = new SourceCombo;
        source->setChoices({{QStringLiteral("tam://mc/M/Axes[0]/Position"), {}},
            {QStringLiteral("tam://mc/M/Axes[1]/Position"), {}}});
        auto* use = new QPushButton(QStringLiteral("&Use"));
        layout->addWidget(source);
        layout->addWidget(use);
        auto* write = new QShortcut(Qt::CTRL | Qt::Key_Return, &window);
        new TypedFields(window); // which owns it
        QString used;
        connect(source, &SourceCombo::chosen, this,
            [source](const QString& text) { source->showValue(text); });
        connect(use, &QPushButton::clicked, this, [&] { used = source->value(); });
        connect(write, &QShortcut::activated, this, [&] { used = source->value(); });
        QVERIFY(axiscomp::test::showActive(window));
        source->setFocus();
        const QString typed = QStringLiteral("Axes[1]/Position");
        for (const QChar c : typed)
            QTest::keyClick(window.windowHandle(), c.toLatin1());
        const QWidget* proposals = source->completer()->popup();
        QTRY_VERIFY(proposals->isVisible());
        QTest::keyClick(window.windowHandle(), key, modifiers);
        QTRY_COMPARE(used, typed);
        QVERIFY(!proposals->isVisible());
        QCOMPARE(source->currentText(), typed);
    }

    /// By the program, such as for the preview of a write.
    void anOpenListOfProposalsGoesWhenTheFocusIsMoved()
    {
        QWidget window;
        auto* layout = new QVBoxLayout(&window);
        auto* source = new SourceCombo;
        source->setChoices({{QStringLiteral("tam://mc/M/Axes[1]/Position"), {}}});
        auto* other = new QPushButton;
        layout->addWidget(source);
        layout->addWidget(other);
        QStringList chosen;
        connect(source, &SourceCombo::chosen, this, [&](const QString& text) {
            chosen += text;
            source->showValue(text);
        });
        QVERIFY(axiscomp::test::showActive(window));
        source->setFocus();
        QTest::keyClicks(source, QStringLiteral("Axes[1]"));
        const QWidget* proposals = source->completer()->popup();
        QTRY_VERIFY(proposals->isVisible());
        other->setFocus();
        QCOMPARE(chosen, QStringList(QStringLiteral("Axes[1]")));
        QVERIFY(!proposals->isVisible());
        QVERIFY(!source->isTyping());
        QVERIFY(other->hasFocus());
    }

    void whatIsRefusedBeforeAKeyUsesItStaysForCorrection()
    {
        QWidget window;
        auto* layout = new QVBoxLayout(&window);
        auto* source = new SourceCombo;
        layout->addWidget(source);
        auto* write = new QShortcut(Qt::CTRL | Qt::Key_Return, &window);
        new TypedFields(window); // which owns it
        source->showValue(QStringLiteral("old"));
        connect(source, &SourceCombo::chosen, source, &SourceCombo::refuse);
        bool isStillTyped = false;
        connect(write, &QShortcut::activated, this, [&] { isStillTyped = source->isTyping(); });
        QVERIFY(axiscomp::test::showActive(window));
        source->setFocus();
        source->lineEdit()->selectAll();
        QTest::keyClicks(source, QStringLiteral("none"));
        QTest::keyClick(source, Qt::Key_Return, Qt::ControlModifier);
        QTRY_VERIFY(isStillTyped);
        QCOMPARE(source->currentText(), QStringLiteral("none"));
        QTest::keyClick(source, Qt::Key_Escape);
        QCOMPARE(source->currentText(), QStringLiteral("old"));
        QVERIFY(!source->isTyping());
    }

    void aButtonThatTakesNoFocusUsesWhatIsTyped()
    {
        QWidget window;
        auto* layout = new QVBoxLayout(&window);
        auto* number = new NumberEdit(NumberEdit::Rule{});
        auto* use = new QToolButton;
        use->setFocusPolicy(Qt::TabFocus);
        layout->addWidget(number);
        layout->addWidget(use);
        new TypedFields(window); // which owns it
        std::vector<double> used;
        connect(use, &QToolButton::clicked, this, [&] { used = number->numbers(); });
        // Likewise one that there is a use for only when the number is taken.
        use->setEnabled(false);
        connect(number, &NumberEdit::chosen, use, [use] { use->setEnabled(true); });
        QVERIFY(axiscomp::test::showActive(window));
        number->setFocus();
        for (const auto& [key, numbers] : {std::pair('5', 5.0), std::pair('7', 57.0)}) {
            QTest::keyClick(number, key);
            QTest::mouseClick(window.windowHandle(), Qt::LeftButton, {}, use->geometry().center());
            QCOMPARE(used, std::vector{numbers});
            QVERIFY(number->hasFocus());
        }
    }

    void theEndOfTheWindowTakesWhatIsTyped()
    {
        QWidget window;
        auto* layout = new QVBoxLayout(&window);
        auto* page = new QWidget;
        auto* pageLayout = new QVBoxLayout(page);
        auto* number = new NumberEdit(NumberEdit::Rule{});
        pageLayout->addWidget(number);
        layout->addWidget(page);
        new TypedFields(*page); // which owns it
        QVERIFY(axiscomp::test::showActive(window));
        number->setFocus();
        QTest::keyClick(number, '5');
        QCloseEvent close;
        QCoreApplication::sendEvent(&window, &close);
        QCOMPARE(number->numbers(), std::vector{5.0});
    }
};

AXISCOMP_WINDOW_TEST(TestTypedFields)

} // namespace tst_typedfields

#include "tst_typedfields.moc"
