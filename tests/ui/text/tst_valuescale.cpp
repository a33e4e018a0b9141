// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/window_test.h"
#include "ui/drawing/local_plot.h"
#include "ui/text/value_scale.h"
#include "ui/text/value_text.h"

#include <QCoreApplication>
#include <QEvent>
#include <QLocale>
#include <QTest>

#include <vector>

namespace tst_valuescale {

using namespace axiscomp::ui;

class TestValueScale : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        axiscomp::test::failOnWindowWarnings();
        QLocale::setDefault(QLocale::c());
    }

    void theUnitSuitsTheLargestValue_data()
    {
        QTest::addColumn<QString>("unit");
        QTest::addColumn<float>("largest");
        QTest::addColumn<QString>("shown");
        const auto row = [](const char* unit, float largest, const char* shown) {
            QTest::addRow("%g %s", static_cast<double>(largest), unit)
                << QString::fromUtf8(unit) << largest << QString::fromUtf8(shown);
        };
        row("mm", 0.0021F, "+2.1 µm");
        row("mm", -0.5F, "-500 µm");
        row("mm", 1.5F, "+1.5 mm");
        row("mm", 0.000004F, "+4 nm");
        row("m", 0.0000125F, "+12.5 µm");
        row("um", 3.25F, "+3.25 µm");
        row("µm", 2000.0F, "+2 mm");
        row("deg", 0.0015F, "+1.5 m°");
        row("rad", 0.000002F, "+2 µrad");
        row("arcsec", 2.5F, "+2.5 arcsec");
        row("counts", 12.0F, "+12 counts");
        row("", 0.125F, "+0.125");
    }
    void theUnitSuitsTheLargestValue()
    {
        QFETCH(QString, unit);
        QFETCH(float, largest);
        QFETCH(QString, shown);
        const std::vector<float> values{0.0F, largest, largest / 2.0F};
        const std::vector<float> alone{largest};
        QCOMPARE(ValueScale(unit.toStdString(), alone).textWithUnit(double(largest)), shown);
        QCOMPARE(ValueScale(unit.toStdString(), values).unit(),
            ValueScale(unit.toStdString(), alone).unit());
    }

    void decimalsStandBelowEachOther()
    {
        const std::vector<float> values{0.0021F, 0.0F, -0.00325F, 0.0005F};
        const ValueScale scale("mm", values);
        QStringList texts;
        for (const float value : values)
            texts += scale.text(double(value));
        QCOMPARE(texts,
            (QStringList{QStringLiteral("+2.10"), QStringLiteral("0.00"), QStringLiteral("-3.25"),
                QStringLiteral("+0.50")}));
    }

    void whatFloat32AddsIsNotSeen()
    {
        // 0.00327 as the difference of two numbers near 1 is 0.00327003...
        const std::vector<float> values{1.00327F - 1.0F + 0.0000003F, 0.0032700002F};
        QCOMPARE(ValueScale("mm", {values.data() + 1, 1}).textWithUnit(double(values[1])),
            QStringLiteral("+3.27 µm"));
        // With the noise of such a difference known, it is as if it were not there.
        QCOMPARE(ValueScale("mm", values, 2e-7).textWithUnit(double(values[0])),
            QStringLiteral("+3.27 µm"));
        const std::vector<float> nothing{2e-11F, -1e-11F};
        QCOMPARE(ValueScale("mm", nothing, 1e-9).text(double(nothing[0])), QStringLiteral("0"));
        QCOMPARE(ValueScale("mm", nothing, 1e-9).text(double(nothing[1])), QStringLiteral("0"));
    }

    void neverMoreThanFiveDigitsOfTheLargest()
    {
        const std::vector<float> values{0.0012345678F, 0.00000012345F};
        const ValueScale scale("mm", values);
        QCOMPARE(scale.text(double(values[0])), QStringLiteral("+1.2346"));
        QCOMPARE(scale.text(double(values[1])), QStringLiteral("+0.0001"));
        QCOMPARE(scale.text(-0.00000001), QStringLiteral("0.0000"));
    }

    void aSizeThatTheDriveDoesNotShowHasNoLastPosition()
    {
        axiscomp::Grid grid;
        grid.axes.push_back(
            {.name = "X", .unit = "mm", .start = -10.0, .distance = 5.0, .size = 3});
        QVERIFY(gridText(grid).startsWith(u"3 ") && gridText(grid).endsWith(u" -10 … 0"));
        grid.axes[0].size = 0;
        QVERIFY(gridText(grid).startsWith(u"- ") && gridText(grid).endsWith(u" -10 … -"));
    }

    void numbersAreInTheWordsOfTheLocale()
    {
        QLocale::setDefault(QLocale(QLocale::German));
        const std::vector<float> values{0.0021F};
        QCOMPARE(
            ValueScale("mm", values).textWithUnit(double(values[0])), QStringLiteral("+2,1 µm"));
        // Other programs get a decimal point, and every digit.
        QCOMPARE(ValueScale("mm", values).plain(0.0012345678F), QByteArray("1.2345678"));
        QCOMPARE(ValueScale("mm", values).plain(-0.0021F), QByteArray("-2.1"));
    }

    void aPlotFollowsTheLanguage()
    {
        LocalPlot plot;
        const auto labels = [&plot] {
            plot.xAxis->setRange(0.1, 0.9);
            plot.replot(QCustomPlot::rpImmediateRefresh);
            return QStringList(plot.xAxis->tickVectorLabels()).join(u' ');
        };
        plot.resize(400, 300);
        QVERIFY2(labels().contains(QStringLiteral("0.4")), qPrintable(labels()));
        QLocale::setDefault(QLocale(QLocale::German));
        QEvent change(QEvent::LanguageChange);
        QCoreApplication::sendEvent(&plot, &change);
        QVERIFY2(labels().contains(QStringLiteral("0,4")), qPrintable(labels()));
        QVERIFY(!labels().contains(u'.'));
        LocalPlot later;
        QCOMPARE(later.locale().language(), QLocale::German);
    }
};

AXISCOMP_WINDOW_TEST(TestValueScale)

} // namespace tst_valuescale

#include "tst_valuescale.moc"
