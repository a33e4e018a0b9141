// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/capture_request.h"
#include "core/capture/capture_run.h"
#include "core/compensator/axis_compensator.h"
#include "core/io/local_file.h"
#include "core/metrology/formats/measurement_format.h"
#include "drivecomm/capture/number_pattern.h"
#include "drivecomm/profile/profile_loader.h"
#include "drivecomm/virtualdrive/machine/machine_file.h"
#include "drivecomm/virtualdrive/machine/program_motion.h"
#include "tests/support/compensator_fixture.h"
#include "tests/support/faulty_link.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTemporaryDir>

#include <cmath>
#include <functional>
#include <set>

namespace tst_capturerun {

using namespace axiscomp;
using namespace axiscomp::drivecomm;
using namespace std::chrono_literals;
using test::LinkFault;
using Kind = CaptureNews::Kind;

namespace {

/// A straight error of 12 um/m, so that every deviation is known: without waves, noise and map.
const std::string straight =
    R"({"axes": {"X": {"slope": 12e-6}, "Y": {}}, "instrument": {"axis": "X"}})";
const std::string referenceRegister = "Machine/Axes[0]/ReferencePosition";
const std::string encoder = "Axes[0]/Signals/PositionController/MasterPosition";

MeasuringPlan planOf(const std::string& axis = "X", bool isAngular = false)
{
    MeasuringPlanRequest request;
    request.axis = axis;
    request.isAngular = isAngular;
    request.to = 30.0;
    request.count = 3;
    request.cycles = 1;
    request.overrun = 1.0;
    request.dwellSeconds = 2.5;
    return makeMeasuringPlan(request).value();
}

/// The straight machine, moved by the plan, and what captures it; time passes only by step().
struct CaptureFixture {
    explicit CaptureFixture(const std::filesystem::path& file = {})
        : drive(VirtualDrive::create(genericProfile(), options()).value())
        , link(*drive)
        , store(std::filesystem::path(folder.path().toStdString()) / "axiscomp")
        , compensator(link, genericProfile(), store)
        , path(file.empty() ? folder.filePath(QStringLiteral("runs.csv")).toStdString()
                            : file.string())
    {
    }

    VirtualDriveOptions options()
    {
        VirtualDriveOptions options;
        options.machine = parseMachine(straight, "straight").value();
        options.program = plan;
        options.programStart = 500ms;
        options.clock = [this] { return time; };
        return options;
    }
    [[nodiscard]] Result<AxisReadings> readings(const CaptureRegisters& registers,
        const ReferenceScale& scale = {}, int axis = 0, const MeasuringPlan& of = planOf())
    {
        AXISCOMP_TRY(const auto status, compensator.status(axis));
        return AxisReadings::open(link, genericProfile(), status, of, registers, scale, {});
    }
    [[nodiscard]] std::string refusal(const CaptureRegisters& registers,
        const ReferenceScale& scale = {}, int axis = 0, const MeasuringPlan& of = planOf())
    {
        const auto opened = readings(registers, scale, axis, of);
        return opened ? "it was taken" : sentence(opened.error());
    }
    [[nodiscard]] Result<void> open(
        const std::string& reference = referenceRegister, const CaptureRules& rules = {})
    {
        AXISCOMP_TRY(auto opened, readings({encoder, reference}));
        AXISCOMP_TRY(auto file, RunFile::open(path, plan, {opened.state(), "laser", "now"}));
        run.emplace(
            std::move(opened), std::move(file), plan, rules, compensator.identify().value());
        return {};
    }
    [[nodiscard]] Result<CaptureNews> step()
    {
        time += 50ms;
        return run->read(link, [this] { return time; }, {});
    }
    /// Until the program has ended, or the plan has all its values.
    struct Played {
        std::vector<CaptureNews> news; ///< without Nothing and Moving, unless the drive is back
        std::optional<Error> error;
        [[nodiscard]] std::vector<Kind> kinds() const
        {
            std::vector<Kind> all;
            for (const CaptureNews& each : news)
                all.push_back(each.kind);
            return all;
        }
    };
    Played play(const std::function<void()>& before = {})
    {
        Played played;
        const double seconds = ProgramMotion(plan, plan.steps.front().approach).endSeconds() + 6.0;
        for (int n = 0; n < static_cast<int>(20.0 * seconds); ++n) {
            if (before)
                before();
            const auto news = step();
            if (!news) {
                played.error = news.error();
                break;
            }
            if (news->isBack || (news->kind != Kind::Nothing && news->kind != Kind::Moving))
                played.news.push_back(*news);
            if (news->kind == Kind::Done || news->kind == Kind::Stopped)
                break;
        }
        return played;
    }

