// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/web/request_handler.h"

#include "core/base/bytes.h"
#include "drivecomm/codec/error_json.h"
#include "drivecomm/codec/json_parsing.h"
#include "drivecomm/virtualdrive/web/pages.h"
#include "drivecomm/web/directory_listing.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace axiscomp::drivecomm {

namespace {

const FormField* fieldNamed(const WebRequest& request, const std::string& name)
{
    const auto place = std::ranges::find(request.fields, name, &FormField::name);
    return place == request.fields.end() ? nullptr : &*place;
}

/// As a person may type it: with blanks around, with a slash in front.
std::string typedPath(std::string path)
{
    const auto isBlank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
    while (!path.empty() && isBlank(path.back()))
        path.pop_back();
    const auto first = std::ranges::find_if_not(path, isBlank);
    path.erase(path.begin(), first);
    if (path.starts_with('/'))
        path.erase(0, 1);
    return path;
}

std::string entityTag(ByteView bytes)
{
    std::array<char, 8> hex{};
    const auto end = std::to_chars(hex.data(), hex.data() + hex.size(), crc32(bytes), 16).ptr;
    return '"' + std::string(hex.data(), end) + '-' + std::to_string(bytes.size()) + '"';
}

} // namespace

PageFrame RequestHandler::frame() const
{
    const DriveIdentity identity = m_drive.identity();
    return {identity.name, std::to_string(identity.serialNumber), m_profile.web.directory,
        m_profile.web.transfer, m_profile.web.registers + "?prefix="};
}

bool RequestHandler::isRegisterPath(const std::string& path) const
{
    return path == m_profile.web.registers || path.starts_with(m_profile.web.registers + "/");
}

Form RequestHandler::formFor(const WebRequest& request) const
{
    const bool isForProgram = isRegisterPath(request.path) && request.method != "POST";
    return preferredForm(request.accept, isForProgram ? Form::Json : Form::Html);
}

WebReply RequestHandler::refusal(const WebRequest& request, const Error& error) const
{
    return refusal(request, error, httpStatus(error.code));
}

WebReply RequestHandler::refusal(const WebRequest& request, const Error& error, int status) const
{
    WebReply reply = formFor(request) == Form::Json
        ? jsonReply(errorJson(error), status)
        : htmlReply(errorPage(frame(), sentence(error), pageBefore(request)), status);
    if (const auto seconds = error.context.integer("seconds"))
        reply.headers.emplace_back("Retry-After", std::to_string(*seconds));
    return reply;
}

WebReply RequestHandler::notAllowed(const WebRequest& request, const std::string& methods) const
{
    WebReply reply = refusal(
        request, rejected(request.path + " takes " + methods + ", not " + request.method), 405);
    reply.headers.emplace_back("Allow", methods);
    return reply;
}

WebReply RequestHandler::answer(const WebRequest& request) const
{
    if (request.isTooLarge)
        return refusal(request,
            {ErrorCode::TooLargeForSlot,
                {{"reason",
                    AXISCOMP_TEXT("Error",
                        "the request has more bytes than the largest that the drive takes")}},
                {}});
    if (request.isMalformed)
        return refusal(request, rejected("the body is not what its Content-Type says"), 400);
    const WebPaths& web = m_profile.web;
    const bool isGet = request.method == "GET";
    if (request.path == "/")
        return isGet ? showStart(request) : notAllowed(request, "GET");
    if (request.path == web.directory)
        return isGet ? showDirectory(request) : notAllowed(request, "GET");
    if (request.path == web.transfer) {
        if (request.method == "POST")
            return transfer(request);
        return isGet ? showTransfer() : notAllowed(request, "GET, POST");
    }
    if (request.path.starts_with(web.files))
        return isGet ? sendFile(request) : notAllowed(request, "GET");
    if (isRegisterPath(request.path))
        return answerRegisters(request);
    return refusal(request, {ErrorCode::UnknownFile, {{"path", request.path}}, {}});
}

WebReply RequestHandler::showStart(const WebRequest&) const
{
    StartPage start;
    if (const auto error = m_drive.readRegisters({m_profile.registers.driveError}))
        start.driveError = toText(error->front().value);
    const int axes = m_drive.identity().axes;
    for (int axis = 0; axis < axes; ++axis) {
        std::vector<std::string> paths;
        for (int n = 0; n < m_profile.registers.axisNameWords; ++n)
            paths.push_back(expandPath(m_profile.registers.axisName, {axis, {}, n}));
        std::vector<std::int32_t> words;
        if (const auto readings = m_drive.readRegisters(paths)) {
            for (const RegisterReading& each : *readings)
                if (const auto* word = std::get_if<std::int32_t>(&each.value))
                    words.push_back(*word);
        }
        start.axisNames.push_back(unpackName(words));
    }
    return htmlReply(startPage(frame(), m_profile, start));
}

WebReply RequestHandler::showDirectory(const WebRequest& request) const
{
    const auto files = m_drive.listFiles();
    if (formFor(request) == Form::Json)
        return jsonReply(directoryJson(files));
    return htmlReply(directoryPage(frame(), m_profile, files));
}

WebReply RequestHandler::showTransfer() const
{
    return htmlReply(transferPage(frame(), m_profile, m_drive.listFiles()));
}

WebReply RequestHandler::transfer(const WebRequest& request) const
{
    if (request.contentType != "multipart/form-data")
        return refusal(request, rejected("the Transfer form is sent as multipart/form-data"), 415);
    const FormField* path = fieldNamed(request, m_profile.web.transferPathField);
    const FormField* file = fieldNamed(request, m_profile.web.transferFileField);
    if (!path || typedPath(path->value).empty())
        return refusal(request,
            rejected("name the file in the drive (field " + m_profile.web.transferPathField + ")"));
    if (!file || (file->isFile && file->fileName.empty() && file->value.empty()))
        return refusal(request,
            rejected("select a file from the PC (field " + m_profile.web.transferFileField + ")"));
    const std::string name = typedPath(path->value);
    if (const auto done = m_drive.upload(name, asBytes(file->value)); !done)
        return refusal(request, done.error());
    const DriveFile taken{name, static_cast<std::uint32_t>(file->value.size()), 0};
    if (formFor(request) == Form::Json)
        return jsonReply("{\"path\":" + jsonString(taken.path)
            + ",\"size\":" + std::to_string(taken.size) + "}\n");
    return htmlReply(transferDonePage(frame(), m_profile, taken));
}

WebReply RequestHandler::sendFile(const WebRequest& request) const
{
    const std::string path = request.path.substr(m_profile.web.files.size());
    const auto bytes = m_drive.download(path);
    if (!bytes)
        return refusal(request, bytes.error());
    WebReply reply;
    reply.headers = {{"ETag", entityTag(*bytes)},
        {"Content-Disposition",
            "attachment; filename=\"" + path.substr(path.rfind('/') + 1) + "\""}};
    if (request.ifNoneMatch == entityTag(*bytes)) {
        reply.status = 304;
        return reply;
    }
    reply.contentType = "application/octet-stream";
    reply.body = asText(*bytes);
    return reply;
}

} // namespace axiscomp::drivecomm
