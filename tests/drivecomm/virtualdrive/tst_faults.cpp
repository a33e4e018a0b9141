// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/direct_link.h"
#include "drivecomm/virtualdrive/faults.h"
#include "tests/drivecomm/virtualdrive/drive_fixture.h"
#include "tests/support/test_registry.h"

#include <future>
#include <numeric>
#include <thread>

namespace tst_faults {

using namespace axiscomp;
using namespace axiscomp::test;
using drivecomm::FaultPlan;
using drivecomm::FaultSpec;
using drivecomm::parseFault;

/// Named faults, their plan, and what the direct link makes of them.
class TestFaults : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void parses_data();
    void parses();
    void refuses_data();
    void refuses();
    void happensAtItsRequestOnly_data();
    void happensAtItsRequestOnly();
    void countsWritesApart();
    void slowAndRejectStay();
    void whoeverReceivedBytesFindsThemCounted();
    void dropIsSpentByItsBytes();
    void clearStartsAgain();
    void countsOverAllThreads();
    void tellsItsObserver();
    void directLinkFails_data();
    void directLinkFails();
    void directLinkCutsOnce();
    void directLinkHasNoFaultsUnlessAsked();
};

void TestFaults::parses_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("kind");
    QTest::addColumn<quint64>("number");
    QTest::addColumn<QString>("code");
    const auto row = [](const char* text, FaultSpec::Kind kind, quint64 number, const char* code) {
        QTest::newRow(text) << text << static_cast<int>(kind) << number << code;
    };
    row("drop-after=1", FaultSpec::Kind::DropAfter, 1, "");
    row("no-reply=7", FaultSpec::Kind::NoReply, 7, "");
    row("garble=3", FaultSpec::Kind::Garble, 3, "");
    row("stores-wrong=2", FaultSpec::Kind::StoresWrong, 2, "");
    row("slow=600000", FaultSpec::Kind::Slow, 600000, "");
    row("reboot-after=12", FaultSpec::Kind::RebootAfter, 12, "");
    row("reject=FlashWear", FaultSpec::Kind::Reject, 0, "FlashWear");
    row("reject=NotAllowedNow", FaultSpec::Kind::Reject, 0, "NotAllowedNow");
}

void TestFaults::parses()
{
    QFETCH(QString, text);
    QFETCH(int, kind);
    QFETCH(quint64, number);
    QFETCH(QString, code);
    const auto fault = parseFault(text.toStdString());
    VERIFY_RESULT(fault);
    QCOMPARE(static_cast<int>(fault->kind), kind);
    QCOMPARE(fault->number, number);
    COMPARE_TEXT(fault->code, code.toStdString());
}

void TestFaults::refuses_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("hint"); // what the sentence names
    QTest::newRow("empty") << ""
                           << "reboot-after=N";
    QTest::newRow("no value") << "slow"
                              << "slow=MS";
    QTest::newRow("unknown") << "explode=1"
                             << "drop-after=BYTES";
    QTest::newRow("another case") << "Slow=1"
                                  << "slow=MS";
    QTest::newRow("no number") << "slow="
                               << "slow";
    QTest::newRow("zero") << "no-reply=0"
                          << "from 1";
    QTest::newRow("negative") << "garble=-1"
                              << "from 1";
    QTest::newRow("fraction") << "garble=1.5"
                              << "whole number";
    QTest::newRow("with a unit") << "slow=5s"
                                 << "whole number";
    QTest::newRow("too slow") << "slow=600001"
                              << "600000";
    QTest::newRow("too large") << "drop-after=99999999999999999999"
                               << "whole number";
    QTest::newRow("unknown code") << "reject=Never"
                                  << "NotAllowedNow";
    QTest::newRow("not of the drive") << "reject=Timeout"
                                      << "TableRefused";
}

void TestFaults::refuses()
{
    QFETCH(QString, text);
    QFETCH(QString, hint);
    const auto fault = parseFault(text.toStdString());
    VERIFY_ERROR(fault, ErrorCode::InvalidArgument);
    const std::string said = sentence(fault.error());
    QVERIFY2(said.find(hint.toStdString()) != std::string::npos, said.c_str());
}

void TestFaults::happensAtItsRequestOnly_data()
{
    QTest::addColumn<int>("kind");
    QTest::newRow("no-reply") << static_cast<int>(FaultSpec::Kind::NoReply);
    QTest::newRow("garble") << static_cast<int>(FaultSpec::Kind::Garble);
    QTest::newRow("reboot-after") << static_cast<int>(FaultSpec::Kind::RebootAfter);
}

