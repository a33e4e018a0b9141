// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/tam_table.h"
#include "tests/ui/support/dropped_files.h"
#include "tests/ui/support/page_states.h"
#include "tests/ui/support/table_samples.h"
#include "tests/ui/support/window_test.h"
#include "ui/controller/machine_controller.h"
#include "ui/text/message_text.h"

#include <QLabel>
#include <QTest>

namespace tst_openedfiles {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::drop;
using test::PageFixture;

namespace {

int tabOf(PageFixture& bench)
{
    return bench.user.the<PageTabs>("pageTabs").currentIndex();
}

QString configuration(PageFixture& bench)
{
    return bench.file(
        QStringLiteral("two.TAMcfg"), test::tamConfiguration({{"Stage-7", 1559, {{}, {}}}}));
}

QString machineFile(PageFixture& bench)
{
    return bench.file(QStringLiteral("machine.toml"),
        "version = 1\n[[drive]]\nendpoint = \"" + bench.served.url().toUtf8()
            + "\"\nserial = 1559\n[[drive.axis]]\naxis = \"X\"\nno-table = true\n"
              "sources = [\"\"]\n");
}

QString driveTable(PageFixture& bench)
{
    const auto bytes =
        encodeTamTable(test::namedTable({4, 3}), false, drivecomm::genericProfile().layout);
    if (!bytes)
        qFatal("%s", test::describe(bytes.error()).c_str());
    return bench.file(QStringLiteral("SMALL1.tamtbl"),
        QByteArray(
            reinterpret_cast<const char*>(bytes->data()), static_cast<qsizetype>(bytes->size())));
}

int filesOnMeasure(PageFixture& bench)
{
    return bench.user.the<QTableView>("measurementFiles").model()->rowCount();
}

} // namespace

/// A file that a desktop hands over, by double click or dropped: it is shown where it belongs.
class TestOpenedFiles : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void aRecordIsOpened()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        bench.wizard.openFile(bench.file(
            QStringLiteral("x.axcal"), QByteArray::fromStdString(recordText(test::recordOfFit()))));
        QTRY_COMPARE(bench.user.the<QLabel>("recordName").text(), QStringLiteral("x.axcal"));
    }

    void aMachineFileIsComparedInTheListOfAllAxes()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        const QString file = machineFile(bench);
        bench.wizard.openFile(file);
        QTRY_VERIFY(bench.user.sees("machineSummary"));
        QCOMPARE(bench.controller().machine().path(), file);
    }

    void aTableOfTheDriveIsOpenedOnWrite()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        QVERIFY(bench.user.choose("dimensionalityField", QStringLiteral("2D")));
        bench.user.the<PageTabs>("pageTabs").setCurrentIndex(PageTabs::Measure);
        const QString file = driveTable(bench);
        bench.wizard.openFile(file);
        QTRY_VERIFY(bench.controller().dataFile().data);
        QCOMPARE(bench.controller().dataFile().path, file);
        QCOMPARE(tabOf(bench), static_cast<int>(PageTabs::Write));
    }

    void aMeasurementIsOpenedOnMeasure()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        bench.user.the<PageTabs>("pageTabs").setCurrentIndex(PageTabs::Write);
        bench.wizard.openFile(test::publicMeasurement("ess_mcu1025"));
        QTRY_COMPARE(tabOf(bench), static_cast<int>(PageTabs::Measure));
        QVERIFY(bench.controller().dataFile().path.isEmpty());
    }

    /// Each of its columns would be one, the direction, too.
    void aMeasurementThatIsOpenedOnWriteIsNoTable()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        bench.wizard.openData(bench.file(QStringLiteral("m.csv"),
            "target [mm],direction,run,deviation [mm]\n0,1,1,0.001\n10,1,1,0.002\n"
            "20,1,1,0.003\n"));
        QTRY_VERIFY(!bench.controller().dataFile().problems.empty());
        QVERIFY(!bench.controller().dataFile().data);
        const QString said = problemText(bench.controller().dataFile().problems.front());
        QVERIFY2(said.contains(QStringLiteral("m.csv is a measurement, not a table; "))
                && said.contains(QStringLiteral("the pages Measure and Fit")),
            qPrintable(said));
        QVERIFY(!bench.user.sees("importDialog"));
        QVERIFY(!bench.controller().action(Action::Write).isEnabled);
    }

    void parametersOfAConfigurationAreImportedAsSoonAsThereIsADrive()
    {
        PageFixture bench;
        bench.served.stop();
        bench.controller().setEndpoints({bench.served.url()});
        QVERIFY(bench.user.isThere());
        bench.wizard.openFile(configuration(bench));
        QTRY_VERIFY(bench.user.message("waitingFileMessage")
                        .startsWith(QStringLiteral("two.TAMcfg is opened as soon as ")));
        QVERIFY(!bench.user.find("importConfigurationDialog"));
        bench.served.start();
        QTRY_VERIFY(bench.user.sees("importConfigurationDialog"));
        QVERIFY(!bench.user.sees("waitingFileMessage"));
    }

    void whatIsDroppedOnWriteIsShownWhereItBelongs()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        QVERIFY(drop(bench, {test::publicMeasurement("ess_mcu1025")}).isTaken);
        QTRY_COMPARE(tabOf(bench), static_cast<int>(PageTabs::Measure));
        QTRY_COMPARE(filesOnMeasure(bench), 1);
        bench.user.the<PageTabs>("pageTabs").setCurrentIndex(PageTabs::Write);
        QVERIFY(drop(bench, {bench.file(QStringLiteral("backup.json"), "{\"name\": \"backup\"}")})
                    .isTaken);
        QTRY_VERIFY(bench.user.message("failureMessage")
                        .startsWith(QStringLiteral("backup.json is no record (.axcal)")));
        QVERIFY(drop(bench, {machineFile(bench)}).isTaken);
        QTRY_VERIFY(bench.user.sees("machineSummary"));
        QVERIFY(drop(bench, {configuration(bench)}).isTaken);
        QTRY_VERIFY(bench.user.sees("importConfigurationDialog"));
        QVERIFY(bench.controller().dataFile().path.isEmpty());
        QVERIFY(!bench.controller().dataFile().isReading);
    }

    /// A CSV file is one of the measurement there: which column is what is said on the tab.
    void whatIsDroppedOnMeasureIsAFileOfItUnlessItIsCertainlySomethingElse()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        QVERIFY(bench.user.choose("dimensionalityField", QStringLiteral("2D")));
        bench.user.the<PageTabs>("pageTabs").setCurrentIndex(PageTabs::Measure);
        QVERIFY(drop(bench, {bench.superData()}).isTaken);
        QTRY_COMPARE(filesOnMeasure(bench), 1);
        QCOMPARE(tabOf(bench), static_cast<int>(PageTabs::Measure));
        const QString table = driveTable(bench);
        QVERIFY(drop(bench, {table}).isTaken);
        QTRY_COMPARE(bench.controller().dataFile().path, table);
        QCOMPARE(tabOf(bench), static_cast<int>(PageTabs::Write));
        QCOMPARE(filesOnMeasure(bench), 1);
    }

    void whatIsChosenAsDataIsWhatItsNameSays()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        bench.picked = machineFile(bench);
        QVERIFY(bench.user.click("openButton"));
        QTRY_VERIFY(bench.user.sees("machineSummary"));
        QVERIFY(bench.controller().dataFile().path.isEmpty());
        QVERIFY(!bench.controller().dataFile().isReading);
    }

    void aFileWhoseMessageIsPutAwayIsNotOpenedLater()
    {
        PageFixture bench;
        bench.served.stop();
        bench.controller().setEndpoints({bench.served.url()});
        QVERIFY(bench.user.isThere());
        bench.wizard.openFile(configuration(bench));
        QTRY_VERIFY(bench.user.sees("waitingFileMessage"));
        auto* close = bench.user.the("waitingFileMessage")
                          .findChild<QWidget*>(QStringLiteral("closeMessage"));
        QVERIFY(close);
        QTest::mouseClick(close, Qt::LeftButton);
        QTRY_VERIFY(!bench.user.sees("waitingFileMessage"));
        bench.served.start();
        QTRY_VERIFY(bench.controller().action(Action::ImportConfiguration).isEnabled);
        QCoreApplication::processEvents();
        QVERIFY(!bench.user.find("importConfigurationDialog"));
        QVERIFY(!bench.user.sees("waitingFileMessage"));
    }

    void whatTheProgramHasNothingToDoWithIsSaid()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        bench.wizard.openFile(
            bench.file(QStringLiteral("letter.txt"), "Dear customer,\nthank you.\n"));
        QTRY_VERIFY(bench.user.message("failureMessage")
                        .startsWith(QStringLiteral("letter.txt is no record (.axcal), no machine "
                                                   "file (.toml)")));
        // The name decides, and whoever reads the file says that it is something else.
        bench.wizard.openFile(bench.file(QStringLiteral("letter.axcal"), "Dear customer,\n"));
        QTRY_VERIFY(bench.user.message("failureMessage")
                        .contains(QStringLiteral("letter.axcal is not a valid record")));
        bench.wizard.openFile(bench.path(QStringLiteral("missing.axcal")));
        QTRY_VERIFY(bench.user.message("failureMessage")
                        .contains(QStringLiteral("missing.axcal cannot be read")));
    }
};

AXISCOMP_WINDOW_TEST(TestOpenedFiles)

} // namespace tst_openedfiles

#include "tst_openedfiles.moc"
