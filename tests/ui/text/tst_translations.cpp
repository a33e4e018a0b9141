// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"
#include "tests/ui/support/source_messages.h"
#include "ui/text/language.h"
#include "ui/text/translated_text.h"

#include <QDir>
#include <QFile>
#include <QHash>
#include <QMap>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>

namespace tst_translations {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::Message;

namespace {

const QString sources = QStringLiteral(AXISCOMP_SOURCE_FOLDER);

using Messages = QHash<QString, Message>;

/// By language: "de".
QMap<QString, Messages> readTranslations()
{
    QMap<QString, Messages> translations;
    const QDir folder(sources + QStringLiteral("/translations"));
    for (const QString& file : folder.entryList({QStringLiteral("axiscomp_*.ts")})) {
        Messages& messages = translations[file.section(u'_', 1).section(u'.', 0, 0)];
        for (const Message& message : test::readTranslationFile(folder.filePath(file)))
            messages.insert(message.id(), message);
    }
    return translations;
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

/// Chinese and Japanese have marks of their own for the same.
QStringList edgesOf(QString text)
{
    static const QRegularExpression edge(QStringLiteral("^\\s+|\\s+$|(…|\\.\\.\\.|[.?!])$"));
    text.replace(u'。', u'.').replace(u'？', u'?').replace(u'！', u'!');
    return captured(text, edge);
}

/// What stands in the first column of the table about the line under the buttons.
QStringList sentencesOfTheGuide()
{
    QFile guide(sources + QStringLiteral("/docs/user-guide.md"));
    if (!guide.open(QIODevice::ReadOnly))
        return {};
    const QString text = QString::fromUtf8(guide.readAll());
    const QString chapter =
        text.section(QStringLiteral("\n## What the line under the buttons says\n"), 1)
            .section(QStringLiteral("\n## "), 0, 0);
    QStringList found;
    for (const QString& line : chapter.split(u'\n')) {
        const QString cell = line.section(u'|', 1, 1).trimmed();
        if (cell.contains(u'.'))
            found += cell.split(QStringLiteral(" / "));
    }
    return found;
}

QByteArray joined(const QStringList& lines)
{
    return lines.join(u'\n').toUtf8();
}

} // namespace

class TestTranslations : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        m_sources = test::findSourceMessages();
        m_translations = readTranslations();
        QCOMPARE(m_translations.keys(), QStringList(Language::available().mid(1)));
        QVERIFY(m_sources.messages.size() > 1500);
    }
    void init() { test::failOnWarnings(); }

    void lupdateUnderstandsEverySource()
    {
        // It says so when it does not know the class, and with that the context, of a text.
        QVERIFY2(m_sources.complaints.isEmpty(), m_sources.complaints.constData());
    }

    void everyTextOfTheSourcesIsTranslated_data() { addLanguages(); }
    void everyTextOfTheSourcesIsTranslated()
    {
        const Messages& translation = ofTheRow();
        QStringList missing;
        for (const Message& message : m_sources.messages) {
            const auto found = translation.constFind(message.id());
            if (found == translation.constEnd() || !found->isFinished
                || found->translations.isEmpty())
                missing += message.described();
        }
        QVERIFY2(missing.isEmpty(),
            "build the target update-translations, then translate:\n" + joined(missing));
    }

    void everyTranslationIsOfATextOfTheSources_data() { addLanguages(); }
    void everyTranslationIsOfATextOfTheSources()
    {
        const Messages& translation = ofTheRow();
        QSet<QString> known;
        for (const Message& message : m_sources.messages)
            known.insert(message.id());
        QStringList left;
        for (const Message& message : translation) {
            if (!known.contains(message.id()))
                left += message.described();
        }
        QVERIFY2(left.isEmpty(), "build the target update-translations:\n" + joined(left));
    }

    void placeholdersAreTheSameOnBothSides_data() { addLanguages(); }
    void placeholdersAreTheSameOnBothSides()
    {
        QFETCH(const QString, language);
        const Messages& translation = ofTheRow();
        QStringList wrong;
        for (const Message& message : translation) {
            for (const QString& text : message.translations) {
                // The form for one may say the number in words; in French it is that of 0, too.
                const bool isForOne = language != QStringLiteral("fr")
                    && message.translations.size() > 1 && text == message.translations.front();
                QStringList wanted = placeholdersOf(message.source);
                QStringList found = placeholdersOf(text);
                if (isForOne) {
                    wanted.removeAll(QStringLiteral("{count}"));
                    found.removeAll(QStringLiteral("{count}"));
                }
                if (found != wanted)
                    wrong += message.described() + QStringLiteral(" -> ") + text;
            }
        }
        QVERIFY2(wrong.isEmpty(), joined(wrong));
    }

