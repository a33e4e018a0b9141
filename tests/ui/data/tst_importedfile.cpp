// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/controller_preview.h"
#include "core/conversion/table_export.h"
#include "core/conversion/table_import.h"
#include "core/formats/formats.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"
#include "tests/ui/support/controller_fixture.h"
#include "ui/async/background_job.h"
#include "ui/controller/setup_history.h"
#include "ui/dialogs/file_filters.h"
#include "ui/text/language.h"
#include "ui/text/message_text.h"

#include <QSignalSpy>
#include <QTest>

#include <algorithm>
#include <atomic>
#include <thread>

namespace tst_importedfile {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::ControllerFixture;

namespace {

/// Corrections of the command: the axis is 2 um short at 10 mm.
const QByteArray softmc = "1 5\n0 0\n10 -0.002\n20 -0.004\n30 -0.002\n40 0\n";
const QByteArray uneven = "X [mm],first [mm],second [mm]\n0,0,0\n10,0.001,-0.001\n15,0.004,-0.004\n"
                          "30,0.002,-0.002\n40,0,0\n";

ImportChoices onGrid(ResamplingChoice::Kind kind, double number)
{
    ImportChoices choices;
    choices.resampling.kind = kind;
    choices.resampling.numbers = {number};
    return choices;
}

/// A softMC file does not say that it corrects its own axis.
ImportChoices forItsOwnAxis()
{
    ImportChoices choices;
    choices.target = sourceTarget(0);
    return choices;
}

std::string joined(const std::vector<Text>& lines)
{
    std::string text;
    for (const Text& line : lines)
        text += line.english() + '\n';
    return text;
}

/// As the first source.
bool hasChosen(ControllerFixture& bench, const std::string& source)
{
    bench->chooseSource(1, QString::fromStdString(source));
    return QTest::qWaitFor(
        [&] { return bench->setup().edited().sources[0].path == source; }, test::patienceMs);
}

bool hasErrors(const DataFile& file)
{
    return std::ranges::any_of(
        file.problems, [](const Diagnostic& each) { return each.severity == Severity::Error; });
}

} // namespace

/// Files of other controllers, and uneven ones, as compensation data.
class TestImportedFile : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aCommandSideFileGetsTheSignOfTheDrive()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        bench->importData(bench.file(QStringLiteral("comp.txt"), softmc), forItsOwnAxis());
        QVERIFY(bench.fileRead());
        const DataFile& file = bench->dataFile();
        for (const Diagnostic& problem : file.problems)
            QVERIFY2(problem.severity == Severity::Warning, qPrintable(problemText(problem)));
        QCOMPARE(file.format, &softmc::format());
        const auto table = bench->selectedTable();
        QVERIFY(table);
        QCOMPARE(table->values.size(), std::size_t{5});
        // e(x) = -c(z) with z + c(z) = x, so a bit more than the 2 um of the file.
        QVERIFY(table->values[1] > 0.002F);
        QVERIFY(table->values[1] < 0.00201F);
        QVERIFY2(joined(file.report).find("softmc holds command values") != std::string::npos,
            joined(file.report).c_str());
    }

    void aFileThatDoesNotSayWhatItCorrectsIsAskedAbout()
    {
        ControllerFixture bench;
        QSignalSpy needed(&bench.controller(), &WizardController::importChoiceNeeded);
        const QString path = bench.file(QStringLiteral("comp.txt"), softmc);
        bench->openData(path);
        QVERIFY(bench.fileRead());
        QCOMPARE(needed.count(), 1);
        QVERIFY(!bench->selectedTable());
        ImportChoices choices = forItsOwnAxis();
        bench->importData(path, choices);
        QVERIFY(bench.fileRead());
        const auto own = bench->selectedTable();
        QVERIFY(own);
        choices.target = otherAxis;
        bench->importData(path, choices);
        QVERIFY(bench.fileRead());
        // The sign alone: the correction of another axis moves no place of this one.
        QCOMPARE(bench->selectedTable()->values[1], 0.002F);
        QVERIFY(own->values[1] > 0.002F);
    }

    void anImportedTableIsWrittenToTheDrive()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        bench.chooseMasterSources(1);
        bench->openData(bench.file(QStringLiteral("comp.txt"), softmc));
        QVERIFY(bench.fileRead());
        const auto table = bench->selectedTable();
        QTRY_VERIFY2(bench->action(Action::Write).isEnabled,
            qPrintable(bench->action(Action::Write).reason));
        QVERIFY(bench.planAndWrite());
        QVERIFY2(!bench->isOutcomeAnError(), qPrintable(bench->outcome()));
        QTRY_VERIFY(bench->driveTable());
        QCOMPARE(bench->driveTable()->values, table->values);
        QVERIFY(bench->driveTable()->values[1] > 0.0F);
    }

    /// What the axis is among its sources decides what its numbers are.
    void aFileIsReadAgainForOtherSources()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        bench->setup().setDimensionality(1);
        QVERIFY(hasChosen(bench, test::masterY));
        bench->openData(bench.file(QStringLiteral("comp.txt"), softmc));
        QVERIFY(bench.fileRead());
        QVERIFY(bench->selectedTable());
        const std::vector<float> ofAnother = bench->selectedTable()->values;
        QVERIFY(hasChosen(bench, test::masterX));
        QVERIFY(bench.fileRead());
        const std::vector<float> own = bench->selectedTable()->values;
        QVERIFY(own != ofAnother);
        bench->history().undo();
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->selectedTable()->values, ofAnother);
        bench->history().redo();
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->selectedTable()->values, own);
        bench->readDataAgain();
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->selectedTable()->values, own);
        QVERIFY(bench.planAndWrite());
        QVERIFY2(!bench->isOutcomeAnError(), qPrintable(bench->outcome()));
        QTRY_VERIFY(bench->driveTable());
        QCOMPARE(bench->driveTable()->values, own);
    }

    void aFileIsReadAgainForTheOtherSideOfTheCompensation()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        bench->setup().setDimensionality(1);
        QVERIFY(hasChosen(bench, test::masterX));
        bench->openData(bench.file(QStringLiteral("comp.txt"), softmc));
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->dataFile().lookupAt, std::optional(LookupAt::Encoder));
        QVERIFY(hasChosen(bench, "Axes[0]/Signals/PathPlanner/Position"));
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->dataFile().lookupAt, std::optional(LookupAt::Set));
        QTRY_VERIFY2(bench->action(Action::Write).isEnabled,
            qPrintable(bench->action(Action::Write).reason));
        QVERIFY(bench.planAndWrite());
        QVERIFY2(!bench->isOutcomeAnError(), qPrintable(bench->outcome()));
    }

    void sourcesForWhichAFileCannotBeReadAreAProblemAndNoQuestion()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        bench->setup().setDimensionality(1);
        QVERIFY(hasChosen(bench, test::masterY));
        bench->openData(bench.file(QStringLiteral("comp.txt"), softmc));
        QVERIFY(bench.fileRead());
        const std::vector<float> before = bench->selectedTable()->values;
        QSignalSpy needed(&bench.controller(), &WizardController::importChoiceNeeded);
        QVERIFY(hasChosen(bench, "Axes[0]/Signals/General/MotorTemperature"));
        QVERIFY(bench.fileRead());
        QVERIFY(hasErrors(bench->dataFile()));
        QCOMPARE(bench->selectedTable()->values, before);
        QVERIFY(hasChosen(bench, test::masterY));
        QVERIFY(bench.fileRead());
        QVERIFY(!hasErrors(bench->dataFile()));
        QCOMPARE(needed.count(), 0);
    }

    void theSignCanBeOverruled()
    {
        ControllerFixture bench;
        const QString path = bench.file(QStringLiteral("comp.txt"), softmc);
        ImportChoices choices;
        choices.sign = SignConvention::Feedback;
        bench->importData(path, choices);
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->selectedTable()->values[1], -0.002F);
        QCOMPARE(bench->importChoices(path), choices);
        // Read again, the choice stays; opened anew, it does not.
        bench->readDataAgain();
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->selectedTable()->values[1], -0.002F);
        bench->importData(path, forItsOwnAxis());
        QVERIFY(bench.fileRead());
        QVERIFY(bench->selectedTable()->values[1] > 0.0F);
    }

    void undoneAFileHasTheChoicesAgainWithWhichItWasRead()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        bench.chooseMasterSources(1);
        const QString path = bench.file(QStringLiteral("comp.txt"), softmc);
        ImportChoices choices;
        choices.sign = SignConvention::Feedback;
        bench->importData(path, choices);
        QVERIFY(bench.fileRead());
        bench->openData(bench.file(QStringLiteral("other.txt"), softmc));
        QVERIFY(bench.fileRead());
        bench->openData(path);
        QVERIFY(bench.fileRead());
        QVERIFY(bench->selectedTable()->values[1] > 0.0F);
        bench->history().undo();
        bench->history().undo();
        QCOMPARE(bench->dataFile().path, path);
        QCOMPARE(bench->selectedTable()->values[1], -0.002F);
        QVERIFY(bench->importChoices(path).sign == SignConvention::Feedback);
        bench->readDataAgain();
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->selectedTable()->values[1], -0.002F);
    }

    void choicesAfterAChangeOfTheDimensionalityGoWithIt()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        bench.chooseMasterSources(1);
        const QString path =
            bench.file(QStringLiteral("a.csv"), "X [mm],X error\n0,0.001\n10,0.002\n20,0.001\n");
        bench->openData(path);
        QVERIFY(bench.fileRead());
        for (const int dimensions : {2, 1}) {
            bench->setup().setDimensionality(dimensions);
            QVERIFY(bench.fileRead());
        }
        ImportChoices choices;
        choices.sign = SignConvention::Command;
        bench->importData(path, choices);
        QVERIFY(bench.fileRead());
        QVERIFY(bench->selectedTable()->values[0] < 0.0F);
        bench->history().undo();
        bench->history().undo();
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->selectedTable()->values[0], 0.001F);
        QVERIFY(!bench->importChoices(path).sign);
        bench->readDataAgain();
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->selectedTable()->values[0], 0.001F);
    }

    void choicesThatGaveNoTableAreNotThoseOfTheData_data()
    {
        QTest::addColumn<bool>("isCancelled");
        QTest::newRow("cancelled") << true;
        QTest::newRow("failed") << false;
    }
    void choicesThatGaveNoTableAreNotThoseOfTheData()
    {
        QFETCH(bool, isCancelled);
        ControllerFixture bench;
        const QString path = bench.file(QStringLiteral("comp.txt"), softmc);
        bench->importData(path, forItsOwnAxis());
        QVERIFY(bench.fileRead());
        const float before = bench->selectedTable()->values[1];
        ImportChoices choices = forItsOwnAxis();
        choices.sign = SignConvention::Feedback;
        if (!isCancelled)
            choices.format = &siemens_cec::format();
        bench->importData(path, choices);
        if (isCancelled)
            bench->cancelReading();
        QVERIFY(bench.fileRead());
        QCOMPARE(bench->selectedTable()->values[1], before);
        // What was said stays to be mended, but says nothing of the data.
        QCOMPARE(bench->importChoices(path).sign.has_value(), !isCancelled);
        bench->readDataAgain();
        QVERIFY(bench.fileRead());
        QVERIFY(!hasErrors(bench->dataFile()));
        QCOMPARE(bench->selectedTable()->values[1], before);
    }

    void valuesWithoutAUnitAreShownAsTheyAreWritten()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        bench->setup().setDimensionality(2);
        bench->openData(bench.file(QStringLiteral("plane.csv"),
            "X [um],Y [mm],table\n0,0,1\n40000,0,5\n0,20,2\n40000,20,3\n"));
        QVERIFY(bench.fileRead());
        QVERIFY(bench->dataFile().data);
        QCOMPARE(bench->signSentence(), QString()); // 5 um or 5 mm: that depends on the sources
        bench.chooseMasterSources(2);
        QVERIFY2(bench->signSentence().contains(QStringLiteral("will add +0.0050 mm")),
            qPrintable(bench->signSentence()));
        const auto shown = bench->selectedTable();
        QVERIFY(shown);
        QVERIFY(bench.planAndWrite());
        QVERIFY2(!bench->isOutcomeAnError(), qPrintable(bench->outcome()));
        QTRY_VERIFY(bench->driveTable());
        QCOMPARE(bench->driveTable()->values, shown->values);
    }

    void whatCannotBeWrittenInTheUnitOfTheAxisSaysWhyInPlaceOfTheSignSentence_data()
    {
        QTest::addColumn<QByteArray>("header");
        QTest::addColumn<QString>("said");
        QTest::newRow("values") << QByteArray("X [mm],X error [deg]")
                                << QStringLiteral("The values are in deg, ");
        QTest::newRow("positions") << QByteArray("X [deg],X error [mm]")
                                   << QStringLiteral("The positions of dimension 1 are in deg, ");
    }
    void whatCannotBeWrittenInTheUnitOfTheAxisSaysWhyInPlaceOfTheSignSentence()
    {
        QFETCH(const QByteArray, header);
        QFETCH(const QString, said);
        ControllerFixture bench;
        QVERIFY(bench.connect());
        bench.chooseMasterSources(1);
        bench->openData(bench.file(QStringLiteral("x.csv"), header + "\n0,0\n20,5\n40,0\n"));
        QVERIFY(bench.fileRead());
        QVERIFY(bench->dataFile().data);
        QTRY_VERIFY2(bench->signSentence().startsWith(said), qPrintable(bench->signSentence()));
    }

    void anUnevenFileNeedsAChoiceAndKeepsWhatThereWas()
    {
        ControllerFixture bench;
        bench->importData(bench.file(QStringLiteral("comp.txt"), softmc), forItsOwnAxis());
        QVERIFY(bench.fileRead());
        const auto before = bench->selectedTable();
        QVERIFY(before);
        QSignalSpy needed(&bench.controller(), &WizardController::importChoiceNeeded);
        const QString path = bench.file(QStringLiteral("uneven.csv"), uneven);
        bench->openData(path);
        QVERIFY(bench.fileRead());
        QCOMPARE(needed.count(), 1);
        QCOMPARE(needed.front().front().toString(), path);
        QCOMPARE(bench->selectedTable(), before);
        QVERIFY(!bench->dataFile().problems.empty());
        QCOMPARE(bench->dataFile().problems.front().code, DiagnosticCode::UnevenSpacing);
        QVERIFY(bench->dataFile().problems.front().line > 0);
    }

    /// A LinuxCNC file that does not say its type has warnings, too.
    void whyAFileNeedsAChoiceIsSaidBesideItsWarnings()
    {
        ControllerFixture bench;
        QSignalSpy needed(&bench.controller(), &WizardController::importChoiceNeeded);
        bench->openData(bench.file(
            QStringLiteral("lcnc.comp"), "0 0 0.001\n20 20.001 20.003\n40 40.002 40.005\n"));
        QVERIFY(bench.fileRead());
        QCOMPARE(needed.count(), 1);
        const auto& problems = bench->dataFile().problems;
        QCOMPARE(problems.front().severity, Severity::Warning);
        QCOMPARE(problems.back().severity, Severity::Error);
        const QString why = problemText(problems.back());
        QVERIFY2(why.contains(QStringLiteral("direction")), qPrintable(why));
        const QString said = bench->log().back().text();
        QVERIFY2(
            said.contains(QStringLiteral("lcnc.comp cannot be used as it is. ")), qPrintable(said));
        QVERIFY2(said.contains(QStringLiteral("direction")), qPrintable(said));
    }

    void anUnevenFileBecomesEvenAndSaysItsDeviation()
    {
        ControllerFixture bench;
        const QString path = bench.file(QStringLiteral("uneven.csv"), uneven);
        bench->importData(path, onGrid(ResamplingChoice::Kind::Distance, 10.0));
        QVERIFY(bench.fileRead());
        QVERIFY(bench->dataFile().data);
        QVERIFY(bench->dataFile().problems.empty());
        QCOMPARE(bench->dataFile().data->tables.size(), std::size_t{2});
        QCOMPARE(bench->selectedTable()->grid.axes[0].size, 5U);
        // At 15 the grid has the middle of 0.001 and 0.0033333, the file 0.004.
        const std::string report = joined(bench->dataFile().report);
        QVERIFY2(report.find("resampled from 5 points to 5 points") != std::string::npos,
            report.c_str());
        QVERIFY2(report.find("0.00183 mm") != std::string::npos, report.c_str());
    }

    void aDeviationToKeepIsAnsweredWithANumberOfPoints()
    {
        ControllerFixture bench;
        const QString path = bench.file(QStringLiteral("uneven.csv"), uneven);
        bench->importData(path, onGrid(ResamplingChoice::Kind::Within, 1e-6));
        QVERIFY(bench.fileRead());
        QVERIFY(bench->dataFile().data);
        // Steps of 5 meet every position of the file.
        QCOMPARE(bench->selectedTable()->grid.axes[0].size, 9U);
    }

    void twoColumnsWithoutAHeaderAreNotTakenForAnOffsetUnasked()
    {
        ControllerFixture bench;
        QSignalSpy needed(&bench.controller(), &WizardController::importChoiceNeeded);
        const QString path =
            bench.file(QStringLiteral("axis.csv"), "0,0\n10,0.002\n20,0.003\n30,0.001\n");
        bench->openData(path);
        QVERIFY(bench.fileRead());
        QVERIFY(!bench->dataFile().data);
        QCOMPARE(needed.count(), 1);
        ImportChoices choices;
        choices.format = &icube::format();
        bench->importData(path, choices);
        QVERIFY(bench.fileRead());
        QVERIFY(bench->dataFile().data);
        QVERIFY(bench->selectedTable()->values[1] < 0.0F);
        QCOMPARE(needed.count(), 1);
    }

    void aFileOfAnotherControllerKeepsItsOwnDimensions()
    {
        ControllerFixture bench;
        bench->importData(bench.file(QStringLiteral("comp.txt"), softmc), forItsOwnAxis());
        QVERIFY(bench.fileRead());
        bench->setup().setDimensionality(2);
        QVERIFY(!bench->dataFile().isReading);
        QCOMPARE(bench->selectedTable()->grid.dimensions(), 1);
    }

    void aTableThatIsExportedIsReadBack()
    {
        CompensationTable table = test::exampleTable(1);
        table.unit = "mm";
        table.grid.axes[0].unit = "mm";
        for (float& value : table.values)
            value *= 1e-4F;
        ImportChoices choices = forItsOwnAxis();
        choices.format = &softmc::format();
        const auto exported = exportTable(table, choices, "x.txt", genericTableLayout());
        VERIFY_RESULT(exported);
        const auto reading = softmc::format().read(exported->bytes, {});
        VERIFY_RESULT(reading);
        QVERIFY(!reading->hasErrors());
        QCOMPARE(reading->tables.front().pointCount(), table.values.size());
    }

    void softmcAppliesNothingBeforeTheFirstPosition()
    {
        CompensationTable table{"first", "mm", {{{"X", "mm", 10.0, 10.0, 4}}}, {}};
        table.values = {0.002F, 0.003F, 0.001F, 0.004F};
        const auto applied = tableAsAppliedBy(table, {"#1", {}}, softmc::format().facts);
        VERIFY_RESULT(applied);
        QCOMPARE(applied->grid.axes[0].start, 0.0);
        QCOMPARE(applied->grid.axes[0].size, 6U);
        QCOMPARE(applied->values.front(), 0.0F); // the drive would hold 0.002
        QVERIFY(applied->values[1] < -0.0019F); // of the command
        QVERIFY(applied->values[5] < -0.0039F); // held above the last one
        const auto atSet = tableAsAppliedBy(table, {"#1", LookupAt::Set}, softmc::format().facts);
        VERIFY_RESULT(atSet);
        QCOMPARE(
            atSet->values, (std::vector<float>{0.0F, -0.002F, -0.003F, -0.001F, -0.004F, -0.004F}));
        VERIFY_ERROR(
            tableAsAppliedBy(table, {}, softmc::format().facts), ErrorCode::TargetNotKnown);
        const auto ofDrive = tableAsAppliedBy(table, {}, calibration_csv::format().facts);
        VERIFY_RESULT(ofDrive);
        QCOMPARE(
            ofDrive->values, (std::vector<float>{0.002F, 0.002F, 0.003F, 0.001F, 0.004F, 0.004F}));
    }

    void pmacBeginsAgainAtTheOtherEnd()
    {
        CompensationTable table{"open", "mm", {{{"X", "mm", 10.0, 10.0, 4}}}, {}};
        table.values = {0.002F, 0.003F, 0.001F, 0.004F};
        const AxisPlace place{"#1", LookupAt::Set};
        const auto open = tableAsAppliedBy(table, place, pmac_1d::format().facts);
        VERIFY_RESULT(open);
        QCOMPARE(open->values,
            (std::vector<float>{-0.004F, -0.002F, -0.003F, -0.001F, -0.004F, -0.002F}));
        table.values.back() = 0.002F;
        const auto closed = tableAsAppliedBy(table, place, pmac_1d::format().facts);
        VERIFY_RESULT(closed);
        QCOMPARE(closed->values,
            (std::vector<float>{-0.001F, -0.002F, -0.003F, -0.001F, -0.002F, -0.003F}));
    }

    void ofManyRequestsOnlyTheNewestIsReported()
    {
        std::vector<int> reported;
        std::atomic<int> run = 0;
        const auto window = std::this_thread::get_id();
        NewestJob<int> job([&reported](int value) { reported.push_back(value); });
        job.start([&run](const std::stop_token& stop) {
            ++run;
            while (!stop.stop_requested())
                std::this_thread::yield();
            return 1;
        });
        std::atomic<bool> isElsewhere = false;
        for (int value = 2; value <= 5; ++value) {
            job.start([&run, &isElsewhere, window, value](const std::stop_token&) {
                ++run;
                isElsewhere = std::this_thread::get_id() != window;
                return value;
            });
        }
        QTRY_VERIFY(!reported.empty());
        QCOMPARE(reported, std::vector<int>{5});
        QCOMPARE(run.load(), 2); // those between were never begun
        QVERIFY(isElsewhere);
        job.start([](const std::stop_token&) { return 6; });
        job.cancel();
        job.start([](const std::stop_token&) { return 7; });
        QTRY_COMPARE(reported, (std::vector<int>{5, 7}));
    }

    void theOpenDialogKnowsEveryFormatThatCanBeRead()
    {
        const QString filter = openFilter();
        const QStringList entries = filter.split(QStringLiteral(";;"));
        const auto readable = std::ranges::count_if(
            tableFormats(), [](const TableFormat* format) { return format->read != nullptr; });
        QCOMPARE(entries.size(), readable + 2);
        for (const char* pattern : {"*.csv", "*.TAMtbl", "*.txt", "*.lis"})
            QVERIFY2(entries.front().contains(QLatin1StringView(pattern)), pattern);
        for (const QString& entry : entries)
            QCOMPARE(entry.count(u'('), 1);
    }

    void theReportIsGerman()
    {
        ControllerFixture bench;
        const QString path = bench.file(QStringLiteral("uneven.csv"), uneven);
        ImportChoices choices = onGrid(ResamplingChoice::Kind::Points, 9.0);
        choices.sign = SignConvention::Command;
        choices.target = sourceTarget(0);
        bench->importData(path, choices);
        QVERIFY(bench.fileRead());
        const std::vector<Text> report = bench->dataFile().report;
        QVERIFY(report.size() >= 3);
        const Language language(QStringLiteral("de"));
        for (const Text& line : report) {
            const QString german = sentenceText(line);
            for (const char* english : {" the ", " at ", " by ", " holds ", " from "})
                QVERIFY2(!german.contains(QLatin1StringView(english)), qPrintable(german));
        }
    }
};

AXISCOMP_TEST(TestImportedFile)

} // namespace tst_importedfile

#include "tst_importedfile.moc"
