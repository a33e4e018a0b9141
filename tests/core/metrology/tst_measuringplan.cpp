// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/fixed_random.h"
#include "core/metrology/gcode.h"
#include "core/metrology/measuring_plan.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>

namespace tst_measuringplan {

using namespace axiscomp;

namespace {

MeasuringPlanRequest usualRequest()
{
    MeasuringPlanRequest request;
    request.from = 0.0;
    request.to = 500.0;
    request.count = 51;
    return request;
}

MeasuringPlan planOf(const MeasuringPlanRequest& request)
{
    auto plan = makeMeasuringPlan(request);
    if (!plan)
        qFatal("%s", sentence(plan.error()).c_str());
    return *std::move(plan);
}

std::string refusal(const MeasuringPlanRequest& request)
{
    const auto plan = makeMeasuringPlan(request);
    return plan ? std::string() : sentence(plan.error());
}

std::string program(MeasuringPlanRequest request, GcodeDialect dialect)
{
    const auto text = gcodeProgram(planOf(request), dialect);
    return text ? *text : sentence(text.error());
}

const std::string shortPlan = "// axiscomp plan: 1\n// axis: X\n// overrun: 1.000 mm\n"
                              "// feed: 600 mm/min\n// dwell: 2.5 s\n// seed: 3\n"
                              "step,run,direction,target [mm],approach [mm]\n"
                              "1,1,+,0.000,-1.000\n2,1,+,10.000,0.000\n"
                              "3,1,-,10.000,11.000\n4,1,-,0.000,10.000\n";

} // namespace

class tst_MeasuringPlan : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void randomNumbersAreThePublishedOnes()
    {
        // SplitMix64 with the seed 1234567, as published with the Java and the C version.
        FixedRandom random(1234567);
        QCOMPARE(random.next(), std::uint64_t{6457827717110365317U});
        QCOMPARE(random.next(), std::uint64_t{3203168211198807973U});
        QCOMPARE(random.next(), std::uint64_t{9817491932198370423U});
        QCOMPARE(random.next(), std::uint64_t{4593380528125082431U});
    }

    void normalNumbersAreNormal()
    {
        FixedRandom random({5, 7});
        double sum = 0.0;
        double squares = 0.0;
        int beyondTwo = 0;
        constexpr int count = 200'000;
        for (int i = 0; i < count; ++i) {
            const double value = random.normal();
            sum += value;
            squares += value * value;
            beyondTwo += std::abs(value) > 2.0 ? 1 : 0;
        }
        QVERIFY(std::abs(sum / count) < 0.01);
        QVERIFY(std::abs(squares / count - 1.0) < 0.02);
        QVERIFY(std::abs(static_cast<double>(beyondTwo) / count - 0.0455) < 0.003);
    }

    void targetsKeepTheRules_data()
    {
        QTest::addColumn<double>("to");
        QTest::addColumn<int>("count");
        QTest::addColumn<double>("period");
        QTest::newRow("no period") << 500.0 << 51 << 0.0;
        QTest::newRow("period of the spacing") << 500.0 << 51 << 10.0;
        QTest::newRow("short period") << 500.0 << 51 << 2.0;
        QTest::newRow("long period") << 300.0 << 31 << 40.0;
        QTest::newRow("two targets") << 10.0 << 2 << 5.0;
        QTest::newRow("close targets") << 0.99 << 100 << 0.0;
    }
    void targetsKeepTheRules()
    {
        QFETCH(const double, to);
        QFETCH(const int, count);
        QFETCH(const double, period);
        MeasuringPlanRequest request = usualRequest();
        request.to = to;
        request.count = count;
        if (period > 0.0)
            request.period = period;
        const double spacing = to / (count - 1);
        const double reach = period > 0.0 ? period : 0.3 * spacing;
        for (request.seed = 1; request.seed <= 50; ++request.seed) {
            const MeasuringPlan plan = planOf(request);
            const std::vector<double> targets = targetsOf(plan);
            QCOMPARE(targets.size(), static_cast<std::size_t>(count));
            QCOMPARE(targets.front(), 0.0);
            QCOMPARE(targets.back(), to);
            for (std::size_t i = 1; i < targets.size(); ++i)
                QVERIFY(targets[i] - targets[i - 1] > spacing / 3.0 - 1e-9);
            for (std::size_t i = 0; i < targets.size(); ++i) {
                QVERIFY(std::abs(targets[i] - static_cast<double>(i) * spacing) < reach + 1e-9);
                QCOMPARE(targets[i], std::round(targets[i] * 1000.0) / 1000.0);
            }
        }
    }