    QTemporaryDir folder;
    std::chrono::nanoseconds time{0};
    MeasuringPlan plan = planOf();
    std::unique_ptr<VirtualDrive> drive;
    test::FaultyLink link;
    DriveStore store;
    AxisCompensator compensator;
    std::filesystem::path path;
    std::optional<CaptureRun> run;
};

std::string contentOf(const std::filesystem::path& file)
{
    const auto bytes = loadFile(file, 1'000'000);
    return bytes ? std::string(asText(*bytes)) : std::string();
}

/// Every value of the plan once, and right.
void verifyComplete(const std::filesystem::path& file, const MeasuringPlan& plan)
{
    const std::string text = contentOf(file);
    const auto reading = chooseMeasurementFormat(text, "runs.csv", {}).value()->read(text, {});
    QVERIFY(reading.measurement.has_value());
    QCOMPARE(reading.measurement->values.size(), plan.steps.size());
    for (const RunValue& value : reading.measurement->values) {
        const double target = reading.measurement->targets[value.target];
        QVERIFY(std::abs(value.deviation - 12e-6 * target) < 1e-7);
    }
}

ReferenceLineReader readerOf(const std::string& unit = {}, const std::string& pattern = {})
{
    ReferenceScale scale;
    scale.unit = unit;
    return ReferenceLineReader::make(scale, false, numberPattern(pattern).value()).value();
}

} // namespace

class tst_CaptureRun : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void everythingIsReadInOneRequestAndNothingIsWritten()
    {
        CaptureFixture fixture;
        QVERIFY(fixture.open());
        const int before = fixture.link.exchanges();
        std::set<std::string> kinds;
        fixture.link.beginning = [&](std::string_view what) { kinds.emplace(what); };
        int steps = 0;
        const auto played = fixture.play([&] { ++steps; });
        QVERIFY(!played.error);
        QCOMPARE(played.kinds(),
            (std::vector<Kind>{
                Kind::Taken, Kind::Taken, Kind::Taken, Kind::Taken, Kind::Taken, Kind::Done}));
        QCOMPARE(fixture.link.exchanges() - before, steps);
        QCOMPARE(kinds, std::set<std::string>{"read"});
        verifyComplete(fixture.path, fixture.plan);
    }

    void aFaultAtAnyExchangeTakesNothingTwiceAndLosesNothing_data()
    {
        QTest::addColumn<int>("fault");
        QTest::addColumn<int>("every"); // exchange: a drive that only reads is the same after all
        QTest::newRow("request lost") << static_cast<int>(LinkFault::RequestLost) << 1;
        QTest::newRow("reply lost") << static_cast<int>(LinkFault::ReplyLost) << 7;
        QTest::newRow("reply garbled") << static_cast<int>(LinkFault::ReplyGarbled) << 7;
        QTest::newRow("late") << static_cast<int>(LinkFault::Late) << 7;
    }
    void aFaultAtAnyExchangeTakesNothingTwiceAndLosesNothing()
    {
        QFETCH(const int, fault);
        QFETCH(const int, every);
        bool isReached = true;
        for (int number = 1; isReached; number += every) {
            CaptureFixture fixture;
            QVERIFY(fixture.open());
            fixture.link.failAt(number, static_cast<LinkFault>(fault));
            const auto played = fixture.play();
            isReached = fixture.link.hasFailed();
            QVERIFY(!played.error);
            QCOMPARE(std::ranges::count(played.kinds(), Kind::Lost), static_cast<long>(isReached));
            QCOMPARE(std::ranges::any_of(played.news, &CaptureNews::isBack), isReached);
            verifyComplete(fixture.path, fixture.plan);
        }
    }

    void aDriveThatIsGoneIsWaitedForAndMissedTargetsAreSaid()
    {
        CaptureFixture fixture;
        QVERIFY(fixture.open());
        fixture.link.failAt(60, LinkFault::DriveGone);
        int exchanges = 0;
        const auto played = fixture.play([&] {
            if (++exchanges == 160)
                fixture.link.heal();
        });
        QVERIFY(!played.error);
        QCOMPARE(std::ranges::count(played.kinds(), Kind::Lost), 1);
        const auto refused = std::ranges::find(played.news, Kind::Refused, &CaptureNews::kind);
        QVERIFY(refused != played.news.end());
        QVERIFY(fixture.run->taken() < fixture.plan.steps.size());
        // The same file goes on, while the machine plays its program once more.
        const std::size_t taken = fixture.run->taken();
        const std::filesystem::path file = fixture.path;
        fixture.run.reset();
        CaptureFixture again(file);
        QVERIFY(again.open());
        QCOMPARE(again.run->taken(), taken);
        QCOMPARE(again.play().kinds().back(), Kind::Done);
        verifyComplete(file, again.plan);
    }

