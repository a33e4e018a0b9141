// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/drivecomm/virtualdrive/drive_fixture.h"
#include "tests/support/test_registry.h"

#include <set>

namespace tst_driveregisters {

using namespace axiscomp;
using namespace axiscomp::test;
using drivecomm::VirtualDrive;

/// The register tree of the virtual drive (docs/drive.md, "Registers").
class TestDriveRegisters : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void hasTheRegistersOfTheSpecification_data();
    void hasTheRegistersOfTheSpecification();
    void hasNothingThatTheProfileDoesNotReach();
    void addressesAreUniqueAndLookReal();
    void addressesStayTheSame();
    void acceptsEverySpellingOfAPath_data();
    void acceptsEverySpellingOfAPath();
    void namesTheNearestPaths_data();
    void namesTheNearestPaths();
    void readsASubtreeAtComponentBoundaries_data();
    void readsASubtreeAtComponentBoundaries();
    void takesValuesThatFit_data();
    void takesValuesThatFit();
    void refusesValuesThatDoNotFit_data();
    void refusesValuesThatDoNotFit();
    void writesAllOrNothing_data();
    void writesAllOrNothing();
    void commandsFallBackToIdle_data();
    void commandsFallBackToIdle();
    void limitsTheSizeOfARequest();
    void packsNamesAsTheDriveDoes();
    void takesParametersAndAddsUnknownOnes();
    void refusesOptionsThatDoNotFit_data();
    void refusesOptionsThatDoNotFit();
};

void TestDriveRegisters::hasTheRegistersOfTheSpecification_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("type");
    QTest::addColumn<QString>("value");
    const auto row = [](const char* path, const char* type, const char* value) {
        QTest::newRow(path) << path << type << value;
    };
    row("General/Parameters/DeviceName[0]", "Int32", "1953655126"); // "Virt"
    row("General/Parameters/DeviceName[6]", "Int32", "0");
    row("General/Signals/Identifications/SerialNumber", "Int32", "100001");
    row("General/Signals/DriveError", "DriveError", "None");
    row("General/Commands/SaveParameters", "SaveParameters", "Idle");
    row("General/Commands/Reboot", "Reboot", "Idle");
    row("Axes[0]/Information/AxisName[0]", "Int32", "88"); // "X"
    row("Axes[1]/Information/AxisName[3]", "Int32", "0");
    row("Axes[1]/Parameters/PositionController/PositionUnit", "PositionUnit", "Millimeter");
    row("Axes[0]/Parameters/Compensations/Axis/Table", "SourceTable", "Disabled");
    row("Axes[0]/Parameters/Compensations/Axis/Dim1Source", "UInt32", "0");
    row("Axes[1]/Parameters/Compensations/Axis/Dim3Source", "UInt32", "0");
    row("Axes[1]/Parameters/Compensations/Cogging/Table", "SourceTable", "Disabled");
    row("Axes[0]/Commands/Compensations/Axis/Activation", "CompensationActivation", "Disabled");
    row("Axes[0]/Signals/Compensations/Axis/State", "CompensationState", "Disabled");
    row("Axes[0]/Signals/Compensations/Axis/Error", "CompensationError", "None");
    row("Axes[0]/Signals/Compensations/Axis/Output", "Single", "0");
    row("Axes[0]/Signals/Compensations/Axis/Dim1Index", "Single", "0");
    row("Axes[1]/Signals/Compensations/Axis/Dim3Index", "Single", "0");
    row("Axes[0]/Signals/Homing/State", "HomingState", "HomingDone");
    row("Axes[0]/Signals/PositionController/MasterPosition", "Double", "50");
    row("Axes[0]/Signals/PositionController/Encoders[0]/Position", "Double", "50");
    row("Axes[0]/Signals/PositionController/Encoders[1]/Position", "Double", "");
    row("Axes[0]/Signals/PositionController/ActualPosition", "Double", "50");
    row("Axes[0]/Signals/PathPlanner/Position", "Double", "");
    row("Axes[0]/Signals/General/MotorTemperature", "Single", "38");
    row("Application/Variables/Floats[0]", "Single", "0");
    row("Application/Variables/Floats[255]", "Single", "0");
    row("Application/Parameters/Floats[255]", "Single", "0");
    row("Application/Tables/Small1/Header/Persistent", "Boolean", "false");
    row("Application/Tables/Large2/Header/Dimensions", "UInt32", "0");
    row("Application/Tables/Small8/Header/Size[2]", "UInt32", "0");
    row("Application/Tables/Small8/Header/StartValue[0]", "Double", "0");
    row("Application/Tables/Small8/Header/Distance[1]", "Double", "0");
    row("Application/Tables/Large1/Header/Elements", "UInt32", "0");
    row("Application/Tables/Large1/Header/Crc", "UInt32", "0");
    row("Application/Tables/Large1/Command", "TableCommand", "Idle");
    row("Application/Tables/Large1/EraseCount", "UInt32", "0");
}

