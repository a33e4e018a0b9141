// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/lookup.h"
#include "drivecomm/virtualdrive/demo_link.h"
#include "tests/drivecomm/virtualdrive/drive_fixture.h"
#include "tests/support/test_registry.h"

#include <atomic>
#include <cmath>
#include <set>
#include <thread>

namespace tst_virtualdrive {

using namespace axiscomp;
using namespace axiscomp::test;

/// What the virtual drive does as time passes (docs/drive.md, "Behaviour").
class TestVirtualDrive : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void axesMoveOverTheirRange();
    void signalsAreThoseOfTheLastTick();
    void timeNeverGoesBack();
    void rampsInLinearly_data();
    void rampsInLinearly();
    void rampsOutLinearly_data();
    void rampsOutLinearly();
    void turnsRoundHalfWay();
    void evaluateRampsOutFirst();
    void evaluateShowsIndicesAndAddsNothing();
    void outputIsTheLookupAtTheSourcesReadWithIt_data();
    void outputIsTheLookupAtTheSourcesReadWithIt();
    void theEncodersMoveByTheOppositeOfTheOutputs();
    void theSumIsNoSource();
    void holdsTheEndsOutsideTheTable();
    void checksBeforeItActivates_data();
    void checksBeforeItActivates();
    void needsHomingToActivate();
    void errorStaysUntilTheNextActivation();
    void checksAgainWhileEvaluating_data();
    void checksAgainWhileEvaluating();
    void refusesChangesWhileOn_data();
    void refusesChangesWhileOn();
    void allowsOtherChangesWhileOn();
    void valuesTakeEffectBeforeCommands();
    void takesAFileWholeOrNotAtAll_data();
    void takesAFileWholeOrNotAtAll();
    void showsTheHeaderOfTheTable();
    void storesSomethingElseOnce();
    void loseACommandWhenStoringWrong();
    void demoDriveIsActive();
    void manyThreadsSeeOneInstant();
};

void TestVirtualDrive::axesMoveOverTheirRange()
{
    DriveFixture bench;
    double lowest = 1e9;
    double highest = -1e9;
    for (int second = 0; second < 62; ++second) {
        bench.time = std::chrono::seconds(second);
        const double x = bench.number(masterOf0);
        const double y = bench.number(masterOf1);
        QVERIFY(x >= 0.0 && x <= 100.0 && y >= 0.0 && y <= 100.0);
        QVERIFY2(std::abs(x - y) > 1e-6, "two axes that move alike");
        lowest = std::min(lowest, x);
        highest = std::max(highest, x);
        const double temperature = bench.number(axisPath(0, "Signals/General/MotorTemperature"));
        QVERIFY(temperature > 30.0 && temperature < 45.0);
        const double second1 =
            bench.number(axisPath(0, "Signals/PositionController/Encoders[1]/Position"));
        QVERIFY(second1 != x && std::abs(second1 - x) < 0.01);
        const double set = bench.number(axisPath(0, "Signals/PathPlanner/Position"));
        QVERIFY(std::abs(set - x) < 0.01);
    }
    QVERIFY(lowest < 0.2 && highest > 99.8);
}

void TestVirtualDrive::signalsAreThoseOfTheLastTick()
{
    DriveFixture bench;
    bench.time = 1700us;
    const double first = bench.number(masterOf0);
    bench.time = 1799999ns;
    QCOMPARE(bench.number(masterOf0), first);
    bench.time = 1800us;
    QVERIFY(bench.number(masterOf0) != first);
}

void TestVirtualDrive::timeNeverGoesBack()
{
    DriveFixture bench;
    bench.time = 5s;
    const double then = bench.number(masterOf0);
    bench.time = 4s;
    QCOMPARE(bench.number(masterOf0), then);
}

void TestVirtualDrive::rampsInLinearly_data()
{
    QTest::addColumn<std::chrono::nanoseconds>("after");
    QTest::addColumn<double>("output");
    QTest::addColumn<QString>("state");
    QTest::newRow("at once") << std::chrono::nanoseconds(0) << 0.0 << "Ramping";
    QTest::newRow("2.5 ms") << std::chrono::nanoseconds(2500us) << 0.125 << "Ramping";
    QTest::newRow("5 ms") << std::chrono::nanoseconds(5ms) << 0.25 << "Ramping";
    QTest::newRow("1 ns before the end")
        << std::chrono::nanoseconds(9999999ns) << static_cast<double>(0.49999995F) << "Ramping";
    QTest::newRow("10 ms") << std::chrono::nanoseconds(10ms) << 0.5 << "Active";
    QTest::newRow("a day") << std::chrono::nanoseconds(24h) << 0.5 << "Active";
}

