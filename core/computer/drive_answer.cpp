// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/computer/drive_answer.h"

#include "core/axis/activation.h"
#include "core/compensator/axis_compensator.h"
#include "core/drive/looking_link.h"
#include "core/text/crc_text.h"

#include <algorithm>

namespace axiscomp {

namespace {

using Clock = std::chrono::steady_clock;

Result<void> askWithin(
    const std::string& endpoint, const DriveQuestion& question, DriveAnswer& answer)
{
    AXISCOMP_TRY(auto made, question.linkFactory(endpoint));
    LookingLink link(std::move(made), question.timeLimit);
    const auto begin = Clock::now();
    AXISCOMP_TRY(answer.drive,
        link.identify({.timeout = question.timeLimit, .stop = question.stop, .progress = {}}));
    answer.latency = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - begin);
    DriveStore store(question.storeRoot);
    AxisCompensator compensator(link, question.profile, store);
    return readAxes(compensator,
        {.timeout = question.timeLimit, .stop = question.stop, .progress = {}}, answer.axes);
}

Text wayOutOf(const DriveAnswer& answer)
{
    const Error& error = *answer.error;
    // One that has changed is nothing to be trusted by a command that is only pasted.
    if (error.code == ErrorCode::CertificateRejected && error.context.english("hasChanged") == "no")
        return AXISCOMP_TEXT("Doctor",
            "if the drive has the same fingerprint: `axiscomp axes --drive {drive} "
            "--trust-certificate {fingerprint}` trusts it from then on")
            .with("drive", answer.endpoint)
            .with("fingerprint", Verbatim{error.context.english("fingerprint")});
    if (!isUnreachable(error.code))
        return {};
    if (!answer.endpoint.starts_with("serial:"))
        return AXISCOMP_TEXT("Doctor",
            "open {drive} in a browser of this computer; if it does not answer there either, look "
            "at power, cable and network")
            .with("drive", answer.endpoint);
    if (error.code == ErrorCode::NotConnected) // that says what to do itself
        return {};
    return AXISCOMP_TEXT(
        "Doctor", "look at power and cable; `axiscomp axes --find --any-baud` tries other speeds");
}

Finding identityFinding(const DriveAnswer& answer)
{
    const Text name = answer.endpoint.empty() ? Text(AXISCOMP_TEXT("Doctor", "address"))
                                              : Verbatim{answer.endpoint};
    if (!answer.drive)
        return {name, Grade::Problem, textOf(*answer.error), wayOutOf(answer)};
    const Text identity =
        AXISCOMP_TEXT("Doctor",
            "{drive}, serial number {serial}, axes: {axes}, profile {profile}; answered after "
            "{milliseconds}")
            .with("drive", answer.drive->name)
            .with("serial", Verbatim{std::to_string(answer.drive->serialNumber)})
            .with("axes", answer.drive->axes)
            .with("profile", answer.profile)
            .with("milliseconds", Quantity{std::to_string(answer.latency.count()), "ms"});
    if (!answer.error)
        return {name, Grade::Ok, identity};
    return {name, Grade::Problem,
        AXISCOMP_TEXT("Doctor", "{drive}; then: {error}")
            .with("drive", identity)
            .with("error", textOf(*answer.error)),
        wayOutOf(answer)};
}

Text axisStateText(const AxisStatus& status)
{
    const Text state = AXISCOMP_TEXT("Doctor", "{unit}, {homing}, compensation {state}")
                           .with("unit", status.axis.unit)
                           .with("homing", status.axis.homingWord)
                           .with("state", status.axis.stateWord);
    if (!status.table)
        return AXISCOMP_TEXT("Doctor", "{state}, no table").with("state", state);
    return AXISCOMP_TEXT("Doctor", "{state}, table {slot} with CRC {crc}")
        .with("state", state)
        .with("slot", status.setup.slot)
        .with("crc", crcText(status.table->crc));
}

Finding axisFinding(const AxisSummary& row)
{
    const Text name = row.axis.name.empty()
        ? AXISCOMP_TEXT("Doctor", "axis {axis}").with("axis", row.axis.index)
        : AXISCOMP_TEXT("Doctor", "axis {axis} ({name})")
              .with("axis", row.axis.index)
              .with("name", row.axis.name);
    if (row.problem)
        return {name, Grade::Problem, textOf(*row.problem)};
    if (!row.status)
        return {name, Grade::Note,
            AXISCOMP_TEXT("Doctor", "it has no compensation registers by this profile")};
    if (row.status->axis.state == CompensationState::Error)
        return {name, Grade::Problem, textOf(compensationError(*row.status))};
    return {name, Grade::Ok, axisStateText(*row.status)};
}

void addDrive(const DriveAnswer& answer, std::vector<Finding>& findings)
{
    findings.push_back(identityFinding(answer));
    // It is that of the whole drive, and every axis says it.
    const auto inError = std::ranges::find_if(answer.axes,
        [](const AxisSummary& row) { return row.status && row.status->hasDriveError; });
    if (inError != answer.axes.end())
        findings.push_back({AXISCOMP_TEXT("Doctor", "drive error"), Grade::Problem,
            Verbatim{inError->status->driveError},
            AXISCOMP_TEXT("Error", "see the drive's manual")});
    for (const AxisSummary& row : answer.axes)
        findings.push_back(axisFinding(row));
}

} // namespace

DriveAnswer askDrive(
    const std::string& endpoint, const std::string& shown, const DriveQuestion& question)
{
    DriveAnswer answer{shown, question.profile.name, {}, {}, {}, {}};
    if (auto asked = askWithin(endpoint, question, answer); !asked)
        answer.error = std::move(asked).error();
    return answer;
}

FindingSection driveFindings(const std::vector<DriveAnswer>& answers)
{
    FindingSection section{AXISCOMP_TEXT("Doctor", "Drives"), {}};
    for (const DriveAnswer& answer : answers)
        addDrive(answer, section.findings);
    if (answers.empty())
        section.findings.push_back({AXISCOMP_TEXT("Doctor", "drives"), Grade::Note,
            AXISCOMP_TEXT("Doctor", "none is known"),
            AXISCOMP_TEXT("Doctor", "add a connection in the window, or give --drive ADDRESS")});
    return section;
}

} // namespace axiscomp
