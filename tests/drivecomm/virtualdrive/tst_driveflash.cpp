// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/local_file.h"
#include "tests/drivecomm/virtualdrive/drive_fixture.h"
#include "tests/support/test_registry.h"

#include <QTemporaryDir>

#include <array>

namespace tst_driveflash {

using namespace axiscomp;
using namespace axiscomp::test;
using drivecomm::VirtualDrive;

/// Flash tables and their wear, reboot, saved parameters and the state folder of the virtual drive
/// (docs/drive.md, "Behaviour").
class TestDriveFlash : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void rebootBringsStoredTablesBack_data();
    void rebootBringsStoredTablesBack();
    void rebootForgetsTheRest();
    void rebootRegisterDoesTheSame();
    void countsOnlyRealOperations();
    void refusesTheNinthOperationInTenMinutes_data();
    void refusesTheNinthOperationInTenMinutes();
    void refusedRequestCostsNothing();
    void savesParametersOnly();
    void keepsItsStateInAFolder();
    void keepsTheWearAcrossRuns();
    void doesNotSaveWhatWasNotSaved();
    void leavesNoOldTables();
    void damagedTableIsABadTable();
    void refusesABrokenStateFolder_data();
    void refusesABrokenStateFolder();
    void refusesAStateThatIsTooLarge_data();
    void refusesAStateThatIsTooLarge();
    void refusesAFolderThatIsInUse();
    void refusesToStoreWhenTheFolderCannotBeWritten();

private:
    static std::filesystem::path path(const QTemporaryDir& folder)
    {
        return folder.path().toStdString();
    }
    static std::string command(const std::string& slot) { return slotPath(slot, "Command"); }
    static std::string persistent(const std::string& slot)
    {
        return slotPath(slot, "Header/Persistent");
    }
};

void TestDriveFlash::rebootBringsStoredTablesBack_data()
{
    QTest::addColumn<int>("way");
    QTest::addColumn<bool>("survives");
    QTest::newRow("volatile upload") << 0 << false;
    QTest::newRow("persistent upload") << 1 << true;
    QTest::newRow("committed") << 2 << true;
    QTest::newRow("persistent, not committed") << 3 << false;
    QTest::newRow("committed as volatile") << 4 << false;
    QTest::newRow("deleted") << 5 << false;
    QTest::newRow("volatile, not committed: the old one stays") << 6 << true;
}

void TestDriveFlash::rebootBringsStoredTablesBack()
{
    QFETCH(int, way);
    QFETCH(bool, survives);
    DriveFixture bench;
    VERIFY_RESULT(bench.upload("Small1", evenTable(1), way == 1 || way >= 4));
    if (way == 2 || way == 3)
        VERIFY_RESULT(bench.set(persistent("Small1"), true));
    if (way == 4 || way == 6)
        VERIFY_RESULT(bench.set(persistent("Small1"), false));
    if (way == 2 || way == 4)
        VERIFY_RESULT(bench.set(command("Small1"), "Commit"));
    if (way == 5)
        VERIFY_RESULT(bench.set(command("Small1"), "Delete"));
    if (way == 6) // over the stored one, in RAM only
        VERIFY_RESULT(bench.upload("Small1", evenTable(2), false));
    QCOMPARE(bench.file("Small1").empty(), way == 5);
    bench.drive->reboot();
    QVERIFY(bench.file("Small1") == (survives ? bench.encoded(evenTable(1), true) : Bytes{}));
    COMPARE_TEXT(bench.text(persistent("Small1")), survives ? "true" : "false");
}

void TestDriveFlash::rebootForgetsTheRest()
{
    DriveFixture bench;
    VERIFY_RESULT(bench.activate(flatTable(0.5F)));
    VERIFY_RESULT(bench.set(variable0, 3.0F));
    bench.time = 1s;
    COMPARE_TEXT(bench.text(stateOf0), "Active");
    bench.drive->reboot();
    COMPARE_TEXT(bench.text(activationOf0), "Disabled");
    COMPARE_TEXT(bench.text(stateOf0), "Disabled");
    QCOMPARE(bench.number(outputOf0), 0.0);
    COMPARE_TEXT(bench.text(homingOf0), "NotHomed");
    COMPARE_TEXT(bench.text(tableOf0), "Disabled");
    QCOMPARE(bench.number(sourceOf0(1)), 0.0);
    QCOMPARE(bench.number(variable0), 0.0);
    VERIFY_RESULT(bench.activate(flatTable(0.5F)));
    COMPARE_TEXT(bench.text(errorOf0), "NotHomed");
}

