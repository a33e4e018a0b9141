// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/web/relayed_connection.h"

#include <sys/socket.h>

#include <cerrno>

namespace axiscomp::drivecomm {

namespace {

constexpr std::size_t bufferSize = 64 * 1024;

} // namespace

/// A socket of which nothing is wanted is left out: its hang-up would wake poll again and again.
pollfd watch(const Socket& socket, const RelayLane& readFrom, const RelayLane& writtenTo)
{
    const int events = (readFrom.wantsToRead() ? POLLIN : 0) | (writtenTo.isEmpty() ? 0 : POLLOUT);
    return {events == 0 ? -1 : socket.get(), static_cast<short>(events), 0};
}

bool readInto(RelayLane& lane, const Socket& source)
{
    lane.bytes.resize(bufferSize);
    lane.begin = 0;
    const ssize_t count = ::recv(source.get(), lane.bytes.data(), lane.bytes.size(), 0);
    const int error = errno;
    lane.bytes.resize(count > 0 && !lane.discards ? static_cast<std::size_t>(count) : 0);
    if (count == 0)
        lane.sourceEnded = true;
    return count >= 0 || error == EAGAIN || error == EINTR;
}

} // namespace axiscomp::drivecomm