    void anotherDriveAtTheSameAddressIsRefused()
    {
        CaptureFixture fixture;
        QVERIFY(fixture.open());
        fixture.link.failAt(30, LinkFault::RequestLost);
        fixture.link.altersIdentity = [](DriveIdentity& drive) { drive.serialNumber = 1; };
        const auto played = fixture.play();
        QVERIFY(played.error);
        QCOMPARE(played.error->code, ErrorCode::OtherDrive);
    }

    void whatTheDriveRefusesEndsIt()
    {
        CaptureFixture fixture;
        QVERIFY(fixture.open());
        fixture.link.failAt(30, LinkFault::Refused);
        const auto played = fixture.play();
        QVERIFY(played.error);
        QCOMPARE(played.error->code, ErrorCode::DriveRejected);
    }

    void aDriveThatStartsAgainIsNotHomedAndStopsIt()
    {
        CaptureFixture fixture;
        QVERIFY(fixture.open());
        const std::string homing = "Axes[0]/Signals/Homing/State";
        int n = 0;
        fixture.link.altersReading = [&](RegisterReading& reading) {
            if (reading.path == homing && ++n > 40)
                reading.value = std::string("NotHomed");
        };
        const auto played = fixture.play();
        QCOMPARE(played.kinds().back(), Kind::Stopped);
        QVERIFY2(played.news.back().text.english().find("lost its homing") != std::string::npos,
            played.news.back().text.english().c_str());
    }

    void aTableThatIsSwitchedOnMeanwhileStopsIt()
    {
        CaptureFixture fixture;
        QVERIFY(fixture.open());
        int n = 0;
        fixture.link.altersReading = [&](RegisterReading& reading) {
            if (reading.path == "Axes[0]/Signals/Compensations/Axis/State" && ++n > 40)
                reading.value = std::string("Active");
        };
        const auto played = fixture.play();
        QCOMPARE(played.kinds().back(), Kind::Stopped);
        QVERIFY2(played.news.back().text.english().find("from off to on") != std::string::npos,
            played.news.back().text.english().c_str());
    }

    /// Another program writes the same values over other positions, or for another source.
    void aTableOverOtherPositionsStopsIt_data()
    {
        QTest::addColumn<QByteArray>("changed");
        QTest::newRow("positions") << QByteArray("/Header/StartValue[0]");
        QTest::newRow("source") << QByteArray("/Compensations/Axis/Dim1Source");
    }
    void aTableOverOtherPositionsStopsIt()
    {
        QFETCH(const QByteArray, changed);
        CaptureFixture fixture;
        WriteRequest request;
        request.dimensionality = 1;
        request.sources = {encoder};
        request.table = test::exampleTable(1, 1, 11);
        fixture.link.beginning = [&](std::string_view) { fixture.time += 1ms; };
        VERIFY_RESULT(fixture.compensator.write(0, request));
        fixture.link.beginning = {};
        bool isChanged = false;
        fixture.link.altersReading = [&](RegisterReading& reading) {
            if (reading.path == "Axes[0]/Signals/Compensations/Axis/State")
                reading.value = std::string("Active");
            if (isChanged && QByteArray::fromStdString(reading.path).endsWith(changed))
                reading.value = std::string("another");
        };
        const auto opened = fixture.readings({encoder, referenceRegister});
        VERIFY_RESULT(opened);
        QCOMPARE(opened->tablePlace(), encoder + " from 0, 11 points every 10");
        QVERIFY(opened->state().starts_with("crc:"));
        const auto same = opened->read(fixture.link, {});
        VERIFY_RESULT(same);
        QVERIFY(same->isSamePlace);
        isChanged = true;
        const auto other = opened->read(fixture.link, {});
        VERIFY_RESULT(other);
        QCOMPARE(other->state, opened->state());
        QVERIFY(!other->isSamePlace);
    }

    /// Readings are as fast as the drive answers, and each register takes its time.
    void whereATableLiesIsNotReadWhileItIsOff()
    {
        CaptureFixture fixture;
        WriteRequest request;
        request.dimensionality = 1;
        request.sources = {encoder};
        request.table = test::exampleTable(1, 1, 11);
        fixture.link.beginning = [&](std::string_view) { fixture.time += 1ms; };
        VERIFY_RESULT(fixture.compensator.write(0, request));
        fixture.link.beginning = {};
        const auto opened = fixture.readings({encoder, referenceRegister}, {.unit = "mm"});
        VERIFY_RESULT(opened);
        QCOMPARE(opened->state(), std::string("off"));
        std::vector<std::string> paths;
        fixture.link.altersReading = [&](RegisterReading& reading) {
            paths.push_back(reading.path);
            if (reading.path == referenceRegister)
                reading.value = 12.5F;
        };
        const auto reading = opened->read(fixture.link, {});
        VERIFY_RESULT(reading);
        QCOMPARE(paths.size(), 7U);
        QCOMPARE(paths.back(), referenceRegister);
        QCOMPARE(reading->reference, 12.5);
        QVERIFY(reading->isSamePlace);
    }

