// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive/compensation_setup.h"
#include "core/store/backup_folder.h"
#include "core/store/drive_store.h"
#include "core/store/sqlite.h"
#include "tests/support/file_content.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTemporaryDir>

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <set>
#include <thread>

#include <sys/stat.h>

namespace tst_drivestore {

using namespace axiscomp;
using axiscomp::test::contentOf;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

constexpr std::int32_t serial = 1559;
const WallTime start = *utcFromText("2026-11-21T08:02:23Z");

AxisBackup backupAt(WallTime time, int axis = 0)
{
    AxisBackup backup;
    backup.drive = {"Triamec-616", serial, 2};
    backup.axis = axis;
    backup.axisName = "X";
    backup.time = time;
    backup.registers = {{"Axes[0]/Parameters/Compensations/Axis/Table", std::string("Small1")}};
    backup.files = {{"Small1", "tables/small1.TAMtbl", Bytes(100, std::byte{7}), true}};
    return backup;
}

JournalEntry entryFor(int axis)
{
    JournalEntry entry;
    entry.serialNumber = serial;
    entry.axis = axis;
    entry.time = start + 1ms;
    entry.step = "upload";
    entry.backup = "/elsewhere/backup.json";
    entry.newRegisters = {{"Axes[0]/Parameters/Compensations/Axis/Dim1Source", 17U}};
    entry.newSlot = "Small2";
    entry.newCrc = 0x00c0ffee;
    entry.persistent = true;
    entry.deletedSlot = "Small4";
    entry.newUnits = {"Millimeter", {"Millimeter", "", "Degree"}};
    entry.newSourcePaths = {"Axes[0]/Signals/Position", "", "Axes[1]/Signals/Position"};
    return entry;
}

void put(const fs::path& file, std::string_view text)
{
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
}

std::set<std::string> namesIn(const fs::path& folder)
{
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.insert(entry.path().filename().string());
    return names;
}

} // namespace

class TestDriveStore : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnWarnings();
        m_temporary = std::make_unique<QTemporaryDir>();
        QVERIFY(m_temporary->isValid());
        m_root = fs::path(m_temporary->path().toStdString()) / "state" / "axiscomp";
        m_folder = m_root / "1559";
        m_store = std::make_unique<DriveStore>(m_root, 30ms);
    }

    void readingMakesNothing();
    void rootFollowsXdg();
    void foldersAreForTheUserOnly();
    void drivesAreApart();

    void backupIsDatedAndReadsBack();
    void backupsOfOneMomentAreKeptApart();
    void newestFiftyOfTheAxisAreKept();
    void backupOfAClockSetBackIsKept();
    void theNewestBackupsAreThoseMadeLastWhateverTheClockSaid();
    void backupOfAnOpenWriteIsKept();
    void foreignFilesAreLeftAlone();
    void leftoversOfACrashAreRemoved();
    void backupOfNotANumberIsKept();

    void journalComesBackUntilItIsClosed();
    void journalIsPerAxis();
    void journalOutlivesAMoveOfTheStore();
    void brokenJournalSaysWhatToDo_data();
    void brokenJournalSaysWhatToDo();
    void journalOfAnotherAxisIsNotTaken();
    void aNewEntryReplacesABrokenJournal();

    void flashHistoryIsKeptAcrossRuns();
    void flashHistoryIsBounded();
    void brokenFileIsMovedAside_data();
    void brokenFileIsMovedAside();
    void whatStandsInTheWayIsNoObstacle();

    void ownTablesAreNewestFirst();
    void figuresAreThoseOfOneTableOfOneAxis();
    void theLatestFiguresOfATableCount();
    void figuresOfTheLast50TablesAreKept();
    void whatIsBeingSavedIsAddedAndWhatIsSavedReplaces();
    void aSlotBelongsToWhoWroteItLast();
    void anUndoneWriteLeavesTheSlotKnown();

    void anotherProgramIsWaitedForAndNamed();
    void writeLockExcludesWritersOnly();
    void nothingIsLostBetweenPrograms();
    void unwritableRootIsNamed();
    void sourceUriNamesTheDrive();

