// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/drive_store.h"
#include "core/store/sqlite.h"
#include "core/store/store_condition.h"
#include "tests/support/file_content.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTemporaryDir>

#include <fstream>

#include <sys/stat.h>

namespace tst_storecondition {

using namespace axiscomp;
using axiscomp::test::contentsBelow;
using namespace std::chrono_literals;
namespace fs = std::filesystem;
using Database = StoreCondition::Database;

namespace {

constexpr std::int32_t serial = 1559;
const WallTime start = *utcFromText("2026-11-21T08:02:23Z");

JournalEntry entryFor(int axis)
{
    JournalEntry entry;
    entry.serialNumber = serial;
    entry.axis = axis;
    entry.time = start;
    entry.step = "upload";
    return entry;
}

void write(const fs::path& file, const std::string& content)
{
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << content;
}

} // namespace

/// Looking at a state folder says what is in it, and changes nothing there: neither a damaged
/// database nor one of an older version is replaced, and nothing is made.
class TestStoreCondition final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnWarnings();
        m_temporary = std::make_unique<QTemporaryDir>();
        const fs::path folder(m_temporary->path().toStdString());
        m_root = folder / "state";
        m_scratch = folder / "scratch";
        fs::create_directory(m_scratch);
        m_file = m_root / "axiscomp.db";
    }

    void whereNothingIsNothingIsMade();
    void theDatabaseIsToldFromOthers_data();
    void theDatabaseIsToldFromOthers();
    void whatIsNoFileIsNotWaitedFor();
    void aWriteThatDidNotEndIsListedAlsoFromTheLog();
    void aWriteThatIsBeingDoneIsToldApart();
    void aJournalOfAnOlderVersionCountsToo();
    void whatAReplacementHasBuiltCountsInPlaceOfTheDatabase();
    void withoutRoomForACopyNothingIsSaidOfTheDatabase();
    void lossesAndBackupsAreCounted();
    void aLossOfAllDrivesCountsForOneThatTheDatabaseDoesNotKnow();
    void theCopyIsAStateFolderOfItsOwn();

private:
    StoreCondition look() { return lookAtStore(m_root, m_scratch); }
    void fill()
    {
        DriveStore store(m_root);
        VERIFY_RESULT(store.recordFlash(serial, start, 1));
    }
    std::unique_ptr<QTemporaryDir> m_temporary;
    fs::path m_root;
    fs::path m_scratch;
    fs::path m_file;
};

void TestStoreCondition::whereNothingIsNothingIsMade()
{
    const StoreCondition condition = look();
    QCOMPARE(condition.database, Database::None);
    QVERIFY(condition.unfinished.empty() && condition.backups == 0 && !condition.lastChange);
    QVERIFY(!fs::exists(m_root));
}

void TestStoreCondition::theDatabaseIsToldFromOthers_data()
{
    QTest::addColumn<QString>("change"); // a statement, or what is done to the file
    QTest::addColumn<Database>("database");
    QTest::newRow("whole") << "" << Database::Usable;
    QTest::newRow("older") << "PRAGMA user_version = 1" << Database::Older;
    QTest::newRow("newer") << "PRAGMA user_version = 1000" << Database::Newer;
    QTest::newRow("another program's") << "PRAGMA application_id = 1234" << Database::Foreign;
    QTest::newRow("damaged head") << "head" << Database::Damaged;
    QTest::newRow("damaged page") << "page" << Database::Damaged;
    QTest::newRow("empty") << "empty" << Database::Damaged;
    QTest::newRow("log alone") << "log" << Database::Damaged;
}

void TestStoreCondition::theDatabaseIsToldFromOthers()
{
    QFETCH(const QString, change);
    QFETCH(const Database, database);
    fill();
    if (change == QStringLiteral("head") || change == QStringLiteral("page")) {
        std::fstream stream(m_file, std::ios::binary | std::ios::in | std::ios::out);
        stream.seekp(change == QStringLiteral("head") ? 0 : 4096);
        stream << std::string(4096, '\x5a');
    } else if (change == QStringLiteral("empty")) {
        fs::resize_file(m_file, 0);
    } else if (change == QStringLiteral("log")) {
        fs::rename(m_file, m_file.string() + "-wal");
    } else if (!change.isEmpty()) {
        sqlite::Connection(m_file, 0ms).run(change.toStdString());
    }
    const auto before = contentsBelow(m_root);
    const StoreCondition condition = look();
    QCOMPARE(condition.database, database);
    QCOMPARE(condition.reason.isEmpty(), database != Database::Damaged);
    QVERIFY(contentsBelow(m_root) == before);
}

void TestStoreCondition::whatIsNoFileIsNotWaitedFor()
{
    fill();
    fs::remove(m_file);
    QCOMPARE(::mkfifo(m_file.c_str(), 0600), 0);
    const StoreCondition condition = look();
    QCOMPARE(condition.database, Database::Unreadable);
    QVERIFY2(condition.reason.english().find("not an ordinary file") != std::string::npos,
        condition.reason.english().c_str());
    QVERIFY(fs::is_fifo(m_file));
}

