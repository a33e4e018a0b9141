// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/write/restored_axis.h"

#include "core/axis/axis_reader.h"
#include "core/drive/drive_units.h"
#include "core/store/kept_meaning.h"
#include "core/table/position_unit.h"
#include "core/table/table_layout.h"
#include "core/write/backup_restore.h"

#include <algorithm>

namespace axiscomp {

namespace {

bool isKnownUnit(const std::string& unit)
{
    return !unitSymbol(unit).empty();
}

/// The argument of the sentence that is about a backup, or about a write that did not end.
NamedArgument broughtBack(BroughtBackBy by)
{
    return {by == BroughtBackBy::Restore ? "restored" : "recovered", Verbatim{"backup"}};
}

std::vector<std::string> withoutLastGaps(std::vector<std::string> texts)
{
    while (!texts.empty() && texts.back().empty())
        texts.pop_back();
    return texts;
}

/// Of whatever type: the axis had it. kept: the address of then, which counts where the drive does
/// not say that of now.
Result<DimSource> sourceOfPath(const RegisterAccess& access, SourceDirectory& sources,
    const std::string& path, std::uint32_t kept)
{
    const auto readings = access.read({path});
    if (readings) {
        const std::uint32_t address = readings->begin()->second.address;
        return DimSource{address != 0 ? address : kept, path};
    }
    if (readings.error().code != ErrorCode::UnknownRegister)
        return fail(readings.error());
    return sources.resolve(access, path); // which says what there is instead
}

bool holdsTable(const AxisBackup& backup)
{
    return std::ranges::any_of(
        backup.files, [](const AxisBackup::File& file) { return !file.bytes.empty(); });
}

/// That the bytes of its files mean what they meant. now: as describeAxis has it.
Result<void> checkFileLayout(const RegisterAccess& access, const AxisBackup& backup,
    const AxisBackup& now, std::vector<Text>& doubts)
{
    if (backup.layout == now.layout)
        return {};
    AXISCOMP_TRY(const auto drive, access.identify());
    if (backup.layout.empty()) {
        if (drive.serialNumber != backup.drive.serialNumber)
            doubts.push_back(AXISCOMP_TEXT("Error",
                "The backup of axis {axis} does not say with which profile it was made; its table "
                "is read with the profile {profile}.")
                                 .with("axis", backup.axis)
                                 .with("profile", now.profile));
        return {};
    }
    AXISCOMP_CHECK(checkLayout(backup, access.profile(), drive.serialNumber));
    doubts.push_back(AXISCOMP_TEXT("Error",
        "The layout of table files in the profile {profile} has been changed since the backup was "
        "made: see that the table is right.")
                         .with("profile", now.profile));
    return {};
}

/// What the backup knows of its numbers: those of an axis without a unit may be in any.
KeptMeaning meaningOf(const AxisBackup& backup)
{
    KeptMeaning meaning{{unitSymbol(backup.unit), {}}, backup.axisName};
    for (const std::string& unit : backup.sourceUnits)
        meaning.units.positions.push_back(unitSymbol(unit));
    return meaning;
}

tl::unexpected<Error> otherUnit(const UnitChange& change, int axis, BroughtBackBy by)
{
    Text what = change.dimension
        ? AXISCOMP_TEXT("Error", "positions of dimension {number} of axis {axis}")
              .with("number", *change.dimension + 1)
              .with("axis", axis)
        : AXISCOMP_TEXT("Error", "values of axis {axis}").with("axis", axis);
    return fail(ErrorCode::UnitMismatch,
        {{"what", std::move(what)}, {"unit", change.before}, {"other", unitNow(change)},
            broughtBack(by)});
}

} // namespace

Result<std::vector<DimSource>> keptSources(
    const RegisterAccess& access, SourceDirectory& sources, const AxisBackup& backup)
{
    std::vector<DimSource> used(dimensionsOfBackup);
    for (std::size_t n = 0; n < used.size(); ++n) {
        const int number = static_cast<int>(n) + 1;
        const auto address = sourceAddress(access, backup.registers, backup.axis, number);
        const std::string path = sourcePath(backup, number);
        if (address == 0)
            continue;
        AXISCOMP_TRY(used[n],
            path.empty() ? sources.sourceAt(access, address)
                         : sourceOfPath(access, sources, path, address));
    }
    return used;
}

Result<std::vector<RegisterWrite>> keptRegisters(
    const RegisterAccess& access, SourceDirectory& sources, const AxisBackup& backup)
{
    AXISCOMP_TRY(const auto used, keptSources(access, sources, backup));
    std::vector<RegisterWrite> registers = backup.registers;
    for (std::size_t n = 0; n < used.size(); ++n) {
        const int number = static_cast<int>(n) + 1;
        const auto source = std::ranges::find(registers,
            access.axisPath(access.registers().source, backup.axis, number), &RegisterWrite::path);
        if (source != registers.end()
            && used[n].address != sourceAddress(access, registers, backup.axis, number))
            source->value = used[n].address;
    }
    return registers;
}

Result<void> checkLayout(
    const AxisBackup& backup, const DriveProfile& profile, std::int32_t serialNumber)
{
    if (backup.layout.empty() || backup.layout == layoutText(profile.layout))
        return {};
    const bool isOtherDrive = serialNumber != backup.drive.serialNumber;
    if (isOtherDrive || backup.profile != profile.name)
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "the backup was made with the profile {before}, which has another layout of "
                    "table files than {profile}: restore it with that profile (--profile), or, on "
                    "a drive that needs the other one, write the table from its file")
                    .with("before", Verbatim{backup.profile})
                    .with("profile", profile.name)}});
    return {};
}

