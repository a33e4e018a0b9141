// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output/doctor_output.h"

#include "app/cli/output/drive_json.h"
#include "app/cli/output/json_output.h"
#include "app/common/console.h"
#include "app/common/number_text.h"
#include "app/common/text_table.h"

#include <array>
#include <cstdio>
#include <cstdlib>

namespace axiscomp::app {

namespace {

std::string_view gradeName(Grade grade)
{
    switch (grade) {
    case Grade::Ok:
        return "ok";
    case Grade::Note:
        return "note";
    case Grade::Problem:
        break;
    }
    return "problem";
}

std::string homeFolder()
{
    const char* const home = std::getenv("HOME");
    return home != nullptr ? home : "";
}

std::string shareableText(const Text& text)
{
    return withoutSecrets(text.english(), homeFolder());
}

/// The same in every text of a document.
Json reportJson(Json json, const std::string& home)
{
    if (json.is_string())
        return withoutSecrets(json.get<std::string>(), home);
    if (json.is_structured())
        for (Json& element : json)
            element = reportJson(std::move(element), home);
    return json;
}

std::string lineOf(const Finding& finding)
{
    const std::string found = shareableText(finding.found);
    return finding.wayOut.isEmpty() ? found : found + " -> " + shareableText(finding.wayOut);
}

Json timeJson(const std::optional<WallTime>& time)
{
    return time ? Json(secondText(*time).text) : Json(nullptr);
}

Json findingsJson(const std::vector<FindingSection>& sections)
{
    Json all = Json::array();
    for (const FindingSection& section : sections)
        for (const Finding& finding : section.findings)
            all.push_back({{"section", section.title.english()}, {"name", finding.name.english()},
                {"grade", gradeName(finding.grade)}, {"found", finding.found.english()},
                {"wayOut", textOrNull(finding.wayOut.english())}});
    return all;
}

Json programJson(const ProgramFacts& program)
{
    Json libraries = Json::array();
    for (const LibraryVersion& library : program.libraries)
        libraries.push_back({{"name", library.name}, {"version", library.version},
            {"builtWith", library.builtWith}});
    return {{"version", program.version}, {"buildType", program.buildType}, {"path", program.path},
        {"libraries", std::move(libraries)}, {"tls", textOrNull(program.tls)},
        {"window", textOrNull(program.window)}, {"drawsPdf", program.drawsPdf}};
}

std::string_view kindName(FolderFacts::Kind kind)
{
    switch (kind) {
    case FolderFacts::Kind::Folder:
        return "Folder";
    case FolderFacts::Kind::Missing:
        return "Missing";
    case FolderFacts::Kind::Blocked:
        return "Blocked";
    case FolderFacts::Kind::Hidden:
        break;
    }
    return "Hidden";
}

std::string_view kindName(system::FileSystemFacts::Kind kind)
{
    switch (kind) {
    case system::FileSystemFacts::Kind::Disk:
        return "Disk";
    case system::FileSystemFacts::Kind::Network:
        return "Network";
    case system::FileSystemFacts::Kind::Memory:
        break;
    }
    return "Memory";
}

Json folderJson(const FolderFacts& folder)
{
    std::array<char, 8> mode{};
    std::snprintf(mode.data(), mode.size(), "%04o", folder.mode);
    const auto& system = folder.fileSystem;
    return {{"path", folder.path.string()}, {"kind", kindName(folder.kind)},
        {"nearest", folder.nearest.string()}, {"usable", folder.mayUse}, {"owner", folder.owner},
        {"own", folder.isOwn}, {"mode", mode.data()},
        {"fileSystem", system ? Json(kindName(system->kind)) : Json(nullptr)},
        {"readOnly", system ? Json(system->isReadOnly) : Json(nullptr)},
        {"freeBytes", system ? Json(system->freeBytes) : Json(nullptr)}};
}

Json systemJson(const ComputerFacts& computer)
{
    const SystemFacts& system = computer.system;
    const DisplayFacts& display = computer.display;
    return {{"distribution", textOrNull(system.distribution)}, {"kernel", system.kernel},
        {"architecture", system.architecture}, {"cores", system.cores}, {"memory", system.memory},
        {"freeMemory", system.freeMemory}, {"time", secondText(computer.clock.now).text},
        {"programMade", timeJson(computer.clock.program)}, {"display", textOrNull(display.display)},
        {"waylandDisplay", textOrNull(display.waylandDisplay)},
        {"platform", textOrNull(display.platform)},
        {"temporaryFolder", folderJson(computer.temporary)},
        {"runtimeFolder", computer.runtime ? folderJson(*computer.runtime) : Json(nullptr)},
        {"proxies", computer.proxies}};
}

Json languageJson(const DoctorFacts& facts)
{
    const LocaleFacts& locale = facts.computer.locale;
    Json variables = Json::object();
    for (const auto& [name, value] : locale.variables)
        variables[name] = value;
    return {{"variables", std::move(variables)}, {"installed", locale.isInstalled},
        {"encoding", locale.encoding}, {"utf8", locale.isUtf8()},
        {"decimalSign", locale.decimalSign}, {"translations", facts.languages}};
}

std::string_view databaseName(StoreCondition::Database database)
{
    switch (database) {
    case StoreCondition::Database::None:
        return "None";
    case StoreCondition::Database::Usable:
        return "Usable";
    case StoreCondition::Database::Older:
        return "Older";
    case StoreCondition::Database::Newer:
        return "Newer";
    case StoreCondition::Database::Foreign:
        return "Foreign";
    case StoreCondition::Database::Damaged:
        return "Damaged";
    case StoreCondition::Database::Busy:
        return "Busy";
    case StoreCondition::Database::NotCopied:
        return "NotCopied";
    case StoreCondition::Database::Unreadable:
        break;
    }
    return "Unreadable";
}

Json storeJson(const StoreCondition& store)
{
    Json writes = Json::array();
    for (const StoreCondition::Write& write : store.unfinished)
        writes.push_back({{"serialNumber", write.entry.serialNumber}, {"axis", write.entry.axis},
            {"began", utcText(write.entry.time)}, {"step", write.entry.step},
            {"isBeingWritten", write.isBeingDone}});
    Json journals = Json::array();
    for (const Error& error : store.damagedJournals)
        journals.push_back(toJson(error, Json::array()));
    Json setAside = Json::array();
    for (const auto& file : store.setAside)
        setAside.push_back(file.string());
    return {{"database", databaseName(store.database)}, {"bytes", store.bytes},
        {"reason", textOrNull(store.reason.english())}, {"lastChange", timeJson(store.lastChange)},
        {"unfinishedWrites", std::move(writes)}, {"damagedJournals", std::move(journals)},
        {"damagedFlashRecords", store.flashLoss}, {"setAside", std::move(setAside)},
        {"drives", store.drives}, {"backups", store.backups}, {"backupBytes", store.backupBytes}};
}

std::string_view settingsStateName(WindowSettings::State state)
{
    switch (state) {
    case WindowSettings::State::Missing:
        return "Missing";
    case WindowSettings::State::Readable:
        return "Readable";
    case WindowSettings::State::Unreadable:
        return "Unreadable";
    case WindowSettings::State::Malformed:
        break;
    }
    return "Malformed";
}

Json configurationJson(const ConfigurationFacts& facts)
{
    return {{"windowSettings", facts.window.file}, {"state", settingsStateName(facts.window.state)},
        {"connections", facts.window.drives.size()}, {"profile", textOrNull(facts.profile)},
        {"profileFile", textOrNull(facts.profileFile)},
        {"profileError",
            facts.profileError ? toJson(*facts.profileError, Json::array()) : Json(nullptr)},
        {"trustedCertificates", facts.certificates}};
}

Json portsJson(const std::vector<SerialPortFacts>& ports)
{
    Json all = Json::array();
    for (const SerialPortFacts& port : ports) {
        const auto& obstacle = port.access.obstacle;
        all.push_back({{"device", port.device}, {"description", port.description},
            {"usbId", textOrNull(port.usbId)}, {"usable", !obstacle.has_value()},
            {"group", obstacle ? textOrNull(obstacle->group) : Json(nullptr)}});
    }
    return all;
}

Json driveJson(const DriveAnswer& answer)
{
    Json axes = Json::array();
    for (const AxisSummary& row : answer.axes) {
        Json axis = toJson(row.axis);
        axis["status"] = row.status ? toJson(*row.status) : Json(nullptr);
        axis["error"] = row.problem ? toJson(*row.problem, Json::array()) : Json(nullptr);
        axes.push_back(std::move(axis));
    }
    const auto& drive = answer.drive;
    return {{"endpoint", textOrNull(answer.endpoint)}, {"profile", textOrNull(answer.profile)},
        {"drive", drive ? Json(drive->name) : Json(nullptr)},
        {"serialNumber", drive ? Json(drive->serialNumber) : Json(nullptr)},
        {"milliseconds", drive ? Json(answer.latency.count()) : Json(nullptr)},
        {"axes", std::move(axes)},
        {"error", answer.error ? toJson(*answer.error, Json::array()) : Json(nullptr)}};
}

bool belongsToAPath(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9')
        || std::string_view("/._-+~@%").find(c) != std::string_view::npos
        || static_cast<unsigned char>(c) >= 0x80;
}

} // namespace

std::string withoutSecrets(std::string_view text, std::string_view homeFolder)
{
    std::string result = withoutPasswords(singleLine(text));
    while (homeFolder.ends_with('/'))
        homeFolder.remove_suffix(1);
    if (homeFolder.empty())
        return result;
    for (std::size_t place = result.find(homeFolder); place != std::string::npos;
         place = result.find(homeFolder, place + 1)) {
        const std::size_t end = place + homeFolder.size();
        const bool isWhole = (place == 0 || !belongsToAPath(result[place - 1]))
            && (end == result.size() || result[end] == '/' || !belongsToAPath(result[end]));
        if (isWhole)
            result.replace(place, homeFolder.size(), "~");
    }
    return result;
}

std::vector<FindingSection> doctorFindings(const DoctorFacts& facts)
{
    return {programFindings(facts.program), systemFindings(facts.computer),
        languageFindings(facts.computer.locale, facts.languages),
        storeFindings(facts.stateFolder, facts.store, facts.computer.clock.now),
        configurationFindings(facts.configuration), serialFindings(facts.ports),
        driveFindings(facts.drives)};
}

std::size_t countOf(const std::vector<FindingSection>& sections, Grade grade)
{
    std::size_t count = 0;
    for (const FindingSection& section : sections)
        for (const Finding& finding : section.findings)
            count += finding.grade == grade ? 1 : 0;
    return count;
}

std::string doctorText(const DoctorFacts& facts, const std::vector<FindingSection>& sections)
{
    std::string text = "axiscomp doctor, " + secondText(facts.computer.clock.now).text + "\n";
    for (const FindingSection& section : sections) {
        std::vector<std::pair<std::string, std::string>> lines;
        for (const Finding& finding : section.findings) {
            std::string grade(gradeName(finding.grade));
            grade.resize(gradeName(Grade::Problem).size() + 2, ' ');
            lines.emplace_back(grade + shareableText(finding.name), lineOf(finding));
        }
        text += "\n" + shareableText(section.title) + "\n" + labelled(lines, "  ");
    }
    const std::size_t problems = countOf(sections, Grade::Problem);
    text += "\n" + (problems == 0 ? "No problems" : plural(problems, "problem", "problems")) + ", "
        + plural(countOf(sections, Grade::Note), "note", "notes") + ".\n";
    return text;
}

Json doctorJson(const DoctorFacts& facts, const std::vector<FindingSection>& sections)
{
    Json drives = Json::array();
    for (const DriveAnswer& answer : facts.drives)
        drives.push_back(driveJson(answer));
    Json document = {{"problems", countOf(sections, Grade::Problem)},
        {"notes", countOf(sections, Grade::Note)}, {"findings", findingsJson(sections)},
        {"program", programJson(facts.program)}, {"system", systemJson(facts.computer)},
        {"language", languageJson(facts)}, {"stateFolder", folderJson(facts.stateFolder)},
        {"store", facts.store ? storeJson(*facts.store) : Json(nullptr)},
        {"configuration", configurationJson(facts.configuration)},
        {"serialPorts", portsJson(facts.ports)}, {"drives", std::move(drives)}};
    return reportJson(std::move(document), homeFolder());
}

} // namespace axiscomp::app
