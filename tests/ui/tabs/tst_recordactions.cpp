// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/calibration_csv.h"
#include "tests/support/unended_write.h"
#include "tests/support/verify.h"
#include "tests/ui/support/dropped_files.h"
#include "tests/ui/support/heartbeat.h"
#include "tests/ui/support/page_states.h"
#include "tests/ui/support/record_files.h"
#include "tests/ui/support/window_test.h"
#include "ui/page/page_tabs.h"

#include <QAbstractButton>
#include <QAction>
#include <QDir>
#include <QFile>
#include <QPushButton>
#include <QTableView>
#include <QTest>
#include <QThreadPool>

#include <algorithm>

namespace tst_recordactions {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::PageFixture;
using test::publicMeasurement;

namespace {

QString recordName(PageFixture& bench)
{
    return bench.user.the<QLabel>("recordName").text();
}

[[nodiscard]] bool isNamed(PageFixture& bench, const char* name)
{
    const bool isSo = QTest::qWaitFor(
        [&] { return recordName(bench) == QLatin1StringView(name); }, test::patienceMs);
    if (!isSo)
        qInfo("it is called %s", qPrintable(recordName(bench)));
    return isSo;
}

QString recordFile(
    PageFixture& bench, const CalibrationRecord& record, const char* name = "x.axcal")
{
    return bench.file(QLatin1StringView(name), QByteArray::fromStdString(recordText(record)));
}

[[nodiscard]] bool openRecord(PageFixture& bench, const CalibrationRecord& record)
{
    bench.wizard.openRecord(recordFile(bench, record));
    return isNamed(bench, "x.axcal");
}

/// A step of the record.
[[nodiscard]] bool change(PageFixture& bench)
{
    bench.user.the<PageTabs>("pageTabs").setCurrentIndex(PageTabs::Measure);
    return bench.user.click("swapDirections");
}

CalibrationRecord savedRecord(PageFixture& bench, const char* name = "x.axcal")
{
    auto record = loadRecord(bench.path(QLatin1StringView(name)).toStdString());
    if (!record)
        qFatal("%s", sentence(record.error()).c_str());
    return *std::move(record);
}

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// The table of a record as a file for Write, over the position of the axis X.
QString tableFile(PageFixture& bench, const CalibrationRecord& record)
{
    CalibrationData data;
    data.tables = {record.tables.front().table};
    data.grid = data.tables.front().grid;
    return bench.file(
        QStringLiteral("table.csv"), QByteArray::fromStdString(writeCalibrationCsv(data)));
}

/// As if the program had been killed when the volatile table of the axis X was being written again,
/// as a persistent one.
[[nodiscard]] bool leavePersistentWrite(PageFixture& bench)
{
    const auto opened =
        test::openJournalOf(DriveStore(bench.folder.path().toStdString() + "/store"),
            bench.served.drive, 1559, bench.controller().setup().baseline(), "switch");
    if (!opened)
        return false;
    bench.controller().refresh();
    return QTest::qWaitFor([&] { return bench.user.sees("finishWriteButton"); }, test::patienceMs);
}

/// The table of the record is chosen for the axis X of the drive.
[[nodiscard]] bool chooseTable(PageFixture& bench, const CalibrationRecord& record)
{
    bench.user.the<PageTabs>("pageTabs").setCurrentIndex(PageTabs::Write);
    bench.picked = tableFile(bench, record);
    return bench.user.choose("dimensionalityField", QStringLiteral("1D"))
        && bench.user.click("openButton")
        && bench.user.enter("source1Field", QString::fromStdString(test::masterX))
        && QTest::qWaitFor(
            [&] { return bench.controller().action(Action::Write).isEnabled; }, test::patienceMs);
}

/// And written by the window.
[[nodiscard]] bool writeTable(PageFixture& bench, const CalibrationRecord& record)
{
    return chooseTable(bench, record) && bench.write() && !bench.controller().isOutcomeAnError();
}

} // namespace

/// The record and the page: opened, saved, reported, lost by nobody, and told of what is written.
class TestRecordActions : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void aRecordIsOpenedByTheButtonAndNamed()
    {
        PageFixture bench;
        QVERIFY(bench.user.isThere());
        QCOMPARE(recordName(bench), QStringLiteral("none"));
        QVERIFY(!bench.user.the("saveRecord").isEnabled());
        QVERIFY(!bench.user.the("reportRecord").isEnabled());
        bench.picked = recordFile(bench, test::recordOfFit());
        QVERIFY(bench.user.click("openRecord"));
        QVERIFY(isNamed(bench, "x.axcal"));
        QCOMPARE(bench.questions.back().purpose, FileQuestion::Purpose::OpenRecord);
        QVERIFY(!bench.window.isWindowModified());
        QTRY_COMPARE(bench.user.the<PageTabs>("pageTabs").tabText(PageTabs::Measure),
            QStringLiteral("Measure · ready"));
        QVERIFY(change(bench));
        QVERIFY(isNamed(bench, "x.axcal*"));
        QVERIFY(bench.window.isWindowModified());
        QVERIFY(bench.user.the("recordName")
                    .accessibleDescription()
                    .contains(QStringLiteral("not saved")));
        bench.user.press(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(isNamed(bench, "x.axcal"));
    }