private:
    std::unique_ptr<QTemporaryDir> m_temporary;
    fs::path m_root;
    fs::path m_folder;
    std::unique_ptr<DriveStore> m_store;
};

void TestDriveStore::readingMakesNothing()
{
    VERIFY_RESULT(m_store->journal(serial, 0));
    QVERIFY(!m_store->journal(serial, 0)->has_value());
    VERIFY_RESULT(m_store->flashHistory(serial));
    QVERIFY(m_store->flashHistory(serial)->recent.empty());
    VERIFY_RESULT(m_store->ownTables(serial, 0));
    QVERIFY(m_store->ownTables(serial, 0)->empty());
    VERIFY_RESULT(m_store->closeJournal(serial, 0));
    VERIFY_RESULT(m_store->recordFlash(serial, start, 0));
    QVERIFY(!fs::exists(m_root));
}

void TestDriveStore::rootFollowsXdg()
{
    const QByteArray oldState = qgetenv("XDG_STATE_HOME");
    const QByteArray oldHome = qgetenv("HOME");
    qputenv("XDG_STATE_HOME", "/state");
    QCOMPARE(DriveStore::defaultRoot(), fs::path("/state/axiscomp"));
    qputenv("XDG_STATE_HOME", "relative");
    qputenv("HOME", "/home/me");
    QCOMPARE(DriveStore::defaultRoot(), fs::path("/home/me/.local/state/axiscomp"));
    qunsetenv("XDG_STATE_HOME");
    QCOMPARE(DriveStore::defaultRoot(), fs::path("/home/me/.local/state/axiscomp"));
    qunsetenv("HOME");
    QVERIFY(DriveStore::defaultRoot().is_absolute());
    QVERIFY(DriveStore::defaultRoot().string().ends_with("/.local/state/axiscomp"));
    qputenv("HOME", oldHome);
    if (!oldState.isEmpty())
        qputenv("XDG_STATE_HOME", oldState);
}

void TestDriveStore::foldersAreForTheUserOnly()
{
    VERIFY_RESULT(m_store->saveBackup(backupAt(start)));
    for (const fs::path& folder : {m_root, m_folder, m_folder / "backups"}) {
        struct stat status { };
        QCOMPARE(::stat(folder.c_str(), &status), 0);
        QCOMPARE(status.st_mode & 0777U, 0700U);
    }
}

void TestDriveStore::drivesAreApart()
{
    VERIFY_RESULT(m_store->recordFlash(1, start, 3));
    VERIFY_RESULT(m_store->recordFlash(-2, start, 1));
    VERIFY_RESULT(m_store->recordOwnTable(1, 0, {"Small1", 5}));
    QCOMPARE(m_store->flashHistory(1)->total, std::uint64_t{3});
    QCOMPARE(m_store->flashHistory(-2)->total, std::uint64_t{1});
    QVERIFY(m_store->ownTables(-2, 0)->empty());
    m_store.reset();
    QCOMPARE(namesIn(m_root), (std::set<std::string>{"axiscomp.db", "axiscomp.lock"}));
}

void TestDriveStore::backupIsDatedAndReadsBack()
{
    const auto file = m_store->saveBackup(backupAt(start + 250ms));
    VERIFY_RESULT(file);
    QCOMPARE(*file, m_folder / "backups" / "2026-11-21T08-02-23.25Z-axis0.json");
    const auto backup = readBackup(contentOf(*file), file->string());
    VERIFY_RESULT(backup);
    QVERIFY(backup->axes == std::vector{backupAt(start + 250ms)});
}

void TestDriveStore::backupsOfOneMomentAreKeptApart()
{
    std::set<fs::path> files;
    for (int i = 0; i < 12; ++i) {
        const auto file = m_store->saveBackup(backupAt(start));
        VERIFY_RESULT(file);
        files.insert(*file);
    }
    QCOMPARE(files.size(), std::size_t{12});
    for (const fs::path& file : files)
        QVERIFY(fs::exists(file));
}

