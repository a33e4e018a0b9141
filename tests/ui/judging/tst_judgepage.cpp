// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/heartbeat.h"
#include "tests/ui/support/measurement_files.h"
#include "tests/ui/support/page_fixture.h"
#include "tests/ui/support/window_test.h"
#include "ui/fields/wrong_mark.h"
#include "ui/page/page_tabs.h"
#include "ui/plot/deviation_plot.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QGroupBox>
#include <QTabWidget>
#include <QTableView>
#include <QTest>

#include "ui/drawing/custom_plot.h"

namespace tst_judgepage {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::PageFixture;
using test::publicMeasurement;

namespace {

PageTabs& tabsOf(PageFixture& bench)
{
    return bench.user.the<PageTabs>("pageTabs");
}

QAbstractItemModel& modelOf(PageFixture& bench, const char* table)
{
    return *bench.user.the<QTableView>(table).model();
}

QString cell(PageFixture& bench, const char* table, int row, int column)
{
    return modelOf(bench, table).index(row, column).data().toString();
}

int currentRow(PageFixture& bench, const char* table)
{
    return bench.user.the<QTableView>(table).currentIndex().row();
}

QString hint(PageFixture& bench)
{
    return bench.user.the<QLabel>("judgeHint").text();
}

QString readout(PageFixture& bench)
{
    return bench.user.the<QLabel>("deviationReadout").text();
}

[[nodiscard]] bool judgeFile(PageFixture& bench, const QString& path)
{
    if (!bench.user.isThere())
        return false;
    tabsOf(bench).setCurrentIndex(PageTabs::Measure);
    bench.picked = path;
    if (!bench.user.click("addMeasurement"))
        return false;
    tabsOf(bench).setCurrentIndex(PageTabs::Judge);
    return bench.user.sees("judgePage");
}

/// A file of runs does not say that it is corrected for the dead path, and would be once more.
void verifyRunsAreSavedUncorrected(PageFixture& bench)
{
    tabsOf(bench).setCurrentIndex(PageTabs::Measure);
    bench.picked = bench.path(QStringLiteral("saved.csv"));
    QVERIFY(bench.user.click("saveMeasurement"));
    QTRY_COMPARE(bench.user.the<QLabel>("measureHint").text(),
        QStringLiteral("Saved as saved.csv with the values of the files: the corrections are not "
                       "in it."));
    QFile saved(bench.picked);
    QVERIFY(saved.open(QIODevice::ReadOnly));
    QCOMPARE(saved.readAll(),
        QByteArray("// axiscomp runs: 1\n"
                   "target [mm],direction,run,deviation [mm]\n"
                   "0,+,1,0\n500,+,1,0\n"));
}

/// The tab Judge with a public measurement that has been judged.
[[nodiscard]] bool judge(PageFixture& bench, const char* name)
{
    return judgeFile(bench, publicMeasurement(name))
        && bench.user.waitFor([&] { return modelOf(bench, "figures").rowCount() > 0; });
}

/// Of the figure A in the table of figures.
[[nodiscard]] bool showsAccuracy(PageFixture& bench, const QString& value)
{
    return bench.user.waitFor([&] { return cell(bench, "figures", 0, 2) == value; });
}

} // namespace

/// The tab Judge, with public measurements whose figures are known.
class TestJudgePage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void withoutAMeasurementItSaysWhereToBegin()
    {
        PageFixture bench;
        QVERIFY(bench.user.isThere());
        tabsOf(bench).setCurrentIndex(PageTabs::Judge);
        QCOMPARE(tabsOf(bench).tabText(PageTabs::Judge), QStringLiteral("Judge · empty"));
        QCOMPARE(hint(bench), QStringLiteral("Add the files of a measurement on the tab Measure."));
        QVERIFY(!bench.user.the("toleranceA").isEnabled());
        QVERIFY(!bench.user.the("excludeProposed").isEnabled());
        // Keys in an empty plot do nothing.
        bench.user.the("deviationPicture").setFocus();
        bench.user.press(Qt::Key_Right);
        bench.user.press(Qt::Key_Delete);
        QVERIFY(readout(bench).isEmpty());
    }