void TestVirtualDrive::rampsInLinearly()
{
    QFETCH(std::chrono::nanoseconds, after);
    QFETCH(double, output);
    QFETCH(QString, state);
    DriveFixture bench;
    bench.time = 12345678ns; // between two ticks
    VERIFY_RESULT(bench.activate(flatTable(0.5F)));
    bench.time += after;
    QCOMPARE(bench.number(outputOf0), output);
    COMPARE_TEXT(bench.text(stateOf0), state.toStdString());
    COMPARE_TEXT(bench.text(activationOf0), "AddToEncoders");
    COMPARE_TEXT(bench.text(errorOf0), "None");
}

void TestVirtualDrive::rampsOutLinearly_data()
{
    QTest::addColumn<std::chrono::nanoseconds>("after");
    QTest::addColumn<double>("output");
    QTest::addColumn<QString>("state");
    QTest::newRow("at once") << std::chrono::nanoseconds(0) << 0.5 << "Ramping";
    QTest::newRow("5 ms") << std::chrono::nanoseconds(5ms) << 0.25 << "Ramping";
    QTest::newRow("7.5 ms") << std::chrono::nanoseconds(7500us) << 0.125 << "Ramping";
    QTest::newRow("10 ms") << std::chrono::nanoseconds(10ms) << 0.0 << "Disabled";
    QTest::newRow("a day") << std::chrono::nanoseconds(24h) << 0.0 << "Disabled";
}

void TestVirtualDrive::rampsOutLinearly()
{
    QFETCH(std::chrono::nanoseconds, after);
    QFETCH(double, output);
    QFETCH(QString, state);
    DriveFixture bench;
    VERIFY_RESULT(bench.activate(flatTable(0.5F)));
    bench.time = 1s;
    VERIFY_RESULT(bench.set(activationOf0, "Disabled"));
    bench.time += after;
    QCOMPARE(bench.number(outputOf0), output);
    COMPARE_TEXT(bench.text(stateOf0), state.toStdString());
}

void TestVirtualDrive::turnsRoundHalfWay()
{
    DriveFixture bench;
    VERIFY_RESULT(bench.activate(flatTable(0.5F)));
    bench.time = 5ms;
    VERIFY_RESULT(bench.set(activationOf0, "Disabled"));
    QCOMPARE(bench.number(outputOf0), 0.25);
    bench.time = 7500us;
    QCOMPARE(bench.number(outputOf0), 0.125);
    VERIFY_RESULT(bench.set(activationOf0, "AddToEncoders"));
    bench.time = 15ms;
    QCOMPARE(bench.number(outputOf0), 0.5);
    COMPARE_TEXT(bench.text(stateOf0), "Active");
}

void TestVirtualDrive::evaluateRampsOutFirst()
{
    DriveFixture bench;
    VERIFY_RESULT(bench.activate(flatTable(0.5F)));
    bench.time = 10ms;
    VERIFY_RESULT(bench.set(activationOf0, "Evaluate"));
    bench.time = 15ms;
    COMPARE_TEXT(bench.text(stateOf0), "Ramping");
    QCOMPARE(bench.number(outputOf0), 0.25);
    bench.time = 20ms;
    COMPARE_TEXT(bench.text(stateOf0), "Evaluating");
    QCOMPARE(bench.number(outputOf0), 0.0);
}

void TestVirtualDrive::evaluateShowsIndicesAndAddsNothing()
{
    DriveFixture bench;
    VERIFY_RESULT(bench.upload("Small1", evenTable(2)));
    VERIFY_RESULT(bench.select("Small1", {variable0, masterOf0}));
    QCOMPARE(bench.number(indexOf0(1)), 0.0);
    VERIFY_RESULT(bench.set(activationOf0, "Evaluate"));
    VERIFY_RESULT(bench.set(variable0, 25.0));
    COMPARE_TEXT(bench.text(stateOf0), "Evaluating");
    QCOMPARE(bench.number(indexOf0(1)), 2.5);
    QCOMPARE(bench.number(indexOf0(2)),
        static_cast<double>(static_cast<float>(bench.number(masterOf0) / 10.0)));
    QCOMPARE(bench.number(indexOf0(3)), 0.0);
    QCOMPARE(bench.number(outputOf0), 0.0);
    VERIFY_RESULT(bench.set(activationOf0, "Disabled"));
    QCOMPARE(bench.number(indexOf0(1)), 0.0);
    COMPARE_TEXT(bench.text(stateOf0), "Disabled");
}

void TestVirtualDrive::outputIsTheLookupAtTheSourcesReadWithIt_data()
{
    QTest::addColumn<int>("dimensions");
    QTest::addColumn<QStringList>("sources");
    const QString temperature =
        QString::fromStdString(axisPath(1, "Signals/General/MotorTemperature"));
    const QString encoder =
        QString::fromStdString(axisPath(1, "Signals/PositionController/Encoders[1]/Position"));
    const QString planner = QString::fromStdString(axisPath(0, "Signals/PathPlanner/Position"));
    const QString master = QString::fromStdString(masterOf0);
    QTest::newRow("1D") << 1 << QStringList{master};
    QTest::newRow("2D, another axis") << 2 << QStringList{planner, encoder};
    QTest::newRow("3D, a Single") << 3 << QStringList{master, encoder, temperature};
}

