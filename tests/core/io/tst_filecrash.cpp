// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/local_file.h"
#include "core/store/drive_store.h"
#include "tests/support/kill_points.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTemporaryDir>

#include <set>

#include <fcntl.h>
#include <sys/mount.h>

namespace tst_filecrash {

using namespace axiscomp;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

constexpr std::int32_t serial = 1559;
constexpr WallTime start{std::chrono::hours(24 * 365 * 50)};
constexpr int databaseStep = 7;

AxisBackup backupAt(WallTime time)
{
    AxisBackup backup;
    backup.drive = {"Triamec-616", serial, 2};
    backup.axisName = "X";
    backup.time = time;
    backup.registers = {{"Axes[0]/Parameters/Compensations/Axis/Table", std::string("Small1")}};
    backup.files = {{"Small1", "tables/small1.TAMtbl", Bytes(500, std::byte{7}), true}};
    return backup;
}

JournalEntry entryAt(const std::string& step)
{
    JournalEntry entry;
    entry.serialNumber = serial;
    entry.time = start;
    entry.step = step;
    entry.newSlot = "Small2";
    return entry;
}

} // namespace

/// One thing that the program keeps on disk.
struct Kept {
    std::function<bool(const fs::path& root, int version)> write;
    /// The version that is there; -1: none, -2: a damaged one.
    std::function<int(const fs::path& root)> read;
    int momentStep = 1; ///< a database makes hundreds of system calls
};
namespace {

Kept plainFile(std::size_t size)
{
    const auto content = [size](int version) {
        return Bytes(size + static_cast<std::size_t>(version), static_cast<std::byte>(version));
    };
    return {[content](const fs::path& root, int version) {
                return saveFile(root / "file", content(version)).has_value();
            },
        [content](const fs::path& root) {
            const auto bytes = loadFile(root / "file", 10'000'000);
            if (!bytes)
                return -1;
            for (const int version : {1, 2, 3})
                if (*bytes == content(version))
                    return version;
            return -2;
        }};
}

/// Two files, and the newest of them counts.
Kept backups()
{
    return {[](const fs::path& root, int version) {
                return DriveStore(root).saveBackup(backupAt(start + version * 1h)).has_value();
            },
        [](const fs::path& root) {
            int newest = -1;
            for (const fs::path& file : DriveStore(root).backups(serial, 0)) {
                const auto bytes = loadFile(file, maximumBackupSize);
                const auto backup = bytes ? readBackup(asText(*bytes), file.string())
                                          : Result<DriveBackup>(fail(bytes.error()));
                if (!backup)
                    return -2;
                const auto version =
                    static_cast<int>((backup->axes.front().time - start) / std::chrono::hours(1));
                newest = std::max(newest, version);
            }
            return newest;
        }};
}

Kept journal()
{
    return {[](const fs::path& root, int version) {
                return DriveStore(root).openJournal(entryAt(std::to_string(version))).has_value();
            },
        [](const fs::path& root) {
            const auto entry = DriveStore(root).journal(serial, 0);
            if (!entry)
                return -2;
            return *entry ? std::stoi((*entry)->step) : -1;
        },
        databaseStep};
}

Kept flashHistory()
{
    return {[](const fs::path& root, int version) {
                return DriveStore(root).recordFlash(serial, start + version * 1h, 1).has_value();
            },
        [](const fs::path& root) {
            const auto history = DriveStore(root).flashHistory(serial);
            if (!history || history->recent.size() != history->total)
                return -2;
            return history->total == 0 ? -1 : static_cast<int>(history->total);
        },
        databaseStep};
}

Kept ownTables()
{
    return {[](const fs::path& root, int version) {
                return DriveStore(root)
                    .recordOwnTable(serial, 0, {"Small1", static_cast<std::uint32_t>(version)})
                    .has_value();
            },
        [](const fs::path& root) {
            const auto tables = DriveStore(root).ownTables(serial, 0);
            if (!tables)
                return -2;
            return tables->empty() ? -1 : static_cast<int>(tables->front().crc);
        },
        databaseStep};
}

bool hasDamagedFile(const fs::path& root)
{
    for (const auto& entry : fs::recursive_directory_iterator(root))
        if (entry.path().extension() == ".broken")
            return true;
    return false;
}

} // namespace

