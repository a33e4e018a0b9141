// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compensator/axis_operations.h"
#include "core/compensator/configuration_transfer.h"
#include "core/io/local_file.h"
#include "core/machine/snapshot.h"
#include "tests/support/changed_backup.h"
#include "tests/support/compensator_fixture.h"
#include "tests/support/moments.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

namespace tst_recovery {

using namespace axiscomp;
using axiscomp::test::CompensatorFixture;
using axiscomp::test::exampleRequest;
using axiscomp::test::exampleTable;
using axiscomp::test::LinkFault;

namespace {

/// A write of a persistent table that was interrupted: exchange counts from its first change.
struct Interrupted : CompensatorFixture {
    explicit Interrupted(int exchange = 2)
    {
        QVERIFY(compensator.write(0, exampleRequest(1, Persistency::Persistent)).has_value());
        old = state();
        CompensatorFixture whole;
        QVERIFY(whole.compensator.write(0, exampleRequest(1, Persistency::Persistent)).has_value());
        const int begin = whole.link.exchanges();
        whole.link.forgetChange();
        QVERIFY(whole.compensator.write(0, exampleRequest(2, Persistency::Persistent)).has_value());
        wanted = whole.state();
        link.failAt(whole.link.firstChange() - begin + exchange, LinkFault::DriveGone);
        QVERIFY(!compensator.write(0, exampleRequest(2, Persistency::Persistent)).has_value());
        link.heal();
        entry = *store.journal(4711, 0).value();
    }
    [[nodiscard]] bool isUnfinished() { return store.journal(4711, 0).value().has_value(); }

    State old;
    State wanted;
    JournalEntry entry;
};

struct Scenario {
    const char* name;
    Persistency before; ///< of the old table
    Persistency after;
    bool hasOldTable;
    bool isSlotFree;
    bool keepsTable; ///< only persistency and sources change
    bool deletes = false; ///< after: Persistent says that a reboot brings nothing back
};

constexpr std::array scenarios{
    Scenario{"first, volatile", Persistency::Volatile, Persistency::Volatile, false, true, false},
    Scenario{
        "first, persistent", Persistency::Volatile, Persistency::Persistent, false, true, false},
    Scenario{"replace, volatile by volatile", Persistency::Volatile, Persistency::Volatile, true,
        true, false},
    Scenario{"replace, persistent by persistent", Persistency::Persistent, Persistency::Persistent,
        true, true, false},
    Scenario{"replace, persistent by volatile", Persistency::Persistent, Persistency::Volatile,
        true, true, false},
    Scenario{"overwrite in place, volatile", Persistency::Volatile, Persistency::Volatile, true,
        false, false},
    Scenario{"overwrite in place, persistent", Persistency::Persistent, Persistency::Persistent,
        true, false, false},
    Scenario{"make persistent", Persistency::Volatile, Persistency::Persistent, true, true, true},
    Scenario{"make volatile", Persistency::Persistent, Persistency::Volatile, true, true, true},
    Scenario{"delete, persistent", Persistency::Persistent, Persistency::Persistent, true, true,
        false, true},
    Scenario{"delete, volatile", Persistency::Volatile, Persistency::Persistent, true, true, false,
        true},
};

/// A drive in the state before the write, and the write.
struct Begun : CompensatorFixture {
    explicit Begun(const Scenario& chosen)
    {
        if (!chosen.isSlotFree)
            fillOtherSlots();
        if (chosen.hasOldTable) {
            const auto written = compensator.write(0, exampleRequest(1, chosen.before));
            QVERIFY2(written.has_value(), "the old table could not be written");
        }
        request = exampleRequest(2, chosen.after);
        if (chosen.keepsTable) {
            request.table.reset();
            std::swap(request.sources[0], request.sources[1]);
        }
        if (chosen.deletes)
            request = deletionRequest();
        old = state();
    }

    /// Tables of a drive program: with them there the axis has only one slot.
    void fillOtherSlots()
    {
        const auto file =
            encodeTamTable(exampleTable(1, 9), false, drivecomm::genericProfile().layout);
        for (const TableSlot& slot : drivecomm::genericProfile().tableSlots) {
            if (slot.name != "Small1")
                QVERIFY(drive.upload(slot.file, *file).has_value());
        }
    }

    Result<WriteReport> write() { return compensator.write(0, request); }
    [[nodiscard]] bool isEmpty(const std::string& file)
    {
        return drive.download(file).value_or(Bytes{}).empty();
    }

    State old;
    WriteRequest request;
};

/// Axis 0 names a slot whose volatile table a restart has taken.
struct Emptied : CompensatorFixture {
    Emptied()
    {
        const bool isWritten = compensator.write(0, exampleRequest(1)).has_value()
            && compensator.write(1, exampleRequest(1, Persistency::Persistent)).has_value();
        QVERIFY2(isWritten, "the tables could not be written");
        drive.reboot();
        old = state();
        QVERIFY2(old.registers[0] == "Small1" && old.table.empty(), "the slot is not empty");
    }

    State old;
};

using Recover = Result<WriteReport> (AxisCompensator::*)(
    const JournalEntry&, const OperationOptions&);
constexpr std::array ways{&AxisCompensator::finishUnfinished, &AxisCompensator::undoUnfinished};

} // namespace

class TestRecovery : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void anInterruptedWriteIsFinishedOrUndone_data()
    {
        QTest::addColumn<int>("scenario");
        QTest::addColumn<int>("fault");
        QTest::addColumn<bool>("finishes");
        for (std::size_t s = 0; s < scenarios.size(); ++s) {
            for (const LinkFault fault : {LinkFault::DriveGone, LinkFault::DriveGoneAfter}) {
                for (const bool finishes : {true, false})
                    QTest::addRow("%s: drive gone%s, %s", scenarios[s].name,
                        fault == LinkFault::DriveGone ? "" : " after", finishes ? "finish" : "undo")
                        << static_cast<int>(s) << static_cast<int>(fault) << finishes;
            }
        }
    }

