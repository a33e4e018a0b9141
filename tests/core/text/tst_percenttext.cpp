// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/number_text.h"

#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

namespace tst_percenttext {

using axiscomp::percentText;

/// A share of a proof or of a travel never looks larger than it is.
class TestPercentText : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { axiscomp::test::failOnWarnings(); }

    void sharesAreRoundedDown_data()
    {
        QTest::addColumn<double>("share");
        QTest::addColumn<QString>("text");
        QTest::newRow("nothing") << 0.0 << "0";
        QTest::newRow("all") << 1.0 << "100";
        QTest::newRow("nearly all") << 0.99999 << "99";
        QTest::newRow("half") << 0.5 << "50";
        QTest::newRow("a third") << 1.0 / 3.0 << "33";
        QTest::newRow("two thirds") << 2.0 / 3.0 << "66";
        QTest::newRow("a tenth") << 0.1 << "10";
        QTest::newRow("a thirtieth") << 1.0 / 30.0 << "3.3";
        QTest::newRow("0.29 of a hundred") << 0.29 << "29"; // 0.29 * 100 is 28.999999999999996
        QTest::newRow("one of 17") << 1.0 / 17.0 << "5.8";
        QTest::newRow("one cell of a large table") << 1.0 / 524288.0 << "0.00019";
        QTest::newRow("less than nothing") << -0.1 << "0";
    }
    void sharesAreRoundedDown()
    {
        QFETCH(double, share);
        QFETCH(QString, text);
        QCOMPARE(QString::fromStdString(percentText(share)), text);
    }
};

AXISCOMP_TEST(TestPercentText)

} // namespace tst_percenttext

#include "tst_percenttext.moc"
