// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/calibration_csv.h"
#include "core/metrology/fit/measurement_fit.h"
#include "core/metrology/record/calibration_record.h"
#include "tests/ui/support/heartbeat.h"
#include "tests/ui/support/measurement_files.h"
#include "tests/ui/support/page_fixture.h"
#include "tests/ui/support/window_test.h"
#include "ui/controller/setup_history.h"
#include "ui/page/page_tabs.h"

#include <QAction>
#include <QCheckBox>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QTableWidget>
#include <QTest>

#include <cmath>

namespace tst_fitpage {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::PageFixture;
using test::publicMeasurement;

namespace {

const std::string setPosition = "Axes[0]/Signals/PathPlanner/Position";

/// To a tab, by key.
[[nodiscard]] bool show(PageFixture& bench, PageTabs::Tab tab)
{
    const auto& tabs = bench.user.the<PageTabs>("pageTabs");
    bench.user.the("pageTabs").setFocus();
    for (int n = 0; n < PageTabs::TabCount && tabs.currentIndex() != tab; ++n)
        bench.user.press(Qt::Key_PageUp, Qt::ControlModifier);
    return tabs.currentIndex() == tab;
}

/// The tab Fit with this measurement.
[[nodiscard]] bool fit(PageFixture& bench, const QString& path)
{
    if (!bench.user.isThere() || !show(bench, PageTabs::Measure))
        return false;
    bench.picked = path;
    return bench.user.click("addMeasurement") && show(bench, PageTabs::Fit)
        && bench.user.sees("fitPage");
}

QString hint(PageFixture& bench)
{
    return bench.user.the<QLabel>("fitHint").text();
}

[[nodiscard]] bool hints(PageFixture& bench, const QString& beginning)
{
    const bool does = test::PageUser::waitFor([&] { return hint(bench).startsWith(beginning); });
    if (!does)
        qInfo("the hint is: %s", qPrintable(hint(bench)));
    return does;
}

[[nodiscard]] bool hasTable(PageFixture& bench)
{
    const bool has =
        test::PageUser::waitFor([&] { return bench.user.the("saveFittedTable").isEnabled(); });
    if (!has)
        qInfo("no table: %s", qPrintable(hint(bench)));
    return has;
}

/// Encoder, compensation off, the zero as measured: chapter 4.2 of the specification.
[[nodiscard]] bool chooseAsSpecified(PageFixture& bench)
{
    return bench.user.choose("fitMeasuredWith", QStringLiteral("off"))
        && bench.user.choose("fitLookup", QStringLiteral("encoder"))
        && bench.user.choose("fitZero", QStringLiteral("as measured")) && hasTable(bench);
}

/// Of the row that begins so; column 1 before, 2 foretold, 3 held out.
QString figure(PageFixture& bench, const QString& name, int column)
{
    const auto& figures = bench.user.the<QTableWidget>("fitFigures");
    for (int row = 0; row < figures.rowCount(); ++row)
        if (figures.item(row, 0)->text().contains(name))
            return figures.item(row, column)->text();
    return {};
}

bool saysRemark(PageFixture& bench, const QString& part)
{
    const auto& remarks = bench.user.the<QListWidget>("fitRemarks");
    for (int row = 0; row < remarks.count(); ++row)
        if (remarks.item(row)->text().contains(part))
            return true;
    return false;
}

/// Of the table along one axis.
bool hasPoints(PageFixture& bench, int count)
{
    return test::PageUser::waitFor(
        [&] { return saysRemark(bench, QStringLiteral(": %1 points, ").arg(count)); });
}

/// Deviations of X and Y over 40 x 30 mm, as an artefact shows them.
QByteArray plane()
{
    QByteArray text = "// compensation: off\nX [mm],Y [mm],dX [um],dY [um]\n";
    for (int y = 0; y <= 30; y += 5)
        for (int x = 0; x <= 40; x += 5)
            text += QByteArray::number(x) + ',' + QByteArray::number(y) + ','
                + QByteArray::number(0.1 * x) + ',' + QByteArray::number(-0.2 * y) + '\n';
    return text;
}

} // namespace

/// The tab on which a measurement becomes a table.
class TestFitPage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void theTabStandsBetweenTheMeasurementAndTheDrive()
    {
        PageFixture bench;
        QVERIFY(bench.user.isThere());
        const auto& tabs = bench.user.the<PageTabs>("pageTabs");
        QCOMPARE(tabs.tabText(PageTabs::Fit), QStringLiteral("Fit · empty"));
        QVERIFY(PageTabs::Measure < PageTabs::Fit && PageTabs::Fit < PageTabs::Write);
        QVERIFY(show(bench, PageTabs::Fit));
        QVERIFY(bench.user.sees("fitPage") && !bench.user.sees("writeButton"));
        QVERIFY(hint(bench).startsWith(QStringLiteral("Add the files of a measurement")));
        QVERIFY(!bench.user.the("useAsTable").isEnabled());
    }