    void anInterruptedWriteIsFinishedOrUndone()
    {
        QFETCH(int, scenario);
        QFETCH(int, fault);
        QFETCH(bool, finishes);
        const Scenario& chosen = scenarios[static_cast<std::size_t>(scenario)];
        Begun whole(chosen);
        const int begin = whole.link.exchanges();
        VERIFY_RESULT(whole.write());
        const int exchanges = whole.link.exchanges() - begin;
        const CompensatorFixture::State wanted = whole.state();
        whole.drive.reboot();
        const CompensatorFixture::State wantedAfterReboot = whole.state();

        int unfinished = 0;
        for (int exchange = 1; exchange <= exchanges; ++exchange) {
            if (!test::hasTurn(exchange + scenario + 2 * fault + (finishes ? 1 : 0), 4))
                continue; // each exchange has one of the two faults, and one of the two ways
            Begun c(chosen);
            c.link.failAt(exchange, static_cast<LinkFault>(fault));
            (void)c.write();
            c.link.heal();
            const QByteArray where = "exchange " + QByteArray::number(exchange);
            const auto status = c.compensator.status(0);
            VERIFY_RESULT(status);
            if (!status->unfinishedWrite)
                continue;
            ++unfinished;
            const JournalEntry entry = *status->unfinishedWrite;
            const auto recovery = c.compensator.recovery(entry);
            VERIFY_RESULT(recovery);
            QVERIFY2(!recovery->finishObstacle && !recovery->undoObstacle, where);
            const auto report = finishes ? c.compensator.finishUnfinished(entry)
                                         : c.compensator.undoUnfinished(entry);
            QVERIFY2(report.has_value(),
                where + ": " + (report ? "" : test::describe(report.error()).c_str()));
            QVERIFY2(c.state() == (finishes ? wanted : c.old),
                where + ": Table is " + c.state().registers[0].c_str() + ", begun with "
                    + entry.step.c_str());
            QVERIFY2(!c.compensator.status(0)->unfinishedWrite, where + ": still unfinished");
            if (chosen.deletes)
                QVERIFY2(c.isEmpty("tables/small1.TAMtbl") == finishes, where + ": the slot");
            QVERIFY2(keptTables(c).isEmpty(), where + ": the kept table is still there");
            if (finishes && chosen.after == Persistency::Persistent) {
                c.drive.reboot();
                QVERIFY2(c.state() == wantedAfterReboot, where + ": gone after a reboot");
            }
            if (!finishes && chosen.deletes && chosen.before == Persistency::Persistent) {
                c.drive.reboot();
                QVERIFY2(c.state() == c.old, where + ": not as it was after a reboot");
            }
            WriteRequest next = exampleRequest(3);
            const auto following = c.compensator.write(0, next);
            QVERIFY2(following.has_value(),
                where + ": " + (following ? "" : test::describe(following.error()).c_str()));
        }
        QVERIFY2(unfinished > 0, "no interruption left anything to do");
    }

    void whatIsSaidToBeUndoneIsThereAlsoWhenTheDriveRestartsMeanwhile_data()
    {
        QTest::addColumn<int>("scenario");
        for (const int s : {2, 5})
            QTest::addRow("%s", scenarios[static_cast<std::size_t>(s)].name) << s;
    }

    /// The old table is volatile: a restart takes it away again that has just been put back.
    void whatIsSaidToBeUndoneIsThereAlsoWhenTheDriveRestartsMeanwhile()
    {
        QFETCH(int, scenario);
        const Scenario& chosen = scenarios[static_cast<std::size_t>(scenario)];
        Begun whole(chosen);
        const int begin = whole.link.exchanges();
        VERIFY_RESULT(whole.write());
        const int exchanges = whole.link.exchanges() - begin;
        int undone = 0;
        bool isOver = false;
        for (int exchange = 1; !isOver; ++exchange) {
            Begun c(chosen);
            c.link.failAt(exchanges - 3, LinkFault::DriveGoneAfter);
            (void)c.write();
            c.link.heal();
            const auto status = c.compensator.status(0);
            VERIFY_RESULT(status);
            QVERIFY(status->unfinishedWrite.has_value());
            const JournalEntry entry = *status->unfinishedWrite;
            const int before = c.link.exchanges();
            c.link.failAt(exchange, LinkFault::Reboot);
            const auto report = c.compensator.undoUnfinished(entry);
            isOver = c.link.exchanges() - before < exchange;
            c.link.heal();
            const QByteArray where = "restart at exchange " + QByteArray::number(exchange);
            if (report) {
                ++undone;
                QVERIFY2(
                    c.state() == c.old, where + ": Table is " + c.state().registers[0].c_str());
                continue;
            }
            const auto again = c.compensator.undoUnfinished(entry);
            QVERIFY2(again.has_value(),
                where + ": " + (again ? "" : test::describe(again.error()).c_str()));
            QVERIFY2(c.state() == c.old, where + ": not the old state at the second try");
        }
        QVERIFY2(undone > 1, "no undoing ended well");
    }

    void anotherDriveIsLeftAlone()
    {
        Interrupted c;
        JournalEntry other = c.entry;
        other.serialNumber = 1;
        c.link.forgetChange();
        for (const Recover way : ways)
            VERIFY_ERROR((c.compensator.*way)(other, {}), ErrorCode::OtherDrive);
        VERIFY_ERROR(c.compensator.recovery(other), ErrorCode::OtherDrive);
        QCOMPARE(c.link.firstChange(), 0);
    }

    /// Copied configurations and virtual drives may share a serial number.
    void aTwinWithTheSameSerialNumberIsLeftAlone()
    {
        Interrupted c;
        drivecomm::VirtualDriveOptions options = CompensatorFixture::options(c.time);
        options.name = "Twin-2";
        drivecomm::VirtualDrive twin(drivecomm::genericProfile(), options);
        drivecomm::FaultPlan faults;
        const auto attachment = test::inProcess().attach(twin, faults);
        AxisCompensator other(attachment->link(), drivecomm::genericProfile(), c.store);
        const auto recovery = other.recovery(c.entry);
        VERIFY_ERROR(recovery, ErrorCode::OtherDrive);
        QCOMPARE(sentence(recovery.error()),
            std::string("this is another drive: expected serial number 4711 (Test-1, axes: 2), "
                        "found 4711 (Twin-2, axes: 2)"));
        VERIFY_ERROR(other.settleUnfinished(c.entry), ErrorCode::OtherDrive);
        for (const Recover way : ways)
            VERIFY_ERROR((other.*way)(c.entry, {}), ErrorCode::OtherDrive);
        QVERIFY(c.isUnfinished());
        VERIFY_RESULT(c.compensator.recovery(c.entry));
    }

