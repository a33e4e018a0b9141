// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/tam_configuration.h"
#include "tests/drivecomm/virtualdrive/drive_fixture.h"
#include "tests/support/test_registry.h"

#include <QTemporaryDir>

#include <fstream>
#include <numbers>

namespace tst_tamconfiguration {

using namespace axiscomp;
using namespace axiscomp::test;
using drivecomm::loadTamConfiguration;
using drivecomm::parseTamConfiguration;
using drivecomm::VirtualDrive;
using drivecomm::VirtualDriveOptions;

/// Configuration files of real drives make virtual drives.
class TestTamConfiguration : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void twoStationsAreTwoDrives();
    void drivesHaveTheRegistersOfTheFile();
    void takesWhatIsMissingFromElsewhere();
    void theLastOfARepeatedRegisterCounts();
    void takesItsRangeFromTheUnit_data();
    void takesItsRangeFromTheUnit();
    void refusesWithTheLine_data();
    void refusesWithTheLine();
    void refusesDocumentTypes();
    void refusesEndlessRegisters();
    void readsOtherEncodings();
    void refusesFilesThatCannotBeRead();

private:
    static std::filesystem::path file(const char* name)
    {
        return std::filesystem::path(AXISCOMP_SOURCE_FOLDER "/tests/data/tamcfg") / name;
    }
    static std::string withRegisters(const std::string& registers)
    {
        return "<TamTopology><Stations>\n<TamStation Name='S' HardwareSerialNumber='5'>\n"
            + registers + "\n</TamStation></Stations></TamTopology>";
    }
    static std::string component(
        const std::string& address, const std::string& type, const std::string& value)
    {
        return "<RegisterComponent Address='" + address + "' Type='" + type + "' Value='" + value
            + "'/>";
    }
    static const RegisterReading* find(const VirtualDriveOptions& options, const std::string& path)
    {
        const auto found = std::ranges::find(options.parameters, path, &RegisterReading::path);
        return found == options.parameters.end() ? nullptr : &*found;
    }
};

void TestTamConfiguration::twoStationsAreTwoDrives()
{
    const auto drives = loadTamConfiguration(file("two-drives.TAMcfg"));
    VERIFY_RESULT(drives);
    QCOMPARE(drives->size(), std::size_t{2});
    const VirtualDriveOptions& gantry = drives->front();
    COMPARE_TEXT(gantry.name, "Gantry-Left");
    QCOMPARE(gantry.serialNumber, 2207);
    QCOMPARE(gantry.axes.size(), std::size_t{2});
    COMPARE_TEXT(gantry.axes[0].name, "X1");
    COMPARE_TEXT(gantry.axes[0].unit, "Millimeter");
    QCOMPARE(gantry.axes[0].low, -50.0);
    QCOMPARE(gantry.axes[0].high, 450.5);
    COMPARE_TEXT(gantry.axes[1].unit, "Millimeter");
    const VirtualDriveOptions& rotary = drives->back();
    COMPARE_TEXT(rotary.name, "Rotary Table"); // the station's: the drive has none
    QCOMPARE(rotary.serialNumber, 2208);
    QCOMPARE(rotary.axes.size(), std::size_t{1});
    COMPARE_TEXT(rotary.axes[0].unit, "Degree");
    QCOMPARE(rotary.axes[0].high, 360.0);
}

void TestTamConfiguration::drivesHaveTheRegistersOfTheFile()
{
    const auto drives = loadTamConfiguration(file("two-drives.TAMcfg"));
    VERIFY_RESULT(drives);
    for (const VirtualDriveOptions& options : *drives) {
        const auto drive = VirtualDrive::create(drivecomm::genericProfile(), options);
        VERIFY_RESULT(drive);
        COMPARE_TEXT((*drive)->identity().name, options.name);
        QCOMPARE((*drive)->identity().serialNumber, options.serialNumber);
        for (const RegisterReading& parameter : options.parameters) {
            const auto read = (*drive)->readRegisters({parameter.path});
            VERIFY_RESULT(read);
            QVERIFY2(read->front().value == parameter.value, parameter.path.c_str());
        }
    }
    const auto gantry = VirtualDrive::create(drivecomm::genericProfile(), drives->front());
    const auto read = (*gantry)->readRegisters({tableOf0, "General/Parameters/LinkAddress",
        "General/Parameters/Standalone", "General/Parameters/LogSeverityLevel",
        axisPath(1, "Parameters/PositionController/Encoders[0]/IncrementsPerUnit"),
        "Application/Parameters/Floats[255]", "Application/Parameters/Integers[3]",
        axisPath(1, "Parameters/PositionController/PositionUnit")});
    VERIFY_RESULT(read);
    std::string values;
    std::string types;
    for (const RegisterReading& one : *read) {
        values += toText(one.value) + ' ';
        types += one.type + ' ';
    }
    COMPARE_TEXT(values, "Small4 4294967295 true Notice -2e+20 0 -7 Millimeter ");
    COMPARE_TEXT(
        types, "SourceTable UInt32 Boolean LogSeverityLevel Double Single Int32 PositionUnit ");
}

