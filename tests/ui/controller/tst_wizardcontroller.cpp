// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/link_factory.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"
#include "tests/ui/support/controller_fixture.h"

#include <QSignalSpy>
#include <QTest>

namespace tst_wizardcontroller {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::ControllerFixture;
using test::DriveGate;
using test::GatedDrive;

namespace {

using Connection = DriveState::Connection;

const std::string stateX = "Axes[0]/Signals/Compensations/Axis/State";
const std::string source2X = "Axes[0]/Parameters/Compensations/Axis/Dim2Source";
const std::string homingX = "Axes[0]/Commands/Homing/Command";

QStringList labels(const WizardController& controller)
{
    QStringList labels;
    for (const AxisEntry& entry : controller.axes())
        labels.append(entry.label);
    return labels;
}

} // namespace

class TestWizardController : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void withoutADriveItSaysWhatToDo()
    {
        ControllerFixture bench;
        QCOMPARE(bench->currentAxis(), -1);
        QCOMPARE(bench->hint(), QStringLiteral("No drive is connected: add a connection first."));
        QVERIFY(!bench->action(Action::Write).isEnabled);
        QVERIFY(bench->action(Action::OpenData).isEnabled);
    }

    void aDriveIsFoundAndItsFirstAxisRead()
    {
        ControllerFixture bench;
        QSignalSpy axes(&bench.controller(), &WizardController::currentAxisChanged);
        QVERIFY(bench.connect());
        QCOMPARE(bench->drives().size(), std::size_t{1});
        QCOMPARE(bench->drives().front().connection, Connection::Connected);
        QCOMPARE(bench->drives().front().name, QStringLiteral("Test-1"));
        QCOMPARE(labels(bench.controller()),
            (QStringList{QStringLiteral("X · Test-1"), QStringLiteral("Y · Test-1")}));
        QCOMPARE(bench->currentAxis(), 0);
        QVERIFY(axes.count() >= 1);
        QVERIFY(bench->setup().hasBaseline());
        QVERIFY(!bench->setup().isDirty());
        QVERIFY(bench->sourceShortlist().size() > 8);
        QCOMPARE(bench->hint(), QStringLiteral("No table is chosen: open compensation data."));
        QCOMPARE(bench->flashOperationsLeft(), 8);
        QCOMPARE(bench->flashWaitSeconds(), 0);
    }

    void theDemoDriveIsThereWithoutHardwareAndMarked()
    {
        ControllerFixture bench;
        bench.options.liveInterval = std::chrono::milliseconds(10);
        bench.options.linkFactory = drivecomm::linkFactory(drivecomm::genericProfile());
        bench->setEndpoints({QStringLiteral("demo:")});
        QTRY_VERIFY(bench->status().has_value());
        QVERIFY(bench->drives().front().isDemo);
        QCOMPARE(labels(bench.controller()).front(), QStringLiteral("X · Demo (demo)"));
        QTRY_COMPARE(bench->status()->axis.stateWord, "Active"); // after its ramp
        QCOMPARE(bench->hint(), QStringLiteral("The compensation is active."));
        QTRY_VERIFY(bench->driveTable());
        QCOMPARE(bench->selectedTable(), bench->driveTable());
        QCOMPARE(bench->driveTable()->grid.axes.at(0).size, 31U);
        QVERIFY(!bench->signSentence().isEmpty());
        bench->deactivate();
        QVERIFY(bench.idle());
        QCOMPARE(bench->status()->axis.stateWord, "Disabled");
        QVERIFY(bench->action(Action::Activate).isEnabled);
    }

    void axesOfAllDrivesStandInOneListWithLabelsOfTheirOwn()
    {
        ControllerFixture bench;
        drivecomm::VirtualDriveOptions twins = ControllerFixture::xyDrive();
        twins.serialNumber = 4712;
        twins.axes = {{.name = "X"}, {.name = "X"}, {.name = ""}};
        bench.addDrive("http://twins", twins);
        bench->setEndpoints({QStringLiteral("http://x"), QStringLiteral("http://twins")});
        QTRY_COMPARE(bench->axes().size(), std::size_t{5});
        QStringList all = labels(bench.controller());
        QCOMPARE(all.removeDuplicates(), 0);
        // The drives share their name: the serial number tells them apart.
        QVERIFY2(all.contains(QStringLiteral("X [0] · Test-1 #4711")), qPrintable(all.join(u'|')));
        QVERIFY2(all.contains(QStringLiteral("X [1] · Test-1")), qPrintable(all.join(u'|')));
        QVERIFY2(all.contains(QStringLiteral("Axis 2 · Test-1")), qPrintable(all.join(u'|')));
    }

