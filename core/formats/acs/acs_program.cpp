// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/acs/acs_program.h"

#include "core/text/text_file.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace axiscomp::acs {

namespace {

bool isLetter(char c)
{
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
}
bool isNameCharacter(char c)
{
    return isLetter(c) || (c >= '0' && c <= '9');
}

/// Takes a statement apart from its beginning; blanks may stand between everything.
class Cursor {
public:
    explicit Cursor(const Token& text) : m_rest(trimmedToken(text)) { }

    [[nodiscard]] const Token& rest() const { return m_rest; }
    [[nodiscard]] bool atEnd() const { return m_rest.text.empty(); }
    /// A name; empty: there is none, and nothing is taken.
    Token name()
    {
        if (atEnd() || !isLetter(m_rest.text.front()))
            return {};
        std::size_t length = 1;
        while (length < m_rest.text.size() && isNameCharacter(m_rest.text[length]))
            ++length;
        return take(length);
    }
    bool is(std::string_view characters)
    {
        if (!m_rest.text.starts_with(characters))
            return false;
        take(characters.size());
        return true;
    }
    /// "(inner)": the inner, trimmed; nothing: there are no brackets, and nothing is taken.
    std::optional<Token> brackets()
    {
        if (atEnd() || m_rest.text.front() != '(')
            return std::nullopt;
        std::size_t depth = 0;
        for (std::size_t i = 0; i < m_rest.text.size(); ++i) {
            depth += m_rest.text[i] == '(' ? 1 : 0;
            depth -= m_rest.text[i] == ')' ? 1 : 0;
            if (depth > 0)
                continue;
            const Token inner = m_rest.part(1, i - 1);
            take(i + 1);
            return trimmedToken(inner);
        }
        return std::nullopt;
    }

private:
    Token take(std::size_t length)
    {
        const Token taken = m_rest.part(0, length);
        m_rest = trimmedToken(m_rest.part(length));
        return taken;
    }

    Token m_rest;
};

/// The pieces between the commas outside of brackets.
std::vector<Token> argumentsOf(const Token& text)
{
    std::vector<Token> arguments;
    std::size_t begin = 0;
    std::size_t depth = 0;
    for (std::size_t i = 0; i <= text.text.size(); ++i) {
        const char c = i < text.text.size() ? text.text[i] : ',';
        depth += c == '(' ? 1 : 0;
        depth -= c == ')' && depth > 0 ? 1 : 0;
        if (c != ',' || (depth > 0 && i < text.text.size()))
            continue;
        arguments.push_back(trimmedToken(text.part(begin, i - begin)));
        begin = i + 1;
    }
    return arguments;
}

/// A number with a sign, which may stand apart.
std::optional<double> literalOf(std::string_view text)
{
    if (text.empty() || (text.front() != '-' && text.front() != '+'))
        return numberOf(text);
    const std::string_view digits = trimmed(text.substr(1));
    if (digits.empty() || digits.front() == '-' || digits.front() == '+')
        return std::nullopt;
    const auto number = numberOf(digits);
    return number && text.front() == '-' && *number != 0.0 ? std::optional(-*number) : number;
}

std::optional<std::int64_t> wholeOf(double number)
{
    constexpr double most = 2147483647.0;
    const bool isIndex = number >= 0.0 && number <= most && number == std::floor(number);
    return isIndex ? std::optional(static_cast<std::int64_t>(number)) : std::nullopt;
}

/// The statements of a line: what stands between semicolons and before the comment. Both count as
/// text within quotation marks.
std::vector<Token> statementsOf(const Token& line)
{
    std::vector<Token> statements;
    std::size_t begin = 0;
    bool isQuoted = false;
    const std::string_view text = line.text;
    const auto add = [&](std::size_t end) {
        const Token piece = trimmedToken(line.part(begin, end - begin));
        if (piece)
            statements.push_back(piece);
        begin = end + 1;
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '"')
            isQuoted = !isQuoted;
        else if (text[i] == ';' && !isQuoted)
            add(i);
        else if (text[i] == '!' && !isQuoted) {
            add(i);
            return statements;
        }
    }
    add(text.size());
    return statements;
}

/// "#5" or "#A": what follows stands in a buffer of its own.
bool beginsBuffer(std::string_view line)
{
    const std::string_view name = line.substr(1, line.find_first_of(" \t", 1) - 1);
    return sameLetters(name, "A") || (wholeNumberOf(name) && name.front() != '-');
}

