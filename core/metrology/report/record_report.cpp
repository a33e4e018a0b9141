// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/report/record_report.h"

#include "core/metrology/fine_quantity.h"
#include "core/metrology/joined_files.h"
#include "core/metrology/record/comparison.h"
#include "core/metrology/record/reference_reading.h"
#include "core/metrology/report/report_text.h"
#include "core/table/table_units.h"
#include "core/table/target_axis.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>

namespace axiscomp {

namespace {

using namespace report;

/// fit: of the table that was made of the measurement; null: none was.
std::vector<Text> correctionsOnRecord(const RecordedCorrections& corrections,
    const CorrectedMeasurement& made, const FitSettings* fit)
{
    std::vector<Text> list = correctionTexts(made.measurement.againstFile,
        {corrections.temperature, corrections.deadPath}, made.largestByTemperature,
        made.largestByDeadPath);
    if (fit && fit->slope != SlopeRemoval::Keep && made.measurement.hasTargets())
        list.emplace_back(
            AXISCOMP_TEXT("Report", "slope taken out for the table, not for figures"));
    if (corrections.drift)
        list.push_back(AXISCOMP_TEXT("Report", "drift taken out for the table, not for figures"));
    return list;
}

Result<ReportMeasurement> measured(const RecordedMeasurement& recorded, const FitSettings* fit)
{
    ReportMeasurement result;
    AXISCOMP_TRY(auto made, correctedMeasurement(recorded));
    result.corrections = correctionsOnRecord(recorded.corrections, made, fit);
    result.measurement = std::move(made.measurement);
    result.areCorrectionsKnown = true;
    result.datum = statedDatum(recorded.corrections.temperature);
    for (const RecordedFile& file : recorded.files)
        result.files.push_back(file.file);
    return result;
}

void addInputs(std::vector<ReportInput>& inputs, const RecordedMeasurement& recorded)
{
    for (const RecordedFile& file : recorded.files)
        inputs.push_back({file.file, file.format, file.sha256});
}

/// measurement: that the table was made of; null: not on record.
Text methodAlongAxis(const FitSettings& settings, const Measurement* measurement)
{
    if (measurement && isFittedOnGrid(*measurement, settings))
        return AXISCOMP_TEXT("Report", "smooth grid of scattered points");
    const std::string method(fitMethodName(settings.method));
    switch (measurement ? fittedDirection(*measurement, settings) : settings.direction) {
    case FitDirection::Positive:
        return AXISCOMP_TEXT("Report", "{method}, from the runs ↑").with("method", method);
    case FitDirection::Negative:
        return AXISCOMP_TEXT("Report", "{method}, from the runs ↓").with("method", method);
    case FitDirection::Mean:
    case FitDirection::Both: // is not on record
        break;
    }
    return AXISCOMP_TEXT("Report", "{method}, from the mean of both directions")
        .with("method", method);
}

Text methodText(const CalibrationRecord& record, const Measurement* measurement)
{
    if (!record.fit)
        return {};
    Text method = methodAlongAxis(record.fit->settings, measurement);
    if (!record.fit->settings.isByTemperature)
        return method;
    return AXISCOMP_TEXT("Report", "{method}, over position and temperature")
        .with("method", std::move(method));
}

Text proofText(const RecordedWrite& write)
{
    if (!write.proof)
        return {};
    const RecordedWrite::Proof& proof = *write.proof;
    const Text share = quantityText(percentText(proof.provedShare), "%");
    if (!proof.isProved)
        return AXISCOMP_TEXT("Report", "failed after {share} of the table").with("share", share);
    return AXISCOMP_TEXT("Report", "passed over {share} of the table").with("share", share);
}

/// At the largest value of a table of one dimension, whose values are in mm or deg.
/// measurement: that it was made of; null: not on record.
Text signText(const CompensationTable& table, const CalibrationRecord& record,
    const Measurement* measurement, const ReportContent& content)
{
    const bool isAngular = content.isAngular;
    if (table.values.empty() || table.grid.axes.size() != 1)
        return {};
    const auto largest =
        std::ranges::max_element(table.values, {}, [](float value) { return std::abs(value); });
    const auto index = static_cast<std::size_t>(largest - table.values.begin());
    const double position = table.grid.axes.front().position(index);
    const auto added = static_cast<double>(*largest);
    constexpr int placeDecimals = 4;
    const std::optional<double> shown[] = {added};
    const FineUnit unit = fineUnit(shown, isAngular);
    const Text amount = quantityText((added > 0.0 ? "+" : "") + unit.digits(added), unit.symbol);
    const auto place = [isAngular](double value) {
        return quantityText(fixedDigits(value, placeDecimals), positionSymbol(isAngular));
    };
    const bool isAtSet = record.fit && record.fit->settings.lookupAt == LookupAt::Set;
    if (!content.corrected.empty())
        return (isAtSet
                ? AXISCOMP_TEXT("Report",
                    "At the set position {position} of axis {axis} the drive adds {added} to what "
                    "the encoder of axis {target} reads.")
                : AXISCOMP_TEXT("Report",
                    "Where the encoder of axis {axis} reads {position}, the drive adds {added} to "
                    "axis {target}."))
            .with("position", place(position))
            .with("axis", Verbatim{measurement->header.axis})
            .with("added", amount)
            .with("target", Verbatim{content.corrected});
    if (isAtSet)
        return AXISCOMP_TEXT("Report",
            "At the set position {position} the drive adds {added} to what the encoder reads.")
            .with("position", place(position))
            .with("added", amount);
    if (!measurement || !isReferenceRead(record, *measurement, position))
        return AXISCOMP_TEXT("Report", "Where the encoder reads {reading}, the drive adds {added}.")
            .with("reading", place(position))
            .with("added", amount);
    return AXISCOMP_TEXT("Report",
        "Where the encoder reads {reading}, the reference said {reference}: the drive adds "
        "{added}.")
        .with("reading", place(position))
        .with("reference", place(position + added))
        .with("added", amount);
}

void addTable(ReportContent& content, const CalibrationRecord& record)
{
    ReportedTable& table = content.table;
    const Measurement* const measurement = content.before ? &content.before->measurement : nullptr;
    table.method = methodText(record, measurement);
    if (!record.tables.empty()) {
        const RecordedTable& first = record.tables.front();
        table.grid = first.table.grid;
        if (record.tables.size() == 1)
            table.crc = first.crc;
        else
            for (const RecordedTable& each : record.tables)
                table.columns.push_back({each.table.name, each.table.target, each.crc});
        if (measurement && correctsAnotherAxis(first.table.target, measurement->header.axis))
            content.corrected = first.table.target;
        if (first.table.unit == "mm" || first.table.unit == "deg")
            content.sign = signText(first.table, record, measurement, content);
    }
    if (record.write) {
        table.crc = record.write->crc; // of the values in the unit of the drive
        table.slot = record.write->slot;
        table.isPersistent = record.write->isPersistent;
        table.proof = proofText(*record.write);
    }
}

/// "M1 (a.csv), M2 (b.csv)" where joined files say different things.
std::string saidOfMachine(const ReportMeasurement& one, std::string MeasurementHeader::*text)
{
    const auto said = saidByFiles(one.measurement, text);
    if (!areDifferent(said))
        return one.measurement.header.*text;
    std::string all;
    for (const auto& each : said) {
        if (each.said.empty())
            continue;
        std::string names;
        for (const std::size_t file : each.files)
            names += (names.empty() ? "" : ", ") + one.files.at(file);
        all += (all.empty() ? "" : ", ") + each.said + " (" + names + ")";
    }
    return all;
}

/// What the first measurement does not state may be in the second one.
void takeMachine(ReportContent& content)
{
    const auto take = [](const std::string& stated, std::string& text) {
        if (!stated.empty())
            text = stated;
    };
    for (const auto* one : {&content.after, &content.before}) {
        if (!*one)
            continue;
        const Measurement& measurement = (*one)->measurement;
        content.isAngular = measurement.isAngular;
        take(saidOfMachine(**one, &MeasurementHeader::machine), content.machine);
        take(measurement.header.axis, content.axis);
        take(saidOfMachine(**one, &MeasurementHeader::serial), content.serial);
    }
}

void addTolerances(ReportContent& content, const CalibrationRecord& record)
{
    RecordedJudging judging = judgingOf(record);
    content.tolerances = std::move(judging.tolerances);
    content.uncertainty = judging.uncertainty;
}

/// Records of older programs have measurements that compareMeasurements refuses by now.
void warnOfOtherTargets(ReportContent& content, const Measurement& before, const Measurement& after)
{
    const auto lesser = lesserRange(before, after);
    if (lesser)
        content.warnings.push_back({"LesserRange", lesserRangeText(*lesser, content.isAngular)});
    if (auto wider = widerTargetsText(before, after))
        content.warnings.push_back({"WiderTargets", std::move(*wider)});
}

void warnOfOtherVerdict(ReportContent& content, const Measurement& last)
{
    const auto ofAllValues = figuresOfAllValues(content, last);
    if (!ofAllValues)
        return;
    const auto verdictsOf = [&content](const Iso230Figures& figures) {
        return verdicts(figures, content.tolerances, content.uncertainty);
    };
    std::ranges::move(otherVerdicts(verdictsOf(figuresBy(content, last)), verdictsOf(*ofAllValues),
                          content.isAngular, UnitLetters::Page),
        std::back_inserter(content.warnings));
}

void addWarnings(ReportContent& content)
{
    const auto measurementOf = [](const std::optional<ReportMeasurement>& one) {
        return one ? &one->measurement : nullptr;
    };
    content.warnings = machineWarnings(measurementOf(content.before), measurementOf(content.after));
    if (content.before && content.after)
        warnOfOtherTargets(content, content.before->measurement, content.after->measurement);
    const auto& last = content.after ? content.after : content.before;
    if (last && last->measurement.hasTargets())
        warnOfOtherVerdict(content, last->measurement);
}

} // namespace

Result<ReportContent> reportContent(
    const CalibrationRecord& record, const std::string& programVersion)
{
    ReportContent content;
    content.programVersion = programVersion;
    if (record.before) {
        AXISCOMP_TRY(
            content.before, measured(*record.before, record.fit ? &record.fit->settings : nullptr));
        addInputs(content.inputs, *record.before);
    }
    if (const RecordedAfter* after = lastAfter(record)) {
        AXISCOMP_TRY(content.after, measured(after->measurement, nullptr));
        content.after->statedTable = after->tableCrc;
        addInputs(content.inputs, after->measurement);
    }
    takeMachine(content);
    if (record.drive) {
        content.drive = record.drive->name;
        content.driveSerial = std::to_string(record.drive->serialNumber);
        content.firmwareProfile = record.drive->profile;
        if (content.axis.empty())
            content.axis = record.drive->axisName;
    }
    if (record.prediction) {
        content.prediction.emplace();
        content.prediction->figures = record.prediction->predicted.values;
        if (const auto& heldOut = record.prediction->heldOut) {
            content.prediction->heldOutRms = heldOut->rms;
            content.prediction->heldOutLargest = heldOut->largest;
            content.prediction->heldOutM = heldOut->range;
        }
    }
    content.isByTemperature = record.fit && record.fit->settings.isByTemperature;
    addTable(content, record);
    addTolerances(content, record);
    addWarnings(content);
    for (const std::string& note : record.notes)
        content.notes.push_back(statedText(note));
    return content;
}

std::optional<ReportFormat> reportFormatOf(const std::filesystem::path& file)
{
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(),
        [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
    if (extension == ".pdf")
        return ReportFormat::Pdf;
    if (extension == ".html" || extension == ".htm")
        return ReportFormat::Html;
    return std::nullopt;
}

} // namespace axiscomp