void TestVirtualDrive::outputIsTheLookupAtTheSourcesReadWithIt()
{
    QFETCH(int, dimensions);
    QFETCH(QStringList, sources);
    DriveFixture bench;
    const CompensationTable table = evenTable(dimensions);
    const Lookup lookup(table);
    std::vector<std::string> paths;
    for (const QString& source : sources)
        paths.push_back(source.toStdString());
    VERIFY_RESULT(bench.upload("Small3", table));
    VERIFY_RESULT(bench.select("Small3", paths));
    VERIFY_RESULT(bench.set(activationOf0, "AddToEncoders"));
    for (int n = 0; n < dimensions; ++n)
        paths.push_back(indexOf0(n + 1));
    paths.push_back(outputOf0);

    std::set<double> outputs;
    for (int step = 0; step < 200; ++step) {
        bench.time += 333333333ns;
        const auto read = bench.drive->readRegisters(paths);
        VERIFY_RESULT(read);
        std::vector<double> positions;
        for (int n = 0; n < dimensions; ++n)
            positions.push_back(toDouble(read->at(static_cast<std::size_t>(n)).value));
        for (int n = 0; n < dimensions; ++n) {
            const auto at = static_cast<std::size_t>(n);
            QCOMPARE(std::get<float>(read->at(at + positions.size()).value),
                static_cast<float>(lookup.index(n, positions[at])));
        }
        const float output = std::get<float>(read->back().value);
        QCOMPARE(output, static_cast<float>(lookup.at(positions)));
        outputs.insert(static_cast<double>(output));
    }
    QVERIFY(outputs.size() > 100);
}

/// Two planes over both axes: 0.1 x + 0.05 y and -0.02 x + 0.08 y. The loop holds
/// x + 0.1 x + 0.05 y = X and y - 0.02 x + 0.08 y = Y, which two linear equations solve.
void TestVirtualDrive::theEncodersMoveByTheOppositeOfTheOutputs()
{
    DriveFixture bench;
    DriveFixture off;
    const auto plane = [](float ofX, float ofY) {
        CompensationTable table;
        table.grid.axes = {{{}, {}, 0.0, 100.0, 2}, {{}, {}, 0.0, 100.0, 2}};
        table.values = {0.0F, 100.0F * ofX, 100.0F * ofY, 100.0F * (ofX + ofY)};
        return table;
    };
    VERIFY_RESULT(bench.upload("Small1", plane(0.1F, 0.05F)));
    VERIFY_RESULT(bench.upload("Small2", plane(-0.02F, 0.08F)));
    VERIFY_RESULT(bench.select("Small1", {masterOf0, masterOf1}));
    const auto ofY = [](const char* name) {
        return axisPath(1, "Parameters/Compensations/Axis/") + name;
    };
    VERIFY_RESULT(bench.drive->writeRegisters(
        {{ofY("Table"), std::string("Small2")}, {ofY("Dim1Source"), bench.address(masterOf0)},
            {ofY("Dim2Source"), bench.address(masterOf1)}}));
    VERIFY_RESULT(bench.set(activationOf0, "AddToEncoders"));
    VERIFY_RESULT(
        bench.set(axisPath(1, "Commands/Compensations/Axis/Activation"), "AddToEncoders"));
    const std::string actualOf0 = axisPath(0, "Signals/PositionController/ActualPosition");
    const std::string actualOf1 = axisPath(1, "Signals/PositionController/ActualPosition");
    for (int second = 1; second < 60; second += 7) {
        bench.time = off.time = std::chrono::seconds(second);
        const double setX = off.number(masterOf0);
        const double setY = off.number(masterOf1);
        QCOMPARE(bench.number(actualOf0), setX);
        QCOMPARE(bench.number(actualOf1), setY);
        const double determinant = 1.1 * 1.08 + 0.05 * 0.02;
        const double x = (1.08 * setX - 0.05 * setY) / determinant;
        const double y = (1.1 * setY + 0.02 * setX) / determinant;
        if (x < 0.0 || x > 100.0 || y < 0.0 || y > 100.0)
            continue; // outside of the table the ends hold
        QVERIFY2(std::abs(bench.number(masterOf0) - x) < 1e-5, qPrintable(QString::number(x)));
        QVERIFY2(std::abs(bench.number(masterOf1) - y) < 1e-5, qPrintable(QString::number(y)));
        QVERIFY(std::abs(bench.number(outputOf0) - (setX - x)) < 1e-5);
    }
    VERIFY_RESULT(bench.set(activationOf0, "Disabled"));
    bench.time += 1s;
    off.time = bench.time;
    QCOMPARE(bench.number(masterOf0), off.number(masterOf0));
}