bool isCommand(std::string_view name)
{
    constexpr std::string_view prefix = "ERRORMAP";
    return (name.size() > prefix.size() && sameLetters(name.substr(0, prefix.size()), prefix))
        || sameLetters(name, "ERRORUNMAP");
}

/// What stands behind the word of a block and is a statement: not a condition.
Token behindWord(std::string_view word, const Token& rest)
{
    const auto is = [word](std::string_view name) { return sameLetters(word, name); };
    if (is("ELSE") || is("END") || is("BLOCK") || is("RET"))
        return rest;
    const std::size_t colon =
        is("CASE") || is("DEFAULT") ? rest.text.find(':') : std::string_view::npos;
    return colon == std::string_view::npos ? Token{} : trimmedToken(rest.part(colon + 1));
}

/// Commands and functions that change none of their arguments.
bool changesNothing(std::string_view word)
{
    constexpr std::array<std::string_view, 56> words{"ARC1", "ARC2", "ASSIGNMARK", "ASSIGNPEG",
        "ASSIGNPOUTS", "BPTP", "BREAK", "BSEG", "CALL", "COMMUT", "DEPENDS", "DISABLE", "DISP",
        "ECOUT", "ENABLE", "ENDS", "FCLEAR", "FOLLOW", "GO", "GOTO", "GROUP", "HALT", "HOME",
        "INTERRUPT", "JOG", "KILL", "LINE", "MPOINT", "MPTP", "MSEG", "PATH", "PAUSE", "PEG_I",
        "PEG_R", "POINT", "PTP", "PVSPLINE", "RESUME", "SAFETYCONF", "SAFETYGROUP", "SEND",
        "SETCONF", "SLAVE", "SPLIT", "START", "STARTPEG", "STOP", "STOPPEG", "STOPPER", "TILL",
        "TRACK", "TRIGGER", "UNFOLLOW", "WAIT", "WRITE", "XSEG"};
    return std::ranges::any_of(
        words, [word](std::string_view one) { return sameLetters(word, one); });
}

/// Whether what stands behind a name changes it: "+= 1", "++", ".3 = 1".
bool changesName(std::string_view rest)
{
    constexpr std::string_view operators = "+-*/%&|~^";
    return rest.starts_with('.') || rest.starts_with('=') || rest.starts_with("++")
        || rest.starts_with("--")
        || (rest.size() > 1 && rest[1] == '=' && operators.find(rest[0]) != operators.npos);
}

/// "XMAP", "XMAP(1)": the name; empty: an expression.
Token nameOf(const Token& argument)
{
    Cursor cursor(argument);
    const Token name = cursor.name();
    while (cursor.brackets())
        continue;
    return cursor.atEnd() ? name : Token{};
}

/// The functions MAP.. in an expression.
std::vector<Token> mapFunctions(const Token& expression)
{
    std::vector<Token> functions;
    for (Cursor cursor(expression); !cursor.atEnd();) {
        const Token name = cursor.name();
        if (!name)
            cursor.is(cursor.rest().text.substr(0, 1));
        else if (name.text.size() >= 3 && sameLetters(name.text.substr(0, 3), "MAP")
            && cursor.rest().text.starts_with('('))
            functions.push_back(name);
    }
    return functions;
}

} // namespace

bool isName(std::string_view text)
{
    return !text.empty() && isLetter(text.front()) && std::ranges::all_of(text, isNameCharacter);
}

bool Program::Variable::isLocal(std::size_t buffer) const
{
    return std::ranges::any_of(declared,
        [buffer](const Declared& said) { return said.buffer == buffer && !said.isGlobal; });
}

/// Whether the name means the same in both buffers.
bool Program::Variable::isSeen(std::size_t from, std::size_t to) const
{
    return from == to || (!isLocal(from) && !isLocal(to));
}

bool Program::Variable::isWhole(std::size_t buffer) const
{
    return std::ranges::any_of(declared,
        [&](const Declared& said) { return said.isWhole && isSeen(said.buffer, buffer); });
}

bool Program::read(const TextReading& reading, std::vector<std::string>& notes)
{
    TextLines lines(reading.text);
    while (const auto whole = lines.next()) {
        if (reading.isStopped())
            return false;
        const Token line = trimmedToken(*whole);
        if (line.text.starts_with('!'))
            keepNote(notes, line.text.substr(1));
        else
            takeLine(line);
    }
    return true;
}

