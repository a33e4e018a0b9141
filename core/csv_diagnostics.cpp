// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv_diagnostics.h"

#include <algorithm>
#include <limits>

namespace axiscomp::csv {

void DiagnosticList::error(DiagnosticCode code, std::size_t line, std::size_t column,
    std::string found, std::string expected)
{
    m_hasErrors = true;
    if (isFull())
        ++m_suppressed;
    else
        m_items.push_back(
            {Severity::Error, code, line, column, std::move(found), std::move(expected)});
}

void DiagnosticList::warning(DiagnosticCode code, std::size_t line, std::size_t column,
    std::string found, std::string expected)
{
    if (m_warnings.size() < m_maximum)
        m_warnings.push_back(
            {Severity::Warning, code, line, column, std::move(found), std::move(expected)});
}

void DiagnosticList::countErrors(std::size_t count)
{
    m_hasErrors = m_hasErrors || count > 0;
    m_suppressed += count;
}

void DiagnosticList::moveInto(CsvReading& reading)
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
    reading.diagnostics = std::move(m_items);
    reading.suppressed = m_suppressed;
}

} // namespace axiscomp::csv
