// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

namespace axiscomp::test {

/// Empty: it cannot be read.
inline std::string contentOf(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Everything below a folder by its path in it, with its content: to see that nothing has changed.
inline std::map<std::string, std::string> contentsBelow(const std::filesystem::path& folder)
{
    std::map<std::string, std::string> contents;
    std::error_code error;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, error))
        contents[entry.path().lexically_relative(folder).string()] =
            entry.is_regular_file() ? contentOf(entry.path()) : std::string();
    return contents;
}

} // namespace axiscomp::test