    void whatHasAKeyHasOneInTheTranslation_data() { addLanguages(); }
    void whatHasAKeyHasOneInTheTranslation()
    {
        const Messages& translation = ofTheRow();
        QStringList wrong;
        for (const Message& message : translation) {
            for (const QString& text : message.translations) {
                if (hasMnemonic(text) != hasMnemonic(message.source))
                    wrong += message.described() + QStringLiteral(" -> ") + text;
            }
        }
        QVERIFY2(wrong.isEmpty(), joined(wrong));
    }

    void textsEndAsTheyDoInEnglish_data() { addLanguages(); }
    void textsEndAsTheyDoInEnglish()
    {
        const Messages& translation = ofTheRow();
        QStringList wrong;
        for (const Message& message : translation) {
            for (const QString& text : message.translations) {
                // The reader has taken the blanks around a translation away.
                if (edgesOf(text) != edgesOf(message.source.trimmed()))
                    wrong += message.described() + QStringLiteral(" -> ") + text;
            }
        }
        QVERIFY2(wrong.isEmpty(), joined(wrong));
    }

    /// Who reads a sentence on the page looks for it there.
    void theGuideHasTheSentencesOfTheLineUnderTheButtons()
    {
        static const QRegularExpression number(QStringLiteral("\\\\%L?\\d"));
        std::vector<QRegularExpression> known;
        for (const Message& message : m_sources.messages) {
            if (message.context != QStringLiteral("axiscomp::ui::ActionRules"))
                continue;
            const QString words = QRegularExpression::escape(message.source);
            known.emplace_back(QRegularExpression::anchoredPattern(
                QString(words).replace(number, QStringLiteral("[\\d:]+"))));
        }
        QStringList unknown;
        const QStringList sentences = sentencesOfTheGuide();
        QVERIFY(sentences.size() > 10);
        for (const QString& sentence : sentences)
            if (std::ranges::none_of(known, [&](const QRegularExpression& expression) {
                    return expression.match(sentence).hasMatch();
                }))
                unknown += sentence;
        QVERIFY2(unknown.isEmpty(), joined(unknown));
    }

    void theLanguagesOfTheLibraryAreOffered()
    {
        QCOMPARE(Language::available(),
            (QStringList{QStringLiteral("en"), QStringLiteral("de"), QStringLiteral("fr"),
                QStringLiteral("ja"), QStringLiteral("zh")}));
        QCOMPARE(Language::nativeName(QStringLiteral("de")), QStringLiteral("Deutsch"));
        QCOMPARE(Language::nativeName(QStringLiteral("zh")), QStringLiteral("简体中文"));
        QCOMPARE(Language::nativeName(QStringLiteral("en")), QStringLiteral("English"));
    }

    void numbersFollowTheLanguageAndComeBack()
    {
        const QLocale before;
        const Text aFolder = AXISCOMP_TEXT("Error", "it is a folder");
        {
            Language language(QStringLiteral("de"));
            QCOMPARE(QLocale().toString(1.5), QStringLiteral("1,5"));
            QCOMPARE(translated(aFolder), QStringLiteral("das ist ein Ordner"));
            language.select(QStringLiteral("en"));
            QCOMPARE(QLocale().toString(1.5), QStringLiteral("1.5"));
            QCOMPARE(translated(aFolder), QStringLiteral("it is a folder"));
            language.select({});
            QCOMPARE(QLocale(), before);
            language.select(QStringLiteral("de"));
        }
        QCOMPARE(QLocale(), before);
        QCOMPARE(translated(aFolder), QStringLiteral("it is a folder"));
    }

private:
    void addLanguages() const
    {
        QTest::addColumn<QString>("language");
        for (const QString& language : m_translations.keys())
            QTest::addRow("%s", qPrintable(language)) << language;
    }
    [[nodiscard]] const Messages& ofTheRow() const
    {
        QFETCH(const QString, language);
        return *m_translations.constFind(language);
    }

    test::SourceMessages m_sources;
    QMap<QString, Messages> m_translations;
};

AXISCOMP_TEST(TestTranslations)

} // namespace tst_translations

#include "tst_translations.moc"
