// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/acs/acs_blocks.h"
#include "core/formats/format_reader.h"
#include "core/formats/format_writer.h"
#include "core/text/token_scanner.h"

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <map>
#include <span>

namespace axiscomp::acs {

// Error maps of an ACS SPiiPlus are program text (ACSPL+): statements fill an array, and one maps
// it to an axis. A saved program holds several buffers and much else.

/// A statement that maps an array, or has to do with it.
struct Call {
    enum class Kind {
        ErrorMap, ///< ERRORMAP1D axis, zone, base, step, array
        SwitchOn, ///< ERRORMAPON axis, zone
        SwitchOff, ///< ERRORMAPOFF or ERRORUNMAP axis, zone
        Map, ///< CONNECT RPOS(a) = APOS(a) + MAP(..)
        Map2, ///< the same with MAP2(..)
        Disconnect, ///< CONNECT RPOS(a) = .. without a map, or MFLAGS(a).17 = 1
        Unsupported, ///< a command or a function for maps that is not read
    };
    Kind kind = Kind::Unsupported;
    Token statement;
    Token name; ///< the command or the function
    /// Of a command: its arguments. Of a CONNECT: the axis of RPOS, that of the APOS to which is
    /// added, and the arguments of the function. Of Disconnect: the axis. Empty: the statement has
    /// another form.
    std::vector<Token> arguments;
    std::size_t buffer = 0;
    std::size_t section = 0; ///< see Program
    std::size_t loop = Blocks::none; ///< the outermost one that it stands in
    std::size_t number = 0; ///< counts all statements of the file
};

/// The elements that a program gives an array: all of them from 0 to the highest index.
struct Elements {
    std::array<std::size_t, 2> counts{1, 1}; ///< of the first and of the second index
    std::vector<double> values; ///< the second index fastest
};

/// What a program says, as far as it matters for error maps; everything else is passed over. A
/// section is what runs in the order of the text: a buffer, a subroutine or an ON routine.
class Program {
public:
    /// Comments on lines of their own become notes. False: stopped.
    [[nodiscard]] bool read(const TextReading& reading, std::vector<std::string>& notes);
    [[nodiscard]] const std::vector<Call>& calls() const { return m_calls; }

    /// What an argument of a call stands for: a number, or a name that got one before. Nothing: an
    /// error that names it.
    [[nodiscard]] std::optional<double> number(
        const Call& call, const Token& argument, DiagnosticList& diagnostics) const;
    /// A number of an axis or a zone, from 0; also a name of AXISDEF.
    [[nodiscard]] std::optional<std::int64_t> index(
        const Call& call, const Token& argument, DiagnosticList& diagnostics) const;
    /// "0", or the name that AXISDEF gives the axis.
    [[nodiscard]] std::string axisName(std::int64_t axis) const;
    /// Whether the first arguments of a call are these numbers. One that it leaves out is any.
    [[nodiscard]] bool isOf(const Call& call, std::initializer_list<std::int64_t> numbers) const;
    /// The statement that ends what others begin: behind the last of these, in each buffer that has
    /// one. Null: none does.
    [[nodiscard]] const Call* endOf(const std::function<bool(const Call&)>& begins,
        const std::function<bool(const Call&)>& ends) const;

    /// Warns of names that get two numbers for one of these maps, which are read: of the names of
    /// others nobody knows yet what counts.
    void warnOfSecondNumbers(std::span<const Call* const> maps, DiagnosticList& diagnostics) const;

    /// Whether the name of an array is the same array at both calls, not one in each of two
    /// buffers.
    [[nodiscard]] bool isOneArray(const Call& call, const Call& other, const Token& array) const;
    /// indices: 1 or 2. Nothing: an error, such as a point that is missing.
    [[nodiscard]] std::optional<Elements> elements(const Call& call, const Token& array,
        std::size_t indices, DiagnosticList& diagnostics) const;

private:
    struct Assigned {
        std::array<std::optional<std::int64_t>, 2> index; ///< nothing: none, or no literal
        std::size_t indices = 0;
        std::optional<double> value; ///< nothing: no literal
        Token text; ///< the value, or the index when that is no literal
        std::size_t buffer = 0;
        std::size_t section = 0;
        std::size_t branch = Blocks::none; ///< the innermost one that it stands in
        std::size_t maps = 0; ///< before it
        std::size_t statement = 0;
    };
    /// What a name gets, as far as it matters at a call.
    struct Known {
        const Assigned* last = nullptr; ///< which counts; null: none
        const Assigned* again = nullptr; ///< a second number since the map before; null: none
        const Assigned* other = nullptr; ///< another one that may count as well; null: none
    };
    struct Declared {
        std::array<std::optional<double>, 2> sizes; ///< nothing: none, or no literal
        std::size_t indices = 0;
        bool isGlobal = false;
        bool isWhole = false; ///< INT
        std::size_t buffer = 0;
        Token name;
    };
    struct Variable {
        std::vector<Declared> declared;
        std::vector<Assigned> assigned;

