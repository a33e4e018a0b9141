// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivecomm/virtualdrive/web/request_head.h"

#include <httplib.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace axiscomp::drivecomm {

/// One connection of a server, plain or TLS, that no client can keep waiting: a request must have
/// come, and a reply must have been taken, within a time that grows with its bytes only. The head
/// of a request is read and checked before httplib sees any of it.
class GuardedStream final : public httplib::Stream {
public:
    using Clock = std::chrono::steady_clock;

    /// socket is not closed here; context null: no TLS.
    GuardedStream(int socket, SSL_CTX* context, std::chrono::milliseconds patience);
    ~GuardedStream() override;

    /// The greeting of TLS; true at once without it.
    [[nodiscard]] bool greet();
    /// False when the client has gone or has said nothing.
    [[nodiscard]] bool waitForRequest(std::chrono::milliseconds time);

    struct Head {
        bool isComplete = false; ///< and may be read like the rest
        std::optional<HeadFault> fault; ///< neither: the client has gone, or was too slow
    };
    [[nodiscard]] Head readHead();

    [[nodiscard]] bool is_readable() const override { return true; }
    [[nodiscard]] bool is_writable() const override { return true; }
    ssize_t read(char* data, size_t size) override;
    ssize_t write(const char* data, size_t size) override;
    void get_remote_ip_and_port(std::string& ip, int& port) const override;
    void get_local_ip_and_port(std::string& ip, int& port) const override;
    [[nodiscard]] socket_t socket() const override { return m_socket; }

private:
    /// What one side has had so far of one message.
    struct Progress {
        Clock::time_point start;
        std::uint64_t bytes = 0;
    };
    /// The result of one try: bytes, 0 the end, or what to wait for.
    struct Outcome {
        ssize_t count;
        short event = 0; ///< of poll; 0: there is nothing to wait for
    };
    [[nodiscard]] Outcome tryRead(char* data, std::size_t size);
    [[nodiscard]] Outcome tryWrite(const char* data, std::size_t size);
    [[nodiscard]] Outcome outcomeOfTls(int result) const;
    [[nodiscard]] ssize_t readSome(char* data, std::size_t size);
    [[nodiscard]] bool waitFor(short event, Clock::time_point until) const;
    [[nodiscard]] Clock::time_point deadline(const Progress& progress) const;

    int m_socket;
    std::chrono::milliseconds m_patience;
    std::unique_ptr<SSL, decltype(&SSL_free)> m_tls;
    std::string m_buffer; ///< received; the next byte to read is at m_begin
    std::size_t m_begin = 0;
    Progress m_request;
    std::optional<Progress> m_reply;
};

} // namespace axiscomp::drivecomm