void TestDriveStore::newestFiftyOfTheAxisAreKept()
{
    const auto other = m_store->saveBackup(backupAt(start - 1h, 1));
    const auto eleventh = m_store->saveBackup(backupAt(start - 1h, 11)); // "axis1" begins "axis11"
    std::vector<fs::path> files;
    for (int i = 0; i < 53; ++i)
        files.push_back(*m_store->saveBackup(backupAt(start + 1s * (i / 2), 0)));
    for (std::size_t i = 0; i < files.size(); ++i)
        QCOMPARE(fs::exists(files[i]), i >= 3);
    QVERIFY(fs::exists(*other));
    QVERIFY(fs::exists(*eleventh));
    QCOMPARE(namesIn(m_folder / "backups").size(), std::size_t{52});
}

void TestDriveStore::backupOfAClockSetBackIsKept()
{
    for (int i = 0; i < 50; ++i)
        VERIFY_RESULT(m_store->saveBackup(backupAt(start + 1s * i)));
    const auto file = m_store->saveBackup(backupAt(start - 24h * 365));
    VERIFY_RESULT(file);
    QVERIFY(fs::exists(*file));
    QCOMPARE(namesIn(m_folder / "backups").size(), std::size_t{50});
}

/// As of a computer whose battery is empty, and which is told the time later.
void TestDriveStore::theNewestBackupsAreThoseMadeLastWhateverTheClockSaid()
{
    std::vector<fs::path> files;
    const auto make = [&](WallTime time) {
        const auto file = m_store->saveBackup(backupAt(time));
        VERIFY_RESULT(file);
        files.push_back(*file);
        QVERIFY(m_store->backups(serial, 0).front() == *file);
    };
    for (int i = 0; i < 50; ++i)
        make(start + 1s * i);
    const WallTime empty = start - 24h * 365;
    for (const WallTime time : {empty, empty, empty + 1h, empty - 24h, empty})
        make(time);
    make(start + 1h);
    const std::vector<fs::path> newest(files.rbegin(), files.rbegin() + 50);
    QVERIFY(m_store->backups(serial, 0) == newest);
    QCOMPARE(files[51].filename(), fs::path("2025-11-21T08-02-23Z-axis0-clock2-2.json"));
    QCOMPARE(files[53].filename(), fs::path("2025-11-20T08-02-23Z-axis0-clock3.json"));
    QVERIFY(timeOfBackup(files[51], 0) == empty);
}

void TestDriveStore::backupOfAnOpenWriteIsKept()
{
    const auto first = m_store->saveBackup(backupAt(start));
    VERIFY_RESULT(first);
    JournalEntry entry = entryFor(0);
    entry.backup = *first;
    VERIFY_RESULT(m_store->openJournal(entry));
    for (int i = 1; i < 60; ++i)
        VERIFY_RESULT(m_store->saveBackup(backupAt(start + 1s * i)));
    QVERIFY(fs::exists(*first));
    QCOMPARE(namesIn(m_folder / "backups").size(), std::size_t{51});

    // A journal that cannot be read may name any backup: none is deleted.
    VERIFY_RESULT(m_store->closeJournal(serial, 0));
    put(m_folder / "journal-axis0.json", "broken");
    VERIFY_RESULT(m_store->saveBackup(backupAt(start + 1h)));
    QCOMPARE(namesIn(m_folder / "backups").size(), std::size_t{52});

    VERIFY_RESULT(m_store->closeJournal(serial, 0));
    VERIFY_RESULT(m_store->saveBackup(backupAt(start + 2h)));
    QVERIFY(!fs::exists(*first));
    QCOMPARE(namesIn(m_folder / "backups").size(), std::size_t{50});
}

void TestDriveStore::foreignFilesAreLeftAlone()
{
    const fs::path backups = m_folder / "backups";
    const std::set<std::string> foreign{"notes.txt", "2026-11-21T08-02-23Z-axis0.json.keep",
        "2026-11-21T08-02-23Z-axis0-x.json", "2026-99-21T08-02-23Z-axis0.json", "-axis0.json",
        "old-2020-11-21T08-02-23Z-axis0.json", "2020-11-21T08-02-23Z-axis0-1.json",
        "2020-11-21T08-02-23Z-axis0-02.json"};
    for (const std::string& name : foreign)
        put(backups / name, "x");
    for (int i = 0; i < 60; ++i)
        VERIFY_RESULT(m_store->saveBackup(backupAt(start + 1s * i)));
    const std::set<std::string> names = namesIn(backups);
    QVERIFY(std::ranges::includes(names, foreign));
    QCOMPARE(names.size(), foreign.size() + 50);
}

