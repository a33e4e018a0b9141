// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program_run.h"

#include "tests/support/patience.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QJsonArray>
#include <QTest>

#include <csignal>

namespace tst_machinecommands {

using namespace axiscomp;
using test::ProgramRun;
using test::Sandbox;
using test::VirtualDriveProcess;

namespace {

const QByteArray first1D = "X [mm],Error [mm]\n0,0\n40,0.0021\n80,-0.001\n";
const QByteArray nearly1D = "X [mm],Error [mm]\n0,0\n40,0.00215\n80,-0.001\n";
const QByteArray second1D = "Y [mm],Error [mm]\n0,0\n50,0.0011\n100,-0.003\n";

/// A section of the file for an axis that looks its table up by its own position.
QByteArray axisSection(int axis, const QByteArray& file, const QByteArray& more = {})
{
    return "[[drive.axis]]\naxis = " + QByteArray::number(axis) + "\nfile = \"" + file
        + "\"\nsources = [\"" + test::positionSource(axis).toUtf8() + "\"]\n" + more;
}

QByteArray driveSection(const QString& url, int serialNumber)
{
    return "[[drive]]\nendpoint = \"" + url.toUtf8()
        + "\"\nserial = " + QByteArray::number(serialNumber) + "\n";
}

/// Two drives of two axes each, and a machine file for three of the four.
struct Machine {
    Sandbox box;
    VirtualDriveProcess one{box};
    VirtualDriveProcess two{box, {"--name", "Second"}};
    int serialTwo = 0;

    Machine()
    {
        box.file("first.csv", first1D);
        box.file("second.csv", second1D);
        const QJsonObject drive = box.run({"axes", "--drive", two.url(), "--json"})
                                      .json()
                                      .value("drives")
                                      .toArray()
                                      .at(0)
                                      .toObject();
        serialTwo = drive.value("serialNumber").toInt();
        write(axisSection(0, "first.csv", "persistent = true\n") + axisSection(1, "second.csv"),
            axisSection(0, "first.csv"));
    }

    void write(const QByteArray& ofOne, const QByteArray& ofTwo) const
    {
        box.file("machine.toml",
            "version = 1\n" + driveSection(one.url(), 100001) + ofOne
                + driveSection(two.url(), serialTwo) + ofTwo);
    }
    [[nodiscard]] ProgramRun run(const QStringList& arguments) const
    {
        return box.run(arguments + QStringList{box.path("machine.toml")});
    }
    [[nodiscard]] QJsonObject status(const VirtualDriveProcess& drive, int axis = 0) const
    {
        return box
            .run({"status", "--json", "--drive", drive.url(), "--axis", QString::number(axis)})
            .json();
    }
    [[nodiscard]] bool isUntouched() const
    {
        return status(one).value("slot").isNull() && status(one, 1).value("slot").isNull()
            && status(two).value("slot").isNull();
    }
};

QJsonObject axisOf(const ProgramRun& run, int drive, int axis)
{
    return run.json()
        .value("drives")
        .toArray()
        .at(drive)
        .toObject()
        .value("axes")
        .toArray()
        .at(axis)
        .toObject();
}

} // namespace

class TestMachineCommands : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void whatDiffersIsWrittenOnceAndThenTheSame()
    {
        const Machine machine;
        const ProgramRun plan = machine.run({"plan"});
        VERIFY_CODE(plan, 9);
        QVERIFY2(plan.out.contains("Plan for axis 1 (Y) of Virtual-1"), plan.out.constData());
        QVERIFY2(
            plan.out.contains("differs: Table, Dim1Source, Persistency"), plan.out.constData());
        QVERIFY(machine.isUntouched());

        const ProgramRun apply = machine.run({"apply"});
        VERIFY_CODE(apply, 0);
        QVERIFY2(apply.out.contains("written"), apply.out.constData());
        const QJsonObject x = machine.status(machine.one);
        QCOMPARE(x.value("persistent").toBool(), true);
        QCOMPARE(x.value("state").toString(), "Disabled");
        QCOMPARE(machine.status(machine.one, 1).value("persistent").toBool(), false);
        QCOMPARE(machine.status(machine.two).value("table").toObject().value("crc"),
            x.value("table").toObject().value("crc"));

        VERIFY_CODE(machine.run({"plan"}), 0);
        const ProgramRun again = machine.run({"apply", "--json"});
        VERIFY_CODE(again, 0);
        QCOMPARE(axisOf(again, 0, 0).value("outcome").toObject().value("written").toBool(), false);
        QCOMPARE(again.json().value("differs").toBool(), false);
        QJsonObject now = machine.status(machine.one);
        QCOMPARE(now.value("slot"), x.value("slot"));
        QCOMPARE(now.value("flash").toObject().value("cycles").toInt(), 1);
    }

