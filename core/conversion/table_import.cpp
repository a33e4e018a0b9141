// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/table_import.h"

#include "core/conversion/lookup_sides.h"
#include "core/csv/cells.h"
#include "core/formats/formats.h"
#include "core/formats/triamec/triamec_tables.h"
#include "core/io/local_file.h"
#include "core/neutral/sign_note.h"
#include "core/table/tam_table.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>

namespace axiscomp {

namespace {

/// The import's choices can help: uneven positions, points without a value.
bool isOfTheGrid(const Diagnostic& diagnostic, int dimensions)
{
    switch (diagnostic.code) {
    case DiagnosticCode::UnevenSpacing:
    case DiagnosticCode::MissingPoint:
        return true;
    case DiagnosticCode::NotANumber:
    case DiagnosticCode::NotFinite:
        return diagnostic.column > static_cast<std::size_t>(dimensions)
            && csv::isNoValue(diagnostic.found.english());
    default:
        return diagnostic.severity == Severity::Warning;
    }
}

/// Two columns of a file may have one name, but a table of many is found by its.
std::string distinctName(std::set<std::string>& taken, const std::string& wanted)
{
    std::string name = wanted;
    for (int n = 2; !taken.insert(name).second; ++n)
        name = wanted + " (" + std::to_string(n) + ')';
    return name;
}

std::vector<TableName> namesOfTables(const std::vector<CompensationTable>& tables)
{
    std::vector<TableName> names;
    for (const CompensationTable& table : tables)
        names.push_back({table.name, table.name});
    return names;
}

/// As they stand: a name of several is for chooseTable() to refuse.
std::vector<TableName> namesOfColumns(const std::vector<NeutralTable>& columns)
{
    std::vector<TableName> names;
    for (const NeutralTable& table : columns) {
        const CompensationColumn& column = table.columns.front();
        const std::string& inFile = column.name.empty() ? table.name : column.name;
        names.push_back(
            {nameOfTable(table, 0), inFile.empty() ? columnText(table, column).english() : inFile});
    }
    return names;
}

class Import {
public:
    explicit Import(const TableImportRequest& request) : m_request(request)
    {
        m_result.sign = request.choices.sign;
    }

    [[nodiscard]] TableImport run()
    {
        chooseFormat();
        if (m_result.refusal || m_result.format == nullptr)
            return std::move(m_result);
        if (auto taken = takeSettings(); !taken)
            refuse(taken.error());
        else if (!isTriamec(*m_result.format))
            readOther();
        else if (m_result.format == &calibration_csv::format())
            readCsv();
        else
            readTamTable();
        return std::move(m_result);
    }

private:
    void chooseFormat();
    [[nodiscard]] Result<Bytes> bytes(std::uint64_t limit);
    /// With the units that are stated. Errors: InvalidArgument.
    [[nodiscard]] Result<void> takeSettings();
    void readCsv();
    void readTamTable();
    void readOther();
    [[nodiscard]] bool takeSign(const std::vector<std::string>& notes);
    /// By their numbers. Errors: those of TableImportRequest::choose.
    [[nodiscard]] Result<std::vector<std::size_t>> wantedOf(
        const std::vector<TableName>& tables) const;
    void take(CalibrationData data);
    void refuseIncomplete();
    void convert(const std::vector<NeutralTable>& whole);
    /// One table, with the notes that it has then.
    [[nodiscard]] Result<CalibrationData> converted(
        const NeutralTable& column, std::shared_ptr<const NeutralTable> beside);
    void refuse(const Error& error) { m_result.refusal = error; }
    void problem(const Error& error)
    {
        m_result.problems.push_back(
            {Severity::Error, DiagnosticCode::IoError, 0, 0, textOf(error), {}});
    }

