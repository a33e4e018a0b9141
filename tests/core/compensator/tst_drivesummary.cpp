// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compensator/drive_summary.h"
#include "tests/support/compensator_fixture.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

namespace tst_drivesummary {

using namespace axiscomp;
using test::CompensatorFixture;
using test::exampleRequest;

namespace {

std::filesystem::path root(const CompensatorFixture& fixture)
{
    return std::filesystem::path(fixture.folder.path().toStdString()) / "axiscomp";
}

} // namespace

class TestDriveSummary : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void eachAxisHasItsOwnTableAndLastWrite()
    {
        CompensatorFixture fixture;
        VERIFY_RESULT(fixture.compensator.write(1, exampleRequest(2, Persistency::Persistent)));
        const auto before = fixture.state(1);
        const auto summary = summarizeDrive(fixture.compensator, root(fixture), {});
        VERIFY_RESULT(summary);
        QVERIFY(fixture.state(1) == before);
        QCOMPARE(summary->axes.size(), std::size_t(2));
        const AxisSummary& untouched = summary->axes[0];
        QVERIFY(untouched.status && !untouched.status->table && !untouched.lastWrite);
        const AxisSummary& written = summary->axes[1];
        QCOMPARE(written.axis.index, 1);
        QVERIFY(written.status && written.status->table && written.status->table->persistent);
        QVERIFY(written.lastWrite.has_value());
        QVERIFY(!written.problem);
        QVERIFY(summary->flashUse.has_value());
        const int limit = drivecomm::genericProfile().flashWear.operations;
        QVERIFY(summary->flashUse->budget.left < limit);
    }

    /// A table is worth what was measured only where it is looked up as it was then.
    void aTableThatIsLookedUpElsewhereIsNotSaidToBeWorthWhatWasMeasured()
    {
        CompensatorFixture fixture;
        VERIFY_RESULT(fixture.compensator.write(0, exampleRequest()));
        const auto status = fixture.compensator.status(0);
        VERIFY_RESULT(status);
        MeasuredFigures figures{status->table->crc, {}, "", false, {{"A", 0.013, {}, 0.003}}};
        figures.madeFor = {LookupAt::Encoder, {"#1"}};
        VERIFY_RESULT(fixture.store.recordMeasured(4711, 0, figures));
        const auto measured = [&fixture] {
            const auto summary = summarizeDrive(fixture.compensator, root(fixture), {});
            return summary ? summary->axes[0].measured : std::nullopt;
        };
        QVERIFY(measured() == figures);
        WriteRequest swapped = exampleRequest();
        swapped.sources = {test::masterY, test::masterX};
        VERIFY_RESULT(fixture.compensator.write(0, swapped));
        QVERIFY(!measured());
        VERIFY_RESULT(fixture.compensator.write(0, exampleRequest()));
        QVERIFY(measured() == figures);
        AxisStatus other = *status;
        other.setup.sources[0].path = "Axes[0]/Signals/PathPlanner/Position";
        const DriveProfile& profile = drivecomm::genericProfile();
        QVERIFY(measuredWith(*status, profile, root(fixture)));
        QVERIFY(!measuredWith(other, profile, root(fixture)));
    }

    void aTableInAnotherUnitIsNotSaidToBeWorthWhatWasMeasured()
    {
        CompensatorFixture fixture;
        VERIFY_RESULT(fixture.compensator.write(0, exampleRequest()));
        const auto status = fixture.compensator.status(0);
        VERIFY_RESULT(status);
        QVERIFY(unitsOfTable(*status) == (TableUnits{"Millimeter", {"Millimeter", "Millimeter"}}));
        MeasuredFigures figures{status->table->crc, {}, "", false, {{"A", 0.013, {}, 0.003}}};
        figures.units = unitsOfTable(*status);
        figures.axisName = "X";
        VERIFY_RESULT(fixture.store.recordMeasured(4711, 0, figures));
        const auto measured = [&fixture] {
            const auto summary = summarizeDrive(fixture.compensator, root(fixture), {});
            return summary ? summary->axes[0].measured : std::nullopt;
        };
        QVERIFY(measured() == figures);
        const std::string unit = "]/Parameters/PositionController/PositionUnit";
        fixture.set("Axes[0" + unit, std::string("Meter"));
        QVERIFY(!measured());
        fixture.set("Axes[0" + unit, std::string("Millimeter"));
        fixture.set("Axes[1" + unit, std::string("Degree")); // of a source
        QVERIFY(!measured());
        fixture.set("Axes[1" + unit, std::string("Millimeter"));
        QVERIFY(measured() == figures);
        figures.axisName = "Z";
        VERIFY_RESULT(fixture.store.recordMeasured(4711, 0, figures));
        QVERIFY(!measured());
    }

    void aDriveThatDoesNotAnswerHasNoSummary()
    {
        CompensatorFixture fixture;
        fixture.link.failAt(3, test::LinkFault::RequestLost);
        const auto summary = summarizeDrive(fixture.compensator, root(fixture), {});
        QVERIFY(!summary && isLinkFailure(summary.error().code));
    }

    void aStopEndsIt()
    {
        CompensatorFixture fixture;
        std::stop_source stop;
        stop.request_stop();
        OperationOptions options;
        options.stop = stop.get_token();
        VERIFY_ERROR(
            summarizeDrive(fixture.compensator, root(fixture), options), ErrorCode::Cancelled);
    }
};

AXISCOMP_TEST(TestDriveSummary)

} // namespace tst_drivesummary

#include "tst_drivesummary.moc"