void Program::takeLine(const Token& line)
{
    if (line.text.starts_with('#')) {
        if (beginsBuffer(line.text)) {
            ++m_buffer;
            m_blocks.close(m_statements + 1);
            beginSection();
        }
        return;
    }
    for (Token statement : statementsOf(line))
        while (statement)
            statement = takeWord(statement);
}

void Program::beginSection()
{
    ++m_section;
    m_isEnded = false;
}

/// Takes a label, or the word of a block; otherwise all of the statement. What is left behind it.
Token Program::takeWord(const Token& statement)
{
    ++m_statements;
    Cursor cursor(statement);
    const Token word = cursor.name();
    if (m_blocks.take(word.text, m_statements)) {
        if (sameLetters(word.text, "ON"))
            beginSection();
        const bool isReturn = sameLetters(word.text, "RET") && !m_blocks.isInside();
        m_isEnded = m_isEnded || isReturn;
        return behindWord(word.text, cursor.rest());
    }
    if (word && cursor.is(":")) {
        if (m_isEnded)
            beginSection();
        return cursor.rest();
    }
    takeStatement(statement, word);
    const bool isJump = sameLetters(word.text, "GOTO")
        || (sameLetters(word.text, "STOP") && cursor.atEnd()); // STOP 8 stops another buffer
    m_isEnded = m_isEnded || (isJump && !m_blocks.isInside());
    return {};
}

void Program::takeStatement(const Token& statement, const Token& name)
{
    if (takeAssignment(statement) || takeDeclaration(statement))
        return;
    if (sameLetters(name.text, "AXISDEF"))
        takeAxisNames(statement);
    else if (sameLetters(name.text, "CONNECT"))
        takeConnect(statement);
    else if (sameLetters(name.text, "MFLAGS"))
        takeFlags(statement);
    else if (isCommand(name.text))
        takeCommand(statement, name);
    else
        takeChange(statement);
}

/// "COPY(YMAP, XMAP)", "READ XMAP", "XMAP(1) += 7": any other statement may change what stands to
/// its left, and its arguments.
void Program::takeChange(const Token& statement)
{
    Cursor cursor(statement);
    const bool isPrefixed = cursor.is("++") || cursor.is("--");
    const Token word = cursor.name();
    std::vector<Token> arguments;
    const auto add = [&arguments](const Token& text) {
        const std::vector<Token> more = argumentsOf(text);
        arguments.insert(arguments.end(), more.begin(), more.end());
    };
    while (const auto inner = cursor.brackets())
        add(*inner);
    Assigned changed;
    changed.text = statement;
    if (isPrefixed || changesName(cursor.rest().text)) {
        assign(word, changed);
        return;
    }
    if (changesNothing(word.text))
        return;
    while (cursor.is("/"))
        cursor.name(); // DC/c
    add(cursor.rest());
    for (const Token& argument : arguments)
        if (const Token name = nameOf(argument))
            assign(name, changed);
}

void Program::assign(const Token& name, Assigned assigned)
{
    assigned.buffer = m_buffer;
    assigned.section = m_section;
    assigned.branch = m_blocks.branch();
    assigned.maps = m_maps;
    assigned.statement = m_statements;
    m_variables[capitals(name.text)].assigned.push_back(assigned);
}

bool Program::takeAssignment(const Token& statement)
{
    Cursor cursor(statement);
    const Token name = cursor.name();
    if (!name)
        return false;
    Assigned assigned;
    std::array<Token, 2> indices;
    while (auto inner = cursor.brackets()) {
        if (assigned.indices == indices.size())
            return true; // an array that no map takes
        indices[assigned.indices++] = *inner;
    }
    if (!cursor.is("=") || cursor.rest().text.starts_with('='))
        return false;
    assigned.text = cursor.rest();
    assigned.value = literalOf(assigned.text.text);
    for (std::size_t n = 0; n < assigned.indices; ++n) {
        const auto literal = literalOf(indices[n].text);
        assigned.index[n] = literal ? wholeOf(*literal) : std::nullopt;
        if (!assigned.index[n])
            assigned.text = indices[n];
    }
    assign(name, assigned);
    return true;
}

