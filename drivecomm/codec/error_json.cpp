// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/codec/error_json.h"

#include "core/text/utf8.h"
#include "drivecomm/codec/json_parsing.h"
#include "drivecomm/codec/text_json.h"

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
/// Room for a text that is deeper than its limit: then the message counts.
constexpr std::size_t deepestErrorJson = 2 + 2 * textJsonNesting;

std::string stringOf(const nlohmann::json& object, const char* key)
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

Text driveMessage(const Error& error)
{
    const Argument* const reason = error.context.find("reason");
    if (!reason)
        return textOf(error);
    const Text* const text = std::get_if<Text>(&reason->value());
    return text ? *text : Verbatim{reason->english()};
}

std::string errorJson(const Error& error)
{
    const Text message = driveMessage(error);
    std::string json = "{\"error\":{\"code\":" + jsonString(errorName(error.code))
        + ",\"message\":" + jsonString(message.english()) + ",\"text\":" + textJson(message);
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
    const nlohmann::json document = parseJson(json, deepestErrorJson);
    const auto error = document.is_object() ? document.find("error") : document.end();
    if (!document.is_object() || error == document.end() || !error->is_object())
        return std::nullopt;
    const std::string code = stringOf(*error, "code");
    const std::string message = stringOf(*error, "message");
    if (code.empty() && message.empty())
        return std::nullopt;
    Error result;
    result.code = driveErrorNamed(code).value_or(ErrorCode::DriveRejected);
    const auto text = error->find("text");
    const auto reason = text == error->end() ? std::nullopt : textFromJson(*text);
    result.context.set(
        "reason", reason ? *reason : Text(Verbatim{message.empty() ? code : message}));
    for (const char* key : {"path", "nearest"})
        if (const std::string value = stringOf(*error, key); !value.empty())
            result.context.set(key, value);
    const auto wait = error->find("retryAfterSeconds");
    if (wait != error->end() && wait->is_number_unsigned()
        && wait->get<std::uint64_t>() < 1'000'000)
        result.context.set("seconds", wait->get<std::uint64_t>());
    result.detail = code;
    return result;
}

} // namespace axiscomp::drivecomm
