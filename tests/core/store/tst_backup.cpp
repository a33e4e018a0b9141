// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/bytes.h"
#include "core/store/backup.h"
#include "core/table/table_layout.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <cmath>
#include <limits>
#include <random>

namespace tst_backup {

using namespace axiscomp;
using namespace std::chrono_literals;

namespace {

AxisBackup example()
{
    AxisBackup backup;
    backup.drive = {"Triamec-616", 1559, 2};
    backup.axis = 1;
    backup.axisName = "X";
    backup.time = *utcFromText("2026-11-21T08:02:23.25Z");
    backup.registers = {
        {"Axes[1]/Parameters/Compensations/Axis/Table", std::string("Small1")},
        {"Axes[1]/Parameters/Compensations/Axis/Dim1Source", std::uint32_t{0x1234}},
    };
    backup.files = {
        {"Small1", "tables/small1.TAMtbl", {std::byte{1}, std::byte{2}, std::byte{0xff}}, true},
        {"Small2", "tables/small2.TAMtbl", {}, false},
    };
    return backup;
}

/// With a table that no axis uses.
DriveBackup withOthers(const AxisBackup& axis)
{
    DriveBackup backup;
    backup.axes = {axis};
    backup.otherFiles = {{"Large1", "tables/large1.TAMtbl", Bytes(4, std::byte{0}), false}};
    return backup;
}

std::string textOf(const AxisBackup& axis)
{
    return writeBackup(withOthers(axis));
}

std::string exampleText()
{
    return textOf(example());
}

/// The text with the first `from` replaced; fails loudly when there is none.
std::string changed(std::string text, std::string_view from, std::string_view to)
{
    const std::size_t place = text.find(from);
    if (place == std::string::npos)
        qFatal("the example has no such text");
    return text.replace(place, from.size(), to);
}

template <typename Random> std::string randomText(Random& random)
{
    static constexpr std::array<std::string_view, 8> parts{
        "a", "\"", "\\", "\n", "µ", "\x01", "/", "日本"};
    std::string text;
    for (auto i = random() % 6; i > 0; --i)
        text += parts[random() % parts.size()];
    return text;
}

template <typename Random> RegisterValue randomValue(Random& random)
{
    const auto bits = random();
    switch (bits % 6) {
    case 0:
        return bits % 12 == 0;
    case 1:
        return static_cast<std::int32_t>(static_cast<std::uint32_t>(random()));
    case 2:
        return static_cast<std::uint32_t>(random());
    case 3: {
        const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
        return std::isnan(value) ? 0.0F : value;
    }
    case 4: {
        const auto value = std::bit_cast<double>(std::uint64_t{random()});
        return std::isnan(value) ? -0.0 : value;
    }
    default:
        return randomText(random);
    }
}

template <typename Random> AxisBackup randomBackup(Random& random, int axis)
{
    AxisBackup backup;
    backup.drive = {randomText(random), static_cast<std::int32_t>(random() & 0xffffffffU), 8};
    backup.axis = axis;
    backup.axisName = randomText(random);
    backup.time = WallTime{std::chrono::nanoseconds{static_cast<std::int64_t>(random() >> 2)}};
    for (auto i = random() % 5; i > 0; --i)
        backup.registers.push_back({randomText(random) + std::to_string(i), randomValue(random)});
    for (auto i = random() % 4; i > 0; --i) {
        Bytes bytes(random() % 1000);
        for (std::byte& byte : bytes)
            byte = static_cast<std::byte>(random() & 0xffU);
        backup.files.push_back({randomText(random), std::to_string(i), bytes, random() % 2 == 0});
    }
    return backup;
}

} // namespace

class TestAxisBackup : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void formIsStable();
    void exampleComesBack();
    void unitsAndPathsComeBackAndMayBeMissing();
    void everyBackupComesBack();
    void numbersWithoutAJsonForm_data();
    void numbersWithoutAJsonForm();
    void extremeNumbersComeBackExactly();
    void textThatIsNotUtf8IsReplaced();
    void membersMayBeInAnyOrder();
    void faultIsNamedByItsPath_data();
    void faultIsNamedByItsPath();
    void everyTruncationIsRefused();
    void everyMissingMemberIsNamed();
    void depthIsLimited_data();
    void depthIsLimited();
    void numberOfValuesIsLimited();
    void sizeIsLimited();