    void aTableThatARebootBringsBackIsWarnedOfByEveryPlan()
    {
        const Machine machine;
        VERIFY_CODE(machine.run({"apply"}), 0);
        const QByteArray none = "[[drive.axis]]\naxis = 0\nno-table = true\nsources = [\"\"]\n";
        machine.write(none, none);
        VERIFY_CODE(machine.run({"apply"}), 0);
        const ProgramRun plan = machine.run({"plan"});
        VERIFY_CODE(plan, 0);
        QCOMPARE(plan.err.count("Flash keeps the table in"), 1); // that of the second is volatile
        QVERIFY2(plan.err.contains("Delete the table first"), plan.err.constData());

        VERIFY_CODE(machine.box.run({"delete", "--axis", "0", "--drive", machine.one.url()}), 0);
        const ProgramRun again = machine.run({"plan"});
        VERIFY_CODE(again, 0);
        QVERIFY2(!again.err.contains("Flash keeps"), again.err.constData());
    }

    void aTableWithinTheToleranceIsTheSame()
    {
        const Machine machine;
        VERIFY_CODE(machine.run({"apply"}), 0);
        machine.box.file("first.csv", nearly1D);
        VERIFY_CODE(machine.run({"plan"}), 9);
        const auto withTolerance = [&](const QByteArray& tolerance) {
            const QByteArray line = "tolerance = \"" + tolerance + "\"\n";
            machine.write(axisSection(0, "first.csv", "persistent = true\n" + line)
                    + axisSection(1, "second.csv"),
                axisSection(0, "first.csv", line));
        };
        withTolerance("0.051 um");
        VERIFY_CODE(machine.run({"plan"}), 0);
        withTolerance("0.049 um");
        VERIFY_CODE(machine.run({"plan"}), 9);
    }

    void anotherDriveIsRefusedAndNothingWritten()
    {
        const Machine machine;
        machine.box.file("machine.toml",
            "version = 1\n" + driveSection(machine.one.url(), 100001) + axisSection(0, "first.csv")
                + driveSection(machine.two.url(), 4711) + axisSection(0, "first.csv"));
        const ProgramRun plan = machine.run({"plan"});
        VERIFY_CODE(plan, 4);
        QVERIFY2(
            plan.err.contains("OtherDrive") && plan.err.contains("4711"), plan.text().constData());
        const ProgramRun apply = machine.run({"apply", "--allow-missing"});
        VERIFY_CODE(apply, 4);
        QVERIFY2(apply.err.contains("nothing was written"), apply.err.constData());
        QVERIFY(machine.isUntouched());
    }

    void whatIsImpossibleForOneAxisIsWrittenToNone()
    {
        const Machine machine;
        machine.write(axisSection(0, "first.csv"),
            "[[drive.axis]]\naxis = 0\nfile = \"first.csv\"\nsources = [\"Axes[0]/Nothing\"]\n");
        const ProgramRun apply = machine.run({"apply"});
        VERIFY_CODE(apply, 2);
        QVERIFY2(apply.err.contains("SourceNotFound"), apply.err.constData());
        QVERIFY(machine.isUntouched());
    }

    void aDriveThatDoesNotAnswerIsNamedAndTheOthersPlanned()
    {
        Machine machine;
        machine.two.process().kill();
        machine.two.process().waitForFinished(test::patienceMs);
        const ProgramRun plan = machine.run({"plan"});
        VERIFY_CODE(plan, 5);
        QVERIFY2(plan.err.contains(machine.two.url().toUtf8()), plan.err.constData());
        QVERIFY2(plan.out.contains("Plan for axis 0 (X) of Virtual-1"), plan.out.constData());
        QVERIFY2(plan.out.contains("does not answer"), plan.out.constData());
        VERIFY_CODE(machine.run({"apply"}), 5);
        QVERIFY(machine.status(machine.one).value("slot").isNull());
        VERIFY_CODE(machine.run({"apply", "--allow-missing"}), 0);
        QVERIFY(!machine.status(machine.one).value("slot").isNull());
        const ProgramRun without = machine.run({"plan", "--allow-missing"});
        VERIFY_CODE(without, 0);
        const QByteArray leftOut = machine.two.url().toUtf8() + " (serial number "
            + QByteArray::number(machine.serialTwo) + ") is left out: ";
        QVERIFY2(without.err.contains(leftOut + "no connection to"), without.err.constData());
        // Where none answers nothing was compared.
        machine.one.process().kill();
        machine.one.process().waitForFinished(test::patienceMs);
        VERIFY_CODE(machine.run({"plan", "--allow-missing"}), 5);
        VERIFY_CODE(machine.run({"apply", "--allow-missing"}), 5);
    }