    void sixtyFourAxesAreSixtyFourEntries()
    {
        ControllerFixture bench;
        drivecomm::VirtualDriveOptions many = ControllerFixture::xyDrive();
        many.axes.assign(64, {.name = "A"});
        bench.addDrive("http://many", many);
        bench->setEndpoints({QStringLiteral("http://many")});
        QTRY_COMPARE(bench->axes().size(), std::size_t{64});
        QCOMPARE(labels(bench.controller()).removeDuplicates(), 0);
        bench->selectAxis(63);
        QTRY_VERIFY(bench->status().has_value());
        QCOMPARE(bench->status()->axis.index, 63);
    }

    void aDriveWithoutCompensationRegistersIsShownWithTheReason()
    {
        static const DriveProfile other = [] {
            DriveProfile profile = drivecomm::genericProfile();
            profile.registers.state = "Axes[{axis}]/Signals/Compensations/Axis/NoSuchState";
            profile.registers.table = "Axes[{axis}]/Parameters/Compensations/Axis/NoSuchTable";
            return profile;
        }();
        ControllerFixture bench;
        bench.options.profile = &other;
        bench->setEndpoints({QStringLiteral("http://x")});
        QTRY_COMPARE(bench->axes().size(), std::size_t{2});
        const AxisEntry& entry = bench->axes().front();
        QVERIFY(!entry.isUsable);
        QCOMPARE(entry.label, QStringLiteral("X · Test-1 (no compensation)"));
        QCOMPARE(entry.problem, QStringLiteral("This axis has no compensation registers."));
        bench->selectAxis(0);
        QCOMPARE(bench->hint(), QStringLiteral("This axis has no compensation registers."));
        QCOMPARE(bench->action(Action::Write).reason,
            QStringLiteral("This axis has no compensation registers."));
    }