void TestDriveStore::leftoversOfACrashAreRemoved()
{
    put(m_folder / ".axiscomp-1-0.tmp", "half a journ");
    put(m_folder / "backups" / ".axiscomp-1-1.tmp", "half a back");
    VERIFY_RESULT(m_store->saveBackup(backupAt(start)));
    QVERIFY(!fs::exists(m_folder / ".axiscomp-1-0.tmp"));
    QCOMPARE(namesIn(m_folder / "backups").size(), std::size_t{1});
}

void TestDriveStore::backupOfNotANumberIsKept()
{
    AxisBackup backup = backupAt(start);
    backup.registers = {{"a", std::numeric_limits<float>::quiet_NaN()}};
    backup.drive.name = "not UTF-8: \xff";
    VERIFY_RESULT(m_store->saveBackup(backup));
}

void TestDriveStore::journalComesBackUntilItIsClosed()
{
    JournalEntry entry = entryFor(0);
    VERIFY_RESULT(m_store->openJournal(entry));
    entry.step = "commit";
    VERIFY_RESULT(m_store->openJournal(entry));
    const auto kept = DriveStore(m_root).journal(serial, 0);
    VERIFY_RESULT(kept);
    QVERIFY(*kept == entry);
    VERIFY_RESULT(m_store->closeJournal(serial, 0));
    QVERIFY(!m_store->journal(serial, 0)->has_value());
}

void TestDriveStore::journalIsPerAxis()
{
    VERIFY_RESULT(m_store->openJournal(entryFor(0)));
    VERIFY_RESULT(m_store->openJournal(entryFor(3)));
    VERIFY_RESULT(m_store->closeJournal(serial, 0));
    QVERIFY(!m_store->journal(serial, 0)->has_value());
    QVERIFY(*m_store->journal(serial, 3) == entryFor(3));
}

void TestDriveStore::journalOutlivesAMoveOfTheStore()
{
    JournalEntry entry = entryFor(0);
    entry.backup = *m_store->saveBackup(backupAt(start));
    VERIFY_RESULT(m_store->openJournal(entry));
    const fs::path moved = m_root.parent_path() / "moved";
    fs::rename(m_root, moved);
    const auto kept = DriveStore(moved).journal(serial, 0);
    VERIFY_RESULT(kept);
    QCOMPARE((*kept)->backup, moved / "1559" / entry.backup.lexically_relative(m_folder));
    QVERIFY(fs::exists((*kept)->backup));
}

void TestDriveStore::brokenJournalSaysWhatToDo_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("empty") << QByteArray("");
    QTest::newRow("half") << QByteArray("{\"format\": \"axiscomp-journal\", \"vers");
    QTest::newRow("other document") << QByteArray("[]");
    QTest::newRow("too large") << QByteArray(2'000'000, ' ');
}

void TestDriveStore::brokenJournalSaysWhatToDo()
{
    QFETCH(QByteArray, text);
    const fs::path file = m_folder / "journal-axis0.json";
    put(file, text.toStdString());
    const auto journal = m_store->journal(serial, 0);
    VERIFY_ERROR(journal, ErrorCode::FileNotReadable);
    QCOMPARE(journal.error().context.english("file"), file.string());
    const std::string reason = journal.error().context.english("reason");
    QVERIFY2(reason.find("then delete the file") != std::string::npos, reason.c_str());
    QCOMPARE(contentOf(file), text.toStdString());
}

void TestDriveStore::journalOfAnotherAxisIsNotTaken()
{
    put(m_folder / "journal-axis0.json",
        R"({"format": "axiscomp-journal", "version": 1, "serialNumber": 1559, "axis": 1,
            "time": "2026-11-21T08:02:23Z", "step": "upload", "backup": "", "newRegisters": [],
            "newSlot": "Small2", "newCrc": "00c0ffee", "persistent": true})");
    const auto journal = m_store->journal(serial, 0);
    VERIFY_ERROR(journal, ErrorCode::FileNotReadable);
    QVERIFY(journal.error().context.english("reason").find("axis 1 of drive 1559")
        != std::string::npos);
}

