// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/common/help_page.h"
#include "tests/app/program_run.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QSet>
#include <QTest>
#include <QTranslator>

namespace tst_helptexts {

using namespace axiscomp;
using namespace axiscomp::app;
using test::ProgramRun;
using test::Sandbox;

namespace {

/// Sentences, and headings of examples.
QStringList partsOfFooter(const std::string& footer)
{
    QStringList parts;
    for (const QString& paragraph : QString::fromStdString(footer).split(QStringLiteral("\n\n")))
        parts += paragraph.section(u'\n', 0, 0);
    return parts;
}

/// All that `axiscomp --help` and the help of each command can show but for what is typed.
QSet<QString> shownTexts()
{
    CommandLine line;
    QSet<QString> texts;
    const auto take = [&](const CLI::App& app) {
        texts.insert(QString::fromStdString(app.get_description()));
        for (const QString& part : partsOfFooter(app.get_footer()))
            texts.insert(part);
        for (const CLI::Option* option : app.get_options()) {
            texts.insert(QString::fromStdString(option->get_description()));
            if (option->nonpositional())
                texts.insert(QString::fromStdString(option->get_group()));
        }
    };
    take(line.parser());
    for (const CLI::App* command : line.parser().get_subcommands({})) {
        texts.insert(QString::fromStdString(command->get_group()));
        take(*command);
    }
    texts.remove(QString());
    return texts;
}

QByteArray helpIn(const QString& locale, const QString& language = {})
{
    Sandbox box;
    box.setVariable(QStringLiteral("LC_ALL"), locale);
    box.setVariable(QStringLiteral("LANGUAGE"), language);
    return box.run({"--help"}).out;
}

QString lines(const QString& text, std::size_t width, std::size_t indent = 0)
{
    return QString::fromStdString(wrapped(text.toStdString(), width, indent));
}

} // namespace

class tst_HelpTexts : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void everyTextOfTheHelpIsInEveryLanguage()
    {
        const QSet<QString> texts = shownTexts();
        QVERIFY(texts.size() > 200);
        for (const std::string& language : textLanguages()) {
            if (language == "en")
                continue;
            QTranslator translator;
            QVERIFY(translator.load(QStringLiteral("axiscomp_") + QString::fromStdString(language),
                QStringLiteral(":/axiscomp-texts")));
            QStringList missing;
            for (const QString& text : texts) {
                if (translator.translate("Help", text.toUtf8().constData()).isEmpty())
                    missing += text;
            }
            QVERIFY2(missing.isEmpty(),
                ("mark them with AXISCOMP_HELP and translate into " + language + ":\n"
                    + missing.join(u'\n').toStdString())
                    .c_str());
        }
    }

    void theEnvironmentChoosesTheLanguage_data()
    {
        QTest::addColumn<QString>("locale");
        QTest::addColumn<QString>("language");
        QTest::addColumn<bool>("isGerman");
        QTest::newRow("German") << "de_DE.UTF-8"
                                << "" << true;
        QTest::newRow("German of Switzerland") << "de_CH.utf8"
                                               << "" << true;
        QTest::newRow("list of languages") << "en_US.UTF-8"
                                           << "xx:de" << true;
        QTest::newRow("C, whatever the list says") << "C.UTF-8"
                                                   << "de" << false;
        QTest::newRow("not UTF-8") << "de_DE.ISO-8859-1"
                                   << "" << false;
        QTest::newRow("without an encoding") << "de_DE"
                                             << "" << false;
        QTest::newRow("a language that there is none for") << "fi_FI.UTF-8"
                                                           << "" << false;
        QTest::newRow("English before German") << "de_DE.UTF-8"
                                               << "en:de" << false;
    }
    void theEnvironmentChoosesTheLanguage()
    {
        QFETCH(const QString, locale);
        QFETCH(const QString, language);
        QFETCH(const bool, isGerman);
        const QByteArray help = helpIn(locale, language);
        QCOMPARE(help.contains("Eine Tabelle") || help.contains("Antriebe:"), isGerman);
        QCOMPARE(help.contains("Drives:"), !isGerman);
    }

    void whatIsTypedIsTheSameInEveryLanguage()
    {
        for (const std::string& language : textLanguages()) {
            Sandbox box;
            box.setVariable(QStringLiteral("LC_ALL"),
                QString::fromStdString(language) + QStringLiteral("_XX.UTF-8"));
            const ProgramRun run = box.run({"write", "--help"});
            VERIFY_CODE(run, 0);
            for (const char* typed :
                {"\n  axiscomp write --drive http", "\n  --own-position", "\n  --source1 REG"})
                QVERIFY2(run.out.contains(typed), (language + ": " + typed).c_str());
        }
    }

    void linesEndWithinTheWidth()
    {
        QCOMPARE(lines("one two three", 7), "one two\nthree");
        QCOMPARE(lines("one two", 8, 4), "one\n    two");
        QCOMPARE(lines("a-word-that-is-longer", 5), "a-word-that-is-longer");
        // Two columns each, and a line may end behind each.
        QCOMPARE(lines("一二三四五六", 8), "一二三四\n五六");
        QCOMPARE(lines("軸 X の値", 6), "軸 X\nの値");
        // A full stop does not begin a line.
        QCOMPARE(lines("一二三。四", 6), "一二\n三。四");
        QCOMPARE(lines("文件（--axis）", 9), "文件\n（--axis）");
    }
};

AXISCOMP_TEST(tst_HelpTexts)

} // namespace tst_helptexts

#include "tst_helptexts.moc"
