// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/firmware/register_tree.h"

#include "core/text/edit_distance.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

namespace axiscomp::drivecomm {

namespace {

constexpr std::uint32_t generalBlock = 0x4000'0000;
constexpr std::uint32_t applicationBlock = 0x4001'0000;
constexpr std::uint32_t otherBlock = 0x4002'0000;
constexpr std::uint32_t firstAxisBlock = 0x4010'0000;
constexpr std::uint32_t blockSize = 0x1'0000;
constexpr std::uint32_t configuredPart = 0x8000; ///< second half of a block
constexpr std::uint32_t overflowBlock = 0x5000'0000;

std::uint32_t blockOf(std::string_view path)
{
    constexpr std::string_view axes = "Axes[";
    if (path.starts_with("General/"))
        return generalBlock;
    if (path.starts_with("Application/"))
        return applicationBlock;
    std::uint32_t axis = 0;
    if (path.starts_with(axes)
        && std::from_chars(path.data() + axes.size(), path.data() + path.size(), axis).ec
            == std::errc{}
        && axis < 0x1000)
        return firstAxisBlock + axis * blockSize;
    return otherBlock;
}

char smallLetter(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool sameName(std::string_view a, std::string_view b)
{
    return std::ranges::equal(a, b, {}, smallLetter, smallLetter);
}

bool isBelow(std::string_view path, std::string_view prefix)
{
    if (prefix.empty() || path == prefix)
        return true;
    return path.starts_with(prefix) && (path[prefix.size()] == '/' || path[prefix.size()] == '[');
}

tl::unexpected<Error> refused(const Register& target, const RegisterValue& value)
{
    const auto* name = std::get_if<std::string>(&value);
    const TextPattern reason = target.enumValues.empty()
        ? AXISCOMP_TEXT("Error", "{path} is of type {type}, and cannot be {value}")
        : AXISCOMP_TEXT("Error", "{path} is of type {type}, one of {names}, and cannot be {value}");
    return fail(ErrorCode::DriveRejected,
        {{"reason",
            reason.with("path", target.path)
                .with("type", target.type)
                .with("names", target.enumValues)
                .with("value", name ? Argument('"' + *name + '"') : Quantity{toText(value)})}});
}

/// A number of any type; none for Boolean and enum.
std::optional<double> numberOf(const RegisterValue& value)
{
    if (std::holds_alternative<bool>(value) || std::holds_alternative<std::string>(value))
        return {};
    return toDouble(value);
}

template <typename Integer> std::optional<RegisterValue> asInteger(double number)
{
    if (!(number >= std::numeric_limits<Integer>::min()
            && number <= std::numeric_limits<Integer>::max())
        || number != std::trunc(number))
        return {};
    return static_cast<Integer>(number);
}

std::optional<RegisterValue> asNumber(std::string_view type, double number)
{
    if (type == "Int32")
        return asInteger<std::int32_t>(number);
    if (type == "UInt32")
        return asInteger<std::uint32_t>(number);
    if (!std::isfinite(number)
        || (type == "Single" && std::abs(number) > std::numeric_limits<float>::max()))
        return {};
    return type == "Single" ? RegisterValue(static_cast<float>(number)) : RegisterValue(number);
}

std::optional<RegisterValue> asEnum(const Register& target, const std::string& name)
{
    constexpr std::size_t longestName = 64;
    if (target.enumValues.empty())
        return name.size() <= longestName ? std::optional<RegisterValue>(name) : std::nullopt;
    const auto known = std::ranges::find_if(
        target.enumValues, [&](const std::string& one) { return sameName(one, name); });
    return known == target.enumValues.end() ? std::nullopt : std::optional<RegisterValue>(*known);
}

} // namespace

bool Register::isParameter() const
{
    const bool keeps = role == RegisterRole::Value || role == RegisterRole::CompensationValue;
    return keeps && path.find("/Parameters/") != std::string::npos;
}

Register& RegisterTree::add(Register added)
{
    if (Register* present = find(added.path))
        return *present;
    added.address = nextAddress(added);
    added.factory = added.saved = added.value;
    Register& kept = m_registers.emplace_back(std::move(added));
    m_byPath.emplace(kept.path, &kept);
    m_byAddress.emplace(kept.address, &kept);
    return kept;
}

std::uint32_t RegisterTree::nextAddress(const Register& added)
{
    const std::uint32_t size = added.type == "Double" ? 8 : 4;
    const auto take = [&](std::uint32_t base, std::uint32_t room) -> std::uint32_t {
        std::uint32_t& used = m_used[base];
        const std::uint32_t aligned = (used + size - 1) / size * size;
        if (aligned + size > room)
            return 0;
        used = aligned + size;
        return base + aligned;
    };
    const std::uint32_t block = blockOf(added.path);
    const std::uint32_t address =
        take(m_configured ? block + configuredPart : block, blockSize - configuredPart);
    return address != 0 ? address : take(overflowBlock, 0x1000'0000);
}

Register* RegisterTree::find(std::string_view path)
{
    const auto found = m_byPath.find(normalisedPath(path));
    return found == m_byPath.end() ? nullptr : found->second;
}

const Register* RegisterTree::atAddress(std::uint32_t address) const
{
    const auto found = m_byAddress.find(address);
    return found == m_byAddress.end() ? nullptr : found->second;
}

std::vector<const Register*> RegisterTree::under(std::string_view prefix) const
{
    const std::string normalised = normalisedPath(prefix);
    std::vector<const Register*> result;
    for (const Register& one : m_registers)
        if (isBelow(one.path, normalised))
            result.push_back(&one);
    return result;
}

std::string RegisterTree::nearest(std::string_view path) const
{
    constexpr std::size_t longestPath = 200;
    const std::string wanted = normalisedPath(path);
    if (wanted.empty() || wanted.size() > longestPath)
        return {};
    // Farther than half of what was asked for is no longer the same name.
    const std::size_t farthest = std::max<std::size_t>(3, wanted.size() / 2);
    struct Match {
        std::size_t distance = 0;
        const Register* found = nullptr;
    };
    std::array<Match, 3> best;
    best.fill({farthest, nullptr});
    for (const Register& one : m_registers) {
        Match match{
            editDistance(wanted, one.path, LetterCase::Ignored, best.back().distance), &one};
        for (Match& place : best)
            if (match.distance < place.distance)
                std::swap(match, place);
    }
    std::string result;
    for (const Match& match : best)
        if (match.found != nullptr)
            result += (result.empty() ? "" : ", ") + match.found->path;
    return result;
}

Result<RegisterValue> fitted(const Register& target, const RegisterValue& value)
{
    std::optional<RegisterValue> result;
    if (target.type == "Boolean") {
        if (std::holds_alternative<bool>(value))
            result = value;
    } else if (target.type == "Int32" || target.type == "UInt32" || target.type == "Single"
        || target.type == "Double") {
        if (const std::optional<double> number = numberOf(value))
            result = asNumber(target.type, *number);
    } else if (const auto* name = std::get_if<std::string>(&value)) {
        result = asEnum(target, *name);
    }
    if (!result)
        return refused(target, value);
    return *result;
}

} // namespace axiscomp::drivecomm
