// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/drive_store.h"
#include "core/store/sqlite.h"
#include "core/store/trusted_certificates.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// What stands in the tables of the database, as the values of DriveStore. All throw
/// sqlite::Failure and are called in a transaction.
namespace axiscomp::records {

/// folder: the drive's; a backup in it is kept relative to it, so that the store can be moved.
void putJournal(
    sqlite::Connection& database, const JournalEntry& entry, const std::filesystem::path& folder);
[[nodiscard]] std::optional<JournalEntry> journal(sqlite::Connection& database,
    std::int32_t serialNumber, int axis, const std::filesystem::path& folder);
/// Of all drives: serial number, axis, time and step alone.
[[nodiscard]] std::vector<JournalEntry> journals(sqlite::Connection& database);
void removeJournal(sqlite::Connection& database, std::int32_t serialNumber, int axis);

void addFlash(sqlite::Connection& database, std::int32_t serialNumber, WallTime time,
    std::uint64_t operations);
/// Operations of which the time is not known.
void addToFlashTotal(
    sqlite::Connection& database, std::int32_t serialNumber, std::uint64_t operations);
void setFlashRefusal(sqlite::Connection& database, std::int32_t serialNumber,
    const DriveStore::FlashHistory::Refusal& refusal);
/// file: where the damaged record is kept, relative to the state folder.
void addFlashLoss(sqlite::Connection& database, std::optional<std::int64_t> serialNumber,
    const std::string& file);
void acceptFlashLoss(sqlite::Connection& database, std::int32_t serialNumber);
[[nodiscard]] DriveStore::FlashHistory flashHistory(
    sqlite::Connection& database, std::int32_t serialNumber, const std::filesystem::path& root);

/// The drives whose flash operations count as used up (FlashHistory::damagedRecord), of those that
/// the database knows or that have a folder below root, in their order.
[[nodiscard]] std::vector<std::int32_t> drivesWithFlashLoss(
    sqlite::Connection& database, const std::filesystem::path& root);

void addOwnTable(sqlite::Connection& database, std::int32_t serialNumber, int axis,
    const DriveStore::OwnTable& table);
[[nodiscard]] std::vector<DriveStore::OwnTable> ownTables(
    sqlite::Connection& database, std::int32_t serialNumber, int axis);

void addUses(sqlite::Connection& database, std::int32_t serialNumber,
    const std::vector<SavedState::Use>& uses);
void replaceUses(sqlite::Connection& database, std::int32_t serialNumber,
    const std::vector<SavedState::Use>& uses);
void setCovered(sqlite::Connection& database, std::int32_t serialNumber, const std::string& slot,
    bool isCovered);
[[nodiscard]] SavedState savedState(sqlite::Connection& database, std::int32_t serialNumber);

/// Replaces what was known with the same table, where takesPlaceOf says so.
void putMeasured(sqlite::Connection& database, std::int32_t serialNumber, int axis,
    const MeasuredFigures& measured, Measuring measuring);
[[nodiscard]] std::optional<MeasuredFigures> measured(
    sqlite::Connection& database, std::int32_t serialNumber, int axis, std::uint32_t crc);

void putCertificate(sqlite::Connection& database, const TrustedCertificates::Entry& entry);
void removeCertificate(sqlite::Connection& database, const std::string& endpoint);
[[nodiscard]] std::vector<TrustedCertificates::Entry> certificates(sqlite::Connection& database);

} // namespace axiscomp::records
