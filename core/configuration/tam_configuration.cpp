// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/configuration/tam_configuration.h"

#include "core/drive/register_value.h"
#include "core/io/local_file.h"
#include "core/text/token_scanner.h"
#include "core/text/utf8.h"
#include "core/text/xml_tags.h"

#include <algorithm>
#include <array>
#include <ranges>
#include <utility>

namespace axiscomp {

namespace {

constexpr std::size_t mostRegisters = 100'000; ///< a drive has some 3000

std::string attributeText(const XmlTag& tag, std::string_view name)
{
    const XmlTag::Attribute* attribute = tag.find(name);
    return attribute ? attribute->value : std::string();
}

class TamReader {
public:
    TamReader(std::string_view text, const std::string& fileName)
        : m_tags(text)
        , m_fileName(fileName)
    {
    }

    [[nodiscard]] Result<std::vector<TamStation>> read()
    {
        while (const auto tag = m_tags.next()) {
            if (m_moduleDepth > 0)
                m_moduleDepth += tag->isEnd ? -1 : 1;
            else if (!tag->isEnd)
                AXISCOMP_CHECK(begin(*tag));
        }
        if (m_tags.problem())
            return wrong(m_tags.line(), *m_tags.problem());
        return std::move(m_stations);
    }

private:
    [[nodiscard]] tl::unexpected<Error> wrong(std::size_t line, Text reason) const
    {
        return fail(ErrorCode::InvalidConfiguration,
            {{"file", m_fileName}, {"line", line}, {"reason", std::move(reason)}});
    }

    [[nodiscard]] Result<void> begin(const XmlTag& tag)
    {
        if (!m_hasRoot && tag.name != "TamTopology")
            return wrong(tag.line,
                AXISCOMP_TEXT("Error", "the root element is {name}, expected TamTopology")
                    .with("name", shownText(tag.name)));
        m_hasRoot = true;
        if (tag.name == "TamStation")
            return station(tag);
        if (tag.name == "TamModule")
            m_moduleDepth = 1;
        else if (tag.name == "RegisterComponent" && !m_stations.empty())
            return registerComponent(tag);
        return {};
    }

    [[nodiscard]] Result<void> station(const XmlTag& tag)
    {
        TamStation& added = m_stations.emplace_back();
        added.name = attributeText(tag, "Name");
        const std::string serial = attributeText(tag, "HardwareSerialNumber");
        if (serial.empty())
            return {};
        const auto number = registerValueFromText("Int32", serial);
        if (!number)
            return wrong(tag.line,
                AXISCOMP_TEXT("Error", "{place}: {problem}")
                    .with("place", Verbatim{"HardwareSerialNumber"})
                    .with("problem", textOf(number.error())));
        added.serialNumber = std::get<std::int32_t>(*number);
        return {};
    }

    [[nodiscard]] Result<void> registerComponent(const XmlTag& tag)
    {
        const XmlTag::Attribute* value = tag.find("Value");
        TamRegister read{normalisedPath(attributeText(tag, "Address")), attributeText(tag, "Type"),
            value ? value->value : std::string(), tag.line, value ? value->offset : 0,
            value ? value->size : 0};
        if (read.path.empty() || read.type.empty() || !value)
            return wrong(tag.line,
                AXISCOMP_TEXT("Error", "a RegisterComponent needs Address, Type and Value"));
        if (++m_registers > mostRegisters)
            return wrong(tag.line,
                AXISCOMP_TEXT("Error", "there are more than {most} registers")
                    .with("most", mostRegisters));
        m_stations.back().registers.push_back(std::move(read));
        return {};
    }

    XmlTags m_tags;
    std::string m_fileName;
    std::vector<TamStation> m_stations;
    std::size_t m_registers = 0;
    int m_moduleDepth = 0; ///< what is in a module is not the drive's own
    bool m_hasRoot = false;
};

} // namespace

const TamRegister* TamStation::find(std::string_view path) const
{
    const auto found = std::find_if(registers.rbegin(), registers.rend(),
        [&](const TamRegister& each) { return each.path == path; });
    return found == registers.rend() ? nullptr : &*found;
}

Result<std::vector<TamStation>> readTamStations(std::string_view text, const std::string& fileName)
{
    return TamReader(text, fileName).read();
}

Result<TamConfiguration> loadTamConfiguration(
    const std::filesystem::path& file, const std::string& fileName)
{
    TamConfiguration configuration;
    configuration.fileName = fileName;
    AXISCOMP_TRY(configuration.bytes, loadFile(file, maximumConfigurationSize));
    AXISCOMP_TRY(configuration.stations, readTamStations(asText(configuration.bytes), fileName));
    return configuration;
}

std::string stationName(const TamStation& station)
{
    std::string text = station.name.empty() ? "?" : shownText(station.name);
    if (station.serialNumber)
        text += " (" + std::to_string(*station.serialNumber) + ")";
    return text;
}

std::string tamUnit(const std::string& word)
{
    if (sameLetters(word, "unspecified"))
        return "None";
    constexpr std::array<std::string_view, 5> units{
        "None", "Meter", "Millimeter", "Radian", "Degree"};
    const auto* const known =
        std::ranges::find_if(units, [&](std::string_view unit) { return sameLetters(word, unit); });
    return known == units.end() ? word : std::string(*known);
}

} // namespace axiscomp
