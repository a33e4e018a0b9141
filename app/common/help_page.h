// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/texts/program_texts.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace axiscomp::app {

/// What --help prints, in the language of the texts. What is typed stays as it is: names of
/// commands, options and their values.
class HelpPage final : public CLI::Formatter {
public:
    /// texts must outlive it.
    explicit HelpPage(const ProgramTexts& texts);

    std::string make_description(const CLI::App* app) const override;
    std::string make_group(std::string group, bool isPositional,
        std::vector<const CLI::Option*> options) const override;
    std::string make_option(const CLI::Option* option, bool isPositional) const override;
    std::string make_option_usage(const CLI::Option* option) const override;
    std::string make_subcommands(const CLI::App* app, CLI::AppFormatMode mode) const override;
    std::string make_subcommand(const CLI::App* command) const override;
    std::string make_footer(const CLI::App* app) const override;

private:
    const ProgramTexts& m_texts;
};

/// Text in lines of so many columns of a terminal, the first of which begins at `indent` and the
/// others with as many blanks. Broken at blanks, and where Chinese and Japanese may be broken.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t width, std::size_t indent);

} // namespace axiscomp::app
