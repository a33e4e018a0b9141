// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"
#include "tests/ui/support/controller_fixture.h"

#include <QTest>

#include <functional>
#include <random>

namespace tst_wizardwalk {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::ControllerFixture;
using test::DriveGate;

namespace {

/// What a user, the drive and other people do, in random order.
class Walk {
public:
    explicit Walk(ControllerFixture& bench, unsigned seed)
        : m_bench(bench)
        , m_random(seed)
        , m_files{bench.file(QStringLiteral("good.csv"), ControllerFixture::calibration2D(1)),
              bench.file(QStringLiteral("other.csv"), ControllerFixture::calibration2D(2)),
              bench.file(QStringLiteral("bad.csv"), "X,table\n1,one\n2,2\n"),
              bench.path(QStringLiteral("missing.csv"))}
    {
    }

    void step()
    {
        const int kind = below(46);
        if (kind >= 40)
            meanIt();
        else if (kind < 26)
            edit(kind % 13);
        else if (kind < 37)
            operate(kind);
        else
            disturb();
        QCoreApplication::processEvents();
    }
    /// Until what runs has ended and the drive is there.
    [[nodiscard]] bool settle()
    {
        m_bench.drive().gate.set(DriveGate::Mode::Open);
        const auto isConnected = [this] {
            return m_bench->drives().front().connection == DriveState::Connection::Connected;
        };
        const bool isSettled = QTest::qWaitFor(
            [&] {
                return !m_bench->busy().isBusy && !m_bench->dataFile().isReading && isConnected();
            },
            test::patienceMs);
        if (!isSettled)
            qInfo("busy: %s; reading: %d; connected: %d; %s", qPrintable(m_bench->busy().step),
                m_bench->dataFile().isReading, isConnected(), qPrintable(m_bench->hint()));
        return isSettled;
    }
    [[nodiscard]] int below(int n)
    {
        return static_cast<int>(m_random() % static_cast<unsigned>(n));
    }

private:
    void edit(int kind)
    {
        SetupModel& setup = m_bench->setup();
        const std::array sources{test::masterX, test::masterY,
            std::string("Axes[0]/Signals/General/MotorTemperature"), std::string(),
            std::string("Axes[0]/Nothing")};
        switch (kind) {
        case 0:
        case 1:
            return setup.setDimensionality(below(4) ? 2 : 1 + below(3));
        case 2:
            return m_bench->chooseSource(1, QString::fromStdString(test::masterX));
        case 3:
            return m_bench->chooseSource(2, QString::fromStdString(test::masterY));
        case 4:
            return m_bench->chooseSource(
                1 + below(3), QString::fromStdString(sources[static_cast<std::size_t>(below(5))]));
        case 5:
        case 6:
            return setup.setTable(
                m_bench->dataFile().data && below(3) ? TableChoice{below(2)} : TableChoice{});
        case 7:
            return setup.setPersistency(below(4) ? Persistency::Volatile : Persistency::Persistent);
        case 8:
            return below(3) ? void() : setup.revert();
        case 9:
            return setup.revert(allFields[static_cast<std::size_t>(below(6))]);
        case 10:
        case 11:
            return below(3) ? void()
                            : m_bench->openData(
                                m_files[static_cast<std::size_t>(below(4) ? below(2) : below(4))]);
        default:
            return below(6) ? void() : m_bench->closeData();
        }
    }

    /// What people do most of the time: one thing after the other, towards an active compensation.
    void meanIt()
    {
        if (m_bench->action(Action::Write).isEnabled) {
            m_bench->planWrite();
            (void)m_bench.idle();
            return m_bench->write();
        }
        if (m_bench->action(Action::Activate).isEnabled)
            return m_bench->activate();
        if (m_bench->action(Action::Deactivate).isEnabled)
            return m_bench->deactivate();
        m_bench.chooseMasterSources();
        if (!m_bench->dataFile().data && !m_bench->dataFile().isReading)
            return m_bench->openData(m_files[0]);
        if (m_bench->dataFile().data)
            m_bench->setup().setTable({below(2)});
    }

    void operate(int kind)
    {
        if (below(6) != 0)
            return m_bench->refreshLive();
        switch (kind) {
        case 26:
        case 27:
        case 28:
            return m_bench->plan() ? m_bench->write() : m_bench->planWrite();
        case 29:
            return m_bench->activate();
        case 30:
            return m_bench->evaluate();
        case 31:
        case 32:
        case 33:
            return m_bench->deactivate();
        case 34:
            return below(4) ? void() : m_bench->planRestoration();
        case 35:
            return m_bench->refresh();
        default:
            return below(4) ? void() : m_bench->cancel();
        }
    }

    /// The drive comes and goes, and other people use it too.
    void disturb()
    {
        switch (below(12)) {
        case 0:
            return m_bench.drive().gate.set(DriveGate::Mode::Gone);
        case 1: {
            const auto reading = m_bench.drive().drive.readRegisters({test::masterY});
            // Refused while the compensation is active, as it should be.
            (void)m_bench.drive().drive.writeRegisters(
                {{"Axes[0]/Parameters/Compensations/Axis/Dim1Source", reading->front().address}});
            return;
        }
        case 2:
            if (below(8) == 0)
                m_bench.drive().drive.reboot();
            return;
        case 3:
            (void)m_bench.drive().drive.writeRegisters(
                {{"Axes[0]/Commands/Homing/Command", std::string("Start")}});
            m_bench.drive().milliseconds += 2'000;
            return;
        default:
            return m_bench.drive().gate.set(DriveGate::Mode::Open);
        }
    }

