// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/serial/command_handler.h"

#include "drivecomm/serial/serial_codec.h"

#include <algorithm>

namespace axiscomp::drivecomm {

namespace {

tl::unexpected<Error> wrong(Text reason)
{
    return fail(ErrorCode::DriveRejected, {{"reason", std::move(reason)}});
}

std::string counted(std::size_t count)
{
    return "ok " + std::to_string(count);
}

SerialReplyLines linesOf(Result<SerialReplyLines> lines)
{
    return lines ? *std::move(lines) : CommandHandler::refused(lines.error());
}

} // namespace

bool CommandHandler::isWrite(const std::vector<std::string>& words)
{
    return words.front() == "set" || words.front() == "put";
}

SerialReplyLines CommandHandler::refused(const Error& error)
{
    return {serialError(error)};
}

SerialReplyLines CommandHandler::rejected(Text reason)
{
    return refused({ErrorCode::DriveRejected, {{"reason", std::move(reason)}}, {}});
}

SerialReplyLines CommandHandler::garbled(const std::string& message)
{
    return {"error " + std::string(serialBadCrc) + " " + serialQuoted(message)};
}

std::string CommandHandler::bootLine() const
{
    const DriveIdentity identity = m_drive.identity();
    return std::string(serialBootWord) + " " + serialQuoted(identity.name) + " "
        + std::to_string(identity.serialNumber);
}

SerialReplyLines CommandHandler::answer(const std::vector<std::string>& words) const
{
    const std::string& request = words.front();
    const auto arguments = std::span(words).subspan(1);
    if (request == "identify" && arguments.empty())
        return {"ok " + serialIdentity(m_drive.identity(), m_drive.profile().name)};
    if (request == "get")
        return linesOf(get(arguments));
    if (request == "set") {
        const auto done = set(arguments);
        return done ? SerialReplyLines{"ok"} : refused(done.error());
    }
    if (request == "list" && arguments.empty())
        return list();
    if (request == "tree")
        return linesOf(tree(arguments));
    if (request == "address")
        return linesOf(addresses(arguments));
    return rejected(
        AXISCOMP_TEXT("Error", "{request} is not a request; these are: {known}")
            .with("request", request)
            .with("known",
                std::vector<std::string>{"identify", "get PATH...", "set PATH VALUE...", "list",
                    "put PATH SIZE CRC32", "take PATH", "tree PREFIX [FIRST]", "address PATH..."}));
}

Result<std::vector<RegisterReading>> CommandHandler::read(std::span<const std::string> paths) const
{
    if (paths.empty() || paths.size() > mostSerialReads)
        return wrong(AXISCOMP_TEXT("Error", "name 1 to {most} registers, not {count}")
                         .with("most", mostSerialReads)
                         .with("count", paths.size()));
    return m_drive.readRegisters({paths.begin(), paths.end()});
}

Result<SerialReplyLines> CommandHandler::get(std::span<const std::string> paths) const
{
    AXISCOMP_TRY(const auto readings, read(paths));
    SerialReplyLines lines{counted(readings.size())};
    for (const RegisterReading& reading : readings)
        lines.push_back(serialReading(reading));
    return lines;
}

Result<SerialReplyLines> CommandHandler::addresses(std::span<const std::string> paths) const
{
    AXISCOMP_TRY(const auto readings, read(paths));
    SerialReplyLines lines{counted(readings.size())};
    for (const RegisterReading& reading : readings)
        lines.push_back(std::to_string(reading.address));
    return lines;
}

Result<void> CommandHandler::set(std::span<const std::string> words) const
{
    if (words.empty() || words.size() % 2 != 0 || words.size() / 2 > mostSerialWrites)
        return wrong(AXISCOMP_TEXT("Error", "name 1 to {most} registers, each with its value")
                         .with("most", mostSerialWrites));
    std::vector<std::string> paths;
    for (std::size_t i = 0; i < words.size(); i += 2)
        paths.push_back(words[i]);
    AXISCOMP_TRY(const auto readings, m_drive.readRegisters(paths));
    std::vector<RegisterWrite> writes;
    for (std::size_t i = 0; i < readings.size(); ++i) {
        const RegisterReading& reading = readings[i];
        auto value = registerValueFromText(reading.type, words[2 * i + 1]);
        if (!value)
            return wrong(AXISCOMP_TEXT("Error", "{place}: {problem}")
                             .with("place", reading.path)
                             .with("problem", textOf(value.error())));
        writes.push_back({reading.path, *std::move(value)});
    }
    return m_drive.writeRegisters(writes);
}

SerialReplyLines CommandHandler::list() const
{
    const auto files = m_drive.listFiles();
    SerialReplyLines lines{counted(files.size())};
    for (const DriveFile& file : files)
        lines.push_back(serialFile(file));
    return lines;
}

Result<SerialReplyLines> CommandHandler::tree(std::span<const std::string> words) const
{
    const auto first = words.size() == 2 ? parseSerialNumber(words[1]) : std::optional(0U);
    if (words.empty() || words.size() > 2 || !first)
        return wrong(AXISCOMP_TEXT("Error", "write {request}; \"\" is everything")
                         .with("request", Verbatim{"tree PREFIX [FIRST]"}));
    const auto readings = m_drive.readTree(normalisedPath(words[0]));
    const std::size_t begin = std::min<std::size_t>(*first, readings.size());
    const std::size_t count = std::min(readings.size() - begin, serialTreePage);
    SerialReplyLines lines{counted(count) + " " + std::to_string(readings.size())};
    for (std::size_t i = begin; i < begin + count; ++i)
        lines.push_back(serialTreeLine(readings[i]));
    return lines;
}

Result<CommandHandler::Put> CommandHandler::beginPut(const std::vector<std::string>& words) const
{
    const auto size = words.size() == 4 ? parseSerialNumber(words[2]) : std::nullopt;
    const auto crc = words.size() == 4 ? parseSerialNumber(words[3], 16) : std::nullopt;
    if (!size || !crc)
        return wrong(AXISCOMP_TEXT("Error", "write {request}, the CRC in hexadecimal digits")
                         .with("request", Verbatim{"put PATH SIZE CRC32"}));
    const auto files = m_drive.listFiles();
    const auto file = std::ranges::find(files, words[1], &DriveFile::path);
    if (file == files.end())
        return fail(ErrorCode::UnknownFile, {{"path", words[1]}});
    if (*size > file->maximumSize)
        return fail(ErrorCode::TooLargeForSlot,
            {{"reason",
                AXISCOMP_TEXT("Error", "{path} can have {most} bytes, not {size}")
                    .with("path", file->path)
                    .with("most", file->maximumSize)
                    .with("size", *size)}});
    return Put{file->path, *size, *crc, file->maximumSize};
}

SerialReplyLines CommandHandler::endPut(const Put& put, ByteView file) const
{
    if (file.size() != put.size)
        return garbled("announced were " + std::to_string(put.size) + " bytes, "
            + std::to_string(file.size()) + " came; nothing was stored");
    if (crc32(file) != put.crc)
        return garbled("the CRC-32 of what came is " + serialCrc32(crc32(file)) + ", announced was "
            + serialCrc32(put.crc) + "; nothing was stored");
    const auto done = m_drive.upload(put.path, file);
    return done ? SerialReplyLines{"ok"} : refused(done.error());
}

Result<Bytes> CommandHandler::take(const std::vector<std::string>& words) const
{
    if (words.size() != 2)
        return wrong(
            AXISCOMP_TEXT("Error", "write {request}").with("request", Verbatim{"take PATH"}));
    return m_drive.download(words[1]);
}

} // namespace axiscomp::drivecomm
