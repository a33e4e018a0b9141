// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output/step_words.h"

#include <algorithm>
#include <array>

namespace axiscomp::app {

namespace {

struct Step {
    std::string_view id;
    std::string_view words;
};

constexpr std::array steps{
    Step{"plan", "look at the drive and plan"},
    Step{"backup", "keep the old state in a backup"},
    Step{"begin", "check that nothing has changed meanwhile"},
    Step{"switch off", "switch the axis to no table"},
    Step{"upload", "upload the table"},
    Step{"verify", "read the table back and compare every byte"},
    Step{"commit", "store the table in flash"},
    Step{"switch", "switch the axis over and read back"},
    Step{"save", "save the parameters and read back"},
    Step{"putting back", "put the old state back"},
    Step{"download", "download"},
};

} // namespace

std::string stepWords(std::string_view step)
{
    const auto* const known = std::ranges::find(steps, step, &Step::id);
    return std::string(known == steps.end() ? step : known->words);
}

} // namespace axiscomp::app
