// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"
#include "tests/ui/support/source_messages.h"
#include "ui/text/language.h"
#include "ui/text/translated_text.h"

#include <QHash>
#include <QRegularExpression>
#include <QTest>

namespace tst_translations {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::Message;

namespace {

const QString sources = QStringLiteral(AXISCOMP_SOURCE_FOLDER);

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

} // namespace

class TestTranslations : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        m_sources = test::findSourceMessages();
        for (const Message& message : test::readTranslationFile(germanFile()))
            m_german.insert(message.id(), message);
        QVERIFY(m_sources.messages.size() > 1500);
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
                // The form for one may say the number in words.
                const bool isForOne = message.isCounted && text == message.translations.front();
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

    void theLanguagesOfTheLibraryAreOffered()
    {
        QCOMPARE(Language::available(), (QStringList{QStringLiteral("en"), QStringLiteral("de")}));
        QCOMPARE(Language::nativeName(QStringLiteral("de")), QStringLiteral("Deutsch"));
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
    test::SourceMessages m_sources;
    QHash<QString, Message> m_german;
};

AXISCOMP_TEST(TestTranslations)

} // namespace tst_translations

#include "tst_translations.moc"
