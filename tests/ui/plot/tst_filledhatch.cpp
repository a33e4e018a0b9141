// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/window_test.h"
#include "ui/drawing/filled_hatch.h"

#include <QTest>

namespace tst_filledhatch {

using namespace axiscomp;
using axiscomp::ui::FilledHatch;

/// What of a map was made up.
class TestFilledHatch : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void halfACellAroundEachFilledPointIsHatched()
    {
        QCustomPlot plot;
        plot.resize(400, 400);
        plot.xAxis->setRange(0.0, 30.0); // beyond the table
        plot.yAxis->setRange(0.0, 20.0);
        auto* hatch = new FilledHatch(plot);
        auto table = std::make_shared<CompensationTable>();
        table->grid.axes = {{"X", "mm", 0.0, 10.0, 3}, {"Y", "mm", 0.0, 10.0, 3}};
        table->values.assign(9, 0.0F);
        table->filled = {1, 2, 4};
        hatch->setTable(table);
        plot.replot();
        const auto places = hatch->places();
        QCOMPARE(places.size(), std::size_t{2}); // 1 and 2 are one, in the first row
        const auto x = [&](double pixel) { return plot.xAxis->pixelToCoord(pixel); };
        const auto y = [&](double pixel) { return plot.yAxis->pixelToCoord(pixel); };
        QVERIFY(std::abs(x(places[0].left()) - 5.0) < 0.2);
        QVERIFY(std::abs(x(places[0].right()) - 20.0) < 0.2); // not beyond the table
        QVERIFY(std::abs(y(places[0].bottom())) < 0.2 && std::abs(y(places[0].top()) - 5.0) < 0.2);
        QVERIFY(std::abs(x(places[1].left()) - 5.0) < 0.2);
        QVERIFY(std::abs(x(places[1].right()) - 15.0) < 0.2);
        QVERIFY(std::abs(y(places[1].bottom()) - 5.0) < 0.2);
        plot.xAxis->setRange(0.0, 4.0); // none of them is in sight
        plot.replot();
        QVERIFY(hatch->places().empty());
    }
};

AXISCOMP_WINDOW_TEST(TestFilledHatch)

} // namespace tst_filledhatch

#include "tst_filledhatch.moc"
