// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/moments.h"

#include <QTest>

#include <csignal>
#include <functional>

#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace axiscomp::test {

/// A child process that does something and is killed (kill -9) on its way into or out of its n-th
/// system call. Nothing that it did in between can be seen from outside, so that all of these are
/// all the moments there are.
class KilledChild {
public:
    enum class End { Killed, Finished, Failed };

    [[nodiscard]] static End run(const std::function<void()>& action, int killAt)
    {
        const pid_t child = ::fork();
        if (child < 0)
            return End::Failed;
        if (child == 0) {
            ::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr);
            ::raise(SIGSTOP);
            action();
            ::_exit(0);
        }
        int status = 0;
        if (::waitpid(child, &status, 0) != child || !WIFSTOPPED(status))
            return End::Failed;
        ::ptrace(PTRACE_SETOPTIONS, child, nullptr, PTRACE_O_EXITKILL | PTRACE_O_TRACESYSGOOD);
        for (int stops = 0; stops < killAt; ++stops) {
            ::ptrace(PTRACE_SYSCALL, child, nullptr, nullptr);
            if (::waitpid(child, &status, 0) != child)
                return End::Failed;
            if (WIFEXITED(status))
                return WEXITSTATUS(status) == 0 ? End::Finished : End::Failed;
            if (!WIFSTOPPED(status) || WSTOPSIG(status) != (SIGTRAP | 0x80))
                return End::Failed;
        }
        ::kill(child, SIGKILL);
        ::waitpid(child, &status, 0);
        return WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL ? End::Killed : End::Failed;
    }
};

/// Kills action at every moment there is, and calls check after each. Gives how many there were;
/// fails the test and gives -1 when a child did something else than being killed or finishing.
/// step: only every so many moments, where each takes long; all with AXISCOMP_EVERY_MOMENT.
inline int killEverywhere(
    const std::function<void()>& action, const std::function<void()>& check, int step = 1)
{
    if (takesEveryMoment())
        step = 1;
    for (int moment = 1;; moment += step) {
        const KilledChild::End end = KilledChild::run(action, moment);
        if (end == KilledChild::End::Failed || QTest::currentTestFailed())
            return -1;
        check();
        if (end == KilledChild::End::Finished)
            return moment - 1;
    }
}

/// No file may grow beyond this while it lives, as on a full disk.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes) : m_oldHandler(std::signal(SIGXFSZ, SIG_IGN))
    {
        ::getrlimit(RLIMIT_FSIZE, &m_old);
        const struct rlimit limit {
            bytes, m_old.rlim_max
        };
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit()
    {
        ::setrlimit(RLIMIT_FSIZE, &m_old);
        std::signal(SIGXFSZ, m_oldHandler);
    }
    Q_DISABLE_COPY_MOVE(FileSizeLimit)

private:
    void (*m_oldHandler)(int);
    struct rlimit m_old { };
};

} // namespace axiscomp::test
