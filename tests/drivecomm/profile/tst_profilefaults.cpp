// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/profile/profile_loader.h"
#include "tests/drivecomm/profile/changed_profile.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <set>
#include <string>

namespace tst_profilefaults {

using namespace axiscomp;
using namespace axiscomp::drivecomm;
using namespace axiscomp::drivecomm::test;

/// What newer profiles have and older ones do not.
bool mayBeMissing(const std::string& key)
{
    static const std::set<std::string> optional{"description", "positionKinds", "temperatures",
        "errorNotHomed", "errorNoTable", "errorDimensionMismatch", "errorBadSource",
        "errorBadTable", "positionMinimum", "positionMaximum"};
    return optional.contains(key);
}

class TestProfileFaults : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { axiscomp::test::failOnWarnings(); }

    void aMissingKeyIsNamed_data()
    {
        QTest::addColumn<std::string>("path");
        const json document = genericJson();
        for (const auto& [key, value] : document.items()) {
            if (!mayBeMissing(key))
                QTest::newRow(key.c_str()) << key;
            for (const auto& [inner, member] : value.items()) {
                if (value.is_object() && !mayBeMissing(inner))
                    QTest::newRow((key + "." + inner).c_str()) << key + "." + inner;
            }
        }
        for (const char* path :
            {"slots[3].name", "slots[3].file", "slots[3].maximumSize", "layout.fields.size.offset",
                "layout.fields.size.type", "layout.fields.start", "layout.fields.distance"})
            QTest::newRow(path) << std::string(path);
    }
    void aMissingKeyIsNamed()
    {
        QFETCH(std::string, path);
        std::string pointer = "/" + path;
        for (char& c : pointer)
            c = c == '.' || c == '[' ? '/' : c;
        std::erase(pointer, ']');
        json document = genericJson();
        const json::json_pointer place(pointer);
        document[place.parent_pointer()].erase(place.back());
        verifyInvalid(parseProfile(document.dump(), "own.json"), path, "missing");
    }

    void aProfileWithoutTheNamesOfErrorsIsStillGood()
    {
        json document = genericJson();
        for (const char* key : {"errorNotHomed", "errorNoTable", "errorDimensionMismatch",
                 "errorBadSource", "errorBadTable"})
            document["enums"].erase(key);
        const auto profile = parseProfile(document.dump(), "own.json");
        VERIFY_RESULT(profile);
        QVERIFY(profile->enums.errorNotHomed.empty());
    }

    void aProfileWithoutTheTravelOfAnAxisIsStillGood()
    {
        json document = genericJson();
        document["registers"].erase("positionMinimum");
        document["registers"].erase("positionMaximum");
        const auto profile = parseProfile(document.dump(), "own.json");
        VERIFY_RESULT(profile);
        QVERIFY(profile->registers.positionMinimum.empty());
    }

    void anUnknownKeyIsNamed_data()
    {
        QTest::addColumn<std::string>("parent");
        QTest::addColumn<std::string>("path");
        const auto row = [](const char* parent, const char* path) {
            QTest::newRow(path) << std::string(parent) << std::string(path);
        };
        row("", "extra");
        row("/registers", "registers.extra");
        row("/enums", "enums.extra");
        row("/slots/2", "slots[2].extra");
        row("/layout", "layout.extra");
        row("/layout/fields", "layout.fields.extra");
        row("/layout/fields/size", "layout.fields.size.extra");
        row("/web", "web.extra");
        row("/flashWear", "flashWear.extra");
    }
    void anUnknownKeyIsNamed()
    {
        QFETCH(std::string, parent);
        QFETCH(std::string, path);
        const auto profile = changedProfile(
            [&](json& document) { document[json::json_pointer(parent)]["extra"] = 1; });
        verifyInvalid(profile, path, "\"extra\" is not known");
    }

    void aValueOfTheWrongTypeIsNamed_data();
    void aValueOfTheWrongTypeIsNamed();
    void aWrongValueIsNamedWithTheReason_data();
    void aWrongValueIsNamedWithTheReason();
    void textThatIsNoJsonIsPlaced_data();
    void textThatIsNoJsonIsPlaced();
};

