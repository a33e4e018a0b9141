// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output/output_file.h"

#include "app/common/arguments.h"
#include "app/common/standard_streams.h"
#include "core/io/local_file.h"

#include <filesystem>
#include <system_error>

namespace axiscomp::app {

bool Output::isStandardOutput() const
{
    return file.empty() || file == standardStream;
}

Result<void> checkOutput(Environment& environment, const Output& output, bool isText)
{
    if (!output.isStandardOutput())
        return {};
    if (environment.json())
        return wrongUsage(
            "standard output is taken by --json: name a file for the result", output.command);
    if (!isText && environment.console().outputIsTerminal())
        return wrongUsage(
            "this is not text for a terminal: name a file for the result", output.command);
    return {};
}

Result<void> checkNoInput(const Output& output, const std::vector<std::string>& inputs)
{
    if (output.isStandardOutput())
        return {};
    for (const std::string& input : inputs) {
        std::error_code ignored; // what is not there cannot be overwritten
        if (std::filesystem::equivalent(pathFromText(output.file), pathFromText(input), ignored))
            return wrongUsage(output.file
                    + " is the measurement itself and would be replaced: "
                      "name another file for the result",
                output.command);
    }
    return {};
}

Result<void> writeOutput(Environment& environment, const Output& output, ByteView bytes)
{
    if (!output.isStandardOutput())
        return saveFile(pathFromText(output.file), bytes);
    environment.console().print(asText(bytes));
    return {};
}

} // namespace axiscomp::app
