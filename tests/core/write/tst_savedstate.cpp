// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a reboot brings back: the parameters that were saved last, with the tables that are in
// flash. The two must belong together whichever axis was written last, and how.
#include "core/io/local_file.h"
#include "tests/support/compensator_fixture.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <algorithm>
#include <functional>

namespace tst_savedstate {

using namespace axiscomp;
using namespace axiscomp::test;

namespace {

/// Other sources than exampleRequest's.
WriteRequest swapped(int seed, Persistency persistency)
{
    WriteRequest request = exampleRequest(seed, persistency);
    std::swap(request.sources[0], request.sources[1]);
    return request;
}

WriteRequest detaching()
{
    WriteRequest none;
    none.withoutTable = true;
    none.sources = {"", "", ""};
    none.dimensionality = 3;
    return none;
}

WriteRequest into(WriteRequest request, const char* slot)
{
    request.slot = slot;
    return request;
}

/// Runs act with the drive gone after each of its exchanges in turn, and off and on again: what an
/// axis has then must satisfy isRight.
void interruptEverywhere(const std::function<void(CompensatorFixture&)>& prepare,
    const std::function<void(CompensatorFixture&)>& act,
    const std::function<bool(const CompensatorFixture::State&)>& isRight)
{
    CompensatorFixture whole;
    prepare(whole);
    const int begin = whole.link.exchanges();
    act(whole);
    const int exchanges = whole.link.exchanges() - begin;
    QVERIFY(exchanges > 10);
    for (int exchange = 1; exchange <= exchanges; ++exchange) {
        CompensatorFixture f;
        prepare(f);
        f.link.failAt(exchange, LinkFault::DriveGoneAfter);
        act(f);
        f.drive.reboot();
        const CompensatorFixture::State now = f.state();
        QVERIFY2(isRight(now),
            qPrintable(QStringLiteral("exchange %1 of %2: %3")
                           .arg(exchange)
                           .arg(exchanges)
                           .arg(QString::fromStdString(now.registers[0]))));
    }
}

/// What a reboot leaves of what prepare does.
CompensatorFixture::State rebooted(const std::function<void(CompensatorFixture&)>& prepare)
{
    CompensatorFixture f;
    prepare(f);
    f.drive.reboot();
    return f.state();
}

bool contains(const std::vector<Text>& texts, const std::string& part)
{
    return std::ranges::any_of(
        texts, [&](const Text& text) { return text.english().find(part) != std::string::npos; });
}

} // namespace

class TestSavedState : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void savingAnAxisBringsNoEarlierTableBackToAnother()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(1, exampleRequest(1, Persistency::Persistent)));
        const CompensatorFixture::State saved = f.state(1);
        VERIFY_RESULT(f.compensator.write(1, exampleRequest(2, Persistency::Volatile)));
        VERIFY_RESULT(f.compensator.write(1, swapped(3, Persistency::Volatile)));
        VERIFY_RESULT(f.compensator.write(0, exampleRequest(4, Persistency::Persistent)));
        f.drive.reboot();
        // Its table was volatile, so that there is none now; above all not the first.
        const CompensatorFixture::State now = f.state(1);
        QVERIFY(now.table.empty());
        QVERIFY(now.registers != saved.registers);
    }

    void aPersistentWriteLeavesTheSavedTableUntilItIsSavedItself()
    {
        const auto prepare = [](CompensatorFixture& f) {
            VERIFY_RESULT(f.compensator.write(0, exampleRequest(1, Persistency::Persistent)));
            VERIFY_RESULT(f.compensator.write(0, exampleRequest(2, Persistency::Volatile)));
        };
        CompensatorFixture whole;
        prepare(whole);
        const int begin = whole.link.exchanges();
        VERIFY_RESULT(whole.compensator.write(0, swapped(3, Persistency::Persistent)));
        const int exchanges = whole.link.exchanges() - begin;
        QVERIFY(exchanges > 10);
        whole.drive.reboot();
        const CompensatorFixture::State wanted = whole.state();

        for (int exchange = 1; exchange <= exchanges; ++exchange) {
            CompensatorFixture f;
            prepare(f);
            f.link.failAt(exchange, LinkFault::DriveGoneAfter);
            (void)f.compensator.write(0, swapped(3, Persistency::Persistent));
            f.drive.reboot();
            CompensatorFixture old;
            prepare(old);
            old.drive.reboot();
            const CompensatorFixture::State now = f.state();
            QVERIFY2(now == old.state() || now == wanted,
                qPrintable(QStringLiteral("exchange %1 of %2").arg(exchange).arg(exchanges)));
        }
    }

    void savingDeletesWhatAVolatileTableCoversInFlash()
    {
        CompensatorFixture f;
        VERIFY_RESULT(
            f.compensator.write(1, into(exampleRequest(1, Persistency::Persistent), "Small3")));
        VERIFY_RESULT(f.compensator.write(1, into(swapped(2, Persistency::Volatile), "Small3")));
        const auto plan = f.compensator.plan(0, exampleRequest(4, Persistency::Persistent));
        VERIFY_RESULT(plan);
        QCOMPARE(plan->flashOperations, 2);
        QVERIFY(contains(plan->warnings, "after a reboot that axis has no table"));
        QVERIFY(contains(plan->warnings, "it is deleted before the parameters are saved"));
        const auto counted = [&f] { return f.compensator.flashUse()->allCycles; };
        const std::uint64_t before = counted();
        VERIFY_RESULT(f.compensator.write(0, exampleRequest(4, Persistency::Persistent)));
        QCOMPARE(counted(), before + 2);
        QCOMPARE(f.store.flashHistory(4711)->total, std::uint64_t{3});
        f.drive.reboot();
        QCOMPARE(f.state(1).registers[0], std::string("Small3"));
        QVERIFY(f.state(1).table.empty());
        VERIFY_RESULT(f.compensator.write(0, exampleRequest(5, Persistency::Persistent)));
    }

    /// As when a whole drive is restored, and this axis is as the backup has it.
    void nothingIsSaidToBeSavedWhereNothingIsWritten()
    {
        CompensatorFixture f;
        const WriteRequest request = exampleRequest(1, Persistency::Persistent);
        VERIFY_RESULT(f.compensator.write(0, request));
        VERIFY_RESULT(
            f.compensator.write(1, into(exampleRequest(2, Persistency::Persistent), "Small3")));
        VERIFY_RESULT(f.compensator.write(1, into(swapped(3, Persistency::Volatile), "Small3")));
        const auto loses = [](const WritePlan& plan) {
            return contains(plan.warnings, "after a reboot that axis has no table");
        };
        const auto same = f.compensator.plan(0, request);
        VERIFY_RESULT(same);
        QVERIFY(same->changes.empty());
        QVERIFY(!loses(*same));
        QCOMPARE(same->flashOperations, 0);
        // Saved once more, since that may not have been seen to its end.
        WriteRequest saving;
        saving.dimensionality = request.dimensionality;
        saving.persistency = Persistency::Persistent;
        const auto saved = f.compensator.plan(0, saving);
        VERIFY_RESULT(saved);
        QVERIFY(saved->changes.empty());
        QVERIFY(loses(*saved));
        QCOMPARE(saved->flashOperations, 1);
    }

    void aVolatileTableThatCoversAnotherIsAnnounced()
    {
        CompensatorFixture f;
        VERIFY_RESULT(
            f.compensator.write(0, into(exampleRequest(1, Persistency::Persistent), "Small1")));
        VERIFY_RESULT(
            f.compensator.write(0, into(exampleRequest(2, Persistency::Persistent), "Small2")));
        const auto plan = f.compensator.plan(0, into(swapped(3, Persistency::Volatile), "Small1"));
        VERIFY_RESULT(plan);
        QVERIFY(contains(plan->warnings, "covers an older one that flash holds in Small1"));
    }

    void makingACoveringTablePersistentBringsNoMixture()
    {
        const auto prepare = [](CompensatorFixture& f) {
            VERIFY_RESULT(
                f.compensator.write(0, into(exampleRequest(1, Persistency::Persistent), "Small1")));
            VERIFY_RESULT(
                f.compensator.write(0, into(swapped(2, Persistency::Volatile), "Small1")));
        };
        const auto act = [](CompensatorFixture& f) {
            (void)f.compensator.setPersistency(0, Persistency::Persistent);
        };
        const CompensatorFixture::State old = rebooted(prepare);
        const CompensatorFixture::State wanted = rebooted([&](CompensatorFixture& f) {
            prepare(f);
            act(f);
        });
        QVERIFY(!wanted.table.empty() && wanted.registers != old.registers);
        interruptEverywhere(prepare, act, [&](const CompensatorFixture::State& now) {
            return now == old || now == wanted || now.table.empty();
        });
    }

    void aPersistentTableForTheSlotThatIsSavedBringsNoMixture()
    {
        const auto prepare = [](CompensatorFixture& f) {
            VERIFY_RESULT(
                f.compensator.write(0, into(exampleRequest(1, Persistency::Persistent), "Small1")));
            VERIFY_RESULT(
                f.compensator.write(0, into(exampleRequest(2, Persistency::Volatile), "Small2")));
        };
        const WriteRequest request = into(swapped(3, Persistency::Persistent), "Small1");
        const auto act = [&](CompensatorFixture& f) { (void)f.compensator.write(0, request); };
        CompensatorFixture planned;
        prepare(planned);
        const auto plan = planned.compensator.plan(0, request);
        VERIFY_RESULT(plan);
        QVERIFY(contains(plan->warnings, "the axis may have no table after a reboot"));
        const CompensatorFixture::State old = rebooted(prepare);
        const CompensatorFixture::State wanted = rebooted([&](CompensatorFixture& f) {
            prepare(f);
            act(f);
        });
        QVERIFY(!wanted.table.empty() && wanted.registers != old.registers);
        interruptEverywhere(prepare, act, [&](const CompensatorFixture::State& now) {
            return now == old || now == wanted || now.table.empty();
        });
    }

    void aSlotThatAnotherAxisNamesAfterARebootIsNotTaken()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(1, into(exampleRequest(1), "Small1")));
        VERIFY_RESULT(
            f.compensator.write(0, into(exampleRequest(2, Persistency::Persistent), "Small2")));
        f.drive.reboot(); // axis 1 names an empty slot now
        VERIFY_RESULT(f.compensator.write(1, into(swapped(3, Persistency::Volatile), "Small3")));
        const auto named = f.compensator.write(0, into(exampleRequest(4), "Small1"));
        VERIFY_ERROR(named, ErrorCode::SlotInUse);
        QCOMPARE(named.error().context.english("user"), std::string("axis 1 after a reboot"));
        const auto chosen = f.compensator.write(0, exampleRequest(4));
        VERIFY_RESULT(chosen);
        QVERIFY(chosen->now.setup.slot != "Small1");
        // Saved once more, the parameters do not name it any more.
        VERIFY_RESULT(f.compensator.write(0, exampleRequest(5, Persistency::Persistent)));
        VERIFY_RESULT(f.compensator.write(0, into(exampleRequest(4), "Small1")));
    }

    void aTableThatAnotherAxisUsesStaysInFlash()
    {
        CompensatorFixture f;
        const std::string tableOfY = "Axes[1]/Parameters/Compensations/Axis/Table";
        VERIFY_RESULT(
            f.compensator.write(0, into(exampleRequest(1, Persistency::Persistent), "Small1")));
        f.set(tableOfY, std::string("Small1"));
        f.link.forgetChange();
        const auto used = f.compensator.setPersistency(0, Persistency::Volatile);
        VERIFY_ERROR(used, ErrorCode::SlotInUse);
        QCOMPARE(sentence(used.error()),
            std::string("the table in Small1 stays in flash, because axis 1 uses it too; free it "
                        "there first, with a persistent write into another slot"));
        QCOMPARE(f.link.firstChange(), 0);
        // Saved with the table, the name is there again after a reboot.
        VERIFY_RESULT(f.compensator.write(0, swapped(1, Persistency::Persistent)));
        VERIFY_RESULT(f.compensator.write(1, exampleRequest(2)));
        const auto saved = f.compensator.setPersistency(0, Persistency::Volatile);
        VERIFY_ERROR(saved, ErrorCode::SlotInUse);
        QCOMPARE(saved.error().context.english("user"), std::string("axis 1 after a reboot"));
        VERIFY_RESULT(f.compensator.write(1, exampleRequest(3, Persistency::Persistent)));
        VERIFY_RESULT(f.compensator.setPersistency(0, Persistency::Volatile));
        QCOMPARE(f.state().persistent, std::string("false"));
    }

    void aTableThatAnotherAxisComesToUseStaysInFlash()
    {
        const WriteRequest request = into(exampleRequest(1, Persistency::Persistent), "Small1");
        CompensatorFixture whole;
        VERIFY_RESULT(whole.compensator.write(0, request));
        const int begin = whole.link.exchanges();
        VERIFY_RESULT(whole.compensator.setPersistency(0, Persistency::Volatile));
        int noticed = 0;
        for (int exchange = 1; exchange <= whole.link.exchanges() - begin; ++exchange) {
            CompensatorFixture f;
            VERIFY_RESULT(f.compensator.write(0, request));
            f.link.forgetChange();
            f.link.actBefore(exchange, [&f] {
                f.set("Axes[1]/Parameters/Compensations/Axis/Table", std::string("Small1"));
            });
            const auto removed = f.compensator.setPersistency(0, Persistency::Volatile);
            if (removed || removed.error().code == ErrorCode::SlotInUse)
                continue;
            VERIFY_ERROR(removed, ErrorCode::ChangedMeanwhile);
            QCOMPARE(f.link.firstChange(), 0);
            ++noticed;
        }
        QVERIFY(noticed > 2);
    }

    void whatARebootBringsBackIsSaidOfATableThatIsOnlyDetached()
    {
        const WriteRequest none = detaching();
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, into(exampleRequest(1), "Small1")));
        QVERIFY(f.compensator.plan(0, none)->warnings.empty()); // a reboot takes it away
        VERIFY_RESULT(f.compensator.setPersistency(0, Persistency::Persistent));
        const CompensatorFixture::State old = f.state();
        const auto plan = f.compensator.plan(0, none);
        VERIFY_RESULT(plan);
        QCOMPARE(plan->warnings.size(), std::size_t{1});
        QCOMPARE(plan->warnings.front().english(),
            std::string("Flash keeps the table in Small1: after a reboot axis 0 (X) uses it again. "
                        "Delete the table first ('axiscomp delete') if it must not come back."));
        VERIFY_RESULT(f.compensator.write(0, none));
        f.drive.reboot();
        QVERIFY(f.state() == old);

        VERIFY_RESULT(f.compensator.write(0, into(exampleRequest(2), "Small2")));
        QVERIFY(contains(f.compensator.plan(0, none)->warnings,
            "After a reboot axis 0 (X) uses the table in Small1 again, as its saved parameters"));
        f.drive.reboot();
        QVERIFY(f.state() == old);
        VERIFY_RESULT(f.compensator.write(0, deletionRequest()));
        QVERIFY(f.compensator.plan(0, none)->warnings.empty());
        f.drive.reboot();
        QVERIFY(f.state().table.empty());
        QCOMPARE(f.state().registers[0], std::string("Disabled"));
    }

    void aDetachedTableThatARebootBringsBackIsSaidAgainAndCanBeDeleted()
    {
        const WriteRequest none = detaching();
        CompensatorFixture f;
        VERIFY_RESULT(
            f.compensator.write(0, into(exampleRequest(1, Persistency::Persistent), "Small1")));
        VERIFY_RESULT(f.compensator.write(0, none));
        const Bytes table = f.drive.download("tables/small1.TAMtbl").value_or(Bytes{});
        const auto again = f.compensator.plan(0, none);
        VERIFY_RESULT(again);
        QVERIFY(again->changes.empty());
        QCOMPARE(again->warnings.size(), std::size_t{1});
        QVERIFY(contains(again->warnings, "Flash keeps the table in Small1: after a reboot"));

        const auto plan = f.compensator.plan(0, deletionRequest());
        VERIFY_RESULT(plan);
        QCOMPARE(plan->deletedSlot, std::string("Small1"));
        QCOMPARE(plan->flashOperations, 1);
        const auto report = f.compensator.write(0, deletionRequest());
        VERIFY_RESULT(report);
        QVERIFY(f.compensator.plan(0, none)->warnings.empty());
        VERIFY_ERROR(f.compensator.write(0, deletionRequest()), ErrorCode::NoTable);
        f.drive.reboot();
        QCOMPARE(f.state().registers[0], std::string("Disabled"));
        QVERIFY(f.drive.download("tables/small1.TAMtbl").value_or(Bytes{}).empty());

        const auto text = loadOrdinaryFile(report->backup, maximumBackupSize);
        VERIFY_RESULT(text);
        const auto backup = readBackup(asText(*text), report->backup.string());
        VERIFY_RESULT(backup);
        VERIFY_RESULT(f.compensator.restore(*backup, false));
        QVERIFY(f.drive.download("tables/small1.TAMtbl").value_or(Bytes{}) == table);
    }

    /// The saved parameters name its slot, which is empty after a reboot.
    void aDetachedTableThatARebootTakesAwayIsNotSaid()
    {
        const WriteRequest none = detaching();
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, into(exampleRequest(1), "Small1")));
        VERIFY_RESULT(
            f.compensator.write(1, into(exampleRequest(2, Persistency::Persistent), "Small2")));
        VERIFY_RESULT(f.compensator.write(0, none));
        QVERIFY(f.compensator.plan(0, none)->warnings.empty());
        VERIFY_ERROR(f.compensator.plan(0, deletionRequest()), ErrorCode::NoTable);
    }

    void aSavingThatDidNotEndForgetsNoSlot()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(1, into(exampleRequest(1), "Small1")));
        VERIFY_RESULT(
            f.compensator.write(0, into(exampleRequest(2, Persistency::Persistent), "Small2")));
        VERIFY_RESULT(f.compensator.write(1, into(exampleRequest(3), "Small3")));
        const WriteRequest request = into(exampleRequest(4, Persistency::Persistent), "Small4");
        CompensatorFixture counting;
        const int begin = counting.link.exchanges();
        VERIFY_RESULT(counting.compensator.write(0, request));
        for (int exchange = 1; exchange <= counting.link.exchanges() - begin; ++exchange) {
            f.link.failAt(exchange, LinkFault::ProgramDies);
            try {
                (void)f.compensator.write(0, request);
            } catch (const ProgramDied&) {
            }
            f.link.heal();
            const auto saved = f.store.savedState(4711);
            VERIFY_RESULT(saved);
            QVERIFY(saved->otherUser("Small1", 0) || saved->otherUser("Small3", 0));
        }
    }

    void restoringLeavesASlotThatAnAxisNamesAfterAReboot()
    {
        CompensatorFixture f;
        VERIFY_RESULT(
            f.compensator.write(0, into(exampleRequest(1, Persistency::Persistent), "Small1")));
        VERIFY_RESULT(
            f.compensator.write(0, into(exampleRequest(2, Persistency::Persistent), "Small2")));
        const auto backup = f.compensator.backup(); // Small1 is nobody's
        VERIFY_RESULT(backup);
        VERIFY_RESULT(f.compensator.write(0, into(swapped(3, Persistency::Persistent), "Small1")));
        VERIFY_RESULT(
            f.compensator.write(0, into(exampleRequest(2, Persistency::Volatile), "Small3")));
        DriveBackup files = *backup;
        files.axes.clear();
        const auto restored = f.compensator.restore(files, false);
        VERIFY_ERROR(restored, ErrorCode::SlotInUse);
        QCOMPARE(restored.error().context.english("user"), std::string("axis 0 after a reboot"));
        f.drive.reboot();
        const CompensatorFixture::State now = f.state();
        CompensatorFixture saved;
        VERIFY_RESULT(
            saved.compensator.write(0, into(swapped(3, Persistency::Persistent), "Small1")));
        QVERIFY(now == saved.state());
    }

    /// The free slot to which a table goes back may be the one of a file that no axis used.
    void aFileWhoseSlotAnAxisNeedsIsLeftOutAndSaid()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, into(exampleRequest(1), "Small1")));
        VERIFY_RESULT(f.compensator.write(0, into(exampleRequest(2), "Small2")));
        const auto backup = f.compensator.backup(); // Small1 is nobody's
        VERIFY_RESULT(backup);
        QCOMPARE(backup->otherFiles.size(), std::size_t{1});
        const auto then = f.compensator.status(0);
        VERIFY_RESULT(then);
        VERIFY_RESULT(f.compensator.write(0, into(exampleRequest(3), "Small1")));
        VERIFY_RESULT(f.compensator.write(0, into(exampleRequest(4), "Small2")));
        for (const bool isThere : {false, true}) {
            const auto plans = f.compensator.planRestore(*backup, false);
            VERIFY_RESULT(plans);
            QCOMPARE(plans->axes.front().after.slot, std::string("Small1"));
            QCOMPARE(plans->axes.front().changes.empty(), isThere);
            QVERIFY(std::ranges::any_of(plans->axes.front().warnings, [](const Text& warning) {
                return warning.english().find("in Small1 is not restored") != std::string::npos;
            }));
            VERIFY_RESULT(f.compensator.restore(*backup, false));
            const auto now = f.compensator.status(0);
            VERIFY_RESULT(now);
            QCOMPARE(now->setup.tableCrc, then->setup.tableCrc);
        }
    }

    void aRestoreThatTheDriveForgotInBetweenIsNotDone()
    {
        const auto prepare = [](CompensatorFixture& f) {
            VERIFY_RESULT(f.compensator.write(0, exampleRequest(1)));
            VERIFY_RESULT(f.compensator.write(1, exampleRequest(2)));
        };
        CompensatorFixture source;
        prepare(source);
        const auto backup = source.compensator.backup();
        VERIFY_RESULT(backup);
        const int begin = source.link.exchanges();
        VERIFY_RESULT(source.compensator.write(0, exampleRequest(3)));
        VERIFY_RESULT(source.compensator.restore(*backup, false));
        const int exchanges = source.link.exchanges() - begin;
        int notDone = 0;
        for (int exchange = 1; exchange <= exchanges; ++exchange) {
            CompensatorFixture f;
            f.link.actBefore(exchange, [&f] { f.drive.reboot(); });
            const auto restored = f.compensator.restore(*backup, false);
            notDone += restored ? 0 : 1;
            for (int axis = 0; restored && axis < 2; ++axis)
                QVERIFY2(f.state(axis).table == source.state(axis).table,
                    qPrintable(QStringLiteral("exchange %1, axis %2").arg(exchange).arg(axis)));
        }
        QVERIFY(notDone > 10);
    }

    void aFlashOperationIsRecordedAlsoWhenTheDriveIsGoneAfterIt()
    {
        const auto counted = [](CompensatorFixture& f) {
            std::uint64_t cycles = 0;
            for (const TableSlot& slot : drivecomm::genericProfile().tableSlots)
                cycles += std::stoul(f.text("Application/Tables/" + slot.name + "/EraseCount"));
            return cycles;
        };
        const WriteRequest request = exampleRequest(1, Persistency::Persistent);
        CompensatorFixture whole;
        VERIFY_RESULT(whole.compensator.write(0, request));
        QCOMPARE(whole.store.flashHistory(4711)->total, std::uint64_t{1});
        for (int exchange = 1; exchange <= whole.link.exchanges(); ++exchange) {
            for (const LinkFault fault : {LinkFault::DriveGone, LinkFault::DriveGoneAfter}) {
                CompensatorFixture f;
                f.link.failAt(exchange, fault);
                (void)f.compensator.write(0, request);
                QVERIFY2(f.store.flashHistory(4711)->total >= counted(f),
                    qPrintable(QStringLiteral("exchange %1").arg(exchange)));
            }
        }
    }

    void anUndoingKeepsTheTableThatARebootHasBroughtBack()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, exampleRequest(1, Persistency::Persistent)));
        VERIFY_RESULT(f.compensator.write(0, swapped(2, Persistency::Volatile)));
        f.link.failAt(20, LinkFault::ProgramDies);
        QVERIFY_THROWS_EXCEPTION(
            ProgramDied, (void)f.compensator.write(0, into(exampleRequest(3), "Small5")));
        f.link.heal();
        f.drive.reboot();
        const CompensatorFixture::State present = f.state();
        QVERIFY(!present.table.empty());
        const auto journal = f.store.journal(4711, 0);
        VERIFY_RESULT(journal);
        QVERIFY(journal->has_value());
        const auto undone = f.compensator.undoUnfinished(**journal);
        VERIFY_RESULT(undone);
        QVERIFY(f.state() != present);
        const auto text = loadFile(undone->backup, maximumBackupSize);
        VERIFY_RESULT(text);
        const auto backup = readBackup(asText(*text), "backup");
        VERIFY_RESULT(backup);
        VERIFY_RESULT(f.compensator.restore(*backup, false));
        QVERIFY(f.state().table == present.table);
    }

    void anUndoingThatIsRefusedOnceIsDoneAllTheSame_data()
    {
        QTest::addColumn<int>("fault");
        QTest::newRow("refused") << static_cast<int>(LinkFault::Refused);
        QTest::newRow("stores wrong") << static_cast<int>(LinkFault::StoresWrong);
    }
    void anUndoingThatIsRefusedOnceIsDoneAllTheSame()
    {
        QFETCH(int, fault);
        const auto interrupted = [](CompensatorFixture& f) {
            VERIFY_RESULT(
                f.compensator.write(0, into(exampleRequest(1, Persistency::Persistent), "Small1")));
            f.link.failAt(29, LinkFault::ProgramDies);
            QVERIFY_THROWS_EXCEPTION(ProgramDied,
                (void)f.compensator.write(0, into(swapped(2, Persistency::Persistent), "Small1")));
            f.link.heal();
        };
        CompensatorFixture whole;
        interrupted(whole);
        const auto journal = whole.store.journal(4711, 0);
        VERIFY_RESULT(journal);
        QVERIFY(journal->has_value());
        const CompensatorFixture::State present = whole.state();
        whole.link.forgetChange();
        const int begin = whole.link.exchanges();
        VERIFY_RESULT(whole.compensator.undoUnfinished(**journal));
        const int first = whole.link.firstChange() - begin;
        const int last = whole.link.exchanges() - begin;
        const CompensatorFixture::State old = whole.state();
        QVERIFY(old != present);
        QVERIFY(0 < first && first < last);
        for (int exchange = first; exchange < last; ++exchange) {
            CompensatorFixture f;
            interrupted(f);
            f.link.failAt(exchange, static_cast<LinkFault>(fault));
            (void)f.compensator.undoUnfinished(*f.store.journal(4711, 0).value());
            const CompensatorFixture::State now = f.state();
            QVERIFY2(now == old || now == present,
                qPrintable(QStringLiteral("exchange %1 of %2: %3")
                               .arg(exchange)
                               .arg(last)
                               .arg(QString::fromStdString(now.registers[0]))));
        }
    }

    void anUndoingThatFlashIsTooWornForDoesNotBegin()
    {
        CompensatorFixture f;
        VERIFY_RESULT(
            f.compensator.write(0, into(exampleRequest(1, Persistency::Persistent), "Small1")));
        f.link.failAt(29, LinkFault::ProgramDies);
        QVERIFY_THROWS_EXCEPTION(ProgramDied,
            (void)f.compensator.write(0, into(swapped(2, Persistency::Persistent), "Small1")));
        f.link.heal();
        VERIFY_RESULT(f.store.recordFlash(4711, f.wallTime(), 8));
        const CompensatorFixture::State present = f.state();
        const auto journal = f.store.journal(4711, 0);
        VERIFY_ERROR(f.compensator.undoUnfinished(**journal), ErrorCode::FlashWear);
        QVERIFY(f.state() == present);
        f.pass(drivecomm::genericProfile().flashWear.window);
        VERIFY_RESULT(f.compensator.undoUnfinished(**journal));
    }

    void whatIsUndoneIsSavedAgainWhenAnotherAxisHasSavedItSwitchedOff()
    {
        CompensatorFixture f;
        VERIFY_RESULT(
            f.compensator.write(0, into(exampleRequest(1, Persistency::Persistent), "Small1")));
        const CompensatorFixture::State old = f.state();
        f.link.failAt(19, LinkFault::ProgramDies);
        QVERIFY_THROWS_EXCEPTION(ProgramDied,
            (void)f.compensator.write(0, into(swapped(2, Persistency::Volatile), "Small1")));
        f.link.heal();
        QCOMPARE(f.state().registers[0], std::string("Disabled"));
        VERIFY_RESULT(f.compensator.write(1, exampleRequest(3, Persistency::Persistent)));
        const auto journal = f.store.journal(4711, 0);
        VERIFY_RESULT(journal);
        VERIFY_RESULT(f.compensator.undoUnfinished(**journal));
        QVERIFY(f.state() == old);
        f.drive.reboot();
        QVERIFY(f.state() == old);
    }

    /// The parameters of all axes are saved, also of one whose write has not ended.
    void whatIsUndoneIsSavedAgainWhenAnotherAxisHasSavedWhatWasWritten()
    {
        int undone = 0;
        bool isOver = false;
        for (int exchange = 1; !isOver; ++exchange) {
            CompensatorFixture f;
            VERIFY_RESULT(
                f.compensator.write(0, into(exampleRequest(1, Persistency::Persistent), "Small1")));
            const CompensatorFixture::State old = f.state();
            f.link.failAt(exchange, LinkFault::ProgramDies);
            isOver = true;
            try {
                (void)f.compensator.write(0, into(swapped(2, Persistency::Volatile), "Small1"));
            } catch (const ProgramDied&) {
                isOver = false;
            }
            f.link.heal();
            const auto journal = f.store.journal(4711, 0);
            VERIFY_RESULT(journal);
            if (!*journal)
                continue;
            VERIFY_RESULT(f.compensator.write(1, exampleRequest(3, Persistency::Persistent)));
            VERIFY_RESULT(f.compensator.undoUnfinished(**journal));
            const QByteArray where = "the program died at exchange " + QByteArray::number(exchange);
            QVERIFY2(f.state() == old, where);
            f.drive.reboot();
            QVERIFY2(f.state() == old, where + ", after a reboot");
            ++undone;
        }
        QVERIFY(undone > 5);
    }
};

AXISCOMP_TEST(TestSavedState)

} // namespace tst_savedstate

#include "tst_savedstate.moc"
