// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive/flash_wear.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <limits>
#include <random>

namespace tst_flashwear {

using namespace axiscomp;
using namespace std::chrono_literals;

namespace {

const WallTime start = *utcFromText("2026-11-21T08:00:00Z");
constexpr FlashWearLimits eightInTenMinutes{.operations = 8, .window = 600s, .ratedCycles = 0};

std::vector<WallTime> times(std::initializer_list<WallTime::duration> offsets)
{
    std::vector<WallTime> result;
    for (const auto offset : offsets)
        result.push_back(start + offset);
    return result;
}

} // namespace

class TestFlashWear : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void nothingRecordedLeavesAll();
    void eachOperationTakesOne();
    void edgesOfTheWindow_data();
    void edgesOfTheWindow();
    void waitIsForTheOperationThatMustExpire();
    void moreThanTheLimitWaitsForEnough();
    void waitIsRoundedUp();
    void afterTheWaitOneIsPossible();
    void historyNeedNotBeSorted();
    void futureOperations_data();
    void futureOperations();
    void clockSetBackDoesNotLockForever();
    void refusalHoldsUntilItsTime();
    void refusalDoesNotShortenTheWait();
    void refusalOfAWrongClockIsForgotten();
    void noKnownLimitAllowsAll();
    void nonsenseIsHarmless();
    void neverMoreThanTheLimitInAnyWindow();
};

void TestFlashWear::nothingRecordedLeavesAll()
{
    const FlashWearGuard guard{eightInTenMinutes};
    QCOMPARE(guard.budget(start).left, 8);
    QCOMPARE(guard.budget(start).wait, 0s);
    QVERIFY(guard.operations(start).empty());
}

void TestFlashWear::eachOperationTakesOne()
{
    FlashWearGuard guard{eightInTenMinutes};
    for (int done = 0; done < 8; ++done) {
        QCOMPARE(guard.budget(start + 1s * done).left, 8 - done);
        guard.record(start + 1s * done);
    }
    QCOMPARE(guard.budget(start + 8s).left, 0);
    QCOMPARE(guard.budget(start + 8s).wait, 592s);
}

void TestFlashWear::edgesOfTheWindow_data()
{
    QTest::addColumn<WallTime::duration>("age");
    QTest::addColumn<int>("left");
    QTest::newRow("now") << WallTime::duration{0} << 7;
    QTest::newRow("just inside") << WallTime::duration{600s - 1ns} << 7;
    QTest::newRow("exactly one window") << WallTime::duration{600s} << 8;
    QTest::newRow("just outside") << WallTime::duration{600s + 1ns} << 8;
}

void TestFlashWear::edgesOfTheWindow()
{
    QFETCH(WallTime::duration, age);
    QFETCH(int, left);
    FlashWearGuard guard{eightInTenMinutes};
    guard.record(start);
    QCOMPARE(guard.budget(start + age).left, left);
    QCOMPARE(guard.operations(start + age).size(), static_cast<std::size_t>(8 - left));
}

void TestFlashWear::waitIsForTheOperationThatMustExpire()
{
    const FlashWearGuard guard{
        {.operations = 3, .window = 600s, .ratedCycles = 0}, times({0s, 100s, 200s})};
    QCOMPARE(guard.budget(start + 250s).left, 0);
    QCOMPARE(guard.budget(start + 250s).wait, 350s);
    QCOMPARE(guard.budget(start + 600s).left, 1);
    QCOMPARE(guard.budget(start + 700s).left, 2);
    QCOMPARE(guard.budget(start + 800s).left, 3);
}

void TestFlashWear::moreThanTheLimitWaitsForEnough()
{
    // Another computer's operations may have been added to the history.
    const FlashWearGuard guard{
        {.operations = 2, .window = 600s, .ratedCycles = 0}, times({0s, 10s, 20s, 30s})};
    QCOMPARE(guard.budget(start + 30s).wait, 590s); // until the one at 20 s is over
    QCOMPARE(guard.budget(start + 619s).left, 0);
    QCOMPARE(guard.budget(start + 620s).left, 1);
    QCOMPARE(guard.budget(start + 620s).wait, 0s);
    QCOMPARE(guard.budget(start + 620s, 2).wait, 10s);
    QCOMPARE(guard.budget(start + 30s, 2).wait, 600s);
    QCOMPARE(guard.budget(start + 30s, 3).wait, 600s); // more than ever are possible
}

void TestFlashWear::waitIsRoundedUp()
{
    FlashWearGuard guard{{.operations = 1, .window = 10s, .ratedCycles = 0}};
    guard.record(start);
    QCOMPARE(guard.budget(start + 1ms).wait, 10s);
    QCOMPARE(guard.budget(start + 9s).wait, 1s);
    QCOMPARE(guard.budget(start + 9999ms).wait, 1s);
}

void TestFlashWear::afterTheWaitOneIsPossible()
{
    FlashWearGuard guard{eightInTenMinutes};
    for (int i = 0; i < 8; ++i)
        guard.record(start + 13700ms * i);
    const WallTime now = start + 100s;
    const FlashBudget budget = guard.budget(now);
    QCOMPARE(budget.left, 0);
    QCOMPARE(guard.budget(now + budget.wait).left, 1);
}