    void base64OfRfc4648_data();
    void base64OfRfc4648();
    void base64ComesBack();
    void base64IsCanonical_data();
    void base64IsCanonical();

    void timesAsText_data();
    void timesAsText();
    void wrongTimesAreRefused_data();
    void wrongTimesAreRefused();
};

void TestAxisBackup::formIsStable()
{
    QCOMPARE(QString::fromStdString(exampleText()), QStringLiteral(R"({
  "format": "axiscomp-backup",
  "version": 1,
  "axes": [
    {
      "drive": {
        "name": "Triamec-616",
        "serialNumber": 1559,
        "axes": 2
      },
      "axis": 1,
      "axisName": "X",
      "time": "2026-11-21T08:02:23.25Z",
      "registers": [
        {
          "path": "Axes[1]/Parameters/Compensations/Axis/Table",
          "type": "Enum",
          "value": "Small1"
        },
        {
          "path": "Axes[1]/Parameters/Compensations/Axis/Dim1Source",
          "type": "UInt32",
          "value": 4660
        }
      ],
      "files": [
        {
          "slot": "Small1",
          "path": "tables/small1.TAMtbl",
          "persistent": true,
          "crc32": "e1b73e2a",
          "bytes": "AQL/"
        },
        {
          "slot": "Small2",
          "path": "tables/small2.TAMtbl",
          "persistent": false,
          "crc32": "00000000",
          "bytes": ""
        }
      ]
    }
  ],
  "otherFiles": [
    {
      "slot": "Large1",
      "path": "tables/large1.TAMtbl",
      "persistent": false,
      "crc32": "2144df1c",
      "bytes": "AAAAAA=="
    }
  ]
}
)"));
}

void TestAxisBackup::exampleComesBack()
{
    const auto backup = readBackup(exampleText(), "b.json");
    VERIFY_RESULT(backup);
    QVERIFY(*backup == withOthers(example()));
    VERIFY_RESULT(readBackup(writeBackup({}), "b.json"));
}

void TestAxisBackup::unitsAndPathsComeBackAndMayBeMissing()
{
    AxisBackup axis = example();
    axis.unit = "Millimeter";
    axis.sourceUnits = {"", "Degree"};
    axis.sourcePaths = {"Axes[0]/Signals/Sensor", "Axes[1]/Signals/Position"};
    axis.profile = "generic";
    axis.layout = layoutText(genericTableLayout());
    const auto backup = readBackup(textOf(axis), "b.json");
    VERIFY_RESULT(backup);
    QVERIFY(backup->axes[0] == axis);
    const auto refused =
        readBackup(changed(textOf(axis), "\"unit\": \"Millimeter\"", "\"unit\": 1"), "b.json");
    VERIFY_ERROR(refused, ErrorCode::InvalidBackup);
    QVERIFY(refused.error().context.english("reason").starts_with("axes[0].unit: "));
    QCOMPARE(
        axis.layout, "little 128 first dimensions=u32@16 size=u32@20 start=f64@32 distance=f64@56");
    QVERIFY(exampleText().find("nit") == std::string::npos
        && exampleText().find("sourcePaths") == std::string::npos
        && exampleText().find("layout") == std::string::npos); // as older versions wrote it
}

void TestAxisBackup::everyBackupComesBack()
{
    std::mt19937_64 random{616};
    for (int i = 0; i < 300; ++i) {
        DriveBackup backup;
        for (int axis = 0; axis < i % 4; ++axis)
            backup.axes.push_back(randomBackup(random, axis));
        backup.otherFiles = randomBackup(random, 0).files;
        const std::string text = writeBackup(backup);
        const auto back = readBackup(text, "b.json");
        VERIFY_RESULT(back);
        QVERIFY(*back == backup);
        QVERIFY(writeBackup(*back) == text);
    }
}

