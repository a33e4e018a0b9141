// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/judge/deviation_curves.h"
#include "core/metrology/run_selection.h"
#include "tests/core/metrology/measurement_reading.h"
#include "tests/support/test_registry.h"

#include <algorithm>
#include <cmath>

namespace tst_deviationcurves {

using namespace axiscomp;

namespace {

constexpr double tolerance = 1e-6; // mm

bool isNear(double a, double b)
{
    return std::abs(a - b) < tolerance;
}

Measurement measurementOf(const char* file)
{
    return test::readAs("runs", test::publicMeasurement(file)).measurement.value_or(Measurement{});
}

DeviationCurves curvesOf(const Measurement& measurement)
{
    return deviationCurves(measurement, iso230Figures(measurement));
}

double size(const std::optional<DeviationRange>& range)
{
    return range ? range->high - range->low : std::nan("");
}

/// One run up and one down over many targets, with one high value.
Measurement longMeasurement(std::size_t targets, std::size_t peak)
{
    Measurement measurement;
    for (const Approach direction : {Approach::Up, Approach::Down})
        for (std::size_t i = 0; i < targets; ++i) {
            if (direction == Approach::Up)
                measurement.targets.push_back(static_cast<double>(i));
            RunValue value;
            value.target = i;
            value.direction = direction;
            value.deviation = i == peak ? 0.5 : 0.001 * std::sin(static_cast<double>(i));
            measurement.values.push_back(value);
        }
    return measurement;
}

} // namespace

/// What the plot of ISO 230-2 shows, against the published figures of a public measurement.
class TestDeviationCurves : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theMarkedRangesAreAsLargeAsTheFigures()
    {
        const DeviationCurves curves = curvesOf(measurementOf("bifrost.csv"));
        QVERIFY(isNear(size(curves.accuracy), 0.0185713));
        QVERIFY(isNear(size(curves.systematic), 0.0159880));
        QVERIFY(isNear(size(curves.meanRange), 0.0149520));
        QVERIFY(curves.reversal.has_value());
        QVERIFY(isNear(std::abs(curves.reversal->up - curves.reversal->down), 0.0045640));
        QCOMPARE(curves.reversal->position, 25.2);
    }

    void curvesGoThroughTheMeansOfTheTargets()
    {
        const DeviationCurves curves = curvesOf(measurementOf("bifrost.csv"));
        const std::array expected{0.003226, -0.001888, 0.000615, -0.008452, 0.006500};
        QCOMPARE(curves.mean.size(), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i)
            QVERIFY(isNear(curves.mean[i].deviation, expected[i]));
        QCOMPARE(curves.runs.size(), std::size_t{10});
        QCOMPARE(curves.valueCount, std::size_t{50});
        QVERIFY(isNear(curves.runs.front().values[3].deviation, -0.00849));
        QVERIFY(isNear(curves.up.smallest[3].deviation, -0.01053));
        QVERIFY(isNear(curves.up.largest[3].deviation, -0.00788));
    }

    void whatIsExcludedStandsApart()
    {
        Measurement measurement = measurementOf("ess_mcu1025.csv");
        const Exclusion first{Approach::Down, 1, 1};
        QVERIFY(exclude(measurement, {&first, 1}));
        const DeviationCurves curves = curvesOf(measurement);
        QCOMPARE(curves.excluded.size(), std::size_t{1});
        QVERIFY(isNear(curves.excluded.front().deviation, 0.0931843));
        QCOMPARE(curves.valueCount, std::size_t{49});
        // The scale is that of the values in use.
        QVERIFY(curves.all->high < 0.0931843);
    }

    /// A laser that was set to zero 12.5 mm away shows the same curves.
    void theZeroOfTheInstrumentMovesNoCurve()
    {
        const auto shown = [](double zero) {
            Measurement measurement = measurementOf("bifrost.csv");
            for (RunValue& value : measurement.values)
                value.deviation += zero;
            measurement.values[7].isUsed = false;
            const Iso230Figures figures = iso230Figures(measurement);
            return deviationCurves(measurement, figures, deviationDatum(figures));
        };
        const DeviationCurves here = shown(0.0);
        const DeviationCurves away = shown(12.5);
        QCOMPARE(away.mean.front().deviation, 0.0);
        QVERIFY(isNear(here.mean[3].deviation, -0.008452 - 0.003226));
        const auto areSame = [](const std::vector<PlacedDeviation>& a,
                                 const std::vector<PlacedDeviation>& b) {
            return !a.empty() && a.size() == b.size()
                && std::ranges::equal(a, b, [](const auto& one, const auto& other) {
                       return one.position == other.position
                           && std::abs(one.deviation - other.deviation) < 1e-12;
                   });
        };
        QVERIFY(areSame(here.mean, away.mean));
        QVERIFY(areSame(here.up.mean, away.up.mean) && areSame(here.down.low, away.down.low));
        QVERIFY(areSame(here.up.high, away.up.high));
        QVERIFY(areSame(here.runs[3].values, away.runs[3].values));
        QVERIFY(areSame(here.up.largest, away.up.largest));
        QVERIFY(areSame(here.excluded, away.excluded));
        const auto isSameRange = [](const auto& a, const auto& b) {
            return isNear(a->low, b->low) && isNear(a->high, b->high);
        };
        QVERIFY(isSameRange(here.all, away.all) && isSameRange(here.accuracy, away.accuracy));
        QVERIFY(isSameRange(here.meanRange, away.meanRange));
        QVERIFY(isNear(here.reversal->up, away.reversal->up));
    }

