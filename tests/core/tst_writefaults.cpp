// SPDX-License-Identifier: GPL-3.0-or-later
//
// A write is run once to count its exchanges with the drive, then again for every exchange and
// every fault. The rows follow from the write itself: a new step is covered without touching this
// file.
#include "tests/support/drive_fixture.h"
#include "tests/support/verify.h"

#include <QTest>

using namespace axiscomp;
using axiscomp::test::DriveFixture;
using axiscomp::test::exampleRequest;
using axiscomp::test::exampleTable;
using axiscomp::test::LinkFault;

namespace {

struct Scenario {
    const char* name;
    Persistency before; ///< of the old table
    Persistency after;
    bool hasOldTable;
    bool isSlotFree;
    bool keepsTable; ///< only persistency and sources change
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
};

struct NamedFault {
    const char* name;
    LinkFault fault;
};
constexpr std::array faults{
    NamedFault{"request lost", LinkFault::RequestLost},
    NamedFault{"reply lost", LinkFault::ReplyLost},
    NamedFault{"reply garbled", LinkFault::ReplyGarbled},
    NamedFault{"refused", LinkFault::Refused},
    NamedFault{"drive gone", LinkFault::DriveGone},
    NamedFault{"drive gone after", LinkFault::DriveGoneAfter},
    NamedFault{"drive reboots", LinkFault::Reboot},
    NamedFault{"stores wrong", LinkFault::StoresWrong},
    NamedFault{"user stops", LinkFault::UserStops},
};

/// A drive in the state before the write, and the write.
struct Case : DriveFixture {
    explicit Case(const Scenario& chosen)
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
        old = state();
        options.stop = stop.get_token();
        link.stopUser = [this] { stop.request_stop(); };
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

    Result<WriteReport> write() { return compensator.write(0, request, options); }

    State old;
    WriteRequest request;
    std::stop_source stop;
    OperationOptions options;
};

} // namespace

class TestWriteFaults : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aWriteThatFailsLeavesTheOldOrTheNewState_data()
    {
        QTest::addColumn<int>("scenario");
        QTest::addColumn<int>("fault");
        for (std::size_t s = 0; s < scenarios.size(); ++s) {
            for (std::size_t f = 0; f < faults.size(); ++f)
                QTest::addRow("%s: %s", scenarios[s].name, faults[f].name)
                    << static_cast<int>(s) << static_cast<int>(f);
        }
    }

    void aWriteThatFailsLeavesTheOldOrTheNewState()
    {
        QFETCH(int, scenario);
        QFETCH(int, fault);
        const Scenario& chosen = scenarios[static_cast<std::size_t>(scenario)];
        const LinkFault kind = faults[static_cast<std::size_t>(fault)].fault;

        Case whole(chosen);
        const int begin = whole.link.exchanges();
        VERIFY_RESULT(whole.write());
        const int exchanges = whole.link.exchanges() - begin;
        QVERIFY(exchanges > 5);
        const DriveFixture::State wanted = whole.state();
        whole.drive.reboot();
        const DriveFixture::State wantedAfterReboot = whole.state();

        for (int exchange = 1; exchange <= exchanges; ++exchange) {
            Case c(chosen);
            const DriveFixture::State oldAfterReboot = afterReboot(chosen);
            c.link.failAt(exchange, kind);
            const auto report = c.write();
            c.link.heal();
            const DriveFixture::State now = c.state();

            const std::string said = report ? "success" : test::describe(report.error());
            const auto where = [&](const char* what) {
                return QByteArray("exchange ") + QByteArray::number(exchange) + " of "
                    + QByteArray::number(exchanges) + ": " + what + "; the program said "
                    + said.c_str() + "; Table is " + now.registers[0].c_str();
            };
            const bool isOld = now == c.old;
            const bool isNew = now == wanted;
            const bool isRebooted =
                kind == LinkFault::Reboot && (now == oldAfterReboot || now == wantedAfterReboot);
            const bool isSwitchedOff = now.registers[0] == "Disabled";
            QVERIFY2(c.text("Axes[0]/Signals/Compensations/Axis/State") == "Disabled",
                where("the compensation is on"));
            if (report) {
                QVERIFY2(isNew, where("it is not the new state"));
            } else if (report.error().code == ErrorCode::RollbackFailed) {
                QVERIFY2(!chosen.isSlotFree || kind == LinkFault::Reboot,
                    where("a roll-back failed although the old table was never touched"));
                QVERIFY2(isSwitchedOff || isOld || isNew || isRebooted,
                    where("it is a mixture that could be activated"));
            } else if (report.error().code == ErrorCode::OutcomeUnknown) {
                QVERIFY2(isOld || isNew || isRebooted, where("it is neither old nor new"));
            } else {
                QVERIFY2(isOld || isRebooted, where("it is not the old state"));
            }

            // Whatever happened, the next write needs no help.
            const auto again = c.compensator.write(0, fullRequest(chosen));
            const bool isDone = again || again.error().code == ErrorCode::NothingToWrite;
            QVERIFY2(isDone, where(again ? "" : test::describe(again.error()).c_str()));
        }
    }

    void theNextRunSaysWhichStateAnInterruptedWriteLeft_data()
    {
        aWriteThatFailsLeavesTheOldOrTheNewState_data();
    }

    void theNextRunSaysWhichStateAnInterruptedWriteLeft()
    {
        QFETCH(int, scenario);
        QFETCH(int, fault);
        const Scenario& chosen = scenarios[static_cast<std::size_t>(scenario)];
        const LinkFault kind = faults[static_cast<std::size_t>(fault)].fault;
        if (kind != LinkFault::DriveGone && kind != LinkFault::DriveGoneAfter)
            return;
        Case whole(chosen);
        const int begin = whole.link.exchanges();
        VERIFY_RESULT(whole.write());
        const int exchanges = whole.link.exchanges() - begin;
        const DriveFixture::State wanted = whole.state();

        for (int exchange = 1; exchange <= exchanges; ++exchange) {
            Case c(chosen);
            c.link.failAt(exchange, kind);
            const auto report = c.write();
            c.link.heal();
            const auto status = c.compensator.status(0);
            VERIFY_RESULT(status);
            if (!status->unfinishedWrite)
                continue;
            const auto outcome = c.compensator.settleUnfinished(*status->unfinishedWrite);
            VERIFY_RESULT(outcome);
            using Outcome = AxisCompensator::UnfinishedOutcome;
            const DriveFixture::State now = c.state();
            const QByteArray where = "exchange " + QByteArray::number(exchange);
            switch (*outcome) {
            case Outcome::Old:
                QVERIFY2(now == c.old, where);
                break;
            case Outcome::New:
            case Outcome::NewUnsaved:
                QVERIFY2(now == wanted, where);
                break;
            case Outcome::Neither:
                QVERIFY2(now != c.old && now != wanted, where);
                QVERIFY2(!chosen.isSlotFree, where + ": the old table was not touched");
                break;
            }
        }
    }

private:
    static DriveFixture::State afterReboot(const Scenario& chosen)
    {
        Case c(chosen);
        c.drive.reboot();
        return c.state();
    }

    /// The new state described completely, for a drive that may have lost its table.
    static WriteRequest fullRequest(const Scenario& chosen)
    {
        WriteRequest request = exampleRequest(chosen.keepsTable ? 1 : 2, chosen.after);
        if (chosen.keepsTable)
            std::swap(request.sources[0], request.sources[1]);
        return request;
    }
};

QTEST_GUILESS_MAIN(TestWriteFaults)
#include "tst_writefaults.moc"
