// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/input_stream.h"

#include "core/io/local_file.h"
#include "core/io/system.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <thread>
#include <utility>

#include <windows.h>

namespace axiscomp::app {

namespace {

constexpr DWORD chunkSize = 256 * 1024;
constexpr DWORD consoleChunk = 8 * 1024; // characters
constexpr wchar_t controlZ = 0x1a;

std::error_code codeOf(DWORD error)
{
    return {static_cast<int>(error), std::system_category()};
}

std::string utf8Of(std::wstring_view text)
{
    const int size = ::WideCharToMultiByte(
        CP_UTF8, 0, text.data(), static_cast<int>(text.size()), nullptr, 0, nullptr, nullptr);
    std::string result(static_cast<std::size_t>(size), '\0');
    ::WideCharToMultiByte(CP_UTF8, 0, text.data(), static_cast<int>(text.size()), result.data(),
        size, nullptr, nullptr);
    return result;
}

/// What one call of the system gave; nothing and no error: the end.
struct Chunk {
    std::string text;
    std::error_code error = {};
    bool hasEnded = false;
};

Chunk readFile(HANDLE file)
{
    Chunk chunk{std::string(chunkSize, '\0')};
    DWORD count = 0;
    const bool isRead = ::ReadFile(file, chunk.text.data(), chunkSize, &count, nullptr) != 0;
    const DWORD error = isRead ? NO_ERROR : ::GetLastError();
    chunk.text.resize(count);
    chunk.hasEnded = isRead ? count == 0 : error == ERROR_BROKEN_PIPE || error == ERROR_HANDLE_EOF;
    if (!isRead && !chunk.hasEnded)
        chunk.error = codeOf(error);
    return chunk;
}

/// Characters, whatever code page the console has; Ctrl-Z at the beginning of a line is the end.
Chunk readConsole(HANDLE console)
{
    std::wstring wide(consoleChunk, L'\0');
    DWORD count = 0;
    if (!::ReadConsoleW(console, wide.data(), consoleChunk, &count, nullptr))
        return {{}, codeOf(::GetLastError())};
    wide.resize(count);
    if (wide.starts_with(controlZ))
        return {{}, {}, true};
    return {utf8Of(wide)};
}

} // namespace

/// Windows cannot wait for a pipe or a console and for an event at the same time: a thread reads
/// and sets an event, one chunk whenever one is asked for.
struct InputStream::Source {
    Source(HANDLE opened, bool isOwn) : file(opened), ownsFile(isOwn)
    {
        DWORD mode = 0;
        isConsole = ::GetConsoleMode(file, &mode) != 0;
        waits = ::GetFileType(file) != FILE_TYPE_DISK;
    }
    Source(const Source&) = delete;
    Source& operator=(const Source&) = delete;
    ~Source()
    {
        if (reader.joinable()) {
            // Again and again: between two looks the thread may begin to read.
            constexpr DWORD pause = 1; // ms
            while (::WaitForSingleObject(ready, pause) == WAIT_TIMEOUT)
                stopReading();
            reader.join();
        }
        ::CloseHandle(ready);
        if (ownsFile)
            ::CloseHandle(file);
    }

    /// The event `ready` comes when there is a chunk.
    void ask()
    {
        if (std::exchange(isAsked, true))
            return;
        if (reader.joinable())
            reader.join();
        ::ResetEvent(ready);
        reader = std::thread([this] {
            readerNumber = ::GetCurrentThreadId();
            chunk = isConsole ? readConsole(file) : readFile(file);
            ::SetEvent(ready);
        });
    }
    /// After `ready`.
    Chunk take()
    {
        reader.join();
        isAsked = false;
        return std::exchange(chunk, {});
    }

    void stopReading() const
    {
        const HANDLE thread = ::OpenThread(THREAD_TERMINATE, FALSE, readerNumber);
        if (thread == nullptr)
            return;
        ::CancelSynchronousIo(thread);
        ::CloseHandle(thread);
    }

