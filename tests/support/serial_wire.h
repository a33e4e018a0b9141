// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/file_descriptor.h"
#include "drivecomm/virtualdrive/serial/pseudo_terminal.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <functional>
#include <mutex>
#include <random>
#include <string>
#include <thread>

namespace axiscomp::test {

/// A serial port of this computer with something else than a drive behind it, on a thread of its
/// own: answer is given what comes, and what it returns is sent back.
class SerialStranger {
public:
    explicit SerialStranger(std::function<std::string(const std::string&)> answer)
        : m_answer(std::move(answer))
    {
        m_thread = std::thread([this] { run(); });
    }
    ~SerialStranger()
    {
        const std::uint64_t one = 1;
        [[maybe_unused]] const ssize_t written = ::write(m_ending.get(), &one, sizeof one);
        m_thread.join();
    }

    [[nodiscard]] std::string url() const { return "serial:" + m_terminal.device(); }
    [[nodiscard]] std::string device() const { return m_terminal.device(); }
    [[nodiscard]] std::string heard() const
    {
        const std::scoped_lock lock(m_mutex);
        return m_heard;
    }

private:
    void run()
    {
        const int master = m_terminal.master().get();
        while (true) {
            std::array<pollfd, 2> polled{{{m_ending.get(), POLLIN, 0}, {master, POLLIN, 0}}};
            ::poll(polled.data(), polled.size(), -1);
            if (polled[0].revents != 0)
                return;
            std::array<char, 4096> buffer{};
            const ssize_t size = ::read(master, buffer.data(), buffer.size());
            if (size <= 0)
                continue;
            const std::string came(buffer.data(), static_cast<std::size_t>(size));
            {
                const std::scoped_lock lock(m_mutex);
                m_heard += came;
            }
            const std::string reply = m_answer(came);
            [[maybe_unused]] const ssize_t sent = ::write(master, reply.data(), reply.size());
        }
    }

    drivecomm::PseudoTerminal m_terminal{drivecomm::PseudoTerminal::open({}).value()};
    FileDescriptor m_ending{::eventfd(0, EFD_CLOEXEC)};
    std::function<std::string(const std::string&)> m_answer;
    mutable std::mutex m_mutex;
    std::string m_heard;
    std::thread m_thread;
};

/// A serial port that leads to another one over a bad cable: one in so many bytes of either
/// direction arrives as something else.
class NoisyCable {
public:
    NoisyCable(const std::string& device, std::uint32_t oneIn, std::uint32_t seed)
        : m_far(::open(device.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC))
        , m_random(seed)
        , m_hit(1.0 / oneIn)
    {
        m_thread = std::thread([this] { run(); });
    }
    ~NoisyCable()
    {
        const std::uint64_t one = 1;
        [[maybe_unused]] const ssize_t written = ::write(m_ending.get(), &one, sizeof one);
        m_thread.join();
    }

    [[nodiscard]] std::string url() const { return "serial:" + m_near.device(); }
    [[nodiscard]] int flips() const { return m_flips; }

private:
    void run()
    {
        while (true) {
            std::array<pollfd, 3> polled{{{m_ending.get(), POLLIN, 0},
                {m_near.master().get(), POLLIN, 0}, {m_far.get(), POLLIN, 0}}};
            ::poll(polled.data(), polled.size(), -1);
            if (polled[0].revents != 0)
                return;
            if (polled[1].revents != 0)
                pass(m_near.master(), m_far);
            if (polled[2].revents != 0)
                pass(m_far, m_near.master());
        }
    }
    void pass(const FileDescriptor& from, const FileDescriptor& to)
    {
        std::array<char, 1024> buffer{};
        const ssize_t size = ::read(from.get(), buffer.data(), buffer.size());
        for (ssize_t i = 0; i < size; ++i) {
            if (!m_hit(m_random))
                continue;
            char& byte = buffer[static_cast<std::size_t>(i)];
            byte = static_cast<char>(byte ^ static_cast<char>(1 + m_random() % 255));
            ++m_flips;
        }
        for (ssize_t sent = 0; sent < size;) {
            const ssize_t count =
                ::write(to.get(), buffer.data() + sent, static_cast<std::size_t>(size - sent));
            if (count > 0) {
                sent += count;
                continue;
            }
            std::array<pollfd, 2> polled{{{m_ending.get(), POLLIN, 0}, {to.get(), POLLOUT, 0}}};
            ::poll(polled.data(), polled.size(), -1);
            if (polled[0].revents != 0)
                return;
        }
    }

    drivecomm::PseudoTerminal m_near{drivecomm::PseudoTerminal::open({}).value()};
    FileDescriptor m_far;
    FileDescriptor m_ending{::eventfd(0, EFD_CLOEXEC)};
    std::mt19937 m_random;
    std::bernoulli_distribution m_hit;
    std::atomic<int> m_flips = 0;
    std::thread m_thread;
};

} // namespace axiscomp::test