    /// Plans are in mm or deg, whatever the axis is in.
    void aPlanOfTheOtherKindIsRefusedWithTheUnitThatItNeeds()
    {
        CaptureFixture fixture;
        auto status = fixture.compensator.status(0);
        VERIFY_RESULT(status);
        const auto refusal = [&](const char* unit, const MeasuringPlan& plan) {
            status->axis.unit = unit;
            const auto opened = AxisReadings::open(fixture.link, genericProfile(), *status, plan,
                {encoder, referenceRegister}, {}, {});
            return opened ? "it was taken" : sentence(opened.error());
        };
        const std::string metres = refusal("Meter", planOf("X", true));
        QVERIFY2(metres.find("in m: make a plan in mm,") != std::string::npos, metres.c_str());
        const std::string radians = refusal("Radian", planOf("X"));
        QVERIFY2(radians.find("in rad: make a plan in deg,") != std::string::npos, radians.c_str());
    }

    void whatCannotBeCapturedIsRefusedBeforeAnythingIsTaken()
    {
        CaptureFixture fixture;
        const auto contains = [](const std::string& text, std::string_view part) {
            if (text.find(part) == std::string::npos)
                qWarning("%s", text.c_str());
            return text.find(part) != std::string::npos;
        };
        const CaptureRegisters right{encoder, referenceRegister};
        QVERIFY(contains(fixture.refusal(right, {}, 0, planOf("Y")),
            "the plan is for axis Y, and this is axis X"));
        QVERIFY(contains(fixture.refusal(right, {}, 0, planOf("X", true)),
            "the plan is in deg, and axis X of the drive in mm"));
        QVERIFY(contains(
            fixture.refusal({encoder, encoder}), "follows the encoder of the axis itself"));
        QVERIFY(contains(
            fixture.refusal({encoder, "Axes[0]/Signals/PositionController/ActualPosition"}),
            "follows the encoder of the axis itself"));
        QVERIFY(contains(fixture.refusal({encoder, "Axes[0]/Signals/Compensations/Axis/State"}),
            "which is no position"));
        QVERIFY(contains(fixture.refusal({encoder, "Machine/Axes[0]/ReferencePositon"}),
            "Machine/Axes[0]/ReferencePositon"));
        ReferenceScale angular;
        angular.unit = "arcsec";
        QVERIFY(contains(fixture.refusal(right, angular), "the instrument is in arcsec"));
        fixture.link.altersReading = [](RegisterReading& reading) {
            if (reading.path == "Axes[0]/Signals/Homing/State")
                reading.value = std::string("NotHomed");
        };
        QVERIFY(contains(fixture.refusal(right), "axis X must be homed first"));
        fixture.link.altersReading = [](RegisterReading& reading) {
            if (reading.path == "Axes[0]/Signals/Compensations/Axis/State")
                reading.value = std::string("Ramping");
        };
        QVERIFY(contains(fixture.refusal(right), "neither on nor off (the drive says Ramping)"));
        // There is no table whose CRC the file of the values could name.
        fixture.link.altersReading = [](RegisterReading& reading) {
            if (reading.path == "Axes[0]/Signals/Compensations/Axis/State")
                reading.value = std::string("Active");
        };
        QVERIFY(contains(fixture.refusal(right), "the drive does not say with which table"));
        // Ramping only when it is read for the capture itself
        int states = 0;
        fixture.link.altersReading = [&states](RegisterReading& reading) {
            if (reading.path == "Axes[0]/Signals/Compensations/Axis/State" && ++states > 1)
                reading.value = std::string("Ramping");
        };
        QVERIFY(contains(fixture.refusal(right), "neither on nor off (the drive says Ramping)"));
    }

    void theEncoderIsAPositionOfTheAxisBeforeItsCompensation()
    {
        CaptureFixture fixture;
        const auto said = [&](const std::string& path) {
            return fixture.refusal({path, referenceRegister});
        };
        for (const std::string path :
            {"Axes[0]/Signals/PathPlanner/Position", // behind its compensation
                "Axes[1]/Signals/PositionController/MasterPosition", // of the other axis
                "Machine/Axes[0]/ReferencePosition2"}) { // of no axis, as far as it is known
            const std::string text = said(path);
            QVERIFY2(text.find(path + " is no position of axis X before its compensation")
                    != std::string::npos,
                text.c_str());
        }
        QCOMPARE(said(encoder), std::string("it was taken"));
        QCOMPARE(said("Axes[0]/Signals/PositionController/Encoders[0]/Position"),
            std::string("it was taken"));
    }

