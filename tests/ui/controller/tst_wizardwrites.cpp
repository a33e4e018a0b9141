// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"
#include "tests/ui/support/controller_fixture.h"
#include "tests/ui/support/write_outcomes.h"
#include "ui/outcome/foreign_change.h"

#include <QSignalSpy>
#include <QTest>

namespace tst_wizardwrites {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::ControllerFixture;
using test::DriveGate;
using test::oldState;
using test::tableX;
using test::written;

class TestWizardWrites : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void fromAFileToAnActiveCompensation()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        QCOMPARE(bench->hint(), QStringLiteral("The parameters still have to be saved."));
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
        QVERIFY2(bench->outcome().startsWith(written), qPrintable(bench->outcome()));
        QVERIFY(!bench->isOutcomeAnError());
        QVERIFY(!bench->setup().isDirty());
        QVERIFY(!bench->setup().edited().table.fileTable); // it is the drive's now
        QCOMPARE(bench->setup().baseline().dimensionality, 2);
        QCOMPARE(bench.drive().text(tableX), bench->setup().baseline().slot);

        bench->activate();
        QVERIFY(bench.idle());
        QCOMPARE(bench->status()->axis.stateWord, "Active");
        QVERIFY(bench->proof().has_value());
        QCOMPARE(bench->proof()->samples.size(), std::size_t{5});
        QVERIFY2(
            bench->outcome().startsWith(QStringLiteral("The compensation is active. Proved over ")),
            qPrintable(bench->outcome()));
        // How much is proved by now stands beside the state.
        QVERIFY(!bench->outcome().contains(QStringLiteral("Move the axis")));
        QCOMPARE(bench->action(Action::Activate).reason,
            QStringLiteral("The compensation is already active."));

