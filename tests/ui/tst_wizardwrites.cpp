// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/verify.h"
#include "tests/ui/controller_bench.h"

#include <QSignalSpy>
#include <QTest>

using namespace axiscomp;
using namespace axiscomp::ui;
using test::ControllerBench;
using test::DriveGate;
using test::LinkFault;

namespace {

const QString written =
    QStringLiteral("Written, read back and compared: the drive holds the new state.");
const QString oldState = QStringLiteral("The drive holds the complete old state.");
const std::string tableX = "Axes[0]/Parameters/Compensations/Axis/Table";

bool starts(const QString& text, const QString& beginning)
{
    return text.startsWith(beginning);
}

} // namespace

class TestWizardWrites : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void fromAFileToAnActiveCompensation()
    {
        ControllerBench bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        QCOMPARE(bench->hint(), QStringLiteral("Parameters must be written."));
        QVERIFY(!bench->action(Action::Activate).isEnabled);
        QCOMPARE(bench->selectedTableBytes(), std::size_t{128 + 36 * 4});

        QSignalSpy ready(&bench.controller(), &WizardController::planReady);
        bench->planWrite();
        QVERIFY(bench->busy().isBusy);
        QVERIFY(!bench->isWriting());
        QTRY_COMPARE(ready.count(), 1);
        QVERIFY(bench->plan().has_value());
        QCOMPARE(bench->plan()->tableBytes, bench->selectedTableBytes());
        QVERIFY(!bench->plan()->changes.empty());
        QCOMPARE(bench.drive().text(tableX), "Disabled");

        bench->write();
        QVERIFY(bench->isWriting());
        QVERIFY(!bench->action(Action::Write).isEnabled);
        QVERIFY(bench.idle());
        QVERIFY2(starts(bench->outcome(), written), qPrintable(bench->outcome()));
        QVERIFY(!bench->isOutcomeAnError());
        QVERIFY(!bench->setup().isChanged());
        QVERIFY(!bench->setup().edited().table.fileTable); // it is the drive's now
        QCOMPARE(bench->setup().baseline().dimensionality, 2);
        QCOMPARE(bench.drive().text(tableX), bench->setup().baseline().slot);

        bench->activate();
        QVERIFY(bench.idle());
        QCOMPARE(bench->status()->axis.state, "Active");
        QVERIFY(bench->proof().has_value());
        QCOMPARE(bench->proof()->samples.size(), std::size_t{5});
        QVERIFY2(bench->outcome().startsWith(
                     QStringLiteral("The compensation is active. Proved: largest difference ")),
            qPrintable(bench->outcome()));
        QVERIFY(bench->outcome().endsWith(QStringLiteral(" in 5 samples.")));
        QCOMPARE(bench->action(Action::Activate).reason,
            QStringLiteral("The compensation is active already."));

        bench->deactivate();
        QVERIFY(bench.idle());
        QCOMPARE(bench->status()->axis.state, "Disabled");
        QCOMPARE(bench->outcome(), QStringLiteral("The compensation is off."));
    }

    void theTableOnTheDriveIsTheFilesOneWithItsNamesAndComesBackOnceOnly()
    {
        ControllerBench bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        const auto table = bench->selectedTable();
        QSignalSpy selected(&bench.controller(), &WizardController::selectedTableChanged);
        QVERIFY(bench.planAndWrite());
        QCOMPARE(bench->selectedTable(), table); // not an empty picture in between
        QVERIFY(bench.readLive());
        QCOMPARE(bench->driveTable(), table);
        QCOMPARE(bench->driveTable()->grid.axes.at(0).name, "X");
        QCOMPARE(selected.count(), 0);
        const int exchanges = bench.drive().gate.exchanges();
        QVERIFY(bench.readLive());
        QVERIFY(bench.readLive());
        // identify and two readings each: no more downloads
        QCOMPARE(bench.drive().gate.exchanges(), exchanges + 6);
    }

    void evaluatingProvesTheIndicesAndAddsNothing()
    {
        ControllerBench bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        QVERIFY(bench.planAndWrite());
        bench->evaluate();
        QVERIFY(bench.idle());
        QCOMPARE(bench->status()->axis.state, "Evaluating");
        QVERIFY(bench->outcome().startsWith(
            QStringLiteral("The compensation is being evaluated: the drive adds nothing. Proved")));
        QVERIFY(bench->action(Action::Deactivate).isEnabled);
        QVERIFY(bench->action(Action::Activate).isEnabled);
    }

    void whatTheUserChangesWhileAWriteIsPlannedStopsIt()
    {
        ControllerBench bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        QSignalSpy ready(&bench.controller(), &WizardController::planReady);
        bench->planWrite();
        bench->setup().setPersistency(Persistency::Persistent);
        QVERIFY(bench.idle());
        QCOMPARE(ready.count(), 0);
        QVERIFY(bench->isOutcomeAnError());
        QVERIFY(!bench->plan().has_value());
    }

    void aPlanDiesWithTheFirstChangeAfterIt()
    {
        ControllerBench bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        bench->planWrite();
        QVERIFY(bench.idle());
        QVERIFY(bench->plan().has_value());
        bench->setup().setTable({1});
        QVERIFY(!bench->plan().has_value());
        bench->write();
        QVERIFY(!bench->busy().isBusy);
        QVERIFY(bench->outcome().contains(QStringLiteral("since the write was planned")));
        QCOMPARE(bench.drive().text(tableX), "Disabled");
    }

    void whatSomebodyElseChangesBetweenPlanAndWriteIsNotOverwritten()
    {
        ControllerBench bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        bench->planWrite();
        QVERIFY(bench.idle());
        const auto y = bench.drive().drive.readRegisters({test::masterY});
        bench.drive().set("Axes[0]/Parameters/Compensations/Axis/Dim1Source", y->front().address);
        bench->write();
        QVERIFY(bench.idle());
        QVERIFY(bench->isOutcomeAnError());
        QVERIFY2(starts(bench->outcome(), QStringLiteral("Somebody else changed")),
            qPrintable(bench->outcome()));
        QCOMPARE(bench.drive().text(tableX), "Disabled");
        // What the drive has is shown; the user's choice stays.
        QCOMPARE(bench->setup().baseline().sources[0].path, test::masterY);
        QCOMPARE(bench->setup().edited().sources[0].path, test::masterX);
        QVERIFY(bench->setup().edited().table.fileTable.has_value());
    }

    void aWriteThatIsCancelledLeavesTheOldState()
    {
        ControllerBench bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        bench->planWrite();
        QVERIFY(bench.idle());
        bench.drive().gate.setAt(9, DriveGate::Mode::Silent);
        bench->write();
        QTRY_COMPARE(bench.drive().gate.waiting(), 1);
        QVERIFY(bench->action(Action::Cancel).isEnabled);
        QCOMPARE(bench->action(Action::Cancel).reason,
            QStringLiteral("Stops the write and puts the old state back."));
        bench->cancel();
        QVERIFY(!bench->action(Action::Cancel).isEnabled);
        bench.drive().gate.set(DriveGate::Mode::Open);
        QVERIFY(bench.idle());
        QCOMPARE(bench->outcome(), QStringLiteral("The write was stopped. ") + oldState);
        QCOMPARE(bench.drive().text(tableX), "Disabled");
        QVERIFY(bench->setup().isChanged(Field::Table));
        QVERIFY(bench->action(Action::Write).isEnabled);
        QVERIFY(bench.planAndWrite());
        QVERIFY(starts(bench->outcome(), written));
    }

    /// Whatever goes wrong at whichever exchange: afterwards the window shows what the drive holds,
    /// and says which of the two states that is.
    void afterAnyFaultTheWindowShowsWhatTheDriveHolds_data()
    {
        QTest::addColumn<int>("fault");
        QTest::addColumn<int>("exchange");
        const std::vector<std::pair<const char*, LinkFault>> faults{
            {"request lost", LinkFault::RequestLost}, {"reply lost", LinkFault::ReplyLost},
            {"refused", LinkFault::Refused}, {"stores wrong", LinkFault::StoresWrong},
            {"reboot", LinkFault::Reboot}};
        for (const auto& [name, fault] : faults) {
            for (int exchange = 1; exchange <= 25; exchange += 2)
                QTest::addRow("%s at exchange %d", name, exchange)
                    << static_cast<int>(fault) << exchange;
        }
    }
    void afterAnyFaultTheWindowShowsWhatTheDriveHolds()
    {
        QFETCH(int, fault);
        QFETCH(int, exchange);
        ControllerBench bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        QVERIFY(bench.planAndWrite());
        const CompensationSetup before = bench->setup().baseline();
        bench->openData(bench.file(QStringLiteral("new.csv"), ControllerBench::calibration2D(7)));
        QVERIFY(bench.fileRead());
        bench->planWrite();
        QVERIFY(bench.idle());
        QVERIFY(bench->plan().has_value());
        const CompensationSetup after = bench->plan()->after;

        bench.drive().faults.load()->failAt(exchange, static_cast<LinkFault>(fault));
        bench->write();
        QVERIFY(bench.idle());
        QTRY_COMPARE(bench->drives().front().connection, DriveState::Connection::Connected);
        QVERIFY(bench.readLive());
        const CompensationSetup& now = bench->setup().baseline();
        QCOMPARE(QString::fromStdString(bench.drive().text(tableX)),
            QString::fromStdString(now.slot.empty() ? "Disabled" : now.slot));
        QVERIFY(!bench->outcome().isEmpty());
        if (starts(bench->outcome(), written)) {
            QVERIFY(now == after || fault == static_cast<int>(LinkFault::Reboot));
            return;
        }
        // A table that is not persistent is gone after a reboot, whatever the program does.
        if (bench->outcome().endsWith(oldState) && fault != static_cast<int>(LinkFault::Reboot)) {
            QVERIFY(now == before);
            QVERIFY(bench->setup().isChanged(Field::Table));
        }
    }

    void aDriveThatIsGoneInTheMiddleIsSettledWhenItIsBack()
    {
        ControllerBench bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        bench->planWrite();
        QVERIFY(bench.idle());
        // Far enough that the journal is open, and for so long that nothing can be put back.
        bench.drive().gate.setAt(16, DriveGate::Mode::Gone);
        bench->write();
        QVERIFY(bench.idle());
        QVERIFY(bench->isOutcomeAnError());
        QCOMPARE(bench->drives().front().connection, DriveState::Connection::Lost);
        QVERIFY(bench->setup().isChanged(Field::Table)); // never what was sent
        bench.drive().gate.set(DriveGate::Mode::Open);
        QTRY_COMPARE(bench->drives().front().connection, DriveState::Connection::Connected);
        QVERIFY(bench.readLive());
        QCOMPARE(bench.drive().text(tableX) == "Disabled", bench->setup().baseline().slot.empty());
        DriveStore store = bench.store();
        const auto journal = store.journal(4711, 0);
        VERIFY_RESULT(journal);
        QVERIFY(!journal->has_value());
    }

    void anEarlierWriteThatDidNotEndIsSaidAndCanBeFinished()
    {
        ControllerBench bench;
        {
            QVERIFY(bench.connect());
            QVERIFY(bench.prepare2D());
            bench->setup().setPersistency(Persistency::Persistent);
            QVERIFY(bench.planAndWrite());
            QVERIFY2(starts(bench->outcome(), written), qPrintable(bench->outcome()));
        }
        // As if the program had been killed before the last step of that write.
        const CompensationSetup setup = bench->setup().baseline();
        DriveStore store = bench.store();
        JournalEntry entry;
        entry.serialNumber = 4711;
        entry.time = std::chrono::system_clock::now();
        entry.step = "save";
        entry.backup = store.backups(4711, 0).front();
        entry.newRegisters = {{tableX, setup.slot},
            {"Axes[0]/Parameters/Compensations/Axis/Dim1Source", setup.sources[0].address},
            {"Axes[0]/Parameters/Compensations/Axis/Dim2Source", setup.sources[1].address},
            {"Axes[0]/Parameters/Compensations/Axis/Dim3Source", std::uint32_t{0}}};
        entry.newSlot = setup.slot;
        entry.newCrc = setup.tableCrc;
        entry.persistent = true;
        VERIFY_RESULT(store.openJournal(entry));
        bench.endController();

        QVERIFY(bench.connect());
        QVERIFY(bench->isOutcomeAnError());
        QVERIFY2(bench->outcome().contains(QStringLiteral("its parameters may not be saved")),
            qPrintable(bench->outcome()));
        QVERIFY(!bench->setup().isChanged());
        QVERIFY(bench->action(Action::Write).isEnabled);
        QCOMPARE(bench->action(Action::Write).reason,
            QStringLiteral("Finishes an earlier write: saves the parameters of the drive."));
        QVERIFY(bench.planAndWrite());
        QVERIFY2(starts(bench->outcome(), written), qPrintable(bench->outcome()));
        QCOMPARE(bench->action(Action::Write).reason, QStringLiteral("Nothing has changed."));
        VERIFY_RESULT(store.journal(4711, 0));
        QVERIFY(!store.journal(4711, 0)->has_value());
    }

    void restorePreviousGoesBackAndForth()
    {
        ControllerBench bench;
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
        bench->restorePrevious();
        QVERIFY(bench.idle());
        QVERIFY2(
            starts(bench->outcome(), QStringLiteral("Restored")), qPrintable(bench->outcome()));
        QCOMPARE(bench->setup().baseline().tableCrc, first);
        QVERIFY(!bench->setup().isChanged());
        bench->restorePrevious();
        QVERIFY(bench.idle());
        QCOMPARE(bench->setup().baseline().tableCrc, second);
    }

    void restorePreviousPassesOverTheBackupOfAWriteThatFailed()
    {
        ControllerBench bench;
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
        bench->restorePrevious();
        QVERIFY(bench.idle());
        QVERIFY2(
            starts(bench->outcome(), QStringLiteral("Restored")), qPrintable(bench->outcome()));
        QCOMPARE(bench->setup().baseline().tableCrc, first);
    }

    void flashWearIsKnownBeforehand()
    {
        ControllerBench bench;
        QVERIFY(bench.connect());
        DriveStore store = bench.store();
        VERIFY_RESULT(store.recordFlash(4711, std::chrono::system_clock::now(), 7));
        QVERIFY(bench.prepare2D());
        bench->setup().setPersistency(Persistency::Persistent);
        QVERIFY(bench.planAndWrite());
        QCOMPARE(bench->flashOperationsLeft(), 0);
        QVERIFY(bench->flashWaitSeconds() > 590);
        QVERIFY(bench.prepare2D(2) == false); // persistent as the table before
        QVERIFY2(
            bench->action(Action::Write).reason.startsWith(QStringLiteral("Flash wear: wait ")),
            qPrintable(bench->action(Action::Write).reason));
        const QString reason = bench->action(Action::Write).reason;
        QTRY_VERIFY(bench->action(Action::Write).reason != reason); // it counts down
        bench->setup().setPersistency(Persistency::Volatile);
        QVERIFY(bench->action(Action::Write).isEnabled);
    }

    void anAxisThatIsNotHomedSaysSo()
    {
        ControllerBench bench;
        drivecomm::VirtualDriveOptions options = ControllerBench::xyDrive();
        options.axes.front().homed = false;
        bench.addDrive("http://x", options);
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        QVERIFY(bench.planAndWrite());
        QCOMPARE(bench->hint(), QStringLiteral("The axis must be homed first."));
        bench->activate();
        QVERIFY(!bench->busy().isBusy);
        QCOMPARE(bench->outcome(), QStringLiteral("The axis must be homed first."));
        QVERIFY(bench->action(Action::Evaluate).isEnabled);
    }

    void persistencyOfTheTableOnTheDriveChangesWithoutAFile()
    {
        ControllerBench bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        QVERIFY(bench.planAndWrite());
        bench->closeData();
        QVERIFY(!bench->dataFile().data);
        bench->setup().setPersistency(Persistency::Persistent);
        QCOMPARE(bench->hint(), QStringLiteral("Parameters must be written."));
        QVERIFY(bench.planAndWrite());
        QVERIFY(bench->outcome().endsWith(QStringLiteral("It is stored in flash.")));
        QVERIFY(bench->status()->table->persistent);
        QCOMPARE(bench->flashOperationsLeft(), 7);
    }

    void anotherAxisCannotBeChosenWhileSomethingRuns()
    {
        ControllerBench bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        bench->planWrite();
        QSignalSpy current(&bench.controller(), &WizardController::currentAxisChanged);
        bench->selectAxis(1);
        QCOMPARE(bench->currentAxis(), 0);
        QCOMPARE(current.count(), 1); // the field goes back
        QVERIFY(bench.idle());
    }

    void aDriveThatIsTakenAwayWhileItIsWrittenToEndsTheOperation()
    {
        ControllerBench bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        bench->planWrite();
        QVERIFY(bench.idle());
        bench.drive().gate.setAt(9, DriveGate::Mode::Silent);
        bench->write();
        QTRY_COMPARE(bench.drive().gate.waiting(), 1);
        bench->setEndpoints({});
        QVERIFY(!bench->busy().isBusy);
        QCOMPARE(bench->currentAxis(), -1);
        bench.drive().gate.set(DriveGate::Mode::Open);
        bench.endController(); // waits for the roll-back
        QCOMPARE(bench.drive().text(tableX), "Disabled");
    }
};

QTEST_GUILESS_MAIN(TestWizardWrites)
#include "tst_wizardwrites.moc"