void TestProfileFaults::aValueOfTheWrongTypeIsNamed_data()
{
    QTest::addColumn<Change>("change");
    QTest::addColumn<std::string>("path");
    const auto row = [](const char* pointer, const json& value, const char* path) {
        QTest::addRow("%s = %s", path, value.dump().c_str())
            << put(pointer, value) << std::string(path);
    };
    row("/name", 1, "name");
    row("/registers", json::array(), "registers");
    row("/registers/table", nullptr, "registers.table");
    row("/registers/deviceNameWords", "7", "registers.deviceNameWords");
    row("/registers/deviceNameWords", 7.5, "registers.deviceNameWords");
    row("/enums/homingDone", true, "enums.homingDone");
    row("/sourceShortlist", "Axes", "sourceShortlist");
    row("/sourceShortlist/1", 4, "sourceShortlist[1]");
    row("/sourceTypes/0", json::object(), "sourceTypes[0]");
    row("/slots", json::object(), "slots");
    row("/slots/1", "Small2", "slots[1]");
    row("/slots/1/maximumSize", -1, "slots[1].maximumSize");
    row("/slots/1/maximumSize", 4294967296, "slots[1].maximumSize");
    row("/slots/1/maximumSize", 18446744073709551615ULL, "slots[1].maximumSize");
    row("/layout", nullptr, "layout");
    row("/layout/byteOrder", 1, "layout.byteOrder");
    row("/layout/headerSize", "128", "layout.headerSize");
    row("/layout/fields/size", 20, "layout.fields.size");
    row("/layout/fields/size/offset", -20, "layout.fields.size.offset");
    row("/layout/fields/size/count", 0, "layout.fields.size.count");
    row("/web/files", 0, "web.files");
    row("/flashWear/operations", 1e99, "flashWear.operations");
    row("/writesAtOneInstant", 1, "writesAtOneInstant");
    row("/readsAtOneInstant", "true", "readsAtOneInstant");
}

void TestProfileFaults::aValueOfTheWrongTypeIsNamed()
{
    QFETCH(Change, change);
    QFETCH(std::string, path);
    verifyInvalid(changedProfile(change), path, "is expected, not ");
}

