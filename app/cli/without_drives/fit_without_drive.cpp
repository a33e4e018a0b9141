// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/commands/fit_drive.h"
#include "app/cli/input/table_input.h"

namespace axiscomp::app {

struct FitDrive::Options {
    std::string command;
    std::string profile;
};

FitDrive::FitDrive(const std::string& command)
    : m_options(std::make_unique<Options>(Options{command, {}}))
{
}

FitDrive::~FitDrive() = default;

void FitDrive::addOptions(CLI::App& command)
{
    addProfileOption(command, m_options->profile);
}

const std::string& FitDrive::profile() const
{
    return m_options->profile;
}

Result<DriveState> FitDrive::read(Environment& /*environment*/, const Measurement& /*measurement*/,
    std::optional<LookupAt> /*stated*/) const
{
    return wrongUsage("this program is built without drives: --onto takes the file of a table",
        m_options->command);
}

const char* FitDrive::description()
{
    return "Merge residuals onto the table that was active: its file";
}

const char* FitDrive::example()
{
    return "\n  axiscomp fit after.csv -o new.csv --onto old.csv";
}

} // namespace axiscomp::app