void TestVirtualDrive::theSumIsNoSource()
{
    DriveFixture bench;
    VERIFY_RESULT(bench.upload("Small1", flatTable(0.5F)));
    VERIFY_RESULT(
        bench.select("Small1", {axisPath(0, "Signals/PositionController/ActualPosition")}));
    VERIFY_RESULT(bench.set(activationOf0, "AddToEncoders"));
    COMPARE_TEXT(bench.text(errorOf0), "BadSource");
}

void TestVirtualDrive::holdsTheEndsOutsideTheTable()
{
    DriveFixture bench;
    CompensationTable table = evenTable(1, 0.001F, 4);
    table.values = {1.0F, 2.0F, 3.0F, 4.0F};
    VERIFY_RESULT(bench.upload("Small1", table));
    VERIFY_RESULT(bench.select("Small1", {variable0}));
    VERIFY_RESULT(bench.set(activationOf0, "AddToEncoders"));
    bench.time = 10ms;
    VERIFY_RESULT(bench.set(variable0, 1e6));
    QCOMPARE(bench.number(outputOf0), 4.0);
    QCOMPARE(bench.number(indexOf0(1)), 3.0);
    VERIFY_RESULT(bench.set(variable0, -1e6));
    QCOMPARE(bench.number(outputOf0), 1.0);
    QCOMPARE(bench.number(indexOf0(1)), 0.0);
}

void TestVirtualDrive::checksBeforeItActivates_data()
{
    QTest::addColumn<QString>("slot");
    QTest::addColumn<QStringList>("sources"); // a path, "-" unset, "?" an unknown address
    QTest::addColumn<QString>("error");
    const QString x = QString::fromStdString(masterOf0);
    const QString y = QString::fromStdString(masterOf1);
    const QString variable = QString::fromStdString(variable0);
    const QString unsignedOne = QString::fromStdString(sourceOf0(1));
    const QString homing = QString::fromStdString(homingOf0);
    const QString output = QString::fromStdString(axisPath(1, "Signals/Compensations/Axis/Output"));
    const QString index = QString::fromStdString(indexOf0(1));
    const QString unset = QStringLiteral("-");
    const QString unknown = QStringLiteral("?");
    using List = QStringList;
    // Small2 holds a 2D table, Small3 is empty
    QTest::newRow("fine") << "Small2" << List{x, y} << "None";
    QTest::newRow("a Single is fine") << "Small2" << List{x, variable} << "None";
    QTest::newRow("no slot") << "Disabled" << List{x, y} << "NoTable";
    QTest::newRow("empty slot") << "Small3" << List{x, y} << "NoTable";
    QTest::newRow("no source") << "Small2" << List{} << "DimensionMismatch";
    QTest::newRow("one source too few") << "Small2" << List{x} << "DimensionMismatch";
    QTest::newRow("one source too many") << "Small2" << List{x, y, variable} << "DimensionMismatch";
    QTest::newRow("a gap first") << "Small2" << List{unset, x, y} << "BadSource";
    QTest::newRow("a gap between") << "Small2" << List{x, unset, y} << "BadSource";
    QTest::newRow("an unknown address") << "Small2" << List{x, unknown} << "BadSource";
    QTest::newRow("an UInt32") << "Small2" << List{x, unsignedOne} << "BadSource";
    QTest::newRow("an enum") << "Small2" << List{homing, y} << "BadSource";
    QTest::newRow("another axis's output") << "Small2" << List{x, output} << "BadSource";
    QTest::newRow("its own index") << "Small2" << List{index, y} << "BadSource";
}

void TestVirtualDrive::checksBeforeItActivates()
{
    QFETCH(QString, slot);
    QFETCH(QStringList, sources);
    QFETCH(QString, error);
    DriveFixture bench;
    VERIFY_RESULT(bench.upload("Small2", evenTable(2)));
    std::vector<RegisterWrite> writes{{tableOf0, slot.toStdString()}};
    for (int n = 0; n < sources.size(); ++n)
        writes.push_back({sourceOf0(n + 1),
            sources[n] == u"-"       ? 0U
                : sources[n] == u"?" ? 0x4000'0002U
                                     : bench.address(sources[n].toStdString())});
    VERIFY_RESULT(bench.drive->writeRegisters(writes));
    for (const char* activation : {"Evaluate", "AddToEncoders"}) {
        VERIFY_RESULT(bench.set(activationOf0, activation));
        bench.time += 20ms;
        COMPARE_TEXT(bench.text(errorOf0), error.toStdString());
        const bool fine = error == u"None";
        const bool adds = activation == std::string("AddToEncoders");
        COMPARE_TEXT(bench.text(stateOf0), fine ? (adds ? "Active" : "Evaluating") : "Error");
        COMPARE_TEXT(bench.text(activationOf0), activation);
        if (!fine) {
            QCOMPARE(bench.number(outputOf0), 0.0);
            QCOMPARE(bench.number(indexOf0(1)), 0.0);
        }
    }
    VERIFY_RESULT(bench.set(activationOf0, "Disabled"));
    bench.time += 20ms;
    COMPARE_TEXT(bench.text(errorOf0), "None");
    COMPARE_TEXT(bench.text(stateOf0), "Disabled");
}

