// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/record/comparison.h"
#include "tests/support/verify.h"
#include "tests/ui/support/page_fixture.h"
#include "tests/ui/support/record_files.h"
#include "tests/ui/support/window_test.h"
#include "ui/page/page_tabs.h"
#include "ui/record/comparison_figures_model.h"

#include <QAccessible>
#include <QCheckBox>
#include <QHeaderView>
#include <QTableView>
#include <QTest>

#include <initializer_list>

#include "ui/drawing/custom_plot.h"

namespace tst_provepage {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::PageFixture;
using test::publicMeasurement;

namespace {

using Column = ComparisonFiguresModel::Column;

QString hint(PageFixture& bench)
{
    return bench.user.the<QLabel>("proveHint").text();
}

[[nodiscard]] bool hints(PageFixture& bench, const QString& words)
{
    const bool isSaid =
        QTest::qWaitFor([&] { return hint(bench).contains(words); }, test::patienceMs);
    if (!isSaid)
        qInfo("it says: %s", qPrintable(hint(bench)));
    return isSaid;
}

QString tabText(PageFixture& bench)
{
    return bench.user.the<PageTabs>("pageTabs").tabText(PageTabs::Prove);
}

int rowOf(Iso230Figure figure)
{
    return static_cast<int>(figure);
}

QModelIndex cell(PageFixture& bench, Iso230Figure figure, Column column)
{
    return bench.user.the<QTableView>("proveFigures").model()->index(rowOf(figure), column);
}

QString text(PageFixture& bench, Iso230Figure figure, Column column)
{
    return cell(bench, figure, column).data().toString();
}

/// The tab Prove of a record that is open.
[[nodiscard]] bool showProve(PageFixture& bench, const CalibrationRecord& record)
{
    if (!bench.user.isThere())
        return false;
    bench.wizard.openRecord(
        bench.file(QStringLiteral("x.axcal"), QByteArray::fromStdString(recordText(record))));
    bench.user.the<PageTabs>("pageTabs").setCurrentIndex(PageTabs::Prove);
    return QTest::qWaitFor(
        [&] { return bench.user.the<QLabel>("recordName").text() == QStringLiteral("x.axcal"); },
        test::patienceMs);
}

/// A second measurement with the table of the record, in two runs each way.
QByteArray smallErrorsAt(
    std::initializer_list<const char*> targets, const CalibrationRecord& record)
{
    QByteArray after = "// compensation: " + test::stateOf(record)
        + "\ntarget [mm],direction,run,deviation [um]\n";
    for (const char* const run : {",+,1,0.1\n", ",+,2,0.2\n", ",-,1,0.1\n", ",-,2,0.2\n"})
        for (const char* const target : targets)
            after += QByteArray(target) + run;
    return after;
}

[[nodiscard]] bool addAfter(PageFixture& bench, const QByteArray& content)
{
    bench.picked = bench.file(QStringLiteral("after.csv"), content);
    return bench.user.click("afterAddMeasurement");
}

CalibrationRecord withTolerance(double accuracy)
{
    CalibrationRecord record = test::recordOfFit();
    record.fit->settings.tolerances = {{Iso230Figure::A, accuracy}};
    return record;
}

[[nodiscard]] bool save(PageFixture& bench)
{
    return bench.user.click("saveRecord")
        && QTest::qWaitFor(
            [&] { return !bench.user.the<QLabel>("recordName").text().endsWith(u'*'); },
            test::patienceMs);
}

CalibrationRecord saved(PageFixture& bench)
{
    auto record = loadRecord(bench.path(QStringLiteral("x.axcal")).toStdString());
    if (!record)
        qFatal("%s", sentence(record.error()).c_str());
    return *std::move(record);
}

} // namespace

/// The tab Prove. The numbers of b02_x are those of docs/metrology.md; those after follow from the
/// two values of each target (tests/ui/support/record_files.h).
class TestProvePage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void figuresStandBesideWhatWasPredicted()
    {
        PageFixture bench;
        const CalibrationRecord record = withTolerance(0.01);
        QVERIFY(showProve(bench, record));
        QCOMPARE(tabText(bench), QStringLiteral("Prove · empty"));
        QVERIFY(hints(bench, QStringLiteral("Write the table and activate it, measure again")));
        QVERIFY(addAfter(bench, test::goodAfterMeasurement(test::stateOf(record))));
        QVERIFY(hints(bench, QStringLiteral("Within the tolerances (uncertainty not stated).")));
        QCOMPARE(tabText(bench), QStringLiteral("Prove · ready"));
        QCOMPARE(text(bench, Iso230Figure::A, Column::Before), QStringLiteral("135.27"));
        QCOMPARE(text(bench, Iso230Figure::A, Column::Predicted), QStringLiteral("55.18"));
        QCOMPARE(text(bench, Iso230Figure::A, Column::HeldOut), QStringLiteral("–"));
        QCOMPARE(text(bench, Iso230Figure::A, Column::After), QStringLiteral("3.83"));
        QCOMPARE(text(bench, Iso230Figure::A, Column::Change), QStringLiteral("-131.44"));
        QCOMPARE(text(bench, Iso230Figure::A, Column::Limit), QStringLiteral("10.00"));
        QCOMPARE(text(bench, Iso230Figure::A, Column::Verdict), QStringLiteral("passed"));
        QCOMPARE(text(bench, Iso230Figure::M, Column::Before), QStringLiteral("93.65"));
        QCOMPARE(text(bench, Iso230Figure::M, Column::HeldOut), QStringLiteral("75.03"));
        QCOMPARE(text(bench, Iso230Figure::M, Column::After), QStringLiteral("1.00"));
        QCOMPARE(text(bench, Iso230Figure::M, Column::Limit), QString());
        // 1.2 x 75.0335 + 2 / sqrt(2) / sqrt(4)
        QVERIFY(bench.user.the<QLabel>("provePromise")
                    .text()
                    .startsWith(QStringLiteral("As predicted: M is 1.00 µm after, and up to "
                                               "90.75 µm is as predicted")));
        QVERIFY(!bench.user.sees("proveHints"));
    }

