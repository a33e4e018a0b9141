// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program_run.h"

#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QFile>
#include <QRegularExpression>
#include <QSet>
#include <QTest>

namespace tst_usage {

using namespace axiscomp;
using test::ProgramRun;
using test::Sandbox;

namespace {

const QStringList commands{"example", "inspect", "convert", "lookup", "formats", "targets",
    "capture", "runs", "judge", "fit", "compare", "report", "axes", "status", "write", "persist",
    "unpersist", "delete", "evaluate", "activate", "deactivate", "read", "files", "upload",
    "download", "monitor", "backup", "restore", "recover", "config", "plan", "apply", "snapshot",
    "metrics", "doctor"};

QString sourceFile(const QString& name)
{
    QFile file(QStringLiteral(AXISCOMP_SOURCE_FOLDER "/") + name);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QSet<QString> longOptions(const QString& text)
{
    static const QRegularExpression option(QStringLiteral("--[a-z][a-z0-9-]*"));
    QSet<QString> found;
    for (auto matches = option.globalMatch(text); matches.hasNext();)
        found.insert(matches.next().captured());
    return found;
}

/// The options that a help text offers: those that begin a line of it.
QSet<QString> offeredOptions(const QByteArray& help)
{
    static const QRegularExpression option(
        QStringLiteral("^  (?:-[a-z], )?(--[a-z0-9-]+)"), QRegularExpression::MultilineOption);
    QSet<QString> found;
    for (auto matches = option.globalMatch(QString::fromUtf8(help)); matches.hasNext();)
        found.insert(matches.next().captured(1));
    return found;
}

/// Set comparison with a readable failure.
QByteArray difference(const QSet<QString>& a, const QSet<QString>& b)
{
    const QSet<QString> all = (a - b) + (b - a);
    return QStringList(all.begin(), all.end()).join(u' ').toUtf8();
}

QString manPage(const QString& page)
{
    QString text = sourceFile(QStringLiteral("packaging/man/") + page);
    return text.replace(QStringLiteral("\\-"), QStringLiteral("-"));
}

QSet<QString> manOptions(const QString& page)
{
    return longOptions(manPage(page));
}

QStringList sortedMatches(const QString& text, const QRegularExpression& pattern)
{
    QStringList found;
    for (auto matches = pattern.globalMatch(text); matches.hasNext();)
        found += matches.next().captured();
    found.sort();
    return found;
}

QSet<QString> completedOptions(const Sandbox& box, const QString& words)
{
    const QString script =
        QStringLiteral("source '" AXISCOMP_SOURCE_FOLDER "/packaging/completion/axiscomp.bash'; ")
        + words;
    const ProgramRun run = box.runProgram(QStringLiteral("/bin/bash"), {"-c", script});
    return longOptions(QString::fromUtf8(run.out));
}

} // namespace

class tst_Usage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void versionNamesTheProgram()
    {
        const Sandbox box;
        const ProgramRun run = box.run({"--version"});
        VERIFY_CODE(run, 0);
        QVERIFY(QRegularExpression("^axiscomp \\d+\\.\\d+\\.\\d+\n$").match(run.out).hasMatch());
        const ProgramRun drive = box.runProgram(test::virtualDriveProgram(), {"--version"});
        VERIFY_CODE(drive, 0);
        QVERIFY(drive.out.startsWith("axiscomp-virtualdrive "));
    }

    void helpListsEveryCommand()
    {
        const Sandbox box;
        const ProgramRun run = box.run({"--help"});
        VERIFY_CODE(run, 0);
        for (const QString& command : commands)
            QVERIFY2(run.out.contains("\n  " + command.toUtf8() + " "), qPrintable(command));
    }

    void helpFitsTheScreen()
    {
        const Sandbox box;
        for (const QString& command : commands) {
            const ProgramRun run = box.run({command, "--help"});
            VERIFY_CODE(run, 0);
            QCOMPARE(run.err, QByteArray());
            QVERIFY2(run.out.contains("usage: axiscomp " + command.toUtf8()), run.out.constData());
            for (const QByteArray& line : run.out.split('\n'))
                QVERIFY2(line.size() <= 100, line.constData());
        }
    }

    void theUsageTellsWhatMayBeMissingOrRepeated_data()
    {
        QTest::addColumn<QByteArray>("arguments");
        QTest::newRow("inspect") << QByteArray("FILE");
        QTest::newRow("judge") << QByteArray("FILE...");
        QTest::newRow("compare") << QByteArray("[BEFORE] AFTER");
        QTest::newRow("formats") << QByteArray("[NAME]");
        QTest::newRow("lookup") << QByteArray("FILE [X [Y [Z]]]");
    }
    void theUsageTellsWhatMayBeMissingOrRepeated()
    {
        QFETCH(const QByteArray, arguments);
        const QByteArray command = QTest::currentDataTag();
        const ProgramRun run = Sandbox().run({command, "--help"});
        VERIFY_CODE(run, 0);
        QVERIFY2(run.out.contains("usage: axiscomp " + command + " [options] " + arguments + "\n"),
            run.out.constData());
    }

