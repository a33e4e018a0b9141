// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/window_test.h"
#include "ui/fields/number_edit.h"
#include "ui/text/fine_scale.h"
#include "ui/text/typed_number.h"

#include <QSignalSpy>
#include <QTest>

#include <cmath>

namespace tst_numberedit {

using axiscomp::ui::amountOf;
using axiscomp::ui::NumberEdit;
using axiscomp::ui::typedList;
using Numbers = std::vector<double>;

namespace {

void enter(NumberEdit& field, const QString& text)
{
    field.setText(text);
    Q_EMIT field.editingFinished();
}

} // namespace

/// Numbers as a person types them: what is none is never taken for another one.
class TestNumberEdit : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { axiscomp::test::failOnWindowWarnings(); }
    void cleanup() { QLocale::setDefault(QLocale(QLocale::English)); }

    void numbersAreTypedAsTheLanguageWritesThem()
    {
        QLocale::setDefault(QLocale(QLocale::German));
        NumberEdit field({.most = 3});
        enter(field, QStringLiteral("0,5; 10"));
        QCOMPARE(field.numbers(), (Numbers{0.5, 10.0}));
        enter(field, QStringLiteral("2.5"));
        QCOMPARE(field.numbers(), Numbers{2.5});
        field.setNumbers({1.25, 3.0});
        QCOMPARE(field.text(), QStringLiteral("1,25; 3"));
    }

    /// A thousand or one: it depends on who reads it.
    void whatCanBeReadInTwoWaysIsNotTaken()
    {
        for (const auto language : {QLocale::English, QLocale::German}) {
            QLocale::setDefault(QLocale(language));
            NumberEdit field(NumberEdit::Rule{});
            enter(field,
                language == QLocale::English ? QStringLiteral("1,000") : QStringLiteral("1.000,5"));
            QVERIFY(field.numbers().empty() && !field.problem().isEmpty());
            if (language == QLocale::German) {
                enter(field, QStringLiteral("1.000"));
                QVERIFY(field.numbers().empty() && !field.problem().isEmpty());
            }
        }
    }

    /// French has blanks between thousands, and lists may have them between numbers.
    void aBlankThatMayStandBetweenThousandsIsNotTaken()
    {
        for (const auto language : {QLocale::English, QLocale::French}) {
            QLocale::setDefault(QLocale(language));
            NumberEdit field({.most = 3});
            for (const char* text :
                {"1 250", "1\u00a0250", "1\u202f250", "2; 12 250", "1 250 000", "-1 250"}) {
                enter(field, QString::fromUtf8(text));
                QVERIFY2(field.numbers().empty() && !field.problem().isEmpty(), text);
            }
            enter(field, QStringLiteral("1250; 11 7"));
            QCOMPARE(field.numbers(), (Numbers{1250.0, 11.0, 7.0}));
            enter(field, QStringLiteral("101; 201"));
            QCOMPARE(field.numbers(), (Numbers{101.0, 201.0}));
            enter(field, QStringLiteral("1500 250"));
            QCOMPARE(field.numbers(), (Numbers{1500.0, 250.0}));
        }
    }

    void inAListWithCommasTheseMayStandBetweenThousandsToo()
    {
        QCOMPARE(typedList(QStringLiteral("21, 31;41,51"), true).value_or(QStringList()),
            (QStringList{QStringLiteral("21"), QStringLiteral("31"), QStringLiteral("41"),
                QStringLiteral("51")}));
        QVERIFY(!typedList(QStringLiteral("1,250"), true));
        QVERIFY(!typedList(QStringLiteral("1 250"), true));
        QVERIFY(typedList(QStringLiteral("1,250"), false));
        QCOMPARE(typedList(QStringLiteral("0.5 250"), false).value_or(QStringList()).size(),
            qsizetype(2));
    }

