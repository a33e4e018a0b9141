// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"
#include "tests/ui/support/controller_fixture.h"
#include "tests/ui/support/write_outcomes.h"

#include <QDir>
#include <QFile>
#include <QTest>

#include <algorithm>

namespace tst_wizardfaults {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::ControllerFixture;
using test::DriveGate;
using test::LinkFault;
using test::oldState;
using test::tableX;
using test::written;

class TestWizardFaults : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

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
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        QVERIFY(bench.planAndWrite());
        const CompensationSetup before = bench->setup().baseline();
        bench->openData(bench.file(QStringLiteral("new.csv"), ControllerFixture::calibration2D(7)));
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
        if (bench->outcome().startsWith(written)) {
            QVERIFY(now == after || fault == static_cast<int>(LinkFault::Reboot));
            return;
        }
        // A table that is not persistent is gone after a reboot, whatever the program does.
        if (bench->outcome().endsWith(oldState) && fault != static_cast<int>(LinkFault::Reboot)) {
            QVERIFY(now == before);
            QVERIFY(bench->setup().isDirty(Field::Table));
        }
    }

    void aDriveThatIsGoneInTheMiddleIsSettledWhenItIsBack()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        bench->planWrite();
        QVERIFY(bench.idle());
        // Far enough that the journal is open, and for so long that nothing can be put back.
        bench.drive().gate.setAt(19, DriveGate::Mode::Gone);
        bench->write();
        QVERIFY(bench.idle());
        QVERIFY(bench->isOutcomeAnError());
        QCOMPARE(bench->drives().front().connection, DriveState::Connection::Lost);
        QVERIFY(bench->setup().isDirty(Field::Table)); // never what was sent
        bench.drive().gate.set(DriveGate::Mode::Open);
        QTRY_COMPARE(bench->drives().front().connection, DriveState::Connection::Connected);
        QVERIFY(bench.readLive());
        QCOMPARE(bench.drive().text(tableX) == "Disabled", bench->setup().baseline().slot.empty());
        DriveStore store = bench.store();
        const auto journal = store.journal(4711, 0);
        VERIFY_RESULT(journal);
        QVERIFY(!journal->has_value());
    }

    void aDriveThatIsTakenAwayWhileItIsWrittenToEndsTheOperation()
    {
        ControllerFixture bench;
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

    void withoutItsJournalAnAxisCanOnlyBeSwitchedOff()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        QVERIFY(bench.planAndWrite());
        bench->activate();
        QVERIFY(bench.idle());
        QCOMPARE(bench->status()->axis.stateWord, "Active");
        bench.endController();
        const QString database = bench.path(QStringLiteral("store/axiscomp.db"));
        for (const char* const ending : {"", "-wal", "-shm"})
            QFile::remove(database + QLatin1String(ending));
        QVERIFY(QDir().mkpath(database));

        bench->setEndpoints({QStringLiteral("http://x")});
        QTRY_VERIFY(bench->status().has_value());
        QVERIFY2(bench->hint().contains(QStringLiteral("axiscomp.db")), qPrintable(bench->hint()));
        QVERIFY(!bench->action(Action::Write).isEnabled);
        QVERIFY(!bench->action(Action::RestoreDrive).isEnabled);
        QTRY_VERIFY(bench->driveTable());
        const auto isOfDatabase = [](const LogLine& line) {
            return line.kind == LogLine::Kind::Error
                && line.text().contains(QStringLiteral("axiscomp.db"));
        };
        QCOMPARE(std::ranges::count_if(bench->log(), isOfDatabase), 1);
        bench->deactivate();
        QVERIFY(bench.idle());
        QCOMPARE(bench->status()->axis.stateWord, "Disabled");
        QVERIFY(!bench->action(Action::Evaluate).isEnabled);
    }
};

AXISCOMP_TEST(TestWizardFaults)

} // namespace tst_wizardfaults

#include "tst_wizardfaults.moc"
