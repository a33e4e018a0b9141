// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/faults.h"

#include "drivecomm/codec/error_json.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace axiscomp::drivecomm {

namespace {

struct Name {
    std::string_view name;
    FaultSpec::Kind kind;
    std::string_view argument;
    std::uint64_t most; ///< 0: the argument is an error code
};

constexpr std::uint64_t anyNumber = std::uint64_t{1} << 53;
constexpr std::uint64_t longestDelayMs = 600'000;

constexpr std::array names{
    Name{"drop-after", FaultSpec::Kind::DropAfter, "BYTES", anyNumber},
    Name{"no-reply", FaultSpec::Kind::NoReply, "N", anyNumber},
    Name{"garble", FaultSpec::Kind::Garble, "N", anyNumber},
    Name{"stores-wrong", FaultSpec::Kind::StoresWrong, "N", anyNumber},
    Name{"slow", FaultSpec::Kind::Slow, "MS", longestDelayMs},
    Name{"reboot-after", FaultSpec::Kind::RebootAfter, "N", anyNumber},
    Name{"reject", FaultSpec::Kind::Reject, "CODE", 0},
};

/// What a drive can answer to a write or an upload.
constexpr std::array rejections{ErrorCode::DriveRejected, ErrorCode::UnknownRegister,
    ErrorCode::UnknownFile, ErrorCode::NotAllowedNow, ErrorCode::TooLargeForSlot,
    ErrorCode::TableRefused, ErrorCode::FlashWear};

tl::unexpected<Error> invalid(Text reason)
{
    return fail(ErrorCode::InvalidArgument, {{"reason", std::move(reason)}});
}

std::vector<std::string> knownFaults()
{
    std::vector<std::string> result;
    for (const Name& known : names)
        result.push_back(std::string(known.name) + '=' + std::string(known.argument));
    return result;
}

Result<FaultSpec> rejectFault(std::string_view code)
{
    std::vector<std::string> known;
    for (const ErrorCode one : rejections) {
        if (errorName(one) == code)
            return FaultSpec{FaultSpec::Kind::Reject, 0, std::string(code)};
        known.emplace_back(errorName(one));
    }
    return invalid(
        AXISCOMP_TEXT("Error", "\"{code}\" is not what a drive can answer; that is one of {known}")
            .with("code", code)
            .with("known", known));
}

} // namespace

Result<FaultSpec> parseFault(std::string_view text)
{
    const std::size_t equals = text.find('=');
    const std::string_view name = text.substr(0, equals);
    const auto known = std::ranges::find(names, name, &Name::name);
    if (known == names.end() || equals == std::string_view::npos)
        return invalid(AXISCOMP_TEXT("Error", "\"{text}\" is not a fault; known are {known}")
                           .with("text", text)
                           .with("known", knownFaults()));
    const std::string_view argument = text.substr(equals + 1);
    if (known->most == 0)
        return rejectFault(argument);
    std::uint64_t number = 0;
    const auto parsed = std::from_chars(argument.data(), argument.data() + argument.size(), number);
    if (parsed.ec != std::errc{} || parsed.ptr != argument.data() + argument.size() || number < 1
        || number > known->most)
        return invalid(AXISCOMP_TEXT(
            "Error", "\"{text}\" is not a whole number from 1 to {most}, as {name} needs")
                           .with("text", argument)
                           .with("most", known->most)
                           .with("name", known->name));
    return FaultSpec{known->kind, number, {}};
}

Error errorAskedFor(const std::string& code)
{
    const Text reason = AXISCOMP_TEXT("Error", "a fault was asked for");
    return {driveErrorNamed(code).value_or(ErrorCode::DriveRejected),
        {{"reason", reason}, {"path", reason}, {"seconds", 60}}, {}};
}

FaultPlan::FaultPlan(std::vector<FaultSpec> faults, Observer observer)
    : m_observer(std::move(observer))
    , m_faults(std::move(faults))
{
}

FaultPlan::Decision FaultPlan::next(bool isWrite)
{
    if (m_observer)
        m_observer(isWrite);
    const std::scoped_lock lock(m_mutex);
    ++m_requests;
    if (isWrite)
        ++m_writes;
    Decision decision;
    for (const FaultSpec& fault : m_faults) {
        const bool thisRequest = fault.number == m_requests;
        switch (fault.kind) {
        case FaultSpec::Kind::DropAfter:
            break;
        case FaultSpec::Kind::NoReply:
            decision.noReply |= thisRequest;
            break;
        case FaultSpec::Kind::Garble:
            decision.garble |= thisRequest;
            break;
        case FaultSpec::Kind::StoresWrong:
            decision.storeWrong |= isWrite && fault.number == m_writes;
            break;
        case FaultSpec::Kind::Slow:
            decision.delay += std::chrono::milliseconds(fault.number);
            break;
        case FaultSpec::Kind::RebootAfter:
            decision.reboot |= thisRequest;
            break;
        case FaultSpec::Kind::Reject:
            if (isWrite && !decision.rejectCode)
                decision.rejectCode = fault.code;
            break;
        }
    }
    return decision;
}

std::optional<std::uint64_t> FaultPlan::bytesUntilDrop() const
{
    const std::scoped_lock lock(m_mutex);
    return untilDrop();
}

std::optional<std::uint64_t> FaultPlan::untilDrop() const
{
    std::optional<std::uint64_t> least;
    for (const FaultSpec& fault : m_faults)
        if (fault.kind == FaultSpec::Kind::DropAfter)
            least = std::min(least.value_or(fault.number), fault.number);
    return least;
}

FaultPlan::Carried FaultPlan::carry(
    std::size_t bytes, const std::function<std::ptrdiff_t(std::size_t)>& send)
{
    const std::scoped_lock lock(m_mutex);
    const auto left = untilDrop();
    const std::ptrdiff_t sent =
        send(left ? static_cast<std::size_t>(std::min<std::uint64_t>(bytes, *left)) : bytes);
    if (sent <= 0)
        return {sent, false};
    const auto carried = static_cast<std::uint64_t>(sent);
    count(carried);
    return {sent, left == carried};
}

void FaultPlan::countBytes(std::uint64_t bytes)
{
    const std::scoped_lock lock(m_mutex);
    count(bytes);
}

void FaultPlan::count(std::uint64_t bytes)
{
    std::erase_if(m_faults, [&](FaultSpec& fault) {
        if (fault.kind != FaultSpec::Kind::DropAfter)
            return false;
        fault.number -= std::min(fault.number, bytes);
        return fault.number == 0;
    });
}

void FaultPlan::add(FaultSpec fault)
{
    const std::scoped_lock lock(m_mutex);
    m_faults.push_back(std::move(fault));
}

void FaultPlan::clear()
{
    const std::scoped_lock lock(m_mutex);
    m_faults.clear();
    m_requests = 0;
    m_writes = 0;
}

} // namespace axiscomp::drivecomm
