// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/formats.h"
#include "core/machine/machine_file.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

namespace tst_machinefile {

using namespace axiscomp;

namespace {

QStringList lines(std::initializer_list<const char*> texts)
{
    QStringList list;
    for (const char* text : texts)
        list += QString::fromUtf8(text);
    return list;
}

const std::string head = "version = 1\n[[drive]]\nendpoint = \"http://a\"\nserial = 7\n";

/// Of one drive with one axis, whose lines these are: from line 6 on.
std::string withAxis(const std::string& lines)
{
    return head + "[[drive.axis]]\n" + lines;
}

const std::string axisX = "axis = \"X\"\nfile = \"x.csv\"\nsources = [\"a\"]\n";

/// The second one is in line 10.
std::string withEndpoints(const std::string& one, const std::string& other)
{
    return "version = 1\n[[drive]]\nendpoint = \"" + one + "\"\nserial = 6\n[[drive.axis]]\n"
        + axisX + "[[drive]]\nendpoint = \"" + other + "\"\nserial = 7\n[[drive.axis]]\n" + axisX;
}

/// "6:1 Syntax serail|a known key; the nearest is serial", one for each problem.
QStringList problemsOf(const std::string& text)
{
    QStringList list;
    for (const Diagnostic& problem : readMachine(text).diagnostics)
        list.append(QStringLiteral("%1:%2 %3 %4|%5")
                        .arg(problem.line)
                        .arg(problem.column)
                        .arg(QString::fromStdString(std::string(diagnosticName(problem.code))),
                            QString::fromStdString(problem.found.english()),
                            QString::fromStdString(problem.expected.english())));
    return list;
}

MachineFile fullMachine()
{
    MachineAxis x;
    x.axis = "X";
    x.sources = {"Axes[0]/A", "Axes[1]/B"};
    x.file = "tables/x \"1\".txt";
    x.column = "2";
    x.choices.format = &softmc::format();
    x.choices.settings = {{"position-unit", "mm"}, {"with blank", "a\\b"}};
    x.choices.target = "#1";
    x.choices.sign = SignConvention::Command;
    x.choices.direction = DirectionChoice::Positive;
    x.choices.dropsWrap = true;
    x.choices.units.values = "um";
    x.choices.units.positions = "drive";
    x.persistency = Persistency::Persistent;
    x.slot = "Large1";
    x.isActive = true;
    x.tolerance = ValueTolerance{0.05, "um"};
    x.acceptsLarge = true;
    MachineAxis none;
    none.axis = "1";
    none.sources = {"", "Axes[0]/A"};
    MachineAxis plain;
    plain.axis = "Z";
    plain.sources = {"Axes[2]/A"};
    plain.file = "z.csv";
    plain.isActive = false;
    return {
        "Mill 7", {{"http://10.0.0.1", 100001, {x, none}}, {"serial:/dev/ttyUSB0", -5, {plain}}}};
}

MachineFile withoutLines(MachineFile machine)
{
    for (MachineDrive& drive : machine.drives) {
        drive.line = 0;
        for (MachineAxis& axis : drive.axes)
            axis.line = 0;
    }
    return machine;
}

} // namespace

class TestMachineFile : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void whatIsWrittenIsReadBackAndAlwaysTheSame()
    {
        const MachineFile machine = fullMachine();
        const std::string text = writeMachine(machine);
        const MachineReading reading = readMachine(text);
        QVERIFY2(reading.machine, qPrintable(problemsOf(text).join(u'\n')));
        QVERIFY(withoutLines(*reading.machine) == machine);
        QCOMPARE(writeMachine(*reading.machine), text);
    }

    void placesAreThoseOfTheFile()
    {
        const MachineReading reading = readMachine(withAxis(axisX));
        QVERIFY(reading.machine);
        QCOMPARE(reading.machine->drives[0].line, std::size_t(2));
        QCOMPARE(reading.machine->drives[0].axes[0].line, std::size_t(5));
    }

    void leavingOutDecidesNothing()
    {
        const MachineAxis axis = readMachine(withAxis(axisX)).machine->drives[0].axes[0];
        QCOMPARE(axis.persistency, Persistency::Volatile);
        QVERIFY(!axis.isActive && !axis.tolerance && !axis.acceptsLarge);
        QVERIFY(axis.slot.empty() && axis.choices == ImportChoices());
    }