    void whatUndoingCostsIsSaidBeforehand()
    {
        constexpr Scenario chosen{
            "replace", Persistency::Persistent, Persistency::Persistent, true, true, false};
        Begun whole(chosen);
        const int begin = whole.link.exchanges();
        VERIFY_RESULT(whole.write());
        const int exchanges = whole.link.exchanges() - begin;
        int most = 0;
        for (int exchange = 1; exchange <= exchanges; ++exchange) {
            Begun c(chosen);
            c.link.failAt(exchange, LinkFault::DriveGone);
            (void)c.write();
            c.link.heal();
            const auto entry = c.store.journal(4711, 0).value();
            if (!entry)
                continue;
            const auto recovery = c.compensator.recovery(*entry);
            VERIFY_RESULT(recovery);
            const auto report = c.compensator.undoUnfinished(*entry);
            VERIFY_RESULT(report);
            QVERIFY2(report->plan.flashOperations <= recovery->undoFlashOperations,
                "exchange " + QByteArray::number(exchange));
            most = std::max(most, report->plan.flashOperations);
        }
        QVERIFY2(most > 0, "no undoing has cost anything");
    }

    void undoingThatFlashDoesNotAllowNowIsAnObstacle()
    {
        constexpr Scenario chosen{
            "replace", Persistency::Persistent, Persistency::Persistent, true, true, false};
        int refused = 0;
        for (int exchange = 1; exchange < 200; ++exchange) {
            Begun c(chosen);
            c.link.failAt(exchange, LinkFault::DriveGone);
            const bool isWritten = c.write().has_value();
            c.link.heal();
            const auto entry = c.store.journal(4711, 0).value();
            if (isWritten && !entry)
                break;
            if (!entry || c.compensator.recovery(*entry)->undoFlashOperations == 0)
                continue;
            VERIFY_RESULT(c.store.recordFlash(
                4711, c.wallTime(), drivecomm::genericProfile().flashWear.operations));
            const auto recovery = c.compensator.recovery(*entry);
            VERIFY_RESULT(recovery);
            QVERIFY(recovery->undoObstacle && recovery->undoObstacle->code == ErrorCode::FlashWear);
            VERIFY_ERROR(c.compensator.undoUnfinished(*entry), ErrorCode::FlashWear);
            ++refused;
            break;
        }
        QCOMPARE(refused, 1);
    }

    void anAxisInAnotherUnitIsNeitherFinishedNorUndone_data()
    {
        QTest::addColumn<int>("axis");
        QTest::addColumn<std::string>("unit");
        QTest::addColumn<std::string>("said");
        QTest::newRow("values a thousand times as large")
            << 0 << std::string("Meter")
            << std::string("the values of axis 0 were in mm when the write began, and the drive "
                           "has them in m now, ");
        QTest::newRow("values that are angles")
            << 0 << std::string("Degree")
            << std::string("the values of axis 0 were in mm when the write began, and the drive "
                           "has them in deg now, ");
        QTest::newRow("positions of a source")
            << 1 << std::string("Degree")
            << std::string("the positions of dimension 2 of axis 0 were in mm when the write "
                           "began, and the drive has them in deg now, ");
    }

    /// The same numbers would mean something else, and both ways say that they are complete.
    void anAxisInAnotherUnitIsNeitherFinishedNorUndone()
    {
        QFETCH(const int, axis);
        QFETCH(const std::string, unit);
        QFETCH(const std::string, said);
        Interrupted c;
        c.set(unitOf(axis), unit);
        const auto recovery = c.compensator.recovery(c.entry);
        VERIFY_RESULT(recovery);
        for (const auto& obstacle : {recovery->finishObstacle, recovery->undoObstacle}) {
            QVERIFY(obstacle && obstacle->code == ErrorCode::UnitMismatch);
            QVERIFY2(sentence(*obstacle).starts_with(said), sentence(*obstacle).c_str());
        }
        c.link.forgetChange();
        for (const Recover way : ways)
            VERIFY_ERROR((c.compensator.*way)(c.entry, {}), ErrorCode::UnitMismatch);
        QCOMPARE(c.link.firstChange(), 0);
        QVERIFY(c.isUnfinished());
        // The way out that the sentence names.
        c.set(unitOf(axis), std::string("Millimeter"));
        VERIFY_RESULT(c.compensator.finishUnfinished(c.entry));
        QVERIFY(c.state() == c.wanted);
    }

    /// The state before it did not have that source: the way back is open.
    void aWriteIsNotFinishedOverANewSourceInAnotherUnit()
    {
        WriteRequest alone = exampleRequest(1, Persistency::Persistent);
        alone.dimensionality = 1;
        alone.sources.pop_back();
        alone.table = exampleTable(1);
        CompensatorFixture whole;
        VERIFY_RESULT(whole.compensator.write(0, alone));
        const int begin = whole.link.exchanges();
        whole.link.forgetChange();
        VERIFY_RESULT(whole.compensator.write(0, exampleRequest(2)));
        CompensatorFixture c;
        VERIFY_RESULT(c.compensator.write(0, alone));
        const CompensatorFixture::State old = c.state();
        c.link.failAt(whole.link.firstChange() - begin + 2, LinkFault::DriveGone);
        QVERIFY(!c.compensator.write(0, exampleRequest(2)).has_value());
        c.link.heal();
        const auto entry = c.store.journal(4711, 0).value();
        QVERIFY(entry.has_value());
        c.set(unitOf(1), std::string("Degree"));
        const auto recovery = c.compensator.recovery(*entry);
        VERIFY_RESULT(recovery);
        QVERIFY(
            recovery->finishObstacle && recovery->finishObstacle->code == ErrorCode::UnitMismatch);
        QVERIFY(!recovery->undoObstacle);
        VERIFY_ERROR(c.compensator.finishUnfinished(*entry), ErrorCode::UnitMismatch);
        VERIFY_RESULT(c.compensator.undoUnfinished(*entry));
        QVERIFY(c.state() == old);
    }

