// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/calibration_csv.h"
#include "core/table/lookup.h"
#include "core/table/table_math.h"
#include "tests/ui/support/table_samples.h"
#include "tests/ui/support/window_test.h"
#include "ui/drawing/table_map.h"
#include "ui/plot/table_plot.h"
#include "ui/text/value_text.h"

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "ui/drawing/custom_plot.h"

namespace tst_tableplot {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::namedTable;
using test::sharedTable;

namespace {

/// The picture of a table in a window of its own.
struct Fixture {
    explicit Fixture(TableViewModel::Table selected, TableViewModel::Table onDrive = {})
    {
        shown.setTables(std::move(selected), std::move(onDrive));
        view = std::make_unique<TablePlot>(shown);
        view->resize(640, 480);
        view->show();
        plot = view->findChild<QCustomPlot*>(QStringLiteral("plotCanvas"));
        view->activateWindow();
        plot->setFocus(); // its keys are shortcuts
        static_cast<void>(QTest::qWaitFor([this] { return plot->hasFocus(); }));
        plot->replot(QCustomPlot::rpImmediateRefresh);
    }
    [[nodiscard]] QString readout() const
    {
        return view->findChild<QLabel*>(QStringLiteral("plotReadout"))->text();
    }
    [[nodiscard]] TableMap& map() const
    {
        for (int i = 0; i < plot->plottableCount(); ++i)
            if (auto* map = dynamic_cast<TableMap*>(plot->plottable(i)))
                return *map;
        qFatal("the plot has no map");
    }
    [[nodiscard]] QPoint pixelOf(const GridPoint& point) const
    {
        const Grid& grid = shown.drawn()->grid;
        const double y = grid.dimensions() == 2 ? grid.axes[1].position(point.j)
                                                : static_cast<double>(shown.valueAt(point));
        return QPointF(
            plot->xAxis->coordToPixel(grid.axes[0].position(point.i)), plot->yAxis->coordToPixel(y))
            .toPoint();
    }
    void press(Qt::Key key) { QTest::keyClick(plot, key); }
    void showCursors()
    {
        view->findChild<QToolButton*>(QStringLiteral("plotCursors"))->setChecked(true);
    }
    [[nodiscard]] QString save(const QString& path)
    {
        QFuture<QString> done = view->exportTo(path);
        done.waitForFinished();
        return done.result();
    }

    TableViewModel shown;
    std::unique_ptr<TablePlot> view;
    QCustomPlot* plot = nullptr;
};

/// A table over 40 x 30 mm with a closed form.
TableViewModel::Table surface(
    std::uint32_t width, std::uint32_t height, double (*value)(double, double))
{
    CompensationTable table = namedTable({width, height});
    table.grid.axes[0].distance = 40.0 / (width - 1);
    table.grid.axes[1].distance = 30.0 / (height - 1);
    for (std::size_t n = 0; n < table.values.size(); ++n)
        table.values[n] = static_cast<float>(value(table.grid.axes[0].position(n % width),
            table.grid.axes[1].position(n / width) - 100.0));
    return std::make_shared<const CompensationTable>(std::move(table));
}

int widestImage(const QByteArray& document)
{
    int widest = 0;
    for (qsizetype at = 0; (at = document.indexOf("/Width ", at)) >= 0; at += 7)
        widest = std::max(
            widest, QByteArray(document.mid(at + 7, 6)).simplified().split(' ')[0].toInt());
    return widest;
}

int channelDifference(const QColor& a, const QColor& b)
{
    return std::max({std::abs(a.red() - b.red()), std::abs(a.green() - b.green()),
        std::abs(a.blue() - b.blue())});
}

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class TestTablePlot : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnWindowWarnings();
        QLocale::setDefault(QLocale::c());
    }

