// SPDX-License-Identifier: GPL-3.0-or-later
//
// A virtual machine: what its instrument says, compared with a page of Python that shares no code
// with it (check_machine.py) and with closed forms.
#include "core/io/file_descriptor.h"
#include "core/io/local_file.h"
#include "core/metrology/judge/iso230.h"
#include "core/metrology/measuring_plan.h"
#include "drivecomm/virtualdrive/machine/machine_file.h"
#include "drivecomm/virtualdrive/machine/machine_truth.h"
#include "drivecomm/virtualdrive/machine/program_motion.h"
#include "drivecomm/virtualdrive/serial/instrument_server.h"
#include "tests/drivecomm/virtualdrive/drive_fixture.h"
#include "tests/support/patience.h"
#include "tests/support/test_registry.h"

#include <QProcess>

#include <nlohmann/json.hpp>

#include <atomic>
#include <cmath>
#include <numbers>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace tst_virtualmachine {

using namespace axiscomp;
using namespace axiscomp::test;
using namespace axiscomp::drivecomm;
using nlohmann::json;

namespace {

/// The screw of docs/virtual-machine.md without temperature and map, or with a part of it replaced.
const std::string screw = R"({"seed": 7, "axes": {"X": {"slope": 12e-6,
 "waves": [{"period": 430, "amplitude": 0.003, "phase": 0.7}, {"period": 97, "amplitude": 0.0012},
           {"period": 10, "amplitude": 0.0008, "phase": 0.3}],
 "reversal": 0.0024, "reversalWidth": 0.01, "noise": {"approach": 0.0001, "reading": 0.00002}}}})";

std::string fileText(const std::string& path)
{
    const auto bytes = loadFile(path, 1'000'000);
    return bytes ? std::string(asText(*bytes)) : std::string();
}

std::string exampleMachine(const std::string& name)
{
    return fileText(std::string(AXISCOMP_SOURCE_FOLDER "/resources/machines/") + name + ".json");
}

MachineDescription machineOf(const std::string& text)
{
    auto machine = parseMachine(text, "machine.json");
    if (!machine)
        qFatal("%s", sentence(machine.error()).c_str());
    return *std::move(machine);
}

MeasuringPlan planFor(const MachineAxis& axis, int count, int cycles, std::uint64_t seed = 1)
{
    MeasuringPlanRequest request;
    request.axis = axis.name;
    request.isAngular = axis.isAngular;
    request.from = axis.low;
    request.to = axis.high;
    request.count = count;
    request.cycles = cycles;
    request.seed = seed;
    return makeMeasuringPlan(request).value();
}

const std::string referenceOf0 = "Machine/Axes[0]/ReferencePosition";

/// A drive with a machine whose clock is moved by hand, and whose program starts at once.
struct MachineFixture {
    explicit MachineFixture(const std::string& text, std::optional<MeasuringPlan> plan = {})
    {
        options.machine = machineOf(text);
        options.program = std::move(plan);
        options.programStart = 0s;
        options.clock = [this] { return time; };
        auto made = VirtualDrive::create(genericProfile(), options);
        if (!made)
            qFatal("%s", sentence(made.error()).c_str());
        drive = *std::move(made);
    }
    [[nodiscard]] double number(const std::string& path)
    {
        const auto read = drive->readRegisters({path});
        return read ? toDouble(read->front().value) : std::nan("");
    }
    [[nodiscard]] std::vector<double> numbers(const std::vector<std::string>& paths)
    {
        std::vector<double> values;
        const auto readings = drive->readRegisters(paths);
        if (readings)
            for (const RegisterReading& reading : *readings)
                values.push_back(toDouble(reading.value));
        return values;
    }
    /// Each step's moment in the middle of its dwell, by feed, ways and dwells.
    [[nodiscard]] std::vector<std::chrono::nanoseconds> standstills() const
    {
        const MeasuringPlan& plan = *options.program;
        std::vector<std::chrono::nanoseconds> moments;
        double seconds = 0.0;
        double place = plan.steps.front().approach;
        for (const MeasuringStep& step : plan.steps) {
            const double way =
                std::abs(step.approach - place) + std::abs(step.target - step.approach);
            seconds += way / (plan.feedPerMinute / 60.0) + plan.dwellSeconds;
            place = step.target;
            moments.push_back(std::chrono::duration_cast<std::chrono::nanoseconds>(
                std::chrono::duration<double>(seconds - plan.dwellSeconds / 2.0)));
        }
        return moments;
    }