    /// Older programs noted no units of the new table: those of the backup count.
    void aJournalWithoutUnitsIsComparedWithItsBackup()
    {
        Interrupted c;
        c.entry.newUnits = {};
        VERIFY_RESULT(c.store.openJournal(c.entry));
        for (const int axis : {0, 1}) {
            c.set(unitOf(axis), std::string("Radian"));
            VERIFY_ERROR(c.compensator.finishUnfinished(c.entry), ErrorCode::UnitMismatch);
            c.set(unitOf(axis), std::string("Millimeter"));
        }
        VERIFY_RESULT(c.compensator.finishUnfinished(c.entry));
        QVERIFY(c.state() == c.wanted);
    }

    /// As after a change of the order of the axes: the table of Z is not for X.
    void anAxisOfAnotherNameIsNeitherFinishedNorUndone()
    {
        Interrupted c;
        test::nameInBackup(c.entry.backup, "Z");
        const auto recovery = c.compensator.recovery(c.entry);
        VERIFY_RESULT(recovery);
        for (const auto& obstacle : {recovery->finishObstacle, recovery->undoObstacle}) {
            QVERIFY(obstacle && obstacle->code == ErrorCode::TargetMismatch);
            QVERIFY2(sentence(*obstacle).starts_with("axis 0 was Z when the write began, and is X"),
                sentence(*obstacle).c_str());
        }
        c.link.forgetChange();
        for (const Recover way : ways)
            VERIFY_ERROR((c.compensator.*way)(c.entry, {}), ErrorCode::TargetMismatch);
        QCOMPARE(c.link.firstChange(), 0);

        test::nameInBackup(c.entry.backup, "Gantry"); // may be the same axis
        const auto doubted = c.compensator.recovery(c.entry);
        VERIFY_RESULT(doubted);
        QVERIFY(!doubted->finishObstacle && !doubted->undoObstacle);
        QCOMPARE(doubted->doubts.size(), std::size_t{1});
        const auto undone = c.compensator.undoUnfinished(c.entry);
        VERIFY_RESULT(undone);
        QVERIFY(undone->plan.warnings == doubted->doubts);
        QVERIFY(c.state() == c.old);
    }

    /// The axis had no table, so that nothing is doubtful about the way back.
    void aDoubtOfFinishingAloneIsSaid()
    {
        CompensatorFixture whole;
        const int begin = whole.link.exchanges();
        whole.link.forgetChange();
        VERIFY_RESULT(whole.compensator.write(0, exampleRequest(2)));
        CompensatorFixture c;
        c.link.failAt(whole.link.firstChange() - begin + 2, LinkFault::DriveGone);
        QVERIFY(!c.compensator.write(0, exampleRequest(2)).has_value());
        c.link.heal();
        JournalEntry entry = *c.store.journal(4711, 0).value();
        entry.newUnits = {}; // as an older program noted it
        VERIFY_RESULT(c.store.openJournal(entry));
        test::changeBackup(entry.backup, [](AxisBackup& axis) { axis.unit.clear(); });
        const auto recovery = c.compensator.recovery(entry);
        VERIFY_RESULT(recovery);
        QVERIFY(!recovery->finishObstacle && !recovery->undoObstacle);
        QCOMPARE(recovery->doubts.size(), std::size_t{1});
        QVERIFY2(
            recovery->doubts.front().english().starts_with("The backup does not say in which unit"),
            recovery->doubts.front().english().c_str());
        const auto finished = c.compensator.finishUnfinished(entry);
        VERIFY_RESULT(finished);
        QVERIFY(std::ranges::find(finished->plan.warnings, recovery->doubts.front())
            != finished->plan.warnings.end());
    }

    void anActiveCompensationIsLeftAlone()
    {
        Interrupted c;
        c.set("Axes[0]/Commands/Compensations/Axis/Activation", std::string("AddToEncoders"));
        const auto recovery = c.compensator.recovery(c.entry);
        VERIFY_RESULT(recovery);
        QVERIFY(recovery->finishObstacle->code == ErrorCode::CompensationActive);
        QVERIFY(recovery->undoObstacle->code == ErrorCode::CompensationActive);
        c.link.forgetChange();
        for (const Recover way : ways)
            VERIFY_ERROR((c.compensator.*way)(c.entry, {}), ErrorCode::CompensationActive);
        QCOMPARE(c.link.firstChange(), 0);
        QVERIFY(c.isUnfinished());
    }

    void anotherProgramThatWritesIsNotDisturbed()
    {
        Interrupted c;
        DriveStore impatient(std::filesystem::path(c.folder.path().toStdString()) / "axiscomp", {});
        AxisCompensator second(c.link, drivecomm::genericProfile(), impatient);
        const auto lock = c.store.lockWrites(4711);
        VERIFY_RESULT(lock);
        c.link.forgetChange();
        for (const Recover way : ways) {
            const auto refused = (second.*way)(c.entry, {});
            VERIFY_ERROR(refused, ErrorCode::FileNotWritable);
            QVERIFY(refused.error().context.contains(DriveStore::missingLock));
        }
        QCOMPARE(c.link.firstChange(), 0);
        QVERIFY(c.isUnfinished());
    }

    void whatSomebodyElseHasSettledIsSaid()
    {
        Interrupted c;
        JournalEntry next = c.entry;
        next.step = "save";
        VERIFY_RESULT(c.store.openJournal(next));
        VERIFY_ERROR(c.compensator.finishUnfinished(c.entry), ErrorCode::ChangedMeanwhile);
        VERIFY_RESULT(c.store.closeJournal(4711, 0));
        VERIFY_ERROR(c.compensator.undoUnfinished(c.entry), ErrorCode::NothingUnfinished);
    }

    void aJournalWithoutATableCanOnlyBeUndone()
    {
        Interrupted c;
        c.entry.newTable.reset(); // as older versions kept it
        VERIFY_RESULT(c.store.openJournal(c.entry));
        const auto recovery = c.compensator.recovery(c.entry);
        VERIFY_RESULT(recovery);
        QVERIFY(recovery->finishObstacle->code == ErrorCode::TableNotKept);
        QVERIFY(!recovery->undoObstacle);
        VERIFY_ERROR(c.compensator.finishUnfinished(c.entry), ErrorCode::TableNotKept);
        VERIFY_RESULT(c.compensator.undoUnfinished(c.entry));
        QVERIFY(c.state() == c.old);
    }

