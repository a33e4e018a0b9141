// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program_run.h"

#include "tests/support/patience.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QJsonObject>
#include <QTest>
#include <QUrl>

#include <cmath>
#include <csignal>

namespace tst_capturecommand {

using namespace axiscomp;
using test::ProgramRun;
using test::Sandbox;
using test::VirtualDriveProcess;

namespace {

/// A straight error, so that every deviation is known: 12 um/m.
const QByteArray straight = R"({"axes": {"X": {"slope": 12e-6}, "Y": {}},
    "instrument": {"axis": "X", "zero": 17.3}})";
const QString referenceRegister = QStringLiteral("Machine/Axes[0]/ReferencePosition");
constexpr int steps = 4;

/// axiscomp capture, while it runs.
class RunningCapture {
public:
    explicit RunningCapture(std::unique_ptr<QProcess> process) : m_process(std::move(process)) { }

    /// Whether it has said this by now or says it before it ends; each on its own channel.
    [[nodiscard]] bool says(const QByteArray& words)
    {
        return waitFor(words, QProcess::StandardOutput, out);
    }
    [[nodiscard]] bool warns(const QByteArray& words)
    {
        return waitFor(words, QProcess::StandardError, err);
    }
    [[nodiscard]] ProgramRun end()
    {
        if (m_process->state() != QProcess::NotRunning
            && !m_process->waitForFinished(test::patienceMs))
            return {-1, out, err};
        out += m_process->readAllStandardOutput();
        err += m_process->readAllStandardError();
        const int code = m_process->exitCode();
        return {m_process->exitStatus() == QProcess::NormalExit ? code : 128 + code, out, err};
    }
    void send(int signal)
    {
        if (const qint64 id = m_process->processId(); id > 0)
            ::kill(static_cast<pid_t>(id), signal);
    }
    void type(const QByteArray& line) { m_process->write(line + "\n"); }

    QByteArray out;
    QByteArray err;

private:
    [[nodiscard]] bool waitFor(
        const QByteArray& words, QProcess::ProcessChannel channel, QByteArray& said)
    {
        m_process->setReadChannel(channel);
        while (!said.contains(words)) {
            if (m_process->bytesAvailable() == 0 && !m_process->waitForReadyRead(test::patienceMs))
                return false;
            said += m_process->readAll();
        }
        return true;
    }

    std::unique_ptr<QProcess> m_process;
};

/// A plan over two targets, and a machine that plays it so fast that a reading that comes late
/// misses neither a target nor a turn. The machine waits until it is told to play.
struct CaptureFixture {
    static constexpr int speed = 6;
    /// dwell: at each target, in s
    explicit CaptureFixture(double dwell = 1.2)
    {
        box.file("machine.json", straight);
        const ProgramRun made = box.run({"targets", "--from", "0", "--to", "30", "--count", "2",
            "--cycles", "1", "--overrun", "10", "--feed", "400", "--dwell",
            QString::number(speed * dwell), "-o", "plan.csv"});
        if (made.code != 0)
            qWarning("%s", made.text().constData());
    }
    void startMachine(const QStringList& more = {})
    {
        machine.reset();
        machine = std::make_unique<VirtualDriveProcess>(box,
            QStringList{"--machine", "machine.json", "--program", "plan.csv", "--program-after",
                "86400", "--instrument", box.path("laser"), "--speed", QString::number(speed)}
                + more);
    }
    /// From the beginning of the program, once the capture reads.
    [[nodiscard]] bool play(RunningCapture& capture) const
    {
        return capture.says("the program moves no axis")
            && machine->writeRegister("Machine/Program/Command", "Start");
    }
    [[nodiscard]] RunningCapture start(const QStringList& words) const
    {
        return RunningCapture(box.start(test::axiscompProgram(), words));
    }
    /// script: of bash, with %1 for the command, which takes lines from standard input.
    [[nodiscard]] RunningCapture startInShell(const QString& script) const
    {
        QString command = "'" + test::axiscompProgram() + "'";
        for (const QString& word : words("-"))
            command += " '" + word + "'";
        return RunningCapture(box.start("/bin/bash", {"-c", script.arg(command)}));
    }
    /// Of the whole program.
    [[nodiscard]] ProgramRun run(RunningCapture capture) const
    {
        return play(capture) ? capture.end() : ProgramRun{-1, capture.out, capture.err};
    }
    [[nodiscard]] QStringList words(
        const QString& reference = referenceRegister, const QStringList& more = {}) const
    {
        return QStringList{"capture", "--drive", machine->url(), "--axis", "X", "--plan",
                   "plan.csv", "--reference", reference, "-o", "runs.csv", "--dwell", "0.4",
                   "--average", "3", "--rate", "50", "--zero-at", "-17.3"}
        + more;
    }
    /// Lines of values in the file.
    [[nodiscard]] long taken() const
    {
        const QByteArray text = box.content("runs.csv");
        const qsizetype columns = text.indexOf("\ntarget [mm],");
        return columns < 0 ? 0 : text.mid(columns + 1).count('\n') - 1;
    }

