// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/tam_table.h"
#include "tests/support/moments.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"
#include "tests/ui/support/web_fixture.h"

#include <QTest>

#include <functional>

namespace tst_wizardweb {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::WebFixture;

namespace {

using Connection = DriveState::Connection;

const QString written = QStringLiteral("Written and verified: the drive holds the new state.");
const std::string base = "Axes[0]/Parameters/Compensations/Axis/";
const std::string tableX = base + "Table";

/// One operation of the controller, from a state in which it can begin.
struct Operation {
    std::function<bool(WebFixture&)> prepare;
    std::function<void(WebFixture&)> begin;
};

bool planNewTable(WebFixture& bench)
{
    if (!bench.prepare2D(1) || !bench.planAndWrite() || !bench.prepare2D(2))
        return false;
    bench->planWrite();
    return bench.idle() && bench->plan().has_value();
}

bool planPrevious(WebFixture& bench)
{
    return bench.prepare2D(1) && bench.planAndWrite() && bench.prepare2D(2) && bench.planAndWrite()
        && bench.planRestoration();
}

bool writeTable(WebFixture& bench)
{
    return bench.prepare2D(1) && bench.planAndWrite();
}

bool activateTable(WebFixture& bench)
{
    if (!writeTable(bench))
        return false;
    bench->activate();
    return bench.idle() && bench->status()->axis.stateWord == "Active";
}

const std::vector<std::pair<const char*, Operation>>& operations()
{
    static const std::vector<std::pair<const char*, Operation>> all{
        {"write", {planNewTable, [](WebFixture& bench) { bench->write(); }}},
        {"activate", {writeTable, [](WebFixture& bench) { bench->activate(); }}},
        {"deactivate", {activateTable, [](WebFixture& bench) { bench->deactivate(); }}},
        {"restore", {planPrevious, [](WebFixture& bench) { bench->write(); }}},
    };
    return all;
}

/// The operation can begin, and nothing else is under way.
bool isReady(WebFixture& bench, const Operation& operation)
{
    return bench.connectByWeb() && operation.prepare(bench) && bench.readLive();
}

/// How many exchanges the operation takes when all goes well.
int exchangesOf(const Operation& operation)
{
    WebFixture bench;
    if (!isReady(bench, operation))
        return 0;
    const int before = bench.drive().gate.exchanges();
    int exchanges = 0;
    QObject context;
    QObject::connect(&bench.controller(), &WizardController::busyChanged, &context, [&] {
        if (!bench->busy().isBusy)
            exchanges = bench.drive().gate.exchanges() - before;
    });
    operation.begin(bench);
    return bench.idle() ? exchanges : 0;
}

} // namespace

class TestWizardWeb : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void fromTheFirstTableToTheOneBeforeAgain()
    {
        WebFixture bench;
        QVERIFY(bench.connectByWeb());
        QCOMPARE(bench->drives().front().name, QStringLiteral("Test-1"));
        QVERIFY(writeTable(bench));
        QVERIFY2(bench->outcome().startsWith(written), qPrintable(bench->outcome()));
        const CompensationSetup first = bench->setup().baseline();
        QCOMPARE(bench.drive().text(tableX), first.slot);

        bench->activate();
        QVERIFY(bench.idle());
        QVERIFY2(bench->outcome().contains(QStringLiteral("Proved")), qPrintable(bench->outcome()));
        QVERIFY(bench->proof().has_value());
        QCOMPARE(bench->status()->axis.stateWord, "Active");
        QCOMPARE(bench->action(Action::Write).reason,
            QStringLiteral("The compensation is active: deactivate it first."));

        bench->deactivate();
        QVERIFY(bench.idle());
        QCOMPARE(bench->status()->axis.stateWord, "Disabled");

        QVERIFY(bench.prepare2D(2));
        QVERIFY(bench.planAndWrite());
        QVERIFY(bench->setup().baseline().tableCrc != first.tableCrc);
        QVERIFY(bench.restorePrevious());
        QVERIFY2(
            bench->outcome().startsWith(QStringLiteral("Restored")), qPrintable(bench->outcome()));
        QCOMPARE(bench->setup().baseline().tableCrc, first.tableCrc);
        QVERIFY(!bench->setup().isDirty());
    }

    /// At every exchange of every operation: the loss is said, what the user has changed stays, the
    /// window connects again by itself and then shows what the drive holds.
    void aConnectionThatIsLostInAnOperationComesBack_data()
    {
        QTest::addColumn<Operation>("operation");
        for (const auto& [name, operation] : operations())
            QTest::newRow(name) << operation;
    }
    void aConnectionThatIsLostInAnOperationComesBack()
    {
        QFETCH(Operation, operation);
        const int exchanges = exchangesOf(operation);
        QVERIFY(exchanges > 0);
        for (int exchange = 1; exchange <= exchanges; ++exchange) {
            if (!test::hasTurn(exchange, 3))
                continue;
            loseAt(exchange, operation);
            if (QTest::currentTestFailed())
                QFAIL(qPrintable(QStringLiteral("lost at exchange %1").arg(exchange)));
        }
    }