void TestDriveRegisters::hasTheRegistersOfTheSpecification()
{
    QFETCH(QString, path);
    QFETCH(QString, type);
    QFETCH(QString, value);
    DriveFixture bench;
    const auto read = bench.drive->readRegisters({path.toStdString()});
    VERIFY_RESULT(read);
    COMPARE_TEXT(read->front().path, path.toStdString());
    COMPARE_TEXT(read->front().type, type.toStdString());
    if (!value.isEmpty())
        COMPARE_TEXT(toText(read->front().value), value.toStdString());
}

void TestDriveRegisters::hasNothingThatTheProfileDoesNotReach()
{
    DriveFixture bench;
    const auto count = [&](const std::string& prefix) {
        return bench.drive->readTree(prefix).size();
    };
    QCOMPARE(count("General"), std::size_t{7 + 1 + 1 + 1 + 1});
    QCOMPARE(count("Axes[0]"), count("Axes[1]"));
    QCOMPARE(count("Axes[0]"), std::size_t{4 + 1 + 4 + 1 + 1 + 6 + 2 + 6 + 2});
    QCOMPARE(count("Application/Tables"), std::size_t{10 * (1 + 1 + 9 + 1 + 1 + 1 + 1)});
    QCOMPARE(count("Application"), std::size_t{512} + count("Application/Tables"));
    QCOMPARE(count(""), count("General") + 2 * count("Axes[0]") + count("Application"));
}

void TestDriveRegisters::addressesAreUniqueAndLookReal()
{
    DriveFixture bench(64);
    QCOMPARE(bench.drive->identity().axes, 64);
    std::set<std::uint32_t> addresses;
    for (const RegisterReading& one : bench.drive->readTree("")) {
        QVERIFY2(one.address != 0 && one.address % 4 == 0, one.path.c_str());
        QVERIFY2(one.type != "Double" || one.address % 8 == 0, one.path.c_str());
        QVERIFY2(addresses.insert(one.address).second, one.path.c_str());
    }
    QVERIFY(addresses.size() > 64 * 24);
}

void TestDriveRegisters::addressesStayTheSame()
{
    DriveFixture small(1);
    DriveFixture large(8);
    large.time = 12345ms;
    VERIFY_RESULT(large.set(tableOf0, "Small3"));
    large.options.parameters = {{"Axes[0]/Parameters/Commutation/Angle", 0, "Single", 1.5F}};
    large.start();
    for (const RegisterReading& one : small.drive->readTree(""))
        QVERIFY2(one.address == large.address(one.path), one.path.c_str());
}

void TestDriveRegisters::acceptsEverySpellingOfAPath_data()
{
    QTest::addColumn<QString>("path");
    QTest::newRow("slashes") << "Axes[0]/Signals/Homing/State";
    QTest::newRow("dots") << "Axes[0].Signals.Homing.State";
    QTest::newRow("mixed") << "Axes[0].Signals/Homing.State";
    QTest::newRow("leading slash") << "/Axes[0]/Signals/Homing/State";
}

void TestDriveRegisters::acceptsEverySpellingOfAPath()
{
    QFETCH(QString, path);
    DriveFixture bench;
    const RegisterReading read = bench.reading(path.toStdString());
    COMPARE_TEXT(read.path, homingOf0);
    COMPARE_TEXT(toText(read.value), "HomingDone");
}