    void aProfileWithoutRawPositionsLeavesTheEncoderToTheUser()
    {
        CaptureFixture fixture;
        DriveProfile profile = genericProfile();
        profile.positionKinds.before.clear();
        const auto status = fixture.compensator.status(0);
        VERIFY_RESULT(status);
        const auto open = [&](const std::string& path) {
            return AxisReadings::open(
                fixture.link, profile, *status, planOf(), {path, referenceRegister}, {}, {});
        };
        VERIFY_RESULT(open(encoder));
        VERIFY_ERROR(open("Axes[0]/Signals/PathPlanner/Position"), ErrorCode::InvalidArgument);
    }

    void aSingleSaysHowFarItsNumbersAreApart()
    {
        CaptureFixture fixture;
        const auto whole = fixture.readings({encoder, referenceRegister});
        QVERIFY(whole && !whole->resolutionAt(500.0));
        fixture.link.altersReading = [](RegisterReading& reading) {
            if (reading.path == referenceRegister)
                reading.value = static_cast<float>(toDouble(reading.value));
        };
        const auto single = fixture.readings({encoder, referenceRegister});
        QVERIFY(single.has_value());
        QCOMPARE(single->resolutionAt(500.0).value(), std::ldexp(1.0, 8 - 23)); // 256 <= 500 < 512
        ReferenceScale metres;
        metres.unit = "m";
        const auto inMetres = fixture.readings({encoder, referenceRegister}, metres);
        QCOMPARE(inMetres->resolutionAt(500.0).value(), 1000.0 * std::ldexp(1.0, -1 - 23));
    }

    void anInstrumentOfLinesIsTakenOnlyWhileItSpeaks()
    {
        CaptureFixture fixture;
        QVERIFY(fixture.open({}));
        ReferenceLines lines(readerOf(), 1s);
        fixture.run->setInstrument([&](std::chrono::nanoseconds now) { return lines.at(now); });
        const auto silent = fixture.play();
        QCOMPARE(fixture.run->taken(), std::size_t{0});
        QVERIFY(std::ranges::count(silent.kinds(), Kind::NoReference) >= 1);
        QVERIFY2(silent.news.front().text.english().starts_with("the instrument says nothing"),
            silent.news.front().text.english().c_str());
        CaptureFixture speaking;
        QVERIFY(speaking.open({}));
        speaking.run->setInstrument([&](std::chrono::nanoseconds now) {
            const double x = speaking.run->lastReading().encoder;
            lines.feed(
                QByteArray::number(1000.0 * x * (1 + 12e-6), 'f', 4).toStdString() + " um\r\n",
                now);
            return lines.at(now);
        });
        QCOMPARE(speaking.play().kinds().back(), Kind::Done);
        verifyComplete(speaking.path, speaking.plan);
    }

    void aTypedPositionIsAskedForTakenAndTakenBack()
    {
        CaptureFixture fixture;
        // The program goes on after 2.5 s, and two values are taken before.
        CaptureRules rules;
        rules.dwell = 300ms;
        QVERIFY(fixture.open({}, rules));
        CaptureRun& run = *fixture.run;
        run.setTyped(readerOf("mm"));
        QCOMPARE(run.type("0.001").english(),
            std::string("no position is asked for at the moment: wait until the axis stands at its "
                        "target"));
        const auto stepUntil = [&](const std::function<bool()>& condition) {
            for (int n = 0; n < 400 && !condition(); ++n)
                if (!fixture.step())
                    return false;
            return condition();
        };
        QVERIFY(stepUntil([&] { return run.isAsked(); }));
        QVERIFY(!run.type("what?").isEmpty());
        QVERIFY(run.isAsked());
        QVERIFY(run.type("0.002").isEmpty());
        QVERIFY(!run.isAsked());
        QVERIFY(stepUntil([&] { return run.taken() == 1; }));
        QVERIFY(std::abs(run.value().deviation - 0.002) < 1e-9);
        // A slip of the pen, while the axis still stands there
        QVERIFY(run.undo());
        QCOMPARE(run.taken(), std::size_t{0});
        QVERIFY(run.values().empty());
        QVERIFY(contentOf(fixture.path).find("0.000,+,1,") == std::string::npos);
        QVERIFY(stepUntil([&] { return run.isAsked(); }));
        QVERIFY(run.type("0.001").isEmpty());
        QVERIFY(stepUntil([&] { return run.taken() == 1; }));
        QVERIFY(std::abs(run.value().deviation - 0.001) < 1e-9);
    }

    void nothingIsTakenBackFromAFileWithoutValues()
    {
        CaptureFixture fixture;
        QVERIFY(fixture.open());
        QVERIFY(fixture.run->undo());
        QCOMPARE(fixture.play().kinds().back(), Kind::Done);
        verifyComplete(fixture.path, fixture.plan);
    }