void TestProfileFaults::aWrongValueIsNamedWithTheReason_data()
{
    QTest::addColumn<Change>("change");
    QTest::addColumn<std::string>("path");
    QTest::addColumn<std::string>("reason");
    const auto row = [](const char* pointer, const json& value, const char* path,
                         const char* reason) {
        QTest::addRow("%s = %s", path, value.dump().substr(0, 80).c_str())
            << put(pointer, value) << std::string(path) << std::string(reason);
    };
    const auto path = [&](const json& value, const char* reason) {
        row("/registers/table", value, "registers.table", reason);
    };
    path("", "it is empty");
    path("Axes/Table", "placeholder {axis} is missing");
    path("Axes[{axis}]/{axis}", "{axis} is there more than once");
    path("Axes[{axis}]/{slot}", "{slot} has no meaning here");
    path("Axes[{axis}]/{n}", "{n} has no meaning here");
    path("Axes[{axis}]/{m}", "in braces");
    path("Axes[{axis}]/}", "in braces");
    path("/Axes[{axis}]", "one slash");
    path("Axes[{axis}]/", "one slash");
    path("Axes[{axis}]//A", "one slash");
    path("Axes[{axis}].Table", "character at position 13");
    path("Axes[{axis}]/a b", "character at position 15");
    path("Axes[{axis}]/\xC3\xA4", "character at position 14");
    path("{axis}" + std::string(251, 'a'), "257 characters");
    row("/registers/source", "Axes[{axis}]/Source", "registers.source", "{n} is missing");
    row("/registers/tableCrc", "Tables/Crc", "registers.tableCrc", "{slot} is missing");
    row("/registers/state", "Axes[{axis}]/Parameters/Compensations/Axis/Table", "registers.state",
        "same register as table");
    row("/registers/axisNameWords", 0, "registers.axisNameWords", "from 1 to 64");
    row("/registers/axisNameWords", 65, "registers.axisNameWords", "from 1 to 64");

    row("/name", "", "name", "a word");
    row("/name", "my drive", "name", "a word");
    row("/enums/stateActive", "", "enums.stateActive", "a word");
    row("/enums/stateActive", "Ramping", "enums.stateActive", "same value as stateRamping");
    row("/enums/tableCommandDelete", "Commit", "enums.tableCommandDelete",
        "same value as tableCommandCommit");

    const auto source = [&](const json& value, const char* reason) {
        row("/sourceShortlist/0", value, "sourceShortlist[0]", reason);
    };
    source("A[0..]", "a range goes");
    source("A[..5]", "a range goes");
    source("A[5..0]", "a range goes");
    source("A[-1..0]", "a range goes");
    source("A[0..x]", "a range goes");
    source("A[0...5]", "a range goes");
    source("A[0..99999999999]", "a range goes");
    source("A..B", "in brackets");
    source("A[0..2000000000]", "more than 1024");
    source("A[0..2000000000]/b c", "character at position");
    source("A[0..9999][0..9999][0..9999]", "more than 1024");
    source("A/{slot}", "{slot} has no meaning");
    source("A[{n}]", "{n} has no meaning");
    source("", "it is empty");
    source(std::string(300, 'a'), "300 characters");
    row("/sourceShortlist/3", "Application/Variables/Floats[3]", "sourceShortlist[4]",
        "there twice");
    row("/sourceTypes", json::array(), "sourceTypes", "at least one");
    row("/sourceTypes/1", "Single", "sourceTypes[1]", "there twice");
    row("/sourceTypes/1", "Boolean", "sourceTypes[1]", "a numeric type");

    row("/slots", json::array(), "slots", "at least one slot");
    row("/slots/4/name", "Small1", "slots[4].name", "another slot has the name Small1");
    row("/slots/4/file", "tables/small1.TAMtbl", "slots[4].file", "another slot has the file");
    row("/slots/4/name", "Disabled", "slots[4].name", "enums.tableDisabled");
    row("/slots/4/name", "Small/5", "slots[4].name", "a word");
    row("/slots/4/maximumSize", 135, "slots[4].maximumSize", "from 136 to 1073741824");
    for (const char* file : {"", "tables/a b", "a?b", "a%20", "a\\b", "a\"b", "a\tb"})
        row("/slots/4/file", file, "slots[4].file", "a file path such as");
    for (const char* file : {"/tables/a", "tables/", "tables//a", "../a", "tables/../a", "./a"})
        row("/slots/4/file", file, "slots[4].file", "between its slashes");

    row("/layout/byteOrder", "middle", "layout.byteOrder", "\"little\" or \"big\"");
    row("/layout/fastestDimension", "1", "layout.fastestDimension", "\"first\" or \"last\"");
    row("/layout/headerSize", 0, "layout.headerSize", "it is 0");
    row("/layout/headerSize", 100, "layout.fields.name", "the header has only 100");
    row("/layout/magic", "TAM", "layout.fields.magic", "length of the magic text, 3");
    row("/layout/version", 65536, "layout.fields.version", "cannot hold 65536");
    const auto type = [&](const json& value, const char* reason) {
        row("/layout/fields/name/type", value, "layout.fields.name.type", reason);
    };
    type("char", "number of characters is missing");
    type("string", "one of u8");
    type("char[]", "one of u8");
    type("char[4", "one of u8");
    type("char[4]x", "one of u8");
    type("char[-4]", "one of u8");
    type("char[99999999999]", "one of u8");
    row("/layout/fields/name/type", "u32[8]", "layout.fields.name", "expected char");
    row("/layout/fields/name/count", 32, "layout.fields.name.count", "given twice");
    row("/layout/fields/size/count", 2, "layout.fields.size", "its count is 2");
    row("/layout/fields/size/offset", 19, "layout.fields.size", "inside dimensions");
    row("/layout/fields/headerCrc/offset", 125, "layout.fields.headerCrc", "ends at byte 129");
    QTest::newRow("version without its field")
        << without("/layout/fields", "version") << std::string("layout.version")
        << std::string("there is no field version to hold it");

    const char* const set = "Axes[{axis}]/Signals/PathPlanner/Position";
    const char* const encoder = "Axes[{axis}]/Signals/PositionController/Encoders[1]/Position";
    row("/positionKinds/afterCompensation/0", set, "positionKinds.commanded",
        "PathPlanner/Position is in afterCompensation too");
    row("/positionKinds/commanded/0", encoder, "positionKinds.commanded",
        "Encoders[1]/Position is in beforeCompensation too");
    row("/positionKinds/afterCompensation/0", encoder, "positionKinds.afterCompensation",
        "Encoders[1]/Position is in beforeCompensation too");
    for (const char* position : {set, "Axes[1]/Signals/PathPlanner/Position"})
        row("/temperatures/0", position, "temperatures", "is in positionKinds too");

    for (const char* page : {"", "directory", "/a b", "/a?b", "/a#b", "//a"})
        row("/web/directory", page, "web.directory", "path of a web page");
    row("/web/directory", "/", "web.directory", "no slash at the end");
    row("/web/files", "/files", "web.files", "a slash is needed at the end");
    row("/web/transfer", "/directory", "web.transfer", "same page as directory");
    row("/web/registers", "/transfer", "web.registers", "same page as directory or transfer");
    row("/web/transferFileField", "filepath", "web.transferFileField", "same field");
    row("/web/transferFileField", "a\"b", "web.transferFileField", "a word");
    row("/flashWear/operations", 0, "flashWear.operations", "from 1 to");
    row("/flashWear/windowSeconds", 0, "flashWear.windowSeconds", "from 1 to");
    row("/flashWear/ratedCycles", -1, "flashWear.ratedCycles", "from 0 to");
}

