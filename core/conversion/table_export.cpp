// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/table_export.h"

#include "core/formats/formats.h"
#include "core/formats/triamec/triamec_tables.h"

namespace axiscomp {

Result<TableExport> exportTable(const CompensationTable& table, const ImportChoices& choices,
    const std::string& fileName, const TableLayout& layout, const TableFacts& facts)
{
    const auto& lookupAt = choices.place.lookupAt;
    const NeutralTable source = neutralTable(CalibrationData{
        table.grid, {table}, lookupAt ? withLookupNote(facts.notes, lookupAt) : facts.notes});
    ConversionRequest request;
    request.from = &calibration_csv::format();
    request.to = choices.format;
    request.targetSign = choices.sign;
    request.targets = choices.targetsFor(source);
    request.isComputed = facts.isComputed;
    request.writing.layout = &layout;
    request.writing.settings = choices.settings;
    request.writing.fileName = fileName;
    AXISCOMP_TRY(auto resampling, resamplingRequest(choices.resampling, source.axes.size()));
    request.resampling = std::move(resampling);
    AXISCOMP_TRY(auto conversion, convertTables(std::span(&source, 1), request));
    std::vector<Text> report = conversionReport(conversion, request);
    return TableExport{std::move(conversion.written.bytes), std::move(report)};
}

} // namespace axiscomp
