// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curve/harmonic_curve.h"
#include "core/curve/smoothing_spline.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace tst_smoothingspline {

using namespace axiscomp;
using Numbers = std::vector<double>;

namespace {

constexpr double pi = std::numbers::pi;
const QString referenceFolder = QStringLiteral(AXISCOMP_SOURCE_FOLDER "/tests/data/curve/");

Numbers numbers(const QJsonValue& value)
{
    Numbers all;
    for (const QJsonValue& number : value.toArray())
        all.push_back(number.toDouble());
    return all;
}

/// What scipy and dense matrices make of a curve; tests/data/curve/spline_reference.py.
struct Reference {
    QJsonObject input;
    QJsonObject result;

    [[nodiscard]] Numbers given(const char* name) const
    {
        return numbers(input[QLatin1String(name)]);
    }
    [[nodiscard]] Numbers expected(const char* name) const
    {
        return numbers(result[QLatin1String(name)]);
    }
    [[nodiscard]] double number(const char* name) const
    {
        return result[QLatin1String(name)].toDouble();
    }
    [[nodiscard]] std::optional<double> wrap() const
    {
        const QJsonValue value = input[QLatin1String("wrap")];
        return value.isNull() ? std::nullopt : std::optional(value.toDouble());
    }
    [[nodiscard]] SmoothingRequest request() const
    {
        SmoothingRequest request{.wrap = wrap()};
        request.periods = {given("periods"), input[QLatin1String("harmonics")].toInt()};
        if (const QJsonValue value = input[QLatin1String("smoothness")]; !value.isNull())
            request.smoothness = value.toDouble();
        return request;
    }
};

void addReferenceRows(const char* kind)
{
    QFile file(referenceFolder + QStringLiteral("spline_reference.json"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QJsonObject all = QJsonDocument::fromJson(file.readAll()).object();
    const QJsonArray inputs = all[QLatin1String("inputs")].toArray();
    const QJsonArray results = all[QLatin1String("results")].toArray();
    QCOMPARE(inputs.size(), results.size());
    QTest::addColumn<QJsonObject>("input");
    QTest::addColumn<QJsonObject>("result");
    for (int i = 0; i < inputs.size(); ++i) {
        const QJsonObject input = inputs[i].toObject();
        if (input[QLatin1String("kind")].toString() == QLatin1String(kind))
            QTest::addRow("%s", qPrintable(input[QLatin1String("name")].toString()))
                << input << results[i].toObject();
    }
}

double largestDifference(const Numbers& a, const Numbers& b)
{
    double largest = a.size() == b.size() ? 0.0 : INFINITY;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

Numbers valuesAt(const FittedCurve& curve, const Numbers& places)
{
    Numbers values;
    for (const double place : places)
        values.push_back(curve.at(place));
    return values;
}

template <typename Function> Numbers madeOf(const Numbers& places, Function function)
{
    Numbers values;
    for (const double place : places)
        values.push_back(function(place));
    return values;
}

Numbers even(double from, double to, std::size_t count)
{
    Numbers places;
    for (std::size_t i = 0; i < count; ++i)
        places.push_back(
            from + (to - from) * static_cast<double>(i) / static_cast<double>(count - 1));
    return places;
}

#define VERIFY_BELOW(difference, limit)                                                            \
    QVERIFY2((difference) <= (limit), qPrintable(QString::number(difference)))

} // namespace

class TestSmoothingSpline : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theStoredReferencesAreWhatScipyMakes()
    {
        QProcess python;
        python.start(QStringLiteral("/usr/bin/python3"),
            {referenceFolder + QStringLiteral("spline_reference.py"), QStringLiteral("check"),
                referenceFolder + QStringLiteral("spline_reference.json")});
        QVERIFY(python.waitForFinished(120000));
        if (python.exitCode() == 77)
            QSKIP("python3-scipy is not installed");
        QVERIFY2(python.exitCode() == 0, python.readAllStandardError().constData());
    }

    void curvesThroughValuesAreThoseOfScipy_data() { addReferenceRows("through"); }
    void curvesThroughValuesAreThoseOfScipy()
    {
        QFETCH(QJsonObject, input);
        QFETCH(QJsonObject, result);
        const Reference reference{input, result};
        const Numbers x = reference.given("x");
        const Numbers y = reference.given("y");
        const Numbers places = reference.given("at");
        const auto spline = interpolatingSpline({x, y}, reference.wrap());
        VERIFY_RESULT(spline);
        VERIFY_BELOW(
            largestDifference(valuesAt(*spline, places), reference.expected("spline")), 1e-9);
        if (reference.wrap())
            return;
        const auto monotone = monotoneCubic({x, y});
        VERIFY_RESULT(monotone);
        VERIFY_BELOW(
            largestDifference(valuesAt(*monotone, places), reference.expected("monotone")), 1e-9);
    }

    void smoothedCurvesAreThoseOfScipyAndOfDenseMatrices_data() { addReferenceRows("smooth"); }
    void smoothedCurvesAreThoseOfScipyAndOfDenseMatrices()
    {
        QFETCH(QJsonObject, input);
        QFETCH(QJsonObject, result);
        const Reference reference{input, result};
        const Numbers x = reference.given("x");
        const Numbers y = reference.given("y");
        const Numbers w = reference.given("w");
        const SmoothingRequest request = reference.request();
        if (!request.smoothness) {
            const auto automatic = smoothingSpline({x, y, w}, request);
            VERIFY_RESULT(automatic);
            const double ratio = automatic->smoothness / reference.number("bestSmoothness");
            QVERIFY2(std::abs(std::log10(ratio)) < 0.02, qPrintable(QString::number(ratio)));
        }
        SmoothingRequest given = request;
        given.smoothness = reference.number("bestSmoothness");
        const auto smoothed = smoothingSpline({x, y, w}, given);
        VERIFY_RESULT(smoothed);
        VERIFY_BELOW(std::abs(smoothed->penalty / reference.number("penalty") - 1.0), 1e-9);
        VERIFY_BELOW(
            largestDifference(valuesAt(smoothed->curve, x), reference.expected("fitted")), 1e-9);
        VERIFY_BELOW(std::abs(smoothed->parameters - reference.number("trace")), 1e-8);
        if (result[QLatin1String("score")].isNull()) // as many parameters as values
            QCOMPARE(smoothed->crossValidation, INFINITY);
        else
            VERIFY_BELOW(std::abs(smoothed->crossValidation - reference.number("score")), 1e-9);
        const Numbers scipy = reference.expected("scipy");
        if (!scipy.empty()) {
            const Numbers places = reference.given("at");
            VERIFY_BELOW(largestDifference(valuesAt(smoothed->curve, places), scipy), 1e-9);
        }
        Numbers terms;
        for (const PeriodicTerm& term : smoothed->curve.terms)
            terms.insert(terms.end(), {term.cosine, term.sine});
        VERIFY_BELOW(largestDifference(terms, reference.expected("terms")), 1e-9);
    }

    /// 360 degrees that were read as a little less are 0 degrees, not a place beside it.
    void theEndOfATurnIsItsBeginning()
    {
        const Numbers x{0.0, 90.0, 180.0, 270.0, 360.0 - 1e-8};
        const Numbers y{0.0, 1.0, 0.0, -1.0, 2.0};
        const auto curve = interpolatingSpline({x, y}, 360.0);
        VERIFY_RESULT(curve);
        VERIFY_BELOW(std::abs(curve->at(0.0) - 1.0), 1e-12);
        VERIFY_BELOW(std::abs(curve->at(360.0) - 1.0), 1e-12);
    }

    void theOrderOfTheSamplesAndTheUnitsDoNotMatter()
    {
        Numbers x = even(-3.0, 7.0, 60);
        Numbers y = madeOf(x, [](double p) { return std::sin(p) + 0.1 * std::sin(91.0 * p); });
        x.push_back(x[5]); // a place with two values
        y.push_back(y[5] + 0.3);
        const auto first = smoothingSpline({x, y});
        VERIFY_RESULT(first);
        std::ranges::reverse(x);
        std::ranges::reverse(y);
        const auto again = smoothingSpline({x, y});
        VERIFY_RESULT(again);
        QCOMPARE(again->curve.base.values, first->curve.base.values);
        for (double& position : x)
            position *= 1024.0;
        for (double& value : y)
            value *= 0.25;
        const auto scaled = smoothingSpline({x, y});
        VERIFY_RESULT(scaled);
        VERIFY_BELOW(std::abs(scaled->smoothness / first->smoothness - 1.0), 1e-9);
        VERIFY_BELOW(std::abs(scaled->curve.at(0.7 * 1024.0) - 0.25 * first->curve.at(0.7)), 1e-12);
    }

    void aStraightLineIsAddedExactly()
    {
        const Numbers x = even(0.0, 100.0, 40);
        const Numbers y = madeOf(x, [](double p) { return std::sin(p); });
        const Numbers tilted = madeOf(x, [](double p) { return std::sin(p) + 3.0 - 0.2 * p; });
        const SmoothingRequest request{.smoothness = 7.0};
        const auto plain = smoothingSpline({x, y}, request);
        const auto sum = smoothingSpline({x, tilted}, request);
        VERIFY_RESULT(plain);
        VERIFY_RESULT(sum);
        for (const double place : even(0.0, 100.0, 333))
            VERIFY_BELOW(
                std::abs(sum->curve.at(place) - plain->curve.at(place) - 3.0 + 0.2 * place), 1e-11);
    }

    /// Of 200 curves with noise 90 % came within 1.13 of the best possible rms to the truth, when
    /// the method was chosen.
    void theAutomaticCurveIsNearTheBestOne()
    {
        std::mt19937 random(11); // NOLINT: the same curves every time
        std::normal_distribution<double> noise(0.0, 0.5);
        std::uniform_real_distribution<double> phase(0.0, 2.0 * pi);
        const Numbers x = even(0.0, 500.0, 81);
        int near = 0;
        constexpr int curves = 40;
        for (int curve = 0; curve < curves; ++curve) {
            const double a = phase(random);
            const double b = phase(random);
            const auto truth = [a, b](double p) {
                return 3.0 * std::sin(2.0 * pi * p / 430.0 + a)
                    + 1.2 * std::sin(2.0 * pi * p / 97.0 + b);
            };
            const Numbers y = madeOf(x, [&](double p) { return truth(p) + noise(random); });
            const auto rmsOf = [&](const SmoothingRequest& request) {
                const auto fit = smoothingSpline({x, y}, request);
                double sum = 0.0;
                for (const double p : x)
                    sum += std::pow(fit->curve.at(p) - truth(p), 2);
                return std::sqrt(sum / static_cast<double>(x.size()));
            };
            double best = INFINITY;
            for (double decade = -2.0; decade <= 8.0; decade += 0.25)
                best = std::min(best, rmsOf({.smoothness = std::pow(10.0, decade)}));
            near += rmsOf({}) <= 1.13 * best ? 1 : 0;
        }
        QVERIFY2(near >= 34, qPrintable(QString::number(near)));
    }

    void aKnownPeriodIsFoundBesideASmoothError()
    {
        std::mt19937 random(3); // NOLINT: the same curve every time
        std::normal_distribution<double> noise(0.0, 0.1);
        std::uniform_real_distribution<double> shift(-3.0, 3.0);
        Numbers x = even(0.0, 500.0, 51);
        for (double& position : x)
            position += shift(random);
        const Numbers y = madeOf(x, [&](double p) {
            return 3.0 * std::sin(p / 80.0) + 0.8 * std::sin(2.0 * pi * p / 10.0 + 0.3)
                + noise(random);
        });
        const auto fit = smoothingSpline({x, y}, {.periods = {{10.0}}});
        VERIFY_RESULT(fit);
        const PeriodicTerm& term = fit->curve.terms.at(0);
        VERIFY_BELOW(std::abs(term.amplitude() - 0.8), 3.0 * term.standardError);
        VERIFY_BELOW(std::abs(term.phase() - 0.3), 0.1);
        // that of a mean of 51 values: 0.1 sqrt(2 / 51)
        QVERIFY2(term.standardError > 0.015 && term.standardError < 0.03,
            qPrintable(QString::number(term.standardError)));
    }

    void aPeriodThatThePositionsDoNotTellIsRefused()
    {
        const Numbers x = even(0.0, 500.0, 51); // every 10
        const Numbers y(x.size(), 0.0);
        const auto fit =
            smoothingSpline({.positions = x, .values = y, .unit = "mm"}, {.periods = {{10.0}}});
        VERIFY_ERROR(fit, ErrorCode::PeriodNotResolved);
        QVERIFY(sentence(fit.error()).find("the period 10 mm") != std::string::npos);
        VERIFY_RESULT(smoothingSpline({x, y}, {.periods = {{10.7}}}));
        // four and five phases: with three harmonics seven are needed
        VERIFY_ERROR(smoothingSpline({x, y}, {.periods = {{40.0}}}), ErrorCode::PeriodNotResolved);
        VERIFY_RESULT(smoothingSpline({x, y}, {.periods = {{50.0}}}));
        VERIFY_ERROR(
            smoothingSpline({x, y}, {.periods = {{50.0}, 3}}), ErrorCode::PeriodNotResolved);
    }

    void termsOfOneTurnAreFoundExactly()
    {
        const Numbers x{3.0, 40.0, 77.0, 130.0, 201.0, 260.0, 300.0, 363.0};
        const auto truth = [](double p) {
            const double angle = p * pi / 180.0;
            return 2.0 + 0.7 * std::cos(angle) - 0.2 * std::sin(angle) + 0.05 * std::sin(2 * angle);
        };
        const Numbers y = madeOf(x, truth);
        const auto fit = fitHarmonics({x, y}, 360.0, 2); // 3 and 363 are one place
        VERIFY_RESULT(fit);
        for (const double place : even(-500.0, 500.0, 97))
            VERIFY_BELOW(std::abs(fit->curve.at(place) - truth(place)), 1e-12);
        VERIFY_BELOW(fit->residualLargest, 1e-12);
        VERIFY_ERROR(fitHarmonics({x, y}, 360.0, 3), ErrorCode::InvalidArgument);
        const Numbers half = even(0.0, 120.0, 8);
        VERIFY_ERROR(fitHarmonics({half, Numbers(8, 1.0)}, 360.0, 2), ErrorCode::PeriodNotResolved);
    }

    void beyondTheKnotsTheEndsAreHeld()
    {
        const Numbers x{0.0, 1.0, 3.0};
        const Numbers y{2.0, -1.0, 5.0};
        const auto spline = interpolatingSpline({x, y});
        VERIFY_RESULT(spline);
        QCOMPARE(spline->at(-7.0), 2.0);
        QCOMPARE(spline->at(7.0), 5.0);
        const auto ring = interpolatingSpline({x, y}, 4.0);
        VERIFY_RESULT(ring);
        QCOMPARE(ring->at(4.0), 2.0);
        QCOMPARE(ring->at(-3.0), -1.0);
    }

    void whatMakesNoSenseIsRefused()
    {
        const Numbers x = even(0.0, 1.0, 7);
        const Numbers y(7, 1.0);
        const Numbers bad{0.0, 1.0, 2.0, 3.0, 4.0, 5.0, NAN};
        const Numbers weights{1.0, 1.0, 1.0, 0.0, 1.0, 1.0, 1.0};
        VERIFY_ERROR(smoothingSpline({x, y}), ErrorCode::InvalidArgument); // 7 positions
        VERIFY_RESULT(interpolatingSpline({x, y}));
        VERIFY_ERROR(interpolatingSpline({bad, y}), ErrorCode::InvalidArgument);
        VERIFY_ERROR(interpolatingSpline({x, bad}), ErrorCode::InvalidArgument);
        VERIFY_ERROR(interpolatingSpline({x, y, weights}), ErrorCode::InvalidArgument);
        VERIFY_ERROR(interpolatingSpline({x, Numbers(6, 1.0)}), ErrorCode::InvalidArgument);
        VERIFY_ERROR(interpolatingSpline({Numbers(7, 2.0), y}), ErrorCode::InvalidArgument);
        VERIFY_ERROR(interpolatingSpline({x, y}, 0.0), ErrorCode::InvalidArgument);
        const Numbers many = even(0.0, 9.9, 40);
        const Numbers ones(40, 1.0);
        VERIFY_ERROR(
            smoothingSpline({many, ones}, {.smoothness = 0.0}), ErrorCode::InvalidArgument);
        VERIFY_ERROR(
            smoothingSpline({many, ones}, {.periods = {{-1.0}}}), ErrorCode::InvalidArgument);
        VERIFY_ERROR(smoothingSpline({many, ones}, {.periods = {{4.0, 2.0}, 2}}),
            ErrorCode::InvalidArgument); // 2 is a harmonic of 4
        VERIFY_ERROR(smoothingSpline({many, ones}, {.wrap = 10.0, .periods = {{3.0}}}),
            ErrorCode::InvalidArgument);
    }
};

AXISCOMP_TEST(TestSmoothingSpline)

} // namespace tst_smoothingspline

#include "tst_smoothingspline.moc"
