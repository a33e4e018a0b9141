// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/formats/measurement_formats.h"
#include "core/metrology/formats/run_assembly.h"
#include "core/table/position_unit.h"
#include "core/text/text_file.h"
#include "core/text/token_scanner.h"
#include "core/text/utf8.h"

#include <algorithm>
#include <array>

namespace axiscomp::api_pos {

namespace {

constexpr std::array<std::string_view, 1> extensions{".pos"};
constexpr std::array kinds{MeasurementKind::Averages};
constexpr std::array<std::string_view, 3> rules{
    "Blocks begin with a line Position and Bidirectional Avg Error, Forward Directional Avg Error "
    "or Reverse Directional Avg Error; lines of position and error in mm follow. The file holds "
    "means, so nothing can be said of repeatability and accuracy.",
    "Where there is no block for the reverse direction, its mean is 2 x bidirectional - forward.",
    "A line Unit or Units with another unit than mm, such as Units: inch, does not say whether it "
    "is that of positions or errors, so both have to be stated: --unit and --value-unit.",
};
constexpr std::array<std::string_view, 1> assumptions{
    "An error is the measured position minus the target. Everything else in the file becomes a "
    "note, but for a line within a block that begins like a number and is no pair.",
};

enum class Block { None, Bidirectional, Forward, Reverse };

struct Entry {
    double position = 0.0;
    double error = 0.0;
    std::size_t line = 0;
};

std::optional<Block> blockOf(std::string_view line)
{
    std::vector<Token> words;
    splitTokens({line, 1, 1}, " \t", words);
    const bool isHead = words.size() >= 4 && sameLetters(words[0].text, "Position")
        && sameLetters(words.back().text, "Error");
    if (!isHead)
        return std::nullopt;
    if (sameLetters(words[1].text, "Bidirectional"))
        return Block::Bidirectional;
    if (sameLetters(words[1].text, "Forward"))
        return Block::Forward;
    return sameLetters(words[1].text, "Reverse") ? std::optional(Block::Reverse) : std::nullopt;
}

/// "1,000.0" and "-.5*", but neither a line of dashes nor a word.
bool beginsLikeNumber(std::string_view text)
{
    const std::size_t digit = text.find_first_not_of("+-.");
    return digit <= 2 && digit < text.size() && text[digit] >= '0' && text[digit] <= '9';
}

class Reader {
public:
    Reader(Measurement& measurement, const MeasurementReadOptions& options,
        DiagnosticList& diagnostics, Encoding encoding)
        : m_measurement(measurement)
        , m_options(options)
        , m_diagnostics(diagnostics)
        , m_encoding(encoding)
    {
    }

    void takeLine(const Token& line);
    [[nodiscard]] std::vector<RawRunValue> values();

private:
    void takeUnit(const Token& content);
    [[nodiscard]] std::vector<Entry>& entries()
    {
        return m_blocks[static_cast<std::size_t>(m_block)];
    }
    [[nodiscard]] const std::vector<Entry>& entriesOf(Block block) const
    {
        return m_blocks[static_cast<std::size_t>(block)];
    }
    void addFollowing(std::vector<RawRunValue>& values);
    void inUnits(std::vector<RawRunValue>& values);

