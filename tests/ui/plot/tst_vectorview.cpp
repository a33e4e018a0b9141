// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/table_samples.h"
#include "tests/ui/support/window_test.h"
#include "ui/drawing/deformed_grid.h"
#include "ui/plot/exaggeration_combo.h"
#include "ui/plot/vector_view.h"

#include <QLabel>
#include <QTemporaryDir>
#include <QTest>

#include "ui/drawing/custom_plot.h"

namespace tst_vectorview {

using namespace axiscomp;
using namespace axiscomp::ui;

namespace {

/// 40 x 30 mm from 0, X and Y errors in micrometres of a closed form, as columns of one file.
VectorView::Data errorsOf(std::uint32_t width, std::uint32_t height, float (*x)(double, double),
    float (*y)(double, double))
{
    auto data = std::make_shared<CalibrationData>();
    data->grid.axes = {
        {"X", "mm", 0.0, 40.0 / (width - 1), width}, {"Y", "mm", 0.0, 30.0 / (height - 1), height}};
    for (const auto& [name, error] : {std::pair("X", x), std::pair("Y", y)}) {
        CompensationTable table{std::string(name) + " error", "um", data->grid, {}, name};
        for (std::size_t j = 0; j < height; ++j)
            for (std::size_t i = 0; i < width; ++i)
                table.values.push_back(
                    error(data->grid.axes[0].position(i), data->grid.axes[1].position(j)));
        data->tables.push_back(std::move(table));
    }
    return data;
}

float none(double, double)
{
    return 0.0F;
}
float four(double, double)
{
    return 4.0F;
}

float five(double, double)
{
    return 5.0F;
}

/// The same with errors of all three axes of a volume.
VectorView::Data volume()
{
    auto data = std::make_shared<CalibrationData>();
    data->grid = test::namedTable({6, 5, 4}).grid;
    for (const char* name : {"X", "Y", "Z"}) {
        CompensationTable table = test::namedTable({6, 5, 4});
        table.name = std::string(name) + " error";
        table.target = name;
        data->tables.push_back(std::move(table));
    }
    return data;
}

struct Fixture {
    explicit Fixture(const VectorView::Data& data)
    {
        view.resize(700, 520);
        view.setData(data);
        view.show();
        plot = view.findChild<QCustomPlot*>(QStringLiteral("vectorCanvas"));
        view.activateWindow();
        plot->setFocus();
        plot->replot(QCustomPlot::rpImmediateRefresh);
    }
    [[nodiscard]] QImage picture() const
    {
        plot->replot(QCustomPlot::rpImmediateRefresh);
        return plot->grab().toImage();
    }
    [[nodiscard]] QComboBox& box(const char* name) const
    {
        return *view.findChild<QComboBox*>(QLatin1StringView(name));
    }
    void press(Qt::Key key) const { QTest::keyClick(plot, key); }

