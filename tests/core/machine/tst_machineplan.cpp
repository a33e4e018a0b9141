// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/formats.h"
#include "core/machine/machine_plan.h"
#include "core/machine/machine_tables.h"
#include "core/machine/machine_texts.h"
#include "core/machine/open_metrics.h"
#include "core/machine/snapshot.h"
#include "core/table/tam_table.h"
#include "tests/support/compensator_fixture.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

namespace tst_machineplan {

using namespace axiscomp;
using test::CompensatorFixture;

namespace {

/// A drive of which axis 0 shall have the example table.
struct Machine {
    CompensatorFixture bench;
    MachineDrive drive;
    std::vector<MachineTable> tables = std::vector<MachineTable>(1);
    MachineContext context;

    Machine()
    {
        drive.serialNumber = 4711;
        MachineAxis& axis = drive.axes.emplace_back();
        axis.axis = "0";
        axis.file = "example.csv";
        axis.sources = std::vector<std::string>{test::masterX, test::masterY};
        tables[0].table = test::exampleTable(2);
        context.storeRoot = std::filesystem::path(bench.folder.path().toStdString()) / "axiscomp";
    }
    [[nodiscard]] Result<DrivePlan> plan()
    {
        return planDrive(
            bench.compensator, drivecomm::genericProfile(), drive, tables, context, {});
    }
    /// The drive shall have what a snapshot of it says.
    void takeFrom(const DriveSnapshot& snapshot)
    {
        context.folder = bench.folder.path().toStdString();
        for (const DriveSnapshot::TableFile& file : snapshot.files)
            std::ofstream(context.folder / file.name, std::ios::binary)
                << std::string(asText(file.bytes));
        drive = snapshot.drive;
        tables = readMachineTables(
            MachineFile{{}, {drive}}, context.folder, drivecomm::genericProfile().layout)
                     .front();
    }
    [[nodiscard]] Result<std::vector<AxisOutcome>> apply(const DrivePlan& planned)
    {
        return applyPlan(bench.compensator, planned, context, {});
    }
};

MachineTable tableAtFirstSource(const MachineAxis& axis, const std::filesystem::path& folder)
{
    return readMachineTable(axis, folder, genericTableLayout(), AxisPlace{"#1", LookupAt::Encoder});
}

} // namespace

/// What a machine file says, compared with a drive and brought there.
class TestMachinePlan : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aPlanIsCarriedOut()
    {
        Machine machine;
        const auto plan = machine.plan();
        QVERIFY(plan.has_value());
        QVERIFY(plan->axes.at(0).writes());
        const auto outcomes = machine.apply(*plan);
        QVERIFY(outcomes.has_value());
        QVERIFY(outcomes->at(0).report.has_value());
        const auto again = machine.plan();
        QVERIFY(again.has_value());
        QVERIFY(!again->differs());
    }

    void aPlanIsNotCarriedOutOnAnotherDrive()
    {
        Machine machine;
        auto plan = machine.plan();
        QVERIFY(plan.has_value());
        plan->drive.serialNumber = 4712; // which was there when it was made
        const auto before = machine.bench.state();
        const auto outcomes = machine.apply(*plan);
        QVERIFY(!outcomes.has_value());
        QCOMPARE(outcomes.error().code, ErrorCode::OtherDrive);
        QVERIFY(machine.bench.state() == before);
    }

    /// The axis X of a twin machine has another error.
    void aTableThatWasMadeForAnotherDriveIsNotPlanned()
    {
        Machine machine;
        machine.context.folder = machine.bench.folder.path().toStdString();
        MachineAxis& axis = machine.drive.axes[0];
        axis.file = "x.csv";
        axis.sources = std::vector<std::string>{test::masterX};
        const auto planOf = [&](const std::string& notes) {
            std::ofstream(machine.context.folder / "x.csv")
                << notes << "X [mm],X error [mm]\n0,0\n10,0.001\n20,0\n";
            machine.tables = {
                readMachineTable(axis, machine.context.folder, genericTableLayout(), std::nullopt)};
            return machine.plan();
        };
        const auto other = planOf("// drive: Mill, serial number 4712\n");
        QVERIFY(other.has_value());
        QVERIFY(other->axes.at(0).problem.has_value());
        QCOMPARE(other->axes[0].problem->code, ErrorCode::OtherDrive);
        const auto own = planOf("// drive: Mill, serial number 4711\n");
        QVERIFY(own.has_value());
        QVERIFY(!own->axes.at(0).problem && own->axes[0].writes());
        planOf("// drive: Mill, serial number 4711\n// drive: Mill, serial number 4712\n");
        QVERIFY(machine.tables[0].problem.has_value());
        QCOMPARE(machine.tables[0].problem->code, ErrorCode::InvalidArgument);
    }

