// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/axis/register_access.h"

#include "core/text/utf8.h"

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <set>

namespace axiscomp {

Exchange RegisterAccess::exchange() const
{
    Exchange exchange;
    exchange.timeout = m_options.timeout;
    exchange.stop = m_options.stop;
    return exchange;
}

RegisterAccess RegisterAccess::withoutStop() const
{
    RegisterAccess copy = *this;
    copy.m_options.stop = {};
    return copy;
}

RegisterAccess RegisterAccess::expecting(const DriveIdentity& drive) const
{
    RegisterAccess copy = *this;
    copy.m_expected = drive.serialNumber;
    return copy;
}

void RegisterAccess::report(std::string_view step, double fraction) const
{
    if (m_options.progress)
        m_options.progress(Progress{std::string(step), fraction});
}

Result<void> RegisterAccess::checkStop() const
{
    if (m_options.stop.stop_requested())
        return fail(ErrorCode::Cancelled);
    return {};
}

Result<void> RegisterAccess::pause(std::chrono::milliseconds duration) const
{
    std::mutex mutex;
    std::condition_variable_any wake;
    std::unique_lock lock(mutex);
    wake.wait_for(lock, m_options.stop, duration, [] { return false; });
    return checkStop();
}

std::string RegisterAccess::axisPath(
    const std::string& pattern, int axis, std::optional<int> n) const
{
    return expandPath(pattern, {.axis = axis, .slot = {}, .n = n});
}

std::string RegisterAccess::slotPath(
    const std::string& pattern, std::string_view slot, std::optional<int> n) const
{
    return expandPath(pattern, {.axis = {}, .slot = slot, .n = n});
}

std::vector<std::string> RegisterAccess::axisPaths(
    const std::string& pattern, int axis, int first, int count) const
{
    std::vector<std::string> paths;
    for (int n = first; n < first + count; ++n)
        paths.push_back(axisPath(pattern, axis, n));
    return paths;
}

Result<DriveIdentity> RegisterAccess::identify() const
{
    auto drive = m_link.identify(exchange());
    if (drive)
        drive->name = shownText(drive->name);
    return drive;
}

Result<void> RegisterAccess::checkDrive() const
{
    if (!m_expected)
        return {};
    AXISCOMP_TRY(const auto drive, identify());
    if (drive.serialNumber == *m_expected)
        return {};
    return fail(ErrorCode::OtherDrive, {{"expected", *m_expected}, {"found", drive.serialNumber}});
}

Result<Readings> RegisterAccess::read(const std::vector<std::string>& paths) const
{
    AXISCOMP_TRY(auto answer, m_link.readRegisters(paths, exchange()));
    Readings readings;
    for (RegisterReading& reading : answer) {
        if (auto* text = std::get_if<std::string>(&reading.value))
            *text = shownText(*text);
        std::string path = reading.path;
        readings.insert_or_assign(std::move(path), std::move(reading));
    }
    return readings;
}

Result<Readings> RegisterAccess::readAvailable(std::vector<std::string> paths) const
{
    std::set<std::string> seen;
    std::erase_if(paths, [&](const std::string& path) { return !seen.insert(path).second; });
    while (!paths.empty()) {
        auto readings = read(paths);
        if (readings || readings.error().code != ErrorCode::UnknownRegister)
            return readings;
        const auto missing = std::ranges::find(paths, readings.error().context.english("path"));
        if (missing == paths.end())
            return readings;
        paths.erase(missing);
    }
    return Readings{};
}

Result<void> RegisterAccess::write(const std::vector<RegisterWrite>& writes) const
{
    return m_link.writeRegisters(writes, exchange());
}

bool isUncertain(ErrorCode code)
{
    return mayHaveArrived(code) || code == ErrorCode::Cancelled;
}

double numberAt(const Readings& readings, const std::string& path)
{
    const auto reading = readings.find(path);
    return reading == readings.end() ? std::numeric_limits<double>::quiet_NaN()
                                     : toDouble(reading->second.value);
}

std::string textAt(const Readings& readings, const std::string& path)
{
    const auto reading = readings.find(path);
    return reading == readings.end() ? std::string() : toText(reading->second.value);
}

std::uint32_t unsignedAt(const Readings& readings, const std::string& path)
{
    const double number = numberAt(readings, path);
    return number >= 0.0 && number <= 4294967295.0 ? static_cast<std::uint32_t>(number) : 0;
}

} // namespace axiscomp
