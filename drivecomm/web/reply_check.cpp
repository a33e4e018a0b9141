// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/web/reply_check.h"

#include "drivecomm/codec/error_json.h"
#include "drivecomm/codec/json_parsing.h"
#include "drivecomm/web/html_table.h"

#include <algorithm>
#include <charconv>
#include <string_view>

namespace axiscomp::drivecomm {

namespace {

std::optional<int> secondsOf(std::string_view retryAfter)
{
    int seconds = 0;
    const auto [end, error] =
        std::from_chars(retryAfter.data(), retryAfter.data() + retryAfter.size(), seconds);
    const bool isNumber =
        error == std::errc() && end == retryAfter.data() + retryAfter.size() && seconds >= 0;
    return isNumber ? std::optional(seconds) : std::nullopt;
}

Text statusText(int status)
{
    return AXISCOMP_TEXT("Error", "HTTP status {status}").with("status", status);
}

tl::unexpected<Error> redirected(const HttpReply& reply)
{
    const TextPattern quote = reply.location.starts_with("https://")
        ? AXISCOMP_TEXT("Error", "a redirect to {address}; give its address with https://")
        : AXISCOMP_TEXT("Error", "a redirect to {address}");
    return fail(ErrorCode::Protocol,
        {{"expected", AXISCOMP_TEXT("Error", "the answer itself")},
            {"quote", quote.with("address", quoteOf(reply.location))}});
}

/// A refusal as a page or without any body: only its status is certain.
Error plainError(const HttpReply& reply, const AskedFor& asked)
{
    const auto seconds = secondsOf(reply.retryAfter);
    const auto code = [&] {
        switch (reply.status) {
        case 401:
            return ErrorCode::Unauthorized;
        case 404:
            return asked.unknown;
        case 409:
            return ErrorCode::NotAllowedNow;
        case 413:
            return ErrorCode::TooLargeForSlot;
        case 422:
            return ErrorCode::TableRefused;
        case 503:
            return !seconds ? ErrorCode::Protocol : ErrorCode::FlashWear;
        default:
            return reply.status >= 400 && reply.status < 500 ? ErrorCode::DriveRejected
                                                             : ErrorCode::Protocol;
        }
    }();
    Error error{code, {}, statusText(reply.status).english()};
    const std::string text = htmlText(std::string_view(reply.body).substr(0, 4096));
    if (code == ErrorCode::Protocol) {
        error.context.set("expected", AXISCOMP_TEXT("Error", "success or a refusal"));
        error.context.set("quote",
            AXISCOMP_TEXT("Error", "HTTP status {status} and {text}")
                .with("status", reply.status)
                .with("text", quoteOf(text)));
    } else if (code == ErrorCode::FlashWear) {
        error.context.set("seconds", *seconds);
    } else {
        error.context.set("reason",
            text.empty() ? statusText(reply.status)
                         : AXISCOMP_TEXT("Error", "HTTP status {status}, {text}")
                               .with("status", reply.status)
                               .with("text", quoteOf(text)));
    }
    return error;
}

} // namespace

Result<void> checkStatus(const HttpReply& reply, const AskedFor& asked)
{
    if (reply.status >= 200 && reply.status < 300)
        return {};
    if (reply.status >= 300 && reply.status < 400)
        return redirected(reply);
    Error error = parseErrorJson(reply.body).value_or(plainError(reply, asked));
    const auto seconds = secondsOf(reply.retryAfter);
    if (error.code == ErrorCode::FlashWear && seconds)
        error.context.setIfMissing("seconds", *seconds);
    const bool isUnknown =
        error.code == ErrorCode::UnknownRegister || error.code == ErrorCode::UnknownFile;
    if (isUnknown)
        error.context.setIfMissing("path", asked.path);
    return fail(std::move(error));
}

Result<void> checkJson(const HttpReply& reply, const Text& expected)
{
    if (reply.contentType == "application/json")
        return {};
    return notExpected(expected, reply.body);
}

Error addEndpoint(Error error, const std::string& endpoint)
{
    error.context.setIfMissing("endpoint", endpoint);
    return error;
}

} // namespace axiscomp::drivecomm
