// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compensator/axis_operations.h"
#include "core/write/kept_backup.h"
#include "tests/support/compensator_fixture.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

namespace tst_keptbackup {

using namespace axiscomp;
using test::CompensatorFixture;
using test::exampleRequest;

/// The backups of a drive, as a person chooses among them.
class TestKeptBackup : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void eachSaysWhatTheWriteBehindItDid()
    {
        CompensatorFixture fixture;
        VERIFY_RESULT(fixture.compensator.write(0, exampleRequest(2)));
        VERIFY_RESULT(fixture.compensator.write(0, exampleRequest(1)));
        VERIFY_RESULT(fixture.compensator.setPersistency(0, Persistency::Persistent));
        VERIFY_RESULT(fixture.compensator.write(0, deletionRequest()));
        VERIFY_RESULT(fixture.compensator.write(1, exampleRequest(2)));
        const auto drive = fixture.compensator.identify();
        VERIFY_RESULT(drive);
        const auto backups = backupsToChoose(fixture.store, *drive, drivecomm::genericProfile());
        QCOMPARE(backups.size(), std::size_t{5});
        for (std::size_t i = 1; i < backups.size(); ++i)
            QVERIFY(backups[i - 1].time >= backups[i].time);
        std::vector<const KeptBackup*> ofX;
        for (const KeptBackup& backup : backups)
            if (backup.axis == 0)
                ofX.push_back(&backup);
        using Write = KeptBackup::Write;
        QCOMPARE(ofX.size(), std::size_t{4});
        QVERIFY(!ofX[0]->write); // the deletion: only the next backup will tell
        QVERIFY(ofX[1]->write == Write::Settings);
        QVERIFY(ofX[2]->write == Write::NewTable);
        QVERIFY(ofX[3]->write == Write::NewTable);
        QVERIFY(!ofX[3]->table);
        QVERIFY(ofX[2]->table && ofX[2]->table->values == exampleRequest(2).table->values);
        QVERIFY(ofX[0]->isPersistent && !ofX[1]->isPersistent);
        for (const KeptBackup* backup : ofX)
            QCOMPARE(backup->unit, std::string("Millimeter"));
    }
};

AXISCOMP_TEST(TestKeptBackup)

} // namespace tst_keptbackup

#include "tst_keptbackup.moc"