void TestVirtualDrive::needsHomingToActivate()
{
    DriveFixture bench;
    bench.options.axes[0].homed = false;
    bench.start();
    COMPARE_TEXT(bench.text(homingOf0), "NotHomed");
    VERIFY_RESULT(bench.activate(flatTable(0.5F)));
    COMPARE_TEXT(bench.text(stateOf0), "Error");
    COMPARE_TEXT(bench.text(errorOf0), "NotHomed");
    VERIFY_RESULT(bench.set(activationOf0, "Evaluate"));
    COMPARE_TEXT(bench.text(stateOf0), "Evaluating");

    VERIFY_RESULT(bench.set(homeAxis0, "Start"));
    bench.time = 999999999ns;
    COMPARE_TEXT(bench.text(homingOf0), "Homing");
    VERIFY_RESULT(bench.set(activationOf0, "AddToEncoders"));
    COMPARE_TEXT(bench.text(errorOf0), "NotHomed");
    bench.time = 1s;
    COMPARE_TEXT(bench.text(homingOf0), "HomingDone");
    VERIFY_RESULT(bench.set(activationOf0, "AddToEncoders"));
    COMPARE_TEXT(bench.text(stateOf0), "Ramping");
}

void TestVirtualDrive::errorStaysUntilTheNextActivation()
{
    DriveFixture bench;
    VERIFY_RESULT(bench.select("Small1", {masterOf0}));
    VERIFY_RESULT(bench.set(activationOf0, "AddToEncoders"));
    COMPARE_TEXT(bench.text(errorOf0), "NoTable");
    VERIFY_RESULT(bench.upload("Small1", flatTable(0.5F)));
    bench.time = 1s;
    COMPARE_TEXT(bench.text(stateOf0), "Error");
    QCOMPARE(bench.number(outputOf0), 0.0);
    VERIFY_RESULT(bench.set(activationOf0, "AddToEncoders"));
    bench.time += 10ms;
    COMPARE_TEXT(bench.text(stateOf0), "Active");
}

void TestVirtualDrive::checksAgainWhileEvaluating_data()
{
    QTest::addColumn<int>("change");
    QTest::addColumn<QString>("error");
    QTest::newRow("table deleted") << 0 << "NoTable";
    QTest::newRow("table of another dimension") << 1 << "DimensionMismatch";
    QTest::newRow("source unset") << 2 << "DimensionMismatch";
    QTest::newRow("source unknown") << 3 << "BadSource";
    QTest::newRow("another slot") << 4 << "NoTable";
    QTest::newRow("another table") << 5 << "None";
}

void TestVirtualDrive::checksAgainWhileEvaluating()
{
    QFETCH(int, change);
    QFETCH(QString, error);
    DriveFixture bench;
    VERIFY_RESULT(bench.upload("Small1", evenTable(1)));
    VERIFY_RESULT(bench.select("Small1", {masterOf0}));
    VERIFY_RESULT(bench.set(activationOf0, "Evaluate"));
    COMPARE_TEXT(bench.text(stateOf0), "Evaluating");
    if (change == 0)
        VERIFY_RESULT(bench.set(slotPath("Small1", "Command"), "Delete"));
    if (change == 1)
        VERIFY_RESULT(bench.upload("Small1", evenTable(2)));
    if (change == 2)
        VERIFY_RESULT(bench.set(sourceOf0(1), std::uint32_t{0}));
    if (change == 3)
        VERIFY_RESULT(bench.set(sourceOf0(1), std::uint32_t{1}));
    if (change == 4)
        VERIFY_RESULT(bench.set(tableOf0, "Small2"));
    if (change == 5)
        VERIFY_RESULT(bench.upload("Small1", flatTable(0.5F)));
    COMPARE_TEXT(bench.text(errorOf0), error.toStdString());
    COMPARE_TEXT(bench.text(stateOf0), error == u"None" ? "Evaluating" : "Error");
    QVERIFY(!std::isnan(bench.number(indexOf0(1))));
}

