// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a reboot brings back: the parameters that were saved last, with the tables that are in
// flash. The two must belong together whichever axis was written last, and how.
#include "tests/support/drive_fixture.h"
#include "tests/support/verify.h"

#include <QTest>

using namespace axiscomp;
using namespace axiscomp::test;

namespace {

/// Other sources than exampleRequest's.
WriteRequest swapped(int seed, Persistency persistency)
{
    WriteRequest request = exampleRequest(seed, persistency);
    std::swap(request.sources[0], request.sources[1]);
    return request;
}

} // namespace

class TestSavedState : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void savingAnAxisBringsNoEarlierTableBackToAnother()
    {
        DriveFixture f;
        VERIFY_RESULT(f.compensator.write(1, exampleRequest(1, Persistency::Persistent)));
        const DriveFixture::State saved = f.state(1);
        VERIFY_RESULT(f.compensator.write(1, exampleRequest(2, Persistency::Volatile)));
        VERIFY_RESULT(f.compensator.write(1, swapped(3, Persistency::Volatile)));
        VERIFY_RESULT(f.compensator.write(0, exampleRequest(4, Persistency::Persistent)));
        f.drive.reboot();
        // Its table was volatile, so that there is none now; above all not the first.
        const DriveFixture::State now = f.state(1);
        QVERIFY(now.table.empty());
        QVERIFY(now.registers != saved.registers);
    }

    void aPersistentWriteLeavesTheSavedTableUntilItIsSavedItself()
    {
        const auto prepare = [](DriveFixture& f) {
            VERIFY_RESULT(f.compensator.write(0, exampleRequest(1, Persistency::Persistent)));
            VERIFY_RESULT(f.compensator.write(0, exampleRequest(2, Persistency::Volatile)));
        };
        DriveFixture whole;
        prepare(whole);
        const int begin = whole.link.exchanges();
        VERIFY_RESULT(whole.compensator.write(0, swapped(3, Persistency::Persistent)));
        const int exchanges = whole.link.exchanges() - begin;
        QVERIFY(exchanges > 10);
        whole.drive.reboot();
        const DriveFixture::State wanted = whole.state();

        for (int exchange = 1; exchange <= exchanges; ++exchange) {
            DriveFixture f;
            prepare(f);
            f.link.failAt(exchange, LinkFault::DriveGoneAfter);
            (void)f.compensator.write(0, swapped(3, Persistency::Persistent));
            f.drive.reboot();
            DriveFixture old;
            prepare(old);
            old.drive.reboot();
            const DriveFixture::State now = f.state();
            QVERIFY2(now == old.state() || now == wanted,
                qPrintable(QStringLiteral("exchange %1 of %2").arg(exchange).arg(exchanges)));
        }
    }
};

QTEST_GUILESS_MAIN(TestSavedState)
#include "tst_savedstate.moc"
