// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/guarded_program.h"

#include <exception>

namespace axiscomp::app {

ExitCode noteError(Console& console, const Error& error)
{
    console.note("error: " + std::string(errorName(error.code)) + ": " + sentence(error));
    return exitCode(error.code);
}

int runGuarded(const std::function<int(Console& console)>& body)
{
    Console console;
    try {
        return body(console);
    } catch (const std::exception& exception) {
        console.note("error: Internal: " + std::string(exception.what()));
        return static_cast<int>(ExitCode::OtherFailure);
    }
}

} // namespace axiscomp::app