void TestProfileFaults::aWrongValueIsNamedWithTheReason()
{
    QFETCH(Change, change);
    QFETCH(std::string, path);
    QFETCH(std::string, reason);
    verifyInvalid(changedProfile(change), path, reason);
}

void TestProfileFaults::textThatIsNoJsonIsPlaced_data()
{
    QTest::addColumn<std::string>("text");
    QTest::addColumn<std::string>("path");
    QTest::addColumn<std::string>("reason");
    const auto row = [](const char* name, const std::string& text, const char* path,
                         const char* reason) {
        QTest::newRow(name) << text << std::string(path) << std::string(reason);
    };
    const char* const noJson = "this is not JSON";
    row("empty", "", "line 1, column 1", noJson);
    row("a comma too many", "{\n \"name\": \"a\",\n \"b\":,\n}", "line 3, column 6", noJson);
    row("cut off", "{\n\"name\": \"gen", "line 2, column 13", noJson);
    row("another language", "<html></html>", "line 1, column 1", noJson);
    row("not UTF-8", "{\"name\": \"\xFF\"}", "line 1, column 11", noJson);
    row("no number", "{\"name\": 1e999}", "line 1, column 14", noJson);
    row("something behind", "{}\n{", "line 2, column 1", noJson);
    row("no object", "[]", "the document", "an object is expected");
    row("twice", R"({"name": "a", "name": "b"})", "name", "there twice");
    row("twice further down", R"({"slots": [{}, {"name": "a", "file": "b", "name": "c"}]})",
        "slots[1].name", "there twice");
    row("too deep", std::string(1000, '['), "the document", "nested deeper than 8");
    row("too long", std::string((1 << 20) + 1, ' '), "the document", "1048576");
    std::string many = "[0";
    for (int i = 0; i < 30'000; ++i)
        many += ",0";
    row("too many numbers", many + "]", "the document", "more than 20000 values");
}

void TestProfileFaults::textThatIsNoJsonIsPlaced()
{
    QFETCH(std::string, text);
    QFETCH(std::string, path);
    QFETCH(std::string, reason);
    verifyInvalid(parseProfile(text, "own.json"), path, reason);
}

AXISCOMP_TEST(TestProfileFaults)

} // namespace tst_profilefaults

#include "tst_profilefaults.moc"