    void aKeptTableThatIsDamagedIsNotWritten()
    {
        Interrupted c;
        const auto file =
            encodeTamTable(exampleTable(2, 7), false, drivecomm::genericProfile().layout);
        VERIFY_RESULT(saveFile(c.entry.newTable->file, *file));
        VERIFY_ERROR(c.compensator.finishUnfinished(c.entry), ErrorCode::FileNotReadable);
        VERIFY_RESULT(c.compensator.undoUnfinished(c.entry));
        QVERIFY(c.state() == c.old);
    }

    /// Whatever becomes of finishing: the way back still leads to the state before the write.
    void finishingThatIsInterruptedCanStillBeUndone()
    {
        Interrupted whole;
        const int begin = whole.link.exchanges();
        VERIFY_RESULT(whole.compensator.finishUnfinished(whole.entry));
        const int exchanges = whole.link.exchanges() - begin;
        for (const LinkFault fault :
            {LinkFault::DriveGone, LinkFault::DriveGoneAfter, LinkFault::Refused}) {
            for (int exchange = 1; exchange <= exchanges; ++exchange) {
                Interrupted c;
                c.link.failAt(exchange, fault);
                const auto finished = c.compensator.finishUnfinished(c.entry);
                c.link.heal();
                const QByteArray where = "exchange " + QByteArray::number(exchange);
                if (finished)
                    continue;
                QVERIFY2(c.isUnfinished(), where);
                const auto now = c.store.journal(4711, 0).value();
                const auto undone = c.compensator.undoUnfinished(*now);
                QVERIFY2(undone.has_value(),
                    where + (undone ? "" : test::describe(undone.error()).c_str()));
                QVERIFY2(c.state() == c.old, where);
            }
        }
    }

    void undoingThatIsInterruptedCanBeRepeatedOrFinished()
    {
        Interrupted whole(6);
        const int begin = whole.link.exchanges();
        VERIFY_RESULT(whole.compensator.undoUnfinished(whole.entry));
        const int exchanges = whole.link.exchanges() - begin;
        for (const bool finishes : {false, true}) {
            for (int exchange = 1; exchange <= exchanges; ++exchange) {
                Interrupted c(6);
                c.link.failAt(exchange, LinkFault::DriveGone);
                VERIFY_ERROR(c.compensator.undoUnfinished(c.entry), ErrorCode::NotConnected);
                c.link.heal();
                VERIFY_RESULT(finishes ? c.compensator.finishUnfinished(c.entry)
                                       : c.compensator.undoUnfinished(c.entry));
                QVERIFY(c.state() == (finishes ? c.wanted : c.old));
                QVERIFY(!c.isUnfinished());
            }
        }
    }

    /// Flash holds the new table already, under the old one, and has nothing to store again.
    void undoingInPlaceThatIsInterruptedCanBeFinished()
    {
        constexpr Scenario chosen{"overwrite in place", Persistency::Volatile,
            Persistency::Persistent, true, false, false};
        Begun whole(chosen);
        const int begin = whole.link.exchanges();
        VERIFY_RESULT(whole.write());
        const int exchanges = whole.link.exchanges() - begin;
        const CompensatorFixture::State wanted = whole.state();
        int interrupted = 0;
        for (int exchange = 1; exchange < 200; ++exchange) {
            Begun c(chosen);
            c.link.failAt(exchanges, LinkFault::DriveGone);
            VERIFY_ERROR(c.write(), ErrorCode::OutcomeUnknown);
            c.link.heal();
            c.link.failAt(exchange, LinkFault::DriveGone);
            const bool isUndone =
                c.compensator.undoUnfinished(*c.store.journal(4711, 0).value()).has_value();
            c.link.heal();
            if (isUndone)
                break;
            ++interrupted;
            const auto entry = c.store.journal(4711, 0).value();
            QVERIFY(entry.has_value());
            const auto finished = c.compensator.finishUnfinished(*entry);
            const QByteArray where = "exchange " + QByteArray::number(exchange);
            QVERIFY2(finished.has_value(),
                where + ": " + (finished ? "" : test::describe(finished.error()).c_str()));
            QVERIFY2(c.state() == wanted, where);
        }
        QVERIFY(interrupted > 10 && interrupted < 199);
    }

    /// Its registers are the same before and after: what the slot holds tells the states apart.
    void aTableInASlotThatWasEmptyIsNotTheOldState()
    {
        WriteRequest request = exampleRequest(2);
        request.slot = "Small1";
        Emptied whole;
        const int begin = whole.link.exchanges();
        VERIFY_RESULT(whole.compensator.write(0, request));
        const int exchanges = whole.link.exchanges() - begin;
        QCOMPARE(whole.state().registers, whole.old.registers);
        int refused = 0;
        for (int exchange = 1; exchange <= 40; ++exchange) {
            Emptied c;
            c.link.failAt(exchanges, LinkFault::DriveGoneAfter);
            VERIFY_ERROR(c.compensator.write(0, request), ErrorCode::OutcomeUnknown);
            c.link.heal();
            QVERIFY(!c.state().table.empty());
            const JournalEntry entry = *c.store.journal(4711, 0).value();
            c.link.failAt(exchange, LinkFault::ReplyGarbled);
            const auto undone = c.compensator.undoUnfinished(entry);
            const bool isStruck = c.link.hasFailed();
            c.link.heal();
            const QByteArray where = "exchange " + QByteArray::number(exchange);
            QVERIFY2(!undone || c.state() == c.old, where);
            QVERIFY2(undone.has_value() != c.store.journal(4711, 0).value().has_value(), where);
            refused += undone ? 0 : 1;
            if (!undone)
                VERIFY_RESULT(c.compensator.undoUnfinished(entry));
            QVERIFY2(c.state() == c.old, where);
            if (!isStruck)
                break;
        }
        QVERIFY(refused > 3);
    }

