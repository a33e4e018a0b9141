// SPDX-License-Identifier: GPL-3.0-or-later
//
// Putting back what has reached flash costs flash operations too: a write that could not be put
// back does not begin, and one that needs none for that may use the last.
#include "tests/support/compensator_fixture.h"
#include "tests/support/moments.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <array>
#include <functional>

namespace tst_flashreserve {

using namespace axiscomp;
using namespace axiscomp::test;

namespace {

WriteRequest into(WriteRequest request, const char* slot)
{
    request.slot = slot;
    return request;
}

WriteRequest persistent(int seed, const char* slot)
{
    return into(exampleRequest(seed, Persistency::Persistent), slot);
}

WriteRequest trial(int seed, const char* slot)
{
    return into(exampleRequest(seed, Persistency::Volatile), slot);
}

int operationsLeft(CompensatorFixture& f)
{
    const auto use = f.compensator.flashUse();
    return use ? use->budget.left : -1;
}

/// Spends operations, by the drive's count and by the store's, until this many are left.
void leave(CompensatorFixture& f, int left)
{
    const auto& layout = drivecomm::genericProfile().layout;
    for (int seed = 100; operationsLeft(f) > left; ++seed) {
        VERIFY_RESULT(f.drive.upload(
            "tables/large2.TAMtbl", *encodeTamTable(exampleTable(1, seed), true, layout)));
        VERIFY_RESULT(f.store.recordFlash(4711, f.wallTime(), 1));
    }
    QCOMPARE(operationsLeft(f), left);
}

constexpr std::array faults{
    LinkFault::Refused, LinkFault::ReplyLost, LinkFault::StoresWrong, LinkFault::RequestLost};

using Step = std::function<Result<WriteReport>(CompensatorFixture&)>;

/// A write, and the operations that must be possible before it begins.
struct Kind {
    std::function<void(CompensatorFixture&)> prepare;
    Step write;
    int needed = 0;
};

Step writing(const WriteRequest& request)
{
    return [request](CompensatorFixture& f) { return f.compensator.write(0, request); };
}

Step making(Persistency persistency)
{
    return [persistency](
               CompensatorFixture& f) { return f.compensator.setPersistency(0, persistency); };
}

std::function<void(CompensatorFixture&)> having(const std::vector<WriteRequest>& requests)
{
    return [requests](CompensatorFixture& f) {
        for (const WriteRequest& request : requests)
            VERIFY_RESULT(f.compensator.write(0, request));
    };
}

} // namespace

class TestFlashReserve : public QObject {
    Q_OBJECT

private:
    static void kinds()
    {
        QTest::addColumn<Kind>("kind");
        QTest::newRow("first, to an empty slot") << Kind{
            [](CompensatorFixture&) {}, writing(exampleRequest(1, Persistency::Persistent)), 1};
        QTest::newRow("in turn") << Kind{having({persistent(1, "Small1"), persistent(2, "Small2")}),
            writing(exampleRequest(3, Persistency::Persistent)), 1};
        QTest::newRow("in place") << Kind{
            having({persistent(1, "Small1")}), writing(persistent(2, "Small1")), 2};
        QTest::newRow("in place, volatile before")
            << Kind{having({trial(1, "Small1")}), writing(persistent(2, "Small1")), 2};
        QTest::newRow("in place, volatile before over another one in flash")
            << Kind{having({persistent(1, "Small1"), trial(2, "Small1")}),
                   writing(persistent(3, "Small1")), 2};
        QTest::newRow("named, persistent there")
            << Kind{having({persistent(1, "Small1"), persistent(2, "Small2")}),
                   writing(persistent(3, "Small1")), 2};
        QTest::newRow("elsewhere, volatile before over another one in flash")
            << Kind{having({persistent(1, "Small1"), trial(2, "Small1")}),
                   writing(persistent(3, "Small2")), 2};
        QTest::newRow("made persistent")
            << Kind{having({trial(1, "Small1")}), making(Persistency::Persistent), 2};
        QTest::newRow("made volatile")
            << Kind{having({persistent(1, "Small1")}), making(Persistency::Volatile), 2};
        QTest::newRow("deleted") << Kind{
            having({persistent(1, "Small1")}), writing(deletionRequest()), 2};
        QTest::newRow("deleted, volatile over another one in flash") << Kind{
            having({persistent(1, "Small1"), trial(2, "Small1")}), writing(deletionRequest()), 1};
        QTest::newRow("deleted, volatile")
            << Kind{having({trial(1, "Small1")}), writing(deletionRequest()), 0};
        QTest::newRow("volatile, in place")
            << Kind{having({persistent(1, "Small1")}), writing(trial(2, "Small1")), 0};
    }

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void aWriteThatCouldNotBePutBackDoesNotBegin_data() { kinds(); }
    void aWriteThatCouldNotBePutBackDoesNotBegin()
    {
        QFETCH(Kind, kind);
        CompensatorFixture f;
        kind.prepare(f);
        if (kind.needed > 0) {
            leave(f, kind.needed - 1);
            const CompensatorFixture::State old = f.state();
            f.link.forgetChange();
            const auto refused = kind.write(f);
            VERIFY_ERROR(refused, ErrorCode::FlashWear);
            QCOMPARE(f.link.firstChange(), 0);
            QVERIFY(f.state() == old);
            const bool isForReserve =
                sentence(refused.error()).find("putting everything back") != std::string::npos;
            QCOMPARE(isForReserve, kind.needed > 1);
            f.pass(std::chrono::seconds(std::stoi(refused.error().context.english("seconds"))));
        } else {
            leave(f, 0);
        }
        VERIFY_RESULT(kind.write(f));
    }