void TestDriveFlash::rebootRegisterDoesTheSame()
{
    DriveFixture bench;
    VERIFY_RESULT(bench.upload("Small1", evenTable(1)));
    // even in one request with what it takes away again
    VERIFY_RESULT(bench.drive->writeRegisters({{"General/Commands/Reboot", "Reboot"},
        {tableOf0, "Small1"}, {save, "Save"}, {variable0, 1.0F}}));
    QVERIFY(bench.file("Small1").empty());
    COMPARE_TEXT(bench.text(tableOf0), "Small1");
    QCOMPARE(bench.number(variable0), 0.0);
    COMPARE_TEXT(bench.text(homingOf0), "NotHomed");
}

void TestDriveFlash::countsOnlyRealOperations()
{
    DriveFixture bench;
    const auto erased = [&] { return bench.number(slotPath("Small1", "EraseCount")); };
    VERIFY_RESULT(bench.set(command("Small1"), "Delete"));
    VERIFY_RESULT(bench.upload("Small1", evenTable(1), false));
    VERIFY_RESULT(bench.set(command("Small1"), "Commit")); // volatile, flash is empty
    VERIFY_RESULT(bench.set(command("Small1"), "Delete"));
    QCOMPARE(erased(), 0.0);
    VERIFY_RESULT(bench.upload("Small1", evenTable(1), true));
    QCOMPARE(erased(), 1.0);
    VERIFY_RESULT(bench.set(command("Small1"), "Commit")); // flash holds it
    VERIFY_RESULT(bench.upload("Small1", evenTable(1), true));
    VERIFY_RESULT(bench.upload("Small1", evenTable(1), false));
    VERIFY_RESULT(bench.set(persistent("Small1"), true));
    VERIFY_RESULT(bench.set(command("Small1"), "Commit"));
    QCOMPARE(erased(), 1.0);
    VERIFY_RESULT(bench.set(persistent("Small1"), false));
    VERIFY_RESULT(bench.set(command("Small1"), "Commit")); // erases
    VERIFY_RESULT(bench.set(command("Small1"), "Commit"));
    QCOMPARE(erased(), 2.0);
    VERIFY_RESULT(bench.upload("Small1", evenTable(2), true));
    VERIFY_RESULT(bench.set(command("Small1"), "Delete"));
    QCOMPARE(erased(), 4.0);
    COMPARE_TEXT(bench.text(driveError), "None");
}

void TestDriveFlash::refusesTheNinthOperationInTenMinutes_data()
{
    QTest::addColumn<int>("operation");
    QTest::newRow("persistent upload") << 0;
    QTest::newRow("commit") << 1;
    QTest::newRow("commit as volatile") << 2;
    QTest::newRow("delete") << 3;
}

