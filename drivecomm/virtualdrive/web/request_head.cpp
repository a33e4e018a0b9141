// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/web/request_head.h"

#include "drivecomm/http/percent_encoding.h"

#include <algorithm>
#include <vector>

namespace axiscomp::drivecomm {

namespace {

constexpr std::string_view lineEnd = "\r\n";
constexpr std::size_t mostLengthDigits = 18; // fits 64 bits

struct HeaderField {
    std::string name; ///< lower case
    std::string_view value;
};

bool isTokenChar(char c)
{
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')
        || std::string_view("!#$%&'*+-.^_`|~").find(c) != std::string_view::npos;
}

/// METHOD /path HTTP/1.1
std::optional<HeadFault> requestLineFault(std::string_view line)
{
    const std::size_t methodEnd = std::min(line.find(' '), line.size());
    const std::size_t pathEnd = line.rfind(' ');
    const std::string_view method = line.substr(0, methodEnd);
    if (method.empty() || !std::ranges::all_of(method, isTokenChar) || methodEnd == line.size()
        || pathEnd <= methodEnd + 1 || line[methodEnd + 1] != '/'
        || line.substr(methodEnd + 1, pathEnd - methodEnd - 1).find(' ') != std::string_view::npos)
        return HeadFault{400, "a request begins with METHOD /PATH HTTP/1.1"};
    const std::string_view version = line.substr(pathEnd + 1);
    if (version != "HTTP/1.1" && version != "HTTP/1.0")
        return HeadFault{505, "the only versions of HTTP that are known here are 1.0 and 1.1"};
    return std::nullopt;
}

std::optional<HeadFault> fieldFault(std::string_view line)
{
    const std::size_t colon = line.find(':');
    if (line.front() == ' ' || line.front() == '\t')
        return HeadFault{400, "a header field must not go on in another line"};
    if (colon == 0 || colon == std::string_view::npos
        || !std::ranges::all_of(line.substr(0, colon), isTokenChar))
        return HeadFault{400, "a header field is not NAME: VALUE"};
    return std::nullopt;
}

/// The values of the fields of that name.
std::vector<std::string_view> valuesOf(
    const std::vector<HeaderField>& fields, std::string_view name)
{
    std::vector<std::string_view> values;
    for (const HeaderField& field : fields)
        if (field.name == name)
            values.push_back(field.value);
    return values;
}

std::optional<HeadFault> bodyFault(std::string_view method, const std::vector<HeaderField>& fields)
{
    const auto lengths = valuesOf(fields, "content-length");
    const auto codings = valuesOf(fields, "transfer-encoding");
    if (lengths.size() > 1)
        return HeadFault{400, "there is more than one Content-Length"};
    if (!codings.empty() && !lengths.empty())
        return HeadFault{400, "there is both a Content-Length and a Transfer-Encoding"};
    if (codings.size() > 1 || (codings.size() == 1 && lowerCase(codings.front()) != "chunked"))
        return HeadFault{501, "the only Transfer-Encoding that is known here is chunked"};
    if (!lengths.empty()) {
        const std::string_view length = lengths.front();
        if (length.empty()
            || !std::ranges::all_of(length, [](char c) { return c >= '0' && c <= '9'; }))
            return HeadFault{400, "Content-Length is not a number of bytes"};
        if (length.size() > mostLengthDigits)
            return HeadFault{413, "the request has more bytes than the drive takes"};
    }
    // Nobody reads the body of a GET: its bytes would be taken for the next request.
    const bool hasBody = !codings.empty() || (!lengths.empty() && lengths.front() != "0");
    if (hasBody && (method == "GET" || method == "HEAD" || method == "OPTIONS"))
        return HeadFault{400, "a " + std::string(method) + " has no body"};
    return std::nullopt;
}

} // namespace

std::optional<HeadFault> illegalByte(std::string_view part)
{
    for (std::size_t i = 0; i < part.size(); ++i) {
        const auto byte = static_cast<unsigned char>(part[i]);
        const bool endsLine = byte == '\r' && (i + 1 == part.size() || part[i + 1] == '\n');
        const bool isEnd = byte == '\n' && i > 0 && part[i - 1] == '\r';
        if ((byte < 0x20 && byte != '\t' && !endsLine && !isEnd) || byte == 0x7f)
            return HeadFault{400, "the head of the request has a control character"};
    }
    return std::nullopt;
}

std::optional<HeadFault> headFault(std::string_view head)
{
    const std::size_t firstEnd = std::min(head.find(lineEnd), head.size());
    const std::string_view requestLine = head.substr(0, firstEnd);
    if (auto fault = requestLineFault(requestLine))
        return fault;
    head.remove_prefix(std::min(firstEnd + lineEnd.size(), head.size()));
    std::vector<HeaderField> fields;
    while (!head.empty()) {
        const std::size_t end = std::min(head.find(lineEnd), head.size());
        const std::string_view line = head.substr(0, end);
        if (auto fault = fieldFault(line))
            return fault;
        if (fields.size() == mostHeadFields)
            return HeadFault{
                431, "there are more than " + std::to_string(mostHeadFields) + " header fields"};
        const std::size_t colon = line.find(':');
        fields.push_back({lowerCase(line.substr(0, colon)), withoutBlanks(line.substr(colon + 1))});
        head.remove_prefix(std::min(end + lineEnd.size(), head.size()));
    }
    if (valuesOf(fields, "host").size() > 1)
        return HeadFault{400, "there is more than one Host"};
    return bodyFault(requestLine.substr(0, requestLine.find(' ')), fields);
}

HeadFault endlessHead(std::string_view begin)
{
    const std::string limit = std::to_string(mostHeadBytes);
    if (begin.find(lineEnd) == std::string_view::npos)
        return {414, "the address has more than " + limit + " bytes"};
    return {431, "the header fields have more than " + limit + " bytes"};
}

} // namespace axiscomp::drivecomm
