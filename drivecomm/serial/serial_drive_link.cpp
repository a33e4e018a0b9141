// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/serial/serial_drive_link.h"

#include "drivecomm/serial/serial_session.h"

#include <algorithm>
#include <map>

namespace axiscomp::drivecomm {

namespace {

constexpr std::uint64_t maximumTake = std::uint64_t{16} << 20;
constexpr std::size_t mostTreeRegisters = 100'000;

class SerialDriveLink final : public DriveLink {
public:
    SerialDriveLink(const DriveEndpoint& endpoint, const DriveProfile& profile)
        : m_endpoint(displayText(endpoint))
        , m_profile(profile)
        , m_session(endpoint)
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
    [[nodiscard]] Result<std::vector<RegisterReading>> readOnce(
        std::span<const std::string> paths, ExchangeDeadline& running);
    [[nodiscard]] Result<void> learnAddresses(
        std::span<const RegisterReading> readings, ExchangeDeadline& running);
    void forgetOtherDrives();

    std::string m_endpoint;
    const DriveProfile& m_profile;
    SerialSession m_session;
    int m_beginnings = 0;
    /// `get` does not tell them, and they do not change while it is the same drive.
    std::map<std::string, std::uint32_t, std::less<>> m_addresses;
};

void SerialDriveLink::forgetOtherDrives()
{
    if (std::exchange(m_beginnings, m_session.beginnings()) != m_session.beginnings())
        m_addresses.clear();
}

Result<DriveIdentity> SerialDriveLink::identify(const Exchange& exchange)
{
    ExchangeDeadline running(exchange);
    const int before = m_session.beginnings();
    m_session.expectAnyDrive();
    AXISCOMP_CHECK(m_session.begin(running));
    m_addresses.clear(); // somebody may have plugged the cable into another drive
    if (m_session.beginnings() != before) // which has just identified it
        return m_session.identity();
    AXISCOMP_TRY(const auto reply, m_session.ask("identify", SerialSession::Shape::Words, running));
    auto identity = parseSerialIdentity(reply.words);
    if (!identity)
        return m_session.unexpected(
            AXISCOMP_TEXT("Error", "name, serial number, axes and profile"), reply.words);
    m_session.expect(*identity);
    return *std::move(identity);
}

Result<std::vector<RegisterReading>> SerialDriveLink::readRegisters(
    std::span<const std::string> paths, const Exchange& exchange)
{
    ExchangeDeadline running(exchange);
    std::vector<RegisterReading> all;
    all.reserve(paths.size());
    while (!paths.empty()) {
        std::size_t count = 0;
        std::size_t length = 0;
        while (count < std::min(paths.size(), mostSerialReads)
            && length + serialWord(paths[count]).size() < longestSerialLine - 64)
            length += serialWord(paths[count++]).size() + 1;
        auto readings = readOnce(paths.first(std::max<std::size_t>(count, 1)), running);
        if (!readings)
            return readings;
        std::ranges::move(*readings, std::back_inserter(all));
        paths = paths.subspan(readings->size());
    }
    return all;
}

Result<std::vector<RegisterReading>> SerialDriveLink::readOnce(
    std::span<const std::string> paths, ExchangeDeadline& running)
{
    std::string words = "get";
    for (const std::string& path : paths)
        words += " " + serialWord(normalisedPath(path));
    AXISCOMP_TRY(const auto reply, m_session.ask(words, SerialSession::Shape::Lines, running));
    forgetOtherDrives();
    if (reply.lines.size() != paths.size())
        return m_session.unexpected(AXISCOMP_COUNTED("Error", "{count} registers", "one register")
                                        .with("count", paths.size()),
            {std::to_string(reply.lines.size())});
    std::vector<RegisterReading> readings;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        auto reading = parseSerialReading(reply.lines[i]);
        if (!reading)
            return m_session.unexpected(
                AXISCOMP_TEXT("Error", "a type and a value"), reply.lines[i]);
        reading->path = normalisedPath(paths[i]);
        readings.push_back(*std::move(reading));
    }
    AXISCOMP_CHECK(learnAddresses(readings, running));
    for (RegisterReading& reading : readings)
        reading.address = m_addresses.find(reading.path)->second;
    return readings;
}

Result<void> SerialDriveLink::learnAddresses(
    std::span<const RegisterReading> readings, ExchangeDeadline& running)
{
    std::string words = "address";
    std::vector<std::string> unknown;
    for (const RegisterReading& reading : readings) {
        const bool isAsked = std::ranges::find(unknown, reading.path) != unknown.end();
        if (m_addresses.contains(reading.path) || isAsked)
            continue;
        words += " " + serialWord(reading.path);
        unknown.push_back(reading.path);
    }
    if (unknown.empty())
        return {};
    AXISCOMP_TRY(const auto reply, m_session.ask(words, SerialSession::Shape::Lines, running));
    if (reply.lines.size() != unknown.size())
        return m_session.unexpected(AXISCOMP_COUNTED("Error", "{count} addresses", "one address")
                                        .with("count", unknown.size()),
            {std::to_string(reply.lines.size())});
    for (std::size_t i = 0; i < unknown.size(); ++i) {
        const auto& line = reply.lines[i];
        const auto address = line.size() == 1 ? parseSerialNumber(line[0]) : std::nullopt;
        if (!address)
            return m_session.unexpected(AXISCOMP_TEXT("Error", "an address"), line);
        m_addresses[unknown[i]] = *address;
    }
    return {};
}

Result<std::vector<RegisterReading>> SerialDriveLink::readTree(
    const std::string& prefix, const Exchange& exchange)
{
    ExchangeDeadline running(exchange);
    std::vector<RegisterReading> all;
    while (true) {
        const std::string words =
            "tree " + serialWord(normalisedPath(prefix)) + " " + std::to_string(all.size());
        AXISCOMP_TRY(const auto reply, m_session.ask(words, SerialSession::Shape::Lines, running));
        forgetOtherDrives();
        const auto total =
            reply.words.size() == 2 ? parseSerialNumber(reply.words[1]) : std::nullopt;
        if (!total || *total > mostTreeRegisters || *total < all.size() + reply.lines.size())
            return m_session.unexpected(
                AXISCOMP_TEXT("Error", "how many registers there are"), reply.words);
        for (const auto& line : reply.lines) {
            auto reading = parseSerialTreeLine(line);
            if (!reading)
                return m_session.unexpected(
                    AXISCOMP_TEXT("Error", "path, address, type and value"), line);
            m_addresses[reading->path] = reading->address;
            all.push_back(*std::move(reading));
        }
        if (all.size() == *total)
            return all;
        if (reply.lines.empty())
            return m_session.unexpected(
                AXISCOMP_TEXT("Error", "the rest of the registers"), reply.words);
    }
}

Result<void> SerialDriveLink::writeRegisters(
    std::span<const RegisterWrite> writes, const Exchange& exchange)
{
    if (exchange.stop.stop_requested())
        return fail(ErrorCode::Cancelled);
    std::string words = "set";
    for (const RegisterWrite& write : writes)
        words +=
            " " + serialWord(normalisedPath(write.path)) + " " + serialWord(toText(write.value));
    if (writes.empty() || writes.size() > mostSerialWrites || words.size() > longestSerialLine - 64)
        return fail(ErrorCode::DriveRejected,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "the serial link writes 1 to {most} registers at one instant, not {count}")
                    .with("most", mostSerialWrites)
                    .with("count", writes.size())}});
    ExchangeDeadline running(exchange);
    const auto reply = m_session.ask(words, SerialSession::Shape::Words, running);
    if (!reply)
        return fail(reply.error());
    return {};
}

