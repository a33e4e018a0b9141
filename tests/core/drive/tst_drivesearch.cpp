// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive/drive_search.h"
#include "tests/support/scripted_link.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <condition_variable>
#include <mutex>
#include <set>
#include <thread>

namespace tst_drivesearch {

using namespace axiscomp;
using test::ScriptedLink;
using namespace std::chrono_literals;

namespace {

const DriveIdentity drive{"Triamec-616", 1559, 2};

Error failure(ErrorCode code)
{
    return {code, {}, {}};
}

std::vector<DriveCandidate> places(std::initializer_list<const char*> endpoints)
{
    std::vector<DriveCandidate> candidates;
    for (const char* endpoint : endpoints)
        candidates.push_back(
            {.endpoints = {endpoint}, .description = std::string("hardware of ") + endpoint});
    return candidates;
}

} // namespace

class TestDriveFinder : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnWarnings();
        m_answers.clear();
        m_asked.clear();
        m_otherRequests = 0;
    }

    void eachCandidateHasItsAnswerInItsPlace();
    void nothingButIdentifyIsSent();
    void aSilentPlaceDoesNotMakeTheOthersWait();
    void moreCandidatesThanThreads();
    void theSpeedsOfAPortAreTriedInTurnUntilOneAnswers();
    void aPortThatCannotBeOpenedIsTriedOnce();
    void nonsenseSaysMoreThanSilence();
    void stoppedItAsksNoMore();
    void noCandidatesNoSightings();
    void whatDoesNotListItsFilesAsADriveIsNotAskedWhoItIs();
    void noMoreAreAskedAtOnceThanWanted();

private:
    [[nodiscard]] DriveSearch search()
    {
        DriveSearch search;
        search.linkFactory =
            [this](const std::string& endpoint) -> Result<std::unique_ptr<DriveLink>> {
            ScriptedLink::Answer answer;
            {
                const std::lock_guard lock(m_mutex);
                m_asked.push_back(endpoint);
                answer = m_answers.at(endpoint);
            }
            return std::make_unique<ScriptedLink>(endpoint, answer, m_otherRequests);
        };
        return search;
    }
    void answers(const std::string& endpoint)
    {
        m_answers[endpoint] = [](const Exchange&) -> Result<DriveIdentity> { return drive; };
    }
    void fails(const std::string& endpoint, ErrorCode code)
    {
        m_answers[endpoint] = [code](const Exchange&) -> Result<DriveIdentity> {
            return fail(failure(code));
        };
    }

    std::mutex m_mutex;
    std::map<std::string, ScriptedLink::Answer> m_answers;
    std::vector<std::string> m_asked;
    std::atomic<int> m_otherRequests = 0;
};

void TestDriveFinder::eachCandidateHasItsAnswerInItsPlace()
{
    answers("a");
    fails("b", ErrorCode::NotConnected);
    answers("c");
    const auto candidates = places({"a", "b", "c"});
    std::set<std::string> sighted;
    DriveSearch all = search();
    all.sighted = [&](const DriveSighting& sighting) { sighted.insert(sighting.endpoint); };
    const auto sightings = findDrives(candidates, all);
    QCOMPARE(sightings.size(), std::size_t(3));
    VERIFY_RESULT(sightings[0].drive);
    QVERIFY(*sightings[0].drive == drive);
    VERIFY_ERROR(sightings[1].drive, ErrorCode::NotConnected);
    VERIFY_RESULT(sightings[2].drive);
    QCOMPARE(sightings[1].endpoint, std::string("b"));
    QCOMPARE(sightings[1].description, std::string("hardware of b"));
    QVERIFY(sighted == std::set<std::string>({"a", "b", "c"}));
}

void TestDriveFinder::nothingButIdentifyIsSent()
{
    answers("a");
    fails("b", ErrorCode::Protocol);
    static_cast<void>(findDrives(places({"a", "b"}), search()));
    QCOMPARE(m_otherRequests.load(), 0);
}

void TestDriveFinder::aSilentPlaceDoesNotMakeTheOthersWait()
{
    // Each waits for the other: asked one after the other, neither would ever answer.
    std::mutex mutex;
    std::condition_variable arrived;
    int waiting = 0;
    const auto meet = [&](const Exchange&) -> Result<DriveIdentity> {
        std::unique_lock lock(mutex);
        ++waiting;
        arrived.notify_all();
        if (!arrived.wait_for(lock, 30s, [&] { return waiting == 2; }))
            return fail(ErrorCode::Timeout);
        return drive;
    };
    m_answers["a"] = meet;
    m_answers["b"] = meet;
    for (const DriveSighting& sighting : findDrives(places({"a", "b"}), search()))
        VERIFY_RESULT(sighting.drive);
}