void TestDriveRegisters::namesTheNearestPaths_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("first");
    QTest::newRow("a letter is missing") << "Axes[0]/Signals/PathPlaner/Position"
                                         << "Axes[0]/Signals/PathPlanner/Position";
    QTest::newRow("lower case") << "axes[1]/signals/homing/state"
                                << "Axes[1]/Signals/Homing/State";
    QTest::newRow("index too large") << "Application/Variables/Floats[2555]"
                                     << "Application/Variables/Floats[255]";
    QTest::newRow("nothing like it") << "x"
                                     << "";
    QTest::newRow("empty") << ""
                           << "";
    QTest::newRow("endless") << QString(100'000, u'a') << "";
}

void TestDriveRegisters::namesTheNearestPaths()
{
    QFETCH(QString, path);
    QFETCH(QString, first);
    DriveFixture bench;
    const auto read = bench.drive->readRegisters({path.toStdString()});
    VERIFY_ERROR(read, ErrorCode::UnknownRegister);
    COMPARE_TEXT(read.error().context.english("path"), path.toStdString());
    const QString nearest = QString::fromStdString(read.error().context.english("nearest"));
    QCOMPARE(nearest.section(u',', 0, 0), first);
    QCOMPARE(nearest.count(u','), first.isEmpty() ? 0 : 2);
    VERIFY_ERROR(bench.set(path.toStdString(), true), ErrorCode::UnknownRegister);
}

void TestDriveRegisters::readsASubtreeAtComponentBoundaries_data()
{
    QTest::addColumn<QString>("prefix");
    QTest::addColumn<int>("count");
    QTest::newRow("one axis of eleven") << "Axes[1]/Signals/Homing" << 1;
    QTest::newRow("with dots and a slash") << "Axes[1].Signals.Homing/" << 1;
    QTest::newRow("a register itself") << "Axes[10]/Signals/Homing/State" << 1;
    QTest::newRow("half a name") << "Axes[1]/Signals/Hom" << 0;
    QTest::newRow("half an index") << "Axes[1" << 0;
    QTest::newRow("an array") << "General/Parameters/DeviceName" << 7;
    QTest::newRow("nothing") << "Nothing" << 0;
}

void TestDriveRegisters::readsASubtreeAtComponentBoundaries()
{
    QFETCH(QString, prefix);
    QFETCH(int, count);
    DriveFixture bench(11);
    QCOMPARE(static_cast<int>(bench.drive->readTree(prefix.toStdString()).size()), count);
}