    /// It says what should be: after "not met:" alone that read as what is.
    void aConditionThatIsNotMetIsQuoted()
    {
        QByteArray runs = "// compensation: off\ntarget [mm],direction,run,deviation [um]\n";
        constexpr int offsets[] = {1, -2, 2, -1, 0}; // each twice in every run
        for (int run = 1; run <= 5; ++run)
            for (const char* direction : {"up", "down"})
                for (int i = 0; i < 10; ++i)
                    runs += QByteArray::number(10 * i) + ',' + direction + ','
                        + QByteArray::number(run) + ','
                        + QByteArray::number(i * i % 7 + 0.1 * offsets[(run + 3 * i) % 5]) + '\n';
        PageFixture bench;
        QVERIFY(judgeFile(bench, bench.file(QStringLiteral("runs.csv"), runs)));
        QTRY_COMPARE(hint(bench),
            QStringLiteral(
                "The standard's condition “the file states the temperature” is not met."));
    }

    void toleranceAndVerdictStandBesideTheFigure()
    {
        PageFixture bench;
        QVERIFY(judge(bench, "bifrost"));
        QVERIFY(showsAccuracy(bench, QStringLiteral("18.57")));
        QVERIFY(bench.user.enter("toleranceA", QStringLiteral("10")));
        QTRY_COMPARE(cell(bench, "figures", 0, 3), QStringLiteral("10.00"));
        QCOMPARE(cell(bench, "figures", 0, 4), QStringLiteral("failed, uncertainty not stated"));
        QCOMPARE(hint(bench),
            QStringLiteral("Accuracy A: 18.57 µm, above the tolerance 10 µm. Go on to Fit: a table "
                           "may make it smaller."));
        QCOMPARE(tabsOf(bench).mark(PageTabs::Judge), PageTabs::Mark::Warning);
        QVERIFY(bench.user.enter("toleranceA", QStringLiteral("0.0195 mm")));
        QTRY_VERIFY(cell(bench, "figures", 0, 4).startsWith(QStringLiteral("passed")));
        QCOMPARE(bench.user.the<QLineEdit>("toleranceA").text(), QStringLiteral("19.5 µm"));
        QVERIFY(bench.user.enter("uncertainty", QStringLiteral("2")));
        QTRY_COMPARE(cell(bench, "figures", 0, 4), QStringLiteral("undecided, U 2.00 µm"));
        QVERIFY(hint(bench).endsWith(QStringLiteral("That is undecided.")));
        QVERIFY(bench.user.click("toleranceA"));
        bench.user.press(Qt::Key_A, Qt::ControlModifier);
        bench.user.press(Qt::Key_Delete);
        bench.user.press(Qt::Key_Return);
        QTRY_COMPARE(cell(bench, "figures", 0, 4), QStringLiteral("–"));
        // What no table can do is not asked of one.
        QVERIFY(bench.user.enter("toleranceR", QStringLiteral("1")));
        QTRY_VERIFY(hint(bench).endsWith(QStringLiteral("look at the mechanics.")));
    }

    /// It would become a tolerance of the next record when the keyboard leaves the field.
    void whatWasTypedIsNotTakenForTheNextRecord()
    {
        PageFixture bench;
        QVERIFY(judge(bench, "bifrost"));
        QVERIFY(bench.user.enter("toleranceA", QStringLiteral("ten")));
        QTRY_VERIFY(bench.user.sees("limitProblem"));
        bench.user.the<QAction>("newRecordAction").trigger();
        QVERIFY(bench.user.click("loseRecordButton"));
        QTRY_VERIFY(!bench.user.sees("limitProblem"));
        QVERIFY(bench.user.the<QLineEdit>("toleranceA").text().isEmpty());
        QVERIFY(!bench.user.the<QLineEdit>("toleranceA").isModified());
    }