    void theCrosshairSaysWhatTheDriveLooksUp_data()
    {
        QTest::addColumn<QList<int>>("sizes");
        QTest::newRow("1D") << QList<int>{9};
        QTest::newRow("2D") << QList<int>{8, 7};
        QTest::newRow("3D") << QList<int>{6, 5, 4};
    }
    void theCrosshairSaysWhatTheDriveLooksUp()
    {
        QFETCH(QList<int>, sizes);
        const auto table = sharedTable({sizes.begin(), sizes.end()});
        Fixture bench(table);
        bench.shown.setSlice(2, 3); // Y is cut, in 3D
        bench.plot->replot(QCustomPlot::rpImmediateRefresh);
        const Lookup lookup(*table);
        const Grid& drawn = bench.shown.drawn()->grid;
        for (std::size_t i = 0; i < drawn.axes[0].size; ++i) {
            const GridPoint point{i, drawn.dimensions() == 2 ? i % drawn.axes[1].size : 0};
            QTest::mouseMove(bench.plot, bench.pixelOf(point));
            std::array<double, 3> position{};
            if (bench.shown.isCut())
                position[1] = table->grid.axes[1].position(3);
            position[bench.shown.dimensionOf(0)] = drawn.axes[0].position(point.i);
            if (drawn.dimensions() == 2)
                position[bench.shown.dimensionOf(1)] = drawn.axes[1].position(point.j);
            const double value =
                lookup.at(std::span(position).first(static_cast<std::size_t>(sizes.size())));
            const QString text = bench.readout();
            QVERIFY2(text.endsWith(bench.shown.valueScale().textWithUnit(value))
                    && text.endsWith(QStringLiteral(" µm")),
                qPrintable(text + QStringLiteral(" is not ") + QString::number(value)));
            QVERIFY2(
                text.startsWith(QStringLiteral("X ") + numberText(position[0])), qPrintable(text));
        }
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(bench.plot, &leave);
        QCOMPARE(bench.readout(), QString());
    }

    void aClickHoldsTheCrosshair()
    {
        Fixture bench(sharedTable({8, 7}));
        QTest::mouseClick(bench.plot, Qt::LeftButton, {}, bench.pixelOf({5, 2}));
        QCOMPARE(bench.shown.current(), std::optional(GridPoint{5, 2}));
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(bench.plot, &leave);
        QCOMPARE(bench.readout(), bench.shown.pointText({5, 2}));
        bench.press(Qt::Key_Escape);
        QVERIFY(!bench.shown.current());
        QCOMPARE(bench.readout(), QString());
    }

    void theColoursAreSymmetricAboutZero()
    {
        CompensationTable table = namedTable({4, 3, 5});
        table.values.assign(table.values.size(), 0.001F);
        table.values[7] = -0.005F;
        Fixture bench(std::make_shared<const CompensationTable>(table));
        // The slice in the middle lacks the extreme: all slices share one scale.
        QCOMPARE(bench.map().dataRange().lower, static_cast<double>(-0.005F));
        QCOMPARE(bench.map().dataRange().upper, static_cast<double>(0.005F));
        QCPColorGradient gradient = bench.map().gradient();
        const QCPRange range = bench.map().dataRange();
        const QColor zero = gradient.color(0.0, range);
        QVERIFY2(zero.saturation() < 20, qPrintable(zero.name()));
        for (const double part : {0.25, 0.5, 1.0}) {
            const QColor above = gradient.color(part * range.upper, range);
            const QColor below = gradient.color(-part * range.upper, range);
            QVERIFY2(above.red() > above.blue() && below.blue() > below.red(),
                qPrintable(above.name() + u' ' + below.name()));
            // Equal amounts look equally strong, also to eyes that see no red.
            QVERIFY2(std::abs(qGray(above.rgb()) - qGray(below.rgb())) < 32,
                qPrintable(above.name() + u' ' + below.name()));
        }
    }