void TestDriveRegisters::takesValuesThatFit_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<RegisterValue>("written");
    QTest::addColumn<RegisterValue>("kept");
    const auto row = [](const char* name, const std::string& path, RegisterValue written,
                         RegisterValue kept) {
        QTest::newRow(name) << QString::fromStdString(path) << written << kept;
    };
    row("Single", variable0, 1.5F, 1.5F);
    row("Single from a whole number", variable0, std::int32_t{-3}, -3.0F);
    row("Single from an unsigned number", variable0, std::uint32_t{3}, 3.0F);
    row("Single from a Double", variable0, 0.1, 0.1F);
    row("UInt32", sourceOf0(1), std::uint32_t{0xFFFF'FFFF}, std::uint32_t{0xFFFF'FFFF});
    row("UInt32 from an Int32", sourceOf0(1), std::int32_t{7}, std::uint32_t{7});
    row("UInt32 from a whole Double", sourceOf0(1), 4e9, std::uint32_t{4'000'000'000});
    row("Int32", "General/Parameters/DeviceName[0]", std::int32_t{-1}, std::int32_t{-1});
    row("enum", tableOf0, "Large2", "Large2");
    row("enum in lower case", tableOf0, "large2", "Large2");
}

void TestDriveRegisters::takesValuesThatFit()
{
    QFETCH(QString, path);
    QFETCH(RegisterValue, written);
    QFETCH(RegisterValue, kept);
    DriveFixture bench;
    VERIFY_RESULT(bench.set(path.toStdString(), written));
    QVERIFY(bench.reading(path.toStdString()).value == kept);
}

void TestDriveRegisters::refusesValuesThatDoNotFit_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<RegisterValue>("value");
    const auto row = [](const char* name, const std::string& path, RegisterValue value) {
        QTest::newRow(name) << QString::fromStdString(path) << value;
    };
    const std::string persistent = slotPath("Small1", "Header/Persistent");
    row("read-only signal", outputOf0, 1.0F);
    row("read-only header", slotPath("Small1", "Header/Crc"), std::uint32_t{1});
    row("read-only serial number", "General/Signals/Identifications/SerialNumber", std::int32_t{1});
    row("read-only axis name", axisPath(0, "Information/AxisName[0]"), std::int32_t{1});
    row("unknown enum value", tableOf0, "Small9");
    row("number for an enum", tableOf0, std::int32_t{1});
    row("text for a number", variable0, "1.5");
    row("boolean for a number", variable0, true);
    row("number for a boolean", persistent, std::int32_t{1});
    row("text for a boolean", persistent, "true");
    row("negative for UInt32", sourceOf0(1), std::int32_t{-1});
    row("fraction for UInt32", sourceOf0(1), 1.5);
    row("too large for UInt32", sourceOf0(1), 4294967296.0);
    row("too large for Int32", "General/Parameters/DeviceName[0]", std::uint32_t{0x8000'0000});
    row("too large for Single", variable0, 1e39);
    row("NaN", variable0, std::numeric_limits<double>::quiet_NaN());
    row("infinity", variable0, std::numeric_limits<float>::infinity());
    row("persistent without a table", persistent, true);
    row("commit without a table", slotPath("Small1", "Command"), "Commit");
}

void TestDriveRegisters::refusesValuesThatDoNotFit()
{
    QFETCH(QString, path);
    QFETCH(RegisterValue, value);
    DriveFixture bench;
    const RegisterReading before = bench.reading(path.toStdString());
    const auto written = bench.set(path.toStdString(), value);
    VERIFY_ERROR(written, ErrorCode::DriveRejected);
    QVERIFY(!written.error().context.english("reason").empty());
    QVERIFY(bench.reading(path.toStdString()) == before);
}

void TestDriveRegisters::writesAllOrNothing_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<RegisterValue>("value");
    QTest::addColumn<ErrorCode>("code");
    const auto row = [](const char* name, const std::string& path, RegisterValue value,
                         ErrorCode code) {
        QTest::newRow(name) << QString::fromStdString(path) << value << code;
    };
    row("unknown", "Axes[2]/Nothing", true, ErrorCode::UnknownRegister);
    row("read-only", stateOf0, "Active", ErrorCode::DriveRejected);
    row("wrong type", sourceOf0(1), "text", ErrorCode::DriveRejected);
    row("command without a table", slotPath("Small2", "Command"), "Commit",
        ErrorCode::DriveRejected);
    row("the same again", variable0, 2.0F, ErrorCode::DriveRejected);
}

void TestDriveRegisters::writesAllOrNothing()
{
    QFETCH(QString, path);
    QFETCH(RegisterValue, value);
    QFETCH(ErrorCode, code);
    DriveFixture bench;
    VERIFY_RESULT(bench.upload("Small1", evenTable(1)));
    const auto before = bench.drive->readTree("");
    const RegisterWrite refused{path.toStdString(), value};
    const RegisterWrite fine{variable0, 1.0F};
    const RegisterWrite activation{activationOf0, "Evaluate"};
    const RegisterWrite persistent{slotPath("Small1", "Header/Persistent"), true};
    const RegisterWrite commit{slotPath("Small1", "Command"), "Commit"};
    const auto written =
        bench.drive->writeRegisters({fine, activation, persistent, commit, refused});
    VERIFY_ERROR(written, code);
    const std::string said = sentence(written.error());
    const std::string named = code == ErrorCode::DriveRejected && path.endsWith(u"/Command")
        ? "Small2"
        : path.toStdString();
    QVERIFY2(said.find(named) != std::string::npos, said.c_str());
    QVERIFY(bench.drive->readTree("") == before);
}

void TestDriveRegisters::commandsFallBackToIdle_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("value");
    QTest::newRow("save") << QString::fromStdString(save) << "Save";
    QTest::newRow("reboot") << "General/Commands/Reboot"
                            << "Reboot";
    QTest::newRow("delete") << QString::fromStdString(slotPath("Small1", "Command")) << "Delete";
    QTest::newRow("homing") << QString::fromStdString(homeAxis0) << "Start";
}

void TestDriveRegisters::commandsFallBackToIdle()
{
    QFETCH(QString, path);
    QFETCH(QString, value);
    DriveFixture bench;
    VERIFY_RESULT(bench.set(path.toStdString(), "Idle"));
    VERIFY_RESULT(bench.set(path.toStdString(), value.toStdString()));
    COMPARE_TEXT(bench.text(path.toStdString()), "Idle");
    VERIFY_ERROR(bench.set(path.toStdString(), "Other"), ErrorCode::DriveRejected);
}

