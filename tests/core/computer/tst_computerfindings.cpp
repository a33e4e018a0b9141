// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/computer/computer_findings.h"
#include "core/computer/configuration_facts.h"
#include "core/computer/program_facts.h"
#include "core/computer/serial_findings.h"
#include "core/computer/store_findings.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QFile>
#include <QTemporaryDir>

#include <algorithm>

#include <sys/stat.h>

namespace tst_computerfindings {

using namespace axiscomp;
using Kind = FolderFacts::Kind;

namespace {

constexpr std::uint64_t plenty = 50'000'000'000;
const WallTime now = *utcFromText("2026-11-21T08:02:23Z");

/// The last of that name; a problem that says so where there is none.
Finding named(const FindingSection& section, const std::string& name)
{
    for (const Finding& finding : section.findings)
        if (finding.name.english() == name)
            return finding;
    return {Verbatim{name}, Grade::Problem, Verbatim{"there is no such finding"}};
}

bool says(const Text& text, const char* words)
{
    return text.english().find(words) != std::string::npos;
}

FolderFacts folder(Kind kind = Kind::Folder)
{
    FolderFacts facts{"/home/anna/.local/state/axiscomp"};
    facts.kind = kind;
    facts.nearest = kind == Kind::Folder ? facts.path : facts.path.parent_path();
    facts.mayUse = facts.isOwn = true;
    facts.owner = "anna";
    facts.mode = 0700;
    facts.fileSystem = system::FileSystemFacts{.freeBytes = plenty};
    return facts;
}

ComputerFacts computer()
{
    ComputerFacts facts;
    facts.clock.now = now;
    facts.temporary = folder();
    facts.locale.encoding = "UTF-8";
    return facts;
}

Finding folderIn(const FolderFacts& facts)
{
    return named(storeFindings(facts, StoreCondition{}, now), "folder");
}

StoreCondition::Write interrupted(bool isBeingDone)
{
    StoreCondition::Write write;
    write.entry.serialNumber = 1559;
    write.entry.axis = 2;
    write.entry.time = now;
    write.entry.step = "upload";
    write.isBeingDone = isBeingDone;
    return write;
}

} // namespace

class TestComputerFindings final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theDistributionIsReadAsAShellReadsIt();
    void aClockThatIsYearsBehindIsAProblem();
    void withoutADisplayTheWindowIsNamed();
    void anotherEncodingThanUtf8IsNamed();
    void aProxyIsNamedWithoutItsValue();
    void aTemporaryFolderMustBeThere();
    void aFolderThatCannotBeMadeSaysWhy_data();
    void aFolderThatCannotBeMadeSaysWhy();
    void aFolderOfRootHasItsCommand();
    void littleRoomIsANoteAndNoneAProblem();
    void theNetworkIsAProblemAndMemoryANote();
    void whatTheDatabaseIsDecidesTheGrade_data();
    void whatTheDatabaseIsDecidesTheGrade();
    void anInterruptedWriteIsAProblemUnlessItGoesOn();
    void aDatabaseOfTheFutureTellsOfTheClock();
    void anAdapterWithoutPermissionIsAProblemAndABuiltInPortANote();
    void theGroupIsJoinedOrTheSessionBegunAnew();
    void aWrongProfileIsNamed();
    void whatIsNotInstalledIsNamed();
    void realFoldersAreLookedAt();
    void sizesAreShort();
};

void TestComputerFindings::theDistributionIsReadAsAShellReadsIt()
{
    QCOMPARE(distributionOf("ID=debian\nPRETTY_NAME=\"Debian GNU/Linux 12 (bookworm)\"\n"),
        "Debian GNU/Linux 12 (bookworm)");
    QCOMPARE(distributionOf("PRETTY_NAME='My \\\"Linux\\\"'"), "My \"Linux\"");
    QCOMPARE(distributionOf("PRETTY_NAME=Alpine\nID=x"), "Alpine");
    QCOMPARE(distributionOf("NAME=x\n"), "");
    QCOMPARE(distributionOf(""), "");
}

