// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compensator/configuration_transfer.h"
#include "tests/support/compensator_fixture.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <algorithm>

namespace tst_configurationtransfer {

using namespace axiscomp;
using namespace axiscomp::test;

namespace {

/// Two axes with tables, and their parameters; then both axes have none.
struct Fixture : CompensatorFixture {
    explicit Fixture(Persistency persistency = Persistency::Persistent)
    {
        for (const int axis : {0, 1}) {
            QVERIFY(compensator.write(axis, exampleRequest(axis + 1, persistency)).has_value());
            old.push_back(state(axis));
        }
        parameters = driveParameters(compensator, storeRoot()).value_or(CompensationParameters{});
        WriteRequest none;
        none.withoutTable = true;
        none.sources = {"", "", ""};
        none.dimensionality = 3;
        for (const int axis : {0, 1})
            QVERIFY(compensator.write(axis, none).has_value());
        link.forgetChange();
    }
    [[nodiscard]] Result<std::vector<AxisWrite>> writes()
    {
        return parameterWrites(compensator, drivecomm::genericProfile(), parameters);
    }

    std::vector<State> old;
    CompensationParameters parameters;
};

/// The plan of giving axis 0, which keeps its table, another first source.
Result<WritePlan> planWithSource(CompensatorFixture& drive, const std::string& path)
{
    AXISCOMP_TRY(auto parameters, driveParameters(drive.compensator, drive.storeRoot()));
    AXISCOMP_TRY(const auto source, drive.compensator.resolveSource(path));
    parameters.axes[0].sources[0] = source.address;
    AXISCOMP_TRY(const auto writes,
        parameterWrites(drive.compensator, drivecomm::genericProfile(), parameters));
    AXISCOMP_TRY(const auto plans, planMultiAxis(drive.compensator, writes));
    return plans.front();
}

bool warnsOf(const Result<WritePlan>& plan, std::string_view words)
{
    return plan && std::ranges::any_of(plan->warnings, [&](const Text& warning) {
        return warning.english().find(words) != std::string::npos;
    });
}

TamStation station(const CompensationParameters& parameters)
{
    TamStation made;
    made.serialNumber = parameters.serialNumber;
    for (const AxisParameters& axis : parameters.axes) {
        const std::string base =
            "Axes[" + std::to_string(axis.axis) + "]/Parameters/Compensations/Axis/";
        made.registers.push_back({base + "Table", "SourceTable", axis.slot});
        for (std::size_t n = 0; n < axis.sources.size(); ++n)
            made.registers.push_back({base + "Dim" + std::to_string(n + 1) + "Source", "UInt32",
                std::to_string(axis.sources[n])});
    }
    return made;
}

} // namespace

class TestConfigurationTransfer : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void theDriveGetsBackWhatWasTakenFromIt_data()
    {
        QTest::addColumn<bool>("persistent");
        QTest::newRow("persistent") << true;
        QTest::newRow("volatile") << false;
    }
    void theDriveGetsBackWhatWasTakenFromIt()
    {
        QFETCH(bool, persistent);
        Fixture c(persistent ? Persistency::Persistent : Persistency::Volatile);
        QCOMPARE(c.parameters.axes.size(), 2U);
        QCOMPARE(c.parameters.serialNumber.value(), 4711);
        const std::uint64_t spent = c.store.flashHistory(4711)->total;
        const auto writes = c.writes();
        VERIFY_RESULT(writes);
        QCOMPARE(writes->size(), 2U);
        QCOMPARE(c.link.firstChange(), 0);
        const auto plans = planMultiAxis(c.compensator, *writes);
        VERIFY_RESULT(plans);
        for (const WritePlan& plan : *plans) {
            QCOMPARE(plan.flashOperations, 0);
            for (const Text& warning : plan.warnings)
                QVERIFY2(warning.english().find("overwritten") == std::string::npos,
                    warning.english().c_str());
        }
        for (const AxisWrite& write : *writes)
            VERIFY_RESULT(c.compensator.write(write.axis, write.request));
        QCOMPARE(c.store.flashHistory(4711)->total, spent);
        for (const int axis : {0, 1}) {
            QVERIFY(c.state(axis) == c.old[static_cast<std::size_t>(axis)]);
            const std::string base = "Axes[" + std::to_string(axis) + "]/";
            QCOMPARE(
                c.text(base + "Commands/Compensations/Axis/Activation"), std::string("Disabled"));
        }
        if (persistent) {
            c.drive.reboot();
            QVERIFY(c.state(1) == c.old[1]);
        }
        const auto again = c.writes();
        VERIFY_RESULT(again);
        QVERIFY(again->empty());
    }