void TestDriveFlash::refusesTheNinthOperationInTenMinutes()
{
    QFETCH(int, operation);
    DriveFixture bench;
    for (int n = 0; n < 8; ++n) { // at 0, 10, ... 70 s
        bench.time = std::chrono::seconds(10 * n);
        VERIFY_RESULT(
            bench.upload("Small2", evenTable(1, 0.001F * static_cast<float>(n + 1)), true));
    }
    VERIFY_RESULT(bench.upload("Small1", evenTable(1)));
    if (operation == 1)
        VERIFY_RESULT(bench.set(persistent("Small1"), true));
    if (operation == 2)
        VERIFY_RESULT(bench.set(persistent("Small2"), false));
    const auto run = [&]() -> Result<void> {
        switch (operation) {
        case 0:
            return bench.upload("Small1", evenTable(2), true);
        case 1:
            return bench.set(command("Small1"), "Commit");
        case 2:
            return bench.set(command("Small2"), "Commit");
        default:
            return bench.set(command("Small2"), "Delete");
        }
    };
    const Bytes small1 = bench.file("Small1");
    const Bytes small2 = bench.file("Small2");
    bench.time = 100s + 1ns;
    COMPARE_TEXT(bench.text(driveError), "None");
    const Result<void> refused = run();
    VERIFY_ERROR(refused, ErrorCode::FlashWear);
    COMPARE_TEXT(refused.error().context.english("seconds"), "500");
    COMPARE_TEXT(bench.text(driveError), "FlashWear");
    QVERIFY(bench.file("Small1") == small1 && bench.file("Small2") == small2);

    bench.time = 600s - 1ns;
    COMPARE_TEXT(bench.text(driveError), "FlashWear");
    VERIFY_ERROR(run(), ErrorCode::FlashWear);
    bench.time = 600s;
    COMPARE_TEXT(bench.text(driveError), "None");
    VERIFY_RESULT(run());
    // the next is possible when the second of the eight is ten minutes old
    const Result<void> next = bench.upload("Small3", evenTable(1), true);
    VERIFY_ERROR(next, ErrorCode::FlashWear);
    COMPARE_TEXT(next.error().context.english("seconds"), "10");
    QVERIFY(bench.file("Small3").empty());
}

void TestDriveFlash::refusedRequestCostsNothing()
{
    DriveFixture bench;
    for (int n = 1; n <= 7; ++n)
        VERIFY_RESULT(bench.upload("Small1", evenTable(1, 0.001F * static_cast<float>(n)), true));
    VERIFY_RESULT(bench.upload("Small2", evenTable(1)));
    VERIFY_RESULT(bench.upload("Small3", evenTable(1)));
    const std::vector<RegisterWrite> both{{persistent("Small2"), true},
        {persistent("Small3"), true}, {command("Small2"), "Commit"}, {command("Small3"), "Commit"},
        {variable0, 1.0F}};
    VERIFY_ERROR(bench.drive->writeRegisters(both), ErrorCode::FlashWear);
    COMPARE_TEXT(bench.text(persistent("Small2")), "false");
    QCOMPARE(bench.number(slotPath("Small2", "EraseCount")), 0.0);
    QCOMPARE(bench.number(variable0), 0.0);
    bench.time = 600s; // the seven are ten minutes old
    VERIFY_RESULT(bench.drive->writeRegisters(both));
    QCOMPARE(bench.number(slotPath("Small3", "EraseCount")), 1.0);
}

void TestDriveFlash::savesParametersOnly()
{
    DriveFixture bench;
    const std::string parameter = "Application/Parameters/Floats[7]";
    VERIFY_RESULT(bench.drive->writeRegisters(
        {{tableOf0, "Large1"}, {sourceOf0(1), bench.address(masterOf0)}, {parameter, 1.25F},
            {variable0, 2.5F}, {"General/Parameters/DeviceName[0]", std::int32_t{0x41414141}}}));
    VERIFY_RESULT(bench.set(save, "Save"));
    VERIFY_RESULT(bench.set(parameter, 9.0F));
    VERIFY_RESULT(bench.set(tableOf0, "Small1"));
    bench.drive->reboot();
    COMPARE_TEXT(bench.text(tableOf0), "Large1");
    QCOMPARE(bench.number(sourceOf0(1)), static_cast<double>(bench.address(masterOf0)));
    QCOMPARE(bench.number(parameter), 1.25);
    QCOMPARE(bench.number(variable0), 0.0);
    COMPARE_TEXT(bench.drive->identity().name, "AAAAual-1");
}

