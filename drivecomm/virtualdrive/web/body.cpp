// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/web/body.h"

#include "drivecomm/http/percent_encoding.h"

namespace axiscomp::drivecomm {

namespace {

/// So much is read and thrown away for a client that would not notice a refusal before it has sent
/// everything.
constexpr std::uint64_t mostDrained = std::uint64_t{64} << 20;
constexpr std::size_t mostFields = 64;

} // namespace

WebRequest requestWithoutBody(const httplib::Request& from)
{
    WebRequest request;
    request.method = from.method == "HEAD" ? "GET" : from.method;
    request.path = from.path;
    const std::size_t question = from.target.find('?');
    if (question != std::string::npos)
        request.query =
            parseUrlEncoded(std::string_view(from.target)
                                .substr(question + 1, from.target.find('#') - question - 1));
    request.contentType = mediaType(from.get_header_value("Content-Type"));
    request.accept = from.get_header_value("Accept");
    request.authorization = from.get_header_value("Authorization");
    request.host = from.get_header_value("Host");
    request.origin = from.get_header_value("Origin");
    request.fetchSite = from.get_header_value("Sec-Fetch-Site");
    request.referer = from.get_header_value("Referer");
    request.ifNoneMatch = from.get_header_value("If-None-Match");
    return request;
}

BodyEnd readBody(const httplib::Request& from, const httplib::ContentReader& contentReader,
    std::uint64_t limit, WebRequest& request)
{
    std::uint64_t size = 0;
    bool givenUp = false;
    const auto take = [&](std::string& target, const char* data, std::size_t count) {
        size += count;
        if (size > mostDrained)
            givenUp = true;
        else if (size > limit)
            request.isTooLarge = true;
        else
            target.append(data, count);
        return !givenUp;
    };
    bool read = false;
    if (from.is_multipart_form_data()) {
        read = contentReader(
            [&](const httplib::MultipartFormData& part) {
                request.fields.push_back({part.name, {}, part.filename,
                    !part.filename.empty() || !part.content_type.empty()});
                return request.fields.size() <= mostFields;
            },
            [&](const char* data, std::size_t count) {
                return take(request.fields.back().value, data, count);
            });
    } else {
        read = contentReader(
            [&](const char* data, std::size_t count) { return take(request.body, data, count); });
    }
    if (givenUp)
        return BodyEnd::Endless;
    if (!read)
        return BodyEnd::Malformed;
    if (request.contentType == "application/x-www-form-urlencoded" && !request.isTooLarge) {
        for (auto& [name, value] : parseUrlEncoded(request.body))
            request.fields.push_back({std::move(name), std::move(value), {}, false});
        request.body.clear();
    }
    return BodyEnd::Complete;
}

} // namespace axiscomp::drivecomm
