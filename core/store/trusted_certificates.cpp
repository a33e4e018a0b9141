// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/trusted_certificates.h"

#include "core/io/file_lock.h"
#include "core/io/local_file.h"
#include "core/store/backup_json.h"
#include "core/store/store_folder.h"

#include <algorithm>
#include <utility>

namespace axiscomp {

namespace {

using Entry = TrustedCertificates::Entry;

constexpr std::string_view certificateFormat = "axiscomp-certificates";
constexpr std::size_t sha256Digits = 64;
constexpr JsonLimits certificateLimits{.size = maximumDocumentSize, .depth = 4, .values = 20'000};

std::filesystem::path fileIn(const std::filesystem::path& root)
{
    return root / "certificates.json";
}

/// nullopt: there is a file that cannot be read or understood.
std::optional<std::vector<Entry>> readEntries(const std::filesystem::path& root)
{
    if (isMissing(fileIn(root)))
        return std::vector<Entry>{};
    const auto bytes = loadFile(fileIn(root), maximumDocumentSize);
    if (!bytes)
        return std::nullopt;
    StrictJson document{asText(*bytes), certificateLimits};
    const JsonNode top = document.root();
    expectFormat(top, certificateFormat);
    top.expectMembers({"format", "version", "certificates"});
    std::vector<Entry> entries;
    bool isUnderstood = true;
    for (const JsonNode& item : top["certificates"].items()) {
        item.expectMembers({"endpoint", "sha256"});
        Entry entry{item["endpoint"].text(), {}};
        if (auto fingerprint = sha256Fingerprint(item["sha256"].text()))
            entry.fingerprint = *std::move(fingerprint);
        else
            isUnderstood = false;
        entries.push_back(std::move(entry));
    }
    if (document.problem() || !isUnderstood)
        return std::nullopt;
    return entries;
}

std::string textOf(const std::vector<Entry>& entries)
{
    OrderedJson document = newDocument(certificateFormat);
    document["certificates"] = OrderedJson::array();
    for (const Entry& entry : entries)
        document["certificates"].push_back(
            {{"endpoint", entry.endpoint}, {"sha256", entry.fingerprint}});
    return jsonText(document);
}

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
    : m_root(std::move(root))
    , m_lockWait(lockWait)
{
}

std::vector<Entry> TrustedCertificates::all() const
{
    auto entries = readEntries(m_root).value_or(std::vector<Entry>{});
    std::ranges::sort(entries, {}, &Entry::endpoint);
    return entries;
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
    return change(endpoint, known);
}

Result<void> TrustedCertificates::forget(const std::string& endpoint)
{
    if (!fingerprintOf(endpoint))
        return {};
    return change(endpoint, std::nullopt);
}

Result<void> TrustedCertificates::change(
    const std::string& endpoint, const std::optional<std::string>& fingerprint)
{
    AXISCOMP_CHECK(makePrivateFolder(m_root));
    const auto lock = FileLock::acquire(m_root / "certificates.lock", m_lockWait, fileIn(m_root));
    if (!lock)
        return fail(lock.error());
    auto entries = readEntries(m_root);
    if (!entries) {
        std::error_code ignored; // saving says what is wrong
        std::filesystem::rename(fileIn(m_root), fileIn(m_root).string() + ".broken", ignored);
        entries.emplace();
    }
    std::erase_if(*entries, [&](const Entry& entry) { return entry.endpoint == endpoint; });
    if (fingerprint)
        entries->push_back({endpoint, *fingerprint});
    const std::string text = textOf(*entries);
    return saveFile(fileIn(m_root), asBytes(text));
}

} // namespace axiscomp