void TestDriveFlash::keepsItsStateInAFolder()
{
    QTemporaryDir folder;
    DriveFixture bench;
    bench.options.stateFolder = path(folder) / "new" / "state";
    bench.start();
    const std::string parameter = "Application/Parameters/Floats[255]";
    VERIFY_RESULT(bench.upload("Small1", evenTable(3, 0.1F, 4), true));
    VERIFY_RESULT(bench.upload("Large2", evenTable(2), true));
    VERIFY_RESULT(bench.upload("Large2", evenTable(2, 0.7F), true));
    VERIFY_RESULT(bench.upload("Small2", evenTable(1)));
    VERIFY_RESULT(bench.select("Small1", {masterOf0, masterOf1, variable0}));
    VERIFY_RESULT(bench.set(parameter, 0.1F));
    VERIFY_RESULT(bench.set(save, "Save"));
    const std::uint32_t source = bench.address(variable0);

    bench.time = 0s;
    bench.start(); // power off and on
    QVERIFY(bench.file("Small1") == bench.encoded(evenTable(3, 0.1F, 4), true));
    QVERIFY(bench.file("Large2") == bench.encoded(evenTable(2, 0.7F), true));
    QVERIFY(bench.file("Small2").empty());
    QCOMPARE(bench.number(slotPath("Large2", "EraseCount")), 2.0);
    QCOMPARE(bench.number(slotPath("Small2", "EraseCount")), 0.0);
    COMPARE_TEXT(bench.text(tableOf0), "Small1");
    QCOMPARE(bench.number(sourceOf0(3)), static_cast<double>(source));
    QVERIFY(bench.reading(parameter).value == RegisterValue(0.1F));
    VERIFY_RESULT(bench.set(activationOf0, "AddToEncoders"));
    COMPARE_TEXT(bench.text(stateOf0), "Ramping");
}

void TestDriveFlash::keepsTheWearAcrossRuns()
{
    QTemporaryDir folder;
    DriveFixture bench;
    bench.options.stateFolder = path(folder);
    bench.time = 1h;
    bench.start();
    for (int n = 1; n <= 8; ++n) {
        bench.time += 1s;
        VERIFY_RESULT(bench.upload("Small1", evenTable(1, 0.001F * static_cast<float>(n)), true));
    }
    bench.time = 0s; // another run, two minutes later by the wall clock
    bench.wallTime += 2min;
    bench.start();
    const auto refused = bench.upload("Small2", evenTable(1), true);
    VERIFY_ERROR(refused, ErrorCode::FlashWear);
    COMPARE_TEXT(refused.error().context.english("seconds"), "473"); // 600 - 7 - 120
    COMPARE_TEXT(bench.text(driveError), "FlashWear");
    bench.time = 473s;
    VERIFY_RESULT(bench.upload("Small2", evenTable(1), true));
    // a wall clock that was set back does not lengthen the wait beyond the window
    bench.time = 0s;
    bench.wallTime -= 24h;
    bench.start();
    bench.time = 600s;
    VERIFY_RESULT(bench.upload("Small3", evenTable(1), true));
}

void TestDriveFlash::doesNotSaveWhatWasNotSaved()
{
    QTemporaryDir folder;
    DriveFixture bench;
    bench.options.stateFolder = path(folder);
    bench.start();
    VERIFY_RESULT(bench.set(tableOf0, "Small1"));
    VERIFY_RESULT(bench.upload("Small1", evenTable(1), true)); // saves the folder
    bench.options.name = "Renamed";
    bench.start();
    COMPARE_TEXT(bench.text(tableOf0), "Disabled");
    COMPARE_TEXT(bench.drive->identity().name, "Renamed");
}

