// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/edit_distance.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace axiscomp {

namespace {

char withoutCase(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

} // namespace

std::size_t editDistance(
    std::string_view a, std::string_view b, LetterCase letters, std::size_t limit)
{
    const std::size_t difference = a.size() > b.size() ? a.size() - b.size() : b.size() - a.size();
    if (difference >= limit)
        return limit;
    const auto isSame = [letters](char x, char y) {
        return letters == LetterCase::Matters ? x == y : withoutCase(x) == withoutCase(y);
    };
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        std::size_t smallest = row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t above = row[j];
            row[j] = std::min(
                {above + 1, row[j - 1] + 1, diagonal + (isSame(a[i - 1], b[j - 1]) ? 0 : 1)});
            diagonal = above;
            smallest = std::min(smallest, row[j]);
        }
        if (smallest >= limit)
            return limit;
    }
    return std::min(row.back(), limit);
}

} // namespace axiscomp