    void theDatumIsAPositionWithinTheTargets()
    {
        const Iso230Figures figures = iso230Figures(measurementOf("bifrost.csv"));
        const auto at = [&](std::optional<double> position) {
            return deviationDatum(figures, position).value_or(PlacedDeviation{});
        };
        QCOMPARE(at({}).position, 15.0);
        QVERIFY(isNear(at({}).deviation, 0.003226));
        QCOMPARE(at(45.6).position, 45.6);
        QVERIFY(isNear(at(45.6).deviation, -0.008452));
        QCOMPARE(at(20.1).position, 20.1); // half way between two targets
        QVERIFY(isNear(at(20.1).deviation, (0.003226 - 0.001888) / 2.0));
        QCOMPARE(at(-1000.0), at({}));
        QCOMPARE(at(1000.0).position, 55.8);
        QVERIFY(!deviationDatum({}));
        QCOMPARE(datumText(at(20.1), false).english(), std::string("0 = mean at 20.1 mm"));
        QCOMPARE(datumText(at({}), true).english(), std::string("0 = mean at 15 °"));
        QCOMPARE(datumText(at({}), true, UnitLetters::Ascii).english(),
            std::string("0 = mean at 15 deg"));
    }

    void ofOneDirectionTheDatumIsItsMean()
    {
        Measurement measurement = measurementOf("bifrost.csv");
        std::erase_if(measurement.values,
            [](const RunValue& value) { return value.direction == Approach::Up; });
        const auto datum = deviationDatum(iso230Figures(measurement));
        QVERIFY(datum && isNear(datum->deviation, 0.004202));
    }

    void twoMeasurementsAreShownFromOnePosition()
    {
        const Measurement before = measurementOf("bifrost.csv");
        Measurement after = before;
        const auto datums = [&](double by, std::optional<double> first = {},
                                std::optional<double> second = {}) {
            for (std::size_t i = 0; i < after.targets.size(); ++i)
                after.targets[i] = before.targets[i] + by;
            return deviationDatums({iso230Figures(before), first}, {iso230Figures(after), second});
        };
        QCOMPARE(datums(-5.1).before->position, 15.0);
        QCOMPARE(datums(-5.1).after->position, 15.0);
        QVERIFY(isNear(datums(-5.1).after->deviation, (0.003226 - 0.001888) / 2.0));
        QCOMPARE(datums(5.0).after->position, 20.0); // the nearest that it has
        QCOMPARE(datums(0.0, 45.6).after, datums(0.0, 45.6).before);
        QCOMPARE(datums(0.0, {}, 45.6).before, datums(0.0, 45.6).before);
        QCOMPARE(datums(0.0, 45.6, 20.0).after->position, 45.6); // that of the first one
        const TwoDatums alone = deviationDatums({Iso230Figures()}, {iso230Figures(before)});
        QVERIFY(!alone.before && alone.after->position == 15.0);
    }

    void aFigureThatIsNotDefinedHasNoMark()
    {
        Measurement measurement = measurementOf("bifrost.csv");
        std::erase_if(measurement.values,
            [](const RunValue& value) { return value.direction == Approach::Down; });
        const DeviationCurves curves = curvesOf(measurement);
        QVERIFY(!curves.accuracy && !curves.systematic && !curves.meanRange && !curves.reversal);
        QVERIFY(curves.mean.empty() && curves.down.mean.empty());
        QCOMPARE(curves.up.mean.size(), std::size_t{5});
        QVERIFY(!deviationCurves(Measurement{}, {}).all);
    }

    void thinnedCurvesKeepWhatSticksOut()
    {
        constexpr std::size_t most = 100;
        const Measurement measurement = longMeasurement(10'000, 4321);
        const DeviationCurves curves = thinned(curvesOf(measurement), most);
        QVERIFY(curves.up.mean.size() <= most && curves.mean.size() <= most);
        QVERIFY(curves.runs.empty());
        const auto highest =
            std::ranges::max_element(curves.up.mean, {}, &PlacedDeviation::deviation);
        QCOMPARE(*highest, (PlacedDeviation{4321.0, 0.5}));
        QVERIFY(std::ranges::is_sorted(curves.up.mean, {}, &PlacedDeviation::position));
        // What is short stays as it is.
        const DeviationCurves few = curvesOf(measurementOf("bifrost.csv"));
        const DeviationCurves same = thinned(few, most);
        QCOMPARE(same.mean, few.mean);
        QCOMPARE(same.runs.size(), few.runs.size());
    }

    void valuesAreFoundByDirectionTargetAndRun()
    {
        const Measurement measurement = measurementOf("ess_mcu1025.csv");
        const RunValue* value = findValue(measurement, Approach::Down, 0, 1);
        QVERIFY(value && isNear(value->deviation, 0.0931843));
        QVERIFY(!findValue(measurement, Approach::Down, 0, 6));
        QVERIFY(!findValue(measurement, Approach::Up, 5, 1));
        QCOMPARE(valuesAt(measurement, Approach::Up, 4).size(), std::size_t{5});
    }
};

AXISCOMP_TEST(TestDeviationCurves)

} // namespace tst_deviationcurves

#include "tst_deviationcurves.moc"
