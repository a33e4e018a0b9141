// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"
#include "tests/ui/support/brackets.h"
#include "tests/ui/support/unfinished_write.h"

#include <QDirIterator>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTest>

#include <functional>

namespace tst_wizardlanguage {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::Brackets;
using test::ControllerFixture;
using test::DriveGate;

namespace {

/// What brings a controller into a state; every text that it can show belongs to some state.
using Story = std::function<void(ControllerFixture&)>;

/// Everything that the controller says. What differs from run to run is taken out.
QStringList textsOf(ControllerFixture& bench)
{
    QStringList texts{bench->hint(), bench->outcome(), bench->busy().step, bench->signSentence()};
    for (const Action action : allActions)
        texts += bench->action(action).reason;
    for (int dimension = 1; dimension <= 3; ++dimension)
        texts += bench->sourceProblem(dimension);
    for (const DriveState& drive : bench->drives())
        texts += drive.problem;
    for (const AxisEntry& entry : bench->axes())
        texts << entry.label << entry.problem;
    for (const LogLine& line : bench->log())
        texts += line.text();
    static const QRegularExpression backup(QStringLiteral("backups/[-.0-9TZ]+-axis"));
    return texts.replaceInStrings(bench.path({}), QStringLiteral("FOLDER"))
        .replaceInStrings(backup, QStringLiteral("backups/TIME-axis"));
}

void connectDrive(ControllerFixture& bench)
{
    QVERIFY(bench.connect());
}

void prepareWrite(ControllerFixture& bench)
{
    QVERIFY(bench.connect());
    QVERIFY(bench.prepare2D());
}

void planWrite(ControllerFixture& bench)
{
    prepareWrite(bench);
    bench->planWrite();
    QVERIFY(bench.idle());
    QVERIFY(bench->plan().has_value());
}

/// A write whose step stays, because the drive does not answer.
void writeUntil(ControllerFixture& bench, DriveGate::Mode mode)
{
    planWrite(bench);
    bench.drive().gate.setAt(18, mode);
    bench->write();
    QTRY_COMPARE(bench.drive().gate.waiting(), 1);
    QTRY_VERIFY2(bench->busy().step.contains(QStringLiteral("switching the axis over")),
        qPrintable(bench->busy().step));
}

void writeUntilItHangs(ControllerFixture& bench)
{
    writeUntil(bench, DriveGate::Mode::Silent);
}

void cancelWrite(ControllerFixture& bench)
{
    writeUntil(bench, DriveGate::Mode::Deaf);
    bench->cancel();
    bench->selectAxis(1);
}

void findNoDrive(ControllerFixture& bench)
{
    bench->setEndpoints({QStringLiteral("http://nowhere")});
    QTRY_COMPARE(bench->drives().front().connection, DriveState::Connection::Lost);
}

void findNamelessDemo(ControllerFixture& bench)
{
    drivecomm::VirtualDriveOptions options = ControllerFixture::xyDrive();
    options.axes = {{.name = ""}, {.name = "X"}, {.name = "X"}};
    bench.addDrive("demo:", options);
    bench->setEndpoints({QStringLiteral("demo:")});
    QTRY_VERIFY(bench->status().has_value());
    bench->planWrite(); // the log names the axis, the outcome the reason
    bench->setup().setDimensionality(2);
    bench->openData(bench.file(QStringLiteral("a.csv"), ControllerFixture::calibration2D(1)));
    QVERIFY(bench.fileRead());
    bench->chooseSource(1, QString::fromStdString(test::masterX));
    bench->chooseSource(2, QString::fromStdString(test::masterY));
    bench->planWrite();
    QVERIFY(bench.idle());
}

void findAxesWithoutRegisters(ControllerFixture& bench)
{
    static const DriveProfile other = [] {
        DriveProfile profile = drivecomm::genericProfile();
        profile.registers.state = "Axes[{axis}]/Signals/Compensations/Axis/NoSuchState";
        return profile;
    }();
    bench.options.profile = &other;
    bench->setEndpoints({QStringLiteral("http://x")});
    QTRY_COMPARE(bench->axes().size(), std::size_t{2});
    bench->selectAxis(0);
}

void writePersistent(ControllerFixture& bench)
{
    prepareWrite(bench);
    bench->setup().setPersistency(Persistency::Persistent);
    QVERIFY(bench.planAndWrite());
}

/// The window is opened again after an end that was not one.
void writeAndReopen(ControllerFixture& bench)
{
    writePersistent(bench);
    VERIFY_RESULT(test::reopenWrite(bench));
    bench.endController();
}

void findUnfinishedWrite(ControllerFixture& bench)
{
    writeAndReopen(bench);
    connectDrive(bench);
    QVERIFY2(
        bench->outcome().contains(QStringLiteral("was interrupted")), qPrintable(bench->outcome()));
}

void findDamagedJournal(ControllerFixture& bench)
{
    writePersistent(bench);
    bench.endController();
    QDirIterator folders(bench.path(QStringLiteral("store")), {QStringLiteral("backups")},
        QDir::Dirs, QDirIterator::Subdirectories);
    QVERIFY(folders.hasNext());
    // Of a version that kept the journal in a file.
    QFile journal(QFileInfo(folders.next()).dir().filePath(QStringLiteral("journal-axis0.json")));
    QVERIFY(journal.open(QIODevice::WriteOnly));
    QVERIFY(journal.write("{") == 1);
    journal.close();
    bench.options.reconnectInterval = std::chrono::hours(1);
    bench->setEndpoints({QStringLiteral("http://x")});
    QTRY_VERIFY(bench->hint().contains(QStringLiteral("journal")));
    // The axis is shown nevertheless, with its table.
    QTRY_VERIFY(bench->driveTable());
}

void chooseWrongSources(ControllerFixture& bench)
{
    connectDrive(bench);
    bench.chooseMasterSources(2);
    bench->chooseSource(2, QString::fromStdString(test::masterX));
    bench->chooseSource(1, QStringLiteral("Axes[0]/Nothing"));
    QTRY_VERIFY(!bench->isSourceBeingChecked(1));
    QVERIFY(!bench->sourceProblem(1).isEmpty());
    QVERIFY(!bench->sourceProblem(2).isEmpty());
}

void readFiles(ControllerFixture& bench)
{
    prepareWrite(bench);
    bench->openData(bench.file(QStringLiteral("bad.csv"), "X,table\n0,1\n1,two\n"));
    QVERIFY(bench.fileRead());
    QVERIFY(!bench->dataFile().problems.empty());
    QVERIFY(!bench->signSentence().isEmpty());
}

void activate(ControllerFixture& bench)
{
    prepareWrite(bench);
    QVERIFY(bench.planAndWrite());
    bench->activate();
    QVERIFY(bench.idle());
    QCOMPARE(bench->status()->axis.stateWord, "Active");
}

void activateWithoutHoming(ControllerFixture& bench)
{
    drivecomm::VirtualDriveOptions options = ControllerFixture::xyDrive();
    options.axes.front().homed = false;
    bench.addDrive("http://x", options);
    prepareWrite(bench);
    QVERIFY(bench.planAndWrite());
    bench->activate();
}

void loseDriveInWrite(ControllerFixture& bench)
{
    planWrite(bench);
    bench.drive().gate.setAt(16, DriveGate::Mode::Gone);
    bench->write();
    QVERIFY(bench.idle());
    QVERIFY(bench->isOutcomeAnError());
}

void letSomebodyElseChange(ControllerFixture& bench)
{
    planWrite(bench);
    const auto y = bench.drive().drive.readRegisters({test::masterY});
    bench.drive().set("Axes[0]/Parameters/Compensations/Axis/Dim1Source", y->front().address);
    bench->write();
    QVERIFY(bench.idle());
    QVERIFY(bench->isOutcomeAnError());
}

} // namespace

class TestWizardLanguage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    /// Nothing that was said in one language stays when there is another one: afterwards the
    /// controller says what it would have said had it spoken that language from the beginning.
    void aChangeOfTheLanguageReachesEveryText_data()
    {
        QTest::addColumn<Story>("story");
        const auto row = [](const char* name, const Story& story) { QTest::newRow(name) << story; };
        row("no drive", [](ControllerFixture& bench) { bench->planWrite(); });
        row("a drive that is not there", findNoDrive);
        row("axes without names of the demo drive", findNamelessDemo);
        row("axes without registers", findAxesWithoutRegisters);
        row("an axis that cannot be read", findDamagedJournal);
        row("an earlier write that did not end", findUnfinishedWrite);
        row("sources that are refused", chooseWrongSources);
        row("a file that was read and one that could not be", readFiles);
        row("while it writes", writeUntilItHangs);
        row("while it stops", cancelWrite);
        row("written and active", activate);
        row("not homed", activateWithoutHoming);
        row("the drive is lost", loseDriveInWrite);
        row("somebody else changed the settings", letSomebodyElseChange);
    }
    void aChangeOfTheLanguageReachesEveryText()
    {
        QFETCH(Story, story);
        QStringList inThatLanguage;
        {
            const Brackets language;
            ControllerFixture bench;
            story(bench);
            if (QTest::currentTestFailed())
                return;
            inThatLanguage = textsOf(bench);
            bench.drive().gate.set(DriveGate::Mode::Open);
        }
        ControllerFixture bench;
        story(bench);
        if (QTest::currentTestFailed())
            return;
        const QStringList before = textsOf(bench);
        {
            const Brackets language;
            bench->retranslate();
            QCOMPARE(textsOf(bench), inThatLanguage);
            QVERIFY(textsOf(bench) != before);
        }
        bench->retranslate();
        QCOMPARE(textsOf(bench), before);
        bench.drive().gate.set(DriveGate::Mode::Open);
    }

    void whatIsShownIsAnnouncedAndAnOutcomeThatWasPutAwayIsNot()
    {
        ControllerFixture bench;
        activate(bench);
        QSignalSpy drives(&bench.controller(), &WizardController::drivesChanged);
        QSignalSpy axes(&bench.controller(), &WizardController::axesChanged);
        QSignalSpy actions(&bench.controller(), &WizardController::actionsChanged);
        QSignalSpy outcome(&bench.controller(), &WizardController::outcomeChanged);
        QSignalSpy current(&bench.controller(), &WizardController::currentAxisChanged);
        const Brackets language;
        bench->retranslate();
        QCOMPARE(actions.count(), 1);
        QCOMPARE(axes.count(), 1);
        QCOMPARE(drives.count(), 0); // nothing is said about a drive that answers
        QCOMPARE(outcome.count(), 0);
        QCOMPARE(current.count(), 0); // the same axis, with the edits of before
    }
};

AXISCOMP_TEST(TestWizardLanguage)

} // namespace tst_wizardlanguage

#include "tst_wizardlanguage.moc"