    void aRecordThatIsDroppedIsOpenedOnEveryTab()
    {
        for (const int tab : {PageTabs::Measure, PageTabs::Write, PageTabs::Prove}) {
            PageFixture bench;
            QVERIFY(bench.user.isThere());
            bench.user.the<PageTabs>("pageTabs").setCurrentIndex(tab);
            QVERIFY(test::drop(bench, {recordFile(bench, test::recordOfFit())}).isTaken);
            QVERIFY(isNamed(bench, "x.axcal"));
        }
    }

    void ctrlSSavesAndAsksForAFileOnce()
    {
        PageFixture bench;
        QVERIFY(bench.user.isThere());
        bench.user.the<PageTabs>("pageTabs").setCurrentIndex(PageTabs::Measure);
        bench.picked = publicMeasurement("b02_x");
        QVERIFY(bench.user.click("addMeasurement"));
        QVERIFY(isNamed(bench, "not saved yet*"));
        bench.picked = bench.path(QStringLiteral("spindle")); // .axcal is put behind
        bench.user.press(Qt::Key_S, Qt::ControlModifier);
        QVERIFY(isNamed(bench, "spindle.axcal"));
        QCOMPARE(bench.questions.back().purpose, FileQuestion::Purpose::SaveRecord);
        QVERIFY(bench.questions.back().start.endsWith(QStringLiteral("b02_x.axcal")));
        const std::size_t questions = bench.questions.size();
        QVERIFY(change(bench));
        bench.user.press(Qt::Key_S, Qt::ControlModifier);
        QVERIFY(isNamed(bench, "spindle.axcal"));
        QCOMPARE(bench.questions.size(), questions);
        QVERIFY(savedRecord(bench, "spindle.axcal").before->swapsDirections);
    }

    /// Its button takes no focus.
    void savingByMouseTakesAToleranceThatIsBeingTyped()
    {
        PageFixture bench;
        QVERIFY(bench.user.isThere() && openRecord(bench, test::recordOfFit()));
        QVERIFY(change(bench));
        bench.user.the<PageTabs>("pageTabs").setCurrentIndex(PageTabs::Judge);
        QVERIFY(bench.user.click("toleranceA"));
        bench.user.press(Qt::Key_A, Qt::ControlModifier);
        bench.user.type(QStringLiteral("10"));
        QVERIFY(bench.user.click("saveRecord"));
        QVERIFY(isNamed(bench, "x.axcal"));
        const std::vector<Tolerance> typed{{Iso230Figure::A, 0.01}};
        QCOMPARE(judgingOf(savedRecord(bench)).tolerances, typed);
    }