    void targetsAreSpreadOverThePeriod()
    {
        // Even over all phases: the mean of exp(2 pi i P / period) is near 0. On an even plan whose
        // spacing is the period it would be 1.
        MeasuringPlanRequest request = usualRequest();
        request.period = 10.0;
        double cosines = 0.0;
        double sines = 0.0;
        double offsets = 0.0;
        int count = 0;
        for (request.seed = 1; request.seed <= 100; ++request.seed) {
            const std::vector<double> targets = targetsOf(planOf(request));
            for (std::size_t i = 10; i + 10 < targets.size(); ++i, ++count) {
                cosines += std::cos(2.0 * std::numbers::pi * targets[i] / 10.0);
                sines += std::sin(2.0 * std::numbers::pi * targets[i] / 10.0);
                offsets += targets[i] - 10.0 * static_cast<double>(i);
            }
        }
        QVERIFY2(std::hypot(cosines, sines) / count < 0.1, "the targets favour a phase");
        QVERIFY2(std::abs(offsets / count) < 0.5, "the targets drift to one side");
    }

    void withoutAPeriodTargetsAreEvenInTheirReach()
    {
        MeasuringPlanRequest request = usualRequest();
        std::array<int, 6> bins{};
        for (request.seed = 1; request.seed <= 100; ++request.seed) {
            const std::vector<double> targets = targetsOf(planOf(request));
            for (std::size_t i = 1; i + 1 < targets.size(); ++i) {
                const double share = (targets[i] - 10.0 * static_cast<double>(i) + 3.0) / 6.0;
                ++bins.at(std::min<std::size_t>(5, static_cast<std::size_t>(share * 6.0)));
            }
        }
        for (const int bin : bins) // 4900 draws, 817 in each of 6; their spread is 26
            QVERIFY(std::abs(bin - 817) < 110);
    }

    void theSameSeedGivesTheSamePlanOnEveryMachine()
    {
        MeasuringPlanRequest request = usualRequest();
        request.period = 10.0;
        request.seed = 7;
        // The rule of measuring_plan.cpp, written once more in another language, gives these.
        const std::vector<double> first{
            0.0, 14.018, 26.717, 34.602, 41.166, 46.579, 58.425, 68.885};
        const std::vector<double> targets = targetsOf(planOf(request));
        QVERIFY(std::ranges::equal(first, std::span(targets).first(first.size())));
        MeasuringPlanRequest other = request;
        other.seed = 8;
        QVERIFY(targetsOf(planOf(request)) != targetsOf(planOf(other)));
    }

    void eachCycleGoesUpAndDownWithOverruns()
    {
        MeasuringPlanRequest request = usualRequest();
        request.count.reset();
        request.spacing = 100.0;
        request.overrun = 2.5;
        request.cycles = 2;
        const MeasuringPlan plan = planOf(request);
        QCOMPARE(plan.steps.size(), std::size_t{24});
        const std::vector<double> targets = targetsOf(plan);
        for (std::size_t i = 0; i < plan.steps.size(); ++i) {
            const MeasuringStep& step = plan.steps[i];
            const std::size_t place = i % 6;
            const bool isUp = i / 6 % 2 == 0;
            QCOMPARE(step.step, static_cast<int>(i) + 1);
            QCOMPARE(step.run, static_cast<int>(i / 12) + 1);
            QCOMPARE(step.direction == Approach::Up, isUp);
            QCOMPARE(step.target, isUp ? targets[place] : targets[5 - place]);
            const double before = isUp ? -2.5 : 502.5;
            QCOMPARE(step.approach, place == 0 ? before : plan.steps[i - 1].target);
        }
    }

    void withoutAnOverrunItIsAPercentOrAThirdOfTheSpacing()
    {
        MeasuringPlanRequest request = usualRequest();
        QCOMPARE(planOf(request).overrun, 3.334); // spacing 10
        request.count = 6;
        QCOMPARE(planOf(request).overrun, 5.0);
    }