void TestAxisBackup::numbersWithoutAJsonForm_data()
{
    QTest::addColumn<double>("value");
    QTest::newRow("NaN") << std::numeric_limits<double>::quiet_NaN();
    QTest::newRow("infinity") << std::numeric_limits<double>::infinity();
    QTest::newRow("minus infinity") << -std::numeric_limits<double>::infinity();
}

void TestAxisBackup::numbersWithoutAJsonForm()
{
    QFETCH(double, value);
    AxisBackup backup = example();
    backup.registers = {{"single", static_cast<float>(value)}, {"double", value}};
    const auto back = readBackup(textOf(backup), "b.json");
    VERIFY_RESULT(back);
    const auto single = std::get<float>(back->axes[0].registers[0].value);
    const auto twice = std::get<double>(back->axes[0].registers[1].value);
    QCOMPARE(std::isnan(single), std::isnan(value));
    QCOMPARE(std::isnan(twice), std::isnan(value));
    QVERIFY(std::isnan(value) || (single == static_cast<float>(value) && twice == value));
}

void TestAxisBackup::extremeNumbersComeBackExactly()
{
    AxisBackup backup = example();
    backup.registers = {
        {"a", std::numeric_limits<float>::denorm_min()},
        {"b", std::numeric_limits<float>::max()},
        {"c", -0.0F},
        {"d", std::numeric_limits<double>::denorm_min()},
        {"e", std::numeric_limits<double>::lowest()},
        {"f", 0.1},
        {"g", std::numeric_limits<std::int32_t>::min()},
        {"h", std::numeric_limits<std::uint32_t>::max()},
        {"i", 3.0},
    };
    backup.drive.serialNumber = std::numeric_limits<std::int32_t>::min();
    const auto back = readBackup(textOf(backup), "b.json");
    VERIFY_RESULT(back);
    QVERIFY(back->axes[0] == backup);
    QVERIFY(std::signbit(std::get<float>(back->axes[0].registers[2].value)));
}

void TestAxisBackup::textThatIsNotUtf8IsReplaced()
{
    AxisBackup backup = example();
    backup.drive.name = "Dr\xfcve";
    const std::string text = textOf(backup);
    const auto back = readBackup(text, "b.json");
    VERIFY_RESULT(back);
    QCOMPARE(back->axes[0].drive.name, std::string("Dr\xef\xbf\xbdve"));
    QCOMPARE(writeBackup(*back), text);
}

void TestAxisBackup::membersMayBeInAnyOrder()
{
    const std::string text = changed(exampleText(), R"("name": "Triamec-616",
        "serialNumber": 1559,
        "axes": 2)",
        R"("axes": 2, "serialNumber":1559,"name": "Triamec-616")");
    const auto backup = readBackup(text, "b.json");
    VERIFY_RESULT(backup);
    QVERIFY(backup->axes[0] == example());
}