    void nothingIsGuessedAndEachIsAskedFor()
    {
        PageFixture bench;
        QVERIFY(bench.open()); // an axis without a source
        QVERIFY(fit(bench, publicMeasurement("b02_x")));
        QVERIFY(hints(bench, QStringLiteral("Choose where the drive looks its table up")));
        QVERIFY(bench.user.choose("fitLookup", QStringLiteral("encoder")));
        QVERIFY(hints(bench, QStringLiteral("The measurement does not say whether")));
        QVERIFY(!bench.user.the("useAsTable").isEnabled());
        const auto& tabs = bench.user.the<PageTabs>("pageTabs");
        QCOMPARE(tabs.tabText(PageTabs::Fit), QStringLiteral("Fit · warning"));
        QVERIFY(bench.user.choose("fitMeasuredWith", QStringLiteral("off")));
        QVERIFY(hasTable(bench));
    }

    void theFileAnswersWhatItSays()
    {
        PageFixture bench;
        const QString path = bench.file(QStringLiteral("off.csv"),
            "// compensation: off\ntarget [mm],direction,run,deviation [um]\n"
            "0,+,1,1\n10,+,1,2\n20,+,1,4\n30,+,1,3\n0,-,1,1\n10,-,1,2\n20,-,1,4\n30,-,1,3\n");
        QVERIFY(fit(bench, path));
        QTRY_VERIFY(!bench.user.sees("fitMeasuredWith"));
        QVERIFY(bench.user.the<QLabel>("fitStateNote").text().contains(QStringLiteral("off")));
    }

    void bothPredictionsStandBesideTheFiguresBefore()
    {
        PageFixture bench;
        QVERIFY(fit(bench, publicMeasurement("b02_x")) && chooseAsSpecified(bench));
        QTRY_COMPARE(figure(bench, QStringLiteral("value B"), 2), QStringLiteral("33.47"));
        QCOMPARE(figure(bench, QStringLiteral(" A"), 1), QStringLiteral("135.27"));
        QCOMPARE(figure(bench, QStringLiteral(" A"), 2), QStringLiteral("55.18"));
        QCOMPARE(figure(bench, QStringLiteral(" R"), 2), QStringLiteral("54.98"));
        QCOMPARE(figure(bench, QStringLiteral(" M"), 2), QStringLiteral("0.00"));
        QCOMPARE(figure(bench, QStringLiteral(" M"), 3), QStringLiteral("75.03"));
        QCOMPARE(figure(bench, QStringLiteral("rms"), 3), QStringLiteral("21.00 µm"));
        QCOMPARE(figure(bench, QStringLiteral("largest"), 3), QStringLiteral("41.07 µm"));
        QVERIFY(saysRemark(bench, QStringLiteral("Between the targets")));
        QVERIFY(bench.user.the<QLabel>("fitSign").text().contains(
            QStringLiteral("the drive will add")));
        QVERIFY(
            saysRemark(bench, QStringLiteral("Largest correction: 57.84 µm at Position -10 mm")));
        const auto& remarks = bench.user.the<QListWidget>("fitRemarks");
        QVERIFY(remarks.item(0)
                    ->data(Qt::AccessibleTextRole)
                    .toString()
                    .startsWith(QStringLiteral("Warning: "))); // they come first
    }

