// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/page_fixture.h"
#include "tests/ui/support/window_test.h"
#include "ui/page/message_stack.h"

#include <QScrollBar>
#include <QTest>

namespace tst_pagesize {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::PageFixture;

namespace {

/// Whether all of it is within the window.
bool isInside(PageFixture& bench, const char* name)
{
    const QWidget& widget = bench.user.the(name);
    const QRect place(widget.mapTo(&bench.window, QPoint()), widget.size());
    const bool isInside = widget.isVisible() && bench.window.rect().contains(place);
    if (!isInside)
        qInfo() << name << place << "is not within" << bench.window.rect();
    return isInside;
}

std::vector<QRect> placesOf(PageFixture& bench)
{
    std::vector<QRect> places;
    for (const char* name : {"connectionsButton", "axisField", "dimensionalityField", "openButton",
             "writeButton", "activateButton", "previewTabs", "plotCanvas", "logButton"}) {
        const QWidget& widget = bench.user.the(name);
        places.emplace_back(widget.mapTo(&bench.window, QPoint()), widget.size());
    }
    return places;
}

} // namespace

/// What fits where the screen is small, and what stays where it is.
class TestPageSize : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void everythingCanBeReachedOnASmallScreen_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QSize>("size");
        for (const QSize& size : {QSize(960, 540), QSize(1280, 720), QSize(1366, 768)})
            for (const char* language : {"en", "de", "fr"})
                QTest::addRow("%dx%d %s", size.width(), size.height(), language)
                    << QString::fromLatin1(language) << size;
    }
    void everythingCanBeReachedOnASmallScreen()
    {
        QFETCH(QString, language);
        QFETCH(QSize, size);
        PageFixture bench(PageFixture::twoAxes(), language);
        bench.window.resize(size);
        QVERIFY(bench.open());
        QVERIFY(bench.choose2D());
        QCoreApplication::processEvents();
        QVERIFY2(bench.window.minimumSizeHint().width() < 900,
            qPrintable(QString::number(bench.window.minimumSizeHint().width())));
        QCOMPARE(bench.window.size(), size);
        for (const char* name : {"menuButton", "connectionsButton", "writeButton",
                 "revertAllButton", "activateButton", "deactivateButton", "saveExampleButton",
                 "plotCanvas", "logButton", "compensationState"})
            QVERIFY(isInside(bench, name));

        // The bar is beside the fields and their hints.
        auto& scroll = bench.user.the<QScrollArea>("setupScroll");
        QVERIFY(scroll.widget()->width() <= scroll.viewport()->width());
        for (const char* name : {"axisField", "source1Field", "source1FieldNote", "openButton",
                 "tableFieldNote", "persistencyFieldNote"}) {
            scroll.ensureWidgetVisible(&bench.user.the(name));
            const QWidget& widget = bench.user.the(name);
            const QRect place(widget.mapTo(scroll.viewport(), QPoint()), widget.size());
            QVERIFY2(place.left() >= 0 && place.right() < scroll.viewport()->width(), name);
        }

        QVERIFY(bench.user.click("writeButton"));
        QTRY_VERIFY(bench.user.sees("pictureAfter"));
        QCOMPARE(bench.window.size(), size);
        for (const char* name : {"previewTitle", "backButton", "confirmWriteButton"})
            QVERIFY(isInside(bench, name));
        auto& preview = bench.user.the<QScrollArea>("previewScroll");
        QVERIFY(preview.widget()->width() <= preview.viewport()->width());
    }

    void aMessageMovesNothing()
    {
        PageFixture bench;
        bench.window.resize(1280, 720);
        QVERIFY(bench.open());
        QVERIFY(bench.choose2D());
        QTRY_VERIFY(bench.user.sees("plotCanvas"));
        auto& messages = *bench.wizard.findChild<MessageStack*>();
        const auto before = placesOf(bench);
        Message message;
        message.text = QStringLiteral("Words. ").repeated(40);
        for (const char* id : {"first", "second"}) {
            message.id = QLatin1StringView(id);
            message.buttons = {
                {QLatin1StringView(id) + QStringLiteral("Button"), QStringLiteral("Do"), [] {}}};
            messages.show(message);
            QCoreApplication::processEvents();
            QTRY_VERIFY(bench.user.sees(id));
            QVERIFY(placesOf(bench) == before);
        }
        QVERIFY(bench.user.click("firstButton")); // the older one, which is scrolled to
        QVERIFY(!messages.contains(QStringLiteral("first")));
        QVERIFY(bench.user.click("secondButton"));
        QTRY_VERIFY(!messages.isVisible());
        QVERIFY(placesOf(bench) == before);
    }

    void theButtonsOfALongMessageAreWhole()
    {
        PageFixture bench;
        bench.window.resize(960, 540);
        QVERIFY(bench.open());
        auto& messages = *bench.wizard.findChild<MessageStack*>();
        messages.show({.id = QStringLiteral("long"),
            .text = QStringLiteral("Words. ").repeated(160),
            .buttons = {{QStringLiteral("longButton"), QStringLiteral("Do"), [] {}}}});
        QTRY_VERIFY(bench.user.sees("longButton"));
        const QWidget& button = bench.user.the("longButton");
        QTRY_VERIFY(messages.height() > 2 * messages.heightOfOne());
        QCOMPARE(button.visibleRegion().boundingRect(), button.rect());
    }
};

AXISCOMP_WINDOW_TEST(TestPageSize)

} // namespace tst_pagesize

#include "tst_pagesize.moc"
