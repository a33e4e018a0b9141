// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"
#include "tests/support/verify.h"
#include "tests/ui/source_texts.h"
#include "tests/ui/translation_file.h"
#include "ui/error_text.h"
#include "ui/language.h"
#include "ui/phrase_book.h"

#include <QCoreApplication>
#include <QDir>
#include <QHash>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

using namespace axiscomp;
using namespace axiscomp::ui;
using test::Message;

namespace {

const QString sources = QStringLiteral(AXISCOMP_SOURCE_FOLDER);

/// What lupdate finds in the sources now, and what it has to say about them.
struct SourceTexts {
    std::vector<Message> messages;
    QByteArray complaints;
};

SourceTexts textsOfTheSources()
{
    const QTemporaryDir folder;
    const QString found = folder.filePath(QStringLiteral("sources.ts"));
    QProcess lupdate;
    lupdate.setWorkingDirectory(sources);
    lupdate.setProcessChannelMode(QProcess::MergedChannels);
    lupdate.start(QStringLiteral(AXISCOMP_LUPDATE),
        {QStringLiteral("-silent"), QStringLiteral("-locations"), QStringLiteral("absolute"),
            QStringLiteral("-no-ui-lines"), QStringLiteral("-I"), QStringLiteral("."),
            QStringLiteral("ui"), QStringLiteral("app/wizard"), QStringLiteral("-ts"), found});
    if (!lupdate.waitForFinished(120'000))
        return {{}, "lupdate did not end"};
    std::vector<Message> messages = test::readTranslationFile(found);
    for (Message& message : messages) // the places are told from the folder of the file
        message.place =
            QDir(sources).relativeFilePath(QDir::cleanPath(folder.filePath(message.place)));
    return {std::move(messages), lupdate.readAll()};
}

QString germanFile()
{
    return sources + QStringLiteral("/translations/axiscomp_de.ts");
}

QStringList captured(const QString& text, const QRegularExpression& expression)
{
    QStringList found;
    for (auto matches = expression.globalMatch(text); matches.hasNext();)
        found += matches.next().captured();
    found.sort();
    return found;
}

/// "%1", "%n", "{name}", "[*]", and the tags of rich text.
QStringList placeholdersOf(const QString& text)
{
    static const QRegularExpression placeholder(
        QStringLiteral("%L?\\d+|%n|\\{\\w+\\}|\\[\\*\\]|</?b>|&nbsp;"));
    return captured(text, placeholder);
}

bool hasMnemonic(QString text)
{
    static const QRegularExpression notAMnemonic(QStringLiteral("&&|&\\w+;"));
    return text.remove(notAMnemonic).contains(u'&');
}

QStringList edgesOf(const QString& text)
{
    static const QRegularExpression edge(QStringLiteral("^\\s+|\\s+$|(…|\\.\\.\\.|[.?!])$"));
    return captured(text, edge);
}

QByteArray joined(const QStringList& lines)
{
    return lines.join(u'\n').toUtf8();
}

/// Files whose texts no window shows: profiles are read before there is one, and the words of a
/// problem of a file are ui/problem_text.cpp's.
bool isShown(const QString& file)
{
    static const QStringList hidden{QStringLiteral("profile_layout.cpp"),
        QStringLiteral("profile_loader.cpp"), QStringLiteral("profile_registers.cpp"),
        QStringLiteral("table_layout.cpp"), QStringLiteral("calibration_example.cpp"),
        QStringLiteral("diagnostic.cpp"), QStringLiteral("register_value.cpp"),
        QStringLiteral("multipart_form.cpp")};
    return !hidden.contains(file.section(u'/', -1));
}

/// Steps have words of their own; the rest is for machines, or a detail that only the log has.
bool isForPeople(const QString& literal)
{
    static const QStringList others{QStringLiteral("drive http"),
        QStringLiteral("the body is not JSON"), QStringLiteral(".path must be a text"),
        QStringLiteral(".value must be a number, a text, true, false or null"),
        QStringLiteral("no answer to "), QStringLiteral("the CRC-32 is wrong; ")};
    static const QRegularExpression header(
        QStringLiteral("^(\\\\r\\\\n)?[A-Z][\\w-]+: |application/"));
    return test::isSentence(literal) && stepText(literal) == literal && !others.contains(literal)
        && !header.match(literal).hasMatch();
}

} // namespace

class TestTranslations : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        m_sources = textsOfTheSources();
        for (const Message& message : test::readTranslationFile(germanFile()))
            m_german.insert(message.id(), message);
        QVERIFY(m_sources.messages.size() > 500);
    }
    void init() { test::failOnWarnings(); }

    void lupdateUnderstandsEverySource()
    {
        // It says so when it does not know the class, and with that the context, of a text.
        QVERIFY2(m_sources.complaints.isEmpty(), m_sources.complaints.constData());
    }

    void everyTextOfTheSourcesIsTranslated()
    {
        QStringList missing;
        for (const Message& message : m_sources.messages) {
            const auto german = m_german.constFind(message.id());
            if (german == m_german.constEnd() || !german->isFinished
                || german->translations.isEmpty())
                missing += message.described();
        }
        QVERIFY2(missing.isEmpty(),
            "build the target update-translations, then translate:\n" + joined(missing));
    }