void TestComputerFindings::aClockThatIsYearsBehindIsAProblem()
{
    ComputerFacts facts = computer();
    QCOMPARE(named(systemFindings(facts), "clock").grade, Grade::Ok);
    facts.clock.program = now + std::chrono::days(100);
    QCOMPARE(named(systemFindings(facts), "clock").grade, Grade::Ok);
    facts.clock.now = *utcFromText("1970-01-01T00:00:10Z");
    const Finding wrong = named(systemFindings(facts), "clock");
    QCOMPARE(wrong.grade, Grade::Problem);
    QVERIFY(says(wrong.found, "1970-01-01T00:00:10Z") && says(wrong.wayOut, "set the clock"));
}

void TestComputerFindings::withoutADisplayTheWindowIsNamed()
{
    ComputerFacts facts = computer();
    const Finding none = named(systemFindings(facts), "display");
    QCOMPARE(none.grade, Grade::Note);
    QVERIFY(says(none.found, "the window needs one"));
    facts.display.display = ":0";
    QCOMPARE(named(systemFindings(facts), "display").found.english(), "DISPLAY=:0");
    facts.display.waylandDisplay = "wayland-0";
    QCOMPARE(named(systemFindings(facts), "display").grade, Grade::Ok);
    facts.display.platform = "offscreen"; // counts before both
    QCOMPARE(named(systemFindings(facts), "display").grade, Grade::Note);
}

void TestComputerFindings::anotherEncodingThanUtf8IsNamed()
{
    LocaleFacts locale;
    locale.variables = {{"LC_ALL", "de_DE"}};
    locale.encoding = "utf8";
    QCOMPARE(named(languageFindings(locale, {"en"}), "locale").grade, Grade::Ok);
    locale.encoding = "ISO-8859-1";
    const Finding latin = named(languageFindings(locale, {"en"}), "locale");
    QCOMPARE(latin.grade, Grade::Note);
    QVERIFY(says(latin.found, "LC_ALL=de_DE") && says(latin.found, "ISO-8859-1"));
    locale.encoding = "UTF-8";
    locale.isInstalled = false;
    QVERIFY(says(named(languageFindings(locale, {"en"}), "locale").found, "not installed"));
    QCOMPARE(
        named(languageFindings(locale, {"en", "de"}), "translations").found.english(), "en, de");
}

void TestComputerFindings::aProxyIsNamedWithoutItsValue()
{
    ComputerFacts facts = computer();
    QCOMPARE(named(systemFindings(facts), "proxies").grade, Grade::Ok);
    facts.proxies = {"http_proxy", "no_proxy"};
    const Finding proxies = named(systemFindings(facts), "proxies");
    QCOMPARE(proxies.grade, Grade::Note);
    QVERIFY(says(proxies.found, "http_proxy, no_proxy"));
}

void TestComputerFindings::aTemporaryFolderMustBeThere()
{
    ComputerFacts facts = computer();
    QCOMPARE(named(systemFindings(facts), "temporary folder").grade, Grade::Ok);
    for (const bool couldBeMade : {true, false}) {
        facts.temporary = folder(Kind::Missing);
        facts.temporary.mayUse = couldBeMade;
        const Finding missing = named(systemFindings(facts), "temporary folder");
        QCOMPARE(missing.grade, Grade::Problem);
        QVERIFY(says(missing.found, "is not there") && says(missing.wayOut, "TMPDIR"));
    }
    facts.temporary = folder(Kind::Blocked);
    QVERIFY(says(named(systemFindings(facts), "temporary folder").found, "is no folder"));
}

void TestComputerFindings::aFolderThatCannotBeMadeSaysWhy_data()
{
    QTest::addColumn<Kind>("kind");
    QTest::addColumn<bool>("mayUse");
    QTest::addColumn<QString>("said");
    QTest::newRow("a file") << Kind::Blocked << false << "is no folder";
    QTest::newRow("hidden") << Kind::Hidden << false << "no permission to look into";
    QTest::newRow("of others") << Kind::Missing << false << "belongs to root";
    QTest::newRow("not yet") << Kind::Missing << true << "";
}

