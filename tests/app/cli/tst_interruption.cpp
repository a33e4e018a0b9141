// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program_run.h"

#include "tests/support/changed_backup.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QJsonArray>
#include <QTest>
#include <QUrl>

#include <csignal>
#include <filesystem>

namespace tst_interruption {

using namespace axiscomp;
using test::ProgramRun;
using test::Sandbox;
using test::VirtualDriveProcess;

namespace {

const QByteArray oldTable = "X,T\n0,0\n50,0.001\n100,0.003\n";
const QByteArray newTable = "X,T\n0,0\n50,0.002\n100,0.001\n";
const QString newSource = QStringLiteral("Axes[0]/Signals/PositionController/MasterPosition");

/// What a write must leave whole: the table, its source and its persistency.
struct AxisState {
    qint64 crc = 0;
    QString source;
    bool persistent = false;

    friend bool operator==(const AxisState&, const AxisState&) = default;
};

AxisState stateOf(const QJsonObject& status)
{
    return {status.value("table").toObject().value("crc").toInteger(),
        status.value("sources").toArray().at(0).toString(), status.value("persistent").toBool()};
}

/// The same drive with the same flash at the same address, quick or slow.
QStringList driveOptions(const QString& url, const char* fault)
{
    QStringList options{"--state", "flash"};
    if (!url.isEmpty())
        options << "--http" << QStringLiteral("127.0.0.1:%1").arg(QUrl(url).port());
    if (fault)
        options << "--fault" << fault;
    return options;
}

/// An axis with an old, stored table.
struct Fixture {
    Sandbox box;
    AxisState before;
    AxisState after;

    Fixture()
    {
        box.file("old.csv", oldTable);
        box.file("new.csv", newTable);
    }
    /// With what has been prepared: the drive's flash and what the program remembers of it.
    explicit Fixture(const Fixture& prepared) : Fixture()
    {
        before = prepared.before;
        after = prepared.after;
        for (const char* folder : {"flash", "state"})
            std::filesystem::copy(prepared.box.path(folder).toStdString(),
                box.path(folder).toStdString(), std::filesystem::copy_options::recursive);
    }

    /// Learns on a quick drive how the axis looks before and after, and leaves it in the old state.
    [[nodiscard]] bool prepare()
    {
        const VirtualDriveProcess quick(box, driveOptions({}, nullptr));
        const QString url = quick.url();
        const bool isNew = write(url, "new.csv", newSource).code == 0;
        after = stateOf(status(url).json());
        const bool isOld = write(url, "old.csv", test::positionSource(0)).code == 0;
        before = stateOf(status(url).json());
        return isNew && isOld && before.crc != after.crc && before.source != after.source;
    }

