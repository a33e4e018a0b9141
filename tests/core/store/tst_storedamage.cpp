// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive/compensation_setup.h"
#include "core/store/drive_store.h"
#include "core/store/sqlite.h"
#include "core/store/trusted_certificates.h"
#include "tests/support/file_content.h"
#include "tests/support/kill_points.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTemporaryDir>

#include <fstream>

namespace tst_storedamage {

using namespace axiscomp;
using axiscomp::test::contentOf;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

constexpr std::int32_t serial = 1559;
constexpr int momentStep = 11; ///< of some hundred system calls
const WallTime start = *utcFromText("2026-11-21T08:02:23Z");
const FlashWearLimits limits{.operations = 8, .window = 10min};

void overwrite(const fs::path& file, std::streamoff offset, const std::string& bytes)
{
    std::fstream stream(file, std::ios::binary | std::ios::in | std::ios::out);
    stream.seekp(offset);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

/// One of the pages with the operations, not the first.
void damageFlashOperations(const fs::path& file)
{
    const std::int64_t page = sqlite::Connection(file, 0ms).number(
        "SELECT pageno FROM dbstat WHERE name = 'flash_operation' AND pagetype = 'leaf' "
        "ORDER BY path LIMIT 1 OFFSET 1");
    overwrite(file, (page - 1) * 4096, std::string(4096, '\x5a'));
}

std::vector<fs::path> damagedFiles(const fs::path& root)
{
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(root))
        if (const std::string name = entry.path().filename().string();
            name.starts_with("axiscomp.db.damaged-") && name.ends_with("Z"))
            files.push_back(entry.path());
    return files;
}

JournalEntry entryFor(int axis)
{
    JournalEntry entry;
    entry.serialNumber = serial;
    entry.axis = axis;
    entry.step = "upload";
    return entry;
}

void fill(const fs::path& root)
{
    DriveStore store(root);
    for (int second = 0; second < 600; ++second)
        VERIFY_RESULT(store.recordFlash(serial, start + second * 1s, 1));
    VERIFY_RESULT(store.recordOwnTable(serial, 0, {"Small1", 5}));
    VERIFY_RESULT(store.openJournal(entryFor(0)));
    VERIFY_RESULT(TrustedCertificates(root).trust("https://drive", std::string(64, 'a')));
}

} // namespace

class TestStoreDamage final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnWarnings();
        m_temporary = std::make_unique<QTemporaryDir>();
        m_root = fs::path(m_temporary->path().toStdString()) / "state";
        m_file = m_root / "axiscomp.db";
        fill(m_root);
    }

    void itIsSetAsideAndCountsAsUsedUp_data();
    void itIsSetAsideAndCountsAsUsedUp();
    void whatCanBeReadIsRecovered();
    void anOlderVersionIsTakenOver_data();
    void anOlderVersionIsTakenOver();
    void damageThatShowsLaterIsTreatedAlike();
    void killedAnywhereItIsReplacedInTheEnd();
    void aProgramThatHasItOpenTakesTheNewOne();
    void aDamagedJournalSaysWhatToDo();
    void aLogIsNeverTakenForThatOfANewDatabase_data();
    void aLogIsNeverTakenForThatOfANewDatabase();

private:
    std::unique_ptr<QTemporaryDir> m_temporary;
    fs::path m_root;
    fs::path m_file;
};

void TestStoreDamage::itIsSetAsideAndCountsAsUsedUp_data()
{
    QTest::addColumn<int>("offset"); // -1: the file is cut to nothing, -2: to the half
    QTest::newRow("head") << 0;
    QTest::newRow("first page") << 100;
    QTest::newRow("empty") << -1;
    QTest::newRow("half") << -2;
}

void TestStoreDamage::itIsSetAsideAndCountsAsUsedUp()
{
    QFETCH(int, offset);
    if (offset < 0)
        fs::resize_file(m_file, offset == -1 ? 0 : fs::file_size(m_file) / 2 / 4096 * 4096);
    else
        overwrite(m_file, offset, std::string(3000, '\x5a'));
    const std::string before = contentOf(m_file);

    DriveStore store(m_root);
    const auto history = store.flashHistory(serial);
    VERIFY_RESULT(history);
    const std::vector<fs::path> aside = damagedFiles(m_root);
    QCOMPARE(aside.size(), std::size_t{1});
    QVERIFY(contentOf(aside.front()) == before);
    QVERIFY(history->damagedRecord == aside.front());
    QVERIFY(wearGuard(limits, *history).budget(start + 24h).isRecordLost);
    QVERIFY(store.flashHistory(serial + 1)->damagedRecord); // whichever drives it knew

    VERIFY_RESULT(store.recordFlash(serial, start + 24h, 1));
    VERIFY_RESULT(store.acceptFlashLoss(serial));
    QCOMPARE(
        wearGuard(limits, *DriveStore(m_root).flashHistory(serial)).budget(start + 24h).left, 7);
    QVERIFY(DriveStore(m_root).flashHistory(serial + 1)->damagedRecord); // each drive by itself
    QCOMPARE(damagedFiles(m_root).size(), std::size_t{1});
}

void TestStoreDamage::whatCanBeReadIsRecovered()
{
    damageFlashOperations(m_file);
    DriveStore store(m_root);
    const auto history = store.flashHistory(serial);
    VERIFY_RESULT(history);
    QVERIFY(history->damagedRecord);
    QCOMPARE(history->total, std::uint64_t{600});
    QVERIFY2(history->recent.size() > 100 && history->recent.size() < 600,
        std::to_string(history->recent.size()).c_str());
    QVERIFY(history->recent.back() == start + 599s && history->recent.front() == start);
    QCOMPARE(store.ownTables(serial, 0)->size(), std::size_t{1});
    QVERIFY(store.journal(serial, 0)->has_value());
    QCOMPARE(TrustedCertificates(m_root).all().size(), std::size_t{1});
}

