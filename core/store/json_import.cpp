// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/json_import.h"

#include "core/io/local_file.h"
#include "core/store/backup_json.h"
#include "core/store/store_folder.h"
#include "core/store/store_records.h"
#include "core/store/store_repair.h"
#include "core/store/trusted_certificates.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace axiscomp {

namespace {

namespace fs = std::filesystem;
using sqlite::Connection;
using sqlite::Statement;

constexpr std::uint64_t maximumDocumentSize = 1024 * 1024;
constexpr JsonLimits documentLimits{.size = maximumDocumentSize, .depth = 8, .values = 20'000};
constexpr std::string_view journalBeginning = "journal-axis";
constexpr std::string_view jsonEnding = ".json";

constexpr std::array<std::string_view, 11> journalMembers{"format", "version", "serialNumber",
    "axis", "time", "step", "backup", "newRegisters", "newSlot", "newCrc", "persistent"};
constexpr std::array<std::string_view, 1> journalExtras{"newTable"};
constexpr std::array<std::string_view, 4> flashMembers{"format", "version", "total", "recent"};
constexpr std::array<std::string_view, 1> flashExtras{"refusal"};

/// A file of an older version.
struct OldFile {
    fs::path path;
    std::int32_t serialNumber = 0; ///< of its folder; 0 for the certificates
    int axis = -1; ///< of a journal
    Bytes bytes{}; ///< empty: nothing that could be understood
};

using StoreChange = std::function<void(Connection&)>;

/// What a file changes in the database, or in words why it cannot be understood.
template <typename T> using ParsedJson = tl::expected<T, Text>;

template <typename T> ParsedJson<T> resultOf(const StrictJson& document, T value)
{
    if (document.problem())
        return tl::unexpected(document.problem()->reason);
    return value;
}

JournalEntry::KeptTable keptTableFromJson(const JsonNode& node, const fs::path& folder)
{
    node.expectMembers({"file", "size", "crc32"});
    const fs::path name = pathFromText(node["file"].textView());
    if (name.empty() || name != name.filename() || name == "." || name == "..")
        node["file"].refuse(
            AXISCOMP_TEXT("Error", "the name of a file beside the journal is expected"));
    return {folder / name, static_cast<std::uint64_t>(node["size"].integer<std::int64_t>(0)),
        crcFromJson(node["crc32"])};
}

ParsedJson<JournalEntry> parseJournal(const OldFile& file)
{
    StrictJson document{asText(file.bytes), documentLimits};
    const JsonNode root = document.root();
    expectFormat(root, "axiscomp-journal");
    // The oldest versions kept no table.
    root.expectMembers(journalMembers, journalExtras);
    JournalEntry entry{root["serialNumber"].integer<std::int32_t>(), root["axis"].integer<int>(0),
        timeFromJson(root["time"]), root["step"].text(), pathFromText(root["backup"].textView()),
        registersFromJson(root["newRegisters"]), root["newSlot"].text(),
        crcFromJson(root["newCrc"]), root["persistent"].boolean()};
    const fs::path folder = file.path.parent_path();
    if (root.has("newTable"))
        entry.newTable = keptTableFromJson(root["newTable"], folder);
    if (!entry.backup.empty())
        entry.backup = folder / entry.backup;
    if (!document.problem() && (entry.serialNumber != file.serialNumber || entry.axis != file.axis))
        return tl::unexpected(
            Text(AXISCOMP_TEXT("Error", "it is about axis {axis} of drive {drive}")
                     .with("axis", entry.axis)
                     .with("drive", entry.serialNumber)));
    return resultOf(document, std::move(entry));
}

ParsedJson<StoreChange> parseFlashHistory(const OldFile& file)
{
    StrictJson document{asText(file.bytes), documentLimits};
    const JsonNode root = document.root();
    expectFormat(root, "axiscomp-flash-history");
    root.expectMembers(flashMembers, flashExtras);
    DriveStore::FlashHistory history;
    history.total = static_cast<std::uint64_t>(root["total"].integer<std::int64_t>(0));
    for (const JsonNode& item : root["recent"].items())
        history.recent.push_back(timeFromJson(item));
    if (root.has("refusal")) {
        const JsonNode refusal = root["refusal"];
        refusal.expectMembers({"time", "waitSeconds"});
        history.refusal = {timeFromJson(refusal["time"]),
            std::chrono::seconds(refusal["waitSeconds"].integer<std::int32_t>(0))};
    }
    return resultOf<StoreChange>(
        document, [history, serial = file.serialNumber](Connection& database) {
            for (const WallTime time : history.recent)
                records::addFlash(database, serial, time, 1);
            if (history.total > history.recent.size())
                records::addToFlashTotal(database, serial, history.total - history.recent.size());
            if (history.refusal)
                records::setFlashRefusal(database, serial, *history.refusal);
        });
}

ParsedJson<StoreChange> parseOwnTables(const OldFile& file)
{
    StrictJson document{asText(file.bytes), documentLimits};
    const JsonNode root = document.root();
    expectFormat(root, "axiscomp-tables");
    root.expectMembers({"format", "version", "tables"});
    std::vector<std::pair<int, DriveStore::OwnTable>> tables;
    for (const JsonNode& item : root["tables"].items()) {
        item.expectMembers({"axis", "slot", "crc"});
        tables.emplace_back(item["axis"].integer<int>(0),
            DriveStore::OwnTable{item["slot"].text(), crcFromJson(item["crc"])});
    }
    std::ranges::reverse(tables); // the newest came first
    return resultOf<StoreChange>(
        document, [tables, serial = file.serialNumber](Connection& database) {
            for (const auto& [axis, table] : tables)
                records::addOwnTable(database, serial, axis, table);
        });
}

ParsedJson<StoreChange> parseSavedState(const OldFile& file)
{
    StrictJson document{asText(file.bytes), documentLimits};
    const JsonNode root = document.root();
    expectFormat(root, "axiscomp-saved-state");
    root.expectMembers({"format", "version", "known", "uses", "covered"});
    SavedState state;
    state.isKnown = root["known"].boolean();
    for (const JsonNode& item : root["uses"].items()) {
        item.expectMembers({"axis", "slot", "crc"});
        state.uses.push_back(
            {item["axis"].integer<int>(0), item["slot"].text(), crcFromJson(item["crc"])});
    }
    for (const JsonNode& item : root["covered"].items())
        state.covered.push_back(item.text());
    return resultOf<StoreChange>(
        document, [state, serial = file.serialNumber](Connection& database) {
            if (state.isKnown)
                records::replaceUses(database, serial, state.uses);
            else
                records::addUses(database, serial, state.uses);
            for (const std::string& slot : state.covered)
                records::setCovered(database, serial, slot, true);
        });
}

ParsedJson<StoreChange> parseCertificates(const OldFile& file)
{
    StrictJson document{asText(file.bytes), documentLimits};
    const JsonNode root = document.root();
    expectFormat(root, "axiscomp-certificates");
    root.expectMembers({"format", "version", "certificates"});
    std::vector<TrustedCertificates::Entry> entries;
    for (const JsonNode& item : root["certificates"].items()) {
        item.expectMembers({"endpoint", "sha256"});
        auto fingerprint = sha256Fingerprint(item["sha256"].text());
        if (!fingerprint)
            item["sha256"].refuse(
                AXISCOMP_TEXT("Error", "the SHA-256 of a certificate is expected"));
        entries.push_back({item["endpoint"].text(), fingerprint.value_or("")});
    }
    return resultOf<StoreChange>(document, [entries](Connection& database) {
        for (const auto& entry : entries)
            records::putCertificate(database, entry);
    });
}

ParsedJson<StoreChange> parseOldFile(const OldFile& file)
{
    const std::string name = file.path.filename().string();
    if (name == "flash.json")
        return parseFlashHistory(file);
    if (name == "tables.json")
        return parseOwnTables(file);
    if (name == "saved.json")
        return parseSavedState(file);
    if (name == "certificates.json")
        return parseCertificates(file);
    return parseJournal(file).map([&](const JournalEntry& entry) -> StoreChange {
        return [entry, folder = file.path.parent_path()](
                   Connection& database) { records::putJournal(database, entry, folder); };
    });
}

std::optional<int> numberFrom(std::string_view text)
{
    int number = 0;
    const char* const end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, number);
    return parsed.ec == std::errc{} && parsed.ptr == end && std::to_string(number) == text
        ? std::optional(number)
        : std::nullopt;
}

std::optional<OldFile> asOldFile(const fs::path& path, std::int32_t serialNumber)
{
    const std::string name = path.filename().string();
    if (name == "flash.json" || name == "tables.json" || name == "saved.json")
        return OldFile{path, serialNumber};
    if (!name.starts_with(journalBeginning) || !name.ends_with(jsonEnding))
        return std::nullopt;
    const auto axis = numberFrom(std::string_view(name).substr(
        journalBeginning.size(), name.size() - journalBeginning.size() - jsonEnding.size()));
    return axis ? std::optional(OldFile{path, serialNumber, *axis}) : std::nullopt;
}

std::vector<OldFile> oldFiles(const fs::path& root)
{
    std::vector<OldFile> files;
    if (const fs::path certificates = root / "certificates.json"; !isMissing(certificates))
        files.push_back({certificates});
    for (const std::int32_t serialNumber : drivesIn(root))
        for (const fs::path& path : filesIn(root / std::to_string(serialNumber)))
            if (auto file = asOldFile(path, serialNumber))
                files.push_back(*std::move(file));
    return files;
}

/// What is no file, or too large for one of ours, counts as one that cannot be understood.
Result<void> loadOldFile(OldFile& file)
{
    std::error_code error;
    if (!fs::is_regular_file(file.path, error)
        || fs::file_size(file.path, error) > maximumDocumentSize)
        return {};
    AXISCOMP_TRY(file.bytes, loadFile(file.path, maximumDocumentSize));
    return {};
}

/// file + ending, or + "-2" and so on: nothing is ever replaced.
fs::path freeName(const fs::path& file, const std::string& ending)
{
    fs::path name = file;
    name += ending;
    for (int number = 2; !isMissing(name); ++number) {
        name = file;
        name += ending + "-" + std::to_string(number);
    }
    return name;
}

/// What was taken over, but not yet renamed, when a program was stopped in between too.
Result<void> renameTakenOver(Connection& database, const fs::path& root)
{
    std::vector<std::pair<std::string, std::string>> names;
    for (Statement row(database, "SELECT file, new_name FROM taken_over"); row.next();)
        names.emplace_back(row.text(0), row.text(1));
    for (const auto& [from, to] : names)
        AXISCOMP_CHECK(renameFile(root / from, root / to));
    if (!names.empty())
        database.run("DELETE FROM taken_over");
    return {};
}

void takeOver(Connection& database, const OldFile& file, const fs::path& root)
{
    const auto change = parseOldFile(file);
    if (!change && file.axis >= 0)
        return; // a journal: the user has to look
    const fs::path newName =
        freeName(file.path, change ? ".imported" : ".broken").lexically_relative(root);
    if (change)
        (*change)(database);
    else if (file.path.filename() == "flash.json")
        records::addFlashLoss(database, file.serialNumber, newName.string());
    Statement(database, "INSERT INTO taken_over (file, new_name) VALUES (?1, ?2)",
        file.path.lexically_relative(root).string(), newName.string())
        .run();
}

fs::path oldJournal(const fs::path& root, std::int32_t serialNumber, int axis)
{
    return root / std::to_string(serialNumber)
        / (std::string(journalBeginning) + std::to_string(axis) + std::string(jsonEnding));
}

} // namespace

