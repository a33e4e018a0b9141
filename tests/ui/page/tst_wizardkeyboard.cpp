// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/page_inputs.h"
#include "tests/ui/support/page_states.h"
#include "tests/ui/support/window_test.h"

#include <QAbstractItemView>
#include <QCompleter>
#include <QTest>

#include <set>

namespace tst_wizardkeyboard {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::PageFixture;
using test::PageUser;

namespace {

/// Where the Tab key leads, until it comes back to where it was.
QList<QWidget*> tabWalk(QWidget& window, Qt::Key key, Qt::KeyboardModifiers modifiers = {})
{
    QList<QWidget*> walk;
    constexpr int most = 200;
    for (int step = 0; step < most; ++step) {
        QTest::keyClick(window.windowHandle(), key, modifiers);
        QWidget* now = window.focusWidget();
        if (!now || walk.contains(now))
            return walk;
        walk += now;
    }
    return walk;
}

QStringList namesOf(const QList<QWidget*>& widgets)
{
    QStringList names;
    for (const QWidget* widget : widgets)
        names += widget->objectName();
    return names;
}

bool hasFocus(const PageFixture& bench, const char* name)
{
    const QWidget* focus = QApplication::focusWidget();
    const auto& widget = bench.user.the(name);
    return focus == &widget || widget.isAncestorOf(focus);
}

QString nameOfFocus()
{
    const QWidget* focus = QApplication::focusWidget();
    return focus ? focus->objectName() : QStringLiteral("nothing has the focus");
}

/// Another register than choose2D() takes, which the list of a source proposes.
const std::string planner = "Axes[0]/Signals/PathPlanner/Position";

const std::string& source(PageFixture& bench, std::size_t dimension)
{
    return bench.controller().setup().edited().sources.at(dimension - 1).path;
}

/// Types over what a source is, and leaves it there, below it the list of what is proposed.
[[nodiscard]] bool typeSource(PageFixture& bench, int dimension, const std::string& text)
{
    const QByteArray field = "source" + QByteArray::number(dimension) + "Field";
    bench.user.press(static_cast<Qt::Key>(Qt::Key_0 + dimension), Qt::AltModifier);
    bench.user.press(Qt::Key_A, Qt::ControlModifier);
    bench.user.type(QString::fromStdString(text));
    const auto& combo = bench.user.the<QComboBox>(field);
    return combo.currentText().toStdString() == text
        && PageUser::waitFor([&] { return combo.completer()->popup()->isVisible(); });
}

} // namespace

class TestWizardKeyboard : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void theTabKeyReachesEverythingThatCanBeUsed_data()
    {
        QTest::addColumn<int>("state");
        int number = 0;
        for (const auto& state : test::allPageStates())
            QTest::newRow(state.name) << number++;
    }
    void theTabKeyReachesEverythingThatCanBeUsed()
    {
        QFETCH(int, state);
        PageFixture bench;
        QVERIFY(test::allPageStates()[std::size_t(state)].reach(bench));
        QWidget& window = test::shownWindow(bench);
        const auto forth = tabWalk(window, Qt::Key_Tab);
        const auto back = tabWalk(window, Qt::Key_Backtab, Qt::ShiftModifier);
        bench.served.faults.clear();
        QStringList missed;
        for (const QWidget* input : test::visibleInputs(window)) {
            if (!input->isEnabled())
                continue;
            if (!forth.contains(input))
                missed += input->objectName() + QStringLiteral(" forth");
            if (!back.contains(input))
                missed += input->objectName() + QStringLiteral(" back");
        }
        QVERIFY2(missed.isEmpty(),
            qPrintable(QStringLiteral("%1; the walk: %2")
                           .arg(missed.join(QStringLiteral(", ")),
                               namesOf(forth).join(QStringLiteral(" ")))));
        QVERIFY(forth.size() < 150);
    }

    void theTabKeyGoesThroughThePageInReadingOrder()
    {
        PageFixture bench;
        QVERIFY(test::page_states::unwritten(bench));
        bench.user.the("driveField").setFocus();
        const QStringList walk =
            QStringList(QStringLiteral("driveField")) + namesOf(tabWalk(bench.window, Qt::Key_Tab));
        qsizetype before = -1;
        for (const char* name :
            {"driveField", "connectionsButton", "refreshButton", "axisField", "dimensionalityField",
                "dimensionalityFieldRevert", "source1Field", "source1FieldRevert", "source2Field",
                "openButton", "tableField", "persistencyField", "writeButton", "revertAllButton",
                "saveExampleButton", "logButton"}) {
            const qsizetype place = walk.indexOf(QLatin1StringView(name));
            QVERIFY2(place > before,
                qPrintable(
                    QStringLiteral("%1 in %2").arg(QLatin1StringView(name), walk.join(u' '))));
            before = place;
        }
    }