    Sandbox box;
    std::unique_ptr<VirtualDriveProcess> machine;
};

/// Every value of the plan once, and right.
void verifyRuns(const Sandbox& box, double tolerance)
{
    const ProgramRun read = box.run({"runs", "runs.csv", "--json"});
    VERIFY_CODE(read, 0);
    QCOMPARE(read.json().value("values").toInt(), steps);
    const QByteArray text = box.content("runs.csv");
    const QByteArrayList lines =
        text.mid(text.indexOf("\ntarget [mm],") + 1).trimmed().split('\n').mid(1);
    QCOMPARE(lines.size(), steps);
    for (const QByteArray& line : lines) {
        const QByteArrayList cells = line.split(',');
        QVERIFY2(std::abs(cells.at(3).toDouble() - 12e-6 * cells.at(0).toDouble()) < tolerance,
            line.constData());
    }
}

} // namespace

class tst_CaptureCommand : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aProgramIsCapturedByARegister()
    {
        CaptureFixture fixture;
        fixture.startMachine();
        const ProgramRun run = fixture.run(fixture.start(fixture.words()));
        VERIFY_CODE(run, 0);
        QVERIFY2(run.out.contains("1/4  0.000 mm up, run 1: "), run.out.constData());
        QVERIFY2(run.out.endsWith("4 of 4 values in runs.csv\n"), run.out.constData());
        QVERIFY2(!run.err.contains("error"), run.err.constData());
        verifyRuns(fixture.box, 2e-6);
        const QByteArray file = fixture.box.content("runs.csv");
        QVERIFY(file.contains("\n// compensation: off\n"));
        QVERIFY(file.contains("\n// reference: Machine/Axes[0]/ReferencePosition, 0 at -17.3\n"));
        QVERIFY(file.contains("\n// encoder: Axes[0]/Signals/PositionController/MasterPosition\n"));
        // All of it is there: nothing is taken twice, and the machine may be anywhere.
        const ProgramRun again = fixture.box.run(fixture.words() + QStringList{"--json"});
        VERIFY_CODE(again, 0);
        QCOMPARE(again.json().keys(),
            (QStringList{"axis", "before", "compensation", "output", "reference", "steps", "taken",
                "unit"}));
        QCOMPARE(again.json().value("before").toInt(), steps);
        QCOMPARE(again.json().value("taken").toInt(), steps);
        QCOMPARE(fixture.box.content("runs.csv"), file);
    }

    void aKillAtEveryLineTakesNothingTwiceAndLosesNothing()
    {
        CaptureFixture fixture;
        for (int line = 1; line <= steps; ++line) {
            fixture.startMachine();
            RunningCapture capture = fixture.start(fixture.words());
            QVERIFY(fixture.play(capture));
            QVERIFY2(capture.says(QByteArray::number(line) + "/4  "), capture.out.constData());
            capture.send(SIGKILL);
            const ProgramRun killed = capture.end(); // with its last value it ends by itself
            QVERIFY2(killed.code == 128 + SIGKILL || line == steps, killed.text().constData());
            QCOMPARE(fixture.taken(), static_cast<long>(line));
            QCOMPARE(fixture.box.content("runs.csv").back(), '\n');
        }
        VERIFY_CODE(fixture.box.run(fixture.words()), 0);
        verifyRuns(fixture.box, 2e-6);
    }

    void anInterruptLeavesAWholeFileThatGoesOn()
    {
        CaptureFixture fixture;
        fixture.startMachine();
        RunningCapture capture = fixture.start(fixture.words());
        QVERIFY(fixture.play(capture));
        QVERIFY2(capture.says("2/4  "), capture.out.constData());
        capture.send(SIGINT);
        const ProgramRun interrupted = capture.end();
        VERIFY_CODE(interrupted, 130);
        QVERIFY2(interrupted.err.contains(
                     "2 of 4 values in runs.csv; the same command goes on behind them"),
            interrupted.err.constData());
        QCOMPARE(fixture.taken(), 2L);
        fixture.startMachine();
        const ProgramRun rest = fixture.run(fixture.start(fixture.words()));
        VERIFY_CODE(rest, 0);
        QVERIFY2(rest.out.contains("2 of 4 values taken"), rest.out.constData());
        QVERIFY2(!rest.out.contains("\n2/4  "), rest.out.constData());
        verifyRuns(fixture.box, 2e-6);
    }

    void aDriveThatGoesAwayIsWaitedFor()
    {
        CaptureFixture fixture;
        fixture.startMachine();
        const QString address = QUrl(fixture.machine->url()).authority();
        RunningCapture capture = fixture.start(fixture.words());
        QVERIFY(fixture.play(capture));
        QVERIFY2(capture.says("1/4  "), capture.out.constData());
        fixture.machine.reset();
        QVERIFY2(capture.warns("waiting for it, Ctrl-C ends"), capture.err.constData());
        fixture.startMachine({"--http", address});
        QVERIFY(fixture.machine->isReady());
        QVERIFY2(capture.warns("the drive answers again"), capture.err.constData());
        QVERIFY(fixture.play(capture));
        VERIFY_CODE(capture.end(), 0);
        QCOMPARE(capture.err.count("waiting for it"), 1);
        verifyRuns(fixture.box, 2e-6);
    }

    void linesOfAnotherProgramAreTakenThroughAPipe()
    {
        CaptureFixture fixture;
        fixture.startMachine();
        const ProgramRun run = fixture.run(fixture.startInShell("cat laser | %1"));
        VERIFY_CODE(run, 0);
        verifyRuns(fixture.box, 2e-6);
        QVERIFY(
            fixture.box.content("runs.csv").contains("// reference: standard input, 0 at -17.3\n"));
    }

    void aProgramThatWritesWithoutAPauseDoesNotKeepTheDriveFromBeingRead()
    {
        CaptureFixture fixture;
        fixture.startMachine();
        RunningCapture capture = fixture.startInShell("exec %1 < <(yes '17.3 mm')");
        QVERIFY(fixture.play(capture));
        QVERIFY2(capture.says("1/4  0.000 mm up"), capture.err.constData());
        capture.send(SIGINT);
        VERIFY_CODE(capture.end(), 130);
        QCOMPARE(fixture.taken(), 1L);
    }

    void anInstrumentOnASerialPortIsRead_data()
    {
        QTest::addColumn<QStringList>("more");
        QTest::newRow("by itself") << QStringList{};
        QTest::newRow("asked, with a pattern")
            << QStringList{"--request", "R\\r\\n", "--pattern", "[+-]([0-9.]+) mm", "--unit", "mm"};
    }
    void anInstrumentOnASerialPortIsRead()
    {
        QFETCH(const QStringList, more);
        CaptureFixture fixture;
        fixture.startMachine();
        const QString laser = "serial:" + fixture.box.path("laser") + "?baud=9600";
        const ProgramRun run = fixture.run(fixture.start(fixture.words(laser, more)));
        VERIFY_CODE(run, 0);
        verifyRuns(fixture.box, 2e-6);
    }

    void whatIsTypedIsAskedForAtEachTarget()
    {
        CaptureFixture fixture(4.0);
        fixture.startMachine();
        RunningCapture capture = fixture.start(fixture.words("typed"));
        QVERIFY(fixture.play(capture));
        const QByteArray plan = fixture.box.content("plan.csv");
        int step = 0;
        qsizetype doubts = 0;
        for (const QByteArray& line : plan.mid(plan.indexOf("\n1,1,+") + 1).trimmed().split('\n')) {
            const QByteArrayList cells = line.split(',');
            const QByteArray direction = cells.at(2) == "+" ? "up" : "down";
            const QByteArray question =
                cells.at(3) + " mm " + direction + ": what does the instrument say, in mm?";
            QVERIFY2(capture.warns(question), capture.err.constData());
            const double target = cells.at(3).toDouble();
            if (++step == 2) { // a slip of the pen, and what it should have been
                capture.type(QByteArray::number(target + 5.0 + 17.3, 'f', 5));
                QVERIFY2(capture.warns("type it once more"), capture.err.constData());
            }
            doubts += capture.err.count("type it once more");
            capture.err.clear();
            capture.type(QByteArray::number(target * (1 + 12e-6) + 17.3, 'f', 5));
        }
        VERIFY_CODE(capture.end(), 0);
        QCOMPARE(doubts, 1);
        verifyRuns(fixture.box, 6e-6);
    }

    void standardInputThatEndsIsSaid()
    {
        CaptureFixture fixture;
        fixture.startMachine();
        const ProgramRun run = fixture.box.run(fixture.words("-"), "0.0 mm\n");
        VERIFY_CODE(run, 3);
        QVERIFY2(run.err.contains("error: FileNotReadable: standard input cannot be read: it has "
                                  "ended"),
            run.err.constData());
        QVERIFY2(run.err.contains("0 of 4 values in runs.csv"), run.err.constData());
    }

    void anInstrumentThatIsWrongIsSaidWithTheWayOut_data()
    {
        QTest::addColumn<QByteArray>("machine");
        QTest::addColumn<QStringList>("more");
        QTest::addColumn<QByteArray>("said");
        QTest::addColumn<int>("taken");
        const QByteArray begin = R"({"axes": {"X": {"slope": 12e-6}}, "instrument": )";
        QTest::newRow("wrong sign")
            << begin + R"({"zero": 17.3, "sign": -1}})" << QStringList{}
            << QByteArray("begin a new file with the reference inverted") << 1;
        QTest::newRow("another unit")
            << begin + R"({"unit": "inch"}})" << QStringList{"--unit", "mm"}
            << QByteArray("in another unit than mm") << 0;
        QTest::newRow("nonsense") << begin + "{}}" << QStringList{"--pattern", "Laser (.*)"}
                                  << QByteArray("where a number is expected") << 0;
    }
    void anInstrumentThatIsWrongIsSaidWithTheWayOut()
    {
        QFETCH(const QByteArray, machine);
        QFETCH(const QStringList, more);
        QFETCH(const QByteArray, said);
        QFETCH(const int, taken);
        CaptureFixture fixture;
        fixture.box.file("machine.json", machine);
        fixture.startMachine();
        RunningCapture capture =
            fixture.start(fixture.words("serial:" + fixture.box.path("laser"), more));
        QVERIFY(fixture.play(capture));
        QVERIFY2(capture.warns(said), capture.err.constData());
        capture.send(SIGTERM);
        VERIFY_CODE(capture.end(), 130);
        QCOMPARE(fixture.taken(), static_cast<long>(taken));
    }

    void anInstrumentThatIsZeroElsewhereIsSaidAtTheFirstValue()
    {
        CaptureFixture fixture;
        fixture.startMachine();
        QStringList words = fixture.words();
        words[words.indexOf("--zero-at") + 1] = "0";
        RunningCapture capture = fixture.start(words);
        QVERIFY(fixture.play(capture));
        QVERIFY2(capture.warns("if that is right, begin a new file with --zero-at -17.300"),
            capture.err.constData());
        capture.send(SIGTERM);
        VERIFY_CODE(capture.end(), 130);
    }

    void whatCannotBeCapturedIsRefused_data()
    {
        QTest::addColumn<QStringList>("changed"); // option and value
        QTest::addColumn<int>("code");
        QTest::addColumn<QByteArray>("said");
        QTest::newRow("plan of another axis") << QStringList{
            "--axis", "Y"} << 2 << QByteArray("the plan is for axis X, and this is axis Y");
        QTest::newRow("no plan") << QStringList{"--plan", "machine.json"} << 3
                                 << QByteArray("machine.json cannot be read: line 1");
        QTest::newRow("no such register")
            << QStringList{"--reference", "Machine/Axes[0]/ReferencePositon"} << 2
            << QByteArray("; the nearest are ");
        QTest::newRow("the encoder itself")
            << QStringList{"--reference", "Axes[0]/Signals/PositionController/MasterPosition"} << 2
            << QByteArray("follows the encoder of the axis itself");
        QTest::newRow("an encoder behind the compensation")
            << QStringList{"--encoder", "Axes[0]/Signals/PathPlanner/Position"} << 2
            << QByteArray("is no position of axis X before its compensation");
        QTest::newRow("the encoder of the other axis")
            << QStringList{"--encoder", "Axes[1]/Signals/PositionController/MasterPosition"} << 2
            << QByteArray("is no position of axis X before its compensation");
        QTest::newRow("no such port") << QStringList{"--reference", "serial:/dev/no-such-port"} << 5
                                      << QByteArray("there is no such port");
        QTest::newRow("standard output")
            << QStringList{"-o", "-"} << 2 << QByteArray("name it with -o");
        QTest::newRow("another file") << QStringList{"-o", "plan.csv"} << 3
                                      << QByteArray("something else than captured values");
        QTest::newRow("pattern") << QStringList{"--pattern", "x"} << 2
                                 << QByteArray("--pattern is for lines of text");
        QTest::newRow("request") << QStringList{"--request", "x"} << 2
                                 << QByteArray("--request is for an instrument on a serial port");
        QTest::newRow("rate") << QStringList{"--rate", "51"} << 2 << QByteArray("--rate");
        QTest::newRow("unit") << QStringList{"--unit", "deg"} << 2
                              << QByteArray("the instrument is in deg");
    }
    void whatCannotBeCapturedIsRefused()
    {
        QFETCH(const QStringList, changed);
        QFETCH(const int, code);
        QFETCH(const QByteArray, said);
        CaptureFixture fixture;
        fixture.startMachine();
        QStringList words = fixture.words();
        const qsizetype place = words.indexOf(changed.at(0));
        if (place < 0)
            words += changed;
        else
            words[place + 1] = changed.at(1);
        const QByteArray plan = fixture.box.content("plan.csv");
        const ProgramRun run = fixture.box.run(words);
        VERIFY_CODE(run, code);
        QVERIFY2(run.err.contains(said), run.err.constData());
        QCOMPARE(fixture.taken(), 0L);
        QCOMPARE(fixture.box.content("plan.csv"), plan);
    }

    void theTableThatIsActiveIsNamedInTheFile()
    {
        CaptureFixture fixture;
        fixture.startMachine();
        const QString drive = fixture.machine->url();
        fixture.box.file("table.csv", "X [mm],Error [mm]\n0,0\n15,0.00018\n30,0.00036\n");
        VERIFY_CODE(
            fixture.box.run({"write", "--drive", drive, "--axis", "X", "--data", "table.csv",
                "--dims", "1", "--source1", test::positionSource(0), "--volatile"}),
            0);
        VERIFY_CODE(fixture.box.run({"activate", "--drive", drive, "--axis", "X"}), 0);
        const QJsonObject status =
            fixture.box.run({"status", "--drive", drive, "--axis", "X", "--json"}).json();
        const auto crc =
            static_cast<uint>(status.value("table").toObject().value("crc").toInteger());
        RunningCapture capture = fixture.start(fixture.words());
        QVERIFY(fixture.play(capture));
        QVERIFY2(capture.says("1/4  "), capture.out.constData());
        const QByteArray file = fixture.box.content("runs.csv");
        const QByteArray expected =
            "// compensation: crc:" + QByteArray::number(crc, 16).rightJustified(8, '0') + "\n";
        QVERIFY2(file.contains(expected), file.constData());
        QVERIFY2(file.contains("\n// table: Axes[0]/Signals/PathPlanner/Position from "
                               "0, 3 points every 15\n"),
            file.constData());
        VERIFY_CODE(fixture.box.run({"deactivate", "--drive", drive, "--axis", "X"}), 0);
        QVERIFY2(capture.warns("error: MeasurementState: "), capture.err.constData());
        const ProgramRun stopped = capture.end();
        VERIFY_CODE(stopped, 2);
        QVERIFY2(stopped.err.contains(" of 4 values in runs.csv\n"), stopped.err.constData());
        QVERIFY2(!stopped.err.contains("goes on behind them"), stopped.err.constData());
        // What is active now belongs into another file.
        const ProgramRun other = fixture.box.run(fixture.words());
        VERIFY_CODE(other, 3);
        QVERIFY2(other.err.contains("where // compensation: off is expected; name a new file"),
            other.err.constData());
    }
};

AXISCOMP_TEST(tst_CaptureCommand)

} // namespace tst_capturecommand

#include "tst_capturecommand.moc"