    /// It would work with a table that nobody has planned.
    void anAxisThatSomebodyHasChangedIsNotSwitchedOn()
    {
        Machine machine;
        machine.drive.axes[0].isActive = true;
        machine.context.activates = true;
        auto& compensator = machine.bench.compensator;
        QVERIFY(compensator.write(0, test::exampleRequest()).has_value());
        const auto plan = machine.plan();
        QVERIFY(plan.has_value());
        QVERIFY(!plan->axes.at(0).writes());
        QVERIFY(plan->axes[0].switches == std::optional(Switch::Activate));
        QVERIFY(compensator.write(0, test::exampleRequest(2)).has_value());
        const auto outcomes = machine.apply(*plan);
        QVERIFY(outcomes.has_value());
        QVERIFY(outcomes->at(0).problem.has_value());
        QCOMPARE(outcomes->at(0).problem->code, ErrorCode::ChangedMeanwhile);
        QVERIFY(outcomes->at(0).now.has_value());
        QVERIFY(!outcomes->at(0).now->isOn());
        const auto again = machine.plan();
        QVERIFY(again.has_value());
        QVERIFY(again->axes.at(0).writes());
    }

    /// The numbers are the same and mean something else.
    void anAxisInAnotherUnitThanThePlannedOneIsNotSwitchedOn()
    {
        Machine machine;
        machine.drive.axes[0].isActive = true;
        machine.context.activates = true;
        QVERIFY(machine.bench.compensator.write(0, test::exampleRequest()).has_value());
        const auto plan = machine.plan();
        QVERIFY(plan.has_value());
        QVERIFY(!plan->axes.at(0).writes());
        machine.bench.set(
            "Axes[0]/Parameters/PositionController/PositionUnit", std::string("Meter"));
        const auto outcomes = machine.apply(*plan);
        QVERIFY(outcomes.has_value());
        QVERIFY(outcomes->at(0).problem.has_value());
        QCOMPARE(outcomes->at(0).problem->code, ErrorCode::ChangedMeanwhile);
        QCOMPARE(outcomes->at(0).problem->context.english("now"), std::string("m at m, mm"));
        QVERIFY(!outcomes->at(0).now->isOn());
    }

    /// -c is what the drive adds at the set position x, and at the encoder's x + c another value.
    void theFileOfAnotherControllerIsMadeForTheSourceOfTheAxis()
    {
        const auto valueAt10 = [](const std::string& source) {
            Machine machine;
            machine.context.folder = machine.bench.folder.path().toStdString();
            std::ofstream(machine.context.folder / "x.txt")
                << "1 5\n0 0\n10 -0.5\n20 0.25\n30 -0.5\n40 0\n";
            MachineAxis& axis = machine.drive.axes[0];
            axis.file = "x.txt";
            axis.choices.format = &softmc::format();
            axis.choices.settings = {{"position-unit", "mm"}, {"value-unit", "mm"}};
            axis.sources = std::vector<std::string>{source};
            axis.acceptsLarge = true;
            machine.tables = {
                readMachineTable(axis, machine.context.folder, genericTableLayout(), std::nullopt)};
            const auto plan = machine.plan();
            if (!plan || plan->axes[0].problem || !plan->axes[0].request.table)
                return 0.0F;
            return plan->axes[0].request.table->values[1];
        };
        QCOMPARE(valueAt10("Axes[0]/Signals/PathPlanner/Position"), 0.5F);
        const float atEncoder = valueAt10(test::masterX);
        QVERIFY2(std::abs(atEncoder - 0.5F / 1.075F) < 1e-6F, std::to_string(atEncoder).c_str());
    }

    /// A PMAC table is one of a modulo axis, which the drive's table is not.
    void aModuloAxisBecomesALinearOneWhereTheFileSaysSo()
    {
        const Machine machine;
        const std::filesystem::path folder = machine.bench.folder.path().toStdString();
        std::ofstream(folder / "x.pmc") << "#1\nDEFINE COMP 4,#1,#1,40000\n16 -16 32 0\n";
        const std::string head =
            "version = 1\n[[drive]]\nendpoint = \"http://a\"\nserial = 7\n[[drive.axis]]\n"
            "axis = \"0\"\nfile = \"x.pmc\"\nformat = \"pmac-1d\"\nsign = \"command\"\n"
            "settings = { counts-per-unit = \"1000\", position-unit = \"mm\" }\nsources = [\""
            + test::masterX + "\"]\n";
        const auto read = [&folder](const std::string& text) {
            const MachineReading reading = readMachine(text);
            return reading.machine ? tableAtFirstSource(reading.machine->drives[0].axes[0], folder)
                                   : MachineTable{};
        };
        const MachineTable refused = read(head);
        QVERIFY(refused.problem.has_value());
        QCOMPARE(refused.problem->code, ErrorCode::FormatCannotHold);
        QVERIFY2(sentence(*refused.problem).find("no-wrap = true") != std::string::npos,
            sentence(*refused.problem).c_str());
        const MachineTable linear = read(head + "no-wrap = true\n");
        QVERIFY2(linear.table, linear.problem ? sentence(*linear.problem).c_str() : "");
        QCOMPARE(linear.table->grid.axes[0].size, 5U);
    }

