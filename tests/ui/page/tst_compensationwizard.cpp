// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/page_fixture.h"
#include "tests/ui/support/window_test.h"

#include <QAction>
#include <QFileInfo>
#include <QRegularExpression>
#include <QTableWidget>
#include <QTest>
#include <QTreeWidget>

namespace tst_compensationwizard {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::PageFixture;

namespace {

const std::string stateX = "Axes[0]/Signals/Compensations/Axis/State";
const std::string tableX = "Axes[0]/Parameters/Compensations/Axis/Table";

/// The second column of the list before a write, by the first.
QString rowOf(const QTableWidget& rows, const QString& field, int column)
{
    for (int row = 0; row < rows.rowCount(); ++row) {
        if (rows.item(row, 0)->text() == field)
            return rows.item(row, column)->text();
    }
    return QStringLiteral("no such row");
}

} // namespace

/// The page as a person uses it: what is shown, keys and clicks, against a drive behind its web
/// server.
class TestCompensationWizard : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void fromTheFirstStartToAnActiveCompensation()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(user.isThere());

        // Without settings there is the demo drive, and it is called that everywhere.
        QTRY_VERIFY(bench.controller().status().has_value());
        QVERIFY(user.message("demoMessage").contains(QStringLiteral("demo drive")));
        QVERIFY(bench.window.windowTitle().contains(QStringLiteral("(demo)")));
        QVERIFY(user.the<QComboBox>("axisField").currentText().contains(QStringLiteral("(demo)")));

        // A drive is added by its address and the demo drive removed.
        QVERIFY(user.click("setUpDrivesButton"));
        QTRY_VERIFY(user.sees("connectionsDialog"));
        auto& dialog = user.the<QDialog>("connectionsDialog");
        QVERIFY(QTest::qWaitForWindowActive(&dialog));
        user.type(bench.served.url());
        user.press(Qt::Key_Return);
        auto& list = user.the<QTreeWidget>("connections");
        QTRY_COMPARE(list.topLevelItemCount(), 2);
        QTRY_VERIFY(list.topLevelItem(1)->text(2).contains(QStringLiteral("1559")));
        list.setCurrentItem(list.topLevelItem(0));
        QVERIFY(user.click("removeConnection"));
        QCOMPARE(list.topLevelItemCount(), 1);
        QTest::keyClick(dialog.windowHandle(), Qt::Key_Return);
        QTRY_VERIFY(!user.find("connectionsDialog"));
        QVERIFY(user.isThere()); // a window manager would give it the keyboard back
        QTRY_VERIFY(bench.controller().status().has_value()
            && bench.controller().status()->drive.serialNumber == 1559);
        QCOMPARE(bench.controller().endpoints(), QStringList(bench.served.url()));
        QVERIFY(user.message("demoMessage").isEmpty());
        QVERIFY(!bench.window.windowTitle().contains(QStringLiteral("(demo)")));
        QTRY_COMPARE(user.the<QLabel>("driveState").text(), QStringLiteral("connected"));

        // Everything of AN140 2.4.
        QVERIFY(user.choose("axisField", QStringLiteral("Y · Stage-7")));
        QTRY_COMPARE(bench.controller().currentAxis(), 1);
        QVERIFY(user.choose("axisField", QStringLiteral("X · Stage-7")));
        QTRY_VERIFY(
            bench.controller().currentAxis() == 0 && bench.controller().status().has_value());
        QVERIFY(bench.choose2D());
        QCOMPARE(bench.questions.size(), std::size_t{1});
        QCOMPARE(bench.questions[0].purpose, FileQuestion::Purpose::OpenData);
        QVERIFY(user.choose("tableField", QStringLiteral("second")));
        QVERIFY(user.click("persistencyField"));
        QCOMPARE(bench.controller().setup().edited().persistency, Persistency::Persistent);
        QVERIFY(bench.window.isWindowModified());
        QVERIFY(user.note("tableField").contains(QStringLiteral("on the drive: none")));
        // The preview says the same: what is not there is not volatile either.
        QCOMPARE(user.note("persistencyField"), QStringLiteral("changed, on the drive: no table"));
        QVERIFY(
            user.the<QLabel>("signSentence").text().contains(QStringLiteral("the drive will add")));