    /// The axis had no table: it would have one that another axis or a person has put there.
    void undoingDoesNotGiveTheAxisATableThatCameIntoItsEmptySlot()
    {
        Emptied c;
        const int begin = c.link.exchanges();
        WriteRequest request = exampleRequest(2);
        request.slot = "Small3";
        {
            Emptied whole;
            const int before = whole.link.exchanges();
            VERIFY_RESULT(whole.compensator.write(0, request));
            c.link.failAt(whole.link.exchanges() - before, LinkFault::DriveGoneAfter);
        }
        QCOMPARE(c.link.exchanges(), begin);
        VERIFY_ERROR(c.compensator.write(0, request), ErrorCode::OutcomeUnknown);
        c.link.heal();
        const auto theirs =
            encodeTamTable(exampleTable(2, 7), false, drivecomm::genericProfile().layout);
        VERIFY_RESULT(c.drive.upload("tables/small1.TAMtbl", *theirs));
        const JournalEntry entry = *c.store.journal(4711, 0).value();
        const auto undone = c.compensator.undoUnfinished(entry);
        VERIFY_RESULT(undone);
        QVERIFY(undone->now.setup.slot.empty());
        QVERIFY(c.state().table.empty());
        QCOMPARE(c.state().registers.at(1), c.old.registers.at(1));
        QVERIFY(c.drive.download("tables/small1.TAMtbl").value_or(Bytes{}) == *theirs);
        QVERIFY(!c.store.journal(4711, 0).value().has_value());
    }

    void aSlotThatAnotherAxisHasTakenStaysItsOwn()
    {
        for (const bool finishes : {true, false}) {
            Interrupted c;
            const TableSlot* slot = drivecomm::genericProfile().slotNamed(c.entry.newSlot);
            const auto theirs =
                encodeTamTable(exampleTable(1, 9), false, drivecomm::genericProfile().layout);
            VERIFY_RESULT(c.drive.upload(slot->file, *theirs));
            c.set("Axes[1]/Parameters/Compensations/Axis/Table", slot->name);
            VERIFY_RESULT(finishes ? c.compensator.finishUnfinished(c.entry)
                                   : c.compensator.undoUnfinished(c.entry));
            QCOMPARE(c.drive.download(slot->file).value_or(Bytes{}), *theirs);
            QCOMPARE(c.compensator.readTable(0)->values, exampleTable(2, finishes ? 2 : 1).values);
        }
    }

    /// After the deletion was interrupted somebody puts another table into the slot.
    void aTableThatCameIntoTheSlotIsNotDeleted()
    {
        Begun c(scenarios.back());
        c.link.forgetChange();
        const int begin = c.link.exchanges();
        Begun whole(scenarios.back());
        whole.link.forgetChange();
        VERIFY_RESULT(whole.write());
        c.link.failAt(whole.link.firstChange() - begin + 1, LinkFault::DriveGone);
        VERIFY_ERROR(c.write(), ErrorCode::RollbackFailed);
        c.link.heal();
        const auto entry = c.store.journal(4711, 0).value();
        QVERIFY(entry.has_value());
        const auto theirs =
            encodeTamTable(exampleTable(1, 9), false, drivecomm::genericProfile().layout);
        VERIFY_RESULT(c.drive.upload("tables/small1.TAMtbl", *theirs));
        const auto recovery = c.compensator.recovery(*entry);
        VERIFY_RESULT(recovery);
        QVERIFY(recovery->finishObstacle->code == ErrorCode::ChangedMeanwhile);
        VERIFY_ERROR(c.compensator.finishUnfinished(*entry), ErrorCode::ChangedMeanwhile);
        QCOMPARE(c.drive.download("tables/small1.TAMtbl").value_or(Bytes{}), *theirs);
    }

    void anUnknownTableInTheSlotStaysWhereItIs()
    {
        for (const bool finishes : {true, false}) {
            Interrupted c(6); // the new table has been uploaded
            const TableSlot* slot = drivecomm::genericProfile().slotNamed(c.entry.newSlot);
            const auto theirs =
                encodeTamTable(exampleTable(1, 9), false, drivecomm::genericProfile().layout);
            QVERIFY(c.drive.download(slot->file).has_value());
            VERIFY_RESULT(c.drive.upload(slot->file, *theirs));
            VERIFY_RESULT(finishes ? c.compensator.finishUnfinished(c.entry)
                                   : c.compensator.undoUnfinished(c.entry));
            QCOMPARE(c.drive.download(slot->file).value_or(Bytes{}), *theirs);
            QCOMPARE(c.compensator.readTable(0)->values, exampleTable(2, finishes ? 2 : 1).values);
            QCOMPARE(c.state().registers[0] == slot->name, false);
        }
    }

    /// Its registers alone are not the new state, nor the old one's the old.
    void anotherTableInTheSlotIsNeitherState()
    {
        using Outcome = AxisCompensator::UnfinishedOutcome;
        const auto& layout = drivecomm::genericProfile().layout;
        const auto theirs = encodeTamTable(exampleTable(2, 9), true, layout);
        Interrupted c(6);
        const TableSlot* slot = drivecomm::genericProfile().slotNamed(c.entry.newSlot);
        const TableSlot* oldSlot = drivecomm::genericProfile().slotNamed(c.old.registers[0]);
        VERIFY_RESULT(c.drive.upload(oldSlot->file, *theirs));
        QCOMPARE(c.compensator.settleUnfinished(c.entry).value(), Outcome::Neither);
        QVERIFY(c.isUnfinished());
        VERIFY_RESULT(c.drive.upload(oldSlot->file, c.old.table));
        QCOMPARE(c.compensator.settleUnfinished(c.entry).value(), Outcome::Old);

        VERIFY_RESULT(c.drive.upload(slot->file, *theirs));
        VERIFY_RESULT(c.drive.writeRegisters(c.entry.newRegisters));
        QCOMPARE(c.compensator.settleUnfinished(c.entry).value(), Outcome::Neither);
        VERIFY_RESULT(c.drive.upload(slot->file, c.wanted.table));
        QCOMPARE(c.compensator.settleUnfinished(c.entry).value(), Outcome::NewUnsaved);
        QVERIFY(c.isUnfinished());
    }