bool Program::takeDeclaration(const Token& statement)
{
    Cursor cursor(statement);
    Declared declared;
    declared.buffer = m_buffer;
    bool hasKind = false;
    Token name = cursor.name();
    for (;; name = cursor.name()) {
        declared.isGlobal = declared.isGlobal || sameLetters(name.text, "GLOBAL");
        declared.isWhole = declared.isWhole || sameLetters(name.text, "INT");
        const bool isKind = sameLetters(name.text, "INT") || sameLetters(name.text, "REAL");
        hasKind = hasKind || isKind;
        if (!isKind && !sameLetters(name.text, "GLOBAL") && !sameLetters(name.text, "LOCAL")
            && !sameLetters(name.text, "STATIC"))
            break;
    }
    if (!hasKind)
        return false;
    for (; name; name = cursor.name()) {
        declared.name = name;
        declared.indices = 0;
        declared.sizes = {};
        while (const auto inner = cursor.brackets()) {
            if (declared.indices < declared.sizes.size())
                declared.sizes[declared.indices] = literalOf(inner->text);
            ++declared.indices;
        }
        m_variables[capitals(name.text)].declared.push_back(declared);
        if (!cursor.is(","))
            break;
    }
    return true;
}

/// "AXISDEF X=0, Y=1"
void Program::takeAxisNames(const Token& statement)
{
    Cursor cursor(statement);
    cursor.name();
    for (const Token& argument : argumentsOf(cursor.rest())) {
        Cursor pair(argument);
        const Token name = pair.name();
        if (!name || !pair.is("="))
            continue;
        if (const auto axis = wholeNumberOf(pair.rest().text))
            m_axes[std::string(name.text)] = *axis;
    }
}

Call Program::callOf(const Token& statement, const Token& name) const
{
    Call call;
    call.statement = statement;
    call.name = name;
    call.buffer = m_buffer;
    call.section = m_section;
    call.loop = m_blocks.loop();
    call.number = m_statements;
    return call;
}

void Program::takeCommand(const Token& statement, const Token& name)
{
    Call call = callOf(statement, name);
    if (sameLetters(name.text, "ERRORMAP1D"))
        call.kind = Call::Kind::ErrorMap;
    else if (sameLetters(name.text, "ERRORMAPON"))
        call.kind = Call::Kind::SwitchOn;
    else if (sameLetters(name.text, "ERRORMAPOFF") || sameLetters(name.text, "ERRORUNMAP"))
        call.kind = Call::Kind::SwitchOff;
    Cursor cursor(statement);
    cursor.name();
    call.arguments = argumentsOf(cursor.rest());
    if (call.kind == Call::Kind::ErrorMap && call.arguments.size() != 5)
        call.arguments.clear();
    m_maps += call.kind == Call::Kind::ErrorMap ? 1 : 0;
    m_calls.push_back(std::move(call));
}

/// "MFLAGS(0).17 = 1", "MFLAGS(0).#DEFCON = 1": the position has no connection of the program's
/// any more.
void Program::takeFlags(const Token& statement)
{
    Cursor cursor(statement);
    cursor.name();
    const auto axis = cursor.brackets();
    const bool isConnection = axis
        && (cursor.is(".17") || (cursor.is(".#") && sameLetters(cursor.name().text, "DEFCON")));
    if (isConnection && cursor.is("=") && literalOf(cursor.rest().text) == 1.0)
        takeDisconnect(statement, *axis);
}

void Program::takeDisconnect(const Token& statement, const Token& axis)
{
    Call call = callOf(statement, Cursor(statement).name());
    call.kind = Call::Kind::Disconnect;
    call.arguments = {axis};
    m_calls.push_back(std::move(call));
}

/// Of other connections than those by maps it matters only that they replace one.
void Program::takeConnect(const Token& statement)
{
    Cursor cursor(statement);
    cursor.name();
    if (!sameLetters(cursor.name().text, "RPOS"))
        return;
    const auto target = cursor.brackets();
    if (!target || !cursor.is("="))
        return;
    const std::vector<Token> functions = mapFunctions(cursor.rest());
    if (functions.empty()) {
        takeDisconnect(statement, *target);
        return;
    }
    Call call = callOf(statement, functions.front());
    if (sameLetters(call.name.text, "MAP"))
        call.kind = Call::Kind::Map;
    else if (sameLetters(call.name.text, "MAP2"))
        call.kind = Call::Kind::Map2;
    const bool addsToPosition = sameLetters(cursor.name().text, "APOS");
    const auto added = addsToPosition ? cursor.brackets() : std::nullopt;
    const bool isSum = added && cursor.is("+") && sameLetters(cursor.name().text, call.name.text);
    const auto inner = isSum ? cursor.brackets() : std::nullopt;
    if (inner && cursor.atEnd()) {
        call.arguments = argumentsOf(*inner);
        call.arguments.insert(call.arguments.begin(), {*target, *added});
    }
    ++m_maps;
    m_calls.push_back(std::move(call));
}

