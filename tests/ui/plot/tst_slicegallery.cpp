// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/table_math.h"
#include "tests/ui/support/table_samples.h"
#include "tests/ui/support/window_test.h"
#include "ui/drawing/table_map.h"
#include "ui/plot/slice_gallery.h"

#include <QLabel>
#include <QListView>
#include <QSignalSpy>
#include <QTest>

namespace tst_slicegallery {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::sharedTable;

namespace {

struct Fixture {
    explicit Fixture(TableViewModel::Table table)
    {
        shown.setTables(std::move(table), nullptr);
        gallery.resize(700, 420);
        list = gallery.findChild<QListView*>(QStringLiteral("sliceGalleryView"));
    }
    [[nodiscard]] QString textOf(int row) const
    {
        return list->model()->index(row, 0).data().toString();
    }
    [[nodiscard]] QImage pictureOf(int row) const
    {
        const auto icon = list->model()->index(row, 0).data(Qt::DecorationRole).value<QIcon>();
        return icon.pixmap(list->iconSize(), QIcon::Selected).toImage();
    }
    [[nodiscard]] bool hasPictures() const
    {
        return QTest::qWaitFor(
            [this] { return pictureOf(0).pixelColor(0, 0).alpha() == 255; }, test::patienceMs);
    }

    TableViewModel shown;
    SliceGallery gallery{shown};
    QListView* list = nullptr;
};

} // namespace

class TestSliceGallery : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnWindowWarnings();
        QLocale::setDefault(QLocale::c());
    }

    void everySliceHasItsPlace()
    {
        Fixture bench(sharedTable({6, 5, 4}));
        QCOMPARE(bench.list->model()->rowCount(), 4);
        QCOMPARE(bench.textOf(1), QStringLiteral("Z 202.5 mm"));
        QCOMPARE(bench.textOf(2), QStringLiteral("Z 205.0 mm"));
        bench.shown.setSlice(1, 0);
        QCOMPARE(bench.list->model()->rowCount(), 6);
        QCOMPARE(bench.textOf(5), QStringLiteral("X 12.5 mm"));
        bench.shown.setTables(sharedTable({6, 5}), nullptr);
        QCOMPARE(bench.list->model()->rowCount(), 0);
    }

    void allSlicesShareOneScaleOfColours()
    {
        CompensationTable table = test::namedTable({3, 3, 3});
        for (std::size_t i = 0; i < table.values.size(); ++i)
            table.values[i] = 0.001F * static_cast<float>(i / 9 + 1);
        Fixture bench(std::make_shared<const CompensationTable>(table));
        bench.gallery.show();
        QVERIFY(bench.hasPictures());
        QCPColorGradient gradient = divergingGradient(false);
        for (int n = 0; n < 3; ++n) {
            const QImage picture = bench.pictureOf(n);
            const QColor wanted = gradient.color((n + 1) / 3.0, QCPRange(-1.0, 1.0));
            const QColor found = picture.pixelColor(picture.rect().center());
            QVERIFY2(std::abs(wanted.red() - found.red()) <= 2
                    && std::abs(wanted.blue() - found.blue()) <= 2,
                qPrintable(wanted.name() + u' ' + found.name()));
        }
        QCOMPARE(bench.gallery.findChild<QLabel*>(QStringLiteral("galleryNote"))->text(),
            QStringLiteral("colours from -3 µm to +3 µm"));
    }

    void aClickOrEnterChoosesTheSlice()
    {
        Fixture bench(sharedTable({6, 5, 4}));
        bench.gallery.show();
        bench.gallery.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&bench.gallery, test::patienceMs));
        const QSignalSpy chosen(&bench.gallery, &SliceGallery::chosen);
        const auto placeOf = [&](int row) {
            return bench.list->visualRect(bench.list->model()->index(row, 0)).center();
        };
        QTest::mouseClick(bench.list->viewport(), Qt::LeftButton, {}, placeOf(3));
        QCOMPARE(bench.shown.sliceIndex(), 3);
        QCOMPARE(chosen.count(), 1);
        QCOMPARE(bench.list->currentIndex().row(), 3);
        bench.list->setFocus();
        QTest::keyClick(bench.list, Qt::Key_Left);
        QCOMPARE(bench.shown.sliceIndex(), 3);
        QTest::keyClick(bench.list, Qt::Key_Return);
        QCOMPARE(bench.shown.sliceIndex(), 2);
        QCOMPARE(chosen.count(), 2);
    }

    void moreSlicesThanCanBeLookedThroughAreLeftOutEvenly()
    {
        QCOMPARE(picturedSlices(2), (std::vector<int>{0, 1}));
        QCOMPARE(picturedSlices(240).size(), std::size_t{240});
        const std::vector<int> some = picturedSlices(1000);
        QVERIFY(some.size() <= 240);
        QCOMPARE(some.front(), 0);
        QCOMPARE(some[1], 5);
        QCOMPARE(some.back(), 999);
    }
};

AXISCOMP_WINDOW_TEST(TestSliceGallery)

} // namespace tst_slicegallery

#include "tst_slicegallery.moc"