void TestDriveStore::aNewEntryReplacesABrokenJournal()
{
    put(m_folder / "journal-axis0.json", "broken");
    VERIFY_RESULT(m_store->openJournal(entryFor(0)));
    QVERIFY(*m_store->journal(serial, 0) == entryFor(0));
    QCOMPARE(contentOf(m_folder / "journal-axis0.json.broken"), std::string("broken"));
}

void TestDriveStore::flashHistoryIsKeptAcrossRuns()
{
    VERIFY_RESULT(m_store->recordFlash(serial, start, 2));
    VERIFY_RESULT(DriveStore(m_root).recordFlash(serial, start + 1500ms, 1));
    const auto history = DriveStore(m_root).flashHistory(serial);
    VERIFY_RESULT(history);
    QVERIFY(*history == (DriveStore::FlashHistory{{start, start, start + 1500ms}, 3}));
}

void TestDriveStore::flashHistoryIsBounded()
{
    VERIFY_RESULT(m_store->recordFlash(serial, start, 5));
    VERIFY_RESULT(m_store->recordFlash(serial, start + 1s, 998));
    VERIFY_RESULT(m_store->recordFlash(serial, start - 1h, 1)); // the clock was set back
    const auto history = m_store->flashHistory(serial);
    VERIFY_RESULT(history);
    QCOMPARE(history->total, std::uint64_t{1004});
    QCOMPARE(history->recent.size(), std::size_t{1000});
    QVERIFY(history->recent.front() == start);
    QVERIFY(history->recent.back() == start - 1h);
    VERIFY_RESULT(m_store->recordFlash(serial, start, 1'000'000));
    QCOMPARE(m_store->flashHistory(serial)->recent.size(), std::size_t{1000});
    QCOMPARE(m_store->flashHistory(serial)->total, std::uint64_t{1001004});
}

void TestDriveStore::brokenFileIsMovedAside_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("text");
    for (const char* name : {"flash.json", "tables.json", "saved.json"}) {
        const QString file = QString::fromLatin1(name);
        QTest::addRow("%s empty", name) << file << QByteArray("");
        QTest::addRow("%s half", name) << file << QByteArray("{\"format\": \"axi");
        QTest::addRow("%s foreign", name) << file << QByteArray("{\"a\": 1}");
        QTest::addRow("%s too large", name) << file << QByteArray(2'000'000, ' ');
    }
    QTest::addRow("negative total")
        << QStringLiteral("flash.json")
        << QByteArray(
               R"({"format": "axiscomp-flash-history", "version": 1, "total": -1, "recent": []})");
    QTest::addRow("a wrong time")
        << QStringLiteral("flash.json")
        << QByteArray(
               R"({"format": "axiscomp-flash-history", "version": 1, "total": 1, "recent": [0]})");
}

void TestDriveStore::brokenFileIsMovedAside()
{
    QFETCH(QString, name);
    QFETCH(QByteArray, text);
    const fs::path file = m_folder / name.toStdString();
    put(file.string() + ".broken", "an earlier one");
    put(file, text.toStdString());

    const auto history = m_store->flashHistory(serial);
    VERIFY_RESULT(history);
    QVERIFY(history->recent.empty());
    // What the drive may still store is not known then.
    const fs::path aside = file.string() + ".broken-2";
    QVERIFY(history->damagedRecord
        == (name == QStringLiteral("flash.json") ? std::optional(aside) : std::nullopt));
    QVERIFY(!m_store->flashHistory(serial + 1)->damagedRecord);
    const auto own = m_store->ownTables(serial, 0);
    VERIFY_RESULT(own);
    QVERIFY(own->empty());
    const auto state = m_store->savedState(serial);
    VERIFY_RESULT(state);
    QVERIFY(*state == SavedState{});
    QVERIFY(!fs::exists(file));
    QCOMPARE(contentOf(aside), text.toStdString());
    QCOMPARE(contentOf(file.string() + ".broken"), std::string("an earlier one"));

    VERIFY_RESULT(m_store->recordFlash(serial, start, 1));
    VERIFY_RESULT(m_store->recordOwnTable(serial, 0, {"Small1", 1}));
    VERIFY_RESULT(m_store->recordCovered(serial, "Small1", true));
    QVERIFY(m_store->savedState(serial)->isCovered("Small1"));
    QCOMPARE(m_store->flashHistory(serial)->total, std::uint64_t{1});
    QCOMPARE(m_store->ownTables(serial, 0)->size(), std::size_t{1});
}

