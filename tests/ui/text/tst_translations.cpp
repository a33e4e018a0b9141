// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/formats/formats.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"
#include "tests/ui/support/source_texts.h"
#include "tests/ui/support/translation_file.h"
#include "ui/text/language.h"
#include "ui/text/message_text.h"
#include "ui/text/phrase_book.h"

#include <QCoreApplication>
#include <QDir>
#include <QDirIterator>
#include <QHash>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

namespace tst_translations {

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
    if (!lupdate.waitForFinished(test::patienceMs))
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

/// Files whose texts no window shows: profiles are read before there is one, values of registers
/// are typed for the command line, and examples and forms are for programs.
bool isShown(const QString& file)
{
    static const QStringList hidden{QStringLiteral("profile_layout.cpp"),
        QStringLiteral("profile_loader.cpp"), QStringLiteral("profile_registers.cpp"),
        QStringLiteral("table_layout.cpp"), QStringLiteral("calibration_example.cpp"),
        QStringLiteral("register_value.cpp"), QStringLiteral("multipart_form.cpp")};
    return !hidden.contains(file.section(u'/', -1));
}

/// What the registry of formats says for docs/formats.md and the help of the command line only.
QStringList documentationTexts()
{
    QStringList texts;
    const auto add = [&texts](std::string_view text) {
        texts += QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
    };
    for (const TableFormat* format : tableFormats()) {
        std::ranges::for_each(format->facts.rules, add);
        std::ranges::for_each(format->facts.assumptions, add);
        add(format->facts.numbers);
        add(format->facts.controller); // a name
        for (const FormatSetting& setting : format->facts.settings)
            add(setting.choices); // as they are typed
    }
    for (const Evidence evidence : {Evidence::Published, Evidence::Code, Evidence::Assumed})
        add(evidenceName(evidence));
    return texts;
}

/// Lines of the files of other controllers, as those want them.
QStringList linesOfFiles()
{
    return {QStringLiteral("# RapidCode compensator table"),
        QStringLiteral(", the first axis fastest\\n"),
        QStringLiteral("// Table of a RapidCode compensator, for CompensatorConfigSet.\\n"),
        QStringLiteral(" in raw counts, "), QStringLiteral(" in user units"),
        QStringLiteral("// The first axis changes fastest.\\n"),
        QStringLiteral("constexpr double table[points] = {\\n"),
        QStringLiteral("#pragma once\\n\\nnamespace "), QStringLiteral("\\n} // namespace "),
        QStringLiteral("constexpr "), QStringLiteral("' Compensation table "),
        QStringLiteral(":START OFFSET="), QStringLiteral("\\nDEFINE COMP "),
        QStringLiteral("RepRapFirmware height map file"),
        QStringLiteral("RepRapFirmware height map file v2")};
}

/// Steps have words of their own; the rest is for machines, or a detail that only the log has.
bool isForPeople(const QString& literal)
{
    static const QStringList others =
        QStringList{QStringLiteral("drive http"), QStringLiteral("tree "),
            QStringLiteral("the body is not JSON"), QStringLiteral(".path must be a text"),
            QStringLiteral(".value must be a number, a text, true, false or null"),
            QStringLiteral("no answer to "), QStringLiteral("the CRC-32 is wrong; "),
            QStringLiteral("dim ")}
        + documentationTexts() + linesOfFiles();
    static const QRegularExpression header(
        QStringLiteral("^(\\\\r\\\\n)?[A-Z][\\w-]+: |application/"));
    return (test::isSentence(literal) || test::isPiece(literal)) && stepText(literal) == literal
        && !others.contains(literal) && !header.match(literal).hasMatch();
}

/// core and its folders, and drivecomm; the simulated drive within it speaks for itself.
/// The sources below the folder; what the virtual drive says is a drive's own words.
QStringList sourceFiles(const QString& folder)
{
    QStringList files;
    QDirIterator below(sources + u'/' + folder, {QStringLiteral("*.cpp"), QStringLiteral("*.h")},
        QDir::Files, QDirIterator::Subdirectories);
    while (below.hasNext()) {
        const QString file = below.next();
        if (isShown(file) && !file.contains(QStringLiteral("/virtualdrive/")))
            files += file;
    }
    return files;
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
        for (const char* folder : {"core", "drivecomm"})
            QTest::newRow(folder) << QString::fromLatin1(folder);
    }
    void everyTextOfCoreAndOfTheLinksIsKnown()
    {
        QFETCH(QString, folder);
        const Language language(QStringLiteral("de"));
        QString phrases;
        for (const char* phrase : knownPhrases())
            phrases += QString::fromUtf8(phrase) + u'\n';
        const auto isKnown = [&phrases](const QString& literal) {
            return phrases.contains(test::isPiece(literal) ? literal : literal.trimmed())
                || translatedPhrase(literal.toStdString()) != literal;
        };
        QStringList unknown;
        int looked = 0;
        for (const QString& file : sourceFiles(folder)) {
            for (const test::Literal& literal : test::stringLiterals(file)) {
                if (!isForPeople(literal.text))
                    continue;
                ++looked;
                if (!isKnown(literal.text))
                    unknown += QStringLiteral("%1:%2: \"%3\"")
                                   .arg(file, QString::number(literal.line), literal.text);
            }
        }
        QVERIFY(looked > 100);
        QVERIFY2(unknown.isEmpty(),
            "the phrase book (ui/*_phrases.cpp) does not have:\n" + joined(unknown));
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

AXISCOMP_TEST(TestTranslations)

} // namespace tst_translations

#include "tst_translations.moc"
