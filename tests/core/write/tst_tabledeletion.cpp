// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/local_file.h"
#include "core/store/backup.h"
#include "tests/support/compensator_fixture.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <stop_token>

namespace tst_tabledeletion {

using namespace axiscomp;
using axiscomp::test::CompensatorFixture;
using axiscomp::test::exampleRequest;
using axiscomp::test::exampleTable;
using axiscomp::test::LinkFault;

namespace {

const std::string tableOfX = "Axes[0]/Parameters/Compensations/Axis/Table";
const std::string tableOfY = "Axes[1]/Parameters/Compensations/Axis/Table";

struct Fixture : CompensatorFixture {
    explicit Fixture(Persistency persistency = Persistency::Persistent)
    {
        QVERIFY(compensator.write(0, exampleRequest(1, persistency)).has_value());
        link.forgetChange();
    }
    [[nodiscard]] bool isEmpty(const std::string& slot)
    {
        return drive.download("tables/" + slot + ".TAMtbl").value_or(Bytes{}).empty();
    }
    [[nodiscard]] std::uint64_t flashTotal() { return store.flashHistory(4711).value().total; }
    Result<WriteReport> deleteTable()
    {
        std::stop_source stop;
        OperationOptions options;
        options.stop = stop.get_token();
        link.stopUser = [&stop] { stop.request_stop(); };
        auto report = compensator.write(0, deletionRequest(), options);
        link.stopUser = {};
        return report;
    }
    /// A table that no axis uses, as a drive program puts it there.
    void fill(const std::string& slot, bool persistent)
    {
        VERIFY_RESULT(drive.upload("tables/" + slot + ".TAMtbl",
            *encodeTamTable(exampleTable(1, 9), persistent, drivecomm::genericProfile().layout)));
        link.forgetChange();
    }
};

/// The axis uses none now; the saved parameters name the table in flash.
struct DetachedFixture : Fixture {
    DetachedFixture()
    {
        WriteRequest none;
        none.withoutTable = true;
        none.dimensionality = 3;
        VERIFY_RESULT(compensator.write(0, none));
    }
};

int exchangesOfDetachedDeletion()
{
    DetachedFixture c;
    const int begin = c.link.exchanges();
    return c.deleteTable() ? c.link.exchanges() - begin : 0;
}

} // namespace

class TestTableDeletion : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void nothingOfItComesBackAfterAReboot_data()
    {
        QTest::addColumn<bool>("persistent");
        QTest::newRow("persistent") << true;
        QTest::newRow("volatile") << false;
    }
    void nothingOfItComesBackAfterAReboot()
    {
        QFETCH(bool, persistent);
        Fixture c(persistent ? Persistency::Persistent : Persistency::Volatile);
        const std::vector<std::string> registers = c.state().registers;
        const std::uint64_t spent = c.flashTotal();
        const auto plan = c.compensator.plan(0, deletionRequest());
        VERIFY_RESULT(plan);
        QCOMPARE(plan->deletedSlot, std::string("Small1"));
        QCOMPARE(plan->flashOperations, persistent ? 1 : 0);
        QCOMPARE(c.link.firstChange(), 0);
        const auto report = c.deleteTable();
        VERIFY_RESULT(report);
        QVERIFY(report->now.setup.slot.empty());
        QCOMPARE(c.flashTotal() - spent, std::uint64_t(persistent ? 1 : 0));
        for (const bool isRebooted : {false, true}) {
            if (isRebooted)
                c.drive.reboot();
            QCOMPARE(c.text(tableOfX), std::string("Disabled"));
            QCOMPARE(c.state().registers[1], registers[1]);
            QCOMPARE(c.state().registers[2], registers[2]);
            QVERIFY(c.isEmpty("small1"));
        }
        QVERIFY(!c.store.journal(4711, 0).value());
    }