    void linesAreReadOrSaidToBeWrong_data()
    {
        QTest::addColumn<QString>("line");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<QString>("pattern");
        QTest::addColumn<double>("position"); // NaN: a problem
        QTest::addColumn<QString>("problem");
        const double none = std::nan("");
        QTest::newRow("unit in it") << "+517.3000042 mm"
                                    << ""
                                    << "" << 517.3000042 << "";
        QTest::newRow("unit stated") << "-.5"
                                     << "um"
                                     << "" << -0.0005 << "";
        QTest::newRow("both") << "X: 12.5e1um;OK"
                              << "um"
                              << "" << 0.125 << "";
        QTest::newRow("inch") << "1 inch"
                              << ""
                              << "" << 25.4 << "";
        QTest::newRow("words behind") << "3.25 OK"
                                      << "mm"
                                      << "" << 3.25 << "";
        QTest::newRow("dash") << "A-3.5 mm"
                              << ""
                              << "" << -3.5 << "";
        QTest::newRow("pattern") << "7;3,25;1"
                                 << "mm"
                                 << "^\\d+;([^;]*);" << 3.25 << "";
        QTest::newRow("pattern without a group") << "P7 3.5"
                                                 << "mm"
                                                 << "\\d+\\.\\d+" << 3.5 << "";
        QTest::newRow("nonsense") << "%$!"
                                  << "mm"
                                  << "" << none
                                  << "the instrument says \"%$!\", where a number is expected";
        QTest::newRow("no match") << "12.5"
                                  << "mm"
                                  << "x(.*)" << none << "a pattern says where it is";
        QTest::newRow("match of no number") << "xERR"
                                            << "mm"
                                            << "x(.*)" << none << "a pattern says where it is";
        QTest::newRow("comma") << "517,300 mm"
                               << ""
                               << "" << none << "has a comma";
        for (const char* line :
            {"+24\u00b035'29.4\"", "+24\u00b0 35' 29.4\"", "+24 35 29.4", "24:35:29.4", "24d35m29s",
                "24 deg 35 min", "35'29.4\"", "12.3 20.1 C", "1\t517.3 mm"})
            QTest::newRow(line) << line << "mm"
                                << "" << none << "another number follows its first one";
        QTest::newRow("a second column behind a unit") << "12.3 mm 20.1 C"
                                                       << "mm"
                                                       << "" << 12.3 << "";
        QTest::newRow("a second field") << "12.3;20.1"
                                        << "mm"
                                        << "" << 12.3 << "";
        QTest::newRow("no unit") << "517.300"
                                 << ""
                                 << "" << none << "without a unit: state the unit";
        QTest::newRow("another unit") << "517.300 inch"
                                      << "mm"
                                      << "" << none << "in another unit than mm";
        QTest::newRow("an angle") << "5 arcsec"
                                  << ""
                                  << "" << none << "in another unit than mm";
        QTest::newRow("beyond a double") << "1e999 mm"
                                         << ""
                                         << "" << none << "a number is expected";
    }
    void linesAreReadOrSaidToBeWrong()
    {
        QFETCH(const QString, line);
        QFETCH(const QString, unit);
        QFETCH(const QString, pattern);
        QFETCH(const double, position);
        QFETCH(const QString, problem);
        const InstrumentReading reading =
            readerOf(unit.toStdString(), pattern.toStdString()).read(line.toStdString());
        const std::string said = reading.problem.english();
        QVERIFY2(said.find(problem.toStdString()) != std::string::npos, said.c_str());
        QCOMPARE(std::isnan(reading.position), std::isnan(position));
        QCOMPARE(said.empty(), !std::isnan(position));
        QVERIFY(std::isnan(position) || std::abs(reading.position - position) < 1e-12);
    }

    void aSignBeforeANumberBelongsToItWithBlanksBetweenAndAsAMinusSign()
    {
        struct Case {
            const char* line;
            double position;
            const char* pattern = "";
        };
        for (const Case& each :
            {Case{"-     0.0035 mm", -0.0035}, {"X +\t20.0046 mm", 20.0046}, {"- .5 mm", -0.5},
                {"\u22120.0035 mm", -0.0035}, {"L \u2212  3.5 mm", -3.5}, {"3.5e\u22122 mm", 0.035},
                {"P7;-   3.5", -3.5, ";.*?([-+]?[0-9.]+)"}, {"P7;-   3,5", -3.5, ";([^;]*)"},
                {"P7;\u22123.5", -3.5, "([-+]?\\d+\\.\\d+)"}, {"P7 - 3.5", 3.5, " - ([0-9.]+)"}}) {
            const auto reading = readerOf("mm", each.pattern).read(each.line);
            QVERIFY2(std::abs(reading.position - each.position) < 1e-12, each.line);
        }
    }