void TestVirtualDrive::refusesChangesWhileOn_data()
{
    QTest::addColumn<std::chrono::nanoseconds>("after");
    QTest::addColumn<bool>("deactivated");
    QTest::newRow("ramping in") << std::chrono::nanoseconds(5ms) << false;
    QTest::newRow("active") << std::chrono::nanoseconds(10ms) << false;
    QTest::newRow("ramping out") << std::chrono::nanoseconds(5ms) << true;
}

void TestVirtualDrive::refusesChangesWhileOn()
{
    QFETCH(std::chrono::nanoseconds, after);
    QFETCH(bool, deactivated);
    DriveFixture bench;
    VERIFY_RESULT(bench.activate(flatTable(0.5F)));
    if (deactivated) {
        bench.time = 1s;
        VERIFY_RESULT(bench.set(activationOf0, "Disabled"));
    }
    bench.time += after;
    const auto before = bench.drive->readTree("");
    const Bytes file = bench.file("Small1");
    const auto refused = [&](const std::string& path, const RegisterValue& value) {
        const auto written = bench.set(path, value);
        VERIFY_ERROR(written, ErrorCode::NotAllowedNow);
        const std::string reason = written.error().context.english("reason");
        QVERIFY2(reason.find("axis 0 (X)") != std::string::npos, reason.c_str());
    };
    refused(tableOf0, "Small2");
    refused(tableOf0, "Small1");
    for (int n = 1; n <= 3; ++n)
        refused(sourceOf0(n), std::uint32_t{0});
    refused(slotPath("Small1", "Command"), "Delete");
    refused(homeAxis0, "Start");
    VERIFY_ERROR(bench.drive->writeRegisters(
                     {{variable0, 1.0F}, {activationOf0, "Disabled"}, {tableOf0, "Small2"}}),
        ErrorCode::NotAllowedNow);
    VERIFY_ERROR(bench.upload("Small1", flatTable(0.25F)), ErrorCode::NotAllowedNow);
    QVERIFY(bench.drive->readTree("") == before);
    QVERIFY(bench.file("Small1") == file);

    VERIFY_RESULT(bench.set(activationOf0, "Disabled"));
    bench.time += 10ms;
    VERIFY_RESULT(bench.upload("Small1", flatTable(0.25F)));
    VERIFY_RESULT(bench.set(tableOf0, "Small2"));
    VERIFY_RESULT(bench.set(slotPath("Small1", "Command"), "Delete"));
}

void TestVirtualDrive::allowsOtherChangesWhileOn()
{
    DriveFixture bench;
    VERIFY_RESULT(bench.activate(flatTable(0.5F)));
    bench.time = 10ms;
    VERIFY_RESULT(bench.upload("Small2", evenTable(1)));
    VERIFY_RESULT(bench.set(slotPath("Small2", "Command"), "Delete"));
    VERIFY_RESULT(bench.set(axisPath(1, compensation + "Table"), "Small1"));
    VERIFY_RESULT(bench.set(axisPath(0, "Parameters/Compensations/Cogging/Table"), "Small8"));
    VERIFY_RESULT(bench.set(slotPath("Small1", "Header/Persistent"), true));
    VERIFY_RESULT(bench.set(slotPath("Small1", "Command"), "Commit"));
    VERIFY_RESULT(bench.set(save, "Save"));
    COMPARE_TEXT(bench.text(stateOf0), "Active");
    QCOMPARE(bench.number(outputOf0), 0.5);
}

void TestVirtualDrive::valuesTakeEffectBeforeCommands()
{
    DriveFixture bench;
    VERIFY_RESULT(bench.upload("Small1", flatTable(0.5F)));
    VERIFY_RESULT(bench.drive->writeRegisters({{activationOf0, "AddToEncoders"},
        {slotPath("Small1", "Command"), "Commit"}, {slotPath("Small1", "Header/Persistent"), true},
        {tableOf0, "Small1"}, {sourceOf0(1), bench.address(masterOf0)}}));
    COMPARE_TEXT(bench.text(stateOf0), "Ramping");
    QCOMPARE(bench.number(slotPath("Small1", "EraseCount")), 1.0);
}

void TestVirtualDrive::takesAFileWholeOrNotAtAll_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<int>("fault");
    QTest::addColumn<int>("code");
    const auto row = [](const char* name, const char* path, int fault, ErrorCode code) {
        QTest::newRow(name) << path << fault << static_cast<int>(code);
    };
    row("no such file", "tables/small9.TAMtbl", 0, ErrorCode::UnknownFile);
    row("no file name", "", 0, ErrorCode::UnknownFile);
    row("a way out", "../tables/small1.TAMtbl", 0, ErrorCode::UnknownFile);
    row("empty", "tables/small1.TAMtbl", 1, ErrorCode::TableRefused);
    row("a byte short", "tables/small1.TAMtbl", 2, ErrorCode::TableRefused);
    row("a flipped bit", "tables/small1.TAMtbl", 3, ErrorCode::TableRefused);
    row("a byte too large for the slot", "tables/small1.TAMtbl", 4, ErrorCode::TooLargeForSlot);
}