void TestComputerFindings::aFolderThatCannotBeMadeSaysWhy()
{
    QFETCH(const Kind, kind);
    QFETCH(const bool, mayUse);
    QFETCH(const QString, said);
    FolderFacts facts = folder(kind);
    facts.mayUse = facts.isOwn = mayUse;
    facts.owner = "root";
    const Finding finding = folderIn(facts);
    QCOMPARE(finding.grade, said.isEmpty() ? Grade::Ok : Grade::Problem);
    QVERIFY2(says(finding.found, qPrintable(said)), finding.found.english().c_str());
    QCOMPARE(says(finding.wayOut, "XDG_STATE_HOME"), !said.isEmpty());
}

void TestComputerFindings::aFolderOfRootHasItsCommand()
{
    FolderFacts facts = folder();
    facts.path = facts.nearest = "/home/anna/my state/axiscomp";
    facts.isOwn = facts.mayUse = false;
    facts.owner = "root";
    const Finding finding = folderIn(facts);
    QCOMPARE(finding.grade, Grade::Problem);
    QVERIFY2(says(finding.wayOut, "sudo chown -R $USER /home/anna/my\\ state/axiscomp;"),
        finding.wayOut.english().c_str());
    facts.isOwn = true;
    QVERIFY(says(folderIn(facts).wayOut, "chmod u+rwx "));
    facts.mayUse = true;
    facts.mode = 0777;
    QCOMPARE(folderIn(facts).grade, Grade::Note);
    facts.mode = 0700;
    QCOMPARE(folderIn(facts).grade, Grade::Ok);
    facts.isOwn = false;
    QCOMPARE(folderIn(facts).grade, Grade::Note); // as long as it works, no command
    QVERIFY(folderIn(facts).wayOut.isEmpty());
    facts.isRoot = true; // who may do everything, and leaves what the user may not change
    QCOMPARE(folderIn(facts).grade, Grade::Note);
}

void TestComputerFindings::littleRoomIsANoteAndNoneAProblem()
{
    FolderFacts facts = folder();
    facts.fileSystem->freeBytes = 99'000'000;
    QCOMPARE(folderIn(facts).grade, Grade::Note);
    facts.fileSystem->freeBytes = 9'000'000;
    QCOMPARE(folderIn(facts).grade, Grade::Problem);
    facts.fileSystem->freeBytes = plenty;
    facts.fileSystem->takesFiles = false;
    QCOMPARE(folderIn(facts).grade, Grade::Problem);
    facts.fileSystem->takesFiles = true;
    facts.fileSystem->isReadOnly = true;
    facts.mayUse = false;
    QVERIFY(says(folderIn(facts).found, "read-only"));
}

void TestComputerFindings::theNetworkIsAProblemAndMemoryANote()
{
    FolderFacts facts = folder();
    const auto finding = [&] {
        return named(storeFindings(facts, StoreCondition{}, now), "file system");
    };
    QCOMPARE(finding().grade, Grade::Ok);
    facts.fileSystem->kind = system::FileSystemFacts::Kind::Network;
    QCOMPARE(finding().grade, Grade::Problem);
    QVERIFY(says(finding().wayOut, "XDG_STATE_HOME"));
    facts.fileSystem->kind = system::FileSystemFacts::Kind::Memory;
    QCOMPARE(finding().grade, Grade::Note);
}

void TestComputerFindings::whatTheDatabaseIsDecidesTheGrade_data()
{
    QTest::addColumn<StoreCondition::Database>("database");
    QTest::addColumn<Grade>("grade");
    using Database = StoreCondition::Database;
    QTest::newRow("none") << Database::None << Grade::Ok;
    QTest::newRow("usable") << Database::Usable << Grade::Ok;
    QTest::newRow("older") << Database::Older << Grade::Note;
    QTest::newRow("newer") << Database::Newer << Grade::Problem;
    QTest::newRow("foreign") << Database::Foreign << Grade::Problem;
    QTest::newRow("damaged") << Database::Damaged << Grade::Problem;
    QTest::newRow("busy") << Database::Busy << Grade::Note;
    QTest::newRow("not copied") << Database::NotCopied << Grade::Note;
    QTest::newRow("unreadable") << Database::Unreadable << Grade::Problem;
}