void TestAxisBackup::faultIsNamedByItsPath_data()
{
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<QByteArray>("to");
    QTest::addColumn<QString>("reason");
    const auto row = [](const char* name, const char* from, const char* to, const char* reason) {
        QTest::newRow(name) << QByteArray(from) << QByteArray(to) << QString::fromUtf8(reason);
    };
    row("other format", "axiscomp-backup", "something", "format: \"axiscomp-backup\" is expected");
    row("later version", "\"version\": 1", "\"version\": 2", "version: only version 1");
    row("version as text", "\"version\": 1", "\"version\": \"1\"",
        "version: a whole number from -2147483648 to 2147483647 is expected, not \"1\"");
    row("missing member", "\"axisName\": \"X\",", "", "axes[0].axisName: this is missing");
    row("unknown member", "\"axis\": 1", "\"axis\": 1, \"extra\": 0",
        "axes[0]: the member \"extra\" is not known");
    row("member twice", "\"axis\": 1", "\"axis\": 1, \"axis\": 0",
        "the member \"axis\" is there twice");
    row("negative axis", "\"axis\": 1", "\"axis\": -1", "axes[0].axis: a whole number from 0");
    row("fractional axis", "\"axis\": 1", "\"axis\": 1.0", "axes[0].axis: a whole number from 0");
    row("serial number too large", "1559", "2147483648", "axes[0].drive.serialNumber: a whole");
    row("serial number beyond 64 bits", "1559", "18446744073709551615",
        "axes[0].drive.serialNumber: a whole");
    row("number beyond any", "1559", "1e999", "line 8, column ");
    row("drive is no object",
        "{\n        \"name\": \"Triamec-616\",\n        \"serialNumber\": "
        "1559,\n        \"axes\": 2\n      }",
        "[1]", "axes[0].drive: an object is expected, not a list");
    row("time", "08:02:23.25Z", "08:02:23.25+01:00", "axes[0].time: a time such as");
    row("type", "\"UInt32\"", "\"Byte\"", "axes[0].registers[1].type: one of Boolean");
    row("value of another type", "\"UInt32\"", "\"Boolean\"",
        "axes[0].registers[1].value: true or false is expected, not 4660");
    row("value too large", "4660", "4294967296",
        "axes[0].registers[1].value: a whole number from 0 to 4294967295");
    row("text for a number", "\"Enum\"", "\"Double\"",
        "axes[0].registers[0].value: a number is expected, or NaN");
    row("single too large", "\"UInt32\",\n          \"value\": 4660", "\"Single\", \"value\": 1e39",
        "axes[0].registers[1].value: this is too large");
    row("register twice", "Axis/Dim1Source", "Axis/Table",
        "axes[0].registers[1].path: this is there twice");
    row("files are no list", "\"files\": [", "\"files\": {\"a\": [",
        "line 43, column 3"); // brackets no longer match
    row("base64", "AQL/", "AQL*", "axes[0].files[0].bytes: this is not base64");
    row("damaged bytes", "AQL/", "AQL+", "axes[0].files[0].crc32: the bytes have the CRC-32 ");
    row("crc of other form", "e1b73e2a", "E1B73E2A",
        "axes[0].files[0].crc32: a CRC-32 of eight hexadecimal digits");
    row("persistent", "true", "1", "axes[0].files[0].persistent: true or false is expected, not 1");
    row("file twice", "Small2\",\n          \"path\": \"tables/small2",
        "Small1\",\n          \"path\": \"tables/small1",
        "axes[0].files[1].path: this file is there twice");
    row("another file twice", "\"otherFiles\": [",
        "\"otherFiles\": [{\"slot\": \"Large1\", \"path\": \"tables/large1.TAMtbl\", "
        "\"persistent\": false, \"crc32\": \"00000000\", \"bytes\": \"\"},",
        "otherFiles[1].path: this file is there twice");
    row("comment", "\"version\": 1", "\"version\": 1 /* */", "line 3, column ");
    row("not UTF-8", "Triamec", "Tri\xffmec", "line 7, column ");
    row("something behind the end", "  ]\n}\n", "  ]\n}\n{}", "line 54, column 1");
}

void TestAxisBackup::faultIsNamedByItsPath()
{
    QFETCH(QByteArray, from);
    QFETCH(QByteArray, to);
    QFETCH(QString, reason);
    const auto backup =
        readBackup(changed(exampleText(), from.toStdString(), to.toStdString()), "b.json");
    VERIFY_ERROR(backup, ErrorCode::InvalidBackup);
    QCOMPARE(backup.error().context.english("file"), std::string("b.json"));
    const QString found = QString::fromStdString(backup.error().context.english("reason"));
    QVERIFY2(found.startsWith(reason), qPrintable(found));
}

