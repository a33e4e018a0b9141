// SPDX-License-Identifier: GPL-3.0-or-later
//
// A backup over the web server, whose replies have no check sum of their own.
#include "tests/support/compensator_fixture.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"
#include "tests/support/wire_attachments.h"

#include <QTest>

#include <vector>

namespace tst_garbledbackup {

using namespace axiscomp;
using namespace axiscomp::test;

namespace {

/// Of the requests that every operation begins with: name and number of the drive, then this.
constexpr std::uint64_t axesCounted = 2;

} // namespace

class TestGarbledBackup : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void aBackupHoldsNoGarbledTable()
    {
        CompensatorFixture f(web());
        VERIFY_RESULT(f.compensator.write(0, exampleRequest(1, Persistency::Persistent)));
        VERIFY_RESULT(f.compensator.write(0, exampleRequest(2)));
        VERIFY_RESULT(f.compensator.write(1, exampleRequest(3)));
        std::uint64_t requests = 0;
        f.requested = [&requests](bool) { ++requests; };
        const auto right = f.compensator.backup();
        VERIFY_RESULT(right);
        QCOMPARE(right->otherFiles.size(), std::size_t{1});
        f.requested = {};

        std::vector<std::uint64_t> withstood;
        const std::uint64_t all = requests;
        for (std::uint64_t number = 1; number <= all; ++number) {
            f.faults.clear();
            f.faults.add({drivecomm::FaultSpec::Kind::Garble, number, {}});
            const auto backup = f.compensator.backup();
            if (!backup)
                continue;
            withstood.push_back(number);
            for (std::size_t axis = 0; axis < 2; ++axis) {
                QVERIFY(backup->axes[axis].registers == right->axes[axis].registers);
                QVERIFY2(backup->axes[axis].files == right->axes[axis].files,
                    qPrintable(QStringLiteral("request %1 of %2").arg(number).arg(all)));
            }
            QVERIFY2(backup->otherFiles == right->otherFiles,
                qPrintable(QStringLiteral("request %1 of %2").arg(number).arg(all)));
        }
        // The three tables are read again. The axes are counted by a refusal, whose status is
        // enough when its words are garbled: then they are counted one by one.
        QCOMPARE(withstood.size(), std::size_t{4});
        QCOMPARE(withstood.front(), axesCounted);
    }

    void aDownloadIsNoGarbledTable()
    {
        CompensatorFixture f(web());
        const auto written = f.compensator.write(0, exampleRequest(1));
        VERIFY_RESULT(written);
        const std::string& path =
            drivecomm::genericProfile().slotNamed(written->now.setup.slot)->file;
        const auto right = f.compensator.download(path);
        VERIFY_RESULT(right);
        f.faults.clear();
        f.faults.add({drivecomm::FaultSpec::Kind::Garble, 1, {}});
        const auto file = f.compensator.download(path);
        VERIFY_RESULT(file);
        QVERIFY(*file == *right);
    }
};

AXISCOMP_TEST(TestGarbledBackup)

} // namespace tst_garbledbackup

#include "tst_garbledbackup.moc"
