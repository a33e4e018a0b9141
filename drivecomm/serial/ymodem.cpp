// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/serial/ymodem.h"

#include <algorithm>
#include <charconv>

namespace axiscomp::drivecomm::ymodem {

void Machine::cancel()
{
    if (!isRunning())
        return;
    m_output.clear();
    m_output.insert(m_output.end(), 8, static_cast<std::byte>(can));
    m_state = State::Failed;
    m_failure = "it was cancelled";
}

void Machine::giveUp(std::string reason)
{
    cancel();
    m_failure = std::move(reason);
}

std::optional<FileHeader> parseHeader(ByteView content)
{
    const std::string_view text = asText(content);
    const std::size_t end = text.find('\0');
    if (end == std::string_view::npos)
        return std::nullopt;
    FileHeader header;
    header.name = text.substr(0, end);
    const std::string_view rest = text.substr(end + 1);
    const std::string_view digits = rest.substr(0, rest.find_first_of(std::string_view("\0 ", 2)));
    if (digits.empty())
        return header;
    std::uint64_t size = 0;
    const char* const last = digits.data() + digits.size();
    const auto parsed = std::from_chars(digits.data(), last, size);
    if (parsed.ec != std::errc{} || parsed.ptr != last)
        return std::nullopt;
    header.size = size;
    return header;
}

} // namespace axiscomp::drivecomm::ymodem
