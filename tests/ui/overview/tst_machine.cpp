// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/verify.h"
#include "tests/ui/support/controller_fixture.h"
#include "tests/ui/support/page_fixture.h"
#include "tests/ui/support/window_test.h"
#include "ui/controller/axis_overview.h"
#include "ui/controller/machine_controller.h"
#include "ui/overview/overview_model.h"
#include "ui/page/setup_panel.h"
#include "ui/style/contrast.h"
#include "ui/style/warning_list.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QDialog>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTableView>
#include <QTableWidget>
#include <QTreeView>

namespace tst_machine {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::ControllerFixture;
using test::DriveGate;
using test::PageFixture;

namespace {

using Column = OverviewModel::Column;
using State = AxisDrift::State;

const QByteArray first1D = "Position [mm],Error [mm]\n0,0\n40,0.0021\n80,-0.001\n";
const QByteArray second1D = "Position [mm],Error [mm]\n0,0\n40,0.0022\n80,-0.001\n";

// Of an axis from 0 to 100 mm or less.
const QByteArray aroundTheTravel = "Position [mm],Error [mm]\n-10,0.002\n110,0.003\n";
const QByteArray awayFromTheTravel = "Position [mm],Error [mm]\n-300,0.001\n-200,0.003\n";

QByteArray driveSection(const QString& endpoint, int serialNumber)
{
    return "[[drive]]\nendpoint = \"" + endpoint.toUtf8()
        + "\"\nserial = " + QByteArray::number(serialNumber) + "\n";
}

/// An axis that looks its table up by the position of the first one.
QByteArray axisSection(const QByteArray& axis, const QByteArray& more = {})
{
    return "[[drive.axis]]\naxis = \"" + axis + "\"\nfile = \"first.csv\"\nsources = [\""
        + QByteArray::fromStdString(test::masterX) + "\"]\n" + more;
}

/// The drives "Test-1" with X and Y and "Table-2" with C, and a file for X and C.
struct Machine {
    ControllerFixture bench;

    Machine()
    {
        drivecomm::VirtualDriveOptions options;
        options.name = "Table-2";
        options.serialNumber = 4712;
        options.axes = {{.name = "C"}};
        bench.addDrive("http://c", options);
        static_cast<void>(bench.file(QStringLiteral("first.csv"), first1D));
    }
    [[nodiscard]] QString write(const QByteArray& drives)
    {
        return bench.file(QStringLiteral("mill.toml"), "version = 1\nname = \"Mill 7\"\n" + drives);
    }
    [[nodiscard]] QString writeBoth(const QByteArray& moreOfX = {}, int serialOfC = 4712)
    {
        return write(driveSection(QStringLiteral("http://x"), 4711) + axisSection("X", moreOfX)
            + driveSection(QStringLiteral("http://c"), serialOfC) + axisSection("0"));
    }
    [[nodiscard]] MachineController& machine() { return bench->machine(); }
    [[nodiscard]] AxisDrift drift(const char* endpoint, int axis)
    {
        return machine().driftOf(QLatin1StringView(endpoint), axis);
    }
    [[nodiscard]] bool apply()
    {
        bool hasEnded = false;
        QObject context;
        QObject::connect(&machine().application(), &MachineApplication::ended, &context,
            [&] { hasEnded = true; });
        machine().apply();
        return QTest::qWaitFor([&] { return hasEnded; }, test::patienceMs);
    }
    /// The drives have been compared.
    [[nodiscard]] bool open(const QString& path)
    {
        machine().open(path);
        return compared();
    }
    [[nodiscard]] bool compared()
    {
        return QTest::qWaitFor(
            [this] {
                return !machine().isReading() && !machine().isAsking()
                    && std::ranges::all_of(machine().drives(),
                        [](const MachineDriveState& drive) { return drive.look != nullptr; });
            },
            test::patienceMs);
    }
};

} // namespace

/// A machine file in the window: how each axis of all drives stands to it.
class TestMachine : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void everyAxisOfTheFileIsComparedAndItsDrivesAreConnected()
    {
        Machine all;
        QVERIFY(all.bench.connect());
        QVERIFY(all.open(all.writeBoth()));
        QCOMPARE(all.bench->endpoints(),
            (QStringList{QStringLiteral("http://x"), QStringLiteral("http://c")}));
        const AxisDrift x = all.drift("http://x", 0);
        QCOMPARE(x.state, State::Differs);
        QVERIFY(x.looked.isValid());
        QVERIFY(x.plan);
        QCOMPARE(x.plan->plan.changes.front().field, std::string("Table"));
        QCOMPARE(all.drift("http://x", 1).state, State::NotInFile);
        QCOMPARE(all.drift("http://c", 0).state, State::Differs);
        QCOMPARE(all.drift("http://other", 0).state, State::NotInFile);
    }

