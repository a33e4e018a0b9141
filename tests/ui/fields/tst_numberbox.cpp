// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/window_test.h"
#include "ui/fields/number_box.h"

#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

namespace tst_numberbox {

using axiscomp::ui::NumberBox;

namespace {

/// As a person types over what is there.
double typed(NumberBox& box, const QString& text)
{
    auto& line = *box.findChild<QLineEdit*>();
    box.selectAll();
    QTest::keyClicks(&line, text);
    box.interpretText();
    return box.value();
}

} // namespace

/// Numbers in a spin box, with the decimal sign of whoever types.
class TestNumberBox : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { axiscomp::test::failOnWindowWarnings(); }

    void bothDecimalSignsAreTaken_data()
    {
        QTest::addColumn<QLocale>("language");
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("value");
        const QLocale english(QLocale::English);
        const QLocale german(QLocale::German);
        const QLocale french(QLocale::French);
        const auto row = [](const QLocale& language, const char* text, double value) {
            QTest::addRow("%s in %s", text, qPrintable(language.name()))
                << language << QString::fromUtf8(text) << value;
        };
        row(english, "0.5", 0.5);
        row(english, "0,5", 0.5);
        row(english, "0,016", 0.016);
        row(german, "0.016", 0.016);
        row(german, "2,5", 2.5);
        row(german, "2.5", 2.5);
        row(german, "-2.25", -2.25);
        row(german, "1000,5", 1000.5);
        row(french, "2.5", 2.5);
    }
    void bothDecimalSignsAreTaken()
    {
        QFETCH(QLocale, language);
        QFETCH(QString, text);
        QFETCH(double, value);
        NumberBox box;
        box.setLocale(language);
        box.setDecimals(3);
        box.setRange(-1e6, 1e6);
        box.setSuffix(QStringLiteral(" mm"));
        QCOMPARE(typed(box, text), value);
        QString shown = language.toString(value, 'f', 3);
        QCOMPARE(box.cleanText(), shown.remove(language.groupSeparator()));
    }

    void whatMayHaveThousandsLeavesTheNumberBefore_data()
    {
        QTest::addColumn<QLocale>("language");
        QTest::addColumn<QString>("text");
        QTest::newRow("English") << QLocale(QLocale::English) << QStringLiteral("1,000");
        QTest::newRow("German") << QLocale(QLocale::German) << QStringLiteral("1.000");
        QTest::newRow("both") << QLocale(QLocale::German) << QStringLiteral("1.000,5");
    }
    void whatMayHaveThousandsLeavesTheNumberBefore()
    {
        QFETCH(QLocale, language);
        QFETCH(QString, text);
        NumberBox box;
        box.setLocale(language);
        box.setRange(-1e6, 1e6);
        box.setValue(7.0);
        QCOMPARE(typed(box, text), 7.0);
    }

    void theNumberBeforeComesBackWithTheReason()
    {
        NumberBox box;
        box.setLocale(QLocale(QLocale::German));
        box.setAccessibleName(QStringLiteral("Zero"));
        box.setDecimals(3);
        box.setRange(-1e6, 1e6);
        box.setValue(7.0);
        QSignalSpy changes(&box, &NumberBox::problemChanged);
        const auto enter = [&](const QString& text) {
            box.selectAll();
            QTest::keyClicks(&box, text);
            QTest::keyClick(&box, Qt::Key_Return);
        };
        enter(QStringLiteral("12.345"));
        QCOMPARE(box.value(), 7.0);
        QCOMPARE(changes.count(), 1);
        QCOMPARE(box.problem(),
            QStringLiteral("Zero: \"12.345\" can be read in two ways; write thousands without a "
                           "sign between them."));
        enter(QStringLiteral("12,345"));
        QCOMPARE(box.value(), 12.345);
        QCOMPARE(changes.count(), 2);
        QVERIFY(box.problem().isEmpty());
        // Whoever goes on from the number before has seen it.
        enter(QStringLiteral("12.345"));
        QVERIFY(!box.problem().isEmpty());
        QTest::keyClick(&box, Qt::Key_Up);
        QCOMPARE(box.value(), 13.345);
        QVERIFY(box.problem().isEmpty());
    }
};

AXISCOMP_WINDOW_TEST(TestNumberBox)

} // namespace tst_numberbox

#include "tst_numberbox.moc"