    [[nodiscard]] static QStringList writeArguments(
        const QString& url, const QString& file, const QString& source)
    {
        return {"write", "--drive", url, "--axis", "0", "--data", file, "--dims", "1", "--source1",
            source, "--persistent"};
    }
    [[nodiscard]] ProgramRun write(
        const QString& url, const QString& file, const QString& source) const
    {
        return box.run(writeArguments(url, file, source));
    }
    [[nodiscard]] ProgramRun status(const QString& url) const
    {
        return box.run({"status", "--drive", url, "--axis", "0", "--json"});
    }
    /// Starts the new write and returns when so many of its steps have ended.
    [[nodiscard]] std::unique_ptr<QProcess> startWrite(
        const QString& url, int steps, const QStringList& more = {}) const
    {
        auto process =
            box.start(test::axiscompProgram(), writeArguments(url, "new.csv", newSource) + more);
        QByteArray said;
        while (said.count("  ok ") < steps && process->waitForReadyRead(test::patienceMs))
            said += process->readAllStandardOutput();
        return process;
    }
    /// The same, killed then.
    [[nodiscard]] bool killWrite(const QString& url, int steps, const QStringList& more = {}) const
    {
        const auto process = startWrite(url, steps, more);
        process->kill();
        return process->waitForFinished(test::patienceMs);
    }
};

void addSteps()
{
    QTest::addColumn<int>("steps");
    QTest::newRow("plan made") << 1;
    QTest::newRow("backup kept") << 2;
    QTest::newRow("table uploaded") << 3;
    QTest::newRow("table verified") << 4;
    QTest::newRow("table stored") << 5;
    QTest::newRow("switched over") << 6;
}

} // namespace

class tst_Interruption : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(m_prepared.prepare()); }
    void init() { test::failOnWarnings(); }

    void interruptLeavesTheOldStateOrTheNewOne_data() { addSteps(); }
    void interruptLeavesTheOldStateOrTheNewOne()
    {
        QFETCH(const int, steps);
        const Fixture bench(m_prepared);
        const VirtualDriveProcess slow(bench.box, driveOptions({}, "slow=15"));
        QVERIFY(slow.isReady());
        const QString url = slow.url();
        const auto process = bench.startWrite(url, steps);
        ::kill(static_cast<pid_t>(process->processId()), SIGINT);
        ::kill(static_cast<pid_t>(process->processId()), SIGINT);
        QVERIFY(process->waitForFinished(test::patienceMs));
        QCOMPARE(process->exitStatus(), QProcess::NormalExit);
        const QByteArray err = process->readAllStandardError();
        const ProgramRun status = bench.status(url);
        VERIFY_CODE(status, 0);
        const AxisState now = stateOf(status.json());
        // Only a write that was complete already may end as if nothing had happened.
        if (process->exitCode() == 0) {
            QCOMPARE(steps, 6);
            QVERIFY(now == bench.after);
            return;
        }
        QVERIFY2(process->exitCode() == 130, err.constData());
        QVERIFY2(err.contains("stopping: what was changed is being put back"), err.constData());
        QVERIFY2(err.contains("error: Cancelled: stopped by the user"), err.constData());
        QVERIFY2(err.contains("the drive holds the complete old state"), err.constData());
        QVERIFY(now == bench.before);
        QVERIFY(!status.json().contains("unfinishedWrite"));
    }

    void aWriteThatAnotherProgramIsDoingIsNotCalledUnfinished()
    {
        const Fixture bench(m_prepared);
        const VirtualDriveProcess slow(bench.box, driveOptions({}, "slow=15"));
        QVERIFY(slow.isReady());
        const QString url = slow.url();
        const auto process = bench.startWrite(url, 3);
        const auto pid = static_cast<pid_t>(process->processId());
        ::kill(pid, SIGSTOP);
        const ProgramRun during = bench.status(url);
        const ProgramRun recover =
            bench.box.run({QStringLiteral("recover"), QStringLiteral("--drive"), url,
                QStringLiteral("--axis"), QStringLiteral("0"), QStringLiteral("--json")});
        process->kill();
        QVERIFY(process->waitForFinished(test::patienceMs));
        VERIFY_CODE(during, 0);
        QVERIFY2(!during.json().contains("unfinishedWrite"), during.text().constData());
        QCOMPARE(during.json().value("isBeingWritten").toBool(), true);
        QVERIFY2(during.err.contains("another program is writing"), during.err.constData());
        VERIFY_CODE(recover, 0);
        QVERIFY2(recover.json().value("unfinishedWrite").isNull(), recover.text().constData());
        QCOMPARE(recover.json().value("isBeingWritten").toBool(), true);
        // Once that program has gone without ending it, it is.
        const ProgramRun after = bench.status(url);
        VERIFY_CODE(after, 0);
        QVERIFY2(after.json().contains("unfinishedWrite"), after.text().constData());
        QCOMPARE(after.json().value("isBeingWritten").toBool(), false);
    }

    void killedProgramIsExplainedByTheNextRun_data() { addSteps(); }
    void killedProgramIsExplainedByTheNextRun()
    {
        QFETCH(const int, steps);
        const Fixture bench(m_prepared);
        const VirtualDriveProcess slow(bench.box, driveOptions({}, "slow=15"));
        QVERIFY(slow.isReady());
        const QString url = slow.url();
        QVERIFY(bench.killWrite(url, steps));
        checkNextRun(bench, url, steps == 6);
    }

    void killedWriteIsFinishedOrUndone_data()
    {
        QTest::addColumn<int>("steps");
        QTest::addColumn<QString>("option");
        for (const int steps : {3, 4, 5, 6}) {
            for (const char* option : {"--finish", "--undo"})
                QTest::addRow("after step %d, %s", steps, option) << steps << option;
        }
    }
    void killedWriteIsFinishedOrUndone()
    {
        QFETCH(const int, steps);
        QFETCH(const QString, option);
        const Fixture bench(m_prepared);
        const VirtualDriveProcess slow(bench.box, driveOptions({}, "slow=15"));
        QVERIFY(slow.isReady());
        const QString url = slow.url();
        QVERIFY(bench.killWrite(url, steps));
        const QStringList recover{QStringLiteral("recover"), QStringLiteral("--drive"), url,
            QStringLiteral("--axis"), QStringLiteral("0"), QStringLiteral("--json")};
        const ProgramRun said = bench.box.run(recover);
        VERIFY_CODE(said, 0);
        if (said.json().value("unfinishedWrite").isNull()
            || said.json().value("unfinishedWrite").toObject().value("driveHolds") == "New")
            return; // it had ended before the program was killed
        QVERIFY2(said.json().value("finishObstacle").isNull(), said.text().constData());
        QVERIFY2(said.json().value("undoObstacle").isNull(), said.text().constData());
        QCOMPARE(said.json().value("isBeingWritten"), QJsonValue(false));
        for (const char* const cost : {"finishFlashOperations", "undoFlashOperations"})
            QVERIFY2(said.json().value(QLatin1String(cost)).isDouble(), said.text().constData());
        QStringList inText = recover;
        inText.removeAll(QStringLiteral("--json"));
        const ProgramRun done = bench.box.run(inText + QStringList{option});
        VERIFY_CODE(done, 0);
        QVERIFY2(!done.out.contains("  failed  "), done.out.constData());
        const ProgramRun status = bench.status(url);
        QVERIFY2(status.err.isEmpty(), status.err.constData());
        const AxisState wanted = option == QStringLiteral("--finish") ? bench.after : bench.before;
        QVERIFY2(stateOf(status.json()) == wanted, status.text().constData());
        const ProgramRun again = bench.box.run(recover + QStringList{option});
        VERIFY_CODE(again, 0);
        QVERIFY2(again.json().value("unfinishedWrite").isNull(), again.text().constData());
    }

    void aDoubtIsSaidBeforeAWriteIsFinishedOrUndone_data()
    {
        QTest::addColumn<QString>("option");
        QTest::newRow("finish") << QStringLiteral("--finish");
        QTest::newRow("undo") << QStringLiteral("--undo");
    }
    void aDoubtIsSaidBeforeAWriteIsFinishedOrUndone()
    {
        QFETCH(const QString, option);
        const Fixture bench(m_prepared);
        const VirtualDriveProcess slow(bench.box, driveOptions({}, "slow=15"));
        QVERIFY(slow.isReady());
        const QString url = slow.url();
        QVERIFY(bench.killWrite(url, 3));
        const QString backup =
            bench.status(url).json().value("unfinishedWrite").toObject().value("backup").toString();
        test::nameInBackup(backup.toStdString(), "Gantry");
        const QString doubt = QStringLiteral("Axis 0 was called Gantry when the backup was made");
        const QStringList recover{"recover", "--drive", url, "--axis", "0", "--json"};
        for (const QStringList& command : {recover, recover + QStringList{option}}) {
            const ProgramRun said = bench.box.run(command);
            VERIFY_CODE(said, 0);
            const QJsonArray doubts = said.json().value("doubts").toArray();
            QCOMPARE(doubts.size(), 1);
            QVERIFY2(doubts.at(0).toString().startsWith(doubt), said.text().constData());
            QVERIFY2(said.err.contains("warning: " + doubt.toUtf8()), said.text().constData());
        }
        const ProgramRun nothing = bench.box.run(recover);
        VERIFY_CODE(nothing, 0);
        QCOMPARE(nothing.json().value("doubts"), QJsonValue(QJsonArray()));
    }

    /// In the slot of the old table, which the axis does not use until the new one is there.
    void halfOfAWriteIsNoStateToKeep()
    {
        const Fixture bench(m_prepared);
        const VirtualDriveProcess slow(bench.box, driveOptions({}, "slow=15"));
        QVERIFY(slow.isReady());
        const QString url = slow.url();
        const QString slot = bench.status(url).json().value("slot").toString();
        QVERIFY(bench.killWrite(url, 4, {"--slot", slot}));
        const ProgramRun status = bench.status(url);
        QCOMPARE(status.json().value("unfinishedWrite").toObject().value("driveHolds").toString(),
            QStringLiteral("Neither"));
        const ProgramRun snapshot = bench.box.run({"snapshot", "--drive", url, "-o", "folder"});
        VERIFY_CODE(snapshot, 6);
        QVERIFY2(snapshot.err.contains("axiscomp recover --undo"), snapshot.err.constData());
        QVERIFY(!QFile::exists(bench.box.path("folder")));
        const QByteArray half = "warning: a write that did not end has left axis 0 in neither";
        const ProgramRun backup = bench.box.run({"backup", "--drive", url, "-o", "drive.json"});
        VERIFY_CODE(backup, 0);
        QVERIFY2(backup.err.startsWith(half), backup.err.constData());
        QVERIFY(!bench.box.content("drive.json").isEmpty());
        const ProgramRun restore =
            bench.box.run({"restore", "drive.json", "--drive", url, "--dry-run"});
        QVERIFY2(restore.err.contains("did not end"), restore.err.constData());
        VERIFY_CODE(bench.box.run({"recover", "--drive", url, "--axis", "0", "--undo"}), 0);
        QVERIFY(stateOf(bench.status(url).json()) == bench.before);
        VERIFY_CODE(bench.box.run({"snapshot", "--drive", url, "-o", "folder"}), 0);
    }

    void aWriteWhoseBackupIsGoneIsSwitchedOffAndWrittenAgain()
    {
        const Fixture bench(m_prepared);
        const VirtualDriveProcess slow(bench.box, driveOptions({}, "slow=15"));
        QVERIFY(slow.isReady());
        const QString url = slow.url();
        QVERIFY(bench.killWrite(url, 3));
        const QStringList axis{"--drive", url, "--axis", "0"};
        const QString backup =
            bench.status(url).json().value("unfinishedWrite").toObject().value("backup").toString();
        QVERIFY2(QFile::remove(backup), qPrintable(backup));
        const ProgramRun status = bench.status(url);
        VERIFY_CODE(status, 0);
        QCOMPARE(status.json().value("unfinishedWrite").toObject().value("driveHolds").toString(),
            QStringLiteral("Unknown"));
        const ProgramRun said = bench.box.run(QStringList{"recover"} + axis);
        VERIFY_CODE(said, 0);
        for (const char* const part :
            {"Which state the drive holds is not known", "`axiscomp write`", "not possible now"})
            QVERIFY2(said.out.contains(part), said.out.constData());
        VERIFY_CODE(bench.box.run(QStringList{"activate"} + axis), 6);
        VERIFY_CODE(bench.box.run(QStringList{"deactivate"} + axis), 0);
        VERIFY_CODE(bench.write(url, "new.csv", newSource), 0);
        const ProgramRun after = bench.status(url);
        QVERIFY2(stateOf(after.json()) == bench.after, after.text().constData());
        QVERIFY2(after.err.isEmpty(), after.err.constData());
    }

    void aNewStateWhoseBackupIsGoneIsSavedByWritingItAgain()
    {
        const Fixture bench(m_prepared);
        const VirtualDriveProcess slow(bench.box, driveOptions({}, "slow=15"));
        QVERIFY(slow.isReady());
        const QString url = slow.url();
        QVERIFY(bench.killWrite(url, 6));
        const QJsonObject left = bench.status(url).json().value("unfinishedWrite").toObject();
        if (left.value("driveHolds") != QStringLiteral("NewUnsaved"))
            return; // it had ended before the program was killed
        QVERIFY(QFile::remove(left.value("backup").toString()));
        const QStringList axis{"--drive", url, "--axis", "0"};
        const QByteArray status = bench.status(url).err;
        const QByteArray recover = bench.box.run(QStringList{"recover"} + axis).out;
        for (const QByteArray& said : {status, recover}) {
            QVERIFY2(said.contains("holds the complete new state"), said.constData());
            QVERIFY2(said.contains("`axiscomp write`"), said.constData());
            QVERIFY2(!said.contains("recover --"), said.constData());
        }
        VERIFY_CODE(bench.box.run(QStringList{"recover", "--finish"} + axis), 3);
        VERIFY_CODE(bench.write(url, "new.csv", newSource), 0);
        const ProgramRun after = bench.status(url);
        QVERIFY2(stateOf(after.json()) == bench.after, after.text().constData());
        QVERIFY2(after.err.isEmpty(), after.err.constData());
    }

    void killedDriveIsExplainedByTheNextRun_data() { addSteps(); }
    void killedDriveIsExplainedByTheNextRun()
    {
        QFETCH(const int, steps);
        const Fixture bench(m_prepared);
        QString url;
        int code = -1;
        QByteArray err;
        {
            VirtualDriveProcess slow(bench.box, driveOptions({}, "slow=15"));
            QVERIFY(slow.isReady());
            url = slow.url();
            const auto process = bench.startWrite(url, steps);
            slow.process().kill();
            QVERIFY(process->waitForFinished(test::patienceMs));
            code = process->exitCode();
            err = process->readAllStandardError();
        }
        // After the last step the write may have ended before the drive was killed.
        const bool hasEnded = steps == 6 && code == 0;
        QVERIFY2(hasEnded || code == 5 || code == 6, err.constData());
        const VirtualDriveProcess quick(bench.box, driveOptions(url, nullptr));
        checkNextRun(bench, url, hasEnded);
    }

