// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/drive_store.h"
#include "core/store/trusted_certificates.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTemporaryDir>

#include <array>
#include <csignal>
#include <random>

#include <sys/wait.h>
#include <unistd.h>

namespace tst_storekills {

using namespace axiscomp;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

constexpr int programs = 4;
constexpr std::int32_t shared = 1559; ///< the drive that all of them use

/// One of several programs: keeps things until it is killed, and says after each what it has kept.
[[noreturn]] void keepThings(const fs::path& root, int program, int begin, int pipe)
{
    const WallTime time{};
    for (int step = begin;;) {
        DriveStore store(root, 60s);
        for (int i = 0; i < 5; ++i, ++step) { // and opens it anew
            JournalEntry entry;
            entry.serialNumber = shared;
            entry.axis = program;
            entry.step = std::to_string(step);
            const bool isKept = store.openJournal(entry) && store.recordFlash(shared, time, 1)
                && store.recordFlash(program, time, 1)
                && store.recordOwnTable(shared, program,
                    {"slot" + std::to_string(program), static_cast<std::uint32_t>(step)})
                && TrustedCertificates(root, 60s).trust(
                    "https://" + std::to_string(program), std::string(64, '0'));
            if (!isKept || ::write(pipe, &step, sizeof step) != sizeof step)
                ::_exit(1);
        }
    }
}

class KilledProgram {
public:
    KilledProgram(fs::path root, int number) : m_root(std::move(root)), m_number(number) { }

    void start()
    {
        std::array<int, 2> ends{};
        QCOMPARE(::pipe(ends.data()), 0);
        m_process = ::fork();
        if (m_process == 0)
            keepThings(m_root, m_number, m_last + 1, ends[1]);
        ::close(ends[1]);
        m_pipe = ends[0];
    }
    void kill()
    {
        ::kill(m_process, SIGKILL);
        int status = 0;
        ::waitpid(m_process, &status, 0);
        QVERIFY2(WIFSIGNALED(status), "the program ended by itself: something could not be kept");
        for (int step = 0; ::read(m_pipe, &step, sizeof step) == sizeof step;) {
            m_last = step;
            ++m_steps;
        }
        ::close(m_pipe);
        ++m_kills;
        check();
    }
    [[nodiscard]] int steps() const { return m_steps; }
    [[nodiscard]] int kills() const { return m_kills; }

private:
    /// A step that was begun may be there, completely or not; one that was reported is.
    void check()
    {
        DriveStore store(m_root, 60s);
        const auto entry = store.journal(shared, m_number);
        VERIFY_RESULT(entry);
        const int there = *entry ? std::stoi((*entry)->step) : 0;
        QVERIFY2(there == m_last || there == m_last + 1, std::to_string(there).c_str());
        const auto history = store.flashHistory(m_number);
        VERIFY_RESULT(history);
        const auto total = static_cast<int>(history->total);
        QVERIFY2(total >= m_steps && total <= m_steps + m_kills, std::to_string(total).c_str());
        QVERIFY(!history->damagedRecord);
        const auto own = store.ownTables(shared, m_number);
        VERIFY_RESULT(own);
        const int newest = own->empty() ? 0 : static_cast<int>(own->front().crc);
        QVERIFY2(newest == m_last || newest == m_last + 1, std::to_string(newest).c_str());
    }

    fs::path m_root;
    int m_number;
    pid_t m_process = -1;
    int m_pipe = -1;
    int m_last = 0; ///< the last step that was reported
    int m_steps = 0;
    int m_kills = 0;
};

} // namespace

/// Four programs use one store and are killed (kill -9) at random moments. AXISCOMP_STORE_KILLS
/// says how many times, AXISCOMP_STORE_SEED which moments.
class TestStoreKills final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }
    void nothingIsLostAndNothingIsWrong();
};

void TestStoreKills::nothingIsLostAndNothingIsWrong()
{
    const int kills = std::max(qEnvironmentVariableIntValue("AXISCOMP_STORE_KILLS"), 40);
    std::mt19937 random(static_cast<unsigned>(qEnvironmentVariableIntValue("AXISCOMP_STORE_SEED")));
    const QTemporaryDir folder;
    const fs::path root = fs::path(folder.path().toStdString()) / "state";
    std::vector<KilledProgram> running;
    for (int number = 0; number < programs; ++number)
        running.emplace_back(root, number);
    for (KilledProgram& program : running)
        program.start();
    for (int i = 0; i < kills && !QTest::currentTestFailed(); ++i) {
        ::usleep(std::uniform_int_distribution<useconds_t>(0, 60'000)(random));
        KilledProgram& program = running[random() % running.size()];
        program.kill();
        program.start();
    }
    int steps = 0;
    int allKills = 0;
    for (KilledProgram& program : running) {
        program.kill();
        steps += program.steps();
        allKills += program.kills();
    }
    qInfo("%d kills, %d steps", allKills, steps);
    QVERIFY(steps > 0);
    const auto total = static_cast<int>(DriveStore(root).flashHistory(shared)->total);
    QVERIFY2(total >= steps && total <= steps + allKills, std::to_string(total).c_str());
    for (const auto& entry : fs::directory_iterator(root))
        QVERIFY(entry.path().filename().string().find("damaged") == std::string::npos);
}

AXISCOMP_TEST(TestStoreKills)

} // namespace tst_storekills

#include "tst_storekills.moc"
