// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/capture_session.h"
#include "core/capture/run_file.h"
#include "core/io/local_file.h"
#include "core/metrology/formats/measurement_format.h"
#include "core/metrology/judge/iso230.h"
#include "drivecomm/profile/profile_loader.h"
#include "drivecomm/virtualdrive/firmware/virtual_drive.h"
#include "drivecomm/virtualdrive/machine/machine_file.h"
#include "drivecomm/virtualdrive/machine/program_motion.h"
#include "tests/support/kill_points.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTemporaryDir>

#include <cmath>
#include <fstream>
#include <functional>

namespace tst_capture {

using namespace axiscomp;
using namespace axiscomp::drivecomm;
using namespace std::chrono_literals;

namespace {

using Event = CaptureSession::Event;

MeasuringPlan planOver(double to, int count, int cycles, double overrun)
{
    MeasuringPlanRequest request;
    request.to = to;
    request.count = count;
    request.cycles = cycles;
    request.overrun = overrun;
    request.dwellSeconds = 2.5;
    return makeMeasuringPlan(request).value();
}

/// An axis that is moved by hand, read 20 times a second.
class HandMoved {
public:
    explicit HandMoved(const MeasuringPlan& plan, CaptureRules rules = {},
        std::span<const CapturedValue> taken = {})
        : session(plan, rules, taken)
    {
    }

    /// In steps of 0.5, and one reading at each.
    void move(double to)
    {
        while (reading.encoder != to) {
            const double left = to - reading.encoder;
            reading.encoder =
                std::abs(left) <= 0.5 ? to : reading.encoder + (left > 0 ? 0.5 : -0.5);
            (void)read();
        }
    }
    /// The events of so many readings at one place.
    std::vector<Event> stand(int readings)
    {
        std::vector<Event> events;
        for (int i = 0; i < readings; ++i)
            events.push_back(read());
        return events;
    }
    Event read()
    {
        reading.time += 50ms;
        reading.reference = reading.encoder + error(reading.encoder);
        const Event event = session.take(reading);
        if (event == Event::Refused || event == Event::Stopped)
            m_problem = session.problem().english();
        return event;
    }
    [[nodiscard]] bool takes() { return std::ranges::count(stand(60), Event::Taken) == 1; }
    [[nodiscard]] const std::string& problem() const { return m_problem; }

    CaptureSession session;
    CaptureReading reading{0ns, 0.0, 0.0, 0.0, "off"};
    std::function<double(double)> error = [](double position) { return 0.001 + 1e-5 * position; };

private:
    std::string m_problem;
};

const std::string screw = R"({"axes": {"X": {"slope": 12e-6,
 "waves": [{"period": 430, "amplitude": 0.003, "phase": 0.7}, {"period": 97, "amplitude": 0.0012},
           {"period": 10, "amplitude": 0.0008, "phase": 0.3}],
 "reversal": 0.0024, "reversalWidth": 0.01, "noise": {"approach": 0.0001, "reading": 0.00002}}}})";

struct Played {
    std::vector<CapturedValue> values;
    int refusals = 0;
    Event last = Event::Moving;
    std::string problem;
};

/// The plan on the screw, read 20 times a second by its registers; isLost(n): whether the n-th
/// exchange, from 0, has no answer.
Played play(const MeasuringPlan& plan, const std::function<bool(int)>& isLost)
{
    std::chrono::nanoseconds time{0};
    VirtualDriveOptions options;
    options.machine = parseMachine(screw, "screw").value();
    options.program = plan;
    options.programStart = 500ms;
    options.clock = [&time] { return time; };
    const auto drive = VirtualDrive::create(genericProfile(), options).value();
    CaptureSession session(plan, {});
    Played played;
    const double end = ProgramMotion(plan, plan.steps.front().approach).endSeconds()
        + 6.0; // beyond the longest gap
    for (int n = 0; n < static_cast<int>(20.0 * end); ++n, time += 50ms) {
        if (isLost(n))
            continue;
        const auto read = drive
                              ->readRegisters({"Axes[0]/Signals/PositionController/MasterPosition",
                                  "Axes[0]/Signals/Compensations/Axis/Output",
                                  "Machine/Axes[0]/ReferencePosition",
                                  "Axes[0]/Signals/Compensations/Axis/State"})
                              .value();
        played.last = session.take({time, toDouble(read[0].value), toDouble(read[1].value),
            toDouble(read[2].value), toText(read[3].value)});
        if (played.last == Event::Taken)
            played.values.push_back(session.value());
        if (played.last == Event::Refused) {
            ++played.refusals;
            played.problem = session.problem().english();
        }
        if (played.last == Event::Done)
            break;
    }
    return played;
}

std::string contentOf(const std::filesystem::path& file)
{
    const auto bytes = loadFile(file, 1'000'000);
    return bytes ? std::string(asText(*bytes)) : std::string();
}

