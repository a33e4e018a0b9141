// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/store_records.h"

#include "core/io/local_file.h"
#include "core/store/backup_json.h"
#include "core/store/store_folder.h"
#include "core/table/target_axis.h"

#include <algorithm>
#include <array>
#include <utility>

namespace axiscomp::records {

namespace {

using sqlite::Connection;
using sqlite::Statement;

constexpr int keptFlashOperations = 1000;
constexpr int keptTablesPerSlot = 4;
constexpr int keptMeasuredTables = 50; // of an axis
constexpr JsonLimits registerLimits{.size = 1024 * 1024, .depth = 8, .values = 20'000};

std::int64_t stored(WallTime time)
{
    return std::chrono::duration_cast<std::chrono::nanoseconds>(time.time_since_epoch()).count();
}

WallTime timeOf(std::int64_t nanoseconds)
{
    return WallTime(
        std::chrono::duration_cast<WallTime::duration>(std::chrono::nanoseconds(nanoseconds)));
}

void knowDrive(Connection& database, std::int32_t serialNumber)
{
    Statement(database, "INSERT OR IGNORE INTO drive (serial) VALUES (?1)", serialNumber).run();
}

std::vector<RegisterWrite> registersOf(const std::string& text)
{
    StrictJson document{text, registerLimits};
    std::vector<RegisterWrite> registers = registersFromJson(document.root());
    if (document.problem())
        throw sqlite::Failure{
            .reason = AXISCOMP_TEXT("Error",
                "its journal of an interrupted write is damaged ({reason}). Look at what the drive "
                "holds, then move the file away")
                          .with("reason", document.problem()->reason)};
    return registers;
}

/// What cannot be read is not known.
std::optional<Grid> gridOf(const std::string& text)
{
    StrictJson document{text, registerLimits};
    Grid grid = spansFromJson(document.root());
    return document.problem() ? std::nullopt : std::optional(std::move(grid));
}

std::string unitsText(const TableUnits& units)
{
    return units == TableUnits{} ? std::string() : jsonText(toJson(units));
}

/// What cannot be read is not known.
TableUnits unitsOf(const std::string& text)
{
    StrictJson document{text, registerLimits};
    TableUnits units = unitsFromJson(document.root());
    return document.problem() ? TableUnits{} : units;
}

std::string pathsText(const std::vector<std::string>& paths)
{
    return paths.empty() ? std::string() : jsonText(paths);
}

/// What cannot be read is not known.
std::vector<std::string> pathsOf(const std::string& text)
{
    StrictJson document{text, registerLimits};
    std::vector<std::string> paths;
    for (const JsonNode& path : document.root().items())
        paths.push_back(path.text());
    return document.problem() ? std::vector<std::string>{} : paths;
}

std::string targetsText(const std::vector<std::string>& targets)
{
    std::string text;
    for (const std::string& target : targets)
        text += (text.empty() ? "" : ", ") + target;
    return text;
}

} // namespace

void putJournal(
    Connection& database, const JournalEntry& entry, const std::filesystem::path& folder)
{
    const std::filesystem::path relative = entry.backup.lexically_relative(folder);
    const bool isInside = !relative.empty() && *relative.begin() != "..";
    const auto& table = entry.newTable;
    const auto ofTable = [&](auto value) {
        return table ? std::optional(static_cast<std::int64_t>(value(*table))) : std::nullopt;
    };
    using Table = JournalEntry::KeptTable;
    Statement(database,
        "INSERT OR REPLACE INTO journal (serial, axis, time, step, backup, registers, slot, crc, "
        "persistent, table_file, table_size, table_crc, deleted_slot, units, source_paths) "
        "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12, ?13, ?14, ?15)",
        entry.serialNumber, entry.axis, stored(entry.time), entry.step,
        (isInside ? relative : entry.backup).string(), jsonText(toJson(entry.newRegisters)),
        entry.newSlot, entry.newCrc, entry.persistent,
        table ? table->file.filename().string() : std::string(),
        ofTable([](const Table& kept) { return kept.size; }),
        ofTable([](const Table& kept) { return kept.crc; }), entry.deletedSlot,
        unitsText(entry.newUnits), pathsText(entry.newSourcePaths))
        .run();
}

std::optional<JournalEntry> journal(
    Connection& database, std::int32_t serialNumber, int axis, const std::filesystem::path& folder)
{
    Statement row(database,
        "SELECT time, step, backup, registers, slot, crc, persistent, table_file, table_size, "
        "table_crc, deleted_slot, units, source_paths FROM journal WHERE serial = ?1 AND axis = ?2",
        serialNumber, axis);
    if (!row.next())
        return std::nullopt;
    JournalEntry entry{serialNumber, axis, timeOf(row.number(0)), row.text(1),
        pathFromText(row.text(2)), registersOf(row.text(3)), row.text(4), row.as<std::uint32_t>(5),
        row.number(6) != 0};
    if (!entry.backup.empty()) // folder / an absolute path is that path
        entry.backup = folder / entry.backup;
    if (!row.isNull(8))
        entry.newTable = JournalEntry::KeptTable{
            folder / pathFromText(row.text(7)), row.as<std::uint64_t>(8), row.as<std::uint32_t>(9)};
    entry.deletedSlot = row.text(10);
    entry.newUnits = unitsOf(row.text(11));
    entry.newSourcePaths = pathsOf(row.text(12));
    return entry;
}

std::vector<JournalEntry> journals(Connection& database)
{
    std::vector<JournalEntry> entries;
    for (Statement row(
             database, "SELECT serial, axis, time, step FROM journal ORDER BY serial, axis");
         row.next();) {
        JournalEntry& entry = entries.emplace_back();
        entry.serialNumber = row.as<std::int32_t>(0);
        entry.axis = row.as<int>(1);
        entry.time = timeOf(row.number(2));
        entry.step = row.text(3);
    }
    return entries;
}

void removeJournal(Connection& database, std::int32_t serialNumber, int axis)
{
    Statement(database, "DELETE FROM journal WHERE serial = ?1 AND axis = ?2", serialNumber, axis)
        .run();
}

void addFlash(
    Connection& database, std::int32_t serialNumber, WallTime time, std::uint64_t operations)
{
    addToFlashTotal(database, serialNumber, operations);
    Statement(database, "INSERT INTO flash_operation (serial, time, count) VALUES (?1, ?2, ?3)",
        serialNumber, stored(time), std::min<std::uint64_t>(operations, keptFlashOperations))
        .run();
    // Each row is one operation at least.
    Statement(database,
        "DELETE FROM flash_operation WHERE serial = ?1 AND id <= (SELECT id FROM flash_operation "
        "WHERE serial = ?1 ORDER BY id DESC LIMIT 1 OFFSET ?2)",
        serialNumber, keptFlashOperations)
        .run();
}

void addToFlashTotal(Connection& database, std::int32_t serialNumber, std::uint64_t operations)
{
    knowDrive(database, serialNumber);
    Statement(database, "UPDATE drive SET flash_total = flash_total + ?2 WHERE serial = ?1",
        serialNumber, operations)
        .run();
}

void setFlashRefusal(Connection& database, std::int32_t serialNumber,
    const DriveStore::FlashHistory::Refusal& refusal)
{
    knowDrive(database, serialNumber);
    Statement(database, "UPDATE drive SET refused_at = ?2, refused_for = ?3 WHERE serial = ?1",
        serialNumber, stored(refusal.time), refusal.wait.count())
        .run();
}

void addFlashLoss(
    Connection& database, std::optional<std::int64_t> serialNumber, const std::string& file)
{
    Statement(database, "INSERT INTO flash_loss (serial, file) VALUES (?1, ?2)", serialNumber, file)
        .run();
}

void acceptFlashLoss(Connection& database, std::int32_t serialNumber)
{
    knowDrive(database, serialNumber);
    Statement(database,
        "UPDATE drive SET accepted_loss = (SELECT coalesce(max(id), 0) FROM flash_loss) "
        "WHERE serial = ?1",
        serialNumber)
        .run();
}

DriveStore::FlashHistory flashHistory(
    Connection& database, std::int32_t serialNumber, const std::filesystem::path& root)
{
    DriveStore::FlashHistory history;
    std::int64_t accepted = 0;
    if (Statement drive(database,
            "SELECT flash_total, refused_at, refused_for, accepted_loss FROM drive "
            "WHERE serial = ?1",
            serialNumber);
        drive.next()) {
        history.total = drive.as<std::uint64_t>(0);
        if (!drive.isNull(1))
            history.refusal = {timeOf(drive.number(1)), std::chrono::seconds(drive.number(2))};
        accepted = drive.number(3);
    }
    Statement rows(database,
        "SELECT time, count FROM flash_operation WHERE serial = ?1 ORDER BY id DESC", serialNumber);
    while (rows.next() && history.recent.size() < keptFlashOperations) {
        const std::size_t room = keptFlashOperations - history.recent.size();
        history.recent.insert(
            history.recent.end(), std::min(room, rows.as<std::size_t>(1)), timeOf(rows.number(0)));
    }
    std::ranges::reverse(history.recent);
    if (Statement loss(database,
            "SELECT file FROM flash_loss WHERE id > ?1 AND (serial IS NULL OR serial = ?2) "
            "ORDER BY id DESC LIMIT 1",
            accepted, serialNumber);
        loss.next())
        history.damagedRecord = root / loss.text(0);
    return history;
}

std::vector<std::int32_t> drivesWithFlashLoss(
    Connection& database, const std::filesystem::path& root)
{
    std::vector<std::int32_t> drives = drivesIn(root);
    for (Statement row(database, "SELECT serial FROM drive"); row.next();)
        drives.push_back(row.as<std::int32_t>(0));
    std::ranges::sort(drives);
    drives.erase(std::unique(drives.begin(), drives.end()), drives.end());
    std::erase_if(drives, [&](std::int32_t serialNumber) {
        return !flashHistory(database, serialNumber, root).damagedRecord;
    });
    return drives;
}

void addOwnTable(
    Connection& database, std::int32_t serialNumber, int axis, const DriveStore::OwnTable& table)
{
    Statement(database, "DELETE FROM own_table WHERE serial = ?1 AND slot = ?2 AND crc = ?3",
        serialNumber, table.slot, table.crc)
        .run();
    Statement(database, "INSERT INTO own_table (serial, axis, slot, crc) VALUES (?1, ?2, ?3, ?4)",
        serialNumber, axis, table.slot, table.crc)
        .run();
    Statement(database,
        "DELETE FROM own_table WHERE serial = ?1 AND slot = ?2 AND id <= (SELECT id FROM own_table "
        "WHERE serial = ?1 AND slot = ?2 ORDER BY id DESC LIMIT 1 OFFSET ?3)",
        serialNumber, table.slot, keptTablesPerSlot)
        .run();
}

std::vector<DriveStore::OwnTable> ownTables(
    Connection& database, std::int32_t serialNumber, int axis)
{
    std::vector<DriveStore::OwnTable> tables;
    for (Statement row(database,
             "SELECT slot, crc FROM own_table WHERE serial = ?1 AND axis = ?2 ORDER BY id DESC",
             serialNumber, axis);
         row.next();)
        tables.push_back({row.text(0), row.as<std::uint32_t>(1)});
    return tables;
}

void addUses(
    Connection& database, std::int32_t serialNumber, const std::vector<SavedState::Use>& uses)
{
    for (const SavedState::Use& use : uses)
        Statement(database,
            "INSERT INTO saved_use (serial, axis, slot, crc) SELECT ?1, ?2, ?3, ?4 WHERE NOT "
            "EXISTS (SELECT * FROM saved_use WHERE serial = ?1 AND axis = ?2 AND slot = ?3 AND "
            "crc = ?4)",
            serialNumber, use.axis, use.slot, use.crc)
            .run();
}

void replaceUses(
    Connection& database, std::int32_t serialNumber, const std::vector<SavedState::Use>& uses)
{
    knowDrive(database, serialNumber);
    Statement(database, "UPDATE drive SET saved_known = 1 WHERE serial = ?1", serialNumber).run();
    Statement(database, "DELETE FROM saved_use WHERE serial = ?1", serialNumber).run();
    addUses(database, serialNumber, uses);
}

void setCovered(
    Connection& database, std::int32_t serialNumber, const std::string& slot, bool isCovered)
{
    Statement(
        database, "DELETE FROM covered_slot WHERE serial = ?1 AND slot = ?2", serialNumber, slot)
        .run();
    if (isCovered)
        Statement(
            database, "INSERT INTO covered_slot (serial, slot) VALUES (?1, ?2)", serialNumber, slot)
            .run();
}

SavedState savedState(Connection& database, std::int32_t serialNumber)
{
    SavedState state;
    if (Statement drive(database, "SELECT saved_known FROM drive WHERE serial = ?1", serialNumber);
        drive.next())
        state.isKnown = drive.number(0) != 0;
    for (Statement row(database,
             "SELECT axis, slot, crc FROM saved_use WHERE serial = ?1 ORDER BY id", serialNumber);
         row.next();)
        state.uses.push_back({row.as<int>(0), row.text(1), row.as<std::uint32_t>(2)});
    for (Statement row(
             database, "SELECT slot FROM covered_slot WHERE serial = ?1 ORDER BY id", serialNumber);
         row.next();)
        state.covered.push_back(row.text(0));
    return state;
}

void putMeasured(Connection& database, std::int32_t serialNumber, int axis,
    const MeasuredFigures& measured, Measuring measuring)
{
    const auto kept = records::measured(database, serialNumber, axis, measured.crc);
    if (kept && !takesPlaceOf(measured, *kept, measuring))
        return;
    for (const char* table : {"measured", "measured_figure"})
        Statement(database,
            "DELETE FROM " + std::string(table) + " WHERE serial = ?1 AND axis = ?2 AND crc = ?3",
            serialNumber, axis, measured.crc)
            .run();
    std::array<std::optional<double>, 4> ends;
    if (const auto& ranges = measured.lesserRange)
        ends = {ranges->before.first, ranges->before.last, ranges->after.first, ranges->after.last};
    Statement(database,
        "INSERT INTO measured (serial, axis, crc, time, date, angular, grid, left_out, "
        "before_first, before_last, after_first, after_last, lookup_at, targets, units, "
        "axis_name) "
        "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12, ?13, ?14, ?15, ?16)",
        serialNumber, axis, measured.crc, stored(measured.time), measured.date, measured.isAngular,
        measured.grid ? jsonText(spansToJson(*measured.grid)) : std::string(),
        static_cast<std::int64_t>(measured.excluded), ends[0], ends[1], ends[2], ends[3],
        measured.madeFor.at ? std::string(lookupAtName(*measured.madeFor.at)) : std::string(),
        targetsText(measured.madeFor.targets), unitsText(measured.units.value_or(TableUnits{})),
        measured.axisName)
        .run();
    for (const MeasuredFigures::Figure& figure : measured.figures)
        Statement(database,
            "INSERT INTO measured_figure (serial, axis, crc, name, before, predicted, after, "
            "tolerance, result) VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9)",
            serialNumber, axis, measured.crc, figure.name, figure.before, figure.predicted,
            figure.after, figure.tolerance, figure.result)
            .run();
    Statement(database,
        "DELETE FROM measured WHERE serial = ?1 AND axis = ?2 AND id <= (SELECT id FROM measured "
        "WHERE serial = ?1 AND axis = ?2 ORDER BY id DESC LIMIT 1 OFFSET ?3)",
        serialNumber, axis, keptMeasuredTables)
        .run();
    Statement(database,
        "DELETE FROM measured_figure WHERE serial = ?1 AND axis = ?2 AND crc NOT IN (SELECT crc "
        "FROM measured WHERE serial = ?1 AND axis = ?2)",
        serialNumber, axis)
        .run();
}

std::optional<MeasuredFigures> measured(
    Connection& database, std::int32_t serialNumber, int axis, std::uint32_t crc)
{
    Statement table(database,
        "SELECT time, date, angular, grid, left_out, before_first, before_last, after_first, "
        "after_last, lookup_at, targets, units, axis_name FROM measured "
        "WHERE serial = ?1 AND axis = ?2 AND crc = ?3",
        serialNumber, axis, crc);
    if (!table.next())
        return std::nullopt;
    MeasuredFigures measured{crc, timeOf(table.number(0)), table.text(1), table.number(2) != 0};
    measured.grid = gridOf(table.text(3));
    measured.excluded = static_cast<std::size_t>(std::max<std::int64_t>(table.number(4), 0));
    if (const auto first = table.real(5))
        measured.lesserRange = TwoRanges{{*first, table.real(6).value_or(*first)},
            {table.real(7).value_or(*first), table.real(8).value_or(*first)}};
    measured.madeFor.at = lookupAtNamed(table.text(9));
    if (const std::string targets = table.text(10); !targets.empty())
        measured.madeFor.targets = targetList(targets);
    if (const TableUnits units = unitsOf(table.text(11)); !(units == TableUnits{}))
        measured.units = units;
    measured.axisName = table.text(12);
    for (Statement row(database,
             "SELECT name, before, predicted, after, tolerance, result FROM measured_figure "
             "WHERE serial = ?1 AND axis = ?2 AND crc = ?3 ORDER BY id",
             serialNumber, axis, crc);
         row.next();)
        measured.figures.push_back(
            {row.text(0), row.real(1), row.real(2), row.real(3), row.real(4), row.text(5)});
    return measured;
}

void putCertificate(Connection& database, const TrustedCertificates::Entry& entry)
{
    Statement(database, "INSERT OR REPLACE INTO certificate (endpoint, sha256) VALUES (?1, ?2)",
        entry.endpoint, entry.fingerprint)
        .run();
}

void removeCertificate(Connection& database, const std::string& endpoint)
{
    Statement(database, "DELETE FROM certificate WHERE endpoint = ?1", endpoint).run();
}

std::vector<TrustedCertificates::Entry> certificates(Connection& database)
{
    std::vector<TrustedCertificates::Entry> entries;
    for (Statement row(database, "SELECT endpoint, sha256 FROM certificate ORDER BY endpoint");
         row.next();)
        entries.push_back({row.text(0), row.text(1)});
    return entries;
}

} // namespace axiscomp::records
