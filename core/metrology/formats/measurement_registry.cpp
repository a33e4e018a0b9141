// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/formats/measurement_formats.h"
#include "core/text/text_file.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <array>

namespace axiscomp {

namespace {

/// What tells one format from another stands within this.
constexpr std::size_t measurementBeginning = std::size_t{64} * 1024;

bool hasMeasurementExtension(const MeasurementFacts& facts, std::string_view fileName)
{
    return std::ranges::any_of(facts.extensions, [&](std::string_view extension) {
        return fileName.size() > extension.size()
            && sameLetters(fileName.substr(fileName.size() - extension.size()), extension);
    });
}

/// Which kind of CSV a mapping of columns means.
const MeasurementFormat& mappedFormat(const std::vector<ColumnMapping>& columns)
{
    const auto has = [&columns](std::string_view role) {
        return std::ranges::any_of(
            columns, [role](const ColumnMapping& one) { return sameLetters(one.role, role); });
    };
    if (has("X") && has("Y"))
        return points_csv::format();
    return has("target") ? runs_csv::format() : track_csv::format();
}

/// An empty file, another kind of file, UTF-16: the reader of text says which.
bool isNoText(std::string_view beginning)
{
    DiagnosticList diagnostics(1);
    const TextInspection inspection(beginning, {}, diagnostics);
    return diagnostics.hasErrors()
        || beginning.find_first_not_of(" \t\r\n\xEF\xBB\xBF") == std::string_view::npos;
}

/// The CSV format that the columns would be of if they were not separated by tabs: its reader says
/// that. Null: none.
const MeasurementFormat* formatWithTabs(std::string_view beginning)
{
    std::string separated(beginning);
    std::ranges::replace(separated, '\t', ',');
    if (separated == beginning)
        return nullptr;
    for (const MeasurementFormat* format :
        {&runs_csv::format(), &wide_csv::format(), &track_csv::format(), &points_csv::format()})
        if (format->recognise(separated) != MeasurementRecognition::No)
            return format;
    return nullptr;
}

tl::unexpected<Error> wrongMapping(std::string_view text)
{
    return fail(ErrorCode::InvalidArgument,
        {{"reason",
            AXISCOMP_TEXT("Error",
                "\"{text}\" names no columns; write target=1,direction=3,deviation=5, with numbers "
                "or names of columns")
                .with("text", text)}});
}

} // namespace

bool MeasurementReading::hasErrors() const
{
    return suppressed > 0
        || std::ranges::find(diagnostics, Severity::Error, &Diagnostic::severity)
        != diagnostics.end();
}

Result<std::vector<ColumnMapping>> columnMappingFromText(std::string_view text)
{
    std::vector<Token> parts;
    splitCells({text, 0, 1}, ',', parts);
    std::vector<ColumnMapping> columns;
    for (const Token& part : parts) {
        const std::size_t equals = part.text.find('=');
        if (equals == std::string_view::npos)
            return wrongMapping(text);
        ColumnMapping mapping{std::string(trimmedToken({part.text.substr(0, equals), 0, 1}).text),
            std::string(trimmedToken({part.text.substr(equals + 1), 0, 1}).text)};
        if (mapping.role.empty() || mapping.column.empty())
            return wrongMapping(text);
        columns.push_back(std::move(mapping));
    }
    return columns;
}

std::span<const MeasurementFormat* const> measurementFormats()
{
    static const std::array formats{
        &runs_csv::format(),
        &wide_csv::format(),
        &track_csv::format(),
        &points_csv::format(),
        &renishaw::format(),
        &api_pos::format(),
        &ecmc_data::format(),
        &ecmc_report::format(),
    };
    return formats;
}

std::string measurementFormatNames()
{
    std::string names;
    for (const MeasurementFormat* format : measurementFormats())
        names += (names.empty() ? "" : ", ") + std::string(format->facts.name);
    return names;
}

bool isCertainMeasurement(std::string_view beginning)
{
    return std::ranges::any_of(measurementFormats(), [beginning](const MeasurementFormat* format) {
        return format->recognise(beginning.substr(0, measurementBeginning))
            == MeasurementRecognition::Certain;
    });
}

Result<const MeasurementFormat*> measurementFormatNamed(std::string_view name)
{
    for (const MeasurementFormat* format : measurementFormats())
        if (sameLetters(name, format->facts.name))
            return format;
    return fail(ErrorCode::UnknownFormat,
        {{"file", std::string(name)}, {"known", measurementFormatNames()}});
}

Result<const MeasurementFormat*> chooseMeasurementFormat(
    std::string_view text, std::string_view fileName, const MeasurementReadOptions& options)
{
    if (!options.columns.empty())
        return &mappedFormat(options.columns);
    const std::string_view beginning = text.substr(0, measurementBeginning);
    if (isNoText(beginning))
        return &runs_csv::format();
    std::vector<const MeasurementFormat*> certain;
    std::vector<const MeasurementFormat*> possible;
    for (const MeasurementFormat* format : measurementFormats()) {
        const auto recognition = format->recognise(beginning);
        if (recognition == MeasurementRecognition::Certain)
            certain.push_back(format);
        else if (recognition == MeasurementRecognition::Possible
            && hasMeasurementExtension(format->facts, fileName))
            possible.push_back(format);
    }
    std::vector<const MeasurementFormat*>& found = certain.empty() ? possible : certain;
    if (found.size() == 1)
        return found.front();
    if (found.empty()) {
        if (const MeasurementFormat* const format = formatWithTabs(beginning))
            return format;
        return fail(ErrorCode::UnknownFormat,
            {{"file", std::string(fileName)}, {"known", measurementFormatNames()},
                {"measurement", Verbatim{"yes"}}});
    }
    std::string names;
    for (const MeasurementFormat* format : found)
        names += (names.empty() ? "" : ", ") + std::string(format->facts.name);
    return fail(
        ErrorCode::FormatAmbiguous, {{"file", std::string(fileName)}, {"candidates", names}});
}

Error measurementError(const std::string& file, const MeasurementReading& reading)
{
    std::size_t errors = reading.suppressed;
    std::size_t units = 0;
    std::size_t scales = 0;
    for (const Diagnostic& diagnostic : reading.diagnostics) {
        errors += diagnostic.severity == Severity::Error ? 1 : 0;
        units += diagnostic.code == DiagnosticCode::UnitMissing ? 1 : 0;
        scales += diagnostic.code == DiagnosticCode::InstrumentScale ? 1 : 0;
    }
    if (units == errors)
        return {ErrorCode::UnitMissing, {{"file", file}}, {}};
    if (scales == errors)
        return {ErrorCode::InstrumentScale, {{"file", file}}, {}};
    return {ErrorCode::InvalidMeasurement, {{"file", file}, {"count", errors}}, {}};
}

} // namespace axiscomp