void TestTamConfiguration::takesWhatIsMissingFromElsewhere()
{
    const auto drives = loadTamConfiguration(file("unspecified.TAMcfg"));
    VERIFY_RESULT(drives);
    QCOMPARE(drives->size(), std::size_t{1}); // a station without axes is no drive
    const VirtualDriveOptions& options = drives->front();
    COMPARE_TEXT(options.name, "S");
    QVERIFY(options.serialNumber > 0);
    COMPARE_TEXT(options.axes[0].unit, "None");
    COMPARE_TEXT(options.axes[0].name, "");
    QCOMPARE(options.axes[0].low, 0.0);
    QCOMPARE(options.axes[0].high, 100.0);
    COMPARE_TEXT(options.axes[1].unit, "Inch");
    const auto drive = VirtualDrive::create(drivecomm::genericProfile(), options);
    VERIFY_RESULT(drive);
    const auto unit =
        (*drive)->readRegisters({axisPath(1, "Parameters/PositionController/PositionUnit")});
    VERIFY_RESULT(unit);
    COMPARE_TEXT(toText(unit->front().value), "Inch");
}

void TestTamConfiguration::theLastOfARepeatedRegisterCounts()
{
    const std::string unit = axisPath(0, "Parameters/PositionController/PositionUnit");
    const auto drives =
        parseTamConfiguration(withRegisters(component(unit, "PositionUnitType", "unspecified")
                                  + component(unit, "PositionUnitType", "radian")),
            "f");
    VERIFY_RESULT(drives);
    QCOMPARE(drives->front().parameters.size(), std::size_t{1});
    COMPARE_TEXT(drives->front().axes[0].unit, "Radian");
    VERIFY_RESULT(VirtualDrive::create(drivecomm::genericProfile(), drives->front()));
}

void TestTamConfiguration::takesItsRangeFromTheUnit_data()
{
    QTest::addColumn<QString>("unit");
    QTest::addColumn<double>("high");
    QTest::newRow("degree") << "degree" << 360.0;
    QTest::newRow("radian") << "RADIAN" << 2.0 * std::numbers::pi;
    QTest::newRow("metre") << "Meter" << 0.1;
    QTest::newRow("millimetre") << "millimeter" << 100.0;
    QTest::newRow("other") << "Furlong" << 100.0;
}

void TestTamConfiguration::takesItsRangeFromTheUnit()
{
    QFETCH(QString, unit);
    QFETCH(double, high);
    const auto drives = parseTamConfiguration(
        withRegisters(component(axisPath(0, "Parameters/PositionController/PositionUnit"),
            "PositionUnitType", unit.toStdString())),
        "f");
    VERIFY_RESULT(drives);
    QCOMPARE(drives->front().axes[0].high, high);
}

void TestTamConfiguration::refusesWithTheLine_data()
{
    QTest::addColumn<QString>("xml");
    QTest::addColumn<int>("line");
    QTest::addColumn<QString>("reason");
    const auto row = [](const char* name, const std::string& xml, int line, const char* reason) {
        QTest::newRow(name) << QString::fromStdString(xml) << line << reason;
    };
    const std::string path = "Axes[0]/A";
    row("empty", "", 1, "");
    row("no XML", "DIM1,TABLE\n1,2\n", 1, "");
    row("another root", "\n<Topology/>", 2, "expected TamTopology");
    row("no station", "<TamTopology>\n</TamTopology>", 1, "no TamStation");
    row("no axis", withRegisters(component("General/A", "Int32", "1")), 1, "no TamStation");
    row("cut off", withRegisters("").substr(0, 70), 2, "");
    row("not closed", "<TamTopology>\n<Stations>\n</TamTopology>", 3, "");
    row("not a number", withRegisters("\n" + component(path, "Int32", "many")), 4, "many");
    row("not whole", withRegisters(component(path, "Int32", "1.5")), 3, "1.5");
    row("too large", withRegisters(component(path, "Int32", "2147483648")), 3, "2147483648");
    row("negative", withRegisters(component(path, "UInt32", "-1")), 3, "-1");
    row("too large a Single", withRegisters(component(path, "Single", "1E+39")), 3, "1E+39");
    row("no Boolean", withRegisters(component(path, "Boolean", "maybe")), 3, "maybe");
    row("no value", withRegisters("<RegisterComponent Address='A' Type='Int32'/>"), 3, "Value");
    row("no type", withRegisters("<RegisterComponent Address='A' Value='1'/>"), 3, "Type");
    row("no address", withRegisters("<RegisterComponent Type='Int32' Value='1'/>"), 3, "Address");
    row("axis 64", withRegisters(component("Axes[64]/A", "Int32", "1")), 3, "axis index");
    row("axis -1", withRegisters(component("Axes[-1]/A", "Int32", "1")), 3, "axis index");
    row("axis x", withRegisters(component("Axes[x]/A", "Int32", "1")), 3, "axis index");
    row("axis without end", withRegisters(component("Axes[1", "Int32", "1")), 3, "axis index");
    row("long enum", withRegisters(component(path, "E", std::string(65, 'e'))), 3, "longer");
    row("serial number", "<TamTopology>\n<TamStation HardwareSerialNumber='A5'/></TamTopology>", 2,
        "HardwareSerialNumber");
    row("unknown entity", withRegisters(component(path, "E", "&lol;")), 3, "");
    row("entity in the text", withRegisters("&lol;"), 3, "");
}

