// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/codec/register_json.h"
#include "drivecomm/virtualdrive/web/register_page.h"
#include "drivecomm/virtualdrive/web/request_handler.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>

namespace axiscomp::drivecomm {

namespace {

/// The value of a DimSource as a person enters it: an address, a path, or a URI
/// tam://mc/<drive>/<path>. nullopt for a path.
std::optional<std::uint32_t> addressFrom(std::string_view text)
{
    const bool isHex = text.starts_with("0x") || text.starts_with("0X");
    const std::string_view digits = text.substr(isHex ? 2 : 0);
    std::uint32_t address = 0;
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), address, isHex ? 16 : 10);
    if (error != std::errc() || end != digits.data() + digits.size())
        return std::nullopt;
    return address;
}

/// The path within the drive.
std::string withoutDrive(const std::string& uri)
{
    constexpr std::string_view scheme = "tam://mc/";
    if (!uri.starts_with(scheme))
        return uri;
    const std::size_t slash = uri.find('/', scheme.size());
    return slash == std::string::npos ? std::string() : uri.substr(slash + 1);
}

} // namespace

WebReply RequestHandler::answerRegisters(const WebRequest& request) const
{
    const bool isOne = request.path != m_profile.web.registers;
    if (request.method == "PUT")
        return putRegisters(request);
    if (isOne)
        return notAllowed(request, "PUT");
    if (request.method == "POST")
        return setByForm(request);
    return request.method == "GET" ? showRegisters(request) : notAllowed(request, "GET, PUT, POST");
}

WebReply RequestHandler::showRegisters(const WebRequest& request) const
{
    std::vector<std::string> paths;
    std::optional<std::string> prefix;
    for (const auto& [key, value] : request.query) {
        const bool isFirstPrefix = key == "prefix" && !prefix;
        if (key == "path")
            paths.push_back(normalisedPath(value));
        else if (isFirstPrefix)
            prefix = normalisedPath(value);
        else
            return refusal(request, rejected("the query takes path=... or one prefix=..."));
    }
    if (prefix.has_value() == !paths.empty())
        return refusal(request, rejected("ask with path=... once or more, or with one prefix=..."));
    if (prefix)
        return showTree(request, *prefix);
    const auto readings = m_drive.readRegisters(paths);
    if (!readings)
        return refusal(request, readings.error());
    if (formFor(request) == Form::Json)
        return jsonReply(readingsJson(*readings));
    const auto rows = rowsFor(*readings);
    return htmlReply(registerListPage(frame(), m_profile, rows, suggestedSources()));
}

WebReply RequestHandler::showTree(const WebRequest& request, const std::string& prefix) const
{
    const auto readings = m_drive.readTree(prefix);
    if (formFor(request) == Form::Json)
        return jsonReply(readingsJson(readings));
    std::vector<std::string> folders;
    std::vector<RegisterReading> own;
    const std::size_t begin = prefix.empty() ? 0 : prefix.size() + 1;
    for (const RegisterReading& each : readings) {
        const std::size_t slash =
            each.path.size() < begin ? std::string::npos : each.path.find('/', begin);
        if (slash == std::string::npos)
            own.push_back(each);
        else if (std::string folder = each.path.substr(0, slash);
                 std::ranges::find(folders, folder) == folders.end())
            folders.push_back(std::move(folder));
    }
    if (readings.empty())
        return refusal(request, {ErrorCode::UnknownRegister, {{"path", prefix}}, {}});
    return htmlReply(
        registerTreePage(frame(), m_profile, prefix, folders, rowsFor(own), suggestedSources()));
}

WebReply RequestHandler::putRegisters(const WebRequest& request) const
{
    if (request.contentType != "application/json")
        return refusal(request, rejected("registers are written as application/json"), 415);
    std::vector<RequestedWrite> requested;
    if (request.path == m_profile.web.registers) {
        auto parsed = parseWrites(request.body);
        if (!parsed)
            return refusal(request, parsed.error());
        requested = std::move(*parsed);
    } else {
        auto value = parseWrittenValue(request.body);
        if (!value)
            return refusal(request, value.error());
        const std::string path = request.path.substr(m_profile.web.registers.size());
        requested.push_back({normalisedPath(path), std::move(*value)});
    }
    if (requested.empty() || requested.size() > DriveLink::maximumWrites)
        return refusal(request,
            rejected("1 to " + std::to_string(DriveLink::maximumWrites)
                + " registers are written at once, not " + std::to_string(requested.size())));
    std::vector<std::string> paths;
    for (const RequestedWrite& each : requested)
        paths.push_back(each.path);
    const auto readings = m_drive.readRegisters(paths); // for their types, which never change
    if (!readings)
        return refusal(request, readings.error());
    std::vector<RegisterWrite> writes;
    for (std::size_t i = 0; i < requested.size(); ++i) {
        auto value = typedValue((*readings)[i].type, requested[i].value);
        if (!value)
            return refusal(request,
                rejected(paths[i] + " is of type " + (*readings)[i].type + ", which "
                    + describe(requested[i].value) + " is not"));
        writes.push_back({paths[i], std::move(*value)});
    }
    if (const auto written = m_drive.writeRegisters(writes); !written)
        return refusal(request, written.error());
    return {204, {}, {}, {}};
}

