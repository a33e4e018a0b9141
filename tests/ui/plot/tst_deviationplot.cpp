// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/formats/measurement_format.h"
#include "tests/support/file_content.h"
#include "tests/ui/support/heartbeat.h"
#include "tests/ui/support/measurement_files.h"
#include "tests/ui/support/window_test.h"
#include "ui/plot/deviation_plot.h"

#include <QLabel>
#include <QSignalSpy>
#include <QTest>

#include "ui/drawing/custom_plot.h"

#include <cmath>

namespace tst_deviationplot {

using namespace axiscomp;
using namespace axiscomp::ui;

namespace {

Measurement measurementOf(const char* name)
{
    const auto format = measurementFormatNamed("runs");
    const auto reading =
        (*format)->read(test::contentOf(test::publicMeasurement(name).toStdString()), {});
    return reading.measurement.value_or(Measurement{});
}

DeviationSeries seriesOf(
    Measurement measurement, const QString& name = {}, OutlierRule rule = OutlierRule::None)
{
    const auto shared = std::make_shared<const Measurement>(std::move(measurement));
    DeviationSeries series =
        deviationSeries(shared, std::make_shared<const Iso230Figures>(iso230Figures(*shared)),
            std::make_shared<const Outliers>(findOutliers(*shared, rule)));
    series.name = name;
    return series;
}

/// Two runs each way over many targets.
Measurement longMeasurement(std::size_t targets)
{
    Measurement measurement;
    for (std::size_t i = 0; i < targets; ++i)
        measurement.targets.push_back(static_cast<double>(i));
    for (const Approach direction : {Approach::Up, Approach::Down})
        for (std::size_t i = 0; i < targets; ++i)
            for (const int run : {1, 2}) {
                RunValue value;
                value.target = i;
                value.direction = direction;
                value.run = run;
                value.deviation = 0.005 * std::sin(static_cast<double>(i) / 500.0) + 1e-4 * run;
                measurement.values.push_back(value);
            }
    return measurement;
}

/// The plot in a window of its own, with the keyboard.
struct Fixture {
    explicit Fixture(std::vector<DeviationSeries> series)
        : selections(&view, &DeviationPlot::selectionChanged)
    {
        view.resize(800, 400);
        view.setSeries(std::move(series));
        view.show();
        view.activateWindow();
        plot = view.findChild<QCustomPlot*>(QStringLiteral("deviationPicture"));
        plot->setFocus();
        static_cast<void>(QTest::qWaitFor([this] { return plot->hasFocus(); }));
        plot->replot(QCustomPlot::rpImmediateRefresh);
    }
    [[nodiscard]] QString readout() const
    {
        return view.findChild<QLabel*>(QStringLiteral("deviationReadout"))->text();
    }
    [[nodiscard]] QPoint pixel(double position, double deviation) const
    {
        return QPointF(plot->xAxis->coordToPixel(position), plot->yAxis->coordToPixel(deviation))
            .toPoint();
    }
    void press(Qt::Key key) const { QTest::keyClick(plot, key); }
    [[nodiscard]] Exclusion selected() const
    {
        return view.selected() ? view.selected()->values : Exclusion{};
    }

    DeviationPlot view;
    QSignalSpy selections;
    QCustomPlot* plot = nullptr;
};

} // namespace

/// The plot of ISO 230-2 in the window.
class TestDeviationPlot : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void theMouseReadsTheTargetUnderIt()
    {
        Fixture bench({seriesOf(measurementOf("bifrost"))});
        QTest::mouseMove(bench.plot, bench.pixel(45.0, 0.0));
        QTRY_COMPARE(
            bench.readout(), QStringLiteral("target 45.6 mm, ↑ -12.25, ↓ -11.11 µm, B -1.14 µm"));
        QCOMPARE(bench.plot->yAxis->label(), QStringLiteral("Deviation [µm]\n0 = mean at 15 mm"));
    }

    void aClickSelectsTheValueAndSaysIt()
    {
        Fixture bench({seriesOf(measurementOf("ess_mcu1025"), {}, OutlierRule::PooledMad)});
        const double shown = 0.0931843 - 0.0070189; // from the mean at the first target
        QTest::mouseClick(bench.plot, Qt::LeftButton, {}, bench.pixel(15.0, shown));
        QCOMPARE(bench.selections.size(), 1);
        QVERIFY(bench.selected() == (Exclusion{Approach::Down, 1, 1}));
        QTest::mouseMove(bench.plot, QPoint(2, 2));
        QTRY_COMPARE(bench.readout(),
            QStringLiteral("down, target 1, run 1, 86.17 µm, proposed for exclusion"));
        QCOMPARE(bench.plot->accessibleDescription(), bench.readout());
    }

    void arrowKeysGoFromValueToValue()
    {
        Fixture bench({seriesOf(measurementOf("bifrost"))});
        bench.press(Qt::Key_Down); // the highest of the first target
        QVERIFY(bench.selected() == (Exclusion{Approach::Down, 1, 1})
            || bench.selected() == (Exclusion{Approach::Down, 1, 2})); // 5.18 both
        bench.press(Qt::Key_Right);
        QCOMPARE(bench.selected().target, std::optional<std::size_t>(2));
        QCOMPARE(bench.selected().direction, std::optional(Approach::Down));
        for (int i = 0; i < 20; ++i)
            bench.press(Qt::Key_Down);
        QVERIFY(bench.selected() == (Exclusion{Approach::Down, 2, 5})); // -4.74, the lowest
        bench.press(Qt::Key_Up);
        QVERIFY(bench.selected() == (Exclusion{Approach::Down, 2, 3})); // -4.33
        bench.press(Qt::Key_Escape);
        QVERIFY(!bench.view.selected());
    }