    std::chrono::nanoseconds time{0};
    VirtualDriveOptions options;
    std::unique_ptr<VirtualDrive> drive;
};

std::vector<double> independentReadings(const std::string& machine, const json& samples)
{
    QProcess python;
    python.start(QStringLiteral("python3"),
        {QStringLiteral(AXISCOMP_SOURCE_FOLDER "/tests/drivecomm/virtualdrive/check_machine.py")});
    python.write(QByteArray::fromStdString(
        json{{"machine", json::parse(machine)}, {"samples", samples}}.dump()));
    python.closeWriteChannel();
    if (!python.waitForFinished(-1) || python.exitCode() != 0)
        qWarning("%s", python.readAllStandardError().constData());
    return json::parse(python.readAllStandardOutput().toStdString(), nullptr, false)
        .get<std::vector<double>>();
}

double median(std::vector<double> values)
{
    std::ranges::sort(values);
    return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2.0;
}

} // namespace

class tst_VirtualMachine : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void anotherProgramComputesTheSameReadings_data()
    {
        QTest::addColumn<QString>("machine");
        QTest::addColumn<int>("axis");
        for (const char* const name : {"screw", "linear-encoder", "rotary-table"})
            QTest::newRow(name) << QString::fromStdString(exampleMachine(name)) << 0;
        QTest::newRow("gantry X") << QString::fromStdString(exampleMachine("gantry")) << 0;
        QTest::newRow("gantry Y") << QString::fromStdString(exampleMachine("gantry")) << 1;
        json all = json::parse(screw);
        all["axes"]["X"]["map"] = {{"spacing", 40}, {"sigma", 0.001}};
        all["instrument"] = {
            {"zero", 17.3}, {"sign", -1}, {"gross", {{{"reading", 9}, {"by", 0.09}}}}};
        QTest::newRow("instrument") << QString::fromStdString(all.dump()) << 0;
        all["axes"]["X"]["reversalWidth"] = 30; // more than the overrun and a spacing
        QTest::newRow("wide reversal") << QString::fromStdString(all.dump()) << 0;
    }
    void anotherProgramComputesTheSameReadings()
    {
        QFETCH(const QString, machine);
        QFETCH(const int, axis);
        const MachineDescription description = machineOf(machine.toStdString());
        const auto self = static_cast<std::size_t>(axis);
        MachineFixture bench(machine.toStdString(), planFor(description.axes[self], 21, 2));
        const std::vector<MeasuringStep>& steps = bench.options.program->steps;
        const auto moments = bench.standstills();
        std::vector<std::string> paths{
            "Machine/Axes[" + std::to_string(axis) + "]/ReferencePosition",
            axisPath(axis, "Signals/General/MotorTemperature")};
        for (std::size_t i = 0; i < description.axes.size(); ++i)
            paths.push_back(
                axisPath(static_cast<int>(i), "Signals/PositionController/MasterPosition"));
        json samples = json::array();
        std::vector<double> said;
        for (std::size_t i = 0; i < steps.size(); ++i) {
            bench.time = moments[i];
            const std::vector<double> read = bench.numbers(paths);
            QCOMPARE(read.size(), paths.size());
            QCOMPARE(read[2 + self], steps[i].target);
            said.push_back(read[0]);
            samples.push_back(
                {{"axis", axis}, {"raw", std::vector<double>(read.begin() + 2, read.end())},
                    {"way", {steps[i].approach, steps[i].target}}, {"temperature", read[1]},
                    {"approach", steps[i].step}, {"reading", bench.time.count() / 100'000}});
        }
        const std::vector<double> expected = independentReadings(machine.toStdString(), samples);
        QCOMPARE(expected.size(), said.size());
        for (std::size_t i = 0; i < said.size(); ++i)
            QVERIFY2(std::abs(said[i] - expected[i]) < 1e-11,
                qPrintable(QStringLiteral("step %1: %2, expected %3")
                               .arg(i + 1)
                               .arg(said[i], 0, 'g', 17)
                               .arg(expected[i], 0, 'g', 17)));
    }

    void theErrorIsTheClosedFormOfTheSpecification()
    {
        const MachineTruth truth(machineOf(
            R"({"axes": {"X": {"slope": 2e-5, "waves": [{"period": 100, "amplitude": 0.01,
                "phase": 0.5}], "reversal": 0.004,
                "thermal": {"expansion": 1e-5, "zeroPerKelvin": 0.001, "fixedAt": 50}}}})"));
        const double raw = 130.0;
        const double expected = raw + 2e-5 * raw
            + 0.01 * std::sin(2.0 * std::numbers::pi * raw / 100.0 + 0.5) - 0.002
            + 1e-5 * 3.0 * (raw - 50.0) + 0.001 * 3.0;
        QVERIFY(
            std::abs(truth.position(0, std::array{raw}, {-0.5, 23.0, 1, 1}) - expected) < 1e-12);
    }

    void theReversalIsPassedThroughItsWidth()
    {
        ReversalState state(0.01, 5.0);
        QCOMPARE(state.side(), 0.5);
        state.moveTo(7.0);
        QVERIFY(std::abs(state.side() - 0.5) < 1e-9);
        state.moveTo(6.9975);
        QVERIFY(std::abs(state.side() - 0.25) < 1e-9);
        state.moveTo(6.995);
        QVERIFY(std::abs(state.side()) < 1e-9);
        state.moveTo(6.9975); // turned within the width: back the same way
        QVERIFY(std::abs(state.side() - 0.25) < 1e-9);
        state.moveTo(6.5);
        QVERIFY(std::abs(state.side() + 0.5) < 1e-9);
        ReversalState sharp(0.0, 5.0);
        sharp.moveTo(4.999);
        QVERIFY(std::abs(sharp.side() + 0.5) < 1e-3);
    }

    void rawPositionAndOutputAreTheSetPosition()
    {
        const MeasuringPlan plan = planFor(machineOf(screw).axes[0], 11, 1);
        MachineFixture bench(screw, plan);
        const CompensationTable table = evenTable(1, 0.2F, 60);
        const DriveProfile& profile = genericProfile();
        QVERIFY(bench.drive->upload(profile.slotNamed("Small1")->file,
            encodeTamTable(table, false, profile.layout).value()));
        const auto address = bench.drive->readRegisters({masterOf0}).value().front().address;
        QVERIFY(bench.drive->writeRegisters({{tableOf0, "Small1"}, {sourceOf0(1), address}}));
        QVERIFY(bench.drive->writeRegisters({{activationOf0, "AddToEncoders"}}));
        bool isCompensated = false;
        const std::vector<std::chrono::nanoseconds> moments = bench.standstills();
        for (std::size_t i = 0; i < plan.steps.size(); ++i) {
            bench.time = moments[i];
            const auto read =
                bench.numbers({masterOf0, outputOf0, axisPath(0, "Signals/PathPlanner/Position"),
                    axisPath(0, "Signals/PositionController/ActualPosition"), referenceOf0});
            QCOMPARE(read[2], plan.steps[i].target);
            QCOMPARE(read[3], read[2]);
            QVERIFY(std::abs(read[0] + read[1] - read[2]) < 1e-6); // the output is a Single
            QVERIFY(std::abs(read[4] - read[0]) < 0.03); // what is measured is the raw position's
            isCompensated = isCompensated || std::abs(read[1]) > 0.1;
        }
        QVERIFY(isCompensated);
    }

    void aProgramMovesAsItsPlanSays()
    {
        MeasuringPlan plan;
        plan.axis = "X";
        plan.feedPerMinute = 600.0; // 10 mm/s
        plan.dwellSeconds = 2.0;
        plan.steps = {{1, 1, Approach::Up, 20.0, 10.0}, {2, 1, Approach::Up, 50.0, 20.0},
            {3, 1, Approach::Down, 50.0, 60.0}};
        const ProgramMotion motion(plan, 10.0);
        const auto at = [&motion](double seconds) { return motion.position(seconds); };
        QCOMPARE(at(-5.0), 10.0);
        QCOMPARE(at(0.5), 15.0);
        QCOMPARE(at(1.0), 20.0);
        QCOMPARE(at(2.9), 20.0);
        QCOMPARE(at(3.5), 25.0);
        QCOMPARE(at(7.0), 50.0);
        QCOMPARE(motion.step(7.0), 2);
        QCOMPARE(at(9.0), 60.0); // 1 s of way after the dwell: the overrun
        QCOMPARE(motion.step(9.0), 3);
        QCOMPARE(at(9.5), 55.0);
        QCOMPARE(at(100.0), 50.0);
        QCOMPARE(motion.endSeconds(), 12.0);
        QCOMPARE(motion.movementEnds(1.0, 9.0), (std::vector<double>{6.0, 9.0}));
    }

    void aTurnThatNobodyReadCounts()
    {
        MeasuringPlan plan = planFor(machineOf(screw).axes[0], 3, 1);
        std::string still = screw;
        still.replace(still.find("0.0001"), 6, "0.0000");
        still.replace(still.find("0.00002"), 7, "0.00000");
        MachineFixture often(still, plan);
        MachineFixture seldom(still, plan);
        const auto end = often.standstills().back();
        for (often.time = 0s; often.time < end; often.time += 50ms)
            (void)often.number(referenceOf0);
        often.time = seldom.time = end;
        QCOMPARE(seldom.number(referenceOf0), often.number(referenceOf0));
    }

    void aProgramStartsAgainFromWhereTheAxisIs()
    {
        const MeasuringPlan plan = planFor(machineOf(screw).axes[0], 3, 1);
        MachineFixture bench(screw, plan);
        bench.time = bench.standstills()[1];
        QCOMPARE(bench.number(masterOf0), plan.steps[1].target);
        const double before = bench.number(referenceOf0);
        QVERIFY(bench.drive->writeRegisters({{"Machine/Program/Command", "Start"}}));
        QCOMPARE(bench.number(masterOf0), plan.steps[1].target);
        const auto begin = bench.time;
        const double way = std::abs(plan.steps[1].target - plan.steps[0].approach)
            + std::abs(plan.steps[0].target - plan.steps[0].approach);
        bench.time = begin
            + std::chrono::duration_cast<std::chrono::nanoseconds>(
                std::chrono::duration<double>(way / (1000.0 / 60.0) + 1.0));
        QCOMPARE(bench.number(masterOf0), plan.steps[0].target);
        QVERIFY(std::isfinite(before));
    }

    void withoutAProgramTheAxisMovesOnAsBefore()
    {
        MachineFixture bench(screw);
        double lowest = 1e9;
        double highest = -1e9;
        std::optional<double> last;
        for (bench.time = 0s; bench.time < 61s; bench.time += 250ms) {
            const auto read = bench.numbers({masterOf0, referenceOf0});
            lowest = std::min(lowest, read[0]);
            highest = std::max(highest, read[0]);
            if (last && std::abs(read[0] - *last) > 1.0) { // beyond the width of the reversal
                const double smooth = 12e-6 * read[0]
                    + 0.003 * std::sin(2.0 * std::numbers::pi * read[0] / 430.0 + 0.7)
                    + 0.0012 * std::sin(2.0 * std::numbers::pi * read[0] / 97.0)
                    + 0.0008 * std::sin(2.0 * std::numbers::pi * read[0] / 10.0 + 0.3);
                const double side = read[0] > *last ? 0.0012 : -0.0012;
                QVERIFY(std::abs(read[1] - read[0] - smooth - side) < 6e-4);
            }
            last = read[0];
        }
        QVERIFY(lowest < 1.0 && highest > 499.0);
        bench.time = 24h * 365;
        QVERIFY(std::isfinite(bench.number(referenceOf0)));
    }

    void noiseIsByTheSeed()
    {
        MachineDescription description = machineOf(screw);
        const MachineTruth truth(description);
        description.seed = 8;
        const MachineTruth other(description);
        const std::array raw{100.0};
        double approaches = 0.0;
        double readings = 0.0;
        constexpr std::uint64_t count = 20'000;
        const double quiet = 100.0 + 0.0012 + 12e-6 * 100.0
            + 0.003 * std::sin(2.0 * std::numbers::pi * 100.0 / 430.0 + 0.7)
            + 0.0012 * std::sin(2.0 * std::numbers::pi * 100.0 / 97.0)
            + 0.0008 * std::sin(2.0 * std::numbers::pi * 100.0 / 10.0 + 0.3);
        for (std::uint64_t i = 1; i <= count; ++i) {
            const MeasuredInstant instant{0.5, 20.0, i, 3};
            const double position = truth.position(0, raw, instant);
            approaches += std::pow(position - quiet, 2);
            readings += std::pow(truth.reading(0, raw, {0.5, 20.0, 1, i})
                    - truth.position(0, raw, {0.5, 20.0, 1, i}),
                2);
            QCOMPARE(truth.position(0, raw, instant), position);
        }
        QVERIFY(std::abs(std::sqrt(approaches / count) - 1e-4) < 3e-6);
        QVERIFY(std::abs(std::sqrt(readings / count) - 2e-5) < 6e-7);
        QVERIFY(
            truth.position(0, raw, {0.5, 20.0, 1, 1}) != other.position(0, raw, {0.5, 20.0, 1, 1}));
    }

    void anAxisWarmsUp()
    {
        MachineFixture bench(exampleMachine("screw"));
        const std::string path = axisPath(0, "Signals/General/MotorTemperature");
        QCOMPARE(bench.number(path), 20.0);
        bench.time = 40min;
        QVERIFY(std::abs(bench.number(path) - (20.0 + 2.0 * (1.0 - std::exp(-1.0)))) < 1e-5);
        bench.time = 24h;
        QVERIFY(std::abs(bench.number(path) - 22.0) < 1e-5);
    }

    void nothingIsThereWithoutAMachine()
    {
        DriveFixture plain(1);
        QVERIFY(plain.drive->readTree("Machine").empty());
        QVERIFY(!plain.drive->instrumentReading());
        MachineFixture bench(screw);
        QCOMPARE(bench.drive->readTree("Machine").size(), std::size_t{1});
        // Every other register keeps its address.
        for (const RegisterReading& reading : plain.drive->readTree("")) {
            const auto same = bench.drive->readRegisters({reading.path});
            QVERIFY2(same && same->front().address == reading.address, reading.path.c_str());
        }
    }

    void theScrewIsAsBadAsItsFiguresSay()
    {
        // Plan, program, ten readings at each target and judgement, fifty machines: the medians
        // that a simulation in another language gives are 11.6 and 14.3 um.
        std::vector<double> m;
        std::vector<double> a;
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            json text = json::parse(screw);
            text["seed"] = seed;
            MeasuringPlanRequest request;
            request.to = 500.0;
            request.count = 51;
            request.period = 10.0;
            request.seed = seed;
            MachineFixture bench(text.dump(), makeMeasuringPlan(request).value());
            Measurement measurement;
            measurement.targets = targetsOf(*bench.options.program);
            const auto moments = bench.standstills();
            for (std::size_t i = 0; i < moments.size(); ++i) {
                const MeasuringStep& step = bench.options.program->steps[i];
                double sum = 0.0;
                for (int n = 0; n < 10; ++n) {
                    bench.time = moments[i] + n * 50ms;
                    sum += bench.number(referenceOf0);
                }
                RunValue value;
                value.target = targetIndex(measurement.targets, step.target);
                value.direction = step.direction;
                value.run = step.run;
                value.deviation = sum / 10.0 - step.target;
                measurement.values.push_back(value);
            }
            sortValues(measurement.values);
            const Iso230Figures figures = iso230Figures(measurement);
            m.push_back(1e3 * figures[Iso230Figure::M].value.value());
            a.push_back(1e3 * figures[Iso230Figure::A].value.value());
        }
        QVERIFY2(std::abs(median(m) - 11.6) < 0.15, qPrintable(QString::number(median(m))));
        QVERIFY2(std::abs(median(a) - 14.3) < 0.15, qPrintable(QString::number(median(a))));
    }

    void badMachineFilesAreNamedWithTheirPlace_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* name, const char* text, const char* said) {
            QTest::newRow(name) << QString::fromUtf8(text) << QString::fromUtf8(said);
        };
        row("no json", "{", "line 1, column 2: this is not JSON");
        row("no axes", "{}", "axes: this is missing");
        row("none", R"({"axes": {}})", "axes: an object with 1 to 16 axes is expected");
        row("misspelt", R"({"axes": {"X": {"revresal": 1}}})",
            "axes.X: \"revresal\" is not known here; is \"reversal\" meant?");
        row("unknown", R"({"axes": {"X": {"colour": 1}}})",
            "axes.X: \"colour\" is not known here; there is: unit, travel, slope, waves, map");
        row("top", R"({"axis": {}})",
            "the document: \"axis\" is not known here; is \"axes\" meant?");
        row("text", R"({"axes": {"X": {"slope": "12e-6"}}})", "axes.X.slope: a number is expected");
        row("steep", R"({"axes": {"X": {"slope": 12}}})",
            "axes.X.slope: a number from -0.1 to 0.1 is expected, not 12");
        row("period", R"({"axes": {"X": {"waves": [{"period": 0, "amplitude": 1}]}}})",
            "axes.X.waves[0].period: a number above 0, at most 1000000, is expected, not 0");
        row("amplitude", R"({"axes": {"X": {"waves": [{"period": 5}]}}})",
            "axes.X.waves[0].amplitude: this is missing");
        row("travel", R"({"axes": {"X": {"travel": [5, 5]}}})",
            "axes.X.travel: the first end must be below the second");
        row("unit", R"({"axes": {"X": {"unit": "m"}}})", "axes.X.unit: mm or deg is expected");
        row("knots", R"({"axes": {"X": {"map": {"spacing": 0.01, "sigma": 1}}}})",
            "axes.X.map.spacing: the travel has more than 10000 knots");
        row("noise", R"({"axes": {"X": {"noise": {"reading": -1}}}})",
            "axes.X.noise.reading: a number from 0 to 1000 is expected, not -1");
        row("from", R"({"axes": {"X": {"from": {"Q": {}}}}})",
            "axes.X.from: there is no axis \"Q\"; there is: X");
        row("itself", R"({"axes": {"X": {"from": {"X": {}}}}})",
            "axes.X.from.X: an axis's own terms stand with the axis");
        row("sign", R"({"axes": {"X": {}}, "instrument": {"sign": 0}})",
            "instrument.sign: 1 or -1 is expected");
        row("instrument unit", R"({"axes": {"X": {}}, "instrument": {"unit": "arcsec"}})",
            "instrument.unit: one of these units is expected: mm, m, um, inch");
        row("instrument axis", R"({"axes": {"X": {}}, "instrument": {"axis": "Y"}})",
            "instrument.axis: there is no axis \"Y\"; there is: X");
        row("seed", R"({"seed": -1, "axes": {"X": {}}})", "seed: a whole number from 0 to");
        row("gross", R"({"axes": {"X": {}}, "instrument": {"gross": [{"reading": 0, "by": 1}]}})",
            "instrument.gross[0].reading: a whole number from 1 to");
        row("twice", R"({"axes": {"X": {}, "X": {}}})", "the member \"X\" is there twice");
    }
    void badMachineFilesAreNamedWithTheirPlace()
    {
        QFETCH(const QString, text);
        QFETCH(const QString, said);
        const auto machine = parseMachine(text.toStdString(), "machine.json");
        VERIFY_ERROR(machine, ErrorCode::FileNotReadable);
        const QString reason = QString::fromStdString(sentence(machine.error()));
        QVERIFY2(reason.startsWith(QStringLiteral("machine.json cannot be read: ") + said),
            qPrintable(reason));
    }

    void plansThatTheMachineCannotPlayAreRefused()
    {
        VirtualDriveOptions options;
        const auto refusal = [&options] {
            const auto made = VirtualDrive::create(genericProfile(), options);
            return made ? std::string() : sentence(made.error());
        };
        options.program = planFor(machineOf(screw).axes[0], 3, 1);
        QVERIFY(refusal().find("a program needs a machine") != std::string::npos);
        options.machine = machineOf(screw);
        COMPARE_TEXT(refusal(), "");
        options.program->axis = "Y";
        QVERIFY(refusal().find("the plan is for axis Y; the machine has: X") != std::string::npos);
        options.program->axis = "X";
        options.program->isAngular = true;
        QVERIFY(refusal().find("one is in mm, the other in deg") != std::string::npos);
        options.program->isAngular = false;
        options.program->steps.back().target = 551.0;
        QVERIFY(
            refusal().find("step 6 of the plan goes to 551, more than a tenth beyond the travel "
                           "of axis X, 0 to 500")
            != std::string::npos);
        options.program->steps.back().target = 0.0;
        options.program->dwellSeconds = 0.0;
        QVERIFY(refusal().find("the plan needs a feed and a dwell") != std::string::npos);
    }

    void theInstrumentSaysWhatIsTrueNow()
    {
        std::atomic<double> value = 1.0;
        auto server = InstrumentServer::start([&value] { return value.load(); },
            {.link = {}, .unit = "um", .unitsPerPosition = 1000.0, .linesPerSecond = 50});
        QVERIFY2(server.has_value(), server ? "" : sentence(server.error()).c_str());
        const FileDescriptor port(
            ::open((*server)->device().c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
        QVERIFY(port.isOpen());
        std::string heard;
        const auto hear = [&] {
            std::array<char, 4096> buffer{};
            const ssize_t size = ::read(port.get(), buffer.data(), buffer.size());
            if (size > 0)
                heard.append(buffer.data(), static_cast<std::size_t>(size));
            return heard;
        };
        QTRY_VERIFY(hear().starts_with("+1000.0000000 um\r\n"));
        value = -0.5;
        QTRY_VERIFY(hear().find("\r\n-500.0000000 um\r\n") != std::string::npos);
        // Nobody reads for a while: what waits is one line.
        QTRY_VERIFY([&] {
            int waiting = 0;
            ::ioctl(port.get(), FIONREAD, &waiting);
            return waiting > 0;
        }());
        value = 2.0;
        heard.clear();
        QCOMPARE(::write(port.get(), "?\r\n", 3), ssize_t{3});
        QTRY_VERIFY(hear().find("+2000.0000000 um\r\n") != std::string::npos);
        QVERIFY2(heard.size() < 100, heard.c_str());
    }
};

AXISCOMP_TEST(tst_VirtualMachine)

} // namespace tst_virtualmachine

#include "tst_virtualmachine.moc"