    void comparingChangesNothing()
    {
        Machine all;
        QVERIFY(all.bench.connect());
        const auto before = test::CompensatorFixture::stateOf(all.bench.drive().drive, 0);
        QVERIFY(all.open(all.writeBoth("persistent = true\nactive = true\n")));
        QCOMPARE(all.drift("http://x", 0).state, State::Differs);
        QVERIFY(test::CompensatorFixture::stateOf(all.bench.drive().drive, 0) == before);
    }

    void theColumnSaysWhatDiffersAndSinceWhenThatIsKnown()
    {
        Machine all;
        QVERIFY(all.bench.connect());
        OverviewModel model(all.bench->overview());
        model.showMachine(all.machine());
        QCOMPARE(model.index(0, Column::Machine).data().toString(), QString());
        QVERIFY(all.open(all.writeBoth()));
        const QString said = model.index(0, Column::Machine).data().toString();
        QVERIFY2(said.startsWith(QStringLiteral("differs: Table, Dim1Source, Persistency · ")),
            qPrintable(said));
        QCOMPARE(
            model.index(1, Column::Machine).data().toString(), QStringLiteral("not in the file"));
        QCOMPARE(model.index(0, Column::Machine).data(OverviewModel::DriftToneRole).toInt(),
            static_cast<int>(Tone::Warning));
    }

    void anotherSerialNumberIsRefused()
    {
        Machine all;
        QVERIFY(all.bench.connect());
        QVERIFY(all.open(all.writeBoth({}, 4799)));
        const AxisDrift drift = all.drift("http://c", 0);
        QCOMPARE(drift.state, State::Problem);
        QVERIFY(!drift.plan);
        QCOMPARE(drift.look->problem->code, ErrorCode::OtherDrive);
        QCOMPARE(all.drift("http://x", 0).state, State::Differs);
    }

    void anAxisThatTheDriveDoesNotHaveIsNoOther()
    {
        Machine all;
        QVERIFY(all.bench.connect());
        QVERIFY(
            all.open(all.write(driveSection(QStringLiteral("http://x"), 4711) + axisSection("Z"))));
        QCOMPARE(all.drift("http://x", 0).state, State::NotInFile);
        const MachineDriveState& drive = all.machine().drives().front();
        QCOMPARE(MachineController::driftOf(drive, 0).state, State::Problem);
        QCOMPARE(drive.look->plan->axes[0].problem->code, ErrorCode::AxisNotFound);
    }

    void aDriveThatDoesNotAnswerHoldsUpNoOtherAndIsComparedWhenItDoes()
    {
        Machine all;
        QVERIFY(all.bench.connect());
        all.bench.drive("http://c").gate.set(DriveGate::Mode::Gone);
        QVERIFY(all.open(all.writeBoth()));
        QTRY_COMPARE(all.drift("http://x", 0).state, State::Differs);
        QCOMPARE(all.drift("http://c", 0).state, State::Unreachable);
        all.bench.drive("http://c").gate.set(DriveGate::Mode::Open);
        QTRY_COMPARE(all.drift("http://c", 0).state, State::Differs);
        all.bench.drive("http://c").gate.set(DriveGate::Mode::Gone);
        all.machine().planAgain();
        QTRY_COMPARE(all.drift("http://c", 0).state, State::Unreachable);
        QVERIFY(!all.drift("http://c", 0).plan);
    }

    void aWriteOfThisWindowIsComparedByItself()
    {
        Machine all;
        QVERIFY(all.bench.connect());
        QVERIFY(all.open(all.writeBoth()));
        all.bench.chooseMasterSources(1);
        all.bench->openData(all.bench.path(QStringLiteral("first.csv")));
        QVERIFY(all.bench.fileRead());
        QTRY_VERIFY(all.bench->action(Action::Write).isEnabled);
        QVERIFY(all.bench.planAndWrite());
        QTRY_COMPARE(all.drift("http://x", 0).state, State::AsFile);
        QCOMPARE(all.drift("http://c", 0).state, State::Differs);
    }

    void whatSomebodyElseChangesEndsWhatWasKnown()
    {
        Machine all;
        QVERIFY(all.bench.connect());
        QVERIFY(all.open(all.write(driveSection(QStringLiteral("http://x"), 4711)
            + "[[drive.axis]]\naxis = \"Y\"\nno-table = true\nsources = [\"\"]\n")));
        all.bench->overview().readNow();
        QTRY_VERIFY(all.bench->overview().rows().at(1).status.has_value());
        QTRY_COMPARE(all.drift("http://x", 1).state, State::AsFile);
        const auto source = all.bench.drive().drive.readRegisters({test::masterX});
        QVERIFY(source.has_value());
        all.bench.drive().set(
            "Axes[1]/Parameters/Compensations/Axis/Dim1Source", source->front().address);
        all.bench->overview().readNow();
        QTRY_COMPARE(all.drift("http://x", 1).state, State::Differs);
    }