    HANDLE file;
    bool ownsFile;
    bool isConsole = false;
    bool waits = false;
    bool isAsked = false;
    HANDLE ready = ::CreateEventW(nullptr, TRUE, FALSE, nullptr);
    std::thread reader;
    std::atomic<DWORD> readerNumber{0};
    Chunk chunk;
};

InputStream::InputStream(std::string name, std::shared_ptr<Source> source)
    : m_name(std::move(name))
    , m_source(std::move(source))
{
}

InputStream::InputStream(InputStream&& other) noexcept = default;
InputStream& InputStream::operator=(InputStream&& other) noexcept = default;
InputStream::~InputStream() = default;

InputStream InputStream::standardInput()
{
    // Never destroyed: its thread may wait for a key until the program has ended.
    static auto& source = *new std::shared_ptr<Source>(
        std::make_shared<Source>(::GetStdHandle(STD_INPUT_HANDLE), false));
    return {"standard input", source};
}

Result<InputStream> InputStream::open(const std::string& file)
{
    const std::filesystem::path path = pathFromText(file);
    const auto state = system::stateOf(path);
    const HANDLE opened = ::CreateFileW(system::nativeName(path).c_str(), GENERIC_READ,
        FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr, OPEN_EXISTING,
        FILE_ATTRIBUTE_NORMAL, nullptr);
    if (opened != INVALID_HANDLE_VALUE)
        return InputStream(file, std::make_shared<Source>(opened, true));
    const std::error_code error = !state          ? state.error()
        : state->kind == system::FileKind::Folder ? std::make_error_code(std::errc::is_a_directory)
                                                  : codeOf(::GetLastError());
    return fail(ErrorCode::FileNotReadable, {{"file", file}, {"reason", fileErrorReason(error)}});
}

tl::unexpected<Error> InputStream::notReadable(const std::error_code& error) const
{
    return fail(ErrorCode::FileNotReadable,
        {{"file", Verbatim{m_name}}, {"reason", fileErrorReason(error)}});
}

Result<bool> InputStream::readMore(Interrupt& interrupt, std::string& text)
{
    while (true) {
        if (m_source->waits) {
            m_source->ask();
            const std::array both{
                reinterpret_cast<HANDLE>(interrupt.wakeHandle()), m_source->ready};
            ::WaitForMultipleObjects(both.size(), both.data(), FALSE, INFINITE);
        }
        if (interrupt.stopped())
            return fail(ErrorCode::Cancelled);
        const Chunk chunk = m_source->waits ? m_source->take() : readFile(m_source->file);
        // Ctrl-C ends the reading of a console before anybody is told of it.
        if (chunk.error == codeOf(ERROR_OPERATION_ABORTED))
            continue;
        if (chunk.error)
            return notReadable(chunk.error);
        text += chunk.text;
        if (chunk.hasEnded || !chunk.text.empty())
            return !chunk.hasEnded;
    }
}

Result<Input> InputStream::waitForInput(Interrupt& interrupt, bool reads,
    std::chrono::steady_clock::time_point until, std::string& text)
{
    if (reads && m_source->waits)
        m_source->ask();
    const std::array both{reinterpret_cast<HANDLE>(interrupt.wakeHandle()), m_source->ready};
    const DWORD count = reads && m_source->waits ? both.size() : 1;
    while (!interrupt.stopped()) {
        const auto left =
            std::chrono::ceil<std::chrono::milliseconds>(until - std::chrono::steady_clock::now());
        const auto timeout = static_cast<DWORD>(std::max<std::int64_t>(left.count(), 0));
        const bool isFile = reads && !m_source->waits;
        const DWORD found =
            ::WaitForMultipleObjects(count, both.data(), FALSE, isFile ? 0 : timeout);
        if (found == WAIT_TIMEOUT && !isFile)
            return Input::None;
        if ((found == WAIT_OBJECT_0 + 1 || isFile) && !interrupt.stopped()) {
            AXISCOMP_TRY(const auto more, readMore(interrupt, text));
            return more ? Input::Some : Input::Ended;
        }
    }
    return fail(ErrorCode::Cancelled);
}

} // namespace axiscomp::app
