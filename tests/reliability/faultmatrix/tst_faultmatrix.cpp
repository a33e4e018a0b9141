// SPDX-License-Identifier: GPL-3.0-or-later
//
// A write is run once to count its steps, then again with every fault at every step, over every
// link. The cases follow from the write itself: a new step is covered without touching this file.
#include "tests/reliability/faultmatrix/fault_matrix.h"
#include "tests/reliability/faultmatrix/killed_program.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"
#include "tests/support/wire_attachments.h"

#include <cstdio>
#include <deque>

namespace tst_faultmatrix {

using namespace axiscomp;
using namespace axiscomp::test;

namespace {

constexpr std::uint32_t longTable = 24; ///< points of each dimension: several blocks of a transfer
constexpr std::size_t cutPositions = 200;
constexpr std::array<std::size_t, 2> cutScenarios{
    3, 6}; ///< persistent, into a free slot and in place
constexpr int waitingThreads = 8;

const std::vector<AttachmentKind>& attachments()
{
    static const std::vector<AttachmentKind> all{inProcess(), web(), serial()};
    return all;
}

std::string report(const std::vector<std::string>& wrong)
{
    constexpr std::size_t most = 12;
    std::string text = std::to_string(wrong.size()) + " cases went wrong:";
    for (std::size_t i = 0; i < std::min(wrong.size(), most); ++i)
        text += "\n  " + wrong[i];
    return text;
}

void addRows(std::span<const MatrixFault> faults, std::size_t firstAttachment)
{
    QTest::addColumn<int>("attachment");
    QTest::addColumn<int>("fault");
    for (std::size_t a = firstAttachment; a < attachments().size(); ++a)
        for (std::size_t f = 0; f < faults.size(); ++f)
            QTest::addRow("%s: %s", attachments()[a].name, faults[f].name)
                << static_cast<int>(a) << static_cast<int>(f);
}

} // namespace

class TestFaultMatrix : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init() { failOnWarnings(); }
    void cleanupTestCase();

    void everyExchangeLeavesTheOldOrTheNewState_data() { addRows(exchangeFaults(), 0); }
    void everyExchangeLeavesTheOldOrTheNewState() { runRow(exchangeFaults()); }
    void everyExchangeOfPuttingBackCanFail_data();
    void everyExchangeOfPuttingBackCanFail();
    void everyRequestLeavesTheOldOrTheNewState_data() { addRows(wireFaults(), 1); }
    void everyRequestLeavesTheOldOrTheNewState() { runRow(wireFaults()); }
    void aCutTransferLeavesTheOldOrTheNewState_data();
    void aCutTransferLeavesTheOldOrTheNewState();
    void aKilledProgramLeavesTheOldOrTheNewState_data();
    void aKilledProgramLeavesTheOldOrTheNewState();

private:
    void runRow(std::span<const MatrixFault> faults);
    const RecordedWrite& recorded(std::size_t attachment, std::size_t scenario);
    void finish(
        const std::vector<MatrixCase>& cases, const AttachmentKind& kind, const char* fault);

    MatrixChoice m_choice = MatrixChoice::ofEnvironment();
    std::vector<HeldStates> m_states; ///< by scenario
    std::map<std::pair<std::size_t, std::size_t>, RecordedWrite> m_recorded;
    MatrixTable m_table;
};

void TestFaultMatrix::initTestCase()
{
    for (const WriteScenario& scenario : writeScenarios()) {
        m_states.push_back(heldStatesOf(scenario));
        QVERIFY2(m_states.back().old != m_states.back().wanted, scenario.name);
    }
}

void TestFaultMatrix::cleanupTestCase()
{
    std::vector<std::string> names;
    for (const AttachmentKind& kind : attachments())
        names.emplace_back(kind.name);
    const std::string which = m_choice.isAll()
        ? "all of them"
        : "a part of them (seed " + std::to_string(m_choice.seed()) + ")";
    std::printf(
        "%s\n%zu cases: %s\n", m_table.markdown(names).c_str(), m_table.total(), which.c_str());
    std::fflush(stdout);
}

const RecordedWrite& TestFaultMatrix::recorded(std::size_t attachment, std::size_t scenario)
{
    const auto [place, isNew] = m_recorded.try_emplace({attachment, scenario});
    if (isNew)
        place->second = recordWrite(writeScenarios()[scenario], attachments()[attachment]);
    return place->second;
}

