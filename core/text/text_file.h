// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/text/diagnostic.h"

#include <cstddef>
#include <stop_token>
#include <string>
#include <string_view>

namespace axiscomp {

enum class Encoding { Utf8, Windows1252 };

/// Looks at the bytes of a whole file before anything is read from it. Adds NotText when they are
/// no text, and the warning Encoding when they are not UTF-8.
class TextInspection {
public:
    /// threads: as shareWork has them.
    TextInspection(std::string_view text, const std::stop_token& stop, DiagnosticList& diagnostics,
        std::size_t threads = 1);

    /// Without the byte-order mark.
    [[nodiscard]] std::string_view body() const { return m_body; }
    [[nodiscard]] Encoding encoding() const { return m_encoding; }

private:
    bool refuse(const TextPattern& what, std::size_t line = 0);
    bool refuseForeignFormat(std::string_view text);
    bool refuseNul(const std::stop_token& stop, std::size_t threads);
    void decideEncoding();

    DiagnosticList& m_diagnostics;
    std::string_view m_body;
    bool m_ascii = true;
    Encoding m_encoding = Encoding::Utf8;
};

/// With a byte-order mark or without one. text: the beginning is enough.
[[nodiscard]] bool isUtf16(std::string_view text);

/// Text of the file as it may be shown: UTF-8 without control characters.
[[nodiscard]] std::string toUtf8(std::string_view bytes, Encoding encoding);

/// What a diagnostic quotes of the file: UTF-8, one line, at most about 40 characters.
[[nodiscard]] std::string excerpt(std::string_view bytes, Encoding encoding);

/// Blanks are space and tab.
[[nodiscard]] std::string_view trimmed(std::string_view text);

} // namespace axiscomp