    /// A file of a whole machine has rotary axes, too, which the drive's tables cannot be.
    void aTableOfAFileIsReadWithoutTheOthers()
    {
        const Machine machine;
        const std::filesystem::path folder = machine.bench.folder.path().toStdString();
        std::ofstream(folder / "all.mpf")
            << "$AA_ENC_COMP[0,0,A1]=0.25\n$AA_ENC_COMP[0,1,A1]=0.5\n$AA_ENC_COMP[0,2,A1]=0.25\n"
               "$AA_ENC_COMP_STEP[0,A1]=180\n$AA_ENC_COMP_MIN[0,A1]=0\n"
               "$AA_ENC_COMP_MAX[0,A1]=360\n$AA_ENC_COMP_IS_MODULO[0,A1]=1\n"
               "$AA_ENC_COMP[0,0,X1]=0\n$AA_ENC_COMP[0,1,X1]=0.001\n"
               "$AA_ENC_COMP_STEP[0,X1]=10\n$AA_ENC_COMP_MIN[0,X1]=0\n"
               "$AA_ENC_COMP_MAX[0,X1]=10\nM17\n";
        std::ofstream(folder / "two.csv")
            << "X [mm],X error [mm],Y error [mm]\n0,0,1\n10,0.001,2\n";
        MachineAxis axis;
        axis.sources = std::vector<std::string>{test::masterX};
        const auto read = [&](const char* file, const char* column) {
            axis.file = file;
            axis.column = column;
            return tableAtFirstSource(axis, folder);
        };
        const std::vector<float> values{0.0F, 0.001F};
        for (const char* column : {"X1", "X1, encoder 0", "2", "#2"}) {
            const MachineTable table = read("all.mpf", column);
            QVERIFY2(table.table, table.problem ? sentence(*table.problem).c_str() : "");
            QCOMPARE(table.table->values, values);
        }
        QCOMPARE(read("all.mpf", "A1").problem.value().code, ErrorCode::FormatCannotHold);
        const Error unknown = read("all.mpf", "Z1").problem.value();
        QCOMPARE(unknown.code, ErrorCode::TableNotFound);
        const std::string known = "1 (A1, encoder 0), 2 (X1, encoder 0)";
        QVERIFY2(sentence(unknown).find(known) != std::string::npos, sentence(unknown).c_str());
        const Error unnamed = read("all.mpf", "").problem.value();
        QCOMPARE(unnamed.code, ErrorCode::InvalidArgument);
        QVERIFY2(sentence(unnamed).find(known) != std::string::npos, sentence(unnamed).c_str());
        const MachineTable ofCsv = read("two.csv", "X error");
        QVERIFY2(ofCsv.table, ofCsv.problem ? sentence(*ofCsv.problem).c_str() : "");
        QCOMPARE(ofCsv.table->values, values);
        QCOMPARE(read("two.csv", "2").table.value().name, std::string("Y error"));
    }

    /// As of --table: none of them is meant more than another.
    void aNameThatSeveralTablesOfAFileHaveIsRefused()
    {
        const Machine machine;
        const std::filesystem::path folder = machine.bench.folder.path().toStdString();
        std::ofstream(folder / "two.mpf")
            << "$AA_ENC_COMP[0,0,X1]=0\n$AA_ENC_COMP[0,1,X1]=0.001\n"
               "$AA_ENC_COMP_STEP[0,X1]=10\n$AA_ENC_COMP_MIN[0,X1]=0\n"
               "$AA_ENC_COMP_MAX[0,X1]=10\n"
               "$AA_ENC_COMP[1,0,X1]=0\n$AA_ENC_COMP[1,1,X1]=0.002\n"
               "$AA_ENC_COMP_STEP[1,X1]=10\n$AA_ENC_COMP_MIN[1,X1]=0\n"
               "$AA_ENC_COMP_MAX[1,X1]=10\nM17\n";
        MachineAxis axis;
        axis.file = "two.mpf";
        axis.sources = std::vector<std::string>{test::masterX};
        const auto read = [&](const char* column) {
            axis.column = column;
            return tableAtFirstSource(axis, folder);
        };
        const MachineTable refused = read("X1");
        QVERIFY2(refused.problem, "a table was taken of two that have the name");
        QCOMPARE(refused.problem->code, ErrorCode::TableAmbiguous);
        const std::string said = sentence(*refused.problem);
        QVERIFY2(said.find("#1: 1 (X1, encoder 0), 2 (X1, encoder 1)") != std::string::npos,
            said.c_str());
        const std::vector<float> values{0.0F, 0.002F};
        for (const char* column : {"#2", "X1, encoder 1"}) {
            const MachineTable table = read(column);
            QVERIFY2(table.table, table.problem ? sentence(*table.problem).c_str() : "");
            QCOMPARE(table.table->values, values);
        }
    }