    void anotherAxisIsAnotherSetup()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        QVERIFY(bench->setup().isDirty());
        bench->selectAxis(1);
        QVERIFY(!bench->status().has_value());
        QVERIFY(!bench->setup().isDirty());
        QTRY_VERIFY(bench->status().has_value());
        QCOMPARE(bench->status()->axis.name, "Y");
        QVERIFY(!bench->setup().isDirty());
        QVERIFY(bench->dataFile().data);
    }

    void anAddressThatIsNoneIsALostDriveWithItsSentence()
    {
        ControllerFixture bench;
        bench->setEndpoints({QStringLiteral("http://user:secret@nowhere")});
        QTRY_COMPARE(bench->drives().front().connection, Connection::Lost);
        QCOMPARE(bench->drives().front().endpoint, QStringLiteral("http://nowhere"));
        QVERIFY(bench->drives().front().problem.contains(QStringLiteral("unknown")));
        QCOMPARE(bench->endpoints(), QStringList{QStringLiteral("http://user:secret@nowhere")});
        QVERIFY(bench->axes().empty());
        bench->setEndpoints({});
        QVERIFY(bench->drives().empty());
    }

    void aLostDriveKeepsFieldsAndEditsAndComesBackByItself()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        const EditedSetup edited = bench->setup().edited();
        bench.drive().gate.set(DriveGate::Mode::Gone);
        bench->refreshLive();
        QTRY_COMPARE(bench->drives().front().connection, Connection::Lost);
        QCOMPARE(
            bench->drives().front().problem, QStringLiteral("No connection to test:: no drive."));
        QCOMPARE(bench->hint(), QStringLiteral("The drive is not connected."));
        QVERIFY(!bench->axes().front().isUsable);
        QCOMPARE(bench->currentAxis(), 0);
        QVERIFY(bench->setup().edited() == edited);
        QVERIFY(bench->setup().isDirty(Field::Table));
        QVERIFY(bench->status().has_value());
        QVERIFY(bench->action(Action::Revert).isEnabled);

        bench.drive().gate.set(DriveGate::Mode::Open);
        QTRY_COMPARE(bench->drives().front().connection, Connection::Connected);
        QVERIFY(bench->setup().edited() == edited);
        QTRY_COMPARE(bench->hint(), QStringLiteral("The parameters still have to be saved."));
    }

    /// Nothing was begun: there is only the connection to speak of.
    void thatAWriteFoundNoConnectionIsNotSaidOfADriveThatIsBack()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        bench.drive().gate.set(DriveGate::Mode::Gone);
        bench->planWrite();
        QVERIFY(bench.idle());
        QCOMPARE(bench->outcome(), QStringLiteral("No connection to test:: no drive."));
        QVERIFY(bench->isOutcomeAnError());
        QTRY_COMPARE(bench->drives().front().connection, Connection::Lost);
        bench.drive().gate.set(DriveGate::Mode::Open);
        QTRY_COMPARE(bench->drives().front().connection, Connection::Connected);
        QTRY_COMPARE(bench->outcome(), QString());
        QTRY_VERIFY(bench->action(Action::Write).isEnabled);
    }

    void anotherDriveAtTheSameAddressIsNoticedAndItsEditsAreDropped()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QVERIFY(bench.prepare2D());
        bench.drive().gate.set(DriveGate::Mode::Gone);
        bench->refreshLive();
        QTRY_COMPARE(bench->drives().front().connection, Connection::Lost);
        bench->refresh();
        drivecomm::VirtualDriveOptions other = ControllerFixture::xyDrive();
        other.name = "Other";
        other.serialNumber = 4799;
        bench.addDrive("http://x", other);
        QTRY_VERIFY(bench->outcome().contains(QStringLiteral("A different drive")));
        QVERIFY(bench->isOutcomeAnError());
        QTRY_VERIFY(bench->status().has_value());
        QCOMPARE(bench->status()->drive.serialNumber, 4799);
        QVERIFY(!bench->setup().isDirty());
    }

    void liveValuesFollowTheDrive()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        QSignalSpy status(&bench.controller(), &WizardController::statusChanged);
        bench.drive().set(homingX, std::string("Start"));
        bench.drive().milliseconds += 60'000;
        QVERIFY(bench.readLive());
        status.clear();
        QVERIFY(bench.readLive());
        // Nothing but live values has moved.
        QCOMPARE(status.count(), 0);
    }

    void liveValuesAreAskedForOneAtATime()
    {
        ControllerFixture bench;
        bench.options.liveInterval = std::chrono::milliseconds(1);
        QVERIFY(bench.connect());
        bench.drive().gate.set(DriveGate::Mode::Silent);
        QTRY_COMPARE(bench.drive().gate.waiting(), 1);
        const int exchanges = bench.drive().gate.exchanges();
        for (int i = 0; i < 20; ++i) {
            bench->refreshLive();
            QTest::qWait(2);
        }
        QCOMPARE(bench.drive().gate.exchanges(), exchanges);
        bench.drive().gate.set(DriveGate::Mode::Open);
        QTRY_VERIFY(bench.drive().gate.exchanges() > exchanges + 10);
        QCOMPARE(bench.drive().gate.mostAtOnce(), 1);
    }

    void whatSomebodyElseChangesShowsUpAndKeepsTheUsersEdits()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        bench->setup().setPersistency(Persistency::Persistent);
        bench->chooseSource(1, QString::fromStdString(test::masterX));
        bench.drive().set(source2X, std::uint32_t{0});
        const auto y = bench.drive().drive.readRegisters({test::masterY});
        bench.drive().set("Axes[0]/Parameters/Compensations/Axis/Dim1Source", y->front().address);
        QVERIFY(bench.readLive());
        QCOMPARE(bench->setup().baseline().sources[0].path, test::masterY);
        QCOMPARE(bench->setup().edited().sources[0].path, test::masterX);
        QVERIFY(bench->setup().isDirty(Field::Source1));
        QVERIFY(bench->setup().isDirty(Field::Persistency));
        bench->setup().revert(Field::Source1);
        QCOMPARE(bench->setup().edited().sources[0].path, test::masterY);
    }

    void aSourceIsCheckedAgainstTheDrive_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("problem");
        const QString floats = QStringLiteral("Application/Variables/Floats[200]");
        QTest::newRow("path of the shortlist")
            << QString::fromStdString(test::masterX) << QString::fromStdString(test::masterX)
            << QString();
        QTest::newRow("with dots")
            << QStringLiteral("Axes[0].Signals.PositionController.MasterPosition")
            << QString::fromStdString(test::masterX) << QString();
        QTest::newRow("uri") << QStringLiteral("tam://mc/Test-1/") + floats << floats << QString();
        QTest::newRow("another path") << floats << floats << QString();
        QTest::newRow("another drive") << QStringLiteral("tam://mc/Other/") + floats << QString()
                                       << QStringLiteral("is a register of the drive Other");
        QTest::newRow("an enum") << QString::fromStdString(stateX) << QString()
                                 << QStringLiteral("is of type");
        QTest::newRow("none") << QStringLiteral("Axes[0]/Nothing") << QString()
                              << QStringLiteral("has no register Axes[0]/Nothing");
        QTest::newRow("no address")
            << QStringLiteral("0xzz") << QString() << QStringLiteral("an address is written 0x");
    }
    void aSourceIsCheckedAgainstTheDrive()
    {
        QFETCH(QString, text);
        QFETCH(QString, path);
        QFETCH(QString, problem);
        ControllerFixture bench;
        QVERIFY(bench.connect());
        bench->chooseSource(1, text);
        QTRY_VERIFY(!bench->isSourceBeingChecked(1));
        QCOMPARE(QString::fromStdString(bench->setup().edited().sources[0].path), path);
        QVERIFY2(bench->sourceProblem(1).contains(problem), qPrintable(bench->sourceProblem(1)));
        QCOMPARE(bench->sourceProblem(1).isEmpty(), problem.isEmpty());
        bench->chooseSource(1, {});
        QVERIFY(!bench->setup().edited().sources[0].isSet());
        QVERIFY(bench->sourceProblem(1).isEmpty());
    }

    void theSameSourceTwiceIsRefused()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        bench.chooseMasterSources();
        bench->chooseSource(2, QString::fromStdString(test::masterX));
        QVERIFY(bench->sourceProblem(2).contains(QStringLiteral("dimension 1 and dimension 2")));
        QCOMPARE(bench->setup().edited().sources[1].path, test::masterY);
    }

    void aCheckThatIsOvertakenDoesNotCount()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        bench->chooseSource(1, QStringLiteral("Axes[0]/Nothing"));
        QVERIFY(bench->isSourceBeingChecked(1));
        QCOMPARE(bench->action(Action::Write).isEnabled, false);
        bench->chooseSource(1, QString::fromStdString(test::masterX));
        QVERIFY(bench.readLive()); // after the first check, as everything has its order
        QVERIFY(bench->sourceProblem(1).isEmpty());
        QCOMPARE(bench->setup().edited().sources[0].path, test::masterX);
    }

    void aDriveThatIsTakenAwayTakesItsAxesAlong()
    {
        ControllerFixture bench;
        bench.addDrive("http://y", [] {
            auto options = ControllerFixture::xyDrive();
            options.name = "Second";
            options.serialNumber = 4713;
            return options;
        }());
        QVERIFY(bench.connect());
        bench->setEndpoints({QStringLiteral("http://x"), QStringLiteral("http://y")});
        QTRY_COMPARE(bench->axes().size(), std::size_t{4});
        QCOMPARE(bench->currentAxis(), 0);
        QVERIFY(bench->status().has_value());
        bench->setEndpoints({QStringLiteral("http://y")});
        QCOMPARE(bench->axes().size(), std::size_t{2});
        QCOMPARE(bench->axes().front().driveName, QStringLiteral("Second"));
        QTRY_VERIFY(bench->status().has_value());
        QCOMPARE(bench->status()->drive.serialNumber, 4713);
    }

    void theLogKeepsTheNewestThousandLines()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        for (int i = 0; i < 1'200; ++i)
            bench->planWrite(); // refused with its reason
        QCOMPARE(bench->log().size(), std::size_t{1000});
        QCOMPARE(bench->log().back().text(), QStringLiteral("Nothing has changed."));
        QCOMPARE(bench->outcome(), QStringLiteral("Nothing has changed."));
    }
};

AXISCOMP_TEST(TestWizardController)

} // namespace tst_wizardcontroller

#include "tst_wizardcontroller.moc"