Result<std::vector<DriveFile>> SerialDriveLink::listFiles(const Exchange& exchange)
{
    ExchangeDeadline running(exchange);
    AXISCOMP_TRY(const auto reply, m_session.ask("list", SerialSession::Shape::Lines, running));
    std::vector<DriveFile> files;
    for (const auto& line : reply.lines) {
        auto file = parseSerialFile(line);
        if (!file)
            return m_session.unexpected(
                AXISCOMP_TEXT("Error", "path, size and maximum size"), line);
        files.push_back(*std::move(file));
    }
    return files;
}

Result<Bytes> SerialDriveLink::download(const std::string& path, const Exchange& exchange)
{
    ExchangeDeadline running(exchange);
    const TableSlot* slot = m_profile.slotOfFile(path);
    return m_session.take(path, slot ? slot->maximumSize : maximumTake, running);
}

Result<void> SerialDriveLink::upload(
    const std::string& path, ByteView bytes, const Exchange& exchange)
{
    ExchangeDeadline running(exchange);
    return m_session.put(path, bytes, running);
}

} // namespace

std::unique_ptr<DriveLink> makeSerialDriveLink(
    const DriveEndpoint& endpoint, const DriveProfile& profile)
{
    return std::make_unique<SerialDriveLink>(endpoint, profile);
}

} // namespace axiscomp::drivecomm