    void aTableThatIsNotThereIsSaid()
    {
        Fixture c;
        c.parameters.axes[1].slot = "Small7";
        const auto writes = c.writes();
        VERIFY_ERROR(writes, ErrorCode::NoTable);
        QCOMPARE(sentence(writes.error()),
            std::string("the configuration names the table in Small7 for axis 1, but the drive has "
                        "none there: write the table to the axis from its file and name the slot "
                        "that it gets in the configuration, or write it into Small7 with 'axiscomp "
                        "write --slot Small7'"));
        QCOMPARE(c.link.firstChange(), 0);
    }

    /// A configuration states no target, so the way out is a write.
    void aTableThatIsNamedAsThatOfAnotherAxisIsRefused()
    {
        CompensatorFixture c;
        WriteRequest request = exampleRequest();
        request.table->name = "Y error";
        request.table->target = "#1";
        VERIFY_RESULT(c.compensator.write(0, request));
        auto parameters = driveParameters(c.compensator, c.storeRoot());
        VERIFY_RESULT(parameters);
        std::swap(parameters->axes[0].sources[0], parameters->axes[0].sources[1]);
        c.link.forgetChange();
        const auto writes =
            parameterWrites(c.compensator, drivecomm::genericProfile(), *parameters);
        VERIFY_RESULT(writes);
        const auto refused = planMultiAxis(c.compensator, *writes);
        VERIFY_ERROR(refused, ErrorCode::TargetMismatch);
        QCOMPARE(sentence(refused.error()),
            std::string(
                "the name of the table, Y error, says that its values correct Y, but for axis 0 "
                "the name on the drive is X; choose another table or axis, or, if it is right all "
                "the same, write the table to this axis from its file first, and state the target "
                "as #2 there"));
        QCOMPARE(c.link.firstChange(), 0);
    }

    /// As a write that names no table.
    void aTableThatStaysIsHeldToItsNewSource()
    {
        CompensatorFixture c;
        WriteRequest request = exampleRequest();
        request.dimensionality = 1;
        request.sources = {masterX};
        request.table = exampleTable(1);
        VERIFY_RESULT(c.compensator.write(0, request));
        QVERIFY(warnsOf(planWithSource(c, "Axes[0]/Signals/PathPlanner/Position"),
            "on the other side of the compensation"));
        QVERIFY(warnsOf(planWithSource(c, masterY), "is a position of another axis"));
        const auto same =
            planWithSource(c, "Axes[0]/Signals/PositionController/Encoders[0]/Position");
        VERIFY_RESULT(same);
        QVERIFY(!warnsOf(same, "The table stays"));
        c.set("Axes[1]/Parameters/PositionController/PositionUnit", std::string("Degree"));
        VERIFY_ERROR(planWithSource(c, masterY), ErrorCode::UnitMismatch);
    }

    /// The axis that has the table would lose it before the other one has it.
    void aTableIsNotMovedToAnotherAxis()
    {
        CompensatorFixture c;
        VERIFY_RESULT(c.compensator.write(0, exampleRequest()));
        const auto parameters = driveParameters(c.compensator, c.storeRoot());
        VERIFY_RESULT(parameters);
        CompensationParameters moved = *parameters;
        std::swap(moved.axes[0].slot, moved.axes[1].slot);
        std::swap(moved.axes[0].sources, moved.axes[1].sources);
        const auto plans = [&]() -> Result<std::vector<WritePlan>> {
            AXISCOMP_TRY(const auto writes,
                parameterWrites(c.compensator, drivecomm::genericProfile(), moved));
            return planMultiAxis(c.compensator, writes);
        };
        const auto refused = plans();
        VERIFY_ERROR(refused, ErrorCode::SlotInUse);
        QCOMPARE(sentence(refused.error()),
            "slot Small1 is in use by axis 0, and an import does not move a table from one axis to "
            "another: write the table to axis 1 from its file, and name the slot that it gets "
            "there "
            "in the configuration");
        const auto report = c.compensator.write(1, exampleRequest());
        VERIFY_RESULT(report);
        moved.axes[1].slot = report->now.setup.slot;
        const auto possible = plans();
        VERIFY_RESULT(possible);
        QCOMPARE(possible->size(), 1U);
    }