Result<void> describeAxis(
    const RegisterAccess& access, SourceDirectory& sources, AxisBackup& backup)
{
    AXISCOMP_TRY(auto facts, readPositionFacts(access, backup.axis));
    backup.axisName = std::move(facts.name);
    backup.profile = access.profile().name;
    backup.layout = layoutText(access.profile().layout);
    AXISCOMP_TRY(const auto used, keptSources(access, sources, backup));
    const auto unitOf = [&](int axis) -> Result<std::string> {
        if (axis == backup.axis)
            return facts.unit;
        AXISCOMP_TRY(auto other, readPositionFacts(access, axis));
        return std::move(other.unit);
    };
    AXISCOMP_TRY(auto units, driveUnits(access.profile(), used, backup.axis, unitOf));
    backup.unit = std::move(units.values);
    backup.sourceUnits = withoutLastGaps(std::move(units.positions));
    std::vector<std::string> paths;
    for (const DimSource& source : used)
        paths.push_back(source.path);
    backup.sourcePaths = withoutLastGaps(std::move(paths));
    return {};
}

Result<RestoredAxis> checkSameAxis(const RegisterAccess& access, SourceDirectory& sources,
    const AxisBackup& backup, BroughtBackBy by)
{
    AxisBackup now{backup.drive, backup.axis, {}, {}, backup.registers, {}};
    now.sourcePaths = backup.sourcePaths;
    AXISCOMP_CHECK(describeAxis(access, sources, now));
    const MeaningChange change =
        changedMeaning(meaningOf(backup), {{now.unit, now.sourceUnits}, now.axisName});
    if (change.isOtherAxis)
        return fail(ErrorCode::TargetMismatch,
            {{"axis", backup.axis}, {"target", Verbatim{backup.axisName}},
                {"name", Verbatim{now.axisName}}, broughtBack(by)});
    RestoredAxis axis{backup.axisName == now.axisName, {}};
    if (!backup.axisName.empty() && !now.axisName.empty() && !axis.hasSameName)
        axis.doubts.push_back(AXISCOMP_TEXT("Error",
            "Axis {axis} was called {before} when the backup was made, and is called {after} now: "
            "see that it is the same axis.")
                                  .with("axis", backup.axis)
                                  .with("before", Verbatim{backup.axisName})
                                  .with("after", Verbatim{now.axisName}));
    if (!holdsTable(backup))
        return axis;
    AXISCOMP_CHECK(checkFileLayout(access, backup, now, axis.doubts));
    if (change.unit)
        return otherUnit(*change.unit, backup.axis, by);
    if (!isKnownUnit(backup.unit) && isKnownUnit(now.unit))
        axis.doubts.push_back(AXISCOMP_TEXT("Error",
            "The backup does not say in which unit axis {axis} was; its table is taken to be in "
            "{unit}.")
                                  .with("axis", backup.axis)
                                  .with("unit", unitSymbol(now.unit)));
    return axis;
}

} // namespace axiscomp
