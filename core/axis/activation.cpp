// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/axis/activation.h"

#include "core/axis/axis_reader.h"
#include "core/axis/verified_transfer.h"

#include <array>
#include <utility>

namespace axiscomp {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds statePollInterval{5};

struct Hint {
    CompensationFault fault;
    TextPattern hint;
};
constexpr std::array hints{
    Hint{CompensationFault::NotHomed, AXISCOMP_TEXT("Error", "the axis must be homed first")},
    Hint{CompensationFault::NoTable,
        AXISCOMP_TEXT("Error", "the axis has no table; write one first")},
    Hint{CompensationFault::DimensionMismatch,
        AXISCOMP_TEXT("Error", "the number of sources must equal the table's dimensions")},
    Hint{CompensationFault::BadSource,
        AXISCOMP_TEXT("Error", "a source is not a Single or Double register of this drive")},
    Hint{CompensationFault::BadTable,
        AXISCOMP_TEXT("Error", "the drive cannot use the table; write it again")},
};

constexpr TextPattern forgotten = AXISCOMP_TEXT(
    "Error", "the drive has restarted, or somebody else has switched the compensation");

Result<void> requestActivation(
    const RegisterAccess& access, const AxisStatus& status, const std::string& value)
{
    const std::string path = access.axisPath(access.registers().activation, status.axis.index);
    // An error stays until the request is withdrawn.
    const bool isStuck = status.axis.state == CompensationState::Error;
    if (isStuck && value != access.enums().activationDisabled) {
        if (auto cleared = writeVerified(access, {{path, access.enums().activationDisabled}});
            !cleared)
            return cleared;
    }
    return writeVerified(access, {{path, value}});
}

/// activation: what was asked for. It is looked at too: a drive that restarts forgets it, and the
/// state that is waited for would never come.
Result<AxisStatus> waitForState(const RegisterAccess& access, const DriveIdentity& drive, int axis,
    SourceDirectory& sources, const std::string& activation, const std::string& wanted)
{
    const std::string path = access.axisPath(access.registers().state, axis);
    const std::string request = access.axisPath(access.registers().activation, axis);
    const auto notReached = [&](const std::string& state, Text hint) {
        return fail(ErrorCode::CompensationError,
            {{"axis", axis}, {"error", state}, {"hint", std::move(hint)}});
    };
    const auto deadline = Clock::now() + access.options().timeout;
    while (true) {
        AXISCOMP_TRY(auto readings, access.read({path, request}));
        const std::string state = textAt(readings, path);
        const bool isError = compensationState(access.enums(), state) == CompensationState::Error;
        if (state == wanted || isError) {
            AXISCOMP_TRY(auto status, readStatus(access, drive, axis, sources));
            if (status.axis.state == CompensationState::Error)
                return fail(compensationError(status));
            if (status.axis.stateWord != wanted) // no more
                return notReached(status.axis.stateWord, forgotten);
            return status;
        }
        if (textAt(readings, request) != activation)
            return notReached(state, forgotten);
        if (Clock::now() >= deadline)
            return notReached(state,
                AXISCOMP_TEXT("Error", "it did not become {state} in time").with("state", wanted));
        AXISCOMP_CHECK(access.pause(statePollInterval));
    }
}

/// What another drive has reached, or not, says nothing about this one.
Result<AxisStatus> confirmed(
    const RegisterAccess& access, const DriveIdentity& drive, Result<AxisStatus> reached)
{
    const auto same = access.expecting(drive).checkDrive();
    if (!same && (reached || same.error().code == ErrorCode::OtherDrive))
        return fail(same.error());
    return reached;
}

Result<AxisStatus> requestAndWait(const RegisterAccess& access, const AxisStatus& status,
    SourceDirectory& sources, const std::string& activation, const std::string& wanted)
{
    AXISCOMP_CHECK(requestActivation(access.expecting(status.drive), status, activation));
    return confirmed(access, status.drive,
        waitForState(access, status.drive, status.axis.index, sources, activation, wanted));
}

/// What can be said before the drive is asked.
Result<AxisStatus> readyStatus(
    const RegisterAccess& access, const DriveIdentity& drive, int axis, SourceDirectory& sources)
{
    auto status = readStatus(access, drive, axis, sources);
    if (status && !status->table)
        return fail(ErrorCode::NoTable, {{"axis", axis}});
    return status;
}

} // namespace

Error compensationError(const AxisStatus& status)
{
    TextPattern hint = AXISCOMP_TEXT("Error", "see the drive's manual");
    for (const Hint& row : hints) {
        if (row.fault == status.fault)
            hint = row.hint;
    }
    return Error{ErrorCode::CompensationError,
        {{"axis", status.axis.index}, {"error", status.error}, {"hint", hint}}, {}};
}

Result<AxisStatus> activateAxis(
    const RegisterAccess& access, const DriveIdentity& drive, int axis, SourceDirectory& sources)
{
    auto status = readyStatus(access, drive, axis, sources);
    if (!status)
        return status;
    if (status->axis.state == CompensationState::Active)
        return confirmed(access, drive, std::move(status));
    if (!status->axis.isHomed)
        return fail(ErrorCode::NotHomed, {{"axis", axis}});
    return requestAndWait(access, *status, sources, access.enums().activationAddToEncoders,
        access.enums().stateActive);
}

Result<AxisStatus> evaluateAxis(
    const RegisterAccess& access, const DriveIdentity& drive, int axis, SourceDirectory& sources)
{
    auto status = readyStatus(access, drive, axis, sources);
    if (!status)
        return status;
    if (status->axis.state == CompensationState::Evaluating)
        return confirmed(access, drive, std::move(status));
    if (status->isOn())
        return fail(ErrorCode::CompensationActive, {{"axis", axis}});
    return requestAndWait(access, *status, sources, access.enums().activationEvaluate,
        access.enums().stateEvaluating);
}

Result<AxisStatus> deactivateAxis(
    const RegisterAccess& access, const DriveIdentity& drive, int axis, SourceDirectory& sources)
{
    auto status = readStatus(access, drive, axis, sources);
    if (!status)
        return status;
    if (status->axis.state == CompensationState::Disabled
        && status->activation == access.enums().activationDisabled)
        return confirmed(access, drive, std::move(status));
    return requestAndWait(
        access, *status, sources, access.enums().activationDisabled, access.enums().stateDisabled);
}

} // namespace axiscomp
