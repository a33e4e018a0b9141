// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/web/web_drive_link.h"

#include "drivecomm/codec/json_parsing.h"
#include "drivecomm/codec/register_json.h"
#include "drivecomm/http/http_client.h"
#include "drivecomm/http/multipart_form.h"
#include "drivecomm/http/percent_encoding.h"
#include "drivecomm/web/directory_listing.h"
#include "drivecomm/web/html_table.h"
#include "drivecomm/web/reply_check.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <utility>

namespace axiscomp::drivecomm {

namespace {

constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20;
constexpr std::uint64_t maximumDownload = 16 * mebibyte;
constexpr std::uint64_t largestTree = 16 * mebibyte;
constexpr std::size_t longestTarget = 7000; ///< servers take 8 KiB with room for the rest
constexpr int mostAxes = 1024;

/// For the error of a drive that does not say which of several registers it lacks.
Argument nameOf(std::span<const std::string> paths)
{
    if (paths.empty())
        return Verbatim{};
    const std::string first = normalisedPath(paths.front());
    if (paths.size() == 1)
        return first;
    return AXISCOMP_COUNTED("Error", "{path}, or one of {count} others asked for with it",
        "{path}, or another one asked for with it")
        .with("path", first)
        .with("count", paths.size() - 1);
}

class WebDriveLink final : public DriveLink {
public:
    WebDriveLink(const DriveEndpoint& endpoint, const DriveProfile& profile,
        CertificateCheck certificateCheck)
        : m_endpoint(displayText(endpoint))
        , m_givesPassword(!endpoint.user.empty() || !endpoint.password.empty())
        , m_profile(profile)
        , m_http(endpoint, std::move(certificateCheck))
    {
    }

    std::string endpoint() const override { return m_endpoint; }
    Result<DriveIdentity> identify(const Exchange& exchange) override;
    Result<std::vector<RegisterReading>> readRegisters(
        std::span<const std::string> paths, const Exchange& exchange) override;
    Result<std::vector<RegisterReading>> readTree(
        const std::string& prefix, const Exchange& exchange) override;
    Result<void> writeRegisters(
        std::span<const RegisterWrite> writes, const Exchange& exchange) override;
    Result<std::vector<DriveFile>> listFiles(const Exchange& exchange) override;
    Result<Bytes> download(const std::string& path, const Exchange& exchange) override;
    Result<void> upload(const std::string& path, ByteView bytes, const Exchange& exchange) override;

private:
    [[nodiscard]] Result<DriveIdentity> identifyAny(const ExchangeDeadline& running);
    void expect(std::int32_t serial, bool isChecked);
    [[nodiscard]] Result<void> checkDrive(const ExchangeDeadline& running);
    [[nodiscard]] Result<HttpReply> ask(
        const HttpRequest& request, const AskedFor& asked, const ExchangeDeadline& running);
    [[nodiscard]] Result<std::vector<RegisterReading>> read(
        std::span<const std::string> paths, const ExchangeDeadline& running);
    [[nodiscard]] Result<std::vector<RegisterReading>> readOnce(
        std::span<const std::string> paths, const ExchangeDeadline& running);
    [[nodiscard]] Result<std::string> readName(
        const ExchangeDeadline& running, std::int32_t& serial);
    [[nodiscard]] Result<int> countAxes(const ExchangeDeadline& running);
    [[nodiscard]] Result<bool> hasAxis(int axis, const ExchangeDeadline& running);
    [[nodiscard]] std::string axisProbe(int axis) const
    {
        return expandPath(m_profile.registers.axisName, {axis, {}, 0});
    }
    [[nodiscard]] tl::unexpected<Error> failed(Error error) const
    {
        if (error.code == ErrorCode::Unauthorized && m_givesPassword)
            error.context.set("given", Verbatim{"yes"});
        return fail(addEndpoint(std::move(error), m_endpoint));
    }

