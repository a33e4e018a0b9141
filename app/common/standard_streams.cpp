// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/standard_streams.h"

#include "app/common/system_process.h"

namespace axiscomp::app {

bool standardInputIsTerminal()
{
    return isTerminal(Stream::Input);
}

Result<std::string> readStandardInput(Interrupt& interrupt, std::uint64_t maximumSize)
{
    InputStream input = InputStream::standardInput();
    std::string text;
    while (true) {
        AXISCOMP_TRY(const auto more, input.readMore(interrupt, text));
        if (!more)
            return text;
        if (text.size() > maximumSize)
            return fail(ErrorCode::FileTooLarge,
                {{"file", Verbatim{"standard input"}},
                    {"size", "more than " + std::to_string(maximumSize)},
                    {"limit", std::to_string(maximumSize)}});
    }
}

} // namespace axiscomp::app
