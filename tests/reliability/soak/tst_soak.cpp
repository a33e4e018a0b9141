// SPDX-License-Identifier: GPL-3.0-or-later
//
// Three programs on one virtual drive act at random, with faults (docs/reliability.md, "Soak").
//     AXISCOMP_SOAK_SEED=N         another run, or one again
//     AXISCOMP_SOAK_OPERATIONS=N   a longer one
// What happens at the same time may come out in another order with the same seed.
#include "tests/reliability/soak/soak.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"
#include "tests/support/wire_attachments.h"

#include <QTest>

namespace tst_soak {

using namespace axiscomp::test;

namespace {

constexpr int shortRun = 300;
/// Each has found something once.
const std::vector shortSeeds{5, 11, 23, 31};

/// ThreadSanitizer does not see the locks inside Qt's event queue, by which the web link hands its
/// requests to its own thread: there, two programs are in the process of the drive.
std::vector<AttachmentKind> attachments()
{
#ifdef __SANITIZE_THREAD__
    return {inProcess(), inProcess(), serial()};
#else
    return {inProcess(), web(), serial()};
#endif
}

} // namespace

class TestSoak : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void whateverHappensEveryAxisHasACompleteState_data()
    {
        QTest::addColumn<int>("seed");
        bool isSet = false;
        const int chosen = qEnvironmentVariableIntValue("AXISCOMP_SOAK_SEED", &isSet);
        for (const int seed : isSet ? std::vector{chosen} : shortSeeds)
            QTest::addRow("seed %d", seed) << seed;
    }
    void whateverHappensEveryAxisHasACompleteState()
    {
        QFETCH(int, seed);
        bool isSet = false;
        const int length = qEnvironmentVariableIntValue("AXISCOMP_SOAK_OPERATIONS", &isSet);
        Soak soak(static_cast<std::uint32_t>(seed), attachments());
        const std::string problem = soak.run(isSet ? length : shortRun);
        qInfo("seed %d: %s", seed, soak.counts().text().c_str());
        if (!problem.empty())
            qInfo("%s", problem.c_str()); // the whole of it: QVERIFY2 cuts it off
        QVERIFY2(problem.empty(), problem.substr(0, problem.find("the last")).c_str());
    }
};

AXISCOMP_TEST(TestSoak)

} // namespace tst_soak

#include "tst_soak.moc"