    void theBackupBringsItBack()
    {
        Fixture c;
        const CompensatorFixture::State old = c.state();
        const auto report = c.deleteTable();
        VERIFY_RESULT(report);
        const auto text = loadOrdinaryFile(report->backup, maximumBackupSize);
        VERIFY_RESULT(text);
        const auto backup = readBackup(asText(*text), report->backup.string());
        VERIFY_RESULT(backup);
        VERIFY_RESULT(c.compensator.restore(*backup, false));
        QVERIFY(c.state() == old);
        c.drive.reboot();
        QVERIFY(c.state() == old);
    }

    void whatStandsAgainstItIsSaidAndNothingIsChanged()
    {
        Fixture c;
        c.set("Axes[0]/Commands/Compensations/Axis/Activation", std::string("AddToEncoders"));
        VERIFY_ERROR(c.deleteTable(), ErrorCode::CompensationActive);
        c.set("Axes[0]/Commands/Compensations/Axis/Activation", std::string("Disabled"));
        c.pass(std::chrono::milliseconds(50));
        c.set(tableOfY, std::string("Small1"));
        const auto used = c.deleteTable();
        VERIFY_ERROR(used, ErrorCode::SlotInUse);
        QCOMPARE(sentence(used.error()),
            std::string("the table in Small1 is not deleted, because axis 1 uses it; free it there "
                        "first"));
        c.set(tableOfY, std::string("Disabled"));
        c.set("Axes[1]/Parameters/Compensations/Cogging/Table", std::string("Small1"));
        VERIFY_ERROR(c.deleteTable(), ErrorCode::SlotInUse);
        c.set("Axes[1]/Parameters/Compensations/Cogging/Table", std::string("Disabled"));
        const auto none = c.compensator.write(1, deletionRequest());
        VERIFY_ERROR(none, ErrorCode::NoTable);
        QCOMPARE(sentence(none.error()),
            std::string("axis 1 uses no table: there is nothing to delete"));
        QCOMPARE(c.link.firstChange(), 0);
        VERIFY_RESULT(c.deleteTable());
    }

    void aTableThatAnotherAxisHasAfterARebootIsKept()
    {
        Fixture c;
        VERIFY_RESULT(c.compensator.write(1, exampleRequest(2, Persistency::Persistent)));
        const std::string theirs = c.text(tableOfY);
        WriteRequest trial = exampleRequest(3);
        VERIFY_RESULT(c.compensator.write(1, trial));
        QVERIFY(c.text(tableOfY) != theirs);
        c.set(tableOfX, theirs);
        const auto refused = c.deleteTable();
        VERIFY_ERROR(refused, ErrorCode::SlotInUse);
        QVERIFY(sentence(refused.error()).find("axis 1 after a reboot") != std::string::npos);
    }

    void parametersThatDoNotNameTheSlotAreNotSaved()
    {
        Fixture c;
        VERIFY_RESULT(c.compensator.write(0, exampleRequest(2)));
        QCOMPARE(c.text(tableOfX), std::string("Small2"));
        const auto report = c.deleteTable();
        VERIFY_RESULT(report);
        QCOMPARE(report->plan.warnings.size(), 1U);
        QCOMPARE(report->plan.warnings.front().english(),
            std::string("After a reboot axis 0 (X) uses the table in Small1 again, as its saved "
                        "parameters say."));
        QVERIFY(c.isEmpty("small2"));
        c.drive.reboot();
        QCOMPARE(c.text(tableOfX), std::string("Small1"));
        QVERIFY(!c.isEmpty("small1"));
    }

    void aVolatileTableOverAStoredOneIsDeletedWithIt()
    {
        Fixture c;
        WriteRequest over = exampleRequest(2);
        over.slot = "Small1";
        VERIFY_RESULT(c.compensator.write(0, over));
        QVERIFY(c.store.savedState(4711).value().isCovered("Small1"));
        const auto report = c.deleteTable();
        VERIFY_RESULT(report);
        QCOMPARE(report->plan.flashOperations, 1);
        QVERIFY(!c.store.savedState(4711).value().isCovered("Small1"));
        c.drive.reboot();
        QVERIFY(c.isEmpty("small1"));
        QCOMPARE(c.text(tableOfX), std::string("Disabled"));
    }

