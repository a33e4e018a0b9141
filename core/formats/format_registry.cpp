// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/formats.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string>

namespace axiscomp {

namespace {

bool hasExtension(const FamilyFacts& facts, std::string_view fileName)
{
    return std::ranges::any_of(facts.extensions, [&](std::string_view extension) {
        return fileName.size() > extension.size()
            && sameLetters(fileName.substr(fileName.size() - extension.size()), extension);
    });
}

/// What tells one format from another stands within this.
constexpr std::size_t longestBeginning = std::size_t{64} * 1024;

} // namespace

std::string_view evidenceName(Evidence evidence)
{
    switch (evidence) {
    case Evidence::Published:
        return "published";
    case Evidence::Code:
        return "read in program code";
    case Evidence::Assumed:
        break;
    }
    return "assumed";
}

bool TableReading::hasErrors() const
{
    return suppressed > 0
        || std::ranges::find(diagnostics, Severity::Error, &Diagnostic::severity)
        != diagnostics.end();
}

std::span<const TableFamily* const> tableFamilies()
{
    static const std::array families{
        &calibration_csv::format(),
        &tam_table::format(),
        &aerotech_1d::format(),
        &aerotech_2d::format(),
        &icube::format(),
        &isg_crosscomp::format(),
        &isg_crosscomp2::format(),
        &isg_ssfk::format(),
        &klipper::format(),
        &linuxcnc::format(),
        &pmac_1d::format(),
        &pmac_2d::format(),
        &rapidcode::format(),
        &rapidcode_header::format(),
        &siemens_cec::format(),
        &siemens_eec::format(),
        &reprap::format(),
        &softmc::format(),
        &softmc_basic::format(),
    };
    return families;
}

bool isTriamec(const TableFamily& family)
{
    return &family == &calibration_csv::format() || &family == &tam_table::format();
}

std::string familyNames(std::span<const TableFamily* const> families)
{
    std::string names;
    for (const TableFamily* family : families)
        names += (names.empty() ? "" : ", ") + std::string(family->facts.name);
    return names;
}

std::string beginningOf(const std::filesystem::path& file)
{
    std::string text(longestBeginning, '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
    return text;
}

Result<const TableFamily*> familyNamed(std::string_view name)
{
    for (const TableFamily* family : tableFamilies())
        if (sameLetters(name, family->facts.name))
            return family;
    return fail(ErrorCode::UnknownFormat,
        {{"file", std::string(name)}, {"known", familyNames(tableFamilies())}});
}

FormatGuess guessFamily(std::string_view text, std::string_view fileName)
{
    struct Candidate {
        const TableFamily* family;
        Recognition recognition;
        bool hasExtension;
    };
    std::vector<Candidate> candidates;
    for (const TableFamily* family : tableFamilies()) {
        const bool isBinary = family->read && !family->recognise;
        const bool hasName = hasExtension(family->facts, fileName);
        Recognition recognition = isBinary && hasName ? Recognition::Possible : Recognition::No;
        if (family->recognise)
            recognition = family->recognise(text.substr(0, longestBeginning));
        if (recognition != Recognition::No)
            candidates.push_back({family, recognition, hasName});
    }
    const auto rank = [](const Candidate& c) {
        return std::pair(c.recognition != Recognition::Certain, !c.hasExtension);
    };
    std::ranges::stable_sort(candidates, {}, rank);
    FormatGuess guess;
    for (const Candidate& candidate : candidates)
        guess.families.push_back(candidate.family);
    const bool isOne = candidates.size() == 1
        || (candidates.size() > 1 && candidates[0].recognition == Recognition::Certain
            && candidates[1].recognition != Recognition::Certain);
    guess.isCertain = isOne;
    return guess;
}

const TableFamily* familyOfExtension(std::string_view fileName)
{
    const TableFamily* found = nullptr;
    for (const TableFamily* family : tableFamilies()) {
        if (!hasExtension(family->facts, fileName))
            continue;
        // The product's own formats come first and have the extension to themselves.
        if (found == nullptr)
            found = family;
        else if (!isTriamec(*found))
            return nullptr;
    }
    return found;
}

Result<FormatChoice> chooseFamily(
    std::string_view text, const std::string& fileName, bool isCalibration)
{
    const TableFamily* const named = familyOfExtension(fileName);
    if (named == &tam_table::format() || (named == &calibration_csv::format() && isCalibration))
        return FormatChoice{named, {}};
    const FormatGuess guess = guessFamily(text, fileName);
    if (guess.families.empty() && named != nullptr)
        return FormatChoice{named, {}};
    if (guess.families.empty())
        return fail(ErrorCode::UnknownFormat,
            {{"file", fileName}, {"known", familyNames(tableFamilies())}});
    FormatChoice choice{guess.families.front(), {}};
    choice.others.assign(guess.families.begin() + 1, guess.families.end());
    const bool isDecided = guess.isCertain || guess.families.size() == 1
        || choice.family == &calibration_csv::format()
        || hasExtension(choice.family->facts, fileName);
    if (isDecided)
        return choice;
    return fail(ErrorCode::FormatAmbiguous,
        {{"file", fileName}, {"candidates", familyNames(guess.families)}});
}

Result<const TableFamily*> outputFamily(const std::string& fileName, const std::string& formatName)
{
    const auto named = formatName.empty() ? Result<const TableFamily*>(familyOfExtension(fileName))
                                          : familyNamed(formatName);
    if (!named)
        return fail(named.error());
    if (*named != nullptr && (*named)->write == nullptr)
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                "the format " + std::string((*named)->facts.name) + " can be read, not written"}});
    if (*named != nullptr)
        return named;
    std::vector<const TableFamily*> candidates;
    for (const TableFamily* family : tableFamilies())
        if (family->write && hasExtension(family->facts, fileName))
            candidates.push_back(family);
    if (candidates.empty())
        return fail(ErrorCode::UnknownFormat,
            {{"file", fileName}, {"known", familyNames(tableFamilies())}});
    return fail(
        ErrorCode::FormatAmbiguous, {{"file", fileName}, {"candidates", familyNames(candidates)}});
}

} // namespace axiscomp
