// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/page_fixture.h"
#include "tests/ui/support/window_test.h"
#include "ui/text/endpoint_text.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QTest>
#include <QTreeWidget>

namespace tst_wizardconnection {

using namespace axiscomp;
using namespace axiscomp::ui;
using drivecomm::FaultSpec;
using test::PageFixture;

namespace {

const std::string activationX = "Axes[0]/Commands/Compensations/Axis/Activation";
const std::string sourceX = "Axes[0]/Parameters/Compensations/Axis/Dim1Source";
const std::string tableX = "Axes[0]/Parameters/Compensations/Axis/Table";

drivecomm::VirtualDriveOptions stage()
{
    drivecomm::VirtualDriveOptions options = PageFixture::twoAxes();
    options.name = "Stage-8";
    options.serialNumber = 1560;
    return options;
}

/// A page with a second drive, which is called Stage-8 and not the one that is chosen.
struct TwoDrives {
    PageFixture bench;
    test::ServedDrive second{stage()};

    [[nodiscard]] bool isThere()
    {
        auto& controller = bench.controller();
        controller.setEndpoints({bench.served.url(), second.url()});
        if (!bench.user.isThere()
            || !test::PageUser::waitFor([&] { return controller.axes().size() == 4; }))
            return false;
        controller.selectAxis(0); // whichever has answered first was chosen
        return true;
    }
};

} // namespace

/// What comes from outside while the page is open: lost connections, other clients, refusals, and
/// a write that is stopped.
class TestWizardConnection : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void aLostConnectionIsSaidEditsAreKeptAndItComesBack()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        QVERIFY(bench.choose2D());
        const EditedSetup edited = bench.controller().setup().edited();
        bench.served.stop();
        QTRY_VERIFY(!user.message("connectionMessage").isEmpty());
        QVERIFY(
            user.message("connectionMessage").contains(QStringLiteral("Your changes are kept")));
        QCOMPARE(
            user.the<QLabel>("driveState").text(), QStringLiteral("connection lost, reconnecting"));
        QCOMPARE(user.hint(), QStringLiteral("The drive is not connected."));
        QVERIFY(!user.the("writeButton").isEnabled());
        QCOMPARE(user.the<QLabel>("compensationState").text(), QStringLiteral("NOT CONNECTED"));
        QVERIFY2(user.the<QLabel>("stateDetail").text().startsWith(QStringLiteral("as read at ")),
            qPrintable(user.the<QLabel>("stateDetail").text()));
        QVERIFY(bench.controller().setup().edited() == edited);
        // It can be worked on: what needs no drive goes on.
        QVERIFY(user.choose("tableField", QStringLiteral("second")));
        bench.served.start();
        QTRY_COMPARE(user.the<QLabel>("driveState").text(), QStringLiteral("connected"));
        QVERIFY(user.message("connectionMessage").isEmpty());
        QCOMPARE(bench.controller().setup().edited().table.fileTable, std::optional(1));
        QTRY_VERIFY(user.the("writeButton").isEnabled());
        QVERIFY(bench.write());
        QVERIFY(bench.saysOutcome(QStringLiteral("the drive holds the new state")));
    }

    void aConnectionLostWhileWritingSaysWhatIsKnownAndLaterWhatTheDriveHolds()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        QVERIFY(bench.choose2D());
        const auto before = bench.state();
        bench.served.faults.add({FaultSpec::Kind::Slow, 40, {}});
        QVERIFY(user.click("writeButton"));
        QVERIFY(user.click("confirmWriteButton"));
        QTRY_VERIFY(bench.controller().isWriting()
            && bench.controller().busy().step.contains(QStringLiteral("writing:")));
        bench.served.stop();
        QVERIFY(bench.idle());
        QVERIFY(!bench.outcome().isEmpty());
        QVERIFY(bench.controller().isOutcomeAnError());
        bench.served.faults.clear();
        bench.served.start();
        QTRY_COMPARE(user.the<QLabel>("driveState").text(), QStringLiteral("connected"));
        QTRY_VERIFY(bench.controller().status().has_value());
        QTRY_VERIFY(bench.controller().action(Action::Write).isEnabled
            || !bench.controller().setup().isDirty());
        const auto after = bench.state();
        QVERIFY(after.registers == before.registers || !after.table.empty());
    }

    void aSecondClientsChangesAreShownAndAnUnwrittenEditIsKept()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.openWritten());
        QVERIFY(user.choose("tableField", QStringLiteral("second")));
        const auto written =
            bench.served.drive.writeRegisters({{activationX, std::string("Evaluate")}});
        VERIFY_RESULT(written);
        QTRY_COMPARE(user.the<QLabel>("compensationState").text(), QStringLiteral("EVALUATING"));
        QCOMPARE(bench.controller().setup().edited().table.fileTable, std::optional(1));
        VERIFY_RESULT(
            bench.served.drive.writeRegisters({{activationX, std::string("AddToEncoders")}}));
        QTRY_COMPARE(
            user.hint(), QStringLiteral("The compensation is active: deactivate it first."));
        VERIFY_RESULT(bench.served.drive.writeRegisters({{activationX, std::string("Disabled")}}));
        QTRY_VERIFY(user.the("writeButton").isEnabled());

        // The table is taken away from the axis: the field shows it.
        QVERIFY(user.click("tableFieldRevert"));
        VERIFY_RESULT(bench.served.drive.writeRegisters({{tableX, std::string("Disabled")}}));
        QTRY_COMPARE(
            user.the<QComboBox>("tableField").currentText(), QStringLiteral("none on the drive"));
    }

    void aWriteStopsWhenTheDriveHasChangedAfterTheListWasShown()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.openWritten());
        QVERIFY(user.choose("tableField", QStringLiteral("second")));
        // From here on the page hears of nothing by itself before the write.
        QVERIFY(user.click("writeButton"));
        QTRY_VERIFY(user.sees("writePreview"));
        VERIFY_RESULT(bench.served.drive.writeRegisters({{sourceX, std::uint32_t{0}}}));
        const auto changed = bench.state();
        if (user.sees("confirmWriteButton"))
            user.press(Qt::Key_Return);
        QVERIFY(bench.idle());
        QTRY_VERIFY(!user.sees("writePreview"));
        QVERIFY2(bench.controller().isOutcomeAnError(), qPrintable(bench.outcome()));
        QCOMPARE(bench.state().registers, changed.registers);
        QCOMPARE(bench.state().table, changed.table);
        QCOMPARE(bench.controller().setup().edited().table.fileTable, std::optional(1));
        QTRY_COMPARE(user.the<QComboBox>("source1Field").currentText(), QString());
    }

    void aDriveThatRefusesIsQuotedAndItsValuesComeBack()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.openWritten());
        const auto before = bench.state();
        QVERIFY(user.choose("tableField", QStringLiteral("second")));
        QVERIFY(user.click("writeButton"));
        QTRY_VERIFY(user.sees("confirmWriteButton"));
        bench.served.faults.add({FaultSpec::Kind::Reject, 0, "TableRefused"});
        QVERIFY(user.click("confirmWriteButton"));
        QVERIFY(bench.saysOutcome(QStringLiteral("a fault was asked for")));
        QVERIFY(bench.outcome().contains(QStringLiteral("The drive holds the complete old state")));
        QVERIFY(user.the("outcomeMessage").isVisible());
        QVERIFY(bench.state() == before);
        bench.served.faults.clear();
        // The edit is still there, and what the drive has is shown as the drive's.
        QVERIFY(bench.controller().setup().isDirty(Field::Table));
        QVERIFY(user.note("tableField").contains(QStringLiteral("on the drive: ")));
        QVERIFY(bench.write());
        QVERIFY(!(bench.state() == before));
    }

    void aChosenDriveThatDoesNotAnswerIsNamedAndTriedAgain()
    {
        TwoDrives drives;
        auto& [bench, second] = drives;
        auto& user = bench.user;
        QVERIFY(drives.isThere());
        second.stop();
        bench.controller().refresh();
        QTRY_VERIFY(bench.controller().drives().at(1).connection == DriveState::Connection::Lost);
        QVERIFY(user.choose("driveField", QStringLiteral("Stage-8")));
        QTRY_VERIFY2(user.message("unreachableMessage")
                         .startsWith(QStringLiteral("Stage-8 does not answer.")),
            qPrintable(user.message("unreachableMessage")));
        QVERIFY(user.click("tryAgainButton"));
        QTRY_VERIFY(user.message("unreachableMessage")
                        .startsWith(QStringLiteral("Stage-8 does not answer.")));
        second.start();
        // The page goes there when it is told to: who looks at an axis acts on that one.
        QTRY_COMPARE(user.message("unreachableMessage"), QStringLiteral("Stage-8 answers now."));
        QCOMPARE(bench.controller().currentAxis(), 0);
        second.stop();
        bench.controller().refresh();
        QTRY_VERIFY(user.message("unreachableMessage")
                        .startsWith(QStringLiteral("Stage-8 does not answer.")));
        second.start();
        QTRY_VERIFY(user.sees("displayDriveButton"));
        QVERIFY(user.click("displayDriveButton"));
        QTRY_COMPARE(bench.controller().currentAxis(), 2);
        QVERIFY(user.message("unreachableMessage").isEmpty());
    }

    /// The axes of a drive that answers late come before those of the drive that is shown.
    void anAxisThatWasAskedAboutIsThatOneWhateverHasComeIntoTheList()
    {
        PageFixture bench;
        test::ServedDrive second{stage()};
        second.stop();
        auto& user = bench.user;
        auto& controller = bench.controller();
        QVERIFY(bench.open());
        controller.setEndpoints({second.url(), bench.served.url()});
        QCOMPARE(controller.axes().size(), std::size_t(2));
        QVERIFY(bench.choose2D());
        QVERIFY(user.choose("axisField", QStringLiteral("Y · ")));
        QTRY_VERIFY(user.sees("loseChangesButton"));
        second.start();
        QTRY_COMPARE(controller.axes().size(), std::size_t(4));
        QCOMPARE(controller.axes()[1].axis.name, std::string("Y"));
        QCOMPARE(controller.axes()[1].serialNumber, 1560);
        QVERIFY(user.click("loseChangesButton"));
        QTRY_COMPARE(controller.currentAxis(), 3);
        QCOMPARE(controller.axes()[3].serialNumber, 1559);
    }

    void anAxisThatHasGoneIsNotReplacedByAnother()
    {
        TwoDrives drives;
        auto& bench = drives.bench;
        QVERIFY(drives.isThere());
        auto& controller = bench.controller();
        const AxisEntry gone = controller.axes()[3];
        controller.setEndpoints({bench.served.url()});
        QCOMPARE(controller.axes().size(), std::size_t(2));
        QVERIFY(!controller.selectAxis(gone));
        QCOMPARE(controller.currentAxis(), 0);
        QVERIFY(controller.selectAxis(AxisEntry(controller.axes()[1])));
        QCOMPARE(controller.currentAxis(), 1);
    }

    /// A drive that is lost is told of every second: who is about to choose keeps the place.
    void aListOfDrivesThatIsOpenKeepsItsPlace()
    {
        TwoDrives drives;
        auto& [bench, second] = drives;
        auto& user = bench.user;
        QVERIFY(drives.isThere());
        auto& list = user.the<QComboBox>("driveField");
        list.showPopup();
        QTRY_VERIFY(list.view()->isVisible());
        list.view()->setCurrentIndex(list.model()->index(1, list.modelColumn()));
        QCOMPARE(list.view()->currentIndex().row(), 1);
        second.stop();
        bench.controller().refresh();
        QTRY_VERIFY(bench.controller().drives().at(1).connection == DriveState::Connection::Lost);
        QVERIFY(list.view()->isVisible());
        QCOMPARE(list.view()->currentIndex().row(), 1);
        QTest::keyClick(list.view(), Qt::Key_Return);
        QTRY_VERIFY(user.message("unreachableMessage").startsWith(QStringLiteral("Stage-8 ")));
    }

    void anAddressWithoutASchemeIsThatOfAWebServer_data()
    {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("taken");
        const auto row = [](const char* typed, const char* taken) {
            QTest::newRow(typed) << QString::fromLatin1(typed) << QString::fromLatin1(taken);
        };
        row("192.168.1.20", "http://192.168.1.20");
        row(" drive-3:8080 ", "http://drive-3:8080");
        row("[fe80::1]:80", "http://[fe80::1]:80");
        row("anna:s3cret@drive", "http://anna:s3cret@drive");
        row("https://drive", "https://drive");
        row("demo:", "demo:");
        row("demo", "demo");
        row("serial:/dev/ttyUSB0", "serial:/dev/ttyUSB0");
        row("/dev/ttyUSB0", "/dev/ttyUSB0");
        row("dri ve", "dri ve");
        row("", "");
    }
    void anAddressWithoutASchemeIsThatOfAWebServer()
    {
        QFETCH(QString, typed);
        QFETCH(QString, taken);
        QCOMPARE(completedEndpoint(typed), taken);
    }

    void anAddressTypedWithoutASchemeIsShownAsItIsTaken()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(user.isThere());
        QVERIFY(user.click("connectionsButton"));
        QTRY_VERIFY(user.sees("connectionsDialog"));
        QString typed = bench.served.url();
        QVERIFY(user.enter("connectionAddress", typed.remove(QStringLiteral("http://"))));
        auto& list = user.the<QTreeWidget>("connections");
        const auto shown = [&] {
            return list.findItems(bench.served.url(), Qt::MatchExactly).size() == 1;
        };
        QTRY_VERIFY_WITH_TIMEOUT(shown(), test::patienceMs);
        user.press(Qt::Key_Escape);
    }

    void aSourceThatTheDriveDoesNotKnowIsRefusedWithASentence()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        QVERIFY(user.enter("source1Field", QStringLiteral("Axes[0]/Signals/NoSuchThing")));
        QTRY_VERIFY(user.note("source1Field").contains(QStringLiteral("NoSuchThing")));
        QVERIFY(!bench.controller().setup().isDirty());
        user.press(Qt::Key_Escape);
        QCOMPARE(user.the<QComboBox>("source1Field").currentText(), QString());
        QVERIFY(user.choose("dimensionalityField", QStringLiteral("2D")));
        QVERIFY(user.enter("source1Field", QString::fromStdString(test::masterX)));
        QTRY_VERIFY(bench.controller().setup().edited().sources[0].isSet());
        QVERIFY(user.enter("source2Field", QString::fromStdString(test::masterX)));
        QTRY_VERIFY(!bench.controller().sourceProblem(2).isEmpty());
        QCOMPARE(user.note("source2Field"), bench.controller().sourceProblem(2));
        QVERIFY(!bench.controller().setup().edited().sources[1].isSet());
    }

    void aWriteIsStoppedAndTheDriveKeepsItsOldState()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.openWritten());
        const auto before = bench.state();
        QVERIFY(user.choose("tableField", QStringLiteral("second")));
        QVERIFY(user.click("writeButton"));
        QTRY_VERIFY(user.sees("confirmWriteButton"));
        bench.served.faults.add({FaultSpec::Kind::Slow, 60, {}});
        QVERIFY(user.click("confirmWriteButton"));
        QTRY_VERIFY(bench.controller().isWriting() && user.sees("cancelButton"));
        QVERIFY(user.click("cancelButton"));
        QVERIFY(!user.the("cancelButton").isEnabled());
        QVERIFY(bench.saysOutcome(QStringLiteral("The write was stopped.")));
        bench.served.faults.clear();
        QVERIFY(bench.state() == before);
        QVERIFY(bench.controller().setup().isDirty(Field::Table));
        QTRY_VERIFY(user.the("writeButton").isEnabled());
    }
};

AXISCOMP_WINDOW_TEST(TestWizardConnection)

} // namespace tst_wizardconnection

#include "tst_wizardconnection.moc"
