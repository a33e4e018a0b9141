// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/drive_store.h"
#include "core/store/store_json.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTemporaryDir>

#include <fstream>

namespace tst_storelimits {

using namespace axiscomp;
namespace fs = std::filesystem;

namespace {

constexpr std::int32_t serial = 1559;

/// As large as a file of the store may be, or a byte larger.
void grow(const fs::path& file, std::uintmax_t more)
{
    std::ofstream(file, std::ios::app).put('\n');
    fs::resize_file(file, maximumDocumentSize + more);
}

} // namespace

class TestStoreLimits final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aHistoryThatIsTooLargeIsMovedAside();
    void aJournalThatIsTooLargeIsAnError();
    void aListThatIsTooLongIsBroken();
};

void TestStoreLimits::aHistoryThatIsTooLargeIsMovedAside()
{
    const QTemporaryDir folder;
    const fs::path root = folder.path().toStdString();
    DriveStore store(root);
    VERIFY_RESULT(store.recordFlash(serial, WallTime{}, 1));
    VERIFY_RESULT(store.recordOwnTable(serial, 0, {"Small1", 1}));
    VERIFY_RESULT(store.recordCovered(serial, "Small1", true));
    for (const char* name : {"flash.json", "tables.json", "saved.json"}) {
        const fs::path file = root / std::to_string(serial) / name;
        QVERIFY(fs::exists(file));
        grow(file, 1);
        VERIFY_RESULT(store.flashHistory(serial));
        VERIFY_RESULT(store.ownTables(serial, 0));
        VERIFY_RESULT(store.savedState(serial));
        QVERIFY(!fs::exists(file));
        QVERIFY(fs::exists(file.string() + ".broken"));
    }
}

void TestStoreLimits::aJournalThatIsTooLargeIsAnError()
{
    const QTemporaryDir folder;
    const fs::path root = folder.path().toStdString();
    DriveStore store(root);
    JournalEntry entry;
    entry.serialNumber = serial;
    entry.step = "upload";
    VERIFY_RESULT(store.openJournal(entry));
    const fs::path file = root / std::to_string(serial) / "journal-axis0.json";
    QVERIFY(fs::exists(file));
    grow(file, 1);
    const auto read = store.journal(serial, 0);
    QVERIFY(!read.has_value());
    QVERIFY2(sentence(read.error()).find(file.string()) != std::string::npos,
        sentence(read.error()).c_str());
    QVERIFY(fs::exists(file)); // what it knew must not be lost
}

void TestStoreLimits::aListThatIsTooLongIsBroken()
{
    std::string text = R"({"format": "axiscomp-tables", "version": 1, "tables": [0)";
    for (int i = 0; i < 20'000; ++i)
        text += ",0";
    const auto tables = readTables(text + "]}");
    QVERIFY(!tables.has_value());
    const std::string tooMany = tables.error().english();
    QVERIFY2(tooMany.find("more than 20000 values") != std::string::npos, tooMany.c_str());
    const auto deep = readTables(std::string(1000, '['));
    QVERIFY(!deep.has_value());
    const std::string tooDeep = deep.error().english();
    QVERIFY2(tooDeep.find("deeper than 8") != std::string::npos, tooDeep.c_str());
}

AXISCOMP_TEST(TestStoreLimits)

} // namespace tst_storelimits

#include "tst_storelimits.moc"
