// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

class StoreDatabase;

enum class CertificateTrust {
    Unknown, ///< nobody has decided about the endpoint
    Trusted, ///< this very certificate
    Changed, ///< another one than this
};

/// "3F:A0:...", 32 bytes in upper case, from the same with or without colons or blanks, in any
/// case; nullopt when it is no SHA-256.
[[nodiscard]] std::optional<std::string> sha256Fingerprint(std::string_view text);

/// The certificates that a person trusts although no authority vouches for them: one for each
/// endpoint (host and port), by the SHA-256 of the whole certificate. In the database of the
/// DriveStore's root, shared by several programs; may be used from several threads.
class TrustedCertificates {
public:
    explicit TrustedCertificates(
        std::filesystem::path root, std::chrono::milliseconds lockWait = std::chrono::seconds{5});
    ~TrustedCertificates();

    struct Entry {
        std::string endpoint; ///< "https://192.168.1.20", never with a password
        std::string fingerprint; ///< sha256Fingerprint
        friend bool operator==(const Entry&, const Entry&) = default;
    };
    /// Sorted by endpoint; none where the store cannot be read: then a person is asked again.
    [[nodiscard]] std::vector<Entry> all() const;
    [[nodiscard]] std::optional<std::string> fingerprintOf(std::string_view endpoint) const;
    [[nodiscard]] CertificateTrust check(
        std::string_view endpoint, std::string_view fingerprint) const;

    /// Takes the place of what was trusted there. Errors: FileNotReadable, FileNotWritable;
    /// InvalidArgument for what is no fingerprint.
    [[nodiscard]] Result<void> trust(const std::string& endpoint, const std::string& fingerprint);
    /// Errors: FileNotReadable, FileNotWritable. What is not there is no error.
    [[nodiscard]] Result<void> forget(const std::string& endpoint);

private:
    std::unique_ptr<StoreDatabase> m_database;
};

} // namespace axiscomp