void TestTamConfiguration::refusesWithTheLine()
{
    QFETCH(QString, xml);
    QFETCH(int, line);
    QFETCH(QString, reason);
    const auto drives = parseTamConfiguration(xml.toStdString(), "machine.TAMcfg");
    VERIFY_ERROR(drives, ErrorCode::InvalidConfiguration);
    const ErrorContext& context = drives.error().context;
    COMPARE_TEXT(context.english("file"), "machine.TAMcfg");
    COMPARE_TEXT(context.english("line"), std::to_string(line));
    QVERIFY2(context.english("reason").find(reason.toStdString()) != std::string::npos,
        context.english("reason").c_str());
    QVERIFY(!context.english("reason").empty());
}

void TestTamConfiguration::refusesDocumentTypes()
{
    std::string bomb = "<?xml version='1.0'?>\n<!DOCTYPE b [<!ENTITY a0 'aaaaaaaaaa'>";
    for (int n = 1; n < 20; ++n) {
        const std::string inner = "&a" + std::to_string(n - 1) + ";";
        bomb += "<!ENTITY a" + std::to_string(n) + " '" + inner + inner + inner + inner + "'>";
    }
    bomb += "]>\n" + withRegisters("&a19;");
    const auto drives = parseTamConfiguration(bomb, "f");
    VERIFY_ERROR(drives, ErrorCode::InvalidConfiguration);
    QVERIFY(drives.error().context.english("reason").find("document type") != std::string::npos);
    const auto external =
        parseTamConfiguration("<!DOCTYPE b SYSTEM 'file:///etc/passwd'>" + withRegisters(""), "f");
    VERIFY_ERROR(external, ErrorCode::InvalidConfiguration);
}

void TestTamConfiguration::refusesEndlessRegisters()
{
    std::string many;
    for (int n = 0; n <= 100'000; ++n)
        many += component("Axes[0]/A[" + std::to_string(n) + "]", "Int32", "1") + '\n';
    const auto drives = parseTamConfiguration(withRegisters(many), "f");
    VERIFY_ERROR(drives, ErrorCode::InvalidConfiguration);
    QVERIFY(drives.error().context.english("reason").find("100000") != std::string::npos);
}

void TestTamConfiguration::readsOtherEncodings()
{
    const QString text = QString::fromStdString("<?xml version='1.0' encoding='utf-16'?>"
        + withRegisters(component("Axes[0]/A", "E", "x")));
    const QByteArray utf16 =
        QByteArray::fromRawData(reinterpret_cast<const char*>(text.utf16()), text.size() * 2);
    const QByteArray marked = QByteArray("\xFF\xFE", 2) + utf16;
    const auto drives = parseTamConfiguration({marked.data(), std::size_t(marked.size())}, "f");
    VERIFY_RESULT(drives);
    QVERIFY(find(drives->front(), "Axes[0]/A") != nullptr);
}

void TestTamConfiguration::refusesFilesThatCannotBeRead()
{
    VERIFY_ERROR(loadTamConfiguration(file("missing.TAMcfg")), ErrorCode::FileNotReadable);
    VERIFY_ERROR(loadTamConfiguration(file(".")), ErrorCode::FileNotReadable);
    const QTemporaryDir folder;
    const std::filesystem::path large = folder.path().toStdString() + "/large.TAMcfg";
    std::ofstream(large).put(' ');
    std::filesystem::resize_file(large, (std::uintmax_t{64} << 20) + 1);
    VERIFY_ERROR(loadTamConfiguration(large), ErrorCode::FileTooLarge);
}

AXISCOMP_TEST(TestTamConfiguration)

} // namespace tst_tamconfiguration

#include "tst_tamconfiguration.moc"
