// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/drive_store.h"
#include "core/store/sqlite.h"
#include "core/store/trusted_certificates.h"
#include "tests/support/file_content.h"
#include "tests/support/kill_points.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTemporaryDir>

#include <fstream>

#include <sys/mount.h>
#include <sys/stat.h>

namespace tst_unusablestore {

using namespace axiscomp;
using axiscomp::test::contentOf;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

constexpr std::int32_t serial = 1559;

JournalEntry someEntry()
{
    JournalEntry entry;
    entry.serialNumber = serial;
    entry.step = "upload";
    return entry;
}

} // namespace

/// A store that cannot be used is named in a sentence, stays as it is, and lets no write begin:
/// neither the flash history that a plan asks for nor the journal is there.
class TestUnusableStore final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnWarnings();
        m_temporary = std::make_unique<QTemporaryDir>();
        m_root = fs::path(m_temporary->path().toStdString()) / "state";
        m_file = m_root / "axiscomp.db";
        fs::create_directories(m_root);
    }

    void anotherProgramsDatabaseIsRefused();
    void aNewerVersionIsRefused();
    void whatIsNoFileIsRefused_data();
    void whatIsNoFileIsRefused();
    void aPipeInPlaceOfAKeptTableIsRefused();
    void aReadOnlyFileSystemIsNamed();
    void aFullFileSystemIsNamed();

private:
    void expectRefused(const std::string& reason);
    std::unique_ptr<QTemporaryDir> m_temporary;
    fs::path m_root;
    fs::path m_file;
};

void TestUnusableStore::expectRefused(const std::string& reason)
{
    DriveStore store(m_root, 30ms);
    const auto history = store.flashHistory(serial);
    QVERIFY(!history.has_value());
    QVERIFY2(sentence(history.error()).find(reason) != std::string::npos,
        sentence(history.error()).c_str());
    const auto opened = store.openJournal(someEntry());
    QVERIFY(!opened.has_value());
    QVERIFY2(sentence(opened.error()).find(reason) != std::string::npos,
        sentence(opened.error()).c_str());
    QVERIFY(!store.journal(serial, 0).has_value());
    QVERIFY(!store.recordFlash(serial, WallTime{}, 1).has_value());
    QVERIFY(TrustedCertificates(m_root, 30ms).all().empty());
}

void TestUnusableStore::anotherProgramsDatabaseIsRefused()
{
    {
        sqlite::Connection other(m_file, 0ms);
        other.run("CREATE TABLE bookmark (name TEXT); PRAGMA application_id = 1234");
    }
    const std::string before = contentOf(m_file);
    expectRefused("axiscomp.db cannot be read: it is the database of another program");
    QVERIFY(contentOf(m_file) == before);
}

void TestUnusableStore::aNewerVersionIsRefused()
{
    VERIFY_RESULT(DriveStore(m_root).recordFlash(serial, WallTime{}, 1));
    const std::int64_t ours = sqlite::Connection(m_file, 0ms).number("PRAGMA user_version");
    sqlite::Connection(m_file, 0ms).run("PRAGMA user_version = 1000");
    expectRefused("a newer version of this program has written it; use that version");
    sqlite::Connection(m_file, 0ms).run("PRAGMA user_version = " + std::to_string(ours));
    QCOMPARE(DriveStore(m_root).flashHistory(serial)->total, std::uint64_t{1});
}

void TestUnusableStore::whatIsNoFileIsRefused_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("kind");
    for (const char* name :
        {"axiscomp.db", "axiscomp.db-journal", "axiscomp.db-wal", "axiscomp.db-shm"})
        for (const char* kind : {"pipe", "folder", "device"})
            QTest::addRow("%s: %s", name, kind)
                << QString::fromLatin1(name) << QString::fromLatin1(kind);
}

void TestUnusableStore::whatIsNoFileIsRefused()
{
    QFETCH(QString, name);
    QFETCH(QString, kind);
    VERIFY_RESULT(DriveStore(m_root).recordFlash(serial, WallTime{}, 1));
    const fs::path place = m_root / name.toStdString();
    fs::remove(place);
    if (kind == QStringLiteral("pipe"))
        QCOMPARE(::mkfifo(place.c_str(), 0600), 0);
    else if (kind == QStringLiteral("folder"))
        fs::create_directory(place);
    else
        fs::create_symlink("/dev/zero", place);
    expectRefused(name.toStdString() + " cannot be read: it is not an ordinary file; move it away");
}

void TestUnusableStore::aPipeInPlaceOfAKeptTableIsRefused()
{
    DriveStore store(m_root);
    const Bytes table(60);
    const auto kept = store.keepTable(serial, 0, table);
    VERIFY_RESULT(kept);
    fs::remove(kept->file);
    QCOMPARE(::mkfifo(kept->file.c_str(), 0600), 0);
    VERIFY_ERROR(store.keptTable(*kept), ErrorCode::FileNotReadable);
    VERIFY_ERROR(store.keepTable(serial, 0, table), ErrorCode::FileNotReadable);
    QVERIFY(fs::is_fifo(kept->file));
}

void TestUnusableStore::aReadOnlyFileSystemIsNamed()
{
    VERIFY_RESULT(DriveStore(m_root).recordFlash(serial, WallTime{}, 1));
    if (::mount(m_root.c_str(), m_root.c_str(), nullptr, MS_BIND, nullptr) != 0)
        QSKIP("only root may mount a file system");
    const int remounted =
        ::mount(nullptr, m_root.c_str(), nullptr, MS_BIND | MS_REMOUNT | MS_RDONLY, nullptr);
    expectRefused("the file system is read-only");
    QCOMPARE(::umount(m_root.c_str()), 0);
    QCOMPARE(remounted, 0);
}

void TestUnusableStore::aFullFileSystemIsNamed()
{
    if (::mount("tmpfs", m_root.c_str(), "tmpfs", 0, "size=256k") != 0)
        QSKIP("only root may mount a small file system");
    const auto first = DriveStore(m_root).recordFlash(serial, WallTime{}, 1);
    {
        std::ofstream filler(m_root / "filler");
        for (int i = 0; i < 300 && filler.write(std::string(1024, 'x').data(), 1024).flush(); ++i) {
        }
    }
    const auto second = DriveStore(m_root, 30ms).openJournal(someEntry());
    fs::remove(m_root / "filler");
    const auto history = DriveStore(m_root).flashHistory(serial);
    const auto journal = DriveStore(m_root).journal(serial, 0);
    QCOMPARE(::umount(m_root.c_str()), 0);
    VERIFY_RESULT(first);
    QVERIFY(!second.has_value());
    QVERIFY2(sentence(second.error()).find("the disk is full") != std::string::npos,
        sentence(second.error()).c_str());
    VERIFY_RESULT(history);
    QCOMPARE(history->total, std::uint64_t{1});
    VERIFY_RESULT(journal);
    QVERIFY(!journal->has_value());
}

AXISCOMP_TEST(TestUnusableStore)

} // namespace tst_unusablestore

#include "tst_unusablestore.moc"
