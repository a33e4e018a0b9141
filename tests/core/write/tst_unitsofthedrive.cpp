// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compensator/table_of_axis.h"
#include "core/write/kept_backup.h"
#include "core/write/lookup_side.h"
#include "tests/support/compensator_fixture.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <algorithm>

namespace tst_unitsofthedrive {

using namespace axiscomp;
using test::CompensatorFixture;
using test::exampleRequest;
using test::masterX;

namespace {

/// Axis 0 is in millimetres, axis 1 in degrees.
struct LinearAndRotary : CompensatorFixture {
    LinearAndRotary()
    {
        set("Axes[1]/Parameters/PositionController/PositionUnit", std::string("Degree"));
    }
};

/// Whose tables have their elements the other way round.
DriveProfile transposing(const std::string& name)
{
    DriveProfile profile = drivecomm::genericProfile();
    profile.name = name;
    profile.layout.dimension1Fastest = false;
    return profile;
}

WriteRequest requestIn(const std::string& values, const std::string& x, const std::string& y)
{
    WriteRequest request = exampleRequest();
    request.table->unit = values;
    request.table->grid.axes[0].unit = x;
    request.table->grid.axes[1].unit = y;
    return request;
}

} // namespace

class TestUnitsOfTheDrive : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void valuesAreInTheUnitOfTheAxisAndPositionsInThoseOfTheSources()
    {
        LinearAndRotary f;
        WriteRequest request = requestIn("nm", "cm", "arcmin");
        for (float& value : request.table->values)
            value *= 1e6F;
        const auto report = f.compensator.write(0, request);
        VERIFY_RESULT(report);
        const auto held = f.compensator.readTable(0);
        VERIFY_RESULT(held);
        const CompensationTable millimetres = *exampleRequest().table;
        QCOMPARE(held->values.size(), millimetres.values.size());
        for (std::size_t i = 0; i < held->values.size(); ++i)
            QVERIFY(std::abs(held->values[i] - millimetres.values[i])
                <= 2e-7F * std::abs(millimetres.values[i]));
        QCOMPARE(held->grid.axes[0].distance, 100.0);
        QVERIFY(std::abs(held->grid.axes[1].distance - 11.0 / 60.0) < 1e-7);
        QCOMPARE(report->plan.unitRemarks.size(), std::size_t{3});
    }

    void valuesWithoutAUnitAreInThatOfTheAxisesOwnPositions()
    {
        LinearAndRotary f;
        WriteRequest request = requestIn("", "deg", "um");
        std::swap(request.sources[0], request.sources[1]);
        VERIFY_RESULT(f.compensator.write(0, request));
        const auto held = f.compensator.readTable(0);
        VERIFY_RESULT(held);
        const CompensationTable asked = *exampleRequest().table;
        for (std::size_t i = 0; i < held->values.size(); ++i)
            QVERIFY(std::abs(held->values[i] - 1e-3F * asked.values[i])
                <= 2e-10F * std::abs(asked.values[i]));

        // Of two lengths it is that of the own positions, too.
        CompensatorFixture lengths;
        WriteRequest both = requestIn("", "um", "mm");
        both.acceptsLarge = true;
        VERIFY_RESULT(lengths.compensator.write(0, both));
        const auto written = lengths.compensator.readTable(0);
        VERIFY_RESULT(written);
        QVERIFY(std::abs(written->values[1] - 1e-3F * asked.values[1])
            <= 2e-10F * std::abs(asked.values[1]));
    }

