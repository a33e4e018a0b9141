// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output/doctor_output.h"
#include "core/store/drive_store.h"
#include "tests/app/program_run.h"
#include "tests/support/file_content.h"
#include "tests/support/raw_responder.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QDir>
#include <QJsonArray>
#include <QSettings>

#include <filesystem>

namespace tst_doctor {

using namespace axiscomp;
using test::contentsBelow;
using test::ProgramRun;
using test::Sandbox;
using test::VirtualDriveProcess;

namespace {

constexpr std::int32_t serial = 1559;
const QString secret = "Xq9-geheim";

struct FoundLine {
    QString grade; ///< "ok", "note", "problem"; empty: there is no such line
    QString found;
    QString wayOut;
};

/// The first of that name.
FoundLine lineOf(const ProgramRun& run, const QString& section, const QString& name)
{
    for (const QJsonValue& value : run.json().value("findings").toArray()) {
        const QJsonObject finding = value.toObject();
        if (finding.value("section").toString() == section
            && finding.value("name").toString() == name)
            return {finding.value("grade").toString(), finding.value("found").toString(),
                finding.value("wayOut").toString()};
    }
    return {};
}

/// The computer on which this test runs may have problems of its own.
bool codeIsThatOfTheProblems(const ProgramRun& run)
{
    const int problems = run.json().value("problems").toInt(-1);
    return problems >= 0 && run.code == (problems > 0 ? 10 : 0);
}

std::filesystem::path stateFolder(const Sandbox& box)
{
    return std::filesystem::path(box.path("state").toStdString()) / "axiscomp";
}

void remember(const Sandbox& box, const QStringList& endpoints)
{
    QSettings settings(
        box.path("config/axiscomp/axis-compensation-wizard.conf"), QSettings::IniFormat);
    settings.setValue("compensationWizard/endpoints", endpoints);
}

} // namespace

/// What is wrong is said with the way out, and nothing is changed by looking.
class TestDoctor final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void whereNothingWasKeptNothingIsMade();
    void aDamagedDatabaseIsNamedAndStays();
    void aFileInPlaceOfTheStateFolderIsAProblem();
    void anInterruptedWriteIsAProblem();
    void aDriveIsAskedAndStaysAsItIs();
    void aDriveThatDoesNotAnswerHoldsUpNothing();
    void theConnectionsOfTheWindowAreAskedToo();
    void aDamagedSettingsFileIsNamed();
    void aWrongAddressAndAWrongProfileAreProblems();
    void noPasswordIsTold();
    void anotherEncodingThanUtf8IsNamed();
    void whatThePersonReadsIsWhatTheProgramReads();
    void theHomeFolderIsNotNamed();
};

void TestDoctor::whereNothingWasKeptNothingIsMade()
{
    const Sandbox box;
    const ProgramRun run = box.run({"doctor", "--json"});
    QVERIFY2(codeIsThatOfTheProblems(run), run.text().constData());
    const FoundLine folder = lineOf(run, "State folder", "folder");
    QVERIFY2(folder.found.contains("the first write makes it"), run.text().constData());
    QCOMPARE(lineOf(run, "State folder", "database").grade, "ok");
    QCOMPARE(lineOf(run, "State folder", "interrupted writes").grade, "ok");
    QCOMPARE(lineOf(run, "Configuration", "window settings").grade, "ok");
    QCOMPARE(lineOf(run, "Drives", "drives").grade, "note");
    QVERIFY(!lineOf(run, "System", "kernel").found.isEmpty());
    QVERIFY(!lineOf(run, "Program", "Qt").found.isEmpty());
    QVERIFY(!QDir(box.path("state")).exists());
    QVERIFY(!QDir(box.path("config")).exists());
}