    void aNumberIsTakenOnlyWhereItStandsByItself_data()
    {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<QByteArray>("problem");
        for (const char* line : {"+24.468\u202f446", "24.468\u00a0446 mm", "7\u2009000.5 mm",
                 "7\u200b000.5 mm", "X1: -0.0035 mm", "X1: 0.0035 mm", "CH2 -42.5 mm",
                 "CH2 - 42.5 mm", "12.3 \u22120.5", "12-5 mm", "24\u00b0-35'", "0.002.345 mm",
                 "13..5 mm", "36.444.5 mm", "12.3 .5",
                 "24.468\xA0"
                 "446 mm"})
            QTest::newRow(line) << QByteArray(line) << QByteArray("another number follows");
        for (const char* line : {"12.3#45 mm", "7_000.5", "34.5e mm", "34.5e+ mm", "0x10 mm",
                 "12\u00b75 mm", "12\u2019345.6 mm", "3.5- mm", "3.5 - mm", "3.5 \u2013",
                 "12.5 E-3 mm", "5/8 inch", "20.1\u00b0C", "12.5 ft", "/84.5 mm", "-+56.5 mm",
                 "--56.5 mm", "- -56.5 mm", "-/56.5", "\u00b156.5 mm", "\u00b1 56.5 mm", "-,5 mm",
                 ",5 mm", "..5 mm", "CH2: OVER", "X12.5 mm", "#1 mm", ">12.5 mm", "(12.5) mm"})
            QTest::newRow(line) << QByteArray(line)
                                << QByteArray("not clear where its number begins and ends");
    }
    void aNumberIsTakenOnlyWhereItStandsByItself()
    {
        QFETCH(const QByteArray, line);
        QFETCH(const QByteArray, problem);
        const InstrumentReading reading = readerOf("mm").read(line.toStdString());
        const std::string said = reading.problem.english();
        QVERIFY2(said.find(problem.toStdString()) != std::string::npos, said.c_str());
        QVERIFY2(said.find("with a pattern") != std::string::npos, said.c_str());
        QVERIFY(std::isnan(reading.position));
    }

    void namesSeparatorsAndFramesStandRoundANumber()
    {
        struct Case {
            const char* line;
            double position;
        };
        for (const Case& each : {Case{"\x02+0012.345\x03", 12.345}, {"X+12.5mm", 12.5},
                 {"X = 12.5 mm", 12.5}, {"Pos. 12.5 mm", 12.5}, {"Position (X) -12.5", -12.5},
                 {"OK;12.5", 12.5}, {"X,12.5,mm", 12.5}, {"{\"x\":12.5}", 12.5},
                 {"\u00a0\u202f12.5\u00a0mm", 12.5}, {"12.5 mm -20.1 C", 12.5},
                 {"12.5, -20.1", 12.5}, {"\u4f4d\u7f6e: 12.5 \u6beb\u7c73", 12.5}}) {
            const auto reading = readerOf("mm").read(each.line);
            QVERIFY2(reading.problem.isEmpty(), reading.problem.english().c_str());
            QCOMPARE(reading.position, each.position);
        }
    }

    void everyKindOfMinusIsOneWithAnyBlankBehindIt()
    {
        for (const char* line :
            {"\u20130.0035 mm", "\u20140.0035 mm", "\u2010 0.0035 mm", "\uff0d0.0035 mm",
                "-\u00a0\u20090.0035 mm", "\u200e-0.0035 mm", "\x96 0.0035 mm", "-3.5 \xB5m"}) {
            const auto reading = readerOf().read(line);
            QVERIFY2(reading.problem.isEmpty(), reading.problem.english().c_str());
            QCOMPARE(reading.position, -0.0035);
        }
        const auto found = readerOf("mm", "\t.*?([-+]?[0-9.]+)").read("P7\t\u2013\u00a03.5");
        QCOMPARE(found.position, -3.5);
    }

    /// Another pattern may find another number.
    void theReferenceOfAFileNamesThePattern()
    {
        CaptureReference reference;
        reference.kind = CaptureReference::Kind::Typed;
        reference.scale.unit = "mm";
        QCOMPARE(reference.text(), std::string("typed [mm]"));
        reference.pattern = "=(.*);\n";
        QCOMPARE(reference.text(), std::string("typed [mm], pattern =(.*);\u240a"));
        reference.kind = CaptureReference::Kind::Serial;
        reference.source = "serial:/dev/ttyUSB1?baud=9600";
        reference.scale.zeroAt = 12.5;
        QCOMPARE(reference.text(),
            std::string("serial:/dev/ttyUSB1?baud=9600 [mm], 0 at 12.5, pattern =(.*);\u240a"));
    }

    void signAndZeroOfAnInstrumentAreTakenOut()
    {
        ReferenceScale scale;
        scale.isInverted = true;
        scale.zeroAt = 100.0;
        const auto reader = ReferenceLineReader::make(scale, false).value();
        QCOMPARE(reader.read("-3.5 mm").position, 103.5);
        VERIFY_ERROR(numberPattern("("), ErrorCode::InvalidArgument);
        scale.unit = "kg";
        VERIFY_ERROR(ReferenceLineReader::make(scale, false), ErrorCode::InvalidArgument);
    }

