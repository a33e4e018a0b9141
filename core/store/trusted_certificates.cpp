// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/trusted_certificates.h"

#include "core/store/store_database.h"
#include "core/store/store_records.h"

#include <algorithm>
#include <utility>

namespace axiscomp {

namespace {

constexpr std::size_t sha256Digits = 64;

} // namespace

std::optional<std::string> sha256Fingerprint(std::string_view text)
{
    std::string digits;
    for (const char c : text) {
        if (c >= 'a' && c <= 'f')
            digits += static_cast<char>(c - 'a' + 'A');
        else if ((c >= '0' && c <= '9') || (c >= 'A' && c <= 'F'))
            digits += c;
        else if (c != ':' && c != ' ')
            return std::nullopt;
    }
    if (digits.size() != sha256Digits)
        return std::nullopt;
    std::string fingerprint;
    for (std::size_t i = 0; i < digits.size(); i += 2)
        fingerprint += (i == 0 ? "" : ":") + digits.substr(i, 2);
    return fingerprint;
}

TrustedCertificates::TrustedCertificates(
    std::filesystem::path root, std::chrono::milliseconds lockWait)
    : m_database(std::make_unique<StoreDatabase>(std::move(root), lockWait))
{
}

TrustedCertificates::~TrustedCertificates() = default;

std::vector<TrustedCertificates::Entry> TrustedCertificates::all() const
{
    return m_database->get<std::vector<Entry>>(records::certificates)
        .value_or(std::vector<Entry>{});
}

std::optional<std::string> TrustedCertificates::fingerprintOf(std::string_view endpoint) const
{
    const std::vector<Entry> entries = all();
    const auto entry = std::ranges::find(entries, endpoint, &Entry::endpoint);
    return entry == entries.end() ? std::nullopt : std::optional(entry->fingerprint);
}

CertificateTrust TrustedCertificates::check(
    std::string_view endpoint, std::string_view fingerprint) const
{
    const auto known = fingerprintOf(endpoint);
    if (!known)
        return CertificateTrust::Unknown;
    return *known == fingerprint ? CertificateTrust::Trusted : CertificateTrust::Changed;
}

Result<void> TrustedCertificates::trust(const std::string& endpoint, const std::string& fingerprint)
{
    const auto known = sha256Fingerprint(fingerprint);
    if (!known)
        return fail(ErrorCode::InvalidArgument,
            {{"reason", fingerprint + " is not the SHA-256 of a certificate"}});
    return m_database->change([&](sqlite::Connection& database) {
        records::putCertificate(database, {endpoint, *known});
    });
}

Result<void> TrustedCertificates::forget(const std::string& endpoint)
{
    if (!fingerprintOf(endpoint))
        return {};
    return m_database->change(
        [&](sqlite::Connection& database) { records::removeCertificate(database, endpoint); });
}

} // namespace axiscomp