void TestDriveFlash::leavesNoOldTables()
{
    QTemporaryDir folder;
    DriveFixture bench;
    bench.options.stateFolder = path(folder);
    bench.start();
    const auto files = [&] {
        return QDir(folder.filePath(QStringLiteral("flash"))).entryList(QDir::Files).size();
    };
    VERIFY_RESULT(bench.upload("Small1", evenTable(1), true));
    VERIFY_RESULT(bench.upload("Small1", evenTable(2), true));
    VERIFY_RESULT(bench.upload("Small2", evenTable(1), true));
    QCOMPARE(files(), 2);
    // what a save left behind that was cut off before drive.json named it
    VERIFY_RESULT(saveFile(path(folder) / "flash" / "Small2-2.TAMtbl", asBytes("half")));
    bench.drive.reset();
    const std::array unfinished{
        path(folder) / ".axiscomp-1-0.tmp", path(folder) / "flash" / ".axiscomp-1-1.tmp"};
    for (const std::filesystem::path& file : unfinished) {
        QVERIFY(isTemporaryFile(file));
        VERIFY_RESULT(saveFile(file, asBytes("half")));
    }
    bench.start();
    QCOMPARE(files(), 2);
    for (const std::filesystem::path& file : unfinished)
        QVERIFY(!std::filesystem::exists(file));
    VERIFY_RESULT(bench.upload("Small2", evenTable(3, 0.1F, 4), true));
    bench.start();
    QVERIFY(bench.file("Small2") == bench.encoded(evenTable(3, 0.1F, 4), true));
    VERIFY_RESULT(bench.set(command("Small1"), "Delete"));
    VERIFY_RESULT(bench.set(command("Small2"), "Delete"));
    QCOMPARE(files(), 0);
}

void TestDriveFlash::damagedTableIsABadTable()
{
    QTemporaryDir folder;
    DriveFixture bench;
    bench.options.stateFolder = path(folder);
    bench.start();
    VERIFY_RESULT(bench.upload("Small1", evenTable(1), true));
    bench.drive.reset();
    Bytes damaged = bench.encoded(evenTable(1), true);
    damaged.back() ^= std::byte{0x40};
    VERIFY_RESULT(saveFile(path(folder) / "flash" / "Small1-1.TAMtbl", damaged));
    bench.start();
    QVERIFY(bench.file("Small1") == damaged);
    QCOMPARE(bench.number(slotPath("Small1", "Header/Elements")), 0.0);
    VERIFY_RESULT(bench.select("Small1", {masterOf0}));
    VERIFY_RESULT(bench.set(activationOf0, "AddToEncoders"));
    COMPARE_TEXT(bench.text(errorOf0), "BadTable");
    VERIFY_RESULT(bench.upload("Small1", evenTable(1), true));
    VERIFY_RESULT(bench.set(activationOf0, "AddToEncoders"));
    COMPARE_TEXT(bench.text(stateOf0), "Ramping");
}

