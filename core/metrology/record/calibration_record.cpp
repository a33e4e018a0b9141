// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/record/calibration_record.h"

#include "core/io/local_file.h"
#include "core/metrology/record/fit_json.h"
#include "core/metrology/record/measurement_json.h"
#include "core/metrology/record/record_fields.h"
#include "core/store/backup_json.h"
#include "core/table/position_unit.h"

#include <algorithm>
#include <utility>

namespace axiscomp {

namespace {

using namespace record_json;

constexpr std::string_view recordFormat = "axiscomp-record";
constexpr JsonLimits recordLimits{.size = maximumRecordSize, .depth = 16, .values = 50'000'000};
constexpr std::string_view approachKeys[] = {"up", "down"};
constexpr std::string_view driftKeys[] = {"offset", "trend"};

OrderedJson toJson(const RecordedFile& file)
{
    OrderedJson object{{"file", file.file}, {"format", file.format}, {"sha256", file.sha256},
        {"measurement", axiscomp::toJson(file.measurement)}};
    putBack(object, file.others);
    return object;
}

RecordedFile fileFromJson(const JsonNode& node)
{
    RecordedFile file{node["file"].text(), node["format"].text(), node["sha256"].text(),
        measurementFromJson(node["measurement"])};
    constexpr std::size_t digits = 64;
    if (file.sha256.size() != digits
        || file.sha256.find_first_not_of("0123456789abcdef") != std::string::npos)
        node["sha256"].refuse(
            AXISCOMP_TEXT("Error", "a SHA-256 of 64 hexadecimal digits is expected"));
    file.others = otherMembers(node, toJson(file));
    return file;
}

OrderedJson toJson(const AirState& air)
{
    return {{"pressure", air.pressureKilopascal}, {"temperature", air.celsius},
        {"humidity", air.humidityPercent}};
}

AirState airFromJson(const JsonNode& node)
{
    return {node["pressure"].number(), node["temperature"].number(), node["humidity"].number()};
}

OrderedJson toJson(const TemperatureCorrection& correction)
{
    OrderedJson object{{"material", correction.materialCelsius},
        {"expansion", correction.expansionPerKelvin}, {"reference", correction.referenceCelsius},
        {"referenceExpansion", correction.referenceExpansionPerKelvin}};
    putIfThere(object, "datum", correction.datum);
    object["confirmed"] = correction.isConfirmed;
    return object;
}

TemperatureCorrection temperatureFromJson(const JsonNode& node)
{
    return {node["material"].number(), node["expansion"].number(), node["reference"].number(),
        node["referenceExpansion"].number(), maybeNumber(node, "datum"),
        node["confirmed"].boolean()};
}

OrderedJson toJson(const DeadPathCorrection& correction)
{
    OrderedJson runs = OrderedJson::array();
    for (const auto& [run, air] : correction.duringRun)
        runs.push_back({{"direction", nameOf(run.first, approachKeys)}, {"run", run.second},
            {"air", toJson(air)}});
    return {{"length", correction.lengthMm}, {"atZero", toJson(correction.atZero)},
        {"runs", std::move(runs)}};
}

DeadPathCorrection deadPathFromJson(const JsonNode& node)
{
    DeadPathCorrection correction{node["length"].number(), airFromJson(node["atZero"])};
    for (const JsonNode& item : node["runs"].items()) {
        const std::pair run{
            enumFromJson<Approach>(item["direction"], approachKeys), item["run"].integer<int>(1)};
        if (!correction.duringRun.emplace(run, airFromJson(item["air"])).second)
            item.refuse(AXISCOMP_TEXT("Error", "this is there twice"));
    }
    return correction;
}

OrderedJson toJson(const RecordedCorrections& corrections)
{
    OrderedJson object = OrderedJson::object();
    if (corrections.temperature)
        object["temperature"] = toJson(*corrections.temperature);
    if (corrections.deadPath)
        object["deadPath"] = toJson(*corrections.deadPath);
    if (corrections.drift)
        object["drift"] = nameOf(*corrections.drift, driftKeys);
    return object;
}

RecordedCorrections correctionsFromJson(const JsonNode& node)
{
    RecordedCorrections corrections;
    if (isThere(node, "temperature"))
        corrections.temperature = temperatureFromJson(node["temperature"]);
    if (isThere(node, "deadPath"))
        corrections.deadPath = deadPathFromJson(node["deadPath"]);
    if (isThere(node, "drift"))
        corrections.drift = enumFromJson<DriftRemoval>(node["drift"], driftKeys);
    return corrections;
}

/// Without the files, which keep their other members themselves.
OrderedJson frameToJson(const RecordedMeasurement& recorded)
{
    OrderedJson exclusions = OrderedJson::array();
    for (const Exclusion& exclusion : recorded.exclusions)
        exclusions.push_back(exclusionText(exclusion));
    return {{"files", OrderedJson::array()}, {"swapDirections", recorded.swapsDirections},
        {"exclude", std::move(exclusions)}, {"corrections", toJson(recorded.corrections)}};
}

OrderedJson toJson(const RecordedMeasurement& recorded)
{
    OrderedJson object = frameToJson(recorded);
    for (const RecordedFile& file : recorded.files)
        object["files"].push_back(toJson(file));
    putBack(object, recorded.others);
    return object;
}

RecordedMeasurement recordedMeasurementFromJson(const JsonNode& node)
{
    RecordedMeasurement recorded;
    for (const JsonNode& item : node["files"].items())
        recorded.files.push_back(fileFromJson(item));
    if (recorded.files.empty())
        node["files"].refuse(AXISCOMP_TEXT("Error", "at least one file is expected"));
    recorded.swapsDirections = node["swapDirections"].boolean();
    for (const JsonNode& item : node["exclude"].items()) {
        const auto exclusions = exclusionsFromText(item.textView());
        if (!exclusions || exclusions->size() != 1)
            item.refuse(AXISCOMP_TEXT(
                "Error", "what is left out is expected, such as down:1:1, run:up:3 or target:7"));
        else
            recorded.exclusions.push_back(exclusions->front());
    }
    recorded.corrections = correctionsFromJson(node["corrections"]);
    recorded.others = otherMembers(node, frameToJson(recorded));
    return recorded;
}

OrderedJson toJson(const RecordedDrive& drive)
{
    OrderedJson object{{"name", drive.name}, {"serialNumber", drive.serialNumber},
        {"profile", drive.profile}, {"axis", drive.axis}, {"axisName", drive.axisName},
        {"compensation", axiscomp::toJson(drive.state)}};
    putBack(object, drive.others);
    return object;
}

RecordedDrive driveFromRecord(const JsonNode& node)
{
    RecordedDrive drive{node["name"].text(), node["serialNumber"].integer<std::int32_t>(),
        node["profile"].text(), node["axis"].integer<int>(0), node["axisName"].text(),
        measuredStateFromJson(node["compensation"])};
    drive.others = otherMembers(node, toJson(drive));
    return drive;
}

OrderedJson toJson(const RecordedWrite& write)
{
    OrderedJson object{{"time", utcText(write.time)}, {"slot", write.slot},
        {"persistent", write.isPersistent}, {"crc32", crcText(write.crc)}};
    if (write.grid)
        object["axes"] = spansToJson(*write.grid);
    if (write.units)
        object["units"] = axiscomp::toJson(*write.units);
    if (write.proof)
        object["proof"] = {{"proved", write.proof->isProved}, {"samples", write.proof->samples},
            {"largestDifference", write.proof->largestDifference},
            {"tolerance", write.proof->tolerance}, {"provedShare", write.proof->provedShare}};
    putBack(object, write.others);
    return object;
}

RecordedWrite writeFromJson(const JsonNode& node)
{
    RecordedWrite write{timeFromJson(node["time"]), node["slot"].text(),
        node["persistent"].boolean(), crcFromJson(node["crc32"])};
    if (isThere(node, "axes"))
        write.grid = spansFromJson(node["axes"]);
    if (isThere(node, "units"))
        write.units = unitsFromJson(node["units"]);
    if (isThere(node, "proof")) {
        const JsonNode proof = node["proof"];
        write.proof = RecordedWrite::Proof{proof["proved"].boolean(),
            proof["samples"].integer<int>(0), proof["largestDifference"].number(),
            proof["tolerance"].number(), proof["provedShare"].number()};
    }
    write.others = otherMembers(node, toJson(write));
    return write;
}

/// Without the measurement.
OrderedJson frameToJson(const RecordedAfter& after)
{
    OrderedJson object{{"measurement", nullptr}, {"figures", axiscomp::toJson(after.figures)}};
    putIfThere(object, "asPredicted", after.isAsPredicted);
    if (after.tableCrc)
        object["crc32"] = crcText(*after.tableCrc);
    return object;
}

OrderedJson toJson(const RecordedAfter& after)
{
    OrderedJson object = frameToJson(after);
    object["measurement"] = toJson(after.measurement);
    putBack(object, after.others);
    return object;
}

RecordedAfter afterFromJson(const JsonNode& node)
{
    RecordedAfter after{
        recordedMeasurementFromJson(node["measurement"]), figureValuesFromJson(node["figures"])};
    if (isThere(node, "asPredicted"))
        after.isAsPredicted = node["asPredicted"].boolean();
    if (isThere(node, "crc32"))
        after.tableCrc = crcFromJson(node["crc32"]);
    after.others = otherMembers(node, frameToJson(after));
    return after;
}

/// Without the measurements.
OrderedJson frameToJson(const RecordedDraft& draft)
{
    OrderedJson object = OrderedJson::object();
    if (draft.before)
        object["before"] = nullptr;
    if (draft.after)
        object["after"] = nullptr;
    if (draft.isTableStated)
        object["tableStated"] = true;
    return object;
}

OrderedJson toJson(const RecordedDraft& draft)
{
    OrderedJson object = frameToJson(draft);
    if (draft.before)
        object["before"] = toJson(*draft.before);
    if (draft.after)
        object["after"] = toJson(*draft.after);
    putBack(object, draft.others);
    return object;
}

RecordedDraft draftFromJson(const JsonNode& node)
{
    RecordedDraft draft;
    if (isThere(node, "before"))
        draft.before = recordedMeasurementFromJson(node["before"]);
    if (isThere(node, "after"))
        draft.after = recordedMeasurementFromJson(node["after"]);
    draft.isTableStated = maybeTrue(node, "tableStated");
    draft.others = otherMembers(node, frameToJson(draft));
    return draft;
}

OrderedJson documentFrame(const CalibrationRecord& record)
{
    OrderedJson object{{"format", recordFormat}, {"version", recordVersion}};
    putIfThere(object, "program", record.program);
    if (record.time)
        object["time"] = utcText(*record.time);
    putIfThere(object, "notes", record.notes);
    return object;
}

template <typename Value>
void putPart(OrderedJson& document, const char* key, const std::optional<Value>& part)
{
    if (part)
        document[key] = toJson(*part);
}

template <typename Value>
void putParts(OrderedJson& document, const char* key, const std::vector<Value>& parts)
{
    for (const Value& part : parts)
        document[key].push_back(toJson(part));
}

template <typename Value>
void takePart(const JsonNode& document, std::string_view key, std::optional<Value>& part,
    Value (*read)(const JsonNode&))
{
    if (isThere(document, key))
        part = read(document[key]);
}

template <typename Value>
void takeParts(const JsonNode& document, std::string_view key, std::vector<Value>& parts,
    Value (*read)(const JsonNode&))
{
    if (isThere(document, key))
        for (const JsonNode& item : document[key].items())
            parts.push_back(read(item));
}

void expectRecord(const JsonNode& document)
{
    const JsonNode format = document["format"];
    if (format.textView() != recordFormat)
        format.refuse(
            AXISCOMP_TEXT("Error", "\"{format}\" is expected").with("format", recordFormat));
    const JsonNode version = document["version"];
    const int found = version.integer<int>(1);
    if (found > recordVersion)
        version.refuse(AXISCOMP_TEXT("Error",
            "the record has version {found}, and this program reads version {known} at most; open "
            "it with a newer version of the program")
                           .with("found", found)
                           .with("known", recordVersion));
}

OtherMembers othersOfDocument(const JsonNode& document, const CalibrationRecord& record)
{
    OrderedJson known = documentFrame(record);
    for (const char* part : {"before", "fit", "tables", "prediction", "drive", "write", "after",
             "verdict", "judging", "draft"})
        known[part] = nullptr;
    return otherMembers(document, known);
}

bool holdsOnlyScalars(const OrderedJson& value)
{
    return std::ranges::none_of(
        value, [](const OrderedJson& item) { return item.is_structured(); });
}

/// Indented, with lists of numbers and small objects on a line of their own, so that two records
/// can be compared line by line.
void write(const OrderedJson& value, const std::string& indent, std::string& text)
{
    constexpr auto replace = OrderedJson::error_handler_t::replace;
    if (!value.is_structured() || value.empty() || holdsOnlyScalars(value)) {
        text += value.dump(-1, ' ', false, replace);
        return;
    }
    const std::string inner = indent + "  ";
    text += value.is_array() ? "[" : "{";
    bool isFirst = true;
    for (const auto& [key, item] : value.items()) {
        text += (isFirst ? "\n" : ",\n") + inner;
        isFirst = false;
        if (value.is_object())
            text += OrderedJson(key).dump(-1, ' ', false, replace) + ": ";
        write(item, inner, text);
    }
    text += "\n" + indent + (value.is_array() ? "]" : "}");
}

} // namespace

Result<CorrectedMeasurement> correctedMeasurement(const RecordedMeasurement& recorded)
{
    std::vector<Measurement> measurements;
    for (const RecordedFile& file : recorded.files)
        measurements.push_back(file.measurement);
    AXISCOMP_TRY(auto whole, selected(measurements, recorded.swapsDirections, recorded.exclusions));
    return corrected(
        std::move(whole), {recorded.corrections.temperature, recorded.corrections.deadPath});
}

Result<Measurement> usedMeasurement(const RecordedMeasurement& recorded)
{
    AXISCOMP_TRY(auto used, correctedMeasurement(recorded));
    return std::move(used.measurement);
}

std::optional<std::int32_t> statedDrive(const RecordedMeasurement& recorded)
{
    for (const RecordedFile& file : recorded.files)
        if (const auto serial = driveSerialOf(file.measurement.header))
            return serial;
    return std::nullopt;
}

RecordedJudging judgingOf(const CalibrationRecord& record)
{
    RecordedJudging judging;
    if (record.judging) {
        judging = *record.judging;
    } else if (record.fit) {
        judging.outlierRule = record.fit->settings.outlierRule;
        judging.tolerances = record.fit->settings.tolerances;
        judging.uncertainty = record.fit->settings.uncertainty;
    }
    if (!record.verdict || record.verdict->figures.empty())
        return judging;
    judging.tolerances.clear();
    for (const Verdict& verdict : record.verdict->figures) {
        judging.tolerances.push_back(verdict.tolerance);
        judging.uncertainty = verdict.uncertainty;
    }
    return judging;
}

Result<DeadPathCorrection> deadPathFromText(std::string_view text, const std::string& fileName)
{
    StrictJson json(text, {.size = maximumDeadPathSize});
    const JsonNode root = json.root();
    constexpr std::array<std::string_view, 3> keys{"length", "atZero", "runs"};
    root.expectMembers(keys, std::span<const std::string_view>());
    auto correction = json.problem() ? DeadPathCorrection{} : deadPathFromJson(root);
    if (json.problem())
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error", "{file} does not describe a dead path: {reason}")
                    .with("file", Verbatim{fileName})
                    .with("reason", json.problem()->reason)}});
    return correction;
}

