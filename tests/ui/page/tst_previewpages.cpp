// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/page_states.h"
#include "tests/ui/support/window_test.h"
#include "ui/plot/vector_view.h"

#include <QLabel>
#include <QListView>
#include <QTabBar>
#include <QTest>

#include "ui/drawing/custom_plot.h"

namespace tst_previewpages {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::PageFixture;
using test::PageUser;

namespace {

QStringList tabsOf(PageFixture& bench)
{
    const auto& tabs = bench.user.the<QTabWidget>("previewTabs");
    QStringList texts;
    for (int n = 0; n < tabs.count(); ++n)
        texts += tabs.tabText(n);
    return texts;
}

QByteArray planeErrors(const char* columns)
{
    QByteArray text = QByteArray("X [mm],Y [mm],") + columns + '\n';
    for (int y = 0; y <= 30; y += 10)
        for (int x = 0; x <= 40; x += 10)
            text += QByteArray::number(x) + ',' + QByteArray::number(y) + ",0.00"
                + QByteArray::number(x / 10) + ",-0.00" + QByteArray::number(y / 10) + '\n';
    return text;
}

bool opens(PageFixture& bench, const QByteArray& content)
{
    bench.picked = bench.file(QStringLiteral("plane.csv"), content);
    return bench.user.click("openButton") && PageUser::waitFor([&] {
        const DataFile& file = bench.controller().dataFile();
        return !file.isReading && file.path == bench.picked;
    });
}

drivecomm::VirtualDriveOptions withTravel()
{
    auto options = PageFixture::twoAxes();
    for (drivecomm::VirtualAxis& axis : options.axes)
        axis.saysTravel = true;
    return options;
}

} // namespace

/// The pages of the preview beside the problems: which of them there are.
class TestPreviewPages : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnWindowWarnings();
        QLocale::setDefault(QLocale::c());
    }

    void theErrorsOfTwoSourcesHaveAPage()
    {
        PageFixture bench;
        QVERIFY(bench.open() && bench.choose2D());
        QVERIFY(!tabsOf(bench).contains(QStringLiteral("Two axes")));
        QVERIFY(opens(bench, planeErrors("X error [mm],Y error [mm]")));
        QTRY_COMPARE_WITH_TIMEOUT(tabsOf(bench),
            (QStringList{QStringLiteral("Picture"), QStringLiteral("Values"),
                QStringLiteral("Surface"), QStringLiteral("Two axes")}),
            test::patienceMs);
        // The other column is of no source.
        QVERIFY(opens(bench, planeErrors("X error [mm],Z error [mm]")));
        QTRY_VERIFY_WITH_TIMEOUT(
            !tabsOf(bench).contains(QStringLiteral("Two axes")), test::patienceMs);
    }

    void aVolumeHasAllSlicesOnAPageAndOneIsChosenThere()
    {
        PageFixture bench;
        QVERIFY(test::page_states::threeDimensions(bench));
        QTRY_COMPARE_WITH_TIMEOUT(tabsOf(bench),
            (QStringList{QStringLiteral("Picture"), QStringLiteral("Values"),
                QStringLiteral("Surface"), QStringLiteral("All slices")}),
            test::patienceMs);
        auto& tabs = bench.user.the<QTabWidget>("previewTabs");
        tabs.setCurrentIndex(3);
        auto& list = bench.user.the<QListView>("sliceGalleryView");
        list.setCurrentIndex(list.model()->index(0, 0));
        QTest::keyClick(&list, Qt::Key_Return);
        QCOMPARE(tabs.tabText(tabs.currentIndex()), QStringLiteral("Picture"));
        QCOMPARE(bench.user.the<QSlider>("sliceIndex").value(), 0);
        QVERIFY(bench.choose2D());
        QTRY_VERIFY_WITH_TIMEOUT(
            !tabsOf(bench).contains(QStringLiteral("All slices")), test::patienceMs);
    }

    void anAxisWithoutATableHasNoSurface()
    {
        PageFixture bench;
        QVERIFY(bench.openWritten());
        QTRY_VERIFY_WITH_TIMEOUT(
            tabsOf(bench).contains(QStringLiteral("Surface")), test::patienceMs);
        QVERIFY(bench.user.choose("axisField", QStringLiteral("Y · ")));
        // The file is read for the other axis meanwhile, and may have a page for its problems.
        QTRY_VERIFY_WITH_TIMEOUT(
            !tabsOf(bench).contains(QStringLiteral("Surface")), test::patienceMs);
    }

    void theTravelOfTheSourcesIsInThePicture()
    {
        PageFixture bench(withTravel());
        QVERIFY(bench.open() && bench.choose2D()); // a table over all of the travel
        QVERIFY(opens(bench, "X [mm],Y [mm],first\n10,10,0\n20,10,0\n10,20,1\n20,20,0\n"));
        const auto& plot = bench.user.the<QCustomPlot>("plotCanvas");
        QTRY_VERIFY_WITH_TIMEOUT(
            plot.yAxis->range().contains(0.0) && plot.yAxis->range().contains(30.0),
            test::patienceMs);
        QVERIFY(plot.xAxis->range().contains(0.0));
        // At most as far beyond the table as it is long itself.
        QVERIFY(plot.xAxis->range().upper < 31.0);
    }
};

AXISCOMP_WINDOW_TEST(TestPreviewPages)

} // namespace tst_previewpages

#include "tst_previewpages.moc"