void TestFaultMatrix::runRow(std::span<const MatrixFault> faults)
{
    QFETCH(int, attachment);
    QFETCH(int, fault);
    const auto a = static_cast<std::size_t>(attachment);
    const auto f = static_cast<std::size_t>(fault);
    const AttachmentKind& kind = attachments()[a];
    std::vector<MatrixCase> cases;
    for (std::size_t s = 0; s < writeScenarios().size(); ++s) {
        const WriteScenario& scenario = writeScenarios()[s];
        const RecordedWrite& write = recorded(a, s);
        QVERIFY2(write.wrong.empty(), write.wrong.c_str());
        const int steps = faults[f].step == MatrixFault::Step::Exchange ? write.exchanges
            : faults[f].step == MatrixFault::Step::Request              ? write.requests
                                                                        : write.writeRequests;
        QVERIFY(steps > 0 && write.exchanges > 5);
        for (int at = 1; at <= steps; ++at) {
            const std::size_t number = static_cast<std::size_t>(at) + s + f;
            // In process every step meets one fault in nine. Over a wire a quarter of the steps of
            // each scenario, each with one fault; together all of them.
            const bool isFew = faults[f].step == MatrixFault::Step::WriteRequest;
            const bool isChosenOnWire = (isFew || m_choice.has(number, faults.size()))
                && m_choice.has(static_cast<std::size_t>(at) + 2 * s, 4);
            if (a == 0 ? !m_choice.has(number, 9) : !isChosenOnWire)
                continue;
            const std::size_t afterwards = number / faults.size() + number;
            for (std::size_t n = 0; n < (m_choice.isAll() && a == 0 ? 4U : 1U); ++n)
                cases.push_back({std::string(scenario.name) + ", step " + std::to_string(at)
                        + " of " + std::to_string(steps) + ", aftermath "
                        + std::to_string((afterwards + n) % 4),
                    [this, &scenario, &kind, &fault = faults[f], s, at, afterwards, n] {
                        return runCase(scenario, kind, m_states[s], fault, at,
                            aftermathOf((afterwards + n) % 4));
                    }});
        }
    }
    finish(cases, kind, faults[f].name);
}

void TestFaultMatrix::finish(
    const std::vector<MatrixCase>& cases, const AttachmentKind& kind, const char* fault)
{
    QVERIFY(!cases.empty());
    const int threads = &kind == &attachments().front() ? 2 : waitingThreads;
    const auto wrong = runCases(cases, threads);
    QVERIFY2(wrong.empty(), report(wrong).c_str());
    m_table.add(fault, kind.name, cases.size());
}

void TestFaultMatrix::everyExchangeOfPuttingBackCanFail_data()
{
    QTest::addColumn<int>("fault");
    QTest::newRow("drive gone while putting back") << static_cast<int>(LinkFault::DriveGone);
    QTest::newRow("drive gone after the request while putting back")
        << static_cast<int>(LinkFault::DriveGoneAfter);
}

void TestFaultMatrix::everyExchangeOfPuttingBackCanFail()
{
    QFETCH(int, fault);
    std::vector<MatrixCase> cases;
    for (std::size_t s = 0; s < writeScenarios().size(); ++s) {
        const RecordedWrite& write = recorded(0, s);
        QVERIFY2(write.wrong.empty(), write.wrong.c_str());
        QVERIFY(write.exchangesToPutBack > 0);
        for (int at = 1; at <= write.exchangesToPutBack; ++at)
            for (std::size_t n = 0; n < 4; ++n) {
                if (!m_choice.has(static_cast<std::size_t>(at) + s + n, 6))
                    continue;
                cases.push_back({std::string(writeScenarios()[s].name) + ", step "
                        + std::to_string(at) + " of " + std::to_string(write.exchangesToPutBack)
                        + ", aftermath " + std::to_string(n),
                    [this, &write, s, at, n, kind = static_cast<LinkFault>(fault)] {
                        return runCase(writeScenarios()[s], attachments()[0], m_states[s],
                            whilePuttingBack(kind, write.exchanges), at, aftermathOf(n));
                    }});
            }
    }
    finish(cases, attachments()[0], QTest::currentDataTag());
}