    void twoPortsOrSchemesOfOneHostAreTwoDrives()
    {
        QVERIFY(readMachine(withEndpoints("http://a:8080", "http://a:8081")).machine);
        QVERIFY(readMachine(withEndpoints("http://a", "https://a")).machine);
        QVERIFY(readMachine(withEndpoints("http://a:443", "http://a:80")).machine);
        QVERIFY(readMachine(withEndpoints("serial:/dev/ttyS0", "serial:/dev/ttys0")).machine);
        QVERIFY(readMachine(withEndpoints("http://[::1]:81", "http://[::1]:82")).machine);
        QVERIFY(readMachine(withEndpoints("http://127.1", "http://127.1:81")).machine);
        QVERIFY(readMachine(withEndpoints("http://[::1", "http://[::2]")).machine);
    }

    void whatIsWrongIsNamedWithItsPlace_data()
    {
        QTest::addColumn<std::string>("text");
        QTest::addColumn<QStringList>("problems");
        QTest::newRow("a misspelled key")
            << withAxis(axisX + "sorces = 1\n")
            << lines({"9:1 Syntax sorces|a known key; the nearest is sources"});
        QTest::newRow("a misspelled key of a drive")
            << "version = 1\n[[drive]]\nendpoint = \"a\"\nserial = 1\n  serail = 2\n"
               "[[drive.axis]]\n"
                + axisX
            << lines({"5:3 Syntax serail|a known key; the nearest is serial"});
        QTest::newRow("another version") << "version = 2\n" + withAxis(axisX).substr(12)
                                         << lines({"1:11 Syntax 2|1, the version of this format"});
        QTest::newRow("no serial number")
            << "version = 1\n[[drive]]\nendpoint = \"a\"\n[[drive.axis]]\n" + axisX
            << lines({"2:1 Syntax |an entry serial"});
        QTest::newRow("a serial number as a text")
            << "version = 1\n[[drive]]\nendpoint = \"a\"\nserial = \"7\"\n[[drive.axis]]\n" + axisX
            << lines({"4:10 Syntax 7|the serial number of the drive, a whole number of at most 32 "
                      "bits, without quotation marks"});
        QTest::newRow("a serial number beyond 32 bits")
            << "version = 1\n[[drive]]\nendpoint = \"a\"\nserial = 2147483648\n[[drive.axis]]\n"
                + axisX
            << lines({"4:10 Syntax 2147483648|the serial number of the drive, a whole number of at "
                      "most 32 bits, without quotation marks"});
        QTest::newRow("no drives")
            << std::string("version = 1\n") << lines({"1:1 Syntax |an entry drive"});
        QTest::newRow("a table of a drive that is none")
            << std::string("version = 1\ndrive = 3\n")
            << lines({"2:9 Syntax 3|sections that begin with [[drive]]"});
        QTest::newRow("neither a table nor none")
            << withAxis("axis = 0\n")
            << lines({"5:1 Syntax |an entry file, or no-table = true for an axis that shall "
                      "have none"});
        QTest::newRow("a table and none") << withAxis(axisX + "no-table = true\n")
                                          << lines({"9:12 Contradiction no-table beside file|"});
        QTest::newRow("a table without sources")
            << withAxis("axis = \"X\"\nfile = \"x.csv\"\n")
            << lines({"5:1 Syntax |an entry sources, with the register that looks the table "
                      "up for each of its dimensions"});
        QTest::newRow("persistent without a table")
            << withAxis("axis = \"X\"\nno-table = true\npersistent = true\n")
            << lines({"8:14 Contradiction persistent of an axis without a table|"});
        QTest::newRow("no-wrap without a table")
            << withAxis("axis = \"X\"\nno-table = true\nno-wrap = true\n")
            << lines({"8:11 Contradiction no-wrap of an axis without a table|"});
        QTest::newRow("active without a table")
            << withAxis("axis = \"X\"\nno-table = true\nactive = true\n")
            << lines({"8:10 Contradiction active of an axis without a table|"});
        QTest::newRow("a number for a text") << withAxis(
            axisX + "slot = 1\n") << lines({"9:8 Syntax 1|a text; write it in quotation marks"});
        QTest::newRow("a number for a target")
            << withAxis(axisX + "target = 2\n")
            << lines({"9:10 Syntax 2|a text; write \"#1\" for the first source, "
                      "\"2\" for an axis of that name"});
        QTest::newRow("a whole version with decimals")
            << "version = 1.0\n" + withAxis(axisX).substr(12)
            << lines({"1:11 Syntax 1.0|1, the version of this format"});
        QTest::newRow("a number below zero for a name")
            << withAxis(axisX + "column = -1\n")
            << lines({"9:10 Syntax -1|a name, or a whole number that is not negative"});
        QTest::newRow("a number with decimals for a name")
            << withAxis(axisX + "column = 2.0\n")
            << lines({"9:10 Syntax 2.0|a name, or a whole number that is not negative"});
        QTest::newRow("an empty name")
            << withAxis(axisX + "target = \"\"\n")
            << lines({"9:10 Syntax |a text that is not empty and has no control characters"});
        QTest::newRow("a zero byte in a name")
            << withAxis("axis = \"X\"\nfile = \"t\\u0000/x.csv\"\nsources = [\"a\"]\n")
            << lines({"7:8 Syntax t\u2400/x.csv|a text that is not empty and has no control "
                      "characters"});
        QTest::newRow("another encoding")
            << std::string("version = 1\nname = \"Fr\xe4se\"\n")
            << lines({"2:11 Syntax name = \"Fr\u00e4se\"|UTF-8 text"});
        QTest::newRow("a word for true") << withAxis(axisX + "persistent = \"yes\"\n")
                                         << lines({"9:14 Syntax yes|true or false"});
        QTest::newRow("an unknown sign") << withAxis(axisX + "sign = \"minus\"\n")
                                         << lines({"9:8 Syntax minus|one of feedback, command"});
        QTest::newRow("a tolerance without its unit")
            << withAxis(axisX + "tolerance = \"0.1\"\n")
            << lines(
                   {"9:13 Syntax 0.1|a number that is not negative and its unit, such as 0.1 um"});
        QTest::newRow("a negative tolerance") << withAxis(axisX + "tolerance = \"-1 um\"\n")
                                              << lines({"9:13 Syntax -1 um|a number that is not "
                                                        "negative and its unit, such as 0.1 um"});
        QTest::newRow("four sources")
            << withAxis("axis = 0\nfile = \"a\"\nsources = [\"a\", \"b\", \"c\", \"d\"]\n")
            << lines({"8:11 Syntax [...]|a list of one to three registers"});
        QTest::newRow("two axes that want one slot")
            << withAxis(axisX
                   + "slot = \"Small1\"\n[[drive.axis]]\naxis = 1\nfile = \"y.csv\"\n"
                     "sources = [\"a\"]\nslot = \"small1\"\n")
            << lines({"14:8 Contradiction slot small1 is taken by the axis in line 9|"});
        QTest::newRow("an axis that is there twice")
            << withAxis(axisX + "[[drive.axis]]\n" + axisX)
            << lines({"10:8 Contradiction axis X of this drive is in line 6 already|"});
        QTest::newRow("a drive that is there twice")
            << withAxis(axisX) + "[[drive]]\nendpoint = \"http://a\"\nserial = 7\n[[drive.axis]]\n"
                + axisX
            << lines({"10:12 Contradiction http://a is a drive in line 3 already|",
                   "11:10 Contradiction serial number 7 is in line 4 already|"});
        QTest::newRow("an address in two ways")
            << "version = 1\n[[drive]]\nendpoint = \"http://A:80\"\nserial = 6\n[[drive.axis]]\n"
                + axisX + "[[drive]]\nendpoint = \"http://me:se@cret@a/\"\nserial = 7\n"
                + "[[drive.axis]]\n" + axisX
            << lines({"10:12 Contradiction http://a is a drive in line 3 already|"});
        QTest::newRow("an IPv6 address in two ways")
            << withEndpoints("http://[::1]:21200", "http://[0:0:0:0:0:0:0:1]:21200")
            << lines({"10:12 Contradiction http://[::1]:21200 is a drive in line 3 already|"});
        QTest::newRow("an IPv4 address in two ways")
            << withEndpoints("https://127.0.0.1", "https://127.1:443")
            << lines({"10:12 Contradiction https://127.0.0.1 is a drive in line 3 already|"});
        QTest::newRow("a port with two rates")
            << "version = 1\n[[drive]]\nendpoint = \"serial:/dev/ttyS0\"\nserial = 6\n"
               "[[drive.axis]]\n"
                + axisX + "[[drive]]\nendpoint = \"serial:/dev/ttyS0?baud=9600\"\nserial = 7\n"
                + "[[drive.axis]]\n" + axisX
            << lines({"10:12 Contradiction serial:/dev/ttyS0 is a drive in line 3 already|"});
        QTest::newRow("a key that is there twice")
            << std::string("version = 1\nversion = 1\n") << QStringList();
    }
    void whatIsWrongIsNamedWithItsPlace()
    {
        QFETCH(std::string, text);
        QFETCH(QStringList, problems);
        const MachineReading reading = readMachine(text);
        QVERIFY(!reading.machine);
        if (!problems.isEmpty()) {
            QCOMPARE(problemsOf(text), problems);
            return;
        }
        QCOMPARE(reading.diagnostics.size(), std::size_t(1));
        QCOMPARE(reading.diagnostics[0].line, std::size_t(2));
    }

