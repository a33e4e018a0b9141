// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/local_file.h"

#include "core/base/parallel.h"
#include "core/io/large_memory.h"
#include "core/io/system.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <new>
#include <span>
#include <string>
#include <string_view>

namespace axiscomp {

namespace {

using system::FileKind;

tl::unexpected<Error> notWritable(const std::filesystem::path& file, const std::error_code& error)
{
    Text reason = fileErrorReason(error);
    if (error == std::errc::no_such_file_or_directory)
        reason = AXISCOMP_TEXT("Error", "the folder {folder} does not exist")
                     .with("folder", std::filesystem::absolute(file).parent_path().string());
    return fail(ErrorCode::FileNotWritable, {{"file", file.string()}, {"reason", reason}});
}

tl::unexpected<Error> notWritable(const std::filesystem::path& file, std::errc error)
{
    return notWritable(file, std::make_error_code(error));
}

tl::unexpected<Error> notReadable(const std::filesystem::path& file, const std::error_code& error)
{
    return fail(
        ErrorCode::FileNotReadable, {{"file", file.string()}, {"reason", fileErrorReason(error)}});
}

tl::unexpected<Error> notReadable(const std::filesystem::path& file, std::errc error)
{
    return notReadable(file, std::make_error_code(error));
}

Result<void> writeDirectly(const std::filesystem::path& file, ByteView bytes)
{
    auto device = system::File::open(file, system::File::Purpose::Write);
    std::error_code error = device ? device->write(bytes) : device.error();
    if (!error)
        error = device->close();
    if (error)
        return notWritable(file, error);
    return {};
}

system::Outcome<system::FileState> stateOf(const system::Outcome<system::File>& file)
{
    if (!file)
        return tl::unexpected(file.error());
    return file->state();
}

/// Several threads read pieces of the bytes. False: one of them came out short, or there was an
/// error.
bool readTogether(const system::File& file, std::size_t threads, std::span<std::byte> bytes)
{
    constexpr std::size_t piece = std::size_t{1} << 20U;
    std::atomic<bool> isWhole = true;
    shareWork((bytes.size() + piece - 1) / piece, threads, [&](std::size_t index) {
        const std::size_t offset = index * piece;
        const auto part = bytes.subspan(offset, std::min(piece, bytes.size() - offset));
        if (file.readAt(offset, part) != part.size())
            isWhole = false;
    });
    return isWhole;
}

/// Reads to the end, or one byte more than the maximum. A file may be longer than it says
/// (expected) while somebody writes to it, or shorter.
template <typename Content>
std::error_code readAll(const system::File& file, std::uint64_t expected, std::uint64_t maximumSize,
    std::size_t threads, Content& content)
{
    constexpr std::uint64_t firstBlock = 4096;
    content.resize(static_cast<std::size_t>(std::max(firstBlock, expected + 1)));
    std::size_t filled = 0;
    if (readTogether(file, threads, {content.data(), static_cast<std::size_t>(expected)}))
        filled = static_cast<std::size_t>(expected);
    while (filled <= maximumSize) {
        if (filled == content.size())
            content.resize(static_cast<std::size_t>(
                std::min(maximumSize + 1, 2 * std::uint64_t{content.size()})));
        const auto count = file.readAt(filled, {content.data() + filled, content.size() - filled});
        if (!count)
            return count.error();
        filled += *count;
        if (filled < content.size())
            break;
    }
    content.resize(filled);
    return {};
}

/// Straight into what is asked for: a second copy would be memory for nothing.
template <typename Content>
Result<Content> load(
    const std::filesystem::path& file, std::uint64_t maximumSize, std::size_t threads)
try {
    const auto opened = system::File::open(file, system::File::Purpose::Read);
    const auto state = stateOf(opened);
    if (!state)
        return notReadable(file, state.error());
    if (state->kind == FileKind::Folder)
        return notReadable(file, std::errc::is_a_directory);
    if (state->kind != FileKind::Ordinary)
        return fail(ErrorCode::FileNotReadable,
            {{"file", file.string()},
                {"reason", AXISCOMP_TEXT("Error", "it is a pipe or a device, not a file")}});

    const auto tooLarge = [&](const Argument& size) {
        return fail(ErrorCode::FileTooLarge,
            {{"file", file.string()}, {"size", size}, {"limit", maximumSize}});
    };
    if (state->size > maximumSize)
        return tooLarge(state->size);

    // One byte more is asked for to see that nothing follows.
    const std::uint64_t readable =
        std::min<std::uint64_t>(maximumSize, std::numeric_limits<std::int64_t>::max());
    Content content;
    if (const auto error = readAll(*opened, state->size, readable, threads, content))
        return notReadable(file, error);
    if (content.size() > maximumSize)
        return tooLarge(AXISCOMP_TEXT("Error", "more than {size}").with("size", maximumSize));
    return content;
} catch (const std::bad_alloc&) {
    return notReadable(file, std::errc::not_enough_memory);
}

} // namespace

Text fileErrorReason(const std::error_code& error)
{
    using Reason = std::pair<std::errc, TextPattern>;
    static const std::array reasons{
        Reason{std::errc::no_such_file_or_directory, AXISCOMP_TEXT("Error", "it does not exist")},
        Reason{std::errc::permission_denied, AXISCOMP_TEXT("Error", "no permission")},
        Reason{std::errc::operation_not_permitted, AXISCOMP_TEXT("Error", "no permission")},
        Reason{std::errc::no_space_on_device, AXISCOMP_TEXT("Error", "the disk is full")},
        Reason{std::errc::read_only_file_system,
            AXISCOMP_TEXT("Error", "the file system is read-only")},
        Reason{std::errc::is_a_directory, AXISCOMP_TEXT("Error", "it is a folder")},
        Reason{std::errc::not_a_directory,
            AXISCOMP_TEXT("Error", "a part of the path is not a folder")},
        Reason{std::errc::filename_too_long, AXISCOMP_TEXT("Error", "the name is too long")},
        Reason{std::errc::too_many_symbolic_link_levels,
            AXISCOMP_TEXT("Error", "its symbolic links lead in a circle")},
        Reason{std::errc::file_too_large,
            AXISCOMP_TEXT("Error", "it would be larger than a file may be here")},
        Reason{std::errc::device_or_resource_busy,
            AXISCOMP_TEXT(
                "Error", "another program is using it; try again when that one has finished")},
        Reason{std::errc::io_error, AXISCOMP_TEXT("Error", "the disk reports an error")},
        Reason{std::errc::not_enough_memory, AXISCOMP_TEXT("Error", "there is not enough memory")}};
    const auto reason =
        std::ranges::find_if(reasons, [&](const Reason& one) { return error == one.first; });
    if (reason != reasons.end())
        return reason->second;
    if (system::isQuotaUsedUp(error))
        return AXISCOMP_TEXT("Error", "the disk quota is used up");
    return Verbatim{system::messageOf(error)};
}

Result<void> saveFile(const std::filesystem::path& file, ByteView bytes)
{
    // What the path leads to decides, before any link is followed by name: "/dev/stdout" is a link
    // to something that has no name.
    const auto there = system::stateOf(file);
    if (there && there->kind == FileKind::Folder)
        return notWritable(file, std::errc::is_a_directory);
    if (there && there->kind != FileKind::Ordinary)
        return writeDirectly(file, bytes);
    const auto target = system::endOfLinks(file);
    if (!target)
        return notWritable(file, target.error());
    if (!target->has_filename())
        return notWritable(file, std::errc::is_a_directory);
    if (const std::error_code error = system::replaceFile(*target, bytes))
        return notWritable(file, error);
    return {};
}

void FileContent::resize(std::size_t size)
{
    if (size > m_size) {
        auto larger = makeLarge<std::byte>(size);
        std::copy_n(m_bytes.get(), m_size, larger.get());
        m_bytes = std::move(larger);
    }
    m_size = size;
}

Result<FileContent> loadContent(
    const std::filesystem::path& file, std::uint64_t maximumSize, std::size_t threads)
{
    return load<FileContent>(file, maximumSize, threads);
}

Result<Bytes> loadFile(const std::filesystem::path& file, std::uint64_t maximumSize)
{
    return load<Bytes>(file, maximumSize, 1);
}

Bytes loadBeginning(const std::filesystem::path& file, std::size_t mostBytes)
{
    const auto opened = system::File::open(file, system::File::Purpose::Read);
    const auto state = stateOf(opened);
    if (!state || state->kind != FileKind::Ordinary)
        return {};
    Bytes bytes(mostBytes);
    bytes.resize(opened->readAt(0, bytes).value_or(0));
    return bytes;
}

Result<void> checkOrdinaryFile(const std::filesystem::path& file)
{
    const auto there = system::linkStateOf(file);
    if (!there || there->kind == FileKind::Ordinary)
        return {};
    return fail(ErrorCode::FileNotReadable,
        {{"file", file.string()},
            {"reason", AXISCOMP_TEXT("Error", "it is not an ordinary file; move it away")}});
}

Result<Bytes> loadOrdinaryFile(const std::filesystem::path& file, std::uint64_t maximumSize)
{
    AXISCOMP_CHECK(checkOrdinaryFile(file));
    return loadFile(file, maximumSize);
}

Result<void> removeFile(const std::filesystem::path& file)
{
    const std::error_code error = system::removeFile(file);
    if (!error || error == std::errc::no_such_file_or_directory)
        return {};
    return notWritable(file, error);
}

bool isTemporaryFile(const std::filesystem::path& file)
{
    const std::string name = file.filename().string();
    return name.starts_with(system::temporaryPrefix) && name.ends_with(system::temporarySuffix);
}

std::filesystem::path pathFromText(std::string_view text)
{
    return system::pathFromText(text);
}

} // namespace axiscomp