/// What a browser can send: the form of a register page. Each field is named after its register;
/// empty ones are left out.
WebReply RequestHandler::setByForm(const WebRequest& request) const
{
    if (request.contentType != "application/x-www-form-urlencoded")
        return refusal(request,
            rejected("the form of a register page is sent as application/x-www-form-urlencoded; "
                     "programs use PUT with JSON"),
            415);
    std::vector<RegisterWrite> writes;
    std::vector<std::string> paths;
    for (const FormField& field : request.fields) {
        if (field.value.empty())
            continue;
        const auto reading = m_drive.readRegisters({normalisedPath(field.name)});
        if (!reading)
            return refusal(request, reading.error());
        auto value = enteredValue(reading->front(), field.value);
        if (!value)
            return refusal(request, value.error());
        paths.push_back(reading->front().path);
        writes.push_back({reading->front().path, std::move(*value)});
    }
    if (writes.empty())
        return refusal(request, rejected("no new value was filled in"));
    if (const auto written = m_drive.writeRegisters(writes); !written)
        return refusal(request, written.error());
    const auto readings = m_drive.readRegisters(paths);
    if (!readings)
        return refusal(request, readings.error());
    if (formFor(request) == Form::Json)
        return jsonReply(readingsJson(*readings));
    return htmlReply(registersSetPage(frame(), rowsFor(*readings), pageBefore(request)));
}

Result<RegisterValue> RequestHandler::enteredValue(
    const RegisterReading& reading, const std::string& text) const
{
    if (isSource(reading.path)) {
        if (const auto address = addressFrom(text))
            return RegisterValue{*address};
        AXISCOMP_TRY(auto source, m_drive.readRegisters({normalisedPath(withoutDrive(text))}));
        return RegisterValue{source.front().address};
    }
    auto value = registerValueFromText(reading.type, text);
    if (!value)
        return fail(
            ErrorCode::DriveRejected, {{"reason", reading.path + ": " + sentence(value.error())}});
    return value;
}

bool RequestHandler::isSource(const std::string& path) const
{
    const int axes = m_drive.identity().axes;
    for (int axis = 0; axis < axes; ++axis)
        for (int n = 1; n <= 3; ++n)
            if (path == normalisedPath(expandPath(m_profile.registers.source, {axis, {}, n})))
                return true;
    return false;
}

std::vector<std::string> RequestHandler::suggestedSources() const
{
    std::vector<std::string> sources;
    for (const std::string& pattern : m_profile.sourceShortlist) {
        if (pattern.find("{axis}") == std::string::npos) {
            sources.push_back(pattern);
            continue;
        }
        const int axes = m_drive.identity().axes;
        for (int axis = 0; axis < axes; ++axis)
            sources.push_back(expandPath(pattern, {axis, {}, {}}));
    }
    return sources;
}

std::vector<RegisterRow> RequestHandler::rowsFor(std::span<const RegisterReading> readings) const
{
    std::vector<RegisterRow> rows;
    std::map<std::uint32_t, std::string> pathOfAddress;
    for (const RegisterReading& reading : readings) {
        const RegisterEntry entry = m_drive.registerEntry(reading.path);
        RegisterRow row{reading, entry.isWritable, entry.names, isSource(reading.path), {}};
        const auto* address = std::get_if<std::uint32_t>(&reading.value);
        if (row.isSource && address && *address != 0) {
            if (pathOfAddress.empty())
                for (const RegisterReading& each : m_drive.readTree(""))
                    pathOfAddress.emplace(each.address, each.path);
            const auto place = pathOfAddress.find(*address);
            row.sourcePath = place == pathOfAddress.end() ? "" : place->second;
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

} // namespace axiscomp::drivecomm
