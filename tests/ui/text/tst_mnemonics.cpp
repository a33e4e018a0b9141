// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/page_inputs.h"
#include "tests/ui/support/page_states.h"
#include "tests/ui/support/window_test.h"
#include "ui/text/language.h"

#include <QAccessible>
#include <QKeySequence>
#include <QTabBar>
#include <QTest>

namespace tst_mnemonics {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::PageFixture;

namespace {

struct Mnemonic {
    QKeySequence key;
    QString owner;
};

QString described(const QWidget& widget, const QString& text)
{
    return QStringLiteral("%1 \"%2\"").arg(widget.objectName(), text);
}

/// Those that answer now: of what is visible and enabled.
std::vector<Mnemonic> mnemonicsOf(const QWidget& window)
{
    std::vector<Mnemonic> found;
    const auto add = [&](const QWidget& widget, const QString& text) {
        const QKeySequence key = QKeySequence::mnemonic(text);
        if (!key.isEmpty() && widget.isVisible() && widget.isEnabled())
            found.push_back({key, described(widget, text)});
    };
    for (const auto* button : window.findChildren<QAbstractButton*>())
        add(*button, button->text());
    for (const auto* label : window.findChildren<QLabel*>()) {
        if (label->buddy())
            add(*label, label->text());
    }
    for (const auto* tabs : window.findChildren<QTabBar*>()) {
        for (int i = 0; i < tabs->count(); ++i)
            add(*tabs, tabs->tabText(i));
    }
    return found;
}

QString accessibleText(QWidget& widget, QAccessible::Text kind)
{
    QAccessibleInterface* interface = QAccessible::queryAccessibleInterface(&widget);
    return interface ? interface->text(kind) : QString();
}

/// A label that leads to the input, or a text of its own, with a key.
bool hasMnemonic(const QWidget& window, const QWidget& input)
{
    if (const auto* button = qobject_cast<const QAbstractButton*>(&input))
        return !QKeySequence::mnemonic(button->text()).isEmpty();
    for (const auto* label : window.findChildren<QLabel*>()) {
        if (label->buddy() == &input && !QKeySequence::mnemonic(label->text()).isEmpty())
            return true;
    }
    return false;
}

/// Keys that two widgets answer to.
QStringList keysOfTwo(const QWidget& window)
{
    const auto found = mnemonicsOf(window);
    QStringList twice;
    for (std::size_t i = 0; i < found.size(); ++i) {
        for (std::size_t j = i + 1; j < found.size(); ++j) {
            if (found[i].key == found[j].key)
                twice += found[i].key.toString() + QStringLiteral(": ") + found[i].owner
                    + QStringLiteral(", ") + found[j].owner;
        }
    }
    return twice;
}

/// Inputs that lack a name, or a description or tool tip where one is due.
QStringList inputsThatSayNothing(QWidget& window)
{
    QStringList missing;
    for (QWidget* input : test::visibleInputs(window)) {
        const QString name = input->objectName();
        if (name.isEmpty())
            missing += QStringLiteral("%1: no object name")
                           .arg(QLatin1StringView(input->metaObject()->className()));
        if (accessibleText(*input, QAccessible::Name).isEmpty())
            missing += name + QStringLiteral(": no accessible name");
        if (!test::isField(*input) && !qobject_cast<QAbstractButton*>(input))
            continue;
        // A message's buttons stand beside its sentence.
        const bool isInMessage =
            input->parentWidget()->findChild<QLabel*>(QStringLiteral("messageText"));
        if (input->toolTip().isEmpty() && !isInMessage)
            missing += name + QStringLiteral(": no tooltip");
        if (accessibleText(*input, QAccessible::Description).isEmpty())
            missing += name + QStringLiteral(": no accessible description");
    }
    return missing;
}

QStringList inputsWithoutKey(QWidget& window)
{
    QStringList missing;
    for (const QWidget* input : test::visibleInputs(window)) {
        if (test::needsMnemonic(*input) && !hasMnemonic(window, *input))
            missing += input->objectName() + QStringLiteral(": no key");
    }
    return missing;
}

} // namespace

/// What every input says about itself, in every state of the page and every language. Reaching a
/// state takes far longer than looking at it, so that it is reached once and translated where it
/// stands.
class TestMnemonics : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void everyKeyLeadsToOneThingAndEveryInputSaysWhatItIs_data()
    {
        QTest::addColumn<int>("state");
        int number = 0;
        for (const auto& state : test::allPageStates())
            QTest::newRow(state.name) << number++;
    }
    void everyKeyLeadsToOneThingAndEveryInputSaysWhatItIs()
    {
        QFETCH(int, state);
        PageFixture bench(PageFixture::twoAxes());
        QVERIFY(test::allPageStates()[std::size_t(state)].reach(bench));
        QWidget& window = test::shownWindow(bench);
        QStringList wrong;
        for (const QString& language : Language::available()) {
            const Language spoken(language);
            QCoreApplication::sendPostedEvents(nullptr, QEvent::LanguageChange);
            QCoreApplication::processEvents();
            if (mnemonicsOf(window).size() <= 3)
                wrong += language + QStringLiteral(": the window has no more than three keys");
            for (const QString& problem :
                keysOfTwo(window) + inputsThatSayNothing(window) + inputsWithoutKey(window))
                wrong += language + QStringLiteral(": ") + problem;
        }
        bench.served.faults.clear();
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
    }
};

AXISCOMP_WINDOW_TEST(TestMnemonics)

} // namespace tst_mnemonics

#include "tst_mnemonics.moc"
