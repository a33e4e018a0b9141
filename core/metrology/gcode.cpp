// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/gcode.h"

#include "core/text/number_text.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace axiscomp {

namespace {

constexpr std::array<std::string_view, 3> dialectNames{"linuxcnc", "fanuc", "siemens"};

struct DialectWords {
    std::string_view begin;
    std::string_view metric;
    std::string_view end;
    std::string_view commentBegin;
    std::string_view commentEnd;
};

DialectWords dialectWords(GcodeDialect dialect)
{
    switch (dialect) {
    case GcodeDialect::LinuxCnc:
        return {"", "G21", "M2\n", "(", ")"};
    case GcodeDialect::Fanuc:
        return {"%\nO0001\n", "G21", "M30\n%\n", "(", ")"};
    case GcodeDialect::Siemens:
        break;
    }
    return {"", "G710", "M30\n", "; ", ""};
}

/// Letters of linear and rotary axes, that no dialect uses for anything else.
bool isProgramAxis(char letter)
{
    return std::string_view("XYZABCUVW").find(letter) != std::string_view::npos;
}

/// "X", or "X1=" on a SINUMERIK. Empty: the dialect has no word for it.
std::string axisWord(const std::string& axis, GcodeDialect dialect)
{
    if (axis.empty() || !isProgramAxis(axis.front()))
        return {};
    if (axis.size() == 1)
        return axis;
    constexpr std::size_t longest = 3;
    const bool isNumbered = axis.size() <= longest
        && std::all_of(axis.begin() + 1, axis.end(), [](char c) { return c >= '0' && c <= '9'; });
    return dialect == GcodeDialect::Siemens && isNumbered ? axis + "=" : std::string();
}

std::string dwellBlock(double seconds, GcodeDialect dialect)
{
    constexpr double millisecondsPerSecond = 1000.0;
    switch (dialect) {
    case GcodeDialect::LinuxCnc:
        return "G4 P" + toText(seconds) + "\n";
    case GcodeDialect::Fanuc:
        return "G04 P" + std::to_string(std::llround(std::ceil(seconds * millisecondsPerSecond)))
            + "\n";
    case GcodeDialect::Siemens:
        break;
    }
    return "G4 F" + toText(seconds) + "\n";
}

class ProgramWriter {
public:
    ProgramWriter(const MeasuringPlan& plan, GcodeDialect dialect, std::string axis)
        : m_plan(plan)
        , m_dialect(dialect)
        , m_words(dialectWords(dialect))
        , m_axis(std::move(axis))
    {
    }

    std::string write()
    {
        m_text = m_words.begin;
        describe();
        m_text += std::string(m_words.metric) + " G90 G94\n";
        std::optional<double> position;
        for (const MeasuringStep& step : m_plan.steps) {
            comment("STEP " + std::to_string(step.step) + " RUN " + std::to_string(step.run)
                + (step.direction == Approach::Up ? " UP" : " DOWN"));
            if (position != step.approach)
                move(step.approach);
            move(step.target);
            m_text += dwellBlock(m_plan.dwellSeconds, m_dialect);
            position = step.target;
        }
        m_text += m_words.end;
        return std::move(m_text);
    }

private:
    /// In capital letters, digits, blanks, points and signs, which every control shows.
    void comment(const std::string& words)
    {
        m_text.append(m_words.commentBegin).append(words).append(m_words.commentEnd).append("\n");
    }
    void describe()
    {
        const std::string unit = m_plan.isAngular ? " DEG" : " MM";
        const std::vector<double> targets = targetsOf(m_plan);
        const PlanTravel travel = planTravel(m_plan);
        comment("AXISCOMP MEASURING PROGRAM FOR AXIS " + m_plan.axis);
        comment("TARGETS " + std::to_string(targets.size()) + " POSITIONS "
            + std::to_string(m_plan.steps.size()) + " SEED " + std::to_string(m_plan.seed));
        comment("MOVES FROM " + planPosition(travel.lowest) + " TO " + planPosition(travel.highest)
            + unit);
        comment("POSITIONS ARE THOSE OF THE MACHINE");
        comment("CANCEL WORK OFFSETS AND DIAMETER PROGRAMMING FIRST");
        comment("DWELL " + toText(m_plan.dwellSeconds) + " S AT EACH TARGET");
    }
    void move(double position)
    {
        m_text +=
            "G1 " + m_axis + planPosition(position) + " F" + toText(m_plan.feedPerMinute) + "\n";
    }

    const MeasuringPlan& m_plan;
    GcodeDialect m_dialect;
    DialectWords m_words;
    std::string m_axis;
    std::string m_text;
};

} // namespace

std::span<const std::string_view> gcodeDialectNames()
{
    return dialectNames;
}

std::optional<GcodeDialect> gcodeDialectNamed(std::string_view name)
{
    const auto found = std::ranges::find(dialectNames, name);
    if (found == dialectNames.end())
        return std::nullopt;
    return static_cast<GcodeDialect>(found - dialectNames.begin());
}

std::string_view gcodeExtension(GcodeDialect dialect)
{
    constexpr std::array<std::string_view, 3> extensions{".ngc", ".nc", ".mpf"};
    return extensions.at(static_cast<std::size_t>(dialect));
}

bool isProgramFile(const std::filesystem::path& file)
{
    constexpr std::array<std::string_view, 5> extensions{".ngc", ".nc", ".mpf", ".tap", ".gcode"};
    const std::string extension = file.extension().string();
    return std::ranges::any_of(
        extensions, [&](std::string_view known) { return sameLetters(extension, known); });
}

Result<std::string> gcodeProgram(const MeasuringPlan& plan, GcodeDialect dialect)
{
    std::string axis = axisWord(plan.axis, dialect);
    if (axis.empty())
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "a program for {dialect} cannot move an axis \"{axis}\"; name one of X, Y, Z, "
                    "A, B, C, U, V, W (--axis)")
                    .with("dialect", dialectNames[static_cast<std::size_t>(dialect)])
                    .with("axis", plan.axis)}});
    return ProgramWriter(plan, dialect, std::move(axis)).write();
}

} // namespace axiscomp
