// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace axiscomp::drivecomm {

struct HttpReply {
    int status = 0;
    std::string contentType; ///< lower case, without parameters
    std::string location;
    std::string retryAfter;
    bool hasEnd = false; ///< the reply said itself where its body ends
    std::string body;
};

/// Reads one HTTP/1.x reply (RFC 9112) from bytes as they come, whatever they are. Interim replies
/// are skipped; memory is bounded by bodyLimit and a fixed limit for the head.
class HttpReplyParser {
public:
    explicit HttpReplyParser(std::uint64_t bodyLimit);

    enum class State { Incomplete, Complete, Failed };
    [[nodiscard]] State state() const { return m_state; }
    /// Takes bytes until the reply is complete or fails. More than the Content-Length that it
    /// announced is a failure of a complete one, too.
    void feed(std::string_view bytes);
    /// The connection has ended, which may be the end of the body.
    void end();

    /// The reply's own status once its head is there, else 0.
    [[nodiscard]] int status() const { return m_inBody ? m_reply.status : 0; }
    /// The length of the body when it was announced.
    [[nodiscard]] std::optional<std::uint64_t> announced() const { return m_length; }
    [[nodiscard]] std::uint64_t received() const { return m_reply.body.size(); }
    /// Of a complete reply: the connection can take another request.
    [[nodiscard]] bool keepsConnection() const { return m_keepsConnection && !m_hasSurplus; }
    /// Of a failed one: what was expected, and the beginning of what came instead.
    [[nodiscard]] const Text& expected() const { return m_expected; }
    [[nodiscard]] std::string_view found() const { return m_found; }

    /// Of a complete one; leaves the parser empty.
    [[nodiscard]] HttpReply take() { return std::move(m_reply); }

private:
    enum class Step { StatusLine, Field, Body, ChunkSize, ChunkData, ChunkEnd, Trailer };
    void takeLine(std::string_view line);
    void takeStatusLine(std::string_view line);
    void takeField(std::string_view line);
    void takeChunkSize(std::string_view line);
    void endHead();
    [[nodiscard]] std::size_t takeBody(std::string_view bytes);
    void fail(Text expected, std::string_view found);

    std::uint64_t m_bodyLimit;
    State m_state = State::Incomplete;
    Step m_step = Step::StatusLine;
    HttpReply m_reply;
    std::string m_line; ///< begun, not ended
    std::size_t m_headSize = 0;
    std::optional<std::uint64_t> m_length; ///< Content-Length, where it tells the body's end
    std::uint64_t m_left = 0; ///< of the body, or of the chunk
    bool m_isChunked = false;
    bool m_inBody = false;
    bool m_keepsConnection = true;
    bool m_hasSurplus = false;
    Text m_expected;
    std::string m_found;
};

} // namespace axiscomp::drivecomm
