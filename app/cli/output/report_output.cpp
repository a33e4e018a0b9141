// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output/report_output.h"

#include "app/common/report_module.h"
#include "app/texts/program_texts.h"
#include "core/io/system.h"

#include <QCoreApplication>
#include <QLibrary>

#include <algorithm>
#include <filesystem>

namespace axiscomp::app {

namespace {

/// Where the build has the module, and where it is installed.
std::vector<std::filesystem::path> moduleFolders()
{
    const std::filesystem::path program = system::programFolder();
    return {program, program / AXISCOMP_MODULE_FOLDER};
}

} // namespace

ReportDocument inLanguage(ReportDocument document, const std::string& language)
{
    const ProgramTexts texts(language);
    return worded(std::move(document), texts.wording(), language);
}

bool drawsPdf()
{
    return std::ranges::any_of(moduleFolders(), [](const std::filesystem::path& folder) {
        std::error_code error;
        return std::filesystem::exists(folder / (std::string(reportModuleName) + ".so"), error);
    });
}

Result<Bytes> drawnAsPdf(const ReportDocument& document)
{
    // The module makes the application object, of which a process has one: inside of another
    // program there is one already, and others work with it.
    if (QCoreApplication::instance() != nullptr)
        return fail(ErrorCode::FileNotReadable,
            {{"file", std::string(reportModuleName) + ".so"},
                {"reason",
                    std::string("only the program axiscomp draws PDF; write the report as HTML "
                                "and print that")}});
    QLibrary module;
    QFunctionPointer function = nullptr;
    for (const std::filesystem::path& folder : moduleFolders()) {
        module.setFileName(QString::fromStdString((folder / reportModuleName).string()));
        function = module.resolve(reportModuleFunction);
        if (function != nullptr)
            break;
    }
    if (function == nullptr)
        return fail(ErrorCode::FileNotReadable,
            {{"file", std::string(reportModuleName) + ".so"},
                {"reason",
                    std::string("what draws PDF is not installed; install the package "
                                "axiscomp-report-pdf, or write the report as HTML and print "
                                "that")}},
            module.errorString().toStdString());
    Result<Bytes> pdf;
    reinterpret_cast<ReportModuleFunction>(function)(document, pdf);
    return pdf;
}

} // namespace axiscomp::app