void TestDoctor::aDamagedDatabaseIsNamedAndStays()
{
    const Sandbox box;
    std::filesystem::create_directories(stateFolder(box));
    box.file("state/axiscomp/axiscomp.db", QByteArray(8192, 'Z'));
    const auto before = contentsBelow(stateFolder(box));
    const VirtualDriveProcess drive(box);
    // Asking a drive opens a store, and so does an https address: not this one.
    const ProgramRun run =
        box.run({"doctor", "--json", "--drive", drive.url(), "--drive", "https://127.0.0.1:1"});
    VERIFY_CODE(run, 10);
    const FoundLine database = lineOf(run, "State folder", "database");
    QCOMPARE(database.grade, "problem");
    QVERIFY2(database.found.contains("damaged"), run.text().constData());
    QVERIFY2(database.wayOut.contains("--reset-flash-count"), run.text().constData());
    QCOMPARE(run.json().value("store").toObject().value("database").toString(), "Damaged");
    QVERIFY(contentsBelow(stateFolder(box)) == before);
}

void TestDoctor::aFileInPlaceOfTheStateFolderIsAProblem()
{
    Sandbox box;
    box.setVariable("XDG_STATE_HOME", box.file("file", "x"));
    const ProgramRun run = box.run({"doctor", "--json"});
    VERIFY_CODE(run, 10);
    const FoundLine folder = lineOf(run, "State folder", "folder");
    QCOMPARE(folder.grade, "problem");
    QVERIFY2(folder.found.contains("file is no folder"), run.text().constData());
    QVERIFY2(folder.wayOut.contains("XDG_STATE_HOME"), run.text().constData());
    QCOMPARE(box.content("file"), "x");
}

void TestDoctor::anInterruptedWriteIsAProblem()
{
    const Sandbox box;
    DriveStore store(stateFolder(box));
    JournalEntry entry;
    entry.serialNumber = serial;
    entry.axis = 1;
    entry.step = "upload";
    VERIFY_RESULT(store.openJournal(entry));
    {
        const auto writing = store.lockWrites(serial);
        VERIFY_RESULT(writing);
        const ProgramRun run = box.run({"doctor", "--json"});
        QCOMPARE(lineOf(run, "State folder", "write").grade, "note");
    }
    const ProgramRun run = box.run({"doctor", "--json"});
    VERIFY_CODE(run, 10);
    const FoundLine left = lineOf(run, "State folder", "interrupted write");
    QCOMPARE(left.grade, "problem");
    QVERIFY2(left.wayOut.contains("axiscomp recover --axis 1"), run.text().constData());
    VERIFY_RESULT(store.closeJournal(serial, 1));
    QCOMPARE(
        lineOf(box.run({"doctor", "--json"}), "State folder", "interrupted writes").grade, "ok");
}

void TestDoctor::aDriveIsAskedAndStaysAsItIs()
{
    const Sandbox box;
    const VirtualDriveProcess drive(box, {"--state", box.path("drive")});
    VERIFY_CODE(box.run({"example", "--dims", "1", "-o", "x.csv"}), 0);
    VERIFY_CODE(
        box.run({"write", "--drive", drive.url(), "--axis", "0", "--data", "x.csv", "--dims", "1",
            "--table", "1", "--source1", test::positionSource(0), "--persistent"}),
        0);
    const auto kept = contentsBelow(stateFolder(box));
    const auto flash = contentsBelow(box.path("drive").toStdString());
    QVERIFY(!kept.empty() && !flash.empty());
    const ProgramRun run = box.run({"doctor", "--json", "--drive", drive.url()});
    QVERIFY2(codeIsThatOfTheProblems(run), run.text().constData());
    const FoundLine line = lineOf(run, "Drives", drive.url());
    QCOMPARE(line.grade, "ok");
    QVERIFY2(
        line.found.startsWith(drive.names().front() + ", serial number "), run.text().constData());
    QVERIFY2(lineOf(run, "Drives", "axis 0 (X)").found.contains("table "), run.text().constData());
    QCOMPARE(lineOf(run, "State folder", "database").grade, "ok");
    const QJsonObject answer = run.json().value("drives").toArray().first().toObject();
    QCOMPARE(answer.value("profile").toString(), "generic");
    QCOMPARE(answer.value("axes").toArray().size(), 2);
    QVERIFY(answer.value("error").isNull());
    QVERIFY(contentsBelow(stateFolder(box)) == kept);
    QVERIFY(contentsBelow(box.path("drive").toStdString()) == flash);
}

