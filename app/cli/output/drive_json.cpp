// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output/drive_json.h"

#include "app/cli/output/status_text.h"
#include "app/common/number_text.h"
#include "core/table/position_unit.h"

#include <algorithm>
#include <limits>

namespace axiscomp::app {

namespace {

/// The first `count` numbers; NaN becomes null.
Json numbers(const std::array<double, 3>& values, int count)
{
    Json list = Json::array();
    for (std::size_t n = 0;
         n < std::min<std::size_t>(values.size(), static_cast<std::size_t>(count)); ++n)
        list.push_back(values[n]);
    return list;
}

Json setupJson(const std::string& drive, const CompensationSetup& setup)
{
    return {{"dimensions", setup.dimensionality}, {"sources", sourceTexts(drive, setup)},
        {"slot", textOrNull(setup.slot)}, {"crc", setup.tableCrc},
        {"persistent", setup.persistency == Persistency::Persistent}};
}

} // namespace

Json toJson(const AxisInfo& axis)
{
    return {{"index", axis.index}, {"name", axis.name}, {"unit", axis.unit},
        {"travel", axis.travel ? Json{axis.travel->low, axis.travel->high} : Json(nullptr)},
        {"homing", axis.homingWord}, {"state", textOrNull(axis.stateWord)}};
}

Json toJson(const AxisStatus& status)
{
    const int dimensions =
        status.table ? status.table->grid.dimensions() : status.setup.dimensionality;
    Json table = nullptr;
    if (status.table)
        table = {{"axes", toJson(status.table->grid)}, {"elements", status.table->elements},
            {"crc", status.table->crc}};
    return {{"drive", status.drive.name}, {"axis", status.axis.index},
        {"slot", textOrNull(status.setup.slot)},
        {"persistent", status.table && status.table->persistent}, {"dimensions", dimensions},
        {"table", std::move(table)}, {"sources", sourceTexts(status.drive.name, status.setup)},
        {"activation", status.activation}, {"state", status.axis.stateWord},
        {"error", status.error}, {"output", status.output},
        {"indices", numbers(status.indices, dimensions)}, {"homing", status.axis.homingWord}};
}

Json toJson(const FlashUse& use)
{
    const bool isCounted = !use.mostUsedSlot.empty();
    const bool isLimited = use.budget.left != std::numeric_limits<int>::max();
    return {{"operationsLeft", isLimited ? Json(use.budget.left) : Json(nullptr)},
        {"waitSeconds", use.budget.wait.count()}, {"byThisComputer", use.operationsRecorded},
        {"mostUsedSlot", textOrNull(use.mostUsedSlot)},
        {"cycles", isCounted ? Json(use.mostCycles) : Json(nullptr)},
        {"allCycles", isCounted ? Json(use.allCycles) : Json(nullptr)},
        {"ratedCycles", use.ratedCycles > 0 ? Json(use.ratedCycles) : Json(nullptr)},
        {"damagedRecord", use.damagedRecord ? Json(use.damagedRecord->string()) : Json(nullptr)}};
}

Json toJson(const MeasuredFigures& measured)
{
    const auto known = [](const std::optional<double>& value) {
        return value ? Json(*value) : Json(nullptr);
    };
    Json figures = Json::array();
    for (const MeasuredFigures::Figure& figure : measured.figures)
        figures.push_back({{"figure", figure.name}, {"before", known(figure.before)},
            {"predicted", known(figure.predicted)}, {"after", known(figure.after)},
            {"tolerance", known(figure.tolerance)}, {"verdict", textOrNull(figure.result)}});
    Json ranges = nullptr;
    if (const auto& lesser = measured.lesserRange)
        ranges = {{"before", {lesser->before.first, lesser->before.last}},
            {"after", {lesser->after.first, lesser->after.last}}};
    return {{"crc", measured.crc}, {"noted", utcText(measured.time)},
        {"date", textOrNull(measured.date)}, {"unit", measured.isAngular ? "deg" : "mm"},
        {"axisUnit", textOrNull(measured.units ? symbolOrWord(measured.units->values) : "")},
        {"figures", std::move(figures)}, {"excluded", measured.excluded},
        {"lesserRange", std::move(ranges)}};
}

Json unfinishedToJson(const JournalEntry& entry, AxisCompensator::UnfinishedOutcome outcome)
{
    return {{"began", utcText(entry.time)}, {"step", entry.step},
        {"driveHolds", outcomeName(outcome)}, {"backup", entry.backup.string()}};
}

Json toJson(const DimensionCoverage& coverage)
{
    return {{"dimension", coverage.dimension + 1}, {"axis", coverage.axis},
        {"travel", {coverage.travel.low, coverage.travel.high}},
        {"table", {coverage.table.low, coverage.table.high}}, {"share", coverage.share}};
}

Json toJson(const WritePlan& plan)
{
    Json coverage = Json::array();
    for (const DimensionCoverage& dimension : plan.coverage)
        coverage.push_back(toJson(dimension));
    Json changes = Json::array();
    for (const PlannedChange& change : plan.changes)
        changes.push_back(
            {{"field", change.field}, {"before", change.before}, {"after", change.after}});
    return {{"drive", plan.drive.name}, {"serialNumber", plan.drive.serialNumber},
        {"axis", plan.axis}, {"before", setupJson(plan.drive.name, plan.before)},
        {"after", setupJson(plan.drive.name, plan.after)},
        {"slotReason", slotReasonName(plan.slotReason)}, {"tableBytes", plan.tableBytes},
        {"deletedSlot", plan.deletedSlot.empty() ? Json(nullptr) : Json(plan.deletedSlot)},
        {"changes", std::move(changes)}, {"flashOperations", plan.flashOperations},
        {"flashOperationsLeft", plan.flashBudget.left},
        {"flashWaitSeconds", plan.flashBudget.wait.count()}, {"coverage", std::move(coverage)},
        {"largeCorrections", englishOf(plan.largeCorrections)},
        {"units", englishOf(plan.unitRemarks)}, {"warnings", englishOf(plan.warnings)}};
}

Json toJson(const SlotDeletion& plan)
{
    return {{"drive", plan.drive.name}, {"serialNumber", plan.drive.serialNumber},
        {"deletedSlot", plan.slot}, {"file", plan.file}, {"tableBytes", plan.bytes},
        {"persistent", plan.persistent}, {"flashOperations", plan.flashOperations},
        {"flashOperationsLeft", plan.flashBudget.left},
        {"flashWaitSeconds", plan.flashBudget.wait.count()}};
}

Json toJson(const WriteReport& report)
{
    return {{"status", toJson(report.now)}, {"backup", report.backup.string()}};
}

Json toJson(const Proof& proof, int dimensions)
{
    Json samples = Json::array();
    for (const Proof::Sample& sample : proof.samples)
        samples.push_back(
            {{"sources", numbers(sample.sources, dimensions)}, {"output", sample.output},
                {"expected", sample.expected}, {"indices", numbers(sample.indices, dimensions)},
                {"expectedIndices", numbers(sample.expectedIndices, dimensions)}});
    return {{"samples", std::move(samples)}, {"largestDifference", proof.largestDifference},
        {"tolerance", proof.tolerance}, {"provedShare", proof.provedShare},
        {"proved", proof.extent == Proof::Extent::Proved}};
}

Json toJson(const DriveFile& file)
{
    return {{"path", file.path}, {"size", file.size}, {"maximumSize", file.maximumSize}};
}

std::vector<std::string> sourceTexts(const std::string& drive, const CompensationSetup& setup)
{
    std::vector<std::string> texts;
    for (const DimSource& source : setup.sources) {
        if (source.isSet())
            texts.push_back(source.path.empty() ? "0x" + hexText(source.address)
                                                : sourceUri(drive, source.path));
    }
    return texts;
}

std::string_view slotReasonName(SlotReason reason)
{
    switch (reason) {
    case SlotReason::Named:
        return "Named";
    case SlotReason::Empty:
        return "Empty";
    case SlotReason::OwnPrevious:
        return "OwnPrevious";
    case SlotReason::KeepTable:
        return "KeepTable";
    case SlotReason::OverwriteOwn:
        return "OverwriteOwn";
    }
    return "";
}

} // namespace axiscomp::app