    void whatInterruptsAnApplyTheNextOneContinues_data()
    {
        QTest::addColumn<int>("writtenAxes");
        for (const int axes : {0, 1})
            QTest::addRow("killed after %d axes", axes) << axes;
    }
    void whatInterruptsAnApplyTheNextOneContinues()
    {
        QFETCH(int, writtenAxes);
        constexpr int axes = 6; // enough for the second one to be killed in time
        const Sandbox box;
        const VirtualDriveProcess drive(
            box, {"--axes", QString::number(axes), "--fault", "slow=20"});
        QByteArray text = "version = 1\n" + driveSection(drive.url(), 100001);
        for (int axis = 0; axis < axes; ++axis) {
            const QByteArray name = "table" + QByteArray::number(axis) + ".csv";
            box.file(name, "P,V\n0,0\n50,0.00" + QByteArray::number(axis + 1) + "\n");
            text += axisSection(axis, name);
        }
        box.file("machine.toml", text);
        const auto apply = box.start(test::axiscompProgram(), {"apply", box.path("machine.toml")});
        // Its plan is printed before it writes.
        QTRY_VERIFY(apply->bytesAvailable() > 0 || apply->waitForReadyRead(10));
        const auto tableRegister = [](int axis) {
            return "Axes[" + std::to_string(axis) + "]/Parameters/Compensations/Axis/Table";
        };
        const RegisterValue noTable = drive.registerValue(tableRegister(axes - 1));
        QVERIFY(noTable != RegisterValue());
        const auto hasTable = [&](int axis) {
            return !box.run({"status", "--json", "--drive", drive.url(), "--axis",
                                QString::number(axis)})
                        .json()
                        .value("slot")
                        .isNull();
        };
        // Looked for by this process: the start of another one takes as long as the whole apply.
        if (writtenAxes > 0)
            QTRY_VERIFY(drive.registerValue(tableRegister(writtenAxes - 1)) != noTable);
        apply->kill();
        QVERIFY(apply->waitForFinished(test::patienceMs));
        QCOMPARE(apply->exitStatus(), QProcess::CrashExit);
        VERIFY_CODE(box.run({"plan", "machine.toml"}), 9);
        VERIFY_CODE(box.run({"apply", "machine.toml"}), 0);
        VERIFY_CODE(box.run({"plan", "machine.toml"}), 0);
        for (int axis = 0; axis < axes; ++axis)
            QVERIFY(hasTable(axis));
    }

    /// The axes of a drive after the one that fails are not begun.
    void whatWasNotWrittenIsSaidAndContinuedWith()
    {
        const Sandbox box;
        // The first axis is uploaded and switched over, then the second one is uploaded.
        const VirtualDriveProcess drive(box, {"--axes", "3", "--fault", "stores-wrong=3"});
        QByteArray text = "version = 1\n" + driveSection(drive.url(), 100001);
        for (int axis = 0; axis < 3; ++axis) {
            const QByteArray name = "table" + QByteArray::number(axis) + ".csv";
            box.file(name, "P,V\n0,0\n50,0.00" + QByteArray::number(axis + 1) + "\n");
            text += axisSection(axis, name);
        }
        box.file("machine.toml", text);
        const ProgramRun run = box.run({"apply", "machine.toml"});
        VERIFY_CODE(run, 6);
        QCOMPARE(run.out.count("not written"), 1);
        QVERIFY2(run.err.contains("note: the same command does again what failed, and continues "
                                  "with what was not written; the rest is there already"),
            run.err.constData());
        VERIFY_CODE(box.run({"apply", "machine.toml"}), 0);
        VERIFY_CODE(box.run({"plan", "machine.toml"}), 0);
    }

    void aSlotThatIsNamedIsNotTakenByAnAxisBefore()
    {
        const Machine machine;
        machine.write(
            axisSection(0, "first.csv") + axisSection(1, "second.csv", "slot = \"Small1\"\n"),
            axisSection(0, "first.csv"));
        VERIFY_CODE(machine.run({"apply"}), 0);
        QCOMPARE(machine.status(machine.one, 1).value("slot").toString(), "Small1");
        QCOMPARE(machine.status(machine.one, 0).value("slot").toString(), "Small2");
        VERIFY_CODE(machine.run({"plan"}), 0);
    }

    void onlyTheAxesThatAreNamedAreWritten()
    {
        const Machine machine;
        VERIFY_CODE(machine.run({"apply", "--only", "100001/0"}), 0);
        QVERIFY(!machine.status(machine.one).value("slot").isNull());
        QVERIFY(machine.status(machine.one, 1).value("slot").isNull());
        QVERIFY(machine.status(machine.two).value("slot").isNull());
        const ProgramRun unknown = machine.run({"apply", "--only", "Q"});
        VERIFY_CODE(unknown, 2);
        QVERIFY2(unknown.err.contains("Q"), unknown.err.constData());
    }

