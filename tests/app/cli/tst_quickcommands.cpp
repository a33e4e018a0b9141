// SPDX-License-Identifier: GPL-3.0-or-later
// The commands that the program has in it, and the same ones of the module that has all commands: a
// language that there are no texts in is shown in English, by the module.
#include "app/cli/start/program_module.h"
#include "tests/app/program_run.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTest>

namespace tst_quickcommands {

using namespace axiscomp;
using test::ProgramRun;
using test::Sandbox;

namespace {

const QByteArray measurement = "// compensation: off\n"
                               "target [mm],direction,run,deviation [um]\n"
                               "0,+,1,0.2\n10,+,1,1.1\n0,-,1,-0.4\n10,-,1,0.5\n"
                               "0,+,2,0.3\n10,+,2,1.0\n0,-,2,-0.3\n10,-,2,0.6\n";

/// A sandbox with files that the commands read, in this language.
struct Bench {
    explicit Bench(const QString& locale)
    {
        box.setVariable(QStringLiteral("LC_ALL"), locale);
        box.file(QStringLiteral("t.csv"), "X [mm],dX [um]\n0,0\n10,1.5\n20,-0.25\n");
        box.file(QStringLiteral("uneven.csv"), "X [mm],dX [um]\n0,0\n10,1.5\n25,-0.25\n");
        box.file(QStringLiteral("runs.csv"), measurement);
    }
    /// Its folder is another one each time.
    [[nodiscard]] ProgramRun run(const QStringList& arguments) const
    {
        QStringList inFolder;
        for (const QString& argument : arguments)
            inFolder += argument.contains(u'.') ? box.path(argument) : argument;
        ProgramRun run = box.run(inFolder);
        run.out.replace(box.path().toUtf8(), "FOLDER");
        run.err.replace(box.path().toUtf8(), "FOLDER");
        return run;
    }

    Sandbox box;
};

/// The libraries that a program needs before its first line.
QByteArray librariesOf(const QString& program)
{
    Sandbox box;
    return box.runProgram(QStringLiteral("ldd"), {program}).out;
}

} // namespace

class tst_QuickCommands : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theySayWhatTheModuleSays_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("made");
        const auto row = [](const char* arguments, const char* made = "") {
            QTest::newRow(arguments)
                << QString::fromLatin1(arguments).split(u' ') << QString::fromLatin1(made);
        };
        row("--version");
        row("example --dims 1 -o e.csv", "e.csv");
        row("inspect t.csv");
        row("inspect t.csv --json");
        row("inspect uneven.csv");
        row("inspect missing.csv");
        row("convert t.csv t.TAMtbl --dims 1", "t.TAMtbl");
        row("convert t.csv t.TAMtbl --dims 1 --json", "t.TAMtbl");
        row("convert t.csv t.g --to siemens");
        row("convert --help");
        row("convert --nonsense");
        row("lookup t.csv 5");
        row("formats");
        row("formats --json");
        row("formats --measurements");
        row("targets --from 0 --to 100 --count 5 --axis X");
        row("runs runs.csv");
        row("judge runs.csv");
        row("judge runs.csv --json");
    }
    void theySayWhatTheModuleSays()
    {
        QFETCH(const QStringList, arguments);
        QFETCH(const QString, made);
        const Bench quick(QStringLiteral("C.UTF-8"));
        const Bench module(QStringLiteral("fi_FI.UTF-8"));
        const ProgramRun ours = quick.run(arguments);
        const ProgramRun theirs = module.run(arguments);
        QCOMPARE(ours.out, theirs.out);
        QCOMPARE(ours.err, theirs.err);
        QCOMPARE(ours.code, theirs.code);
        QVERIFY(!ours.out.isEmpty() || !ours.err.isEmpty());
        if (!made.isEmpty()) {
            QVERIFY(!quick.box.content(made).isEmpty());
            QCOMPARE(quick.box.content(made), module.box.content(made));
        }
    }

    void aLanguageIsTheModules()
    {
        const Bench german(QStringLiteral("de_DE.UTF-8"));
        const ProgramRun run = german.run({QStringLiteral("convert"), QStringLiteral("--help")});
        VERIFY_CODE(run, 0);
        QVERIFY2(run.out.contains("Diese Hilfe zeigen"), run.out.constData());
    }

    void theProgramNeedsNothingOfQtToStart()
    {
        const QByteArray program = librariesOf(test::axiscompProgram());
        QVERIFY2(program.contains("libstdc++"), program.constData());
        QVERIFY2(!program.contains("Qt6"), program.constData());
        const QString module = QFileInfo(test::axiscompProgram())
                                   .dir()
                                   .filePath(QLatin1StringView(app::programModuleName));
        QVERIFY(librariesOf(module).contains("Qt6Core"));
    }

    void withoutItsModuleItSaysThatItIsNotAllThere()
    {
        Sandbox box;
        const QString alone = box.path(QStringLiteral("axiscomp"));
        QVERIFY(QFile::copy(test::axiscompProgram(), alone));
        VERIFY_CODE(box.runProgram(alone, {QStringLiteral("--version")}), 0);
        const ProgramRun run = box.runProgram(alone, {QStringLiteral("axes")});
        VERIFY_CODE(run, 3);
        QVERIFY2(run.err.contains("axiscomp-program.so cannot be read: axiscomp is not installed "
                                  "completely (")
                && run.err.contains("No such file or directory); install it again"),
            run.err.constData());
    }

    void aModuleThatCannotBeLoadedSaysWhy()
    {
        Sandbox box;
        const QString program = box.path(QStringLiteral("axiscomp"));
        QVERIFY(QFile::copy(test::axiscompProgram(), program));
        box.file(QLatin1StringView(app::programModuleName), "this is no module\n");
        const ProgramRun run = box.runProgram(program, {QStringLiteral("axes")});
        VERIFY_CODE(run, 3);
        QVERIFY2(run.err.contains("axiscomp-program.so: file too short); install it again"),
            run.err.constData());
    }
};

AXISCOMP_TEST(tst_QuickCommands)

} // namespace tst_quickcommands

#include "tst_quickcommands.moc"
