// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/output/json.h"
#include "core/computer/computer_findings.h"
#include "core/computer/configuration_facts.h"
#include "core/computer/drive_answer.h"
#include "core/computer/program_facts.h"
#include "core/computer/serial_findings.h"
#include "core/computer/store_findings.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp::app {

/// All that `axiscomp doctor` looks at.
struct DoctorFacts {
    ProgramFacts program;
    ComputerFacts computer;
    std::vector<std::string> languages;
    FolderFacts stateFolder;
    std::optional<StoreCondition> store; ///< none: there was no folder for its copy
    ConfigurationFacts configuration;
    std::vector<SerialPortFacts> ports;
    std::vector<DriveAnswer> drives;
};

[[nodiscard]] std::vector<FindingSection> doctorFindings(const DoctorFacts& facts);
[[nodiscard]] std::size_t countOf(const std::vector<FindingSection>& sections, Grade grade);

/// One line for each finding, and how many problems there are.
[[nodiscard]] std::string doctorText(
    const DoctorFacts& facts, const std::vector<FindingSection>& sections);
/// The same as data (docs/cli.md, "Documents of --json").
[[nodiscard]] Json doctorJson(
    const DoctorFacts& facts, const std::vector<FindingSection>& sections);

/// A text that may be shown to others: one line, without passwords, the home folder as "~".
[[nodiscard]] std::string withoutSecrets(std::string_view text, std::string_view homeFolder);

} // namespace axiscomp::app