    /// What names an empty slot can be tidied up too.
    void aNameWithoutATableIsTakenAway()
    {
        Fixture c(Persistency::Volatile);
        VERIFY_RESULT(
            c.drive.writeRegisters({{"General/Commands/SaveParameters", std::string("Save")}}));
        c.drive.reboot();
        QCOMPARE(c.text(tableOfX), std::string("Small1"));
        VERIFY_RESULT(c.deleteTable());
        c.drive.reboot();
        QCOMPARE(c.text(tableOfX), std::string("Disabled"));
    }

    /// As after a reboot that took a volatile table: a backup of it finds everything there, and
    /// only a deletion takes the name away.
    void aNameWithoutATableIsNoDifferenceToABackup()
    {
        Fixture c(Persistency::Volatile);
        VERIFY_RESULT(
            c.drive.writeRegisters({{"General/Commands/SaveParameters", std::string("Save")}}));
        c.drive.reboot();
        QCOMPARE(c.text(tableOfX), std::string("Small1"));
        const auto backup = c.compensator.backup();
        VERIFY_RESULT(backup);
        c.link.forgetChange();
        const auto planned = c.compensator.planRestore(*backup, false);
        VERIFY_RESULT(planned);
        QVERIFY(planned->axes.front().changes.empty());
        const auto restored = c.compensator.restore(*backup, false);
        VERIFY_RESULT(restored);
        QVERIFY(restored->axes.empty());
        QCOMPARE(c.link.firstChange(), 0);
        QCOMPARE(c.text(tableOfX), std::string("Small1"));

        // A table that has come into it is no longer what the backup holds.
        c.fill("small1", false);
        const auto filled = c.compensator.planRestore(*backup, false);
        VERIFY_RESULT(filled);
        QCOMPARE(filled->axes.front().changes.front().field, std::string("Table"));
        c.drive.reboot();
        // Nor is a backup of an axis that named none.
        DriveBackup ofNone = *backup;
        ofNone.axes[0].registers[0].value = std::string("Disabled");
        const auto named = c.compensator.planRestore(ofNone, false);
        VERIFY_RESULT(named);
        QCOMPARE(named->axes.front().changes.front().before, std::string("Small1, empty"));
        QCOMPARE(named->axes.front().changes.front().after, std::string("none"));

        const auto deletion = c.compensator.plan(0, deletionRequest());
        VERIFY_RESULT(deletion);
        QCOMPARE(deletion->changes.front().before, std::string("Small1, empty"));
        VERIFY_RESULT(c.deleteTable());
        QCOMPARE(c.text(tableOfX), std::string("Disabled"));
    }

    void aCommandThatIsLostIsRepeated()
    {
        Fixture whole;
        const int begin = whole.link.exchanges();
        VERIFY_RESULT(whole.deleteTable());
        const int exchanges = whole.link.exchanges() - begin;
        int repeated = 0;
        for (int exchange = 1; exchange <= exchanges; ++exchange) {
            Fixture c;
            c.link.beginning = [&, at = 0](std::string_view) mutable {
                if (++at == exchange)
                    c.drive.storeNextWrong();
            };
            const auto report = c.deleteTable();
            c.link.beginning = {};
            if (!report) {
                QVERIFY(c.text(tableOfX) == "Small1");
                continue;
            }
            QVERIFY(c.isEmpty("small1"));
            ++repeated;
        }
        QVERIFY(repeated > 1);
    }