    void everythingFromTheChoiceToTheProofWithoutAMouse()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        user.press(Qt::Key_X, Qt::AltModifier);
        QVERIFY(hasFocus(bench, "axisField"));
        user.press(Qt::Key_S, Qt::AltModifier);
        QVERIFY(hasFocus(bench, "dimensionalityField"));
        user.press(Qt::Key_Down);
        QCOMPARE(bench.controller().setup().edited().dimensionality, 2);
        user.press(Qt::Key_1, Qt::AltModifier);
        QVERIFY(hasFocus(bench, "source1Field"));
        // A part of the path, then the entry of the list that opens.
        user.type(QStringLiteral("0]/Signals/PositionController/Master"));
        user.press(Qt::Key_Down);
        user.press(Qt::Key_Return);
        QTRY_COMPARE(bench.controller().setup().edited().sources[0].path, test::masterX);
        // The arrow keys alone.
        user.press(Qt::Key_2, Qt::AltModifier);
        QVERIFY(hasFocus(bench, "source2Field"));
        user.type(QString::fromStdString(test::masterY));
        user.press(Qt::Key_Tab);
        QTRY_COMPARE(bench.controller().setup().edited().sources[1].path, test::masterY);
        bench.picked = bench.superData();
        user.press(Qt::Key_O, Qt::AltModifier);
        QTRY_VERIFY(bench.controller().dataFile().data);
        user.press(Qt::Key_B, Qt::AltModifier);
        QVERIFY(hasFocus(bench, "tableField"));
        user.press(Qt::Key_Down);
        QCOMPARE(bench.controller().setup().edited().table.fileTable, std::optional(1));
        user.press(Qt::Key_P, Qt::AltModifier);
        QTRY_COMPARE(bench.controller().setup().edited().persistency, Persistency::Persistent);
        user.press(Qt::Key_W, Qt::AltModifier);
        QTRY_VERIFY(user.sees("confirmWriteButton"));
        user.press(Qt::Key_K, Qt::AltModifier);
        QTRY_VERIFY(!user.sees("confirmWriteButton"));
        user.press(Qt::Key_Return, Qt::ControlModifier);
        QTRY_VERIFY(user.sees("confirmWriteButton"));
        QVERIFY(hasFocus(bench, "confirmWriteButton"));
        user.press(Qt::Key_W, Qt::AltModifier);
        QVERIFY(bench.saysOutcome(QStringLiteral("the drive holds the new state")));
        user.press(Qt::Key_A, Qt::AltModifier);
        QVERIFY(bench.saysOutcome(QStringLiteral("Proved")));
        user.press(Qt::Key_E, Qt::AltModifier);
        QVERIFY(bench.saysOutcome(QStringLiteral("The compensation is off.")));
    }

    void aSourceThatIsBeingTypedIsTheOneThatIsWritten_data()
    {
        QTest::addColumn<Qt::Key>("key");
        QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
        QTest::newRow("key of the button") << Qt::Key_W << Qt::KeyboardModifiers(Qt::AltModifier);
        QTest::newRow("key of the page")
            << Qt::Key_Return << Qt::KeyboardModifiers(Qt::ControlModifier);
    }
    void aSourceThatIsBeingTypedIsTheOneThatIsWritten()
    {
        QFETCH(Qt::Key, key);
        QFETCH(Qt::KeyboardModifiers, modifiers);
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(test::page_states::unwritten(bench));
        QVERIFY(typeSource(bench, 1, planner));
        QCOMPARE(source(bench, 1), test::masterX);
        user.press(key, modifiers);
        QTRY_VERIFY(user.sees("confirmWriteButton"));
        QCOMPARE(source(bench, 1), planner);
        QCOMPARE(bench.controller().plan()->after.sources[0].path, planner);
        user.press(key, modifiers);
        QVERIFY(bench.saysOutcome(QStringLiteral("the drive holds the new state")));
        QCOMPARE(bench.controller().setup().baseline().sources[0].path, planner);
    }

    void aSourceThatIsBeingTypedKeepsTheOldOneFromBeingActivated()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(test::page_states::isWritten(bench));
        QVERIFY(typeSource(bench, 1, planner));
        user.press(Qt::Key_A, Qt::AltModifier);
        QTRY_COMPARE(source(bench, 1), planner);
        QTRY_VERIFY(!user.the("activateButton").isEnabled());
        QVERIFY(bench.idle());
        QVERIFY(!bench.controller().status()->isOn());
    }

    void theMenuTakesASourceThatIsBeingTyped()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(test::page_states::unwritten(bench));
        QVERIFY(typeSource(bench, 1, planner));
        QVERIFY(user.click("menuButton")); // closes the list
        QTRY_VERIFY(!user.the<QComboBox>("source1Field").completer()->popup()->isVisible());
        QVERIFY(user.pickFromMenu("menuButton", "pageMenu", Qt::Key_Escape));
        QCOMPARE(source(bench, 1), planner);
        QTRY_VERIFY2(hasFocus(bench, "source1Field"), qPrintable(nameOfFocus()));
    }

    void aSourceThatIsRefusedStaysForCorrectionAndNothingIsWritten()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(test::page_states::unwritten(bench));
        QVERIFY(typeSource(bench, 2, test::masterX)); // that of dimension 1
        user.press(Qt::Key_Return, Qt::ControlModifier);
        QTRY_VERIFY(
            user.note("source2Field").contains(QStringLiteral("dimension 1 and dimension 2")));
        QVERIFY(!bench.controller().busy().isBusy);
        QVERIFY(!user.sees("confirmWriteButton"));
        auto& combo = user.the<QComboBox>("source2Field");
        QCOMPARE(combo.currentText().toStdString(), test::masterX);
        user.press(Qt::Key_Escape);
        user.press(Qt::Key_Return, Qt::ControlModifier);
        QTRY_VERIFY(user.sees("confirmWriteButton"));
        QCOMPARE(bench.controller().plan()->after.sources[1].path, test::masterY);
    }

    void theSourceListIsChosenFromByArrowKeys()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        user.press(Qt::Key_1, Qt::AltModifier);
        user.press(Qt::Key_Down, Qt::AltModifier);
        auto& box = user.the<QComboBox>("source1Field");
        QTRY_VERIFY(box.view()->isVisible());
        user.press(Qt::Key_Down);
        user.press(Qt::Key_Return);
        QTRY_VERIFY(!box.view()->isVisible());
        QTRY_VERIFY(bench.controller().setup().edited().sources[0].isSet());
        QCOMPARE(box.currentText().isEmpty(), false);
    }

    void escapeAndTheShortcutsDoWhatTheyPromise()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(test::page_states::unwritten(bench));
        user.press(Qt::Key_L, Qt::ControlModifier);
        QVERIFY(user.sees("logView"));
        user.press(Qt::Key_L, Qt::AltModifier);
        QTRY_VERIFY(!user.sees("logView"));
        user.press(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(!bench.controller().setup().isDirty());
        const auto questions = bench.questions.size();
        user.press(Qt::Key_O, Qt::ControlModifier);
        QCOMPARE(bench.questions.size(), questions + 1);
        QTRY_VERIFY(!bench.controller().dataFile().isReading);
        user.press(Qt::Key_F5);
        QTRY_COMPARE(user.the<QLabel>("driveState").text(), QStringLiteral("connected"));
        QVERIFY(bench.user.message("connectionMessage").isEmpty());
    }

    void escapeStopsAWrite()
    {
        PageFixture bench;
        QVERIFY(test::page_states::writing(bench));
        bench.user.press(Qt::Key_Escape);
        bench.served.faults.clear();
        QVERIFY(bench.saysOutcome(QStringLiteral("The write was stopped.")));
    }

    void theFocusIsNeverLostWhenAButtonGoes()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(test::page_states::unwritten(bench));
        // The button that is pressed is disabled or hidden by what it does.
        for (const char* name : {"source2FieldRevert", "revertAllButton"}) {
            user.the(name).setFocus(Qt::TabFocusReason);
            QVERIFY(user.click(name));
            QVERIFY2(!user.the(name).isVisible() || !user.the(name).isEnabled(), name);
            QWidget* focus = QApplication::focusWidget();
            QVERIFY2(focus && focus->isVisible() && focus->isEnabled(), name);
            QVERIFY2(focus != &bench.window, name);
        }
        const QWidget* before = QApplication::focusWidget();
        user.press(Qt::Key_Tab);
        QVERIFY(QApplication::focusWidget() != before);
    }

    void theFocusIsNeverLostWhenAMessageGoes()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(test::page_states::leaveQuestion(bench));
        user.press(Qt::Key_Y, Qt::AltModifier);
        QTRY_VERIFY(!user.sees("leaveQuestion"));
        const QWidget* focus = QApplication::focusWidget();
        QVERIFY(focus && focus->isVisible());
    }
};

AXISCOMP_WINDOW_TEST(TestWizardKeyboard)

} // namespace tst_wizardkeyboard

#include "tst_wizardkeyboard.moc"