    void residualsAreNotAddedOnceMoreAfterTheirOwnWrite()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        bench.picked =
            bench.file(QStringLiteral("old.csv"), "X [mm],dX [um]\n0,1\n10,1\n20,1\n30,1\n40,1\n");
        QVERIFY(bench.user.choose("dimensionalityField", QStringLiteral("1D"))
            && bench.user.click("openButton")
            && bench.user.enter("source1Field", QString::fromStdString(test::masterX)));
        QTRY_VERIFY(bench.controller().action(Action::Write).isEnabled);
        QVERIFY(bench.write());
        QByteArray runs = "target [mm],direction,run,deviation [um]\n";
        for (int target = 0; target <= 40; target += 10)
            for (const char* direction : {"+", "-"})
                runs += QByteArray::number(target) + ',' + direction + ",1,0.5\n";
        QVERIFY(fit(bench, bench.file(QStringLiteral("runs.csv"), runs)));
        QVERIFY(bench.user.choose("fitZero", QStringLiteral("as measured")));
        QVERIFY(bench.user.choose("fitOnto", QStringLiteral("table of the axis")));
        QVERIFY(bench.user.choose("fitMeasuredWith", QStringLiteral("merged onto")));
        QVERIFY(hasTable(bench) && bench.user.click("useAsTable"));
        QTRY_VERIFY(bench.controller().dataFile().isMade);
        QVERIFY(bench.write());
        QVERIFY(show(bench, PageTabs::Fit));
        QVERIFY(hints(bench, QStringLiteral("The measurement does not say whether")));
        QVERIFY(bench.user.the<QLabel>("fitStateNote")
                    .text()
                    .startsWith(QStringLiteral("The axis has another table")));
        QVERIFY(!bench.user.the("useAsTable").isEnabled());
    }

    void fieldsThatMeanNothingHereAreHidden()
    {
        PageFixture bench;
        QVERIFY(fit(bench, publicMeasurement("b02_x")) && chooseAsSpecified(bench));
        for (const char* hidden : {"fitSmoothness", "fitPeriods", "fitRobust", "fitFar", "fitBody",
                 "fitGain", "fitPoints", "fitZeroPosition", "fitColumn"})
            QVERIFY2(!bench.user.sees(hidden), hidden);
        QVERIFY(bench.user.choose("fitMethod", QStringLiteral("smooth")));
        QTRY_VERIFY(bench.user.sees("fitSmoothness") && bench.user.sees("fitPeriods"));
        QVERIFY(bench.user.choose("fitZero", QStringLiteral("at a position")));
        QTRY_VERIFY(bench.user.sees("fitZeroPosition"));
        QVERIFY(hints(bench, QStringLiteral("At: a number is needed")));
        QVERIFY(!bench.user.the("useAsTable").isEnabled());
        QVERIFY(bench.user.enter("fitZeroPosition", QStringLiteral("5")));
        QVERIFY(hasTable(bench));
    }

    void whatIsNoNumberIsNotTaken()
    {
        PageFixture bench;
        QVERIFY(fit(bench, publicMeasurement("b02_x")) && chooseAsSpecified(bench));
        QVERIFY(bench.user.enter("fitTurn", QStringLiteral("many")));
        QVERIFY(hints(bench, QStringLiteral("Turn: \"many\" cannot be taken")));
        QVERIFY(!bench.user.the("useAsTable").isEnabled());
        QVERIFY(bench.user.click("fitTurn"));
        bench.user.press(Qt::Key_A, Qt::ControlModifier);
        bench.user.press(Qt::Key_Delete);
        bench.user.press(Qt::Key_Return);
        QVERIFY(hasTable(bench));
    }

    void whatWasTypedIsNotTakenForTheNextRecord()
    {
        PageFixture bench;
        QVERIFY(fit(bench, publicMeasurement("b02_x")) && chooseAsSpecified(bench));
        QVERIFY(bench.user.enter("fitTurn", QStringLiteral("many")));
        QVERIFY(hints(bench, QStringLiteral("Turn: \"many\" cannot be taken")));
        bench.user.the<QAction>("newRecordAction").trigger();
        QVERIFY(bench.user.click("loseRecordButton"));
        QTRY_VERIFY(bench.user.the<QLineEdit>("fitTurn").text().isEmpty());
        QVERIFY(hints(bench, QStringLiteral("Add the files of a measurement")));
    }

    void theGridNeedsItsNumber()
    {
        PageFixture bench;
        QVERIFY(fit(bench, publicMeasurement("b02_x")) && chooseAsSpecified(bench));
        QVERIFY(hasPoints(bench, 9));
        QVERIFY(bench.user.choose("fitGrid", QStringLiteral("a number of points")));
        QVERIFY(hints(bench, QStringLiteral("Number: a number is needed")));
        QVERIFY(bench.user.enter("fitPoints", QStringLiteral("1")));
        QVERIFY(hints(bench, QStringLiteral("Number: \"1\" cannot be taken")));
        QVERIFY(bench.user.enter("fitPoints", QStringLiteral("41")));
        QVERIFY(hasTable(bench));
        QVERIFY(hasPoints(bench, 41));
        QVERIFY(bench.user.choose("fitGrid", QStringLiteral("a distance")));
        QVERIFY(bench.user.enter("fitDistance", QStringLiteral("2.5")));
        QVERIFY(hasPoints(bench, 17));
    }

    void everyChoiceIsOneStepBack()
    {
        PageFixture bench;
        QVERIFY(fit(bench, publicMeasurement("b02_x")) && chooseAsSpecified(bench));
        const auto& zero = bench.user.the<QComboBox>("fitZero");
        const auto& method = bench.user.the<QComboBox>("fitMethod");
        QVERIFY(bench.user.choose("fitMethod", QStringLiteral("spline")));
        QCOMPARE(method.currentIndex(), int(FitMethod::Spline));
        bench.user.press(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(method.currentIndex(), int(FitMethod::Linear));
        QCOMPARE(zero.currentIndex(), int(FitZero::Keep));
        bench.user.press(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(zero.currentIndex(), int(FitZero::Automatic));
        bench.user.press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_COMPARE(zero.currentIndex(), int(FitZero::Keep));
    }

    /// From the file of the instrument to the drive, with what the record says of it.
    void aMeasurementBecomesTheTableOnTheDrive()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        QVERIFY(bench.user.enter("source1Field", QString::fromStdString(test::masterX)));
        QVERIFY(fit(bench, publicMeasurement("b02_x")));
        QVERIFY(bench.user.choose("fitMeasuredWith", QStringLiteral("off")));
        // The source says where the table is looked up.
        QVERIFY(hasTable(bench));
        QVERIFY(bench.user.the<QLabel>("fitLookupNote")
                    .text()
                    .contains(QStringLiteral("before the compensation")));
        QVERIFY(bench.user.choose("fitZero", QStringLiteral("as measured")));
        QVERIFY(hasTable(bench));
        QVERIFY(bench.user.click("useAsTable"));
        const auto& tabs = bench.user.the<PageTabs>("pageTabs");
        QTRY_COMPARE(tabs.currentIndex(), int(PageTabs::Write));
        const auto table = bench.controller().selectedTable();
        QVERIFY(table && bench.controller().dataFile().isMade);
        QCOMPARE(bench.user.the<QLineEdit>("dataFile").text(), QStringLiteral("fit of b02_x.csv"));
        QVERIFY(bench.user.the<QComboBox>("tableField")
                    .currentText()
                    .contains(QStringLiteral("Fitted: Error")));
        // Nothing else is in the table, which lies at the targets.
        QVERIFY(bench.controller().signSentence().contains(QStringLiteral("the reference reads")));
        QVERIFY(bench.write());
        QVERIFY2(
            bench.saysOutcome(QStringLiteral("Written and verified")), qPrintable(bench.outcome()));
        QVERIFY(bench.controller().status()->table);
        // The mean of the first target, -35.5909 um.
        QVERIFY(std::abs(static_cast<double>(table->values.front()) + 0.0355909) < 1e-7);
        QCOMPARE(bench.controller().status()->table->crc, tableCrc(*table));
        // What was promised is kept with it: a step of the record.
        QVERIFY(show(bench, PageTabs::Fit));
        const auto* undo = bench.wizard.findChild<QAction*>(QStringLiteral("undoAction"));
        QVERIFY(undo && undo->text().contains(QStringLiteral("Table in use")));
    }

    void aTableOfWhichAZeroWasTakenOutNamesNoReference()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        QVERIFY(bench.user.enter("source1Field", QString::fromStdString(test::masterX)));
        QVERIFY(fit(bench, publicMeasurement("b02_x")));
        QVERIFY(bench.user.choose("fitMeasuredWith", QStringLiteral("off")));
        QVERIFY(hasTable(bench));
        QVERIFY(bench.user.click("useAsTable"));
        const auto& tabs = bench.user.the<PageTabs>("pageTabs");
        QTRY_COMPARE(tabs.currentIndex(), int(PageTabs::Write));
        const QString sign = bench.controller().signSentence();
        QVERIFY2(sign.startsWith(QStringLiteral("where the encoder reads")), qPrintable(sign));
        QVERIFY2(!sign.contains(QStringLiteral("reference")), qPrintable(sign));
    }

    void aSavedTableNamesAReferenceOnlyWhereItWasRead_data()
    {
        QTest::addColumn<QString>("zero");
        QTest::addColumn<bool>("isRead");
        QTest::newRow("kept") << QStringLiteral("as measured") << true;
        QTest::newRow("taken out") << QStringLiteral("at the first target") << false;
    }
    void aSavedTableNamesAReferenceOnlyWhereItWasRead()
    {
        QFETCH(const QString, zero);
        QFETCH(const bool, isRead);
        PageFixture bench;
        QVERIFY(fit(bench, publicMeasurement("b02_x")));
        QVERIFY(bench.user.choose("fitMeasuredWith", QStringLiteral("off")));
        QVERIFY(bench.user.choose("fitLookup", QStringLiteral("encoder")));
        QVERIFY(bench.user.choose("fitZero", zero) && hasTable(bench));
        QVERIFY(bench.user.click("saveFittedTable"));
        const auto says = [&](const QString& part) {
            return bench.user.sees("exportDialog")
                && bench.user.the<QPlainTextEdit>("conversionReport").toPlainText().contains(part);
        };
        QTRY_VERIFY(says(QStringLiteral("the feedback file says")));
        QCOMPARE(says(QStringLiteral("the reference ")), isRead);
        bench.user.press(Qt::Key_Escape);
        QTRY_VERIFY(!bench.user.sees("exportDialog"));
    }

    /// A table that was put there is one without a file: there is nothing to read again.
    void aTableThatWasMadeHereIsNotReadAgain()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        QVERIFY(fit(bench, publicMeasurement("b02_x")) && chooseAsSpecified(bench));
        QVERIFY(bench.user.click("useAsTable"));
        QTRY_VERIFY(bench.controller().dataFile().isMade);
        const auto data = bench.controller().dataFile().data;
        bench.controller().readDataAgain();
        bench.controller().setup().setDimensionality(2);
        QTest::qWait(50);
        QVERIFY(!bench.controller().dataFile().isReading);
        QVERIFY(bench.controller().dataFile().problems.empty()); // of a file that is not there
        QCOMPARE(bench.controller().dataFile().data, data);
        QVERIFY(bench.user.hint().contains(QStringLiteral("The table has 1 dimension")));
        // Undone on Write, as a file that was opened.
        bench.controller().history().undo();
        bench.controller().history().undo();
        QVERIFY(!bench.controller().dataFile().data);
    }

    void aTableForTheOtherSideOfTheCompensationIsNotWritten()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        QVERIFY(bench.user.enter("source1Field", QString::fromStdString(test::masterX)));
        QVERIFY(fit(bench, publicMeasurement("b02_x")));
        QVERIFY(bench.user.choose("fitMeasuredWith", QStringLiteral("off")));
        QVERIFY(bench.user.choose("fitLookup", QStringLiteral("set position")));
        QVERIFY(bench.user.choose("fitGrid", QStringLiteral("a number of points")));
        QVERIFY(bench.user.enter("fitPoints", QStringLiteral("9")));
        QVERIFY(hasTable(bench));
        QVERIFY(hints(bench, QStringLiteral("The table was made for a position after")));
        QVERIFY(bench.user.click("useAsTable"));
        QTRY_VERIFY(bench.controller().selectedTable());
        const ActionState write = bench.controller().action(Action::Write);
        QVERIFY(!write.isEnabled);
        QVERIFY2(write.reason.contains(QStringLiteral("made for a position after")),
            qPrintable(write.reason));
        QVERIFY(bench.user.enter("source1Field", QString::fromStdString(setPosition)));
        QTRY_VERIFY(bench.controller().action(Action::Write).isEnabled);
    }

    /// The axis X of a twin machine has another error.
    void aTableOfAnotherMeasuredDriveIsNotWritten()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        QVERIFY(bench.user.enter("source1Field", QString::fromStdString(test::masterX)));
        QByteArray runs = "// axis: X\n// compensation: off\n// drive: Mill, serial number 850618\n"
                          "target [mm],direction,run,deviation [um]\n";
        for (int target = 0; target <= 40; target += 10)
            for (const char* direction : {"+", "-"})
                runs += QByteArray::number(target) + ',' + direction + ",1,"
                    + QByteArray::number(target / 10) + '\n';
        QVERIFY(fit(bench, bench.file(QStringLiteral("runs.csv"), runs)));
        QVERIFY(hasTable(bench));
        QVERIFY(hints(bench, QStringLiteral("The line // drive: of the file says")));
        QVERIFY(bench.user.click("useAsTable"));
        QTRY_VERIFY(bench.controller().selectedTable());
        QCOMPARE(bench.controller().dataFile().measuredDrive, std::optional<std::int32_t>(850618));
        const ActionState write = bench.controller().action(Action::Write);
        QVERIFY(!write.isEnabled);
        QVERIFY2(
            write.reason.contains(QStringLiteral("850618 was measured, and this one has 1559")),
            qPrintable(write.reason));
        // As a file it says the same, and so does one of the drive that is connected.
        const std::string text = writeCalibrationCsv(*bench.controller().dataFile().data);
        QByteArray table = QByteArray::fromStdString(text);
        bench.controller().importData(bench.file(QStringLiteral("table.csv"), table), {});
        QTRY_VERIFY(!bench.controller().dataFile().isMade);
        QVERIFY(!bench.controller().action(Action::Write).isEnabled);
        table.replace("850618", "1559");
        bench.controller().importData(bench.file(QStringLiteral("own.csv"), table), {});
        QTRY_VERIFY(bench.controller().action(Action::Write).isEnabled);
    }

    /// In one dimension both are the first source: their names tell them apart.
    void aTableOfAnotherAxisIsNotWritten()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        QVERIFY(bench.user.enter("source1Field", QString::fromStdString(test::masterX)));
        const QByteArray runs = "// axis: Y\n// compensation: off\n"
                                "target [mm],direction,run,deviation [um]\n"
                                "0,+,1,1\n10,+,1,3\n20,+,1,2\n30,+,1,5\n";
        QVERIFY(fit(bench, bench.file(QStringLiteral("y.csv"), runs)) && hasTable(bench));
        QVERIFY(
            hints(bench, QStringLiteral("The table corrects axis Y, and the current axis is X: ")));
        QVERIFY(bench.user.click("useAsTable"));
        QTRY_VERIFY(bench.controller().dataFile().isMade);
        QVERIFY(bench.user.click("writeButton"));
        QVERIFY(bench.idle());
        QTRY_VERIFY(bench.controller().isOutcomeAnError());
        QVERIFY2(bench.outcome().contains(QStringLiteral("the name on the drive is X")),
            qPrintable(bench.outcome()));
        QVERIFY(!bench.user.sees("confirmWriteButton"));
    }

    /// As the same table from a file: the errors of Y are not written to X, and no angles.
    void whatDoesNotSuitTheAxisIsNotWritten()
    {
        PageFixture bench;
        QVERIFY(bench.open() && bench.choose2D());
        QVERIFY(fit(bench, bench.file(QStringLiteral("plane.csv"), plane())));
        QVERIFY(hasTable(bench)); // by the source, which is set
        QVERIFY(bench.user.choose("fitColumn", QStringLiteral("dY")));
        QVERIFY(bench.user.click("useAsTable"));
        QTRY_VERIFY(bench.controller().dataFile().isMade);
        QVERIFY(bench.user.click("writeButton"));
        QVERIFY(bench.idle());
        QTRY_VERIFY(bench.controller().isOutcomeAnError());
        QVERIFY2(bench.outcome().contains(QStringLiteral("dY")), qPrintable(bench.outcome()));
        QVERIFY(!bench.user.sees("confirmWriteButton"));

        QByteArray turns = "// compensation: off\ntarget [deg],direction,run,deviation [arcsec]\n";
        for (const char* direction : {"+", "-"})
            for (int target = 0; target <= 40; target += 10)
                turns += QByteArray::number(target) + ',' + direction + ",1,2\n";
        QVERIFY(show(bench, PageTabs::Measure));
        bench.user.the("measurementFiles").setFocus();
        bench.user.press(Qt::Key_Delete);
        QVERIFY(fit(bench, bench.file(QStringLiteral("turns.csv"), turns)) && hasTable(bench));
        QVERIFY(bench.user.click("useAsTable"));
        QTRY_COMPARE(bench.controller().dataFile().path, QStringLiteral("fit of turns.csv"));
        bench.controller().setup().setDimensionality(1);
        QVERIFY(bench.user.click("writeButton"));
        QVERIFY(bench.idle());
        QTRY_VERIFY(bench.controller().isOutcomeAnError());
        QVERIFY(!bench.user.sees("confirmWriteButton"));
    }

    void theTableIsSavedAsTheCommandLineDoesIt()
    {
        PageFixture bench;
        QVERIFY(fit(bench, publicMeasurement("b02_x")) && chooseAsSpecified(bench));
        bench.picked = bench.path(QStringLiteral("table.csv"));
        QVERIFY(bench.user.click("saveFittedTable"));
        QVERIFY(bench.user.click("acceptConversion"));
        QTRY_VERIFY(QFile::exists(bench.picked));
        QCOMPARE(bench.questions.back().purpose, FileQuestion::Purpose::SaveTable);
        QVERIFY(bench.questions.back().start.endsWith(QStringLiteral("b02_x-table.csv")));
        const CsvReading read = readCalibrationCsv(bench.picked.toStdString(), CsvOptions());
        QVERIFY(read.data && read.data->tables.front().values.size() == 9);
        QVERIFY(read.data->notes.front().starts_with("made of b02_x.csv (runs)"));
        QVERIFY(
            std::abs(static_cast<double>(read.data->tables.front().values[2]) - 0.0578386) < 1e-7);
    }

    void pointsAreAMapWhoseColumnIsChosenByItsName()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        QVERIFY(fit(bench, bench.file(QStringLiteral("plane.csv"), plane())));
        QVERIFY(bench.user.choose("fitLookup", QStringLiteral("encoder")) && hasTable(bench));
        QTRY_VERIFY(bench.user.sees("fitMap") && !bench.user.sees("fitPlot"));
        const auto& column = bench.user.the<QComboBox>("fitColumn");
        QCOMPARE(column.currentText(), QStringLiteral("dX")); // of the current axis
        QVERIFY(!bench.user.sees("fitMethod") && bench.user.sees("fitRobust"));
        QVERIFY(bench.user.choose("fitColumn", QStringLiteral("dY")));
        QVERIFY(bench.user.click("useAsTable"));
        QTRY_VERIFY(bench.controller().selectedTable());
        const auto table = bench.controller().selectedTable();
        QCOMPARE(table->name, std::string("dY"));
        // -0.2 um for each millimetre of Y, 0 at the lowest corner
        QVERIFY(std::abs(static_cast<double>(table->values.back()) + 0.006) < 1e-6);
        QCOMPARE(bench.controller().dataFile().data->tables.size(), std::size_t{2});
        QVERIFY(bench.user.hint().contains(QStringLiteral("The table has 2 dimensions")));
    }

    void residualsAreMergedOntoTheTableOfTheDrive()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        QVERIFY(bench.user.enter("source1Field", QString::fromStdString(test::masterX)));
        bench.picked =
            bench.file(QStringLiteral("old.csv"), "X [mm],dX [um]\n0,1\n10,1\n20,1\n30,1\n40,1\n");
        QVERIFY(bench.user.click("openButton"));
        QVERIFY(bench.write());
        QTRY_VERIFY(bench.controller().driveTable());
        const std::uint32_t crc = bench.controller().status()->table->crc;
        QByteArray after = "// compensation: crc:" + QByteArray::number(crc, 16)
            + "\ntarget [mm],direction,run,deviation [um]\n";
        for (const char* direction : {"+", "-"})
            for (int target = 0; target <= 40; target += 10)
                after += QByteArray::number(target) + ',' + direction + ",1,0.5\n";
        QVERIFY(fit(bench, bench.file(QStringLiteral("after.csv"), after)));
        QVERIFY(hints(bench, QStringLiteral("These are residuals of the table")));
        QVERIFY(bench.user.choose("fitOnto", QStringLiteral("table of the axis")));
        QVERIFY(bench.user.choose("fitZero", QStringLiteral("as measured")));
        QVERIFY(hasTable(bench));
        QTRY_VERIFY(bench.user.sees("fitGain"));
        QVERIFY(bench.user.click("useAsTable"));
        QTRY_VERIFY(bench.controller().dataFile().isMade);
        for (const float value : bench.controller().selectedTable()->values)
            QVERIFY(std::abs(static_cast<double>(value) - 0.0015) < 1e-8);
    }

    void aFileOfTheTableThatWasActiveIsAskedFor()
    {
        PageFixture bench;
        QVERIFY(fit(bench, publicMeasurement("b02_x")));
        QVERIFY(bench.user.choose("fitLookup", QStringLiteral("encoder")));
        bench.picked = bench.file(
            QStringLiteral("old.csv"), "X [mm],dX [um]\n-20,1\n-10,1\n0,1\n10,1\n20,1\n");
        QVERIFY(bench.user.choose("fitMeasuredWith", QStringLiteral("merged onto")));
        QVERIFY(bench.user.choose("fitOnto", QStringLiteral("table of a file")));
        QTRY_COMPARE(bench.user.the<QLabel>("fitOntoNote").text(), QStringLiteral("old.csv"));
        QCOMPARE(bench.questions.back().purpose, FileQuestion::Purpose::OpenActiveTable);
        QVERIFY(hasTable(bench));
    }

    void aMillionValuesNeverStopTheWindow()
    {
        PageFixture bench;
        const auto began = test::Heartbeat::busy();
        QByteArray text = "// compensation: off\nX [mm],Y [mm],dX [um]\n";
        for (int y = 0; y < 1000; ++y)
            for (int x = 0; x < 1000; ++x)
                text += QByteArray::number(0.1 * x) + ',' + QByteArray::number(0.1 * y) + ','
                    + QByteArray::number((x * 7 + y * 13) % 100 * 0.01) + '\n';
        const QString path = bench.file(QStringLiteral("million.csv"), text);
        text.clear();
        const auto writing = test::Heartbeat::busy() - began;
        QVERIFY(fit(bench, path));
        QVERIFY(QTest::qWaitFor(
            [&] { return bench.user.the("fitLookup").isEnabled(); }, 3 * test::patienceMs));
        test::Heartbeat heart;
        QVERIFY(bench.user.choose("fitLookup", QStringLiteral("encoder")));
        QVERIFY(bench.user.choose("fitGrid", QStringLiteral("a number of points")));
        QVERIFY(bench.user.enter("fitPoints", QStringLiteral("41")));
        QVERIFY(bench.user.enter("fitSmoothness", QStringLiteral("1e-4")));
        QVERIFY(QTest::qWaitFor(
            [&] { return bench.user.the("useAsTable").isEnabled(); }, 3 * test::patienceMs));
        // Whatever the machine: each value touched once takes about as long as writing the file
        // did.
        QVERIFY2(heart.longestBusy() < writing / 4,
            qPrintable(QStringLiteral("%1 us of %2 us")
                           .arg(heart.longestBusy().count())
                           .arg(writing.count())));
    }
};

AXISCOMP_WINDOW_TEST(TestFitPage)

} // namespace tst_fitpage

#include "tst_fitpage.moc"