    /// Somebody on the way has kept it.
    void anOldFileThatTheDriveDoesNotShowIsNotTheOldState()
    {
        using Outcome = AxisCompensator::UnfinishedOutcome;
        Interrupted c(6);
        const TableSlot* oldSlot = drivecomm::genericProfile().slotNamed(c.old.registers[0]);
        CompensationTable moved = exampleTable(2, 1);
        moved.grid.axes.front().start += 50.0;
        c.link.altersDownload = [&](Bytes& bytes) { bytes = c.old.table; };
        for (const CompensationTable& theirs : {exampleTable(2, 9), moved}) {
            VERIFY_RESULT(c.drive.upload(
                oldSlot->file, *encodeTamTable(theirs, true, drivecomm::genericProfile().layout)));
            QCOMPARE(c.compensator.settleUnfinished(c.entry).value(), Outcome::Neither);
        }
        QVERIFY(c.isUnfinished());
        VERIFY_RESULT(c.drive.upload(oldSlot->file, c.old.table));
        QCOMPARE(c.compensator.settleUnfinished(c.entry).value(), Outcome::Old);
    }

    /// Its CRC is that of the old one, and so are slot and sources: only the file tells them apart.
    void aTableOfTheSameValuesOnAnotherGridIsNotTheNewState()
    {
        using Outcome = AxisCompensator::UnfinishedOutcome;
        WriteRequest request = exampleRequest(1);
        request.slot = "Small1";
        WriteRequest moved = request;
        moved.table->grid.axes.front().start += 50.0;
        CompensatorFixture whole;
        VERIFY_RESULT(whole.compensator.write(0, request));
        const CompensatorFixture::State old = whole.state();
        const int begin = whole.link.exchanges();
        VERIFY_RESULT(whole.compensator.write(0, moved));
        const CompensatorFixture::State wanted = whole.state();
        QVERIFY(wanted.table != old.table && wanted.registers == old.registers);
        int notBegun = 0;
        int complete = 0;
        for (int exchange = 1; exchange <= whole.link.exchanges() - begin; ++exchange) {
            CompensatorFixture c;
            VERIFY_RESULT(c.compensator.write(0, request));
            c.link.failAt(exchange, LinkFault::ProgramDies);
            QVERIFY_THROWS_EXCEPTION(test::ProgramDied, (void)c.compensator.write(0, moved));
            c.link.heal();
            const auto entry = c.store.journal(4711, 0).value();
            if (!entry)
                continue;
            const QByteArray where = "exchange " + QByteArray::number(exchange);
            const auto outcome = c.compensator.settleUnfinished(*entry);
            VERIFY_RESULT(outcome);
            QVERIFY2((*outcome == Outcome::New) == (c.state() == wanted), where);
            QVERIFY2((*outcome == Outcome::Old) == (c.state() == old), where);
            complete += *outcome == Outcome::New ? 1 : 0;
            if (*outcome != Outcome::Old || !entry->newTable)
                continue;
            ++notBegun;
            Bytes damaged = wanted.table;
            damaged.back() ^= std::byte{1};
            VERIFY_RESULT(saveFile(entry->newTable->file, damaged));
            QVERIFY2(c.compensator.settleUnfinished(*entry).value() == Outcome::Old, where);
        }
        QVERIFY(notBegun > 0 && complete > 0);
    }

    void withoutTheBackupOfTheOldStateOnlyTheNewOneIsTold_data()
    {
        QTest::addColumn<QByteArray>("left");
        QTest::newRow("missing") << QByteArray();
        QTest::newRow("half") << QByteArray("{\"format\": \"axiscomp-b");
        QTest::newRow("of the other axis") << QByteArray("other");
    }
    /// The axis can be looked at, switched off and written, which is the way out.
    void withoutTheBackupOfTheOldStateOnlyTheNewOneIsTold()
    {
        using Outcome = AxisCompensator::UnfinishedOutcome;
        QFETCH(const QByteArray, left);
        Interrupted c(6);
        const std::filesystem::path backup = c.entry.backup;
        QVERIFY(std::filesystem::remove(backup));
        if (left == "other") {
            CompensatorFixture twin;
            VERIFY_RESULT(twin.compensator.write(1, exampleRequest(1)));
            const auto other = loadFile(twin.store.backups(4711, 1).front(), maximumBackupSize);
            VERIFY_RESULT(saveFile(backup, *other));
        } else if (!left.isEmpty()) {
            VERIFY_RESULT(saveFile(backup, asBytes(left.toStdString())));
        }
        const auto now = settledStatus(c.compensator, c.storeRoot(), 0, {});
        VERIFY_RESULT(now);
        QVERIFY(now->settled && now->settled->outcome == Outcome::Unknown);
        QVERIFY(now->settled->recovery.finishObstacle && now->settled->recovery.undoObstacle);
        for (const auto& refused : {checkMayActivate(*now), checkIsWhole(*now)}) {
            VERIFY_ERROR(refused, ErrorCode::VerifyMismatch);
            QVERIFY(sentence(refused.error()).find("is not known") != std::string::npos);
        }
        for (const Recover way : ways)
            QVERIFY(!(c.compensator.*way)(c.entry, {}).has_value());
        VERIFY_RESULT(c.compensator.deactivate(0));
        QVERIFY(c.isUnfinished());
        WriteRequest again = exampleRequest(2, Persistency::Persistent);
        again.slot = c.entry.newSlot;
        VERIFY_RESULT(c.compensator.write(0, again));
        QVERIFY(c.state() == c.wanted);
        QVERIFY(!c.isUnfinished());
    }

    /// It can be activated, and is neither finished nor undone: that would need the backup.
    void aNewStateWithoutTheBackupOfTheOldOneIsSavedByWritingItAgain()
    {
        using Outcome = AxisCompensator::UnfinishedOutcome;
        Interrupted c(6);
        const TableSlot* slot = drivecomm::genericProfile().slotNamed(c.entry.newSlot);
        VERIFY_RESULT(c.drive.upload(slot->file, c.wanted.table));
        VERIFY_RESULT(c.drive.writeRegisters(c.entry.newRegisters));
        const auto whole = settledStatus(c.compensator, c.storeRoot(), 0, {});
        VERIFY_RESULT(whole);
        QVERIFY(whole->settled && !whole->settled->recovery.isBackupUnread);
        QVERIFY(std::filesystem::remove(c.entry.backup));
        const auto now = settledStatus(c.compensator, c.storeRoot(), 0, {});
        VERIFY_RESULT(now);
        QVERIFY(now->settled && now->settled->outcome == Outcome::NewUnsaved);
        QVERIFY(now->settled->recovery.isBackupUnread);
        VERIFY_RESULT(checkMayActivate(*now));
        for (const Recover way : ways)
            QVERIFY(!(c.compensator.*way)(c.entry, {}).has_value());
        WriteRequest again = exampleRequest(2, Persistency::Persistent);
        again.slot = c.entry.newSlot;
        VERIFY_RESULT(c.compensator.write(0, again));
        QVERIFY(!c.isUnfinished());
        c.drive.reboot();
        QVERIFY(c.state() == c.wanted);
    }