class TestFileCrash final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void killedAnywhereTheOldOrTheNewIsThere_data() { everything(); }
    void killedAnywhereTheOldOrTheNewIsThere();
    void onAFullDiskTheOldOrTheNewIsThere_data() { everything(); }
    void onAFullDiskTheOldOrTheNewIsThere();
    void aFileSystemWithoutRoomIsNamed();
    void aDeviceWithoutRoomIsNamed();

private:
    static void everything();
};

void TestFileCrash::everything()
{
    QTest::addColumn<Kept>("kept");
    QTest::newRow("small file") << plainFile(100);
    QTest::newRow("large file") << plainFile(300'000);
    QTest::newRow("backup") << backups();
    QTest::newRow("journal") << journal();
    QTest::newRow("flash history") << flashHistory();
    QTest::newRow("tables") << ownTables();
}

void TestFileCrash::killedAnywhereTheOldOrTheNewIsThere()
{
    QFETCH(Kept, kept);
    const QTemporaryDir folder;
    const fs::path root = folder.path().toStdString();
    const auto fresh = [&](const std::string& name) {
        fs::remove_all(root / name);
        fs::create_directory(root / name);
        return root / name;
    };
    std::set<int> found;
    const fs::path place = root / "work";
    fresh("work");
    QVERIFY(kept.write(place, 1));
    const int moments = test::killEverywhere([&] { ::_exit(kept.write(place, 2) ? 0 : 1); },
        [&] {
            const int there = kept.read(place);
            found.insert(there);
            QVERIFY2(there == 1 || there == 2, std::to_string(there).c_str());
            QVERIFY(!hasDamagedFile(place));
            QVERIFY(kept.write(place, 3)); // nothing of it stands in the way
            fresh("work");
            QVERIFY(kept.write(place, 1));
        },
        kept.momentStep);
    QVERIFY2(moments > 10, std::to_string(moments).c_str());
    qInfo("killed at %d moments", moments);
    QCOMPARE(found, (std::set<int>{1, 2}));
}

void TestFileCrash::onAFullDiskTheOldOrTheNewIsThere()
{
    QFETCH(Kept, kept);
    const QTemporaryDir folder;
    const fs::path root = folder.path().toStdString();
    QVERIFY(kept.write(root, 1));
    bool isSaved = false;
    rlim_t limit = 0;
    int refused = 0;
    const rlim_t step = test::takesEveryMoment() ? 1 : 7;
    for (; !isSaved; limit = limit < 1000 ? limit + step : 2 * limit) {
        {
            const test::FileSizeLimit full(limit);
            isSaved = kept.write(root, 2);
        }
        QCOMPARE(kept.read(root), isSaved ? 2 : 1);
        QVERIFY(!hasDamagedFile(root));
        refused += isSaved ? 0 : 1;
    }
    QVERIFY(refused > 10);
    QVERIFY(kept.write(root, 3));
}

void TestFileCrash::aFileSystemWithoutRoomIsNamed()
{
    const QTemporaryDir folder;
    const fs::path root = folder.path().toStdString();
    if (::mount("tmpfs", root.c_str(), "tmpfs", 0, "size=64k") != 0)
        QSKIP("only root may mount a small file system");
    const Bytes old(20'000, std::byte{1});
    const auto first = saveFile(root / "file", old);
    const auto second = saveFile(root / "file", Bytes(60'000, std::byte{2}));
    const auto there = loadFile(root / "file", 100'000);
    const auto files = std::distance(fs::directory_iterator(root), fs::directory_iterator());
    QCOMPARE(::umount(root.c_str()), 0);
    VERIFY_RESULT(first);
    VERIFY_ERROR(second, ErrorCode::FileNotWritable);
    QCOMPARE(second.error().context.english("reason"), std::string("the disk is full"));
    VERIFY_RESULT(there);
    QVERIFY(*there == old);
    QCOMPARE(files, 1);
}

void TestFileCrash::aDeviceWithoutRoomIsNamed()
{
    const auto saved = saveFile("/dev/full", Bytes(10, std::byte{1}));
    VERIFY_ERROR(saved, ErrorCode::FileNotWritable);
    QCOMPARE(saved.error().context.english("reason"), std::string("the disk is full"));
}

AXISCOMP_TEST(TestFileCrash)

} // namespace tst_filecrash

#include "tst_filecrash.moc"