    void anAmountThatMayHaveThousandsIsNotTaken()
    {
        QLocale::setDefault(QLocale(QLocale::German));
        for (const char* text : {"1.234", "1.234 mm", "1.234,5 um"})
            QVERIFY2(!amountOf(QLatin1StringView(text), false), text);
        const auto millimetres = amountOf(QStringLiteral("1,234 mm"), false);
        QVERIFY(millimetres && *millimetres == 1.234);
        const auto micrometres = amountOf(QStringLiteral("2.5"), false);
        QVERIFY(micrometres && std::abs(*micrometres - 0.0025) < 1e-12);
    }

    /// A group of thousands does not begin with 0.
    void whatIsBelowOneHasNoThousands()
    {
        for (const auto language : {QLocale::English, QLocale::German, QLocale::French}) {
            QLocale::setDefault(QLocale(language));
            for (const char* text : {"0,016 mm", "0.016 mm", "16.0 um", "16,0", "0,016mm"}) {
                const auto amount = amountOf(QLatin1StringView(text), false);
                QVERIFY2(amount && std::abs(*amount - 0.016) < 1e-12, text);
            }
        }
        QLocale::setDefault(QLocale(QLocale::German));
        NumberEdit field({.most = 2});
        enter(field, QStringLiteral("0.016; -0.250"));
        QCOMPARE(field.numbers(), (Numbers{0.016, -0.25}));
        QLocale::setDefault(QLocale(QLocale::English));
        for (const char* text : {"1,234 mm", "0,016,000", "0,016.5", "1,5,2"})
            QVERIFY2(!amountOf(QLatin1StringView(text), false), text);
        // In a list the comma might separate.
        enter(field, QStringLiteral("0,016"));
        QVERIFY(!field.problem().isEmpty());
    }

    void aWrongTextStaysAndTheNumberBeforeToo()
    {
        NumberEdit field({.smallest = 0.0, .isMore = true});
        QSignalSpy chosen(&field, &NumberEdit::chosen);
        enter(field, QStringLiteral("4"));
        QCOMPARE(chosen.size(), 1);
        for (const char* wrong : {"0", "-1", "four", "nan", "inf", "1; 2"}) {
            enter(field, QLatin1StringView(wrong));
            QVERIFY2(!field.problem().isEmpty(), wrong);
            QCOMPARE(field.text(), QLatin1StringView(wrong));
            QCOMPARE(field.numbers(), Numbers{4.0});
        }
        QCOMPARE(chosen.size(), 1);
        enter(field, QString());
        QVERIFY(field.problem().isEmpty() && field.numbers().empty());
        QCOMPARE(chosen.size(), 2);
    }

    /// What is made on another thread comes while somebody types.
    void whatIsBeingTypedStaysWhileTheNumberIsTheSame()
    {
        NumberEdit field({.smallest = 0.0, .isMore = true});
        field.setNumbers({4.0});
        field.selectAll();
        QTest::keyClicks(&field, QStringLiteral("0."));
        field.setNumbers({4.0});
        QTest::keyClicks(&field, QStringLiteral("5"));
        QCOMPARE(field.text(), QStringLiteral("0.5"));
        Q_EMIT field.editingFinished();
        QCOMPARE(field.numbers(), Numbers{0.5});
        field.selectAll();
        QTest::keyClicks(&field, QStringLiteral("four"));
        Q_EMIT field.editingFinished();
        field.setNumbers({0.5});
        QCOMPARE(field.text(), QStringLiteral("four"));
        QVERIFY(!field.problem().isEmpty());
        field.setNumbers({2.0});
        QCOMPARE(field.text(), QStringLiteral("2"));
        QVERIFY(field.problem().isEmpty());
    }

    void aCountIsWhole()
    {
        NumberEdit field({.most = 2, .smallest = 2.0, .areWhole = true});
        enter(field, QStringLiteral("41; 31"));
        QCOMPARE(field.numbers(), (Numbers{41.0, 31.0}));
        enter(field, QStringLiteral("2.5"));
        QVERIFY(!field.problem().isEmpty());
        enter(field, QStringLiteral("1"));
        QVERIFY(!field.problem().isEmpty());
    }
};

AXISCOMP_WINDOW_TEST(TestNumberEdit)

} // namespace tst_numberedit

#include "tst_numberedit.moc"
