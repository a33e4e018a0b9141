// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output/json_output.h"

#include "app/common/console.h"

namespace axiscomp::app {

std::vector<std::string> englishOf(const std::vector<Text>& texts)
{
    std::vector<std::string> english;
    for (const Text& text : texts)
        english.push_back(text.english());
    return english;
}

Json textOrNull(const std::string& text)
{
    return text.empty() ? Json(nullptr) : Json(text);
}

std::string dump(const Json& json)
{
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json toJson(const Diagnostic& diagnostic)
{
    return {{"code", diagnosticName(diagnostic.code)}, {"line", diagnostic.line},
        {"column", diagnostic.column}, {"message", message(diagnostic)}};
}

Json toJson(const Grid& grid)
{
    Json list = Json::array();
    for (const GridAxis& axis : grid.axes)
        list.push_back({{"name", axis.name}, {"unit", axis.unit}, {"start", axis.start},
            {"distance", axis.distance}, {"size", axis.size}});
    return list;
}

Json filledJson(const std::vector<std::uint32_t>& filled, const std::vector<std::size_t>& sizes)
{
    Json list = Json::array();
    for (std::size_t point : filled) {
        Json index = Json::array();
        for (const std::size_t size : sizes) {
            index.push_back(point % size);
            point /= size;
        }
        list.push_back(std::move(index));
    }
    return list;
}

Json toJson(const CompensationTable& table)
{
    const TableStatistics figures = statistics(table);
    std::vector<std::size_t> sizes;
    for (const GridAxis& axis : table.grid.axes)
        sizes.push_back(axis.size);
    return {{"name", table.name},
        {"target", table.target.empty() ? Json(nullptr) : Json(table.target)}, {"unit", table.unit},
        {"min", figures.minimum}, {"max", figures.maximum}, {"rms", figures.rms},
        {"filled", filledJson(table.filled, sizes)}};
}

Json toJson(const Error& error, const Json& diagnostics)
{
    Json json = {{"code", errorName(error.code)},
        {"message", withoutPasswords(singleLine(sentence(error)))}, {"context", Json::object()}};
    for (const auto& [key, value] : error.context.all())
        json["context"][key] = withoutPasswords(value.english());
    json["diagnostics"] = diagnostics;
    return json;
}

} // namespace axiscomp::app