    const TableImportRequest& m_request;
    TableImport m_result;
    FormatSettings m_settings;
    std::set<std::string> m_names; ///< of the tables so far
    std::optional<LookupAt> m_lookupAt; ///< for which the tables so far were made
    bool m_isOneOfSeveral = false; ///< the table that is converted
};

void Import::chooseFormat()
{
    const std::string name = m_request.file.filename().string();
    const std::string text = beginningOf(m_request.file);
    m_result.candidates = guessFormat(text, name).formats;
    m_result.format = m_request.choices.format;
    if (m_result.format != nullptr)
        return;
    const auto choice = axiscomp::chooseFormat(text, name, false);
    if (isOfMeasurement(choice))
        return problem(choice.error());
    // What nobody knows is read as a calibration file: its problems say what one looks like.
    m_result.format = choice ? choice->format : &calibration_csv::format();
    if (choice || choice.error().code != ErrorCode::FormatAmbiguous)
        return;
    m_result.format = m_result.candidates.front();
    if (formatOfExtension(name) == &calibration_csv::format())
        m_result.candidates.push_back(&calibration_csv::format());
    refuse(choice.error());
}

Result<void> Import::takeSettings()
{
    const FormatFacts& facts = m_result.format->facts;
    const ImportChoices& choices = m_request.choices;
    AXISCOMP_TRY(m_settings, withStatedUnits(facts, choices.settings, choices.units));
    // Other formats check them where they read.
    if (isTriamec(*m_result.format))
        AXISCOMP_CHECK(SettingValues::of(facts, m_settings, false));
    return {};
}

Result<Bytes> Import::bytes(std::uint64_t limit)
{
    auto bytes = loadFile(m_request.file, limit);
    if (!bytes)
        problem(bytes.error());
    return bytes;
}

/// A calibration file may say itself that it holds command values.
bool Import::takeSign(const std::vector<std::string>& notes)
{
    auto sign = signOfTable(notes, m_request.choices.sign);
    if (sign)
        m_result.sign = *sign;
    else
        refuse(sign.error());
    return sign.has_value();
}

Result<std::vector<std::size_t>> Import::wantedOf(const std::vector<TableName>& tables) const
{
    if (m_request.choose) {
        AXISCOMP_TRY(const auto chosen, m_request.choose(tables));
        return std::vector{chosen};
    }
    std::vector<std::size_t> all(tables.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
}

void Import::take(CalibrationData data)
{
    m_result.sourceAxes = data.grid.dimensions();
    if (!takeSign(data.notes))
        return;
    if (m_request.choices.isConversion() || m_result.sign == SignConvention::Command) {
        convert(std::vector{neutralTable(data)});
        return;
    }
    const auto wanted = wantedOf(namesOfTables(data.tables));
    if (!wanted)
        return refuse(wanted.error());
    std::vector<CompensationTable> tables;
    for (const std::size_t n : *wanted) {
        takeStatedUnits(data.tables[n], m_request.choices.units);
        tables.push_back(std::move(data.tables[n]));
    }
    data.tables = std::move(tables);
    data.grid = data.tables.front().grid;
    m_result.data = std::make_shared<const CalibrationData>(std::move(data));
}

/// A file that other choices make usable is refused with its first problem, not given up.
void Import::refuseIncomplete()
{
    const auto& problems = m_result.problems;
    const auto isOfIt = [&](const Diagnostic& d) { return isOfTheGrid(d, m_request.dimensions); };
    const auto first = std::ranges::find_if(problems, [](const Diagnostic& d) {
        return d.severity == Severity::Error && d.code != DiagnosticCode::UnevenSpacing;
    });
    if (first != problems.end() && std::ranges::all_of(problems, isOfIt))
        refuse({ErrorCode::InvalidArgument, {{"reason", textOf(*first)}}, {}});
}

void Import::readCsv()
{
    CsvOptions options;
    options.dimensions = m_request.dimensions;
    options.units = statedUnits(m_settings, m_request.choices.units);
    options.missing = m_request.choices.missing;
    options.snap = m_request.choices.snap;
    options.stop = m_request.stop;
    options.progress = m_request.progress;
    CsvReading reading = readCalibrationCsv(m_request.file, options);
    const bool isOnlyUneven = reading.hasErrors() && reading.suppressed == 0
        && std::ranges::all_of(reading.diagnostics, [](const Diagnostic& d) {
               return d.severity == Severity::Warning || d.code == DiagnosticCode::UnevenSpacing;
           });
    m_result.isCancelled = reading.cancelled;
    m_result.problems = std::move(reading.diagnostics);
    m_result.suppressedProblems = reading.suppressed;
    m_result.fullGrid = std::move(reading.fullGrid);
    if (reading.data)
        take(*std::move(reading.data));
    else if (!isOnlyUneven)
        refuseIncomplete();
    if (!isOnlyUneven || m_result.isCancelled)
        return;
    options.acceptsUneven = true;
    CsvReading uneven = readCalibrationCsv(m_request.file, options);
    m_result.isCancelled = uneven.cancelled;
    if (!uneven.data)
        return;
    if (!takeSign(uneven.data->notes))
        return;
    m_result.sourceAxes = uneven.data->grid.dimensions();
    convert(std::vector{neutralTable(*uneven.data, uneven.knots)});
    if (m_result.data)
        m_result.problems = std::move(uneven.diagnostics);
}

void Import::readTamTable()
{
    constexpr std::uint64_t largestFile = 64ULL * 1024 * 1024; // far more than any drive holds
    const auto content = bytes(largestFile);
    if (!content)
        return;
    auto decoded = decodeTamTable(*content, *m_request.layout);
    if (!decoded) {
        problem(decoded.error());
        return;
    }
    CalibrationData data;
    data.grid = decoded->table.grid;
    if (decoded->table.name.empty())
        decoded->table.name = m_request.file.stem().string();
    data.tables.push_back(std::move(decoded->table));
    stateUnits(data, m_settings);
    take(std::move(data));
}

void Import::readOther()
{
    const TableFormat& format = *m_result.format;
    if (format.read == nullptr)
        return refuse({ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error", "the format {format} can be written, not read")
                    .with("format", format.facts.name)}},
            {}});
    const auto content = bytes(format.facts.mostBytes);
    if (!content)
        return;
    TableReadOptions options;
    options.settings = m_settings;
    options.missing = m_request.choices.missing;
    options.snap = m_request.choices.snap;
    options.layout = m_request.layout;
    options.stop = m_request.stop;
    auto reading = format.read(asText(*content), options);
    if (!reading)
        return refuse(reading.error());
    m_result.isCancelled = reading->cancelled;
    const bool isUsable = !reading->hasErrors() && !reading->tables.empty();
    m_result.problems = std::move(reading->diagnostics);
    m_result.suppressedProblems = reading->suppressed;
    if (isUsable && !m_result.isCancelled)
        convert(reading->tables);
    else if (format.facts.marksMissing && !m_result.isCancelled)
        refuseIncomplete();
}

void Import::convert(const std::vector<NeutralTable>& whole)
{
    const std::vector<NeutralTable> tables = separateColumns(whole);
    m_result.sourceAxes = static_cast<int>(tables.front().axes.size());
    for (const NeutralTable& table : tables) {
        m_result.hasDirections = m_result.hasDirections
            || std::ranges::any_of(table.columns,
                [](const CompensationColumn& c) { return c.direction != Direction::Both; });
        m_result.hasWrap = m_result.hasWrap
            || std::ranges::any_of(table.axes, [](const SourceAxis& a) { return !!a.wrap; });
    }
    const auto wanted = wantedOf(namesOfColumns(tables));
    if (!wanted)
        return refuse(wanted.error());
    m_isOneOfSeveral = wanted->size() > 1;
    CalibrationData data;
    for (const std::size_t n : *wanted) {
        if (m_request.stop.stop_requested()) {
            m_result.isCancelled = true;
            return;
        }
        auto one = converted(tables[n], sourcesBeside(whole, n));
        if (!one)
            return refuse(one.error());
        if (data.tables.empty())
            data = *std::move(one);
        else
            data.tables.push_back(std::move(one->tables.front()));
    }
    // Any of its columns may have been made for one of the two.
    m_result.usedPlace.lookupAt = !isOfDrive(*m_result.format, m_result.sign);
    if (m_result.usedPlace.lookupAt)
        data.notes = withLookupNote(std::move(data.notes), m_lookupAt);
    m_result.usedPlace.target =
        std::ranges::any_of(data.tables, &CompensationTable::isTargetOfDrive);
    m_result.data = std::make_shared<const CalibrationData>(std::move(data));
}

Result<CalibrationData> Import::converted(
    const NeutralTable& column, std::shared_ptr<const NeutralTable> beside)
{
    const ImportChoices& choices = m_request.choices;
    ConversionRequest request;
    request.from = m_result.format;
    request.to = &calibration_csv::format();
    request.sourceSign = m_result.sign;
    request.targets = choices.targetsFor(column);
    request.beside = std::move(beside);
    request.units = choices.units;
    request.direction = choices.direction;
    request.dropsWrap = choices.dropsWrap;
    if (!isOfDrive(*request.from, m_result.sign))
        request.lookupAt = choices.place.lookupAt;
    AXISCOMP_TRY(auto resampling, resamplingRequest(choices.resampling, column.axes.size()));
    request.resampling = std::move(resampling);
    AXISCOMP_TRY(const auto conversion, convertTables(std::span(&column, 1), request));
    AXISCOMP_TRY(auto data, calibrationData(conversion.written.held.front()));
    CompensationTable& table = data.tables.front();
    table.isTargetOfDrive = choices.target.empty() && !request.targets.empty();
    table.name = distinctName(m_names, table.name);
    if (const auto lookupAt = conversion.tables.front().lookupAt)
        m_lookupAt = lookupAt;
    if (m_isOneOfSeveral)
        m_result.report.emplace_back(Verbatim{table.name + ':'});
    std::ranges::move(conversionReport(conversion, request), std::back_inserter(m_result.report));
    return data;
}

} // namespace

TableImport importTables(const TableImportRequest& request)
{
    return Import(request).run();
}

} // namespace axiscomp
