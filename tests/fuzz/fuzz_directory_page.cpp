// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/web/directory_listing.h"
#include "drivecomm/web/html_table.h"
#include "tests/fuzz/expect.h"

#include <cstdint>
#include <set>

using namespace axiscomp;
using namespace axiscomp::drivecomm;

namespace {

void expectUsable(const std::vector<DriveFile>& files)
{
    std::set<std::string> paths;
    for (const DriveFile& file : files) {
        FUZZ_EXPECT(!file.path.empty() && file.size <= file.maximumSize);
        FUZZ_EXPECT(paths.insert(file.path).second);
        for (const char c : file.path)
            FUZZ_EXPECT(c > ' ' && c < '\x7f');
    }
    const auto again = parseDirectoryJson(directoryJson(files));
    FUZZ_EXPECT(again.has_value() && *again == files);
}

void expectProtocol(const Error& error)
{
    FUZZ_EXPECT(error.code == ErrorCode::Protocol);
    const std::string& quote = error.context.english("quote");
    FUZZ_EXPECT(!quote.empty() && quote.size() < 100 && !error.context.english("expected").empty());
    for (const char c : quote)
        FUZZ_EXPECT(c >= ' ' && c < '\x7f');
}

} // namespace

/// The directory as a page and as JSON, from a drive that may be none.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    for (const auto& files : {parseDirectoryPage(text), parseDirectoryJson(text)}) {
        if (files)
            expectUsable(*files);
        else
            expectProtocol(files.error());
    }
    std::size_t cells = 0;
    for (const HtmlTable& table : htmlTables(text))
        for (const HtmlRow& row : table)
            cells += row.size();
    FUZZ_EXPECT(cells * 3 <= size);
    FUZZ_EXPECT(htmlText(text).size() <= size * 3);
    return 0;
}