    void aDeletionOfWhatARebootBringsBackIsOnlyFinishedOnceParametersAreSaved_data()
    {
        QTest::addColumn<LinkFault>("fault");
        QTest::newRow("the drive is gone") << LinkFault::DriveGoneAfter;
        QTest::newRow("refused") << LinkFault::Refused;
        QTest::newRow("stopped") << LinkFault::UserStops;
    }
    void aDeletionOfWhatARebootBringsBackIsOnlyFinishedOnceParametersAreSaved()
    {
        QFETCH(LinkFault, fault);
        const int exchanges = exchangesOfDetachedDeletion();
        int undone = 0;
        int finished = 0;
        for (int exchange = 1; exchange <= exchanges; ++exchange) {
            DetachedFixture c;
            c.link.failAt(exchange, fault);
            const auto deleted = c.deleteTable();
            c.link.heal();
            const auto entry = c.store.journal(4711, 0).value();
            if (!entry) {
                c.drive.reboot();
                QCOMPARE(c.text(tableOfX), std::string(deleted ? "Disabled" : "Small1"));
                QCOMPARE(c.isEmpty("small1"), deleted.has_value());
                continue;
            }
            const auto recovery = c.compensator.recovery(*entry);
            VERIFY_RESULT(recovery);
            if (!recovery->undoObstacle) {
                VERIFY_RESULT(c.compensator.undoUnfinished(*entry));
                c.drive.reboot();
                QCOMPARE(c.text(tableOfX), std::string("Small1"));
                QVERIFY(!c.isEmpty("small1"));
                ++undone;
                continue;
            }
            QVERIFY(!deleted);
            QCOMPARE(recovery->undoObstacle->code, ErrorCode::NotUndoable);
            VERIFY_ERROR(c.compensator.undoUnfinished(*entry), ErrorCode::NotUndoable);
            VERIFY_RESULT(c.compensator.finishUnfinished(*entry));
            c.drive.reboot();
            QCOMPARE(c.text(tableOfX), std::string("Disabled"));
            QVERIFY(c.isEmpty("small1"));
            ++finished;
        }
        QVERIFY(undone > 0 || fault != LinkFault::DriveGoneAfter);
        QVERIFY(finished > 0);
    }

    /// They say what a reboot brings back, which nobody has read.
    void puttingADeletionBackLeavesTheSavedParametersAsTheyAre()
    {
        const int exchanges = exchangesOfDetachedDeletion();
        int savedNothing = 0;
        for (int exchange = 1; exchange <= exchanges; ++exchange) {
            DetachedFixture c;
            c.link.failAt(exchange, LinkFault::Refused);
            const auto deleted = c.deleteTable();
            c.link.heal();
            if (deleted || deleted.error().code != ErrorCode::RollbackFailed)
                continue;
            QVERIFY(sentence(deleted.error()).find("can only be finished") != std::string::npos);
            QVERIFY(!c.isEmpty("small1"));
            c.drive.reboot();
            QVERIFY(!c.isEmpty("small1"));
            savedNothing += c.text(tableOfX) == "Small1" ? 1 : 0;
        }
        QVERIFY(savedNothing > 0);
    }

    /// The axis had the table before the first of the two, so that there is something to undo.
    void finishingADeletionThatIsPutBackCanStillBeUndone()
    {
        const auto begun = [](Fixture& c) {
            c.link.beginning = [&c](std::string_view what) {
                if (what == "write")
                    c.link.failAt(0, LinkFault::DriveGoneAfter);
            };
            static_cast<void>(c.deleteTable());
            c.link.beginning = {};
            c.link.heal();
            return c.store.journal(4711, 0).value();
        };
        Fixture whole;
        const auto first = begun(whole);
        QVERIFY(first.has_value());
        QCOMPARE(whole.text(tableOfX), std::string("Disabled"));
        const int begin = whole.link.exchanges();
        VERIFY_RESULT(whole.compensator.finishUnfinished(*first));
        const int exchanges = whole.link.exchanges() - begin;
        for (int exchange = 1; exchange <= exchanges; ++exchange) {
            Fixture c;
            const auto entry = begun(c);
            QVERIFY(entry.has_value());
            c.link.failAt(exchange, LinkFault::Refused);
            const auto finished = c.compensator.finishUnfinished(*entry);
            c.link.heal();
            if (finished)
                continue;
            QVERIFY(finished.error().code != ErrorCode::RollbackFailed);
            const auto left = c.store.journal(4711, 0).value();
            QVERIFY(left.has_value());
            VERIFY_RESULT(c.compensator.undoUnfinished(*left));
            c.drive.reboot();
            QCOMPARE(c.text(tableOfX), std::string("Small1"));
            QVERIFY(!c.isEmpty("small1"));
        }
    }