void TestFaultMatrix::aCutTransferLeavesTheOldOrTheNewState_data()
{
    QTest::addColumn<int>("attachment");
    QTest::addColumn<bool>("isReadBack");
    for (std::size_t a = 1; a < attachments().size(); ++a) {
        QTest::addRow("%s: upload", attachments()[a].name) << static_cast<int>(a) << false;
        QTest::addRow("%s: read-back", attachments()[a].name) << static_cast<int>(a) << true;
    }
}

void TestFaultMatrix::aCutTransferLeavesTheOldOrTheNewState()
{
    QFETCH(int, attachment);
    QFETCH(bool, isReadBack);
    const AttachmentKind& kind = attachments()[static_cast<std::size_t>(attachment)];
    struct Cut {
        const WriteScenario* scenario;
        HeldStates states;
        MatrixFault fault;
    };
    std::deque<Cut> cuts; // stay where they are while cases name them
    std::vector<MatrixCase> cases;
    for (const std::size_t s : cutScenarios) {
        const WriteScenario& scenario = writeScenarios()[s];
        const RecordedWrite write = recordWrite(scenario, kind, longTable);
        QVERIFY2(write.wrong.empty(), write.wrong.c_str());
        const RecordedWrite::Transfer& transfer = isReadBack ? write.readBack : write.upload;
        QVERIFY(transfer.exchange > 0 && transfer.bytes > cutPositions);
        cuts.push_back({&scenario, heldStatesOf(scenario, longTable), cutIn(transfer.exchange)});
        for (std::size_t n = 0; n < cutPositions; ++n) {
            const bool isEdge = n < 2 || n + 2 >= cutPositions;
            if (!isEdge && !m_choice.has(n + s, 24))
                continue;
            const auto byte = static_cast<int>(1 + n * (transfer.bytes - 1) / (cutPositions - 1));
            cases.push_back({std::string(scenario.name) + ", byte " + std::to_string(byte) + " of "
                    + std::to_string(transfer.bytes),
                [&kind, &cut = cuts.back(), byte, n] {
                    return runCase(*cut.scenario, kind, cut.states, cut.fault, byte,
                        aftermathOf(n / 16), longTable);
                }});
        }
    }
    finish(cases, kind, isReadBack ? "read-back cut at a byte" : "upload cut at a byte");
}

void TestFaultMatrix::aKilledProgramLeavesTheOldOrTheNewState_data()
{
    QTest::addColumn<int>("attachment");
    QTest::addColumn<bool>("isRequestLost");
    for (std::size_t a = 1; a < attachments().size(); ++a) {
        QTest::addRow("%s: carried out", attachments()[a].name) << static_cast<int>(a) << false;
        QTest::addRow("%s: not carried out", attachments()[a].name) << static_cast<int>(a) << true;
    }
}

void TestFaultMatrix::aKilledProgramLeavesTheOldOrTheNewState()
{
    QFETCH(int, attachment);
    QFETCH(bool, isRequestLost);
    const AttachmentKind& kind = attachments()[static_cast<std::size_t>(attachment)];
    std::vector<KilledProgram> programs;
    std::vector<RecordedProgram> recorded;
    for (const WriteScenario& scenario : writeScenarios()) {
        if (scenario.isOneByOne) // the program takes a profile for that
            continue;
        programs.push_back({&scenario, kind, isRequestLost});
        recorded.push_back(recordProgram(programs.back()));
        QVERIFY2(recorded.back().wrong.empty(), recorded.back().wrong.c_str());
        QVERIFY(recorded.back().requests > 5);
    }
    const std::size_t scenarios = programs.size();
    std::vector<MatrixCase> cases;
    for (std::size_t s = 0; s < scenarios; ++s) {
        for (int at = 1; at <= recorded[s].requests; ++at) {
            // Each request ends one of the programs, over one of the links, carried out or not.
            const std::size_t number = static_cast<std::size_t>(at) + s
                + (isRequestLost ? scenarios : 0)
                + 2 * scenarios * static_cast<std::size_t>(attachment - 1);
            if (!m_choice.has(number, 4 * scenarios))
                continue;
            cases.push_back({std::string(programs[s].scenario->name) + ", request "
                    + std::to_string(at) + " of " + std::to_string(recorded[s].requests),
                [&, s, at] { return runKilled(programs[s], recorded[s], at); }});
        }
    }
    finish(cases, kind,
        isRequestLost ? "program killed, request not carried out"
                      : "program killed, request carried out");
}

AXISCOMP_TEST(TestFaultMatrix)

} // namespace tst_faultmatrix

#include "tst_faultmatrix.moc"