    /// A is 1 + 2 sqrt(2) um.
    void aFigureReadsAsItWasDecided()
    {
        PageFixture bench;
        const CalibrationRecord record = withTolerance(0.0038284);
        QVERIFY(showProve(bench, record));
        QVERIFY(addAfter(bench, test::goodAfterMeasurement(test::stateOf(record))));
        QTRY_COMPARE(text(bench, Iso230Figure::A, Column::Verdict), QStringLiteral("failed"));
        QCOMPARE(text(bench, Iso230Figure::A, Column::After), QStringLiteral("3.82843"));
        QCOMPARE(text(bench, Iso230Figure::A, Column::Limit), QStringLiteral("3.82840"));
        QCOMPARE(text(bench, Iso230Figure::M, Column::After), QStringLiteral("1.00"));
    }

    /// A column that takes what the others leave is as narrow as that.
    void theVerdictIsReadWholeHoweverNarrowTheWindow()
    {
        PageFixture bench;
        bench.window.resize(900, 700);
        const CalibrationRecord record = withTolerance(0.01);
        QVERIFY(showProve(bench, record));
        QVERIFY(addAfter(bench, test::goodAfterMeasurement(test::stateOf(record))));
        QVERIFY(hints(bench, QStringLiteral("Within the tolerances")));
        const auto& figures = bench.user.the<QTableView>("proveFigures");
        QTRY_VERIFY(figures.columnWidth(Column::Verdict)
            > figures.fontMetrics().horizontalAdvance(QStringLiteral("passed")));
        QVERIFY(!figures.horizontalHeader()->stretchLastSection());
    }

    void aRowIsReadAsASentence()
    {
        PageFixture bench;
        const CalibrationRecord record = withTolerance(0.01);
        QVERIFY(showProve(bench, record));
        QVERIFY(addAfter(bench, test::goodAfterMeasurement(test::stateOf(record))));
        QVERIFY(hints(bench, QStringLiteral("Within the tolerances")));
        QCOMPARE(
            cell(bench, Iso230Figure::A, Column::Figure).data(Qt::AccessibleTextRole).toString(),
            QStringLiteral("accuracy A: Before 135.27 µm, Predicted 55.18 µm, After 3.83 µm, "
                           "Change -131.44 µm, Tolerance 10.00 µm, passed"));
        QCOMPARE(
            cell(bench, Iso230Figure::M, Column::HeldOut).data(Qt::AccessibleTextRole).toString(),
            QStringLiteral("Held out 75.03 µm"));
        const auto& left = *bench.user.the<QTableView>("proveResidual").model();
        QCOMPARE(left.rowCount(), 9);
        // Of the mean of both directions: sqrt(0.5 / 2 + 0.5 / 2) / 2
        QCOMPARE(left.index(1, 0).data(Qt::AccessibleTextRole).toString(),
            QStringLiteral("at -15 mm: 1.00 µm, standard error 0.35 µm"));
    }

