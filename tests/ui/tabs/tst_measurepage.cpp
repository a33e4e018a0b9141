// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/dropped_files.h"
#include "tests/ui/support/heartbeat.h"
#include "tests/ui/support/measurement_files.h"
#include "tests/ui/support/page_fixture.h"
#include "tests/ui/support/window_test.h"
#include "ui/page/page_tabs.h"
#include "ui/tabs/measure_page.h"

#include <QCheckBox>
#include <QSpinBox>
#include <QStackedWidget>
#include <QTableView>
#include <QTableWidget>
#include <QTest>
#include <QTreeView>

namespace tst_measurepage {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::PageFixture;
using test::publicMeasurement;

namespace {

QString cell(PageFixture& bench, int row, int column)
{
    const auto& files = bench.user.the<QTableView>("measurementFiles");
    return files.model()->index(row, column).data().toString();
}

int fileCount(PageFixture& bench)
{
    return bench.user.the<QTableView>("measurementFiles").model()->rowCount();
}

[[nodiscard]] bool showMeasure(PageFixture& bench)
{
    bench.user.the<PageTabs>("pageTabs").setFocus();
    bench.user.the<PageTabs>("pageTabs").setCurrentIndex(PageTabs::Measure);
    return bench.user.sees("measurePage");
}

[[nodiscard]] bool add(PageFixture& bench, const QString& path)
{
    bench.picked = path;
    return bench.user.click("addMeasurement");
}

[[nodiscard]] bool says(PageFixture& bench, int row, const QString& state)
{
    return QTest::qWaitFor([&] { return cell(bench, row, 1) == state; }, test::patienceMs);
}

QString valueText(PageFixture& bench, int row, int column)
{
    return bench.user.the<QTableView>("runValues").model()->index(row, column).data().toString();
}

QString summary(PageFixture& bench)
{
    return bench.user.the<QLabel>("runValuesSummary").text();
}

/// The tab Measure with a public measurement, its values shown and with the keyboard.
[[nodiscard]] bool showValues(PageFixture& bench, const char* name)
{
    if (!bench.user.isThere() || !showMeasure(bench) || !add(bench, publicMeasurement(name))
        || !says(bench, 0, QStringLiteral("ready")))
        return false;
    bench.user.the<QTabWidget>("measureTabs").setCurrentIndex(3);
    bench.user.the("runValues").setFocus();
    return bench.user.sees("runValues");
}

void choose(PageFixture& bench, int row, int column)
{
    auto& table = bench.user.the<QTableView>("runValues");
    table.setCurrentIndex(table.model()->index(row, column));
}

QString statement(PageFixture& bench, const QString& name)
{
    const auto& facts = bench.user.the<QTableWidget>("fileFacts");
    for (int row = 0; row < facts.rowCount(); ++row)
        if (facts.item(row, 0)->text() == name)
            return facts.item(row, 1)->text();
    return {};
}

} // namespace

/// The tabs over the page, and the one for the files of a measurement.
class TestMeasurePage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void theWindowOpensOnWriteAndEveryTabIsReachedByKey()
    {
        PageFixture bench;
        QVERIFY(bench.user.isThere());
        const auto& tabs = bench.user.the<PageTabs>("pageTabs");
        QCOMPARE(tabs.currentIndex(), int(PageTabs::Write));
        QVERIFY(bench.user.sees("writeButton") && !bench.user.sees("measurePage"));
        bench.user.the("pageTabs").setFocus();
        for (int i = PageTabs::Write; i > PageTabs::Measure; --i)
            bench.user.press(Qt::Key_PageUp, Qt::ControlModifier);
        QVERIFY(bench.user.sees("measurePage") && !bench.user.sees("writeButton"));
        QVERIFY(bench.user.sees("driveField") && bench.user.sees("logButton"));
        bench.user.press(Qt::Key_PageDown, Qt::ControlModifier);
        QVERIFY(bench.user.sees("judgePage") && !bench.user.sees("measurePage"));
        for (int i = PageTabs::Judge; i < PageTabs::Write; ++i)
            bench.user.press(Qt::Key_PageDown, Qt::ControlModifier);
        QVERIFY(bench.user.sees("writeButton"));
    }