    ControllerFixture& m_bench;
    std::mt19937 m_random;
    std::vector<QString> m_files;
};

bool hasAxis(const WizardController& c)
{
    return c.currentAxis() >= 0 && c.axes()[static_cast<std::size_t>(c.currentAxis())].isUsable
        && c.status().has_value() && !c.busy().isBusy;
}

bool isActive(const WizardController& c)
{
    return c.status()->axis.stateWord == "Active" || c.status()->axis.stateWord == "Ramping";
}

/// Table and sources, from what the controller shows to everybody.
bool fits(const WizardController& c)
{
    const EditedSetup& edited = c.setup().edited();
    int dimensions = 0;
    if (edited.table.fileTable) {
        if (!c.selectedTable())
            return false;
        dimensions = c.selectedTable()->grid.dimensions();
    } else if (c.status()->table) {
        dimensions = c.status()->table->grid.dimensions();
    }
    if (dimensions != edited.dimensionality)
        return false;
    for (int n = 1; n <= edited.dimensionality; ++n) {
        const DimSource& source = edited.sources[static_cast<std::size_t>(n - 1)];
        if (!source.isSet() || c.isSourceBeingChecked(n))
            return false;
        for (int other = 1; other < n; ++other) {
            if (edited.sources[static_cast<std::size_t>(other - 1)] == source)
                return false;
        }
    }
    return true;
}

/// A write that was interrupted before its parameters were saved; writing once more saves them.
bool isUnsaved(const WizardController& c)
{
    return c.unfinishedWrite().contains(QStringLiteral("its parameters may not be saved"));
}

bool mayWrite(const WizardController& c)
{
    if (!hasAxis(c) || isActive(c) || c.dataFile().isReading || !fits(c)
        || !(c.setup().isDirty() || isUnsaved(c)))
        return false;
    const bool isPersistent = c.setup().edited().persistency == Persistency::Persistent;
    const bool isNewTable = c.setup().edited().table.fileTable && c.setup().isDirty(Field::Table);
    const bool costsFlash = isNewTable ? isPersistent : c.setup().isDirty(Field::Persistency);
    return !costsFlash || c.flashOperationsLeft() > 0;
}

bool mayActivate(const WizardController& c)
{
    return hasAxis(c) && !isActive(c) && !c.setup().isDirty() && c.status()->table && fits(c)
        && c.status()->axis.homingWord == "HomingDone";
}

/// What the rules are about, for a failure.
QString told(const WizardController& c)
{
    return QStringLiteral("axis %1, busy \"%2\", state %3, changed %4, reading %5, fits %6, "
                          "table of the drive %7, flash left %8; Write: %9")
        .arg(c.currentAxis())
        .arg(c.busy().step)
        .arg(c.status() ? QString::fromStdString(c.status()->axis.stateWord)
                        : QStringLiteral("unknown"))
        .arg(c.setup().isDirty())
        .arg(c.dataFile().isReading)
        .arg(c.status() && fits(c))
        .arg(c.status() && c.status()->table)
        .arg(c.flashOperationsLeft())
        .arg(c.action(Action::Write).reason);
}

} // namespace

class TestWizardWalk : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theRulesHoldWhateverIsDone()
    {
        ControllerFixture bench;
        QVERIFY(bench.connect());
        Walk walk(bench, 20261121);
        int written = 0;
        int activated = 0;
        QObject::connect(
            &bench.controller(), &WizardController::outcomeChanged, &bench.controller(), [&] {
                written += bench->outcome().startsWith(QStringLiteral("Written and verified"));
                activated += bench->outcome().contains(QStringLiteral("active. Proved"));
            });
        for (int step = 0; step < 10'000; ++step) {
            walk.step();
            if (step % 100 == 99)
                QVERIFY(walk.settle());
            check(bench.controller());
            if (QTest::currentTestFailed()) {
                qInfo("at step %d: %s", step, qPrintable(told(bench.controller())));
                return;
            }
        }
        qInfo("%d writes and %d activations on the way", written, activated);
        QVERIFY(written > 10);
        QVERIFY(activated > 5);
    }

private:
    static void check(const WizardController& c)
    {
        QCOMPARE(c.action(Action::Write).isEnabled, mayWrite(c));
        QCOMPARE(c.action(Action::Activate).isEnabled, mayActivate(c));
        for (const Action action : allActions)
            QVERIFY(!c.action(action).reason.isEmpty());
        QVERIFY(!c.hint().isEmpty());
        QCOMPARE(c.busy().isBusy, !c.busy().step.isEmpty());
        QVERIFY(!c.isWriting() || c.busy().isBusy);
        // What is chosen exists.
        const auto chosen = c.setup().edited().table.fileTable;
        if (chosen)
            QVERIFY(c.dataFile().data);
        else
            QCOMPARE(c.selectedTable(), c.driveTable());
    }
};

AXISCOMP_TEST(TestWizardWalk)

} // namespace tst_wizardwalk

#include "tst_wizardwalk.moc"