    void anotherFileIsNotWrittenOverWithoutAsking()
    {
        PageFixture bench;
        QVERIFY(bench.user.isThere() && openRecord(bench, test::recordOfFit()));
        QVERIFY(change(bench));
        const QString other = bench.file(QStringLiteral("other.axcal"), "something else");
        bench.picked = other;
        bench.user.press(Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(bench.user.message("recordQuestion").contains(QStringLiteral("other.axcal")));
        QCOMPARE(contentOf(other), QByteArray("something else"));
        QVERIFY(bench.user.click("overwriteRecordButton"));
        QVERIFY(isNamed(bench, "other.axcal"));
        QVERIFY(savedRecord(bench, "other.axcal").draft);
    }

    /// Overwrite would put another record over that file.
    void aQuestionGoesWithTheRecordThatItIsAbout()
    {
        PageFixture bench;
        QVERIFY(bench.user.isThere() && openRecord(bench, test::recordOfFit()));
        const QString other = bench.file(QStringLiteral("other.axcal"), "something else");
        for (const bool opensAnother : {false, true}) {
            bench.picked = other;
            bench.user.press(Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
            QTRY_VERIFY(
                bench.user.message("recordQuestion").contains(QStringLiteral("other.axcal")));
            if (opensAnother) {
                bench.wizard.openRecord(recordFile(bench, test::recordOfFit("b02_y"), "y.axcal"));
                QVERIFY(isNamed(bench, "y.axcal"));
            } else {
                bench.picked = bench.path(QStringLiteral("z.axcal"));
                bench.user.press(Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
                QVERIFY(isNamed(bench, "z.axcal"));
            }
            QTRY_VERIFY(!bench.user.sees("recordQuestion"));
        }
        QCOMPARE(contentOf(other), QByteArray("something else"));
    }

    void closingAsksOnceForFieldsAndRecord()
    {
        PageFixture bench;
        QVERIFY(bench.open() && bench.choose2D());
        QVERIFY(openRecord(bench, test::recordOfFit()));
        QVERIFY(change(bench));
        QVERIFY(!bench.window.close());
        const QString question = bench.user.message("leaveQuestion");
        QVERIFY2(question.contains(QStringLiteral("not written to the drive"))
                && question.contains(QStringLiteral("x.axcal")),
            qPrintable(question));
        QVERIFY(bench.user.click("stayButton"));
        QVERIFY(bench.window.isVisible());
        QVERIFY(!bench.window.close());
        QVERIFY(bench.user.click("saveAndCloseButton"));
        QTRY_VERIFY(!bench.window.isVisible());
        QVERIFY(savedRecord(bench).draft->before->swapsDirections);
    }

    void closingAfterSavingLosesNothingThatIsChangedWhileItSaves()
    {
        PageFixture bench;
        QVERIFY(bench.user.isThere() && openRecord(bench, test::recordOfFit()));
        QVERIFY(change(bench));
        QTRY_VERIFY(bench.user.the("saveMeasurement").isEnabled()); // it has been read
        // In one go: nothing is saved before the event loop.
        bench.user.the<QAction>("saveRecordAction").trigger();
        bench.user.the<QAbstractButton>("swapDirections").click();
        QVERIFY(!bench.window.close());
        bench.user.the<QAbstractButton>("saveAndCloseButton").click();
        QTRY_VERIFY(!bench.window.isVisible());
        QVERIFY(!savedRecord(bench).draft); // exchanged twice
    }

    void closingWithoutSavingKeepsNothing()
    {
        PageFixture bench;
        QVERIFY(bench.user.isThere() && openRecord(bench, test::recordOfFit()));
        const QByteArray content = contentOf(bench.path(QStringLiteral("x.axcal")));
        QVERIFY(change(bench));
        QVERIFY(!bench.window.close());
        QVERIFY(bench.user.message("leaveQuestion").contains(QStringLiteral("x.axcal")));
        QVERIFY(bench.user.click("loseChangesButton"));
        QTRY_VERIFY(!bench.window.isVisible());
        QCOMPARE(contentOf(bench.path(QStringLiteral("x.axcal"))), content);
    }

    void theQuestionGoesWhenTheRecordIsSaved()
    {
        PageFixture bench;
        QVERIFY(bench.user.isThere() && openRecord(bench, test::recordOfFit()));
        QVERIFY(change(bench));
        QVERIFY(!bench.window.close());
        bench.user.press(Qt::Key_S, Qt::ControlModifier);
        QTRY_VERIFY(!bench.user.sees("leaveQuestion"));
        QVERIFY(bench.window.isVisible());
        QVERIFY(bench.window.close());
    }

    void anotherRecordIsOpenedOnlyWhenThisOneMayGo()
    {
        PageFixture bench;
        QVERIFY(bench.user.isThere() && openRecord(bench, test::recordOfFit()));
        QVERIFY(change(bench));
        const QString other = recordFile(bench, test::recordOfFit("b02_y"), "y.axcal");
        bench.wizard.openRecord(other);
        QTRY_VERIFY(bench.user.message("recordQuestion").contains(QStringLiteral("x.axcal")));
        QCOMPARE(recordName(bench), QStringLiteral("x.axcal*"));
        QVERIFY(bench.user.click("saveFirstButton"));
        QVERIFY(isNamed(bench, "y.axcal"));
        QVERIFY(savedRecord(bench).draft->before->swapsDirections);
    }

    void aRecordThatCannotBeReadIsToldAndTheOneThereStays()
    {
        PageFixture bench;
        QVERIFY(bench.user.isThere() && openRecord(bench, test::recordOfFit()));
        bench.wizard.openRecord(
            bench.file(QStringLiteral("new.axcal"), R"({"format":"axiscomp-record","version":9})"));
        QTRY_VERIFY(bench.user.message("failureMessage").contains(QStringLiteral("has version 9")));
        QCOMPARE(recordName(bench), QStringLiteral("x.axcal"));
    }

    void theRecordNotesThatItsTableWasWrittenAndProved()
    {
        auto options = PageFixture::twoAxes();
        options.axes.front().low = -15.0; // always within the table
        options.axes.front().high = 15.0;
        PageFixture bench(options);
        const CalibrationRecord record = test::recordOfFit();
        QVERIFY(bench.open() && openRecord(bench, record));
        QVERIFY(writeTable(bench, record));
        QVERIFY(isNamed(bench, "x.axcal*"));
        bench.user.press(Qt::Key_S, Qt::ControlModifier);
        QVERIFY(isNamed(bench, "x.axcal"));
        const CalibrationRecord written = savedRecord(bench);
        QVERIFY(written.drive && written.write);
        QCOMPARE(written.drive->serialNumber, 1559);
        QCOMPARE(written.drive->axis, 0);
        QCOMPARE(written.drive->axisName, std::string("X"));
        QCOMPARE(written.write->crc, record.tables.front().crc);
        QCOMPARE(written.write->slot, bench.controller().status()->setup.slot);
        QVERIFY(!written.write->proof);
        QVERIFY(bench.user.click("activateButton") && bench.idle());
        QVERIFY(bench.controller().proof());
        QVERIFY(isNamed(bench, "x.axcal*"));
        bench.user.press(Qt::Key_S, Qt::ControlModifier);
        QVERIFY(isNamed(bench, "x.axcal"));
        const CalibrationRecord proved = savedRecord(bench);
        QVERIFY(proved.write->proof && proved.write->proof->isProved);
        QCOMPARE(proved.write->proof->samples,
            static_cast<int>(bench.controller().proof()->samples.size()));
    }

    void theRecordNotesThatTheWriteOfItsTableWasFinished()
    {
        PageFixture bench;
        const CalibrationRecord record = test::recordOfFit();
        QVERIFY(bench.open() && openRecord(bench, record));
        QVERIFY(writeTable(bench, record));
        QVERIFY(isNamed(bench, "x.axcal*"));
        bench.user.press(Qt::Key_S, Qt::ControlModifier);
        QVERIFY(isNamed(bench, "x.axcal"));
        QVERIFY(!savedRecord(bench).write->isPersistent);
        QVERIFY(leavePersistentWrite(bench));
        QVERIFY(bench.user.click("finishWriteButton"));
        QVERIFY2(bench.saysOutcome(QStringLiteral("Finished and verified")),
            qPrintable(bench.outcome()));
        QVERIFY(isNamed(bench, "x.axcal*"));
        bench.user.press(Qt::Key_S, Qt::ControlModifier);
        QVERIFY(isNamed(bench, "x.axcal"));
        QVERIFY(savedRecord(bench).write->isPersistent);
    }

    /// Its numbers on the drive are others than those of the record.
    void aWriteToAnAxisInMetresIsNotedToo()
    {
        auto options = PageFixture::twoAxes();
        options.axes.front() = {"X", "Meter", 0.0, 0.04, 0.017, true};
        PageFixture bench(options);
        const CalibrationRecord record = test::recordOfFit();
        QVERIFY(bench.open() && openRecord(bench, record));
        QVERIFY(writeTable(bench, record));
        QVERIFY(isNamed(bench, "x.axcal*"));
        bench.user.press(Qt::Key_S, Qt::ControlModifier);
        QVERIFY(isNamed(bench, "x.axcal"));
        const CalibrationRecord written = savedRecord(bench);
        QVERIFY(written.write);
        QCOMPARE(written.write->crc, bench.controller().status()->table->crc);
        QVERIFY(written.write->crc != record.tables.front().crc);
        QVERIFY(bench.user.click("activateButton") && bench.idle());
        QVERIFY(isNamed(bench, "x.axcal*"));
        // Prove knows the table by what the drive shows.
        bench.user.the<PageTabs>("pageTabs").setCurrentIndex(PageTabs::Prove);
        bench.picked = bench.file(QStringLiteral("after.csv"),
            test::goodAfterMeasurement(
                "crc:" + QByteArray::fromStdString(crcText(written.write->crc))));
        QVERIFY(bench.user.click("afterAddMeasurement"));
        QTRY_VERIFY(bench.user.the("keepAfter").isEnabled());
    }

    void theValuesOfTheRecordOverOtherPositionsAreNotNoted()
    {
        PageFixture bench;
        const CalibrationRecord record = test::recordOfFit();
        QVERIFY(bench.open() && openRecord(bench, record));
        CalibrationRecord shifted = record;
        shifted.tables.front().table.grid.axes.front().start -= 5.0;
        QVERIFY(writeTable(bench, shifted));
        QCOMPARE(bench.controller().status()->table->crc, record.tables.front().crc);
        QCOMPARE(recordName(bench), QStringLiteral("x.axcal"));
        QVERIFY(bench.window.close()); // nothing is being noted
    }

    void aTableThatIsNotTheRecordsIsNotNoted()
    {
        PageFixture bench;
        QVERIFY(bench.open() && openRecord(bench, test::recordOfFit()));
        QVERIFY(writeTable(bench, test::recordOfFit("b02_y")));
        QCOMPARE(recordName(bench), QStringLiteral("x.axcal"));
        // What is noted is asked about before the window closes, also while it is being noted.
        QVERIFY(bench.window.close());
    }

    void aRecordOfAnotherAxisSaysWhyItNotesNothing()
    {
        PageFixture bench;
        CalibrationRecord record = test::recordOfFit();
        record.drive = RecordedDrive{"Other", 77, "generic", 0, "X", {}};
        QVERIFY(bench.open() && openRecord(bench, record));
        QVERIFY(writeTable(bench, record));
        QTRY_VERIFY(bench.user.message("failureMessage")
                        .contains(QStringLiteral("only the record does not say so")));
        QCOMPARE(recordName(bench), QStringLiteral("x.axcal"));
    }

    void thatTheRecordNotesNothingIsSaidBeforeTheWrite_data()
    {
        QTest::addColumn<int>("serial");
        QTest::newRow("of this axis") << 1559;
        QTest::newRow("of another drive") << 77;
    }
    void thatTheRecordNotesNothingIsSaidBeforeTheWrite()
    {
        QFETCH(const int, serial);
        PageFixture bench;
        CalibrationRecord record = test::recordOfFit();
        record.drive = RecordedDrive{"Other", serial, "generic", 0, "X", {}};
        QVERIFY(bench.open() && openRecord(bench, record));
        QVERIFY(chooseTable(bench, record));
        QVERIFY(bench.user.click("writeButton"));
        QTRY_VERIFY(bench.user.sees("writePreview"));
        QVERIFY(bench.controller().plan());
        const bool isSaid =
            std::ranges::any_of(bench.controller().plan()->warnings, [](const Text& warning) {
                return warning.english().starts_with(
                    "The open record will not note this write: the record is of ");
            });
        QCOMPARE(isSaid, serial != 1559);
    }

    void aSourceOnTheWrongSideOfTheCompensationIsNotWritten()
    {
        PageFixture bench;
        CalibrationRecord record = test::recordOfFit();
        record.fit->settings.lookupAt = LookupAt::Set; // masterX is before the compensation
        QVERIFY(bench.open() && openRecord(bench, record));
        bench.picked = tableFile(bench, record);
        QVERIFY(bench.user.choose("dimensionalityField", QStringLiteral("1D"))
            && bench.user.click("openButton")
            && bench.user.enter("source1Field", QString::fromStdString(test::masterX)));
        QTRY_VERIFY(bench.controller().action(Action::Write).isEnabled);
        QVERIFY(bench.user.click("writeButton"));
        QTRY_VERIFY(bench.user.message("failureMessage")
                        .contains(QStringLiteral("made for a position after the compensation")));
        QVERIFY(!bench.user.sees("confirmWriteButton"));
    }

    void aSourceOfADimensionThatIsNotChosenKeepsNothingFromBeingWritten()
    {
        PageFixture bench;
        const QString afterIt = QStringLiteral("Axes[1]/Signals/PathPlanner/Position");
        CalibrationRecord record = test::recordOfFit();
        record.fit->settings.lookupAt = LookupAt::Encoder;
        QVERIFY(bench.open() && openRecord(bench, record));
        bench.picked = tableFile(bench, record);
        QVERIFY(bench.user.choose("dimensionalityField", QStringLiteral("2D"))
            && bench.user.enter("source1Field", QString::fromStdString(test::masterX))
            && bench.user.enter("source2Field", afterIt));
        QTRY_VERIFY(bench.controller().setup().edited().sources[1].isSet());
        QVERIFY(bench.user.choose("dimensionalityField", QStringLiteral("1D"))
            && bench.user.click("openButton"));
        QTRY_VERIFY(bench.controller().action(Action::Write).isEnabled);
        QVERIFY(bench.user.click("writeButton"));
        QTRY_VERIFY(bench.user.sees("confirmWriteButton"));
        QVERIFY(bench.user.message("failureMessage").isEmpty());
        // It is there again with its dimension.
        QVERIFY(bench.user.choose("dimensionalityField", QStringLiteral("2D")));
        QCOMPARE(bench.controller().setup().edited().sources[1].path, afterIt.toStdString());
    }

    void theReportIsHtmlOrPdfInTheLanguageOfTheWindow()
    {
        PageFixture bench(PageFixture::twoAxes(), QStringLiteral("de"));
        QVERIFY(bench.user.isThere() && openRecord(bench, test::recordOfFit()));
        const QString html = bench.path(QStringLiteral("r.html"));
        bench.picked = html;
        QVERIFY(bench.user.click("reportRecord"));
        QCOMPARE(bench.questions.back().purpose, FileQuestion::Purpose::SaveReport);
        QTRY_VERIFY(bench.user.sees("reportMessage"));
        QVERIFY(contentOf(html).contains("<html lang=\"de\""));
        QVERIFY(contentOf(html).contains("135,27"));
        const QString pdf = bench.path(QStringLiteral("r.PDF"));
        bench.picked = pdf;
        bench.user.press(Qt::Key_P, Qt::ControlModifier);
        QTRY_VERIFY(contentOf(pdf).startsWith("%PDF-1"));
        bench.picked = bench.path(QStringLiteral("r.doc"));
        QVERIFY(bench.user.click("reportRecord"));
        QTRY_VERIFY(bench.user.message("failureMessage").contains(QStringLiteral("r.doc")));
        QVERIFY(!QFile::exists(bench.path(QStringLiteral("r.doc"))));
    }

    void whatAProgramHasLeftIsOffered()
    {
        PageFixture bench;
        const QString folder = bench.path(QStringLiteral("store/records"));
        QVERIFY(QDir().mkpath(folder));
        CalibrationRecord record = test::recordOfFit();
        record.before->exclusions = {{Approach::Down, 1, 1}};
        record.others = {{"/recovery", R"({"path":"/somewhere/spindle.axcal","sha256":""})"}};
        VERIFY_RESULT(saveRecord((folder + QStringLiteral("/left.axcal")).toStdString(), record));
        QVERIFY(bench.user.isThere());
        QTRY_VERIFY(bench.user.message("recoveryOffer").contains(QStringLiteral("spindle.axcal")));
        QCOMPARE(bench.user.the<QPushButton>("takeUnsavedButton").text(),
            QStringLiteral("&Take Them Up"));
        QVERIFY(bench.user.click("takeUnsavedButton"));
        QVERIFY(isNamed(bench, "spindle.axcal*"));
    }

    void oneRecordThatWasNeverSavedIsNotSeveral()
    {
        PageFixture bench;
        const QString folder = bench.path(QStringLiteral("store/records"));
        QVERIFY(QDir().mkpath(folder));
        CalibrationRecord record = test::recordOfFit();
        record.others = {{"/recovery", R"({"path":"","sha256":""})"}};
        VERIFY_RESULT(saveRecord((folder + QStringLiteral("/left.axcal")).toStdString(), record));
        QVERIFY(bench.user.isThere());
        QTRY_VERIFY(bench.user.message("recoveryOffer").contains(QStringLiteral("never saved")));
        QCOMPARE(
            bench.user.the<QPushButton>("takeUnsavedButton").text(), QStringLiteral("&Take It Up"));
        QCOMPARE(bench.user.the<QPushButton>("forgetUnsavedButton").text(),
            QStringLiteral("For&get It"));
    }

    void aLargeRecordNeverStopsTheWindow()
    {
        PageFixture bench;
        CalibrationRecord record = test::recordOfFit();
        Measurement& measurement = record.before->files.front().measurement;
        measurement.targets.clear();
        measurement.values.clear();
        for (std::size_t target = 0; target < 3000; ++target)
            measurement.targets.push_back(static_cast<double>(target));
        for (const Approach direction : {Approach::Up, Approach::Down})
            for (std::size_t target = 0; target < 3000; ++target)
                for (int run = 1; run <= 10; ++run)
                    measurement.values.push_back(
                        {target, direction, run, 1e-6 * static_cast<double>(run)});
        const auto began = test::Heartbeat::busy();
        const QString path = recordFile(bench, record);
        const auto writing = test::Heartbeat::busy() - began;
        QVERIFY(bench.user.isThere());
        auto& tabs = bench.user.the<PageTabs>("pageTabs");
        tabs.setCurrentIndex(PageTabs::Prove);
        bench.picked = bench.file(
            QStringLiteral("after.csv"), test::goodAfterMeasurement(test::stateOf(record)));
        test::Heartbeat heart;
        bench.wizard.openRecord(path);
        QVERIFY(isNamed(bench, "x.axcal"));
        QVERIFY(bench.user.click("afterAddMeasurement"));
        QVERIFY(bench.user.click("keepAfter"));
        QTRY_VERIFY(bench.user.the<QLabel>("proveHint")
                        .text()
                        .contains(QStringLiteral("The measurement is in the record")));
        bench.user.press(Qt::Key_S, Qt::ControlModifier);
        QVERIFY(isNamed(bench, "x.axcal"));
        // Whatever the machine: the window takes less than writing the record does.
        QVERIFY2(heart.longestBusy() < writing,
            qPrintable(QStringLiteral("%1 us, writing %2 us")
                           .arg(heart.longestBusy().count())
                           .arg(writing.count())));
        QCOMPARE(savedRecord(bench).after.size(), std::size_t{1});
        QTRY_VERIFY(bench.user.the<QLabel>("proveHint")
                        .text()
                        .contains(QStringLiteral("that is saved: write the report")));
    }

    void theTableOfTheRecordTakenOnceMoreKeepsWhatWasWritten()
    {
        PageFixture bench;
        QVERIFY(test::page_states::fitCurve(bench));
        QTRY_VERIFY(bench.user.the("useAsTable").isEnabled());
        bench.user.the<QPushButton>("useAsTable").click();
        QTRY_VERIFY(bench.controller().dataFile().isMade);
        bench.picked = bench.path(QStringLiteral("first.axcal"));
        bench.user.press(Qt::Key_S, Qt::ControlModifier);
        QVERIFY(isNamed(bench, "first.axcal"));
        CalibrationRecord record = savedRecord(bench, "first.axcal");
        record.write = RecordedWrite{*record.time, "Small1", true, record.tables.front().crc};
        QVERIFY(openRecord(bench, record));
        bench.user.the<PageTabs>("pageTabs").setCurrentIndex(PageTabs::Fit);
        QTRY_VERIFY(bench.user.the("useAsTable").isEnabled());
        bench.user.the<QPushButton>("useAsTable").click();
        QTRY_COMPARE(bench.user.the<PageTabs>("pageTabs").currentIndex(), int{PageTabs::Write});
        QVERIFY(QThreadPool::globalInstance()->waitForDone(test::patienceMs));
        QCoreApplication::processEvents();
        QCOMPARE(recordName(bench), QStringLiteral("x.axcal")); // no star: it has not changed
        bench.user.press(Qt::Key_S, Qt::ControlModifier);
        QVERIFY(isNamed(bench, "x.axcal"));
        QVERIFY(savedRecord(bench).write.has_value());
    }

    void aTableIsNotPutIntoARecordThatWasBegunMeanwhile()
    {
        PageFixture bench;
        QVERIFY(test::page_states::fitCurve(bench));
        bench.picked = bench.path(QStringLiteral("first.axcal"));
        bench.user.press(Qt::Key_S, Qt::ControlModifier);
        QVERIFY(isNamed(bench, "first.axcal"));
        QTRY_VERIFY(bench.user.the("useAsTable").isEnabled());
        // Its record is made on another thread, and handed over in the event loop.
        bench.user.the<QPushButton>("useAsTable").click();
        bench.user.the<QAction>("newRecordAction").trigger();
        QVERIFY(isNamed(bench, "none"));
        QVERIFY(QThreadPool::globalInstance()->waitForDone(test::patienceMs));
        QCoreApplication::processEvents();
        QCOMPARE(recordName(bench), QStringLiteral("none"));
        QVERIFY(!bench.controller().setup().edited().table.fileTable);
        QVERIFY(!bench.window.isWindowModified());
    }

    void aNewRecordBeginsEmpty()
    {
        PageFixture bench;
        QVERIFY(bench.user.isThere() && openRecord(bench, test::recordOfFit()));
        bench.user.the<QAction>("newRecordAction").trigger();
        QVERIFY(isNamed(bench, "none"));
        QCOMPARE(bench.user.the<QTableView>("measurementFiles").model()->rowCount(), 0);
    }
};

AXISCOMP_WINDOW_TEST(TestRecordActions)

} // namespace tst_recordactions

#include "tst_recordactions.moc"