    /// The overview has said nothing yet of what was compared.
    void whatSomebodyElseChangesBeforeTheOverviewIsReadEndsWhatWasKnown()
    {
        Machine all;
        QVERIFY(all.bench.connect());
        QVERIFY(all.open(all.write(driveSection(QStringLiteral("http://x"), 4711)
            + "[[drive.axis]]\naxis = \"Y\"\nno-table = true\nsources = [\"\"]\n")));
        QCOMPARE(all.drift("http://x", 1).state, State::AsFile);
        const auto source = all.bench.drive().drive.readRegisters({test::masterX});
        QVERIFY(source.has_value());
        all.bench.drive().set(
            "Axes[1]/Parameters/Compensations/Axis/Dim1Source", source->front().address);
        all.bench->overview().readNow();
        QTRY_COMPARE(all.drift("http://x", 1).state, State::Differs);
    }

    void anOperationDoesNotWaitForTheComparison()
    {
        Machine all;
        QVERIFY(all.bench.connect());
        QVERIFY(all.bench.prepare2D());
        QVERIFY(all.open(all.writeBoth()));
        DriveGate& gate = all.bench.drive().gate;
        gate.set(DriveGate::Mode::Silent);
        all.machine().planAgain();
        QTRY_COMPARE(gate.waiting(), 1);
        const int before = gate.exchanges();
        all.bench->planWrite();
        QTRY_VERIFY(gate.exchanges() > before); // long before the deadline of 20 s
        QCOMPARE(gate.timeouts(), 0);
        gate.set(DriveGate::Mode::Open);
        QVERIFY(all.bench.idle());
        QVERIFY(all.compared());
        QCOMPARE(all.drift("http://x", 0).state, State::Differs);
    }

    void aFileThatIsReadAgainHasWhatItSaysNow()
    {
        Machine all;
        QVERIFY(all.bench.connect());
        QVERIFY(all.open(all.writeBoth()));
        static_cast<void>(all.write("nonsense = 1\n"));
        all.machine().planAgain();
        QTRY_VERIFY(!all.machine().isReading());
        QVERIFY(all.machine().file()->refusal);
        QVERIFY(all.machine().drives().empty());
        QCOMPARE(all.drift("http://x", 0).state, State::NotInFile);
        QVERIFY(all.open(all.writeBoth()));
        QCOMPARE(all.drift("http://x", 0).state, State::Differs);
        all.machine().close();
        QVERIFY(!all.machine().file());
        QCOMPARE(all.bench->endpoints().size(), 2);
    }