void TestAxisBackup::everyTruncationIsRefused()
{
    const std::string text = exampleText();
    const std::size_t lastBrace = text.rfind('}');
    for (std::size_t length = 0; length <= lastBrace; ++length)
        VERIFY_ERROR(readBackup(text.substr(0, length), "b.json"), ErrorCode::InvalidBackup);
}

void TestAxisBackup::everyMissingMemberIsNamed()
{
    // Renaming a member makes it missing, whichever it is.
    const std::string text = exampleText();
    int members = 0;
    for (std::size_t place = text.find("\": "); place != std::string::npos;
         place = text.find("\": ", place + 1)) {
        const std::size_t begin = text.rfind('"', place - 1) + 1;
        const std::string name = text.substr(begin, place - begin);
        const auto backup = readBackup(std::string(text).replace(begin, name.size(), "other"), "b");
        VERIFY_ERROR(backup, ErrorCode::InvalidBackup);
        const std::string reason = backup.error().context.english("reason");
        QVERIFY2(reason.find(name + ": this is missing") != std::string::npos, reason.c_str());
        ++members;
    }
    QCOMPARE(members, 34);
}

void TestAxisBackup::depthIsLimited_data()
{
    QTest::addColumn<QByteArray>("begin");
    QTest::newRow("lists") << QByteArray("[");
    QTest::newRow("objects") << QByteArray("{\"a\":");
}

void TestAxisBackup::depthIsLimited()
{
    QFETCH(QByteArray, begin);
    const auto backup = readBackup(begin.repeated(1'000'000).toStdString(), "b.json");
    VERIFY_ERROR(backup, ErrorCode::InvalidBackup);
    QCOMPARE(
        backup.error().context.english("reason"), std::string("it is nested deeper than 8 levels"));
}

void TestAxisBackup::numberOfValuesIsLimited()
{
    std::string text = "[0";
    for (int i = 0; i < 200'000; ++i)
        text += ",0";
    const auto backup = readBackup(text + "]", "b.json");
    VERIFY_ERROR(backup, ErrorCode::InvalidBackup);
    QCOMPARE(
        backup.error().context.english("reason"), std::string("it has more than 100000 values"));
}

void TestAxisBackup::sizeIsLimited()
{
    const std::string blanks(maximumBackupSize + 1, ' ');
    const auto backup = readBackup(blanks, "b.json");
    VERIFY_ERROR(backup, ErrorCode::InvalidBackup);
    QCOMPARE(backup.error().context.english("reason"),
        std::string("it has 134217729 bytes, more than the 134217728 that such a file can have"));
}

void TestAxisBackup::base64OfRfc4648_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("0") << QByteArray("") << QByteArray("");
    QTest::newRow("1") << QByteArray("f") << QByteArray("Zg==");
    QTest::newRow("2") << QByteArray("fo") << QByteArray("Zm8=");
    QTest::newRow("3") << QByteArray("foo") << QByteArray("Zm9v");
    QTest::newRow("4") << QByteArray("foob") << QByteArray("Zm9vYg==");
    QTest::newRow("5") << QByteArray("fooba") << QByteArray("Zm9vYmE=");
    QTest::newRow("6") << QByteArray("foobar") << QByteArray("Zm9vYmFy");
    QTest::newRow("high bits") << QByteArray("\xfb\xff\xbf", 3) << QByteArray("+/+/");
}

void TestAxisBackup::base64OfRfc4648()
{
    QFETCH(QByteArray, bytes);
    QFETCH(QByteArray, text);
    const std::string plain = bytes.toStdString();
    QCOMPARE(toBase64(asBytes(plain)), text.toStdString());
    const auto back = fromBase64(text.toStdString());
    QVERIFY(back.has_value());
    QCOMPARE(std::string(asText(*back)), plain);
}

