// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/codec/error_json.h"

#include "core/text/utf8.h"
#include "drivecomm/codec/json_parsing.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace axiscomp::drivecomm {

namespace {

struct Row {
    ErrorCode code;
    int status;
};

constexpr std::array rows{
    Row{ErrorCode::DriveRejected, 400},
    Row{ErrorCode::Unauthorized, 401},
    Row{ErrorCode::UnknownRegister, 404},
    Row{ErrorCode::UnknownFile, 404},
    Row{ErrorCode::NotAllowedNow, 409},
    Row{ErrorCode::TooLargeForSlot, 413},
    Row{ErrorCode::TableRefused, 422},
    Row{ErrorCode::FlashWear, 503},
};

constexpr std::size_t longestText = 1000; ///< bytes of what a drive may say in one place
constexpr std::string_view unnamed = "no reason given";

std::string textOf(const nlohmann::json& object, const char* key)
{
    const auto place = object.find(key);
    if (place == object.end() || !place->is_string())
        return {};
    return std::string(cutAtCharacter(place->get_ref<const std::string&>(), longestText));
}

} // namespace

int httpStatus(ErrorCode code)
{
    const auto row = std::ranges::find(rows, code, &Row::code);
    return row == rows.end() ? 400 : row->status;
}

std::string driveMessage(const Error& error)
{
    const Argument* const reason = error.context.find("reason");
    return reason ? reason->english() : sentence(error);
}

std::string errorJson(const Error& error)
{
    std::string json = "{\"error\":{\"code\":" + jsonString(errorName(error.code))
        + ",\"message\":" + jsonString(driveMessage(error));
    if (const auto seconds = error.context.integer("seconds"))
        json += ",\"retryAfterSeconds\":" + std::to_string(*seconds);
    for (const char* key : {"path", "nearest"})
        if (const std::string value = error.context.english(key); !value.empty())
            json += ",\"" + std::string(key) + "\":" + jsonString(value);
    return json + "}}\n";
}

std::optional<ErrorCode> driveErrorNamed(std::string_view name)
{
    const auto row = std::ranges::find(rows, name, [](const Row& r) { return errorName(r.code); });
    return row == rows.end() ? std::nullopt : std::optional(row->code);
}

std::optional<Error> parseErrorJson(std::string_view json)
{
    const nlohmann::json document = parseJson(json);
    const auto error = document.is_object() ? document.find("error") : document.end();
    if (!document.is_object() || error == document.end() || !error->is_object())
        return std::nullopt;
    const std::string code = textOf(*error, "code");
    const std::string message = textOf(*error, "message");
    if (code.empty() && message.empty())
        return std::nullopt;
    Error result;
    result.code = driveErrorNamed(code).value_or(ErrorCode::DriveRejected);
    result.context.set(
        "reason", !message.empty() ? message : (code.empty() ? std::string(unnamed) : code));
    for (const char* key : {"path", "nearest"})
        if (const std::string value = textOf(*error, key); !value.empty())
            result.context.set(key, value);
    const auto wait = error->find("retryAfterSeconds");
    if (wait != error->end() && wait->is_number_unsigned()
        && wait->get<std::uint64_t>() < 1'000'000)
        result.context.set("seconds", wait->get<std::uint64_t>());
    result.detail = code;
    return result;
}

} // namespace axiscomp::drivecomm