    void whatIsNoAmountIsNotTaken()
    {
        PageFixture bench;
        QVERIFY(judge(bench, "bifrost"));
        QVERIFY(bench.user.enter("toleranceA", QStringLiteral("ten")));
        QTRY_VERIFY(bench.user.sees("limitProblem"));
        QVERIFY(bench.user.the<QLabel>("limitProblem").text().contains(QStringLiteral("\"ten\"")));
        QCOMPARE(bench.user.the("toleranceA").accessibleDescription(),
            bench.user.the<QLabel>("limitProblem").text());
        QCOMPARE(cell(bench, "figures", 0, 4), QStringLiteral("–"));
        QVERIFY(bench.user.enter("toleranceA", QStringLiteral("10um")));
        QTRY_VERIFY(!bench.user.sees("limitProblem"));
        QTRY_COMPARE(cell(bench, "figures", 0, 3), QStringLiteral("10.00"));
    }

    /// The tolerance that was not taken would be missing in silence.
    void eachFieldThatIsNotTakenSaysSoUntilItIs()
    {
        PageFixture bench;
        QVERIFY(judge(bench, "bifrost"));
        const auto& problem = bench.user.the<QLabel>("limitProblem");
        const auto& systematic = bench.user.the<QLineEdit>("toleranceE");
        const auto& repeatability = bench.user.the<QLineEdit>("toleranceR");
        QVERIFY(bench.user.enter("toleranceE", QStringLiteral("six")));
        QTRY_VERIFY(bench.user.sees("limitProblem"));
        QVERIFY(bench.user.enter("toleranceR", QStringLiteral("one")));
        QTRY_VERIFY(isMarkedWrong(repeatability));
        QVERIFY(isMarkedWrong(systematic));
        QVERIFY2(problem.text().contains(QStringLiteral("\"six\"")), qPrintable(problem.text()));
        QVERIFY(repeatability.toolTip().contains(QStringLiteral("\"one\"")));
        QVERIFY(bench.user.enter("toleranceR", QStringLiteral("2")));
        QTRY_VERIFY(!isMarkedWrong(repeatability));
        QVERIFY(isMarkedWrong(systematic));
        QVERIFY2(problem.text().contains(QStringLiteral("\"six\"")), qPrintable(problem.text()));
        QCOMPARE(systematic.accessibleDescription(), problem.text());
        QVERIFY(!repeatability.toolTip().contains(QStringLiteral("\"one\"")));
        QVERIFY(bench.user.enter("toleranceE", QStringLiteral("6")));
        QTRY_VERIFY(!bench.user.sees("limitProblem"));
        QVERIFY(!isMarkedWrong(systematic));
    }

