// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/changed_backup.h"
#include "tests/support/compensator_fixture.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <array>

namespace tst_sourcesofabackup {

using namespace axiscomp;
using test::CompensatorFixture;
using test::exampleRequest;
using test::LinkFault;
using test::masterX;
using test::masterY;

namespace {

const std::string plannerX = "Axes[0]/Signals/PathPlanner/Position";
const std::string gone = "Axes[0]/Signals/PositionController/FormerPosition";

std::uint32_t addressOf(CompensatorFixture& c, const std::string& path)
{
    const auto readings = c.drive.readRegisters({path});
    return readings ? readings->front().address : 0;
}

/// As of a drive whose firmware has the position of X where this one has the planned position.
void moveSource(CompensatorFixture& c, std::vector<RegisterWrite>& registers)
{
    registers.at(1).value = addressOf(c, plannerX);
}

/// A backup of the first table of axis 0, which has another table by now.
struct Replaced : CompensatorFixture {
    Replaced()
    {
        QVERIFY(compensator.write(0, exampleRequest(1)).has_value());
        wanted = state();
        const auto backup = compensator.backup();
        QVERIFY(backup.has_value());
        kept = backup->axes.front();
        QVERIFY(compensator.write(0, exampleRequest(2)).has_value());
    }

    State wanted;
    AxisBackup kept;
};

/// A write that was interrupted right after its first change.
struct Interrupted : CompensatorFixture {
    Interrupted()
    {
        CompensatorFixture whole;
        QVERIFY(whole.compensator.write(0, exampleRequest(1)).has_value());
        const int begin = whole.link.exchanges();
        whole.link.forgetChange();
        QVERIFY(whole.compensator.write(0, exampleRequest(2)).has_value());
        wanted = whole.state();
        QVERIFY(compensator.write(0, exampleRequest(1)).has_value());
        old = state();
        link.failAt(whole.link.firstChange() - begin + 2, LinkFault::DriveGone);
        QVERIFY(!compensator.write(0, exampleRequest(2)).has_value());
        link.heal();
        entry = *store.journal(4711, 0).value();
    }

    /// Changes what is kept of the state before the write, and of the one after it.
    template <typename Change> void changeKept(const Change& change)
    {
        test::changeBackup(entry.backup,
            [&](AxisBackup& before) { change(before.registers, before.sourcePaths); });
        change(entry.newRegisters, entry.newSourcePaths);
        QVERIFY(store.openJournal(entry).has_value());
    }

    State old;
    State wanted;
    JournalEntry entry;
};

using Recover = Result<WriteReport> (AxisCompensator::*)(
    const JournalEntry&, const OperationOptions&);
constexpr std::array ways{&AxisCompensator::finishUnfinished, &AxisCompensator::undoUnfinished};

} // namespace

class TestSourcesOfABackup : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    /// Its address may be that of another register, on a replaced drive or after an update.
    void aSourceIsRestoredByItsPath()
    {
        Replaced c;
        QVERIFY(c.kept.sourcePaths == (std::vector{masterX, masterY}));
        moveSource(c, c.kept.registers);
        VERIFY_RESULT(c.compensator.restore({.axes = {c.kept}}, false));
        QCOMPARE(c.state().registers.at(1), c.wanted.registers.at(1));
        QCOMPARE(c.state().registers.at(2), c.wanted.registers.at(2));
        QVERIFY(c.state().table == c.wanted.table);
    }

    void aSourceThatIsNotThereAnyMoreIsRefused()
    {
        Replaced c;
        c.kept.sourcePaths.at(0) = gone;
        const auto before = c.state();
        c.link.forgetChange();
        for (const bool force : {false, true}) {
            const auto refused = c.compensator.restore({.axes = {c.kept}}, force);
            VERIFY_ERROR(refused, ErrorCode::SourceNotFound);
            QCOMPARE(refused.error().context.english("source"), gone);
            VERIFY_ERROR(c.compensator.planRestore(c.kept, force), ErrorCode::SourceNotFound);
        }
        QCOMPARE(c.link.firstChange(), 0);
        QVERIFY(c.state() == before);
    }

    /// Older versions kept the addresses alone.
    void aBackupWithoutPathsIsRestoredByItsAddresses()
    {
        Replaced c;
        c.kept.sourcePaths.clear();
        moveSource(c, c.kept.registers);
        VERIFY_RESULT(c.compensator.restore({.axes = {c.kept}}, false));
        QCOMPARE(c.state().registers.at(1), std::to_string(addressOf(c, plannerX)));
    }

    void anInterruptedWriteIsFinishedAndUndoneByThePathsOfItsSources()
    {
        for (const Recover way : ways) {
            Interrupted c;
            QVERIFY(c.entry.newSourcePaths == (std::vector<std::string>{masterX, masterY, ""}));
            c.changeKept([&c](std::vector<RegisterWrite>& registers, std::vector<std::string>&) {
                moveSource(c, registers);
            });
            const auto outcome = c.compensator.settleUnfinished(c.entry);
            VERIFY_RESULT(outcome);
            QVERIFY(*outcome == AxisCompensator::UnfinishedOutcome::Old);
            VERIFY_RESULT((c.compensator.*way)(c.entry, {}));
            QVERIFY(c.state() == (way == ways.front() ? c.wanted : c.old));
            QVERIFY(!c.store.journal(4711, 0).value().has_value());
        }
    }

    void aWriteWhoseSourceIsNotThereAnyMoreIsNeitherFinishedNorUndone()
    {
        Interrupted c;
        c.changeKept([](std::vector<RegisterWrite>&, std::vector<std::string>& paths) {
            paths.at(0) = gone;
        });
        const auto outcome = c.compensator.settleUnfinished(c.entry);
        VERIFY_RESULT(outcome);
        QVERIFY(*outcome == AxisCompensator::UnfinishedOutcome::Neither);
        const auto recovery = c.compensator.recovery(c.entry);
        VERIFY_RESULT(recovery);
        for (const auto& obstacle : {recovery->finishObstacle, recovery->undoObstacle})
            QVERIFY(obstacle && obstacle->code == ErrorCode::SourceNotFound);
        c.link.forgetChange();
        for (const Recover way : ways)
            VERIFY_ERROR((c.compensator.*way)(c.entry, {}), ErrorCode::SourceNotFound);
        QCOMPARE(c.link.firstChange(), 0);
        QVERIFY(c.store.journal(4711, 0).value().has_value());
    }
};

AXISCOMP_TEST(TestSourcesOfABackup)

} // namespace tst_sourcesofabackup

#include "tst_sourcesofabackup.moc"
