// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/format_reader.h"
#include "core/formats/formats.h"
#include "core/formats/klipper/klipper_config.h"
#include "core/text/number_text.h"
#include "core/text/text_file.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <array>

namespace axiscomp::klipper {

namespace {

constexpr std::string_view sectionPrefix = "bed_mesh ";

constexpr std::array<std::string_view, 1> extensions{".cfg"};
constexpr std::array<std::string_view, 8> rules{
    "Each section [bed_mesh NAME] of printer.cfg, which may stand behind #*# as SAVE_CONFIG writes "
    "it, is a profile: one table. The section [bed_mesh] holds settings and no table.",
    "points has a line for each of the y_count positions of Y, beginning at min_y, with x_count "
    "heights each, beginning at min_x.",
    "The positions are evenly spaced from min_x to max_x and from min_y to max_y; older files add "
    "x_offset and y_offset.",
    "The height is added to the commanded Z.",
    "Between the probed points the mesh is refined first, with mesh_x_pps and mesh_y_pps further "
    "points by the method algo (lagrange or bicubic); then it is bilinear.",
    "Outside of the mesh the heights at its edge are held.",
    "With fade the correction becomes less with Z, towards the mean height or fade_target.",
    "Profiles of another version than 1 are not used.",
};
constexpr std::array<std::string_view, 3> assumptions{
    "A height of the bed is not an error of the Z axis. It is understood as the offset that the "
    "firmware adds to the commanded Z, so that the nozzle follows the bed; as a value for the "
    "feedback it is the opposite.",
    "The table holds the probed points; between them it is bilinear here, without the refinement "
    "and without fade.",
    "Positions and heights are in mm.",
};

/// One section [bed_mesh NAME].
struct Profile {
    Token section;
    std::string name;
    std::map<std::string, Token, std::less<>> entries;
    std::vector<Token> rows; ///< of points
};

bool isKnownKey(std::string_view key)
{
    constexpr std::array<std::string_view, 14> keys{"version", "points", "x_count", "y_count",
        "mesh_x_pps", "mesh_y_pps", "algo", "tension", "min_x", "max_x", "min_y", "max_y",
        "x_offset", "y_offset"};
    return std::ranges::find(keys, key) != keys.end();
}

constexpr TextPattern noEntry = AXISCOMP_TEXT("Error", "an entry such as min_x = 10");

/// Reads the sections of a configuration, and looks into those of profiles only.
class Sections {
public:
    explicit Sections(TextReading& source) : m_source(source) { }

    void take(const Token& line);
    void leave() { m_isInProfile = m_isInPoints = false; }
    [[nodiscard]] std::vector<Profile> profiles() && { return std::move(m_profiles); }

private:
    void begin(const Token& section);
    void takeEntry(const Token& line);

    TextReading& m_source;
    std::vector<Profile> m_profiles;
    bool m_isInProfile = false;
    bool m_isInPoints = false;
};

void Sections::begin(const Token& section)
{
    m_isInPoints = false;
    m_isInProfile = section.text.starts_with(sectionPrefix);
    if (!m_isInProfile)
        return;
    Profile profile;
    profile.section = section;
    profile.name = toUtf8(trimmed(section.text.substr(sectionPrefix.size())), Encoding::Utf8);
    if (std::ranges::find(m_profiles, profile.name, &Profile::name) != m_profiles.end())
        m_source.diagnostics.error(DiagnosticCode::Contradiction, section.line, section.column,
            AXISCOMP_TEXT("Error", "a second section for the profile {name}")
                .with("name", profile.name),
            AXISCOMP_TEXT("Error", "each profile once"));
    m_profiles.push_back(std::move(profile));
}

void Sections::takeEntry(const Token& line)
{
    const std::size_t equals = line.text.find_first_of("=:");
    const Token key = trimmedToken(line.part(0, equals));
    m_isInPoints = key.text == "points";
    if (equals == std::string_view::npos) {
        m_source.diagnostics.error(
            DiagnosticCode::Syntax, key.line, key.column, quoted(key), noEntry);
        return;
    }
    if (!isKnownKey(key.text)) {
        m_source.diagnostics.warning(
            DiagnosticCode::UnknownKey, key.line, key.column, quoted(key), {});
        return;
    }
    const Token value = trimmedToken(line.part(equals + 1));
    Profile& profile = m_profiles.back();
    if (!profile.entries.emplace(std::string(key.text), value).second)
        m_source.diagnostics.error(DiagnosticCode::Contradiction, key.line, key.column,
            AXISCOMP_TEXT("Error", "a second {key}").with("key", key.text),
            AXISCOMP_TEXT("Error", "each entry once in a section"));
    if (m_isInPoints && value)
        profile.rows.push_back(value);
}

void Sections::take(const Token& line)
{
    const Token content = trimmedToken(line);
    if (!content)
        return;
    if (const auto section = sectionOf(line)) {
        begin(*section);
        return;
    }
    if (!m_isInProfile)
        return;
    const bool isContinued = line.text.front() == ' ' || line.text.front() == '\t';
    if (!isContinued)
        takeEntry(line);
    else if (m_isInPoints)
        m_profiles.back().rows.push_back(content);
    else
        m_source.diagnostics.error(
            DiagnosticCode::Syntax, content.line, content.column, quoted(content), noEntry);
}

/// The numbers of one profile.
class ProfileReader {
public:
    ProfileReader(const Profile& profile, TextReading& source)
        : m_profile(profile)
        , m_source(source)
    {
    }