void put(const std::filesystem::path& file, std::string_view text)
{
    QVERIFY(saveFile(file, asBytes(text)));
}

const RunOrigin origin{"off", "laser", "2026-11-21T09:30:00"};

CapturedValue valueOf(const MeasuringPlan& plan, std::size_t step)
{
    return {plan.steps[step], 0.001 * static_cast<double>(step) - 0.0023, plan.steps[step].target,
        0.0, std::chrono::seconds(step)};
}

} // namespace

class tst_Capture : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void takesEachStepOnceWithTheMeanOfItsReadings()
    {
        const MeasuringPlan plan = planOver(30.0, 4, 1, 1.0);
        HandMoved axis(plan);
        axis.move(-1.0);
        for (const MeasuringStep& step : plan.steps) {
            axis.move(step.approach);
            axis.move(step.target);
            QVERIFY2(axis.takes(), axis.problem().c_str());
            const CapturedValue& value = axis.session.value();
            QCOMPARE(value.step, step);
            QVERIFY(std::abs(value.deviation - (0.001 + 1e-5 * step.target)) < 1e-12);
            QVERIFY(std::abs(value.encoder - step.target) < 1e-12);
            QCOMPARE(axis.stand(100).back() == Event::Taken, false);
        }
        QCOMPARE(axis.read(), Event::Done);
        QCOMPARE(axis.session.due(), plan.steps.size());
    }

    void standsForTheDwellAndThenReadsTenTimes()
    {
        HandMoved axis(planOver(30.0, 4, 1, 1.0));
        axis.move(-1.0);
        axis.move(0.0);
        const std::vector<Event> events = axis.stand(40);
        const auto taken = std::ranges::find(events, Event::Taken) - events.begin();
        QCOMPARE(taken, 19 + 9); // 1 s since the axis came, which is a reading before; ten readings
        QCOMPARE(events[static_cast<std::size_t>(taken) - 1], Event::Standing);
        QCOMPARE(events[static_cast<std::size_t>(taken) + 1], Event::Moving);
    }

    void anAxisThatTremblesDoesNotStand()
    {
        HandMoved axis(planOver(30.0, 4, 1, 1.0));
        axis.move(-1.0);
        axis.move(0.0);
        for (int i = 0; i < 100; ++i) {
            axis.reading.encoder = i % 2 == 0 ? 0.0012 : 0.0;
            QCOMPARE(axis.read(), Event::Moving);
        }
        axis.reading.encoder = 0.0;
        QVERIFY(axis.takes());
    }

    void anotherTargetOrDirectionIsRefusedAndSaid()
    {
        const MeasuringPlan plan = planOver(30.0, 4, 1, 1.0);
        HandMoved axis(plan);
        axis.move(2.0);
        axis.move(0.0);
        QCOMPARE(axis.stand(40).back(), Event::Refused);
        QVERIFY2(
            axis.problem().starts_with("step 1 is approached upwards, and the axis did not come "
                                       "from below; go to -1.000 mm"),
            axis.problem().c_str());
        axis.move(-0.3);
        for (const double place : {-0.2, -0.1, 0.0}) {
            axis.reading.encoder = place;
            (void)axis.read();
        }
        QCOMPARE(axis.stand(40).back(), Event::Refused);
        QVERIFY2(
            axis.problem().starts_with("the axis came only 0.300 mm in the direction of step 1, "
                                       "less than the overrun of 1.000 mm"),
            axis.problem().c_str());
        axis.move(-1.0);
        axis.move(plan.steps[2].target);
        QCOMPARE(axis.stand(40).back(), Event::Refused);
        QVERIFY2(axis.problem().find("step 1 at 0.000 mm is due; this is the target of step 3")
                != std::string::npos,
            axis.problem().c_str());
        axis.move(-1.0);
        axis.move(0.0);
        QVERIFY2(axis.takes(), axis.problem().c_str());
    }

    void whatTheDriveAddsBelongsToThePosition()
    {
        HandMoved axis(planOver(30.0, 4, 1, 1.0));
        axis.reading.output = 0.5;
        axis.move(-1.5);
        axis.move(-0.5);
        QVERIFY2(axis.takes(), axis.problem().c_str());
        QCOMPARE(axis.session.value().output, 0.5);
    }

    void readingsThatDifferAreTakenAgain()
    {
        HandMoved axis(planOver(30.0, 4, 1, 1.0));
        int n = 0;
        axis.error = [&n](double) { return n++ % 10 == 4 ? 0.005 : 0.001; };
        axis.move(-1.0);
        axis.move(0.0);
        const std::vector<Event> events = axis.stand(60);
        QCOMPARE(std::ranges::count(events, Event::Taken), 0);
        QVERIFY(std::ranges::count(events, Event::Refused) >= 3);
        QVERIFY2(axis.problem().find("differ by 0.004 mm, more than the window of 0.001 mm")
                != std::string::npos,
            axis.problem().c_str());
        axis.error = [](double) { return 0.001; };
        QVERIFY(axis.takes());
        QVERIFY(std::abs(axis.session.value().deviation - 0.001) < 1e-12);
    }

    void anInstrumentWithoutAPositionGivesNoValue()
    {
        HandMoved axis(planOver(30.0, 4, 1, 1.0));
        axis.error = [](double) { return std::nan(""); };
        axis.move(-1.0);
        axis.move(0.0);
        QCOMPARE(axis.stand(60).back(), Event::NoReference);
        QCOMPARE(QString::fromStdString(axis.session.problem().english()),
            QStringLiteral("the instrument gives no position"));
        QCOMPARE(axis.session.due(), std::size_t{0});
    }

    void anInstrumentThatDoesNotFollowTheAxisGivesNoFurtherValue_data()
    {
        QTest::addColumn<double>("factor");
        QTest::addColumn<double>("jump");
        QTest::addColumn<QByteArray>("said");
        QTest::newRow("wrong sign") << -1.0 << 0.0
                                    << QByteArray("counts the other way; begin a new file with "
                                                  "the reference inverted");
        QTest::newRow("another unit") << 1000.0 << 0.0 << QByteArray("its unit or factor");
        QTest::newRow("factor") << 0.5 << 0.0 << QByteArray("its unit or factor");
        QTest::newRow("zero set anew") << 1.0 << 3.0 << QByteArray("its zero was set anew");
    }
    void anInstrumentThatDoesNotFollowTheAxisGivesNoFurtherValue()
    {
        QFETCH(const double, factor);
        QFETCH(const double, jump);
        QFETCH(const QByteArray, said);
        const MeasuringPlan plan = planOver(30.0, 4, 1, 1.0);
        HandMoved axis(plan);
        const double second = plan.steps[1].target;
        axis.error = [&](double position) {
            return factor * position - position + (position == second ? jump : 0.0);
        };
        axis.move(-1.0);
        axis.move(0.0);
        QVERIFY(axis.takes());
        axis.move(second);
        QCOMPARE(axis.stand(60).back() == Event::Taken, false);
        QCOMPARE(axis.session.due(), std::size_t{1});
        QVERIFY2(
            axis.problem().find(said.toStdString()) != std::string::npos, axis.problem().c_str());
        axis.error = [](double) { return 0.001; };
        QVERIFY(axis.takes());
    }

    void whatWasTakenBeforeIsComparedToo()
    {
        const MeasuringPlan plan = planOver(30.0, 4, 1, 1.0);
        const CapturedValue first = valueOf(plan, 0);
        HandMoved axis(plan, {}, std::span(&first, 1));
        axis.error = [](double position) { return -2.0 * position; };
        axis.move(plan.steps[1].approach);
        axis.move(plan.steps[1].target);
        QVERIFY(!axis.takes());
        QVERIFY2(axis.problem().find("with the reference inverted") != std::string::npos,
            axis.problem().c_str());
        axis.error = [](double) { return 0.001; };
        QVERIFY(axis.takes());
        QCOMPARE(axis.session.value().step.step, 2);
    }

    void aChangedStateStopsIt()
    {
        HandMoved axis(planOver(30.0, 4, 1, 1.0));
        axis.move(-1.0);
        axis.move(0.0);
        QVERIFY(axis.takes());
        axis.reading.state = "crc:1c291ca3";
        QCOMPARE(axis.read(), Event::Stopped);
        QVERIFY2(axis.problem().find("from off to crc:1c291ca3") != std::string::npos,
            axis.problem().c_str());
        axis.reading.state = "off";
        QCOMPARE(axis.read(), Event::Stopped);
    }

    void aTableOverOtherPositionsStopsIt()
    {
        HandMoved axis(planOver(30.0, 4, 1, 1.0));
        axis.move(-1.0);
        axis.move(0.0);
        QVERIFY(axis.takes());
        axis.reading.isSamePlace = false;
        QCOMPARE(axis.read(), Event::Stopped);
        QVERIFY2(axis.problem().find("over other positions or sources") != std::string::npos,
            axis.problem().c_str());
    }

    void aClockThatJumpsTakesNothingTwice()
    {
        HandMoved axis(planOver(30.0, 4, 1, 1.0));
        axis.move(-1.0);
        axis.move(0.0);
        (void)axis.stand(15);
        axis.reading.time -= 1h;
        const std::vector<Event> events = axis.stand(60);
        QCOMPARE(std::ranges::count(events, Event::Taken), 1);
        QVERIFY(std::ranges::find(events, Event::Taken) - events.begin() >= 28);
        axis.reading.time -= 1h;
        QCOMPARE(std::ranges::count(axis.stand(60), Event::Taken), 0);
    }

    void aLongPauseLeavesNoWayThatCounts()
    {
        const MeasuringPlan plan = planOver(30.0, 4, 1, 1.0);
        HandMoved axis(plan);
        axis.move(-1.0);
        axis.move(0.0);
        axis.reading.time += 3s;
        QCOMPARE(axis.stand(60).back(), Event::Refused);
        QCOMPARE(axis.problem(),
            "how the axis came to step 1 is not known, as nothing could be read for 3.05 s; go to "
            "-1.000 mm and come back");
        axis.move(-1.0);
        axis.move(0.0);
        QVERIFY(axis.takes());
    }

    void afterAPauseOnTheWayItIsSaidThatItWasThePause()
    {
        HandMoved axis(planOver(30.0, 4, 1, 1.0));
        axis.move(-1.0);
        axis.reading.encoder = -0.3;
        axis.reading.time += 3s;
        for (const double place : {-0.2, -0.1, 0.0}) {
            axis.reading.encoder = place;
            (void)axis.read();
        }
        QCOMPARE(axis.stand(40).back(), Event::Refused);
        QVERIFY2(axis.problem().find("nothing could be read for 3.05 s") != std::string::npos,
            axis.problem().c_str());
        // The pause does not excuse what was seen after it.
        axis.move(1.0);
        axis.move(0.0);
        QCOMPARE(axis.stand(40).back(), Event::Refused);
        QVERIFY2(axis.problem().find("did not come from below") != std::string::npos,
            axis.problem().c_str());
        for (const double place : {-0.1, -0.2, -0.3, -0.2, -0.1, 0.0}) {
            axis.reading.encoder = place;
            (void)axis.read();
        }
        QCOMPARE(axis.stand(40).back(), Event::Refused);
        QVERIFY2(axis.problem().starts_with("the axis came only 0.300 mm"), axis.problem().c_str());
    }

    void aProgramIsCapturedAndJudged()
    {
        MeasuringPlanRequest request;
        request.to = 500.0;
        request.count = 51;
        request.period = 10.0;
        const MeasuringPlan plan = makeMeasuringPlan(request).value();
        const Played played = play(plan, [](int) { return false; });
        QVERIFY2(played.values.size() == plan.steps.size(), played.problem.c_str());
        QCOMPARE(played.refusals, 0);
        QCOMPARE(played.last, Event::Done);
        QTemporaryDir folder;
        const std::filesystem::path file =
            folder.filePath(QStringLiteral("runs.csv")).toStdString();
        {
            auto runs = RunFile::open(file, plan, origin);
            QVERIFY2(runs.has_value(), runs ? "" : sentence(runs.error()).c_str());
            for (const CapturedValue& value : played.values)
                QVERIFY(runs->append(value));
        }
        const std::string text = contentOf(file);
        const MeasurementReading reading =
            chooseMeasurementFormat(text, "runs.csv", {}).value()->read(text, {});
        QVERIFY(reading.measurement.has_value());
        QCOMPARE(reading.diagnostics.size(), std::size_t{0});
        QCOMPARE(reading.measurement->header.axis, std::string("X"));
        QCOMPARE(reading.measurement->header.compensation.kind, MeasuredState::Kind::Off);
        QCOMPARE(reading.measurement->values.size(), plan.steps.size());
        const Iso230Figures figures = iso230Figures(*reading.measurement);
        QVERIFY(std::abs(figures[Iso230Figure::M].value.value() - 0.0116) < 0.0005);
        QVERIFY(std::abs(figures[Iso230Figure::B].value.value() - 0.0024) < 0.0003);
    }

    void aFaultAtAnyExchangeTakesNothingTwiceAndLosesNothingSilently()
    {
        const MeasuringPlan plan = planOver(30.0, 3, 1, 1.0);
        const Played whole = play(plan, [](int) { return false; });
        QCOMPARE(whole.values.size(), plan.steps.size());
        for (const int length : {1, 8, 60}) {
            for (int first = 0; first < 420; first += length == 1 ? 1 : 11) {
                const Played played =
                    play(plan, [&](int n) { return n >= first && n < first + length; });
                for (std::size_t i = 0; i < played.values.size(); ++i) {
                    QCOMPARE(played.values[i].step, plan.steps[i]);
                    QVERIFY(
                        std::abs(played.values[i].deviation - whole.values[i].deviation) < 1e-4);
                }
                const bool isComplete = played.values.size() == plan.steps.size();
                QVERIFY(isComplete == (played.last == Event::Done));
                QVERIFY2(
                    isComplete || played.refusals > 0, "a value was lost and nothing was said");
                QVERIFY(isComplete || length > 1); // one lost exchange hides no turn
            }
        }
    }

    void aKillAtAnyByteLeavesWholeLines()
    {
        const MeasuringPlan plan = planOver(30.0, 3, 1, 1.0);
        QTemporaryDir folder;
        const std::filesystem::path file =
            folder.filePath(QStringLiteral("runs.csv")).toStdString();
        const auto fill = [&] {
            auto runs = RunFile::open(file, plan, origin);
            if (!runs)
                return std::string(sentence(runs.error()));
            for (std::size_t step = runs->taken(); step < plan.steps.size(); ++step)
                if (!runs->append(valueOf(plan, step)))
                    return std::string("not written");
            return contentOf(file);
        };
        const std::string whole = fill();
        QCOMPARE(std::ranges::count(whole, '\n'), 8 + 6);
        for (std::size_t size = 0; size <= whole.size(); ++size) {
            put(file, std::string_view(whole).substr(0, size));
            const auto lines = std::ranges::count(whole.substr(0, size), '\n');
            {
                const auto runs = RunFile::open(file, plan, origin);
                QVERIFY2(runs.has_value(), runs ? "" : sentence(runs.error()).c_str());
                QCOMPARE(
                    static_cast<long>(runs->taken()), std::max(0L, static_cast<long>(lines) - 8));
                QCOMPARE(contentOf(file).back(), '\n'); // nothing is left of a half line
            }
            QCOMPARE(QString::fromStdString(fill()), QString::fromStdString(whole));
        }
    }

    void aValueThatIsTakenBackIsTakenAgainByThePlan()
    {
        const MeasuringPlan plan = planOver(30.0, 4, 1, 1.0);
        HandMoved axis(plan);
        axis.move(-1.0);
        axis.move(0.0);
        QVERIFY(axis.takes());
        const CapturedValue first = axis.session.value();
        axis.move(plan.steps[1].target);
        QVERIFY(axis.takes());
        // It still stands there, and for another dwell.
        axis.session.takeBack(std::span(&first, 1));
        QCOMPARE(axis.session.due(), std::size_t{1});
        const std::vector<Event> events = axis.stand(60);
        QCOMPARE(std::ranges::count(events, Event::Taken), 1);
        QCOMPARE(std::ranges::find(events, Event::Taken) - events.begin(), 19 + 9);
        QCOMPARE(axis.session.value().step, plan.steps[1]);
        // It has left the target meanwhile, and has to come to it again.
        axis.move(plan.steps[2].target);
        axis.session.takeBack(std::span(&first, 1));
        QCOMPARE(axis.stand(60).back(), Event::Refused);
        QVERIFY2(axis.problem().find("step 2 at") != std::string::npos, axis.problem().c_str());
        axis.move(plan.steps[1].approach - 0.5);
        axis.move(plan.steps[1].target);
        QVERIFY2(axis.takes(), axis.problem().c_str());
        QCOMPARE(axis.session.value().step, plan.steps[1]);
        axis.session.takeBack({});
        QCOMPARE(axis.session.due(), std::size_t{0});
    }

    void theLastLineIsTakenOffTheFile()
    {
        const MeasuringPlan plan = planOver(30.0, 3, 1, 1.0);
        QTemporaryDir folder;
        const std::filesystem::path file =
            folder.filePath(QStringLiteral("runs.csv")).toStdString();
        std::vector<std::string> after;
        {
            auto runs = RunFile::open(file, plan, origin).value();
            after.push_back(contentOf(file));
            for (std::size_t step = 0; step < 3; ++step) {
                QVERIFY(runs.append(valueOf(plan, step)));
                after.push_back(contentOf(file));
            }
            QVERIFY(runs.removeLast());
            QCOMPARE(contentOf(file), after[2]);
            QCOMPARE(runs.taken(), std::size_t{2});
        }
        auto again = RunFile::open(file, plan, origin).value();
        QCOMPARE(again.taken(), std::size_t{2});
        QVERIFY(again.removeLast());
        QVERIFY(again.append(valueOf(plan, 1)));
        QVERIFY(again.append(valueOf(plan, 2)));
        QCOMPARE(contentOf(file), after[3]);
        for (std::size_t left = 3; left > 0; --left) {
            QVERIFY(again.removeLast());
            QCOMPARE(contentOf(file), after[left - 1]);
        }
    }

    /// An editor saves by a new file of the same name, or by writing the old one anew.
    void aFileThatAnotherProgramChangesMeanwhileTakesNoFurtherValue_data()
    {
        using Change = std::function<void(const std::filesystem::path&)>;
        QTest::addColumn<Change>("change");
        QTest::newRow("replaced") << Change([](const std::filesystem::path& file) {
            const std::string content = contentOf(file);
            std::filesystem::rename(file, file.string() + "~");
            put(file, content);
        });
        QTest::newRow("deleted") << Change(
            [](const std::filesystem::path& file) { std::filesystem::remove(file); });
        QTest::newRow("longer") << Change([](const std::filesystem::path& file) {
            std::ofstream(file, std::ios::app) << "// Kim\n";
        });
        QTest::newRow("shorter") << Change([](const std::filesystem::path& file) {
            std::ofstream(file, std::ios::trunc) << "// axiscomp runs: 1\n";
        });
    }
    void aFileThatAnotherProgramChangesMeanwhileTakesNoFurtherValue()
    {
        QFETCH(const std::function<void(const std::filesystem::path&)>, change);
        const MeasuringPlan plan = planOver(30.0, 3, 1, 1.0);
        QTemporaryDir folder;
        const std::filesystem::path file =
            folder.filePath(QStringLiteral("runs.csv")).toStdString();
        auto runs = RunFile::open(file, plan, origin).value();
        QVERIFY(runs.append(valueOf(plan, 0)));
        change(file);
        const bool isThere = std::filesystem::exists(file);
        const std::string changed = isThere ? contentOf(file) : std::string();
        const auto refused = runs.append(valueOf(plan, 1));
        VERIFY_ERROR(refused, ErrorCode::FileNotWritable);
        const std::string said = sentence(refused.error());
        QVERIFY2(said.find("replaced, changed or deleted") != std::string::npos, said.c_str());
        VERIFY_ERROR(runs.removeLast(), ErrorCode::FileNotWritable);
        QCOMPARE(runs.taken(), std::size_t{1});
        QCOMPARE(std::filesystem::exists(file), isThere);
        QCOMPARE(isThere ? contentOf(file) : std::string(), changed);
    }

    void aKillWhileAValueIsTakenBackLeavesItOrTakesItWhole()
    {
        const MeasuringPlan plan = planOver(30.0, 3, 1, 1.0);
        QTemporaryDir folder;
        const std::filesystem::path file =
            folder.filePath(QStringLiteral("runs.csv")).toStdString();
        const auto fill = [&] {
            auto runs = RunFile::open(file, plan, origin).value();
            for (std::size_t step = runs.taken(); step < 3; ++step)
                QVERIFY(runs.append(valueOf(plan, step)));
        };
        fill();
        const std::string before = contentOf(file);
        const std::string after =
            before.substr(0, before.find_last_of('\n', before.size() - 2) + 1);
        int taken = 0;
        const int moments = test::killEverywhere(
            [&] {
                auto runs = RunFile::open(file, plan, origin);
                if (runs)
                    (void)runs->removeLast();
            },
            [&] {
                const std::string content = contentOf(file);
                QVERIFY2(content == before || content == after, content.c_str());
                taken += content == after ? 1 : 0;
                fill();
                QCOMPARE(contentOf(file), before);
            });
        QVERIFY(moments > 5 && taken > 0 && taken < moments);
    }

    /// Whether the instrument corrects for the temperature by itself is known to nobody here.
    void aCapturedFileDoesNotSayThatNothingWasCorrected()
    {
        const MeasuringPlan plan = planOver(30.0, 3, 1, 1.0);
        QTemporaryDir folder;
        const std::filesystem::path file =
            folder.filePath(QStringLiteral("runs.csv")).toStdString();
        std::string whole;
        {
            auto runs = RunFile::open(file, plan, origin).value();
            for (std::size_t step = 0; step < plan.steps.size(); ++step)
                QVERIFY(runs.append(valueOf(plan, step)));
            whole = contentOf(file);
        }
        const auto format = measurementFormatNamed("runs");
        VERIFY_RESULT(format);
        const MeasurementReading reading = (*format)->read(whole, {});
        QVERIFY(reading.measurement);
        QCOMPARE(reading.measurement->header.corrected, MeasurementHeader::Corrected::NotSaid);
        // A person who knows writes it into the file, and the same command goes on with it.
        whole.insert(whole.find("target ["), "// corrected: 20C\n");
        put(file, whole);
        const auto again = RunFile::open(file, plan, origin);
        VERIFY_RESULT(again);
        QCOMPARE(again->taken(), plan.steps.size());
    }

    void aFileOfSomethingElseIsRefusedAndLeftAsItIs()
    {
        const MeasuringPlan plan = planOver(30.0, 3, 1, 1.0);
        QTemporaryDir folder;
        const std::filesystem::path file =
            folder.filePath(QStringLiteral("runs.csv")).toStdString();
        const auto refusal = [&](const std::string& content, const std::string& state = "off") {
            put(file, content);
            const auto runs = RunFile::open(file, plan, {state, "laser", "now"});
            if (runs)
                return std::string("it was taken");
            return contentOf(file) == content ? sentence(runs.error()) : "it was changed";
        };
        QVERIFY(refusal("hello").find("something else than captured values") != std::string::npos);
        QVERIFY(refusal("a,b\n1,2\n").find("something else") != std::string::npos);
        std::string whole;
        put(file, "");
        {
            auto runs = RunFile::open(file, plan, origin).value();
            QVERIFY(runs.append(valueOf(plan, 0)));
            whole = contentOf(file);
        }
        {
            const auto again = RunFile::open(file, plan, origin).value();
            QCOMPARE(again.values().size(), std::size_t{1});
            QVERIFY(std::abs(again.values()[0].deviation + 0.0023) < 1e-12);
            QCOMPARE(again.values()[0].time, std::chrono::nanoseconds(0));
        }
        const std::string otherState = refusal(whole, "crc:1c291ca3");
        QVERIFY2(otherState.find("line 4 has \"// compensation: off\" where // compensation: "
                                 "crc:1c291ca3 is expected")
                != std::string::npos,
            otherState.c_str());
        std::string otherAxis = whole;
        otherAxis.replace(otherAxis.find("// axis: "), 10, "// axis: Q");
        QVERIFY(refusal(otherAxis).find("where // axis: ") != std::string::npos);
        std::string otherPlan = whole;
        otherPlan.replace(otherPlan.find("\n0.000,+,1,") + 1, 5, "0.001");
        const std::string said = refusal(otherPlan);
        QVERIFY2(
            said.find("where step 1 of the plan, 0.000,+,1,... is expected") != std::string::npos,
            said.c_str());
        std::string damaged = whole;
        damaged.replace(damaged.rfind(",0.000"), 6, ",now");
        QVERIFY(refusal(damaged).find("step 1 of the plan") != std::string::npos);
        for (const char* late : {",1795892006764.000", ",9223372036.900", ",1e300"}) {
            damaged = whole;
            damaged.replace(damaged.rfind(",0.000"), 6, late);
            QVERIFY2(refusal(damaged).find("step 1 of the plan") != std::string::npos, late);
        }
        std::string otherInstrument = whole;
        otherInstrument.replace(otherInstrument.find("laser"), 5, "ruler");
        QVERIFY(
            refusal(otherInstrument).find("// reference: laser is expected") != std::string::npos);
        std::string otherFeed = whole;
        otherFeed.replace(otherFeed.find("1000 mm/min"), 4, "500");
        QVERIFY(refusal(otherFeed).find("// feed: 1000 mm/min is expected") != std::string::npos);
        std::string otherDwell = whole;
        otherDwell.replace(otherDwell.find("2.5 s"), 3, "40");
        QVERIFY(refusal(otherDwell).find("// dwell: 2.5 s is expected") != std::string::npos);
        std::string repeated = whole + whole.substr(whole.find("\n0.000,") + 1);
        QVERIFY(refusal(repeated).find("step 2 of the plan") != std::string::npos);
    }

    void aFileGoesOnWithTheSameRawPositionOnly()
    {
        const MeasuringPlan plan = planOver(30.0, 3, 1, 1.0);
        QTemporaryDir folder;
        const std::filesystem::path file =
            folder.filePath(QStringLiteral("runs.csv")).toStdString();
        RunOrigin master = origin;
        master.encoder = "Axes[0]/MasterPosition";
        {
            auto runs = RunFile::open(file, plan, master).value();
            QVERIFY(runs.append(valueOf(plan, 0)));
        }
        const std::string whole = contentOf(file);
        RunOrigin other = origin;
        other.encoder = "Axes[0]/Encoders[0]/Position";
        const auto refused = RunFile::open(file, plan, other);
        const std::string said = refused ? "it was taken" : sentence(refused.error());
        QVERIFY2(said.find("\"// encoder: Axes[0]/MasterPosition\" where // encoder: "
                           "Axes[0]/Encoders[0]/Position is expected")
                != std::string::npos,
            said.c_str());
        QCOMPARE(contentOf(file), whole);
        QCOMPARE(RunFile::open(file, plan, master).value().taken(), std::size_t{1});
        // Those of earlier versions do not say it.
        std::string silent = whole;
        const std::size_t begin = silent.find("// encoder: ");
        silent.erase(begin, silent.find('\n', begin) + 1 - begin);
        put(file, silent);
        QCOMPARE(RunFile::open(file, plan, other).value().taken(), std::size_t{1});
    }

    /// An axis X is on many drives.
    void aFileGoesOnWithTheSameDriveOnly()
    {
        const MeasuringPlan plan = planOver(30.0, 3, 1, 1.0);
        QTemporaryDir folder;
        const std::filesystem::path file =
            folder.filePath(QStringLiteral("runs.csv")).toStdString();
        RunOrigin mill = origin;
        mill.drive = DriveIdentity{"Mill", 4711, 2};
        {
            auto runs = RunFile::open(file, plan, mill).value();
            QVERIFY(runs.append(valueOf(plan, 0)));
        }
        const std::string whole = contentOf(file);
        RunOrigin other = origin;
        other.drive = DriveIdentity{"Mill", 4712, 2};
        const auto refused = RunFile::open(file, plan, other);
        const std::string said = refused ? "it was taken" : sentence(refused.error());
        QVERIFY2(said.find("\"// drive: Mill, serial number 4711\" where // drive: Mill, serial "
                           "number 4712 is expected")
                != std::string::npos,
            said.c_str());
        QCOMPARE(contentOf(file), whole);
        mill.drive->name = "Lathe"; // a new name is no new drive
        QCOMPARE(RunFile::open(file, plan, mill).value().taken(), std::size_t{1});
        // Those of earlier versions do not say it.
        std::string silent = whole;
        const std::size_t begin = silent.find("// drive: ");
        silent.erase(begin, silent.find('\n', begin) + 1 - begin);
        put(file, silent);
        QCOMPARE(RunFile::open(file, plan, other).value().taken(), std::size_t{1});
    }

    /// The CRC of a table is that of its values alone.
    void aFileGoesOnWithATableOverTheSamePositionsOnly()
    {
        const MeasuringPlan plan = planOver(30.0, 3, 1, 1.0);
        QTemporaryDir folder;
        const std::filesystem::path file =
            folder.filePath(QStringLiteral("runs.csv")).toStdString();
        RunOrigin active{"crc:1c291ca3", "laser", "2026-11-21T09:30:00"};
        active.tablePlace = "MasterPosition from 0, 11 points every 10";
        {
            auto runs = RunFile::open(file, plan, active).value();
            QVERIFY(runs.append(valueOf(plan, 0)));
        }
        const std::string whole = contentOf(file);
        QVERIFY2(whole.find("\n// table: MasterPosition from 0, 11 points every 10\n")
                != std::string::npos,
            whole.c_str());
        RunOrigin other = active;
        other.tablePlace = "MasterPosition from 5, 11 points every 10";
        const auto refused = RunFile::open(file, plan, other);
        const std::string said = refused ? "it was taken" : sentence(refused.error());
        QVERIFY2(
            said.find("where // table: MasterPosition from 5") != std::string::npos, said.c_str());
        QCOMPARE(contentOf(file), whole);
        QCOMPARE(RunFile::open(file, plan, active).value().taken(), std::size_t{1});
        // Those of earlier versions do not say it.
        std::string silent = whole;
        const std::size_t begin = silent.find("// table: ");
        silent.erase(begin, silent.find('\n', begin) + 1 - begin);
        put(file, silent);
        QCOMPARE(RunFile::open(file, plan, other).value().taken(), std::size_t{1});
    }

    void aDriveWithoutANameIsToldByItsSerialNumber()
    {
        const MeasuringPlan plan = planOver(30.0, 3, 1, 1.0);
        QTemporaryDir folder;
        const std::filesystem::path file =
            folder.filePath(QStringLiteral("runs.csv")).toStdString();
        RunOrigin nameless = origin;
        nameless.drive = DriveIdentity{"", 4711, 2};
        {
            auto runs = RunFile::open(file, plan, nameless).value();
            QVERIFY(runs.append(valueOf(plan, 0)));
        }
        QVERIFY(contentOf(file).find("\n// drive: serial number 4711\n") != std::string::npos);
        QCOMPARE(RunFile::open(file, plan, nameless).value().taken(), std::size_t{1});
        nameless.drive->serialNumber = 7;
        VERIFY_ERROR(RunFile::open(file, plan, nameless), ErrorCode::FileNotReadable);
    }

    void aFileWithoutAValueBeginsAnew()
    {
        const MeasuringPlan plan = planOver(30.0, 3, 1, 1.0);
        QTemporaryDir folder;
        const std::filesystem::path file =
            folder.filePath(QStringLiteral("runs.csv")).toStdString();
        QVERIFY(RunFile::open(file, plan, {"off", "a much longer name of a laser", "then"}));
        QVERIFY(RunFile::open(file, plan, origin));
        const std::string text = contentOf(file);
        QVERIFY2(text.find("// reference: laser\n") != std::string::npos, text.c_str());
        QCOMPARE(std::ranges::count(text, '\n'), 8);
    }

    void twoProgramsCannotWriteToOneFile()
    {
        const MeasuringPlan plan = planOver(30.0, 3, 1, 1.0);
        QTemporaryDir folder;
        const std::filesystem::path file =
            folder.filePath(QStringLiteral("runs.csv")).toStdString();
        const auto first = RunFile::open(file, plan, origin);
        QVERIFY(first.has_value());
        const auto second = RunFile::open(file, plan, origin);
        VERIFY_ERROR(second, ErrorCode::FileNotWritable);
        VERIFY_ERROR(
            RunFile::open(folder.path().toStdString(), plan, origin), ErrorCode::FileNotWritable);
    }
};

AXISCOMP_TEST(tst_Capture)

} // namespace tst_capture

#include "tst_capture.moc"
