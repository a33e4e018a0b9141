// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/http/http_reply_parser.h"
#include "tests/fuzz/expect.h"

#include <cstdint>

using namespace axiscomp::drivecomm;

namespace {

constexpr std::uint64_t limit = 1000;

HttpReplyParser parsed(std::string_view bytes, std::size_t piece)
{
    HttpReplyParser parser(limit);
    for (; !bytes.empty(); bytes.remove_prefix(std::min(piece, bytes.size()))) {
        parser.feed(bytes.substr(0, piece));
        FUZZ_EXPECT(parser.received() <= limit);
    }
    parser.end();
    return parser;
}

} // namespace

/// One reply, in one piece and in small ones: the same comes out. The first byte is the size of the
/// pieces.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0)
        return 0;
    const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    HttpReplyParser whole = parsed(bytes, bytes.size() + 1);
    HttpReplyParser pieces = parsed(bytes, std::size_t{1} + data[0]);
    FUZZ_EXPECT(whole.state() == pieces.state());
    FUZZ_EXPECT(whole.expected() == pieces.expected());
    FUZZ_EXPECT(whole.status() == pieces.status());
    if (whole.state() == HttpReplyParser::State::Failed)
        FUZZ_EXPECT(!whole.expected().isEmpty() && whole.found().size() <= 256);
    if (whole.state() != HttpReplyParser::State::Complete)
        return 0;
    FUZZ_EXPECT(whole.keepsConnection() == pieces.keepsConnection());
    const HttpReply a = whole.take();
    const HttpReply b = pieces.take();
    FUZZ_EXPECT(a.status >= 100 && a.status <= 999);
    FUZZ_EXPECT(a.status == b.status && a.body == b.body && a.hasEnd == b.hasEnd);
    FUZZ_EXPECT(a.contentType == b.contentType && a.location == b.location);
    return 0;
}