    /// Behind -- a word is a file or a position, whatever it looks like; and in front of the
    /// command an option is none of it. "There is no option --dims; the nearest is --dims" helps
    /// nobody.
    void noOptionIsProposedThatWasTyped_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("reason");
        QTest::newRow("an option behind --")
            << QStringList{"inspect", "--dims", "1", "t.csv", "--", "--dims=1"}
            << QByteArray("nothing takes the argument --dims=1 (see axiscomp inspect --help)");
        QTest::newRow("the same in front of --, too")
            << QStringList{"inspect", "--dims=1", "t.csv", "--", "--dims=1"}
            << QByteArray("nothing takes the argument --dims=1 (see axiscomp inspect --help)");
        QTest::newRow("no option of the command behind --")
            << QStringList{"inspect", "t.csv", "--", "--dmis"}
            << QByteArray("nothing takes the argument --dmis (see axiscomp inspect --help)");
        QTest::newRow("a file behind --")
            << QStringList{"inspect", "--", "a.csv", "b.csv"}
            << QByteArray("nothing takes the argument b.csv (see axiscomp inspect --help)");
        QTest::newRow("in front of the command")
            << QStringList{"--json", "formats"}
            << QByteArray("--json is an option of formats: give it behind formats (see axiscomp "
                          "formats --help)");
        QTest::newRow("misspelled, with -- behind it")
            << QStringList{"inspect", "--dmis=1", "--", "t.csv"}
            << QByteArray("there is no option --dmis; the nearest is --dims (see axiscomp inspect "
                          "--help)");
    }
    void noOptionIsProposedThatWasTyped()
    {
        QFETCH(const QStringList, arguments);
        QFETCH(const QByteArray, reason);
        const ProgramRun run = Sandbox().run(arguments);
        VERIFY_CODE(run, 2);
        QCOMPARE(run.err, "error: InvalidArgument: " + reason + "\n");
    }