        // The list of what will be written, then the write.
        const auto before = bench.state();
        QVERIFY(user.click("writeButton"));
        QTRY_VERIFY(user.sees("confirmWriteButton"));
        const auto& rows = user.the<QTableWidget>("previewRows");
        QCOMPARE(rowOf(rows, QStringLiteral("Dimensionality"), 2), QStringLiteral("2D"));
        QVERIFY(rowOf(rows, QStringLiteral("Dim1 Source"), 2).contains(QStringLiteral("X")));
        QCOMPARE(rowOf(rows, QStringLiteral("Persistency"), 2), QStringLiteral("persistent"));
        QTRY_VERIFY(
            rowOf(rows, QStringLiteral("Largest change"), 2).contains(QStringLiteral("µm")));
        QVERIFY(user.the<QLabel>("previewCost").text().contains(QStringLiteral("1 used")));
        QVERIFY(bench.state() == before);
        user.press(Qt::Key_Return);
        QVERIFY(bench.saysOutcome(QStringLiteral("the drive holds the new state")));
        QVERIFY(!bench.window.isWindowModified());
        QVERIFY(!(bench.state() == before));
        QVERIFY(!bench.state().table.empty());
        QVERIFY(user.the<QComboBox>("tableField")
                    .currentText()
                    .startsWith(QStringLiteral("On the drive")));