    /// The axis uses no table then, as in the new state, and what a slot holds says no more.
    void halfOfADeletionWithoutTheBackupOfTheOldStateIsNotKnown()
    {
        using Outcome = AxisCompensator::UnfinishedOutcome;
        Begun c(scenarios.back());
        c.link.beginning = [&c](std::string_view what) {
            if (what == "write")
                c.link.failAt(0, LinkFault::DriveGoneAfter);
        };
        VERIFY_ERROR(c.write(), ErrorCode::RollbackFailed);
        c.link.beginning = {};
        c.link.heal();
        const JournalEntry entry = *c.store.journal(4711, 0).value();
        QCOMPARE(c.compensator.settleUnfinished(entry).value(), Outcome::Neither);
        QVERIFY(std::filesystem::remove(entry.backup));
        QCOMPARE(c.compensator.settleUnfinished(entry).value(), Outcome::Unknown);
    }

    void halfOfAWriteIsNotActivated()
    {
        Interrupted c;
        const auto root = std::filesystem::path(c.folder.path().toStdString()) / "axiscomp";
        const auto before = settledStatus(c.compensator, root, 0, {});
        VERIFY_RESULT(before);
        VERIFY_RESULT(checkMayActivate(*before)); // the complete old state
        const TableSlot* slot = drivecomm::genericProfile().slotNamed(c.old.registers[0]);
        VERIFY_RESULT(c.drive.upload(slot->file,
            *encodeTamTable(exampleTable(2, 9), true, drivecomm::genericProfile().layout)));
        const auto half = settledStatus(c.compensator, root, 0, {});
        VERIFY_RESULT(half);
        const auto refused = checkMayActivate(*half);
        VERIFY_ERROR(refused, ErrorCode::VerifyMismatch);
        QVERIFY(sentence(refused.error()).find("axiscomp recover --undo") != std::string::npos);
        QVERIFY(sentence(refused.error()).find('{') == std::string::npos);
    }

    void halfOfAWriteIsNotKeptAsTheStateOfAnAxis()
    {
        Interrupted c;
        const auto old = backUpDrive(c.compensator, c.storeRoot(), {});
        VERIFY_RESULT(old); // the complete old state
        QVERIFY(old->doubts.empty());
        VERIFY_RESULT(driveParameters(c.compensator, c.storeRoot()));
        VERIFY_RESULT(snapshotOf(c));
        const TableSlot* slot = drivecomm::genericProfile().slotNamed(c.old.registers[0]);
        VERIFY_RESULT(c.drive.upload(slot->file,
            *encodeTamTable(exampleTable(2, 9), true, drivecomm::genericProfile().layout)));
        VERIFY_ERROR(driveParameters(c.compensator, c.storeRoot()), ErrorCode::VerifyMismatch);
        const auto refused = snapshotOf(c);
        VERIFY_ERROR(refused, ErrorCode::VerifyMismatch);
        const std::string said = sentence(refused.error());
        QVERIFY(said.find("axis 0 in neither") != std::string::npos);
        QVERIFY(said.find("axiscomp recover --undo") != std::string::npos);
        QVERIFY(said.find('{') == std::string::npos);
        // What is left can be rescued all the same.
        const auto rescue = backUpDrive(c.compensator, c.storeRoot(), {});
        VERIFY_RESULT(rescue);
        QCOMPARE(rescue->doubts.size(), std::size_t{1});
        QVERIFY(rescue->doubts.front().code == ErrorCode::VerifyMismatch);
        QVERIFY(rescue->backup.axes.front().files.front().bytes
            == c.drive.download(slot->file).value_or(Bytes{}));
    }

    void whatAnotherProgramIsWritingIsNotKeptAsTheStateOfAnAxis()
    {
        Interrupted c;
        const auto lock = c.store.lockWrites(4711);
        VERIFY_RESULT(lock);
        VERIFY_ERROR(driveParameters(c.compensator, c.storeRoot()), ErrorCode::ChangedMeanwhile);
        VERIFY_ERROR(snapshotOf(c), ErrorCode::ChangedMeanwhile);
        const auto rescue = backUpDrive(c.compensator, c.storeRoot(), {});
        VERIFY_RESULT(rescue);
        QCOMPARE(rescue->doubts.size(), std::size_t{1});
        QVERIFY(rescue->doubts.front().code == ErrorCode::ChangedMeanwhile);
    }

    void aFailedWriteOverAnUnfinishedOneForgetsNothing()
    {
        Interrupted c;
        c.drive.storeNextWrong();
        VERIFY_ERROR(c.compensator.write(0, exampleRequest(5)), ErrorCode::VerifyMismatch);
        QVERIFY(c.isUnfinished());
        QVERIFY(*c.store.journal(4711, 0).value() == c.entry);
        VERIFY_RESULT(c.compensator.finishUnfinished(c.entry));
        QVERIFY(c.state() == c.wanted);
    }

private:
    static std::string unitOf(int axis)
    {
        return "Axes[" + std::to_string(axis) + "]/Parameters/PositionController/PositionUnit";
    }
    static Result<DriveSnapshot> snapshotOf(CompensatorFixture& c)
    {
        return snapshotDrive(
            c.compensator, drivecomm::genericProfile(), c.storeRoot(), "demo:", {});
    }
    static QStringList keptTables(const Begun& c)
    {
        const QDir folder(c.folder.path() + QStringLiteral("/axiscomp/4711"));
        return folder.entryList({QStringLiteral("*.TAMtbl")});
    }
};

AXISCOMP_TEST(TestRecovery)

} // namespace tst_recovery

#include "tst_recovery.moc"
