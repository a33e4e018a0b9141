// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/serial/ymodem.h"
#include "tests/fuzz/expect.h"

#include <cstdint>

using namespace axiscomp;
using namespace axiscomp::drivecomm;

namespace {

constexpr std::uint64_t limit = 5000;

/// Feeds bytes in pieces with pauses between them, and then waits for the end, which must come.
template <typename Machine, typename Check>
void talk(Machine& machine, ByteView bytes, std::size_t piece, Check check)
{
    ymodem::Clock::time_point now{};
    while (!bytes.empty() && machine.isRunning()) {
        const ByteView part = bytes.first(std::min(piece, bytes.size()));
        FUZZ_EXPECT(machine.feed(part, now) <= part.size());
        check();
        // A byte 0xAA at the end of a piece stands for a pause.
        if (machine.isRunning() && part.back() == std::byte{0xAA}) {
            now = std::max(now, machine.wakeAt());
            machine.tick(now);
        }
        bytes = bytes.subspan(part.size());
        FUZZ_EXPECT(machine.output().size() < 100'000);
    }
    for (int n = 0; machine.isRunning(); ++n) {
        FUZZ_EXPECT(n < 1000);
        now = std::max(now, machine.wakeAt());
        machine.tick(now);
        check();
    }
    FUZZ_EXPECT((machine.state() == ymodem::State::Failed) == !machine.failure().empty());
}

} // namespace

/// What comes from the other side of a transfer. The first byte is the size of the pieces.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0)
        return 0;
    const ByteView bytes = std::as_bytes(std::span(data + 1, size - 1));
    const std::size_t piece = std::size_t{1} + data[0];
    ymodem::Receiver receiver(limit, std::nullopt, {});
    talk(receiver, bytes, piece, [&] { FUZZ_EXPECT(receiver.received() <= limit); });
    if (receiver.state() == ymodem::State::Done && receiver.header().size)
        FUZZ_EXPECT(receiver.received() == *receiver.header().size);
    const Bytes file(3000, std::byte{0x55});
    ymodem::Sender sender("name", file, {});
    talk(sender, bytes, piece, [&] { FUZZ_EXPECT(sender.acknowledged() <= file.size()); });
    if (sender.state() == ymodem::State::Done)
        FUZZ_EXPECT(sender.acknowledged() == file.size());
    static_cast<void>(ymodem::parseHeader(bytes));
    return 0;
}