        bench->deactivate();
        QVERIFY(bench.idle());
        QCOMPARE(bench->status()->axis.stateWord, "Disabled");
        QCOMPARE(bench->outcome(), QStringLiteral("The compensation is off."));
    }

    void theSameNumbersInAnotherUnitAreAnotherTable()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        QVERIFY(bench.planAndWrite());
        QVERIFY(!bench->setup().isDirty(Field::Table));
        for (const QByteArray unit : {"[um]", "[arcsec]"}) {
            QByteArray other = ControllerFixture::calibration2D(1);
            const qsizetype values = other.indexOf("[mm]", other.indexOf("Y [mm]") + 6);
            QVERIFY(values > 0);
            other.replace(values, 4, unit);
            bench->openData(bench.file(QStringLiteral("other.csv"), other));
            QVERIFY(bench.fileRead());
            QVERIFY2(bench->setup().isDirty(Field::Table), unit.constData());
        }
    }

    /// Also in a program that was started anew: nothing but the numbers says that it is the same.
    void aTableThatTheDriveHasAlreadyIsNotChangedAndBlocksNothing()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        QVERIFY(bench.planAndWrite());
        bench.endController();

        QVERIFY(bench.connect());
        bench->openData(bench.path(QStringLiteral("2d-1.csv")));
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->setup().edited().table.fileTable, std::optional<int>(0));
        QVERIFY(!bench->setup().isDirty(Field::Table));
        QVERIFY(!bench->setup().isDirty());
        QVERIFY2(bench->action(Action::Activate).isEnabled,
            qPrintable(bench->action(Action::Activate).reason));
        QVERIFY(!bench->action(Action::Write).isEnabled);
        // The other table of the file is another one.
        bench->setup().setTable({1});
        QVERIFY(bench->setup().isDirty(Field::Table));
        QVERIFY(!bench->action(Action::Activate).isEnabled);
        bench->setup().setTable({0});
        QVERIFY(!bench->setup().isDirty());
        // What is changed beside it costs what it costs with the drive's table.
        bench->setup().setPersistency(Persistency::Persistent);
        QVERIFY(bench->setup().isDirty() && !bench->setup().isDirty(Field::Table));
        QVERIFY(bench.planAndWrite());
        QVERIFY2(!bench->isOutcomeAnError(), qPrintable(bench->outcome()));
        QVERIFY(bench->status()->table->persistent);
    }

    void theTableOnTheDriveIsTheFilesOneWithItsNamesAndComesBackOnceOnly()
    {
        ControllerFixture bench;
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

    /// A table file on the drive says nothing of axes: what it is of is known by the sources alone.
    void aTableAtAnotherSourceIsDescribedAnew()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        bench.chooseMasterSources(1);
        bench->openData(bench.file(
            QStringLiteral("x.csv"), "Pos X [mm];Comp X [mm]\n0;0.001\n10;0.002\n20;0.003\n"));
        QVERIFY(bench.fileRead());
        QVERIFY(bench.planAndWrite());
        QVERIFY2(!bench->isOutcomeAnError(), qPrintable(bench->outcome()));
        bench.endController(); // with the names that the file has

        QVERIFY(bench.connect());
        QTRY_VERIFY(bench->driveTable());
        QCOMPARE(bench->driveTable()->grid.axes.at(0).name, "X");
        bench->chooseSource(1, QString::fromStdString(test::masterY));
        QTRY_VERIFY(bench->action(Action::Write).isEnabled);
        QVERIFY(bench.planAndWrite());
        QVERIFY2(!bench->isOutcomeAnError(), qPrintable(bench->outcome()));
        QTRY_VERIFY(bench->driveTable());
        QCOMPARE(bench->driveTable()->grid.axes.at(0).name, "Y");
        QCOMPARE(bench->driveTable()->values.size(), std::size_t{3});
    }

    void evaluatingProvesTheIndicesAndAddsNothing()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        QVERIFY(bench.planAndWrite());
        bench->evaluate();
        QVERIFY(bench.idle());
        QCOMPARE(bench->status()->axis.stateWord, "Evaluating");
        QVERIFY(bench->outcome().startsWith(
            QStringLiteral("The compensation is being evaluated: the drive adds nothing. Its table "
                           "indices are right.")));
        QVERIFY(!bench->outcome().contains(QStringLiteral("roved")));
        QVERIFY(!bench->movingProof());
        QVERIFY(bench->action(Action::Deactivate).isEnabled);
        QVERIFY(bench->action(Action::Activate).isEnabled);
    }

    void theProofGrowsWhileTheAxisMovesAndEndsWithTheActivation()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        QVERIFY(bench.planAndWrite());
        QVERIFY(!bench->movingProof());
        bench->activate();
        QVERIFY(bench.idle());
        QTRY_VERIFY(bench->driveTable());
        QVERIFY(bench.readLive());
        QVERIFY(bench->movingProof());
        const double first = bench->movingProof()->part().share();
        QVERIFY(first > 0.0);
        for (int i = 0; i < 10; ++i) {
            bench.drive().milliseconds += 3000;
            QVERIFY(bench.readLive());
        }
        QVERIFY(bench->movingProof()->part().share() > first);
        QVERIFY(!bench->movingProof()->failure());
        bench->deactivate();
        QVERIFY(bench.idle());
        QVERIFY(!bench->movingProof());
    }

    void aDriveThatContradictsItsTableWhileActiveIsAnErrorOnce()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        QVERIFY(bench.planAndWrite());
        bench->activate();
        QVERIFY(bench.idle());
        QTRY_VERIFY(bench->driveTable());
        QVERIFY(bench.readLive());
        QVERIFY(!bench->isOutcomeAnError());
        bench.drive().faults.load()->altersReading = [](RegisterReading& reading) {
            if (reading.path == "Axes[0]/Signals/Compensations/Axis/Output")
                reading.value = std::get<float>(reading.value) + 1e-4F;
        };
        QSignalSpy outcomes(&bench.controller(), &WizardController::outcomeChanged);
        for (int i = 0; i < 3; ++i)
            QVERIFY(bench.readLive());
        QCOMPARE(outcomes.count(), 1);
        QVERIFY(bench->isOutcomeAnError());
        QVERIFY2(bench->outcome().startsWith(
                     QStringLiteral("The compensation is active, but the drive contradicts its "
                                    "table. Stop the axis and deactivate. ")),
            qPrintable(bench->outcome()));
        QVERIFY(bench->movingProof()->failure());
    }

    void whatTheUserChangesWhileAWriteIsPlannedStopsIt()
    {
        ControllerFixture bench;
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
        ControllerFixture bench;
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

    void whyAWriteIsRefusedGoesWithWhatWasChosen_data()
    {
        QTest::addColumn<bool>("opensAnother");
        QTest::newRow("another file") << true;
        QTest::newRow("another persistency") << false;
    }
    void whyAWriteIsRefusedGoesWithWhatWasChosen()
    {
        QFETCH(const bool, opensAnother);
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        const QByteArray other = "// target: Z\n" + ControllerFixture::calibration2D(1);
        bench->openData(bench.file(QStringLiteral("other.csv"), other));
        QVERIFY(bench.fileRead());
        bench->planWrite();
        QVERIFY(bench.idle());
        QVERIFY(!bench->plan().has_value());
        QVERIFY2(bench->isOutcomeAnError(), qPrintable(bench->outcome()));
        if (opensAnother)
            QVERIFY(bench.prepare2D(2));
        else
            bench->setup().setPersistency(Persistency::Persistent);
        QCOMPARE(bench->outcome(), QString());
    }

    void whatSomebodyElseChangesBetweenPlanAndWriteIsNotOverwritten()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        bench->planWrite();
        QVERIFY(bench.idle());
        const auto y = bench.drive().drive.readRegisters({test::masterY});
        bench.drive().set("Axes[0]/Parameters/Compensations/Axis/Dim1Source", y->front().address);
        bench->write();
        QVERIFY(bench.idle());
        QVERIFY(bench->isOutcomeAnError());
        QVERIFY2(bench->outcome().startsWith(QStringLiteral("Somebody else changed")),
            qPrintable(bench->outcome()));
        QCOMPARE(bench.drive().text(tableX), "Disabled");
        // What the drive has is shown; the user's choice stays.
        QCOMPARE(bench->setup().baseline().sources[0].path, test::masterY);
        QCOMPARE(bench->setup().edited().sources[0].path, test::masterX);
        QVERIFY(bench->setup().edited().table.fileTable.has_value());
    }

    void onlyWhatThisWindowHasNotChangedIsLoggedAsSuch()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        const auto foreignChanges = [&] {
            return std::ranges::count_if(bench->log(), [](const LogLine& line) {
                return line.text().contains(QStringLiteral("not by this window"));
            });
        };
        QVERIFY(bench.planAndWrite());
        QVERIFY2(bench->outcome().startsWith(written), qPrintable(bench->outcome()));
        QVERIFY(bench.readLive());
        QCOMPARE(foreignChanges(), 0);
        const auto y = bench.drive().drive.readRegisters({test::masterY});
        bench.drive().set("Axes[0]/Parameters/Compensations/Axis/Dim1Source", y->front().address);
        QVERIFY(bench.readLive());
        QCOMPARE(foreignChanges(), 1);
        QCOMPARE(bench->outcome(),
            QStringLiteral("The settings of this axis on the drive have changed, and not by this "
                           "window: source 1."));
        QVERIFY(bench->isOutcomeAWarning());
    }

    /// An absolute encoder needs no homing after a restart, which is then no other program.
    void aRestartOfAHomedAxisIsNotSaidToBeAnotherProgram()
    {
        AxisStatus before;
        before.axis.isHomed = true;
        before.setup.sources[0] = {1, test::masterX};
        before.setup.tableCrc = 1;
        before.table.emplace();
        AxisStatus now = before;
        now.setup = {};
        now.table.reset();
        QCOMPARE(foreignChange(before, now).text,
            QStringLiteral("Its volatile table is gone: write it again, as a persistent one if it "
                           "has to outlast a restart. The settings of this axis on the drive have "
                           "changed, and not by this window: source 1, table."));
    }

    void aMessageOfSuccessDoesNotOutliveItsTruth_data()
    {
        QTest::addColumn<QString>("event");
        QTest::addColumn<QString>("message");
        QTest::newRow("switched off") << "off"
                                      << "The compensation is off: something other than this "
                                         "window has switched it off.";
        QTest::newRow("restart")
            << "restart"
            << "The axis has lost its homing, as after a restart of the drive: the compensation is "
               "off. Home the axis and activate again. Its volatile table is gone: write it again, "
               "as a persistent one if it has to outlast a restart.";
    }
    void aMessageOfSuccessDoesNotOutliveItsTruth()
    {
        QFETCH(const QString, event);
        QFETCH(const QString, message);
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        bench->setup().setPersistency(Persistency::Volatile);
        QVERIFY(bench.planAndWrite());
        bench->activate();
        QVERIFY(bench.idle());
        QVERIFY2(!bench->isOutcomeAnError(), qPrintable(bench->outcome()));
        QVERIFY2(bench->outcome().contains(QStringLiteral("active")), qPrintable(bench->outcome()));
        if (event == QStringLiteral("off"))
            bench.drive().set(
                "Axes[0]/Commands/Compensations/Axis/Activation", std::string("Disabled"));
        else
            bench.drive().drive.reboot();
        QTRY_VERIFY2(bench.readLive() && bench->isOutcomeAWarning(), qPrintable(bench->outcome()));
        QCOMPARE(bench->outcome(), message);
        QVERIFY(std::ranges::any_of(bench->log(), [&](const LogLine& line) {
            return line.kind == LogLine::Kind::Warning && line.text() == message;
        }));
    }

    void aWriteThatIsCancelledLeavesTheOldState()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        bench->planWrite();
        QVERIFY(bench.idle());
        bench.drive().gate.setAt(9, DriveGate::Mode::Silent);
        bench->write();
        QTRY_COMPARE(bench.drive().gate.waiting(), 1);
        QVERIFY(bench->action(Action::Cancel).isEnabled);
        QCOMPARE(bench->action(Action::Cancel).reason,
            QStringLiteral("Stops the write and rolls back."));
        bench->cancel();
        QVERIFY(!bench->action(Action::Cancel).isEnabled);
        bench.drive().gate.set(DriveGate::Mode::Open);
        QVERIFY(bench.idle());
        QCOMPARE(bench->outcome(), QStringLiteral("The write was stopped. ") + oldState);
        QCOMPARE(bench.drive().text(tableX), "Disabled");
        QVERIFY(bench->setup().isDirty(Field::Table));
        QVERIFY(bench->action(Action::Write).isEnabled);
        QVERIFY(bench.planAndWrite());
        QVERIFY(bench->outcome().startsWith(written));
    }

    /// Another program has run into it, or this one before its last start.
    void aRefusalOfTheDriveIsRememberedAcrossStarts()
    {
        ControllerFixture bench;
        DriveStore store = bench.store();
        VERIFY_RESULT(store.recordFlashRefusal(
            4711, std::chrono::system_clock::now(), std::chrono::seconds(300)));
        QVERIFY(bench.connect());
        QCOMPARE(bench->flashOperationsLeft(), 0);
        QVERIFY(bench->flashWaitSeconds() > 290);
        QVERIFY(bench.prepare2D());
        bench->setup().setPersistency(Persistency::Persistent);
        QVERIFY2(bench->action(Action::Write)
                     .reason.startsWith(QStringLiteral("To spare the flash, wait ")),
            qPrintable(bench->action(Action::Write).reason));
        bench->setup().setPersistency(Persistency::Volatile);
        QVERIFY(bench.planAndWrite());
        QVERIFY2(bench->outcome().startsWith(written), qPrintable(bench->outcome()));
        QVERIFY(bench->flashUse().has_value());
        QCOMPARE(bench->flashUse()->mostCycles, 0U);
    }

    void flashWearIsKnownBeforehand()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        DriveStore store = bench.store();
        VERIFY_RESULT(store.recordFlash(4711, std::chrono::system_clock::now(), 7));
        QVERIFY(bench.prepare2D());
        bench->setup().setPersistency(Persistency::Persistent);
        QVERIFY(bench.planAndWrite());
        QCOMPARE(bench->flashOperationsLeft(), 0);
        QVERIFY(bench->flashWaitSeconds() > 590);
        QVERIFY(bench.prepare2D(2) == false); // persistent as the table before
        QVERIFY2(bench->action(Action::Write)
                     .reason.startsWith(QStringLiteral("To spare the flash, wait ")),
            qPrintable(bench->action(Action::Write).reason));
        const QString reason = bench->action(Action::Write).reason;
        QTRY_VERIFY(bench->action(Action::Write).reason != reason); // it counts down
        bench->setup().setPersistency(Persistency::Volatile);
        QVERIFY(bench->action(Action::Write).isEnabled);
    }

    void anAxisThatIsNotHomedSaysSo()
    {
        ControllerFixture bench;
        drivecomm::VirtualDriveOptions options = ControllerFixture::xyDrive();
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
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        QVERIFY(bench.planAndWrite());
        bench->closeData();
        QVERIFY(!bench->dataFile().data);
        bench->setup().setPersistency(Persistency::Persistent);
        QCOMPARE(bench->hint(), QStringLiteral("The parameters still have to be saved."));
        QVERIFY(bench.planAndWrite());
        QVERIFY(bench->outcome().endsWith(QStringLiteral("It is stored in flash.")));
        QVERIFY(bench->status()->table->persistent);
        QCOMPARE(bench->flashOperationsLeft(), 7);
    }

    void anotherAxisCannotBeChosenWhileSomethingRuns()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        bench->planWrite();
        QSignalSpy current(&bench.controller(), &WizardController::currentAxisChanged);
        bench->selectAxis(1);
        QCOMPARE(bench->currentAxis(), 0);
        QCOMPARE(current.count(), 1); // the field goes back
        QVERIFY(bench.idle());
    }
};

AXISCOMP_TEST(TestWizardWrites)

} // namespace tst_wizardwrites

#include "tst_wizardwrites.moc"