    void everythingProposedIsExcludedInOneStepAndComesBack()
    {
        PageFixture bench;
        QVERIFY(judge(bench, "ess_mcu1025"));
        QVERIFY(showsAccuracy(bench, QStringLiteral("204.76")));
        QTRY_COMPARE(hint(bench),
            QStringLiteral("2 values do not fit the others: look at them, and exclude them or "
                           "leave them in."));
        QCOMPARE(tabsOf(bench).tabText(PageTabs::Judge), QStringLiteral("Judge · warning"));
        QVERIFY(bench.user.click("excludeProposed"));
        QVERIFY(showsAccuracy(bench, QStringLiteral("89.27")));
        QCOMPARE(cell(bench, "figures", 0, 5), QStringLiteral("204.76"));
        QCOMPARE(bench.user.the<QLabel>("judgeHeading").text(),
            QStringLiteral("2 values excluded, not an evaluation by ISO 230-2."));
        QVERIFY(!bench.user.the("excludeProposed").isEnabled());
        bench.user.the("outliers").setFocus();
        bench.user.press(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(showsAccuracy(bench, QStringLiteral("204.76")));
        QCOMPARE(bench.user.the<QLabel>("judgeHeading").text(),
            QStringLiteral("Figures of ISO 230-2:2014"));
    }

    void aToleranceThatOnlyTheChosenValuesMeetIsSaid()
    {
        PageFixture bench;
        QVERIFY(judge(bench, "ess_mcu1025"));
        QVERIFY(bench.user.enter("toleranceA", QStringLiteral("100")));
        QTRY_VERIFY(cell(bench, "figures", 0, 4).startsWith(QStringLiteral("failed")));
        QVERIFY(bench.user.click("excludeProposed"));
        QTRY_VERIFY(cell(bench, "figures", 0, 4).startsWith(QStringLiteral("passed")));
        QVERIFY2(hint(bench).startsWith(QStringLiteral("Of all values accuracy A is 204.7")),
            qPrintable(hint(bench)));
        QCOMPARE(tabsOf(bench).mark(PageTabs::Judge), PageTabs::Mark::Warning);
    }

    void whatIsExcludedIsUsedAgainFromTheList()
    {
        PageFixture bench;
        QVERIFY(judge(bench, "ess_mcu1025"));
        auto& outliers = bench.user.the<QTableView>("outliers");
        outliers.setFocus();
        outliers.setCurrentIndex(outliers.model()->index(0, 0));
        QVERIFY(!bench.user.the("useSelectedAgain").isEnabled());
        bench.user.press(Qt::Key_Delete);
        QTRY_COMPARE(cell(bench, "outliers", 1, 4), QStringLiteral("excluded"));
        outliers.setCurrentIndex(outliers.model()->index(1, 0));
        QVERIFY(!bench.user.the("excludeSelected").isEnabled());
        QVERIFY(bench.user.click("useSelectedAgain"));
        QTRY_COMPARE(cell(bench, "outliers", 1, 4), QStringLiteral("proposed"));
    }

    void anotherRuleFindsOthers()
    {
        PageFixture bench;
        QVERIFY(judge(bench, "ess_mcu1025"));
        QTRY_COMPARE(modelOf(bench, "outliers").rowCount(), 2);
        QVERIFY(bench.user.choose("outlierRule", QStringLiteral("no rule")));
        QTRY_COMPARE(modelOf(bench, "outliers").rowCount(), 0);
        bench.user.the("outliers").setFocus();
        bench.user.press(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(modelOf(bench, "outliers").rowCount(), 2);
        QCOMPARE(bench.user.the<QComboBox>("outlierRule").currentIndex(), 0);
    }

    void whatIsSelectedInOnePlaceIsSelectedInAll()
    {
        PageFixture bench;
        QVERIFY(judge(bench, "ess_mcu1025"));
        auto& outliers = bench.user.the<QTableView>("outliers");
        QTRY_COMPARE(outliers.model()->rowCount(), 2);
        outliers.setCurrentIndex(outliers.model()->index(1, 0));
        QVERIFY(readout(bench).startsWith(QStringLiteral("down, target 2, run 1, ")));
        QVERIFY(readout(bench).endsWith(QStringLiteral("proposed for exclusion")));
        QCOMPARE(currentRow(bench, "targetFigures"), 1);
        QCOMPARE(currentRow(bench, "runDrift"), 5);
        // By key in the plot: to the first target, in the same run.
        bench.user.the("deviationPicture").setFocus();
        bench.user.press(Qt::Key_Left);
        // 93.18 µm as it was read, from the mean of its target.
        QVERIFY(readout(bench).startsWith(QStringLiteral("down, target 1, run 1, 86.17 µm")));
        QCOMPARE(currentRow(bench, "outliers"), 0);
        QCOMPARE(currentRow(bench, "targetFigures"), 0);
        bench.user.press(Qt::Key_Delete);
        QTRY_VERIFY(readout(bench).endsWith(QStringLiteral("97.61 µm, excluded")));
        // A run in its table.
        auto& runs = bench.user.the<QTableView>("runDrift");
        runs.setCurrentIndex(runs.model()->index(2, 0));
        QCOMPARE(readout(bench), QStringLiteral("run 3, up"));
        QCOMPARE(currentRow(bench, "outliers"), -1);
    }

    void allValuesAreShownOnDemand()
    {
        PageFixture bench;
        QVERIFY(judge(bench, "ess_mcu1025"));
        auto& showsAll = bench.user.the<QCheckBox>("showAllValues");
        QVERIFY(!showsAll.isEnabled());
        QVERIFY(bench.user.click("excludeProposed"));
        QTRY_VERIFY(showsAll.isEnabled());
        QTRY_COMPARE(cell(bench, "targetFigures", 0, 5), QStringLiteral("4"));
        QVERIFY(bench.user.click("showAllValues"));
        QCOMPARE(cell(bench, "targetFigures", 0, 5), QStringLiteral("5"));
        // Nothing is left to be shown.
        bench.user.press(Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY(!showsAll.isEnabled() && !showsAll.isChecked());
    }

    void aSuspectedDriftIsSaid()
    {
        PageFixture bench;
        QVERIFY(judge(bench, "b02_y"));
        QTRY_VERIFY(hint(bench).startsWith(QStringLiteral("The runs up drift by -12.25")));
        QVERIFY(bench.user.the<QTabWidget>("judgeTabs").isTabVisible(5));
        QCOMPARE(cell(bench, "drift", 5, 1), QStringLiteral("suspected"));
        bench.user.the<QTabWidget>("judgePlots").setCurrentIndex(1);
        bench.user.the("driftPicture").setFocus();
        bench.user.press(Qt::Key_Right);
        bench.user.press(Qt::Key_Right);
        QVERIFY(bench.user.the("driftPicture")
                    .accessibleDescription()
                    .startsWith(QStringLiteral("up, run 2: offset ")));
        QCOMPARE(currentRow(bench, "runDrift"), 1);
        bench.user.press(Qt::Key_Down);
        QCOMPARE(currentRow(bench, "runDrift"), 6);
    }

    /// Each file would need its own.
    void aTemperatureThatNotAllFilesSayIsNotProposed()
    {
        PageFixture bench;
        const auto file = [&bench](const QString& name, const QByteArray& celsius,
                              const QByteArray& value) {
            return bench.file(name,
                "// material temperature: " + celsius
                    + "\n// expansion: 11.5e-6\ntarget [mm],direction,run,deviation [um]\n"
                      "0,+,1,0\n500,+,1,"
                    + value + "\n0,-,1,0\n500,-,1,0\n");
        };
        QVERIFY(judgeFile(
            bench, file(QStringLiteral("cold.csv"), QByteArray("20.5"), QByteArray("1"))));
        QVERIFY(judgeFile(
            bench, file(QStringLiteral("warm.csv"), QByteArray("24.5"), QByteArray("2"))));
        QTRY_COMPARE(cell(bench, "targetFigures", 0, 2), QStringLiteral("2"));
        QVERIFY(bench.user.click("corrections"));
        QTRY_VERIFY(bench.user.sees("correctionsDialog"));
        QVERIFY(bench.user.the<QLineEdit>("materialTemperature").text().isEmpty());
        QCOMPARE(bench.user.the<QLineEdit>("materialExpansion").text(), QStringLiteral("11.5"));
        QVERIFY(bench.user.click("rejectCorrections"));
    }

    void valuesAreBroughtTo20DegreesWhenAskedFor()
    {
        PageFixture bench;
        const QString path = bench.file(QStringLiteral("warm.csv"),
            "// material temperature: 22.5\ntarget [mm],direction,run,deviation [um]\n"
            "0,+,1,0\n500,+,1,0\n0,-,1,0\n500,-,1,0\n");
        QVERIFY(judgeFile(bench, path));
        QTRY_COMPARE(cell(bench, "figures", 11, 2), QStringLiteral("0.00")); // M
        QVERIFY(bench.user.click("corrections"));
        QTRY_VERIFY(bench.user.sees("correctionsDialog"));
        // The file's temperature is proposed, and nothing is assumed.
        QCOMPARE(bench.user.the<QLineEdit>("materialTemperature").text(), QStringLiteral("22.5"));
        QVERIFY(bench.user.the<QLineEdit>("materialExpansion").text().isEmpty());
        QVERIFY(!bench.user.the<QGroupBox>("temperatureCorrection").isChecked());
        bench.user.the<QGroupBox>("temperatureCorrection").setChecked(true);
        QVERIFY(bench.user.click("acceptCorrections"));
        QVERIFY(bench.user.the<QLabel>("correctionProblem")
                    .text()
                    .startsWith(QStringLiteral("Enter temperatures")));
        QVERIFY(bench.user.click("steelExpansion"));
        QCOMPARE(bench.user.the<QLineEdit>("materialExpansion").text(), QStringLiteral("11.5"));
        QVERIFY(bench.user.click("acceptCorrections"));
        QVERIFY(bench.user.the<QLabel>("correctionProblem")
                    .text()
                    .startsWith(QStringLiteral("The file does not say")));
        QVERIFY(bench.user.click("notCorrected"));
        QVERIFY(bench.user.click("acceptCorrections"));
        // 500 mm * 11.5e-6/K * 2.5 K
        QTRY_COMPARE(cell(bench, "figures", 11, 2), QStringLiteral("14.37"));
        QVERIFY(bench.user.the<QLabel>("correctionsText")
                    .text()
                    .contains(QStringLiteral("11.5 µm/(m·K): values changed by up to 14.37 µm")));
        QVERIFY(test::showActive(bench.window));
        bench.user.the("outliers").setFocus();
        bench.user.press(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(cell(bench, "figures", 11, 2), QStringLiteral("0.00"));
        QCOMPARE(
            bench.user.the<QLabel>("correctionsText").text(), QStringLiteral("No corrections."));
    }

    void exchangedDirectionsAreSaidWithTheCorrections()
    {
        PageFixture bench;
        QVERIFY(judge(bench, "b02_y"));
        QTRY_COMPARE(
            bench.user.the<QLabel>("correctionsText").text(), QStringLiteral("No corrections."));
        bench.user.the<QAbstractButton>("swapDirections").click();
        QTRY_COMPARE(bench.user.the<QLabel>("correctionsText").text(),
            QStringLiteral("Up and down exchanged."));
    }

    /// As when a capture ends, or a record that was being read is there.
    void correctionsOfOneMeasurementAreNotThoseOfAnother()
    {
        PageFixture bench;
        const QByteArray content("target [mm],direction,run,deviation [um]\n0,+,1,0\n500,+,1,0\n");
        QVERIFY(judgeFile(bench, bench.file(QStringLiteral("one.csv"), content)));
        QTRY_VERIFY(modelOf(bench, "figures").rowCount() > 0);
        QVERIFY(bench.user.click("corrections"));
        QTRY_VERIFY(bench.user.sees("correctionsDialog"));
        bench.wizard.openFile(bench.file(QStringLiteral("other.csv"), content));
        QTRY_VERIFY(!bench.user.sees("correctionsDialog"));
        QCOMPARE(
            bench.user.the<QLabel>("correctionsText").text(), QStringLiteral("No corrections."));
    }

    void aDeadPathIsReadFromItsFile()
    {
        PageFixture bench;
        QVERIFY(judgeFile(bench,
            bench.file(QStringLiteral("laser.csv"),
                "target [mm],direction,run,deviation [um]\n0,+,1,0\n500,+,1,0\n")));
        QTRY_VERIFY(modelOf(bench, "figures").rowCount() > 0);
        QVERIFY(bench.user.click("corrections"));
        QTRY_VERIFY(bench.user.sees("correctionsDialog"));
        bench.picked = bench.file(QStringLiteral("bad.json"), "{}");
        QVERIFY(bench.user.click("openDeadPath"));
        QCOMPARE(bench.questions.back().purpose, FileQuestion::Purpose::OpenDeadPath);
        QTRY_VERIFY(bench.user.the<QLabel>("correctionProblem")
                        .text()
                        .contains(QStringLiteral("bad.json")));
        bench.picked = bench.file(QStringLiteral("dead-path.json"),
            R"({"length": 300, "atZero": {"pressure": 101.325, "temperature": 20, "humidity": 50},
                "runs": [{"direction": "up", "run": 1,
                          "air": {"pressure": 101.325, "temperature": 22, "humidity": 50}}]})");
        QVERIFY(bench.user.click("openDeadPath"));
        QTRY_COMPARE(bench.user.the<QLabel>("deadPathText").text(),
            QStringLiteral("300 mm; runs with their air: 1"));
        QVERIFY(bench.user.click("acceptCorrections"));
        QTRY_VERIFY(
            bench.user.the<QLabel>("correctionsText")
                .text()
                .startsWith(QStringLiteral("Dead path of 300 mm: values changed by up to ")));
        verifyRunsAreSavedUncorrected(bench);
    }

    void aTrackHasNoFiguresAndIsToldWhatToDo()
    {
        PageFixture bench;
        QByteArray track = "encoder [mm],reference [mm]\n";
        for (int n = 0; n < 40; ++n)
            track += QByteArray::number(n) + ',' + QByteArray::number(n * 1.0001) + '\n';
        QVERIFY(judgeFile(bench, bench.file(QStringLiteral("track.csv"), track)));
        QTRY_VERIFY(hint(bench).startsWith(QStringLiteral("This measurement has no targets")));
        QVERIFY(hint(bench).contains(QStringLiteral("Fit")));
        QCOMPARE(modelOf(bench, "figures").rowCount(), 0);
        QVERIFY(!bench.user.the("toleranceA").isEnabled());
        QCOMPARE(tabsOf(bench).mark(PageTabs::Judge), PageTabs::Mark::Empty);
    }

    void aFileThatCannotBeUsedIsNamed()
    {
        PageFixture bench;
        QVERIFY(judgeFile(bench, bench.file(QStringLiteral("none.csv"), "no,measurement\n1,2\n")));
        QTRY_COMPARE(
            hint(bench), QStringLiteral("A file cannot be used: the tab Measure says why."));
        QCOMPARE(tabsOf(bench).mark(PageTabs::Judge), PageTabs::Mark::Warning);
    }

    void aMillionValuesNeverStopTheWindow()
    {
        PageFixture bench;
        const auto began = test::Heartbeat::busy();
        QByteArray text = "target [mm],direction,run,deviation [um]\n";
        for (int run = 1; run <= 100; ++run)
            for (int target = 0; target < 10'000; ++target)
                text += QByteArray::number(target) + (run % 2 ? ",+," : ",-,")
                    + QByteArray::number((run + 1) / 2) + ',' + QByteArray::number(target % 7)
                    + '\n';
        const QString path = bench.file(QStringLiteral("million.csv"), text);
        text.clear();
        const auto writing = test::Heartbeat::busy() - began;
        QVERIFY(bench.user.isThere());
        test::Heartbeat heart;
        QVERIFY(judgeFile(bench, path));
        QVERIFY(QTest::qWaitFor(
            [&] { return modelOf(bench, "figures").rowCount() > 0; }, 20 * test::patienceMs));
        QTest::qWait(100);
        auto& targets = bench.user.the<QTableView>("targetFigures");
        bench.user.the<QTabWidget>("judgeTabs").setCurrentIndex(1);
        targets.setCurrentIndex(targets.model()->index(5000, 0));
        QVERIFY(readout(bench).startsWith(QStringLiteral("target 5000 mm")));
        QVERIFY(bench.user.click("excludeSelected"));
        QVERIFY(QTest::qWaitFor(
            [&] { return bench.user.the("showAllValues").isEnabled(); }, 20 * test::patienceMs));
        QTest::qWait(100);
        // Whatever the machine: each value touched once takes about as long as writing the file
        // did.
        QVERIFY2(heart.longestBusy() < writing / 4,
            qPrintable(QStringLiteral("%1 us of %2 us")
                           .arg(heart.longestBusy().count())
                           .arg(writing.count())));
    }
};

AXISCOMP_WINDOW_TEST(TestJudgePage)

} // namespace tst_judgepage

#include "tst_judgepage.moc"
