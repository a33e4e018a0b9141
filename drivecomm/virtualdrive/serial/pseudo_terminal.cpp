// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/serial/pseudo_terminal.h"

#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace axiscomp::drivecomm {

namespace {

tl::unexpected<Error> refused(const std::string& link, Text reason)
{
    return fail(ErrorCode::InvalidEndpoint,
        {{"endpoint",
             link.empty() ? Argument(AXISCOMP_TEXT("Error", "a new pseudo-terminal")) : link},
            {"reason", std::move(reason)}});
}

tl::unexpected<Error> noTerminal(const std::string& link)
{
    // NOLINTNEXTLINE(concurrency-mt-unsafe): glibc's is thread-safe
    const std::string reason = std::strerror(errno);
    return refused(
        link, AXISCOMP_TEXT("Error", "no pseudo-terminal: {reason}").with("reason", reason));
}

/// No echo, no line editing, no translation: a serial line.
bool makeRaw(const FileDescriptor& slave)
{
    termios settings{};
    if (::tcgetattr(slave.get(), &settings) != 0)
        return false;
    ::cfmakeraw(&settings);
    return ::tcsetattr(slave.get(), TCSANOW, &settings) == 0;
}

Result<void> placeLink(const std::string& link, const std::string& device)
{
    std::error_code error;
    const auto status = std::filesystem::symlink_status(link, error);
    if (std::filesystem::exists(status) && !std::filesystem::is_symlink(status))
        return refused(
            link, AXISCOMP_TEXT("Error", "there is a file of this name; choose another one"));
    // Renamed, so that a client finds the old port or the new one.
    const std::string fresh = link + ".new";
    std::filesystem::remove(fresh, error);
    std::filesystem::create_symlink(device, fresh, error);
    if (!error)
        std::filesystem::rename(fresh, link, error);
    if (error)
        return refused(link,
            AXISCOMP_TEXT("Error", "the link cannot be made: {reason}")
                .with("reason", error.message()));
    return {};
}

} // namespace

Result<PseudoTerminal> PseudoTerminal::open(const std::string& link)
{
    PseudoTerminal terminal;
    terminal.m_master = FileDescriptor(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK));
    const int master = terminal.m_master.get();
    std::array<char, 128> name{};
    if (!terminal.m_master.isOpen() || ::grantpt(master) != 0 || ::unlockpt(master) != 0
        || ::ptsname_r(master, name.data(), name.size()) != 0)
        return noTerminal(link);
    terminal.m_device = name.data();
    terminal.m_slave = FileDescriptor(::open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC));
    if (!terminal.m_slave.isOpen() || !makeRaw(terminal.m_slave))
        return noTerminal(link);
    if (!link.empty()) {
        AXISCOMP_CHECK(placeLink(link, terminal.m_device));
        terminal.m_link = link;
    }
    return terminal;
}

PseudoTerminal& PseudoTerminal::operator=(PseudoTerminal&& other) noexcept
{
    std::swap(m_master, other.m_master);
    std::swap(m_slave, other.m_slave);
    std::swap(m_device, other.m_device);
    std::swap(m_link, other.m_link);
    return *this;
}

PseudoTerminal::~PseudoTerminal()
{
    removeLink();
}

void PseudoTerminal::discardUnread() const
{
    ::tcflush(m_slave.get(), TCIFLUSH);
}

void PseudoTerminal::removeLink() const
{
    if (m_link.empty())
        return;
    std::error_code error; // another terminal may have the name by now
    if (std::filesystem::read_symlink(m_link, error) == m_device && !error)
        std::filesystem::remove(m_link, error);
}

} // namespace axiscomp::drivecomm
