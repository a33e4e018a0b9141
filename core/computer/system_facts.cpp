// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/computer/system_facts.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <thread>

#include <langinfo.h>
#include <locale.h>
#include <sqlite3.h>
#include <strings.h>
#include <sys/stat.h>
#include <sys/utsname.h>
#include <zlib.h>

namespace axiscomp {

namespace {

constexpr std::streamsize mostOfAFile = 64 * 1024;

/// Of a small file of the system; empty where it cannot be read.
std::string beginningOf(const char* file)
{
    std::ifstream stream(file, std::ios::binary);
    std::string text(static_cast<std::size_t>(mostOfAFile), '\0');
    stream.read(text.data(), mostOfAFile);
    text.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
    return text;
}

/// What follows "KEY" in the line that begins with it.
std::string_view lineValue(std::string_view text, std::string_view key)
{
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        if (text.starts_with(key))
            return text.substr(key.size(), end - key.size());
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return {};
}

/// Of "MemTotal:       16316412 kB", in bytes; 0 where there is no number.
std::uint64_t memoryOf(std::string_view text, std::string_view key)
{
    std::string_view value = lineValue(text, key);
    value.remove_prefix(std::min(value.find_first_not_of(' '), value.size()));
    std::uint64_t number = 0;
    std::from_chars(value.data(), value.data() + value.size(), number);
    return number * 1024;
}

std::string variable(const char* name)
{
    const char* const value = std::getenv(name);
    return value != nullptr ? value : "";
}

} // namespace

std::string distributionOf(std::string_view osRelease)
{
    std::string_view value = lineValue(osRelease, "PRETTY_NAME=");
    const bool isQuoted = value.size() >= 2 && (value.front() == '"' || value.front() == '\'')
        && value.back() == value.front();
    if (isQuoted)
        value = value.substr(1, value.size() - 2);
    std::string name;
    for (std::size_t n = 0; n < value.size(); ++n) {
        if (value[n] == '\\' && n + 1 < value.size())
            ++n;
        name.push_back(value[n]);
    }
    return name;
}

SystemFacts systemFacts()
{
    SystemFacts facts;
    facts.distribution = distributionOf(beginningOf("/etc/os-release"));
    if (facts.distribution.empty())
        facts.distribution = distributionOf(beginningOf("/usr/lib/os-release"));
    utsname names{};
    if (::uname(&names) == 0) {
        facts.kernel = std::string(names.sysname) + " " + names.release;
        facts.architecture = names.machine;
    }
    facts.cores = std::thread::hardware_concurrency();
    const std::string memory = beginningOf("/proc/meminfo");
    facts.memory = memoryOf(memory, "MemTotal:");
    facts.freeMemory = memoryOf(memory, "MemAvailable:");
    return facts;
}

bool LocaleFacts::isUtf8() const
{
    return ::strcasecmp(encoding.c_str(), "UTF-8") == 0
        || ::strcasecmp(encoding.c_str(), "UTF8") == 0;
}

LocaleFacts localeFacts()
{
    LocaleFacts facts;
    for (const char* name :
        {"LC_ALL", "LC_CTYPE", "LC_NUMERIC", "LC_MESSAGES", "LANG", "LANGUAGE"}) {
        if (std::string value = variable(name); !value.empty())
            facts.variables.emplace_back(name, std::move(value));
    }
    locale_t locale = ::newlocale(LC_ALL_MASK, "", nullptr);
    facts.isInstalled = locale != nullptr;
    if (locale == nullptr) // what programs use then
        locale = ::newlocale(LC_ALL_MASK, "C", nullptr);
    if (locale == nullptr)
        return facts;
    facts.encoding = ::nl_langinfo_l(CODESET, locale);
    facts.decimalSign = ::nl_langinfo_l(RADIXCHAR, locale);
    ::freelocale(locale);
    return facts;
}

DisplayFacts displayFacts()
{
    return {variable("DISPLAY"), variable("WAYLAND_DISPLAY"), variable("QT_QPA_PLATFORM")};
}

ClockFacts clockFacts()
{
    ClockFacts facts{std::chrono::system_clock::now()};
    struct stat status { };
    if (::stat("/proc/self/exe", &status) == 0)
        facts.program = std::chrono::system_clock::from_time_t(status.st_mtim.tv_sec);
    return facts;
}

std::vector<std::string> proxyVariables()
{
    std::vector<std::string> names;
    for (const char* name : {"http_proxy", "HTTP_PROXY", "https_proxy", "HTTPS_PROXY", "all_proxy",
             "ALL_PROXY", "no_proxy", "NO_PROXY"})
        if (!variable(name).empty())
            names.emplace_back(name);
    return names;
}

std::vector<LibraryVersion> libraryVersions()
{
    return {{"SQLite", ::sqlite3_libversion(), SQLITE_VERSION},
        {"zlib", ::zlibVersion(), ZLIB_VERSION}};
}

} // namespace axiscomp
