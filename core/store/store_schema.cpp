// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/store_schema.h"

#include <array>
#include <string>

namespace axiscomp {

namespace {

constexpr std::int64_t applicationId = 0x41784370; // "AxCp"

// Times are nanoseconds since 1970 (UTC), CRCs unsigned, registers as in a backup (backup_json.h).
// A migration that has been in a release is never changed: what is new is appended as another one.
constexpr std::array migrations{
    R"(
CREATE TABLE drive (
    serial INTEGER PRIMARY KEY,
    flash_total INTEGER NOT NULL DEFAULT 0, -- operations ever recorded
    refused_at INTEGER,                     -- the drive itself reported wear
    refused_for INTEGER,                    -- seconds
    saved_known INTEGER NOT NULL DEFAULT 0,
    accepted_loss INTEGER NOT NULL DEFAULT 0 -- flash_loss.id up to which the user has decided
) STRICT;
CREATE TABLE flash_operation (
    id INTEGER PRIMARY KEY, serial INTEGER NOT NULL, time INTEGER NOT NULL, count INTEGER NOT NULL
) STRICT;
CREATE INDEX flash_operation_serial ON flash_operation (serial, id);
CREATE TABLE flash_loss (
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    serial INTEGER,       -- NULL: of all drives
    file TEXT NOT NULL    -- where the damaged record is kept, relative to the state folder
) STRICT;
CREATE TABLE journal (
    serial INTEGER NOT NULL, axis INTEGER NOT NULL, time INTEGER NOT NULL, step TEXT NOT NULL,
    backup TEXT NOT NULL, -- relative to the drive's folder where it is in it
    registers TEXT NOT NULL, slot TEXT NOT NULL, crc INTEGER NOT NULL, persistent INTEGER NOT NULL,
    table_file TEXT, table_size INTEGER, table_crc INTEGER, -- NULL: no table is kept
    PRIMARY KEY (serial, axis)
) STRICT;
CREATE TABLE own_table ( -- the newest has the largest id
    id INTEGER PRIMARY KEY, serial INTEGER NOT NULL, axis INTEGER NOT NULL, slot TEXT NOT NULL,
    crc INTEGER NOT NULL
) STRICT;
CREATE TABLE saved_use (
    id INTEGER PRIMARY KEY, serial INTEGER NOT NULL, axis INTEGER NOT NULL, slot TEXT NOT NULL,
    crc INTEGER NOT NULL
) STRICT;
CREATE TABLE covered_slot (
    id INTEGER PRIMARY KEY, serial INTEGER NOT NULL, slot TEXT NOT NULL, UNIQUE (serial, slot)
) STRICT;
CREATE TABLE certificate (endpoint TEXT PRIMARY KEY, sha256 TEXT NOT NULL) STRICT;
CREATE TABLE taken_over ( -- files of older versions that are still to be renamed
    file TEXT PRIMARY KEY, new_name TEXT NOT NULL
) STRICT;
)",
    "ALTER TABLE journal ADD COLUMN deleted_slot TEXT NOT NULL DEFAULT ''", // empty: none
    R"(
CREATE TABLE measured (
    id INTEGER PRIMARY KEY, serial INTEGER NOT NULL, axis INTEGER NOT NULL, crc INTEGER NOT NULL,
    time INTEGER NOT NULL, date TEXT NOT NULL, angular INTEGER NOT NULL,
    UNIQUE (serial, axis, crc)
) STRICT;
CREATE TABLE measured_figure ( -- in mm or deg, NULL: not known
    id INTEGER PRIMARY KEY, serial INTEGER NOT NULL, axis INTEGER NOT NULL, crc INTEGER NOT NULL,
    name TEXT NOT NULL, before REAL, predicted REAL, after REAL, tolerance REAL,
    result TEXT NOT NULL, UNIQUE (serial, axis, crc, name)
) STRICT;
)",
    // Where the table lies, as JSON (spansToJson); empty: not known.
    "ALTER TABLE measured ADD COLUMN grid TEXT NOT NULL DEFAULT ''",
    // Values that are left out.
    "ALTER TABLE measured ADD COLUMN left_out INTEGER NOT NULL DEFAULT 0",
    // What two measurements cover, where the last one covers less; in mm or deg, NULL: as much.
    R"(
ALTER TABLE measured ADD COLUMN before_first REAL;
ALTER TABLE measured ADD COLUMN before_last REAL;
ALTER TABLE measured ADD COLUMN after_first REAL;
ALTER TABLE measured ADD COLUMN after_last REAL;
)",
    // Where the table has to be looked up: "encoder" or "set", and "#1, other"; empty: not stated.
    R"(
ALTER TABLE measured ADD COLUMN lookup_at TEXT NOT NULL DEFAULT '';
ALTER TABLE measured ADD COLUMN targets TEXT NOT NULL DEFAULT '';
)",
    // Of the new table, as JSON (toJson of TableUnits); empty: not known.
    "ALTER TABLE journal ADD COLUMN units TEXT NOT NULL DEFAULT ''",
    // Of the table on the drive, likewise, and the name of its axis; empty: not known.
    R"(
ALTER TABLE measured ADD COLUMN units TEXT NOT NULL DEFAULT '';
ALTER TABLE measured ADD COLUMN axis_name TEXT NOT NULL DEFAULT '';
)",
    // The registers of the new sources, as a JSON list; empty: not known.
    "ALTER TABLE journal ADD COLUMN source_paths TEXT NOT NULL DEFAULT ''",
};

} // namespace

StoreIdentity storeIdentity(sqlite::Connection& database)
{
    const std::int64_t application = database.number("PRAGMA application_id");
    const std::int64_t version = database.number("PRAGMA user_version");
    const auto current = static_cast<std::int64_t>(migrations.size());
    if (application != applicationId)
        return StoreIdentity::Foreign;
    return version == current ? StoreIdentity::Ours
        : version < current   ? StoreIdentity::Older
                              : StoreIdentity::Newer;
}

void migrateStore(sqlite::Connection& database)
{
    sqlite::Transaction transaction(database, sqlite::Transaction::Kind::Write);
    const auto version = static_cast<std::size_t>(database.number("PRAGMA user_version"));
    for (std::size_t next = version; next < migrations.size(); ++next)
        database.run(migrations[next]);
    database.run("PRAGMA application_id = " + std::to_string(applicationId));
    database.run("PRAGMA user_version = " + std::to_string(migrations.size()));
    transaction.commit();
}

} // namespace axiscomp
