// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fit/table_fit.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QFile>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

namespace tst_tablefit {

using namespace axiscomp;
using Numbers = std::vector<double>;
using Values = std::vector<MeasuredValue>;

namespace {

constexpr double pi = std::numbers::pi;

/// A public measurement, tests/data/metrology; lines target,direction,run,deviation in mm.
Values measurement(const char* name)
{
    QFile file(QStringLiteral(AXISCOMP_SOURCE_FOLDER "/tests/data/metrology/%1.csv")
                   .arg(QLatin1String(name)));
    Values values;
    if (!file.open(QIODevice::ReadOnly))
        return values;
    for (const QByteArray& line : file.readAll().split('\n')) {
        const QList<QByteArray> cells = line.split(',');
        if (cells.size() == 4 && !line.startsWith("target"))
            values.push_back({cells[0].toDouble(), cells[1] == "+", cells[2].toULongLong(),
                cells[3].toDouble()});
    }
    return values;
}

/// Figures of ISO 230-2.
struct Figures {
    double reversal = 0.0; // B
    double range = 0.0; // M
    double systematic = 0.0; // E
    double repeatability = 0.0; // R
    double accuracy = 0.0; // A
};

Figures figuresOf(const Values& values)
{
    std::map<double, std::array<Numbers, 2>> targets;
    for (const MeasuredValue& value : values)
        targets[value.target][value.isUp ? 0 : 1].push_back(value.deviation);
    Numbers means;
    Numbers both;
    Numbers high;
    Numbers low;
    Figures figures;
    for (const auto& [target, directions] : targets) {
        std::array<double, 2> mean{};
        std::array<double, 2> s{};
        for (std::size_t d = 0; d < 2; ++d) {
            const auto n = static_cast<double>(directions[d].size());
            for (const double x : directions[d])
                mean[d] += x / n;
            for (const double x : directions[d])
                s[d] += (x - mean[d]) * (x - mean[d]) / (n - 1.0);
            s[d] = std::sqrt(s[d]);
            both.push_back(mean[d]);
            high.push_back(mean[d] + 2.0 * s[d]);
            low.push_back(mean[d] - 2.0 * s[d]);
        }
        const double b = std::abs(mean[0] - mean[1]);
        means.push_back(0.5 * (mean[0] + mean[1]));
        figures.reversal = std::max(figures.reversal, b);
        figures.repeatability =
            std::max({figures.repeatability, 2.0 * s[0] + 2.0 * s[1] + b, 4.0 * s[0], 4.0 * s[1]});
    }
    const auto span = [](const Numbers& upper, const Numbers& lower) {
        return *std::ranges::max_element(upper) - *std::ranges::min_element(lower);
    };
    figures.range = span(means, means);
    figures.systematic = span(both, both);
    figures.accuracy = span(high, low);
    return figures;
}

bool isNear(double found, double expected, double tolerance = 1e-6)
{
    if (std::abs(found - expected) <= tolerance)
        return true;
    qInfo("found %.9g, expected %.9g", found, expected);
    return false;
}

/// The means of both directions as a curve.
TableFitRequest keepingZero()
{
    return {.zero = ZeroRule::Keep, .unit = "mm"};
}

/// A machine with waves, a part with the lead of its screw, and a reversal.
double machineError(double u)
{
    return 12e-6 * u + 0.003 * std::sin(2.0 * pi * u / 430.0 + 0.7)
        + 0.0008 * std::sin(2.0 * pi * u / 10.0 + 0.3);
}

Values machineRuns(unsigned seed, std::size_t targets, double noise)
{
    std::mt19937 random(seed); // NOLINT: the same runs every time
    std::uniform_real_distribution<double> shift(-3.0, 3.0);
    std::normal_distribution<double> error(0.0, 1.0);
    Values values;
    for (std::size_t i = 0; i < targets; ++i) {
        const bool isEnd = i == 0 || i + 1 == targets;
        const double target = 500.0 * static_cast<double>(i) / static_cast<double>(targets - 1)
            + (isEnd ? 0.0 : shift(random));
        for (std::size_t run = 1; run <= 5; ++run)
            for (const bool isUp : {true, false})
                values.push_back({target, isUp, run,
                    machineError(target) + (isUp ? 0.0012 : -0.0012) + noise * error(random)});
    }
    return values;
}

} // namespace

class TestTableFit : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    /// Of these measurements, as computed for the specification of this program.
    void realMeasurementsArePredicted_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QList<double>>("predicted"); // B, M, E, R, A
        QTest::addColumn<QList<double>>("heldOut"); // rms, largest, M
        QTest::addRow("b02 x") << "b02_x"
                               << QList<double>{0.0334657, 0.0, 0.0334657, 0.0549840, 0.0551810}
                               << QList<double>{0.0209982, 0.0410688, 0.0750335};
        QTest::addRow("bifrost") << "bifrost" << QList<double>{NAN, 0.0, NAN, NAN, 0.0083537}
                                 << QList<double>{NAN, NAN, 0.0177945};
        QTest::addRow("b02 y") << "b02_y" << QList<double>{NAN, 0.0, NAN, NAN, NAN}
                               << QList<double>{NAN, NAN, 0.0901514};
    }
    void realMeasurementsArePredicted()
    {
        QFETCH(QString, name);
        QFETCH(QList<double>, predicted);
        QFETCH(QList<double>, heldOut);
        Values values = measurement(qPrintable(name));
        QVERIFY(!values.empty());
        std::ranges::reverse(values); // the order does not matter
        const auto fit = fitTable(values, keepingZero());
        VERIFY_RESULT(fit);
        const auto runs = predictRuns(values, fit->table("mm"), keepingZero());
        VERIFY_RESULT(runs);
        const Figures figures = figuresOf(*runs);
        const Numbers found{figures.reversal, figures.range, figures.systematic,
            figures.repeatability, figures.accuracy};
        for (int i = 0; i < predicted.size(); ++i)
            if (!std::isnan(predicted[i]))
                QVERIFY(isNear(found[static_cast<std::size_t>(i)], predicted[i]));
        const auto without = predictHeldOut(values, keepingZero());
        VERIFY_RESULT(without);
        const Numbers left{without->rms, without->largest, without->range};
        for (int i = 0; i < heldOut.size(); ++i)
            if (!std::isnan(heldOut[i]))
                QVERIFY(isNear(left[static_cast<std::size_t>(i)], heldOut[i]));
    }

    /// What a table is worth whose knots are the targets although it is looked up after the
    /// compensation: 0.86 um are left.
    void aTableAtTheSetPositionHasItsKnotsAtTheReferences()
    {
        const Values values = measurement("b02_x");
        TableFitRequest request = keepingZero();
        const auto atTargets = fitTable(values, request);
        VERIFY_RESULT(atTargets);
        request.lookupAt = LookupAt::Set;
        const auto wrong = predictRuns(values, atTargets->table("mm"), request);
        VERIFY_RESULT(wrong);
        QVERIFY(isNear(figuresOf(*wrong).range, 0.0008596));
        // the knots are uneven: a fine grid holds them nearly
        VERIFY_ERROR(fitTable(values, request), ErrorCode::InvalidArgument);
        request.grid.points = 200'001;
        const auto atReferences = fitTable(values, request);
        VERIFY_RESULT(atReferences);
        const auto right = predictRuns(values, atReferences->table("mm"), request);
        VERIFY_RESULT(right);
        QVERIFY(isNear(figuresOf(*right).range, 0.0));
    }

    /// The axis stands at P + r - constant. Values of an even grid over the targets, computed by
    /// numpy; nothing is left at the targets, of 94 um.
    void theConstantOfTheZeroMovesNoKnotAtTheSetPosition_data()
    {
        QTest::addColumn<int>("zero");
        QTest::addColumn<QList<double>>("expected");
        QTest::newRow("first") << static_cast<int>(ZeroRule::First)
                               << QList<double>{0.0, 0.0492145656, 0.0926195083, 0.0554434661,
                                      -0.0002226554, 0.0124338566, 0.0171534367, 0.0287268263,
                                      0.0635148462};
        QTest::newRow("mean") << static_cast<int>(ZeroRule::Mean)
                              << QList<double>{-0.0352405446, 0.0139740210, 0.0573371946,
                                     0.0195770640, -0.0357234266, -0.0231037153, -0.0183785605,
                                     -0.0067497766, 0.0281725670};
        QTest::newRow("at 7 mm") << static_cast<int>(ZeroRule::Position)
                                 << QList<double>{-0.0142058593, 0.0350087063, 0.0783968115,
                                        0.0409853166, -0.0145334150, -0.0018798973, 0.0028198460,
                                        0.0144130268, 0.0492679766};
    }
    void theConstantOfTheZeroMovesNoKnotAtTheSetPosition()
    {
        QFETCH(const int, zero);
        QFETCH(const QList<double>, expected);
        TableFitRequest request;
        request.zero = static_cast<ZeroRule>(zero);
        request.zeroPosition = 7.0;
        request.lookupAt = LookupAt::Set;
        request.grid = {.points = 9, .start = -20.0, .end = 20.0};
        request.holdsEnds = true;
        for (const double ofInstrument : {0.0, 0.3, 17.3}) {
            Values values = measurement("b02_x");
            for (MeasuredValue& value : values)
                value.deviation += ofInstrument;
            const auto fit = fitTable(values, request);
            VERIFY_RESULT(fit);
            for (int i = 0; i < expected.size(); ++i)
                QVERIFY(isNear(fit->values[static_cast<std::size_t>(i)], expected[i], 1.1e-10));
            const auto runs = predictRuns(values, fit->table("mm"), request);
            VERIFY_RESULT(runs);
            QVERIFY2(
                figuresOf(*runs).range < 1e-7, qPrintable(QString::number(figuresOf(*runs).range)));
            const auto heldOut = predictHeldOut(values, request);
            VERIFY_RESULT(heldOut);
            if (request.zero == ZeroRule::First)
                QVERIFY(isNear(heldOut->range, 0.0751568482, 1.1e-10));
        }
    }

    /// A slope of 0.002 and 0.1 mm more in the middle, on a zero of 0.5 mm: the axis stands at S
    /// with S + 0.002 S = 50 + 0.2 there, and the drive adds S - 50.
    void aSlopeThatIsTakenOutMovesNoKnotAtTheSetPosition()
    {
        Values values;
        for (int i = 0; i <= 10; ++i)
            values.push_back({10.0 * i, true, 1, 0.5 + 0.002 * (10.0 * i) + (i == 5 ? 0.1 : 0.0)});
        TableFitRequest request;
        request.slope = SlopeRemoval::Ends;
        request.lookupAt = LookupAt::Set;
        request.grid = {.points = 11, .start = 0.0, .end = 100.0};
        request.holdsEnds = true;
        const auto fit = fitTable(values, request);
        VERIFY_RESULT(fit);
        QVERIFY(isNear(fit->removed.slope, 0.002, 1e-12));
        QVERIFY(isNear(fit->removed.constant, 0.5, 1e-12));
        QVERIFY(isNear(fit->knots[5].position, 50.2 / 1.002, 1e-12));
        QVERIFY(isNear(fit->knots[6].position, 60.0, 1e-12));
        QVERIFY(isNear(
            fit->curve.at(50.2 / 1.002) - 0.5 - 0.002 * 50.2 / 1.002, 50.2 / 1.002 - 50.0, 1e-12));
    }

    /// Half of the constant is in the table, and all of it was in the readings.
    void theConstantOfAGainMovesNoKnotAtTheSetPosition()
    {
        CompensationTable active;
        active.grid.axes = {{"X", "mm", -20.0, 5.0, 9}};
        active.values.assign(9, 0.0F);
        Values values = measurement("b02_x");
        TableFitRequest request;
        request.lookupAt = LookupAt::Set;
        request.active = {&active};
        request.grid = {.points = 9, .start = -20.0, .end = 20.0};
        request.holdsEnds = true;
        const auto whole = fitTable(values, request);
        VERIFY_RESULT(whole);
        for (MeasuredValue& value : values)
            value.deviation += 0.3;
        request.gain = 0.5;
        const auto half = fitTable(values, request);
        VERIFY_RESULT(half);
        for (std::size_t i = 0; i < 9; ++i) {
            QVERIFY(isNear(half->knots[i].position, whole->knots[i].position, 1e-12));
            QVERIFY(isNear(half->values[i], 0.5 * whole->values[i], 1e-12));
        }
    }

    void denserTablesFollowTheSpline()
    {
        const Values values = measurement("b02_x");
        TableFitRequest request = keepingZero();
        request.method = FitMethod::Spline;
        struct Expected {
            std::size_t points;
            double distance; // um
            double slopeChange; // um/mm
        };
        for (const Expected& expected : {Expected{9, 9.295609, 16.4275},
                 Expected{81, 0.147016, 2.3695}, Expected{641, 0.002381, 0.3050}}) {
            request.grid.points = expected.points;
            const auto fit = fitTable(values, request);
            VERIFY_RESULT(fit);
            QVERIFY(isNear(1e3 * fit->density.largestDistance, expected.distance));
            QVERIFY(isNear(1e3 * fit->density.largestSlopeChange, expected.slopeChange, 5e-5));
        }
        request.grid.points = 0;
        for (const auto& [within, points] :
            {std::pair{1e-3, 32U}, std::pair{1e-4, 100U}, std::pair{1e-5, 313U}}) {
            request.within = within;
            const auto fit = fitTable(values, request);
            VERIFY_RESULT(fit);
            QCOMPARE(fit->grid.size, points);
            QVERIFY(fit->density.largestDistance <= within);
        }
        request.mostPoints = 312;
        VERIFY_ERROR(fitTable(values, request), ErrorCode::ResamplingImpossible);
    }

    void theZeroIsWhereItIsAskedFor()
    {
        const Values values = measurement("b02_x"); // -20 to 20 in steps of 5
        TableFitRequest request;
        const auto keep = fitTable(values, keepingZero());
        VERIFY_RESULT(keep);
        const auto first = fitTable(values, request);
        VERIFY_RESULT(first);
        QCOMPARE(first->values.front(), 0.0);
        QVERIFY(std::abs(first->removed.constant - keep->values.front()) < 1e-15);
        request.zero = ZeroRule::Position;
        request.zeroPosition = 10.0;
        QCOMPARE(fitTable(values, request)->values[6], 0.0);
        request.zero = ZeroRule::Mean;
        const auto mean = fitTable(values, request);
        double sum = 0.0;
        for (const double value : mean->values)
            sum += value;
        QVERIFY(std::abs(sum) < 1e-15);
    }

    void slopesAreTakenOutWhenAsked()
    {
        Values values;
        for (int i = 0; i <= 10; ++i)
            values.push_back({10.0 * i, true, 1, 0.5 + 0.002 * (10.0 * i) + (i == 5 ? 0.1 : 0.0)});
        TableFitRequest request = keepingZero();
        const auto kept = fitTable(values, request);
        QVERIFY(std::abs(kept->values[10] - 0.7) < 1e-15);
        QVERIFY(!kept->remainingReversal);
        request.slope = SlopeRemoval::Ends;
        const auto ends = fitTable(values, request);
        VERIFY_RESULT(ends);
        QVERIFY(std::abs(ends->removed.slope - 0.002) < 1e-15);
        QVERIFY(std::abs(ends->values[10] - 0.5) < 1e-12);
        QVERIFY(std::abs(ends->values[5] - 0.6) < 1e-12);
        request.slope = SlopeRemoval::LeastSquares; // the bump in the middle has no slope
        const auto least = fitTable(values, request);
        QVERIFY(std::abs(least->removed.slope - 0.002) < 1e-15);
        request.turn = 360.0;
        VERIFY_ERROR(fitTable(values, request), ErrorCode::InvalidArgument);
    }

    void aDirectionIsTakenAlone()
    {
        Values values = machineRuns(1, 11, 0.0);
        TableFitRequest request = keepingZero();
        request.grid.points = 101;
        const auto mean = fitTable(values, request);
        VERIFY_RESULT(mean);
        request.direction = FitDirection::Positive;
        const auto up = fitTable(values, request);
        VERIFY_RESULT(up);
        for (std::size_t i = 0; i < up->values.size(); ++i)
            QVERIFY(std::abs(up->values[i] - mean->values[i] - 0.0012) < 1e-12);
        QVERIFY(std::abs(*mean->remainingReversal - 0.0012) < 1e-12);
        QVERIFY(!mean->isMostlyReversal); // E is some 11 um
        std::erase_if(values, [](const MeasuredValue& v) { return !v.isUp && v.target == 500.0; });
        VERIFY_RESULT(fitTable(values, request));
        request.direction = FitDirection::Mean;
        const auto refused = fitTable(values, request);
        VERIFY_ERROR(refused, ErrorCode::InvalidArgument);
        QVERIFY2(sentence(refused.error()).find("target 500 mm has no value of one direction")
                != std::string::npos,
            sentence(refused.error()).c_str());
    }

    /// Between the targets a linear table does not know the part with the screw's lead, and says
    /// so; a spline with the period does know it.
    void aKnownPeriodIsForetoldBetweenTheTargets()
    {
        const Values values = machineRuns(4, 51, 0.0001);
        TableFitRequest linear = keepingZero();
        linear.grid.distance = 10.0;
        TableFitRequest smooth = keepingZero();
        smooth.method = FitMethod::Smooth;
        smooth.periods = {{10.0}};
        const auto linearOut = predictHeldOut(values, linear);
        const auto smoothOut = predictHeldOut(values, smooth);
        VERIFY_RESULT(linearOut);
        VERIFY_RESULT(smoothOut);
        QVERIFY2(linearOut->range > 0.002, qPrintable(QString::number(linearOut->range)));
        QVERIFY2(smoothOut->range < 0.0005, qPrintable(QString::number(smoothOut->range)));
        const auto fit = fitTable(values, smooth);
        VERIFY_RESULT(fit);
        QCOMPARE(fit->grid.size, std::size_t{1001}); // p / 20 apart
        const CompensationTable table = fit->table("mm");
        const Lookup lookup(table);
        for (double u = 0.0; u <= 500.0; u += 0.37)
            QVERIFY(std::abs(lookup.at(u) - machineError(u)) < 0.00025);
    }

    /// With a table active the residuals are merged onto it; from a table of the wrong sign too.
    void residualsAreMergedOntoWhatWasActive()
    {
        for (const LookupAt lookupAt : {LookupAt::Encoder, LookupAt::Set}) {
            CompensationTable active;
            active.grid.axes = {{"X", "mm", 0.0, 5.0, 101}};
            for (std::size_t i = 0; i <= 100; ++i)
                active.values.push_back(
                    static_cast<float>(-machineError(5.0 * static_cast<double>(i))));
            TableFitRequest request = keepingZero();
            request.lookupAt = lookupAt;
            request.active = {&active};
            request.grid.points = 501;
            Values values;
            const auto frame = LookupFrame::make(lookupAt, {{&active}}, {&active});
            VERIFY_RESULT(frame);
            for (int i = 0; i <= 250; ++i) {
                const double target = 2.0 * i;
                const double raw = frame->rawPosition({&target, 1})->at(0);
                values.push_back({target, true, 1, raw + machineError(raw) - target});
            }
            request.grid.start = 1.0;
            request.grid.end = 499.0;
            const auto fit = fitTable(values, request);
            VERIFY_RESULT(fit);
            for (const FitKnot& knot : fit->knots) {
                const double raw =
                    lookupAt == LookupAt::Encoder ? knot.position : knot.position - knot.value;
                QVERIFY(std::abs(knot.value - machineError(raw)) < 1e-12);
            }
            const auto runs = predictRuns(values, fit->table("mm"), request);
            VERIFY_RESULT(runs);
            for (const MeasuredValue& value : *runs)
                if (value.target > 2.0 && value.target < 498.0) // a chord of 2 mm: 0.16 um
                    QVERIFY2(std::abs(value.deviation) < 0.00016,
                        qPrintable(QString::number(value.deviation)));
            request.gain = 0.5;
            const auto half = fitTable(values, request);
            VERIFY_RESULT(half);
            for (std::size_t i = 0; i < half->knots.size(); ++i) {
                QCOMPARE(half->knots[i].position, fit->knots[i].position);
                const double deviation = values[i].deviation;
                QVERIFY(
                    std::abs(half->knots[i].value - fit->knots[i].value + 0.5 * deviation) < 1e-12);
            }
        }
    }

    /// Half of r = a x^2 is left with gain 0.5, and straight lines over the gap take a h^2 / 2 more
    /// than that.
    void aGainLeavesItsShareHeldOutToo()
    {
        constexpr double a = 1e-6;
        CompensationTable active;
        active.grid.axes = {{"X", "mm", 0.0, 10.0, 11}};
        active.values.assign(11, 0.0F);
        Values values;
        for (int i = 0; i <= 10; ++i)
            values.push_back({10.0 * i, true, 1, a * 100.0 * i * i});
        TableFitRequest request = keepingZero();
        request.active = {&active};
        request.gain = 0.5;
        const auto heldOut = predictHeldOut(values, request);
        VERIFY_RESULT(heldOut);
        QVERIFY(isNear(heldOut->residuals.back().value, 0.5 * a * (8100.0 - 100.0), 1e-12));
        QVERIFY(isNear(heldOut->range, 0.5 * a * 1e4, 1e-12)); // at the last target
        QVERIFY(isNear(heldOut->largest, 0.5 * a * 1e4, 1e-12));
        QVERIFY(isNear(heldOut->unknownRange, 0.0, 1e-12));
    }

    void whatCannotBeFittedIsRefused()
    {
        const Values values = measurement("b02_x");
        TableFitRequest request = keepingZero();
        VERIFY_ERROR(fitTable({}, request), ErrorCode::InvalidArgument);
        VERIFY_ERROR(fitTable(std::span(values).first(1), request), ErrorCode::InvalidArgument);
        request.method = FitMethod::Harmonic;
        VERIFY_ERROR(fitTable(values, request), ErrorCode::InvalidArgument); // no turn
        request.method = FitMethod::Smooth;
        request.periods = {{5.0}}; // the targets are 5 apart
        VERIFY_ERROR(fitTable(values, request), ErrorCode::PeriodNotResolved);
        request.method = FitMethod::Spline;
        VERIFY_ERROR(fitTable(values, request), ErrorCode::InvalidArgument); // not with periods
        Values three;
        for (int i = 0; i < 3; ++i)
            three.push_back({1.0 * i, true, 1, 0.0});
        VERIFY_ERROR(predictHeldOut(three, keepingZero()), ErrorCode::InvalidArgument);
        Values bad = values;
        bad[3].deviation = NAN;
        VERIFY_ERROR(fitTable(bad, keepingZero()), ErrorCode::InvalidArgument);
    }
};

AXISCOMP_TEST(TestTableFit)

} // namespace tst_tablefit

#include "tst_tablefit.moc"
