// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/computer/program_facts.h"

namespace axiscomp {

namespace {

/// Packages are files that somebody has, or stand in an archive: how they are installed follows.
Text installText(const char* package)
{
    return AXISCOMP_TEXT("Doctor", "install the package {package}")
        .with("package", Verbatim{package});
}

Finding libraryFinding(const LibraryVersion& library)
{
    if (library.version == library.builtWith)
        return {Verbatim{library.name}, Grade::Ok, Verbatim{library.version}};
    return {Verbatim{library.name}, Grade::Ok,
        AXISCOMP_TEXT("Doctor", "{version}, built with {other}")
            .with("version", library.version)
            .with("other", library.builtWith)};
}

Finding tlsFinding(const std::string& tls)
{
    if (!tls.empty())
        return {Verbatim{"https"}, Grade::Ok, Verbatim{tls}};
    return {Verbatim{"https"}, Grade::Note,
        AXISCOMP_TEXT("Doctor", "there is no TLS library: https drives cannot be reached"),
        AXISCOMP_TEXT("Doctor", "install OpenSSL (sudo apt install libssl3)")};
}

Finding windowFinding(const std::string& window)
{
    if (!window.empty())
        return {AXISCOMP_TEXT("Doctor", "window"), Grade::Ok, Verbatim{window}};
    return {AXISCOMP_TEXT("Doctor", "window"), Grade::Note,
        AXISCOMP_TEXT("Doctor", "not installed; the command line does without"),
        installText("axis-compensation-wizard")};
}

Finding pdfFinding(bool drawsPdf)
{
    if (drawsPdf)
        return {AXISCOMP_TEXT("Doctor", "reports"), Grade::Ok, Verbatim{"HTML, PDF"}};
    return {AXISCOMP_TEXT("Doctor", "reports"), Grade::Note,
        AXISCOMP_TEXT("Doctor", "what draws PDF is not installed"),
        AXISCOMP_TEXT(
            "Doctor", "install the package {package}, or write the report as HTML and print that")
            .with("package", Verbatim{"axiscomp-report-pdf"})};
}

} // namespace

FindingSection programFindings(const ProgramFacts& facts)
{
    FindingSection section{AXISCOMP_TEXT("Doctor", "Program"), {}};
    section.findings.push_back({AXISCOMP_TEXT("Doctor", "version"), Grade::Ok,
        Verbatim{facts.version + (facts.buildType.empty() ? "" : ", " + facts.buildType)}});
    section.findings.push_back(
        {AXISCOMP_TEXT("Doctor", "program"), Grade::Ok, Verbatim{facts.path}});
    for (const LibraryVersion& library : facts.libraries)
        section.findings.push_back(libraryFinding(library));
    section.findings.push_back(tlsFinding(facts.tls));
    section.findings.push_back(windowFinding(facts.window));
    section.findings.push_back(pdfFinding(facts.drawsPdf));
    return section;
}

} // namespace axiscomp
