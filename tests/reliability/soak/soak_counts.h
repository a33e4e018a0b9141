// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/reliability/soak/operation.h"

#include <map>
#include <string>

namespace axiscomp::test {

/// How often what was done, went wrong and came out.
class SoakCounts {
public:
    void add(const Operation& operation, const Ending& ending);
    void addGroup() { ++m_groups; }
    /// Tables for docs/reliability.md.
    [[nodiscard]] std::string text() const;

private:
    std::map<Action, std::map<std::string, int>> m_outcomes;
    std::map<std::string, int> m_mishaps;
    int m_operations = 0;
    int m_groups = 0;
};

} // namespace axiscomp::test
