// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/system_process.h"

#include <algorithm>

// windows.h comes before what needs it.
#include <windows.h>

#include <shellapi.h>

namespace axiscomp::app {

namespace {

HANDLE handleOf(Stream stream)
{
    switch (stream) {
    case Stream::Input:
        return ::GetStdHandle(STD_INPUT_HANDLE);
    case Stream::Output:
        return ::GetStdHandle(STD_OUTPUT_HANDLE);
    case Stream::Notes:
        break;
    }
    return ::GetStdHandle(STD_ERROR_HANDLE);
}

std::string utf8Of(const wchar_t* text)
{
    const int size = ::WideCharToMultiByte(CP_UTF8, 0, text, -1, nullptr, 0, nullptr, nullptr);
    std::string result(static_cast<std::size_t>(size), '\0');
    ::WideCharToMultiByte(CP_UTF8, 0, text, -1, result.data(), size, nullptr, nullptr);
    result.pop_back(); // the zero at the end
    return result;
}

std::error_code lastError()
{
    const DWORD error = ::GetLastError();
    if (error == ERROR_BROKEN_PIPE || error == ERROR_NO_DATA)
        return std::make_error_code(std::errc::broken_pipe);
    return {static_cast<int>(error), std::system_category()};
}

/// As characters, whatever code page the console has.
std::error_code writeToConsole(HANDLE console, std::string_view text)
{
    const int size =
        ::MultiByteToWideChar(CP_UTF8, 0, text.data(), static_cast<int>(text.size()), nullptr, 0);
    std::wstring wide(static_cast<std::size_t>(size), L'\0');
    ::MultiByteToWideChar(
        CP_UTF8, 0, text.data(), static_cast<int>(text.size()), wide.data(), size);
    // Consoles before Windows 8 take 64 KiB at once.
    constexpr std::size_t most = 16 * 1024;
    std::wstring_view rest = wide;
    while (!rest.empty()) {
        DWORD written = 0;
        const auto next = static_cast<DWORD>(std::min(rest.size(), most));
        if (!::WriteConsoleW(console, rest.data(), next, &written, nullptr) || written == 0)
            return lastError();
        rest.remove_prefix(written);
    }
    return {};
}

} // namespace

/// Not those of main(): the run time of C has squeezed these into the code page of the system, and
/// has replaced * and ? by names of files.
ProgramArguments::ProgramArguments(int count, char** values) : m_count(count), m_values(values)
{
    int found = 0;
    wchar_t** const wide = ::CommandLineToArgvW(::GetCommandLineW(), &found);
    if (wide == nullptr)
        return;
    for (int i = 0; i < found; ++i)
        m_texts.push_back(utf8Of(wide[i]));
    ::LocalFree(static_cast<HLOCAL>(wide));
    for (std::string& text : m_texts)
        m_pointers.push_back(text.data());
    m_pointers.push_back(nullptr);
    m_count = found;
    m_values = m_pointers.data();
}

bool isTerminal(Stream stream)
{
    DWORD mode = 0;
    return ::GetConsoleMode(handleOf(stream), &mode) != 0;
}

/// Consoles before Windows 10 cannot.
bool canRewriteLine(Stream stream)
{
    DWORD mode = 0;
    return ::GetConsoleMode(handleOf(stream), &mode) != 0
        && ::SetConsoleMode(handleOf(stream), mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING) != 0;
}

std::size_t columnsOf(Stream stream)
{
    CONSOLE_SCREEN_BUFFER_INFO info{};
    if (!::GetConsoleScreenBufferInfo(handleOf(stream), &info))
        return 0;
    return static_cast<std::size_t>(info.srWindow.Right - info.srWindow.Left + 1);
}

std::error_code writeAll(Stream stream, std::string_view text)
{
    const HANDLE handle = handleOf(stream);
    if (isTerminal(stream))
        return writeToConsole(handle, text);
    constexpr std::size_t most = 1024 * 1024;
    while (!text.empty()) {
        DWORD written = 0;
        const auto next = static_cast<DWORD>(std::min(text.size(), most));
        if (!::WriteFile(handle, text.data(), next, &written, nullptr))
            return lastError();
        text.remove_prefix(written);
    }
    return {};
}

} // namespace axiscomp::app
