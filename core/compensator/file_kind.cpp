// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compensator/file_kind.h"

#include "core/formats/table_format.h"
#include "core/io/local_file.h"
#include "core/metrology/formats/measurement_format.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <array>

namespace axiscomp {

namespace {

struct NamedKind {
    std::string_view extension;
    FileKind kind;
};
constexpr std::array namedKinds{NamedKind{".axcal", FileKind::Record},
    NamedKind{".toml", FileKind::MachineFile}, NamedKind{".TAMcfg", FileKind::Configuration},
    NamedKind{".TAMtbl", FileKind::Table}};

bool endsWith(std::string_view fileName, std::string_view extension)
{
    return fileName.size() >= extension.size()
        && sameLetters(fileName.substr(fileName.size() - extension.size()), extension);
}

/// What the program and TAM begin their own files with.
std::optional<FileKind> kindOfMark(std::string_view beginning)
{
    const auto isThere = [beginning](std::string_view text) {
        return beginning.substr(0, 1024).find(text) != std::string_view::npos;
    };
    if (isThere("\"axiscomp-record\""))
        return FileKind::Record;
    if (isThere("<TamTopology"))
        return FileKind::Configuration;
    return std::nullopt;
}

bool mayBeMeasurement(std::string_view beginning, std::string_view fileName)
{
    return std::ranges::any_of(measurementFormats(), [&](const MeasurementFormat* format) {
        return format->recognise(beginning) == MeasurementRecognition::Possible
            && std::ranges::any_of(format->facts.extensions,
                [fileName](std::string_view each) { return endsWith(fileName, each); });
    });
}

bool isTable(std::string_view beginning, const std::string& fileName)
{
    const auto choice = chooseFormat(beginning, fileName, false);
    return choice || choice.error().code == ErrorCode::FormatAmbiguous;
}

} // namespace

std::optional<FileKind> kindOfName(std::string_view fileName)
{
    for (const NamedKind& named : namedKinds)
        if (endsWith(fileName, named.extension))
            return named.kind;
    return std::nullopt;
}

Result<FileKind> kindOfFile(std::string_view beginning, const std::string& fileName)
{
    if (const auto named = kindOfName(fileName))
        return *named;
    if (const auto marked = kindOfMark(beginning))
        return *marked;
    if (isCertainMeasurement(beginning))
        return FileKind::Measurement;
    if (isTable(beginning, fileName))
        return FileKind::Table;
    if (mayBeMeasurement(beginning, fileName))
        return FileKind::Measurement;
    return fail(ErrorCode::UnknownFormat, {{"file", fileName}, {"opened", Verbatim{"yes"}}});
}

Result<FileKind> kindOfFile(const std::filesystem::path& file)
{
    const std::string beginning = beginningOf(file);
    if (beginning.empty())
        AXISCOMP_CHECK(loadFile(file, 0)); // which says what is wrong with it
    return kindOfFile(beginning, file.filename().string());
}

} // namespace axiscomp