void TestDriveStore::whatStandsInTheWayIsNoObstacle()
{
    put(m_folder / "elsewhere" / "inner", "x");
    put(m_folder / "flash.json", "broken");
    fs::create_symlink("elsewhere", m_folder / "flash.json.broken");
    fs::create_directories(m_folder / "tables.json" / "inner");
    QCOMPARE(::mkfifo((m_folder / "saved.json").c_str(), 0600), 0);
    VERIFY_RESULT(m_store->flashHistory(serial));
    QCOMPARE(contentOf(m_folder / "flash.json.broken-2"), std::string("broken"));
    QVERIFY(fs::exists(m_folder / "elsewhere" / "inner"));
    QVERIFY(fs::is_directory(m_folder / "tables.json.broken" / "inner"));
    QVERIFY(fs::is_fifo(m_folder / "saved.json.broken"));
    VERIFY_RESULT(m_store->recordOwnTable(serial, 0, {"Small1", 1}));
}

void TestDriveStore::whatIsBeingSavedIsAddedAndWhatIsSavedReplaces()
{
    using Use = SavedState::Use;
    const Use first{0, "Small1", 1};
    const Use second{1, "Small2", 2};
    VERIFY_RESULT(m_store->recordSaving(serial, {first}));
    QVERIFY(!m_store->savedState(serial)->isKnown);
    VERIFY_RESULT(m_store->recordSaved(serial, {first}));
    VERIFY_RESULT(m_store->recordSaving(serial, {first, second}));
    VERIFY_RESULT(m_store->recordCovered(serial, "Small3", true));
    const auto both = m_store->savedState(serial);
    VERIFY_RESULT(both);
    QVERIFY(both->isKnown);
    QVERIFY((both->uses == std::vector{first, second}));
    QVERIFY(both->otherUser("Small2", 0) == 1);
    QVERIFY(!both->otherUser("Small2", 1));
    QVERIFY(both->isInTheWay("Small2", 0, 2));
    QVERIFY(both->isInTheWay("Small2", 1, 3));
    QVERIFY(!both->isInTheWay("Small2", 1, 2));
    QVERIFY(!both->isInTheWay("Small3", 1, 2));

    VERIFY_RESULT(m_store->recordSaved(serial, {second}));
    QVERIFY(m_store->savedState(serial)->uses == std::vector{second});
    QVERIFY(m_store->savedState(serial)->isCovered("Small3"));
    VERIFY_RESULT(m_store->recordCovered(serial, "Small3", false));
    QVERIFY(m_store->savedState(serial)->covered.empty());
    QVERIFY(m_store->savedState(serial + 1)->uses.empty());
}

void TestDriveStore::ownTablesAreNewestFirst()
{
    VERIFY_RESULT(m_store->recordOwnTable(serial, 0, {"Small1", 1}));
    VERIFY_RESULT(m_store->recordOwnTable(serial, 0, {"Small2", 2}));
    VERIFY_RESULT(m_store->recordOwnTable(serial, 1, {"Small3", 3}));
    VERIFY_RESULT(m_store->recordOwnTable(serial, 0, {"Small1", 4}));
    using Tables = std::vector<DriveStore::OwnTable>;
    QVERIFY(
        *m_store->ownTables(serial, 0) == (Tables{{"Small1", 4}, {"Small2", 2}, {"Small1", 1}}));
    QVERIFY(*m_store->ownTables(serial, 1) == (Tables{{"Small3", 3}}));
}

