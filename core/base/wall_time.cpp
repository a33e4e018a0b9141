// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/wall_time.h"

#include <array>
#include <cstdio>

namespace axiscomp {

namespace {

using Nanoseconds = std::chrono::nanoseconds;

// The years that fit 64 bits of nanoseconds as a whole.
constexpr int firstYear = 1678;
constexpr int lastYear = 2261;

/// Takes `count` digits off the front of text.
std::optional<int> takeDigits(std::string_view& text, std::size_t count)
{
    if (text.size() < count)
        return std::nullopt;
    int value = 0;
    for (const char digit : text.substr(0, count)) {
        if (digit < '0' || digit > '9')
            return std::nullopt;
        value = value * 10 + (digit - '0');
    }
    text.remove_prefix(count);
    return value;
}

bool take(std::string_view& text, char expected)
{
    if (!text.starts_with(expected))
        return false;
    text.remove_prefix(1);
    return true;
}

/// ".25" as nanoseconds; no point is no fraction.
std::optional<Nanoseconds> takeFraction(std::string_view& text)
{
    if (!take(text, '.'))
        return Nanoseconds{0};
    const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
    if (digits == 0 || digits > 9)
        return std::nullopt;
    auto value = takeDigits(text, digits);
    for (std::size_t i = digits; i < 9; ++i)
        *value *= 10;
    return Nanoseconds{*value};
}

} // namespace

std::string utcText(WallTime time)
{
    const auto day = std::chrono::floor<std::chrono::days>(time);
    const std::chrono::year_month_day date{day};
    const std::chrono::hh_mm_ss clock{std::chrono::duration_cast<Nanoseconds>(
        time - std::chrono::time_point_cast<Nanoseconds>(day))};

    std::array<char, 64> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%04d-%02u-%02uT%02d:%02d:%02d",
        static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
        static_cast<unsigned>(date.day()), static_cast<int>(clock.hours().count()),
        static_cast<int>(clock.minutes().count()), static_cast<int>(clock.seconds().count()));
    std::string text = buffer.data();
    if (const auto fraction = clock.subseconds().count(); fraction != 0) {
        std::snprintf(buffer.data(), buffer.size(), ".%09d", static_cast<int>(fraction));
        text += buffer.data();
        text.erase(text.find_last_not_of('0') + 1);
    }
    return text + "Z";
}

std::optional<WallTime> utcFromText(std::string_view text)
{
    const auto year = takeDigits(text, 4);
    const bool afterYear = take(text, '-');
    const auto month = takeDigits(text, 2);
    const bool afterMonth = take(text, '-');
    const auto day = takeDigits(text, 2);
    const bool afterDay = take(text, 'T');
    const auto hour = takeDigits(text, 2);
    const bool afterHour = take(text, ':');
    const auto minute = takeDigits(text, 2);
    const bool afterMinute = take(text, ':');
    const auto second = takeDigits(text, 2);
    const auto fraction = takeFraction(text);
    if (!year || !afterYear || !month || !afterMonth || !day || !afterDay || !hour || !afterHour
        || !minute || !afterMinute || !second || !fraction || text != "Z")
        return std::nullopt;

    const std::chrono::year_month_day date{std::chrono::year{*year},
        std::chrono::month{static_cast<unsigned>(*month)},
        std::chrono::day{static_cast<unsigned>(*day)}};
    if (!date.ok() || *year < firstYear || *year > lastYear || *hour > 23 || *minute > 59
        || *second > 59)
        return std::nullopt;
    return std::chrono::time_point_cast<WallTime::duration>(std::chrono::sys_days{date}
        + std::chrono::hours{*hour} + std::chrono::minutes{*minute} + std::chrono::seconds{*second}
        + *fraction);
}

} // namespace axiscomp