void TestVirtualDrive::takesAFileWholeOrNotAtAll()
{
    QFETCH(QString, path);
    QFETCH(int, fault);
    QFETCH(int, code);
    DriveFixture bench;
    VERIFY_RESULT(bench.upload("Small1", evenTable(1)));
    const Bytes before = bench.file("Small1");
    Bytes bytes = bench.encoded(evenTable(2));
    if (fault == 1)
        bytes.clear();
    if (fault == 2)
        bytes.pop_back();
    if (fault == 3)
        bytes.back() ^= std::byte{1};
    if (fault == 4)
        bytes.resize(bench.profile.slotNamed("Small1")->maximumSize + 1);
    const auto uploaded = bench.drive->upload(path.toStdString(), bytes);
    VERIFY_ERROR(uploaded, static_cast<ErrorCode>(code));
    for (const auto& [key, value] : uploaded.error().context.all())
        QVERIFY2(!value.english().empty() || path.isEmpty(), key.c_str());
    QVERIFY(bench.file("Small1") == before);
    QCOMPARE(bench.drive->listFiles().size(), bench.profile.tableSlots.size());
    QCOMPARE(bench.drive->listFiles().front().size, static_cast<std::uint32_t>(before.size()));
    QCOMPARE(bench.drive->listFiles().back().size, 0U);
}

void TestVirtualDrive::showsTheHeaderOfTheTable()
{
    DriveFixture bench;
    CompensationTable table = evenTable(2);
    table.grid.axes[1] = {{}, {}, -2.5, 0.125, 5};
    table.values.resize(table.grid.pointCount());
    VERIFY_RESULT(bench.upload("Large1", table, true));
    const auto header = [&](const std::string& rest) {
        return bench.number(slotPath("Large1", "Header/" + rest));
    };
    QCOMPARE(header("Dimensions"), 2.0);
    QCOMPARE(header("Size[0]"), 12.0);
    QCOMPARE(header("Size[1]"), 5.0);
    QCOMPARE(header("Size[2]"), 1.0);
    QCOMPARE(header("StartValue[1]"), -2.5);
    QCOMPARE(header("Distance[1]"), 0.125);
    QCOMPARE(header("Distance[2]"), 0.0);
    QCOMPARE(header("Elements"), 60.0);
    const std::span<const float> values(table.values);
    QCOMPARE(header("Crc"), static_cast<double>(crc32(std::as_bytes(values))));
    COMPARE_TEXT(bench.text(slotPath("Large1", "Header/Persistent")), "true");
    VERIFY_RESULT(bench.set(slotPath("Large1", "Header/Persistent"), false));
    QVERIFY(bench.file("Large1") == bench.encoded(table, false));
    VERIFY_RESULT(bench.set(slotPath("Large1", "Command"), "Delete"));
    QCOMPARE(header("Dimensions"), 0.0);
    QCOMPARE(header("Size[2]"), 0.0);
    QCOMPARE(header("Crc"), 0.0);
}

void TestVirtualDrive::storesSomethingElseOnce()
{
    DriveFixture bench;
    const Bytes sent = bench.encoded(evenTable(1));
    bench.drive->storeNextWrong();
    VERIFY_ERROR(bench.drive->upload("tables/small1.TAMtbl", Bytes{}), ErrorCode::TableRefused);
    VERIFY_RESULT(bench.upload("Small1", evenTable(1)));
    QVERIFY(bench.file("Small1") != sent);
    VERIFY_RESULT(decodeTamTable(bench.file("Small1"), bench.profile.layout));
    VERIFY_RESULT(bench.upload("Small1", evenTable(1)));
    QVERIFY(bench.file("Small1") == sent);

    bench.drive->storeNextWrong();
    VERIFY_RESULT(bench.drive->writeRegisters(
        {{activationOf0, "Disabled"}, {tableOf0, "Small1"}, {variable0, 2.0F}}));
    QVERIFY(bench.text(tableOf0) != "Small1" || bench.number(variable0) != 2.0);
    VERIFY_RESULT(bench.drive->writeRegisters({{tableOf0, "Small1"}, {variable0, 2.0F}}));
    COMPARE_TEXT(bench.text(tableOf0), "Small1");
    QCOMPARE(bench.number(variable0), 2.0);
}

void TestVirtualDrive::loseACommandWhenStoringWrong()
{
    DriveFixture bench;
    VERIFY_RESULT(bench.upload("Small1", evenTable(1)));
    bench.drive->storeNextWrong();
    VERIFY_RESULT(bench.set(slotPath("Small1", "Command"), "Delete"));
    QVERIFY(!bench.file("Small1").empty());
    VERIFY_RESULT(bench.set(slotPath("Small1", "Command"), "Delete"));
    QVERIFY(bench.file("Small1").empty());
}

