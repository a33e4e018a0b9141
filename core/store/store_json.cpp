// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/store_json.h"

#include "core/store/backup_json.h"

#include <array>
#include <chrono>
#include <utility>

namespace axiscomp {

namespace {

constexpr std::string_view journalFormat = "axiscomp-journal";
constexpr std::string_view flashFormat = "axiscomp-flash-history";
constexpr std::string_view tablesFormat = "axiscomp-tables";
constexpr std::string_view savedFormat = "axiscomp-saved-state";
constexpr JsonLimits storeLimits{.size = maximumDocumentSize, .depth = 8, .values = 20'000};

template <typename T> DocumentResult<T> resultOf(const StrictJson& document, T value)
{
    if (document.problem())
        return tl::unexpected(document.problem()->reason);
    return value;
}

constexpr std::array<std::string_view, 11> journalMembers{"format", "version", "serialNumber",
    "axis", "time", "step", "backup", "newRegisters", "newSlot", "newCrc", "persistent"};
constexpr std::array<std::string_view, 1> journalExtras{"newTable"};
constexpr std::array<std::string_view, 4> flashMembers{"format", "version", "total", "recent"};
constexpr std::array<std::string_view, 1> flashExtras{"refusal"};

JournalEntry::KeptTable keptTableFromJson(const JsonNode& node, const std::filesystem::path& folder)
{
    node.expectMembers({"file", "size", "crc32"});
    const std::filesystem::path name = node["file"].text();
    if (name.empty() || name != name.filename() || name == "." || name == "..")
        node["file"].refuse(
            AXISCOMP_TEXT("Error", "the name of a file beside the journal is expected"));
    return {folder / name, static_cast<std::uint64_t>(node["size"].integer<std::int64_t>(0)),
        crcFromJson(node["crc32"])};
}

} // namespace

std::string writeJournal(const JournalEntry& entry, const std::filesystem::path& folder)
{
    const std::filesystem::path relative = entry.backup.lexically_relative(folder);
    const bool isInside = !relative.empty() && *relative.begin() != "..";
    OrderedJson document = newDocument(journalFormat);
    document["serialNumber"] = entry.serialNumber;
    document["axis"] = entry.axis;
    document["time"] = utcText(entry.time);
    document["step"] = entry.step;
    document["backup"] = (isInside ? relative : entry.backup).string();
    document["newRegisters"] = toJson(entry.newRegisters);
    document["newSlot"] = entry.newSlot;
    document["newCrc"] = crcText(entry.newCrc);
    document["persistent"] = entry.persistent;
    if (entry.newTable)
        document["newTable"] = {{"file", entry.newTable->file.filename().string()},
            {"size", entry.newTable->size}, {"crc32", crcText(entry.newTable->crc)}};
    return jsonText(document);
}

DocumentResult<JournalEntry> readJournal(std::string_view text, const std::filesystem::path& folder)
{
    StrictJson document{text, storeLimits};
    const JsonNode root = document.root();
    expectFormat(root, journalFormat);
    // Journals of older versions kept no table.
    root.expectMembers(journalMembers, journalExtras);
    JournalEntry entry{root["serialNumber"].integer<std::int32_t>(), root["axis"].integer<int>(0),
        timeFromJson(root["time"]), root["step"].text(), root["backup"].text(),
        registersFromJson(root["newRegisters"]), root["newSlot"].text(),
        crcFromJson(root["newCrc"]), root["persistent"].boolean()};
    if (root.has("newTable"))
        entry.newTable = keptTableFromJson(root["newTable"], folder);
    if (!entry.backup.empty()) // folder / an absolute path is that path
        entry.backup = folder / entry.backup;
    return resultOf(document, std::move(entry));
}

std::string writeFlashHistory(const DriveStore::FlashHistory& history)
{
    OrderedJson document = newDocument(flashFormat);
    document["total"] = history.total;
    document["recent"] = OrderedJson::array();
    for (const WallTime time : history.recent)
        document["recent"].push_back(utcText(time));
    if (history.refusal)
        document["refusal"] = {{"time", utcText(history.refusal->time)},
            {"waitSeconds", history.refusal->wait.count()}};
    return jsonText(document);
}

DocumentResult<DriveStore::FlashHistory> readFlashHistory(std::string_view text)
{
    StrictJson document{text, storeLimits};
    const JsonNode root = document.root();
    expectFormat(root, flashFormat);
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
    return resultOf(document, std::move(history));
}

std::string writeTables(const std::vector<WrittenTable>& tables)
{
    OrderedJson document = newDocument(tablesFormat);
    document["tables"] = OrderedJson::array();
    for (const WrittenTable& written : tables)
        document["tables"].push_back({{"axis", written.axis}, {"slot", written.table.slot},
            {"crc", crcText(written.table.crc)}});
    return jsonText(document);
}

DocumentResult<std::vector<WrittenTable>> readTables(std::string_view text)
{
    StrictJson document{text, storeLimits};
    const JsonNode root = document.root();
    expectFormat(root, tablesFormat);
    root.expectMembers({"format", "version", "tables"});
    std::vector<WrittenTable> tables;
    for (const JsonNode& item : root["tables"].items()) {
        item.expectMembers({"axis", "slot", "crc"});
        tables.push_back(
            {item["axis"].integer<int>(0), {item["slot"].text(), crcFromJson(item["crc"])}});
    }
    return resultOf(document, std::move(tables));
}

std::string writeSavedState(const SavedState& state)
{
    OrderedJson document = newDocument(savedFormat);
    document["known"] = state.isKnown;
    document["uses"] = OrderedJson::array();
    for (const SavedState::Use& use : state.uses)
        document["uses"].push_back(
            {{"axis", use.axis}, {"slot", use.slot}, {"crc", crcText(use.crc)}});
    document["covered"] = OrderedJson::array();
    for (const std::string& slot : state.covered)
        document["covered"].push_back(slot);
    return jsonText(document);
}

DocumentResult<SavedState> readSavedState(std::string_view text)
{
    StrictJson document{text, storeLimits};
    const JsonNode root = document.root();
    expectFormat(root, savedFormat);
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
    return resultOf(document, std::move(state));
}

} // namespace axiscomp
