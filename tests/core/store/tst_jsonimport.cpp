// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/drive_store.h"
#include "core/store/trusted_certificates.h"
#include "tests/support/kill_points.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTemporaryDir>

#include <fstream>
#include <set>

namespace tst_jsonimport {

using namespace axiscomp;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

constexpr std::int32_t serial = 1559;
constexpr int momentStep = 11; ///< of some hundred system calls
const WallTime start = *utcFromText("2026-11-21T08:02:23.25Z");

/// A state folder that the last version before the database has written.
void copyOldFolder(const fs::path& root)
{
    fs::copy(fs::path(AXISCOMP_SOURCE_FOLDER "/tests/data/state/json"), root,
        fs::copy_options::recursive);
}

void put(const fs::path& file, const std::string& text)
{
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
}

std::set<std::string> filesBelow(const fs::path& root)
{
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(root))
        if (entry.is_regular_file())
            names.insert(entry.path().lexically_relative(root).string());
    return names;
}

/// What is wrong with what was taken over; empty when it is all there, once.
std::string whatIsWrong(const fs::path& root)
{
    DriveStore store(root);
    const auto first = store.journal(serial, 0);
    const auto second = store.journal(serial, 1);
    if (!first || !*first || !second || !*second)
        return "a journal is missing";
    JournalEntry entry;
    entry.serialNumber = serial;
    entry.time = start + 1ms;
    entry.step = "commit";
    entry.backup = root / "1559" / "backups" / "2026-11-21T08-02-23.25Z-axis0.json";
    entry.newRegisters = {{"Axes[0]/Parameters/Compensations/Axis/Dim1Source", 17U},
        {"Axes[0]/Parameters/Compensations/Axis/Table", std::string("Small2")}};
    entry.newSlot = "Small2";
    entry.newCrc = 0x00c0ffee;
    entry.persistent = true;
    entry.newTable =
        JournalEntry::KeptTable{root / "1559" / "journal-axis0-88677aed.TAMtbl", 60, 0x88677aed};
    if (!(**first == entry))
        return "the journal of axis 0 differs";
    if (const auto table = store.keptTable(*entry.newTable); !table || table->size() != 60)
        return "the kept table cannot be read";
    entry.axis = 1;
    entry.step = "upload";
    entry.backup = "/elsewhere/backup.json";
    entry.persistent = false;
    entry.newTable.reset();
    if (!(**second == entry))
        return "the journal of axis 1 differs";
    DriveStore::FlashHistory history;
    history.recent.assign(994, start);
    history.recent.insert(history.recent.end(), 5, start + 1s);
    history.recent.push_back(start - 1h);
    history.total = 1004;
    history.refusal = {start + 2s, 75s};
    if (store.flashHistory(serial) != history)
        return "the flash history differs";
    if (store.flashHistory(-2) != DriveStore::FlashHistory{{start, start}, 2})
        return "the flash history of drive -2 differs";
    using Tables = std::vector<DriveStore::OwnTable>;
    if (store.ownTables(serial, 0) != Tables{{"Small1", 3}, {"Small1", 1}}
        || store.ownTables(serial, 1) != Tables{{"Small2", 0xfffffffe}})
        return "the own tables differ";
    const SavedState state{
        true, {{0, "Small1", 1}, {1, "Small2", 2}, {0, "Small3", 3}}, {"Small1"}};
    if (store.savedState(serial) != state)
        return "what a reboot brings back differs";
    const auto fingerprint = [](char digit) { return *sha256Fingerprint(std::string(64, digit)); };
    if (TrustedCertificates(root).all()
        != std::vector<TrustedCertificates::Entry>{{"https://192.168.1.20", fingerprint('a')},
            {"https://drive.example:8443", fingerprint('b')}})
        return "the certificates differ";
    return {};
}

} // namespace

class TestJsonImport final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnWarnings();
        m_temporary = std::make_unique<QTemporaryDir>();
        m_root = fs::path(m_temporary->path().toStdString()) / "state";
    }

    void everythingIsTakenOverOnce();
    void killedAnywhereNothingIsLostOrThereTwice();
    void whatAnOlderVersionWritesLaterIsAdded();
    void aDocumentWithoutEndIsBroken_data();
    void aDocumentWithoutEndIsBroken();
    void theUserDecidesAboutADamagedHistory();

private:
    std::unique_ptr<QTemporaryDir> m_temporary;
    fs::path m_root;
};