void TestComputerFindings::whatTheDatabaseIsDecidesTheGrade()
{
    QFETCH(const StoreCondition::Database, database);
    QFETCH(const Grade, grade);
    StoreCondition condition;
    condition.database = database;
    condition.reason = Verbatim{"malformed"};
    const FindingSection section = storeFindings(folder(), condition, now);
    QCOMPARE(named(section, "database").grade, grade);
    const bool isKnown = database == StoreCondition::Database::None
        || database == StoreCondition::Database::Usable
        || database == StoreCondition::Database::Older;
    QCOMPARE(named(section, "interrupted writes").grade, isKnown ? Grade::Ok : Grade::Note);
    if (database != StoreCondition::Database::Usable)
        return;
    condition.isWritable = false;
    QCOMPARE(named(storeFindings(folder(), condition, now), "database").grade, Grade::Problem);
    QCOMPARE(named(storeFindings(folder(), std::nullopt, now), "database").grade, Grade::Note);
}

void TestComputerFindings::anInterruptedWriteIsAProblemUnlessItGoesOn()
{
    StoreCondition condition;
    condition.database = StoreCondition::Database::Usable;
    condition.unfinished = {interrupted(false), interrupted(true)};
    const FindingSection section = storeFindings(folder(), condition, now);
    const Finding left = named(section, "interrupted write");
    QCOMPARE(left.grade, Grade::Problem);
    QVERIFY(says(left.found, "axis 2") && says(left.found, "1559") && says(left.found, "upload"));
    QVERIFY(says(left.wayOut, "axiscomp recover --axis 2"));
    QCOMPARE(named(section, "write").grade, Grade::Note);
}

void TestComputerFindings::aDatabaseOfTheFutureTellsOfTheClock()
{
    StoreCondition condition;
    condition.database = StoreCondition::Database::Usable;
    const auto isSaid = [&] {
        return std::ranges::any_of(storeFindings(folder(), condition, now).findings,
            [](const Finding& finding) { return says(finding.found, "the clock was set back"); });
    };
    condition.lastChange = now;
    QVERIFY(!isSaid());
    condition.lastChange = now + std::chrono::days(2);
    QVERIFY(isSaid());
}

void TestComputerFindings::anAdapterWithoutPermissionIsAProblemAndABuiltInPortANote()
{
    const DeviceAccess refused{"/dev/ttyUSB0", noPermission({"dialout"})};
    const FindingSection section = serialFindings({{"/dev/ttyUSB0", "FT232R", "0403:6001", refused},
        {"/dev/ttyS0", "", "", refused}, {"/dev/ttyUSB1", "", "0403:6001", {"/dev/ttyUSB1", {}}}});
    const Finding adapter = named(section, "/dev/ttyUSB0");
    QCOMPARE(adapter.grade, Grade::Problem);
    QVERIFY(says(adapter.found, "FT232R, USB 0403:6001: you have no permission"));
    QVERIFY(says(adapter.wayOut, "sudo usermod -aG dialout $USER"));
    QCOMPARE(named(section, "/dev/ttyS0").grade, Grade::Note);
    QCOMPARE(named(section, "/dev/ttyUSB1").grade, Grade::Ok);
    QCOMPARE(named(serialFindings({}), "ports").grade, Grade::Ok);
}

void TestComputerFindings::theGroupIsJoinedOrTheSessionBegunAnew()
{
    const auto stranger = noPermission({"dialout", false, false});
    QVERIFY(says(stranger.wayOut, "sudo usermod -aG dialout $USER") && stranger.group == "dialout");
    const auto joined = noPermission({"dialout", true, false});
    QVERIFY(says(joined.found, "this session is older") && says(joined.wayOut, "log out"));
    QVERIFY(!says(joined.wayOut, "usermod"));
    QVERIFY(says(noPermission({}).found, "no group has it"));
    QVERIFY(noPermission({}).group.empty());
    QVERIFY(says(noPermission({"dialout", true, true}).wayOut, "administrator"));
}

