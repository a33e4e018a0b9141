// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/firmware/state_folder.h"

#include "core/io/local_file.h"
#include "drivecomm/codec/json_parsing.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

namespace axiscomp::drivecomm {

namespace {

using nlohmann::json;

constexpr std::uint64_t maximumJson = std::uint64_t{64} << 20;
constexpr std::uint64_t maximumTable = std::uint64_t{64} << 20;
constexpr std::string_view tableEnding = ".TAMtbl";
constexpr std::string_view flashFolder = "flash";
constexpr int format = 1;

/// The name of a table's file is new for every flash operation.
std::string tableFile(std::string_view slot, std::uint32_t eraseCount)
{
    std::string name(slot);
    std::ranges::replace_if(
        name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name + '-' + std::to_string(eraseCount) + std::string(tableEnding);
}

json toJson(const RegisterValue& value)
{
    return std::visit([](const auto& held) { return json(held); }, value);
}

std::optional<RegisterValue> toValue(const json& value)
{
    if (value.is_boolean())
        return value.get<bool>();
    if (value.is_string())
        return value.get<std::string>();
    if (value.is_number())
        return value.get<double>();
    return {};
}

/// Takes typed members out of a JSON object; complaint keeps the first that is not as it must be.
class Reader {
public:
    Reader(const json& object, std::string place, Text& complaint)
        : m_object(object)
        , m_place(std::move(place))
        , m_complaint(complaint)
    {
    }
    [[nodiscard]] std::int64_t integer(const char* key, std::int64_t least, std::int64_t most)
    {
        const auto member = m_object.find(key);
        if (member == m_object.end() || !member->is_number_integer()
            || (member->is_number_unsigned()
                && member->get<std::uint64_t>() > static_cast<std::uint64_t>(most))
            || member->get<std::int64_t>() < least || member->get<std::int64_t>() > most) {
            complain(key,
                AXISCOMP_TEXT("Error", "a whole number from {least} to {most}")
                    .with("least", least)
                    .with("most", most));
            return least;
        }
        return member->get<std::int64_t>();
    }
    [[nodiscard]] const json& part(const char* key, json::value_t type, const Text& expected)
    {
        static const json nothing;
        const auto member = m_object.find(key);
        if (member != m_object.end() && member->type() == type)
            return *member;
        complain(key, expected);
        return nothing;
    }
    /// Empty when there is none.
    [[nodiscard]] std::string fileName(const char* key)
    {
        const auto member = m_object.find(key);
        if (member == m_object.end())
            return {};
        std::string name = member->is_string() ? member->get<std::string>() : "";
        if (name.empty() || name.find_first_of("/\\") != std::string::npos)
            complain(key,
                AXISCOMP_TEXT("Error", "the name of a file in the folder {folder}")
                    .with("folder", flashFolder));
        return name;
    }
    void complain(const std::string& key, const Text& expected)
    {
        if (m_complaint.isEmpty())
            m_complaint = AXISCOMP_TEXT("Error", "{place} must be {expected}")
                              .with("place", m_place + key)
                              .with("expected", expected);
    }

private:
    const json& m_object;
    std::string m_place;
    Text& m_complaint;
};

tl::unexpected<Error> unreadable(const std::filesystem::path& file, Text reason)
{
    return fail(
        ErrorCode::FileNotReadable, {{"file", file.string()}, {"reason", std::move(reason)}});
}

struct ParsedSlot {
    std::uint32_t eraseCount = 0;
    std::string file;
};

std::map<std::string, ParsedSlot> parseSlots(const json& slots, Text& complaint)
{
    std::map<std::string, ParsedSlot> result;
    for (const auto& [name, slot] : slots.items()) {
        Reader reader(slot, "slots." + name + ".", complaint);
        result[name] = {static_cast<std::uint32_t>(reader.integer(
                            "eraseCount", 0, std::numeric_limits<std::uint32_t>::max())),
            reader.fileName("file")};
    }
    return result;
}

/// Everything but the tables; slots says where they are.
SavedDrive parseDrive(
    const json& document, std::map<std::string, ParsedSlot>& slots, Text& complaint)
{
    Reader reader(document, "", complaint);
    SavedDrive drive;
    (void)reader.integer("format", format, format);
    drive.serialNumber = static_cast<std::int32_t>(reader.integer("serialNumber",
        std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max()));
    drive.savedAt = WallTime(std::chrono::duration_cast<WallTime::duration>(
        std::chrono::milliseconds(reader.integer("savedAtMs", 0, std::int64_t{1} << 42))));
    const Text ages = AXISCOMP_TEXT("Error", "a list of whole numbers, 0 or more");
    for (const json& age : reader.part("flashOperationAgesNs", json::value_t::array, ages)) {
        if (!age.is_number_integer() || age.get<std::int64_t>() < 0)
            reader.complain("flashOperationAgesNs", ages);
        else
            drive.operationAges.emplace_back(age.get<std::int64_t>());
    }
    const Text object = AXISCOMP_TEXT("Error", "an object");
    for (const auto& [path, value] :
        reader.part("parameters", json::value_t::object, object).items()) {
        if (const std::optional<RegisterValue> parsed = toValue(value))
            drive.parameters.emplace(path, *parsed);
        else
            reader.complain(
                "parameters." + path, AXISCOMP_TEXT("Error", "a boolean, a number or a text"));
    }
    slots = parseSlots(reader.part("slots", json::value_t::object, object), complaint);
    return drive;
}

/// Whatever cannot be removed does no harm.
void removeFiles(const std::filesystem::path& folder,
    const std::function<bool(const std::filesystem::path&)>& unused)
{
    std::error_code ignored;
    std::filesystem::directory_iterator file(folder, ignored);
    for (; file != std::filesystem::directory_iterator{}; file.increment(ignored))
        if (unused(file->path()))
            std::filesystem::remove(file->path(), ignored);
}

} // namespace

StateFolder::StateFolder(std::filesystem::path folder, FileLock lock)
    : m_folder(std::move(folder))
    , m_lock(std::move(lock))
{
}

Result<std::unique_ptr<StateFolder>> StateFolder::open(const std::filesystem::path& folder)
{
    std::error_code problem;
    std::filesystem::create_directories(folder / flashFolder, problem);
    if (problem)
        return fail(
            ErrorCode::FileNotWritable, {{"file", folder.string()}, {"reason", problem.message()}});
    Result<FileLock> lock =
        FileLock::acquire(folder / "lock", std::chrono::milliseconds(0), folder);
    if (!lock)
        return fail(lock.error());
    return std::unique_ptr<StateFolder>(new StateFolder(folder, *std::move(lock)));
}

Result<std::optional<SavedDrive>> StateFolder::load()
{
    std::error_code problem;
    if (!std::filesystem::exists(mainFile(), problem) && !problem) {
        removeUnused();
        return std::nullopt;
    }
    const Result<Bytes> bytes = loadFile(mainFile(), maximumJson);
    if (!bytes)
        return fail(bytes.error());
    const json document = parseJson(asText(*bytes));
    if (!document.is_object())
        return unreadable(
            mainFile(), AXISCOMP_TEXT("Error", "it is not the JSON of a virtual drive's state"));

    Text complaint;
    std::map<std::string, ParsedSlot> slots;
    SavedDrive drive = parseDrive(document, slots, complaint);
    if (!complaint.isEmpty())
        return unreadable(mainFile(), complaint);

    for (const auto& [name, slot] : slots) {
        drive.slots[name].eraseCount = slot.eraseCount;
        if (slot.file.empty())
            continue;
        Result<Bytes> table = loadFile(m_folder / flashFolder / slot.file, maximumTable);
        if (!table)
            return fail(table.error());
        drive.slots[name].table = std::make_shared<const Bytes>(*std::move(table));
        m_tableFiles.insert(slot.file);
    }
    removeUnused();
    return drive;
}

Result<void> StateFolder::save(const SavedDrive& drive)
{
    std::set<std::string> files;
    json slots = json::object();
    for (const auto& [name, slot] : drive.slots) {
        json& saved = slots[name] = {{"eraseCount", slot.eraseCount}};
        if (!slot.table)
            continue;
        const std::string file = tableFile(name, slot.eraseCount);
        saved["file"] = file;
        files.insert(file);
        if (m_tableFiles.contains(file))
            continue;
        if (Result<void> written = saveFile(m_folder / flashFolder / file, *slot.table); !written)
            return written;
    }
    json ages = json::array();
    for (const std::chrono::nanoseconds age : drive.operationAges)
        ages.push_back(age.count());
    json parameters = json::object();
    for (const auto& [path, value] : drive.parameters)
        parameters[path] = toJson(value);
    const json document{{"format", format}, {"serialNumber", drive.serialNumber},
        {"savedAtMs",
            std::chrono::duration_cast<std::chrono::milliseconds>(drive.savedAt.time_since_epoch())
                .count()},
        {"flashOperationAgesNs", ages}, {"parameters", parameters}, {"slots", slots}};
    const std::string text = document.dump(1, ' ', false, json::error_handler_t::replace) + '\n';
    if (Result<void> written = saveFile(mainFile(), asBytes(text)); !written)
        return written;
    m_tableFiles = std::move(files);
    removeUnused();
    return {};
}

/// Tables of former states, and what a save left behind that did not come to its end.
void StateFolder::removeUnused() const
{
    removeFiles(m_folder, isTemporaryFile);
    removeFiles(m_folder / flashFolder, [&](const std::filesystem::path& file) {
        const std::string name = file.filename().string();
        return isTemporaryFile(file)
            || (name.ends_with(tableEnding) && !m_tableFiles.contains(name));
    });
}

} // namespace axiscomp::drivecomm