    /// Set to zero 0.1 mm away, it would hide the error that is left.
    void theZeroOfTheInstrumentIsNotShown()
    {
        PageFixture bench;
        const CalibrationRecord record = withTolerance(0.01);
        QVERIFY(showProve(bench, record));
        QVERIFY(addAfter(bench,
            test::afterMeasurement(test::stateOf(record), [](int i) { return 100 + i % 2; })));
        QVERIFY(hints(bench, QStringLiteral("Within the tolerances")));
        const auto& left = *bench.user.the<QTableView>("proveResidual").model();
        QCOMPARE(left.index(1, 0).data(Qt::AccessibleTextRole).toString(),
            QStringLiteral("at -15 mm: 1.00 µm, standard error 0.35 µm"));
        QCOMPARE(left.headerData(1, Qt::Horizontal, Qt::ToolTipRole).toString(),
            QStringLiteral("0 = mean at -20 mm"));
        QCOMPARE(bench.user.the("residualPlot").accessibleDescription(),
            QStringLiteral("What is left lies between 0.00 µm and 1.00 µm."));
        const auto* plot = bench.user.the("residualPlot").findChild<QCustomPlot*>();
        QVERIFY(plot);
        QCOMPARE(plot->yAxis->label(), QStringLiteral("Deviation [µm]\n0 = mean at -20 mm"));
    }

    void whichTableWasActiveIsSaidByThePersonWhereTheFileDoesNot()
    {
        PageFixture bench;
        const CalibrationRecord record = withTolerance(0.01);
        QVERIFY(showProve(bench, record));
        QVERIFY(!bench.user.sees("tableStated"));
        QVERIFY(addAfter(bench, test::goodAfterMeasurement({})));
        QVERIFY(hints(bench, QStringLiteral("does not say which table was active")));
        QCOMPARE(tabText(bench), QStringLiteral("Prove · warning"));
        QVERIFY(!bench.user.the("keepAfter").isEnabled());
        QCOMPARE(bench.user.the<QTableView>("proveFigures").model()->rowCount(), 0);
        QVERIFY(bench.user.the<QCheckBox>("tableStated")
                    .text()
                    .contains(QString::fromStdString(crcText(record.tables.front().crc))));
        QVERIFY(bench.user.click("tableStated"));
        QVERIFY(hints(bench, QStringLiteral("Within the tolerances")));
        QVERIFY(bench.user.the("keepAfter").isEnabled());
        // Of another file it is to be said anew.
        bench.picked = publicMeasurement("b02_y");
        QVERIFY(bench.user.click("afterAddMeasurement"));
        QVERIFY(hints(bench, QStringLiteral("does not say which table was active")));
    }

    void aMeasurementOfAnotherStateIsRefused_data()
    {
        QTest::addColumn<QByteArray>("state");
        QTest::addColumn<QString>("words");
        QTest::newRow("off") << QByteArray("off") << QStringLiteral("with the compensation off");
        QTest::newRow("another table")
            << QByteArray("crc:00000001") << QStringLiteral("with the table 00000001 active");
    }
    void aMeasurementOfAnotherStateIsRefused()
    {
        QFETCH(QByteArray, state);
        QFETCH(QString, words);
        PageFixture bench;
        QVERIFY(showProve(bench, withTolerance(0.01)));
        QVERIFY(addAfter(bench, test::goodAfterMeasurement(state)));
        QVERIFY(hints(bench, words));
        QCOMPARE(tabText(bench), QStringLiteral("Prove · warning"));
        QVERIFY(!bench.user.sees("tableStated") && !bench.user.the("keepAfter").isEnabled());
        QCOMPARE(bench.user.the<QTableView>("proveFigures").model()->rowCount(), 0);
    }

    /// Three of the nine targets, and all of the travel.
    void farTargetsAreNotCalledLessOfTheAxis()
    {
        PageFixture bench;
        CalibrationRecord record = withTolerance(0.01);
        QVERIFY(showProve(bench, record));
        QVERIFY(addAfter(bench, smallErrorsAt({"-20", "0", "20"}, record)));
        QVERIFY(hints(bench, QStringLiteral("Within the tolerances")));
        const QString promise = bench.user.the<QLabel>("provePromise").text();
        QVERIFY2(promise.startsWith(QStringLiteral("Whether it is as predicted is open, since the "
                                                   "targets are farther apart than before: M is ")),
            qPrintable(promise));
    }