void TestDoctor::aDriveThatDoesNotAnswerHoldsUpNothing()
{
    const Sandbox box;
    const VirtualDriveProcess drive(box);
    const test::RawResponder silent(test::neverAnswer);
    const QString silentUrl = QString::fromStdString(silent.url());
    const ProgramRun run = box.run({"doctor", "--json", "--timeout", "0.5", "--drive", silentUrl,
        "--drive", "http://127.0.0.1:1", "--drive", "serial:/dev/no-such-port"});
    VERIFY_CODE(run, 10);
    const FoundLine late = lineOf(run, "Drives", silentUrl);
    QCOMPARE(late.grade, "problem");
    QVERIFY2(late.found.contains("did not answer within 0.5 s"), run.text().constData());
    QVERIFY2(late.wayOut.contains("power, cable and network"), run.text().constData());
    QCOMPARE(lineOf(run, "Drives", "http://127.0.0.1:1").grade, "problem");
    QVERIFY2(lineOf(run, "Drives", "serial:/dev/no-such-port").found.contains("no such port"),
        run.text().constData());
    QCOMPARE(run.json().value("drives").toArray().size(), 3);
    // Another one is asked all the same, at the same time.
    const ProgramRun both =
        box.run({"doctor", "--json", "--drive", "http://127.0.0.1:1", "--drive", drive.url()});
    QCOMPARE(lineOf(both, "Drives", drive.url()).grade, "ok");
}

void TestDoctor::theConnectionsOfTheWindowAreAskedToo()
{
    const Sandbox box;
    const VirtualDriveProcess first(box);
    const VirtualDriveProcess second(box);
    remember(box, {first.url(), second.url()});
    const ProgramRun run = box.run({"doctor", "--json", "--drive", second.url()});
    QCOMPARE(run.json().value("drives").toArray().size(), 2); // the second one once
    QCOMPARE(lineOf(run, "Drives", first.url()).grade, "ok");
    QCOMPARE(lineOf(run, "Drives", second.url()).grade, "ok");
    QVERIFY(lineOf(run, "Configuration", "window settings").found.endsWith("connections: 2"));
}

void TestDoctor::aDamagedSettingsFileIsNamed()
{
    const Sandbox box;
    QVERIFY(QDir(box.path()).mkpath("config/axiscomp"));
    box.file("config/axiscomp/axis-compensation-wizard.conf", "[compensationWizard\nendpoints");
    const ProgramRun run = box.run({"doctor", "--json"});
    VERIFY_CODE(run, 10);
    QCOMPARE(lineOf(run, "Configuration", "window settings").grade, "problem");
}

void TestDoctor::aWrongAddressAndAWrongProfileAreProblems()
{
    const Sandbox box;
    const ProgramRun address = box.run({"doctor", "--json", "--drive", "ftp://drive"});
    VERIFY_CODE(address, 10);
    QVERIFY2(lineOf(address, "Drives", "address").found.contains("is not the address of a drive"),
        address.text().constData());
    const ProgramRun profile = box.run(
        {"doctor", "--json", "--drive", "demo:", "--profile", box.file("profile.json", "{}")});
    VERIFY_CODE(profile, 10);
    QCOMPARE(lineOf(profile, "Configuration", "drive profile").grade, "problem");
    QCOMPARE(lineOf(profile, "Drives", "demo:").grade, "problem");
    QCOMPARE(
        lineOf(box.run({"doctor", "--json", "--drive", "demo:"}), "Drives", "demo:").grade, "ok");
}

void TestDoctor::noPasswordIsTold()
{
    Sandbox box;
    const VirtualDriveProcess drive(box);
    const QString withPassword =
        QString(drive.url()).replace("http://", "http://anna:" + secret + "@");
    for (const char* name : {"http_proxy", "HTTPS_PROXY"})
        box.setVariable(name, "http://anna:" + secret + "@proxy:3128");
    box.setVariable("AXISCOMP_DRIVE", withPassword);
    remember(box, {"http://anna:" + secret + "@127.0.0.1:1", "ftp://anna:" + secret + "@drive"});
    for (const QStringList& form : {QStringList{"doctor"}, QStringList{"doctor", "--json"}}) {
        const ProgramRun run = box.run(form);
        VERIFY_CODE(run, 10);
        QVERIFY2(!(run.out + run.err).contains(secret.toUtf8()), run.text().constData());
        QVERIFY2(run.out.contains("http_proxy") && run.out.contains("HTTPS_PROXY"),
            run.text().constData());
        QVERIFY2(run.out.contains(drive.url().toUtf8()), run.text().constData());
        QVERIFY2(!run.out.contains("anna"), run.text().constData());
    }
}