void TestStoreCondition::aWriteThatDidNotEndIsListedAlsoFromTheLog()
{
    DriveStore store(m_root);
    VERIFY_RESULT(store.openJournal(entryFor(1)));
    QVERIFY(fs::exists(m_file.string() + "-wal")); // as long as the store has it open
    const auto before = contentsBelow(m_root);
    const StoreCondition condition = look();
    QCOMPARE(condition.database, Database::Usable);
    QCOMPARE(condition.unfinished.size(), std::size_t{1});
    const JournalEntry& entry = condition.unfinished.front().entry;
    QCOMPARE(entry.serialNumber, serial);
    QCOMPARE(entry.axis, 1);
    QVERIFY(entry.time == start && entry.step == "upload");
    QVERIFY(!condition.unfinished.front().isBeingDone);
    QVERIFY(contentsBelow(m_root) == before);
}

void TestStoreCondition::aWriteThatIsBeingDoneIsToldApart()
{
    DriveStore store(m_root);
    VERIFY_RESULT(store.openJournal(entryFor(0)));
    {
        const auto writing = store.lockWrites(serial);
        VERIFY_RESULT(writing);
        QVERIFY(look().unfinished.front().isBeingDone);
    }
    QVERIFY(!look().unfinished.front().isBeingDone);
    VERIFY_RESULT(store.lockWrites(serial)); // looking holds nothing
}

void TestStoreCondition::aJournalOfAnOlderVersionCountsToo()
{
    write(m_root / "1559" / "journal-axis2.json", "{");
    const StoreCondition condition = look();
    QCOMPARE(condition.database, Database::None);
    QCOMPARE(condition.damagedJournals.size(), std::size_t{1});
    const std::string said = sentence(condition.damagedJournals.front());
    QVERIFY2(said.find("journal-axis2.json") != std::string::npos, said.c_str());
}

/// As a program leaves it that is ended between setting the damaged one aside and renaming this.
void TestStoreCondition::whatAReplacementHasBuiltCountsInPlaceOfTheDatabase()
{
    {
        DriveStore store(m_root);
        VERIFY_RESULT(store.openJournal(entryFor(1)));
    }
    fs::rename(m_file, m_file.string() + ".recovered-2026-11-21T08-02-23Z");
    for (const bool isDamagedThere : {false, true}) {
        if (isDamagedThere)
            write(m_file, "damaged");
        const auto before = contentsBelow(m_root);
        const StoreCondition condition = look();
        QCOMPARE(condition.database, Database::Usable);
        QCOMPARE(condition.unfinished.size(), std::size_t{1});
        QVERIFY(contentsBelow(m_root) == before);
    }
}

void TestStoreCondition::withoutRoomForACopyNothingIsSaidOfTheDatabase()
{
    fill();
    fs::remove_all(m_scratch);
    const StoreCondition condition = look();
    QCOMPARE(condition.database, Database::NotCopied);
    QVERIFY2(condition.reason.english().find(m_scratch.string()) != std::string::npos,
        condition.reason.english().c_str());
}

void TestStoreCondition::lossesAndBackupsAreCounted()
{
    fill();
    sqlite::Connection(m_file, 0ms)
        .run("INSERT INTO flash_loss (serial, file) VALUES (NULL, 'axiscomp.db.damaged-1')");
    write(m_root / "axiscomp.db.damaged-1", "x");
    write(m_root / "axiscomp.db.damaged-1-wal", "x");
    write(m_root / "1559" / "backups" / "2026-11-21T08-02-23Z-axis0.json", "{}");
    write(m_root / "1559" / "backups" / "2026-11-21T08-02-24Z-axis0.json", "{}\n");
    const StoreCondition condition = look();
    QCOMPARE(condition.flashLoss, std::vector<std::int32_t>{serial});
    QCOMPARE(condition.setAside, std::vector<fs::path>{m_root / "axiscomp.db.damaged-1"});
    QCOMPARE(condition.backups, std::size_t{2});
    QCOMPARE(condition.backupBytes, std::uint64_t{5});
    QCOMPARE(condition.drives, std::size_t{1});
    VERIFY_RESULT(DriveStore(m_root).acceptFlashLoss(serial));
    QVERIFY(look().flashLoss.empty());
}

void TestStoreCondition::aLossOfAllDrivesCountsForOneThatTheDatabaseDoesNotKnow()
{
    fill();
    sqlite::Connection(m_file, 0ms)
        .run("DELETE FROM drive; INSERT INTO flash_loss (serial, file) VALUES (NULL, 'x')");
    write(m_root / "1559" / "backups" / "2026-11-21T08-02-23Z-axis0.json", "{}");
    QVERIFY(DriveStore(m_root).flashHistory(serial)->damagedRecord.has_value());
    QCOMPARE(look().flashLoss, std::vector<std::int32_t>{serial});
}

void TestStoreCondition::theCopyIsAStateFolderOfItsOwn()
{
    fill();
    static_cast<void>(look());
    QCOMPARE(DriveStore(m_scratch).flashHistory(serial)->total, std::uint64_t{1});
    VERIFY_RESULT(DriveStore(m_scratch).recordFlash(serial, start, 1));
    QCOMPARE(DriveStore(m_root).flashHistory(serial)->total, std::uint64_t{1});
}

AXISCOMP_TEST(TestStoreCondition)

} // namespace tst_storecondition

#include "tst_storecondition.moc"
