// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compensator/multi_axis_write.h"
#include "core/table/tam_table.h"
#include "tests/support/compensator_fixture.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <algorithm>

namespace tst_multiaxiswrite {

using namespace axiscomp;
using test::CompensatorFixture;
using test::exampleRequest;
using test::exampleTable;

namespace {

/// Whether one of the warnings of a plan says that an axis has no table after a reboot.
bool saysThatATableIsLost(const WritePlan& plan)
{
    return std::ranges::any_of(plan.warnings, [](const Text& warning) {
        return warning.english().find("after a reboot that axis has no table") != std::string::npos;
    });
}

} // namespace

class TestSeveralWrites : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void planningChangesNothing()
    {
        CompensatorFixture fixture;
        const auto before = fixture.state(0);
        const std::vector<AxisWrite> writes{{0, exampleRequest(1)}, {1, exampleRequest(2)}};
        const auto plans = planMultiAxis(fixture.compensator, writes);
        VERIFY_RESULT(plans);
        QCOMPARE(plans->size(), std::size_t(2));
        QCOMPARE(plans->at(1).axis, 1);
        QVERIFY(fixture.state(0) == before);
    }

    void plannedWritesGetASlotEach()
    {
        CompensatorFixture fixture;
        const std::vector<AxisWrite> writes{{0, exampleRequest(1)}, {1, exampleRequest(2)}};
        VERIFY_RESULT(planMultiAxis(fixture.compensator, writes));
        for (const AxisWrite& write : writes)
            VERIFY_RESULT(fixture.compensator.write(write.axis, write.request));
        QVERIFY(fixture.state(0).registers[0] != fixture.state(1).registers[0]);
        QVERIFY(fixture.state(0).table != fixture.state(1).table);
    }

    void plansNameTheSlotsThatTheWritesWillTake()
    {
        CompensatorFixture fixture;
        const std::vector<AxisWrite> writes{{0, exampleRequest(1)}, {1, exampleRequest(2)}};
        const auto plans = planMultiAxis(fixture.compensator, writes);
        VERIFY_RESULT(plans);
        for (std::size_t n = 0; n < writes.size(); ++n) {
            const auto report = fixture.compensator.write(writes[n].axis, writes[n].request);
            VERIFY_RESULT(report);
            QCOMPARE(report->plan.after.slot, plans->at(n).after.slot);
        }
    }

    void withOneSlotForTwoAxesNoneIsWritten()
    {
        CompensatorFixture fixture;
        const auto file =
            encodeTamTable(exampleTable(1, 9), false, drivecomm::genericProfile().layout);
        VERIFY_RESULT(file);
        const auto& slots = drivecomm::genericProfile().tableSlots;
        for (std::size_t n = 1; n < slots.size(); ++n)
            VERIFY_RESULT(fixture.drive.upload(slots[n].file, *file));
        const std::vector<AxisWrite> writes{{0, exampleRequest(1)}, {1, exampleRequest(2)}};
        VERIFY_RESULT(planMultiAxis(fixture.compensator, std::span(writes).first(1)));
        const auto plans = planMultiAxis(fixture.compensator, writes);
        VERIFY_ERROR(plans, ErrorCode::NoFreeSlot);
        QCOMPARE(plans.error().context.english("ofAxis"), std::string("1"));
        QVERIFY2(
            sentence(plans.error()).find("axis 0, which is written first") != std::string::npos,
            sentence(plans.error()).c_str());
    }

    void aSlotIsNotNamedForTwoAxes()
    {
        CompensatorFixture fixture;
        std::vector<AxisWrite> writes{{0, exampleRequest(1)}, {1, exampleRequest(2)}};
        for (AxisWrite& write : writes)
            write.request.slot = "Small3";
        VERIFY_ERROR(planMultiAxis(fixture.compensator, writes), ErrorCode::SlotInUse);
    }

    void anAxisIsNotNamedTwice()
    {
        CompensatorFixture fixture;
        const std::vector<AxisWrite> writes{{1, exampleRequest(1)}, {1, exampleRequest(2)}};
        VERIFY_ERROR(planMultiAxis(fixture.compensator, writes), ErrorCode::InvalidArgument);
    }

    void theErrorOfOneAxisIsThatOfAllAndNamesIt()
    {
        CompensatorFixture fixture;
        WriteRequest wrong = exampleRequest(2);
        wrong.sources.pop_back();
        const std::vector<AxisWrite> writes{{0, exampleRequest(1)}, {1, wrong}};
        const auto plans = planMultiAxis(fixture.compensator, writes);
        VERIFY_ERROR(plans, ErrorCode::SourceMissing);
        QCOMPARE(plans.error().context.english("ofAxis"), std::string("1"));
    }

    void aTableThatIsStoredInTheSameRunIsNotSaidToBeLost()
    {
        CompensatorFixture fixture;
        for (const int axis : {0, 1})
            VERIFY_RESULT(fixture.compensator.write(axis, exampleRequest(axis + 1)));
        std::vector<AxisWrite> writes{{0, exampleRequest(1, Persistency::Persistent)},
            {1, exampleRequest(2, Persistency::Persistent)}};
        const auto stored = planMultiAxis(fixture.compensator, writes);
        VERIFY_RESULT(stored);
        QVERIFY(!saysThatATableIsLost(stored->at(0)));
        QVERIFY(!saysThatATableIsLost(stored->at(1)));
        writes[1].request.persistency = Persistency::Volatile;
        const auto lost = planMultiAxis(fixture.compensator, writes);
        VERIFY_RESULT(lost);
        QVERIFY(saysThatATableIsLost(lost->at(0)));
    }

