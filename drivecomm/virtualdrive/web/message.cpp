// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/web/message.h"

#include "drivecomm/http/percent_encoding.h"

#include <charconv>

namespace axiscomp::drivecomm {

namespace {

/// Calls take with each part of text between separators.
template <typename Take> void split(std::string_view text, char separator, Take take)
{
    while (true) {
        const std::size_t end = text.find(separator);
        take(text.substr(0, end));
        if (end == std::string_view::npos)
            return;
        text.remove_prefix(end + 1);
    }
}

/// How specific a range of Accept is for type ("text/html"); 0 when it does not match.
int specificity(std::string_view range, std::string_view type)
{
    if (range == type)
        return 3;
    if (range == "*/*")
        return 1;
    const std::string_view group = type.substr(0, type.find('/') + 1);
    return range.size() == group.size() + 1 && range.starts_with(group) && range.ends_with('*') ? 2
                                                                                                : 0;
}

/// RFC 9110, 12.5.1: the most specific range counts.
double quality(std::string_view accept, std::string_view type)
{
    int best = 0;
    double result = 0.0;
    split(accept, ',', [&](std::string_view entry) {
        const std::size_t semicolon = entry.find(';');
        const int match = specificity(mediaType(entry), type);
        if (match <= best)
            return;
        best = match;
        result = 1.0;
        if (semicolon == std::string_view::npos)
            return;
        split(entry.substr(semicolon + 1), ';', [&](std::string_view parameter) {
            parameter = withoutBlanks(parameter);
            if (!parameter.starts_with("q="))
                return;
            double q = 0.0;
            const auto [end, error] =
                std::from_chars(parameter.data() + 2, parameter.data() + parameter.size(), q);
            result = error == std::errc() ? q : 0.0;
        });
    });
    return result;
}

} // namespace

Error rejected(std::string reason)
{
    return {ErrorCode::DriveRejected, {{"reason", std::move(reason)}}, {}};
}

std::string pageBefore(const WebRequest& request)
{
    const std::string origin = "://" + request.host + "/";
    const std::size_t place = request.referer.find(origin);
    if (request.host.empty() || (place != 4 && place != 5)) // http, https
        return "/";
    // "//name" would lead to another site.
    const std::size_t path = request.referer.find_first_not_of('/', place + origin.size());
    return "/" + (path == std::string::npos ? "" : request.referer.substr(path));
}

WebReply htmlReply(std::string page, int status)
{
    return {status, "text/html; charset=utf-8", std::move(page), {}};
}

WebReply jsonReply(std::string json, int status)
{
    return {status, "application/json", std::move(json), {}};
}

Form preferredForm(std::string_view accept, Form otherwise)
{
    const double html = quality(accept, "text/html");
    const double json = quality(accept, "application/json");
    if (html == json)
        return otherwise;
    return html > json ? Form::Html : Form::Json;
}

std::vector<std::pair<std::string, std::string>> parseUrlEncoded(std::string_view text)
{
    std::vector<std::pair<std::string, std::string>> result;
    split(text, '&', [&result](std::string_view part) {
        if (part.empty())
            return;
        const std::size_t equals = part.find('=');
        const std::string_view value =
            equals == std::string_view::npos ? std::string_view() : part.substr(equals + 1);
        result.emplace_back(formDecoded(part.substr(0, equals)), formDecoded(value));
    });
    return result;
}

} // namespace axiscomp::drivecomm
