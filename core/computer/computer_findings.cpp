// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/computer/computer_findings.h"

#include <cstdlib>

namespace axiscomp {

namespace {

/// Less room than that lets a write fail, or soon will.
constexpr std::uint64_t leastRoom = 10'000'000;
constexpr std::uint64_t littleRoom = 100'000'000;
/// A clock that has lost the time is years behind; packages may be dated some weeks ahead.
constexpr std::chrono::days wrongClock{365};

Finding clockFinding(const ClockFacts& clock)
{
    const Text name = AXISCOMP_TEXT("Doctor", "clock");
    if (!clock.program || clock.now >= *clock.program - wrongClock)
        return {name, Grade::Ok, secondText(clock.now)};
    return {name, Grade::Problem,
        AXISCOMP_TEXT("Doctor", "{now} is before the program was made, {made}")
            .with("now", secondText(clock.now))
            .with("made", secondText(*clock.program)),
        AXISCOMP_TEXT("Doctor",
            "set the clock (timedatectl says what it follows): flash operations are counted by "
            "it")};
}

Finding displayFinding(const DisplayFacts& display)
{
    const Text name = AXISCOMP_TEXT("Doctor", "display");
    const auto isSet = [&](const char* variable, const std::string& value) {
        return Text(Verbatim{std::string(variable) + "=" + value});
    };
    if (!display.platform.empty())
        return {name, Grade::Note, isSet("QT_QPA_PLATFORM", display.platform),
            AXISCOMP_TEXT("Doctor", "unset it if the window does not appear")};
    if (!display.waylandDisplay.empty())
        return {name, Grade::Ok, isSet("WAYLAND_DISPLAY", display.waylandDisplay)};
    if (!display.display.empty())
        return {name, Grade::Ok, isSet("DISPLAY", display.display)};
    return {name, Grade::Note, AXISCOMP_TEXT("Doctor", "none; the window needs one"),
        AXISCOMP_TEXT("Doctor",
            "start the window on the desktop, or over ssh -X; the command line does without")};
}

Finding temporaryFinding(const FolderFacts& folder)
{
    const Text name = AXISCOMP_TEXT("Doctor", "temporary folder");
    if (folder.kind == FolderFacts::Kind::Missing) // nobody will make it
        return {name, Grade::Problem,
            AXISCOMP_TEXT("Doctor", "{folder} is not there").with("folder", folder.path.string()),
            AXISCOMP_TEXT("Doctor", "make it, or set {variable} to another folder")
                .with("variable", Verbatim{"TMPDIR"})};
    if (auto obstacle = folderObstacle(name, folder, "TMPDIR"))
        return *std::move(obstacle);
    return {name, Grade::Ok,
        AXISCOMP_TEXT("Doctor", "{folder}, {free} free")
            .with("folder", folder.path.string())
            .with("free", byteQuantity(folder.fileSystem ? folder.fileSystem->freeBytes : 0))};
}

/// The window does without, so nothing of it is a problem.
Finding runtimeFinding(const std::optional<FolderFacts>& folder)
{
    const Text name = AXISCOMP_TEXT("Doctor", "runtime folder");
    const Text wayOut = AXISCOMP_TEXT("Doctor",
        "log in at the desktop or over ssh, and not by su or sudo, if the window does not appear");
    if (!folder)
        return {name, Grade::Note, AXISCOMP_TEXT("Doctor", "XDG_RUNTIME_DIR is not set"), wayOut};
    const Text path = Verbatim{folder->path.string()};
    if (folder->kind != FolderFacts::Kind::Folder)
        return {name, Grade::Note,
            AXISCOMP_TEXT("Doctor", "{folder} is not there").with("folder", path), wayOut};
    if (!folder->isOwn)
        return {name, Grade::Note,
            AXISCOMP_TEXT("Doctor", "{folder} belongs to {owner}")
                .with("folder", path)
                .with("owner", folder->owner),
            wayOut};
    return {name, Grade::Ok, path};
}

Finding proxyFinding(const std::vector<std::string>& proxies)
{
    const Text name = AXISCOMP_TEXT("Doctor", "proxies");
    if (proxies.empty())
        return {name, Grade::Ok, AXISCOMP_TEXT("Doctor", "none")};
    return {name, Grade::Note,
        AXISCOMP_TEXT("Doctor", "{variables}: drives are reached without a proxy all the same")
            .with("variables", proxies)};
}

Text variablesOf(const LocaleFacts& locale)
{
    std::string text;
    for (const auto& [name, value] : locale.variables) {
        text += text.empty() ? "" : " ";
        text += name + "=" + value;
    }
    return text.empty() ? Text(AXISCOMP_TEXT("Doctor", "no variable is set")) : Verbatim{text};
}

Finding localeFinding(const LocaleFacts& locale)
{
    const Text name = AXISCOMP_TEXT("Doctor", "locale");
    const Text variables = variablesOf(locale);
    if (!locale.isInstalled)
        return {name, Grade::Note,
            AXISCOMP_TEXT("Doctor", "{variables}: this locale is not installed")
                .with("variables", variables),
            AXISCOMP_TEXT("Doctor",
                "sudo apt install locales and sudo dpkg-reconfigure locales, or export "
                "LC_ALL=C.UTF-8")};
    if (!locale.isUtf8())
        return {name, Grade::Note,
            AXISCOMP_TEXT("Doctor",
                "{variables}: its encoding {encoding} is not UTF-8, so that letters outside of "
                "ASCII may look wrong")
                .with("variables", variables)
                .with("encoding", locale.encoding),
            AXISCOMP_TEXT("Doctor",
                "export LC_ALL=C.UTF-8, or the locale of your language with "
                "UTF-8")};
    return {name, Grade::Ok,
        AXISCOMP_TEXT("Doctor", "{variables}: {encoding}")
            .with("variables", variables)
            .with("encoding", locale.encoding)};
}

} // namespace

ComputerFacts computerFacts()
{
    ComputerFacts facts{
        systemFacts(), clockFacts(), displayFacts(), localeFacts(), folderFacts(temporaryFolder())};
    const char* const runtime = std::getenv("XDG_RUNTIME_DIR");
    if (runtime != nullptr && *runtime != '\0')
        facts.runtime = folderFacts(runtime);
    facts.proxies = proxyVariables();
    return facts;
}

std::optional<Finding> folderObstacle(
    const Text& name, const FolderFacts& facts, const std::string& variable)
{
    const Text folder = Verbatim{facts.path.string()};
    const Text nearest = Verbatim{facts.nearest.string()};
    const auto problem = [&](Text found) {
        return Finding{name, Grade::Problem, std::move(found),
            AXISCOMP_TEXT("Doctor", "set {variable} to a folder of your own")
                .with("variable", variable)};
    };
    if (facts.kind == FolderFacts::Kind::Blocked)
        return problem(AXISCOMP_TEXT("Doctor", "{folder} cannot be used: {nearest} is no folder")
                           .with("folder", folder)
                           .with("nearest", nearest));
    if (facts.kind == FolderFacts::Kind::Hidden)
        return problem(AXISCOMP_TEXT(
            "Doctor", "{folder} cannot be used: you have no permission to look into {nearest}")
                           .with("folder", folder)
                           .with("nearest", nearest));
    const auto& system = facts.fileSystem;
    if (system && system->isReadOnly)
        return problem(AXISCOMP_TEXT("Doctor", "{folder} is on a file system that is read-only")
                           .with("folder", folder));
    if (!facts.mayUse)
        return problem(AXISCOMP_TEXT("Doctor",
            "{folder} cannot be used: {nearest} belongs to {owner}, and you have no permission to "
            "change it")
                           .with("folder", folder)
                           .with("nearest", nearest)
                           .with("owner", facts.owner));
    if (!system || (system->takesFiles && system->freeBytes >= littleRoom))
        return std::nullopt;
    const bool isFull = !system->takesFiles || system->freeBytes < leastRoom;
    return Finding{name, isFull ? Grade::Problem : Grade::Note,
        (system->takesFiles ? AXISCOMP_TEXT("Doctor", "{folder} has only {free} free")
                            : AXISCOMP_TEXT("Doctor",
                                "{folder} is on a file system that takes no more files, with "
                                "{free} free"))
            .with("folder", folder)
            .with("free", byteQuantity(system->freeBytes)),
        AXISCOMP_TEXT("Doctor", "make room there, or set {variable} to a folder of another disk")
            .with("variable", variable)};
}

FindingSection systemFindings(const ComputerFacts& facts)
{
    const SystemFacts& system = facts.system;
    const Text unknown = AXISCOMP_TEXT("Doctor", "not known");
    FindingSection section{AXISCOMP_TEXT("Doctor", "System"), {}};
    section.findings = {
        {AXISCOMP_TEXT("Doctor", "system"), Grade::Ok,
            system.distribution.empty() ? unknown : Text(Verbatim{system.distribution})},
        {AXISCOMP_TEXT("Doctor", "kernel"), Grade::Ok,
            Verbatim{system.kernel + ", " + system.architecture}},
        {AXISCOMP_TEXT("Doctor", "processor cores"), Grade::Ok,
            Verbatim{std::to_string(system.cores)}},
        {AXISCOMP_TEXT("Doctor", "memory"), Grade::Ok,
            system.memory == 0 ? unknown
                               : AXISCOMP_TEXT("Doctor", "{all}, {free} free")
                                     .with("all", byteQuantity(system.memory))
                                     .with("free", byteQuantity(system.freeMemory))},
        clockFinding(facts.clock),
        displayFinding(facts.display),
        temporaryFinding(facts.temporary),
        runtimeFinding(facts.runtime),
        proxyFinding(facts.proxies),
    };
    return section;
}

FindingSection languageFindings(const LocaleFacts& facts, const std::vector<std::string>& languages)
{
    FindingSection section{AXISCOMP_TEXT("Doctor", "Language"), {}};
    section.findings = {
        localeFinding(facts),
        {AXISCOMP_TEXT("Doctor", "decimal sign"), Grade::Ok,
            AXISCOMP_TEXT("Doctor", "\"{sign}\"; the command line writes and reads a point")
                .with("sign", facts.decimalSign)},
        {AXISCOMP_TEXT("Doctor", "translations"), Grade::Ok,
            Verbatim{Argument(languages).english()}},
    };
    return section;
}

} // namespace axiscomp