    void aWriteThatBeginsCanBePutBackFromEveryExchange_data() { kinds(); }
    void aWriteThatBeginsCanBePutBackFromEveryExchange()
    {
        QFETCH(Kind, kind);
        CompensatorFixture whole;
        kind.prepare(whole);
        leave(whole, kind.needed);
        const int begin = whole.link.exchanges();
        VERIFY_RESULT(kind.write(whole));
        const int exchanges = whole.link.exchanges() - begin;
        const CompensatorFixture::State wanted = whole.state();
        int rollBack = 0;
        for (int exchange = 1; exchange <= exchanges; ++exchange) {
            for (int n = 0; n < static_cast<int>(faults.size()); ++n) {
                if (!hasTurn(exchange + n, static_cast<int>(faults.size())))
                    continue;
                const LinkFault fault = faults[static_cast<std::size_t>(n)];
                CompensatorFixture f;
                kind.prepare(f);
                leave(f, kind.needed);
                const CompensatorFixture::State old = f.state();
                f.link.failAt(exchange, fault);
                const auto written = kind.write(f);
                const std::string place = std::to_string(exchange) + " of "
                    + std::to_string(exchanges) + ", fault "
                    + std::to_string(static_cast<int>(fault)) + ": "
                    + (written ? "done" : describe(written.error()));
                QVERIFY2(f.state() == (written ? wanted : old), place.c_str());
                QVERIFY2(
                    written || written.error().code != ErrorCode::RollbackFailed, place.c_str());
                QVERIFY2(f.text("General/Signals/DriveError") == "None", place.c_str());
                rollBack += written ? 0 : 1;
            }
        }
        QVERIFY(rollBack > 0);
    }