bool isSameTable(const RecordedTable& a, const RecordedTable& b)
{
    const auto hasUnitOf = [](const GridAxis& one, const GridAxis& other) {
        return isSameUnit(one.unit, other.unit);
    };
    return isSameTable(TableIdentity{a.crc, a.table.grid}, TableIdentity{b.crc, b.table.grid})
        && isSameUnit(a.table.unit, b.table.unit)
        && std::ranges::equal(a.table.grid.axes, b.table.grid.axes, hasUnitOf);
}

const RecordedAfter* lastAfter(const CalibrationRecord& record)
{
    std::optional<std::uint32_t> active;
    if (record.write)
        active = record.write->crc;
    else if (!record.tables.empty())
        active = record.tables.front().crc;
    const auto found = std::find_if(record.after.rbegin(), record.after.rend(),
        [&](const RecordedAfter& after) { return !after.tableCrc || after.tableCrc == active; });
    return found == record.after.rend() ? nullptr : &*found;
}

std::string recordText(const CalibrationRecord& record)
{
    OrderedJson document = documentFrame(record);
    putPart(document, "before", record.before);
    putPart(document, "fit", record.fit);
    putParts(document, "tables", record.tables);
    putPart(document, "prediction", record.prediction);
    putPart(document, "drive", record.drive);
    putPart(document, "write", record.write);
    putParts(document, "after", record.after);
    putPart(document, "verdict", record.verdict);
    putPart(document, "judging", record.judging);
    putPart(document, "draft", record.draft);
    putBack(document, record.others);
    std::string text;
    write(document, {}, text);
    return text + "\n";
}

