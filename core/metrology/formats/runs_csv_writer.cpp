// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/formats/measurement_format.h"
#include "core/metrology/header_texts.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <array>

namespace axiscomp {

namespace {

void appendStatement(std::string& text, std::string_view key, const std::string& value)
{
    if (!value.empty())
        text.append("// ").append(key).append(": ").append(value).append("\n");
}

std::string numberOrNothing(const std::optional<double>& number)
{
    return number ? shortestText(*number) : std::string();
}

std::string headerText(const Measurement& measurement)
{
    const MeasurementHeader& header = measurement.header;
    std::string text = "// axiscomp runs: 1\n";
    if (measurement.kind == MeasurementKind::Averages)
        appendStatement(text, "kind", std::string(measurementKindName(measurement.kind)));
    for (const HeaderText& said : headerTexts)
        appendStatement(text, said.key, header.*said.member);
    appendStatement(text, "compensation", measuredStateText(header.compensation));
    appendStatement(text, "air temperature", numberOrNothing(header.airTemperature));
    appendStatement(text, "material temperature", numberOrNothing(header.materialTemperature));
    appendStatement(text, "expansion", numberOrNothing(header.expansion));
    if (header.corrected != MeasurementHeader::Corrected::NotSaid)
        appendStatement(text, "corrected",
            header.corrected == MeasurementHeader::Corrected::None ? "none" : "20C");
    // What looks like a statement is not to become one.
    for (const std::string& note : measurement.notes)
        text.append(note.find(':') == std::string::npos ? "// " : "// note: ")
            .append(note)
            .append("\n");
    return text;
}

/// A column that only some values have.
struct FurtherColumn {
    std::string_view name;
    bool hasUnit;
    std::optional<double> RunValue::*member;
};
constexpr std::array furtherColumns{FurtherColumn{"encoder", true, &RunValue::encoder},
    FurtherColumn{"output", true, &RunValue::output}, FurtherColumn{"time", false, &RunValue::time},
    FurtherColumn{"temperature", false, &RunValue::temperature}};

} // namespace

std::string writeRunsCsv(const Measurement& measurement)
{
    const std::string unit = " [" + std::string(positionUnit(measurement)) + "]";
    std::vector<FurtherColumn> further;
    for (const FurtherColumn& column : furtherColumns)
        if (std::ranges::any_of(measurement.values,
                [&](const RunValue& value) { return (value.*column.member).has_value(); }))
            further.push_back(column);
    std::string text = headerText(measurement);
    text += "target" + unit + ",direction,run,deviation" + unit;
    for (const FurtherColumn& column : further)
        text += "," + std::string(column.name) + (column.hasUnit ? unit : std::string());
    const bool marksUse = measurement.excludedCount() > 0;
    text += marksUse ? ",use\n" : "\n";
    for (const RunValue& value : measurement.values) {
        text += shortestText(measurement.targets[value.target]);
        text += value.direction == Approach::Up ? ",+," : ",-,";
        text += std::to_string(value.run) + "," + shortestText(value.deviation);
        for (const FurtherColumn& column : further)
            text += "," + numberOrNothing(value.*column.member);
        if (marksUse)
            text += value.isUsed ? ",1" : ",0";
        text += '\n';
    }
    // Otherwise the figures of the written file would be those of a measurement without them.
    for (const double target : targetsWithoutValues(measurement))
        text += shortestText(target) + ",+,1,"
            + std::string(further.size() + (marksUse ? 1 : 0), ',') + "\n";
    return text;
}

} // namespace axiscomp
