// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output/environment.h"

#include "app/cli/output/json_output.h"

#include <sstream>
#include <utility>

namespace axiscomp::app {

namespace {

std::string placeOf(const std::string& file, std::size_t line, std::size_t column)
{
    std::string place = file;
    if (line > 0)
        place += ":" + std::to_string(line);
    if (line > 0 && column > 0)
        place += ":" + std::to_string(column);
    return place;
}

} // namespace

Environment::Environment(Console& console, Interrupt& interrupt, bool json)
    : m_console(console)
    , m_interrupt(interrupt)
    , m_json(json)
{
}

Environment::Environment(Console& console, Interrupt& interrupt, Taker documents, Taker readings)
    : m_console(console)
    , m_interrupt(interrupt)
    , m_documents(std::move(documents))
    , m_readings(std::move(readings))
{
}

void Environment::print(std::string_view text)
{
    if (!m_json)
        m_console.print(text);
}

void Environment::report(std::string_view text)
{
    m_reports += text;
    print(text);
}

void Environment::noteReports()
{
    std::istringstream lines(std::exchange(m_reports, {}));
    for (std::string line; std::getline(lines, line);)
        if (!line.empty())
            m_console.note("note: " + line);
}

std::string Environment::nameOf(const std::string& file) const
{
    const auto found = m_names.find(file);
    return found == m_names.end() ? file : found->second;
}

void Environment::document(const Json& json)
{
    if (m_documents)
        m_documents(json);
    else if (m_json)
        m_console.print(dump(json));
}

void Environment::diagnose(const std::string& file, const std::vector<Diagnostic>& diagnostics)
{
    for (const Diagnostic& diagnostic : diagnostics) {
        const bool isError = diagnostic.severity == Severity::Error;
        m_console.note(placeOf(file, diagnostic.line, diagnostic.column)
            + (isError ? ": error: " : ": warning: ") + message(diagnostic));
        if (isError) {
            Json entry = toJson(diagnostic);
            entry["file"] = file;
            m_diagnostics.push_back(std::move(entry));
        }
    }
}

void Environment::diagnose(const std::string& file, std::size_t line, std::size_t column,
    const std::string& code, const std::string& what)
{
    m_console.note(placeOf(file, line, column) + ": error: " + what + " (" + code + ")");
    m_diagnostics.push_back(
        {{"code", code}, {"line", line}, {"column", column}, {"message", what}, {"file", file}});
}

void Environment::tell(const Error& error, const std::string& place)
{
    const std::string said = place.empty() ? sentence(error) : place + ": " + sentence(error);
    m_console.note(
        "error: " + std::string(errorName(error.code)) + ": " + withoutPasswords(singleLine(said)));
    if (!m_told)
        m_told = error;
}

void Environment::warn(const std::string& sentence)
{
    m_console.note("warning: " + sentence);
}

} // namespace axiscomp::app