    /// Two of the nine targets: whatever the table does, its error over 40 mm is not seen.
    void overLessOfTheAxisNothingIsGreen()
    {
        PageFixture bench;
        CalibrationRecord record = withTolerance(0.01);
        QVERIFY(showProve(bench, record));
        QVERIFY(addAfter(bench, smallErrorsAt({"0", "5"}, record)));
        QVERIFY(hints(bench, QStringLiteral("Within the tolerances")));
        QVERIFY(bench.user.the<QLabel>("proveWarnings")
                    .text()
                    .contains(QStringLiteral("second one from 0 to 5 mm: over a shorter")));
        QVERIFY(bench.user.the<QLabel>("provePromise")
                    .text()
                    .startsWith(QStringLiteral("Whether it is as predicted is open")));
        QCOMPARE(tabText(bench), QStringLiteral("Prove · warning"));
    }

    void aToleranceThatIsNotMetIsNeverGreen()
    {
        PageFixture bench;
        CalibrationRecord record = withTolerance(0.003);
        QVERIFY(showProve(bench, record));
        QVERIFY(addAfter(bench, test::goodAfterMeasurement(test::stateOf(record))));
        QVERIFY(hints(
            bench, QStringLiteral("Not within the tolerances: A 3.83 µm (tolerance 3.00 µm).")));
        QCOMPARE(text(bench, Iso230Figure::A, Column::Verdict), QStringLiteral("failed"));
        QCOMPARE(tabText(bench), QStringLiteral("Prove · warning"));
    }

    void aToleranceWithinTheUncertaintyIsUndecided()
    {
        PageFixture bench;
        CalibrationRecord record = withTolerance(0.004);
        record.fit->settings.uncertainty = 0.001; // 3.83 + 1 > 4 > 3.83 - 1
        QVERIFY(showProve(bench, record));
        QVERIFY(addAfter(bench, test::goodAfterMeasurement(test::stateOf(record))));
        QVERIFY(hints(bench, QStringLiteral("Undecided, since the uncertainty is too large: A")));
        QCOMPARE(tabText(bench), QStringLiteral("Prove · warning"));
    }

    void aTableWithTheWrongSignIsToldAsAHint()
    {
        PageFixture bench;
        CalibrationRecord record = withTolerance(0.5);
        const auto used = usedMeasurement(*record.before);
        VERIFY_RESULT(used);
        const auto figures = iso230Figures(*used);
        QVERIFY(showProve(bench, record));
        QVERIFY(addAfter(bench, test::afterMeasurement(test::stateOf(record), [&](int i) {
            return 2000.0 * *figures.targets[static_cast<std::size_t>(i)].mean;
        })));
        QVERIFY(hints(bench, QStringLiteral("The machine is not as good as was predicted.")));
        QVERIFY(bench.user.the<QLabel>("proveHints")
                    .text()
                    .contains(QStringLiteral("the table has the wrong sign")));
        QVERIFY(bench.user.the<QLabel>("provePromise")
                    .text()
                    .startsWith(QStringLiteral("Not as predicted: M is 187.31 µm after")));
        QCOMPARE(tabText(bench), QStringLiteral("Prove · warning"));
    }

    /// Of targets that are too far apart M held out may be larger than M before.
    void aTableThatDoesNothingIsNotAsPredicted()
    {
        PageFixture bench;
        CalibrationRecord record = withTolerance(0.5);
        record.prediction->heldOut->range = 0.1;
        const auto used = usedMeasurement(*record.before);
        VERIFY_RESULT(used);
        const auto figures = iso230Figures(*used);
        QVERIFY(showProve(bench, record));
        QVERIFY(addAfter(bench, test::afterMeasurement(test::stateOf(record), [&](int i) {
            return 1000.0 * *figures.targets[static_cast<std::size_t>(i)].mean;
        })));
        QVERIFY(hints(bench, QStringLiteral("The machine is no better than before.")));
        QCOMPARE(bench.user.the<QLabel>("provePromise").text(),
            QStringLiteral("Not as predicted, since the machine is no better than before: M is "
                           "93.65 µm after and was 93.65 µm before."));
        QVERIFY(bench.user.the<QLabel>("proveHints")
                    .text()
                    .contains(QStringLiteral("the compensation was not active")));
        QCOMPARE(tabText(bench), QStringLiteral("Prove · warning"));
    }

