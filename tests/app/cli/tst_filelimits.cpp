// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program_run.h"

#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QFile>
#include <QTest>

namespace tst_filelimits {

using namespace axiscomp;
using test::ProgramRun;
using test::Sandbox;

/// What a file may have at most is said before any of it is read.
class tst_FileLimits : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aFileThatIsTooLargeIsRefused_data()
    {
        QTest::addColumn<QStringList>("command");
        QTest::addColumn<QString>("file");
        QTest::addColumn<qint64>("limit");
        constexpr qint64 mebibyte = 1 << 20;
        QTest::newRow("table") << QStringList{"inspect", "large.TAMtbl"} << "large.TAMtbl"
                               << 64 * mebibyte;
        QTest::newRow("backup") << QStringList{"restore", "--drive", "demo:", "backup.json"}
                                << "backup.json" << 128 * mebibyte;
        QTest::newRow("upload") << QStringList{"upload", "--drive", "demo:", "any.bin", "--to",
            "tables/small1.TAMtbl"}
                                << "any.bin" << 64 * mebibyte;
        QTest::newRow("profile") << QStringList{"axes", "--drive", "demo:", "--profile", "p.json"}
                                 << "p.json" << mebibyte;
    }
    void aFileThatIsTooLargeIsRefused()
    {
        QFETCH(const QStringList, command);
        QFETCH(const QString, file);
        QFETCH(const qint64, limit);
        const Sandbox box;
        QFile sparse(box.path(file));
        QVERIFY(sparse.open(QIODevice::WriteOnly) && sparse.resize(limit + 1));
        const ProgramRun run = box.run(command);
        VERIFY_CODE(run, 3);
        QVERIFY2(run.err.startsWith("error: FileTooLarge: "), run.err.constData());
        QVERIFY2(run.err.contains(QByteArray::number(limit)), run.err.constData());
    }

    void aCalibrationThatIsTooLargeIsADiagnostic()
    {
        const Sandbox box;
        QFile sparse(box.path("large.csv"));
        QVERIFY(sparse.open(QIODevice::WriteOnly) && sparse.resize((qint64{1} << 30) + 1));
        const ProgramRun run = box.run({"inspect", "large.csv", "--dims", "1"});
        VERIFY_CODE(run, 3);
        QVERIFY2(run.err.contains("1073741824 bytes"), run.err.constData());
    }

    void aPointThatIsTooLongIsRefused()
    {
        const Sandbox box;
        box.file("t.csv", "X,T\n0,0.1\n1000,0.2\n");
        box.file("points.txt", "1\n" + QByteArray(64 * 1024 + 1, '1'));
        const ProgramRun run =
            box.run({"lookup", "t.csv", "--dims", "1", "--points", "points.txt"});
        VERIFY_CODE(run, 3);
        QVERIFY2(run.err.contains("points.txt:2:1: error: "), run.err.constData());
    }

    void standardInputIsLimitedToo()
    {
        const Sandbox box;
        const ProgramRun run = box.runProgram("/bin/sh",
            {"-c", "head -c 67108865 /dev/zero | exec \"$0\" inspect - --from tamtbl",
                test::axiscompProgram()});
        VERIFY_CODE(run, 3);
        QVERIFY2(run.err.startsWith("error: FileTooLarge: "), run.err.constData());
    }

    void aPasswordFileIsALine()
    {
        const Sandbox box;
        box.file("password", QByteArray(4097, 'x'));
        const ProgramRun run = box.runProgram(
            test::virtualDriveProgram(), {"--user", "anna", "--password-file", "password"});
        VERIFY_CODE(run, 3);
        QVERIFY2(run.err.startsWith("error: FileTooLarge: "), run.err.constData());
    }
};

AXISCOMP_TEST(tst_FileLimits)

} // namespace tst_filelimits

#include "tst_filelimits.moc"