void TestFaults::happensAtItsRequestOnly()
{
    QFETCH(int, kind);
    FaultPlan plan({{static_cast<FaultSpec::Kind>(kind), 3, {}}});
    for (int request = 1; request <= 6; ++request) {
        const FaultPlan::Decision decision = plan.next(request % 2 == 0);
        const bool expected = request == 3;
        QCOMPARE(decision.noReply || decision.garble || decision.reboot, expected);
        QVERIFY(!decision.storeWrong && !decision.rejectCode && decision.delay == 0ms);
    }
}

void TestFaults::countsWritesApart()
{
    FaultPlan plan({{FaultSpec::Kind::StoresWrong, 2, {}}});
    std::vector<bool> wrong;
    for (const bool isWrite : {false, true, false, true, false, true})
        wrong.push_back(plan.next(isWrite).storeWrong);
    QVERIFY((wrong == std::vector<bool>{false, false, false, true, false, false}));
}

void TestFaults::slowAndRejectStay()
{
    FaultPlan plan({{FaultSpec::Kind::Slow, 20, {}}, {FaultSpec::Kind::Slow, 5, {}},
        {FaultSpec::Kind::Reject, 0, "FlashWear"}});
    for (int request = 0; request < 3; ++request) {
        QCOMPARE(plan.next(false).delay, 25ms);
        QVERIFY(!plan.next(false).rejectCode);
        QVERIFY(plan.next(true).rejectCode == "FlashWear");
    }
}

/// Otherwise a recording of how much an exchange carries misses what was sent last.
void TestFaults::whoeverReceivedBytesFindsThemCounted()
{
    FaultPlan plan;
    plan.add({FaultSpec::Kind::DropAfter, 100, {}});
    std::future<std::optional<std::uint64_t>> asked;
    const auto first = plan.carry(60, [&](std::size_t size) {
        asked = std::async(std::launch::async, [&plan] { return plan.bytesUntilDrop(); });
        asked.wait_for(std::chrono::milliseconds(20));
        return static_cast<std::ptrdiff_t>(size);
    });
    QCOMPARE(first.bytes, std::ptrdiff_t{60});
    QVERIFY(!first.isCut);
    QVERIFY(asked.get() == 40U);
    const auto refused = plan.carry(60, [](std::size_t) { return std::ptrdiff_t{-1}; });
    QCOMPARE(refused.bytes, std::ptrdiff_t{-1});
    QVERIFY(!refused.isCut);
    const auto last =
        plan.carry(60, [](std::size_t size) { return static_cast<std::ptrdiff_t>(size); });
    QCOMPARE(last.bytes, std::ptrdiff_t{40});
    QVERIFY(last.isCut);
    QVERIFY(!plan.bytesUntilDrop());
}

void TestFaults::dropIsSpentByItsBytes()
{
    FaultPlan plan;
    QVERIFY(!plan.bytesUntilDrop());
    plan.countBytes(1000); // before the fault: does not count
    plan.add({FaultSpec::Kind::DropAfter, 300, {}});
    plan.add({FaultSpec::Kind::DropAfter, 100, {}});
    QVERIFY(plan.bytesUntilDrop() == 100U);
    plan.countBytes(99);
    QVERIFY(plan.bytesUntilDrop() == 1U);
    plan.countBytes(1); // the connection is cut here, and works again
    QVERIFY(plan.bytesUntilDrop() == 200U);
    plan.countBytes(5000);
    QVERIFY(!plan.bytesUntilDrop());
}

void TestFaults::clearStartsAgain()
{
    FaultPlan plan({{FaultSpec::Kind::Slow, 20, {}}});
    (void)plan.next(true);
    plan.clear();
    plan.add({FaultSpec::Kind::NoReply, 1, {}});
    const FaultPlan::Decision decision = plan.next(true);
    QVERIFY(decision.noReply);
    QCOMPARE(decision.delay, 0ms);
}

void TestFaults::countsOverAllThreads()
{
    constexpr int perThread = 2000;
    FaultPlan plan(
        {{FaultSpec::Kind::NoReply, 1234, {}}, {FaultSpec::Kind::DropAfter, 4 * perThread, {}}});
    std::array<int, 4> hits{};
    {
        std::vector<std::jthread> threads;
        for (int& hit : hits)
            threads.emplace_back([&plan, &hit] {
                for (int i = 0; i < perThread; ++i) {
                    hit += plan.next(false).noReply ? 1 : 0;
                    plan.countBytes(1);
                }
            });
    }
    QCOMPARE(std::accumulate(hits.begin(), hits.end(), 0), 1);
    QVERIFY(!plan.bytesUntilDrop());
}

void TestFaults::tellsItsObserver()
{
    std::vector<bool> seen;
    FaultPlan* changed = nullptr;
    FaultPlan plan({}, [&](bool isWrite) {
        seen.push_back(isWrite);
        if (isWrite)
            changed->add({FaultSpec::Kind::NoReply, 2, {}});
    });
    changed = &plan;
    QVERIFY(!plan.next(false).noReply);
    QVERIFY(plan.next(true).noReply); // what the observer adds counts for this request already
    QVERIFY((seen == std::vector<bool>{false, true}));
}