void TestDriveRegisters::limitsTheSizeOfARequest()
{
    DriveFixture bench;
    std::vector<std::string> paths(DriveLink::maximumReads, masterOf0);
    VERIFY_RESULT(bench.drive->readRegisters(paths));
    paths.push_back(masterOf0);
    VERIFY_ERROR(bench.drive->readRegisters(paths), ErrorCode::DriveRejected);

    std::vector<RegisterWrite> writes;
    for (std::size_t i = 0; i < DriveLink::maximumWrites; ++i)
        writes.push_back({"Application/Variables/Floats[" + std::to_string(i) + "]", 1.0F});
    VERIFY_RESULT(bench.drive->writeRegisters(writes));
    writes.push_back({"Application/Variables/Floats[100]", 1.0F});
    VERIFY_ERROR(bench.drive->writeRegisters(writes), ErrorCode::DriveRejected);
    VERIFY_ERROR(bench.drive->writeRegisters({}), ErrorCode::DriveRejected);
}

void TestDriveRegisters::packsNamesAsTheDriveDoes()
{
    DriveFixture bench;
    bench.options.name = "Cross-Axis Drive of the Longest Name";
    bench.start();
    COMPARE_TEXT(bench.drive->identity().name, "Cross-Axis Drive of the Long");
    QCOMPARE(bench.number("General/Parameters/DeviceName[0]"), 1936683587.0); // "Cros"
    VERIFY_RESULT(bench.set("General/Parameters/DeviceName[1]", std::int32_t{0}));
    COMPARE_TEXT(bench.drive->identity().name, "Cros");
}

void TestDriveRegisters::takesParametersAndAddsUnknownOnes()
{
    DriveFixture bench;
    const std::string kp = axisPath(1, "Parameters/PositionController/Controllers[0]/Kp");
    bench.options.parameters = {{kp, 0x1234, "Single", 17.0F},
        {axisPath(1, "Parameters/Commutation/Source"), 0, "CommutationSource", "Encoder0"},
        {axisPath(0, "Signals/Extra/Value"), 0, "Int32", std::int32_t{5}},
        {axisPath(0, "Signals/Compensations/Axis/State"), 0, "CompensationState", "Active"},
        {tableOf0, 0, "SourceTable", "small4"}};
    bench.start();
    QCOMPARE(bench.number(kp), 17.0);
    QVERIFY(bench.address(kp) != 0x1234);
    VERIFY_RESULT(bench.set(kp, 18.0));
    COMPARE_TEXT(bench.text(tableOf0), "Small4");
    COMPARE_TEXT(bench.text(stateOf0), "Disabled");
    const RegisterReading source = bench.reading(axisPath(1, "Parameters/Commutation/Source"));
    COMPARE_TEXT(source.type, "CommutationSource");
    VERIFY_RESULT(bench.set(source.path, "Encoder1"));
    VERIFY_ERROR(bench.set(source.path, std::int32_t{1}), ErrorCode::DriveRejected);
    VERIFY_ERROR(
        bench.set(axisPath(0, "Signals/Extra/Value"), std::int32_t{6}), ErrorCode::DriveRejected);
}

void TestDriveRegisters::refusesOptionsThatDoNotFit_data()
{
    QTest::addColumn<int>("fault");
    QTest::newRow("65 axes") << 0;
    QTest::newRow("no range") << 1;
    QTest::newRow("no period") << 2;
    QTest::newRow("parameter of another type") << 3;
}

void TestDriveRegisters::refusesOptionsThatDoNotFit()
{
    QFETCH(int, fault);
    drivecomm::VirtualDriveOptions options;
    options.axes.resize(1);
    if (fault == 0)
        options.axes.resize(65);
    if (fault == 1)
        options.axes[0].high = options.axes[0].low;
    if (fault == 2)
        options.axes[0].periodSeconds = 0.0;
    if (fault == 3)
        options.parameters = {{variable0, 0, "Single", "text"}};
    VERIFY_ERROR(
        VirtualDrive::create(drivecomm::genericProfile(), options), ErrorCode::InvalidArgument);
}

AXISCOMP_TEST(TestDriveRegisters)

} // namespace tst_driveregisters

#include "tst_driveregisters.moc"
