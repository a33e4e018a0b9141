// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/fit_drive.h"

#include "app/cli/input/known_tables.h"
#include "app/cli/session/command_session.h"
#include "app/common/arguments.h"
#include "core/compensator/known_tables.h"
#include "core/neutral/drive_note.h"
#include "core/store/drive_store.h"

namespace axiscomp::app {

namespace {

Result<AxisTables> tablesOfAxis(
    Environment& environment, CommandSession& session, int axis, const Measurement& measurement)
{
    AXISCOMP_TRY(const auto settled, settledStatus(environment, session, axis));
    AXISCOMP_CHECK(
        checkMeasuredDrive(driveSerialOf(measurement.header), settled.status.drive.serialNumber));
    AXISCOMP_TRY(
        auto table, session.compensator().readDescribedTable(settled.status, session.operation()));
    const DriveStore store(session.storeRoot());
    AXISCOMP_TRY(auto tables,
        axiscomp::tablesOfAxis(axisOfDrive(settled.status, session.profile()), std::move(table),
            session.profile(), store, std::string(positionUnit(measurement))));
    noteRemarks(environment, tables.remarks);
    for (const Error& error : tables.unreadable)
        environment.warn(sentence(error));
    return tables;
}

} // namespace

struct FitDrive::Options {
    DriveOptions drive;
};

FitDrive::FitDrive(const std::string& command) : m_options(std::make_unique<Options>())
{
    m_options->drive.command = command;
}

FitDrive::~FitDrive() = default;

void FitDrive::addOptions(CLI::App& command)
{
    addDriveOptions(command, m_options->drive);
    addAxisOption(command, m_options->drive);
}

const std::string& FitDrive::profile() const
{
    return m_options->drive.profile;
}

Result<DriveState> FitDrive::read(
    Environment& environment, const Measurement& measurement, std::optional<LookupAt> stated) const
{
    AxisTables found;
    const auto read = [&](Environment& same, CommandSession& session,
                          int axis) -> Result<ExitCode> {
        AXISCOMP_TRY(found, tablesOfAxis(same, session, axis, measurement));
        return ExitCode::Done;
    };
    AXISCOMP_CHECK(withAxis(environment, m_options->drive, read));
    if (stated) {
        AXISCOMP_TRY(const auto profile, profileOf(m_options->drive.profile));
        AXISCOMP_CHECK(checkLookupAt(*stated, profile, found.source));
    }
    return DriveState{std::move(found.active), found.lookupAt, std::move(found.backups)};
}

const char* FitDrive::description()
{
    return AXISCOMP_HELP("Help",
        "Merge residuals onto the table that was active: its file, or drive for the one that "
        "the axis uses (--drive, --axis)");
}

const char* FitDrive::example()
{
    return "\n  axiscomp fit after.csv -o new.csv --onto drive --drive http://192.0.2.5 --axis X";
}

} // namespace axiscomp::app
