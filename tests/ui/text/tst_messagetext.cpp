// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"
#include "tests/ui/support/pseudo_language.h"
#include "ui/text/language.h"
#include "ui/text/message_text.h"
#include "ui/text/translated_text.h"

#include <QTest>

namespace tst_messagetext {

using namespace axiscomp;
using namespace axiscomp::ui;

namespace {

const TextPattern aFolder = AXISCOMP_TEXT("Error", "it is a folder");

} // namespace

/// How the sentences of core become those of the window's language.
class TestMessageText : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aTextWithinATextIsTranslatedToo()
    {
        const Language language(QStringLiteral("de"));
        const Text inner{errorPattern(ErrorCode::NotHomed), {{"axis", 0}}};
        QCOMPARE(
            errorText({ErrorCode::RollbackFailed,
                {{"reason", inner}, {"rollback", aFolder}, {"backup", Verbatim{"/tmp/b.json"}}},
                {}}),
            QStringLiteral(
                "Achse 0 muss zuerst referenziert werden; auch das Zurückstellen des alten "
                "Zustands ist fehlgeschlagen (das ist ein Ordner). Die Achse nicht aktivieren, "
                "sondern wiederherstellen aus /tmp/b.json."));
    }

    void aQuestionWithinASentenceHasNoFullStopBehindIt()
    {
        const Text inner = AXISCOMP_TEXT(
            "Error", "nothing listens there; is the drive switched on, and is the address right?");
        Language language(QStringLiteral("en"));
        for (const char* name : {"en", "de", "fr", "ja", "zh"}) {
            language.select(QLatin1StringView(name));
            const QString said = errorText({ErrorCode::OutcomeUnknown,
                {{"reason", inner}, {"backup", Verbatim{"/tmp/b.json"}}}, {}});
            QVERIFY2(said.contains(u'?') || said.contains(QChar(0xff1f)), qPrintable(said));
            for (const QChar mark : {QChar(u'?'), QChar(0xff1f)})
                for (const QChar stop : {QChar(u'.'), QChar(0x3002)})
                    QVERIFY2(!said.contains(QString(mark) + stop), qPrintable(said));
        }
    }

    void numbersHaveTheDecimalSignOfTheLanguageAndNamesKeepTheirs()
    {
        const Text text = AXISCOMP_TEXT("Error", "{axis} = {position}")
                              .with("axis", Verbatim{"1.5"})
                              .with("position", Quantity{"-1.5e-05", "mm"});
        Language language(QStringLiteral("de"));
        QCOMPARE(translated(text), QStringLiteral("1.5 = -1,5e-05 mm"));
        language.select(QStringLiteral("en"));
        QCOMPARE(translated(text), QStringLiteral("1.5 = -1.5e-05 mm"));
        QCOMPARE(QString::fromStdString(text.english()), translated(text));
    }

    void aListIsJoined()
    {
        const Language language(QStringLiteral("de"));
        QCOMPARE(
            errorText({ErrorCode::TableNotFound,
                {{"table", Verbatim{"A"}}, {"known", std::vector<std::string>{"B", "C 1.5"}}}, {}}),
            QStringLiteral("Die Datei enthält keine Tabelle A, sondern: B, C 1.5."));
    }

    void aCountChoosesItsForm_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<int>("count");
        QTest::addColumn<QString>("sentence");
        const auto row = [](const char* language, int count, const char* sentence) {
            QTest::addRow("%s, %d", language, count)
                << QString::fromLatin1(language) << count << QString::fromUtf8(sentence);
        };
        row("en", 0, "X.csv is not a valid calibration file: 0 problems.");
        row("en", 1, "X.csv is not a valid calibration file: one problem.");
        row("en", 7, "X.csv is not a valid calibration file: 7 problems.");
        row("de", 1, "X.csv ist keine gültige Kalibrierdatei: 1 Problem.");
        row("de", 7, "X.csv ist keine gültige Kalibrierdatei: 7 Probleme.");
    }
    void aCountChoosesItsForm()
    {
        QFETCH(const QString, language);
        QFETCH(const int, count);
        const Language spoken(language);
        // A name at the beginning of a sentence is not a word.
        QTEST(errorText({ErrorCode::InvalidCalibration,
                  {{"file", Verbatim{"X.csv"}}, {"count", count}}, {}}),
            "sentence");
    }

    void wordsWithoutATranslationStayEnglish()
    {
        const Language language(QStringLiteral("de"));
        const TextPattern unheard{"Error", "{count} unheard of things", "one unheard of thing"};
        QCOMPARE(translated(unheard.with("count", 1)), QStringLiteral("one unheard of thing"));
        QCOMPARE(translated(unheard.with("count", 2)), QStringLiteral("2 unheard of things"));
        QCOMPARE(translated(TextPattern{"Error", "a {thing}", nullptr}), QStringLiteral("a ?"));
    }

    void aTextThatWasReadAtRunTimeIsTranslated()
    {
        const Language language(QStringLiteral("de"));
        QCOMPARE(translated(Text::withWords("Error", "it is a folder", {}, {})),
            QStringLiteral("das ist ein Ordner"));
    }

    void onlyANumberCanBeAnEmptyCell()
    {
        const Language language(QStringLiteral("de"));
        QCOMPARE(problemText({Severity::Error, DiagnosticCode::NotANumber, 3, 2, {}, {}, {}}),
            QStringLiteral("Das ist keine Zahl: die Zelle ist leer."));
    }

    void aProblemIsAGermanSentence()
    {
        const Language language(QStringLiteral("de"));
        QCOMPARE(problemText({Severity::Error, DiagnosticCode::NotANumber, 3, 2, Verbatim{"1,5x"},
                     AXISCOMP_TEXT("Error", "a number such as {example}")
                         .with("example", Verbatim{"0.5"}),
                     {}}),
            QStringLiteral("Das ist keine Zahl: gefunden \"1,5x\", erwartet eine Zahl wie 0.5."));
    }

    void aMessageOfTenTextsIsTranslatedQuickly()
    {
        const Language language(QStringLiteral("de"));
        Text text = aFolder;
        for (int n = 0; n < 9; ++n)
            text = Text(errorPattern(ErrorCode::FileNotReadable),
                {{"file", Verbatim{"x"}}, {"reason", text}});
        QVERIFY(translated(text).endsWith(QStringLiteral("das ist ein Ordner")));
        QBENCHMARK
        {
            (void)translated(text);
        }
    }
};

AXISCOMP_TEST(TestMessageText)

} // namespace tst_messagetext

#include "tst_messagetext.moc"
