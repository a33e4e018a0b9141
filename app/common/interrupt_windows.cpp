// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/interrupt.h"

#include <windows.h>

namespace axiscomp::app {

namespace {

/// The one that takes the signals; the system calls a function that knows of no object.
struct Taker {
    std::mutex mutex;
    Interrupt* interrupt = nullptr;
};

Taker& taker()
{
    static Taker taker;
    return taker;
}

/// On a thread of the system. Another program can end this one without a word (TerminateProcess):
/// nothing here is told of that, as with SIGKILL.
BOOL WINAPI takeSignal(DWORD signal)
{
    {
        const std::lock_guard lock(taker().mutex);
        if (taker().interrupt == nullptr)
            return FALSE;
        taker().interrupt->request();
    }
    // When this function returns from one of the others, the program ends at once.
    if (signal != CTRL_C_EVENT && signal != CTRL_BREAK_EVENT)
        ::Sleep(INFINITE);
    return TRUE;
}

void setTaker(Interrupt* interrupt)
{
    const std::lock_guard lock(taker().mutex);
    taker().interrupt = interrupt;
}

} // namespace

struct Interrupt::System {
    HANDLE wake = ::CreateEventW(nullptr, TRUE, FALSE, nullptr);
    bool takesSignals = false;
};

Interrupt::Interrupt(Signals signals) : m_system(std::make_unique<System>())
{
    if (signals == Signals::AreLeftAlone)
        return;
    m_system->takesSignals = true;
    setTaker(this);
    ::SetConsoleCtrlHandler(takeSignal, TRUE);
}

Interrupt::~Interrupt()
{
    if (m_system->takesSignals) {
        ::SetConsoleCtrlHandler(takeSignal, FALSE);
        setTaker(nullptr);
    }
    ::CloseHandle(m_system->wake);
}

std::intptr_t Interrupt::wakeHandle() const
{
    return reinterpret_cast<std::intptr_t>(m_system->wake);
}

void Interrupt::wait()
{
    ::WaitForSingleObject(m_system->wake, INFINITE);
}

void Interrupt::wake()
{
    ::SetEvent(m_system->wake);
}

} // namespace axiscomp::app