    /// To become volatile costs what to become persistent costs, and is refused in the same way.
    void removingATableFromFlashIsSaidAndRefusedAsStoringIt()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, exampleRequest(1, Persistency::Persistent)));
        WriteRequest remove;
        remove.dimensionality = 2;
        remove.persistency = Persistency::Volatile;
        const auto plan = f.compensator.plan(0, remove);
        VERIFY_RESULT(plan);
        QCOMPARE(plan->flashOperations, 1);
        QCOMPARE(plan->warnings.size(), std::size_t{1});
        QCOMPARE(plan->warnings.front().english(),
            std::string("The table is removed from flash, which is a flash operation too. After a "
                        "reboot the axis has no table."));
        leave(f, 0);
        const auto refused = f.compensator.plan(0, remove);
        VERIFY_ERROR(refused, ErrorCode::FlashWear);
        const std::string seconds = refused.error().context.english("seconds");
        QCOMPARE(sentence(refused.error()),
            "removing a table from flash is a flash operation too, and there were too many of them "
            "in a short time; wait "
                + seconds + " s, or keep the table persistent");
        f.pass(std::chrono::seconds(std::stoi(seconds)));
        VERIFY_RESULT(f.compensator.plan(0, remove));
    }

    /// To write volatile is the way out of neither.
    void storingATableAndDeletingOneSayToWait()
    {
        const std::string reserve =
            "the flash operations that are left would do for the change, but not for putting "
            "everything back if it fails; wait ";
        const std::string none = "too many flash operations in a short time; wait ";
        const auto saysToWait = [](const auto& refused, const std::string& beginning) {
            VERIFY_ERROR(refused, ErrorCode::FlashWear);
            const std::string due = beginning + refused.error().context.english("seconds") + " s";
            QCOMPARE(sentence(refused.error()), due);
        };
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, exampleRequest(1, Persistency::Volatile)));
        WriteRequest store;
        store.dimensionality = 2;
        store.persistency = Persistency::Persistent;
        leave(f, 1);
        saysToWait(f.compensator.plan(0, store), reserve);
        leave(f, 0);
        saysToWait(f.compensator.plan(0, store), none);

        CompensatorFixture stored;
        VERIFY_RESULT(stored.compensator.write(0, persistent(1, "Small1")));
        VERIFY_RESULT(stored.compensator.upload("tables/small5.TAMtbl",
            *encodeTamTable(exampleTable(1, 1), true, drivecomm::genericProfile().layout)));
        leave(stored, 1);
        saysToWait(stored.compensator.plan(0, deletionRequest()), reserve);
        leave(stored, 0);
        saysToWait(stored.compensator.plan(0, deletionRequest()), none);
        saysToWait(stored.compensator.planSlotDeletion("Small5"), none);
    }

    void aFileThatCouldNotBePutBackIsNotUploaded()
    {
        const auto& layout = drivecomm::genericProfile().layout;
        const std::string path = "tables/small5.TAMtbl";
        CompensatorFixture f;
        VERIFY_RESULT(
            f.compensator.upload(path, *encodeTamTable(exampleTable(1, 1), true, layout)));
        leave(f, 1);
        const Bytes next = *encodeTamTable(exampleTable(1, 2), true, layout);
        const auto refused = f.compensator.upload(path, next);
        VERIFY_ERROR(refused, ErrorCode::FlashWear);
        QCOMPARE(refused.error().context.english("reserve"), std::string("1"));
        f.pass(std::chrono::seconds(std::stoi(refused.error().context.english("seconds"))));
        VERIFY_RESULT(f.compensator.upload(path, next));
    }

    void tablesThatNoAxisUsesCountBeforeADriveIsRestored()
    {
        const auto& layout = drivecomm::genericProfile().layout;
        const auto storeUnused = [&layout](CompensatorFixture& f, int seed) {
            VERIFY_RESULT(f.drive.upload(
                "tables/small2.TAMtbl", *encodeTamTable(exampleTable(1, seed), true, layout)));
        };
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, persistent(1, "Small1")));
        storeUnused(f, 50);
        leave(f, 4);
        auto backup = f.compensator.backup();
        VERIFY_RESULT(backup);
        VERIFY_RESULT(f.compensator.write(0, persistent(2, "Small1")));
        storeUnused(f, 51);
        VERIFY_RESULT(f.store.recordFlash(4711, f.wallTime(), 1));
        QCOMPARE(operationsLeft(f), 2);
        const auto before = f.state();
        f.link.forgetChange();

        // The axis alone needs 2, the unused table 1 more.
        const auto refused = f.compensator.planRestore(*backup, false);
        VERIFY_ERROR(refused, ErrorCode::FlashWear);
        QVERIFY2(
            sentence(refused.error())
                .starts_with(
                    "the flash operations that are left would do for all of these changes, 2, but"),
            sentence(refused.error()).c_str());
        VERIFY_ERROR(f.compensator.restore(*backup, false), ErrorCode::FlashWear);
        QCOMPARE(f.link.firstChange(), 0);
        QVERIFY(f.state() == before);

        DriveBackup axesOnly = *backup;
        axesOnly.otherFiles.clear();
        VERIFY_RESULT(f.compensator.planRestore(axesOnly, false));
        // Nor without axes: the drive does it, but not what the record allows.
        VERIFY_RESULT(f.store.recordFlash(4711, f.wallTime(), 2));
        DriveBackup filesOnly = *backup;
        filesOnly.axes.clear();
        const auto alone = f.compensator.planRestore(filesOnly, false);
        VERIFY_ERROR(alone, ErrorCode::FlashWear);
        QVERIFY(!alone.error().context.contains("together"));
        f.pass(drivecomm::genericProfile().flashWear.window);
        VERIFY_RESULT(f.compensator.restore(*backup, false));
    }

    void whatRestoringAFileCostsIsPlannedAndSaid()
    {
        const auto& layout = drivecomm::genericProfile().layout;
        CompensatorFixture f;
        const Bytes file = *encodeTamTable(exampleTable(1, 50), true, layout);
        VERIFY_RESULT(f.compensator.upload("tables/small4.TAMtbl", file));
        const auto backup = f.compensator.backup();
        VERIFY_RESULT(backup);
        VERIFY_RESULT(f.compensator.deleteSlot("Small4"));
        const auto plan = f.compensator.planRestore(*backup, false);
        VERIFY_RESULT(plan);
        QCOMPARE(plan->files.size(), std::size_t{1});
        QCOMPARE(plan->files.front().file.slot, std::string("Small4"));
        QVERIFY(!plan->files.front().isThere);
        QCOMPARE(plan->files.front().flashOperations, 1);
        const int left = operationsLeft(f);
        const auto restored = f.compensator.restore(*backup, false);
        VERIFY_RESULT(restored);
        QVERIFY(restored->axes.empty());
        QCOMPARE(restored->files.size(), std::size_t{1});
        QCOMPARE(operationsLeft(f), left - 1);

        const auto again = f.compensator.planRestore(*backup, false);
        VERIFY_RESULT(again);
        QVERIFY(again->files.front().isThere);
        QCOMPARE(again->files.front().flashOperations, 0);
        QVERIFY(f.compensator.restore(*backup, false)->files.empty());
        QCOMPARE(operationsLeft(f), left - 1);
    }
};

AXISCOMP_TEST(TestFlashReserve)

} // namespace tst_flashreserve

#include "tst_flashreserve.moc"
