// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program_run.h"

#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QJsonArray>
#include <QTest>
#include <QUrl>

namespace tst_wholestory {

using namespace axiscomp;
using test::ProgramRun;
using test::Sandbox;
using test::VirtualDriveProcess;

/// The main job from end to end, with nothing but the programs, curl and an independent reader.
class tst_WholeStory : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void fromACsvFileToAnActiveCompensationThatSurvivesAReboot()
    {
        Sandbox box;
        const VirtualDriveProcess drive(box, {"--http", "127.0.0.1:0", "--axes", "2"});
        QVERIFY(drive.isReady());
        box.setVariable("AXISCOMP_DRIVE", drive.url());

        VERIFY_CODE(box.run({"example", "--dims", "2", "-o", "e.csv"}), 0);
        const ProgramRun written = box.run(
            {"write", "--axis", "0", "--data", "e.csv", "--dims", "2", "--table", "2", "--source1",
                test::positionSource(0), "--source2", test::positionSource(1), "--persistent"});
        VERIFY_CODE(written, 0);
        const ProgramRun activated = box.run({"activate", "--axis", "0"});
        VERIFY_CODE(activated, 0);
        QVERIFY2(activated.out.contains("is Active."), activated.out.constData());
        QVERIFY2(activated.out.contains("Proof: "), activated.out.constData());

        const ProgramRun status = box.run({"status", "--axis", "0", "--json"});
        VERIFY_CODE(status, 0);
        QCOMPARE(status.json().value("state").toString(), "Active");
        QCOMPARE(status.json().value("persistent").toBool(), true);
        checkTableFile(box, drive.url(), status.json());
        if (QTest::currentTestFailed())
            return;

        reboot(box, drive.url());
        if (QTest::currentTestFailed())
            return;
        const ProgramRun again = box.run({"status", "--axis", "0", "--json"});
        VERIFY_CODE(again, 0);
        QCOMPARE(again.json().value("table"), status.json().value("table"));
        QCOMPARE(again.json().value("slot"), status.json().value("slot"));
        QCOMPARE(again.json().value("sources"), status.json().value("sources"));
        QCOMPARE(again.json().value("persistent").toBool(), true);
        QCOMPARE(again.json().value("activation").toString(), "Disabled");
        QCOMPARE(again.json().value("state").toString(), "Disabled");
        QCOMPARE(again.json().value("output").toDouble(-1.0), 0.0);
    }

    void theTourRunsWithoutATerminal()
    {
        const Sandbox box;
        // It measures a machine twice: a minute and a half of a quiet computer.
        const ProgramRun run = box.runProgram("/bin/bash",
            {AXISCOMP_SOURCE_FOLDER "/app/cli/tour.sh", AXISCOMP_PROGRAM_FOLDER}, {},
            10 * test::patienceMs);
        VERIFY_CODE(run, 0);
        QVERIFY2(run.out.contains("$ axiscomp write"), run.out.constData());
        const qsizetype proof = run.out.lastIndexOf("Proof: what the drive adds");
        QVERIFY2(proof > 0, run.out.constData());
        QVERIFY2(run.out.indexOf("is Active.") < proof, run.out.constData());
        const qsizetype step = run.out.indexOf("8. The table of the record");
        const QByteArray fitted = run.out.mid(step, run.out.indexOf("9. Measured again") - step);
        QVERIFY2(fitted.contains("Proof: what the drive adds"), fitted.constData());
        QVERIFY2(!fitted.contains("Not proved"), fitted.constData());
        QVERIFY2(run.out.contains("\nAs predicted: M is"), run.out.constData());
        QVERIFY2(run.out.contains("um after (tolerance 5.000 um: passed)"), run.out.constData());
        // Who follows the guide types what is shown to work here.
        for (const QByteArray& command : commandsOf("/docs/laser-to-drive.md"))
            QVERIFY2(run.out.contains("$ " + command + '\n'), command.constData());
    }

    void theTourFailsWhenAProgramDoes()
    {
        const Sandbox box;
        const ProgramRun run =
            box.runProgram("/bin/bash", {AXISCOMP_SOURCE_FOLDER "/app/cli/tour.sh", box.path()});
        QVERIFY(run.code != 0);
    }

private:
    /// Those of the programs in a document, each in one line; the tour takes any free port.
    static QByteArrayList commandsOf(const char* document)
    {
        QFile file(QStringLiteral(AXISCOMP_SOURCE_FOLDER) + document);
        if (!file.open(QIODevice::ReadOnly))
            return {"the document"};
        QByteArrayList commands;
        const QByteArray text =
            file.readAll().replace("\\\n", " ").replace("127.0.0.1:8080 &", "127.0.0.1:0");
        for (const QByteArray& line : text.split('\n'))
            if (line.startsWith("    axiscomp"))
                commands += line.simplified();
        return commands.size() > 8 ? commands : QByteArrayList{"more than eight commands"};
    }

    /// The drive's file, fetched by curl and decoded by a reader that shares no code with us.
    void checkTableFile(const Sandbox& box, const QString& url, const QJsonObject& status)
    {
        VERIFY_CODE(
            box.runProgram("curl",
                {"--silent", "--fail", "-o", "t.TAMtbl", url + "/files/tables/small1.TAMtbl"}),
            0);
        const ProgramRun decoded = box.runProgram(
            "python3", {AXISCOMP_SOURCE_FOLDER "/tests/tools/decode_tamtbl.py", "t.TAMtbl"});
        VERIFY_CODE(decoded, 0);
        const QJsonObject file = decoded.json();
        const QJsonObject table = status.value("table").toObject();
        QCOMPARE(file.value("name").toString(), "Table 2");
        QCOMPARE(file.value("persistent").toBool(), true);
        QCOMPARE(file.value("crc").toString().toUInt(nullptr, 16),
            static_cast<unsigned>(table.value("crc").toInteger()));
        QCOMPARE(file.value("elements"), table.value("elements"));
        for (int n = 0; n < 2; ++n) {
            const QJsonObject inFile = file.value("axes").toArray().at(n).toObject();
            const QJsonObject onDrive = table.value("axes").toArray().at(n).toObject();
            for (const char* const key : {"size", "start", "distance"})
                QCOMPARE(inFile.value(key), onDrive.value(key));
        }
        checkValues(box, file.value("values").toArray());
    }

    /// The lines of the example are in table order: dimension 1 fastest.
    void checkValues(const Sandbox& box, const QJsonArray& values)
    {
        int element = 0;
        bool isHeader = true;
        for (const QByteArray& line : box.content("e.csv").trimmed().split('\n')) {
            if (line.startsWith("//"))
                continue;
            if (!std::exchange(isHeader, false)) {
                const double expected = line.trimmed().split(',').at(3).toDouble();
                QCOMPARE(values.at(element).toDouble(),
                    static_cast<double>(static_cast<float>(expected)));
                ++element;
            }
        }
        QCOMPARE(element, values.size());
    }

    void reboot(const Sandbox& box, const QString& url)
    {
        const ProgramRun run = box.runProgram("curl",
            {"--silent", "--fail", "-X", "PUT", "-H", "Content-Type: application/json", "-d",
                R"({"value": "Reboot"})", url + "/registers/General/Commands/Reboot"});
        VERIFY_CODE(run, 0);
    }
};

AXISCOMP_TEST(tst_WholeStory)

} // namespace tst_wholestory

#include "tst_wholestory.moc"