        [[nodiscard]] bool isLocal(std::size_t buffer) const;
        [[nodiscard]] bool isSeen(std::size_t from, std::size_t to) const;
        [[nodiscard]] bool isWhole(std::size_t buffer) const;
    };
    /// The indices that the assignments and the declarations of an array make.
    struct Extent {
        std::array<std::size_t, 2> counts{1, 1};
        std::vector<const Assigned*> assigned;
    };

    void takeLine(const Token& line);
    void beginSection();
    [[nodiscard]] Token takeWord(const Token& statement);
    void takeStatement(const Token& statement, const Token& name);
    [[nodiscard]] bool takeAssignment(const Token& statement);
    void assign(const Token& name, Assigned assigned);
    [[nodiscard]] bool takeDeclaration(const Token& statement);
    void takeChange(const Token& statement);
    void takeAxisNames(const Token& statement);
    void takeCommand(const Token& statement, const Token& name);
    void takeConnect(const Token& statement);
    void takeFlags(const Token& statement);
    void takeDisconnect(const Token& statement, const Token& axis);
    [[nodiscard]] Call callOf(const Token& statement, const Token& name) const;
    [[nodiscard]] const Variable& variableOf(std::string_view name) const;
    [[nodiscard]] Known knownAt(const Call& call, const Token& name) const;
    [[nodiscard]] const Assigned* valueBefore(
        const Call& call, const Token& name, DiagnosticList& diagnostics) const;
    [[nodiscard]] std::optional<Extent> extentOf(const Call& call, const Token& array,
        std::size_t indices, DiagnosticList& diagnostics) const;
    [[nodiscard]] bool fitsDeclaration(const Call& call, const Token& array, const Extent& extent,
        std::size_t indices, DiagnosticList& diagnostics) const;

    std::map<std::string, Variable, std::less<>> m_variables; ///< by name in capital letters
    std::map<std::string, std::int64_t, std::less<>> m_axes; ///< of AXISDEF, as written
    std::vector<Call> m_calls;
    Blocks m_blocks;
    std::size_t m_buffer = 0;
    std::size_t m_section = 0;
    std::size_t m_maps = 0;
    std::size_t m_statements = 0;
    bool m_isEnded = false; ///< what follows runs only from a label or ON
};

/// A letter or underline, then letters, digits and underlines.
[[nodiscard]] bool isName(std::string_view text);

/// "APOS(0)": what stands in the brackets; empty: something else.
[[nodiscard]] Token axisOfPosition(const Token& argument);

/// Adds an error for a command that is not supported.
void refuseCommand(const Call& call, DiagnosticList& diagnostics);
/// Adds an error for a statement of another form than this one.
void refuseForm(const Call& call, const TextPattern& form, DiagnosticList& diagnostics);
/// Adds that the other format reads a map: a warning beside maps of the own, otherwise an error.
void pointTo(const FormatFacts& other, const Call& call, Text found, bool hasOwn,
    DiagnosticList& diagnostics);

/// Warns of a second map of an axis; line: of the first one.
void warnOfSecond(
    const Call& call, const std::string& axis, std::size_t line, DiagnosticList& diagnostics);

/// Certain when a program maps arrays in the ways of a format, and in none of the other's.
[[nodiscard]] Recognition recogniseProgram(std::string_view text,
    const std::vector<Call::Kind>& own, const std::vector<Call::Kind>& other);

/// The settings that both formats have for writing.
inline constexpr FormatSetting arrayName{.key = "name",
    .kind = FormatSetting::Kind::Text,
    .meaning =
        AXISCOMP_TEXT("Error", "name of the array: a letter, then letters, digits and underlines"),
    .standard = "ERRORMAP",
    .forWriting = true};
inline constexpr FormatSetting declaresArray{.key = "declare",
    .kind = FormatSetting::Kind::YesNo,
    .meaning = AXISCOMP_TEXT(
        "Error", "the program declares the array; no where the controller has it already"),
    .standard = "yes",
    .forWriting = true};

/// The name of the array. Errors: InvalidArgument for what is no name in a program.
[[nodiscard]] Result<std::string> nameOfArray(
    const FormatFacts& facts, const SettingValues& settings);
/// A setting that is a number from 0. Errors: InvalidArgument.
[[nodiscard]] Result<std::int64_t> numberFromZero(
    const FormatFacts& facts, const SettingValues& settings, std::string_view key);

/// "-66, 20": the first position and the distance.
[[nodiscard]] std::string gridArguments(const SourceAxis& axis);
/// The declaration, where it is wanted, and the elements. indices: 1, or 2 with that of the second
/// axis first.
[[nodiscard]] std::string arrayLines(
    const NeutralTable& table, const std::string& name, std::size_t indices, bool isDeclared);
/// What is to be known of both formats.
void remarkOnArray(const std::string& name, bool isDeclared, std::vector<Text>& remarks);

} // namespace axiscomp::acs
