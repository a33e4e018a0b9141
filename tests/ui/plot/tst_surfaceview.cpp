// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/table_samples.h"
#include "tests/ui/support/window_test.h"
#include "ui/drawing/surface_axes.h"
#include "ui/drawing/surface_image.h"
#include "ui/drawing/table_map.h"
#include "ui/plot/surface_view.h"

#include <QComboBox>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include <cmath>

namespace tst_surfaceview {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::sharedTable;

namespace {

/// 40 x 30 mm from 0, with values of a closed form.
TableViewModel::Table tableOf(
    std::uint32_t width, std::uint32_t height, double (*value)(double, double))
{
    CompensationTable table;
    table.unit = "mm";
    table.grid.axes = {
        {"X", "mm", 0.0, 40.0 / (width - 1), width}, {"Y", "mm", 0.0, 30.0 / (height - 1), height}};
    for (std::size_t j = 0; j < height; ++j)
        for (std::size_t i = 0; i < width; ++i)
            table.values.push_back(static_cast<float>(
                value(table.grid.axes[0].position(i), table.grid.axes[1].position(j))));
    return std::make_shared<const CompensationTable>(std::move(table));
}

QImage drawn(const SurfaceSight& sight, double range)
{
    return surfaceImage(sight, divergingGradient(false), QCPRange(-range, range), Qt::black, 4096);
}

int difference(const QColor& a, const QColor& b)
{
    return std::max({std::abs(a.red() - b.red()), std::abs(a.green() - b.green()),
        std::abs(a.blue() - b.blue())});
}

QColor colorOf(double value, double range)
{
    QCPColorGradient gradient = divergingGradient(false);
    return gradient.color(value, QCPRange(-range, range));
}

struct Fixture {
    explicit Fixture(TableViewModel::Table table)
    {
        shown.setTables(std::move(table), nullptr);
        view = std::make_unique<SurfaceView>(shown);
        view->resize(640, 480);
        view->show();
    }
    [[nodiscard]] QImage picture() const { return view->grab().toImage(); }
    void press(Qt::Key key) { QTest::keyClick(view.get(), key); }

