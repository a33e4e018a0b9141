// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <system_error>

namespace axiscomp {

/// Writes a file so that after a crash or a full disk the old file is whole or the new one is: a
/// temporary file beside it, flushed, and renamed (system::replaceFile says what Windows promises
/// less). A symbolic link is followed and stays; the old file's mode is kept, a new file gets what
/// the umask gives; a read-only file is refused. Devices and pipes ("/dev/stdout") are written to
/// directly. Errors: FileNotWritable.
[[nodiscard]] Result<void> saveFile(const std::filesystem::path& file, ByteView bytes);

/// The bytes of a file. Unlike Bytes, they are not cleared before they are read.
class FileContent {
public:
    [[nodiscard]] ByteView view() const { return {m_bytes.get(), m_size}; }
    [[nodiscard]] std::size_t size() const { return m_size; }
    [[nodiscard]] std::byte* data() { return m_bytes.get(); }
    /// Keeps the bytes up to the smaller size; what follows is anything.
    void resize(std::size_t size);

private:
    std::unique_ptr<std::byte[]> m_bytes;
    std::size_t m_size = 0;
};

/// Pipes and devices are refused: they may have no end. threads: as shareWork has them, for a file
/// of megabytes. Errors: FileNotReadable, FileTooLarge.
[[nodiscard]] Result<FileContent> loadContent(
    const std::filesystem::path& file, std::uint64_t maximumSize, std::size_t threads = 1);

/// The same as Bytes.
[[nodiscard]] Result<Bytes> loadFile(const std::filesystem::path& file, std::uint64_t maximumSize);

/// At most so many bytes from the beginning of an ordinary file; nothing of one that cannot be
/// read.
[[nodiscard]] Bytes loadBeginning(const std::filesystem::path& file, std::size_t mostBytes);

/// Whether this is an ordinary file, or nothing at all: a pipe would be waited for, a device be
/// written to. For files that nobody but this program makes. Errors: FileNotReadable.
[[nodiscard]] Result<void> checkOrdinaryFile(const std::filesystem::path& file);

/// loadFile for such a file. Errors: FileNotReadable, FileTooLarge.
[[nodiscard]] Result<Bytes> loadOrdinaryFile(
    const std::filesystem::path& file, std::uint64_t maximumSize);

/// Deletes a file so that it is gone after a crash too; one that does not exist is no error.
/// Errors: FileNotWritable.
[[nodiscard]] Result<void> removeFile(const std::filesystem::path& file);

/// Whether this is the name of a temporary file of saveFile: those that a crash left behind may be
/// deleted when nobody else writes to the folder.
[[nodiscard]] bool isTemporaryFile(const std::filesystem::path& file);

/// The reason in words, for the context of FileNotReadable and FileNotWritable.
[[nodiscard]] Text fileErrorReason(const std::error_code& error);

/// A path from the text of a command line or a document, which is UTF-8.
[[nodiscard]] std::filesystem::path pathFromText(std::string_view text);

} // namespace axiscomp
