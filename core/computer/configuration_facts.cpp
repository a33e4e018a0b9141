// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/computer/configuration_facts.h"

namespace axiscomp {

namespace {

Finding settingsFinding(const WindowSettings& window)
{
    const Text name = AXISCOMP_TEXT("Doctor", "window settings");
    const Text file = Verbatim{window.file};
    switch (window.state) {
    case WindowSettings::State::Missing:
        return {name, Grade::Ok, AXISCOMP_TEXT("Doctor", "none; the window was not used yet")};
    case WindowSettings::State::Readable:
        break;
    case WindowSettings::State::Unreadable:
        return {name, Grade::Problem,
            AXISCOMP_TEXT("Doctor", "{file} is not a file that you may read").with("file", file),
            AXISCOMP_TEXT("Doctor", "move it away; the window begins a new one")};
    case WindowSettings::State::Malformed:
        return {name, Grade::Problem,
            AXISCOMP_TEXT("Doctor", "{file} is damaged").with("file", file),
            AXISCOMP_TEXT("Doctor", "move it away; the window begins a new one")};
    }
    return {name, Grade::Ok,
        AXISCOMP_TEXT("Doctor", "{file}, connections: {number}")
            .with("file", file)
            .with("number", window.drives.size())};
}

Finding profileFinding(const ConfigurationFacts& facts)
{
    const Text name = AXISCOMP_TEXT("Doctor", "drive profile");
    if (facts.profileError)
        return {name, Grade::Problem, textOf(*facts.profileError)};
    return {name, Grade::Ok,
        facts.profileFile.empty()
            ? AXISCOMP_TEXT("Doctor", "{profile}, built in").with("profile", facts.profile)
            : Text(Verbatim{facts.profile + ", " + facts.profileFile})};
}

Finding certificateFinding(const std::vector<std::string>& certificates)
{
    const Text name = AXISCOMP_TEXT("Doctor", "trusted certificates");
    if (certificates.empty())
        return {name, Grade::Ok, AXISCOMP_TEXT("Doctor", "none")};
    return {name, Grade::Ok, Verbatim{Argument(certificates).english()}};
}

} // namespace

FindingSection configurationFindings(const ConfigurationFacts& facts)
{
    return {AXISCOMP_TEXT("Doctor", "Configuration"),
        {settingsFinding(facts.window), profileFinding(facts),
            certificateFinding(facts.certificates)}};
}

} // namespace axiscomp