    [[nodiscard]] NeutralTable table();

private:
    [[nodiscard]] const Token* entry(const std::string& key);
    [[nodiscard]] SourceAxis axis(
        const std::string& name, const std::string& small, std::int64_t points);
    [[nodiscard]] std::int64_t pointsOf(const std::string& key);
    [[nodiscard]] std::vector<double> heights(std::int64_t columns, std::int64_t rows);
    void checkVersion();

    const Profile& m_profile;
    TextReading& m_source;
};

const Token* ProfileReader::entry(const std::string& key)
{
    const auto found = m_profile.entries.find(key);
    if (found != m_profile.entries.end())
        return &found->second;
    m_source.diagnostics.error(DiagnosticCode::Syntax, m_profile.section.line, 0,
        Verbatim{std::string(m_profile.section.text)},
        AXISCOMP_TEXT("Error", "an entry {key} in this section").with("key", key));
    return nullptr;
}

void ProfileReader::checkVersion()
{
    const auto version = m_profile.entries.find("version");
    if (version != m_profile.entries.end() && version->second.text != "1")
        m_source.diagnostics.error(DiagnosticCode::Contradiction, version->second.line,
            version->second.column,
            AXISCOMP_TEXT("Error", "version {version}").with("version", quoted(version->second)),
            AXISCOMP_TEXT("Error", "1; the firmware does not use other versions"));
}

/// The number of points along an axis; 0 after an error.
std::int64_t ProfileReader::pointsOf(const std::string& key)
{
    const Token* const token = entry(key);
    const auto points = token ? readWholeNumber(*token,
                            AXISCOMP_TEXT("Error", "a number of points"), m_source.diagnostics)
                              : std::nullopt;
    if (!points)
        return 0;
    if (*points >= 2)
        return *points;
    m_source.diagnostics.error(DiagnosticCode::TooFewPoints, token->line, token->column,
        Verbatim{key + " = " + std::to_string(*points)}, AXISCOMP_TEXT("Error", "at least 2"));
    return 0;
}

std::vector<double> ProfileReader::heights(std::int64_t columns, std::int64_t rows)
{
    std::vector<double> values;
    std::vector<Token> cells;
    for (const Token& row : m_profile.rows) {
        if (m_source.isStopped())
            return {};
        splitCells(row, ',', cells);
        if (static_cast<std::int64_t>(cells.size()) != columns)
            m_source.diagnostics.error(DiagnosticCode::ColumnCount, row.line, 0,
                AXISCOMP_COUNTED("Error", "{count} heights", "1 height")
                    .with("count", cells.size()),
                AXISCOMP_TEXT("Error", "{value}, as {key} says")
                    .with("value", columns)
                    .with("key", Verbatim{"x_count"}));
        readNumbers(cells, AXISCOMP_TEXT("Error", "a height in mm"), values, m_source.diagnostics);
    }
    const auto found = static_cast<std::int64_t>(m_profile.rows.size());
    if (found != rows)
        m_source.diagnostics.error(
            found < rows ? DiagnosticCode::MissingPoint : DiagnosticCode::Contradiction,
            m_profile.section.line, 0,
            AXISCOMP_COUNTED("Error", "{count} lines of points", "1 line of points")
                .with("count", found),
            AXISCOMP_TEXT("Error", "{value}, as {key} says")
                .with("value", rows)
                .with("key", Verbatim{"y_count"}));
    return values;
}

SourceAxis ProfileReader::axis(
    const std::string& name, const std::string& small, std::int64_t points)
{
    SourceAxis axis;
    axis.name = name;
    axis.unit = "mm";
    std::array<double, 2> ends{};
    const std::array<std::string, 2> keys{"min_" + small, "max_" + small};
    bool isKnown = true;
    for (std::size_t n = 0; n < ends.size(); ++n) {
        const Token* const token = entry(keys[n]);
        const auto number = token
            ? readNumber(*token, AXISCOMP_TEXT("Error", "a position in mm"), m_source.diagnostics)
            : std::nullopt;
        isKnown = isKnown && number.has_value();
        ends[n] = number.value_or(0.0);
    }
    const auto offset = m_profile.entries.find(small + "_offset");
    if (offset != m_profile.entries.end())
        for (double& end : ends)
            end += readNumber(
                offset->second, AXISCOMP_TEXT("Error", "an offset in mm"), m_source.diagnostics)
                       .value_or(0.0);
    if (isKnown && !(ends[1] > ends[0]))
        m_source.diagnostics.error(DiagnosticCode::NotMonotonic, entry(keys[1])->line, 0,
            AXISCOMP_TEXT("Error", "{number} after {number2}")
                .with("number", keys[1] + " = " + toText(ends[1]))
                .with("number2", keys[0] + " = " + toText(ends[0])),
            AXISCOMP_TEXT("Error", "a maximum above the minimum"));
    if (m_source.diagnostics.hasErrors())
        return axis;
    // The number of points is that of the heights, which are there.
    const auto count = static_cast<std::size_t>(points);
    axis.knots = evenKnots(ends[0], (ends[1] - ends[0]) / static_cast<double>(count - 1), count);
    axis.knots.back() = ends[1];
    return axis;
}

NeutralTable ProfileReader::table()
{
    NeutralTable table;
    table.name = m_profile.name;
    table.sign = SignConvention::Command;
    checkVersion();
    const std::int64_t columns = pointsOf("x_count");
    const std::int64_t rows = pointsOf("y_count");
    CompensationColumn column;
    column.target = "Z";
    column.unit = "mm";
    if (entry("points") && columns > 0 && rows > 0)
        column.values = heights(columns, rows);
    table.axes = {axis("X", "x", columns), axis("Y", "y", rows)};
    table.columns.push_back(std::move(column));
    return table;
}

std::vector<NeutralTable> parse(TextReading& source)
{
    Sections sections(source);
    AutosavedPart autosaved;
    TextLines lines(source.text);
    while (const auto line = lines.next()) {
        if (source.isStopped())
            return {};
        if (autosaved.beginsAt(*line))
            sections.leave();
        sections.take(configLine(*line));
    }
    const std::vector<Profile> profiles = std::move(sections).profiles();
    if (profiles.empty())
        source.diagnostics.error(DiagnosticCode::Syntax, 0, 0, {},
            AXISCOMP_TEXT("Error", "a section [bed_mesh NAME] with the points of a mesh"));
    std::vector<NeutralTable> tables;
    for (const Profile& profile : profiles)
        tables.push_back(ProfileReader(profile, source).table());
    return tables;
}

Result<TableReading> read(std::string_view text, const TableReadOptions& options)
{
    return readText(klipper::format().facts, text, options, parse);
}

Recognition recognise(std::string_view text)
{
    TextLines lines(text);
    while (const auto line = lines.next()) {
        const auto section = sectionOf(configLine(*line));
        if (section && section->text.starts_with(sectionPrefix))
            return Recognition::Certain;
    }
    return Recognition::No;
}

} // namespace

const TableFormat& format()
{
    static const TableFormat format{
        .facts = {.name = "klipper",
            .controller = "Klipper",
            .description = AXISCOMP_TEXT(
                "Error", "[bed_mesh NAME] sections of printer.cfg: heights of the bed"),
            .extensions = extensions,
            .fewestDimensions = 2,
            .mostDimensions = 2,
            .knots = KnotRule::Even,
            .mostTables = 0,
            .holdsNames = true,
            .holdsUnits = true,
            .numbers = "decimal text",
            .sign = SignConvention::Command,
            .signEvidence = Evidence::Code,
            .behaviour = {.outside = Outside::Hold},
            .outsideEvidence = Evidence::Code,
            .rules = rules,
            .assumptions = assumptions},
        .recognise = recognise,
        .read = read};
    return format;
}

} // namespace axiscomp::klipper