    TableViewModel shown;
    VectorView view{shown};
    QCustomPlot* plot = nullptr;
};

/// How dark and blue a place is, beside it by at most a pixel: a line of the real grid.
bool hasRealLine(const QImage& picture, const QPointF& at)
{
    for (int dx = -1; dx <= 1; ++dx)
        for (int dy = -1; dy <= 1; ++dy) {
            const QColor pixel =
                picture.pixelColor(static_cast<int>(at.x()) + dx, static_cast<int>(at.y()) + dy);
            if (pixel.blue() - pixel.red() > 60)
                return true;
        }
    return false;
}

} // namespace

class TestVectorView : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnWindowWarnings();
        QLocale::setDefault(QLocale::c());
    }

    void theRealGridIsWhereReferenceAndNotEncoderSays()
    {
        // Every point is 4 µm further along X: at x 1000, 4 mm.
        Fixture bench(errorsOf(5, 4, four, none));
        bench.view.findChild<ExaggerationCombo*>(QStringLiteral("vectorExaggeration"))
            ->setCurrentIndex(10);
        QCOMPARE(bench.view.exaggeration(), 1000.0);
        const QImage picture = bench.picture();
        const auto pixel = [&](double x, double y) {
            return QPointF(bench.plot->xAxis->coordToPixel(x), bench.plot->yAxis->coordToPixel(y));
        };
        // Between the horizontal lines at 0, 10, 20, 30.
        for (const double x : {0.0, 10.0, 20.0, 30.0, 40.0}) {
            QVERIFY2(hasRealLine(picture, pixel(x + 4.0, 15.0)), qPrintable(QString::number(x)));
            QVERIFY2(!hasRealLine(picture, pixel(x + 2.0, 15.0)), qPrintable(QString::number(x)));
            QVERIFY2(!hasRealLine(picture, pixel(x, 15.0)), qPrintable(QString::number(x)));
        }
    }

    void errorsAreMovedByTheFactorInTheUnitOfTheGrid()
    {
        const auto data = errorsOf(
            5, 4, [](double x, double) { return static_cast<float>(x / 10.0); },
            [](double, double y) { return static_cast<float>(-y / 5.0); });
        const ErrorPlane plane{
            {ErrorPlane::Table(data, &data->tables[0]), ErrorPlane::Table(data, &data->tables[1])},
            {0.001, 0.001}};
        QCOMPARE(plane.at(4, 3, 1.0).x, 40.0 + 0.004);
        QCOMPARE(plane.at(4, 3, 1.0).y, 30.0 - 0.006);
        QCOMPARE(plane.at(4, 3, 500.0).x, 40.0 + 2.0);
        // Between points as the drive interpolates, beyond them held.
        QCOMPARE(plane.at({20.0, 15.0}, 1000.0).x, 20.0 + 2.0);
        QCOMPARE(plane.at({20.0, 45.0}, 1000.0).y, 45.0 - 6.0);
        QCOMPARE(plane.largest(1), 0.006);
        // A tenth of 30 for 0.006: 500; along X, 4 for 0.004: 1000.
        QVERIFY(std::abs(fittingExaggeration(plane) / 500.0 - 1.0) < 1e-6);
    }

    void aMillimetreIsAsLongOnBothAxes()
    {
        Fixture bench(errorsOf(5, 4, four, none));
        const auto pixels = [](const QCPAxis& axis) {
            return std::abs(axis.coordToPixel(1.0) - axis.coordToPixel(0.0));
        };
        static_cast<void>(bench.picture());
        QVERIFY(std::abs(pixels(*bench.plot->xAxis) / pixels(*bench.plot->yAxis) - 1.0) < 0.02);
        bench.view.resize(420, 520);
        static_cast<void>(bench.picture());
        static_cast<void>(bench.picture());
        QVERIFY(std::abs(pixels(*bench.plot->xAxis) / pixels(*bench.plot->yAxis) - 1.0) < 0.02);
        QVERIFY(bench.plot->xAxis->range().contains(0.0));
        QVERIFY(bench.plot->xAxis->range().contains(40.0));
    }

    void theFactorIsSaidAndChangedByKeys()
    {
        Fixture bench(errorsOf(5, 4, five, none)); // 4 for 0.005: 800
        QCOMPARE(bench.view.exaggeration(), 500.0);
        const auto note = [&] {
            return bench.view.findChild<QLabel*>(QStringLiteral("vectorNote"))->text();
        };
        QVERIFY2(note().contains(QStringLiteral("× 500")), qPrintable(note()));
        const QImage before = bench.picture();
        bench.press(Qt::Key_Plus);
        QCOMPARE(bench.view.exaggeration(), 1000.0);
        QVERIFY(note().contains(QStringLiteral("× 1")));
        QVERIFY(bench.picture() != before);
        bench.press(Qt::Key_Home);
        QCOMPARE(bench.view.exaggeration(), 500.0);
        QVERIFY(bench.picture() == before);
    }

    void keysAndMouseMoveZoomAndGoBack()
    {
        Fixture bench(errorsOf(12, 9, four, none));
        const QImage whole = bench.picture();
        for (const Qt::Key key : {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down,
                 Qt::Key_PageUp, Qt::Key_PageDown}) {
            bench.press(key);
            QVERIFY(bench.picture() != whole);
            QTest::mouseDClick(bench.plot, Qt::LeftButton, {}, bench.plot->rect().center());
            QVERIFY(bench.picture() == whole);
        }
        const QPoint centre = bench.plot->axisRect()->center();
        QWheelEvent wheel(centre, bench.plot->mapToGlobal(centre), {}, {0, 120}, Qt::NoButton,
            Qt::NoModifier, Qt::NoScrollPhase, false);
        const double range = bench.plot->xAxis->range().size();
        QCoreApplication::sendEvent(bench.plot, &wheel);
        QVERIFY(bench.plot->xAxis->range().size() < range);
    }

    void whichColumnsAreDrawnIsSeenAndCanBeChanged()
    {
        auto data = std::make_shared<CalibrationData>(*errorsOf(5, 4, four, none));
        data->tables.push_back(data->tables[1]);
        data->tables.back().name = "Y error, second run";
        data->tables.back().values.assign(20, 7.0F);
        Fixture bench(data);
        QCOMPARE(bench.box("vectorColumn1").currentText(), QStringLiteral("X error"));
        QCOMPARE(bench.box("vectorColumn2").count(), 2);
        QCOMPARE(bench.box("vectorColumn2").currentText(), QStringLiteral("Y error"));
        const QImage first = bench.picture();
        bench.box("vectorColumn2").setCurrentIndex(1);
        Q_EMIT bench.box("vectorColumn2").activated(1);
        QVERIFY(bench.picture() != first);
    }

    void theAxisIsMarked()
    {
        Fixture bench(errorsOf(5, 4, four, none));
        const QImage plain = bench.picture();
        bench.view.setMarker(std::array{12.0, 17.0, 0.0});
        QVERIFY(bench.picture() != plain);
        bench.view.setMarker(std::nullopt);
        QVERIFY(bench.picture() == plain);
    }

    void ofAVolumeTheSliceThatIsShown()
    {
        Fixture bench(volume());
        bench.shown.setTables(test::sharedTable({6, 5, 4}), nullptr);
        const QImage first = bench.picture();
        bench.shown.setSlice(3, 0);
        QVERIFY(bench.picture() != first);
        QCOMPARE(bench.box("vectorColumn2").currentText(), QStringLiteral("Y error"));
        bench.shown.setSlice(2, 1);
        QCOMPARE(bench.box("vectorColumn2").currentText(), QStringLiteral("Z error"));
        QCOMPARE(bench.plot->yAxis->label(), QStringLiteral("Z [mm]"));
    }

    void linesOfALargeGridAreFewAndAlwaysTheSame()
    {
        const GridAxis axis{"X", "mm", 0.0, 0.25, 724};
        const DrawnLines all = drawnLines(axis, -10.0, 200.0, 24);
        QCOMPARE(all.step, std::size_t{50});
        QCOMPARE(all.lines[1], std::size_t{50});
        QCOMPARE(all.lines.back(), std::size_t{723});
        const DrawnLines part = drawnLines(axis, 20.1, 40.0, 24);
        QCOMPARE(part.step, std::size_t{5});
        QCOMPARE(part.lines.front() % 5, std::size_t{0});
        QVERIFY(axis.position(part.lines.front()) <= 20.1);
        QVERIFY(axis.position(part.lines.back()) >= 40.0);
        QCOMPARE(drawnLines({"X", "mm", 0.0, 1.0, 5}, 0.0, 4.0, 24).lines.size(), std::size_t{5});
    }

    void itIsSavedOnWhite()
    {
        const QTemporaryDir folder;
        Fixture bench(errorsOf(5, 4, four, none));
        bench.view.setPalette(test::darkPalette());
        const QString path = folder.filePath(QStringLiteral("vectors.png"));
        const auto saved = bench.view.exportTo(path);
        QTRY_VERIFY_WITH_TIMEOUT(saved.isFinished(), test::patienceMs);
        QCOMPARE(saved.result(), QString());
        const QImage image(path);
        QCOMPARE(image.size(), QSize(2000, 1300));
        QCOMPARE(image.pixelColor(3, 3), QColor(Qt::white));
        QVERIFY(image.text(QStringLiteral("Title")).startsWith(QStringLiteral("X error and Y")));
        // The window is dark as before.
        QCOMPARE(bench.picture().pixelColor(1, 1), test::darkPalette().base().color());
    }
};

AXISCOMP_WINDOW_TEST(TestVectorView)

} // namespace tst_vectorview

#include "tst_vectorview.moc"