    /// Where the sign is converted, values are added to positions: what is stated comes first.
    void statedUnitsAreThoseOfTheFileBeforeItIsConverted()
    {
        Machine machine;
        machine.context.folder = machine.bench.folder.path().toStdString();
        std::ofstream(machine.context.folder / "x.txt")
            << "1 5\n0 0\n10000 -500\n20000 250\n30000 -500\n40000 0\n";
        MachineAxis& axis = machine.drive.axes[0];
        axis.file = "x.txt";
        axis.choices.format = &softmc::format();
        axis.choices.settings = {{"position-unit", "um"}};
        axis.choices.units = {"um", {}};
        axis.sources = std::vector<std::string>{test::masterX};
        axis.acceptsLarge = true;
        const auto read = [&] {
            return readMachineTable(axis, machine.context.folder, genericTableLayout(),
                AxisPlace{"#1", LookupAt::Encoder});
        };
        const MachineTable table = read();
        QVERIFY2(table.table, table.problem ? sentence(*table.problem).c_str() : "");
        const float value = table.table->values[1];
        QVERIFY2(std::abs(value - 500.0F / 1.075F) < 1e-3F, std::to_string(value).c_str());
        QCOMPARE(table.table->unit, "um");

        // Nobody knows then what is to be added to a position in um.
        axis.choices.units = {std::string(unitOfDrive), {}};
        const MachineTable refused = read();
        QVERIFY(refused.problem.has_value());
        QVERIFY2(sentence(*refused.problem).find("are said to be in the unit of the drive")
                != std::string::npos,
            sentence(*refused.problem).c_str());
        // Nor is a setting overruled.
        axis.choices.settings = {{"position-unit", "mm"}, {"value-unit", "mm"}};
        axis.choices.units = {"um", {}};
        const MachineTable contradicted = read();
        QVERIFY(contradicted.problem.has_value());
        QVERIFY2(sentence(*contradicted.problem).find("the setting value-unit says mm")
                != std::string::npos,
            sentence(*contradicted.problem).c_str());
        // The unit of the drive is none of the file, and would be taken for none at all.
        axis.choices.settings = {{"position-unit", "mm"}, {"value-unit", std::string(unitOfDrive)}};
        axis.choices.units = {};
        const MachineTable setting = read();
        QVERIFY(setting.problem.has_value());
        QVERIFY2(sentence(*setting.problem).find("value-unit is \"drive\"") != std::string::npos,
            sentence(*setting.problem).c_str());
        axis.choices.settings = {};
        axis.choices.units = {std::string(unitOfDrive), std::string(unitOfDrive)};
        const MachineTable ofDrive = read();
        QVERIFY(
            ofDrive.table.has_value() || ofDrive.problem->code == ErrorCode::SignNotConvertible);
    }

    /// LinuxCNC and a PMAC add the values to the positions, so that one of two units is wrong by a
    /// factor, whether a setting or the machine file says it.
    void twoUnitsThatAreStatedForOneAxisAreRefused_data()
    {
        QTest::addColumn<QString>("format");
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<FormatSettings>("settings");
        QTest::newRow("linuxcnc") << "linuxcnc" << QByteArray("0 0 0\n100 0.02 0.02\n")
                                  << FormatSettings{{"type", "1"}};
        QTest::newRow("pmac-1d") << "pmac-1d"
                                 << QByteArray("#1\nDEFINE COMP 4,#1,#1,40000\n16 -16 32 0\n")
                                 << FormatSettings{{"counts-per-unit", "1000"}};
    }
    void twoUnitsThatAreStatedForOneAxisAreRefused()
    {
        QFETCH(QString, format);
        QFETCH(QByteArray, content);
        QFETCH(FormatSettings, settings);
        const Machine machine;
        const std::filesystem::path folder = machine.bench.folder.path().toStdString();
        std::ofstream(folder / "x.txt") << content.constData();
        MachineAxis axis;
        axis.file = "x.txt";
        axis.choices.format = *formatNamed(format.toStdString());
        axis.choices.settings = settings;
        axis.choices.sign = SignConvention::Command;
        axis.choices.dropsWrap = true;
        axis.sources = std::vector<std::string>{test::masterX};
        const auto read = [&](const StatedUnits& stated) {
            axis.choices.units = stated;
            return tableAtFirstSource(axis, folder);
        };
        const MachineTable refused = read({.values = "um", .positions = "mm"});
        QVERIFY(!refused.table);
        QVERIFY(std::ranges::any_of(refused.problems, [](const Diagnostic& problem) {
            return problem.code == DiagnosticCode::Contradiction;
        }));
        const MachineTable taken = read({.values = "mm", .positions = "mm"});
        QVERIFY2(taken.table, taken.problem ? sentence(*taken.problem).c_str() : "");
        QCOMPARE(taken.table->unit, "mm");
    }