    std::string m_endpoint;
    bool m_givesPassword;
    const DriveProfile& m_profile;
    HttpClient m_http;
    std::optional<std::int32_t> m_expected; ///< serial number of the drive that was identified
};

Result<HttpReply> WebDriveLink::ask(
    const HttpRequest& request, const AskedFor& asked, const ExchangeDeadline& running)
{
    auto reply = m_http.send(request, running);
    if (!reply)
        return reply;
    if (auto status = checkStatus(*reply, asked); !status)
        return failed(std::move(status.error()));
    return reply;
}

Result<DriveIdentity> WebDriveLink::identify(const Exchange& exchange)
{
    const auto before = std::exchange(m_expected, {});
    m_http.takeAnyConnection();
    auto identity = identifyAny(ExchangeDeadline(exchange));
    if (!identity && !m_expected && before)
        expect(*before, false);
    return identity;
}

/// From here on another drive than this one is refused, also while the axes are counted.
void WebDriveLink::expect(std::int32_t serial, bool isChecked)
{
    m_expected = serial;
    m_http.checkConnections(
        [this](const ExchangeDeadline& running) { return checkDrive(running); }, isChecked);
}

/// A new connection may lead to another drive than the one that was identified.
Result<void> WebDriveLink::checkDrive(const ExchangeDeadline& running)
{
    const std::vector<std::string> path{m_profile.registers.serialNumber};
    AXISCOMP_TRY(const auto readings, readOnce(path, running));
    const auto* found = std::get_if<std::int32_t>(&readings.front().value);
    if (found && *found == *m_expected)
        return {};
    return fail(ErrorCode::OtherDrive,
        {{"expected", *m_expected}, {"found", toText(readings.front().value)}});
}

Result<DriveIdentity> WebDriveLink::identifyAny(const ExchangeDeadline& running)
{
    DriveIdentity identity;
    auto name = readName(running, identity.serialNumber);
    if (!name)
        return fail(std::move(name.error()));
    identity.name = std::move(*name);
    expect(identity.serialNumber, true);
    AXISCOMP_TRY(const auto axes, countAxes(running));
    identity.axes = axes;
    return identity;
}

Result<std::string> WebDriveLink::readName(const ExchangeDeadline& running, std::int32_t& serial)
{
    std::vector<std::string> paths{m_profile.registers.serialNumber};
    for (int n = 0; n < m_profile.registers.deviceNameWords; ++n)
        paths.push_back(expandPath(m_profile.registers.deviceName, {{}, {}, n}));
    AXISCOMP_TRY(const auto readings, read(paths, running));
    std::vector<std::int32_t> words;
    for (const RegisterReading& reading : readings) {
        const auto* word = std::get_if<std::int32_t>(&reading.value);
        if (!word) {
            return failed(notExpected(
                AXISCOMP_TEXT("Error", "{path} of type Int32").with("path", reading.path),
                reading.type + " " + toText(reading.value))
                              .value());
        }
        words.push_back(*word);
    }
    serial = words.front();
    words.erase(words.begin());
    return unpackName(words);
}

/// An axis is there when its AxisName is. All probes of a request fail together, and the error
/// names the first register that is missing, which is the number of axes.
Result<int> WebDriveLink::countAxes(const ExchangeDeadline& running)
{
    for (int first = 0; first < mostAxes; first += static_cast<int>(maximumReads)) {
        std::vector<std::string> probes;
        for (int axis = first; axis < first + static_cast<int>(maximumReads); ++axis)
            probes.push_back(axisProbe(axis));
        const auto readings = read(probes, running);
        if (readings)
            continue;
        if (readings.error().code != ErrorCode::UnknownRegister)
            return fail(readings.error());
        const auto missing =
            std::ranges::find(probes, normalisedPath(readings.error().context.english("path")));
        if (missing != probes.end())
            return first + static_cast<int>(missing - probes.begin());
        // The drive does not say which: halve.
        int low = first;
        int high = first + static_cast<int>(maximumReads);
        while (low < high) {
            const int middle = low + (high - low) / 2;
            AXISCOMP_TRY(const auto found, hasAxis(middle, running));
            (found ? low : high) = found ? middle + 1 : middle;
        }
        return low;
    }
    return fail(ErrorCode::Protocol,
        {{"endpoint", m_endpoint}, {"expected", AXISCOMP_TEXT("Error", "at most 1024 axes")},
            {"quote", AXISCOMP_TEXT("Error", "more")}});
}

Result<bool> WebDriveLink::hasAxis(int axis, const ExchangeDeadline& running)
{
    const std::vector<std::string> probe{axisProbe(axis)};
    const auto reading = read(probe, running);
    if (reading)
        return true;
    if (reading.error().code == ErrorCode::UnknownRegister)
        return false;
    return fail(reading.error());
}

Result<std::vector<RegisterReading>> WebDriveLink::readRegisters(
    std::span<const std::string> paths, const Exchange& exchange)
{
    return read(paths, ExchangeDeadline(exchange));
}

Result<std::vector<RegisterReading>> WebDriveLink::read(
    std::span<const std::string> paths, const ExchangeDeadline& running)
{
    std::vector<RegisterReading> all;
    all.reserve(paths.size());
    while (!paths.empty()) {
        std::size_t count = 0;
        std::size_t length = 0;
        while (count < std::min(paths.size(), maximumReads) && length < longestTarget)
            length += percentEncoded(paths[count++]).size() + 6;
        if (length >= longestTarget && count > 1)
            --count;
        auto readings = readOnce(paths.first(count), running);
        if (!readings)
            return readings;
        std::ranges::move(*readings, std::back_inserter(all));
        paths = paths.subspan(count);
    }
    return all;
}

Result<std::vector<RegisterReading>> WebDriveLink::readOnce(
    std::span<const std::string> paths, const ExchangeDeadline& running)
{
    HttpRequest request;
    request.target = m_profile.web.registers;
    for (const std::string& path : paths) {
        request.target += request.target.find('?') == std::string::npos ? "?path=" : "&path=";
        request.target += percentEncoded(normalisedPath(path));
    }
    AXISCOMP_TRY(
        const auto reply, ask(request, {ErrorCode::UnknownRegister, nameOf(paths)}, running));
    const Text expected = AXISCOMP_COUNTED(
        "Error", "a JSON array of {count} registers", "a JSON array of one register")
                              .with("count", paths.size());
    if (auto json = checkJson(reply, expected); !json)
        return failed(std::move(json.error()));
    auto readings = parseReadings(reply.body);
    if (!readings)
        return failed(std::move(readings.error()));
    const bool asAsked = std::ranges::equal(*readings, paths,
        [](const RegisterReading& r, const std::string& p) { return r.path == normalisedPath(p); });
    if (!asAsked)
        return failed(notExpected(
            AXISCOMP_COUNTED("Error", "a JSON array of {count} registers, in the order asked for",
                "a JSON array of the one register asked for")
                .with("count", paths.size()),
            reply.body)
                          .value());
    return readings;
}

Result<std::vector<RegisterReading>> WebDriveLink::readTree(
    const std::string& prefix, const Exchange& exchange)
{
    const ExchangeDeadline running(exchange);
    const std::string root = normalisedPath(prefix);
    HttpRequest request;
    request.target = m_profile.web.registers + "?prefix=" + percentEncoded(root);
    request.replyLimit = largestTree;
    AXISCOMP_TRY(const auto reply, ask(request, {ErrorCode::UnknownRegister, root}, running));
    if (auto json = checkJson(reply, AXISCOMP_TEXT("Error", "a JSON array of registers")); !json)
        return failed(std::move(json.error()));
    auto readings = parseReadings(reply.body);
    if (!readings)
        return failed(std::move(readings.error()));
    for (const RegisterReading& each : *readings) {
        const bool isBelow = root.empty() || each.path == root || each.path.starts_with(root + "/");
        if (!isBelow)
            return failed(notExpected(
                AXISCOMP_TEXT("Error", "registers below {path}").with("path", root), each.path)
                              .value());
    }
    return readings;
}

Result<void> WebDriveLink::writeRegisters(
    std::span<const RegisterWrite> writes, const Exchange& exchange)
{
    const ExchangeDeadline running(exchange);
    std::vector<std::string> paths;
    std::ranges::transform(writes, std::back_inserter(paths), &RegisterWrite::path);
    const std::string json = writesJson(writes);
    HttpRequest request;
    request.method = HttpRequest::Method::Put;
    request.target = m_profile.web.registers;
    request.contentType = "application/json";
    request.body = {asBytes(json)};
    AXISCOMP_TRY(
        const auto reply, ask(request, {ErrorCode::UnknownRegister, nameOf(paths)}, running));
    if (reply.status != 204 && !reply.body.empty())
        return failed(
            notExpected(AXISCOMP_TEXT("Error", "status 204 without a body"), reply.body).value());
    return {};
}

Result<std::vector<DriveFile>> WebDriveLink::listFiles(const Exchange& exchange)
{
    const ExchangeDeadline running(exchange);
    HttpRequest request;
    request.target = m_profile.web.directory;
    request.accept = "application/json, text/html;q=0.5";
    AXISCOMP_TRY(const auto reply, ask(request, {}, running));
    // A page that is cut between two rows looks like one with fewer files.
    if (!reply.hasEnd && reply.contentType != "application/json"
        && lowerCase(reply.body).find("</html") == std::string::npos)
        return failed(notExpected(
            AXISCOMP_TEXT("Error", "a Directory page with its Content-Length, or up to </html>"),
            htmlText(reply.body))
                          .value());
    auto files = reply.contentType == "application/json" ? parseDirectoryJson(reply.body)
                                                         : parseDirectoryPage(reply.body);
    if (!files)
        return failed(std::move(files.error()));
    return files;
}

Result<Bytes> WebDriveLink::download(const std::string& path, const Exchange& exchange)
{
    const ExchangeDeadline running(exchange);
    const TableSlot* slot = m_profile.slotOfFile(path);
    HttpRequest request;
    request.target = m_profile.web.files + percentEncoded(path);
    request.accept = "application/octet-stream, application/json;q=0.5";
    request.replyLimit = slot ? slot->maximumSize : maximumDownload;
    request.reportsProgress = true;
    AXISCOMP_TRY(const auto reply, ask(request, {ErrorCode::UnknownFile, path}, running));
    if (!reply.hasEnd)
        return failed(
            notExpected(AXISCOMP_TEXT("Error", "a file with its Content-Length"), reply.body)
                .value());
    if (reply.contentType == "text/html" || reply.contentType == "application/json")
        return failed(notExpected(
            AXISCOMP_TEXT("Error", "the bytes of {path}").with("path", path), reply.body)
                          .value());
    Bytes bytes(reply.body.size());
    if (!bytes.empty())
        std::memcpy(bytes.data(), reply.body.data(), bytes.size());
    return bytes;
}

Result<void> WebDriveLink::upload(const std::string& path, ByteView bytes, const Exchange& exchange)
{
    const ExchangeDeadline running(exchange);
    const MultipartForm form(
        m_profile.web.transferPathField, path, m_profile.web.transferFileField, path, bytes);
    HttpRequest request;
    request.method = HttpRequest::Method::Post;
    request.target = m_profile.web.transfer;
    request.contentType = form.contentType();
    request.body = form.pieces();
    request.watchedPiece = MultipartForm::filePiece;
    request.reportsProgress = true;
    const auto reply = ask(request, {ErrorCode::UnknownFile, path}, running);
    if (!reply)
        return fail(reply.error());
    return {};
}

} // namespace

std::unique_ptr<DriveLink> makeWebDriveLink(
    const DriveEndpoint& endpoint, const DriveProfile& profile, CertificateCheck certificateCheck)
{
    return std::make_unique<WebDriveLink>(endpoint, profile, std::move(certificateCheck));
}

} // namespace axiscomp::drivecomm