    void everyTranslationIsOfATextOfTheSources()
    {
        QSet<QString> known;
        for (const Message& message : m_sources.messages)
            known.insert(message.id());
        QStringList left;
        for (const Message& message : std::as_const(m_german)) {
            if (!known.contains(message.id()))
                left += message.described();
        }
        QVERIFY2(left.isEmpty(), "build the target update-translations:\n" + joined(left));
    }

    void placeholdersAreTheSameOnBothSides()
    {
        QStringList wrong;
        for (const Message& message : std::as_const(m_german)) {
            for (const QString& text : message.translations) {
                if (placeholdersOf(text) != placeholdersOf(message.source))
                    wrong += message.described() + QStringLiteral(" -> ") + text;
            }
        }
        QVERIFY2(wrong.isEmpty(), joined(wrong));
    }

    void whatHasAKeyHasOneInGerman()
    {
        QStringList wrong;
        for (const Message& message : std::as_const(m_german)) {
            for (const QString& text : message.translations) {
                if (hasMnemonic(text) != hasMnemonic(message.source))
                    wrong += message.described() + QStringLiteral(" -> ") + text;
            }
        }
        QVERIFY2(wrong.isEmpty(), joined(wrong));
    }

    void textsEndAsTheyDoInEnglish()
    {
        QStringList wrong;
        for (const Message& message : std::as_const(m_german)) {
            for (const QString& text : message.translations) {
                // The reader has taken the blanks around a translation away.
                if (edgesOf(text) != edgesOf(message.source.trimmed()))
                    wrong += message.described() + QStringLiteral(" -> ") + text;
            }
        }
        QVERIFY2(wrong.isEmpty(), joined(wrong));
    }

    void everyErrorAndEveryPhraseIsGerman()
    {
        const auto phrases = knownPhrases();
        QStringList missing;
        for (const char* phrase : phrases) {
            const QString id = QStringLiteral("Error\n%1\n").arg(QString::fromUtf8(phrase));
            if (!m_german.contains(id))
                missing += QString::fromUtf8(phrase);
        }
        for (const ErrorCode code : allErrorCodes()) {
            const std::string text(errorTemplate(code));
            const bool isKnown =
                std::ranges::any_of(phrases, [&](const char* phrase) { return text == phrase; });
            if (!isKnown)
                missing += QString::fromStdString(text);
        }
        QVERIFY2(missing.isEmpty(), joined(missing));
    }

    void everyTextOfCoreAndOfTheLinksIsKnown_data()
    {
        QTest::addColumn<QString>("folder");
        QTest::newRow("core") << QStringLiteral("core");
        QTest::newRow("drivecomm") << QStringLiteral("drivecomm");
    }
    void everyTextOfCoreAndOfTheLinksIsKnown()
    {
        QFETCH(QString, folder);
        QString known;
        for (const char* phrase : knownPhrases())
            known += QString::fromUtf8(phrase) + u'\n';
        QStringList unknown;
        int looked = 0;
        const QDir files(sources + u'/' + folder);
        for (const QString& file : files.entryList({QStringLiteral("*.cpp")}, QDir::Files)) {
            if (!isShown(file))
                continue;
            for (const QString& literal : test::stringLiterals(files.filePath(file))) {
                if (!isForPeople(literal))
                    continue;
                ++looked;
                if (!known.contains(literal.trimmed()))
                    unknown += folder + u'/' + file + QStringLiteral(": \"") + literal + u'"';
            }
        }
        QVERIFY(looked > 20);
        QVERIFY2(unknown.isEmpty(),
            "the phrase book (ui/*_phrases.cpp) does not have:\n" + joined(unknown));
    }

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

    void theLanguagesOfTheLibraryAreOffered()
    {
        QCOMPARE(Language::available(), (QStringList{QStringLiteral("en"), QStringLiteral("de")}));
        QCOMPARE(Language::nativeName(QStringLiteral("de")), QStringLiteral("Deutsch"));
        QCOMPARE(Language::nativeName(QStringLiteral("en")), QStringLiteral("English"));
    }

    void numbersFollowTheLanguageAndComeBack()
    {
        const QLocale before;
        {
            Language language(QStringLiteral("de"));
            QCOMPARE(QLocale().toString(1.5), QStringLiteral("1,5"));
            QCOMPARE(translatedPhrase("it is a folder"), QStringLiteral("das ist ein Ordner"));
            language.select(QStringLiteral("en"));
            QCOMPARE(QLocale().toString(1.5), QStringLiteral("1.5"));
            QCOMPARE(translatedPhrase("it is a folder"), QStringLiteral("it is a folder"));
            language.select({});
            QCOMPARE(QLocale(), before);
            language.select(QStringLiteral("de"));
        }
        QCOMPARE(QLocale(), before);
        QCOMPARE(translatedPhrase("it is a folder"), QStringLiteral("it is a folder"));
    }

private:
    SourceTexts m_sources;
    QHash<QString, Message> m_german;
};

QTEST_GUILESS_MAIN(TestTranslations)
#include "tst_translations.moc"