    void aDriveThatRebootsInTheMiddleIsShownAsItIsAfterwards_data()
    {
        aConnectionThatIsLostInAnOperationComesBack_data();
    }
    void aDriveThatRebootsInTheMiddleIsShownAsItIsAfterwards()
    {
        QFETCH(Operation, operation);
        const int exchanges = exchangesOf(operation);
        QVERIFY(exchanges > 0);
        for (int exchange = 1; exchange <= exchanges; ++exchange) {
            if (!test::hasTurn(exchange + 1, 3))
                continue;
            rebootAt(exchange, operation);
            if (QTest::currentTestFailed())
                QFAIL(qPrintable(QStringLiteral("rebooted at exchange %1").arg(exchange)));
        }
    }

    void whatASecondClientChangesIsShown()
    {
        WebFixture bench;
        QVERIFY(bench.connectByWeb());
        QVERIFY(writeTable(bench));
        bench->setup().setPersistency(Persistency::Persistent);
        const auto other = bench.secondClient();
        const std::vector<RegisterWrite> activation{
            {"Axes[0]/Commands/Compensations/Axis/Activation", std::string("AddToEncoders")}};
        VERIFY_RESULT(other->writeRegisters(activation, {}));
        bench.drive().milliseconds += 60'000; // its ramp
        QVERIFY(bench.readLive());
        QCOMPARE(bench->status()->axis.stateWord, "Active");
        QCOMPARE(bench->hint(), QStringLiteral("The compensation is active: deactivate it first."));
        QVERIFY(bench->setup().isDirty(Field::Persistency));
        QVERIFY(std::ranges::any_of(bench->log(), [](const LogLine& line) {
            return line.text() == QStringLiteral("Compensation: Active.");
        }));
    }

    void aWriteStopsBeforeItOverwritesWhatASecondClientHasChanged()
    {
        WebFixture bench;
        QVERIFY(bench.connectByWeb());
        QVERIFY(planNewTable(bench));
        const std::string slot = bench.drive().text(tableX);
        const auto other = bench.secondClient();
        const std::vector<std::string> variable{"Application/Variables/Floats[7]"};
        const auto readings = other->readRegisters(variable, {});
        VERIFY_RESULT(readings);
        const std::vector<RegisterWrite> source{{base + "Dim1Source", readings->front().address}};
        VERIFY_RESULT(other->writeRegisters(source, {}));

        bench->write();
        QVERIFY(bench.idle());
        QVERIFY(bench->isOutcomeAnError());
        // Both values: the one that was planned for, and the one that is there now.
        const QString said = bench->outcome();
        QVERIFY2(said.contains(QString::fromStdString(test::masterX)), qPrintable(said));
        QVERIFY2(said.contains(QString::fromStdString(variable[0])), qPrintable(said));
        QCOMPARE(bench.drive().text(tableX), slot);
        QCOMPARE(bench->setup().baseline().sources[0].path, variable[0]);
        // What the user had not changed follows the drive, what had been changed stays.
        QCOMPARE(bench->setup().edited().sources[0].path, variable[0]);
        QVERIFY(bench->setup().isDirty(Field::Table));
    }

private:
    static void loseAt(int exchange, const Operation& operation)
    {
        WebFixture bench;
        QVERIFY(isReady(bench, operation));
        const EditedSetup edited = bench->setup().edited();
        bench.drive().gate.callAt(exchange, [&bench] { bench.switchOff(); });
        operation.begin(bench);
        QVERIFY(bench.idle());
        QTRY_VERIFY(!bench.isConnected());
        // That a write has succeeded is not said any more: who knows what the drive holds now.
        QVERIFY(!bench->outcome().isEmpty() || !bench->setup().isDirty());
        QCOMPARE(bench->hint(), QStringLiteral("The drive is not connected."));
        if (bench->isOutcomeAnError())
            QVERIFY(bench->setup().edited() == edited);

        bench.switchOn();
        QVERIFY(bench.connectedAgain());
        checkTheDriveIsShown(bench);
        // The file's table is unwritten, unless the drive had taken it before the connection went.
        if (bench->setup().edited().table.fileTable) {
            const auto crc =
                elementCrc(*bench->selectedTable(), drivecomm::genericProfile().layout);
            VERIFY_RESULT(crc);
            QCOMPARE(
                bench->setup().isDirty(Field::Table), bench->setup().baseline().tableCrc != *crc);
        }
    }

    static void rebootAt(int exchange, const Operation& operation)
    {
        WebFixture bench;
        QVERIFY(isReady(bench, operation));
        bench.drive().gate.callAt(exchange, [&bench] { bench.drive().drive.reboot(); });
        operation.begin(bench);
        QVERIFY(bench.idle());
        QVERIFY(!bench->outcome().isEmpty());
        QVERIFY(bench.connectedAgain());
        checkTheDriveIsShown(bench);
    }

    static void checkTheDriveIsShown(WebFixture& bench)
    {
        QVERIFY(bench.readLive());
        const CompensationSetup& shown = bench->setup().baseline();
        QCOMPARE(QString::fromStdString(bench.drive().text(tableX)),
            QString::fromStdString(shown.slot.empty() ? "Disabled" : shown.slot));
        for (int n = 1; n <= 3; ++n)
            QCOMPARE(bench.drive().text(base + "Dim" + std::to_string(n) + "Source"),
                std::to_string(shown.sources[static_cast<std::size_t>(n - 1)].address));
        QCOMPARE(bench->status()->axis.stateWord,
            bench.drive().text("Axes[0]/Signals/Compensations/Axis/State"));
    }
};

AXISCOMP_TEST(TestWizardWeb)

} // namespace tst_wizardweb

#include "tst_wizardweb.moc"