    void everyTabSaysHowThingsAreInWords()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        const auto& tabs = bench.user.the<PageTabs>("pageTabs");
        QCOMPARE(tabs.tabText(PageTabs::Measure), QStringLiteral("Measure · empty"));
        QCOMPARE(tabs.tabText(PageTabs::Write), QStringLiteral("Write · empty"));
        QVERIFY(bench.choose2D());
        QCOMPARE(tabs.tabText(PageTabs::Write), QStringLiteral("Write · ready"));
        QVERIFY(showMeasure(bench));
        QVERIFY(add(bench, publicMeasurement("b02_x")));
        QTRY_COMPARE(tabs.tabText(PageTabs::Measure), QStringLiteral("Measure · ready"));
        QVERIFY(add(bench, bench.file(QStringLiteral("none.csv"), "no,measurement\n1,2\n")));
        QTRY_COMPARE(tabs.tabText(PageTabs::Measure), QStringLiteral("Measure · warning"));
    }

    void theTabWriteIsNotReadyWhileTheTableIsOfOtherDimensions()
    {
        PageFixture bench;
        QVERIFY(bench.openWritten());
        QVERIFY(bench.user.pickFromMenu("recentButton", "recentMenu", Qt::Key_C)); // Close File
        const auto& tabs = bench.user.the<PageTabs>("pageTabs");
        QTRY_COMPARE(tabs.tabText(PageTabs::Write), QStringLiteral("Write · ready"));
        QVERIFY(bench.user.choose("dimensionalityField", QStringLiteral("1D")));
        QTRY_COMPARE(tabs.tabText(PageTabs::Write), QStringLiteral("Write · warning"));
        QVERIFY(bench.user.choose("dimensionalityField", QStringLiteral("2D")));
        QTRY_COMPARE(tabs.tabText(PageTabs::Write), QStringLiteral("Write · ready"));
    }

    void aFileSaysWhatItHolds()
    {
        PageFixture bench;
        QVERIFY(bench.user.isThere() && showMeasure(bench));
        QVERIFY(add(bench, publicMeasurement("b02_x")));
        QCOMPARE(bench.questions.back().purpose, FileQuestion::Purpose::OpenMeasurement);
        QVERIFY(bench.questions.back().filter.contains(QStringLiteral("*.rtl")));
        QVERIFY(says(bench, 0, QStringLiteral("ready")));
        QCOMPARE(cell(bench, 0, 0), QStringLiteral("b02_x.csv"));
        QCOMPARE(cell(bench, 0, 2), QStringLiteral("5 up, 5 down"));
        QVERIFY(statement(bench, QStringLiteral("Targets")).startsWith(QStringLiteral("9 from ")));
        QVERIFY(statement(bench, QStringLiteral("Note")).contains(QStringLiteral("ecmc")));
    }

    void droppedFilesAreAddedToTheMeasurement()
    {
        PageFixture bench;
        QVERIFY(bench.user.isThere() && showMeasure(bench));
        QVERIFY(
            test::drop(bench, {publicMeasurement("b02_x"), publicMeasurement("b02_y")}).isTaken);
        QCOMPARE(fileCount(bench), 2);
        QVERIFY(bench.controller().dataFile().path.isEmpty());
    }

    void aFileIsRemovedByKeyAndComesBackByUndo()
    {
        PageFixture bench;
        QVERIFY(bench.user.isThere() && showMeasure(bench));
        QVERIFY(add(bench, publicMeasurement("b02_x")));
        QVERIFY(says(bench, 0, QStringLiteral("ready")));
        bench.user.the("measurementFiles").setFocus();
        bench.user.press(Qt::Key_Delete);
        QCOMPARE(fileCount(bench), 0);
        bench.user.press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(fileCount(bench), 1);
        bench.user.press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(fileCount(bench), 0);
    }

    void undoOnThisTabLeavesTheFieldsOfWriteAlone()
    {
        PageFixture bench;
        QVERIFY(bench.open() && bench.choose2D());
        const auto edited = bench.controller().setup().edited();
        QVERIFY(showMeasure(bench));
        QVERIFY(add(bench, publicMeasurement("b02_x")));
        bench.user.press(Qt::Key_Z, Qt::ControlModifier);
        bench.user.press(Qt::Key_Z, Qt::ControlModifier);
        bench.user.press(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(bench.controller().setup().edited() == edited);
    }

    void nothingIsWrittenFromAnotherTab()
    {
        PageFixture bench;
        QVERIFY(bench.open() && bench.choose2D());
        QVERIFY(showMeasure(bench));
        bench.user.press(Qt::Key_Return, Qt::ControlModifier);
        QVERIFY(bench.idle());
        QVERIFY(!bench.user.sees("confirmWriteButton"));
        QCOMPARE(bench.user.the<PageTabs>("pageTabs").currentIndex(), int(PageTabs::Measure));
    }

    void columnsWithoutUsualNamesAreGivenARoleOverThePreview()
    {
        PageFixture bench;
        QVERIFY(bench.user.isThere() && showMeasure(bench));
        QVERIFY(add(bench,
            bench.file(QStringLiteral("own.csv"),
                "Pos [mm],Way,Lap,Delta [um]\n0,+,1,1\n10,+,1,2\n0,-,1,3\n10,-,1,4\n")));
        QVERIFY(says(bench, 0, QStringLiteral("cannot be used")));
        QTRY_VERIFY(bench.user.find("roleOfColumn4"));
        const QStringList roles{QStringLiteral("target"), QStringLiteral("direction"),
            QStringLiteral("run"), QStringLiteral("deviation")};
        bench.user.the<QTabWidget>("measureTabs").setCurrentIndex(1);
        for (int n = 1; n <= 4; ++n) {
            const QByteArray name = "roleOfColumn" + QByteArray::number(n);
            QVERIFY(bench.user.choose(name, roles[n - 1]));
        }
        QVERIFY(says(bench, 0, QStringLiteral("ready"))
            || says(bench, 0, QStringLiteral("warnings: 1")));
        QCOMPARE(cell(bench, 0, 2), QStringLiteral("1 up, 1 down"));
    }

    void aProblemOpensItsLineOfTheFile()
    {
        PageFixture bench;
        QVERIFY(bench.user.isThere() && showMeasure(bench));
        QVERIFY(add(bench,
            bench.file(QStringLiteral("bad.csv"),
                "target [mm],direction,run,deviation [um]\n0,+,1,0.2\n1,sideways,1,0.3\n")));
        QVERIFY(says(bench, 0, QStringLiteral("cannot be used")));
        QWidget& page = bench.user.the("measurePage");
        auto* problems = page.findChild<QTreeView*>(QStringLiteral("problems"));
        QTRY_VERIFY(problems->isVisible());
        const auto* title = page.findChild<QLabel*>(QStringLiteral("problemTitle"));
        QCOMPARE(title->text(), QStringLiteral("bad.csv cannot be used."));
        problems->setCurrentIndex(problems->model()->index(0, 0));
        Q_EMIT problems->activated(problems->currentIndex());
        auto* lines = page.findChild<QTableView*>(QStringLiteral("fileLines"));
        QTRY_VERIFY(lines && lines->isVisible());
    }

    void whatTheFileLeavesOpenIsChosen()
    {
        PageFixture bench;
        QVERIFY(bench.user.isThere() && showMeasure(bench));
        QVERIFY(add(bench,
            bench.file(QStringLiteral("wide.csv"),
                "exported by hand\ntarget_mm,up1 [um],up2 [um]\n0,1,2\n10,2,3\n20,3,3\n")));
        QVERIFY(says(bench, 0, QStringLiteral("cannot be used")));
        auto& lines = bench.user.the<QSpinBox>("skippedLines");
        lines.setValue(1);
        QVERIFY(bench.user.choose("measurementFormat", QStringLiteral("wide")));
        QVERIFY(bench.user.choose("measurementValues", QStringLiteral("deviations")));
        QTRY_COMPARE(cell(bench, 0, 2), QStringLiteral("2 up, 0 down"));
        QVERIFY(bench.user.click("swapDirections"));
        QTRY_VERIFY(bench.user.the<QCheckBox>("swapDirections").isChecked());
    }

    void valuesOfAllFilesAreShownByTargetAndRun()
    {
        PageFixture bench;
        QVERIFY(showValues(bench, "ess_mcu1025"));
        const auto& model = *bench.user.the<QTableView>("runValues").model();
        QCOMPARE(model.rowCount(), 5);
        QCOMPARE(model.columnCount(), 11); // five runs up, five down
        QCOMPARE(model.headerData(0, Qt::Horizontal).toString(), QStringLiteral("Target [mm]"));
        QCOMPARE(model.headerData(6, Qt::Horizontal).toString(), QStringLiteral("↓ 1 [µm]"));
        QCOMPARE(valueText(bench, 1, 0), QStringLiteral("25.2"));
        QCOMPARE(valueText(bench, 0, 1), QStringLiteral("11.11")); // 0.0111123 mm
        QCOMPARE(valueText(bench, 0, 6), QStringLiteral("93.18")); // 0.0931843 mm
        QCOMPARE(model.index(0, 6).data(Qt::AccessibleTextRole).toString(),
            QStringLiteral("down, target 1, run 1, 93.18 µm"));
        // Runs of a second file follow those of the first.
        QVERIFY(add(bench, publicMeasurement("b02_x")));
        QTRY_COMPARE(model.columnCount(), 21);
    }

    void aValueIsLeftOutByKeyAndUsedAgain()
    {
        PageFixture bench;
        QVERIFY(showValues(bench, "ess_mcu1025"));
        QCOMPARE(summary(bench), QStringLiteral("Values: 50, excluded: 0 (✕). ↑ up, ↓ down."));
        choose(bench, 0, 6);
        QVERIFY(!bench.user.the("useValuesAgain").isEnabled());
        bench.user.press(Qt::Key_Delete);
        QTRY_COMPARE(valueText(bench, 0, 6), QStringLiteral("✕ 93.18"));
        QCOMPARE(summary(bench), QStringLiteral("Values: 50, excluded: 1 (✕). ↑ up, ↓ down."));
        QVERIFY(bench.user.the<QTableView>("runValues").currentIndex().column() == 6);
        QVERIFY(bench.user.click("useValuesAgain"));
        QTRY_COMPARE(valueText(bench, 0, 6), QStringLiteral("93.18"));
        QVERIFY(bench.user.the("runValues").hasFocus());
        bench.user.press(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(valueText(bench, 0, 6), QStringLiteral("✕ 93.18"));
    }

    void runsAndTargetsAreLeftOutAsAWhole()
    {
        PageFixture bench;
        QVERIFY(showValues(bench, "ess_mcu1025"));
        choose(bench, 2, 7);
        QVERIFY(bench.user.click("excludeRun"));
        QTRY_VERIFY(summary(bench).contains(QStringLiteral("excluded: 5"))); // one of each target
        for (int row = 0; row < 5; ++row)
            QVERIFY(valueText(bench, row, 7).startsWith(u'✕'));
        choose(bench, 4, 0);
        QVERIFY(!bench.user.the("excludeRun").isEnabled());
        QVERIFY(bench.user.click("excludeValues"));
        QTRY_VERIFY(summary(bench).contains(QStringLiteral("excluded: 14"))); // 5 + 10 - 1
        QVERIFY(
            valueText(bench, 4, 1).startsWith(u'✕') && !valueText(bench, 3, 1).startsWith(u'✕'));
    }

    void whatTheFileItselfLeavesOutIsNotUsedAgainHere()
    {
        PageFixture bench;
        const QString path = bench.file(QStringLiteral("used.csv"),
            "target [mm],direction,run,deviation [um],use\n"
            "0,+,1,1,1\n10,+,1,2,0\n0,-,1,3,1\n10,-,1,4,1\n");
        QVERIFY(bench.user.isThere() && showMeasure(bench) && add(bench, path));
        bench.user.the<QTabWidget>("measureTabs").setCurrentIndex(3);
        QTRY_COMPARE(valueText(bench, 1, 1), QStringLiteral("✕ 2.00"));
        choose(bench, 1, 1);
        QVERIFY(!bench.user.the("useValuesAgain").isEnabled());
    }

    void theMeasurementIsSavedAsRunsWithWhatIsExcludedMarked()
    {
        PageFixture bench;
        QVERIFY(bench.user.isThere() && showMeasure(bench));
        QVERIFY(!bench.user.the("saveMeasurement").isEnabled());
        const QString first = bench.file(QStringLiteral("first.csv"),
            "target [mm],direction,run,deviation [um]\n0,+,1,1\n10,+,1,2\n");
        const QString second = bench.file(QStringLiteral("second.csv"),
            "target [mm],direction,run,deviation [um]\n0,+,1,3\n10,+,1,4\n");
        QVERIFY(add(bench, first) && add(bench, second));
        bench.user.the<QTabWidget>("measureTabs").setCurrentIndex(3);
        QTRY_COMPARE(valueText(bench, 1, 2), QStringLiteral("4.00"));
        choose(bench, 1, 2);
        QVERIFY(bench.user.click("excludeValues"));
        QTRY_COMPARE(valueText(bench, 1, 2), QStringLiteral("✕ 4.00"));
        bench.picked = bench.path(QStringLiteral("both.csv"));
        QVERIFY(bench.user.click("saveMeasurement"));
        const auto& hint = bench.user.the<QLabel>("measureHint");
        QTRY_VERIFY(hint.text().startsWith(QStringLiteral("Saved as both.csv.")));
        QCOMPARE(bench.questions.back().purpose, FileQuestion::Purpose::SaveMeasurement);
        QVERIFY(bench.questions.back().start.endsWith(QStringLiteral("first-runs.csv")));
        QFile saved(bench.picked);
        QVERIFY(saved.open(QIODevice::ReadOnly));
        QCOMPARE(saved.readAll(),
            QByteArray("// axiscomp runs: 1\n"
                       "target [mm],direction,run,deviation [mm],use\n"
                       "0,+,1,0.001,1\n0,+,2,0.003,1\n10,+,1,0.002,1\n10,+,2,0.004,0\n"));
        // It is about what was shown.
        bench.user.press(Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY(!hint.text().startsWith(QStringLiteral("Saved")));
    }

    void aFileOfTheMeasurementIsNotWrittenOver()
    {
        PageFixture bench;
        QVERIFY(bench.user.isThere() && showMeasure(bench));
        const QByteArray content = "target [mm],direction,run,deviation [um]\n0,+,1,1\n10,+,1,2\n";
        const QString path = bench.file(QStringLiteral("own.csv"), content);
        QVERIFY(add(bench, path));
        QVERIFY(bench.user.click("saveMeasurement"));
        QTRY_VERIFY(bench.user.message("failureMessage")
                        .contains(QStringLiteral("own.csv cannot be written: it is one of the "
                                                 "files of this measurement")));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), content);
    }

    /// A file is written while the measurement may already be another one.
    void whatWasChangedMeanwhileIsNotSaidToBeSaved()
    {
        PageFixture bench;
        QVERIFY(bench.user.isThere() && showMeasure(bench));
        QVERIFY(add(bench,
            bench.file(QStringLiteral("first.csv"),
                "target [mm],direction,run,deviation [um]\n0,+,1,1\n10,+,1,2\n")));
        const auto& hint = bench.user.the<QLabel>("measureHint");
        QTRY_VERIFY(hint.text().startsWith(QStringLiteral("The measurement can be used.")));
        auto& page = bench.user.the<MeasurePage>("measurePage");
        page.showSaved(QStringLiteral("old-runs.csv"), std::make_shared<const Measurement>());
        QVERIFY(hint.text().startsWith(QStringLiteral("The measurement can be used.")));
    }

    void aTrackIsNamedAsWhatHasNoTargets()
    {
        PageFixture bench;
        QByteArray track = "encoder [mm],reference [mm]\n";
        for (int n = 0; n < 40; ++n)
            track += QByteArray::number(n) + ',' + QByteArray::number(n * 1.0001) + '\n';
        QVERIFY(bench.user.isThere() && showMeasure(bench));
        QVERIFY(add(bench, bench.file(QStringLiteral("track.csv"), track)));
        const auto& hint = bench.user.the<QLabel>("measureHint");
        QTRY_VERIFY(hint.text().startsWith(QStringLiteral("Without targets")));
        QVERIFY(!bench.user.the("saveMeasurement").isEnabled());
        QVERIFY(!bench.user.the<QTabWidget>("measureTabs").isTabVisible(3));
    }

    void aMillionValuesNeverStopTheWindow()
    {
        PageFixture bench;
        const auto began = test::Heartbeat::busy();
        QByteArray text = "target [mm],direction,run,deviation [um]\n";
        for (int run = 1; run <= 100; ++run)
            for (int target = 0; target < 10'000; ++target)
                text += QByteArray::number(target) + (run % 2 ? ",+," : ",-,")
                    + QByteArray::number((run + 1) / 2) + ",1.5\n";
        const QString path = bench.file(QStringLiteral("million.csv"), text);
        text.clear();
        const auto writing = test::Heartbeat::busy() - began;
        QVERIFY(bench.user.isThere() && showMeasure(bench));
        bench.user.the<QTabWidget>("measureTabs").setCurrentIndex(3);
        test::Heartbeat heart;
        QVERIFY(add(bench, path));
        QVERIFY(QTest::qWaitFor(
            [&] { return cell(bench, 0, 1) == QStringLiteral("ready"); }, 10 * test::patienceMs));
        bench.user.the<QTabWidget>("measureTabs").setCurrentIndex(3);
        choose(bench, 5, 5);
        QVERIFY(bench.user.click("excludeRun"));
        QVERIFY(QTest::qWaitFor(
            [&] { return valueText(bench, 5, 5).startsWith(u'✕'); }, 10 * test::patienceMs));
        // Whatever the machine: each value touched once takes about as long as writing the file
        // did.
        QVERIFY2(heart.longestBusy() < writing / 4,
            qPrintable(QStringLiteral("%1 us of %2 us")
                           .arg(heart.longestBusy().count())
                           .arg(writing.count())));
        auto& table = bench.user.the<QTableView>("runValues");
        table.selectAll();
        QVERIFY(!bench.user.the("excludeValues").isEnabled());
        QVERIFY(summary(bench).startsWith(QStringLiteral("Too many cells are selected")));
    }
};

AXISCOMP_WINDOW_TEST(TestMeasurePage)

} // namespace tst_measurepage

#include "tst_measurepage.moc"