const Program::Variable& Program::variableOf(std::string_view name) const
{
    static const Variable unknown{};
    const auto found = m_variables.find(capitals(name));
    return found == m_variables.end() ? unknown : found->second;
}

/// The last assignment to a plain name before the call in its section, or else that of the others,
/// whose order nobody knows, so that they must be the same.
Program::Known Program::knownAt(const Call& call, const Token& name) const
{
    Known known;
    const Assigned* elsewhere = nullptr;
    const Assigned* otherElsewhere = nullptr;
    const Assigned* later = nullptr;
    const Variable& variable = variableOf(name.text);
    for (const Assigned& assigned : variable.assigned) {
        if (assigned.indices > 0 || !variable.isSeen(assigned.buffer, call.buffer))
            continue;
        if (assigned.section != call.section) {
            otherElsewhere =
                elsewhere && elsewhere->value != assigned.value ? &assigned : otherElsewhere;
            elsewhere = &assigned;
        } else if (assigned.statement < call.number) {
            if (known.last && known.last->maps != assigned.maps)
                known.again = nullptr; // the one before is that of another map
            else if (known.last && known.last->value != assigned.value)
                known.again = &assigned;
            known.last = &assigned;
        } else if (call.loop != Blocks::none && m_blocks.isWithin(call.loop, assigned.statement)) {
            later = &assigned;
        }
    }
    if (!known.last) {
        known.last = elsewhere;
        known.other = otherElsewhere;
    }
    if (known.last && later && later->value != known.last->value)
        known.other = later;
    return known;
}

/// The assignment that counts for a plain name at a call.
const Program::Assigned* Program::valueBefore(
    const Call& call, const Token& name, DiagnosticList& diagnostics) const
{
    const Known known = knownAt(call, name);
    const Assigned* const last = known.last;
    const Assigned* const other = known.other;
    const auto refuse = [&](Text expected) -> const Assigned* {
        diagnostics.error(
            DiagnosticCode::NotANumber, name.line, name.column, quoted(name), std::move(expected));
        return nullptr;
    };
    if (!last)
        return refuse(AXISCOMP_TEXT("Error", "a number, or a name that got one before"));
    if (other)
        return refuse((other->section == call.section
                ? AXISCOMP_TEXT("Error",
                    "one number; line {line} gives it another one for the next pass of the loop")
                : other->buffer == call.buffer
                ? AXISCOMP_TEXT("Error",
                    "one number; another part of the program gives it another one in line {line}")
                : AXISCOMP_TEXT(
                    "Error", "one number; other buffers give it another one in line {line}"))
                          .with("line", other->text.line));
    if (!last->value)
        return refuse(AXISCOMP_TEXT("Error",
            "a name that got a number; in line {line} it gets something that is not computed here")
                          .with("line", last->text.line));
    if (!m_blocks.isWithin(last->branch, call.number))
        return refuse(AXISCOMP_TEXT("Error",
            "a name that got a number outside of IF, ELSE, SWITCH, LOOP, WHILE and ON; only the "
            "controller knows whether that of line {line} counts")
                          .with("line", last->text.line));
    if (variableOf(name.text).isWhole(call.buffer) && *last->value != std::floor(*last->value))
        return refuse(AXISCOMP_TEXT(
            "Error", "a whole number, since it is declared INT; in line {line} it gets another one")
                          .with("line", last->text.line));
    return last;
}

void Program::warnOfSecondNumbers(
    std::span<const Call* const> maps, DiagnosticList& diagnostics) const
{
    const auto isOfElement = [](const Assigned& assigned) { return assigned.indices > 0; };
    std::set<const Assigned*> named;
    for (const Call* const call : maps) {
        for (const Token& argument : call->arguments) {
            const Token position = axisOfPosition(argument);
            const Token& name = position ? position : argument;
            const bool isArray = std::ranges::any_of(variableOf(name.text).assigned, isOfElement);
            const Assigned* const again = isArray ? nullptr : knownAt(*call, name).again;
            if (!again || !named.insert(again).second)
                continue;
            diagnostics.warning(DiagnosticCode::DuplicateValue, again->text.line,
                again->text.column,
                AXISCOMP_TEXT("Error", "{what} a second time").with("what", quoted(name)),
                AXISCOMP_TEXT("Error", "each value once; the last one counts"));
        }
    }
}

