// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/record/fit_json.h"

#include "core/base/bytes.h"
#include "core/metrology/record/record_fields.h"
#include "core/store/backup_json.h"

#include <bit>
#include <cmath>
#include <limits>

namespace axiscomp {

namespace {

using namespace record_json;

constexpr std::string_view directionNames[] = {"mean", "positive", "negative"};
constexpr std::string_view methodNames[] = {"linear", "cubic", "spline", "smooth", "harmonic"};
constexpr std::string_view slopeNames[] = {"keep", "lsq", "ends"};
constexpr std::string_view zeroNames[] = {"automatic", "home", "first", "mean", "position", "keep"};
constexpr std::string_view driftNames[] = {"offset", "trend"};
constexpr std::string_view lookupNames[] = {"encoder", "set"};
constexpr std::string_view removalNames[] = {"none", "rigid", "rigidAlong", "scale"};
constexpr std::string_view farNames[] = {"refuse", "smooth", "nearest"};
constexpr std::string_view outlierNames[] = {"none", "mad", "grubbs"};
constexpr std::string_view resultNames[] = {"passed", "failed", "undecided", "notDefined"};

OrderedJson toJson(const GridAxis& axis);
OrderedJson toJson(const CompensationTable& table);
OrderedJson toJson(const Verdict& verdict);

constexpr std::size_t mostPoints = std::numeric_limits<std::uint32_t>::max();

OrderedJson toJson(const Tolerance& tolerance)
{
    return {{"figure", figureName(tolerance.figure)}, {"value", tolerance.value}};
}

Iso230Figure figureFromJson(const JsonNode& node)
{
    const auto figure = figureNamed(node.textView());
    if (!figure || figureName(*figure) != node.textView())
        node.refuse(AXISCOMP_TEXT("Error", "this is no figure of ISO 230-2, such as A or EUp"));
    return figure.value_or(Iso230Figure::A);
}

Tolerance toleranceFromJson(const JsonNode& node)
{
    return {figureFromJson(node["figure"]), node["value"].number()};
}

OrderedJson toJson(const AxisRequest& request)
{
    OrderedJson object = OrderedJson::object();
    if (request.points > 0)
        object["points"] = request.points;
    if (request.distance != 0.0)
        object["distance"] = request.distance;
    putIfThere(object, "start", request.start);
    putIfThere(object, "end", request.end);
    return object;
}

AxisRequest axisRequestFromJson(const JsonNode& node)
{
    AxisRequest request;
    if (isThere(node, "points"))
        request.points = node["points"].integer<std::size_t>(0, mostPoints);
    request.distance = maybeNumber(node, "distance").value_or(0.0);
    request.start = maybeNumber(node, "start");
    request.end = maybeNumber(node, "end");
    return request;
}

template <typename Enum>
void putEnum(OrderedJson& object, const char* key, const std::optional<Enum>& value, Names names)
{
    if (value)
        object[key] = nameOf(*value, names);
}

template <typename Enum>
std::optional<Enum> maybeEnum(const JsonNode& object, std::string_view key, Names names)
{
    return isThere(object, key) ? std::optional(enumFromJson<Enum>(object[key], names))
                                : std::nullopt;
}

template <typename Items> OrderedJson listToJson(const Items& items)
{
    OrderedJson list = OrderedJson::array();
    for (const auto& item : items)
        list.push_back(toJson(item));
    return list;
}

template <typename Item>
std::vector<Item> listFromJson(const JsonNode& list, Item (*read)(const JsonNode&))
{
    std::vector<Item> items;
    for (const JsonNode& item : list.items())
        items.push_back(read(item));
    return items;
}

OrderedJson toJson(const FitSettings& settings)
{
    OrderedJson object{{"direction", nameOf(settings.direction, directionNames)},
        {"method", nameOf(settings.method, methodNames)}};
    putIfThere(object, "smoothness", settings.smoothness);
    object["periods"] = settings.periods.periods;
    object["harmonics"] = settings.periods.harmonics;
    putIfThere(object, "turn", settings.turn);
    object["slope"] = nameOf(settings.slope, slopeNames);
    object["zero"] = nameOf(settings.zero, zeroNames);
    object["zeroPosition"] = settings.zeroPosition;
    putIfThere(object, "home", settings.home);
    putEnum(object, "drift", settings.drift, driftNames);
    putEnum(object, "lookupAt", settings.lookupAt, lookupNames);
    object["gain"] = settings.gain;
    object["grid"] = listToJson(settings.grid);
    if (settings.isByTemperature)
        object["by"] = "temperature";
    putIfThere(object, "within", settings.within);
    object["hold"] = settings.holdsEnds;
    object["mostPoints"] = settings.mostPoints;
    object["remove"] = nameOf(settings.remove, removalNames);
    object["removeAlong"] = settings.removeAlong;
    object["fill"] = nameOf(settings.farPoints, farNames);
    object["robust"] = settings.isRobust;
    putIfThere(object, "speed", settings.speed);
    object["tolerances"] = listToJson(settings.tolerances);
    putIfThere(object, "uncertainty", settings.uncertainty);
    object["outliers"] = nameOf(settings.outlierRule, outlierNames);
    return object;
}

bool takesTemperature(const JsonNode& node)
{
    if (!isThere(node, "by"))
        return false;
    const JsonNode by = node["by"];
    if (by.textView() != "temperature")
        by.refuse(AXISCOMP_TEXT("Error", "\"{format}\" is expected")
                      .with("format", Verbatim{"temperature"}));
    return true;
}

FitSettings settingsFromJson(const JsonNode& node)
{
    FitSettings settings;
    settings.direction = enumFromJson<FitDirection>(node["direction"], directionNames);
    settings.method = enumFromJson<FitMethod>(node["method"], methodNames);
    settings.smoothness = maybeNumber(node, "smoothness");
    settings.periods.periods = node["periods"].numbers();
    settings.periods.harmonics = node["harmonics"].integer<int>(1, 1'000'000);
    settings.turn = maybeNumber(node, "turn");
    settings.slope = enumFromJson<SlopeRemoval>(node["slope"], slopeNames);
    settings.zero = enumFromJson<FitZero>(node["zero"], zeroNames);
    settings.zeroPosition = node["zeroPosition"].numbers();
    settings.home = maybeNumber(node, "home");
    settings.drift = maybeEnum<DriftRemoval>(node, "drift", driftNames);
    settings.lookupAt = maybeEnum<LookupAt>(node, "lookupAt", lookupNames);
    settings.gain = node["gain"].number();
    settings.grid = listFromJson(node["grid"], &axisRequestFromJson);
    settings.isByTemperature = takesTemperature(node);
    settings.within = maybeNumber(node, "within");
    settings.holdsEnds = node["hold"].boolean();
    settings.mostPoints = node["mostPoints"].integer<std::size_t>(0, mostPoints);
    settings.remove = enumFromJson<BodyRemoval>(node["remove"], removalNames);
    settings.removeAlong = node["removeAlong"].integer<std::size_t>(0, 2);
    settings.farPoints = enumFromJson<FarPoints>(node["fill"], farNames);
    settings.isRobust = node["robust"].boolean();
    settings.speed = maybeNumber(node, "speed");
    settings.tolerances = listFromJson(node["tolerances"], &toleranceFromJson);
    settings.uncertainty = maybeNumber(node, "uncertainty");
    settings.outlierRule = enumFromJson<OutlierRule>(node["outliers"], outlierNames);
    return settings;
}

OrderedJson toJson(const GridAxis& axis)
{
    return {{"name", axis.name}, {"unit", axis.unit}, {"start", axis.start},
        {"distance", axis.distance}, {"size", axis.size}};
}

GridAxis gridAxisFromJson(const JsonNode& node)
{
    GridAxis axis{node["name"].text(), node["unit"].text(), node["start"].number(),
        node["distance"].number(), node["size"].integer<std::uint32_t>(2)};
    if (!(axis.distance > 0.0))
        node["distance"].refuse(AXISCOMP_TEXT("Error", "a distance above 0 is expected"));
    return axis;
}

OrderedJson toJson(const CompensationTable& table)
{
    OrderedJson values = OrderedJson::array();
    for (const float value : table.values)
        values.push_back(shortDouble(value));
    OrderedJson object{{"name", table.name}, {"unit", table.unit}, {"target", table.target},
        {"axes", listToJson(table.grid.axes)}, {"values", std::move(values)}};
    if (!table.filled.empty())
        object["filled"] = table.filled;
    return object;
}

std::vector<float> tableValues(const JsonNode& node)
{
    std::vector<float> values;
    for (const double number : node.numbers()) {
        values.push_back(static_cast<float>(number));
        if (std::isinf(values.back()))
            node.refuse(AXISCOMP_TEXT("Error", "this is too large for a Single"));
    }
    return values;
}

std::vector<std::uint32_t> filledPoints(const JsonNode& node, std::size_t points)
{
    std::vector<std::uint32_t> filled;
    for (const JsonNode& item : node.items()) {
        filled.push_back(item.integer<std::uint32_t>());
        if (filled.back() >= points || (filled.size() > 1 && filled.back() <= *(filled.end() - 2)))
            item.refuse(AXISCOMP_TEXT(
                "Error", "numbers of the table's points are expected, ascending from 0"));
    }
    return filled;
}

CompensationTable tableFromJson(const JsonNode& node)
{
    CompensationTable table;
    table.name = node["name"].text();
    table.unit = node["unit"].text();
    table.target = node["target"].text();
    table.grid.axes = listFromJson(node["axes"], &gridAxisFromJson);
    table.values = tableValues(node["values"]);
    const std::size_t dimensions = table.grid.axes.size();
    if (dimensions < 1 || dimensions > 3)
        node["axes"].refuse(AXISCOMP_TEXT("Error", "a table has 1 to 3 axes"));
    else if (table.grid.pointCount() != table.values.size())
        node["values"].refuse(
            AXISCOMP_TEXT("Error", "{count} values are here, and the grid has {expected} points")
                .with("count", table.values.size())
                .with("expected", table.grid.pointCount()));
    if (isThere(node, "filled"))
        table.filled = filledPoints(node["filled"], table.values.size());
    return table;
}

OrderedJson toJson(const HeldOut& heldOut)
{
    OrderedJson targets = OrderedJson::array();
    OrderedJson residuals = OrderedJson::array();
    for (const HeldOut::Residual& residual : heldOut.residuals) {
        targets.push_back(residual.target);
        residuals.push_back(residual.value);
    }
    return {{"rms", heldOut.rms}, {"largest", heldOut.largest}, {"M", heldOut.range},
        {"targets", std::move(targets)}, {"residuals", std::move(residuals)}};
}

HeldOut heldOutFromJson(const JsonNode& node)
{
    HeldOut heldOut;
    heldOut.rms = node["rms"].number();
    heldOut.largest = node["largest"].number();
    heldOut.range = node["M"].number();
    const auto targets = node["targets"].numbers();
    const auto residuals = node["residuals"].numbers();
    if (targets.size() != residuals.size())
        node["residuals"].refuse(
            AXISCOMP_TEXT("Error", "this list has {count} elements, and the others have {expected}")
                .with("count", residuals.size())
                .with("expected", targets.size()));
    for (std::size_t i = 0; i < std::min(targets.size(), residuals.size()); ++i)
        heldOut.residuals.push_back({targets[i], residuals[i]});
    return heldOut;
}

OrderedJson toJson(const Verdict& verdict)
{
    OrderedJson object = toJson(verdict.tolerance);
    object = {{"figure", object["figure"]}, {"tolerance", object["value"]}};
    object["value"] = verdict.value ? OrderedJson(*verdict.value) : OrderedJson(nullptr);
    object["U"] = verdict.uncertainty ? OrderedJson(*verdict.uncertainty) : OrderedJson(nullptr);
    object["result"] = nameOf(verdict.result, resultNames);
    return object;
}

Verdict oneVerdictFromJson(const JsonNode& node)
{
    return {{figureFromJson(node["figure"]), node["tolerance"].number()},
        maybeNumber(node, "value"), maybeNumber(node, "U"),
        enumFromJson<VerdictResult>(node["result"], resultNames)};
}

template <typename Value> OrderedJson withOthers(OrderedJson object, const Value& value)
{
    putBack(object, value.others);
    return object;
}

} // namespace

std::uint32_t tableCrc(const CompensationTable& table)
{
    static_assert(std::endian::native == std::endian::little);
    return crc32(std::as_bytes(std::span(table.values)));
}

OrderedJson toJson(const RecordedFit& fit)
{
    OrderedJson object{{"settings", toJson(fit.settings)}};
    if (!fit.active.empty())
        object["active"] = listToJson(fit.active);
    return withOthers(std::move(object), fit);
}

RecordedFit recordedFitFromJson(const JsonNode& node)
{
    RecordedFit fit{settingsFromJson(node["settings"])};
    if (isThere(node, "active"))
        fit.active = listFromJson(node["active"], &tableFromJson);
    fit.others = otherMembers(node, toJson(fit));
    return fit;
}

OrderedJson toJson(const RecordedTable& table)
{
    OrderedJson object = toJson(table.table);
    object["crc32"] = crcText(table.crc);
    return withOthers(std::move(object), table);
}

RecordedTable recordedTableFromJson(const JsonNode& node)
{
    RecordedTable table{tableFromJson(node), crcFromJson(node["crc32"])};
    if (tableCrc(table.table) != table.crc)
        node["crc32"].refuse(AXISCOMP_TEXT("Error",
            "the values have the CRC-32 {found}: they were changed, or the file is damaged")
                                 .with("found", crcText(tableCrc(table.table))));
    table.others = otherMembers(node, toJson(table));
    return table;
}

OrderedJson toJson(const FigureValues& figures)
{
    OrderedJson object = OrderedJson::object();
    for (const Iso230Figure figure : allIso230Figures())
        object[std::string(figureName(figure))] =
            figures[figure] ? OrderedJson(*figures[figure]) : OrderedJson(nullptr);
    return object;
}

FigureValues figureValuesFromJson(const JsonNode& node)
{
    FigureValues figures;
    for (const Iso230Figure figure : allIso230Figures())
        figures.values[static_cast<std::size_t>(figure)] = maybeNumber(node, figureName(figure));
    if (node.value() != nullptr && !node.value()->is_object())
        static_cast<void>(node["A"]);
    return figures;
}

OrderedJson toJson(const RecordedPrediction& prediction)
{
    OrderedJson object{
        {"before", toJson(prediction.before)}, {"predicted", toJson(prediction.predicted)}};
    if (prediction.heldOut)
        object["heldOut"] = toJson(*prediction.heldOut);
    return withOthers(std::move(object), prediction);
}

RecordedPrediction predictionFromJson(const JsonNode& node)
{
    RecordedPrediction prediction;
    prediction.before = figureValuesFromJson(node["before"]);
    prediction.predicted = figureValuesFromJson(node["predicted"]);
    if (isThere(node, "heldOut"))
        prediction.heldOut = heldOutFromJson(node["heldOut"]);
    prediction.others = otherMembers(node, toJson(prediction));
    return prediction;
}

OrderedJson toJson(const RecordedVerdict& verdict)
{
    return withOthers({{"figures", listToJson(verdict.figures)}}, verdict);
}

RecordedVerdict verdictFromJson(const JsonNode& node)
{
    RecordedVerdict verdict{listFromJson(node["figures"], &oneVerdictFromJson)};
    verdict.others = otherMembers(node, toJson(verdict));
    return verdict;
}

OrderedJson toJson(const RecordedJudging& judging)
{
    OrderedJson object{{"tolerances", listToJson(judging.tolerances)}};
    putIfThere(object, "uncertainty", judging.uncertainty);
    object["outliers"] = nameOf(judging.outlierRule, outlierNames);
    return withOthers(std::move(object), judging);
}

RecordedJudging judgingFromJson(const JsonNode& node)
{
    RecordedJudging judging;
    judging.tolerances = listFromJson(node["tolerances"], &toleranceFromJson);
    judging.uncertainty = maybeNumber(node, "uncertainty");
    judging.outlierRule = enumFromJson<OutlierRule>(node["outliers"], outlierNames);
    judging.others = otherMembers(node, toJson(judging));
    return judging;
}

} // namespace axiscomp