    Measurement& m_measurement;
    const MeasurementReadOptions& m_options;
    DiagnosticList& m_diagnostics;
    Encoding m_encoding;
    Block m_block = Block::None;
    bool m_isAmongPairs = false; ///< since the head of the block or a pair no line of words
    std::array<std::vector<Entry>, 4> m_blocks;
    Token m_unitLine; ///< that says another unit than that of the format
    std::string m_unit = "mm";
};

/// "Units: inch", the first that is not mm.
void Reader::takeUnit(const Token& content)
{
    std::vector<Token> words;
    splitTokens(content, " \t:=", words);
    if (m_unitLine || words.size() != 2
        || !(sameLetters(words[0].text, "Unit") || sameLetters(words[0].text, "Units")))
        return;
    std::string unit = toUtf8(words[1].text, m_encoding);
    if (!isPositionUnit(unit) || isSameUnit(unit, m_unit))
        return;
    m_unit = std::move(unit);
    m_unitLine = content;
}

void Reader::takeLine(const Token& line)
{
    const Token content = trimmedToken(line);
    if (const auto block = blockOf(content.text)) {
        m_block = *block;
        m_isAmongPairs = true;
        return;
    }
    std::vector<Token> words;
    splitTokens(content, " \t", words);
    const bool isPair = m_block != Block::None && words.size() == 2 && numberOf(words[0].text);
    if (isPair) {
        const auto position =
            readNumber(words[0], AXISCOMP_TEXT("Error", "a position in mm"), m_diagnostics);
        const auto error =
            readNumber(words[1], AXISCOMP_TEXT("Error", "an error in mm"), m_diagnostics);
        if (position && error)
            entries().push_back({*position, *error, content.line});
        m_isAmongPairs = true;
        return;
    }
    if (m_isAmongPairs && beginsLikeNumber(content.text)) {
        m_diagnostics.error(DiagnosticCode::Syntax, content.line, 0,
            Verbatim{excerpt(content.text, m_encoding)},
            AXISCOMP_TEXT("Error",
                "a position and an error in mm, with decimal points and without separators of "
                "thousands"));
        return;
    }
    takeUnit(content);
    // Behind a line of words another table may stand, of which nothing is known.
    if (content && content.text.find_first_not_of("+-._= \t") != std::string_view::npos)
        m_isAmongPairs = false;
    constexpr std::size_t mostNotes = 1000;
    if (content && m_measurement.notes.size() < mostNotes)
        m_measurement.notes.push_back(shownText(toUtf8(content.text, m_encoding), 1000));
}

RawRunValue valueOf(const Entry& entry, Approach direction, double error)
{
    RawRunValue raw;
    raw.target = entry.position;
    raw.value.direction = direction;
    raw.value.deviation = error;
    raw.value.line = entry.line;
    return raw;
}

/// The reverse direction where only the mean of both and the forward one are there.
void Reader::addFollowing(std::vector<RawRunValue>& values)
{
    const std::vector<Entry>& both = entriesOf(Block::Bidirectional);
    const std::vector<Entry>& one = entriesOf(Block::Forward);
    for (const Entry& mean : both)
        if (!one.empty() && std::ranges::find(one, mean.position, &Entry::position) == one.end())
            m_diagnostics.error(DiagnosticCode::CountMismatch, mean.line, 0,
                AXISCOMP_TEXT("Error", "a position without a forward mean"),
                AXISCOMP_TEXT("Error", "the same positions in both blocks"));
    for (const Entry& forward : one) {
        const auto mean = std::ranges::find(both, forward.position, &Entry::position);
        if (mean == both.end())
            m_diagnostics.error(DiagnosticCode::CountMismatch, forward.line, 0,
                AXISCOMP_TEXT("Error", "a position without a bidirectional mean"),
                AXISCOMP_TEXT("Error", "the same positions in both blocks"));
        else
            values.push_back(valueOf(forward, Approach::Down, 2.0 * mean->error - forward.error));
    }
}

/// The format has mm for both; another unit may be that of one of them.
void Reader::inUnits(std::vector<RawRunValue>& values)
{
    if (m_unitLine && (m_options.unit.empty() || m_options.valueUnit.empty())) {
        m_diagnostics.error(DiagnosticCode::UnitMissing, m_unitLine.line, 0,
            Verbatim{excerpt(m_unitLine.text, m_encoding)},
            AXISCOMP_TEXT("Error",
                "mm, or both units stated: that of the positions (--unit) and that of the errors "
                "(--value-unit)"));
        return;
    }
    const auto targets =
        unitOfFormat("targets", m_options.unit, m_unit, m_measurement, m_diagnostics);
    const auto errors =
        unitOfFormat("values", m_options.valueUnit, m_unit, m_measurement, m_diagnostics);
    if (!targets || !errors || !areSameKind(*targets, *errors, m_diagnostics))
        return;
    m_measurement.isAngular = targets->isAngular;
    for (RawRunValue& raw : values) {
        raw.target *= targets->factor;
        raw.value.deviation *= errors->factor;
    }
}

std::vector<RawRunValue> Reader::values()
{
    std::vector<RawRunValue> values;
    for (const Entry& entry : entriesOf(Block::Forward))
        values.push_back(valueOf(entry, Approach::Up, entry.error));
    for (const Entry& entry : entriesOf(Block::Reverse))
        values.push_back(valueOf(entry, Approach::Down, entry.error));
    if (entriesOf(Block::Reverse).empty())
        addFollowing(values);
    if (values.empty() && !m_diagnostics.hasErrors())
        m_diagnostics.error(DiagnosticCode::Syntax, 0, 0,
            AXISCOMP_TEXT("Error", "no block of a direction"),
            AXISCOMP_TEXT("Error",
                "a block Forward Directional Avg Error; the mean of both directions alone says "
                "nothing of either"));
    inUnits(values);
    return values;
}

MeasurementRecognition recognise(std::string_view text)
{
    TextLines lines(text);
    while (const auto line = lines.next())
        if (blockOf(line->text))
            return MeasurementRecognition::Certain;
    return MeasurementRecognition::No;
}

} // namespace

const MeasurementFormat& format()
{
    static const MeasurementFormat format{
        .facts = {.name = "api-pos",
            .origin = "API laser software",
            .description = AXISCOMP_TEXT("Error", "means of a linear measurement (.pos)"),
            .extensions = extensions,
            .kinds = kinds,
            .rules = rules,
            .assumptions = assumptions},
        .recognise = recognise,
        .read = readRuns<valuesByLine<Reader>, MeasurementKind::Averages>};
    return format;
}

} // namespace axiscomp::api_pos
