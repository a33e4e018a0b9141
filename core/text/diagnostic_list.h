// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/text/diagnostic.h"

#include <string>
#include <vector>

namespace axiscomp {

/// Collects the problems of one file, up to a maximum; further errors are counted.
class DiagnosticList {
public:
    explicit DiagnosticList(std::size_t maximum) : m_maximum(maximum) { }

    void error(DiagnosticCode code, std::size_t line, std::size_t column, std::string found,
        std::string expected);
    void warning(DiagnosticCode code, std::size_t line, std::size_t column, std::string found,
        std::string expected);
    /// With the number that the controller itself gives this error.
    void error(Diagnostic diagnostic);
    /// Counts errors that are not worth a diagnostic each.
    void countErrors(std::size_t count);

    /// True when a further error would only be counted.
    [[nodiscard]] bool isFull() const { return m_items.size() >= m_maximum; }
    [[nodiscard]] bool hasErrors() const { return m_hasErrors; }
    [[nodiscard]] std::size_t suppressed() const { return m_suppressed; }

    /// In the order of the file, what concerns the whole file last.
    [[nodiscard]] std::vector<Diagnostic> take();

private:
    std::size_t m_maximum;
    std::vector<Diagnostic> m_items;
    std::vector<Diagnostic> m_warnings;
    std::size_t m_suppressed = 0;
    bool m_hasErrors = false;
};

} // namespace axiscomp