    /// The whole file would be impossible from then on.
    void anAxisThatIsLeftOutKeepsItsSlot()
    {
        const Machine machine;
        machine.write(
            axisSection(0, "first.csv") + axisSection(1, "second.csv", "slot = \"Small1\"\n"),
            axisSection(0, "first.csv"));
        VERIFY_CODE(machine.run({"apply", "--only", "100001/0"}), 0);
        QCOMPARE(machine.status(machine.one, 0).value("slot").toString(), "Small2");
        VERIFY_CODE(machine.run({"apply"}), 0);
        QCOMPARE(machine.status(machine.one, 1).value("slot").toString(), "Small1");
    }

    void anActivationIsADifferenceAndSwitchedWhenAskedFor()
    {
        const Machine machine;
        machine.write(axisSection(0, "first.csv", "active = true\n"), axisSection(0, "first.csv"));
        VERIFY_CODE(machine.run({"apply"}), 0);
        QCOMPARE(machine.status(machine.one).value("state").toString(), "Disabled");
        const ProgramRun plan = machine.run({"plan"});
        VERIFY_CODE(plan, 9);
        QVERIFY2(plan.out.contains("differs: Activation"), plan.out.constData());
        const ProgramRun apply = machine.run({"apply", "--activate", "--json"});
        VERIFY_CODE(apply, 0);
        const QJsonObject outcome = axisOf(apply, 0, 0).value("outcome").toObject();
        QVERIFY(!outcome.value("proof").isNull());
        QCOMPARE(outcome.value("status").toObject().value("state").toString(), "Active");
        VERIFY_CODE(machine.run({"plan"}), 0);

        // What differs is known while it is active, and not written.
        machine.box.file("first.csv", nearly1D);
        const ProgramRun drift = machine.run({"plan"});
        VERIFY_CODE(drift, 9);
        QVERIFY2(drift.err.contains("active; deactivate it first"), drift.err.constData());
        const ProgramRun refused = machine.run({"apply"});
        VERIFY_CODE(refused, 4);
        QVERIFY(
            machine.run({"plan", "--only", QString::number(machine.serialTwo) + "/0"}).code == 9);
    }

    /// Outside of its table an axis shows nothing, and `activate` warns of it in these words.
    void whatIsSwitchedOnIsProvedOrWarnedOf()
    {
        const Machine machine;
        machine.box.file("around.csv", "X [mm],Error [mm]\n-10,0.002\n110,0.003\n");
        machine.box.file("away.csv", "X [mm],Error [mm]\n-300,0.001\n-200,0.003\n");
        machine.write(axisSection(0, "around.csv", "active = true\n"),
            axisSection(0, "away.csv", "active = true\n"));
        const ProgramRun apply = machine.run({"apply", "--activate"});
        VERIFY_CODE(apply, 0);
        const QByteArray serial = QByteArray::number(machine.serialTwo);
        QVERIFY2(apply.out.contains("(serial number 100001), axis 0: Proof: what the drive adds is "
                                    "what the table says, over 100 % of the table."),
            apply.out.constData());
        QVERIFY2(apply.out.contains("written and switched, not proved"), apply.out.constData());
        QVERIFY2(apply.err.contains("(serial number " + serial
                     + "), axis 0: nothing is proved: The axis is outside of the table"),
            apply.err.constData());

        VERIFY_CODE(
            machine.box.run({"deactivate", "--axis", "0", "--drive", machine.two.url()}), 0);
        const ProgramRun again = machine.run({"apply", "--activate", "--json"});
        VERIFY_CODE(again, 0);
        QVERIFY2(again.err.contains("nothing is proved: "), again.err.constData());
        const auto proof = axisOf(again, 1, 0).value("outcome").toObject().value("proof");
        QVERIFY(!proof.toObject().value("proved").toBool(true));
    }

    void aFileThatIsWrongIsNamedBeforeAnyDriveIsAsked()
    {
        const Machine machine;
        machine.write(
            axisSection(0, "first.csv", "slto = \"Small1\"\n"), axisSection(0, "first.csv"));
        const ProgramRun run = machine.run({"plan"});
        VERIFY_CODE(run, 3);
        QVERIFY2(run.err.contains("machine.toml:9:1: error: ")
                && run.err.contains("the nearest is slot"),
            run.err.constData());
        machine.box.file("first.csv", "X [mm],Error [mm]\n0,0\n40,zero\n");
        machine.write(axisSection(0, "first.csv"), axisSection(0, "first.csv"));
        const ProgramRun table = machine.run({"plan"});
        VERIFY_CODE(table, 3);
        QVERIFY2(table.err.contains("first.csv:3:2: error: "), table.err.constData());
    }
};

AXISCOMP_TEST(TestMachineCommands)

} // namespace tst_machinecommands

#include "tst_machinecommands.moc"