    void aNameInTheFileIsShownWithoutMarkupAndCut()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        bench.picked = bench.file(QStringLiteral("mill.toml"),
            "version = 1\nname = \"<b>" + QByteArray(5000, 'M') + "\"\n"
                + driveSection(bench.served.url(), 1559)
                + "[[drive.axis]]\naxis = \"X\"\nno-table = true\nsources = [\"\"]\n");
        user.the<QAction>("openMachineAction").trigger();
        QTRY_VERIFY(user.sees("machineSummary"));
        auto& summary = user.the<QLabel>("machineSummary");
        QTRY_VERIFY(summary.text().startsWith(QStringLiteral("mill.toml (<b>MMM")));
        QCOMPARE(summary.textFormat(), Qt::PlainText);
        QVERIFY2(summary.text().size() < 400, qPrintable(summary.text()));
    }

    void aPersonOpensAFileAndSeesWhatDiffers()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        static_cast<void>(bench.file(QStringLiteral("first.csv"), first1D));
        bench.picked = bench.file(QStringLiteral("mill.toml"),
            "version = 1\nname = \"Mill 7\"\n" + driveSection(bench.served.url(), 1559)
                + axisSection("X") + axisSection("Q"));
        user.the<QAction>("openMachineAction").trigger();
        QCOMPARE(bench.questions.back().purpose, FileQuestion::Purpose::OpenMachine);
        QTRY_VERIFY(user.sees("overview"));
        auto& table = user.the<QTableView>("overview");
        QTRY_VERIFY(!table.isColumnHidden(Column::Machine));
        QTRY_VERIFY(table.model()
                        ->index(0, Column::Machine)
                        .data()
                        .toString()
                        .startsWith(QStringLiteral("differs: ")));
        QTRY_VERIFY2(user.the<QLabel>("machineSummary")
                         .text()
                         .startsWith(QStringLiteral(
                             "mill.toml (Mill 7): axes differ: 1, cannot be compared: 1. ")),
            qPrintable(user.the<QLabel>("machineSummary").text()));
        QVERIFY(user.sees("machineWarnings")); // of the axis that there is not
        auto& rows = user.the<QTableWidget>("driftRows");
        QTRY_COMPARE(rows.rowCount(), 3);
        QCOMPARE(rows.item(0, 1)->text(), QStringLiteral("no table"));
        QVERIFY2(rows.item(0, 2)->text().startsWith(QStringLiteral("first.csv: 3 points")),
            qPrintable(rows.item(0, 2)->text()));
        QVERIFY(user.click("closeMachine"));
        QTRY_VERIFY(table.isColumnHidden(Column::Machine));
        QVERIFY(!user.sees("driftDetails"));
    }

    void applyingWritesWhatWasPlannedAndNothingElse()
    {
        Machine all;
        QVERIFY(all.bench.connect());
        QVERIFY(all.open(all.writeBoth("persistent = true\n")));
        QCOMPARE(all.machine().applyObstacle(false), QString());
        QVERIFY(all.apply());
        const auto& written = all.machine().application().drives();
        QCOMPARE(written.size(), std::size_t(2));
        for (const auto& drive : written) {
            QVERIFY(!drive.problem);
            QVERIFY(drive.outcomes.at(0).report.has_value());
            QVERIFY(drive.outcomes[0].now->table.has_value());
        }
        QVERIFY(written[0].outcomes[0].now->table->persistent);
        QVERIFY(!written[1].outcomes[0].now->table->persistent);
        QVERIFY(!all.bench->isWriting());
        const auto& rows = all.bench->overview().rows(); // X, Y and C
        for (const std::size_t row : {0, 2}) {
            QCOMPARE(rows.at(row).file, QStringLiteral("first.csv"));
            QCOMPARE(rows.at(row).column, QStringLiteral("Error"));
        }
        QVERIFY(rows.at(1).file.isEmpty());
        QVERIFY(all.compared());
        QTRY_COMPARE(all.drift("http://x", 0).state, State::AsFile);
        QTRY_COMPARE(all.drift("http://c", 0).state, State::AsFile);
        QCOMPARE(all.machine().applyObstacle(false),
            QStringLiteral("All drives have what the file says."));
    }

    void thePageKnowsThatThisWindowHasChangedItsAxis()
    {
        Machine all;
        QVERIFY(all.bench.connect());
        QVERIFY(all.open(all.writeBoth()));
        QVERIFY(all.apply());
        QVERIFY(all.bench.readLive());
        QCOMPARE(all.bench->outcome(),
            QStringLiteral("mill.toml is applied. Written and verified: X · Test-1, 0 · Table-2."));
        QVERIFY(!all.bench->isOutcomeAWarning());
        QVERIFY(all.bench->status()->table.has_value());
        QStringList said;
        for (const LogLine& line : all.bench->log())
            said += line.text();
        const auto has = [&](const QString& words) {
            return std::ranges::any_of(
                said, [&](const QString& line) { return line.contains(words); });
        };
        QVERIFY(has(QStringLiteral("X · Test-1: written; it holds: ")));
        QVERIFY(has(QStringLiteral("0 · Table-2: written; it holds: ")));
        QVERIFY(!has(QStringLiteral("Another program")));
    }

    void nothingIsWrittenWhileAPartIsImpossible()
    {
        Machine all;
        QVERIFY(all.bench.connect());
        QVERIFY(all.open(all.writeBoth({}, 4799)));
        QVERIFY(!all.machine().applyObstacle(false).isEmpty());
        QVERIFY(!all.machine().applyObstacle(true).isEmpty()); // it answers
        QCOMPARE(all.machine().obstacles(true).size(), std::size_t(1));
        QCOMPARE(all.machine().obstacles(true)[0].problem.error.code, ErrorCode::OtherDrive);
    }

    void aMissingDriveIsLeftOutOnlyWhenThatIsSaid()
    {
        Machine all;
        QVERIFY(all.bench.connect());
        all.bench.drive("http://c").gate.set(DriveGate::Mode::Gone);
        QVERIFY(all.open(all.writeBoth()));
        QTRY_COMPARE(all.drift("http://c", 0).state, State::Unreachable);
        QTRY_VERIFY(!all.machine().isAsking());
        QVERIFY(!all.machine().applyObstacle(false).isEmpty());
        QCOMPARE(all.machine().applyObstacle(true), QString());
        QVERIFY(all.apply());
        QCOMPARE(all.machine().application().drives().size(), std::size_t(1));
        QTRY_COMPARE(all.drift("http://x", 0).state, State::AsFile);
    }

    void whereNoDriveAnswersNothingIsKnown()
    {
        Machine all;
        QVERIFY(all.bench.connect());
        QVERIFY(all.open(all.writeBoth()));
        for (const char* endpoint : {"http://x", "http://c"})
            all.bench.drive(endpoint).gate.set(DriveGate::Mode::Gone);
        all.machine().planAgain();
        for (const char* endpoint : {"http://x", "http://c"})
            QTRY_COMPARE(all.drift(endpoint, 0).state, State::Unreachable);
        QTRY_VERIFY(!all.machine().isAsking());
        QVERIFY(!all.machine().obstacles(false).empty());
        QCOMPARE(
            all.machine().applyObstacle(true), QStringLiteral("No drive of the file answers."));
    }

    void largeCorrectionsHaveToBeAcceptedInTheFile()
    {
        Machine all;
        QVERIFY(all.bench.connect());
        static_cast<void>(all.bench.file(
            QStringLiteral("first.csv"), "Position [mm],Error [mm]\n0,0\n40,2.1\n80,-1\n"));
        const QByteArray drive = driveSection(QStringLiteral("http://x"), 4711);
        QVERIFY(all.open(all.write(drive + axisSection("X"))));
        QVERIFY(!all.machine().applyObstacle(false).isEmpty());
        QCOMPARE(
            all.machine().obstacles(false).at(0).problem.error.code, ErrorCode::LargeCorrection);
        QVERIFY(all.open(all.write(drive + axisSection("X", "accept-large = true\n"))));
        QCOMPARE(all.machine().applyObstacle(false), QString());
        QVERIFY(!all.drift("http://x", 0).plan->plan.largeCorrections.empty());
    }

    void activationsAreSwitchedOnlyWhenThatIsSaid()
    {
        Machine all;
        static_cast<void>(all.bench.file(QStringLiteral("first.csv"), aroundTheTravel));
        QVERIFY(all.bench.connect());
        QVERIFY(all.open(all.writeBoth("active = true\n")));
        QVERIFY(all.apply());
        QVERIFY(!all.bench->status()->isOn());
        QTRY_COMPARE(all.drift("http://x", 0).state, State::Differs); // its activation
        QVERIFY(all.compared());
        QVERIFY(!all.machine().applyObstacle(false).isEmpty());
        all.machine().setActivates(true);
        QVERIFY(all.compared());
        QTRY_COMPARE(all.machine().applyObstacle(false), QString());
        QVERIFY(all.apply());
        QVERIFY(all.bench->status()->isOn());
        QCOMPARE(
            all.bench->outcome(), QStringLiteral("mill.toml is applied. Switched: X · Test-1."));
        QVERIFY(!all.bench->isOutcomeAWarning());
        QTRY_COMPARE(all.drift("http://x", 0).state, State::AsFile);
    }

    /// Outside of its table an axis shows nothing.
    void whatIsSwitchedOnAndNotProvedIsWarnedOf()
    {
        Machine all;
        static_cast<void>(all.bench.file(QStringLiteral("first.csv"), awayFromTheTravel));
        QVERIFY(all.bench.connect());
        all.machine().setActivates(true);
        QVERIFY(all.open(all.write(
            driveSection(QStringLiteral("http://x"), 4711) + axisSection("X", "active = true\n"))));
        QTRY_COMPARE(all.machine().applyObstacle(false), QString());
        QVERIFY(all.apply());
        QCOMPARE(all.bench->outcome(),
            QStringLiteral("mill.toml is applied. Written and verified: X · Test-1. Switched: X · "
                           "Test-1. Not proved: X · Test-1."));
        QVERIFY(all.bench->isOutcomeAWarning());
        const auto isWhy = [](const LogLine& line) {
            const QString text = line.text();
            return line.kind == LogLine::Kind::Warning
                && text.startsWith(
                    QStringLiteral("X · Test-1: written and switched, not proved; it holds: "))
                && text.endsWith(
                    QStringLiteral(" Not proved. The axis is outside of the table, where the "
                                   "values at its ends hold. Move the axis into the table and "
                                   "activate again."));
        };
        QVERIFY(std::ranges::any_of(all.bench->log(), isWhy));
    }

    void whatWasToBeSwitchedAndWasNotIsSaid()
    {
        Machine all;
        QVERIFY(all.bench.connect());
        const QByteArray axes = axisSection("X") + axisSection("Y", "active = true\n");
        const QString file = all.write(driveSection(QStringLiteral("http://x"), 4711) + axes);
        QVERIFY(all.open(file));
        QVERIFY(all.apply());
        QTRY_COMPARE(all.drift("http://x", 0).state, State::AsFile);
        // Another table for X alone: Y has what it shall have, and is to be switched on.
        static_cast<void>(all.bench.file(QStringLiteral("other.csv"), second1D));
        static_cast<void>(all.write(driveSection(QStringLiteral("http://x"), 4711)
            + QByteArray(axes).replace(axes.indexOf("first"), 5, "other")));
        all.machine().setActivates(true);
        QVERIFY(all.open(file));
        QTRY_COMPARE(all.machine().applyObstacle(false), QString());
        all.bench.drive().gate.holdUploads();
        all.machine().apply();
        QTRY_VERIFY(all.bench->busy().fraction > 0.1);
        all.bench->cancel();
        QTRY_VERIFY(all.bench->isOutcomeAnError());
        QTRY_VERIFY2(all.bench->outcome().contains(
                         QStringLiteral("Failed: X · Test-1. Not switched: Y · Test-1. ")),
            qPrintable(all.bench->outcome()));
    }

    void aStoppedApplicationPutsBackAndSaysSo()
    {
        Machine all;
        QVERIFY(all.bench.connect());
        QVERIFY(all.open(all.writeBoth()));
        const auto before = test::CompensatorFixture::stateOf(all.bench.drive().drive, 0);
        all.bench.drive().gate.holdUploads();
        all.machine().apply();
        QVERIFY(all.bench->isWriting());
        QTRY_VERIFY(all.bench->busy().fraction > 0.1);
        all.bench->cancel();
        QTRY_VERIFY(!all.bench->isWriting());
        QTRY_VERIFY(all.bench->isOutcomeAnError());
        QVERIFY(test::CompensatorFixture::stateOf(all.bench.drive().drive, 0) == before);
        QVERIFY2(all.bench->outcome().contains(QStringLiteral("Failed: X · Test-1")),
            qPrintable(all.bench->outcome()));
    }

    /// The drive of the page is none of the file, or it is done before the other one.
    void theFieldsWaitForAllDrivesAndNotLonger_data()
    {
        QTest::addColumn<bool>("isCurrentWritten");
        QTest::newRow("the other drive alone") << false;
        QTest::newRow("both drives") << true;
    }
    void theFieldsWaitForAllDrivesAndNotLonger()
    {
        QFETCH(const bool, isCurrentWritten);
        Machine all;
        QVERIFY(all.bench.connect());
        const QString onlyC =
            all.write(driveSection(QStringLiteral("http://c"), 4712) + axisSection("0"));
        QVERIFY(all.open(isCurrentWritten ? all.writeBoth() : onlyC));
        QTRY_COMPARE(all.machine().applyObstacle(false), QString());
        const SetupPanel panel(
            all.bench.controller(), drivecomm::genericProfile(), *QApplication::style());
        const auto& field = *panel.findChild<QCheckBox*>(QStringLiteral("persistencyField"));
        QVERIFY(field.isEnabled());
        all.bench.drive("http://c").gate.holdUploads();
        all.machine().apply();
        QVERIFY(!field.isEnabled());
        QVERIFY(all.bench.idle());
        QVERIFY(all.bench->isWriting() && !field.isEnabled());
        all.bench.drive("http://c").gate.releaseUploads();
        QTRY_VERIFY(!all.bench->isWriting());
        QTRY_VERIFY(field.isEnabled());
        QVERIFY(!all.bench->isOutcomeAnError());
    }

    void aSavedMachineIsWhatTheDrivesHave()
    {
        Machine all;
        QVERIFY(all.bench.connect());
        QVERIFY(all.open(all.writeBoth("persistent = true\n")));
        QVERIFY(all.apply());
        QVERIFY(all.compared());
        MachineSaving& saving = all.machine().saving();
        const QString folder = all.bench.path(QStringLiteral("saved"));
        const QStringList drives{QStringLiteral("http://x"), QStringLiteral("http://c")};
        saving.save(drives, QStringLiteral("Mill 7"), folder);
        QTRY_COMPARE(saving.stage(), MachineSaving::Stage::Saved);
        QCOMPARE(saving.snapshot()->tables(), std::size_t(2));
        QVERIFY(all.open(folder + QStringLiteral("/machine.toml")));
        QTRY_COMPARE(all.drift("http://x", 0).state, State::AsFile);
        QCOMPARE(all.drift("http://c", 0).state, State::AsFile);
        // The same state again is the same bytes: there is nothing to ask.
        saving.save(drives, QStringLiteral("Mill 7"), folder);
        QTRY_COMPARE(saving.stage(), MachineSaving::Stage::Saved);
    }

    void noFileIsReplacedWithoutAsking()
    {
        Machine all;
        QVERIFY(all.bench.connect());
        const QStringList drives{QStringLiteral("http://x")};
        const QString folder = all.bench.path(QString());
        const QByteArray mine = "mine\n";
        const QString file = all.bench.file(QStringLiteral("machine.toml"), mine);
        const auto content = [&] {
            QFile opened(file);
            return opened.open(QIODevice::ReadOnly) ? opened.readAll() : QByteArray();
        };
        MachineSaving& saving = all.machine().saving();
        saving.save(drives, {}, folder);
        QTRY_COMPARE(saving.stage(), MachineSaving::Stage::Asking);
        QCOMPARE(saving.replaced(), QStringList(QStringLiteral("machine.toml")));
        QCOMPARE(content(), mine);
        saving.replace();
        QTRY_COMPARE(saving.stage(), MachineSaving::Stage::Saved);
        QVERIFY(content().startsWith("version = 1\n"));
    }

    void aFileThatAppearsAfterTheQuestionIsAskedForToo()
    {
        Machine all;
        QVERIFY(all.bench.connect());
        QVERIFY(all.open(all.writeBoth("persistent = true\n")));
        QVERIFY(all.apply());
        const QByteArray mine = "mine\n";
        QVERIFY(QDir().mkpath(all.bench.path(QStringLiteral("saved"))));
        static_cast<void>(all.bench.file(QStringLiteral("saved/machine.toml"), mine));
        MachineSaving& saving = all.machine().saving();
        saving.save({QStringLiteral("http://x")}, {}, all.bench.path(QStringLiteral("saved")));
        QTRY_COMPARE(saving.stage(), MachineSaving::Stage::Asking);
        QCOMPARE(saving.replaced(), QStringList(QStringLiteral("machine.toml")));
        const QString table = QString::fromStdString(saving.snapshot()->files.front().name);
        const QString file = all.bench.file(QStringLiteral("saved/") + table, mine);
        saving.replace();
        QTRY_COMPARE(saving.stage(), MachineSaving::Stage::Asking);
        QCOMPARE(saving.replaced(), (QStringList{table, QStringLiteral("machine.toml")}));
        QFile opened(file);
        QVERIFY(opened.open(QIODevice::ReadOnly));
        QCOMPARE(opened.readAll(), mine);
        saving.replace();
        QTRY_COMPARE(saving.stage(), MachineSaving::Stage::Saved);
    }

    void aMachineWithoutOneOfItsDrivesIsNotSaved()
    {
        Machine all;
        QVERIFY(all.bench.connect());
        QVERIFY(all.open(all.writeBoth()));
        all.bench.drive("http://c").gate.set(DriveGate::Mode::Gone);
        MachineSaving& saving = all.machine().saving();
        const QString folder = all.bench.path(QStringLiteral("saved"));
        saving.save({QStringLiteral("http://x"), QStringLiteral("http://c")}, {}, folder);
        QTRY_COMPARE(saving.stage(), MachineSaving::Stage::Failed);
        QCOMPARE(saving.problemPlace(), QStringLiteral("http://c"));
        QVERIFY(!QFile::exists(folder));
    }

    void aPersonSeesAllPlansBeforeAnythingIsWritten()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        static_cast<void>(bench.file(QStringLiteral("first.csv"), first1D));
        bench.picked = bench.file(QStringLiteral("mill.toml"),
            "version = 1\n" + driveSection(bench.served.url(), 1559) + axisSection("X"));
        const auto before = bench.state();
        user.the<QAction>("openMachineAction").trigger();
        QTRY_VERIFY(user.sees("overview"));
        user.the<QAction>("applyMachineAction").trigger();
        QTRY_VERIFY(user.sees("applyMachineDialog"));
        QTRY_COMPARE(user.the<QTableWidget>("applyRows").rowCount(), 1);
        QTRY_VERIFY(user.the("applyButton").isEnabled());
        QVERIFY(user.the<QTableWidget>("applyRows")
                    .item(0, 2)
                    ->text()
                    .contains(QStringLiteral("first.csv: 3 points")));
        QVERIFY(bench.state() == before);
        user.the<QPushButton>("applyButton").click();
        QTRY_VERIFY(!user.sees("applyButton")); // it has ended
        QCOMPARE(user.the<QTableWidget>("applyRows").item(0, 1)->text(), QStringLiteral("written"));
        QVERIFY(user.the<QLabel>("applyReason")
                    .text()
                    .startsWith(QStringLiteral("mill.toml is applied.")));
        QVERIFY(!(bench.state() == before));
        user.the<QPushButton>("closeApplyButton").click();
        QTRY_VERIFY(!user.find("applyMachineDialog"));
    }

    void aPersonSeesWhetherWhatWasSwitchedOnIsProved_data()
    {
        QTest::addColumn<QByteArray>("table");
        QTest::addColumn<bool>("isProved");
        QTest::newRow("around the travel") << aroundTheTravel << true;
        QTest::newRow("away from it") << awayFromTheTravel << false;
    }
    void aPersonSeesWhetherWhatWasSwitchedOnIsProved()
    {
        QFETCH(const QByteArray, table);
        QFETCH(const bool, isProved);
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        static_cast<void>(bench.file(QStringLiteral("first.csv"), table));
        bench.picked = bench.file(QStringLiteral("mill.toml"),
            "version = 1\n" + driveSection(bench.served.url(), 1559)
                + axisSection("X", "active = true\n"));
        user.the<QAction>("openMachineAction").trigger();
        QTRY_VERIFY(user.sees("overview"));
        user.the<QAction>("applyMachineAction").trigger();
        QTRY_VERIFY(user.sees("applyActivates"));
        user.the<QCheckBox>("applyActivates").setChecked(true);
        QTRY_VERIFY(bench.controller().machine().applyObstacle(false).isEmpty()
            && user.the("applyButton").isEnabled());
        user.the<QPushButton>("applyButton").click();
        QTRY_VERIFY(!user.sees("applyButton")); // it has ended
        QCOMPARE(user.the<QTableWidget>("applyRows").item(0, 1)->text(),
            isProved ? QStringLiteral("written and switched, proved")
                     : QStringLiteral("written and switched, not proved"));
        const QString proved = user.the<QLabel>("applyRemarks").text();
        const QStringList warned = user.the<WarningList>("applyWarnings").warnings();
        QCOMPARE(proved.startsWith(QStringLiteral("X · Stage-7: Proved over ")), isProved);
        QCOMPARE(warned.size(), isProved ? qsizetype(0) : qsizetype(1));
        QVERIFY(isProved
            || warned.front().startsWith(
                QStringLiteral("X · Stage-7: Not proved. The axis is outside of the table")));
    }

    /// A second one would switch off what is chosen in the first.
    void thereIsOneDialogToApplyAMachineFile()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        static_cast<void>(bench.file(QStringLiteral("first.csv"), first1D));
        bench.picked = bench.file(QStringLiteral("mill.toml"),
            "version = 1\n" + driveSection(bench.served.url(), 1559) + axisSection("X"));
        user.the<QAction>("openMachineAction").trigger();
        QTRY_VERIFY(user.sees("overview"));
        user.the<QAction>("applyMachineAction").trigger();
        QTRY_VERIFY(user.sees("applyMachineDialog"));
        QTRY_VERIFY(user.the("applyMachine").isEnabled());
        user.the<QPushButton>("applyMachine").click();
        const auto count =
            bench.wizard.findChildren<QDialog*>(QStringLiteral("applyMachineDialog")).size();
        QCOMPARE(count, qsizetype(1));
    }

    /// The dialog goes after the menu, and takes back what was chosen in it.
    void theWindowGoesWithTheDialogOpenAndActivationsChosen()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        static_cast<void>(bench.file(QStringLiteral("first.csv"), first1D));
        bench.picked = bench.file(QStringLiteral("mill.toml"),
            "version = 1\n" + driveSection(bench.served.url(), 1559)
                + axisSection("X", "active = true\n"));
        user.the<QAction>("openMachineAction").trigger();
        QTRY_VERIFY(user.sees("overview"));
        user.the<QAction>("applyMachineAction").trigger();
        QTRY_VERIFY(user.sees("applyActivates"));
        user.the<QCheckBox>("applyActivates").setChecked(true);
        QVERIFY(bench.controller().machine().activates());
    }

    void aPersonSavesTheDrivesOfAMachine()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.openWritten());
        bench.picked = bench.path(QStringLiteral("mill"));
        user.the<QAction>("saveMachineAction").trigger();
        QTRY_VERIFY(user.sees("saveMachineDialog"));
        QTRY_VERIFY(user.the("saveMachineButton").isEnabled());
        user.the<QPushButton>("saveMachineButton").click();
        QCOMPARE(bench.questions.back().purpose, FileQuestion::Purpose::SaveMachine);
        QTRY_VERIFY(user.the<QLabel>("saveMachineReason")
                        .text()
                        .endsWith(QStringLiteral("machine.toml: drives: 1, tables: 1.")));
        QVERIFY(QFile::exists(bench.path(QStringLiteral("mill/1559-axis0.csv"))));
    }

    void whatIsChosenAnewIsNotSavedByTheAnswerToAnOlderQuestion()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.openWritten());
        static_cast<void>(bench.file(QStringLiteral("machine.toml"), "mine\n"));
        bench.picked = bench.path(QString());
        user.the<QAction>("saveMachineAction").trigger();
        QTRY_VERIFY(user.sees("saveMachineDialog"));
        QTRY_VERIFY(user.the("saveMachineButton").isEnabled());
        user.the<QPushButton>("saveMachineButton").click();
        QTRY_VERIFY(user.sees("replaceMachineButton"));
        user.the<QListWidget>("machineDrives").item(0)->setCheckState(Qt::Unchecked);
        QVERIFY(!user.sees("replaceMachineButton"));
        QCOMPARE(
            user.the<QLabel>("saveMachineReason").text(), QStringLiteral("No drive is chosen."));
    }

    void aFileWithMistakesSaysWhereTheyAre()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        bench.picked = bench.file(QStringLiteral("mill.toml"),
            "version = 1\n" + driveSection(bench.served.url(), 1559)
                + "[[drive.axis]]\nfyle = 1\n");
        user.the<QAction>("openMachineAction").trigger();
        QTRY_VERIFY(user.sees("machineProblems"));
        const QAbstractItemModel& problems = *user.the<QTreeView>("machineProblems").model();
        QVERIFY(problems.rowCount() > 0);
        bool isNamed = false;
        for (int row = 0; row < problems.rowCount(); ++row)
            isNamed = isNamed
                || (problems.index(row, 0).data().toString() == QStringLiteral("6")
                    && problems.index(row, 1).data().toString() == QStringLiteral("1")
                    && problems.index(row, 2).data().toString().contains(QStringLiteral("file")));
        QVERIFY(isNamed);
        QVERIFY(!user.sees("driftDetails"));
    }
};

AXISCOMP_WINDOW_TEST(TestMachine)

} // namespace tst_machine

#include "tst_machine.moc"