    /// As by `axiscomp compare`.
    void whatIsNotCorrectedIsNotComparedWithWhatIs()
    {
        PageFixture bench;
        CalibrationRecord record = withTolerance(0.01);
        record.before->corrections.temperature =
            TemperatureCorrection{20.9, 11.5e-6, 20.0, 0.0, std::nullopt, true};
        QVERIFY(showProve(bench, record));
        QVERIFY(addAfter(bench, test::goodAfterMeasurement(test::stateOf(record))));
        QVERIFY(hints(bench,
            QStringLiteral("first measurement is corrected and the second is "
                           "not")));
        QCOMPARE(tabText(bench), QStringLiteral("Prove · warning"));
        QVERIFY(!bench.user.sees("provePromise") && !bench.user.the("keepAfter").isEnabled());
        QCOMPARE(bench.user.the<QTableView>("proveFigures").model()->rowCount(), 0);
    }

    void whatIsCorrectedBesideWhatIsNotIsComparedWithAWarning()
    {
        PageFixture bench;
        const CalibrationRecord record = withTolerance(0.01);
        QVERIFY(showProve(bench, record));
        QByteArray after = test::goodAfterMeasurement(test::stateOf(record));
        QVERIFY(addAfter(bench, after.replace("target", "// corrected: 20C\ntarget")));
        QVERIFY(hints(bench, QStringLiteral("corrected differently for temperature")));
        QCOMPARE(tabText(bench), QStringLiteral("Prove · warning"));
        QVERIFY(bench.user.sees("provePromise") && bench.user.the("keepAfter").isEnabled());
    }

