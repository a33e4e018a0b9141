// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/bytes.h"

#include <QIODevice>

#include <cstdint>
#include <functional>
#include <vector>

namespace axiscomp::drivecomm {

/// The body of one request, read once from pieces in memory. It is sequential on purpose: a device
/// that can be rewound would let Qt send a PUT or POST again, by itself, when the connection closes
/// before the reply, although the drive may have carried it out.
class HttpBody final : public QIODevice {
public:
    /// onRead is told how many bytes of pieces[watchedPiece] are on their way.
    HttpBody(std::vector<ByteView> pieces, std::size_t watchedPiece,
        std::function<void(std::uint64_t)> onRead);

    [[nodiscard]] bool isSequential() const override { return true; }
    bool reset() override { return false; }
    bool seek(qint64) override { return false; }
    [[nodiscard]] qint64 bytesAvailable() const override;
    [[nodiscard]] bool wasRead() const { return m_read > 0; }
    /// Forgets the pieces: what is read from now on is the end.
    void letGo();
    [[nodiscard]] qint64 total() const { return m_total; }

protected:
    qint64 readData(char* data, qint64 maximumSize) override;
    qint64 writeData(const char*, qint64) override { return -1; }

private:
    std::vector<ByteView> m_pieces;
    std::size_t m_watchedPiece;
    std::function<void(std::uint64_t)> m_onRead;
    std::size_t m_piece = 0;
    std::size_t m_offset = 0;
    qint64 m_read = 0;
    qint64 m_total = 0;
};

} // namespace axiscomp::drivecomm
