// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/http_body.h"

#include <algorithm>
#include <cstring>

namespace axiscomp::drivecomm {

HttpBody::HttpBody(std::vector<ByteView> pieces, std::size_t watchedPiece,
    std::function<void(std::uint64_t)> onRead)
    : m_pieces(std::move(pieces))
    , m_watchedPiece(watchedPiece)
    , m_onRead(std::move(onRead))
{
    for (const ByteView& piece : m_pieces)
        m_total += static_cast<qint64>(piece.size());
    open(QIODevice::ReadOnly | QIODevice::Unbuffered);
}

void HttpBody::letGo()
{
    m_pieces.clear();
    m_piece = 0;
    m_onRead = nullptr;
}

qint64 HttpBody::bytesAvailable() const
{
    return m_total - m_read;
}

qint64 HttpBody::readData(char* data, qint64 maximumSize)
{
    qint64 copied = 0;
    while (copied < maximumSize && m_piece < m_pieces.size()) {
        const ByteView rest = m_pieces[m_piece].subspan(m_offset);
        const std::size_t count =
            std::min(rest.size(), static_cast<std::size_t>(maximumSize - copied));
        if (count > 0)
            std::memcpy(data + copied, rest.data(), count);
        copied += static_cast<qint64>(count);
        m_offset += count;
        if (m_piece == m_watchedPiece && m_onRead)
            m_onRead(m_offset);
        if (count == rest.size()) {
            ++m_piece;
            m_offset = 0;
        }
    }
    m_read += copied;
    return copied == 0 && maximumSize > 0 ? -1 : copied;
}

} // namespace axiscomp::drivecomm
