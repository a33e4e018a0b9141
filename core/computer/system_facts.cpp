// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/computer/system_facts.h"

#include "core/io/local_file.h"
#include "core/io/system.h"
#include "core/text/token_scanner.h"
#include "core/text/utf8.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <thread>

#include <langinfo.h>
#include <locale.h>
#include <sqlite3.h>
#include <sys/utsname.h>
#include <zlib.h>

namespace axiscomp {

namespace {

constexpr std::size_t mostShown = 500; ///< characters of what others have written

/// Of a small file of the system; empty where it cannot be read.
std::string systemText(const char* file)
{
    constexpr std::size_t mostOfAFile = 64 * 1024;
    return std::string(asText(loadBeginning(file, mostOfAFile)));
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
    return value != nullptr ? shownText(value, mostShown) : "";
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
    return shownText(name, mostShown);
}

SystemFacts systemFacts()
{
    SystemFacts facts;
    facts.distribution = distributionOf(systemText("/etc/os-release"));
    if (facts.distribution.empty())
        facts.distribution = distributionOf(systemText("/usr/lib/os-release"));
    utsname names{};
    if (::uname(&names) == 0) {
        facts.kernel = std::string(names.sysname) + " " + names.release;
        facts.architecture = names.machine;
    }
    facts.cores = std::thread::hardware_concurrency();
    const std::string memory = systemText("/proc/meminfo");
    facts.memory = memoryOf(memory, "MemTotal:");
    facts.freeMemory = memoryOf(memory, "MemAvailable:");
    return facts;
}

bool LocaleFacts::isUtf8() const
{
    return sameLetters(encoding, "UTF-8") || sameLetters(encoding, "UTF8");
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
    if (const auto program = system::stateOf("/proc/self/exe"))
        facts.program = program->lastChange;
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