    TableViewModel shown;
    std::unique_ptr<SurfaceView> view;
};

} // namespace

class TestSurfaceView : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnWindowWarnings();
        QLocale::setDefault(QLocale::c());
    }

    void fromAboveTheSurfaceIsTheMap()
    {
        const auto value = [](double x, double y) { return (x - 10.0) * (y - 20.0); };
        const SurfaceSight sight{
            tableOf(2, 2, value), 0.0, 90.0, 0.01, {-600.0, 300.0}, {640, 480}};
        const QImage image = drawn(sight, 600.0);
        const SurfaceProjection projection(sight);
        for (double x = 1.0; x < 40.0; x += 2.3) {
            for (double y = 1.0; y < 30.0; y += 1.9) {
                const QPointF pixel = projection.pixel(x, y, value(x, y));
                const QColor found =
                    image.pixelColor(static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
                const QColor wanted = colorOf(value(x, y), 600.0);
                QVERIFY2(difference(found, wanted) <= 8,
                    qPrintable(found.name() + u' ' + wanted.name()));
            }
        }
        // X to the right, Y upwards, true to scale.
        const QPointF origin = projection.pixel(0.0, 0.0, 0.0);
        const QPointF across = projection.pixel(40.0, 0.0, 0.0) - origin;
        const QPointF up = projection.pixel(0.0, 30.0, 0.0) - origin;
        QVERIFY(across.x() > 100.0 && std::abs(across.y()) < 1e-6);
        QVERIFY(up.y() < -100.0 && std::abs(up.x()) < 1e-6);
        QVERIFY(std::abs(across.x() / 40.0 + up.y() / 30.0) < 1e-6);
        QCOMPARE(image.pixelColor(2, 2).alpha(), 0);
    }

    void heightsAreExaggeratedByTheFactor_data()
    {
        QTest::addColumn<QString>("unit");
        QTest::addColumn<double>("factor");
        QTest::newRow("same unit") << QStringLiteral("mm") << 1.0;
        QTest::newRow("smaller unit") << QStringLiteral("um") << 0.001;
        QTest::newRow("no unit") << QString() << 1.0;
    }
    void heightsAreExaggeratedByTheFactor()
    {
        QFETCH(QString, unit);
        QFETCH(double, factor);
        CompensationTable table = *tableOf(3, 3, [](double x, double) { return x / 1e4; });
        table.unit = unit.toStdString();
        for (const double exaggeration : {1.0, 1000.0}) {
            const SurfaceSight sight{std::make_shared<const CompensationTable>(table), 0.0, 60.0,
                exaggeration, {0.0, 0.004}, {640, 480}};
            const SurfaceProjection projection(sight);
            const QPointF foot = projection.pixel(0.0, 0.0, 0.0);
            const double perMillimetre = projection.pixel(1.0, 0.0, 0.0).x() - foot.x();
            const double height = foot.y() - projection.pixel(0.0, 0.0, 0.004).y();
            // The eye is 60 degrees above the floor.
            QVERIFY(std::abs(height / (0.004 * factor * exaggeration * 0.5 * perMillimetre) - 1.0)
                < 1e-9);
        }
        // A third of 40 mm for 0.004.
        QVERIFY(
            std::abs(fittingExaggeration(table, {0.0, 0.004}) * factor / (1e4 / 3.0) - 1.0) < 1e-9);
    }

    /// The same place whatever units are written in the file.
    void bothDimensionsAreTrueToScaleInUnlikeUnits()
    {
        CompensationTable table = *tableOf(3, 3, [](double x, double) { return x / 1e4; });
        const SurfaceSight sight{std::make_shared<const CompensationTable>(table), 30.0, 35.0,
            1000.0, {0.0, 0.004}, {640, 480}};
        const QPointF wanted = SurfaceProjection(sight).pixel(40.0, 30.0, 0.004);
        const double fitting = fittingExaggeration(table, {0.0, 0.004});
        const auto look = [&](const char* unit, double perMillimetre, std::size_t axis) {
            CompensationTable other = table;
            other.grid.axes[axis].unit = unit;
            other.grid.axes[axis].distance *= perMillimetre;
            SurfaceSight seen = sight;
            seen.table = std::make_shared<const CompensationTable>(other);
            const QPointF found = SurfaceProjection(seen).pixel(
                other.grid.axes[0].last(), other.grid.axes[1].last(), 0.004);
            const QPointF off = found - wanted;
            return hasOneScale(other) && std::hypot(off.x(), off.y()) < 1e-6
                && std::abs(fittingExaggeration(other, {0.0, 0.004}) / fitting - 1.0) < 1e-9;
        };
        for (const std::size_t axis : {0, 1}) {
            QVERIFY(look("m", 0.001, axis));
            QVERIFY(look("cm", 0.1, axis));
            QVERIFY(look("um", 1000.0, axis));
            QVERIFY(look("", 1.0, axis));
        }
    }

    void lengthsAndAnglesHaveNoScaleInCommon()
    {
        CompensationTable table = *tableOf(3, 3, [](double x, double) { return x / 1e4; });
        table.grid.axes[1].unit = "deg";
        table.grid.axes[1].distance = 180.0; // to 360
        QVERIFY(!hasOneScale(table));
        const SurfaceSight sight{std::make_shared<const CompensationTable>(table), 0.0, 90.0, 1.0,
            {0.0, 0.004}, {640, 480}};
        const SurfaceProjection projection(sight);
        const QPointF origin = projection.pixel(0.0, 0.0, 0.0);
        const double across = projection.pixel(40.0, 0.0, 0.0).x() - origin.x();
        const double up = origin.y() - projection.pixel(0.0, 360.0, 0.0).y();
        QVERIFY(across > 100.0 && std::abs(across - up) < 1e-6);
        Fixture bench(std::make_shared<const CompensationTable>(table));
        auto* box = bench.view->findChild<QComboBox*>(QStringLiteral("surfaceExaggeration"));
        QVERIFY(!box->isEnabled());
        const double factor = bench.view->exaggeration();
        bench.press(Qt::Key_Plus);
        QCOMPARE(bench.view->exaggeration(), factor);
        bench.shown.setTables(sharedTable({12, 9}), nullptr);
        QVERIFY(box->isEnabled());
        table.grid.axes[1].unit = "mm";
        table.unit = "deg";
        QVERIFY(!hasOneScale(table));
    }

    void whatIsNearHidesWhatIsFar()
    {
        // A roof along X whose ridge is at Y = 15.
        const auto roof = [](double, double y) { return 15.0 - std::abs(y - 15.0); };
        SurfaceSight sight{tableOf(31, 31, roof), 0.0, 20.0, 1.0, {0.0, 15.0}, {640, 480}};
        const auto seenAt = [&](double x, double y) {
            const QPointF pixel = SurfaceProjection(sight).pixel(x, y, roof(x, y));
            return drawn(sight, 15.0)
                .pixelColor(static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
        };
        // Between the grid's lines; the far side of the roof is steeper than the eye's way.
        const QColor own = colorOf(roof(0.0, 23.5), 15.0);
        QVERIFY(difference(seenAt(20.5, 23.5), own) > 30);
        sight.turn = 180.0;
        QVERIFY(difference(seenAt(20.5, 23.5), own) <= 10);
    }

    void keysAndMouseTurnItAndHomeGoesBack()
    {
        Fixture bench(sharedTable({12, 9}));
        QTRY_VERIFY_WITH_TIMEOUT(bench.view->isWhole(), test::patienceMs);
        const QImage first = bench.picture();
        for (const Qt::Key key : {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down}) {
            bench.press(key);
            QVERIFY(!bench.view->isWhole());
            QVERIFY(bench.picture() != first);
            bench.press(Qt::Key_Home);
        }
        QTRY_VERIFY_WITH_TIMEOUT(bench.view->isWhole(), test::patienceMs);
        QVERIFY(bench.picture() == first);
        const QPoint centre = bench.view->rect().center();
        QTest::mousePress(bench.view.get(), Qt::LeftButton, {}, centre);
        QTest::mouseMove(bench.view.get(), centre + QPoint(50, 20));
        QTest::mouseRelease(bench.view.get(), Qt::LeftButton, {}, centre + QPoint(50, 20));
        QVERIFY(bench.picture() != first);
        QTest::mouseClick(
            bench.view->findChild<QToolButton*>(QStringLiteral("surfaceReset")), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(bench.view->isWhole(), test::patienceMs);
        bench.view->setFocus();
        QVERIFY(bench.view->exaggeration() > 0.0);
    }

    void theExaggerationIsRoundAndCanBeChosen()
    {
        Fixture bench(tableOf(3, 3, [](double x, double) { return x / 1e4; }));
        QCOMPARE(bench.view->exaggeration(), 2000.0);
        bench.press(Qt::Key_Plus);
        QCOMPARE(bench.view->exaggeration(), 5000.0);
        bench.press(Qt::Key_Minus);
        bench.press(Qt::Key_Minus);
        QCOMPARE(bench.view->exaggeration(), 1000.0);
        auto* box = bench.view->findChild<QComboBox*>(QStringLiteral("surfaceExaggeration"));
        QCOMPARE(box->currentText(), QStringLiteral("× 1000"));
        box->setCurrentIndex(0);
        QCOMPARE(bench.view->exaggeration(), 2000.0);
    }

    void theEndsOfEachAxisHaveANumber()
    {
        QCOMPARE(
            ticksWithEnds(0.0, 40.0, 0.12), (std::vector<double>{0.0, 10.0, 20.0, 30.0, 40.0}));
        // What would touch the number at an end is left out.
        QCOMPARE(
            ticksWithEnds(1.0, 40.5, 0.12), (std::vector<double>{1.0, 10.0, 20.0, 30.0, 40.5}));
        QCOMPARE(
            ticksWithEnds(9.0, 31.0, 0.12), (std::vector<double>{9.0, 15.0, 20.0, 25.0, 31.0}));
        QCOMPARE(ticksWithEnds(-3.1, 3.1, 0.12), (std::vector<double>{-3.1, -2.0, 0.0, 2.0, 3.1}));
    }

    void wheelAndKeysZoomAndADoubleClickGoesBack()
    {
        Fixture bench(sharedTable({12, 9}));
        QTRY_VERIFY_WITH_TIMEOUT(bench.view->isWhole(), test::patienceMs);
        const QImage first = bench.picture();
        const QPoint centre = bench.view->rect().center();
        QWheelEvent wheel(centre, bench.view->mapToGlobal(centre), {}, {0, 120}, Qt::NoButton,
            Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(bench.view.get(), &wheel);
        QVERIFY(bench.picture() != first);
        bench.press(Qt::Key_PageUp);
        QTest::mouseDClick(bench.view.get(), Qt::LeftButton, {}, centre);
        QTRY_VERIFY_WITH_TIMEOUT(bench.view->isWhole(), test::patienceMs);
        QVERIFY(bench.picture() == first);
    }

    void itIsSavedOnWhiteWithItsOrigin()
    {
        const QTemporaryDir folder;
        Fixture bench(sharedTable({12, 9}));
        bench.view->setPalette(test::darkPalette());
        bench.view->setOrigin(
            {QStringLiteral("Gantry"), QStringLiteral("X"), QStringLiteral("grid.csv")});
        for (const char* name : {"surface.png", "surface.svg", "surface.pdf"}) {
            const auto saved = bench.view->exportTo(folder.filePath(QLatin1StringView(name)));
            QTRY_VERIFY_WITH_TIMEOUT(saved.isFinished(), test::patienceMs);
            QCOMPARE(saved.result(), QString());
        }
        const QImage image(folder.filePath(QStringLiteral("surface.png")));
        QCOMPARE(image.pixelColor(3, 3), QColor(Qt::white));
        QVERIFY(image.text(QStringLiteral("Description")).contains(QStringLiteral("grid.csv")));
        // The surface itself, not its axes alone.
        int colored = 0;
        for (int x = 600; x < 1400; ++x)
            colored += image.pixelColor(x, 700).saturation() > 20 ? 1 : 0;
        QVERIFY2(colored > 300, qPrintable(QString::number(colored)));
        const auto refused = bench.view->exportTo(folder.filePath(QStringLiteral("surface.csv")));
        QTRY_VERIFY_WITH_TIMEOUT(refused.isFinished(), test::patienceMs);
        QVERIFY(refused.result().contains(QStringLiteral(".png, .svg or .pdf")));
    }

    void theLargestTableIsWholeAfterTheTurn()
    {
        Fixture bench(sharedTable({724, 724}));
        QTRY_VERIFY_WITH_TIMEOUT(bench.view->isWhole(), test::patienceMs);
        bench.press(Qt::Key_Left);
        QVERIFY(!bench.view->isWhole());
        static_cast<void>(bench.picture());
        QVERIFY(!bench.view->isWhole());
        QTRY_VERIFY_WITH_TIMEOUT(bench.view->isWhole(), test::patienceMs);
    }

    void theAxisAndThePointAreMarked()
    {
        Fixture bench(sharedTable({12, 9, 4}));
        QTRY_VERIFY_WITH_TIMEOUT(bench.view->isWhole(), test::patienceMs);
        const QImage plain = bench.picture();
        bench.view->setMarker(TablePlot::Marker{{10.0, 105.0, 202.0}, 0.001});
        QVERIFY(bench.picture() != plain);
        bench.view->setMarker(std::nullopt);
        QVERIFY(bench.picture() == plain);
        bench.shown.setCurrent(GridPoint{2, 3});
        QVERIFY(bench.picture() != plain);
    }

    void aCurveHasNoSurface()
    {
        Fixture bench(sharedTable({9}));
        const QColor base = bench.view->palette().base().color();
        QCOMPARE(bench.picture().pixelColor(bench.view->rect().center()), base);
        bench.press(Qt::Key_Left);
        bench.press(Qt::Key_Plus);
        bench.shown.setTables(nullptr, nullptr);
        QCOMPARE(bench.picture().pixelColor(bench.view->rect().center()), base);
    }
};

AXISCOMP_WINDOW_TEST(TestSurfaceView)

} // namespace tst_surfaceview

#include "tst_surfaceview.moc"