void TestAxisBackup::base64ComesBack()
{
    std::mt19937 random{4648};
    for (std::size_t size = 0; size < 300; ++size) {
        Bytes bytes(size);
        for (std::byte& byte : bytes)
            byte = static_cast<std::byte>(random() & 0xffU);
        const std::string text = toBase64(bytes);
        const QByteArray raw(
            reinterpret_cast<const char*>(bytes.data()), static_cast<qsizetype>(bytes.size()));
        QCOMPARE(QByteArray::fromStdString(text), raw.toBase64()); // another implementation
        QVERIFY(fromBase64(text) == bytes);
    }
}

void TestAxisBackup::base64IsCanonical_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("no padding") << QByteArray("Zg");
    QTest::newRow("half the padding") << QByteArray("Zg=");
    QTest::newRow("too much padding") << QByteArray("Z===");
    QTest::newRow("only padding") << QByteArray("====");
    QTest::newRow("padding inside") << QByteArray("Zg==Zm9v");
    QTest::newRow("stray bits of one byte") << QByteArray("Zh==");
    QTest::newRow("stray bits of two bytes") << QByteArray("Zm9=");
    QTest::newRow("line break") << QByteArray("Zm9v\nZm9");
    QTest::newRow("url alphabet") << QByteArray("-_-_");
    QTest::newRow("high byte") << QByteArray("Zm9\xe9");
    QTest::newRow("one digit") << QByteArray("Z");
}

void TestAxisBackup::base64IsCanonical()
{
    QFETCH(QByteArray, text);
    QVERIFY(!fromBase64(text.toStdString()).has_value());
}

void TestAxisBackup::timesAsText_data()
{
    QTest::addColumn<qint64>("nanoseconds");
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("epoch") << qint64{0} << QByteArray("1970-01-01T00:00:00Z");
    QTest::newRow("before it") << qint64{-1} << QByteArray("1969-12-31T23:59:59.999999999Z");
    QTest::newRow("leap day") << qint64{1709164800'000000000} << QByteArray("2024-02-29T00:00:00Z");
    QTest::newRow("fraction") << qint64{1'500000000} << QByteArray("1970-01-01T00:00:01.5Z");
    QTest::newRow("one nanosecond") << qint64{1} << QByteArray("1970-01-01T00:00:00.000000001Z");
    QTest::newRow("first") << qint64{-9214560000'000000000} << QByteArray("1678-01-01T00:00:00Z");
    QTest::newRow("last") << qint64{9214646399'999999999}
                          << QByteArray("2261-12-31T23:59:59.999999999Z");
}

void TestAxisBackup::timesAsText()
{
    QFETCH(qint64, nanoseconds);
    QFETCH(QByteArray, text);
    const WallTime time{std::chrono::nanoseconds{nanoseconds}};
    QCOMPARE(utcText(time), text.toStdString());
    QVERIFY(utcFromText(text.toStdString()) == time);
}

void TestAxisBackup::wrongTimesAreRefused_data()
{
    QTest::addColumn<QByteArray>("text");
    for (const char* text : {"", "Z", "2026-11-21", "2026-11-21T08:02:23", "2026-11-21 08:02:23Z",
             "2026-11-21T08:02Z", "2026-02-29T00:00:00Z", "2026-13-01T00:00:00Z",
             "2026-00-10T00:00:00Z", "2026-11-31T00:00:00Z", "2026-11-21T24:00:00Z",
             "2026-11-21T08:60:00Z", "2026-11-21T08:02:60Z", "2026-11-21T08:02:23.Z",
             "2026-11-21T08:02:23.1234567890Z", "2026-11-21T08:02:23Zx", "+026-11-21T08:02:23Z",
             "1677-12-31T23:59:59Z", "2262-01-01T00:00:00Z", "2026-11-21T08:02:23.5+00:00"})
        QTest::newRow(*text != '\0' ? text : "empty") << QByteArray(text);
}

void TestAxisBackup::wrongTimesAreRefused()
{
    QFETCH(QByteArray, text);
    QVERIFY(!utcFromText(text.toStdString()).has_value());
}

AXISCOMP_TEST(TestAxisBackup)

} // namespace tst_backup

#include "tst_backup.moc"
