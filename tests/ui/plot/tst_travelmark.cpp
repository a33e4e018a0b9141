// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/table_samples.h"
#include "tests/ui/support/window_test.h"
#include "ui/plot/table_plot.h"

#include <QTest>

#include "ui/drawing/custom_plot.h"

namespace tst_travelmark {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::sharedTable;

namespace {

using Spans = std::array<std::optional<Travel>, 3>;

struct Fixture {
    explicit Fixture(TableViewModel::Table table)
    {
        shown.setTables(std::move(table), nullptr);
        view.resize(640, 480);
        view.show();
        plot = view.findChild<QCustomPlot*>(QStringLiteral("plotCanvas"));
    }
    void setTravel(const Spans& travel, bool holdsEnds = true)
    {
        view.setTravel(travel, holdsEnds);
        plot->replot(QCustomPlot::rpImmediateRefresh);
    }
    [[nodiscard]] QImage picture() const { return plot->grab().toImage(); }
    /// Of a place between grid lines.
    [[nodiscard]] QColor colorAt(double x, double y) const
    {
        return picture().pixelColor(static_cast<int>(plot->xAxis->coordToPixel(x)),
            static_cast<int>(plot->yAxis->coordToPixel(y)));
    }
    [[nodiscard]] QColor base() const { return view.palette().base().color(); }
    /// What is said beside the marker; empty when nothing is.
    [[nodiscard]] QString note() const
    {
        for (int i = 0; i < plot->itemCount(); ++i) {
            const auto* text = qobject_cast<QCPItemText*>(plot->item(i));
            if (text && text->visible() && text->text().size() > 1)
                return text->text();
        }
        return {};
    }

    TableViewModel shown;
    TablePlot view{shown};
    QCustomPlot* plot = nullptr;
};

} // namespace

class TestTravelMark : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnWindowWarnings();
        QLocale::setDefault(QLocale::c());
    }

    void theWholeViewShowsTheTravelToo()
    {
        Fixture bench(sharedTable({9})); // 0 to 20
        const QCPRange table = bench.plot->xAxis->range();
        bench.setTravel({Travel{-10.0, 30.0}});
        QVERIFY(bench.plot->xAxis->range().contains(-10.0));
        QVERIFY(bench.plot->xAxis->range().contains(30.0));
        // As long as nothing else is looked at.
        bench.plot->xAxis->setRange(3.0, 4.0);
        bench.setTravel({Travel{-5.0, 30.0}});
        QCOMPARE(bench.plot->xAxis->range(), QCPRange(3.0, 4.0));
        bench.view.setTravel({}, true);
        QTest::keyClick(bench.plot, Qt::Key_Home);
        QCOMPARE(bench.plot->xAxis->range(), table);
    }

    void aLongTravelLeavesTheTableAThirdOfThePicture()
    {
        Fixture bench(sharedTable({9}));
        bench.setTravel({Travel{-1000.0, 5000.0}});
        QVERIFY(std::abs(bench.plot->xAxis->range().size() - 60.0 * 1.04) < 1e-9);
    }

    void theTravelIsTintedAndEndsWhereTheAxisDoes()
    {
        Fixture bench(sharedTable({9}));
        bench.setTravel({Travel{-10.0, 13.0}});
        const double middle = bench.plot->yAxis->range().center();
        const double high = middle + 0.23 * bench.plot->yAxis->range().size();
        QVERIFY(bench.colorAt(-7.3, high) != bench.base());
        QCOMPARE(bench.colorAt(18.7, high), bench.base());
        bench.setTravel({});
        QCOMPARE(bench.colorAt(1.3, high), bench.base());
    }

    void beyondTheTableTheEndValueIsDrawn()
    {
        Fixture bench(sharedTable({9}));
        bench.setTravel({Travel{0.0, 40.0}}, false);
        const QImage without = bench.picture();
        bench.setTravel({Travel{0.0, 40.0}}, true);
        const QImage with = bench.picture();
        const auto last = static_cast<double>(bench.shown.table()->values.back());
        const int y = static_cast<int>(std::round(bench.plot->yAxis->coordToPixel(last)));
        const auto differing = [&](int line) {
            int count = 0;
            for (int x = static_cast<int>(bench.plot->xAxis->coordToPixel(20.5));
                 x < static_cast<int>(bench.plot->xAxis->coordToPixel(39.5)); ++x)
                count += without.pixel(x, line) != with.pixel(x, line) ? 1 : 0;
            return count;
        };
        QVERIFY2(std::max({differing(y - 1), differing(y), differing(y + 1)}) > 60,
            "no dashed line at the end value");
        QCOMPARE(differing(y + 6), 0);
    }

    void theTravelGoesAroundTheMap()
    {
        Fixture bench(sharedTable({9, 7})); // 0 to 20, 100 to 115
        bench.setTravel({Travel{-5.0, 25.0}, Travel{95.0, 120.0}});
        QVERIFY(bench.plot->yAxis->range().contains(95.0));
        QVERIFY(bench.plot->yAxis->range().contains(120.0));
        QVERIFY(bench.colorAt(-3.1, 107.3) != bench.base());
        bench.setTravel({std::nullopt, std::nullopt, Travel{0.0, 1.0}}); // of no drawn axis
        QVERIFY(!bench.plot->yAxis->range().contains(95.0));
    }

    void ofASliceTheDrawnDimensions()
    {
        Fixture bench(sharedTable({9, 7, 5})); // Z: 200 to 210
        bench.shown.setSlice(1, 2);
        bench.setTravel({Travel{-50.0, 80.0}, Travel{98.0, 117.0}, Travel{195.0, 211.0}});
        QVERIFY(bench.plot->xAxis->range().contains(98.0));
        QVERIFY(!bench.plot->xAxis->range().contains(90.0));
        QVERIFY(bench.plot->yAxis->range().contains(195.0));
    }

    void outsideTheTableIsSaidAtTheMarker()
    {
        Fixture bench(sharedTable({9, 7, 5}));
        const auto noteAt = [&](double x, double y, double z) {
            bench.view.setMarker(TablePlot::Marker{{x, y, z}, 0.0});
            return bench.note();
        };
        const QString outside = QStringLiteral("outside the table: end value held");
        QCOMPARE(noteAt(3.0, 101.0, 204.0), QString());
        QCOMPARE(noteAt(-0.1, 101.0, 204.0), outside);
        QCOMPARE(noteAt(3.0, 115.1, 204.0), outside);
        QCOMPARE(noteAt(3.0, 101.0, 210.1), outside); // also of the dimension that is cut
        QCOMPARE(noteAt(20.0, 115.0, 210.0), QString());
        static_cast<void>(noteAt(-0.1, 101.0, 204.0));
        bench.view.setMarker(std::nullopt);
        QCOMPARE(bench.note(), QString());
        // Where something else than the end value is beyond the table, nothing is claimed.
        bench.view.setTravel({}, false);
        QCOMPARE(noteAt(-0.1, 101.0, 204.0), QString());
    }
};

AXISCOMP_WINDOW_TEST(TestTravelMark)

} // namespace tst_travelmark

#include "tst_travelmark.moc"
