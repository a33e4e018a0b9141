// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/text_reading.h"

#include "core/formats/text_scanner.h"

namespace axiscomp {

void TextReading::error(std::string_view number, DiagnosticCode code, std::size_t line,
    std::size_t column, std::string found, std::string expected)
{
    diagnostics.error({.severity = Severity::Error,
        .code = code,
        .line = line,
        .column = column,
        .found = std::move(found),
        .expected = std::move(expected),
        .controllerError = std::string(number)});
}

Result<TableReading> readText(const FamilyFacts& facts, std::string_view text,
    const TableReadOptions& options, std::vector<NeutralTable> (*parse)(TextReading&))
{
    const auto settings = SettingValues::of(facts, options.settings, false);
    if (!settings)
        return fail(settings.error());
    TableReading reading;
    DiagnosticList diagnostics(options.maximumDiagnostics);
    const bool isReadable = isReadableText(text, facts.mostBytes, diagnostics);
    const bool isBlank = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF") == std::string_view::npos;
    if (isReadable && isBlank) {
        diagnostics.error(DiagnosticCode::EmptyFile, 0, 0, "", "");
    } else if (isReadable) {
        TextReading source{text, options, *settings, diagnostics};
        reading.tables = parse(source);
    }
    reading.cancelled = options.stop.stop_requested();
    if (diagnostics.hasErrors() || reading.cancelled)
        reading.tables.clear();
    reading.suppressed = diagnostics.suppressed();
    reading.diagnostics = diagnostics.take();
    return reading;
}

} // namespace axiscomp
