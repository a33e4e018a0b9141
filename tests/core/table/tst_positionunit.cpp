// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/position_unit.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

namespace tst_positionunit {

using namespace axiscomp;

class TestPositionUnit : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aDrivesUnitHasASymbol()
    {
        QCOMPARE(unitSymbol("Millimeter"), "mm");
        QCOMPARE(unitSymbol("Degree"), "deg");
        QCOMPARE(unitSymbol("None"), "");
        QCOMPARE(unitSymbol("Furlong"), "Furlong");
    }

    void unitsOfOneKindHaveAFactor_data()
    {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::addColumn<double>("factor"); // 0: none
        const auto row = [](const char* from, const char* to, double factor) {
            QTest::addRow("%s to %s", from, to) << QByteArray(from) << QByteArray(to) << factor;
        };
        row("um", "mm", 0.001);
        row("mm", "um", 1000.0);
        row("µm", "Millimeter", 0.001);
        row("\u03bcm", "nm", 1000.0);
        row("Inch", "mm", 25.4);
        row("m", "um", 1e6);
        row("deg", "Radian", 0.017453292519943295);
        row("arcsec", "°", 1.0 / 3600.0);
        row("inches", "mm", 25.4);
        row("thou", "mil", 1.0);
        row("uin", "in", 1e-6);
        row("microns", "\u339b", 1.0);
        row("\u2033", "arcsec", 1.0);
        row("'", "arcminutes", 1.0);
        row("Radian", "deg", 57.29577951308232);
        row("mrad", "arcsec", 206.26480624709636);
        row("turn", "rad", 6.283185307179586);
        row("mm", "deg", 0.0);
        row("mm", "Furlong", 0.0);
        row("", "mm", 0.0);
    }
    void unitsOfOneKindHaveAFactor()
    {
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, to);
        QFETCH(double, factor);
        const auto found = unitFactor(from.constData(), to.constData());
        QCOMPARE(found.has_value(), factor != 0.0);
        if (found)
            QVERIFY2(std::abs(*found / factor - 1.0) < 1e-12, qPrintable(QString::number(*found)));
    }

    /// Otherwise 20 mm that were um become 20.000000000000004 in a file.
    void decimalFactorsAreExact()
    {
        QCOMPARE(*unitFactor("mm", "um"), 1000.0);
        QCOMPARE(*unitFactor("um", "mm"), 0.001);
        QCOMPARE(*unitFactor("um", "nm"), 1000.0);
        QCOMPARE(*unitFactor("m", "nm"), 1e9);
        QCOMPARE(*unitFactor("inch", "mm"), 25.4);
        QCOMPARE(*unitFactor("uin", "nm"), 25.4);
        QCOMPARE(*unitFactor("deg", "arcsec"), 3600.0);
        QCOMPARE(*unitFactor("turn", "deg"), 360.0);
        QCOMPARE(*unitFactor("rad", "urad"), 1e6);
    }

    void spellingsOfAUnitAreTheSame()
    {
        QVERIFY(isSameUnit("um", "µm"));
        QVERIFY(isSameUnit("MM", "Millimeter"));
        QVERIFY(isSameUnit("°", "Degree"));
        QVERIFY(isSameUnit("Furlong", "furlong"));
        QVERIFY(!isSameUnit("um", "mm"));
        QVERIFY(!isSameUnit("mrad", "mm"));
        QVERIFY(!isSameUnit("", "mm"));
    }
};

AXISCOMP_TEST(TestPositionUnit)

} // namespace tst_positionunit

#include "tst_positionunit.moc"