        // Active, and proved.
        QVERIFY(user.click("activateButton"));
        QVERIFY(bench.saysOutcome(QStringLiteral("Proved over")));
        QTRY_COMPARE(bench.served.text(stateX), std::string("Active"));
        QTRY_COMPARE(user.the<QLabel>("compensationState").text(), QStringLiteral("ACTIVE"));
        QVERIFY(user.the<QLabel>("liveValues").text().contains(QStringLiteral("µm")));
        QTRY_VERIFY2(user.the<QLabel>("stateDetail")
                         .text()
                         .contains(QRegularExpression(QStringLiteral("proved over [\\d.]+ % of"))),
            qPrintable(user.the<QLabel>("stateDetail").text()));
        QVERIFY(!user.the("writeButton").isEnabled());
        QCOMPARE(user.hint(), QStringLiteral("The compensation is active."));
    }

    void evaluatedActiveAndOffAgain()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.openWritten());
        QVERIFY(user.pickFromMenu("activateMenuButton", "activateMenu", Qt::Key_E));
        QVERIFY(bench.saysOutcome(QStringLiteral("the drive adds nothing")));
        QTRY_COMPARE(user.the<QLabel>("compensationState").text(), QStringLiteral("EVALUATING"));
        QVERIFY(user.click("activateButton"));
        QVERIFY(bench.saysOutcome(QStringLiteral("Proved")));
        QVERIFY(user.click("deactivateButton"));
        QVERIFY(bench.saysOutcome(QStringLiteral("The compensation is off.")));
        QTRY_COMPARE(user.the<QLabel>("compensationState").text(), QStringLiteral("OFF"));
        QTRY_COMPARE(bench.served.text(stateX), std::string("Disabled"));
    }

    void oneFieldIsRevertedAndThenAll()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        QVERIFY(bench.choose2D());
        const SetupModel& setup = bench.controller().setup();
        QVERIFY(setup.isDirty(Field::Source2));
        QVERIFY(user.click("source2FieldRevert"));
        QVERIFY(!setup.isDirty(Field::Source2));
        QVERIFY(setup.isDirty(Field::Source1));
        QVERIFY(!user.sees("source2FieldRevert"));
        QCOMPARE(user.hint(), QStringLiteral("Dim2 Source is missing."));
        // Ctrl+R reverts where the cursor is.
        QVERIFY(user.click("source1Field"));
        user.press(Qt::Key_R, Qt::ControlModifier);
        QVERIFY(!setup.isDirty(Field::Source1));
        QVERIFY(setup.isDirty(Field::Table));
        QVERIFY(user.click("revertAllButton"));
        QVERIFY(!setup.isDirty());
        QCOMPARE(user.the<QComboBox>("dimensionalityField").currentText(), QStringLiteral("1D"));
        QVERIFY(!bench.window.isWindowModified());
        QVERIFY(!user.the("revertAllButton").isEnabled());
    }

    void theExampleIsAFileThatCanBeOpened()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        QVERIFY(user.choose("dimensionalityField", QStringLiteral("3D")));
        bench.picked = bench.path(QStringLiteral("example.csv"));
        QVERIFY(user.click("saveExampleButton"));
        QCOMPARE(bench.questions.back().purpose, FileQuestion::Purpose::SaveExample);
        QVERIFY(bench.questions.back().start.endsWith(QStringLiteral("example-3d.csv")));
        QTRY_VERIFY(QFile::exists(bench.picked));
        QTRY_VERIFY(QFileInfo(bench.picked).size() > 0);
        QVERIFY(user.click("openButton"));
        QTRY_VERIFY(bench.controller().dataFile().data);
        QCOMPARE(bench.controller().dataFile().data->grid.dimensions(), 3);
        QVERIFY(user.note("dataField").startsWith(QStringLiteral("tables: ")));
    }

    void theListBeforeAWriteCanBeLeftAndSwitchedOff()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        QVERIFY(bench.choose2D());
        const auto before = bench.state();
        QVERIFY(user.click("writeButton"));
        QTRY_VERIFY(user.sees("writePreview"));
        QVERIFY(!user.the("writeButton").isEnabled());
        user.press(Qt::Key_Escape);
        QTRY_VERIFY(!user.sees("writePreview"));
        QVERIFY(bench.state() == before);
        QVERIFY(bench.controller().setup().isDirty());
        QVERIFY(user.the("writeButton").isEnabled());

        QVERIFY(user.click("writeButton"));
        QVERIFY(user.click("skipPreviewForVolatile"));
        QVERIFY(user.click("confirmWriteButton"));
        QVERIFY(bench.saysOutcome(QStringLiteral("the drive holds the new state")));
        QVERIFY(user.choose("tableField", QStringLiteral("second")));
        const auto first = bench.state();
        QVERIFY(user.click("writeButton"));
        QTRY_VERIFY(!(bench.state() == first));
        QVERIFY(bench.idle());
        // A persistent write always shows its list.
        QVERIFY(user.choose("tableField", QStringLiteral("first")));
        QVERIFY(user.click("persistencyField"));
        QVERIFY(user.click("writeButton"));
        QTRY_VERIFY(user.sees("writePreview"));
        QVERIFY(!user.sees("skipPreviewForVolatile"));
    }

    void persistencyOfTheTableOnTheDriveIsChangedWithoutAFile()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.openWritten());
        QVERIFY(user.pickFromMenu("recentButton", "recentMenu", Qt::Key_C)); // Close File
        QTRY_VERIFY(!bench.controller().dataFile().data);
        QVERIFY(user.click("persistencyField"));
        QVERIFY(bench.write());
        QVERIFY(bench.saysOutcome(QStringLiteral("stored in flash")));
        bench.served.drive.reboot();
        QVERIFY(bench.served.text(tableX) != "Disabled");
    }

    void thePreviousTableComesBackAfterItsPreview()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.openWritten());
        const auto first = bench.state();
        QVERIFY(user.choose("tableField", QStringLiteral("second")));
        QVERIFY(bench.write());
        const auto second = bench.state();
        QVERIFY(!(first == second));
        QVERIFY(user.pickFromMenu("activateMenuButton", "activateMenu", Qt::Key_P));
        QTRY_VERIFY(user.sees("confirmWriteButton"));
        QVERIFY(user.the<QLabel>("previewTitle").text().contains(QStringLiteral("restored")));
        const auto& rows = user.the<QTableWidget>("previewRows");
        QTRY_VERIFY2(!rowOf(rows, QStringLiteral("Largest change"), 2)
                          .startsWith(QStringLiteral("computing")),
            "no largest change");
        QVERIFY2(user.the<QLabel>("previewRemarks")
                     .text()
                     .startsWith(QStringLiteral("This is what the axis had before the write of")),
            qPrintable(user.the<QLabel>("previewRemarks").text()));
        QVERIFY(bench.state() == second); // nothing has been written yet
        QVERIFY(user.click("confirmWriteButton"));
        QVERIFY(bench.saysOutcome(QStringLiteral("Restored")));
        QVERIFY(bench.state() == first);
        QVERIFY(!bench.controller().setup().isDirty());
    }

    void theTableIsDeletedAfterItsPreview()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.openWritten());
        const auto before = bench.state();
        QVERIFY(user.pickFromMenu("activateMenuButton", "activateMenu", Qt::Key_D));
        QTRY_VERIFY(user.sees("confirmWriteButton"));
        QVERIFY(user.the<QLabel>("previewTitle").text().contains(QStringLiteral("deleted")));
        const auto& rows = user.the<QTableWidget>("previewRows");
        QCOMPARE(rowOf(rows, QStringLiteral("Table"), 2), QStringLiteral("none"));
        QCOMPARE(rowOf(rows, QStringLiteral("Small1"), 2), QStringLiteral("empty"));
        QVERIFY(!user.sees("skipPreviewForVolatile"));
        user.press(Qt::Key_Escape);
        QTRY_VERIFY(!user.sees("writePreview"));
        QVERIFY(bench.state() == before);

        QVERIFY(user.pickFromMenu("activateMenuButton", "activateMenu", Qt::Key_D));
        QTRY_VERIFY(user.sees("confirmWriteButton"));
        QVERIFY(user.click("confirmWriteButton"));
        QVERIFY(bench.saysOutcome(QStringLiteral("Small1 is empty")));
        QCOMPARE(bench.served.text(tableX), std::string("Disabled"));
        QVERIFY(!user.the<QAction>("deleteAction").isEnabled());
    }

    void anotherAxisIsChosenOnlyAfterAQuestionWhenSomethingIsUnwritten()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        QVERIFY(user.choose("dimensionalityField", QStringLiteral("2D")));
        QVERIFY(user.choose("axisField", QStringLiteral("Y · ")));
        QVERIFY(user.message("leaveQuestion").contains(QStringLiteral("not written")));
        QCOMPARE(user.the<QComboBox>("axisField").currentIndex(), 0);
        QVERIFY(user.click("stayButton"));
        QVERIFY(user.message("leaveQuestion").isEmpty());
        QCOMPARE(bench.controller().setup().edited().dimensionality, 2);
        QVERIFY(user.choose("axisField", QStringLiteral("Y · ")));
        QVERIFY(user.click("loseChangesButton"));
        QTRY_COMPARE(user.the<QComboBox>("axisField").currentIndex(), 1);
        QVERIFY(!bench.controller().setup().isDirty());
    }

    void anAxisThatIsNotHomedSaysSo()
    {
        PageFixture bench(PageFixture::twoAxes(false));
        QVERIFY(bench.openWritten());
        QCOMPARE(bench.user.hint(), QStringLiteral("The axis must be homed first."));
        QVERIFY(!bench.user.the("activateButton").isEnabled());
        QVERIFY(bench.user.note("axisField").contains(QStringLiteral("not homed")));
    }
};

AXISCOMP_WINDOW_TEST(TestCompensationWizard)

} // namespace tst_compensationwizard

#include "tst_compensationwizard.moc"