void TestJsonImport::everythingIsTakenOverOnce()
{
    copyOldFolder(m_root);
    const std::set<std::string> before = filesBelow(m_root);
    QCOMPARE(whatIsWrong(m_root), std::string());
    QCOMPARE(whatIsWrong(m_root), std::string()); // and is not taken over again
    std::set<std::string> expected{"axiscomp.db", "axiscomp.lock"};
    for (const std::string& name : before) {
        const bool stays = name.find("backups") != std::string::npos || name.ends_with(".TAMtbl");
        expected.insert(stays ? name : name + ".imported");
    }
    QCOMPARE(filesBelow(m_root), expected);
    VERIFY_RESULT(DriveStore(m_root).closeJournal(serial, 0));
    QVERIFY(!DriveStore(m_root).journal(serial, 0)->has_value());
}

void TestJsonImport::killedAnywhereNothingIsLostOrThereTwice()
{
    const auto prepare = [&] {
        fs::remove_all(m_root);
        copyOldFolder(m_root);
        // The long history makes every moment slow.
        put(m_root / "1559" / "flash.json",
            R"({"format": "axiscomp-flash-history", "version": 1, "total": 7,
                "recent": ["2026-11-21T08:02:23Z"]})");
    };
    prepare();
    const int moments = test::killEverywhere(
        [&] { ::_exit(DriveStore(m_root).flashHistory(serial).has_value() ? 0 : 1); },
        [&] {
            DriveStore store(m_root);
            QCOMPARE(store.flashHistory(serial)->total, std::uint64_t{7});
            QCOMPARE(store.flashHistory(-2)->total, std::uint64_t{2});
            QCOMPARE(store.ownTables(serial, 0)->size(), std::size_t{2});
            QVERIFY(store.journal(serial, 1)->has_value());
            QVERIFY(fs::exists(m_root / "1559" / "flash.json.imported"));
            QVERIFY(!fs::exists(m_root / "1559" / "flash.json"));
            prepare();
        },
        momentStep);
    QVERIFY2(moments > 50, std::to_string(moments).c_str());
}

void TestJsonImport::whatAnOlderVersionWritesLaterIsAdded()
{
    VERIFY_RESULT(DriveStore(m_root).recordFlash(-2, start - 1h, 1));
    fs::create_directories(m_root / "-2");
    fs::copy(
        fs::path(AXISCOMP_SOURCE_FOLDER "/tests/data/state/json/-2/flash.json"), m_root / "-2");
    const auto history = DriveStore(m_root).flashHistory(-2);
    VERIFY_RESULT(history);
    QVERIFY((*history == DriveStore::FlashHistory{{start - 1h, start, start}, 3}));
}

void TestJsonImport::aDocumentWithoutEndIsBroken_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("many values")
        << QByteArray(R"({"format": "axiscomp-tables", "version": 1, "tables": [0)")
            + QByteArray(",0").repeated(20'000) + "]}";
    QTest::newRow("deep") << QByteArray(1000, '[');
    QTest::newRow("large") << QByteArray(1024 * 1024 + 1, ' ');
}

void TestJsonImport::aDocumentWithoutEndIsBroken()
{
    QFETCH(QByteArray, text);
    for (const char* name : {"flash.json", "tables.json", "saved.json"})
        put(m_root / "1559" / name, text.toStdString());
    VERIFY_RESULT(DriveStore(m_root).ownTables(serial, 0));
    for (const char* name : {"flash.json", "tables.json", "saved.json"})
        QVERIFY(fs::exists(m_root / "1559" / (name + std::string(".broken"))));
}

void TestJsonImport::theUserDecidesAboutADamagedHistory()
{
    put(m_root / "1559" / "flash.json", "{");
    const FlashWearLimits limits{.operations = 8, .window = 10min};
    DriveStore store(m_root);
    const FlashBudget budget = wearGuard(limits, *store.flashHistory(serial)).budget(start);
    QCOMPARE(budget.left, 0);
    QVERIFY(budget.isRecordLost);
    VERIFY_RESULT(store.acceptFlashLoss(serial));
    const auto decided = DriveStore(m_root).flashHistory(serial);
    QVERIFY(!decided->damagedRecord);
    QCOMPARE(wearGuard(limits, *decided).budget(start).left, 8);
}

AXISCOMP_TEST(TestJsonImport)

} // namespace tst_jsonimport

#include "tst_jsonimport.moc"
