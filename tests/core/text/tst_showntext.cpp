// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/utf8.h"

#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

namespace tst_showntext {

using namespace axiscomp;

class TestShownText : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void whatATerminalActsOnBecomesVisible_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("shown");
        QTest::newRow("nothing special")
            << QByteArray("Stra\u00dfe 5 \u00b5m") << QByteArray("Stra\u00dfe 5 \u00b5m");
        QTest::newRow("escape") << QByteArray("a\x1b[2Jb") << QByteArray("a\u241b[2Jb");
        QTest::newRow("line end") << QByteArray("a\nb\r") << QByteArray("a\u240ab\u240d");
        QTest::newRow("delete") << QByteArray("a\x7f") << QByteArray("a[U+007F]");
        QTest::newRow("control sequence introducer")
            << QByteArray("\u009b31m") << QByteArray("[U+009B]31m");
        QTest::newRow("right to left") << QByteArray("a\u202egnp") << QByteArray("a[U+202E]gnp");
        QTest::newRow("isolate") << QByteArray("\u2066x\u2069") << QByteArray("[U+2066]x[U+2069]");
        QTest::newRow("no width") << QByteArray("a\u200bb\ufeff")
                                  << QByteArray("a[U+200B]b[U+FEFF]");
        QTest::newRow("tags") << QByteArray("\U000E0041") << QByteArray("[U+E0041]");
        QTest::newRow("no UTF-8") << QByteArray("a\xff"
                                                "b")
                                  << QByteArray("a\ufffd"
                                                "b");
        QTest::newRow("four bytes") << QByteArray("\U0001F600") << QByteArray("\U0001F600");
    }
    void whatATerminalActsOnBecomesVisible()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, shown);
        QCOMPARE(QByteArray::fromStdString(visibleText(text.toStdString())), shown);
        QCOMPARE(QByteArray::fromStdString(shownText(text.toStdString())), shown);
    }

    void linesAreKeptWhereThatIsAskedFor()
    {
        QCOMPARE(visibleText("a\n\tb\r\x1b", true), std::string("a\n\tb\u240d\u241b"));
    }

    void aLongTextIsCutBetweenCharacters()
    {
        const std::string letters(300, 'x');
        QCOMPARE(shownText(letters, 100), std::string(100, 'x') + "\u2026");
        QCOMPARE(shownText(std::string(100, 'x'), 100), std::string(100, 'x'));
        QCOMPARE(shownText("abc\u00e4\u00e4", 4), std::string("abc\u2026"));
    }

    void aTextEndsAtItsFirstZero()
    {
        QCOMPARE(shownText(std::string_view("ab\0cd", 5)), std::string("ab"));
    }
};

AXISCOMP_TEST(TestShownText)

} // namespace tst_showntext

#include "tst_showntext.moc"
