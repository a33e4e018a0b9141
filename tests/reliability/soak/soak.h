// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/reliability/soak/operation_choice.h"
#include "tests/reliability/soak/soak_counts.h"
#include "tests/reliability/soak/soak_model.h"
#include "tests/reliability/soak/soak_program.h"

#include <deque>

namespace axiscomp::test {

/// Several programs on one drive, acting at random, one after the other and together, with faults;
/// after every operation the drive and the programs' files are compared with what they may hold.
class Soak {
public:
    Soak(std::uint32_t seed, const std::vector<AttachmentKind>& attachments);

    /// Ends at the first thing that is wrong: what it is, at which operation, and the last 20
    /// operations. Empty: everything was right.
    [[nodiscard]] std::string run(int operations);
    [[nodiscard]] const SoakCounts& counts() const { return m_counts; }

private:
    [[nodiscard]] Moment look();
    [[nodiscard]] std::vector<std::string> single();
    [[nodiscard]] std::vector<std::string> group();
    [[nodiscard]] Ending perform(const Operation& operation);
    void note(const Operation& operation, const Ending& ending);

    std::uint32_t m_seed;
    SoakDrive m_drive;
    OperationChoice m_choice;
    SoakModel m_model;
    std::vector<std::unique_ptr<SoakProgram>> m_programs;
    Moment m_before;
    SoakCounts m_counts;
    int m_done = 0;
    std::deque<std::string> m_history;
};

} // namespace axiscomp::test