std::optional<double> Program::number(
    const Call& call, const Token& argument, DiagnosticList& diagnostics) const
{
    if (const auto literal = literalOf(argument.text))
        return literal;
    if (isName(argument.text)) {
        const Assigned* const assigned = valueBefore(call, argument, diagnostics);
        return assigned ? assigned->value : std::nullopt;
    }
    diagnostics.error(DiagnosticCode::NotANumber, argument.line, argument.column, quoted(argument),
        AXISCOMP_TEXT("Error",
            "a number with a decimal point, or a name that got one; expressions are not computed"));
    return std::nullopt;
}

std::optional<std::int64_t> Program::index(
    const Call& call, const Token& argument, DiagnosticList& diagnostics) const
{
    for (const auto& [name, axis] : m_axes)
        if (sameLetters(name, argument.text))
            return axis;
    const auto value = number(call, argument, diagnostics);
    const auto whole = value ? wholeOf(*value) : std::nullopt;
    if (value && !whole)
        diagnostics.error(DiagnosticCode::LimitExceeded, argument.line, argument.column,
            quoted(argument), AXISCOMP_TEXT("Error", "a whole number from 0"));
    return whole;
}

std::string Program::axisName(std::int64_t axis) const
{
    for (const auto& [name, number] : m_axes)
        if (number == axis)
            return name;
    return std::to_string(axis);
}

bool Program::isOf(const Call& call, std::initializer_list<std::int64_t> numbers) const
{
    DiagnosticList ignored(0);
    std::size_t n = 0;
    for (const std::int64_t number : numbers) {
        if (n < call.arguments.size() && index(call, call.arguments[n], ignored) != number)
            return false;
        ++n;
    }
    return !call.arguments.empty();
}

const Call* Program::endOf(const std::function<bool(const Call&)>& begins,
    const std::function<bool(const Call&)>& ends) const
{
    std::map<std::size_t, const Call*> latest; // of each buffer that begins it; null: it has no end
    for (const Call& call : m_calls) {
        const auto found = latest.find(call.buffer);
        if (begins(call))
            latest[call.buffer] = nullptr;
        else if (found != latest.end() && !found->second && ends(call))
            found->second = &call;
    }
    const bool isEnded =
        std::ranges::all_of(latest, [](const auto& buffer) { return buffer.second != nullptr; });
    return isEnded && !latest.empty() ? latest.begin()->second : nullptr;
}

bool Program::isOneArray(const Call& call, const Call& other, const Token& array) const
{
    return variableOf(array.text).isSeen(call.buffer, other.buffer);
}

/// What is assigned to an array; nothing: an error.
std::optional<Program::Extent> Program::extentOf(
    const Call& call, const Token& array, std::size_t indices, DiagnosticList& diagnostics) const
{
    Extent extent;
    const Variable& variable = variableOf(array.text);
    const bool isWhole = variable.isWhole(call.buffer);
    bool isGood = true;
    for (const Assigned& assigned : variable.assigned) {
        const bool isOfElement = assigned.indices > 0;
        // What is assigned to the whole array before its elements, they replace.
        if (!variable.isSeen(assigned.buffer, call.buffer)
            || (!isOfElement && extent.assigned.empty()))
            continue;
        const auto refuse = [&](DiagnosticCode code, Text expected) {
            isGood = false;
            diagnostics.error(code, assigned.text.line, assigned.text.column, quoted(assigned.text),
                std::move(expected));
        };
        if (!isOfElement)
            refuse(DiagnosticCode::NotANumber,
                AXISCOMP_TEXT("Error",
                    "numbers for the elements of {name} alone; what else changes the array behind "
                    "them is not computed")
                    .with("name", quoted(array)));
        else if (assigned.indices != indices)
            refuse(DiagnosticCode::Syntax,
                indices == 1
                    ? AXISCOMP_TEXT("Error", "one index of {name}").with("name", quoted(array))
                    : AXISCOMP_TEXT("Error", "two indices of {name}").with("name", quoted(array)));
        else if (!assigned.index[0] || (indices == 2 && !assigned.index[1]))
            refuse(DiagnosticCode::NotANumber,
                AXISCOMP_TEXT("Error", "an index of {name}: a whole number from 0")
                    .with("name", quoted(array)));
        else if (!assigned.value)
            refuse(DiagnosticCode::NotANumber,
                AXISCOMP_TEXT(
                    "Error", "a number with a decimal point; expressions are not computed"));
        else if (!m_blocks.isWithin(assigned.branch, call.number))
            refuse(DiagnosticCode::Syntax,
                AXISCOMP_TEXT("Error",
                    "a number outside of IF, ELSE, SWITCH, LOOP, WHILE and ON; only the controller "
                    "knows whether this one counts"));
        else if (isWhole && *assigned.value != std::floor(*assigned.value))
            refuse(DiagnosticCode::Contradiction,
                AXISCOMP_TEXT("Error", "a whole number, since {name} is declared INT")
                    .with("name", quoted(array)));
        else
            extent.assigned.push_back(&assigned);
        for (std::size_t n = 0; isGood && n < indices; ++n)
            extent.counts[n] = std::max(
                extent.counts[n], static_cast<std::size_t>(assigned.index[n].value_or(0)) + 1);
    }
    if (extent.assigned.empty() && isGood)
        diagnostics.error(DiagnosticCode::Syntax, array.line, array.column, quoted(array),
            AXISCOMP_TEXT("Error", "an array whose elements are numbers in this program"));
    if (!isGood || extent.assigned.empty())
        return std::nullopt;
    return extent;
}