    void degreesWithADecimalPointHaveNoMinutes()
    {
        const auto reader = ReferenceLineReader::make({}, true).value();
        QCOMPARE(reader.read("24.5\u00b0 20.1 C").position, 24.5);
        QCOMPARE(reader.read("24.5 deg 3").position, 24.5);
        QVERIFY(std::isnan(reader.read("24\u00b035'29.4\"").position));
    }

    void onlyTheNewestWholeLineCountsAndOnlyForASecond()
    {
        ReferenceLines lines(readerOf(), 5s);
        lines.feed("1.5 mm\r\n2.5 m", 10s);
        QCOMPARE(lines.at(10s).position, 1.5);
        lines.feed("m\n", 10500ms);
        QCOMPARE(lines.at(11500ms).position, 2.5);
        QVERIFY(std::isnan(lines.at(11501ms).position));
        QVERIFY(std::isnan(lines.at(9s).position)); // a clock that jumped
        lines.feed("\n\n", 12s);
        QVERIFY(std::isnan(lines.at(12s).position)); // nothing was said
        lines.feed(std::string(100'000, '7') + "\n", 13s);
        QVERIFY(std::isnan(lines.at(13s).position));
        lines.feed("3.5 mm\n", 14s);
        QCOMPARE(lines.at(14s).position, 3.5);
        // No longer than the axis has stood when its value is taken.
        ReferenceLines quick(readerOf(), 400ms);
        quick.feed("4.5 mm\n", 10s);
        QCOMPARE(quick.at(10400ms).position, 4.5);
        QVERIFY(std::isnan(quick.at(10401ms).position));
    }

    void noLineIsReadOfWhichAPartIsMissing()
    {
        ReferenceLines lines(readerOf("mm"), 5s);
        const std::string blanks(ReferenceLines::longestLine - 4, ' ');
        lines.feed(blanks + "1.25\n", 9s);
        QCOMPARE(lines.at(9s).position, 1.25);
        lines.feed(blanks + "517.3000042\n", 10s);
        QVERIFY(std::isnan(lines.at(10s).position));
        QVERIFY(
            lines.at(10s).problem.english().find("more than 4096 characters") != std::string::npos);
        // The port was opened while "517.3000042" was said, and once more after "51".
        lines.beginWithinLine();
        lines.feed("7.3000042\n", 11s);
        QVERIFY(std::isnan(lines.at(11s).position));
        lines.feed("517.3000042\r\n51", 12s);
        QCOMPARE(lines.at(12s).position, 517.3000042);
        lines.beginWithinLine();
        lines.feed("42\n517.3000043\n", 13s);
        QCOMPARE(lines.at(13s).position, 517.3000043);
        // An end that is of two characters is one.
        lines.beginWithinLine();
        lines.feed("42\r\n", 14s);
        QCOMPARE(lines.at(14s).position, 517.3000043);
    }

    void aTypedNumberThatSurprisesIsAskedForOnceMore()
    {
        TypedReference typed(readerOf("mm"), {}, 0.001);
        CaptureReading axis;
        axis.encoder = 10.0;
        axis.output = 0.002;
        QVERIFY(std::isnan(typed.reading().position));
        QVERIFY(!typed.type("what?", axis, false).isEmpty());
        const std::string question = typed.type("10.5", axis, false).english();
        QVERIFY2(question.starts_with("10.5 mm is 498.000 um from the encoder: type it once more"),
            question.c_str());
        QVERIFY(!typed.type("10.6", axis, false).isEmpty()); // another one: asked again
        QVERIFY(typed.type("10.6", axis, false).isEmpty());
        QCOMPARE(typed.reading().position, 10.6);
        typed.forget();
        QVERIFY(typed.type("10.005", axis, false).isEmpty());
        CapturedValue value;
        value.step.target = 10.0;
        value.deviation = 0.005;
        value.encoder = 10.0;
        value.output = 0.002;
        typed.taken(value);
        QVERIFY(std::isnan(typed.reading().position));
        QVERIFY(typed.type("10.0319", axis, false).isEmpty()); // within ten times 3 um
        const std::string more = typed.type("10.0321", axis, false).english();
        QVERIFY2(more.find("until now it was 3.000 um at most") != std::string::npos, more.c_str());
        TypedReference later(readerOf("mm"), std::span(&value, 1), 0.001);
        QVERIFY(!later.type("10.0321", axis, false).isEmpty());
    }
};

AXISCOMP_TEST(tst_CaptureRun)

} // namespace tst_capturerun

#include "tst_capturerun.moc"