    void whatIsSelectedElsewhereIsShownWithoutBeingReported()
    {
        Fixture bench({seriesOf(measurementOf("bifrost"))});
        bench.view.select(DeviationPlace{0, {{}, 4, {}}});
        QCOMPARE(bench.selections.size(), 0);
        QVERIFY(bench.readout().startsWith(QStringLiteral("target 45.6 mm")));
        bench.view.select(DeviationPlace{0, {Approach::Up, {}, 3}});
        QCOMPARE(bench.readout(), QStringLiteral("run 3, up"));
        bench.view.setSeries({});
        QVERIFY(!bench.view.selected() && bench.readout().isEmpty());
    }

    void anExcludedValueLeavesTheScaleAndIsStillFound()
    {
        Measurement measurement = measurementOf("ess_mcu1025");
        const Exclusion outlier{Approach::Down, 1, 1};
        QVERIFY(exclude(measurement, {&outlier, 1}));
        Fixture bench({seriesOf(std::move(measurement))});
        QVERIFY(bench.plot->yAxis->range().upper < 0.0931843);
        // It stands at the upper border, with an arrow.
        const QPoint border(bench.pixel(15.0, 0.0).x(), bench.plot->axisRect()->top() + 10);
        QTest::mouseClick(bench.plot, Qt::LeftButton, {}, border);
        QVERIFY(bench.selected() == outlier);
        QVERIFY(bench.plot->accessibleDescription().endsWith(QStringLiteral(", excluded")));
    }

    void twoMeasurementsHaveOneScale()
    {
        Measurement after = measurementOf("bifrost");
        for (RunValue& value : after.values)
            value.deviation /= 10.0;
        Fixture bench({seriesOf(measurementOf("bifrost"), QStringLiteral("before")),
            seriesOf(std::move(after), QStringLiteral("after"))});
        QVERIFY(bench.plot->yAxis->range().lower < -0.010);
        QStringList names;
        for (int i = 0; i < bench.plot->legend->itemCount(); ++i)
            names += static_cast<QCPPlottableLegendItem*>(bench.plot->legend->item(i))
                         ->plottable()
                         ->name();
        QVERIFY(names.contains(QStringLiteral("before: mean ↑")));
        QVERIFY(names.contains(QStringLiteral("after: mean of both")));
        bench.press(Qt::Key_Right); // begins with the newest
        QCOMPARE(bench.view.selected()->series, std::size_t{1});
        bench.press(Qt::Key_Space);
        QCOMPARE(bench.view.selected()->series, std::size_t{0});
        QVERIFY(bench.readout().startsWith(QStringLiteral("before: target 15 mm")));
    }

    void theSameMeasurementKeepsTheViewAndAnotherOneIsSeenWhole()
    {
        const DeviationSeries series = seriesOf(measurementOf("bifrost"));
        Fixture bench({series});
        const QCPRange whole = bench.plot->xAxis->range();
        bench.press(Qt::Key_Plus);
        QVERIFY(bench.plot->xAxis->range().size() < whole.size());
        DeviationSeries again = series;
        again.outliers = nullptr;
        bench.view.setSeries({again});
        QVERIFY(bench.plot->xAxis->range().size() < whole.size());
        bench.press(Qt::Key_Home);
        QCOMPARE(bench.plot->xAxis->range().size(), whole.size());
        bench.press(Qt::Key_Plus);
        bench.view.setSeries({seriesOf(measurementOf("b02_x"))});
        QVERIFY(bench.plot->xAxis->range().lower <= measurementOf("b02_x").targets.front());
    }

    void aMillionValuesAreShownAndWalkedWithoutAStop()
    {
        const DeviationSeries series = seriesOf(longMeasurement(250'000));
        Fixture bench({});
        test::Heartbeat heart;
        bench.view.setSeries({series});
        QTest::qWait(50);
        bench.press(Qt::Key_Right);
        bench.press(Qt::Key_Up);
        for (int i = 0; i < 20; ++i) {
            bench.press(Qt::Key_Plus);
            QTest::qWait(1); // a person does not press twice in one event
        }
        QTest::mouseClick(bench.plot, Qt::LeftButton, {}, bench.plot->axisRect()->center());
        QTest::qWait(50);
        bench.press(Qt::Key_Home);
        bench.view.setSeries({});
        QTest::qWait(50);
        // Of a build that is not optimised; the goal for one that is are 16 ms.
        QVERIFY2(heart.longestBusy() < std::chrono::milliseconds(150),
            qPrintable(QStringLiteral("%1 us").arg(heart.longestBusy().count())));
    }

    void nearEnoughEveryPointIsDrawn()
    {
        Fixture bench({seriesOf(longMeasurement(20'000))});
        bench.plot->xAxis->setRange(5000.0, 5100.0);
        bench.plot->replot();
        const auto drawn = bench.plot->graph(0)->dataCount();
        QVERIFY2(drawn >= 101 && drawn <= 110, qPrintable(QString::number(drawn)));
    }
};

AXISCOMP_WINDOW_TEST(TestDeviationPlot)

} // namespace tst_deviationplot

#include "tst_deviationplot.moc"