    /// What is carried out knows of the other writes as its plan did.
    void whatIsRestoredInTheSameRunIsNotSaidToBeLost()
    {
        CompensatorFixture fixture;
        for (const int axis : {0, 1})
            VERIFY_RESULT(
                fixture.compensator.write(axis, exampleRequest(axis + 1, Persistency::Persistent)));
        const auto backup = fixture.compensator.backup();
        VERIFY_RESULT(backup);
        fixture.pass(std::chrono::hours(48));
        for (const int axis : {0, 1})
            VERIFY_RESULT(fixture.compensator.write(axis, exampleRequest(axis + 3)));
        const auto planned = fixture.compensator.planRestore(*backup, false);
        VERIFY_RESULT(planned);
        const auto done = fixture.compensator.restore(*backup, false);
        VERIFY_RESULT(done);
        QCOMPARE(done->axes.size(), std::size_t(2));
        for (const std::size_t n : {0, 1}) {
            QVERIFY(!saysThatATableIsLost(planned->axes.at(n)));
            QVERIFY(!saysThatATableIsLost(done->axes.at(n).plan));
        }
    }

    void whatIsWrittenInTheSameRunIsNotSaidToBeLost()
    {
        CompensatorFixture fixture;
        std::vector<AxisTable> tables(2);
        for (const int axis : {0, 1}) {
            VERIFY_RESULT(fixture.compensator.write(axis, exampleRequest(axis + 1)));
            AxisTable& table = tables.at(static_cast<std::size_t>(axis));
            table.axis = axis;
            table.request = exampleRequest(axis + 3, Persistency::Persistent);
        }
        std::atomic<std::size_t> turn = 0;
        const auto end = writeTables(fixture.compensator, fixture.storeRoot(), 0, tables, turn, {});
        VERIFY_RESULT(end.outcome);
        QCOMPARE(end.outcome->writes.size(), std::size_t(2));
        for (const auto& write : end.outcome->writes) {
            VERIFY_RESULT(write);
            QVERIFY(!saysThatATableIsLost(write->plan));
        }
    }

    void nothingIsWrittenAfterTheFirstThatFails()
    {
        CompensatorFixture fixture;
        const std::vector<AxisWrite> writes{{0, exampleRequest(1)}, {1, exampleRequest(2)}};
        const auto plans = planMultiAxis(fixture.compensator, writes);
        VERIFY_RESULT(plans);
        std::vector<std::size_t> begun;
        const auto reports = writeInTurn(
            writes, *plans, [&begun](std::size_t n, const WriteRequest&) -> Result<WriteReport> {
                begun.push_back(n);
                return fail(ErrorCode::Timeout, {{"milliseconds", 1}});
            });
        QVERIFY(begun == std::vector<std::size_t>{0});
        QCOMPARE(reports.size(), std::size_t(1));
        VERIFY_ERROR(reports.front(), ErrorCode::Timeout);
    }

    /// It is not yet when the second write is planned.
    void aTableThatTheRunMakesVolatileIsSaidToBeLost()
    {
        CompensatorFixture fixture;
        VERIFY_RESULT(fixture.compensator.write(0, exampleRequest(1, Persistency::Persistent)));
        const std::vector<AxisWrite> writes{
            {0, exampleRequest(2)}, {1, exampleRequest(3, Persistency::Persistent)}};
        const auto plans = planMultiAxis(fixture.compensator, writes);
        VERIFY_RESULT(plans);
        QVERIFY(saysThatATableIsLost(plans->at(1)));
        for (const AxisWrite& write : writes)
            VERIFY_RESULT(fixture.compensator.write(write.axis, write.request));
        fixture.drive.reboot();
        QVERIFY(fixture.state(0).table.empty());
    }

    void theFlashOperationsOfAllAreCountedTogether()
    {
        CompensatorFixture fixture;
        const int limit = drivecomm::genericProfile().flashWear.operations;
        for (int n = 0; n + 1 < limit; ++n)
            VERIFY_RESULT(
                fixture.compensator.write(0, exampleRequest(10 + n, Persistency::Persistent)));
        const std::vector<AxisWrite> one{{0, exampleRequest(1, Persistency::Persistent)}};
        VERIFY_RESULT(planMultiAxis(fixture.compensator, one));
        const std::vector<AxisWrite> two{{0, exampleRequest(1, Persistency::Persistent)},
            {1, exampleRequest(2, Persistency::Persistent)}};
        const auto plans = planMultiAxis(fixture.compensator, two);
        VERIFY_ERROR(plans, ErrorCode::FlashWear);
        const std::string seconds = plans.error().context.english("seconds");
        QVERIFY(std::stoi(seconds) > 0);
        QCOMPARE(QString::fromStdString(sentence(plans.error())),
            QString::fromStdString("together these changes cost 2 flash operations, more than are "
                                   "possible now; wait "
                + seconds + " s, or make fewer changes at a time"));
        fixture.pass(std::chrono::seconds(std::stoi(seconds)));
        VERIFY_RESULT(planMultiAxis(fixture.compensator, two));
    }
};

AXISCOMP_TEST(TestSeveralWrites)

} // namespace tst_multiaxiswrite

#include "tst_multiaxiswrite.moc"