    void aPlanReadsBack()
    {
        MeasuringPlanRequest request = usualRequest();
        request.axis = "Y";
        request.period = 5.0;
        const MeasuringPlan plan = planOf(request);
        const auto read = readMeasuringPlan(measuringPlanCsv(plan), "plan.csv");
        QVERIFY2(read.has_value(), read ? "" : sentence(read.error()).c_str());
        QVERIFY(*read == plan);
        request.isAngular = true;
        request.period.reset();
        const MeasuringPlan angles = planOf(request);
        QVERIFY(measuringPlanCsv(angles).find("target [deg]") != std::string::npos);
        QVERIFY(readMeasuringPlan(measuringPlanCsv(angles), "plan.csv").value() == angles);
    }

    void theFileIsAsDocumented()
    {
        const auto read = readMeasuringPlan(shortPlan, "plan.csv");
        QVERIFY2(read.has_value(), read ? "" : sentence(read.error()).c_str());
        QCOMPARE(measuringPlanCsv(*read), shortPlan);
    }

    void badPlansNameTheLine_data()
    {
        QTest::addColumn<QString>("before");
        QTest::addColumn<QString>("after");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* name, const char* before, const char* after,
                             const char* said) {
            QTest::newRow(name) << QString::fromUtf8(before) << QString::fromUtf8(after)
                                << QString::fromUtf8(said);
        };
        row("step", "2,1,+,10", "3,1,+,10", "line 9: \"3\"; expected: step 2");
        row("run", "1,1,+,0", "1,0,+,0", "line 8: \"0\"; expected: the number of a run, from 1");
        row("direction", "1,1,+,0", "1,1,up,0", "line 8: \"up\"; expected: the direction + or -");
        row("target", "10.000,0.000", "ten,0.000", "line 9: \"ten\"; expected: a position");
        row("side", "0.000,-1.000", "0.000,1.000",
            "line 8: \"1.000\"; expected: a position below the target, since the axis moves up");
        row("side down", "10.000,11.000", "10.000,9.000",
            "line 10: \"9.000\"; expected: a position above the target, since the axis moves down");
        row("twice", "10.000,0.000", "0.000,-1.000",
            "line 9: \"0.000\"; expected: each target once in a run; it has this one already");
        row("cells", "1,1,+,0.000,-1.000", "1,1,+,0.000",
            "line 8: \"1,1,+,0.000\"; expected: five cells, as the header has");
        row("header", "target [mm]", "target [um]",
            "expected: the header step,run,direction,target [mm],approach [mm]");
        row("version", "plan: 1", "plan: 2", "line 1: \"2\"; expected: version 1");
        row("dwell", "dwell: 2.5 s", "dwell: long", "line 5: \"long\"; expected: a number above 0");
        row("seed", "seed: 3", "seed: 3.5", "line 6: \"3.5\"; expected: a whole number");
        row("control characters", "10.000,0.000", "10\x1b,0.000", "line 9: \"10");
    }
    void badPlansNameTheLine()
    {
        QFETCH(const QString, before);
        QFETCH(const QString, after);
        QFETCH(const QString, said);
        QString text = QString::fromStdString(shortPlan);
        text.replace(text.indexOf(before), before.size(), after);
        const auto read = readMeasuringPlan(text.toStdString(), "plan.csv");
        VERIFY_ERROR(read, ErrorCode::FileNotReadable);
        const QString reason = QString::fromStdString(sentence(read.error()));
        QVERIFY2(reason.contains(said), qPrintable(reason));
        QVERIFY2(!reason.contains(QChar(0x1b)), qPrintable(reason));
    }

    void aPlanWithoutStepsIsNone()
    {
        const auto read = readMeasuringPlan("// axiscomp plan: 1\n", "plan.csv");
        VERIFY_ERROR(read, ErrorCode::FileNotReadable);
        QCOMPARE(QString::fromStdString(sentence(read.error())),
            QStringLiteral("plan.csv cannot be read: there is no step in it; expected: a plan as "
                           "axiscomp targets writes it"));
    }

    void everyDialectHasItsOwnDwell()
    {
        MeasuringPlanRequest request = usualRequest();
        request.count = 2;
        request.cycles = 1;
        request.dwellSeconds = 2.5;
        request.overrun = 1.0;
        const std::string moves = "G1 X-1.000 F1000\nG1 X0.000 F1000\n";
        const std::string linuxcnc = program(request, GcodeDialect::LinuxCnc);
        QVERIFY2(linuxcnc.find("G21 G90 G94\n(STEP 1 RUN 1 UP)\n" + moves + "G4 P2.5\n")
                != std::string::npos,
            linuxcnc.c_str());
        QVERIFY2(linuxcnc.find("CANCEL WORK OFFSETS AND DIAMETER") != std::string::npos,
            linuxcnc.c_str());
        QVERIFY(linuxcnc.ends_with("G1 X0.000 F1000\nG4 P2.5\nM2\n"));
        const std::string fanuc = program(request, GcodeDialect::Fanuc);
        QVERIFY2(fanuc.starts_with("%\nO0001\n("), fanuc.c_str());
        QVERIFY2(fanuc.find("(STEP 1 RUN 1 UP)\n" + moves + "G04 P2500\n") != std::string::npos,
            fanuc.c_str());
        QVERIFY(fanuc.ends_with("G04 P2500\nM30\n%\n"));
        const std::string siemens = program(request, GcodeDialect::Siemens);
        QVERIFY2(siemens.find("G710 G90 G94\n; STEP 1 RUN 1 UP\n" + moves + "G4 F2.5\n")
                != std::string::npos,
            siemens.c_str());
        QVERIFY(siemens.ends_with("M30\n"));
    }

    void programsVisitThePlanAndDoNothingElse_data()
    {
        QTest::addColumn<int>("dialect");
        QTest::newRow("linuxcnc") << 0;
        QTest::newRow("fanuc") << 1;
        QTest::newRow("siemens") << 2;
    }
    void programsVisitThePlanAndDoNothingElse()
    {
        QFETCH(const int, dialect);
        MeasuringPlanRequest request = usualRequest();
        request.cycles = 2;
        const MeasuringPlan plan = planOf(request);
        QStringList lines = QString::fromStdString(program(request, GcodeDialect{dialect}))
                                .split(QLatin1Char('\n'), Qt::SkipEmptyParts);
        // Moves, dwells, and the words around them: no T, S, M3, M8 or anything else.
        static const QRegularExpression known(
            QStringLiteral("^(%|O0001|(G21|G710) G90 G94|G1 X-?\\d+\\.\\d{3} F1000|G0?4 "
                           "[PF]\\d+|M2|M30|\\([A-Z0-9 "
                           ".-]+\\)|; [A-Z0-9 .-]+)$"));
        std::vector<double> visited;
        std::optional<double> position;
        for (const QString& line : lines) {
            QVERIFY2(known.match(line).hasMatch(), qPrintable(line));
            if (line.startsWith(QStringLiteral("G1 ")))
                position = line.section(QLatin1Char(' '), 1, 1).mid(1).toDouble();
            else if (line.startsWith(QStringLiteral("G4 "))
                || line.startsWith(QStringLiteral("G04")))
                visited.push_back(position.value());
        }
        QCOMPARE(visited.size(), plan.steps.size());
        for (std::size_t i = 0; i < visited.size(); ++i)
            QCOMPARE(visited[i], plan.steps[i].target);
    }

    void aProgramOnlyNamesAxesThatTheControlHas()
    {
        MeasuringPlanRequest request = usualRequest();
        request.axis = "X1";
        QVERIFY(
            program(request, GcodeDialect::Siemens).find("G1 X1=0.000 F1000") != std::string::npos);
        QVERIFY(program(request, GcodeDialect::LinuxCnc)
                    .find("a program for linuxcnc cannot move an axis \"X1\"; name one of X")
            != std::string::npos);
        for (const char* const axis : {"", "F", "x", "X M8", "X\nM8", "M3"}) {
            MeasuringPlan plan = planOf(usualRequest());
            plan.axis = axis; // as a file may have it
            for (const GcodeDialect dialect :
                {GcodeDialect::LinuxCnc, GcodeDialect::Fanuc, GcodeDialect::Siemens})
                QVERIFY2(!gcodeProgram(plan, dialect), axis);
        }
    }

    void aFaultNamesItsField()
    {
        using Field = MeasuringPlanField;
        const auto fieldOf = [](const std::function<void(MeasuringPlanRequest&)>& spoil) {
            MeasuringPlanRequest request = usualRequest();
            spoil(request);
            const auto fault = measuringPlanFault(request);
            const auto plan = makeMeasuringPlan(request);
            if (!fault || plan || !sentence(plan.error()).ends_with(fault->reason.english()))
                qFatal("no fault, or another one than that of the plan");
            return fault->field;
        };
        QVERIFY(!measuringPlanFault(usualRequest()));
        QCOMPARE(fieldOf([](auto& request) { request.axis = " "; }), Field::Axis);
        QCOMPARE(fieldOf([](auto& request) { request.from = 0.0001; }), Field::From);
        QCOMPARE(fieldOf([](auto& request) { request.to = -1.0; }), Field::To);
        QCOMPARE(fieldOf([](auto& request) { request.count = 1; }), Field::Targets);
        QCOMPARE(fieldOf([](auto& request) { request.period = -1.0; }), Field::Period);
        QCOMPARE(fieldOf([](auto& request) { request.cycles = 0; }), Field::Cycles);
        QCOMPARE(fieldOf([](auto& request) { request.cycles = 1000; }), Field::Cycles);
        QCOMPARE(fieldOf([](auto& request) { request.overrun = 0.0; }), Field::Overrun);
        QCOMPARE(fieldOf([](auto& request) { request.feedPerMinute = 0.0; }), Field::Feed);
        QCOMPARE(fieldOf([](auto& request) { request.dwellSeconds = 0.0; }), Field::Dwell);
    }

    void requestsThatCannotBeAreRefusedWithAWayOut_data()
    {
        QTest::addColumn<MeasuringPlanRequest>("request");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* name, const auto& change, const char* said) {
            MeasuringPlanRequest request = usualRequest();
            change(request);
            QTest::newRow(name) << request << QString::fromUtf8(said);
        };
        using Request = MeasuringPlanRequest;
        row(
            "order", [](Request& r) { r.from = 600.0; }, "exchange the two");
        row(
            "same", [](Request& r) { r.from = 500.0; }, "exchange the two");
        row(
            "nan", [](Request& r) { r.to = NAN; }, "must lie within 1000000 mm of zero");
        row(
            "decimals", [](Request& r) { r.to = 499.9995; },
            "499.9995 mm has more than the three decimals");
        row(
            "both", [](Request& r) { r.spacing = 10.0; }, "one of the two");
        row(
            "neither", [](Request& r) { r.count.reset(); }, "one of the two");
        row(
            "wide", [](Request& r) { r.count.reset(), r.spacing = 501.0; },
            "at most the distance of the ends, 500 mm");
        row(
            "one", [](Request& r) { r.count = 1; }, "a plan has 2 to 10000 targets, not 1");
        row(
            "many", [](Request& r) { r.count.reset(), r.spacing = 0.01; },
            "2 to 10000 targets, not 50001");
        row(
            "close", [](Request& r) { r.to = 0.5, r.count = 52; },
            "52 targets would be closer than 0.01 mm");
        row(
            "steps", [](Request& r) { r.count = 10000, r.cycles = 6; },
            "more than 100000 steps; choose fewer targets or cycles");
        row(
            "period", [](Request& r) { r.period = 0.0; }, "leave it out if none is known");
        row(
            "overrun", [](Request& r) { r.overrun = 0.0; }, "the overrun must be above 0");
        row(
            "overrun decimals", [](Request& r) { r.overrun = 0.0005; }, "round it");
        row(
            "feed", [](Request& r) { r.feedPerMinute = -1.0; },
            "the feed must be above 0 and at most 1000000 mm/min");
        row(
            "dwell", [](Request& r) { r.dwellSeconds = 0.0; },
            "the dwell must be above 0 s and at most 3600 s");
        row(
            "cycles", [](Request& r) { r.cycles = 0; }, "at least one cycle is needed");
    }
    void requestsThatCannotBeAreRefusedWithAWayOut()
    {
        QFETCH(const MeasuringPlanRequest, request);
        QFETCH(const QString, said);
        const QString reason = QString::fromStdString(refusal(request));
        QVERIFY2(reason.contains(said), qPrintable(reason));
    }
};

AXISCOMP_TEST(tst_MeasuringPlan)

} // namespace tst_measuringplan

#include "tst_measuringplan.moc"