    void whatIsKeptIsWhatTheCommandCompareKeeps()
    {
        PageFixture bench;
        CalibrationRecord record = withTolerance(0.01);
        QVERIFY(showProve(bench, record));
        QVERIFY(addAfter(bench, test::goodAfterMeasurement(test::stateOf(record))));
        QVERIFY(bench.user.click("keepAfter"));
        QVERIFY(hints(bench, QStringLiteral("The measurement is in the record")));
        QVERIFY(!bench.user.the("keepAfter").isEnabled());
        QVERIFY(save(bench));
        const CalibrationRecord kept = saved(bench);
        QCOMPARE(kept.after.size(), std::size_t{1});
        QCOMPARE(kept.after.front().isAsPredicted, std::optional(true));
        QCOMPARE(kept.after.front().measurement.files.front().file, std::string("after.csv"));
        QVERIFY(std::abs(*kept.after.front().figures[Iso230Figure::A]
                    - 1e-3 * (1.0 + 4.0 / std::sqrt(2.0)))
            < 1e-9);
        QCOMPARE(kept.verdict->figures.front().result, VerdictResult::Passed);
        QVERIFY(!kept.draft);
        // The same by the functions of the command.
        const auto before = usedMeasurement(*record.before);
        const auto after = usedMeasurement(kept.after.front().measurement);
        VERIFY_RESULT(before);
        VERIFY_RESULT(after);
        const auto comparison = compareMeasurements(*before, *after, comparisonRequest(record));
        VERIFY_RESULT(comparison);
        keepAfter(record, kept.after.front().measurement, *comparison);
        QCOMPARE(QByteArray::fromStdString(recordText(kept)),
            QByteArray::fromStdString(recordText(record)));
        // It is a step, as everything else of the record.
        bench.user.press(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(hints(bench, QStringLiteral("Keep it in the record")));
        QVERIFY(bench.user.the("keepAfter").isEnabled());
    }

    void whatWasKeptIsShownWhenTheRecordIsOpened()
    {
        PageFixture bench;
        CalibrationRecord record = withTolerance(0.01);
        {
            PageFixture first;
            QVERIFY(showProve(first, record));
            QVERIFY(addAfter(first, test::goodAfterMeasurement({})));
            QVERIFY(first.user.click("tableStated"));
            QVERIFY(first.user.click("keepAfter"));
            QVERIFY(hints(first, QStringLiteral("The measurement is in the record")));
            QVERIFY(save(first));
            record = saved(first);
        }
        QVERIFY(showProve(bench, record));
        QVERIFY(hints(bench, QStringLiteral("The measurement is in the record")));
        QCOMPARE(text(bench, Iso230Figure::A, Column::After), QStringLiteral("3.83"));
        const auto& files = *bench.user.the<QTableView>("afterMeasurementFiles").model();
        QCOMPARE(files.index(0, 0).data().toString(), QStringLiteral("after.csv"));
        QVERIFY(!bench.user.the("afterFileChoices").isEnabled());
    }

    void filesAreChosenAndTheirProblemsShownAsInMeasure()
    {
        PageFixture bench;
        QVERIFY(showProve(bench, withTolerance(0.01)));
        QVERIFY(addAfter(
            bench, "target [mm],direction,run,deviation [um]\n0,+,1,0.2\n1,sideways,1,0.3\n"));
        QVERIFY(hints(bench, QStringLiteral("after.csv")));
        QCOMPARE(tabText(bench), QStringLiteral("Prove · warning"));
        const auto* page = bench.user.find("provePage");
        const auto* problems = page->findChild<QWidget*>(QStringLiteral("afterProblems"));
        QTRY_VERIFY(problems && problems->isVisible());
        QCOMPARE(bench.questions.back().purpose, FileQuestion::Purpose::OpenMeasurement);
        // They are of this tab alone.
        QCOMPARE(bench.user.the<QTableView>("measurementFiles").model()->rowCount(), 1);
    }

    /// A tolerance that is met because the values that fail it are left out.
    void whatIsLeftOutIsSaidBesideTheFiguresOfAllValues()
    {
        PageFixture bench;
        const CalibrationRecord record = withTolerance(0.01);
        QVERIFY(showProve(bench, record));
        QByteArray content = test::goodAfterMeasurement(test::stateOf(record));
        QVERIFY(addAfter(bench, content));
        QVERIFY(hints(bench, QStringLiteral("Within the tolerances")));
        const auto& model = *bench.user.the<QTableView>("proveFigures").model();
        QVERIFY(!bench.user.sees("proveWarnings"));
        QCOMPARE(model.columnCount(), static_cast<int>(Column::AllBefore));

        QByteArrayList lines = content.trimmed().split('\n');
        for (qsizetype n = 2; n < lines.size(); ++n)
            lines[n] += n == 2 ? ",use" : lines[n].startsWith("20,") ? ",0" : ",1";
        for (QByteArray& line : lines)
            if (line.startsWith("20,+,1,"))
                line = "20,+,1,50,0";
        PageFixture other;
        QVERIFY(showProve(other, record));
        QVERIFY(addAfter(other, lines.join('\n') + '\n'));
        QVERIFY(hints(other, QStringLiteral("Within the tolerances")));
        QCOMPARE(tabText(other), QStringLiteral("Prove · warning"));
        QVERIFY(other.user.the<QLabel>("proveWarnings")
                    .text()
                    .contains(QStringLiteral("4 values excluded, not an evaluation by ISO 230-2")));
        QVERIFY(other.user.the<QLabel>("proveWarnings").text().contains(QStringLiteral("failed")));
        QCOMPARE(text(other, Iso230Figure::A, Column::AllBefore), QStringLiteral("135.27"));
        QCOMPARE(text(other, Iso230Figure::A, Column::After), QStringLiteral("3.83"));
        QVERIFY(text(other, Iso230Figure::A, Column::AllAfter).toDouble() > 10.0);
    }

    void withoutATableTheMeasurementsAreComparedAlone()
    {
        PageFixture bench;
        QVERIFY(bench.user.isThere());
        auto& tabs = bench.user.the<PageTabs>("pageTabs");
        tabs.setCurrentIndex(PageTabs::Measure);
        bench.picked = publicMeasurement("b02_x");
        QVERIFY(bench.user.click("addMeasurement"));
        tabs.setCurrentIndex(PageTabs::Prove);
        QVERIFY(hints(bench, QStringLiteral("No table of this record is in use")));
        bench.picked = publicMeasurement("b02_y");
        QVERIFY(bench.user.click("afterAddMeasurement"));
        QVERIFY(hints(bench, QStringLiteral("there is no verdict")));
        QCOMPARE(text(bench, Iso230Figure::A, Column::After), QStringLiteral("125.72"));
        QCOMPARE(text(bench, Iso230Figure::A, Column::Predicted), QStringLiteral("–"));
        QVERIFY(!bench.user.the("keepAfter").isEnabled());
    }
};

AXISCOMP_WINDOW_TEST(TestProvePage)

} // namespace tst_provepage

#include "tst_provepage.moc"
