// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/program.h"
#include "app/cli/start/program_module.h"
#include "app/cli/start/quick_commands.h"
#include "app/common/guarded_program.h"
#include "app/common/system_process.h"
#include "core/io/system.h"

#include <dlfcn.h>

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <system_error>

namespace {

using namespace axiscomp;
using namespace axiscomp::app;

/// Where the build has it, and where it is installed.
int runModule(int argc, char** argv)
{
    const std::filesystem::path program = system::programFolder();
    const std::array files{
        program / programModuleName, program / AXISCOMP_MODULE_FOLDER / programModuleName};
    std::string reason;
    for (const std::filesystem::path& file : files) {
        if (void* const module = ::dlopen(file.c_str(), RTLD_NOW))
            if (void* const function = ::dlsym(module, programModuleFunction))
                return reinterpret_cast<ProgramModuleFunction>(function)(argc, argv);
        // What one that is there lacks says more than that another one is not there.
        const char* const said = ::dlerror();
        std::error_code none;
        if (said != nullptr && (reason.empty() || std::filesystem::exists(file, none)))
            reason = said;
    }
    return runGuarded([&reason](Console& console) {
        return static_cast<int>(noteError(console,
            {ErrorCode::FileNotReadable,
                {{"file", std::string(programModuleName)},
                    {"reason",
                        "axiscomp is not installed completely (" + reason + "); install it again"}},
                {}}));
    });
}

} // namespace

int main(int argc, char** argv)
{
    ProgramArguments arguments(argc, argv);
    const std::span values(arguments.values(), static_cast<std::size_t>(arguments.count()));
    return isQuick(values) ? runProgram(arguments.count(), arguments.values())
                           : runModule(arguments.count(), arguments.values());
}
