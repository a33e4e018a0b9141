// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/texts/program_texts.h"

namespace axiscomp::app {

struct ProgramTexts::Translation { };

std::vector<std::string> textLanguages()
{
    return {"en"};
}

std::string languageOfEnvironment()
{
    return "en";
}

ProgramTexts::ProgramTexts(const std::string& /*language*/) { }

ProgramTexts::~ProgramTexts() = default;

std::string ProgramTexts::help(const std::string& text) const
{
    return text;
}

Wording ProgramTexts::wording() const
{
    Wording wording;
    wording.words = [](const TextPattern& pattern, std::optional<std::int64_t> count) {
        return std::string(pattern.one != nullptr && count == 1 ? pattern.one : pattern.words);
    };
    return wording;
}

} // namespace axiscomp::app