void TestDriveFlash::refusesABrokenStateFolder_data()
{
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::addColumn<QString>("reason");
    QTest::newRow("no JSON") << "{"
                             << ""
                             << "not the JSON";
    QTest::newRow("a list") << "^[\\s\\S]*$"
                            << "[]"
                            << "not the JSON";
    QTest::newRow("nested deeply") << "^[\\s\\S]*$" << QString(100'000, u'[') << "not the JSON";
    QTest::newRow("format") << "\"format\": 1"
                            << "\"format\": 2"
                            << "format must be";
    QTest::newRow("serial number") << "\"serialNumber\": 100001"
                                   << "\"serialNumber\": 7"
                                   << "serial number 7";
    QTest::newRow("serial number as text") << "\"serialNumber\": 100001"
                                           << "\"serialNumber\": \"x\""
                                           << "serialNumber must be";
    QTest::newRow("erase count") << "\"eraseCount\": 1"
                                 << "\"eraseCount\": -1"
                                 << "slots.Small1.eraseCount must be";
    QTest::newRow("slot") << "\"Small1\": \\{"
                          << "\"Small9\": {"
                          << "no slot Small9";
    QTest::newRow("file elsewhere") << "Small1-1.TAMtbl"
                                    << "../drive.json"
                                    << "slots.Small1.file must be";
    QTest::newRow("file missing") << "Small1-1.TAMtbl"
                                  << "Small1-2.TAMtbl"
                                  << "Small1-2.TAMtbl";
    QTest::newRow("parameter") << "\"Small1\"(,|\\s*\\})"
                               << "[1]\\1"
                               << "parameters.";
    QTest::newRow("parameter's value") << "Axis/Table\": \"Small1\""
                                       << "Axis/Table\": \"Small9\""
                                       << "Small9";
    QTest::newRow("ages") << "\"flashOperationAgesNs\": \\["
                          << "\"flashOperationAgesNs\": [-1,"
                          << "flashOperationAgesNs must be";
}

void TestDriveFlash::refusesABrokenStateFolder()
{
    QFETCH(QString, from);
    QFETCH(QString, to);
    QFETCH(QString, reason);
    QTemporaryDir folder;
    DriveFixture bench;
    bench.options.stateFolder = path(folder);
    bench.start();
    VERIFY_RESULT(bench.upload("Small1", evenTable(1), true));
    VERIFY_RESULT(bench.set(tableOf0, "Small1"));
    VERIFY_RESULT(bench.set(save, "Save"));
    bench.drive.reset();

    const auto file = path(folder) / "drive.json";
    const auto good = loadFile(file, 1 << 20);
    VERIFY_RESULT(good);
    QString text = QString::fromStdString(std::string(asText(*good)));
    const QString before = text;
    text.replace(QRegularExpression(from), to);
    QVERIFY(text != before);
    const std::string broken = text.toStdString();
    VERIFY_RESULT(saveFile(file, asBytes(broken)));
    const auto created = VirtualDrive::create(bench.profile, bench.options);
    VERIFY_ERROR(created, ErrorCode::FileNotReadable);
    const std::string said = sentence(created.error());
    QVERIFY2(said.find(reason.toStdString()) != std::string::npos, said.c_str());
    QVERIFY2(said.find(folder.path().toStdString()) != std::string::npos, said.c_str());
    // nothing was touched: the state can be repaired by hand
    VERIFY_RESULT(saveFile(file, *good));
    bench.start();
    QVERIFY(!bench.file("Small1").empty());
}

void TestDriveFlash::refusesAStateThatIsTooLarge_data()
{
    QTest::addColumn<QString>("name");
    QTest::newRow("state") << "drive.json";
    QTest::newRow("table") << "flash/Small1-1.TAMtbl";
}

void TestDriveFlash::refusesAStateThatIsTooLarge()
{
    QFETCH(QString, name);
    QTemporaryDir folder;
    DriveFixture bench;
    bench.options.stateFolder = path(folder);
    bench.start();
    VERIFY_RESULT(bench.upload("Small1", evenTable(1), true));
    bench.drive.reset();
    std::filesystem::resize_file(path(folder) / name.toStdString(), (std::uintmax_t{64} << 20) + 1);
    const auto created = VirtualDrive::create(bench.profile, bench.options);
    VERIFY_ERROR(created, ErrorCode::FileTooLarge);
}

void TestDriveFlash::refusesAFolderThatIsInUse()
{
    QTemporaryDir folder;
    DriveFixture bench;
    bench.options.stateFolder = path(folder);
    bench.start();
    VERIFY_ERROR(VirtualDrive::create(bench.profile, bench.options), ErrorCode::FileNotWritable);
    bench.drive.reset();
    VERIFY_RESULT(VirtualDrive::create(bench.profile, bench.options));
    bench.options.stateFolder = path(folder) / "lock" / "below a file";
    VERIFY_ERROR(VirtualDrive::create(bench.profile, bench.options), ErrorCode::FileNotWritable);
}

void TestDriveFlash::refusesToStoreWhenTheFolderCannotBeWritten()
{
    QTemporaryDir folder;
    DriveFixture bench;
    bench.options.stateFolder = path(folder) / "state";
    bench.start();
    VERIFY_RESULT(bench.upload("Small1", evenTable(1), true));
    std::filesystem::remove_all(path(folder) / "state");
    VERIFY_ERROR(bench.upload("Small1", evenTable(2), true), ErrorCode::DriveRejected);
    VERIFY_ERROR(bench.set(save, "Save"), ErrorCode::DriveRejected);
    QVERIFY(bench.file("Small1") == bench.encoded(evenTable(1), true));
    QCOMPARE(bench.number(slotPath("Small1", "EraseCount")), 1.0);
    VERIFY_RESULT(bench.upload("Small2", evenTable(2), false));
}

AXISCOMP_TEST(TestDriveFlash)

} // namespace tst_driveflash

#include "tst_driveflash.moc"
