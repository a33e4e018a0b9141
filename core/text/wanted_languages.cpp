// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/wanted_languages.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace axiscomp {

namespace {

std::string variable(const char* name)
{
    const char* const value = std::getenv(name);
    return value == nullptr ? std::string() : value;
}

/// "de_CH.UTF-8"
std::string localeOfMessages()
{
    for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
        if (std::string value = variable(name); !value.empty())
            return value;
    }
    return "C";
}

std::string languageOf(std::string_view locale)
{
    return std::string(locale.substr(0, locale.find_first_of("_.@")));
}

bool isUtf8(std::string_view locale)
{
    const auto dot = locale.find('.');
    std::string encoding(locale.substr(dot == std::string_view::npos ? locale.size() : dot + 1));
    encoding.resize(std::min(encoding.size(), encoding.find('@')));
    std::erase(encoding, '-');
    std::ranges::transform(
        encoding, encoding.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
    return encoding == "utf8";
}

} // namespace

std::vector<std::string> wantedLanguages()
{
    const std::string locale = localeOfMessages();
    const std::string language = languageOf(locale);
    if (language == "C" || language == "POSIX" || !isUtf8(locale))
        return {"en"};
    std::vector<std::string> languages;
    std::string wanted = variable("LANGUAGE") + ":" + locale;
    while (!wanted.empty()) {
        const std::size_t end = std::min(wanted.find(':'), wanted.size());
        if (std::string next = languageOf(std::string_view(wanted).substr(0, end)); !next.empty())
            languages.push_back(std::move(next));
        wanted.erase(0, end + 1);
    }
    return languages;
}

} // namespace axiscomp