    void theMapIsWhatTheDriveInterpolates()
    {
        // Bilinear between four points: this very function.
        Fixture bench(surface(2, 2, [](double x, double y) { return (x - 10.0) * (y - 20.0); }));
        const QImage image = bench.plot->grab().toImage();
        QCPColorGradient gradient = bench.map().gradient();
        int compared = 0;
        for (double x = 0.5; x < 40.0; x += 1.7) {
            for (double y = 0.5; y < 30.0; y += 1.3) {
                const QPointF pixel(
                    bench.plot->xAxis->coordToPixel(x), bench.plot->yAxis->coordToPixel(100.0 + y));
                const QColor wanted =
                    gradient.color((x - 10.0) * (y - 20.0), bench.map().dataRange());
                const QColor found = image.pixelColor(pixel.toPoint());
                QVERIFY2(channelDifference(wanted, found) <= 6,
                    qPrintable(wanted.name() + u' ' + found.name()));
                ++compared;
            }
        }
        QVERIFY(compared > 500);
        // No further than the table.
        const double right = bench.plot->xAxis->coordToPixel(40.0);
        const int middle = bench.plot->axisRect()->center().y() + 3;
        QVERIFY(bench.plot->axisRect()->right() - right > 4.0);
        const auto isBase = [&](double x) {
            return image.pixelColor(static_cast<int>(x), middle)
                == bench.view->palette().base().color();
        };
        QVERIFY(isBase(right + 2.0) && !isBase(right - 2.0));
    }

