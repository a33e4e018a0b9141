// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/changed_backup.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"
#include "tests/ui/support/unfinished_write.h"
#include "tests/ui/support/write_outcomes.h"

#include <QTest>

namespace tst_wizardrestore {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::ControllerFixture;
using test::DriveGate;
using test::written;

namespace {

/// The CRCs of the tables of which the controller says that an axis has them now, as long as it is
/// there.
class WrittenTables {
public:
    explicit WrittenTables(WizardController& controller)
    {
        QObject::connect(&controller, &WizardController::tableWritten, &m_context,
            [this](const AxisStatus& now) { crcs.push_back(now.setup.tableCrc); });
    }

    std::vector<std::uint32_t> crcs;

private:
    QObject m_context;
};

} // namespace

class TestWizardRestore : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void restorePreviousGoesBackAndForth()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(!bench->action(Action::RestorePrevious).isEnabled);
        QVERIFY(bench.prepare2D(1));
        QVERIFY(bench.planAndWrite());
        const std::uint32_t first = bench->setup().baseline().tableCrc;
        QVERIFY(bench.prepare2D(2));
        QVERIFY(bench.planAndWrite());
        const std::uint32_t second = bench->setup().baseline().tableCrc;
        QVERIFY(first != second);
        QVERIFY(bench->action(Action::RestorePrevious).isEnabled);
        bench->setup().setPersistency(Persistency::Persistent);
        WrittenTables restored(bench.controller());
        QVERIFY(bench.restorePrevious());
        QVERIFY2(
            bench->outcome().startsWith(QStringLiteral("Restored")), qPrintable(bench->outcome()));
        QCOMPARE(bench->setup().baseline().tableCrc, first);
        QVERIFY(!bench->setup().isDirty());
        QVERIFY(bench.restorePrevious());
        QCOMPARE(bench->setup().baseline().tableCrc, second);
        QVERIFY((restored.crcs == std::vector{first, second}));
    }

    void restorePreviousPassesOverTheBackupOfAWriteThatFailed()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D(1));
        QVERIFY(bench.planAndWrite());
        const std::uint32_t first = bench->setup().baseline().tableCrc;
        QVERIFY(bench.prepare2D(2));
        QVERIFY(bench.planAndWrite());
        QVERIFY(bench.prepare2D(3));
        bench->planWrite();
        QVERIFY(bench.idle());
        const std::size_t backups = bench.store().backups(4711, 0).size();
        bench.drive().gate.setAt(16, DriveGate::Mode::Silent);
        bench->write();
        QTRY_COMPARE(bench.drive().gate.waiting(), 1);
        bench->cancel();
        bench.drive().gate.set(DriveGate::Mode::Open);
        QVERIFY(bench.idle());
        QCOMPARE(bench.store().backups(4711, 0).size(), backups + 1);
        QVERIFY(bench.restorePrevious());
        QVERIFY2(
            bench->outcome().startsWith(QStringLiteral("Restored")), qPrintable(bench->outcome()));
        QCOMPARE(bench->setup().baseline().tableCrc, first);
    }

    void theBackupThatWasSeenComesBackWhateverHasBecomeOfItsFile()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D(1));
        QVERIFY(bench.planAndWrite());
        const std::uint32_t first = bench->setup().baseline().tableCrc;
        QVERIFY(bench.prepare2D(2));
        QVERIFY(bench.planAndWrite());
        QVERIFY(bench.planRestoration());
        // Another program's write: its backup is the newest, and pushes others out.
        for (const std::filesystem::path& file : bench.store().backups(4711, 0))
            QVERIFY(std::filesystem::remove(file));
        bench->write();
        QVERIFY(bench.idle());
        QVERIFY2(
            bench->outcome().startsWith(QStringLiteral("Restored")), qPrintable(bench->outcome()));
        QCOMPARE(bench->setup().baseline().tableCrc, first);
    }

    void aRestorationStopsWhenTheAxisIsNotAsThePreviewHadIt()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D(1));
        QVERIFY(bench.planAndWrite());
        QVERIFY(bench.prepare2D(2));
        QVERIFY(bench.planAndWrite());
        const std::uint32_t second = bench->setup().baseline().tableCrc;
        QVERIFY(bench.planRestoration());
        bench.drive().set("Axes[0]/Parameters/Compensations/Axis/Dim1Source", std::uint32_t{0});
        bench->write();
        QVERIFY(bench.idle());
        QVERIFY2(bench->isOutcomeAnError(), qPrintable(bench->outcome()));
        QVERIFY2(bench->outcome().endsWith(QStringLiteral("Nothing was written.")),
            qPrintable(bench->outcome()));
        QCOMPARE(bench->setup().baseline().tableCrc, second);
        QVERIFY(!bench->setup().baseline().sources[0].isSet());
    }

    void theTableIsDeletedAsPlannedAndCanBeRestored()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(!bench->action(Action::DeleteTable).isEnabled);
        QVERIFY(bench.prepare2D(1));
        bench->setup().setPersistency(Persistency::Persistent);
        QVERIFY(bench.planAndWrite());
        const std::uint32_t first = bench->setup().baseline().tableCrc;
        QVERIFY(bench->action(Action::DeleteTable).isEnabled);
        bench->planDeletion();
        QVERIFY(bench.idle());
        QVERIFY(bench->plan().has_value());
        QCOMPARE(bench->plan()->deletedSlot, std::string("Small1"));
        QCOMPARE(bench->plan()->flashOperations, 1);
        QCOMPARE(bench->setup().baseline().tableCrc, first);
        bench->write();
        QVERIFY(bench.idle());
        QVERIFY2(bench->outcome().startsWith(QStringLiteral("Deleted and verified: Small1")),
            qPrintable(bench->outcome()));
        QVERIFY(bench->setup().baseline().slot.empty());
        QVERIFY(!bench->setup().isDirty());
        QVERIFY(!bench->action(Action::DeleteTable).isEnabled);
        QVERIFY(bench.restorePrevious());
        QCOMPARE(bench->setup().baseline().tableCrc, first);
    }

    void anEarlierWriteThatDidNotEndIsSaidAndCanBeFinished()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        bench->setup().setPersistency(Persistency::Persistent);
        QVERIFY(bench.planAndWrite());
        QVERIFY2(bench->outcome().startsWith(written), qPrintable(bench->outcome()));
        VERIFY_RESULT(test::reopenWrite(bench));
        bench.endController();

        QVERIFY(bench.connect());
        QVERIFY(bench->isOutcomeAnError());
        QCOMPARE(bench->unfinishedWrite(), bench->outcome());
        QVERIFY2(bench->outcome().contains(QStringLiteral("its parameters may not be saved")),
            qPrintable(bench->outcome()));
        QVERIFY(!bench->setup().isDirty());
        QVERIFY(bench->action(Action::Write).isEnabled);
        QCOMPARE(bench->action(Action::Write).reason,
            QStringLiteral("Finishes an earlier write: saves the parameters of the drive."));
        QVERIFY(bench.planAndWrite());
        QVERIFY2(bench->outcome().startsWith(written), qPrintable(bench->outcome()));
        QCOMPARE(bench->action(Action::Write).reason, QStringLiteral("Nothing has changed."));
        QVERIFY(!isUnfinished(bench));
    }

    /// Each live value says that there is one, and comes sooner than a full reading ends.
    void anUnfinishedWriteIsSaidOfASlowDriveToo()
    {
        ControllerFixture bench;
        bench.options.liveInterval = std::chrono::milliseconds(1);
        bench.options.reconnectInterval = std::chrono::milliseconds(5);
        bench.options.linkFactory = [&bench, link = bench.options.linkFactory](
                                        const std::string& endpoint) {
            auto slow = link(endpoint);
            bench.drive().faults.load()->beginning = [](std::string_view) { QThread::msleep(2); };
            return slow;
        };
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        bench->setup().setPersistency(Persistency::Persistent);
        QVERIFY(bench.planAndWrite());
        VERIFY_RESULT(test::reopenWrite(bench));
        QVERIFY(
            QTest::qWaitFor([&] { return !bench->unfinishedWrite().isEmpty(); }, test::patienceMs));
    }

    void anUnfinishedWriteIsFinishedOrUndone_data()
    {
        QTest::addColumn<bool>("finishes");
        QTest::newRow("finish") << true;
        QTest::newRow("undo") << false;
    }
    void anUnfinishedWriteIsFinishedOrUndone()
    {
        QFETCH(bool, finishes);
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QCOMPARE(bench->action(Action::FinishWrite).reason,
            QStringLiteral("This axis has no unfinished write."));
        QVERIFY(bench.prepare2D());
        bench->setup().setPersistency(Persistency::Persistent);
        QVERIFY(bench.planAndWrite());
        VERIFY_RESULT(test::reopenWrite(bench));
        bench.endController();

        QVERIFY(bench.connect());
        QVERIFY(!bench->unfinishedWrite().isEmpty());
        QVERIFY(bench->action(Action::FinishWrite).isEnabled);
        QVERIFY(bench->action(Action::UndoWrite).isEnabled);
        bench->setup().setDimensionality(2);
        bench->openData(bench.path(QStringLiteral("2d-1.csv")));
        QVERIFY(bench.fileRead());
        WrittenTables now(bench.controller());
        if (finishes)
            bench->finishWrite();
        else
            bench->undoWrite();
        QVERIFY(bench.idle());
        QVERIFY2(bench->outcome().startsWith(finishes ? QStringLiteral("Finished and verified")
                                                      : QStringLiteral("Undone and verified")),
            qPrintable(bench->outcome()));
        QVERIFY(bench->unfinishedWrite().isEmpty());
        QVERIFY(!bench->action(Action::UndoWrite).isEnabled);
        QVERIFY(!isUnfinished(bench));
        QCOMPARE(bench->setup().baseline().slot.empty(), !finishes);
        QCOMPARE(now.crcs.size(), std::size_t{finishes ? 1U : 0U});
        // The file's table is what the drive has now: nothing is left to write.
        if (finishes) {
            QCOMPARE(bench->setup().edited().table.fileTable, std::optional<int>(0));
            QVERIFY(!bench->setup().isDirty());
            QVERIFY(bench->action(Action::Activate).isEnabled);
        }
    }

    void whatIsDoubtfulAboutAnUnfinishedWriteIsSaidWithIt()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        bench->setup().setPersistency(Persistency::Persistent);
        QVERIFY(bench.planAndWrite());
        VERIFY_RESULT(test::reopenWrite(bench));
        bench.endController();
        test::nameInBackup(bench.store().backups(4711, 0).front(), "Gantry");

        QVERIFY(bench.connect());
        QVERIFY(bench->action(Action::FinishWrite).isEnabled);
        QVERIFY(bench->action(Action::UndoWrite).isEnabled);
        QVERIFY2(bench->unfinishedWrite().contains(
                     QStringLiteral("Axis 0 was called Gantry when the backup was made, and is "
                                    "called X now: see that it is the same axis.")),
            qPrintable(bench->unfinishedWrite()));
    }

    void anUnfinishedWriteWaitsWhileTheCompensationIsActive()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        bench->setup().setPersistency(Persistency::Persistent);
        QVERIFY(bench.planAndWrite());
        bench->activate();
        QVERIFY(bench.idle());
        VERIFY_RESULT(test::reopenWrite(bench));
        bench.endController();

        QVERIFY(bench.connect());
        QVERIFY(!bench->unfinishedWrite().isEmpty());
        for (const Action action : {Action::FinishWrite, Action::UndoWrite}) {
            QVERIFY(!bench->action(action).isEnabled);
            QCOMPARE(bench->action(action).reason,
                QStringLiteral("The compensation is active: deactivate it first."));
        }
        bench->finishWrite();
        QVERIFY(!bench->busy().isBusy);
        bench->deactivate();
        QVERIFY(bench.idle());
        QVERIFY(bench->action(Action::FinishWrite).isEnabled);
    }

private:
    static bool isUnfinished(ControllerFixture& bench)
    {
        const auto journal = bench.store().journal(4711, 0);
        return !journal || journal->has_value();
    }
};

AXISCOMP_TEST(TestWizardRestore)

} // namespace tst_wizardrestore

#include "tst_wizardrestore.moc"