    void aSlotThatNoAxisUsesIsFreed_data()
    {
        QTest::addColumn<bool>("persistent");
        QTest::newRow("persistent") << true;
        QTest::newRow("volatile") << false;
    }
    void aSlotThatNoAxisUsesIsFreed()
    {
        QFETCH(bool, persistent);
        Fixture c;
        c.fill("small3", persistent);
        const std::uint64_t spent = c.flashTotal();
        const auto plan = c.compensator.planSlotDeletion("Small3");
        VERIFY_RESULT(plan);
        QCOMPARE(plan->flashOperations, persistent ? 1 : 0);
        QCOMPARE(c.link.firstChange(), 0);
        const auto backup = c.compensator.deleteSlot("Small3");
        VERIFY_RESULT(backup);
        QVERIFY(std::filesystem::exists(*backup));
        QCOMPARE(c.flashTotal() - spent, std::uint64_t(persistent ? 1 : 0));
        QVERIFY(c.isEmpty("small3"));
        c.drive.reboot();
        QVERIFY(c.isEmpty("small3"));
        QVERIFY(!c.isEmpty("small1"));
        VERIFY_ERROR(c.compensator.deleteSlot("Small3"), ErrorCode::NoTable);
    }

    void aSlotThatIsUsedOrUnknownIsRefused()
    {
        Fixture c;
        const auto used = c.compensator.deleteSlot("Small1");
        VERIFY_ERROR(used, ErrorCode::SlotInUse);
        QVERIFY(sentence(used.error()).find("axis 0 uses it") != std::string::npos);
        VERIFY_ERROR(c.compensator.deleteSlot("Small9"), ErrorCode::SlotNotFound);
        QCOMPARE(c.link.firstChange(), 0);
        // The saved parameters still name the slot that the axis does not use now.
        VERIFY_RESULT(c.compensator.write(0, exampleRequest(2)));
        c.link.forgetChange();
        const auto later = c.compensator.deleteSlot("Small1");
        VERIFY_ERROR(later, ErrorCode::SlotInUse);
        QVERIFY(sentence(later.error()).find("axis 0 after a reboot") != std::string::npos);
        QCOMPARE(c.link.firstChange(), 0);
        VERIFY_RESULT(c.compensator.setPersistency(0, Persistency::Persistent));
        VERIFY_RESULT(c.compensator.deleteSlot("Small1"));
    }

    void aSlotIsThereOrNotWhateverHappens()
    {
        Fixture whole;
        whole.fill("small3", true);
        const Bytes old = *whole.drive.download("tables/small3.TAMtbl");
        const int begin = whole.link.exchanges();
        VERIFY_RESULT(whole.compensator.deleteSlot("Small3"));
        const int exchanges = whole.link.exchanges() - begin;
        for (const LinkFault fault :
            {LinkFault::DriveGone, LinkFault::DriveGoneAfter, LinkFault::Refused}) {
            for (int exchange = 1; exchange <= exchanges; ++exchange) {
                Fixture c;
                c.fill("small3", true);
                c.link.failAt(exchange, fault);
                const auto deleted = c.compensator.deleteSlot("Small3");
                c.link.heal();
                const QByteArray where = "exchange " + QByteArray::number(exchange);
                const Bytes now = c.drive.download("tables/small3.TAMtbl").value_or(Bytes{});
                QVERIFY2(now.empty() || now == old, where);
                QVERIFY2(!deleted || now.empty(), where);
                c.drive.reboot();
                QVERIFY2(now == c.drive.download("tables/small3.TAMtbl").value_or(Bytes{}), where);
            }
        }
    }
};

AXISCOMP_TEST(TestTableDeletion)

} // namespace tst_tabledeletion

#include "tst_tabledeletion.moc"
