// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/http/http_reply_parser.h"

#include "drivecomm/http/percent_encoding.h"

#include <algorithm>
#include <charconv>

namespace axiscomp::drivecomm {

namespace {

constexpr std::size_t mostHead = 64 * 1024;
constexpr std::size_t mostFound = 256;
constexpr std::string_view version = "HTTP/1.";

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

std::optional<std::uint64_t> number(std::string_view text, int base)
{
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(value)
                                                                    : std::nullopt;
}

Text atMost(std::uint64_t bytes)
{
    return AXISCOMP_TEXT("Error", "at most {size} bytes").with("size", bytes);
}

bool hasNoBody(int status)
{
    return status == 204 || status == 304 || status == 101;
}

/// What a line may begin with, as long as it is not complete.
bool mayBeStatusLine(std::string_view begun)
{
    return begun.substr(0, version.size()) == version.substr(0, begun.size());
}

} // namespace

HttpReplyParser::HttpReplyParser(std::uint64_t bodyLimit) : m_bodyLimit(bodyLimit) { }

void HttpReplyParser::fail(Text expected, std::string_view found)
{
    m_state = State::Failed;
    m_expected = std::move(expected);
    m_found = found.substr(0, mostFound);
}

void HttpReplyParser::feed(std::string_view bytes)
{
    while (!bytes.empty() && m_state == State::Incomplete) {
        if (m_step == Step::Body || m_step == Step::ChunkData) {
            bytes.remove_prefix(takeBody(bytes));
            continue;
        }
        const std::size_t end = bytes.find('\n');
        const std::string_view piece = bytes.substr(0, end);
        m_headSize += piece.size() + (end == std::string_view::npos ? 0 : 1);
        m_line += piece.substr(0, mostHead);
        if (m_step == Step::StatusLine && !mayBeStatusLine(m_line))
            return fail(AXISCOMP_TEXT("Error", "an HTTP reply"),
                m_line + std::string(bytes.substr(piece.size(), mostFound)));
        if (m_headSize > mostHead)
            return fail(AXISCOMP_TEXT("Error", "a head of at most 64 KiB"), m_line);
        if (end == std::string_view::npos)
            return;
        bytes.remove_prefix(end + 1);
        std::string line;
        line.swap(m_line);
        if (line.ends_with('\r'))
            line.pop_back();
        takeLine(line);
    }
    if (bytes.empty())
        return;
    m_hasSurplus = true;
    if (m_state == State::Complete && m_length) // the length may be wrong, and a file cut
        fail(
            AXISCOMP_TEXT("Error", "nothing after the bytes that Content-Length announces"), bytes);
}

void HttpReplyParser::takeLine(std::string_view line)
{
    switch (m_step) {
    case Step::StatusLine:
        return takeStatusLine(line);
    case Step::Field:
        return line.empty() ? endHead() : takeField(line);
    case Step::ChunkSize:
        return takeChunkSize(line);
    case Step::ChunkEnd:
        m_step = Step::ChunkSize;
        return line.empty() ? void() : fail(AXISCOMP_TEXT("Error", "the end of a chunk"), line);
    case Step::Trailer:
        if (line.empty())
            m_state = State::Complete;
        return;
    case Step::Body:
    case Step::ChunkData:
        return;
    }
}

void HttpReplyParser::takeStatusLine(std::string_view line)
{
    // "HTTP/1.1 200" and perhaps a reason
    const std::string_view rest = line.substr(std::min(version.size(), line.size()));
    const bool isStatusLine = rest.size() >= 5 && isDigit(rest[0]) && rest[1] == ' '
        && std::ranges::all_of(rest.substr(2, 3), isDigit) && rest[2] != '0'
        && (rest.size() == 5 || rest[5] == ' ');
    if (!isStatusLine)
        return fail(AXISCOMP_TEXT("Error", "the status line of an HTTP reply"), line);
    m_reply = {};
    m_length.reset();
    m_isChunked = false;
    m_keepsConnection = rest[0] != '0';
    m_reply.status = static_cast<int>(number(rest.substr(2, 3), 10).value_or(0));
    m_step = Step::Field;
}

void HttpReplyParser::takeField(std::string_view line)
{
    if (line.front() == ' ' || line.front() == '\t')
        return; // goes on with a field that matters to nobody here, or is given up anyway
    const std::size_t colon = line.find(':');
    if (colon == 0 || colon == std::string_view::npos)
        return fail(AXISCOMP_TEXT("Error", "a header field of an HTTP reply"), line);
    const std::string name = lowerCase(line.substr(0, colon));
    const std::string_view value = withoutBlanks(line.substr(colon + 1));
    if (name == "content-length") {
        const auto length = number(value, 10);
        if (!length || (m_length && m_length != length))
            return fail(AXISCOMP_TEXT("Error", "one Content-Length"), line);
        m_length = length;
    } else if (name == "transfer-encoding") {
        if (lowerCase(value) != "chunked")
            return fail(AXISCOMP_TEXT("Error", "no Transfer-Encoding but chunked"), line);
        m_isChunked = true;
    } else if (name == "content-encoding") {
        if (lowerCase(value) != "identity")
            return fail(AXISCOMP_TEXT("Error", "no Content-Encoding but identity"), line);
    } else if (name == "connection") {
        m_keepsConnection =
            m_keepsConnection && lowerCase(value).find("close") == std::string::npos;
    } else if (name == "age") {
        if (number(value, 10).value_or(0) > 0)
            return fail(AXISCOMP_TEXT("Error",
                            "an answer of the drive itself and not one that a cache or proxy in "
                            "between has kept; connect to the drive without it"),
                line);
    } else if (name == "content-type") {
        m_reply.contentType = mediaType(value);
    } else if (name == "location") {
        m_reply.location = value;
    } else if (name == "retry-after") {
        m_reply.retryAfter = value;
    }
}

void HttpReplyParser::endHead()
{
    const int status = m_reply.status;
    const bool isInterim = status >= 100 && status < 200 && status != 101;
    if (isInterim) {
        m_step = Step::StatusLine;
        m_headSize = 0;
        return;
    }
    m_inBody = true;
    if (m_isChunked)
        m_length.reset();
    if (hasNoBody(status))
        m_length.reset();
    m_reply.hasEnd = hasNoBody(status) || m_isChunked || m_length;
    m_left = m_length.value_or(0);
    if (m_length.value_or(0) > m_bodyLimit)
        return fail(atMost(m_bodyLimit), "Content-Length: " + std::to_string(*m_length));
    if (hasNoBody(status) || m_length == std::uint64_t{0})
        m_state = State::Complete;
    else
        m_step = m_isChunked ? Step::ChunkSize : Step::Body;
    m_headSize = 0;
}

void HttpReplyParser::takeChunkSize(std::string_view line)
{
    const auto size = number(withoutBlanks(line.substr(0, line.find(';'))), 16);
    if (!size)
        return fail(AXISCOMP_TEXT("Error", "the size of a chunk"), line);
    m_headSize = 0;
    m_left = *size;
    m_step = *size == 0 ? Step::Trailer : Step::ChunkData;
}

std::size_t HttpReplyParser::takeBody(std::string_view bytes)
{
    const bool endsWithConnection = m_step == Step::Body && !m_length;
    const std::size_t count = endsWithConnection
        ? bytes.size()
        : static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size(), m_left));
    if (count > m_bodyLimit - m_reply.body.size()) {
        fail(atMost(m_bodyLimit), m_reply.body + std::string(bytes.substr(0, mostFound)));
        return count;
    }
    m_reply.body.append(bytes.substr(0, count));
    if (endsWithConnection)
        return count;
    m_left -= count;
    if (m_left == 0 && m_step == Step::Body)
        m_state = State::Complete;
    else if (m_left == 0)
        m_step = Step::ChunkEnd;
    return count;
}

void HttpReplyParser::end()
{
    if (m_state == State::Incomplete && m_step == Step::Body && !m_length) {
        m_keepsConnection = false;
        m_state = State::Complete;
    }
}

} // namespace axiscomp::drivecomm
