// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compensator/known_tables.h"
#include "core/io/local_file.h"
#include "tests/support/compensator_fixture.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

namespace tst_knowntables {

using namespace axiscomp;
using test::CompensatorFixture;
using test::exampleRequest;
using test::exampleTable;
using test::masterX;
using test::masterY;

namespace {

const std::string plannerX = "Axes[0]/Signals/PathPlanner/Position";
const std::string temperature = "Axes[0]/Signals/General/MotorTemperature";

/// Axis 0 had a table, which its newest backup holds, and has another one. In millimetres.
struct Replaced : CompensatorFixture {
    explicit Replaced(const WriteRequest& first = exampleRequest(1))
    {
        QVERIFY(compensator.write(0, first).has_value());
        WriteRequest second = first;
        second.table = exampleTable(2, 2);
        QVERIFY(compensator.write(0, second).has_value());
    }

    void setUnit(const std::string& unit)
    {
        set("Axes[0]/Parameters/PositionController/PositionUnit", unit);
    }

    template <typename Change> void changeBackup(const Change& change)
    {
        const std::filesystem::path file = store.backups(4711, 0).front();
        const auto text = loadFile(file, maximumBackupSize);
        QVERIFY(text.has_value());
        auto backup = readBackup(asText(*text), file.string());
        QVERIFY(backup.has_value());
        change(backup->axes.front());
        QVERIFY(saveFile(file, asBytes(writeBackup(*backup))).has_value());
    }

    [[nodiscard]] Result<AxisTables> tables()
    {
        AXISCOMP_TRY(const auto status, compensator.status(0));
        AXISCOMP_TRY(auto table, compensator.readDescribedTable(0));
        return tablesOfAxis(axisOfDrive(status, compensator.profile()), std::move(table),
            compensator.profile(), store, "mm");
    }
    /// The table of the newest backup.
    [[nodiscard]] Result<CompensationTable> kept()
    {
        AXISCOMP_TRY(const auto all, tables());
        return all.backups.at(0).tables.at(0);
    }
    [[nodiscard]] bool hadOtherSources()
    {
        const auto all = tables();
        return all && all->backups.at(0).hadOtherSources;
    }
};

bool isNear(double a, double b)
{
    return std::abs(a - b) <= 2e-7 * std::abs(b);
}

} // namespace

class TestKnownTables : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aTableOfABackupIsInTheUnitsWithWhichItWasKept()
    {
        for (const char* unit : {"Millimeter", "Meter"}) {
            Replaced c;
            c.setUnit(unit);
            const auto kept = c.kept();
            VERIFY_RESULT(kept);
            QVERIFY2(kept->values == exampleTable(2, 1).values, unit);
            QVERIFY2(isNear(kept->grid.axes[0].distance, 10.0), unit);
            QVERIFY2(isNear(kept->grid.axes[1].distance, 11.0), unit);
        }
    }

    /// Older versions did not note the units.
    void aBackupThatDoesNotSayItsUnitIsInThatOfTheAxis()
    {
        Replaced c;
        c.changeBackup([](AxisBackup& backup) {
            backup.unit.clear();
            backup.sourceUnits.clear();
        });
        c.setUnit("Meter");
        const auto kept = c.kept();
        VERIFY_RESULT(kept);
        QVERIFY(isNear(kept->values.at(0), 1e3 * exampleTable(2, 1).values.at(0)));
        QVERIFY(isNear(kept->grid.axes[0].distance, 1e4));
    }

    void temperaturesAreNotConvertedWithTheUnitOfTheAxis()
    {
        WriteRequest request = exampleRequest(1);
        request.sources[1] = temperature;
        Replaced c(request);
        c.setUnit("Meter");
        const auto all = c.tables();
        VERIFY_RESULT(all);
        for (const KnownTables* known : {&all->active, &all->backups.at(0)}) {
            const GridAxis& axis = known->tables.at(0).grid.axes[1];
            QCOMPARE(axis.distance, 11.0);
            QCOMPARE(axis.unit, std::string("degC"));
        }
        QVERIFY(isNear(all->active.tables.at(0).grid.axes[0].distance, 1e4));
    }

    /// A replaced drive, or another version of its firmware, may have others at these addresses.
    void theSourcesOfABackupAreToldByTheirPaths()
    {
        Replaced c;
        QVERIFY(!c.hadOtherSources());
        const auto planner = c.drive.readRegisters({plannerX});
        VERIFY_RESULT(planner);
        const std::uint32_t other = planner->front().address;
        c.changeBackup([&](AxisBackup& backup) { backup.registers.at(1).value = other; });
        QVERIFY2(!c.hadOtherSources(), "the paths are the same, whatever the addresses");
        c.changeBackup([](AxisBackup& backup) { backup.sourcePaths.clear(); });
        QVERIFY2(c.hadOtherSources(), "an older backup has the addresses alone");

        Replaced moved;
        moved.changeBackup([](AxisBackup& backup) { backup.sourcePaths = {plannerX, masterY}; });
        QVERIFY2(moved.hadOtherSources(), "another register at the same address is another source");
    }
};

AXISCOMP_TEST(TestKnownTables)

} // namespace tst_knowntables

#include "tst_knowntables.moc"
