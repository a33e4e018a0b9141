// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/system_process.h"

#include <cerrno>

#include <sys/ioctl.h>
#include <unistd.h>

namespace axiscomp::app {

namespace {

int descriptorOf(Stream stream)
{
    switch (stream) {
    case Stream::Input:
        return STDIN_FILENO;
    case Stream::Output:
        return STDOUT_FILENO;
    case Stream::Notes:
        break;
    }
    return STDERR_FILENO;
}

} // namespace

ProgramArguments::ProgramArguments(int count, char** values) : m_count(count), m_values(values) { }

bool isTerminal(Stream stream)
{
    return ::isatty(descriptorOf(stream)) == 1;
}

bool canRewriteLine(Stream stream)
{
    return isTerminal(stream);
}

std::size_t columnsOf(Stream stream)
{
    winsize size{};
    return ::ioctl(descriptorOf(stream), TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

std::error_code writeAll(Stream stream, std::string_view text)
{
    while (!text.empty()) {
        const ssize_t count = ::write(descriptorOf(stream), text.data(), text.size());
        if (count < 0) {
            if (errno == EINTR)
                continue;
            return {errno, std::generic_category()};
        }
        text.remove_prefix(static_cast<std::size_t>(count));
    }
    return {};
}

} // namespace axiscomp::app
