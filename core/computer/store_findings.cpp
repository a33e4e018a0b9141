// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/computer/store_findings.h"

#include "core/computer/computer_findings.h"

#include <string_view>

namespace axiscomp {

namespace {

using Database = StoreCondition::Database;

const char* const stateVariable = "XDG_STATE_HOME";
/// Clocks of computers that share a folder differ a little.
constexpr std::chrono::hours aheadOfTheClock{1};

/// As a shell reads it; not in quotation marks, in which a tilde would be no folder.
std::string shellWord(const std::filesystem::path& path)
{
    std::string word;
    for (const char c : path.string()) {
        const bool isPlain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')
            || (c >= '0' && c <= '9')
            || std::string_view("/._-+~@%:,").find(c) != std::string_view::npos
            || static_cast<unsigned char>(c) >= 0x80;
        word += isPlain ? "" : "\\";
        word += c;
    }
    return word;
}

Finding folderFinding(const FolderFacts& folder)
{
    const Text name = AXISCOMP_TEXT("Doctor", "folder");
    const Text path = Verbatim{folder.path.string()};
    const bool isThere = folder.kind == FolderFacts::Kind::Folder;
    if (isThere && !folder.isOwn && !folder.isRoot && !folder.mayUse)
        return {name, Grade::Problem,
            AXISCOMP_TEXT("Doctor", "{folder} belongs to {owner}")
                .with("folder", path)
                .with("owner", folder.owner),
            AXISCOMP_TEXT("Doctor", "sudo chown -R $USER {folder}; run this program without sudo")
                .with("folder", shellWord(folder.path))};
    if (isThere && folder.isOwn && !folder.mayUse && folder.fileSystem
        && !folder.fileSystem->isReadOnly)
        return {name, Grade::Problem,
            AXISCOMP_TEXT("Doctor", "{folder} is yours, but its permissions keep you out")
                .with("folder", path),
            Verbatim{"chmod u+rwx " + shellWord(folder.path)}};
    if (auto obstacle = folderObstacle(name, folder, stateVariable))
        return *std::move(obstacle);
    if (!isThere)
        return {name, Grade::Ok,
            AXISCOMP_TEXT("Doctor", "{folder} is not there yet; the first write makes it")
                .with("folder", path)};
    if (!folder.isOwn && !folder.isRoot)
        return {name, Grade::Note,
            AXISCOMP_TEXT("Doctor", "{folder} belongs to {owner}")
                .with("folder", path)
                .with("owner", folder.owner)};
    if (!folder.isOwn)
        return {name, Grade::Note,
            AXISCOMP_TEXT("Doctor",
                "{folder} belongs to {owner}, and you are root: what is made "
                "there now belongs to root")
                .with("folder", path)
                .with("owner", folder.owner),
            AXISCOMP_TEXT("Doctor", "run this program without sudo")};
    if (folder.othersMayChange())
        return {name, Grade::Note,
            AXISCOMP_TEXT("Doctor", "{folder} can be changed by other users").with("folder", path),
            Verbatim{"chmod go-w " + shellWord(folder.path)}};
    return {name, Grade::Ok,
        AXISCOMP_TEXT("Doctor", "{folder}, {free} free")
            .with("folder", path)
            .with("free", byteQuantity(folder.fileSystem ? folder.fileSystem->freeBytes : 0))};
}

Finding fileSystemFinding(const FolderFacts& folder)
{
    const Text name = AXISCOMP_TEXT("Doctor", "file system");
    if (!folder.fileSystem)
        return {name, Grade::Note, AXISCOMP_TEXT("Doctor", "not known")};
    switch (folder.fileSystem->kind) {
    case system::FileSystemFacts::Kind::Network:
        return {name, Grade::Problem,
            AXISCOMP_TEXT("Doctor",
                "on the network, where a database can be damaged: nothing is "
                "kept there, and no write begins"),
            AXISCOMP_TEXT("Doctor", "set {variable} to a folder on this computer")
                .with("variable", Verbatim{stateVariable})};
    case system::FileSystemFacts::Kind::Memory:
        return {name, Grade::Note,
            AXISCOMP_TEXT("Doctor", "in memory: backups and journal are gone after a restart"),
            AXISCOMP_TEXT("Doctor", "set {variable} to a folder on a disk")
                .with("variable", Verbatim{stateVariable})};
    case system::FileSystemFacts::Kind::Disk:
        break;
    }
    return {name, Grade::Ok, AXISCOMP_TEXT("Doctor", "of this computer")};
}

Finding databaseFinding(const StoreCondition& condition)
{
    const Text name = AXISCOMP_TEXT("Doctor", "database");
    const Text moveAway = AXISCOMP_TEXT("Doctor", "move it away");
    switch (condition.database) {
    case Database::None:
        return {name, Grade::Ok, AXISCOMP_TEXT("Doctor", "none yet; the first write makes it")};
    case Database::Usable:
        break;
    case Database::Older:
        return {name, Grade::Note,
            AXISCOMP_TEXT("Doctor",
                "of an older version, {size}; the next command that needs it "
                "brings it up to date")
                .with("size", byteQuantity(condition.bytes))};
    case Database::Newer:
        return {name, Grade::Problem,
            AXISCOMP_TEXT("Doctor", "a newer version of this program has written it"),
            AXISCOMP_TEXT("Doctor", "use that version")};
    case Database::Foreign:
        return {name, Grade::Problem,
            AXISCOMP_TEXT("Doctor", "it is the database of another program"), moveAway};
    case Database::Damaged:
        return {name, Grade::Problem,
            AXISCOMP_TEXT("Doctor", "it is damaged ({reason})").with("reason", condition.reason),
            AXISCOMP_TEXT("Doctor",
                "the next command that needs it sets it aside and keeps what can be read; look "
                "what the drives hold, then `axiscomp status --reset-flash-count` for each")};
    case Database::Busy:
        return {name, Grade::Note,
            AXISCOMP_TEXT("Doctor", "not checked, because programs write to it all the time"),
            AXISCOMP_TEXT("Doctor", "try again when they have finished")};
    case Database::NotCopied:
        return {name, Grade::Note,
            AXISCOMP_TEXT("Doctor", "not checked: {reason}").with("reason", condition.reason),
            AXISCOMP_TEXT("Doctor", "make room there, or set {variable} to another folder")
                .with("variable", Verbatim{"TMPDIR"})};
    case Database::Unreadable:
        return {name, Grade::Problem, condition.reason};
    }
    if (!condition.isWritable)
        return {name, Grade::Problem,
            AXISCOMP_TEXT("Doctor", "you have no permission to change it"),
            AXISCOMP_TEXT("Doctor",
                "let the user have it to whom the folder belongs (chown, "
                "chmod u+rw)")};
    return {name, Grade::Ok,
        AXISCOMP_TEXT("Doctor", "whole, {size}").with("size", byteQuantity(condition.bytes))};
}

Finding writeFinding(const StoreCondition::Write& write)
{
    const Text name = AXISCOMP_TEXT("Doctor", "interrupted write");
    const JournalEntry& entry = write.entry;
    const auto about = [&](const TextPattern& pattern) {
        return Text(pattern)
            .with("axis", entry.axis)
            .with("drive", Verbatim{std::to_string(entry.serialNumber)})
            .with("time", secondText(entry.time))
            .with("step", Verbatim{entry.step});
    };
    if (write.isBeingDone)
        return {AXISCOMP_TEXT("Doctor", "write"), Grade::Note,
            about(AXISCOMP_TEXT("Doctor",
                "a program is writing to axis {axis} of the drive with "
                "serial number {drive} now, since {time} ({step})"))};
    return {name, Grade::Problem,
        about(AXISCOMP_TEXT("Doctor",
            "a write to axis {axis} of the drive with serial number "
            "{drive} began at {time} and did not end (step {step})")),
        AXISCOMP_TEXT("Doctor",
            "`axiscomp recover --axis {axis}` with that drive says what it holds, and finishes "
            "the write or undoes it")
            .with("axis", entry.axis)};
}

void addJournal(const StoreCondition& condition, std::vector<Finding>& findings)
{
    for (const StoreCondition::Write& write : condition.unfinished)
        findings.push_back(writeFinding(write));
    for (const Error& error : condition.damagedJournals)
        findings.push_back(
            {AXISCOMP_TEXT("Doctor", "interrupted write"), Grade::Problem, textOf(error)});
    const bool isKnown = condition.database == Database::None
        || condition.database == Database::Usable || condition.database == Database::Older;
    if (condition.unfinished.empty() && condition.damagedJournals.empty())
        findings.push_back(
            {AXISCOMP_TEXT("Doctor", "interrupted writes"), isKnown ? Grade::Ok : Grade::Note,
                isKnown ? AXISCOMP_TEXT("Doctor", "none") : AXISCOMP_TEXT("Doctor", "not known")});
}

void addHistory(const StoreCondition& condition, WallTime now, std::vector<Finding>& findings)
{
    for (const std::int32_t drive : condition.flashLoss)
        findings.push_back({AXISCOMP_TEXT("Doctor", "flash record"), Grade::Note,
            AXISCOMP_TEXT("Doctor",
                "that of the drive with serial number {drive} was damaged: "
                "its flash operations count as used up")
                .with("drive", Verbatim{std::to_string(drive)}),
            AXISCOMP_TEXT("Doctor",
                "wait as long as the drive counts them, then `axiscomp status "
                "--reset-flash-count`")});
    for (const std::filesystem::path& file : condition.setAside)
        findings.push_back({AXISCOMP_TEXT("Doctor", "set aside"), Grade::Note,
            AXISCOMP_TEXT("Doctor", "{file} is an earlier database that was damaged")
                .with("file", file.string()),
            AXISCOMP_TEXT("Doctor", "delete it when nothing is missed")});
    if (condition.lastChange && *condition.lastChange > now + aheadOfTheClock)
        findings.push_back({AXISCOMP_TEXT("Doctor", "last change"), Grade::Note,
            AXISCOMP_TEXT("Doctor", "{time} is still to come: the clock was set back since")
                .with("time", secondText(*condition.lastChange)),
            AXISCOMP_TEXT("Doctor", "look at the clock: flash operations are counted by it")});
    findings.push_back({AXISCOMP_TEXT("Doctor", "backups"), Grade::Ok,
        AXISCOMP_TEXT("Doctor", "files: {backups}, drives: {drives}, {size}")
            .with("backups", condition.backups)
            .with("drives", condition.drives)
            .with("size", byteQuantity(condition.backupBytes))});
}

} // namespace

FindingSection storeFindings(
    const FolderFacts& folder, const std::optional<StoreCondition>& condition, WallTime now)
{
    FindingSection section{AXISCOMP_TEXT("Doctor", "State folder"), {}};
    section.findings = {folderFinding(folder), fileSystemFinding(folder)};
    if (!condition) {
        section.findings.push_back({AXISCOMP_TEXT("Doctor", "database"), Grade::Note,
            AXISCOMP_TEXT(
                "Doctor", "not checked, because no copy could be made in the temporary folder")});
        return section;
    }
    section.findings.push_back(databaseFinding(*condition));
    addJournal(*condition, section.findings);
    addHistory(*condition, now, section.findings);
    return section;
}

} // namespace axiscomp