void TestDriveStore::figuresAreThoseOfOneTableOfOneAxis()
{
    QVERIFY(!m_store->measured(serial, 0, 7)->has_value());
    const MeasuredFigures first{7, start, "2026-11-20", true,
        {{"A", 0.1 + 0.2, 1e-300, std::nullopt, -0.0, "undecided"}, {"B"}}};
    MeasuredFigures second{4'000'000'000, start + 1s, "", false, {{"A", 1.0, {}, 2.0, 3.0}}};
    second.excluded = 3;
    second.lesserRange = TwoRanges{{-0.1, 500.0}, {0.0, 1.0 / 3.0}};
    second.grid = Grid{{{"", "", -0.1, 1.0 / 3.0, 5}, {"", "", 7.0, 2.0, 2}}};
    second.madeFor = {LookupAt::Set, {"#2", "other"}};
    second.units = TableUnits{"mm", {"mm", ""}};
    second.axisName = "X";
    VERIFY_RESULT(m_store->recordMeasured(serial, 0, first));
    VERIFY_RESULT(m_store->recordMeasured(serial, 0, second));
    m_store = std::make_unique<DriveStore>(m_root);
    QVERIFY(*m_store->measured(serial, 0, 7) == first);
    QVERIFY(*m_store->measured(serial, 0, 4'000'000'000) == second);
    QVERIFY(!m_store->measured(serial, 1, 7)->has_value());
    QVERIFY(!m_store->measured(serial + 1, 0, 7)->has_value());
}

void TestDriveStore::theLatestFiguresOfATableCount()
{
    VERIFY_RESULT(m_store->recordMeasured(serial, 0, {7, start, "", false, {{"A", 1.0}, {"B"}}}));
    const MeasuredFigures later{7, start + 1s, "", false, {{"A", 1.0, {}, 0.1}}};
    VERIFY_RESULT(m_store->recordMeasured(serial, 0, later));
    QVERIFY(*m_store->measured(serial, 0, 7) == later);
}

void TestDriveStore::figuresOfTheLast50TablesAreKept()
{
    VERIFY_RESULT(m_store->recordMeasured(serial, 1, {1, start, "", false, {{"A", 1.0}}}));
    for (std::uint32_t crc = 1; crc <= 51; ++crc)
        VERIFY_RESULT(m_store->recordMeasured(serial, 0, {crc, start, "", false, {{"A", 1.0}}}));
    QVERIFY(!m_store->measured(serial, 0, 1)->has_value());
    QCOMPARE(m_store->measured(serial, 0, 2).value()->figures.size(), std::size_t{1});
    QVERIFY(m_store->measured(serial, 1, 1)->has_value());
    QCOMPARE(sqlite::Connection(m_root / "axiscomp.db", 0ms)
                 .number("SELECT count(*) FROM measured_figure"),
        std::int64_t{51});
}

void TestDriveStore::aSlotBelongsToWhoWroteItLast()
{
    VERIFY_RESULT(m_store->recordOwnTable(serial, 0, {"Small1", 1}));
    VERIFY_RESULT(m_store->recordOwnTable(serial, 1, {"Small1", 1}));
    QVERIFY(m_store->ownTables(serial, 0)->empty());
    QCOMPARE(m_store->ownTables(serial, 1)->size(), std::size_t{1});
}

void TestDriveStore::anUndoneWriteLeavesTheSlotKnown()
{
    for (std::uint32_t crc = 1; crc <= 6; ++crc)
        VERIFY_RESULT(m_store->recordOwnTable(serial, 0, {"Small1", crc}));
    using Tables = std::vector<DriveStore::OwnTable>;
    QVERIFY(*m_store->ownTables(serial, 0)
        == (Tables{{"Small1", 6}, {"Small1", 5}, {"Small1", 4}, {"Small1", 3}}));
}

void TestDriveStore::anotherProgramIsWaitedForAndNamed()
{
    VERIFY_RESULT(m_store->recordFlash(serial, start, 1));
    const fs::path database = m_root / "axiscomp.db";
    {
        sqlite::Connection other(database, 0ms);
        const sqlite::Transaction held(other, sqlite::Transaction::Kind::Write);
        const auto recorded = m_store->recordFlash(serial, start, 1);
        VERIFY_ERROR(recorded, ErrorCode::FileNotWritable);
        QCOMPARE(recorded.error().context.english("file"), database.string());
        QVERIFY(
            recorded.error().context.english("reason").starts_with("another program is using it"));
        VERIFY_ERROR(m_store->openJournal(entryFor(0)), ErrorCode::FileNotWritable);
        VERIFY_RESULT(m_store->flashHistory(serial)); // reading needs no lock
        VERIFY_RESULT(DriveStore(m_root, 30ms).flashHistory(serial));
    }
    {
        fs::create_directories(m_folder);
        const auto held = FileLock::acquire(m_folder / "lock", 0ms, m_folder);
        VERIFY_RESULT(held);
        VERIFY_ERROR(m_store->saveBackup(backupAt(start)), ErrorCode::FileNotWritable);
    }
    VERIFY_RESULT(m_store->recordFlash(serial, start, 1));
    QCOMPARE(m_store->flashHistory(serial)->total, std::uint64_t{2});

    DriveStore patient{m_root, 60s};
    std::atomic<bool> isHeld = false;
    std::thread other([&] {
        sqlite::Connection connection(database, 0ms);
        const sqlite::Transaction held(connection, sqlite::Transaction::Kind::Write);
        isHeld = true;
        isHeld.notify_one();
        std::this_thread::sleep_for(50ms);
    });
    isHeld.wait(false);
    const auto recorded = patient.recordFlash(serial, start, 1);
    other.join();
    VERIFY_RESULT(recorded);
}

void TestDriveStore::writeLockExcludesWritersOnly()
{
    const auto held = m_store->lockWrites(serial);
    VERIFY_RESULT(held);
    VERIFY_ERROR(m_store->lockWrites(serial), ErrorCode::FileNotWritable);
    VERIFY_RESULT(m_store->lockWrites(serial + 1));
    VERIFY_RESULT(m_store->saveBackup(backupAt(start)));
    VERIFY_RESULT(m_store->openJournal(entryFor(0)));
}

void TestDriveStore::nothingIsLostBetweenPrograms()
{
    constexpr int writers = 4;
    constexpr int each = 10;
    std::atomic<int> failures{0};
    std::vector<std::thread> threads;
    for (int writer = 0; writer < writers; ++writer)
        threads.emplace_back([&, writer] {
            DriveStore store{m_root, 60s};
            for (int i = 0; i < each; ++i) {
                const std::string slot = "slot" + std::to_string(writer);
                failures += !store.recordFlash(serial, start, 1).has_value();
                failures += !store.saveBackup(backupAt(start, writer)).has_value();
                failures += !store.recordOwnTable(serial, writer, {slot, 1}).has_value();
            }
        });
    for (std::thread& thread : threads)
        thread.join();
    QCOMPARE(failures.load(), 0);
    QCOMPARE(m_store->flashHistory(serial)->total, std::uint64_t{writers * each});
    QCOMPARE(namesIn(m_folder / "backups").size(), std::size_t{writers * each});
    for (int writer = 0; writer < writers; ++writer)
        QCOMPARE(m_store->ownTables(serial, writer)->size(), std::size_t{1});
}

void TestDriveStore::unwritableRootIsNamed()
{
    put(m_root, "a file where the store should be");
    VERIFY_ERROR(m_store->saveBackup(backupAt(start)), ErrorCode::FileNotWritable);
    VERIFY_ERROR(m_store->openJournal(entryFor(0)), ErrorCode::FileNotWritable);
    const auto recorded = m_store->recordFlash(serial, start, 1);
    VERIFY_ERROR(recorded, ErrorCode::FileNotWritable);
    QCOMPARE(recorded.error().context.english("file"), (m_root / "axiscomp.db").string());
    QCOMPARE(recorded.error().context.english("reason"),
        std::string("a part of the path is not a folder"));
}

void TestDriveStore::sourceUriNamesTheDrive()
{
    QCOMPARE(sourceUri("Triamec-616", "Axes[0]/Signals/PathPlanner/Position"),
        std::string("tam://mc/Triamec-616/Axes[0]/Signals/PathPlanner/Position"));
}

AXISCOMP_TEST(TestDriveStore)

} // namespace tst_drivestore

#include "tst_drivestore.moc"
