// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace axiscomp::app {

// What a program has of the system that starts it: system_process_posix.cpp,
// system_process_windows.cpp.

/// The arguments of main(), as UTF-8.
class ProgramArguments {
public:
    ProgramArguments(int count, char** values);
    ProgramArguments(const ProgramArguments&) = delete;
    ProgramArguments& operator=(const ProgramArguments&) = delete;

    [[nodiscard]] int count() const { return m_count; }
    /// Where other users can read the arguments of a program, what is written here is what they
    /// read.
    [[nodiscard]] char** values() { return m_values; }

private:
    std::vector<std::string> m_texts;
    std::vector<char*> m_pointers;
    int m_count;
    char** m_values;
};

/// Standard input, standard output and standard error.
enum class Stream { Input, Output, Notes };

[[nodiscard]] bool isTerminal(Stream stream);
/// Whether "\r\033[K" empties the line that a person sees.
[[nodiscard]] bool canRewriteLine(Stream stream);
/// Of the terminal; 0 where that is not known.
[[nodiscard]] std::size_t columnsOf(Stream stream);

/// All of a text, as it is; a terminal gets its characters. std::errc::broken_pipe when nobody
/// reads any more.
[[nodiscard]] std::error_code writeAll(Stream stream, std::string_view text);

} // namespace axiscomp::app
