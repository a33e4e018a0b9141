// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/page_states.h"
#include "tests/ui/support/window_test.h"

#include <QTest>

namespace tst_wizardclosing {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::PageFixture;

/// Nothing is lost without a question, and a drive is left in the old or the new state.
class TestWizardClosing : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void withoutChangesTheWindowClosesAtOnce()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        QVERIFY(bench.window.close());
        QVERIFY(!bench.window.isVisible());
    }

    void unwrittenChangesAreAskedAbout()
    {
        PageFixture bench;
        QVERIFY(test::page_states::closeQuestion(bench));
        QVERIFY(bench.user.message("leaveQuestion").contains(QStringLiteral("X · Stage-7")));
        QVERIFY(bench.window.isVisible());
        QVERIFY(bench.user.click("stayButton"));
        QVERIFY(bench.window.isVisible());
        QVERIFY(bench.controller().setup().isDirty());
        const auto before = bench.state();
        QVERIFY(!bench.window.close());
        QVERIFY(bench.user.click("loseChangesButton"));
        QTRY_VERIFY(!bench.window.isVisible());
        QVERIFY(bench.state() == before);
    }

    void theQuestionGoesWhenTheChangesHaveGone()
    {
        PageFixture bench;
        QVERIFY(test::page_states::closeQuestion(bench));
        QVERIFY(bench.user.click("revertAllButton"));
        QTRY_VERIFY(!bench.user.sees("leaveQuestion"));
        QVERIFY(bench.window.close());
    }

    void stoppedWhileWritingTheDriveKeepsItsOldState()
    {
        PageFixture bench;
        const auto before = bench.state();
        QVERIFY(test::page_states::closingWhileWriting(bench));
        QVERIFY(
            bench.user.message("leaveQuestion").contains(QStringLiteral("write is in progress")));
        QVERIFY(bench.window.isVisible());
        QVERIFY(bench.user.click("stopAndCloseButton"));
        bench.served.faults.clear();
        QTRY_VERIFY(!bench.window.isVisible());
        QVERIFY(bench.state() == before);
    }

    void closedWhenDoneTheDriveHasTheNewState()
    {
        PageFixture bench;
        const auto before = bench.state();
        QVERIFY(test::page_states::closingWhileWriting(bench));
        QVERIFY(bench.user.click("closeWhenDoneButton"));
        QVERIFY(bench.window.isVisible());
        bench.served.faults.clear();
        QTRY_VERIFY(!bench.window.isVisible());
        QVERIFY(!(bench.state() == before));
        QVERIFY(!bench.state().table.empty());
        QVERIFY(!bench.controller().setup().isDirty());
    }

    void whoStaysSeesTheWriteEnd()
    {
        PageFixture bench;
        QVERIFY(test::page_states::closingWhileWriting(bench));
        QVERIFY(bench.user.click("stayButton"));
        bench.served.faults.clear();
        QVERIFY(bench.saysOutcome(QStringLiteral("the drive holds the new state")));
        QVERIFY(bench.window.isVisible());
        QVERIFY(bench.window.close());
    }

    void aWriteThatFailedBeforeTheWindowClosesIsRead()
    {
        PageFixture bench;
        QVERIFY(test::page_states::preview(bench));
        // The drive takes nothing and says so late.
        bench.served.faults.add({drivecomm::FaultSpec::Kind::Slow, 250, {}});
        bench.served.faults.add({drivecomm::FaultSpec::Kind::Reject, 0, "TableRefused"});
        QVERIFY(bench.user.click("confirmWriteButton"));
        QTRY_VERIFY(bench.controller().isWriting());
        QVERIFY(!bench.window.close());
        QVERIFY(bench.user.click("closeWhenDoneButton"));
        QVERIFY2(bench.saysOutcome(QStringLiteral("The drive holds the complete old state")),
            qPrintable(bench.outcome()));
        QVERIFY(bench.window.isVisible());
        bench.served.faults.clear();
    }

    void askedToEndFromOutsideItClosesWithoutQuestions()
    {
        // What becomes of the drive is tst_wizardend's.
        PageFixture bench;
        QVERIFY(test::page_states::writing(bench));
        bench.wizard.closeNow();
        QTRY_VERIFY(!bench.window.isVisible());
        bench.served.faults.clear();
    }
};

AXISCOMP_WINDOW_TEST(TestWizardClosing)

} // namespace tst_wizardclosing

#include "tst_wizardclosing.moc"