void TestStoreDamage::anOlderVersionIsTakenOver_data()
{
    QTest::addColumn<bool>("isDamaged");
    QTest::newRow("whole") << false;
    QTest::newRow("damaged") << true;
}

/// Its journal does not know deletions, units and paths of sources, and it has no figures of
/// measurements.
void TestStoreDamage::anOlderVersionIsTakenOver()
{
    QFETCH(bool, isDamaged);
    sqlite::Connection(m_file, 0ms)
        .run("ALTER TABLE journal DROP COLUMN deleted_slot; ALTER TABLE journal DROP COLUMN units; "
             "ALTER TABLE journal DROP COLUMN source_paths; "
             "DROP TABLE measured; DROP TABLE measured_figure; PRAGMA user_version = 1");
    if (isDamaged)
        damageFlashOperations(m_file);
    DriveStore store(m_root);
    const auto history = store.flashHistory(serial);
    VERIFY_RESULT(history);
    QCOMPARE(history->damagedRecord.has_value(), isDamaged);
    const auto entry = store.journal(serial, 0);
    VERIFY_RESULT(entry);
    QVERIFY(*entry == entryFor(0));
    JournalEntry deletion = entryFor(1);
    deletion.deletedSlot = "Small3";
    VERIFY_RESULT(store.openJournal(deletion));
    QVERIFY(DriveStore(m_root).journal(serial, 1).value() == deletion);
    VERIFY_RESULT(store.recordMeasured(serial, 0, {5, start}));
    QVERIFY(DriveStore(m_root).measured(serial, 0, 5).value().has_value());
}

void TestStoreDamage::damageThatShowsLaterIsTreatedAlike()
{
    DriveStore store(m_root);
    QVERIFY(!store.flashHistory(serial)->damagedRecord);
    damageFlashOperations(m_file);
    // So that the store does not answer from its memory.
    sqlite::Connection(m_file, 0ms).run("UPDATE drive SET saved_known = 1");
    QVERIFY(store.flashHistory(serial)->damagedRecord);
    QCOMPARE(damagedFiles(m_root).size(), std::size_t{1});
}

void TestStoreDamage::killedAnywhereItIsReplacedInTheEnd()
{
    const std::string whole = contentOf(m_file);
    const auto prepare = [&] {
        fs::remove_all(m_root);
        fs::create_directories(m_root);
        std::ofstream(m_file, std::ios::binary) << whole;
        overwrite(m_file, 0, std::string(3000, '\x5a'));
    };
    prepare();
    const int moments = test::killEverywhere(
        [&] { ::_exit(DriveStore(m_root).flashHistory(serial).has_value() ? 0 : 1); },
        [&] {
            const auto history = DriveStore(m_root).flashHistory(serial);
            VERIFY_RESULT(history);
            QVERIFY(history->damagedRecord);
            QVERIFY(fs::exists(*history->damagedRecord));
            QCOMPARE(damagedFiles(m_root).size(), std::size_t{1});
            prepare();
        },
        momentStep);
    QVERIFY2(moments > 50, std::to_string(moments).c_str());
}

void TestStoreDamage::aProgramThatHasItOpenTakesTheNewOne()
{
    DriveStore store(m_root);
    VERIFY_RESULT(store.recordOwnTable(serial, 0, {"Small1", 6}));
    // As another program that has found damage does it.
    fs::rename(m_file, m_file.string() + ".damaged-2026-11-21T08-02-23Z");
    for (const char* ending : {"-wal", "-shm"})
        fs::remove(m_file.string() + ending);
    VERIFY_RESULT(store.recordOwnTable(serial, 0, {"Small1", 7}));
    QCOMPARE(DriveStore(m_root).ownTables(serial, 0)->size(), std::size_t{1});
}

void TestStoreDamage::aDamagedJournalSaysWhatToDo()
{
    sqlite::Connection(m_file, 0ms).run("UPDATE journal SET registers = '{'");
    DriveStore store(m_root);
    const auto journal = store.journal(serial, 0);
    VERIFY_ERROR(journal, ErrorCode::FileNotReadable);
    QCOMPARE(journal.error().context.english("file"), m_file.string());
    const std::string reason = journal.error().context.english("reason");
    QVERIFY2(reason.starts_with("its journal of an interrupted write is damaged")
            && reason.ends_with("then move the file away"),
        reason.c_str());
    VERIFY_RESULT(store.openJournal(entryFor(0)));
    QVERIFY(store.journal(serial, 0)->has_value());
}

void TestStoreDamage::aLogIsNeverTakenForThatOfANewDatabase_data()
{
    QTest::addColumn<QString>("ending");
    QTest::newRow("write-ahead log") << QStringLiteral("-wal");
    QTest::newRow("rollback journal") << QStringLiteral("-journal");
}

void TestStoreDamage::aLogIsNeverTakenForThatOfANewDatabase()
{
    QFETCH(QString, ending);
    const std::string log = ending.toStdString();
    fs::remove(m_file);
    std::ofstream(m_file.string() + log) << "something";
    const auto history = DriveStore(m_root).flashHistory(serial);
    VERIFY_RESULT(history);
    QCOMPARE(history->total, std::uint64_t{0});
    QVERIFY(history->damagedRecord); // what it held is not known
    QVERIFY(!fs::exists(m_file.string() + log));
    QCOMPARE(contentOf(history->damagedRecord->string() + log), std::string("something"));
}

AXISCOMP_TEST(TestStoreDamage)

} // namespace tst_storedamage

#include "tst_storedamage.moc"
