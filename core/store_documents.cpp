// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store_documents.h"

#include "core/backup_json.h"

#include <utility>

namespace axiscomp {

namespace {

constexpr std::string_view journalFormat = "axiscomp-journal";
constexpr std::string_view flashFormat = "axiscomp-flash-history";
constexpr std::string_view tablesFormat = "axiscomp-tables";
constexpr JsonLimits limits{.size = maximumDocumentSize, .depth = 8, .values = 20'000};

template <typename T> DocumentResult<T> resultOf(const StrictJson& document, T value)
{
    if (document.problem())
        return tl::unexpected(document.problem()->reason);
    return value;
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
    return jsonText(document);
}

DocumentResult<JournalEntry> readJournal(std::string_view text, const std::filesystem::path& folder)
{
    StrictJson document{text, limits};
    const JsonNode root = document.root();
    expectFormat(root, journalFormat);
    root.expectMembers({"format", "version", "serialNumber", "axis", "time", "step", "backup",
        "newRegisters", "newSlot", "newCrc", "persistent"});
    JournalEntry entry{root["serialNumber"].integer<std::int32_t>(), root["axis"].integer<int>(0),
        timeFromJson(root["time"]), root["step"].text(), root["backup"].text(),
        registersFromJson(root["newRegisters"]), root["newSlot"].text(),
        crcFromJson(root["newCrc"]), root["persistent"].boolean()};
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
    return jsonText(document);
}

DocumentResult<DriveStore::FlashHistory> readFlashHistory(std::string_view text)
{
    StrictJson document{text, limits};
    const JsonNode root = document.root();
    expectFormat(root, flashFormat);
    root.expectMembers({"format", "version", "total", "recent"});
    DriveStore::FlashHistory history;
    history.total = static_cast<std::uint64_t>(root["total"].integer<std::int64_t>(0));
    for (const JsonNode& item : root["recent"].items())
        history.recent.push_back(timeFromJson(item));
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
    StrictJson document{text, limits};
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

} // namespace axiscomp
