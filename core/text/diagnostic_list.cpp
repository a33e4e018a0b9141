// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/diagnostic_list.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace axiscomp {

void DiagnosticList::error(DiagnosticCode code, std::size_t line, std::size_t column,
    std::string found, std::string expected)
{
    error({.severity = Severity::Error,
        .code = code,
        .line = line,
        .column = column,
        .found = std::move(found),
        .expected = std::move(expected),
        .controllerError = {}});
}

void DiagnosticList::error(Diagnostic diagnostic)
{
    m_hasErrors = true;
    if (isFull())
        ++m_suppressed;
    else
        m_items.push_back(std::move(diagnostic));
}

void DiagnosticList::warning(DiagnosticCode code, std::size_t line, std::size_t column,
    std::string found, std::string expected)
{
    if (m_warnings.size() < m_maximum)
        m_warnings.push_back({.severity = Severity::Warning,
            .code = code,
            .line = line,
            .column = column,
            .found = std::move(found),
            .expected = std::move(expected),
            .controllerError = {}});
}

void DiagnosticList::countErrors(std::size_t count)
{
    m_hasErrors = m_hasErrors || count > 0;
    m_suppressed += count;
}

std::vector<Diagnostic> DiagnosticList::take()
{
    // Errors come first when there is no room for all: they are what stops the file.
    const std::size_t room = m_maximum - std::min(m_maximum, m_items.size());
    const std::size_t kept = std::min(room, m_warnings.size());
    std::move(m_warnings.begin(), m_warnings.begin() + static_cast<std::ptrdiff_t>(kept),
        std::back_inserter(m_items));
    const auto place = [](const Diagnostic& item) {
        return item.line == 0 ? std::numeric_limits<std::size_t>::max() : item.line;
    };
    std::ranges::stable_sort(m_items, {}, place);
    return std::move(m_items);
}

} // namespace axiscomp
