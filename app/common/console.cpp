// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/console.h"

#include "app/common/system_process.h"
#include "core/io/local_file.h"
#include "core/text/utf8.h"

#include <algorithm>

namespace axiscomp::app {

namespace {

constexpr std::size_t bufferSize = 64 * 1024;
constexpr std::chrono::milliseconds progressInterval{100};
constexpr std::string_view eraseLine = "\r\033[K";

/// Cut so that no UTF-8 character is torn.
std::string firstBytes(std::string text, std::size_t most)
{
    if (text.size() <= most)
        return text;
    const auto isContinuation = [](char c) {
        return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
    };
    while (most > 0 && isContinuation(text[most]))
        --most;
    text.resize(most);
    return text;
}

std::string percent(double fraction)
{
    const int value = fraction > 0.0 ? static_cast<int>(std::min(fraction, 1.0) * 100.0) : 0;
    std::string text = std::to_string(value);
    text.insert(0, 3 - text.size(), ' ');
    return text + " %";
}

} // namespace

std::string singleLine(std::string_view text)
{
    std::string result;
    result.reserve(text.size());
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        result.push_back(byte < 0x20 || byte == 0x7f ? ' ' : c);
    }
    return visibleText(result);
}

std::string withoutPasswords(std::string_view text)
{
    constexpr std::string_view scheme = "://";
    std::string result(text);
    for (std::size_t place = result.find(scheme); place != std::string::npos;
         place = result.find(scheme, place + 1)) {
        const std::size_t begin = place + scheme.size();
        const std::size_t end = result.find_first_of(" \t\r\n", begin);
        const std::size_t at = result.substr(0, end).rfind('@');
        constexpr std::string_view example = "user:password"; // of a sentence that says what to do
        if (at != std::string::npos && at >= begin && result.substr(begin, at - begin) != example)
            result.erase(begin, at + 1 - begin);
    }
    return result;
}

Console::Console()
    : m_outputIsTerminal(isTerminal(Stream::Output))
    , m_showsProgress(canRewriteLine(Stream::Notes))
{
    constexpr std::size_t fewestColumns = 20;
    const std::size_t columns = m_showsProgress ? columnsOf(Stream::Notes) : 0;
    if (columns > fewestColumns)
        m_width = columns;
}

Console::Console(Taker output, Taker notes) : m_output(std::move(output)), m_notes(std::move(notes))
{
}

Console::~Console()
{
    const std::lock_guard lock(m_mutex);
    hideProgress();
    send();
}

void Console::print(std::string_view text)
{
    const std::lock_guard lock(m_mutex);
    hideProgress();
    // A program gets what a file says as it is; a terminal acts on some of it.
    if (m_outputIsTerminal)
        m_kept.append(visibleText(text, true));
    else
        m_kept.append(text);
    if (m_kept.size() >= bufferSize)
        send();
}

void Console::note(std::string_view line)
{
    const std::lock_guard lock(m_mutex);
    hideProgress();
    send();
    std::string text = withoutPasswords(singleLine(line));
    if (m_notes) {
        m_notes(text);
        return;
    }
    text.push_back('\n');
    // Nobody can be told that standard error does not work.
    static_cast<void>(writeAll(Stream::Notes, text));
}

void Console::progress(std::string_view step, double fraction)
{
    const std::lock_guard lock(m_mutex);
    const auto now = std::chrono::steady_clock::now();
    if (!m_showsProgress || now < m_progressDue)
        return;
    m_progressDue = now + progressInterval;
    send();
    const std::string head = percent(fraction) + "  ";
    const std::string words = firstBytes(singleLine(step), m_width - 1 - head.size());
    m_progressVisible = true;
    static_cast<void>(writeAll(Stream::Notes, std::string(eraseLine) + head + words));
}

void Console::clearProgress()
{
    const std::lock_guard lock(m_mutex);
    hideProgress();
}

Result<void> Console::flush()
{
    const std::lock_guard lock(m_mutex);
    send();
    if (m_outputError && m_outputError != std::errc::broken_pipe)
        return fail(ErrorCode::FileNotWritable,
            {{"file", Verbatim{"standard output"}}, {"reason", fileErrorReason(m_outputError)}});
    return {};
}

bool Console::readerGone() const
{
    const std::lock_guard lock(m_mutex);
    return m_outputError == std::errc::broken_pipe;
}

void Console::send()
{
    if (m_kept.empty())
        return;
    if (m_output)
        m_output(m_kept);
    else if (!m_outputError)
        m_outputError = writeAll(Stream::Output, m_kept);
    m_kept.clear();
}

void Console::hideProgress()
{
    if (!m_progressVisible)
        return;
    m_progressVisible = false;
    static_cast<void>(writeAll(Stream::Notes, eraseLine));
}

} // namespace axiscomp::app
