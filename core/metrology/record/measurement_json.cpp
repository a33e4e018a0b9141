// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/record/measurement_json.h"

#include "core/metrology/header_texts.h"
#include "core/metrology/record/record_fields.h"
#include "core/store/backup_json.h"
#include "core/text/number_text.h"

#include <cmath>
#include <functional>
#include <limits>

namespace axiscomp {

namespace {

using namespace record_json;

constexpr std::string_view kindNames[] = {"runs", "averages", "track", "points"};
constexpr std::string_view approachNames[] = {"up", "down"};
constexpr std::string_view stateNames[] = {"notSaid", "off", "on"};
constexpr std::string_view correctedNames[] = {"notSaid", "none", "20C"};

/// One list with a member of every item.
template <typename Item, typename Member>
void putColumn(OrderedJson& columns, const char* key, const std::vector<Item>& items, Member member)
{
    OrderedJson list = OrderedJson::array();
    for (const Item& item : items)
        list.push_back(std::invoke(member, item));
    columns[key] = std::move(list);
}

/// The same of a member that not every item has: null where it is missing, no list when none has.
template <typename Item>
void putSparseColumn(OrderedJson& columns, const char* key, const std::vector<Item>& items,
    std::optional<double> Item::*member)
{
    const auto has = [&](const Item& item) { return (item.*member).has_value(); };
    if (std::ranges::any_of(items, has))
        putColumn(columns, key, items, [&](const Item& item) {
            return item.*member ? OrderedJson(*(item.*member)) : OrderedJson(nullptr);
        });
}

/// The lists of an object, which all have as many elements as the first one that is read.
class Columns {
public:
    explicit Columns(const JsonNode& object) : m_object(object) { }

    [[nodiscard]] std::vector<double> numbers(std::string_view key)
    {
        return sized(key, m_object[key].numbers());
    }
    [[nodiscard]] std::vector<std::optional<double>> sparse(std::string_view key)
    {
        if (!isThere(m_object, key))
            return std::vector<std::optional<double>>(m_size.value_or(0));
        return sized(key, m_object[key].numbersOrNull());
    }
    [[nodiscard]] std::vector<std::string> texts(std::string_view key)
    {
        return sized(key, textsFromJson(m_object[key]));
    }
    /// Whole numbers within these limits.
    [[nodiscard]] std::vector<std::size_t> counts(
        std::string_view key, std::size_t least, std::size_t most)
    {
        std::vector<std::size_t> result;
        for (const double number : numbers(key)) {
            if (!(number >= static_cast<double>(least) && number <= static_cast<double>(most))
                || number != std::floor(number)) {
                m_object[key].refuse(AXISCOMP_TEXT(
                    "Error", "whole numbers from {least} to {most} are expected, not {found}")
                                         .with("least", least)
                                         .with("most", most)
                                         .with("found", toText(number)));
                return std::vector<std::size_t>(m_size.value_or(0), least);
            }
            result.push_back(static_cast<std::size_t>(number));
        }
        return result;
    }
    [[nodiscard]] std::vector<Approach> approaches(std::string_view key)
    {
        std::vector<Approach> result;
        for (const std::string& text : texts(key)) {
            const bool isUp = text == approachNames[0];
            if (!isUp && text != approachNames[1])
                m_object[key].refuse(AXISCOMP_TEXT("Error", "\"{found}\" is neither up nor down")
                                         .with("found", text));
            result.push_back(isUp ? Approach::Up : Approach::Down);
        }
        return result;
    }
    [[nodiscard]] std::size_t size() const { return m_size.value_or(0); }

private:
    template <typename Value>
    std::vector<Value> sized(std::string_view key, std::vector<Value> list)
    {
        if (!m_size)
            m_size = list.size();
        if (list.size() != *m_size) {
            m_object[key].refuse(AXISCOMP_TEXT(
                "Error", "this list has {count} elements, and the others have {expected}")
                                     .with("count", list.size())
                                     .with("expected", *m_size));
            list.resize(*m_size);
        }
        return list;
    }