    void aTableThatWasReadFromOneAxisIsNotWrittenToAnother()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, exampleRequest()));
        const auto table = f.compensator.readDescribedTable(0);
        VERIFY_RESULT(table);
        QCOMPARE(table->grid.axes[0].name, std::string("X"));
        QCOMPARE(table->grid.axes[1].name, std::string("Y"));
        QCOMPARE(table->target, std::string("X"));
        WriteRequest request = exampleRequest();
        request.table = *table;
        VERIFY_RESULT(f.compensator.plan(0, request));
        std::swap(request.sources[0], request.sources[1]);
        VERIFY_ERROR(f.compensator.plan(1, request), ErrorCode::TargetMismatch);
    }

    void anAngleIsRefusedForALinearSource()
    {
        LinearAndRotary f;
        const auto before = f.state();
        VERIFY_ERROR(
            f.compensator.write(0, requestIn("mm", "deg", "deg")), ErrorCode::UnitMismatch);
        VERIFY_ERROR(f.compensator.write(0, requestIn("mm", "mm", "mm")), ErrorCode::UnitMismatch);
        VERIFY_ERROR(
            f.compensator.write(0, requestIn("deg", "mm", "deg")), ErrorCode::UnitMismatch);
        QVERIFY(f.state() == before);
        VERIFY_RESULT(f.compensator.write(0, requestIn("mm", "mm", "deg")));
    }

    void aSourceThatIsNoPositionTakesItsNumbersAsTheyAre()
    {
        LinearAndRotary f;
        WriteRequest request = requestIn("mm", "mm", "degC");
        request.sources[1] = "Axes[0]/Signals/General/MotorTemperature";
        const auto plan = f.compensator.plan(0, request);
        VERIFY_RESULT(plan);
        QVERIFY(plan->table);
        QCOMPARE(plan->table->grid.axes[1].distance, 11.0);
        QVERIFY(plan->unitRemarks.empty());
    }

    void ofASourceWhoseUnitNobodyKnowsTheUnitOfTheColumnIsSaid()
    {
        LinearAndRotary f;
        for (const char* unit : {"K", "degF"}) {
            WriteRequest request = requestIn("mm", "mm", unit);
            request.sources[1] = "Axes[0]/Signals/General/MotorTemperature";
            const auto plan = f.compensator.plan(0, request);
            VERIFY_RESULT(plan);
            QCOMPARE(plan->unitRemarks.size(), std::size_t{1});
            QCOMPARE(plan->unitRemarks.front().english(),
                std::string("The positions of dimension 2 are written in ") + unit
                    + " as they stand: the profile does not say the unit of "
                      "Axes[0]/Signals/General/MotorTemperature.");
        }
    }

    void aTableIsReadWithWhatTheDriveSaysOfIt()
    {
        LinearAndRotary f;
        VERIFY_RESULT(f.compensator.write(0, requestIn("mm", "mm", "deg")));
        const auto grid = f.compensator.readDescribedTable(0);
        VERIFY_RESULT(grid);
        QCOMPARE(grid->unit, std::string("mm"));
        QCOMPARE(grid->grid.axes[0].unit, std::string("mm"));
        QCOMPARE(grid->grid.axes[1].unit, std::string("deg"));
        QCOMPARE(grid->target, std::string("X"));
        QCOMPARE(lookupNotes(*f.compensator.status(0), drivecomm::genericProfile()),
            std::vector<std::string>{"lookup: encoder"});

        WriteRequest other = requestIn("deg", "mm", "mm");
        other.sources = {
            "Axes[0]/Signals/PathPlanner/Position", "Axes[0]/Signals/General/MotorTemperature"};
        other.table->grid.axes[1].unit.clear();
        VERIFY_RESULT(f.compensator.write(1, other));
        const auto cross = f.compensator.readDescribedTable(1);
        VERIFY_RESULT(cross);
        QCOMPARE(cross->unit, std::string("deg"));
        QCOMPARE(cross->grid.axes[0].unit, std::string("mm"));
        QCOMPARE(cross->grid.axes[1].unit, std::string());
        QCOMPARE(lookupNotes(*f.compensator.status(1), drivecomm::genericProfile()),
            std::vector<std::string>{"lookup: set"});
    }

    void theLookupOfATableIsThatOfTheAxisItself()
    {
        const DriveProfile& profile = drivecomm::genericProfile();
        const std::vector<std::string> sources{
            test::masterX, "Axes[1]/Signals/PathPlanner/Position"};
        QCOMPARE(lookupAtSources(profile, 0, sources), std::optional(LookupAt::Encoder));
        QCOMPARE(lookupAtSources(profile, 1, sources), std::optional(LookupAt::Set));
        QCOMPARE(lookupAtSources(profile, 2, sources), std::optional<LookupAt>());
        QCOMPARE(lookupAtSources(profile, 2, std::vector{test::masterX, test::masterY}),
            std::optional(LookupAt::Encoder));
        QCOMPARE(lookupAtSources(profile, 0, std::vector<std::string>{"Analog/Input"}),
            std::optional<LookupAt>());
    }

    void theLibraryRefusesLargeCorrectionsUntilTheyAreAccepted()
    {
        LinearAndRotary f;
        WriteRequest request = requestIn("mm", "mm", "deg");
        request.table->values[7] = 0.6F; // of 50 mm
        const auto plan = f.compensator.plan(0, request);
        VERIFY_RESULT(plan);
        QCOMPARE(plan->largeCorrections.size(), std::size_t{1});
        const auto before = f.state();
        VERIFY_ERROR(f.compensator.write(0, request), ErrorCode::LargeCorrection);
        QVERIFY(f.state() == before);
        request.acceptsLarge = true;
        VERIFY_RESULT(f.compensator.write(0, request));
        // What the drive has had comes back without a question.
        const auto after = f.state();
        const auto backup = f.compensator.backup();
        VERIFY_RESULT(backup);
        VERIFY_RESULT(f.compensator.write(0, exampleRequest()));
        VERIFY_RESULT(f.compensator.restore(*backup, false));
        QVERIFY(f.state().table == after.table);
    }

    /// Its numbers would be a thousand times too large, or too small.
    void aBackupIsNotRestoredWhereItsNumbersMeanSomethingElse_data()
    {
        QTest::addColumn<int>("axis");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<QString>("what");
        QTest::newRow("values") << 0 << QStringLiteral("Meter")
                                << QStringLiteral("values of axis 0");
        QTest::newRow("values of an axis without a unit")
            << 0 << QStringLiteral("None") << QStringLiteral("values of axis 0");
        QTest::newRow("positions of a source")
            << 1 << QStringLiteral("Radian")
            << QStringLiteral("positions of dimension 2 of axis 0");
        QTest::newRow("positions of a source without a unit")
            << 1 << QStringLiteral("None") << QStringLiteral("positions of dimension 2 of axis 0");
    }

    void aBackupIsNotRestoredWhereItsNumbersMeanSomethingElse()
    {
        QFETCH(int, axis);
        QFETCH(QString, unit);
        QFETCH(QString, what);
        LinearAndRotary f;
        VERIFY_RESULT(f.compensator.write(0, requestIn("mm", "mm", "deg")));
        const auto backup = f.compensator.backup();
        VERIFY_RESULT(backup);
        const auto report = f.compensator.write(0, exampleRequest(2));
        VERIFY_RESULT(report);
        const auto kept = axisBackupsIn(report->backup, drivecomm::genericProfile());
        VERIFY_RESULT(kept);
        f.set("Axes[" + std::to_string(axis) + "]/Parameters/PositionController/PositionUnit",
            unit.toStdString());
        const auto before = f.state();
        f.link.forgetChange();
        for (const bool force : {false, true}) {
            const auto refused = f.compensator.restore(*backup, force);
            VERIFY_ERROR(refused, ErrorCode::UnitMismatch);
            QCOMPARE(QString::fromStdString(refused.error().context.english("what")), what);
            VERIFY_ERROR(f.compensator.planRestore(*backup, force), ErrorCode::UnitMismatch);
            // What a write keeps, as the window restores it.
            VERIFY_ERROR(f.compensator.planRestore(kept->front(), force), ErrorCode::UnitMismatch);
        }
        QCOMPARE(f.link.firstChange(), 0);
        QVERIFY(f.state() == before);
    }

    /// Nobody converts what stays where it is.
    void aTableThatStaysGetsNoSourceInAnotherUnit()
    {
        LinearAndRotary f;
        WriteRequest request = requestIn("mm", "mm", "deg");
        VERIFY_RESULT(f.compensator.write(0, request));
        const auto before = f.state();
        f.link.forgetChange();
        request.table.reset();
        std::swap(request.sources[0], request.sources[1]);
        const auto refused = f.compensator.write(0, request);
        VERIFY_ERROR(refused, ErrorCode::UnitMismatch);
        QCOMPARE(QString::fromStdString(sentence(refused.error())),
            QStringLiteral("the positions of dimension 1 of the table on the drive are in mm, and "
                           "the new source is in deg; write the table from its file, together with "
                           "the source"));
        QCOMPARE(f.link.firstChange(), 0);
        QVERIFY(f.state() == before);

        request.sources = {"Axes[0]/Signals/PathPlanner/Position", test::masterY};
        VERIFY_RESULT(f.compensator.write(0, request)); // millimetres as well
    }

    /// The profile says no unit of a temperature: it is another thing than a position all the same.
    void aTableThatStaysGetsNoTemperatureForAPosition_data()
    {
        QTest::addColumn<std::string>("had");
        QTest::addColumn<std::string>("wanted");
        const std::string warmth = "Axes[0]/Signals/General/MotorTemperature";
        QTest::newRow("a temperature for a position") << masterX << warmth;
        QTest::newRow("a position for a temperature") << warmth << masterX;
    }
    void aTableThatStaysGetsNoTemperatureForAPosition()
    {
        QFETCH(std::string, had);
        QFETCH(std::string, wanted);
        CompensatorFixture f;
        WriteRequest request = exampleRequest();
        request.sources[0] = had;
        VERIFY_RESULT(f.compensator.write(0, request));
        request.table.reset();
        request.sources[0] = wanted;
        const auto refused = f.compensator.plan(0, request);
        VERIFY_ERROR(refused, ErrorCode::UnitMismatch);
        QCOMPARE(sentence(refused.error()),
            "dimension 1 of the table on the drive is one of " + had + ", and " + wanted
                + " is something else: one of them is a position, the other a temperature; write "
                  "the table from its file, together with the source");
    }

    void aTableThatStaysForARegisterOfWhichNothingIsKnownIsWarnedOf()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, exampleRequest()));
        WriteRequest request = exampleRequest();
        request.table.reset();
        request.sources[0] = "Application/Variables/Floats[0]";
        const auto plan = f.compensator.plan(0, request);
        VERIFY_RESULT(plan);
        QVERIFY(std::ranges::any_of(plan->warnings, [](const Text& warning) {
            return warning.english()
                == "The table stays, its dimension 1 has positions of an axis, and the profile "
                   "does not say what Application/Variables/Floats[0] is. Write the table that was "
                   "made "
                   "for this source.";
        }));
    }

    /// As after a change of the order of the axes: the table of X is not for Y.
    void aBackupIsNotRestoredToAnAxisOfAnotherName()
    {
        LinearAndRotary f;
        VERIFY_RESULT(f.compensator.write(0, requestIn("mm", "mm", "deg")));
        const auto original = f.compensator.backup();
        VERIFY_RESULT(original);
        QCOMPARE(original->axes.front().axisName, std::string("X"));
        const auto report = f.compensator.write(0, exampleRequest(2));
        VERIFY_RESULT(report);
        const auto kept = axisBackupsIn(report->backup, drivecomm::genericProfile());
        VERIFY_RESULT(kept);
        QCOMPARE(kept->front().axisName, std::string("X"));
        const auto before = f.state();
        f.link.forgetChange();
        DriveBackup backup = *original;
        backup.axes.front().axisName = "Y1";
        for (const bool force : {false, true}) {
            const auto refused = f.compensator.restore(backup, force);
            VERIFY_ERROR(refused, ErrorCode::TargetMismatch);
            QVERIFY(
                sentence(refused.error()).starts_with("axis 0 was Y1 when the backup was made"));
            VERIFY_ERROR(
                f.compensator.planRestore(backup.axes.front(), force), ErrorCode::TargetMismatch);
        }
        QCOMPARE(f.link.firstChange(), 0);
        QVERIFY(f.state() == before);

        backup.axes.front().axisName = "Gantry"; // may be the same axis
        const auto plan = f.compensator.planRestore(backup.axes.front(), false);
        VERIFY_RESULT(plan);
        QVERIFY(std::ranges::any_of(plan->warnings, [](const Text& warning) {
            return warning.english().starts_with("Axis 0 was called Gantry");
        }));
        VERIFY_RESULT(f.compensator.restore(backup, false));
    }

    void aBackupIsNotRestoredWithAnotherLayoutOfItsTable()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, exampleRequest()));
        const auto backup = f.compensator.backup();
        VERIFY_RESULT(backup);
        QCOMPARE(backup->axes.front().profile, std::string("generic"));
        const DriveProfile mine = transposing("mine");
        AxisCompensator other(f.link, mine, f.store);
        const auto refused = other.planRestore(backup->axes.front(), true);
        VERIFY_ERROR(refused, ErrorCode::InvalidArgument);
        QVERIFY(sentence(refused.error())
                    .starts_with("the backup was made with the profile generic, which has another "
                                 "layout of table files than mine: "));

        // The same profile, put right since then: of the same drive it is the same file.
        const DriveProfile changed = transposing("generic");
        AxisCompensator later(f.link, changed, f.store);
        const auto plan = later.planRestore(backup->axes.front(), false);
        VERIFY_RESULT(plan);
        QVERIFY(std::ranges::any_of(plan->warnings, [](const Text& warning) {
            return warning.english().starts_with(
                "The layout of table files in the profile generic");
        }));
        AxisBackup ofAnother = backup->axes.front();
        ofAnother.drive.serialNumber = 7;
        VERIFY_ERROR(later.planRestore(ofAnother, true), ErrorCode::InvalidArgument);
        VERIFY_RESULT(f.compensator.planRestore(ofAnother, true));
    }

    void noTableThatNoAxisUsedIsRestoredWithAnotherLayoutEither()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, exampleRequest()));
        WriteRequest none;
        none.withoutTable = true;
        none.sources = {"", "", ""};
        none.dimensionality = 3;
        VERIFY_RESULT(f.compensator.write(0, none));
        const auto backup = f.compensator.backup();
        VERIFY_RESULT(backup);
        QVERIFY(!backup->otherFiles.empty());
        const DriveProfile mine = transposing("mine");
        AxisCompensator other(f.link, mine, f.store);
        const auto refused = other.planRestore(*backup, true);
        VERIFY_ERROR(refused, ErrorCode::InvalidArgument);
        QVERIFY(sentence(refused.error()).starts_with("the backup was made with the profile"));
        VERIFY_ERROR(other.restore(*backup, true), ErrorCode::InvalidArgument);
        DriveBackup without = *backup;
        without.otherFiles.clear();
        VERIFY_RESULT(other.planRestore(without, true));
        VERIFY_RESULT(f.compensator.planRestore(*backup, true));
    }

    void aBackupThatSaysNoLayoutIsRestoredToAnotherDriveWithAWarning()
    {
        CompensatorFixture f;
        VERIFY_RESULT(f.compensator.write(0, exampleRequest()));
        const auto backup = f.compensator.backup();
        VERIFY_RESULT(backup);
        AxisBackup axis = backup->axes.front();
        axis.layout.clear();
        const auto warns = [&] {
            const auto plan = f.compensator.planRestore(axis, true);
            return plan && std::ranges::any_of(plan->warnings, [](const Text& warning) {
                return warning.english().starts_with(
                    "The backup of axis 0 does not say with which profile");
            });
        };
        QVERIFY(!warns());
        axis.drive.serialNumber = 7;
        QVERIFY(warns());
    }

    void aBackupThatSaysNoUnitIsRestoredWithAWarning()
    {
        LinearAndRotary f;
        VERIFY_RESULT(f.compensator.write(0, requestIn("mm", "mm", "deg")));
        auto backup = f.compensator.backup();
        VERIFY_RESULT(backup);
        VERIFY_RESULT(f.compensator.write(0, exampleRequest(2)));
        const auto warnsOfUnit = [](const WritePlan& plan) {
            return std::ranges::any_of(plan.warnings, [](const Text& warning) {
                return warning.english().starts_with(
                    "The backup does not say in which unit axis 0");
            });
        };
        auto plan = f.compensator.planRestore(backup->axes.front(), false);
        VERIFY_RESULT(plan);
        QVERIFY(!warnsOfUnit(*plan));
        for (AxisBackup& axis : backup->axes) {
            axis.unit.clear();
            axis.sourceUnits.clear();
        }
        plan = f.compensator.planRestore(backup->axes.front(), false);
        VERIFY_RESULT(plan);
        QVERIFY(warnsOfUnit(*plan));
        const auto plans = f.compensator.planRestore(*backup, false);
        VERIFY_RESULT(plans);
        QVERIFY(warnsOfUnit(plans->axes.front()));
        VERIFY_RESULT(f.compensator.restore(*backup, false));
    }
};

AXISCOMP_TEST(TestUnitsOfTheDrive)

} // namespace tst_unitsofthedrive

#include "tst_unitsofthedrive.moc"
