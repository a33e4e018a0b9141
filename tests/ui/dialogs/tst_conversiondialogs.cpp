// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/calibration_csv.h"
#include "core/formats/formats.h"
#include "tests/ui/support/page_states.h"
#include "tests/ui/support/window_test.h"

#include <QComboBox>
#include <QFile>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTest>

#include <algorithm>

namespace tst_conversiondialogs {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::PageFixture;
using test::page_states::chooseAt;
using test::page_states::unevenFile;

namespace {

QString reason(PageFixture& bench)
{
    const auto& label = bench.user.the<QLabel>("conversionReason");
    return label.isVisible() ? label.text() : QString();
}

QString report(PageFixture& bench)
{
    return bench.user.the<QPlainTextEdit>("conversionReport").toPlainText();
}

bool mayAccept(PageFixture& bench)
{
    return bench.user.the("acceptConversion").isEnabled();
}

/// A 1D table in millimetres is chosen.
bool open1D(PageFixture& bench)
{
    bench.picked = bench.file(QStringLiteral("line.csv"),
        "// target: X, X\nX [mm],first [mm],second "
        "[mm]\n0,0,1\n10,0.001,2\n20,0.003,3\n30,0.002,4\n");
    return bench.open() && bench.user.click("openButton")
        && test::PageUser::waitFor([&] { return bench.controller().selectedTable() != nullptr; });
}

bool openExport(PageFixture& bench, const QString& format)
{
    bench.user.the<QAction>("exportAction").trigger();
    return test::PageUser::waitFor([&] { return bench.user.sees("exportDialog"); })
        && bench.user.choose("conversionFormat", format);
}

} // namespace

/// The dialogs about files of other controllers.
class TestConversionDialogs : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void anUnevenFileAsksByItselfAndSaysTheDeviationFirst()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        bench.picked = unevenFile(bench);
        QVERIFY(user.click("openButton"));
        QTRY_VERIFY(user.sees("importDialog"));
        QTRY_VERIFY2(
            reason(bench).contains(QStringLiteral("not evenly spaced")), qPrintable(reason(bench)));
        QVERIFY(!mayAccept(bench));
        QCOMPARE(user.the("acceptConversion").toolTip(), reason(bench));
        QVERIFY(chooseAt(bench, "gridField", 2));
        QVERIFY(!mayAccept(bench)); // the distance is missing
        QCOMPARE(reason(bench), QStringLiteral("Enter a number for the even grid."));
        QVERIFY(user.click("gridNumberField"));
        user.type(QStringLiteral("1 250"));
        QTRY_COMPARE(
            reason(bench), QStringLiteral("\"1 250\" is no number, and no list such as 21; 31."));
        user.the<QLineEdit>("gridNumberField").selectAll();
        user.type(QStringLiteral("10"));
        QTRY_VERIFY(mayAccept(bench));
        QVERIFY2(report(bench).contains(QStringLiteral("off by at most 0.00183 mm")),
            qPrintable(report(bench)));
        QVERIFY(!bench.controller().dataFile().data); // nothing has been taken yet
        QVERIFY(user.click("acceptConversion"));
        QTRY_VERIFY(bench.controller().dataFile().data);
        QCOMPARE(bench.controller().selectedTable()->grid.axes[0].size, 5U);
        QVERIFY(!user.sees("importDialog"));
    }

    void aFileWithGapsAsksAndIsFilled()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        bench.picked = bench.file(QStringLiteral("gaps.csv"),
            "X [mm],first [mm],second [mm]\n0,0,0\n10,0.001,\n20,nan,2\n"
            "30,0.003,3\n");
        QVERIFY(user.click("openButton"));
        QTRY_VERIFY(user.sees("importDialog"));
        QTRY_VERIFY2(reason(bench).contains(QStringLiteral("can be filled or left out")),
            qPrintable(reason(bench)));
        QVERIFY(!mayAccept(bench));
        QVERIFY(chooseAt(bench, "missingField", static_cast<int>(MissingPoints::Plane)));
        QTRY_VERIFY2(mayAccept(bench), qPrintable(reason(bench)));
        for (const char* filled : {"1 of 4 points of first", "1 of 4 points of second"})
            QVERIFY2(report(bench).contains(QLatin1StringView(filled)), qPrintable(report(bench)));
        QVERIFY(!report(bench).contains(QStringLiteral("taken as they are")));
        QVERIFY(user.click("acceptConversion"));
        QTRY_VERIFY(bench.controller().dataFile().data);
        const CompensationTable& table = *bench.controller().selectedTable();
        QCOMPARE(table.filled, (std::vector<std::uint32_t>{2}));
        QVERIFY(std::abs(table.values[2] - 0.002F) < 1e-6F);
        QCOMPARE(
            bench.controller().dataFile().data->tables[1].filled, (std::vector<std::uint32_t>{1}));
    }

    void numbersAreTakenAsTheyAreWhereNothingElseIsSaid_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("said");
        QTest::newRow("as they are")
            << QByteArray("X [mm],first [mm]\n0,0\n10,0.001\n20,0.003\n30,0.002\n")
            << QStringLiteral("The numbers of the file are taken as they are.");
        QTest::newRow("with a warning")
            << QByteArray("X [mm],first [mm]\n0,0.001\n10,0.001\n20,0.001\n")
            << QStringLiteral("Line 1: ");
    }
    void numbersAreTakenAsTheyAreWhereNothingElseIsSaid()
    {
        QFETCH(const QByteArray, text);
        QFETCH(const QString, said);
        PageFixture bench;
        QVERIFY(bench.open());
        bench.picked = bench.file(QStringLiteral("line.csv"), text);
        QVERIFY(bench.user.click("openButton"));
        QTRY_VERIFY(bench.controller().dataFile().data);
        QVERIFY(bench.user.pickFromMenu("recentButton", "recentMenu", Qt::Key_O));
        QTRY_VERIFY(bench.user.sees("importDialog"));
        QTRY_VERIFY2(mayAccept(bench), qPrintable(reason(bench)));
        QVERIFY2(report(bench).startsWith(said), qPrintable(report(bench)));
    }

    void measuredPositionsSnapWithTheToleranceThatIsEntered()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        bench.picked = bench.file(QStringLiteral("measured.csv"),
            "X [mm],first [mm],second [mm]\n0.0002,0,0\n9.9997,1,1\n20.0001,2,2\n");
        QVERIFY(user.click("openButton"));
        QTRY_VERIFY(user.sees("importDialog"));
        QVERIFY(user.click("snapField"));
        user.type(QStringLiteral("no"));
        QTRY_COMPARE(reason(bench),
            QStringLiteral("\"no\" is no tolerance: enter a number above 0, or nothing."));
        user.the<QLineEdit>("snapField").selectAll();
        user.type(QStringLiteral("0.001"));
        QTRY_VERIFY2(mayAccept(bench), qPrintable(reason(bench)));
        QVERIFY(user.click("acceptConversion"));
        QTRY_VERIFY(bench.controller().dataFile().data);
        QCOMPARE(bench.controller().selectedTable()->grid.axes[0].distance, 10.0);
    }

    void aCancelledDialogLeavesEverything()
    {
        PageFixture bench;
        QVERIFY(test::page_states::unwritten(bench));
        const auto table = bench.controller().selectedTable();
        bench.picked = bench.file(QStringLiteral("offsets.csv"), "0,0\n10,0.002\n20,0.003\n");
        QVERIFY(bench.user.click("openButton"));
        QTRY_VERIFY(bench.user.sees("importDialog"));
        QTRY_VERIFY(!reason(bench).isEmpty());
        QVERIFY(bench.user.click("cancelConversion"));
        QTRY_VERIFY(!bench.user.sees("importDialog"));
        QCOMPARE(bench.controller().selectedTable(), table);
        QVERIFY(bench.controller().dataFile().path.endsWith(QStringLiteral("super-1.csv")));
    }

    void theOptionsOfAnOpenFileCanBeChanged()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        bench.picked = bench.file(
            QStringLiteral("comp.txt"), "1 5\n0 0\n10 -0.002\n20 -0.004\n30 -0.002\n40 0\n");
        QVERIFY(user.click("openButton"));
        // Which axis the values correct is not in such a file.
        QTRY_VERIFY(user.sees("importDialog"));
        QTRY_VERIFY2(
            reason(bench).contains(QStringLiteral("not stated")), qPrintable(reason(bench)));
        QVERIFY(!mayAccept(bench));
        QVERIFY(chooseAt(bench, "targetField", 1));
        QTRY_VERIFY(mayAccept(bench));
        QVERIFY(user.click("acceptConversion"));
        QTRY_VERIFY(bench.controller().dataFile().data);
        QVERIFY(!user.sees("importDialog"));
        QVERIFY(user.note("dataField").contains(QStringLiteral("softmc")));
        QVERIFY(user.pickFromMenu("recentButton", "recentMenu", Qt::Key_O));
        QTRY_VERIFY(user.sees("importDialog"));
        QTRY_VERIFY(mayAccept(bench));
        QVERIFY(report(bench).contains(QStringLiteral("softmc holds command values")));
        QVERIFY(chooseAt(bench, "signField", 1));
        QTRY_VERIFY(mayAccept(bench)
            && report(bench).contains(QStringLiteral("softmc holds feedback values, as you say")));
        QVERIFY(user.click("acceptConversion"));
        QTRY_VERIFY(bench.controller().selectedTable()->values[1] < 0.0F);
    }

    void whatIsNeededAndMissingIsSaid()
    {
        PageFixture bench;
        QVERIFY(open1D(bench));
        QVERIFY(openExport(bench, QStringLiteral("CSV file of this program")));
        QTRY_VERIFY2(
            reason(bench).contains(QStringLiteral("counts-per-unit")), qPrintable(reason(bench)));
        QVERIFY(!mayAccept(bench));
        QVERIFY(bench.user.click("setting_counts-per-unit"));
        bench.user.type(QStringLiteral("10000"));
        QTRY_VERIFY(mayAccept(bench));
        QVERIFY(reason(bench).isEmpty());
        QVERIFY(!report(bench).isEmpty());
    }

    void aSettingThatIsClearedDoesNotComeBackWithTheNextFormat()
    {
        PageFixture bench;
        auto& user = bench.user;
        const auto counts = [&] { return &user.the<QLineEdit>("setting_counts-per-unit"); };
        const QString first = QStringLiteral("CSV file of this program");
        const QString second = QStringLiteral("leadscrew compensation of one source");
        QVERIFY(open1D(bench));
        QVERIFY(openExport(bench, first));
        QVERIFY(user.click("setting_counts-per-unit"));
        user.type(QStringLiteral("1000"));
        QVERIFY(user.choose("conversionFormat", second));
        QCOMPARE(counts()->text(), QStringLiteral("1000"));
        counts()->clear();
        QVERIFY(user.choose("conversionFormat", first));
        QCOMPARE(counts()->text(), QString());
        counts()->setText(QStringLiteral("2000"));
        QVERIFY(user.choose("conversionFormat", second));
        QCOMPARE(counts()->text(), QStringLiteral("2000"));
    }

    void aSettingThatMayHaveThousandsIsNotTaken()
    {
        PageFixture bench; // which sets the language of the window
        const QScopeGuard back([before = QLocale()] { QLocale::setDefault(before); });
        QLocale::setDefault(QLocale(QLocale::German));
        QVERIFY(open1D(bench));
        QVERIFY(openExport(bench, QStringLiteral("CSV file of this program")));
        QVERIFY(bench.user.click("setting_counts-per-unit"));
        bench.user.type(QStringLiteral("10.000"));
        QTRY_VERIFY2(
            reason(bench).contains(QStringLiteral("\"10.000\"")), qPrintable(reason(bench)));
        QVERIFY(!mayAccept(bench));
        bench.user.type(QStringLiteral("5"));
        QTRY_VERIFY2(mayAccept(bench), qPrintable(reason(bench))); // 10.0005 is none
    }

    void aSignThatNobodyHasPublishedIsChosen()
    {
        PageFixture bench;
        QVERIFY(open1D(bench));
        QVERIFY(openExport(bench, QStringLiteral("leadscrew compensation of one source")));
        QTRY_VERIFY2(reason(bench).contains(QStringLiteral("obody has published")),
            qPrintable(reason(bench)));
        QVERIFY(!mayAccept(bench));
        QCOMPARE(bench.user.the<QComboBox>("signField").currentText(),
            QStringLiteral("choose one; command is assumed"));
        QVERIFY(chooseAt(bench, "signField", 2));
        QTRY_VERIFY2(
            reason(bench).contains(QStringLiteral("counts-per-unit")), qPrintable(reason(bench)));
        QVERIFY(bench.user.click("setting_counts-per-unit"));
        bench.user.type(QStringLiteral("10000"));
        QVERIFY(bench.user.click("setting_source-motor"));
        bench.user.type(QStringLiteral("1"));
        QTRY_VERIFY2(mayAccept(bench), qPrintable(reason(bench)));
        QVERIFY(report(bench).contains(QStringLiteral("pmac-1d holds command values, as you say")));
    }

    void aSignThatWasStatedIsNotOfAnotherFormat()
    {
        PageFixture bench;
        QVERIFY(open1D(bench));
        QVERIFY(openExport(bench, QStringLiteral("leadscrew compensation of one source")));
        QVERIFY(chooseAt(bench, "signField", 1));
        QVERIFY(bench.user.choose("conversionFormat", QStringLiteral("text table of positions")));
        QTRY_VERIFY(mayAccept(bench));
        QCOMPARE(bench.user.the<QComboBox>("signField").currentIndex(), 0);
        QVERIFY(!report(bench).contains(QStringLiteral("as you say")));
    }

    void anExportedFileIsReadByCore()
    {
        PageFixture bench;
        QVERIFY(open1D(bench));
        QVERIFY(openExport(bench, QStringLiteral("text table of positions")));
        QTRY_VERIFY(mayAccept(bench));
        bench.picked = bench.path(QStringLiteral("out.txt"));
        QVERIFY(bench.user.click("acceptConversion"));
        QTRY_VERIFY(QFile::exists(bench.picked));
        QVERIFY(bench.questions.back().filter.contains(QStringLiteral("*.txt")));
        QVERIFY(bench.questions.back().start.endsWith(QStringLiteral("first.txt")));
        QFile file(bench.picked);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const auto reading = softmc::format().read(file.readAll().toStdString(), {});
        VERIFY_RESULT(reading);
        QVERIFY(!reading->hasErrors());
        const NeutralTable& table = reading->tables.front();
        QCOMPARE(table.axes[0].knots, (std::vector<double>{0, 10, 20, 30}));
        QVERIFY(table.columns[0].values[1] < 0.0); // the command is moved the other way
        QVERIFY(std::abs(table.columns[0].values[1] + 0.001) < 1e-5);
    }

    /// As `axiscomp convert` does it: by the position at which the drive looks the table up.
    void aTableForTheSetPositionIsExportedAtItsPositions()
    {
        PageFixture bench;
        bench.picked = bench.file(QStringLiteral("set.csv"),
            "// lookup: set\n// target: X\nX [mm],first [mm]\n0,0\n10,0.5\n20,-0.25\n");
        QVERIFY(bench.open());
        QVERIFY(bench.user.click("openButton"));
        QTRY_VERIFY(bench.controller().selectedTable());
        QVERIFY(openExport(bench, QStringLiteral("text table of positions")));
        QTRY_VERIFY(mayAccept(bench));
        QVERIFY2(report(bench).contains(QStringLiteral("at the set position (lookup: set)")),
            qPrintable(report(bench)));
        bench.picked = bench.path(QStringLiteral("out.txt"));
        QVERIFY(bench.user.click("acceptConversion"));
        QTRY_VERIFY(QFile::exists(bench.picked));
        QFile file(bench.picked);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), QByteArray("1 3\n0 0\n10 -0.5\n20 0.25\n"));
    }

    /// As `axiscomp convert` does it: `write` refuses another drive than the one that was measured.
    void theNotesOfAFileAreExportedWithItsTable()
    {
        PageFixture bench;
        bench.picked = bench.file(QStringLiteral("made.csv"),
            "// made of before.csv\n// drive: Mill, serial number 4711\n// target: X\n"
            "X [mm],first [mm]\n0,0\n10,0.005\n20,-0.0025\n");
        QVERIFY(bench.open());
        QVERIFY(bench.user.click("openButton"));
        QTRY_VERIFY(bench.controller().selectedTable());
        QVERIFY(openExport(bench, QStringLiteral("calibration file: reference positions")));
        QTRY_VERIFY(mayAccept(bench));
        bench.picked = bench.path(QStringLiteral("out.csv"));
        QVERIFY(bench.user.click("acceptConversion"));
        QTRY_VERIFY(QFile::exists(bench.picked));
        const CsvReading read = readCalibrationCsv(bench.picked.toStdString(), CsvOptions());
        QVERIFY(read.data);
        for (const char* note : {"made of before.csv", "drive: Mill, serial number 4711"})
            QVERIFY2(std::ranges::count(read.data->notes, note) == 1, note);
    }

    /// The sources that are chosen say where the drive will look it up.
    void theFileOfAnotherControllerIsMadeForTheChosenSource()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        const auto choose = [&](const std::string& source) {
            bench.controller().chooseSource(1, QString::fromStdString(source));
            return test::PageUser::waitFor(
                [&] { return bench.controller().setup().edited().sources[0].path == source; });
        };
        QVERIFY(choose("Axes[0]/Signals/PathPlanner/Position"));
        const QString file =
            bench.file(QStringLiteral("x.txt"), "1 5\n0 0\n10 -0.5\n20 0.25\n30 -0.5\n40 0\n");
        ImportChoices choices;
        choices.format = &softmc::format();
        choices.settings = {{"position-unit", "mm"}, {"value-unit", "mm"}};
        bench.controller().importData(file, choices);
        QTRY_VERIFY(bench.controller().dataFile().data);
        QCOMPARE(bench.controller().dataFile().data->tables[0].values[1], 0.5F);
        QCOMPARE(bench.controller().dataFile().lookupAt, std::optional(LookupAt::Set));

        QVERIFY(choose(test::masterX));
        bench.controller().readDataAgain();
        QTRY_COMPARE(bench.controller().dataFile().lookupAt, std::optional(LookupAt::Encoder));
        QVERIFY(std::abs(bench.controller().dataFile().data->tables[0].values[1] - 0.5F / 1.075F)
            < 1e-6F);
    }

    void anExportThatCannotBeWrittenSaysWhy()
    {
        PageFixture bench;
        QVERIFY(open1D(bench));
        QVERIFY(openExport(bench, QStringLiteral("text table of positions")));
        QTRY_VERIFY(mayAccept(bench));
        bench.picked = bench.path(QStringLiteral("no-such-folder/out.txt"));
        QVERIFY(bench.user.click("acceptConversion"));
        QTRY_VERIFY(
            bench.user.message("failureMessage").contains(QStringLiteral("no-such-folder")));
    }

    void thePictureShowsWhatAnotherControllerWouldApply()
    {
        PageFixture bench;
        QVERIFY(open1D(bench));
        auto& facts = bench.user.the<QLabel>("tableFacts");
        const QString ofDrive = facts.text();
        QVERIFY(ofDrive.contains(QStringLiteral("4 points")));
        QVERIFY(bench.user.choose("appliedBy", QStringLiteral("softMC")));
        QTRY_VERIFY2(facts.text().contains(QStringLiteral("6 points")), qPrintable(facts.text()));
        // What is written is not touched by what is looked at.
        QCOMPARE(bench.controller().selectedTable()->values.size(), std::size_t{4});
        QVERIFY(bench.user.choose("appliedBy", QStringLiteral("the drive")));
        QTRY_COMPARE(facts.text(), ofDrive);
    }

    void withoutATableThereIsNothingToExport()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        QVERIFY(!bench.user.the<QAction>("exportAction").isEnabled());
        QVERIFY(!bench.user.the<QAction>("exportAction").toolTip().isEmpty());
    }
};

AXISCOMP_WINDOW_TEST(TestConversionDialogs)

} // namespace tst_conversiondialogs

#include "tst_conversiondialogs.moc"