void TestDoctor::anotherEncodingThanUtf8IsNamed()
{
    Sandbox box;
    box.setVariable("LC_ALL", "C.UTF-8");
    QCOMPARE(lineOf(box.run({"doctor", "--json"}), "Language", "locale").grade, "ok");
    box.setVariable("LC_ALL", "C");
    const ProgramRun ascii = box.run({"doctor", "--json"});
    QVERIFY2(codeIsThatOfTheProblems(ascii), ascii.text().constData());
    QCOMPARE(lineOf(ascii, "Language", "locale").grade, "note");
    QVERIFY(lineOf(ascii, "Language", "locale").found.contains("LC_ALL=C"));
    QVERIFY(!ascii.json().value("language").toObject().value("utf8").toBool(true));
    box.setVariable("LC_ALL", "xx_XX.UTF-8");
    const FoundLine missing = lineOf(box.run({"doctor", "--json"}), "Language", "locale");
    QVERIFY2(missing.found.contains("not installed"), qPrintable(missing.found));
}

void TestDoctor::whatThePersonReadsIsWhatTheProgramReads()
{
    Sandbox box;
    box.setVariable("LC_ALL", "C.UTF-8"); // Qt warns of others
    const QStringList drive{"--drive", "http://127.0.0.1:1"};
    const ProgramRun json = box.run(QStringList{"doctor", "--json"} + drive);
    const ProgramRun text = box.run(QStringList{"doctor"} + drive);
    VERIFY_CODE(text, 10);
    QCOMPARE(json.code, text.code);
    const QJsonArray findings = json.json().value("findings").toArray();
    int problems = 0;
    qsizetype lines = 0;
    for (const QByteArray& line : text.out.split('\n')) {
        const QByteArray grade = line.trimmed().split(' ').first();
        const bool isFinding =
            line.startsWith("  ") && (grade == "ok" || grade == "note" || grade == "problem");
        lines += isFinding ? 1 : 0;
        problems += isFinding && grade == "problem" ? 1 : 0;
    }
    QCOMPARE(lines, findings.size());
    QCOMPARE(problems, json.json().value("problems").toInt());
    const QString summary = QStringLiteral("%1 problem").arg(problems);
    QVERIFY2(text.out.contains(summary.toUtf8()), text.text().constData());
    QCOMPARE(text.err, "");
}

void TestDoctor::theHomeFolderIsNotNamed()
{
    using app::withoutSecrets;
    QCOMPARE(withoutSecrets("/home/anna/.local is there", "/home/anna"), "~/.local is there");
    QCOMPARE(withoutSecrets("in /home/anna: 3", "/home/anna/"), "in ~: 3");
    QCOMPARE(withoutSecrets("/home/annabel and /mnt/home/anna", "/home/anna"),
        "/home/annabel and /mnt/home/anna");
    QCOMPARE(withoutSecrets("/x", ""), "/x");
    QCOMPARE(withoutSecrets("/x", "/"), "/x");
    QCOMPARE(withoutSecrets("a\nhttp://u:p@host", ""), "a http://host");
    QCOMPARE(withoutSecrets("DISPLAY=http://u:it's@host and http://u:a\"b@host", ""),
        "DISPLAY=http://host and http://host");
    Sandbox box;
    box.setVariable("HOME", box.path());
    const ProgramRun run = box.run({"doctor", "--json"});
    QVERIFY2(!run.out.contains(box.path().toUtf8()), run.text().constData());
    QVERIFY2(lineOf(run, "State folder", "folder").found.startsWith("~/state/axiscomp"),
        run.text().constData());
}

AXISCOMP_TEST(TestDoctor)

} // namespace tst_doctor

#include "tst_doctor.moc"