/// Of each declaration that the call sees. An array that is larger than what it gets is a warning.
bool Program::fitsDeclaration(const Call& call, const Token& array, const Extent& extent,
    std::size_t indices, DiagnosticList& diagnostics) const
{
    const auto sizesText = [&](const auto& sizeOf) {
        std::string text = quoted(array).text;
        for (std::size_t n = 0; n < indices; ++n)
            text += '(' + std::to_string(static_cast<long long>(sizeOf(n))) + ')';
        return text;
    };
    bool isWarned = false;
    const Variable& variable = variableOf(array.text);
    for (const Declared& said : variable.declared) {
        if (!variable.isSeen(said.buffer, call.buffer))
            continue;
        bool isKnown = said.indices == indices;
        for (std::size_t n = 0; n < std::min(said.indices, indices); ++n)
            isKnown = isKnown && said.sizes[n].has_value() && std::abs(*said.sizes[n]) < 1e9;
        if (!isKnown && said.indices == indices)
            continue; // a size that a name says
        const auto size = [&](std::size_t n) { return *said.sizes[n]; };
        const auto count = [&](std::size_t n) { return static_cast<double>(extent.counts[n]); };
        bool isShort = !isKnown;
        bool isLong = false;
        for (std::size_t n = 0; isKnown && n < indices; ++n) {
            isShort = isShort || size(n) < count(n);
            isLong = isLong || size(n) > count(n);
        }
        if (isShort) {
            diagnostics.error(DiagnosticCode::Contradiction, said.name.line, said.name.column,
                isKnown ? Text(Verbatim{sizesText(size)})
                        : AXISCOMP_TEXT("Error", "{name} with another number of indices")
                              .with("name", quoted(array)),
                AXISCOMP_TEXT("Error", "{sizes}, which its elements need")
                    .with("sizes", sizesText(count)));
            return false;
        }
        if (isLong && !std::exchange(isWarned, true))
            diagnostics.warning(DiagnosticCode::Assumption, said.name.line, said.name.column,
                AXISCOMP_TEXT("Error", "{array} with elements for {sizes}")
                    .with("array", sizesText(size))
                    .with("sizes", sizesText(count)),
                AXISCOMP_TEXT("Error",
                    "a value for each element; the table has those that the program gives, and "
                    "the controller may use the others as they are"));
    }
    return true;
}