    /// What is proposed for a number helps.
    void aTargetIsANameOrTheNumberOfASource()
    {
        for (const char* target : {"#1", "2", "other"}) {
            const std::string text = withAxis(axisX + "target = \"" + target + "\"\n");
            const MachineReading reading = readMachine(text);
            QVERIFY2(reading.machine, qPrintable(problemsOf(text).join(u'\n')));
            QCOMPARE(reading.machine->drives[0].axes[0].choices.target, std::string(target));
        }
    }

    void whatIsNoTomlIsNamedWithItsPlace()
    {
        const MachineReading reading = readMachine("version = 1\n[[drive]\n");
        QVERIFY(!reading.machine);
        QCOMPARE(reading.diagnostics.size(), std::size_t(1));
        QCOMPARE(reading.diagnostics[0].line, std::size_t(2));
        const std::string said = message(reading.diagnostics[0]);
        QVERIFY2(said.find("valid TOML") != std::string::npos, said.c_str());
    }

    void lettersOutsideOfTextsAreRefusedWithTheirPlace_data()
    {
        QTest::addColumn<QByteArray>("line");
        QTest::newRow("at its beginning") << QByteArray("\u01fd");
        QTest::newRow("in a key") << QByteArray("gr\u00f6\u00dfe = 1");
        QTest::newRow("as a value") << QByteArray("version = \u00e4");
        QTest::newRow("behind a number") << QByteArray("version = 1\u00b5");
        QTest::newRow("behind a backslash") << QByteArray("name = \"\"\"a\\\u00e9\"\"\"");
    }
    void lettersOutsideOfTextsAreRefusedWithTheirPlace()
    {
        QFETCH(QByteArray, line);
        const MachineReading reading = readMachine("# \u00e4\n" + line.toStdString() + "\n");
        QVERIFY(!reading.machine);
        QCOMPARE(reading.diagnostics.size(), std::size_t(1));
        QCOMPARE(reading.diagnostics[0].line, std::size_t(2));
        const std::string said = message(reading.diagnostics[0]);
        QVERIFY2(said.find("valid TOML") != std::string::npos, said.c_str());
    }

    void theNumberOfProblemsIsLimitedAndCounted()
    {
        std::string text = withAxis(axisX);
        for (int n = 0; n < 150; ++n)
            text += "unknown" + std::to_string(n) + " = 1\n";
        const MachineReading reading = readMachine(text);
        QCOMPARE(reading.diagnostics.size(), std::size_t(100));
        QCOMPARE(reading.suppressed, std::size_t(50));
        const Error error = machineError("m.toml", reading);
        QCOMPARE(sentence(error), std::string("m.toml is not a valid machine file: 150 problems"));
    }
};

AXISCOMP_TEST(TestMachineFile)

} // namespace tst_machinefile

#include "tst_machinefile.moc"