    void wrongUsageIsOneSentenceWithAHint_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("hint");
        QTest::newRow("nothing") << QStringList{} << QByteArray("(see axiscomp --help)");
        QTest::newRow("unknown command")
            << QStringList{"burn"} << QByteArray("no command burn (see axiscomp --help)");
        QTest::newRow("unknown option")
            << QStringList{"axes", "--drvie", "demo:"}
            << QByteArray(
                   "there is no option --drvie; the nearest is --drive (see axiscomp axes --help)");
        QTest::newRow("one argument too many")
            << QStringList{"write", "--drive", "demo:", "table.csv"}
            << QByteArray("nothing takes the argument table.csv (see axiscomp write --help)");
        QTest::newRow("missing argument")
            << QStringList{"inspect"} << QByteArray("(see axiscomp inspect --help)");
        QTest::newRow("missing value")
            << QStringList{"axes", "--drive"} << QByteArray("(see axiscomp axes --help)");
        QTest::newRow("not a number") << QStringList{"axes", "--drive", "demo:", "--timeout",
            "soon"} << QByteArray("(see axiscomp axes --help)");
        QTest::newRow("out of range") << QStringList{"axes", "--drive", "demo:", "--timeout", "-1"}
                                      << QByteArray("(see axiscomp axes --help)");
        QTest::newRow("dimensions")
            << QStringList{"example", "--dims", "4"} << QByteArray("(see axiscomp example --help)");
        QTest::newRow("both") << QStringList{"write", "--persistent", "--volatile"}
                              << QByteArray("(see axiscomp write --help)");
        QTest::newRow("no drive") << QStringList{"status"}
                                  << QByteArray("(see axiscomp status --help)");
        QTest::newRow("two drives") << QStringList{"status", "--drive", "demo:", "--drive", "demo:"}
                                    << QByteArray("(see axiscomp status --help)");
        QTest::newRow("nothing to write") << QStringList{"write", "--drive", "demo:"}
                                          << QByteArray("(see axiscomp write --help)");
        QTest::newRow("rate") << QStringList{"monitor", "--drive", "demo:", "--rate", "101"}
                              << QByteArray("(see axiscomp monitor --help)");
    }
    void wrongUsageIsOneSentenceWithAHint()
    {
        QFETCH(const QStringList, arguments);
        QFETCH(const QByteArray, hint);
        const Sandbox box;
        const ProgramRun run = box.run(arguments);
        VERIFY_CODE(run, 2);
        QVERIFY2(run.err.startsWith("error: InvalidArgument: "), run.err.constData());
        QVERIFY2(run.err.contains(hint), run.err.constData());
        QCOMPARE(run.err.count('\n'), 1);
        QCOMPARE(run.out, QByteArray());

        const ProgramRun json =
            box.run(arguments.mid(0, 1) + QStringList{"--json"} + arguments.mid(1));
        VERIFY_CODE(json, 2);
        const QJsonObject error = json.json().value("error").toObject();
        QCOMPARE(error.value("code").toString(), "InvalidArgument");
        QVERIFY(!error.value("message").toString().isEmpty());
    }

    void anOptionThatMayBeRepeatedTakesOneWordEachTime_data()
    {
        QTest::addColumn<QString>("program");
        QTest::addColumn<QStringList>("arguments");
        const QString axiscomp = test::axiscompProgram();
        const auto row = [&](const QStringList& arguments) {
            QTest::newRow(arguments.join(u' ').toUtf8().constData()) << axiscomp << arguments;
        };
        row({"axes", "--drive", "demo:"});
        row({"write", "--map", "X"});
        row({"plan", "m.toml", "--only", "X"});
        row({"inspect", "x.csv", "--set-in", "value-unit=um"});
        row({"convert", "x.csv", "y.csv", "--set-out", "value-unit=um"});
        row({"convert", "x.csv", "y.csv", "--target", "#1"});
        row({"convert", "x.csv", "y.csv", "--target", "#1,other", "--target", "other"});
        row({"convert", "x.csv", "y.csv", "--zero", "-10"});
        row({"convert", "x.csv", "y.csv", "--points", "11,9"});
        row({"convert", "x.csv", "y.csv", "--distance", "5"});
        QTest::newRow("virtual drive")
            << test::virtualDriveProgram() << QStringList{"--fault", "slow=1"};
    }
    void anOptionThatMayBeRepeatedTakesOneWordEachTime()
    {
        QFETCH(const QString, program);
        QFETCH(const QStringList, arguments);
        const Sandbox box;
        const ProgramRun run = box.runProgram(program, arguments + QStringList{"12"});
        VERIFY_CODE(run, 2);
        QVERIFY2(run.err.contains("nothing takes the argument 12 "), run.err.constData());
    }

    /// It is neither below nor above any limit.
    void whatIsNoNumberIsInNoRange_data()
    {
        QTest::addColumn<QString>("program");
        QTest::addColumn<QStringList>("arguments");
        const QString axiscomp = test::axiscompProgram();
        QTest::newRow("timeout") << axiscomp
                                 << QStringList{"axes", "--drive", "demo:", "--timeout"};
        QTest::newRow("rate") << axiscomp << QStringList{"monitor", "--drive", "demo:", "--rate"};
        for (const char* option : {"--window", "--dwell", "--rate"})
            QTest::addRow("capture %s", option)
                << axiscomp << QStringList{"capture", "--drive", "demo:", option};
        QTest::newRow("speed") << test::virtualDriveProgram() << QStringList{"--speed"};
        QTest::newRow("after") << test::virtualDriveProgram()
                               << QStringList{"--machine", "m.json", "--program", "p.csv",
                                      "--program-after"};
    }
    void whatIsNoNumberIsInNoRange()
    {
        QFETCH(const QString, program);
        QFETCH(const QStringList, arguments);
        const Sandbox box;
        for (const QString& value : QStringList{"nan", "inf"}) {
            const ProgramRun run = box.runProgram(program, arguments + QStringList{value});
            VERIFY_CODE(run, 2);
            const QByteArray reason = (arguments.last() + ": " + value + " is no number").toUtf8();
            QVERIFY2(run.err.contains(reason), run.err.constData());
        }
    }

    void anEmptyValueTakesNoOtherArgument_data()
    {
        QTest::addColumn<QString>("option");
        QTest::addColumn<QStringList>("before");
        QTest::newRow("runs") << "--output" << QStringList{"runs"};
        QTest::newRow("fit") << "--output" << QStringList{"fit", "--lookup-at", "encoder"};
        QTest::newRow("list") << "--exclude" << QStringList{"judge"};
    }
    void anEmptyValueTakesNoOtherArgument()
    {
        QFETCH(const QString, option);
        QFETCH(const QStringList, before);
        const Sandbox box;
        QFile data(QStringLiteral(AXISCOMP_SOURCE_FOLDER "/tests/data/metrology/b02_x.csv"));
        QVERIFY(data.open(QIODevice::ReadOnly));
        const QByteArray content = data.readAll();
        const QString a = box.file("a.csv", content);
        const QString b = box.file("b.csv", content);
        const ProgramRun run = box.run(before + QStringList{option + "=", a, b});
        VERIFY_CODE(run, 2);
        const QByteArray reason =
            (option + " has no value after the = (see axiscomp " + before.first() + " --help)")
                .toUtf8();
        QVERIFY2(run.err.contains(reason), run.err.constData());
        QCOMPARE(box.content("a.csv"), content);
    }

    void wrongEndpointsAreNamedWithoutThePassword_data()
    {
        QTest::addColumn<QString>("endpoint");
        QTest::newRow("scheme") << "ftp://user:secret@drive";
        QTest::newRow("path") << "http://user:secret@drive/x";
        QTest::newRow("nothing") << "http://";
        QTest::newRow("serial") << "serial:ttyUSB0";
    }
    void wrongEndpointsAreNamedWithoutThePassword()
    {
        QFETCH(const QString, endpoint);
        const Sandbox box;
        const ProgramRun run = box.run({"axes", "--drive", endpoint});
        VERIFY_CODE(run, 2);
        QVERIFY2(run.err.startsWith("error: InvalidEndpoint: "), run.err.constData());
        QVERIFY2(!run.err.contains("secret"), run.err.constData());
    }

    void completionAndManPageHaveTheOptionsOfEveryCommand()
    {
        const Sandbox box;
        QSet<QString> all = offeredOptions(box.run({"--help"}).out);
        QCOMPARE(difference(completedOptions(box, "_axiscomp_options ''"), all), QByteArray());
        for (const QString& command : commands) {
            const QSet<QString> offered = offeredOptions(box.run({command, "--help"}).out);
            QVERIFY(offered.contains("--help"));
            QVERIFY(offered.contains("--json"));
            const QByteArray wrong =
                difference(completedOptions(box, "_axiscomp_options " + command), offered);
            QVERIFY2(wrong.isEmpty(), qPrintable(command + ": " + wrong));
            all += offered;
        }
        QCOMPARE(difference(manOptions("axiscomp.1"), all), QByteArray());
    }

    void completionKnowsTheCommands()
    {
        const Sandbox box;
        const ProgramRun run = box.runProgram(QStringLiteral("/bin/bash"),
            {"-c",
                "source '" AXISCOMP_SOURCE_FOLDER "/packaging/completion/axiscomp.bash'; "
                "echo $_axiscomp_commands"});
        const QStringList known = QString::fromUtf8(run.out).simplified().split(u' ');
        QCOMPARE(known.size(), commands.size());
        QCOMPARE(difference({known.begin(), known.end()}, {commands.begin(), commands.end()}),
            QByteArray());
    }

    void theManPagesOfEveryLanguageHaveTheCommands()
    {
        for (const QString& name : QStringList{"axiscomp.1", "de/axiscomp.1"}) {
            const QString page = manPage(name);
            for (const QString& command : commands)
                QVERIFY2(page.contains(QRegularExpression(
                             "\n\\.TP\n\\.(B|BI|BR) \"?([^\n]*, \" )?" + command + "\\b")),
                    qPrintable(name + ": " + command));
        }
    }

    /// Translated page by page: the same options as often, the same commands, codes and files, and
    /// as many entries.
    void theGermanPagesHaveWhatTheEnglishOnesHave_data()
    {
        QTest::addColumn<QString>("page");
        for (const char* page :
            {"axiscomp.1", "axiscomp-virtualdrive.1", "axis-compensation-wizard.1"})
            QTest::newRow(page) << QString::fromLatin1(page);
    }
    void theGermanPagesHaveWhatTheEnglishOnesHave()
    {
        QFETCH(const QString, page);
        const QString english = manPage(page);
        const QString german = manPage("de/" + page);
        QVERIFY(english.size() > 1000 && german.size() > 1000);
        static const QRegularExpression named(
            QStringLiteral("--[a-z][a-z0-9-]*|^\\.(?:TP|SH)|^\\.B[IR]? \"?[a-z]+(?=[ \"]|$)"
                           "|^\\.B \\d+$|/usr/share/[a-z/.\\\\-]+"),
            QRegularExpression::MultilineOption);
        QCOMPARE(sortedMatches(german, named), sortedMatches(english, named));
    }

    void completionAndManPageHaveTheOptionsOfTheVirtualDrive()
    {
        const Sandbox box;
        const QSet<QString> offered =
            offeredOptions(box.runProgram(test::virtualDriveProgram(), {"--help"}).out);
        QVERIFY(offered.contains("--http"));
        QCOMPARE(difference(completedOptions(box, "echo $_axiscomp_virtualdrive_options"), offered),
            QByteArray());
        QCOMPARE(difference(manOptions("axiscomp-virtualdrive.1"), offered), QByteArray());
    }
};

AXISCOMP_TEST(tst_Usage)

} // namespace tst_usage

#include "tst_usage.moc"