    void anImportIsPlannedForItsOwnDrive()
    {
        Fixture c;
        TamConfiguration configuration{"machine.TAMcfg", {}, {station(c.parameters)}};
        const auto plan = [&](bool force) {
            return planImport(c.compensator, drivecomm::genericProfile(), configuration, 0, force);
        };
        const auto planned = plan(false);
        VERIFY_RESULT(planned);
        QCOMPARE(planned->tables.size(), 2U);
        QCOMPARE(planned->plans.size(), 2U);
        QCOMPARE(planned->plans[1].after.slot, c.parameters.axes[1].slot);
        configuration.stations[0].serialNumber = 7;
        VERIFY_ERROR(plan(false), ErrorCode::OtherDrive);
        VERIFY_RESULT(plan(true));
        configuration.stations[0].serialNumber.reset();
        VERIFY_RESULT(plan(false));
        QCOMPARE(c.link.firstChange(), 0);
    }

    void whatDoesNotFitTheAxisIsRefused()
    {
        Fixture c;
        CompensationParameters good = c.parameters;
        c.parameters.axes[0].unit = "Degree";
        VERIFY_ERROR(c.writes(), ErrorCode::InvalidArgument);
        c.parameters = good;
        c.parameters.axes[0].sources[1] = 0;
        VERIFY_ERROR(c.writes(), ErrorCode::SourceMissing);
        c.parameters = good;
        c.parameters.axes[0].sources[1] = 3; // no register has this address
        const auto writes = c.writes();
        VERIFY_RESULT(writes);
        VERIFY_ERROR(planMultiAxis(c.compensator, *writes), ErrorCode::SourceNotFound);
        c.parameters = good;
        c.parameters.axes[0].axis = 2;
        VERIFY_ERROR(c.writes(), ErrorCode::AxisNotFound);
        QCOMPARE(c.link.firstChange(), 0);
    }

    void anAxisWhoseCompensationIsOnIsLeftAlone()
    {
        Fixture c;
        const auto writes = c.writes();
        VERIFY_RESULT(c.compensator.write(0, writes->front().request));
        c.set("Axes[0]/Commands/Compensations/Axis/Activation", std::string("AddToEncoders"));
        c.parameters.axes[0].slot.clear();
        const auto off = c.writes();
        VERIFY_RESULT(off);
        VERIFY_ERROR(planMultiAxis(c.compensator, *off), ErrorCode::CompensationActive);
    }

    void anInterruptionLeavesTheOldOrTheNewState()
    {
        Fixture whole;
        const auto wholeWrites = whole.writes();
        const CompensatorFixture::State before = whole.state();
        const int begin = whole.link.exchanges();
        VERIFY_RESULT(whole.compensator.write(0, wholeWrites->front().request));
        const int exchanges = whole.link.exchanges() - begin;
        for (int exchange = 1; exchange <= exchanges; ++exchange) {
            Fixture c;
            const auto writes = c.writes();
            c.link.failAt(exchange, LinkFault::DriveGone);
            const auto written = c.compensator.write(0, writes->front().request);
            c.link.heal();
            const QByteArray where = "exchange " + QByteArray::number(exchange);
            const CompensatorFixture::State now = c.state();
            QVERIFY2(now == before || now == c.old[0], where);
            QVERIFY2(!written || now == c.old[0], where);
            if (const auto entry = c.store.journal(4711, 0).value()) {
                VERIFY_RESULT(c.compensator.finishUnfinished(*entry));
                QVERIFY2(c.state() == c.old[0], where);
            }
        }
    }
};

AXISCOMP_TEST(TestConfigurationTransfer)

} // namespace tst_configurationtransfer

#include "tst_configurationtransfer.moc"