void TestComputerFindings::aWrongProfileIsNamed()
{
    ConfigurationFacts facts;
    facts.profile = "generic";
    facts.window = {"/home/anna/.config/w.conf", WindowSettings::State::Missing};
    const auto all = [&] { return configurationFindings(facts); };
    QCOMPARE(named(all(), "drive profile").found.english(), "generic, built in");
    QCOMPARE(named(all(), "window settings").grade, Grade::Ok);
    facts.profileError = Error{ErrorCode::InvalidProfile,
        {{"file", Verbatim{"p.json"}}, {"path", Verbatim{"slots"}},
            {"reason", Verbatim{"it is empty"}}},
        {}};
    QCOMPARE(named(all(), "drive profile").grade, Grade::Problem);
    QVERIFY(says(named(all(), "drive profile").found, "p.json is wrong at slots"));
    for (const auto state : {WindowSettings::State::Unreadable, WindowSettings::State::Malformed}) {
        facts.window.state = state;
        QCOMPARE(named(all(), "window settings").grade, Grade::Problem);
    }
}

void TestComputerFindings::whatIsNotInstalledIsNamed()
{
    ProgramFacts facts;
    facts.libraries = {{"zlib", "1.3", "1.2.13"}};
    const FindingSection bare = programFindings(facts);
    QCOMPARE(named(bare, "zlib").found.english(), "1.3, built with 1.2.13");
    for (const char* lacking : {"https", "window", "reports"})
        QVERIFY2(named(bare, lacking).grade == Grade::Note, lacking);
    QVERIFY(says(named(bare, "window").wayOut, "package axis-compensation-wizard"));
    QVERIFY(says(named(bare, "reports").wayOut, "package axiscomp-report-pdf"));
    facts.tls = "OpenSSL 3";
    facts.window = "/usr/bin/axis-compensation-wizard";
    facts.drawsPdf = true;
    for (const Finding& finding : programFindings(facts).findings)
        QVERIFY2(finding.grade == Grade::Ok, finding.name.english().c_str());
}

void TestComputerFindings::realFoldersAreLookedAt()
{
    const QTemporaryDir temporary;
    const std::filesystem::path root(temporary.path().toStdString());
    QCOMPARE(::chmod(root.c_str(), 0750), 0);
    const FolderFacts there = folderFacts(root);
    QVERIFY(there.kind == Kind::Folder && there.mayUse && there.isOwn && !there.othersMayChange());
    QCOMPARE(there.mode, 0750U);
    QVERIFY(there.fileSystem && there.fileSystem->freeBytes > 0);
    const FolderFacts missing = folderFacts(root / "a" / "b");
    QVERIFY(missing.kind == Kind::Missing && missing.nearest == root && missing.mayUse);
    QVERIFY(!std::filesystem::exists(root / "a"));
    QFile file(temporary.filePath(QStringLiteral("file")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    const FolderFacts blocked = folderFacts(root / "file" / "axiscomp");
    QVERIFY(blocked.kind == Kind::Blocked && !blocked.mayUse);
    QCOMPARE(blocked.nearest.string(), (root / "file").string());
}

void TestComputerFindings::sizesAreShort()
{
    const auto text = [](std::uint64_t bytes) { return Argument(byteQuantity(bytes)).english(); };
    QCOMPARE(text(0), "0 B");
    QCOMPARE(text(999), "999 B");
    QCOMPARE(text(1000), "1.0 kB");
    QCOMPARE(text(99'960), "100 kB");
    QCOMPARE(text(999'600), "1.0 MB");
    QCOMPARE(text(3'440'000'000), "3.4 GB");
}

AXISCOMP_TEST(TestComputerFindings)

} // namespace tst_computerfindings

#include "tst_computerfindings.moc"