private:
    /// `status` says which of the two states the drive holds, and a new write succeeds.
    void checkNextRun(const Fixture& bench, const QString& url, bool mayHaveEnded)
    {
        const ProgramRun status = bench.status(url);
        VERIFY_CODE(status, 0);
        const AxisState now = stateOf(status.json());
        const QString held =
            status.json().value("unfinishedWrite").toObject().value("driveHolds").toString();
        QVERIFY2(now == bench.before || now == bench.after, status.text().constData());
        if (held == "Old")
            QVERIFY2(now == bench.before, status.text().constData());
        else if (held == "New" || held == "NewUnsaved")
            QVERIFY2(now == bench.after, status.text().constData());
        else // nothing had been begun, or all was done
            QVERIFY2(
                held.isEmpty() && (now == bench.before || (mayHaveEnded && now == bench.after)),
                status.text().constData());
        if (!held.isEmpty())
            QVERIFY2(status.err.startsWith("warning: a write to axis 0 that began at "),
                status.err.constData());
        VERIFY_CODE(
            bench.write(url, "new.csv", newSource), 0); // 0 also when there is nothing to do
        const ProgramRun after = bench.status(url);
        QVERIFY2(stateOf(after.json()) == bench.after, after.text().constData());
        QVERIFY2(after.err.isEmpty(), after.err.constData());
    }

    Fixture m_prepared;
};

AXISCOMP_TEST(tst_Interruption)

} // namespace tst_interruption

#include "tst_interruption.moc"
