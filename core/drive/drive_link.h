// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bytes.h"
#include "core/drive/register_value.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace axiscomp {

struct DriveIdentity {
    std::string name;
    std::int32_t serialNumber = 0;
    int axes = 0;

    friend bool operator==(const DriveIdentity&, const DriveIdentity&) = default;
};

/// A row of the drive's directory; size 0 = empty.
struct DriveFile {
    std::string path; ///< "tables/small1.TAMtbl"
    std::uint32_t size = 0;
    std::uint32_t maximumSize = 0;

    friend bool operator==(const DriveFile&, const DriveFile&) = default;
};

/// How long one exchange may take, and how it is watched and stopped.
struct Exchange {
    std::chrono::milliseconds timeout{5000}; ///< with retries, without a slow line's own time
    std::stop_token stop; ///< Cancelled as soon as it is set
    std::function<void(std::uint64_t done, std::uint64_t total)> progress; ///< bytes of a transfer
};

/// The port to a drive: small, blocking, one exchange a call. Implementations are used from one
/// thread. Errors common to all: NotConnected, ConnectionLost, Timeout, Protocol, Unauthorized,
/// CertificateRejected, Cancelled, DriveRejected. After ConnectionLost or Timeout of a write or an
/// upload it is unknown whether the drive acted: read back. Only what is safe to repeat is
/// repeated.
class DriveLink {
public:
    DriveLink() = default;
    DriveLink(const DriveLink&) = delete;
    DriveLink& operator=(const DriveLink&) = delete;
    virtual ~DriveLink() = default;

    /// Up to this many registers are read or written at one instant; over a serial line 16 and 8.
    static constexpr std::size_t maximumReads = 64;
    static constexpr std::size_t maximumWrites = 32;

    /// "http://192.168.1.20", without a password: for messages.
    [[nodiscard]] virtual std::string endpoint() const = 0;

    [[nodiscard]] virtual Result<DriveIdentity> identify(const Exchange& exchange) = 0;

    /// One reading per path, in their order. More than that are read in several requests.
    /// Errors: UnknownRegister (path).
    [[nodiscard]] virtual Result<std::vector<RegisterReading>> readRegisters(
        std::span<const std::string> paths, const Exchange& exchange) = 0;

    /// All registers whose path is the prefix or lies below it ("" = all).
    [[nodiscard]] virtual Result<std::vector<RegisterReading>> readTree(
        const std::string& prefix, const Exchange& exchange) = 0;

    /// All at one instant, or none and the error of the first that is refused; 1 to maximumWrites.
    /// Errors: UnknownRegister, NotAllowedNow, FlashWear, DriveRejected.
    [[nodiscard]] virtual Result<void> writeRegisters(
        std::span<const RegisterWrite> writes, const Exchange& exchange) = 0;

    [[nodiscard]] virtual Result<std::vector<DriveFile>> listFiles(const Exchange& exchange) = 0;

    /// Errors: UnknownFile.
    [[nodiscard]] virtual Result<Bytes> download(
        const std::string& path, const Exchange& exchange) = 0;

    /// The drive takes the file whole or not at all. Errors: UnknownFile, NotAllowedNow,
    /// TooLargeForSlot, TableRefused, FlashWear.
    [[nodiscard]] virtual Result<void> upload(
        const std::string& path, ByteView bytes, const Exchange& exchange) = 0;
};

} // namespace axiscomp
