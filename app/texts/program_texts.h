// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"

#include <memory>
#include <string>
#include <vector>

namespace axiscomp::app {

/// "en" and every language that there is a translation for.
[[nodiscard]] std::vector<std::string> textLanguages();

/// The first of wantedLanguages() that is one of textLanguages(), else "en".
[[nodiscard]] std::string languageOfEnvironment();

/// The texts of a program in one language. program_texts.cpp; without Qt, and so in English alone,
/// english_texts.cpp.
class ProgramTexts {
public:
    /// language: one of textLanguages().
    explicit ProgramTexts(const std::string& language);
    ~ProgramTexts();

    /// Of a text marked with AXISCOMP_HELP; as it is where there is no translation.
    [[nodiscard]] std::string help(const std::string& text) const;
    /// For Text::worded; must not outlive this.
    [[nodiscard]] Wording wording() const;

private:
    struct Translation;
    std::unique_ptr<Translation> m_translation; ///< null: English
};

} // namespace axiscomp::app
