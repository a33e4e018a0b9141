// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reliability/soak/soak_counts.h"

#include <algorithm>
#include <vector>

namespace axiscomp::test {

namespace {

int sumOf(const std::map<std::string, int>& counts)
{
    int sum = 0;
    for (const auto& [name, count] : counts)
        sum += count;
    return sum;
}

/// "VerifyMismatch 12, Timeout 3": the most frequent first.
std::string listed(const std::map<std::string, int>& counts)
{
    std::vector<std::pair<std::string, int>> rows(counts.begin(), counts.end());
    std::ranges::stable_sort(rows, std::ranges::greater{}, &std::pair<std::string, int>::second);
    std::string text;
    for (const auto& [name, count] : rows)
        text += (text.empty() ? "" : ", ") + name + " " + std::to_string(count);
    return text.empty() ? "-" : text;
}

} // namespace

void SoakCounts::add(const Operation& operation, const Ending& ending)
{
    ++m_operations;
    ++m_outcomes[operation.action][ending.name()];
    if (operation.mishap && ending.hasStruck)
        ++m_mishaps[mishapName(*operation.mishap)];
}

std::string SoakCounts::text() const
{
    std::string text = std::to_string(m_operations) + " operations, of them "
        + std::to_string(m_groups) + " groups at the same time, " + std::to_string(sumOf(m_mishaps))
        + " with a fault\n\n";
    text += "| operation | times | done | other outcomes |\n|---|---|---|---|\n";
    for (const auto& [action, outcomes] : m_outcomes) {
        std::map<std::string, int> others = outcomes;
        others.erase("done");
        const int sum = sumOf(outcomes);
        text += std::string("| ") + actionNames[static_cast<std::size_t>(action)] + " | "
            + std::to_string(sum) + " | " + std::to_string(sum - sumOf(others)) + " | "
            + listed(others) + " |\n";
    }
    text += "\n| fault | times |\n|---|---|\n";
    for (const auto& [name, count] : m_mishaps)
        text += "| " + name + " | " + std::to_string(count) + " |\n";
    return text;
}

} // namespace axiscomp::test