void TestDriveFinder::moreCandidatesThanThreads()
{
    std::vector<DriveCandidate> candidates;
    for (int i = 0; i < 100; ++i) {
        candidates.push_back({{std::to_string(i)}, {}});
        answers(std::to_string(i));
    }
    const auto sightings = findDrives(candidates, search());
    QCOMPARE(sightings.size(), std::size_t(100));
    for (std::size_t i = 0; i < sightings.size(); ++i) {
        QCOMPARE(sightings[i].endpoint, std::to_string(i));
        VERIFY_RESULT(sightings[i].drive);
    }
    QCOMPARE(m_asked.size(), std::size_t(100));
}

void TestDriveFinder::theSpeedsOfAPortAreTriedInTurnUntilOneAnswers()
{
    fails("115200", ErrorCode::Protocol);
    fails("921600", ErrorCode::Timeout);
    answers("460800");
    answers("57600");
    const std::vector<DriveCandidate> port{{{"115200", "921600", "460800", "57600"}, "USB"}};
    const auto sightings = findDrives(port, search());
    VERIFY_RESULT(sightings.front().drive);
    QCOMPARE(sightings.front().endpoint, std::string("460800"));
    QVERIFY(m_asked == std::vector<std::string>({"115200", "921600", "460800"}));
}

void TestDriveFinder::aPortThatCannotBeOpenedIsTriedOnce()
{
    fails("115200", ErrorCode::NotConnected);
    answers("921600");
    const auto sightings =
        findDrives(std::vector<DriveCandidate>{{{"115200", "921600"}, ""}}, search());
    VERIFY_ERROR(sightings.front().drive, ErrorCode::NotConnected);
    QCOMPARE(m_asked.size(), std::size_t(1));
}

void TestDriveFinder::nonsenseSaysMoreThanSilence()
{
    fails("1", ErrorCode::Timeout);
    fails("2", ErrorCode::Protocol);
    fails("3", ErrorCode::Timeout);
    const auto sightings = findDrives(std::vector<DriveCandidate>{{{"1", "2", "3"}, ""}}, search());
    VERIFY_ERROR(sightings.front().drive, ErrorCode::Protocol);
    QCOMPARE(sightings.front().endpoint, std::string("2"));
}

void TestDriveFinder::stoppedItAsksNoMore()
{
    std::stop_source stop;
    m_answers["a"] = [&](const Exchange& exchange) -> Result<DriveIdentity> {
        stop.request_stop();
        return exchange.stop.stop_requested() ? Result<DriveIdentity>(fail(ErrorCode::Cancelled))
                                              : Result<DriveIdentity>(drive);
    };
    answers("b");
    DriveSearch stopped = search();
    stopped.stop = stop.get_token();
    const auto sightings = findDrives(std::vector<DriveCandidate>{{{"a", "b"}, ""}}, stopped);
    VERIFY_ERROR(sightings.front().drive, ErrorCode::Cancelled);
    QCOMPARE(m_asked.size(), std::size_t(1));
}

void TestDriveFinder::noCandidatesNoSightings()
{
    QVERIFY(findDrives({}, search()).empty());
}

void TestDriveFinder::whatDoesNotListItsFilesAsADriveIsNotAskedWhoItIs()
{
    answers("a");
    auto candidates = places({"a"});
    candidates.front().isUnknown = true;
    const auto sightings = findDrives(candidates, search()); // a scripted link lists no files
    VERIFY_ERROR(sightings.front().drive, ErrorCode::DriveRejected);
    QCOMPARE(m_otherRequests.load(), 1);
}

void TestDriveFinder::noMoreAreAskedAtOnceThanWanted()
{
    std::atomic<int> now = 0;
    std::atomic<int> most = 0;
    std::vector<DriveCandidate> candidates;
    for (int i = 0; i < 60; ++i) {
        candidates.push_back({{std::to_string(i)}, {}});
        m_answers[std::to_string(i)] = [&](const Exchange&) -> Result<DriveIdentity> {
            const int running = ++now;
            int known = most;
            while (running > known && !most.compare_exchange_weak(known, running)) { }
            for (int n = 0; n < 100; ++n)
                std::this_thread::yield();
            --now;
            return drive;
        };
    }
    DriveSearch few = search();
    few.mostAtOnce = 3;
    static_cast<void>(findDrives(candidates, few));
    QVERIFY2(most.load() <= 3, std::to_string(most.load()).c_str());
    QCOMPARE(now.load(), 0);
    few.mostAtOnce = 1;
    most = 0;
    static_cast<void>(findDrives(candidates, few));
    QCOMPARE(most.load(), 1);
}

AXISCOMP_TEST(TestDriveFinder)

} // namespace tst_drivesearch

#include "tst_drivesearch.moc"