void TestFlashWear::historyNeedNotBeSorted()
{
    const FlashWearGuard guard{
        {.operations = 3, .window = 600s, .ratedCycles = 0}, times({200s, 0s, 100s})};
    QCOMPARE(guard.operations(start + 200s), times({0s, 100s, 200s}));
    QCOMPARE(guard.budget(start + 200s).wait, 400s);
}

void TestFlashWear::futureOperations_data()
{
    QTest::addColumn<WallTime::duration>("ahead");
    QTest::addColumn<bool>("counts");
    QTest::newRow("a moment") << WallTime::duration{1ns} << true;
    QTest::newRow("just below a window") << WallTime::duration{600s - 1ns} << true;
    QTest::newRow("a window") << WallTime::duration{600s} << false;
    QTest::newRow("years") << WallTime::duration{24h * 365 * 20} << false;
}

void TestFlashWear::futureOperations()
{
    QFETCH(WallTime::duration, ahead);
    QFETCH(bool, counts);
    const FlashWearGuard guard{
        {.operations = 1, .window = 600s, .ratedCycles = 0}, {start + ahead}};
    QCOMPARE(guard.budget(start).left, counts ? 0 : 1);
    QVERIFY(guard.budget(start).wait <= 2 * 600s);
}

void TestFlashWear::clockSetBackDoesNotLockForever()
{
    FlashWearGuard guard{{.operations = 1, .window = 600s, .ratedCycles = 0}};
    guard.record(start);
    const WallTime lastYear = start - 24h * 365;
    QCOMPARE(guard.budget(lastYear).left, 1);
    guard.record(lastYear);
    QCOMPARE(guard.budget(lastYear).left, 0);
    QCOMPARE(guard.budget(lastYear).wait, 600s);
    QCOMPARE(guard.operations(lastYear), std::vector<WallTime>{lastYear});
}

void TestFlashWear::refusalHoldsUntilItsTime()
{
    FlashWearGuard guard{eightInTenMinutes};
    guard.recordRefusal(start, 120s);
    QCOMPARE(guard.budget(start).left, 0);
    QCOMPARE(guard.budget(start).wait, 120s);
    QCOMPARE(guard.budget(start + 119s).left, 0);
    QCOMPARE(guard.budget(start + 120s - 1ns).wait, 1s);
    QCOMPARE(guard.budget(start + 120s).left, 8);
    QCOMPARE(guard.budget(start + 120s).wait, 0s);
}

void TestFlashWear::refusalDoesNotShortenTheWait()
{
    FlashWearGuard guard{{.operations = 1, .window = 600s, .ratedCycles = 0}};
    guard.record(start);
    guard.recordRefusal(start, 5s);
    QCOMPARE(guard.budget(start).wait, 600s);
    guard.recordRefusal(start, 900s);
    QCOMPARE(guard.budget(start).wait, 900s);
}

void TestFlashWear::refusalOfAWrongClockIsForgotten()
{
    FlashWearGuard guard{eightInTenMinutes};
    guard.recordRefusal(start, 60s);
    QCOMPARE(guard.budget(start - 599s).left, 0);
    QCOMPARE(guard.budget(start - 601s).left, 8);
    QCOMPARE(guard.budget(start - 24h * 365).left, 8);
}

void TestFlashWear::noKnownLimitAllowsAll()
{
    FlashWearGuard guard{FlashWearLimits{}};
    guard.record(start, 1000);
    QCOMPARE(guard.budget(start).left, std::numeric_limits<int>::max());
}

void TestFlashWear::nonsenseIsHarmless()
{
    FlashWearGuard guard{
        {.operations = 2, .window = std::chrono::seconds::max(), .ratedCycles = 0}};
    guard.record(start, 0);
    guard.record(start, -5);
    QCOMPARE(guard.budget(start).left, 2);
    guard.recordRefusal(start, std::chrono::seconds::min());
    QCOMPARE(guard.budget(start).left, 2);
    guard.recordRefusal(start, std::chrono::seconds::max());
    QCOMPARE(guard.budget(start).left, 0);
}

/// Follows the guard's own word through random operations: in no window are there more than
/// allowed, and never is one refused that the drive's rule allows.
void TestFlashWear::neverMoreThanTheLimitInAnyWindow()
{
    std::mt19937 random{20261121};
    std::uniform_int_distribution<int> pause{0, 200'000};
    FlashWearGuard guard{eightInTenMinutes};
    std::vector<WallTime> done;
    WallTime now = start;
    for (int i = 0; i < 5000; ++i) {
        now += std::chrono::milliseconds{pause(random)};
        const auto inWindow = std::ranges::count_if(
            done, [now](WallTime operation) { return now - operation < 600s; });
        QVERIFY(inWindow <= 8);
        QCOMPARE(guard.budget(now).left, static_cast<int>(8 - inWindow));
        const int operations = std::min(guard.budget(now).left, 1 + i % 3);
        guard.record(now, operations);
        done.insert(done.end(), static_cast<std::size_t>(operations), now);
    }
}

AXISCOMP_TEST(TestFlashWear)

} // namespace tst_flashwear

#include "tst_flashwear.moc"
