// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/drivecomm/virtualdrive/drive_fixture.h"
#include "tests/support/kill_points.h"
#include "tests/support/test_registry.h"

#include <QTemporaryDir>

#include <filesystem>
#include <set>

namespace tst_statecrash {

using namespace axiscomp;
using namespace axiscomp::drivecomm;
using namespace axiscomp::test;
namespace fs = std::filesystem;

namespace {

constexpr int momentStep = 3;

/// A bench whose drive keeps its flash in the folder.
struct KeptDrive : DriveFixture {
    explicit KeptDrive(const fs::path& folder) : DriveFixture(1)
    {
        drive.reset();
        options.stateFolder = folder;
        start();
    }
    bool store(float value) { return upload("Small1", flatTable(value), true).has_value(); }
    [[nodiscard]] float stored()
    {
        const auto table = decodeTamTable(file("Small1"), profile.layout);
        return table ? table->table.values.front() : -1.0F;
    }
};

} // namespace

class StateCrashTest final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void killedAnywhereFlashIsTheOldOrTheNew();
    void onAFullDiskFlashIsTheOld();
};

void StateCrashTest::killedAnywhereFlashIsTheOldOrTheNew()
{
    const QTemporaryDir folder;
    const fs::path root = folder.path().toStdString();
    const auto begin = [&] {
        fs::remove_all(root / "state");
        QVERIFY(KeptDrive(root / "state").store(1.0F));
    };
    begin();
    std::set<float> found;
    const int moments =
        killEverywhere([&] { ::_exit(KeptDrive(root / "state").store(2.0F) ? 0 : 1); },
            [&] {
                const float value = KeptDrive(root / "state").stored();
                QVERIFY2(value == 1.0F || value == 2.0F, std::to_string(value).c_str());
                found.insert(value);
                QVERIFY(KeptDrive(root / "state").store(3.0F));
                begin();
            },
            momentStep);
    QVERIFY2(moments > 30, std::to_string(moments).c_str());
    qInfo("killed at %d moments", moments);
    QCOMPARE(found, (std::set<float>{1.0F, 2.0F}));
}

void StateCrashTest::onAFullDiskFlashIsTheOld()
{
    const QTemporaryDir folder;
    const fs::path root = folder.path().toStdString();
    QVERIFY(KeptDrive(root).store(1.0F));
    bool isStored = false;
    int refused = 0;
    for (rlim_t limit = 0; !isStored; limit += 16) {
        {
            KeptDrive drive(root);
            const FileSizeLimit full(limit);
            isStored = drive.store(2.0F);
        }
        QCOMPARE(KeptDrive(root).stored(), isStored ? 2.0F : 1.0F);
        refused += isStored ? 0 : 1;
    }
    QVERIFY(refused > 10);
}

AXISCOMP_TEST(StateCrashTest)

} // namespace tst_statecrash

#include "tst_statecrash.moc"
