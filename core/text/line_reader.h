// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace axiscomp {

/// The lines of a text, ended by LF, CRLF or CR.
class LineReader {
public:
    explicit LineReader(std::string_view text);

    [[nodiscard]] bool atEnd() const { return m_position == m_end; }
    [[nodiscard]] const char* position() const { return m_position; }
    [[nodiscard]] const char* end() const { return m_end; }
    /// The number of the line that begins at position(), from 1.
    [[nodiscard]] std::size_t lineNumber() const { return m_lineNumber; }

    /// The line at position() without its end. Not at the end.
    [[nodiscard]] std::string_view next();
    /// After `lines` lines were read by other means, up to the beginning of another line.
    void skipTo(const char* position, std::size_t lines);

private:
    const char* m_position;
    const char* m_end;
    const char* m_nextFeed; ///< the first LF at or after the position, or the end
    const char* m_nextReturn; ///< the first CR before that LF, or the same
    std::size_t m_lineNumber = 1;
};

/// Where the first pieces of a text end, at most so many: each behind the line in which it gets
/// this long. bytes: at least 1.
[[nodiscard]] std::vector<const char*> pieceEnds(
    std::string_view text, std::size_t bytes, std::size_t mostPieces);

} // namespace axiscomp