std::optional<Elements> Program::elements(
    const Call& call, const Token& array, std::size_t indices, DiagnosticList& diagnostics) const
{
    const auto extent = extentOf(call, array, indices, diagnostics);
    if (!extent || !fitsDeclaration(call, array, *extent, indices, diagnostics))
        return std::nullopt;
    Elements elements{extent->counts, {}};
    const double all =
        static_cast<double>(elements.counts[0]) * static_cast<double>(elements.counts[1]);
    // No more than the file has is ever allocated: one of the first elements is missing then.
    const auto size =
        static_cast<std::size_t>(std::min(all, static_cast<double>(extent->assigned.size() + 1)));
    std::vector<bool> seen(size, false);
    elements.values.resize(size);
    const auto textOf = [&](std::size_t place) {
        std::string text = quoted(array).text;
        if (indices == 2)
            text += '(' + std::to_string(place / elements.counts[1]) + ')';
        return text + '(' + std::to_string(indices == 2 ? place % elements.counts[1] : place) + ')';
    };
    const Assigned* again = nullptr;
    std::size_t againAt = 0;
    for (const Assigned* assigned : extent->assigned) {
        const double exact = indices == 1
            ? static_cast<double>(*assigned->index[0])
            : static_cast<double>(*assigned->index[0]) * static_cast<double>(elements.counts[1])
                + static_cast<double>(*assigned->index[1]);
        if (!(exact < static_cast<double>(size)))
            continue;
        const auto place = static_cast<std::size_t>(exact);
        if (seen[place] && !again) {
            again = assigned;
            againAt = place;
        }
        seen[place] = true;
        elements.values[place] = *assigned->value == 0.0 ? 0.0 : *assigned->value; // no -0
    }
    const auto hole = std::ranges::find(seen, false);
    if (hole != seen.end()) {
        diagnostics.error(DiagnosticCode::MissingPoint, array.line, array.column,
            AXISCOMP_TEXT("Error", "no {element}")
                .with("element", textOf(static_cast<std::size_t>(hole - seen.begin()))),
            AXISCOMP_TEXT("Error", "a number for each element up to the highest index"));
        return std::nullopt;
    }
    if (again)
        diagnostics.warning(DiagnosticCode::DuplicatePoint, again->text.line, again->text.column,
            AXISCOMP_TEXT("Error", "{element} a second time").with("element", textOf(againAt)),
            AXISCOMP_TEXT("Error", "each element once; the last number counts"));
    return elements;
}

Token axisOfPosition(const Token& argument)
{
    Cursor cursor(argument);
    if (!sameLetters(cursor.name().text, "APOS"))
        return {};
    const auto axis = cursor.brackets();
    return axis && cursor.atEnd() ? *axis : Token{};
}

void refuseCommand(const Call& call, DiagnosticList& diagnostics)
{
    diagnostics.error(DiagnosticCode::Syntax, call.name.line, call.name.column,
        AXISCOMP_TEXT("Error", "{name}, which is not supported")
            .with("name", capitals(quoted(call.name).text)),
        AXISCOMP_TEXT("Error", "ERRORMAP1D, or CONNECT with MAP or MAP2"));
}

void refuseForm(const Call& call, const TextPattern& form, DiagnosticList& diagnostics)
{
    diagnostics.error(DiagnosticCode::Syntax, call.statement.line, call.statement.column,
        quoted(call.statement), form);
}

void pointTo(const FormatFacts& other, const Call& call, Text found, bool hasOwn,
    DiagnosticList& diagnostics)
{
    Text expected =
        AXISCOMP_TEXT("Error", "the format {format} to read it").with("format", other.name);
    if (hasOwn)
        diagnostics.warning(DiagnosticCode::LeftOut, call.name.line, call.name.column,
            std::move(found), std::move(expected));
    else
        diagnostics.error(DiagnosticCode::Syntax, call.name.line, call.name.column,
            std::move(found), std::move(expected));
}

void warnOfSecond(
    const Call& call, const std::string& axis, std::size_t line, DiagnosticList& diagnostics)
{
    diagnostics.warning(DiagnosticCode::Assumption, call.statement.line, call.statement.column,
        AXISCOMP_TEXT("Error", "another map of axis {axis}, besides that of line {line}")
            .with("axis", axis)
            .with("line", line),
        AXISCOMP_TEXT("Error",
            "one map of an axis; both are read, and the program decides which one counts"));
}

Recognition recogniseProgram(
    std::string_view text, const std::vector<Call::Kind>& own, const std::vector<Call::Kind>& other)
{
    TableReadOptions options;
    DiagnosticList diagnostics(0);
    static const SettingValues none{};
    std::vector<std::string> notes;
    Program program;
    if (!program.read({text, options, none, diagnostics}, notes))
        return Recognition::No;
    const auto hasOneOf = [&](const std::vector<Call::Kind>& kinds) {
        return std::ranges::any_of(program.calls(),
            [&](const Call& call) { return std::ranges::find(kinds, call.kind) != kinds.end(); });
    };
    if (!hasOneOf(own))
        return Recognition::No;
    return hasOneOf(other) ? Recognition::Possible : Recognition::Certain;
}

} // namespace axiscomp::acs