bool hasStore(const fs::path& root)
{
    const std::vector<fs::path> files = filesIn(root);
    return std::ranges::any_of(files, [](const fs::path& file) {
        return file.filename().string().starts_with(databaseName);
    }) || !oldFiles(root).empty();
}

Result<void> takeOverJson(Connection& database, const fs::path& root)
{
    AXISCOMP_CHECK(renameTakenOver(database, root));
    std::vector<OldFile> files = oldFiles(root);
    if (files.empty())
        return {};
    for (OldFile& file : files)
        AXISCOMP_CHECK(loadOldFile(file));
    sqlite::Transaction transaction(database, sqlite::Transaction::Kind::Write);
    for (const OldFile& file : files)
        takeOver(database, file, root);
    transaction.commit();
    return renameTakenOver(database, root);
}

Result<std::optional<JournalEntry>> journalOfOlderVersion(
    const fs::path& root, std::int32_t serialNumber, int axis)
{
    OldFile file{oldJournal(root, serialNumber, axis), serialNumber, axis};
    if (isMissing(file.path))
        return std::nullopt;
    const auto loaded = loadOldFile(file);
    auto entry = loaded ? parseJournal(file) : tl::unexpected(textOf(loaded.error()));
    if (entry)
        return *std::move(entry);
    return fail(ErrorCode::FileNotReadable,
        {{"file", file.path.string()},
            {"reason",
                AXISCOMP_TEXT("Error",
                    "it was kept about a write that did not end, but is damaged ({reason}). Look "
                    "at what the drive holds, then delete the file")
                    .with("reason", entry.error())}});
}

std::vector<Result<JournalEntry>> journalsOfOlderVersion(const fs::path& root)
{
    std::vector<Result<JournalEntry>> journals;
    for (const OldFile& file : oldFiles(root)) {
        if (file.axis < 0)
            continue;
        auto journal = journalOfOlderVersion(root, file.serialNumber, file.axis);
        if (!journal)
            journals.push_back(fail(std::move(journal).error()));
        else if (*journal)
            journals.push_back(**std::move(journal));
    }
    return journals;
}

Result<void> dropJournalOfOlderVersion(const fs::path& root, std::int32_t serialNumber, int axis)
{
    const fs::path file = oldJournal(root, serialNumber, axis);
    return isMissing(file) ? Result<void>{} : renameFile(file, freeName(file, ".broken"));
}

} // namespace axiscomp