    const JsonNode& m_object;
    std::optional<std::size_t> m_size;
};

OrderedJson toJson(const MeasurementHeader& header)
{
    OrderedJson object = OrderedJson::object();
    for (const HeaderText& text : headerTexts)
        putIfThere(object, text.key, header.*text.member);
    object["compensation"] = axiscomp::toJson(header.compensation);
    putIfThere(object, "airTemperature", header.airTemperature);
    putIfThere(object, "materialTemperature", header.materialTemperature);
    putIfThere(object, "expansion", header.expansion);
    object["corrected"] = nameOf(header.corrected, correctedNames);
    return object;
}

MeasurementHeader headerFromJson(const JsonNode& node)
{
    MeasurementHeader header;
    for (const HeaderText& text : headerTexts)
        header.*text.member = maybeText(node, text.key);
    header.compensation = measuredStateFromJson(node["compensation"]);
    header.airTemperature = maybeNumber(node, "airTemperature");
    header.materialTemperature = maybeNumber(node, "materialTemperature");
    header.expansion = maybeNumber(node, "expansion");
    header.corrected =
        enumFromJson<MeasurementHeader::Corrected>(node["corrected"], correctedNames);
    return header;
}

OrderedJson valuesToJson(const std::vector<RunValue>& values)
{
    OrderedJson columns = OrderedJson::object();
    putColumn(columns, "target", values, &RunValue::target);
    putColumn(columns, "direction", values,
        [](const RunValue& value) { return nameOf(value.direction, approachNames); });
    putColumn(columns, "run", values, &RunValue::run);
    putColumn(columns, "deviation", values, &RunValue::deviation);
    putSparseColumn(columns, "encoder", values, &RunValue::encoder);
    putSparseColumn(columns, "output", values, &RunValue::output);
    putSparseColumn(columns, "time", values, &RunValue::time);
    putSparseColumn(columns, "temperature", values, &RunValue::temperature);
    if (!std::ranges::all_of(values, &RunValue::isUsed))
        putColumn(
            columns, "use", values, [](const RunValue& value) { return value.isUsed ? 1 : 0; });
    putColumn(columns, "line", values, &RunValue::line);
    return columns;
}

std::vector<RunValue> valuesFromJson(const JsonNode& node, std::size_t targets)
{
    constexpr std::size_t mostRuns = 1'000'000;
    Columns columns(node);
    const auto deviations = columns.numbers("deviation");
    const auto target = columns.counts("target", 0, targets == 0 ? 0 : targets - 1);
    const auto direction = columns.approaches("direction");
    const auto run = columns.counts("run", 1, mostRuns);
    const auto encoder = columns.sparse("encoder");
    const auto output = columns.sparse("output");
    const auto time = columns.sparse("time");
    const auto temperature = columns.sparse("temperature");
    const auto use = isThere(node, "use") ? columns.counts("use", 0, 1)
                                          : std::vector<std::size_t>(columns.size(), 1);
    const auto line = columns.counts("line", 0, std::numeric_limits<std::uint32_t>::max());
    if (targets == 0 && columns.size() > 0)
        node.refuse(AXISCOMP_TEXT("Error", "there are values without targets"));
    std::vector<RunValue> values;
    for (std::size_t i = 0; i < columns.size(); ++i)
        values.push_back({target[i], direction[i], static_cast<int>(run[i]), deviations[i],
            encoder[i], output[i], time[i], temperature[i], use[i] == 1, line[i]});
    sortValues(values);
    return values;
}

OrderedJson trackToJson(const std::vector<TrackSample>& track)
{
    OrderedJson columns = OrderedJson::object();
    putColumn(columns, "encoder", track, &TrackSample::encoder);
    putColumn(columns, "reference", track, &TrackSample::reference);
    putColumn(columns, "direction", track,
        [](const TrackSample& sample) { return nameOf(sample.direction, approachNames); });
    putSparseColumn(columns, "time", track, &TrackSample::time);
    return columns;
}

std::vector<TrackSample> trackFromJson(const JsonNode& node)
{
    Columns columns(node);
    const auto encoder = columns.numbers("encoder");
    const auto reference = columns.numbers("reference");
    const auto direction = columns.approaches("direction");
    const auto time = columns.sparse("time");
    std::vector<TrackSample> track;
    for (std::size_t i = 0; i < columns.size(); ++i)
        track.push_back({encoder[i], reference[i], direction[i], time[i]});
    return track;
}

OrderedJson toJson(const MeasuredPoints& points)
{
    return {{"axes", points.axes}, {"positions", points.positions}, {"columns", points.columns},
        {"values", points.values}};
}

/// One list of numbers for each name, all of the same length.
std::vector<std::vector<double>> listsFromJson(
    const JsonNode& node, std::size_t count, std::optional<std::size_t>& length)
{
    std::vector<std::vector<double>> lists;
    for (const JsonNode& item : node.items()) {
        lists.push_back(item.numbers());
        if (!length)
            length = lists.back().size();
        if (lists.back().size() != *length)
            item.refuse(AXISCOMP_TEXT(
                "Error", "this list has {count} elements, and the others have {expected}")
                            .with("count", lists.back().size())
                            .with("expected", *length));
    }
    if (lists.size() != count)
        node.refuse(AXISCOMP_TEXT("Error", "{count} lists are here, and there are {expected} names")
                        .with("count", lists.size())
                        .with("expected", count));
    return lists;
}

MeasuredPoints pointsFromJson(const JsonNode& node)
{
    MeasuredPoints points;
    points.axes = textsFromJson(node["axes"]);
    if (points.axes.size() < 2 || points.axes.size() > 3)
        node["axes"].refuse(AXISCOMP_TEXT("Error", "points have 2 or 3 axes"));
    points.columns = textsFromJson(node["columns"]);
    std::optional<std::size_t> length;
    points.positions = listsFromJson(node["positions"], points.axes.size(), length);
    points.values = listsFromJson(node["values"], points.columns.size(), length);
    return points;
}

OrderedJson publishedToJson(const std::vector<PublishedFigure>& published)
{
    OrderedJson columns = OrderedJson::object();
    putColumn(columns, "figure", published, &PublishedFigure::name);
    putColumn(columns, "value", published, &PublishedFigure::value);
    putColumn(columns, "halfUnit", published, &PublishedFigure::halfUnit);
    putColumn(columns, "line", published, &PublishedFigure::line);
    return columns;
}

std::vector<PublishedFigure> publishedFromJson(const JsonNode& node)
{
    Columns columns(node);
    const auto values = columns.numbers("value");
    const auto names = columns.texts("figure");
    const auto halfUnits = columns.numbers("halfUnit");
    const auto lines = columns.counts("line", 0, std::numeric_limits<std::uint32_t>::max());
    std::vector<PublishedFigure> published;
    for (std::size_t i = 0; i < columns.size(); ++i)
        published.push_back({names[i], values[i], halfUnits[i], lines[i]});
    return published;
}

/// As one file was read: directions are exchanged in all of them together, which stands elsewhere.
OrderedJson toJson(const AgainstFile& asked)
{
    OrderedJson object = OrderedJson::object();
    if (asked.invertsReference)
        object["invertReference"] = true;
    if (asked.takesAsReference)
        object["asReference"] = true;
    if (asked.takesAsDeviations)
        object["asDeviations"] = true;
    for (const StatedUnit& unit : asked.units)
        object["units"].push_back(
            {{"what", unit.what}, {"stated", unit.stated}, {"file", unit.ofFile}});
    return object;
}

AgainstFile againstFileFromJson(const JsonNode& node)
{
    AgainstFile asked;
    asked.invertsReference = maybeTrue(node, "invertReference");
    asked.takesAsReference = maybeTrue(node, "asReference");
    asked.takesAsDeviations = maybeTrue(node, "asDeviations");
    if (isThere(node, "units"))
        for (const JsonNode& item : node["units"].items())
            asked.units.push_back(
                {item["what"].text(), item["stated"].text(), item["file"].text()});
    return asked;
}

std::vector<double> targetsFromJson(const JsonNode& node)
{
    std::vector<double> targets = node.numbers();
    if (std::ranges::adjacent_find(targets, std::greater_equal()) != targets.end())
        node.refuse(AXISCOMP_TEXT("Error", "targets are expected to ascend"));
    return targets;
}

} // namespace

OrderedJson toJson(const MeasuredState& state)
{
    OrderedJson object{{"state", nameOf(state.kind, stateNames)}};
    if (state.tableCrc)
        object["crc32"] = crcText(*state.tableCrc);
    return object;
}

MeasuredState measuredStateFromJson(const JsonNode& node)
{
    MeasuredState state;
    state.kind = enumFromJson<MeasuredState::Kind>(node["state"], stateNames);
    if (isThere(node, "crc32"))
        state.tableCrc = crcFromJson(node["crc32"]);
    return state;
}

OrderedJson toJson(const Measurement& measurement)
{
    OrderedJson object{{"kind", nameOf(measurement.kind, kindNames)},
        {"angular", measurement.isAngular}, {"header", toJson(measurement.header)}};
    putIfThere(object, "notes", measurement.notes);
    if (measurement.hasTargets()) {
        object["targets"] = measurement.targets;
        object["values"] = valuesToJson(measurement.values);
    }
    if (measurement.kind == MeasurementKind::Track)
        object["track"] = trackToJson(measurement.track);
    if (measurement.kind == MeasurementKind::Points)
        object["points"] = toJson(measurement.points);
    if (!measurement.published.empty())
        object["published"] = publishedToJson(measurement.published);
    object["halfPrintedUnit"] = measurement.halfPrintedUnit;
    if (auto asked = toJson(measurement.againstFile); !asked.empty())
        object["againstFile"] = std::move(asked);
    return object;
}

Measurement measurementFromJson(const JsonNode& node)
{
    Measurement measurement;
    measurement.kind = enumFromJson<MeasurementKind>(node["kind"], kindNames);
    measurement.isAngular = node["angular"].boolean();
    measurement.header = headerFromJson(node["header"]);
    measurement.notes = maybeTexts(node, "notes");
    if (measurement.hasTargets()) {
        measurement.targets = targetsFromJson(node["targets"]);
        measurement.values = valuesFromJson(node["values"], measurement.targets.size());
    }
    if (measurement.kind == MeasurementKind::Track)
        measurement.track = trackFromJson(node["track"]);
    if (measurement.kind == MeasurementKind::Points)
        measurement.points = pointsFromJson(node["points"]);
    if (isThere(node, "published"))
        measurement.published = publishedFromJson(node["published"]);
    measurement.halfPrintedUnit = node["halfPrintedUnit"].number();
    if (isThere(node, "againstFile"))
        measurement.againstFile = againstFileFromJson(node["againstFile"]);
    return measurement;
}

} // namespace axiscomp
