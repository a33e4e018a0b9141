// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/page_fixture.h"
#include "tests/ui/support/window_test.h"
#include "ui/drawing/custom_plot.h"
#include "ui/style/contrast.h"

#include <QCheckBox>
#include <QTableView>
#include <QTableWidget>
#include <QTest>

#include <cmath>
#include <functional>
#include <utility>

namespace tst_writepreview {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::PageFixture;

namespace {

QStringList textsOf(const QWidget& widget, const char* name)
{
    QStringList texts;
    for (const QLabel* label : widget.findChildren<QLabel*>(QLatin1StringView(name)))
        texts += label->text();
    return texts;
}

/// The largest value of PageFixture::superData, as the page says it but for the sign: two of its
/// values are equally large.
QString largestOf(double factor)
{
    double largest = 0.0;
    for (int y = 0; y <= 30; y += 5)
        for (int x = 0; x <= 40; x += 4) {
            // The file has seven decimals.
            const double value = std::round(0.002 * std::sin(x / 6.0 + y / 9.0 + 1) * 1e7) / 1e7;
            largest = std::max(largest, std::abs(factor * value));
        }
    return QStringLiteral("%1 µm at").arg(largest * 1000.0, 0, 'f', 3);
}

QString lineOf(PageFixture& bench, const char* picture)
{
    return textsOf(bench.user.the(picture), "thumbnailLine").value(0);
}

bool plan(PageFixture& bench)
{
    return bench.user.click("writeButton")
        && test::PageUser::waitFor([&] { return bench.user.sees("pictureAfter"); });
}

/// Does something, once, when a widget gets the keyboard.
class TakesWhenFocused : public QObject {
public:
    TakesWhenFocused(QWidget& widget, std::function<void()> take) : m_take(std::move(take))
    {
        widget.installEventFilter(this);
    }
    bool eventFilter(QObject*, QEvent* event) override
    {
        if (event->type() == QEvent::FocusIn && m_take)
            std::exchange(m_take, nullptr)();
        return false;
    }

private:
    std::function<void()> m_take;
};

} // namespace

/// The list of what a write will change: what it warns of, and what it shows.
class TestWritePreview : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void aWarningHasItsSymbolAndColourAndARemarkHasNot()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        QVERIFY(bench.choose2D());
        user.the<QCheckBox>("skipPreviewForVolatile").setChecked(true);
        QVERIFY(user.click("persistencyField"));
        QVERIFY(bench.write());
        // A volatile table over a persistent one, in other units than the axis has.
        bench.picked = bench.file(QStringLiteral("um.csv"),
            "X [mm],Y [mm],height [um]\n0,0,0\n40,0,2\n0,30,1\n40,30,0\n");
        QVERIFY(user.click("openButton"));
        QTRY_VERIFY(bench.controller().dataFile().path == bench.picked);
        QVERIFY(user.choose("tableField", QStringLiteral("height")));
        QVERIFY(user.click("persistencyField"));
        QVERIFY(plan(bench));
        const QWidget& warnings = user.the("previewWarnings");
        QVERIFY(warnings.isVisible());
        const QStringList said = textsOf(warnings, "warningText");
        QCOMPARE(said.size(), 1);
        QVERIFY2(said.front().startsWith(QStringLiteral("The new table is volatile: after a")),
            qPrintable(said.front()));
        for (const QLabel* symbol : warnings.findChildren<QLabel*>(QStringLiteral("warningSymbol")))
            QVERIFY(!symbol->pixmap().isNull());
        QCOMPARE(warnings.findChildren<QLabel*>(QStringLiteral("warningSymbol")).size(), 1);
        const QImage picture = user.the("previewWarnings").grab().toImage();
        QCOMPARE(picture.pixelColor(4, warnings.height() / 2).rgb(),
            fillColor(Tone::Warning, warnings.palette()).rgb());
        const QString remarks = user.the<QLabel>("previewRemarks").text();
        QVERIFY2(remarks.contains(QStringLiteral("converted from um to mm")), qPrintable(remarks));
        QVERIFY(!remarks.contains(said.front()));
        QVERIFY(!user.sees("skipPreviewForVolatile"));
        QVERIFY2(
            user.the<QLabel>("previewSign").text().contains(QStringLiteral("the drive will add +")),
            qPrintable(user.the<QLabel>("previewSign").text()));
    }

    void theOldTheNewAndTheirDifferenceAreShownWithTheirLargestValues()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        QVERIFY(bench.choose2D());
        QVERIFY(plan(bench));
        QVERIFY(!user.sees("previewWarnings"));
        QVERIFY(!user.sees("pictureBefore"));
        QVERIFY(!user.sees("pictureDifference"));
        QVERIFY2(lineOf(bench, "pictureAfter").contains(largestOf(1.0)),
            qPrintable(lineOf(bench, "pictureAfter")));
        // Both axes of a map are positions.
        const auto* map = user.the("pictureAfter").findChild<QCustomPlot*>();
        QVERIFY(map && map->xAxis->label().isEmpty());
        QCOMPARE(map->yAxis->label(), QString());
        QVERIFY(user.click("confirmWriteButton"));
        QVERIFY(bench.idle());

        QVERIFY(user.choose("tableField", QStringLiteral("second"))); // is - first
        QVERIFY(plan(bench));
        QTRY_VERIFY(user.sees("pictureDifference"));
        QCOMPARE(textsOf(user.the("changePictures"), "thumbnailTitle"),
            QStringList({QStringLiteral("On the drive"), QStringLiteral("New"),
                QStringLiteral("Difference, new − old")}));
        QVERIFY(lineOf(bench, "pictureBefore").contains(largestOf(1.0)));
        QVERIFY(lineOf(bench, "pictureAfter").contains(largestOf(1.0)));
        QVERIFY2(lineOf(bench, "pictureDifference").contains(largestOf(2.0)),
            qPrintable(lineOf(bench, "pictureDifference")));
        // Nothing beside it speaks of another table.
        QVERIFY(!user.sees("signSentence"));
        QVERIFY(!user.sees("tableFacts"));
        user.press(Qt::Key_Escape);
        QTRY_VERIFY(user.sees("signSentence"));
    }

    /// Any of its values may follow any of the old ones.
    void aTableOverAnotherSourceHasNoDifferenceToTheOldOne()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        const auto mayWrite = [&] {
            return test::PageUser::waitFor(
                [&] { return bench.controller().action(Action::Write).isEnabled; });
        };
        bench.picked =
            bench.file(QStringLiteral("x.csv"), "X [mm],E [mm]\n0,0.001\n10,0.003\n20,-0.001\n");
        QVERIFY(user.click("openButton"));
        QVERIFY(user.enter("source1Field", QString::fromStdString(test::masterX)));
        QVERIFY(mayWrite());
        QVERIFY(bench.write());
        bench.picked =
            bench.file(QStringLiteral("y.csv"), "Y [mm],E [mm]\n0,0.001\n10,0.0031\n20,-0.001\n");
        QVERIFY(user.click("openButton"));
        const QAbstractItemModel& values = *user.the<QTableView>("values").model();
        QTRY_COMPARE(values.columnCount(), 4);
        QVERIFY(user.enter("source1Field", QString::fromStdString(test::masterY)));
        QTRY_COMPARE(values.columnCount(), 2);
        QVERIFY(mayWrite());
        QVERIFY(plan(bench));
        QVERIFY(user.sees("pictureBefore"));
        QVERIFY(!user.sees("pictureDifference"));
        const auto& rows = user.the<QTableWidget>("previewRows");
        QTRY_COMPARE(rows.item(1, 2)->text(), QStringLiteral("up to +4.100 µm"));
    }

    /// It takes the focus, and with it what is being typed into a field is taken.
    void aPreviewOfOtherFieldsByNowIsPutAwayWithAWord()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        QVERIFY(bench.choose2D());
        TakesWhenFocused taking(user.the("confirmWriteButton"),
            [&] { bench.controller().setup().setPersistency(Persistency::Persistent); });
        user.press(Qt::Key_Return, Qt::ControlModifier);
        QVERIFY(bench.saysOutcome(QStringLiteral("have changed since the write was planned")));
        QVERIFY(!user.sees("confirmWriteButton"));
        QVERIFY(user.the("writeButton").isEnabled());
        user.press(Qt::Key_Return, Qt::ControlModifier);
        QTRY_VERIFY(user.sees("confirmWriteButton"));
        QCOMPARE(bench.controller().plan()->after.persistency, Persistency::Persistent);
    }

    void whatIsDeletedIsShown()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.openWritten());
        QVERIFY(user.pickFromMenu("activateMenuButton", "activateMenu", Qt::Key_D));
        QTRY_VERIFY(user.sees("pictureBefore"));
        QVERIFY(!user.sees("pictureAfter"));
        QVERIFY(!user.sees("previewSign"));
        QVERIFY(lineOf(bench, "pictureBefore").contains(largestOf(1.0)));
    }

    void ofThreeDimensionsTheMiddleSliceIsShownAndSaid()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        QByteArray text = "X [mm],Y [mm],Z [mm],E [mm]\n";
        for (int z = 0; z <= 40; z += 20)
            for (int y = 0; y <= 30; y += 10)
                for (int x = 0; x <= 40; x += 10)
                    text += QByteArray::number(x) + ',' + QByteArray::number(y) + ','
                        + QByteArray::number(z) + ',' + QByteArray::number(x * z * 1e-6) + '\n';
        bench.picked = bench.file(QStringLiteral("volume.csv"), text);
        QVERIFY(user.choose("dimensionalityField", QStringLiteral("3D")));
        QVERIFY(user.click("openButton"));
        for (const auto& [field, source] : {std::pair("source1Field",
                                                "Axes[0]/Signals/"
                                                "PositionController/"
                                                "MasterPosition"),
                 std::pair("source2Field", "Axes[1]/Signals/PositionController/MasterPosition"),
                 std::pair("source3Field", "Application/Variables/Floats[0]")})
            QVERIFY(user.enter(field, QLatin1StringView(source)));
        QTRY_VERIFY(bench.controller().action(Action::Write).isEnabled);
        QVERIFY(plan(bench));
        QCOMPARE(lineOf(bench, "pictureAfter"),
            QStringLiteral("largest +1.600 µm at X 40, Y 0, Z 40; shown: the middle slice, Z 20"));
    }
};

AXISCOMP_WINDOW_TEST(TestWritePreview)

} // namespace tst_writepreview

#include "tst_writepreview.moc"
