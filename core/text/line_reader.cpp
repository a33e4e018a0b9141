// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/line_reader.h"

#include <algorithm>
#include <cstring>

namespace axiscomp {

namespace {

const char* find(const char* begin, const char* end, char c)
{
    const void* found =
        begin == end ? nullptr : std::memchr(begin, c, static_cast<std::size_t>(end - begin));
    return found == nullptr ? end : static_cast<const char*>(found);
}

} // namespace

LineReader::LineReader(std::string_view text)
    : m_position(text.data())
    , m_end(text.data() + text.size())
    , m_nextFeed(find(m_position, m_end, '\n'))
    , m_nextReturn(find(m_position, m_nextFeed, '\r'))
{
}

std::string_view LineReader::next()
{
    const char* begin = m_position;
    const char* end = m_nextReturn;
    const char* following = end;
    if (following != m_end)
        ++following;
    if (following == m_nextFeed && following != m_end)
        ++following;
    skipTo(following, 1);
    return {begin, static_cast<std::size_t>(end - begin)};
}

void LineReader::skipTo(const char* position, std::size_t lines)
{
    m_position = position;
    m_lineNumber += lines;
    // Searched for once each: a text without LF is not read to its end again and again, and one
    // without CR never further than the line.
    if (m_nextFeed < position)
        m_nextFeed = find(position, m_end, '\n');
    if (m_nextReturn < position)
        m_nextReturn = find(position, m_nextFeed, '\r');
}

std::vector<const char*> pieceEnds(std::string_view text, std::size_t bytes, std::size_t mostPieces)
{
    const char* const end = text.data() + text.size();
    std::vector<const char*> ends;
    for (const char* p = text.data(); p != end && ends.size() < mostPieces; ends.push_back(p)) {
        p += std::min(bytes - 1, static_cast<std::size_t>(end - p));
        while (p != end && *p != '\n' && *p != '\r')
            ++p;
        if (end - p > 1 && p[0] == '\r' && p[1] == '\n')
            ++p;
        p += p == end ? 0 : 1;
    }
    return ends;
}

} // namespace axiscomp
