// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/joined_files.h"

#include "core/text/text_file.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <span>

namespace axiscomp {

namespace {

bool isSameStatement(const std::string& one, const std::string& other)
{
    return sameLetters(trimmed(one), trimmed(other));
}

bool isSameStatement(const std::optional<double>& one, const std::optional<double>& other)
{
    return one == other;
}

template <typename Statement>
std::vector<SaidByFiles<Statement>> groupedByFiles(
    const Measurement& measurement, Statement MeasurementHeader::*member)
{
    const std::span<const MeasurementHeader> headers = measurement.joined.empty()
        ? std::span(&measurement.header, 1)
        : std::span(measurement.joined);
    std::vector<SaidByFiles<Statement>> groups;
    for (std::size_t file = 0; file < headers.size(); ++file) {
        const Statement& said = headers[file].*member;
        auto group = std::ranges::find_if(
            groups, [&](const auto& other) { return isSameStatement(other.said, said); });
        if (group == groups.end())
            group = groups.insert(group, {said, {}});
        group->files.push_back(file);
    }
    return groups;
}

} // namespace

TextsOfFiles saidByFiles(const Measurement& measurement, std::string MeasurementHeader::*text)
{
    return groupedByFiles(measurement, text);
}

NumbersOfFiles saidByFiles(
    const Measurement& measurement, std::optional<double> MeasurementHeader::*number)
{
    return groupedByFiles(measurement, number);
}

bool areDifferent(const TextsOfFiles& said)
{
    return std::ranges::count_if(said, [](const auto& group) {
        return !trimmed(group.said).empty();
    }) > 1;
}

bool areDifferent(const NumbersOfFiles& said)
{
    return said.size() > 1;
}

bool areAllDifferent(const TextsOfFiles& one, const TextsOfFiles& other)
{
    bool isSaidOfBoth = false;
    for (const auto& first : one)
        for (const auto& second : other) {
            if (trimmed(first.said).empty() || trimmed(second.said).empty())
                continue;
            if (isSameStatement(first.said, second.said))
                return false;
            isSaidOfBoth = true;
        }
    return isSaidOfBoth;
}

} // namespace axiscomp