    /// 5.5 um over 100 mm are no mistake of units.
    void unitsThatAreStatedCountForTheWarningsOfAFile()
    {
        const Machine machine;
        const std::filesystem::path folder = machine.bench.folder.path().toStdString();
        std::ofstream(folder / "x.csv") << "X;dX\n0;1,5\n0,1;-2,5\n0,2;3\n";
        MachineAxis axis;
        axis.file = "x.csv";
        axis.sources = std::vector<std::string>{test::masterX};
        axis.choices.format = &calibration_csv::format();
        const auto read = [&] {
            return readMachineTable(axis, folder, genericTableLayout(), std::nullopt);
        };
        const auto problems = [&] { return read().problems; };
        QCOMPARE(problems().size(), std::size_t{1});
        axis.choices.units = {"um", "m"};
        QVERIFY(problems().empty());
        axis.choices.units = {};
        axis.choices.settings = {{"position-unit", "m"}, {"value-unit", "um"}};
        QVERIFY(problems().empty());
        // Neither overrules the other.
        axis.choices.units = {"m", {}};
        const MachineTable contradicted = read();
        QVERIFY(contradicted.problem.has_value());
        QVERIFY2(sentence(*contradicted.problem).find("the setting value-unit says um")
                != std::string::npos,
            sentence(*contradicted.problem).c_str());
    }