void TestFaults::directLinkFails_data()
{
    QTest::addColumn<QString>("fault");
    QTest::addColumn<int>("code"); // -1: no error
    QTest::addColumn<double>("variable"); // what the drive holds after a write of 2
    const auto row = [](const char* fault, int code, double variable) {
        QTest::newRow(fault) << fault << code << variable;
    };
    row("no-reply=2", static_cast<int>(ErrorCode::Timeout), 2.0);
    row("garble=2", static_cast<int>(ErrorCode::Protocol), 2.0);
    row("reboot-after=2", static_cast<int>(ErrorCode::ConnectionLost), 0.0);
    row("stores-wrong=1", -1, -2.0);
    row("slow=1", -1, 2.0);
    row("slow=5000", static_cast<int>(ErrorCode::Timeout), 2.0);
    row("reject=FlashWear", static_cast<int>(ErrorCode::FlashWear), 0.0);
    row("drop-after=350", static_cast<int>(ErrorCode::ConnectionLost), 0.0);
}

void TestFaults::directLinkFails()
{
    QFETCH(QString, fault);
    QFETCH(int, code);
    QFETCH(double, variable);
    DriveFixture bench;
    FaultPlan plan({parseFault(fault.toStdString()).value()});
    const auto link = drivecomm::makeDirectLink(*bench.drive, &plan);
    const std::vector<std::string> paths{variable0};
    if (fault != u"slow=5000")
        VERIFY_RESULT(link->readRegisters(paths, {}));
    const std::vector<RegisterWrite> writes{{variable0, 2.0F}};
    const auto written = link->writeRegisters(writes, {});
    if (code < 0)
        VERIFY_RESULT(written);
    else
        VERIFY_ERROR(written, static_cast<ErrorCode>(code));
    QCOMPARE(bench.number(variable0), variable);
}

void TestFaults::directLinkCutsOnce()
{
    DriveFixture bench;
    const Bytes file = bench.encoded(evenTable(2));
    FaultPlan plan({{FaultSpec::Kind::DropAfter, 500, {}}});
    const auto link = drivecomm::makeDirectLink(*bench.drive, &plan);
    VERIFY_ERROR(link->upload("tables/small1.TAMtbl", file, {}), ErrorCode::ConnectionLost);
    QVERIFY(bench.file("Small1").empty());
    VERIFY_RESULT(link->upload("tables/small1.TAMtbl", file, {}));
    QVERIFY(bench.file("Small1") == file);
}

void TestFaults::directLinkHasNoFaultsUnlessAsked()
{
    DriveFixture bench;
    const auto link = drivecomm::makeDirectLink(*bench.drive);
    const auto identity = link->identify({});
    VERIFY_RESULT(identity);
    QVERIFY((*identity == DriveIdentity{"Virtual-1", 100001, 2}));
    // more than one request holds
    std::vector<std::string> paths;
    for (int n = 0; n < 150; ++n)
        paths.push_back("Application/Variables/Floats[" + std::to_string(n) + "]");
    const auto read = link->readRegisters(paths, {});
    VERIFY_RESULT(read);
    QCOMPARE(read->size(), paths.size());
    COMPARE_TEXT(read->back().path, paths.back());
    paths.back() = "Application/Variables/Floats[256]";
    VERIFY_ERROR(link->readRegisters(paths, {}), ErrorCode::UnknownRegister);
    VERIFY_RESULT(link->readRegisters({}, {}));

    std::uint64_t done = 0;
    Exchange exchange;
    exchange.progress = [&done](std::uint64_t bytes, std::uint64_t) { done = bytes; };
    const Bytes file = bench.encoded(evenTable(1));
    VERIFY_RESULT(link->upload("tables/small1.TAMtbl", file, exchange));
    QCOMPARE(done, std::uint64_t{file.size()});
    const auto files = link->listFiles({});
    VERIFY_RESULT(files);
    QCOMPARE(files->front().size, static_cast<std::uint32_t>(file.size()));
    const auto back = link->download("tables/small1.TAMtbl", {});
    VERIFY_RESULT(back);
    QVERIFY(*back == file);
    VERIFY_ERROR(link->download("tables/small1", {}), ErrorCode::UnknownFile);
    const auto tree = link->readTree("Axes[0]", {});
    VERIFY_RESULT(tree);
    QVERIFY(tree->size() > 20);

    std::stop_source stop;
    stop.request_stop();
    Exchange stopped;
    stopped.stop = stop.get_token();
    VERIFY_ERROR(link->identify(stopped), ErrorCode::Cancelled);
}

AXISCOMP_TEST(TestFaults)

} // namespace tst_faults

#include "tst_faults.moc"