    void gridPointsAreShownOnDemand()
    {
        const auto flat = [](double, double) { return 1.0; };
        Fixture bench(surface(9, 7, flat));
        const QPoint point = bench.pixelOf({4, 3});
        const auto changed = [&, plain = bench.plot->grab().toImage()] {
            const QImage image = bench.plot->grab().toImage();
            int count = 0;
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x)
                    count += image.pixel(x, y) != plain.pixel(x, y) ? 1 : 0;
            return std::pair(count, image.pixelColor(point));
        };
        const QAction* action = bench.view->findChild<QAction*>(QStringLiteral("plotPoints"));
        bench.press(Qt::Key_G);
        QVERIFY(action->isChecked());
        bench.plot->replot(QCustomPlot::rpImmediateRefresh);
        const auto [count, color] = changed();
        QVERIFY2(count >= 9 * 7 * 9 && count <= 9 * 7 * 25, qPrintable(QString::number(count)));
        QCOMPARE(color, bench.view->palette().text().color());
        bench.press(Qt::Key_G);
        bench.plot->replot(QCustomPlot::rpImmediateRefresh);
        QCOMPARE(changed().first, 0);
        // Too close to be told apart, until they are zoomed into; and none on a curve.
        bench.shown.setTables(surface(300, 200, flat), nullptr);
        bench.plot->replot(QCustomPlot::rpImmediateRefresh);
        const auto pointsSeen = [&] {
            const QImage image = bench.plot->grab().toImage();
            bench.press(Qt::Key_G);
            bench.plot->replot(QCustomPlot::rpImmediateRefresh);
            const bool isSame = image == bench.plot->grab().toImage();
            bench.press(Qt::Key_G);
            return !isSame;
        };
        QVERIFY(!pointsSeen());
        for (int n = 0; n < 8; ++n)
            bench.press(Qt::Key_Plus);
        bench.plot->replot(QCustomPlot::rpImmediateRefresh);
        QVERIFY(pointsSeen());
        bench.shown.setTables(sharedTable({9}), nullptr);
        bench.plot->replot(QCustomPlot::rpImmediateRefresh);
        QVERIFY(!pointsSeen() && !action->isEnabled());
    }

    void contoursAreDrawnOnDemand()
    {
        Fixture bench(surface(5, 4, [](double x, double) { return x; }));
        const QImage plain = bench.plot->grab().toImage();
        bench.press(Qt::Key_C);
        QTRY_VERIFY_WITH_TIMEOUT(bench.plot->grab().toImage() != plain, test::patienceMs);
        const QImage image = bench.plot->grab().toImage();
        const auto darkAt = [&](double x) {
            const int column = static_cast<int>(bench.plot->xAxis->coordToPixel(x));
            int count = 0;
            for (int y = 0; y < image.height(); ++y) {
                int least = 255;
                for (int n = column - 1; n <= column + 1; ++n)
                    least = std::min(least, qGray(image.pixel(n, y)));
                count += least < 90 ? 1 : 0;
            }
            return count;
        };
        const int height = static_cast<int>(bench.map().visiblePlace().height());
        for (const double level : {5.0, 15.0, 35.0}) // but for the label
            QVERIFY2(darkAt(level) > height * 8 / 10, qPrintable(QString::number(darkAt(level))));
        QVERIFY(darkAt(7.3) < height / 10);
        bench.press(Qt::Key_C);
        bench.plot->replot(QCustomPlot::rpImmediateRefresh);
        QVERIFY(bench.plot->grab().toImage() == plain);
        // A constant table has none, and a curve neither.
        bench.press(Qt::Key_C);
        bench.shown.setTables(surface(5, 4, [](double, double) { return 2.0; }), nullptr);
        bench.shown.setTables(sharedTable({9}), nullptr);
        bench.plot->replot(QCustomPlot::rpImmediateRefresh);
    }

    void theCrossSectionsAreThoseOfTheDrive()
    {
        const auto value = [](double x, double y) { return (x - 10.0) * (y - 20.0); };
        Fixture bench(surface(5, 4, value));
        bench.press(Qt::Key_X);
        bench.plot->replot(QCustomPlot::rpImmediateRefresh);
        const auto verifyAt = [&](double x, double y) {
            int found = 0;
            for (int n = 0; n < bench.plot->plottableCount(); ++n) {
                if (const auto* graph = qobject_cast<QCPGraph*>(bench.plot->plottable(n));
                    graph && graph->keyAxis() != bench.plot->xAxis) {
                    ++found;
                    QCOMPARE(graph->dataCount(), 5);
                    for (const QCPGraphData& point : *graph->data())
                        QVERIFY(std::abs(point.value - value(point.key, y)) < 1e-4);
                }
                if (const auto* curve = qobject_cast<QCPCurve*>(bench.plot->plottable(n))) {
                    ++found;
                    QCOMPARE(curve->dataCount(), 4);
                    for (const QCPCurveData& point : *curve->data())
                        QVERIFY(std::abs(point.key - value(x, point.value - 100.0)) < 1e-4);
                }
            }
            QCOMPARE(found, 2);
        };
        verifyAt(20.0, 15.0); // the middle
        bench.view->setMarker(TablePlot::Marker{{3.3, 107.7}, 0.0});
        verifyAt(3.3, 7.7);
        QTest::mouseClick(bench.plot, Qt::LeftButton, {}, bench.pixelOf({3, 2}));
        verifyAt(30.0, 20.0);
        bench.showCursors();
        bench.shown.setCurrent(GridPoint{1, 1});
        verifyAt(10.0, 10.0);
    }

    void theCrossSectionsShareTheZoomOfTheMap()
    {
        Fixture bench(sharedTable({20, 20}));
        const int before = bench.plot->axisRect()->width();
        bench.press(Qt::Key_X);
        bench.plot->replot(QCustomPlot::rpImmediateRefresh);
        QVERIFY(bench.plot->axisRect()->width() < before - 60);
        bench.press(Qt::Key_Plus);
        bench.press(Qt::Key_Right);
        QCPAxis* below = nullptr;
        QCPAxis* beside = nullptr;
        for (int n = 0; n < bench.plot->plottableCount(); ++n) {
            const auto* graph = qobject_cast<QCPGraph*>(bench.plot->plottable(n));
            const auto* curve = qobject_cast<QCPCurve*>(bench.plot->plottable(n));
            if (graph && graph->keyAxis() != bench.plot->xAxis)
                below = graph->keyAxis();
            if (curve)
                beside = curve->valueAxis();
        }
        QVERIFY(below && beside);
        QCOMPARE(below->range(), bench.plot->xAxis->range());
        QCOMPARE(beside->range(), bench.plot->yAxis->range());
        beside->setRange(101.0, 103.0);
        QCOMPARE(bench.plot->yAxis->range(), QCPRange(101.0, 103.0));
        // Side by side, to the pixel.
        bench.plot->replot(QCustomPlot::rpImmediateRefresh);
        QCOMPARE(below->axisRect()->left(), bench.plot->axisRect()->left());
        QCOMPARE(below->axisRect()->right(), bench.plot->axisRect()->right());
        QCOMPARE(beside->axisRect()->top(), bench.plot->axisRect()->top());
        QCOMPARE(beside->axisRect()->bottom(), bench.plot->axisRect()->bottom());
        bench.press(Qt::Key_X);
        bench.press(Qt::Key_Home); // other positions have longer labels
        bench.plot->replot(QCustomPlot::rpImmediateRefresh);
        QCOMPARE(bench.plot->axisRect()->width(), before);
    }

    void theCursorsSayTheirDifference()
    {
        const auto table = sharedTable({8, 7});
        Fixture bench(table);
        bench.showCursors();
        QTest::mouseClick(bench.plot, Qt::LeftButton, {}, bench.pixelOf({1, 2}));
        bench.press(Qt::Key_Space); // B
        QTest::mouseClick(bench.plot, Qt::LeftButton, {}, bench.pixelOf({5, 5}));
        bench.press(Qt::Key_Right);
        bench.press(Qt::Key_Down);
        const double difference = static_cast<double>(table->values[4 * 8 + 6])
            - static_cast<double>(table->values[2 * 8 + 1]);
        QCOMPARE(bench.readout(),
            QStringLiteral("A: %1     B: %2\nB - A: X +12.5 mm, Y +5 mm, %3")
                .arg(bench.shown.pointText({1, 2}), bench.shown.pointText({6, 4}),
                    bench.shown.valueScale().textWithUnit(difference)));
        QCOMPARE(bench.shown.current(), std::optional(GridPoint{6, 4}));
        // The values' current cell moves the cursor that is active.
        bench.shown.setCurrent(GridPoint{0, 0});
        QVERIFY(bench.readout().contains(QStringLiteral("B: ") + bench.shown.pointText({0, 0})));
    }

    void theKeyboardZoomsAndMovesAndGoesBack()
    {
        Fixture bench(sharedTable({50, 40}));
        const QCPRange whole = bench.plot->xAxis->range();
        bench.press(Qt::Key_Plus);
        QVERIFY(bench.plot->xAxis->range().size() < whole.size());
        const QCPRange zoomed = bench.plot->xAxis->range();
        bench.press(Qt::Key_Right);
        QVERIFY(bench.plot->xAxis->range().center() > zoomed.center());
        bench.press(Qt::Key_Minus);
        bench.press(Qt::Key_Home);
        QCOMPARE(bench.plot->xAxis->range(), whole);
    }

    void theMouseZoomsAndMoves()
    {
        Fixture bench(sharedTable({50, 40}));
        const QCPRange whole = bench.plot->xAxis->range();
        const QPoint centre = bench.plot->axisRect()->center();
        QWheelEvent wheel(centre, bench.plot->mapToGlobal(centre), {}, {0, 120}, Qt::NoButton,
            Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(bench.plot, &wheel);
        const QCPRange zoomed = bench.plot->xAxis->range();
        QVERIFY(zoomed.size() < whole.size());
        QTest::mousePress(bench.plot, Qt::LeftButton, {}, centre);
        QTest::mouseMove(bench.plot, centre + QPoint(60, 0));
        QTest::mouseRelease(bench.plot, Qt::LeftButton, {}, centre + QPoint(60, 0));
        QVERIFY(bench.plot->xAxis->range().center() < zoomed.center());
        QVERIFY(!bench.shown.current()); // dragging is no click
        QTest::mouseClick(
            bench.view->findChild<QToolButton*>(QStringLiteral("plotResetZoom")), Qt::LeftButton);
        QCOMPARE(bench.plot->xAxis->range(), whole);
    }

    void theZoomStaysFromSliceToSlice()
    {
        Fixture bench(sharedTable({20, 20, 5}), sharedTable({20, 20, 5}, 1.0));
        bench.press(Qt::Key_Plus);
        const QCPRange zoomed = bench.plot->xAxis->range();
        bench.shown.setSlice(3, 0);
        bench.shown.setContent(TableContent::Drive);
        QCOMPARE(bench.plot->xAxis->range(), zoomed);
        QCOMPARE(bench.shown.sliceIndex(), 0);
        // A point that is out of sight is brought into it.
        bench.shown.setCurrent(GridPoint{0, 0});
        QVERIFY(bench.plot->xAxis->range().contains(0.0));
        QCOMPARE(bench.plot->xAxis->range().size(), zoomed.size());
        bench.shown.setSlice(1, 0);
        QVERIFY(
            bench.plot->xAxis->range().contains(100.0) && bench.plot->xAxis->label() == u"Y [mm]");
    }

    void theDrivesCurveStandsBesideTheSelectedOne()
    {
        Fixture bench(sharedTable({9}), sharedTable({9}, 1.0));
        QVERIFY(bench.plot->legend->visible());
        int drawn = 0;
        for (int i = 0; i < bench.plot->graphCount(); ++i)
            drawn += bench.plot->graph(i)->dataCount() == 9 ? 1 : 0;
        QCOMPARE(drawn, 2);
        bench.shown.setContent(TableContent::Difference);
        QTRY_VERIFY(!bench.plot->legend->visible());
        QCOMPARE(bench.plot->yAxis->label(), QStringLiteral("difference [µm]"));
    }

    void theMarkerStandsWhereTheAxisIs()
    {
        Fixture bench(sharedTable({8, 7, 6}));
        bench.shown.setSlice(2, 1); // X and Z are drawn
        bench.view->setMarker(TablePlot::Marker{{3.0, 101.0, 204.5}, 0.001});
        const auto markers = [&] {
            QList<QPointF> places;
            for (int i = 0; i < bench.plot->graphCount(); ++i) {
                const QCPGraph& graph = *bench.plot->graph(i);
                if (graph.lineStyle() == QCPGraph::lsNone && graph.dataCount() == 1)
                    places += QPointF(graph.dataMainKey(0), graph.dataMainValue(0));
            }
            return places;
        };
        QCOMPARE(markers(), QList<QPointF>{QPointF(3.0, 204.5)});
        bench.shown.setTables(sharedTable({9}), nullptr);
        QCOMPARE(markers(), QList<QPointF>{QPointF(3.0, 0.001)});
        bench.view->setMarker(std::nullopt);
        QVERIFY(markers().isEmpty());
    }

    void aPictureIsSavedOnWhite()
    {
        const QTemporaryDir folder;
        const auto table = sharedTable({8, 7});
        Fixture bench(table);
        QPalette dark;
        dark.setColor(QPalette::Base, Qt::black);
        dark.setColor(QPalette::Text, Qt::white);
        bench.view->setPalette(dark);
        const QString path = folder.filePath(QStringLiteral("map.PNG"));
        QCOMPARE(bench.save(path), QString());
        const QImage image(path);
        QCOMPARE(image.size(), QSize(2000, 1300));
        QCOMPARE(image.pixelColor(3, 3), QColor(Qt::white));
        const auto largest = std::ranges::max_element(table->values) - table->values.begin();
        QCPColorGradient gradient = bench.map().gradient(); // the window is dark again
        QVERIFY(gradient.color(0.0, bench.map().dataRange()) != qRgb(247, 247, 247));
        bench.view->setPalette(QPalette(Qt::white));
        gradient = bench.map().gradient();
        const QRgb wanted =
            gradient.color(static_cast<double>(table->values[static_cast<std::size_t>(largest)]),
                bench.map().dataRange());
        qsizetype found = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x)
                found += image.pixel(x, y) == wanted ? 1 : 0;
        }
        QVERIFY2(found > 20, qPrintable(QString::number(found))); // the peak of a tent
    }

    void aPictureSaysWhatItIsAndWhereFrom()
    {
        const QTemporaryDir folder;
        Fixture bench(sharedTable({8, 7}));
        bench.view->setOrigin(
            {QStringLiteral("Gantry"), QStringLiteral("X"), QStringLiteral("grid.csv")});
        const QString png = folder.filePath(QStringLiteral("map.png"));
        QCOMPARE(bench.save(png), QString());
        const QImage image(png);
        QCOMPARE(image.text(QStringLiteral("Title")), QStringLiteral("table, compensation [µm]"));
        QVERIFY(image.text(QStringLiteral("Description"))
                    .startsWith(QStringLiteral("Gantry · axis X · grid.csv · ")));
        // Black on white, above the picture.
        int dark = 0;
        for (int y = 0; y < 100; ++y)
            for (int x = 0; x < image.width(); ++x)
                dark += image.pixelColor(x, y).lightness() < 80 ? 1 : 0;
        QVERIFY2(dark > 500, qPrintable(QString::number(dark)));
        const QString svg = folder.filePath(QStringLiteral("map.svg"));
        QCOMPARE(bench.save(svg), QString());
        const QByteArray drawing = contentOf(svg);
        QVERIFY(drawing.contains("<svg") && drawing.contains("grid.csv"));
        QVERIFY(drawing.contains("<image") && drawing.contains("X [mm]"));
    }

    void aNameIsProposed()
    {
        const PictureOrigin origin{
            QStringLiteral("Gantry/1"), QStringLiteral("X"), QStringLiteral("2D-superdata.csv")};
        QCOMPARE(proposedPictureName(origin, QStringLiteral("map")),
            QStringLiteral("Gantry_1 X 2D-superdata map.png"));
        QCOMPARE(proposedPictureName({}, {}), QStringLiteral("picture.png"));
        QCOMPARE(proposedPictureName({QString(400, u'a'), {}, {}}, {}).size(), 104);
    }

    void aDoubleClickShowsTheWholeAndTheRightButtonAMenu()
    {
        Fixture bench(sharedTable({50, 40}));
        const QCPRange whole = bench.plot->xAxis->range();
        bench.press(Qt::Key_Plus);
        QTest::mouseDClick(bench.plot, Qt::LeftButton, {}, bench.plot->axisRect()->center());
        QCOMPARE(bench.plot->xAxis->range(), whole);
        Q_EMIT bench.plot->customContextMenuRequested(bench.plot->axisRect()->center());
        auto* menu = bench.view->findChild<QMenu*>(QStringLiteral("plotMenu"));
        QVERIFY(menu && menu->isVisible());
        QStringList texts;
        for (const QAction* action : menu->actions())
            texts += action->text().remove(u'&');
        QVERIFY2(texts.contains(QStringLiteral("Whole view"))
                && texts.contains(QStringLiteral("Contours"))
                && texts.contains(QStringLiteral("Save picture…")),
            qPrintable(texts.join(u'|')));
        menu->close();
    }

    void aDocumentHasOnePageOfThePicturesSize_data()
    {
        QTest::addColumn<QList<int>>("sizes");
        QTest::addColumn<bool>("hasImage");
        QTest::newRow("curve") << QList<int>{9} << false;
        QTest::newRow("map") << QList<int>{8, 7} << true;
    }
    void aDocumentHasOnePageOfThePicturesSize()
    {
        QFETCH(QList<int>, sizes);
        QFETCH(bool, hasImage);
        const QTemporaryDir folder;
        Fixture bench(sharedTable({sizes.begin(), sizes.end()}));
        const QRect before = bench.plot->viewport();
        const QString path = folder.filePath(QStringLiteral("plot.pdf"));
        QCOMPARE(bench.save(path), QString());
        const QByteArray document = contentOf(path);
        QVERIFY(document.startsWith("%PDF-") && document.trimmed().endsWith("%%EOF"));
        QCOMPARE(document.count("/Type /Page\n"), 1);
        QVERIFY(document.contains("/MediaBox [0 0 750"));
        QVERIFY(document.contains("/Type /Font"));
        QCOMPARE(widestImage(document) > 2000, hasImage);
        QCOMPARE(bench.plot->viewport(), before);
        QCOMPARE(bench.map().visible(), hasImage);
    }

    void theSavedValuesAreOfTheTableThatIsShown()
    {
        const QTemporaryDir folder;
        const auto selected = sharedTable({6, 5, 4});
        const auto onDrive = sharedTable({6, 5, 4}, 1.0);
        Fixture bench(selected, onDrive);
        bench.shown.setContent(TableContent::Drive);
        bench.shown.setSlice(1, 2);
        bench.view->setValuesOrigin({false, {"lookup: encoder"}, {"lookup: set"}});
        const QString path = folder.filePath(QStringLiteral("table.csv"));
        QCOMPARE(bench.save(path), QString());
        CsvOptions options;
        options.dimensions = 3;
        const CsvReading reading = parseCalibrationCsv(contentOf(path).toStdString(), options);
        QVERIFY(reading.data.has_value());
        QCOMPARE(reading.data->tables.size(), std::size_t{1});
        QCOMPARE(reading.data->tables.front().values, onDrive->values);
        QCOMPARE(reading.data->notes, std::vector<std::string>{"lookup: set"});
    }

    void valuesThatNoDriveTakesAreNotSavedAsACalibrationFile()
    {
        const QTemporaryDir folder;
        Fixture bench(sharedTable({9}), sharedTable({9}, 1.0));
        const QString path = folder.filePath(QStringLiteral("values.csv"));
        bench.view->setValuesOrigin({false, {}, {}});
        QVERIFY(bench.save(path).contains(QStringLiteral("Export for Another Controller")));
        bench.view->setValuesOrigin({true, {}, {}});
        bench.shown.setContent(TableContent::Difference);
        QTRY_VERIFY(bench.shown.drawn());
        QVERIFY(bench.save(path).contains(QStringLiteral("difference")));
        QVERIFY(!QFile::exists(path));
    }

    void withoutATableThereIsNoScale()
    {
        Fixture bench(sharedTable({9}));
        QVERIFY(bench.plot->xAxis->tickLabels() && bench.plot->yAxis->tickLabels());
        bench.shown.setTables(nullptr, nullptr);
        QVERIFY(!bench.plot->xAxis->tickLabels() && !bench.plot->yAxis->tickLabels());
        bench.shown.setTables(sharedTable({9}), nullptr);
        QVERIFY(bench.plot->xAxis->tickLabels() && bench.plot->yAxis->tickLabels());
    }

    void whatCannotBeSavedIsSaidInASentence()
    {
        const QTemporaryDir folder;
        Fixture bench(sharedTable({9}));
        QVERIFY(bench.save(folder.filePath(QStringLiteral("plot.gif")))
                    .contains(QStringLiteral(".png, .svg, .pdf or .csv")));
        const QString path = folder.filePath(QStringLiteral("no/such/folder.png"));
        QVERIFY(!bench.save(path).isEmpty());
        bench.shown.setTables(nullptr, nullptr);
        QCOMPARE(bench.save(folder.filePath(QStringLiteral("plot.png"))),
            QStringLiteral("There is no table to save."));
        QVERIFY(QDir(folder.path()).isEmpty());
    }
};

AXISCOMP_WINDOW_TEST(TestTablePlot)

} // namespace tst_tableplot

#include "tst_tableplot.moc"