    /// "value_unit" left the numbers in the unit of the axis: 0.2 mm in place of 0.2 um.
    void aSettingThatTheFormatDoesNotHaveIsAnError_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<bool>("isKnown");
        for (const char* file : {"x.csv", "x.TAMtbl"})
            for (const bool isKnown : {false, true})
                QTest::addRow("%s, %s", file, isKnown ? "known" : "unknown") << file << isKnown;
    }
    void aSettingThatTheFormatDoesNotHaveIsAnError()
    {
        QFETCH(const QString, file);
        QFETCH(const bool, isKnown);
        Machine machine;
        machine.context.folder = machine.bench.folder.path().toStdString();
        MachineAxis& axis = machine.drive.axes[0];
        axis.file = file.toStdString();
        axis.sources = std::vector<std::string>{test::masterX};
        if (axis.file == "x.csv")
            axis.choices.format = &calibration_csv::format();
        axis.choices.settings = {{isKnown ? "value-unit" : "value_unit", "um"}};
        const auto bytes = encodeTamTable(test::exampleTable(1), false, genericTableLayout());
        QVERIFY(bytes.has_value());
        std::ofstream stream(machine.context.folder / axis.file, std::ios::binary);
        if (axis.file == "x.csv")
            stream << "X [mm],X error\n0,0\n10,0.2\n20,0\n";
        else
            stream << asText(*bytes);
        stream.close();
        const MachineTable table =
            readMachineTable(axis, machine.context.folder, genericTableLayout(), std::nullopt);
        QCOMPARE(table.table.has_value(), isKnown);
        QCOMPARE(table.problem.has_value(), !isKnown);
        if (isKnown)
            QCOMPARE(table.table->unit, "um");
        else
            QVERIFY2(
                sentence(*table.problem).find("has no setting value_unit") != std::string::npos,
                sentence(*table.problem).c_str());
    }

    void aToleranceIsOfTheValuesAndNotOfTheSlot()
    {
        Machine machine;
        VERIFY_RESULT(machine.bench.compensator.write(0, test::exampleRequest(2)));
        const auto status = machine.bench.compensator.status(0);
        VERIFY_RESULT(status);
        MachineAxis& axis = machine.drive.axes[0];
        axis.tolerance = ValueTolerance{1000.0, "mm"};
        axis.acceptsLarge = true;
        axis.slot = status->setup.slot;
        const auto same = machine.plan();
        VERIFY_RESULT(same);
        QVERIFY(!same->axes.at(0).problem);
        QVERIFY(!same->differs());
        axis.slot = status->setup.slot == "Small5" ? "Small6" : "Small5";
        const auto other = machine.plan();
        VERIFY_RESULT(other);
        QVERIFY(!other->axes.at(0).problem);
        QVERIFY(other->axes[0].writes());
        QCOMPARE(other->axes[0].plan.after.slot, axis.slot);
    }

    void aLargeCorrectionIsConfirmedInTheFileAndNowhereElse()
    {
        Machine machine;
        machine.tables[0].table->values[3] = 5.0F;
        const auto plan = machine.plan();
        QVERIFY(plan.has_value());
        const auto& obstacle = plan->axes.at(0).obstacle;
        QVERIFY(obstacle.has_value());
        QCOMPARE(obstacle->code, ErrorCode::LargeCorrection);
        const std::string said = sentence(*obstacle);
        QVERIFY2(
            said.find("accept-large = true for axis 0 in the machine file") != std::string::npos,
            said.c_str());
        QVERIFY2(said.find("preview") == std::string::npos, said.c_str());
    }

    void aTableThatAnotherAxisOfTheFileStoresIsNotSaidToBeLost()
    {
        Machine machine;
        for (const int axis : {0, 1})
            VERIFY_RESULT(machine.bench.compensator.write(axis, test::exampleRequest()));
        machine.drive.axes[0].persistency = Persistency::Persistent;
        machine.drive.axes.push_back(machine.drive.axes[0]);
        machine.drive.axes[1].axis = "1";
        machine.tables.push_back(machine.tables[0]);
        const auto isOneLost = [&machine] {
            const auto plan = machine.plan();
            return plan
                && std::ranges::any_of(plan->axes.at(0).plan.warnings, [](const Text& warning) {
                       return warning.english().find("after a reboot that axis has no table")
                           != std::string::npos;
                   });
        };
        QVERIFY(!isOneLost());
        machine.drive.axes[1].persistency = Persistency::Volatile;
        QVERIFY(isOneLost());
    }

    void theFlashOperationsOfAllAxesAreCountedTogether()
    {
        Machine machine;
        const int limit = drivecomm::genericProfile().flashWear.operations;
        for (int n = 0; n + 1 < limit; ++n)
            VERIFY_RESULT(machine.bench.compensator.write(
                0, test::exampleRequest(10 + n, Persistency::Persistent)));
        machine.drive.axes[0].persistency = Persistency::Persistent;
        const auto one = machine.plan();
        VERIFY_RESULT(one);
        QCOMPARE(one->axes.at(0).plan.flashOperations, 1);
        QVERIFY(!one->obstacle);

        machine.drive.axes.push_back(machine.drive.axes[0]);
        machine.drive.axes[1].axis = "1";
        machine.tables.push_back(machine.tables[0]);
        const auto two = machine.plan();
        VERIFY_RESULT(two);
        QCOMPARE(two->axes.at(1).plan.flashOperations, 1);
        QVERIFY(two->obstacle);
        QCOMPARE(two->obstacle->code, ErrorCode::FlashWear);
    }

    /// A reboot has taken the volatile table of an axis whose parameters were saved.
    void aSnapshotOfAnAxisThatNamesAnEmptySlotIsWhatTheDriveHas()
    {
        Machine machine;
        CompensatorFixture& bench = machine.bench;
        VERIFY_RESULT(bench.compensator.write(0, test::exampleRequest()));
        bench.set("General/Commands/SaveParameters", std::string("Save"));
        bench.drive.reboot();
        QVERIFY(!bench.compensator.status(0)->setup.slot.empty());
        QVERIFY(!bench.compensator.status(0)->table.has_value());
        const auto snapshot = snapshotDrive(
            bench.compensator, drivecomm::genericProfile(), machine.context.storeRoot, "demo:", {});
        VERIFY_RESULT(snapshot);
        machine.drive = snapshot->drive;
        machine.tables.assign(machine.drive.axes.size(), {});
        const auto plan = machine.plan();
        VERIFY_RESULT(plan);
        QVERIFY(!plan->differs());
        // Other sources are written, and the name goes with that.
        machine.drive.axes[0].sources = std::vector<std::string>{test::masterX};
        const auto changed = machine.plan();
        VERIFY_RESULT(changed);
        QVERIFY(changed->axes[0].differs());
        QVERIFY(changed->axes[0].plan.after.slot.empty());
    }

    /// Neither an axis of another name nor one with another unit vanishes from what is watched.
    void anAxisThatCannotBeComparedIsAMetric()
    {
        Machine machine;
        machine.drive.axes.push_back(machine.drive.axes[0]);
        machine.drive.axes[1].axis = "1";
        machine.drive.axes.push_back(machine.drive.axes[0]);
        machine.drive.axes[2].axis = "Q";
        machine.tables = std::vector(3, machine.tables[0]);
        machine.tables[1].table->unit = "deg"; // the axes are in mm
        VERIFY_RESULT(machine.bench.compensator.write(0, test::exampleRequest()));
        const auto plan = machine.plan();
        VERIFY_RESULT(plan);
        DriveMetrics metrics;
        metrics.endpoint = "demo:";
        auto summary = summarizeDrive(machine.bench.compensator, machine.context.storeRoot, {});
        VERIFY_RESULT(summary);
        metrics.summary = *std::move(summary);
        addComparison(*plan, metrics);
        const std::string text = openMetrics(std::vector{metrics});
        const std::string drive = R"({endpoint="demo:",drive="Test-1",serial="4711",)";
        for (const std::string& line : {"axiscomp_axis_differs" + drive + R"(axis="0",name="X"} 0)",
                 "axiscomp_axis_comparable" + drive + R"(axis="0",name="X"} 1)",
                 "axiscomp_axis_differs" + drive + R"(axis="1",name="Y"} 1)",
                 "axiscomp_axis_comparable" + drive + R"(axis="1",name="Y"} 0)",
                 "axiscomp_axis_differs" + drive + R"(name="Q"} 1)",
                 "axiscomp_axis_comparable" + drive + R"(name="Q"} 0)"})
            QVERIFY2(text.find(line + "\n") != std::string::npos, (line + "\n" + text).c_str());
        // Named a second time, by its name.
        machine.drive.axes[2].axis = "X";
        const auto twice = machine.plan();
        VERIFY_RESULT(twice);
        DriveMetrics ofTwice;
        addComparison(*twice, ofTwice);
        QVERIFY(!ofTwice.differs.at(0).has_value());
    }

    /// A file of a table has no units; the numbers are those that the axis had.
    void aSnapshotOfWhatNoCsvHoldsStatesTheUnits()
    {
        Machine machine;
        WriteRequest request = test::exampleRequest();
        request.table->grid.axes[0].start = -1361.0;
        request.table->grid.axes[0].distance = 0.1 + 1e-13;
        VERIFY_RESULT(machine.bench.compensator.write(0, request));
        const auto snapshot = snapshotDrive(machine.bench.compensator, drivecomm::genericProfile(),
            machine.context.storeRoot, "demo:", {});
        VERIFY_RESULT(snapshot);
        const MachineAxis& axis = snapshot->drive.axes.at(0);
        QVERIFY2(axis.file.ends_with(".TAMtbl"), axis.file.c_str());
        QCOMPARE(axis.choices.units.values, std::string("mm"));
        QCOMPARE(axis.choices.units.positions, std::string("mm"));
    }

    /// The table is called as that of another axis, and its distance is none that the positions
    /// give back to the last bit.
    void aSnapshotOfWhatNoCsvHoldsIsWhatTheDriveHas()
    {
        Machine machine;
        CompensatorFixture& bench = machine.bench;
        WriteRequest request;
        request.sources = {test::masterX};
        request.table = test::exampleTable(1, 1, 4);
        request.table->name = "Y error";
        request.table->target = "#1";
        request.table->values.assign(4, 0.001F);
        request.table->grid.axes[0].start = 9.26409106271656;
        request.table->grid.axes[0].distance = 1.2607628851577706;
        VERIFY_RESULT(bench.compensator.write(0, request));
        const auto snapshot = snapshotDrive(
            bench.compensator, drivecomm::genericProfile(), machine.context.storeRoot, "demo:", {});
        VERIFY_RESULT(snapshot);
        const MachineAxis& axis = snapshot->drive.axes.at(0);
        QVERIFY2(axis.file.ends_with(".TAMtbl"), axis.file.c_str());
        QCOMPARE(axis.choices.target, std::string("#1"));
        machine.takeFrom(*snapshot);
        const auto plan = machine.plan();
        VERIFY_RESULT(plan);
        QVERIFY(!plan->axes.at(0).problem.has_value());
        QVERIFY(!plan->differs());
    }

    void aSnapshotOfATableWithACommaInItsNameCanBePlanned()
    {
        Machine machine;
        CompensatorFixture& bench = machine.bench;
        WriteRequest request;
        request.sources = {test::masterX};
        request.table = test::exampleTable(1);
        request.table->name = "X error, laser 3";
        VERIFY_RESULT(bench.compensator.write(0, request));
        const auto snapshot = snapshotDrive(
            bench.compensator, drivecomm::genericProfile(), machine.context.storeRoot, "demo:", {});
        VERIFY_RESULT(snapshot);
        const MachineAxis& axis = snapshot->drive.axes.at(0);
        QVERIFY2(axis.file.ends_with(".csv"), axis.file.c_str());
        QCOMPARE(axis.choices.format, &calibration_csv::format());
        machine.takeFrom(*snapshot);
        const auto plan = machine.plan();
        VERIFY_RESULT(plan);
        QVERIFY(!plan->axes.at(0).problem.has_value());
        QVERIFY(!plan->differs());
    }

    /// Index 1 is axis "2": the number alone would be a question.
    void aSnapshotNamesAxesAsApplyTakesThem()
    {
        CompensatorFixture bench({"1", "2"});
        WriteRequest request = test::exampleRequest();
        for (const int axis : {0, 1})
            VERIFY_RESULT(bench.compensator.write(axis, request));
        const auto snapshot = snapshotDrive(
            bench.compensator, drivecomm::genericProfile(), bench.storeRoot(), "demo:", {});
        VERIFY_RESULT(snapshot);
        QCOMPARE(snapshot->drive.axes.size(), std::size_t{2});
        QCOMPARE(snapshot->drive.axes.at(1).axis, std::string("index:1"));
        QCOMPARE(snapshot->drive.axes.at(1).file.substr(0, 10), std::string("4711-axis1"));
        for (const int axis : {0, 1}) {
            const std::string& name = snapshot->drive.axes.at(static_cast<std::size_t>(axis)).axis;
            QCOMPARE(bench.compensator.findAxis(name).value_or(-1), axis);
        }
    }

    void whatNoMachineFileCanHaveIsSaidOfTheNameOrOfTheDrives()
    {
        CompensatorFixture bench;
        const auto snapshot = snapshotDrive(
            bench.compensator, drivecomm::genericProfile(), bench.storeRoot(), "demo:", {});
        VERIFY_RESULT(snapshot);
        VERIFY_RESULT(joinSnapshots("Mill", {*snapshot}));
        const auto named = joinSnapshots("Mi\x7fll", {*snapshot});
        VERIFY_ERROR(named, ErrorCode::InvalidArgument);
        QVERIFY(sentence(named.error()).starts_with("a machine cannot be called Mi"));
        const auto twice = joinSnapshots("Mill", {*snapshot, *snapshot});
        VERIFY_ERROR(twice, ErrorCode::InvalidArgument);
        QVERIFY(sentence(twice.error()).starts_with("these drives make no machine: "));
    }

    void aTableWithoutASourceIsSaidOfItsAxis()
    {
        CompensatorFixture bench;
        const auto written = bench.compensator.write(0, test::exampleRequest());
        VERIFY_RESULT(written);
        bench.set("Axes[1]/Parameters/Compensations/Axis/Table", written->now.setup.slot);
        const auto refused = snapshotDrive(
            bench.compensator, drivecomm::genericProfile(), bench.storeRoot(), "demo:", {});
        VERIFY_ERROR(refused, ErrorCode::SourceMissing);
        QCOMPARE(sentence(refused.error()),
            std::string("the source of dimension 1 of axis 1 is missing"));
    }

    /// X fails because somebody has changed it, and Y is never come to.
    void anAxisThatWasToBeSwitchedAndWasNotIsNotDone()
    {
        Machine machine;
        machine.context.activates = true;
        auto& compensator = machine.bench.compensator;
        VERIFY_RESULT(compensator.write(1, test::exampleRequest()));
        MachineAxis second = machine.drive.axes[0];
        second.axis = "1";
        second.isActive = true;
        machine.drive.axes.push_back(second);
        machine.tables.push_back(MachineTable{});
        machine.tables[1].table = test::exampleTable(2);
        const auto plan = machine.plan();
        VERIFY_RESULT(plan);
        QVERIFY(!plan->axes.at(1).writes());
        QVERIFY(plan->axes[1].switches == std::optional(Switch::Activate));
        VERIFY_RESULT(compensator.write(0, test::exampleRequest(2)));
        const auto outcomes = machine.apply(*plan);
        VERIFY_RESULT(outcomes);
        QCOMPARE(outcomeText(outcomes->at(0)).english(), std::string("failed"));
        QCOMPARE(outcomeText(outcomes->at(1)).english(), std::string("not switched"));

        // Nobody has asked for it.
        machine.context.activates = false;
        const auto unasked = machine.apply(*plan);
        VERIFY_RESULT(unasked);
        QCOMPARE(outcomeText(unasked->at(1)).english(), std::string("nothing to do"));
    }

    void whatWasWrittenAndWhatWasSwitchedAreToldApart()
    {
        const auto said = [](bool isWritten, bool isSwitched, bool awaitsWrite, bool awaitsSwitch) {
            AxisOutcome outcome;
            if (isWritten)
                outcome.report.emplace();
            if (isSwitched)
                outcome.activation.emplace();
            outcome.awaitsWrite = awaitsWrite;
            outcome.awaitsSwitch = awaitsSwitch;
            return outcomeText(outcome).english();
        };
        QCOMPARE(said(true, true, false, false), std::string("written and switched"));
        QCOMPARE(said(true, false, false, true), std::string("written, not switched"));
        QCOMPARE(said(false, true, true, false), std::string("switched, not written"));
        QCOMPARE(said(false, true, false, false), std::string("switched"));
        QCOMPARE(said(false, false, true, true), std::string("not written"));
        QCOMPARE(said(false, false, false, false), std::string("nothing to do"));
    }

    /// Outside of its table an axis shows nothing, whatever the drive does with it.
    void whatIsSwitchedOnIsProvedOrSaidNotToBe_data()
    {
        QTest::addColumn<double>("start");
        QTest::addColumn<bool>("isProved");
        QTest::newRow("around the axes") << 0.0 << true;
        QTest::newRow("elsewhere") << -2000.0 << false;
    }
    void whatIsSwitchedOnIsProvedOrSaidNotToBe()
    {
        QFETCH(const double, start);
        QFETCH(const bool, isProved);
        Machine machine;
        Grid& grid = machine.tables[0].table->grid;
        for (GridAxis& axis : grid.axes)
            axis.distance *= 2.5;
        grid.axes[0].start = start;
        machine.drive.axes[0].isActive = true;
        machine.context.activates = true;
        const auto plan = machine.plan();
        VERIFY_RESULT(plan);
        const auto outcomes = machine.apply(*plan);
        VERIFY_RESULT(outcomes);
        const AxisOutcome& outcome = outcomes->at(0);
        QVERIFY(!outcome.problem && outcome.activation);
        QCOMPARE(outcome.activation->notProved().has_value(), !isProved);
        QCOMPARE(outcomeText(outcome).english(),
            std::string("written and switched, ") + (isProved ? "proved" : "not proved"));
        machine.drive.axes[0].isActive = false;
        const auto back = machine.plan();
        VERIFY_RESULT(back);
        const auto off = machine.apply(*back);
        VERIFY_RESULT(off);
        QCOMPARE(outcomeText(off->at(0)).english(), std::string("switched"));
    }

    void anAxisThatNobodyHasChangedIsSwitchedOn()
    {
        Machine machine;
        machine.drive.axes[0].isActive = true;
        machine.context.activates = true;
        QVERIFY(machine.bench.compensator.write(0, test::exampleRequest()).has_value());
        const auto plan = machine.plan();
        QVERIFY(plan.has_value());
        const auto outcomes = machine.apply(*plan);
        QVERIFY(outcomes.has_value());
        QVERIFY(!outcomes->at(0).problem.has_value());
        QVERIFY(outcomes->at(0).now->isOn());
    }
};

AXISCOMP_TEST(TestMachinePlan)

} // namespace tst_machineplan

#include "tst_machineplan.moc"
