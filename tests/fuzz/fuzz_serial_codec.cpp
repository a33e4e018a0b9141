// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/serial/serial_codec.h"
#include "tests/fuzz/expect.h"

using namespace axiscomp;
using namespace axiscomp::drivecomm;

namespace {

void checkLine(const std::string& text)
{
    const SerialLine line = parseSerialLine(text);
    FUZZ_EXPECT(line.number.value_or(1) != 0 || line.state != SerialLine::State::Good);
    if (line.state != SerialLine::State::Good)
        return;
    FUZZ_EXPECT(text.size() <= longestSerialLine && !line.words.empty());
    // Written again it says the same, in one line of ASCII.
    std::string words;
    for (const std::string& word : line.words)
        words += (words.empty() ? "" : " ") + serialWord(word);
    const std::string again = serialLine(line.number, words, true);
    for (const char c : again)
        FUZZ_EXPECT(c >= ' ' && c < '\x7F');
    if (again.size() <= longestSerialLine) {
        const SerialLine twice = parseSerialLine(again);
        FUZZ_EXPECT(twice.state == SerialLine::State::Good && twice.hasCrc);
        FUZZ_EXPECT(twice.words == line.words && twice.number == line.number);
    }
}

void checkReplies(const std::vector<std::string>& words)
{
    if (const auto error = parseSerialError(words))
        FUZZ_EXPECT(!sentence(*error).empty());
    if (const auto identity = parseSerialIdentity(words))
        FUZZ_EXPECT(identity->axes >= 0 && identity->axes <= 1024);
    if (const auto reading = parseSerialReading(words))
        FUZZ_EXPECT(reading->type == words[0]);
    if (const auto reading = parseSerialTreeLine(words))
        FUZZ_EXPECT(reading->type == words[2]);
    if (const auto file = parseSerialFile(words))
        FUZZ_EXPECT(!file->path.empty());
}

} // namespace

/// What comes over a serial line, cut into lines, as requests and as replies.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    SerialLineAssembler assembler;
    for (std::size_t i = 0; i < size; ++i) {
        const auto line = assembler.feed(static_cast<char>(data[i]));
        if (!line)
            continue;
        FUZZ_EXPECT(!line->empty() && line->size() <= longestSerialLine + 1);
        checkLine(*line);
        checkReplies(parseSerialLine(*line).words);
    }
    return 0;
}