Result<CalibrationRecord> recordFromText(std::string_view text, const std::string& fileName)
{
    StrictJson json(text, recordLimits);
    const JsonNode document = json.root();
    CalibrationRecord record;
    expectRecord(document);
    if (!json.problem()) {
        record.program = maybeText(document, "program");
        if (isThere(document, "time"))
            record.time = timeFromJson(document["time"]);
        record.notes = maybeTexts(document, "notes");
        takePart(document, "before", record.before, &recordedMeasurementFromJson);
        takePart(document, "fit", record.fit, &recordedFitFromJson);
        takeParts(document, "tables", record.tables, &recordedTableFromJson);
        takePart(document, "prediction", record.prediction, &predictionFromJson);
        takePart(document, "drive", record.drive, &driveFromRecord);
        takePart(document, "write", record.write, &writeFromJson);
        takeParts(document, "after", record.after, &afterFromJson);
        takePart(document, "verdict", record.verdict, &verdictFromJson);
        takePart(document, "judging", record.judging, &judgingFromJson);
        takePart(document, "draft", record.draft, &draftFromJson);
        record.others = othersOfDocument(document, record);
    }
    if (json.problem())
        return fail(
            ErrorCode::InvalidRecord, {{"file", fileName}, {"reason", json.problem()->reason}});
    return record;
}

Result<void> saveRecord(const std::filesystem::path& file, const CalibrationRecord& record)
{
    return saveFile(file, asBytes(recordText(record)));
}

Result<CalibrationRecord> loadRecord(const std::filesystem::path& file)
{
    AXISCOMP_TRY(const auto bytes, loadFile(file, maximumRecordSize));
    return recordFromText(asText(bytes), file.string());
}

} // namespace axiscomp