void TestVirtualDrive::demoDriveIsActive()
{
    std::chrono::nanoseconds time{0};
    drivecomm::VirtualDriveOptions options = drivecomm::demoDriveOptions();
    options.clock = [&time] { return time; };
    drivecomm::VirtualDrive drive(drivecomm::genericProfile(), options);
    VERIFY_RESULT(drivecomm::loadDemoState(drive));
    time = 15s;
    const auto read = drive.readRegisters({stateOf0, outputOf0,
        slotPath("Small1", "Header/Persistent"), slotPath("Small1", "Header/Dimensions")});
    VERIFY_RESULT(read);
    COMPARE_TEXT(toText(read->at(0).value), "Active");
    QVERIFY(std::abs(toDouble(read->at(1).value)) > 1e-6);
    QVERIFY(std::abs(toDouble(read->at(1).value)) < 0.02);
    COMPARE_TEXT(toText(read->at(2).value), "true");
    QCOMPARE(toDouble(read->at(3).value), 2.0);
    drive.reboot();
    const auto after = drive.readRegisters({tableOf0, stateOf0});
    VERIFY_RESULT(after);
    COMPARE_TEXT(toText(after->at(0).value), "Small1");
    COMPARE_TEXT(toText(after->at(1).value), "Disabled");
    COMPARE_TEXT(drive.identity().name, "Demo");
    QCOMPARE(drive.identity().axes, 2);
}

/// Readers see a request whole or not at all, and the output that belongs to the table, while
/// another thread switches between two setups.
void TestVirtualDrive::manyThreadsSeeOneInstant()
{
    std::atomic<std::int64_t> ticks = 0;
    drivecomm::VirtualDriveOptions options;
    options.clock = [&ticks] { return std::chrono::microseconds(211 * ++ticks); };
    const DriveProfile& profile = drivecomm::genericProfile();
    drivecomm::VirtualDrive drive(profile, options);
    const auto encode = [&](float value) {
        return encodeTamTable(flatTable(value), false, profile.layout).value_or(Bytes{});
    };
    VERIFY_RESULT(drive.upload("tables/small1.TAMtbl", encode(1.0F)));
    VERIFY_RESULT(drive.upload("tables/small2.TAMtbl", encode(2.0F)));
    const std::string variable1 = "Application/Variables/Floats[1]";

    std::atomic<bool> stop = false;
    std::atomic<int> wrong = 0;
    std::atomic<int> reads = 0;
    const auto watch = [&] {
        while (!stop) {
            const auto read =
                drive.readRegisters({tableOf0, variable0, variable1, stateOf0, outputOf0, masterOf0,
                    axisPath(0, "Signals/PositionController/Encoders[0]/Position")});
            if (!read) {
                ++wrong;
                continue;
            }
            const auto number = [&](std::size_t i) { return toDouble(read->at(i).value); };
            const std::string table = toText(read->at(0).value);
            const std::string state = toText(read->at(3).value);
            const double full = table == "Small1" ? 1.0 : 2.0;
            const bool pairBelongs =
                number(1) == -number(2) && (table == "Disabled" || number(1) == full);
            const bool outputBelongs = state == "Active" ? number(4) == full
                : state == "Ramping"                     ? number(4) >= 0.0 && number(4) <= full
                                                         : number(4) == 0.0;
            if (!pairBelongs || !outputBelongs || number(5) != number(6))
                ++wrong;
            ++reads;
        }
    };
    std::vector<std::jthread> watchers;
    for (int i = 0; i < 3; ++i)
        watchers.emplace_back(watch);
    const std::uint32_t source = drive.readRegisters({masterOf0})->front().address;
    int switches = 0;
    int refusals = 0;
    while (switches < 60 || (reads < 500 && wrong == 0)) {
        const float value = switches % 2 == 0 ? 1.0F : 2.0F;
        const auto written =
            drive.writeRegisters({{tableOf0, "Small" + toText(value)}, {sourceOf0(1), source},
                {variable0, value}, {variable1, -value}, {activationOf0, "AddToEncoders"}});
        if (written) {
            ++switches;
            while (toText(drive.readRegisters({stateOf0})->front().value) != "Active") { }
            VERIFY_RESULT(drive.writeRegisters({{activationOf0, "Disabled"}}));
        } else {
            QCOMPARE(written.error().code, ErrorCode::NotAllowedNow);
            ++refusals;
        }
    }
    stop = true;
    watchers.clear();
    QCOMPARE(wrong.load(), 0);
    QVERIFY(refusals > 0);
}

AXISCOMP_TEST(TestVirtualDrive)

} // namespace tst_virtualdrive

#include "tst_virtualdrive.moc"
