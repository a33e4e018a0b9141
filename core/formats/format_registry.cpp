// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/formats.h"
#include "core/io/local_file.h"
#include "core/metrology/formats/measurement_format.h"
#include "core/text/text_file.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string>

namespace axiscomp {

namespace {

bool hasExtension(const FormatFacts& facts, std::string_view fileName)
{
    return std::ranges::any_of(facts.extensions, [&](std::string_view extension) {
        return fileName.size() > extension.size()
            && sameLetters(fileName.substr(fileName.size() - extension.size()), extension);
    });
}

/// An extension that says nothing of what is in the file.
bool isOfAnything(std::string_view fileName)
{
    constexpr std::array<std::string_view, 5> extensions{".txt", ".ini", ".cfg", ".prg", ".dat"};
    return std::ranges::any_of(extensions, [fileName](std::string_view extension) {
        return fileName.size() >= extension.size()
            && sameLetters(fileName.substr(fileName.size() - extension.size()), extension);
    });
}

/// Naming a format does not help with UTF-16.
Error ofNoFormat(std::string_view text, const std::string& fileName)
{
    if (isUtf16(text))
        return {ErrorCode::UnknownFormat, {{"file", fileName}, {"utf16", Verbatim{"yes"}}}, {}};
    return {
        ErrorCode::UnknownFormat, {{"file", fileName}, {"known", formatNames(tableFormats())}}, {}};
}

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

std::span<const TableFormat* const> tableFormats()
{
    static const std::array formats{
        &calibration_csv::format(),
        &tam_table::format(),
        &acs_1d::format(),
        &acs_2d::format(),
        &aerotech_1d::format(),
        &aerotech_2d::format(),
        &fanuc::format(),
        &heidenhain_com::format(),
        &heidenhain_com_530::format(),
        &icube::format(),
        &isg_crosscomp::format(),
        &isg_crosscomp2::format(),
        &isg_ssfk::format(),
        &klipper::format(),
        &klipper_twist::format(),
        &kmotion_geo::format(),
        &kmotion_linear::format(),
        &linuxcnc::format(),
        &pmac_1d::format(),
        &pmac_2d::format(),
        &power_pmac::format(),
        &rapidcode::format(),
        &rapidcode_header::format(),
        &siemens_cec::format(),
        &siemens_eec::format(),
        &reprap::format(),
        &softmc::format(),
        &softmc_basic::format(),
        &twincat_nc::format(),
        &weihong::format(),
    };
    return formats;
}

bool isTriamec(const TableFormat& format)
{
    return &format == &calibration_csv::format() || &format == &tam_table::format();
}

std::string formatNames(std::span<const TableFormat* const> formats)
{
    std::string names;
    for (const TableFormat* format : formats)
        names += (names.empty() ? "" : ", ") + std::string(format->facts.name);
    return names;
}

std::string beginningOf(const std::filesystem::path& file)
{
    return std::string(asText(loadBeginning(file, longestBeginning)));
}

Result<const TableFormat*> formatNamed(std::string_view name)
{
    for (const TableFormat* format : tableFormats())
        if (sameLetters(name, format->facts.name))
            return format;
    return fail(ErrorCode::UnknownFormat,
        {{"file", std::string(name)}, {"known", formatNames(tableFormats())}});
}

FormatGuess guessFormat(std::string_view text, std::string_view fileName)
{
    struct Candidate {
        const TableFormat* format;
        Recognition recognition;
        bool hasExtension;
    };
    std::vector<Candidate> candidates;
    for (const TableFormat* format : tableFormats()) {
        const bool isBinary = format->read && !format->recognise;
        const bool hasName = hasExtension(format->facts, fileName);
        Recognition recognition = isBinary && hasName ? Recognition::Possible : Recognition::No;
        if (format->recognise)
            recognition = format->recognise(text.substr(0, longestBeginning));
        if (recognition != Recognition::No)
            candidates.push_back({format, recognition, hasName});
    }
    const auto rank = [](const Candidate& c) {
        return std::pair(c.recognition != Recognition::Certain, !c.hasExtension);
    };
    std::ranges::stable_sort(candidates, {}, rank);
    FormatGuess guess;
    for (const Candidate& candidate : candidates)
        guess.formats.push_back(candidate.format);
    const bool isOne = candidates.size() == 1
        || (candidates.size() > 1 && candidates[0].recognition == Recognition::Certain
            && candidates[1].recognition != Recognition::Certain);
    guess.isCertain = isOne;
    return guess;
}

const TableFormat* formatOfExtension(std::string_view fileName)
{
    const TableFormat* found = nullptr;
    for (const TableFormat* format : tableFormats()) {
        if (!hasExtension(format->facts, fileName))
            continue;
        // The product's own formats come first and have the extension to themselves.
        if (found == nullptr)
            found = format;
        else if (!isTriamec(*found))
            return nullptr;
    }
    return found;
}

Result<FormatChoice> chooseFormat(
    std::string_view text, const std::string& fileName, bool isCalibration)
{
    const TableFormat* const named = formatOfExtension(fileName);
    if (named == &tam_table::format())
        return FormatChoice{named, {}};
    if (isCertainMeasurement(text))
        return fail(ErrorCode::UnknownFormat, {{"file", fileName}, {"measured", Verbatim{"yes"}}});
    if (named == &calibration_csv::format() && isCalibration)
        return FormatChoice{named, {}};
    const FormatGuess guess = guessFormat(text, fileName);
    const bool isTelling = named != nullptr && named->read != nullptr && !isOfAnything(fileName);
    if (guess.formats.empty() && isTelling)
        return FormatChoice{named, {}};
    if (guess.formats.empty())
        return fail(ofNoFormat(text, fileName));
    FormatChoice choice{guess.formats.front(), {}};
    choice.others.assign(guess.formats.begin() + 1, guess.formats.end());
    const bool isDecided = guess.isCertain || guess.formats.size() == 1
        || hasExtension(choice.format->facts, fileName);
    const bool isCalibrationName = named == &calibration_csv::format();
    const bool isSure = isTriamec(*choice.format)
        || (isDecided
            && choice.format->recognise(text.substr(0, longestBeginning)) == Recognition::Certain);
    if (isSure || (!isCalibrationName && named == choice.format && guess.formats.size() == 1))
        return choice;
    std::vector<const TableFormat*> candidates = guess.formats;
    if (isCalibrationName)
        candidates.push_back(named);
    return fail(
        ErrorCode::FormatAmbiguous, {{"file", fileName}, {"candidates", formatNames(candidates)}});
}

bool isOfMeasurement(const Result<FormatChoice>& choice)
{
    return !choice && choice.error().context.contains("measured");
}

Result<const TableFormat*> outputFormat(const std::string& fileName, const std::string& formatName)
{
    const auto named = formatName.empty() ? Result<const TableFormat*>(formatOfExtension(fileName))
                                          : formatNamed(formatName);
    if (!named)
        return fail(named.error());
    if (*named != nullptr && (*named)->write == nullptr)
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error", "the format {format} can be read, not written")
                    .with("format", (*named)->facts.name)}});
    if (*named != nullptr)
        return named;
    std::vector<const TableFormat*> writable;
    std::ranges::copy_if(tableFormats(), std::back_inserter(writable),
        [](const TableFormat* format) { return format->write != nullptr; });
    std::vector<const TableFormat*> candidates;
    std::ranges::copy_if(writable, std::back_inserter(candidates),
        [&](const TableFormat* format) { return hasExtension(format->facts, fileName); });
    if (candidates.empty())
        return fail(ErrorCode::UnknownFormat,
            {{"file", fileName}, {"known", formatNames(writable)}, {"written", Verbatim{"yes"}}});
    return fail(
        ErrorCode::FormatAmbiguous, {{"file", fileName}, {"candidates", formatNames(candidates)}});
}

} // namespace axiscomp
