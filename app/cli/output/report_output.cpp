// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output/report_output.h"

#include "app/common/report_module.h"

#include <QCoreApplication>
#include <QDir>
#include <QLibrary>
#include <QLocale>
#include <QTranslator>

#include <filesystem>

/// Q_INIT_RESOURCE declares a function, which must not be in a namespace.
static void useTranslations()
{
    Q_INIT_RESOURCE(axiscomp_texts);
}

namespace axiscomp::app {

namespace {

const QLatin1StringView folderOfTexts(":/axiscomp-texts");

/// Where the build has the module, and where it is installed.
std::vector<std::filesystem::path> moduleFolders()
{
    std::error_code error;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
    return {program, program / AXISCOMP_MODULE_FOLDER};
}

} // namespace

std::vector<std::string> reportLanguages()
{
    useTranslations();
    std::vector<std::string> languages{"en"};
    const QStringList files = QDir(folderOfTexts).entryList(QDir::Files, QDir::Name);
    for (const QString& file : files)
        languages.push_back(file.section(u'_', 1).section(u'.', 0, 0).toStdString());
    return languages;
}

ReportDocument inLanguage(ReportDocument document, const std::string& language)
{
    useTranslations();
    const QString name = QString::fromStdString(language);
    QTranslator translator;
    const bool isTranslated =
        translator.load(QStringLiteral("axiscomp_") + name, QString(folderOfTexts));
    Wording wording;
    wording.decimalSign = isTranslated ? QLocale(name).decimalPoint().front().toLatin1() : '.';
    wording.words = [&translator, isTranslated](
                        const TextPattern& pattern, std::optional<std::int64_t> count) {
        const int form = count
            ? static_cast<int>(std::clamp<std::int64_t>(*count, 0, std::numeric_limits<int>::max()))
            : -1;
        const QString words = isTranslated
            ? translator.translate(pattern.context, pattern.words, pattern.one, form)
            : QString();
        if (!words.isEmpty())
            return words.toStdString();
        return std::string(pattern.one != nullptr && count == 1 ? pattern.one : pattern.words);
    };
    return worded(std::move(document), wording, language);
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
                    std::string("what draws PDF is not installed; write the report as HTML and "
                                "print that")}},
            module.errorString().toStdString());
    Result<Bytes> pdf;
    reinterpret_cast<ReportModuleFunction>(function)(document, pdf);
    return pdf;
}

} // namespace axiscomp::app
