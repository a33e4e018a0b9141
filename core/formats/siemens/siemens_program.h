// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/format_reader.h"
#include "core/formats/format_writer.h"
#include "core/text/token_scanner.h"

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <map>

namespace axiscomp::siemens {

// Compensation files of SINUMERIK are part programs that assign system variables:
// "$AA_ENC_COMP[0,3,X1]=0.012 ; +12 um", between CHANDATA(1) and M17.

/// "$NAME[argument, argument]=value"
struct Assignment {
    Token name; ///< with its '$'
    std::vector<Token> arguments;
    Token value; ///< without the brackets or quotation marks of an axis name
};

/// What a variable that is true or false is set to: 1, 0, TRUE or FALSE; nothing: to something
/// else.
[[nodiscard]] std::optional<bool> yesOrNo(std::string_view value);

/// What switches tables on: "$SN_CEC_TABLE_ENABLE[0]=1". The last one counts, since a program may
/// switch a table off while it is loaded.
class Switches {
public:
    /// False: not of this name, or of another number of arguments.
    [[nodiscard]] bool take(
        const Assignment& said, std::string_view name, std::size_t argumentCount);
    /// Warns where a table is switched off; the same for a switch that was looked at before.
    void check(std::string_view name, std::initializer_list<std::string_view> arguments,
        DiagnosticList& diagnostics);
    /// Names what switches off something else than a table of the file.
    void reportOthers(DiagnosticList& diagnostics) const;

private:
    struct Switch {
        Token statement;
        Token name;
        bool isOff = false;
        bool isOfTable = false;
    };
    std::map<std::string, Switch> m_switches; ///< by name and arguments in capital letters
};

/// Calls visit for each assignment of the program; anything else is a problem. Comments become
/// notes. False: stopped.
[[nodiscard]] bool readProgram(const TextReading& reading, std::vector<std::string>& notes,
    const std::function<void(const Assignment&)>& visit);

/// Certain when the program assigns variables of this name and none of the other format.
[[nodiscard]] Recognition recogniseProgram(
    std::string_view text, std::string_view own, std::string_view other);

/// One table of a file as its variables say it.
struct Curve {
    enum Variable { Step, Min, Max, IsModulo, Direction, MultBy, variableCount };

    Text label; ///< for problems: "axis X1, encoder 0"
    std::string prefix; ///< of its variables: "$AA_ENC_COMP"
    std::array<std::optional<double>, variableCount> variables = {};
    std::array<std::size_t, variableCount> lines = {};
    struct Point {
        std::int64_t index = 0;
        double value = 0.0;
        std::size_t line = 0;
        std::size_t column = 0;
    };
    std::vector<Point> points;

    [[nodiscard]] double value(Variable variable) const
    {
        return variables[variable].value_or(0.0);
    }
};
inline constexpr std::string_view variableNames[] = {
    "_STEP", "_MIN", "_MAX", "_IS_MODULO", "_DIRECTION", "_MULT_BY_TABLE"};

/// Which of the variables a name means, behind the prefix; variableCount: none.
[[nodiscard]] Curve::Variable variableOf(std::string_view suffix);
/// Keeps the value of a variable; a second one is a contradiction.
void setVariable(
    Curve& curve, Curve::Variable variable, const Assignment& said, DiagnosticList& diagnostics);
void addPoint(Curve& curve, const Token& index, const Token& value, DiagnosticList& diagnostics);

/// Axis and values of a curve; errors for what is missing or does not fit.
struct Sampled {
    SourceAxis axis; ///< without name and unit
    std::vector<double> values;
};
[[nodiscard]] std::optional<Sampled> sample(const Curve& curve, DiagnosticList& diagnostics);

/// The axes that are said to be rotary, in degrees.
inline constexpr FormatSetting rotaryAxes{.key = "rotary-axes",
    .kind = FormatSetting::Kind::Text,
    .meaning = AXISCOMP_TEXT("Error",
        "names of the axes in degrees, such as C,B; all others are in mm, and modulo axes "
        "in degrees anyway"),
    .forReading = true};
/// "deg" or "mm".
[[nodiscard]] std::string unitOf(
    const SettingValues& settings, const std::string& axis, bool isModulo);

/// The name of an axis in a program: the setting, or the table's name for it. Errors:
/// InvalidArgument for what is no name.
[[nodiscard]] Result<std::string> axisName(const FormatFacts& facts, const SettingValues& settings,
    std::string_view key, const std::string& name);

/// "$AN_CEC_STEP[0]=1" and the others of an axis. subject: what stands in the brackets.
[[nodiscard]] std::string gridLines(
    const SourceAxis& axis, std::string_view prefix, std::string_view subject);
/// What a modulo axis must be: rotary, one period, closed. Errors: FormatCannotHold.
[[nodiscard]] Result<void> checkModulo(const FormatFacts& facts, const NeutralTable& table);

} // namespace axiscomp::siemens
