// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"
#include "ui/text/language.h"
#include "ui/text/message_text.h"
#include "ui/text/phrase_book.h"

#include <QTest>

namespace tst_messagetext {

using namespace axiscomp;
using namespace axiscomp::ui;

/// How the sentences of core become those of the window's language.
class TestMessageText : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void phrasesWithinPhrasesAreGerman_data()
    {
        QTest::addColumn<QByteArray>("english");
        QTest::addColumn<QString>("german");
        const auto row = [](const char* english, const char* german) {
            QTest::newRow(english) << QByteArray(english) << QString::fromUtf8(german);
        };
        row("10 (steps of 5) (or is the dimensionality 2?)",
            "10 (Schrittweite 5) (oder ist die Dimensionalität 2?)");
        row("at least 3 for dimensionality 2, 2 of positions and 1 of values; separate the columns "
            "with , or ; instead of tabs",
            "mindestens 3 bei Dimensionalität 2, davon 2 mit Positionen und 1 mit Werten; die "
            "Spalten mit , oder ; statt mit Tabulatoren trennen");
        row("Small1 (CRC 1c291ca3), Axes[0]/A, Axes[1]/B, volatile",
            "Small1 (CRC 1c291ca3), Axes[0]/A, Axes[1]/B, flüchtig");
        row("the compensation of axis 0 (X) is on, so its homing must stay; deactivate it",
            "die Kompensation ist eingeschaltet (Achse 0 (X)), daher unveränderlich: die "
            "Referenzierung; zuerst deaktivieren");
        row("HTTP status 500 and \"a text\"", "HTTP-Status 500 und \"a text\"");
        row("unheard of", "unheard of");
    }
    void phrasesWithinPhrasesAreGerman()
    {
        QFETCH(QByteArray, english);
        QFETCH(QString, german);
        const Language language(QStringLiteral("de"));
        QCOMPARE(translatedPhrase(english.toStdString()), german);
    }

    void ofSeveralPhrasesTheOneThatKnowsMoreIsTaken()
    {
        // " says " is a part of another sentence than the phrase with the most letters.
        const Language language(QStringLiteral("de"));
        QCOMPARE(translatedPhrase("where the encoders read X = 0.5 mm, Y = 1.5 mm, Z = 2 mm the "
                                  "reference of Q is 0.001 mm below its encoder: the feedback file "
                                  "says -0.001 mm"),
            QStringLiteral("wo die Geber X = 0,5 mm, Y = 1,5 mm, Z = 2 mm melden, liegt die "
                           "Referenz von Q 0,001 mm unter ihrem Geber: in der Datei der Geberseite "
                           "steht -0,001 mm"));
        QCOMPARE(translatedPhrase("{before} next to 3"), QStringLiteral("{before} neben 3"));
    }

    void aTextThatManyPhrasesMatchIsTranslatedAtOnce()
    {
        const Language language(QStringLiteral("de"));
        std::string english = "a number";
        for (int i = 0; i < 20; ++i)
            english += "; b (c), expected d: found e (f)";
        QVERIFY(translatedPhrase(english).startsWith(QStringLiteral("eine Zahl")));
    }

    void numbersInSentencesHaveTheDecimalSignOfTheLanguage_data()
    {
        QTest::addColumn<QByteArray>("english");
        QTest::addColumn<QString>("german");
        const auto row = [](const char* english, const char* german) {
            QTest::newRow(english) << QByteArray(english) << QString::fromUtf8(german);
        };
        row("0.25", "0,25");
        row("they differ by at most 1.5e-05 mm at X = -0.5 mm",
            "sie unterscheiden sich höchstens um 1,5e-05 mm bei X = -0,5 mm");
        row("0.25 after 1e3", "0,25 nach 1e3");
        // What a person shall write like this, what was typed, names, versions and addresses.
        row("a number such as 0.5", "eine Zahl wie 0.5");
        row("version 1.5", "Version 1.5");
        row("\"0.5\", which is taken to be a header", "\"0.5\", als Kopfzeile aufgefasst");
        row("10.0.0.1", "10.0.0.1");
        row("two numbers such as 0.25,0.001: position and offset",
            "zwei Zahlen wie 0.25,0.001: Position und Offset");
    }
    void numbersInSentencesHaveTheDecimalSignOfTheLanguage()
    {
        QFETCH(QByteArray, english);
        QFETCH(QString, german);
        Language language(QStringLiteral("de"));
        QCOMPARE(translatedPhrase(english.toStdString()), german);
        language.select(QStringLiteral("en"));
        QCOMPARE(translatedPhrase(english.toStdString()), QString::fromUtf8(english));
    }

    void onlyANumberCanBeAnEmptyCell()
    {
        const Language language(QStringLiteral("de"));
        QCOMPARE(problemText({Severity::Error, DiagnosticCode::NotANumber, 3, 2, "", "a number"}),
            QStringLiteral("Das ist keine Zahl: die Zelle ist leer, erwartet eine Zahl."));
        QCOMPARE(problemText({Severity::Error, DiagnosticCode::Syntax, 0, 0, "",
                     "an index that ends in ]"}),
            QStringLiteral("Das ist nicht so geschrieben, wie das Format es verlangt, erwartet ein "
                           "Index, der mit ] endet."));
    }

    void namesKeepTheirPoints()
    {
        const Language language(QStringLiteral("de"));
        QCOMPARE(errorText({ErrorCode::FileNotReadable,
                     {{"file", "1.5"}, {"reason", "it is a folder"}}, {}}),
            QStringLiteral("1.5 kann nicht gelesen werden: das ist ein Ordner."));
    }

    void anErrorIsAGermanSentence()
    {
        const Language language(QStringLiteral("de"));
        QCOMPARE(errorText({ErrorCode::NotConnected,
                     {{"endpoint", "http://x"},
                         {"reason",
                             "nothing listens there; is the drive switched on, and is the address "
                             "right?"}},
                     {}}),
            QStringLiteral("Keine Verbindung zu http://x: dort antwortet nichts; ist der Antrieb "
                           "eingeschaltet und stimmt die Adresse?"));
        QCOMPARE(problemText({Severity::Error, DiagnosticCode::NotANumber, 3, 2, "1,5x",
                     "a number such as 0.5"}),
            QStringLiteral("Das ist keine Zahl: gefunden \"1,5x\", erwartet eine Zahl wie 0.5."));
    }
};

AXISCOMP_TEST(TestMessageText)

} // namespace tst_messagetext

#include "tst_messagetext.moc"
